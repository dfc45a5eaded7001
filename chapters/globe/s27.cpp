#include "edition/section.hpp"
#include "globe/rolling.hpp"

SECTION(globe, 27, "How much friction rolling needs")

using namespace globe;

/*!
## What Euler does

Whether the ball can roll depends on the friction that rolling would need, and Euler looks for where it needs
most. With $S$ for the fraction that {{sec globe.26}} found, the equation for $\lambda$ becomes
$S + a - c\cos\Phi = \frac c\lambda\sin\Phi$, whence

$$ \lambda = \frac{c\sin\Phi}{S + a - c\cos\Phi}. \tag{1} $$

At $\Phi = 0$ and $\Phi = 180°$ no friction is needed; there, he says, is no danger that it should not
suffice. So he examines the angles between, 90° and 270°. At the first

$$ S = -\frac{kk(aa+cc+kk+2aC)}{kk(2C-a)+2Ccc-a^3-acc}{{entry numerator}}, \qquad
   \lambda = \frac{c}{S+a}{{entry sign}}, \tag{2} $$

and at the second the same with the other sign. If only the constant $C$ is such that $S + a$ is greater than
$3c$, rolling can go on. Since other cases can hardly be worked out than those with a very small $c$, he
neglects its higher powers,

$$ S + a = \frac{(aa+kk)^2}{a^3 - kk(2C-a)}. \tag{3} $$

Calling this $mc$, with $m > 3$, he finds $C$, or, more conveniently,

$$ \lambda = \frac{c(a^3 + akk - 2Ckk)}{(aa+kk)^2}. \tag{4} $$

Unless $C$ is very large, that does not go beyond the limit which he allows to friction.

::: margin
Today: $\lambda\le\mu$ is Coulomb's condition. $C = c(2h-1)$, where $h$ is the energy over what it takes to
stand still at the top.
:::

Three things are missing. The greatest friction is not needed at 90°, nor need the ball get there. The
condition has two sides: for fast turning $S + a$ is negative. And at the top there is danger after all: the
pressure may vanish, and with it every friction. This is first lost at the top only while

$$ kk \ge (a+c)(3c-a), \qquad\text{that is}\quad c \le \tfrac13\bigl(\sqrt{4aa+3kk}-a\bigr); \tag{A} $$

with more eccentricity it is lost before, at an angle below 180°.

## The program

Euler's two estimates are these. The library's λ is the same fraction without $S$, which has poles.
*/

template <class Real>
Real at_right_angle(Real a, Real c, Real k, Real C)  // (2)
{
  const Real S = -k * k * (a * a + c * c + k * k + 2 * a * C)
                 / (k * k * (2 * C - a) + 2 * C * c * c - a * a * a - a * c * c);
  return c / (S + a);
}

template <class Real>
Real for_small_c(Real a, Real c, Real k, Real C)  // (4)
{
  const Real A = a * a + k * k;
  return c * (a * a * a + a * k * k - 2 * C * k * k) / (A * A);
}

const auto a = real("a", 1, feet, closed(1, 1), "radius of the ball, the unit of length");
const auto c = real("c", 0.1, feet, closed(0.01, 1), "CG, from the ball's centre to its centre of gravity");
const auto k =
    real("k", 0.6, feet, closed(0.1, 2), "radius of gyration: the moment of inertia about G is Pkk");
const auto h = real("h", 3, none, closed(0.01, 1e4), "energy, as a part of what the top asks for");
const auto mu = real("mu", 0.3, none, closed(0.01, 10), "friction over pressure that the plane can give");

TELL
{
  const Ball<double> ball{a, c, k};
  const auto loss = rolling::loss_of_pressure(ball);
  require(h < loss.h, "h", "less than the energy with which the pressure is lost");
  const auto most = rolling::greatest_friction(ball, energy<double>(h));
  const double C = c * (2 * h - 1);
  tell("right", at_right_angle<double>(a, c, k, C), "λ at 90°, by (2)");
  tell("small", for_small_c<double>(a, c, k, C), "the same for very small c, by (4)");
  tell("lambda", most.lambda, "the λ that is greatest, in either direction");
  tell("Phi", most.Phi, degrees, "where it is needed");
  tell("c_early", rolling::eccentricity_of_early_loss<double>(a, k), feet, "c beyond which (A) fails");
  auto& lost = table("lost", "Where the pressure is first lost",
                     {{"c", "c (feet)"}, {"h", "energy"}, {"Phi", "Φ", degrees, 9}});
  for(const double part : {0.25, 0.5, 1.0, 1.25, 1.5})
  {
    const double c_ = part * rolling::eccentricity_of_early_loss<double>(a, k);
    const auto first = rolling::loss_of_pressure(Ball<double>{a, c_, k});
    lost.row({c_, first.h, first.Phi});
  }
  auto& rolls = table("rolls", "Energies with which it rolls for ever", {{"from", "from"}, {"to", "to"}});
  for(const auto& window : rolling::windows(ball, mu))
    rolls.row({window.from, window.to});
}

