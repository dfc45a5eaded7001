// Euler's approximate solution and what is complete to the second order, against fifty digits where it is hard; lengths,
// times, tensions; tables.

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "balance/euler.hpp"
#include "balance/instrument.hpp"
#include "edition/compare.hpp"

using namespace balance;
using edition::Fifty, edition::within, edition::within_relative, edition::within_ulps;

namespace
{

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Angles<Fifty> less(const Angles<>& a, const Angles<Fifty>& b)
{
  return {a.omega - b.omega, a.eta - b.eta, a.theta - b.theta};
}

bool all_within(const Angles<Fifty>& a, double eps)
{
  return abs(a.omega) <= eps && abs(a.eta) <= eps && abs(a.theta) <= eps;
}

}  // namespace

TEST_CASE("lengths and times of instruments")
{
  const Quantities w = quantities_of(light_pans);
  CHECK(w.f == within_relative(Fifty("33.43333333333333333333333"), 1e-15, "c is 0.1, rounded"));
  CHECK(w.lambda == within_relative(Fifty("0.9783295018333687241289968"), 1e-15, "the same"));
  CHECK(w.i == within_relative(Fifty("0.489164750916684362064498"), 1e-15, "the same"));
  CHECK(w.beam_time == within_relative(Fifty("3.211180535497003082448842"), 1e-15, "the same"));
  CHECK(w.pan_time == within_ulps(exact::pi() / 4, 1, "μ = 4"));
  CHECK(least_f(light_pans).f == within_relative(Fifty("3.651483716701107423046"), 1e-15, "a root"));
  CHECK(least_f(light_pans).c == within_relative(Fifty("1.825741858350553711523"), 1e-15, "a root"));
  CHECK(tilt(light_pans, 0.005)
        == within_ulps(atan(Fifty(0.005) * 2 / (Fifty(0.1) * 2)), 2, "two products"));
  const Quantities e = quantities_of(instrument_of_35);
  CHECK(e.lambda == within_ulps(1, 4, "the numbers of the instrument are rounded"));
  CHECK(e.f == within_ulps(32, 4, "the same"));
  CHECK(e.i == within_ulps(0.25, 4, "the same"));
  CHECK(e.rho == within_ulps(0.25, 4, "the same"));
  Instrument above{2, 2, -0.1, 1.44, 0.5, 2, 16};
  CHECK(quantities_of(above).kappa
        == within_relative(Fifty("0.9630868246861536060967261"), 1e-15, "−0.1 and 1.44, rounded"));
  CHECK(std::isnan(quantities_of(above).lambda));
}

TEST_CASE("as c vanishes f overflows, and nothing else does")
{
  const auto with = [](double c) {
    Instrument x = heavy_pans;
    x.c = c;
    return quantities_of(x);
  };
  CHECK(with(1e-3).f == within_relative(Fifty("5333.334333333333333333333"), 1e-15, "c rounded"));
  CHECK(with(1e-160).lambda
        == within_relative(Fifty("2.449489742783178098197284e-80"), 1e-15, "c rounded"));
  CHECK(slower_coefficient(with(1e-3))
        == within_relative(Fifty("0.004888562022708735401280793"), 1e-15, "the same"));
  CHECK(slower_coefficient(with(1e-8))
        == within_relative(Fifty("0.00001530977965674778139840049"), 1e-15, "the same"));
  CHECK(slower_coefficient(with(1e-160))
        == within_relative(Fifty("1.530931089239486311373303e-81"), 1e-15, "the same"));
  for(const double tiny : {1e-308, 1e-320, 5e-324})
  {
    const Quantities q = with(tiny);
    const Fifty inertia = 2 * Fifty(heavy_pans.kk) + 8;
    CHECK(q.lambda == within_relative(sqrt(Fifty(64) * tiny / inertia), 1e-15, "for exactly this c"));
    CHECK(q.f == (tiny < 1e-308 ? std::numeric_limits<double>::infinity() : q.f));
  }
  CHECK(with(0).lambda == 0);
  CHECK(with(0).f == std::numeric_limits<double>::infinity());
  CHECK(with(-1e-320).f == -std::numeric_limits<double>::infinity());
}

