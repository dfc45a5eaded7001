#!/bin/sh
# planck 1.5.0 (npm; Box2D has the same rules): more iterations do not keep a pendulum swinging, the moment of inertia is about a
# body's origin, and a pendulum of a kilometre goes slow.
#
# The guess: step(dt, velocityIterations, positionIterations) is more exact with more of them. One joint is solved by the first; what
# is lost is lost by the step, and goes with its length. In the mass data I is about the origin of the body, in Rapier,
# Bullet and ODE about the centre of gravity: a loaded ball given 0.2 about its centre, which is at the distance 1/2, has
# less than none, and swings up. And no body moves by more than two metres a step: at sixty steps a second that is 120 m/s, which a
# pendulum of 734 m has when it falls from the side.
#
#> after a minute, of 90 degrees: 1 iteration 29.8, 8 iterations 29.8, 1000 iterations 29.8
#> after a minute, of 90 degrees: 120 steps a second 40.2, 960 steps 74.0
#> I = 0.2 given, centre at 1/2: about the centre -0.05
#> quarter period over the true one: 500 m 1.000, 1000 m 1.033, 2000 m 1.221
. "$(dirname "$0")/room.sh"
npm_packages planck@1.5.0
cat >"$room/ask.mjs" <<'J'
import * as planck from 'planck';
const g = 9.81;
function pendulum(length) {
  const world = new planck.World({ gravity: { x: 0, y: -g } });
  const bob = world.createDynamicBody({ position: { x: length, y: 0 }, allowSleep: false });
  bob.setMassData({ mass: 1, I: 0.005, center: { x: 0, y: 0 } });
  world.createJoint(new planck.RevoluteJoint({}, world.createBody(), bob, { x: 0, y: 0 }));
  return { world, angle: () => Math.atan2(bob.getPosition().x, -bob.getPosition().y) };
}
function left(rate, iterations) {
  const { world, angle } = pendulum(1);
  let largest = 0;
  for (let i = 0; i < 60 * rate; ++i) {
    world.step(1 / rate, iterations, iterations);
    if (i >= 55 * rate) largest = Math.max(largest, Math.abs(angle()));
  }
  return ((largest * 180) / Math.PI).toFixed(1);
}
const times = (n) => `${n} iteration${n > 1 ? 's' : ''} ${left(60, n)}`;
console.log(`after a minute, of 90 degrees: ${[1, 8, 1000].map(times).join(', ')}`);
console.log(`after a minute, of 90 degrees: 120 steps a second ${left(120, 8)}, 960 steps ${left(960, 8)}`);
const ball = new planck.World().createDynamicBody();
ball.setMassData({ mass: 1, I: 0.2, center: { x: 0, y: -0.5 } });
console.log(`I = 0.2 given, centre at 1/2: about the centre ${(ball.getInertia() - ball.getMass() * 0.25).toFixed(2)}`);
const quarter = (length) => {
  const { world, angle } = pendulum(length);
  let steps = 0;
  do {
    world.step(1 / 60);
    ++steps;
  } while (angle() > 0);
  return `${length} m ${(steps / 60 / (1.8540746773 * Math.sqrt(length / g))).toFixed(3)}`;
};
console.log(`quarter period over the true one: ${[500, 1000, 2000].map(quarter).join(', ')}`);
J
(cd "$room" && node ask.mjs) >"$room/seen"
as_seen "$room/seen"
