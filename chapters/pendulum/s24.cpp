#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 24, "The third column: three integrals")

using exact::integrate, exact::ln2, pendulum::root_of, pendulum::V, pendulum::W;

/*!
## What Euler does

The sum of the third column is an integral, which falls into three parts. The series of {{sec pendulum.23}},
whose left side he calls $V$, has the right factors above; multiplied by $\frac{dv}{v}$ and integrated it gets
the missing ones below as well,

$$ \begin{aligned} \int\frac{V\,dv}{v} = \frac1{2^2}\,lv &+ \frac{1\cdot3^2}{2^2\cdot4^2}vv
   + \frac{1\cdot3\cdot5^2}{2\cdot4^2\cdot6^2}{{entry factor}}v^4 \\
   &+ \frac{1\cdot3\cdot5\cdot7^2}{2\cdot4\cdot6^2\cdot8^2}v^6 + \text{etc.}, \end{aligned} \tag{1} $$

so that the sum is $\int\frac{V\,dv}{v} - \frac14\,lv$ for $v = 1$. It remains to integrate the three parts of
$V$. The first gives

$$ \int -\frac{dv}{v^3}\,(1 + l2) = \frac{1+l2}{2vv}, \tag{2} $$

and the second

$$
\int\frac{dv}{v^3{{entry cubes}}\sqrt{1-vv}} = -\frac{\sqrt{1-vv}}{2vv} -
\tfrac12\,l\left(1+\sqrt{1-vv}\right) +
     \tfrac12\,lv. \tag{3} $$

The third he reduces by a well-known rule,

$$ \begin{aligned} \int\frac{dv}{v^3}{{entry differential}}\,l\left(1+\sqrt{1-vv}\right)
   ={}& -\frac{1}{2vv}\,l\left(1+\sqrt{1-vv}\right) \\
   &- \tfrac12\int\frac{dv}{v^3}\cdot\frac{1-\sqrt{1-vv}}{\sqrt{1-vv}}. \end{aligned} \tag{4} $$

::: margin
The rule is integration by parts. The differential of the logarithm is
$-\frac{dv}{v}\cdot\frac{1-\sqrt{1-vv}}{\sqrt{1-vv}}$.
:::

The last integral is {{eq 3}} less that of $\frac{dv}{v^3}$. Therefore the third part is

$$ \begin{aligned} -{{entry minus}}\frac1{2vv}\,l\left(1+\sqrt{1-vv}\right) &+ \frac{\sqrt{1-vv}}{4vv} \\
   &+ \tfrac14\,l\left(1+\sqrt{1-vv}\right) - \tfrac14\,lv - \frac1{4vv}, \end{aligned} \tag{5} $$

and all parts together, with a constant still to be found,

$$ \begin{aligned} \tfrac14\,lv{{entry member}} + \frac{1+2l2}{4vv} &- \frac{\sqrt{1-vv}}{4vv} \\
   &- \left(\frac14 + \frac1{2vv}\right) l\left(1+\sqrt{1-vv}\right) + C. \end{aligned} \tag{6} $$

## The program

The three integrals and their sum, as they are written.
*/

Fifty part_1(const Fifty& v)  // (2)
{
  return (1 + ln2()) / (2 * v * v);
}

Fifty part_2(const Fifty& v)  // (3)
{
  const Fifty root = root_of(v);
  return -root / (2 * v * v) - log(1 + root) / 2 + log(v) / 2;
}

Fifty part_3(const Fifty& v)  // (5)
{
  const Fifty vv = v * v, root = root_of(v);
  return -log(1 + root) / (2 * vv) + root / (4 * vv) + log(1 + root) / 4 - log(v) / 4 - 1 / (4 * vv);
}

Fifty all_parts(const Fifty& v)  // (6), without C
{
  const Fifty vv = v * v, root = root_of(v);
  return log(v) / 4 + (1 + 2 * ln2()) / (4 * vv) - root / (4 * vv)
         - (Fifty(0.25) + 1 / (2 * vv)) * log(1 + root);
}

/*!
What they should come to is the series {{eq 1}} without its logarithm, the function $W(v) =
\int\frac{V\,dv}{v} - \frac14lv$ that vanishes at $v = 0$. How $W$ is had without loss of digits is told in
{{sec pendulum.25}}.
*/

