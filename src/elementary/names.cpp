// The C library's names of the elementary functions, for a program in which they are to have the same bits on every machine
// and in the page: the functions of nearest.hpp. What is linked into a program goes before its libraries, and holds for
// them, too. While something is timed they are the C library's own (names.hpp).

#include "elementary/names.hpp"
#include "elementary/nearest.hpp"

#ifndef __EMSCRIPTEN__
#include <dlfcn.h>
#endif

namespace nearest = elementary::nearest;

namespace
{

#ifdef __EMSCRIPTEN__
template <auto ours, class... Number>
double meant(const char*, Number... x)
{
  return ours(x...);
}
#else
// Of the programs and libraries after this one the first that has `name`: the C library.
template <class Function>
Function* plain(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// A complex number of C's; `__extension__`, for C++ has none.
__extension__ using Complex = double _Complex;

Complex complex(double real, double imaginary)
{
  Complex z = 0;
  __real__ z = real;
  __imag__ z = imaginary;
  return z;
}

// `name` is that of `ours`.
template <auto ours, class... Number>
double meant(const char* name, Number... x)
{
  if(!elementary::Plain_names::asked())
    return ours(x...);
  static const auto theirs = plain<double(Number...)>(name);
  return theirs(x...);
}
#endif

}  // namespace

extern "C"
{
  double sin(double x)
  {
    return meant<&nearest::sin>("sin", x);
  }
  double cos(double x)
  {
    return meant<&nearest::cos>("cos", x);
  }
  double tan(double x)
  {
    return meant<&nearest::tan>("tan", x);
  }
  double asin(double x)
  {
    return meant<&nearest::asin>("asin", x);
  }
  double acos(double x)
  {
    return meant<&nearest::acos>("acos", x);
  }
  double atan(double x)
  {
    return meant<&nearest::atan>("atan", x);
  }
  double exp(double x)
  {
    return meant<&nearest::exp>("exp", x);
  }
  double exp2(double x)
  {
    return meant<&nearest::exp2>("exp2", x);
  }
  double expm1(double x)
  {
    return meant<&nearest::expm1>("expm1", x);
  }
  double log(double x)
  {
    return meant<&nearest::log>("log", x);
  }
  double log2(double x)
  {
    return meant<&nearest::log2>("log2", x);
  }
  double log10(double x)
  {
    return meant<&nearest::log10>("log10", x);
  }
  double log1p(double x)
  {
    return meant<&nearest::log1p>("log1p", x);
  }
  double cbrt(double x)
  {
    return meant<&nearest::cbrt>("cbrt", x);
  }
  double sinh(double x)
  {
    return meant<&nearest::sinh>("sinh", x);
  }
  double cosh(double x)
  {
    return meant<&nearest::cosh>("cosh", x);
  }
  double tanh(double x)
  {
    return meant<&nearest::tanh>("tanh", x);
  }
  double asinh(double x)
  {
    return meant<&nearest::asinh>("asinh", x);
  }
  double acosh(double x)
  {
    return meant<&nearest::acosh>("acosh", x);
  }
  double atanh(double x)
  {
    return meant<&nearest::atanh>("atanh", x);
  }
  double atan2(double y, double x)
  {
    return meant<&nearest::atan2>("atan2", y, x);
  }
  double pow(double x, double y)
  {
    return meant<&nearest::pow>("pow", x, y);
  }
  double hypot(double x, double y)
  {
    return meant<&nearest::hypot>("hypot", x, y);
  }
  /// The compiler asks for both at once where a program asks for each.
  void sincos(double x, double* sine, double* cosine)
  {
#ifndef __EMSCRIPTEN__
    if(elementary::Plain_names::asked())
    {
      static const auto theirs = plain<void(double, double*, double*)>("sincos");
      return theirs(x, sine, cosine);
    }
#endif
    *sine = nearest::sin(x);
    *cosine = nearest::cos(x);
  }
#ifndef __EMSCRIPTEN__
  // Of a complex number: the page's C++ library makes these of those of real numbers, the C library here of its own.
  double cabs(Complex z)
  {
    return hypot(__real__ z, __imag__ z);
  }
  Complex ccos(Complex z)
  {
    const double x = __real__ z, y = __imag__ z;
    return complex(cos(x) * cosh(y), -sin(x) * sinh(y));
  }
  Complex csin(Complex z)
  {
    const double x = __real__ z, y = __imag__ z;
    return complex(sin(x) * cosh(y), cos(x) * sinh(y));
  }
#endif
}
