#!/bin/sh
# mpmath 1.2.1 (Debian python3-mpmath 1.2.1-2): nsum of Euler's own series for the period gives fifteen digits of which
# fewer and fewer are right, the wider the swing; and quad with error=True promises six digits more than it has.
#
# The guess: nsum goes on until the digits asked for stand still, so a slow series is only slow. It extrapolates from the
# first some hundred members instead, and stops when two extrapolations agree, as they soon do where each member is nearly
# m times the one before. The sum for a swing of 179 degrees is short by a thirtieth, with no word. And near the top
# quad's own estimate of its error is smaller than the error by the factor of a million. Way out: ellipk, or agm.
#
#> nsum, 150 degrees:  digits that agree with ellipk: 15
#> nsum, 170 degrees:  digits that agree with ellipk: 9
#> nsum, 176 degrees:  digits that agree with ellipk: 4
#> nsum, 179 degrees:  digits that agree with ellipk: 1
#> quad, 1e-6 from the top: relative error 5e-12, promised below 1e-17
. "$(dirname "$0")/room.sh"
debian python3-mpmath=1.2.1-2
cat >"$room/run.py" <<'PY'
from mpmath import *
def ratio(m):
    return nsum(lambda n: (gamma(n + 0.5) / gamma(n + 1) / sqrt(pi))**2 * m**n, [0, inf]) * pi / 2 / ellipk(m)
for zeta in (150, 170, 176, 179):
    wrong = abs(ratio(sin(zeta * pi / 360)**2) - 1)
    print('nsum, %d degrees:  digits that agree with ellipk: %d' % (zeta, 15 if wrong < 1e-15 else floor(-log10(wrong))))
m = 1 - mpf('1e-12')
value, promised = quad(lambda s: 1 / sqrt(1 - m * sin(s)**2), [0, pi / 2], error=True)
print('quad, 1e-6 from the top: relative error %.0e, promised %s' %
      (abs(value / ellipk(m) - 1), 'below 1e-17' if promised < 1e-17 else 'as it is'))
PY
in_room /usr/bin/python3 run.py >"$room/seen"
as_seen "$room/seen"
