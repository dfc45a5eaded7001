#include <gsl/gsl_sf_ellint.h>

#include "edition/section.hpp"
#include "pendulum/columns.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 15, "The series of the descent, and its first term")

/*!
## What Euler does

The descent begins in $g$, where $bAg = \eta$, and the time is counted from there; the integral of
{{sec pendulum.14}} has therefore to vanish for $\psi = \eta$. Then $t$ is the time, in seconds, from the
first position $Ag$ to any other, $AZ$.

Soon after the start $\sin^2\tfrac12\eta$ is very small against $\sin^2\tfrac12\psi$. So the root can be
developed by powers of their ratio:

$$ \begin{aligned} \frac{d\psi}{2\sqrt{\sin^2\frac12\psi - \sin^2\frac12\eta}}
   = \tfrac12 d\psi\Bigl(\frac1{\sin\frac12\psi} &+ \frac{1\cdot\sin^2\frac12\eta}{2\cdot\sin^3\frac12\psi}
   + \frac{1\cdot3\,\sin^4\frac12\eta}{2\cdot4\,\sin^5\frac12\psi} \\
   &+ \frac{1\cdot3\cdot5\,\sin^6\frac12\eta}{2\cdot4\cdot6\,\sin^7\frac12\psi}
   + \text{etc.}\Bigr). \end{aligned} \tag{1} $$

The first term can be integrated at once by logarithms,

$$ \int\frac{d\psi}{2\sin\frac12\psi}
   = l\,\frac{\operatorname{tg}\frac14\psi}{\operatorname{tg}\frac14\eta}. \tag{2} $$

::: margin
$l$ is the natural logarithm, $\operatorname{tg}$ the tangent.
:::

One sees from this that the integral would be infinite if η vanished altogether, and that the time is the
longer, the smaller η is taken. If the terms after the first could be neglected, the time would already be
had,

$$ \frac{t\sqrt{2g}}{\sqrt b} = l\,\frac{\operatorname{tg}\frac14\psi}{\operatorname{tg}\frac14\eta},\qquad
   t = \frac{\sqrt b}{\sqrt{2g}}
   \,l\,\frac{\operatorname{tg}\frac14\psi}{\operatorname{tg}\frac14\eta}. \tag{3} $$

## The program

The development, and its first term. As in {{sec pendulum.14}} the way from the start, $\psi - \eta$, is what
is handed on, so that nothing cancels when it is short: the quotient of the tangents is
$1 + \sin\tfrac14(\psi-\eta) : \cos\tfrac14\psi\,\sin\tfrac14\eta$.
*/

double element(double psi, double eta, int terms)  // (1), without dψ
{
  const double ratio = std::pow(std::sin(eta / 2) / std::sin(psi / 2), 2);
  double sum = 0, term = 0.5 / std::sin(psi / 2);
  for(int n = 1; n <= terms; ++n, term *= ratio * (2 * n - 3) / (2 * n - 2))
    sum += term;
  return sum;
}

template <class Real>
Real first_term(Real way, Real eta)  // (2), (3); way = ψ − η
{
  using std::cos, std::log1p, std::sin;
  return log1p(sin(way / 4) / (cos((eta + way) / 4) * sin(eta / 4)));
}

/*!
At the start itself the ratio of the sines is 1, and there the development is on the verge of its convergence:
none of its terms is smaller than the first. That moment is short, but it leaves a debt behind, which no
smallness of η diminishes. Close to the top, where ψ is $\eta\cosh\tau$ and the first term says
$l(\psi:\eta)$, the debt is

$$ \operatorname{arcosh}\frac\psi\eta - l\,\frac\psi\eta, \tag{4} $$

which begins with nothing and rises to $l\,2$.

Euler will pay it in {{sec pendulum.22}} and {{sec pendulum.24}}, for the whole descent. His own functions of
these sections, $D(v)$ and $W(v)$, can do more: taken not at 1 but at $v = \sin\alpha:\sin\omega$, with
$\omega = \tfrac12\psi$ and $\alpha = \tfrac12\eta$, they give the time down to any place:

$$ \begin{aligned} \frac{t\sqrt{2g}}{\sqrt b} \approx \left(1+\tfrac14\sin^2\alpha\right)
   l\,\frac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}
   &+ \left(1 + \tfrac34\sin^2\alpha\right)\cos\alpha\;l\,2 \\
   &- \left(D(v) + \sin^2\alpha\;W(v)\right)\cos\omega. \end{aligned} \tag{5} $$

::: code pendulum/columns.hpp D
:::

::: code pendulum/columns.hpp W
:::
*/

