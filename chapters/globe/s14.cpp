#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/asked.hpp"
#include "globe/ball.hpp"
#include "globe/oracle.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 14, "Case I: the smallest motions")

using namespace globe;

/*!
## What Euler does

A ball that is moved very little rocks like a pendulum; this is the first of the three cases in which the
time can be had. For our ball, Euler says, there is but one condition under which the formula of
{{sec globe.13}} can be treated in the usual way: the motion impressed is such that Φ remains very small for
ever, to which it is necessary that the angular velocity ζ at the start be infinitely small too. Then
$\sin\Phi = \Phi$ and $\cos\Phi = 1 - \frac12\Phi\Phi$, and it becomes

$$ dt = \frac{d\Phi\sqrt{kk + cc\Phi\Phi}}{\sqrt{\zeta\zeta kk - 2gc\Phi\Phi}}. \tag{1} $$

In the numerator $cc\Phi\Phi$ may safely be neglected against $kk$; and with $2gc = nnkk$

$$ dt = \frac{k\,d\Phi}{\sqrt{\zeta\zeta kk - 2gc\Phi\Phi}}
   = \frac{d\Phi}{\sqrt{\zeta\zeta - nn\Phi\Phi}}. \tag{2} $$

The integral is an arc whose sine is known,

$$ t = \frac1n A\sin\frac{n\Phi}{\zeta}, \qquad \frac{n\Phi}\zeta = \sin nt, \tag{3} $$

$$ \Phi = \frac{\zeta k}{\sqrt{2gc}}\,\sin\frac{t\sqrt{2gc}}{k}. \tag{4} $$

In our copy a letter γ stands for the sign of the root.

::: margin
Today: $k^2\ddot\theta = -2gc\,\theta$, a harmonic oscillation of the frequency $n = \sqrt{2gc}/k$. The
$n$ of {{sec globe.21}} is another quantity, a pure number.
:::

How safe is the neglect? The two terms that he drops are of the same order: $cc\Phi\Phi$ against $kk$, and
the $\frac1{24}\Phi^4$ of the cosine. Keep both to the first order, and write $A = \zeta:n$ and
$\varphi = nt$; then {{eq 4}} is followed by

$$ \begin{aligned} \Phi &= A\sin\varphi \\
   &\quad - A^3\Bigl(\frac1{16} + \frac{cc}{4kk}\Bigr)\varphi\cos\varphi \\
   &\quad + A^3\Bigl(\frac1{24} \\
   &\quad\; + \Bigl(\frac1{48} + \frac{cc}{4kk}\Bigr)\cos^2\varphi\Bigr)\sin\varphi.
   \end{aligned} \tag{A} $$

The second term grows with the time. It is no growing of the motion: it says that the true sine goes a
little slower, and since the ball is then each time a little later than {{eq 4}} has it, the error adds
up. What Euler loses is not the size but the pace. It is lost for a large $c:k$ far sooner than for a
pendulum, so that "very small" here means small not against a right angle only but also against $k:c$.

## The program

One line for {{eq 4}}, and one for what {{eq A}} adds.
*/

template <class Real>
Real by_euler(const Real& A, const Real& phase)  // (4)
{
  using std::sin;
  return A * sin(phase);
}

template <class Real>
Real next(const Real& q, const Real& A, const Real& phase)  // the rest of (A), q being cc:kk
{
  using std::cos, std::sin;
  const Real s = sin(phase), u = cos(phase);
  const Real there = (Real(1) / 24 + (Real(1) / 48 + q / 4) * u * u) * s;
  return A * A * A * (there - (Real(1) / 16 + q / 4) * phase * u);
}

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto asked = asked_energy(0.01);
const auto t = real("t", 0.4, seconds, closed(0, 1e100), "time since the lowest place");

TELL
{
  require(c <= 1e3 * k, "c", "between 1e-40 and a thousand times k");
  require(k <= 1e40 * c, "c", "between 1e-40 and a thousand times k");
  const Energy<Fifty> e0 = asked.fifty(c.fifty(), k.fifty() * k.fifty(), g.fifty());
  require(e0.from_top > 0, asked.given(), "an energy h below 1: the ball is to rock");
  const auto e = rounded(e0);
  const double n = std::sqrt(2 * g) * std::sqrt(c) / k, A = 2 * std::sqrt(e.h);
  require(t * n <= 1e3, "t", "at most a thousand over n");
  const double phase = double(t.fifty() * sqrt(2 * g.fifty() * c.fifty()) / k.fifty());
  tell("n", n, Unit{"1/s"}, "n, the frequency");
  tell("A", A, degrees, "ζ:n, the greatest Φ by (4)");
  tell("Phi_euler", by_euler(A, phase), degrees, "Φ at the time t, by (4)");
  tell("Phi_next", by_euler(A, phase) + next<double>(c / k * (c / k), A, phase), degrees, "by (A)");
  tell("Phi", smooth::angle(c, k, e, phase * k).Phi, degrees, "exactly");
  tell("pace", (1. / 16 + c / k * (c / k) / 4) * A * A, percent, "by how much it goes slower, by (A)");
}

