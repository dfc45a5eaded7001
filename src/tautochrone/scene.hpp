#pragma once
/** @file
 * Swings as the page shows them moving: where the body is at a time, and what is drawn of it.
 *
 * Lengths are in units of a, k is k/a, times in Euler's clock (g = ½) unless seconds are named.
 */
#include "tautochrone/cheeks.hpp"

#include <vector>

namespace tautochrone
{

/// A body let go at rest at φ₀, asked where it is.
class Timed_swing
{
public:
  /**
   * Between these cheeks, from φ₀. With sin ½φ = sin ½φ₀ cos α the element of time is
   * √(2(kk + rr)(c − c₀)/(c − x)) dα/cos ½φ, finite everywhere and formed without a difference; it is summed
   * by Gauss's rule of eight places in each of 64 parts of a right angle.
   * @throws std::domain_error unless 0 < φ₀ < largest_amplitude(cheeks, k) and 0 ≤ k ≤ 1e20
   */
  Timed_swing(Cheeks cheeks, double k, double phi0);

  /// The time of one swing, from rest to rest on the other side. Relative error below 5e-15 for φ₀ up to
  /// 0.99 of the largest amplitude (checks of §§2 and 31).
  double time() const { return 2 * reached_.back(); }

  /// φ at the time t ≥ 0: off by less than 1e-14 (1 + t/time()) times the greatest velocity's time().
  double angle(double t) const;

private:
  double element(double alpha) const;                  // dt/dα
  double between(double alpha, double further) const;  // the time between two phases

  Cheeks cheeks_;
  double k_, half_sine_, c0_;
  std::vector<double> reached_;  // the times at the ends of the parts, up to the lowest place
};

/// The unit of Euler's clock in seconds: √a/(2√g), g the height fallen in the first second, both in one unit.
double clock_in_seconds(double a, double g);

/**
 * Declares the scene `name`: the two cheeks, the free part of the thread, and a body that swings out to φ₀
 * for one period; for the body stand two equal weights on the line of the thread, k above G and k below it,
 * which move alike. Where k = 0, it is one. `unit` is that of the clock in seconds.
 *
 * Columns: t in seconds; phi; M_x, M_y, where the thread leaves the cheek; G_x, G_y; and for k > 0 the
 * weights, upper_x, upper_y, lower_x, lower_y. Places are from A, to the right and upwards.
 * Domain: as Timed_swing, of cycloids and Euler's cheeks with both corrections, else std::domain_error.
 */
void scene_between_cheeks(const char* name, Cheeks cheeks, double k, double phi0, double unit);

/// A thread on its cheek and the body on it, from A, to the right and upwards.
struct Hung
{
  double phi;  ///< the angle of the free part with the vertical, positive to the right
  double M_x;  ///< where the thread leaves the cheek
  double M_y;  ///< where the thread leaves the cheek
  double G_x;  ///< the centre of gravity
  double G_y;  ///< the centre of gravity
};

/**
 * A body that is let go at rest at φ₀ between cycloids or Euler's cheeks with both corrections, at the times
 * i T₀/n for i = 0 to `last`, T₀ = small_swing(k). Angles as Timed_swing::angle(), places to 1e-14.
 * @throws std::domain_error as Timed_swing, and for other cheeks
 */
std::vector<Hung> hung_between(Cheeks cheeks, double k, double phi0, int n, int last);

/**
 * The same between the cheeks of the highest exact tautochrone (see member.hpp), where the root of the height
 * goes as the cosine of the time. Angles and places to 1e-12.
 * @throws std::domain_error unless n is even and positive, 0.02 ≤ k ≤ 0.9 and 1e-3 ≤ φ₀ ≤ the curve's end
 */
std::vector<Hung> hung_on_highest(double k, double phi0, int n, int last);

}  // namespace tautochrone
