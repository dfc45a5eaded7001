/// @file
/// How much energy a motion has, and where the ball stands: both given so that no digit is lost near the top.
///
/// The energy is the number h: what the motion has at the lowest place over what it would take to stand still
/// at the highest. On a smooth plane h = ζζkk/8gc, where the ball rolls h = ζζbb/8gc, ζ being the angular
/// velocity at the lowest place. With h < 1 the ball rocks up to sin² ½Φ = h, with h > 1 it turns over and
/// over, and between them is Euler's Case II. His constants Γ (§11) and C (§25) are c(2h − 1), his n (§21) is
/// √2h.
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "exact/fifty.hpp"
#include "globe/ball.hpp"

namespace globe
{

/// h and 1 − h. Whoever knows the second better than by subtraction gives it.
template <class Real>
struct Energy
{
  Real h;         ///< 0 ≤ h, finite
  Real from_top;  ///< 1 − h, negative where the ball turns over

  /// Whether the ball turns over and over.
  bool turns_over() const { return from_top < 0; }
};

/// Throws std::domain_error unless h is 0 or more and finite, and 1 − h agrees.
template <class Real>
void require(const Energy<Real>& e)
{
  using std::isfinite;
  const bool agree = e.from_top < 0 ? e.h >= 1 : e.from_top <= 1 && e.h <= 1;
  if(!(e.h >= 0) || !isfinite(e.h) || !agree)
    throw std::domain_error("the energy must be 0 or more and finite");
}

/// From h. Throws std::domain_error unless 0 ≤ h < ∞.
template <class Real>
Energy<Real> energy(const Real& h)
{
  Energy<Real> e{h, 1 - h};
  require(e);
  return e;
}

/// From 1 − h, at most 1: below the top where it is positive, above where it is negative.
template <class Real>
Energy<Real> energy_from_top(const Real& below)
{
  Energy<Real> e{1 - below, below};
  require(e);
  return e;
}

/// From 1 − h where that is not 0, else from h: as a reader gives it.
template <class Real>
Energy<Real> energy_given(const Real& h, const Real& from_top)
{
  return from_top == 0 ? energy(h) : energy_from_top(from_top);
}

/// From the amplitude Φ of a ball that rocks, 0 ≤ Φ ≤ π.
template <class Real>
Energy<Real> energy_of_amplitude(const Real& Phi)
{
  using std::cos, std::sin;
  const Real s = sin(Phi / 2), c = cos(Phi / 2);
  Energy<Real> e{s * s, c * c};
  require(e);
  return e;
}

/// From what its amplitude lacks of half a turn.
template <class Real>
Energy<Real> energy_of_amplitude_from_top(const Real& eta)
{
  const Energy<Real> other = energy_of_amplitude(eta);
  return {other.from_top, other.h};
}

/// From the angular velocity ζ at the lowest place, kk being k k on a smooth plane (§11) and bb where the ball
/// rolls (§29). In double 1 − h is rounded once: it is as exact as ζ is.
/// Throws std::domain_error unless c, kk, g > 0 and h is finite.
template <class Real>
Energy<Real> energy_of_velocity(const Real& c, const Real& kk, const Real& g, const Real& zeta)
{
  if(!(c > 0 && kk > 0 && g > 0))
    throw std::domain_error("the energy of a velocity needs c, the moment of inertia and g positive");
  using exact::Fifty;
  const Fifty h = Fifty(zeta) * Fifty(zeta) * Fifty(kk) / (8 * Fifty(g) * Fifty(c));
  Energy<Real> e{static_cast<Real>(h), static_cast<Real>(1 - h)};
  require(e);
  return e;
}

/// The angular velocity at the lowest place, from h; arguments as before.
template <class Real>
Real velocity_of_energy(const Real& c, const Real& kk, const Real& g, const Energy<Real>& e)
{
  using std::sqrt;
  return sqrt(8 * g) * sqrt(c) * sqrt(e.h) / sqrt(kk);
}

/// Where the ball stands: the sine and the cosine of ½Φ, 0 ≤ Φ ≤ π.
template <class Real>
struct Place
{
  Real s;  ///< sin ½Φ
  Real c;  ///< cos ½Φ, small near the top
};

/// h − sin² ½Φ: what is left of the energy for motion, from whichever pair keeps its digits. In fifty digits what is
/// less than a part in 10⁴⁵ of what it is formed from is nothing: there the ball turns back.
template <class Real>
Real left_for_motion(const Energy<Real>& e, const Place<Real>& place)
{
  const Real whole = e.h < 0.5 ? e.h : Real(place.c * place.c);
  const Real left = e.h < 0.5 ? Real(e.h - place.s * place.s) : Real(whole - e.from_top);
  if constexpr(std::is_same_v<Real, exact::Fifty>)
    if(abs(left) <= 1e-45 * whole)
      return 0;
  return left;
}

/// Whether a ball with that energy gets to the place, be it the last.
inline bool gets_to(const Energy<exact::Fifty>& e, const Place<exact::Fifty>& place)
{
  return left_for_motion(e, place) >= 0;
}

/// From Φ, 0 ≤ Φ ≤ π, else std::domain_error.
template <class Real>
Place<Real> place(const Real& Phi)
{
  using std::cos, std::sin;
  Place<Real> p{sin(Phi / 2), cos(Phi / 2)};
  if(!(Phi >= 0 && p.c >= 0))
    throw std::domain_error("the angle must lie between 0 and half a turn");
  return p;
}

/// From what Φ lacks of half a turn, 0 ≤ ψ ≤ π, else std::domain_error.
template <class Real>
Place<Real> place_from_top(const Real& psi)
{
  const Place<Real> other = place(psi);
  return {other.c, other.s};
}

/// Where the ball is at a time: the angle, and what it lacks of the top.
struct Turned
{
  double Phi;  ///< Φ, with its sign, and with all turns done
  double
      from_top;  ///< π − |Φ| of a ball that rocks, of one that turns over the angle to the nearest top: 0 … π
};

/// A number as the program computes with it, from fifty digits: both members of each pair rounded once.
/// @{
inline Energy<double> rounded(const Energy<exact::Fifty>& e)
{
  return {static_cast<double>(e.h), static_cast<double>(e.from_top)};
}
inline Place<double> rounded(const Place<exact::Fifty>& p)
{
  return {static_cast<double>(p.s), static_cast<double>(p.c)};
}
/// @}

}  // namespace globe