TEST_CASE("the five equations solved as they stand give the accelerations of the three, and the tensions")
{
  const Balance<> b = numbers_of(instrument_of_35);
  const std::array<State<>, 4> states{{{{1. / 6, 1. / 6, 1. / 6}, {}},
                                       {{0.1, -0.12, 0.08}, {0.3, -0.2, 0.4}},
                                       {{-0.9, 0.7, 1.3}, {1.1, -2.3, 0.6}},
                                       {{1.4, -0.2, -0.1}, {-0.4, 1.9, -3.1}}}};
  for(const State<>& now : states)
  {
    const Five five = five_equations(instrument_of_35, now);
    const Angles<> three = accelerations(b, now);
    const Tensions<> pulls = tensions(b, now);
    CHECK(five.acceleration.omega == within(three.omega, 1e-13, "terms up to 20, eliminated twice"));
    CHECK(five.acceleration.eta == within(three.eta, 1e-13, "the same"));
    CHECK(five.acceleration.theta == within(three.theta, 1e-13, "the same"));
    CHECK(five.tension.P == within(pulls.P, 1e-14, "the same, of order 1"));
    CHECK(five.tension.Q == within(pulls.Q, 1e-14, "the same"));
  }
  // a light beam between heavy pans: moments of a hundred leave an acceleration of 1e-14
  const Instrument light{10, 0.1, 0.01, 0.01, 10, 0.1, 16};
  const State<> still{{2e-9, 4e-9, -5e-9}, {}};
  CHECK(five_equations(light, still).acceleration.omega
        == within_ulps(accelerations(widened(light), widened(still)).omega, 1,
                       "one rounding, of fifty digits"));
  const Tensions<> at_start = tensions(b, states[0]), moving = tensions(b, states[1]);
  CHECK(at_start.P == within(Fifty("0.9769267797466242228252474143"), 1e-15, "some roundings"));
  CHECK(at_start.Q == within(Fifty("0.9953596833792258930361242316"), 1e-15, "the same"));
  CHECK(moving.P == within(Fifty("1.001135151697198489920498689"), 1e-15, "the same"));
  CHECK(moving.Q == within(Fifty("1.009584449337958701106200701"), 1e-15, "the same"));
  CHECK(first_order_tensions(b, states[0].at).P == within(Fifty(107) / 108, 1e-15, "one part in 108"));
  const Places<> at = places(16. / 9, 32. / 9, states[0].at);
  CHECK(at.x == within(Fifty("2.342996439021786883069277394"), 1e-15, "a and b rounded"));
  CHECK(at.y == within(Fifty("3.211360587435440149268409405"), 1e-15, "the same"));
  CHECK(at.x1 == within(Fifty("1.163290606535279989573161088"), 1e-15, "the same"));
  CHECK(at.y1 == within(Fifty("3.801213503678693596016467558"), 1e-15, "the same"));
}

TEST_CASE("the pans' accelerations are the second differences of their places")
{
  const Fifty a = 1.7, b = 3.2, h("1e-16");
  const State<Fifty> now{{-0.9, 0.7, 1.3}, {1.1, -2.3, 0.6}};
  const Angles<Fifty> to{0.4, -5, 2.1};
  const auto at = [&](const Fifty& t) {
    const auto angle = [&t](const Fifty& x, const Fifty& v, const Fifty& w) {
      return Fifty(x + t * v + t * t * w / 2);
    };
    return places<Fifty>(a, b,
                         {angle(now.at.omega, now.rate.omega, to.omega),
                          angle(now.at.eta, now.rate.eta, to.eta),
                          angle(now.at.theta, now.rate.theta, to.theta)});
  };
  const Places<Fifty> before = at(-h), here = at(0), after = at(h);
  const auto second = [&](Fifty Places<Fifty>::*which) {
    return (after.*which - 2 * here.*which + before.*which) / (h * h);
  };
  const Places<Fifty> got = place_accelerations<Fifty>(a, b, now, to);
  CHECK(got.x == within(second(&Places<Fifty>::x), 1e-15, "fifty digits over the square of the step"));
  CHECK(got.y == within(second(&Places<Fifty>::y), 1e-15, "the same"));
  CHECK(got.x1 == within(second(&Places<Fifty>::x1), 1e-15, "the same"));
  CHECK(got.y1 == within(second(&Places<Fifty>::y1), 1e-15, "the same"));
}

