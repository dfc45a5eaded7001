#include "edition/section.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 25, "Infinities that destroy each other")

using pendulum::root_of, pendulum::W;

/*!
## What Euler does

The constant of integration has to be found just where every part of the integral is infinite. With that
constant, {{sec pendulum.24}} has led to

$$ \begin{aligned} \int\frac{V\,dv}{v} - \tfrac14\,lv{{entry left}} = C &+ \frac{1+2l2}{4vv} -
\frac{\sqrt{1-vv}}{4vv} \\
   &- \left(\frac14 + \frac1{2vv}\right) l\left(1+\sqrt{1-vv}\right), \end{aligned} \tag{1} $$

::: margin
Today: a removable singularity; expand at $v = 0$, and take the limit.
:::

and $v = 1$ will make this the sum of the third column. $C$ must be such that the whole vanishes at $v = 0$.
But put $v = 0$, and all the parts grow to infinity. Euler has no doubt that these infinities destroy one
another, since a definite $C$ must come out. The remedy is the usual one in such cases: $v$ is not taken as
nothing but as infinitely small, and then all the terms divided by $vv$ will cancel of themselves. This is
done in {{sec pendulum.26}}.

## The program

Whoever computes with sixteen digits meets the same inconvenience in earnest. Near $v = 0$ the parts are of
the order $1/vv$; each is rounded, and the rounding errors do not destroy one another. Here is {{eq 1}} as it
stands, with the constant of the next section.
*/

template <class Real>
Real as_it_stands(Real v)  // (1)
{
  using std::log;
  const Real vv = v * v;
  const Real root = root_of(v);
  const Real two = log(Real(2));
  return (two - 1) / 4 + (1 + 2 * two) / (4 * vv) - root / (4 * vv)
         - (Real(0.25) + 1 / (2 * vv)) * log(1 + root);
}

/*!
The infinities can be made to cancel before a number is put in. With $q = \frac12\left(1-\sqrt{1-vv}\right)$
one has $1+\sqrt{1-vv} = 2(1-q)$ and $vv = 4q(1-q)$. Then every $l2$ goes out of {{eq 1}}, and what remains
is finite at $q = 0$:

$$ W = -\frac14 + \frac1{8(1-q)} - \left(\frac14 + \frac1{8q(1-q)}\right) l(1-q). \tag{A} $$

With $-l(1-q) = q + \frac12qq + q\,R$, where $R = \frac13qq + \frac14q^3 + \text{etc.}$, the last cancellation
goes out too, and all digits are kept however small $v$ is:

$$ W = \frac{q\left(\frac92 - q - qq\right) + R\left(1 + 2q(1-q)\right)}{8(1-q)}. \tag{B} $$

::: code pendulum/columns.hpp W (B)
:::
*/

const auto v = real("v", 1e-3, none, above_to(1e-150, 1), "the variable, infinitely small for Euler");

TELL
{
  auto& loss = table("loss", "What sixteen digits make of it, as v grows small",
                     {{"v", "v", none, 1}, {"stands", "by (1)"}, {"W", "W", none, 12}});
  for(const double x : {1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8})
    loss.row({x, as_it_stands(x), W(x)});
}

TELL
{
  curve("parts", {"v", "part", "stands", "W"}, [](Curve& c) {
    for(double x = 1; x > 1e-8; x *= 0.87)
      c.put({x, (1 + 2 * std::numbers::ln2) / (4 * x * x), std::abs(as_it_stands(x)), W(x)});
  });
}

/*!
{{table loss}}

::: figure pendulum-25
alt: Three things against v, both scales logarithmic. The greatest part rises with slope minus two as v grows
small, the whole falls with slope two. What sixteen digits make of the whole follows it down to a ten
thousandth and then turns up, sixteen decades below the part.

Euler's infinities on a machine of sixteen digits. The parts of {{eq 1}} grow like $1/vv$, and their sum
vanishes like $vv$. Below $v = 10^{-4}$ the points show nothing but the rounding of the parts.
:::

## Speed against error
*/

TELL
{
  const double w = v;
  race("whole", "W(v)", W(v.fifty()),
       {{"as it stands, (1)", [=] { return as_it_stands(w); }},
        {"without cancellation, (B)", [=] { return W(w); }}});
}

