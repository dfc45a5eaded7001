#include "race/race.hpp"

#include <algorithm>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <utility>

namespace race
{
namespace
{

// The time that the processor spent on this program, so that what others did meanwhile is not counted: in nanoseconds,
// for std::clock() counts whole microseconds, and a short turn could last none.
double processor_seconds()
{
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const Entrant& entrant, std::size_t repetitions)
{
  const double start = processor_seconds();
  for(std::size_t i = 0; i < repetitions; ++i)
    entrant.run();
  return processor_seconds() - start;
}

// Doubles the repetitions until they last for a turn; this warms the caches too.
std::size_t repetitions_for(const Entrant& entrant, double seconds)
{
  std::size_t repetitions = 1;
  while(seconds_of(entrant, repetitions) < seconds && repetitions < (std::size_t{1} << 30))
    repetitions *= 2;
  return repetitions;
}

// Half of what lies between the quartiles, as a part of the median.
double spread(std::vector<double> x)
{
  std::sort(x.begin(), x.end());
  const std::size_t quarter = x.size() / 4;
  return (x[x.size() - 1 - quarter] - x[quarter]) / 2 / median(x);
}

}  // namespace

Entrant of_function(std::string name, const std::function<double()>& function, std::size_t evaluations)
{
  if(!function)
    return {std::move(name), {}, evaluations};
  const auto run = [function, evaluations] {
    for(std::size_t i = 0; i < evaluations; ++i)
      keep(function());
  };
  return {std::move(name), run, evaluations};
}

double median(std::vector<double> x)
{
  if(x.empty())
    return std::numeric_limits<double>::quiet_NaN();
  std::sort(x.begin(), x.end());
  const std::size_t half = x.size() / 2;
  return x.size() % 2 == 1 ? x[half] : (x[half - 1] + x[half]) / 2;
}

Timing timing_of(const std::string& name, const std::vector<double>& times,
                 const std::vector<double>& first)
{
  std::vector<double> ratios;
  for(std::size_t round = 0; round < times.size(); ++round)
    ratios.push_back(times[round] / first[round]);
  return {name, median(times), *std::min_element(times.begin(), times.end()), median(ratios),
          spread(ratios)};
}

std::vector<Timing> run(const std::vector<Entrant>& entrants, Options options)
{
  if(options.rounds < 1)
    throw std::invalid_argument("race: at least one round is needed");
  std::vector<std::size_t> repetitions;
  for(const Entrant& entrant : entrants)
  {
    if(entrant.evaluations == 0 || !entrant.run)
      throw std::invalid_argument("race: " + entrant.name + " has nothing to run");
    repetitions.push_back(repetitions_for(entrant, options.seconds_per_turn));
  }

  const std::size_t n = entrants.size();
  std::vector<std::vector<double>> times(n);
  for(std::size_t round = 0; round < static_cast<std::size_t>(options.rounds); ++round)
    for(std::size_t turn = 0; turn < n; ++turn)
    {
      const std::size_t i = (round + turn) % n;
      const auto evaluations = static_cast<double>(repetitions[i] * entrants[i].evaluations);
      times[i].push_back(seconds_of(entrants[i], repetitions[i]) / evaluations);
    }

  std::vector<Timing> timings;
  for(std::size_t i = 0; i < n; ++i)
    timings.push_back(timing_of(entrants[i].name, times[i], times[0]));
  return timings;
}

}  // namespace race
