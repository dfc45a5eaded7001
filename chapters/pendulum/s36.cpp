#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "pendulum/three_members.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 36, "Second example: the last members, and a lost result")

using namespace pendulum;

/*!
## What Euler does

The two members that remain are reckoned out; then the copy breaks off. The second member is the hyperbolic
logarithm of two times $\cos\alpha$,

$$ \begin{aligned} l\,0{,}6931472 &= 9{,}8408253 \\ l\cos\alpha &= 9{,}9999835 \\ l\,\text{membr. II} &= 9{,}8408088, \qquad
   \text{membr. II} = 0{,}69312, \end{aligned} \tag{1} $$

and multiplied by $\tfrac34\sin^2\alpha$ it gives the third,

$$ \begin{aligned} l\,\text{membr. II} &= 9{,}8408088 \\ l\,\tfrac34 &= 9{,}8750613 \\ l\sin^2\alpha &= 5{,}8816838 \\
   l\,\text{membr. III} &= 5{,}5975539, \qquad \text{membr. III} = 0{,}00004. \end{aligned} \tag{2} $$

Here the copy breaks off. The next page begins in the middle of {{sec pendulum.37}}; the sentence that
collects the members, which in the first example is {{sec pendulum.33}}, is lost. What it must have said can
be restored, if not how it said it: the members printed add up to

$$ 5{,}43461 + 0{,}69312 + 0{,}00004 = 6{,}12777, \tag{3} $$

and by his rule that would have been his $T/\Theta$. With the factor forgotten in {{sec pendulum.29}} it is

$$ T = \tfrac2\pi\cdot 6{,}12777\,\Theta = 3{,}90106\,\Theta. \tag{4} $$

## The program

The reckoning is that of {{sec pendulum.32}} with another angle; the wrong entry for 0,6931472 comes again.
*/

const auto swing_ = amplitude_from_top(1_deg, closed(90_deg, 179.9_deg));
const auto Theta = real("Theta", 1.0, seconds, positive, "time of one infinitely small swing");

std::vector<Line> reckoning(const Fifty& alpha)  // (1), (2)
{
  const auto exact = three_members(alpha, 40);
  const SevenPlaces second = SevenPlaces::as_written("9,8408253") + SevenPlaces::of(cos(alpha));
  const SevenPlaces square = 2 * SevenPlaces::of(sin(alpha));
  const SevenPlaces third = second + SevenPlaces::of(Fifty(0.75)) + square;
  return {{"l 0,6931472", "9,8408253", SevenPlaces::of(Fifty("0.6931472")).text(),
           augmented_logarithm(exact::ln2())},
          {"l cos α", "9,9999835", SevenPlaces::of(cos(alpha)).text(), augmented_logarithm(cos(alpha))},
          {"l member II", "9,8408088", second.text(), augmented_logarithm(exact.second)},
          {"member II", "0,69312", rounded(second.number(), 5), exact.second},
          {"l ¾", "9,8750613", SevenPlaces::of(Fifty(0.75)).text(), augmented_logarithm(Fifty(0.75))},
          {"l sin²α", "5,8816838", square.text(), augmented_logarithm(pow(sin(alpha), 2))},
          {"l member III", "5,5975539", third.text(), augmented_logarithm(exact.third)},
          {"member III", "0,00004", rounded(third.number(), 5), exact.third}};
}

/*!
The lost sum is put together from what is printed in this section and the last.
*/

constexpr double restored_sum = 5.43461 + 0.69312 + 0.00004;  // (3)

TELL
{
  const Fifty alpha = swing_.eta.fifty() / 2;
  const auto m = three_members(alpha, 40);
  tell_lines("lines", "the reckoning, line by line", reckoning(alpha), swing_.eta == 1_deg);
  tell("restored", restored_sum,
       "the sum of the printed members of the example of 1°: not in the copy, inferred");
  tell("restored_T", Theta * 2 / std::numbers::pi * restored_sum, seconds, "one swing by that sum and (4)");
  tell("members", double(m.sum()), "the three members, exactly");
  tell("left_out", double(ratio_by_mean(2 * alpha) * exact::pi() / 2 - m.sum()),
       "what all later members would add");
  tell("T_over_Theta", ratio_by_mean(2 * alpha), "T/Θ to thirty digits");
  tell("T", Theta * swing::ratio({swing_.zeta, swing_.eta}), seconds, "one swing, exactly");
  curve("swings", {"zeta", "ratio"}, [](Curve& c) {
    for(double eta = 0.2; eta < 40; eta *= 1.03)
      c.put({180 - eta, swing::ratio_from_top(eta * 1_deg)});
  });
}

/*!
The three members leave out only {{left_out|e2}} now. Four degrees nearer to the top, the swing takes only
one small swing's time more: {{T|5}} s in place of {{pendulum.33.T|5}} s. So slowly does a logarithm grow.

::: figure pendulum-36
alt: T over Theta against the amplitude from 140 to 180 degrees, the exact curve with three marked pairs: at
175 and 179 degrees the exact values 2.88 and 3.90, and above them Euler's 4.52 and the restored 6.13, each
higher by the factor pi over two.

The two examples. Euler's results, the second of them restored, stand above the curve by the same factor
$\pi/2$, as the forgotten factor demands.
:::

## Checks
*/

CHECK_THAT("from the wrong entry for l 0,6931472 every other line follows as it is printed")
{
  const std::vector<Line> lines = reckoning(exact::pi() / 360);
  CHECK(lines.front().printed != lines.front().reckoned);
  for(std::size_t i = 1; i < lines.size(); ++i)
    CHECK(lines[i].printed == lines[i].reckoned);
}

CHECK_THAT("the members are right as printed, their sum misses K by no more than their roundings, and "
           "nothing more is needed")
{
  const auto m = three_members(exact::pi() / 360, 40);
  const Fifty K = ratio_by_mean(exact::pi() / 180) * exact::pi() / 2;
  CHECK(m.second == printed("0,69312"));
  CHECK(m.third == printed("0,00004"));
  CHECK(double(K) == within(restored_sum, 2e-5, "one member cut off, two rounded, at the fifth decimal"));
  CHECK(K - m.sum() == between(2.52e-9, 2.54e-9, "the fourth column, 0.436 sin⁴α"));
}

/*!
The restored result contradicts the true time by the same factor as the first example; that proves again
where the error is.
*/

const Erratum the_swing{"§36, the lost result, restored",
                        {"T = 6,12777 Θ", 6.12777},
                        {"T = 3,90107 Θ", 3.90107},
                        "the forgotten factor 2/π; the number is inferred from the printed members",
                        [](double reading) {
                          return ratio_by_mean(exact::pi() / 180)
                                 == within(reading, 0.5e-5, "half a unit of the fifth decimal");
                        }};

const Erratum misread_table{"§36, l 0,6931472",
                            {"9,8408253", 9.8408253},
                            {"9,8408255", 9.8408255},
                            "as in §32",
                            [](double reading) {
                              return augmented_logarithm(exact::ln2())
                                     == within(reading, 0.6e-7, "half a unit, and 0,6931472 is rounded");
                            }};

const Emendation cosine{"§36, the second factor",
                        {"cot α", 1 / std::tan(0.5_deg)},
                        {"cos α", std::cos(0.5_deg)},
                        "its logarithm is printed beside it",
                        [](double reading) {
                          return std::log10(reading) + 10
                                 == within(9.9999835, 0.5e-7, "half a unit of the seventh place");
                        }};
