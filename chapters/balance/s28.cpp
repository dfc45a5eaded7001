#include "balance/euler.hpp"
#include "edition/section.hpp"

SECTION(balance, 28, "Case 1: do both pans stay at rest for ever?")

using namespace balance;

/*!
## What Euler does

The way out of the contradiction is that the conditions were divided by $\mathfrak A$ and $\mathfrak B$, and
so lost the factors on which everything hangs. Nothing else can meet them but

$$ \mathfrak A = 0, \qquad \mathfrak B = 0. \tag{1} $$

So in this case, Euler concludes, both pans remain at rest for ever {{entry pans_at_rest}} and take up no
motion at all, though the beam goes on swinging beside them.

::: margin
Today: a 1 : 2 resonance. Its divisor, $\mu - 2\lambda$, does not occur in Euler's formulae.
:::

At the order of smallness at which he works that is not so. His equations keep the product $\eta\omega$, of
the second order, but have dropped a term that is of the same order and does not vanish with η
({{sec balance.13}}): $A$ and $B$ move on arcs, and so a little sideways, twice in each period of the beam.
With it

$$ \begin{gathered} \frac{d^2\eta}{dt^2} + \mu\mu\eta = \frac{a}{b}\,\frac{d^2}{dt^2}\frac{\omega\omega}2,\\
   \eta = -F(\cos2\lambda t - \cos\mu t),\\
   F = \frac ab\,\frac{\lambda\lambda mm}{\mu\mu-4\lambda\lambda},
\end{gathered} \tag{A} $$

and $\vartheta = -\eta$: the pans open and close together. At $\mu = 2\lambda$ the divisor vanishes, and the
swings grow with the time, as $-\frac{a}{4b}mm\lambda\,t\sin2\lambda t$.

## The program

The second order is that of {{api balance::second_order}}; beside it the full equations are integrated. Where
a slight change of the start would grow more than ten thousand times until $t$, the program refuses.
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, closed(0.1, 10), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, closed(0.1, 30), "frequency of the pans, μ = √(2g/b)");
const auto beta = real("beta", 0.5, none, closed(0.01, 2), "a/b, arm to string");
const auto rho = real("rho", 0.25, none, closed(0, 0.45), "share of one pan in the whole inertia");
const auto m = angle("m", 1. / 6, closed(0.01_deg, 20_deg), "inclination of the beam at the start");
const auto t = real("t", 1, seconds, closed(0.001, 100), "time");

const auto given = [] { return Balance<>{lambda * lambda, mu * mu, beta, rho}; };

TELL
{
  require(parting(given(), released(m, 0, 0), t) <= 1e4, "t",
          "so short that a slight change does not grow ten thousand times");
  const Angles<> second = second_order(given(), {m, 0, 0}, t);
  const Angles<> full = Motion(given(), released(m, 0, 0)).to(t).at;
  tell("omega", full.omega, degrees, "the beam, by the full equations", 10);
  tell("eta", full.eta, degrees, "the pan P", 9);
  tell("theta", full.theta, degrees, "the pan Q", 9);
  tell("eta_second", second.eta, degrees, "P by (A)");
  tell("theta_second", second.theta, degrees, "Q by (A)");
}

TELL
{
  curve("pans", {"t", "eta", "theta", "second"}, [](Curve& out) {
    const double until = 4 * std::numbers::pi;
    for(int j = 0; const State<>& now : course({1, 9, 0.5, 0.25}, released(1. / 6, 0, 0), until, 400))
    {
      const double at = until * j++ / 400;
      const double second = second_order({1, 9, 0.5, 0.25}, {1. / 6, 0, 0}, at).eta;
      out.put({at, now.at.eta / 1_deg, now.at.theta / 1_deg, second / 1_deg});
    }
  });
}

/*!
After {{t}} s P stands at {{eta|4}}, Q at {{theta|4}}; by {{eq A}} at {{eta_second|4}} and
{{theta_second|4}}. By Euler both would be at zero.

::: figure balance-28
alt: The inclinations of both pans over two periods of the beam, mirror images of each other, up to a third
of a degree. Formula (A) runs close to P. Euler's line is zero.

Both pans hang at rest when the beam is let go at a sixth of the radius, $\lambda = 1$, $\mu = 3$. They do
not stay so: P and Q by the full equations, P by {{eq A}} (dashed), and what Euler says, zero.
:::

## Checks
*/

