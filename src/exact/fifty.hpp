#pragma once
/** @file
 * A real number of fifty decimal digits, the oracle against which doubles are judged.
 */
#include <compare>
#include <concepts>
#include <cstddef>
#include <string>

/// Exact fractions, fifty-digit reals, formal series: what the edition trusts when it judges a double.
namespace exact
{

/**
 * A real number with a significand of 168 bits (50 decimal digits) and a practically unbounded exponent.
 *
 * It is used like a `double`: the elementary functions are found by argument-dependent lookup, so that `using
 * std::sqrt; sqrt(x)` is one formula for both. Products, quotients and `sqrt` are correctly rounded; so are
 * sums and differences, but for rare differences of which Boost 1.74 takes a unit of the last place where
 * less than half of one is due (`findings/boost-difference`). The other functions are good to a few units of
 * the fiftieth digit. A division by zero gives an infinity and an undefined operation a NaN, as for doubles.
 *
 * Source: `cpp_bin_float_50` of Boost.Multiprecision, which stays out of this header.
 */
class Fifty
{
public:
  Fifty();          ///< Zero.
  Fifty(double x);  ///< Exactly the given double, not the decimal fraction it was written as.
  /// A whole number, exactly.
  /// @{
  template <std::signed_integral Integer>
  Fifty(Integer n) : Fifty(Exactly{}, static_cast<long long>(n))
  {
  }
  template <std::unsigned_integral Integer>
  Fifty(Integer n) : Fifty(Exactly{}, static_cast<unsigned long long>(n))
  {
  }
  /// @}
  Fifty(bool) = delete;
  Fifty(long double) = delete;

  /// The number that a decimal text such as `"3.16621"` or `"-1e-300"` denotes.
  /// @throws std::invalid_argument if the text is anything else
  /// @{
  explicit Fifty(const char* decimal);
  explicit Fifty(const std::string& decimal);
  /// @}

  /// A copy.
  /// @{
  Fifty(const Fifty& other);
  Fifty& operator=(const Fifty& other);
  /// @}
  ~Fifty() = default;

  /// The nearest double, ties to even, subnormals included.
  explicit operator double() const;

  /// The number in decimal, rounded to `digits` significant digits, without trailing zeros: plain (`0.00012`)
  /// from 1e-4 up to 10^digits, else with an exponent (`1.2e-05`). `"inf"`, `"-inf"`, `"nan"` for the rest. The same in
  /// every locale.
  /// @throws std::out_of_range unless 1 ≤ digits ≤ 50
  std::string str(int digits = 50) const;

  /// The four operations, rounded as said above, and the comparisons.
  /// @{
  Fifty& operator+=(const Fifty& y);
  Fifty& operator-=(const Fifty& y);
  Fifty& operator*=(const Fifty& y);
  Fifty& operator/=(const Fifty& y);

  friend Fifty operator+(Fifty x, const Fifty& y) { return x += y; }
  friend Fifty operator-(Fifty x, const Fifty& y) { return x -= y; }
  friend Fifty operator*(Fifty x, const Fifty& y) { return x *= y; }
  friend Fifty operator/(Fifty x, const Fifty& y) { return x /= y; }
  friend Fifty operator+(const Fifty& x) { return x; }
  friend Fifty operator-(const Fifty& x);
  friend bool operator==(const Fifty& x, const Fifty& y);
  friend std::partial_ordering operator<=>(const Fifty& x, const Fifty& y);
  /// @}

  /// @name Elementary functions
  /// The names of the standard library; to a few units of the fiftieth digit.
  /// @{
  friend Fifty sqrt(const Fifty& x);   ///< NaN below zero
  friend Fifty cbrt(const Fifty& x);   ///< of either sign
  friend Fifty exp(const Fifty& x);    ///< e to the x
  friend Fifty expm1(const Fifty& x);  ///< without cancellation near 0
  friend Fifty log(const Fifty& x);    ///< -inf at zero, NaN below
  friend Fifty log1p(const Fifty& x);  ///< without cancellation near 0; -inf at -1, NaN below
  friend Fifty sin(const Fifty& x);    ///< x in radians, near a multiple of π too; NaN from |x| = 1e45 on
  friend Fifty cos(const Fifty& x);    ///< the same of the cosine
  friend Fifty tan(const Fifty& x);    ///< and of the tangent
  friend Fifty asin(const Fifty& x);   ///< NaN outside [-1, 1]
  friend Fifty acos(const Fifty& x);   ///< NaN outside [-1, 1]
  friend Fifty atan(const Fifty& x);   ///< from -½π to ½π
  friend Fifty atan2(const Fifty& y, const Fifty& x);   ///< the angle of the point (x, y), from -π to π
  friend Fifty sinh(const Fifty& x);                    ///< the hyperbolic sine
  friend Fifty cosh(const Fifty& x);                    ///< the hyperbolic cosine
  friend Fifty tanh(const Fifty& x);                    ///< the hyperbolic tangent
  friend Fifty asinh(const Fifty& x);                   ///< of every x
  friend Fifty acosh(const Fifty& x);                   ///< NaN below 1
  friend Fifty atanh(const Fifty& x);                   ///< infinite at ±1, NaN beyond
  friend Fifty pow(const Fifty& x, const Fifty& y);     ///< NaN for x below zero unless y is whole
  friend Fifty pow(const Fifty& x, int n);              ///< by repeated squaring, for negative x too
  friend Fifty hypot(const Fifty& x, const Fifty& y);   ///< √(xx + yy)
  friend Fifty abs(const Fifty& x);                     ///< without its sign
  friend Fifty fabs(const Fifty& x) { return abs(x); }  ///< the same
  friend Fifty floor(const Fifty& x);                   ///< the next whole number below
  friend Fifty ceil(const Fifty& x);                    ///< the next whole number above
  friend Fifty round(const Fifty& x);                   ///< halves away from zero, as `std::round`
  friend Fifty ldexp(const Fifty& x, int n);            ///< x 2ⁿ, exactly
  friend Fifty tgamma(const Fifty& x);                  ///< NaN at 0, -1, -2, ...
  friend Fifty lgamma(const Fifty& x);                  ///< ln |Γ(x)|; +inf at 0, -1, -2, ...
  friend bool isfinite(const Fifty& x);                 ///< neither infinite nor NaN
  friend bool isnan(const Fifty& x);                    ///< what an undefined operation gives
  /// @}

private:
  struct Exactly
  {
  };
  Fifty(Exactly, long long n);
  Fifty(Exactly, unsigned long long n);

  friend struct Inside;  // the compiled side, which knows what the bytes hold
  alignas(16) std::byte bytes_[64];
};

Fifty pi();           ///< 3.14159..., as near as 168 bits come: 4.3e-51 less than π, which is its sine
Fifty ln2();          ///< the natural logarithm of 2
Fifty euler_gamma();  ///< Euler's constant, 0.57721...

/**
 * The error of a double in units of its last place: |got - exact| over the spacing of doubles at `exact`.
 *
 * The spacing is that of the binade in which `exact` itself lies, 2^-1074 among the subnormals and at zero,
 * and that of the last binade for what is too large for a double. An infinite `got` is without error where
 * `exact` rounds to that infinity, and infinitely wrong elsewhere. With a NaN on either side the answer is
 * infinite.
 */
double ulps(double got, const Fifty& exact);

}  // namespace exact
