/// @file
/// What the reader may change: units, ranges, and the parameters that a section declares.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "edition/rule.hpp"
#include "exact/fifty.hpp"

namespace edition
{

using exact::Fifty;

/// @cond
namespace degrees_as_written
{

/// An unevaluated sum of two doubles.
struct Two
{
  double hi;
  double lo;
};

constexpr Two split(double x)
{
  const double c = 134217729.0 * x;
  const double hi = c - (c - x);
  return {hi, x - hi};
}

constexpr Two product(double x, double y)
{
  const double p = x * y;
  const Two a = split(x), b = split(y);
  return {p, ((a.hi * b.hi - p) + a.hi * b.lo + a.lo * b.hi) + a.lo * b.lo};
}

constexpr Two times(Two x, double y)
{
  const Two p = product(x.hi, y);
  const double lo = p.lo + x.lo * y;
  const double hi = p.hi + lo;
  return {hi, lo - (hi - p.hi)};
}

constexpr Two over(Two x, double y)
{
  const double q = x.hi / y;
  const Two back = product(q, y);
  const double rest = (((x.hi - back.hi) - back.lo) + x.lo) / y;
  const double hi = q + rest;
  return {hi, rest - (hi - q)};
}

/// The radians of a decimal number of degrees, from its digits: correctly rounded for up to 15 digits.
constexpr double radians_of(const char* text)
{
  double digits = 0;
  int power = 0;
  bool fraction = false;
  for(; *text != '\0' && *text != 'e' && *text != 'E'; ++text)
  {
    if(*text == '.')
      fraction = true;
    else if(*text != '\'')
    {
      digits = 10 * digits + (*text - '0');
      power -= fraction ? 1 : 0;
    }
  }
  if(*text != '\0')
  {
    ++text;
    const bool negative = *text == '-';
    int exponent = 0;
    for(text += (*text == '-' || *text == '+') ? 1 : 0; *text != '\0'; ++text)
      exponent = 10 * exponent + (*text - '0');
    power += negative ? -exponent : exponent;
  }
  Two x = over(times({3.141592653589793116, 1.2246467991473532e-16}, digits), 180);
  for(; power < 0; ++power)
    x = over(x, 10);
  for(; power > 0; --power)
    x = times(x, 10);
  return x.hi + x.lo;
}

}  // namespace degrees_as_written
/// @endcond

/// Degrees as they are written, radians as they are computed with.
constexpr double operator""_deg(const char* written)
{
  return degrees_as_written::radians_of(written);
}

/// A unit: what is written behind a number, and by what the program's number is multiplied to be in
/// that unit.
struct Unit
{
  const char* symbol = "";  ///< What is written.
  double factor = 1;        ///< What is multiplied by; for an angle, what a half turn has of them.
  bool of_angle = false;    ///< Whether the program's number is an angle in radians.

  /// Units are the same when they are written the same and scale the same.
  bool operator==(const Unit& other) const;
};
/// The units that the sections use. `degrees` is told what is in radians, `percent` a ratio.
/// @{
inline constexpr Unit none{};
inline constexpr Unit seconds{"s"};
inline constexpr Unit metres{"m"};
inline constexpr Unit feet{"ft"};
inline constexpr Unit kilograms{"kg"};
inline constexpr Unit radians{"rad"};
inline constexpr Unit degrees{"°", 180, true};
inline constexpr Unit arcminutes{"′", 10800, true};
inline constexpr Unit percent{"%", 100};
/// @}

/// The numbers that a parameter may be.
struct Range
{
  double lo;     ///< The least.
  double hi;     ///< The greatest.
  bool lo_open;  ///< Whether the least is itself left out.
  bool hi_open;  ///< Whether the greatest is.
};
inline constexpr double infinity = std::numeric_limits<double>::infinity();  ///< Out of every range.
/// What a positive quantity of any scale may be, 1e-100 to 1e100: far beyond every scene, and still so far
/// from the ends of the doubles that squares and quotients of two such numbers are right.
inline constexpr Range scale{1e-100, 1e100, false, false};
/// Every finite number; those above zero; those and zero. Where a formula squares or divides, `scale` is meant.
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

/// A place in a file, for the teller's complaints.
struct Source
{
  const char* file;  ///< As the compiler was given it.
  int line;          ///< From 1.
};
/// Where it is called; as a default argument, where the caller is called.
constexpr Source here(const char* file = __builtin_FILE(), int line = __builtin_LINE())
{
  return {file, line};
}

/// A default that keeps to what other parameters allow; made by at_most().
struct Default
{
  /// The same number always.
  Default(double always) : usual(always) {}
  /// See at_most().
  Default(double otherwise, const char* in_words, Rule<Fifty()> end)
      : usual(otherwise), most_in_words(in_words), most(std::move(end))
  {
  }
  double usual;                    ///< The default.
  const char* most_in_words = "";  ///< What it is at most; empty where nothing.
  Rule<Fifty()> most{};            ///< The same in the program's unit, at the other parameters' values.
};
/// The default `usual`, but `most()` where that is less: `at_most(40_deg, "phi0", [] { return phi0.fifty(); })`.
/// `most` may look at parameters that were declared before, whatever their ranges let them be; it must lie in
/// the range of the one that is declared.
Default at_most(double usual, const char* in_words, Rule<Fifty()> most);

/// A quantity that Euler leaves free: an option of the program, a number in its code.
template <class Number>
class Parameter
{
public:
  /// The parameter that was declared as number `index`; made by real(), integer(), angle() and amplitude().
  explicit Parameter(std::size_t index) : index_(index) {}
  /// Its value in this run: the default or what the reader gave. Angles are in radians.
  operator Number() const;
  /// The same as it was written, in fifty digits: 0.1 is a tenth, and 5° is π/36.
  Fifty fifty() const;

private:
  std::size_t index_;
};

/// Declares a real parameter, the option `--name`. The default must lie in the range.
Parameter<double> real(const char* name, const Default& default_value, Unit unit, Range range,
                       const char* meaning, Source source = here());
/// Declares a whole number from `lo` to `hi`.
Parameter<int> integer(const char* name, int default_value, int lo, int hi, const char* meaning,
                       Source source = here());
/// Declares an angle: in radians here, in degrees on the command line, where `1.2rad` works too.
Parameter<double> angle(const char* name, const Default& default_value, Range range, const char* meaning,
                        Source source = here());

/// The amplitude of a swing in both its guises, ζ from the lowest point and η = 180° − ζ from the top.
struct AmplitudeParameter
{
  Parameter<double> zeta;  ///< From the lowest point.
  Parameter<double> eta;   ///< From the top.
};
/// Declares `--zeta` and `--eta`. Whichever the reader gives is carried as it was written and the other formed
/// from it in fifty digits, before either is rounded; both together must agree. `range` is that of ζ, within
/// [0°, 180°].
AmplitudeParameter amplitude(double default_zeta, Range range = open(0, std::numbers::pi),
                             Source source = here());
/// The same with the default given as η.
AmplitudeParameter amplitude_from_top(double default_eta, Range range = open(0, std::numbers::pi),
                                      Source source = here());

/// Refuses a combination of parameters that no scene has: one line on standard error names `parameter`,
/// its value and what is `allowed`; the program ends with exit status 2. One limit each: the checks must see it
/// from both its sides.
void require(bool possible, const char* parameter, const char* allowed, Source source = here());

}  // namespace edition
