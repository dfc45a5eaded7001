#include "exact/fifty.hpp"

#include "exact/inside.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/cbrt.hpp>
#include <boost/math/special_functions/expm1.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/log1p.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace exact
{
namespace
{

namespace policies = boost::math::policies;

// Boost's own functions answer outside their domain as the standard library does, instead of throwing.
using Quiet = policies::policy<
    policies::domain_error<policies::ignore_error>, policies::pole_error<policies::ignore_error>,
    policies::overflow_error<policies::ignore_error>, policies::evaluation_error<policies::ignore_error>>;

Fifty nan()
{
  return std::numeric_limits<double>::quiet_NaN();
}
Fifty infinity()
{
  return std::numeric_limits<double>::infinity();
}

// Sign, digits with or without a point, exponent: no more than that. Boost alone would take "" and "0x1f" for
// numbers.
bool is_decimal(std::string_view text)
{
  const auto skip_sign = [&] {
    text.remove_prefix(text.starts_with('+') || text.starts_with('-') ? 1 : 0);
  };
  const auto skip_digits = [&] {
    const auto count = std::min(text.find_first_not_of("0123456789"), text.size());
    text.remove_prefix(count);
    return count;
  };
  skip_sign();
  auto digits = skip_digits();
  if(text.starts_with('.'))
  {
    text.remove_prefix(1);
    digits += skip_digits();
  }
  if(digits > 0 && (text.starts_with('e') || text.starts_with('E')))
  {
    text.remove_prefix(1);
    skip_sign();
    digits = skip_digits();
  }
  return digits > 0 && text.empty();
}

// An angle less the nearest multiple of ½π, and which one, modulo 4.
struct Turned
{
  Real rest;
  int quarters;
};

// With 600 bits for π: below 1e45 an angle of 168 bits comes no nearer to a multiple of ½π than some 2^-180, so that 2^-600
// of the angle leave the rest all its digits.
Turned turned(const Real& x)
{
  using Wide = boost::multiprecision::number<
      boost::multiprecision::cpp_bin_float<600, boost::multiprecision::digit_base_2>,
      boost::multiprecision::et_off>;
  static const Wide quarter = boost::math::constants::half_pi<Wide>();
  const Wide whole = floor(Wide(x) / quarter + 0.5);
  const Wide rest = Wide(x) - whole * quarter;
  return {rest.convert_to<Real>(), (whole - 4 * floor(whole / 4)).convert_to<int>()};
}

bool has_sine(const Fifty& x)
{
  static const Fifty limit("1e45");
  return abs(x) < limit;
}

}  // namespace

Fifty::Fifty()
{
  Inside::begin(*this, 0);
}
Fifty::Fifty(double x)
{
  Inside::begin(*this, x);
}
Fifty::Fifty(Exactly, long long n)
{
  Inside::begin(*this, n);
}
Fifty::Fifty(Exactly, unsigned long long n)
{
  Inside::begin(*this, n);
}
Fifty::Fifty(const Fifty& other)
{
  Inside::begin(*this, real(other));
}
Fifty::Fifty(const std::string& decimal) : Fifty(decimal.c_str()) {}

Fifty::Fifty(const char* decimal) : Fifty()
{
  if(!is_decimal(decimal))
  {
    throw std::invalid_argument("not a decimal number: '" + std::string(decimal) + "'");
  }
  Inside::of(*this) = Real(decimal);
}

Fifty& Fifty::operator=(const Fifty& other)
{
  if(this != &other)
    Inside::of(*this) = real(other);
  return *this;
}

Fifty::operator double() const
{
  return real(*this).convert_to<double>();
}

std::string Fifty::str(int digits) const
{
  if(digits < 1 || digits > 50)
  {
    throw std::out_of_range("a Fifty has 1 to 50 digits to show, not " + std::to_string(digits));
  }
  return real(*this).str(digits, std::ios_base::fmtflags{});
}

Fifty& Fifty::operator+=(const Fifty& y)
{
  return Inside::of(*this) += real(y), *this;
}
Fifty& Fifty::operator-=(const Fifty& y)
{
  return Inside::of(*this) -= real(y), *this;
}
Fifty& Fifty::operator*=(const Fifty& y)
{
  return Inside::of(*this) *= real(y), *this;
}
Fifty& Fifty::operator/=(const Fifty& y)
{
  return Inside::of(*this) /= real(y), *this;
}

Fifty operator-(const Fifty& x)
{
  return fifty(-real(x));
}
bool operator==(const Fifty& x, const Fifty& y)
{
  return real(x) == real(y);
}

std::partial_ordering operator<=>(const Fifty& x, const Fifty& y)
{
  if(isnan(x) || isnan(y))
  {
    return std::partial_ordering::unordered;
  }
  return real(x).compare(real(y)) <=> 0;
}

Fifty sqrt(const Fifty& x)
{
  return x < 0 ? nan() : fifty(sqrt(real(x)));
}
Fifty cbrt(const Fifty& x)
{
  return fifty(boost::math::cbrt(real(x), Quiet{}));
}
Fifty exp(const Fifty& x)
{
  return fifty(exp(real(x)));
}
Fifty sin(const Fifty& x)
{
  if(!has_sine(x))
  {
    return nan();
  }
  const auto [rest, quarters] = turned(real(x));
  const Real size = quarters % 2 == 0 ? Real(sin(rest)) : Real(cos(rest));
  return fifty(quarters < 2 ? size : Real(-size));
}
Fifty cos(const Fifty& x)
{
  if(!has_sine(x))
  {
    return nan();
  }
  const auto [rest, quarters] = turned(real(x));
  const Real size = quarters % 2 == 0 ? Real(cos(rest)) : Real(sin(rest));
  return fifty(quarters == 0 || quarters == 3 ? size : Real(-size));
}
Fifty tan(const Fifty& x)
{
  return sin(x) / cos(x);
}
Fifty atan(const Fifty& x)
{
  return fifty(atan(real(x)));
}
Fifty atan2(const Fifty& y, const Fifty& x)
{
  return fifty(atan2(real(y), real(x)));
}
Fifty cosh(const Fifty& x)
{
  return fifty(cosh(real(x)));
}
Fifty pow(const Fifty& x, const Fifty& y)
{
  return fifty(pow(real(x), real(y)));
}
Fifty pow(const Fifty& x, int n)
{
  return fifty(pow(real(x), n));
}
Fifty abs(const Fifty& x)
{
  return fifty(abs(real(x)));
}
Fifty floor(const Fifty& x)
{
  return fifty(floor(real(x)));
}
Fifty ceil(const Fifty& x)
{
  return fifty(ceil(real(x)));
}
Fifty ldexp(const Fifty& x, int n)
{
  return fifty(ldexp(real(x), n));
}
Fifty hypot(const Fifty& x, const Fifty& y)
{
  return sqrt(x * x + y * y);  // the exponent does not overflow
}
bool isfinite(const Fifty& x)
{
  return boost::multiprecision::isfinite(real(x));
}
bool isnan(const Fifty& x)
{
  return boost::multiprecision::isnan(real(x));
}

Fifty round(const Fifty& x)
{
  const Fifty whole = floor(abs(x));
  const Fifty size = abs(x) - whole < 0.5 ? whole : whole + 1;
  return x < 0 ? -size : size;
}

Fifty expm1(const Fifty& x)
{
  return abs(x) < 1 ? fifty(boost::math::expm1(real(x), Quiet{})) : exp(x) - 1;
}

Fifty log(const Fifty& x)
{
  if(x == 0)
  {
    return -infinity();
  }
  return x < 0 ? nan() : fifty(log(real(x)));
}

Fifty log1p(const Fifty& x)
{
  return abs(x) < 0.5 ? fifty(boost::math::log1p(real(x), Quiet{})) : log(1 + x);
}

Fifty asin(const Fifty& x)
{
  return abs(x) > 1 ? nan() : fifty(asin(real(x)));
}
Fifty acos(const Fifty& x)
{
  return abs(x) > 1 ? nan() : fifty(acos(real(x)));
}

// The hyperbolic functions by expm1 and log1p, none of which cancels for small arguments.
Fifty sinh(const Fifty& x)
{
  if(abs(x) > 1)
  {
    return fifty(sinh(real(x)));
  }
  const Fifty e = expm1(x);
  return (e + e / (1 + e)) / 2;
}

Fifty tanh(const Fifty& x)
{
  if(abs(x) > 100)
  {
    return x < 0 ? -1 : 1;
  }
  const Fifty e = expm1(2 * x);
  return e / (e + 2);
}

Fifty asinh(const Fifty& x)
{
  const Fifty size = abs(x);
  const Fifty y = log1p(size + size * size / (1 + sqrt(1 + size * size)));
  return x < 0 ? -y : y;
}

Fifty acosh(const Fifty& x)
{
  const Fifty above = x - 1;
  return x < 1 ? nan() : log1p(above + sqrt(above * (x + 1)));
}

Fifty atanh(const Fifty& x)
{
  if(abs(x) >= 1)
  {
    return abs(x) > 1 ? nan() : x * infinity();
  }
  return log1p(2 * x / (1 - x)) / 2;
}

Fifty tgamma(const Fifty& x)
{
  return x <= 0 && floor(x) == x ? nan() : fifty(boost::math::tgamma(real(x), Quiet{}));
}

Fifty lgamma(const Fifty& x)
{
  return x <= 0 && floor(x) == x ? infinity() : fifty(boost::math::lgamma(real(x), Quiet{}));
}

Fifty pi()
{
  return fifty(boost::math::constants::pi<Real>());
}
Fifty ln2()
{
  return fifty(boost::math::constants::ln_two<Real>());
}
Fifty euler_gamma()
{
  return fifty(boost::math::constants::euler<Real>());
}

double ulps(double got, const Fifty& exact)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if(std::isnan(got) || isnan(exact))
  {
    return infinite;
  }
  if(std::isinf(got) || !isfinite(exact))
  {
    return got == static_cast<double>(exact) ? 0 : infinite;
  }
  using Double = std::numeric_limits<double>;
  int exponent = Double::min_exponent;
  if(exact != 0)
  {
    frexp(real(exact), &exponent);
  }
  const int binade = std::clamp(exponent, Double::min_exponent, Double::max_exponent);
  return static_cast<double>(ldexp(abs(Fifty(got) - exact), Double::digits - binade));
}

}  // namespace exact
