#include "tautochrone/curve.hpp"

#include "exact/ode.hpp"

#include <algorithm>
#include <stdexcept>

namespace tautochrone
{
namespace
{

using exact::Fifty;

// A tautochrone through the larger radius at which dr = 0 for the angle phi: it ends there.
Point ending_at(const Fifty& k, const Fifty& phi)
{
  const Fifty half = (1 + k * k) * cos(phi) / 2;
  return {phi, half + sqrt(half * half - k * k), 0};
}

// Where the integration down to phi begins: at the end, or as near as leaves e^-80 of an error there.
// Near the lowest point two curves approach each other as φ to the power (1 - kk)/kk.
Point beginning(const Fifty& k, const Fifty& phi)
{
  Point end = highest_end(k);
  const Fifty enough = falling(phi) - 80 * k * k / ((1 - k) * (1 + k));
  if(falling(end.phi) >= enough)
    return end;
  Fifty lower = phi;
  Fifty upper = end.phi;
  while(enough - falling(upper) > k * k)
  {
    const Fifty middle = (lower + upper) / 2;
    (falling(middle) > enough ? lower : upper) = middle;
  }
  return ending_at(k, upper);
}

}  // namespace

Fifty falling(const Fifty& phi)
{
  return (sin(phi) * sin(phi) - 1) / 2 - log(sin(phi));
}

Point highest_end(const Fifty& k)
{
  if(!(k > 0 && k < 1))
    throw std::domain_error("a pendulum on cheeks needs 0 < k < a, not k/a = " + k.str(6));
  return {atan((1 - k) / sqrt(k)), sqrt(k * (1 - k + k * k)), (1 - k) * (1 - k) / 2};
}

namespace
{

// r at angles that grow, on the tautochrone that ends at `end`; `begin` tells where to begin for an angle.
template <class Start>
std::vector<Fifty> down_from(const Fifty& k, const Point& end, const std::vector<Fifty>& angles,
                             Start begin)
{
  if(k < Fifty("1e-9"))
    throw std::domain_error("k/a is too small to follow the curve: " + k.str(6));
  const Fifty kk = k * k;
  const auto versine = [](const Fifty& phi) { return 2 * sin(phi / 2) * sin(phi / 2); };
  // The slope with respect to h = 1 - cos φ: no sine is left in it.
  const auto right_side = [&](const Fifty& h, const exact::State& r) {
    const Fifty u = kk + r[0] * r[0];
    return exact::State{u * (u - (1 + kk) * r[0] * (1 - h)) / (kk * (1 + kk) * h * (2 - h))};
  };
  std::vector<Fifty> radii;
  Point at = end;
  for(auto phi = angles.rbegin(); phi != angles.rend(); ++phi)
  {
    if(!(*phi >= 0 && *phi <= (radii.empty() ? end.phi : at.phi)))
      throw std::domain_error("the angles must grow up to " + end.phi.str(6) + ", unlike " + phi->str(6));
    const Point start = *phi == 0 ? Point{0, 1, 0} : begin(*phi);
    if(start.phi < at.phi)
      at = start;
    if(*phi != at.phi)
      at.r = solve(right_side, versine(at.phi), {at.r}, versine(*phi), Fifty("1e-30")).y[0];
    at.phi = *phi;
    radii.push_back(at.r);
  }
  std::reverse(radii.begin(), radii.end());
  return radii;
}

}  // namespace

Point widest_end(const Fifty& k)
{
  if(!(k > 0 && k < 1))
    throw std::domain_error("a pendulum on cheeks needs 0 < k < a, not k/a = " + k.str(6));
  const Fifty sine = (1 - k) * (1 + k) / (1 + k * k);
  return {atan2(sine, 2 * k / (1 + k * k)), k, (1 + k * k) / 4 * sine * sine};
}

std::vector<Fifty> highest(const Fifty& k, const std::vector<Fifty>& angles)
{
  return down_from(k, highest_end(k), angles, [&](const Fifty& phi) { return beginning(k, phi); });
}

std::vector<Fifty> through(const Fifty& k, const Fifty& phi, const Fifty& r,
                           const std::vector<Fifty>& angles)
{
  if(!(phi > 0 && r > 0 && (1 + k * k) * r * cos(phi) >= (k * k + r * r) * (1 - Fifty("1e-45"))))
    throw std::domain_error("no cheek leads through this point: dr would be positive there");
  const Point end{phi, r, 0};
  return down_from(k, end, angles, [&](const Fifty&) { return Point(end); });
}

Fifty highest(const Fifty& k, const Fifty& phi)
{
  return highest(k, std::vector<Fifty>{phi})[0];
}

}  // namespace tautochrone
