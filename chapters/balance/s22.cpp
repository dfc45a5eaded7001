#include "balance/instrument.hpp"
#include "balance/mathieu.hpp"
#include "edition/section.hpp"
#include "exact/ode.hpp"

SECTION(balance, 22, "The beam is slow, the pans are quick")

using namespace balance;

/*!
## What Euler does

Before he turns to single motions Euler settles which of the two frequencies is the greater. For Bernoulli's
phenomena to show, the beam must swing to and fro at all, and therefore its centre of gravity must lie below
the pivot: the balance must be of the sluggish kind ({{sec balance.02}}, {{sec balance.21}}). Yet the depth
$c = CG$ is always very small. Hence the length

$$ f = c + \frac{kk}c + \frac{2Laa}{Mc} \tag{1} $$

of the pendulum that keeps time with the beam is very great, and $\lambda = \sqrt{2g:f}$ a very small number.
On the other hand

$$ \mu = \sqrt{\frac{2g}b} \tag{2} $$

is for the most part considerable, unless the pans hang by very short strings; but that is never done. So in
what follows λ may be taken as always much smaller than μ. It is a statement about instruments, not about
formulae, and much rests on it: $2\mu-\lambda$, by which he divides, is then not small
({{sec balance.17}}), nor is the difference of $1$ and $K$ ({{sec balance.30}}), and by it he chooses the
frequencies of his example ({{sec balance.35}}).

How small can λ be made, and how great? The ratio is one of two lengths, and by (1) $f$ has a least value,
that at $c = f:2$:

$$ \frac\lambda\mu = \sqrt{\frac bf}, \qquad f \ge 2\sqrt{kk + \frac{2Laa}M}. \tag{A} $$

::: margin
Today: Mathieu's equation with $a = 4\mu^2/\lambda^2$ and $q = 2p$; (B) are the tips of its Arnold tongues.
:::

A beam whose strings are shorter than this least $f$ is slower than its pans, wherever its centre of gravity
lies. What Euler keeps away from by
his assumption has a name today. In the pan's equation ({{sec balance.15}}) the weight seems to vary with the
frequency λ; about

$$ \lambda = 2\mu, \quad \mu, \quad \tfrac23\mu, \quad \ldots, \quad \frac{2\mu}j \tag{B} $$

lie intervals in which the swings of a pan grow without end, however small the beam's. In the first of them
they grow as $e^{p\mu t}$ or nearly so, with $p = am:b$, as much as the arm's end rises in parts of the
string; and it reaches, nearly, from $2\mu(1-p)$ to $2\mu(1+p)$. For $\lambda=2\mu$ the strings must be four
times as long as $f$: that is excluded indeed. But in the direction of slow beams the intervals do not end,
they become too narrow to be met. And another resonance is not excluded at all, that of $\mu=2\lambda$, with
$f=4b$ ({{sec balance.28}}); Euler's equations do not contain it.

## The program

The intervals are from characteristic values, {{api balance::unstable}}, the rates of growth from
{{api balance::floquet}}.
*/

const auto a = real("a", 2, feet, closed(0.1, 100), "half the beam");
const auto b = real("b", 2, feet, closed(0.1, 1000), "length of the strings");
const auto c = real("c", 0.1, feet, closed(1e-3, 100), "depth of the beam's centre of gravity");
const auto k =
    real("k", 1.1547005383792515, feet, closed(0.03, 100), "the beam's radius of gyration about G");
const auto L = real("L", 0.5, none, closed(0, 100), "weight of each pan");
const auto M = real("M", 2, none, closed(0.01, 1e4), "weight of the beam");
const auto g = real("g", 16, feet, closed(0.1, 100), "height fallen in the first second");
const auto m = angle("m", 1. / 6, closed(0.01_deg, 25_deg), "how far the beam swings");

double kk()
{
  return k * k;
}

Quantities given()
{
  return quantities_of({a, b, c, kk(), L, M, g});
}

