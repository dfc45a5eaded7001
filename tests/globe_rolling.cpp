/// @file
/// The rolling ball: its times against the equations of motion and numbers found by other tools, and in double
/// against fifty digits; the friction it needs, what the plane bears, and how far that goes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "edition/compare.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "globe/oracle.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"

using namespace globe;
using edition::within;
using edition::within_relative;
using edition::within_ulps;
using exact::Fifty;

namespace
{

const Ball<Fifty> exact_ball = our_ball<Fifty>;
const Ball<double> ball = our_ball<double>;
const Fifty radian = 180 / exact::pi();
const char* const other_tools = "two independent tools agree to so many digits";
const char* const bound = "the stated bound";

/// The quarter by §29's integral with sin ½Φ = √h sin θ.
Fifty quarter_by_integral(const Ball<Fifty>& b, const Fifty& h)
{
  const auto f = [&](const Fifty& theta) {
    const Fifty ss = h * sin(theta) * sin(theta);
    return sqrt((bb(b) + 4 * b.a * b.c * ss) / (1 - ss));
  };
  return exact::integrate(f, 0, exact::pi() / 2).value;
}

/// By §25's equation.
exact::State by_motion(const Ball<Fifty>& b, const Fifty& h, const Fifty& tau)
{
  const Fifty g = 1 / (2 * b.c);  // then t is τ
  const auto motion = [&](const Fifty&, const exact::State& s) {
    const Fifty D = b.a * b.a + b.c * b.c + b.k * b.k - 2 * b.a * b.c * cos(s[0]);
    return exact::State{s[1], -(2 * b.c * g + b.a * b.c * s[1] * s[1]) * sin(s[0]) / D};
  };
  return exact::solve(motion, 0, {0, 2 * sqrt(h / bb(b))}, tau).y;
}

}  // namespace

TEST_CASE("one formula is the time of the equation of motion, rocking, turning over and between")
{
  for(const char* text : {"0.5", "1", "1.001", "3"})
  {
    const Fifty h(text), tau("0.9");
    const Fifty Phi = by_motion(exact_ball, h, tau)[0];
    CHECK(rolling::time(exact_ball, energy(h), place(Phi))
          == within_relative(tau, 1e-27, "steps of 1e-32"));
  }
  for(const char* text : {"1e-9", "0.25", "0.9"})
    CHECK(
        rolling::quarter(exact_ball, energy(Fifty(text)))
        == within_relative(quarter_by_integral(exact_ball, Fifty(text)), 1e-37, "the oracle's own bound"));
}

TEST_CASE("times are what other tools found")
{
  const auto at = [](const char* h, const char* Phi) {
    return rolling::time(exact_ball, energy(Fifty(h)), place(Fifty(Phi)));
  };
  CHECK(at("0.3", "1") == within_relative(Fifty("1.231242449645377505603665825"), 1e-27, other_tools));
  CHECK(at("1", "2") == within_relative(Fifty("1.394767102168858123617766703"), 1e-27, other_tools));
  CHECK(at("3", "3") == within_relative(Fifty("1.111804480279011492054693660"), 1e-27, other_tools));
  CHECK(rolling::quarter(exact_ball, energy(Fifty(3)))
        == within_relative(Fifty("1.174490713232687733973599916"), 1e-27, other_tools));
  CHECK(rolling::quarter(exact_ball, energy(Fifty(0.5)))
        == within_relative(Fifty("2.095703618244633653816115934"), 1e-27, other_tools));
  CHECK(rolling::quarter(ball, energy_from_top(1e-15))
        == within_ulps(Fifty("23.2083049154510469738737272306"), 8, bound));
  CHECK(rolling::quarter(ball, energy_from_top(-1e-15))
        == within_ulps(Fifty("23.2083049154510388217431635046"), 8, bound));
  // One turn with c = 1e-12 and ζ = 3, where h is 8e11: a little more than ⅔π seconds.
  const Ball<Fifty> centred{1, Fifty("1e-12"), Fifty("0.6")};
  const Fifty g = our_g<Fifty>;
  const Energy<Fifty> fast = energy_of_velocity<Fifty>(centred.c, bb(centred), g, 3);
  const Fifty turn = 2 * rolling::quarter(centred, fast) / sqrt(2 * g * centred.c);
  CHECK(turn == within_relative(Fifty("2.09439510240008269842541322417"), 1e-29, other_tools));
  CHECK(turn / (2 * exact::pi() / 3) - 1
        == within_relative(Fifty("3.288398692832370099541218e-12"), 1e-17, "what the digits leave"));
}

