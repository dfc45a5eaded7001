#include "elliptic/carlson.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <type_traits>

#include "elementary/exactly.hpp"

namespace elliptic
{
namespace
{

template <class Real>
constexpr bool is_double = std::is_same_v<Real, double>;

// The arguments are brought together until none differs from their mean by more than this part of it. The
// first term that the series lacks, of the twelfth power (R_F) or the tenth (R_J), is then below the last bit.
template <class Real>
const Real near_enough_F = is_double<Real> ? 0x1.ap-5 : 0x1p-14;
template <class Real>
const Real near_enough_J = is_double<Real> ? 0x1.8p-6 : 0x1p-17;

// Where p exceeds the others so far, t + p is p as long as it matters; in double but for one term more.
template <class Real>
constexpr double far_beyond = is_double<Real> ? 0x1p58 : 0x1p400;
// More steps than it then takes to bring the arguments together.
template <class Real>
constexpr int most_steps = is_double<Real> ? 96 : 256;

template <class Real>
void require_domain(const Real& x, const Real& y, const Real& z)
{
  using std::isfinite;
  const bool none_negative = x >= 0 && y >= 0 && z >= 0;
  const bool one_zero_at_most = x + y > 0 && y + z > 0 && z + x > 0;
  if(!none_negative || !one_zero_at_most)
    throw std::domain_error("Carlson's integrals: no argument may be negative, at most one zero");
  if(!isfinite(x) || !isfinite(y) || !isfinite(z))
    throw std::domain_error("Carlson's integrals: all arguments must be finite");
}

template <class Real>
void require_positive(const Real& p)
{
  using std::isfinite;
  if(!(p > 0) || !isfinite(p))
    throw std::domain_error("Carlson's integrals: the last argument must be positive and finite");
}

// Whether nothing overflows or underflows that matters, when all arguments but a zero lie so. No NaN does.
bool is_moderate(double x)
{
  return x >= 0x1p-300 && x <= 0x1p300;
}

// Σ (½)ₘ/m! (−E₂ + E₃)ᵐ, each term of the degree n over 2n + 1, to the degree 11, without its first term 1.
template <class Real>
Real series_F(const Real& E2, const Real& E3)
{
  const auto of = [](int n, int d) { return Real(n) / d; };
  const Real p0 =
      E2 * (of(-1, 10) + E2 * (of(1, 24) + E2 * (of(-5, 208) + E2 * (of(35, 2176) - E2 * of(3, 256)))));
  const Real p1 =
      of(1, 14) + E2 * (of(-3, 44) + E2 * (of(1, 16) + E2 * (of(-35, 608) + E2 * of(315, 5888))));
  const Real p2 = of(3, 104) + E2 * (of(-15, 272) + E2 * of(5, 64));
  const Real p3 = of(5, 304) - E2 * of(35, 736);
  return p0 + E3 * (p1 + E3 * (p2 + E3 * p3));
}

// The same of five numbers, with 3/(2n + 3), to the degree 9, and without 1 too.
template <class Real>
Real series_J(const Real& E2, const Real& E3, const Real& E4, const Real& E5)
{
  const auto of = [](int n, int d) { return Real(n) / d; };
  const Real p2 = E2 * (of(-3, 14) + E2 * (of(9, 88) + E2 * (of(-1, 16) + E2 * of(105, 2432))));
  const Real p3 = of(1, 6) + E2 * (of(-9, 52) + E2 * (of(45, 272) - E2 * of(5, 32)))
                  + E3 * (of(3, 40) - E2 * of(45, 304) + E3 * of(5, 112));
  const Real p4 = of(-3, 22) + E2 * (of(3, 20) - E2 * of(45, 304)) + E3 * (of(-9, 68) + E2 * of(15, 56))
                  + E4 * of(9, 152);
  const Real p5 = of(3, 26) + E2 * (of(-9, 68) + E2 * of(15, 112)) + E3 * of(9, 76) - E4 * of(3, 28);
  return p2 + E3 * p3 + E4 * p4 + E5 * p5;
}

// The same where three of the five are equal, from what the other two differ by from the mean.
template <class Real>
Real series_D(const Real& X, const Real& Y)
{
  const Real Z = -(X + Y) / 3, XY = X * Y, ZZ = Z * Z;
  return series_J(Real(XY - 6 * ZZ), Real((3 * XY - 8 * ZZ) * Z), Real(3 * (XY - ZZ) * ZZ),
                  Real(XY * ZZ * Z));
}

// And where two are equal, from what the other three differ by.
template <class Real>
Real series_of_four(const Real& X, const Real& Y, const Real& Z)
{
  const Real P = -(X + Y + Z) / 2, XYZ = X * Y * Z, PP = P * P;
  const Real E2 = X * Y + Z * (X + Y) - 3 * PP;
  const Real E3 = XYZ + 2 * P * (E2 + 2 * PP);
  const Real E4 = (2 * XYZ + P * (E2 + 3 * PP)) * P;
  return series_J(E2, E3, E4, Real(XYZ * PP));
}

// What a step adds to every argument: three products of roots, each rounded once and a half.
template <class Real>
Real shift_of(const Real& x, const Real& y, const Real& z)
{
  using std::sqrt;
  return sqrt(x * y) + (sqrt(y * z) + sqrt(z * x));
}

template <class Real>
Real largest(const Real& a, const Real& b, const Real& c)
{
  using std::abs, std::max;
  return max(Real(abs(a)), max(Real(abs(b)), Real(abs(c))));
}

// A step takes the mean to the mean of it and of what the step adds. Where the numbers are far apart that is formed as
// it stands. Nearer it is what the mean loses that is formed, an eighth of the squares of the differences of the roots:
// it is small, so are its errors, and the mean, kept as a sum, has none besides.
template <class Real>
Real moderate_F(Real x, Real y, Real z)
{
  using elementary::ordered_sum, elementary::sum_of, std::sqrt;
  const Real third = Real(1) / 3;
  Real mean = (x + y + z) * third;
  Real spread = largest(Real(mean - x), Real(mean - y), Real(mean - z));
  while(spread > 0.9 * mean)
  {
    const Real shift = shift_of(x, y, z);
    x = (x + shift) / 4;
    y = (y + shift) / 4;
    z = (z + shift) / 4;
    mean = (mean + shift) / 4;
    spread /= 4;
  }
  const auto two = sum_of(x, y), all = sum_of(two.value, z);
  mean = all.value * third;
  const auto thrice = ordered_sum(Real(2 * mean), mean);
  Real lost = (((all.value - thrice.value) - thrice.lost) + (all.lost + two.lost)) * third;
  Real dx = (mean - x) + lost, dy = (mean - y) + lost, dz = (mean - z) + lost;
  while(spread > near_enough_F<Real> * mean)
  {
    const Real rx = sqrt(x), ry = sqrt(y), rz = sqrt(z);
    const Real u = rx - ry, v = ry - rz, w = rz - rx;
    const auto next = ordered_sum(mean, Real(lost - (u * u + (v * v + w * w)) / 8));
    mean = next.value;
    lost = next.lost;
    dx /= 4;
    dy /= 4;
    dz /= 4;
    spread /= 4;
    x = mean - dx;
    y = mean - dy;
    z = mean - dz;
  }
  const Real inverse = 1 / mean, root = sqrt(inverse);
  const Real X = dx * inverse, Y = dy * inverse, Z = -X - Y;
  return root + root * (series_F(Real(X * Y - Z * Z), Real(X * Y * Z)) - inverse / 2 * lost);
}

exact::Fifty plain_D(exact::Fifty x, exact::Fifty y, exact::Fifty z)
{
  using exact::Fifty;
  Fifty mean = (x + y + 3 * z) / 5;
  const Fifty dx = mean - x, dy = mean - y;
  const Fifty spread = largest(dx, dy, Fifty(mean - z));
  Fifty quarter = 1, sum = 0;
  while(spread * quarter > near_enough_J<Fifty> * mean)
  {
    const Fifty shift = shift_of(x, y, z);
    sum += 3 * quarter / (sqrt(z) * (z + shift));
    x = (x + shift) / 4;
    y = (y + shift) / 4;
    z = (z + shift) / 4;
    mean = (mean + shift) / 4;
    quarter /= 4;
  }
  const Fifty scale = quarter / mean;
  return sum + quarter * (1 + series_D(Fifty(dx * scale), Fifty(dy * scale))) / (mean * sqrt(mean));
}

// The roots of four numbers, two to a register: each as it is alone.
template <class Real>
struct Roots
{
  Real x, y, z, p;

