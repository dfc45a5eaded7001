#include "edition/section.hpp"
#include "pendulum/asked.hpp"
#include "pendulum/columns.hpp"
#include "pendulum/equation.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 15, "The series of the descent, and its first term")

/*!
## What Euler does

The element of the descent is developed into a series, and its first term alone gives a formula for the
time. The descent begins in $g$, where $bAg = \eta$; the integral of {{sec pendulum.14}} must therefore
vanish for $\psi = \eta$, and then $t$ is the time in seconds from the first position $Ag$ to any other,
$AZ$.

Soon after the start $\sin^2\tfrac12\eta$ is very small against $\sin^2\tfrac12\psi$. So the root can be
developed by powers of their ratio:

$$ \begin{aligned} &\frac{d\psi}{2\sqrt{\sin^2\frac12\psi - \sin^2\frac12\eta}}
   = \tfrac12 d\psi\Bigl(\frac1{\sin\frac12\psi} + \frac{1\cdot\sin^2\frac12\eta}{2\cdot\sin^3\frac12\psi} \\
   &\quad + \frac{1\cdot3\,\sin^4\frac12\eta}{2\cdot4\,\sin^5\frac12\psi}
   + \frac{1\cdot3\cdot5\,\sin^6\frac12\eta}{2\cdot4\cdot6\,\sin^7\frac12\psi}
   + \text{etc.}\Bigr). \end{aligned} \tag{1} $$

The first term can be integrated at once by logarithms,

$$ \int\frac{d\psi}{2\sin\frac12\psi}
   = l\,\frac{\operatorname{tg}\frac14\psi}{\operatorname{tg}\frac14\eta}. \tag{2} $$

::: margin
$l$ is the natural logarithm, $\operatorname{tg}$ the tangent.
:::

One sees from this that the integral would be infinite if η vanished altogether, and that the time is the
longer {{entry less}}, the smaller η is taken. If the terms after the first could be neglected, one would
already have

$$ \frac{t\sqrt{2g}}{\sqrt b} = l\,\frac{\operatorname{tg}\frac14\psi}{\operatorname{tg}\frac14\eta},\qquad
   t = \frac{\sqrt b}{\sqrt{2g}}
   \,l\,\frac{\operatorname{tg}\frac14\psi}{\operatorname{tg}\frac14\eta}. \tag{3} $$

## The program

The development, and its first term. As in {{sec pendulum.14}} the way from the start, $\psi - \eta$, is
what is handed on, so that nothing cancels when it is short: the quotient of the tangents is $1 +
\sin\tfrac14(\psi-\eta) : \cos\tfrac14\psi\,\sin\tfrac14\eta$.
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
At the start itself the ratio of the sines is 1, and there the series {{eq 1}} diverges. That moment is
short, but something is missing from it on, which no smallness of η diminishes. Close to the top, where ψ is
$\eta\cosh\tau$ at the time $\tau = t\sqrt{2g/b}$ and the first term says $l(\psi:\eta)$, what is missing is

$$ \operatorname{arcosh}\frac\psi\eta - l\,\frac\psi\eta, \tag{A} $$

which begins with nothing and rises to $l\,2$.

Euler will supply it for the whole descent. But the functions that he needs for that, $D(v)$ in {{sec
pendulum.22}} and $W(v)$ in {{sec pendulum.24}}, can do more. Taken not at 1 but at $v =
\sin\alpha:\sin\omega$, with $\omega = \tfrac12\psi$ and $\alpha = \tfrac12\eta$, they give the time down to
any place. For in the lemma of {{sec pendulum.18}} every end at α with $\cos\alpha$ has its fellow at ω, with
$-\cos\omega$ and a power of $v$; added up, the ones make $D(1)$ and $W(1)$, the others $D(v)$ and $W(v)$:

$$ \begin{aligned} \frac{t\sqrt{2g}}{\sqrt b} \approx \left(1+\tfrac14\sin^2\alpha\right)
   l\,\frac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}
   &+ \left(1 + \tfrac34\sin^2\alpha\right)\cos\alpha\;l\,2 \\
   &- \left(D(v) + \sin^2\alpha\;W(v)\right)\cos\omega. \end{aligned} \tag{B} $$
*/

