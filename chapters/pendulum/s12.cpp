#include <utility>

#include "edition/section.hpp"
#include "exact/series.hpp"
#include "pendulum/scene.hpp"
#include "pendulum/scene_judge.hpp"
#include "pendulum/series.hpp"
#include "pendulum/tail.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 12, "How long, when the swing nearly reaches the top?")

using pendulum::ratio_by_mean, pendulum::series, pendulum::tail_bound;

/*!
## What Euler does

A supplement to the dissertation opens with a question about the widest swings of all: how long do they
last? Near its end, in {{sec pendulum.11}}, the dissertation had shown that the time of a swing grows to
infinity as $\zeta$ grows to 180°. He is now curious how great it is when $\zeta$ is very nearly 180°, so
that $c = \sin\tfrac12\zeta$ falls short of one by next to nothing. The series that was found,

$$ T = \frac{\pi\sqrt b}{\sqrt{2g}}\left(1 + \frac{1^2}{2^2}c^2 + \frac{1^2\cdot3^2}{2^2\cdot4^2}c^4
   + \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}c^6 + \text{etc.}\right){{entry squares}}, \tag{1} $$

does have a finite sum; but its terms decrease too slowly for one to find the sum from them, even roughly.
Nor does he see a way to transform the series into another whose sum could be had exactly enough.

## The program

How many terms does it take? The program takes them away, in fifty digits, from the whole, which it knows
from the mean of {{sec pendulum.11}}, until no more is left than a given part.
*/

int terms_needed(const Fifty& cc, double part)  // of (1)
{
  const Fifty whole = ratio_by_mean(2 * acos(sqrt(cc)));
  Fifty left = whole, term = 1;
  int n = 0;
  for(; left > part * whole; ++n)
  {
    left -= term;
    term *= cc * pow(Fifty(2 * n + 1) / Fifty(2 * n + 2), 2);
  }
  return n;
}

/*!
Yet there is a way to transform the series, and a short one. With $s = \cos\tfrac12\zeta$ and $q =
\tan^2\tfrac14\zeta = \frac{1-s}{1+s}$ the sum is also

::: margin
Landen's transformation, $K(c) = (1+q)K(q)$.
:::

$$ \frac T\Theta = (1+q)\left(1 + \frac{1^2}{2^2}q^2 + \frac{1^2\cdot3^2}{2^2\cdot4^2}q^4
   + \text{etc.}\right), \tag{A} $$

the same series, with the square of the tangent of the quarter angle in the place of the sine of the half.
At {{zeta}} that takes $c = {{c}}$ down to $q = {{q}}$; and it can be done again and again. Done to the end
it is the arithmetic-geometric mean.
*/

template <class Real>
Real landen(Real s)  // q
{
  return (1 - s) / (1 + s);
}

double series_after_landen(double s, int terms)  // (A)
{
  const double q = landen(s);
  return (1 + q) * series(q * q, terms);
}

int steps_of_the_mean(double eta, double part)
{
  const double mean = 1 / ratio_by_mean(eta);
  double a = 1, m = std::sin(eta / 2);
  int step = 0;
  for(; a - mean > part * mean; ++step)
    m = std::sqrt(std::exchange(a, (a + m) / 2) * m);
  return step;
}

/*!
The amplitude is best given by what it lacks of 180°; the other choice is the accuracy wanted.
*/

const auto swing_ = amplitude_from_top(5_deg);
const auto part = real("part", 1e-5, none, closed(1e-15, 0.1), "part of the whole that may be left out");

TELL
{
  const double s = std::sin(swing_.eta / 2), c = std::cos(swing_.eta / 2);
  tell("c", c, "the quantity in whose powers (1) proceeds");
  tell("q", landen(s), "and that of (A)");
  tell("T_over_Theta", swing::ratio({swing_.zeta, swing_.eta}),
       "one swing, the infinitely small one being 1");
  tell("steps", steps_of_the_mean(swing_.eta, part), "steps of the mean that are needed");
  if(swing_.eta < 0.5_deg)
    return;  // counting would take too long
  tell("ten_closed", series(1 - s * s, 10) + tail_bound(c, s, 10),
       "ten terms of (1), and B of §8 for the rest");
  tell("needed", terms_needed(pow(cos(swing_.eta.fifty() / 2), 2), part), "terms of (1) that are needed");
  tell("needed_landen", terms_needed(pow(landen(sin(swing_.eta.fifty() / 2)), 2), part), "the same of (A)");
}

