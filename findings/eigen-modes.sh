#!/bin/sh
# Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4): computeDirect of a symmetric matrix of three rows loses half of the digits
# of close or small frequencies; and the generalised solver reads the lower half of both matrices only.
#
# The guess: "direct" is quicker and as good, three rows being few: two nearly equal pans whose squared frequencies
# differ by 1e-8 come out with a seventh of that missing, and a slow mode of 1e-12 beside one of 1000 seventeen times too
# large. And a mass matrix of which the upper half is filled in is symmetric enough: it is taken for diagonal, and
# "success" is reported. Way out: compute(), and both halves.
#
#> difference of two close ones, true 1e-08: direct 8.67e-09, iterated 1.00e-08
#> smallest of three, true 1e-12: direct 1.76e-11, iterated 1.01e-12
#> mass matrix, upper half only: 1.0000 3.0000, success; both halves: 0.8377 7.1623
. "$(dirname "$0")/room.sh"
debian libeigen3-dev=3.4.0-4
cat >"$room/ask.cpp" <<'C'
#include <Eigen/Dense>
#include <cstdio>
using namespace Eigen;
Matrix3d turned(const Vector3d& values)
{
  const Matrix3d q = AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Matrix3d m = q * values.asDiagonal() * q.transpose();
  return (m + m.transpose()) / 2;
}
int main()
{
  SelfAdjointEigenSolver<Matrix3d> direct, iterated;
  const auto both = [&](const Vector3d& values) {
    direct.computeDirect(turned(values));
    iterated.compute(turned(values));
  };
  both({1, 1 + 1e-8, 2});
  const auto difference = [](const auto& s) { return s.eigenvalues()[1] - s.eigenvalues()[0]; };
  std::printf("difference of two close ones, true 1e-08: direct %.2e, iterated %.2e\n", difference(direct),
              difference(iterated));
  both({1e-12, 1, 1000});
  std::printf("smallest of three, true 1e-12: direct %.2e, iterated %.2e\n", direct.eigenvalues()[0],
              iterated.eigenvalues()[0]);
  Matrix2d stiffness, mass;
  stiffness << 2, 0, 0, 3;
  mass << 2, 1, 0, 1;
  GeneralizedSelfAdjointEigenSolver<Matrix2d> half(stiffness, mass);
  mass << 2, 1, 1, 1;
  GeneralizedSelfAdjointEigenSolver<Matrix2d> whole(stiffness, mass);
  std::printf("mass matrix, upper half only: %.4f %.4f, %s; both halves: %.4f %.4f\n", half.eigenvalues()[0],
              half.eigenvalues()[1], half.info() == Success ? "success" : "refused", whole.eigenvalues()[0],
              whole.eigenvalues()[1]);
}
C
in_room c++ -std=c++17 -O1 -isystem /usr/include/eigen3 ask.cpp -o ask
"$room/ask" >"$room/seen"
as_seen "$room/seen"
