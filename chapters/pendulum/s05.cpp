#include <gsl/gsl_odeiv2.h>

#include "edition/section.hpp"
#include "pendulum/body.hpp"
#include "pendulum/equation.hpp"
#include "pendulum/plate.hpp"
#include "pendulum/scene.hpp"
#include "pendulum/scene_judge.hpp"
#include "pendulum/steps.hpp"
#include "swing/motion.hpp"
#include "swing/oracle.hpp"

SECTION(pendulum, 5, "The equation of motion")

using pendulum::Place, pendulum::arc, pendulum::leapfrog, pendulum::line, pendulum::runge_kutta;
using swing::Amplitude, swing::Motion;

/*!
## What Euler does

::: margin
Today: $\ddot\theta = -(mga/I)\sin\theta$. Euler's $g$ is a length: in the first second a body falls
$\frac12\cdot9.8$ metres. So his $2g$ is our $g$.
:::

The moment of gravity divided by the moment of inertia gives the acceleration of the angle, and this one
equation contains the whole motion. Let the pendulum be moving away from its natural position $AB$, and let it
have come to $AG$ when the time $t$ has passed, counted in seconds, so that it has turned through the angle
$BAG = \Phi$. In the element of time $dt$ it turns through the element $GAg = d\Phi$. Its angular speed is
therefore $\frac{d\Phi}{dt}$, and the differential of this divided by $dt$ is its acceleration,

$$ \frac{dd\Phi}{dt^2} , \tag{1} $$

the element $dt$ being taken constant. By the principles of motion the acceleration is proportional to the
moment of the driving force divided by the moment of inertia of the whole body about the axis of gyration $A$.
Both are known: the first is $Ma\sin\Phi$ ({{sec pendulum.04}}), taken negative because it tends to retard the
motion; the second is $M(aa+kk)$ ({{sec pendulum.03}}). If, then, $g$ denotes the height through which heavy
bodies fall in one second, the rules of mechanics supply the differential equation of the second order

$$ \frac{dd\Phi}{dt^2} = -\frac{2g\,Ma\sin\Phi}{M(aa+kk)} = -\frac{2ga\sin\Phi}{aa+kk} , \tag{2} $$

from which the whole motion of the pendulum must be derived.

## The program

The equation is a quotient, with the mass above and below.
*/

double acceleration(double phi, double M, double a, double k, double g)  // (2)
{
  const double moment = -M * std::sin(phi);
  const double inertia = M * (a + k * (k / a));  // each divided by a, so that no square overflows
  return 2 * g * (moment / inertia);
}

/*!
A machine needs no more to follow the motion step by step. The simplest good rule is the leapfrog, which asks
for the acceleration at the beginning and at the end of each step.

::: code pendulum/steps.hpp leapfrog
:::

The rule of Runge and Kutta takes four accelerations a step. The GSL has one of the eighth order that chooses
its own steps.
*/

double with_gsl(Place at, double t, double (*turning)(double))
{
  const auto rule = [](double, const double y[], double dy[], void* f) {
    dy[0] = y[1];
    dy[1] = (*static_cast<double (**)(double)>(f))(y[0]);
    return 0;
  };
  gsl_odeiv2_system system{rule, nullptr, 2, &turning};
  auto* driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, t / 100, 1e-14, 1e-14);
  double now = 0, y[2] = {at.phi, at.rate};
  gsl_odeiv2_driver_apply(driver, &now, t, y);
  gsl_odeiv2_driver_free(driver);
  return y[0];
}

/*!
The exact solution came with Jacobi's elliptic functions. With $c = \sin\frac12\zeta$ and
$\tau = t\sqrt{2g}/\sqrt b$, where $b = (aa+kk)/a$, it is $\sin\frac12\Phi = c\,\operatorname{sn}(\tau, c)$.
The library has it as {{api swing::Motion}}, and in fifty digits as the judge. The speed in $AB$, with which
the steps begin, is that of {{sec pendulum.06}}.
*/

const auto swing_ = amplitude(90_deg, open(0_deg, 180_deg));
const auto t = real("t", 1.0, seconds, closed(1e-100, 1000), "time since the pendulum left AB");
const auto a = real("a", 0.5, metres, scale, "distance AG of the centre of gravity from the axis");
const auto k = real("k", std::sqrt(1.0 / 12), metres, closed(0, 1e100), "radius of gyration about G");
const auto M = real("M", 1.0, kilograms, scale, "mass, and at the same time the weight");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second");

double turning(double phi)
{
  return acceleration(phi, M, a, k, g);
}

double per_second()  // τ/t
{
  return std::sqrt(2 * g) / std::sqrt(pendulum::equivalent_length<double>(a, k));
}