/*!
The counts for all amplitudes:
*/

TELL
{
  curve("counts", {"eta", "series", "landen", "mean"}, [](Curve& c) {
    for(double eta = 180_deg; eta > 1_deg; eta /= 1.08)
    {
      const Fifty s = sin(Fifty(eta) / 2);
      c.put({eta / 1_deg, 1.0 * terms_needed(1 - s * s, 1e-5), 1.0 * terms_needed(pow(landen(s), 2), 1e-5),
             1.0 * steps_of_the_mean(eta, 1e-5)});
    }
  });
}

TELL
{
  pendulum::scene_of_swing("swing", {swing_.zeta, swing_.eta}, 1 / std::numbers::pi);  // Θ is a second
}

/*!
At 175° it takes {{needed}} terms of his series to have the time to the hundred-thousandth part, after one
transformation {{needed_landen}}, and by the mean {{steps}} steps. So at 5° from the top the answer to his
question is $T$ = {{T_over_Theta|8}} Θ. Even ten terms of {{eq 1}} come near it, once they are closed by
$B$: {{ten_closed|6}} Θ.

::: figure pendulum-12
alt: Terms needed against the angle from the top, both logarithmic. Euler's series rises to nearly 100 000
terms at 1 degree, the series after one step to 200; the mean needs four steps.

What it takes to have $T$ to the hundred-thousandth part. Half as far from the top, Euler's series {{eq 1}}
needs four times as many terms, Landen's {{eq A}} twice as many; the mean hardly notices.
:::

::: scene swing
alt: A pendulum hangs from its axis, drawn aside by the amplitude; a grey arc marks the way of its bob.

How long it lasts, to be seen: a pendulum whose smallest swings take a second.
:::

## Speed against error

Among the ways is {{eq 1}} with its tail closed by the bound $B$ of {{sec pendulum.08}}, an arc and a
logarithm.
*/

TELL
{
  const double eta = swing_.eta, c = std::cos(eta / 2), s = std::sin(eta / 2), cc = 1 - s * s;
  std::vector<Method> ways;
  for(const int n : {100, 1000, 4000, 16000})
    ways.push_back({std::to_string(n) + " terms", [=] { return series(cc, n); }, "series (1)"});
  for(const int n : {10, 100, 1000})
    ways.push_back({std::to_string(n) + " terms and B", [=] { return series(cc, n) + tail_bound(c, s, n); },
                    "series (1) closed"});
  for(const int n : {5, 46, 107, 170})
    ways.push_back({"Landen, " + std::to_string(n) + " terms", [=] { return series_after_landen(s, n); },
                    "series (A)"});
  ways.push_back({"mean", [=] { return ratio_by_mean(eta); }});
  ways.push_back({"this edition", [=] { return swing::ratio_from_top(eta); }});
  race("near_the_top", "T/Θ", ratio_by_mean(swing_.eta.fifty()), ways);
}

/*!
## Checks

The transformation is exact: with $q$ for the variable, $cc = 1 - ss = \frac{4q}{(1+q)^2}$, and {{eq A}} is
an identity between power series.
*/

CHECK_THAT("the series in c, with 4q/(1+q)² for cc, is (1+q) times the series in q")
{
  using Formal = exact::Series<Rational>;
  std::vector<Rational> squares;
  for(int n = 0; n <= 24; ++n)
    squares.push_back(pow(exact::double_factorial_ratio(n), 2));
  const Formal F(squares, 24), q = Formal::x(24), one = Formal(1).truncated(24);
  const Formal in_c = compose(F, Formal(4) * q / pow(one + q, 2)), in_q = (one + q) * compose(F, q * q);
  for(int n = 0; n <= 24; ++n)
    CHECK(in_c[n] == in_q[n]);
}

CHECK_THAT("the series after one step gives the time")
{
  for(const double eta : {5_deg, 30_deg, 90_deg, 170_deg})
    CHECK(series_after_landen(std::sin(eta / 2), 400)
          == within_ulps(ratio_by_mean(Fifty(eta)), 8,
                         "s, and the many small terms near the top, are rounded"));
}

