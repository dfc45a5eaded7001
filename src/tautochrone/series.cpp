#include "tautochrone/series.hpp"

#include <array>
#include <stdexcept>
#include <string>

namespace tautochrone
{
namespace
{

// The coefficient n of the product of two series of which the first n + 1 coefficients are known.
template <class Coefficient>
Coefficient product(const std::vector<Coefficient>& a, const std::vector<Coefficient>& b, int n)
{
  Coefficient sum(0);
  for(int i = 0; i <= n; ++i)
    sum += a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(n - i)];
  return sum;
}

}  // namespace

// With u = κ + rr and κ = kk/aa, a = 1, the equation is uu − (1 + κ) r u cos φ − κ (1 + κ) (dr/dφ) sin φ
// = 0. Its order n is cos³φ rₙ and what the earlier coefficients make.
template <class Number>
std::vector<exact::Laurent<Number>> corrections(int last)
{
  using Polynomial = exact::Laurent<Number>;
  if(last < 0)
    throw std::domain_error("the expansion has no coefficients before r₀");
  const Polynomial c(Number(1), 1);
  std::vector<Polynomial> r = {c};
  std::vector<Polynomial> u = {c * c};
  Polynomial dr_sin;  // of the order n - 1
  // [corrections]
  for(int n = 1; n <= last; ++n)
  {
    r.emplace_back(0);
    u.push_back(product(r, r, n) + (n == 1 ? 1 : 0));
    const Polynomial before = dr_sin;
    dr_sin = slope_times_sine(r[static_cast<std::size_t>(n - 1)]);
    const Polynomial ru = product(r, u, n) + product(r, u, n - 1);
    const Polynomial rest = product(u, u, n) - c * ru - dr_sin - before;
    r.back() = -rest / (c * c * c);
    u.back() += 2 * c * r.back();
  }
  // [corrections]
  return r;
}

template std::vector<exact::Laurent<exact::Rational>> corrections(int last);
template std::vector<exact::Laurent<exact::Fifty>> corrections(int last);

exact::Laurent<exact::Fifty> truncated(int order, const exact::Fifty& k)
{
  exact::Laurent<exact::Fifty> sum;
  exact::Fifty power = 1;
  for(const auto& coefficient : corrections<exact::Fifty>(order))
  {
    sum += power * coefficient;
    power *= k * k;
  }
  return sum;
}

exact::Laurent<double> truncated_in_double(int order, const exact::Fifty& k)
{
  const exact::Laurent<exact::Fifty> exactly = truncated(order, k);
  exact::Laurent<double> rounded;
  for(int n = exactly.lowest(); n <= exactly.highest(); ++n)
    rounded += exact::Laurent<double>(static_cast<double>(exactly[n]), n);
  return rounded;
}

namespace
{

// −rₙ/cos φ in powers of t = tan²φ, for n = 0 to last_power; that of n = 0 is −1.
const std::vector<std::vector<double>>& in_tangents()
{
  static const std::vector<std::vector<double>> polynomials = [] {
    std::vector<std::vector<double>> made;
    for(const auto& r_n : corrections<exact::Fifty>(last_power))
    {
      // Horner's rule by powers of 1/cos²φ = 1 + t; the highest power of cos φ is at most the first, and
      // r₁ alone has it, with 1/cos³φ: then the polynomial is divided by nothing.
      std::vector<exact::Fifty> sum = {0};
      for(int power = r_n.lowest(); power <= 1; power += 2)
      {
        std::vector<exact::Fifty> next(sum.size() + 1);
        for(std::size_t i = 0; i < sum.size(); ++i)
        {
          next[i] += sum[i];
          next[i + 1] += sum[i];
        }
        sum = std::move(next);
        sum[0] -= r_n[power];
      }
      made.emplace_back();
      for(const exact::Fifty& coefficient : sum)
        made.back().push_back(static_cast<double>(coefficient));
    }
    return made;
  }();
  return polynomials;
}

// A polynomial and its derivative.
std::pair<double, double> with_slope(const std::vector<double>& coefficients, double t)
{
  double value = 0, slope = 0;
  for(auto c = coefficients.rbegin(); c != coefficients.rend(); ++c)
  {
    slope = slope * t + value;
    value = value * t + *c;
  }
  return {value, slope};
}

void require_order(int order)
{
  if(order < 0 || order > last_power)
    throw std::domain_error("the order must be 0 to " + std::to_string(last_power) + ", not "
                            + std::to_string(order));
}

}  // namespace

std::vector<double> terms(double k, double phi, int last)
{
  require_order(last);
  if(!(k >= 0 && std::abs(phi) < 1.5707963267948968))
    throw std::domain_error("the series needs k ≥ 0 and |φ| < ½π");
  const double c = std::cos(phi), tangent = std::sin(phi) / c;
  std::vector<double> result;
  double power = 1;
  for(int n = 0; n <= last; ++n)
  {
    result.push_back(-c * power
                     * with_slope(in_tangents()[static_cast<std::size_t>(n)], tangent * tangent).first);
    power *= k * k;
  }
  return result;
}

double radius_by_series(int order, double k, double phi)
{
  double sum = 0;
  for(const double term : terms(k, phi, order))
    sum += term;
  return sum;
}

double end_of_truncated(int order, double k)
{
  require_order(order);
  if(!(k == 0 || (k >= 1e-10 && k <= 1e10)))
    throw std::domain_error("the end needs k/a from 1e-10 to 1e10, or zero");
  if(order == 0 || k == 0)
    return std::acos(0.0);
  const double kk = k * k;
  double t = 1 / (kk + std::sqrt(kk * (1 + kk)));  // kk t (2 + t) = 1; with more terms t is less
  for(double before = 2 * t; order > 1 && t < before;)
  {
    double value = -1, slope = 0, power = kk;
    for(int n = 1; n <= order; ++n)
    {
      const auto [now, now_slope] = with_slope(in_tangents()[static_cast<std::size_t>(n)], t);
      value += power * now;
      slope += power * now_slope;
      power *= kk;
    }
    before = t;
    t -= value / slope;  // from above: the sum is convex
  }
  return std::atan(std::sqrt(t));
}

}  // namespace tautochrone
