/// @file
/// What every benchmark's report says alike.
#pragma once

#include <fstream>
#include <string>

#include <fmt/format.h>

namespace race
{

/// The processor's name as Linux gives it; "unknown" where it gives none.
inline std::string processor()
{
  std::ifstream info("/proc/cpuinfo");
  for(std::string line; std::getline(info, line);)
    if(line.starts_with("model name"))
      return line.substr(line.find(": ") + 2);
  return "unknown";
}

/// A number rounded to three digits: what a table shows, and more than a repeated run keeps.
inline double three_digits(double x)
{
  return std::stod(fmt::format("{:.3g}", x));
}

}  // namespace race