CHECK_THAT("the scene shows the motion itself, in its true time")
{
  for(const Told& now : told_at("", "eta=60", "eta=1e-6"))
  {
    const Fifty unit = 1 / exact::pi();
    const pendulum::Scene_judge judge(swing_.zeta.fifty(), swing_.eta.fifty(), unit);
    for(const auto& frame : now.points("swing", 9))
    {
      const Fifty phi = judge.angle(frame.at("t"));
      CHECK(frame.value("t") == between(0, judge.last(), "one period"));
      CHECK(frame.value("phi") == within(phi, judge.slack(), judge.because));
      CHECK(frame.value("x") == within(sin(phi), judge.slack(), judge.because));
      CHECK(frame.value("y") == within(-cos(phi), judge.slack(), judge.because));
    }
  }
}

CHECK_THAT("the counted terms are enough, and one fewer is not")
{
  for(const double zeta : {60_deg, 90_deg, 175_deg})
    for(const double allowed : {1e-5, 1e-15})
    {
      const Fifty cc = pow(sin(Fifty(zeta) / 2), 2), whole = ratio_by_mean(exact::pi() - zeta);
      const int n = terms_needed(cc, allowed);
      CHECK(series(cc, n) >= whole * (1 - Fifty(allowed)));
      CHECK(series(cc, n - 1) < whole * (1 - Fifty(allowed)));
    }
}

/*!
Near the top the $n$th term is nearly $e^{-nss}/\pi n$, so that it takes the more terms, the smaller $ss$
is. The steps of the mean grow as the logarithm of a logarithm.
*/

CHECK_THAT("near the top (1) needs about seven terms over ss for five figures")
{
  for(const double eta : {10_deg, 5_deg, 2_deg})
  {
    const Fifty ss = pow(sin(Fifty(eta) / 2), 2);
    CHECK(ss * terms_needed(1 - ss, 1e-5) == between(6.9, 7.4, "it falls slowly, as T/Θ grows"));
  }
}

CHECK_THAT("the mean needs thirteen steps at most, even a part in 10³⁰⁰ from the top")
{
  CHECK(steps_of_the_mean(5_deg, 1e-15) == 6);
  CHECK(steps_of_the_mean(1e-50, 1e-15) == 10);
  CHECK(steps_of_the_mean(1e-300, 1e-15) == 13);
}

/*!
In our copy {{eq 1}} has lost all its squares, and the coefficient of $c^4$ its 3 besides.
*/

const Emendation squares{"§12, the series",
                         {"1 + ½c² + 1/(2·4) c⁴ + 1·3·5/(2·4·6) c⁶", 1 + 1. / 8 + 1. / 128 + 15. / 48 / 64},
                         {"1 + 1²/2² c² + 1²3²/2²4² c⁴ + 1²3²5²/2²4²6² c⁶", [] { return series(0.25, 4); }},
                         "at ζ = 60° each term is less than a quarter of the one before, which bounds what "
                         "four of them leave out",
                         [](double reading) {
                           const double fifth = 1225. / 16384 / 256,
                                        short_by = swing::ratio_from_bottom(60_deg) - reading;
                           return short_by == between(fifth, fifth * 4 / 3, "the geometric series of ¼");
                         }};

/*!
What is told at 5° from the top, at a right angle and at half a degree:
*/

