/// @file
/// The ball on a smooth plane: its times against the equations of motion, against numbers found by other tools, and
/// in double against fifty digits, to the ends of the ranges.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "edition/compare.hpp"
#include "exact/ode.hpp"
#include "globe/oracle.hpp"
#include "globe/smooth.hpp"
#include "globe/time.hpp"

using namespace globe;
using edition::within;
using edition::within_relative;
using edition::within_ulps;
using exact::Fifty;

namespace
{

const Fifty c0 = our_ball<Fifty>.c, k0 = our_ball<Fifty>.k;
constexpr double c = 0.1, k = 0.6, degree = std::numbers::pi / 180;
const char* const other_tools = "two independent tools agree to so many digits";
const char* const bound = "the stated bound";

/// The angle and velocity by §10's equation, at the time τ with the velocity of h at the start.
exact::State by_motion(const Fifty& c_, const Fifty& k_, const Fifty& h, const Fifty& tau)
{
  const Ball<Fifty> ball{1, c_, k_};
  const Fifty g = 1 / (2 * c_);  // then t is τ
  const auto motion = [&](const Fifty&, const exact::State& s) {
    return exact::State{s[1], accelerations<Fifty>(ball, g, s[0], s[1], 0).Phi};
  };
  return exact::solve(motion, 0, {0, 2 * sqrt(h) / k_}, tau).y;
}

}  // namespace

TEST_CASE("the times are those of the equations of motion, rocking, turning over and between")
{
  for(const char* text : {"0.5", "0.999", "1", "1.001", "2", "9"})
  {
    const Fifty h(text), tau("0.7");
    const Fifty Phi = by_motion(c0, k0, h, tau)[0];
    if(Phi < exact::pi())
      CHECK(smooth::time(c0, k0, energy(h), place(Phi))
            == within_relative(tau, 1e-26, "some hundred steps of 1e-32, and the place near rest"));
  }
  const Fifty quarter = smooth::quarter(c0, k0, energy(Fifty(0.5)));
  CHECK(by_motion(c0, k0, Fifty(0.5), quarter)[0]
        == within(exact::pi() / 2, 1e-28, "hundred steps of 1e-32"));
  CHECK(by_motion(c0, k0, Fifty(0.5), quarter)[1] == within(0, 1e-28, "hundred steps of 1e-32"));
}

TEST_CASE("quarter periods and half turns are what other tools found")
{
  CHECK(smooth::quarter(c0, k0, energy(Fifty(0.5)))
        == within_relative(Fifty("1.122684671085358322119754306"), 1e-27, other_tools));
  CHECK(smooth::quarter(c0, k0, energy(Fifty(2)))
        == within_relative(Fifty("0.7919915702638591885482862064"), 1e-27, other_tools));
  CHECK(smooth::time(c0, k0, energy(Fifty(2)), place(Fifty(1)))
        == within_relative(Fifty("0.2174026926019614723630964684"), 1e-27, other_tools));
  CHECK(smooth::quarter(c0, k0, energy_from_top(Fifty("1e-15")))
        == within_relative(Fifty("11.2044683213001864073538617770"), 1e-29, other_tools));
  CHECK(smooth::quarter(c0, k0, energy_from_top(Fifty("-1e-15")))
        == within_relative(Fifty("11.2044683213001805389765829234"), 1e-29, other_tools));
  CHECK(smooth::quarter(Fifty("0.1"), Fifty("1e-6"), energy(Fifty(0.5)))
        == within_relative(Fifty("0.141421356288685025403138787179"), 1e-29, other_tools));
}

TEST_CASE("the fifty digits are those of quadrature alone, and its inverse is its inverse")
{
  for(const char* below : {"0.9", "1e-20", "0", "-1e-15", "-3", "-1e20"})
    for(const char* ratio : {"1e-6", "0.3", "50"})
    {
      const Energy<Fifty> e{1 - Fifty(below), Fifty(below)};
      const Fifty c_ = Fifty(ratio) * k0;
      const Place<Fifty> there = place(Fifty("0.5"));
      const Fifty tau = oracle::smooth_time(c_, k0, e, there);
      CHECK(smooth::time(c_, k0, e, there) == within_relative(tau, 1e-35, "two ways of forty digits"));
      CHECK(oracle::smooth_place(c_, k0, e, tau).s
            == within_relative(there.s, 1e-25, "a step of Newton's"));
      if(e.from_top != 0)
        CHECK(smooth::quarter(c_, k0, e)
              == within_relative(oracle::smooth_quarter(c_, k0, e), 1e-35, "two ways of forty digits"));
    }
}