  Roots(const Real& x0, const Real& y0, const Real& z0, const Real& p0)
  {
    using std::sqrt;
    if constexpr(is_double<Real>)
    {
      double two[2] = {x0, y0}, others[2] = {z0, p0};
      for(double& number : two)
        number = std::sqrt(number);
      for(double& number : others)
        number = std::sqrt(number);
      x = two[0], y = two[1], z = others[0], p = others[1];
    }
    else
      x = sqrt(x0), y = sqrt(y0), z = sqrt(z0), p = sqrt(p0);
  }
};

// arctan √u over √u less one, or artanh √−u over √−u less one, for |u| ≤ 1/16: the first term that it lacks is below
// 2⁻⁵⁶.
template <class Real>
Real arc_excess(Real u)
{
  const auto of = [](int n) { return (n % 2 == 0 ? 1. : -1.) / (2 * n + 1); };
  const Real u2 = u * u, u4 = u2 * u2;
  const Real low = (of(1) + u * of(2)) + u2 * (of(3) + u * of(4));
  const Real middle = (of(5) + u * of(6)) + u2 * (of(7) + u * of(8));
  const Real high = (of(9) + u * of(10)) + u2 * (of(11) + u * of(12)) + u4 * of(13);
  return u * (low + u4 * (middle + u4 * high));
}

// Σ 2ⁿ arctan √δ g over √δ, or with the hyperbolic one where δ < 0, of `steps` falling g with their 1 + δgg.
template <class Real>
Real plain_arcs(const Real& delta, const Real* arm, const Real* norm, int steps)
{
  using std::abs, std::asinh, std::atan, std::atan2, std::atanh, std::sqrt;
  Real sum = 0, twice = 1;
  if constexpr(is_double<Real>)
    if(steps == 0 || abs(delta) * arm[0] * arm[0] <= 0.0625)
    {
      for(int n = 0; n < steps; ++n, twice *= 2)
        sum += twice * arm[n] * (1 + arc_excess(delta * arm[n] * arm[n]));
      return sum;
    }
  // From the last on all together, as the angle of Π (1 + i√δ g)^(2ⁿ) = a + i√δ b, until that might exceed half a
  // turn, or come near the infinite; the others each by itself.
  const Real root = sqrt(Real(abs(delta)));
  const Real limit = delta > 0 ? 3 : 0.5;
  Real a = 1, b = 0, reach = 0;
  int left = steps;
  for(; left > 0; --left)
  {
    const Real g = arm[left - 1];
    reach = g + 2 * reach;
    if(root * reach > limit)
      break;
    const Real aa = a * a - delta * b * b, ab = 2 * a * b;
    a = aa - delta * ab * g;
    b = ab + aa * g;
  }
  for(int n = 0; n < left; ++n, twice *= 2)
  {
    const Real t = root * arm[n];
    sum += twice * (delta > 0 ? Real(atan(t)) : Real(asinh(t / sqrt(norm[n])))) / root;
  }
  if(delta == 0)
    return sum + b;
  return sum + twice * (delta > 0 ? Real(atan2(Real(root * b), a)) : Real(atanh(root * b / a))) / root;
}

// In fifty digits, and where both integrals are wanted at once and quickly.
template <bool with_F, class Real>
First_and_third<Real> plain_J(Real x, Real y, Real z, Real p)
{
  using std::abs, std::max, std::sqrt;
  const Real mean_F = (x + y + z) / 3;
  const Real dxF = mean_F - x, dyF = mean_F - y;
  Real mean = (x + y + z + 2 * p) / 5;
  const Real dx = mean - x, dy = mean - y, dz = mean - z;
  const Real delta = (p - x) * (p - y) * (p - z);
  const Real spread = max(largest(dx, dy, dz), Real(abs(mean - p)));
  Real quarter = 1, eighth = 1;                        // 4⁻ⁿ and 8⁻ⁿ
  Real arm[most_steps<Real>], norm[most_steps<Real>];  // of the complex numbers 1 + i√δ g: g, and 1 + δgg
  int steps = 0;
  while(spread * quarter > near_enough_J<Real> * mean)
  {
    const Roots<Real> r(x, y, z, p);
    const Real shift = r.x * r.y + r.z * (r.x + r.y);
    const Real& w = r.p;
    const Real inverse = 1 / ((w + r.x) * (w + r.y) * (w + r.z));
    arm[steps] = eighth * inverse;
    norm[steps] = 2 * w * (p + shift) * inverse;
    ++steps;
    x = (x + shift) / 4;
    y = (y + shift) / 4;
    z = (z + shift) / 4;
    p = (p + shift) / 4;
    mean = (mean + shift) / 4;
    quarter /= 4;
    eighth /= 8;
  }
  const Real scale = quarter / mean;
  const Real series = 1 + series_of_four(Real(dx * scale), Real(dy * scale), Real(dz * scale));
  First_and_third<Real> result{
      Real(0), Real(6 * plain_arcs(delta, arm, norm, steps) + quarter * series / (mean * sqrt(mean)))};
  if constexpr(with_F)
  {
    const Real mean_now = (x + y + z) / 3;
    const Real part = quarter / mean_now;
    const Real U = dxF * part, V = dyF * part, W = -U - V;
    result.F = (1 + series_F(Real(U * V - W * W), Real(U * V * W))) / sqrt(mean_now);
  }
  return result;
}

// From here on numbers as sums of two doubles, a pair, without which the roundings of some six steps add up. Only the
// first digits of the second part matter. Of a step what is left is the rounding of the products of roots.
using elementary::ordered_sum, elementary::Pair, elementary::sum_of;

// Two doubles in one register.
typedef double Two __attribute__((vector_size(2 * sizeof(double))));

constexpr std::uint64_t upper_bits = 0xfffffffff8000000;
constexpr std::uint64_t twice_one =
    0x7fde623822fc16e6;  // less the bits of a number: about those of its inverse

// The upper 26 bits; that cut off is faster than rounded, but for single numbers.
ELEMENTARY_INLINE Two upper_part(Two x)
{
  return elementary::from_bits<Two>(elementary::bits_of(x) & upper_bits);
}

ELEMENTARY_INLINE Pair<Two> product(Two a, Two b)
{
  const Two whole = a * b, ah = upper_part(a), at = a - ah, bh = upper_part(b), bt = b - bh;
  return {whole, (ah * bh - whole) + (ah * bt + at * b)};
}
ELEMENTARY_INLINE Pair<double> product(double a, double b)
{
  return elementary::product_of(a, b);
}
template <class Real>
ELEMENTARY_INLINE Pair<Real> product(const Pair<Real>& a, const Pair<Real>& b)
{
  const Pair<Real> first = product(a.value, b.value);
  return {first.value, first.lost + (a.value * b.lost + a.lost * b.value)};
}

ELEMENTARY_INLINE Pair<double> quotient(const Pair<double>& a, const Pair<double>& b)
{
  const double q = a.value / b.value;
  const Pair<double> back = product(q, b.value);
  return {q, (((a.value - back.value) - back.lost) + (a.lost - q * b.lost)) / b.value};
}

ELEMENTARY_INLINE Pair<double> sum(const Pair<double>& a, const Pair<double>& b)
{
  const Pair<double> first = sum_of(a.value, b.value);
  return {first.value, first.lost + (a.lost + b.lost)};
}

ELEMENTARY_INLINE Two roots_of(Two x)
{
  double two[2] = {x[0], x[1]};
  for(double& number : two)
    number = std::sqrt(number);
  return Two{two[0], two[1]};
}

// 1/x to a sixtieth, x > 0; of 0 some large number. By the bits, then one step of Newton's.
ELEMENTARY_INLINE Two about_inverse(Two x)
{
  const Two guess = elementary::from_bits<Two>(twice_one - elementary::bits_of(x));
  return guess * (2 - x * guess);
}

// Four numbers on their way together, as pairs, and their roots.
struct Together
{
  Pair<Two> xy, zp;
  Pair<Two> root_xy{}, root_zp{};  // of the numbers before the last step
  double shift = 0;                // what it added to every one of them, before they were quartered

