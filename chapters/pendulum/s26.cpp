#include "edition/section.hpp"
#include "exact/series.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 26, "The constant, by a quantity infinitely small")

using pendulum::W;

/*!
## What Euler does

An infinitely small $v$ makes the infinities of {{sec pendulum.25}} cancel, and the constant is found. First,
$\sqrt{1-vv} = 1 - \frac12vv$, so that the member with the root becomes

$$ -\frac{\sqrt{1-vv}}{4vv} = -\frac1{4vv} + \frac18{{entry member}}. \tag{1} $$

Then

$$ \begin{gathered} l\left(1+\sqrt{1-vv}\right) = l\left(2 - \tfrac12vv\right)
   = l2 + l\left(1 - \tfrac14vv\right), \\
   l\left(1 - \tfrac14vv\right) = -\tfrac14vv, \qquad
   l\left(1+\sqrt{1-vv}\right) = l2{{entry logarithm_of_two}}
   - \tfrac14vv{{entry quarter}}. \end{gathered} \tag{2} $$

With these put in, the expression that must vanish takes the form

$$ C + \frac{1+2l2}{4vv} - \frac1{4vv} + \frac18{{entry eighth}}
   - \left(\frac14 + \frac1{2vv}\right)\left(l2 - \tfrac14vv\right). \tag{3} $$

::: margin
For a finite $v$, {{eq 3}} with {{eq 4}} leaves $\frac1{16}vv$. The terms dropped in {{eq 1}} and {{eq 2}} add
$\frac1{32}vv$ and $\frac3{64}vv$, and all three make $\frac9{64}vv$, the first term of the series.
:::

Multiply out the last member: all that is divided by $vv$ cancels, what is multiplied by $vv$ is nothing, and
there remains

$$ C + \tfrac14 - \tfrac14\,l2 = 0, \qquad\text{that is}\qquad C = \tfrac14\,l2 - \tfrac14. \tag{4} $$

## The program

The three steps with a $v$ that is small but not nothing, in fifty digits, because at $v = 10^{-11}$ the
parts that destroy each other have 22 digits before the point.
*/

Fifty root_member(const Fifty& v)  // (1), the right side
{
  return -1 / (4 * v * v) + Fifty(1) / 8;
}

Fifty logarithm(const Fifty& v)  // (2), the right side
{
  return exact::ln2() - v * v / 4;
}

Fifty expression(const Fifty& v, const Fifty& C)  // (3)
{
  const Fifty vv = v * v;
  return C + (1 + 2 * exact::ln2()) / (4 * vv) + root_member(v)
         - (Fifty(0.25) + 1 / (2 * vv)) * logarithm(v);
}

const Fifty C = exact::ln2() / 4 - Fifty(1) / 4;  // (4)

const auto v = real("v", 1e-3, none, open(1e-11, 1), "the quantity that is conceived infinitely small");

TELL
{
  tell("C", C, "the constant");
  tell("left", expression(v.fifty(), C), "what is left of (3) with that constant");
  tell("whole", W(v.fifty()), "what is left when nothing is dropped, §25");
  auto& approach =
      table("approach", "The expression (3) without C, which goes to ¼ − ¼ l 2, and with C",
            {{"v", "v", none, 1}, {"without_C", "without C", none, 15}, {"with_C", "with C", none, 3}});
  for(const char* const small : {"0.1", "0.01", "0.001", "0.0001", "1e-7", "1e-10"})
  {
    const Fifty x(small);
    approach.row({static_cast<double>(x), static_cast<double>(expression(x, 0)),
                  static_cast<double>(expression(x, C))});
  }
}

/*!
{{table approach}}

So $C$ = {{C|15}}.

::: no-figure
The section takes a limit, and its table shows it.
:::

## Checks

To conceive $v$ as infinitely small does no harm: the power series, not cut off, say the same. Leave out $C$,
multiply by $4vv$ and write $l(1+\sqrt{1-vv})$ as $l2 + l\,\frac12(1+\sqrt{1-vv})$. What has the factor $l2$
is then $-vv$, which gives the $-\frac14\,l2$ of {{eq 4}}, and the rest is a series in exact fractions,

$$ 1 - \sqrt{1-vv} - (2 + vv)\,l\,\tfrac12\left(1+\sqrt{1-vv}\right). \tag{A} $$
*/

CHECK_THAT("of (A) nothing is left without vv, vv gives the ¼ of (4), and the rest is the third column")
{
  using Formal = exact::Series<Rational>;
  const Formal vv = exact::pow(Formal::x(42), 2);
  const Formal root = sqrt(1 - vv);
  const Formal rest = 1 - root - (2 + vv) * log((1 + root) / 2);
  CHECK(rest[0] == 0);
  CHECK(rest[2] / 4 == Rational(1, 4));
  for(int n = 1; n <= 19; ++n)
    CHECK(rest[2 * n + 2] / 4 == pendulum::entry(n + 1, 1));
}

