/// @file
/// How the generated tables are read: shared by the functions of one number and the loops over arrays,
/// which so give the same bits.
///
/// A table has 64 rows for each doubling of its argument; the leading bits tell the row. It ends after
/// eight doublings. Below, the function is a logarithm, whose mantissa has 64 rows too, and a short
/// polynomial in a small quantity z: λ + z(p₀ + p₁z + … + λ(q₀ + q₁z + …)).
#pragma once

#include "swing/bits.hpp"
#include "swing/time.hpp"
#include "swing_tables.hpp"

/// The reading of the generated tables.
namespace swing::rows
{

using bits::bits_of;
using bits::from_bits;

/// x², or what is as good where that is nothing beside 1: numbers that underflow cost much time.
SWING_INLINE double square_of(double x)
{
  const double y = x > 0x1p-100 ? x : 0x1p-100;
  return y * y;
}

/// K by 1 − k, down to the last k below 1.
struct K_by_modulus
{
  static constexpr const double* rows = tables::K_rows;               ///< where its logarithm's rows begin
  static constexpr std::uint64_t first = tables::K_by_modulus_first;  ///< its own first row
  static constexpr double start = tables::K_by_modulus_start;         ///< where that starts
  static constexpr double last = 1;                                   ///< where the domain ends
  static constexpr double halving_hi = tables::ln2_hi;                ///< what a halving of x adds to λ,
  static constexpr double halving_lo = tables::ln2_lo;                ///< in two parts
  static constexpr double halvings = 3;                               ///< λ is zero at x = 2 to this
  static constexpr double scale = 0.5;                                ///< below the table, K = ½(λ + …)
  static constexpr const auto& plain = tables::K_by_modulus_plain;    ///< the p
  static constexpr const auto& with_log = tables::K_by_modulus_with_log;  ///< the q
  static constexpr bool down_to_subnormal = false;  ///< whether x may be as small as that
  /// z
  SWING_INLINE static double small_of(double y) { return y; }
};

/// K by kc.
struct K_by_complement
{
  static constexpr const double* rows = tables::K_rows;  ///< where its logarithm's rows begin
  static constexpr std::uint64_t first = tables::K_by_complement_first;  ///< its own first row
  static constexpr double start = tables::K_by_complement_start;         ///< where that starts
  static constexpr double last = 1;                                      ///< where the domain ends
  static constexpr double halving_hi = tables::ln2_hi;                 ///< what a halving of x adds to λ,
  static constexpr double halving_lo = tables::ln2_lo;                 ///< in two parts
  static constexpr double halvings = 2;                                ///< λ is zero at x = 2 to this
  static constexpr double scale = 1;                                   ///< below the table, K = λ + …
  static constexpr const auto& plain = tables::K_by_complement_plain;  ///< the p
  static constexpr const auto& with_log = tables::K_by_complement_with_log;  ///< the q
  static constexpr bool down_to_subnormal = true;  ///< whether x may be as small as that
  /// z
  SWING_INLINE static double small_of(double kc) { return square_of(kc); }
};

/// T/Θ by η.
struct Ratio_by_eta
{
  static constexpr const double* rows = tables::ratio_rows;           ///< where its logarithm's rows begin
  static constexpr std::uint64_t first = tables::ratio_by_eta_first;  ///< its own first row
  static constexpr double start = tables::ratio_by_eta_start;         ///< where that starts
  static constexpr double last = pi_hi;                               ///< where the domain ends
  static constexpr double halving_hi = tables::ratio_ln2_hi;          ///< what a halving of x adds to λ,
  static constexpr double halving_lo = tables::ratio_ln2_lo;          ///< in two parts
  static constexpr double halvings = 3;                               ///< λ is zero at x = 2 to this
  static constexpr double scale = 1;                                  ///< below the table, T/Θ = λ + …
  static constexpr const auto& plain = tables::ratio_by_eta_plain;    ///< the p
  static constexpr const auto& with_log = tables::ratio_by_eta_with_log;  ///< the q
  static constexpr bool down_to_subnormal = true;  ///< whether x may be as small as that
  /// z
  SWING_INLINE static double small_of(double eta) { return square_of(eta); }
};

/// How far the bits of x lie beyond those of the table's start: of the numbers in the table at most
/// `reach`, of all others more.
template <class Table>
SWING_INLINE std::uint64_t beyond_start(double x)
{
  return bits_of(x) - __builtin_bit_cast(std::uint64_t, Table::start);
}
/// Of the last number in the table.
template <class Table>
inline constexpr std::uint64_t reach = __builtin_bit_cast(std::uint64_t, Table::last)
                                       - __builtin_bit_cast(std::uint64_t, Table::start);

/// Where the row for x begins, x being in the table.
template <class Table>
SWING_INLINE std::uint64_t row_of(double x)
{
  return ((beyond_start<Table>(x) >> 46) + Table::first) * tables::row_length;
}

/// Where the row of the logarithm begins.
SWING_INLINE std::uint64_t row_of_mantissa(double x)
{
  return ((bits_of(x) >> 46) & 63) * tables::row_length;
}

/// What the row c adds to its value c[1] at the distance t from its centre c[0].
template <class Number>
SWING_INLINE Number beyond_centre(const Number* c, Number t)
{
  const Number t2 = t * t;
  const Number low = c[2] + t * c[3];
  const Number middle = c[4] + t * c[5];
  const Number high = c[6] + t * c[7];
  return t * (low + t2 * (middle + t2 * high));
}

/// An argument below the table, as a mantissa and a power of two.
struct Scaled
{
  double mantissa;  ///< from 1 to 2
  double power;     ///< what x was multiplied by
  double halvings;  ///< how many there are from where λ is zero, a whole number
};

/// x > 0 as mantissa and power.
template <class Table>
SWING_INLINE Scaled scaled(double x)
{
  constexpr double zero = Table::halvings + (0x1p52 + 1023);
  const bool tiny = Table::down_to_subnormal && x < 0x1p-1000;  // made normal first
  const std::uint64_t normal = bits_of(tiny ? x * 0x1p60 : x);
  const std::uint64_t exponent = normal >> 52;
  return {from_bits((normal & 0x000fffffffffffff) | 0x3ff0000000000000), from_bits((2046 - exponent) << 52),
          (tiny ? zero + 60 : zero) - from_bits(exponent | 0x4330000000000000)};
}

/// A value as a sum, the second part being small beside the first.
template <class Number>
struct Sum
{
  Number main;  ///< the leading part
  Number rest;  ///< what is to be added
};

/// p₀ + p₁z + …
template <std::size_t n, class Number>
SWING_INLINE Number series(const double (&c)[n], Number z)
{
  Number sum = z * c[n - 1] + c[n - 2];
  for(std::size_t j = n - 2; j-- > 0;)
    sum = sum * z + c[j];
  return sum;
}

/// The value below the table, without its scale, from the logarithm of the mantissa; and the value in the
/// table from its own, with no halvings and z = 0. Where the logarithm is read, the first two products and
/// sums are exact.
template <class Table, class Number>
SWING_INLINE Sum<Number> with_halvings(Number centre, Number beyond, Number halvings, Number z)
{
  const Number main = halvings * Table::halving_hi + centre;
  const Number rest = halvings * Table::halving_lo + beyond;
  return {main, rest + z * (series(Table::plain, z) + (main + rest) * series(Table::with_log, z))};
}

}  // namespace swing::rows
