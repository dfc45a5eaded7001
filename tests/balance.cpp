// The balance's mechanics: the equations against Newton's, the motion against itself and against its limits.

#include <array>
#include <limits>
#include <stdexcept>

#include "balance/motion.hpp"
#include "balance/systems.hpp"
#include "edition/compare.hpp"

using namespace balance;
using edition::between, edition::Fifty, edition::within, edition::within_relative, edition::within_ulps;

namespace
{

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// λ = 1, μ = 3, i = ¼ as in §35, ρ = ¼, with round numbers for an instrument maker.
constexpr Instrument of_35{16. / 9, 32. / 9, 8. / 81, 10304. / 6561, 1, 4, 16};
constexpr Balance<> example{1, 9, 0.5, 0.25};

/// Where the balance comes to after the time s if its accelerations last.
State<Fifty> after(const Fifty& s, const State<Fifty>& now, const Angles<Fifty>& a)
{
  const auto angle = [&s](const auto& x, const auto& v, const auto& w) {
    return x + s * v + s * s * w / 2;
  };
  return {{angle(now.at.omega, now.rate.omega, a.omega), angle(now.at.eta, now.rate.eta, a.eta),
           angle(now.at.theta, now.rate.theta, a.theta)},
          {now.rate.omega + s * a.omega, now.rate.eta + s * a.eta, now.rate.theta + s * a.theta}};
}

/// §6: x, y of the pan P and x′, y′ of Q; outward and downward from C.
std::array<Fifty, 4> coordinates(const Fifty& a, const Fifty& b, const Angles<Fifty>& at)
{
  return {a * cos(at.omega) + b * sin(at.eta), b * cos(at.eta) - a * sin(at.omega),
          a * cos(at.omega) - b * sin(at.theta), b * cos(at.theta) + a * sin(at.omega)};
}

const std::array<State<Fifty>, 3> scenes{{{{0.1, -0.12, 0.08}, {0.3, -0.2, 0.4}},
                                          {{-0.9, 0.7, 1.3}, {1.1, -2.3, 0.6}},
                                          {{1.4, -0.2, -0.1}, {-0.4, 1.9, -3.1}}}};

}  // namespace

TEST_CASE("what is integrated are the accelerations, written by the sines and cosines of the three angles")
{
  const Balance<Fifty> b{0.9, 9.5, 0.5, 0.3};
  for(const State<Fifty>& now : scenes)
  {
    const std::array<Fifty, 3> v{now.rate.omega, now.rate.eta, now.rate.theta};
    std::array<elementary::SineCosine<Fifty>, 3> turned;
    const std::array<Fifty, 3> x{now.at.omega, now.at.eta, now.at.theta};
    for(std::size_t i = 0; i < x.size(); ++i)
      turned[i] = {sin(x[i]), cos(x[i])};
    std::array<Fifty, 3> got;
    systems::Fixed::accelerations(b, Fifty(0), x.data(), turned.data(), v.data(), got.data());
    const Angles<Fifty> a = accelerations(b, now);
    CHECK(got[0] == within_relative(a.omega, 1e-46, "some forty operations, of which few cancel"));
    CHECK(got[1] == within_relative(a.eta, 1e-46, "as before"));
    CHECK(got[2] == within_relative(a.theta, 1e-46, "as before"));
  }
}

TEST_CASE(
    "the accelerations satisfy Euler's five equations, with the two tensions eliminated in another way")
{
  const Instrument& r = of_35;
  const Fifty inertia = Fifty(r.M) * (Fifty(r.kk) + Fifty(r.c) * r.c);  // of the beam about C
  const Fifty pans = Fifty(r.L) * r.a * r.a;
  const Fifty I = inertia + 2 * pans;
  const Fifty G = 2 * Fifty(r.g);
  const Balance<Fifty> b{G * r.M * r.c / I, G / r.b, Fifty(r.a) / r.b, pans / I};
  for(const State<Fifty>& now : scenes)
  {
    const Angles<Fifty> acceleration = accelerations(b, now);
    const Fifty h("1e-14");
    const auto before = coordinates(r.a, r.b, after(-h, now, acceleration).at);
    const auto here = coordinates(r.a, r.b, now.at);
    const auto behind = coordinates(r.a, r.b, after(h, now, acceleration).at);
    std::array<Fifty, 4> pull;  // of the string on the pan, in weights, by second differences
    for(std::size_t k = 0; k < 4; ++k)
      pull[k] = (before[k] - 2 * here[k] + behind[k]) / (h * h) / (2 * Fifty(r.g)) - (k % 2 == 1 ? 1 : 0);
    const auto& [omega, eta, theta] = now.at;
    const char* reason = "second differences with h = 1e-14 leave h², and 50 digits lose 28";
    CHECK(pull[0] * cos(eta) - pull[1] * sin(eta) == within(0, 1e-20, reason));      // I and II
    CHECK(pull[2] * cos(theta) + pull[3] * sin(theta) == within(0, 1e-20, reason));  // III and IV
    const Fifty P = -pull[0] * sin(eta) - pull[1] * cos(eta);
    const Fifty Q = pull[2] * sin(theta) - pull[3] * cos(theta);
    const Fifty strings = -P * r.a * cos(omega - eta) + Q * r.a * cos(theta - omega);  // the pans weigh 1
    const Fifty momentum = -Fifty(r.M) * r.c * sin(omega) + strings;
    CHECK(acceleration.omega == within(momentum / inertia * 2 * r.g, 1e-18, reason));  // V
  }
}