TELL
{
  curve("needs", {"h", "lambda", "right", "small"}, [](Curve& needs) {
    const Ball<double> ball{a, c, k};
    const double end = 0.95 * rolling::loss_of_pressure(ball).h;
    for(int n = 1; n <= 200; ++n)
    {
      const double h_ = n * end / 200, C = c * (2 * h_ - 1);
      needs.put({h_, std::abs(rolling::greatest_friction(ball, energy(h_)).lambda),
                 std::abs(at_right_angle<double>(a, c, k, C)), std::abs(for_small_c<double>(a, c, k, C))});
    }
  });
}

/*!
At three times the energy for the top the ball needs most at {{Phi|5}}°, a little more than at 90°:
{{lambda|4}} against {{right|4}}; for very small $c$ Euler would reckon {{small|4}}.

{{table rolls}}

{{table lost}}

::: figure globe-27
alt: The friction needed against the energy: the exact curve and the two estimates.

The greatest friction that rolling needs against the energy: exactly (blue), and by Euler's estimates at 90°
(dashed) and for small $c$ (red).
:::

## Checks

All is held against {{sec globe.25}}: the acceleration of the rolling ball, and the force that this asks for.
*/

struct Forces
{
  Fifty friction, pressure;  // over the weight
};

Forces forces(const Fifty& a, const Fifty& c, const Fifty& k, const Fifty& h, const Fifty& Phi)
{
  const Fifty s = sin(Phi), u = cos(Phi), D = a * a + c * c + k * k - 2 * a * c * u;
  const Fifty ww = 2 * c * (2 * h - 1 + u) / D;  // with 2g = 1
  const Fifty turning = -s * (c + a * c * ww) / D;
  return {-(turning * (a - c * u) + c * ww * s), 1 + c * (turning * s + ww * u)};
}

CHECK_THAT(
    "the friction told is what the rolling motion asks for, and nowhere on its way does it ask for more")
{
  for(const Told& now : told_at("", "h=0.4 c=0.5 k=0.5", "h=35", "c=0.3 k=1.5 h=1"))
  {
    const Fifty a_ = a.fifty(), c_ = c.fifty(), k_ = k.fifty(), h_ = h.fifty(), C = c_ * (2 * h_ - 1);
    const auto most = rolling::greatest_friction(Ball<Fifty>{a_, c_, k_}, energy(h_));
    const Forces there = forces(a_, c_, k_, h_, most.Phi), right = forces(a_, c_, k_, h_, exact::pi() / 2);
    CHECK(now.value("lambda")
          == within_relative(there.friction / there.pressure, 1e-12, "the motion there"));
    CHECK(now.value("Phi", degrees) == within(most.Phi, 1e-7, "half the digits, at a maximum"));
    CHECK(now.value("right") == within(right.friction / right.pressure, 1e-13, "some roundings"));
    CHECK(now.value("small") == within(for_small_c(a_, c_, k_, C), 1e-13, "some roundings"));
    CHECK(now.value("c_early", feet)
          == within_relative((sqrt(4 * a_ * a_ + 3 * k_ * k_) - a_) / 3, 1e-15, "(A)"));
    const Fifty end = h_ < 1 ? Fifty(2 * asin(sqrt(h_))) : exact::pi();
    for(int n = 0; n <= 90; ++n)
    {
      const Forces f = forces(a_, c_, k_, h_, n * end / 90);
      CHECK(abs(f.friction / f.pressure)
            == between(0, abs(there.friction / there.pressure) + 1e-40, "the most"));
    }
  }
}

