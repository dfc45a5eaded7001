#pragma once
// Private to src/exact: what the bytes of a Fifty hold, for the functions that hand it to Boost and back.
#include "exact/fifty.hpp"

// Boost writes whole numbers as the global locale would have them unless it is told not to, and then trips over its own
// separators.
#define BOOST_LEXICAL_CAST_ASSUME_C_LOCALE
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <new>
#include <type_traits>

namespace exact
{

using Real = boost::multiprecision::cpp_bin_float_50;

struct Inside
{
  static_assert(sizeof(Real) <= sizeof(Fifty::bytes_));
  static_assert(alignof(Real) <= alignof(Fifty));
  static_assert(std::is_trivially_destructible_v<Real>);

  template <class Value>
  static void begin(Fifty& x, const Value& value)
  {
    ::new(static_cast<void*>(x.bytes_)) Real(value);
  }
  static Real& of(Fifty& x) { return *std::launder(reinterpret_cast<Real*>(x.bytes_)); }
  static const Real& of(const Fifty& x) { return *std::launder(reinterpret_cast<const Real*>(x.bytes_)); }
};

inline const Real& real(const Fifty& x)
{
  return Inside::of(x);
}

inline Fifty fifty(const Real& value)
{
  Fifty x;
  Inside::of(x) = value;
  return x;
}

}  // namespace exact
