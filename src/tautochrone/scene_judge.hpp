#pragma once
/** @file
 * What the frames of scene_between_cheeks() are judged by: the equation of motion, the time of the swing and
 * the curve's own integrals, all in fifty digits.
 */
#include "edition/told.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/curve.hpp"
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
std::vector<Judged_frame> judged(const std::vector<edition::ToldRow>& frames, Cheeks cheeks,
                                 const exact::Fifty& k, const exact::Fifty& phi0, const exact::Fifty& unit);

/// Where in these frames a body should be that is let go at φ₀ between cycloids or Euler's cheeks with both
/// corrections. `unit` is that of Euler's clock in seconds.
std::vector<On_curve> places_between(const std::vector<edition::ToldRow>& frames, Cheeks cheeks,
                                     const exact::Fifty& k, const exact::Fifty& phi0,
                                     const exact::Fifty& unit);

/// The places on the highest exact tautochrone, so many swings after the body was let go at φ₀, where the root of the
/// height is a cosine of the time; each found from an angle that is right to 1e-9. Good to 1e-15. Domain: 0.02 ≤ k ≤ 0.9,
/// φ₀ ≤ the end.
std::vector<On_curve> on_highest(const exact::Fifty& k, const exact::Fifty& phi0,
                                 const std::vector<exact::Fifty>& swings,
                                 const std::vector<exact::Fifty>& near);

/// The same in these frames, each found from its "exact_phi"; T is the time of a swing in seconds.
std::vector<On_curve> on_highest(const std::vector<edition::ToldRow>& frames, const exact::Fifty& k,
                                 const exact::Fifty& phi0, const exact::Fifty& T);

}  // namespace tautochrone
