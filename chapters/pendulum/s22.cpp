#include <vector>

#include <gsl/gsl_sum.h>

#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 22, "The second column sums to l 2")

using pendulum::D;

/*!
## What Euler does

The second column of the array sums to the logarithm of two. All its terms in {{sec pendulum.21}} have just
the factor $\cos\alpha$, which multiplies the infinite series

$$ \begin{aligned} \frac1{2^2} &+ \frac{1\cdot3}{2\cdot4^2} + \frac{1\cdot3\cdot5}{2\cdot4\cdot6^2}
   + \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8^2} \\
   &+ \frac{1\cdot3\cdots9}{2\cdot4\cdots8\cdot10^2} + \frac{1\cdot3\cdots11}{2\cdot4\cdots10\cdot12^2}
   + \text{etc.} \end{aligned} \tag{1} $$

To sum it he considers, more generally,

$$ \begin{aligned} \frac1{\sqrt{1-vv}} = 1 &+ \frac12vv + \frac{1\cdot3}{2\cdot4}v^4
   + \frac{1\cdot3\cdot5}{2\cdot4\cdot6}v^6 \\
   &+ \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8}v^8 + \text{etc.} \end{aligned} \tag{2} $$

Divided by $v$ it begins with $\frac1v + \frac12v$; multiplied by $dv$ and integrated it gets just the
denominators that are wanted,

$$ \begin{aligned} \int\frac{dv}{v\sqrt{1-vv}} = lv &+ \frac1{2^2}vv{{entry integrated}} +
\frac{1\cdot3}{2\cdot4^2}v^4
   + \frac{1\cdot3\cdot5}{2\cdot4\cdot6^2}v^6 \\
   &+ \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8^2}v^8 + \text{etc.}, \end{aligned} \tag{3} $$

so that the sum is $\int\frac{dv}{v\sqrt{1-vv}} - lv$ {{entry minus}}, when $v = 1$ is put after the
integration. He calls
the root $u$. With $vv = 1 - uu$, $2lv = l(1-uu)$ and $\frac{dv}v = -\frac{u\,du}{1-uu}$ the integral is

$$ \begin{aligned} \int\frac{dv}{v\sqrt{1-vv}} &= -\int\frac{du}{1-uu}{{entry middle}} =
-\tfrac12\,l\,\frac{1+u}{1-u} \\
   &= -l(1+u) + \tfrac12\,l(1-uu) + C. \end{aligned} \tag{4} $$

With the root put back, the last logarithm is $lv$ and goes out:

$$ \int\frac{dv}{v\sqrt{1-vv}} - lv = C - l\left(1 + \sqrt{1-vv}\right). \tag{5} $$

This must vanish at $v = 0$, which gives $C = l2$. And for $v = 1$ the sum of the series is known:

$$ \frac1{2^2} + \frac{1\cdot3}{2\cdot4^2} + \frac{1\cdot3\cdot5}{2\cdot4\cdot6^2} +
     \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8^2}
   + \text{etc.} = l2. \tag{6} $$

## The program

The function found on the way will be wanted again and gets a name, $D(v) = l2 - l(1+\sqrt{1-vv})$. As it
stands it loses everything when $v$ is small, since the two logarithms are then equal. Nothing is lost in
$-l(1-q)$, with $q = \frac12(1-\sqrt{1-vv})$ found without a difference:

::: code pendulum/columns.hpp half_versine
:::

::: code pendulum/columns.hpp D (5)
:::

The series is added as it stands. Let $a_n$ be the coefficients of {{eq 2}}, so that the terms of {{eq 1}} are
$\frac{a_n}{2n}$. The difference $a_{n-1} - a_n = \frac{a_n}{2n-1}$ is more than this
and the next, $a_n - a_{n+1} = \frac{a_n}{2n+2}$, is less; so what the first $N$ terms leave out is caught:

$$ a_{N+1} < l2 - \sum_{n=1}^N \frac{a_n}{2n} < a_N. \tag{A} $$
*/

struct Partial
{
  double sum = 0;   // of the first N terms of (3), without lv
  double last = 1;  // a_N v²ᴺ
};

Partial partial(double v, int terms)  // (3)
{
  Partial p;
  for(int n = 1; n <= terms; ++n)
  {
    p.last *= (2 * n - 1.0) / (2 * n) * v * v;
    p.sum += p.last / (2 * n);
  }
  return p;
}

/*!
What the first $N$ terms leave out is the difference, where enough of its digits are left, and else the sum of
those that follow: where they fall fast not many are wanted.
*/

double left_out(double v, int terms)
{
  const double falls = (1 - v) * (1 + v);  // a term is less than vv times the one before
  const Partial kept = partial(v, terms);
  if(falls < 0.01 && terms * falls < 4)
    return D(v) - kept.sum;
  double sum = 0, last = kept.last;
  for(int n = terms + 1; n <= terms + 40 / falls + 1 && last > 0; ++n)
  {
    last *= (2 * n - 1.0) / (2 * n) * v * v;
    sum += last / (2 * n);
  }
  return sum;
}

