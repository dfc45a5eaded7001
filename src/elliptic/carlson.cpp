#include "elliptic/carlson.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

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

// Where p exceeds the others so far, t + p is p as long as it matters.
template <class Real>
constexpr double far_beyond = is_double<Real> ? 0x1p116 : 0x1p400;
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
  return x >= 0x1p-200 && x <= 0x1p200;
}
bool is_moderate_or_zero(double x)
{
  return is_moderate(x) || x == 0;
}

// Σ (½)ₘ/m! (−E₂ + E₃)ᵐ, each term of the degree n over 2n + 1, to the degree 11.
template <class Real>
Real series_F(const Real& E2, const Real& E3)
{
  const auto of = [](int n, int d) { return Real(n) / d; };
  const Real p0 =
      1 + E2 * (of(-1, 10) + E2 * (of(1, 24) + E2 * (of(-5, 208) + E2 * (of(35, 2176) - E2 * of(3, 256)))));
  const Real p1 =
      of(1, 14) + E2 * (of(-3, 44) + E2 * (of(1, 16) + E2 * (of(-35, 608) + E2 * of(315, 5888))));
  const Real p2 = of(3, 104) + E2 * (of(-15, 272) + E2 * of(5, 64));
  const Real p3 = of(5, 304) - E2 * of(35, 736);
  return p0 + E3 * (p1 + E3 * (p2 + E3 * p3));
}

// The same of five numbers, with 3/(2n + 3), to the degree 9.
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
  return 1 + (p2 + E3 * p3 + E4 * p4 + E5 * p5);
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

template <class Real>
Real moderate_F(Real x, Real y, Real z)
{
  using std::sqrt;
  Real mean = (x + y + z) / 3;
  const Real dx = mean - x, dy = mean - y;
  const Real spread = largest(dx, dy, Real(mean - z));
  Real quarter = 1;  // 4⁻ⁿ
  while(spread * quarter > near_enough_F<Real> * mean)
  {
    const Real shift = shift_of(x, y, z);
    x = (x + shift) / 4;
    y = (y + shift) / 4;
    z = (z + shift) / 4;
    mean = (mean + shift) / 4;
    quarter /= 4;
  }
  const Real scale = quarter / mean;
  const Real X = dx * scale, Y = dy * scale, Z = -X - Y;
  return series_F(Real(X * Y - Z * Z), Real(X * Y * Z)) / sqrt(mean);
}

