/// @file
/// The exchange of motion between the pans beyond the first order (C fixed): by averaging, and as it shows in a motion.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "balance/balance.hpp"

namespace balance
{

/// What the third order says of pans whose beam swings with the amplitude m (§31); λ/μ not near 2, 1/2 or 1/3.
struct Averaged
{
  double splitting;  ///< the frequency of η − ϑ less that of η + ϑ, ρμ³m²/(2(μ²−4λ²)), 1/s
  double shift;      ///< that of η + ϑ less μ, −(a/b)²λ⁴m²/(4μ(4μ²−λ²)), 1/s: Mathieu's
  double time;       ///< π over the size of the splitting: P's motion is then Q's; ∞ for m = 0 or ρ = 0
};

/// From the averaged quartic Lagrangian. @throws std::domain_error unless λ² > 0 and μ² > 0, and where a divisor vanishes
Averaged averaged(const Balance<>& b, double m);

/// A lone swinging pan, the beam at rest (§23): its motion may be unstable towards the other pan.
struct Lone_pan
{
  double beam;  ///< amplitude by which the pan drives the beam, ρμ²n²/(β(4μ²−λ²)), each of two oscillations
  double threshold;  ///< the ρ beyond which it is unstable, (4μ²−λ²)/(32μ²)
  double growth;     ///< rate at which the other pan's swings grow, 1/s; 0 where they do not
};

/// For the amplitude n. @throws std::domain_error unless λ² ≥ 0 and 4μ² > λ²
Lone_pan lone_pan(const Balance<>& b, double n);

/// Self-trapping (§38): of two pans that exchange their motion in the time π/(σ − μ), with amplitudes so great that a
/// pendulum's longer period matters.
struct Trapping
{
  double critical;  ///< the amplitude √(32|σ−μ|/μ) beyond which the exchange remains incomplete
  double
      ratio;  ///< transfer time to that of small swings, (2/π)K(k), k = (n/critical)²; ∞ at it, NaN beyond
  double reach;  ///< Q's greatest amplitude, in parts of n: 1 below, 1/√2 at it, √(½ − ½√(1 − 1/k²)) beyond
};

/// For the amplitude n. Errors of some ulps of n/critical. @throws std::domain_error unless μ > 0, splitting ≠ 0, n ≥ 0
Trapping trapping(double splitting, double mu, double n);

/// The same ratio by n/critical itself, which near 1 is what counts. NaN outside 0 to 1.
double trapping_ratio(double of_critical);

/// How far the pans swing about a moment.
struct Envelope
{
  double t;  ///< the moment
  double P;  ///< amplitude of η's part at μ
  double Q;  ///< of ϑ's
};

/// The envelopes at `parts` + 1 moments equally far apart from `window`/2 to `until` − `window`/2: from the motion
/// demodulated at μ, (η − iη̇/μ)e^(−iμt), in the mean over a window about the moment with the weights of a raised cosine,
/// so that the lines at μ ± λ and beyond are left out when the window holds two periods of the beam or more.
/// @throws std::domain_error and std::runtime_error as Motion does, or unless 0 < window < until and parts ≥ 1
std::vector<Envelope> envelopes(const Balance<>& b, const State<>& start, double until, double window,
                                int parts);

/// When Q first swings farthest, and how completely it has taken over.
struct Handover
{
  double time;  ///< of Q's first greatest amplitude
  double Q;     ///< that amplitude over P's first
  double P;     ///< P's then, over its first
};

/// From envelopes; the greatest is refined by a parabola. NaN throughout where Q's amplitude only rises or falls.
Handover handover(const std::vector<Envelope>& course);

/// The same two amplitudes about the moment `middle`, to judge envelopes(): by GSL (by_gsl() at 1e-12), in the plain mean of
/// `parts` moments. @throws as by_gsl() does. Precondition: middle ≥ window/2 > 0, parts ≥ 1
Envelope by_gsl_in_the_mean(const Balance<>& b, const State<>& start, double middle, double window,
                            int parts);

/// When Q leans farthest.
struct Farthest
{
  double time;  ///< the moment
  double Q;     ///< |ϑ| then
  double P;     ///< the greatest |η| within 32 steps of it
};

/// Of a course, at(t) being {η, ϑ} and t never going back, looked at in steps from 0 to `until`. Precondition: step > 0
template <class Course>
Farthest farthest(Course at, double until, double step)
{
  std::vector<std::array<double, 2>> all;
  for(int k = 0; k * step <= until; ++k)
    all.push_back(at(k * step));
  std::size_t best = 0;
  for(std::size_t k{0}; k < all.size(); ++k)
    if(std::abs(all[k][1]) > std::abs(all[best][1]))
      best = k;
  double P = 0;
  for(std::size_t k = best - std::min<std::size_t>(best, 32); k < std::min(all.size(), best + 32); ++k)
    P = std::max(P, std::abs(all[k][0]));
  return {static_cast<double>(best) * step, std::abs(all[best][1]), P};
}

}  // namespace balance
