#include <array>

#include "edition/section.hpp"
#include "exact/series.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 23, "The third column: a series differentiated")

using pendulum::D, pendulum::root_of, pendulum::V;

/*!
## What Euler does

When the descent begins a little farther from the top, the third column too may deserve some attention, whose
terms contain $\cos\alpha\sin^2\alpha$. They multiply the series

$$ \frac{1\cdot3^2}{2^2\cdot4^2} + \frac{1\cdot3\cdot5^2}{2\cdot4^2\cdot6^2} +
     \frac{1\cdot3\cdot5\cdot7^2}{2\cdot4\cdot6^2\cdot8^2}
   + \frac{1\cdot3\cdot5\cdot7\cdot9^2}{2\cdot4\cdot6\cdot8^2\cdot10^2} + \text{etc.}, \tag{1} $$

whose sum can be found without difficulty from what {{sec pendulum.22}} has found,

$$ \begin{aligned} l2 - l\left(1+\sqrt{1-vv}\right) = \frac1{2^2}vv &+ \frac{1\cdot3}{2\cdot4^2}v^4
   + \frac{1\cdot3\cdot5}{2\cdot4\cdot6^2}v^6 \\
   &+ \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8^2}v^8{{entry powers}} + \text{etc.} \end{aligned}
   \tag{2} $$

In {{eq 1}} the last odd factor is squared as well; a derivative will supply it. He divides by $v$, which
makes the powers odd,

$$ \begin{aligned} \frac{l2}{v} - \frac{l\left(1+\sqrt{1-vv}\right)}{v} = \frac1{2^2}v
   &+ \frac{1\cdot3}{2\cdot4^2}v^3 + \frac{1\cdot3\cdot5}{2\cdot4\cdot6^2}v^5 \\
   &+ \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8^2}v^7 + \text{etc.}, \end{aligned} \tag{3} $$

and differentiates. Without the $dv$ the left side becomes

$$ -\frac{l2}{vv} + \frac1{vv}\,l\left(1+\sqrt{1-vv}\right)
   + \frac1{\left(1+\sqrt{1-vv}\right)\sqrt{1-vv}}, \tag{4} $$

whose last member is $\frac1{vv\sqrt{1-vv}} - \frac1{vv}$. So the left side, which {{sec pendulum.24}} will
call $V$, has three parts,

$$ V = -\frac{1+l2}{vv}{{entry letters}} +
\frac1{vv\sqrt{1-vv}} + \frac1{vv}\,l\left(1+\sqrt{1-vv}\right). \tag{5} $$

On the right the odd numbers have come above:

$$ V = \frac1{2^2} + \frac{1\cdot3^2}{2\cdot4^2}vv + \frac{1\cdot3\cdot5^2}{2\cdot4\cdot6^2}v^4
   + \frac{1\cdot3\cdot5\cdot7^2}{2\cdot4\cdot6\cdot8^2}v^6 + \text{etc.} \tag{6} $$

## The program

To compute with, the three parts as they stand are a trap: as $v$ gets small each grows without limit, and of
the sum nothing is left.
*/

std::array<double, 3> parts(double v)  // (5)
{
  const double vv = v * v;
  const double u = root_of(v);
  return {-(1 + std::numbers::ln2) / vv, 1 / (vv * u), std::log(1 + u) / vv};
}

double three_parts(double v)
{
  const auto [first, second, third] = parts(v);
  return first + second + third;
}

/*!
The cure is to write $V = \frac{1}{u(1+u)} - \frac{D(v)}{vv}$, where $u$ is the root and $D$ the left side of
{{eq 2}}, and to take the quotient $D/vv$, near ¼, as one thing. The function wants the root beside $v$: near
$v = 1$ it is the root that tells how large $V$ is.

::: code pendulum/columns.hpp V
:::

And the series.
*/

double by_series(double v, int terms)  // (6)
{
  double sum = 0;
  double power = 0.5;  // ½·¾···(2n−1)/2n v²ⁿ⁻²
  for(int n = 1; n <= terms; ++n)
  {
    sum += power * (2 * n - 1) / (2 * n);
    power *= (2 * n + 1) / (2. * n + 2) * v * v;
  }
  return sum;
}

const auto v = real("v", 0.6, none, open(1e-150, 1), "the variable");

