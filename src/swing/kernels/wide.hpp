/// @file
/// As many numbers at once as a register holds.
///
/// Part of kernels.cpp, and compiled with it once for each instruction set: like all of this folder it has
/// internal linkage, and takes nothing inline from a library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "swing/bits.hpp"

namespace swing::kernels
{
namespace
{

// Through a long computation the numbers go step by step, so many in one step before the next begins: of a
// short one the processor has several under way, of a long one it waits for each result.
constexpr std::size_t block = 128;

using bits::Wide;
using bits::width;

template <class Vector = Wide, class Number>
SWING_INLINE Vector load(const Number* x)
{
  Vector wide;
  __builtin_memcpy(&wide, x, sizeof wide);
  return wide;
}

template <class Vector, class Number>
SWING_INLINE void store(const Vector& x, Number* out)
{
  __builtin_memcpy(out, &x, sizeof x);
}

// The first n of them, or all where n is more.
SWING_INLINE void store_first(std::size_t n, Wide x, double* out)
{
  if(n >= width)
    store(x, out);
  else
    for(std::size_t i = 0; i < n; ++i)
      out[i] = x[i];
}

// Of a and b number by number in turn those in even places, and those in odd places.
template <unsigned... i>
SWING_INLINE void exchange_numbers(Wide& a, Wide& b, std::integer_sequence<unsigned, i...>)
{
  const Wide first = a;
  a = __builtin_shufflevector(first, b, (i % 2 == 0 ? i : width + i - 1)...);
  b = __builtin_shufflevector(first, b, (i % 2 == 0 ? i + 1 : width + i)...);
}

// Of a and then b the pairs in even places, and those in odd places.
template <unsigned... i>
SWING_INLINE void exchange_pairs(Wide& a, Wide& b, std::integer_sequence<unsigned, i...>)
{
  const Wide first = a;
  a = __builtin_shufflevector(first, b, (i / 2 * 4 + i % 2)...);
  b = __builtin_shufflevector(first, b, (i / 2 * 4 + i % 2 + 2)...);
}

// Transposes a square: first within the pairs, then the pairs, each time between the rows whose numbers
// differ by `distance`.
template <unsigned distance = 1>
SWING_INLINE void transpose(Wide* row)
{
  constexpr std::make_integer_sequence<unsigned, width> places{};
#pragma GCC unroll 8
  for(unsigned i = 0; i < width; ++i)
    if((i & distance) == 0)
    {
      if constexpr(distance == 1)
        exchange_numbers(row[i], row[i + distance], places);
      else
        exchange_pairs(row[i], row[i + distance], places);
    }
  if constexpr(2 * distance < width)
    transpose<2 * distance>(row);
}

// So many numbers has a row of a motion's table: one line of the cache.
constexpr unsigned row_length = 8;

// The first `length` numbers j of the next `width` rows as column[j], each row beginning where `row` says.
// This is much faster than to gather them one by one.
template <unsigned length>
SWING_INLINE void read_columns(const double* table, const std::uint64_t* row, Wide* column)
{
#pragma GCC unroll 8
  for(unsigned j = 0; j < length; j += width)
  {
#pragma GCC unroll 8
    for(unsigned i = 0; i < width; ++i)
      column[j + i] = load(table + row[i] + j);
    transpose(column + j);
  }
}

// The other way: writes the next `width` rows, one after another.
SWING_INLINE void write_rows(Wide* column, double* rows)
{
#pragma GCC unroll 8
  for(unsigned j = 0; j < row_length; j += width)
  {
    transpose(column + j);
#pragma GCC unroll 8
    for(unsigned i = 0; i < width; ++i)
      store(column[j + i], rows + i * row_length + j);
  }
}

// c[first] + c[first + step] x + … of the first n coefficients, at least two, unrolled.
template <unsigned first, unsigned step, unsigned n, class Number>
SWING_INLINE Number horner(const double* c, Number x)
{
  static_assert(first + step < n);
  if constexpr(first + 2 * step < n)
    return c[first] + x * horner<first + step, step, n>(c, x);
  else
    return c[first] + x * c[first + step];
}

// c[0] + c[1] x + …, the even and the odd powers apart: half the wait for one multiplication more.
template <unsigned n, class Number>
SWING_INLINE Number polynomial(const double* c, Number x)
{
  return horner<0, 2, n>(c, x * x) + x * horner<1, 2, n>(c, x * x);
}
template <unsigned n, class Number>
SWING_INLINE Number polynomial(const double (&c)[n], Number x)
{
  return polynomial<n>(&c[0], x);
}

}  // namespace
}  // namespace swing::kernels