double strength()  // p = am/b
{
  return a / b * m;
}

TELL
{
  const Quantities q = given();
  require(strength() <= 0.4, "m", "such that am/b is 0.4 at the most");
  const Least least = least_f({a, b, c, kk(), L, M, g});
  tell("f", q.f, feet, "the beam's pendulum, (1)", 15);
  tell("lambda", q.lambda, Unit{"1/s"}, "λ", 15);
  tell("mu", q.mu, Unit{"1/s"}, "μ, (2)", 15);
  tell("ratio", q.lambda / q.mu, "λ/μ", 15);
  tell("least_f", least.f, feet, "the least f for any c, (A)", 15);
  tell("most", std::sqrt(b / least.f), "the greatest λ/μ with these strings", 15);
  tell("excluded", 4 * q.f, feet, "the strings for which λ is 2μ", 15);
  tell("open", q.f / 4, feet, "the strings for which μ is 2λ", 15);
  tell("p", strength(), "am/b", 15);
}

TELL
{
  const double mu = given().mu, p = strength();
  auto& rows =
      table("intervals", "Where a pan's swings grow: between which frequencies of the beam, and how fast",
            {{"order", "j"},
             {"middle", "2μ/j", Unit{"1/s"}},
             {"from", "from λ", Unit{"1/s"}, 11},
             {"to", "to λ", Unit{"1/s"}, 11},
             {"growth", "rate at λ = 2μ/j", Unit{"1/s"}, 7}});
  for(const int j : {1, 2})
  {
    const Interval i = unstable(mu, p, j);
    rows.row({(long long)j, 2 * mu / j, i.from, i.to, floquet({mu, 2 * mu / j, p}).growth});
  }
}

TELL
{
  for(const int j : {1, 2, 3})
    curve(j == 1   ? "first"
          : j == 2 ? "second"
                   : "third",
          {"p", "from", "to"}, [j](Curve& out) {
            for(int k = 0; k <= 80; ++k)
            {
              const Interval i = k == 0 ? Interval{2. / j, 2. / j} : unstable(1, k / 200., j);
              out.put({k / 200., i.from, i.to});
            }
          });
  curve("balances", {"c", "ratio", "p"}, [](Curve& out) {
    for(int k = -30; k <= 20; ++k)
    {
      const double depth = std::pow(10, k / 10.);
      const Quantities q = quantities_of({a, b, depth, kk(), L, M, g});
      out.put({depth, q.lambda / q.mu, strength()});
    }
  });
}

/*!
In this instrument $f$ is {{f|4}} ft for strings of {{b}} ft, and λ is {{ratio|4}} of μ. At whatever depth the
centre of gravity lay, it would not be more than {{most|4}} of it. For $\lambda=2\mu$ the strings would have
to be {{excluded|4}} ft long, for $\mu = 2\lambda$ only {{open|4}} ft.

{{table intervals}}

::: figure balance-22
alt: Narrow wedges that stand on their tips at two, one and two thirds of the axis of the frequencies' ratio
and widen upwards. All balances of one kind lie on a short level line at the left, which crosses the third
wedge, as thin as a line there.

Where a pan's swings grow: the beam's frequency in parts of μ, and $p=am:b$. The wedges stand on
$\lambda=2\mu$, μ, $\frac23\mu$. The level line holds all the balances that have this beam, these pans and
strings, at whatever depth their centre of gravity; the point is Euler's example.
:::

## Checks
*/

Fifty kk_exactly()
{
  return k.fifty() * k.fifty();
}

