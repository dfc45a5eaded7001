/// @file
/// The teller: with this a section declares, once, who it is, what the reader may change, what it says,
/// what Euler or the scan has wrong, and what is checked. The command line, the text, the JSON, the
/// figures' data, the tests and the page all follow from that. How a section is written stands in
/// `book/authoring.md`.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <doctest/doctest.h>

#include "edition/compare.hpp"

namespace edition
{

/// Degrees as they are written, radians as they are computed with; correctly rounded.
constexpr double operator""_deg(long double x)
{
  return static_cast<double>(x * std::numbers::pi_v<long double> / 180);
}
/// Whole degrees.
constexpr double operator""_deg(unsigned long long x)
{
  return operator""_deg(static_cast<long double>(x));
}
/// Radians, to say so.
constexpr double operator""_rad(long double x)
{
  return static_cast<double>(x);
}

/// A unit: what is written behind a number, and by what the program's number is multiplied to be in
/// that unit.
struct Unit
{
  const char* symbol = "";  ///< What is written.
  long double factor = 1;   ///< What is multiplied by.
};
/// The units that the sections use. `degrees` is told what is in radians, `percent` a ratio.
/// @{
inline constexpr Unit none{};
inline constexpr Unit seconds{"s"};
inline constexpr Unit metres{"m"};
inline constexpr Unit feet{"ft"};
inline constexpr Unit radians{"rad"};
inline constexpr Unit degrees{"°", 180 / std::numbers::pi_v<long double>};
inline constexpr Unit percent{"%", 100};
/// @}

/// The numbers that a parameter may be.
struct Range
{
  double lo;     ///< The least.
  double hi;     ///< The greatest.
  bool lo_open;  ///< Whether the least is itself left out.
  bool hi_open;  ///< Whether the greatest is.