  Together(double x, double y, double z, double p) : xy{{x, y}, {0, 0}}, zp{{z, p}, {0, 0}} {}

  ELEMENTARY_INLINE void step()
  {
    const Two r = roots_of(xy.value), q = roots_of(zp.value);
    const Two rh = upper_part(r), rt = r - rh, qh = upper_part(q), qt = q - qh;
    root_xy = {r, (((xy.value - rh * rh) - (r + rh) * rt) + xy.lost) * (0.5 * about_inverse(r))};
    root_zp = {q, (((zp.value - qh * qh) - (q + qh) * qt) + zp.lost) * (0.5 * about_inverse(q))};
    const double x = r[0], y = r[1], z = q[0];
    const double a = x * y, b = y * z, c = z * x;
    const double of_roots =
        (root_xy.lost[0] * (y + z) + root_xy.lost[1] * (x + z)) + root_zp.lost[0] * (x + y);
    const Pair<double> two = sum_of(b, c), all = sum_of(a, two.value);
    const double all_lost = two.lost + (all.lost + of_roots);
    shift = all.value;
    const Two added{shift, shift}, lost{all_lost, all_lost};
    const Pair<Two> next = sum_of(xy.value, added), others = sum_of(zp.value, added);
    xy = {next.value * 0.25, (next.lost + (xy.lost + lost)) * 0.25};
    zp = {others.value * 0.25, (others.lost + (zp.lost + lost)) * 0.25};
  }
};

// The mean of the four, the last counted twice.
ELEMENTARY_INLINE Pair<double> mean_of_five(const Together& all)
{
  const Pair<double> two = sum_of(all.xy.value[0], all.xy.value[1]);
  const Pair<double> three = sum_of(all.zp.value[0], 2 * all.zp.value[1]),
                     five = sum_of(two.value, three.value);
  const double lost = (all.xy.lost[0] + all.xy.lost[1]) + (all.zp.lost[0] + 2 * all.zp.lost[1]);
  const double mean = 0.2 * five.value;
  const Pair<double> back = ordered_sum(4 * mean, mean);
  return {mean,
          0.2 * (((five.value - back.value) - back.lost) + ((five.lost + lost) + (two.lost + three.lost)))};
}

// The same where it counts: after two steps what is left is a small part of the integral, and the mean that was carried
// along is good enough.
ELEMENTARY_INLINE Pair<double> mean_now(const Together& all, double quarter, double mean)
{
  return quarter < 0x1p-3 ? Pair<double>{mean, 0} : mean_of_five(all);
}

// 1 + series over the power 3/2 of the mean, which is a pair.
ELEMENTARY_INLINE double over_power(const Pair<double>& mean, double series)
{
  const double inverse = 1 / mean.value, power = inverse * std::sqrt(inverse);
  const Pair<double> one = product(inverse, mean.value);
  return power + power * (series + 1.5 * (((1 - one.value) - one.lost) - inverse * mean.lost));
}

double moderate_D(double x, double y, double z)
{
  double mean = (x + y + 3 * z) / 5;
  const double dx = mean - x, dy = mean - y;
  const double spread = largest(dx, dy, mean - z);
  Together all(x, y, z, z);
  double quarter = 1;
  Pair<double> parts{0, 0};
  while(spread * quarter > near_enough_J<double> * mean)
  {
    all.step();
    const Pair<Two>&root = all.root_zp, &next = all.zp;
    const double inverse = 1 / (root.value[0] * next.value[0]), term = quarter * inverse;
    const double lost = root.value[0] * next.lost[0] + root.lost[0] * next.value[0];
    const Pair<double> now = sum_of(parts.value, term);
    parts = {now.value, parts.lost + (now.lost - term * (lost * inverse))};
    mean = (mean + all.shift) / 4;
    quarter /= 4;
  }
  const double scale = quarter / mean;
  const double rest = quarter * over_power(mean_now(all, quarter, mean), series_D(dx * scale, dy * scale));
  const Pair<double> result = sum_of(0.75 * parts.value, rest);
  return result.value + (result.lost + 0.75 * parts.lost);
}

// What the steps on the way to R_J leave to be summed, at most so many and one for the other half of a register.
struct Stages
{
  static constexpr int most = most_steps<double> + 1;
  double w[most], x[most], y[most], z[most];                      // the roots
  double w_lost[most], x_lost[most], y_lost[most], z_lost[most];  // and what they lack
  double p[most];                                                 // the last number after the step
  int steps = 0;

