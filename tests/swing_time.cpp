/// @file
/// Hard cases of the swing's time: the whole range of each function, the edges of its tables, and its ends.
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "swing/oracle.hpp"
#include "swing/time.hpp"
#include "swing_worst.hpp"

using exact::Fifty;
using swing::Amplitude;
namespace oracle = swing::oracle;

namespace
{

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

double batch(void (*f)(std::span<const double>, std::span<double>), double x)
{
  std::vector<double> in(9, x);
  std::vector<double> out(9);
  f(in, out);
  for(double y : out)
    if(y != out[0] && !(std::isnan(y) && std::isnan(out[0])))
      throw std::logic_error("an array of equal numbers gave different results");
  return out[0];
}

double K_batch(double k)
{
  return batch(swing::K, k);
}
double K_from_complement_batch(double kc)
{
  return batch(swing::K_from_complement, kc);
}
double ratio_from_bottom_batch(double zeta)
{
  return batch(swing::ratio_from_bottom, zeta);
}
double ratio_from_top_batch(double eta)
{
  return batch(swing::ratio_from_top, eta);
}

// The edges at which the rows of a table meet are among the numbers with seven bits.
template <class See>
void at_edges(double lowest, double last, See see)
{
  for(double octave = lowest; octave <= last; octave *= 2)
    for(int i = 0; i < 64; ++i)
    {
      const double edge = octave * (1 + i / 64.0);
      for(double x : {std::nextafter(edge, 0.0), edge, std::nextafter(edge, 10.0)})
        if(x <= last)
          see(x);
    }
}

}  // namespace

TEST_CASE("K(k): 10⁴ moduli in every octave of 1 − k, down to the last double below 1")
{
  Dice dice(1);
  for(int j = 1; j <= 53; ++j)
  {
    Worst one;
    Worst array;
    std::vector<double> k{1 - std::ldexp(1, -j)};
    for(int i = 0; i < 10000; ++i)
      k.push_back(1 - std::ldexp(dice.between(1, 2), -j));
    std::vector<double> together(k.size());
    swing::K(k, together);
    for(std::size_t i = 0; i < k.size(); ++i)
    {
      if(k[i] == 1)
        continue;
      const swing::Twofold exact = K_of(complement_of(k[i]));
      one.see(k[i], ulps(swing::K(k[i]), exact));
      array.see(k[i], ulps(together[i], exact));
    }
    CAPTURE(j);
    CAPTURE(one.at);
    CAPTURE(array.at);
    CHECK(one.error <= 0.6);
    CHECK(array.error <= 0.6);
  }
}

TEST_CASE("K(k) at the ends, far down, and out of range")
{
  const double pi_half = swing::pi_hi / 2;
  for(double k : {0.0, smallest, 1e-300, 1e-160, 1e-17})
  {
    CHECK(swing::K(k) == pi_half);
    CHECK(K_batch(k) == pi_half);
  }
  for(double k : {0.5, std::sqrt(0.5), 1 - 0x1p-27, 1 - 0x1p-35, 1 - 0x1p-53})
  {
    CAPTURE(k);
    CHECK(exact::ulps(swing::K(k), oracle::K(k)) <= 0.6);
    CHECK(exact::ulps(K_batch(k), oracle::K(k)) <= 0.6);
    CHECK(swing::K(-k) == swing::K(k));
    CHECK(K_batch(-k) == K_batch(k));
  }
  for(const auto f : {+[](double k) { return swing::K(k); }, K_batch})
  {
    CHECK(f(1) == inf);
    CHECK(f(-1) == inf);
    CHECK(std::isnan(f(std::nextafter(1, 2))));
    CHECK(std::isnan(f(2)));
    CHECK(std::isnan(f(inf)));
    CHECK(std::isnan(f(-inf)));
    CHECK(std::isnan(f(not_a_number)));
  }
}

