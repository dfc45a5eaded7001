// Mathieu's side, the hung balance and its modes, the exchange: against references of thirty digits, against theory, and
// where the answer must be a refusal.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gsl/gsl_sf_mathieu.h>

#include "balance/causes.hpp"
#include "balance/exchange.hpp"
#include "balance/hung.hpp"
#include "balance/links.hpp"
#include "balance/mathieu.hpp"
#include "balance/motion.hpp"
#include "balance/small_swings.hpp"
#include "balance/systems.hpp"
#include "edition/compare.hpp"

using namespace balance;
using edition::between, edition::Fifty, edition::within, edition::within_relative, edition::within_ulps;

namespace
{

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr Prescribed_beam example{3, 1, 1. / 12};

double sum_of_squares(const Characteristic& c)
{
  double sum = c.first == 0 ? c.coefficients[0] * c.coefficients[0] : 0;
  for(const double x : c.coefficients)
    sum += x * x;
  return sum;
}

}  // namespace

TEST_CASE("a pan under a beam that swings as it must")
{
  const Pan start{1. / 6, 0};
  const struct
  {
    double t;
    const char *y, *rate;
  } known[]{{1, "-0.164521729939448645586397127653", "-0.0759054237665254826504075488147"},
            {10, "0.0268408648975119521854567", "0.493251077839027507222387344903"},
            {100, "-0.00275037761197794221668044979879", "0.497706265260156963382671328960"},
            {1000, "-0.161342869083424666247388713368", "-0.122603451314736766331758383261"}};
  for(const auto& [t, y, rate] : known)
  {
    const Pan at = pan_under(example, start, t);
    const double room = 1e-13 + 1e-14 * t;
    CHECK(at.y == within(Fifty(y), room / 6, "a sixth and a twelfth rounded, and one unit a period"));
    CHECK(at.rate == within(Fifty(rate), room / 2, "the same"));
  }
  const Pan other = pan_under({3, 1, -1. / 12}, start, 100);
  CHECK(other.y == within(Fifty("-0.00516356259471710040433855565805"), 1e-12, "the same"));
  const Pan late = pan_under(example, start, 2e5 * std::numbers::pi);
  CHECK(late.y
        == within(Fifty("-0.0949960793221589220018892195293"), 1e-9, "t is rounded by 6e-11, 10⁵ periods"));
  CHECK_THROWS_AS(pan_under(example, start, -1), std::domain_error);
  CHECK_THROWS_AS(pan_under({0, 1, 0.1}, start, 1), std::domain_error);
}

TEST_CASE("half trace, mean frequency and its shift")
{
  const Floquet f = floquet(example);
  CHECK(f.half_trace
        == within(Fifty("0.9999999946033331161218103498558603445574"), 1e-15, "products of order 1"));
  CHECK(f.shift
        == within_relative(-Fifty("0.00001653476151762942778724613813218851712756"), 1e-12,
                           "a twelfth rounded"));
  CHECK(f.frequency
        == within_ulps(3 - Fifty("0.00001653476151762942778724613813218851712756"), 1, "rounded once"));
  CHECK(f.growth == 0);
  CHECK(f.q == within_ulps(Fifty(1) / 6, 1, "rounded"));
  // to the leading order −p²λ⁴/(4μ(4μ²−λ²)), for the smallest p
  for(const double p : {1e-8, 1e-120})
    CHECK(floquet({3, 1, p}).shift
          == within_relative(-Fifty(p) * p / 420, 1e-14, "the next term is p² of it"));
  const Floquet mirrored = floquet({3, 1, -1. / 12});
  CHECK(mirrored.shift == f.shift);
  for(const double mu : {0.2, 0.7, 1.3, 2.2, 5.3, 19.7})
  {
    const Floquet g = floquet({mu, 1, 0.3});
    CHECK(g.growth == 0);
    CHECK(std::cos(2 * std::numbers::pi * g.frequency) == within(g.half_trace, 1e-12, "phases up to 124"));
  }
  CHECK_THROWS_AS(floquet({3, not_a_number, 0.1}), std::domain_error);
}