CHECK_THAT("f, λ, μ, their ratio and its bound are (1), (2), (A), and the bound is met at c = f : 2")
{
  for(const Told& now : told_at("", "c=2.5 L=0 b=0.7 m=3", "a=31 b=200 k=9.5 L=40 M=0.5 c=0.002 g=9.7"))
  {
    const Fifty A = a.fifty(), C = c.fifty(), inner = kk_exactly() + 2 * L.fifty() * A * A / M.fifty();
    const Fifty f = C + inner / C, least = 2 * sqrt(inner);
    const char* const because = "a dozen roundings";
    CHECK(now.value("f", feet) == within_relative(f, 2e-15, because));
    CHECK(now.value("lambda", Unit{"1/s"}) == within_relative(sqrt(2 * g.fifty() / f), 2e-15, because));
    CHECK(now.value("mu", Unit{"1/s"}) == within_relative(sqrt(2 * g.fifty() / b.fifty()), 1e-15, because));
    CHECK(now.value("ratio") == within_relative(sqrt(b.fifty() / f), 2e-15, because));
    CHECK(now.value("least_f", feet) == within_relative(least, 2e-15, because));
    CHECK(now.value("most") == within_relative(sqrt(b.fifty() / least), 2e-15, because));
    CHECK(now.value("excluded", feet) == within_relative(4 * f, 2e-15, because));
    CHECK(now.value("open", feet) == within_relative(f / 4, 2e-15, because));
    CHECK(now.value("p") == within_relative(A * m.fifty() / b.fifty(), 1e-15, because));
    const Fifty at_least = sqrt(inner);
    for(const Fifty& depth : {Fifty(at_least * 99 / 100), Fifty(at_least * 101 / 100)})
      CHECK(depth + inner / depth > least);
    CHECK(f >= least);
  }
}

CHECK_THAT("swings of am/b = 0.4 are followed, and no greater ones")
{
  for(const char* const greater : {"m=0.40000000000000008rad", "a=4 m=0.20000000000000004rad"})
    CHECK(refused_at(greater));
  for(const char* const most : {"m=0.4rad", "a=4 m=0.2rad"})
    CHECK(!refused_at(most));
}

/*!
The bounds and the rates are looked at in the pan's equation itself, integrated in fifty digits over half a
period of the beam. Of the two motions, one even and one odd about the moment of the beam's turning, one ends
at zero or level where the beam's frequency is a bound; and the mean of both gives the rate.
*/

struct Half  // of a period of the beam, after which:
{
  Fifty even, even_rate, odd, odd_rate;
};

Half half_period(const Fifty& mu, const Fifty& lambda, const Fifty& p)
{
  const exact::RightSide right = [&](const Fifty& t, const exact::State& y) {
    const Fifty pull = p * lambda * lambda * cos(lambda * t) - mu * mu;
    return exact::State{y[1], pull * y[0], y[3], pull * y[2]};
  };
  const auto y = exact::solve(right, 0, {1, 0, 0, mu}, exact::pi() / lambda, Fifty("1e-18")).y;
  return {y[0], y[1] / mu, y[2], y[3] / mu};
}

