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
/// |x|.
SWING_INLINE double magnitude(double x)
{
  return __builtin_fabs(x);
}
/// x, and −x where `sign` is the bit of the sign.
SWING_INLINE double with_sign(double x, std::uint64_t sign)
{
  return from_bits(bits_of(x) ^ sign);
}

}  // namespace swing::bits