TEST_CASE("K(k) where the rows of its table meet")
{
  Worst worst;
  at_edges(0x1p-10, 1, [&](double y) {
    const double k = 1 - y;
    worst.see(k, ulps(swing::K(k), K_of(complement_of(k))));
    const double below = std::nextafter(k, 0.0);
    worst.see(below, ulps(swing::K(below), K_of(complement_of(below))));
  });
  CAPTURE(worst.at);
  CHECK(worst.error <= 0.6);
}

TEST_CASE("K from the complement: all magnitudes, edges, ends")
{
  Dice dice(2);
  Worst one;
  Worst array;
  const auto see = [&](double kc) {
    const swing::Twofold exact = K_of({kc, 0});
    one.see(kc, ulps(swing::K_from_complement(kc), exact));
    array.see(kc, ulps(K_from_complement_batch(kc), exact));
  };
  at_edges(0x1p-10, 1, see);
  for(int i = 0; i < 20000; ++i)
    see(dice.unit());
  for(int i = 0; i < 20000; ++i)
    see(dice.log_between(1e-250, 1));
  CAPTURE(one.at);
  CAPTURE(array.at);
  CHECK(one.error <= 0.55);
  CHECK(array.error <= 0.55);

  for(double kc :
      {1.0, 0.5, 1e-154, 1e-155, 1e-300, 0x1p-1022, std::nextafter(0x1p-1022, 0.0), 1e-320, smallest})
  {
    CAPTURE(kc);
    CHECK(exact::ulps(swing::K_from_complement(kc), oracle::K_from_complement(kc)) <= 0.55);
    CHECK(exact::ulps(K_from_complement_batch(kc), oracle::K_from_complement(kc)) <= 0.55);
  }
  for(const auto f : {+[](double kc) { return swing::K_from_complement(kc); }, K_from_complement_batch})
  {
    CHECK(f(0) == inf);
    CHECK(std::isnan(f(std::nextafter(1, 2))));
    CHECK(std::isnan(f(-smallest)));
    CHECK(std::isnan(f(-0.5)));
    CHECK(std::isnan(f(inf)));
    CHECK(std::isnan(f(not_a_number)));
  }
}

TEST_CASE("T/Θ from ζ on all of [0, π], the double nearest to π and its neighbours included")
{
  Dice dice(3);
  Worst one;
  Worst whole;
  Worst array;
  const auto see = [&](double zeta) {
    const swing::Twofold eta =
        swing::sum_of(swing::pi_hi, -zeta) + swing::Twofold{swing::pi_lo, -0x1.f1976b7ed8fbcp-109};
    const swing::Twofold exact = ratio_of(K_of_eta(eta));
    one.see(zeta, ulps(swing::ratio_from_bottom(zeta), exact));
    whole.see(zeta, ulps(swing::ratio(Amplitude::from_zeta(zeta)), exact));
    array.see(zeta, ulps(ratio_from_bottom_batch(zeta), exact));
  };
  for(int i = 0; i < 30000; ++i)
    see(dice.between(0, swing::pi_hi));
  for(int i = 0; i < 20000; ++i)
    see(swing::pi_hi - dice.log_between(4e-16, 0.1));
  for(double zeta : {0.0, 1e-308, 1e-9, 1e-6, 1e-3, swing::pi_hi / 2, 170 * swing::pi_hi / 180,
                     179.9 * swing::pi_hi / 180, swing::pi_hi - 1e-4, swing::pi_hi - 1e-9,
                     std::nextafter(swing::pi_hi, 0.0), swing::pi_hi})
    see(zeta);
  CAPTURE(one.at);
  CAPTURE(whole.at);
  CAPTURE(array.at);
  CHECK(one.error <= 0.55);
  CHECK(whole.error <= 0.55);
  CHECK(array.error <= 0.55);

  for(const auto f : {+[](double zeta) { return swing::ratio_from_bottom(zeta); }, ratio_from_bottom_batch})
  {
    CHECK(std::isnan(f(std::nextafter(swing::pi_hi, 4.0))));
    CHECK(std::isnan(f(-smallest)));
    CHECK(std::isnan(f(-1)));
    CHECK(std::isnan(f(inf)));
    CHECK(std::isnan(f(not_a_number)));
  }
}