const auto v = real("v", 1.0, none, above_to(1e-10, 1), "the variable; Euler puts 1 in the end");

TELL
{
  const Fifty at = v.fifty();
  tell("part_1", part_1(at), "the first part integrated, (2)");
  tell("part_2", part_2(at), "the second, (3)");
  tell("part_3", part_3(at), "the third, (5)");
  tell("W", W(at), "the sum of the series: at v = 1 that of the third column");
  tell("C", W(at) - (all_parts(at) - log(at) / 4), "so C must be");
}

TELL
{
  curve("integrand", {"v", "integrand"}, [](Curve& c) {
    for(double u = 1; u > 0.005; u -= 0.005)  // the root
    {
      const double x = std::sqrt((1 - u) * (1 + u));
      c.put({x, x > 0 ? (V(x, u) - 0.25) / x : 0});
    }
  });
}

/*!
::: figure pendulum-24
alt: The curve of V less a quarter, divided by v, against v from 0 to 1. It begins at zero, rises slowly, and
goes to infinity at 1; the area under it is shaded.

The sum of the third column as an area: under the curve $\frac{1}{v}\left(V - \frac14\right)$ from 0 to 1 lies
{{W|6}}. At the end the curve goes to infinity, but no faster than $1/\sqrt{1-vv}$, and the area is finite.
:::

The sum is wanted for $v = 1$ only. For other $v$ the same function gives the time of a descent that is *not*
complete, with $v = \sin\alpha/\sin\omega$; {{sec pendulum.15}} makes use of it.

## Checks

The series first; its sum is the area in the figure, here with the root as the variable, so that nothing is
infinite.
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
  const auto by_root = [](const Fifty& u) {
    const Fifty vv = (1 - u) * (1 + u);
    return (V(sqrt(vv), u) - 0.25) * u / vv;
  };
  for(const Fifty& x : {Fifty(0.3), Fifty(0.6), Fifty(1)})
    CHECK(W(x)
          == within_relative(integrate(by_root, root_of(x), 1).value, 1e-40, "the quadrature's bound"));
}

/*!
Then the integrals, each from $a$ to $b$, against quadrature.
*/

CHECK_THAT("each part is the integral that it is said to be")
{
  const auto check = [](Fifty (*part)(const Fifty&), const std::function<Fifty(const Fifty&)>& integrand) {
    for(const auto& [a, b] : {std::pair(0.1, 0.6), std::pair(0.6, 0.9)})
      CHECK(part(b) - part(a)
            == within_relative(integrate(integrand, a, b).value, 1e-44, "parts of 10³ cancel"));
  };
  check(part_1, [](const Fifty& y) { return -(1 + ln2()) / pow(y, 3); });
  check(part_2, [](const Fifty& y) { return 1 / (pow(y, 3) * root_of(y)); });
  check(part_3, [](const Fifty& y) { return log(1 + root_of(y)) / pow(y, 3); });
  check(all_parts, [](const Fifty& y) { return V(y) / y; });
}

CHECK_THAT("(6) is the sum of the parts, and W but for one and the same constant")
{
  const Fifty C = W(Fifty(1)) - all_parts(1);
  for(const Fifty& x : {Fifty(0.01), Fifty(0.1), Fifty(0.6), Fifty(1)})
  {
    CHECK(all_parts(x) == within(part_1(x) + part_2(x) + part_3(x), 1e-44, "parts of 10⁴"));
    CHECK(W(x) == within(all_parts(x) - log(x) / 4 + C, 1e-44, "the same"));
  }
}

/*!
Our copy has many slips here: it repeats the damage of {{sec pendulum.23}} in the three parts of $V$, and
adds wrong powers and signs and a lost member. The readings are tried by quadrature from $v = 0.3$ to
$0.6$.
*/

double rise(Fifty (*f)(const Fifty&))
{
  return static_cast<double>(f(0.6) - f(0.3));
}

Fifty area(const std::function<Fifty(const Fifty&)>& integrand)
{
  return integrate(integrand, 0.3, 0.6).value;
}

const auto is_third = [](double rise) {
  return rise
         == within_ulps(area([](const Fifty& y) { return log(1 + root_of(y)) / pow(y, 3); }), 2,
                        "roundings");
};

