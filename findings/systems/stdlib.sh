#!/bin/sh
# The elliptic functions of @stdlib (npm), asked for the pendulum near the top. Seen: book/systems/stdlib.json.
. "$(dirname "$0")/question.sh"
npm_packages @stdlib/math-base-special-ellipk@0.2.4 @stdlib/math-base-special-ellipj@0.4.1
cat >"$room/asked" <<'ASKED'
system @stdlib
version 0.4.1
from npm @stdlib/math-base-special-ellipj 0.4.1
K.call ellipk(m)
am.call ellipj(u, m)[3]
T.1 2/pi · ellipk(cos(eta/2)**2)
Phi.1 2 asin(k·sn), [sn, cn, dn, am] = ellipj(u, m)
Phi.2 2 atan2(k·sn, dn), the same
ASKED
cat >"$room/ask.cjs" <<J
const ellipk = require('@stdlib/math-base-special-ellipk');
const ellipj = require('@stdlib/math-base-special-ellipj');
const say = (key, ...x) => console.log(key, ...x.map(String));
const [eta, u] = [[$(list , $eta)], [$(list , $u)]];
const k = eta.map((x) => Math.cos(x / 2));
say('K.quarter', ellipk(0.25));
say('K.one', ellipk(1));
say('K.beyond', ellipk(1.5));
say('am.ten', ellipj(10, 0.25)[3]);
say('am.one', ellipj(2, 1)[3]);
say('am.beyond', ellipj(1, 1.5)[3]);
say('T.1', ...k.map((x) => (2 / Math.PI) * ellipk(x * x)));
const jacobi = k.map((x, i) => ellipj(u[i], x * x));
say('Phi.1', ...k.map((x, i) => 2 * Math.asin(x * jacobi[i][0])));
say('Phi.2', ...k.map((x, i) => 2 * Math.atan2(x * jacobi[i][0], jacobi[i][2])));
J
(cd "$room" && node ask.cjs) >"$room/said"
as_recorded stdlib