TEST_CASE("the energy does not change along the motion")
{
  const Balance<Fifty> b{1.3, 7.1, 0.6, 0.41};
  for(const State<Fifty>& now : scenes)
  {
    const Angles<Fifty> a = accelerations(b, now);
    const Fifty h("1e-20");
    const Fifty slope = (energy(b, after(h, now, a)) - energy(b, after(-h, now, a))) / (2 * h);
    CHECK(slope == within(0, 1e-25, "a central difference with h = 1e-20 in fifty digits"));
  }
}

TEST_CASE("an instrument gives its four numbers, and what is none is refused")
{
  const Balance<> b = numbers_of(of_35);
  CHECK(b.lambda2 == within_ulps(1, 4, "half a dozen roundings"));
  CHECK(b.mu2 == within_ulps(9, 1, "b rounded"));
  CHECK(b.beta == 0.5);
  CHECK(b.rho == within_ulps(0.25, 4, "half a dozen roundings"));
  for(double Instrument::*which : {&Instrument::a, &Instrument::b, &Instrument::M, &Instrument::g})
    for(const double bad : {0.0, -1.0, not_a_number, infinity})
    {
      Instrument wrong = of_35;
      wrong.*which = bad;
      CHECK_THROWS_AS(numbers_of(wrong), std::domain_error);
    }
  Instrument point = of_35;
  point.kk = point.c = 0;
  CHECK_THROWS_AS(numbers_of(point), std::domain_error);
}

TEST_CASE("the motion agrees with the oracle and keeps the energy, and so does GSL's pair")
{
  const State<> start = released(1. / 6, 1. / 6, 1. / 6);
  Motion motion(example, start);
  for(const double t : {1.0, 10.0, 30.0})
  {
    const State<Fifty> exact = oracle(example, start, t);
    const State<> got = motion.to(t);
    CHECK(got.at.omega
          == within(exact.at.omega, 4e-15, "a tenth of a unit a step, and the last roundings"));
    CHECK(got.at.eta == within(exact.at.eta, 4e-15, "the same"));
    CHECK(got.rate.theta == within(exact.rate.theta, 12e-15, "the same, times μ"));
    CHECK(motion.energy_drift() < 1e-14);
    const State<> by_peer = by_gsl(example, start, t, 1e-13);
    CHECK(by_peer.at.eta == within(exact.at.eta, 1e-12, "tolerance 1e-13 a step, some hundred steps"));
  }
  CHECK_THROWS_AS(by_gsl(example, start, 1, 0), std::domain_error);
}

TEST_CASE("the motion does not depend on where one stops on the way")
{
  const State<> start{{0.3, -0.5, 0.7}, {0.1, 1.0, -1.0}};
  Motion whole(example, start);
  Motion halting(example, start);
  for(int k = 0; k < 100; ++k)
    halting.to(0.1 * k);
  CHECK(halting.to(10).at.eta == whole.to(10).at.eta);
}

TEST_CASE("a course is the motion at equal steps")
{
  const State<> start = released(1. / 6, 1. / 6, 0);
  const auto states = course(example, start, 6, 3);
  REQUIRE(states.size() == 4);
  CHECK(states[0].at.eta == start.at.eta);
  CHECK(states[3].at.theta
        == within(oracle(example, start, 6).at.theta, 1e-12, "some thirty steps, each to rounding"));
}

TEST_CASE("small swings keep together what a slight change puts apart, wild ones do not")
{
  CHECK(parting(example, released(1e-6, 1e-6, -1e-6), 6) == between(1, 1.01, "each its own cosine"));
  CHECK(parting({25, 400, 0.05, 0.45}, released(0, 0.35, -0.35), 20) > 1e6);
  CHECK(sure_until(example, released(1e-6, 1e-6, -1e-6), 6, 10) == 6);
  const double sure = sure_until({25, 400, 0.05, 0.45}, released(0, 0.35, -0.35), 20, 1e4);
  CHECK(sure == 20. / 64);
  CHECK(parting({25, 400, 0.05, 0.45}, released(0, 0.35, -0.35), sure) <= 1e4);
  CHECK(parting({25, 400, 0.05, 0.45}, released(0, 0.35, -0.35), 2 * sure) > 1e4);
}

