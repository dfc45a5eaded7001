#!/bin/sh
# Pendulum and loaded ball (see scene.sh) in the physics engines of npm. Matter.js counts in pixels and milliseconds:
# 100 pixels are the metre here. Seen: book/systems/engines-npm.json.
. "$(dirname "$0")/scene.sh"
npm_packages matter-js@0.20.0 planck@1.5.0 cannon-es@0.20.0 @dimforge/rapier2d-compat@0.21.0 p2-es@1.2.3
cat >"$room/ask.mjs" <<'J'
import Matter from 'matter-js';
import * as planck from 'planck';
import * as cannon from 'cannon-es';
import rapier from '@dimforge/rapier2d-compat';
import * as p2 from 'p2-es';

const [g, dt, tilt, offset, inertia] = [9.81, 1 / 60, 1.2, 0.5, 0.4];
const [sin, cos] = [Math.sin(tilt), Math.cos(tilt)];

// Steps a scene for a minute; angle() is its angle from the lowest place.
function watch(angle, step) {
  let [first, last, times, largest, before] = [0, 0, 0, 0, angle()];
  for (let i = 0; i < 3600; ++i) {
    step();
    const now = angle();
    if (before > 0 && now <= 0) {
      last = (i + before / (before - now)) * dt;
      if (times++ === 0) first = last;
    }
    if (i >= 3300) largest = Math.max(largest, Math.abs(now));
    before = now;
  }
  const rounded = (x, digits) => Number(x.toFixed(digits));
  return { period: rounded((last - first) / (times - 1), 4), amplitude: rounded((largest * 180) / Math.PI, 2) };
}
const tell = (engine, version, name, bob, pendulum, ball) =>
  console.log(JSON.stringify({ engine, version, from: `npm ${name} ${version}`, bob, pendulum, ball }));