TEST_CASE("points of the stability chart by series: right in their domain, the same bits in every way")
{
  // from Taylor's series in mpmath
  CHECK(halves(36, 1. / 6).half_trace()
        == within(Fifty("0.9999999946033331161218103498558603445574"), 2e-14, "q rounded, terms up to 30"));
  const struct
  {
    double a, q;
    const char* sine2;
    double room;
  } known[]{{36, 0.16666666666666666, "2.6983334419390948250720698277213e-9", 2e-14},
            {1, 8, "-18.189773124368937317028941681738", 4e-13},
            {0, -8, "-7.2456559394438137520243752770952", 2e-13},
            {64, -2, "0.0000097324468679135681051640618331605", 1e-13},
            {99, 0.25, "0.0061906865808369164951538983488317", 2e-13},
            {100, 8, "0.00065248931780487109626602116431117", 2e-13},
            {250, -1.25, "0.08532495415508017832143663699845", 5e-12},
            {400, 8, "0.0000099266202021403138961426205916682", 1e-10}};
  for(const auto& [x, y, sine2, room] : known)
    CHECK(halves(x, y).sine2 == within(Fifty(sine2), room, "terms up to e^(0.66√a)"));
  std::vector<double> a, q;
  for(const double at : {0.0, 0.3, 1.0, 3.9, 9.0, 17.0, 36.0, 64.0, 77.7, 99.9, 123.0, 250.0, 400.0})
    for(const double strength : {-8.0, -1.3, -1e-9, 0.0, 0.25, 2.0, 8.0})
    {
      a.push_back(at);
      q.push_back(strength);
    }
  std::vector<Halves> row(a.size());
  halves(a, q, row);
  for(std::size_t k = 0; k < a.size(); ++k)
  {
    const Halves alone = halves(a[k], q[k]);
    CHECK(alone.sine2 == row[k].sine2);
    CHECK(alone.cosine2 == row[k].cosine2);
    const double room = (1 + std::abs(alone.sine2)) * (3e-15 + 2e-16 * std::exp(0.66 * std::sqrt(a[k])));
    CHECK(alone.sine2 + alone.cosine2 == within(1, room, "terms up to e^(0.66√a) cancel"));
    if(a[k] == 0)
      continue;
    const Floquet integrated = floquet({std::sqrt(a[k]) / 2, 1, q[k] / 2});
    CHECK(alone.half_trace() == within(integrated.half_trace, 4 * room, "the same, and √a is rounded"));
  }
  for(std::size_t v = 0; v < systems::count(); ++v)
    for(const std::size_t count : {std::size_t{1}, std::size_t{7}, std::size_t{8}, a.size()})
    {
      std::vector<Halves> by_variant(count);
      systems::kernels(v).halves_of_many(a.data(), q.data(), by_variant.data(), count);
      for(std::size_t k = 0; k < count; ++k)
      {
        Halves one{};
        systems::kernels(v).halves_of_one(a[k], q[k], one);
        CHECK(by_variant[k].sine2 == row[k].sine2);
        CHECK(by_variant[k].cosine2 == row[k].cosine2);
        CHECK(one.sine2 == row[k].sine2);
        CHECK(one.cosine2 == row[k].cosine2);
      }
    }
  for(const auto& [x, y] :
      {std::pair{-1e-9, 0.0}, {401.0, 0.0}, {1.0, 8.01}, {not_a_number, 0.0}, {1.0, not_a_number}})
    CHECK_THROWS_AS(halves(x, y), std::domain_error);
  CHECK_THROWS_AS(halves(a, std::span(q).first(3), row), std::invalid_argument);
}