TEST_CASE("in double times keep what they promise, from the smallest swing to the fastest turning")
{
  double worst = 0, worst_excess = 0, worst_on_the_way = 0;
  for(const Ball<double>& b :
      {ball, cradle<double>, Ball<double>{1, 1e-12, 0.6}, Ball<double>{1, 1, 1e-8},
       Ball<double>{1, 0.999, 1e-3}, Ball<double>{1, 5, 2}, Ball<double>{1, 1e-300, 0.6}})
    for(const double below : {1.0, 0.9999, 0.5, 0.1, 1e-3, 1e-6, 1e-15, 1e-40, 1e-300, -1e-300, -1e-15,
                              -1e-9, -1e-3, -0.5, -3.0, -1e3, -1e16})
    {
      const Energy<double> e = energy_from_top(below);
      const Energy<Fifty> exact_e{1 - Fifty(below), below};
      const Fifty exact = rolling::quarter(exactly(b), exact_e);
      worst = std::max(worst, exact::ulps(rolling::quarter(b, e), exact));
      if(below > 0.4 && below < 1)
      {
        const Fifty excess = exact / (exact::pi() / 2 * sqrt(bb(exactly(b)))) - 1;
        worst_excess = std::max(worst_excess, exact::ulps(rolling::excess(b, e), excess));
      }
      if(below == 1)
        continue;
      for(const double part : {1e-12, 0.3, 0.7})
      {
        const double Phi = part * (below > 0 ? 2 * std::asin(std::sqrt(1 - below)) : std::numbers::pi);
        const Place<double> there = place(Phi);
        const Place<Fifty> exact_there{there.s, sqrt(1 - Fifty(there.s) * Fifty(there.s))};
        worst_on_the_way =
            std::max(worst_on_the_way, exact::ulps(rolling::time(b, e, there),
                                                   rolling::time(exactly(b), exact_e, exact_there)));
      }
    }
  CHECK(worst <= 8);
  CHECK(worst_excess <= 10);
  CHECK(worst_on_the_way <= 8);
  CHECK(rolling::excess(ball, energy(1e-20))
        == within_relative(Fifty("3.35470085470085470087142059774e-21"), 1e-15, bound));
  CHECK(rolling::quarter(ball, energy(1.0)) == std::numeric_limits<double>::infinity());
}

TEST_CASE("the means that give a whole quarter are right for every ball and all the way to the top")
{
  double worst = 0;
  int step = 0;
  for(const double c : {1e-9, 1e-4, 0.03, 0.5, 0.99, 3.0, 1e3})
    for(const double k : {1e-12, 1e-5, 0.2, 1.0, 40.0})
      for(double below = 0.97; below > 1e-30; below *= 0.31, ++step)
      {
        const Ball<double> b{1, c * (1 + 0.01 * (step % 7)), k};
        for(const double lacks : {below, -below, -1 / below})
        {
          const Energy<double> e = energy_from_top(lacks);
          const Fifty exact = rolling::quarter(exactly(b), {1 - Fifty(lacks), lacks});
          worst = std::max(worst, exact::ulps(rolling::quarter(b, e), exact));
        }
      }
  MESSAGE("worst of ", 3 * step, " quarters: ", worst, " ulps");
  CHECK(worst <= 8);
  // where q is 10⁴⁰, nearly the greatest that is allowed, and next to no energy or all of it is missing
  const Ball<double> thin{1, 1, 2e-20};
  for(const double below : {1 - 0x1p-53, 0.5, 1e-300, 5e-324, -5e-324, -1e300})
    CHECK(rolling::quarter(thin, energy_from_top(below))
          == within_ulps(rolling::quarter(exactly(thin), {1 - Fifty(below), below}), 8, bound));
}