CHECK_THAT(
    "at the bounds of the intervals a motion of the pan comes back after one or two periods of the beam")
{
  for(const Told& now : told_at("", "b=20 a=9 m=10", "b=700 a=40 m=2"))
  {
    const Fifty mu = sqrt(2 * g.fifty() / b.fifty()), p = a.fifty() * m.fifty() / b.fifty();
    const auto rows = now.rows("intervals");
    REQUIRE(rows.size() == 2);
    for(std::size_t k{0}; k < 2; ++k)
    {
      const long long j = static_cast<long long>(k) + 1;
      const auto& row = rows[k];
      CHECK(row.value("order") == j);
      CHECK(row.value("middle", Unit{"1/s"}) == within_relative(2 * mu / j, 2e-15, "a root"));
      // which of the four vanishes there, and by how much it is off a little further on
      const auto bound = [&](const char* which, const auto& of) {
        const Fifty at = row.at(which, Unit{"1/s"}), next = at * (1 + Fifty("1e-8"));
        const Fifty here = of(half_period(mu, at, p)), there = of(half_period(mu, next, p));
        return Fifty(at - here * (next - at) / (there - here));
      };
      const auto even = [j](const Half& y) { return j == 1 ? y.even : y.even_rate; };
      const auto odd = [j](const Half& y) { return j == 1 ? y.odd_rate : y.odd; };
      const Fifty one = bound("from", even), other = bound("from", odd);
      const bool is_even =
          abs(one - row.at("from", Unit{"1/s"})) < abs(other - row.at("from", Unit{"1/s"}));
      const char* const because = "the library's bound, and a secant";
      CHECK(row.value("from", Unit{"1/s"}) == within_relative(is_even ? one : other, 1e-11, because));
      CHECK(row.value("to", Unit{"1/s"})
            == within_relative(is_even ? bound("to", odd) : bound("to", even), 1e-11, because));
      const Half y = half_period(mu, 2 * mu / j, p);
      const Fifty trace =
          abs(y.even * y.odd_rate + y.even_rate * y.odd);  // half the trace of a whole period
      const Fifty rate = log(trace + sqrt(trace * trace - 1)) * mu / (j * exact::pi());
      CHECK(row.value("growth", Unit{"1/s"})
            == within_relative(rate, 1e-6, "a small root of a difference"));
      if(j == 1)
        CHECK(row.value("growth", Unit{"1/s"})
              == within_relative(p * mu, 2 * double(p * p) + 1e-6, "the leading term"));
    }
  }
}

CHECK_THAT("in the figure swings grow inside the wedges and not outside, by the exponents")
{
  for(const Told& now : told_at("", "b=6 a=3 k=0.7", "L=30 c=1 b=3 m=2"))
  {
    int j = 0;
    for(const char* wedge : {"first", "second", "third"})
    {
      ++j;
      const auto points = now.points(wedge);
      for(const std::size_t k : {std::size_t{0}, std::size_t{30}, std::size_t{55}, std::size_t{80}})
      {
        const double p = points[k].at("p"), from = points[k].at("from"), to = points[k].at("to");
        if(k == 0)
        {
          CHECK(points[k].value("from") == within_ulps(Fifty(2) / j, 1, "the tip"));
          CHECK(points[k].value("to") == within_ulps(Fifty(2) / j, 1, "the tip"));
          continue;
        }
        const double part = (to - from) / 50;
        CHECK(floquet({1, from + part, p}).growth > 0);
        CHECK(floquet({1, to - part, p}).growth > 0);
        CHECK(floquet({1, from - part, p}).growth == 0);
        CHECK(floquet({1, to + part, p}).growth == 0);
        const Interval known = unstable(1, p, j);
        CHECK(points[k].value("from")
              == between(known.from, known.from + part, "by the exponents on both sides"));
        CHECK(points[k].value("to") == between(known.to - part, known.to, "the same"));
      }
    }
    for(const auto& point : now.points("balances", 5))
    {
      const Fifty C = point.at("c"),
                  inner = kk_exactly() + 2 * L.fifty() * a.fifty() * a.fifty() / M.fifty();
      CHECK(point.value("ratio")
            == within_relative(sqrt(b.fifty() / (C + inner / C)), 3e-15, "a dozen roundings"));
      CHECK(point.value("p") == within_relative(a.fifty() * m.fifty() / b.fifty(), 1e-15, "two roundings"));
    }
  }
}

/*!
## Go on from here

::: exercise
A rod with $kk = \frac13aa$ carries pans without weight. Can its beam be as quick as a pan on strings of the
length $a$?
answer: Barely not: the least $f$ is $2a:\sqrt3 = 1.1547\,a$, so that λ is at the most {{rod|4}} of μ.
:::
*/

TELL
{
  tell("rod", std::sqrt(1 / least_f({1, 1, 1, 1. / 3, 0, 1, 1}).f),
       "λ/μ for a rod with b = a and light pans");
}

CHECK_THAT("the rod's beam stays a little slower than its pans")
{
  for(const Told& now : told_at(""))
    CHECK(now.value("rod") == within_ulps(sqrt(sqrt(Fifty(3)) / 2), 2, "some roundings"));
}
