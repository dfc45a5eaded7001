/// @file
/// Euler's solution for a balance let go from rest (§33), the exact motion, and what lies between the two.
#pragma once

#include <vector>

#include "balance/motion.hpp"

namespace balance
{

/// A balance let go from rest, in the letters of §33, and the one number more that the exact equations need.
struct Release
{
  double lambda, mu, i;  ///< in 1/s; i = λμμa/4g
  Angles<> at;           ///< the inclinations m, n, n′ of beam and pans at the start
  double rho;            ///< Laa/I, which Euler's formulae do not contain
};

/// Euler's example (§35): λ = 1, μ = 3, i = ¼, and a sixth of the radius for each angle. ρ is not his.
inline constexpr Release example_of_35{1, 3, 0.25, {1. / 6, 1. / 6, 1. / 6}, 0.25};

/// The numbers of the balance: since i = λμμa/4g = λa/2b, the arm is to the string as 2i to λ.
Balance<> balance_of(const Release& r);

// [euler]
/// Beam and pans at the time t by Euler's formulae (§33), which are not exact. Precondition: λ ≠ 2μ.
/// Error of the evaluation: a few ulps of the greatest angle, and those of the phases.
inline Angles<> euler(const Release& r, double t)
{
  const auto& [m, n, n1] = r.at;
  const double slower = std::cos((r.mu - r.lambda) * t) / (2 * r.mu - r.lambda);
  const double faster = std::cos((r.mu + r.lambda) * t) / (2 * r.mu + r.lambda);
  const double strays = r.i * m * (slower - faster);
  return {m * std::cos(r.lambda * t), n * (std::cos(r.mu * t) + strays), n1 * (std::cos(r.mu * t) - strays)};
}
// [euler]

/// One moment of a motion, known in four ways.
struct Moment
{
  double t;
  Angles<> exact;         ///< by integration of the full equations
  Angles<> euler;         ///< by euler()
  Angles<> second_order;  ///< by second_order()
  Angles<> lengthened;    ///< the same with the pans' period longer by the factor 1 + n²/16
};

/// The motion through one period of the beam, 2π/λ, at `parts` + 1 moments equally far apart.
/// @throws std::domain_error and std::runtime_error as Motion does. Precondition: parts ≥ 1
std::vector<Moment> one_period(const Release& r, int parts);

/// For η at one moment: what Euler's formula adds to n cos μt, and the truth less each of the solutions.
struct Departure
{
  double strays, from_euler, from_second_order, from_lengthened;
};

inline Departure departure(const Release& r, const Moment& now)
{
  return {now.euler.eta - r.at.eta * std::cos(r.mu * now.t), now.exact.eta - now.euler.eta,
          now.exact.eta - now.second_order.eta, now.exact.eta - now.lengthened.eta};
}

/// The greatest of each in one period of the beam, to some four digits (720 moments are looked at).
Departure greatest_departure(const Release& r);

}  // namespace balance
