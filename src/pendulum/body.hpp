/// @file
/// A body as the elements it is made of, and the three numbers that are left of it in the motion.
#pragma once

#define EIGEN_DONT_VECTORIZE  // sums in one order, and to the same bits, on every processor and in the page
#include <Eigen/Core>

namespace pendulum
{

/// The elements of a body, one in each column: its mass and its place x, y. The axis A is the
/// origin, y points upwards.
using Elements = Eigen::Matrix3Xd;

// [body]
/// What the motion knows of a body: its mass M, its centre of gravity G and its radius of gyration
/// k about G (§3).
struct Body
{
  double M;           ///< its mass
  Eigen::Vector2d G;  ///< where its centre of gravity is, A being the origin
  double k;           ///< its radius of gyration about G

  double a() const;  ///< AG
};
// [body]

/// The body that the elements make. Domain: positive masses. Error: a few ulps of the greatest arm;
/// squares of lengths do not overflow.
Body body_of(const Elements& elements);

/// The moment of inertia of the elements about a parallel axis through `point`: each mass by the
/// square of its distance.
double moment_of_inertia(const Elements& elements, const Eigen::Vector2d& point);

/// The body turned about A until AG makes the angle phi with the vertical, to the right of it. Domain: G
/// not at A.
Elements turned(Elements elements, double phi);

/// Three weights on one body, the example of §§3 to 5: with its centre of gravity neither in an
/// element nor below A.
Elements three_weights();

}  // namespace pendulum
