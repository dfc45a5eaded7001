#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 14, "The equation of the descent")

/*!
## What Euler does

The equation of motion is written with the angles from the top. With the letters of {{sec pendulum.13}} the
two squares in the equation of motion are

$$ cc = \cos^2\tfrac12\eta = 1 - \sin^2\tfrac12\eta, \tag{1} $$

$$ zz = \cos^2\tfrac12\psi = 1 - \sin^2\tfrac12\psi, \tag{2} $$

and the rest of it becomes

$$ \frac{dz}{\sqrt{1-zz}} = \tfrac12\,d\psi. \tag{3} $$

Here he sets the sign $+$, where the differential of $\cos\tfrac12\psi$ would have $-$. He says why: now the
body is taken to go down, while before it had been going up. On the way up time and $z$ grow together, on
the way down $z$ decreases and $\psi$ grows; what has to be positive is the element of time.

In the difference $cc - zz$ the two ones cancel, and there remains

$$ \frac{dt\sqrt{2g}}{\sqrt b} = \frac{d\psi}{2\sqrt{\sin^2\tfrac12\psi - \sin^2\tfrac12\eta}}, \tag{4} $$

::: margin
Today: $\tfrac12\dot\psi^2 = 2\left(\sin^2\tfrac12\psi - \sin^2\tfrac12\eta\right)$ in the unit
$\sqrt{b/2g}$ of time, the energy counted from the top.
:::

where, he reminds us, the term $\sin^2\tfrac12\eta$ is as small as can be. The large number $c$, nearly one,
has gone; a small number has come in its place.

## The program

The equation as it stands, and before the ones were cancelled.
*/

double element(double psi, double eta)  // (4), without dψ
{
  return 1 / (2 * std::sqrt(std::pow(std::sin(psi / 2), 2) - std::pow(std::sin(eta / 2), 2)));
}

double element_before(double psi, double eta)  // (1), (2), (3)
    // (3) over the root of (1) less (2)
{
  const double cc = std::pow(std::cos(eta / 2), 2), zz = std::pow(std::cos(psi / 2), 2);
  return 0.5 / std::sqrt(cc - zz);
}

/*!
One difference is left, and just after the start, where $\psi$ is hardly more than $\eta$, it is again one
of nearly equal numbers. It is a product,

$$ \sin^2\tfrac12\psi - \sin^2\tfrac12\eta = \sin\tfrac12(\psi+\eta)\,\sin\tfrac12(\psi-\eta), \tag{5} $$

and if the way already gone, $\psi - \eta$, is what is given, nothing is lost at all.
*/

double element_of_way(double way, double eta)  // (4) by (5); way = ψ − η
{
  return 1 / (2 * std::sqrt(std::sin(eta + way / 2) * std::sin(way / 2)));
}

/*!
Free are the angle of the start and the angle that is reached; and, for seconds, the length and $g$.
*/

const auto swing_ = amplitude_from_top(0.1_deg);
const auto psi = angle("psi", 0.2_deg, above_to(0_deg, 180_deg), "the angle from the top that is reached");
const auto b = real("b", 1.0, metres, positive, "length of the equivalent simple pendulum");
const auto g =
    real("g", 4.903325, metres, positive, "height fallen in the first second, half of today's g");

TELL
{
  require(psi > swing_.eta, "psi", "greater than eta, where the descent begins");
  const double way = psi - swing_.eta, unit = std::sqrt(b / (2 * g));
  const double tau = swing::time_from_rest_past(way, swing_.eta);
  tell("element", element_of_way(way, swing_.eta), "dt/dψ in the unit √(b/2g)");
  tell("speed", 1 / (unit * element_of_way(way, swing_.eta)), Unit{"rad/s"}, "angular speed at ψ");
  tell("t", unit * tau, seconds, "time since the start");
  tell("cosh", swing_.eta * std::cosh(tau), degrees, "where η cosh t√(2g/b) would be by then");
  const Fifty start = Fifty(double(swing_.eta)), end = Fifty(double(psi));
  race("difference", "dt/dψ", 1 / (2 * sqrt(sin((end + start) / 2) * sin((end - start) / 2))),
       {{"1/(2√(cc − zz))", [] { return element_before(psi, swing_.eta); }},
        {"the equation (4)", [] { return element(psi, swing_.eta); }},
        {"the product (5)", [=] { return element_of_way(way, swing_.eta); }}});
}

/*!
How the element depends on ψ, for three starts, the last of them very near the top.
*/

