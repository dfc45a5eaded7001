#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 17, "The second term adds a quarter")

/*!
## What Euler does

The second term of the series is integrated, and adds a quarter to the first. In {{sec pendulum.15}} the
time of the descent was developed into a series, and {{sec pendulum.16}} kept its first term. To see what
the others amount to, he halves the angles once and for all: let $\tfrac12\psi = \omega$ and
$\tfrac12\eta = \alpha$. The series becomes

$$ \frac{dt\sqrt{2g}}{\sqrt b} = d\omega\left(\frac{1}{\sin\omega} +
     \frac12\cdot\frac{\sin^2\alpha}{\sin^3\omega}
   + \frac{1\cdot3}{2\cdot4}\cdot\frac{\sin^4\alpha}{\sin^5\omega} + \text{etc.}\right), \tag{1} $$

and its first term gives $l\,\dfrac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}$. For
the second he needs the integral of $d\omega/\sin^3\omega$. He guesses its form and leaves two numbers open,

$$ \int\frac{d\omega}{\sin^3\omega} = \frac{A\cos\omega}{\sin^2\omega} + B\int\frac{d\omega}{\sin\omega}.
     \tag{2} $$

Differentiated, and with $\cos^2\omega = 1 - \sin^2\omega$, this says

$$ \begin{aligned} \frac1{\sin^3\omega}
   &= -\frac{A}{\sin\omega} - \frac{2A\cos^2\omega}{\sin^3\omega} + \frac{B}{\sin\omega} \\
   &= \frac{A}{\sin\omega} - \frac{2A}{\sin^3\omega} + \frac{B}{\sin\omega}, \end{aligned} \tag{3} $$

so that $2A = -1$ and $A + B = 0$: $A = -\tfrac12$, $B = \tfrac12$. The constant follows from the integral
being nothing where the descent begins, at $\omega = \alpha$:

$$ \int_\alpha\frac{d\omega}{\sin^3\omega} = \frac{\cos\alpha}{2\sin^2\alpha} -
     \frac{\cos\omega}{2\sin^2\omega}
   + \frac12\,l\,\frac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}. \tag{4} $$

Half of $\sin^2\alpha$ times this is the second term, and both together are

$$ \frac{t\sqrt{2g}}{\sqrt b} = \left(1 + \tfrac14\sin^2\alpha\right)
     l\,\frac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}
   + \tfrac14\cos\alpha - \frac{\cos\omega\,\sin^2\alpha}{4\sin^2\omega}. \tag{5} $$

For the whole descent, $\omega = 90°$,

$$ \frac{t\sqrt{2g}}{\sqrt b} = \left(1 + \tfrac14\sin^2\alpha\right) l\cot\tfrac12\alpha +
     \tfrac14\cos\alpha. \tag{6} $$

And here is the surprise. The second term carries the factor $\sin^2\alpha$, as small as one likes, and yet
it has added $\tfrac14\cos\alpha$, which is very nearly ¼ however small α is. That is a notable quantity; so
much the more must the terms that follow be pursued.

::: margin
Close to the start $\sin\omega$ is hardly more than $\sin\alpha$, and there no term of (1) is smaller than
another.
:::

## The program

As they stand, {{eq 4}} and {{eq 5}} are good for the whole descent. Soon after the start they are not: both
differences are of nearly equal numbers. Both can be taken by hand. With $\delta = \omega - \alpha$,

$$ \begin{aligned} \frac{\cos\alpha}{\sin^2\alpha} - \frac{\cos\omega}{\sin^2\omega}
   &= \frac{2\sin\frac{\omega+\alpha}2\,\sin\frac\delta2\,(1 + \cos\alpha\cos\omega)}
           {\sin^2\alpha\,\sin^2\omega}, \\
   \frac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}
   &= 1 + \frac{\sin\frac12\delta}{\cos\frac12\omega\,\sin\frac12\alpha}. \end{aligned} \tag{7} $$
*/

template <class Real>
Real logarithm(Real alpha, Real delta)  // l(tg ½ω : tg ½α), the first term of (1), by (7)
{
  using std::cos, std::log1p, std::sin;
  return log1p(sin(delta / 2) / (cos((alpha + delta) / 2) * sin(alpha / 2)));
}

template <class Real>
Real scaled_cube(Real alpha, Real delta)  // sin²α times (4), by (7)
{
  using std::cos, std::pow, std::sin;
  const Real omega = alpha + delta;
  const Real difference = 2 * sin(alpha + delta / 2) * sin(delta / 2) * (1 + cos(alpha) * cos(omega));
  return (difference / pow(sin(omega), 2) + pow(sin(alpha), 2) * logarithm(alpha, delta)) / 2;
}

