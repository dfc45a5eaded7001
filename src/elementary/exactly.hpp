/// @file
/// Sums and products of doubles with what they are rounded by, and the bits of a double: for one number or for a
/// vector of them.
///
/// The errors are exact in round-to-nearest without contraction (Knuth, Dekker). Everything is inlined always, so
/// that no code made for one processor can be picked by the linker for another.
#pragma once

#include <cstdint>

/// Never a function of its own.
#define ELEMENTARY_INLINE [[gnu::always_inline]] inline

/// Functions that give the same bits on every machine.
namespace elementary
{

/// The whole numbers that have the bits of a Real, which is double or a vector of doubles.
template <class Real>
struct BitsOf
{
  typedef std::uint64_t Type __attribute__((vector_size(sizeof(Real))));  ///< as many as there are numbers
};
/// @cond
template <>
struct BitsOf<double>
{
  using Type = std::uint64_t;
};
/// @endcond
template <class Real>
using Bits = typename BitsOf<Real>::Type;  ///< the same, shorter

/// The bits of x.
template <class Real>
ELEMENTARY_INLINE Bits<Real> bits_of(Real x)
{
  return __builtin_bit_cast(Bits<Real>, x);
}
/// The number that has these bits.
template <class Real>
ELEMENTARY_INLINE Real from_bits(Bits<Real> b)
{
  return __builtin_bit_cast(Real, b);
}

constexpr std::uint64_t sign_bit = 0x8000000000000000;  ///< set in negative numbers

/// |x|.
template <class Real>
ELEMENTARY_INLINE Real magnitude(Real x)
{
  return from_bits<Real>(bits_of(x) & ~sign_bit);
}

/// A number as a sum, the second part being small beside the first.
template <class Real>
struct Pair
{
  Real value;  ///< the leading part
  Real lost;   ///< what it lacks
};

/// a + b as it is, for |a| ≥ |b| or a = 0.
template <class Real>
ELEMENTARY_INLINE Pair<Real> ordered_sum(Real a, Real b)
{
  const Real sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b as it is.
template <class Real>
ELEMENTARY_INLINE Pair<Real> sum_of(Real a, Real b)
{
  const Real sum = a + b;
  const Real from_b = sum - a;
  return {sum, (a - (sum - from_b)) + (b - from_b)};
}

/// a − b as it is.
template <class Real>
ELEMENTARY_INLINE Pair<Real> difference_of(Real a, Real b)
{
  return sum_of(a, -b);
}

/// The upper 26 bits of x; x − head_of(x) has no more. |x| < 2⁹⁹⁶.
template <class Real>
ELEMENTARY_INLINE Real head_of(Real x)
{
  const Real wide = x * 0x1.0000002p27;
  return wide - (wide - x);
}

/// a·b as it is; what it is rounded by must not underflow.
template <class Real>
ELEMENTARY_INLINE Pair<Real> product_of(Real a, Real b)
{
  const Real product = a * b;
  const Real ah = head_of(a), at = a - ah;
  const Real bh = head_of(b), bt = b - bh;
  return {product, ((ah * bh - product) + ah * bt + at * bh) + at * bt};
}

}  // namespace elementary
