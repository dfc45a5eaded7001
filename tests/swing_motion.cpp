/// @file
/// Hard cases of the swing's motion: turning points, long times, the top itself, and both sides of it.
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "swing/motion.hpp"
#include "swing/oracle.hpp"
#include "swing_worst.hpp"

using exact::Fifty;
using swing::Amplitude;
using swing::Motion;
using swing::Start;
namespace oracle = swing::oracle;

namespace
{

constexpr double epsilon = 0x1p-52;
constexpr double right_angle = swing::pi_hi / 2;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double distance(double got, const Fifty& exact)
{
  return static_cast<double>(abs(Fifty(got) - exact));
}

// How far Φ may be off in units of 2⁻⁵² ζ, read from rows and computed from the beginning: the rows are
// right to a rounding, and reading them rounds once more. And Φ' in units of 2⁻⁵² 2k.
constexpr double allowed_by_rows = 1.1;
constexpr double allowed = 2;
constexpr double allowed_velocity = 2.5;

// One amplitude, its motion and the oracle's; `since_bottom` is the time from the bottom to the clock's
// start.
struct Case
{
  Amplitude a;
  Motion motion;
  oracle::Motion exact;
  Fifty since_bottom = 0;

  static Case zeta(double z)
  {
    return {Amplitude::from_zeta(z), Motion(Amplitude::from_zeta(z)), oracle::Motion::from_zeta(z)};
  }
  static Case eta(double e)
  {
    const Amplitude a = Amplitude::from_eta(e);
    return {a, Motion(a), oracle::Motion::from_eta(e)};
  }
  Case from_rest() const { return {a, Motion(a, Start::rest), exact, exact.quarter()}; }

  double angle_error(double t) const
  {
    return distance(motion.angle(t), exact.angle(Fifty(t) + since_bottom)) / (epsilon * a.zeta);
  }
  double velocity_error(double t) const
  {
    return distance(motion.velocity(t), exact.velocity(Fifty(t) + since_bottom))
           / (epsilon * 2 * a.modulus());
  }
};

void check(const Case& c, const std::vector<double>& times)
{
  Worst angle;
  Worst velocity;
  for(double t : times)
  {
    angle.see(t, c.angle_error(t));
    velocity.see(t, c.velocity_error(t));
  }
  CAPTURE(c.a.zeta);
  CAPTURE(c.a.eta);
  CAPTURE(angle.at);
  CAPTURE(velocity.at);
  CHECK(angle.error <= (c.motion.rows(swing::kernels::angle) != nullptr ? allowed_by_rows : allowed));
  CHECK(velocity.error <= allowed_velocity);
}

// So many random times, in periods.
std::vector<double> random_times(Dice& dice, const Motion& m, int n, double first, double last)
{
  std::vector<double> times;
  for(int i = 0; i < n; ++i)
    times.push_back(m.period() * dice.between(first, last));
  return times;
}

std::vector<Case> cases()
{
  const double d = swing::pi_hi / 180;
  return {Case::zeta(1e-9),   Case::zeta(1e-5),    Case::zeta(1e-4),    Case::zeta(10 * d),
          Case::zeta(11 * d), Case::zeta(45 * d),  Case::zeta(89 * d),  Case::zeta(right_angle),
          Case::zeta(91 * d), Case::zeta(150 * d), Case::zeta(179 * d), Case::eta(1e-4),
          Case::eta(1e-9),    Case::eta(1e-15),    Case::eta(1e-100),   Case::eta(1e-307)};
}

}  // namespace

TEST_CASE("Φ and Φ' at random times within 100 periods")
{
  Dice dice(21);
  for(const Case& c : cases())
    check(c, random_times(dice, c.motion, 250, -100, 100));
}

TEST_CASE("the same after 10⁶ periods, and at t = 10¹²")
{
  Dice dice(22);
  for(const Case& c : cases())
  {
    check(c, random_times(dice, c.motion, 150, 1e6, 1e6 + 1));
    check(c, {1e9, 1e12, -1e12});
  }
}

TEST_CASE("at rest, at the bottom and one ulp beside them, after up to 10⁹ quarter periods")
{
  for(const Case& c : cases())
  {
    const double quarter = c.motion.period() / 4;
    std::vector<double> times;
    for(double n : {0.0, 1.0, 2.0, 3.0, 4.0, 1e6, 1e6 + 1, 1e9, 1e9 + 3})
      for(double towards : {0.0, n * quarter, 1e300})
        times.push_back(std::nextafter(n * quarter, towards));
    check(c, times);
    CAPTURE(c.a.zeta);
    CAPTURE(c.a.eta);
    CHECK(c.motion.angle(0) == 0);
    CHECK(exact::ulps(c.motion.velocity(0), Fifty(2) * sin(Fifty(c.a.zeta) / Fifty(2))) <= 4);
    // Φ(T/4) = ζ; there Φ is flat, so that the double nearest to T/4 is as good as T/4.
    CHECK(std::abs(c.motion.angle(quarter) - c.a.zeta) <= epsilon * c.a.zeta);
  }
}

