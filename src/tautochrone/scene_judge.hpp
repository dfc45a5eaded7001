#pragma once
/** @file
 * What the frames of scene_between_cheeks() are judged by: the equation of motion, the time of the swing and
 * the curve's own integrals, all in fifty digits.
 */
#include "edition/told.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tautochrone
{

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
  const auto angles = angles_by_motion(r, k, phi0, times);
  std::vector<Judged_frame> result;
  for(std::size_t i = 0; i < frames.size(); ++i)
  {
    const Fifty& phi = angles[i];
    const Fifty s = sin(phi), c = cos(phi), free = r(c);
    const auto aside = [&](const Fifty& x) -> Fifty { return r(cos(x)) * cos(x); };
    const auto up = [&](const Fifty& x) -> Fifty { return r(cos(x)) * sin(x); };
    const Fifty x = phi == 0 ? Fifty(0) : exact::integrate(aside, 0, phi).value;
    const Fifty y = (phi == 0 ? Fifty(0) : exact::integrate(up, 0, phi).value) - 1;
    Judged_frame frame{frames[i], unit * times[i], {}, 1e-13 * (1 + static_cast<double>(k))};
    frame.right = {{"phi", phi}, {"M_x", x - free * s}, {"M_y", y + free * c}, {"G_x", x}, {"G_y", y}};
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

}  // namespace tautochrone
