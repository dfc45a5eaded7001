#pragma once
/** @file
 * Euler's curve and its cheek through k⁴ (§§30 to 34), in forms that lose nothing at small angles.
 *
 * Lengths are in the unit of a and k; φ is in radians, 0 ≤ φ < ½π (each quantity is an even or an odd
 * function of it). With t = tan²φ and κ = kk/aa Euler's sums become polynomials in t; all terms of s, p
 * and q are positive, those of r, x, y and z with κ are subtracted from the cycloid's. Nothing here is
 * refused: where r ≤ 0 the thread is all wound and the curve has ended, see end_of_truncated().
 *
 * `Real` is double or exact::Fifty. In double every quantity errs by less than 1e-14 of the sum of its
 * terms' sizes, for any 0 ≤ k/a ≤ 1e20; s, p, q and ds/dφ therefore by less than 1e-14 of themselves.
 */
#include "exact/fifty.hpp"

#include <cmath>

namespace tautochrone
{

/// The small number κ = kk/aa of a body and the functions of an angle that all of Euler's formulae share.
template <class Real>
struct Place
{
  Real kappa;  ///< kk/aa
  Real sin;    ///< sin φ
  Real cos;    ///< cos φ
  Real t;      ///< tan²φ
};

/// Both prepared. Domain: a > 0, k ≥ 0, |φ| < ½π.
template <class Real>
Place<Real> place(const Real& a, const Real& k, const Real& phi)
{
  using std::cos, std::sin;
  const Real s = sin(phi), c = cos(phi), tangent = s / c;
  return {(k / a) * (k / a), s, c, tangent * tangent};
}

namespace parts
{

/// Σ cₙ uⁿ over n ≥ 0 with c₀ = first and cₙ₊₁ = cₙ·ratio(n), until nothing is added any more; |u| < 1.
template <class Real, class Ratio>
Real sum(const Real& first, const Real& u, Ratio ratio)
{
  Real total = first, term = first;
  for(int n = 0; n < 2000; ++n)
  {
    term *= u * ratio(n);
    const Real next = total + term;
    if(next == total)
      break;
    total = next;
  }
  return total;
}

/// φ − sin φ cos φ, by the sine's series below half a radian.
template <class Real>
Real segment(const Real& phi)
{
  using std::sin;
  const Real u = 2 * phi;
  if(phi > 0.5 || phi < -0.5)
    return phi - sin(u) / 2;
  return u * u * u / 12 * sum<Real>(1, -u * u, [](int n) { return Real(1) / ((2 * n + 4) * (2 * n + 5)); });
}

/// ∫dφ(1/cos³φ − cos φ) from 0: with w = sin φ this is ∫dw((1 − ww)⁻² − 1).
template <class Real>
Real arc_of_kk(const Place<Real>& at, const Real& phi)
{
  using std::asinh, std::tan;
  const Real w = at.sin, ww = w * w;
  if(ww > 0.25)
    return (w / (at.cos * at.cos) + asinh(tan(phi))) / 2 - w;
  return w * ww * sum<Real>(Real(2) / 3, ww, [](int n) {
           return Real((n + 3) * (2 * n + 3)) / ((n + 2) * (2 * n + 5));
         });
}

/// ∫dφ sin²φ/cos⁷φ from 0: this is ∫dw ww(1 − ww)⁻⁴.
template <class Real>
Real arc_of_k4(const Place<Real>& at, const Real& phi)
{
  using std::asinh, std::tan;
  const Real w = at.sin, ww = w * w, e = 1 / (at.cos * at.cos);
  if(ww > 0.25)
    return w * e * (e * (e / 6 - Real(1) / 24) - Real(1) / 16) - asinh(tan(phi)) / 16;
  return w * ww * sum<Real>(Real(1) / 3, ww, [](int n) {
           return Real((n + 4) * (2 * n + 3)) / ((n + 1) * (2 * n + 5));
         });
}

/// ∫dφ(1/cos²φ − cos²φ) from 0: with w = tan φ this is ∫dw(1 − (1 + ww)⁻²).
template <class Real>
Real width_of_kk(const Place<Real>& at, const Real& phi)
{
  using std::tan;
  const Real w = tan(phi);
  if(at.t > 0.25)
    return w - (phi + at.sin * at.cos) / 2;
  return w * at.t * sum<Real>(Real(2) / 3, -at.t, [](int n) {
           return Real((n + 3) * (2 * n + 3)) / ((n + 2) * (2 * n + 5));
         });
}

}  // namespace parts

// [curve]
/// r = MG, the radius of curvature (§30).
template <class Real>
Real euler_r(const Real& a, const Real& k, const Real& phi)
{
  const auto [kappa, s, c, t] = place(a, k, phi);
  return a * c * (1 - kappa * t * ((2 + t) + 6 * kappa * (1 + t) * (1 + t) * (1 + t)));
}

/// z = CG, the arc from the lowest point (§32).
template <class Real>
Real euler_z(const Real& a, const Real& k, const Real& phi)
{
  const auto at = place(a, k, phi);
  return a * (at.sin - at.kappa * (parts::arc_of_kk(at, phi) + 6 * at.kappa * parts::arc_of_k4(at, phi)));
}

/// x = CQ, the height above the lowest point (§32).
template <class Real>
Real euler_x(const Real& a, const Real& k, const Real& phi)
{
  const auto [kappa, s, c, t] = place(a, k, phi);
  return a / 2 * s * s * (1 - kappa * t * (1 + kappa * (1 + t) * (3 + 2 * t)));
}

/// y = QG, how far the curve is from the vertical (§32).
template <class Real>
Real euler_y(const Real& a, const Real& k, const Real& phi)
{
  const auto at = place(a, k, phi);
  const Real of_k4 = at.sin / at.cos * at.t * (2 + Real(6) / 5 * at.t);
  return a * ((phi + at.sin * at.cos) / 2 - at.kappa * (parts::width_of_kk(at, phi) + at.kappa * of_k4));
}
// [curve]

// [cheek]
/// s = AM, the arc of the cheek that the thread lies on (§33): a − r without the subtraction.
template <class Real>
Real euler_s(const Real& a, const Real& k, const Real& phi)
{
  using std::sin;
  const auto [kappa, s, c, t] = place(a, k, phi);
  const Real half = sin(phi / 2);
  return a * (2 * half * half + c * kappa * t * ((2 + t) + 6 * kappa * (1 + t) * (1 + t) * (1 + t)));
}

/// ds/dφ, the cheek's own radius of curvature (§33).
template <class Real>
Real euler_ds(const Real& a, const Real& k, const Real& phi)
{
  const auto [kappa, s, c, t] = place(a, k, phi);
  const Real e = 1 + t;
  return a * s * (1 + kappa * (1 + e * e * (3 + kappa * e * (12 + 42 * t))));
}

/// p = AP, the depth of the place where the thread leaves the cheek, below A (§34).
template <class Real>
Real euler_p(const Real& a, const Real& k, const Real& phi)
{
  const auto [kappa, s, c, t] = place(a, k, phi);
  return a / 2 * (s * s + kappa * (s * s + t * (3 + kappa * (12 + t * (27 + 14 * t)))));
}

/// q = PM, how far that place is from the vertical (§34).
template <class Real>
Real euler_q(const Real& a, const Real& k, const Real& phi)
{
  const auto [kappa, s, c, t] = place(a, k, phi);
  const Real of_kk = parts::segment(phi) / 2 + s / c * t;
  const Real of_k4 = s / c * t * (4 + t * (Real(54) / 5 + 6 * t));
  return a * (parts::segment(phi) / 2 + kappa * (of_kk + kappa * of_k4));
}
// [cheek]

/// How far one of these lengths is off Huygens's, which has k = 0. It is reckoned in fifty digits: of a small
/// body it may be less than a rounding.
inline double off_huygens(exact::Fifty (*length)(const exact::Fifty& a, const exact::Fifty& k,
                                                 const exact::Fifty& phi),
                          const exact::Fifty& a, const exact::Fifty& k, const exact::Fifty& phi)
{
  return static_cast<double>(length(a, k, phi) - length(a, 0, phi));
}

}  // namespace tautochrone