TEST_CASE(
    "the formula and the quadrature that judges it agree, in every regime, and its inverse comes back")
{
  for(const Ball<Fifty>& b :
      {exact_ball, cradle<Fifty>, Ball<Fifty>{1, 1, Fifty("1e-5")}, Ball<Fifty>{2, 7, 1}})
    for(const char* below : {"0.9999999999", "0.3", "1e-12", "1e-60", "0", "-1e-20", "-0.5", "-1e8"})
    {
      const Energy<Fifty> e{1 - Fifty(below), Fifty(below)};
      const Place<Fifty> there = place(e.h < 0.5 ? Fifty(sqrt(e.h)) : Fifty("1.1"));
      const Fifty time = rolling::time(b, e, there);
      CHECK(oracle::rolling_time(b, e, there) == within_relative(time, 1e-34, "the judge's bound"));
      if(e.from_top != 0)
        CHECK(oracle::rolling_quarter(b, e)
              == within_relative(rolling::quarter(b, e), 1e-34, "the judge's bound"));
      CHECK(oracle::rolling_place(b, e, time).s
            == within_relative(there.s, 1e-25, "one step of Newton's method"));
    }
  CHECK(oracle::rolling_quarter(exact_ball, energy(Fifty(1))) == edition::infinite("the top"));
}

TEST_CASE("with the centre of gravity all but on the rim the bottom costs no digits")
{
  const Ball<Fifty> rim{1, 1, Fifty("1e-8")};
  const Fifty time = rolling::quarter(rim, energy(Fifty(0.5)));
  // As k vanishes the quarter is ln ((1 + √½)/(1 − √½)); what k adds is of the order of kk ln k.
  const Fifty root = sqrt(Fifty(0.5));
  CHECK(time == within_relative(log((1 + root) / (1 - root)), 1e-14, "kk ln k"));
  CHECK(time == within_relative(quarter_by_integral({1, 1, Fifty("1e-3")}, Fifty(0.5)), 1e-5, "kk ln k"));
  const Ball<Fifty> near{1, 1, Fifty("1e-3")};
  CHECK(rolling::quarter(near, energy(Fifty(0.5)))
        == within_relative(quarter_by_integral(near, Fifty(0.5)), 1e-36, "the oracle's own bound"));
}

TEST_CASE("with just the velocity for the top the time is elementary")
{
  for(const char* text : {"1e-20", "0.5", "2", "3.14159"})
  {
    const Place<Fifty> there = place(Fifty(text));
    CHECK(rolling::separatrix_time(exact_ball, there)
          == within_relative(rolling::time(exact_ball, energy(Fifty(1)), there), 1e-44, "fifty digits"));
  }
  for(const double psi : {1e-300, 1e-12, 0.1, 1.0, 3.0})
    CHECK(rolling::separatrix_time(ball, place_from_top(psi))
          == within_ulps(rolling::separatrix_time(exactly(ball), place_from_top(Fifty(psi))), 8, bound));
  CHECK(rolling::separatrix_time(ball, place_from_top(0.0)) == std::numeric_limits<double>::infinity());
}

TEST_CASE("the angle at a time has that time")
{
  for(const Ball<double>& b : {ball, cradle<double>, Ball<double>{1, 0.999, 1e-3}})
    for(const double below : {0.9, 0.5, 1e-12, 0.0, -1e-12, -1.0, -50.0})
    {
      const Energy<double> e = energy_from_top(below);
      const double quarter = below == 0 ? 5 : rolling::quarter(b, e);
      for(const double part : {1e-9, 0.2, 0.5, 0.9})
      {
        const Turned at = rolling::angle(b, e, part * quarter);
        const Place<double> there = at.Phi < 1.6 ? place(at.Phi) : place_from_top(at.from_top);
        const double blur = 1e-15 * (at.Phi < 1.6 ? at.Phi : at.from_top)
                            / std::sqrt(rolling::velocity_squared(b, e, there));
        CHECK(rolling::time(b, e, there) == within(part * quarter, 3e-15 * part * quarter + blur, bound));
      }
    }
}

