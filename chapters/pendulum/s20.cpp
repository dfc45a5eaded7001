#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 20, "The integrals of the whole descent, written out")

using exact::double_factorial_ratio, pendulum::log_cot_half;

/*!
## What Euler does

For the *whole* descent, which is his chief concern, the integrals become simpler. There $\omega = 90°$, its
cosine vanishes, and of every pair of ends in {{sec pendulum.19}} only the one at α remains. With each
integral put into the next they are

$$ \int_\alpha^{90°}\frac{d\omega}{\sin\omega} = l{{entry logarithm}}\cot\tfrac12\alpha, \tag{1} $$

$$ \int_\alpha^{90°}\frac{d\omega}{\sin^3\omega} = \frac{\cos\alpha}{2\sin^2\alpha} +
     \frac12\,l\cot\tfrac12\alpha, \tag{2} $$

$$ \int_\alpha^{90°}\frac{d\omega}{\sin^5\omega} = \frac{\cos\alpha}{4\sin^4\alpha} +
     \frac{3\cos\alpha}{2\cdot4\sin^2\alpha}
   + \frac{1\cdot3}{2\cdot4}\,l\cot\tfrac12\alpha{{entry fifth}}, \tag{3} $$

$$ \begin{aligned} \int_\alpha^{90°}\frac{d\omega}{\sin^7\omega} = \frac{\cos\alpha}{6\sin^6\alpha}
   &+ \frac{5\cos\alpha}{4\cdot6\sin^4\alpha} + \frac{3\cdot5\cos\alpha}{2\cdot4\cdot6\sin^2\alpha} \\
   &+ \frac{1\cdot3\cdot5}{2\cdot4\cdot6}\,l\cot\tfrac12\alpha{{entry seventh}}, \end{aligned} \tag{4} $$

$$ \begin{aligned} \int_\alpha^{90°}\frac{d\omega}{\sin^9\omega} = \frac{\cos\alpha}{8\sin^8\alpha}
   &+ \frac{7\cos\alpha}{6\cdot8\sin^6\alpha} + \frac{5\cdot7\cos\alpha}{4\cdot6\cdot8\sin^4\alpha} \\
   &+ \frac{3\cdot5\cdot7\cos\alpha}{2\cdot4\cdot6\cdot8\sin^2\alpha} \\
   &+ \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8}\,l\cot\tfrac12\alpha{{entry ninth}}, \qquad\text{etc.}
   \end{aligned} \tag{5} $$

## The program

::: margin
$a_m/a_i$ is the product of the fractions $\frac{2j-1}{2j}$ for $j$ from $i+1$ to $m$: the rungs of the ladder
that lie between.
:::

The law is easily read off. With $a_n = \frac{1\cdot3\cdots(2n-1)}{2\cdot4\cdots2n}$,

$$ \int_\alpha^{90°}\frac{d\omega}{\sin^{2m+1}\omega} =
     \cos\alpha\sum_{i=1}^{m}\frac{a_m}{a_i}\cdot\frac{1}{2i\,\sin^{2i}\alpha}
   + a_m\,l\cot\tfrac12\alpha. \tag{A} $$

Multiplied by $\sin^{2m}\alpha$ the pieces do not overflow, and since all are positive they can safely be
added up.
*/

template <class Real>
Real written_out(int m, Real alpha)  // (A), times sin²ᵐα
{
  using std::cos, std::sin;
  const Real x = sin(alpha) * sin(alpha);
  Real sum = 0;
  Real factor = 1;  // a_m/a_i · sin²⁽ᵐ⁻ⁱ⁾α
  for(int i = m; i > 0; --i)
  {
    sum += factor / (2 * i);
    factor *= x * (2 * i - 1) / (2 * i);
  }
  return cos(alpha) * sum + factor * log_cot_half(alpha);
}

const auto alpha = angle("alpha", 30_deg, above_to(0_deg, 90_deg), "α = ½η, where the descent begins");
const auto m = integer("m", 4, 0, 500, "the power of the sine is 2m + 1");

TELL
{
  tell("scaled", written_out<double>(m, alpha), "the integral over the whole descent, times sin²ᵐα");
  tell("integral", written_out(m, alpha.fifty()) / pow(sin(alpha.fifty()), 2 * m), "the integral itself");
}

TELL
{
  curve("shares", {"alpha", "s8", "s6", "s4", "s2", "l"}, [](Curve& c) {
    for(double degree = 1; degree < 90; degree += 0.5)
    {
      const double a = degree * 1_deg, x = std::pow(std::sin(a), 2);
      const double C = std::cos(a) / written_out(4, a), L = log_cot_half(a) / written_out(4, a);
      c.put({degree, C / 8, 7 * C * x / 48, 35 * C * x * x / 192, 105 * C * x * x * x / 384,
             105 * L * x * x * x * x / 384});
    }
  });
}

