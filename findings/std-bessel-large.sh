#!/bin/sh
# libstdc++ 12.2 (Debian g++-12 12.2.0-14+deb12u1): std::cyl_bessel_j of an argument from 1000 on is any number at all when the
# order is some hundreds; the C library's jn, which asks for a whole order, is right.
#
# The guess: the special functions of C++17 are as good as those that POSIX has had before them, and a Bessel function of
# the first kind and whole order is never beyond 1. From x = 1000 on libstdc++ takes Hankel's expansion for large arguments,
# whatever the order is, for which it is of no use, and sums its terms while they still grow. The terms of a long
# Kapteyn or Jacobi series, J_n(n e), are such values. Below 1000 it is right. Way out: jn(); boost::math::cyl_bessel_j.
#
#> J_300(999.99): 0.0007142, jn: 0.0007142
#> J_300(1000.01): -3.1973, jn: 0.00022142
#> J_500(1000.01): -1.5945e+34, jn: -0.0192
#> J_1000(1000.01): 7.5057e+183, jn: 0.044772
#> J_5(1000.01): 0.0052724, jn: 0.0052724
. "$(dirname "$0")/room.sh"
debian g++-12=12.2.0-14+deb12u1
cat >"$room/ask.cpp" <<'C'
#include <cmath>
#include <cstdio>
#include <initializer_list>
int main()
{
  const auto ask = [](int n, double x) {
    std::printf("J_%d(%.6g): %.5g, jn: %.5g\n", n, x, std::cyl_bessel_j(n, x), jn(n, x));
  };
  ask(300, 999.99);
  for(const int n : {300, 500, 1000, 5})
    ask(n, 1000.01);
}
C
in_room g++-12 -std=c++17 ask.cpp -o ask
"$room/ask" >"$room/seen"
as_seen "$room/seen"
