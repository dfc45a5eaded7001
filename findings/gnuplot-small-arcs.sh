#!/bin/sh
# gnuplot 5.4.4 (Debian gnuplot-nox 5.4.4+dfsg1-2+b2): asinh(x) is off by a hundredth at x = 1e-7 and nought from 1e-8 on; atanh
# loses its digits too; asin, atan, sinh and tanh keep theirs.
#
# The guess: a function that a program has can be used; asinh is in the C library since 1999. Here it is made from complex
# square roots and a logarithm of a sum that is nearly one. A curve that should go through the origin as a straight line
# goes through it as a step, on logarithmic scales it ends; so do times near a separatrix, which are arcs of this kind.
# Way out: for small x, x - x**3/6 and x + x**3/3.
#
#> x = 1e-4: asinh(x)/x 0.999999995, atanh(x)/x 1.000000003, asin(x)/x 1.000000002, tanh(x)/x 0.999999997
#> x = 1e-6: asinh(x)/x 1.000044449, atanh(x)/x 1.000000000, asin(x)/x 1.000000000, tanh(x)/x 1.000000000
#> x = 1e-7: asinh(x)/x 0.988431212, atanh(x)/x 1.000000000, asin(x)/x 1.000000000, tanh(x)/x 1.000000000
#> x = 1e-8: asinh(x)/x 0.000000000, atanh(x)/x 0.999999996, asin(x)/x 1.000000000, tanh(x)/x 1.000000000
#> x = 1e-15: asinh(x)/x 0.000000000, atanh(x)/x 1.054711873, asin(x)/x 1.000000000, tanh(x)/x 1.000000000
#> x = 1e-17: asinh(x)/x 0.000000000, atanh(x)/x 0.000000000, asin(x)/x 1.000000000, tanh(x)/x 1.000000000
. "$(dirname "$0")/room.sh"
debian gnuplot-nox=5.4.4+dfsg1-2+b2
cat >"$room/ask.gp" <<'G'
do for [e in "-4 -6 -7 -8 -15 -17"] {
  x = 10.0**e
  print sprintf("x = 1e%s: asinh(x)/x %.9f, atanh(x)/x %.9f, asin(x)/x %.9f, tanh(x)/x %.9f", \
                e, asinh(x)/x, atanh(x)/x, asin(x)/x, tanh(x)/x)
}
G
in_room gnuplot ask.gp 2>"$room/seen"
as_seen "$room/seen"