TEST_CASE("k = 1 and past a quarter turn: just to the top, and over it")
{
  const std::vector<Place<double>> places{place(1.6), place_from_top(1.5), place_from_top(0.3),
                                          place_from_top(1e-9), place_from_top(1e-200)};
  for(const Ball<double>& b : {ball, cradle<double>, Ball<double>{1, 5, 2}})
  {
    for(const double below : {0.0, -1e-300, -1e-12, -2.0})
    {
      const Energy<double> e = energy_from_top(below);
      std::vector<double> together(places.size());
      rolling::time(b, e, places, together);
      for(std::size_t i = 0; i < places.size(); ++i)
      {
        const Place<Fifty> exact_place =
            i == 0 ? Place<Fifty>{places[i].s, sqrt(1 - Fifty(places[i].s) * Fifty(places[i].s))}
                   : Place<Fifty>{sqrt(1 - Fifty(places[i].c) * Fifty(places[i].c)), places[i].c};
        const Fifty exact = rolling::time(exactly(b), Energy<Fifty>{1 - Fifty(below), below}, exact_place);
        CHECK(rolling::time(b, e, places[i]) == within_ulps(exact, 8, bound));
        CHECK(together[i] == rolling::time(b, e, places[i]));
      }
      if(below < 0)
        CHECK(rolling::time(b, e, place_from_top(0.0))
              == within_relative(rolling::quarter(b, e), 4e-15, "16 ulps, two ways"));
    }
    CHECK(rolling::time(b, energy(1.0), place_from_top(0.0)) == std::numeric_limits<double>::infinity());
    CHECK_THROWS_AS(rolling::excess(b, energy(1.0)), std::domain_error);
  }
  // Rocking, the second quarter goes back through the angles of the first; turning over, each half turn is as long.
  for(const double below : {0.5, 1e-12, -1e-12, -1.0})
  {
    const Energy<double> e = energy_from_top(below);
    const double quarter = rolling::quarter(ball, e);
    const double whole = (below > 0 ? 4 : 2) * quarter;
    const double turned = below > 0 ? 0 : 2 * std::numbers::pi;
    const double rounded = 4e-15 * whole * 3;  // the times, to 18 ulps, at a velocity below 3
    for(const double part : {0.2, 0.5, 0.9})
    {
      const double Phi = rolling::angle(ball, e, part * quarter).Phi;
      CHECK(rolling::angle(ball, e, -part * quarter).Phi == -Phi);
      CHECK(rolling::angle(ball, e, whole + part * quarter).Phi
            == within(Phi + turned, rounded, "the time is rounded"));
      CHECK(rolling::angle(ball, e, 2 * quarter - part * quarter).Phi
            == within(below > 0 ? Phi : turned - Phi, rounded, "the time is rounded"));
    }
  }
}