TEST_CASE("growth, and the edges of the intervals in which swings grow")
{
  CHECK(floquet({1, 2, 1. / 12}).growth
        == within_relative(Fifty("0.08306416021978094041314227883700888267093"), 1e-12, "p rounded"));
  CHECK(floquet({1, 2, 0.05}).growth
        == within_relative(Fifty("0.04994157019841303062587848724643262581460"), 1e-12, "p rounded"));
  CHECK(floquet({1, 1, 1. / 12}).growth
        == within_relative(Fifty("0.00064696628124313594597925084216820936"), 1e-10,
                           "a root of a product of 4e-6"));
  const Interval first = unstable(1, 1. / 12, 1);
  CHECK(first.from
        == within_relative(Fifty("1.85445981516376636547279238204"), 1e-14, "an eigenvalue of order 1"));
  CHECK(first.to == within_relative(Fifty("2.19537392893105113509766093184"), 1e-14, "the same"));
  for(const int order : {1, 2, 3})
  {
    const Interval i = unstable(1, 1. / 12, order);
    const double width = i.to - i.from;
    CHECK(floquet({1, i.from + 0.01 * width, 1. / 12}).growth > 0);
    CHECK(floquet({1, i.to - 0.01 * width, 1. / 12}).growth > 0);
    CHECK(floquet({1, i.from - 0.01 * width, 1. / 12}).growth == 0);
    CHECK(floquet({1, i.to + 0.01 * width, 1. / 12}).growth == 0);
    CHECK(floquet({1, (i.from + i.to) / 2, 1. / 12}).frequency
          == within_relative(order * (i.from + i.to) / 4, 1e-15, "½λ times the order"));
  }
  CHECK_THROWS_AS(unstable(1, 0.1, 0), std::domain_error);
  CHECK_THROWS_AS(unstable(1, 0.5, 1), std::domain_error);
}

TEST_CASE("characteristic values and functions")
{
  for(const double q : {-20.0, 0.0, 1. / 6, 5.0, 29.5, 30.0, 90.0, 1000.0})
    for(const int n : {0, 1, 2, 5, 10, 12})
    {
      const Characteristic a = cosine_characteristic(n, q);
      gsl_sf_result peer;
      gsl_sf_mathieu_a_e(n, q, &peer);
      CHECK(a.value
            == within(peer.val, 1e-13 * (n * n + 2 * std::abs(q) + 1000), "GSL's, which is sound here"));
      CHECK(sum_of_squares(a) == within(1, 1e-14, "made so"));
      const double lines = static_cast<double>(a.coefficients.size());
      CHECK(a.residual < 1e-14 * 4 * lines * lines);  // of the size of the matrix
      if(n > 0)
        CHECK(sine_characteristic(n, q).residual < 1e-11);
    }
  // values do not change sign on the way from q = 29.5 to 30, as GSL's do
  const auto at_zero = [](const Characteristic& c) {
    return std::accumulate(c.coefficients.begin(), c.coefficients.end(), 0.0);
  };
  CHECK(at_zero(cosine_characteristic(5, 29.5)) > 0);
  CHECK(at_zero(cosine_characteristic(5, 30)) > 0);
  for(const double q :
      {29.5, 30.0, 60.0, 90.0})  // five zeros lie between 0 and a half turn: at a quarter turn it falls
  {
    const Characteristic c = cosine_characteristic(5, q);
    double slope = 0;
    for(std::size_t k = 0; k < c.coefficients.size(); ++k)
      slope -= c.coefficients[k] * static_cast<double>(2 * k + 1) * (k % 2 == 0 ? 1 : -1);
    CHECK(slope < 0);
  }
  CHECK(cosine_characteristic(5, 21).value == between(37.46, 37.47, "SciPy 1.10 has a₃, 14.99"));
  CHECK(cosine_characteristic(3, 0).value == 9);
  CHECK_THROWS_AS(sine_characteristic(0, 1), std::domain_error);
  CHECK_THROWS_AS(cosine_characteristic(1, not_a_number), std::domain_error);
}

