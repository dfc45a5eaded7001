/// @file
/// Where in its half swing a pendulum is, and what the rows of its motion say there: shared by the
/// functions of one time and the loops over arrays, which so give the same bits.
#pragma once

#include "swing/bits.hpp"
#include "swing/kernels.hpp"

/// The time reduced to a phase, and the reading of a motion's rows.
namespace swing::phase
{

using bits::bits_of;
using bits::magnitude;
using bits::sign_bit;
using bits::with_sign;

/// A number and what it was rounded by, so small that its effect need only be known to a few digits.
struct Part
{
  double value;  ///< the number
  double lost;   ///< what is to be added
};

/// The upper 26 bits of x.
SWING_INLINE double head_of(double x)
{
  const double wide = x * 0x1.0000002p27;
  return wide - (wide - x);
}

/// x·y with what the product is rounded by, the halves of y being known: exactly, and so the same with and
/// without a fused instruction. Of a product below 2⁻⁹⁰⁰, where there may be one, that may underflow, and is
/// nothing.
template <bool may_be_tiny = true>
SWING_INLINE Part product_of(double x, double y, double y_head, double y_tail)
{
  const double product = x * y;
#if defined(__FMA__)
  static_cast<void>(y_head);
  static_cast<void>(y_tail);
  const double lost = __builtin_fma(x, y, -product);
#else
  const double head = head_of(x);
  const double tail = x - head;
  const double lost = ((head * y_head - product) + head * y_tail + tail * y_head) + tail * y_tail;
#endif
  return {product, !may_be_tiny || magnitude(product) > 0x1p-900 ? lost : 0};
}

/// Whether the fraction of a half swing is still known at the time t; false for NaN.
SWING_INLINE bool within_reach(const kernels::Frequency& f, double t)
{
  return magnitude(t * f.hi) <= f.reach;
}

/// A time in half swings.
struct Reduced
{
  double n;              ///< the nearest whole number
  double whole;          ///< what is left without
  double lost;           ///< what the product was rounded by
  std::uint64_t parity;  ///< the bit of the sign where n is odd
};

/// The product of time and frequency is formed exactly; n is taken off before the rest is added.
template <bool may_be_tiny = true>
SWING_INLINE Reduced reduced(const kernels::Frequency& f, double t)
{
  const Part product = product_of<may_be_tiny>(t, f.hi, f.head, f.tail);
  const double shifted = product.value + 0x1.8p52;
  const double n = shifted - 0x1.8p52;
  return {n, product.value - n, product.lost + t * f.lo, bits_of(shifted) << 63};
}

/// Where the rows are to be read.
struct Place
{
  std::uint64_t row;   ///< the nearest row
  double distance;     ///< from it, in steps
  double n;            ///< half swings
  std::uint64_t sign;  ///< of what is asked
};

/// The place of a reduced time that is within reach.
SWING_INLINE Place place_of(const kernels::Rows& r, const Reduced& t)
{
  const double steps_in_half_swing = __builtin_copysign(r.steps, t.whole);
  const double steps = t.whole * steps_in_half_swing;
  const double nearest = steps + 0x1p52;
  return {bits_of(nearest) & 0xffff, (steps - (nearest - 0x1p52)) + t.lost * steps_in_half_swing, t.n,
          (t.parity & r.by_parity) ^ (bits_of(t.whole) & r.by_side)};
}

/// The row's polynomial at the distance d from its phase.
template <class Number>
SWING_INLINE Number polynomial(const Number* c, Number d)
{
  const Number d2 = d * d;
  const Number low = c[1] + d * c[2];
  const Number middle = c[3] + d * c[4];
  const Number high = c[5] + d * c[6];
  return c[0] + d * (low + d2 * (middle + d2 * (high + d2 * c[7])));
}

/// Going round, an angle grows by so many turns.
template <class Number>
SWING_INLINE Number turned(const kernels::Rows& r, Number n, Number value)
{
  return n * r.turn_hi + (n * r.turn_lo + value);
}

}  // namespace swing::phase
