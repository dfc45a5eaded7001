#!/bin/sh
# Maxima's elliptic functions in double precision and with 50 digits, asked for the pendulum near the top. Seen:
# book/systems/maxima.json.
. "$(dirname "$0")/question.sh"
debian maxima=5.46.0-11 maxima-share=5.46.0-11
cat >"$room/asked" <<'ASKED'
system Maxima
version 5.46.0
from Debian maxima 5.46.0-11
K.call elliptic_kc(m)
Pi.call elliptic_pi(n, phi, m)
am.call jacobi_am(u, m)
T.1 2/%pi · elliptic_kc(cos(eta/2)^2)
T.2 the same in bfloat, fpprec: 50
Phi.1 2 asin(k·jacobi_sn(u, m))
Phi.2 2 atan2(k·jacobi_sn(u, m), jacobi_dn(u, m))
ASKED
cat >"$room/ask.mac" <<M
fpprec: 50\$
fpprintprec: 20\$
display2d: false\$
tell(key, x) := printf(true, "~a~{ ~a~}~%", key, map(lambda([a], if bfloatp(a) then ssubst("e", "b", string(a)) else printf(false, "~,18,,,,,'ee", a)), x))\$
eta: [$(list , $eta)]\$
u: [$(list , $u)]\$
safely(f) := block([errormsg: false, a: errcatch(f())], if a = [] then "error" else a[1])\$
tell("K.quarter", [elliptic_kc(0.25)])\$
printf(true, "K.one ~a~%", safely(lambda([], elliptic_kc(1.0))))\$
printf(true, "K.beyond ~a~%", string(elliptic_kc(1.5)))\$
tell("Pi.quarter", [elliptic_pi(0.25, float(%pi/2), 0.25)])\$
tell("am.ten", [jacobi_am(10.0, 0.25)])\$
printf(true, "am.one ~a~%", safely(lambda([], jacobi_am(2.0, 1.0))))\$
printf(true, "am.beyond ~a~%", string(safely(lambda([], jacobi_am(1.0, 1.5)))))\$
at_swings(f) := map(lambda([e, t], f(e, t)), eta, u)\$
printf(true, "T.1~{ ~a~}~%", at_swings(lambda([e, t], block([a: safely(lambda([], float(2/%pi * elliptic_kc(cos(e/2)^2))))], if numberp(a) then printf(false, "~,17e", a) else a))))\$
tell("T.2", at_swings(lambda([e, t], bfloat(2/%pi) * elliptic_kc(cos(bfloat(e)/2)^2))))\$
tell("Phi.1", at_swings(lambda([e, t], 2 * asin(cos(e/2) * jacobi_sn(t, cos(e/2)^2)))))\$
tell("Phi.2", at_swings(lambda([e, t], 2 * atan2(cos(e/2) * jacobi_sn(t, cos(e/2)^2), jacobi_dn(t, cos(e/2)^2)))))\$
M
sed -i "s/printf(false, \"~,18,,,,,'ee\", a)/printf(false, \"~,17e\", a)/" "$room/ask.mac"
in_room maxima --very-quiet --batch ask.mac >"$room/log" 2>&1
grep -E '^(K|Pi|am|T|Phi)\.' "$room/log" >"$room/said" || cat "$room/log" >&2
cat "$room/log"; as_recorded maxima
