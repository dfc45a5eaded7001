/// @file
/// What most sections of the pendulum's chapter share: Euler's series for the time of a swing, and the
/// mean that judges it.
#pragma once

#include <cmath>

/// Euler's own formulae for the pendulum, each in the section where he finds it, here where several
/// sections use them.
namespace pendulum
{

// [series]
/// The first `terms` terms of T/Θ = 1 + (1²/2²)cc + (1²3²/2²4²)c⁴ + ..., added from the first on (§§8,
/// 9, 11). Domain: 0 ≤ cc ≤ 1, terms ≥ 0. Real: double or exact::Fifty. In double, n terms lose at most
/// n/2 ulp to rounding.
template <class Real>
Real series(Real cc, int terms)
{
  Real sum = 0;
  Real term = 1;
  for(int n = 0; n < terms; ++n)
  {
    sum += term;
    const Real a = Real(2 * n + 1) / Real(2 * n + 2);
    term *= a * a * cc;
  }
  return sum;
}
// [series]

// [ratio_by_mean]
/// T/Θ = 1/M(1, sin ½η), M the arithmetic-geometric mean of Gauss and η = 180° − ζ. Domain: 0 < η ≤ π,
/// radians. Real: double (to 4 ulp) or exact::Fifty (to 48 digits), where it is the judge of the
/// others.
template <class Real>
Real ratio_by_mean(Real eta)
{
  using std::sin, std::sqrt;
  Real a = 1;
  Real g = sin(eta / 2);
  for(Real gap = 2; a - g < gap && a > g;)  // until rounding stops it
  {
    gap = a - g;
    const Real mean = (a + g) / 2;
    g = sqrt(a * g);
    a = mean;
  }
  return 1 / a;
}
// [ratio_by_mean]

}  // namespace pendulum
