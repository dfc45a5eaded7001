#pragma once
/** @file
 * How a reader may ask for a place of a swing, or of Euler's curve.
 */
#include "edition/section.hpp"
#include "tautochrone/thread.hpp"

#include <algorithm>
#include <cstdio>
#include <numbers>

namespace tautochrone
{

/// Nine tenths of the angle at which the thread is all wound, in radians, for k = ratio and a = 1: what a swing may
/// be by default. Not less than 1e-7°, and for a ratio that no section accepts what it is at the nearest one that
/// some does.
inline double ample(Cheeks cheeks, double ratio)
{
  using namespace edition;
  return std::max(0.9 * largest_amplitude(cheeks, std::clamp(ratio, 1e-10, 1e10)), 1e-7_deg);
}

/// The option --phi0 of a pendulum between the cheeks, which swings out to `usual`, or as far as is ample().
inline edition::Parameter<double> asked_swing(double usual, const edition::Parameter<int>& cheeks,
                                              const edition::Parameter<double>& k,
                                              const edition::Parameter<double>& a,
                                              edition::Source source = edition::here())
{
  using namespace edition;
  return angle("phi0",
               at_most(usual, "nine tenths of where the thread is all wound",
                       [=] { return ample(Cheeks(int(cheeks)), k / a); }),
               closed(1e-7_deg, 89_deg), "how far the pendulum swings to either side", source);
}

/// `usual` as the default of a place of the swing out to `phi0`, or that where it is less.
inline edition::Default within_swing(double usual, const edition::Parameter<double>& phi0)
{
  return edition::at_most(usual, "phi0", [phi0] { return phi0.fifty(); });
}

/// Refuses, by its name, a k that is not from 1e-9 a to 1e9 a.
inline void require_ratio(double ratio)
{
  edition::require(ratio >= 1e-9, "k", "from 1e-9 a to 1e9 a");
  edition::require(ratio <= 1e9, "k", "from 1e-9 a to 1e9 a");
}

/// Settings on either side of these limits, for the checks.
/// @{
inline constexpr const char* ratio_within[] = {"k=1e-9", "a=2 k=2e-9", "k=1e9", "a=2 k=2e9"};
inline constexpr const char* ratio_beyond[] = {"k=9.999999999999997e-10", "a=2 k=1.9999999999999994e-9",
                                               "k=1000000000.0000002", "a=2 k=2000000000.0000004"};
/// @}

/// The place φ of a swing out to φ₀, whatever leads the thread, for k = ratio and a = 1: found from the angles as
/// they were written, in fifty digits, and rounded. Near the end of the swing their doubles would leave little of
/// c − x. Refuses, by its name, a φ beyond φ₀. Domain: that of on_cheeks(). Each number is off by half an ulp.
inline Posture<double> posture_as_written(Cheeks cheeks, double ratio,
                                          const edition::Parameter<double>& phi0,
                                          const edition::Parameter<double>& phi)
{
  edition::require(phi.fifty() <= phi0.fifty(), "phi", "at most phi0");
  const auto at = on_cheeks<exact::Fifty>(cheeks, ratio, phi0.fifty(), phi.fifty());
  return {double(at.sin), double(at.cos), double(at.r), double(at.shortening), double(at.to_rise)};
}

/// The same, where k is refused, too, that is not from 1e-9 a to 1e9 a, and a swing beyond the cheeks' end, by the
/// names of the sections' options.
inline Posture<double> asked_posture(Cheeks cheeks, double ratio, const edition::Parameter<double>& phi0,
                                     const edition::Parameter<double>& phi)
{
  require_ratio(ratio);
  edition::require(phi0 < largest_amplitude(cheeks, ratio), "phi0",
                   "less than where the thread is all wound");
  return posture_as_written(cheeks, ratio, phi0, phi);
}

/// Settings on either side of the other limits of a posture asked for, for the checks.
/// @{
inline constexpr const char* posture_within[] = {
    "cheeks=2 k=0.3 phi0=57.5849", "cheeks=3 k=0.3 phi0=47.8289", "cheeks=3 k=0.6 phi0=30.8849",
    "phi0=30 phi=30", "phi0=50 phi=50"};
inline constexpr const char* posture_beyond[] = {
    "cheeks=2 k=0.3 phi0=57.5850", "cheeks=3 k=0.3 phi0=47.8290", "cheeks=3 k=0.6 phi0=30.8850",
    "phi0=30 phi=30.0000000000000000000001", "phi0=50 phi=50.0000000000000000000001"};
/// @}

/// Where Euler's curve with both corrections ends, for k = ratio and a = 1: the angle in radians at which r has
/// come down to zero and the thread is all wound, ½π for a ratio below 1e-10. Refuses, by the names of the
/// sections' options, a k above a, and a φ beyond that end, which it names.
inline double asked_end(double ratio, double phi)
{
  edition::require(ratio <= 1, "k", "at most a");
  const double last = ratio < 1e-10 ? std::numbers::pi / 2 : largest_amplitude(Cheeks::euler_k4, ratio);
  char allowed[80];
  std::snprintf(allowed, sizeof allowed, "less than %.6g°, where r is zero and the thread all wound",
                last * 180 / std::numbers::pi);
  edition::require(phi < last, "phi", allowed);
  return last;
}

}  // namespace tautochrone
