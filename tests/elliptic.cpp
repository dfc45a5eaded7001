/// @file
/// Carlson's integrals against closed values, their defining integrals, fifty digits and GSL, over all doubles.
#include <doctest/doctest.h>
#include <gsl/gsl_sf_ellint.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "edition/compare.hpp"
#include "elliptic/carlson.hpp"
#include "exact/quadrature.hpp"

using namespace elliptic;
using edition::within_relative;
using edition::within_ulps;
using exact::Fifty;

namespace
{

constexpr double smallest = 5e-324, largest = std::numeric_limits<double>::max();

/// Random numbers spread evenly in their logarithm from 10^-decades to 10^decades, kept within the doubles.
class Spread
{
public:
  explicit Spread(double decades) : exponent_(-decades, decades) {}
  double operator()() { return std::clamp(std::pow(10.0, exponent_(engine_)), smallest, largest); }

private:
  std::mt19937_64 engine_{612};
  std::uniform_real_distribution<double> exponent_;
};

/// ∫₀^∞ f(t) dt with t = u/(1−u); `f` decays at least as t^(-3/2).
Fifty to_infinity(const std::function<Fifty(const Fifty&)>& f)
{
  const auto folded = [&](const Fifty& u, const Fifty& to_end) {
    const Fifty rest = to_end > 0 ? to_end : 1 - u;
    const Fifty t = (to_end > 0 ? u : -to_end) / rest;
    return f(t) / (rest * rest);
  };
  return exact::integrate_from_ends(folded, 0, 1).value;
}

struct Worst
{
  double C = 0, F = 0, D = 0, J = 0, together = 0;

  void look_at(double x, double y, double z, double p);
};

void Worst::look_at(double x, double y, double z, double p)
{
  const Fifty X = x, Y = y, Z = z, P = p;
  const Fifty F = R_F(X, Y, Z), J = R_J(X, Y, Z, P);
  C = std::max(C, exact::ulps(R_C(x, y), R_C(X, Y)));
  this->F = std::max(this->F, exact::ulps(R_F(x, y, z), F));
  D = std::max(D, exact::ulps(R_D(x, y, z), R_D(X, Y, Z)));
  this->J = std::max(this->J, exact::ulps(R_J(x, y, z, p), J));
  const auto both = R_F_and_J(x, y, z, p);
  together = std::max({together, exact::ulps(both.F, F), exact::ulps(both.J, J)});
}

Worst worst_over(double decades, int samples)
{
  Spread spread(decades);
  Worst worst;
  for(int i = 0; i < samples; ++i)
  {
    const double x = spread(), y = spread(), z = spread(), p = spread();
    worst.look_at(x, y, z, p);
  }
  return worst;
}

}  // namespace

TEST_CASE("Carlson's integrals have the lemniscate's closed values")
{
  const Fifty two_pi = 2 * exact::pi();
  const Fifty quarter = pow(tgamma(Fifty(0.25)), 2) / (4 * sqrt(two_pi));
  CHECK(R_F<Fifty>(0, 1, 2) == within_relative(quarter, 1e-48, "a few steps of fifty digits"));
  const Fifty b = pow(tgamma(Fifty(0.75)), 2) / sqrt(two_pi);
  CHECK(R_D<Fifty>(0, 2, 1) == within_relative(3 * b, 1e-48, "a few steps of fifty digits"));
}

TEST_CASE("Carlson's integrals are what they are defined to be")
{
  for(const Fifty& x : {Fifty(0.25), Fifty(40), Fifty(1e-3)})
  {
    const Fifty y = 1, z = 3;
    const char* const because = "the oracle's own bound";
    const auto root = [&](const Fifty& t) { return sqrt((t + x) * (t + y) * (t + z)); };
    const Fifty first = to_infinity([&](const Fifty& t) { return 1 / (2 * root(t)); });
    CHECK(R_F(x, y, z) == within_relative(first, 1e-36, because));
    for(const double p : {1e-3, 0.25, 2.0, 50.0, 1e4})
    {
      const Fifty third = to_infinity([&](const Fifty& t) { return Fifty(1.5) / ((t + p) * root(t)); });
      CHECK(R_J(x, y, z, Fifty(p)) == within_relative(third, 1e-36, because));
      const Fifty elementary = to_infinity([&](const Fifty& t) { return 1 / (2 * (t + p) * sqrt(t + x)); });
      CHECK(R_C(x, Fifty(p)) == within_relative(elementary, 1e-36, because));
    }
    CHECK(R_D(x, y, z) == within_relative(R_J(x, y, z, z), 1e-48, "two ways, of fifty digits"));
  }
}

