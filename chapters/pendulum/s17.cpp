#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/asked.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 17, "The second term adds a quarter")

/*!
## What Euler does

The second term of the series is integrated, and adds a quarter to the first. To see what the terms after
the first amount to, he halves the angles once and for all: let $\tfrac12\psi = \omega$ and $\tfrac12\eta =
\alpha$. The series of {{sec pendulum.15}} becomes

$$ \frac{dt\sqrt{2g}}{\sqrt b} = d\omega\left(\frac{1}{\sin\omega}
   + \frac12{{entry half}}\cdot\frac{\sin^2\alpha}{\sin^3\omega}
   + \frac{1\cdot3}{2\cdot4}\cdot\frac{\sin^4\alpha}{\sin^5\omega} + \text{etc.}\right), \tag{1} $$

and its first term gives $l\,\dfrac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}$. For
the second he needs the integral of $d\omega/\sin^3\omega$. He guesses its form and leaves two numbers open,

$$ \int\frac{d\omega}{\sin^3\omega} = \frac{A\cos\omega}{\sin^2\omega}
   + B\int\frac{d\omega}{\sin\omega}. \tag{2} $$

Differentiated, and with $\cos^2\omega = 1 - \sin^2\omega$, this says

$$ \begin{aligned} \frac1{\sin^3\omega}
   &= -\frac{A}{\sin\omega} - \frac{2A\cos^2\omega}{\sin^3\omega} + \frac{B}{\sin\omega} \\
   &= \frac{A}{\sin\omega} - \frac{2A}{\sin^3\omega} + \frac{B}{\sin\omega}, \end{aligned} \tag{3} $$

so that $2A = -1$ and $A + B = 0$: $A = -\tfrac12$, $B = \tfrac12$. The integral is therefore
$-\frac{\cos\omega}{2\sin^2\omega} + \frac12\,l\operatorname{tg}\frac12\omega + C$. It has to vanish where
the descent begins, at $\omega = \alpha$, and so $C = \frac{\cos\alpha}{2\sin^2\alpha} -
\frac12\,l\operatorname{tg}\frac12\alpha$:

::: margin
Today: the reduction formula for $\int\csc^3\omega\,d\omega$.
:::

$$ \int_\alpha\frac{d\omega}{\sin^3\omega} = \frac{\cos\alpha}{2\sin^2\alpha}
   - \frac{\cos\omega}{2\sin^2\omega}
   + \frac12\,l\,\frac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}. \tag{4} $$

The first two terms together give

$$ \frac{t\sqrt{2g}}{\sqrt b} = \left(1 + \tfrac14\sin^2\alpha\right)
     l\,\frac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}
   + \tfrac14\cos\alpha - \frac{\cos\omega\,\sin^2\alpha}{4\sin^2\omega}{{entry last_term}}, \tag{5} $$

and for the whole descent, $\omega = 90°$,

$$ \frac{t\sqrt{2g}}{\sqrt b} = \left(1 + \tfrac14\sin^2\alpha\right) l\cot\tfrac12\alpha
   + \tfrac14\cos\alpha{{entry results}}. \tag{6} $$

So the second term has added $\tfrac14\cos\alpha$, which is very nearly ¼: a quantity that is quite notable.
All the more must the terms that follow be pursued.

## The program

It is surprising that a term with the factor $\sin^2\alpha$ should bring a quarter, however small α is. It
does so close to the start, where $\sin\omega$ is hardly more than $\sin\alpha$. There {{eq 4}} and {{eq 5}}
have differences of nearly equal numbers. They can be taken by hand: with $\delta = \omega - \alpha$,

$$ \begin{aligned} \frac{\cos\alpha}{\sin^2\alpha} - \frac{\cos\omega}{\sin^2\omega}
   &= \frac{2\sin\frac{\omega+\alpha}2\,\sin\frac\delta2\,(1 + \cos\alpha\cos\omega)}
           {\sin^2\alpha\,\sin^2\omega}, \\
   \frac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}
   &= 1 + \frac{\sin\frac12\delta}{\cos\frac12\omega\,\sin\frac12\alpha}. \end{aligned} \tag{A} $$
*/

template <class Real>
Real logarithm(Real alpha, Real delta)  // l(tg ½ω : tg ½α), the first term of (1), by (A)
{
  using std::cos, std::log1p, std::sin;
  return log1p(sin(delta / 2) / (cos((alpha + delta) / 2) * sin(alpha / 2)));
}

