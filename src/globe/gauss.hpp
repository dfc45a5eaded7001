/// @file
/// The Gauss-Legendre rule with a fixed number of nodes, for the comparisons of quadratures.
#pragma once

#include <vector>

namespace globe
{

/// Nodes and weights, found once, used as often as wanted.
class Gauss
{
public:
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

private:
  struct Node
  {
    double x;
    double weight;
  };
  std::vector<Node> nodes_;
};

}  // namespace globe