  ELEMENTARY_INLINE void put(const Together& now)
  {
    x[steps] = now.root_xy.value[0], x_lost[steps] = now.root_xy.lost[0];
    y[steps] = now.root_xy.value[1], y_lost[steps] = now.root_xy.lost[1];
    z[steps] = now.root_zp.value[0], z_lost[steps] = now.root_zp.lost[0];
    w[steps] = now.root_zp.value[1], w_lost[steps] = now.root_zp.lost[1];
    p[steps] = now.zp.value[1];
    ++steps;
  }
  void fill_up()
  {
    if(steps % 2 != 0)
    {
      w[steps] = x[steps] = y[steps] = z[steps] = 1;
      w_lost[steps] = x_lost[steps] = y_lost[steps] = z_lost[steps] = 0;
    }
  }
};

ELEMENTARY_INLINE Two two_at(const double* from)
{
  return Two{from[0], from[1]};
}
ELEMENTARY_INLINE void put_two(double* to, Two numbers)
{
  to[0] = numbers[0];
  to[1] = numbers[1];
}

// artanh t, 0 < t < 1, by half the logarithm of (1 + t)/(1 − t). Where t is near 1 that is (1 + t)²/(1 − tt), and `rest`
// the better 1 − tt.
Pair<double> area_of_tangent(const Pair<double>& t, double rest)
{
  const Pair<double> above = ordered_sum(1.0, t.value), below = ordered_sum(1.0, -t.value);
  if(below.value < 0x1p-4)
    return {0.5 * std::log(above.value * above.value / rest), 0};
  const Pair<double> ratio =
      quotient({above.value, above.lost + t.lost}, {below.value, below.lost - t.lost});
  return {0.5 * std::log(ratio.value), 0.5 * ratio.lost / ratio.value};
}

// Σ 2ⁿ arctan √δ gₙ over √δ, or with the hyperbolic one where δ < 0; gₙ = 8⁻ⁿ/((w + x)(w + y)(w + z)).
Pair<double> arcs(const Pair<double>& delta, Stages& s)
{
  constexpr int most = Stages::most;
  double product_of_sums[most], g[most], g_lost[most], u[most], term[most], term_lost[most];
  s.fill_up();
  Two eighth{1, 0x1p-3}, quarter{1, 0x1p-2};  // 8⁻ⁿ and 4⁻ⁿ
  for(int n = 0; n < s.steps; n += 2, eighth *= 0x1p-6, quarter *= 0x1p-4)
  {
    const Two w = two_at(s.w + n), w_lost = two_at(s.w_lost + n);
    const auto with = [&](const double* root, const double* lost) {
      const Pair<Two> whole = sum_of(w, two_at(root + n));
      return Pair<Two>{whole.value, whole.lost + (w_lost + two_at(lost + n))};
    };
    const Pair<Two> d = product(product(with(s.x, s.x_lost), with(s.y, s.y_lost)), with(s.z, s.z_lost));
    const Two inverse = 1 / d.value;
    const Pair<Two> one = product(inverse, d.value);
    const Two lost = (((1 - one.value) - one.lost) - inverse * d.lost) * inverse;
    const Two of_eighth = eighth * inverse, of_quarter = quarter * inverse;
    const Two square = delta.value * of_eighth * of_eighth;
    put_two(product_of_sums + n, d.value);
    put_two(g + n, of_eighth);
    put_two(g_lost + n, eighth * lost);
    put_two(u + n, square);
    put_two(term + n, of_quarter);
    put_two(term_lost + n, quarter * lost + of_quarter * arc_excess(square));
  }
  Pair<double> small{0, 0};
  int n = s.steps - 1;
  for(; n >= 0 && std::abs(u[n]) <= 0.0625; --n)
    small = sum(small, {term[n], term_lost[n]});
  if(n < 0)
    return small;
  const double sign = delta.value > 0 ? 1 : -1, size = std::abs(delta.value), r = std::sqrt(size);
  const Pair<double> square = product(r, r);
  const Pair<double> root{r, (((size - square.value) - square.lost) + sign * delta.lost) / (2 * r)};
  Pair<double> large{0, 0};
  for(double twice = std::ldexp(1.0, n); n >= 0; --n, twice /= 2)
  {
    const Pair<double> t = product(root, {g[n], g_lost[n]});
    const Pair<double> arc = delta.value > 0
                                 ? Pair<double>{std::atan(t.value), t.lost / (1 + t.value * t.value)}
                                 : area_of_tangent(t, 8 * s.w[n] * s.p[n] / product_of_sums[n]);
    large = sum(large, {twice * arc.value, twice * arc.lost});
  }
  return sum(small, quotient(large, root));
}

double moderate_J(double x, double y, double z, double p)
{
  double mean = (x + y + z + 2 * p) / 5;
  const double dx = mean - x, dy = mean - y, dz = mean - z;
  const double spread = std::max(largest(dx, dy, dz), std::abs(mean - p));
  Together all(x, y, z, p);
  Stages stages;
  double quarter = 1;
  while(spread * quarter > near_enough_J<double> * mean)
  {
    all.step();
    stages.put(all);
    mean = (mean + all.shift) / 4;
    quarter /= 4;
  }
  const double scale = quarter / mean;
  const double rest =
      quarter
      * over_power(mean_now(all, quarter, mean), series_of_four(dx * scale, dy * scale, dz * scale));
  if(stages.steps == 0)
    return rest;
  using elementary::difference_of;
  const Pair<double> delta =
      product(product(difference_of(p, x), difference_of(p, y)), difference_of(p, z));
  const Pair<double> sixth = arcs(delta, stages);
  const Pair<double> most = ordered_sum(4 * sixth.value, 2 * sixth.value),
                     result = sum_of(most.value, rest);
  return result.value + (result.lost + (most.lost + 6 * sixth.lost));
}

// A first step for arguments from both ends of the doubles. It brings them nearer to each other in the ratio of
// their square roots; what it returns is (x + shift) r r, with the r that leaves the largest near the square
// root of what it was.
struct Wide
{
  double r, x, y, z, p;