TEST_CASE("friction and pressure are those of the equations of motion, whatever the energy")
{
  const Fifty g("15.625");
  for(const char* text : {"0.3", "1", "3", "50"})
    for(const char* angle : {"0.1", "1", "2", "3.1"})
    {
      const Fifty h(text), Phi(angle);
      if(sin(Phi / 2) * sin(Phi / 2) > h)
        continue;
      const Energy<Fifty> e = energy(h);
      const Fifty w = sqrt(rolling::velocity_squared(exact_ball, e, place(Phi)) * 2 * g * exact_ball.c);
      const Fifty lambda = rolling::friction(exact_ball, e, place(Phi));
      const auto all = accelerations(exact_ball, g, Phi, w, lambda);
      // Rolling: the acceleration of the place of contact is a Φ''.
      const Fifty contact = all.x + exact_ball.c * (all.Phi * cos(Phi) - w * w * sin(Phi));
      CHECK(contact == within(exact_ball.a * all.Phi, 1e-43, "rounding"));
      CHECK(rolling::pressure(exact_ball, e, place(Phi)) == within(all.pressure, 1e-43, "rounding"));
    }
  const Place<double> sixty = place(std::numbers::pi / 3);
  CHECK(rolling::friction(ball, energy(3.0), sixty)
        == within_ulps(Fifty("0.04444623538093982334026645742"), 8, bound));
  CHECK(rolling::pressure(ball, energy(3.0), sixty)
        == within_ulps(Fifty("1.032286564573129146258292517"), 4, bound));
  const double s = std::sin(0.4), y = ball.a - ball.c * std::cos(0.8);
  CHECK(rolling::friction(ball, {s * s, std::cos(0.4) * std::cos(0.4)}, place(0.8))
        == within_ulps(ball.c * std::sin(0.8) * y / (ball.k * ball.k + y * y), 8, "at rest"));
}

TEST_CASE("the greatest friction is where other tools found it, also where none is needed at 90°")
{
  const auto three = rolling::greatest_friction(exact_ball, energy(Fifty(3)));
  CHECK(three.Phi * radian == within_relative(Fifty("94.86783809273063288979026628"), 1e-27, other_tools));
  CHECK(three.lambda == within_relative(Fifty("0.05416607744998008836297875295"), 1e-27, other_tools));
  // 2C(cc + kk) = aA: λ(90°) = 0
  const auto none_at_90 = [](const Ball<Fifty>& b) {
    const Fifty C = b.a * (bb(b) + 2 * b.a * b.c) / (2 * (b.c * b.c + b.k * b.k));
    return rolling::greatest_friction(b, energy(Fifty((C / b.c + 1) / 2)));
  };
  CHECK(none_at_90(exact_ball).Phi * radian
        == within_relative(Fifty("139.6091412149604798743626496"), 1e-26, other_tools));
  CHECK(abs(none_at_90(exact_ball).lambda)
        == within_relative(Fifty("0.001864549343166746072617845349"), 1e-25, other_tools));
  CHECK(none_at_90(cradle<Fifty>).Phi * radian
        == within_relative(Fifty("128.1173165256296404912391170"), 1e-26, other_tools));
  for(const double h : {1e-12, 0.01, 0.3, 0.9, 0.999999, 1.0, 1.5, 3.0, 20.0})
    for(const Ball<double>& b : {ball, cradle<double>})
    {
      const auto exact = rolling::greatest_friction(exactly(b), energy(Fifty(h)));
      const auto got = rolling::greatest_friction(b, energy(h));
      if(!(exact.lambda < 1e9))
        CHECK(got.lambda == std::numeric_limits<double>::infinity());
      else
      {
        CHECK(got.lambda == within_relative(exact.lambda, 1e-13, bound));
        CHECK(got.Phi == within_relative(exact.Phi, 1e-9, "a flat maximum"));
      }
    }
}

