#!/bin/sh
# Pendulum and loaded ball (see scene.sh) in Box2D, Bullet and ODE. Seen: book/systems/engines-debian.json.
. "$(dirname "$0")/scene.sh"
debian libbox2d-dev=2.4.1-3 libbullet-dev=3.24+dfsg-2 libode-dev=2:0.16.2-1
cat >"$room/measure.hpp" <<'C'
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
constexpr double g = 9.81, dt = 1.0 / 60, right_angle = M_PI / 2, tilt = 1.2, offset = 0.5, inertia = 0.4;
struct Seen
{
  double period, amplitude;
};
// Steps a scene for a minute; angle() is its angle from the lowest place.
inline Seen watch(const std::function<double()>& angle, const std::function<void()>& step)
{
  double first = 0, last = 0, largest = 0, before = angle();
  int times = 0;
  for(int i = 0; i < 3600; ++i)
  {
    step();
    const double now = angle();
    if(before > 0 && now <= 0)
    {
      last = (i + before / (before - now)) * dt;
      if(times++ == 0)
        first = last;
    }
    if(i >= 3300)
      largest = std::max(largest, std::abs(now));
    before = now;
  }
  return {(last - first) / (times - 1), largest * 180 / M_PI};
}
inline void tell(const char* engine, const char* version, const char* from, double bob, Seen pendulum, Seen ball)
{
  std::printf("{\"engine\":\"%s\",\"version\":\"%s\",\"from\":\"%s\",\"bob\":%g,"
              "\"pendulum\":{\"period\":%.4f,\"amplitude\":%.2f},\"ball\":{\"period\":%.4f,\"amplitude\":%.2f}}\n",
              engine, version, from, bob, pendulum.period, pendulum.amplitude, ball.period, ball.amplitude);
}
C
cat >"$room/box2d.cpp" <<'C'
#include "measure.hpp"
#include <box2d/box2d.h>
b2Body* body(b2World& world, b2Vec2 at, float angle, float radius, b2MassData mass, b2Vec2 centre)
{
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = at;
  def.angle = angle;
  def.allowSleep = false;
  b2Body* b = world.CreateBody(&def);
  b2CircleShape circle;
  circle.m_radius = radius;
  circle.m_p = centre;
  b2FixtureDef fixture;
  fixture.shape = &circle;
  fixture.density = 1;
  fixture.friction = 1;
  b->CreateFixture(&fixture);
  b->SetMassData(&mass);
  return b;
}
int main()
{
  b2World swing({0, -g});
  b2BodyDef fixed;
  b2Body* bob = body(swing, {1, 0}, 0, 0.1f, {1, {0, 0}, 0.005f}, {0, 0});
  b2RevoluteJointDef joint;
  joint.Initialize(swing.CreateBody(&fixed), bob, {0, 0});
  swing.CreateJoint(&joint);
  const Seen pendulum = watch([&] { return std::atan2(bob->GetPosition().x, -bob->GetPosition().y); },
                              [&] { swing.Step(dt, 8, 3); });
  b2World plane({0, -g});
  b2EdgeShape edge;
  edge.SetTwoSided({-50, 0}, {50, 0});
  b2FixtureDef ground;
  ground.shape = &edge;
  ground.friction = 1;
  plane.CreateBody(&fixed)->CreateFixture(&ground);
  b2Body* loaded = body(plane, {0, 1}, tilt, 1, {1, {0, -offset}, inertia + offset * offset}, {0, 0});
  const Seen ball = watch([&] { return loaded->GetAngle(); }, [&] { plane.Step(dt, 8, 3); });
  tell("Box2D", "2.4.1", "Debian libbox2d-dev 2.4.1-3", 0.005, pendulum, ball);
}
C
cat >"$room/bullet.cpp" <<'C'
#include "measure.hpp"
#include <btBulletDynamicsCommon.h>
struct World
{
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  World() { world.setGravity({0, -g, 0}); }
};
int main()
{
  World swing;
  btSphereShape small(0.1);
  btRigidBody bob(1, nullptr, &small, btVector3(0.004, 0.004, 0.004));
  bob.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(1, 0, 0)));
  bob.setActivationState(DISABLE_DEACTIVATION);
  swing.world.addRigidBody(&bob);
  btHingeConstraint hinge(bob, btVector3(-1, 0, 0), btVector3(0, 0, 1));
  swing.world.addConstraint(&hinge);
  const auto place = [&] { return bob.getWorldTransform().getOrigin(); };
  const Seen pendulum = watch([&] { return std::atan2(place().x(), -place().y()); },
                              [&] { swing.world.stepSimulation(dt, 0); });
  World level;
  btStaticPlaneShape ground(btVector3(0, 1, 0), 0);
  btRigidBody floor(0, nullptr, &ground);
  floor.setFriction(1);
  level.world.addRigidBody(&floor);
  btSphereShape sphere(1);
  btCompoundShape shifted;
  shifted.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, offset, 0)), &sphere);
  btRigidBody loaded(1, nullptr, &shifted, btVector3(inertia, inertia, inertia));
  loaded.setFriction(1);
  loaded.setWorldTransform(btTransform(btQuaternion(btVector3(0, 0, 1), tilt),
                                       btVector3(offset * std::sin(tilt), 1 - offset * std::cos(tilt), 0)));
  loaded.setActivationState(DISABLE_DEACTIVATION);
  level.world.addRigidBody(&loaded);
  const Seen ball = watch(
      [&] {
        const btVector3 down = loaded.getWorldTransform().getBasis() * btVector3(0, -1, 0);
        return std::atan2(down.x(), -down.y());
      },
      [&] { level.world.stepSimulation(dt, 0); });
  tell("Bullet", "3.24", "Debian libbullet-dev 3.24+dfsg-2", 0.004, pendulum, ball);
  swing.world.removeConstraint(&hinge);
}
C
cat >"$room/ode.cpp" <<'C'
#include "measure.hpp"
#include <ode/ode.h>
dWorldID world;
dJointGroupID contacts;
void near(void*, dGeomID a, dGeomID b)
{
  dContact c[4];
  const int n = dCollide(a, b, 4, &c[0].geom, sizeof(dContact));
  for(int i = 0; i < n; ++i)
  {
    c[i].surface.mode = dContactApprox1;
    c[i].surface.mu = 1;
    dJointAttach(dJointCreateContact(world, contacts, &c[i]), dGeomGetBody(c[i].geom.g1), dGeomGetBody(c[i].geom.g2));
  }
}
int main()
{
  dInitODE();
  world = dWorldCreate();
  dWorldSetGravity(world, 0, -g, 0);
  dBodyID bob = dBodyCreate(world);
  dMass mass;
  dMassSetSphereTotal(&mass, 1, 0.1);
  dBodySetMass(bob, &mass);
  dBodySetPosition(bob, 1, 0, 0);
  dJointID hinge = dJointCreateHinge(world, nullptr);
  dJointAttach(hinge, bob, nullptr);
  dJointSetHingeAnchor(hinge, 0, 0, 0);
  dJointSetHingeAxis(hinge, 0, 0, 1);
  const Seen pendulum = watch([&] { return std::atan2(dBodyGetPosition(bob)[0], -dBodyGetPosition(bob)[1]); },
                              [&] { dWorldStep(world, dt); });
  world = dWorldCreate();
  dWorldSetGravity(world, 0, -g, 0);
  dSpaceID space = dSimpleSpaceCreate(nullptr);
  contacts = dJointGroupCreate(0);
  dCreatePlane(space, 0, 1, 0, 0);
  dBodyID loaded = dBodyCreate(world);
  dMassSetParameters(&mass, 1, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
  dBodySetMass(loaded, &mass);
  dGeomID sphere = dCreateSphere(space, 1);
  dGeomSetBody(sphere, loaded);
  dGeomSetOffsetPosition(sphere, 0, offset, 0);
  dMatrix3 turned;
  dRFromAxisAndAngle(turned, 0, 0, 1, tilt);
  dBodySetRotation(loaded, turned);
  dBodySetPosition(loaded, offset * std::sin(tilt), 1 - offset * std::cos(tilt), 0);
  const Seen ball = watch(
      [&] {
        const dReal* r = dBodyGetRotation(loaded);
        return std::atan2(-r[1], r[5]);
      },
      [&] {
        dSpaceCollide(space, nullptr, near);
        dWorldStep(world, dt);
        dJointGroupEmpty(contacts);
      });
  tell("ODE", "0.16.2", "Debian libode-dev 2:0.16.2-1", 0.004, pendulum, ball);
}
C
in_room sh -c '
  c="c++ -O2 -std=c++17 -w -I/usr/include/bullet"
  $c box2d.cpp -o box2d -lbox2d
  $c bullet.cpp -o bullet -lBulletDynamics -lBulletCollision -lLinearMath
  $c ode.cpp -o ode -lode
  ./box2d; ./bullet; ./ode' >"$room/seen"
as_recorded engines-debian
