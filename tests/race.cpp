/// @file
/// The timing harness: what it reports must be right whatever the machine does.
#include <stdexcept>

#include <doctest/doctest.h>

#include "race/race.hpp"

TEST_CASE("every entrant runs in every round, the repetitions alike")
{
  std::size_t a = 0;
  std::size_t b = 0;
  const auto timings = race::run({{"a", [&] { ++a; }, 1}, {"b", [&] { ++b; }, 10}}, {7, 1e-5});
  REQUIRE(timings.size() == 2);
  CHECK(timings[0].name == "a");
  CHECK(timings[1].name == "b");
  CHECK(a >= 8);
  CHECK(b >= 8);
  CHECK(timings[0].ratio == 1.0);
}

TEST_CASE("the fastest round is no slower than the median, and both are positive")
{
  double x = 1;
  const auto work = [&] {
    for(int i = 0; i < 1000; ++i)
    {
      race::forget(x);
      race::keep(1 / x);
    }
  };
  for(const auto& timing : race::run({{"division", work, 1000}}, {5, 1e-4}))
  {
    CHECK(timing.fastest > 0);
    CHECK(timing.fastest <= timing.seconds);
  }
}

TEST_CASE("a function is evaluated as often as its entrant says")
{
  int calls = 0;
  const race::Entrant entrant = race::of_function(
      "counts", [&] { return double(++calls); }, 64);
  CHECK(entrant.name == "counts");
  CHECK(entrant.evaluations == 64);
  entrant.run();
  CHECK(calls == 64);
}

TEST_CASE("a race without rounds or with an entrant that does nothing is refused")
{
  CHECK_THROWS_AS(race::run({{"none", [] {}, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(race::run({{"empty", nullptr, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(race::run({race::of_function("empty", nullptr, 1)}), std::invalid_argument);
  CHECK_THROWS_AS(race::run({race::of_function(
                      "none", [] { return 1.; }, 0)}),
                  std::invalid_argument);
  CHECK_THROWS_AS(race::run({{"a", [] {}, 1}}, {0, 1e-3}), std::invalid_argument);
  CHECK(race::run({}).empty());
}
