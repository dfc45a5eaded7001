#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 36, "Second example: the last members, and a lost result")

using namespace pendulum;

/*!
## What Euler does

Euler works out the last two members of the second example; then the copy breaks off. The second member is the
hyperbolic logarithm of two multiplied by $\cos\alpha$,

$$ \begin{aligned} l\,0{,}6931472 &= 9{,}8408253 \\ l\cos\alpha &= 9{,}9999835 \\ l\,\text{membr. II} &= 9{,}8408088 \\
   \text{membr. II} &= 0{,}69312, \end{aligned} \tag{1} $$

and multiplied by $\tfrac34\sin^2\alpha$ it gives the third,

$$ \begin{aligned} l\,\text{membr. II} &= 9{,}8408088 \\ l\,\tfrac34 &= 9{,}8750613 \\ l\sin^2\alpha &= 5{,}8816838 \\
   l\,\text{membr. III} &= 5{,}5975539 \\ \text{membr. III} &= 0{,}00004. \end{aligned} \tag{2} $$

After the first word of the next sentence the copy goes on in the middle of {{sec pendulum.37}}. In between
Euler must have collected the members, as he does in {{sec pendulum.33}}. Those that he prints add up to

$$ 5{,}43461 + 0{,}69312 + 0{,}00004 = 6{,}12777, \tag{3} $$

and this, or nearly this, will have been his $T/\Theta$. Here too the factor of {{sec pendulum.29}} is
missing:

$$ T = \tfrac2\pi\cdot 6{,}12777\,\Theta = {{mended|6}}\,\Theta. \tag{4} $$

## The program

The reckoning is that of {{sec pendulum.32}}, from the same logarithm of two, and the lost sum is put together
from what is printed.
*/

std::vector<Line> reckoning(const Fifty& alpha)  // (1), (2)
{
  return last_members(alpha, {"9,8408253", "9,9999835", "9,8408088", "0,69312", "9,8750613", "5,8816838",
                              "5,5975539", "0,00004"});
}

constexpr double restored_sum = 5.43461 + 0.69312 + 0.00004;  // (3)

const auto swing_ = amplitude_from_top(1_deg, closed(90_deg, 179.9_deg));
const auto Theta = real("Theta", 1.0, seconds, positive, "time of one infinitely small swing");

TELL
{
  tell_lines("lines", "the reckoning, line by line", reckoning(swing_.eta.fifty() / 2),
             swing_.eta == 1_deg);
  tell("restored", restored_sum, "the sum of the members printed for 1°: inferred, not in the copy");
  tell("mended", 2 / std::numbers::pi * restored_sum, "T/Θ for 1° by that sum");  // (4)
  tell("T_over_Theta", ratio_by_mean(swing_.eta.fifty()), "T/Θ to thirty digits");
  tell("T", Theta * swing::ratio({swing_.zeta, swing_.eta}), seconds, "one swing, exactly");
}

TELL
{
  curve("swings", {"eta", "exact", "euler"}, [](Curve& c) {
    for(double eta = 0.1; eta < 60; eta *= 1.05)
      c.put({eta, swing::ratio_from_top(eta * 1_deg), three_members(eta / 2 * 1_deg, 200).sum()});
  });
  curve("examples", {"eta", "exact", "euler"}, [](Curve& c) {
    c.put({5, swing::ratio_from_top(5_deg), 4.52023});
    c.put({1, swing::ratio_from_top(1_deg), restored_sum});
  });
}

/*!
::: margin
Today: $T/\Theta \approx \frac2\pi\ln\frac8\eta$ near the top.
:::

The second swing reaches four degrees nearer to the top than the first, and a seconds pendulum takes only one
second more for it: {{T|5}} s instead of {{pendulum.33.T|5}} s. So slowly does a logarithm grow.

::: figure pendulum-36
alt: T over Theta against the angle from the top on a logarithmic scale that runs from 60 degrees down to a
tenth of a degree. The exact curve is nearly a straight line, and so is Euler's rule above it, steeper. Both
examples, at 5 and at 1 degree, are marked on both lines.

Each tenfold approach to the top adds very nearly the same to the time. Euler's rule, with the printed result
of the first example and the restored one of the second, is the same line stretched by $\pi/2$.
:::

## Checks
*/

CHECK_THAT("from Euler's logarithm of two every other line follows as it is printed")
{
  const std::vector<Line> lines = reckoning(exact::pi() / 360);
  for(std::size_t i = 1; i < lines.size(); ++i)
    CHECK(lines[i].reckoned == lines[i].printed);
}

CHECK_THAT("both members are right as printed, and what is left out after them does not matter")
{
  const auto m = three_members(exact::pi() / 360, 40);
  CHECK(m.second == printed("0,69312"));
  CHECK(m.third == printed("0,00004"));
  CHECK(ratio_by_mean(exact::pi() / 180) * exact::pi() / 2 - m.sum()
        == between(0, 0.437 * std::pow(std::sin(0.5_deg), 4), "the fourth column and those after it"));
}

/*!
The number is restored, not the sentence. The mean confirms it as the time of half a swing: one of its members
is cut off and two are rounded, so that it may be off by two units of the fifth decimal.
*/

const Emendation lost_result{
    "§36, the end",
    {"the first word of a sentence, and no more", 0.0},
    {"a sentence that collects the members: 6,12777 (the number is inferred)", restored_sum},
    "§33 collects them at this place of the first example",
    [](double reading) {
      return ratio_by_mean(exact::pi() / 180) * exact::pi() / 2
             == within(reading, 2e-5, "one member is cut off, two are rounded, at the fifth decimal");
    }};

const Emendation cosine{"§36, the second factor, in text and reckoning",
                        {"cot α", 1 / std::tan(0.5_deg)},
                        {"cos α", std::cos(0.5_deg)},
                        "its logarithm is printed beside it",
                        [](double reading) {
                          return std::log10(reading) + 10
                                 == within(9.9999835, 0.5e-7, "half a unit of the last place");
                        }};
