#include "globe/carlson.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace globe
{
namespace
{

// The arguments are brought together until they differ by less than this part of their mean; the series that
// is left then errs in its sixth power, below the last bit.
template <class Real>
const Real near = std::ldexp(1.0, std::is_same_v<Real, double> ? -10 : -29);

template <class Real>
void require_domain(const Real& x, const Real& y, const Real& z)
{
  using std::isfinite;
  const bool none_negative = x >= 0 && y >= 0 && z >= 0;
  const bool one_zero_at_most = x + y > 0 && y + z > 0 && z + x > 0;
  if(!none_negative || !one_zero_at_most || !isfinite(x + y + z))
    throw std::domain_error("Carlson's integrals: no argument may be negative, at most one zero");
}

// R_C(1, u) with u = 1 + e, both given because neither keeps its digits when formed from the other.
template <class Real>
Real R_C_of_one(const Real& u, const Real& e)
{
  using std::asinh, std::atan, std::sqrt;
  if(e == 0)
    return 1;
  const Real root = sqrt(e < 0 ? Real(-e) : e);
  return (e < 0 ? Real(asinh(root / sqrt(u))) : Real(atan(root))) / root;
}

}  // namespace

template <class Real>
Real R_F(Real x, Real y, Real z)
{
  using std::abs, std::max, std::sqrt;
  require_domain(x, y, z);
  Real mean = (x + y + z) / 3;
  while(max({abs(mean - x), abs(mean - y), abs(mean - z)}) > near<Real> * mean)
  {
    const Real shift = sqrt(x) * sqrt(y) + sqrt(y) * sqrt(z) + sqrt(z) * sqrt(x);
    x = (x + shift) / 4;
    y = (y + shift) / 4;
    z = (z + shift) / 4;
    mean = (mean + shift) / 4;
  }
  const Real X = (mean - x) / mean;
  const Real Y = (mean - y) / mean;
  const Real Z = -X - Y;
  const Real E2 = X * Y - Z * Z;
  const Real E3 = X * Y * Z;
  return (1 - E2 / 10 + E3 / 14 + E2 * E2 / 24 - 3 * E2 * E3 / 44) / sqrt(mean);
}

template <class Real>
Real R_J(Real x, Real y, Real z, Real p)
{
  using std::abs, std::isfinite, std::max, std::sqrt;
  require_domain(x, y, z);
  if(!(p > 0) || !isfinite(p))
    throw std::domain_error("R_J needs a positive fourth argument");
  Real mean = (x + y + z + 2 * p) / 5;
  Real delta = (p - x) * (p - y) * (p - z);
  Real quarter = 1;  // 4⁻ⁿ
  Real sum = 0;
  while(max({abs(mean - x), abs(mean - y), abs(mean - z), abs(mean - p)}) > near<Real> * mean)
  {
    const Real shift = sqrt(x) * sqrt(y) + sqrt(y) * sqrt(z) + sqrt(z) * sqrt(x);
    const Real d = (sqrt(p) + sqrt(x)) * (sqrt(p) + sqrt(y)) * (sqrt(p) + sqrt(z));
    sum += quarter / d * R_C_of_one(Real(2 * sqrt(p) * (p + shift) / d), Real(delta / d / d));
    x = (x + shift) / 4;
    y = (y + shift) / 4;
    z = (z + shift) / 4;
    p = (p + shift) / 4;
    mean = (mean + shift) / 4;
    delta /= 64;
    quarter /= 4;
  }
  const Real X = (mean - x) / mean;
  const Real Y = (mean - y) / mean;
  const Real Z = (mean - z) / mean;
  const Real P = -(X + Y + Z) / 2;
  const Real E2 = X * Y + Y * Z + Z * X - 3 * P * P;
  const Real E3 = X * Y * Z + 2 * E2 * P + 4 * P * P * P;
  const Real E4 = (2 * X * Y * Z + E2 * P + 3 * P * P * P) * P;
  const Real E5 = X * Y * Z * P * P;
  const Real series =
      1 - 3 * E2 / 14 + E3 / 6 + 9 * E2 * E2 / 88 - 3 * E4 / 22 - 9 * E2 * E3 / 52 + 3 * E5 / 26;
  return quarter * series / (mean * sqrt(mean)) + 6 * sum;
}

template double R_F(double, double, double);
template exact::Fifty R_F(exact::Fifty, exact::Fifty, exact::Fifty);
template double R_J(double, double, double, double);
template exact::Fifty R_J(exact::Fifty, exact::Fifty, exact::Fifty, exact::Fifty);

}  // namespace globe