TEST_CASE("T/Θ and K(cos ½η) from η: all magnitudes, edges, ends")
{
  Dice dice(4);
  Worst one;
  Worst quarter;
  Worst array;
  const auto see = [&](double eta) {
    const swing::Twofold K = K_of_eta({eta, 0});
    one.see(eta, ulps(swing::ratio_from_top(eta), ratio_of(K)));
    quarter.see(eta, ulps(swing::quarter_time_from_top(eta), K));
    array.see(eta, ulps(ratio_from_top_batch(eta), ratio_of(K)));
  };
  at_edges(0x1p-8, swing::pi_hi, see);
  for(int i = 0; i < 20000; ++i)
    see(dice.between(0, swing::pi_hi));
  for(int i = 0; i < 20000; ++i)
    see(dice.log_between(1e-250, 1));
  CAPTURE(one.at);
  CAPTURE(quarter.at);
  CAPTURE(array.at);
  CHECK(one.error <= 0.6);
  CHECK(quarter.error <= 0.6);
  CHECK(array.error <= 0.6);

  for(double eta : {1e-1, 1e-16, 1e-150, 1e-154, 1e-300, 1e-308, 1e-320, smallest, swing::pi_hi})
  {
    CAPTURE(eta);
    const Fifty exact = oracle::ratio_from_top(eta);
    CHECK(exact::ulps(swing::ratio_from_top(eta), exact) <= 0.6);
    CHECK(exact::ulps(swing::quarter_time_from_top(eta), exact * exact::pi() / Fifty(2)) <= 0.6);
    CHECK(exact::ulps(ratio_from_top_batch(eta), exact) <= 0.6);
  }
  for(const auto f : {+[](double eta) { return swing::ratio_from_top(eta); }, ratio_from_top_batch,
                      +[](double eta) { return swing::quarter_time_from_top(eta); }})
  {
    CHECK(f(0) == inf);
    CHECK(std::isnan(f(std::nextafter(swing::pi_hi, 4.0))));
    CHECK(std::isnan(f(-smallest)));
    CHECK(std::isnan(f(not_a_number)));
  }
  CHECK(swing::ratio(Amplitude::from_eta(0)) == inf);
  CHECK(swing::quarter_time(Amplitude::from_eta(0)) == inf);
  CHECK(swing::ratio_excess(Amplitude::from_eta(0)) == inf);
}

TEST_CASE("T/Θ − 1 to a relative 10⁻¹⁵, from the smallest swings to the top")
{
  Worst worst;
  Dice dice(5);
  const auto see = [&](double zeta) {
    const Fifty exact = oracle::ratio_excess(zeta);
    const double got = swing::ratio_excess(Amplitude::from_zeta(zeta));
    worst.see(zeta, static_cast<double>(abs(Fifty(got) / exact - Fifty(1))));
  };
  for(int i = 0; i < 3000; ++i)
    see(dice.between(0, swing::pi_hi));
  for(int i = 0; i < 3000; ++i)
    see(dice.log_between(1e-150, 1));
  for(double zeta : {1e-150, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, swing::pi_hi / 2,
                     std::nextafter(swing::pi_hi / 2, 2.0)})
    see(zeta);
  CAPTURE(worst.at);
  CHECK(worst.error <= 1e-15);
  CHECK(swing::ratio_excess(Amplitude::from_zeta(0)) == 0);
  CHECK(swing::ratio_excess(Amplitude::from_zeta(1e-308)) == 0);  // 6·10⁻⁶¹⁸ is no double
}

