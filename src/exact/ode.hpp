#pragma once
/** @file
 * Motions to thirty and more digits: the oracle for everything that is integrated in double.
 */
#include "exact/fifty.hpp"

#include <functional>
#include <vector>

namespace exact
{

using State = std::vector<Fifty>;                                        ///< y, one number an unknown
using RightSide = std::function<State(const Fifty& t, const State& y)>;  ///< f in y' = f(t, y)

/// A solution at one time and how far it can be trusted.
struct Solution
{
  State y;              ///< the solution
  Fifty error;          ///< the greatest difference to a second integration with other orders and steps
  int evaluations = 0;  ///< of the right-hand side, in both integrations together
};

/**
 * y(t1) of y' = f(t, y), y(t0) = y0, by extrapolation of the midpoint rule with steps chosen so that each
 * contributes at most `tolerance` to the error (absolute where |y| < 1, else relative to it).
 *
 * The equation is solved twice, the second time with an order higher by four and a tolerance smaller by a
 * factor of a thousand. That second solution is returned; the difference between the two, which is the error
 * of the first, is the reported one. t1 may lie before t0. Where a trial step leads f to something that is
 * not finite, the step is shortened.
 *
 * @throws std::invalid_argument if the tolerance is not between 1e-40 and 1e-3, or a number is not finite
 * @throws std::runtime_error if a step becomes too small (a singularity) or more than 100 000 are needed
 *
 * Source: Gragg's rule and Aitken-Neville extrapolation (Hairer, Nørsett and Wanner, *Solving Ordinary
 * Differential Equations I*, II.9).
 */
Solution solve(const RightSide& f, const Fifty& t0, const State& y0, const Fifty& t1,
               const Fifty& tolerance = Fifty("1e-32"));

/// The same at several times, each reached from the one before: each error is that of its own leg.
std::vector<Solution> solve(const RightSide& f, const Fifty& t0, const State& y0,
                            const std::vector<Fifty>& times, const Fifty& tolerance = Fifty("1e-32"));

}  // namespace exact
