#include "globe/time.hpp"

#include <cmath>
#include <stdexcept>

#include "elementary/processor.hpp"
#include "elliptic/carlson.hpp"
#include "globe/gauss.hpp"

namespace globe
{

namespace
{

// ∫ of (3)'s integrand, 4 r r zz/(1 + √(1 + 4 r r zz(1 − zz))), from 0 to v by Gauss's rule with n nodes. They lie
// in blocks of eight, which the processor takes at once where it can; the sums are the same everywhere.
using Rest = double (*)(double r, double v, int n);

constexpr int lanes = 8;

struct Nodes
{
  double x[32], weight[32];

  explicit Nodes(std::size_t n)
  {
    const Gauss rule(static_cast<int>(n));
    for(std::size_t i = 0; i < n; ++i)
    {
      x[i] = (1 + rule.nodes()[i].x) / 2;
      weight[i] = rule.nodes()[i].weight / 2;
    }
  }
};

[[gnu::always_inline]] inline double rest_in_blocks(double r, double v, int n)
{
  static const Nodes sixteen(16), thirty_two(32);
  const Nodes& nodes = n == 16 ? sixteen : thirty_two;
  const double q = 4 * r * r;
  double sum[lanes] = {};
  for(int start = 0; start < n; start += lanes)
    for(int i = 0; i < lanes; ++i)
    {
      const double z = v * nodes.x[start + i];
      const double zz = z * z;
      sum[i] += nodes.weight[start + i] * zz / (1 + std::sqrt(1 + q * zz * (1 - zz)));
    }
  const double half = (sum[0] + sum[4]) + (sum[1] + sum[5]), other = (sum[2] + sum[6]) + (sum[3] + sum[7]);
  return q * v * (half + other);
}

double plain_rest(double r, double v, int n)
{
  return rest_in_blocks(r, v, n);
}

#if defined(__x86_64__)
#if defined(__clang__)  // which takes the whole width without being asked
#define GLOBE_AVX512 "avx512f"
#else
#define GLOBE_AVX512 "avx512f,prefer-vector-width=512"
#endif
[[gnu::target("avx2")]] double avx2_rest(double r, double v, int n)
{
  return rest_in_blocks(r, v, n);
}
[[gnu::target(GLOBE_AVX512)]] double avx512_rest(double r, double v, int n)
{
  return rest_in_blocks(r, v, n);
}

constexpr Rest variants[] = {plain_rest, avx2_rest, avx512_rest};
#else
constexpr Rest variants[] = {plain_rest};
#endif

template <class Real>
void require_way_to_top(const Real& c, const Real& k, const Real& omega, const Real& v)
{
  if(!(c >= 0 && k > 0 && c <= 1e6 * k && omega > 0 && v >= 0 && omega < 2))
    throw std::domain_error("the time to the top needs k > 0, 0 ≤ c ≤ 10⁶ k and 0 < ω ≤ 90°");
}

template <class Real>
Real time_by_carlson(const Real& c, const Real& k, const Real& omega)
{
  using elliptic::R_D, elliptic::R_J;
  using std::asinh, std::cos, std::hypot, std::sin, std::sqrt;
  const Real v = cos(omega);
  require_way_to_top(c, k, omega, v);
  // [time]
  const Real r = c / k;
  const Real s = sin(omega);
  const Real q = 1 + 4 * r * r * v * v;
  const Real B = 2 * r * (hypot(r, Real(1)) + r);
  const Real X = (1 + B * s * s) / (1 + B);
  const Real Z = 1 + B * v * v;
  const Real bounded = R_J(Real(1), X, Z, q) + R_D(X, Z, Real(1));
  return k * (asinh(v / (s * sqrt(q))) + 4 * r * r * v * v * v / 3 * bounded);
  // [time]
}

}  // namespace

double separatrix_time_by_carlson(double c, double k, double omega)
{
  return time_by_carlson(c, k, omega);
}

template <>
double separatrix_time(const double& c, const double& k, const double& omega)
{
  const double r = c / k;
  if(!(r <= 1.2))
    return time_by_carlson(c, k, omega);
  const double v = std::cos(omega);
  require_way_to_top(c, k, omega, v);
  static const Rest rest = variants[elementary::variants_that_run() - 1];
  return k * (std::asinh(v / std::sin(omega)) + rest(r, v, r <= 0.5 ? 16 : 32));
}

template <>
exact::Fifty separatrix_time(const exact::Fifty& c, const exact::Fifty& k, const exact::Fifty& omega)
{
  return time_by_carlson(c, k, omega);
}

void separatrix_time(double c, double k, std::span<const double> omega, std::span<double> tau)
{
  if(omega.size() != tau.size())
    throw std::invalid_argument("the arrays differ in length");
  for(std::size_t i = 0; i < tau.size(); ++i)
    tau[i] = separatrix_time(c, k, omega[i]);
}

double separatrix_angle(double c, double k, double tau)
{
  if(!(c >= 0 && k > 0 && c <= 1e6 * k && tau >= 0 && tau < 690 * k))
    throw std::domain_error("the way to the top needs k > 0, 0 ≤ c ≤ 10⁶ k and a time from 0 to 690 k");
  const auto angle = [](double x) { return 2 * std::atan(std::exp(-x)); };
  double below = tau / std::hypot(k, c), above = tau / k;
  for(;;)
  {
    const double x = (below + above) / 2;
    if(!(below < x && x < above))
      return angle(x);
    (separatrix_time(c, k, angle(x)) > tau ? above : below) = x;
  }
}

}  // namespace globe
