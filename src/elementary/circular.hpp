/// @file
/// Sine, cosine, tangent and their inverses, with the same bits on every machine.
///
/// They are made of + − × ÷ and √ alone, without contraction and without the C library, whose sines differ
/// from machine to machine. All are odd or even to the last bit, as the true functions are. A NaN gives a
/// NaN. Errors were measured against fifty digits over some twenty thousand arguments of every magnitude,
/// the worst of all doubles for the reduction (6381956970095103·2⁷⁹⁷) among them (tests/elementary.cpp); ulps
/// are units in the last place of the true value.
#pragma once

#include "elementary/exactly.hpp"

namespace elementary
{

/// @name Of one number
/// @{

double sin(double x);  ///< x in radians, of any size; NaN for ±∞. Error at most 0.8 ulp
double cos(double x);  ///< x in radians, of any size; NaN for ±∞. Error at most 0.8 ulp
double tan(double x);  ///< x in radians, of any size; NaN for ±∞. Error at most 0.9 ulp

double atan(double x);  ///< from −½π to ½π. Error at most 0.7 ulp
double atan2(double y,
             double x);  ///< the angle of the point (x, y), from −π to π; zeros and infinities as in C.
                         ///< Error at most 0.7 ulp, also where y/x overflows or underflows
double asin(double x);   ///< from −½π to ½π; NaN outside [−1, 1]. Error at most 0.7 ulp
double acos(double x);   ///< from 0 to π; NaN outside [−1, 1]. Error at most 0.7 ulp

/// Both of one angle.
template <class Real>
struct SineCosine
{
  Real sine;    ///< sin x
  Real cosine;  ///< cos x
};

/// sin x and cos x, each with the bits that it has alone.
SineCosine<double> sincos(double x);

/// @}

/// The pieces that the functions are made of, for double and for vectors of doubles.
namespace circular
{

/// ½π in four parts, the first three of 33 bits: their products with whole numbers below 2²⁰ are exact.
constexpr double quarter_turn[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69,
                                   0x1.b839a252049c1p-104};
constexpr double inverse_quarter = 0x1.45f306dc9c883p-1;  ///< 2/π
constexpr double reach = 0x1p20;                          ///< the largest |x| that is reduced by these

/// sin r = r + r³(c₀ + c₁r² + …) for |r| ≤ ¼π; the sum errs by 2⁻⁵⁷ r at most (interpolation where the error
/// alternates most evenly).
constexpr double sine_terms[] = {-0x1.5555555555549p-3, 0x1.111111110f877p-7,   -0x1.a01a019c11285p-13,
                                 0x1.71de35775aa1ap-19, -0x1.ae5e65f69cb37p-26, 0x1.5d92ee4ed54dfp-33};
/// cos r = 1 − ½r² + r⁴(c₀ + c₁r² + …); the sum errs by 2⁻⁶³ at most.
constexpr double cosine_terms[] = {0x1.555555555554bp-5,   -0x1.6c16c16c1504ep-10, 0x1.a01a019c981bdp-16,
                                   -0x1.27e4f7f9838b3p-22, 0x1.1ee9e1d323e7fp-29,  -0x1.8fa9d4387945fp-37};

/// c₀ + c₁z + … of six coefficients.
template <class Real>
ELEMENTARY_INLINE Real six_terms(const double (&c)[6], Real z)
{
  const Real z2 = z * z;
  return (c[0] + z * c[1]) + z2 * ((c[2] + z * c[3]) + z2 * (c[4] + z * c[5]));
}

/// x less so many quarter turns, as a sum.
template <class Real>
struct Reduced
{
  Pair<Real> rest;   ///< at most ¼π, but for a rounding
  Bits<Real> turns;  ///< the number of quarter turns, modulo 4 at least
};

/// For |x| ≤ reach, to 2⁻¹⁰⁰ absolutely.
template <class Real>
ELEMENTARY_INLINE Reduced<Real> reduced(Real x)
{
  const Real shifted = x * inverse_quarter + 0x1.8p52;
  const Real n = shifted - 0x1.8p52;
  const Pair<Real> first = difference_of(Real(x - n * quarter_turn[0]), Real(n * quarter_turn[1]));
  const Pair<Real> second = difference_of(first.value, Real(n * quarter_turn[2]));
  return {ordered_sum(second.value, Real(second.lost + (first.lost - n * quarter_turn[3]))),
          bits_of(shifted)};
}

/// sin r as a sum.
template <class Real>
ELEMENTARY_INLINE Pair<Real> sine(Pair<Real> r)
{
  const Real z = r.value * r.value;
  return {r.value, r.lost * (1 - 0.5 * z) + r.value * z * six_terms(sine_terms, z)};
}

/// cos r as a sum.
template <class Real>
ELEMENTARY_INLINE Pair<Real> cosine(Pair<Real> r)
{
  const Pair<Real> z = product_of(r.value, r.value);
  const Pair<Real> most = ordered_sum(Real(Real{} + 1), Real(-0.5 * z.value));
  const Real rest =
      z.value * z.value * six_terms(cosine_terms, z.value) - (r.value * r.lost + 0.5 * z.lost);
  return {most.value, most.lost + rest};
}

/// sin x and cos x for the equations of motion, many at once: the error is at most 1.3·2⁻⁵³ absolutely for
/// |x| ≤ 1024, which is all that an integrator can use; beyond `reach` a NaN. A number has the same bits in a vector
/// of any length.
template <class Real>
ELEMENTARY_INLINE SineCosine<Real> swift_sincos(Real x)
{
  const Real shifted = x * inverse_quarter + 0x1.8p52;
  const Real n = shifted - 0x1.8p52;
  constexpr double beyond_first = quarter_turn[1] + quarter_turn[2];
  const Real r = (x - n * quarter_turn[0]) - n * beyond_first;
  const Real z = r * r;
  const Real s = r + r * z * six_terms(sine_terms, z);
  const Real c = 1 - (0.5 * z - z * z * six_terms(cosine_terms, z));
  const Bits<Real> turns = bits_of(shifted);
  const auto odd = (turns & 1) != 0;
  const auto far = !(magnitude(x) <= reach);
  const Real unknown = Real{} + __builtin_nan("");
  const Real sine = from_bits<Real>(bits_of(Real(odd ? c : s)) ^ ((turns & 2) << 62));
  const Real cosine = from_bits<Real>(bits_of(Real(odd ? s : c)) ^ (((turns + 1) & 2) << 62));
  return {far ? unknown : sine, far ? unknown : cosine};
}

}  // namespace circular
}  // namespace elementary
