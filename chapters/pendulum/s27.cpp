#include "edition/section.hpp"
#include "pendulum/columns.hpp"
#include "pendulum/three_members.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 27, "The third column sums to ¾ l 2")

using pendulum::root_of, pendulum::W;

/*!
## What Euler does

The third column of the array sums to three quarters of the logarithm of two. With the constant of
{{sec pendulum.26}} the function that belongs to it is complete,

$$ \begin{aligned} \int\frac{V\,dv}{v}{{entry integrand}} - \tfrac14\,lv = \tfrac14\,l2 - \tfrac14 &+
\frac{1+2l2}{4vv}
   - \frac{\sqrt{1-vv}{{entry root}}}{4vv} \\
   &- \left(\frac14 + \frac1{2vv}\right) l\left(1+\sqrt{1-vv}\right), \end{aligned} \tag{1} $$

and with $v = 1$ it becomes the sum of the series. The root vanishes, the logarithm with it, and there remains

$$ \begin{aligned} \frac{1\cdot3^2}{2^2\cdot4^2} &+ \frac{1\cdot3\cdot5^2}{2\cdot4^2\cdot6^2}
   + \frac{1\cdot3\cdot5\cdot7^2}{2\cdot4\cdot6^2\cdot8^2} + \text{etc.} \\
   &= \tfrac14\,l2 - \tfrac14 + \tfrac14 + \tfrac12\,l2 = \tfrac34{{entry three_quarters}}\,l2.
   \end{aligned} \tag{2} $$

So the whole third column of {{sec pendulum.21}}, whose terms all have the factor $\cos\alpha\sin^2\alpha$,
turns into the simple expression

$$ \tfrac34\cos\alpha\,\sin^2\alpha\; l2. \tag{3} $$

## The program
*/

Fifty function(const Fifty& v)  // (1)
{
  const Fifty vv = v * v;
  const Fifty root = root_of(v);
  const Fifty two = exact::ln2();
  return two / 4 - Fifty(0.25) + (1 + 2 * two) / (4 * vv) - root / (4 * vv)
         - (Fifty(0.25) + 1 / (2 * vv)) * log(1 + root);
}

template <class Real>
Real third_column(Real alpha)  // (3)
{
  using std::cos, std::log, std::sin;
  return Real(0.75) * cos(alpha) * sin(alpha) * sin(alpha) * log(Real(2));
}

/*!
The series gives the sum independently, since what the first terms leave out can be caught between close
bounds, as in {{sec pendulum.22}}. With $a_n = \frac{1\cdot3\cdots(2n-1)}{2\cdot4\cdots2n}$ a term is

$$ \frac{a_{n+1}^2}{2n\,a_n} = \left(a_n - a_{n+1}\right)\left(1 + \frac1{4n(n+1)}\right), \tag{A} $$

and all the differences from $n = N+1$ on add up to $a_{N+1}$. So the remainder after $N$ terms exceeds
$a_{N+1}$, by less than its $4(N+1)(N+2)$th part.
*/

struct Partial
{
  double sum = 0;      // of the first N terms of (2)
  double bound = 0.5;  // a_{N+1}
};

Partial partial(int N)  // (2)
{
  Partial p;
  for(int n = 1; n <= N; ++n)
  {
    const double fraction = (2 * n + 1.0) / (2 * n + 2);
    p.sum += p.bound * fraction * fraction / (2 * n);
    p.bound *= fraction;
  }
  return p;
}

Fifty lacking(const Fifty& alpha)  // of t√(2g)/√b, after the first two columns
{
  return swing::oracle::K_from_complement(sin(alpha)) - pendulum::sum_by_columns(alpha, 1);
}

const auto swing_ = amplitude_from_top(5_deg, from_below(90_deg, 180_deg));
const auto terms = integer("N", 4, 1, 10'000'000, "terms of the series that are added");

TELL
{
  const Partial p = partial(terms);
  const Fifty alpha = swing_.eta.fifty() / 2, before = lacking(alpha);
  const auto told = [&](const Fifty& left) {  // nothing, where fifty digits cannot tell
    return left < Fifty("1e-45") ? 0 : static_cast<double>(left);
  };
  tell("sum", p.sum, "the first N terms of the series (2)");
  tell("with_bound", p.sum + p.bound, "with the lower bound of the remainder, a_{N+1}");
  tell("S1", W<double>(1), "the whole series, ¾ l 2");
  tell("column", third_column<double>(swing_.eta / 2), "the third column, (3)");
  tell("before", told(before), "what t√(2g/b) lacks without it");
  tell("after", told(before - third_column(alpha)), "what it lacks with it");
}

