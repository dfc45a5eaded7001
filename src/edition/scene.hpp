/// @file
/// Scenes that move: the bodies that the page draws, and the motion that the section's program gives them.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "edition/tell.hpp"

namespace edition
{

/// A number, or the name of the scene's column that has it for each frame.
using Moving = std::variant<double, std::string>;

/// A place: x to the right, y upwards, in any one unit of length.
struct Spot
{
  Moving x;  ///< To the right.
  Moving y;  ///< Upwards.
};

/// A body of a scene; made by the functions of `drawn`.
struct Body
{
  std::string kind;            ///< What the page draws it as.
  std::vector<Spot> at;        ///< Its place, or its joints.
  double radius = 0;           ///< Of what is round, in the unit of the places.
  Moving turn = 0.;            ///< Of a wheel: how far it has turned, in radians.
  std::string colour = "ink";  ///< One of figures/style.gp.
};

/// The bodies that there are. `colour` is the name of one in figures/style.gp.
namespace drawn
{
/// A straight line through joints: a rod, a thread, a beam.
Body rod(std::vector<Spot> joints, std::string colour = "ink");
/// A disc.
Body bob(Spot centre, double radius, std::string colour = "blue");
/// The way of a point through all the frames.
Body trail(Spot point, std::string colour = "grey");
/// A ring with a spoke from its centre, which hangs straight down at 0 and turns forwards (to the right
/// above).
Body wheel(Spot centre, double radius, Moving turn, std::string colour = "ink");
/// A level line.
Body ground(double y, std::string colour = "grey");
}  // namespace drawn

/// Declares a scene, which the page shows as `::: scene NAME`: `columns` as of a curve, the first of them
/// `t`, the time in seconds; a frame is a point, the frames in the order of their times, near enough to
/// each other that between them all may go evenly. The page shows the motion in true time and begins anew
/// after the last frame. The frames are a curve: checks can look at them by the scene's name. @throws
/// std::logic_error for a body with a column that there is not
void scene(const char* name, std::vector<Body> bodies, std::vector<std::string> columns,
           const Rule<void(Curve&)>& frames);

}  // namespace edition
