/// @file
/// Times of the ball that have a closed form, in Euler's natural measure τ = t√(2gc), which is a length.
#pragma once

#include <cmath>
#include <span>

#include "exact/fifty.hpp"

namespace globe
{

// [by_euler]
/// Euler's time τ = t√(2gc) in Case II (§17), until the centre of gravity stands at the angle 2ω from the
/// highest place. Domain: as separatrix_time(). It is too long, by less than the next term of his expansion.
/// Real: double (to 3 ulps) or exact::Fifty.
template <class Real>
Real separatrix_time_by_euler(const Real& c, const Real& k, const Real& omega)
{
  using std::asinh, std::cos, std::tan;
  const Real v = cos(omega);
  return 2 * c * (c / k) / 3 * v * v * v + k * asinh(1 / tan(omega));  // arsinh cot ω = −l tan ½ω
}

/// The next term, −(2c⁴/k³)(cos⁵ω/5 − cos⁷ω/7).
template <class Real>
Real separatrix_next_term(const Real& c, const Real& k, const Real& omega)
{
  using std::cos;
  const Real v = cos(omega), r = c / k;
  return -2 * c * r * r * r * v * v * v * v * v * (1 / Real(5) - v * v / 7);
}
// [by_euler]

/// On a smooth plane, with just the velocity that the top asks for (ζζkk = 8gc, Euler's Case II): the time τ
/// = t√(2gc) from the lowest position until the centre of gravity stands at the angle 2ω from the highest.
///
/// Domain: k > 0, 0 ≤ c ≤ 10⁶ k, 0 < ω ≤ π/2; else std::domain_error. Error in double: 4 ulps where c ≤ 1.2 k,
/// else 10, for ω from 10⁻³⁰⁰ to 1.5.
///
/// Source: k arsinh cot ω and the integral that is left by Gauss's rule, 16 nodes for c ≤ ½k and 32 for c ≤ 1.2k.
/// For larger c, and in fifty digits, separatrix_time_by_carlson().
template <class Real>
Real separatrix_time(const Real& c, const Real& k, const Real& omega);

/// Of an array of ω, bit for bit as one by one. Throws as that does, and std::invalid_argument for spans that
/// differ in length.
void separatrix_time(double c, double k, std::span<const double> omega, std::span<double> tau);

/// The same in closed form, for any c. Domain as separatrix_time(); error 10 ulps.
///
/// Source: with v = cos ω, q = 1 + 4ccvv/kk, B = (2c/kk)(√(cc+kk) + c), X = (1 + B sin²ω)/(1 + B), Z = 1 +
/// Bvv,
///
///     τ = k arsinh(cot ω/√q) + (4cc/3k) v³ (R_J(1, X, Z, q) + R_D(X, Z, 1)),
///
/// from the integral of §13 by Carlson's relation between two R_J of conjugate fourth arguments, which moves
/// all that is infinite at the top into the first term.
double separatrix_time_by_carlson(double c, double k, double omega);

/// The inverse: the ω of Case II at the time τ, π/2 at the start.
///
/// Domain: k > 0, 0 ≤ c ≤ 10⁶ k, 0 ≤ τ < 690 k, where ω is still above 10⁻³⁰⁰; else std::domain_error. The
/// time of the result is τ within 20 ulps and what the last place of ω makes of it.
///
/// Source: halving in x = arsinh cot ω, since dτ/dx = √(kk + cc sin²Φ) lies between k and √(kk + cc).
double separatrix_angle(double c, double k, double tau);

/// @cond
template <>
double separatrix_time(const double& c, const double& k, const double& omega);
template <>
exact::Fifty separatrix_time(const exact::Fifty& c, const exact::Fifty& k, const exact::Fifty& omega);
/// @endcond

}  // namespace globe