const Emendation factor{
    "§24, (1), third term",
    {"2·3·5²/(2·4²·6²)", 2},
    {"1·3·5²/(2·4²·6²)", 1},
    "it is an entry of the array",
    [](double first) { return Rational::exactly(first) * 75 / 1152 == pendulum::entry(3, 1); }};

const Emendation cubes{
    "§24, under the integrals of (2), of (3) in both its places, and on the right of (4)",
    {"v²", 2},
    {"v³", 3},
    "only the cubes give what stands on the right, here of (3)",
    [](double p) {
      const Fifty second = area([p](const Fifty& y) { return 1 / (pow(y, Fifty(p)) * root_of(y)); });
      return rise(part_2) == within_ulps(second, 2, "roundings");
    }};

const Emendation differential{
    "§24, (4), left side",
    {"ddv/v³ l(1+√(1−vv))", 0},
    {"dv/v³ l(1+√(1−vv))", [] { return rise(part_3); }},
    "it is the third part of V, over v; a second differential is nothing, dv being constant",
    is_third};

const Emendation minus{
    "§24, (5)",
    {"1/(2vv) l(1+√(1−vv))",
     [] { return rise([](const Fifty& y) { return part_3(y) + log(1 + root_of(y)) / (y * y); }); }},
    {"−1/(2vv) l(1+√(1−vv))", [] { return rise(part_3); }},
    "it comes from (4) with its minus",
    is_third};

const Emendation member{
    "§24, (6)",
    {"1/(4vv) lv",
     [] {
       return rise([](const Fifty& y) {
         return all_parts(y) - log(y) / 4 - (1 + 2 * ln2()) / (4 * y * y) + log(y) / (4 * y * y);
       });
     }},
    {"¼ lv + (1 + 2 l 2)/(4vv)", [] { return rise(all_parts); }},
    "the whole is the integral of V dv/v",
    [](double rise) {
      return rise == within_ulps(area([](const Fifty& y) { return V(y) / y; }), 2, "roundings");
    }};

/*!
What is told: each part by quadrature from where it stands to 1, where all is elementary; the constant in
closed form.
*/

CHECK_THAT("the parts told are the integrals from a known place, and C is ¼ l 2 − ¼")
{
  const auto from = [](const Fifty& x, const std::function<Fifty(const Fifty&, const Fifty&)>& integrand) {
    const auto by_root = [&](const Fifty& u) {
      const Fifty y = sqrt((1 - u) * (1 + u));
      return integrand(y, u) * u / y;  // dv = −u du/v
    };
    return integrate(by_root, 0, root_of(x)).value;
  };
  for(const Told& now : told_at("", "v=0.25", "v=0.01"))
  {
    const Fifty x = v.fifty();
    const char* const why = "parts of the size of 1/vv";
    const Fifty first = from(x, [](const Fifty& y, const Fifty&) { return (1 + ln2()) / pow(y, 3); });
    CHECK(now.value("part_1") == within((1 + ln2()) / 2 + first, 1e-24, why));
    const Fifty second = from(x, [](const Fifty& y, const Fifty& u) { return 1 / (pow(y, 3) * u); });
    CHECK(now.value("part_2") == within(-second, 1e-24, why));
    const Fifty third = from(x, [](const Fifty& y, const Fifty& u) { return log(1 + u) / pow(y, 3); });
    CHECK(now.value("part_3") == within(Fifty(-0.25) - third, 1e-24, why));
    Fifty series = 0;
    for(int n = 1; n <= 60; ++n)
      series += static_cast<Fifty>(pendulum::entry(n + 1, 1)) * pow(x, 2 * n);
    const bool all = x == Fifty(1);
    CHECK(now.value("W") == within(all ? 3 * ln2() / 4 : series, 1e-29, "Euler's sum, or sixty terms"));
    CHECK(now.value("C") == within(ln2() / 4 - Fifty(0.25), 1e-27, "§26, by an infinitely small v"));
  }
}

CHECK_THAT("the figure's curve is (V − ¼)/v, by the series")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("integrand", 7))
      if(const double x = point.at("v"); x < 0.9)
      {
        Fifty series = 0;
        for(int n = 1; n <= 150; ++n)
          series += static_cast<Fifty>(pendulum::entry(n + 1, 1)) * (2 * n) * pow(Fifty(x), 2 * n - 1);
        CHECK(point.value("integrand")
              == within(series, 3e-14, "v is rounded, and near 0 V is close to ¼"));
      }
}
