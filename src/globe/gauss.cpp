#include "globe/gauss.hpp"

#include <memory>
#include <stdexcept>

#include <gsl/gsl_integration.h>

namespace globe
{

Gauss::Gauss(int n)
{
  if(n < 1)
    throw std::invalid_argument("a rule of quadrature has at least one node");
  const auto size = static_cast<std::size_t>(n);
  const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> table{
      gsl_integration_glfixed_table_alloc(size), &gsl_integration_glfixed_table_free};
  nodes_.resize(size);
  for(std::size_t i = 0; i < size; ++i)
    gsl_integration_glfixed_point(-1, 1, i, &nodes_[i].x, &nodes_[i].weight, table.get());
}

}  // namespace globe
