#!/bin/sh
# cannon-es 0.20.0 (npm): a ball rolls down a slope like a hollow one, and a rod's moments of inertia depend on how it lay when
# it was made.
#
# The guess: a Sphere of mass m and radius r has the moment 2/5 m r^2, so that it rolls with 5/7 of g sin(slope). The shape knows
# the formula, and the body does not ask for it: it has the moments of the box about it, for a ball 2/3 m r^2, and rolls with 3/5. That
# box has its sides along the axes of the world, but its moments are given to the body's own axes: a thin rod that is made at 45
# degrees has thirty times the moment about its length that it has when it is made along an axis, and a fifth more across, for
# good. Way out: set inertia and invInertia, and call updateInertiaWorld(true).
#
#> a ball's moment: of its shape 0.400, of its body 0.667
#> a ball rolls down with 0.600 g sin(slope), slipping by less than 1e-5
#> with the shape's moment it rolls with 0.714 g sin(slope), slipping by less than 1e-5
#> a rod's moment about its length and across, made at  0 degrees: 0.0067 0.3367
#> a rod's moment about its length and across, made at 30 degrees: 0.1180 0.3944
#> a rod's moment about its length and across, made at 45 degrees: 0.2050 0.4033
. "$(dirname "$0")/room.sh"
npm_packages cannon-es@0.20.0
cat >"$room/ask.mjs" <<'J'
import { Body, Box, Plane, Quaternion, Sphere, Vec3, World } from 'cannon-es';
const own = new Vec3();
new Sphere(1).calculateLocalInertia(1, own);
const [g, slope, dt] = [9.81, 0.2, 1 / 60];
const roll = (moment) => {
  const world = new World({ gravity: new Vec3(g * Math.sin(slope), -g * Math.cos(slope), 0) });
  world.solver.iterations = 50;
  world.defaultContactMaterial.friction = 1;
  world.defaultContactMaterial.restitution = 0;
  const plane = new Body({ mass: 0, shape: new Plane() });
  plane.quaternion.setFromEuler(-Math.PI / 2, 0, 0);
  const shape = new Sphere(1);
  const ball = new Body({ mass: 1, shape, position: new Vec3(0, 1, 0), linearDamping: 0, angularDamping: 0 });
  const given = ball.inertia.x;
  if (moment) {
    ball.inertia.set(moment, moment, moment);
    ball.invInertia.set(1 / moment, 1 / moment, 1 / moment);
    ball.updateInertiaWorld(true);
  }
  world.addBody(plane);
  world.addBody(ball);
  const speed = (steps) => {
    for (let i = 0; i < steps; i++) world.step(dt);
    return ball.velocity.x;
  };
  const rate = (-speed(60) + speed(120)) / (120 * dt) / (g * Math.sin(slope));
  const slip = Math.abs(ball.velocity.x + ball.angularVelocity.z);
  return { given, told: `with ${rate.toFixed(3)} g sin(slope), slipping by ${slip < 1e-5 ? 'less than 1e-5' : slip}` };
};
const { given, told } = roll();
console.log(`a ball's moment: of its shape ${own.x.toFixed(3)}, of its body ${given.toFixed(3)}`);
console.log(`a ball rolls down ${told}`);
console.log(`with the shape's moment it rolls ${roll(own.x).told}`);
for (const degrees of [0, 30, 45]) {
  const quaternion = new Quaternion();
  quaternion.setFromAxisAngle(new Vec3(0, 0, 1), (degrees * Math.PI) / 180);
  const { inertia } = new Body({ mass: 1, shape: new Box(new Vec3(1, 0.1, 0.1)), quaternion });
  const [along, across] = [inertia.x, inertia.z].map((moment) => moment.toFixed(4));
  console.log(`a rod's moment about its length and across, made at ${`${degrees}`.padStart(2)} degrees: ${along} ${across}`);
}
J
(cd "$room" && node ask.mjs) >"$room/seen"
as_seen "$room/seen"
