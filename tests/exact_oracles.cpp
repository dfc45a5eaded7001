/// @file
/// Integrals and motions to many digits: against closed forms, and the reported errors against the true ones.
#include "edition/compare.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

using namespace exact;
using edition::within;
using edition::within_relative;

namespace
{

// K(sin ½ζ) by the arithmetic-geometric mean: a second route to the period of the pendulum.
Fifty quarter_period(const Fifty& zeta)
{
  Fifty a = 1;
  Fifty b = cos(zeta / 2);
  while(abs(a - b) > Fifty("1e-45"))
  {
    const Fifty mean = (a + b) / 2;
    b = sqrt(a * b);
    a = mean;
  }
  return pi() / (2 * a);
}

State pendulum(const Fifty&, const State& y)
{
  return {y[1], -sin(y[0])};
}

State kepler(const Fifty&, const State& y)
{
  const Fifty r = hypot(y[0], y[1]);
  const Fifty r3 = r * r * r;
  return {y[2], y[3], -y[0] / r3, -y[1] / r3};
}

}  // namespace

TEST_CASE("smooth integrals are known to forty-nine digits")
{
  const auto quarter = integrate([](const Fifty& x) { return 1 / (1 + x * x); }, 0, 1);
  CHECK(4 * quarter.value == within_relative(pi(), 1e-48, "a few hundred roundings"));
  const auto backward = integrate([](const Fifty& x) { return exp(x); }, 1, -2);
  CHECK(backward.value
        == within_relative(exp(Fifty(-2)) - exp(Fifty(1)), 1e-48, "a few hundred roundings"));
  CHECK(integrate([](const Fifty& x) { return x; }, 3, 3).value == 0);
  CHECK(integrate([](const Fifty& x) { return x * x * x; }, -1, 1).value
        == within(Fifty(0), 1e-49, "the odd parts cancel up to their rounding"));
}

TEST_CASE("endpoint singularities lose nothing when the distance is handed over")
{
  const auto arcsine = integrate_from_ends(
      [](const Fifty&, const Fifty& d) { return 1 / sqrt(abs(d) * (2 - abs(d))); }, -1, 1);
  CHECK(arcsine.value == within_relative(pi(), 1e-48, "a few hundred roundings"));
  const auto three_quarters = integrate_from_ends(
      [](const Fifty& x, const Fifty& d) { return pow(d < 0 ? -d : x, Fifty(-0.75)); }, 0, 1);
  CHECK(three_quarters.value == within_relative(Fifty(4), 1e-48, "x^-¾ loses 1e-50 beyond the last node"));
  const auto logarithm = integrate([](const Fifty& x) { return log(x); }, 0, 1);
  CHECK(logarithm.value == within_relative(Fifty(-1), 1e-47, "the last half digits of ln 0 are not seen"));
}

TEST_CASE("the sign of the distance tells the end, and its size is right")
{
  integrate_from_ends(
      [](const Fifty& x, const Fifty& d) {
        const Fifty end = d < 0 ? 2 : 5;
        CHECK(end - x == within(d, 1e-48, "x is rounded"));
        return Fifty(1);
      },
      2, 5);
}

TEST_CASE("an integral that does not settle is refused")
{
  const auto step = [](const Fifty& x) { return Fifty(x < Fifty("0.3") ? 0 : 1); };
  CHECK_THROWS_AS(integrate(step, 0, 1), std::runtime_error);
  const auto pole = [](const Fifty& x) { return 1 / (x - 0.5); };
  CHECK_THROWS_AS(integrate(pole, 0, 1), std::domain_error);
  const Fifty infinite = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(integrate([](const Fifty& x) { return exp(-x); }, 0, infinite), std::domain_error);
}

TEST_CASE("the mesh is halved nine times before an integral is refused")
{
  const auto peak = [](const char* width) {
    const Fifty w(width);
    return integrate([w](const Fifty& x) { return w / (x * x + w * w); }, -1, 1);
  };
  CHECK(peak("0.3").evaluations < 3000);  // eight times are enough
  const auto last = peak("0.1");
  CHECK(last.evaluations > 3000);
  CHECK(last.value == within_relative(2 * atan(Fifty(10)), 1e-48, "a few hundred roundings"));
  CHECK_THROWS_AS(peak("0.05"), std::runtime_error);
}

