#include <algorithm>

#include "edition/section.hpp"
#include "pendulum/equation.hpp"
#include "pendulum/steps.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 6, "The speed at every angle, and the length b")

using pendulum::Place, pendulum::cosine_difference, pendulum::equivalent_length;
using swing::Amplitude;

/*!
## What Euler does

One integration gives the speed at every angle, and with it a length $b$ that stands for the whole body. He
multiplies the equation of {{sec pendulum.05}} on both sides by $2d\Phi$. Since
$\int d\Phi\sin\Phi = -\cos\Phi$, its integral is

$$ \frac{d\Phi^2}{dt^2} = \frac{4ga\cos\Phi}{aa+kk} + C . \tag{1} $$

To determine the constant he notes that $\frac{d\Phi^2}{dt^2}$ is the square of the angular speed, which must
vanish when the pendulum has reached its greatest excursion, $\Phi = \zeta$. So the constant, and with it the
equation that defines the motion of the pendulum, are

$$ C = -\frac{4ga\cos\zeta}{aa+kk} , \tag{2} $$

$$ \frac{d\Phi^2}{dt^2} = \frac{4ga(\cos\Phi-\cos\zeta)}{aa+kk} . \tag{3} $$

Now for brevity let

$$ \frac{aa+kk}a = a + \frac{kk}a = b ; \tag{4} $$

then

$$ \frac{d\Phi^2}{dt^2} = \frac{4g}b\,(\cos\Phi-\cos\zeta) . \tag{5} $$

The length $b$ is the distance of the centre of oscillation from the axis of suspension or, what comes to the
same, the length of the isochronous simple pendulum: of the one, that is, which would take on the very same
oscillating motion if it described arcs of the same amplitude. The body is gone from the equation. And at the
very beginning, when the pendulum left its vertical position $AB$, the square of its speed was

$$ \frac{4g}b\,(1-\cos\zeta) , \tag{6} $$

from which, he adds, one also has the height that is due to this speed.

::: margin
Today: conservation of energy, $\frac12\dot\theta^2 = \omega_0^2(\cos\theta-\cos\theta_0)$ with
$\omega_0^2 = 2g/b$. The height *due* to a speed $v$ is the one from which a body must fall to gain it,
$vv/4g$.
:::

The text that we have shows $2g$ for $4g$ in the first four of these formulae, but not in the last. Only $4g$
is right; see the apparatus.

## The program

The difference of the cosines decides everything here, and near the turning point there is nothing left of it
when it is formed as it stands. As a product it keeps its digits; and counted from the top, with
$\psi = 180° - \Phi$, it is the difference of the other two cosines.

::: code pendulum/equation.hpp cosine_difference
:::
*/

double difference(double phi, Amplitude to)
{
  const double psi = (swing::pi_hi - phi) + swing::pi_lo;
  return to.zeta < to.eta ? cosine_difference(phi, to.zeta) : cosine_difference(to.eta, psi);
}

double speed(double phi, Amplitude to, double b, double g)  // (5), its root
{
  return std::sqrt(4 * g / b * difference(phi, to));
}

double speed_at_bottom(Amplitude to, double b, double g)  // (6), its root
{
  return std::sqrt(8 * g / b) * std::sin(to.zeta / 2);
}

/*!
The same in the letters of the body, as Euler has it first.
*/

double first_integral(double phi, double a, double k, double g, double C)  // (1)
{
  return 4 * g * a * std::cos(phi) / (a * a + k * k) + C;
}

double constant(double zeta, double a, double k, double g)  // (2)
{
  return -4 * g * a * std::cos(zeta) / (a * a + k * k);
}

double square_of_speed(double phi, double zeta, double a, double k, double g)  // (3)
{
  return 4 * g * a * cosine_difference(phi, zeta) / (a * a + k * k);
}

/*!
And the length $b$, in the one order of operations in which no square overflows:

::: code pendulum/equation.hpp equivalent_length
:::
*/

