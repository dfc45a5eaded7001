#include <utility>

#include "edition/section.hpp"
#include "exact/series.hpp"
#include "pendulum/series.hpp"
#include "pendulum/tail.hpp"
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
   + \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}c^6 + \text{etc.}\right), \tag{1} $$

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
   + \text{etc.}\right), \tag{2} $$

the same series, with the square of the tangent of the quarter angle in the place of the sine of the half.
At {{zeta}} that takes $c = {{c}}$ down to $q = {{q}}$; and it can be done again and again. Done to the end
it is the arithmetic-geometric mean.
*/

template <class Real>
Real landen(Real s)  // q
{
  return (1 - s) / (1 + s);
}

double series_after_landen(double s, int terms)  // (2)
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
  tell("q", landen(s), "and that of (2)");
  tell("T_over_Theta", swing::ratio({swing_.zeta, swing_.eta}),
       "one swing, the infinitely small one being 1");
  tell("steps", steps_of_the_mean(swing_.eta, part), "steps of the mean that are needed");
  if(swing_.eta < 0.5_deg)
    return;  // counting would take too long
  tell("ten_closed", series(1 - s * s, 10) + tail_bound(c, s, 10),
       "ten terms of (1), and B of §8 for the rest");
  tell("needed", terms_needed(1 - Fifty(s) * s, part), "terms of (1) that are needed");
  tell("needed_landen", terms_needed(pow(landen(Fifty(s)), 2), part), "the same of (2)");
}

/*!
The counts for all amplitudes; then the ways side by side. Among these is {{eq 1}} with its tail closed by
the bound $B$ of {{sec pendulum.08}}, an arc and a logarithm.
*/

TELL
{
  curve("needed", {"eta", "series", "landen", "mean"}, [](Curve& c) {
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
  const double eta = swing_.eta, c = std::cos(eta / 2), s = std::sin(eta / 2), cc = 1 - s * s;
  std::vector<Method> ways;
  for(const int n : {100, 1000, 4000, 16000})
    ways.push_back({std::to_string(n) + " terms", [=] { return series(cc, n); }, "series (1)"});
  for(const int n : {10, 100, 1000})
    ways.push_back({std::to_string(n) + " terms and B", [=] { return series(cc, n) + tail_bound(c, s, n); },
                    "series (1) closed"});
  for(const int n : {5, 46, 107, 170})
    ways.push_back({"Landen, " + std::to_string(n) + " terms", [=] { return series_after_landen(s, n); },
                    "series (2)"});
  ways.push_back({"mean", [=] { return ratio_by_mean(eta); }});
  ways.push_back({"this edition", [=] { return swing::ratio_from_top(eta); }});
  race("near_the_top", "T/Θ", ratio_by_mean(Fifty(eta)), ways);
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
needs four times as many terms, Landen's {{eq 2}} twice as many; the mean hardly notices.
:::

## Checks

The transformation is exact: with $q$ for the variable, $cc = 1 - ss = \frac{4q}{(1+q)^2}$, and {{eq 2}} is
an identity between power series.
*/

CHECK_THAT("the series in c, with 4q/(1+q)² for cc, is (1+q) times the series in q")
{
  using Formal = exact::Series<Rational>;
  std::vector<Rational> squares;
  for(int n = 0; n <= 24; ++n)
    squares.push_back(pow(exact::double_factorial_ratio(n), 2));
  const Formal F(squares, 24), q = Formal::x(24), one = Formal(1).truncated(24);
  CHECK(compose(F, Formal(4) * q / pow(one + q, 2)) == (one + q) * compose(F, q * q));
}

CHECK_THAT("the series after one step gives the time")
{
  for(const double eta : {5_deg, 30_deg, 90_deg, 170_deg})
    CHECK(series_after_landen(std::sin(eta / 2), 400)
          == within_ulps(ratio_by_mean(Fifty(eta)), 8,
                         "s, and the many small terms near the top, are rounded"));
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
In the scan {{eq 1}} has lost all its squares, and the coefficient of $c^4$ its 3 besides.
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
