// What the C library's names mean in a program with elementary/names.cpp, as the sections' programs are.
#include <dlfcn.h>
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <initializer_list>

#include "elementary/names.hpp"
#include "elementary/nearest.hpp"

namespace nearest = elementary::nearest;

namespace
{

double theirs(const char* name, double x)
{
  static void* const library = dlopen("libm.so.6", RTLD_NOW);
  REQUIRE(library != nullptr);
  return reinterpret_cast<double (*)(double)>(dlsym(library, name))(x);
}

}  // namespace

TEST_CASE("the names mean the functions rounded to nearest, and the C library's while something is timed")
{
  for(int i = 1; i < 1000; ++i)
  {
    const volatile double x = 0.001 * i;  // read anew: of one number a compiler asks for one sine
    CHECK(std::sinh(x) == nearest::sinh(x));
    CHECK(std::exp(x) == nearest::exp(x));
    CHECK(std::sin(100 * x) == nearest::sin(100 * x));
    const elementary::Plain_names plain;
    CHECK(std::sinh(x) == theirs("sinh", x));
    CHECK(std::exp(x) == theirs("exp", x));
    CHECK(std::sin(100 * x) == theirs("sin", 100 * x));
    {
      const elementary::Plain_names again;
    }
    CHECK(elementary::Plain_names::asked());
    CHECK(std::cbrt(x) == theirs("cbrt", x));
  }
  CHECK_FALSE(elementary::Plain_names::asked());
}

TEST_CASE("an angle's sine and cosine asked for together are the same")
{
  double sine = 0, cosine = 0;
  for(const double x : {0.1, 2.0, 1e5})
  {
    sincos(x, &sine, &cosine);
    CHECK(sine == nearest::sin(x));
    CHECK(cosine == nearest::cos(x));
    const elementary::Plain_names plain;
    sincos(x, &sine, &cosine);
    CHECK(sine == theirs("sin", x));
    CHECK(cosine == theirs("cos", x));
  }
}

TEST_CASE("of complex numbers, too, they are made of the functions rounded to nearest")
{
  for(const double x : {-3.0, 0.1, 2.0, 40.0})
    for(const double y : {-1.5, 1e-9, 0.7})
    {
      const std::complex<double> z(x, y);
      CHECK(std::abs(z) == nearest::hypot(x, y));
      CHECK(std::cos(z).real() == nearest::cos(x) * nearest::cosh(y));
      CHECK(std::cos(z).imag() == -nearest::sin(x) * nearest::sinh(y));
      CHECK(std::sin(z).real() == nearest::sin(x) * nearest::cosh(y));
      CHECK(std::sin(z).imag() == nearest::cos(x) * nearest::sinh(y));
    }
}