double beyond_G(double a, double k) { return k * (k / a); }  // b − a

const auto swing_ = amplitude(60_deg);
const auto phi = angle("phi", 30_deg, closed(0_deg, 180_deg), "the present angle BAG = Φ");
const auto a = real("a", 0.5, metres, positive, "distance AG of the centre of gravity from the axis");
const auto k = real("k", 0.28867513459481287, metres, nonnegative, "radius of gyration about G");
const auto g = real("g", 4.903325, metres, positive, "height fallen in the first second");

TELL
{
  require(phi <= swing_.zeta, "phi", "at most zeta");
  const Amplitude zeta{swing_.zeta, swing_.eta};
  const double b = equivalent_length<double>(a, k), v = b * speed_at_bottom(zeta, b, g);  // (4)
  tell("b", b, metres, "distance of the centre of oscillation from the axis");
  tell("beyond_G", beyond_G(a, k), metres, "by how much it lies beyond G, kk/a");
  tell("speed", speed(phi, zeta, b, g), Unit{"rad/s"}, "angular speed at Φ");
  tell("at_bottom", speed_at_bottom(zeta, b, g), Unit{"rad/s"}, "angular speed in AB");
  tell("v", v, Unit{"m/s"}, "speed of the centre of oscillation in AB");
  tell("height_due", v * v / (4 * g), metres, "the height that is due to this speed");
}

TELL
{
  curve("phase", {"phi", "rate"}, [](Curve& c) {
    for(const double zeta : {30_deg, 60_deg, 90_deg, 150_deg, 180_deg})
    {
      for(int i = 0; i <= 360; ++i)
      {
        const double at = zeta * std::cos(i * 1_deg);
        const double rate = std::sqrt(2 * std::max(0.0, cosine_difference(at, zeta)));
        c.put({at / 1_deg, i <= 180 ? -rate : rate});
      }
      c.gap();
    }
  });
  curve("length", {"a", "b"}, [](Curve& c) {
    for(double over_k = 0.1; over_k < 10.1; over_k *= 1.02)
      c.put({over_k, equivalent_length(over_k, 1.0)});
  });
}

/*!
Let go at {{zeta|deg0}}, the rod of {{sec pendulum.01}} passes {{phi|deg0}} with {{speed|4}} radians a second
and $AB$ with {{at_bottom|4}}. Its centre of oscillation has then fallen {{height_due|4}} metres, and has the
speed of a body that has fallen so far.

::: figure pendulum-06
alt: Closed curves about the origin, one inside the other, in a plane of angle and angular speed. The inner
ones are nearly ellipses; the outer ones grow pointed towards −180 and 180 degrees. The outermost runs into
these two points: it is the boundary.

Equation {{eq 5}} as a picture: angular speed, in the unit $\sqrt{2g}/\sqrt b$, against angle. On each curve
the pendulum goes round clockwise, once in a period. The small ones are ellipses of one shape, and all take
the same time. The boundary belongs to 180°; on it the pendulum comes to the top and stays there.
:::

::: figure pendulum-06-length
alt: The length b against a, both in units of k, the first axis logarithmic. The curve has its minimum, 2, at
a equal to k and rises on both sides. A level line at 2.5 cuts it at one half and at 2.

The length $b$ of one body hung at different distances $a$ from its centre of gravity. It is least, $2k$, for
$a = k$. Any greater length belongs to two distances, whose product is $kk$ and whose sum is $b$: hang the
pendulum up by its centre of oscillation, and it swings as before.
:::

## Checks

Along the exact motion, whose speed comes from theta functions and not from {{eq 5}}, the first integral holds
to forty digits.
*/

/// The square of the angular speed at Φ in the exact motion, in the unit 2g/b.
Fifty by_motion(const Fifty& angle, const Fifty& zeta)
{
  const Fifty t = swing::oracle::time_from_bottom(angle, exact::pi() - zeta);
  return pow(swing::oracle::Motion::from_zeta(zeta).velocity(t), 2);
}

