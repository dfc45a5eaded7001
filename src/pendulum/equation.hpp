/// @file
/// What the pendulum's equation of motion is made of: the length that stands for the body, and the
/// difference of two cosines that stands for the amplitude.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pendulum
{

// [equivalent_length]
/// b = a + kk/a, the length of the simple pendulum that swings as the compound one does (§6): a =
/// AG, and k the radius of gyration about G. Domain: a > 0, k ≥ 0, in the same unit as the result.
/// Real: double (to 2 ulp, and no overflow or underflow that b itself has not), exact::Fifty or
/// exact::Rational.
template <class Real>
Real equivalent_length(Real a, Real k)
{
  return a + k * (k / a);
}
// [equivalent_length]

// [cosine_difference]
/// cos Φ − cos ζ as a product of sines, which keeps its digits where the two cosines agree (§§6,
/// 7). Counted from the top it is the same: cos Φ − cos ζ = cos η − cos ψ, so that
/// cosine_difference(eta, psi) serves there. Domain: any angles, radians. Real: double (to 3 ulp
/// beyond what the rounding of the two half sums does) or exact::Fifty.
template <class Real>
Real cosine_difference(Real phi, Real zeta)
{
  using std::sin;
  return 2 * sin((zeta + phi) / 2) * sin((zeta - phi) / 2);
}
// [cosine_difference]

/// The way from rest at the angle η from the top, in doubles: what was formed as the way, but not past the lowest point
/// by rounding, where swing::time_from_rest_past() ends. Radians.
inline double way_from_rest(double way, double eta)
{
  return std::min(way, std::numbers::pi - eta);
}

}  // namespace pendulum