  /// True for a number inside; false for NaN.
  bool contains(double x) const { return (lo_open ? lo < x : lo <= x) && (hi_open ? x < hi : x <= hi); }
};
inline constexpr double infinity = std::numeric_limits<double>::infinity();  ///< Out of every range.
/// Every finite number; those above zero; those and zero.
/// @{
inline constexpr Range any{-infinity, infinity, true, true};
inline constexpr Range positive{0, infinity, true, true};
inline constexpr Range nonnegative{0, infinity, false, true};
/// @}
/// lo ≤ x ≤ hi
constexpr Range closed(double lo, double hi)
{
  return {lo, hi, false, false};
}
/// lo < x < hi
constexpr Range open(double lo, double hi)
{
  return {lo, hi, true, true};
}
/// lo < x ≤ hi
constexpr Range above_to(double lo, double hi)
{
  return {lo, hi, true, false};
}
/// lo ≤ x < hi
constexpr Range from_below(double lo, double hi)
{
  return {lo, hi, false, true};
}

/// A quantity that Euler leaves free: an option of the program, a number in its code.
template <class Number>
class Parameter
{
public:
  /// The parameter that was declared as number `index`; made by real(), integer(), angle() and amplitude().
  explicit Parameter(std::size_t index) : index_(index) {}
  /// Its value in this run: the default or what the reader gave. Angles are in radians.
  operator Number() const;
  /// The same in fifty digits, before it was rounded to a double: 5° is π/36.
  Fifty fifty() const;

private:
  std::size_t index_;
};

/// Declares a real parameter, the option `--name`. The default must lie in the range.
Parameter<double> real(const char* name, double default_value, Unit unit, Range range, const char* meaning);
/// Declares a whole number from `lo` to `hi`.
Parameter<int> integer(const char* name, int default_value, int lo, int hi, const char* meaning);
/// Declares an angle: in radians here, in degrees on the command line, where `1.2rad` works too.
Parameter<double> angle(const char* name, double default_value, Range range, const char* meaning);

/// The amplitude of a swing in both its guises, ζ from the lowest point and η = 180° − ζ from the top.
struct AmplitudeParameter
{
  Parameter<double> zeta;  ///< From the lowest point.
  Parameter<double> eta;   ///< From the top.
};
/// Declares `--zeta` and `--eta`. Whichever the reader gives is carried as given and the other is
/// formed in degrees before it is rounded to radians; both together must agree. `range` is that of ζ,
/// within [0°, 180°].
AmplitudeParameter amplitude(double default_zeta, Range range = open(0, std::numbers::pi));
/// The same with the default given as η.
AmplitudeParameter amplitude_from_top(double default_eta, Range range = open(0, std::numbers::pi));

/// Refuses a combination of parameters that no scene has: one line on standard error names `parameter`,
/// its value and what is `allowed`; the program ends with exit status 2.
void require(bool possible, const char* parameter, const char* allowed);

/// Tells a value: a real number in `unit` (the number itself is in the program's unit), an integer, a
/// text, a fraction, or fifty digits. Its `name` is what the prose calls it by.
/// @{
void tell(const char* name, double value, Unit unit, const char* meaning);
inline void tell(const char* name, double value, const char* meaning)
{
  tell(name, value, none, meaning);
}
void tell(const char* name, int value, const char* meaning);
void tell(const char* name, long long value, const char* meaning);
void tell(const char* name, const std::string& value, const char* meaning);
inline void tell(const char* name, const char* value, const char* meaning)
{
  tell(name, std::string(value), meaning);
}
void tell(const char* name, const Fifty& value, const char* meaning);
void tell(const char* name, const Rational& value, const char* meaning);
/// @}

/// A cell of a table.
using Cell = std::variant<double, long long, std::string>;

/// A column: its name in the data, its heading, its unit, and how many significant digits are shown.
struct Column
{
  std::string name;     ///< In the data.
  std::string heading;  ///< On the page.
  Unit unit = none;     ///< In which both show it.
  int digits = 6;       ///< Significant digits shown; the data have all.
};

/// A table under way; made by table().
class Table
{
public:
  /// An empty one.
  Table(std::string name, std::string caption, std::vector<Column> columns);
  /// Adds a row, one cell a column (in the program's unit); another number of cells throws
  /// std::logic_error.
  /// @{
  void row(std::initializer_list<Cell> cells) { row(std::vector<Cell>(cells)); }
  void row(std::vector<Cell> cells);
  /// @}

  std::string name;                     ///< What the prose and the data call it by.
  std::string caption;                  ///< What stands above it.
  std::vector<Column> columns;          ///< From left to right.
  std::vector<std::vector<Cell>> rows;  ///< In the columns' units.
};

/// Tells a table; the reference is good to the end of the TELL block.
Table& table(const char* name, const char* caption, std::vector<Column> columns);

/// The data of a figure under way; made by curve().
class Curve
{
public:
  /// Without any points yet; one name a column.
  explicit Curve(std::vector<std::string> columns) : columns_(std::move(columns)) {}
  /// Adds a point, one number a column, written with 17 digits; another number of them throws
  /// std::logic_error.
  /// @{
  void put(std::initializer_list<double> numbers) { put(std::vector<double>(numbers)); }
  void put(const std::vector<double>& numbers);
  /// @}
  /// Breaks the line here: what follows is drawn as a line of its own.
  void gap() { text_ += '\n'; }
  /// Begins a new block (gnuplot's `index`), for several lines in one file; it has its own header, as
  /// gnuplot expects.
  void block();