  Wide(double x0, double y0, double z0, double p0)
  {
    const double top = std::max(std::max(x0, y0), std::max(z0, p0));
    r = std::ldexp(1.0, -std::ilogb(top) / 4);
    const double rx = std::sqrt(x0) * r, ry = std::sqrt(y0) * r, rz = std::sqrt(z0) * r;
    const double shift = rx * (ry + rz) + ry * rz;
    x = x0 * r * r + shift;
    y = y0 * r * r + shift;
    z = z0 * r * r + shift;
    p = p0 * r * r + shift;
  }
};

// Arguments multiplied by a power of four, so that the largest is as large as is_moderate() allows.
struct Scaled
{
  double x, y, z, p;
  int half;       // the power of two in their roots
  bool moderate;  // whether all are now, but for zeros

  Scaled(double x0, double y0, double z0, double p0)
      : half((298 - std::ilogb(std::max(std::max(x0, y0), std::max(z0, p0)))) / 2)
  {
    x = std::ldexp(x0, 2 * half);
    y = std::ldexp(y0, 2 * half);
    z = std::ldexp(z0, 2 * half);
    p = std::ldexp(p0, 2 * half);
    const auto fits = [](double given, double now) { return given == 0 || is_moderate(now); };
    moderate = fits(x0, x) && fits(y0, y) && fits(z0, z) && fits(p0, p);
  }
};

double wide_F(double x, double y, double z)
{
  require_domain(x, y, z);
  const Scaled s(x, y, z, 0);
  if(s.moderate)
    return std::ldexp(moderate_F(s.x, s.y, s.z), s.half);
  const Wide next(x, y, z, 0);
  return 2 * next.r * R_F(next.x, next.y, next.z);
}

double wide_D(double x, double y, double z)
{
  require_domain(x, y, z);
  require_positive(z);
  const Scaled s(x, y, z, 0);
  if(s.moderate)
    return std::ldexp(moderate_D(s.x, s.y, s.z), 3 * s.half);
  const Wide next(x, y, z, 0);
  return 3 * next.r / std::sqrt(z) * (next.r / next.z)
         + 2 * next.r * (next.r * (next.r * R_D(next.x, next.y, next.z)));
}

double wide_J(double x, double y, double z, double p)
{
  require_domain(x, y, z);
  require_positive(p);
  if(p / far_beyond < double >> std::max(x, std::max(y, z)))
  {
    // 3/p (R_F − ½π/√p), and a part of it smaller than x/p, y/p and z/p
    const Pair<double> third = ordered_sum(R_F(x, y, z), -std::numbers::pi / 2 / std::sqrt(p));
    const Pair<double> whole = ordered_sum(2 * third.value, third.value);
    return whole.value / p + (whole.lost + 3 * third.lost) / p;
  }
  const Scaled s(x, y, z, p);
  if(s.moderate)
    return std::ldexp(moderate_J(s.x, s.y, s.z, s.p), 3 * s.half);
  const Wide next(x, y, z, p);
  const double w = std::sqrt(p), rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z);
  double d[] = {w + rx, w + ry, w + rz};
  std::sort(d, d + 3);
  const auto part = [w](double q, double root) { return (q / (w + root)) / (w + root); };
  const double e = part(p - x, rx) * part(p - y, ry) * part(p - z, rz);
  // √(1 + e), its factors ordered so that none is lost
  const double c = std::sqrt(2.0) * std::sqrt(w / d[0]) * (std::sqrt(next.p / d[2] / d[1]) / next.r);
  const double root = std::sqrt(std::abs(e));
  const double arc = e == 0 ? 1 : (e > 0 ? std::atan(root) : std::asinh(root / c)) / root;
  return 6 * arc / d[2] / d[0] / d[1]
         + 2 * next.r * (next.r * (next.r * R_J(next.x, next.y, next.z, next.p)));
}

}  // namespace

