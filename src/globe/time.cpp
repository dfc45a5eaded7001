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
  if(!(c >= 0 && k > 0 && omega > 0 && v >= 0 && omega < 2))
    throw std::domain_error("the time to the top needs c ≥ 0, k > 0 and 0 < ω ≤ 90°");
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

template double separatrix_time(const double&, const double&, const double&);
template exact::Fifty separatrix_time(const exact::Fifty&, const exact::Fifty&, const exact::Fifty&);

}  // namespace globe