CHECK_THAT("where the pressure is told to be lost it vanishes, and with less energy nowhere")
{
  for(const Told& now : told_at("", "k=1.5", "k=0.1 h=0.5"))
    for(const auto& row : now.rows("lost"))
    {
      const Fifty a_ = a.fifty(), k_ = k.fifty(), c_ = row.at("c"), h_ = row.at("h");
      const auto first = rolling::loss_of_pressure(Ball<Fifty>{a_, c_, k_});
      CHECK(forces(a_, c_, k_, first.h, first.Phi).pressure == within(0, 1e-35, "by the motion"));
      CHECK(row.value("h") == within_relative(first.h, 1e-12, "the library's bound"));
      CHECK(row.value("Phi", degrees)
            == within(first.Phi, 1e-6, "half the digits where (A) is just fulfilled"));
      CHECK(row.value("c") == between(0.05, 2, "parts of the bound"));
      const Fifty end = h_ < 1 ? Fifty(2 * asin(sqrt(h_))) : exact::pi();
      for(int n = 0; n <= 60; ++n)
        CHECK(forces(a_, c_, k_, h_ * (1 - 1e-9), n * end / 60).pressure == between(0, 1e9, "it bears"));
    }
}

CHECK_THAT("the pressure is first lost at the top up to the c of (A), and beyond it before the top")
{
  for(const Told& now : told_at("", "k=1.5", "k=0.1 h=0.5"))
    for(const auto& row : now.rows("lost"))
    {
      const double k_ = k, bound = (std::sqrt(4 + 3 * k_ * k_) - 1) / 3;
      CHECK((row.at("Phi", degrees) < 3.14) == (row.at("c") > bound * 1.001));
    }
}

CHECK_THAT("for very small c Euler's fraction (2) becomes (3), and its λ becomes (4)")
{
  const Fifty c_ = 1e-15, k_ = Fifty(3) / 5, C = Fifty(7) / 2;
  const Fifty by_3 = c_ * (1 - k_ * k_ * (2 * C - 1)) / pow(1 + k_ * k_, 2);
  CHECK(at_right_angle(Fifty(1), c_, k_, C) == within_relative(by_3, 1e-28, "cc is left out"));
  CHECK(for_small_c(Fifty(1), c_, k_, C) == within_relative(by_3, 1e-45, "the same, written otherwise"));
}

CHECK_THAT("at the ends of the energies told the plane just gives the friction that is needed")
{
  for(const Told& now : told_at("", "c=0.5 k=0.5 h=0.5", "mu=0.1"))
    for(const auto& row : now.rows("rolls"))
    {
      const Ball<Fifty> ball{a.fifty(), c.fifty(), k.fifty()};
      const auto need = [&](double h_) {
        return abs(rolling::greatest_friction(ball, energy(Fifty(h_))).lambda);
      };
      CHECK(need(row.at("to")) == within_relative(mu.fifty(), 1e-9, "the motion needs just μ"));
      CHECK(row.value("to") == between(row.at("from"), 1e9, "in order"));
      CHECK(row.value("from") == between(0, row.at("to"), "in order"));
      if(row.at("from") > 0)
        CHECK(need(row.at("from")) == within_relative(mu.fifty(), 1e-9, "the motion needs just μ"));
    }
}

CHECK_THAT("the curves are those of the motion and of the two estimates")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("needs", 5))
    {
      const Fifty a_ = a.fifty(), c_ = c.fifty(), k_ = k.fifty(), h_ = point.at("h"), C = c_ * (2 * h_ - 1);
      const auto most = rolling::greatest_friction(Ball<Fifty>{a_, c_, k_}, energy(h_));
      const Forces there = forces(a_, c_, k_, h_, most.Phi),
                   right = forces(a_, c_, k_, h_, exact::pi() / 2);
      CHECK(point.value("lambda")
            == within_relative(abs(there.friction / there.pressure), 1e-11, "the motion"));
      CHECK(point.value("right") == within(abs(right.friction / right.pressure), 1e-12, "some roundings"));
      CHECK(point.value("small") == within(abs(for_small_c(a_, c_, k_, C)), 1e-12, "some roundings"));
      CHECK(point.value("h") == between(0, 1e4, "below the loss"));
    }
}

bool is_the_friction(double reading)
{
  const Forces f = forces(1, Fifty(1) / 10, Fifty(3) / 5, 3, exact::pi() / 2);
  return reading == within_relative(f.friction / f.pressure, 1e-12, "the motion's own, at h = 3");
}

const Emendation numerator{"§27, the numerator of S",
                           {"−2ac", 0.1 / (0.36 * (1.37 - 0.2) + 1)},
                           {"+2aC", at_right_angle(1.0, 0.1, 0.6, 0.5)},
                           "the motion of our ball asks for that friction at 90°",
                           is_the_friction};

const Emendation sign{"§27, λ at 90°",
                      {"−c/(S+a)", -at_right_angle(1.0, 0.1, 0.6, 0.5)},
                      {"c/(S+a)", at_right_angle(1.0, 0.1, 0.6, 0.5)},
                      "(1) with sin 90° = 1, and the motion of our ball",
                      is_the_friction};