CHECK_THAT("the pans move as the full equations say, here by GSL, and to the second order as (A) does")
{
  for(const Told& now :
      told_at("", "lambda=1 mu=2 m=3 t=20", "mu=7 beta=1.5 rho=0.4 m=12 t=5", "m=0.01 t=40"))
  {
    const Angles<> full = by_gsl(given(), released(m, 0, 0), t, 1e-13).at;
    CHECK(now.value("omega", degrees) == within(full.omega, 1e-11, "GSL's tolerance, step by step"));
    CHECK(now.value("eta", degrees) == within(full.eta, 1e-11, "the same"));
    CHECK(now.value("theta", degrees) == within(full.theta, 1e-11, "the same"));
    const Fifty l = lambda.fifty(), u = mu.fifty(), s = t.fifty(),
                am = beta.fifty() * m.fifty() * m.fifty();
    const Fifty A = u == 2 * l ? -am * l * s * sin(2 * l * s) / 4
                               : -am * l * l / (u * u - 4 * l * l) * (cos(2 * l * s) - cos(u * s));
    CHECK(now.value("eta_second", degrees)
          == within(A, 1e-15 * double(am) * mu * t + 1e-18, "phases rounded"));
    CHECK(now.value("theta_second", degrees)
          == within(-A, 1e-15 * double(am) * mu * t + 1e-18, "the same"));
    CHECK(abs(Fifty(full.eta) - A)
          <= 4 * double(am) * m * (1 + mu * t) + 1e-11);  // a third order, which the time lets grow
  }
  const Angles<> at_pi = second_order({1, 9, 0.5, 0.25}, {1. / 6, 0, 0}, std::numbers::pi);
  CHECK(at_pi.eta == within_relative(Fifty(-1) / 180, 1e-14, "2F, with F = 1/360"));
}

CHECK_THAT(
    "where neighbouring motions part too far the program refuses, but not where the swings are small")
{
  CHECK(refused_at("lambda=10 mu=1 beta=2 rho=0.45 m=20 t=4.37"));
  CHECK(!refused_at("lambda=10 mu=1 beta=2 rho=0.45 m=20 t=4.361"));
  CHECK(!refused_at("lambda=10 mu=1 beta=2 rho=0.45 m=0.02 t=100"));
}

CHECK_THAT("in the figure the pans are those of GSL's motion, and (A)")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("pans", 5))
    {
      const double s = point.at("t");
      const Angles<> full =
          s == 0 ? Angles<>{} : by_gsl({1, 9, 0.5, 0.25}, released(1. / 6, 0, 0), s, 1e-13).at;
      CHECK(point.value("eta") == within(full.eta / 1_deg, 1e-9, "GSL's tolerance"));
      CHECK(point.value("theta") == within(full.theta / 1_deg, 1e-9, "GSL's tolerance"));
      const Fifty A = -(cos(2 * Fifty(s)) - cos(3 * Fifty(s))) / 360 * 180 / exact::pi();
      CHECK(point.value("second") == within(A, 1e-14, "phases rounded"));
    }
}

const Erratum pans_at_rest{
    "§28, the greatest inclination of P while the beam swings once to and fro, in minutes",
    {"none", 0},
    {"18.65′", 18.65},
    "the full equations, λ = 1, μ = 3, a/b = ½, ρ = ¼, m = ⅙",
    [](double reading) {
      State<> now = released(1. / 6, 0, 0);
      double most = 0;
      for(int k = 0; k < 630; ++k)
      {
        now = by_gsl({1, 9, 0.5, 0.25}, now, 0.01, 1e-12);
        most = std::max(most, std::abs(now.at.eta));
      }
      return reading == within(most / 1_deg * 60, 0.005, "the digits given");
    }};

/*!
## Go on from here

::: exercise
Let μ be 2λ. After what time would the pans swing as wide as the beam by {{eq A}}, and why do they not get so
far?
answer: After $t = 4b:a\lambda m$, 48 s in the example. But what they gain the beam loses: after 20 s they
stand at 2.0° where {{eq A}} has 3.0°.
:::
*/

CHECK_THAT("at μ = 2λ the pans fall behind (A) after twenty seconds")
{
  CHECK(4 / (0.5 / 6) == within(48, 1e-12, "a quotient"));
  for(const Told& now : told_at("mu=2 t=20"))
  {
    CHECK(now.value("eta", degrees) == between(-2.05_deg, -1.95_deg, "2.0°"));
    CHECK(now.value("eta_second", degrees) == between(-3.05_deg, -2.95_deg, "3.0°"));
  }
}
