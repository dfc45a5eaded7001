/// @file
/// The ball and its equations of motion, as §§2-7 of the paper set them up.
///
/// Euler's letters and units: g is the height fallen from rest in the first second, so that the acceleration
/// of gravity is 2g; weights serve as masses; the friction λΠ is positive when it acts backwards, against
/// the motion. Lengths are in any unit, times in seconds, angles in radians.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "exact/fifty.hpp"

namespace globe
{

/// A ball whose centre of gravity G is not its centre C.
template <class Real>
struct Ball
{
  Real a;  ///< its radius, a > 0
  Real c;  ///< the distance CG, c ≥ 0
  Real k;  ///< the moment of inertia about the axis through G is weight · kk, k > 0

  /// a − c, how far G lies above the lowest point. Whoever knows it better than by subtraction gives it: where c is
  /// nearly a, all that rolls hangs on its digits.
  Real gap = a - c;
};

/// A ball as the program computes with it, from fifty digits: each member rounded once, a − c too.
inline Ball<double> rounded(const Ball<exact::Fifty>& ball)
{
  return {static_cast<double>(ball.a), static_cast<double>(ball.c), static_cast<double>(ball.k),
          static_cast<double>(ball.gap)};
}

/// And back, its members in agreement to fifty digits: where c is within half of a it is a − c that counts, else c.
inline Ball<exact::Fifty> exactly(const Ball<double>& ball)
{
  using exact::Fifty;
  const Fifty a = ball.a, gap = ball.gap;
  return 2 * abs(gap) < a ? Ball<Fifty>{a, a - gap, ball.k, gap} : Ball<Fifty>{a, ball.c, ball.k};
}

/// The ball of the programs, in feet: a homogeneous one of weight 4/5 and radius 1 with a pellet of weight 1/5
/// halfway down to its surface. Euler gives no numbers.
template <class Real>
inline const Ball<Real> our_ball{1, Real(1) / 10, Real(3) / 5};
/// The height fallen in the first second, in feet: 15⅝.
template <class Real>
inline const Real our_g = Real(125) / 8;
/// A cradle, far from Euler's small c: its centre of gravity lies halfway to the surface.
template <class Real>
inline const Ball<Real> cradle{1, Real(1) / 2, Real(1) / 2};
/// The height fallen in the unit of time where the cradle is told of: then 2g = 1.
template <class Real>
inline const Real cradle_g = Real(1) / 2;

/// bb = (a − c)² + kk, the moment of inertia about the lowest point over the weight (§30).
template <class Real>
Real bb(const Ball<Real>& ball)
{
  return ball.gap * ball.gap + ball.k * ball.k;
}

/// BB = (a + c)² + kk, the same about the highest point.
template <class Real>
Real BB(const Ball<Real>& ball)
{
  return (ball.a + ball.c) * (ball.a + ball.c) + ball.k * ball.k;
}

/// The same ball in a measure of its own, about the largest of its lengths: of the powers that are formed with it
/// none is too large or too small. In double the measure is a power of two, and no digit changes as long as the
/// lesser lengths stay above 1e-300 of it. Domain: some length positive, all finite.
template <class Real>
Ball<Real> in_own_measure(const Ball<Real>& ball)
{
  Real unit = std::max({ball.a, ball.c, ball.k});
  if constexpr(std::is_same_v<Real, double>)
    unit = std::ldexp(1.0, std::ilogb(unit));
  return {ball.a / unit, ball.c / unit, ball.k / unit, ball.gap / unit};
}

/// The versed sine 1 − cos Φ from s = sin Φ and u = cos Φ, without a difference where it is small. Error: 2 ulps besides what
/// theirs make.
template <class Real>
Real versed_sine(const Real& s, const Real& u)
{
  return u > 0 ? Real(s * s / (1 + u)) : Real(1 - u);
}

/// The accelerations of G and of the angle, and what the plane bears.
template <class Real>
struct Accelerations
{
  Real x;         ///< of G forwards, ddx/dt²
  Real y;         ///< of G upwards, ddy/dt²
  Real Phi;       ///< of the angle, ddΦ/dt²
  Real pressure;  ///< Π/P; where it is negative the ball has left the plane and the rest is void
};

/// Solves the three equations of §§6-7 and the second of §3 for the ball at the angle Φ from its lowest
/// position, turning with the velocity w = dΦ/dt, with the ratio λ of friction to pressure (0 on a smooth
/// plane).
/// Domain: c w w finite; the denominator kk − c sin Φ (λ(a − c cos Φ) − c sin Φ) is positive for every |λ| <
/// 2k/(a + c).
/// Nothing is thrown; outside, the result is formal. `Real` is double or exact::Fifty; rounding: a few ulps
/// of each summand.
template <class Real>
Accelerations<Real> accelerations(const Ball<Real>& ball, const Real& g, const Real& Phi, const Real& w,
                                  const Real& lambda)
{
  using std::cos, std::sin;
  const auto& [a, c, k, gap] = ball;
  const Real s = sin(Phi), u = cos(Phi);
  const Real arm =
      lambda * (gap + c * versed_sine(s, u)) - c * s;  // of Π and its friction together, about G
  const Real pressure = k * k * (1 + c * w * w * u / (2 * g)) / (k * k - c * s * arm);
  return {-2 * g * lambda * pressure, 2 * g * (pressure - 1), 2 * g * pressure * arm / (k * k), pressure};
}

/// The accelerations of a ball that rolls, ds = a dΦ: the equation of §9, which friction and pressure have left,
/// and the second differentials of §3. The friction over the weight is then −x/2g, and λ that over the pressure.
/// Domain: c w w finite, and k > 0 or the centre of gravity not at the contact. Nothing is thrown. Rounding: a
/// few ulps of each summand.
template <class Real>
Accelerations<Real> rolling_accelerations(const Ball<Real>& ball, const Real& g, const Real& Phi,
                                          const Real& w)
{
  using std::cos, std::sin;
  const auto& [a, c, k, gap] = ball;
  const Real s = sin(Phi), u = cos(Phi), versed = versed_sine(s, u);
  const Real turning = -(2 * g * c + a * c * w * w) * s / (bb(ball) + 2 * a * c * versed);
  const Real x = turning * (gap + c * versed) + c * w * w * s, y = c * turning * s + c * w * w * u;
  return {x, y, turning, 1 + y / (2 * g)};
}

}  // namespace globe
