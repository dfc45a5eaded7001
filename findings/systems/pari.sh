#!/bin/sh
# PARI's complete elliptic integrals at the usual 38 digits, asked for the pendulum near the top. It has neither
# the third kind nor Jacobi's functions, but 1/sn² is the x of a point of the curve y² = x (x - 1) (x - m), and that
# it gives at any time u. Seen: book/systems/pari.json.
. "$(dirname "$0")/question.sh"
debian pari-gp=2.15.2-1
cat >"$room/asked" <<'ASKED'
system PARI
version 2.15.2
from Debian pari-gp 2.15.2-1
K.call ellK(k)
T.1 2/Pi · ellK(cos(eta/2))
T.2 1/agm(1, sin(eta/2))
Phi.1 2 asin(k/sqrt(x)), x = ellztopoint(ellinit([0, -1 - m, 0, m, 0]), u)[1]
ASKED
cat >"$room/run.gp" <<GP
say(key, x) = { print1(key); for(i = 1, #x, print1(" ", strprintf("%.20g", x[i]))); print(); }
swings = [$(list , $eta)];
say("K.quarter", [ellK(0.25)]);
iferr(say("K.one", [ellK(1)]), e, print("K.one error: ", e));
z = ellK(1.5); print("K.beyond ", strprintf("%.17g", real(z)), if(imag(z) < 0, " - ", " + "), strprintf("%.17g", abs(imag(z))), "i");
say("T.1", [2/Pi * ellK(cos(x/2)) | x <- swings]);
times = [$(list , $u)];
angle(eta, u) = { my(k = cos(eta/2), m = k^2); 2*asin(k/sqrt(real(ellztopoint(ellinit([0, -1 - m, 0, m, 0]), u)[1]))); }
say("T.2", [1/agm(1, sin(x/2)) | x <- swings]);
say("Phi.1", vector(3, i, angle(swings[i], times[i])));
GP
in_room gp --quiet --fast run.gp </dev/null >"$room/said"
as_recorded pari
