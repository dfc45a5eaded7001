#pragma once
/** @file
 * Euler's expansion of the tautochrone's radius of curvature in powers of kk.
 */
#include "exact/series.hpp"

#include <cmath>
#include <vector>

/// The tautochrone of compound pendulums.
namespace tautochrone
{

// [powers]
/// A polynomial in cos φ and 1/cos φ with exact coefficients.
using Powers = exact::Laurent<exact::Rational>;

/// cosⁿφ, for n of either sign.
inline Powers cosine(int n)
{
  return {1, n};
}

/// The derivative of such a polynomial with respect to φ, times sin φ; this is a polynomial again.
template <class Number>
exact::Laurent<Number> slope_times_sine(const exact::Laurent<Number>& p)
{
  return (exact::Laurent<Number>(Number(1), 2) - 1) * derivative(p);  // −sin²φ = cos²φ − 1
}
// [powers]

/// A series in kk whose coefficients are such polynomials.
using Expansion = exact::Series<Powers>;

/// The first correction (§29): P = −(1 − cos⁴φ)/a cos³φ. Domain: a ≠ 0.
inline Powers P(const exact::Rational& a)
{
  return (cosine(4) - 1) / (a * cosine(3));
}

// [radius]
/// Euler's radius of curvature MG with both corrections (§30), in the unit of the lengths a and k.
/// Domain: a > 0, k ≥ 0, |φ| < ½π; from some angle on it is negative, which no curve on cheeks can be.
/// Real: double (to 4 ulps of the largest term) or exact::Fifty.
template <class Real>
Real radius(const Real& a, const Real& k, const Real& phi)
{
  using std::cos, std::pow, std::sin;
  const Real c = cos(phi), s = sin(phi);
  return a * c - k * k * (1 - pow(c, 4)) / (a * pow(c, 3))
         - 6 * pow(k, 4) * s * s / (pow(a, 3) * pow(c, 7));
}
// [radius]

// [equation]
/**
 * The left side of Euler's differential equation, ordered by powers of kk as in §28; zero on a tautochrone.
 *
 * `dr_sin` is (dr/dφ) sin φ. Any numbers will do: doubles, fifty digits, or formal expansions.
 */
template <class Real>
Real equation(const Real& a, const Real& kk, const Real& r, const Real& dr_sin, const Real& cos)
{
  const Real rr = r * r;
  return a * rr * rr - a * a * rr * r * cos
         + kk * (2 * a * rr - a * a * r * cos - rr * r * cos - a * a * dr_sin)
         + kk * kk * (a - r * cos - dr_sin);
}
// [equation]

/**
 * r₀, r₁, ... with r = a Σ rₙ (kk/aa)ⁿ: the first `last` + 1 coefficients, polynomials in cos φ and 1/cos
 * φ.
 *
 * r₀ = cos φ; r₁ and r₂ are the P and Q of §§29 and 30 for a = 1. All coefficients are whole numbers, which
 * `Number` = `Rational` gives exactly and `Fifty` as long as they have no more than fifty digits. The
 * series diverges for every φ but zero: it is an asymptotic one.
 *
 * @throws std::domain_error if last < 0
 */
template <class Number>
std::vector<exact::Laurent<Number>> corrections(int last);

/// r/a through the power (kk/aa)^order, as a polynomial in cos φ and 1/cos φ. `k` is k/a, not negative.
/// @throws std::domain_error if order < 0
exact::Laurent<exact::Fifty> truncated(int order, const exact::Fifty& k);

/// The same with its coefficients rounded to doubles, for the races.
exact::Laurent<double> truncated_in_double(int order, const exact::Fifty& k);

/// The last power of kk for which terms() and end_of_truncated() have coefficients.
inline constexpr int last_power = 16;

/**
 * The terms (kk)ⁿrₙ of r/a for n = 0 to `last`, in double, at an angle 0 ≤ φ < ½π; k is k/a, not negative.
 *
 * r₀ is cos φ, and rₙ/cos φ a polynomial in tan²φ with none but negative coefficients, so that each term is
 * good to 1e-14 of itself (measured), at small angles too.
 * @throws std::domain_error unless 0 ≤ last ≤ last_power, 0 ≤ k, |φ| < ½π
 */
std::vector<double> terms(double k, double phi, int last);

/// r/a through the power (kk)^order, in double: the sum of terms(), good to 1e-14 of the largest. @throws
/// as they
double radius_by_series(int order, double k, double phi);

/**
 * The angle at which the radius of Euler's curve, kept through the power (kk)^order, comes down to zero:
 * the whole thread is then wound and the curve ends. ½π for the cycloid (order 0) and for k = 0.
 *
 * There is but one such angle, because all terms but the first grow with tan²φ in size and have the same
 * sign. `k` is k/a, 1e-10 ≤ k ≤ 1e10 or zero. The error is at most 4 ulps.
 * @throws std::domain_error unless 0 ≤ order ≤ last_power and k is as it should be
 */
double end_of_truncated(int order, double k);

}  // namespace tautochrone
