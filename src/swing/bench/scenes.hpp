/// @file
/// What is raced in bench-swing: scenes, and in each the ways to one quantity with their errors.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "exact/fifty.hpp"

namespace bench
{

/// One way to the quantity of a scene.
struct Method
{
  std::string name;  ///< as it stands in the table
  std::string kind;  ///< "ours", "peer", "Euler" or "classic"
  std::function<void(std::span<const double> in, std::span<double> out)>
      run;                              ///< NaN where the method fails
  std::function<double(double)> one{};  ///< the same of one number; none of methods that work on arrays
};

/// One quantity, its arguments, and all the ways to it.
struct Scene
{
  std::string name;                 ///< as it stands over the table
  std::string quantity;             ///< what is computed, and for which arguments
  std::string unit;                 ///< of the errors
  std::string peer;                 ///< the method whose time the others' are divided by
  std::vector<double> in;           ///< the arguments
  std::vector<exact::Fifty> exact;  ///< of as many of the first arguments as are judged
  double place = 0;             ///< the unit of the error where it is not the last place: 2⁻⁵² of this
  std::vector<Method> methods;  ///< the ways to it
  bool cold = false;            ///< whether each call is timed alone, after much memory was touched
};

/// How a method did: errors in the scene's unit, over the arguments that it did not fail at.
struct Error
{
  double worst = 0;          ///< the largest error
  double mean = 0;           ///< the mean of all errors
  std::size_t failures = 0;  ///< results that are no finite number where the true one is
  std::size_t judged = 0;    ///< how many arguments were looked at
};

/// All scenes, in the order of the book.
std::vector<Scene> all_scenes();

/// Runs the method once over the arguments and judges it.
Error judge(const Scene& scene, const Method& method);

}  // namespace bench
