#include <gsl/gsl_odeiv2.h>

#include "edition/section.hpp"
#include "pendulum/body.hpp"
#include "pendulum/equation.hpp"
#include "pendulum/plate.hpp"
#include "pendulum/steps.hpp"
#include "swing/motion.hpp"
#include "swing/oracle.hpp"

SECTION(pendulum, 5, "The equation of motion")

using pendulum::Place, pendulum::arc, pendulum::leapfrog, pendulum::line, pendulum::runge_kutta;
using swing::Amplitude, swing::Motion;

/*!
## What Euler does

The moment of gravity over the moment of inertia is the acceleration of the angle, and from this one equation
the whole motion follows. The pendulum is on its way out from its natural position $AB$, and when the time $t$
has passed, in seconds, it has come to $AG$, having turned through the angle $BAG = \Phi$. In the element of
time $dt$ it turns through the element $GAg = d\Phi$. So its angular speed is $\frac{d\Phi}{dt}$, and the
differential of this divided by $dt$ gives its acceleration,

$$ \frac{dd\Phi}{dt^2} , \tag{1} $$

with the element $dt$ taken constant. By the principles of motion the acceleration is proportional to the
moment of the driving force divided by the moment of inertia of the whole body about the axis of gyration,
which is at $A$. Both are known: the moment of the force is $Ma\sin\Phi$ ({{sec pendulum.04}}), to be taken
negative because it tends to slow the motion; the moment of inertia is $M(aa+kk)$ ({{sec pendulum.03}}). And
if $g$ denotes the height through which heavy bodies fall in one second, the rules of mechanics supply the
equation of the second degree

$$ \frac{dd\Phi}{dt^2} = -\frac{2g\,Ma\sin\Phi}{M(aa+kk)} = -\frac{2ga\sin\Phi}{aa+kk} , \tag{2} $$

from which the whole motion of the pendulum has to be derived.

::: margin
Today: $\ddot\theta = -\dfrac{mga}{I}\sin\theta$. Euler's $g$ is half of ours: in one second a body falls
$\frac12\cdot9{,}8$ metres, which he calls $g$.
:::

## The program

The equation is the quotient of two things already made. The mass stands in both.
*/

double acceleration(double phi, double M, double a, double k, double g)  // (2)
{
  const double moment = -M * a * std::sin(phi);
  const double inertia = M * (a * a + k * k);
  return 2 * g * moment / inertia;
}

/*!
That is enough for a machine. It goes in small steps, in each of which the acceleration counts as known; the
simplest rule that is any good is the leapfrog.

::: code pendulum/steps.hpp leapfrog
:::

The speed in $AB$ with which to begin is taken from {{sec pendulum.06}}. A better rule, of Runge and Kutta,
asks for the acceleration four times a step; and the GSL has rules of the eighth order that choose their own
steps.
*/

double with_gsl(Place at, double t, double (*turning)(double))
{
  const auto rule = [](double, const double y[], double dy[], void* f) {
    dy[0] = y[1];
    dy[1] = (*static_cast<double (**)(double)>(f))(y[0]);
    return 0;
  };
  gsl_odeiv2_system system{rule, nullptr, 2, &turning};
  const auto order_8 = gsl_odeiv2_step_rk8pd;
  gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&system, order_8, t / 100, 1e-14, 1e-14);
  double now = 0, y[2] = {at.phi, at.rate};
  gsl_odeiv2_driver_apply(driver, &now, t, y);
  gsl_odeiv2_driver_free(driver);
  return y[0];
}

/*!
The equation also has an exact solution, in the elliptic functions that Jacobi named: with
$c = \sin\frac12\zeta$ and $\tau = t\sqrt{2g}/\sqrt b$ it is $\sin\frac12\Phi = c\,\mathrm{sn}(\tau, c)$. The
library has it as {{api swing::Motion}}, and with fifty digits for a judge.
*/

const auto swing_ = amplitude(90_deg, open(0_deg, 180_deg));
const auto t = real("t", 1.0, seconds, above_to(0, 1000), "time since the pendulum left AB");
const auto a = real("a", 0.5, metres, positive, "distance AG of the centre of gravity from the axis");
const auto k = real("k", 0.28867513459481287, metres, nonnegative, "radius of gyration about G");
const auto M = real("M", 1.0, Unit{"kg"}, positive, "mass, and at the same time the weight");
const auto g = real("g", 4.903325, metres, positive, "height fallen in the first second");

double turning(double phi) { return acceleration(phi, M, a, k, g); }

