#include "edition/section.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 25, "Infinities that destroy each other")

using pendulum::D, pendulum::half_versine, pendulum::root_of, pendulum::W;

/*!
## What Euler does

Every part of the integral is infinite at the place where the whole must vanish. With the constant that is to
bring this about, {{sec pendulum.24}} has led to

$$ \begin{aligned} \int\frac{V\,dv}{v} - \tfrac14\,lv = C &+ \frac{1+2l2}{4vv} - \frac{\sqrt{1-vv}}{4vv} \\
   &- \left(\frac14 + \frac1{2vv}\right) l\left(1+\sqrt{1-vv}\right), \end{aligned} \tag{1} $$

and with $v = 1$ this will be the sum of the third column. But first there is an inconvenience. The constant
must be such that the expression vanishes at $v = 0$; and when one puts $v = 0$, all parts grow to infinity.
There can be no doubt, he says, that these infinities destroy one another, since a definite value must come
out for $C$. The remedy is the usual one in such cases: $v$ is not made zero but conceived infinitely small;
then the terms that are divided by $vv$ will cancel of themselves. {{sec pendulum.26}} carries it out.

::: margin
Today: a removable singularity; expand at $v = 0$, and take the limit.
:::

## The program

Whoever computes meets the same inconvenience in earnest. On a machine that carries sixteen digits the parts
do not destroy each other; they leave their rounding errors behind, which are as large as the parts. Here is
{{eq 1}} as it stands, with the constant that the next section finds.
*/

double as_it_stands(double v)  // (1)
{
  const double vv = v * v;
  const double root = root_of(v);
  return (std::numbers::ln2 - 1) / 4 + (1 + 2 * std::numbers::ln2) / (4 * vv) - root / (4 * vv)
         - (0.25 + 1 / (2 * vv)) * std::log(1 + root);
}

/*!
A first cure is to subtract the largest parts by hand: with $D = l2 - l(1+\sqrt{1-vv})$ and
$u = \sqrt{1-vv}$,

$$ W = -\frac14 + \frac{1}{4(1+u)} + \frac{D}{4} + \frac{D}{2vv}. \tag{2} $$

Nothing is infinite any more, but the first, second and fourth member still cancel: the relative error,
which before grew like $1/v^4$, now grows like $1/vv$.
*/

double once_reduced(double v)  // (2)
{
  const double root = root_of(v);
  return -0.25 + 1 / (4 * (1 + root)) + D(v, root) * (0.25 + 1 / (2 * v * v));
}

/*!
The full cure has no cancellation at all. With $q = \frac12(1-u)$ one has $vv = 4q(1-q)$ and
$D = -l(1-q) = q + \frac12qq + q\,R$, where $R = \frac13qq + \frac14q^3 + \ldots$; put into {{eq 2}}, this
gives

$$ W = \frac{q\left(\frac92 - q - qq\right) + R\left(1 + 2q(1-q)\right)}{8(1-q)}. \tag{3} $$

::: code pendulum/columns.hpp W
:::

The smaller $v$ is, the more it shows.
*/

const auto v = real("v", 1e-3, none, above_to(1e-150, 1),
    "the variable, which Euler conceives infinitely small");

TELL
{
  const double w = v;
  tell("W", W(w), "W, all digits");
  tell("stands", as_it_stands(w), "(1) in sixteen digits");
  tell("reduced", once_reduced(w), "(2) in sixteen digits");
  auto& loss = table("loss", "What sixteen digits make of it, as v grows small.",
                     {{"v", "v"}, {"stands", "by (1)"}, {"reduced", "by (2)"}, {"W", "W", none, 12}});
  for(const double x : {1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8})
    loss.row({x, as_it_stands(x), once_reduced(x), W(x)});
  curve("error", {"v", "stands", "reduced", "W"}, [](Curve& c) {
    for(double x = 1; x > 1e-8; x *= 0.9)
    {
      const auto error = [truth = W(Fifty(x))](double got) {
        return std::max(std::abs(static_cast<double>((got - truth) / truth)), 1e-17);
      };
      c.put({x, error(as_it_stands(x)), error(once_reduced(x)), error(W(x))});
    }
  });
  race("W", "W(v)", W(Fifty(w)), {{"as it stands, (1)", [=] { return as_it_stands(w); }},
                                  {"once reduced, (2)", [=] { return once_reduced(w); }},
                                  {"without cancellation, (3)", [=] { return W(w); }}});
}

