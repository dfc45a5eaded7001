#include "balance/euler.hpp"
#include "balance/instrument.hpp"
#include "edition/section.hpp"

SECTION(balance, 34, "How irregular the pans are, and on what it depends")

using namespace balance;

/*!
## What Euler does

The letters $m$, $n$ and $n'$ stand for the greatest excursions of beam and pans. For the beam, he says, this
is true in all rigour. With the pans it may happen, because of the last members of the formulae of
{{sec balance.33}}, that the greatest excursion is somewhat more or somewhat less than $n$ and $n'$. This
irregularity will be the greater the greater the beam's motion, that is, the angle $m$ {{entry beams_angle}};
and mostly it will depend on the number

$$ i = \frac{\lambda\mu\mu a}{4g}, \tag{1} $$

which will be the greater the longer the beam, of which $a$ is the half. So in smaller balances it is less to
be noticed.

For the beam the statement is true of $\omega = m\cos\lambda t$. Of the balance it is not: two pans that do
not swing alike tug at their beam ({{sec balance.13}}), and it swings farther than it was drawn aside.

::: margin
Today: similarity. Of the four numbers on which the motion depends, none is a length.
:::

And the length of the beam is not what counts. In {{eq 1}} a longer beam also makes λ smaller, because more
mass lies farther out. As $2g = \mu\mu b$ and $\lambda\lambda = 2gMc:(M(kk+cc)+2Laa)$, it is

$$ i = \frac{\lambda a}{2b} = \frac1{2b}\sqrt{\frac{2gc}{\dfrac{kk+cc}{aa}+\dfrac{2L}M}}, \tag{A} $$

and if beams of different length are alike, so that $k:a$ is the same for all, $i$ tends to a limit; it has
nearly reached it when $a$ is several times $c$. What makes the pans irregular is a short string and a beam
whose centre of gravity lies deep.

## The program
*/

const auto a = real("a", 2, feet, closed(1e-6, 1e6), "half the beam");
const auto b = real("b", 2, feet, closed(1e-3, 1e3), "length of the strings");
const auto c = real("c", 0.1, feet, closed(1e-6, 1e3), "depth of the beam's centre of gravity");
const auto shape = real("shape", 0.5, none, closed(0.01, 10), "k/a, radius of gyration to half the beam");
const auto L = real("L", 1, none, closed(1e-6, 1e6), "weight of each pan");
const auto M = real("M", 2, none, closed(1e-6, 1e6), "weight of the beam");
const auto g = real("g", 16, feet, closed(0.1, 100), "height fallen in the first second");

double i_with(double arm)
{
  return quantities_of({arm, b, c, shape * arm * (shape * arm), L, M, g}).i;
}

double limit()  // of (A) for long beams
{
  return std::sqrt(2 * g * c / (shape * shape + 2 * L / M)) / (2 * b);
}

TELL
{
  tell("i", i_with(a), Unit{"1/s"}, "the number i, (1)");
  tell("longer", i_with(2 * a), Unit{"1/s"}, "the same for a beam twice as long");
  tell("limit", limit(), Unit{"1/s"}, "for the longest");
  auto& rows = table("arms", "Half the beam, and i", {{"a", "a", feet}, {"i", "i", Unit{"1/s"}}});
  for(const double arm : {0.25, 0.5, 1., 2., 4., 8.})
    rows.row({arm, i_with(arm)});
  curve("by_arm", {"a", "i"}, [](Curve& out) {
    for(int j = -80; j <= 40; ++j)
    {
      const double arm = std::pow(10, j / 40.);
      out.put({arm, i_with(arm)});
    }
  });
}

/*!
For the excursions the example of {{sec balance.35}} is taken, in full and by Euler's formulae, but so that Q
hangs at rest at first.
*/

constexpr Release with_Q_at_rest{1, 3, 0.25, {1. / 6, 1. / 6, 0}, 0.25};

double beams_most()  // in full, in sixty seconds
{
  double most = 0;
  for(const State<>& now : course(balance_of(with_Q_at_rest), {with_Q_at_rest.at, {}}, 60, 6000))
    most = std::max(most, std::abs(now.at.omega));
  return most;
}

TELL
{
  tell("beam", beams_most() * 6, "the beam's greatest excursion in full, in parts of m", 4);
  tell("P_by_him", euler_start(with_Q_at_rest).eta * 6, "that of P by the formula, in parts of n");
}

