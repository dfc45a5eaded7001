#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 18, "One lemma for all the terms")

/*!
## What Euler does

One lemma serves for the integrals of all the terms: what {{sec pendulum.17}} did for the third power of the
sine is done here for any. The integral of $d\omega/\sin^{n+1}\omega$ is wanted. Again he assumes its form,

$$ \int\frac{d\omega}{\sin^{n+1}\omega} = \frac{A\cos\omega}{\sin^n\omega}{{entry ansatz}} +
     B\int\frac{d\omega}{\sin^{n-1}\omega}, \tag{1} $$

differentiates, and puts $1 - \sin^2\omega$ for $\cos^2\omega$:

$$ \begin{aligned} \frac{1}{\sin^{n+1}\omega}
  &= -\frac{A}{\sin^{n-1}\omega}{{entry lost_term}} - \frac{nA\cos^2\omega}{\sin^{n+1}\omega} +
  \frac{B}{\sin^{n-1}\omega} \\ &= \frac{(n-1)A}{\sin^{n-1}\omega}{{entry power}} -
  \frac{nA}{\sin^{n+1}\omega} + \frac{B}{\sin^{n-1}\omega}. \end{aligned} \tag{2} $$

Each of the two powers must balance by itself, so that

$$ A = -\frac1n, \qquad B = \frac{n-1}{n}{{entry B}}. \tag{3} $$

::: margin
Today: the reduction formula for powers of the cosecant, usually found by integration by parts.
:::

With the constant that makes the integral vanish at the start, $\omega = \alpha$, the lemma is

$$ \int_\alpha\frac{d\omega}{\sin^{n+1}\omega} = \frac{\cos\alpha}{n\sin^n\alpha} -
     \frac{\cos\omega}{n\sin^n\omega}
   + \frac{n-1}{n}\int_\alpha\frac{d\omega}{\sin^{n-1}\omega}, \tag{4} $$

and the last integral, two powers lower, may be regarded as known.

## The program

For small α the integrals are huge, too large for a double when $n$ is in the hundreds. But in the series of
{{sec pendulum.15}} each is multiplied by $\sin^n\alpha$, and so the program carries the products. Going up
by twos, it starts from the logarithm if $n$ is even; if $n$ is odd, from nothing, since then $B = 0$ at
$n = 1$.
*/

template <class Real>
Real scaled(int n, Real alpha, Real omega)  // (4), times sinⁿα
{
  using std::cos, std::log, std::pow, std::sin, std::tan;
  const Real s = sin(alpha);
  const Real v = s / sin(omega);
  Real J = n % 2 == 0 ? log(tan(omega / 2) / tan(alpha / 2)) : Real(0);
  for(int k = 2 - n % 2; k <= n; k += 2)
    J = (cos(alpha) - cos(omega) * pow(v, k) + (k - 1) * s * s * J) / k;
  return J;
}

/*!
For the whole descent and $n = 2m$ the cosine of ω is gone. What is left is a recurrence in which all terms
are positive and the error of one step is diminished by the next:

$$ J_m = \frac{\cos\alpha}{2m} + \frac{2m-1}{2m}\sin^2\alpha\; J_{m-1}, \qquad J_0 = l\cot\tfrac12\alpha.
     \tag{A} $$

::: code pendulum/columns.hpp scaled_integral (A)
:::
*/

const auto swing_ = amplitude_from_top(5_deg);
const auto psi = angle("psi", 180_deg, above_to(0_deg, 180_deg), "angle from the top at which it ends");
const auto n = integer("n", 10, 1, 2000, "the lemma's n: the integral of dω/sinⁿ⁺¹ω");

TELL
{
  require(psi.fifty() >= swing_.eta.fifty() * (1 + Fifty("1e-18")), "psi",
          "greater than eta, where the descent begins, by at least 1e-18 of it");
  const Fifty alpha = swing_.eta.fifty() / 2;
  const Fifty product = scaled(n, alpha, psi.fifty() / 2);
  tell("scaled", product, "sinⁿα times the integral of dω/sinⁿ⁺¹ω");
  tell("integral", product / pow(sin(alpha), static_cast<int>(n)), "the integral itself");
}

TELL
{
  curve("falling", {"power", "J1", "J10", "J45"}, [](Curve& c) {
    for(int m = 0; m <= 500; m += 1 + m / 12)
      c.put({2. * m + 1, pendulum::scaled_integral(m, 1_deg), pendulum::scaled_integral(m, 10_deg),
             pendulum::scaled_integral(m, 45_deg)});
  });
}

