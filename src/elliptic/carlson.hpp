/// @file
/// Carlson's symmetric elliptic integrals, in double and in fifty digits by the same lines.
///
///     R_C(x, y)            ½ ∫₀^∞ dt / ((t+y) √(t+x)), the elementary one
///     R_F(x, y, z)         ½ ∫₀^∞ dt / √((t+x)(t+y)(t+z))
///     R_J(x, y, z, p)      3⁄2 ∫₀^∞ dt / ((t+p) √((t+x)(t+y)(t+z)))
///     R_D(x, y, z)         R_J(x, y, z, z)
///     R_F_and_J(…)         both of the same arguments for little more than the price of one
///
/// Unlike Legendre's F, E and Π they lose no digits where the modulus or the characteristic nears 1, provided
/// that one gives them the complement and does not let them form it.
///
/// Every argument that a double can hold is right, from 5·10⁻³²⁴ to 1.8·10³⁰⁸, in any mixture; a value beyond
/// the doubles is +∞, or 0. `Real` is double or exact::Fifty.
///
/// Source: B. C. Carlson, *Numerical computation of real or complex elliptic integrals*, Numerical Algorithms
/// 10 (1995), 13-26. Here the arguments are brought together less far and the series that is left is longer. In
/// double what a rounding loses is carried along where it would add up over the steps: in the mean of R_F, and in all
/// that R_D and R_J are summed of (T. J. Dekker, Numerische Mathematik 18 (1971), 224-242). The arcs of R_J that are
/// small are by their series; in fifty digits, and in R_F_and_J, they are taken together, as the arc of the product of
/// their complex numbers.
///
/// Errors in double, in units of the last place, are the worst found against fifty digits, at a hundred thousand arguments
/// spread evenly in their logarithm from 10⁻⁶ to 10⁶ and as many that nearly agree, and at thousands over all doubles
/// (tests/elliptic.cpp).
#pragma once

#include <span>

#include "exact/fifty.hpp"

/// Carlson's elliptic integrals.
namespace elliptic
{

/// ½ ∫₀^∞ dt / ((t+y) √(t+x)): an arc tangent where y > x, an inverse hyperbolic sine where y < x.
/// Domain: x ≥ 0 and y > 0, both finite; else std::domain_error. Error in double: 4 ulps.
template <class Real>
Real R_C(const Real& x, const Real& y);

/// ½ ∫₀^∞ dt / √((t+x)(t+y)(t+z)).
/// Domain: x, y, z finite, none below 0 and at most one of them 0; else std::domain_error. Error in double:
/// 3 ulps.
template <class Real>
Real R_F(const Real& x, const Real& y, const Real& z);

/// 3⁄2 ∫₀^∞ dt / ((t+p) √((t+x)(t+y)(t+z))).
/// Domain: as R_F, and p > 0 finite. Error in double: 3 ulps.
template <class Real>
Real R_J(const Real& x, const Real& y, const Real& z, const Real& p);

/// R_J(x, y, z, z). Domain: as R_F, and z > 0. Error in double: 3 ulps; 4 where the arguments differ by more than a
/// factor of 10¹⁸⁰.
template <class Real>
Real R_D(const Real& x, const Real& y, const Real& z);

/// R_F(x, y, z) and R_J(x, y, z, p).
template <class Real>
struct First_and_third
{
  Real F;  ///< of the first kind
  Real J;  ///< of the third
};

/// Both at once: one bringing together serves both, and no rounding is carried along: that is for speed. Domain as R_J.
/// Error in double: 8 ulps.
template <class Real>
First_and_third<Real> R_F_and_J(const Real& x, const Real& y, const Real& z, const Real& p);

/// The same of arrays, bit for bit as of single numbers, NaN where those throw. Throws std::invalid_argument
/// when the spans differ in length, never for a value. `out` may be one of the arguments.
/// @{
void R_C(std::span<const double> x, std::span<const double> y, std::span<double> out);
void R_F(std::span<const double> x, std::span<const double> y, std::span<const double> z,
         std::span<double> out);
void R_D(std::span<const double> x, std::span<const double> y, std::span<const double> z,
         std::span<double> out);
void R_J(std::span<const double> x, std::span<const double> y, std::span<const double> z,
         std::span<const double> p, std::span<double> out);
/// @}

/// @cond
extern template double R_C(const double&, const double&);
extern template exact::Fifty R_C(const exact::Fifty&, const exact::Fifty&);
extern template double R_F(const double&, const double&, const double&);
extern template exact::Fifty R_F(const exact::Fifty&, const exact::Fifty&, const exact::Fifty&);
extern template double R_D(const double&, const double&, const double&);
extern template exact::Fifty R_D(const exact::Fifty&, const exact::Fifty&, const exact::Fifty&);
extern template double R_J(const double&, const double&, const double&, const double&);
extern template exact::Fifty R_J(const exact::Fifty&, const exact::Fifty&, const exact::Fifty&,
                                 const exact::Fifty&);
extern template First_and_third<double> R_F_and_J(const double&, const double&, const double&,
                                                  const double&);
extern template First_and_third<exact::Fifty> R_F_and_J(const exact::Fifty&, const exact::Fifty&,
                                                        const exact::Fifty&, const exact::Fifty&);
/// @endcond

}  // namespace elliptic
