#!/bin/sh
# Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4): eulerAngles keeps the first angle between nought and a half turn, so that a
# small turn backwards comes out as three large ones; and a Quaterniond has its scalar first where it is given four
# numbers, and last where it is given four numbers in an array.
#
# The guess: the angles of a turn by -0.1 about z are (-0.1, 0, 0), as those of +0.1 are (0.1, 0, 0): a ball that rocks
# about upright jumps by half turns at every passage. And {1, 0, 0, 0} is the turn that leaves all as it is. Way out: own
# formulae with atan2; name the order (Quaterniond(w, x, y, z)) and never map an array that another program made.
#
#> +0.1 about z: 0.1000 0.0000 0.0000
#> -0.1 about z: 3.0416 -3.1416 3.1416
#> Quaterniond(1, 0, 0, 0) turns y to +1 y
#> Quaterniond(array {1, 0, 0, 0}) turns y to -1 y
. "$(dirname "$0")/room.sh"
debian libeigen3-dev=3.4.0-4
cat >"$room/ask.cpp" <<'C'
#include <Eigen/Geometry>
#include <cstdio>
int main()
{
  using namespace Eigen;
  for(const double angle : {0.1, -0.1})
  {
    const Vector3d a = AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix().eulerAngles(2, 1, 0);
    std::printf("%+.1f about z: %.4f %.4f %.4f\n", angle, a[0], a[1] + 0.0, a[2] + 0.0);
  }
  const double array[] = {1, 0, 0, 0};
  std::printf("Quaterniond(1, 0, 0, 0) turns y to %+g y\n", (Quaterniond(1, 0, 0, 0) * Vector3d::UnitY()).y());
  std::printf("Quaterniond(array {1, 0, 0, 0}) turns y to %+g y\n", (Quaterniond(array) * Vector3d::UnitY()).y());
}
C
in_room c++ -std=c++17 -O1 -isystem /usr/include/eigen3 ask.cpp -o ask
"$room/ask" >"$room/seen"
as_seen "$room/seen"
