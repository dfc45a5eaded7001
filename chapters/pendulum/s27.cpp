#include "edition/section.hpp"
#include "pendulum/columns.hpp"
#include "pendulum/three_members.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 27, "The third column sums to ¾ l 2")

using pendulum::root_of, pendulum::W;

/*!
## What Euler does

The third column of the array sums to three quarters of the logarithm of two. With the constant of
{{sec pendulum.26}} nothing is open any more. The function that belongs to the third column is

$$ \begin{aligned} \int\frac{V\,dv}{v} - \tfrac14\,lv = \tfrac14\,l2 - \tfrac14 &+ \frac{1+2l2}{4vv}
   - \frac{\sqrt{1-vv}}{4vv} \\
   &- \left(\frac14 + \frac1{2vv}\right) l\left(1+\sqrt{1-vv}\right), \end{aligned} \tag{1} $$

and when 1 is put for $v$ the root vanishes, its logarithm with it, and the sum of the series appears,

$$ \begin{aligned} \frac{1\cdot3^2}{2^2\cdot4^2} &+ \frac{1\cdot3\cdot5^2}{2\cdot4^2\cdot6^2}
   + \frac{1\cdot3\cdot5\cdot7^2}{2\cdot4\cdot6^2\cdot8^2} + \text{etc.} \\
   &= \tfrac14\,l2 - \tfrac14 + \tfrac14 + \tfrac12\,l2 = \tfrac34\,l2. \end{aligned} \tag{2} $$

So the whole third column of the array of {{sec pendulum.21}}, all of whose terms have the factor
$\cos\alpha\sin^2\alpha$, turns into the simple expression

$$ \tfrac34\cos\alpha\,\sin^2\alpha\; l2. \tag{3} $$

## The program
*/

template <class Real>
Real function(Real v)  // (1)
{
  using std::log;
  const Real vv = v * v;
  const Real root = root_of(v);
  const Real two = log(Real(2));
  return two / 4 - Real(0.25) + (1 + 2 * two) / (4 * vv) - root / (4 * vv)
         - (Real(0.25) + 1 / (2 * vv)) * log(1 + root);
}

template <class Real>
Real third_column(Real alpha)  // (3)
{
  using std::cos, std::log, std::pow, std::sin;
  return Real(0.75) * cos(alpha) * pow(sin(alpha), 2) * log(Real(2));
}

/*!
What the first terms leave out can be caught between bounds as in {{sec pendulum.22}}, and here the bounds
are very narrow. With $a_n = \frac{1\cdot3\cdots(2n-1)}{2\cdot4\cdots2n}$ a term is

$$ \frac{a_{n+1}^2}{2n\,a_n} = \left(a_n - a_{n+1}\right)\left(1 + \frac1{4n(n+1)}\right), \tag{4} $$

and the sum of all differences from $n = N+1$ on is $a_{N+1}$. So the remainder after $N$ terms is more than
$a_{N+1}$, and more by less than the part $\frac1{4(N+1)(N+2)}$ of it.
*/

struct Partial
{
  double sum = 0;         // of the first N terms of (2)
  double remainder = 0.5; // a_{N+1}
};

Partial partial(int N)  // (2)
{
  Partial p;
  for(int n = 1; n <= N; ++n)
  {
    const double fraction = (2 * n + 1.0) / (2 * n + 2);
    p.sum += p.remainder * fraction * fraction / (2 * n);
    p.remainder *= fraction;
  }
  return p;
}

const auto swing_ = amplitude_from_top(5_deg);
const auto terms = integer("N", 4, 1, 10'000'000, "terms of the series that are added");

TELL
{
  const Partial p = partial(terms);
  const double alpha = swing_.eta / 2;
  const auto m = pendulum::three_members(alpha, 40);
  tell("S1", W<double>(1), "the sum of the series, ¾ l 2");
  tell("sum", p.sum, "its first N terms");
  tell("with_remainder", p.sum + p.remainder, "with the lower bound of what is left, a_{N+1}");
  tell("column", third_column(alpha), "the third column, (3)");
  tell("before", swing::quarter_time_from_top(2 * alpha) - m.first - m.second,
       "what t√(2g/b) lacked without it");
  tell("after", swing::quarter_time_from_top(2 * alpha) - m.sum(), "what it lacks with it");
}

