#include "pendulum/body.hpp"

#include <cmath>

namespace pendulum
{

double Body::a() const
{
  return G.stableNorm();
}

// [body_of]
Body body_of(const Elements& elements)
{
  const Eigen::RowVectorXd m = elements.row(0);
  const Eigen::Vector2d G = elements.bottomRows<2>() * (m / m.sum()).transpose();
  const Eigen::Matrix2Xd arms = elements.bottomRows<2>().colwise() - G;
  Eigen::RowVectorXd r(m.size());
  for(Eigen::Index i = 0; i < m.size(); ++i)
    r(i) = arms.col(i).stableNorm() * std::sqrt(m(i) / m.sum());
  return {m.sum(), G, r.stableNorm()};
}
// [body_of]

// [sum_of_squares]
double moment_of_inertia(const Elements& elements, const Eigen::Vector2d& point)
{
  return elements.row(0).dot((elements.bottomRows<2>().colwise() - point).colwise().squaredNorm());
}
// [sum_of_squares]

Elements turned(Elements elements, double phi)
{
  const Eigen::Vector2d G = body_of(elements).G;
  const double by = phi - std::atan2(G.x(), -G.y());
  const Eigen::Matrix2d turn{{std::cos(by), -std::sin(by)}, {std::sin(by), std::cos(by)}};
  elements.bottomRows<2>() = (turn * elements.bottomRows<2>()).eval();
  return elements;
}

Elements three_weights()
{
  return Elements{{1, 2, 0.5}, {0.3, -0.2, 0.9}, {-1.1, -0.4, -2.3}};
}

}  // namespace pendulum
