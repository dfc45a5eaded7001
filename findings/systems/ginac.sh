#!/bin/sh
# GiNaC's complete elliptic integrals at 17 and at 50 digits, asked for the pendulum near the top. They take the
# modulus and are asked below one only. Seen: book/systems/ginac.json.
. "$(dirname "$0")/question.sh"
debian ginac-tools=1.8.6-1
cat >"$room/asked" <<'ASKED'
system GiNaC
version 1.8.6
from Debian ginac-tools 1.8.6-1
K.call EllipticK(k)
T.1 2/Pi · EllipticK(cos(eta/2)), Digits = 17
T.2 the same, Digits = 50
ASKED
ask() { printf '%s\n' "$@" | in_room ginsh | sed '/^[0-9][0-9]$/d'; }
{
  echo "K.quarter $(ask 'EllipticK(0.25);')"
  echo "T.1 $(for x in 0.017453292519943295 0.0001; do ask "evalf(2/Pi*EllipticK(cos($x/2)));"; done | tr '\n' ' ') not_asked"
  echo "T.2 $(for x in $eta; do ask 'Digits=50;' "evalf(2/Pi*EllipticK(cos($(printf '%.21f' "$x")/2)));" | cut -c 1-22; done | tr '\n' ' ')"
} >"$room/said"
as_recorded ginac
