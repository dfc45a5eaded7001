/// @file
/// A pan under a beam that swings whatever the pans do (§15): Mathieu's equation, its exponents from its own solutions,
/// its characteristic values from a matrix of its own.
///
/// With ω = m cos λt and p = am/b the pan P has y″ = −(μ² − pλ² cos λt) y, which is Mathieu's equation in z = ½λt with
/// a = 4μ²/λ² and q = 2p. Q has −p, that is P half a period later.
#pragma once

#include <span>
#include <vector>

namespace balance
{

/// The equation, in its three numbers.
struct Prescribed_beam
{
  double mu;      ///< the pan's frequency, 1/s
  double lambda;  ///< the beam's, 1/s
  double p;       ///< am/b: by how much A's acceleration changes the pan's weight, in units of λ²/μ²
};

/// What becomes of a pan in the long run.
struct Floquet
{
  double q;           ///< 2p, Mathieu's
  double a;           ///< 4μ²/λ², Mathieu's
  double half_trace;  ///< of the change of (y, y′) in a period of the beam; beyond ±1 the pan's swings grow
  double frequency;  ///< mean frequency, 1/s; where the swings grow, the multiple of ½λ that they keep to
  double shift;      ///< frequency − μ, to full relative precision where the swings do not grow
  double growth;     ///< rate at which they grow, 1/s; 0 where they do not
};

/// From two solutions over half a period of the beam, integrated to rounding, and the recurrence between the lines of the
/// spectrum. Relative errors below 1e-10 (tests/balance_linear.cpp) for |p| ≤ 1 and μ ≤ 20 λ.
/// @throws std::domain_error unless μ, λ > 0 and all is finite; std::runtime_error if the equation cannot be integrated
Floquet floquet(const Prescribed_beam& of);

/// ½(1 ∓ half trace) of the change of (y, y′) in a period of the beam, as products of what the two solutions with y₁ = 1,
/// y₁′ = 0 and y₂ = 0, y₂′ = 1 where the beam is farthest out are after half of it.
struct Halves
{
  double sine2;  ///< sin² of half the phase gained in a period, −y₁′y₂; negative where the swings grow
  double cosine2;  ///< cos² of it, y₁y₂′; negative where they grow, in the intervals of odd order

  /// Half the trace.
  double half_trace() const { return cosine2 - sine2; }
  /// Whether the swings grow.
  bool growing() const { return sine2 < 0 || cosine2 < 0; }
};

/// The same at a point (a, q) of the stability chart, for maps of it: by power series in sin² ½λt, a hundred times as quick
/// as GSL integrates, and quicker yet for many points at a time, which have the bits that they have alone. Errors,
/// absolute, or relative to a half trace beyond 1, measured against forty digits at 3900 points: 3e-14 for a ≤ 36, 1e-13
/// for a ≤ 100, 1e-10 for a ≤ 400 (tests/balance_linear.cpp).
/// @throws std::domain_error unless 0 ≤ a ≤ 400 and |q| ≤ 8; std::invalid_argument unless there are as many of each
/// @{
Halves halves(double a, double q);
void halves(std::span<const double> a, std::span<const double> q, std::span<Halves> at);
/// @}

/// A pan's place and speed.
struct Pan
{
  double y;     ///< its inclination
  double rate;  ///< in 1/s
};

/// The pan at the time t, from `start` at t = 0 when the beam is farthest out: whole periods by powers of the change in
/// one, the rest by integration.
/// @throws std::domain_error as floquet() does, or unless 0 ≤ t < 10⁶ periods of the beam
Pan pan_under(const Prescribed_beam& of, const Pan& start, double t);

/// The moment number k of `many`, from 0, in the last fifth of the time from 0 to `until`: one in each of `many` equal parts
/// of it, each at another place of its part, by the golden section, so that they keep step with no rhythm of the motion.
/// Precondition: 0 ≤ k < many
inline double late_moment(int k, int many, double until)
{
  const double place = k * 0.6180339887498949;
  return until * (0.8 + 0.2 * (k + (place - static_cast<int>(place))) / many);
}

/// A characteristic value of Mathieu's equation y″ + (a − 2q cos 2z) y = 0 with its function.
struct Characteristic
{
  double value;  ///< a
  std::vector<double>
      coefficients;  ///< of cos or sin of the angles 2k z or (2k+1) z, from the lowest, squares adding up
                     ///< to 1 (the first of the even cosines doubled); the function is positive at 0, or
                     ///< rises there
  int first;         ///< the lowest multiple of z: 0, 1 or 2
  double residual;   ///< the length of what the equation leaves of them
};

/// aₙ(q), of cosines, n ≥ 0; bₙ(q), of sines, n ≥ 1: the eigenvalues of a symmetric tridiagonal matrix (Eigen). Absolute
/// error below 1e-11 for n ≤ 40, |q| ≤ 10⁴; relative to the largest of 1, n², q below 1e-14.
/// @throws std::domain_error unless 0 ≤ n ≤ 200 (1 ≤ n for sines) and |q| ≤ 10⁶
/// @{
Characteristic cosine_characteristic(int n, double q);
Characteristic sine_characteristic(int n, double q);
/// @}

/// Between which beam frequencies λ a pan's swings grow.
struct Interval
{
  double from;  ///< in 1/s
  double to;    ///< in 1/s
};

/// The interval about λ = 2μ/order, for order 1, 2, …; q does not depend on λ, so that its ends are 2μ/√a and 2μ/√b.
/// @throws std::domain_error unless order ≥ 1, μ > 0, |p| < ½ and all is finite
Interval unstable(double mu, double p, int order);

}  // namespace balance
