#include "pendulum/scene.hpp"

#include <algorithm>

#include "edition/scene.hpp"
#include "elementary/circular.hpp"

namespace pendulum
{
namespace
{

/// Frames of a scene of one period: at least so many, and more where the pendulum lingers near the top, so
/// that between two of them it turns by no more than a twelfth of a radian. Beyond 4000 a slow end is shown
/// in coarser steps.
int frames_of(const swing::Motion& motion)
{
  const double frames = motion.period() * 24;  // no pendulum is faster than 2 in √(2g)/√b
  return static_cast<int>(std::clamp(frames, 240., 4000.));
}

}  // namespace

void scene_of_swing(const char* name, const swing::Amplitude& amplitude, double unit)
{
  const swing::Motion motion(amplitude, swing::Start::rest);
  namespace drawn = edition::drawn;
  const edition::Spot axis{0., 0.}, bob{"x", "y"};
  edition::scene(
      name,
      {drawn::trail(bob), drawn::rod({axis, bob}), drawn::bob(axis, 0.02, "ink"), drawn::bob(bob, 0.07)},
      {"t", "phi", "x", "y"}, [&](edition::Curve& c) {
        const int frames = frames_of(motion);
        for(int i = 0; i <= frames; ++i)
        {
          const double t = motion.period() * i / frames, phi = motion.angle(t);
          c.put({unit * t, phi, elementary::sin(phi), -elementary::cos(phi)});
        }
      });
}

}  // namespace pendulum