{
  const pixels = 100;
  const engine = () => Matter.Engine.create({ gravity: { x: 0, y: 1, scale: (g * pixels) / 1e6 } });
  const swing = engine();
  const bob = Matter.Bodies.circle(pixels, 0, 0.1 * pixels, { frictionAir: 0 });
  const rod = Matter.Constraint.create({ pointA: { x: 0, y: 0 }, bodyB: bob, length: pixels, stiffness: 1 });
  Matter.Composite.add(swing.world, [bob, rod]);
  const pendulum = watch(
    () => Math.atan2(bob.position.x, bob.position.y),
    () => Matter.Engine.update(swing, 1000 * dt),
  );
  // A disc has 25 corners or so unless it is asked for more; its centre of gravity is set before it is turned.
  const level = engine();
  const floor = Matter.Bodies.rectangle(0, 50, 10000, 100, { isStatic: true, friction: 1 });
  const loaded = Matter.Bodies.circle(0, -pixels, pixels, { frictionAir: 0, friction: 1, frictionStatic: 10 }, 200);
  Matter.Body.setCentre(loaded, { x: 0, y: offset * pixels }, true);
  Matter.Body.setMass(loaded, 1);
  Matter.Body.setInertia(loaded, inertia * pixels * pixels);
  Matter.Body.rotate(loaded, -tilt, { x: 0, y: -pixels });
  Matter.Composite.add(level.world, [floor, loaded]);
  const ball = watch(
    () => -loaded.angle,
    () => Matter.Engine.update(level, 1000 * dt),
  );
  tell('Matter.js', '0.20.0', 'matter-js', 0, pendulum, ball);
}
{
  const body = (world, position, angle, radius, mass, I, centre) => {
    const b = world.createDynamicBody({ position, angle, allowSleep: false });
    b.createFixture({ shape: new planck.Circle({ x: 0, y: 0 }, radius), density: 1, friction: 1 });
    b.setMassData({ mass, I, center: centre });
    return b;
  };
  const swing = new planck.World({ gravity: { x: 0, y: -g } });
  const bob = body(swing, { x: 1, y: 0 }, 0, 0.1, 1, 0.005, { x: 0, y: 0 });
  swing.createJoint(new planck.RevoluteJoint({}, swing.createBody(), bob, { x: 0, y: 0 }));
  const pendulum = watch(
    () => Math.atan2(bob.getPosition().x, -bob.getPosition().y),
    () => swing.step(dt),
  );
  const level = new planck.World({ gravity: { x: 0, y: -g } });
  level.createBody().createFixture({ shape: new planck.Edge({ x: -50, y: 0 }, { x: 50, y: 0 }), friction: 1 });
  const loaded = body(level, { x: 0, y: 1 }, tilt, 1, 1, inertia + offset * offset, { x: 0, y: -offset });
  const ball = watch(
    () => loaded.getAngle(),
    () => level.step(dt),
  );
  tell('planck', '1.5.0', 'planck', 0.005, pendulum, ball);
}
{
  const undamped = { linearDamping: 0, angularDamping: 0 };
  const world = () => new cannon.World({ gravity: new cannon.Vec3(0, -g, 0) });
  const fixInertia = (body, I) => {
    body.inertia.set(I, I, I);
    body.invInertia.set(1 / I, 1 / I, 1 / I);
    body.updateInertiaWorld(true);
  };
  const swing = world();
  const axis = new cannon.Body({ mass: 0 });
  const bob = new cannon.Body({
    mass: 1,
    position: new cannon.Vec3(1, 0, 0),
    shape: new cannon.Sphere(0.1),
    ...undamped,
  });
  const z = new cannon.Vec3(0, 0, 1);
  swing.addBody(axis);
  swing.addBody(bob);
  swing.addConstraint(
    new cannon.HingeConstraint(axis, bob, { pivotB: new cannon.Vec3(-1, 0, 0), axisA: z, axisB: z }),
  );
  const pendulum = watch(
    () => Math.atan2(bob.position.x, -bob.position.y),
    () => swing.step(dt),
  );
  const level = world();
  level.defaultContactMaterial.friction = 1;
  const floor = new cannon.Body({ mass: 0, shape: new cannon.Plane() });
  floor.quaternion.setFromEuler(-Math.PI / 2, 0, 0);
  const loaded = new cannon.Body({
    mass: 1,
    position: new cannon.Vec3(offset * sin, 1 - offset * cos, 0),
    ...undamped,
  });
  loaded.addShape(new cannon.Sphere(1), new cannon.Vec3(0, offset, 0));
  loaded.quaternion.setFromAxisAngle(z, tilt);
  fixInertia(loaded, inertia);
  level.addBody(floor);
  level.addBody(loaded);
  const down = new cannon.Vec3();
  const ball = watch(
    () => {
      loaded.quaternion.vmult(new cannon.Vec3(0, -1, 0), down);
      return Math.atan2(down.x, -down.y);
    },
    () => level.step(dt),
  );
  tell('cannon-es', '0.20.0', 'cannon-es', 0.004, pendulum, ball);
}
{
  await rapier.init();
  const world = () => {
    const w = new rapier.World({ x: 0, y: -g });
    w.timestep = dt;
    return w;
  };
  const body = (w, x, y, turned) =>
    w.createRigidBody(rapier.RigidBodyDesc.dynamic().setTranslation(x, y).setRotation(turned).setCanSleep(false));
  const swing = world();
  const axis = swing.createRigidBody(rapier.RigidBodyDesc.fixed());
  const bob = body(swing, 1, 0, 0);
  swing.createCollider(rapier.ColliderDesc.ball(0.1).setMass(1), bob);
  swing.createImpulseJoint(rapier.JointData.revolute({ x: 0, y: 0 }, { x: -1, y: 0 }), axis, bob, true);
  const pendulum = watch(
    () => Math.atan2(bob.translation().x, -bob.translation().y),
    () => swing.step(),
  );
  const level = world();
  level.createCollider(rapier.ColliderDesc.cuboid(50, 1).setTranslation(0, -1).setFriction(1));
  const loaded = body(level, 0, 1, tilt);
  const disc = rapier.ColliderDesc.ball(1).setFriction(1);
  disc.setMassProperties(1, { x: 0, y: -offset }, inertia);
  level.createCollider(disc, loaded);
  const ball = watch(
    () => loaded.rotation(),
    () => level.step(),
  );
  tell('Rapier', '0.21.0', '@dimforge/rapier2d-compat', 0.005, pendulum, ball);
}
{
  const body = (x, y, angle, radius, middle) => {
    const b = new p2.Body({ mass: 1, position: [x, y], angle, damping: 0, angularDamping: 0 });
    b.addShape(new p2.Circle({ radius }), [0, middle]);
    return b;
  };
  const swing = new p2.World({ gravity: [0, -g] });
  const axis = new p2.Body();
  const bob = body(1, 0, 0, 0.1, 0);
  swing.addBody(axis);
  swing.addBody(bob);
  swing.addConstraint(new p2.RevoluteConstraint(axis, bob, { worldPivot: [0, 0] }));
  const pendulum = watch(
    () => Math.atan2(bob.position[0], -bob.position[1]),
    () => swing.step(dt),
  );
  const level = new p2.World({ gravity: [0, -g] });
  level.defaultContactMaterial.friction = 1;
  const floor = new p2.Body();
  floor.addShape(new p2.Plane());
  const loaded = body(offset * sin, 1 - offset * cos, tilt, 1, offset);
  loaded.inertia = inertia;
  loaded.invInertia = 1 / inertia;
  level.addBody(floor);
  level.addBody(loaded);
  const ball = watch(
    () => loaded.angle,
    () => level.step(dt),
  );
  tell('p2', '1.2.3', 'p2-es', 0.005, pendulum, ball);
}
J
(cd "$room" && node ask.mjs 2>"$room/errors") >"$room/seen" || cat "$room/errors" >&2
as_recorded engines-npm
