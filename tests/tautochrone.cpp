/// @file
/// The tautochrone of compound pendulums: Euler's expansion and the exact curve by routes that share
/// nothing.
#include "edition/compare.hpp"
#include "exact/ode.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace exact;
using namespace tautochrone;
using edition::within;
using edition::within_relative;

namespace
{

// The height that §25 asks of a tautochrone: 2ax (kk + rr) = (aa + kk) rr sin²φ.
Fifty height(const Fifty& k, const Fifty& phi, const Fifty& r)
{
  return (1 + k * k) * r * r * sin(phi) * sin(phi) / (2 * (k * k + r * r));
}

}  // namespace

TEST_CASE("the coefficients satisfy the equation to their order, in whole numbers")
{
  const auto r_n = corrections<Rational>(6);
  const Expansion r(r_n, 6);
  std::vector<Powers> dr_sin;
  for(const Powers& coefficient : r_n)
    dr_sin.push_back(slope_times_sine(coefficient));
  const Expansion cos(Powers(1, 1));
  CHECK(equation<Expansion>(1, Expansion::x(), r, Expansion(dr_sin, 6), cos) == Expansion({Powers(0)}, 6));
  for(const Powers& coefficient : r_n)
    for(int n = coefficient.lowest(); n <= coefficient.highest(); ++n)
      CHECK(coefficient[n].denominator() == "1");
}

TEST_CASE("fractions and fifty digits give the same coefficients")
{
  const auto exactly = corrections<Rational>(8);
  const auto nearly = corrections<Fifty>(8);
  for(std::size_t i = 0; i < exactly.size(); ++i)
    for(int n = exactly[i].lowest(); n <= exactly[i].highest(); ++n)
      CHECK(nearly[i][n] == static_cast<Fifty>(exactly[i][n]));
}

TEST_CASE("the curve's end is the highest point that any tautochrone reaches")
{
  for(const char* text : {"0.02", "0.3", "0.7", "0.999"})
  {
    const Fifty k(text);
    const Point end = highest_end(k);
    CHECK(end.x == within_relative(height(k, end.phi, end.r), 1e-48, "some ten roundings"));
    CHECK(slope(end.phi, end.r, k) == within(Fifty(0), 1e-45, "a rounded zero over k⁴"));
    for(const double nearby : {-1e-9, 1e-9})  // of the other ends, at the radius r, none is higher
    {
      const Fifty r = end.r * (1 + nearby);
      const Fifty phi = acos((k * k + r * r) / ((1 + k * k) * r));
      CHECK(height(k, phi, r) < end.x);
    }
  }
}

TEST_CASE("the curve agrees with the flow on a sphere that has neither a singularity nor a sine")
{
  // X = cos φ, Y = r sin φ/√(kk + rr), Z = k sin φ/√(kk + rr), with f = a + kk/a:
  // dX = −ZZ, dY = (k/f) Z, dZ = XZ − (k/f) Y on X² + Y² + Z² = 1.
  for(const char* text : {"0.05", "0.3", "0.8"})
  {
    const Fifty k(text);
    const Fifty turn = k / (1 + k * k);
    const Point end = highest_end(k);
    const Fifty length = sqrt(k * k + end.r * end.r);
    const State start = {cos(end.phi), end.r * sin(end.phi) / length, k * sin(end.phi) / length};
    const auto flow = [&](const Fifty&, const State& p) {
      return State{-p[2] * p[2], turn * p[2], p[0] * p[2] - turn * p[1]};
    };
    for(const Solution& at : solve(flow, 0, start, {Fifty(-0.25), Fifty(-1), Fifty(-3)}))
    {
      const Fifty phi = atan2(hypot(at.y[1], at.y[2]), at.y[0]);
      const Fifty r = k * at.y[1] / at.y[2];
      CHECK(highest(k, phi) == within_relative(r, 1e-28, "the stated error"));
    }
  }
}

