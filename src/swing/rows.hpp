/// @file
/// How the generated tables are read: shared by the functions of one number and the loops over arrays,
/// which so give the same bits.
///
/// A table has four or eight rows for each doubling of its argument; the leading bits tell the row. It ends
/// after eight or nine doublings. Below, the function is a logarithm and a short polynomial in a small quantity z:
/// λ + z(p₀ + p₁z + … + λ(q₀ + q₁z + …)). The tables are small so that they stay in the caches while little
/// else does: a row serves a wide interval and is a quotient of polynomials.
#pragma once

#include "swing/bits.hpp"
#include "swing/time.hpp"
#include "swing_tables.hpp"

/// The reading of the generated tables.
namespace swing::rows
{

using bits::bits_of;
using bits::from_bits;

/// K by k, down to the last k below 1. The row is found by x = 1 − k, and holds k itself; for all k up to ½
/// there is one, which holds k².
struct K_by_modulus
{
  static constexpr const auto& stored = tables::K_by_modulus;  ///< all that is read
  static constexpr double start = 0x1p-9;                      ///< the first x that has a row
  static constexpr double last = 1;                            ///< where the domain ends
  static constexpr unsigned shift = 50;                        ///< of the bits that tell the row
  static constexpr std::uint64_t of_square = 32;               ///< the row for all k up to ½
  static constexpr double square_from = 0.5;                   ///< the first x that has it
  static constexpr std::uint64_t expected = 6;                 ///< rows asked for at once: k up to 25/32
  static constexpr bool sloping = false;                       ///< whether rows have a slope
  static constexpr bool squared = false;                       ///< whether z is x²; else it is x
  static constexpr bool down_to_subnormal = false;             ///< whether x may be as small as that
};

/// K by x = kc.
struct K_by_complement
{
  static constexpr const auto& stored = tables::K_by_complement;  ///< all that is read
  static constexpr double start = 0x1p-8;                         ///< the first x that has a row
  static constexpr bool sloping = false;                          ///< whether rows have a slope
  static constexpr double last = 1;                               ///< where the domain ends
  static constexpr unsigned shift = 49;                           ///< of the bits that tell the row
  static constexpr bool squared = true;                           ///< whether z is x²; else it is x
  static constexpr bool down_to_subnormal = true;                 ///< whether x may be as small as that
};

/// T/Θ by x = η. For all η from 25/16 on there is one row, which holds ζ² = (π − η)².
struct Ratio_by_eta
{
  static constexpr const auto& stored = tables::ratio_by_eta;  ///< all that is read
  static constexpr double start = 0x1p-7;                      ///< the first x that has a row
  static constexpr double last = pi_hi;                        ///< where the domain ends
  static constexpr unsigned shift = 50;                        ///< of the bits that tell the row
  static constexpr std::uint64_t of_square = 31;               ///< the row for all η from 25/16 on
  static constexpr double square_from = 25.0 / 16;             ///< the first x that has it
  static constexpr std::uint64_t expected = 1;                 ///< rows asked for at once: this one
  static constexpr bool sloping = true;                        ///< whether rows have a slope
  static constexpr bool squared = true;                        ///< whether z is x²; else it is x
  static constexpr bool down_to_subnormal = true;              ///< whether x may be as small as that
};

/// An x below this is tiny: its square is nothing beside 1.
inline constexpr double tiny = 0x1p-100;

/// A table of which an x is asked that is not tiny: it is found by less.
template <class Table>
struct Not_tiny : Table
{
  static constexpr bool down_to_subnormal = false;  ///< whether x may be as small as that
};

/// How far the bits of x lie beyond those of the table's start: of the numbers that have a row at most
/// `reach`, of all others more. Here as in what follows, x is a double or several side by side.
template <class Table, class Number>
SWING_INLINE auto beyond_start(Number x)
{
  return bits_of(x) - __builtin_bit_cast(std::uint64_t, Table::start);
}
/// Of the last number that has a row.
template <class Table>
inline constexpr std::uint64_t reach = __builtin_bit_cast(std::uint64_t, Table::last)
                                       - __builtin_bit_cast(std::uint64_t, Table::start);

/// a where all bits of `mask` are set, b where none is: a choice that needs no branch.
template <class Bits>
SWING_INLINE Bits chosen(Bits mask, Bits a, Bits b)
{
  return b ^ ((a ^ b) & mask);
}

/// A row, and the number whose distance from its centre is asked for.
template <class Bits, class Number>
struct Place
{
  Bits row;  ///< which
  Number x;  ///< the number
};

/// The place of an x that has a row.
template <class Table, class Number>
SWING_INLINE auto place_of(Number x)
{
  return Place<decltype(bits_of(x)), Number>{beyond_start<Table>(x) >> Table::shift, x};
}

/// A row, and a number as the sum of two.
template <class Bits, class Number>
struct Place_of_sum
{
  Bits row;     ///< which
  Number x;     ///< the number
  Number rest;  ///< what it lacks
};

/// All bits set where a row is not that of a square, from what beyond_start() says.
template <class Table, class Bits>
SWING_INLINE Bits not_of_square(Bits beyond)
{
  constexpr std::uint64_t edge = __builtin_bit_cast(std::uint64_t, Table::square_from)
                                 - __builtin_bit_cast(std::uint64_t, Table::start);
  return 0 - ((beyond - edge) >> 63);
}

/// The place of a modulus, x = 1 − k having a row.
template <class Number>
SWING_INLINE auto place_of_modulus(Number k, Number x)
{
  using Table = K_by_modulus;
  const auto beyond = beyond_start<Table>(x);
  const auto plain = not_of_square<Table>(beyond);
  return Place<decltype(bits_of(x)), Number>{
      chosen(plain, beyond >> Table::shift, 0 * beyond + Table::of_square),
      from_bits(chosen(plain, bits_of(k), bits_of(k * k)))};
}

/// How far a pendulum swings, from the top and from the bottom, each with what it lacks. From the bottom it is only
/// asked where η ≥ 25/16, and what η lacks only where it is less.
template <class Number>
struct Angles
{
  Number eta;        ///< from the top
  Number eta_rest;   ///< what that lacks
  Number zeta;       ///< from the bottom
  Number zeta_rest;  ///< what that lacks
};

/// Of η, which is exact.
template <class Number>
SWING_INLINE Angles<Number> from_top(Number eta)
{
  const Number nearly = pi_hi - eta;
  return {eta, Number{}, nearly, ((pi_hi - nearly) - eta) + pi_lo};
}

/// Of ζ, which is exact, with the two parts of π.
template <class Number>
SWING_INLINE Angles<Number> from_bottom(Number zeta, double half_turn, double beyond)
{
  const Number nearly = half_turn - zeta;  // exact where η < 25/16
  const Number eta = nearly + beyond;
  return {eta, (nearly - eta) + beyond, zeta, Number{}};
}

/// To be added and taken away again: rounds to a multiple of 2⁻²⁵, whose square is exact.
inline constexpr double to_upper = 0x1.8p27;

/// The place of angles whose η has a row. Of ζ the upper half is squared.
template <class Number>
SWING_INLINE auto place_of_angles(const Angles<Number>& a, double upwards = to_upper)
{
  using Table = Ratio_by_eta;
  const auto beyond = beyond_start<Table>(a.eta);
  const auto plain = not_of_square<Table>(beyond);
  const Number upper = (a.zeta + upwards) - upwards;
  const Number rest = (upper + a.zeta) * ((a.zeta - upper) + a.zeta_rest);
  return Place_of_sum<decltype(bits_of(a.eta)), Number>{
      chosen(plain, beyond >> Table::shift, 0 * beyond + Table::of_square),
      from_bits(chosen(plain, bits_of(a.eta), bits_of(upper * upper))),
      from_bits(chosen(plain, bits_of(a.eta_rest), bits_of(rest)))};
}

/// A value as a sum, the second part being small beside the first.
template <class Number>
struct Sum
{
  Number main;  ///< the leading part
  Number rest;  ///< what is to be added
};

/// c₀ + c₁t + … of six coefficients, of which each stands `step` behind the one before; where it is asked for, the
/// small is summed first.
template <unsigned step, bool small_first, class Number>
SWING_INLINE Number quintic(const Number* c, Number t)
{
  const Number t2 = t * t;
  const Number middle = t2 * (c[2 * step] + t * c[3 * step]);
  const Number last = (t2 * t2) * (c[4 * step] + t * c[5 * step]);
  if constexpr(small_first)
    return c[0] + (t * c[step] + (middle + last));
  return (c[0] + t * c[step]) + middle + last;
}

/// The value at the distance t from a row's centre, of that there, the slope, and what stands above and below in the
/// quotient by which the slope differs. What the first sum is rounded by is carried on. Where the table's rows have no
/// slope the quotient is all: they are quicker, and serve shorter intervals.
template <class Table, class Number>
SWING_INLINE Sum<Number> beyond_centre(Number value, Number slope, Number t, Number above, Number below)
{
  if constexpr(!Table::sloping)
    return {value, (t * above) / below};
  const Number step = t * slope;
  const Number main = value + step;
  return {main, (step - (main - value)) + t * (above / below)};
}

/// x² where z is that, or what is as good where that is nothing beside 1: numbers that underflow cost much
/// time.
template <class Table, class Number>
SWING_INLINE Number small_of(Number x)
{
  if constexpr(!Table::squared)
    return x;
  if constexpr(Table::down_to_subnormal)
    x = x > tiny ? x : Number{} + tiny;
  return x * x;
}

/// An argument below the rows, as a mantissa and a power of two.
template <class Number>
struct Scaled
{
  Number mantissa;  ///< from 1 to 2
  Number power;     ///< what x was multiplied by
  Number halvings;  ///< how many there are from where λ is zero, a whole number
};

/// x > 0 as mantissa and power.
template <class Table, class Number>
SWING_INLINE Scaled<Number> scaled(Number x, double zero)
{
  Number normal = x;
  Number from = Number{} + zero;
  if constexpr(Table::down_to_subnormal)
  {
    normal = x < 0x1p-1000 ? x * 0x1p60 : x;
    from = x < 0x1p-1000 ? from + 60.0 : from;
  }
  const auto b = bits_of(normal);
  const auto exponent = b >> 52;
  return {from_bits((b & 0x000fffffffffffff) | 0x3ff0000000000000), from_bits((2046 - exponent) << 52),
          from - from_bits(exponent | 0x4330000000000000)};
}

/// Where in the table the centre of the logarithm stands: the mantissa's leading bits tell.
template <class Number>
SWING_INLINE auto centre_of(Number mantissa)
{
  return (bits_of(mantissa) >> 48) & 14;
}

/// p₀ + p₁z + …
template <std::size_t n, class Number>
SWING_INLINE Number series(const double (&c)[n], Number z)
{
  Number sum = z * c[n - 1] + c[n - 2];
  for(std::size_t j = n - 2; j-- > 0;)
    sum = sum * z + c[j];
  return sum;
}

/// Where the logarithm is read.
template <class Number>
struct Reading
{
  Number value;     ///< what it is at the centre
  Number distance;  ///< from there
  Number sum;       ///< of the number and the centre
};

/// The value below the rows. The first two products and sums are exact.
template <class Stored, class Number>
SWING_INLINE Sum<Number> below(const Stored& f, const Reading<Number>& at, Number halvings, Number z)
{
  const Number s = at.distance / at.sum;
  const Number s2 = s * s;
  const Number beyond =
      s * ((f.beyond[0] + s2 * f.beyond[1]) + (s2 * s2) * (f.beyond[2] + s2 * f.beyond[3]));
  const Number main = halvings * f.halving[0] + at.value;
  const Number rest = halvings * f.halving[1] + beyond;
  return {main, rest + z * (series(f.plain, z) + (main + rest) * series(f.with_log, z))};
}

}  // namespace swing::rows