TEST_CASE("the reported error of an integral is larger than the true one")
{
  for(const char* tolerance : {"1e-5", "1e-12", "1e-25"})
  {
    CAPTURE(tolerance);
    const auto result = integrate([](const Fifty& x) { return exp(x); }, 0, 1, Fifty(tolerance));
    CHECK(abs(result.value - expm1(Fifty(1))) <= result.error);
    CHECK(result.error <= Fifty(tolerance) * 2);
  }
}

TEST_CASE("the pendulum returns after the period that the arithmetic-geometric mean gives")
{
  for(const char* zeta : {"0.001", "1", "3"})
  {
    CAPTURE(zeta);
    const Fifty quarter = quarter_period(Fifty(zeta));
    const auto bottom = solve(pendulum, 0, {Fifty(zeta), 0}, quarter);
    CHECK(bottom.y[0] == within(Fifty(0), 1e-30, "some ten steps of 1e-32 each"));
    CHECK(bottom.y[1] == within(-2 * sin(Fifty(zeta) / 2), 1e-30, "some ten steps of 1e-32 each"));
    const auto back = solve(pendulum, 0, {Fifty(zeta), 0}, 4 * quarter);
    CHECK(back.y[0]
          == within(Fifty(zeta), 1e-28, "at 3 rad a small error grows a hundredfold over a swing"));
  }
}

TEST_CASE("the reported error of a motion is larger than the true one")
{
  for(const char* tolerance : {"1e-8", "1e-16", "1e-24", "1e-32", "1e-40"})
  {
    CAPTURE(tolerance);
    const State nearest = {Fifty("0.4"), 0, 0, 2};  // of an orbit with the eccentricity 0.6
    const auto planet = solve(kepler, 0, nearest, 2 * pi(), Fifty(tolerance));
    const Fifty error = abs(planet.y[0] - Fifty("0.4")) + abs(planet.y[1]);
    CHECK(error <= planet.error);
    CHECK(planet.error <= Fifty(tolerance) * 10'000);
  }
}

TEST_CASE("time runs backwards and in legs")
{
  const auto there = solve(pendulum, 0, {1, 0}, {Fifty(1), Fifty(2)});
  REQUIRE(there.size() == 2);
  const auto direct = solve(pendulum, 0, {1, 0}, 2);
  CHECK(there[1].y[0] == within(direct.y[0], 1e-30, "two integrations to 1e-32"));
  const auto back = solve(pendulum, 2, there[1].y, 0);
  CHECK(back.y[0] == within(Fifty(1), 1e-30, "two integrations to 1e-32"));
  CHECK(solve(pendulum, 0, {1, 0}, 0).y[0] == 1);
  const auto earlier = solve(pendulum, Fifty(-0.5), {1, 0}, Fifty(1.5));
  CHECK(earlier.y[0] == within(direct.y[0], 1e-48, "the same steps, their ends rounded at other times"));
  CHECK(earlier.evaluations == direct.evaluations);
}

TEST_CASE("a motion into a singularity or with bad input is refused")
{
  const auto blow_up = [](const Fifty&, const State& y) { return State{y[0] * y[0]}; };
  CHECK_THROWS_AS(solve(blow_up, 0, {1}, 2), std::runtime_error);
  CHECK_THROWS_AS(solve(pendulum, 0, {1, 0}, 1, Fifty("1e-60")), std::invalid_argument);
  CHECK_THROWS_AS(solve(pendulum, 0, {1, 0}, 1, Fifty(1)), std::invalid_argument);
  CHECK_THROWS_AS(solve(pendulum, 0, {1 / Fifty(0), 0}, 1), std::invalid_argument);
  const auto short_answer = [](const Fifty&, const State&) { return State{1}; };
  CHECK_THROWS_AS(solve(short_answer, 0, {1, 0}, 1), std::invalid_argument);
}
