#include "balance/euler.hpp"
#include "balance/exchange.hpp"
#include "edition/section.hpp"

SECTION(balance, 31, "No motion in the other pan, and where it comes from all the same")

using namespace balance;

/*!
## What Euler does

Once more he concludes that, however the beam and the one pan may have been set going, no motion at all can
arise in the other {{entry in_the_other}}; and that this seems to be against the experiment that was reported
to him. But he adds a caution. Only smallest oscillations have been considered. Angles were put for their
sines, and unity for their cosines; had the sines and cosines themselves been kept, the difference would have
been huge, and so it cannot be denied that in greater oscillations there may be such a communication. Only, it
could not have been determined from the theory.

The caution is right, and more right than he thinks. That the other pan stays at rest is not so even at the
order at which he works ({{sec balance.28}}). At the next it takes over the *whole* motion, in this very
model, and the theory does determine it. A beam that swings with the amplitude $m$ couples the pans by the
tones at $\mu \pm \lambda$ which each of them gives it. In the mean over its oscillations the difference
$\eta - \vartheta$ swings with another frequency than the sum $\eta + \vartheta$, and the two frequencies
differ by

$$ \frac{\rho\,\mu^3m^2}{2(\mu^2-4\lambda^2)}, \tag{A} $$

where ρ is the share of one pan in the whole inertia. After the time in which this makes half a turn,

$$ T_3 = \frac{2\pi\,|\mu^2-4\lambda^2|}{\rho\,\mu^3m^2}, \tag{B} $$

the pan that was let go alone is at rest and the other swings in its place. Both frequencies are besides
lowered a little, as Mathieu's equation ({{sec balance.15}}) has it; that of the sum then differs from μ by

$$ -\frac{a^2}{b^2}\,\frac{\lambda^4m^2}{4\mu(4\mu^2-\lambda^2)}. \tag{C} $$

::: margin
Today: the first average of a fourth-order Hamiltonian. The pans are in 1 : 1 resonance, so any coupling,
however small, exchanges all.
:::

As the beam's amplitude comes in by its square, beams that swing less need longer, in the limit for ever;
this is what a theory of smallest oscillations sees of it.

## The program

The formulae are {{api balance::averaged}}. The full equations are integrated by {{api balance::Motion}}, and
the motion is demodulated at μ, {{api balance::envelopes}}.
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, closed(0.5, 2), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 5, Unit{"1/s"}, closed(1, 20), "frequency of the pans, μ = √(2g/b)");
const auto beta = real("beta", 0.5, none, closed(0.05, 1), "a/b, arm to string");
const auto rho = real("rho", 0.25, none, closed(0.01, 0.45), "share of one pan in the whole inertia");
const auto m = angle("m", 1. / 6, closed(1_deg, 20_deg), "inclination of the beam at the start");
const auto n = angle("n", 1. / 60, closed(0.1_deg, 20_deg), "inclination of the pan P at the start");

const auto given = [] { return Balance<>{lambda * lambda, mu * mu, beta, rho}; };

std::vector<Envelope> swings(double until)  // of P and Q
{
  return envelopes(given(), released(m, n, 0), until, 8 * std::numbers::pi / lambda, 400);
}

TELL
{
  const double square = mu / lambda * (mu / lambda);
  require(std::abs(square - 4) >= 1, "mu",
          "such that μμ differs from 4λλ by λλ or more, where (A) is infinite");
  const Averaged mean = averaged(given(), m);
  require(mean.time <= 3000, "m", "such that the exchange takes 3000 s at the most");
  require(mean.time >= 12 * std::numbers::pi / lambda, "m",
          "such that it takes six oscillations of the beam");
  const Handover over = handover(swings(1.8 * mean.time));
  tell("splitting", mean.splitting, Unit{"1/s"}, "by how much the two frequencies differ, (A)");
  tell("shift", mean.shift, Unit{"1/s"}, "by how much that of η + ϑ differs from μ, (C)");
  tell("by_theory", mean.time, seconds, "P's motion is then Q's, (B)");
  tell("by_motion", over.time, seconds, "Q then swings farthest, by the full equations", 5);
  tell("Q", over.Q, percent, "its amplitude, in parts of P's first", 4);
  tell("P", over.P, percent, "P's then", 3);
}

TELL
{
  curve("envelopes", {"t", "P", "Q"}, [](Curve& out) {
    for(const Envelope& now : swings(2.2 * averaged(given(), m).time))
      out.put({now.t, now.P / n, now.Q / n});
  });
}

/*!
His example has μ = 3λ, and all three angles alike ({{sec balance.35}}). Let P alone have its angle, and halve
all angles twice.
*/