TEST_CASE("the designed instrument has the frequencies it was designed for, and passes everything")
{
  const auto all = modes(designed);
  REQUIRE(all.size() == 4);
  const double expected[]{1, 2.6, 4, 4.2};
  for(std::size_t k = 0; k < 4; ++k)
    CHECK(all[k].frequency == within_relative(Fifty(expected[k]), 1e-15, "h, M and c are rounded"));
  CHECK(all[2].shape.eta == 1);
  CHECK(all[2].shape.theta == -1);
  const Transfer t = transfer(designed);
  CHECK(t.time == within_relative(5 * exact::pi(), 2e-15, "a difference of 0.2 of frequencies near 4"));
  CHECK(t.estimate == within_relative(Fifty("15.790014035872673656"), 1e-14, "the same numbers rounded"));
  const double half = 5 * std::numbers::pi;
  const Full_state there = linear_motion(designed, {{0, 0, 1, 0}, {}}, half),
                   back = linear_motion(designed, {{0, 0, 1, 0}, {}}, 2 * half);
  CHECK(there.at.theta == within(-1, 1e-13, "h, M and c are rounded, phases of 66"));
  CHECK(there.at.eta == within(0, 1e-13, "the same"));
  CHECK(there.at.phi == within(0, 1e-13, "the same"));
  CHECK(back.at.eta == within(1, 1e-13, "the same"));
  const Full_state late = linear_motion(designed, {{0, 0, 1, 0}, {}}, half * 1e6);
  CHECK(late.at.theta == within(0, 2e-7, "10⁶ times: h, M and c are rounded by 1e-16, and t by 1e-9"));
  const Full_state moving{{0.01, -0.02, 0.03, 0.04}, {0.1, 0.2, -0.3, 0.4}};
  const Full_state at_start = linear_motion(designed, moving, 0);
  CHECK(at_start.at.omega == within(-0.02, 1e-15, "the modes are complete"));
  CHECK(at_start.rate.theta == within(0.4, 1e-14, "the same"));
  CHECK(at_start.rate.phi == within(0.1, 1e-14, "the same"));
}

TEST_CASE(
    "the small motion keeps its digits where the masses are nearly singular and the modes nearly cancel")
{
  // a beam of a ten thousandth of a pan's weight on very short shears: from mpmath, sixty digits
  const Suspended light{{0.1, 100, 10, 10000, 100, 0.01, 0.1}, 0.01};
  const Four now = linear_motion(light, {{0, 0, 0.17453292519943295, 0}, {}}, 10).at;
  CHECK(now.phi == within_relative(Fifty("0.154517572140052182779925"), 4e-16, "one rounding"));
  CHECK(now.theta == within_relative(Fifty("-0.00001460801711001171799712512"), 4e-16, "the same"));
}

TEST_CASE("the exact motion with C movable")
{
  const char* because = "the instrument's numbers are rounded, some hundred steps to rounding";
  const auto check = [because](const Full_state& got, const char* phi, const char* omega, const char* eta,
                               const char* theta, double room) {
    CHECK(got.at.phi == within(Fifty(phi), room, because));
    CHECK(got.at.omega == within(Fifty(omega), room, because));
    CHECK(got.at.eta == within(Fifty(eta), room, because));
    CHECK(got.at.theta == within(Fifty(theta), room, because));
  };
  Full_motion tenth(designed, {{0, 0, 0.1, 0}, {}});
  check(tenth.to(1), "-0.00069398955207274312931083039", "0.00030857670497547676588748689",
        "-0.058506641035090387932100790", "0.0069852896308027956584789987", 1e-15);
  check(tenth.to(5 * std::numbers::pi), "-5.0489437061156615493535546e-7",
        "-9.3059241118727500022125496e-8", "2.9618362076712628444986606e-6",
        "-0.099978055433057758833316953", 1e-14);
  check(tenth.to(10 * std::numbers::pi), "2.0193149366215076697727999e-6", "3.7198091347887678040121238e-7",
        "0.099912231933714499601203726", "-0.000011844333076331895048698205", 2e-14);
  CHECK(tenth.energy_drift() < 1e-13);
  Full_motion round(plain, {{0, 0, 1. / 6, 0}, {}});
  check(round.to(10), "0.0012036258978077770381039867", "0.0011001714930599545991617830",
        "0.00054201370293763711946224553", "0.10820686209809760272086587", 2e-14);
  check(round.to(60), "-0.0060105512012428530924600189", "0.0052351056061587358547760446",
        "0.078535450217562335054526297", "0.00036258844742331301903828302", 1e-13);
}

