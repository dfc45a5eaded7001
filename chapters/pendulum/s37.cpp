#include "edition/section.hpp"
#include "pendulum/columns.hpp"
#include "pendulum/three_members.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 37, "How far each of his two methods reaches")

using namespace pendulum;

/*!
## What Euler does

The nearer the swing comes to the whole circle, the longer it lasts and the less work it is to compute; for
smaller swings, where the work grows, Euler goes back to the series of the dissertation. When $\alpha$ is so
great that the terms with $\sin^6\alpha$ {{entry power}} can no longer be neglected, the new method cannot
even give the time exactly. For the sums of the fourth and later columns would demand all too intricate
calculations, and no device of analysis has been found that would lighten the labour.

In such cases, he says, the series of {{sec pendulum.09}} does the business much more easily. For then $\zeta
= 180° - \eta$ is such that $c = \sin\tfrac12\zeta = \cos\tfrac12\eta$ falls notably short of 1. So the series

$$ 1 + \frac{1^2}{2^2}cc + \frac{1^2\cdot3^2}{2^2\cdot4^2}c^4
   + \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}c^6
   + \text{etc.} \tag{1} $$

converges fast enough for its sum to be had, exactly enough, by adding up several terms; and this multiplied
by Θ gives the time of one swing.

::: margin
Today: the one is an expansion of $K(k)$ about $k = 1$, the other about $k = 0$.
:::

So it does, and it contradicts the members of {{eq pendulum.29 2}}, which are likewise to be multiplied by Θ.
One arc worked out in both ways would have brought the forgotten $2/\pi$ to light.

Do the two methods meet? Both ends can be measured: up to which η the three members serve, and how many terms
of {{eq 1}} it takes from there on.

## The program

As in the examples, five decimals of $K$ are wanted. The logarithmic column and the first few of the others
leave something out, and so does his series. In both cases it grows steadily, with η or with ζ.
*/

double left_out(double eta, int columns)  // of K, by the logarithmic column and so many of the others
{
  return swing::quarter_time_from_top(eta) - sum_by_columns(eta / 2, columns);
}

double left_out_by_series(double eta, int terms)  // (1)
{
  return swing::quarter_time_from_top(eta)
         - std::numbers::pi / 2 * series(std::pow(std::cos(eta / 2), 2), terms);
}

/*!
The three members serve while they leave out less than half a unit of the fifth decimal. With two columns
beside the logarithmic one the bisection finds their limit, with three what the fourth column would have
added.
*/

double reach(int columns)
{
  double low = 1_deg, high = 80_deg;
  while(high - low > 1e-12)
    (left_out((low + high) / 2, columns) < 0.5e-5 ? low : high) = (low + high) / 2;
  return low;
}

int terms_needed(double eta)
{
  int terms = 1, too_few = 0;
  for(; left_out_by_series(eta, terms) > 0.5e-5; terms *= 2)
    too_few = terms;
  while(terms - too_few > 1)
    (left_out_by_series(eta, (terms + too_few) / 2) > 0.5e-5 ? too_few : terms) = (terms + too_few) / 2;
  return terms;
}

const auto swing_ = amplitude_from_top(30_deg, closed(1_deg, 179.5_deg));

TELL
{
  tell("three_reach", reach(2), degrees, "η up to which the three members give K to five decimals", 9);
  tell("four_reach", reach(3), degrees, "the same with the fourth column", 9);
  tell("terms_there", terms_needed(reach(2)),
       "terms of (1) for five decimals where the three members give up");
  tell("terms_120", terms_needed(60_deg), "the same at ζ = 120°");
  tell("terms", terms_needed(swing_.eta), "the same at the given ζ");
  const Fifty alpha = swing_.eta.fifty() / 2;
  tell("left_out", double(ratio_by_mean(2 * alpha) * exact::pi() / 2 - sum_by_columns(alpha, 2)),
       "what the three members leave out of K there");
}

TELL
{
  curve("methods", {"eta", "three", "four", "s10", "s100", "s1000"}, [](Curve& c) {
    for(double eta = 1; eta < 150; eta *= 1.03)
      c.put({eta, left_out(eta * 1_deg, 2), left_out(eta * 1_deg, 3), left_out_by_series(eta * 1_deg, 10),
             left_out_by_series(eta * 1_deg, 100), left_out_by_series(eta * 1_deg, 1000)});
  });
}

/*!
The three members serve up to {{three_reach|f2}}; with the fourth column they would have served to
{{four_reach|f1}}. Where they give up, the series that is to take their place needs {{terms_there}} terms. At
an amplitude of {{zeta}} it still needs {{terms}}, at 120° {{terms_120}}. So there is a wide range in which
neither of his methods is fit for work by hand. The columns that he did without would have closed the gap
({{sec pendulum.38}}).

::: figure pendulum-37
alt: What each method leaves out of K against eta, both logarithmic. The line of the three members rises with
eta and crosses the level of five decimals near 7 degrees, that with the fourth column near 18 degrees. The
lines of Euler's series fall: with 1000 terms it crosses the level near 11 degrees, with 100 near 35, with 10
near 104.

What is left out of $K$. The grey line is half a unit of the fifth decimal. The members serve to the left of
where they cross it, the series to the right of where it does.
:::

## Checks
*/

CHECK_THAT(
    "at the limit found, the three members leave out half a unit of the fifth decimal, by fifty digits")
{
  const Fifty eta = reach(2);
  CHECK(ratio_by_mean(eta) * exact::pi() / 2 - three_members(eta / 2, 200).sum()
        == within(0.5e-5, 4e-15, "the sum of the columns errs by 4 ulp"));
}