const Balance<> of_35{1, 9, 0.5, 0.25};

Handover in_the_example(double angle)
{
  const double until = 1.8 * averaged(of_35, angle).time;
  return handover(envelopes(of_35, released(angle, angle, 0), until, 8 * std::numbers::pi, 400));
}

TELL
{
  auto& rows = table("example", "λ = 1, μ = 3, a/b = ½, ρ = ¼: beam and P let go from the same angle",
                     {{"angle", "m = n", degrees, 3},
                      {"theory", "by (B)", seconds, 4},
                      {"motion", "full equations", seconds, 4},
                      {"Q", "Q's swing", percent, 3},
                      {"P", "P's then", percent, 2}});
  for(const double angle : {1. / 6, 1. / 12, 1. / 24})
  {
    const Handover over = in_the_example(angle);
    rows.row({angle, averaged(of_35, angle).time, over.time, over.Q, over.P});
  }
  const double full = in_the_example(1. / 6).time, theory = averaged(of_35, 1. / 6).time;
  tell("longer", full / theory - 1, percent, "by what part the exchange takes longer than (B), at a sixth",
       3);
}

/*!
By {{eq B}} the motion passes in {{by_theory|5}} s, by the full equations in {{by_motion|4}} s; then Q has
{{Q|3}} of the swing with which P began, and P {{P|2}}.

::: figure balance-31
alt: Two curves against the time. P's amplitude falls from one nearly to zero and comes back; Q's rises from
zero to one at the same time.

How far P and Q swing, in parts of the angle $n$ from which P alone was let go, by the full equations, with a
beam that swings by a sixth of the radius. P begins with more than $n$, the $n(1-K)+F$ of {{eq balance.30 B}}.
By Euler Q would keep to the line of zero.
:::

### Euler's own example

{{table example}}

At the sixth of the radius that he has the exchange takes longer than {{eq B}} by {{longer|2}}: there (B) is
but an estimate, since what is of the order of the angles' squares beside it is left out, and angles of the
pan count as much as those of the beam. Halve the angles, and (B) comes nearer. In this example, besides,
the pans' frequency is three times the beam's: at small swings of P beside a wide one of the beam this stirs
both pans alike ({{sec balance.28}} has the same at twice the beam's), and Q can get more than P had.

## Checks
*/

