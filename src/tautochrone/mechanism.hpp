#pragma once
/** @file
 * Swings of one freedom whose inertia and whose weight's moment are polynomials in 1 − cos φ, in double.
 *
 * Lengths are in units of a, masses in units of the body's. Euler's clock (g = ½): the inertia I and the
 * moment w sin φ rule the motion by I (dφ/dt)² = V(φ₀) − V(φ), dV = w sin φ dφ.
 */
#include "exact/series.hpp"

#include <vector>

namespace tautochrone
{

/**
 * A body that is led along any curve whose radius r is a polynomial in h = 1 − cos φ, where I = kk + rr and
 * w = r; or one with a thread that has weight (§11).
 *
 * How much longer its wide swings take is never the difference of two times. With
 * 1 + D = 2 V I w₀/(I₀ sin²φ ww) the excess is an average of 1 − 1/√(1 + D); D is a polynomial in h without
 * a constant term over a positive one, and its coefficients are formed in fifty digits.
 */
class Mechanism
{
public:
  using Polynomial = exact::Laurent<exact::Fifty>;  ///< in h = 1 − cos φ

  /// @throws std::domain_error unless both are polynomials, positive in the lowest place
  Mechanism(const Polynomial& inertia, const Polynomial& moment);

  /**
   * T/T₀ − 1 of swings out to φ₀ on either side, T₀ being the time of an infinitely small one. The error is
   * below 1e-13 times the average of the sizes of the terms of D (measured on cycloids and circles: 3e-15
   * of the excess) where w has not fallen below a tenth of w₀ at φ₀; below that it grows as w₀/w.
   *
   * @throws std::domain_error unless 0 < φ₀ < π and w and I are positive as far as φ₀
   */
  double excess(double phi0) const;

  /// T₀ = 2π√(½I₀/w₀), at most 2 ulps off.
  double small_swing() const;

  /// T = T₀ + T₀ excess. @throws as excess()
  double swing_time(double phi0) const;

private:
  std::vector<double> inertia_, moment_;  // over their values in the lowest place
  std::vector<double> height_;            // of h, hh, ... in V/w₀
  std::vector<double> rest_;  // of h, hh, ... in 2 V I w₀/(h I₀) − (2 − h)ww, over w₀w₀
  double small_;
};

}  // namespace tautochrone
