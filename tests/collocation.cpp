// Gauss' collocation: its numbers by what they must do, its motions against twenty and more digits, against themselves
// and against what must not be followed.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "balance/motion.hpp"
#include "balance/systems.hpp"
#include "edition/compare.hpp"

namespace
{

using balance::systems::Fixed;
using collocation::Ensemble, collocation::Moment, collocation::Motion;
using edition::within, edition::within_ulps, edition::between;
using exact::Fifty;
namespace number = collocation::coefficients;

/// §35's balance, ρ = ¼, from 10° or what Euler counts for it.
constexpr Fixed example{1, 9, 0.5, 0.25};
const Moment<3> start{{1. / 6, 1. / 6, 1. / 6}, {}};
const Moment<3> violent{{0.6, 0.9, -0.5}, {}};

/// x″ = −q² sin x.
struct Pendulum
{
  static constexpr unsigned freedoms = 1;
  double q2;

  template <class Of, class Real>
  ELEMENTARY_INLINE static void accelerations(const Of& of, const Real&, const Real* x, const Real*,
                                              Real* a)
  {
    a[0] = Real(-of.q2) * sincos(x[0]).sine;
  }
};

/// The same, which is given its sine.
struct Turning
{
  static constexpr unsigned freedoms = 1, angles = 1;
  double q2;

  template <class Of, class Real>
  ELEMENTARY_INLINE static void accelerations(const Of& of, const Real&, const Real*,
                                              const elementary::SineCosine<Real>* turned, const Real*,
                                              Real* a)
  {
    a[0] = Real(-of.q2) * turned[0].sine;
  }
};

/// x″ = −1/x²: a fall into the centre, which is reached in a finite time.
struct Fall
{
  static constexpr unsigned freedoms = 1;

  template <class Of, class Real>
  ELEMENTARY_INLINE static void accelerations(const Of&, const Real&, const Real* x, const Real*, Real* a)
  {
    a[0] = Real(-1.0) / (x[0] * x[0]);
  }
};

/// x″ = t³ − x′: the time and the rate occur.
struct Driven
{
  static constexpr unsigned freedoms = 1;

  template <class Of, class Real>
  ELEMENTARY_INLINE static void accelerations(const Of&, const Real& t, const Real*, const Real* v, Real* a)
  {
    a[0] = t * t * t - v[0];
  }
};

/// The same, the power of the time being found once a step.
struct Driven_once
{
  static constexpr unsigned freedoms = 1;

  template <class Of, class Real>
  ELEMENTARY_INLINE static Real driven(const Of&, const Real& t)
  {
    return t * t * t;
  }
  template <class Of, class Real>
  ELEMENTARY_INLINE static void accelerations(const Of&, const Real& cube, const Real*, const Real* v,
                                              Real* a)
  {
    a[0] = cube - v[0];
  }
};

template <unsigned n>
double farthest(const Moment<n>& a, const Moment<n>& b)
{
  double most = 0;
  for(unsigned k = 0; k < n; ++k)
    most = std::max({most, std::abs(a.x[k] - b.x[k]), std::abs(a.v[k] - b.v[k])});
  return most;
}

double energy_of(const Moment<3>& m)
{
  const balance::State<Fifty> now{{m.x[0], m.x[1], m.x[2]}, {m.v[0], m.v[1], m.v[2]}};
  return static_cast<double>(balance::energy(balance::Balance<Fifty>{1, 9, 0.5, 0.25}, now)
                                 / Fifty("0.26327860030442389931696936383381616")
                             - 1);
}

}  // namespace

