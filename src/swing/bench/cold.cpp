#include "cold.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>

#if defined(__x86_64__)
#include <x86intrin.h>
#endif

namespace bench::cold
{
namespace
{

constexpr std::size_t runs = 25;      // of each entrant in a round
constexpr std::size_t uncounted = 2;  // calls at the beginning of a run
constexpr std::size_t counted = 6;    // calls that follow

using Clock = std::chrono::steady_clock;

// A clock for some nanoseconds, in ticks.
#if defined(__x86_64__)
std::uint64_t ticks()
{
  _mm_lfence();
  const std::uint64_t t = __rdtsc();
  _mm_lfence();
  return t;
}
#else
std::uint64_t ticks()
{
  return static_cast<std::uint64_t>(Clock::now().time_since_epoch().count());
}
#endif

double seconds_per_tick()
{
  const Clock::time_point start = Clock::now();
  const std::uint64_t first = ticks();
  while(Clock::now() - start < std::chrono::milliseconds(50))
  {
  }
  const std::uint64_t last = ticks();
  return std::chrono::duration<double>(Clock::now() - start).count() / static_cast<double>(last - first);
}

// One byte of each line.
void touch(std::vector<unsigned char>& memory)
{
  for(std::size_t i = 0; i < memory.size(); i += 64)
    memory[i] = static_cast<unsigned char>(memory[i] + 1);
  race::keep(memory.data());
}

// The mean of the middle half: finer than the clock's steps, and without what was interrupted.
double middle(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  const auto quarter = static_cast<std::ptrdiff_t>(times.size() / 4);
  return std::accumulate(times.begin() + quarter, times.end() - quarter, 0.0)
         / static_cast<double>(times.size() - 2 * (times.size() / 4));
}

}  // namespace

std::vector<race::Timing> run(const std::vector<Entrant>& entrants, std::span<const double> arguments,
                              int rounds)
{
  if(arguments.empty() || rounds < 1)
    throw std::invalid_argument("cold: at least one argument and one round are needed");
  std::vector<Entrant> all{{"nothing", [](double x) { return x; }}};
  all.insert(all.end(), entrants.begin(), entrants.end());
  std::vector<unsigned char> memory(touched);
  const double unit = seconds_per_tick();
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 dice(1);
  std::size_t next = 0;
  std::vector<std::vector<double>> times(all.size());
  for(int round = 0; round < rounds; ++round)
  {
    std::vector<std::vector<double>> of(all.size());
    for(std::size_t run = 0; run < runs; ++run)
    {
      std::shuffle(order.begin(), order.end(), dice);
      for(std::size_t i : order)
        for(std::size_t call = 0; call < uncounted + counted; ++call)
        {
          const double x = arguments[next++ % arguments.size()];
          touch(memory);
          const std::uint64_t start = ticks();
          const double y = all[i].one(x);
          const std::uint64_t end = ticks();
          race::keep(y);
          if(call >= uncounted)
            of[i].push_back(static_cast<double>(end - start) * unit);
        }
    }
    for(std::size_t i = 0; i < all.size(); ++i)
      times[i].push_back(middle(of[i]));
    for(std::size_t i = 1; i < all.size(); ++i)
      times[i].back() -= times[0].back();
  }
  std::vector<race::Timing> timings;
  for(std::size_t i = 1; i < all.size(); ++i)
    timings.push_back(race::timing_of(all[i].name, times[i], times[1]));
  return timings;
}

}  // namespace bench::cold
