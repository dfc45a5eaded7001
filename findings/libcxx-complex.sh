#!/bin/sh
# libc++ 14 (Debian libc++-14-dev 1:14.0.6-12; 19.1.7 and 22.1.8 the same; what clang takes on a Mac, for Android and for the web): the
# inverse functions, the root and the logarithm of complex numbers are the schoolbook's formulae, and lose what these lose.
#
# The guess: the standard's complex functions are as good as the real ones, as they are in libstdc++, which calls the C library's.
# Here asinh is log(z + root(z^2 + 1)): of a negative number a difference of two large ones, wrong in the seventh digit at -1e5
# and infinite at -1e9; of a small one nought. The arc sine of 1e9 has no real part, the root of -4 has one, the logarithm next to
# the unit circle has few digits, and tanh(i pi/2), where a tangent is 1.6e16, is not a number. Times next to a separatrix and
# arcs that have become complex are arguments of this kind; the same program with libstdc++ has all the digits shown. Way out: the
# real functions for real arguments; asinh(-z) as -asinh(z); log|z| by log1p.
#
#> asinh(-1e5)         libc++ (-12.20607376, 0), libstdc++ (-12.20607265, 0)
#> asinh(-1e9)         libc++ (-inf, 0), libstdc++ (-21.41641302, 0)
#> asinh(1e-8)/1e-8    libc++ (0.9999999889, 0), libstdc++ (1, 0)
#> asinh(1e-17)/1e-17  libc++ (0, 0), libstdc++ (1, 0)
#> atanh(1e-8)/1e-8    libc++ (0.999999995, 0), libstdc++ (1, 0)
#> asin(1e9)           libc++ (0, 16.60859036), libstdc++ (1.570796327, 21.41641302)
#> sqrt(-4)            libc++ (1.224646799e-16, 2), libstdc++ (0, 2)
#> log(1 + 1e-6 i)     libc++ (5.000444503e-13, 1e-06), libstdc++ (5e-13, 1e-06)
#> tanh(i pi/2)        libc++ (nan, inf), libstdc++ (0, 1.633123935e+16)
. "$(dirname "$0")/room.sh"
debian clang-14=1:14.0.6-12 libc++-14-dev=1:14.0.6-12 libc++abi-14-dev=1:14.0.6-12
cat >"$room/ask.cpp" <<'C'
#include <cmath>
#include <complex>
#include <cstdio>
int main()
{
  using Z = std::complex<double>;
  volatile double zero = 0;
  const auto part = [](double x) { return std::isnan(x) ? std::abs(x) : x; };
  const auto tell = [part](const char* name, Z z)
  { std::printf("%s|(%.10g, %.10g)\n", name, part(z.real()), part(z.imag())); };
  tell("asinh(-1e5)", std::asinh(Z(-1e5, zero)));
  tell("asinh(-1e9)", std::asinh(Z(-1e9, zero)));
  tell("asinh(1e-8)/1e-8", std::asinh(Z(1e-8, zero)) / 1e-8);
  tell("asinh(1e-17)/1e-17", std::asinh(Z(1e-17, zero)) / 1e-17);
  tell("atanh(1e-8)/1e-8", std::atanh(Z(1e-8, zero)) / 1e-8);
  tell("asin(1e9)", std::asin(Z(1e9, zero)));
  tell("sqrt(-4)", std::sqrt(Z(-4, zero)));
  tell("log(1 + 1e-6 i)", std::log(Z(1 + zero, 1e-6)));
  tell("tanh(i pi/2)", std::tanh(Z(zero, std::acos(zero))));
}
C
for library in libc++ libstdc++; do
  in_room clang++-14 -stdlib=$library -O1 ask.cpp -o ask
  in_room ./ask >"$room/$library"
done
paste -d'|' "$room/libc++" "$room/libstdc++" |
  awk -F'|' '{ printf "%-19s libc++ %s, libstdc++ %s\n", $1, $2, $4 }' >"$room/seen"
as_seen "$room/seen"
