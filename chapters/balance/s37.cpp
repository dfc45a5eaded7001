#include "balance/hung.hpp"
#include "edition/section.hpp"

SECTION(balance, 37, "No trace of a cause, and two that he dismisses")

using namespace balance;

/*!
## What Euler does

The calculation shows no trace of what was reported, that the pans rest and swing by turns. The cause must be
a quite different one. It might be sought in larger motions, or in this, that $A$ and $B$ were supposed to
lie in one straight line with $C$. But it does not appear how so small a change could make so huge a
difference, since the method leaves no room for doubt.

It can. If $A$ and $B$ lie by $e$ lower than $C$, a tilt of the beam moves them sideways at once. The swings
of both pans against each other keep the frequency μ; those with each other have another, σ, a root of

$$ \begin{gathered} (\lambda_e^2 - \sigma^2)(\mu^2 - \sigma^2) = \varepsilon\sigma^4,\\
  \varepsilon = \frac{2Le^2}{I_e}, \quad \lambda_e^2 = \frac{2g(Mc+2Le)}{I_e},\\
  I_e = M(kk+cc) + 2L(aa+ee). \end{gathered} \tag{A} $$

::: margin
Today: perturbation of a double eigenvalue.
:::

A pan that swings alone is the sum of the two, and after the time $\pi:|\sigma-\mu|$ the other has its
whole motion. However small $e$ is, nothing remains incomplete; it only takes longer, as $1 : ee$. What
counts is the coupling against the difference of the two pans, which is zero.

## The program
*/

const auto M = real("M", 2, none, closed(0.01, 1e4), "weight of the beam");
const auto L = real("L", 1, none, closed(0.01, 100), "weight of each pan");
const auto a = real("a", 2, feet, closed(0.1, 100), "half the beam");
const auto b = real("b", 2, feet, closed(0.1, 100), "length of the strings");
const auto c = real("c", 0.1, feet, closed(1e-4, 10), "depth of the beam's centre of gravity");
const auto k =
    real("k", 1.1547005383792515, feet, closed(0.03, 100), "the beam's radius of gyration about G");
const auto g = real("g", 16, feet, closed(0.1, 100), "height fallen in the first second");
const auto e = real("e", 0.2, feet, closed(1e-12, 10), "how far A and B lie below C");

double kk()
{
  return k * k;
}

const auto given = [] { return Suspended{{a, b, c, kk(), L, M, g}, 1, e, false}; };

TELL
{
  const auto all = modes(given());
  tell("slowest", all[0].frequency, Unit{"1/s"}, "the slowest of the three frequencies", 16);
  tell("middle", all[1].frequency, Unit{"1/s"}, "the second of them", 16);
  tell("fastest", all[2].frequency, Unit{"1/s"}, "the third", 16);
  tell("splitting", transfer(given()).splitting, Unit{"1/s"}, "σ − μ", 16);
  tell("time", transfer(given()).time, seconds, "P's motion is then Q's", 16);
}

TELL
{
  curve("times", {"e", "time"}, [](Curve& out) {
    for(int j = 0; j <= 40; ++j)
    {
      Suspended s = given();
      s.e = std::pow(10, -4 + j / 10.);
      out.put({s.e, transfer(s).time});
    }
  });
}

/*!
Lowered by {{e}} ft, the ends let P hand its motion to Q in {{time|5}} s.

::: figure balance-37
alt: The transfer time against the offset, both axes logarithmic: a straight line falling two decades for one.

The time in which P's motion becomes Q's, against the offset $e$. It is finite for every one.
:::

## Checks
*/

std::array<Fifty, 3> roots(const Fifty& e_)  // μ² and the two of (A), by the quadratic
{
  const Fifty M_ = double(M), L_ = double(L), a_ = double(a), c_ = double(c), G = 2 * Fifty(double(g));
  const Fifty I = M_ * (Fifty(kk()) + c_ * c_) + 2 * L_ * (a_ * a_ + e_ * e_), mu2 = G / double(b);
  const Fifty l2 = G * (M_ * c_ + 2 * L_ * e_) / I, rest = 1 - 2 * L_ * e_ * e_ / I;
  const Fifty root = sqrt((l2 + mu2) * (l2 + mu2) - 4 * rest * l2 * mu2);
  return {mu2, (l2 + mu2 - root) / (2 * rest), (l2 + mu2 + root) / (2 * rest)};
}

Fifty apart(const std::array<Fifty, 3>& all)  // σ − μ
{
  const Fifty mu = sqrt(all[0]), x = sqrt(all[1]) - mu, y = sqrt(all[2]) - mu;
  return abs(x) < abs(y) ? x : y;
}

CHECK_THAT("the frequencies are the roots of (A), and σ − μ their difference in fifty digits")
{
  for(const Told& now : told_at("", "e=1e-4", "e=1e-10 c=0.3 L=0.2", "M=50 a=1 b=3 e=0.7"))
  {
    auto all = roots(double(e));
    const Fifty split = apart(all);
    std::sort(all.begin(), all.end());
    CHECK(now.value("slowest", Unit{"1/s"}) == within_ulps(sqrt(all[0]), 1, "the library's bound"));
    CHECK(now.value("middle", Unit{"1/s"}) == within_ulps(sqrt(all[1]), 1, "the same"));
    CHECK(now.value("fastest", Unit{"1/s"}) == within_ulps(sqrt(all[2]), 1, "the same"));
    CHECK(now.value("splitting", Unit{"1/s"}) == within_relative(split, 1e-15, "two roundings"));
    CHECK(now.value("time", seconds) == within_relative(exact::pi() / abs(split), 1e-15, "the same"));
    const auto points = now.points("times");
    CHECK(points[0].at("time") / points[10].at("time") == between(80, 120, "as the square, for small e"));
    for(const std::size_t j : {std::size_t{0}, std::size_t{20}, std::size_t{40}})
    {
      const double lower = points[j].at("e");
      CHECK(points[j].value("e")
            == within_relative(pow(Fifty(10), Fifty(double(j)) / 10 - 4), 1e-14, "a power"));
      CHECK(points[j].value("time")
            == within_relative(exact::pi() / abs(apart(roots(lower))), 1e-15, "two roundings"));
    }
  }
}

/*!
## Go on from here

::: exercise
How low must $A$ and $B$ lie in this balance if the exchange is to take no longer than {{balance.38.time|4}}
s, as with the moving pivot of {{sec balance.38}}? Is that a small change?
answer: About 0.64 ft, since the time goes nearly as $1:ee$: a third of the arm. No maker would overlook it.
:::
*/

CHECK_THAT("A and B must lie some 0.64 ft lower for an exchange in 15.7 seconds")
{
  for(const Told& now : told_at("e=0.62", "e=0.66"))
    CHECK(now.value("time", seconds)
          == (e < 0.64 ? between(15.71, 17, "not yet") : between(14, 15.7, "by then")));
}