TEST_CASE("Φ is odd and Φ' even to the last bit")
{
  Dice dice(23);
  for(const Case& c : cases())
  {
    const Motion rest(c.a, Start::rest);
    for(int i = 0; i < 200; ++i)
    {
      const double t = dice.log_between(1e-12, 1e6);
      CHECK(c.motion.angle(-t) == -c.motion.angle(t));
      CHECK(c.motion.velocity(-t) == c.motion.velocity(t));
      CHECK(rest.angle(-t) == rest.angle(t));
      CHECK(rest.velocity(-t) == -rest.velocity(t));
    }
  }
}

TEST_CASE("the first instants keep their relative accuracy: Φ = 2kt")
{
  for(const Case& c : cases())
    for(double t : {1e-150, 1e-20, 1e-12})
    {
      CAPTURE(c.a.zeta);
      CHECK(exact::ulps(c.motion.angle(t), Fifty(t) * Fifty(2) * sin(Fifty(c.a.zeta) / Fifty(2))) <= 8);
    }
}

TEST_CASE("the energy ½Φ'² + 1 − cos Φ does not change at 10⁶ random times")
{
  Dice dice(24);
  for(double zeta : {1e-5, 0.3, 1.0, right_angle, 2.0, 3.0, swing::pi_hi - 1e-6})
  {
    const Amplitude a = Amplitude::from_zeta(zeta);
    const Motion m(a);
    constexpr std::size_t n = 1000000;
    std::vector<double> t(n);
    std::vector<double> angle(n);
    std::vector<double> velocity(n);
    for(double& x : t)
      x = 1e6 * m.period() * dice.unit();
    m.angle(t, angle);
    m.velocity(t, velocity);
    const Fifty k = sin(Fifty(zeta) / Fifty(2));
    const Fifty exact = Fifty(2) * k * k;
    const double main = static_cast<double>(exact);
    const long double energy = main + static_cast<long double>(static_cast<double>(exact - main));
    Worst worst;
    for(std::size_t i = 0; i < n; ++i)
    {
      const long double v = velocity[i];
      const long double s = std::sin(static_cast<long double>(angle[i]) / 2);
      const long double off = (v * v / 2 + 2 * s * s - energy) / energy;
      worst.see(t[i], static_cast<double>(std::abs(off)) / epsilon);
    }
    CAPTURE(zeta);
    CAPTURE(worst.at);
    // Judged in long double, so that only Φ and Φ' are. 2¼ ε of Φ' are 4½ of its square, and Φ has its own
    // half.
    CHECK(worst.error <= 5);
  }
}

TEST_CASE("from rest it is the motion from the bottom a quarter period later")
{
  Dice dice(25);
  for(const Case& c : cases())
  {
    const Case rest = c.from_rest();
    CHECK(std::abs(rest.motion.angle(0) - c.a.zeta) <= epsilon * c.a.zeta);
    CHECK(rest.motion.velocity(0) == 0);
    check(rest, random_times(dice, rest.motion, 150, -10, 10));
  }
}

TEST_CASE("from rest at η = 10⁻⁹ the angle from the top grows as η cosh t, to its last digits")
{
  for(double eta : {1e-3, 1e-9, 1e-15, 1e-200, 1e-307})
  {
    const Motion m(Amplitude::from_eta(eta), Start::rest);
    const auto exact = oracle::Motion::from_eta(eta);
    CHECK(exact::ulps(m.angle_from_top(0), eta) <= 4);
    for(double t : {1e-3, 0.5, 1.0, 5.0, 15.0})
    {
      const Fifty psi = exact.angle_from_top(Fifty(t) + exact.quarter());
      CAPTURE(eta);
      CAPTURE(t);
      CHECK(distance(m.angle_from_top(t), psi) <= 4 * epsilon * static_cast<double>(psi));
    }
  }
}

