#include <gsl/gsl_integration.h>

#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 18, "One lemma for all the terms")

using pendulum::scaled_integral;

/*!
## What Euler does

What {{sec pendulum.17}} did for the third power of the sine is now done for any. Let the integral of
$d\omega/\sin^{n+1}\omega$ be wanted. Again he writes down the form that it should have,

$$ \int\frac{d\omega}{\sin^{n+1}\omega} = \frac{A\cos\omega}{\sin^n\omega} +
     B\int\frac{d\omega}{\sin^{n-1}\omega}, \tag{1} $$

differentiates, and puts $1 - \sin^2\omega$ for $\cos^2\omega$:

$$ \begin{aligned} \frac{1}{\sin^{n+1}\omega}
  &= -\frac{A}{\sin^{n-1}\omega} - \frac{nA\cos^2\omega}{\sin^{n+1}\omega} + \frac{B}{\sin^{n-1}\omega} \\
  &= \frac{(n-1)A}{\sin^{n-1}\omega} - \frac{nA}{\sin^{n+1}\omega} + \frac{B}{\sin^{n-1}\omega}.
     \end{aligned} \tag{2} $$

The two powers must balance one by one, so that

$$ A = -\frac1n, \qquad B = \frac{n-1}{n}. \tag{3} $$

With the constant that makes the integral vanish at the start, $\omega = \alpha$, the lemma is

$$ \int_\alpha\frac{d\omega}{\sin^{n+1}\omega} = \frac{\cos\alpha}{n\sin^n\alpha} -
     \frac{\cos\omega}{n\sin^n\omega}
   + \frac{n-1}{n}\int_\alpha\frac{d\omega}{\sin^{n-1}\omega}, \tag{4} $$

where the last integral, two powers lower, may be taken as known: going down by twos one ends at the logarithm
of {{sec pendulum.17}}.

::: margin
Today: integration by parts, or a reduction formula for powers of the cosecant.
:::

## The program

The lemma, used from the lowest power upwards. If $n$ is odd one begins with the integral of 1, but $B$ is
nothing at $n = 1$.
*/

template <class Real>
Real integral(int n, Real alpha, Real omega)  // (4): of dω/sinⁿ⁺¹ω from α to ω
{
  using std::cos, std::log, std::pow, std::sin, std::tan;
  Real lower = n % 2 == 0 ? log(tan(omega / 2) / tan(alpha / 2)) : omega - alpha;
  for(int k = n % 2 == 0 ? 2 : 1; k <= n; k += 2)
    lower = cos(alpha) / (k * pow(sin(alpha), k)) - cos(omega) / (k * pow(sin(omega), k))
        + (k - 1) * lower / k;
  return lower;
}

/*!
The integrals are huge: α is small, and its sine stands below with a high power. In the series of
{{sec pendulum.15}} each is multiplied by $\sin^n\alpha$, and so it is better to carry the products. With
$n = 2m$, for the whole descent, and $J_m$ for the product, {{eq 4}} is a recurrence in which nothing
overflows, nothing is subtracted, and the error made at one step is diminished by the next:

$$ J_m = \frac{\cos\alpha}{2m} + \frac{2m-1}{2m}\sin^2\alpha\; J_{m-1}, \qquad J_0 = l\cot\tfrac12\alpha.
     \tag{5} $$

::: code pendulum/columns.hpp scaled_integral
:::

A way that owes nothing to the lemma is quadrature, here by a peer.
*/

double by_gsl(int n, double alpha, double omega)  // sinⁿα times the integral, by Gauss and Kronrod
{
  struct Cosecant { int n; double alpha; } cosecant{n, alpha};
  gsl_function f{[](double y, void* p) {
    const auto& c = *static_cast<Cosecant*>(p);
    return std::pow(std::sin(c.alpha) / std::sin(c.alpha + y), c.n) / std::sin(c.alpha + y);
  }, &cosecant};
  static gsl_integration_workspace* const workspace = gsl_integration_workspace_alloc(200);
  double result = 0;
  double error = 0;
  gsl_integration_qag(&f, 0, omega - alpha, 0, 1e-13, 200, GSL_INTEG_GAUSS21, workspace, &result, &error);
  return result;
}

/*!
The reader may choose η, how far down to go, and the power.
*/

