#include <vector>

#include <gsl/gsl_sum.h>

#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 22, "The second column sums to l 2")

using pendulum::D;

/*!
## What Euler does

The second column of the array sums to the logarithm of two. Its terms,
in {{sec pendulum.21}}, have nothing but $\cos\alpha$ in common, and this stands before an infinite series:

$$ \begin{aligned} \frac1{2^2} &+ \frac{1\cdot3}{2\cdot4^2} + \frac{1\cdot3\cdot5}{2\cdot4\cdot6^2}
   + \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8^2} \\
   &+ \frac{1\cdot3\cdots9}{2\cdot4\cdots8\cdot10^2} + \frac{1\cdot3\cdots11}{2\cdot4\cdots10\cdot12^2}
   + \text{etc.} \end{aligned} \tag{1} $$

To sum it he goes back to a series that everybody knows,

$$ \begin{aligned} \frac1{\sqrt{1-vv}} = 1 &+ \frac12vv + \frac{1\cdot3}{2\cdot4}v^4
   + \frac{1\cdot3\cdot5}{2\cdot4\cdot6}v^6 \\
   &+ \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8}v^8 + \text{etc.} \end{aligned} \tag{2} $$

Divided by $v$, multiplied by $dv$ and integrated it gets just the denominators that are wanted,

$$ \begin{aligned} \int\frac{dv}{v\sqrt{1-vv}} = lv &+ \frac1{2^2}vv + \frac{1\cdot3}{2\cdot4^2}v^4
   + \frac{1\cdot3\cdot5}{2\cdot4\cdot6^2}v^6 \\
   &+ \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8^2}v^8 + \text{etc.}, \end{aligned} \tag{3} $$

so that the sum is $\int\frac{dv}{v\sqrt{1-vv}} - lv$, when $v = 1$ is put after the integration. He calls
the root $u$: then $vv = 1 - uu$, $2lv = l(1-uu)$, $\frac{dv}v = -\frac{u\,du}{1-uu}$, and

$$ \begin{aligned} \int\frac{dv}{v\sqrt{1-vv}} &= -\int\frac{du}{1-uu} = -\tfrac12\,l\,\frac{1+u}{1-u} \\
   &= -l(1+u) + \tfrac12\,l(1-uu) + C. \end{aligned} \tag{4} $$

With the root put back, the last logarithm is $lv$, and it goes out:

$$ \int\frac{dv}{v\sqrt{1-vv}} - lv = C - l\left(1 + \sqrt{1-vv}\right). \tag{5} $$

This must vanish with $v$, as the series does, so $C = l2$. And for $v = 1$ the sum of the series is known:

$$ \frac1{2^2} + \frac{1\cdot3}{2\cdot4^2} + \frac{1\cdot3\cdot5}{2\cdot4\cdot6^2} +
     \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8^2}
   + \text{etc.} = l2. \tag{6} $$

So what was lacking of the time was not a quarter, as after two terms, but $l2\cdot\cos\alpha$.

## The program

The function that he has found on the way will be wanted again and gets a name,
$D(v) = l2 - l(1+\sqrt{1-vv})$. As it stands it loses everything when $v$ is small, since both logarithms
are then the same. Nothing is lost when it is made one logarithm of $1 - q$, with
$q = \frac12(1-\sqrt{1-vv})$:

::: code pendulum/columns.hpp half_versine
:::

::: code pendulum/columns.hpp D
:::

The series is added as it stands. How far its first $N$ terms fall short can be said exactly enough, by a
device as simple as his own. With $a_n$ for the coefficients of {{eq 2}}, $a_{n-1} - a_n = \frac{a_n}{2n-1}$
and $a_n - a_{n+1} = \frac{a_n}{2n+2}$; the terms of {{eq 1}}, $\frac{a_n}{2n}$, lie between, and so

$$ a_{N+1} < l2 - \sum_{n=1}^N \frac{a_n}{2n} < a_N. \tag{7} $$
*/

struct Partial
{
  double sum = 0;    // of the first N terms of (3), without lv
  double a = 1;      // a_N
  double power = 1;  // v²ᴺ
};

