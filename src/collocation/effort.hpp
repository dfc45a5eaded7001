/// @file
/// What it costs to follow a motion.
#pragma once

namespace collocation
{

/// What the following costs and what it is to cost.
struct Effort
{
  double tolerance = 1e-16;  ///< error allowed in a step, relative to the velocities
  long steps = 0;            ///< made
  long rejected = 0;         ///< tried in vain
  long sweeps = 0;           ///< in all: each evaluates the accelerations at eight moments
};

}  // namespace collocation