/*!
## Checks

Fifty digits can bear the infinities: {{eq 1}} as it stands is there the same as {{eq B}}, and both are the
series of the third column.
*/

CHECK_THAT("(1) is W, and W is the series of the third column")
{
  for(const double x : {1e-6, 1e-3, 0.1, 0.5})
  {
    Fifty series = 0;
    for(int n = 1; n <= 80; ++n)
      series += static_cast<Fifty>(pendulum::entry(n + 1, 1)) * pow(Fifty(x), 2 * n);
    CHECK(W(Fifty(x))
          == within_relative(series, 1e-48, "at ½ eighty terms leave 10⁻⁵²; the rest is rounding"));
    CHECK(as_it_stands(Fifty(x)) == within(series, 1e-49 / (x * x), "roundings of the parts"));
  }
}

CHECK_THAT("the infinities do destroy each other: (1) vanishes like 9/64 vv")
{
  const Fifty y("1e-8");
  CHECK(as_it_stands(y) / (y * y) == within(Fifty(9) / 64, 1e-17, "the next term, 25/384 vv"));
}

CHECK_THAT("in sixteen digits (1) loses its digits like 1/v⁴, and (B) loses none")
{
  for(const double x : {0x1p-6, 0x1p-10, 0x1p-14})
  {
    double worst = 0;
    for(double near = x; near < 1.5 * x; near += x / 64)
      worst = std::max(worst, static_cast<double>(abs(as_it_stands(near) - W(Fifty(near))) * near * near));
    CHECK(worst == between(0.3e-16, 3e-16, "four parts near ½/vv, each rounded"));
  }
  for(const double x : {1e-150, 1e-8, 1e-4, 0.1, 0.6, 1.0})
    CHECK(W(x) == within_ulps(W(Fifty(x)), 6, "the bound of the function"));
}

/*!
Of the left side of {{eq 1}} our copy has only the last two letters.
*/

const Emendation left{
    "§25, (1), left side",
    {"l v", std::log(0.6)},
    {"∫V dv/v − ¼ l v", W<double>(0.6)},
    "the right side, at v = 0.6, with the constant of §26",
    [](double left) { return left == within(as_it_stands(Fifty(0.6)), 1e-16, "W in double, near 0.06"); }};

/*!
What is told, by the third column's series, which knows nothing of the infinities:
*/

Fifty third_column(const Fifty& x)  // Σ entry v²ⁿ; at v = 1 Euler's ¾ l 2
{
  if(x == Fifty(1))
    return 3 * log(Fifty(2)) / 4;
  Fifty sum = 0;
  for(int n = 1; n <= 80; ++n)
    sum += static_cast<Fifty>(pendulum::entry(n + 1, 1)) * pow(x, 2 * n);
  return sum;
}

CHECK_THAT("the table has the series in one column, and its ruin in the other")
{
  for(const Told& now : told_at("", "v=0.5", "v=1e-9"))
  {
    for(const auto& row : now.rows("loss"))
    {
      const Fifty x(row.at("v")), truth = third_column(x);
      const double rounding = 2e-16 / row.at("v") / row.at("v");
      CHECK(row.value("W") == within_relative(truth, 1.4e-15, "the library's bound"));
      CHECK(row.value("stands") == within(truth, 1.5 * rounding, "four parts near ½/vv, each rounded"));
    }
    const Fifty truth = third_column(v.fifty());
    CHECK(now.exact("whole") == within_relative(truth, 1e-40, "eighty terms"));
    CHECK(now.method("whole", "without cancellation, (B)")
          == within_relative(truth, 2e-15, "the library's bound"));
    CHECK(now.method("whole", "as it stands, (1)")
          == within(truth, 3e-16 / v / v, "four parts, each rounded"));
  }
}

CHECK_THAT("the figure has the greatest part, the sum as it stands, and W")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("parts", 12))
    {
      const Fifty x(point.at("v")), part = (1 + 2 * exact::ln2()) / (4 * x * x);
      CHECK(point.value("part") == within_relative(part, 1e-15, "a square and a quotient"));
      if(x < Fifty(0.6))
      {
        const double rounding = 5e-16 * static_cast<double>(part);
        CHECK(point.value("W") == within_relative(third_column(x), 2e-15, "the library's bound"));
        CHECK(point.value("stands")
              == between(third_column(x) - rounding, third_column(x) + rounding, "rounding"));
      }
    }
}
