#pragma once
/** @file
 * The time of a swing on a curve that is given by numbers, in double: the fast way to the integral of §19.
 *
 * Lengths are in units of a, k is k/a, times in Euler's clock (g = ½).
 */
#include "exact/series.hpp"
#include "tautochrone/kernels.hpp"

#include <array>

namespace tautochrone
{

/**
 * A curve whose radius of curvature is a polynomial in cos φ and 1/cos φ, and a body that is led along it.
 *
 * Its swings are timed by Gauss's and Chebyshev's rule: after sin ½φ = sin ½φ₀ sin α all nodes weigh the
 * same, and nothing is infinite. c − x is never formed by subtraction: it is c − c₀ = 2 sin²½φ₀ cos²α
 * times a divided difference, whose coefficients come from one synthetic division.
 */
class Path
{
public:
  /**
   * @param r the radius over a: powers of cos φ from -24 to 23, none of them -1, for which the height is
   * no power
   * @param k the radius of gyration over a, 0 ≤ k ≤ 1e100
   * @throws std::domain_error otherwise
   */
  Path(const exact::Laurent<double>& r, double k);

  /**
   * T, the time of one swing from side to side out to φ₀: at most 2 ulps off where r is a polynomial with
   * coefficients of the size of one (measured: 1.0 up to φ₀ = 1.4), plus what r itself errs by.
   *
   * 8 nodes and 16 more, trebled up to 1944 until they change 4e-9 at most. The error is then nearly the
   * cube of that, for singularities that are weak its square.
   * @throws std::domain_error unless 0 < φ₀ < ½π (any curve without 1/cos φ: < π) and the curve rises all
   * the way
   * @throws std::runtime_error if 1944 nodes are not enough
   */
  double swing_time(double phi0) const;

  /// The same by a given variant of the loops, for tests and races.
  double swing_time(double phi0, kernels::Sum sum) const;

private:
  static constexpr int most_powers = 24;  // of either sign
  using Coefficients = std::array<double, most_powers>;

  int powers_, inverse_powers_;
  double kk_;
  Coefficients r_, r_inverse_;        // of c⁰, c, ... and of e, ee, ...
  Coefficients over_, over_inverse_;  // the same over the powers that they have when integrated
};

}  // namespace tautochrone