TEST_CASE("seen in a mirror the balance moves as its image does")
{
  const State<> start{{0.3, -0.5, 0.7}, {0.1, 1.0, -1.0}};
  const State<> image{{-0.3, -0.7, 0.5}, {-0.1, 1.0, -1.0}};
  const State<> a = Motion(example, start).to(8);
  const State<> b = Motion(example, image).to(8);
  CHECK(a.at.omega == within(-b.at.omega, 1e-11, "the same sums in another order"));
  CHECK(a.at.eta == within(-b.at.theta, 1e-11, "the same"));
}

TEST_CASE("the classical rule is of the fourth order")
{
  const State<> start = released(1. / 6, 1. / 6, -1. / 6);
  const double exact = static_cast<double>(oracle(example, start, 5).at.eta);
  const auto error = [&](int steps) { return runge_kutta(example, start, 5, steps).at.eta - exact; };
  CHECK(error(200) / error(400) == between(14, 18, "2⁴, and the next order is not yet negligible"));
  CHECK_THROWS_AS(runge_kutta(example, start, 5, 0), std::invalid_argument);
}

TEST_CASE("for small swings the first order is wrong by squares, the second by cubes")
{
  const Balance<> b{1.21, 7.3, 0.6, 0.3};
  const auto errors = [&](double s) {
    const State<> start = released(0.5 * s, 0.4 * s, -0.7 * s);
    Motion motion(b, start, 1e-18);
    const Angles<> exact = motion.to(5).at;
    const Angles<> first = small_motion(b, start, 5);
    const Angles<> second = second_order(b, start.at, 5);
    return std::array{exact.omega - first.omega,  exact.eta - first.eta,  exact.theta - first.theta,
                      exact.omega - second.omega, exact.eta - second.eta, exact.theta - second.theta};
  };
  const auto large = errors(1e-3);
  const auto small = errors(1e-4);
  for(std::size_t k = 0; k < 3; ++k)
  {
    CHECK(large[k] / small[k] == between(97, 103, "10², but for the third order"));
    CHECK(large[k + 3] / small[k + 3] == between(980, 1020, "10³, but for the fourth order"));
  }
}

TEST_CASE("small motions are right for a falling and for an indifferent beam too")
{
  const State<> start{{0.01, 0.02, -0.03}, {0.02, -0.01, 0.05}};
  CHECK(small_motion({0, 9, 0.5, 0.25}, start, 3).omega == within_ulps(0.07, 1, "0.01 + 3·0.02"));
  const double falling = small_motion({-0.25, 9, 0.5, 0.25}, start, 3).omega;
  const double closed_form = 0.01 * std::cosh(1.5) + 0.04 * std::sinh(1.5);
  CHECK(falling == within_ulps(closed_form, 2, "the same formula, otherwise grouped"));
}

TEST_CASE("with a longer period a pan keeps time with a pendulum of its amplitude")
{
  // the beam held by its inertia: λ = 0, ρ = 0, so that P is a simple pendulum
  const double n = 0.1, t = 2 * std::numbers::pi / 3;
  const double exact = Motion({0, 9, 0.5, 0}, released(0, n, 0)).to(t).at.eta;
  const Angles<> longer = small_motion(with_longer_period({0, 9, 0.5, 0}, n), released(0, n, 0), t);
  CHECK(exact == within(longer.eta, 2e-6, "the third harmonic, n³/192 of it in n, and n⁵"));
  CHECK(std::abs(small_motion({0, 9, 0.5, 0}, released(0, n, 0), 5 * t).eta - n * std::cos(0)) < 1e-12);
}

TEST_CASE("a driven oscillator near resonance keeps its digits")
{
  for(const double p : {1.0, 2.9, 2.99999, 3 * (1 + 1e-12), 3.0000001, 7.0})
  {
    const Fifty q = 3;
    const Fifty exact = (cos(Fifty(p) * 10) - cos(q * 10)) / (q * q - Fifty(p) * p);
    CHECK(driven(3, p, 10) == within_relative(exact, 1e-14, "phases up to 50 rounded"));
  }
  CHECK(driven(3, 3, 10) == within_ulps(10 * sin(Fifty(30)) / 6, 4, "the limit, one sine"));
  CHECK(driven(3, 1, 0) == 0);
}

TEST_CASE("what is no motion is refused")
{
  const State<> start = released(0.1, 0.1, 0.1);
  CHECK_THROWS_AS(Motion({1, 0, 0.5, 0.25}, start), std::domain_error);
  CHECK_THROWS_AS(Motion({1, 9, 0, 0.25}, start), std::domain_error);
  CHECK_THROWS_AS(Motion({1, 9, 0.5, 0.5}, start), std::domain_error);
  CHECK_THROWS_AS(Motion({not_a_number, 9, 0.5, 0.25}, start), std::domain_error);
  CHECK_THROWS_AS(Motion(example, released(0.1, not_a_number, 0.1)), std::domain_error);
  CHECK_THROWS_AS(Motion(example, start, 0), std::domain_error);
  Motion motion(example, start);
  motion.to(1);
  CHECK_THROWS_AS(motion.to(0.5), std::invalid_argument);
  CHECK_THROWS_AS(motion.to(infinity), std::invalid_argument);
}