TEST_CASE("the energies at which the ball can roll for ever")
{
  const auto of_cradle = rolling::windows(cradle<double>, 1 / 3.0);
  REQUIRE(of_cradle.size() == 2);
  CHECK(of_cradle[0].from == 0);
  CHECK(of_cradle[0].to == within_relative(Fifty("0.1362556411950426699602548391"), 1e-15, bound));
  CHECK(of_cradle[1].from == within_relative(Fifty("0.8985265588077603024159568785"), 1e-15, bound));
  CHECK(of_cradle[1].to == within_relative(Fifty("2.560963857625863988440485760"), 1e-15, bound));
  const auto of_ball = rolling::windows(ball, 1 / 3.0);
  REQUIRE(of_ball.size() == 1);
  CHECK(of_ball[0].to == within_relative(Fifty("32.65704018276515135359184951"), 1e-15, bound));
  // Inside a window the friction suffices, outside not.
  for(const Ball<double>& b : {ball, cradle<double>, Ball<double>{1, 0.9, 0.1}, Ball<double>{1, 2, 1}})
    for(const double mu : {0.01, 0.1, 1 / 3.0, 0.9})
    {
      const auto windows = rolling::windows(b, mu);
      REQUIRE(!windows.empty());
      CHECK(windows.front().from == 0);
      double last = 0;
      for(const auto& window : windows)
      {
        CHECK(window.from < window.to);
        const auto needs = [&](double h) {
          return static_cast<double>(abs(rolling::greatest_friction(exactly(b), energy(Fifty(h))).lambda));
        };
        CHECK(needs(window.from * (1 + 1e-13) + 1e-13 * window.to) <= mu);
        CHECK(needs((window.from + window.to) / 2) <= mu);
        CHECK(needs(window.to * (1 - 1e-13)) <= mu);
        CHECK(needs(window.to * (1 + 1e-13)) > mu);
        if(window.from > 0)
        {
          CHECK(needs(window.from * (1 - 1e-13)) > mu);
          CHECK(needs((last + window.from) / 2) > mu);
        }
        last = window.to;
      }
      for(const double more : {1.01, 1.5, 3.0, 100.0})
        CHECK(std::abs(rolling::greatest_friction(b, energy(more * last)).lambda) > mu);
    }
  CHECK_THROWS_AS(rolling::windows(ball, 0.0), std::domain_error);
  CHECK_THROWS_AS(rolling::windows(ball, std::nan("")), std::domain_error);
}

TEST_CASE("a rolling ball loses its pressure first at the top exactly while kk ≥ (a + c)(3c − a)")
{
  const auto of_cradle = rolling::loss_of_pressure(cradle<Fifty>);
  CHECK(of_cradle.h == within_relative(Fifty("3.378272339202300401573869164"), 1e-27, other_tools));
  CHECK(of_cradle.Phi * radian
        == within_relative(Fifty("125.8393731595017679290053574"), 1e-27, other_tools));
  CHECK(rolling::loss_of_pressure(ball).h == within_ulps(40.25, 2, bound));
  CHECK(rolling::loss_of_pressure(ball).from_top == 0);
  for(const char* text : {"0.01", "0.3", "0.6", "1"})
  {
    const Fifty k(text), c = rolling::eccentricity_of_early_loss(Fifty(1), k);
    CHECK((1 + c) * (3 * c - 1) == within(k * k, 1e-48, "rounding"));
    const auto below = rolling::loss_of_pressure<Fifty>({1, Fifty(c - 1e-6), k});
    const auto above = rolling::loss_of_pressure<Fifty>({1, Fifty(c + 1e-6), k});
    CHECK(below.from_top == 0);
    CHECK(above.from_top > 0);
    CHECK(above.from_top < 0.1);
  }
  // By the equations of motion: with that energy the least pressure is 0, there, and with less it is above.
  for(const Ball<double>& b : {ball, cradle<double>, Ball<double>{1, 0.9, 0.1}, Ball<double>{1, 0.7, 0.3},
                               Ball<double>{1, 1, 1e-8}, Ball<double>{1, 1000, 0.1}})
  {
    const auto loss = rolling::loss_of_pressure(b);
    const auto exact = rolling::loss_of_pressure(exactly(b));
    CHECK(loss.h == within_ulps(exact.h, 1, bound));
    CHECK(loss.from_top == within_ulps(exact.from_top, 1, bound));
    CHECK(rolling::pressure(exactly(b), energy(exact.h), place_from_top(exact.from_top))
          == within(0, 1e-40, "rounding"));
    for(double Phi = 0.001; Phi < 3.14; Phi += 0.001)
    {
      const Energy<double> less = energy(loss.h * (1 - 1e-9));
      if(std::pow(std::sin(Phi / 2), 2) < less.h)
        CHECK(rolling::pressure(b, less, place(Phi)) > 0);
    }
  }
  // It can happen to a ball that only rocks.
  CHECK(rolling::loss_of_pressure(Ball<double>{1, 0.9, 0.1}).h < 0.9);
}