TEST_CASE(
    "the stages and weights are Gauss': powers up to the fifteenth are integrated exactly, once and twice")
{
  for(int p = 0; p < 16; ++p)
  {
    Fifty once = 0, twice = 0;
    for(int j = 0; j < 8; ++j)
    {
      const Fifty power = pow(Fifty(number::c[j]), p);
      once += (Fifty(number::b[j]) + number::b_lost[j]) * power;
      twice += (Fifty(number::d[j]) + number::d_lost[j]) * power;
    }
    CHECK(once == within(Fifty(1) / (p + 1), 2e-16, "the stages are rounded, by 5e-17 each"));
    if(p < 15)
      CHECK(twice == within(Fifty(1) / ((p + 1) * (p + 2)), 2e-16, "the same"));
  }
  for(int i = 0; i < 8; ++i)
    for(int p = 0; p < 8; ++p)
    {
      Fifty once = 0, twice = 0;
      for(int j = 0; j < 8; ++j)
      {
        once += Fifty(number::once[j][i]) * pow(Fifty(number::c[j]), p);
        twice += Fifty(number::twice[j][i]) * pow(Fifty(number::c[j]), p);
      }
      CHECK(once == within(pow(Fifty(number::c[i]), p + 1) / (p + 1), 3e-16, "eight roundings"));
      if(p < 7)  // the first integral of the seventh power is beyond the polynomials
        CHECK(twice == within(pow(Fifty(number::c[i]), p + 2) / ((p + 1) * (p + 2)), 3e-16, "the same"));
    }
}

TEST_CASE("the weights for the last coefficients see Legendre's polynomials of the seventh and sixth "
          "degree alone")
{
  for(int p = 0; p < 8; ++p)
  {
    Fifty seventh = 0, sixth = 0;
    for(int j = 0; j < 8; ++j)
    {
      const Fifty x = 2 * Fifty(number::c[j]) - 1;
      Fifty before = 1, P = p == 0 ? Fifty(1) : x;
      for(int k = 2; k <= p; ++k)
      {
        const Fifty next = ((2 * k - 1) * x * P - (k - 1) * before) / k;
        before = P;
        P = next;
      }
      seventh += number::seventh[j] * P;
      sixth += number::sixth[j] * P;
    }
    CHECK(seventh == within(p == 7 ? 1 : 0, 4e-15, "weights up to 2, rounded, and the stages"));
    CHECK(sixth == within(p == 6 ? 1 : 0, 4e-15, "the same"));
  }
}

TEST_CASE(
    "Euler's example is followed to rounding, for a hundred periods and with its energy for ten thousand")
{
  Motion<Fixed> motion(example, start, {}, balance::systems::best().fixed);
  const Moment<3> at_1000 = motion.to(1000);
  const char* because = "a tenth of a unit a step, in the mean";
  CHECK(at_1000.x[0] == within(Fifty("0.1216967067005352530686950754"), 5e-14, because));
  CHECK(at_1000.x[1] == within(Fifty("-0.1123413278136499803957574146"), 5e-14, because));
  CHECK(at_1000.x[2] == within(Fifty("-0.1124984767990494148077891189"), 5e-14, because));
  CHECK(at_1000.v[0] == within(Fifty("0.08877064933263113544329503147"), 5e-14, because));
  CHECK(at_1000.v[2] == within(Fifty("0.3809404582690856151085762994"), 1.5e-13, "the same times μ"));
  double most = 0;
  for(int part = 1; part <= 10; ++part)
    most = std::max(most, std::abs(energy_of(motion.to(2000 * 3.14159 * part))));
  MESSAGE("energy over 10⁴ periods: ", most, ", steps ", motion.effort().steps);
  CHECK(most <= 3e-12);
}

TEST_CASE("a wild motion is right within its condition, or refused")
{
  const balance::Balance<> b{1, 9, 0.5, 0.25};
  const double t = 6 * 3.141592653589793;
  const auto exact = balance::oracle(b, balance::released(0.6, 0.9, -0.5), t);
  const Moment<3> reference{{static_cast<double>(exact.at.omega), static_cast<double>(exact.at.eta),
                             static_cast<double>(exact.at.theta)},
                            {static_cast<double>(exact.rate.omega), static_cast<double>(exact.rate.eta),
                             static_cast<double>(exact.rate.theta)}};
  double condition = 0;
  for(unsigned k = 0; k < 3; ++k)
  {
    Moment<3> beside = violent;
    beside.x[k] += 1e-9;
    condition = std::max(condition, farthest(Motion<Fixed>(example, beside).to(t), reference) / 1e-9);
  }
  const double error = farthest(Motion<Fixed>(example, violent).to(t), reference);
  MESSAGE("condition ", condition, ", error/condition ", error / condition * 0x1p52, " · 2⁻⁵²");
  CHECK(condition > 1000);
  CHECK(error <= 50 * 0x1p-52 * condition);
  // a first step far too long is shortened, not believed
  const double of_long = farthest(Motion<Fixed>(example, violent, {1e-14, 1000}).to(t), reference);
  CHECK(of_long <= 50 * 0x1p-52 * condition);
}

