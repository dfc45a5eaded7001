#include "balance/euler.hpp"
#include "balance/exchange.hpp"
#include "edition/section.hpp"

#include <complex>

SECTION(balance, 32, "Case 3: both pans pulled aside")

using namespace balance;

/*!
## What Euler does

The last case has both pans pulled aside, P by $n$ and Q by $n'$, with the beam inclined by $m$; to neither
pan any motion is given. That both rates vanish at the start is provided for by

$$ \alpha = 90°, \qquad \beta = 90°, \tag{1} $$

and because of the inclinations, as was seen before ({{sec balance.30}}),

$$ \mathfrak A = n, \qquad \mathfrak B = n'. {{entry constant_B}} \tag{2} $$

So he gets for the two pans

$$ \begin{aligned} \eta = {}&n\cos\mu t\\ &+ \frac{\lambda\mu\mu amn}{4g(2\mu-\lambda)}\cos(\mu-\lambda)t\\
   &- \frac{\lambda\mu\mu amn}{4g(2\mu+\lambda)}\cos(\mu+\lambda)t,\\
 \vartheta = {}&n'\cos\mu t\\ &- \frac{\lambda\mu\mu amn'}{4g(2\mu-\lambda)}\cos(\mu-\lambda)t\\
   &+ \frac{\lambda\mu\mu amn'}{4g(2\mu+\lambda)}\cos(\mu+\lambda)t. {{entry four_g}} \end{aligned} \tag{3} $$

What was "very nearly" two sections ago is now simply so. At $t = 0$ the formulae give $n(1+K)$ and $n'(1-K)$,
$K$ being that of {{sec balance.26}}; to start at $n$ and $n'$ they need

$$ \mathfrak A = \frac n{1+K}, \qquad \mathfrak B = \frac{n'}{1-K}. \tag{A} $$

What (3) leaves out weighs more. Each pan's motion depends on its own first inclination alone; change $n'$,
and η is the same. In truth the two exchange what they have ({{sec balance.31}}), and now one can see what
that means when both have something. The sum of the swings, $\eta+\vartheta$, and their difference go on with
two slightly different frequencies. After the time

$$ T_3 = \frac{2\pi\,|\mu^2-4\lambda^2|}{\rho\,\mu^3m^2} \tag{B} $$

one of them has gained half a turn on the other, and P swings by $n'$, Q by $n$; in between, at the time $t$,
by the roots of

$$ \frac{nn+n'n'}2 \pm \frac{nn-n'n'}2\cos\frac{\pi t}{T_3}. \tag{C} $$

::: margin
Today: $n=\pm n'$ excites one normal mode, all else a beat of two.
:::

If $n$ and $n'$ are equal, there is nothing to exchange: the pans swing with each other and go on so. It is
that very start, with $n=n'$, which Euler chooses for his example ({{sec balance.35}}). A table of it,
however exact, would not have shown him what he looked for.

## The program

Beside (3) stand the formulae with the amplitudes of (A), {{api balance::euler_corrected}}, and the motion by
the full equations, its amplitudes taken as in {{sec balance.31}}.
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, closed(0.5, 2), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 5, Unit{"1/s"}, closed(1, 20), "frequency of the pans, μ = √(2g/b)");
const auto beta = real("beta", 0.5, none, closed(0.05, 1), "a/b, arm to string");
const auto rho = real("rho", 0.25, none, closed(0.01, 0.45), "share of one pan in the whole inertia");
const auto m = angle("m", 1. / 6, closed(1_deg, 20_deg), "inclination of the beam at the start");
const auto n = angle("n", 2_deg, closed(-10_deg, 10_deg), "inclination of the pan P");
const auto n1 = angle("n1", 0.8_deg, closed(-10_deg, 10_deg), "inclination n′ of the pan Q");
const auto t = real("t", 1, seconds, closed(0, 200), "time");

Release release()
{
  return {lambda, mu, beta * lambda / 2, {m, n, n1}, rho};
}

Balance<> given()
{
  return {lambda * lambda, mu * mu, beta, rho};
}

double meanwhile()  // the window in which the amplitudes are taken, four swings of the beam to and fro
{
  return 8 * std::numbers::pi / lambda;
}

TELL
{
  const double square = mu / lambda * (mu / lambda);
  require(std::abs(square - 4) >= 1, "mu", "such that μμ differs from 4λλ by λλ or more");
  const double time = averaged(given(), m).time;
  require(time <= 3000, "m", "such that the exchange takes 3000 s at the most");
  require(time >= 1.5 * meanwhile(), "m", "such that it takes six swings of the beam to and fro");
  const Release r = release();
  require(parting(given(), {r.at, {}}, std::max(double(t), time)) <= 1e4,
          std::abs(n) >= std::abs(n1) ? "n" : "n1",
          "so small that a slight change does not grow ten thousand times");
  const Angles<> at = euler(r, double(t)), start = euler_start(r), own = euler_corrected(r, double(t));
  const Angles<> full = t == 0 ? r.at : Motion(given(), {r.at, {}}).to(t).at;
  auto& rows = table("pans", "The two pans, in degrees",
                     {{"what", "what"}, {"eta", "η", degrees, 8}, {"theta", "ϑ", degrees, 8}});
  rows.row({"(3) at t = 0", start.eta, start.theta});
  rows.row({"(3) at the time t", at.eta, at.theta});
  rows.row({"with (A)", own.eta, own.theta});
  rows.row({"full equations", full.eta, full.theta});
  tell("K", K_of(r), "K");
  tell("A", n / (1 + K_of(r)), degrees, "𝔄 by (A)");
  tell("B", n1 / (1 - K_of(r)), degrees, "𝔅");
  tell("time", time, seconds, "when all is exchanged, (B)");
  const auto two = envelopes(given(), {r.at, {}}, time + meanwhile() / 2, meanwhile(), 1);
  tell("P_then", two[1].P, degrees, "how far P then swings, by the full equations", 3);
  tell("Q_then", two[1].Q, degrees, "how far Q does", 3);
}

double middle(double P, double Q, double part)  // (C), of the first of them; part is t : T₃
{
  return std::sqrt((P * P + Q * Q) / 2 + (P * P - Q * Q) / 2 * std::cos(std::numbers::pi * part));
}

TELL
{
  curve("swings", {"t", "P", "Q", "P_theory", "Q_theory"}, [](Curve& out) {
    const double time = averaged(given(), m).time;
    for(const Envelope& now : envelopes(given(), {release().at, {}}, 2.2 * time, meanwhile(), 300))
      out.put({now.t, now.P / 1_deg, now.Q / 1_deg, middle(n, n1, now.t / time) / 1_deg,
               middle(n1, n, now.t / time) / 1_deg});
  });
}

/*!
{{table pans}}

After {{time|4}} s the pan P, let go at {{n}}, swings by {{P_then|2}}, and Q, let go at {{n1}}, by
{{Q_then|2}}.

::: figure balance-32
alt: Two curves that start at two degrees and at less than one, cross, change places, and cross again.

How far P and Q swing when both have been pulled aside, by the full equations and by {{eq C}} (dashed). By
{{eq 3}} both would keep to their levels.
:::

## Checks
*/

