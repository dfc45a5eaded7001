#!/bin/sh
# PARI's complete elliptic integrals at the usual 38 digits, asked for the pendulum near the top. It has neither
# the third kind nor Jacobi's functions; those of time are had from its agm. Seen: book/systems/pari.json.
. "$(dirname "$0")/question.sh"
debian pari-gp=2.15.2-1
cat >"$room/asked" <<'ASKED'
system PARI
version 2.15.2
from Debian pari-gp 2.15.2-1
K.call ellK(k)
T.1 2/Pi · ellK(cos(eta/2))
T.2 1/agm(1, sin(eta/2))
ASKED
cat >"$room/run.gp" <<GP
say(key, x) = { print1(key); for(i = 1, #x, print1(" ", strprintf("%.20g", x[i]))); print(); }
swings = [$(list , $eta)];
say("K.quarter", [ellK(0.25)]);
iferr(say("K.one", [ellK(1)]), e, print("K.one error: ", e));
z = ellK(1.5); print("K.beyond ", strprintf("%.17g", real(z)), if(imag(z) < 0, " - ", " + "), strprintf("%.17g", abs(imag(z))), "i");
say("T.1", [2/Pi * ellK(cos(x/2)) | x <- swings]);
say("T.2", [1/agm(1, sin(x/2)) | x <- swings]);
GP
in_room gp --quiet --fast run.gp </dev/null >"$room/said"
as_recorded pari
