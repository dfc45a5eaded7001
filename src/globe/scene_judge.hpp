/// @file
/// What the frames of scene.hpp are judged by: the equations of motion of §§6-9, in fifty digits.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "edition/told.hpp"
#include "exact/ode.hpp"
#include "globe/ball.hpp"

namespace globe
{

/// A frame as it was told, and what it should be, lengths in units of a.
struct Judged_ball
{
  edition::ToldRow told;  ///< the frame
  double earliest;        ///< the time of the judged frame before it
  double latest;          ///< and of the one after it
  exact::Fifty Phi;       ///< its angle
  exact::Fifty C_x;       ///< the centre
  exact::Fifty G_x;       ///< the centre of gravity
  exact::Fifty G_y;       ///< and its height
  exact::Fifty pressure;  ///< what the plane bears of the weight
  double slack;           ///< how far each of the four may be off
  /// One of these four: what was told, and what is right.
  struct Number
  {
    edition::ToldNumber told;  ///< as it was told
    exact::Fifty right;        ///< as it should be
  };
  /// The four, to be compared within `slack`.
  std::vector<Number> numbers() const
  {
    return {{told.value("Phi"), Phi},
            {told.value("C_x"), C_x},
            {told.value("G_x"), G_x},
            {told.value("G_y"), G_y}};
  }
  /// And why so much.
  static constexpr const char* because =
      "ten ulps of the time, that times the velocity, and the way's rounding";
};

/// What the ball is to do.
enum class Plane
{
  smooth,  ///< Nothing holds it: G goes on as it does.
  rough    ///< It rolls.
};

/// Judges frames of a ball that at the first of them has the angle Φ and turns by w a second; on a smooth
/// plane G goes forwards by f a second. Domain: a, c, k, g > 0 in one unit.
inline std::vector<Judged_ball> judged(const std::vector<edition::ToldRow>& frames, Plane plane,
                                       const Ball<exact::Fifty>& given, const exact::Fifty& g,
                                       const exact::Fifty& Phi, const exact::Fifty& w,
                                       const exact::Fifty& f = 0)
{
  using exact::Fifty;
  const Ball<Fifty> ball{1, given.c / given.a, given.k / given.a};
  const Fifty g_ = g / given.a;
  const auto pushed = [&](const exact::State& y) {
    return plane == Plane::smooth ? accelerations<Fifty>(ball, g_, y[0], y[1], 0)
                                  : rolling_accelerations<Fifty>(ball, g_, y[0], y[1]);
  };
  const auto motion = [&](const Fifty&, const exact::State& y) -> exact::State {
    return {y[1], pushed(y).Phi};
  };
  std::vector<Fifty> times;
  for(const auto& frame : frames)
    times.emplace_back(frame.at("t"));
  const auto states = exact::solve(motion, 0, {Phi, w}, times, Fifty("1e-20"));
  const Fifty start = sin(Phi);
  double fastest = 0;
  for(const auto& state : states)
    fastest = std::max(fastest, std::abs(static_cast<double>(state.y[1])));
  std::vector<Judged_ball> result;
  for(std::size_t i = 0; i < frames.size(); ++i)
  {
    const Fifty at = states[i].y[0], s = sin(at);
    const Fifty C_x =
        plane == Plane::rough ? Fifty(at - Phi) : Fifty(f / given.a * times[i] + ball.c * (s - start));
    const double along = static_cast<double>(abs(C_x) + ball.c);
    const double earliest = frames[i > 0 ? i - 1 : 0].at("t");
    const double latest = frames[std::min(i + 1, frames.size() - 1)].at("t");
    result.push_back({frames[i], earliest, latest, at, C_x, C_x - ball.c * s, 1 - ball.c * cos(at),
                      pushed(states[i].y).pressure,
                      1e-15 * (along + 20 * fastest * static_cast<double>(times.back())) + 1e-15});
  }
  return result;
}

}  // namespace globe
