#include "edition/section.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(balance, 4, "The pans, two weights on equal strings")

/*!
## What Euler does

The pans are taken for two equal weights that hang on two equal strings from the very ends $A$ and $B$ of the
beam. Each is a simple weight $L$ without extension, each string without weight, of the length

$$ AP = BQ = b. \tag{1} $$

Through $A$ and $B$ are drawn the verticals in which the strings would hang if they had no inclination. At the
time considered the pan P leans from its vertical by the angle η and the pan Q from its own by ϑ, both to the
same side: where η leads P outward, ϑ leads Q inward.

Three things are passed over, here or where the swings become small ({{sec balance.11}}), and the third
decides everything. A real pan has extension. If it is
rigid with its hangings, and κ is its radius of gyration about its centre of gravity, then it swings like a
simple weight on the somewhat longer string

$$ b + \frac{\kappa\kappa}b. \tag{A} $$

Then, a pan needs more time for a wide swing than for a small one, by the part $\frac1{16}nn$ to begin with,
$n$ being how far it goes from the vertical; it comes out of step with its companion while only one of the two
swings wide. And no two pans are *equal*. That they are here, to the last digit, is a supposition like the
others, and the whole exchange of motions rests on it.

::: margin
Today: two detuned oscillators, Rabi's formula. (A) is the compound pendulum of {{sec pendulum.06}}.
:::

What differing strings would do can be seen on any two oscillators of the frequencies μ and μ′, so coupled
that if they were equal one would hand over everything in the time $T$. Let σ be $\mu + \pi:T$. Then the
second gets at most the part

$$ \frac{\sigma^2-\mu^2}{\sqrt{(\sigma^2-\mu^2)^2 + (\mu^2-\mu'^2)^2}} \tag{B} $$

of the first one's swing. It is nearly everything if μ and μ′ differ by much less than $\pi:T$, nearly nothing
if by much more.

## The program
*/

const auto b = real("b", 2, feet, closed(1e-10, 1e10), "AP, the string of P");
const auto g = real("g", 16, feet, closed(1e-10, 1e10), "height fallen in the first second");
const auto n = angle("n", 10_deg, closed(1e-6_deg, 179.9_deg), "how far P swings from the vertical");
const auto kappa =
    real("kappa", 0.3, feet, closed(0, 1e10), "radius of gyration κ of a pan about its centre");
const auto longer =
    real("longer", 0.01, none, closed(-0.5, 1), "how much longer the string of Q is, in parts of b");
const auto T =
    real("T", 5 * std::numbers::pi, seconds, closed(1e-3, 1e9), "time in which equal pans pass everything");

double like_a_string()  // (A)
{
  return b + kappa / b * kappa;
}

double swing_of(double string)  // from side to side, very small
{
  return std::numbers::pi * std::sqrt(string / (2 * g));
}

double gets(double part, double time)  // (B), the other string being b(1 + part)
{
  const double mu = std::sqrt(2 * g / b), apart = std::numbers::pi / time;
  const double coupling = apart * (2 * mu + apart), detuning = mu * mu * part / (1 + part);
  return coupling / std::hypot(coupling, detuning);
}

TELL
{
  tell("time", swing_of(b), seconds, "one very small swing of P", 15);
  tell("string", like_a_string(), feet,
       "the string of a simple weight that keeps time with a rigid pan, (A)", 15);
  tell("time_rigid", swing_of(like_a_string()), seconds, "one swing of that pan", 15);
  tell("ratio", swing::ratio(swing::Amplitude::from_zeta(n)), "time of a swing of n, in very small swings",
       14);
  tell("wide", std::sqrt(8 * std::abs(double(longer))), degrees,
       "swing that takes longer by half that part, to the first order", 14);
  tell("gets", gets(longer, T), percent, "what Q gets of P's swing, (B)", 14);
}

TELL
{
  curve("parts", {"longer", "once", "four", "sixteen"}, [](Curve& out) {
    for(int j = -80; j <= 20; ++j)
    {
      const double part = std::pow(10, j / 20.) / 10;
      out.put({100 * part, gets(part, T), gets(part, 4 * T), gets(part, 16 * T)});
    }
  });
}

/*!
A swing of {{n}} takes {{ratio|7}} times as long as a very small one. With strings that differ by one
per cent Q gets {{gets|3}} of the swing, if equal pans would hand over everything in the {{balance.01.T|4}}
seconds of {{sec balance.01}}.

::: figure balance-04
alt: Three falling curves against the difference of the strings from a thousandth of a per cent to the whole
length, on a logarithmic axis. Each begins near one; the one for the longest time falls first.

What part of the swing the other pan gets at most, against the difference of the strings. The slower the
exchange, the more exactly must they be equal.
:::

## Checks
*/

