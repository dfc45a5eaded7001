/// @file
/// The real roots of a polynomial in an interval.
#pragma once

#include <vector>

namespace globe
{

/// Halvings after which a root is known: of a double they lead to the smallest there is, of fifty digits, which
/// have no smallest, as far as anyone needs.
inline constexpr int most_halvings = 1200;

/// The value of Σ p[n] xⁿ, of any row of numbers p.
template <class Coefficients, class Real>
Real value_of(const Coefficients& p, const Real& x)
{
  Real sum = 0;
  for(std::size_t n = p.size(); n-- > 0;)
    sum = sum * x + p[n];
  return sum;
}

/// The coefficients of the derivative.
template <class Real>
std::vector<Real> derivative_of(const std::vector<Real>& p)
{
  std::vector<Real> q;
  for(std::size_t n = 1; n < p.size(); ++n)
    q.push_back(p[n] * Real(static_cast<double>(n)));
  return q;
}

/// The coefficients of the product.
template <class Real>
std::vector<Real> product_of(const std::vector<Real>& p, const std::vector<Real>& q)
{
  std::vector<Real> r(p.size() + q.size() - 1, Real(0));
  for(std::size_t i = 0; i < p.size(); ++i)
    for(std::size_t j = 0; j < q.size(); ++j)
      r[i + j] += p[i] * q[j];
  return r;
}

/// The roots in [low, high] at which the polynomial changes its sign, in rising order: between the roots of the
/// derivative, which are found in the same way, by halving to the last place.
template <class Real>
std::vector<Real> roots_between(const std::vector<Real>& p, const Real& low, const Real& high)
{
  std::vector<Real> roots;
  if(p.size() < 2)
    return roots;
  std::vector<Real> ends = roots_between(derivative_of(p), low, high);
  ends.insert(ends.begin(), low);
  ends.push_back(high);
  for(std::size_t i = 1; i < ends.size(); ++i)
  {
    Real a = ends[i - 1], b = ends[i];
    const bool rising = value_of(p, b) > 0;
    if((value_of(p, a) > 0) == rising)
      continue;
    Real middle = (a + b) / 2;
    for(int n = 0; n < most_halvings && a < middle && middle < b; ++n, middle = (a + b) / 2)
      ((value_of(p, middle) > 0) == rising ? b : a) = middle;
    roots.push_back(b);
  }
  return roots;
}

}  // namespace globe