TEST_CASE("an instrument and a state in fifty digits are those in doubles, rounded less")
{
  for(const Instrument& x : {instrument_of_35, light_pans, Instrument{2, 3, -1e-9, 0.7, 1e5, 1e-3, 4.9}})
  {
    const Balance<> b = numbers_of(x);
    const Balance<Fifty> wide = widened(x);
    CHECK(b.lambda2 == within_relative(wide.lambda2, 1e-15, "eight roundings"));
    CHECK(b.mu2 == within_relative(wide.mu2, 1e-15, "a quotient"));
    CHECK(b.beta == within_relative(wide.beta, 1e-15, "a quotient"));
    CHECK(b.rho == within_relative(wide.rho, 1e-15, "eight roundings"));
  }
  CHECK_THROWS_AS(widened(Instrument{0, 1, 1, 1, 1, 1, 1}), std::domain_error);
  const State<Fifty> now = widened(State<>{{1, 2, 3}, {4, 5, 6}});
  CHECK((now.at.omega == 1 && now.at.eta == 2 && now.at.theta == 3));
  CHECK((now.rate.omega == 4 && now.rate.eta == 5 && now.rate.theta == 6));
}

TEST_CASE("the consistent second order leaves cubes of the exact accelerations, Euler's squares")
{
  const Balance<Fifty> b{1.21, 7.3, 0.6, 0.3};
  const auto left = [&b](const Fifty& s) {
    const State<Fifty> now{{0.5 * s, 0.4 * s, -0.7 * s}, {0.3 * s, -0.9 * s, 0.8 * s}};
    const Angles<Fifty> exact = accelerations(b, now), his = euler_accelerations(b, now.at),
                        second = second_order_accelerations(b, now);
    return std::array<Fifty, 4>{exact.eta - his.eta, exact.omega - his.omega, exact.eta - second.eta,
                                exact.omega - second.omega};
  };
  const auto large = left(Fifty("1e-10")), small = left(Fifty("1e-11"));
  for(std::size_t k = 0; k < 2; ++k)
  {
    CHECK(large[k] / small[k] == within(100, 1e-6, "squares, and cubes 1e-10 of them"));
    CHECK(large[k + 2] / small[k + 2] == within(1000, 1e-5, "cubes, and what is next"));
  }
}

TEST_CASE("the general solution, its constants, and back")
{
  const State<> start{{0.1, 0.12, -0.08}, {0.05, -0.2, 0.3}};
  const Found found = constants_of(1, 3, 0.25, start);
  const auto& k = found.constants;
  const char* because = "the start is rounded, and a dozen operations";
  CHECK(k.A == within_relative(Fifty("0.1371838144542968567486912029"), 1e-15, because));
  CHECK(k.alpha == within_relative(Fifty("2.075002112878088215830835056"), 1e-15, because));
  CHECK(k.B == within_relative(Fifty("0.1280059947007951270818951671"), 1e-15, because));
  CHECK(k.beta == within_relative(Fifty("-0.6719406753252774112234589477"), 1e-15, because));
  CHECK(k.C == within_relative(Fifty("0.1118033988749894848204586834"), 1e-15, because));
  CHECK(k.gamma == within_relative(Fifty("1.107148717794090503017065460"), 1e-15, because));
  CHECK(found.of_P == within_relative(Fifty("3.000045918367346938775510204"), 1e-15, because));
  const State<> at_2 = general<double>(1, 3, 0.25, k, 2), at_0 = general<double>(1, 3, 0.25, k, 0);
  CHECK(at_2.at.eta == within_relative(Fifty("0.1341421105245360458863356200"), 1e-14, because));
  CHECK(at_2.at.theta == within_relative(Fifty("-0.1037886118388151455168821129"), 1e-14, because));
  CHECK(at_0.rate.eta == within_relative(-0.2, 1e-14, because));
  CHECK(at_0.rate.theta == within_relative(0.3, 1e-14, because));
  CHECK(at_0.at.omega == within_relative(0.1, 1e-14, because));
  const auto [M, N] = sidebands<double>(1, 3, 0.25, 1. / 6, 1. / 6);
  CHECK(M == within_ulps(Fifty(1) / 360, 3, "a sixth rounded"));
  CHECK(N == within_ulps(Fifty(1) / 504, 3, "the same"));
  // against its own fifty digits at a late time
  const Constants<Fifty> wide{k.A, k.B, k.C, k.alpha, k.beta, k.gamma};
  const State<Fifty> exact = general<Fifty>(1, 3, 0.25, wide, 1e9);
  const State<> late = general<double>(1, 3, 0.25, k, 1e9);
  CHECK(late.at.eta == within(exact.at.eta, 1e-16, "an ulp of the amplitude 0.14, whatever the phase"));
  CHECK(late.rate.theta == within(exact.rate.theta, 3e-16, "the same, times μ"));
  CHECK_THROWS_AS(constants_of(2, 1, 0.25, start), std::domain_error);
  CHECK_THROWS_AS(constants_of(0, 1, 0.25, start), std::domain_error);
}