CHECK_THAT("the steps (1), (2) and (3) are right as far as they go, and leave what the margin says")
{
  for(const double small : {1e-2, 1e-4, 1e-6})
  {
    const Fifty x(small);
    const Fifty vv = x * x;
    const Fifty root = sqrt(1 - vv);
    const double of_vv = small * small;
    CHECK((-root / (4 * vv) - root_member(x)) / vv
          == within(Fifty(1) / 32, of_vv / 63, "the next term, vv/64"));
    CHECK((logarithm(x) - log(1 + root)) / (2 * vv * vv)
          == within(Fifty(3) / 64, of_vv / 38, "the next term, 5vv/192"));
    CHECK(expression(x, C) == within(vv / 16, 1e-49 / of_vv, "exact, but for the rounding of the parts"));
  }
}

/*!
In our copy the minus and the eighth of {{eq 1}} are lost, the eighth in {{eq 3}} too; the logarithms of
{{eq 2}} have ½ for ¼ in four places, though {{eq 3}} has it right; and $l2$ has become the square of $l$.
*/

const Emendation member{"§26, (1)",
                        {"1/(4vv) + ¼", 25.25},
                        {"−1/(4vv) + ⅛", -24.875},
                        "the member with its root, here at v = 0.1",
                        [](double member) {
                          return member
                                 == within(-std::sqrt(0.99) / 0.04, 3.2e-4, "vv/32, and a little more");
                        }};

const Emendation eighth{"§26, (3)",
                        {"+ ¼", 0.25},
                        {"+ ⅛", 0.125},
                        "only so it comes to C + ¼ − ¼ l 2, as our copy has it, and vanishes with v",
                        [](double eighth) {
                          const Fifty rest = expression(Fifty("0.01"), C) - Fifty(1) / 8;
                          return rest + eighth == within(0, 7e-6, "vv/16 at v = 0.01");
                        }};

const Emendation quarter{"§26, (2), four times",
                         {"½ vv", 0.005},
                         {"¼ vv", 0.0025},
                         "half of ½ vv, since 2 was taken out; (3) has it; here at v = 0.1",
                         [](double subtracted) {
                           return std::log(2) - subtracted
                                  == within(std::log(1 + std::sqrt(0.99)), 1e-5, "3/32 of v to the fourth");
                         }};

const Emendation logarithm_of_two{
    "§26, (2) to (4)",
    {"l²", std::pow(std::numbers::ln2, 2)},
    {"l 2", std::numbers::ln2},
    "it is l(1 + √(1−vv)) at v = 0",
    [](double constant) { return constant == within(log(1 + sqrt(1 - Fifty(1e-8))), 1e-8, "¼ vv"); }};

/*!
What the program tells is held against the parts themselves, in closed form: of {{eq 3}} with {{eq 4}} there
is $\frac1{16}vv$ left, and of the whole expression what the series of {{eq A}} says.
*/

CHECK_THAT("the constant told is that of the integral's closed form, and what is left is a sixteenth of vv")
{
  for(const Told& now : told_at("", "v=0.5", "v=1e-10"))
  {
    const Fifty x = v.fifty(), vv = x * x, noise = Fifty("1e-48") / vv;
    CHECK(now.value("C") == within(log(Fifty(2) / exp(Fifty(1))) / 4, 1e-49, "the logarithm of 2 : e"));
    CHECK(now.value("left")
          == within(vv / 16, static_cast<double>(noise), "the parts are of the size of 1/vv"));
    Fifty sum = 0;
    for(int n = 60; n >= 1; --n)
      sum += static_cast<Fifty>(pendulum::entry(n + 1, 1)) * pow(vv, n);
    const double rest = static_cast<double>(pow(vv, 60) + noise);
    CHECK(now.value("whole") == within(sum, rest, "sixty terms of the third column"));
    for(const auto& row : now.rows("approach"))
    {
      const Fifty small(row.at("v")), ww = small * small;
      CHECK(row.value("without_C")
            == within_ulps(ww / 16 + (1 - exact::ln2()) / 4, 2, "v rounds, and the number told"));
      const double lost = static_cast<double>(ww * Fifty(4e-16) + Fifty("1e-48") / ww);
      CHECK(row.value("with_C")
            == within(ww / 16, lost, "v rounds, and the parts are of the size of 1/vv"));
    }
  }
}
