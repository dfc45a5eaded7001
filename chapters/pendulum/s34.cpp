#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "pendulum/series.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 34, "Second example, one degree from the top: the logarithms")

using namespace pendulum;

/*!
## What Euler does

Now the pendulum is let go only one degree from the top: $bAg = 1°$, so that its arc is short of the circle
by two degrees. Here $\eta = 1°$ and $\alpha = 30'$, and the table gives

$$ l\cos 30' = 9{,}9999835, \qquad l\sin\alpha = 7{,}9408419, \tag{1} $$

$$ l\sin^2\alpha = 5{,}8816838, \qquad l\sin^4\alpha = 1{,}7633676. \tag{2} $$

With them the series that multiplies the logarithm is

$$ 1 + \tfrac14\sin^2\alpha + \tfrac{9}{64}\sin^4\alpha + \text{etc.} = 1{,}00001904. \tag{3} $$

::: margin
The sixth power is no longer worth its line: its term is below $10^{-13}$.
:::

Unlike its fellow in {{sec pendulum.30}}, this sum is right to its last digit.

## The program

It is the reckoning of {{sec pendulum.30}} with another angle, and two terms in place of three.
*/

const auto swing_ = amplitude_from_top(1_deg, closed(90_deg, 179.9_deg));

Fifty factor_by_the_table(const Fifty& alpha)  // (3)
{
  const SevenPlaces sine = SevenPlaces::of(sin(alpha));
  return 1 + Fifty(0.25) * (2 * sine).number() + Fifty(9) / 64 * (4 * sine).number();
}

std::vector<Line> reckoning(const Fifty& alpha)  // (1), (2), (3)
{
  const SevenPlaces sine = SevenPlaces::of(sin(alpha));
  const auto true_power = [&](int n) { return augmented_logarithm(pow(sin(alpha), n)); };
  return {{"l cos α", "9,9999835", SevenPlaces::of(cos(alpha)).text(), augmented_logarithm(cos(alpha))},
          {"l sin α", "7,9408419", sine.text(), true_power(1)},
          {"l sin²α", "5,8816838", (2 * sine).text(), true_power(2)},
          {"l sin⁴α", "1,7633676", (4 * sine).text(), true_power(4)},
          {"series (3)", "1,00001904", rounded(factor_by_the_table(alpha), 8),
           ratio_by_mean(exact::pi() - 2 * alpha)}};
}

/*!
How many terms of {{eq 3}} are needed at all? That depends on how far from the top the descent begins; the
program counts those that it takes to leave less than half a unit of the eighth decimal.
*/

int terms_needed(double eta)
{
  const double excess = swing::ratio_excess(swing::Amplitude::from_zeta(eta));  // the sum less 1
  const double m = std::pow(std::sin(eta / 2), 2);
  int terms = 1;
  while(excess - (series(m, terms) - 1) > 0.5e-8)
    ++terms;
  return terms;
}

TELL
{
  const Fifty alpha = swing_.eta.fifty() / 2;
  tell_lines("lines", "the reckoning, line by line", reckoning(alpha), swing_.eta == 1_deg);
  tell("factor", ratio_by_mean(exact::pi() - 2 * alpha), "the whole series (3), exactly");
  tell("terms_needed", terms_needed(swing_.eta), "terms of (3) for eight decimals, the first among them");
  tell("arc", 2 * swing_.zeta, degrees, "the whole arc of the swing");
  curve("terms", {"eta", "terms"}, [](Curve& c) {
    for(double eta = 0.05; eta < 60; eta *= 1.01)
      c.put({eta, static_cast<double>(terms_needed(eta * 1_deg))});
  });
}

/*!
For this angle {{terms_needed}} terms do; the arc is {{arc|5}}°, and {{factor|11}} is the sum.

::: figure pendulum-34
alt: A staircase: the number of terms needed for eight decimals against eta on a logarithmic scale, from one
or two below one degree to a dozen at 60 degrees.

How many terms of {{eq 3}} give eight decimals. Euler's "three or four" of {{sec pendulum.29}} serve up to
about ten degrees.
:::

## Checks
*/

CHECK_THAT("every printed line is what a table of seven places and honest doubling give")
{
  for(const Line& line : reckoning(exact::pi() / 360))
    CHECK(line.printed == line.reckoned);
}

CHECK_THAT("the sum of the series is right to its eighth decimal")
{
  CHECK(ratio_by_mean(exact::pi() - exact::pi() / 180) == printed("1,00001904"));
  CHECK(factor_by_the_table(exact::pi() / 360)
        == within(ratio_by_mean(exact::pi() - exact::pi() / 180), 1e-11, "l sin²α to 7 places"));
}

/*!
In the scan the second of {{eq 2}} has lost its exponent and the sign of the logarithm. Four times the
printed logarithm of the sine, less thirty, leaves no doubt.
*/

const Emendation fourth_power{"§34, the second power",
                              {"sin²α = 1,7633676", 2},
                              {"l sin⁴α = 1,7633676", 4},
                              "it is four times l sin α, tens dropped",
                              [](double power) {
                                const SevenPlaces sine = SevenPlaces::as_written("7,9408419");
                                return (static_cast<int>(power) * sine).text() == "1,7633676";
                              }};