TELL
{
  curve("sums", {"terms", "sum", "with_bound"}, [](Curve& c) {
    for(int n = 1; n <= 100; ++n)
      c.put({1.0 * n, partial(n).sum, partial(n).sum + partial(n).bound});
  });
}

/*!
At η = {{eta}} the time lacks {{before|4}} with two columns and {{after|4}} with three.

::: figure pendulum-27
alt: Sums of the series against the number of terms up to 100. They rise from 0.14 towards 0.52 and cross
the line of a quarter of the logarithm of 2 between the first and the second term. With the bound of the
remainder they lie on three quarters of the logarithm of 2 from the first terms on.

The sums of {{eq 2}} creep towards $\frac34\,l2$; the second is already above $\frac14\,l2$, which our copy
has for all of them. The open points have the lower bound $a_{N+1}$ of the remainder added.
:::

## Speed against error
*/

TELL
{
  race("whole", "the sum (2)", exact::ln2() * 3 / 4,
       {{"4 terms", [] { return partial(4).sum; }, "plain"},
        {"1000 terms", [] { return partial(1000).sum; }, "plain"},
        {"4 terms and the remainder", [] { return partial(4).sum + partial(4).bound; }, "bound"},
        {"1000 terms and the remainder", [] { return partial(1000).sum + partial(1000).bound; }, "bound"},
        {"¾ l 2", [] { return 0.75 * std::numbers::ln2; }}});
}

/*!
## Checks
*/

CHECK_THAT("(1) is the function of the third column, and at v = 1 it is ¾ l 2")
{
  for(const double v : {0.1, 0.6, 1.0})
    CHECK(function(Fifty(v))
          == within(W(Fifty(v)), 1e-49 / (v * v), "the rounding of parts of the order 1/vv"));
  CHECK(function(1) == within(exact::ln2() * 3 / 4, 1e-49, "a dozen roundings of fifty digits"));
}

CHECK_THAT("a term is as (A) has it, exactly, and the remainder lies between its bounds")
{
  for(int n = 1; n <= 20; ++n)
  {
    const Rational difference = exact::double_factorial_ratio(n) - exact::double_factorial_ratio(n + 1);
    CHECK(pendulum::entry(n + 1, 1) == difference * (1 + Rational(1, 4 * n * (n + 1))));
  }
  for(const int N : {1, 4, 50, 1000})
  {
    const Partial p = partial(N);
    const double width = p.bound / (4.0 * (N + 1) * (N + 2));
    CHECK(exact::ln2() * 3 / 4 - Fifty(p.sum)
          == between(p.bound - 1e-15, p.bound + width + 1e-15, "(A), and the rounding of the sum"));
  }
}

CHECK_THAT("the third column is what the time lacks after two, but for less than half of sin⁴α")
{
  for(const double alpha : {0.5_deg, 2.5_deg, 10_deg, 20_deg})
    CHECK(lacking(alpha) - third_column(Fifty(alpha))
          == between(0.43 * std::pow(std::sin(alpha), 4), 0.5 * std::pow(std::sin(alpha), 4),
                     "the fourth column begins with 0.436, §28"));
}

/*!
Our copy has $\frac14$ for $\frac34$ in {{eq 2}} and {{eq 3}}, though its own {{eq 1}} gives $\frac34$ and
{{sec pendulum.29}} has it. In {{eq 1}} it has mistaken letters under the root and under the integral.
*/

const Emendation three_quarters{
    "§27, (2) and (3)",
    {"¼ l 2", std::numbers::ln2 / 4},
    {"¾ l 2", 3 * std::numbers::ln2 / 4},
    "the sum lies between its bounds, and §32 takes the logarithm of ¾",
    [](double sum) {
      const Partial p = partial(4);
      return sum == between(p.sum + p.bound, p.sum + p.bound * (1 + 1.0 / 120), "the bounds from (A)");
    }};

const Emendation root{"§27, (1)",
                      {"(v² − vv)/(4vv)", 0.0},
                      {"√(1−vv)/(4vv)", 0.8 / 1.44},
                      "§25 has the root; here at v = 0.6",
                      [](double member) {
                        const Fifty others =
                            function(Fifty(0.6)) + root_of(Fifty(0.6)) / (4 * Fifty(0.6) * Fifty(0.6));
                        return others - member == within(W(Fifty(0.6)), 1e-15, "a member rounded");
                      }};