TELL
{
  const auto [first, second, third] = parts(v);
  tell("first", first, "the first part, −(1 + l 2)/vv");
  tell("second", second, "the second, 1/(vv√(1−vv))");
  tell("third", third, "the third, l(1+√(1−vv))/vv");
  tell("sum", first + second + third, "the three parts added");
  tell("V", V<double>(v), "V, all digits");
  tell("series", by_series(v, 40), "forty terms of the series (6)");
}

TELL
{
  curve("parts", {"v", "first", "second", "third", "V"}, [](Curve& c) {
    for(double x = 0.01; x < 0.9995; x += x < 0.97 ? 0.005 : 0.0005)
      c.put({x, parts(x)[0], parts(x)[1], parts(x)[2], V(x)});
  });
}

/*!
At $v$ = {{v}} the parts are {{first|5}}, {{second|5}} and {{third|5}}; their sum is {{V|8}}. Try
`--v 1e-8`.

::: figure pendulum-23
alt: The three parts of V and V itself against v from 0 to 1. One part falls to minus infinity as v goes to
zero, two rise to plus infinity; their sum hardly leaves a quarter until v is near 1.

$V$ and the three parts of which it is made. On the left they shoot off to infinity and their sum knows
nothing of it: it goes to ¼. Near $v = 1$ the sum is infinite in earnest.
:::

## Checks

That {{eq 5}} is {{eq 6}} is an identity between formal power series in exact fractions: in $vv\,V$ the $l2$
falls out.
*/

CHECK_THAT("(1) is the third column of the array")
{
  CHECK(pendulum::entry(2, 1) == Rational(1 * 9, 4 * 16));
  CHECK(pendulum::entry(3, 1) == Rational(1 * 3 * 25, 2 * 16 * 36));
  CHECK(pendulum::entry(4, 1) == Rational(1 * 3 * 5 * 49, 2 * 4 * 36 * 64));
  CHECK(pendulum::entry(5, 1) == Rational(1 * 3 * 5 * 7 * 81, 2 * 4 * 6 * 64 * 100));
}

CHECK_THAT("the three parts are the derivative of (3), coefficient by coefficient to the 40th power")
{
  using Formal = exact::Series<Rational>;
  const Formal x = Formal::x(42);
  const Formal root = sqrt(1 - x * x);
  const Formal last = x * x / ((1 + root) * root), two_parts = 1 / root - 1;
  for(int n = 0; n <= 40; ++n)
    CHECK(last[n] == two_parts[n]);                       // (4)
  const Formal sum = 1 / root - 1 + log((1 + root) / 2);  // vv V; l(1+√) is l 2 and this logarithm
  for(int n = 1; n <= 20; ++n)
  {
    CHECK(sum[2 * n] == exact::double_factorial_ratio(n) * (2 * n - 1) / (2 * n));
    CHECK(sum[2 * n + 1] == 0);
  }
}

CHECK_THAT("V sums the series, and so do the three parts, as far as sixteen digits let them")
{
  for(const double x : {0.05, 0.3, 0.6, 0.95})
  {
    CHECK(by_series(x, 400) == within_ulps(V(Fifty(x)), 20, "falling terms, all positive"));
    CHECK(three_parts(x) == within(V(Fifty(x)), 1e-15 / (x * x), "three parts, each at most 2/vv"));
  }
}

CHECK_THAT("V keeps its digits where the parts have lost theirs, and where only the root tells")
{
  CHECK(V(1e-8) == within_ulps(V(Fifty(1e-8)), 2, "a logarithm and three quotients"));
  CHECK(std::abs(three_parts(1e-8) - 0.25) >= 0.25);  // near 10¹⁶ all doubles are whole numbers
  CHECK(V(1.0, 1e-10)
        == within_ulps(Fifty("9999999998.30685281964005469056"), 2, "1/u − 1 − l 2 + u at u = 10⁻¹⁰"));
}

/*!
In our copy the series {{eq 2}} has powers one too low; in {{eq 4}} and {{eq 5}} the digit 1 has become the
letter $l$, $l2$ has become $l^2$, and a plus a minus; besides, a line of text stands there twice. The
readings are tried at $v = \frac12$, the letter $l$ before a fraction being taken as its logarithm.
*/

double four_terms(int p)  // of (2) at v = ½, with the powers p, p + 2, ... after vv
{
  return 0.0625 + std::pow(0.5, p) * (3. / 32 + 15. / 288 * 0.25 + 105. / 3072 * 0.0625);
}