template <class Real>
Real uniform(Real way, Real eta, bool with_squares = true)  // (5), or the same without the terms in sin²α
{
  using std::cos, std::log, std::sin, std::sqrt;
  const Real alpha = eta / 2, omega = alpha + way / 2,
             ss = with_squares ? Real(pow(sin(alpha), 2)) : Real(0);
  const Real v = sin(alpha) / sin(omega), root = sqrt(sin(way / 2) * sin(omega + alpha)) / sin(omega);
  return (1 + ss / 4) * first_term(way, eta) + (1 + 3 * ss / 4) * cos(alpha) * log(Real(2))
         - (pendulum::D(v, root) + ss * pendulum::W(v, root)) * cos(omega);
}

/*!
Free are both angles, and the length and $g$ for the time in seconds.
*/

const auto swing_ = amplitude_from_top(5_deg);
const auto psi = angle("psi", 90_deg, above_to(0_deg, 180_deg), "the angle from the top that is reached");
const auto b = real("b", 1.0, metres, positive, "length of the equivalent simple pendulum");
const auto g =
    real("g", 4.903325, metres, positive, "height fallen in the first second, half of today's g");

TELL
{
  require(psi > swing_.eta, "psi", "greater than eta, where the descent begins");
  const double eta = swing_.eta, way = psi - eta, tau = swing::time_from_rest_past(way, eta);
  tell("t", std::sqrt(b / (2 * g)) * tau, seconds, "time from g to Z");
  tell("tau", tau, "the same as t√(2g)/√b");
  tell("first", first_term(way, eta), "the first term, (3)");
  tell("short_by", tau - first_term(way, eta), "by how much it falls short");
  tell("uniform", uniform(way, eta), "the time by (5)");
  tell("uniform_off", tau - uniform(way, eta), "by how much this falls short");
  auto& rows = table("rows", "The descent from η, and what the formulae leave out",
                     {{"psi", "ψ", degrees},
                      {"tau", "t√(2g/b)", none, 12},
                      {"first", "(3)", none, 8},
                      {"short", "short by", none, 6},
                      {"uniform", "(5) short by", none, 4}});
  for(const double reached : {6_deg, 10_deg, 30_deg, 90_deg, 180_deg})
    if(reached > eta)
    {
      const double exact = swing::time_from_rest(reached, eta), first = first_term(reached - eta, eta);
      rows.row({reached, exact, first, exact - first, exact - uniform(reached - eta, eta)});
    }
}

/*!
The error of each, all the way down, for three starts.
*/

TELL
{
  curve("short", {"x", "first", "uniform"}, [](Curve& c) {
    for(const double eta : {5_deg, 1_deg, 0.01_deg})
    {
      for(double way = 1e-4 * eta; eta + way < 180_deg; way *= 1.1)
      {
        const Fifty exact = swing::oracle::time_from_rest_past(way, eta);
        c.put({way / eta, static_cast<double>(exact - first_term(Fifty(way), Fifty(eta))),
               static_cast<double>(exact - uniform(Fifty(way), Fifty(eta)))});
      }
      c.gap();
    }
  });
  const double eta = swing_.eta, way = psi - eta, c = std::cos(eta / 2);
  race("descent", "t√(2g)/√b", swing::oracle::time_from_rest_past(way, eta),
       {{"the first term", [=] { return first_term(way, eta); }},
        {"(5) without sin²α", [=] { return uniform(way, eta, false); }},
        {"(5)", [=] { return uniform(way, eta); }},
        {"GSL, K − F of c",
         [=] {
           const double phi = std::asin(std::min(1.0, std::cos((eta + way) / 2) / c));
           return gsl_sf_ellint_Kcomp(c, GSL_PREC_DOUBLE) - gsl_sf_ellint_F(phi, c, GSL_PREC_DOUBLE);
         }},
        {"this edition", [=] { return swing::time_from_rest_past(way, eta); }}});
}

/*!
At $\eta = 5°$ the first term is short by {{short_by|4}} when the pendulum passes the height of the axis, of
{{tau|6}} in all. Formula {{eq 5}} misses {{uniform_off|e2}}.

::: figure pendulum-15
alt: What the formulae leave out against the way gone. The first term's error rises to ln 2 for all starts.

What is left out after a way of so many η. The first term runs up its debt while ψ grows from η to a few times
η, for all starts alike, and keeps it: the dashed line is $l\,2$. Formula {{eq 5}} is the better, the nearer
the top the descent began, and it is good from the first moment.
:::

## Checks

The development {{eq 1}} first, against the element of time.
*/

CHECK_THAT("the series of the element sums to the element, everywhere beyond the start")
{
  for(const double eta : {1e-6, 5_deg, 60_deg})
    for(const double times : {1.5, 2.0, 2.9})
    {
      const double reached = times * eta;
      const Fifty product = sin((Fifty(reached) + eta) / 2) * sin((Fifty(reached) - eta) / 2);
      const Fifty exact = 1 / (2 * sqrt(product));
      CHECK(element(reached, eta, 200)
            == within_ulps(exact, 60, "a ratio of 3/4 at most, and its rounding"));
    }
}

