#!/bin/sh
# SciPy 1.10.1 (Debian python3-scipy 1.10.1-2): mathieu_cem and mathieu_sem take their argument in degrees, and give the derivative
# by radians.
#
# The guess: one of two. Who has not read it takes the argument for radians, like everything else in scipy.special; who has
# takes the second result, "the derivative with respect to x", for one by that x. It is 57 times as large. Way out: multiply by
# pi/180, or think of the second result as of a function of its own.
#
#> ce_1(q = 0) at 60: 0.5, at 60 radians: -0.9524
#> the derivative at 60: -0.8660, by differences of the argument: -0.0151
. "$(dirname "$0")/room.sh"
debian python3-scipy=1.10.1-2
cat >"$room/ask.py" <<'P'
from math import cos
from scipy.special import mathieu_cem
value, derivative = mathieu_cem(1, 0, 60)
print('ce_1(q = 0) at 60: %.4g, at 60 radians: %.4f' % (value, cos(60)))
step = 1e-3
print('the derivative at 60: %.4f, by differences of the argument: %.4f'
      % (derivative, (mathieu_cem(1, 0, 60 + step)[0] - mathieu_cem(1, 0, 60 - step)[0]) / (2 * step)))
P
in_room /usr/bin/python3 ask.py >"$room/seen"
as_seen "$room/seen"