template <class Real>
Real scaled_cube(Real alpha, Real delta)  // sin²α times (4), by (A)
{
  using std::cos, std::sin;
  const Real omega = alpha + delta, s = sin(omega);
  const Real ends = 2 * (sin(alpha + delta / 2) / s) * (sin(delta / 2) / s) * (1 + cos(alpha) * cos(omega));
  return (ends + pow(sin(alpha), 2) * logarithm(alpha, delta)) / 2;
}

double two_terms(double alpha, double omega)  // (5), as Euler writes it
{
  const double s = std::sin(alpha);
  return (1 + s * s / 4) * std::log(std::tan(omega / 2) / std::tan(alpha / 2)) + std::cos(alpha) / 4
         - std::cos(omega) * s * s / (4 * std::pow(std::sin(omega), 2));
}

double whole_integral(double way,
                      double eta)  // to the lowest point, if the way leads there or past it by rounding
{
  return eta + way < std::numbers::pi ? swing::time_from_rest_past(way, eta)
                                      : swing::quarter_time_from_top(eta);
}

const auto swing_ = amplitude_from_top(5_deg, from_below(30_deg, 180_deg));
const auto psi = angle("psi", 180_deg, above_to(0_deg, 180_deg), "angle from the top that is reached");

TELL
{
  pendulum::require_descent(psi, swing_.eta);
  const double alpha = swing_.eta / 2, delta = static_cast<double>((psi.fifty() - swing_.eta.fifty()) / 2);
  const double exact = whole_integral(2 * delta, swing_.eta);
  const double first = logarithm(alpha, delta), second = scaled_cube(alpha, delta) / 2;
  tell("first", first, "the first term of (1), integrated");
  tell("second", second, "the second");
  tell("both", first + second, "their sum, t√(2g/b) by (5)");
  tell("exact", exact, "t√(2g/b) of the whole integral");
  tell("short_by", exact - first - second, "what the terms that follow must bring");
}

TELL
{
  curve("integrand", {"omega", "terms1", "terms2", "terms3", "terms10", "exact"}, [](Curve& c) {
    const double alpha = 2.5_deg;
    for(double x = 1; x < 12; x *= x < 1.2 ? 1.0005 : 1.02)
    {
      const double sine = std::sin(x * alpha), ratio = std::pow(std::sin(alpha) / sine, 2);
      const auto sum = [&](int terms) {
        double inner = 1;  // from the last term inwards
        for(int n = terms - 1; n > 0; --n)
          inner = 1 + inner * ratio * (2 * n - 1) / (2 * n);
        return x * alpha / sine * inner;
      };
      const double gap = std::sin((x + 1) * alpha) * std::sin((x - 1) * alpha);
      c.put({x, sum(1), sum(2), sum(3), sum(10), x * alpha / std::sqrt(gap)});
    }
  });
}

/*!
From a start at {{eta}} the two terms give {{both|7}}, of which {{second|4}} are new; {{short_by|4}} are
still missing.

::: figure pendulum-17
alt: Contribution to the time against omega over alpha on a logarithmic scale. The exact curve comes down
from infinity at 1 and soon lies on 1. Sums of one, two, three and ten terms begin at 1, 1.5, 1.9 and 3.5
and join the exact curve later or sooner.

Where the time is spent, and what the terms of {{eq 1}} see of it, for $\alpha = 2\tfrac12°$; areas are
times. All the terms are at work within the first few multiples of α, where the pendulum is only just
leaving the top. Even ten of them see little of the spike with which the exact curve begins.
:::

## Checks

The two numbers of the ansatz, in exact fractions: with them {{eq 3}} is an identity in $\sin\omega$. Then
the integrals against quadrature, from just after the start to the end.
*/

CHECK_THAT("with A = −½ and B = ½ the differentiated ansatz is an identity")
{
  const Rational A(-1, 2), B(1, 2);
  for(int n = 1; n <= 7; ++n)
  {
    const Rational sine(n, 7), cosine_squared = 1 - sine * sine;
    CHECK(-A / sine - 2 * A * cosine_squared / pow(sine, 3) + B / sine == 1 / pow(sine, 3));
    CHECK(A / sine - 2 * A / pow(sine, 3) + B / sine == 1 / pow(sine, 3));
  }
}

