#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 24, "The third column: three integrals")

using pendulum::root_of, pendulum::V, pendulum::W;

/*!
## What Euler does

The series $V$ of {{sec pendulum.23}} has the right factors above; multiplied by $\frac{dv}{v}$ and integrated
it gets the missing ones below as well,

$$ \begin{aligned} \int\frac{V\,dv}{v} = \frac1{2^2}\,lv &+ \frac{1\cdot3^2}{2^2\cdot4^2}vv
   + \frac{1\cdot3\cdot5^2}{2\cdot4^2\cdot6^2}v^4 \\
   &+ \frac{1\cdot3\cdot5\cdot7^2}{2\cdot4\cdot6^2\cdot8^2}v^6 + \text{etc.} \end{aligned} \tag{1} $$

So the sum of the third column is $\int\frac{V\,dv}{v} - \frac14\,lv$, with 1 put for $v$. It remains to
integrate the three parts of which $V$ consists. The first gives

$$ \int -\frac{dv}{v^3}\,(1 + l2) = \frac{1+l2}{2vv}, \tag{2} $$

and the second

$$ \int\frac{dv}{v^3\sqrt{1-vv}} = -\frac{\sqrt{1-vv}}{2vv} - \tfrac12\,l\left(1+\sqrt{1-vv}\right) +
     \tfrac12\,lv. \tag{3} $$

The third he reduces by the well-known rule for a product, and since the differential of $l(1+\sqrt{1-vv})$ is
$-\frac{dv}{v}\cdot\frac{1-\sqrt{1-vv}}{\sqrt{1-vv}}$,

$$ \begin{aligned} \int\frac{dv}{v^3}\,l\left(1+\sqrt{1-vv}\right)
   = &-\frac{1}{2vv}\,l\left(1+\sqrt{1-vv}\right) \\
   &- \tfrac12\int\frac{dv}{v^3}\cdot\frac{1-\sqrt{1-vv}}{\sqrt{1-vv}}. \end{aligned} \tag{4} $$

The last integral is {{eq 3}} less that of $\frac{dv}{v^3}$. Therefore the third part is

$$ \begin{aligned} -\frac1{2vv}\,l\left(1+\sqrt{1-vv}\right) &+ \frac{\sqrt{1-vv}}{4vv} \\
   &+ \tfrac14\,l\left(1+\sqrt{1-vv}\right) - \tfrac14\,lv - \frac1{4vv}, \end{aligned} \tag{5} $$

and all parts together, with a constant that is still open,

$$ \begin{aligned} \tfrac14\,lv + \frac{1+2l2}{4vv} &- \frac{\sqrt{1-vv}}{4vv} \\
   &- \left(\frac14 + \frac1{2vv}\right) l\left(1+\sqrt{1-vv}\right) + C. \end{aligned} \tag{6} $$

::: margin
The sum is wanted for $v = 1$ only, but for every other $v$ the same function gives the time of a descent that
is *not* complete, with $v = \sin\alpha/\sin\omega$: see {{sec pendulum.15}}.
:::

## The program

The three integrals, and their sum, as they are written. The same code serves doubles and fifty digits.
*/

template <class Real>
Real part_1(Real v)  // (2)
{
  using std::log;
  return (1 + log(Real(2))) / (2 * v * v);
}

template <class Real>
Real part_2(Real v)  // (3)
{
  using std::log;
  const Real root = root_of(v);
  return -root / (2 * v * v) - log(1 + root) / 2 + log(v) / 2;
}

template <class Real>
Real part_3(Real v)  // (5)
{
  using std::log;
  const Real root = root_of(v);
  return (root - 1 - 2 * log(1 + root)) / (4 * v * v) + (log(1 + root) - log(v)) / 4;
}

template <class Real>
Real collected(Real v)  // (6) without C and without ¼ lv
{
  using std::log;
  const Real vv = v * v;
  const Real root = root_of(v);
  return (1 + 2 * log(Real(2)) - root) / (4 * vv) - (Real(0.25) + 1 / (2 * vv)) * log(1 + root);
}