TEST_CASE("the motion that just reaches the top is 2 arctan sinh t")
{
  const Motion m(Amplitude::from_eta(0));
  CHECK(std::isinf(m.period()));
  for(double t : {0.0, 1e-100, 1e-20, 1e-8, 0.1, 0.5, 0.8813, 0.8814, 1.0, 2.0, 5.0, 10.0, 30.0, 300.0})
  {
    CAPTURE(t);
    const Fifty s = sinh(Fifty(t));
    CHECK(exact::ulps(m.angle(t), Fifty(2) * atan(s)) <= 4);
    CHECK(exact::ulps(m.velocity(t), Fifty(2) / sqrt(Fifty(1) + s * s)) <= 4);
    CHECK(m.angle(-t) == -m.angle(t));
    CHECK(exact::ulps(m.angle_from_top(t), Fifty(2) * atan2(Fifty(1), s)) <= 4);
  }
  CHECK(m.angle(1e100) == swing::pi_hi);
  CHECK_THROWS_AS(Motion(Amplitude::from_eta(0), Start::rest), std::domain_error);
}

TEST_CASE("going round, from hardly over the top to very fast")
{
  Dice dice(26);
  for(double excess :
      {1e-300, 1e-30, 1e-18, 1e-9, 1e-3, 0.5, std::nextafter(1.0, 0.0), 1.0, 1.5, 100.0, 1e10, 1e300})
  {
    const Motion m = Motion::revolving(excess);
    const auto exact = oracle::Motion::revolving(excess);
    Worst angle;
    Worst velocity;
    for(double periods : {1.0, 1e6})
      for(int i = 0; i < 100; ++i)
      {
        const double t = m.period() * (dice.unit() + (periods - 1));
        const Fifty phi = exact.angle(t);
        angle.see(t, distance(m.angle(t), phi)
                         / (epsilon * std::fmax(swing::pi_hi, static_cast<double>(phi))));
        velocity.see(t, distance(m.velocity(t), exact.velocity(t)) / (epsilon * m.velocity(0)));
      }
    CAPTURE(excess);
    CAPTURE(angle.at);
    CAPTURE(velocity.at);
    CHECK(angle.error <= allowed);
    CHECK(velocity.error <= allowed_velocity);
    CHECK(exact::ulps(m.period(), Fifty(2) * exact.quarter()) <= 1);
    CHECK(m.angle(0) == 0);
  }
  for(double bad : {0.0, -1.0, not_a_number, std::numeric_limits<double>::infinity()})
    CHECK_THROWS_AS(Motion::revolving(bad), std::domain_error);
}

TEST_CASE("just below the top, just over it and on it, the way up is the same")
{
  // With 1 ∓ x of the energy, x = 10⁻³⁰, the paths part by x e²ᵗ/8.
  const Motion below(Amplitude::from_depth(2e-30));
  const Motion on(Amplitude::from_eta(0));
  const Motion over = Motion::revolving(1e-30);
  for(double t : {0.01, 0.3, 1.0, 3.0, 10.0, 15.0})
  {
    CAPTURE(t);
    CHECK(std::abs(below.angle(t) - on.angle(t)) <= 4 * epsilon);
    CHECK(std::abs(over.angle(t) - on.angle(t)) <= 4 * epsilon);
    CHECK(std::abs(below.velocity(t) - on.velocity(t)) <= 4 * epsilon);
    CHECK(std::abs(over.velocity(t) - on.velocity(t)) <= 4 * epsilon);
  }
}

TEST_CASE("over the top, the angle runs on and the energy stays")
{
  const Motion m = Motion::revolving(0.01);
  Dice dice(27);
  double before = 0;
  for(double t = 0; t < 40; t += 0.01)
  {
    const double phi = m.angle(t);
    CHECK(phi >= before);
    before = phi;
    const double s = std::sin(phi / 2);
    const double v = m.velocity(t);
    // 2(1 + excess); the angle of several turns carries its error into the sine.
    CHECK(std::abs(v * v / 2 + 2 * s * s - 2.02) <= 8 * epsilon * 2.02 + 2 * epsilon * phi);
  }
}

TEST_CASE("times that are no times, and times too far to tell")
{
  for(const Case& c : cases())
  {
    CHECK(std::isnan(c.motion.angle(not_a_number)));
    CHECK(std::isnan(c.motion.velocity(not_a_number)));
    CHECK(std::isnan(c.motion.angle(std::numeric_limits<double>::infinity())));
    CHECK(std::isnan(c.motion.angle(0x1p51 * c.motion.period())));
    CHECK(std::isfinite(c.motion.angle(0x1p48 * c.motion.period())));
  }
  const Motion still(Amplitude::from_zeta(0));
  CHECK(still.angle(3) == 0);
  CHECK(still.velocity(3) == 0);
  CHECK(still.period() == 2 * swing::pi_hi);
  std::vector<double> three(3);
  std::vector<double> four(4);
  CHECK_THROWS_AS(still.angle(three, four), std::invalid_argument);
  CHECK_THROWS_AS(still.velocity(three, four), std::invalid_argument);
  CHECK_THROWS_AS(still.angle_from_top(three, four), std::invalid_argument);
}
