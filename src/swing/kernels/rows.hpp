/// @file
/// A motion's rows: how they are made, and how they are read for an array of times.
///
/// Part of kernels.cpp; see wide.hpp.
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

using bits::with_sign;

static_assert(sizeof(Row) == row_length * sizeof(double));
static_assert(rows_at_once % width == 0);

// sin πx for |x| ≤ ½.
SWING_INLINE Wide sine_of_half_turns(Wide x)
{
  const Wide x2 = x * x;
  return pi_hi * (x + (x * x2) * polynomial(tables::sine_of_turns, x2));
}

// The highest power that is computed; rows have two less.
constexpr unsigned highest = 9;

// A polynomial of degree 9 brought down to 7: d⁸ and d⁹ are replaced by the polynomials that differ least
// from them for |d| ≤ ½ and vanish at 0.
SWING_INLINE void bring_down(Wide* c)
{
  for(unsigned j = 0; j < 3; ++j)
    c[2 + 2 * j] += tables::eighth_power[j] * c[8];
  for(unsigned j = 0; j < 4; ++j)
    c[1 + 2 * j] += tables::ninth_power[j] * c[9];
}

// With Σ aₙdⁿ for the angle, Σ Sₙdⁿ for its sine and Σ Cₙdⁿ for its cosine, and bₙ = (n + 1)aₙ₊₁, the
// equation of motion and the derivatives of sine and cosine give each next coefficient.
template <bool of_velocity>
void make_rows(const Centres& centres, Row* rows)
{
  constexpr unsigned last = highest + of_velocity;
  const double pull = centres.pull * (centres.step * centres.step);
  for(std::size_t i = 0; i < centres.size; i += width)
  {
    const Wide angle = load(centres.angle + i);
    const Wide speed = load(centres.speed + i);
    const Wide half_turns = angle * (0.5 / pi_hi);
    const Wide s = sine_of_half_turns(half_turns);
    Wide S[last];
    Wide C[last];
    Wide b[last];
    S[0] = 2.0 * s * sine_of_half_turns(0.5 - half_turns);
    C[0] = 1.0 - 2.0 * s * s;
    b[0] = speed * centres.step;
#pragma GCC unroll 10
    for(unsigned n = 0; n + 1 < last; ++n)
    {
      const double next = n + 1.0;
      b[n + 1] = (pull / next) * S[n];
      S[n + 1] = b[0] * C[n];
      C[n + 1] = b[0] * S[n];
#pragma GCC unroll 10
      for(unsigned j = 1; j <= n; ++j)
      {
        S[n + 1] += b[j] * C[n - j];
        C[n + 1] += b[j] * S[n - j];
      }
      S[n + 1] *= 1 / next;
      C[n + 1] *= -1 / next;
    }
    Wide c[highest + 1];
    c[0] = of_velocity ? speed : angle;
#pragma GCC unroll 10
    for(unsigned n = 1; n <= highest; ++n)
      c[n] = of_velocity ? b[n] * (1 / centres.step) : b[n - 1] * (1.0 / n);
    bring_down(c);
    write_rows(c, rows[i].c);
  }
}

// What of a block is known before the rows are read.
struct Places
{
  alignas(64) double distance[block] = {};
  alignas(64) double n[block] = {};
  alignas(64) std::uint64_t sign[block] = {};
  alignas(64) std::uint64_t row[block] = {};
};

template <bool turning>
SWING_INLINE void read_motion(const Rows& rows, const double* t, double* out, std::size_t n)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Rows& r = rows;
  Places x;
  for(std::size_t start = 0; start < n; start += block)
  {
    const std::size_t size = n - start < block ? n - start : block;
    for(std::size_t i = 0; i < size; ++i)
    {
      const bool within = phase::within_reach(r.frequency, t[start + i]);
      phase::Reduced reduced = phase::reduced(r.frequency, t[start + i]);
      reduced.whole = within ? reduced.whole : 0;
      reduced.parity = within ? reduced.parity : 0;
      const phase::Place place = phase::place_of(r, reduced);
      x.distance[i] = within ? place.distance : nan;
      x.sign[i] = place.sign;
      x.row[i] = place.row * row_length;
      if constexpr(turning)
        x.n[i] = place.n;
    }
    for(std::size_t i = 0; i < size; i += width)
    {
      Wide c[row_length];
      read_columns<row_length>(r.row->c, x.row + i, c);
      Wide value = with_sign(phase::polynomial(c, load(x.distance + i)), load<bits::Wide_bits>(x.sign + i));
      if constexpr(turning)
        value = phase::turned(r, load(x.n + i), value);
      store_first(size - i, value, out + start + i);
    }
  }
}

// For one time alone, which is not tiny.
template <bool turning>
double read_one(const Rows& rows, double t)
{
  if(!phase::within_reach(rows.frequency, t)) [[unlikely]]
    return std::numeric_limits<double>::quiet_NaN();
  const phase::Place place = phase::place_of(rows, phase::reduced<false>(rows.frequency, t));
  const double value = with_sign(phase::polynomial(rows.row[place.row].c, place.distance), place.sign);
  return turning ? phase::turned(rows, place.n, value) : value;
}

void read_any_motion(const Rows& rows, const double* t, double* out, std::size_t n)
{
  if(rows.turn_hi == 0)
    read_motion<false>(rows, t, out, n);
  else
    read_motion<true>(rows, t, out, n);
}

}  // namespace
}  // namespace swing::kernels