template <class Real>
Real moderate_D(Real x, Real y, Real z)
{
  using std::sqrt;
  Real mean = (x + y + 3 * z) / 5;
  const Real dx = mean - x, dy = mean - y;
  const Real spread = largest(dx, dy, Real(mean - z));
  Real quarter = 1, sum = 0;
  while(spread * quarter > near_enough_J<Real> * mean)
  {
    const Real shift = shift_of(x, y, z);
    sum += 3 * quarter / (sqrt(z) * (z + shift));
    x = (x + shift) / 4;
    y = (y + shift) / 4;
    z = (z + shift) / 4;
    mean = (mean + shift) / 4;
    quarter /= 4;
  }
  const Real scale = quarter / mean;
  const Real X = dx * scale, Y = dy * scale, Z = -(X + Y) / 3;
  const Real XY = X * Y, ZZ = Z * Z;
  const Real series =
      series_J(Real(XY - 6 * ZZ), Real((3 * XY - 8 * ZZ) * Z), Real(3 * (XY - ZZ) * ZZ), Real(XY * ZZ * Z));
  return sum + quarter * series / (mean * sqrt(mean));
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

// arctan √u over √u, or artanh √−u over √−u, for |u| ≤ 1/16: the first term that it lacks is below 2⁻⁵⁶.
double arc_over_tangent(double u)
{
  const auto of = [](int n) { return (n % 2 == 0 ? 1. : -1.) / (2 * n + 1); };
  const double u2 = u * u, u4 = u2 * u2;
  const double low = (of(1) + u * of(2)) + u2 * (of(3) + u * of(4));
  const double middle = (of(5) + u * of(6)) + u2 * (of(7) + u * of(8));
  const double high = (of(9) + u * of(10)) + u2 * (of(11) + u * of(12)) + u4 * of(13);
  return 1 + u * (low + u4 * (middle + u4 * high));
}

// Σ 2ⁿ arctan √δ g over √δ, or with the hyperbolic one where δ < 0, of `steps` falling g with their 1 + δgg.
template <class Real>
Real arcs(const Real& delta, const Real* arm, const Real* norm, int steps)
{
  using std::abs, std::asinh, std::atan, std::atan2, std::atanh, std::sqrt;
  Real sum = 0, twice = 1;
  if constexpr(is_double<Real>)
    if(steps == 0 || abs(delta) * arm[0] * arm[0] <= 0.0625)
    {
      for(int n = 0; n < steps; ++n, twice *= 2)
        sum += twice * arm[n] * arc_over_tangent(delta * arm[n] * arm[n]);
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

// R_F too, where it is wanted.
template <bool with_F, class Real>
First_and_third<Real> moderate_J(Real x, Real y, Real z, Real p)
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
    // by products of roots where one bringing together serves both integrals and is to be quick
    const Real shift = with_F ? Real(r.x * r.y + r.z * (r.x + r.y)) : shift_of(x, y, z);
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
  const Real X = dx * scale, Y = dy * scale, Z = dz * scale, P = -(X + Y + Z) / 2;
  const Real XYZ = X * Y * Z, PP = P * P;
  const Real E2 = X * Y + Z * (X + Y) - 3 * PP;
  const Real E3 = XYZ + 2 * P * (E2 + 2 * PP);
  const Real E4 = (2 * XYZ + P * (E2 + 3 * PP)) * P;
  const Real series = series_J(E2, E3, E4, Real(XYZ * PP));
  First_and_third<Real> result{
      Real(0), Real(6 * arcs(delta, arm, norm, steps) + quarter * series / (mean * sqrt(mean)))};
  if constexpr(with_F)
  {
    const Real mean_now = (x + y + z) / 3;
    const Real part = quarter / mean_now;
    const Real U = dxF * part, V = dyF * part, W = -U - V;
    result.F = series_F(Real(U * V - W * W), Real(U * V * W)) / sqrt(mean_now);
  }
  return result;
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

double wide_F(double x, double y, double z)
{
  require_domain(x, y, z);
  if(is_moderate_or_zero(x) && is_moderate_or_zero(y) && is_moderate_or_zero(z))
    return moderate_F(x, y, z);
  const Wide next(x, y, z, 0);
  return 2 * next.r * R_F(next.x, next.y, next.z);
}

double wide_D(double x, double y, double z)
{
  require_domain(x, y, z);
  require_positive(z);
  if(is_moderate_or_zero(x) && is_moderate_or_zero(y) && is_moderate(z))
    return moderate_D(x, y, z);
  const Wide next(x, y, z, 0);
  return 3 * next.r / std::sqrt(z) * (next.r / next.z)
         + 2 * next.r * (next.r * (next.r * R_D(next.x, next.y, next.z)));
}

First_and_third<double> wide_J(double x, double y, double z, double p)
{
  require_domain(x, y, z);
  require_positive(p);
  const double top = std::max(x, std::max(y, z));
  if(p / far_beyond < double >> top)
  {
    const double F = R_F(x, y, z);
    return {F, 3 * F / p};
  }
  if(is_moderate_or_zero(x) && is_moderate_or_zero(y) && is_moderate_or_zero(z) && is_moderate(p))
    return moderate_J<true>(x, y, z, p);
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
  const First_and_third<double> rest = R_F_and_J(next.x, next.y, next.z, next.p);
  return {2 * next.r * rest.F, 6 * arc / d[2] / d[0] / d[1] + 2 * next.r * (next.r * (next.r * rest.J))};
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
  }
  else
  {
    require_domain(x, y, z);
    require_positive(z);
  }
  return moderate_D(x, y, z);
}

namespace
{

template <bool with_F, class Real>
First_and_third<Real> any_J(const Real& x, const Real& y, const Real& z, const Real& p)
{
  if constexpr(is_double<Real>)
  {
    if(!is_moderate(x) || !is_moderate(y) || !is_moderate(z) || !is_moderate(p)
       || p / far_beyond < double >> z)
      return wide_J(x, y, z, p);
  }
  else
  {
    require_domain(x, y, z);
    require_positive(p);
    if(p / far_beyond < Real >> std::max(x, std::max(y, z)))
    {
      const Real F = moderate_F(x, y, z);
      return {F, 3 * F / p};
    }
  }
  return moderate_J<with_F>(x, y, z, p);
}

}  // namespace

template <class Real>
Real R_J(const Real& x, const Real& y, const Real& z, const Real& p)
{
  return any_J<false>(x, y, z, p).J;
}

template <class Real>
First_and_third<Real> R_F_and_J(const Real& x, const Real& y, const Real& z, const Real& p)
{
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