template <class Real>
Real uniform(Real way, Real eta)  // (B)
{
  using std::cos, std::log, std::sin, std::sqrt;
  const Real alpha = eta / 2, omega = alpha + way / 2, ss = pow(sin(alpha), 2);
  const Real v = sin(alpha) / sin(omega), root = sqrt(sin(way / 2) * sin(omega + alpha)) / sin(omega);
  return (1 + ss / 4) * first_term(way, eta) + (1 + 3 * ss / 4) * cos(alpha) * log(Real(2))
         - (pendulum::D(v, root) + ss * pendulum::W(v, root)) * cos(omega);
}

const auto swing_ = amplitude_from_top(5_deg, from_below(30_deg, 180_deg));
const auto psi = angle("psi", 90_deg, above_to(0_deg, 180_deg), "the angle from the top that is reached");
const auto b = real("b", 1.0, metres, scale, "length of the equivalent simple pendulum");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

double way_gone()  // ψ − η
{
  return pendulum::way_from_rest(static_cast<double>(psi.fifty() - swing_.eta.fifty()), swing_.eta);
}

TELL
{
  pendulum::require_descent(psi, swing_.eta);
  const double eta = swing_.eta, way = way_gone(), tau = swing::time_from_rest_past(way, eta);
  const double unit = std::sqrt(b) / std::sqrt(2 * g), first = first_term(way, eta);
  tell("t", unit * tau, seconds, "time from g to Z");
  tell("t_first", unit * first, seconds, "the same by the first term, (3)");
  tell("tau", tau, "t√(2g)/√b");
  tell("first", first, "the first term");
  tell("short_by", tau - first, "by how much it falls short");
  const Fifty start = swing_.eta.fifty(), gone = psi.fifty() - start,
              off = swing::oracle::time_from_rest_past(gone, start) - uniform(gone, start);
  tell("uniform_off", off < Fifty("1e-45") ? 0 : double(off), "by how much (B) falls short");
}

TELL
{
  curve("short", {"x", "first", "uniform"}, [](Curve& c) {
    for(const Fifty eta : {5_deg, 1_deg, 0.01_deg})
    {
      for(Fifty way = 1e-4 * eta; eta + way < 180_deg; way *= 1.1)
      {
        const Fifty exact = swing::oracle::time_from_rest_past(way, eta);
        c.put({double(way / eta), double(exact - first_term(way, eta)), double(exact - uniform(way, eta))});
      }
      c.gap();
    }
  });
}

/*!
At $\eta = 5°$ the first term is short by {{short_by|4}} when the pendulum passes the height of the axis, of
{{tau|6}} in all. Formula {{eq B}} misses {{uniform_off|e2}}.

::: figure pendulum-15
alt: What the formulae leave out against the way gone. The first term's error rises to ln 2 for all starts.

What is left out after a way of so many η. The first term falls behind while ψ grows from η to a few
times η, for all starts alike, and never makes it good: the dashed line is $l\,2$. Formula {{eq B}} is good
from the
first moment, and the better, the nearer the top the descent began.
:::

## Speed against error

The two approximations beside the edition's own function, which is exact.
*/

TELL
{
  const double eta = swing_.eta, way = way_gone();
  race("descent", "t√(2g)/√b",
       swing::oracle::time_from_rest_past(psi.fifty() - swing_.eta.fifty(), swing_.eta.fifty()),
       {{"the first term", [=] { return first_term(way, eta); }},
        {"(B)", [=] { return uniform(way, eta); }},
        {"this edition", [=] { return swing::time_from_rest_past(way, eta); }}});
}

/*!
## Checks

First the development {{eq 1}}, against the element of time, and the integral {{eq 2}}, against its term.
*/

