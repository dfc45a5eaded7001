/// @file
/// The ball as the page shows it moving. Lengths in a scene are in units of its radius a.
#pragma once

#include <functional>

#include "globe/ball.hpp"
#include "globe/energy.hpp"

namespace globe
{

/// A ball and its motion, as scene_of_ball() draws it. Lengths and τ are in units of a.
struct Moving_ball
{
  Ball<double> ball;                                     ///< with a = 1
  double clock;                                          ///< the seconds of a unit of τ
  std::function<double(double tau)> angle;               ///< Φ at a τ since the first frame
  std::function<double(double Phi, double t)> advanced;  ///< how far C has come at Φ and after t seconds
  double end;                                            ///< the last frame's τ
  double fastest;                                        ///< the greatest dΦ/dτ
};

/// The ball in units of its radius.
Ball<double> in_radii(const Ball<double>& ball);

/// Whether a ball can be drawn so: its lengths within a thousand of each other, and h from 1e-100 to 1e9. Of
/// one that cannot there is no scene.
bool can_be_seen(const Ball<double>& ball, double h);

/// Declares the scene `name`: the ball, its centre of gravity, the way of that, and the plane. Columns: t in
/// seconds; Phi; C_x, the centre from where the first frame has it; G_x, G_y. At least 120 frames, so many
/// that between two of them the ball turns by no more than a twelfth of a radian; beyond 2000 a slow end is
/// shown in coarser steps. A motion that ends where it begins has no scene.
void scene_of_ball(const char* name, const Moving_ball& motion);

/// The ball on a smooth plane from its lowest place on, turning forwards, G going forwards by f a second
/// (over a): one period or two turns; till it leaves the plane; or, where it turns to the top and no further
/// (h = 1), till it lacks e⁻¹⁰ of it. Domain: can_be_seen().
Moving_ball smooth_motion(const Ball<double>& given, double g, const Energy<double>& e, double f);

/// The ball that rolls, from the angle that it has at a τ (over a) after the lowest place: one period or two
/// turns; at h = 1 till it lacks some e⁻¹⁰ of the top; in each case no farther than to where the plane bears
/// nothing. Domain: can_be_seen().
Moving_ball rolling_motion(const Ball<double>& given, double g, const Energy<double>& e, double from = 0);

}  // namespace globe