TELL
{
  curve("error", {"swings", "exact", "next"}, [](Curve& error) {
    const Energy<Fifty> e = asked.fifty(c.fifty(), k.fifty() * k.fifty(), g.fifty());
    const double A = 2 * double(sqrt(e.h)), q = c / k * (c / k);
    for(int i = 0; i <= 240; ++i)
    {
      const double phase = i * std::numbers::pi / 60;
      const double off = smooth::angle(c, k, rounded(e), phase * k).Phi - by_euler(A, phase);
      error.put({i / 60., off / A, next<double>(q, A, phase) / A});
    }
  });
}

/*!
With an amplitude of {{A|4}} our ball stands at {{Phi|9}} after four tenths of a second, where {{eq 4}} has
{{Phi_euler|9}} and {{eq A}} {{Phi_next|9}}. Its pace is {{pace|3}} slower than Euler's.

::: figure globe-14
alt: Exact angle minus Euler's, as a part of the amplitude, over four swings: an oscillation that grows
evenly from nothing. The formula with the next term lies upon it at first and leaves it a little in the
later swings.

What {{eq 4}} lacks of the exact angle, as a part of the amplitude, over four single swings (blue), and what
{{eq A}} makes of it (red). The error grows because the ball falls behind.
:::

## Checks

Both formulae are held against the motion itself, by the equations of {{sec globe.06}} and {{sec globe.07}}.
*/

Fifty by_equations(const Energy<Fifty>& e, const Fifty& phase)  // Φ at nt = φ
{
  const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), second = sqrt(2 * g_ * c_), n = second / k_;
  const Ball<Fifty> ball{c_ + k_, c_, k_};
  // Φ over the amplitude, against φ, so that the steps are good for any smallness.
  const Fifty A = 2 * sqrt(e.h);
  const auto motion = [&](const Fifty&, const exact::State& s) {
    const Fifty turning = accelerations<Fifty>(ball, g_, A * s[0], n * A * s[1], 0).Phi;
    return exact::State{s[1], Fifty(turning / (n * n * A))};
  };
  return phase == 0 ? Fifty(0) : Fifty(A * exact::solve(motion, 0, {0, 1}, phase).y[0]);
}

CHECK_THAT("the angles told are (4), (A), and the motion's own")
{
  for(const Told& now : told_at("", "zeta=0.01 t=0.5", "h=0.3 c=0.5 t=0.9", "h=1e-30 c=40 k=1 t=0.2",
                                "from_top=0.01 t=0", "from_top=1e-100"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), n = sqrt(2 * g.fifty() * c_) / k_, phase = n * t.fifty();
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g.fifty());
    const Fifty zeta = velocity_of_energy<Fifty>(c_, k_ * k_, g.fifty(), e), A = zeta / n;
    const Fifty slow = (1 + 4 * pow(c_ / k_, 2)) / 16 * A * A, first = A * sin(phase);
    const Fifty more = A * A * sin(phase) * (2 + cos(phase) * cos(phase)) / 48
                       + pow(A * c_ / k_, 2) / 4 * sin(phase) * pow(cos(phase), 2)
                       - slow * phase * cos(phase);
    // An ulp of φ moves the sine by that times the cosine.
    const double slack = 1e-15 * double(A) * (1 + double(phase));
    CHECK(now.value("n", Unit{"1/s"}) == within_relative(n, 1e-15, "five roundings, some of them halved"));
    CHECK(now.value("A", degrees) == within_relative(A, 4e-16, "a root of a rounded number"));
    CHECK(now.value("Phi_euler", degrees) == within(first, slack, "an ulp of the phase"));
    CHECK(now.value("Phi_next", degrees)
          == within(first + A * more, slack * (1 + 8 * double(slow)), "the same, of either summand"));
    CHECK(now.value("pace", percent) == within_relative(slow, 2e-15, "eight roundings"));
    CHECK(now.value("Phi", degrees)
          == within(by_equations(e, phase), 8 * slack, "the library's ten ulps of the time"));
  }
}

