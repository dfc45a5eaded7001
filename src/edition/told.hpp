/// @file
/// What was told, as the checks see it: a claim about a told value, a table's column, a curve's points or a
/// race's ways, at the reader's parameters and at others. A check run ends in failure when something is told
/// that no claim has looked at.
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edition/compare.hpp"
#include "edition/doctest.hpp"
#include "edition/tell.hpp"

namespace edition
{

struct Said;

/// A number, or a text, that was told; to be compared, and in no other way to be had, so that whatever looks at
/// it is a claim.
class ToldNumber
{
public:
  /// What `key` was told to be; `exact` has more digits than a double or is the same number.
  ToldNumber(std::string key, const Fifty& exact, std::string text, int digits);
  /// Compiled once, not anew by every section that makes claims.
  /// @{
  ToldNumber(const ToldNumber&);
  ToldNumber(ToldNumber&&) noexcept;
  ToldNumber& operator=(const ToldNumber&) = delete;
  ToldNumber& operator=(ToldNumber&&) = delete;
  ~ToldNumber();
  /// @}

  /// The claim that it is what is expected. A told whole number or fraction counts as the real number it is.
  friend bool operator==(const ToldNumber& told, const Expectation& e) { return told.is(e); }
  /// The claim that it is this whole number.
  template <std::integral Integer>
  friend bool operator==(const ToldNumber& told, Integer n)
  {
    return told.is(Rational(n));
  }
  /// The claim that it is exactly this fraction.
  friend bool operator==(const ToldNumber& told, const Rational& q) { return told.is(q); }
  /// The claim that it is this text.
  /// @{
  friend bool operator==(const ToldNumber& told, const std::string& words) { return told.is_text(words); }
  friend bool operator==(const ToldNumber& told, const char* words) { return told.is_text(words); }
  /// @}

  /// As it was told.
  const std::string& text() const { return text_; }

private:
  bool is(const Expectation& e) const;
  bool is(const Rational& q) const;
  bool is_text(std::string_view words) const;

  std::string key_;
  Fifty exact_;
  std::string text_;
  int digits_;
};

/// For doctest's messages.
doctest::String toString(const ToldNumber& told);

/// A row of a told table, or a point of a curve. Names that were not told, and units other than the told
/// column's, throw std::logic_error. Numbers are in the program's unit (radians, ratios), those of a curve as
/// they were put.
class ToldRow
{
public:
  /// Row `index` of `name`.
  ToldRow(std::string name, const std::vector<Column>& columns, const std::vector<Cell>& cells);
  /// Compiled once, not anew by every section that makes claims.
  /// @{
  ToldRow(const ToldRow&);
  ToldRow(ToldRow&&) noexcept;
  ToldRow& operator=(const ToldRow&);
  ToldRow& operator=(ToldRow&&) noexcept;
  ~ToldRow();
  /// @}

  /// What the column has here, to be compared.
  ToldNumber value(const char* column, Unit unit = none) const;
  /// The same as a plain number: the argument at which the other columns are judged.
  double at(const char* column, Unit unit = none) const;
  /// A cell of words.
  const std::string& words(const char* column) const;

private:
  std::size_t index_of(const char* column) const;
  const Cell& cell(const char* column, Unit unit) const;

  std::string name_;
  std::vector<Column> columns_;
  std::vector<Cell> cells_;
};

/// What the section says at one setting of its parameters. Names that were not told throw std::logic_error, and
/// so does a unit that is not the told one.
class Told
{
public:
  /// What was said at `setting`.
  Told(std::string setting, Said& said);

  /// The setting, as told_at() was given it; empty for the reader's own parameters.
  const std::string& setting() const { return setting_; }
  /// A told value.
  ToldNumber value(const char* name, Unit unit = none) const;
  /// The rows of a table.
  std::vector<ToldRow> rows(const char* table) const;
  /// The points of a curve; with `n`, so many of them (at least two), evenly from the first to the last.
  std::vector<ToldRow> points(const char* curve, std::size_t n = 0) const;
  /// What one way of a race came to.
  ToldNumber method(const char* race, const std::string& name) const;
  /// What a race is judged by.
  ToldNumber exact(const char* race) const;
  /// The names of a race's ways, in their order.
  std::vector<std::string> methods(const char* race) const;

private:
  std::string setting_;
  Said* said_;
};

/// The settings of told_at(), one after the other: while the loop's body runs, the section's parameters have the
/// values of the setting, and afterwards those that they had.
class Settings
{
public:
  /// See told_at().
  explicit Settings(std::span<const std::string_view> settings);
  Settings(const Settings&) = delete;
  Settings& operator=(const Settings&) = delete;
  ~Settings();

  /// One setting of the loop.
  class Iterator
  {
  public:
    /// Setting number `at`.
    Iterator(Settings* of, std::size_t at) : of_(of), at_(at) {}
    /// Sets the parameters, has the section tell, and gives what it said.
    const Told& operator*() const { return of_->tell_at(at_); }
    /// The next.
    Iterator& operator++()
    {
      ++at_;
      return *this;
    }
    /// Whether two stand at the same setting.
    bool operator==(const Iterator& other) const { return at_ == other.at_; }

  private:
    Settings* of_;
    std::size_t at_;
  };

  /// From the first setting to past the last.
  /// @{
  Iterator begin() { return {this, 0}; }
  Iterator end();
  /// @}

private:
  const Told& tell_at(std::size_t i);

  std::vector<std::string> settings_;
  std::optional<Told> told_;
};

/// What the section says at each of some settings: `""` is the reader's own (the defaults, unless `--check` came
/// with parameters), `"zeta=150 b=2"` the defaults but for these, written as on the command line. A setting that
/// the section refuses throws.
template <std::convertible_to<std::string_view>... Text>
Settings told_at(const Text&... settings)
{
  const std::string_view each[] = {settings...};
  return Settings(each);
}

/// A claim that the section refuses a setting, or, after !, that it tells something there; true if it does.
class Refusal
{
public:
  /// Of what came of a setting; made by refused_at().
  Refusal(std::string setting, bool refused) : setting_(std::move(setting)), refused_(refused) {}
  /// The claim that it is not refused.
  Refusal operator!() const;
  /// Whether it is so; the comparison is remembered.
  explicit operator bool() const;
  /// What came of the setting.
  std::string words() const;

private:
  std::string setting_;
  bool refused_;
  bool claimed_ = true;
};
/// For doctest's messages.
doctest::String toString(const Refusal& refusal);

/// The claim that the section refuses this setting, as the command line would.
[[nodiscard]] Refusal refused_at(const std::string& setting);

}  // namespace edition
