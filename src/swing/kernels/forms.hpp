/// @file
/// The motion computed from the beginning for each time: by series, or by theta functions of the dual nome.
///
/// Part of kernels.cpp; see wide.hpp. What is computed for one time is free of branches: the compiler works
/// on many at once.
#pragma once

#include <limits>

#include "swing/kernels/wide.hpp"
#include "swing/phase.hpp"
#include "swing/time.hpp"
#include "swing_tables.hpp"

namespace swing::kernels
{
namespace
{

using bits::bits_of;
using bits::from_bits;
using bits::magnitude;
using bits::sign_bit;
using bits::with_sign;
using phase::Part;
using phase::product_of;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// sin πr / π for |r| ≤ ½; its slope, cos πr, is not far from 1 − 4r².
SWING_INLINE double sine_of_turns(Part r)
{
  const double x = r.value * r.value;
  return r.value + (r.lost * (1 - 4 * x) + (r.value * x) * polynomial(tables::sine_of_turns, x));
}

// e⁻ˣ − 1 and e⁻ˣ for 0 ≤ x ≤ 700.
struct Exponential
{
  double minus_one;
  double value;
};

SWING_INLINE Exponential exponential_of_minus(Part x)
{
  constexpr double inverse = 1 / (tables::ln2_hi + tables::ln2_lo);
  const double shifted = x.value * inverse + 0x1.8p52;
  const double n = shifted - 0x1.8p52;
  const double r = (n * tables::ln2_hi - x.value) + (n * tables::ln2_lo - x.lost);
  const double p = r + (r * r) * polynomial(tables::exponential, r);
  const double scale = from_bits((1023 - bits_of(shifted)) << 52);
  return {(scale - 1) + scale * p, scale + scale * p};
}

// 2 arctan (y/x) for x, y ≥ 0, not both zero: from 0, ½π or π, whichever is the nearest.
SWING_INLINE double twice_arc_tangent(double y, double x)
{
  constexpr double tangent_of_eighth = 0.41421356237309503;
  const double difference = y - x;
  const double sum = y + x;
  const bool steep = difference > 0;
  const bool middle = magnitude(difference) < tangent_of_eighth * sum;
  const double s = (middle ? difference : steep ? -x : y) / (middle ? sum : steep ? y : x);
  const double x2 = s * s;
  const double from = middle ? pi_hi / 2 : steep ? pi_hi : 0;
  return from + (from * (pi_lo / pi_hi) + 2 * (s + s * x2 * polynomial(tables::arc_tangent, x2)));
}

// scale · (sin z / π) (1 + c₀ x + …), z = πr and x = (sin z / π)².
template <unsigned terms>
SWING_INLINE double sine_series(double scale, double scale_lost, const double* c, Part r)
{
  const double s = sine_of_turns(r);
  const double main = scale * s;
  return main + main * (scale_lost + (s * s) * polynomial<terms>(c, s * s));
}

// Up to 90°: Φ is such a series, and Φ' one of the same kind with z counted from rest.
template <unsigned terms>
struct Low
{
  SWING_INLINE static double angle(const Prepared& p, Part r, Part)
  {
    return sine_series<terms>(p.angle_scale, p.angle_scale_lost, p.angle_series, r);
  }
  SWING_INLINE static double from_top(const Prepared& p, Part r, Part to_rest)
  {
    return (pi_hi - angle(p, r, to_rest)) + pi_lo;
  }
  SWING_INLINE static double speed(const Prepared& p, Part, Part to_rest)
  {
    return sine_series<terms>(p.velocity_scale, p.velocity_scale_lost, p.velocity_series, to_rest);
  }
};

// Revolving with much energy: Φ = 2z + sin z cos z · (c₀ + c₁ x + …), and Φ' goes as 1 + c₀ x + …
struct Fast
{
  SWING_INLINE static double beyond_mean(const Prepared& p, Part r, Part to_top)
  {
    const double s = sine_of_turns(r);
    return s * sine_of_turns(to_top) * polynomial(p.angle_series, s * s);
  }
  SWING_INLINE static double angle(const Prepared& p, Part r, Part to_top)
  {
    return r.value * (2 * pi_hi)
           + (r.value * (2 * pi_lo) + r.lost * (2 * pi_hi) + beyond_mean(p, r, to_top));
  }
  SWING_INLINE static double from_top(const Prepared& p, Part r, Part to_top)
  {
    return to_top.value * (2 * pi_hi)
           + (to_top.value * (2 * pi_lo) + to_top.lost * (2 * pi_hi) - beyond_mean(p, r, to_top));
  }
  SWING_INLINE static double speed(const Prepared& p, Part r, Part)
  {
    const double s = sine_of_turns(r);
    return p.velocity_scale
           + p.velocity_scale * (p.velocity_scale_lost + (s * s) * polynomial(p.velocity_series, s * s));
  }
};

// The dual nome: with v = −r ln q', the powers of g = e⁻ᵛ and h = √q'/g are what the theta functions are
// made of. Neither exceeds 1. Their squares are G and H.
struct Theta
{
  double g;
  double h;
  double one_minus_G;
  double one_minus_H;
};

// With all their digits, 1 − G and 1 − H too: from the nearer end of the half swing.
SWING_INLINE Theta theta_of(const Prepared& p, Part r, Part to_rest)
{
  const bool upper = to_rest.value < r.value;
  const double nearer = upper ? to_rest.value : r.value;
  const double lost = upper ? to_rest.lost : r.lost;
  const Part v = product_of(nearer, p.log_q_hi, p.log_q_head, p.log_q_tail);
  const bool far_down = v.value > 700;
  const double v_lost = v.lost + (lost * p.log_q_hi + nearer * p.log_q_lo);
  const Exponential e = exponential_of_minus({far_down ? 700 : v.value, far_down ? 0 : v_lost});
  const double other = p.root_q / e.value;
  const double near = -e.minus_one * (2 + e.minus_one);
  const double far = (1 - other) * (1 + other);
  return {upper ? other : e.value, upper ? e.value : other, upper ? far : near, upper ? near : far};
}

// Fewer digits suffice for Φ: the error of v does not count where g is small. So v may be taken from the
// bottom all the way.
SWING_INLINE Theta theta_from_bottom(const Prepared& p, Part r)
{
  const double v = r.value * p.log_q_hi;
  const bool far_down = v > 700;
  const Exponential e = exponential_of_minus({far_down ? 700 : v, far_down ? 0 : r.lost * p.log_q_hi});
  const double h = p.root_q / e.value;
  return {e.value, h, -e.minus_one * (2 + e.minus_one), (1 - h) * (1 + h)};
}

// What remains of a theta function when its first factor, 1 ± G or 1 ± H, is taken out, is 1 and this: y (1
// + x + x²) + q² y² (1 + x + … + x⁴) + q⁶ y³ (1 + x + … + x⁶). In the last term, which is less than q⁹, x⁵
// and x⁶ no longer count; and with q' < 2⁻¹⁴ the first term suffices.
template <int terms>
SWING_INLINE double beyond_one(const Prepared& p, double x, double y)
{
  const double three = 1 + x * (1 + x);
  if constexpr(terms == 1)
    return y * three;
  const double five = 1 + x * (1 + x * three);
  const double q2 = p.q * p.q;
  return y * (three + (y * q2) * (five + (y * q2 * q2) * five));
}

// The cofactors of θ₁ … θ₄, less 1; their first factors are 1 − G, 1 + G, 1 + H and 1 − H.
template <int terms>
struct Cofactors
{
  SWING_INLINE static double of_1(const Prepared& p, const Theta& t)
  {
    return beyond_one<terms>(p, t.g * t.g, -p.q * (t.h * t.h));
  }
  SWING_INLINE static double of_2(const Prepared& p, const Theta& t)
  {
    return beyond_one<terms>(p, -(t.g * t.g), p.q * (t.h * t.h));
  }
  SWING_INLINE static double of_3(const Prepared& p, const Theta& t)
  {
    return beyond_one<terms>(p, -(t.h * t.h), p.q * (t.g * t.g));
  }
  SWING_INLINE static double of_4(const Prepared& p, const Theta& t)
  {
    return beyond_one<terms>(p, t.h * t.h, -p.q * (t.g * t.g));
  }
};

// main·(1 + a)/(1 + b) and what the factor in it was rounded by, where a and b are small.
SWING_INLINE double nearly(const Prepared& p, double main, double a, double b)
{
  return main + main * (p.velocity_scale_lost + (a - b) / (1 + b));
}

// A positive quotient, the tangent of ½Φ.
struct Quotient
{
  double above;
  double below;
};

// Above 90°: C θ₁/θ₃ of the dual nome.
template <int terms>
struct High
{
  SWING_INLINE static Theta theta(const Prepared& p, Part r, Part) { return theta_from_bottom(p, r); }
  SWING_INLINE static Quotient tangent(const Prepared& p, const Theta& t)
  {
    return {p.angle_scale * (t.one_minus_G * (1 + Cofactors<terms>::of_1(p, t))),
            t.g * ((1 + t.h * t.h) * (1 + Cofactors<terms>::of_3(p, t)))};
  }
  SWING_INLINE static double speed(const Prepared& p, const Theta& t)
  {
    const double main = p.velocity_scale * (t.g * t.one_minus_H / (1 + t.g * t.g));
    return nearly(p, main, Cofactors<terms>::of_4(p, t), Cofactors<terms>::of_2(p, t));
  }
};

// Revolving with little energy: C θ₁/θ₄ of the dual nome, and Φ' goes as θ₃/θ₂.
struct Barely
{
  SWING_INLINE static Theta theta(const Prepared& p, Part r, Part to_top) { return theta_of(p, r, to_top); }
  SWING_INLINE static Quotient tangent(const Prepared& p, const Theta& t)
  {
    return {p.angle_scale * (t.one_minus_G * (1 + Cofactors<3>::of_1(p, t))),
            t.g * (t.one_minus_H * (1 + Cofactors<3>::of_4(p, t)))};
  }
  SWING_INLINE static double speed(const Prepared& p, const Theta& t)
  {
    const double main = p.velocity_scale * (t.g * (1 + t.h * t.h) / (1 + t.g * t.g));
    return nearly(p, main, Cofactors<3>::of_3(p, t), Cofactors<3>::of_2(p, t));
  }
};

// Where the clock started.
enum class From
{
  bottom,
  rest,
  going_round
};

// Where in its half swing the pendulum is: of the time, n half swings are taken off.
struct Phase
{
  Part behind;         // since the bottom, in half swings
  Part ahead;          // what is left to rest or to the top: the rest of ½
  double n;            // a whole number
  std::uint64_t sign;  // of what is asked
};

// Started at rest, what is left and what is gone change their places. Going round, a half swing is a whole
// turn.
template <From from, Question asked>
SWING_INLINE Phase phase_of(const Prepared& p, double t)
{
  const phase::Reduced reduced = phase::reduced(p.frequency, t);
  const double r = reduced.whole + reduced.lost;
  const std::uint64_t sign = bits_of(r) & sign_bit;
  const Part near{with_sign(r, sign), with_sign((reduced.whole - r) + reduced.lost, sign)};
  const double left = 0.5 - near.value;
  const double rounded = left - near.lost;
  const Part far{rounded, (left - rounded) - near.lost};
  if constexpr(from == From::bottom)
    return {near, far, reduced.n,
            asked == angle      ? reduced.parity ^ sign
            : asked == velocity ? reduced.parity
                                : 0};
  else if constexpr(from == From::rest)
    return {far, near, reduced.n,
            asked == angle      ? reduced.parity
            : asked == velocity ? reduced.parity ^ sign ^ sign_bit
                                : 0};
  else
    return {near, far, reduced.n, asked == angle ? sign : 0};
}

// Out of reach the fraction of a half swing is no longer known.
template <From from, Question asked>
SWING_INLINE double finished(const Prepared& p, double t, double n, std::uint64_t sign, double value)
{
  double result = with_sign(value, sign);
  if constexpr(from == From::going_round && asked == angle)
    result = n * (2 * pi_hi) + (n * (2 * pi_lo) + result);
  return phase::within_reach(p.frequency, t) ? result : nan;
}

// By a series, in one step.
template <class Form, From from, Question asked>
void series_loop(const Prepared& prepared, const double* t, double* out, std::size_t n)
{
  const Prepared p = prepared;
  for(std::size_t i = 0; i < n; ++i)
  {
    const Phase s = phase_of<from, asked>(p, t[i]);
    double value = 0;
    if constexpr(asked == angle)
      value = Form::angle(p, s.behind, s.ahead);
    else if constexpr(asked == velocity)
      value = Form::speed(p, s.behind, s.ahead);
    else
      value = Form::from_top(p, s.behind, s.ahead);
    out[i] = finished<from, asked>(p, t[i], s.n, s.sign, value);
  }
}

// By theta functions, in four steps.
template <class Form, Question asked>
SWING_INLINE Theta theta_for(const Prepared& p, Part behind, Part ahead)
{
  return asked == angle ? Form::theta(p, behind, ahead) : theta_of(p, behind, ahead);
}

// Of Φ the tangent of its half; of the angle from the top the same turned over; of Φ' itself over 1.
template <class Form, Question asked>
SWING_INLINE Quotient quotient_for(const Prepared& p, const Theta& t)
{
  if constexpr(asked == velocity)
    return {Form::speed(p, t), 1};
  const Quotient q = Form::tangent(p, t);
  return asked == angle ? q : Quotient{q.below, q.above};
}
template <Question asked>
SWING_INLINE double value_for(Quotient q)
{
  return asked == velocity ? q.above : twice_arc_tangent(q.above, q.below);
}

// What a block has after each step.
struct Steps
{
  alignas(64) double behind[block];
  alignas(64) double behind_lost[block];
  alignas(64) double ahead[block];
  alignas(64) double ahead_lost[block];
  alignas(64) double n[block];
  alignas(64) std::uint64_t sign[block];
  alignas(64) double g[block];
  alignas(64) double h[block];
  alignas(64) double one_minus_G[block];
  alignas(64) double one_minus_H[block];
  alignas(64) double above[block];
  alignas(64) double below[block];
};

template <class Form, From from, Question asked>
void theta_loop(const Prepared& prepared, const double* t, double* out, std::size_t n)
{
  const Prepared p = prepared;
  if(n == 1)
  {
    const Phase s = phase_of<from, asked>(p, t[0]);
    const Theta theta = theta_for<Form, asked>(p, s.behind, s.ahead);
    const double value = value_for<asked>(quotient_for<Form, asked>(p, theta));
    out[0] = finished<from, asked>(p, t[0], s.n, s.sign, value);
    return;
  }
  Steps x;
  for(std::size_t start = 0; start < n; start += block)
  {
    const std::size_t size = n - start < block ? n - start : block;
    for(std::size_t i = 0; i < size; ++i)
    {
      const Phase s = phase_of<from, asked>(p, t[start + i]);
      x.behind[i] = s.behind.value;
      x.behind_lost[i] = s.behind.lost;
      x.ahead[i] = s.ahead.value;
      x.ahead_lost[i] = s.ahead.lost;
      x.n[i] = s.n;
      x.sign[i] = s.sign;
    }
    for(std::size_t i = 0; i < size; ++i)
    {
      const Theta theta =
          theta_for<Form, asked>(p, {x.behind[i], x.behind_lost[i]}, {x.ahead[i], x.ahead_lost[i]});
      x.g[i] = theta.g;
      x.h[i] = theta.h;
      x.one_minus_G[i] = theta.one_minus_G;
      x.one_minus_H[i] = theta.one_minus_H;
    }
    for(std::size_t i = 0; i < size; ++i)
    {
      const Quotient q = quotient_for<Form, asked>(p, {x.g[i], x.h[i], x.one_minus_G[i], x.one_minus_H[i]});
      x.above[i] = q.above;
      x.below[i] = q.below;
    }
    for(std::size_t i = 0; i < size; ++i)
    {
      const double value = value_for<asked>({x.above[i], x.below[i]});
      out[start + i] = finished<from, asked>(p, t[start + i], x.n[i], x.sign[i], value);
    }
  }
}

}  // namespace
}  // namespace swing::kernels
