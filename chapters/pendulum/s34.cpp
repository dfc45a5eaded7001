#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 34, "Second example, one degree from the top: the logarithms")

using namespace pendulum;

/*!
## What Euler does

In the second example the pendulum is let go one degree from the top and rises again to the same height. So
$bAg = \eta = 1°$ and $\alpha = 30'$. The table gives

$$ l\cos 30' = 9{,}9999835, \qquad l\sin\alpha = 7{,}9408419, \tag{1} $$

and from this follow the powers

$$ l\sin^2\alpha = 5{,}8816838, \qquad l\sin^4\alpha{{entry fourth_power}} = 1{,}7633676. \tag{2} $$

With them the series that multiplies $l\cot\tfrac12\alpha$ is

$$ 1 + \tfrac14\sin^2\alpha + \tfrac{9}{64}\sin^4\alpha + \text{etc.} = 1{,}00001904. \tag{3} $$

::: margin
The sixth power, which he still had for 5°, is gone. Eight decimals do not even need the fourth.
:::

Unlike the sum in {{sec pendulum.30}}, this one is right to its last digit.

## The program

It is the reckoning of {{sec pendulum.30}} with another angle and one power less.
*/

Fifty sum_by_the_table(SevenPlaces sine)  // (3)
{
  return 1 + (2 * sine).number() / 4 + 9 * (4 * sine).number() / 64;
}

std::vector<Line> reckoning(const Fifty& alpha)  // (1), (2), (3)
{
  const SevenPlaces sine = SevenPlaces::of(sin(alpha));
  const auto power = [&](int n) { return augmented_logarithm(pow(sin(alpha), n)); };
  return {{"l cos α", "9,9999835", SevenPlaces::of(cos(alpha)).text(), augmented_logarithm(cos(alpha))},
          {"l sin α", "7,9408419", sine.text(), power(1)},
          {"l sin²α", "5,8816838", (2 * sine).text(), power(2)},
          {"l sin⁴α", "1,7633676", (4 * sine).text(), power(4)},
          {"series (3)", "1,00001904", rounded(sum_by_the_table(sine), 8),
           ratio_by_mean(exact::pi() - 2 * alpha)}};
}

/*!
How many terms of {{eq 3}} do eight decimals take? The series is that of a swing of amplitude η, so the
program knows its sum, and counts the terms until less than half a unit of the eighth decimal is missing.
*/

int terms_needed(double eta)
{
  int terms = 1;
  while(swing::ratio_from_bottom(eta) - series(std::pow(std::sin(eta / 2), 2), terms) > 0.5e-8)
    ++terms;
  return terms;
}

double four_serve_to()  // in degrees, to a tenth
{
  int tenths = 10;
  while(terms_needed((tenths + 1) * 0.1_deg) <= 4)
    ++tenths;
  return tenths / 10.0;
}

const auto swing_ = amplitude_from_top(1_deg, closed(90_deg, 179.9_deg));

TELL
{
  tell_lines("lines", "the reckoning, line by line", reckoning(swing_.eta.fifty() / 2),
             swing_.eta == 1_deg);
  tell("factor", swing::ratio_from_bottom(swing_.eta), "the sum of the whole series (3)");
  tell("terms_needed", terms_needed(swing_.eta), "terms of (3) for eight decimals, the 1 among them");
  tell("four_serve", four_serve_to() * 1_deg, degrees, "to which η four terms give eight decimals", 3);
}

TELL
{
  curve("terms", {"eta", "terms"}, [](Curve& c) {
    for(double eta = 0.05; eta < 60; eta *= 1.01)
      c.put({eta, double(terms_needed(eta * 1_deg))});
  });
  curve("examples", {"eta", "terms"}, [](Curve& c) {
    for(const double eta : {1.0, 5.0})
      c.put({eta, double(terms_needed(eta * 1_deg))});
  });
}

/*!
{{table lines}}

For this angle {{terms_needed}} terms are enough.

::: figure pendulum-34
alt: A staircase: the number of terms needed for eight decimals against eta on a logarithmic scale, two at one
degree, three at five degrees, a dozen at 60 degrees.

How many terms of {{eq 3}} give eight decimals. Euler's "three or four" ({{sec pendulum.29}}) serve up to
about {{four_serve|deg0}}.
:::

## Checks
*/

