#pragma once
/** @file
 * The usual ways to follow Euler's differential equation numerically, good and bad, in double: what the
 * exact curve by the flow on the sphere (member.hpp) is measured against.
 *
 * Lengths are in units of a: k is k/a, r is r/a. Angles are in radians. Where a way does not get there
 * the result is NaN.
 */
#include <optional>
#include <vector>

namespace tautochrone
{

/// Which of GSL's integrators.
enum class Stepper
{
  runge_kutta,     ///< the explicit pair of the eighth order by Prince and Dormand
  adams,           ///< Adams's method of variable order
  gear,            ///< the backward differentiation formulae of variable order, for stiff equations
  bulirsch_stoer,  ///< Bulirsch's and Stoer's extrapolation, by Bader's and Deuflhard's implicit rule
};

/**
 * r at the angle `to` on the curve through (from, r), by steps each of which errs by at most `tolerance`.
 *
 * Downwards every error dies. Upwards it grows nearly as exp(A(from) − A(to))/kk, see falling(), so that
 * from a place near the vertical nothing can be got. From the highest curve's end downwards, with 1e-13, the
 * result errs by less than 1e-13 for 0.01 ≤ k ≤ 0.9 (measured). Domain: 0 < k < 1, 0 < from, to < ½π, 1e-15 ≤
 * tolerance ≤ 0.1. NaN elsewhere, and where 200 000 steps are not enough.
 */
double follow(double k, double from, double r, double to, double tolerance, Stepper stepper);

/// The same at several angles, each reached from the one before; NaN from the first on that is not.
std::vector<double> follow(double k, double from, double r, const std::vector<double>& to, double tolerance,
                           Stepper stepper);

/**
 * r at several angles from a polynomial in φφ of the degree n that satisfies the equation at n + 1
 * Chebyshev points of 0 ≤ φ ≤ phi1, or at n of them where the value r1 at phi1 is given.
 *
 * With that value it converges. Without it the problem has no single solution: the more points, the
 * better the polynomial can imitate the differences between tautochrones, and the worse the result.
 *
 * Newton's iteration from Euler's curve with both corrections, or from the cosine where that has ended.
 * Domain: 0 < k < 1, 0 < phi1 < ½π, 2 ≤ n ≤ 200; NaN elsewhere, and where the iteration does not settle.
 */
std::vector<double> collocation(double k, double phi1, std::optional<double> r1, int n,
                                const std::vector<double>& angles);

}  // namespace tautochrone