/*!
Another way is Levin's transformation, which guesses the limit from the way in which the sums approach it.
*/

double by_levin(int terms)
{
  std::vector<double> series;
  for(int n = 1; n <= terms; ++n)
    series.push_back(partial(1, n).last / (2 * n));
  auto* const workspace = gsl_sum_levin_utrunc_alloc(series.size());
  double sum = 0, error = 0;
  gsl_sum_levin_utrunc_accel(series.data(), series.size(), workspace, &sum, &error);
  gsl_sum_levin_utrunc_free(workspace);
  return sum;
}

const auto v = real("v", 1.0, none, closed(0, 1), "the variable of the series; Euler puts 1 in the end");
const auto terms = integer("N", 6, 1, 10'000'000, "terms that are added; Euler writes six");

TELL
{
  tell("D", D<double>(v), "the sum of the series in v; l 2 for v = 1");
  tell("sum", partial(v, terms).sum, "its first N terms");
  tell("short_by", left_out(v, terms), "what they leave out", 6);
  tell("for_15_digits", 1e30 / std::numbers::pi, "terms needed to come within 10⁻¹⁵ of l 2, by (A)", 2);
  tell("levin_off", std::abs(by_levin(12) - std::numbers::ln2),
       "the error of Levin's transformation, 12 terms", 1);
}

TELL
{
  curve("errors", {"terms", "plain", "levin"}, [](Curve& c) {
    for(int n = 1; n <= 1000; n += 1 + n / 8)
    {
      const double levin = n <= 14 ? std::abs(by_levin(n) - std::numbers::ln2) : std::nan("");
      c.put({1. * n, std::numbers::ln2 - partial(1, n).sum, levin});
    }
  });
}

/*!
The six terms that he writes make {{sum|6}}, and {{short_by|3}} is still to come: that is nearly a third of
the whole.
To get fifteen digits by adding, {{for_15_digits|e1}} terms would be needed. So the whole column brings
$l2\cdot\cos\alpha$ to the time, where {{sec pendulum.17}}, after two terms, had a quarter of $\cos\alpha$.

::: figure pendulum-22
alt: Error of the sum against the number of terms, both logarithmic. The plain sum falls along a line of
slope minus one half; Levin's transformation comes to a ten thousand millionth within a dozen terms.

What is missing of $l2$ after $N$ terms. The plain sum creeps: a hundred times the work for one digit more.
Levin's transformation, made for such series, comes within {{levin_off|e1}} in a dozen terms; then it stops,
because it magnifies the rounding of the terms. Euler's logarithm needs no term at all.
:::

## Speed against error
*/

TELL
{
  race("whole", "the sum (6)", exact::ln2(),
       {{"6 terms", [] { return partial(1, 6).sum; }, "plain"},
        {"1000 terms", [] { return partial(1, 1000).sum; }, "plain"},
        {"GSL, Levin's u, 12 terms", [] { return by_levin(12); }},
        {"Euler's logarithm", [] { return D(1.0); }}});
}

/*!
## Checks

The integral in {{eq 5}}, less the logarithm, is that of $\left(\frac1{\sqrt{1-vv}} - 1\right)\frac{dv}{v}$
from 0.
*/

CHECK_THAT("(1) is the second column of the array")
{
  for(int n = 1; n <= 12; ++n)
    CHECK(pendulum::entry(n, 0) == exact::double_factorial_ratio(n) / (2 * n));
}

CHECK_THAT("D(v) is the integral that it comes from, and at v = 1 it is l 2")
{
  for(const double x : {1e-3, 0.3, 0.6, 0.99})
  {
    const auto f = [](const Fifty& y) {
      const Fifty root = sqrt((1 - y) * (1 + y));
      return y / (root * (1 + root));  // (1/√(1−yy) − 1)/y
    };
    CHECK(D(Fifty(x))
          == within_relative(exact::integrate(f, 0, x).value, 1e-46, "roundings of fifty digits"));
  }
  CHECK(D(Fifty(1)) == within(exact::ln2(), 1e-49, "a logarithm of fifty digits"));
}

CHECK_THAT("D(v) sums the series, where l 2 − l(1+√(1−vv)) as it stands has lost everything")
{
  for(const double x : {1e-8, 0.1, 0.5, 0.9})
    CHECK(partial(x, 200).sum
          == within_relative(D(Fifty(x)), 2e-15, "at 0.9 two hundred terms leave 10⁻²¹"));
  CHECK(std::numbers::ln2 - std::log(1 + std::sqrt(1 - 1e-16)) == 0);  // at v = 10⁻⁸
}