TEST_CASE("with a coarse tolerance the error stays below what the tolerance lets expect")
{
  const auto fine = Motion<Fixed>(example, start, {1e-18}).to(600);
  for(const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
  {
    Motion<Fixed> motion(example, start, {tolerance});
    const double error = farthest(motion.to(600), fine);
    CHECK(error <= tolerance * static_cast<double>(motion.effort().steps));
    CHECK(error > 0);
  }
}

TEST_CASE("gone back, a motion returns to where it was")
{
  const Moment<3> there = Motion<Fixed>(example, start).to(500);
  Moment<3> turned = there;
  for(double& v : turned.v)
    v = -v;
  const Moment<3> back = Motion<Fixed>(example, turned).to(500);
  CHECK(farthest(back, start) <= 1e-12);
}

TEST_CASE("the bits do not depend on the registers, on company, or on where one stops on the way")
{
  for(const Moment<3>& from : {start, violent})
  {
    Motion<Fixed> whole(example, from);
    const Moment<3> expected = whole.to(20);
    for(std::size_t i = 0; i < balance::systems::count(); ++i)
      CHECK(farthest(Motion<Fixed>(example, from, {}, balance::systems::kernels(i).fixed).to(20), expected)
            == 0);
    Motion<Fixed> halting(example, from);
    for(int k = 0; k < 57; ++k)
      halting.to(0.35 * k);
    CHECK(farthest(halting.to(20), expected) == 0);
  }
  std::array<Moment<3>, 8> starts;
  for(unsigned i = 0; i < 8; ++i)
    starts[i] = {{0.1 * i - 0.2, 0.9 - 0.25 * i, -0.5 + 0.13 * i}, {0.1, 0, 0.05 * i}};
  for(std::size_t i = 0; i < balance::systems::count(); ++i)
  {
    Ensemble<Fixed> together(example, starts, {}, balance::systems::kernels(i).fixed_together);
    together.to(3.21);
    const auto states = together.to(20);
    for(unsigned lane = 0; lane < 8; ++lane)
      CHECK(farthest(states[lane], Motion<Fixed>(example, starts[lane]).to(20)) == 0);
  }
}

TEST_CASE("equal pans in a symmetric motion stay equal to the last bit; the beam stays at rest")
{
  const Moment<3> swinging = Motion<Fixed>(example, {{0, 0.4, 0.4}, {0, -0.3, -0.3}}).to(100);
  CHECK(swinging.x[0] == 0);
  CHECK(swinging.x[1] == swinging.x[2]);
}

TEST_CASE("time and rates may occur in the accelerations")
{
  // x = t⁴/4 − t³ + 3t² − 6t + 6 − 6e⁻ᵗ
  const Fifty t = 5;
  const Fifty exact = pow(t, 4) / 4 - pow(t, 3) + 3 * t * t - 6 * t + 6 - 6 * exp(-t);
  CHECK(Motion<Driven>({}, {{0}, {0}}).to(5).x[0] == within_ulps(exact, 4, "some ten steps"));
}

TEST_CASE("what the time alone drives is found once a step, with the same bits, alone and among others")
{
  std::array<Moment<1>, 8> starts;
  for(unsigned i = 0; i < 8; ++i)
    starts[i] = {{0.1 * i}, {0.3 - 0.1 * i}};
  Ensemble<Driven_once> together({}, starts);
  const auto states = together.to(5);
  for(unsigned i = 0; i < 8; ++i)
  {
    const Moment<1> expected = Motion<Driven>({}, starts[i]).to(5);
    CHECK(farthest(Motion<Driven_once>({}, starts[i]).to(5), expected) == 0);
    CHECK(farthest(states[i], expected) == 0);
  }
}

TEST_CASE("sine and cosine are turned on by a small angle to rounding")
{
  for(const double x : {0.0, 0.3, -1.2, 1.57, 3.0, -40.0})
    for(const double by : {0.0, 1e-300, -1e-12, 1e-5, -1e-3, 0x1p-8, -0x1p-8})
    {
      double s[8], c[8];
      const auto turned = collocation::turned_on(sincos(collocation::Eight(x)), collocation::Eight(by));
      turned.sine.store(s);
      turned.cosine.store(c);
      const Fifty sum = Fifty(x) + by;
      CHECK(s[0] == within(sin(sum), 2.5 * 0x1p-53, "1.3 units of the given ones, and one rounding"));
      CHECK(c[7] == within(cos(sum), 2.5 * 0x1p-53, "the same"));
    }
}

TEST_CASE("who is given the sines moves as who finds them, alone and among others")
{
  std::array<Moment<1>, 8> starts;
  for(unsigned i = 0; i < 8; ++i)
    starts[i] = {{0.3 * i}, {0.5 - 0.2 * i}};
  const auto states = Ensemble<Turning>({1}, starts).to(100);
  for(unsigned i = 0; i < 8; ++i)
  {
    const Moment<1> alone = Motion<Turning>({1}, starts[i]).to(100);
    CHECK(farthest(states[i], alone) == 0);
    CHECK(farthest(alone, Motion<Pendulum>({1}, starts[i]).to(100)) <= 1e-12);
  }
}

TEST_CASE("a first step may be as small as it likes")
{
  const Moment<3> expected = Motion<Fixed>(example, start).to(3);
  for(const double step : {5e-324, 1e-300, 1e-20})
    CHECK(farthest(Motion<Fixed>(example, start, {1e-14, step}).to(3), expected) <= 1e-14);
}

TEST_CASE("with the tolerance at which the equations are not solved to rounding a hundred periods keep "
          "their energy")
{
  Motion<Fixed> motion(example, start, {3e-9, 0.05}, balance::systems::best().fixed);
  double most = 0;
  for(int part = 1; part <= 20; ++part)
    most = std::max(most, std::abs(energy_of(motion.to(10 * 3.14159 * part))));
  MESSAGE("energy over 100 periods: ", most);
  CHECK(most <= 5e-12);
  CHECK(motion.to(1000).x[0]
        == within(Fifty("0.1216967067005352530686950754"), 1e-10, "a thirtieth of the tolerance"));
}

TEST_CASE("a pendulum passes its lowest point when it must")
{
  // a quarter of the period at 150°, K(sin 75°), from the oracle of fifty digits: 1/agm
  const Fifty zeta = exact::pi() * 5 / 6;
  Fifty a = 1, g = cos(zeta / 2);
  for(int i = 0; i < 8; ++i)
  {
    const Fifty mean = (a + g) / 2;
    g = sqrt(a * g);
    a = mean;
  }
  const double quarter = static_cast<double>(exact::pi() / (2 * a));
  const Moment<1> there = Motion<Pendulum>({1}, {{static_cast<double>(zeta)}, {0}}).to(101 * quarter);
  CHECK(there.x[0]
        == within(0, 6e-13, "the speed 1.93 times 10⁻¹⁵ of the time 280, four units of its last place"));
}

TEST_CASE("what is not smooth is refused, and so is what is no motion")
{
  // the centre is reached at t = π/√8
  Motion<Fall> fall({}, {{1}, {0}});
  CHECK(fall.to(1.1).x[0] == between(0.01, 0.1, "not yet there"));
  CHECK_THROWS_AS(fall.to(1.2), std::runtime_error);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   inf = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(Motion<Fixed>(example, {{nan, 0, 0}, {}}), std::domain_error);
  CHECK_THROWS_AS(Motion<Fixed>(example, {{0, 0, 0}, {inf, 0, 0}}), std::domain_error);
  CHECK_THROWS_AS(Motion<Fixed>(example, start, {0, 0.1}), std::domain_error);
  CHECK_THROWS_AS(Motion<Fixed>(example, start, {1e-14, 0}), std::domain_error);
  CHECK_THROWS_AS(Motion<Fixed>(example, start, {1e-14, inf}), std::domain_error);
  Motion<Fixed> motion(example, start);
  motion.to(1);
  CHECK_THROWS_AS(motion.to(0.5), std::invalid_argument);
  CHECK_THROWS_AS(motion.to(nan), std::invalid_argument);
}
