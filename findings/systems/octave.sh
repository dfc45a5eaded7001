#!/bin/sh
# Octave's elliptic functions, asked for the pendulum near the top. Seen: book/systems/octave.json.
. "$(dirname "$0")/question.sh"
debian octave=7.3.0-2
cat >"$room/asked" <<'ASKED'
system Octave
version 7.3.0
from Debian octave 7.3.0-2
K.call ellipke(m)
T.1 2/pi · ellipke(cos(eta/2)^2)
Phi.1 2 asin(k·sn), [sn, cn, dn] = ellipj(u, m)
Phi.2 2 atan2(k·sn, dn), the same
ASKED
cat >"$room/ask.m" <<M
1;
function say(key, x), printf("%s %s\n", key, strjoin(arrayfun(@(a) sprintf("%.17g", a), x, "UniformOutput", false))); end
eta = [$eta]; u = [$u]; k = cos(eta / 2);
say("K.quarter", ellipke(0.25));
say("K.one", ellipke(1));
try, say("K.beyond", ellipke(1.5)); catch e, printf("K.beyond error: %s\n", e.message); end
say("T.1", 2/pi * ellipke(k.^2));
[sn, cn, dn] = ellipj(u, k.^2);
say("Phi.1", 2 * asin(k .* sn));
say("Phi.2", 2 * atan2(k .* sn, dn));
M
in_room octave-cli --quiet ask.m >"$room/said" 2>"$room/errors" || cat "$room/errors" >&2
as_recorded octave
