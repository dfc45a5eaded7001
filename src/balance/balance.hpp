/// @file
/// The balance with two hanging pans: equations of motion, energy, and what becomes of them for small
/// swings.
///
/// A beam turns about a fixed point C; from its ends A and B, in line with C, two equal pans hang by
/// strings. In Euler's letters ω is the inclination of the beam (positive when A is lifted), η that of the
/// string AP and ϑ that of BQ, both counted from the vertical towards the side of A, all in radians. Times
/// are in seconds; g is the height fallen in the first second, so that 2g is today's acceleration of
/// gravity.
///
/// The motion depends on four numbers only. With I = M(kk+cc) + 2Laa they are
///
///     λ² = 2gMc/I    the beam's frequency, the pans fixed to its ends; negative when G lies above C
///     μ² = 2g/b      each pan's frequency, the beam being held
///     β = a/b        arm to string
///     ρ = Laa/I      the share of one pan in the inertia, 0 ≤ ρ < ½
///
/// and Euler's i (§33) is ½βλ. The exact formulae are templates, the same for doubles and for fifty digits.
#pragma once

#include <cmath>

#include "elementary/circular.hpp"
#include "exact/fifty.hpp"

/// The motion of a balance with two hanging pans.
namespace balance
{

/// Three angles, or their rates, or their accelerations.
template <class Number = double>
struct Angles
{
  Number omega{};  ///< the beam
  Number eta{};    ///< the pan P, which hangs from A
  Number theta{};  ///< the pan Q, which hangs from B
};

/// Where the balance is and how fast it moves.
template <class Number = double>
struct State
{
  Angles<Number> at;    ///< in radians
  Angles<Number> rate;  ///< in radians a second
};

/// A balance, in the four numbers that its motion depends on.
template <class Number = double>
struct Balance
{
  Number lambda2{};  ///< λ², 1/s²
  Number mu2{};      ///< μ², 1/s²
  Number beta{};     ///< a/b
  Number rho{};      ///< Laa/I
};

/// A balance as a maker of instruments gives it, in any consistent units (Euler: English feet, seconds,
/// weights).
struct Instrument
{
  double a;   ///< CA = CB, half the beam
  double b;   ///< AP = BQ, the strings
  double c;   ///< CG, how far the beam's centre of gravity lies below C; negative if above
  double kk;  ///< the square of the beam's radius of gyration about G
  double L;   ///< weight of each pan
  double M;   ///< weight of the beam with all that is fixed to it
  double g;   ///< height fallen in the first second
};

/// The four numbers of an instrument, each to some four ulps.
/// @throws std::domain_error unless a, b, M, g > 0, kk, L ≥ 0, kk + c² > 0, and all of it is finite
Balance<> numbers_of(const Instrument& instrument);

// [accelerations]
/// The accelerations of the three angles, without any approximation.
///
/// Source: the Lagrangian of §6's coordinates; that is, Euler's five equations (§7–9) without the two
/// tensions. The divisor 1 − ρ(s₁² + s₂²) is at least 1 − 2ρ > 0.
template <class Number>
Angles<Number> accelerations(const Balance<Number>& b, const State<Number>& now)
{
  using elementary::cos;
  using elementary::sin;
  const auto& [at, rate] = now;
  const Number s1 = sin(at.omega - at.eta), c1 = cos(at.omega - at.eta);
  const Number s2 = sin(at.omega - at.theta), c2 = cos(at.omega - at.theta);
  const Number centripetal = b.beta * rate.omega * rate.omega;
  // what the pans would do if the beam turned uniformly
  const Number eta = -b.mu2 * sin(at.eta) + centripetal * c1;
  const Number theta = -b.mu2 * sin(at.theta) - centripetal * c2;
  const Number pull = s1 * eta - c1 * rate.eta * rate.eta - s2 * theta + c2 * rate.theta * rate.theta;
  const Number free = -b.lambda2 * sin(at.omega) + b.rho / b.beta * pull;
  const Number omega = free / (1 - b.rho * (s1 * s1 + s2 * s2));
  return {omega, eta + b.beta * omega * s1, theta - b.beta * omega * s2};
}

// [accelerations]

/// The energy divided by I (1/s²), zero at rest with everything hanging straight down. It keeps its value.
template <class Number>
Number energy(const Balance<Number>& b, const State<Number>& now)
{
  using elementary::sin;
  const auto& [at, rate] = now;
  const auto height = [](const Number& x) { return 2 * sin(x / 2) * sin(x / 2); };  // 1 − cos x
  const Number speeds = rate.eta * rate.eta + rate.theta * rate.theta;
  const Number heights = height(at.eta) + height(at.theta);
  const Number coupled = rate.theta * sin(at.omega - at.theta) - rate.eta * sin(at.omega - at.eta);
  const Number beam = rate.omega * rate.omega / 2 + b.lambda2 * height(at.omega);
  return beam + b.rho / (b.beta * b.beta) * (speeds / 2 + b.mu2 * heights + b.beta * rate.omega * coupled);
}

/// The motion for very small angles: three pendulums that know nothing of each other, because at first
/// order the ends of the beam move only up and down. ω swings with λ (for λ² < 0 it grows as a hyperbolic
/// cosine), η and ϑ with μ. Error: a few ulps of the greatest angle, and those of the phase λt or μt.
Angles<> small_motion(const Balance<>& b, const State<>& start, double t);

/// The same balance with the period of its pans longer by the factor 1 + nn/16, as that of any pendulum of the
/// amplitude n is to the second order of n (radians).
inline Balance<> with_longer_period(Balance<> b, double n)
{
  b.mu2 /= (1 + n * n / 16) * (1 + n * n / 16);
  return b;
}

/// The excursion at the time t of an oscillator of frequency q, at rest for t = 0, that is driven by cos
/// pt: (cos pt − cos qt)/(q² − p²), the solution of x″ + q²x = cos pt, and its limit t sin(qt)/(2q) for p =
/// q. Nothing is lost when p and q are near: error a few ulps of min(½t², 1/|q² − p²|), and those of the
/// phases.
double driven(double q, double p, double t);

/// The motion from rest at (m, n, n′), complete to the second order of the angles; the third is missing.
///
/// Of what it adds to small_motion(), Euler's solution (§33) has the forced part of the product term alone:
/// not its free part, not the term of A's and B's arc, and nothing for the beam. Precondition: λ² ≥ 0, else
/// NaN.
/// Source: perturbation of the cubic Lagrangian Lab[(½ω²)″(η − ϑ) − ½ω̈(η² − ϑ²)].
Angles<> second_order(const Balance<>& b, const Angles<>& released, double t);

}  // namespace balance