template <class Real>
Real R_C(const Real& x, const Real& y)
{
  using std::asinh, std::atan, std::isfinite, std::log, std::sqrt;
  require_positive(y);
  if(!(x >= 0) || !isfinite(x))
    throw std::domain_error("R_C: the first argument must be finite and not negative");
  if(x == y)
    return 1 / sqrt(x);
  if(x < y)
    return atan(sqrt(y - x) / sqrt(x)) / sqrt(y - x);
  const Real ratio = sqrt(x - y) / sqrt(y);
  if(!isfinite(ratio))  // over 10³⁰⁸: the logarithms have nothing to cancel
    return (log(x) - log(y) + 2 * log(Real(2))) / (2 * sqrt(x));
  return asinh(ratio) / sqrt(x - y);
}

template <class Real>
Real R_F(const Real& x, const Real& y, const Real& z)
{
  if constexpr(is_double<Real>)
  {
    if(!is_moderate(x) || !is_moderate(y) || !is_moderate(z))
      return wide_F(x, y, z);
  }
  else
    require_domain(x, y, z);
  return moderate_F(x, y, z);
}

template <class Real>
Real R_D(const Real& x, const Real& y, const Real& z)
{
  if constexpr(is_double<Real>)
  {
    if(!is_moderate(x) || !is_moderate(y) || !is_moderate(z))
      return wide_D(x, y, z);
    return moderate_D(x, y, z);
  }
  else
  {
    require_domain(x, y, z);
    require_positive(z);
    return plain_D(x, y, z);
  }
}

