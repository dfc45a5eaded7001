#pragma once
/** @file
 * Exact fractions, and the few exact numbers that Euler's series are made of.
 */
#include "exact/fifty.hpp"

#include <memory>

namespace exact
{

/**
 * A fraction of whole numbers of any size, always in lowest terms with a positive denominator.
 *
 * Source: `cpp_rational` of Boost.Multiprecision, which stays out of this header. A value is never changed
 * once made, so that copies share it.
 */
class Rational
{
public:
  Rational();  ///< Zero.
  /// A whole number.
  /// @{
  template <std::signed_integral Integer>
  Rational(Integer n) : Rational(static_cast<long long>(n), 1LL)
  {
  }
  template <std::unsigned_integral Integer>
  Rational(Integer n) : Rational(std::to_string(n).c_str())
  {
  }
  /// @}
  Rational(bool) = delete;
  Rational(double) = delete;  ///< a double is a fraction with a power of two below: say so with `exactly`

  /// @throws std::domain_error if the denominator is zero
  Rational(long long numerator, long long denominator);

  /// A whole number or a fraction in decimal digits: `"-22"`, `"355/113"`.
  /// @throws std::invalid_argument if the text is anything else
  /// @throws std::domain_error if the denominator is zero
  explicit Rational(const char* text);

  /// The fraction that a finite double is. @throws std::domain_error if it is not finite
  static Rational exactly(double x);

  std::string numerator() const;    ///< in decimal digits, with the sign
  std::string denominator() const;  ///< in decimal digits, positive
  std::string str() const;          ///< `"-3/4"`, or `"5"` for a whole number

  explicit operator double() const;  ///< the nearest double, ties to even
  explicit operator Fifty() const;   ///< to the last of its 168 bits

  /// The four operations and the comparisons, exactly. @throws std::domain_error on division by zero
  /// @{
  Rational& operator+=(const Rational& y);
  Rational& operator-=(const Rational& y);
  Rational& operator*=(const Rational& y);
  Rational& operator/=(const Rational& y);
  friend Rational operator+(Rational x, const Rational& y) { return x += y; }
  friend Rational operator-(Rational x, const Rational& y) { return x -= y; }
  friend Rational operator*(Rational x, const Rational& y) { return x *= y; }
  friend Rational operator/(Rational x, const Rational& y) { return x /= y; }
  friend Rational operator+(const Rational& x) { return x; }
  friend Rational operator-(const Rational& x) { return Rational() - x; }
  friend bool operator==(const Rational& x, const Rational& y);
  friend std::strong_ordering operator<=>(const Rational& x, const Rational& y);
  friend Rational abs(const Rational& x);
  /// @}

  /// @throws std::domain_error for a negative power of zero
  friend Rational pow(const Rational& x, int n);

private:
  struct Value;
  explicit Rational(Value value);
  std::shared_ptr<const Value> value_;
};

/// n! @throws std::domain_error if n < 0
Rational factorial(int n);

/// n!! = n (n-2) (n-4) ... down to 1 or 2, and 1 for n = 0 and n = -1. @throws std::domain_error if n < -1
Rational double_factorial(int n);

/// (2n-1)!! / (2n)!! = ½ · ¾ · ⅚ ···, the coefficients of 1/√(1-x). @throws std::domain_error if n < 0
Rational double_factorial_ratio(int n);

/// x (x-1) ... (x-k+1) / k!, for every fraction x. @throws std::domain_error if k < 0
Rational binomial(const Rational& x, int k);

/// The n-th Bernoulli number, with B₁ = -½. @throws std::domain_error if n < 0
Rational bernoulli(int n);

}  // namespace exact
