#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "pendulum/three_members.hpp"

SECTION(pendulum, 32, "First example: the members with the logarithm of two")

using namespace pendulum;

/*!
## What Euler does

The second member of {{eq pendulum.29 2}} is the hyperbolic logarithm of two, 0,69314718, multiplied by
$\cos\alpha = \cos 2°30'$. By common logarithms,

$$ \begin{aligned} l\,0{,}6931472 &= 9{,}8408253 \\ l\cos\alpha &= 9{,}9995865 \\ \text{sum} &= 9{,}8404118 = l\,\text{membr. II}, \end{aligned} \tag{1} $$

so that the member itself is 0,69249. Multiplied by $\tfrac34\sin^2\alpha$ it becomes the third,

$$ \begin{aligned} l\,\text{membr. II} &= 9{,}8404118 \\ l\,\tfrac34 &= 9{,}8750613 \\ l\sin^2\alpha &= 7{,}2793592 \\
   l\,\text{membr. III} &= 6{,}9948323, \end{aligned} \tag{2} $$

that is 0,00099. Since this is not even a thousandth, the members that would follow can safely be left out.

## The program

The reckoning again in whole ten-millionths, this time with the one number that Euler took from his table
wrongly.
*/

const SevenPlaces euler_has_for_ln_two = SevenPlaces::as_written("9,8408253");

struct Reckoned  // (1), (2)
{
  SevenPlaces second, third;
};

Reckoned members_by_the_table(const Fifty& alpha, SevenPlaces ln_two)
{
  const SevenPlaces second = ln_two + SevenPlaces::of(cos(alpha));
  return {second, second + SevenPlaces::of(Fifty(0.75)) + 2 * SevenPlaces::of(sin(alpha))};
}

/*!
What the members leave out is the fourth column of the array and all that follow. Its coefficient, which
{{sec pendulum.28}} finds, tells whether "safely" is justified.
*/

const auto swing_ = amplitude_from_top(5_deg, closed(90_deg, 179.9_deg));

TELL
{
  const Fifty alpha = swing_.eta.fifty() / 2;
  const auto exact = three_members(alpha, 40);
  const Reckoned t = members_by_the_table(alpha, euler_has_for_ln_two);
  const Fifty ln_two("0.6931472");
  tell_lines(
      "lines", "the reckoning, line by line",
      {{"l 2, hyperbolic", "0,69314718", rounded(exact::ln2(), 8), exact::ln2()},
       {"l 0,6931472", "9,8408253", SevenPlaces::of(ln_two).text(), augmented_logarithm(exact::ln2())},
       {"l cos α", "9,9995865", SevenPlaces::of(cos(alpha)).text(), augmented_logarithm(cos(alpha))},
       {"l member II", "9,8404118", t.second.text(), augmented_logarithm(exact.second)},
       {"member II", "0,69249", rounded(t.second.number(), 5), exact.second},
       {"l ¾", "9,8750613", SevenPlaces::of(Fifty(0.75)).text(), augmented_logarithm(Fifty(0.75))},
       {"l sin²α", "7,2793592", (2 * SevenPlaces::of(sin(alpha))).text(),
        augmented_logarithm(pow(sin(alpha), 2))},
       {"l member III", "6,9948323", t.third.text(), augmented_logarithm(exact.third)},
       {"member III", "0,00099", rounded(t.third.number(), 5), exact.third}},
      swing_.eta == 5_deg);
  tell("second", double(exact.second), "the second member, cos α l 2, exactly");
  tell("third", double(exact.third), "the third member, ¾ cos α sin²α l 2, exactly");
  tell("left_out", double(ratio_by_mean(2 * alpha) * exact::pi() / 2 - exact.sum()),
       "all the members after the third");
  curve("sizes", {"eta", "first", "second", "third", "rest"}, [](Curve& c) {
    for(double eta = 0.5; eta < 60.01; eta *= 1.05)
    {
      const Fifty a = Fifty(eta) * exact::pi() / 360;
      const auto m = three_members(a, 200);
      c.put({eta, double(m.first), double(m.second), double(m.third),
             double(ratio_by_mean(2 * a) * exact::pi() / 2 - m.sum())});
    }
  });
}

/*!
One line is not what the table has: the logarithm of 0,6931472 ends in 5, not in 3. Since Euler uses it
again in {{sec pendulum.36}}, he misread the table once and trusted his paper afterwards. Two units in the
seventh place do no harm to a result of five.

The third member is {{third|3}}, and all that is left out after it comes to {{left_out|e2}}: the argument
holds.

::: figure pendulum-32
alt: The sizes of the three members and of what is left out, against eta from half a degree to 60 degrees,
both scales logarithmic. The first two are of order one; the third rises as the square of eta, the rest as
its fourth power.

How large the members are. The third grows as the square of the angle, what Euler leaves out as its fourth
power: at 5° it is the sixth decimal, at 20° already the third.
:::

## Checks
*/

CHECK_THAT("from Euler's wrong number for l 0,6931472 the table gives every other line as he prints it")
{
  const Reckoned t = members_by_the_table(exact::pi() / 72, euler_has_for_ln_two);
  CHECK(euler_has_for_ln_two.text() == "9,8408253");
  CHECK(t.second.text() == "9,8404118");
  CHECK(rounded(t.second.number(), 5) == "0,69249");
  CHECK(t.third.text() == "6,9948323");
  CHECK(rounded(t.third.number(), 5) == "0,00099");
}

CHECK_THAT("both members are right as printed, and the third is less than a thousandth")
{
  const auto m = three_members(exact::pi() / 72, 40);
  CHECK(m.second == printed("0,69249"));
  CHECK(m.third == printed("0,00099"));
  CHECK(m.third < Fifty("0.001"));
  CHECK(ratio_by_mean(exact::pi() / 36) * exact::pi() / 2 - m.sum()
        == between(1.58e-6, 1.59e-6, "the fourth column, pendulum.28"));
}

/*!
The table's slip, and two readings of the scan. Both of these are settled by the logarithm that stands
beside them: 9,8750613 is the logarithm of ¾ and of nothing else.
*/

const Erratum misread_table{"§32, l 0,6931472",
                            {"9,8408253", 9.8408253},
                            {"9,8408255", 9.8408255},
                            "the table's entry; the slip returns in §36",
                            [](double reading) {
                              return augmented_logarithm(exact::ln2())
                                     == within(reading, 0.6e-7, "half a unit, and 0,6931472 is rounded");
                            }};

double from_its_logarithm()
{
  return std::pow(10, 9.8750613 - 10);
}

const Emendation factor_of_the_third{
    "§32, the factor of the third member",
    {"2/7 sin²α", 2.0 / 7},
    {"¾ sin²α", 0.75},
    "its logarithm is written out below",
    [](double reading) {
      return reading == within_relative(from_its_logarithm(), 1.2e-7, "half a unit of the seventh place");
    }};

const Emendation its_logarithm{
    "§32, the line of its logarithm", {"l ½", 0.5}, {"l ¾", 0.75}, "l ½ is 9,6989700", [](double reading) {
      return reading == within_relative(from_its_logarithm(), 1.2e-7, "half a unit of the seventh place");
    }};