const auto swing_ = amplitude_from_top(5_deg);
const auto psi = angle("psi", 180_deg, above_to(0_deg, 180_deg),
    "angle from the top down to which is integrated");
const auto n = integer("n", 10, 1, 2000, "the lemma's n: the integral of dω/sinⁿ⁺¹ω");

TELL
{
  require(psi > swing_.eta, "psi", "greater than eta, where the descent begins");
  const Fifty alpha = Fifty(swing_.eta) / 2;
  const Fifty omega = Fifty(psi) / 2;
  const Fifty whole = integral<Fifty>(n, alpha, omega);
  const Fifty scaled = whole * pow(sin(alpha), static_cast<int>(n));
  tell("A", Rational(-1, n), "A, by (3)");
  tell("B", Rational(n - 1, n), "B, by (3)");
  tell("log_of_integral", static_cast<double>(log(whole) / log(Fifty(10))),
       "common logarithm of the integral");
  tell("scaled", scaled, "sinⁿα times the integral");
  const double a = swing_.eta / 2;
  const double o = psi / 2;
  race("scaled", "sinⁿα ∫dω/sinⁿ⁺¹ω", scaled,
       {{"lemma as it stands", [=] { return integral<double>(n, a, o) * std::pow(std::sin(a), n); }},
        {"GSL, qag of 21 points", [=] { return by_gsl(n, a, o); }}});
}

/*!
For the figure, the scaled integrals of the whole descent.
*/

TELL
{
  curve("scaled", {"m", "J1", "J10", "J45"}, [](Curve& c) {
    for(int m = 0; m <= 1000; m += 1 + m / 12)
      c.put({1.0 * m, scaled_integral(m, 1_deg), scaled_integral(m, 10_deg), scaled_integral(m, 45_deg)});
  });
}

/*!
With $n$ = {{n}} the integral of the whole descent has the common logarithm {{log_of_integral|5}}, and
multiplied by $\sin^n\alpha$ it is {{scaled|6}}.

::: figure pendulum-18
alt: The scaled integrals J against m on logarithmic scales, for alpha of 1, 10 and 45 degrees. They begin at
different heights and run into nearly the same falling straight line.

The integrals of the terms, each times its power of $\sin\alpha$. However small α is they soon fall like
$1/2m$ and no faster: the powers of $\sin\alpha$ in the series are used up by the integrals, and it
is only the coefficients $\frac12, \frac{1\cdot3}{2\cdot4}, \ldots$ that make the terms small.
:::

## Checks

The lemma itself is algebra in $s = \sin\omega$, and exact fractions prove it, $n$ by $n$. Differentiating
$\cos\omega/\sin^p\omega$ gives $-1/s^{p-1} - p(1-ss)/s^{p+1}$.
*/

Rational derivative(const Rational& A, int p, const Rational& B, int power, const Rational& s)
{
  return A * (-1 / pow(s, p - 1) - p * (1 - s * s) / pow(s, p + 1)) + B / pow(s, power - 1);
}

CHECK_THAT("with (3) the derivative of (1) is 1/sinⁿ⁺¹ω, for n up to 20")
{
  for(int k = 1; k <= 20; ++k)
    for(const Rational& s : {Rational(1, 3), Rational(3, 5), Rational(9, 10)})
      CHECK(derivative(Rational(-1, k), k, Rational(k - 1, k), k, s) == 1 / pow(s, k + 1));
}

/*!
The definite form, and the recurrence, against quadrature.
*/

Fifty quadrature(int k, const Fifty& alpha, const Fifty& omega)  // sinᵏα times the integral
{
  return exact::integrate([&](const Fifty& y) {
    return pow(sin(alpha) / sin(alpha + y), k) / sin(alpha + y);
  }, 0, omega - alpha).value;
}

CHECK_THAT("the definite form agrees with quadrature for even and odd n")
{
  const Fifty alpha = Fifty(30_deg);
  for(const int k : {1, 2, 3, 4, 5, 6, 8, 10})
    for(const double omega : {31_deg, 75_deg, 90_deg})
      CHECK(integral<Fifty>(k, alpha, omega) * pow(sin(alpha), k)
            == within_relative(quadrature(k, alpha, omega), 1e-38, "the quadrature's 10⁻⁴⁰"));
}