CHECK_THAT("the series of the element sums to the element, everywhere beyond the start")
{
  for(const double eta : {1e-6, 5_deg, 60_deg})
    for(const double times : {1.5, 2.0, 2.9})
    {
      const Fifty reached = times * eta, product = sin((reached + eta) / 2) * sin((reached - eta) / 2);
      CHECK(
          element(times * eta, eta, 200)
          == within_ulps(1 / (2 * sqrt(product)), 8, "some thirty terms count, falling by half at least"));
    }
}

CHECK_THAT("the first term's integral is nothing at the start, and its derivative is the first term")
{
  for(const double eta : {1e-300, 1e-6, 5_deg, 90_deg})
  {
    CHECK(first_term(0.0, eta) == 0);
    for(const double reached : {90.5_deg, 120_deg, 180_deg})
    {
      const Fifty h("1e-18"), way = reached - eta, start = eta;
      const Fifty slope = (first_term(way + h, start) - first_term(way - h, start)) / (2 * h);
      CHECK(slope
            == within_relative(1 / (2 * sin((way + start) / 2)), 5e-29, "1e-47 over h, and hh = 1e-36"));
      CHECK(first_term(reached - eta, eta) == within_ulps(first_term(way, start), 2, "a few roundings"));
    }
  }
}

/*!
Then what is missing: {{eq A}} near the top, and $l\,2$ in the end, at a start as near as the machine's
numbers
allow.
*/

CHECK_THAT("near the top the first term falls short by arcosh x − ln x, and in the end by ln 2")
{
  for(const double x : {1.001, 1.5, 3.0, 100.0})
  {
    const Fifty eta("1e-30"), way = eta * (Fifty(x) - 1);
    const Fifty debt = swing::oracle::time_from_rest_past(way, eta) - first_term(way, eta);
    CHECK(debt == within(acosh(Fifty(x)) - log(Fifty(x)), 1e-48, "fifty digits; the next power is 1e-56"));
  }
  const double whole = swing::time_from_rest_past(180_deg, 1e-300), first = first_term(180_deg, 1e-300);
  CHECK(whole - first == within(exact::ln2(), 2.3e-13, "two numbers near 690, an ulp each"));
}

/*!
Formula {{eq B}} leaves out the next power in the logarithm's factor and what the next column of {{sec
pendulum.21}} holds.
*/

CHECK_THAT("the uniform formula errs by the fourth power of sin α, from the start to the lowest point")
{
  for(const Fifty eta : {5_deg, 1_deg, 0.01_deg})
    for(Fifty way = 1e-6 * eta; eta + way < 180_deg; way *= 3)
    {
      const Fifty missed = swing::oracle::time_from_rest_past(way, eta) - uniform(way, eta);
      const Fifty most = pow(sin(eta / 2), 4) * (Fifty(9) / 64 * first_term(way, eta) + 0.44);
      CHECK(missed == between(0, most, "9/64 of the logarithm, and the fourth column, 0.436"));
    }
  CHECK(uniform(90_deg, 1e-9) == within_ulps(uniform(Fifty(90_deg), Fifty(1e-9)), 2, "a few roundings"));
}

/*!
The hard cases: a descent that has hardly begun, where the double ψ would carry no more than six digits of
it; and one from $10^{-300}$ of a radian.
*/

CHECK_THAT("the time is right where the way is a millionth of η, and where η is 1e-300")
{
  using swing::oracle::time_from_rest_past;
  CHECK(time_from_rest_past(Fifty("1e-18"), Fifty("1e-12"))
        == printed("0.00141421344452199136754017079005"));
  CHECK(swing::time_from_rest_past(1e-18, 1e-12)
        == within_ulps(acosh(1 + Fifty(1e-18) / 1e-12), 2, "so near the top it is a hyperbolic motion"));
  CHECK(swing::time_from_rest_past(1e-13, 1e-3)
        == within_ulps(time_from_rest_past(1e-13, 1e-3), 6, "the library's own bound"));
  CHECK(swing::time_from_rest_past(90_deg, 1e-300)
        == within_ulps(Fifty("691.973595852873998108416523445"), 2, "a logarithm"));
}

/*!
One word is turned round in our copy. It makes the time less, the smaller η is taken, just after saying that
the time becomes infinite for none at all.
*/

