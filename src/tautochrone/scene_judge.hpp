#pragma once
/** @file
 * What the frames of scene_between_cheeks() are judged by: the equation of motion, the time of the swing and
 * the curve's own integrals, all in fifty digits.
 */
#include "edition/told.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tautochrone
{

/// A place on a curve whose radius of curvature is r(cos φ), in fifty digits; a = 1.
struct On_curve
{
  exact::Fifty phi;  ///< the angle of the thread, positive to the right
  exact::Fifty r;    ///< what of the thread is free
  exact::Fifty x;    ///< the height above the lowest place
  exact::Fifty y;    ///< how far it is to the right
};

/// Where a body that swings out to φ₀ is at such times, by its equation of motion and the integrals of the curve. Domain:
/// that of angles_by_motion().
inline std::vector<On_curve> places_by_motion(const exact::Laurent<exact::Fifty>& r, const exact::Fifty& k,
                                              const exact::Fifty& phi0,
                                              const std::vector<exact::Fifty>& times)
{
  using exact::Fifty;
  const auto up = [&](const Fifty& at) -> Fifty { return r(cos(at)) * sin(at); };
  const auto aside = [&](const Fifty& at) -> Fifty { return r(cos(at)) * cos(at); };
  const auto from_lowest = [](const auto& f, const Fifty& phi) {
    return phi == 0 ? Fifty(0) : exact::integrate(f, 0, phi).value;
  };
  std::vector<On_curve> places;
  for(const Fifty& phi : angles_by_motion(r, k, phi0, times))
    places.push_back({phi, r(cos(phi)), from_lowest(up, phi), from_lowest(aside, phi)});
  return places;
}

/// A frame as it was told, and what it should be.
struct Judged_frame
{
  edition::ToldRow told;                                    ///< the frame
  exact::Fifty t;                                           ///< its time in seconds
  std::vector<std::pair<std::string, exact::Fifty>> right;  ///< the other columns, by their names
  double slack;                                             ///< how far these may be off
  /// And why.
  static constexpr const char* because = "the clock's bound, and some roundings of the curve's terms";
};

/// Frames that lie evenly in a period, the first at its begin and the last at its end, of the scene between
/// cycloids or Euler's cheeks with both corrections. `unit` is that of Euler's clock in seconds. Domain:
/// 1e-4 ≤ φ₀.
inline std::vector<Judged_frame> judged(const std::vector<edition::ToldRow>& frames, Cheeks cheeks,
                                        const exact::Fifty& k, const exact::Fifty& phi0,
                                        const exact::Fifty& unit)
{
  using exact::Fifty;
  const auto r = truncated(cheeks == Cheeks::cycloids ? 0 : 2, k);
  const Fifty T = exact::pi() * sqrt(2 * (1 + k * k)) * (1 + excess(r, k, phi0));
  std::vector<Fifty> times;
  for(std::size_t i = 0; i < frames.size(); ++i)
    times.push_back(2 * T * static_cast<int>(i) / static_cast<int>(frames.size() - 1));
  const auto places = places_by_motion(r, k, phi0, times);
  std::vector<Judged_frame> result;
  for(std::size_t i = 0; i < frames.size(); ++i)
  {
    const On_curve& at = places[i];
    const Fifty s = sin(at.phi), c = cos(at.phi), x = at.y, y = at.x - 1;
    Judged_frame frame{frames[i], unit * times[i], {}, 1e-13 * (1 + static_cast<double>(k))};
    frame.right = {{"phi", at.phi}, {"M_x", x - at.r * s}, {"M_y", y + at.r * c}, {"G_x", x}, {"G_y", y}};
    if(k > 0)
      for(const auto& [name, l] : {std::pair<std::string, Fifty>{"upper", -k}, {"lower", k}})
      {
        frame.right.emplace_back(name + "_x", x + l * s);
        frame.right.emplace_back(name + "_y", y - l * c);
      }
    result.push_back(frame);
  }
  return result;
}

/// The place on the highest exact tautochrone, so many swings after the body was let go at φ₀, where the root of the height is a cosine of the
/// time; found from an angle that is right to 1e-9. Good to 1e-15. Domain: 0.02 ≤ k ≤ 0.9, φ₀ ≤ the end.
inline On_curve on_highest(const exact::Fifty& k, const exact::Fifty& phi0, const exact::Fifty& swings,
                           const exact::Fifty& near)
{
  using exact::Fifty;
  const Fifty kk = k * k, lowest("1e-9");
  const auto radius_at = [&](const Fifty& to) { return to > lowest ? highest(k, to) : Fifty(1); };
  const auto root = [&](const Fifty& r, const Fifty& to) -> Fifty {  // of the height, by (2) of §25
    return sqrt((1 + kk) / 2 / (kk + r * r)) * r * sin(to);
  };
  const Fifty cosine_of_t = cos(exact::pi() * swings),
              wanted = root(highest(k, phi0), phi0) * abs(cosine_of_t);
  Fifty to = abs(near);
  const Fifty r = radius_at(to);
  to -= (root(r, to) - wanted) * sqrt(2 * (1 + kk) / (kk + r * r));
  if(to > phi0)
    to = phi0;
  On_curve place{to, radius_at(to), wanted * wanted, to};
  const Fifty low("1e-13");
  if(to > low)  // the breadth is followed down the equation with r
    place.y = low
              - exact::solve(
                    [&](const Fifty& phi, const exact::State& at) -> exact::State {
                      return {slope<Fifty>(phi, at[0], k), at[0] * cos(phi)};
                    },
                    to, {place.r, 0}, low, Fifty("1e-16"))
                    .y[1];
  if(cosine_of_t < 0)
  {
    place.phi = -place.phi;
    place.y = -place.y;
  }
  return place;
}

}  // namespace tautochrone