TEST_CASE("an amplitude carries its supplement to the last digit, and what is no amplitude is refused")
{
  for(double zeta : {0.0, 1e-9, 1.0, 3.0, 3.14159, std::nextafter(swing::pi_hi, 0.0), swing::pi_hi})
  {
    CAPTURE(zeta);
    const Fifty eta = exact::pi() - Fifty(zeta);
    const Amplitude a = Amplitude::from_zeta(zeta);
    CHECK(a.zeta == zeta);
    CHECK(exact::ulps(a.eta, eta) <= 0.5);
    const Amplitude b = Amplitude::from_eta(zeta);
    CHECK(b.eta == zeta);
    CHECK(exact::ulps(b.zeta, eta) <= 0.5);
    // 2⁻¹⁰⁶, for π is carried to 107 bits.
    CHECK(static_cast<double>(abs(Fifty(a.eta) + Fifty(a.eta_rest) - eta)) <= 0x1p-106);
  }
  for(double bad : {std::nextafter(swing::pi_hi, 4.0), -smallest, -1.0, inf, not_a_number})
  {
    CHECK_THROWS_AS(Amplitude::from_zeta(bad), std::domain_error);
    CHECK_THROWS_AS(Amplitude::from_eta(bad), std::domain_error);
  }
  for(double bad : {std::nextafter(2, 3), -smallest, inf, not_a_number})
  {
    CHECK_THROWS_AS(Amplitude::from_height(bad), std::domain_error);
    CHECK_THROWS_AS(Amplitude::from_depth(bad), std::domain_error);
  }
}

TEST_CASE(
    "the height of the turning point goes in and comes back, from 10⁻³⁰⁰ to the last double below the top")
{
  for(double h : {1e-300, 1e-18, 1e-12, 1e-6, 1e-3, 0.3, 1.0, 1.2, 1.9, 1.999999, 2 - 0x1p-52})
  {
    CAPTURE(h);
    const Amplitude a = Amplitude::from_height(h);
    // An arc sine and a sine of half an ulp each, squared: 5 ulps, of the smaller of h and 2 − h.
    CHECK(exact::ulps(h <= 1 ? a.height() : a.depth(), h <= 1 ? Fifty(h) : Fifty(2) - Fifty(h)) <= 5);
    const Amplitude b = Amplitude::from_depth(h);
    CHECK(b.zeta == a.eta);
    CHECK(b.eta == a.zeta);
  }
  // Where 1 − cos ζ would have lost all: ζ = √(2h) (1 + h/12 + …).
  CHECK(exact::ulps(Amplitude::from_height(1e-18).zeta, sqrt(Fifty(2) * Fifty(1e-18))) <= 2);
  CHECK(exact::ulps(Amplitude::from_depth(1e-20).eta, sqrt(Fifty(2) * Fifty(1e-20))) <= 2);
}

TEST_CASE("the time to an angle on the way, from the bottom and from rest")
{
  Dice dice(6);
  Worst up;
  for(double zeta : {1e-6, 0.1, 1.0, 2.0, 3.0, 3.14})
    for(int i = 0; i < 300; ++i)
    {
      const double phi = dice.between(0, zeta);
      const Amplitude a = Amplitude::from_zeta(zeta);
      up.see(phi, exact::ulps(swing::time_from_bottom(phi, a),
                              oracle::time_from_bottom(phi, exact::pi() - Fifty(zeta))));
      CHECK(swing::time_from_bottom(-phi, a) == -swing::time_from_bottom(phi, a));
    }
  CAPTURE(up.at);
  CHECK(up.error <= 6);

  Worst down;
  Worst past;
  for(double eta : {3.0, 1.0, 1e-3, 1e-7, 9.9e-9, 1e-8, 1e-12, 1e-100, 1e-300})
    for(int i = 0; i < 300; ++i)
    {
      const double psi = dice.between(eta, swing::pi_hi);
      down.see(psi, exact::ulps(swing::time_from_rest(psi, eta),
                                oracle::time_from_rest_past(Fifty(psi) - Fifty(eta), eta)));
      const double little = eta * dice.log_between(1e-14, 0.04);
      past.see(little, exact::ulps(swing::time_from_rest_past(little, eta),
                                   oracle::time_from_rest_past(little, eta)));
    }
  CAPTURE(down.at);
  CAPTURE(past.at);
  CHECK(down.error <= 6);
  CHECK(past.error <= 6);
}