TELL
{
  curve("element", {"psi", "element"}, [](Curve& c) {
    for(const double eta : {5_deg, 1_deg, 0.1_deg})
    {
      for(double way = 1e-3 * eta; eta + way <= 180_deg; way *= 1.06)
        c.put({(eta + way) / 1_deg, element_of_way(way, eta)});
      c.gap();
    }
  });
  curve("limit", {"psi", "element"}, [](Curve& c) {
    for(double psi_ = 0.05_deg; psi_ <= 180_deg; psi_ *= 1.06)
      c.put({psi_ / 1_deg, 0.5 / std::sin(psi_ / 2)});
  });
}

/*!
::: figure pendulum-14
alt: The element of time against ψ. Three curves fall from infinity, at 5, 1 and 0.1 degrees, to a common
one.

The time that each further radian takes, against the angle from the top. Every start has an infinite
element, which lasts only a moment; soon afterwards all three curves lie on one,
$\tfrac12 : \sin\tfrac12\psi$, as if η were nothing. That is what {{sec pendulum.15}} builds on.
:::

## Checks

The exact descent, in fifty digits, has at every moment the speed that {{eq 4}} gives it; and so has a
solution of the equation of motion, which near the top is $\psi'' = \sin\psi$ and knows nothing of any
integral.
*/

CHECK_THAT("the element is one over the speed of the exact descent")
{
  for(const double eta : {1e-8, 1e-3, 5_deg, 90_deg})
  {
    const auto motion = swing::oracle::Motion::from_eta(eta);
    for(const double part : {0.1, 0.5, 0.9, 1.0})
    {
      const Fifty t = motion.quarter() * part - motion.quarter();  // before the lowest point
      const Fifty reached = motion.angle_from_top(t), speed = abs(motion.velocity(t));
      const double way = static_cast<double>(reached - eta), width = 4 + static_cast<double>(reached / way);
      CHECK(element_of_way(way, eta) == within_ulps(1 / speed, 4, "two sines, a product, a root"));
      const double psi_ = static_cast<double>(reached), difference = static_cast<double>(speed * speed / 4);
      if(part < 0.5)
        continue;
      CHECK(element(psi_, eta) == within_ulps(1 / speed, width, "ψ is rounded, and the squares cancel"));
      const double lost = 1e-15 + 4e-16 / difference;
      CHECK(element_before(psi_, eta) == within_relative(1 / speed, lost, "two numbers near 1 cancel"));
    }
  }
}

CHECK_THAT("the element is one over the speed that the equation ψ'' = sin ψ leads to")
{
  const Fifty eta = exact::pi() / 36;
  const auto fall = [](const Fifty&, const exact::State& y) { return exact::State{y[1], sin(y[0])}; };
  for(const double t : {0.5, 2.0, 4.5})
  {
    const auto reached = exact::solve(fall, Fifty(0), {eta, Fifty(0)}, Fifty(t), Fifty("1e-25"));
    const double way = static_cast<double>(reached.y[0] - eta);
    CHECK(element_of_way(way, 5_deg) == within_ulps(1 / reached.y[1], 4, "two sines, a product, a root"));
  }
}

/*!
The sign in {{eq 3}}: on the way down $dz$ is negative when $d\psi$ is positive, and the element of time is
positive with both of his signs taken together.
*/

CHECK_THAT("dz is −½dψ times √(1 − zz), so that the sign + means the descent")
{
  for(const double reached : {1_deg, 60_deg, 179_deg})
  {
    const Fifty h("1e-20"), middle = reached;
    const Fifty slope = (cos((middle + h) / 2) - cos((middle - h) / 2)) / (2 * h);
    const Fifty z = cos(middle / 2);
    CHECK(slope / sqrt(1 - z * z) == within(Fifty(-0.5), 1e-25, "hh = 1e-40, and 1e-50 over h"));
  }
}

/*!
Near the top the pendulum is a body about an unstable balance, and goes as the hyperbolic cosine of the
time.
*/

CHECK_THAT("near the top ψ is η cosh t, while ψ is small")
{
  const double eta = 1e-9;
  const auto motion = swing::oracle::Motion::from_eta(eta);
  for(const double t : {0.1, 1.0, 10.0})
  {
    const Fifty reached = motion.angle_from_top(Fifty(t) - motion.quarter());
    CHECK(eta * std::cosh(t) == within_relative(reached, 1e-10, "the cube of an angle below 1.2e-5"));
  }
}

CHECK_THAT("one part in a hundred millions from the top the ones cancel to nothing, the product does not")
{
  CHECK(std::isinf(element_before(2e-8, 1e-8)));
  const Fifty difference = sin(Fifty(3e-8) / 2) * sin(Fifty(1e-8) / 2);
  CHECK(difference == within_relative(Fifty("7.4999999999999996875e-17"), 1e-15, "1e-8 is rounded"));
  const Fifty exact = 1 / (2 * sqrt(difference));
  CHECK(element_of_way(1e-8, 1e-8) == within_ulps(exact, 4, "two sines, a product, a root"));
}
