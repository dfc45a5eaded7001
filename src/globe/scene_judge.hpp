/// @file
/// What the frames of scene.hpp are judged by: the equations of motion of §§6-9, in fifty digits.
#pragma once

#include <vector>

#include "edition/told.hpp"
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
std::vector<Judged_ball> judged(const std::vector<edition::ToldRow>& frames, Plane plane,
                                const Ball<exact::Fifty>& given, const exact::Fifty& g,
                                const exact::Fifty& Phi, const exact::Fifty& w, const exact::Fifty& f = 0);

}  // namespace globe