CHECK_THAT("the numbers told are the time's, Landen's and the mean's, and one term fewer is not enough")
{
  for(const Told& now : told_at("", "eta=90 part=1e-12", "eta=0.5 part=0.001"))
  {
    const Fifty eta = swing_.eta.fifty(), T = swing::oracle::ratio_from_top(eta),
                q = pow(tan((exact::pi() - eta) / 4), 2);
    CHECK(now.value("c") == within_ulps(cos(eta / 2), 1, "one cosine"));
    CHECK(now.value("q") == within_ulps(q, 3, "a sine and a quotient"));
    CHECK(now.value("T_over_Theta") == within_ulps(T, 1, "the library's bound"));
    const Fifty left = T * part.fifty();
    const auto is_fewest = [&](int n, const Fifty& square, const Fifty& factor) {
      return T - factor * series(square, n) <= left && T - factor * series(square, n - 1) > left;
    };
    const int needed = terms_needed(pow(cos(eta / 2), 2), part), after = terms_needed(q * q, part);
    CHECK(is_fewest(needed, pow(cos(eta / 2), 2), 1));
    CHECK(is_fewest(after, q * q, 1 + q));
    CHECK(now.value("needed") == needed);
    CHECK(now.value("needed_landen") == after);
    const double closed = std::pow(std::cos(swing_.eta / 2), 20) / 300;
    CHECK(now.value("ten_closed") == between(T - Fifty(1e-14), T + closed, "B is a bound, and comes near"));
    Fifty a = 1, m = sin(eta / 2);
    int steps = 0;
    for(; a * T - 1 > part.fifty(); ++steps)
      m = sqrt(std::exchange(a, (a + m) / 2) * m);
    CHECK(now.value("steps") == steps);
  }
}

CHECK_THAT("every way of the race is as near as its own bound says")
{
  for(const Told& now : told_at("", "eta=90 part=1e-12", "eta=0.6 part=0.001"))
  {
    const Fifty eta = swing_.eta.fifty(), T = swing::oracle::ratio_from_top(eta), cc = pow(cos(eta / 2), 2);
    const Fifty q = pow(tan((exact::pi() - eta) / 4), 2);
    CHECK(now.exact("near_the_top") == within_relative(T, 1e-45, "two ways of fifty digits"));
    for(const int n : {100, 1000, 4000, 16000})
      CHECK(now.method("near_the_top", std::to_string(n) + " terms")
            == within_relative(series(cc, n), 3e-13, "cc rounds, and a half ulp a term"));
    for(const int n : {10, 100, 1000})
    {
      const Fifty rest = T - series(cc, n);
      CHECK(now.method("near_the_top", std::to_string(n) + " terms and B")
            == between(T - Fifty(1e-13), T + rest / 10 + Fifty(1e-13),
                       "B is above the rest, by a tenth at most"));
    }
    for(const int n : {5, 46, 107, 170})
      CHECK(now.method("near_the_top", "Landen, " + std::to_string(n) + " terms")
            == within_relative((1 + q) * series(q * q, n), 2e-14, "q rounds, and a half ulp a term"));
    CHECK(now.method("near_the_top", "mean") == within_ulps(T, 4, "its own bound"));
    CHECK(now.method("near_the_top", "this edition")
          == within_ulps(T, 1, "η rounds, and the library's bound"));
  }
}

CHECK_THAT("the figure's counts are the fewest terms and steps")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("counts", 4))
    {
      const Fifty eta = Fifty(point.at("eta")) * exact::pi() / 180, s = sin(eta / 2),
                  T = swing::oracle::ratio_from_top(eta);
      const Fifty q = (1 - s) / (1 + s), left = T * Fifty("1e-5");
      const auto is_fewest = [&](int n, const Fifty& square, const Fifty& factor) {
        return T - factor * series(square, n) <= left
               && (n == 1 || T - factor * series(square, n - 1) > left);
      };
      CHECK(is_fewest(static_cast<int>(point.at("series")), 1 - s * s, 1));
      CHECK(is_fewest(static_cast<int>(point.at("landen")), q * q, 1 + q));
      CHECK(point.value("mean")
            == within(Fifty(steps_of_the_mean(static_cast<double>(eta), 1e-5)), 0, "a count"));
    }
}

/*!
## Go on from here

::: exercise
Foretell from the numbers for 5° how many terms the two series take at 2.5° from the top, and how many
steps the mean.

answer: About four times {{needed}} terms of {{eq 1}}, twice {{needed_landen}} of {{eq A}}, and four steps as
before. The program counts 14898, 89 and 4: a little fewer, because the part that may be left out is one of a
longer time.
:::
*/

CHECK_THAT("half as far from the top the counts are 14898, 89 and 4")
{
  for(const Told& now : told_at(""))
  {
    CHECK(now.value("needed") == 3791);
    CHECK(now.value("needed_landen") == 46);
  }
  for(const Told& now : told_at("eta=2.5"))
  {
    CHECK(now.value("needed") == 14898);
    CHECK(now.value("needed_landen") == 89);
    CHECK(now.value("steps") == 4);
  }
}