double two_terms(double alpha, double omega)  // (5), as Euler writes it
{
  const double s = std::sin(alpha);
  return (1 + s * s / 4) * std::log(std::tan(omega / 2) / std::tan(alpha / 2)) + std::cos(alpha) / 4
         - std::cos(omega) * s * s / (4 * std::pow(std::sin(omega), 2));
}

/*!
Euler leaves η free, and how far down the time is asked for.
*/

const auto swing_ = amplitude_from_top(5_deg);
const auto psi = angle("psi", 180_deg, above_to(0_deg, 180_deg),
    "angle from the top at which the time is asked for");

TELL
{
  const double eta = swing_.eta;
  require(psi > eta, "psi", "greater than eta, where the descent begins");
  const double alpha = eta / 2;
  const double delta = (psi - eta) / 2;
  const double exact = swing::time_from_rest_past(psi - eta, eta);
  const double first = logarithm(alpha, delta);
  const double second = scaled_cube(alpha, delta) / 2;
  tell("first", first, "the first term of (1), integrated");
  tell("second", second, "the second");
  tell("both", first + second, "their sum, t√(2g/b) by (5)");
  tell("exact", exact, "t√(2g/b), exactly");
  tell("short_by", exact - first - second, "what the terms that follow must bring");
  tell("quarter", std::cos(alpha) / 4, "¼ cos α");
}

/*!
The figure's data: what a step in the logarithm of ω contributes, so that equal areas are equal times.
*/

TELL
{
  curve("integrand", {"omega", "terms1", "terms2", "terms3", "terms10", "exact"}, [](Curve& c) {
    const double alpha = 2.5_deg;
    for(double x = 1; x < 12; x *= x < 1.2 ? 1.0005 : 1.02)
    {
      const double omega = x * alpha;
      const double v = std::sin(alpha) / std::sin(omega);
      double term = omega / std::sin(omega);
      std::vector<double> row{x};
      for(double n = 1, sum = 0; n <= 10; ++n)
      {
        sum += term;
        term *= (2 * n - 1) / (2 * n) * v * v;
        if(n <= 3 || n > 9)
          row.push_back(sum);
      }
      const double gap = std::sin(omega + alpha) * std::sin(omega - alpha);
      row.push_back(gap > 0 ? omega / std::sqrt(gap) : infinity);
      c.put(row);
    }
  });
}

/*!
The second term's integral in both ways. For the whole descent they are equally good; try `--psi 5.000001`.
*/

TELL
{
  const double alpha = swing_.eta / 2;
  const double omega = psi / 2;
  const double delta = (psi - swing_.eta) / 2;
  if(alpha < 1e-100)
    return;  // sin²α has no place in a double
  race("cube", "sin²α ∫dω/sin³ω", scaled_cube(Fifty(alpha), Fifty(delta)),
       {{"Euler's (4)", [=] {
           const double s = std::sin(alpha);
           return (std::cos(alpha) - std::cos(omega) * std::pow(s / std::sin(omega), 2)
                   + s * s * std::log(std::tan(omega / 2) / std::tan(alpha / 2))) / 2;
         }},
        {"differences taken by hand, (7)", [=] { return scaled_cube(alpha, delta); }}});
}

/*!
From {{eta}} below the top the two terms give {{both|7}}, of which {{second|4}} are new, and {{short_by|4}}
are still missing.

::: figure pendulum-17
alt: Contribution to the time against omega over alpha on a logarithmic scale. The exact curve comes down
from infinity at 1 and soon lies on 1. Sums of one, two, three and ten terms begin at 1, 1.5, 1.9 and 3.5
and join the exact curve later or sooner.

Where the time is spent, and what the terms of {{eq 1}} see of it, for $\alpha = 2\tfrac12°$; areas are
times. All the terms are at work within the first few multiples of α, and none may be left out there: the
pendulum is only just leaving the top, and even ten terms see little of the spike with which the exact curve
begins.
:::

## Checks

The two numbers of the ansatz, in exact fractions: {{eq 3}} is an identity in $\sin\omega$.
*/

CHECK_THAT("with A = −½ and B = ½ the differentiated ansatz is an identity")
{
  const Rational A(-1, 2);
  const Rational B(1, 2);
  for(int n = 1; n <= 7; ++n)
  {
    const Rational sine(n, 7);
    const Rational cosine_squared = 1 - sine * sine;
    CHECK(-A / sine - 2 * A * cosine_squared / pow(sine, 3) + B / sine == 1 / pow(sine, 3));
    CHECK(A / sine - 2 * A / pow(sine, 3) + B / sine == 1 / pow(sine, 3));
  }
}

/*!
Then the integrals against quadrature, from just after the start to the end.
*/

Fifty quadrature(const Fifty& alpha, const Fifty& delta, const Fifty& first, const Fifty& second)
{
  const Fifty s = sin(alpha);
  return exact::integrate([&](const Fifty& y) {
    const Fifty sine = sin(alpha + y);
    return first / sine + second * s * s / pow(sine, 3);
  }, 0, delta).value;
}

