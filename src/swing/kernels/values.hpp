/// @file
/// K and the period over arrays, from the generated tables.
///
/// Part of kernels.cpp; see wide.hpp.
#pragma once

#include <limits>

#include "swing/kernels/wide.hpp"
#include "swing/rows.hpp"

namespace swing::kernels
{
namespace
{

static_assert(row_length == tables::row_length);

// So many go together: few enough that seldom one of them lies below the table where not many do.
constexpr std::size_t few = 32;

// What of them is known before the table is read.
struct Arguments
{
  alignas(64) double given[few] = {};
  alignas(64) double mantissa[few] = {};
  alignas(64) double lost[few] = {};
  alignas(64) double halvings[few] = {};
  alignas(64) double z[few] = {};
  alignas(64) std::uint64_t row[few] = {};
};

template <class Table>
SWING_INLINE double in_domain(double x)
{
  return x > 0 && x <= Table::last ? x : 1;
}

// Each argument's row, and whether some arguments lie below the table.
template <class Kernel>
SWING_INLINE bool find_rows(const double* in, Arguments& a, std::size_t size)
{
  using Table = typename Kernel::Table;
  std::uint64_t below = 0;
  for(std::size_t i = 0; i < size; ++i)
  {
    const double x = Kernel::argument(in[i]);
    const double inside = in_domain<Table>(x);
    a.given[i] = x;
    a.row[i] = rows::row_of<Table>(inside);
    if constexpr(Kernel::inexact)
      a.lost[i] = Kernel::lost(in[i]);
    below |= inside < Table::start;
  }
  return below != 0;
}

// Where some do, the rows of those are the logarithm's.
template <class Kernel>
SWING_INLINE void find_rows_below(Arguments& a, std::size_t size)
{
  using Table = typename Kernel::Table;
  for(std::size_t i = 0; i < size; ++i)
  {
    const double x = in_domain<Table>(a.given[i]);
    const bool below = x < Table::start;
    const rows::Scaled s = rows::scaled<Table>(x);
    a.mantissa[i] = below ? s.mantissa : x;
    if constexpr(Kernel::inexact)
      a.lost[i] *= below ? s.power : 1;
    a.halvings[i] = below ? s.halvings : 0;
    a.z[i] = below ? Table::small_of(x) : 0;
    a.row[i] = below ? rows::row_of_mantissa(s.mantissa) : a.row[i];
  }
}

// Whether one of the next `width` numbers is not zero.
SWING_INLINE bool any(const double* x)
{
  bool found = false;
  for(unsigned i = 0; i < width; ++i)
    found |= x[i] != 0;
  return found;
}

// The values by their rows, as many at once as a register holds.
template <class Kernel, bool some_below>
SWING_INLINE void read_rows(const Arguments& a, double* out, std::size_t size)
{
  using Table = typename Kernel::Table;
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for(std::size_t i = 0; i < size; i += width)
  {
    Wide c[row_length];
    read_columns(Table::rows, a.row + i, c);
    const Wide given = load(a.given + i);
    Wide t = load((some_below ? a.mantissa : a.given) + i) - c[0];
    if constexpr(Kernel::inexact)
      t += load(a.lost + i);
    rows::Sum<Wide> sum{c[1], rows::beyond_centre(c, t)};
    Wide scale = Wide{} + 1.0;
    if constexpr(some_below)
      if(any(a.halvings + i))
      {
        const Wide halvings = load(a.halvings + i);
        sum = rows::with_halvings<Table>(sum.main, sum.rest, halvings, load(a.z + i));
        if constexpr(Table::scale != 1)
          scale = halvings != 0.0 ? Wide{} + Table::scale : scale;
      }
    const Wide outside = given == 0.0 ? Wide{} + inf : Wide{} + nan;
    const Wide value = ((given > 0.0) & (given <= Table::last)) ? (sum.main + sum.rest) * scale : outside;
    if(size - i >= width)
      __builtin_memcpy(out + i, &value, sizeof value);
    else
      for(std::size_t j = i; j < size; ++j)
        out[j] = value[j - i];
  }
}

template <class Kernel>
void table_loop(const double* in, double* out, std::size_t n)
{
  Arguments a;
  for(std::size_t start = 0; start < n; start += few)
  {
    const std::size_t size = n - start < few ? n - start : few;
    if(find_rows<Kernel>(in + start, a, size))
    {
      find_rows_below<Kernel>(a, size);
      read_rows<Kernel, true>(a, out + start, size);
    }
    else
      read_rows<Kernel, false>(a, out + start, size);
  }
}

// What a table is asked for, from what is given: `inexact` with what that lacks.
struct By_modulus
{
  using Table = rows::K_by_modulus;
  static constexpr bool inexact = false;
  SWING_INLINE static double argument(double k) { return 1 - bits::magnitude(k); }
};

template <class Of>
struct As_given
{
  using Table = Of;
  static constexpr bool inexact = false;
  SWING_INLINE static double argument(double x) { return x; }
};

struct By_zeta
{
  using Table = rows::Ratio_by_eta;
  static constexpr bool inexact = true;
  SWING_INLINE static double argument(double zeta)
  {
    return zeta >= 0 ? (pi_hi - zeta) + pi_lo : std::numeric_limits<double>::quiet_NaN();
  }
  SWING_INLINE static double lost(double zeta) { return ((pi_hi - zeta) - argument(zeta)) + pi_lo; }
};

}  // namespace
}  // namespace swing::kernels