CHECK_THAT("the scaled recurrence keeps all digits where the integral is beyond all doubles")
{
  const Fifty J200 = quadrature(400, Fifty(0.01), exact::pi() / 2);
  CHECK(scaled_integral(200, 0.01) == within_ulps(J200, 3, "each step shrinks what the last one erred"));
  CHECK_FALSE(std::isfinite(integral<double>(400, 0.01, 90_deg)));
  for(const double alpha : {1_deg, 10_deg, 45_deg, 75_deg, 89_deg})
    for(const int m : {1, 5, 50, 500})
      CHECK(scaled_integral(m, alpha)
            == within_ulps(scaled_integral(m, Fifty(alpha)), 3 / std::pow(std::cos(alpha), 2),
                           "a step errs by an ulp or two and hands on sin²α of it"));
}

CHECK_THAT("just after the start the lemma loses digits, and quadrature over the short way does not")
{
  const double alpha = 30_deg;
  const double omega = 30.000001_deg;
  const Fifty truth = quadrature(8, alpha, omega);
  CHECK(by_gsl(8, alpha, omega) == within_relative(truth, 1e-13, "what it is asked for"));
  const double naive = integral(8, alpha, omega) * std::pow(std::sin(alpha), 8);
  CHECK(std::abs(static_cast<double>(naive / truth) - 1) > 1e-11);
}

CHECK_THAT("the scaled integrals fall like 1/2m, over cos α")
{
  for(const double alpha : {1_deg, 10_deg, 45_deg})
    CHECK(2000 * std::cos(alpha) * scaled_integral(1000, alpha)
          == within_relative(1, 2e-3 / std::pow(std::cos(alpha), 2),
              "the next term is 1/m smaller, over cos²α"));
}

/*!
The scan has damaged nearly every line of the derivation, but not the lemma at its end. Each reading is tried
at $n = 4$, $\sin\omega = \tfrac35$, where all numbers are fractions.
*/

const Rational s(3, 5);
const auto is_integrand = [](double reading) { return reading == static_cast<double>(1 / pow(s, 5)); };

double of(const Rational& A, int p, const Rational& B)
{
  return static_cast<double>(derivative(A, p, B, 4, s));
}

double right_side(const Rational& first)  // (2), with the given first term
{
  return static_cast<double>(first + 1 / pow(s, 5) + Rational(3, 4) / pow(s, 3));
}

const Emendation ansatz{
    "§18, the ansatz (1)", {"A cos ω/sinⁿ⁺¹ω", [] { return of({-1, 4}, 5, {3, 4}); }},
    {"A cos ω/sinⁿω", [] { return of({-1, 4}, 4, {3, 4}); }}, "its derivative must be 1/sinⁿ⁺¹ω",
    is_integrand};

const Emendation left_sides{
    "§18, (2), left sides", {"d/dω of the ansatz, with sinⁿ⁺¹ω", [] { return of({-1, 4}, 5, {3, 4}); }},
    {"1/sinⁿ⁺¹ω", [] { return static_cast<double>(1 / pow(s, 5)); }}, "it must equal the right side",
    [](double left) { return left == right_side(Rational(3 * -1, 4) / pow(s, 3)); }};

const Emendation lost_term{
    "§18, (2), first line", {"−nA cos²ω/sinⁿ⁺¹ω + B/sinⁿ⁻¹ω", [] {
      return static_cast<double>((1 - s * s) / pow(s, 5) + Rational(3, 4) / pow(s, 3));
    }},
    {"−A/sinⁿ⁻¹ω − nA cos²ω/sinⁿ⁺¹ω + B/sinⁿ⁻¹ω", [] { return of({-1, 4}, 4, {3, 4}); }},
    "the cosine above the power has a derivative too", is_integrand};

const Emendation power{
    "§18, (2), second line", {"(n−1)A/sinⁿ⁺¹ω", [] { return right_side(Rational(-3, 4) / pow(s, 5)); }},
    {"(n−1)A/sinⁿ⁻¹ω", [] { return right_side(Rational(-3, 4) / pow(s, 3)); }}, "it must balance B",
    is_integrand};

const Emendation B{
    "§18, (3)", {"B = 1/n", [] { return of({-1, 4}, 4, {1, 4}); }},
    {"B = (n−1)/n", [] { return of({-1, 4}, 4, {3, 4}); }},
    "(4) has it, and so do the powers in (2)", is_integrand};