TEST_CASE("the height is the one that equal times ask for")
{
  for(const char* text : {"0.1", "0.3", "0.7"})
  {
    const Fifty k(text);
    const Point end = highest_end(k);
    const auto right_side = [&](const Fifty& phi, const State& y) {
      return State{slope(phi, y[0], k), y[0] * sin(phi)};
    };
    for(const double part : {0.9, 0.5, 0.1})
    {
      const Fifty phi = end.phi * part;
      const State y = solve(right_side, end.phi, {end.r, end.x}, phi).y;
      CHECK(y[1] == within(height(k, phi, y[0]), 1e-29, "some fifty steps of 1e-32 each"));
    }
  }
}

TEST_CASE("another curve through the same lowest point has the height of equal times, too")
{
  const Fifty k("0.3");
  const Fifty phi = Fifty(40) * pi() / 180;
  const Fifty half = (1 + k * k) * cos(phi) / 2;
  const Fifty r = half + sqrt(half * half - k * k);  // dr = 0: it ends here, long before the highest
  const auto right_side = [&](const Fifty& at, const State& y) {
    return State{slope(at, y[0], k), y[0] * sin(at)};
  };
  const auto down = solve(right_side, phi, {r, height(k, phi, r)}, {phi / 2, phi / 100, phi / 10'000});
  CHECK(abs(down[0].y[0] - highest(k, phi / 2)) > 1e-3);
  CHECK(down[1].y[1]
        == within(height(k, phi / 100, down[1].y[0]), 1e-29, "some fifty steps of 1e-32 each"));
  CHECK(down[2].y[0] == within(Fifty(1), 1e-7, "near the vertical 1 - r is 0.75 φφ, and φ is 7e-5"));
}

TEST_CASE("all swings on it take the same time, by the integral of §19 with heights from the geometry")
{
  const Fifty k("0.3");
  const Point end = highest_end(k);
  const auto right_side = [&](const Fifty& phi, const State& y) {
    return State{slope(phi, y[0], k), y[0] * sin(phi)};
  };
  for(const char* part : {"0.2", "0.6", "1"})
  {
    constexpr int nodes = 24;  // of the midpoint rule after φ = φ₀ sin α, from the widest angle down
    std::vector<Fifty> angles = {end.phi * Fifty(part)};
    for(int i = nodes; i-- > 0;)
      angles.push_back(angles[0] * sin((i + Fifty(0.5)) * pi() / (2 * nodes)));
    const auto at = solve(right_side, end.phi, {end.r, end.x}, angles, Fifty("1e-16"));
    Fifty sum;
    for(std::size_t i = 1; i < at.size(); ++i)
    {
      const Fifty& r = at[i].y[0];
      const Fifty to_fall = at[0].y[1] - at[i].y[1];
      sum += sqrt((angles[0] * angles[0] - angles[i] * angles[i]) * (k * k + r * r) / to_fall) / nodes;
    }
    CHECK(sum / sqrt(2 * (1 + k * k)) == within(Fifty(1), 1e-7, "24 nodes, near the end of the curve"));
  }
}

TEST_CASE("small k takes no longer and agrees with Euler's series at its best")
{
  for(const char* text : {"0.02", "1e-3", "1e-9"})
  {
    const Fifty k(text);
    const Fifty phi("0.8");
    const auto series = truncated(12, k);
    CHECK(highest(k, phi) == within(series(cos(phi)), 1e-18, "at 0.02 the term 13 is below 1e-18"));
  }
}

TEST_CASE("many angles at once are the same as each alone")
{
  const Fifty k("0.05");
  const std::vector<Fifty> angles = {0, Fifty("0.01"), Fifty("0.5"), Fifty("1.2"), highest_end(k).phi};
  const auto radii = highest(k, angles);
  CHECK(radii.front() == 1);
  CHECK(radii.back() == highest_end(k).r);
  for(std::size_t i = 0; i < angles.size(); ++i)
    CHECK(radii[i] == within(highest(k, angles[i]), 1e-28, "the stated error"));
}

TEST_CASE("the circle and the cycloid keep the times that are known of them")
{
  const Fifty phi0 = pi() / 2 - Fifty("0.5");
  CHECK(excess(truncated(0, 0), 0, phi0) == within(Fifty(0), 1e-25, "Huygens: all swings alike"));
  Fifty a = 1;
  Fifty b = cos(phi0 / 2);
  while(abs(a - b) > Fifty("1e-45"))
  {
    const Fifty mean = (a + b) / 2;
    b = sqrt(a * b);
    a = mean;
  }
  const Laurent<Fifty> circle(1);
  CHECK(excess(circle, 0, phi0) == within(1 / a - 1, 1e-25, "Gauss: the mean of 1 and cos ½φ₀"));
  CHECK(excess(circle, Fifty("0.3"), phi0) == within(1 / a - 1, 1e-25, "a fixed axis needs no small k"));
}

TEST_CASE("a derivative by phi times a sine is what differences say")
{
  const Laurent<Fifty> p = truncated(2, Fifty("0.3"));
  const Fifty phi("0.7");
  const Fifty h("1e-16");
  const Fifty difference = (p(cos(phi + h)) - p(cos(phi - h))) / (2 * h) * sin(phi);
  CHECK(slope_times_sine(p)(cos(phi)) == within(difference, 1e-29, "h² and 50 digits over h"));
}

TEST_CASE("Euler's radius is the truncated expansion, and in double good to a few ulps")
{
  const double a = 0.7;
  for(const double k : {1e-3, 0.05, 0.3})
    for(const double phi : {0.0, 1e-9, 0.4, -0.4, 1.0})
    {
      const Fifty exactly = a * truncated(2, Fifty(k) / a)(cos(Fifty(phi)));
      CHECK(radius<Fifty>(a, k, phi) == within(exactly, 1e-46, "some dozen roundings"));
      const double largest = std::max(a, 6 * std::pow(k, 4) / std::pow(a, 3) / std::pow(std::cos(phi), 7));
      CHECK(radius(a, k, phi) == within(exactly, 4 * 2.2e-16 * largest, "4 ulps of the largest term"));
      CHECK(
          truncated_in_double(2, Fifty(k))(std::cos(phi))
          == within(truncated(2, k)(cos(Fifty(phi))), 8 * 2.2e-16 * std::pow(std::cos(phi), -7), "a sum"));
    }
}

TEST_CASE("with n corrections a small swing is longer by ¼ φ₀² (3κ)ⁿ κ/(1 + κ), where κ = kk/aa")
{
  const Fifty amplitude("1e-3"), kappa("0.01");
  for(int n = 0; n <= 3; ++n)
    CHECK(excess(truncated(n, sqrt(kappa)), sqrt(kappa), amplitude) / pow(amplitude, 2)
          == within_relative(pow(3 * kappa, n) * kappa / (4 * (1 + kappa)), 2e-5,
                             "the next power of the amplitude, 10⁻⁶, has a coefficient below 20"));
}

TEST_CASE("what is no pendulum on cheeks is refused")
{
  CHECK_THROWS_AS(highest_end(0), std::domain_error);
  CHECK_THROWS_AS(highest_end(1), std::domain_error);
  CHECK_THROWS_AS(highest(Fifty("1e-10"), Fifty(1)), std::domain_error);
  CHECK_THROWS_AS(highest(Fifty("0.3"), Fifty(1)), std::domain_error);  // the curve ends before
  CHECK_THROWS_AS(highest(Fifty("0.3"), Fifty(-1)), std::domain_error);
  CHECK_THROWS_AS(highest(Fifty("0.3"), {Fifty("0.5"), Fifty("0.4")}), std::domain_error);
  CHECK_THROWS_AS(corrections<Rational>(-1), std::domain_error);
  CHECK_THROWS_AS(excess(truncated(0, 0), 0, 2), std::domain_error);
  CHECK(isnan(excess(truncated(2, Fifty("0.3")), Fifty("0.3"), Fifty(1))));  // it has turned back
}
