#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "pendulum/series.hpp"
#include "swing/oracle.hpp"

SECTION(pendulum, 30, "First example, five degrees from the top: the logarithms")

using namespace pendulum;

/*!
## What Euler does

The first example begins with a table of logarithms, and one of its numbers is wrong. The pendulum is let go
at $bAg = 5°$ from the top and rises to the same height on the other side. So $\eta = 5°$ and
$\alpha = 2°\,30'$, and the table gives

$$ l\cos\alpha = 9{,}9995865, \qquad l\sin\alpha = 8{,}6396796. \tag{1} $$

::: margin
$l$ before a trigonometric function is here the *common* logarithm with ten added, as in the tables:
9,9995865 is $-0{,}0004135$.
:::

The second, doubled, makes the square of the sine; twice and three times that, its other powers,

$$ \begin{gathered} l\sin^2\alpha = 7{,}2793592, \\
   l\sin^4\alpha = 4{,}5587184, \qquad l\sin^6\alpha = 1{,}8380776. \end{gathered} \tag{2} $$

From these he computes the series by which $l\cot\tfrac12\alpha$ is to be multiplied,

$$ 1 + \tfrac14\sin^2\alpha + \tfrac{9}{64}\sin^4\alpha + \tfrac{25}{256}\sin^6\alpha + \text{etc.}
   = 1{,}0004801{{entry the_series}}. \tag{3} $$

This last number is the wrong one.

## The program

A line of such a reckoning is checked in two ways: against the truth, and against what a calculator must find
who looks up seven places and adds what is on the paper. The second is done in whole ten-millionths.

::: code pendulum/logarithms.hpp SevenPlaces
:::

The series is then a matter of three antilogarithms.
*/

Fifty factor_by_the_table(SevenPlaces sine)  // (2), (3)
{
  return 1 + Fifty(0.25) * (2 * sine).number() + Fifty(9) / 64 * (4 * sine).number()
         + Fifty(25) / 256 * (6 * sine).number();
}

std::vector<Line> reckoning(const Fifty& alpha)
{
  const SevenPlaces sine = SevenPlaces::of(sin(alpha));
  const auto power = [&](const char* what, const char* printed, int n) {
    return Line{what, printed, (n * sine).text(), augmented_logarithm(pow(sin(alpha), n))};
  };
  return {{"l cos α", "9,9995865", SevenPlaces::of(cos(alpha)).text(), augmented_logarithm(cos(alpha))},
          power("l sin α", "8,6396796", 1),
          power("l sin²α", "7,2793592", 2),
          power("l sin⁴α", "4,5587184", 4),
          power("l sin⁶α", "1,8380776", 6),
          {"series (3)", "1,0004801", rounded(factor_by_the_table(sine), 7),
           ratio_by_mean(exact::pi() - 2 * alpha)}};
}

const auto swing_ = amplitude_from_top(5_deg, closed(90_deg, 179.9_deg));

TELL
{
  const Fifty alpha = swing_.eta.fifty() / 2;
  const Fifty square = pow(sin(alpha), 2);
  tell_lines("lines", "the reckoning, line by line", reckoning(alpha), swing_.eta == 5_deg);
  tell("second_term", double(square / 4), "¼ sin²α");
  tell("third_term", double(9 * square * square / 64), "9/64 sin⁴α");
  tell("factor", ratio_by_mean(exact::pi() - 2 * alpha), "the whole series (3), to 30 digits");
}

/*!
{{table lines}}

The logarithms of the powers are too large by one or two units of the last place, because what is doubled had
been rounded; so it was done, and it does no harm. The series is another matter. Its second term is
{{second_term|6}}, its third {{third_term|3}}, and no reckoning makes more of them than {{factor|8}}.

::: no-figure
The section is a table of numbers, and the table is shown.
:::

## Checks

The program's calculator, working from the table alone, must write what our copy has.
*/

CHECK_THAT(
    "a table of seven places and honest doubling give the logarithms of our copy, but not its series")
{
  const std::vector<Line> lines = reckoning(exact::pi() / 72);
  for(std::size_t i = 0; i + 1 < lines.size(); ++i)
    CHECK(lines[i].printed == lines[i].reckoned);
  CHECK(lines.back().reckoned == "1,0004762");
}

/*!
The cosine is a close call: behind its seventh place comes …51, and a double shifted by ten might be rounded
either way. The table here rounds a number of fifty digits.
*/

CHECK_THAT("the logarithm of the cosine lies within a fiftieth of a unit of the tie between two entries")
{
  const Fifty in_units = augmented_logarithm(cos(exact::pi() / 72)) * Fifty(1e7);
  CHECK(in_units - floor(in_units) == between(0.5, 0.52, "the tie is at one half"));
}

CHECK_THAT(
    "the series is that of a swing of 5° from the lowest point, and the table gives it to nine decimals")
{
  const Fifty m = pow(sin(exact::pi() / 72), 2);
  CHECK(series(m, 20) == within(ratio_by_mean(exact::pi() * 35 / 36), 1e-48, "m²⁰ is below 10⁻⁵⁴"));
  CHECK(factor_by_the_table(SevenPlaces::of(sin(exact::pi() / 72)))
        == within(series(m, 20), 1.1e-10, "¼ sin²α, its logarithm wrong by a ten-millionth"));
}

/*!
The wrong sum stands twice, here and in {{sec pendulum.31}}, where the product that it enters is
nevertheless right. Whoever looks for the slip will find that the third term with its decimal shifted, or with
27 for 9, gives other wrong numbers, but not this one.
*/

const Doubtful the_series{"§30, (3), the sum of the series",
                          {"1,0004801", 1.0004801},
                          {"1,0004762", 1.0004762},
                          "1 + ¼sin²α alone is 1.0004757, and all the rest is half a millionth",
                          [](double reading) {
                            const Fifty m = pow(sin(exact::pi() / 72), 2);
                            const Fifty sum = 1 + m / 4 + 9 * m * m / 64 + 25 * m * m * m / 256;
                            return sum == within(reading, 0.5e-7, "half a unit of the last place");
                          }};

/*!
The true column and the terms told, once more from the sine and the time alone:
*/

CHECK_THAT(
    "the truths told are the logarithms of the powers and the time of a swing of η, the terms its first")
{
  for(const Told& now : told_at("", "eta=1", "eta=90"))
  {
    const Fifty eta = swing_.eta.fifty(), ten = log(Fifty(10)), s = log(sin(eta / 2)) / ten;
    const Fifty time = swing::oracle::ratio_from_bottom(eta), versed = (1 - cos(eta)) / 2;
    const auto augmented = [](const Fifty& l) {
      return l - 10 * floor(l / 10);
    };  // no logarithm is negative
    const std::array<Fifty, 6> truth{augmented(log(cos(eta / 2)) / ten),
                                     augmented(s),
                                     augmented(2 * s),
                                     augmented(4 * s),
                                     augmented(6 * s),
                                     time};
    const auto rows = now.rows("lines");
    for(std::size_t i = 0; i < truth.size(); ++i)
      CHECK(rows.at(i).value("true") == within_relative(truth[i], 2e-16, "rounded to a double"));
    CHECK(now.value("second_term") == within_relative(versed / 4, 2e-16, "sin²α is half of 1 − cos η"));
    CHECK(now.value("third_term") == within_relative(9 * versed * versed / 64, 2e-16, "the same"));
    CHECK(now.value("factor") == within_relative(time, 1e-45, "two ways of fifty digits"));
  }
}