Fifty quadrature(const Fifty& alpha, const Fifty& delta, const Fifty& first, const Fifty& second)
{
  return exact::integrate(
             [&](const Fifty& y) {
               const Fifty sine = sin(alpha + y);
               return first / sine + second * pow(sin(alpha), 2) / pow(sine, 3);
             },
             0, delta)
      .value;
}

CHECK_THAT("the integral of dω/sin³ω is what the ansatz makes it, from just after the start to the end")
{
  for(const double alpha : {0.5_deg, 2.5_deg, 30_deg, 60_deg})
    for(const double part : {1e-9, 0.01, 0.5, 1.0})
    {
      const double delta = part * (90_deg - alpha);
      const Fifty truth = quadrature(alpha, delta, 0, 1);
      CHECK(scaled_cube(Fifty(alpha), Fifty(delta))
            == within_relative(truth, 1e-47, "fifty digits, twice"));
      CHECK(scaled_cube(alpha, delta) == within_ulps(truth, 4, "nothing cancels; a dozen roundings"));
    }
}

CHECK_THAT("(5) is the sum of the first two terms, but loses its digits just after the start")
{
  const char* const few = "a logarithm, few roundings";
  for(const double alpha : {0.5_deg, 2.5_deg, 30_deg})
    for(const double omega : {45_deg, 75_deg, 90_deg})
      CHECK(two_terms(alpha, omega)
            == within_ulps(quadrature(alpha, Fifty(omega) - alpha, 1, 0.5), 3, few));
  const double delta = 0x1p-40;  // 30° + δ is a double
  const double by_hand = logarithm(30_deg, delta) + scaled_cube(30_deg, delta) / 2;
  CHECK(by_hand == within_ulps(quadrature(30_deg, delta, 1, 0.5), 3, few));
  CHECK(std::abs(two_terms(30_deg, 30_deg + delta) / by_hand - 1) > 1e-6);
}

/*!
With the second term as with the first, what is missing does not fade as η does. After the first it tended
to $l2$; now it tends to $l2 - \tfrac14$.
*/

CHECK_THAT("near the top what two terms leave out tends to ln 2 − ¼")
{
  for(const double eta : {1e-9, 1e-150, 1e-300})
    CHECK(swing::quarter_time_from_top(eta) - two_terms(eta / 2, 90_deg)
          == within(exact::ln2() - 0.25, 2.3e-13, "two numbers near 690, an ulp each"));
}

/*!
Our copy has lost the ½ before the second differential, though it is there in {{sec pendulum.15}} and again
in the result. And it has mangled both results: they lack the $t$ on the left and the $l$ of the logarithm,
and close the bracket in the wrong place; in the first, moreover, the last term has a stray $A$ and has lost
a square.
*/

const Emendation half{
    "§17, the second differential",
    {"dω sin²α/sin³ω", 1},
    {"½ dω sin²α/sin³ω", 0.5},
    "for small α it is what the element has beyond 1/sin ω, here at ω = 1",
    [](double coefficient) {
      const Fifty alpha("1e-10"), beyond = 1 / sqrt(sin(1 + alpha) * sin(1 - alpha)) - 1 / sin(Fifty(1));
      return coefficient
             == within(beyond * pow(sin(Fifty(1)), 3) / pow(sin(alpha), 2), 1e-19, "αα, nearly");
    }};

const double at = 2.5_deg, ss = std::pow(std::sin(at), 2);

const Emendation results{
    "§17, both results, here for the whole descent",
    {"(1 + ¼ sin²α)[cot ½α + ¼ cos α]", (1 + ss / 4) * (1 / std::tan(at / 2) + std::cos(at) / 4)},
    {"(1 + ¼ sin²α) l cot ½α + ¼ cos α",
     (1 + ss / 4) * -std::log(std::tan(at / 2)) + std::cos(at) / 4},  // (6)
    "the quadrature of both terms, for α = 2½°",
    [](double time) {
      return time == within_ulps(quadrature(at, 90_deg - at, 1, 0.5), 3, "a logarithm, few roundings");
    }};

