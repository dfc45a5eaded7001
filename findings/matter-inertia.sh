#!/bin/sh
# matter-js 0.20.0 (npm): every body has four times its moment of inertia, so that a rod hinged at its end takes a third longer for
# a swing.
#
# The guess: a body's inertia, which the documentation calls its moment of inertia and which is there to be read and set, is that
# of its shape and mass. It is four times that, by a factor inside the library, and setMass and setDensity keep the factor. A
# pendulum that is a small bob on a long constraint hardly shows it, as the bob's own moment hardly counts; a rod, whatever rolls
# and a loaded ball do. Way out: Body.setInertia(body, body.inertia / 4) once the mass is set.
#
#> inertia over that of the formula: rectangle 4.000, disc of 200 corners 3.997
#> a rod hinged at its end, period over the true one: 1.323 as made (root of 7/4: 1.323), 1.000 with a quarter of its inertia
. "$(dirname "$0")/room.sh"
npm_packages matter-js@0.20.0
cat >"$room/ask.mjs" <<'J'
import Matter from 'matter-js';
const { Bodies, Body, Composite, Constraint, Engine } = Matter;
const length = 200;
const disc = () => Bodies.circle(0, 0, 100, { friction: 1, frictionStatic: 10, frictionAir: 0, restitution: 0 }, 200);
const rod = () => Bodies.rectangle(0, length / 2, 1, length, { frictionAir: 0 });
const ratios = [
  [rod(), (length ** 2 + 1) / 12],
  [disc(), 100 ** 2 / 2],
].map(([body, moment]) => (body.inertia / body.mass / moment).toFixed(3));
console.log(`inertia over that of the formula: rectangle ${ratios[0]}, disc of 200 corners ${ratios[1]}`);
const quarter = (body) => Body.setInertia(body, body.inertia / 4);
// Gravity is 0.001 of a length per square millisecond.
const period = (change) => {
  const [engine, body, swing, dt] = [Engine.create(), rod(), 0.05, 1000 / 480];
  change(body);
  const [x, y] = [(Math.sin(swing) * length) / 2, (Math.cos(swing) * length) / 2];
  Body.setAngle(body, swing);
  Body.setPosition(body, { x: -x, y });
  const hinge = { pointA: { x: 0, y: 0 }, bodyB: body, pointB: { x, y: -y }, length: 0, stiffness: 1 };
  Composite.add(engine.world, [body, Constraint.create(hinge)]);
  const passed = [];
  let before = body.position.x;
  for (let n = 0; passed.length < 5; n++) {
    Engine.update(engine, dt);
    const now = body.position.x;
    if (before < 0 && now >= 0) passed.push((n + 1 - now / (now - before)) * dt);
    before = now;
  }
  const formula = 2 * Math.PI * Math.sqrt((length ** 2 / 3 + 1 / 12) / ((0.001 * length) / 2));
  return ((passed[4] - passed[0]) / 4 / (formula * (1 + swing ** 2 / 16))).toFixed(3);
};
console.log(
  `a rod hinged at its end, period over the true one: ${period(() => {})} as made (root of 7/4: ` +
    `${Math.sqrt(7 / 4).toFixed(3)}), ${period(quarter)} with a quarter of its inertia`,
);
J
(cd "$room" && node ask.mjs) >"$room/seen"
as_seen "$room/seen"