CHECK_THAT("one term fewer of his series than the number found is not enough, by fifty digits")
{
  for(const double eta : {reach(2), 30_deg, 60_deg})
  {
    const Fifty cc = pow(cos(Fifty(eta) / 2), 2), unit = Fifty(1e-5) / exact::pi();
    CHECK(ratio_by_mean(Fifty(eta)) - series(cc, terms_needed(eta)) < unit);
    CHECK(ratio_by_mean(Fifty(eta)) - series(cc, terms_needed(eta) - 1) > unit);
  }
}

/*!
In the end the two expansions do meet. The swing of 150° can be had by both, and it must come to $\sqrt3$
times the swing of 30°.
*/

CHECK_THAT("his series and all the columns give the same swing of 150°, √3 times that of 30°")
{
  const Fifty small = series(pow(sin(exact::pi() / 12), 2), 90);
  const Fifty by_series = series(pow(cos(exact::pi() / 12), 2), 1600);
  const Fifty by_columns = 2 / exact::pi() * sum_by_columns(exact::pi() / 12, 45);
  CHECK(by_series == within_relative(sqrt(Fifty(3)) * small, 1e-45, "cc¹⁶⁰⁰ is below 10⁻⁴⁸"));
  CHECK(by_columns == within_relative(sqrt(Fifty(3)) * small, 1e-45, "sin⁹⁰α is below 10⁻⁵²"));
}

/*!
The section has lost its head with the end of {{sec pendulum.36}}, and one reading must stay open. The copy
lets the method fail when the terms with $\sin^6\alpha$ count. Since it is the fourth column that is missing,
one would expect $\sin^4\alpha$; but what is said is true of either.
*/

const Undecided power{
    "§37, the terms that cannot be neglected",
    {"sin⁶α", 6},
    {"sin⁴α", 4},
    "where the column with either comes to a unit of the fifth decimal, the three members fail",
    [](double exponent) {
      if(exponent < 2)
        return false;  // no column has it
      const double S = column_sums<double>(8)[std::size_t(exponent) / 2];
      return 2 * std::asin(std::pow(1e-5 / S, 1 / exponent)) > reach(2);
    }};

/*!
What is told is judged by the oracle's time: just below each limit that is told less than half a unit is left
out, and just above it more; of terms, one fewer is too few.
*/

Fifty beyond_columns(const Fifty& eta, int columns)
{
  const Fifty K = swing::oracle::K_from_complement(sin(eta / 2));
  return K - sum_by_columns(eta / 2, columns);
}

Fifty beyond_terms(const Fifty& eta, int terms)
{
  const Fifty K = swing::oracle::K_from_complement(sin(eta / 2));
  return K - exact::pi() / 2 * series(pow(cos(eta / 2), 2), terms);
}

CHECK_THAT(
    "the limits and the numbers of terms told are those at which half a unit of five decimals is left out")
{
  const Fifty half_unit("0.5e-5");
  for(const Told& now : told_at("", "eta=1", "eta=120"))
  {
    const auto limit = [&](int columns) {
      Fifty low = Fifty(0.01), high = Fifty(1.2);
      for(int i = 0; i < 60; ++i)
        (beyond_columns((low + high) / 2, columns) < half_unit ? low : high) = (low + high) / 2;
      return low;
    };
    CHECK(now.value("three_reach", degrees) == within(limit(2), 1e-10, "where K's ulps hide the limit"));
    CHECK(now.value("four_reach", degrees) == within(limit(3), 1e-10, "where K's ulps hide the limit"));
    const auto fewest = [&](const Fifty& eta, int told) {
      return beyond_terms(eta, told) <= half_unit && beyond_terms(eta, told - 1) > half_unit;
    };
    CHECK(fewest(swing_.eta.fifty(), terms_needed(swing_.eta)));
    CHECK(now.value("terms") == terms_needed(swing_.eta));
    CHECK(fewest(exact::pi() / 3, terms_needed(60_deg)));
    CHECK(now.value("terms_120") == terms_needed(60_deg));
    CHECK(fewest(limit(2), terms_needed(reach(2))));
    CHECK(now.value("terms_there") == terms_needed(reach(2)));
    CHECK(now.value("left_out")
          == within_relative(beyond_columns(swing_.eta.fifty(), 2), 2e-16, "fifty digits, rounded"));
  }
}

CHECK_THAT("the figure has what each method leaves out")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("methods", 5))
    {
      const Fifty eta = Fifty(point.at("eta")) * exact::pi() / 180;
      const char* const why = "differences of rounded numbers of the size of K";
      CHECK(point.value("three") == within(beyond_columns(eta, 2), 6e-15, why));
      CHECK(point.value("four") == within(beyond_columns(eta, 3), 6e-15, why));
      CHECK(point.value("s10") == within(beyond_terms(eta, 10), 1e-14, why));
      CHECK(point.value("s100") == within(beyond_terms(eta, 100), 4e-14, why));
      CHECK(point.value("s1000") == within(beyond_terms(eta, 1000), 2e-13, why));
    }
}

/*!
## Go on from here

::: exercise
Ten terms are perhaps what one would add by hand. Up to which amplitude do they give $K$ to five decimals?

answer: To 76.38°, not quite the semicircle of {{sec pendulum.11}}: `--zeta 76.38` tells 10 terms, and
`--zeta 76.39` tells 11. From there to the {{three_reach|deg0}} from the top where the members serve neither
method is short.
:::
*/

CHECK_THAT("ten terms serve to 76.38°, and no farther than 76.39°")
{
  for(const Told& now : told_at("zeta=76.38", "zeta=76.39"))
    CHECK(now.value("terms") == (swing_.zeta < 76.385_deg ? 10 : 11));
}
