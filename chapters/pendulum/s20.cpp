#include <array>

#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 20, "The integrals of the whole descent, written out")

using exact::double_factorial_ratio;
using pendulum::log_cot_half, pendulum::scaled_integral;

/*!
## What Euler does

The time of the *whole* descent is what he is after, and there $\omega = 90°$: the cosine of ω vanishes, and
of every pair of ends in {{sec pendulum.19}} only the one at α remains. Put one into the next, the integrals
become

$$ \int_\alpha^{90°}\frac{d\omega}{\sin\omega} = l\cot\tfrac12\alpha, \tag{1} $$

$$ \int_\alpha^{90°}\frac{d\omega}{\sin^3\omega} = \frac{\cos\alpha}{2\sin^2\alpha} +
     \frac12\,l\cot\tfrac12\alpha, \tag{2} $$

$$ \int_\alpha^{90°}\frac{d\omega}{\sin^5\omega} = \frac{\cos\alpha}{4\sin^4\alpha} +
     \frac{3\cos\alpha}{2\cdot4\sin^2\alpha}
   + \frac{1\cdot3}{2\cdot4}\,l\cot\tfrac12\alpha, \tag{3} $$

$$ \begin{aligned} \int_\alpha^{90°}\frac{d\omega}{\sin^7\omega} = \frac{\cos\alpha}{6\sin^6\alpha}
   &+ \frac{5\cos\alpha}{4\cdot6\sin^4\alpha} + \frac{3\cdot5\cos\alpha}{2\cdot4\cdot6\sin^2\alpha} \\
   &+ \frac{1\cdot3\cdot5}{2\cdot4\cdot6}\,l\cot\tfrac12\alpha, \end{aligned} \tag{4} $$

$$ \begin{aligned} \int_\alpha^{90°}\frac{d\omega}{\sin^9\omega} = \frac{\cos\alpha}{8\sin^8\alpha}
   &+ \frac{7\cos\alpha}{6\cdot8\sin^6\alpha} + \frac{5\cdot7\cos\alpha}{4\cdot6\cdot8\sin^4\alpha} \\
   &+ \frac{3\cdot5\cdot7\cos\alpha}{2\cdot4\cdot6\cdot8\sin^2\alpha} \\
   &+ \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8}\,l\cot\tfrac12\alpha, \qquad\text{etc.}
   \end{aligned} \tag{5} $$

## The program

The law is easily read off. With $a_n = \frac{1\cdot3\cdots(2n-1)}{2\cdot4\cdots2n}$, the product under the
last term,

$$ \int_\alpha^{90°}\frac{d\omega}{\sin^{2m+1}\omega} =
     \cos\alpha\sum_{i=1}^{m}\frac{a_m}{a_i}\cdot\frac{1}{2i\,\sin^{2i}\alpha}
   + a_m\,l\cot\tfrac12\alpha. \tag{6} $$

::: margin
$a_m/a_i$ is the product of the fractions $\frac{2j-1}{2j}$ for $j$ from $i+1$ to $m$: the rungs of the ladder
that lie between.
:::
*/

Rational coefficient(int m, int i)  // of cos α / sin²ⁱα in (6)
{
  return double_factorial_ratio(m) / (2 * i * double_factorial_ratio(i));
}

/*!
Multiplied by $\sin^{2m}\alpha$ the pieces neither overflow nor cancel, so the written form can be added up
safely; whether that is wise is another question, since the recurrence of {{sec pendulum.18}} comes to the
same in a third of the operations.
*/

template <class Real>
Real written_out(int m, Real alpha)  // (6) times sin²ᵐα
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

/*!
The reader may choose the angle and the power.
*/

const auto alpha = angle("alpha", 30_deg, above_to(0_deg, 90_deg), "α = ½η, where the descent begins");
const auto m = integer("m", 4, 0, 500, "the power of the sine is 2m + 1");