const Emendation powers{"§23, (2)",
                        {"v³, v⁵, v⁷", four_terms(3)},
                        {"v⁴, v⁶, v⁸", four_terms(4)},
                        "the logarithm on the left, at v = ½",
                        [](double sum) {
                          return sum
                                 == within(D(Fifty(0.5)), 4e-5, "the fifth term, 2.4e-5, and a third more");
                        }};

const double l2 = std::numbers::ln2;

const Emendation letters{
    "§23, (5), and likewise (4)",
    {"−(1 − l²)/vv + l/(vv√(1−vv)) + l/vv l(1+√(1−vv))",
     -4 * (1 - l2 * l2) - std::log(0.25 * root_of(0.5)) - std::log(0.25) * std::log(1 + root_of(0.5))},
    {"−(1 + l 2)/vv + 1/(vv√(1−vv)) + 1/vv l(1+√(1−vv))", three_parts(0.5)},
    "the series (6), at v = ½",
    [](double sum) { return sum == within(by_series(0.5, 60), 4e-15, "three parts, near 6"); }};

/*!
What is told, in the middle, where the parts are huge, and near 1:
*/

Fifty V_by_logarithm(const Fifty& x)  // (5) in fifty digits, less the digits that the parts cancel
{
  const Fifty xx = x * x, u = sqrt((1 - x) * (1 + x));
  return (1 / u - 1 + log((1 + u) / 2)) / xx;
}

CHECK_THAT("the parts told are those of (5), and V is their sum in fifty digits")
{
  for(const Told& now : told_at("", "v=1e-8", "v=0.999"))
  {
    const Fifty x = v.fifty(), xx = x * x, u = sqrt((1 - x) * (1 + x)), truth = V_by_logarithm(x);
    const double near_one = 1e-15 + 2e-16 / static_cast<double>(1 - x),
                 rounded = 3e-16 / static_cast<double>(xx);
    CHECK(now.value("first")
          == within_relative(-(1 + exact::ln2()) / xx, 1e-15, "a square and a quotient"));
    CHECK(now.value("second") == within_relative(1 / (xx * u), near_one, "the root of a rounded v"));
    CHECK(now.value("third") == within_relative(log(1 + u) / xx, near_one, "the root of a rounded v"));
    CHECK(now.value("sum")
          == within(truth, 8 * rounded + near_one / static_cast<double>(u), "three parts, rounded"));
    CHECK(now.value("V") == within_relative(truth, near_one, "the root of a rounded v"));
    Fifty series = 0;
    for(int n = 1; n <= 40; ++n)
      series +=
          static_cast<Fifty>(exact::double_factorial_ratio(n) * (2 * n - 1) / (2 * n)) * pow(xx, n - 1);
    CHECK(now.value("series") == within_relative(series, 1e-14, "forty roundings, all terms positive"));
  }
}

CHECK_THAT("the figure's curves are the three parts and V")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("parts", 6))
    {
      const Fifty x(point.at("v")), xx = x * x, u = sqrt((1 - x) * (1 + x));
      CHECK(point.value("first") == within_relative(-(1 + exact::ln2()) / xx, 1e-15, "few roundings"));
      CHECK(point.value("second") == within_relative(1 / (xx * u), 1e-15, "few roundings"));
      CHECK(point.value("third")
            == within(log(1 + u) / xx, 3e-16 / static_cast<double>(xx), "1 + u rounds"));
      CHECK(point.value("V") == within_relative(V_by_logarithm(x), 2e-15, "few roundings"));
    }
}

/*!
## Go on from here

::: exercise
To how many decimals do the three parts, added as they stand, give $V$ at $v = 10^{-4}$?

answer: To seven or eight: the parts are of the size of $10^8$, a double near that is rounded by
$10^{-8}$, and $V$ itself is 0.250000003. At $10^{-8}$ nothing is left.
:::
*/

CHECK_THAT("at v = 10⁻⁴ the three parts give V to some 10⁻⁸, and V is ¼ and 3·10⁻⁹")
{
  for(const Told& now : told_at("v=1e-4"))
  {
    CHECK(now.value("V") == within(0.250000003, 0.5e-9, "9/32 vv above a quarter"));
    CHECK(now.value("sum") == within(V_by_logarithm(v.fifty()), 6e-8, "three parts up to 2·10⁸, rounded"));
  }
}
