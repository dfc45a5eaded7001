#include "edition/section.hpp"
#include "exact/series.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 23, "The third column: a series differentiated")

using pendulum::D, pendulum::root_of, pendulum::V;

/*!
## What Euler does

When the descent begins a little farther from the top, the third column too may deserve some attention, whose
terms contain $\cos\alpha\sin^2\alpha$. Before them stands the series

$$ \frac{1\cdot3^2}{2^2\cdot4^2} + \frac{1\cdot3\cdot5^2}{2\cdot4^2\cdot6^2} +
     \frac{1\cdot3\cdot5\cdot7^2}{2\cdot4\cdot6^2\cdot8^2}
   + \frac{1\cdot3\cdot5\cdot7\cdot9^2}{2\cdot4\cdot6\cdot8^2\cdot10^2} + \text{etc.}, \tag{1} $$

and it can be summed without much trouble from what {{sec pendulum.22}} has found,

$$ \begin{aligned} l2 - l\left(1+\sqrt{1-vv}\right) = \frac1{2^2}vv &+ \frac{1\cdot3}{2\cdot4^2}v^4
   + \frac{1\cdot3\cdot5}{2\cdot4\cdot6^2}v^6 \\
   &+ \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8^2}v^8 + \text{etc.} \end{aligned} \tag{2} $$

The terms of {{eq 1}} have one odd factor more than these, squared above as well as below. Factors above come
by differentiating. So he divides by $v$, which makes the powers odd,

$$ \frac{l2}{v} - \frac{l\left(1+\sqrt{1-vv}\right)}{v} = \frac1{2^2}v + \frac{1\cdot3}{2\cdot4^2}v^3 +
     \frac{1\cdot3\cdot5}{2\cdot4\cdot6^2}v^5
   + \text{etc.}, \tag{3} $$

and differentiates. On the left this gives, without the $dv$,

$$ \begin{gathered} -\frac{l2}{vv} + \frac1{vv}\,l\left(1+\sqrt{1-vv}\right)
   + \frac1{\left(1+\sqrt{1-vv}\right)\sqrt{1-vv}}, \\
   \frac1{\left(1+\sqrt{1-vv}\right)\sqrt{1-vv}} = \frac1{vv\sqrt{1-vv}} - \frac1{vv},
   \end{gathered} \tag{4} $$

so that the left side, for which the next section writes $V$, has three parts,

$$ V = -\frac{1+l2}{vv} + \frac1{vv\sqrt{1-vv}} + \frac1{vv}\,l\left(1+\sqrt{1-vv}\right), \tag{5} $$

and on the right the odd numbers have come above,

$$ V = \frac1{2^2} + \frac{1\cdot3^2}{2\cdot4^2}vv + \frac{1\cdot3\cdot5^2}{2\cdot4\cdot6^2}v^4
   + \frac{1\cdot3\cdot5\cdot7^2}{2\cdot4\cdot6\cdot8^2}v^6 + \text{etc.} \tag{6} $$

## The program

The three parts as they stand are a trap for anybody who computes with them: as $v$ gets small each grows
without limit, and of the sum nothing is left.
*/

double part(int which, double v)  // (5)
{
  const double root = root_of(v);
  if(which == 1)
    return -(1 + std::numbers::ln2) / (v * v);
  return (which == 2 ? 1 / root : std::log1p(root)) / (v * v);
}

double three_parts(double v)
{
  return part(1, v) + part(2, v) + part(3, v);
}

/*!
The cure is to write $V = \frac{1}{u(1+u)} - \frac{D(v)}{vv}$, with $u$ for the root, and to take the quotient
$D/vv$ as one thing, near ¼. The function wants the root beside $v$: near $v = 1$ it is the root that tells
how large $V$ is.

::: code pendulum/columns.hpp V
:::

And the series.
*/

double by_series(double v, int terms)  // (6)
{
  double sum = 0;
  double power = 1;  // a_n v²ⁿ⁻²
  for(int n = 1; n <= terms; ++n)
  {
    power *= (2 * n - 1) / (2.0 * n) * (n > 1 ? v * v : 1);
    sum += power * (2 * n - 1) / (2 * n);
  }
  return sum;
}

const auto v = real("v", 0.6, none, open(1e-150, 1), "the variable");
const auto terms = integer("terms", 40, 1, 10'000'000, "terms of the series that are added");

TELL
{
  tell("V", V<double>(v), "V, all digits");
  tell("first", part(1, v), "its first part, −(1 + l 2)/vv");
  tell("second", part(2, v), "its second part, 1/(vv√(1−vv))");
  tell("third", part(3, v), "its third part, l(1+√(1−vv))/vv");
  tell("parts", three_parts(v), "the three parts added");
  tell("series", by_series(v, terms), "the series (6)");
  const double w = v;
  race("V", "V(v)", V(Fifty(w)), {{"three parts, (5)", [=] { return three_parts(w); }},
                                  {"series (6)", [=, n = static_cast<int>(terms)] { return by_series(w,
                                   n); }},
                                  {"in one piece", [=] { return V(w); }}});
}

TELL
{
  curve("parts", {"v", "first", "second", "third", "V"}, [](Curve& c) {
    for(double x = 0.01; x < 0.9995; x += x < 0.97 ? 0.005 : 0.0005)
      c.put({x, part(1, x), part(2, x), part(3, x), V(x)});
  });
}