TEST_CASE("in double quarters keep what they promise, from the smallest swing to the fastest turning")
{
  double worst = 0;
  for(const double ratio : {0.0, 1e-12, 1.0 / 6, 1.0, 3.1, 1e5})
    for(const double below : {1.0, 0.9999, 0.5, 1e-3, 1e-15, 1e-300, -1e-300, -1e-9, -0.5, -1e16})
    {
      const double c_ = ratio * k;
      const Energy<double> e = energy_from_top(below);
      const Energy<Fifty> exact_e{1 - Fifty(below), below};
      const Fifty exact = smooth::quarter<Fifty>(c_, k, exact_e);
      worst = std::max(worst, exact::ulps(smooth::quarter(c_, k, e), exact));
    }
  CHECK(worst <= 8);
  CHECK(smooth::quarter(c, k, energy(1.0)) == std::numeric_limits<double>::infinity());
}

TEST_CASE("in double the time to a place keeps what it promises")
{
  double worst = 0;
  for(const double ratio : {0.01, 1.0 / 6, 1.0, 10.0})
    for(const double below : {0.9999, 0.5, 1e-9, 0.0, -1e-15, -1.0})
      for(const double part : {1e-12, 0.3, 0.95})
      {
        const Energy<double> e = energy_from_top(below);
        const double Phi = part * (below > 0 ? 2 * std::asin(std::sqrt(1 - below)) : std::numbers::pi);
        const Place<double> there = place(Phi);
        const Fifty exact = smooth::time<Fifty>(ratio * k, k, {1 - Fifty(below), below},
                                                {there.s, sqrt(1 - Fifty(there.s) * Fifty(there.s))});
        worst = std::max(worst, exact::ulps(smooth::time(ratio * k, k, e, there), exact)
                                    * std::min(1.0, 5 * (1 - part)));
      }
  CHECK(worst <= 8);
  const Place<double> near_top = place_from_top(1e-12);
  CHECK(smooth::time(c, k, energy(1.0), near_top)
        == within_ulps(Fifty("17.42144807238410682001379926"), 8, bound));
  CHECK(smooth::time(c, k, energy(1.0), near_top)
        == within_ulps(Fifty(separatrix_time(c, k, 0.5e-12)), 8, "two ways"));
  CHECK(smooth::time(c, k, energy(1.0), place_from_top(0.0)) == std::numeric_limits<double>::infinity());
}

TEST_CASE("the angle at a time is that of other tools, also where Newton's method in Φ diverges")
{
  const Turned after = smooth::angle(c, k, energy_from_top(-1e-12), 9.13214173760318381518285284160 / 4);
  CHECK(after.Phi == within_ulps(Fifty("3.05092564081708075366172459892"), 2, bound));
  CHECK(after.from_top == within_relative(Fifty("0.0906670127727124848009187843569"), 2e-15, bound));
  const double quarter = smooth::quarter(c, k, energy_from_top(1e-12));
  CHECK(smooth::angle(c, k, energy_from_top(1e-12), quarter / 2).Phi
        == within_ulps(Fifty("3.13957413682278140906125"), 2, bound));
  const double second = std::sqrt(2 * our_g<double> * c);
  const Energy<double> slow = energy_of_velocity(c, k * k, our_g<double>, 0.01);
  CHECK(smooth::angle(c, k, slow, second / 2).Phi
        == within_relative(Fifty("0.003377941945494967073571462852"), 2e-15, bound));
}

