/// @file
/// The motion of the balance by integration of the exact equations: Gauss' collocation for use
/// (collocation/motion.hpp), GSL's pair of Runge, Kutta, Prince and Dormand and the classical rule with equal steps to
/// compare, twenty digits to judge all three.
#pragma once

#include <memory>
#include <vector>

#include "balance/balance.hpp"
#include "collocation/effort.hpp"

namespace balance
{

/// A balance let go from rest.
inline State<> released(double omega, double eta, double theta)
{
  return {{omega, eta, theta}, {}};
}

/// A motion under way, carried on from time to time.
class Motion
{
public:
  /// The balance `b` in the state `start` at t = 0. Each step's error is kept below `tolerance`, relatively to the
  /// rates; the estimate is a cautious one.
  /// @throws std::domain_error unless μ² > 0, β > 0, 0 ≤ ρ < ½, everything is finite and 1e-24 ≤ tolerance
  /// ≤ 0.01
  explicit Motion(const Balance<>& b, const State<>& start, double tolerance = 1e-14);
  ~Motion();
  /// It may be moved, not copied.
  /// @{
  Motion(Motion&&) noexcept;
  Motion& operator=(Motion&&) noexcept;
  /// @}

  /// The state at the time t, in seconds, which must not lie before the last one asked for. In Euler's example (§36) the
  /// angles err by less than 1e-13 until t = 1000; what is found does not depend on which times were asked for before.
  /// @throws std::invalid_argument if t is not finite or lies before
  /// @throws std::runtime_error if the steps become too small to go on
  const State<>& to(double t);

  /// |E/E₀ − 1| at the last time asked for; |E − E₀| where E₀ is zero (at rest, everything hanging straight
  /// down).
  double energy_drift() const;

  /// What the motion has cost so far.
  const collocation::Effort& effort() const;

private:
  struct Inner;
  std::unique_ptr<Inner> inner_;
};

/// The states at `parts` + 1 moments equally far apart, from 0 to `until`, with the tolerance 1e-14.
/// @throws std::domain_error and std::runtime_error as Motion does. Precondition: parts ≥ 1, until ≥ 0
std::vector<State<>> course(const Balance<>& b, const State<>& start, double until, int parts);

/// How many times a slight change of the three angles at the start has grown until the time t, in the angle where it
/// has grown most, the greatest of 100 moments equally far apart: at least 1. By as many times what is rounded in the
/// beginning is magnified. @throws std::domain_error and std::runtime_error as Motion does. Precondition: t ≥ 0
double parting(const Balance<>& b, const State<>& start, double t);

/// The greatest of `until`, its half, its quarter and so on until which parting() is at most `most`: so long a motion told
/// in doubles is the motion of the balance, not of how the start was rounded.
/// @throws std::domain_error and std::runtime_error as Motion does. Precondition: until ≥ 0, most > 1
double sure_until(const Balance<>& b, const State<>& start, double until, double most);

/// The state at the time t by GSL's rk8pd, which keeps its estimate of each step's error below `tolerance`, absolutely for
/// small numbers and relatively for great ones.
/// @throws std::domain_error as Motion does, for 1e-15 ≤ tolerance ≤ 0.1; std::runtime_error if GSL gives up
State<> by_gsl(const Balance<>& b, const State<>& start, double t, double tolerance);

/// The state at the time t by the classical Runge–Kutta rule of the fourth order in `steps` equal steps.
/// Its error falls as steps⁻⁴. @throws std::invalid_argument unless steps ≥ 1
State<> runge_kutta(const Balance<>& b, const State<>& start, double t, int steps);

/// The state at the time t with an error below 1e-18, for exactly the doubles given: the oracle for the others.
/// Takes some 30 ms a second of motion in Euler's example, more for wild motions.
/// @throws std::runtime_error if even steps good to 1e-34 do not suffice
State<exact::Fifty> oracle(const Balance<>& b, const State<>& start, double t);

}  // namespace balance