CHECK_THAT("(3) is made of three cosines, starts at n(1 + K), n′(1 − K), and with (A) at n and n′")
{
  for(const Told& now :
      told_at("", "lambda=2 mu=11 beta=0.9 rho=0.4 m=12 n=-3 n1=5 t=40", "mu=3.1 rho=0.1 m=15 t=3.3"))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty(), s = t.fifty(), half = beta.fifty() * l / 2 * m.fifty();
    const Fifty lower = half / (2 * u - l), upper = half / (2 * u + l), k = lower - upper;
    const auto pan = [&](const Fifty& size, int side, const Fifty& x) {
      return Fifty(size * (cos(u * x) + side * (lower * cos((u - l) * x) - upper * cos((u + l) * x))));
    };
    const Fifty N = n.fifty(), N1 = n1.fifty();
    const auto rows = now.rows("pans");
    const double eps = (2e-15 + 3e-16 * double(u + l) * t) * 0.2;
    const char* const because = "phases from rounded frequencies";
    CHECK(rows[0].value("eta", degrees) == within_relative(pan(N, 1, 0), 2e-15, "sums"));
    CHECK(rows[0].value("theta", degrees) == within_relative(pan(N1, -1, 0), 2e-15, "sums"));
    CHECK(rows[1].value("eta", degrees) == within(pan(N, 1, s), eps, because));
    CHECK(rows[1].value("theta", degrees) == within(pan(N1, -1, s), eps, because));
    CHECK(rows[2].value("eta", degrees) == within(pan(N / (1 + k), 1, s), eps, because));
    CHECK(rows[2].value("theta", degrees) == within(pan(N1 / (1 - k), -1, s), eps, because));
    CHECK(pan(N / (1 + k), 1, 0) == within(N, 1e-45, "(A)"));
    CHECK(pan(N1 / (1 - k), -1, 0) == within(N1, 1e-45, "(A)"));
    const Angles<> full = by_gsl(given(), {{m, n, n1}, {}}, t, 1e-13).at;
    CHECK(rows[3].value("eta", degrees) == within(full.eta, 1e-10, "GSL's tolerance, step by step"));
    CHECK(rows[3].value("theta", degrees) == within(full.theta, 1e-10, "the same"));
    CHECK(now.value("K") == within_relative(k, 1e-14, "a dozen roundings"));
    CHECK(now.value("A", degrees) == within_relative(N / (1 + k), 1e-15, "a quotient"));
    CHECK(now.value("B", degrees) == within_relative(N1 / (1 - k), 1e-15, "a quotient"));
    const Fifty time =
        2 * exact::pi() * abs(u * u - 4 * l * l) / (rho.fifty() * u * u * u * m.fifty() * m.fifty());
    CHECK(now.value("time", seconds) == within_relative(time, 4e-15, "a dozen roundings"));
  }
}