TEST_CASE("the angle at a time has that time, in every swing and turn")
{
  for(const double ratio : {0.01, 1.0 / 6, 1.0, 20.0})
    for(const double below : {0.9, 0.5, 1e-3, 1e-12, -1e-12, -1e-3, -1.0, -50.0})
    {
      const Energy<double> e = energy_from_top(below);
      const double quarter = smooth::quarter(ratio * k, k, e);
      for(const double part : {1e-9, 0.2, 0.5, 0.9})
      {
        const Turned at = smooth::angle(ratio * k, k, e, part * quarter);
        const Place<double> there = at.Phi < 1.6 ? place(at.Phi) : place_from_top(at.from_top);
        // The place is rounded, by the swing's bound of four units of 2⁻⁵², at the velocity it has.
        const double velocity = std::sqrt(smooth::velocity_squared(ratio * k, k, e, there));
        const double blur = 1e-15 * (at.Phi < 1.6 ? at.Phi : at.from_top) / velocity;
        CHECK(smooth::time(ratio * k, k, e, there)
              == within(part * quarter, 3e-15 * part * quarter + blur, bound));
        const double whole = (below > 0 ? 4 : 2) * quarter;
        const double turned = below > 0 ? 0 : 2 * std::numbers::pi;
        const double late = 4e-15 * whole * velocity;
        CHECK(smooth::angle(ratio * k, k, e, part * quarter + whole).Phi
              == within(at.Phi + turned, late + 1e-15, "the time is rounded"));
        CHECK(smooth::angle(ratio * k, k, e, -part * quarter).Phi == -at.Phi);
        if(below > 0)
          CHECK(smooth::angle(ratio * k, k, e, 2 * quarter - part * quarter).Phi
                == within(at.Phi, late + 1e-15, "the time is rounded"));
      }
    }
  CHECK(smooth::angle(c, k, energy(1.0), smooth::time(c, k, energy(1.0), place_from_top(1e-9))).from_top
        == within_relative(1e-9, 1e-14, "ten ulps of the time, 12 of them units of k"));
  for(const double half : {1.0, -1.0})  // just between two lowest places
    CHECK(smooth::angle(c, k, energy(8.0), half * smooth::quarter(c, k, energy(8.0))).Phi
          == within_ulps(half * exact::pi(), 4, bound));
  CHECK_THROWS_AS(smooth::angle(c, k, energy(0.5), 1e30), std::domain_error);
}

TEST_CASE("excesses over a very small swing keep their digits")
{
  CHECK(smooth::excess(c, k, energy(1e-20))
        == within_relative(Fifty("2.77777777777777777779074074074e-21"), 1e-15, bound));
  for(const double ratio : {0.0, 1e-12, 1.0 / 6, 1.0, 50.0})
    for(const double h : {1e-12, 1e-6, 0.01, 0.5, 0.99})
    {
      const Fifty whole = smooth::quarter<Fifty>(ratio * k, k, energy(Fifty(h)));
      const Fifty excess = whole / (exact::pi() / 2 * k) - 1;
      CHECK(smooth::excess(ratio * k, k, energy(h)) == within_ulps(excess, 8, bound));
    }
  for(const double ratio : {60.0, 80.0, 100.0})  // where the mesh of equal steps would be too fine
    for(const double below : {0.1, 0.01, 1e-6, 1e-12, 1e-100})
    {
      const Fifty whole = smooth::quarter<Fifty>(ratio * k, k, energy_from_top(Fifty(below)));
      CHECK(smooth::excess(ratio * k, k, energy_from_top(below))
            == within_ulps(whole / (exact::pi() / 2 * k) - 1, 8, bound));
    }
  // 1e-24 of the pendulum's: what c = 1e-12 adds, told by two small numbers
  const Fifty tiny("1e-12");
  const Fifty more =
      smooth::quarter(tiny, k0, energy(Fifty(0.5))) / smooth::quarter(Fifty(0), k0, energy(Fifty(0.5))) - 1;
  CHECK(more
        == within_relative(Fifty("9.25925925925925925925925374780e-25"), 1e-15, "forty digits less 25"));
}

TEST_CASE("with the second energy half a turn is elliptic")
{
  for(const char* ratio : {"0.01", "0.16666666666", "1", "30"})
  {
    const Fifty c_(ratio);
    const auto [h, half_turn] = smooth::second_energy(c_, Fifty(1));
    CHECK(half_turn
          == within_relative(smooth::quarter(c_, Fifty(1), energy(h)), 1e-36, "the oracle's own bound"));
    CHECK(h < smooth::lift_off_energy(c_, Fifty(1)));
    const double small = static_cast<double>(c_);
    CHECK(smooth::second_energy(small, 1.0).half_turn
          == within_ulps(smooth::second_energy(Fifty(small), Fifty(1)).half_turn, 8, bound));
  }
  CHECK(smooth::second_energy(c0, k0).h
        == within_relative(Fifty("3.541381265149109844499842123"), 1e-27, other_tools));
  CHECK(smooth::second_energy(c0, k0).half_turn
        == within_relative(Fifty("0.5469484164332981129787494723"), 1e-27, other_tools));
}