TELL
{
  const double b = pendulum::equivalent_length<double>(a, k);
  const double per_second = std::sqrt(2 * g / b);
  require(t * per_second < 1e6, "t", "less than a million times √b/√(2g)");
  const Motion motion({swing_.zeta, swing_.eta});
  const double phi = motion.angle(t * per_second);
  tell("slowest", turning(swing_.zeta), Unit{"rad/s²"}, "acceleration at the turning point");
  tell("phi", phi, degrees, "where the pendulum is at the time t");
  tell("speed", per_second * motion.velocity(t * per_second), Unit{"rad/s"}, "how fast it turns there");
  tell("acceleration", turning(phi), Unit{"rad/s²"}, "and its acceleration");
  tell("period", motion.period() / per_second, seconds, "a whole period, there and back");
}

TELL
{
  const Fifty b = Fifty(a) + Fifty(k) * Fifty(k) / Fifty(a);
  using Judge = swing::oracle::Motion;
  const bool low = swing_.zeta < swing_.eta;  // the smaller of the two is known to more digits
  const Judge judge = low ? Judge::from_zeta(swing_.zeta.fifty()) : Judge::from_eta(swing_.eta.fifty());
  const double per_second = std::sqrt(2 * g / pendulum::equivalent_length<double>(a, k));
  const Place start{0, 2 * per_second * std::sin(swing_.zeta / 2)};
  std::vector<Method> ways;
  const auto way = [&](const char* rule, int n, auto follow) {
    ways.push_back({std::string(rule) + ", " + std::to_string(n) + " steps", follow, rule});
  };
  for(const int n : {16, 64, 256, 1024})
    way("leapfrog", n, [=] { return leapfrog(start, t, n, turning).phi; });
  for(const int n : {8, 32, 128, 512})
    way("Runge-Kutta", n, [=] { return runge_kutta(start, t, n, turning).phi; });
  ways.push_back({"GSL, eighth order", [=] { return with_gsl(start, t, turning); }});
  const Motion motion({swing_.zeta, swing_.eta});
  ways.push_back({"this edition", [=] { return motion.angle(t * per_second); }});
  race("phi", "Φ at the time t", judge.angle(Fifty(t) * sqrt(2 * Fifty(g) / b)), ways);
}

/*!
Euler's second figure shows the element of the motion. What the whole motion is like depends on the amplitude.
*/

TELL
{
  curve("fig_2", {"x", "y"}, [](Curve& c) {
    const double phi = 38_deg, d_phi = 7_deg;
    line(c, {0, 0}, pendulum::at(1, 0));            // AB
    line(c, {0, 0}, pendulum::at(1, phi));          // AG
    line(c, {0, 0}, pendulum::at(1, phi + d_phi));  // Ag
    arc(c, 1, 0, phi + d_phi);
    arc(c, 0.26, 0, phi);
    arc(c, 0.52, phi, phi + d_phi);
  });
  curve("motion", {"swings", "phi"}, [](Curve& c) {
    for(const double zeta : {30_deg, 90_deg, 150_deg, 179_deg})
    {
      const Motion motion(Amplitude::from_zeta(zeta));
      for(int i = 0; i <= 400; ++i)
        c.put({i / 50.0, motion.angle(i / 50.0 * std::numbers::pi) / 1_deg});
      c.gap();
    }
  });
}

/*!
::: figure pendulum-05
alt: From the axis A a vertical line to B, an oblique line to G, and close beyond it a line to g. The angle
from AB to AG is marked Φ, the small one from AG to Ag dΦ.

The second figure of Euler's plate, drawn after the text: the pendulum on its way out at the time $t$, and
where it is an element of time later.
:::

::: figure pendulum-05-motion
alt: Four curves of the angle against the time. For 30 degrees it looks like a sine with a period of 6.4.
Wider swings take longer; for 179 degrees the pendulum stands almost still near 179 degrees most of the time
and whips through the lowest point, alternately up and down.

Four motions that obey {{eq 2}}, all of the same pendulum and all leaving $AB$ at the same time. For narrow
swings it is the sine of the elements. The nearer the turning point to the top, the longer the pendulum hangs
there, with next to no acceleration.
:::

## Checks

First the equation itself. For the three weights of {{sec pendulum.03}} it can be had without $a$ and $k$:
what all elements pull, by the sum of all squares. And $2g$ is the right constant by Euler's own definition: a
weight on a level thread begins to fall freely, and with that acceleration kept up falls through $g$ in the
first second.
*/