TEST_CASE(
    "links give the motion, the energy and the small motions of the balance with shears, or with C fixed")
{
  const Full_state start{{0.1, 0.3, -0.5, 0.7}, {-0.2, 0.1, 1.0, -1.0}};
  const Full_state fixed{{0, 0.3, -0.5, 0.7}, {0, 0.1, 1.0, -1.0}};
  const Suspended held{light_pans, 1, 0.3, false};
  for(const auto& [s, from] : {std::pair{plain, start}, std::pair{held, fixed}})
  {
    Full_motion motion(s, from);
    const Full_state now = motion.to(4);
    const links::Place<double> other = links::followed(s, from, 4), mine = links::place(now);
    for(std::size_t k = 0; k < 4; ++k)
    {
      CHECK(other.q[k] == within(mine.q[k], 1e-9, "the classical rule"));
      CHECK(other.v[k] == within(mine.v[k], 1e-8, "the same, of rates some times as great"));
    }
    const Energies shares = energies(s, now);
    const double all = shares.P + shares.Q + shares.rest;
    CHECK(links::built(s).energy(mine) == within_relative(all, 1e-14, "sums"));
    const Energies parts = links::built(s).shares(mine);
    CHECK(parts.P == within_relative(shares.P / all, 1e-13, "sums"));
    CHECK(parts.Q == within_relative(shares.Q / all, 1e-13, "sums"));
    CHECK(parts.P + parts.Q + parts.rest == within_ulps(Fifty(1), 2, "sums"));
  }
  const auto widened = [](const Suspended& s, const Fifty& longer) {
    const Instrument& x = s.beam;
    return links::Built<Fifty>{s.h, x.a, x.b, x.b * (1 + longer), x.c, x.kk, x.L, x.M, 2 * Fifty(x.g)};
  };
  const links::Place<Fifty> later =
      links::small_motion(widened(designed, 0), {{0, 0, 1, 0}, {}}, 5 * exact::pi(), 30);
  CHECK(later.q[3] == within(Fifty(-1), 1e-14, "designed so, its numbers rounded"));
  CHECK(links::handed_on(widened(designed, 0)) == within_relative(Fifty(1), 1e-18, "equal strings"));
  for(const double longer : {0.01, 0.1, -0.2})
    for(const Suspended& s : {designed, plain})
      CHECK(handed_on(s, longer) == within_relative(links::handed_on(widened(s, longer)), 1e-12, "GSL's"));
}