TEST_CASE("where the arcs of the steps add up to many turns none is lost")
{
  // By R_J(x, y, y, p) = 3 (R_C(x, y) − R_C(x, p))/(p − y).
  for(const double p : {2.0, 30.0, 1e3, 1e6, 1e12, 1e30})
    for(const double x : {1e-30, 1e-6, 1.0, 1e6, 0.4 * p})
    {
      const Fifty X = x, y = 1e-5, P = p;
      const Fifty closed = 3 * (R_C(X, y) - R_C(X, P)) / (P - y);
      CHECK(R_J(X, y, y, P) == within_relative(closed, 1e-42, "the difference keeps as many digits"));
      CHECK(R_J(x, 1e-5, 1e-5, p) == within_ulps(R_J(X, Fifty(1e-5), Fifty(1e-5), P), 3, "the bound"));
      CHECK(R_F_and_J(x, 1e-5, 1e-5, p).J
            == within_ulps(R_J(X, Fifty(1e-5), Fifty(1e-5), P), 8, "the bound"));
    }
}

TEST_CASE("Carlson's integrals in double keep what they promise")
{
  const Worst worst = worst_over(6, 5000);
  CHECK(worst.C <= 4);
  CHECK(worst.F <= 3);
  CHECK(worst.D <= 3);
  CHECK(worst.J <= 3);
  CHECK(worst.together <= 8);
}

TEST_CASE("they keep it where some arguments nearly agree, agree, or are 0")
{
  Spread spread(6), apart(4);
  Worst worst;
  for(int i = 0; i < 3000; ++i)
  {
    const double x = spread();
    const auto near = [&] { return x * (1 + 1e-6 * apart()); };  // by a part in 10¹⁰ to 10²
    double y = near(), z = near(), p = i % 3 == 0 ? spread() : near();
    if(i % 5 == 0)
      y = x;
    if(i % 7 == 0)
      p = z;
    worst.look_at(i % 11 == 0 ? 0 : x, y, z, p);
  }
  CHECK(worst.F <= 3);
  CHECK(worst.D <= 3);
  CHECK(worst.J <= 3);
  CHECK(worst.together <= 8);
}

TEST_CASE("Carlson's integrals in double are right for any mixture of doubles")
{
  for(const double decades : {30.0, 90.0, 150.0, 323.0})
  {
    const Worst worst = worst_over(decades, 500);
    CHECK(worst.C <= 4);
    CHECK(worst.F <= 3);
    CHECK(worst.D <= (decades < 100 ? 3 : 4));
    CHECK(worst.J <= 3);
    CHECK(worst.together <= 8);
  }
}

TEST_CASE("the ends of the doubles are no ends of Carlson's integrals")
{
  for(const double x : {smallest, 1e-323, 2.2e-308, 1.0, 1e308, largest})
    for(const double y : {smallest, 3e-320, 1.0, 1e308, largest})
      for(const double z : {smallest, 1e-310, 1.0, largest})
      {
        const Fifty X = x, Y = y, Z = z;
        CHECK(R_F(x, y, z) == within_ulps(R_F(X, Y, Z), 3, "the bound"));
        CHECK(R_F(0.0, y, z) == within_ulps(R_F(Fifty(0), Y, Z), 3, "the bound"));
        CHECK(R_C(x, y) == within_ulps(R_C(X, Y), 4, "the bound"));
        CHECK(exact::ulps(R_D(x, y, z), R_D(X, Y, Z)) <= 4);
        CHECK(exact::ulps(R_J(x, y, z, y), R_J(X, Y, Z, Y)) <= 4);
      }
  CHECK(R_F(1e308, 1e308, 1e308) == within_ulps(1e-154, 1, "one over a root"));
  CHECK(R_F(5e-324, 5e-324, 1e-323)
        == within_ulps(R_F(Fifty(5e-324), Fifty(5e-324), Fifty(1e-323)), 4, "the bound"));
  CHECK(R_D(smallest, smallest, smallest) == std::numeric_limits<double>::infinity());
  CHECK(R_J(largest, largest, largest, largest) == 0);
}