/*!
In the example, with Q at rest at the start, the beam swings in the first minute out to {{beam|4}} of the
angle from which it was let go. P's greatest excursion by the formula is {{P_by_him|5}} of $n$, right at the
start.

With $a$ = {{a}} ft and strings of {{b}} ft, $i$ is {{i|5}}; with a beam twice as long {{longer|5}}. The
longest would have {{limit|5}}.

{{table arms}}

::: figure balance-34
alt: The number i against half the length of the beam, on a logarithmic axis from a hundredth of a foot to ten
feet. It rises from zero, bends where a is some times c, and runs level along a thin line.

The number $i$ for beams of one shape and of different length, all else being equal; the thin line is the
limit. That it grows with $a$ is true of the shortest only.
:::

## Checks
*/

Fifty by_A(const Fifty& arm)
{
  const Fifty k = shape.fifty() * arm, C = c.fifty();
  return sqrt(2 * g.fifty() * C / ((k * k + C * C) / (arm * arm) + 2 * L.fifty() / M.fifty()))
         / (2 * b.fifty());
}

CHECK_THAT("i is (A), tends to the limit told and never exceeds it")
{
  for(const Told& now : told_at("", "a=1e-5 c=0.3 L=0.2 M=50 b=0.01", "a=7e5 shape=3 c=1e-5 L=4e5 g=31",
                                "a=0.1 c=900 M=1e-5"))
  {
    CHECK(now.value("i", Unit{"1/s"}) == within_relative(by_A(a.fifty()), 2e-15, "the library's, and kk"));
    CHECK(now.value("longer", Unit{"1/s"}) == within_relative(by_A(2 * a.fifty()), 2e-15, "the same"));
    const Fifty far = by_A(Fifty("1e30") * c.fifty());
    CHECK(now.value("limit", Unit{"1/s"}) == within_relative(far, 2e-15, "some roundings"));
    for(const auto& row : now.rows("arms"))
    {
      CHECK(row.value("i", Unit{"1/s"}) == within_relative(by_A(row.at("a", feet)), 2e-15, "the same"));
      CHECK(by_A(row.at("a", feet)) < far);
    }
    for(const auto& point : now.points("by_arm", 5))
      CHECK(point.value("i") == within_relative(by_A(point.at("a")), 2e-15, "the same"));
  }
}

CHECK_THAT("the beam goes farther than m, by GSL too; the formula's own P begins farthest out")
{
  for(const Told& now : told_at(""))
  {
    double most = 0;
    for(int j = 0; j <= 1200; ++j)
      most = std::max(most, std::abs(by_gsl(balance_of(with_Q_at_rest), {with_Q_at_rest.at, {}},
                                            std::max(j / 20., 1e-9), 1e-9)
                                         .at.omega));
    CHECK(now.value("beam") == within_relative(6 * most, 2e-3, "looked at every twentieth of a second"));
    CHECK(most > 1. / 6 * 1.05);
    CHECK(now.value("P_by_him") == within_relative(1 + Fifty(1) / 420, 1e-15, "1 + K"));
    for(int j = 1; j <= 628; ++j)
      CHECK(std::abs(euler(with_Q_at_rest, j / 100.).eta) <= euler_start(with_Q_at_rest).eta);
  }
}

const Emendation beams_angle{"§34, the angle of the beam's motion",
                             {"n", 0},
                             {"m", 1},
                             "what is added to a pan's swing, over that swing, does not grow with n",
                             [](double m_is_what_counts) {
                               Release twice_m = example_of_35, twice_n = example_of_35;
                               twice_m.at.omega *= 2;
                               twice_n.at.eta *= 2;
                               const auto share = [](const Release& r) {
                                 return euler_start(r).eta / r.at.eta - 1;
                               };
                               const bool by_m = share(twice_m) > 1.9 * share(example_of_35);
                               const bool by_n = share(twice_n) > 1.9 * share(example_of_35);
                               return m_is_what_counts == (by_m && !by_n ? 1 : by_n ? 0 : -1);
                             }};

/*!
## Go on from here

::: exercise
At what depth of its centre of gravity does a beam make its pans the most irregular?
answer: Where it is the quickest, since $i = a\lambda:2b$ and only λ contains $c$: at
$c = \sqrt{kk+2Laa:M}$ ({{sec balance.14}}). In the balance given that is $\sqrt5$ ft, and $i$ would be 1.34.
:::
*/

CHECK_THAT("i is the greatest at the c of the quickest beam, where it is 1.34 in the balance given")
{
  double most = 0;
  for(const Told& now : told_at("c=2.2360679774997898", "c=2.2", "c=2.27", "c=1", "c=5"))
  {
    const Unit unit{"1/s"};
    if(most == 0)
    {
      const Fifty root = sqrt(Fifty(5));  // λλ is 2g : 2c there
      CHECK(now.value("i", unit) == within_relative(sqrt(16 / root) / 2, 2e-15, "the library's"));
      CHECK(now.value("i", unit) == printed("1.34"));
      most = i_with(a);
    }
    else
      CHECK(i_with(a) < most);
  }
}
