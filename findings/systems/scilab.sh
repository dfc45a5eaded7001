#!/bin/sh
# Scilab's elliptic functions, asked for the pendulum near the top. delip takes the sine of the amplitude and k,
# %k takes m. Seen: book/systems/scilab.json.
. "$(dirname "$0")/question.sh"
debian scilab-cli=6.1.1+dfsg2-6
cat >"$room/asked" <<'ASKED'
system Scilab
version 6.1.1
from Debian scilab-cli 6.1.1+dfsg2-6
K.call delip(1, k)
am.call amell(u, k)
T.1 2/%pi · delip(1, cos(eta/2))
T.2 2/%pi · %k(cos(eta/2)^2), which takes m
Phi.1 2 asin(k·sn), [sn, cn, dn] = ellipj(u, m)
Phi.2 2 atan(k·sn, dn), the same
ASKED
cat >"$room/ask.sce" <<S
function say(key, x), mprintf("%s%s\n", key, strcat(msprintf(" %.17g\n", x'))), endfunction
eta = [$(list , $eta)]; u = [$(list , $u)]; k = cos(eta / 2);
say("K.quarter", delip(1, 0.25));
say("K.one", delip(1, 1));
try, say("K.beyond", delip(1, 1.5)), catch, mprintf("K.beyond error: %s\n", strsubst(lasterror(), ascii(10), " ")), end
say("am.ten", amell(10, 0.25));
say("am.one", amell(2, 1));
try, say("am.beyond", amell(1, 1.5)), catch, mprintf("am.beyond error: %s\n", strsubst(lasterror(), ascii(10), " ")), end
t1 = []; t2 = []; sn = []; dn = [];
for i = 1:3
  t1(i) = 2/%pi * delip(1, k(i));
  t2(i) = 2/%pi * real(%k(k(i)^2));
  [s, c, d] = ellipj(u(i), k(i)^2);
  sn(i) = s; dn(i) = d;
end
say("T.1", t1');
say("T.2", t2');
say("Phi.1", 2 * asin(k .* sn'));
say("Phi.2", 2 * atan(k .* sn', dn'));
exit
S
in_room scilab-cli -nb -f ask.sce </dev/null >"$room/log" 2>&1
grep -E '^(K|Pi|am|T|Phi)\.' "$room/log" >"$room/said" || cat "$room/log" >&2
as_recorded scilab
