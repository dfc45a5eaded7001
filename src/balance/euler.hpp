/// @file
/// Euler's solution for a balance let go from rest (§33).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "balance/motion.hpp"

namespace balance
{

/// A balance let go from rest, in the letters of §33, and the one number more that the exact equations need.
struct Release
{
  double lambda;  ///< the beam's frequency, √(2g/f), in 1/s
  double mu;      ///< a pan's frequency, √(2g/b), in 1/s
  double i;       ///< λμμa/4g, in 1/s
  Angles<> at;    ///< the inclinations m, n, n′ of beam and pans at the start
  double rho;     ///< Laa/I, which Euler's formulae do not contain
};

/// Euler's example (§35): λ = 1, μ = 3, i = ¼, and a sixth of the radius for each angle. ρ is not his.
inline constexpr Release example_of_35{1, 3, 0.25, {1. / 6, 1. / 6, 1. / 6}, 0.25};

/// The numbers of the balance: since i = λμμa/4g = λa/2b, the arm is to the string as 2i to λ.
inline Balance<> balance_of(const Release& r)
{
  return {r.lambda * r.lambda, r.mu * r.mu, 2 * r.i / r.lambda, r.rho};
}

// [euler]
/// Beam and pans at the time t by Euler's formulae (§33), which are not exact. Precondition: λ ≠ 2μ.
/// Error of the evaluation: a few ulps of the greatest angle, and those of the phases.
inline Angles<> euler(const Release& r, double t)
{
  const auto& [m, n, n1] = r.at;
  const double slower = std::cos((r.mu - r.lambda) * t) / (2 * r.mu - r.lambda);
  const double faster = std::cos((r.mu + r.lambda) * t) / (2 * r.mu + r.lambda);
  const double strays = r.i * m * (slower - faster);
  return {m * std::cos(r.lambda * t), n * (std::cos(r.mu * t) + strays),
          n1 * (std::cos(r.mu * t) - strays)};
}
// [euler]

// [departure]
/// The most, in radians, that η by the full equations departs from η by a formula in one period of the beam, to
/// some four digits (720 moments are looked at). Throws as Motion does.
template <class Formula>
double departure(const Release& r, Formula eta)
{
  const double period = 2 * std::numbers::pi / r.lambda;
  const auto full = course(balance_of(r), {r.at, {}}, period, 720);
  double most = 0;
  for(std::size_t k = 0; k < full.size(); ++k)
    most = std::max(most, std::abs(full[k].at.eta - eta(r, period * static_cast<double>(k) / 720)));
  return most;
}
// [departure]

}  // namespace balance
