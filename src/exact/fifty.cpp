#include "exact/fifty.hpp"

#include "exact/inside.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/cbrt.hpp>
#include <boost/math/special_functions/expm1.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/log1p.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

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

using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<600, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

// ½π in two parts, of which the first has so few bits that a million times it is exact.
struct Quarter
{
  Real first;
  Real second;
};
const Quarter& quarter_turn()
{
  static const Quarter parts = [] {
    const Wide& all = boost::math::constants::half_pi<Wide>();
    const Wide first = ldexp(floor(ldexp(all, 136)), -136);
    return Quarter{first.convert_to<Real>(), Wide(all - first).convert_to<Real>()};
  }();
  return parts;
}

// Below a million the first difference is exact, and unless it all but vanishes the rest has all its digits. Else with 600
// bits for π: below 1e45 an angle of 168 bits comes no nearer to a multiple of ½π than some 2^-180, so that 2^-600 of the
// angle leave the rest all its digits.
Turned turned(const Real& x)
{
  const double about = x.convert_to<double>();
  if(std::abs(about) < 0x1p20)
  {
    const double whole = std::nearbyint(about / boost::math::constants::half_pi<double>());
    if(whole == 0)
      return {x, 0};
    const auto& [first, second] = quarter_turn();
    const Real rest = (x - whole * first) - whole * second;
    if(abs(rest) > 0x1p-60)
      return {rest, static_cast<int>(whole) & 3};
  }
  static const Wide quarter = boost::math::constants::half_pi<Wide>();
  const Wide whole = floor(Wide(x) / quarter + 0.5);
  const Wide rest = Wide(x) - whole * quarter;
  return {rest.convert_to<Real>(), (whole - 4 * floor(whole / 4)).convert_to<int>()};
}

struct SineCosine
{
  Real sine;
  Real cosine;
};

// Up to ¼π, from the nearest multiple of 1/32 by the addition theorem: beyond the power 20 nothing is left of the series for
// what remains, 1/64 at the most.
SineCosine sine_and_cosine(const Real& x)
{
  static constexpr int parts = 32, nodes = 27, powers = 20;
  static const auto at_node = [] {
    std::array<SineCosine, nodes> table;
    for(int j = 0; j < nodes; ++j)
      table[static_cast<std::size_t>(j)] = SineCosine{sin(Real(j) / parts), cos(Real(j) / parts)};
    return table;
  }();
  static const auto inverse_factorial = [] {
    std::array<Real, powers> table;
    Real factorial = 1;
    for(int n = 0; n < powers; ++n)
    {
      factorial *= std::max(n, 1);
      table[static_cast<std::size_t>(n)] = (n % 4 < 2 ? 1 : -1) / factorial;
    }
    return table;
  }();

  const double node = std::nearbyint(x.convert_to<double>() * parts);
  const Real left = x - node / parts, square = left * left;
  Real sine = 0, cosine = 0;
  for(std::size_t n = powers; n > 0; n -= 2)
  {
    sine = sine * square + inverse_factorial[n - 1];
    cosine = cosine * square + inverse_factorial[n - 2];
  }
  sine *= left;
  if(node == 0)
    return {sine, cosine};
  const SineCosine& at = at_node[static_cast<std::size_t>(std::abs(node))];
  const Real from = node < 0 ? Real(-at.sine) : at.sine;
  return {from * cosine + at.cosine * sine, at.cosine * cosine - from * sine};
}

SineCosine turned_back(const Real& x)
{
  const auto [rest, quarters] = turned(x);
  const auto [sine, cosine] = sine_and_cosine(rest);
  switch(quarters)
  {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

// NaN where the sine is not known. Whoever wants an angle's sine wants mostly its cosine too, and of its half both: the last
// two angles are remembered.
SineCosine sine_and_cosine_of_any(const Fifty& x)
{
  struct Remembered
  {
    Fifty x = nan();
    SineCosine of;
  };
  thread_local std::array<Remembered, 2> last;
  static const Fifty limit("1e45");
  if(!(abs(x) < limit))
    return {real(nan()), real(nan())};
  for(const Remembered& one : last)
    if(one.x == x)
      return one.of;
  last[1] = std::exchange(last[0], {x, turned_back(real(x))});
  return last[0].of;
}

// The angle of a point between the axis of x and the diagonal, 0 <= y <= x: turned back by the multiple of 1/32 that two
// terms find, it has a tangent below 1/48, and beyond the power 31 nothing is left of its series. No C library's arc tangent
// is the beginning: that would show in the last bit.
Real angle_below_diagonal(const Real& y, const Real& x)
{
  static const auto reciprocal = [] {
    std::array<Real, 16> table;
    for(std::size_t n = 0; n < table.size(); ++n)
      table[n] = Real(n % 2 == 0 ? 1 : -1) / (2 * n + 1);
    return table;
  }();

  Real tangent = y / x;
  const double about = tangent.convert_to<double>();
  const double node = std::nearbyint(32 * about * (1.0584 - 0.273 * about)) / 32;
  if(node != 0)
  {
    const auto [sine, cosine] = sine_and_cosine(node);
    tangent = (y * cosine - x * sine) / (x * cosine + y * sine);
  }
  const Real square = tangent * tangent;
  Real series = 0;
  for(std::size_t n = reciprocal.size(); n > 0; --n)
    series = series * square + reciprocal[n - 1];
  return node + series * tangent;
}

// Of a point off the axes and not at infinity.
Real angle_of(const Real& y, const Real& x)
{
  static const Real quarter = boost::math::constants::half_pi<Real>();
  const Real up = abs(y), right = abs(x);
  const Real first =
      up <= right ? angle_below_diagonal(up, right) : Real(quarter - angle_below_diagonal(right, up));
  const Real upper = x < 0 ? Real(2 * quarter - first) : first;
  return y < 0 ? Real(-upper) : upper;
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
  return fifty(sine_and_cosine_of_any(x).sine);
}
Fifty cos(const Fifty& x)
{
  return fifty(sine_and_cosine_of_any(x).cosine);
}
Fifty tan(const Fifty& x)
{
  const auto [sine, cosine] = sine_and_cosine_of_any(x);
  return fifty(sine / cosine);
}
Fifty atan(const Fifty& x)
{
  return atan2(x, 1);
}
Fifty atan2(const Fifty& y, const Fifty& x)
{
  const bool plain = isfinite(y) && isfinite(x) && y != 0 && x != 0;
  return fifty(plain ? angle_of(real(y), real(x)) : Real(atan2(real(y), real(x))));
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
  return abs(x) > 1 ? nan() : atan2(x, sqrt((1 - x) * (1 + x)));
}
Fifty acos(const Fifty& x)
{
  return abs(x) > 1 ? nan() : atan2(sqrt((1 - x) * (1 + x)), x);
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
