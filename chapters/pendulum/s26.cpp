#include "edition/section.hpp"
#include "exact/series.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 26, "The constant, by a quantity infinitely small")

using pendulum::W;

/*!
## What Euler does

A quantity infinitely small finds the constant. What {{sec pendulum.25}} announced is now done. Let $v$ be
infinitely small. First, $\sqrt{1-vv} = 1 - \frac12vv$, from which the member with the root becomes

$$ -\frac{\sqrt{1-vv}}{4vv} = -\frac1{4vv} + \frac18. \tag{1} $$

Then

$$ \begin{gathered} l\left(1+\sqrt{1-vv}\right) = l\left(2 - \tfrac12vv\right)
   = l2 + l\left(1 - \tfrac14vv\right), \\
   l\left(1 - \tfrac14vv\right) = -\tfrac14vv, \end{gathered} \tag{2} $$

so that $l\left(1+\sqrt{1-vv}\right) = l2 - \frac14vv$. With these put in, the expression that is to vanish
takes the form

$$ C + \frac{1+2l2}{4vv} - \frac1{4vv} + \frac18 - \left(\frac14 + \frac1{2vv}\right)\left(l2 -
     \tfrac14vv\right). \tag{3} $$

When the last member is multiplied out, everything that has $vv$ below goes out, what has $vv$ above is
nothing, and there remains

$$ C + \tfrac14 - \tfrac14\,l2 = 0, \qquad\text{that is}\qquad C = \tfrac14\,l2 - \tfrac14. \tag{4} $$

::: margin
One order further, and what is left of the whole is $\frac9{64}vv$, the first term of the series; {{eq 3}}
leaves $\frac1{16}vv$.
:::

## The program

The three steps with a $v$ that is small but not nothing, each beside what it replaces.
*/

template <class Real>
Real root_member(Real v)  // (1), the right side
{
  return -1 / (4 * v * v) + Real(1) / 8;
}

template <class Real>
Real logarithm(Real v)  // (2)
{
  using std::log;
  return log(Real(2)) - v * v / 4;
}

template <class Real>
Real expression(Real v, Real C)  // (3)
{
  using std::log;
  const Real vv = v * v;
  return C + (1 + 2 * log(Real(2))) / (4 * vv) + root_member(v) - (Real(0.25) + 1 / (2 * vv)) * logarithm(v);
}

const Fifty C = exact::ln2() / 4 - Fifty(1) / 4;  // (4)

const auto v = real("v", 1e-3, none, open(1e-11, 1), "the quantity that is conceived infinitely small");

/*!
In fifty digits one may go down to $10^{-11}$: there the parts that destroy each other have 22 digits before
the comma.
*/

