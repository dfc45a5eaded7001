/// @file
/// The way of the ball with friction: three motions with all their events, against numbers found by other tools,
/// an integration that knows nothing of Taylor series, and what must stay the same.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "edition/compare.hpp"
#include "exact/ode.hpp"
#include "globe/judge.hpp"
#include "globe/path.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"

using namespace globe;
using edition::within;
using edition::within_relative;
using exact::Fifty;

namespace
{

const char* const other_tools = "two independent tools agree to so many digits";

/// One event as other tools found it.
struct Found
{
  const char *t, *Phi, *w, *energy;
};

template <class Real>
void check(const Path<Real>& path, const std::vector<Found>& found, double tolerance, const char* because)
{
  REQUIRE(path.events().size() > found.size());
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    const Event<Real>& event = path.events()[i + 1];
    CHECK(Fifty(event.t) == within_relative(Fifty(found[i].t), tolerance, because));
    CHECK(Fifty(event.state.Phi) == within_relative(Fifty(found[i].Phi), tolerance, because));
    CHECK(Fifty(event.state.w) == within_relative(Fifty(found[i].w), tolerance, because));
    CHECK(Fifty(event.energy) == within_relative(Fifty(found[i].energy), tolerance, because));
  }
}

const std::vector<Found> bowled{{"0.2862073440442989404806234", "1.047497721919954246582473",
                                 "7.169970541110068757506752", "62.33403218936035306133019"}};
const std::vector<Found> let_go{{"1.874195434430897040968573", "-0.1553199062018076184909402",
                                 "-0.7641210749682688884884034", "0.6555035604414564555651172"},
                                {"2.365094834209513478747405", "-0.4861529562264958475491123",
                                 "-0.5629054452535723043529157", "0.6555035604414564555651172"},
                                {"5.178102723390748214260113", "0.1396515045261652213008186",
                                 "0.4526719164540681016868901", "0.5570931358145734965269686"},
                                {"5.998704201920461675637460", "0.4227715971708417340250804",
                                 "0.2108436684788156104755602", "0.5570931358145734965269686"},
                                {"7.565582366903669307030903", "0.2674871876222793912328312",
                                 "-0.3491678346547035268688287", "0.5504283157642376281259369"},
                                {"9.443938134700180532553273", "-0.4184278263430798811226042",
                                 "-0.1577290217806204545106081", "0.5504283157642376281259369"},
                                {"10.69087684452244924558055", "-0.3237147707238625733194631",
                                 "0.2820303676427668256736445", "0.5479207877845406507587809"}};
const std::vector<Found> jumping{
    {"0.4059806440476612527093954", "1.164735706235967381509633", "2.209596700883332021419997", "3.5"},
    {"1.246633342265125157606186", "2.609891999342923001467327", "1.523263188377662197687338",
     "3.495408626412204753130273"}};

template <class Real>
Path<Real> bowled_path()
{
  return {our_ball<Real>, our_g<Real>, Real(1) / 3, {0, 10, 0, 0}, 2};
}

template <class Real>
Path<Real> let_go_path(const Real& end)
{
  return {cradle<Real>, cradle_g<Real>, Real(1) / 5, {0, 0, 1, 0}, end};
}

template <class Real>
Path<Real> jumping_path()
{
  using std::sqrt;
  return {cradle<Real>, cradle_g<Real>, Real(1) / 3, {0, 0, 0, 2 * sqrt(Real(3))}, 9};
}

}  // namespace

TEST_CASE("a bowled ball scrapes, then rolls for ever")
{
  check(bowled_path<Fifty>(), bowled, 1e-24, other_tools);
  const Path<double> path = bowled_path<double>();
  check(path, bowled, 1e-14, "rounding of some forty steps");
  REQUIRE(path.events().size() == 2);
  CHECK(path.events()[0].mode == Mode::scraping_forwards);
  CHECK(path.events()[1].mode == Mode::rolling);
  const State<double> end = path.at(2);
  CHECK(end.Phi == within_relative(Fifty("12.44368606645228787608178"), 1e-14, "rounding"));
  CHECK(end.s == within_relative(Fifty("13.90156522767539363074810"), 1e-14, "rounding"));
  CHECK(end.w == within_relative(Fifty("7.639492209387429752317742"), 1e-14, "rounding"));
  CHECK(end.slip == 0);
}

