#pragma once
/** @file
 * The exact tautochrones of a body with k < a, in double: the highest, the widest, the one through a point.
 *
 * Lengths are in units of a, the distance AC: k is k/a, r is r/a.
 *
 * With H = 1 − cos φ, Y = r sin φ/√(kk + rr), Z = k sin φ/√(kk + rr) the equation of §25 becomes a flow
 * on a sphere, H(2 − H) = YY + ZZ, whose right sides are products: no denominator, no sine, no
 * singularity at the lowest point. Followed downwards all its errors die. The height is ½(1 + kk)YY. By Y
 * instead of its time the flow is one equation, whose series has but two sums of squares in each term.
 */
#include "tautochrone/kernels.hpp"

#include <vector>

namespace tautochrone
{

/// Which of the infinitely many tautochrones through the lowest point, all with the radius a there.
enum class Member
{
  highest,  ///< ends where the height is greatest, at tan φ = (a − k)/√(ak)
  widest    ///< ends where the angle is greatest, at 90° − 2 arctan(k/a)
};

/// A place on a tautochrone and on its cheek.
struct Position
{
  double phi = 0;  ///< the angle, in radians
  double r = 1;    ///< MG, the radius of curvature
  double x = 0;    ///< CQ, the height of G above the lowest point
  double s = 0;    ///< AM = 1 − r, the arc of the cheek that the thread lies on, without the subtraction
};

/**
 * Where the curve ends, in closed form: the cheek would have to turn back there. At most 6 ulps off.
 * @throws std::domain_error unless 0 < k < 1: for k ≥ a the radius grows with the angle, and a thread
 * cannot be wound so
 */
Position end(Member member, double k);

/**
 * The place with the angle φ. Relative errors below 1e-14 for r, x and s of the highest curve and 1e-13 for
 * those of the widest, where the angle itself is not in question (measured for k from 0.001 to 0.999 and φ
 * from 1e-300 to the end, of the highest near 90° for k from 1e-9).
 *
 * A Taylor series at each step, of order 16 where the place is near, else 24, and 32 where that is not long enough. How far above φ the steps must begin, and how good they must be
 * there, only the rate tells at which different curves approach each other downwards: for small k the begin is
 * much nearer than the end, and a step that errs high up may be long. The same bits on every machine: no product and
 * sum are fused, and the sines are the edition's; but for k/a below cos²φ/1000, where the highest curve is Euler's
 * formula with the C library's cosine.
 *
 * @throws std::domain_error unless 1e-9 ≤ k < 1 and 0 ≤ φ ≤ end(member, k).phi
 */
Position at(Member member, double k, double phi);

/**
 * The places at several angles, which must grow and lie between 0 and the end: with the errors of at() each, but all on
 * one way down, and those that lie in the same step together: the same bits by every variant of the loops.
 * @throws std::domain_error as at(), and unless the angles grow
 */
std::vector<Position> along(Member member, double k, const std::vector<double>& angles);

/// The same by a given variant of the loops, for tests and races.
std::vector<Position> along(Member member, double k, const std::vector<double>& angles, kernels::Find find);

/**
 * The place with the angle φ on the tautochrone that passes through the point (φ₁, r₁), which every point
 * with (1 + kk)r₁ cos φ₁ ≥ kk + r₁r₁ does, at φ ≤ φ₁.
 * @throws std::domain_error unless 1e-9 ≤ k < 1, the point is as said and 0 ≤ φ ≤ φ₁
 */
Position at_through(double k, double phi1, double r1, double phi);

/// A place as it is drawn: what at() says, and the arc and the breadth, which need an integration.
struct Drawn
{
  Position at;        ///< angle, radius, height, arc of the cheek
  double z = 0;       ///< CG, the arc of the curve
  double y = 0;       ///< QG, how far the curve is from the vertical
  double p = 0;       ///< AP, the depth of the place where the thread leaves the cheek
  double q = 0;       ///< PM, how far that place is from the vertical
  double by_arc = 0;  ///< the height again, as the integral of dz sin φ: it must equal at.x
};

/**
 * The curve and its cheek at several angles, which must grow and lie between 0 and the end. Errors of z,
 * y and by_arc below 1e-12 of themselves, from k = 0.1 on 1e-13, of p and q below 1e-14 (absolutely); k
 * from 0.02 to 0.9.
 *
 * The whole curve is followed to its lowest point, which takes some (1 + kk)/kk steps for each factor of e.
 * @throws std::domain_error unless 0.005 ≤ k < 1 and the angles are as they should be; angles between 0
 * and 1e-14 of the end are refused, too
 */
std::vector<Drawn> drawn(Member member, double k, const std::vector<double>& angles);

}  // namespace tautochrone
