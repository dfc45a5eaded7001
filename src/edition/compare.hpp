/// @file
/// Comparisons that state how close, and why no closer: the only ones that the edition's checks use for
/// real numbers.
#pragma once

#include <string>

#include "edition/doctest.hpp"
#include "exact/fifty.hpp"
#include "exact/rational.hpp"

namespace edition
{

using exact::Fifty;
using exact::Rational;

/// What a real number is expected to be, how far it may be off, and the reason for that much.
/// Made by within_ulps(), within(), within_relative(), between(), printed() and infinite(); compared by `==`.
class Expectation
{
public:
  /// An interval, closed; `expected` and `tolerance` are how the reader is told of it.
  Expectation(const Fifty& lowest, const Fifty& highest, std::string expected, std::string tolerance,
              std::string because);

  /// Compiled once, not anew by every section that makes claims.
  /// @{
  Expectation(const Expectation&);
  Expectation(Expectation&&) noexcept;
  Expectation& operator=(const Expectation&) = delete;
  Expectation& operator=(Expectation&&) = delete;
  ~Expectation();
  /// @}

  /// True when `got` is a number and lies in the interval. Remembers the comparison for the ledger of
  /// claims, what was got with `digits` digits.
  bool holds(const Fifty& got, int digits) const;

  /// The expectation in words: number, tolerance, reason.
  std::string text() const;

  /// True of infinite() alone.
  bool is_infinite() const { return infinite_; }

private:
  friend Expectation infinite(const char* because);
  Fifty lowest_;
  Fifty highest_;
  std::string expected_;
  std::string tolerance_;
  std::string because_;
  bool infinite_ = false;
};

/// At most `n` units in the last place of the double nearest to `y`. An infinite `y` is met by itself alone;
/// a `y` that is no number by nothing. Precondition: n ≥ 0.
Expectation within_ulps(const Fifty& y, double n, const char* because);
/// At most `eps` away from `y`.
Expectation within(const Fifty& y, double eps, const char* because);
/// At most `eps`·|y| away from `y`.
Expectation within_relative(const Fifty& y, double eps, const char* because);
/// From `lo` to `hi`, both included.
Expectation between(const Fifty& lo, const Fifty& hi, const char* because);
/// Rounds to what is printed: at most half a unit of its last place away. `number` is a decimal with
/// comma or point, for instance "1,1803"; anything else throws std::invalid_argument.
Expectation printed(const char* number);
/// Above every number.
Expectation infinite(const char* because);

/// The comparison itself; what was got is shown with 17 digits, or with 30.
/// @{
inline bool operator==(double got, const Expectation& e)
{
  return e.holds(got, 17);
}
inline bool operator==(const Fifty& got, const Expectation& e)
{
  return e.holds(got, 30);
}
/// @}

/// For doctest's messages.
doctest::String toString(const Expectation& e);

/// A comparison as it was made: what the ledger of claims keeps of a check.
struct Claim
{
  std::string got;        ///< The number that was compared.
  std::string expected;   ///< What it was compared with; of a range, both ends.
  std::string tolerance;  ///< How far it might have been off.
  std::string because;    ///< Why so far.
  double used = -1;       ///< What part of the tolerance was needed; negative where there is none.
};

/// Remembers a comparison for the ledger; take_last_claim() hands it out.
void remember(Claim claim);

/// The comparison made last in this thread, handed out once; empty strings where none was made since.
Claim take_last_claim();

}  // namespace edition

/// @cond
// Fifty, Rational and words in doctest's messages; of words doctest itself says where they lie.
template <>
struct doctest::StringMaker<const char*>
{
  static doctest::String convert(const char* words) { return words ? words : "nullptr"; }
};
template <>
struct doctest::StringMaker<exact::Fifty>
{
  static doctest::String convert(const exact::Fifty& x) { return x.str(30).c_str(); }
};
template <>
struct doctest::StringMaker<exact::Rational>
{
  static doctest::String convert(const exact::Rational& x) { return x.str().c_str(); }
};
/// @endcond