TEST_CASE("the friction beyond which scraping is not determined")
{
  const auto of_ball = rolling::painleve(exact_ball), of_cradle = rolling::painleve(cradle<Fifty>);
  CHECK(of_ball.mu == within_relative(Fifty("3.680804971017807938224064157"), 1e-27, other_tools));
  CHECK(of_ball.Phi * radian
        == within_relative(Fifty("95.93790172143078424947530604"), 1e-26, other_tools));
  CHECK(of_cradle.mu == within_relative(Fifty("0.7824836267421240502413782085"), 1e-27, other_tools));
  CHECK(of_cradle.Phi * radian
        == within_relative(Fifty("132.6603320113313759257397168"), 1e-26, other_tools));
  for(const double k : {1e-6, 0.01, 0.1})
  {
    const Ball<double> b{1, 0.5, k};
    const double mu = rolling::painleve(b).mu;
    CHECK(mu >= 2 * k / 1.5);
    CHECK(mu == within_relative(rolling::painleve(exactly(b)).mu, 1e-9, "a sharp minimum as k vanishes"));
  }
  // A large ball, whose height hardly changes: at 90°, however large.
  for(const double a : {1e17, 1e19, 9.99999999999e19})
  {
    const auto limit = rolling::painleve(Ball<double>{a, 0.1, 0.6});
    CHECK(limit.mu == within_relative(3.7 / a, 1e-15, "(kk + cc)/ac"));
    CHECK(limit.Phi * radian == within(90, 1e-13, "the angle of half"));
  }
}

TEST_CASE("an excess keeps its digits to the least distance from the top that a double has")
{
  double worst = 0;
  for(const double below : {0.1, 1e-3, 1e-15, 1e-80, 1e-160, 1e-300, 5e-324})
  {
    const Fifty exact = rolling::quarter(exactly(ball), {1 - Fifty(below), below})
                        / (exact::pi() / 2 * sqrt(bb(exactly(ball))));
    worst = std::max(worst, exact::ulps(rolling::excess(ball, energy_from_top(below)), exact - 1));
  }
  CHECK(worst <= 10);
}

TEST_CASE("where c is nearly a, all that rolls keeps its digits by a − c, and without it has lost them")
{
  for(const char* const less : {"1e-4", "1e-9", "-1e-9", "1e-12"})
    for(const char* const k : {"1e-3", "1e-9"})
    {
      const Ball<Fifty> b{1, 1 - Fifty(less), Fifty(k)};
      const Ball<double> near = rounded(b);
      const double bend =
          std::sqrt(bb(near) / BB(near));  // so far from the lowest place its moment changes
      CHECK(bb(near) == within_ulps(bb(b), 3, "three roundings"));
      for(const double h : {bend * bend, 0.3, 2.0})
      {
        const Energy<double> e = energy(h);
        const Energy<Fifty> exact_e = energy(Fifty(h));
        CHECK(rolling::quarter(near, e)
              == within_ulps(oracle::rolling_quarter(b, exact_e), 9, "8, and of the ball"));
        if(h < 1)
          CHECK(rolling::excess(near, e)
                == within_ulps(oracle::rolling_quarter(b, exact_e) / (exact::pi() / 2 * sqrt(bb(b))) - 1,
                               12, "10, and of the ball"));
        for(const double Phi : {bend / 3, bend, 0.5})
        {
          if(std::pow(std::sin(Phi / 2), 2) > 0.9 * h)
            continue;
          const Place<double> at = place(Phi);
          const Place<Fifty> exact_at{at.s, sqrt(1 - Fifty(at.s) * at.s)};
          CHECK(rolling::time(near, e, at)
                == within_ulps(oracle::rolling_time(b, exact_e, exact_at), 10, "8, and of the ball"));
        }
      }
      for(const double mu : {0.1, 0.6})
      {
        const auto exact = rolling::windows(b, Fifty(mu));
        const auto got = rolling::windows(near, mu);
        REQUIRE(got.size() == exact.size());
        for(std::size_t i = 0; i < got.size(); ++i)
        {
          CHECK(got[i].to == within_relative(exact[i].to, 4e-15, "of the ball's roundings"));
          const auto needs = [&](const Fifty& h) {
            return abs(rolling::greatest_friction(b, energy(h)).lambda);
          };
          CHECK(needs(exact[i].to * (1 - Fifty("1e-18"))) <= mu);
          CHECK(needs(exact[i].to * (1 + Fifty("1e-18"))) > mu);
        }
      }
    }
}