CHECK_THAT("the first term is the integral of the first term")
{
  for(const double eta : {1e-300, 1e-6, 5_deg, 90_deg})
    for(const double reached : {90.5_deg, 120_deg, 180_deg})
    {
      const double way = reached - eta;
      const Fifty exact = log(tan((Fifty(way) + eta) / 4) / tan(Fifty(eta) / 4));
      CHECK(first_term(way, eta) == within_ulps(exact, 4, "sines, a quotient and a logarithm"));
      const Fifty h("1e-18"), more = first_term(way + h, Fifty(eta)),
                              less = first_term(way - h, Fifty(eta));
      const Fifty term = 1 / (2 * sin((Fifty(way) + eta) / 2));
      CHECK((more - less) / (2 * h) == within_relative(term, 1e-28, "hh = 1e-36, and 1e-47 over h"));
    }
}

/*!
Then the debt: {{eq 4}} near the top, $l\,2$ after it, at a start as near as the machine's numbers allow.
*/

CHECK_THAT("near the top the first term falls short by arcosh x − ln x, and in the end by ln 2")
{
  for(const double x : {1.001, 1.5, 3.0, 100.0})
  {
    const Fifty eta("1e-30"), way = eta * (Fifty(x) - 1);
    const Fifty debt = swing::oracle::time_from_rest_past(way, eta) - first_term(way, eta);
    CHECK(debt == within(acosh(Fifty(x)) - log(Fifty(x)), 1e-38, "the square of 1e-28, and fifty digits"));
  }
  const double whole = swing::time_from_rest_past(180_deg, 1e-300), first = first_term(180_deg, 1e-300);
  CHECK(whole - first == within(exact::ln2(), 2.3e-13, "two numbers near 690, an ulp each"));
}

/*!
Formula {{eq 5}} leaves out what the next column of {{sec pendulum.21}} and the next power in the logarithm's
factor hold, some $\sin^4\alpha\,l\cot\tfrac12\alpha$.
*/

CHECK_THAT("the uniform formula errs by the fourth power of sin α, from the start to the lowest point")
{
  for(const double eta : {5_deg, 1_deg, 0.01_deg})
    for(double way = 1e-6 * eta; eta + way < 180_deg; way *= 3)
    {
      const Fifty missed = swing::oracle::time_from_rest_past(way, eta) - uniform(Fifty(way), Fifty(eta));
      const Fifty x = pow(sin(Fifty(eta) / 2), 2);
      const Fifty most = x * x * (Fifty(9) / 64 * first_term(Fifty(way), Fifty(eta)) + 0.44);
      CHECK(missed == between(0, most, "9/64 of the logarithm, and the fourth column, 0,436"));
    }
  const Fifty exact = swing::oracle::time_from_rest_past(90_deg, 1e-9);
  CHECK(uniform(90_deg, 1e-9) == within_ulps(exact, 4, "sin⁴α is nothing; a few roundings"));
}

/*!
The hard cases. A descent that has hardly begun, where the double ψ would carry no more than six digits of it;
and one from $10^{-300}$ of a radian.
*/

CHECK_THAT("the time is right where the way is a millionth of η, and where η is 1e-300")
{
  using swing::oracle::time_from_rest_past;
  CHECK(time_from_rest_past(Fifty("1e-18"), Fifty("1e-12"))
        == printed("0.00141421344452199136754017079005"));
  const Fifty begun = time_from_rest_past(Fifty("1e-13"), Fifty("1e-3"));
  CHECK(begun == printed("0.0000141421368021244897532185561959"));
  CHECK(swing::time_from_rest_past(1e-18, 1e-12)
        == within_ulps(acosh(1 + Fifty(1e-18) / 1e-12), 4, "so near the top it is a hyperbolic motion"));
  const Fifty in_doubles = time_from_rest_past(1e-13, 1e-3);
  CHECK(swing::time_from_rest_past(1e-13, 1e-3) == within_ulps(in_doubles, 4, "the library's own bound"));
  const Fifty long_way("691.973595852873998108416523445");
  CHECK(swing::time_from_rest_past(90_deg, 1e-300) == within_ulps(long_way, 2, "the library's own bound"));
}

/*!
One word is turned round in the text: it makes the time less, the smaller η is taken, just after saying that
it becomes infinite for none at all.
*/

const Doubtful less{"§15, the time for smaller η",
                    {"the less (minus)", -1},
                    {"the longer (maius)", 1},
                    "the time to any place grows as η shrinks, without bound",
                    [](double sign) {
                      const auto time = [](double eta) { return swing::time_from_rest(90_deg, eta); };
                      return sign * (time(2_deg) - time(5_deg)) > 0
                             && sign * (time(1_deg) - time(2_deg)) > 0;
                    }};
