/// @file
/// The globe's library: the equations of motion against Newton's laws; the time to the top against its integral.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "edition/compare.hpp"
#include "exact/quadrature.hpp"
#include "globe/ball.hpp"
#include "globe/energy.hpp"
#include "globe/gauss.hpp"
#include "globe/time.hpp"

using namespace globe;
using edition::within;
using edition::within_relative;
using edition::within_ulps;
using exact::Fifty;

namespace
{

/// Random numbers spread evenly in their logarithm from 10^-decades to 10^decades.
class Spread
{
public:
  explicit Spread(double decades) : exponent_(-decades, decades) {}
  double operator()() { return std::pow(10.0, exponent_(engine_)); }

private:
  std::mt19937_64 engine_{612};
  std::uniform_real_distribution<double> exponent_;
};

/// τ of Case II by the integral of §13 in v = sin ½Φ, its logarithm split off.
Fifty time_by_integral(const Fifty& c, const Fifty& k, const Fifty& omega)
{
  const auto rest = [&](const Fifty& v) {
    return 4 * c * c * v * v / (k + sqrt(k * k + 4 * c * c * v * v * (1 - v * v)));
  };
  return k * asinh(1 / tan(omega)) + exact::integrate(rest, 0, cos(omega)).value;
}

}  // namespace

TEST_CASE("the accelerations fulfil Euler's equations, whatever the friction")
{
  const Ball<Fifty> ball{1, Fifty("0.1"), Fifty("0.6")};
  const Fifty g("15.625"), Phi("1.1"), w("4");
  for(const char* ratio : {"0", "0.3", "-0.3", "1"})
  {
    const Fifty lambda(ratio);
    const auto [ddx, ddy, ddPhi, pressure] = accelerations(ball, g, Phi, w, lambda);
    const char* const because = "a dozen roundings of fifty digits, of numbers below 100";
    CHECK(ddx / (2 * g) == within(-lambda * pressure, 1e-46, because));
    CHECK(ddy / (2 * g) == within(pressure - 1, 1e-46, because));
    const Fifty moment = lambda * pressure * (ball.a - ball.c * cos(Phi)) - pressure * ball.c * sin(Phi);
    CHECK(ball.k * ball.k * ddPhi / (2 * g) == within(moment, 1e-46, because));
    CHECK(ddy == within(ball.c * ddPhi * sin(Phi) + ball.c * w * w * cos(Phi), 1e-46, because));
  }
}

TEST_CASE("below the stated friction the accelerations are determined at every angle")
{
  const Ball<double> ball{1, 0.9, 0.01};
  const double limit = 2 * ball.k / (ball.a + ball.c);
  for(double Phi = 0; Phi < 6.28; Phi += 1e-3)
    for(const double lambda : {-0.999 * limit, 0.999 * limit})
      CHECK(accelerations(ball, 15.625, Phi, 0.0, lambda).pressure > 0);
}

TEST_CASE("the time to the top is its integral, from a centred ball to a very eccentric one")
{
  for(const char* ratio : {"0", "1e-30", "0.01", "0.1666", "1", "3"})
    for(const char* angle : {"1e-20", "0.01", "0.7", "1.5"})
    {
      const Fifty c(ratio), k = 1, omega(angle);
      const Fifty time = time_by_integral(c, k, omega);
      CHECK(separatrix_time(c, k, omega) == within_relative(time, 1e-37, "the oracle's own bound"));
    }
}

TEST_CASE(
    "Euler's time to the top exceeds the time by less than the next term, and is good to 3 ulps in double")
{
  for(const double c : {1e-6, 0.01, 0.3, 2.0})
    for(const double omega : {1e-300, 1e-9, 0.3, 1.0, 1.5})
    {
      const Fifty euler = separatrix_time_by_euler<Fifty>(c, 1, omega);
      const Fifty time = separatrix_time<Fifty>(c, 1, omega);
      CHECK(time <= euler);
      CHECK(time >= euler + separatrix_next_term<Fifty>(c, 1, omega));
      CHECK(separatrix_time_by_euler(c, 1.0, omega) == within_ulps(euler, 3, "the stated error"));
      CHECK(separatrix_next_term(c, 1.0, omega)
            == within_ulps(separatrix_next_term<Fifty>(c, 1, omega), 16, "a dozen roundings"));
    }
}

