/// @file
/// Doubles as bits, and what else is always inlined: so no code made for one processor can be picked by the
/// linker for another.
#pragma once

#include <cstdint>

/// Never a function of its own.
#define SWING_INLINE [[gnu::always_inline]] inline

/// Doubles as bits.
namespace swing::bits
{

/// The bit of the sign.
inline constexpr std::uint64_t sign_bit = 0x8000000000000000;

/// As many numbers as a register holds.
#if defined(__AVX512F__)
constexpr unsigned width = 8;
#elif defined(__AVX__)
constexpr unsigned width = 4;
#else
constexpr unsigned width = 2;
#endif
/// A register of them.
using Wide = double __attribute__((vector_size(width * sizeof(double))));
/// And of their bits.
using Wide_bits = std::uint64_t __attribute__((vector_size(width * sizeof(double))));

/// The bits of x.
SWING_INLINE std::uint64_t bits_of(double x)
{
  return __builtin_bit_cast(std::uint64_t, x);
}
/// The same of several.
SWING_INLINE Wide_bits bits_of(Wide x)
{
  return __builtin_bit_cast(Wide_bits, x);
}
/// The double that has these bits.
SWING_INLINE double from_bits(std::uint64_t b)
{
  return __builtin_bit_cast(double, b);
}
/// The same of several.
SWING_INLINE Wide from_bits(Wide_bits b)
{
  return __builtin_bit_cast(Wide, b);
}
/// The same object, of which the compiler no longer knows the contents: then it reads each number where it
/// stands, beside the others, and does not copy it to where the function's own constants are.
template <class Object>
SWING_INLINE const Object& as_stored(const Object& object)
{
  const Object* place = &object;
  asm("" : "+r"(place));
  return *place;
}

/// The same number, made from its bits where it is used and not fetched from where constants stand: where a row's place
/// depends on it and the caches are cold, the row would be waited for once more.
SWING_INLINE double made(double x)
{
  std::uint64_t b = bits_of(x);
  asm("" : "+r"(b));
  return from_bits(b);
}

/// |x|.
SWING_INLINE double magnitude(double x)
{
  return __builtin_fabs(x);
}
/// The same of several.
SWING_INLINE Wide magnitude(Wide x)
{
  return from_bits(bits_of(x) & ~sign_bit);
}
/// x, and −x where `sign` is the bit of the sign.
SWING_INLINE double with_sign(double x, std::uint64_t sign)
{
  return from_bits(bits_of(x) ^ sign);
}
/// The same of several.
SWING_INLINE Wide with_sign(Wide x, Wide_bits sign)
{
  return from_bits(bits_of(x) ^ sign);
}

}  // namespace swing::bits
