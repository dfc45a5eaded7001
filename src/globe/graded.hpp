/// @file
/// Integrals over an angle from 0 to θ, of integrands whose singularities lie near its ends, not on them: Gauss's
/// rule on panels that grow away from each end as 1, 2½, 6, ...
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "exact/quadrature.hpp"
#include "globe/gauss.hpp"

namespace globe
{

namespace graded_panels
{

/// ∫ f from a to b: sixteen nodes in double, and in fifty digits to forty of them.
template <class Real, class Function>
Real panel(const Function& f, const Real& a, const Real& b)
{
  if constexpr(std::is_same_v<Real, double>)
  {
    static const Gauss rule(16);
    return rule(f, a, b);
  }
  else
    return exact::integrate(f, a, b).value;
}

/// ∫ f from a to b, 0 ≤ a, f having singularities at ±i near, or farther.
template <class Real, class Function>
Real from_end(const Function& f, Real a, const Real& b, const Real& near)
{
  using std::sqrt;
  Real sum = 0;
  while(a < b)
  {
    const Real length = Real(1.5) * sqrt(a * a + near * near);
    const Real next = b - a < Real(1.25) * length ? b : Real(a + length);
    sum += panel(f, a, next);
    a = next;
  }
  return sum;
}

}  // namespace graded_panels

/// ∫ f(sin θ, cos θ) dθ from 0 up to the θ whose sine and cosine are given, both ≥ 0. `f` is singular no nearer
/// than at ±i at_0, and at ½π ± i at_right, both of them above 0. In double to the last digits of the sum; f is
/// called with sines and cosines that are both exact to rounding.
template <class Real, class Function>
Real integrate_over_angle(const Function& f, const Real& sine, const Real& cosine, const Real& at_0,
                          const Real& at_right)
{
  using std::min, std::sqrt;
  // By the tangent of half the angle, or of half of what it lacks of a right one: no sine need be taken.
  const auto by_tangent = [&f](bool from_right) {
    return [&f, from_right](const Real& t) {
      const Real whole = 1 + t * t;
      const Real small = 2 * t / whole, large = (1 - t) * (1 + t) / whole;
      return Real(2 * (from_right ? f(large, small) : f(small, large)) / whole);
    };
  };
  const Real middle = sqrt(Real(2)) - 1;
  const Real below = min(Real(sine / (1 + cosine)), middle);
  Real sum = graded_panels::from_end(by_tangent(false), Real(0), below, min(Real(at_0 / 2), Real(1)));
  if(sine > cosine)
    sum += graded_panels::from_end(by_tangent(true), Real(cosine / (1 + sine)), middle,
                                   min(Real(at_right / 2), Real(1)));
  return sum;
}

}  // namespace globe
