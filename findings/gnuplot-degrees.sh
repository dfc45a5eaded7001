#!/bin/sh
# gnuplot 5.4.4 (Debian gnuplot-nox 5.4.4+dfsg1-2+b2): with "set angles degrees" asinh and acosh give degrees, sinh and cosh take
# none, and atanh and tanh know nothing of it; log does not, and arg does.
#
# The guess: an axis in degrees changes sin, asin and their kin, and a hyperbolic function has nothing to do with angles. The manual
# says that the inverse ones of complex numbers are affected; asinh and acosh of any number are, and atanh of none. So sinh(asinh(1))
# is 4e21, a time next to a separatrix, which is an asinh, comes out 57 times too long in a plot that shows its angle in
# degrees, and the imaginary part of log(z) is not arg(z). Way out: log(x + sqrt(x*x + 1)), or degrees by hand.
#
#> radians: asinh(1) 0.881374, acosh(2) 1.316958, atanh(0.5) 0.549306
#> radians: sinh(asinh(1)) 1, cosh(acosh(2)) 2, tanh(atanh(0.5)) 0.5
#> radians: atanh(0.5 + 0.1 i), its real part 0.540610; asinh(1 + 0.1 i) 0.883142
#> radians: arg(i) 1.570796, imaginary part of log(i) 1.570796
#> degrees: asinh(1) 50.498987, acosh(2) 75.456129, atanh(0.5) 0.549306
#> degrees: sinh(asinh(1)) 4.26974e+21, cosh(acosh(2)) 2.94544e+32, tanh(atanh(0.5)) 0.5
#> degrees: atanh(0.5 + 0.1 i), its real part 0.540610; asinh(1 + 0.1 i) 50.600335
#> degrees: arg(i) 90.000000, imaginary part of log(i) 1.570796
. "$(dirname "$0")/room.sh"
debian gnuplot-nox=5.4.4+dfsg1-2+b2
cat >"$room/ask.gp" <<'G'
do for [unit in "radians degrees"] {
  if (unit eq "degrees") { set angles degrees } else { set angles radians }
  print sprintf("%s: asinh(1) %.6f, acosh(2) %.6f, atanh(0.5) %.6f", unit, asinh(1.0), acosh(2.0), atanh(0.5))
  print sprintf("%s: sinh(asinh(1)) %.6g, cosh(acosh(2)) %.6g, tanh(atanh(0.5)) %.6g", \
                unit, sinh(asinh(1.0)), cosh(acosh(2.0)), tanh(atanh(0.5)))
  print sprintf("%s: atanh(0.5 + 0.1 i), its real part %.6f; asinh(1 + 0.1 i) %.6f", \
                unit, real(atanh({0.5, 0.1})), real(asinh({1, 0.1})))
  print sprintf("%s: arg(i) %.6f, imaginary part of log(i) %.6f", unit, arg({0, 1}), imag(log({0, 1})))
}
G
in_room gnuplot ask.gp 2>"$room/seen"
as_seen "$room/seen"
