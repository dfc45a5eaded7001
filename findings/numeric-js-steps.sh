#!/bin/sh
# numeric 1.2.6 (npm): dopri stops after a thousand steps, says nothing, and answers for any later time all the same; and
# its event is the way up only.
#
# The guess: asked for a pendulum from 0 to 100 with 1e-10, it follows it to 100, or throws. It breaks off at 43; the
# message stays undefined; sol.at(100) continues the last step's polynomial to half a million radians. And an event
# "angle nought" of a pendulum that is let go on the right is not its first passage, which is downwards, but the second.
# Way out: a sixth argument, the number of steps, compare the last of sol.x with what was asked for, and both signs of an event.
#
#> asked for 100, reached 43.4, message undefined, angle at 100: 585872
#> first passage at K = 1.854; the event is at 3.000 K
. "$(dirname "$0")/room.sh"
npm_packages numeric@1.2.6
cat >"$room/ask.mjs" <<'J'
import numeric from 'numeric';
const K = 1.8540746773013719;
const pendulum = (t, [angle, rate]) => [rate, -Math.sin(angle)];
const start = [Math.PI / 2, 0];
const long = numeric.dopri(0, 100, start, pendulum, 1e-10);
console.log(
  `asked for 100, reached ${long.x.at(-1).toFixed(1)}, message ${long.msg}, angle at 100: ${long.at(100)[0].toFixed(0)}`,
);
const stopped = numeric.dopri(0, 20, start, pendulum, 1e-10, 5000, (t, [angle]) => angle);
console.log(`first passage at K = ${K.toFixed(3)}; the event is at ${(stopped.x.at(-1) / K).toFixed(3)} K`);
J
(cd "$room" && node ask.mjs) >"$room/seen"
as_seen "$room/seen"
