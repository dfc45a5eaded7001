/// @file
/// The pendulum as the page shows it moving.
#pragma once

#include "swing/motion.hpp"

namespace pendulum
{

/// Declares the scene `name`: a pendulum of length 1 that is let go at Φ = ζ and swings for one period.
/// `unit` is √b/√(2g) in seconds. Columns: t in seconds, phi in radians, and the bob's place x, y. Domain:
/// 0 < ζ < π.
void scene_of_swing(const char* name, const swing::Amplitude& amplitude, double unit);

}  // namespace pendulum