Partial partial(double v, int terms)  // (3)
{
  Partial p;
  for(int n = 1; n <= terms; ++n)
  {
    p.a *= (2 * n - 1.0) / (2 * n);
    p.power *= v * v;
    p.sum += p.a * p.power / (2 * n);
  }
  return p;
}

double with_tail(int N)  // the sum, and (2a_N + a_{N+1})/3 for what is missing
{
  const Partial p = partial(1, N);
  return p.sum + p.a * (1 - 1.0 / (6 * (N + 1)));
}

/*!
Between the bounds the truth lies a third of the way down, the nearer the larger $N$ is; so the upper one
should count twice in their mean. A modern peer: the transformation of Levin, which guesses the limit from
the way in which the sums approach it.
*/

double by_levin(int terms)
{
  std::vector<double> series(static_cast<std::size_t>(terms));
  for(int n = 1; n <= terms; ++n)
    series[static_cast<std::size_t>(n - 1)] = partial(1, n).a / (2 * n);
  gsl_sum_levin_utrunc_workspace* const workspace = gsl_sum_levin_utrunc_alloc(series.size());
  double sum = 0;
  double error = 0;
  gsl_sum_levin_utrunc_accel(series.data(), series.size(), workspace, &sum, &error);
  gsl_sum_levin_utrunc_free(workspace);
  return sum;
}

const auto v = real("v", 1.0, none, closed(0, 1), "the variable of the series; Euler puts 1 in the end");
const auto terms = integer("N", 6, 1, 10'000'000, "terms that are added; Euler writes six");

TELL
{
  const Partial p = partial(v, terms);
  tell("D", D<double>(v), "the sum of the series in v; l 2 for v = 1");
  tell("sum", p.sum, "its first N terms");
  tell("short_by", D<double>(v) - p.sum, "what they leave out");
  if(v == 1)
  {
    tell("least", p.a * (2 * terms + 1.0) / (2 * terms + 2.0), "more than this, by (7)");
    tell("most", p.a, "less than this");
  }
  tell("for_15_digits", 1e30 / std::numbers::pi, "terms wanted to come within 10⁻¹⁵ of l 2");
}

/*!
The ways to the sum, by what each makes of the same number of terms.
*/

TELL
{
  curve("errors", {"terms", "plain", "mean", "levin"}, [](Curve& c) {
    for(int n = 1; n <= 1000; n += 1 + n / 6)
    {
      const auto error = [](double x) { return std::abs(x - std::numbers::ln2); };
      const double levin = n <= 14 ? error(by_levin(n + 1)) : infinity;
      c.put({1.0 * n, error(partial(1, n).sum), error(with_tail(n)), levin});
    }
  });
  race("sum", "the sum (6)", exact::ln2(),
       {{"6 terms", [] { return partial(1, 6).sum; }, "plain"},
        {"1000 terms", [] { return partial(1, 1000).sum; }, "plain"},
        {"6 terms and a mean of (7)", [] { return with_tail(6); }, "mean"},
        {"1000 terms and a mean of (7)", [] { return with_tail(1000); }, "mean"},
        {"GSL, Levin's u, 12 terms", [] { return by_levin(12); }},
        {"Euler's logarithm", [] { return D(1.0); }}});
}

/*!
The six terms that he writes make {{sum|6}}, and {{short_by|3}} is still to come: hardly anybody would guess
the sum. To get fifteen digits by adding, {{for_15_digits|e1}} terms would be needed.

::: figure pendulum-22
alt: Error of the sum against the number of terms, both logarithmic. The plain sum falls along a line of
slope minus one half; with a mean of the bounds it falls five times as steeply; Levin's transformation comes
to a ten thousand millionth within a dozen terms.

What is missing of $l2$ after $N$ terms. The plain sum creeps: a hundred times the work for one digit more.
With the mean of the bounds {{eq 7}} tenfold work gives two and a half digits. A transformation made for
such series finds ten digits in a dozen terms, and then stops, because the terms are rounded. Euler's
logarithm has all digits and needs no term at all.
:::

## Checks

The law of the second column, then the function against quadrature: the integral in {{eq 5}}, less the
logarithm, is that of $\left(\frac1{\sqrt{1-vv}} - 1\right)\frac{dv}{v}$ from 0.
*/

