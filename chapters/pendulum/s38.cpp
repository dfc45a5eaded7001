#include "edition/section.hpp"
#include "pendulum/columns.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 38, "An invitation, and what came of it")

using namespace pendulum;

/*!
## What Euler does

Euler closes by saying why he has treated the widest swings, whose arc is all but the whole circle, with such
care: of all who studied the motion of pendulums, none had touched this case. Yet it deserves the greatest
attention, because it cannot be solved without devices of its own, both in the calculation and in the
integrations. And the summation of the fourth and later columns, which he had to pass over here, may give
geometers an occasion to carry this fine part of analysis further.

The invitation can be accepted. All the columns have sums, and {{eq pendulum.28 3}} gives them, each from the
two before it. With them the method of the supplement is complete, and the gap of {{sec pendulum.37}} is
closed.

## The program

With $x = \sin^2\alpha$, what $J$ columns beside the logarithmic one leave out is less than $S_J
x^J/\cos\alpha$ ({{eq pendulum.28 5}}), and none of the sums $S_J$ is greater than the first, $l2$. So the
program knows beforehand how many it needs for all the digits of a double.
*/

int columns_needed(double eta)
{
  const double x = std::pow(std::sin(eta / 2), 2);
  const double enough = 1e-16 * swing::quarter_time_from_top(eta);
  int J = 0;
  for(double left = std::numbers::ln2 / std::cos(eta / 2); left > enough; left *= x)
    ++J;
  return J;
}

double by_columns(double eta)  // T/Θ
{
  return 2 / std::numbers::pi * sum_by_columns(eta / 2, columns_needed(eta));
}

/*!
His own series of {{sec pendulum.09}} leaves out, after $n$ terms, less than the next term over $1 - cc$.
*/

int terms_needed(double zeta)
{
  const double cc = std::pow(std::sin(zeta / 2), 2);
  const double enough = 1e-16 * (1 - cc) * swing::ratio_from_bottom(zeta);
  int n = 0;
  for(double next = 1; next > enough; ++n)
    next *= std::pow((2 * n + 1.0) / (2 * n + 2), 2) * cc;
  return n;
}

/*!
Together they are a rule for every swing: up to a right angle the one, beyond it the other.
*/

double by_both(swing::Amplitude a)  // T/Θ
{
  return a.zeta > a.eta ? by_columns(a.eta) : series(std::pow(a.modulus(), 2), terms_needed(a.zeta));
}

const auto swing_ = amplitude_from_top(1_deg, open(80_deg, 180_deg));

TELL
{
  tell("T_over_Theta", ratio_by_mean(swing_.eta.fifty()), "T/Θ to thirty digits");
  tell("columns_1", columns_needed(1_deg), "columns for all digits of a double, at η = 1°");
  tell("columns_90", columns_needed(90_deg), "the same at 90°");
  tell("terms_1", terms_needed(179_deg), "terms of the series of §9 for the same, at η = 1°");
  tell("terms_90", terms_needed(90_deg), "the same at 90°");
}

TELL
{
  const double eta = swing_.eta;
  race("ratio", "T/Θ", ratio_by_mean(swing_.eta.fifty()),
       {{"all columns", [=] { return by_columns(eta); }},
        {"one column of logarithms",
         [=] { return 2 / std::numbers::pi * sum_with_one_logarithm(eta / 2, columns_needed(eta)); }},
        {"arithmetic-geometric mean", [=] { return ratio_by_mean(eta); }},
        {"this edition", [=] { return swing::ratio_from_top(eta); }}});
}

TELL
{
  curve("needed", {"zeta", "columns", "terms"}, [](Curve& c) {
    for(double zeta = 1; zeta < 179.5; ++zeta)
      c.put({zeta, zeta < 50 ? std::nan("") : columns_needed((180 - zeta) * 1_deg),
             zeta > 130 ? std::nan("") : terms_needed(zeta * 1_deg)});
  });
}

/*!
For a swing that falls short of the top by 1°, all digits of a double take {{terms_1}} terms of the series,
but only {{columns_1}} columns. Series and array meet at a right angle, with {{terms_90}} terms or
{{columns_90}} columns; no swing asks for more.

::: figure pendulum-38
alt: How many terms the series and how many columns the array need for sixteen digits, against the amplitude.
The terms rise from a few to about fifty at 90 degrees and steeply on; the columns fall from there to a few
near 180 degrees.

The invitation, answered: how many terms of the dissertation's series, or columns of the supplement's array,
give sixteen digits of the time. For every swing one of them is short.
:::

## Checks
*/

CHECK_THAT("by terms or by columns, every swing comes out to a few units of the last place")
{
  for(const double small : {1.57, 1.0, 0.1, 1e-3, 1e-8, 1e-16, 1e-150, 1e-300})
  {
    CHECK(by_both(swing::Amplitude::from_eta(small))
          == within_ulps(ratio_by_mean(Fifty(small)), 4,
                         "a logarithm, a mean and a polynomial, each rounded"));
    CHECK(by_both(swing::Amplitude::from_zeta(small))
          == within_ulps(ratio_by_mean(exact::pi() - Fifty(small)), 6, "up to 47 additions, each rounded"));
  }
}