Fifty tau_as_given()  // t√2g/√b from the numbers as they were written
{
  return t.fifty() * sqrt(2 * g.fifty() / pendulum::equivalent_length(a.fifty(), k.fifty()));
}

TELL
{
  require(t * per_second() < 1e5, "t", "less than a hundred thousand times √b/√(2g)");
  const double phi = Motion({swing_.zeta, swing_.eta}).angle(t * per_second());
  tell("phi", phi, degrees, "where the pendulum is at the time t");
  tell("acceleration", turning(phi), Unit{"rad/s²"}, "its acceleration there");
}

/*!
Euler's second figure shows the element of the motion; the next, whole motions.
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

TELL
{
  pendulum::scene_of_swing("swing", {swing_.zeta, swing_.eta}, 1 / per_second());
}

/*!
One second after it left $AB$ the rod has turned at {{zeta|deg0}}, passed $AB$ on its way back, and stands at
{{phi|deg1}}.

::: figure pendulum-05
alt: From the axis A a vertical line to B, an oblique line to G, and close beyond it a line to g. The angle
from AB to AG is marked Φ, the small one from AG to Ag dΦ.

The second figure of Euler's plate, drawn after the text: the pendulum on its way out at the time $t$, and
again when the element $dt$ has passed.
:::

::: figure pendulum-05-motion
alt: Four curves of the angle against the time. For 30 degrees it looks like a sine with a period of two.
Wider swings take longer; for 179 degrees the pendulum stands almost still near 179 degrees most of the time
and whips through the lowest point, alternately up and down.

Four motions of one pendulum that leaves $AB$ with different speeds. The narrow swing is nearly a sine; the
nearer the turning point is to the top, the longer the pendulum stays there, with almost no acceleration.
:::

::: scene swing
alt: A pendulum hangs from its axis, drawn aside by the amplitude; a grey arc marks the way of its bob.

The motion of the rod in its true time, let go at the turning point. Bring ζ near 180° and it lingers there.
:::

## Speed against error
*/

TELL
{
  const auto judge = pendulum::judge_of(swing_.zeta.fifty(), swing_.eta.fifty());
  const Fifty tau = tau_as_given();
  const Place start{0, 2 * per_second() * std::sin(swing_.zeta / 2)};
  std::vector<Method> ways;
  for(const int n : {16, 64, 256, 1024})
    ways.push_back({"leapfrog, " + std::to_string(n) + " steps",
                    [=] { return leapfrog(start, t, n, turning).phi; }, "leapfrog"});
  for(const int n : {8, 32, 128, 512})
    ways.push_back({"Runge-Kutta, " + std::to_string(n) + " steps",
                    [=] { return runge_kutta(start, t, n, turning).phi; }, "Runge-Kutta"});
  ways.push_back({"GSL, eighth order", [=] { return with_gsl(start, t, turning); }});
  const Motion motion({swing_.zeta, swing_.eta});
  ways.push_back({"this edition", [=] { return motion.angle(t * per_second()); }});
  race("place", "Φ at the time t", judge.angle(tau), ways);
}

/*!
The physics engines of games take steps too, sixty a second, by rules of the first order, and what is lost at
each adds up. A pendulum of one metre, let go at a right angle with nothing that damps it, should swing as far
after a minute:

{{collected engines pendulum}}

The bob is a small ball or disc, which makes the true periods differ a little; the mean period is that of the
whole minute, and shortens as the swing dies. Smaller steps help, more iterations do not. How the engines were
asked stands in [Other systems](other-systems.html).

## Checks

For the three weights of {{sec pendulum.03}} the equation can be had without $a$ and $k$: the moment of all
elements, by the sum of all squares. And $2g$ is the right factor by Euler's own definition: a point on a
level thread begins to fall freely, and keeping that acceleration it falls through $g$ in the first second.
*/

CHECK_THAT("the equation holds for a body element by element, and 2g is its constant")
{
  const auto body = pendulum::body_of(pendulum::three_weights());
  for(const double phi : {-170_deg, -30_deg, 0.5_deg, 60_deg, 120_deg})
  {
    const auto elements = pendulum::turned(pendulum::three_weights(), phi);
    const double moment = elements.row(0).dot(elements.row(1));
    CHECK(acceleration(phi, body.M, body.a(), body.k, 4.9)
          == within(-2 * 4.9 * moment / pendulum::moment_of_inertia(elements, {0, 0}), 1e-14,
                    "a dozen roundings of numbers up to 7"));
  }
  CHECK(acceleration(90_deg, 1, 0.75, 0, 4.9) * 0.75 / 2 == within_ulps(-4.9, 2, "three roundings"));
}

