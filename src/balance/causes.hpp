/// @file
/// The causes by which the motion of one pan passes to the other (§38), side by side in one beam and its pans, those of
/// the designed instrument; and the same looked at by other rules, to judge them.
#pragma once

#include <array>
#include <vector>

#include "balance/exchange.hpp"
#include "balance/hung.hpp"
#include "exact/fifty.hpp"

namespace balance
{

/// {η, ϑ} of the exact motion at times that never go back, as farthest() of exchange.hpp wants it.
inline auto pans(const Suspended& s, const Full_state& from)
{
  return [motion = Full_motion(s, from)](double t) mutable {
    const Four now = motion.to(t).at;
    return std::array<double, 2>{now.eta, now.theta};
  };
}

/// What can pass P's motion on.
enum class Cause
{
  pivot,  ///< C can move
  beam,   ///< C is fixed, and the beam swings
  ends,   ///< C is fixed, and A and B lie lower by a/10
  none    ///< C is fixed, A and B in line with it, the beam at rest
};

/// The causes compared.
namespace causes
{

constexpr double of_P = 1. / 20;                       ///< P's first, radians
constexpr double of_beam = 1. / 6;                     ///< the beam's, where it is let go too, radians
constexpr double look = 3.14159265358979323846 / 128;  ///< an eighth of a radian of the pans, s
inline constexpr Full_state only_P{.at = {0, 0, of_P, 0}, .rate = Four()};  ///< P let go alone

/// The balance with a cause; for Cause::beam and Cause::none that with nothing but the fixed pivot.
constexpr Suspended balance_with(Cause by)
{
  return {designed.beam, by == Cause::pivot ? designed.h : 1, by == Cause::ends ? 0.2 : 0,
          by == Cause::pivot};
}

/// The time in which all passes, in theory, s: transfer() or, for the beam, averaged(); ∞ for Cause::none.
double theory(Cause by);

/// When Q leans farthest by the full equations, until one and a half times what theory has (for Cause::none, as with
/// Cause::pivot), and how far. Where the beam swings, of both pans the mean over four of its swings to and fro.
Farthest passing(Cause by);

/// A moment, and how far Q swings about it, in parts of P's first swing: 131 until 1.3 times what theory has, which must
/// not be Cause::none. Where the beam swings, equally far apart; else their logarithms, from the cube root of six seconds
/// or more.
std::vector<std::array<double, 2>> way(Cause by);

/// @name To judge by
/// @{

/// theory() in fifty digits: what was designed, the formula of §31, and the two frequencies of §37 by their quadratic.
/// @throws std::invalid_argument for Cause::none
exact::Fifty theory_exactly(Cause by);

/// passing() by other rules: by links and the classical rule in steps of a third of a look, where the error is below 1e-4
/// of the swing; where the beam swings by mean_by_gsl() about the moment that passing() has.
Farthest judged(Cause by);

/// The pans' swings where the beam swings, in the mean over four of its swings about the moment `middle`, by GSL.
Envelope mean_by_gsl(double middle);

/// @}

}  // namespace causes
}  // namespace balance
