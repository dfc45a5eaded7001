/// @file
/// Euler's time of a swing that falls little short of the whole circle (§§29–36).
#pragma once

#include <cmath>

#include "pendulum/series.hpp"

namespace pendulum
{

// [three_members]
/// The three members of Euler's formula for the quarter motion t√(2g)/√b, the angle α = ½η being small
/// (§29).
template <class Real>
struct Members
{
  Real factor;  ///< 1 + ¼ sin²α + ..., the series of a swing of amplitude η
  Real first;   ///< l cot ½α times the factor
  Real second;  ///< cos α l 2
  Real third;   ///< ¾ cos α sin²α l 2

  Real sum() const { return first + second + third; }  ///< all three, the quarter motion
};

/// Domain: 0 < α ≤ π/2, radians; `terms` of the factor's series are kept. The sum falls short of K(cos
/// α) by less than 0.437 sin⁴α / cos α, if the factor is complete. Nothing cancels: in double each
/// member is good to a few ulp, however small α.
template <class Real>
Members<Real> three_members(Real alpha, int terms)
{
  using std::cos, std::log, std::sin, std::tan;
  const Real s = sin(alpha);
  const Real ln_two = log(Real(2));
  const Real factor = series(s * s, terms);
  const Real second = cos(alpha) * ln_two;
  return {factor, -log(tan(alpha / 2)) * factor, second, Real(0.75) * s * s * second};
}
// [three_members]

}  // namespace pendulum