CHECK_THAT(
    "it refuses a c, an energy and a time just beyond its limits, however given, and none before them")
{
  // With c = 1/8 and g = k = 1 h is ζζ; with c = k = 1 and g = 1/2 n is 1.
  for(const char* const beyond :
      {"c=1000.0000000000002 k=1", "c=500.0000000000001 k=0.5", "c=0.9999999999999998 k=1e40",
       "c=1.9999999999999996 k=2e40", "from_top=0.5 zeta=1e-300",
       "c=0.125 g=1 k=1 zeta=9.9999999999999999e-51", "h=1", "from_top=-1e-100", "c=0.125 g=1 k=1 zeta=1",
       "c=0.125 g=1 k=1 zeta=1e50", "c=0.125 g=1 k=1 zeta=1.0000000000000001e50",
       "c=1 g=0.5 k=1 t=1000.0000000000002", "c=4 g=2 k=2 t=500.0000000000001"})
    CHECK(refused_at(beyond));
  for(const char* const within_them :
      {"c=1000 k=1", "c=500 k=0.5", "c=1 k=1e40", "c=2 k=2e40", "from_top=0.5",
       "c=0.125 g=1 k=1 zeta=1.0000000000000001e-50", "h=0.99999999999999999", "from_top=1e-100",
       "c=0.125 g=1 k=1 zeta=0.99999999999999999", "c=1 g=0.5 k=1 t=1000", "c=4 g=2 k=2 t=500"})
    CHECK(!refused_at(within_them));
}

CHECK_THAT("the exact angle differs from (4) by what (A) adds, but for terms smaller by h(1 + cc:kk) again")
{
  for(const Told& now : told_at("h=1e-6", "h=1e-8 c=1.2", "h=1e-12 c=0.01"))
  {
    const Energy<Fifty> e = asked.fifty(c.fifty(), k.fifty() * k.fifty(), g.fifty());
    const Fifty A = 2 * sqrt(e.h), q = pow(c.fifty() / k.fifty(), 2);
    for(const double phase : {0.5, 2., 5.})
    {
      const Fifty off = by_equations(e, phase) - by_euler<Fifty>(A, phase);
      CHECK(off == within_relative(next<Fifty>(q, A, phase), 40 * double(e.h * (1 + q)), "the next order"));
    }
    CHECK(now.value("A", degrees) == within_relative(A, 4e-16, "a root of a rounded number"));
  }
}

CHECK_THAT("(4) is the motion of kk ddΦ = −2gcΦ dt², and starts with ζ")
{
  const Fifty A("1e-3"), phase("0.7"), step("1e-12");
  const auto at = [&](const Fifty& shift) { return by_euler<Fifty>(A, phase + shift); };
  CHECK((at(step) - 2 * at(0) + at(-step)) / (step * step)
        == within(-at(0), 1e-23, "a difference of fifty digits by steps of 1e-12"));
  CHECK(by_euler<Fifty>(A, step) / step == within(A, 1e-26, "the first of its velocity is An = ζ"));
}

CHECK_THAT("the errors drawn are the motion's and those of (A)")
{
  for(const Told& now : told_at("", "h=0.04 c=0.3"))
  {
    const Energy<Fifty> e = asked.fifty(c.fifty(), k.fifty() * k.fifty(), g.fifty());
    const Fifty A = 2 * sqrt(e.h), q = pow(c.fifty() / k.fifty(), 2);
    for(const auto& point : now.points("error", 5))
    {
      const Fifty phase = exact::pi() * Fifty(std::round(60 * point.at("swings"))) / 60;
      CHECK(point.value("swings") == between(0, 4, "four swings"));
      CHECK(
          point.value("exact")
          == within(by_equations(e, phase) / A - sin(phase), 2e-14, "the library's ten ulps of the time"));
      CHECK(point.value("next")
            == within(next<Fifty>(q, A, phase) / A, 1e-15 * double(A * A * (1 + q) * (1 + phase)),
                      "some roundings of its summands"));
    }
  }
}

/*!
## Go on from here

::: exercise
Let $G$ be as far from $C$ as $40k$. How small must the motion be for its pace to differ from Euler's by
less than a hundredth? Compare the pendulum, where $c:k$ does not count.
answer: By {{eq A}} $A^2(\frac1{16} + 400)$ is to be $0.01$, so that $A$ is 0.005, less than a third of a
degree. The pendulum, with $\frac1{16}A^2$, may swing up to $A = 0.4$, nearly 23°. `--c 40 --k 1 --h
6.249e-6` tells the pace.
:::
*/

CHECK_THAT("at c = 40k the pace is a hundredth slower already for A = 0.005")
{
  for(const Told& now : told_at("c=40 k=1 h=6.249e-6 t=0.01"))
  {
    CHECK(now.value("pace", percent) == within(0.01, 1e-5, "the h is rounded to four figures"));
    CHECK(now.value("A", degrees) == within(0.005, 1e-6, "the same"));
  }
  CHECK(0.4 * 0.4 / 16 == within(0.01, 1e-16, "the pendulum's pace"));
  CHECK(0.4 / 1_deg == between(22.9, 23, "nearly 23°"));
}
