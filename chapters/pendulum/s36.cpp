#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 36, "Second example: the last members, and a lost result")

using namespace pendulum;

/*!
## What Euler does

Euler works out the last two members of the second example; then the copy breaks off. The second member is the
hyperbolic logarithm of two multiplied by $\cos\alpha$,

$$ \begin{aligned} l\,0{,}6931472 &= 9{,}8408253 \\ l\cos\alpha{{entry cosine}} &= 9{,}9999835 \\
   l\,\text{membr. II} &= 9{,}8408088 \\
   \text{membr. II} &= 0{,}69312, \end{aligned} \tag{1} $$

and multiplied by $\tfrac34\sin^2\alpha$ it gives the third,

$$ \begin{aligned} l\,\text{membr. II} &= 9{,}8408088 \\ l\,\tfrac34 &= 9{,}8750613 \\
   l\sin^2\alpha &= 5{,}8816838 \\
   l\,\text{membr. III} &= 5{,}5975539 \\ \text{membr. III} &= 0{,}00004. \end{aligned} \tag{2} $$

After the first word of the next sentence {{entry lost_result}} the copy goes on in the middle of
{{sec pendulum.37}}. In between Euler must have collected the members, as he does in {{sec pendulum.33}}.
Those that our copy has add up to

$$ 5{,}43461 + 0{,}69312 + 0{,}00004 = 6{,}12777, \tag{A} $$

and this, or nearly this, will have been his $T/\Theta$. Here too the factor of {{sec pendulum.29}} is
missing:

$$ T = \tfrac2\pi\cdot 6{,}12777\,\Theta = {{mended|6}}\,\Theta. \tag{B} $$

## The program

The reckoning is that of {{sec pendulum.32}}, from the same logarithm of two, and the lost sum is put together
from what is there.
*/

std::vector<Line> reckoning(const Fifty& alpha)  // (1), (2)
{
  return last_members(alpha, {"9,8408253", "9,9999835", "9,8408088", "0,69312", "9,8750613", "5,8816838",
                              "5,5975539", "0,00004"});
}

constexpr double restored_sum = 5.43461 + 0.69312 + 0.00004;  // (A)

const auto swing_ = amplitude_from_top(1_deg, closed(90_deg, 179.9_deg));
const auto Theta = real("Theta", 1.0, seconds, scale, "time of one infinitely small swing");

TELL
{
  tell_lines("lines", "the reckoning, line by line", reckoning(swing_.eta.fifty() / 2),
             swing_.eta == 1_deg);
  tell("restored", restored_sum, "the sum of his members for 1°: inferred, not in the copy");
  tell("mended", 2 / std::numbers::pi * restored_sum, "T/Θ for 1° by that sum");  // (B)
  tell("T_over_Theta", ratio_by_mean(swing_.eta.fifty()), "T/Θ to thirty digits");
  tell("T", Theta * swing::ratio({swing_.zeta, swing_.eta}), seconds, "one swing");
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
{{table lines}}

::: margin
Today: $T/\Theta \approx \frac2\pi\ln\frac8\eta$ near the top.
:::

The second swing reaches four degrees nearer to the top than the first, and a seconds pendulum takes only one
second more for it: {{T|5}} s instead of {{pendulum.33.T|5}} s. So slowly does a logarithm grow.

::: figure pendulum-36
alt: T over Theta against the angle from the top on a logarithmic scale that runs from 60 degrees down to a
tenth of a degree. The exact curve is nearly a straight line, and so is Euler's rule above it, steeper. Both
examples, at 5 and at 1 degree, are marked on both lines.

Each tenfold approach to the top adds very nearly the same to the time. Euler's rule, with his result
of the first example and the restored one of the second, is the same line stretched by $\pi/2$.
:::

## Checks
*/

CHECK_THAT("from Euler's logarithm of two every other line follows as it stands")
{
  const std::vector<Line> lines = reckoning(exact::pi() / 360);
  for(std::size_t i = 1; i < lines.size(); ++i)
    CHECK(lines[i].reckoned == lines[i].printed);
}

CHECK_THAT("both members are right as they stand, and what is left out after them does not matter")
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
                        "its logarithm stands beside it",
                        [](double reading) {
                          return std::log10(reading) + 10
                                 == within(9.9999835, 0.5e-7, "half a unit of the last place");
                        }};