TEST_CASE("K, 1 ± K and where they vanish")
{
  // g = 18, a = 2: i = ¼, K = 1/420 for m = 1/6
  const Factors f = factors(1, 3, 2, 18, 1. / 6);
  CHECK(f.K == within_ulps(Fifty(1) / 420, 2, "a sixth rounded"));
  CHECK(f.one_plus == within_ulps(1 + Fifty(1) / 420, 1, "the same"));
  for(const double m : {1. / 6, -1. / 6})
  {
    const double root = lambda_where_K_is_one(3, 2, 18, m);
    for(const double lambda :
        {root, root * (1 + 1e-9), root * (1 - 1e-13), 3.0, 1e-9, 1e-150, 6 * (1 - 1e-15)})
    {
      const Factors got = factors(lambda, 3, 2, 18, m);
      const Fifty square = Fifty(lambda) * lambda, K = square * m / 2 / (36 - square);
      CHECK(got.K == within_relative(K, 3e-16, "rounded once from 100 bits"));
      CHECK(got.one_plus == within_relative(1 + K, 3e-16, "the same, however near to zero"));
      CHECK(got.one_minus == within_relative(1 - K, 3e-16, "the same"));
    }
  }
  CHECK(lambda_where_K_is_one(1, 2, 18, 1.5)
        == within_relative(Fifty("1.921537845661045601799044"), 3e-16, "am/b = 1/12"));
  CHECK(std::isnan(lambda_where_K_is_one(3, 2, 18, -2.1)));
  CHECK_THROWS_AS(factors(2, 1, 2, 18, 0.1), std::domain_error);
  CHECK_THROWS_AS(factors(1, 3, 2, 18, not_a_number), std::domain_error);
}

TEST_CASE("the formulae of § 33 and the complete second order keep their digits near every resonance")
{
  const auto at = [](double lambda, double mu, double i) {
    return Release{lambda, mu, i, {1. / 6, 0.15, -0.1}, 0.25};
  };
  for(const Release& r :
      {at(1, 3, 0.25), at(1, 2 * (1 + 1e-9), 0.25), at(1, 2 * (1 - 1e-9), 0.25), at(1, 2, 0.25),
       at(1, 0.5, 0.25), at(2 * (1 + 1e-10), 1, 0.25), at(1, 3, 1e-101), at(1e-9, 3, 1e-10), at(1, 1, 0.3)})
    for(const double t : {0.0, 1e-8, 1.0, 10.0, 1234.5, 1e7})
    {
      const auto w = widened(r);
      const double growth =
          1 + std::abs(r.i) * t * (1 + r.lambda) + 1e-3 / r.i * (r.i < 1e-50 ? 1e-3 * t : 0);
      const Angles<Fifty> left = less(second_order(r, t), second_order<Fifty>(w, t));
      CHECK(abs(left.eta) <= 1e-15 * growth);
      CHECK(abs(left.theta) <= 1e-15 * growth);
      if(r.i > 1e-50)
        CHECK(abs(left.omega) <= 1e-15 * (1 + t) * (1 + r.lambda / r.i));
      if(r.lambda != 2 * r.mu)
      {
        const double divisor = 1 + r.i * 0.2 / std::abs(2 * r.mu - r.lambda);
        CHECK(all_within(less(euler(r, t), euler<Fifty>(w, t)), 2e-16 * divisor));
        CHECK(all_within(less(euler_rates(r, t), euler_rates<Fifty>(w, t)), 2e-15 * divisor));
      }
      CHECK(all_within(less(euler_corrected(r, t), euler_corrected<Fifty>(w, t)), 5e-16));
    }
}

