#!/bin/sh
# gnuplot's complete elliptic integrals, asked for the pendulum near the top; its own print shows 15 digits, so the
# answers are printed by sprintf. Seen: book/systems/gnuplot.json.
. "$(dirname "$0")/question.sh"
debian gnuplot-nox=5.4.4+dfsg1-2+b2
cat >"$room/asked" <<'ASKED'
system gnuplot
version 5.4.4
from Debian gnuplot-nox 5.4.4+dfsg1-2+b2
K.call EllipticK(k)
Pi.call EllipticPi(n, k)
T.1 2/pi · EllipticK(cos(eta/2))
ASKED
cat >"$room/ask.gp" <<'G'
period(eta) = 2/pi * EllipticK(cos(eta/2.))
G
ask() { in_room gnuplot -e 'load "ask.gp"' -e "print $1" 2>&1 | sed '/^$/d; s/^line [0-9]*: /error: /; /^ *^$/d; /^print/d'; }
{
  ask 'sprintf("K.quarter %.17g", EllipticK(0.25))'
  echo "K.one $(ask 'EllipticK(1)')"
  echo "K.beyond $(ask 'EllipticK(1.5)')"
  ask 'sprintf("Pi.quarter %.17g", EllipticPi(0.25, 0.25))'
  echo "T.1 $(for x in $eta; do ask "sprintf(\"%.17g\", period($x))" | tr ' ' _; done | tr '\n' ' ')"
} >"$room/said"
as_recorded gnuplot
