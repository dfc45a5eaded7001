#include "tautochrone/series.hpp"

#include <stdexcept>

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

// With u = κ + rr and κ = kk/aa, a = 1, the equation is uu − (1 + κ) r u cos φ − κ (1 + κ) (dr/dφ) sin φ = 0.
// Its order n is cos³φ rₙ and what the earlier coefficients make.
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

}  // namespace tautochrone