const Emendation integrand{
    "§27, (1), left side",
    {"∫ v dv/v − ¼ l v", 0.6 - std::log(0.6) / 4},
    {"∫ V dv/v − ¼ l v", [] { return W(0.6); }},
    "it is the right side, here from 0 to 0.6",
    [](double left) { return left == within(function(Fifty(0.6)), 1e-16, "W in double, near 0.06"); }};

/*!
What is told, by fractions, and by the oracle's time:
*/

CHECK_THAT(
    "the sums told are those of the entries, and what the time lacks is the third column and a little")
{
  for(const Told& now : told_at("", "eta=90 N=1", "eta=1e-150rad N=60"))
  {
    Rational sum = 0;
    for(int n = 1; n <= terms; ++n)
      sum += pendulum::entry(n + 1, 1);
    const Fifty entries(sum), bound(exact::double_factorial_ratio(terms + 1));
    CHECK(now.value("sum") == within_relative(entries, 2e-15, "a half ulp a term"));
    CHECK(now.value("with_bound") == within_relative(entries + bound, 2e-15, "a half ulp a term"));
    CHECK(now.value("S1") == within_ulps(3 * log(Fifty(2)) / 4, 6, "the library's bound"));
    const Fifty alpha = swing_.eta.fifty() / 2, u = cos(alpha),
                K = swing::oracle::K_from_complement(sin(alpha));
    const Fifty column = 3 * u * (1 - u) * (1 + u) * log(Fifty(2)) / 4;
    CHECK(now.value("column")
          == within(column, 4e-16 * static_cast<double>(column) + 1e-48, "few roundings"));
    const Fifty before =
        K - swing::oracle::ratio_from_bottom(2 * alpha) * log((1 + u) / sin(alpha)) - u * log(Fifty(2));
    const auto rounded = [](const Fifty& x) { return 2e-16 * std::abs(static_cast<double>(x)) + 1e-45; };
    const char* const why = "fifty digits, rounded; nothing, where they cannot tell";
    CHECK(now.value("before") == within(before, rounded(before), why));
    CHECK(now.value("after") == within(before - column, rounded(before - column), why));
  }
}

CHECK_THAT("the race's ways and the figure's sums are those of the entries")
{
  const auto entries = [](int N) {
    Fifty sum = 0, bound = 0.5;  // a₁
    for(int n = 1; n <= N; ++n)
    {
      const Fifty before = std::exchange(bound, bound * (2 * n + 1) / (2 * n + 2));
      sum += bound * bound / (2 * n * before);
    }
    return std::pair{sum, bound};
  };
  for(const Told& now : told_at("", "eta=90 N=1", "eta=20 N=60"))
  {
    CHECK(now.exact("whole") == within_relative(3 * log(Fifty(2)) / 4, 1e-49, "two ways of fifty digits"));
    CHECK(now.method("whole", "¾ l 2") == within_ulps(3 * log(Fifty(2)) / 4, 1, "a product"));
    for(const int N : {4, 1000})
    {
      const auto [sum, bound] = entries(N);
      CHECK(now.method("whole", std::to_string(N) + " terms") == within(sum, 2e-14, "N roundings"));
      CHECK(now.method("whole", std::to_string(N) + " terms and the remainder")
            == within(sum + bound, 2e-14, "N roundings"));
    }
  }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("sums", 6))
    {
      const auto [sum, bound] = entries(static_cast<int>(point.at("terms")));
      CHECK(point.value("sum") == within_relative(sum, 5e-15, "a hundred roundings"));
      CHECK(point.value("with_bound") == within_relative(sum + bound, 5e-15, "a hundred roundings"));
    }
}

/*!
## Go on from here

::: exercise
Within which angle from the top may the third column be left out too, if five decimals are wanted? Is it
needed in his second example, 1° from the top?

answer: Within 0.355°, where it comes to half a unit of the fifth decimal. At 1° it is needed: `--eta 1` tells
0.0000396, his 0,00004 ({{sec pendulum.36}}).
:::
*/

CHECK_THAT("the third column is half a unit of the fifth decimal at 0.355°, and 0.0000396 at 1°")
{
  for(const Told& now : told_at("eta=0.355"))
    CHECK(now.value("column") == between(0.4985e-5, 0.5e-5, "just within"));
  for(const Told& now : told_at("eta=0.356"))
    CHECK(now.value("column") == between(0.5e-5, 0.502e-5, "just beyond"));
  for(const Told& now : told_at("eta=1"))
    CHECK(now.value("column") == within(0.0000396, 0.5e-7, "three digits"));
}
