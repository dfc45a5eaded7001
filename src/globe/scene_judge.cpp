#include "globe/scene_judge.hpp"

#include <algorithm>
#include <cmath>

#include "exact/ode.hpp"

namespace globe
{

std::vector<Judged_ball> judged(const std::vector<edition::ToldRow>& frames, Plane plane,
                                const Ball<exact::Fifty>& given, const exact::Fifty& g,
                                const exact::Fifty& Phi, const exact::Fifty& w, const exact::Fifty& f)
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
