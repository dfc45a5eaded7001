#include "balance/euler.hpp"
#include "edition/section.hpp"

SECTION(balance, 33, "The motions of beam and pans, with one letter less")

using namespace balance;

/*!
## What Euler does

The formulae of {{sec balance.32}} for a balance of which all three parts are let go from rest are drawn
together by one letter. He puts

$$ i = \frac{\lambda\mu\mu a}{4g}. \tag{1} $$

Then beam and pans move so:

$$ \begin{aligned}
\eta &= n\cos\mu t + \frac{imn}{2\mu-\lambda}\cos(\mu-\lambda)t\\
  &\qquad - \frac{imn}{2\mu+\lambda}\cos(\mu+\lambda)t,\\
\vartheta &= n'\cos\mu t - \frac{imn'}{2\mu-\lambda}\cos(\mu-\lambda)t\\
  &\qquad + \frac{imn'}{2\mu+\lambda}\cos(\mu+\lambda)t,\\
\omega &= m\cos\lambda t,
\end{aligned} \tag{2} $$

and with these speeds {{entry second_member}}:

$$ \begin{aligned}
\frac{d\eta}{dt} = {}&{-\mu n}\sin\mu t\\ &- \frac{(\mu-\lambda)imn}{2\mu-\lambda}\sin(\mu-\lambda)t\\
  &+ \frac{(\mu+\lambda)imn}{2\mu+\lambda}\sin(\mu+\lambda)t,\\
\frac{d\vartheta}{dt} = {}&{-\mu n'}\sin\mu t\\ &+ \frac{(\mu-\lambda)imn'}{2\mu-\lambda}\sin(\mu-\lambda)t\\
  &- \frac{(\mu+\lambda)imn'}{2\mu+\lambda}\sin(\mu+\lambda)t,\\
\frac{d\omega}{dt} = {}&{-\lambda m}\sin\lambda t.
\end{aligned} \tag{3} $$

The number $i$ is a frequency: since $2g = \mu\mu b$, it is $a\lambda:2b$. At $t = 0$ {{eq 2}} gives not $n$
and $n'$ but $n(1+K)$ and $n'(1-K)$, with the $K$ of {{sec balance.26}}.

## The program

The formulae, the same with amplitudes that start where they should, and what is complete to the second order
({{sec balance.13}}).

::: code balance/euler.hpp euler (2)
:::
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, scale, "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, scale, "frequency of the pans, μ = √(2g/b)");
const auto i = real("i", 0.25, Unit{"1/s"}, closed(1e-200, 1e100), "λμμa/4g");
const auto m = angle("m", 1. / 6, closed(-90_deg, 90_deg), "inclination of the beam at the start");
const auto n = angle("n", 1. / 6, closed(-90_deg, 90_deg), "inclination of the pan P at the start");
const auto n1 = angle("n1", 1. / 6, closed(-90_deg, 90_deg), "inclination n′ of the pan Q at the start");
const auto rho =
    real("rho", 0.25, none, closed(0, 0.5), "share of one pan in the whole inertia, for the beam");
const auto t = real("t", 1, seconds, closed(0, 1e9), "time");

const auto given = [] {  // as it is written
  return ReleaseOf<Fifty>{
      lambda.fifty(), mu.fifty(), i.fifty(), {m.fifty(), n.fifty(), n1.fifty()}, rho.fifty()};
};

TELL
{
  const ReleaseOf<Fifty> r = given();
  require(r.lambda != 2 * r.mu, "lambda", "not 2 mu");
  require(r.mu != 2 * r.lambda, "lambda", "not half of mu");
  require(lambda <= 1e9, "lambda", "at most 1e9");
  require(mu <= 1e9, "mu", "at most 1e9");
  require(abs(K_of(r)) != 1, "i", "such that K is neither 1 nor -1");
  require(abs(K_of(r)) < 1e200, "i", "such that K is below 1e200");
  const Angles<Fifty> at = euler<Fifty>(r, t.fifty()), rate = euler_rates<Fifty>(r, t.fifty()),
                      from = euler_start<Fifty>(r), own = euler_corrected<Fifty>(r, t.fifty()),
                      second = second_order<Fifty>(r, t.fifty());
  auto& rows =
      table("motion", "Beam and pans in radians, their rates in radians a second",
            {{"what", "what"}, {"omega", "ω", none, 14}, {"eta", "η", none, 14}, {"theta", "ϑ", none, 14}});
  const auto row = [&rows](const char* what, const Angles<Fifty>& x) {
    rows.row({what, double(x.omega), double(x.eta), double(x.theta)});
  };
  row("by (2)", at);
  row("rates by (3)", rate);
  row("where (2) starts", from);
  row("amplitudes corrected", own);
  row("second order", second);
}

TELL
{
  curve("missed", {"t", "euler", "corrected", "second"}, [](Curve& out) {
    const Release& r = example_of_35;
    for(int j = 0; const State<>& now : course(balance_of(r), {r.at, {}}, 2 * std::numbers::pi, 300))
    {
      const double at = 2 * std::numbers::pi * j++ / 300;
      out.put({at, (euler(r, at).eta - now.at.eta) / 1_deg,
               (euler_corrected(r, at).eta - now.at.eta) / 1_deg,
               (second_order(r, at).eta - now.at.eta) / 1_deg});
    }
  });
}

/*!
{{table motion}}

::: figure balance-33
alt: How far the pan P by each of three formulae is from the full motion over one period of the beam. All
three grow to some tenths of a degree.

What each formula misses of P's true inclination in Euler's example: by {{eq 2}}, with corrected amplitudes,
and complete to the second order (dashed). What the last one leaves is of the third order, the longer period
of wider swings.
:::

## Checks
*/

