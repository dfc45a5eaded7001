/// @file
/// What the usual numerical ways make of Euler's equation: which of them lose, and how much.
#include "edition/compare.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/ways.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace exact;
using namespace tautochrone;
using edition::between;
using edition::within;

namespace
{

constexpr double degree = std::numbers::pi / 180;

double error(double got, double exactly)
{
  return std::abs(got - exactly);
}

}  // namespace

TEST_CASE("followed upwards from the exact place at 5° the curve is lost, the sooner the smaller the body")
{
  const auto lost = [](double k, double to) {
    const double from = 5 * degree;
    const double got = follow(k, from, at(Member::highest, k, from).r, to, 1e-13, Stepper::runge_kutta);
    return std::isnan(got) ? 1 : error(got, at(Member::highest, k, to).r);
  };
  CHECK(lost(0.3, 50 * degree)
        == between(1e-12, 1e-7, "a rounding grows by e^{(A(5°) − A(50°))/kk} and dies by the end"));
  CHECK(lost(0.1, 10 * degree) > 0.1);
  CHECK(lost(0.02, 6 * degree) > 0.1);
}

TEST_CASE(
    "followed downwards from the end it is as good as the tolerance, by explicit and by implicit steps")
{
  for(const double k : {0.1, 0.3, 0.7})
  {
    const Position last = end(Member::highest, k);
    const double phi = 0.3 * last.phi, exactly = at(Member::highest, k, phi).r;
    CHECK(error(follow(k, last.phi, last.r, phi, 1e-13, Stepper::runge_kutta), exactly) < 1e-12);
    CHECK(error(follow(k, last.phi, last.r, phi, 1e-8, Stepper::gear), exactly) < 1e-5);
    CHECK(error(follow(k, last.phi, last.r, phi, 1e-10, Stepper::adams), exactly) < 1e-7);
    CHECK(error(follow(k, last.phi, last.r, phi, 1e-12, Stepper::bulirsch_stoer), exactly) < 1e-11);
    const std::vector<double> angles{0.9 * last.phi, 0.5 * last.phi, phi};
    const std::vector<double> all = follow(k, last.phi, last.r, angles, 1e-13, Stepper::runge_kutta);
    for(std::size_t i = 0; i < angles.size(); ++i)
      CHECK(error(all[i], at(Member::highest, k, angles[i]).r) < 1e-12);
  }
}

TEST_CASE(
    "followed downwards from the end with 1e-13 a step the error is below 1e-13, for k down to 0.01 a")
{
  for(const double k : {0.01, 0.1, 0.3, 0.9})
    for(const double part : {0.01, 0.5, 0.99, 1.0})
    {
      const Position last = end(Member::highest, k);
      const double phi = part * last.phi * (1 - 1e-15);
      CHECK(follow(k, last.phi, last.r, phi, 1e-13, Stepper::runge_kutta)
            == within(highest(k, phi), 1e-13, "the stated error"));
    }
}

TEST_CASE("collocation converges with the outer value; without it more points make it worse")
{
  const double phi1 = 40 * degree;
  const std::vector<double> angles = {10 * degree, 20 * degree, 30 * degree};
  const auto worst = [&](double k, bool outer, int n) {
    const auto got = collocation(
        k, phi1, outer ? std::optional(at(Member::highest, k, phi1).r) : std::nullopt, n, angles);
    double most = 0;
    for(std::size_t i = 0; i < angles.size(); ++i)
      most = std::max(most, error(got[i], at(Member::highest, k, angles[i]).r));
    return most;
  };
  CHECK(worst(0.1, true, 24) < 1e-10);
  CHECK(worst(0.1, true, 48) < 1e-13);
  CHECK(worst(0.3, true, 64) < 1e-12);
  CHECK(worst(0.1, false, 16) < 1e-8);
  CHECK(worst(0.1, false, 64) > 100 * worst(0.1, false, 16));
  CHECK(worst(0.02, false, 48) < 1e-12);
}

TEST_CASE("nonsense is answered by no number")
{
  CHECK(std::isnan(follow(1.5, 0.5, 1, 0.2, 1e-10, Stepper::runge_kutta)));
  CHECK(std::isnan(follow(0.3, 0.5, 0.5, 0, 1e-10, Stepper::runge_kutta)));
  CHECK(std::isnan(follow(0.3, 0.5, 0.5, 0.2, 0, Stepper::gear)));
  CHECK(std::isnan(follow(0.3, 0.5, 0.5, {0.4, 2}, 1e-10, Stepper::adams)[0]));
  CHECK(follow(0.3, 0.5, 0.5, std::vector<double>{}, 1e-10, Stepper::adams).empty());
  CHECK(std::isnan(collocation(0.3, 0.5, {}, 1, {0.1})[0]));
  CHECK(std::isnan(collocation(0.0, 0.5, {}, 8, {0.1})[0]));
}