TEST_CASE("the cubic in fifty digits has the designed roots, and the shapes that the masses ask for")
{
  const Instrument& x = designed.beam;
  const links::Built<Fifty> of{designed.h, x.a, x.b, x.b, x.c, x.kk, x.L, x.M, 2 * Fifty(x.g)};
  const Small_swings small(of);
  Fifty sum = 0;
  for(const int fifths : {5, 13, 21})
  {
    const Small_swings::Way way = small.together(Fifty(fifths * fifths) / 25 + Fifty("1e-3"));
    CHECK(way.square == within_relative(Fifty(fifths * fifths) / 25, 1e-14, "M, c and h rounded"));
    sum += way.square;
    // the masses at rest times the shape, times σ², are the stiffness times it
    const auto masses = of.equations({});
    const auto stiffness = of.stiffness();
    for(std::size_t i{0}; i < 4; ++i)
    {
      Fifty left = -stiffness[i] * way.shape[i];
      for(std::size_t k{0}; k < 4; ++k)
        left += way.square * masses[i][k] * way.shape[k];
      CHECK(left == within(0, 1e-36, "fifty digits"));
    }
  }
  CHECK(sum == within_relative(small.sum_of_roots(), 1e-36, "fifty digits"));
  CHECK(small.rough_time() == within_relative(Fifty(transfer(designed).estimate), 1e-14, "some products"));
  const Small_swings::Limits limits = small.limits(Fifty(1) / 5, Fifty(1) / 2);
  CHECK(limits.critical == within_relative(sqrt(Fifty(8) / 5), 1e-14, "√(32σ/μ), μ = 4"));
  CHECK(limits.reach == 1);
  CHECK(Small_swings::reach(2) == within_relative(trapping(1. / 32, 1, 2).reach, 1e-15, "doubles"));
}

TEST_CASE("three causes: by each the motion passes, in the time that its theory has; without any it stays")
{
  for(const Cause by : {Cause::pivot, Cause::beam, Cause::ends})
  {
    const Farthest seen = causes::passing(by);
    CHECK(causes::theory(by) == within_relative(causes::theory_exactly(by), 1e-10, "differences"));
    CHECK(seen.time == within_relative(causes::theory(by), 0.03, "a flat top"));
    CHECK(seen.Q / causes::of_P == between(0.98, 1.02, "nearly all"));
    CHECK(causes::way(by).size() == 131);
  }
  CHECK(causes::passing(Cause::none).Q / causes::of_P < 0.01);
  CHECK(std::isinf(causes::theory(Cause::none)));
  CHECK_THROWS_AS(causes::theory_exactly(Cause::none), std::invalid_argument);
}

TEST_CASE("the exchange by shears keeps together what a slight change puts apart, a wild motion does not")
{
  CHECK(parting(designed, {{0, 0, 0.01, 0}, {}}, 30) == between(1, 10, "slow beats"));
  const Suspended light{{2, 2, 0.4, 0.3, 4, 1, 16}, 1};
  CHECK(parting(light, {{0.3, 0.3, -0.5, 0.5}, {1, 1, 1, 1}}, 60) > 1e4);
}

TEST_CASE("with C fixed and no offset the full equations are those of the balance in its four numbers")
{
  const Suspended held{instrument_of_35, 1, 0, false};
  const State<> start{{0.3, -0.5, 0.7}, {0.1, 1.0, -1.0}};
  Full_motion full(held, {{0, 0.3, -0.5, 0.7}, {0, 0.1, 1.0, -1.0}});
  Motion three({1, 9, 0.5, 0.25}, start);
  const Full_state a = full.to(6);
  const State<> b = three.to(6);
  CHECK(a.at.phi == 0);
  CHECK(a.at.omega == within(b.at.omega, 1e-12, "the instrument's numbers are rounded, and a wild motion"));
  CHECK(a.at.theta == within(b.at.theta, 1e-12, "the same"));
  CHECK_THROWS_AS(Full_motion(held, {{0.1, 0, 0, 0}, {}}), std::domain_error);
}