/*!
From {{alpha}} on the integral {{eq 5}} is {{integral|8}}.

::: figure pendulum-20
alt: Shares of the five pieces of the integral of one over the ninth power of the sine, against alpha from 0
to 90 degrees. Near 0 the piece with the eighth power is everything; towards 90 degrees all have a part.

What part of {{eq 5}} each of its five pieces has. When α is small the first is nearly everything. Multiplied
by the series' $\sin^8\alpha$ it loses all its sines and does not vanish with α, while the other pieces, the
logarithm last, keep some. That is where the quarter of {{sec pendulum.17}} came from, and what will come of
the later terms.
:::

## Checks
*/

Fifty quadrature(int power, const Fifty& from)  // times the sine's power, less one
{
  const auto f = [&](const Fifty& y) { return pow(sin(from) / sin(from + y), power - 1) / sin(from + y); };
  return exact::integrate(f, 0, exact::pi() / 2 - from).value;
}

CHECK_THAT("the closed forms are the integrals, from α = 1° to 89°")
{
  for(const double from : {1_deg, 30_deg, 60_deg, 89_deg})
    for(int row = 0; row <= 6; ++row)
      CHECK(written_out(row, Fifty(from))
            == within_relative(quadrature(2 * row + 1, Fifty(from)), 1e-46, "fifty digits; 89° costs two"));
}

Rational coefficient(int m, int i)  // of cos α/sin²ⁱα in (A)
{
  return double_factorial_ratio(m) / (2 * i * double_factorial_ratio(i));
}

CHECK_THAT("the law gives the coefficients that he writes")
{
  CHECK(coefficient(1, 1) == Rational(1, 2));
  CHECK(coefficient(2, 2) == Rational(1, 4));
  CHECK(coefficient(2, 1) == Rational(3, 2 * 4));
  CHECK(coefficient(3, 3) == Rational(1, 6));
  CHECK(coefficient(3, 2) == Rational(5, 4 * 6));
  CHECK(coefficient(3, 1) == Rational(3 * 5, 2 * 4 * 6));
  CHECK(coefficient(4, 4) == Rational(1, 8));
  CHECK(coefficient(4, 3) == Rational(7, 6 * 8));
  CHECK(coefficient(4, 2) == Rational(5 * 7, 4 * 6 * 8));
  CHECK(coefficient(4, 1) == Rational(3 * 5 * 7, 2 * 4 * 6 * 8));
}

CHECK_THAT("near 90° every integral is nearly 90° − α")
{
  const Fifty gap("1e-6");
  for(const int row : {0, 1, 5, 20})
    CHECK(written_out(row, exact::pi() / 2 - gap) / pow(cos(gap), 2 * row)
          == within_relative(gap * (1 + (2 * row + 1) * gap * gap / 6), 1e-21, "the next term has gap⁴"));
}

/*!
Our copy again: the logarithm has become an integral; in the third line, and worse in the fourth and fifth,
powers of the sine, factors above and factors below are lost. Each reading is worked out at $\alpha = 30°$ and
held against the quadrature, the logarithm being mended first.
*/

const double S = std::sin(30_deg);
const double C = std::cos(30_deg);
const double L = log_cot_half(30_deg);

double over(int k)  // cos α/sinᵏα
{
  return C / std::pow(S, k);
}

bool is_integral(double reading, int k)
{
  return reading
         == within_relative(quadrature(k, 30_deg) / pow(sin(Fifty(30_deg)), k - 1), 1e-14, "few roundings");
}

const Emendation logarithm{"§20, all lines",
                           {"∫ cot ½α", 2 * std::log(std::sin(15_deg))},
                           {"l cot ½α", L},
                           "(1) is the first term of §16",
                           [](double reading) { return is_integral(reading, 1); }};

const Emendation fifth{
    "§20, (3)",
    {"cos α/(4 sin²α) + 3 cos α/(2·4 (sin³α)²) + 1/(2·4) l cot ½α", over(2) / 4 + 3 * over(6) / 8 + L / 8},
    {"cos α/(4 sin⁴α) + 3 cos α/(2·4 sin²α) + 1·3/(2·4) l cot ½α",
     over(4) / 4 + 3 * over(2) / 8 + 3 * L / 8},
    "§19, n = 4, with (2) put into it",
    [](double reading) { return is_integral(reading, 5); }};