CHECK_THAT("every line of our copy is what a table of seven places and honest doubling give")
{
  for(const Line& line : reckoning(exact::pi() / 360))
    CHECK(line.reckoned == line.printed);
}

CHECK_THAT("the looked-up logarithms and the sum of the series are right to their last digits")
{
  const std::vector<Line> lines = reckoning(exact::pi() / 360);
  for(const std::size_t i : {0u, 1u, 4u})
    CHECK(lines[i].truth == printed(lines[i].printed.c_str()));
  CHECK(sum_by_the_table(SevenPlaces::as_written("7,9408419"))
        == within(lines.back().truth, 4.4e-12, "half a unit in l sin α, a unit in l sin²α"));
}

/*!
In our copy the second of {{eq 2}} is without the sign of the logarithm, and its exponent is 2.
*/

const Emendation fourth_power{
    "§34, the second power",
    {"sin²α = 1,7633676", 2},
    {"l sin⁴α = 1,7633676", 4},
    "it is four times l sin α, less thirty",
    [](double n) {
      const double times = n * (7.9408419 - 10) + 10;
      return times == within(1.7633676, 1e-9, "the sine's logarithm n times, less tens");
    }};

/*!
The truth in the table, and how many terms serve, by the whole series in fifty digits:
*/

Fifty missing_after(int terms, const Fifty& eta)  // what (3) lacks after so many terms
{
  return swing::oracle::ratio_from_bottom(eta) - series(pow(sin(eta / 2), 2), terms);
}

CHECK_THAT("the truths told are the logarithms and the sum, and the terms told are the fewest that serve")
{
  const Fifty half_unit("0.5e-8");
  for(const Told& now : told_at("", "eta=5", "eta=60"))
  {
    const Fifty eta = swing_.eta.fifty(), ten = log(Fifty(10)), s = log(sin(eta / 2)) / ten;
    const Fifty sum = swing::oracle::ratio_from_bottom(eta);
    const std::array<Fifty, 5> truth{log(cos(eta / 2)) / ten + 10, s + 10, 2 * s + 10, 4 * s + 10, sum};
    const auto rows = now.rows("lines");
    for(std::size_t i = 0; i < truth.size(); ++i)
      CHECK(rows.at(i).value("true") == within_relative(truth[i], 3e-16, "rounded to a double"));
    CHECK(now.value("factor") == within_ulps(sum, 1, "the library's bound"));
    int fewest = 1;
    while(missing_after(fewest, eta) > half_unit)
      ++fewest;
    CHECK(now.value("terms_needed") == fewest);
    Fifty to = exact::pi() / 180;
    const Fifty tenth = exact::pi() / 1800;
    while(missing_after(4, to + tenth) <= half_unit)
      to += tenth;
    CHECK(now.value("four_serve", degrees)
          == within_ulps(to, 1, "a whole number of tenths, and the degree"));
  }
}

CHECK_THAT("the staircase has at each point the fewest terms that serve, and so has either example")
{
  for(const Told& now : told_at(""))
    for(const char* const drawn : {"terms", "examples"})
      for(const auto& point : now.points(drawn, 9))
      {
        const Fifty eta = Fifty(point.at("eta")) * exact::pi() / 180, half_unit("0.5e-8");
        int fewest = 1;
        while(missing_after(fewest, eta) > half_unit)
          ++fewest;
        CHECK(point.value("terms") == within(Fifty(fewest), 0, "a count"));
      }
}

/*!
## Go on from here

::: exercise
How near to the top must the pendulum be let go for the series {{eq 3}} to need no term but the 1, to eight
decimals?

answer: Its second term, nearly $\frac1{16}\eta^2$, must be less than half a unit of the eighth decimal: so
from 0.0162° on.
:::
*/

CHECK_THAT("the 1 alone serves to 0.0162°, and not to 0.0163°")
{
  CHECK(terms_needed(0.0162_deg) == 1);
  CHECK(terms_needed(0.0163_deg) == 2);
}
