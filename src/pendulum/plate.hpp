/// @file
/// The lines of which Euler's plate is drawn. The axis A is the origin, y points upwards, angles
/// are counted from the lowest point to the right, in radians. Each piece is followed by a gap, so
/// that a figure's script can pick the i-th by `every :::i::i`.
#pragma once

#include <cmath>

#include "edition/section.hpp"

namespace pendulum
{

/// A point of the plate.
struct Point
{
  double x;  ///< to the right of A
  double y;  ///< above A
};

/// The point at a distance from A, on the line that makes the angle phi with the vertical.
inline Point at(double distance, double phi)
{
  return {distance * std::sin(phi), -distance * std::cos(phi)};
}

/// A straight line.
inline void line(edition::Curve& c, Point from, Point to)
{
  c.put({from.x, from.y});
  c.put({to.x, to.y});
  c.gap();
}

/// An arc about A, in a hundred pieces.
inline void arc(edition::Curve& c, double radius, double from, double to)
{
  for(int i = 0; i <= 100; ++i)
  {
    const Point p = at(radius, from + (to - from) * i / 100);
    c.put({p.x, p.y});
  }
  c.gap();
}

}  // namespace pendulum
