#pragma once
/** @file
 * How long a compound pendulum swings between the cheeks that the paper speaks of, in double.
 *
 * Lengths are in units of a, the distance AC: k is k/a. Euler's clock: the velocity is the square root of
 * the height fallen, so that g = ½; a time in it is a number times √a. For seconds divide it by √(2g).
 */
namespace tautochrone
{

/// What leads the thread.
enum class Cheeks
{
  none,      ///< a fixed axis: the centre of gravity describes a circle
  cycloids,  ///< Huygens's: r = a cos φ
  euler_kk,  ///< Euler's with the first correction
  euler_k4   ///< Euler's with both
};

/**
 * The defect of §26, D = 2CQ·MH/(AD·GT) − 1, at the angle φ: zero on a tautochrone. Without cancellation:
 * its relative error is below 1e-14 where the radius of curvature is no small difference.
 *
 * @throws std::domain_error unless 0 < φ, the curve reaches to φ, and 0 ≤ k ≤ 1e20
 */
double defect(Cheeks cheeks, double k, double phi);

/**
 * T/T₀ − 1: by what fraction a swing out to φ₀ on either side takes longer than an infinitely small one.
 *
 * By Abel's theorem it is the average of √(1 + D) − 1 over the heights x = x₀ sin²β, 0 < β < ½π, where D
 * is the defect of §26. D is formed without cancellation, so nothing is lost however small the excess is:
 * the relative error is below 1e-13 (measured: 4e-15 for k/a up to 0.7), for amplitudes from 1e-150 to
 * the end of the curve. Below 1e-300 the result is zero or subnormal.
 *
 * @throws std::domain_error unless 0 < phi0 < largest_amplitude(cheeks, k) and 0 ≤ k ≤ 1e20
 */
double excess(Cheeks cheeks, double k, double phi0);

/// T₀ = 2π√(½f), f = a + kk/a: the time of an infinitely small swing from one side to the other. Domain: k
/// from 0 to 1e150. At most 2 ulps off.
double small_swing(double k);

/// T, the time of one swing from side to side: T₀ + T₀ excess. At most 3 ulps off. @throws as excess()
double swing_time(Cheeks cheeks, double k, double phi0);

/// Up to what angle the pendulum can swing: π on a fixed axis, ½π on cycloids, the end of Euler's curves
/// (see end_of_truncated()). It is not reached: excess() wants φ₀ below.
double largest_amplitude(Cheeks cheeks, double k);

}  // namespace tautochrone
