// The C library's names of the elementary functions, for a program in which they are to have the same bits on every machine
// and in the page: the functions of nearest.hpp. What is linked into a program goes before its libraries, and holds for
// them, too.

#include "elementary/nearest.hpp"

namespace nearest = elementary::nearest;

extern "C"
{
  double sin(double x)
  {
    return nearest::sin(x);
  }
  double cos(double x)
  {
    return nearest::cos(x);
  }
  double tan(double x)
  {
    return nearest::tan(x);
  }
  double asin(double x)
  {
    return nearest::asin(x);
  }
  double acos(double x)
  {
    return nearest::acos(x);
  }
  double atan(double x)
  {
    return nearest::atan(x);
  }
  double exp(double x)
  {
    return nearest::exp(x);
  }
  double exp2(double x)
  {
    return nearest::exp2(x);
  }
  double expm1(double x)
  {
    return nearest::expm1(x);
  }
  double log(double x)
  {
    return nearest::log(x);
  }
  double log2(double x)
  {
    return nearest::log2(x);
  }
  double log10(double x)
  {
    return nearest::log10(x);
  }
  double log1p(double x)
  {
    return nearest::log1p(x);
  }
  double cbrt(double x)
  {
    return nearest::cbrt(x);
  }
  double sinh(double x)
  {
    return nearest::sinh(x);
  }
  double cosh(double x)
  {
    return nearest::cosh(x);
  }
  double tanh(double x)
  {
    return nearest::tanh(x);
  }
  double asinh(double x)
  {
    return nearest::asinh(x);
  }
  double acosh(double x)
  {
    return nearest::acosh(x);
  }
  double atanh(double x)
  {
    return nearest::atanh(x);
  }
  double atan2(double y, double x)
  {
    return nearest::atan2(y, x);
  }
  double pow(double x, double y)
  {
    return nearest::pow(x, y);
  }
  double hypot(double x, double y)
  {
    return nearest::hypot(x, y);
  }
  /// The compiler asks for both at once where a program asks for each.
  void sincos(double x, double* sine, double* cosine)
  {
    *sine = nearest::sin(x);
    *cosine = nearest::cos(x);
  }
}
