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

/// Times single calls, each with an argument of its own: for each entrant runs of some calls one after another, the
/// first of a run not counted. So before each call that counts the entrant was called last, and between the two
/// there is only the memory that is touched. Were the entrants to take turns call by call, the code and the tables
/// of each would have lain untouched while all others had theirs, but what several of them share, as a logarithm of
/// the C library, would not. The runs follow each other in an order that changes at random, so that what disturbs
/// the machine for a while disturbs all. A round's time is the mean of the middle half of its calls, less that of a
/// call of a function that returns its argument; the rest is as in race::run(). Throws std::invalid_argument for no
/// arguments or fewer than one round.
std::vector<race::Timing> run(const std::vector<Entrant>& entrants, std::span<const double> arguments,
                              int rounds);

}  // namespace bench::cold