TEST_CASE(
    "k = 1, past a quarter turn: the times to an angle are elementary, up to the double before the top")
{
  const Amplitude top = Amplitude::from_eta(0);
  for(const double phi : {1e-300, 1.0, swing::pi_hi / 2, 1.6, 2.0, 3.0, 3.14159265,
                          std::nextafter(swing::pi_hi, 0.0), swing::pi_hi})
  {
    CAPTURE(phi);
    const Fifty exact = asinh(tan(Fifty(phi) / Fifty(2)));
    CHECK(exact::ulps(swing::time_from_bottom(phi, top), exact) <= 5);
    CHECK(swing::time_from_bottom(-phi, top) == -swing::time_from_bottom(phi, top));
  }
  CHECK(std::isnan(swing::time_from_bottom(std::nextafter(swing::pi_hi, 4.0), top)));
  CHECK(swing::time_from_rest(2, 0) == inf);
  CHECK(swing::time_from_rest_past(1e-300, 0) == inf);
  // With less than the last place of π to the top; and rest itself, where ζ as a double lies beyond it.
  for(const double eta : {1e-16, 1e-17, 1e-18, 1e-300})
    CHECK(exact::ulps(swing::time_from_bottom(swing::pi_hi, Amplitude::from_eta(eta)),
                      oracle::time_from_bottom(swing::pi_hi, eta))
          <= 5);
  for(const double eta : {0.3, 1.0, 1.1, 2.9})
  {
    const Amplitude a = Amplitude::from_eta(eta);
    CHECK(swing::time_from_bottom(a.zeta, a) <= swing::quarter_time(a) * (1 + 0x1p-50));
    CHECK(swing::time_from_bottom(a.zeta, a)
          >= swing::quarter_time(a) * (1 - 0x1p-24));  // half an ulp of ζ
  }
}

TEST_CASE("the time to an angle: ends and out of range")
{
  const Amplitude a = Amplitude::from_zeta(2);
  CHECK(swing::time_from_bottom(0, a) == 0);
  CHECK(exact::ulps(swing::time_from_bottom(2, a),
                    oracle::ratio_from_bottom(Fifty(2)) * exact::pi() / Fifty(2))
        <= 6);
  CHECK(std::isnan(swing::time_from_bottom(std::nextafter(2, 3), a)));
  CHECK(std::isnan(swing::time_from_bottom(not_a_number, a)));
  // Nothing underflows in the smallest swings, where the time is the arc whose sine is Φ/ζ.
  for(const double zeta : {1e-9, 1e-155, 1e-200, 1e-300})
    CHECK(exact::ulps(swing::time_from_bottom(zeta / 2, swing::Amplitude::from_zeta(zeta)), exact::pi() / 6)
          <= 2);
  CHECK(swing::time_from_rest(1e-3, 1e-3) == 0);
  CHECK(std::isnan(swing::time_from_rest(0.9e-3, 1e-3)));
  CHECK(std::isnan(swing::time_from_rest(3.2, 1e-3)));
  CHECK(std::isnan(swing::time_from_rest(1, -1e-3)));
  CHECK(std::isnan(swing::time_from_rest(not_a_number, 1e-3)));
  CHECK(swing::time_from_rest(1, 0) == inf);
  // From the smallest angle that there is: 744 + ln 8 − … without overflow.
  CHECK(exact::ulps(swing::time_from_rest(1, smallest),
                    oracle::time_from_rest_past(Fifty(1) - Fifty(smallest), smallest))
        <= 2);
  // The three printed in the notes: hardly past rest, from very near the top, and past rest by less than ψ
  // can carry.
  CHECK(exact::ulps(swing::time_from_rest_past(1e-18, 1e-12), oracle::time_from_rest_past(1e-18, 1e-12))
        <= 4);
  CHECK(exact::ulps(swing::time_from_rest_past(1e-13, 1e-3), oracle::time_from_rest_past(1e-13, 1e-3))
        <= 4);
}

