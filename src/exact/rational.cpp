#include "exact/rational.hpp"

#include "exact/inside.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace exact
{
namespace
{

namespace multiprecision = boost::multiprecision;
using Integer = multiprecision::cpp_int;
using Fraction = multiprecision::cpp_rational;

// Decimal digits with an optional minus sign; Boost alone would also take octal and hexadecimal ones.
Integer whole_number(const std::string& text)
{
  const std::string digits = text.starts_with('-') ? text.substr(1) : text;
  if(digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos)
  {
    throw std::invalid_argument("not a whole number: '" + text + "'");
  }
  const auto first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  const Integer size(digits.substr(first));
  return text.starts_with('-') ? Integer(-size) : size;
}

void require_nonnegative(int n, const char* what)
{
  if(n < 0)
  {
    throw std::domain_error(std::string(what) + " of a negative number");
  }
}

// The quotient n/d with `bits` significant bits or one more, the last one sticky: it is set if anything is
// lost, so that one more rounding to fewer bits is a correct one. The value is the result times 2^shift.
std::pair<Integer, int> sticky_quotient(const Integer& n, const Integer& d, int bits)
{
  const int shift = static_cast<int>(msb(n)) - static_cast<int>(msb(d)) - bits;
  const Integer up = shift < 0 ? Integer(n << static_cast<unsigned>(-shift)) : n;
  const Integer down = shift > 0 ? Integer(d << static_cast<unsigned>(shift)) : d;
  Integer quotient, rest;
  divide_qr(up, down, quotient, rest);
  if(rest != 0)
  {
    bit_set(quotient, 0);
  }
  return {quotient, shift};
}

}  // namespace

struct Rational::Value
{
  Fraction fraction;
};

Rational::Rational(Value value) : value_(std::make_shared<const Value>(std::move(value))) {}
Rational::Rational() : Rational(Value{0}) {}

Rational::Rational(long long numerator, long long denominator) : Rational()
{
  if(denominator == 0)
  {
    throw std::domain_error("a fraction with the denominator 0");
  }
  *this = Rational(Value{Fraction(Integer(numerator)) / Fraction(Integer(denominator))});
}

Rational::Rational(const char* text) : Rational()
{
  const std::string all = text;
  const auto bar = all.find('/');
  const Integer numerator = whole_number(all.substr(0, bar));
  const Integer denominator = bar == std::string::npos ? Integer(1) : whole_number(all.substr(bar + 1));
  if(denominator == 0)
  {
    throw std::domain_error("a fraction with the denominator 0: '" + all + "'");
  }
  *this = Rational(Value{Fraction(numerator) / Fraction(denominator)});
}

Rational Rational::exactly(double x)
{
  if(!std::isfinite(x))
  {
    throw std::domain_error("only a finite double is a fraction");
  }
  return Rational(Value{Fraction(x)});
}

std::string Rational::numerator() const
{
  return multiprecision::numerator(value_->fraction).str();
}
std::string Rational::denominator() const
{
  return multiprecision::denominator(value_->fraction).str();
}
std::string Rational::str() const
{
  return value_->fraction.str();
}

Rational::operator Fifty() const
{
  const Fraction size = abs(value_->fraction);
  if(size == 0)
  {
    return 0;
  }
  const auto [quotient, shift] =
      sticky_quotient(multiprecision::numerator(size), multiprecision::denominator(size), 200);
  const Fifty result = ldexp(fifty(Real(quotient)), shift);
  return value_->fraction < 0 ? -result : result;
}

Rational::operator double() const
{
  const Fraction size = abs(value_->fraction);
  if(size == 0)
  {
    return 0;
  }
  // A Fifty would round a first time: 70 bits with a sticky one pass through it unrounded.
  const auto [quotient, shift] =
      sticky_quotient(multiprecision::numerator(size), multiprecision::denominator(size), 70);
  const double result = static_cast<double>(ldexp(fifty(Real(quotient)), shift));
  return value_->fraction < 0 ? -result : result;
}

Rational& Rational::operator+=(const Rational& y)
{
  return *this = Rational(Value{value_->fraction + y.value_->fraction});
}

Rational& Rational::operator-=(const Rational& y)
{
  return *this = Rational(Value{value_->fraction - y.value_->fraction});
}

Rational& Rational::operator*=(const Rational& y)
{
  return *this = Rational(Value{value_->fraction * y.value_->fraction});
}

Rational& Rational::operator/=(const Rational& y)
{
  if(y.value_->fraction == 0)
  {
    throw std::domain_error("division of a fraction by zero");
  }
  return *this = Rational(Value{value_->fraction / y.value_->fraction});
}

bool operator==(const Rational& x, const Rational& y)
{
  return x.value_->fraction == y.value_->fraction;
}

std::strong_ordering operator<=>(const Rational& x, const Rational& y)
{
  return x.value_->fraction.compare(y.value_->fraction) <=> 0;
}

Rational abs(const Rational& x)
{
  return x < 0 ? -x : x;
}

Rational pow(const Rational& x, int n)
{
  Rational power = 1;
  Rational square = n < 0 ? Rational(1) / x : x;
  for(int left = n; left != 0; left /= 2)
  {
    if(left % 2 != 0)
    {
      power *= square;
    }
    square *= square;
  }
  return power;
}

Rational factorial(int n)
{
  require_nonnegative(n, "factorial");
  Rational product = 1;
  for(int i = 2; i <= n; ++i)
  {
    product *= i;
  }
  return product;
}

Rational double_factorial(int n)
{
  require_nonnegative(n + 1, "double factorial");
  Rational product = 1;
  for(int i = n; i > 1; i -= 2)
  {
    product *= i;
  }
  return product;
}

Rational double_factorial_ratio(int n)
{
  require_nonnegative(n, "double factorial");
  return double_factorial(2 * n - 1) / double_factorial(2 * n);
}

Rational binomial(const Rational& x, int k)
{
  require_nonnegative(k, "binomial coefficient with the lower number");
  Rational product = 1;
  for(int i = 0; i < k; ++i)
  {
    product *= (x - i) / (i + 1);
  }
  return product;
}

Rational bernoulli(int n)
{
  require_nonnegative(n, "Bernoulli number");
  std::vector<Rational> b = {1};
  for(int m = 1; m <= n; ++m)
  {
    Rational sum = 0;
    for(int j = 0; j < m; ++j)
    {
      sum += binomial(m + 1, j) * b[static_cast<std::size_t>(j)];
    }
    b.push_back(-sum / (m + 1));
  }
  return b.back();
}

}  // namespace exact