namespace
{

// Whether R_J needs no care for the range of its arguments.
bool is_moderate(double x, double y, double z, double p)
{
  return is_moderate(x) && is_moderate(y) && is_moderate(z) && is_moderate(p)
         && !(p / far_beyond < double >> z);
}

template <bool with_F>
First_and_third<exact::Fifty> any_J(const exact::Fifty& x, const exact::Fifty& y, const exact::Fifty& z,
                                    const exact::Fifty& p)
{
  require_domain(x, y, z);
  require_positive(p);
  if(p / far_beyond < exact::Fifty >> std::max(x, std::max(y, z)))
  {
    const exact::Fifty F = moderate_F(x, y, z);
    return {F, 3 * F / p};
  }
  return plain_J<with_F>(x, y, z, p);
}

}  // namespace

template <class Real>
Real R_J(const Real& x, const Real& y, const Real& z, const Real& p)
{
  if constexpr(is_double<Real>)
    return is_moderate(x, y, z, p) ? moderate_J(x, y, z, p) : wide_J(x, y, z, p);
  else
    return any_J<false>(x, y, z, p).J;
}

template <class Real>
First_and_third<Real> R_F_and_J(const Real& x, const Real& y, const Real& z, const Real& p)
{
  if constexpr(is_double<Real>)
    return is_moderate(x, y, z, p) ? plain_J<true>(x, y, z, p)
                                   : First_and_third<double>{R_F(x, y, z), wide_J(x, y, z, p)};
  else
    return any_J<true>(x, y, z, p);
}

