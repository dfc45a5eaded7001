#pragma once
/** @file
 * Integrals to more than forty digits.
 */
#include "exact/fifty.hpp"

#include <functional>

namespace exact
{

/// An integral and how far it can be trusted.
struct Integral
{
  Fifty value;  ///< the integral
  Fifty
      error;  ///< how much the last halving of the mesh changed the value, and 1e-49 of the integral of |f|
  int evaluations = 0;  ///< of f
};

/**
 * The integral of f from a to b, by the tanh-sinh rule, its mesh halved until the value stands still.
 *
 * f must be analytic between a and b: split the interval at a kink. It is not called at the ends. If it is
 * infinite there, half of the digits are lost: use `integrate_from_ends`. The rule converges so fast that the
 * change at the last halving, which is reported and is at most `tolerance` times the integral of |f|, is
 * nearly the square root of the true error.
 *
 * @throws std::domain_error if a or b is not finite, or f(x) is not
 * @throws std::runtime_error if the tolerance is not reached with a mesh of 2^-9, some 6000 evaluations
 *
 * Source: H. Takahasi and M. Mori, Double exponential formulas for numerical integration (1974).
 */
Integral integrate(const std::function<Fifty(const Fifty&)>& f, const Fifty& a, const Fifty& b,
                   const Fifty& tolerance = Fifty("1e-40"));

/**
 * The same, where f is also told how far x is from the nearer end: a number with the sign of (end - x),
 * negative in the left half and positive in the right one, that keeps its fifty digits however close the end
 * is.
 *
 * The nodes reach to 1e-200 of the interval from an end, so that a singularity as strong as the power -¾ is
 * integrated with all its digits.
 */
Integral integrate_from_ends(const std::function<Fifty(const Fifty& x, const Fifty& to_nearer_end)>& f,
                             const Fifty& a, const Fifty& b, const Fifty& tolerance = Fifty("1e-40"));

}  // namespace exact
