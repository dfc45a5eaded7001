#!/bin/sh
# SciPy's elliptic functions, asked for the pendulum near the top. Seen: book/systems/scipy.json.
. "$(dirname "$0")/question.sh"
debian python3-scipy=1.10.1-2
cat >"$room/asked" <<'ASKED'
system SciPy
version 1.10.1
from Debian python3-scipy 1.10.1-2
K.call ellipk(m)
am.call ellipj(u, m)[3]
T.1 2/pi · ellipk(cos(eta/2)**2)
T.2 2/pi · ellipkm1(sin(eta/2)**2)
Phi.1 2 arcsin(k·sn), sn, cn, dn, am = ellipj(u, m)
Phi.2 2 arctan2(k·sn, dn), the same
ASKED
cat >"$room/run.py" <<PY
import numpy as np
from scipy import special
def say(key, *x): print(key, *('%.17g' % a for a in x))
eta = np.array([$(list , $eta)]); u = np.array([$(list , $u)]); k = np.cos(eta / 2)
say('K.quarter', special.ellipk(.25))
say('K.one', special.ellipk(1))
say('K.beyond', special.ellipk(1.5))
say('am.ten', special.ellipj(10, .25)[3])
say('am.one', special.ellipj(2, 1)[3])
say('am.beyond', special.ellipj(1, 1.5)[3])
say('T.1', *2 / np.pi * special.ellipk(k**2))
say('T.2', *2 / np.pi * special.ellipkm1(np.sin(eta / 2)**2))
sn, cn, dn, am = special.ellipj(u, k**2)
say('Phi.1', *2 * np.arcsin(k * sn))
say('Phi.2', *2 * np.arctan2(k * sn, dn))
PY
in_room /usr/bin/python3 run.py >"$room/said"
as_recorded scipy