TEST_CASE("very fast turning: 2n√gc T nears 4kE(−cc/kk)")
{
  // τ of a half turn is T√(2gc)/2, so that 2n√(gc) T = 2√2 n τ with h = nn/2
  const Fifty n("1e8");
  const Fifty time = 2 * sqrt(Fifty(2)) * n * smooth::quarter(c0, k0, energy(Fifty(n * n / 2)));
  CHECK(time == within_relative(Fifty("3.79595632384715092009474557325"), 1e-29, other_tools));
  CHECK(time - Fifty("3.79595632384715073029692938089")
        == within_relative(Fifty("1.897978161923575578427254e-16"), 1e-13, "what the digits leave"));
}

TEST_CASE("pressure and angular acceleration are those of §§6-7")
{
  for(const char* text : {"0.3", "1", "2", "30"})
    for(const char* angle : {"0.1", "1", "2", "3.1"})
    {
      const Fifty h(text), Phi(angle), g("15.625");
      const Energy<Fifty> e = energy(h);
      if(sin(Phi / 2) * sin(Phi / 2) > h)
        continue;
      const Fifty w = sqrt(smooth::velocity_squared(c0, k0, e, place(Phi)) * 2 * g * c0);
      const auto all = accelerations<Fifty>(our_ball<Fifty>, g, Phi, w, 0);
      CHECK(smooth::pressure(c0, k0, e, place(Phi)) == within(all.pressure, 1e-46, "rounding"));
      CHECK(all.Phi == within(-2 * g * c0 * sin(Phi) / (k0 * k0) * all.pressure, 1e-44, "rounding"));
    }
  CHECK(smooth::pressure(c, k, energy(2.0), place(60 * degree))
        == within_ulps(Fifty("1.072886297376093294460641399"), 4, bound));
}

TEST_CASE("the ball leaves the plane where its pressure vanishes, and only beyond 1 + kk/4cc")
{
  const auto six = smooth::lift_off(c0, k0, Fifty(8));  // n = 6: h = 18, the limit is 10
  CHECK(six.Phi * 180 / exact::pi()
        == within_relative(Fifty("122.1829281541104208097570701"), 1e-27, other_tools));
  const Fifty second = sqrt(2 * our_g<Fifty> * c0);
  CHECK(six.tau / second == within_relative(Fifty("0.08675164700374182185562535165"), 1e-27, other_tools));
  CHECK(six.w * second == within_relative(Fifty("24.22225632930735813445447231"), 1e-27, other_tools));
  for(const double excess : {5e-324, 1e-300, 5e-13, 1e-3, 8.0, 1e6, 1e150})
    for(const double ratio : {1.0 / 6, 1.0, 10.0})
    {
      const auto exact = smooth::lift_off(Fifty(ratio), Fifty(1), Fifty(excess));
      const auto there = smooth::lift_off(ratio, 1.0, excess);
      CHECK(there.from_top == within_ulps(exact.from_top, 8, bound));
      CHECK(there.tau == within_ulps(exact.tau, 8, bound));
      CHECK(there.w == within_ulps(exact.w, 8, bound));
      const Energy<Fifty> e = energy(Fifty(smooth::lift_off_energy(Fifty(ratio), Fifty(1)) + excess));
      if(excess > 1e-20 && excess < 1e10)
        CHECK(smooth::pressure(Fifty(ratio), Fifty(1), e, place(exact.Phi))
              == within(0, 1e-28, "rounding"));
    }
  CHECK(smooth::lift_off(c, k, 5e-13).from_top
        == within_ulps(Fifty("0.0000003333333333333253600823045"), 8, bound));
  CHECK_THROWS_AS(smooth::lift_off(c, k, 0.0), std::domain_error);
  CHECK_THROWS_AS(smooth::lift_off(c, k, -1.0), std::domain_error);
  for(double Phi = 0; Phi < 3.14; Phi += 0.1)
    CHECK(smooth::pressure(c, k, energy(10.0), place(Phi)) > 0);
}

