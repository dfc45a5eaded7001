/// @file
/// The motion of the balance by integration of the exact equations: GSL's pair of Runge, Kutta, Prince and
/// Dormand of the eighth order for use, the classical rule with equal steps to compare, twenty digits to
/// judge both.
#pragma once

#include <memory>
#include <vector>

#include "balance/balance.hpp"

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
  /// The balance `b` in the state `start` at t = 0. Each step's error is kept below `tolerance`, absolutely
  /// for small angles and rates and relatively for great ones.
  /// @throws std::domain_error unless μ² > 0, β > 0, 0 ≤ ρ < ½, everything is finite and 1e-15 ≤ tolerance
  /// ≤ 0.1
  explicit Motion(const Balance<>& b, const State<>& start, double tolerance = 1e-13);
  ~Motion();
  /// It may be moved, not copied.
  /// @{
  Motion(Motion&&) noexcept;
  Motion& operator=(Motion&&) noexcept;
  /// @}

  /// The state at the time t, in seconds, which must not lie before the last one asked for. With tolerance
  /// 1e-13 the angles of Euler's example err by less than 1e-12 until t = 30.
  /// @throws std::invalid_argument if t is not finite or lies before
  /// @throws std::runtime_error if the steps become too small to go on
  const State<>& to(double t);

  /// |E/E₀ − 1| at the last time asked for; |E − E₀| where E₀ is zero (at rest, everything hanging straight
  /// down).
  double energy_drift() const;

private:
  struct Inner;
  std::unique_ptr<Inner> inner_;
};

/// The states at `parts` + 1 moments equally far apart, from 0 to `until`, with the tolerance 1e-13.
/// @throws std::domain_error and std::runtime_error as Motion does. Precondition: parts ≥ 1, until ≥ 0
std::vector<State<>> course(const Balance<>& b, const State<>& start, double until, int parts);

/// The state at the time t by the classical Runge–Kutta rule of the fourth order in `steps` equal steps.
/// Its error falls as steps⁻⁴. @throws std::invalid_argument unless steps ≥ 1
State<> runge_kutta(const Balance<>& b, const State<>& start, double t, int steps);

/// The state at the time t with an error below 1e-18, for exactly the doubles given: the oracle for the others.
/// Takes some 30 ms a second of motion in Euler's example, more for wild motions.
/// @throws std::runtime_error if even steps good to 1e-34 do not suffice
State<exact::Fifty> oracle(const Balance<>& b, const State<>& start, double t);

}  // namespace balance
