#pragma once
/** @file
 * How long a compound pendulum swings whose centre of gravity is led along a curve.
 */
#include "exact/series.hpp"

#include <functional>
#include <vector>

namespace tautochrone
{

/**
 * T/T₀ - 1, by how much a swing of amplitude phi0 lasts longer than an infinitely small one (§19).
 *
 * `r` and `x` are the radius of curvature and the height as functions of φ, in units of a, with r(0) = 1; k
 * is k/a. The midpoint rule after φ = φ₀ sin α, its nodes doubled until the result stands still to
 * twenty-five digits. The amplitude must not be smaller than 1e-4, because heights are subtracted.
 *
 * @throws std::domain_error unless 1e-4 ≤ phi0 < π/2, k ≥ 0, and x grows from 0 to phi0
 * @throws std::runtime_error if 1024 nodes are not enough
 */
exact::Fifty excess(const std::function<exact::Fifty(const exact::Fifty&)>& r,
                    const std::function<exact::Fifty(const exact::Fifty&)>& x, const exact::Fifty& k,
                    const exact::Fifty& phi0);

/// The same for a radius that is a polynomial in cos φ and 1/cos φ without a term 1/cos φ, such as Euler's.
/// NaN where that radius is below 1e-4 at phi0: there, or just beyond, such a curve has turned back.
exact::Fifty excess(const exact::Laurent<exact::Fifty>& r, const exact::Fifty& k, const exact::Fifty& phi0);

/**
 * (dφ/dt)² of a swing out to φ₀ on Huygens's cheeks at the angle φ, in units of a and in Euler's clock, by
 * following the body's equation of motion (kk + rr)φ" + rr'φ'φ' = −½r sin φ down from rest: it knows
 * nothing of the integral of §17, which it is there to judge. k is k/a. The relative error is below 1e-25.
 *
 * @throws std::domain_error unless 1e-20 ≤ k ≤ 1e20 and 0 ≤ φ ≤ φ₀ < ½π, φ₀ > 0
 */
exact::Fifty turning2_by_motion(const exact::Fifty& k, const exact::Fifty& phi0, const exact::Fifty& phi);

/// The same on any curve, whose radius is a polynomial in cos φ and 1/cos φ with the value 1 at φ = 0, and
/// positive up to φ₀.
/// @throws std::domain_error as above
exact::Fifty turning2_by_motion(const exact::Laurent<exact::Fifty>& r, const exact::Fifty& k,
                                const exact::Fifty& phi0, const exact::Fifty& phi);

/// A place on a curve, a = 1.
struct On_curve
{
  exact::Fifty phi;  ///< the angle of the thread, positive to the right
  exact::Fifty r;    ///< what of the thread is free
  exact::Fifty x;    ///< the height above the lowest place
  exact::Fifty y;    ///< how far it is to the right
};

/**
 * Where a body is that is let go at rest at φ₀ on any such curve, at times after that, which must grow, by
 * following its equation of motion (kk + rr)φ" + rr'φ'φ' = −½r sin φ, and with it the curve's integrals of r sin φ
 * and r cos φ; a = 1, Euler's clock. The error grows with every swing; it is below 1e-16 φ₀ for some ten.
 * @throws std::domain_error unless 0 ≤ k ≤ 1e20 and 0 < φ₀ < ½π
 */
std::vector<On_curve> places_by_motion(const exact::Laurent<exact::Fifty>& r, const exact::Fifty& k,
                                       const exact::Fifty& phi0, const std::vector<exact::Fifty>& times);

/// How a body on a wound thread is accelerated, a = 1 and g = ½; see accelerations().
struct Accelerations
{
  exact::Fifty turning;  ///< 2ddφ/dt²
  exact::Fifty along;    ///< of G along the thread, towards M, doubled
  exact::Fifty across;   ///< of G at right angles to it, upwards, doubled
};

/**
 * The accelerations of a body that turns with (dφ/dt)² = turning2 at the angle φ, by d'Alembert's principle:
 * the body is two equal weights, k above G and k below it, each of which is accelerated as its place on the
 * line MG demands; what is wanting to gravity does no work when the line is moved. It knows nothing of Z, of
 * P and of the equations of §§14 to 17. Good to 1e-40 of themselves. Domain: k ≥ 0, |φ| < ½π, r(cos φ) > 0.
 */
Accelerations accelerations(const exact::Laurent<exact::Fifty>& r, const exact::Fifty& k,
                            const exact::Fifty& turning2, const exact::Fifty& phi);

/// T/T₀ − 1 of a simple pendulum on a fixed axis, by the series whose coefficients are the squares of
/// 1·3·5…/2·4·6…: all of its terms are positive. Good to 1e-45 of itself; domain: 0 < φ₀ ≤ 170°.
exact::Fifty circle_excess(const exact::Fifty& phi0);

/// By how many seconds a clock is late when it has counted a day, if it was set by infinitely small
/// swings and its swings take 1 + excess times as long.
inline double late_in_a_day(const exact::Fifty& excess)
{
  return 86400 * static_cast<double>(excess);
}

}  // namespace tautochrone
