/// @file
/// The inner loops over arrays, compiled once for each instruction set and chosen when the program runs.
///
/// All variants are made from one source (kernels.cpp) out of + − × ÷ and shifts of bits alone, without
/// contraction, so that each gives the same bits; only how many numbers are worked on at once differs.
#pragma once

#include <cstddef>

namespace swing::kernels
{

/// The motion prepared for asking: what Motion computes once. See motion.cpp for how, kernels.cpp for what it
/// is.
struct Prepared
{
  double f_hi = 0;       ///< half swings (or half turns) per unit of time, the leading double
  double f_head = 0;     ///< its upper 26 bits
  double f_tail = 0;     ///< f_hi − f_head
  double f_lo = 0;       ///< what f_hi lacks, to 107 bits in all
  double reach = 0x1p50; ///< as many half swings can be told apart

  double d[3] = {};       ///< θ₃/θ₃(0) = 1 + d[0] x + d[1] x² + d[2] x³, x = (sin z / π)²
  double n[2] = {};       ///< θ₁/sin z in the same form
  double p[3] = {};       ///< what the second exceeds the first by, divided by x
  double log_q = 0;       ///< −ln q' of the dual nome: the argument of the hyperbolic form per half swing
  double log_q_head = 0;  ///< its upper 26 bits
  double log_q_tail = 0;  ///< the rest of it
  double root_q = 0;      ///< √q'
  double q = 0;           ///< q'
  double angle_scale = 0; ///< factor of tan ½Φ
  double velocity_scale = 0;      ///< factor of Φ'
  double angle_scale_lost = 0;    ///< what the first was rounded by, relative to it
  double velocity_scale_lost = 0; ///< what the second was rounded by, relative to it
};

/// The six courses a motion can take, each with its own formula.
enum Course : int
{
  low,            ///< swinging, ζ ≤ 90°, the clock started at the bottom
  low_from_rest,  ///< the same started at rest
  high,           ///< swinging, ζ > 90°
  high_from_rest, ///< the same started at rest
  fast,           ///< revolving, with at least twice the energy that just reaches the top
  barely          ///< revolving with less
};

/// One of the instruction sets, with all loops compiled for it. `in` and `out` have n elements.
struct Table
{
  const char* name; ///< "sse2", "avx2", "avx512" (or "portable" where there is but one)

  using Loop = void (*)(const double* in, double* out, std::size_t n);
  Loop K;                 ///< of k
  Loop K_from_complement; ///< of kc
  Loop ratio;             ///< of ζ
  Loop ratio_from_top;    ///< of η

  /// Loops of times.
  using Motion = void (*)(const Prepared& p, const double* t, double* out, std::size_t n);
  /// What is asked of a motion.
  struct Questions
  {
    Motion angle;    ///< Φ
    Motion velocity; ///< Φ'
    Motion from_top; ///< the angle from the top, π − |Φ| in the first swing
  };
  Questions motion[6]; ///< by Course
};

/// How many variants this processor can run, from the plainest to the widest; at least one.
std::size_t count();

/// The variant number i < count().
const Table& variant(std::size_t i);

/// The widest.
const Table& best();

} // namespace swing::kernels