CHECK_THAT("the averages are (A), (B) and (C)")
{
  for(const Told& now :
      told_at("", "lambda=2 mu=11 rho=0.4 m=12 n=3", "mu=3 beta=1 rho=0.1 m=20", "mu=1 m=15"))
  {
    const Fifty u = mu.fifty(), l = lambda.fifty(), mm = m.fifty() * m.fifty(), B = beta.fifty();
    const Fifty apart = rho.fifty() * u * u * u * mm / (2 * (u * u - 4 * l * l));
    CHECK(now.value("splitting", Unit{"1/s"}) == within_relative(apart, 4e-15, "a dozen roundings"));
    CHECK(now.value("by_theory", seconds) == within_relative(exact::pi() / abs(apart), 4e-15, "the same"));
    const Fifty down = -B * B * l * l * l * l * mm / (4 * u * (4 * u * u - l * l));
    CHECK(now.value("shift", Unit{"1/s"}) == within_relative(down, 4e-15, "the same"));
  }
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

/*!
The handover is looked for a second time in the motion by GSL, as plainly as possible: the amplitude at a
moment is taken from the angle and the rate, in the mean over one oscillation of the beam.
*/

struct Amplitudes
{
  double P, Q;
};

Amplitudes plainly(double t)  // about the time t, over n
{
  Amplitudes sum{0, 0};
  const double period = 2 * std::numbers::pi / lambda;
  for(int k = 0; k < 12; ++k)
  {
    const State<> now = by_gsl(given(), released(m, n, 0), t + period * (k / 12. - 0.5), 1e-11);
    sum.P += now.at.eta * now.at.eta + now.rate.eta * now.rate.eta / (mu * mu);
    sum.Q += now.at.theta * now.at.theta + now.rate.theta * now.rate.theta / (mu * mu);
  }
  return {std::sqrt(sum.P / 12) / n, std::sqrt(sum.Q / 12) / n};
}

double side_tones()  // what they add to the plain amplitude, at most, in parts of n
{
  const double both = beta * lambda * m * (1 / (2 * mu - lambda) + 1 / (2 * mu + lambda));
  const double F = beta * lambda * lambda * m * m / std::abs(mu * mu - 4 * lambda * lambda);
  return both + 2 * F / n + m * m;
}

CHECK_THAT(
    "at the time told Q swings as far as told, and P as little; and Q less far a quarter of the time "
    "before or after")
{
  for(const Told& now : told_at("", "lambda=2 mu=11 rho=0.4 m=6 n=2", "mu=7 rho=0.1 m=20 n=1.5"))
  {
    const double theory = averaged(given(), m).time;
    CHECK(now.value("by_motion", seconds)
          == within_relative(theory, 0.06, "the next order, mm, and side tones"));
    const double T = handover(swings(1.8 * theory)).time, off = side_tones();
    CHECK(now.value("by_motion", seconds) == within_relative(T, 1e-12, "the same motion"));
    const Amplitudes at_T = plainly(T);
    CHECK(now.value("Q", percent) == within(at_T.Q, off, "the side tones"));
    CHECK(now.value("P", percent) == within(at_T.P, off + 0.1, "the same, which add up to it"));
    CHECK(plainly(0.75 * T).Q < at_T.Q);
    CHECK(plainly(1.25 * T).Q < at_T.Q);
    const auto points = now.points("envelopes");
    for(const std::size_t k : {std::size_t{60}, std::size_t{200}, std::size_t{340}})
    {
      const double t =
          4 * std::numbers::pi / lambda + double(k) / 400 * (2.2 * theory - 8 * std::numbers::pi / lambda);
      CHECK(points[k].value("t") == within_relative(t, 1e-12, "equal steps"));
      const Amplitudes there = plainly(t);
      CHECK(points[k].value("P") == within(there.P, off + 0.05, "the side tones, which add up"));
      CHECK(points[k].value("Q") == within(there.Q, off + 0.05, "the same"));
    }
  }
}

CHECK_THAT("in the figure P begins with the n(1 − K) + F of § 30, more than it was let go from")
{
  for(const Told& now : told_at("n=1"))
  {
    const double K = beta * lambda * lambda * m / (4 * mu * mu - lambda * lambda);
    const double F = beta * lambda * lambda * m * m / (mu * mu - 4 * lambda * lambda);
    const double begins = 1 - K + F / n;
    CHECK(begins == between(1.03, 1.05, "more than n"));
    const auto first = now.points("envelopes")[0];
    CHECK(first.value("P")
          == within(begins * std::cos(std::numbers::pi * first.at("t") / (2 * averaged(given(), m).time)),
                    0.01, "the third order"));
  }
}

CHECK_THAT("the smaller the beam's swing, the better (B)")
{
  double last = 1;
  for(const double beam : {1. / 6, 1. / 12, 1. / 24})
  {
    const Balance<> b{1, 25, 0.5, 0.25};
    const double theory = averaged(b, beam).time;
    const auto course = envelopes(b, released(beam, beam / 10, 0), 1.8 * theory, 8 * std::numbers::pi, 400);
    const double off = std::abs(handover(course).time / theory - 1);
    CHECK(off < last);
    CHECK(off < 0.03);
    last = off;
  }
}

Envelope in_the_mean(double angle, double middle)  // over four swings of the beam to and fro, by GSL
{
  return by_gsl_in_the_mean(of_35, released(angle, angle, 0), middle, 8 * std::numbers::pi, 400);
}

CHECK_THAT("in Euler's example all passes over, later than (B) says, and by less the smaller the angles")
{
  for(const Told& now : told_at(""))
  {
    const auto rows = now.rows("example");
    REQUIRE(rows.size() == 3);
    double last = 0.25;
    for(std::size_t k{0}; k < 3; ++k)
    {
      const Fifty angle = Fifty(1) / (6 << k), theory = 40 * exact::pi() / (27 * angle * angle);
      const double time = rows[k].at("motion", seconds), angle_ = double(angle);
      CHECK(rows[k].value("angle", degrees) == within_relative(angle, 1e-15, "one rounding"));
      CHECK(rows[k].value("theory", seconds) == within_relative(theory, 4e-15, "a dozen roundings"));
      const double first = in_the_mean(angle_, 12.6).P;
      const Envelope there = in_the_mean(angle_, time);
      CHECK(rows[k].value("motion", seconds)
            == between(double(theory), (1 + last) * double(theory), "(B), and less off"));
      CHECK(rows[k].value("Q", percent) == within(there.Q / first, 0.01, "another mean"));
      CHECK(rows[k].value("P", percent) == within(there.P / first, 0.01, "another mean"));
      CHECK(in_the_mean(angle_, 0.85 * time).Q < there.Q);
      CHECK(in_the_mean(angle_, 1.15 * time).Q < there.Q);
      last = time / double(theory) - 1;
    }
    const double first_time = rows[0].at("motion", seconds);
    CHECK(now.value("longer", percent)
          == within(first_time * 27 / (36 * 40 * std::numbers::pi) - 1, 1e-12, "the table's first row"));
  }
  // a small swing of P beside a wide one of the beam: Q gets more than P had, at μ = 3λ and not at 5λ
  const auto reach = [](double mu2) {
    const Balance<> b{1, mu2, 0.5, 0.25};
    const double until = 1.8 * averaged(b, 1. / 6).time;
    return handover(envelopes(b, released(1. / 6, 1. / 60, 0), until, 8 * std::numbers::pi, 400)).Q;
  };
  CHECK(reach(9) > 1.1);
  CHECK(reach(25) < 1.02);
}

const Erratum in_the_other{"§31, Q's swing from 196 to 202 seconds in the example, in parts of P's first",
                           {"not at all", 0},
                           {"1.021", 1.021},
                           "the full equations, ρ = ¼, P alone let go",
                           [](double reading) {
                             State<> now = by_gsl(of_35, released(1. / 6, 1. / 6, 0), 196, 1e-13);
                             double most = 0;
                             for(int k = 0; k < 600; ++k)
                             {
                               now = by_gsl(of_35, now, 0.01, 1e-13);
                               most = std::max(most, std::abs(now.at.theta) * 6);
                             }
                             return reading == within(most, 0.0005, "the digits given");
                           }};

/*!
## Go on from here

::: exercise
How many swings does P make until its motion is Q's, if the pans are much quicker than the beam?
answer: By {{eq B}} $\mu T_3:\pi$ tends to $2:\rho mm$. With a beam that swings by a sixth and $\rho=\tfrac14$
that is 288 swings, whatever the lengths. (In the balance of {{sec balance.01}} it is
{{balance.01.swings|3}}.)
:::
*/

CHECK_THAT("quick pans make 2 : ρmm swings until all is exchanged, less a part 4λλ : μμ")
{
  for(const Told& now : told_at("lambda=2 mu=20", "lambda=1 mu=14"))
  {
    const Fifty part = 4 * lambda.fifty() * lambda.fifty() / (mu.fifty() * mu.fifty());
    const Fifty time = 288 * (1 - part) * exact::pi() / mu.fifty();
    CHECK(now.value("by_theory", seconds) == within_relative(time, 1e-14, "the sixth is rounded"));
  }
}