TEST_CASE("our ball is the homogeneous one with its pellet")
{
  const auto [a, c, k, gap] = our_ball<Fifty>;
  const Fifty about_C = Fifty(4) / 5 * (Fifty(2) / 5) * a * a + Fifty(1) / 5 * (a / 2) * (a / 2);
  CHECK(c == within(Fifty(1) / 5 * a / 2, 1e-50, "one rounding"));
  CHECK(k * k == within(about_C - c * c, 1e-49, "a few roundings"));
}

TEST_CASE("the time to the top in double keeps what it promises")
{
  Spread spread(6);
  std::mt19937_64 engine(1787);
  std::uniform_real_distribution<double> exponent(-300, std::log10(1.5));
  double worst = 0;
  for(int i = 0; i < 500; ++i)
  {
    const double c = std::min(spread(), 1e6), k = 1, omega = std::pow(10.0, exponent(engine));
    worst = std::max(worst, exact::ulps(separatrix_time(c, k, omega), separatrix_time<Fifty>(c, k, omega)));
  }
  CHECK(worst <= 10);
  CHECK_THROWS_AS(separatrix_time(0.1, 0.6, 0.0), std::domain_error);
  CHECK_THROWS_AS(separatrix_time(0.1, 0.6, -0.1), std::domain_error);
  CHECK_THROWS_AS(separatrix_time(0.1, 0.6, 1.6), std::domain_error);
  CHECK_THROWS_AS(separatrix_time(0.1, 0.0, 0.7), std::domain_error);
  CHECK_THROWS_AS(separatrix_time(-0.1, 0.6, 0.7), std::domain_error);
  CHECK_THROWS_AS(separatrix_time(1e7, 0.6, 0.7), std::domain_error);
  CHECK_THROWS_AS(separatrix_time(std::nan(""), 0.6, 0.7), std::domain_error);
}

TEST_CASE("the angle at a time has that time")
{
  for(const double c : {0.0, 0.1, 1.0, 100.0})
    for(const double tau : {1e-3, 0.5, 3.0, 40.0, 600.0})
    {
      const double omega = separatrix_angle(c, 1.0, tau);
      const double last_place = std::nextafter(omega, 2.0) - omega;
      const double blur = last_place * std::hypot(1.0, c * std::sin(2 * omega)) / std::sin(omega);
      CHECK(separatrix_time(c, 1.0, omega)
            == within(tau, 5e-15 * tau + blur, "20 ulps and the last place of ω"));
    }
  CHECK(separatrix_angle(0.1, 0.6, 0.0) == within_ulps(exact::pi() / 2, 1, "an arc tangent"));
  CHECK_THROWS_AS(separatrix_angle(0.1, 0.6, -1.0), std::domain_error);
  CHECK_THROWS_AS(separatrix_angle(0.1, 0.6, 690 * 0.6), std::domain_error);
  CHECK_THROWS_AS(separatrix_angle(0.1, 0.0, 1.0), std::domain_error);
  CHECK_THROWS_AS(separatrix_angle(0.1, 0.6, std::nan("")), std::domain_error);
}

TEST_CASE(
    "whether the ball gets to a place is known to 45 digits, and to as many of what is lacking of the top")
{
  const Fifty right = exact::pi() / 2;
  const Energy<Fifty> half = energy(Fifty(1) / 2), top = energy_from_top(Fifty("1e-300"));
  CHECK(left_for_motion(half, place(right)) == 0);
  CHECK(gets_to(half, place(Fifty(right - Fifty("1e-40")))));
  CHECK(left_for_motion(half, place(Fifty(right - Fifty("1e-40")))) > 0);
  CHECK_FALSE(gets_to(half, place(Fifty(right + Fifty("1e-40")))));
  CHECK(gets_to(top, place_from_top(Fifty("3e-150"))));
  CHECK_FALSE(gets_to(top, place_from_top(Fifty("1e-150"))));
  CHECK(gets_to(energy(Fifty(1)), place_from_top(Fifty(0))));
}

TEST_CASE("a Gauss rule is exact below twice its nodes, and not at it")
{
  const Gauss four(4);
  const auto power = [](int n) { return [n](double x) { return std::pow(x, n); }; };
  CHECK(four(power(7), 0, 1) == within_ulps(0.125, 4, "four rounded products"));
  CHECK(std::abs(four(power(8), 0, 1) - 1.0 / 9) > 1e-6);
  CHECK_THROWS_AS(Gauss(0), std::invalid_argument);
}
