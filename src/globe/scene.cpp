#include "globe/scene.hpp"

#include <algorithm>
#include <cmath>

#include "edition/scene.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"

namespace globe
{
namespace
{

/// The seconds of a unit of τ = t√(2gc), τ in units of a. Domain: a, c, g > 0.
double clock_of(const Ball<double>& ball, double g)
{
  return std::sqrt(ball.a / ball.c) * (std::sqrt(ball.a) / (std::sqrt(2.) * std::sqrt(g)));
}

/// When the plane first bears nothing of a ball that rolls, between two times τ (over a) after the lowest
/// place, to the last bit; the second of them where it bears something all the way. Looked for at a thousand
/// times. Domain: can_be_seen().
double end_of_rolling(const Ball<double>& ball, const Energy<double>& e, double from, double to)
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

}  // namespace

Ball<double> in_radii(const Ball<double>& ball)
{
  return {1, ball.c / ball.a, ball.k / ball.a, ball.gap / ball.a};
}

bool can_be_seen(const Ball<double>& ball, double h)
{
  const Ball<double> own = in_radii(ball);
  const auto of_its_size = [](double x) { return x >= 1e-3 && x <= 1e3; };
  return of_its_size(own.c) && of_its_size(own.k) && h >= 1e-100 && h <= 1e9;
}

void scene_of_ball(const char* name, const Moving_ball& motion)
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

Moving_ball smooth_motion(const Ball<double>& given, double g, const Energy<double>& e, double f)
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

Moving_ball rolling_motion(const Ball<double>& given, double g, const Energy<double>& e, double from)
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