const Emendation last_term{
    "§17, the last term of the sum of two",
    {"cos ω sin²α A/(4 sin ω)", std::cos(45_deg) * ss * -0.5 / (4 * std::sin(45_deg))},
    {"cos ω sin²α/(4 sin²ω)", std::cos(45_deg) * ss / (4 * std::pow(std::sin(45_deg), 2))},
    "the quadrature of both terms, for α = 2½° and up to ω = 45°",
    [](double term) {
      const double before = (1 + ss / 4) * logarithm(at, 45_deg - at) + std::cos(at) / 4;
      return before - term
             == within_ulps(quadrature(at, 45_deg - at, 1, 0.5), 3, "a logarithm, few roundings");
    }};

/*!
What is told, at 5°, near the top, for a small swing, and on the way down:
*/

CHECK_THAT("the terms told are the quadratures of the first two, and the time told is the oracle's")
{
  for(const Told& now : told_at("", "eta=1 psi=1.5", "eta=1e-200rad psi=3e-200rad", "zeta=30"))
  {
    const Fifty alpha = swing_.eta.fifty() / 2, delta = psi.fifty() / 2 - alpha;
    const Fifty first = quadrature(alpha, delta, 1, 0), second = quadrature(alpha, delta, 0, 0.5);
    const Fifty tau = swing::oracle::time_from_rest_past(2 * delta, 2 * alpha);
    CHECK(now.value("first") == within_ulps(first, 4, "two sines, a quotient, a logarithm"));
    CHECK(now.value("second") == within_ulps(second, 5, "nothing cancels; a dozen roundings"));
    CHECK(now.value("both") == within_ulps(first + second, 4, "a sum of both"));
    CHECK(now.value("exact") == within_relative(tau, 2e-15, "the library's bound, six ulps"));
    const double size = 2e-15 * static_cast<double>(tau);
    CHECK(now.value("short_by") == within(tau - first - second, size, "a difference of rounded numbers"));
  }
}

CHECK_THAT("the figure has the element and the sums of its terms, times ω")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("integrand", 5))
      if(point.at("omega") > 1)
      {
        const Fifty alpha = exact::pi() / 72, omega = point.at("omega") * alpha, s = sin(omega),
                    v = pow(sin(alpha) / s, 2);
        const auto sum = [&](int terms) {
          Fifty all = 0;
          for(int n = 0; n < terms; ++n)
            all += tgamma(Fifty(n) + Fifty(0.5)) / (sqrt(exact::pi()) * tgamma(Fifty(n + 1))) * pow(v, n);
          return omega / s * all;
        };
        CHECK(point.value("terms1") == within_relative(sum(1), 1e-15, "few roundings"));
        CHECK(point.value("terms2") == within_relative(sum(2), 2e-15, "few roundings"));
        CHECK(point.value("terms3") == within_relative(sum(3), 2e-15, "few roundings"));
        CHECK(point.value("terms10") == within_relative(sum(10), 4e-15, "few roundings"));
        const double near = 1e-15 * (1 + 1 / (point.at("omega") - 1));
        CHECK(point.value("exact")
              == within_relative(omega / s / sqrt(1 - v), near, "ω − α of rounded angles"));
      }
}

CHECK_THAT(
    "a way of less than 10⁻³⁰ of η is refused, since fifty digits of both angles would leave too few of it")
{
  for(const char* const too_near : pendulum::hardly_descended)
    CHECK(refused_at(too_near));
  for(const char* const far_enough : pendulum::descended)
    CHECK(!refused_at(far_enough));
}

/*!
## Go on from here

::: exercise
Is a quarter the most that the second term can bring to the whole descent?

answer: No. It brings a little more, up to 0.29992 from a start at 67.07°, and comes down to a quarter
again at 111.28°. What grows at first is the logarithm's part, $\frac14\sin^2\alpha\,l\cot\frac12\alpha$.
:::
*/

CHECK_THAT("the second term brings most from 67.07°, 0.29992, and a quarter again from 111.28°")
{
  for(const Told& now : told_at("eta=66", "eta=67.07", "eta=68.2"))
    CHECK(now.value("second")
          == between(swing_.eta == 67.07_deg ? 0.299919 : 0.2998,
                     swing_.eta == 67.07_deg ? 0.29992 : 0.2999, "lower on both sides"));
  for(const Told& now : told_at("eta=111.28197660032380"))
    CHECK(now.value("second") == within(0.25, 1e-14, "a rounded angle"));
}