/*!
The true column is formed once more from the angle alone, and the times from the oracle's.
*/

CHECK_THAT("the truths told are those of the members, and the times those of the swing")
{
  for(const Told& now : told_at("", "eta=5 Theta=2", "eta=60 Theta=1e-50"))
  {
    const Fifty alpha = swing_.eta.fifty() / 2, ten = log(Fifty(10)),
                T = swing::oracle::ratio_from_top(2 * alpha);
    const auto augmented = [&](const Fifty& x) { return log(x) / ten - 10 * floor(log(x) / ten / 10); };
    const Fifty square = (1 - cos(2 * alpha)) / 2, second = sqrt(1 - square) * exact::ln2();
    const std::array<Fifty, 8> truth{augmented(Fifty("0.6931472")),
                                     augmented(cos(alpha)),
                                     augmented(second),
                                     second,
                                     augmented(Fifty("0.75")),
                                     augmented(square),
                                     augmented(Fifty("0.75") * square * second),
                                     Fifty("0.75") * square * second};
    const auto rows = now.rows("lines");
    for(std::size_t i = 0; i < truth.size(); ++i)
      CHECK(rows.at(i).value("true") == within_relative(truth[i], 2e-16, "rounded to a double"));
    CHECK(now.value("restored") == within(Fifty("6.12777"), 1e-15, "three decimals added in doubles"));
    CHECK(now.value("mended")
          == within_relative(Fifty("6.12777") * 2 / exact::pi(), 4e-16, "and a product"));
    CHECK(now.value("T_over_Theta") == within_relative(T, 1e-45, "two ways of fifty digits"));
    CHECK(now.value("T", seconds)
          == within_relative(Theta.fifty() * T, 4e-16, "the library's ulp, a product"));
  }
}

CHECK_THAT("the curves are the swing and Euler's rule, and the dots his examples")
{
  for(const Told& now : told_at(""))
    for(const char* const drawn : {"swings", "examples"})
      for(const auto& point : now.points(drawn, 6))
      {
        const Fifty eta = Fifty(point.at("eta")) * exact::pi() / 180,
                    T = swing::oracle::ratio_from_top(eta);
        CHECK(point.value("exact")
              == within_relative(T, 5e-16, "η in radians rounds, and the library's ulp"));
        const Fifty rule = exact::pi() / 2 * T;
        const double s = std::sin(static_cast<double>(eta) / 2),
                     dot = point.at("eta") == 1 || point.at("eta") == 5;
        CHECK(point.value("euler")
              == within(rule, 0.44 * std::pow(s, 4) / std::sqrt(1 - s * s) + dot * 2e-5 + 4e-15,
                        "the members' bound"));
      }
}

/*!
## Go on from here

::: exercise
What does a tenfold approach to the top add to the time, and how near must the pendulum be let go for ten
seconds?

answer: It adds nearly $\frac2\pi\,l\,10$, or 1.46587 Θ: {{T_over_Theta|6}} at a degree, 5.36687 at a tenth.
Ten seconds take $8e^{-5\pi}$ of a radian, a quarter of a second of arc.
:::
*/

CHECK_THAT("a tenth of the angle adds nearly 1.46587 Θ, and ten seconds belong to 8e^(−5π)")
{
  CHECK(2 / exact::pi() * log(Fifty(10)) == printed("1.46587"));
  for(const Told& now : told_at("eta=1", "eta=0.1"))
    CHECK(now.value("T_over_Theta")
          == within(swing_.eta > 0.5_deg ? 3.90107 : 5.36687, 0.5e-5, "five decimals"));
  const Fifty eta = 8 * exp(-5 * exact::pi());
  CHECK(swing::oracle::ratio_from_top(eta) == within(10, 1e-10, "ηη"));
  CHECK(eta * 648'000 / exact::pi() == within(0.25, 0.003, "seconds of arc"));
}