/*!
From {{eta}} to the bottom, with $n$ = {{n}}, the integral is {{integral|e3}}; multiplied by $\sin^n\alpha$ it
is {{scaled|6}}.

::: figure pendulum-18
alt: The scaled integrals against the power of the sine on logarithmic scales, for alpha of 1, 10 and 45
degrees. They begin at different heights and soon fall along parallel lines.

The integrals of the terms, each times its power of $\sin\alpha$. However small α is they soon fall like
$1/(2m\cos\alpha)$ and no faster: the integrals use up the powers of $\sin\alpha$ in the series, and only
the coefficients $\frac12, \frac{1\cdot3}{2\cdot4}, \ldots$ help to make the terms small.
:::

## Checks

The derivative of $\cos\omega/\sin^p\omega$ is $-1/s^{p-1} - p(1-ss)/s^{p+1}$, where $s = \sin\omega$. So the
lemma is algebra, which exact fractions can prove.
*/

Rational slope(int n, int p, const Rational& A, const Rational& B, const Rational& s)  // of (1), with sinᵖω
{
  return A * (-1 / pow(s, p - 1) - p * (1 - s * s) / pow(s, p + 1)) + B / pow(s, n - 1);
}

CHECK_THAT("with (3) the derivative of (1) is 1/sinⁿ⁺¹ω, for n up to 20")
{
  for(int k = 1; k <= 20; ++k)
    for(const Rational& s : {Rational(1, 3), Rational(3, 5), Rational(9, 10)})
      CHECK(slope(k, k, {-1, k}, {k - 1, k}, s) == 1 / pow(s, k + 1));
}

Fifty integral(int k, const Fifty& alpha, const Fifty& omega)  // the same as scaled(), by quadrature
{
  const auto f = [&](const Fifty& y) { return pow(sin(alpha) / sin(alpha + y), k) / sin(alpha + y); };
  return exact::integrate(f, 0, omega - alpha).value;
}

CHECK_THAT("the definite form agrees with quadrature for even and odd n")
{
  const Fifty alpha(30_deg);
  for(const int k : {1, 2, 3, 4, 5, 8, 10})
    for(const double omega : {31_deg, 75_deg, 90_deg})
      CHECK(scaled(k, alpha, Fifty(omega))
            == within_relative(integral(k, alpha, omega), 1e-46,
                               "the short way to 31° costs two digits of fifty"));
}

CHECK_THAT("the recurrence keeps its digits, even where the integral is beyond all doubles")
{
  const Fifty J200 = integral(400, Fifty(0.01), exact::pi() / 2);  // the integral is 10⁷⁹⁷
  CHECK(pendulum::scaled_integral(200, 0.01) == within_ulps(J200, 1.5, "the cosine, a product, a sum"));
  for(const double alpha : {1_deg, 45_deg, 75_deg})
    for(const int m : {1, 5, 50, 500})
      CHECK(pendulum::scaled_integral(m, alpha)
            == within_ulps(scaled(2 * m, Fifty(alpha), exact::pi() / 2), 3 / std::pow(std::cos(alpha), 2),
                           "a step errs by an ulp or two and hands on sin²α of it"));
}

CHECK_THAT("just after the start the lemma loses seven digits, its two ends being nearly equal")
{
  const double lost =
      static_cast<double>(scaled(8, 30_deg, 30.000001_deg) / integral(8, 30_deg, 30.000001_deg)) - 1;
  CHECK(std::abs(lost) == between(1e-10, 1e-8, "half an ulp of the cosine over a way of 2e-8"));
}

CHECK_THAT("the scaled integrals fall like 1/(2m cos α)")
{
  for(const double alpha : {1_deg, 10_deg, 45_deg})
  {
    const double tt = std::pow(std::tan(alpha), 2);
    CHECK(2000 * std::cos(alpha) * pendulum::scaled_integral(1000, alpha)
          == within(1 + tt / 2001, 2e-6 * tt, "what follows is smaller by another 1/m"));
  }
}

/*!
Our copy has damage in four places of the derivation, but none in the lemma at its end. On the left of
{{eq 2}} it twice writes out the derivative of {{eq 1}}, with the same wrong power. Each reading is tried at
$n = 4$, $\sin\omega = \tfrac35$, where all numbers are fractions.
*/

double slope_of_ansatz(int p, const Rational& B)
{
  return static_cast<double>(slope(4, p, {-1, 4}, B, {3, 5}));
}