CHECK_THAT("(1) is the second column of the array")
{
  for(int n = 1; n <= 12; ++n)
    CHECK(pendulum::entry(n, 0) == exact::double_factorial_ratio(n) / (2 * n));
}

CHECK_THAT("D(v) is the integral that it comes from")
{
  for(const double x : {1e-3, 0.3, 0.6, 0.99})
  {
    const Fifty area = exact::integrate([](const Fifty& y) {
      const Fifty root = sqrt((1 - y) * (1 + y));
      return y / (root * (1 + root));  // (1/√(1−yy) − 1)/y
    }, 0, Fifty(x)).value;
    CHECK(D(Fifty(x)) == within_relative(area, 1e-38, "the quadrature's 10⁻⁴⁰"));
  }
}

CHECK_THAT("D(v) sums the series, and keeps its digits however small v is")
{
  CHECK(D(Fifty(1)) == within(exact::ln2(), 1e-49, "a logarithm of fifty digits"));
  for(const double x : {1e-150, 1e-8, 1e-4, 0.1, 0.5, 0.9})
    CHECK(D(x) == within_ulps(D(Fifty(x)), 4, "the bound of the function"));
  for(const double x : {1e-8, 0.1, 0.5, 0.9})
    CHECK(partial(x, 200).sum == within_relative(D(Fifty(x)), 1e-14, "at 0.9 two hundred terms leave 10⁻²¹"));
  CHECK(std::numbers::ln2 - std::log(1 + std::sqrt(1 - 1e-16)) == 0);  // as it is written, at v = 10⁻⁸
}

CHECK_THAT("the bounds (7) hold")
{
  for(const int n : {1, 2, 6, 100, 10'000})
  {
    const Partial p = partial(1, n);
    const Fifty missing = exact::ln2() - Fifty(p.sum);
    CHECK(missing == between(p.a * (2 * n + 1) / (2 * n + 2), p.a, "(7)"));
    CHECK(with_tail(n) == within(exact::ln2(), p.a / (9.0 * n * n),
          "the tail's next term is a tenth of a_N/NN"));
  }
}

/*!
Readings of the scan, each tried at a point. In {{eq 3}} the first coefficient has lost its square, and the
powers are one too low; a minus sign has become a sign of equality; and in {{eq 4}} there is a $u$ too many.
*/

double four_terms(double first,
    int above)  // (3) at v = ½, with this first coefficient and the powers 2, 3 + above, ...
{
  return std::log(0.5) + first / 4 + 3.0 / 32 * std::pow(0.5, 3 + above)
      + 15.0 / 288 * std::pow(0.5, 5 + above)
         + 105.0 / 3072 * std::pow(0.5, 7 + above);
}

const Emendation integrated{
    "§22, (3)", {"½ vv, v³, v⁵, v⁷", four_terms(0.5, 0)}, {"1/2² vv, v⁴, v⁶, v⁸", four_terms(0.25, 1)},
    "four terms must come near to (5) at v = ½",
    [](double sum) {
      return sum == within(D(Fifty(0.5)) + log(Fifty(0.5)), 5e-5, "the fifth, 2.4e-5, and a third more");
    }};

const Emendation minus{
    "§22, the formula for the sum", {"∫ dv/(v√(1−vv)) = l v, v = 1", 0.0},
    {"∫ dv/(v√(1−vv)) − l v, v = 1", D(1.0)}, "the sum is more than its first six terms",
    [](double sum) { return sum > partial(1, 6).sum; }};

const Emendation middle{
    "§22, (4)", {"−∫ u du/(1−uu)", 0.5 * std::log(1 - 0.36)}, {"−∫ du/(1−uu)", -std::atanh(0.6)},
    "the logarithm that follows is its value, here from 0 to u = 0,6",
    [](double integral) { return integral == within_ulps(-log(Fifty(4)) / 2, 2, "½ l (1,6/0,4) is ½ l 4"); }};
