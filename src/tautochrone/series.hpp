#pragma once
/** @file
 * Euler's expansion of the tautochrone's radius of curvature in powers of kk.
 */
#include "exact/series.hpp"

#include <vector>

/// The tautochrone of compound pendulums.
namespace tautochrone
{

/// A polynomial in cos φ and 1/cos φ with exact coefficients.
using Powers = exact::Laurent<exact::Rational>;

/// A series in kk whose coefficients are such polynomials.
using Expansion = exact::Series<Powers>;

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

/**
 * r₀, r₁, ... with r = a Σ rₙ (kk/aa)ⁿ: the first `last` + 1 coefficients, polynomials in cos φ and 1/cos φ.
 *
 * r₀ = cos φ; r₁ and r₂ are the P and Q of §§29 and 30 for a = 1. All coefficients are whole numbers, which
 * `Number` = `Rational` gives exactly and `Fifty` as long as they have no more than fifty digits. The series
 * diverges for every φ but zero: it is an asymptotic one.
 *
 * @throws std::domain_error if last < 0
 */
template <class Number>
std::vector<exact::Laurent<Number>> corrections(int last);

/// r/a through the power (kk/aa)^order, as a polynomial in cos φ and 1/cos φ. `k` is k/a, not negative.
/// @throws std::domain_error if order < 0
exact::Laurent<exact::Fifty> truncated(int order, const exact::Fifty& k);

}  // namespace tautochrone