TELL
{
  const Fifty w = static_cast<double>(v);
  const Fifty true_root = sqrt((1 - w) * (1 + w));
  tell("C", C, "the constant");
  tell("left", expression(w, C), "what is left of (3) with that constant");
  tell("exact", W(w), "what is left of the unabridged expression, §25");
  tell("root_error", static_cast<double>(-true_root / (4 * w * w) - root_member(w)), "what (1) leaves out");
  tell("log_error", static_cast<double>(log(1 + true_root) - logarithm(w)), "what (2) leaves out");
  auto& approach = table("approach",
      "The expression (3), for smaller and smaller v: without C it goes to ¼ − ¼ l 2.",
                         {{"v", "v"}, {"without_C", "without C", none, 15}, {"with_C", "with C"}});
  for(const char* const small : {"0.1", "0.01", "0.001", "0.0001", "1e-7", "1e-10"})
  {
    const Fifty x(small);
    approach.row({static_cast<double>(x), static_cast<double>(expression(x, Fifty(0))),
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

That nothing is wrong with conceiving $v$ infinitely small is seen when the series are not cut off at all.
Four times $vv$ times the expression is a power series in exact fractions, once $l2$ has been set apart; and
apart from $l2$ it is

$$ \begin{gathered} 1 - \sqrt{1-vv} - (2 + vv)\,l\,\tfrac12\left(1+\sqrt{1-vv}\right), \\
   \text{with } l2:\quad 2 - (2 + vv) = -vv. \end{gathered} \tag{5} $$
*/

using Formal = exact::Series<Rational>;

CHECK_THAT("the parts with vv below destroy each other, ¼ is left, and the third column follows")
{
  const Formal vv = exact::pow(Formal::x(42), 2);
  const Formal root = sqrt(1 - vv);
  const Formal apart = 1 - root - (2 + vv) * log((1 + root) / 2);
  CHECK(apart[0] == 0);
  CHECK(apart[2] / 4 == Rational(1, 4));  // so that C + ¼ − ¼ l 2 = 0
  for(int n = 1; n <= 19; ++n)
    CHECK(apart[2 * n + 2] / 4 == pendulum::entry(n + 1, 1));
}

CHECK_THAT("the two replacements are right as far as they go, and no farther")
{
  for(const char* const small : {"1e-2", "1e-4", "1e-6"})
  {
    const Fifty x(small);
    const Fifty root = sqrt(1 - x * x);
    CHECK((-root / (4 * x * x) - root_member(x)) / (x * x)
          == within(Fifty(1) / 32, 2e-6, "the next term, vv/64"));
    CHECK((log(1 + root) - logarithm(x)) / pow(x, 4)
          == within(-Fifty(3) / 32, 6e-6, "the next term, 5vv/96"));
  }
}

CHECK_THAT("with C = ¼ l 2 − ¼ the expression (3) vanishes with v")
{
  for(const char* const small : {"1e-2", "1e-5", "1e-10"})
  {
    const Fifty x(small);
    CHECK(expression(x, C) == within_relative(x * x / 16, 1e-6, "multiplied out it is just ¼ · ¼vv"));
  }
}

/*!
The scan has ¼ where ⅛ is needed, twice, and a plus before it; a ½ for the ¼ in the logarithms, though
{{eq 3}} has it right; and again the square of $l$ for $l2$. The readings are worked out at $v = 0{,}1$, or
put into {{eq 3}}.
*/

double mended(double eighth, double of_logarithm)  // (3) at v = 0.01, with this for ⅛ and this for ¼
{
  const double vv = 1e-4;
  return static_cast<double>(C) + (1 + 2 * std::numbers::ln2) / (4 * vv) - 1 / (4 * vv) + eighth
         - (0.25 + 1 / (2 * vv)) * (std::numbers::ln2 - of_logarithm * vv);
}

bool vanishes(double left)
{
  return left == within(0, 1e-5, "vv/16");
}

const Emendation sign{
    "§26, (1)", {"1/(4vv) + …", 25 + 0.125}, {"−1/(4vv) + …", -25 + 0.125},
    "the member has a minus in §25 and in (3)",
    [](double member) {
      return member == within(-std::sqrt(0.99) / 0.04, 4e-4, "vv/32 at v = 0,1, and more");
    }};

const Emendation eighth{
    "§26, (1) and (3)", {"+ ¼", mended(0.25, 0.25)}, {"+ ⅛", mended(0.125, 0.25)},
    "only so (3) comes to C + ¼ − ¼ l 2, as is printed, and vanishes", vanishes};

const Emendation quarter{
    "§26, (2), three times", {"½ vv", std::log(2) - 0.005}, {"¼ vv", std::log(2) - 0.0025},
    "half of ½ vv, since 2 was taken out; (3) has it",
    [](double l) { return l == within(std::log(1 + std::sqrt(0.99)), 1e-5, "3/32 of v to the fourth"); }};

const Emendation logarithm_of_two{
    "§26, (3) and (4)", {"¼ l² − ¼, with the square of l 2", std::pow(std::numbers::ln2, 2) / 4 - 0.25},
    {"¼ l 2 − ¼", std::numbers::ln2 / 4 - 0.25},
    "it is the l 2 of §22, and only so the expression vanishes",
    [](double constant) {
      return static_cast<double>(expression(Fifty("1e-6"), Fifty(constant))) == within(0, 1e-12, "vv/16");
    }};