TEST_CASE("at the ends of the doubles: the mean, and the times of the smallest swings")
{
  constexpr double largest = std::numeric_limits<double>::max();
  for(const auto& [a, b] : {std::pair{smallest, 2 * smallest},
                            {3 * smallest, 4 * smallest},
                            {7 * smallest, 8 * smallest},
                            {largest, largest},
                            {1e308, 0.9e308},
                            {smallest, largest},
                            {largest, smallest},
                            {1e-310, 1e-300},
                            {smallest, 1.0},
                            {1.0, smallest}})
  {
    const double at[] = {a, b};  // clang 14 captures no bindings
    CAPTURE(at[0]);
    CAPTURE(at[1]);
    // Of subnormal numbers the last step is half of the smallest double.
    const double allowed = a < 1e-307 && b < 1e-307 ? 0.5 + 1e-9 : 5;
    CHECK(exact::ulps(swing::agm(a, b), oracle::agm(a, b)) <= allowed);
  }
  CHECK(swing::agm(inf, 1) == inf);
  CHECK(swing::agm(1, inf) == inf);

  // From rest: the times of small angles depend on their quotient alone, down to arcosh 2.
  for(const auto& [past, eta] : {std::pair{smallest, smallest},
                                 {2 * smallest, smallest},
                                 {smallest, 1e-310},
                                 {1e-310, 1e-310},
                                 {3e-310, 1e-320},
                                 {1e-300, smallest},
                                 {1.0, smallest},
                                 {smallest, 1e-9},
                                 {smallest, 1e-3},
                                 {1e-320, 2.0},
                                 {1e-310, 1e-300}})
  {
    const double at[] = {past, eta};  // clang 14 captures no bindings
    CAPTURE(at[0]);
    CAPTURE(at[1]);
    CHECK(exact::ulps(swing::time_from_rest_past(past, eta), oracle::time_from_rest_past(past, eta)) <= 6);
  }
  CHECK(exact::ulps(swing::time_from_rest(2 * smallest, smallest),
                    oracle::time_from_rest_past(smallest, smallest))
        <= 6);

  for(const auto& [phi, zeta] : {std::pair{smallest, smallest},
                                 {2 * smallest, 3 * smallest},
                                 {1e-310, 1e-310},
                                 {1e-310, 3e-310},
                                 {smallest, 1e-3},
                                 {smallest, 1e-300},
                                 {1e-320, 3.0},
                                 {1e-290, 1e-280},
                                 {1e-300, 1e-100}})
  {
    const double at[] = {phi, zeta};  // clang 14 captures no bindings
    CAPTURE(at[0]);
    CAPTURE(at[1]);
    // The smallest swings take the arc whose sine is Φ/ζ.
    const Fifty exact = zeta < 1e-50 ? asin(Fifty(phi) / Fifty(zeta))
                                     : oracle::time_from_bottom(phi, exact::pi() - Fifty(zeta));
    CHECK(exact::ulps(swing::time_from_bottom(phi, Amplitude::from_zeta(zeta)), exact) <= 6);
  }
}

TEST_CASE("arrays of different length are refused")
{
  std::vector<double> three(3);
  std::vector<double> four(4);
  CHECK_THROWS_AS(swing::K(three, four), std::invalid_argument);
  CHECK_THROWS_AS(swing::K_from_complement(three, four), std::invalid_argument);
  CHECK_THROWS_AS(swing::ratio_from_bottom(three, four), std::invalid_argument);
  CHECK_THROWS_AS(swing::ratio_from_top(three, four), std::invalid_argument);
}
