/// @file
/// Carlson's symmetric elliptic integrals, in double and in fifty digits by the same lines.
///
/// All times of the ball that are elliptic at all are written in them: unlike Legendre's F, E and Π they
/// lose no digits where the modulus or the characteristic nears 1, which is just where the motion nears the
/// top.
///
/// Source: B. C. Carlson, *Numerical computation of real or complex elliptic integrals*, Numerical
/// Algorithms 10 (1995), 13-26; the elementary part of R_J is formed so that a small p costs no digits.
/// Errors in double were measured against the same lines in fifty digits, on arguments spread from 10⁻⁶ to
/// 10⁶.
#pragma once

#include "exact/fifty.hpp"

namespace globe
{

/// ½ ∫₀^∞ dt / √((t+x)(t+y)(t+z)), for `Real` double or exact::Fifty.
/// Domain: x, y, z finite, none below 0 and at most one of them 0; else std::domain_error. Error in double:
/// 6 ulps.
template <class Real>
Real R_F(Real x, Real y, Real z);

/// 3⁄2 ∫₀^∞ dt / ((t+p) √((t+x)(t+y)(t+z))), for `Real` double or exact::Fifty.
/// Domain: as R_F, and p > 0 finite. Error in double: 8 ulps.
template <class Real>
Real R_J(Real x, Real y, Real z, Real p);

/// R_J(x, y, z, z). Domain: as R_F, and z > 0. Error in double: 8 ulps.
template <class Real>
Real R_D(Real x, Real y, Real z)
{
  return R_J(x, y, z, z);
}

/// @cond
extern template double R_F(double, double, double);
extern template exact::Fifty R_F(exact::Fifty, exact::Fifty, exact::Fifty);
extern template double R_J(double, double, double, double);
extern template exact::Fifty R_J(exact::Fifty, exact::Fifty, exact::Fifty, exact::Fifty);
/// @endcond

}  // namespace globe