  /// The lines so far, tab separated, without the first header.
  const std::string& text() const { return text_; }

private:
  std::vector<std::string> columns_;
  std::string text_;
};

/// Declares data for a figure; `draw` is called, at once, only when data are asked for.
void curve(const char* name, std::vector<std::string> columns, const std::function<void(Curve&)>& draw);

/// One way to a number. Methods of one `family` (a series with more and more terms, say) are joined by
/// a line in the plot.
struct Method
{
  std::string name;                  ///< What it is called in the plot and the table.
  std::function<double()> evaluate;  ///< The number, computed anew at each call.
  std::string family = {};           ///< Empty for a method that stands alone.
};

/// Sets several ways to one number side by side: the error of each in ulps of the 50-digit value
/// `exact`, and with `--bench` its time. `exact` must be finite and not zero.
void race(const char* name, const char* quantity, const Fifty& exact, const std::vector<Method>& methods);

/// What stands in a text at some place, and the number that comes of it when it is taken at its word.
struct Reading
{
  /// The words, and the number, or what computes it when it is wanted.
  /// @{
  template <class Yield>
  requires std::is_arithmetic_v<Yield> Reading(const char* words, Yield value)
      : text(words), yields([value] { return static_cast<double>(value); })
  {
  }
  template <class Yield>
  requires std::is_invocable_r_v<double, Yield> Reading(const char* words, Yield compute)
      : text(words), yields(compute)
  {
  }
  /// @}

  std::string text;                ///< The words.
  std::function<double()> yields;  ///< The number.
};

/// Whose slip it is.
enum class Kind
{
  erratum,     ///< Euler's own, or his printer's.
  emendation,  ///< The scan's: the right reading is certain.
  doubtful,    ///< Wrong, but whether Euler, the printer or the scan is to blame cannot be told.
  undecided    ///< Which of two readings is meant cannot be told.
};

/// An entry of the apparatus: a place, what is printed there, what is right, and the proof, a function
/// of the number that a reading yields. The proof must fail with what is printed and hold with what is
/// right; for an undecided reading it must not tell the two apart. The programs' checks try every entry
/// both ways.
struct Entry
{
  Kind kind;                          ///< Whose slip it is.
  std::string where;                  ///< The place, section first.
  Reading printed;                    ///< What stands there; of two possible readings, the one.
  Reading right;                      ///< What should; of two possible readings, the other.
  std::string because;                ///< The proof in words.
  std::function<bool(double)> holds;  ///< The proof.
};

/// Puts an entry into the section's apparatus.
void enter(Entry entry);

/// An Entry of one kind, declared as an object of the section's file.
template <Kind kind_of_entry>
struct EntryOf
{
  /// Enters it.
  EntryOf(const char* where, Reading printed, Reading right, const char* because,
          std::function<bool(double)> holds)
  {
    enter({kind_of_entry, where, std::move(printed), std::move(right), because, std::move(holds)});
  }
};
/// The four kinds, as a section declares them.
/// @{
using Erratum = EntryOf<Kind::erratum>;
using Emendation = EntryOf<Kind::emendation>;
using Doubtful = EntryOf<Kind::doubtful>;
using Undecided = EntryOf<Kind::undecided>;
/// @}

/// Registers who the section is; made by SECTION.
struct Identity
{
  /// For the whole program: there is one such object in it.
  Identity(const char* chapter, int number, const char* title);
};

/// Registers what the section says; made by TELL.
struct Telling
{
  /// `body` is called when the program tells.
  explicit Telling(void (*body)());
};

}  // namespace edition

/// Names the section that this file is.
#define SECTION(chapter, number, title)                                                                    \
  static const edition::Identity edition_identity{#chapter, number, title};

/// Opens a block in which the section says something. A section may have several, one idea each; they
/// are told in their order.
#define TELL EDITION_TELL(__COUNTER__)
/// @cond
#define EDITION_TELL(count) EDITION_TELL_COUNTED(count)
#define EDITION_TELL_COUNTED(count) EDITION_TELL_NAMED(edition_tell_##count, edition_telling_##count)
#define EDITION_TELL_NAMED(body, registration)                                                             \
  static void body();                                                                                      \
  static const edition::Telling registration{&(body)};                                                     \
  static void body()
/// @endcond

/// Opens a check: a doctest case whose name is a statement.
#define CHECK_THAT(statement) TEST_CASE(statement)

using namespace edition;  // a section's file speaks the edition's language