TEST_CASE("an offset, however small, splits the frequencies, and its effect keeps all its digits")
{
  const auto with = [](double e) { return Suspended{heavy_pans, 1, e, false}; };
  CHECK(transfer(with(1e-4)).splitting
        == within_relative(Fifty("3.888680050183015109781258e-9"), 1e-14, "c and e rounded"));
  CHECK(transfer(with(0.2)).time == within_relative(186.86, 1e-4, "to the digits that stand here"));
  for(const double e : {1e-20, 1e-100, 1e-150})
  {
    const Transfer t = transfer(with(e));
    CHECK(t.estimate * t.splitting
          == within_relative(exact::pi(), 1e-15, "the leading term, e² beyond it"));
  }
  CHECK(std::isinf(transfer(with(0)).time));
  // nearest to μ is a frequency, of which the square is the farther from μ²
  const Transfer wide = transfer({{0.51, 4.5, 0.0392, 2.84 * 2.84, 2.14, 2.16, 19.795}, 1, 0.825, false});
  CHECK(wide.splitting
        == within_relative(Fifty("0.5611852875115226245538795"), 1e-14, "the numbers are rounded"));
  const auto all = modes(with(0.2));
  REQUIRE(all.size() == 3);
  // (λₑ² − s)(μ² − s) = εs²
  const Fifty inertia = 2 * (Fifty(heavy_pans.kk) + Fifty(0.1) * 0.1) + 2 * (4 + Fifty(0.2) * 0.2);
  const Fifty lambda2 = 32 * (2 * Fifty(0.1) + 2 * Fifty(0.2)) / inertia,
              epsilon = 2 * Fifty(0.2) * 0.2 / inertia;
  const Fifty sum = lambda2 + 16, root = sqrt(sum * sum - 64 * lambda2 * (1 - epsilon));
  CHECK(all[0].square == within_ulps((sum - root) / (2 * (1 - epsilon)), 1, "rounded once"));
  CHECK(all[2].square == within_ulps((sum + root) / (2 * (1 - epsilon)), 1, "rounded once"));
  // Mc + 2Le = 0: the beam is indifferent; below it topples
  CHECK(modes(with(-0.125))[0].square < 0);
  CHECK(std::isnan(modes(with(-0.125))[0].frequency));
}

TEST_CASE("shears as long as the strings, very short ones, and what has no masses")
{
  Suspended s = designed;
  s.h = s.beam.b;
  const Transfer equal = transfer(s);
  CHECK(equal.estimate == 0);  // where ν = μ the estimate is none
  CHECK(equal.time == between(1, 10, "of the order of π/(μ√ε/2)"));
  s.h = 1e-9;
  CHECK(std::abs(transfer(s).splitting) < 1e-8);
  CHECK_THROWS_AS(modes(Suspended{{2, 2, 0.1, 4. / 3, 0, 20, 16}, 5}), std::domain_error);
  CHECK_THROWS_AS(modes(Suspended{{2, 2, 0.1, 4. / 3, 1, 20, 16}, 0}), std::domain_error);
  CHECK_THROWS_AS(modes(Suspended{{2, 2, 0.1, 4. / 3, 1, 20, 16}, 5, not_a_number}), std::domain_error);
  // all of the beam's inertia in a point at C, beam all but weightless: the masses are singular to rounding
  CHECK_THROWS_AS(modes(Suspended{{1e-9, 2, 1e-9, 0, 1, 1e-18, 16}, 5}), std::domain_error);
}

TEST_CASE("unequal strings: what Q can have of P's swing")
{
  for(const double equal :
      {handed_on(designed, 0), handed_on(plain, 0), handed_on({heavy_pans, 1, 0.2, false}, 0)})
    CHECK(equal == within(1, 1e-13, "four modes' shares"));
  CHECK(handed_on(designed, 0.01) == within(0.990, 0.001, "to the digits that stand here"));
  CHECK(handed_on(designed, 0.1) == within(0.712, 0.01, "the same"));
  // two pans alone, of the frequencies' difference d and the splitting s: s/√(s² + d²)
  const Suspended weak{heavy_pans, 1, 0.01, false};
  const double split = transfer(weak).splitting;
  for(const double part : {0.3, 1.0, 4.0})
    CHECK(handed_on(weak, 2 * part * split / 4)
          == within_relative(1 / std::sqrt(1 + part * part), 1e-3, "of the order of e²"));
  CHECK_THROWS_AS(handed_on(designed, -1), std::domain_error);
  CHECK_THROWS_AS(handed_on({heavy_pans, 1, 0, false}, 0.1), std::domain_error);
  CHECK_THROWS_AS(handed_on({heavy_pans, 1, -0.125, false}, 0.1), std::domain_error);
}