CHECK_THAT("the scene shows the motion itself, in its true time")
{
  for(const Told& now : told_at("", "zeta=150 a=0.25", "eta=1e-6"))
  {
    const Fifty unit = sqrt(pendulum::equivalent_length(Fifty(a), Fifty(k)) / (2 * Fifty(g)));
    const pendulum::Scene_judge judge(swing_.zeta.fifty(), swing_.eta.fifty(), unit);
    for(const auto& frame : now.points("swing", 9))
    {
      const Fifty phi = judge.angle(frame.at("t"));
      CHECK(frame.value("t") == between(0, judge.last(), "one period"));
      CHECK(frame.value("phi") == within(phi, judge.slack(), judge.because));
      CHECK(frame.value("x") == within(sin(phi), judge.slack(), judge.because));
      CHECK(frame.value("y") == within(-cos(phi), judge.slack(), judge.because));
    }
  }
}

CHECK_THAT("the exact motion has the acceleration (2)")
{
  const Fifty unit = sqrt(2 * Fifty(4.9) / pendulum::equivalent_length(Fifty(0.5), Fifty(0.3)));
  const Fifty dt("1e-12");
  for(const double zeta : {1_deg, 60_deg, 150_deg, 179_deg})
    for(const double time : {0.3, 1.0, 5.0, 12.0})
    {
      const auto motion = swing::oracle::Motion::from_zeta(zeta);
      const Fifty before = motion.angle(unit * (time - dt)), now = motion.angle(unit * time),
                  after = motion.angle(unit * (time + dt));
      CHECK((after - 2 * now + before) / (dt * dt)  // (1)
            == within(acceleration(static_cast<double>(now), 1, 0.5, 0.3, 4.9), 1e-14,
                      "ten roundings up to 15"));
    }
}

CHECK_THAT(
    "halving the steps leaves a sixteenth of Runge and Kutta's error, and a quarter of the leapfrog's")
{
  const auto simple = [](double phi) { return -std::sin(phi); };
  const double K = swing::quarter_time({90_deg, 90_deg});
  const auto rk = [&](int n) { return runge_kutta({90_deg, 0}, K, n, simple).phi; };  // it should be 0
  const auto frog = [&](int n) { return leapfrog({90_deg, 0}, K, n, simple).phi; };
  CHECK(rk(40) / rk(80) == within(16, 0.2, "order four, and a fortieth for the next order"));
  CHECK(frog(40) / frog(80) == within(4, 0.002, "order two; the next is four"));
  CHECK(with_gsl({90_deg, 0}, K, simple) == within(0, 1e-13, "a tolerance of 10⁻¹⁴ a step, and ten steps"));
}

/*!
Let go $10^{-12}$ of a radian from the top, the pendulum cannot be followed in Φ: a double near 180° holds
what is missing to the top to four digits only. The angle from the top, $\psi = 180°-\Phi$, has all its
digits, and its equation is the same with the sign changed.
*/

CHECK_THAT("let go just short of the top, steps in ψ find the bottom, and steps in Φ miss it")
{
  const double eta = 1e-12, K = swing::quarter_time_from_top(eta);
  const auto down = [](double psi) { return std::sin(psi); };
  const auto up = [](double phi) { return -std::sin(phi); };
  CHECK(runge_kutta({eta, 0}, K, 4000, down).phi
        == within(std::numbers::pi, 3e-9, "4000 steps, the rule's own error"));
  CHECK(std::abs(runge_kutta({std::numbers::pi - eta, 0}, K, 4000, up).phi)
        == between(2e-4, 2e-3,
                   "η is off by 2·10⁻⁴ of itself, each early step rounds anew, and the speed is 2"));
}

/*!
What is told, and every way of the race, by the exact motion in fifty digits:
*/

swing::oracle::Motion judged()
{
  using Judge = swing::oracle::Motion;
  return swing_.zeta < swing_.eta ? Judge::from_zeta(swing_.zeta.fifty())
                                  : Judge::from_eta(swing_.eta.fifty());
}

CHECK_THAT(
    "the angle and the acceleration told are the exact motion's, the acceleration its second difference")
{
  for(const Told& now :
      told_at("", "zeta=170 t=3 a=1 k=0", "zeta=1e-6 t=0.001 a=2 k=3 M=5 g=16", "eta=1e-6 t=2"))
  {
    const Fifty tau = tau_as_given(), rate = tau / t.fifty(), h("1e-12");
    const auto motion = judged();
    const Fifty Phi = motion.angle(tau);
    const double late = 1e-15 * (1 + static_cast<double>(tau)) * (2 * swing_.zeta + 1e-300);
    CHECK(now.value("phi", degrees) == within(Phi, late, "two ulps of ζ, and a time that rounds"));
    const Fifty bend = (motion.angle(tau + h) - 2 * Phi + motion.angle(tau - h)) / (h * h) * rate * rate;
    const double steep = static_cast<double>(rate * rate);
    CHECK(now.value("acceleration", Unit{"rad/s²"})
          == within(bend, steep * (2 * late + 1e-22) + 2e-15 * std::abs(static_cast<double>(bend)),
                    "Φ, and few roundings"));
  }
}

