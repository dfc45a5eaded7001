/// @file
/// How the generated tables are read: shared by the functions of one number and the loops over arrays, which
/// so give the same bits.
///
/// A table has 64 rows for each doubling of its argument; the leading bits tell the row. Everything here is
/// inlined always, so that no code made for one processor can be picked by the linker for another.
#pragma once

#include <cstdint>

#include "swing/time.hpp"
#include "swing_tables.hpp"

/// Never a function of its own.
#define SWING_INLINE [[gnu::always_inline]] inline

/// The reading of the generated tables.
namespace swing::rows
{

/// The bits of x.
SWING_INLINE std::uint64_t bits_of(double x)
{
  return __builtin_bit_cast(std::uint64_t, x);
}
/// The double that has these bits.
SWING_INLINE double from_bits(std::uint64_t b)
{
  return __builtin_bit_cast(double, b);
}

/// K by 1 − k, down to the last k below 1.
struct K_by_modulus
{
  static constexpr const double* rows = tables::K_by_modulus;  ///< the table
  static constexpr double start = tables::K_by_modulus_start;  ///< where it starts
  static constexpr double last = 1;                            ///< where the domain ends
};

/// K by kc.
struct K_by_complement
{
  static constexpr const double* rows = tables::K_by_complement;  ///< the table
  static constexpr double start = tables::K_by_complement_start;  ///< where it starts
  static constexpr double halving_hi = tables::ln2_hi;  ///< what a halving of x adds to the value,
  static constexpr double halving_lo = tables::ln2_lo;  ///< in two parts
  static constexpr double last = 1;                     ///< where the domain ends
};

/// T/Θ by η.
struct Ratio_by_eta
{
  static constexpr const double* rows = tables::ratio_by_eta;  ///< the table
  static constexpr double start = tables::ratio_by_eta_start;  ///< where it starts
  static constexpr double halving_hi = tables::ratio_ln2_hi;   ///< what a halving of x adds to the value,
  static constexpr double halving_lo = tables::ratio_ln2_lo;   ///< in two parts
  static constexpr double last = pi_hi;                        ///< where the domain ends
};

/// Where in the table the row for x begins.
template <class Table>
SWING_INLINE std::uint64_t row_of(double x)
{
  constexpr std::uint64_t first = __builtin_bit_cast(std::uint64_t, Table::start) >> 46;
  return ((bits_of(x) >> 46) - first) * tables::row_length;
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

/// An argument that was doubled n times, and what it lacks.
struct Doubled
{
  double x;     ///< the argument
  double lost;  ///< what it was rounded by
  double n;     ///< a whole number
};

/// x > 0 doubled until it is in the table.
template <class Table>
SWING_INLINE Doubled doubled(double x, double lost)
{
  constexpr double start = static_cast<double>(__builtin_bit_cast(std::uint64_t, Table::start) >> 52);
  const bool tiny = x < 0x1p-1000;  // made normal first
  const double normal = tiny ? x * 0x1p60 : x;
  const double missing = start - (from_bits((bits_of(normal) >> 52) | 0x4330000000000000) - 0x1p52);
  const double n = missing > 0 ? missing : 0;
  const double power = from_bits(bits_of(n + (0x1p52 + 1023)) << 52);
  return {normal * power, lost * power, tiny ? n + 60 : n};
}

/// A value as a sum, the second part being small beside the first.
template <class Number>
struct Sum
{
  Number main;  ///< the leading part
  Number rest;  ///< what is to be added
};

/// The value where the argument is halved n times.
template <class Table, class Number>
SWING_INLINE Sum<Number> halved(Sum<Number> value, Number n)
{
  const Number halvings = n * Table::halving_hi;  // exact
  const Number sum = value.main + halvings;
  const Number added = sum - value.main;
  const Number lost = (value.main - (sum - added)) + (halvings - added);
  return {sum, (lost + n * Table::halving_lo) + value.rest};
}

}  // namespace swing::rows
