#include "tautochrone/swing.hpp"

#include "exact/ode.hpp"
#include "exact/quadrature.hpp"

#include <cmath>
#include <stdexcept>

namespace tautochrone
{

using exact::Fifty;

namespace
{

void require_swing(const Fifty& k, const Fifty& phi0)
{
  if(!(phi0 >= Fifty("1e-4") && phi0 < exact::pi() / 2 && k >= 0))
    throw std::domain_error("a swing needs 0.0001 ≤ φ₀ < ½π and k ≥ 0");
}

}  // namespace

Fifty excess(const std::function<Fifty(const Fifty&)>& r, const std::function<Fifty(const Fifty&)>& x,
             const Fifty& k, const Fifty& phi0)
{
  require_swing(k, phi0);
  const Fifty c = x(phi0);
  const Fifty small_swing = exact::pi() * sqrt(2 * (1 + k * k));
  Fifty before;
  for(int nodes = 16; nodes <= 1024; nodes *= 2)
  {
    Fifty sum;
    for(int i = 0; i < nodes; ++i)
    {
      const Fifty alpha = (i + Fifty(0.5)) * exact::pi() / (2 * nodes);
      const Fifty phi = phi0 * sin(alpha);
      const Fifty radius = r(phi);
      const Fifty to_fall = c - x(phi);
      if(!(to_fall > 0))
        throw std::domain_error("the curve does not rise to φ = " + phi0.str(6));
      sum += phi0 * cos(alpha) * sqrt((k * k + radius * radius) / to_fall);
    }
    const Fifty result = exact::pi() / nodes * sum / small_swing - 1;
    if(abs(result - before) < Fifty("1e-25"))
      return result;
    before = result;
  }
  throw std::runtime_error("the time of the swing does not settle");
}

Fifty excess(const exact::Laurent<Fifty>& r, const Fifty& k, const Fifty& phi0)
{
  require_swing(k, phi0);
  if(r(cos(phi0)) < 1e-4)
    return std::nan("");
  const exact::Laurent<Fifty> falling = integral(r);  // dx = r dφ sin φ = −r d(cos φ)
  const auto x = [&](const Fifty& phi) { return falling(Fifty(1)) - falling(cos(phi)); };
  return excess([&](const Fifty& phi) { return r(cos(phi)); }, x, k, phi0);
}

Fifty turning2_by_motion(const exact::Laurent<Fifty>& r, const Fifty& k, const Fifty& phi0,
                         const Fifty& phi)
{
  const Fifty kk = k * k;
  if(!(k >= Fifty("1e-20") && k <= Fifty("1e20") && phi >= 0 && phi0 > 0 && phi <= phi0
       && phi0 < exact::pi() / 2))
    throw std::domain_error("turning2_by_motion: a k from 1e-20 to 1e20 and 0 ≤ φ ≤ φ₀ < ½π are needed");
  // With w = φ'φ' it is dw/dφ = 2φ"; what is followed is w(1 + kk)/φ₀φ₀ against φ/φ₀.
  const exact::Laurent<Fifty> dr = derivative(r);  // with respect to cos φ
  const auto slope = [&](const Fifty& u, const exact::State& y) -> exact::State {
    const Fifty s = sin(phi0 * u), c = cos(phi0 * u), radius = r(c);
    return {s * radius * (2 * dr(c) * y[0] * phi0 - (1 + kk) / phi0) / (kk + radius * radius)};
  };
  if(phi == phi0)
    return 0;
  return exact::solve(slope, 1, {0}, phi / phi0).y[0] * phi0 * phi0 / (1 + kk);
}

Fifty turning2_by_motion(const Fifty& k, const Fifty& phi0, const Fifty& phi)
{
  return turning2_by_motion(exact::Laurent<Fifty>(Fifty(1), 1), k, phi0, phi);
}

std::vector<On_curve> places_by_motion(const exact::Laurent<Fifty>& r, const Fifty& k, const Fifty& phi0,
                                       const std::vector<Fifty>& times)
{
  if(!(k >= 0 && k <= Fifty("1e20") && phi0 > 0 && phi0 < exact::pi() / 2))
    throw std::domain_error("places_by_motion: a k from 0 to 1e20 and 0 < φ₀ < ½π are needed");
  const exact::Laurent<Fifty> dr = derivative(r);  // with respect to cos φ
  // Followed are φ/φ₀ and its velocity in the time √(2(1 + kk)), x/φ₀φ₀ and y/φ₀: all are of the size of one. Sine and
  // cosine go along with them, which is quicker than to find them anew.
  const Fifty
      unit = sqrt(2 * (1 + k * k)),
      x = exact::integrate([&](const Fifty&phi) -> Fifty { return r(cos(phi)) * sin(phi); }, 0, phi0).value,
      y = exact::integrate([&](const Fifty&phi) -> Fifty { return r(cos(phi)) * cos(phi); }, 0, phi0).value;
  const auto motion = [&](const Fifty&, const exact::State& at) -> exact::State {
    const Fifty &velocity = at[1], &s = at[4], &c = at[5], radius = r(c), w = phi0 * velocity / unit;
    const Fifty turning = phi0 * velocity;
    return {velocity,
            unit * unit / phi0 * s * radius * (dr(c) * w * w - Fifty(0.5)) / (k * k + radius * radius),
            radius * s * velocity / phi0,
            radius * c * velocity,
            c * turning,
            -s * turning};
  };
  std::vector<Fifty> scaled;
  for(const Fifty& t : times)
    scaled.push_back(t / unit);
  std::vector<On_curve> places;
  for(const exact::Solution& at : exact::solve(
          motion, 0, {1, 0, x / (phi0 * phi0), y / phi0, sin(phi0), cos(phi0)}, scaled, Fifty("1e-20")))
  {
    const Fifty phi = at.y[0] * phi0;
    places.push_back({phi, r(cos(phi)), at.y[2] * phi0 * phi0, at.y[3] * phi0});
  }
  return places;
}

Accelerations accelerations(const exact::Laurent<Fifty>& r, const Fifty& k, const Fifty& turning2,
                            const Fifty& phi)
{
  const Fifty s = sin(phi), c = cos(phi), radius = r(c), dr = -s * derivative(r)(c);
  struct Plane
  {
    Fifty aside, down;
  };
  // A weight at the distance l from M goes by l dφ across the line, for M is at rest; the distance grows by dr.
  const auto first = [&](const Fifty& l) { return Plane{l * c, -l * s}; };
  const auto second = [&](const Fifty& l) { return Plane{dr * c - l * s, -dr * s - l * c}; };
  Fifty work = 0, inertia = 0;  // of gravity less what w demands, and that ddφ is multiplied by, doubled
  for(const Fifty& l : {radius - k, radius + k})
  {
    const Plane one = first(l), two = second(l);
    work += (one.down - 2 * turning2 * (one.aside * two.aside + one.down * two.down)) / 2;
    inertia += one.aside * one.aside + one.down * one.down;
  }
  const Fifty turning = 2 * work / inertia;
  const Plane one = first(radius), two = second(radius);
  const Fifty aside = 2 * turning2 * two.aside + turning * one.aside,
              down = 2 * turning2 * two.down + turning * one.down;
  return {turning, -aside * s - down * c, aside * c - down * s};
}

Fifty circle_excess(const Fifty& phi0)
{
  const Fifty cc = pow(sin(phi0 / 2), 2), least("1e-50");
  Fifty sum = 0, term = 1;
  for(int n = 1; n == 1 || term > sum * least; ++n)
  {
    term *= cc * (2 * n - 1) * (2 * n - 1) / (4 * n * n);
    sum += term;
  }
  return sum;
}

}  // namespace tautochrone
