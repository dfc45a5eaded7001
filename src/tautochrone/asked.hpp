#pragma once
/** @file
 * How a reader may ask for a place of a swing.
 */
#include "edition/section.hpp"
#include "tautochrone/thread.hpp"

namespace tautochrone
{

/// The place φ of a swing out to φ₀ between the cheeks, for k = ratio and a = 1. Refuses, by the names of the
/// sections' options, a k that is not from 1e-9 a to 1e9 a, a swing beyond the cheeks' end, and a φ beyond φ₀.
inline Posture<double> asked_posture(Cheeks cheeks, double ratio, double phi0, double phi)
{
  edition::require(ratio >= 1e-9 && ratio <= 1e9, "k", "from 1e-9 a to 1e9 a");
  edition::require(phi0 < largest_amplitude(cheeks, ratio), "phi0",
                   "less than where the thread is all wound");
  edition::require(phi <= phi0, "phi", "at most phi0");
  return on_cheeks<double>(cheeks, ratio, phi0, phi);
}

}  // namespace tautochrone
