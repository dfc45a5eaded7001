/// @file
/// What is raced in bench-globe: scenes, and in each the ways to one quantity.
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
  std::string name;                                ///< as it stands in the table
  std::string kind;                                ///< "ours" or "peer"
  std::function<void(std::span<double> out)> run;  ///< NaN where the method fails
};

/// One quantity at many arguments, and all the ways to it; the speed of the others is told by the first.
struct Scene
{
  std::string name;                 ///< as it stands over the table
  std::string quantity;             ///< what is computed, and for which arguments
  std::string unit;                 ///< of the errors
  std::size_t size = 0;             ///< how many arguments
  std::vector<exact::Fifty> exact;  ///< of as many of the first arguments as are judged
  std::vector<Method> methods;      ///< the ways to it
};

/// A scene that is set up when it is wanted.
struct Lazy
{
  std::string name;             ///< the scene's
  std::function<Scene()> make;  ///< sets it up
};

/// How a method did, over the arguments that it did not fail at.
struct Error
{
  double worst = 0;          ///< the largest error in ulps
  double mean = 0;           ///< the mean of all
  std::size_t failures = 0;  ///< results that are no finite number
  std::size_t judged = 0;    ///< how many arguments were looked at
};

/// All scenes, in the order of the book.
std::vector<Lazy> all_scenes();

/// Judges what a method gave.
Error judge(const Scene& scene, std::span<const double> out);

}  // namespace bench
