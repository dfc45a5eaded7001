/// @file
/// Libraries that take part in the benchmark where they are installed: FLINT's Arb, PARI, and SLEEF for a
/// logarithm.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace bench::libraries
{

/// A way to K by k and kc of the same amplitude, both given as doubles.
struct K_way
{
  std::string name;                              ///< as it stands in the table
  std::function<double(double k, double kc)> K;  ///< K, as a double
};

/// The ways of those that are installed.
std::vector<K_way> K_ways();

/// The names of those that are not.
std::vector<std::string> left_out();

}  // namespace bench::libraries