CHECK_THAT("the equation holds for a body element by element, the mass cancels, and 2g is the constant")
{
  const pendulum::Elements elements = pendulum::three_weights();
  const auto body = pendulum::body_of(elements);
  const double lean = std::atan2(body.G.x(), -body.G.y());
  const double inertia = pendulum::moment_of_inertia(elements, {0, 0});
  for(const double phi : {-170_deg, -30_deg, 0.5_deg, 60_deg, 120_deg})
  {
    const auto arms = std::cos(phi - lean) * elements.row(1) - std::sin(phi - lean) * elements.row(2);
    const double by_elements = -2 * 4.9 * elements.row(0).dot(arms) / inertia;
    CHECK(acceleration(phi, body.M, body.a(), body.k, 4.9)
          == within(by_elements, 1e-14, "a dozen roundings of numbers up to 7"));
    CHECK(acceleration(phi, 1, 0.5, 0.3, 4.9) == acceleration(phi, 1024, 0.5, 0.3, 4.9));
  }
  const double fall_in_a_second = -0.75 * acceleration(90_deg, 1, 0.75, 0, 4.9) / 2;
  CHECK(fall_in_a_second == within_ulps(4.9, 2, "three roundings"));
}

CHECK_THAT("the exact motion satisfies the equation, to twenty-three digits")
{
  const Fifty dt("1e-12");
  for(const double zeta : {1_deg, 60_deg, 150_deg, 179_deg})
  {
    const auto motion = swing::oracle::Motion::from_zeta(zeta);
    for(const double tau : {0.3, 1.0, 5.0, 12.0})
    {
      const Fifty before = motion.angle(tau - dt), now = motion.angle(tau), after = motion.angle(tau + dt);
      CHECK((after - 2 * now + before) / (dt * dt)  // (1)
            == within(-sin(now), 1e-23, "dt²/12 of a fourth derivative of at most 5"));
    }
  }
}

/*!
Three places of three motions, by the library's {{api swing::Motion}}, by GSL in steps, and as they are known
to thirty digits.
*/

CHECK_THAT("the motion is where thirty digits say")
{
  const auto simple = [](double phi) { return -std::sin(phi); };
  const Fifty at_60("0.847798681677116844663678331881"), at_179("3.11181350604429767058142989753");
  const double c = std::sin(30_deg);
  const Motion narrow(Amplitude::from_zeta(60_deg)), wide(Amplitude::from_zeta(179_deg));
  CHECK(narrow.angle(1) == within_ulps(at_60, 8, "a quotient of two short series, an arc tangent"));
  CHECK(wide.angle(5) == within_ulps(at_179, 8, "the same"));
  CHECK(with_gsl({0, 2 * c}, 1, simple) == within(at_60, 1e-13, "GSL's tolerance, over a few steps"));
  const Motion from_rest(Amplitude::from_eta(5_deg), swing::Start::rest);
  CHECK(from_rest.angle_from_top(2) == within_ulps(Fifty("0.327331553638912965685362369018"), 8, "the same"));
}

CHECK_THAT("halving the steps leaves a sixteenth of Runge and Kutta's error, and a quarter of the leapfrog's")
{
  const auto simple = [](double phi) { return -std::sin(phi); };
  const double K = swing::quarter_time({90_deg, 90_deg});
  const auto late = [&](auto rule, int n) {  // by how much it misses AB, over its speed there
    const Place place = rule(Place{90_deg, 0}, K, n, simple);
    return std::abs(place.phi / place.rate / K);
  };
  const auto rk = [](auto... x) { return runge_kutta(x...); };
  const auto frog = [](auto... x) { return leapfrog(x...); };
  CHECK(late(rk, 40) == within_relative(1.85e-8, 0.01, "known to three digits"));
  CHECK(late(rk, 40) / late(rk, 80) == within_relative(16, 0.05, "order four"));
  CHECK(late(frog, 40) == within_relative(6.14e-5, 0.01, "known to three digits"));
  CHECK(late(frog, 40) / late(frog, 80) == within_relative(4, 0.01, "order two"));
}

/*!
Let go a billionth of a milliradian from the top, the pendulum loses the greater part of its digits not to the
rule but to the variable. Counted from the top, ψ = 180° − Φ, it obeys the same equation with the sign
changed, and keeps them.
*/

CHECK_THAT("from 10⁻¹² of a radian off the top, steps in ψ find the bottom, and steps in Φ miss it")
{
  const double eta = 1e-12, K = swing::quarter_time_from_top(eta);
  const auto down = [](double psi) { return std::sin(psi); };
  const auto up = [](double phi) { return -std::sin(phi); };
  const double found = runge_kutta({eta, 0}, K, 4000, down).phi;
  CHECK(found == within(std::numbers::pi, 1e-8, "4000 steps, the rule's own error"));
  const double missed = std::abs(runge_kutta({std::numbers::pi - eta, 0}, K, 4000, up).phi);
  CHECK(missed == between(1e-4, 1e-2, "η is known to 1e-4 in Φ, and time is lost in proportion"));
}
