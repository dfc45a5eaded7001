/// @file
/// Single calls timed with a cold cache: before each, more memory is touched than the nearer caches hold.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "race/race.hpp"

namespace bench::cold
{

/// One way.
struct Entrant
{
  std::string name;                   ///< as in the table
  std::function<double(double)> one;  ///< of one number
};

/// How many bytes are touched before each call.
inline constexpr std::size_t touched = std::size_t{4} << 20;

/// Times single calls, in each round so many for each entrant, in an order that changes at random, since
/// what an entrant leaves behind may serve the next, and each with an argument of its own. A round's time
/// is the median of its calls, less that of a call of a function that returns its argument; the rest is as
/// in race::run(). Throws std::invalid_argument for no arguments or fewer than one round.
std::vector<race::Timing> run(const std::vector<Entrant>& entrants, std::span<const double> arguments,
                              int rounds);

}  // namespace bench::cold