TELL
{
  tell("scaled", written_out<double>(m, alpha), "the integral over the whole descent, times sin²ᵐα");
  tell("log_of_integral", std::log10(written_out<double>(m, alpha)) - 2 * m * std::log10(std::sin(alpha)),
       "common logarithm of the integral itself");
  auto& pieces = table("pieces", "The coefficients of (1) to (5), in lowest terms.",
                       {{"power", "power"}, {"s8", "cos α/sin⁸α"}, {"s6", "cos α/sin⁶α"},
                        {"s4", "cos α/sin⁴α"},
                        {"s2", "cos α/sin²α"}, {"l", "l cot ½α"}});
  for(int row = 0; row <= 4; ++row)
  {
    std::vector<Cell> cells{1.0 * (2 * row + 1)};
    for(int i = 4; i > 0; --i)
      cells.push_back(i <= row ? coefficient(row, i).str() : "");
    cells.push_back(double_factorial_ratio(row).str());
    pieces.row(cells);
  }
}

/*!
The figure's data and the race. For many powers at once the recurrence is the better still, since it gives all
of them.
*/

TELL
{
  curve("shares", {"alpha", "s8", "s6", "s4", "s2", "l"}, [](Curve& c) {
    for(double degrees_ = 1; degrees_ < 90; degrees_ += 0.5)
    {
      const double a = degrees_ * 1_deg;
      const double whole = scaled_integral(4, a);
      std::vector<double> row{degrees_};
      for(int i = 4; i > 0; --i)
        row.push_back(static_cast<double>(coefficient(4, i)) * std::cos(a) * std::pow(std::sin(a), 8
            - 2 * i));
      row.push_back(35.0 / 128 * std::pow(std::sin(a), 8) * log_cot_half(a));
      for(std::size_t i = 1; i < row.size(); ++i)
        row[i] /= whole;
      c.put(row);
    }
  });
  const double a = alpha;
  race("scaled", "sin²ᵐα ∫dω/sin²ᵐ⁺¹ω", scaled_integral(m, Fifty(a)),
       {{"written out, (6)", [=] { return written_out<double>(m, a); }},
        {"recurrence of §18", [=] { return scaled_integral<double>(m, a); }}});
}

/*!
{{table pieces}}

::: figure pendulum-20
alt: Shares of the five pieces of the integral of one over the ninth power of the sine, against alpha from 0
to 90 degrees. Near 0 the piece with the eighth power is everything; towards 90 degrees all have a part.

What part of {{eq 5}} each of its five pieces has. When α is small the first is nearly everything, and the
logarithm is nothing: after multiplication by the series' $\sin^8\alpha$ it is of the order $\sin^8\alpha$,
while the first piece has lost all its sines. That is where the quarter of {{sec pendulum.17}} came from, and
what will come of the later terms.
:::

## Checks

The pieces against quadrature, and the law {{eq 6}} against the five forms that are printed, in exact
fractions.
*/

Fifty quadrature(int power, const Fifty& from)  // times the sine's power, less one
{
  return exact::integrate([&](const Fifty& y) {
    return pow(sin(from) / sin(from + y), power - 1) / sin(from + y);
  }, 0, exact::pi() / 2 - from).value;
}

CHECK_THAT("the closed forms are the integrals, from α = 1° to 89°")
{
  for(const double from : {1_deg, 30_deg, 60_deg, 89_deg})
    for(int row = 0; row <= 6; ++row)
      CHECK(written_out(row, Fifty(from))
            == within_relative(quadrature(2 * row + 1, Fifty(from)), 1e-38, "the quadrature's 10⁻⁴⁰"));
}

CHECK_THAT("the law gives the coefficients that he writes")
{
  CHECK(coefficient(1, 1) == Rational(1, 2));
  CHECK(coefficient(2, 2) == Rational(1, 4));
  CHECK(coefficient(2, 1) == Rational(3, 2 * 4));
  CHECK(coefficient(3, 2) == Rational(5, 4 * 6));
  CHECK(coefficient(3, 1) == Rational(3 * 5, 2 * 4 * 6));
  CHECK(coefficient(4, 3) == Rational(7, 6 * 8));
  CHECK(coefficient(4, 2) == Rational(5 * 7, 4 * 6 * 8));
  CHECK(coefficient(4, 1) == Rational(3 * 5 * 7, 2 * 4 * 6 * 8));
}

