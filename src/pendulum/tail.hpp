/// @file
/// What Euler's series for the time of a swing leaves out, between two bounds that stay close near the top.
#pragma once

#include <cmath>

namespace pendulum
{

// [tail]
/// A little more than all terms of the series from the N-th on (the first is number 0): each a_n²
/// is replaced by 1/π(n+¼), which it approaches from below, and what then stands there sums to an
/// arc and a logarithm. The true tail lies between π a_N²(N+¼) times this and this (§8), so that the
/// two differ by less than one part in 32N².
/// Domain: 0 < c < 1, s = √(1−cc) > 0, N ≥ 0. Real: double or exact::Fifty.
/// Error: N + 4 ulps of itself for cc ≤ ½, beyond that (3 + N/2) ulps of the whole sum.
template <class Real>
Real tail_bound(Real c, Real s, int N)
{
  using std::atan, std::log1p, std::sqrt;
  const Real w = sqrt(c);
  const Real short_of_one = s * s / ((1 + c) * (1 + w));  // 1 − w
  const bool wide = c * c > Real(0.5);
  Real sum = wide ? Real((2 * atan(w) + log1p(2 * w / short_of_one)) / w) : Real(0);  // all terms, or none
  Real power = 1;
  int n = 0;
  for(; n < N; ++n, power *= c * c)
    sum -= wide ? Real(power / (n + Real(0.25))) : Real(0);
  for(Real before = 1; !wide && sum != before; ++n, power *= c * c)
  {
    before = sum;
    sum += power / (n + Real(0.25));
  }
  return sum / (4 * atan(Real(1)));
}
// [tail]

}  // namespace pendulum