TELL
{
  curve("sums", {"terms", "sum", "with_remainder"}, [](Curve& c) {
    for(int n = 1; n <= 100; ++n)
      c.put({1.0 * n, partial(n).sum, partial(n).sum + partial(n).remainder});
  });
  race("sum", "the sum (2)", exact::ln2() * 3 / 4,
       {{"4 terms", [] { return partial(4).sum; }, "plain"},
        {"1000 terms", [] { return partial(1000).sum; }, "plain"},
        {"4 terms and the remainder", [] { return partial(4).sum + partial(4).remainder; }, "bound"},
        {"1000 terms and the remainder", [] { return partial(1000).sum + partial(1000).remainder; }, "bound"},
        {"(1) at v = 1", [] { return function(1.0); }},
        {"¾ l 2", [] { return 0.75 * std::numbers::ln2; }}});
}

/*!
At η = {{eta}}° the time lacked {{before|4}} with two columns and lacks {{after|4}} with three.

::: figure pendulum-27
alt: Sums of the series against the number of terms up to 100. They rise from 0.14 towards 0.52 and cross
the line of a quarter of the logarithm of 2 between the first and the second term. With the bound of the
remainder they lie on three quarters of the logarithm of 2 from the first terms on.

The sums of {{eq 2}}. Already the second is above $\frac14\,l2$, which the scan prints as the sum of all;
they creep towards $\frac34\,l2$ as {{sec pendulum.22}}'s did. The open points have the lower bound
$a_{N+1}$ of the remainder added.
:::

## Checks
*/

CHECK_THAT("at v = 1 the function (1) is ¾ l 2")
{
  CHECK(function(Fifty(1)) == within(exact::ln2() * 3 / 4, 1e-49, "a dozen roundings of fifty digits"));
  CHECK(W(Fifty(1)) == within(exact::ln2() * 3 / 4, 1e-49, "the same"));
  CHECK(W(1.0) == within_ulps(exact::ln2() * 3 / 4, 6, "the bound of the function"));
}

CHECK_THAT("a term is as (4) has it, exactly")
{
  for(int n = 1; n <= 20; ++n)
  {
    const Rational difference = exact::double_factorial_ratio(n) - exact::double_factorial_ratio(n + 1);
    CHECK(pendulum::entry(n + 1, 1) == difference * (1 + Rational(1, 4 * n * (n + 1))));
  }
}

CHECK_THAT("so the series, with its remainder between the bounds, sums to ¾ l 2")
{
  for(const int N : {1, 4, 50, 1000, 100'000})
  {
    const Partial p = partial(N);
    const Fifty missing = exact::ln2() * 3 / 4 - Fifty(p.sum);
    const double width = p.remainder / (4.0 * (N + 1) * (N + 2));
    CHECK(missing == between(p.remainder - 1e-14, p.remainder + width + 1e-14,
          "(4); and 10⁵ additions round"));
  }
}

CHECK_THAT("with three columns the time lacks less than the fourth, sin⁴α times ½")
{
  for(const double eta : {1_deg, 5_deg, 20_deg})
  {
    const Fifty alpha = Fifty(eta) / 2;
    const auto m = pendulum::three_members(alpha, 100);
    const Fifty missing = pendulum::ratio_by_mean(2 * alpha) * exact::pi() / 2 - m.sum();
    CHECK(m.third == within(third_column(alpha), 1e-48, "the same, written otherwise"));
    CHECK(missing / pow(sin(alpha), 4)
          == between(0.4, 0.5, "§28: 0.436 at the least, and a little for the rest"));
  }
}

/*!
The scan prints $\frac14\,l2$ for the sum, and $\frac14$ again in {{eq 3}}; but {{eq 1}} gives $\frac34$,
and {{sec pendulum.29}} has it so. It has mistaken letters too, under the root and under the integral.
*/

const Emendation three_quarters{
    "§27, (2) and (3)", {"¼ l 2", std::numbers::ln2 / 4}, {"¾ l 2", 3 * std::numbers::ln2 / 4},
    "the sum lies between its bounds, and §32 takes the logarithm of ¾",
    [](double sum) {
      const Partial p = partial(4);
      return sum == between(p.sum + p.remainder, p.sum + p.remainder * (1 + 1.0 / 120),
          "the bounds from (4)");
    }};

const Emendation root{
    "§27, (1)", {"(v² − vv)/(4vv)", 0.0}, {"√(1−vv)/(4vv)", 0.8 / 1.44}, "§25; here at v = 0,6",
    [](double member) {
      const double others = function(0.6) + 0.8 / 1.44;
      return others - member == within_relative(W(Fifty(0.6)), 1e-14, "parts near 3 leave 0.06");
    }};

const Emendation integrand{
    "§27, (1), left side", {"∫ v dv/v − ¼ l v", 0.6 - std::log(0.6) / 4},
    {"∫ V dv/v − ¼ l v", [] { return W(0.6); }}, "it is the right side, here from 0 to 0,6",
    [](double left) { return left == within_relative(function(0.6), 1e-14, "parts near 3 leave 0.06"); }};
