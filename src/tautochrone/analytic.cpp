#include "tautochrone/analytic.hpp"

#include "exact/ode.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace tautochrone
{
namespace
{

using exact::Fifty;
using exact::Rational;
using exact::State;
using std::size_t;

template <class Number>
void require(const Number& kappa, int last)
{
  if(last < 0 || !(kappa > 0))
    throw std::domain_error("the power series needs κ > 0 and at least one term");
}

[[noreturn]] void no_series(int m)
{
  throw std::domain_error("κ = 1/" + std::to_string(2 * m + 1) + " is a resonance: no such series exists");
}

// The rest of the equation's coefficient of hᵐ, where bₘ itself is left out: uu − (1 + κ) r u (1 − h), u
// = κ + rr, and the term of lower order from h h dr/dh.
template <class Number>
Number rest(const Number& kappa, const std::vector<Number>& b, int m)
{
  const auto coefficient = [&](const std::vector<Number>& p, const std::vector<Number>& q, int n) {
    Number sum(0);
    for(int i = 0; i <= n; ++i)
      sum += p[static_cast<size_t>(i)] * q[static_cast<size_t>(n - i)];
    return sum;
  };
  std::vector<Number> r = b;
  r.resize(static_cast<size_t>(m) + 1, Number(0));
  std::vector<Number> u;
  for(int n = 0; n <= m; ++n)
    u.push_back(coefficient(r, r, n) + (n == 0 ? kappa : Number(0)));
  return coefficient(u, u, m) - (1 + kappa) * (coefficient(r, u, m) - coefficient(r, u, m - 1))
         + kappa * (1 + kappa) * (m - 1) * r[static_cast<size_t>(m - 1)];
}

struct Series
{
  std::vector<Fifty> x;
  Fifty reach2;  // the series is good to forty-five digits up to this SS
};

Series prepared(const Fifty& kappa)
{
  if(!(kappa >= Fifty("0.02") && kappa <= 100))
    throw std::domain_error("the analytic curve is followed for κ from 0.02 to 100, not " + kappa.str(6));
  Series series{cosine_series(kappa, 140), 1};
  for(size_t m = 130; m <= 140; ++m)
    series.reach2 =
        std::min(series.reach2, pow(Fifty("1e-46") / abs(series.x[m]), Fifty(1) / static_cast<int>(m)));
  return series;
}

// h = 1 − cos φ and dh/d(SS), at SS.
std::pair<Fifty, Fifty> sums(const Series& series, const Fifty& SS)
{
  Fifty h, slope;
  for(size_t m = series.x.size(); m-- > 1;)
  {
    h = (h - series.x[m]) * SS;
    slope = slope * SS - static_cast<int>(m) * series.x[m];
  }
  return {h, slope};
}

// Z/ε = dh/dS
Fifty slope_of_h(const Fifty& kappa, const Fifty& h, const Fifty& S)
{
  return (1 + kappa) * sqrt((h * (2 - h) - S * S) / kappa);
}

Analytic place(const Fifty& kappa, const Fifty& S, const Fifty& h, const Fifty& dh_dS)
{
  if(S == 0)
    return {0, 0, 1, 0};
  return {S, 2 * asin(sqrt(h / 2)), (1 + kappa) * S / dh_dS, (1 + kappa) / 2 * S * S};
}

// d(dh/dS)/dS: the square of slope_of_h() differentiated, which takes no root at every step; no number where dh/dS has
// come to an end.
Fifty bend_of_h(const Fifty& kappa, const Fifty& h, const Fifty& S, const Fifty& slope)
{
  if(!(slope > 0))
    return std::numeric_limits<double>::quiet_NaN();
  return (1 + kappa) * (1 + kappa) / kappa * (1 - h - S / slope);
}

// y[0] at t1, where the curve gets there.
Fifty followed(const exact::RightSide& f, const Fifty& t0, const State& y0, const Fifty& t1)
{
  try
  {
    return solve(f, t0, y0, t1, Fifty("1e-36")).y[0];
  }
  catch(const std::runtime_error&)
  {
    throw std::domain_error("the analytic curve does not reach so far");
  }
}

}  // namespace

template <class Number>
std::vector<Number> cosine_series(const Number& kappa, int last)
{
  require(kappa, last);
  const Number four_eps2 = 4 * kappa / ((1 + kappa) * (1 + kappa));
  std::vector<Number> x = {Number(1), -(1 + kappa) / 2};
  // [x]
  for(int m = 2; m <= last; ++m)
  {
    const Number factor = 1 - (2 * m - 1) * kappa;
    if(factor == 0)
      no_series(m - 1);
    Number sum(0);
    for(int i = 1; i < m; ++i)
    {
      const size_t j = static_cast<size_t>(i);
      sum += x[j] * x[static_cast<size_t>(m) - j];
      if(i > 1)
        sum += four_eps2 * (i * (m + 1 - i)) * x[j] * x[static_cast<size_t>(m) + 1 - j];
    }
    x.push_back(-sum * (1 + kappa) / (2 * factor));
  }
  // [x]
  x.resize(static_cast<size_t>(last) + 1);
  return x;
}

template <class Number>
std::vector<Number> radius_series(const Number& kappa, int last)
{
  require(kappa, last);
  std::vector<Number> b = {Number(1)};
  // [b]
  for(int m = 1; m <= last; ++m)
  {
    const Number factor = (2 * m + 1) * kappa - 1;
    if(factor == 0)
      no_series(m);
    b.push_back(rest(kappa, b, m) / ((1 + kappa) * factor));
  }
  // [b]
  return b;
}

template std::vector<Rational> cosine_series(const Rational& kappa, int last);
template std::vector<Fifty> cosine_series(const Fifty& kappa, int last);
template std::vector<Rational> radius_series(const Rational& kappa, int last);
template std::vector<Fifty> radius_series(const Fifty& kappa, int last);

int resonance(const Rational& kappa)
{
  if(!(kappa > 0 && kappa < 1 && kappa.numerator() == "1" && kappa.denominator().size() < 9))
    return 0;
  const int odd = std::stoi(kappa.denominator());
  return odd % 2 == 1 ? (odd - 1) / 2 : 0;
}

Rational logarithmic_coefficient(const Rational& kappa)
{
  const int m = resonance(kappa);
  if(m == 0)
    throw std::domain_error("κ = " + kappa.str() + " is no resonance");
  return rest(kappa, radius_series(kappa, m - 1), m) / (2 * kappa * (1 + kappa));
}

Analytic analytic_at_arc(const Fifty& kappa, const Fifty& S)
{
  if(!(S == 0 || (S >= Fifty("1e-100") && S < 1)))
    throw std::domain_error("the arc S must be zero or from 1e-100 to 1, not " + S.str(6));
  const Series series = prepared(kappa);
  if(S * S <= series.reach2)
  {
    const auto [h, slope] = sums(series, S * S);
    return place(kappa, S, h, 2 * S * slope);
  }
  const auto f = [&](const Fifty& at, const State& y) {  // h and dh/dS
    return State{y[1], bend_of_h(kappa, y[0], at, y[1])};
  };
  const Fifty from = sqrt(series.reach2), h_from = sums(series, series.reach2).first;
  const Fifty h = followed(f, from, {h_from, slope_of_h(kappa, h_from, from)}, S);
  return place(kappa, S, h, slope_of_h(kappa, h, S));
}

Analytic analytic_at_angle(const Fifty& kappa, const Fifty& phi)
{
  if(!(phi == 0 || (phi >= Fifty("1e-100") && phi < exact::pi() / 2)))
    throw std::domain_error("the angle must be zero or from 1e-100 to ½π, not " + phi.str(6));
  const Series series = prepared(kappa);
  const Fifty h = 2 * sin(phi / 2) * sin(phi / 2);
  const Fifty h_of_series = sums(series, series.reach2).first;
  if(h <= h_of_series)
  {
    Fifty SS = 2 * h / (1 + kappa);
    for(int i = 0; i < 200; ++i)
    {
      const auto [now, slope] = sums(series, SS);
      const Fifty change = (h - now) / slope;
      SS += change;
      if(SS > series.reach2)
        SS = series.reach2;
      if(!(abs(change) > Fifty("1e-44") * SS))
        break;
    }
    return place(kappa, sqrt(SS), h, 2 * sqrt(SS) * sums(series, SS).second);
  }
  const auto f = [&](const Fifty& at, const State& y) {  // S and dh/dS
    const Fifty steep = 1 / y[1];
    return State{steep, steep * bend_of_h(kappa, at, y[0], y[1])};
  };
  const Fifty from = sqrt(series.reach2);
  const Fifty S = followed(f, h_of_series, {from, slope_of_h(kappa, h_of_series, from)}, h);
  return place(kappa, S, h, slope_of_h(kappa, h, S));
}

}  // namespace tautochrone