CHECK_THAT(
    "the exact way of the race is the motion's, the steps' errors fall by their orders, GSL's is small")
{
  for(const Told& now : told_at("", "zeta=60 t=0.5", "zeta=20 t=1 a=1 k=0"))
  {
    const Fifty Phi = judged().angle(tau_as_given());
    CHECK(now.exact("place") == within(Phi, 1e-45, "the same oracle at the same numbers"));
    const auto bound = [&](double order, double n, double constant) {
      return constant * std::pow(n, -order);
    };
    for(const int n : {16, 64, 256, 1024})
      CHECK(now.method("place", "leapfrog, " + std::to_string(n) + " steps")
            == within(Phi, bound(2, n, 20) + 1e-13, "order two, on ways of a few radians"));
    for(const int n : {8, 32, 128, 512})
      CHECK(now.method("place", "Runge-Kutta, " + std::to_string(n) + " steps")
            == within(Phi, bound(4, n, 400) + 1e-13, "order four"));
    CHECK(now.method("place", "GSL, eighth order") == within(Phi, 1e-12, "a tolerance of 10⁻¹⁴ a step"));
    CHECK(now.method("place", "this edition") == within(Phi, 5e-15, "two ulps, and a time that rounds"));
  }
}

CHECK_THAT("the figures are the body's lines and arcs, and four exact motions")
{
  for(const Told& now : told_at(""))
  {
    const auto plate = now.points("fig_2");
    const Fifty Phi = 38 * exact::pi() / 180, on = 45 * exact::pi() / 180;
    CHECK(plate.at(1).value("y") == within(-1, 1e-15, "B is below A"));
    CHECK(plate.at(3).value("x") == within(sin(Phi), 3e-16, "G"));
    CHECK(plate.at(3).value("y") == within(-cos(Phi), 3e-16, "G"));
    CHECK(plate.at(1).value("x") == within(0, 1e-16, "B is below A"));
    CHECK(plate.at(5).value("x") == within(sin(on), 3e-16, "g"));
    CHECK(plate.at(5).value("y") == within(-cos(on), 3e-16, "g"));
    int curve = -1;
    double before = 9;
    for(const auto& point : now.points("motion", 60))
    {
      const double swings = point.at("swings");
      curve += swings < before ? 1 : 0;
      before = swings;
      const Fifty zeta =
          Fifty(std::array{30, 90, 150, 179}.at(static_cast<std::size_t>(curve))) * exact::pi() / 180;
      const auto motion = swing::oracle::Motion::from_zeta(zeta);
      CHECK(point.value("phi")
            == within(motion.angle(swings * exact::pi()) * 180 / exact::pi(), 1e-10, "times to 25"));
    }
  }
}

CHECK_THAT("a time of a hundred thousand units √b/√(2g) is refused for any of their lengths, and one just "
           "less is not")
{
  for(const char* const beyond : {"zeta=1e-9 a=1 k=0 g=5e3 t=1000", "a=2 k=2 g=2e8 t=10"})
    CHECK(refused_at(beyond));
  for(const char* const within_it :
      {"zeta=1e-9 a=1 k=0 g=5e3 t=999.9999999999998", "a=2 k=2 g=2e8 t=9.999999999999998"})
    CHECK(!refused_at(within_it));
}

/*!
## Go on from here

::: exercise
Hang the rod not by its end but a sixth of a metre from its middle, and start it to the same amplitude.
Where is it after a second? And if it were a thousand times as heavy?

answer: Where it was before, at {{phi|deg1}}, and its mass does not matter. Both places have the same $b$:
hung by its centre of oscillation, a body keeps its time ({{sec pendulum.06}}).
:::
*/

CHECK_THAT("hung by its centre of oscillation, however heavy, the rod is in the same place")
{
  const Fifty tau = sqrt(2 * g.fifty() * 3 / 2);  // b is ⅔ of a metre
  for(const Told& now : told_at("a=0.16666666666666666", "a=0.16666666666666666 M=1000"))
    CHECK(now.value("phi", degrees) == within(judged().angle(tau), 1e-14, "a and k are rounded"));
}
