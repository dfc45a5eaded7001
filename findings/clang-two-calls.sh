#!/bin/sh
# clang++ 14 (Debian clang-14 1:14.0.6-12), beside g++ 12.2 (g++-12 12.2.0-14+deb12u1), with glibc: for the sine and the cosine of one
# angle g++ calls sincos once, at the usual -O2; clang++ calls sin and then cos, at every level of optimization, unless it is told
# -fno-math-errno. A rule of quadrature whose integrand has both took here 2.6 times as long by clang++ as by g++, and with the
# option no longer.
#
# The guess: both optimize alike what every program of this field does at each step, and -fno-math-errno, which changes no
# number, saves a comparison after a root. To clang++ a sine that may set errno has an effect, and of two such calls none can be
# made; g++ makes one all the same. -ffast-math brings the one call too, and with it other numbers.
#
#> compiled by                     calls for sin x and cos x
#> g++ -O2                         sincos
#> clang++ -O2                     cos sin
#> clang++ -O3                     cos sin
#> clang++ -O2 -fno-math-errno     sincos
. "$(dirname "$0")/room.sh"
debian clang-14=1:14.0.6-12 g++-12=12.2.0-14+deb12u1
cat >"$room/ask" <<'S'
cat >product.cpp <<'C'
#include <cmath>
double product(double x) { return std::sin(x) * std::cos(x); }
C
calls() { # how it is called, compiler, options...
  said=$1
  shift
  printf '%-30s  %s\n' "$said" "$("$@" -S product.cpp -o - | grep -E '^[[:space:]]+(call|jmp|bl|b)q?[[:space:]]' |
    grep -oE 'sincos|sin|cos' | sort | paste -sd ' ')"
}
printf '%-30s  %s\n' 'compiled by' 'calls for sin x and cos x'
calls 'g++ -O2' g++-12 -O2
calls 'clang++ -O2' clang++-14 -O2
calls 'clang++ -O3' clang++-14 -O3
calls 'clang++ -O2 -fno-math-errno' clang++-14 -O2 -fno-math-errno
S
in_room sh ask >"$room/seen"
as_seen "$room/seen"