CHECK_THAT("the integral of dω/sin³ω is what the ansatz makes it, from just after the start to the end")
{
  for(const double alpha : {0.5_deg, 2.5_deg, 30_deg, 60_deg})
    for(const double part : {1e-9, 0.01, 0.5, 1.0})
    {
      const double delta = part * (90_deg - alpha);
      const Fifty truth = quadrature(alpha, delta, 0, 1);
      CHECK(scaled_cube(Fifty(alpha), Fifty(delta))
            == within_relative(truth, 1e-38, "the quadrature's 10⁻⁴⁰"));
      CHECK(scaled_cube(alpha, delta) == within_ulps(truth, 12, "nothing cancels; a dozen roundings"));
    }
}

CHECK_THAT("(5) is the sum of the first two terms")
{
  for(const double alpha : {0.5_deg, 2.5_deg, 30_deg})
    for(const double omega : {45_deg, 75_deg, 90_deg})
    {
      const Fifty truth = quadrature(alpha, Fifty(omega) - alpha, 1, Fifty(0.5));
      CHECK(two_terms(alpha, omega) == within_ulps(truth, 8, "one logarithm, and few roundings"));
    }
}

CHECK_THAT("just after the start (4) loses its digits, and (7) does not")
{
  const double alpha = 30_deg;
  const double delta = 0x1p-40;
  const double omega = alpha + delta;  // exactly, both being multiples of 2⁻⁵³
  const auto end = [](double angle) { return std::cos(angle) / std::pow(std::sin(angle), 2); };
  const double naive = end(alpha) - end(omega);
  const double by_hand = 2 * scaled_cube(alpha, delta) / std::pow(std::sin(alpha), 2)
      - logarithm(alpha, delta);
  CHECK(std::abs(naive / by_hand - 1) > 1e-6);
}

/*!
With the second term as with the first, what is missing does not fade as η does. After the first it tended
to $l2$; now it tends to $l2 - \tfrac14$.
*/

CHECK_THAT("near the top what two terms leave out tends to ln 2 − ¼")
{
  for(const double eta : {1e-9, 1e-150, 1e-300})
  {
    const double missing = swing::quarter_time_from_top(eta) - two_terms(eta / 2, 90_deg);
    CHECK(missing == within(exact::ln2() - 0.25, 4e-13, "logarithms near 690 are rounded at 1.1e-13"));
  }
}

/*!
The scan has lost the ½ before the second differential, though it is there in {{sec pendulum.15}} and again
in the result; and it has mangled both results, which lack the $t$ on the left and the $l$ of the logarithm,
and close the bracket in the wrong place.
*/

const Emendation half{
    "§17, the second differential", {"dω sin²α/sin³ω", 1}, {"½ dω sin²α/sin³ω", 0.5},
    "it is the second term of §15, and only so the result has ¼ cos α",
    [](double coefficient) {
      const double sum = logarithm(2.5_deg, 87.5_deg) + coefficient * scaled_cube(2.5_deg, 87.5_deg);
      return sum == within_ulps(two_terms(2.5_deg, 90_deg), 8, "the same sum, rounded otherwise");
    }};

const double at = 2.5_deg;

const Emendation both_terms{
    "§17, the sum of two terms", {"(1 + ¼ sin²α)[tg ½ω/tg ½α + ¼ cos α − cos ω sin²α A/(4 sin ω)]", [] {
      const double tail = std::cos(45_deg) * std::pow(std::sin(at), 2) * -0.5 / (4 * std::sin(45_deg));
      return (1 + std::pow(std::sin(at), 2) / 4) * (std::tan(22.5_deg) / std::tan(at / 2) + std::cos(at) / 4
          - tail);
    }},
    {"(1 + ¼ sin²α) l(tg ½ω/tg ½α) + ¼ cos α − cos ω sin²α/(4 sin²ω)", [] { return two_terms(at, 45_deg); }},
    "the quadrature of both terms, here up to ω = 45°",
    [](double time) { return time == within_ulps(quadrature(at, 45_deg - at, 1, Fifty(0.5)), 8,
        "few roundings"); }};

const Emendation whole_descent{
    "§17, the whole descent", {"(1 + ¼ sin²α)[cot ½α + ¼ cos α]", [] {
      return (1 + std::pow(std::sin(at), 2) / 4) * (1 / std::tan(at / 2) + std::cos(at) / 4);
    }},
    {"(1 + ¼ sin²α) l cot ½α + ¼ cos α", [] {
      return (1 + std::pow(std::sin(at), 2) / 4) * -std::log(std::tan(at / 2)) + std::cos(at) / 4;  // (6)
    }},
    "the quadrature of both terms up to ω = 90°",
    [](double time) { return time == within_ulps(quadrature(at, 90_deg - at, 1, Fifty(0.5)), 8,
        "few roundings"); }};
