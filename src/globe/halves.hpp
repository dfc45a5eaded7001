/// @file
/// Means over a quarter of the period of sn: the trapezoidal rule, doubled until it stands still.
#pragma once

#include <array>
#include <cmath>

namespace globe
{

/// The mean of f(sn², cn², dn²) over a quarter period, f ≥ 0 analytic in sn². `kc2` is the complement of the
/// squared modulus, 0 < kc2 ≤ 1. The nodes of each mesh come from those of the mesh before by the formulae of
/// half the argument, in products only. NaN where 4096 intervals do not suffice. Error: 4 ulps, and what f
/// errs by.
template <class Function>
double mean_over_quarter(double kc2, const Function& f)
{
  constexpr std::size_t most = 2048;
  std::array<double, most> s2, c2, d2;  // squares: roots are taken where they are wanted
  const double kc = std::sqrt(kc2);
  s2[0] = 1 / (1 + kc);
  c2[0] = kc / (1 + kc);
  d2[0] = kc;
  double mean = (f(0.0, 1.0, 1.0) + f(1.0, 0.0, kc2)) / 2;
  double finer = (mean + f(s2[0], kc / (1 + kc), kc)) / 2;
  double before = 0;
  for(std::size_t n = 1; n < most; n *= 2)
  {
    // Each doubling squares the factor by which the error falls.
    const double change = std::abs(finer - mean), fall = change / before;
    if(change == 0 || (change < 1e-4 * finer && change * fall * fall < 0x1p-56 * finer))
      return finer;
    before = change;
    mean = finer;
    double sum = 0;
    for(std::size_t i = 0; i < n; ++i)
    {
      // of u/2, and of (2K − u)/2 in the upper half of the arrays, all six by one division
      const double c = std::sqrt(c2[i]), d = std::sqrt(d2[i]), s = s2[i];
      const double both = c + d, c1 = 1 + c, d1 = 1 + d;
      const double cd = c1 * d1, inverse = 1 / (both * cd), part = both * inverse;
      const double lower_s2 = s * part, lower_c2 = both * part * c1, lower_d2 = both * part * d1;
      const double upper_s2 = part * (c1 * c1), upper_c2 = kc2 * (s * c1 * inverse),
                   upper_d2 = kc2 * (c1 * cd * inverse);
      sum += f(lower_s2, lower_c2, lower_d2) + f(upper_s2, upper_c2, upper_d2);
      s2[i] = lower_s2;
      c2[i] = lower_c2;
      d2[i] = lower_d2;
      s2[n + i] = upper_s2;
      c2[n + i] = upper_c2;
      d2[n + i] = upper_d2;
    }
    finer = (mean + sum / static_cast<double>(2 * n)) / 2;
  }
  return std::nan("");
}

/// √(1+x) − 1 without cancellation.
inline double root_excess(double x)
{
  return x / (1 + std::sqrt(1 + x));
}

}  // namespace globe
