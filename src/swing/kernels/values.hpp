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

// So many go together: few enough that seldom one of them lies below the rows where not many do.
constexpr std::size_t few = 32;

// What of them is known before the table is read.
struct Arguments
{
  alignas(64) double given[few];
  alignas(64) double x[few];  // whose distance from the row's centre is asked for
  alignas(64) double lost[few];
  alignas(64) std::uint64_t row[few];
  alignas(64) double mantissa[few];
  alignas(64) double halvings[few];
  alignas(64) double z[few];
  alignas(64) std::uint64_t centre[few];
};

template <class Table>
SWING_INLINE Wide in_domain(Wide x)
{
  return ((x > 0.0) & (x <= Table::last)) ? x : Wide{} + 1.0;
}

// Whether something holds of one of the numbers, of which a comparison told.
template <class Comparison>
SWING_INLINE bool any(const Comparison& holds)
{
  auto found = holds[0];
  for(unsigned i = 1; i < width; ++i)
    found |= holds[i];
  return found != 0;
}

// Each argument's row, and whether some arguments lie below the rows.
template <class Kernel>
SWING_INLINE bool find_rows(const double* in, Arguments& a)
{
  using Table = typename Kernel::Table;
  auto below = Wide{} > 0.0;
  for(std::size_t i = 0; i < few; i += width)
  {
    const Wide given = load(in + i);
    const Wide x = Kernel::argument(given);
    const Wide inside = in_domain<Table>(x);
    below |= inside < Table::start;
    const auto place = Kernel::place_of(given, inside < Table::start ? Wide{} + Table::start : inside);
    store(x, a.given + i);
    store(place.x, a.x + i);
    store(place.row * sizeof(Table::stored.rows[0]) / sizeof(double), a.row + i);
    if constexpr(Kernel::inexact)
      store(place.rest, a.lost + i);
  }
  return any(below);
}

// Where some do, what the logarithm of those is read from; of all others it is that of 1.
template <class Kernel>
SWING_INLINE void find_centres(Arguments& a)
{
  using Table = typename Kernel::Table;
  for(std::size_t i = 0; i < few; i += width)
  {
    const Wide inside = in_domain<Table>(load(a.given + i));
    const auto below = inside < Table::start;
    const Wide x = below ? inside : Wide{} + 1.0;
    const rows::Scaled<Wide> s = rows::scaled<Table>(x, Table::stored.zero);
    store(s.mantissa, a.mantissa + i);
    store(below ? s.halvings : Wide{}, a.halvings + i);
    store(rows::small_of<Table>(x), a.z + i);
    store(rows::centre_of(s.mantissa), a.centre + i);
    if constexpr(Kernel::inexact)
      store(load(a.lost + i) * s.power, a.lost + i);
  }
}

// What the logarithm says of the next `width`.
template <class Kernel>
SWING_INLINE Wide below_rows(const Arguments& a, std::size_t i)
{
  using Table = typename Kernel::Table;
  Wide centre{};
  Wide value{};
  for(unsigned j = 0; j < width; ++j)
  {
    centre[j] = Table::stored.centres[a.centre[i + j]];
    value[j] = Table::stored.centres[a.centre[i + j] + 1];
  }
  const Wide mantissa = load(a.mantissa + i);
  Wide distance = mantissa - centre;
  if constexpr(Kernel::inexact)
    distance += load(a.lost + i);
  const rows::Sum<Wide> sum =
      rows::below(Table::stored, rows::Reading<Wide>{value, distance, mantissa + centre},
                  load(a.halvings + i), load(a.z + i));
  return sum.main + sum.rest;
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
    Wide c[tables::row_length];
    read_columns<tables::row_length>(Table::stored.rows[0], a.row + i, c);
    const Wide given = load(a.given + i);
    Wide t = load(a.x + i) - c[0];
    if constexpr(Kernel::inexact)
      t += load(a.lost + i);
    const rows::Sum<Wide> sum =
        rows::beyond_centre<Table>(c[1], c[14], t, rows::quintic<2, Table::sloping>(c + 2, t),
                                   rows::quintic<2, Table::sloping>(c + 3, t));
    Wide value = sum.main + sum.rest;
    if constexpr(some_below)
    {
      const auto below = load(a.halvings + i) != 0.0;
      if(any(below))
        value = below ? below_rows<Kernel>(a, i) : value;
    }
    const Wide outside = given == 0.0 ? Wide{} + inf : Wide{} + nan;
    value = ((given > 0.0) & (given <= Table::last)) ? value : outside;
    store_first(size - i, value, out + i);
  }
}

template <class Kernel>
void table_loop(const double* in, double* out, std::size_t n)
{
  Arguments a;
  double last[few] = {};  // those that are fewer
  for(std::size_t start = 0; start < n; start += few)
  {
    const std::size_t size = n - start < few ? n - start : few;
    const double* given = in + start;
    if(size < few)
    {
      __builtin_memcpy(last, given, size * sizeof(double));
      given = last;
    }
    if(find_rows<Kernel>(given, a))
    {
      find_centres<Kernel>(a);
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
  SWING_INLINE static Wide argument(Wide k) { return 1.0 - bits::magnitude(k); }
  SWING_INLINE static auto place_of(Wide k, Wide x)
  {
    return rows::place_of_modulus(bits::magnitude(k), x);
  }
};

template <class Of>
struct As_given
{
  using Table = Of;
  static constexpr bool inexact = false;
  SWING_INLINE static Wide argument(Wide x) { return x; }
  SWING_INLINE static auto place_of(Wide, Wide x) { return rows::place_of<Table>(x); }
};

struct By_eta
{
  using Table = rows::Ratio_by_eta;
  static constexpr bool inexact = true;
  SWING_INLINE static Wide argument(Wide eta) { return eta; }
  SWING_INLINE static auto place_of(Wide, Wide eta) { return rows::place_of_angles(rows::from_top(eta)); }
};

struct By_zeta
{
  using Table = rows::Ratio_by_eta;
  static constexpr bool inexact = true;
  SWING_INLINE static Wide argument(Wide zeta)
  {
    return zeta >= 0.0 ? (pi_hi - zeta) + pi_lo : Wide{} + std::numeric_limits<double>::quiet_NaN();
  }
  SWING_INLINE static auto place_of(Wide zeta, Wide eta)
  {
    rows::Angles<Wide> a = rows::from_bottom(zeta, pi_hi, pi_lo);
    a.eta = eta;
    return rows::place_of_angles(a);
  }
};

}  // namespace
}  // namespace swing::kernels
