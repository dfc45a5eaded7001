#!/bin/sh
# Box2D 2.4.1 (Debian libbox2d-dev 2.4.1-3): a pendulum that swings little enough does not swing. A body slower than 0.01 m/s
# and 2 degrees/s for half a second is put to sleep, joint or no joint, and hangs at the angle where it was then.
#
# The guess: small swings are the easy ones, the period is known to all digits. A pendulum of one metre let go from 0.15
# degrees stops for good within a second, not even upright. Way out: allowSleep = false in the body's definition, or in the world.
#
#> allowed to sleep: asleep at the end, swings through 0.00 degrees
#> not allowed to sleep: awake at the end, swings through 0.30 degrees
. "$(dirname "$0")/room.sh"
debian libbox2d-dev=2.4.1-3
cat >"$room/ask.cpp" <<'C'
#include <algorithm>
#include <box2d/box2d.h>
#include <cmath>
#include <cstdio>
int main()
{
  for(const bool sleeps : {true, false})
  {
    b2World world({0, -9.81f});
    const double start = 0.15 * M_PI / 180;
    b2BodyDef fixed, def;
    def.type = b2_dynamicBody;
    def.position.Set(float(std::sin(start)), float(-std::cos(start)));
    def.allowSleep = sleeps;
    b2Body* bob = world.CreateBody(&def);
    b2MassData mass{1, {0, 0}, 0.005f};
    bob->SetMassData(&mass);
    b2RevoluteJointDef joint;
    joint.Initialize(world.CreateBody(&fixed), bob, {0, 0});
    world.CreateJoint(&joint);
    double low = 1, high = -1;
    for(int i = 0; i < 3600; ++i)
    {
      world.Step(1 / 60.f, 8, 3);
      if(i < 3300) continue;
      const double angle = std::atan2(bob->GetPosition().x, -bob->GetPosition().y) * 180 / M_PI;
      low = std::min(low, angle);
      high = std::max(high, angle);
    }
    std::printf("%s sleep: %s at the end, swings through %.2f degrees\n", sleeps ? "allowed to" : "not allowed to",
                bob->IsAwake() ? "awake" : "asleep", high - low);
  }
}
C
in_room c++ -std=c++17 -O1 ask.cpp -o ask -lbox2d
in_room ./ask >"$room/seen"
as_seen "$room/seen"
