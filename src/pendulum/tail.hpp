/// @file
/// What Euler's series for the time of a swing leaves out, between two bounds that stay close near the top.
#pragma once

#include <cmath>
#include <utility>

namespace pendulum
{

// [tail]
/// B, a little more than all terms of the series from the N-th on (the first is number 0): the sum of
/// c²ⁿ/π(n+¼), each a_n² being replaced by what it approaches from below. From 0 on it sums to an arc and a
/// logarithm. The true tail lies between π a_N²(N+¼) B and B (§8), and these differ by less than one part
/// in 32N². Domain: 0 < c < 1, s = √(1−cc) > 0, N ≥ 0. Real: double or exact::Fifty.
/// Error: 10 ulps of itself for cc ≤ ½, beyond that (3 + N/2) ulps of the whole sum.
template <class Real>
Real tail_bound(Real c, Real s, int N)
{
  using std::atan, std::log, std::pow, std::sqrt;
  Real sum = 0;
  if(c * c <= Real(0.5))  // the terms from the N-th on, until they no longer count
  {
    Real power = pow(c, 2 * N), before = -1;
    for(int n = N; sum != before; ++n, power *= c * c)
      before = std::exchange(sum, sum + power / (n + Real(0.25)));
  }
  else  // all terms, less the first N
  {
    const Real w = sqrt(c);
    Real power = 1;
    sum = (2 * atan(w) + 2 * log((1 + w) / s) + log(1 + c)) / w;  // (1+w)/(1−w) = (1+w)²(1+c)/ss
    for(int n = 0; n < N; ++n, power *= c * c)
      sum -= power / (n + Real(0.25));
  }
  return sum / (4 * atan(Real(1)));
}
// [tail]

}  // namespace pendulum
