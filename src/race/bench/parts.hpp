/// @file
/// What the scenes of several benchmarks are put together from.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <boost/math/policies/policy.hpp>

namespace bench
{

/// Where Boost's functions fail they give an infinity or a NaN; what an exception costs is not counted against
/// them.
using Overflow = boost::math::policies::overflow_error<boost::math::policies::ignore_error>;
/// The same.
using Domain = boost::math::policies::domain_error<boost::math::policies::ignore_error>;
/// Boost's own default, which computes in long double.
using Promoting =
    boost::math::policies::policy<boost::math::policies::promote_double<true>, Overflow, Domain>;
/// The one that stays in double.
using DoubleOnly =
    boost::math::policies::policy<boost::math::policies::promote_double<false>, Overflow, Domain>;

/// What a peer without an answer gives.
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
/// So many arguments has a scene: too many for the processor to learn their order.
inline constexpr std::size_t many = 100000;

/// n numbers spread evenly from a to b.
inline std::vector<double> uniform(std::uint64_t seed, std::size_t n, double a, double b)
{
  std::mt19937_64 engine(seed);
  std::vector<double> x(n);
  for(double& y : x)
    y = a + (b - a) * std::ldexp(static_cast<double>(engine() >> 11), -53);
  return x;
}

}  // namespace bench