TEST_CASE("what has no dimension is the same to the bit in every measure of length")
{
  for(const double unit : {0x1p-330, 0x1p330})
  {
    const Ball<double> b{ball.a * unit, ball.c * unit, ball.k * unit, ball.gap * unit};
    const auto e = energy(3.0);
    CHECK(rolling::pressure(b, e, place(1.0)) == rolling::pressure(ball, e, place(1.0)));
    CHECK(rolling::friction(b, e, place(1.0)) == rolling::friction(ball, e, place(1.0)));
    CHECK(rolling::greatest_friction(b, e).lambda == rolling::greatest_friction(ball, e).lambda);
    CHECK(rolling::loss_of_pressure(b).h == rolling::loss_of_pressure(ball).h);
    CHECK(rolling::painleve(b).mu == rolling::painleve(ball).mu);
    CHECK(rolling::windows(b, 0.3).front().to == rolling::windows(ball, 0.3).front().to);
  }
}

TEST_CASE("the accelerations of rolling are those with the friction that it needs, and G keeps up with the "
          "contact")
{
  for(const Ball<Fifty>& b : {exact_ball, cradle<Fifty>})
    for(const Fifty& Phi : {Fifty("0.3"), Fifty("1.7"), Fifty(3)})
    {
      const Fifty g = Fifty("0.7"), w = Fifty("1.3");
      const auto rolls = rolling_accelerations(b, g, Phi, w);
      const Fifty lambda = -rolls.x / (2 * g * rolls.pressure);
      const auto scrapes = accelerations(b, g, Phi, w, lambda);
      CHECK(rolls.Phi == within(scrapes.Phi, 1e-45, "fifty digits"));
      CHECK(rolls.x == within(scrapes.x, 1e-45, "fifty digits"));
      CHECK(rolls.y == within(scrapes.y, 1e-45, "fifty digits"));
      CHECK(rolls.pressure == within(scrapes.pressure, 1e-45, "fifty digits"));
      // §3: dds = ddx + c ddΦ cos Φ − c dΦ² sin Φ
      CHECK(scrapes.x + b.c * scrapes.Phi * cos(Phi) - b.c * w * w * sin(Phi)
            == within(b.a * scrapes.Phi, 1e-45, "fifty digits"));
    }
}

TEST_CASE("a rolling ball that makes no sense is refused")
{
  CHECK_THROWS_AS(rolling::quarter(Ball<double>{0, 0.1, 0.6}, energy(0.5)), std::domain_error);
  CHECK_THROWS_AS(rolling::quarter(Ball<double>{1, 0, 0.6}, energy(0.5)), std::domain_error);
  CHECK_THROWS_AS(rolling::quarter(Ball<double>{1, 0.1, -0.6}, energy(0.5)), std::domain_error);
  CHECK_THROWS_AS(rolling::quarter(Ball<double>{1, std::nan(""), 0.6}, energy(0.5)), std::domain_error);
  CHECK_THROWS_AS(rolling::time(ball, energy(0.5), place(2.0)), std::domain_error);
  CHECK_THROWS_AS(rolling::excess(ball, energy(2.0)), std::domain_error);
  std::vector<Energy<double>> e{energy(0.5)};
  std::vector<double> out(2);
  CHECK_THROWS_AS(rolling::quarter(ball, e, out), std::invalid_argument);
  out.resize(1);
  rolling::quarter(ball, e, out);
  CHECK(out[0] == rolling::quarter(ball, e[0]));
}
