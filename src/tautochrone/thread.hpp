#pragma once
/** @file
 * The body on its wound thread (§§8 to 18): speeds, accelerations, the places Z and H, the forces.
 *
 * Lengths are in units of a, forces in units of the body's weight. Euler's clock: the velocity is the
 * square root of the height fallen, so that g = ½ and a force P gives the acceleration ½P/M.
 */
#include "tautochrone/cheeks.hpp"

#include <cmath>

namespace tautochrone
{

/**
 * A place of a swing, as far as the mechanics needs it: the angle, the radius of curvature r = MG, how
 * fast that shortens, −dr/dφ over sin φ (on a cycloid 1, on a circle 0; finite in the lowest point), and
 * c − x, how far G has still to rise.
 */
template <class Real>
struct Posture
{
  Real sin;         ///< sin φ
  Real cos;         ///< cos φ
  Real r;           ///< MG
  Real shortening;  ///< −dr/(dφ sin φ), not negative where the thread winds itself on the cheek
  Real to_rise;     ///< c − x, not negative
};

// [motion]
/// (dφ/dt)², by the integral of §17. Domain: k ≥ 0, kk + rr > 0. A few ulps off.
template <class Real>
Real turning2(const Posture<Real>& at, const Real& k)
{
  return at.to_rise / (k * k + at.r * at.r);
}

/// v, the height due to the velocity of G (§18).
template <class Real>
Real speed_height(const Posture<Real>& at, const Real& k)
{
  return at.r * at.r * turning2(at, k);
}

/// 2ddφ/dt², from the equation of §17; negative in the upper part of the rise, zero in the lowest point.
template <class Real>
Real twice_acceleration(const Posture<Real>& at, const Real& k)
{
  const Real wound = 1 - 2 * at.shortening * turning2(at, k);
  return -at.r * at.sin * wound / (k * k + at.r * at.r);
}

/// P over the weight, the force at right angles to MG that would do what gravity does (§16). Both its
/// terms are positive where the thread winds itself on the cheek.
template <class Real>
Real force(const Posture<Real>& at, const Real& k)
{
  const Real kk = k * k, rr = at.r * at.r;
  return at.sin * (rr + 2 * kk * at.shortening * turning2(at, k)) / (kk + rr);
}

/// GH = kk/MG, of the centre of oscillation for the axis M (§10). Domain: r > 0.
template <class Real>
Real GH(const Posture<Real>& at, const Real& k)
{
  return k * k / at.r;
}

/// GZ, where the force P must attack (§15), on any cheek; in the lowest point its limit. It loses digits
/// where Z comes near to G; on cycloids cycloidal_GZ() does not, see GZ_on_cheeks().
template <class Real>
Real GZ(const Posture<Real>& at, const Real& k)
{
  const Real kk = k * k, turning = 2 * at.shortening * turning2(at, k);
  return kk * at.r * (1 - turning) / (at.r * at.r + kk * turning);
}
// [motion]

/// The pull along the thread over the weight: cos φ and what bends the path of G.
template <class Real>
Real tension(const Posture<Real>& at, const Real& k)
{
  return at.cos + 2 * at.r * turning2(at, k);
}

/// What the free part must bear across at M, over the weight, because the body is made to turn with it; a
/// thread that is limp cannot. R = −kk·2ddφ/(r dt²), which is P·GZ/r: on cycloids take it from
/// cycloidal_GZ(), for here, as in twice_acceleration(), digits are lost where Z comes near to G.
template <class Real>
Real across(const Posture<Real>& at, const Real& k)
{
  return -k * k * twice_acceleration(at, k) / at.r;
}

/**
 * A place of a swing out to φ₀ on Huygens's cheeks, c − x as a product of two sines.
 *
 * Domain: 0 ≤ |φ| ≤ φ₀ < ½π. In double the quantities above are then good to 1e-14 of themselves, but for
 * GZ(), twice_acceleration() and across(): these to 1e-14 and 1e-15 (kk + cos²φ)/(kk + cos²φ₀), which is
 * four digits lost for small k and φ₀ = 89°.
 */
template <class Real>
Posture<Real> on_cycloids(const Real& phi0, const Real& phi)
{
  using std::cos, std::sin;
  return {sin(phi), cos(phi), cos(phi), Real(1), sin(phi0 - phi) * sin(phi0 + phi) / 2};
}

/// A place of a swing out to φ₀ on a fixed axis. Domain: 0 ≤ |φ| ≤ φ₀ ≤ π.
template <class Real>
Posture<Real> on_circle(const Real& phi0, const Real& phi)
{
  using std::cos, std::sin;
  return {sin(phi), cos(phi), Real(1), Real(0), 2 * sin((phi0 - phi) / 2) * sin((phi0 + phi) / 2)};
}

/// (c − x)/(cos²φ − cos²φ₀) between Euler's cheeks with one or two corrections, from e = 1/cos²φ and e₀: the
/// divided difference of x in cos²φ. Domain: k ≥ 0, e and e₀ ≥ 1. Rounding: a few ulps of the terms.
template <class Real>
Real rise_of_euler(int corrections, const Real& k, const Real& e0, const Real& e)
{
  const Real kappa = k * k, square = corrections == 2 ? Real(kappa * kappa) : Real(0);
  const Real down = kappa / 2 + square * (e0 * e0 + e0 * e + e * e - Real(3) / 2 * (e0 + e));
  return (1 + kappa) / 2 - e * e0 * down;
}

/**
 * A place of a swing out to φ₀ between Euler's cheeks with one or two corrections (§30). c − x is a product
 * of two sines and a divided difference of x, which is a polynomial in cos²φ and its inverse.
 *
 * Domain: k ≥ 0, 0 ≤ |φ| ≤ φ₀, and φ₀ before the end of the curve, where r > 0. In double r, the shortening
 * and c − x err by less than 1e-14 of the sum of their terms' sizes.
 */
template <class Real>
Posture<Real> on_euler(int corrections, const Real& k, const Real& phi0, const Real& phi)
{
  using std::cos, std::sin;
  const Real s = sin(phi), c = cos(phi), c0 = cos(phi0);
  const Real e = 1 / (c * c), e0 = 1 / (c0 * c0), t = s * s * e;
  const Real kappa = k * k, square = corrections == 2 ? Real(kappa * kappa) : Real(0);
  return {s, c, c * (1 - t * (kappa * (2 + t) + 6 * square * e * e * e)),
          1 + kappa * (1 + 3 * e * e) + square * e * e * e * (12 + 42 * t),
          sin(phi0 - phi) * sin(phi0 + phi) * rise_of_euler(corrections, k, e0, e)};
}

/// A place of a swing out to φ₀, whatever leads the thread: the one of the three above. Domain: theirs.
template <class Real>
Posture<Real> on_cheeks(Cheeks cheeks, const Real& k, const Real& phi0, const Real& phi)
{
  switch(cheeks)
  {
    case Cheeks::none:
      return on_circle(phi0, phi);
    case Cheeks::cycloids:
      return on_cycloids(phi0, phi);
    default:
      return on_euler(cheeks == Cheeks::euler_k4 ? 2 : 1, k, phi0, phi);
  }
}

/**
 * GZ on Huygens's cheeks: kk c(kk + c₀²)/(c²(kk + c²) + kk(c² − c₀²)), c = cos φ. Every term is positive,
 * so that Z never reaches G there. Domain: 0 ≤ |φ| ≤ φ₀ < ½π. In double good to 1e-14 of itself.
 */
template <class Real>
Real cycloidal_GZ(const Real& k, const Real& phi0, const Real& phi)
{
  using std::cos, std::sin;
  const Real kk = k * k, c = cos(phi), cc = c * c, c0 = cos(phi0);
  return kk * c * (kk + c0 * c0) / (cc * (kk + cc) + kk * sin(phi0 - phi) * sin(phi0 + phi));
}

/// GZ on a swing out to φ₀, whatever leads the thread: cycloidal_GZ() between cycloids, elsewhere GZ(). Domain: that of
/// on_cheeks().
template <class Real>
Real GZ_on_cheeks(Cheeks cheeks, const Real& k, const Real& phi0, const Real& phi)
{
  return cheeks == Cheeks::cycloids ? cycloidal_GZ(k, phi0, phi) : GZ(on_cheeks(cheeks, k, phi0, phi), k);
}

/// M on Huygens's cheek and G on its involute, to the right of A and below it, for a = 1.
template <class Real>
struct CycloidalPlaces
{
  Real q;        ///< PM, of M
  Real p;        ///< AP, of M
  Real G_aside;  ///< QG
  Real G_down;   ///< AQ
};

/// These places, by subtraction: meant for fifty digits. In double they err by 1e-15 of a; euler_q() and
/// euler_p() lose nothing at small angles.
template <class Real>
CycloidalPlaces<Real> cycloidal_places(const Real& phi)
{
  using std::cos, std::sin;
  const Real s = sin(phi), c = cos(phi), q = (phi - s * c) / 2, p = s * s / 2;
  return {q, p, q + c * s, p + c * c};
}

}  // namespace tautochrone
