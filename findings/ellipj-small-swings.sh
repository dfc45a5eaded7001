#!/bin/sh
# Jacobi's functions of a pendulum that hardly swings, after a long time, in SciPy 1.10.1 (Debian python3-scipy 1.10.1-2),
# Cephes (npm cephes 3.3.3) and Boost.Math 1.81 (Debian libboost1.81-dev 1.81.0-5+deb12u1): the digits go, and sn² + cn² is
# not one.
#
# The guess: with m = 9e-10, a swing of 0.0034 degrees, sn is the sine to nine digits, and nothing can go wrong. For so small an m
# the three take the first member in m of a series that has the *time* beside it: it is m u that ought to be small. A
# pendulum that beats seconds has u = 1e7 after 37 days. What is asked for is hardly worse conditioned than the sine of u; @stdlib's
# ellipj (npm, 0.4.1), which has no such short cut, is right. Way out: take whole periods 4K from u first.
#
#> SciPy:  m = 9e-10:   sn² + cn² - 1 at u = 1e5, 1e7, 1e9: 5e-10 5e-06 5e-02
#> SciPy:  m = 1.1e-9:  sn² + cn² - 1 at u = 1e5, 1e7, 1e9: below 1e-15, all
#> SciPy:  m = 9e-10, u = 1e9: sn is off by 1e-02
#> Cephes: m = 9e-10:   sn² + cn² - 1 at u = 1e5, 1e7, 1e9: 5e-10 5e-06 5e-02
#> @stdlib: m = 9e-10:  sn² + cn² - 1 at u = 1e5, 1e7, 1e9: below 1e-15, all
#> Boost:  m = 1e-10:   sn² + cn² - 1 at u = 1e5, 1e7, 1e9: 6e-12 6e-08 6e-04
. "$(dirname "$0")/room.sh"
debian python3-scipy=1.10.1-2 python3-mpmath=1.2.1-2
debian libboost1.81-dev=1.81.0-5+deb12u1
npm_packages cephes@3.3.3 @stdlib/math-base-special-ellipj@0.4.1
cat >"$room/run.py" <<'PY'
import mpmath
from scipy.special import ellipj
def circle(m):
    off = [abs(sn**2 + cn**2 - 1) for sn, cn, dn, am in (ellipj(u, m) for u in (1e5, 1e7, 1e9))]
    return 'below 1e-15, all' if max(off) < 1e-15 else ' '.join('%.0e' % x for x in off)
print('SciPy:  m = 9e-10:   sn² + cn² - 1 at u = 1e5, 1e7, 1e9:', circle(9e-10))
print('SciPy:  m = 1.1e-9:  sn² + cn² - 1 at u = 1e5, 1e7, 1e9:', circle(1.1e-9))
mpmath.mp.dps = 50
period = 4 * mpmath.ellipk(mpmath.mpf(9e-10))
sn = mpmath.ellipfun('sn', mpmath.mpf(1e9) % period, m=mpmath.mpf(9e-10))
print('SciPy:  m = 9e-10, u = 1e9: sn is off by %.0e' % abs(ellipj(1e9, 9e-10)[0] - float(sn)))
PY
cat >"$room/ask.cjs" <<'J'
const cephes = require('cephes');
const ellipj = require('@stdlib/math-base-special-ellipj');
const tell = (name, functions) => {
  const off = [1e5, 1e7, 1e9].map((u) => functions(u)).map(([sn, cn]) => Math.abs(sn * sn + cn * cn - 1));
  const shown = off.map((x) => x.toExponential(0).replace(/-(\d)$/, '-0$1')).join(' ');
  console.log(`${name} sn² + cn² - 1 at u = 1e5, 1e7, 1e9: ${Math.max(...off) < 1e-15 ? 'below 1e-15, all' : shown}`);
};
cephes.compiled.then(() => {
  tell('Cephes: m = 9e-10:  ', (u) => {
    const [, { sn, cn }] = cephes.ellpj(u, 9e-10);
    return [sn, cn];
  });
  tell('@stdlib: m = 9e-10: ', (u) => ellipj(u, 9e-10));
});
J
cat >"$room/ask.cpp" <<'C'
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cstdio>
int main()
{
  std::printf("Boost:  m = 1e-10:   sn² + cn² - 1 at u = 1e5, 1e7, 1e9:");
  for(const double u : {1e5, 1e7, 1e9})
  {
    double cn = 0, dn = 0;
    const double sn = boost::math::jacobi_elliptic(1e-5, u, &cn, &dn);
    std::printf(" %.0e", std::abs(sn * sn + cn * cn - 1));
  }
  std::puts("");
}
C
in_room c++ -std=c++17 -O1 -w ask.cpp -o ask
{
  in_room /usr/bin/python3 run.py
  (cd "$room" && node ask.cjs)
  "$room/ask"
} >"$room/seen"
as_seen "$room/seen"
