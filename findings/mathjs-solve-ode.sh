#!/bin/sh
# mathjs 15.2.0 (npm): solveODE compares its tolerance with a difference of rates, not of states, so that the answer depends on the
# unit of time: a pendulum asked in milliseconds is wrong altogether, and in microseconds it is done in one step.
#
# The guess: the error estimate that the solver keeps below tol, as its manual says, is that of a step, whatever the unit of time. It
# is the difference of the two rules before it is multiplied by the step, an error per unit of time. Milliseconds, the
# usual unit in JavaScript, make it a thousand times coarser, and the first step tried is the whole interval, which is taken at
# once where all rates are small numbers. A pendulum let go at 1.5 is at 5.7 then, or at -488.6, without a word. Way out: a unit of
# time in which the rates are about one; maxStep.
#
#> true:                       -0.3928
#> minutes, tol 0.0001:        -0.3928, steps: 485
#> minutes, tol 0.000001:      -0.3928, steps: 1533
#> seconds, tol 0.0001:        -0.3930, steps: 82
#> seconds, tol 0.000001:      -0.3928, steps: 224
#> milliseconds, tol 0.0001:   5.6925, steps: 3
#> milliseconds, tol 0.000001: -0.4281, steps: 35
#> microseconds, tol 0.0001:   -488.6093, steps: 1
#> microseconds, tol 0.000001: -488.6093, steps: 1
#> milliseconds, maxStep 50:   -0.3928, steps: 200
. "$(dirname "$0")/room.sh"
npm_packages mathjs@15.2.0
cat >"$room/ask.mjs" <<'J'
import { solveODE } from 'mathjs';
// A pendulum of a metre, let go at 1.5, after ten seconds; s of the unit of time make a second.
const after = (s, options) => {
  const rates = (t, [angle, speed]) => [speed, (-9.81 / s ** 2) * Math.sin(angle)];
  const { t, y } = solveODE(rates, [0, 10 * s], [1.5, 0], options);
  return `${y.at(-1)[0].toFixed(4)}, steps: ${t.length - 1}`;
};
console.log('true:'.padEnd(27), after(1, { tol: 1e-11, maxIter: 1e6 }).split(',')[0]);
for (const [name, s] of Object.entries({ minutes: 1 / 60, seconds: 1, milliseconds: 1e3, microseconds: 1e6 }))
  for (const tol of [1e-4, 1e-6]) console.log(`${name}, tol ${tol}:`.padEnd(27), after(s, { tol }));
console.log('milliseconds, maxStep 50:'.padEnd(27), after(1e3, { tol: 1e-6, maxStep: 50 }));
J
(cd "$room" && node ask.mjs) >"$room/seen"
as_seen "$room/seen"
