#!/bin/sh
# mpmath's elliptic functions at its usual 15 digits, asked for the pendulum near the top, and with 50 digits for
# the modulus. Seen: book/systems/mpmath.json.
. "$(dirname "$0")/question.sh"
debian python3-mpmath=1.2.1-2
cat >"$room/asked" <<'ASKED'
system mpmath
version 1.2.1
from Debian python3-mpmath 1.2.1-2
K.call ellipk(m)
Pi.call ellippi(n, m)
T.1 2/pi · ellipk(cos(eta/2)**2), mp.dps = 15
T.2 2/pi · ellipk(cos(eta/2)**2), mp.dps = 50
Phi.1 2 asin(k·sn), sn = ellipfun('sn', u, m=k**2), mp.dps = 15
Phi.2 the same, mp.dps = 50
ASKED
cat >"$room/run.py" <<PY
from mpmath import *
def say(key, *x): print(key, *(nstr(a, 17).replace(' ', '') for a in x))
swings = list(zip([$(list , $eta)], [$(list , $u)]))
def period(eta): return 2 / pi * ellipk(cos(mpf(eta) / 2)**2)
def angle(eta, u):
    k = cos(mpf(eta) / 2)
    return 2 * asin(k * ellipfun('sn', u, m=k**2))
say('K.quarter', ellipk(.25))
say('K.one', ellipk(1))
say('K.beyond', ellipk(1.5))
say('Pi.quarter', ellippi(.25, .25))
say('T.1', *(period(eta) for eta, u in swings))
say('Phi.1', *(angle(eta, u) for eta, u in swings))
mp.dps = 50
say('T.2', *(period(eta) for eta, u in swings))
say('Phi.2', *(angle(eta, u) for eta, u in swings))
PY
in_room /usr/bin/python3 run.py >"$room/said"
as_recorded mpmath