CHECK_THAT("the times are those of the integral, and near the vertical they grow by a sixteenth of nn")
{
  for(const Told& now :
      told_at("", "n=90 b=1e-9 g=3e9 kappa=0", "n=179.9 kappa=4 b=5", "n=1e-6 b=1e10 kappa=1e10"))
  {
    const Fifty amplitude = n.fifty(), L = b.fifty() + kappa.fifty() * kappa.fifty() / b.fifty();
    const Fifty ratio = 2 * swing::oracle::K_from_complement(cos(amplitude / 2)) / exact::pi();
    CHECK(now.value("ratio") == within_relative(ratio, 2e-13, "n rounded, which matters near the top"));
    CHECK(now.value("time", seconds)
          == within_relative(exact::pi() * sqrt(b.fifty() / (2 * g.fifty())), 6e-16, "a root"));
    CHECK(now.value("string", feet) == within_relative(L, 4e-16, "a sum"));
    CHECK(now.value("time_rigid", seconds)
          == within_relative(exact::pi() * sqrt(L / (2 * g.fifty())), 8e-16, "a root of that"));
    if(n < 1_deg)
      CHECK(ratio
            == within(1 + amplitude * amplitude / 16, double(pow(amplitude, 4)),
                      "the next term is 11/3072 of it"));
  }
}

/*!
The two oscillators are set going by themselves: coupled by a spring $s$ of the strength that $T$ demands,

$$ \begin{gathered} \ddot u = -\mu^2u - s(u+v),\\
   \ddot v = -\mu'^2v - s(u+v),\\
   2s = \sigma^2-\mu^2,
\end{gathered} \tag{C} $$

in which equal ones keep μ against each other and have σ with each other. The first is let go alone, and what
the second reaches is looked for.
*/

double reached(double part, double time)
{
  const double mu = std::sqrt(2 * g / b), sigma = mu + std::numbers::pi / time;
  const double s = (sigma * sigma - mu * mu) / 2, other = mu * mu / (1 + part);
  std::array<double, 2> at{1, 0}, before = at;
  double most = 0;
  const double step = 2e-4 / sigma;
  at[0] = 1 - step * step / 2 * (mu * mu + s);
  at[1] = -step * step / 2 * s;
  for(double now = step; now < 3.2 * time; now += step)  // Störmer's rule
  {
    const double both = s * (at[0] + at[1]);
    const std::array<double, 2> next{2 * at[0] - before[0] - step * step * (mu * mu * at[0] + both),
                                     2 * at[1] - before[1] - step * step * (other * at[1] + both)};
    before = at;
    at = next;
    most = std::max(most, std::abs(at[1]));
  }
  return most;
}

CHECK_THAT("the second of two coupled oscillators gets what (B) says, of equal ones everything")
{
  for(const Told& now : told_at("", "longer=0.1", "longer=-0.3 b=3 T=40", "longer=0.9 T=30", "longer=0"))
    CHECK(now.value("gets", percent)
          == within(reached(longer, T), 2e-3, "the beat's top need not fall on one of the pan's"));
  for(const Told& now : told_at("longer=0", "longer=0 T=1e9", "longer=0 T=0.001 b=1e10"))
    CHECK(now.value("gets", percent) == within(1, 0, "equal pans"));
}

Fifty exactly(const Fifty& part, const Fifty& time)
{
  const Fifty mu2 = 2 * g.fifty() / b.fifty(), apart = exact::pi() / time;
  const Fifty c = apart * (2 * sqrt(mu2) + apart), d = mu2 - mu2 / (1 + part);
  return c / sqrt(c * c + d * d);
}

CHECK_THAT("(B) is told with all its digits, and drawn")
{
  for(const Told& now : told_at("", "longer=1e-9 T=1e9", "longer=-0.5 b=1e-9 T=1e4", "longer=1 g=1e-9 T=7"))
  {
    CHECK(now.value("gets", percent)
          == within_relative(exactly(longer.fifty(), T.fifty()), 4e-15, "a root and quotients"));
    for(const auto& point : now.points("parts", 6))
    {
      const Fifty part = Fifty(point.at("longer")) / 100, time = T.fifty();
      CHECK(point.value("once") == within_relative(exactly(part, time), 4e-15, "the same"));
      CHECK(point.value("four") == within_relative(exactly(part, 4 * time), 4e-15, "the same"));
      CHECK(point.value("sixteen") == within_relative(exactly(part, 16 * time), 4e-15, "the same"));
    }
  }
}

/*!
## Go on from here

::: exercise
How wide may P swing at the start before its longer time puts it out of step as much as a string longer by one
per cent would?

answer: The time grows by $\frac1{16}nn$, with the string by half a per cent: about {{wide|3}}. Where equal
pans need long for the exchange, wide swings are exchanged incompletely ({{sec balance.38}}).
:::
*/

CHECK_THAT("a swing of that width takes longer by what the longer string takes, to the first order")
{
  for(const Told& now : told_at("", "longer=1e-4", "longer=-0.3"))
  {
    const Fifty wide = sqrt(8 * abs(longer.fifty()));
    CHECK(now.value("wide", degrees) == within_relative(wide, 1e-15, "a root"));
    const Fifty by_string = abs(longer.fifty()) / 2;
    CHECK(double(swing::oracle::ratio_from_bottom(wide) - 1)
          == within_relative(by_string, 0.3, "higher orders"));
  }
}