TEST_CASE("by the third order the pans exchange their motion, in the time that averaging tells")
{
  const double known[]{1.0215, 1.0104, 1.0051};
  int k = 0;
  for(const double m : {1. / 6, 1. / 12, 1. / 24})
  {
    const Balance<> b{1, 25, 0.5, 0.25};
    const Averaged theory = averaged(b, m);
    const double period = 2 * std::numbers::pi;
    const Handover seen =
        handover(envelopes(b, released(m, m / 10, 0), 1.3 * theory.time, 4 * period, 200));
    CHECK(seen.time / theory.time
          == within_relative(known[k++], 0.01, "the maximum of a flat curve among 200 moments"));
    CHECK(seen.Q == between(0.98, 1.02, "complete"));
    CHECK(seen.P < 0.05);
  }
  const Averaged of_35 = averaged({1, 9, 0.5, 0.25}, 1. / 6);
  CHECK(of_35.time
        == within_relative(2 * exact::pi() * 5 / (Fifty(27) / 4 / 36), 1e-15, "2π(μ²−4λ²)/(ρμ³m²)"));
  CHECK(of_35.shift == within_relative(-Fifty(1) / 60480, 1e-15, "(1/4)(1/36)/(12·35)"));
  CHECK_THROWS_AS(averaged({1, 4, 0.5, 0.25}, 0.1), std::domain_error);
}

TEST_CASE("a lone pan drives the beam, and with heavy pans wakes the other")
{
  const Lone_pan of_35 = lone_pan({1, 9, 0.5, 0.25}, 1. / 6);
  CHECK(of_35.beam == within_ulps(Fifty(1) / 280, 3, "some products"));
  CHECK(of_35.threshold == within_ulps(Fifty(35) / 288, 2, "the same"));
  const Lone_pan heavy = lone_pan({1, 25, 0.5, 0.35}, 0.15);
  CHECK(heavy.growth == within_relative(0.00951, 1e-3, "to the digits that stand here"));
  CHECK(lone_pan({1, 25, 0.5, 0.05}, 0.15).growth == 0);
}

TEST_CASE("beyond a certain amplitude the exchange is trapped")
{
  const char* known[]{"1.016199360097058232069474", "1.282971249183285141411938",
                      "1.924746200070922366104394"};
  int k = 0;
  for(const double r : {0.5, 0.9, 0.99})
    CHECK(
        trapping_ratio(r)
        == within_relative(Fifty(known[k++]), 1e-15, "r rounded; near 1 the tenth part of its logarithm"));
  CHECK(trapping_ratio(0.999999)
        == within_relative(Fifty("4.838889473315150344167281"), 1e-11, "r is rounded by 5e-17 of 1e-6"));
  CHECK(std::isinf(trapping_ratio(1)));
  CHECK(std::isnan(trapping_ratio(1.01)));
  const Suspended heavy{{1, 2, 0.02, 1. / 3, 1, 1000, 16}, 5};
  const Transfer t = transfer(heavy);
  CHECK(trapping(t.splitting, 4, 0.2).critical
        == within_relative(0.2310, 3e-4, "to the digits that stand here"));
  CHECK(trapping(t.splitting, 4, 0.2).ratio
        == within_relative(1.196, 0.02, "an integration has 1.196; n⁴ is left out"));
  CHECK(trapping(t.splitting, 4, 0.2).reach == 1);
  CHECK(trapping(t.splitting, 4, 0.25).reach
        == within(0.498, 0.01, "an integration has 0.498; n⁴ is left out"));
  CHECK(trapping(1. / 32, 1, 1).reach == within_ulps(sqrt(Fifty(1) / 2), 1, "at the critical amplitude"));
  CHECK(trapping(1. / 32, 1, 100).reach == within_relative(0.5e-4, 1e-8, "1/2k, k = 10⁴"));
  CHECK_THROWS_AS(trapping(0, 4, 0.1), std::domain_error);
}