CHECK_THAT("the square of the speed is what the exact motion has, in all three forms")
{
  const double b = equivalent_length(0.5, 0.3);
  for(const double zeta : {1e-3, 60_deg, 120_deg, 170_deg})
    for(const double part : {0.0, 0.5, 0.9})
    {
      const double at = part * zeta;
      const Fifty exact_square = by_motion(at, zeta);
      CHECK(2 * (cos(Fifty(at)) - cos(Fifty(zeta)))
            == within(exact_square, 1e-40, "theta functions of fifty digits"));
      const Fifty in_seconds = exact_square * 2 * Fifty(4.9) / Fifty(b);
      CHECK(square_of_speed(at, zeta, 0.5, 0.3, 4.9)
            == within_ulps(in_seconds, 12, "eight operations, two sines"));
      CHECK(std::pow(speed(at, Amplitude::from_zeta(zeta), b, 4.9), 2)
            == within_ulps(in_seconds, 12, "the same, a root, a square"));
      CHECK(first_integral(at, 0.5, 0.3, 4.9, constant(zeta, 0.5, 0.3, 4.9))
            == within(in_seconds, 2e-14, "two numbers up to 29, each of six operations"));
    }
  CHECK(speed(30_deg, Amplitude::from_zeta(60_deg), 2, 1)
        == within_ulps(Fifty("0.855599677167352192969235766211"), 4, "two sines, three products, a root"));
}

/*!
The $4g$ at each of its places. Each formula is tried where it stands alone: {{eq 1}} by what it says of two
angles, {{eq 2}} at $\Phi = 90°$, where the constant is all that there is.
*/

const double body_ = 4.9 * 0.5 / (0.5 * 0.5 + 0.3 * 0.3);  // ga/(aa + kk)
const auto says_the_motion = [](const Fifty& square) {
  return [right = 2 * body_ * square](double reading) {
    return reading == within_relative(right, 1e-14, "a few roundings");
  };
};

const Doubtful in_the_integral{
    "§6, the first integral", {"2ga cos Φ", 2 * body_ * cosine_difference(0_deg, 30_deg)},
    {"4ga cos Φ", 4 * body_ * cosine_difference(0_deg, 30_deg)},
    "twice ∫ 2ga sin Φ dΦ is −4ga cos Φ; between 0° and 30° the exact motion loses twice what is printed",
    says_the_motion(by_motion(0, 60_deg) - by_motion(30_deg, 60_deg))};

const Doubtful in_the_constant{
    "§6, the constant C", {"−2ga cos ζ", -2 * body_ * std::cos(120_deg)},
    {"−4ga cos ζ", -4 * body_ * std::cos(120_deg)},
    "at Φ = 90° the constant is the whole square of the speed; for ζ = 120° it is twice what is printed",
    says_the_motion(by_motion(90_deg, 120_deg))};

const Doubtful in_the_bracket{
    "§6, with the constant put in", {"2ga (cos Φ − cos ζ)", 2 * body_ * cosine_difference(30_deg, 60_deg)},
    {"4ga (cos Φ − cos ζ)", 4 * body_ * cosine_difference(30_deg, 60_deg)},
    "at 30° the pendulum that swings to 60° has twice that square of the speed",
    says_the_motion(by_motion(30_deg, 60_deg))};

const Doubtful with_b{
    "§6, the same with b",
    {"2g/b", 2 * 4.9 / equivalent_length(0.5, 0.3) * cosine_difference(30_deg, 60_deg)},
    {"4g/b", 4 * 4.9 / equivalent_length(0.5, 0.3) * cosine_difference(30_deg, 60_deg)},
    "the section's last formula, and the root in §7, have 4g too",
    says_the_motion(by_motion(30_deg, 60_deg))};

