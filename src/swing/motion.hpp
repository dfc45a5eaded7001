/// @file
/// Where the pendulum is, and how fast: the motion in closed form, for any energy.
///
/// Units as in time.hpp: radians, and √(b/2g) for the time. A Motion is prepared once and then asked as
/// often as wanted:
///
///     Motion m(a);                 swinging with the amplitude a, at t = 0 upwards through the lowest point
///     Motion m(a, Start::rest);    the same, at t = 0 at rest at Φ = ζ
///     Motion::revolving(excess)    going round, at t = 0 at the lowest point
///     m.angle(t), m.velocity(t)    Φ and Φ'
///     m.angle_from_top(t)          π − |Φ|, with all its digits near the top
///     m.period()                   of the whole motion, there and back or once round
///
/// Each is also there for arrays, many times faster. The time is first reduced to a fraction of the swing
/// with a frequency of 107 bits, so that 10⁶ periods cost no digit.
///
/// When a question is asked for the first time, the motion is tabulated for it: polynomials of degree 7 at
/// 32 to 512 phases of a quarter period, each in one line of the cache, which takes as long as some ten to
/// two hundred answers computed from the beginning. From then on an answer is read from one of them. Nearer
/// to the top than η = 6·10⁻¹¹ (and for excesses as small) the rows would be too many; there each answer is
/// computed from the beginning, as it is with amplitudes below 2⁻⁴⁰⁰. Copies of a motion share the rows;
/// several threads may ask at once.
///
/// All is computed in round to nearest and, on x86-64, with subnormal numbers, whatever is set; the
/// caller's setting returns. So a motion of the same amplitude is the same to the last bit
/// (tests/swing_environment.cpp).
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "swing/kernels.hpp"
#include "swing/time.hpp"

namespace swing
{

/// Where the clock starts.
enum class Start
{
  bottom,  ///< at the lowest point, moving towards positive angles
  rest     ///< at rest at Φ = ζ
};

/// The motion of one pendulum.
class Motion
{
public:
  /// Swinging between −ζ and ζ. With η = 0 it is the motion that needs for ever to reach the top, Φ = 2
  /// arctan sinh t; that cannot start from rest there: std::domain_error.
  explicit Motion(Amplitude a, Start start = Start::bottom);

  /// Going round and round: ½Φ'² + 1 − cos Φ = 2(1 + excess). The angle grows without end.
  /// Throws std::domain_error unless 0 < excess ≤ 10³⁰⁰.
  static Motion revolving(double excess);

  // Errors as found by tests/swing_motion.cpp, within 100 periods and after 10⁶ alike, for any amplitude.

  /// Φ at the time t. Worst error 1.1 · 2⁻⁵² ζ (of π, or of Φ itself, going round; 2 · 2⁻⁵² ζ where there
  /// are no rows), and some of the last digits of Φ in the first instants. NaN for NaN and when |t| exceeds
  /// 2⁵⁰ half swings (10¹⁵⁰ for the motion that ends at the top).
  double angle(double t) const;
  /// Φ' at the time t, NaN as angle(). Worst error 2½ · 2⁻⁵² of the greatest velocity.
  double velocity(double t) const;
  /// The angle between the pendulum and the upper vertical at the time t, 0 … π; NaN as angle(). Worst
  /// error 4 · 2⁻⁵² of itself: near the top it keeps its own digits, not only those of π. Of the motion
  /// that ends at the top it is not told below 4e⁻⁷⁰⁰.
  double angle_from_top(double t) const;

  /// Φ of an array of times, bit for bit as of one. Throws std::invalid_argument when the spans differ in
  /// length, and for no other reason. The spans may be the same, or not overlap.
  void angle(std::span<const double> t, std::span<double> out) const;
  /// Φ' of an array of times, the same.
  void velocity(std::span<const double> t, std::span<double> out) const;
  /// The angle from the top of an array of times, the same.
  void angle_from_top(std::span<const double> t, std::span<double> out) const;

  /// The time of a whole period, there and back or once round; +∞ when the top is just reached. Worst error
  /// 1 ulp.
  double period() const;

  /// What the loops that compute directly are given; for tests and benchmarks of each variant.
  const kernels::Prepared& prepared() const { return prepared_; }
  /// Which of those loops; for the same.
  kernels::Course course() const { return course_; }
  /// The rows that a question is answered by, or none where it is computed directly; for the same.
  const kernels::Rows* rows(kernels::Question asked) const;

private:
  class Tables;

  Motion() = default;
  double ask(kernels::Question asked, double t) const;
  double ask_with_care(kernels::Question asked, double t) const;
  void ask(kernels::Question asked, std::span<const double> t, std::span<double> out) const;

  kernels::Prepared prepared_;
  kernels::Course course_ = kernels::low;
  std::shared_ptr<Tables> tables_;
};

}  // namespace swing
