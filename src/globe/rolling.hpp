/// @file
/// The ball that rolls without scraping, Part II of the paper: times, the friction that it needs, what the plane
/// bears, and how far that goes.
///
/// Times are τ = t√(2gc), a length. Where c is nearly a all hangs on a − c, which Ball carries. Of the ball a, c, k > 0 are asked for, a and c ≤ 10²⁰ b, b < 10¹³⁰; c may exceed a (a cradle
/// whose base has a small radius). See energy.hpp for h and for how a place is given.
///
/// `Real` is double or exact::Fifty. Errors in double are in ulps for the ball, energy and place given, measured
/// against fifty digits (tests/globe_rolling.cpp).
#pragma once

#include <span>
#include <vector>

#include "globe/energy.hpp"

/// The ball that rolls.
namespace globe::rolling
{

/// Throws std::domain_error unless a, c, k > 0, a and c ≤ 10²⁰ b and b < 10¹³⁰.
template <class Real>
void require(const Ball<Real>& ball);

/// The time from the lowest place up to another, in every regime by one formula: with ϖ = sin² ½Φ
///
///     τ = b √(ϖ/h) (R_F(1 − ϖ/h, 1 − ϖ, 1 + 4acϖ/bb) + (4acϖ/3bb) R_J(the same, 1)).
///
/// +∞ at the top when h = 1. Domain: sin² ½Φ ≤ h; else std::domain_error. Error in double: 8 ulps, and near rest
/// what an ulp of the place makes of it.
template <class Real>
Real time(const Ball<Real>& ball, const Energy<Real>& e, const Place<Real>& place);

/// The time from the lowest place to rest (h < 1), or over half a turn (h > 1), by the same formula; +∞ at
/// h = 1. In double the integrals, being complete, are found by means of Gauss's kind. Error in double: 8 ulps; the worst
/// found is below 7.
template <class Real>
Real quarter(const Ball<Real>& ball, const Energy<Real>& e);

/// quarter() over ½πb, less one, without cancellation. h < 1, else std::domain_error. Error in double: 10 ulps.
double excess(const Ball<double>& ball, const Energy<double>& e);

/// The time at h = 1, which is elementary: B artanh(BV/√(bb + 4acVV)) − 2√(ac) arsinh(2√(ac) V/b), V = sin ½Φ.
/// +∞ at the top. Error in double: 8 ulps of the first term.
template <class Real>
Real separatrix_time(const Ball<Real>& ball, const Place<Real>& place);

/// The inverse: where the ball is at the time τ, as smooth::angle().
Turned angle(const Ball<double>& ball, const Energy<double>& e, double tau);

/// Arrays, bit for bit as one by one. Throw as those do, and std::invalid_argument for spans that differ.
/// @{
void quarter(const Ball<double>& ball, std::span<const Energy<double>> e, std::span<double> out);
void time(const Ball<double>& ball, const Energy<double>& e, std::span<const Place<double>> place,
          std::span<double> out);
/// @}

/// The square of the angular velocity over 2gc: 4(h − sin² ½Φ)/(bb + 4ac sin² ½Φ).
template <class Real>
Real velocity_squared(const Ball<Real>& ball, const Energy<Real>& e, const Place<Real>& place);

/// Π/P: what the plane bears, as a part of the weight; negative where the formula has left the plane.
/// Rounding: 8 ulps of the largest summand.
template <class Real>
Real pressure(const Ball<Real>& ball, const Energy<Real>& e, const Place<Real>& place);

/// λ: the ratio of friction to pressure that rolling needs, positive backwards, for 0 ≤ Φ ≤ 180°; on the other
/// side it is the same with the other sign. Infinite where the pressure vanishes.
/// Source: §§26-27, written without his fraction S, which has poles where no friction is needed.
template <class Real>
Real friction(const Ball<Real>& ball, const Energy<Real>& e, const Place<Real>& place);

/// Where |λ| is greatest on the way from the lowest place to rest or to the top.
template <class Real>
struct Greatest
{
  Real Phi;     ///< the angle
  Real lambda;  ///< λ there, with its sign; infinite where the pressure vanishes on the way
};

/// Source: the roots of cos Φ LQ + 2w(1 − w)(L'Q − LQ'), of the sixth degree in w = sin² ½Φ, and the place of rest.
template <class Real>
Greatest<Real> greatest_friction(const Ball<Real>& ball, const Energy<Real>& e);

/// Energies h from one number to another.
template <class Real>
struct Window
{
  Real from;  ///< the least h
  Real to;    ///< the greatest
};

/// The energies with which the ball rolls for ever, the plane bearing it and |λ| ≤ μ all the way, in rising
/// order; the first starts at 0. μ > 0 finite, else std::domain_error. In fifty digits the ends are good to 19 of
/// them; in double they are those, some milliseconds, each rounded once. What is forbidden between two of 4000
/// neighbouring angles only, by less than a part in 10⁷ of μ, is not seen.
template <class Real>
std::vector<Window<Real>> windows(const Ball<Real>& ball, const Real& mu);

/// Where a rolling ball first loses its pressure, as its energy grows.
template <class Real>
struct Loss
{
  Real h;         ///< the least energy
  Real Phi;       ///< the angle
  Real from_top;  ///< 180° − Φ, exactly 0 at the top
};

/// At the top exactly when kk ≥ (a + c)(3c − a), hence always when c ≤ a/3; else before it. Then the energy is
/// the least of all with which the pressure vanishes at some angle, −Q₀/Q₁ in w = sin² ½Φ, where its derivative's
/// numerator, of the fourth degree, vanishes. In double by way of fifty digits, a quarter of a millisecond: 1 ulp each.
template <class Real>
Loss<Real> loss_of_pressure(const Ball<Real>& ball);

/// The eccentricity c from which on the pressure is lost before the top, (√(4aa + 3kk) − a)/3.
template <class Real>
Real eccentricity_of_early_loss(const Real& a, const Real& k)
{
  using std::sqrt;
  return (a * a + k * k) / (sqrt(4 * a * a + 3 * k * k) + a);
}

/// The greatest μ with which scraping is determined by the equations of §8 at every angle, whatever the motion,
/// and the angle that sets it: the least of (kk + cc sin²Φ)/(c sin Φ |a − c cos Φ|).
template <class Real>
struct Painleve
{
  Real mu;   ///< the limit
  Real Phi;  ///< where
};
/// The limit of this ball, and the angle that sets it.
template <class Real>
Painleve<Real> painleve(const Ball<Real>& ball);

/// @cond
template <>
std::vector<Window<double>> windows(const Ball<double>& ball, const double& mu);
template <>
std::vector<Window<exact::Fifty>> windows(const Ball<exact::Fifty>& ball, const exact::Fifty& mu);
/// @endcond

}  // namespace globe::rolling