TEST_CASE("let go at an angle that asks for too much friction, a cradle scrapes and rolls by turns")
{
  check(let_go_path<Fifty>(11), let_go, 1e-23, other_tools);
  check(let_go_path<double>(11), let_go, 1e-12, "rounding, and what the motion makes of it");
}

TEST_CASE("rolling too fast the cradle scrapes before it jumps")
{
  check(jumping_path<Fifty>(), jumping, 1e-24, other_tools);
  const Path<double> path = jumping_path<double>();
  check(path, jumping, 1e-13, "rounding, and what the motion makes of it");
  REQUIRE(path.events().size() == 3);
  CHECK(path.events()[1].mode == Mode::scraping_backwards);
  CHECK(path.events()[2].mode == Mode::off);
  CHECK(path.ended() == path.events()[2].t);
  CHECK(rolling::loss_of_pressure(cradle<double>).h > 3);  // rolling it would have stayed
}

TEST_CASE("the smallest scraping has its own digits")
{
  const Path<double> path(our_ball<double>, our_g<double>, 1 / 3.0, {0, 1e-9, 0, 2}, 1e-9);
  REQUIRE(path.events().size() == 2);
  CHECK(path.events()[1].t == within_relative(Fifty("2.916514764853368981234435e-11"), 1e-13, "rounding"));
  const Path<double> smaller(our_ball<double>, our_g<double>, 1 / 3.0, {0, -1e-300, 0, 2}, 1e-9);
  REQUIRE(smaller.events().size() == 2);
  CHECK(smaller.events()[0].mode == Mode::scraping_backwards);
  CHECK(smaller.events()[1].t > 0);
  CHECK(smaller.events()[1].t < 1e-298);
}

TEST_CASE("scraping is Euler's equations integrated, and keeps the two integrals")
{
  const Ball<Fifty> ball = our_ball<Fifty>;
  const Fifty g = our_g<Fifty>, lambda = Fifty(1) / 3, t("0.25");
  const auto motion = [&](const Fifty&, const exact::State& s) {
    const auto all = accelerations(ball, g, s[0], s[1], lambda);
    return exact::State{s[1], all.Phi, s[3], all.x};  // Φ, w, x, x'
  };
  const exact::State end = exact::solve(motion, 0, {0, 0, 0, 10}, t).y;
  const Path<Fifty> path = bowled_path<Fifty>();
  const State<Fifty> there = path.at(t);
  CHECK(there.Phi == within(end[0], 1e-28, "steps of 1e-32"));
  CHECK(there.w == within(end[1], 1e-28, "steps of 1e-32"));
  CHECK(there.s - ball.c * sin(there.Phi) == within(end[2], 1e-28, "steps of 1e-32"));
  // x' + λ(y' + 2gt) stays the same.
  const Fifty x = there.slip + (ball.a - ball.c * cos(there.Phi)) * there.w;
  const Fifty y = ball.c * there.w * sin(there.Phi);
  CHECK(x + lambda * (y + 2 * g * t) == within(10, 1e-40, "rounding"));
}

TEST_CASE(
    "what friction takes is what the energy has lost, with its own digits where that is hardly anything")
{
  const Path<Fifty> exact = let_go_path<Fifty>(11);
  const Path<double> path = let_go_path<double>(11);
  for(const char* const t : {"0.001", "1", "1.9", "5", "11"})
  {
    const Fifty taken = exact.events()[0].energy - exact.energy(exact.at(Fifty(t)));
    CHECK(exact.lost(Fifty(t)) == within_relative(taken, 1e-13, "the stated bound"));
    CHECK(path.lost(std::stod(t))
          == within_relative(exact.lost(Fifty(std::stod(t))), 1e-13, "the stated bound"));
  }
  const double slip = 1e-9;
  const Path<double> hardly(our_ball<double>, our_g<double>, 1 / 3.0, {0, slip, 0, 2}, 1e-9);
  const Path<Fifty> as_well({1, Fifty(0.1), Fifty(0.6)}, our_g<Fifty>, Fifty(1 / 3.0),
                            {0, Fifty(slip), 0, 2}, Fifty(1e-9));
  CHECK(hardly.lost(1e-9) == within_relative(as_well.lost(Fifty(1e-9)), 1e-13, "the stated bound"));
  CHECK(hardly.lost(0) == 0);
  CHECK_THROWS_AS(hardly.lost(2e-9), std::domain_error);
}

