#include "globe/time.hpp"

#include <cmath>
#include <stdexcept>

#include "globe/carlson.hpp"

namespace globe
{

template <class Real>
Real separatrix_time(const Real& c, const Real& k, const Real& omega)
{
  using std::asinh, std::cos, std::hypot, std::sin, std::sqrt;
  const Real v = cos(omega);
  if(!(c >= 0 && k > 0 && c <= 1e6 * k && omega > 0 && v >= 0 && omega < 2))
    throw std::domain_error("the time to the top needs k > 0, 0 ≤ c ≤ 10⁶ k and 0 < ω ≤ 90°");
  // [time]
  const Real r = c / k;
  const Real s = sin(omega);
  const Real q = 1 + 4 * r * r * v * v;
  const Real B = 2 * r * (hypot(r, Real(1)) + r);
  const Real X = (1 + B * s * s) / (1 + B);
  const Real Z = 1 + B * v * v;
  const Real bounded = R_J(Real(1), X, Z, q) + R_D(X, Z, Real(1));
  return k * (asinh(v / (s * sqrt(q))) + 4 * r * r * v * v * v / 3 * bounded);
  // [time]
}

double separatrix_angle(double c, double k, double tau)
{
  if(!(c >= 0 && k > 0 && c <= 1e6 * k && tau >= 0 && tau < 690 * k))
    throw std::domain_error("the way to the top needs k > 0, 0 ≤ c ≤ 10⁶ k and a time from 0 to 690 k");
  const auto angle = [](double x) { return 2 * std::atan(std::exp(-x)); };
  double below = tau / std::hypot(k, c), above = tau / k;
  for(;;)
  {
    const double x = (below + above) / 2;
    if(!(below < x && x < above))
      return angle(x);
    (separatrix_time(c, k, angle(x)) > tau ? above : below) = x;
  }
}

template double separatrix_time(const double&, const double&, const double&);
template exact::Fifty separatrix_time(const exact::Fifty&, const exact::Fifty&, const exact::Fifty&);

}  // namespace globe
