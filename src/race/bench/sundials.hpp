/// @file
/// SUNDIALS' integrators, which take part in the benchmark where they are installed.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bench::sundials
{

/// ẏ of y at the time t, as GSL wants it: 0 where it can be had.
using Slope = int (*)(double t, const double y[], double slope[], void* of);

/// A way to carry y from the time 0 to t; whether it got there.
struct Way
{
  std::string name;                               ///< as it stands in the table
  std::function<bool(double* y, double t)> from;  ///< y goes in and comes out
};

/// ARKODE's explicit pairs of the eighth and the sixth order, and CVODE's Adams rule, of `n` numbers, with the tolerance
/// absolutely and relatively; none where SUNDIALS is not installed.
std::vector<Way> ways(Slope slope, const std::shared_ptr<void>& of, std::size_t n, double tolerance);

/// CVODE's backward differentiation formulae, for one stiff equation; none where SUNDIALS is not installed.
std::vector<Way> stiff_ways(Slope slope, const std::shared_ptr<void>& of, double tolerance);

/// The names of those that are not installed.
std::vector<std::string> left_out();

}  // namespace bench::sundials
