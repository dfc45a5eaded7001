/// @file
/// What the scenes are put together from: arguments, and ways to a number.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "exact/fifty.hpp"
#include "race/bench/parts.hpp"
#include "scenes.hpp"

namespace bench
{

/// A degree in radians.
inline constexpr double degree = std::numbers::pi / 180;
/// So many of the first arguments are judged.
inline constexpr std::size_t judged = 2000;

/// A method from a function of one number; what it throws becomes NaN.
template <class Function>
Method each(std::string name, std::string kind, Function f)
{
  const auto one = [f](double x) {
    try
    {
      return static_cast<double>(f(x));
    }
    catch(const std::exception&)
    {
      return not_a_number;
    }
  };
  return {std::move(name), std::move(kind),
          [one](std::span<const double> in, std::span<double> out) {
            for(std::size_t i = 0; i < in.size(); ++i)
              out[i] = one(in[i]);
          },
          one};
}

/// What a function of GSL returns, NaN where it fails.
double gsl_value(int status, double value);

/// Uniform in the logarithm to base 2, by exact scaling alone so that the numbers are the same everywhere.
std::vector<double> logarithmic(std::uint64_t seed, std::size_t n, int octaves);

/// f of as many of the first numbers as are judged.
template <class Function>
std::vector<exact::Fifty> exactly(const std::vector<double>& in, Function f)
{
  std::vector<exact::Fifty> values;
  for(std::size_t i = 0; i < in.size() && i < judged; ++i)
    values.push_back(f(in[i]));
  return values;
}

/// The scenes of K and of the period.
void add_values(std::vector<Scene>& scenes);
/// The scenes of the motion.
void add_motions(std::vector<Scene>& scenes);
/// The scenes of the quarter period as an integral, and of the equation of motion integrated.
void add_integrations(std::vector<Scene>& scenes);

}  // namespace bench
