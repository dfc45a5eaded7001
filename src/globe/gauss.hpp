/// @file
/// The Gauss-Legendre rule with a fixed number of nodes, for the times of the ball and the comparisons of quadratures.
#pragma once

#include <vector>

namespace globe
{

/// Nodes and weights, found once, used as often as wanted.
class Gauss
{
public:
  /// Where f is asked, and what its value counts.
  struct Node
  {
    double x;       ///< from −1 to 1
    double weight;  ///< all together 2
  };

  /// The rule with n nodes, exact for polynomials below the degree 2n. n ≥ 1, else std::invalid_argument.
  /// Source: gsl_integration_glfixed, tabulated for n ≤ 20 and found by Newton's method for most others.
  explicit Gauss(int n);

  /// The integral of f from a to b.
  template <class Function>
  double operator()(Function f, double a, double b) const
  {
    double sum = 0;
    for(const Node& node : nodes_)
      sum += node.weight * f((a + b) / 2 + node.x * (b - a) / 2);
    return sum * (b - a) / 2;
  }

  /// The nodes for the interval from −1 to 1.
  const std::vector<Node>& nodes() const { return nodes_; }

private:
  std::vector<Node> nodes_;
};

}  // namespace globe