CHECK_THAT("what is told is (2), its derivative, and the solutions of the equations, at resonances too")
{
  for(const Told& now :
      told_at("", "lambda=1 mu=2.000000001 t=30 m=2 n=-7 n1=5", "mu=1 lambda=2.0000000002 i=1e-12 t=9",
              "mu=1 lambda=1.9999999998 n1=-5 t=50", "i=1e-101 n1=-30 t=123.4 mu=17"))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty(), s = t.fifty(), im = i.fifty() * m.fifty(), h("1e-15");
    const auto tone = [&](const Fifty& at) {
      return cos((u - l) * at) / (2 * u - l) - cos((u + l) * at) / (2 * u + l);
    };
    const auto eta = [&](const Fifty& at) { return n.fifty() * (cos(u * at) + im * tone(at)); };
    const auto theta = [&](const Fifty& at) { return n1.fifty() * (cos(u * at) - im * tone(at)); };
    const auto slope = [&h](const auto& f, const Fifty& at) {
      return Fifty((f(at + h) - f(at - h)) / (2 * h));
    };
    const Fifty K = im * tone(0), arc = 2 * i.fifty() * l * m.fifty() * m.fifty() / (u * u - 4 * l * l)
                                        * (cos(2 * l * s) - cos(u * s));
    const Fifty pan = im * (tone(s) - tone(0) * cos(u * s)), still = cos(u * s);
    const auto rows = now.rows("motion");
    const char* const because = "one rounding";
    const auto three = [&](std::size_t k, const Fifty& eta_, const Fifty& theta_, double eps) {
      CHECK(rows[k].value("eta") == within_relative(eta_, eps, because));
      CHECK(rows[k].value("theta") == within_relative(theta_, eps, because));
    };
    REQUIRE(rows.size() == 5);
    three(0, eta(s), theta(s), 2e-16);
    three(1, slope(eta, s), slope(theta, s), 1e-15);
    three(2, n.fifty() * (1 + K), n1.fifty() * (1 - K), 2e-16);
    three(3, eta(s) / (1 + K), theta(s) / (1 - K), 2e-16);
    three(4, n.fifty() * (still + pan) - arc, n1.fifty() * (still - pan) + arc, 2e-16);
    for(const std::size_t k : {std::size_t{0}, std::size_t{3}})
      CHECK(rows[k].value("omega") == within_relative(m.fifty() * cos(l * s), 2e-16, because));
    const Fifty N = n.fifty(), N1 = n1.fifty(), beam = cos(l * s);
    const Fifty lines = (cos((u - l) * s) - beam) / (u - 2 * l) + (cos((u + l) * s) - beam) / (u + 2 * l);
    const Fifty drive = u * m.fifty() * (N - N1) / 2 * lines
                        + u * u * (N * N - N1 * N1) * (beam - cos(2 * u * s)) / (4 * u * u - l * l);
    CHECK(rows[4].value("omega")
          == within_relative(m.fifty() * beam + rho.fifty() * l / (2 * i.fifty()) * drive, 2e-16, because));
    CHECK(rows[1].value("omega") == within_relative(-l * m.fifty() * sin(l * s), 2e-16, because));
    CHECK(rows[2].value("omega") == within_relative(m.fifty(), 2e-16, because));
  }
}

CHECK_THAT("λ = 2μ and μ = 2λ are refused, K = ±1, frequencies beyond 1e9 and K from 1e200 on, and nothing "
           "beside them")
{
  const std::string one = "m=0.5rad i=", other = "m=-0.5rad i=",  // K is i : 35, and −i : 35
      great = "lambda=1e-100 mu=1e-100 m=1.5rad i=";              // and 1e100 i
  for(const std::string& no : std::vector<std::string>{"lambda=6", "lambda=1 mu=0.5", "lambda=1.5", "mu=2",
                                                       "lambda=1000000000.0000001", "mu=1000000000.0000001",
                                                       one + "35", other + "35", great + "1e100"})
    CHECK(refused_at(no));
  for(const std::string& yes :
      std::vector<std::string>{"lambda=5.99999999999999999", "lambda=6.00000000000000001", "lambda=6 mu=4",
                               "lambda=1.49999999999999999", "lambda=1.50000000000000001", "lambda=1e9",
                               "mu=1e9", one + "34.99999999999999999", one + "35.00000000000000001",
                               other + "34.99999999999999999", great + "9.999999999999999e99"})
    CHECK(!refused_at(yes));
}

CHECK_THAT("the figure's lines are what the formulae miss of GSL's motion")
{
  const Release& r = example_of_35;
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("missed", 5))
    {
      const double s = point.at("t"),
                   full = by_gsl(balance_of(r), {r.at, {}}, std::max(s, 1e-9), 1e-13).at.eta;
      CHECK(point.value("euler") == within((euler(widened(r), Fifty(s)).eta - full) / 1_deg, 1e-8, "GSL"));
      CHECK(point.value("corrected")
            == within((euler_corrected(widened(r), Fifty(s)).eta - full) / 1_deg, 1e-8, "GSL"));
      CHECK(point.value("second")
            == within((second_order(widened(r), Fifty(s)).eta - full) / 1_deg, 1e-8, "GSL"));
    }
}

const Emendation second_member{
    "§33, the sign of the second member of dη:dt, in the example its coefficient",
    {"+ (μ−λ)imn/(2μ−λ)", 2. / 720},
    {"− (μ−λ)imn/(2μ−λ)", -2. / 720},
    "it is the derivative of (2); §35 has it",
    [](double reading) {  // the rest of dη/dt at t = 1
      const double rest = -std::sin(3.) / 2 + 4 * std::sin(4.) / 1008;
      return rest + reading * std::sin(2.)
             == within(euler_rates(example_of_35, 1.).eta, 1e-15, "few roundings");
    }};
