/// @file
/// Eight numbers worked on at once, in one register, in two or in four, as the processor has them; or as many as one
/// register holds. The bits are the same.
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
using Wide = double __attribute__((vector_size(width * sizeof(double))));  ///< a register

/// f of each register of the arguments.
template <class Result, class Function, class First, class... Others>
ELEMENTARY_INLINE Result each(Function f, const First& x, const Others&... others)
{
  Result result;
  for(unsigned i = 0; i < First::parts; ++i)
    result.part[i] = f(x.part[i], others.part[i]...);
  return result;
}

/// Answers to a question about each of `count` numbers, all bits set where it is true.
template <unsigned count>
struct Answers
{
  static constexpr unsigned parts = count / width;  ///< registers that hold them
  decltype(Wide{} < Wide{}) part[parts];            ///< in order

  /// One by one.
  /// @{
  ELEMENTARY_INLINE friend Answers operator&(const Answers& x, const Answers& y)
  {
    return each<Answers>([](auto a, auto b) { return a & b; }, x, y);
  }
  ELEMENTARY_INLINE friend Answers operator|(const Answers& x, const Answers& y)
  {
    return each<Answers>([](auto a, auto b) { return a | b; }, x, y);
  }
  ELEMENTARY_INLINE friend Answers operator!(const Answers& x)
  {
    return each<Answers>([](auto a) { return ~a; }, x);
  }
  /// @}

  /// Whether it is true of one at least.
  ELEMENTARY_INLINE friend bool any(const Answers& x)
  {
    auto together = x.part[0];
    for(unsigned i = 1; i < parts; ++i)
      together |= x.part[i];
    long long found = 0;
    for(unsigned i = 0; i < width; ++i)
      found |= together[i];
    return found != 0;
  }
};

/// `count` numbers.
template <unsigned count>
struct Several
{
  static constexpr unsigned parts = count / width;  ///< registers that hold them
  Wide part[parts];                                 ///< in order

  Several() = default;
  /// So many times x.
  ELEMENTARY_INLINE Several(double x)
  {
    for(unsigned i = 0; i < parts; ++i)
      part[i] = Wide{} + x;
  }
  /// From memory.
  ELEMENTARY_INLINE explicit Several(const double* x)
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

  /// Number by number.
  /// @{
  ELEMENTARY_INLINE friend Several operator+(const Several& x, const Several& y)
  {
    return each<Several>([](Wide a, Wide b) { return a + b; }, x, y);
  }
  ELEMENTARY_INLINE friend Several operator-(const Several& x, const Several& y)
  {
    return each<Several>([](Wide a, Wide b) { return a - b; }, x, y);
  }
  ELEMENTARY_INLINE friend Several operator*(const Several& x, const Several& y)
  {
    return each<Several>([](Wide a, Wide b) { return a * b; }, x, y);
  }
  ELEMENTARY_INLINE friend Several operator/(const Several& x, const Several& y)
  {
    return each<Several>([](Wide a, Wide b) { return a / b; }, x, y);
  }
  ELEMENTARY_INLINE friend Several operator-(const Several& x)
  {
    return each<Several>([](Wide a) { return -a; }, x);
  }
  ELEMENTARY_INLINE friend Several magnitude(const Several& x)
  {
    return each<Several>([](Wide a) { return elementary::magnitude(a); }, x);
  }
  ELEMENTARY_INLINE friend Answers<count> operator<=(const Several& x, const Several& y)
  {
    return each<Answers<count>>([](Wide a, Wide b) { return a <= b; }, x, y);
  }
  ELEMENTARY_INLINE friend Answers<count> operator<(const Several& x, const Several& y)
  {
    return each<Answers<count>>([](Wide a, Wide b) { return a < b; }, x, y);
  }
  ELEMENTARY_INLINE friend Several select(const Answers<count>& which, const Several& x, const Several& y)
  {
    return each<Several>([](auto m, Wide a, Wide b) -> Wide { return m ? a : b; }, which, x, y);
  }
  ELEMENTARY_INLINE friend Several select(bool which, const Several& x, const Several& y)
  {
    return which ? x : y;
  }
  /// The square root.
  ELEMENTARY_INLINE friend Several root(const Several& x)
  {
    double y[count];
    x.store(y);
    for(double& number : y)
      number = __builtin_sqrt(number);
    return Several(y);
  }
  /// Sine and cosine as elementary::circular::swift_sincos has them.
  ELEMENTARY_INLINE friend elementary::SineCosine<Several> sincos(const Several& x)
  {
    elementary::SineCosine<Several> both;
    for(unsigned i = 0; i < parts; ++i)
    {
      const auto [s, c] = elementary::circular::swift_sincos(x.part[i]);
      both.sine.part[i] = s;
      both.cosine.part[i] = c;
    }
    return both;
  }
  /// @}
};

using Eight = Several<8>;         ///< eight numbers
using Register = Several<width>;  ///< as many as a register holds

/// The same of one number.
/// @{
ELEMENTARY_INLINE double select(bool which, double x, double y)
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
