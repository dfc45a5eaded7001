/// @file
/// The ball as the page shows it moving. Lengths in a scene are in units of its radius a.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "edition/scene.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"

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
inline Ball<double> in_radii(const Ball<double>& ball)
{
  return {1, ball.c / ball.a, ball.k / ball.a, ball.gap / ball.a};
}

/// The seconds of a unit of τ = t√(2gc), τ in units of a. Domain: a, c, g > 0.
inline double clock_of(const Ball<double>& ball, double g)
{
  return std::sqrt(ball.a / ball.c) * (std::sqrt(ball.a) / (std::sqrt(2.) * std::sqrt(g)));
}

/// Whether a ball can be drawn so: its lengths within a thousand of each other, and h from 1e-100 to 1e9. Of
/// one that cannot there is no scene.
inline bool can_be_seen(const Ball<double>& ball, double h)
{
  const Ball<double> own = in_radii(ball);
  const auto of_its_size = [](double x) { return x >= 1e-3 && x <= 1e3; };
  return of_its_size(own.c) && of_its_size(own.k) && h >= 1e-100 && h <= 1e9;
}

/// Declares the scene `name`: the ball, its centre of gravity, the way of that, and the plane. Columns: t in
/// seconds; Phi; C_x, the centre from where the first frame has it; G_x, G_y. At least 120 frames, so many
/// that between two of them the ball turns by no more than a twelfth of a radian; beyond 2000 a slow end is
/// shown in coarser steps. A motion that ends where it begins has no scene.
inline void scene_of_ball(const char* name, const Moving_ball& motion)
{
  if(!(motion.end > 0))
    return;
  namespace drawn = edition::drawn;
  const edition::Spot C{"C_x", 1.}, G{"G_x", "G_y"};
  edition::scene(
      name, {drawn::ground(0), drawn::trail(G), drawn::wheel(C, 1, "Phi"), drawn::bob(G, 0.06)},
      {"t", "Phi", "C_x", "G_x", "G_y"}, [&](edition::Curve& frames) {
        const int many = static_cast<int>(std::clamp(12 * motion.end * motion.fastest, 120., 2000.));
        for(int i = 0; i <= many; ++i)
        {
          const double tau = motion.end * i / many, Phi = motion.angle(tau), t = motion.clock * tau,
                       x = motion.advanced(Phi, t);
          frames.put({t, Phi, x, x - motion.ball.c * std::sin(Phi), 1 - motion.ball.c * std::cos(Phi)});
        }
      });
}

/// The ball on a smooth plane from its lowest place on, turning forwards, G going forwards by f a second
/// (over a): one period or two turns; till it leaves the plane; or, where it turns to the top and no further
/// (h = 1), till it lacks e⁻¹⁰ of it. Domain: can_be_seen().
inline Moving_ball smooth_motion(const Ball<double>& given, double g, const Energy<double>& e, double f)
{
  const Ball<double> ball = in_radii(given);
  const double over = e.h - smooth::lift_off_energy<double>(ball.c, ball.k);
  const double period = over > 0 ? smooth::lift_off<double>(ball.c, ball.k, over).tau
                                 : 4 * smooth::quarter<double>(ball.c, ball.k, e);
  return {ball,
          clock_of(given, g),
          [=](double tau) { return smooth::angle(ball.c, ball.k, e, tau).Phi; },
          [=](double Phi, double t) { return f * t + ball.c * std::sin(Phi); },
          std::isinf(period) ? 10 * ball.k : period,
          2 * std::sqrt(e.h) / ball.k};
}

/// When the plane first bears nothing of a ball that rolls, between two times τ (over a) after the lowest
/// place, to the last bit; the second of them where it bears something all the way. Looked for at a thousand
/// times. Domain: can_be_seen().
inline double end_of_rolling(const Ball<double>& ball, const Energy<double>& e, double from, double to)
{
  const auto borne = [&](double tau) {
    const double half = rolling::angle(ball, e, tau).Phi / 2;
    return rolling::pressure<double>(ball, e, {std::abs(std::sin(half)), std::abs(std::cos(half))}) > 0;
  };
  if(!borne(from))
    return from;
  constexpr int many = 1000;
  const double part = (to - from) / many;
  for(int i = 1; i <= many; ++i)
    if(!borne(from + i * part))
    {
      double on = from + (i - 1) * part, off = from + i * part;
      for(double middle = (on + off) / 2; on < middle && middle < off; middle = (on + off) / 2)
        (borne(middle) ? on : off) = middle;
      return on;
    }
  return to;
}

/// The ball that rolls, from the angle that it has at a τ (over a) after the lowest place: one period or two
/// turns; at h = 1 till it lacks some e⁻¹⁰ of the top; in each case no farther than to where the plane bears
/// nothing. Domain: can_be_seen().
inline Moving_ball rolling_motion(const Ball<double>& given, double g, const Energy<double>& e,
                                  double from = 0)
{
  const Ball<double> ball = in_radii(given);
  const double period = 4 * rolling::quarter<double>(ball, e);
  const double length = std::isinf(period) ? 10 * std::sqrt(BB(ball)) : period;
  const double start = rolling::angle(ball, e, from).Phi;
  return {ball,
          clock_of(given, g),
          [=](double tau) { return rolling::angle(ball, e, from + tau).Phi; },
          [=](double Phi, double) { return Phi - start; },
          end_of_rolling(ball, e, from, from + length) - from,
          2 * std::sqrt(e.h) / std::sqrt(bb(ball))};
}

}  // namespace globe
