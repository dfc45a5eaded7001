#!/bin/sh
# xsimd 8.1.0 (Debian libxsimd-dev 8.1.0-7): fmod, remainder, hypot and atan2 of batches are not those of the C library.
#
# The guess: fmod is exact by definition, whatever the quotient, and the thing to bring a time into one period with. Here it is
# x - trunc(x/y) y, rounded at each step: after 1e9 periods and some, eight digits of the phase are left, after 1e15 one. hypot is
# the root of the sum of the squares and overflows with them, for which alone one calls it. atan2(0, -0) is not a number.
# Way out: reduce with std::fmod before the loop; scale before hypot. (The sines are right at any argument.)
#
#> fmod(1e9, 0.3): xsimd 0.100000023842, exactly 0.100000037007
#> fmod(1e15, 0.3): xsimd 0.125000000000, exactly 0.137007434154
#> remainder(1e15, 0.3): xsimd -0.125000000000, exactly 0.137007434154
#> hypot(3e200, 4e200): xsimd inf, std 5e+200
#> hypot(3e-200, 4e-200): xsimd 0, std 5e-200
#> atan2(0, -0): xsimd nan, std 3.14159
. "$(dirname "$0")/room.sh"
debian libxsimd-dev=8.1.0-7
cat >"$room/ask.cpp" <<'C'
#include <cmath>
#include <cstdio>
#include <string>
#include <xsimd/xsimd.hpp>
using Batch = xsimd::batch<double>;
double first(const Batch& b)
{
  return b.get(0);
}
const char* shown(double x)
{
  static char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return std::isnan(x) ? "nan" : text;
}
int main()
{
  for(const char* x : {"1e9", "1e15"})
    std::printf("fmod(%s, 0.3): xsimd %.12f, exactly %.12f\n", x, first(fmod(Batch(std::stod(x)), Batch(0.3))),
                std::fmod(std::stod(x), 0.3));
  std::printf("remainder(1e15, 0.3): xsimd %.12f, exactly %.12f\n", first(remainder(Batch(1e15), Batch(0.3))),
              std::remainder(1e15, 0.3));
  std::printf("hypot(3e200, 4e200): xsimd %g, std %g\n", first(hypot(Batch(3e200), Batch(4e200))), std::hypot(3e200, 4e200));
  std::printf("hypot(3e-200, 4e-200): xsimd %g, std %g\n", first(hypot(Batch(3e-200), Batch(4e-200))),
              std::hypot(3e-200, 4e-200));
  std::printf("atan2(0, -0): xsimd %s, std %g\n", shown(first(atan2(Batch(0.0), Batch(-0.0)))), std::atan2(0.0, -0.0));
}
C
in_room c++ -std=c++17 -O1 -w ask.cpp -o ask
"$room/ask" >"$room/seen"
as_seen "$room/seen"
