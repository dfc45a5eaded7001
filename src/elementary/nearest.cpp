#include "elementary/nearest.hpp"

#include <cmath>
#include <limits>

#include "elementary/reduction.hpp"

namespace elementary::nearest
{
namespace
{

using Double = Pair<double>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// 1/n!, of which the first few are wanted to two doubles.
constexpr Double inverse_factorial[] = {{0x1p+0, 0},
                                        {0x1p+0, 0},
                                        {0x1p-1, 0},
                                        {0x1.5555555555555p-3, 0x1.5555555555555p-57},
                                        {0x1.5555555555555p-5, 0x1.5555555555555p-59},
                                        {0x1.1111111111111p-7, 0x1.1111111111111p-63},
                                        {0x1.6c16c16c16c17p-10, -0x1.f49f49f49f49fp-65},
                                        {0x1.a01a01a01a01ap-13, 0x1.a01a01a01a01ap-73},
                                        {0x1.a01a01a01a01ap-16, 0x1.a01a01a01a01ap-76},
                                        {0x1.71de3a556c734p-19, -0x1.c154f8ddc6cp-73},
                                        {0x1.27e4fb7789f5cp-22, 0x1.cbbc05b4fa99ap-76},
                                        {0x1.ae64567f544e4p-26, -0x1.c062e06d1f209p-80},
                                        {0x1.1eed8eff8d898p-29, 0},
                                        {0x1.6124613a86d09p-33, 0},
                                        {0x1.93974a8c07c9dp-37, 0},
                                        {0x1.ae7f3e733b81fp-41, 0},
                                        {0x1.ae7f3e733b81fp-45, 0},
                                        {0x1.952c77030ad4ap-49, 0},
                                        {0x1.6827863b97d97p-53, 0},
                                        {0x1.2f49b46814157p-57, 0},
                                        {0x1.e542ba4020225p-62, 0},
                                        {0x1.71b8ef6dcf572p-66, 0},
                                        {0x1.0ce396db7f853p-70, 0},
                                        {0x1.761b41316381ap-75, 0}};

/// log 2 in three parts, the first two of 42 bits: their products with whole numbers below 2¹¹ are exact.
constexpr double log_two[] = {0x1.62e42fefa38p-1, 0x1.ef35793c76p-45, 0x1.cc01f97b57a08p-87};
constexpr Double log_of_two{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr Double inverse_log_two{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
constexpr Double inverse_log_ten{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};

double added(Double x)
{
  return x.value + x.lost;
}

Double negative(Double x)
{
  return {-x.value, -x.lost};
}

Double plus(Double a, Double b)
{
  const Double sum = sum_of(a.value, b.value);
  return ordered_sum(sum.value, sum.lost + (a.lost + b.lost));
}

Double times(Double a, Double b)
{
  const Double product = product_of(a.value, b.value);
  return ordered_sum(product.value, product.lost + (a.value * b.lost + a.lost * b.value));
}

/// `factor` is a power of two, and nothing underflows.
Double scaled(Double x, double factor)
{
  return {x.value * factor, x.lost * factor};
}

Double over(Double a, Double b)
{
  const double q = a.value / b.value;
  const Double back = product_of(q, b.value);
  return ordered_sum(q, (((a.value - back.value) - back.lost) + (a.lost - q * b.lost)) / b.value);
}

Double root(Double x)
{
  const double r = std::sqrt(x.value);
  if(r == 0)
    return {0, 0};
  const Double square = product_of(r, r);
  return ordered_sum(r, (((x.value - square.value) - square.lost) + x.lost) / (2 * r));
}

/// A number x.value·2^power + …, as one double: rounded once, also where it is so small that it has fewer digits.
double result(Double x, int power)
{
  int own = 0;
  std::frexp(x.value, &own);  // |x| is from 2^(own − 1) to 2^own
  const int lowest = -1022 - power;
  if(own + power > 1100)
    return x.value * infinity;
  if(own + power < -1100)
    return x.value * 0;
  if(own - 1 >= lowest)
    return std::ldexp(added(x), power);
  const double guard = std::copysign(std::ldexp(1.0, lowest), x.value);
  const Double sum = sum_of(guard, x.value);
  return std::ldexp((sum.value + (sum.lost + x.lost)) - guard, power);
}

/// A positive double as mantissa·2^power, the mantissa from √½ to √2.
struct Split
{
  double mantissa;
  int power;
};

Split split(double x)
{
  int power = 0;
  double mantissa = std::frexp(x, &power);
  if(mantissa < 0x1.6a09e667f3bcdp-1)
  {
    mantissa *= 2;
    --power;
  }
  return {mantissa, power};
}

/// c₀ + c₁z + … with coefficients ±1/n!, n = first, first + step, …, last, of which all but `exactly` are of one double.
/// `sign` is that of their quotients.
Double series(Double z, int first, int step, int last, int exactly, int sign)
{
  int n = last;
  double tail = 0;
  for(; n >= first + exactly * step; n -= step)
    tail = inverse_factorial[n].value + sign * (z.value * tail);
  Double sum = ordered_sum(inverse_factorial[n].value, inverse_factorial[n].lost + sign * (z.value * tail));
  for(n -= step; n >= first; n -= step)
  {
    const Double more = times(z, sum);
    sum = plus(inverse_factorial[n], sign > 0 ? more : negative(more));
  }
  return sum;
}

/// sin r, cos r for |r| ≤ ¼π, to some 2⁻⁷⁶ of themselves.
SineCosine<Double> sincos_of(Double r)
{
  if(magnitude(r.value) < 0x1p-200)  // the squares vanish
    return {r, {1, 0}};
  const Double z = times(r, r);
  const Double sine = plus(r, negative(times(times(r, z), series(z, 3, 2, 23, 5, -1))));
  const Double cosine = plus({1, 0}, negative(times(z, series(z, 2, 2, 22, 5, -1))));
  return {sine, cosine};
}

/// Whether x rounds to one double for every error up to `error` of itself.
bool sure(Double x, double error)
{
  return x.value + (x.lost + error * x.value) == x.value + (x.lost - error * x.value);
}

/// sin r and cos r as sincos_of has them, but to 2⁻⁵⁸ and 2⁻⁵⁶: of their series all but two terms in one double. Enough
/// for nine in ten.
Double swift_sine(Double r)
{
  const Double square = product_of(r.value, r.value);
  const Double z{square.value, square.lost + 2 * r.value * r.lost};
  double tail = 0;
  for(int n = 17; n >= 5; n -= 2)
    tail = inverse_factorial[n].value - z.value * tail;
  const Double cubic = times(z, inverse_factorial[3]);
  const Double less = ordered_sum(cubic.value, cubic.lost - z.value * z.value * tail);
  return plus(r, negative(times(r, less)));
}
Double swift_cosine(Double r)
{
  const Double square = product_of(r.value, r.value);
  const Double half{0.5 * square.value, 0.5 * square.lost + r.value * r.lost};
  double tail = 0;
  for(int n = 16; n >= 4; n -= 2)
    tail = inverse_factorial[n].value - square.value * tail;
  const Double first = ordered_sum(1., -half.value);
  return ordered_sum(first.value, first.lost - half.lost + square.value * square.value * tail);
}

/// sin (x + ½π·more).
double sine(double x, std::uint64_t more)
{
  const circular::Reduced<double> reduced = circular::reduced_any(x);
  const Double r = ordered_sum(reduced.rest.value, reduced.rest.lost);
  const std::uint64_t turns = reduced.turns + more;
  const bool across = (turns & 1) != 0;
  double size = 0;
  if(magnitude(r.value) > 0x1p-200)  // else the squares vanish
  {
    const Double nearly = across ? swift_cosine(r) : swift_sine(r);
    const bool enough = sure(nearly, across ? 0x1p-56 : 0x1p-58);
    size = added(enough ? nearly : across ? sincos_of(r).cosine : sincos_of(r).sine);
  }
  else
    size = across ? 1 + r.value : r.value;
  return (turns & 2) != 0 ? -size : size;
}

/// sin and cos of any double; NaN where it is not finite.
SineCosine<Double> sincos_of(double x)
{
  const circular::Reduced<double> r = circular::reduced_any(x);
  const SineCosine<Double> of = sincos_of(ordered_sum(r.rest.value, r.rest.lost));
  const Double sine = (r.turns & 1) != 0 ? of.cosine : of.sine;
  const Double cosine = (r.turns & 1) != 0 ? of.sine : of.cosine;
  return {(r.turns & 2) != 0 ? negative(sine) : sine, ((r.turns + 1) & 2) != 0 ? negative(cosine) : cosine};
}

/// The angle of the point (x, y), of which the nearest double to it in each place is taken first.
Double angle_of(Double y, Double x)
{
  const double near = elementary::atan2(y.value, x.value);
  const SineCosine<Double> at = sincos_of(near);
  const Double off = plus(times(y, at.cosine), negative(times(x, at.sine)));
  const Double along = plus(times(x, at.cosine), times(y, at.sine));
  return ordered_sum(near, off.value / along.value);
}

/// eˣ − 1 for |x| ≤ 0.4, to some 2⁻⁷⁷ of itself: of a sixteenth of x by the series, and doubled four times.
Double expm1_of(Double x)
{
  if(magnitude(x.value) < 0x1p-100)
    return x;
  const Double r = scaled(x, 0x1p-4);
  Double e = plus(r, times(times(r, r), series(r, 2, 1, 13, 4, 1)));
  for(int n = 0; n < 4; ++n)
    e = plus(scaled(e, 2), times(e, e));
  return e;
}

/// eˣ as (1 + rest)·2^power.
struct Exponential
{
  Double rest;
  int power;
};

/// For |x| < 2¹⁰.
Exponential exponential(Double x)
{
  const double shifted = x.value * inverse_log_two.value + 0x1.8p52;
  const double k = shifted - 0x1.8p52;
  const Double first = difference_of(x.value - k * log_two[0], k * log_two[1]);
  const Double rest = ordered_sum(first.value, first.lost + (x.lost - k * log_two[2]));
  return {expm1_of(rest), static_cast<int>(k)};
}

Double whole(const Exponential& e)
{
  return plus({1, 0}, e.rest);
}

/// log (1 + w) for −0.3 ≤ w ≤ 0.42, to some 2⁻⁷⁷ of itself: nearly, and then what is missing.
Double log1p_small(Double w)
{
  if(magnitude(w.value) < 0x1p-100)
    return w;
  const double s = w.value / (2 + w.value), z = s * s;
  double terms = 0;
  for(int n = 21; n >= 3; n -= 2)
    terms = 1. / n + z * terms;
  const double near = 2 * s + 2 * s * z * terms;
  const Double back = expm1_of({-near, 0});
  const Double off = plus(w, plus(back, times(w, back)));
  return ordered_sum(near, off.value + (off.lost - 0.5 * off.value * off.value));
}

/// log (m·2^k), where log m is given.
Double with_powers(int k, Double log_m)
{
  if(k == 0)
    return log_m;
  const Double first = sum_of(k * log_two[0], k * log_two[1]);
  return plus({first.value, first.lost + k * log_two[2]}, log_m);
}

/// log x for a positive finite x.
Double log_of(double x)
{
  const Split s = split(x);
  return with_powers(s.power, log1p_small({s.mantissa - 1, 0}));
}

/// What a logarithm is of an x that is not positive and finite.
double log_beyond(double x)
{
  return x == 0 ? -infinity : x > 0 ? x : nan;
}

/// log (1 + w) for a finite w > −1.
Double log1p_of(Double w)
{
  if(w.value >= -0.29 && w.value <= 0.41)
    return log1p_small(w);
  const Double sum = plus({1, 0}, w);
  const Split s = split(sum.value);
  return with_powers(s.power, log1p_small(sum_of(s.mantissa - 1, std::ldexp(sum.lost, -s.power))));
}

/// x^n·2^(−power·n) of a mantissa, n > 0.
Double whole_power(double mantissa, int n)
{
  Double square{mantissa, 0}, product{1, 0};
  for(; n > 0; n /= 2)
  {
    if(n % 2 != 0)
      product = times(product, square);
    square = times(square, square);
  }
  return product;
}

/// |x|ʸ for finite x ≠ 0 and finite y ≠ 0.
double power_of(double x, double y)
{
  const Split s = split(magnitude(x));
  constexpr int most = 64;
  if(magnitude(y) <= most && y == std::trunc(y))
  {
    const int n = static_cast<int>(magnitude(y));
    const Double product = whole_power(s.mantissa, n);
    return y > 0 ? result(product, n * s.power) : result(over({1, 0}, product), -n * s.power);
  }
  if(magnitude(y) < 0x1p-70)
    return 1;
  const Double log_x = with_powers(s.power, log1p_small({s.mantissa - 1, 0}));
  if(magnitude(y) > 0x1p70)
    return log_x.value == 0 ? 1 : (log_x.value > 0) == (y > 0) ? infinity : 0;
  const Double t = times({y, 0}, log_x);
  if(!(magnitude(t.value) < 1000))
    return t.value > 0 ? infinity : 0;
  const Exponential e = exponential(t);
  return result(whole(e), e.power);
}

/// ½(eˣ + sign·e⁻ˣ) for 0 ≤ x < 800.
double half_sum(double x, double sign)
{
  const Exponential e = exponential({x, 0});
  const Double up = whole(e), down = over({1, 0}, up);
  const double square = e.power > 100 ? 0 : std::ldexp(1.0, -2 * e.power);
  return result(plus(up, scaled(down, sign * square)), e.power - 1);
}

/// With the sign of x.
double signed_as(double x, double size)
{
  return std::copysign(size, x);
}

}  // namespace

double sin(double x)
{
  return magnitude(x) < 0x1p-27 ? x : sine(x, 0);
}

double cos(double x)
{
  return sine(x, 1);
}

double tan(double x)
{
  if(magnitude(x) < 0x1p-27)
    return x;
  const SineCosine<Double> of = sincos_of(x);
  return added(over(of.sine, of.cosine));
}

double asin(double x)
{
  if(!(magnitude(x) <= 1))
    return nan;
  if(magnitude(x) < 0x1p-27)
    return x;
  const Double other = root(times(sum_of(1., x), difference_of(1., x)));
  return added(angle_of({x, 0}, other));
}

double acos(double x)
{
  if(!(magnitude(x) <= 1))
    return nan;
  const Double other = root(times(sum_of(1., x), difference_of(1., x)));
  return added(angle_of(other, {x, 0}));
}

double atan(double x)
{
  if(!(magnitude(x) >= 0x1p-27))
    return x;
  return magnitude(x) > 0x1p60 ? elementary::atan(x) : added(angle_of({x, 0}, {1, 0}));
}

double atan2(double y, double x)
{
  const double size_y = magnitude(y), size_x = magnitude(x);
  if(!(size_y > 0 && size_x > 0 && size_y < infinity && size_x < infinity))
    return elementary::atan2(y, x);
  int of_y = 0, of_x = 0;
  const double a = std::frexp(y, &of_y), b = std::frexp(x, &of_x);
  const int apart = of_y - of_x;
  if(apart > 60 || apart < -60)
    return elementary::atan2(y, x);
  return added(
      angle_of({apart > 0 ? a : std::ldexp(a, apart), 0}, {apart > 0 ? std::ldexp(b, -apart) : b, 0}));
}

double exp(double x)
{
  if(!(magnitude(x) < 800))
    return x > 0 ? infinity : x < 0 ? 0 : x;
  const Exponential e = exponential({x, 0});
  return result(whole(e), e.power);
}

double exp2(double x)
{
  if(!(magnitude(x) < 1100))
    return x > 0 ? infinity : x < 0 ? 0 : x;
  const double k = (x + 0x1.8p52) - 0x1.8p52;
  return result(plus({1, 0}, expm1_of(times({x - k, 0}, log_of_two))), static_cast<int>(k));
}

double expm1(double x)
{
  if(magnitude(x) < 0x1p-54 || !(magnitude(x) < 800))
    return x == -infinity ? -1 : magnitude(x) < 1 || x != x ? x : x > 0 ? infinity : -1;
  if(magnitude(x) < 0.35)
    return added(expm1_of({x, 0}));
  const Exponential e = exponential({x, 0});
  if(e.power > 200)
    return result(whole(e), e.power);
  const double factor = std::ldexp(1.0, e.power < -200 ? -200 : e.power);
  return added(plus({-1, 0}, scaled(whole(e), factor)));
}

double log(double x)
{
  if(!(x > 0 && x < infinity))
    return log_beyond(x);
  return added(log_of(x));
}

double log2(double x)
{
  if(!(x > 0 && x < infinity))
    return log_beyond(x);
  const Split s = split(x);
  return added(
      plus({static_cast<double>(s.power), 0}, times(log1p_small({s.mantissa - 1, 0}), inverse_log_two)));
}

double log10(double x)
{
  if(!(x > 0 && x < infinity))
    return log_beyond(x);
  return added(times(log_of(x), inverse_log_ten));
}

double log1p(double x)
{
  if(!(x > -1 && x < infinity))
    return x == -1 ? -infinity : x > 0 ? x : nan;
  return magnitude(x) < 0x1p-54 ? x : added(log1p_of({x, 0}));
}

double pow(double x, double y)
{
  if(x == 1 || y == 0)
    return 1;
  if(x != x || y != y)
    return nan;
  const bool integer = magnitude(y) >= 0x1p53 || y == std::trunc(y);
  const bool odd = integer && magnitude(y) < 0x1p53 && std::trunc(y / 2) * 2 != y;
  const double sign = odd ? std::copysign(1.0, x) : 1.0;
  const double size = magnitude(x);
  if(magnitude(y) == infinity)
    return size == 1 ? 1 : (size > 1) == (y > 0) ? infinity : 0;
  if(size == 0 || size == infinity)
    return sign * ((size == 0) == (y > 0) ? 0 : infinity);
  return x < 0 && !integer ? nan : sign * power_of(x, y);
}

double cbrt(double x)
{
  if(!(magnitude(x) > 0 && magnitude(x) < infinity))
    return x;
  int power = 0;
  double m = std::frexp(magnitude(x), &power);
  const int third = (power >= 0 ? power + 2 : power) / 3;
  m = std::ldexp(m, power - 3 * third);  // from 1/8 to 1
  double r = 0.5 + 0.5 * m;
  for(int n = 0; n < 7; ++n)
    r -= (r * r * r - m) / (3 * r * r);
  const Double cube = times(product_of(r, r), {r, 0});
  return signed_as(x, result(ordered_sum(r, ((m - cube.value) - cube.lost) / (3 * r * r)), third));
}

double hypot(double x, double y)
{
  double a = magnitude(x), b = magnitude(y);
  if(a == infinity || b == infinity)
    return infinity;
  if(!(a >= b))
  {
    const double other = a;
    a = b;
    b = other;
  }
  if(a != a || b != b)
    return nan;
  int power = 0, of_b = 0;
  const double most = std::frexp(a, &power);
  std::frexp(b, &of_b);
  if(b == 0 || power - of_b > 60)
    return a;
  const double least = std::ldexp(b, -power);
  return result(root(plus(product_of(most, most), product_of(least, least))), power);
}

double sinh(double x)
{
  const double size = magnitude(x);
  if(size < 0x1p-27 || !(size < 800))
    return size < 1 || x != x ? x : signed_as(x, infinity);
  if(size < 0.35)
  {
    const Double e = expm1_of({size, 0});
    return signed_as(x, added(scaled(plus(e, over(e, plus({1, 0}, e))), 0.5)));
  }
  return signed_as(x, half_sum(size, -1));
}

double cosh(double x)
{
  const double size = magnitude(x);
  if(!(size < 800))
    return size * infinity;
  return half_sum(size, 1);
}

double tanh(double x)
{
  const double size = magnitude(x);
  if(size < 0x1p-27 || !(size < 22))
    return size < 1 || x != x ? x : signed_as(x, 1);
  if(size < 0.17)
  {
    const Double e = expm1_of({2 * size, 0});
    return signed_as(x, added(over(e, plus(e, {2, 0}))));
  }
  const Exponential e = exponential({2 * size, 0});
  const Double square = scaled(whole(e), std::ldexp(1.0, e.power));
  return signed_as(x, added(over(plus(square, {-1, 0}), plus(square, {1, 0}))));
}

double asinh(double x)
{
  const double size = magnitude(x);
  if(size < 0x1p-27 || !(size < infinity))
    return x;
  if(size > 0x1p40)
    return signed_as(x, added(plus(log_of(size), log_of_two)));
  const Double square = product_of(size, size);
  const Double side = root(plus({1, 0}, square));
  return signed_as(x, added(log1p_of(plus({size, 0}, over(square, plus({1, 0}, side))))));
}

double acosh(double x)
{
  if(!(x >= 1 && x < infinity))
    return x > 1 ? x : nan;
  if(x > 0x1p40)
    return added(plus(log_of(x), log_of_two));
  const Double t = difference_of(x, 1.0);
  return t.value == 0 ? 0 : added(log1p_of(plus(t, root(times(t, plus(t, {2, 0}))))));
}

double atanh(double x)
{
  const double size = magnitude(x);
  if(!(size < 1))
    return size == 1 ? signed_as(x, infinity) : nan;
  if(size < 0x1p-27)
    return x;
  return signed_as(x, added(scaled(log1p_of(over({2 * size, 0}, difference_of(1.0, size))), 0.5)));
}

}  // namespace elementary::nearest
