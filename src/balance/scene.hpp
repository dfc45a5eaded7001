/// @file
/// The balance as the page shows it moving. As in the figure of §6 the end A with the pan P is on the left.
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "balance/hung.hpp"
#include "balance/motion.hpp"

namespace balance
{

/// Where the joints are, to the right and upwards from O, in the unit of the lengths.
template <class Number>
struct Joints
{
  Number C_x;  ///< the pivot
  Number C_y;  ///< the pivot
  Number A_x;  ///< P's end of the beam
  Number A_y;  ///< P's end of the beam
  Number B_x;  ///< Q's end
  Number B_y;  ///< Q's end
  Number P_x;  ///< the pan P
  Number P_y;  ///< the pan P
  Number Q_x;  ///< the pan Q
  Number Q_y;  ///< the pan Q
};

/// From the angles of shears of the length h, a beam of two arms a in line with C, and strings of the length
/// b.
template <class Number>
Joints<Number> joints(const Number& h, const Number& a, const Number& b, const Number& phi,
                      const Number& omega, const Number& eta, const Number& theta)
{
  using std::cos, std::sin;
  Joints<Number> j{};
  j.C_x = -h * sin(phi);
  j.C_y = -h * cos(phi);
  j.A_x = j.C_x - a * cos(omega);
  j.A_y = j.C_y + a * sin(omega);
  j.B_x = j.C_x + a * cos(omega);
  j.B_y = j.C_y - a * sin(omega);
  j.P_x = j.A_x - b * sin(eta);
  j.P_y = j.A_y - b * cos(eta);
  j.Q_x = j.B_x - b * sin(theta);
  j.Q_y = j.B_y - b * cos(theta);
  return j;
}

/// The joints by the names of a scene's columns.
std::array<std::pair<const char*, double>, 10> by_name(const Joints<double>& j);

/// Declares the scene `name`: the balance on its shears, in its own lengths. 24 frames in a turn of the fastest mode, at
/// least 240, at most 2000, and no longer than `until` seconds nor than so many frames reach; an `until` of 0 has no
/// scene. Columns: t, and the joints C_x to Q_y. `fastest` is the frequency of its fastest mode. Domain: as
/// Full_motion.
void scene_on_shears(const char* name, const Suspended& s, const Full_state& start, double until,
                     double fastest);

/// The same of the balance whose pivot stands still, the strings of the length 1 and O in C. Domain: as Motion.
void scene_on_pivot(const char* name, const Balance<>& b, const State<>& start, double until);

}  // namespace balance