CHECK_THAT("the bounds (A) hold")
{
  for(const int n : {1, 2, 6, 100, 10'000})
  {
    const Partial p = partial(1, n);
    CHECK(exact::ln2() - p.sum == between(p.last * (2 * n + 1) / (2 * n + 2), p.last, "(A)"));
  }
}

/*!
Readings of our copy, each tried at a point. In {{eq 3}} the first coefficient has lost its square, and the
powers are one too low; a minus sign has become a sign of equality; and in {{eq 4}} there is a $u$ too many.
*/

double four_terms(double first, int p)  // of (3), v = ½: first coefficient, powers p, p + 2, ...
{
  return std::log(0.5) + first / 4 + std::pow(0.5, p) * (3. / 32 + 15. / 288 * 0.25 + 105. / 3072 * 0.0625);
}

const Emendation integrated{
    "§22, (3)",
    {"½ vv, v³, v⁵, v⁷", four_terms(0.5, 3)},
    {"1/2² vv, v⁴, v⁶, v⁸", four_terms(0.25, 4)},
    "four terms must come near to (5) at v = ½",
    [](double sum) {
      return sum == within(D(Fifty(0.5)) + log(Fifty(0.5)), 4e-5, "the fifth, 2.4e-5, and a third more");
    }};

const Emendation minus{"§22, the formula for the sum",
                       {"∫ dv/(v√(1−vv)) = l v, v = 1", 0.0},
                       {"∫ dv/(v√(1−vv)) − l v, v = 1", D(1.0)},
                       "the sum is more than its first six terms",
                       [](double sum) {
                         const Partial six = partial(1, 6);
                         return sum == between(six.sum + six.last * 13 / 14, six.sum + six.last, "(A)");
                       }};

const Emendation middle{"§22, (4)",
                        {"−∫ u du/(1−uu)", 0.5 * std::log(1 - 0.36)},
                        {"−∫ du/(1−uu)", -std::atanh(0.6)},
                        "the logarithm that follows is its value, here from 0 to u = 0.6",
                        [](double integral) {
                          return integral == within_ulps(-log(Fifty(4)) / 2, 2, "½ l (1.6/0.4) is ½ l 4");
                        }};

/*!
What is told, at 1, where the terms fall fast, and where $v$ is as small as a thousandth. What is left out is
held against as many terms more as fifty digits want:
*/

Fifty terms_of_series(const Fifty& x, int N)  // (3) without lv, in fifty digits
{
  Fifty sum = 0, a = 1;
  for(int n = 1; n <= N; ++n)
  {
    a *= x * x * (2 * n - 1) / (2 * n);
    sum += a / (2 * n);
  }
  return sum;
}

CHECK_THAT("the sum told is the logarithm, and its terms are the series'")
{
  for(const Told& now :
      told_at("", "v=0.6 N=3", "v=0.001 N=1", "v=0.001 N=3", "v=0.999 N=1500", "v=0.999 N=2500"))
  {
    const Fifty x = v.fifty(), D_ = log(2 / (1 + sqrt((1 - x) * (1 + x))));
    const Fifty sum = terms_of_series(x, terms);
    CHECK(
        now.value("D")
        == within_relative(D_, x > Fifty("0.99") ? 1e-14 : 1e-15, "the library's bound, and an ulp of v"));
    CHECK(now.value("sum") == within_relative(sum, x > Fifty("0.99") ? 1e-14 : 1e-15, "roundings"));
    const Fifty left = x == 1 ? Fifty(D_ - sum) : Fifty(terms_of_series(x, terms + 25'000) - sum);
    CHECK(now.value("short_by") == within_relative(left, 1e-9, "six digits are told"));
    CHECK(now.value("for_15_digits")
          == within_relative(1 / (exact::pi() * pow(Fifty("1e-15"), 2)), 1e-15, "a_N is nearly 1/√(πN)"));
    CHECK(now.value("levin_off") == between(1e-11, 1e-9, "it magnifies the rounding of the terms"));
    CHECK(now.exact("whole") == within_relative(log(Fifty(2)), 1e-49, "two ways of fifty digits"));
    CHECK(now.method("whole", "6 terms") == within_relative(terms_of_series(1, 6), 1e-15, "few roundings"));
    CHECK(now.method("whole", "1000 terms")
          == within_relative(terms_of_series(1, 1000), 1e-14, "roundings"));
    CHECK(now.method("whole", "GSL, Levin's u, 12 terms") == within(exact::ln2(), 1e-9, "as above"));
    CHECK(now.method("whole", "Euler's logarithm") == within_ulps(exact::ln2(), 1, "a logarithm"));
  }
}

CHECK_THAT("the figure has what the plain sum leaves out, and Levin's errors as they fall below it")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("errors", 20))
    {
      const int n = static_cast<int>(point.at("terms"));
      const Fifty rest = exact::ln2() - terms_of_series(1, n);
      CHECK(point.value("plain") == within(rest, 1e-14, "n roundings"));
      if(n > 2 && n <= 14)
        CHECK(point.value("levin")
              == between(0, static_cast<double>(rest) * std::pow(0.2, n - 2), "five-fold a term"));
    }
}

/*!
## Go on from here

::: exercise
How many terms of {{eq 6}} leave out a thousandth? And a millionth?

answer: By {{eq A}} nearly $10^6/\pi$, 318310 of them: the program tells 0.00100000. For a millionth a
million times as many would be needed.
:::
*/

CHECK_THAT("318310 terms leave out a thousandth")
{
  for(const Told& now : told_at("N=318310"))
    CHECK(now.value("short_by") == within(0.001, 0.5e-8, "to six digits"));
}