/*!
The clause about the height due to the speed has suffered; as it stands it says that {{eq 6}} *is* that
height. But {{eq 6}} is the square of an angular speed. The centre of oscillation $O$ moves $b$ times as fast,
and the height due to its speed is $b(1-\cos\zeta)$, which is just how high it climbs: the sagitta of
{{sec pendulum.10}}.
*/

const Doubtful height{
    "§6, the height due to the speed", {"(4g/b)(1 − cos ζ)", 4 * 4.9 / 2.5 * (1 - std::cos(60_deg))},
    {"b (1 − cos ζ)", 2.5 * (1 - std::cos(60_deg))}, "a body that falls from there has the speed of O in AB",
    [](double reading) {
      const double v = 2.5 * speed_at_bottom(Amplitude::from_zeta(60_deg), 2.5, 4.9);  // b = 2,5
      const double seconds_of_fall = v / (2 * 4.9);
      const double fallen = 4.9 * seconds_of_fall * seconds_of_fall;
      return reading == within_ulps(fallen, 8, "a sine, a root, five products");
    }};

/*!
The length $b$: the simple pendulum obeys the same equation whatever the amplitude, and axis and centre of
oscillation may change places. Both exactly.
*/

CHECK_THAT("b stands for the body, is the same for the distance kk/a, and is never less than 2k")
{
  for(int i = 1; i <= 20; ++i)
  {
    const Rational a_(i, 7), k_(5, 3), b_ = a_ + k_ * k_ / a_, other = k_ * k_ / a_;
    CHECK(a_ / (a_ * a_ + k_ * k_) == 1 / b_);
    CHECK(other + k_ * k_ / other == b_);
    CHECK(a_ + other == b_);
    CHECK(b_ > 2 * k_);
  }
  CHECK(equivalent_length(5.0, 5.0) == 10);
}

CHECK_THAT("neither b nor the difference of the cosines is lost to overflow or cancellation")
{
  CHECK(equivalent_length(1e200, 1.0) == 1e200);
  CHECK(equivalent_length(1e-300, 1.0) == within_ulps(1e300, 1, "one division"));
  CHECK(beyond_G(1e8, 1) == 1e-8);
  CHECK(equivalent_length(1e8, 1.0) - 1e8 != 1e-8);  // in b itself it is lost
  const Fifty small("3.749999999999999999609375e-19");
  CHECK(cosine_difference(5e-10, 1e-9) == within_ulps(small, 4, "two sums, two sines, a product"));
  CHECK(std::cos(5e-10) - std::cos(1e-9) == 0);
  CHECK(speed(3.0, Amplitude::from_eta(1e-12), 2, 1)
        == within_ulps(sqrt(2 * (cos(Fifty(3)) + cos(Fifty(1e-12)))), 8, "ψ from π of 107 bits"));
}

/*!
With steps in place of the exact motion the energy is no longer kept. What Runge and Kutta's rule loses it
never gets back; the leapfrog's error comes and goes.
*/

CHECK_THAT("Runge and Kutta's energy drifts with the time, the leapfrog's does not")
{
  const auto simple = [](double x) { return -std::sin(x); };
  const auto worst = [&](auto rule, int from) {  // over 20 units of time after `from`
    double most = 0;
    Place at = rule(Place{60_deg, 0}, from, 10 * from, simple);
    for(int time = 0; time < 20; ++time)
    {
      at = rule(at, 1, 10, simple);
      most = std::max(most, std::abs(at.rate * at.rate / 2 - cosine_difference(at.phi, 60_deg)));
    }
    return most;
  };
  const auto rk = [](auto... x) { return pendulum::runge_kutta(x...); };
  const auto frog = [](auto... x) { return pendulum::leapfrog(x...); };
  CHECK(worst(rk, 2000) / worst(rk, 1000) == within_relative(2, 0.05, "twice the time, twice the loss"));
  CHECK(worst(frog, 2000) / worst(frog, 1000) == within_relative(1, 0.05, "the same error over and over"));
}
