#!/bin/sh
# FriCAS' elliptic functions at its usual 20 digits and at 50, asked for the pendulum near the top. Seen:
# book/systems/fricas.json.
. "$(dirname "$0")/question.sh"
debian fricas=1.3.8-6
eta=$(echo "$eta" | sed 's/1e/1.0e/g') # 1e-4 alone is no number here
cat >"$room/asked" <<'ASKED'
system FriCAS
version 1.3.8
from Debian fricas 1.3.8-6
K.call ellipticK(m)
Pi.call ellipticPi(z, n, m), z: DoubleFloat
T.1 2/%pi · ellipticK(cos(eta/2)^2)
T.2 the same, digits(50)
T.3 2/%pi · ellipticRF(0, sin(eta/2)^2, 1)
Phi.1 2 asin(k·jacobiSn(u, m))
Phi.2 the same, digits(50)
ASKED
# ask EXPRESSION ...: the values of the expressions, one a line; what FriCAS refuses is "error: ...".
ask() {
  in_room fricas -nosman -eval 'digits(20)' "$@" </dev/null |
    sed -n 's/^ *([0-9]*) *\([-0-9][0-9._E ]*\)$/\1/p; s/^ *ellipticK : /error: /p' | tr -d '_ ' | sed 's/^error:/error: /' |
    grep -v -x -e 20 -e 50
}
{
  echo "K.quarter $(ask -eval 'ellipticK(0.25)')"
  echo "K.one $(ask -eval 'ellipticK(1.0)')"
  echo "K.beyond $(ask -eval 'ellipticK(1.5)')"
  echo "Pi.quarter $(ask -eval 'ellipticPi(1::DoubleFloat, 0.25::DoubleFloat, 0.25::DoubleFloat)')"
  echo "T.1 $(for x in $eta; do ask -eval "2/%pi*ellipticK(cos($x/2)^2)"; done | tr '\n' ' ')"
  echo "T.2 $(for x in $eta; do ask -eval 'digits(50)' -eval "2/%pi*ellipticK(cos($x/2)^2)" | cut -c 1-22; done | tr '\n' ' ')"
  echo "T.3 $(for x in $eta; do ask -eval "2/%pi*ellipticRF(0.0, sin($x/2)^2, 1.0)"; done | tr '\n' ' ')"
  set -- $u
  echo "Phi.1 $(for x in $eta; do ask -eval "2*asin(cos($x/2)*jacobiSn($1, cos($x/2)^2))"; shift; done | tr '\n' ' ')"
  set -- $u
  echo "Phi.2 $(for x in $eta; do ask -eval 'digits(50)' -eval "2*asin(cos($x/2)*jacobiSn($1, cos($x/2)^2))" | cut -c 1-22; shift; done | tr '\n' ' ')"
} >"$room/said"
as_recorded fricas