TEST_CASE("Euler's fast turning: his time, his inequalities, and the anomaly")
{
  const Fifty n = 4, pi = exact::pi();
  const Fifty turn = smooth::fast_time_by_euler(c0, k0, n, Fifty(2 * pi)) / sqrt(2 * our_g<Fifty> * c0);
  CHECK(turn == within_relative(Fifty("0.3913900847597284076251376548"), 1e-27, other_tools));
  const auto e = smooth::inequalities(c0, k0, n);
  CHECK(e.e1 == within_relative(Fifty("0.03010033444816053511705685619"), 1e-27, other_tools));
  CHECK(e.e2 == within_relative(Fifty("0.003344481605351170568561872910"), 1e-27, other_tools));
  CHECK(smooth::anomaly(e, Fifty(2))
        == within_relative(Fifty("2.024421294867381839041018167"), 1e-27, other_tools));
  const smooth::Inequalities<double> near{0.0301, 0.00334};
  for(const double M : {0.0, 1e-9, 2.0, 100.0, -5.0})
    CHECK(smooth::anomaly(near, M) == within_ulps(smooth::anomaly<Fifty>({near.e1, near.e2}, M), 4, bound));
  CHECK_THROWS_AS(smooth::anomaly({0.9, 0.3}, 1.0), std::domain_error);
}

TEST_CASE("with hardly any moment of inertia of its own a ball keeps its times, up to a thousand million k")
{
  for(const double ratio : {1e7, 1e8, 1e9})
    for(const double below : {0.7, 1e-12, -1.0})
    {
      const Energy<double> e = energy_from_top(below);
      const Energy<Fifty> exact_e = energy_from_top(Fifty(below));
      CHECK(smooth::quarter(ratio, 1.0, e)
            == within_ulps(oracle::smooth_quarter(ratio, 1, exact_e), 8, "the stated bound"));
      for(const double Phi : {1e-10, 0.5})
      {
        const Place<double> at = place(Phi);
        const Place<Fifty> exact_at{at.s, sqrt(1 - Fifty(at.s) * at.s)};
        CHECK(smooth::time(ratio, 1.0, e, at)
              == within_ulps(oracle::smooth_time(ratio, 1, exact_e, exact_at), 8, "the stated bound"));
      }
    }
}

TEST_CASE("arrays have the bits of single calls, and what makes no sense is refused")
{
  const std::vector<Energy<double>> e{energy(0.5), energy_from_top(1e-9), energy(2.0), energy(0.0)};
  std::vector<double> out(4);
  smooth::quarter(c, k, e, out);
  for(std::size_t i = 0; i < 4; ++i)
    CHECK(out[i] == smooth::quarter(c, k, e[i]));
  const std::vector<Place<double>> places{place(0.0), place(1.0), place(1.5), place(0.1)};
  smooth::time(c, k, energy(0.6), places, out);
  for(std::size_t i = 0; i < 4; ++i)
    CHECK(out[i] == smooth::time(c, k, energy(0.6), places[i]));
  const std::vector<double> tau{0.1, -3, 0, 50};
  std::vector<Turned> turned(4);
  smooth::angle(c, k, energy(0.6), tau, turned);
  for(std::size_t i = 0; i < 4; ++i)
    CHECK(turned[i].Phi == smooth::angle(c, k, energy(0.6), tau[i]).Phi);
  out.pop_back();
  CHECK_THROWS_AS(smooth::quarter(c, k, e, out), std::invalid_argument);
  CHECK_THROWS_AS(energy(-0.1), std::domain_error);
  CHECK_THROWS_AS(energy(std::nan("")), std::domain_error);
  CHECK_THROWS_AS(energy(std::numeric_limits<double>::infinity()), std::domain_error);
  CHECK_THROWS_AS(energy_from_top(1.5), std::domain_error);
  CHECK_THROWS_AS(energy_of_velocity(0.0, 1.0, 1.0, 1.0), std::domain_error);
  CHECK_THROWS_AS(place(-0.1), std::domain_error);
  CHECK_THROWS_AS(place(4.0), std::domain_error);
  CHECK_THROWS_AS(smooth::quarter(-0.1, k, energy(0.5)), std::domain_error);
  CHECK_THROWS_AS(smooth::quarter(c, 0.0, energy(0.5)), std::domain_error);
  CHECK_THROWS_AS(smooth::time(c, k, energy(0.5), place(2.0)), std::domain_error);
  CHECK_THROWS_AS(smooth::excess(c, k, energy(2.0)), std::domain_error);
}