CHECK_THAT("adding up the pieces and the recurrence agree to the last digits for the 1001st power too")
{
  for(const double from : {1e-300, 1e-3, 0.1, 1.0})
    CHECK(written_out(500, from) == within_ulps(scaled_integral(500, Fifty(from)),
          3 / std::pow(std::cos(from), 2),
                                                "the bound of the recurrence: the same steps, backwards"));
}

CHECK_THAT("near 90° every integral is nearly 90° − α")
{
  const Fifty gap("1e-6");
  for(int row = 0; row <= 20; ++row)
    CHECK(written_out(row, exact::pi() / 2 - gap) / pow(cos(gap), 2 * row)
          == within(gap, (2 * row + 1) * 1e-18, "the integrand is 1 + (2m+1)/2 times a square below 10⁻¹²"));
}

/*!
The scan again. The logarithm has become an integral; in the third line, and worse in the fourth and fifth,
powers of the sine, factors above and factors below are lost. Each reading is worked out at $\alpha = 30°$ and
held against the quadrature, the logarithm being mended first.
*/

const double S = std::sin(30_deg);
const double C = std::cos(30_deg);
const double L = log_cot_half(30_deg);

double power(int k) { return std::pow(S, k); }

bool is_integral(double reading, int k)
{
  return reading == within_relative(quadrature(k, 30_deg) / pow(sin(Fifty(30_deg)), k - 1), 1e-14,
      "few roundings");
}

const Emendation logarithm{
    "§20, all lines", {"∫ cot ½α", 2 * std::log(std::sin(15_deg))}, {"l cot ½α", L},
    "(1) is the first term of §16",
    [](double reading) { return is_integral(reading, 1); }};

const Emendation fifth{
    "§20, (3)", {"cos α/(4 sin²α) + 3 cos α/(2·4 (sin³α)²) + 1/(2·4) l cot ½α",
                 C / (4 * power(2)) + 3 * C / (8 * power(6)) + L / 8},
    {"cos α/(4 sin⁴α) + 3 cos α/(2·4 sin²α) + 1·3/(2·4) l cot ½α",
     C / (4 * power(4)) + 3 * C / (8 * power(2)) + 3 * L / 8},
    "§19, n = 4, with (2) put into it", [](double reading) { return is_integral(reading, 5); }};

const Emendation seventh{
    "§20, (4)", {"sin²α, (sin³α)², (sin⁵α)²; 3 above 2·4·6, and 1 above the logarithm",
                 C / (6 * power(2)) + 5 * C / (24 * power(6)) + 3 * C / (48 * power(10)) + L / 48},
    {"sin⁶α, sin⁴α, sin²α; 3·5 and 1·3·5 above",
     C / (6 * power(6)) + 5 * C / (24 * power(4)) + 15 * C / (48 * power(2)) + 15 * L / 48},
    "§19, n = 6, with (3) put into it", [](double reading) { return is_integral(reading, 7); }};

const Emendation ninth{
    "§20, (5)", {"sin²α, (sin³α)², (sin⁵α)², (sin⁷α)²; 8·8, 2·4·6 and 2·4·6·8 below, 1 above the logarithm",
                 C / (8 * power(2)) + 7 * C / (64 * power(6)) + 35 * C / (48 * power(10))
                     + 105 * C / (384 * power(14)) + L / 384},
    {"sin⁸α, sin⁶α, sin⁴α, sin²α; 6·8, 4·6·8, 2·4·6·8; 1·3·5·7",
     C / (8 * power(8)) + 7 * C / (48 * power(6)) + 35 * C / (192 * power(4)) + 105 * C / (384 * power(2))
         + 105 * L / 384},
    "§19, n = 8, with (4) put into it", [](double reading) { return is_integral(reading, 9); }};