const Doubtful less{"§15, the time for smaller η",
                    {"the less (minus)", -1},
                    {"the longer (maius)", 1},
                    "the time to any place grows as η shrinks, without bound",
                    [](double sign) {
                      if(std::abs(sign) != 1)
                        return false;  // no direction
                      const auto time = [](double eta) { return swing::time_from_rest(90_deg, eta); };
                      return sign * (time(2_deg) - time(5_deg)) > 0
                             && sign * (time(1_deg) - time(2_deg)) > 0;
                    }};

/*!
What is told: at 5° and a right angle, near the top after a hundred η, and for the half swing of a small
pendulum.
*/

CHECK_THAT("the times told are the oracle's and the logarithm's, and what is missing their differences")
{
  for(const Told& now :
      told_at("", "eta=1e-100rad psi=1e-98rad b=2", "zeta=30 psi=180 g=16", "eta=90 psi=91"))
  {
    const Fifty eta = swing_.eta.fifty(), tau = swing::oracle::time_from_rest_past(psi.fifty() - eta, eta);
    const Fifty first = log(tan(psi.fifty() / 4) / tan(eta / 4)), unit = sqrt(b.fifty() / (2 * g.fifty()));
    const double size = static_cast<double>(tau), size_of_first = static_cast<double>(first);
    CHECK(now.value("tau") == within(tau, 2e-15 * size, "the library's bound"));
    CHECK(now.value("first") == within(first, 1e-15 * size_of_first, "few roundings"));
    CHECK(now.value("t", seconds) == within_relative(unit * tau, 3e-15, "and a product"));
    CHECK(now.value("t_first", seconds) == within_relative(unit * first, 2e-15, "and a product"));
    CHECK(now.value("short_by") == within(tau - first, 3e-15 * size, "a difference of rounded numbers"));
    CHECK(now.exact("descent") == within_relative(tau, 1e-45, "the same oracle"));
    CHECK(now.method("descent", "the first term") == within(first, 1e-15 * size_of_first, "few roundings"));
    CHECK(now.method("descent", "this edition") == within(tau, 2e-15 * size, "the library's bound"));
    const double s = std::sin(swing_.eta / 2),
                 fourth = std::pow(s, 4) * (9. / 64 * size_of_first + 0.44 / std::cos(swing_.eta / 2));
    CHECK(now.method("descent", "(B)")
          == between(tau - fourth - 3e-15 * size, tau + 3e-15 * size, "as the check above"));
    CHECK(now.value("uniform_off") == between(0, fourth, "as the check above"));
  }
}

CHECK_THAT("the figure's first curve is arcosh x − l x while the way is small, and tends to l 2, the "
           "second to nothing")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("short", 40))
    {
      const Fifty x = 1 + Fifty(point.at("x")), debt = acosh(x) - log(x);
      CHECK(point.value("first") == within(debt, 2e-3, "the law near the top; at 5° sin²α is 0.0019"));
      CHECK(point.value("uniform") == between(-1e-15, 8e-6, "sin⁴α times a half and a logarithm, at 5°"));
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
After which way has the first term already lost half of what it will lose?

answer: After a tenth of η: {{eq A}} is $\frac12\,l2$ when $\psi : \eta = 1.0987$. The figure shows it,
and `--eta 1e-9rad --psi 1.0986841e-9rad` tells 0.34657.
:::
*/

CHECK_THAT("half of ln 2 is missing after a tenth of η, at 1.0987 η")
{
  const Fifty x = 1 / sqrt(1 - pow(sqrt(Fifty(2)) - 1, 2));
  CHECK(x == within(1.0986841134678, 1e-13, "fourteen digits"));
  CHECK(acosh(x) - log(x) == within(exact::ln2() / 2, 1e-48, "(A)"));
  for(const Told& now : told_at("eta=1e-9rad psi=1.0986841134678100e-9rad"))
    CHECK(now.value("short_by")
          == within(exact::ln2() / 2, 1e-13, "x to fourteen digits, and a difference"));
}