TEST_CASE("Carlson's integrals agree with GSL's")
{
  Spread spread(2);
  for(int i = 0; i < 100; ++i)
  {
    const double x = spread(), y = spread(), z = spread(), p = spread();
    const char* const because = "GSL stops its series at 10⁻³ of spread and sums a few hundred roundings";
    CHECK(R_F(x, y, z) == within_relative(gsl_sf_ellint_RF(x, y, z, GSL_PREC_DOUBLE), 2e-14, because));
    CHECK(R_D(x, y, z) == within_relative(gsl_sf_ellint_RD(x, y, z, GSL_PREC_DOUBLE), 2e-14, because));
    CHECK(R_J(x, y, z, p)
          == within_relative(gsl_sf_ellint_RJ(x, y, z, p, GSL_PREC_DOUBLE), 2e-14, because));
  }
}

TEST_CASE("arrays have the bits of single numbers, and NaN where those throw")
{
  Spread spread(100);
  std::vector<double> x, y, z, p;
  for(int i = 0; i < 300; ++i)
    for(std::vector<double>* v : {&x, &y, &z, &p})
      v->push_back(spread());
  x[7] = -1;
  p[8] = std::nan("");
  std::vector<double> C(300), F(300), D(300), J(300);
  R_C(x, y, C);
  R_F(x, y, z, F);
  R_D(x, y, z, D);
  R_J(x, y, z, p, J);
  for(std::size_t i = 0; i < 300; ++i)
  {
    if(i == 7)
    {
      CHECK((std::isnan(C[i]) && std::isnan(F[i]) && std::isnan(D[i]) && std::isnan(J[i])));
      continue;
    }
    CHECK(C[i] == R_C(x[i], y[i]));
    CHECK(F[i] == R_F(x[i], y[i], z[i]));
    CHECK(D[i] == R_D(x[i], y[i], z[i]));
    CHECK((i == 8 ? std::isnan(J[i]) : J[i] == R_J(x[i], y[i], z[i], p[i])));
  }
  F.pop_back();
  CHECK_THROWS_AS(R_F(x, y, z, F), std::invalid_argument);
}

TEST_CASE("Carlson's integrals refuse what they are not defined for")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(R_F(-1.0, 1.0, 1.0), std::domain_error);
  CHECK_THROWS_AS(R_F(0.0, 0.0, 1.0), std::domain_error);
  CHECK_THROWS_AS(R_F(nan, 1.0, 1.0), std::domain_error);
  CHECK_THROWS_WITH_AS(R_F(1.0, 1.0, infinite), "Carlson's integrals: all arguments must be finite",
                       std::domain_error);
  CHECK_THROWS_AS(R_J(1.0, 2.0, 3.0, 0.0), std::domain_error);
  CHECK_THROWS_AS(R_J(1.0, 2.0, 3.0, -1.0), std::domain_error);
  CHECK_THROWS_AS(R_J(1.0, 2.0, 3.0, nan), std::domain_error);
  CHECK_THROWS_AS(R_J(0.0, 0.0, 3.0, 1.0), std::domain_error);
  CHECK_THROWS_AS(R_D(1.0, 2.0, 0.0), std::domain_error);
  CHECK_THROWS_AS(R_C(1.0, 0.0), std::domain_error);
  CHECK_THROWS_AS(R_C(-1.0, 1.0), std::domain_error);
}
