/// @file
/// Several ways to one result, timed against each other in one process.
///
/// A single timing tells little on a machine that does other things too. Here all entrants run in turn,
/// round after round, so that what disturbs one disturbs all, and what is reported of each is the median:
/// of its own time, and of its time over that of the first entrant in the same round. The time is the
/// processor's, not the wall clock's.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace race
{

/// One way to the result.
struct Entrant
{
  std::string name;           ///< how it is called in the table
  std::function<void()> run;  ///< performs `evaluations` evaluations
  std::size_t evaluations;    ///< how many evaluations one call of `run` makes, at least 1
};

/// A function that is evaluated so many times in one call of `run`; its results are kept(). Without a function, or with no
/// evaluations, run() throws.
Entrant of_function(std::string name, const std::function<double()>& function, std::size_t evaluations);

/// How long a race lasts.
struct Options
{
  int rounds = 11;                 ///< how many times each entrant has its turn, at least 1
  double seconds_per_turn = 2e-3;  ///< a turn repeats `run` until about this long has passed, at least once
};

/// What was measured of one entrant.
struct Timing
{
  std::string name;  ///< the entrant's
  double seconds;    ///< per evaluation, the median over the rounds
  double fastest;    ///< per evaluation, in the best round
  double ratio;      ///< its time over that of entrant 0, the median over the rounds
  double spread;     ///< half the distance of that ratio's quartiles, as a part of it
};

/// Times the entrants in interleaved rounds; the one who begins changes from round to round. Each is first
/// called until a turn's length is known. The result is in the order of the entrants. An entrant without
/// evaluations or without a function, or fewer than one round, throws std::invalid_argument.
std::vector<Timing> run(const std::vector<Entrant>& entrants, Options options = {});

/// The median; of none, NaN.
double median(std::vector<double> x);

/// What is told of an entrant by its time for one evaluation in each round, and that of the first entrant.
/// Both must have as many elements, at least one.
Timing timing_of(const std::string& name, const std::vector<double>& times,
                 const std::vector<double>& first);

/// Makes the compiler believe that somebody looks at `value`, so that it must be computed. Costs nothing.
template <class T>
inline void keep(const T& value)
{
  asm volatile("" : : "r,m"(value) : "memory");
}

/// Makes the compiler forget what it knows of `value`, so that nothing can be computed from it ahead of
/// time.
template <class T>
inline void forget(T& value)
{
  asm volatile("" : "+m"(value) : : "memory");
}

}  // namespace race