/*!
{{table loss}}

::: figure pendulum-25
alt: Relative error of three ways to W against v, both logarithmic. Euler's form rises with slope minus four
and has lost every digit before v is a ten thousandth; the reduced form rises with slope minus two; the
third stays at the last digit.

Euler's infinities on a machine of sixteen digits. As it stands the formula is useless from $v = 10^{-4}$
on: the parts are of the order $1/vv$, each is rounded, and what should be left is of the order $vv$.
:::

## Checks

That the forms are the same function is seen in fifty digits, as long as those suffice; and against the
series.
*/

template <class Real>
Real by_series(const Real& x)
{
  Real sum = 0;
  Real a = Real(1) / 2;  // a_n
  Real power = 1;
  for(int n = 1; n <= 400; ++n)
  {
    const Real next = a * (2 * n + 1) / (2 * n + 2);
    power *= x * x;
    sum += next * next / (2 * n * a) * power;
    a = next;
  }
  return sum;
}

CHECK_THAT("the form without cancellation is the series, and the series the form (1)")
{
  for(const double x : {1e-8, 1e-3, 0.1, 0.5, 0.8})
  {
    const Fifty y(x);
    const Fifty root = root_of(y);
    const Fifty form = (exact::ln2() - 1) / 4 + (1 + 2 * exact::ln2() - root) / (4 * y * y)
                       - (Fifty(0.25) + 1 / (2 * y * y)) * log(1 + root);
    CHECK(W(y) == within_relative(by_series(y), 1e-45, "400 terms; at 0.8 they leave 10⁻⁷⁸"));
    CHECK(form == within(W(y), 1e-47 / (x * x), "its parts, of the order 1/vv, in fifty digits"));
  }
}

CHECK_THAT("W keeps its digits from v = 10⁻¹⁵⁰ to 1")
{
  for(const double x : {1e-150, 1e-8, 1e-4, 1e-2, 0.1, 0.3, 0.6, 0.9, 1.0})
    CHECK(W(x) == within_ulps(W(Fifty(x)), 6, "the bound of the function"));
  CHECK(W(1.0) == within_ulps(exact::ln2() * 3 / 4, 3, "the sum of the third column, §27"));
}

CHECK_THAT("the other two lose their digits like 1/v⁴ and 1/vv")
{
  const auto error = [](double got,
      double x) { return std::abs(static_cast<double>(got / W(Fifty(x)) - 1)); };
  for(const double x : {0x1p-8, 0x1p-10, 0x1p-12})  // of v⁴ error and vv error the worst in a neighbourhood
  {
    double stands = 0;
    double reduced = 0;
    for(int k = 0; k < 50; ++k)
    {
      const double near = x * (1 + k / 100.0);
      stands = std::max(stands, error(as_it_stands(near), near) * std::pow(near, 4));
      reduced = std::max(reduced, error(once_reduced(near), near) * near * near);
    }
    CHECK(stands == between(2e-17, 4e-15, "a few units of 10⁻¹⁶, divided by 9/64"));
    CHECK(reduced == between(2e-17, 4e-15, "the same"));
  }
}

CHECK_THAT("(1) vanishes with v as it should, which fifty digits can still see at 10⁻¹⁰")
{
  const Fifty y("1e-10");
  CHECK(W(y) == within_relative(y * y * 9 / 64, 1e-19, "the second term is 25/54 vv of the first"));
}

/*!
Of the left side of {{eq 1}} the scan has kept only the last two letters.
*/

const Emendation left{
    "§25, (1), left side", {"l v", std::log(0.6)}, {"∫V dv/v − ¼ l v", by_series(0.6)},
    "the right side, at v = 0,6, with the constant of §26",
    [](double left) { return left == within(Fifty(as_it_stands(0.6)), 1e-15,
        "parts near 3 in sixteen digits"); }};