TEST_CASE("rolling on the way has the closed time")
{
  const Path<double> path = bowled_path<double>();
  const State<double> start = path.events()[1].state, end = path.at(path.ended());
  const Ball<double> ball = our_ball<double>;
  const double second = std::sqrt(2 * our_g<double> * ball.c);
  const double D = bb(ball) + 4 * ball.a * ball.c * std::pow(std::sin(start.Phi / 2), 2);
  const Energy<double> e =
      energy(start.w * start.w * D / (8 * our_g<double> * ball.c) + std::pow(std::sin(start.Phi / 2), 2));
  const double before = rolling::time(ball, e, place(start.Phi));
  const double passed = (path.ended() - path.events()[1].t) * second;
  CHECK(rolling::angle(ball, e, before + passed).Phi == within_relative(end.Phi, 1e-13, "rounding"));
}

TEST_CASE("without friction the centre of gravity goes on as it did, and the angle is the smooth plane's")
{
  const Ball<double> ball = our_ball<double>;
  const double g = our_g<double>, w = 5;
  const Path<double> path(ball, g, 0.0, {0, 3 - (ball.a - ball.c) * w, 0, w}, 1.5);
  const double second = std::sqrt(2 * g * ball.c);
  const Energy<double> e = energy_of_velocity(ball.c, ball.k * ball.k, g, w);
  for(const double t : {0.1, 0.7, 1.5})
  {
    const State<double> there = path.at(t);
    CHECK(there.Phi == within(smooth::angle(ball.c, ball.k, e, t * second).Phi, 1e-13, "rounding"));
    CHECK(there.s - ball.c * std::sin(there.Phi) == within(3 * t, 1e-13, "rounding"));
    CHECK(path.energy(there) == within_relative(path.events()[0].energy, 1e-13, "nothing is lost"));
  }
}

TEST_CASE("the less friction, the nearer the first half swing to that on a smooth plane")
{
  // Let go at 1 rad; the times till the cradle turns back.
  const std::vector<std::pair<const char*, const char*>> found{{"0.1", "2.794169286993051918336"},
                                                               {"0.01", "2.768985451863301701795"},
                                                               {"0.001", "2.781493033495194453267"},
                                                               {"0.0001", "2.782859813973181205905"}};
  for(const auto& [mu, half_swing] : found)
  {
    const Path<double> path(cradle<double>, cradle_g<double>, std::stod(mu), {0, 0, 1, 0}, 3);
    double low = 2, high = 3;
    for(int i = 0; i < 60; ++i)
      (path.at((low + high) / 2).w < 0 ? low : high) = (low + high) / 2;
    CHECK(low == within_relative(Fifty(half_swing), 1e-13, "rounding"));
  }
}

TEST_CASE("scraping and rolling alternate for ever, and what is lost dies as one over the number of swings")
{
  const Path<double> path = let_go_path<double>(800);
  const Fifty threshold("0.4129395012431613799940271");
  std::vector<double> amplitude;
  double before = 0;
  for(const auto& event : path.events())
  {
    CHECK(event.t >= before);
    before = event.t;
    CHECK(event.mode != Mode::off);
  }
  double last_energy = path.events()[0].energy;
  for(const auto& event : path.events())
  {
    CHECK(event.energy <= last_energy * (1 + 1e-14));
    last_energy = event.energy;
  }
  CHECK(path.events().size() > 200);
  // At rest at the threshold angle the energy is 2g(a − c cos Φ).
  const double least = 1 - 0.5 * std::cos(static_cast<double>(threshold));
  CHECK(last_energy > least);
  CHECK(last_energy < least + 0.01);
}

