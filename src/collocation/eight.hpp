/// @file
/// Eight numbers worked on at once: in one register, in two or in four, as the processor has them. The bits are the
/// same.
///
/// Everything lies in a namespace named after the registers' width and the variant, and is inlined always, so that no code
/// made for one processor, or with a caller's flags, can be picked by the linker for another.
#pragma once

#include "elementary/circular.hpp"

#if defined(__AVX512F__)
#define COLLOCATION_WIDTH 8
#elif defined(__AVX__)
#define COLLOCATION_WIDTH 4
#else
#define COLLOCATION_WIDTH 2
#endif
/// Set by collocation_variants() of the build: what is compiled there is not to be confused with what another file makes
/// of the same templates with other flags.
#ifndef COLLOCATION_VARIANT
#define COLLOCATION_VARIANT
#endif
#define COLLOCATION_JOIN(a, b, c) a##b##c
#define COLLOCATION_NAME(width, variant) COLLOCATION_JOIN(width_, width, variant)
/// The namespace of what is compiled for registers of this width.
#define COLLOCATION_REGISTERS COLLOCATION_NAME(COLLOCATION_WIDTH, COLLOCATION_VARIANT)

/// Motions of few degrees of freedom, integrated to rounding.
namespace collocation
{
/// Made for registers of COLLOCATION_WIDTH numbers.
inline namespace COLLOCATION_REGISTERS
{

constexpr unsigned width = COLLOCATION_WIDTH;                              ///< numbers in a register
constexpr unsigned parts = 8 / width;                                      ///< registers that hold eight
using Wide = double __attribute__((vector_size(width * sizeof(double))));  ///< a register

/// Answers to a question about each of eight numbers.
struct Mask
{
  decltype(Wide{} < Wide{}) part[parts];  ///< all bits set where it is true
};

/// Eight numbers.
struct Eight
{
  Wide part[parts];  ///< in order

  Eight() = default;
  /// Eight times x.
  ELEMENTARY_INLINE Eight(double x)
  {
    for(unsigned i = 0; i < parts; ++i)
      part[i] = Wide{} + x;
  }
  /// From memory.
  ELEMENTARY_INLINE explicit Eight(const double* x)
  {
    for(unsigned i = 0; i < parts; ++i)
      __builtin_memcpy(&part[i], x + i * width, sizeof(Wide));
  }
  /// To memory.
  ELEMENTARY_INLINE void store(double* x) const
  {
    for(unsigned i = 0; i < parts; ++i)
      __builtin_memcpy(x + i * width, &part[i], sizeof(Wide));
  }
};

/// f of each register of the arguments.
template <class Result = Eight, class Function, class... Arguments>
ELEMENTARY_INLINE Result each(Function f, const Arguments&... x)
{
  Result result;
  for(unsigned i = 0; i < parts; ++i)
    result.part[i] = f(x.part[i]...);
  return result;
}

/// Number by number.
/// @{
ELEMENTARY_INLINE Eight operator+(const Eight& x, const Eight& y)
{
  return each([](Wide a, Wide b) { return a + b; }, x, y);
}
ELEMENTARY_INLINE Eight operator-(const Eight& x, const Eight& y)
{
  return each([](Wide a, Wide b) { return a - b; }, x, y);
}
ELEMENTARY_INLINE Eight operator*(const Eight& x, const Eight& y)
{
  return each([](Wide a, Wide b) { return a * b; }, x, y);
}
ELEMENTARY_INLINE Eight operator/(const Eight& x, const Eight& y)
{
  return each([](Wide a, Wide b) { return a / b; }, x, y);
}
ELEMENTARY_INLINE Eight operator-(const Eight& x)
{
  return each([](Wide a) { return -a; }, x);
}
ELEMENTARY_INLINE Eight magnitude(const Eight& x)
{
  return each([](Wide a) { return elementary::magnitude(a); }, x);
}
ELEMENTARY_INLINE Mask operator<=(const Eight& x, const Eight& y)
{
  return each<Mask>([](Wide a, Wide b) { return a <= b; }, x, y);
}
ELEMENTARY_INLINE Mask operator<(const Eight& x, const Eight& y)
{
  return each<Mask>([](Wide a, Wide b) { return a < b; }, x, y);
}
ELEMENTARY_INLINE Mask operator&(const Mask& x, const Mask& y)
{
  return each<Mask>([](auto a, auto b) { return a & b; }, x, y);
}
ELEMENTARY_INLINE Mask operator|(const Mask& x, const Mask& y)
{
  return each<Mask>([](auto a, auto b) { return a | b; }, x, y);
}
ELEMENTARY_INLINE Mask operator!(const Mask& x)
{
  return each<Mask>([](auto a) { return ~a; }, x);
}
ELEMENTARY_INLINE Eight select(const Mask& which, const Eight& x, const Eight& y)
{
  return each([](auto m, Wide a, Wide b) -> Wide { return m ? a : b; }, which, x, y);
}
/// @}

/// The same of one number.
/// @{
ELEMENTARY_INLINE double select(bool which, double x, double y)
{
  return which ? x : y;
}
ELEMENTARY_INLINE Eight select(bool which, const Eight& x, const Eight& y)
{
  return which ? x : y;
}
ELEMENTARY_INLINE bool any(bool x)
{
  return x;
}
ELEMENTARY_INLINE double root(double x)
{
  return __builtin_sqrt(x);
}
/// @}

/// Whether it is true of one at least.
ELEMENTARY_INLINE bool any(const Mask& x)
{
  auto together = x.part[0];
  for(unsigned i = 1; i < parts; ++i)
    together |= x.part[i];
  long long found = 0;
  for(unsigned i = 0; i < width; ++i)
    found |= together[i];
  return found != 0;
}

/// The square root.
ELEMENTARY_INLINE Eight root(const Eight& x)
{
  double y[8];
  x.store(y);
  for(double& number : y)
    number = __builtin_sqrt(number);
  return Eight(y);
}

/// Sine and cosine as elementary::circular::swift_sincos has them.
/// @{
ELEMENTARY_INLINE elementary::SineCosine<Eight> sincos(const Eight& x)
{
  elementary::SineCosine<Eight> both;
  for(unsigned i = 0; i < parts; ++i)
  {
    const auto [s, c] = elementary::circular::swift_sincos(x.part[i]);
    both.sine.part[i] = s;
    both.cosine.part[i] = c;
  }
  return both;
}
ELEMENTARY_INLINE elementary::SineCosine<double> sincos(double x)
{
  return elementary::circular::swift_sincos(x);
}
/// @}

/// The sum, in the order ((0+4)+(2+6))+((1+5)+(3+7)).
ELEMENTARY_INLINE double sum(const Eight& x)
{
  double y[8];
  x.store(y);
  return ((y[0] + y[4]) + (y[2] + y[6])) + ((y[1] + y[5]) + (y[3] + y[7]));
}

}  // namespace COLLOCATION_REGISTERS
}  // namespace collocation
