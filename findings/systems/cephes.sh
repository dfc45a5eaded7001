#!/bin/sh
# The Cephes library as compiled for npm, asked for the pendulum near the top: ellpk takes 1 - m, the others m.
# Seen: book/systems/cephes.json.
. "$(dirname "$0")/question.sh"
npm_packages cephes@3.3.3
cat >"$room/asked" <<'ASKED'
system Cephes
version 3.3.3
from npm cephes 3.3.3
K.call ellpk(m1)
am.call ellpj(u, m)[1].ph
T.1 2/pi · ellpk(1 - cos(eta/2)**2)
T.2 2/pi · ellpk(sin(eta/2)**2)
Phi.1 2 asin(k·sn), [ret, {sn, cn, dn, ph}] = ellpj(u, m)
Phi.2 2 atan2(k·sn, dn), the same
ASKED
cat >"$room/ask.cjs" <<J
const cephes = require('cephes');
const say = (key, ...x) => console.log(key, ...x.map(String));
const safely = (f) => {
  try {
    return f();
  } catch (error) {
    return ('error: ' + error.message).replace(/cephes reports |"/g, '').replace(/ /g, '_');
  }
};
const [eta, u] = [[$(list , $eta)], [$(list , $u)]];
const k = eta.map((x) => Math.cos(x / 2));
const jacobi = k.map((x, i) => cephes.ellpj(u[i], x * x)[1]);
cephes.compiled.then(() => {
  say('K.quarter', cephes.ellpk(0.25));
  say('K.one', safely(() => cephes.ellpk(0)));
  say('K.beyond', safely(() => cephes.ellpk(-0.5)));
  say('am.ten', cephes.ellpj(10, 0.25)[1].ph);
  say('am.one', safely(() => cephes.ellpj(2, 1)[1].ph));
  say('am.beyond', safely(() => cephes.ellpj(1, 1.5)[1].ph));
  say('T.1', ...k.map((x) => safely(() => (2 / Math.PI) * cephes.ellpk(1 - x * x))));
  say('T.2', ...eta.map((x) => (2 / Math.PI) * cephes.ellpk(Math.sin(x / 2) ** 2)));
  say('Phi.1', ...k.map((x, i) => 2 * Math.asin(x * jacobi[i].sn)));
  say('Phi.2', ...k.map((x, i) => 2 * Math.atan2(x * jacobi[i].sn, jacobi[i].dn)));
});
J
(cd "$room" && node ask.cjs) >"$room/said"
as_recorded cephes