double right_side(int p, const Rational& first)  // (2), with the first term first/sinᵖω
{
  const Rational s(3, 5);
  return static_cast<double>(first / pow(s, p) + 1 / pow(s, 5) + Rational(3, 4) / pow(s, 3));
}

const auto is_integrand = [](double reading) {
  return reading == static_cast<double>(pow(Rational(5, 3), 5));
};

const Emendation ansatz{"§18, the ansatz (1), and twice on the left of (2)",
                        {"A cos ω/sinⁿ⁺¹ω", slope_of_ansatz(5, {3, 4})},
                        {"A cos ω/sinⁿω", slope_of_ansatz(4, {3, 4})},
                        "its derivative must be 1/sinⁿ⁺¹ω",
                        is_integrand};

const Emendation lost_term{"§18, (2), first line",
                           {"−nA cos²ω/sinⁿ⁺¹ω + B/sinⁿ⁻¹ω", right_side(3, -1)},
                           {"−A/sinⁿ⁻¹ω − nA cos²ω/sinⁿ⁺¹ω + B/sinⁿ⁻¹ω", right_side(3, {-3, 4})},
                           "the cosine above the power has a derivative too",
                           is_integrand};

const Emendation power{"§18, (2), second line",
                       {"(n−1)A/sinⁿ⁺¹ω", right_side(5, {-3, 4})},
                       {"(n−1)A/sinⁿ⁻¹ω", right_side(3, {-3, 4})},
                       "only so does it balance B",
                       is_integrand};

const Emendation B{"§18, (3)",
                   {"B = 1/n", slope_of_ansatz(4, {1, 4})},
                   {"B = (n−1)/n", slope_of_ansatz(4, {3, 4})},
                   "(4) has it, and so do the powers in (2)",
                   is_integrand};

/*!
What is told, by the integral itself:
*/

CHECK_THAT(
    "the integral told and its scaled form are those of quadrature, even and odd, near the top and below")
{
  for(const Told& now : told_at("", "eta=60 psi=100 n=7", "eta=0.01 n=400", "eta=90 psi=91 n=1"))
  {
    const Fifty alpha = swing_.eta.fifty() / 2, J = integral(n, alpha, psi.fifty() / 2);
    CHECK(now.value("scaled") == within_relative(J, 1e-28, "quadrature over a way that may be long"));
    CHECK(now.value("integral")
          == within_relative(J / pow(sin(alpha), static_cast<int>(n)), 1e-28, "the same"));
  }
}

CHECK_THAT("the figure's curves are the scaled integrals at 1, 10 and 45 degrees")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("falling", 5))
    {
      const int m = static_cast<int>(point.at("power")) / 2;
      const Fifty right = exact::pi() / 2, degree = exact::pi() / 180;
      CHECK(point.value("J1") == within_relative(scaled(2 * m, degree, right), 4e-16, "as above"));
      CHECK(point.value("J10") == within_relative(scaled(2 * m, 10 * degree, right), 4e-16, "as above"));
      CHECK(point.value("J45") == within_relative(scaled(2 * m, 45 * degree, right), 1e-15, "as above"));
    }
}

CHECK_THAT("a way of less than 10⁻¹⁸ of η is refused, since its ends cancel, and of fifty digits thirty "
           "are to be left")
{
  for(const char* const too_near :
      {"eta=60 psi=60.000000000000000059", "eta=1e-200rad psi=1.00000000000000000099e-200rad"})
    CHECK(refused_at(too_near));
  for(const char* const far_enough :
      {"eta=60 psi=60.000000000000000061", "eta=1e-200rad psi=1.0000000000000000101e-200rad"})
    CHECK(!refused_at(far_enough));
}

/*!
## Go on from here

::: exercise
For $n = 2000$ and the whole descent from 5° foretell the product with $\sin^n\alpha$; the integral itself
has 2718 digits before its point.

answer: By the figure's law it is nearly $1/(n\cos\alpha)$, 0.00050048; and so it is told.
:::
*/

CHECK_THAT("for n = 2000 the product is 1 over n cos α, to six digits, and the integral has 2718 digits")
{
  for(const Told& now : told_at("n=2000"))
  {
    const Fifty alpha = swing_.eta.fifty() / 2;
    CHECK(now.value("scaled") == within_relative(1 / (2000 * cos(alpha)), 1.1e-6, "tan²α over n"));
    CHECK(now.value("integral") == between(Fifty("1e2717"), Fifty("1e2718"), "2718 digits"));
  }
}
