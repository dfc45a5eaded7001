#pragma once
/** @file
 * The one tautochrone that is analytic in its lowest point, its power series in fractions, and the
 * resonances.
 *
 * κ = kk/aa; lengths are in units of a. S is the arc of the virtual curve, dσ² = dz² + kk dφ², over f = a
 * + kk/a; the height is ½fSS. h = 1 − cos φ.
 */
#include "exact/fifty.hpp"
#include "exact/rational.hpp"

#include <vector>

namespace tautochrone
{

/**
 * xₘ of cos φ = Σ xₘ S²ᵐ for m = 0 to `last`, by XX + (k/f)²(dX/dS)² = 1 − SS. `Number` is Rational
 * (exactly) or Fifty.
 * @throws std::domain_error if last < 0, κ ≤ 0, or κ is 1/(2m − 1) for an m from 2 to `last`: there is no
 * such series
 */
template <class Number>
std::vector<Number> cosine_series(const Number& kappa, int last);

/**
 * bₘ of r/a = Σ bₘ hᵐ for m = 0 to `last`, by the equation of §25. `Number` is Rational (exactly) or Fifty.
 * @throws std::domain_error if last < 0, κ ≤ 0, or κ is 1/(2m + 1) for an m from 1 to `last`: there is no
 * such series
 */
template <class Number>
std::vector<Number> radius_series(const Number& kappa, int last);

/// The m for which κ = 1/(2m + 1), 1 ≤ m; 0 where there is none.
int resonance(const exact::Rational& kappa);

/**
 * The coefficient of hᵐ ln h in r/a at the resonance κ = 1/(2m + 1); all the curves there have it in
 * common, and differ from each other in that of hᵐ. 2 for κ = 1/3, 27 for κ = 1/5.
 * @throws std::domain_error if κ is no resonance
 */
exact::Rational logarithmic_coefficient(const exact::Rational& kappa);

/// A place of the analytic tautochrone.
struct Analytic
{
  exact::Fifty S;    ///< the arc of the virtual curve over f
  exact::Fifty phi;  ///< the angle, in radians
  exact::Fifty r;    ///< the radius of curvature
  exact::Fifty x;    ///< the height above the lowest point
};

/**
 * The place with a given S, or a given angle, to twenty-five digits: by the series while it lasts, then by
 * dh/dS = Z/ε and its inverse, ZZ = h(2 − h) − SS.
 *
 * For κ > 1 it is the only tautochrone with r = a in its lowest point. Its radius grows from κ = 1/3 on,
 * so that it cannot be wound on a cheek; for smaller κ it can, up to where dr = 0, and goes on beyond. It
 * may be followed up to where r becomes infinite.
 *
 * Domain: 1/50 ≤ κ ≤ 100, S and φ from 1e-100 up or zero.
 * @throws std::domain_error outside, at a resonance, or where the curve does not reach so far
 * @{
 */
Analytic analytic_at_arc(const exact::Fifty& kappa, const exact::Fifty& S);
Analytic analytic_at_angle(const exact::Fifty& kappa, const exact::Fifty& phi);
/// @}

}  // namespace tautochrone
