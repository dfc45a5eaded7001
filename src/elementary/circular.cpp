#include "elementary/circular.hpp"

#include <cmath>
#include <limits>

#include "elementary/reduction.hpp"

namespace elementary
{
namespace
{

using circular::Reduced;
using Double = Pair<double>;
__extension__ using Wide = unsigned __int128;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Double half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr Double fourth_pi{0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};
constexpr Double pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

/// The bits of 2/π from 2⁶³ down; each line has 4 times 64.
constexpr std::uint64_t two_over_pi[] = {
    0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041,  //
    0xfe5163abdebbc561, 0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e,  //
    0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b,  //
    0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,  //
    0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab};

/// x ≥ 2⁻¹⁰ reduced in whole numbers: of the 1200 bits of 2/π those that count, 256, times the 53 of x.
/// At least 138 bits of the fraction are right, and no double comes nearer to a quarter turn than 2⁻⁶².
Reduced<double> reduced_by_integers(double x)
{
  const std::uint64_t bits = bits_of(x);
  const int exponent = static_cast<int>(bits >> 52) - 1075;
  const std::uint64_t mantissa = (bits & 0xfffffffffffff) | 0x10000000000000;
  const int first = (exponent + 62) / 64;
  std::uint64_t product[4];  // the leading word first
  std::uint64_t carry = 0;
  for(int k = 3; k >= 0; --k)
  {
    const Wide sum = Wide{mantissa} * two_over_pi[first + k] + carry;
    product[k] = static_cast<std::uint64_t>(sum);
    carry = static_cast<std::uint64_t>(sum >> 64);
  }
  const int shift = 62 + exponent - 64 * first;  // after which the two upper bits are the quarter turns
  const auto shifted = [&product](int k, int by) {
    return by == 0 ? product[k] : product[k] << by | product[k + 1] >> (64 - by);
  };
  const std::uint64_t top = shifted(0, shift);
  std::uint64_t f[3];
  for(int k = 0; k < 3; ++k)
    f[k] = shifted(k, shift) << 2 | (k < 2 ? shifted(k + 1, shift) : product[3] << shift) >> 62;
  const bool beyond = f[0] >> 63 != 0;  // more than half a quarter turn
  for(std::uint64_t& word : f)
    word = beyond ? ~word : word;
  const Double upper = ordered_sum(static_cast<double>(f[0] >> 11) * 0x1p-53,
                                   static_cast<double>((f[0] & 0x7ff) << 42 | f[1] >> 22) * 0x1p-106);
  const double lower = upper.lost + static_cast<double>((f[1] & 0x3fffff) << 31 | f[2] >> 33) * 0x1p-159;
  const Double main = product_of(half_pi.value, upper.value);
  const Double rest =
      ordered_sum(main.value, main.lost + (half_pi.value * lower + half_pi.lost * upper.value));
  const std::uint64_t turns = (top >> 62) + (beyond ? 1 : 0);
  return {beyond ? Double{-rest.value, -rest.lost} : rest, turns};
}

double added(Double x)
{
  return x.value + x.lost;
}

double with_sign(double x, std::uint64_t sign)
{
  return from_bits<double>(bits_of(x) ^ sign);
}

/// sin (r + ½π·turns).
double sine_after(const Double& r, std::uint64_t turns)
{
  return with_sign(added((turns & 1) != 0 ? circular::cosine(r) : circular::sine(r)), (turns & 2) << 62);
}

/// a/b, to some 2⁻¹⁰⁰.
Double quotient(Double a, Double b)
{
  const double q = a.value / b.value;
  const Double back = product_of(q, b.value);
  return {q, (((a.value - back.value) - back.lost) + (a.lost - q * b.lost)) / b.value};
}

/// arctan s = s + s³(c₀ + c₁s² + …) for |s| ≤ tan ⅛π; the sum errs by 2⁻⁵⁷ s at most.
constexpr double arc_terms[] = {-0x1.555555555553cp-2, 0x1.99999999955a2p-3,  -0x1.249249229d06fp-3,
                                0x1.c71c70e005f95p-4,  -0x1.745cf8372326bp-4, 0x1.3b110e20e6701p-4,
                                -0x1.10eb4087eec26p-4, 0x1.df08bf670b490p-5,  -0x1.9cb64fb2a57f9p-5,
                                0x1.378fe78e6ba46p-5,  -0x1.24d69ca6588bep-6};

/// arctan y/x from 0 to ½π as a sum, for x, y ≥ 0 that are neither both zero nor far from 1, both.
Double arc_tangent(Double y, Double x)
{
  constexpr double eighth = 0.41421356237309503;  // its tangent
  const bool steep = eighth * y.value > x.value;
  const bool flat = y.value < eighth * x.value;
  Double above = y, below = x, from{0, 0};
  if(steep)
  {
    above = {-x.value, -x.lost};
    below = y;
    from = half_pi;
  }
  else if(!flat)
  {
    const Double difference = difference_of(y.value, x.value);
    const Double sum = sum_of(y.value, x.value);
    above = {difference.value, difference.lost + (y.lost - x.lost)};
    below = {sum.value, sum.lost + (y.lost + x.lost)};
    from = fourth_pi;
  }
  const Double s = quotient(above, below);
  const double z = s.value * s.value;
  double series = arc_terms[10];
  for(int k = 9; k >= 0; --k)
    series = arc_terms[k] + z * series;
  const Double main = sum_of(from.value, s.value);
  return {main.value, main.lost + (from.lost + (s.lost * (1 - z) + s.value * z * series))};
}

/// √(1 − x²) as a sum, for |x| ≤ 1.
Double other_side(double x)
{
  const Double sum = sum_of(1.0, x), difference = difference_of(1.0, x);
  const Double product = product_of(sum.value, difference.value);
  const double lost = product.lost + (sum.value * difference.lost + sum.lost * difference.value);
  const double root = std::sqrt(product.value);
  if(root == 0)
    return {0, 0};
  const Double square = product_of(root, root);
  return {root, (((product.value - square.value) - square.lost) + lost) / (2 * root)};
}

}  // namespace

Reduced<double> circular::reduced_any(double x)
{
  const double size = magnitude(x);
  if(size <= reach)
    return reduced(x);
  if(!(size < std::numeric_limits<double>::infinity()))
    return {{nan, nan}, 0};
  const Reduced<double> r = reduced_by_integers(size);
  return x > 0 ? r : Reduced<double>{{-r.rest.value, -r.rest.lost}, 0 - r.turns};
}

double sin(double x)
{
  if(magnitude(x) < 0x1p-27)
    return x;
  const Reduced<double> r = circular::reduced_any(x);
  return sine_after(r.rest, r.turns);
}

double cos(double x)
{
  const Reduced<double> r = circular::reduced_any(x);
  return sine_after(r.rest, r.turns + 1);
}

SineCosine<double> sincos(double x)
{
  const Reduced<double> r = circular::reduced_any(x);
  return {magnitude(x) < 0x1p-27 ? x : sine_after(r.rest, r.turns), sine_after(r.rest, r.turns + 1)};
}

double tan(double x)
{
  if(magnitude(x) < 0x1p-27)
    return x;
  const Reduced<double> r = circular::reduced_any(x);
  const Double s = circular::sine(r.rest), c = circular::cosine(r.rest);
  const Double sine = ordered_sum(s.value, s.lost), cosine = ordered_sum(c.value, c.lost);
  if((r.turns & 1) == 0)
    return added(quotient(sine, cosine));
  return -added(quotient(cosine, sine));
}

double atan(double x)
{
  const double size = magnitude(x);
  if(!(size >= 0x1p-27))
    return x;
  const double angle = size > 0x1p60 ? half_pi.value : added(arc_tangent({size, 0}, {1, 0}));
  return with_sign(angle, bits_of(x) & sign_bit);
}

double atan2(double y, double x)
{
  if(!(y == y && x == x))
    return nan;
  const std::uint64_t sign = bits_of(y) & sign_bit;
  const bool behind = (bits_of(x) & sign_bit) != 0;
  const double across = magnitude(y), along = magnitude(x);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if(across == infinity && along == infinity)
    return with_sign(behind ? 3 * fourth_pi.value : fourth_pi.value, sign);
  if(across == 0 || along == infinity)
    return with_sign(behind ? pi.value : 0, sign);
  if(along == 0 || across == infinity)
    return with_sign(half_pi.value, sign);
  int of_across = 0, of_along = 0;
  const double a = std::frexp(across, &of_across), b = std::frexp(along, &of_along);
  const int apart = of_across - of_along;
  if(apart > 60)
    return with_sign(half_pi.value, sign);
  if(apart < -60)
    return with_sign(behind ? pi.value : across / along, sign);
  const Double angle = apart > 0 ? arc_tangent({a, 0}, {std::ldexp(b, -apart), 0})
                                 : arc_tangent({std::ldexp(a, apart), 0}, {b, 0});
  if(!behind)
    return with_sign(added(angle), sign);
  const Double left = difference_of(pi.value, angle.value);
  return with_sign(left.value + (left.lost + (pi.lost - angle.lost)), sign);
}

double asin(double x)
{
  const double size = magnitude(x);
  if(!(size <= 1))
    return nan;
  if(size < 0x1p-27)
    return x;
  return with_sign(added(arc_tangent({size, 0}, other_side(x))), bits_of(x) & sign_bit);
}

double acos(double x)
{
  const double size = magnitude(x);
  if(!(size <= 1))
    return nan;
  if(size < 0x1p-60)
    return half_pi.value;
  const Double angle = arc_tangent(other_side(x), {size, 0});
  if(x > 0)
    return added(angle);
  const Double left = difference_of(pi.value, angle.value);
  return left.value + (left.lost + (pi.lost - angle.lost));
}

}  // namespace elementary
