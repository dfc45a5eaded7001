/// @file
/// A body as the elements it is made of, and the three numbers that are left of it in the motion.
#pragma once

#include <cmath>

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

  double a() const { return G.stableNorm(); }  ///< AG
};

/// The body that the elements make. Domain: positive masses. Error: a few ulps of the greatest arm;
/// squares of lengths do not overflow.
inline Body body_of(const Elements& elements)
{
  const Eigen::RowVectorXd m = elements.row(0);
  const Eigen::Vector2d G = elements.bottomRows<2>() * (m / m.sum()).transpose();
  const Eigen::Matrix2Xd arms = elements.bottomRows<2>().colwise() - G;
  Eigen::RowVectorXd r(m.size());
  for(Eigen::Index i = 0; i < m.size(); ++i)
    r(i) = arms.col(i).stableNorm() * std::sqrt(m(i) / m.sum());
  return {m.sum(), G, r.stableNorm()};
}
// [body]

// [sum_of_squares]
/// The moment of inertia of the elements about a parallel axis through `point`: each mass by the
/// square of its distance.
inline double moment_of_inertia(const Elements& elements, const Eigen::Vector2d& point)
{
  return elements.row(0).dot((elements.bottomRows<2>().colwise() - point).colwise().squaredNorm());
}
// [sum_of_squares]

/// The body turned about A until AG makes the angle phi with the vertical, to the right of it. Domain: G
/// not at A.
inline Elements turned(Elements elements, double phi)
{
  const Eigen::Vector2d G = body_of(elements).G;
  const double by = phi - std::atan2(G.x(), -G.y());
  const Eigen::Matrix2d turn{{std::cos(by), -std::sin(by)}, {std::sin(by), std::cos(by)}};
  elements.bottomRows<2>() = (turn * elements.bottomRows<2>()).eval();
  return elements;
}

/// Three weights on one body, the example of §§3 to 5: with its centre of gravity neither in an
/// element nor below A.
inline Elements three_weights()
{
  return Elements{{1, 2, 0.5}, {0.3, -0.2, 0.9}, {-1.1, -0.4, -2.3}};
}

}  // namespace pendulum