TEST_CASE("the formula of § 33 by its printed example; its start; the corrected amplitudes start where "
          "they should")
{
  const Angles<> at_2 = euler(example_of_35, 2.0);
  CHECK(at_2.eta == within(Fifty("0.1592648880177192939454797539"), 1e-16, "a sixth rounded"));
  CHECK(at_2.theta == within(Fifty("0.1607918741990693795697376787"), 1e-16, "the same"));
  CHECK(at_2.omega == within(Fifty("-0.06935780609119039783292803825"), 1e-16, "the same"));
  const Angles<> start = euler_start(example_of_35), formula = euler(example_of_35, 0.0);
  CHECK(start.eta == within_ulps(formula.eta, 1, "two ways to one number"));
  CHECK(start.theta == within_ulps(formula.theta, 1, "the same"));
  CHECK(start.eta == within_ulps(Fifty(421) / 2520, 2, "n(1 + 1/420)"));
  const Angles<> right = euler_corrected(example_of_35, 0.0);
  CHECK(right.eta == within_ulps(1. / 6, 1, "a product and a quotient"));
  CHECK(right.theta == within_ulps(1. / 6, 1, "the same"));
  CHECK(second_order(example_of_35, 0.0).eta == 1. / 6);
  const Release opened{1, 3, 0.25, {1. / 6, 0, 0}, 0.25};
  CHECK(second_order(opened, 1.0).eta
        == within(Fifty("-0.00159401572237029"), 1e-17, "to the digits that stand here"));
}

TEST_CASE("driven near resonance")
{
  for(const double delta : {1e-2, 1e-6, 1e-12, 0.0})
  {
    const double lambda = 1.5 * (1 + delta);
    const Fifty p = 2 * Fifty(lambda),
                exact = delta == 0 ? 10 * sin(Fifty(30)) / 6 : (cos(p * 10) - cos(Fifty(30))) / (9 - p * p);
    CHECK(driven(3, 2 * lambda, 10) == within_relative(exact, 1e-15, "two sines of phases up to 30"));
  }
}

TEST_CASE("a toppling beam: Euler's formula is real, and starts where it should")
{
  // §30's formula with λ = κ√−1, over its own value at the start
  using Complex = std::complex<double>;
  const Complex lambda{0, 0.5}, mu = 3, i = 0.5 * lambda / 2.0;
  const auto formula = [&](double t, double m) {
    return std::cos(mu * t)
           + i * m
                 * (std::cos((mu - lambda) * t) / (2.0 * mu - lambda)
                    - std::cos((mu + lambda) * t) / (2.0 * mu + lambda));
  };
  const Angles<> at = toppling<double>(0.5, 3, 0.5, {0.01, 1. / 6, -0.1}, 5);
  CHECK(at.eta
        == within_relative((formula(5, 0.01) / formula(0, 0.01)).real() / 6, 1e-14,
                           "hyperbolic functions to 6, phases of 15"));
  CHECK(at.theta
        == within_relative((formula(5, -0.01) / formula(0, -0.01)).real() * -0.1, 1e-14, "the same"));
  CHECK(at.omega
        == within_relative(Fifty("0.0613228947966368611661985231282"), 1e-15, "a hyperbolic cosine"));
  const Angles<> start = toppling<double>(0.5, 3, 0.5, {0.01, 1. / 6, -0.1}, 0);
  CHECK(start.eta == within_ulps(1. / 6, 1, "one quotient"));
  CHECK(start.theta == within_ulps(-0.1, 1, "the same"));
}

TEST_CASE("a table in degrees and minutes is rounded from the number itself")
{
  const Fifty sixth = Fifty(1) / 6;
  const ReleaseOf<Fifty> r{1, 3, 0.25, {sixth, sixth, sixth}, 0.25};
  const long omega[13]{600, 520, 300, 0, -300, -520, -600, -520, -300, 0, 300, 520, 600};
  const long eta[13]{601, 4, -601, -9, 599, 4, -599, 4, 599, -9, -601, 4, 601};
  const long theta[13]{599, -4, -599, 9, 601, -4, -601, -4, 601, 9, -599, -4, 599};
  for(int row = 0; row < 13; ++row)
  {
    const Row got = row_of(r, exact::pi() * row / 6, sixth, 10);
    CHECK(got.omega.all == omega[row]);
    CHECK(got.eta.all == eta[row]);
    CHECK(got.theta.all == theta[row]);
  }
  CHECK(row_of(r, 0, sixth, 10).eta.text() == "10°\u202f1′");
  CHECK(in_minutes(Fifty(-1) / 7200, 1, 60).text() == "−0°\u202f1′");  // half a minute, away from zero
  CHECK(in_minutes(Fifty("-0.000138888888888888888888"), 1, 60).text() == "0°\u202f0′");
  CHECK_THROWS_AS(in_minutes(1, 0, 10), std::domain_error);
  CHECK_THROWS_AS(in_minutes(not_a_number, 1, 10), std::domain_error);
}