/*!
What they should come to is the function $W(v) = \int\frac{V\,dv}{v} - \frac14lv$ that vanishes at $v = 0$, as
the series {{eq 1}} does without its logarithm. How the program has it without loss of digits is told in
{{sec pendulum.25}}.
*/

const auto v = real("v", 1.0, none, above_to(1e-150, 1), "the variable; Euler puts 1 in the end");

TELL
{
  tell("part_1", part_1<double>(v), "the first part integrated, (2)");
  tell("part_2", part_2<double>(v), "the second, (3)");
  tell("part_3", part_3<double>(v), "the third, (5)");
  tell("collected", collected<double>(v), "all together, less ¼ lv, C being 0");
  tell("W", W<double>(v), "the sum of the series: at v = 1 that of the third column");
  tell("C", W<double>(v) - collected<double>(v), "so C must be");
}

TELL
{
  curve("integrand", {"v", "integrand"}, [](Curve& c) {
    for(double x = 0.005; x < 0.999; x += 0.005)
      c.put({x, (V(x) - 0.25) / x});
    for(double u = 0.04; u > 0.005; u -= 0.005)
      c.put({1 - u * u / 2, V(1 - u * u / 2, u) - 0.25});
  });
}

/*!
::: figure pendulum-24
alt: The curve of V less a quarter, divided by v, against v from 0 to 1. It begins at zero, rises slowly, and
goes to infinity at 1; the area under it is shaded.

The sum of the third column as an area: under the curve $\frac{1}{v}\left(V - \frac14\right)$ from 0 to 1 lies
{{W|6}}. At the end the curve goes to infinity, but no faster than $1/\sqrt{1-vv}$, and the area is finite.
:::

## Checks

The series first. Every term of {{eq 1}} is the entry of the array that it should be, and the area in the
figure is the sum.
*/

CHECK_THAT("(1) without its logarithm has the entries of the third column as coefficients")
{
  for(int n = 1; n <= 12; ++n)
  {
    const Rational of_V = exact::double_factorial_ratio(n + 1) * (2 * n + 1) / (2 * n + 2);
    CHECK(of_V / (2 * n) == pendulum::entry(n + 1, 1));
  }
}

CHECK_THAT("the area under (V − ¼)/v is W")
{
  for(const double x : {0.3, 0.6, 1.0})
  {
    const Fifty end(x);
    const Fifty area = exact::integrate_from_ends([&](const Fifty& y, const Fifty& to_end) {
      const Fifty root = sqrt((end < 1 ? 1 - y : (to_end > 0 ? to_end : 1 - y)) * (1 + y));
      return y < Fifty("1e-9") ? Fifty(9) / 32 * y : (V(y, root) - Fifty(0.25)) / y;
    }, 0, end, Fifty("1e-25")).value;
    CHECK(W(end) == within_relative(area, 1e-23, "the quadrature; below 10⁻⁹ only the first term is kept"));
  }
}

/*!
Then the integrals: the slope of each, taken from values $10^{-12}$ apart, must be what was integrated.
*/

Fifty slope(Fifty (*f)(Fifty), double at)
{
  const Fifty h("1e-12");
  return (f(Fifty(at) + h) - f(Fifty(at) - h)) / (2 * h);
}

CHECK_THAT("each part has the slope that it should have")
{
  for(const double x : {0.1, 0.3, 0.6, 0.9})
  {
    const Fifty y(x);
    const Fifty cube = pow(y, 3);
    const Fifty root = root_of(y);
    const char* const why = "the third derivative, at most 10³ times the first, times hh/6";
    CHECK(slope(part_1, x) == within_relative(-(1 + exact::ln2()) / cube, 1e-20, why));
    CHECK(slope(part_2, x) == within_relative(1 / (cube * root), 1e-20, why));
    CHECK(slope(part_3, x) == within_relative(log(1 + root) / cube, 1e-20, why));
    CHECK(slope(collected, x) == within_relative((V(y) - Fifty(0.25)) / y, 1e-18,
          "the same; the parts nearly cancel"));
  }
}

