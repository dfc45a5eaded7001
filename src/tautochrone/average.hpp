#pragma once
/** @file
 * Averages over a quarter of the circle, of functions that may change abruptly near its end.
 */
#include <cmath>

namespace tautochrone
{

/**
 * The average of f over 0 < α < ½π, where f is given sin²α and cos²α and is analytic in them.
 *
 * Such a function goes on evenly and with the period π, so that the midpoint rule converges
 * geometrically. It is taken with 16 nodes and three times as many as long as that helps: the next error
 * is nearly the cube of the last change, at worst its square, and 4e-9 is little enough. What has not
 * settled with 432 nodes changes abruptly near α = ½π, and is integrated by the tanh-sinh rule, whose
 * nodes crowd there in powers of ten, down to cos²α = 1e-300. `abrupt` says that it changes within a
 * tenth of the quarter; then that rule is taken at once.
 *
 * The result errs by less than 1e-15 of the average of |f| besides what f errs by, NaN where f is NaN.
 */
template <class Function>
double average_over_quarter(Function f, bool abrupt)
{
  constexpr double half_pi = 1.5707963267948966;
  const auto at = [&](double alpha) {
    const double s = std::sin(alpha), c = std::cos(alpha);
    return f(s * s, c * c);
  };
  double sum = 0, coarse = 0;
  for(int nodes = 16; nodes <= 432 && !abrupt; nodes *= 3)
  {
    for(int i = 0; i < nodes; ++i)
      if(nodes == 16 || i % 3 != 1)  // the others were there before
        sum += at((i + 0.5) / nodes * half_pi);
    const double fine = sum / nodes;
    if(nodes > 16 && !(std::abs(fine - coarse) > 4e-9 * std::abs(fine)))
      return fine;
    coarse = fine;
  }
  // α = ½π/(1 + exp(−π sinh u)), and what it lacks to ½π likewise, so that neither is subtracted.
  const auto tanh_sinh = [&](double step, double first) {
    double total = 0;
    for(double u = first; u < 5.4; u += step)
    {
      const double q = std::exp(-2 * half_pi * std::sinh(u));
      const double small = half_pi * q / (1 + q), weight = half_pi * std::cosh(u) * q / ((1 + q) * (1 + q));
      const double s = std::sin(small), c = std::cos(small);
      total += weight * (f(c * c, s * s) + (u > 0 ? f(s * s, c * c) : 0));
    }
    return total;
  };
  double step = 0.25, total = tanh_sinh(step, 0), before = 0;
  do
  {
    before = total * step;
    total += tanh_sinh(step, step / 2);
    step /= 2;
  } while(std::abs(total * step - before) > 1e-9 * std::abs(before) && step > 1e-3);
  return 2 * total * step;
}

}  // namespace tautochrone