/*!
At $v$ = {{v}} the parts are {{first|5}}, {{second|5}} and {{third|5}}, their sum is {{V|8}}. Try `--v 1e-8`.

::: figure pendulum-23
alt: The three parts of V and V itself against v from 0 to 1. One part falls to minus infinity as v goes to
zero, two rise to plus infinity; their sum hardly leaves a quarter until v is near 1.

$V$ and the three parts of which it is made. On the left they shoot off to infinity and their sum knows
nothing of it: it goes to ¼. Near $v = 1$ the sum is infinite in earnest.
:::

## Checks

The third column of the array is {{eq 1}}. And {{eq 5}} is {{eq 6}}, an identity between formal power series
in exact fractions: when $vv\,V$ is formed, $l2$ falls out.
*/

CHECK_THAT("(1) is the third column of the array")
{
  CHECK(pendulum::entry(2, 1) == Rational(1 * 9, 4 * 16));
  CHECK(pendulum::entry(3, 1) == Rational(1 * 3 * 25, 2 * 16 * 36));
  CHECK(pendulum::entry(4, 1) == Rational(1 * 3 * 5 * 49, 2 * 4 * 36 * 64));
  CHECK(pendulum::entry(5, 1) == Rational(1LL * 3 * 5 * 7 * 81, 2LL * 4 * 6 * 64 * 100));
}

using Formal = exact::Series<Rational>;

Formal formal_root(int order)
{
  const Formal x = Formal::x(order);
  return sqrt(1 - x * x);
}

CHECK_THAT("the three parts are the derivative of (3), coefficient by coefficient to the 40th power")
{
  const Formal x = Formal::x(42);
  const Formal root = formal_root(42);
  const Formal parts = 1 / root - 1 + log((1 + root) / 2);  // vv V; l(1+√) is l 2 and this logarithm
  for(int n = 1; n <= 20; ++n)
  {
    const Rational term = exact::double_factorial_ratio(n) * (2 * n - 1) / (2 * n);
    CHECK(parts[2 * n] == term);
    CHECK(parts[2 * n + 1] == 0);
  }
  CHECK(x * x / ((1 + root) * root) == 1 / root - 1);  // (4)
}

CHECK_THAT("V is the slope of D/v, sums the series, and keeps its digits everywhere")
{
  for(const double x : {0.05, 0.3, 0.6, 0.95})
  {
    const Fifty h("1e-12");
    const auto D_over = [](const Fifty& at) { return D(at) / at; };
    const Fifty slope = (D_over(Fifty(x) + h) - D_over(Fifty(x) - h)) / (2 * h);
    CHECK(V(Fifty(x)) == within_relative(slope, 1e-18, "the third derivative, at most 10⁵, times hh/6"));
    CHECK(three_parts(x) == within(V(Fifty(x)), 2e-15 / (x * x), "three parts, each at most 2/vv"));
    CHECK(by_series(x, 400) == within_ulps(V(Fifty(x)), 100,
          "falling terms, all positive, at most 400 of them"));
  }
  for(const double x : {1e-150, 1e-8, 1e-4, 1e-2, 0.3, 0.6, 0.9})
    CHECK(V(x) == within_ulps(V(Fifty(x)), 6, "the bound of the function"));
  CHECK(V(1.0, 1e-10) == within_ulps(V(Fifty(1), Fifty(1e-10)), 6, "the root given"));
  CHECK(V(1.0, 1e-10) == within(Fifty("9999999998.30685281964005"), 2e-6,
        "1/u − 1 − l 2 + u, an ulp being 2e-6"));
}

CHECK_THAT("the three parts lose all of it below v = 10⁻⁸")
{
  CHECK(std::abs(three_parts(1e-2) / V(1e-2) - 1) > 1e-13);
  CHECK(std::abs(three_parts(3e-9) / V(3e-9) - 1) > 1);
}

/*!
In the scan the series {{eq 2}} has powers one too low, the digit 1 and the letter $l$ have changed places,
$l2$ has become $l^2$, and a plus a minus; besides, a line of text stands there twice. The readings are tried
at $v = 0{,}6$, the letter $l$ before a fraction being taken as its logarithm and $l^2$ as the square of $l2$.
*/

const auto is_V = [](double reading) {
  return reading == within_relative(V(Fifty(0.6)), 1e-14, "three parts, near 5");
};

double mended(double first, double third_factor)  // (5), with this above the first part and before the third
{
  return first / 0.36 + 1 / (0.36 * 0.8) + third_factor * std::log(1.8);
}

const Emendation powers{
    "§23, (2)", {"v³, v⁵, v⁷", 0.09 + 3 * 0.216 / 32 + 15 * 0.07776 / 288 + 105 * 0.0279936 / 3072},
    {"v⁴, v⁶, v⁸", 0.09 + 3 * 0.1296 / 32 + 15 * 0.046656 / 288 + 105 * 0.01679616 / 3072},
    "the logarithm on the left, at v = 0,6",
    [](double sum) { return sum == within(D(Fifty(0.6)), 3e-4,
        "the fifth term, 1.5e-4, and as much again"); }};

const Emendation plus{
    "§23, (5), first part", {"−(1 − l 2)/vv", mended(-(1 - std::numbers::ln2), 1 / 0.36)},
    {"−(1 + l 2)/vv", mended(-(1 + std::numbers::ln2), 1 / 0.36)}, "both come from (4) with a minus", is_V};

const Emendation two{
    "§23, (4) and (5)", {"l²", mended(-1 - std::pow(std::numbers::ln2, 2), 1 / 0.36)},
    {"l 2", mended(-1 - std::numbers::ln2, 1 / 0.36)}, "it is the l 2 of (2)", is_V};

const Emendation one{
    "§23, (4) and (5), before the last logarithm", {"l/vv", mended(-1 - std::numbers::ln2, -std::log(0.36))},
    {"1/vv", mended(-1 - std::numbers::ln2, 1 / 0.36)}, "it is the derivative of −1/v", is_V};