/*!
The exchange is looked at once more in the motion by GSL, whose amplitude at μ is taken in the plain mean over
the same time.
*/

struct Both
{
  double P, Q;
};

Both by_gsl_about(double time)
{
  State<> now{{m, n, n1}, {}};
  std::complex<double> P = 0, Q = 0;
  double at = 0;
  for(int k = 0; k < 600; ++k)
  {
    const double next = time + meanwhile() * (k / 600. - 0.5);
    if(next > at)
      now = by_gsl(given(), now, next - at, 1e-12);
    at = next;
    P += std::polar(1., mu * next) * std::complex<double>(now.at.eta, now.rate.eta / mu);
    Q += std::polar(1., mu * next) * std::complex<double>(now.at.theta, now.rate.theta / mu);
  }
  return {std::abs(P) / 600, std::abs(Q) / 600};
}

double stray()  // what the beam's start gives both at once (§28), and what is of the next order
{
  return 2 * beta * lambda * lambda * m * m / std::abs(mu * mu - 4 * lambda * lambda)
         + 0.06 * std::max(std::abs(n), std::abs(n1));
}

CHECK_THAT("at T₃ the pans have changed places, in GSL's motion too; in the figure they do so by (C)")
{
  for(const Told& now :
      told_at("", "lambda=2 mu=11 rho=0.06 m=12 n=-1 n1=2", "mu=7 rho=0.1 m=15 n=1.5 n1=1.5"))
  {
    const double time = averaged(given(), m).time;
    const Both then = by_gsl_about(time);
    CHECK(now.value("P_then", degrees) == within(then.P, 0.01 * std::abs(n1), "another mean"));
    CHECK(now.value("Q_then", degrees) == within(then.Q, 0.01 * std::abs(n), "another mean"));
    CHECK(now.value("P_then", degrees) == within(std::abs(n1), stray(), "the next order"));
    CHECK(now.value("Q_then", degrees) == within(std::abs(n), stray(), "the same"));
    const auto points = now.points("swings");
    for(const std::size_t k : {std::size_t{40}, std::size_t{150}, std::size_t{280}})
    {
      const auto& point = points[k];
      const double turn = std::numbers::pi * point.at("t") / time;
      const Fifty P = sqrt((1 + cos(Fifty(turn))) / 2 * Fifty(n) * double(n)
                           + (1 - cos(Fifty(turn))) / 2 * Fifty(n1) * double(n1)),
                  Q = sqrt((1 - cos(Fifty(turn))) / 2 * Fifty(n) * double(n)
                           + (1 + cos(Fifty(turn))) / 2 * Fifty(n1) * double(n1));
      CHECK(point.value("P_theory") == within(P / 1_deg, 1e-12, "a cosine"));
      CHECK(point.value("Q_theory") == within(Q / 1_deg, 1e-12, "the same"));
      const Both there = by_gsl_about(point.at("t"));
      CHECK(point.value("P")
            == within(there.P / 1_deg, 0.02 * std::max(std::abs(n), std::abs(n1)) / 1_deg, "another mean"));
      CHECK(point.value("Q")
            == within(there.Q / 1_deg, 0.02 * std::max(std::abs(n), std::abs(n1)) / 1_deg, "another mean"));
      CHECK(Fifty(there.P) == within(P, 1.5 * stray(), "the next order"));
      CHECK(Fifty(there.Q) == within(Q, 1.5 * stray(), "the same"));
    }
  }
}