const Emendation seventh{
    "§20, (4)",
    {"cos α/(6 sin²α) + 5 cos α/(4·6 (sin³α)²) + 3 cos α/(2·4·6 (sin⁵α)²) + 1/(2·4·6) l cot ½α",
     over(2) / 6 + 5 * over(6) / 24 + 3 * over(10) / 48 + L / 48},
    {"cos α/(6 sin⁶α) + 5 cos α/(4·6 sin⁴α) + 3·5 cos α/(2·4·6 sin²α) + 1·3·5/(2·4·6) l cot ½α",
     over(6) / 6 + 5 * over(4) / 24 + 15 * over(2) / 48 + 15 * L / 48},
    "§19, n = 6, with (3) put into it",
    [](double reading) { return is_integral(reading, 7); }};

const Emendation ninth{
    "§20, (5)",
    {"cos α/(8 sin²α) + 7 cos α/(8·8 (sin³α)²) + 5·7 cos α/(2·4·6 (sin⁵α)²) "
     "+ 3·5·7 cos α/(2·4·6·8 (sin⁷α)²) + 1/(2·4·6·8) l cot ½α",
     over(2) / 8 + 7 * over(6) / 64 + 35 * over(10) / 48 + 105 * over(14) / 384 + L / 384},
    {"cos α/(8 sin⁸α) + 7 cos α/(6·8 sin⁶α) + 5·7 cos α/(4·6·8 sin⁴α) + 3·5·7 cos α/(2·4·6·8 sin²α) "
     "+ 1·3·5·7/(2·4·6·8) l cot ½α",
     over(8) / 8 + 7 * over(6) / 48 + 35 * over(4) / 192 + 105 * over(2) / 384 + 105 * L / 384},
    "§19, n = 8, with (4) put into it",
    [](double reading) { return is_integral(reading, 9); }};

/*!
What is told, by quadrature:
*/

CHECK_THAT("the integral told is that of quadrature, at 30°, near the top, at a high power and near 90°")
{
  for(const Told& now : told_at("", "alpha=1e-9rad m=3", "alpha=89.9 m=500", "alpha=45 m=0"))
  {
    const Fifty truth = quadrature(2 * m + 1, alpha.fifty());
    CHECK(now.value("scaled")
          == within_relative(truth, 1e-12, "near 90° the double of α has lost three digits"));
    const Fifty whole = truth / pow(sin(alpha.fifty()), 2 * m);
    CHECK(now.value("integral") == within_relative(whole, 1e-40, "quadrature of fifty digits"));
  }
  for(const Told& now : told_at("", "alpha=1 m=40", "alpha=1e-6 m=2"))
    CHECK(now.value("scaled")
          == within_relative(quadrature(2 * m + 1, alpha.fifty()), 1e-15,
                             "far from 90° few roundings count"));
}

CHECK_THAT("the five shares of the figure are those of the five pieces, and make one")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("shares", 6))
    {
      const Fifty a = Fifty(point.at("alpha")) * exact::pi() / 180, s = sin(a),
                  whole = quadrature(9, a) / pow(s, 8);
      CHECK(point.value("s8")
            == within_relative(cos(a) / (8 * pow(s, 8)) / whole, 2e-14, "a rounded angle"));
      CHECK(point.value("s6")
            == within_relative(7 * cos(a) / (48 * pow(s, 6)) / whole, 2e-14, "a rounded angle"));
      CHECK(point.value("s4")
            == within_relative(35 * cos(a) / (192 * pow(s, 4)) / whole, 2e-14, "a rounded angle"));
      CHECK(point.value("s2")
            == within_relative(105 * cos(a) / (384 * s * s) / whole, 2e-14, "a rounded angle"));
      CHECK(point.value("l")
            == within_relative(-105 * log(tan(a / 2)) / 384 / whole, 2e-14, "a rounded angle"));
      CHECK(point.at("s8") + point.at("s6") + point.at("s4") + point.at("s2") + point.at("l")
            == within(1, 2e-14, "five rounded shares"));
    }
}

/*!
## Go on from here

::: exercise
The series of {{sec pendulum.17}} multiplies the integral with $\sin^{2m+1}\omega$ by $a_m\sin^{2m}\alpha$.
What does its $m$th term bring to the descent when α becomes infinitely small?

answer: $\frac{a_m}{2m}$, however near the top. Of all the pieces of {{eq A}} only that with $i = m$ is left,
without any sine: `--alpha 1e-6 --m 4` tells an eighth. All these terms together, an eighth times
$\frac{35}{128}$ the fourth of them, are the column that {{sec pendulum.22}} sums.
:::
*/

CHECK_THAT("as α vanishes, the scaled integral becomes 1/2m")
{
  for(const Told& now : told_at("alpha=1e-6 m=4", "alpha=1e-6 m=50"))
    CHECK(now.value("scaled")
          == within_ulps(Fifty(1) / (2 * int(m)), 2, "sin²α is 3·10⁻¹⁶, and it times 7/48"));
  CHECK(double_factorial_ratio(4) == Rational(35, 128));
}
