#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "pendulum/series.hpp"

SECTION(pendulum, 30, "First example, five degrees from the top: the logarithms")

using namespace pendulum;

/*!
## What Euler does

The pendulum is let go at $bAg = 5°$ from the top and rises to the same height on the other side. So
$\eta = 5°$ and $\alpha = 2°\,30'$, and a table of logarithms gives

$$ l\cos\alpha = 9{,}9995865, \qquad l\sin\alpha = 8{,}6396796. \tag{1} $$

By doubling, and doubling and trebling that, he has the powers of the sine,

$$ l\sin^2\alpha = 7{,}2793592, \quad l\sin^4\alpha = 4{,}5587184, \quad l\sin^6\alpha = 1{,}8380776, \tag{2} $$

and with them the series by which $l\cot\tfrac12\alpha$ is to be multiplied,

$$ 1 + \tfrac14\sin^2\alpha + \tfrac{9}{64}\sin^4\alpha + \tfrac{25}{256}\sin^6\alpha + \text{etc.} = 1{,}0004801. \tag{3} $$

::: margin
$l$ before a trigonometric function is here the *common* logarithm with ten added, as in the tables:
9,9995865 is $-0{,}0004135$.
:::

Everything is right but the last number.

## The program

A line of such a reckoning can be checked in two ways: against the truth, and against what a calculator of
his day must find, who looks up seven places and adds what is on the paper. The second is done in whole
ten-millionths, as on the paper.

::: code pendulum/logarithms.hpp SevenPlaces
:::

The angle is the example's; another may be put in its place.
*/

const auto swing_ = amplitude_from_top(5_deg, closed(90_deg, 179.9_deg));

struct Sines  // (1), (2)
{
  SevenPlaces cosine, sine, square, fourth, sixth;
};

Sines looked_up(const Fifty& alpha)
{
  const SevenPlaces sine = SevenPlaces::of(sin(alpha));
  return {SevenPlaces::of(cos(alpha)), sine, 2 * sine, 4 * sine, 6 * sine};
}

/*!
The series is then a matter of three antilogarithms.
*/

Fifty factor_by_the_table(const Sines& t)  // (3)
{
  return 1 + Fifty(0.25) * t.square.number() + Fifty(9) / 64 * t.fourth.number()
         + Fifty(25) / 256 * t.sixth.number();
}

/*!
Each line as it is printed, as the calculator finds it, and as it should be:
*/

std::vector<Line> reckoning(const Fifty& alpha)
{
  const Sines t = looked_up(alpha);
  const auto sine_to = [&](int n) { return augmented_logarithm(pow(sin(alpha), n)); };
  return {{"l cos α", "9,9995865", t.cosine.text(), augmented_logarithm(cos(alpha))},
          {"l sin α", "8,6396796", t.sine.text(), sine_to(1)},
          {"l sin²α", "7,2793592", t.square.text(), sine_to(2)},
          {"l sin⁴α", "4,5587184", t.fourth.text(), sine_to(4)},
          {"l sin⁶α", "1,8380776", t.sixth.text(), sine_to(6)},
          {"series (3)", "1,0004801", rounded(factor_by_the_table(t), 7),
           ratio_by_mean(exact::pi() - 2 * alpha)}};
}

TELL
{
  const Fifty alpha = swing_.eta.fifty() / 2;
  tell_lines("lines", "the reckoning, line by line", reckoning(alpha), swing_.eta == 5_deg);
  tell("factor", ratio_by_mean(exact::pi() - 2 * alpha), "the whole series (3), exactly");
  tell("second_term", double(Fifty(0.25) * pow(sin(alpha), 2)), "¼ sin²α");
  tell("third_term", double(Fifty(9) / 64 * pow(sin(alpha), 4)), "9/64 sin⁴α");
}

/*!
The doubled logarithms are off by a unit of the last place from what the table would say, because what is
doubled has been rounded; that is how it was done, and it does no harm.

The series is another matter. Its second term is {{second_term|6}}, its third {{third_term|3}}, and no
reckoning makes more of them than {{factor|8}}.

::: no-figure
The section is a table of numbers, and the table is shown.
:::

## Checks

The program's calculator, working from the table alone, must write what Euler's printer set.
*/

CHECK_THAT(
    "the printed logarithms are what a table of seven places and honest doubling give, the series is not")
{
  const std::vector<Line> lines = reckoning(exact::pi() / 72);
  for(std::size_t i = 0; i + 1 < lines.size(); ++i)
    CHECK(lines[i].printed == lines[i].reckoned);
  CHECK(lines.back().printed != lines.back().reckoned);
}

/*!
The cosine is a close call: its eighth digit and those after it are …51, so that a rounding done on a
machine's double after a shift by ten could go either way. The table here rounds a number of fifty digits.
*/

CHECK_THAT(
    "the logarithm of the cosine lies within a fiftieth of a unit of the tie between two table entries")
{
  const Fifty in_units = augmented_logarithm(cos(exact::pi() / 72)) * Fifty(1e7);
  CHECK(in_units - floor(in_units) == between(0.5, 0.52, "the tie is at one half"));
}

/*!
The factor is the same series as that of a swing of amplitude η, which {{sec pendulum.10}} knows how to
bound. What is printed lies far outside; a reader who looks for the slip will find that a decimal shifted in
the third term, or a 27 for its 9, gives other wrong numbers, not this one. It stands twice, here and in
{{sec pendulum.31}}, where the product it enters is nevertheless right.
*/

const Doubtful the_series{"§30, (3), the sum of the series",
                          {"1,0004801", 1.0004801},
                          {"1,0004762", 1.0004762},
                          "1 + ¼sin²α alone is 1,0004757, and all the rest is half a millionth",
                          [](double reading) {
                            const Fifty m = pow(sin(exact::pi() / 72), 2);
                            const Fifty sum = 1 + m / 4 + 9 * m * m / 64 + 25 * m * m * m / 256;
                            return sum == within(reading, 0.5e-7, "half a unit of the printed place");
                          }};

CHECK_THAT("the factor is the time of a swing of 5° from the lowest point, by the series and by the mean")
{
  const Fifty m = pow(sin(exact::pi() / 72), 2);
  CHECK(series(m, 20) == within(ratio_by_mean(35 * exact::pi() / 36), 1e-48, "m²⁰ is below 10⁻⁵⁴"));
  CHECK(factor_by_the_table(looked_up(exact::pi() / 72))
        == within(series(m, 20), 2e-10, "two units of 7 places in sin²α/4"));
}