CHECK_THAT(
    "where neighbouring motions part too far the program refuses, but not where the swings are small")
{
  const std::string light = "lambda=2 mu=20 beta=0.05 rho=0.45 m=10 ";  // all is exchanged in 22 s
  for(const char* const apart : {"n1=0 n=2.97", "n1=0 n=2.93 t=68.9", "n=0 n1=2.805"})
    CHECK(refused_at(light + apart));
  for(const char* const near : {"n1=0 n=2.95", "n1=0 n=2.93 t=68.7", "n=0 n1=2.78"})
    CHECK(!refused_at(light + near));
  CHECK(refused_at("lambda=2 mu=20 beta=0.05 rho=0.45 m=1 n=10 n1=-10 t=200"));
  CHECK(!refused_at("lambda=2 mu=20 beta=0.05 rho=0.45 m=1 n=0.1 n1=-0.1 t=200"));
}

CHECK_THAT("μμ within λλ of 4λλ is refused, and an exchange of more than 3000 s, or in fewer than six "
           "swings of the beam to and fro")
{
  for(const char* const no :
      {"mu=1.73205081", "mu=2", "mu=2.23606797", "lambda=2 mu=3.464101616", "mu=1 rho=0.1 m=14.36192209",
       "rho=0.45 m=14.29207845", "lambda=2 rho=0.45 m=13.2318935"})
    CHECK(refused_at(no));
  for(const char* const yes :
      {"mu=1.7320508", "mu=2.23606798", "lambda=2 mu=3.464101615", "mu=1 rho=0.1 m=14.3619221",
       "rho=0.45 m=14.29207844", "lambda=2 rho=0.45 m=13.2318934"})
    CHECK(!refused_at(yes));
}

CHECK_THAT("pans that start alike go on alike, but for what the beam stirs in both")
{
  const Balance<> b{1, 25, 0.5, 0.25};
  const double time = averaged(b, 1. / 6).time;
  const auto all = envelopes(b, {{1. / 6, 1. / 6, 1. / 6}, {}}, 1.2 * time, 8 * std::numbers::pi, 60);
  for(const Envelope& now : all)
    CHECK(now.P == within(now.Q, 0.12 / 6, "what the beam's start gives to one and takes from the other"));
}

/*!
For $\mathfrak A$ and $\mathfrak B$ our copy is right, but they are Euler's approximation taken as equality,
and $n'$ a little more so than $n$: his start for Q falls short by $K$. In the first pair of denominators, and
in ϑ, it has a + for the 4 of $4g$, and α for $a$.
*/

const Erratum constant_B{
    "§32, 𝔅 for n′ = 1, in the example",
    {"n′", 1.},
    {"n′/(1 − K)", 420. / 419},
    "with n′ the pan does not start at n′",
    [](double reading) {
      const State<> start = general<double>(1, 3, 0.25, {0, reading, 1. / 6, 0, 90_deg, 90_deg}, 0);
      return start.at.theta == within_relative(1, 1e-14, "roundings");
    }};

const Emendation four_g{
    "§32, λμμam : 4g(2μ−λ), in the example",
    {"+g", [] { return 9 * 16. / 9 / 6 / (16 * 5); }},
    {"4g", [] { return 9 * 16. / 9 / 6 / (64 * 5); }},
    "§30 has it, and the general solution",
    [](double reading) {
      return reading == within_relative(sidebands<double>(1, 3, 0.25, 1, 1. / 6).M / 2, 1e-14, "roundings");
    }};
