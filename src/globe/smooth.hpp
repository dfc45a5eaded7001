/// @file
/// The ball on a smooth plane, Part I of the paper: times, angles and pressure at any energy.
///
/// Times are Euler's τ = t√(2gc), a length; c ≥ 0 and k > 0 are the ball's, and c at most 10⁹ k. See energy.hpp
/// for h and for how a place is given.
///
/// The integral of §13 is hyperelliptic. Here its first part, k times the pendulum's own time υ with the same
/// h, is Carlson's R_F, and what is left is finite up to the top:
///
///     τ = kυ + ∫ 4cc vv √(1−vv) dv / ((k + √(kk + 4cc vv(1−vv))) √(h−vv)),   v = sin ½Φ.
///
/// Where a quantity is also there for exact::Fifty, it is by the same lines, with the integral to forty digits.
/// Errors in double are in ulps for the c, k, h and angles given, measured against fifty digits
/// (tests/globe_smooth.cpp).
#pragma once

#include <span>

#include "globe/energy.hpp"

/// The ball without friction.
namespace globe::smooth
{

/// The time from the lowest place to rest (h < 1), or over half a turn (h > 1); +∞ at h = 1.
/// Domain: c ≥ 0, k > 0, c ≤ 10⁹ k; else std::domain_error. Error in double: 8 ulps.
/// Source: for c ≤ 3k the trapezoidal rule in υ, doubled until it stands still, its nodes by the formulae of
/// half the argument; for larger c the integral above.
template <class Real>
Real quarter(const Real& c, const Real& k, const Energy<Real>& e);

/// quarter() over ½πk, less one: by how much a swing is longer than a very small one, without cancellation.
/// Domain: h < 1, and c ≤ 100 k; else std::domain_error. Error in double: 8 ulps.
double excess(double c, double k, const Energy<double>& e);

/// The time from the lowest place up to another. +∞ at the top when h = 1.
/// Domain: as quarter(), and the ball gets there: sin² ½Φ ≤ h; else std::domain_error. Error in double: 8 ulps
/// of the time, and near rest what an ulp of the place makes of it.
template <class Real>
Real time(const Real& c, const Real& k, const Energy<Real>& e, const Place<Real>& place);

/// The inverse: where the ball is at the time τ, having been at the lowest place at τ = 0, turning forwards.
/// Domain: as quarter(), |τ| below 10⁹ quarters; else std::domain_error. The angle, and near the top what it
/// lacks, are those of τ within 10 ulps.
Turned angle(double c, double k, const Energy<double>& e, double tau);

/// Arrays, bit for bit as one by one. Throw as those do, and std::invalid_argument for spans that differ.
/// @{
void quarter(double c, double k, std::span<const Energy<double>> e, std::span<double> out);
void time(double c, double k, const Energy<double>& e, std::span<const Place<double>> place,
          std::span<double> out);
void angle(double c, double k, const Energy<double>& e, std::span<const double> tau, std::span<Turned> out);
/// @}

/// The one other energy at which the integral of §13 is elliptic, h₀ = ½(1 + √(1 + kk/cc)), and the time of
/// half a turn with it.
template <class Real>
struct Second_energy
{
  Real h;          ///< h₀ > 1, and below the limit of lift_off()
  Real half_turn;  ///< τ
};

/// Domain: c > 0, k > 0; else std::domain_error. Error in double: 8 ulps.
template <class Real>
Second_energy<Real> second_energy(const Real& c, const Real& k);

/// Π/P: what the plane bears, as a part of the weight. Negative where the formula has left the plane.
/// The place may be any the ball gets to. Rounding: 8 ulps of the largest summand, which is below 2 + 4hcc/kk.
template <class Real>
Real pressure(const Real& c, const Real& k, const Energy<Real>& e, const Place<Real>& place);

/// (dΦ/dτ)²: the square of the angular velocity over 2gc, 4(h − sin² ½Φ)/(kk + cc sin² Φ).
template <class Real>
Real velocity_squared(const Real& c, const Real& k, const Energy<Real>& e, const Place<Real>& place);

/// Where the ball leaves the plane.
template <class Real>
struct Lift_off
{
  Real Phi;       ///< the angle, above a right one
  Real from_top;  ///< π − Φ
  Real tau;       ///< the time since the lowest place
  Real w;         ///< dΦ/dτ there
};

/// The least h with which it does, 1 + kk/4cc; with just that much it is without pressure at the top.
template <class Real>
Real lift_off_energy(const Real& c, const Real& k);

/// Where and when, the energy given by what h exceeds lift_off_energy(), more than 0.
/// Domain: c > 0, k > 0; else std::domain_error. Error in double: 8 ulps each.
template <class Real>
Lift_off<Real> lift_off(const Real& c, const Real& k, const Real& excess);

/// @name Euler's Case III (§§21-22): fast turning, ζζkk = 4gcnn with n large
/// 2n t√gc = Φ(k + cc/4k + k/2nn) − (cc/8k) sin 2Φ − (k/2nn) sin Φ, τ being t√2gc. Domain: k, n > 0.
/// @{
// [fast]
/// τ by his formula, for any Φ.
template <class Real>
Real fast_time_by_euler(const Real& c, const Real& k, const Real& n, const Real& Phi)
{
  using std::sin, std::sqrt;
  const Real root_half = 1 / sqrt(Real(2));
  const Real q = c * (c / k), m = k / (n * n);
  return root_half / n * (Phi * (k + q / 4 + m / 2) - q / 8 * sin(2 * Phi) - m / 2 * sin(Phi));
}

/// The two inequalities, as parts of the mean motion: M = Φ − e1 sin Φ − e2 sin 2Φ, M growing as the time.
template <class Real>
struct Inequalities
{
  Real e1;  ///< of the first
  Real e2;  ///< of the second
};
template <class Real>
Inequalities<Real> inequalities(const Real& c, const Real& k, const Real& n)
{
  const Real q = c * (c / k), m = k / (n * n), mean = k + q / 4 + m / 2;
  return {m / 2 / mean, q / 8 / mean};
}
// [fast]

/// The Φ of a mean anomaly M, by Newton's method. Domain: e1 + 2 e2 < ½, else std::domain_error. Error in
/// double: 4 ulps.
template <class Real>
Real anomaly(const Inequalities<Real>& e, const Real& M);
/// @}

}  // namespace globe::smooth
