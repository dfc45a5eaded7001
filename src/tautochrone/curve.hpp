#pragma once
/** @file
 * The exact tautochrone of a compound pendulum, to thirty digits.
 *
 * Lengths are in units of a, the distance AC: k is k/a, r is r/a.
 */
#include "exact/fifty.hpp"

#include <cmath>
#include <vector>

namespace tautochrone
{

// [slope]
/**
 * dr/dφ on a tautochrone, by the equation at the end of §25, for a = 1.
 *
 * Followed with φ growing, every error grows nearly as exp(-A(φ)/kk), A being falling(); followed towards
 * φ = 0, it dies as fast. Singular at φ = 0 and for k = 0.
 */
template <class Real>
Real slope(const Real& phi, const Real& r, const Real& k)
{
  using std::cos, std::sin;
  const Real kk = k * k;
  const Real u = kk + r * r;
  return u * (u - (1 + kk) * r * cos(phi)) / (kk * (1 + kk) * sin(phi));
}
// [slope]

/**
 * A(φ) = -½ - ln sin φ + ½ sin²φ, which falls from infinity at φ = 0 to zero at 90°.
 *
 * Two neighbouring tautochrones of small k differ at φ nearly as exp(-A/kk), and the same A rules Euler's
 * series: its terms begin to grow after some A/kk of them.
 */
exact::Fifty falling(const exact::Fifty& phi);

/// A point of the curve: the angle, the radius of curvature, the height above the lowest point.
struct Point
{
  exact::Fifty phi;  ///< the angle, in radians
  exact::Fifty r;    ///< the radius of curvature
  exact::Fifty x;    ///< the height above the lowest point
};

/**
 * Where the highest tautochrone ends, in closed form.
 *
 * For k < 1 infinitely many curves through the lowest point, all with the radius 1 there, have all swings
 * equal. Each of them ends where dr = 0 and the cheek would have to turn back. The one that reaches highest
 * does so at tan φ = (1 - k)/√k and at the height ½(1 - k)². It is the edition's standard of an exact
 * curve.
 *
 * @throws std::domain_error unless 0 < k < 1
 */
Point highest_end(const exact::Fifty& k);

/**
 * Where the widest tautochrone ends, the one that reaches the greatest angle: at 90° − 2 arctan k with
 * the radius k.
 * @throws std::domain_error unless 0 < k < 1
 */
Point widest_end(const exact::Fifty& k);

/**
 * r of the highest tautochrone at each of the angles, which must grow and lie between 0 and its end. The
 * error is below 1e-28.
 *
 * Integrated backwards. For small k the integration need not begin at the end: two tautochrones that are
 * both there at an angle a little above φ differ at φ by less than e^-80.
 *
 * @throws std::domain_error unless 1e-9 ≤ k < 1 and the angles are as they should be
 */
std::vector<exact::Fifty> highest(const exact::Fifty& k, const std::vector<exact::Fifty>& angles);

/// The same at one angle.
exact::Fifty highest(const exact::Fifty& k, const exact::Fifty& phi);

/**
 * r of the tautochrone through the point (φ, r), at each of the angles, which must grow and lie between 0
 * and φ. The error is below 1e-28.
 *
 * Through every point with (1 + kk) r cos φ ≥ kk + rr passes one that can be wound on a cheek.
 * @throws std::domain_error unless 1e-9 ≤ k < 1, the point is as said, and the angles are as they should be
 */
std::vector<exact::Fifty> through(const exact::Fifty& k, const exact::Fifty& phi, const exact::Fifty& r,
                                  const std::vector<exact::Fifty>& angles);

}  // namespace tautochrone