TEST_CASE("the judge finds the changes by itself, however short the time between two of them")
{
  const oracle::Judge judge(cradle<Fifty>, cradle_g<Fifty>, Fifty(1) / 5);
  const std::vector<oracle::Stretch> all = judge.stretches({0, 0, 1, 0}, 100, let_go.size());
  REQUIRE(all.size() == let_go.size() + 1);
  for(std::size_t i = 0; i < let_go.size(); ++i)
  {
    const oracle::Stretch& now = all[i + 1];
    CHECK(now.from == within(Fifty(let_go[i].t), 1e-17, "steps of 1e-20, and what the motion makes of it"));
    CHECK(now.start.Phi == within(Fifty(let_go[i].Phi), 1e-17, "the same"));
    CHECK(now.start.w == within(Fifty(let_go[i].w), 1e-17, "the same"));
    CHECK(judge.energy(now.start) == within(Fifty(let_go[i].energy), 1e-17, "the same"));
    CHECK(now.mode
          == (i % 2 == 0   ? Mode::rolling
              : i % 4 == 1 ? Mode::scraping_backwards
                           : Mode::scraping_forwards));
  }
  const Fifty t("2.2");
  CHECK(judge.at(all, t).Phi == within(let_go_path<Fifty>(3).at(t).Phi, 1e-17, "steps of 1e-20"));
  CHECK(judge.stretches({0, 0, 1, 0}, all[2].from - Fifty("1e-15")).size() == 2);
  CHECK(judge.stretches({0, 0, 1, 0}, all[2].from + Fifty("1e-15")).size() == 3);
  // Hardly more than the friction there is: where it turns it scrapes for 3t₀, a hundredth of a swing and less.
  for(const char* const above : {"1e-4", "1e-6"})
  {
    const Fifty turning = Fifty("0.4129395012431613799940271") + Fifty(above);
    const Path<Fifty> path(cradle<Fifty>, cradle_g<Fifty>, Fifty(1) / 5, {0, 0, turning, 0}, 8);
    const std::vector<oracle::Stretch> found = judge.stretches({0, 0, turning, 0}, 8);
    REQUIRE(found.size() == path.events().size());
    CHECK(found.size() > 4);
    for(std::size_t i = 0; i < found.size(); ++i)
      CHECK(found[i].from == within(path.events()[i].t, 1e-12, "nearly a double root"));
  }
}

TEST_CASE("the judge finds where the ball leaves the plane")
{
  const oracle::Judge judge(cradle<Fifty>, cradle_g<Fifty>, Fifty(1) / 3);
  const State<Fifty> start{0, 0, 0, 2 * sqrt(Fifty(3))};
  const std::vector<oracle::Stretch> all = judge.stretches(start, 9);
  REQUIRE(all.size() == jumping.size() + 1);
  for(std::size_t i = 0; i < jumping.size(); ++i)
  {
    const oracle::Stretch& now = all[i + 1];
    CHECK(now.from
          == within(Fifty(jumping[i].t), 1e-17, "steps of 1e-20, and what the motion makes of it"));
    CHECK(now.start.Phi == within(Fifty(jumping[i].Phi), 1e-17, "the same"));
    CHECK(now.start.w == within(Fifty(jumping[i].w), 1e-17, "the same"));
  }
  CHECK(all[1].mode == Mode::scraping_backwards);
  CHECK(all[2].mode == Mode::off);
  CHECK(judge.margins(all[2].start, Mode::scraping_backwards)[2]
        == within(Fifty(0), 1e-17, "nothing holds it down"));
}

TEST_CASE("what makes no sense is refused")
{
  const Ball<double> ball = our_ball<double>;
  const State<double> rest{0, 0, 1, 0};
  CHECK_THROWS_AS(Path<double>(ball, 0, 0.1, rest, 1), std::domain_error);
  CHECK_THROWS_AS(Path<double>(ball, 1, -0.1, rest, 1), std::domain_error);
  CHECK_THROWS_AS(Path<double>(ball, 1, 3.7, rest, 1), std::domain_error);
  CHECK_THROWS_AS(Path<double>(ball, 1, 0.1, rest, -1), std::domain_error);
  CHECK_THROWS_AS(Path<double>({1, 0.1, 0}, 1, 0.1, rest, 1), std::domain_error);
  CHECK_THROWS_AS(Path<double>(ball, 1, 0.1, {0, 0, std::nan(""), 0}, 1), std::domain_error);
  const Path<double> path(ball, 1, 0.1, rest, 1);
  CHECK_THROWS_AS(path.at(1.1), std::domain_error);
  CHECK_THROWS_AS(path.at(-0.1), std::domain_error);
  CHECK(path.at(0).Phi == 1);
}
