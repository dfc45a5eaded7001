/// @file
/// What the frames of scene.hpp are judged by: the motion in fifty digits.
#pragma once

#include "exact/fifty.hpp"
#include "swing/oracle.hpp"

namespace pendulum
{

/// The motion from rest at Φ = ζ = π − η, by the smaller of the two angles, which is known to more digits.
inline swing::oracle::Motion judge_of(const exact::Fifty& zeta, const exact::Fifty& eta)
{
  using Judge = swing::oracle::Motion;
  return zeta < eta ? Judge::from_zeta(zeta) : Judge::from_eta(eta);
}

/// Judges frames of scene_of_swing(); `unit` is √b/√(2g) in seconds.
class Scene_judge
{
public:
  /// Of the motion from rest at Φ = ζ = π − η.
  Scene_judge(const exact::Fifty& zeta, const exact::Fifty& eta, const exact::Fifty& unit)
      : judge_(judge_of(zeta, eta)), unit_(unit), slack_(1e-15 * static_cast<double>(4 * judge_.quarter()))
  {
  }

  /// The angle at the time t, in seconds.
  exact::Fifty angle(const exact::Fifty& t) const { return judge_.angle(t / unit_ + judge_.quarter()); }
  /// No frame comes later, in seconds: a period, and what is rounded.
  double last() const { return 4.0001 * static_cast<double>(unit_ * judge_.quarter()); }
  /// How far a frame's angle, x or y may be off.
  double slack() const { return slack_; }
  /// And why.
  static constexpr const char* because =
      "the time is rounded three times, and no pendulum is faster than 2";

private:
  swing::oracle::Motion judge_;
  exact::Fifty unit_;
  double slack_;
};

}  // namespace pendulum