namespace
{

constexpr double none = std::numeric_limits<double>::quiet_NaN();

template <class Function, class... Spans>
void of_each(Function f, std::span<double> out, Spans... in)
{
  if(((in.size() != out.size()) || ...))
    throw std::invalid_argument("Carlson's integrals: the arrays differ in length");
  for(std::size_t i = 0; i < out.size(); ++i)
  {
    try
    {
      out[i] = f(in[i]...);
    }
    catch(const std::domain_error&)
    {
      out[i] = none;
    }
  }
}

}  // namespace

void R_C(std::span<const double> x, std::span<const double> y, std::span<double> out)
{
  of_each([](const double& a, const double& b) { return R_C(a, b); }, out, x, y);
}

void R_F(std::span<const double> x, std::span<const double> y, std::span<const double> z,
         std::span<double> out)
{
  of_each([](const double& a, const double& b, const double& c) { return R_F(a, b, c); }, out, x, y, z);
}

void R_D(std::span<const double> x, std::span<const double> y, std::span<const double> z,
         std::span<double> out)
{
  of_each([](const double& a, const double& b, const double& c) { return R_D(a, b, c); }, out, x, y, z);
}

void R_J(std::span<const double> x, std::span<const double> y, std::span<const double> z,
         std::span<const double> p, std::span<double> out)
{
  of_each(
      [](const double& a, const double& b, const double& c, const double& d) { return R_J(a, b, c, d); },
      out, x, y, z, p);
}

template double R_C(const double&, const double&);
template exact::Fifty R_C(const exact::Fifty&, const exact::Fifty&);
template double R_F(const double&, const double&, const double&);
template exact::Fifty R_F(const exact::Fifty&, const exact::Fifty&, const exact::Fifty&);
template double R_D(const double&, const double&, const double&);
template exact::Fifty R_D(const exact::Fifty&, const exact::Fifty&, const exact::Fifty&);
template double R_J(const double&, const double&, const double&, const double&);
template exact::Fifty R_J(const exact::Fifty&, const exact::Fifty&, const exact::Fifty&,
                          const exact::Fifty&);
template First_and_third<double> R_F_and_J(const double&, const double&, const double&, const double&);
template First_and_third<exact::Fifty> R_F_and_J(const exact::Fifty&, const exact::Fifty&,
                                                 const exact::Fifty&, const exact::Fifty&);

}  // namespace elliptic