CHECK_THAT("collected they are W, but for one and the same constant")
{
  for(const double x : {0.01, 0.1, 0.3, 0.6, 0.9})
  {
    const Fifty constant = W(Fifty(x)) - collected(Fifty(x));
    CHECK(constant == within(W(Fifty(1)) - collected(Fifty(1)), 1e-43, "parts of 10⁴ cancel"));
  }
}

/*!
The scan is at its worst here: powers, signs, a whole member lost. Each reading is tried at $v = 0{,}6$, the
differentials by the slopes of what stands on the right, and the sums by their value.
*/

const double L = std::log(1.8);  // l(1+√(1−vv))

template <class Part>
bool is_slope(double reading, Part part)
{
  return reading == within_relative(slope(part, 0.6), 1e-14, "few roundings");
}

const Emendation factor{
    "§24, (1), third term", {"2·3·5²/(2·4²·6²)", 150.0 / 1152}, {"1·3·5²/(2·4²·6²)", 75.0 / 1152},
    "§23 has it",
    [](double coefficient) {
      return coefficient == within_ulps(static_cast<Fifty>(pendulum::entry(3, 1)), 1, "one division");
    }};

const Emendation first_cube{
    "§24, (2)", {"−dv/v² (1 + l 2)", -(1 + std::numbers::ln2) / 0.36},
    {"−dv/v³ (1 + l 2)", -(1 + std::numbers::ln2) / 0.216}, "the first part of V, over v",
    [](double integrand) { return is_slope(integrand, part_1<Fifty>); }};

const Emendation second_cube{
    "§24, (3), on both its places", {"dv/(v²√(1−vv))", 1 / (0.36 * 0.8)},
    {"dv/(v³√(1−vv))", 1 / (0.216 * 0.8)},
    "the second part of V, over v", [](double integrand) { return is_slope(integrand, part_2<Fifty>); }};

const Emendation differential{
    "§24, (4), left side", {"ddv/v³ l(1+√(1−vv)), nothing if dv is constant", 0.0},
    {"dv/v³ l(1+√(1−vv))", L / 0.216}, "the third part of V, over v",
    [](double integrand) { return is_slope(integrand, part_3<Fifty>); }};

const Emendation third_cube{
    "§24, (4), the integral that is left", {"dv/v² (1−√(1−vv))/√(1−vv)", 0.25 / 0.36},
    {"dv/v³ (1−√(1−vv))/√(1−vv)", 0.25 / 0.216}, "the left side has the cube",
    [](double left) { return is_slope(L / 0.216 + 0.25 / 0.216 / 2 - left / 2, part_3<Fifty>); }};

bool is_part_3(double reading)
{
  return reading == within_relative(part_3(Fifty(0.6)), 1e-14, "few roundings");
}

const double rest_of_3 = 0.8 / 1.44 + L / 4 - std::log(0.6) / 4 - 1 / 1.44;

const Emendation minus{
    "§24, (5)", {"1/(2vv) l(1+√(1−vv))", L / 0.72 + rest_of_3},
    {"−1/(2vv) l(1+√(1−vv))", -L / 0.72 + rest_of_3},
    "it comes from (4) with its minus", is_part_3};

const double rest_of_all = -0.8 / 1.44 - (0.25 + 1 / 0.72) * L;

const Emendation member{
    "§24, (6)", {"1/(4vv) lv", std::log(0.6) / 1.44 + rest_of_all},
    {"¼ lv + (1 + 2 l 2)/(4vv)", std::log(0.6) / 4 + (1 + 2 * std::numbers::ln2) / 1.44 + rest_of_all},
    "the sum of (2), (3) and (5)",
    [](double sum) {
      const Fifty parts = part_1(Fifty(0.6)) + part_2(Fifty(0.6)) + part_3(Fifty(0.6));
      return sum == within_relative(parts, 1e-14, "few roundings");
    }};
