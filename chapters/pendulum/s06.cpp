#include "edition/section.hpp"
#include "pendulum/equation.hpp"
#include "swing/oracle.hpp"

SECTION(pendulum, 6, "The speed at every angle, and the length b")

using pendulum::cosine_difference, pendulum::equivalent_length;

/*!
## What Euler does

One integration gives the speed at every angle, and with it a length $b$ that stands for the whole body. He
multiplies the equation of {{sec pendulum.05}} on both sides by $2d\Phi$. Since
$\int d\Phi\sin\Phi = -\cos\Phi$, its integral is

$$ \frac{d\Phi^2}{dt^2} = \frac{4g{{entry four_g}}a\cos\Phi}{aa+kk} + C . \tag{1} $$

Here $\frac{d\Phi^2}{dt^2}$ is the square of the angular speed, which must vanish when the pendulum has
reached its greatest excursion, $\Phi = \zeta$. This fixes the constant,

$$ C = -\frac{4ga\cos\zeta}{aa+kk} , \tag{2} $$

and the equation that determines the motion of the pendulum is now

$$ \frac{d\Phi^2}{dt^2} = \frac{4ga(\cos\Phi-\cos\zeta)}{aa+kk} . \tag{3} $$

For brevity he puts

$$ \frac{aa+kk}a = a + \frac{kk}a = b , \tag{4} $$

so that

$$ \frac{d\Phi^2}{dt^2} = \frac{4g}b\,(\cos\Phi-\cos\zeta) . \tag{5} $$

The length $b$ is the distance of the centre of oscillation from the axis of suspension. What comes to the
same, it is the length of the isochronous simple pendulum: the one that would take on the same oscillating
motion if it described arcs of the same amplitude. At the very beginning, when the pendulum left its vertical
position $AB$, the square of its speed was

$$ \frac{4g}b\,(1-\cos\zeta) , \tag{6} $$

and this formula, he adds, also expresses the height due to that speed {{entry height}}.

::: margin
Today: conservation of energy, $\frac12\dot\theta^2 = \omega_0^2(\cos\theta-\cos\theta_0)$ with
$\omega_0^2 = 2g/b$. The height *due* to a speed $v$ is the one from which a body must fall to gain it,
$vv/4g$.
:::

In the text before us the first four of these formulae, {{eq 1}} to {{eq 3}} and {{eq 5}}, have $2g$; only
{{eq 6}} has the $4g$ that all need.

## The program

First the integral as it stands.
*/

double first_integral(double phi, double C, double a, double k, double g)  // (1)
{
  return 4 * g * a * std::cos(phi) / (a * a + k * k) + C;
}

double constant(double zeta, double a, double k, double g)  // (2)
{
  return -4 * g * a * std::cos(zeta) / (a * a + k * k);
}

/*!
Together they are {{eq 3}}, but near the turning point they cancel. As a product of sines the difference of
the cosines keeps its digits.

::: code pendulum/equation.hpp cosine_difference
:::
*/

double square_of_speed(double phi, double zeta, double b, double g)  // (5)
{
  return 4 * g / b * cosine_difference(phi, zeta);
}

/*!
And the length $b$, in the order of operations in which no square overflows:

::: code pendulum/equation.hpp equivalent_length (4)
:::
*/

const auto swing_ = amplitude(60_deg);
const auto phi = angle("phi", 30_deg, closed(0_deg, 180_deg), "the present angle BAG = Φ");
const auto a = real("a", 0.5, metres, scale, "distance AG of the centre of gravity from the axis");
const auto k = real("k", std::sqrt(1.0 / 12), metres, closed(0, 1e100), "radius of gyration about G");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second");

TELL
{
  require(phi.fifty() <= swing_.zeta.fifty(), "phi", "at most zeta");
  const double b = equivalent_length<double>(a, k);                           // (4)
  const double at_bottom = std::sqrt(square_of_speed(0, swing_.zeta, b, g));  // (6)
  tell("b", b, metres, "distance of the centre of oscillation from the axis");
  tell("beyond_G", k * (k / a), metres, "how far it lies beyond G, kk/a");
  tell("speed", std::sqrt(std::max(0.0, square_of_speed(phi, swing_.zeta, b, g))), Unit{"rad/s"},
       "angular speed at Φ");
  tell("at_bottom", at_bottom, Unit{"rad/s"}, "angular speed in AB");
  tell("height_due", b * at_bottom * (b * at_bottom / (4 * g)), metres,
       "the height due to the speed of O in AB");
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
and $AB$ with {{at_bottom|4}}. Its centre of oscillation has then fallen {{height_due|4}} metres and has the
speed of a body that has fallen freely so far.

::: figure pendulum-06
alt: Closed curves about the origin, one inside the other, in a plane of angle and angular speed. The inner
ones are nearly ellipses; the outer ones grow pointed towards −180 and 180 degrees. The outermost runs into
these two points: it is the boundary.

Equation {{eq 5}} as a picture, for five amplitudes. The pendulum goes round each closed curve clockwise, once
in a period; the small ones are nearly ellipses of one shape. The grey curve, for 180°, is the separatrix: on
it the pendulum comes to the top and stays there, and beyond it, which is not in this paper, it goes round.
:::

::: figure pendulum-06-length
alt: The length b against a, both in units of k, the first axis logarithmic. The curve has its minimum, 2, at
a equal to k and rises on both sides. A level line at 2.5 cuts it at one half and at 2.

The length $b$ of one body hung at different distances $a$ from its centre of gravity. It is least, $2k$, for
$a = k$. Any greater length belongs to two distances, with the product $kk$ and the sum $b$: hung up by its
centre of oscillation, the pendulum swings as before.
:::

## Checks

The judge is the exact motion, whose speed comes from theta functions and not from {{eq 5}}.
*/

/// The square of the angular speed at Φ in the exact motion, in the unit 2g/b.
Fifty by_motion(const Fifty& at, const Fifty& zeta)
{
  const Fifty t = swing::oracle::time_from_bottom(at, exact::pi() - zeta);
  return pow(swing::oracle::Motion::from_zeta(zeta).velocity(t), 2);
}

CHECK_THAT("the square of the speed is that of the exact motion, in both forms")
{
  const double b = equivalent_length(0.5, 0.3);
  for(const double zeta : {1e-3, 60_deg, 120_deg, 170_deg})
    for(const double part : {0.0, 0.5, 0.9})
    {
      const double at = part * zeta;
      const Fifty truth = by_motion(at, zeta) * 2 * Fifty(4.9) / Fifty(b);
      CHECK(square_of_speed(at, zeta, b, 4.9) == within_ulps(truth, 6, "six operations, two sines"));
      CHECK(first_integral(at, constant(zeta, 0.5, 0.3, 4.9), 0.5, 0.3, 4.9)  // (3)
            == within(truth, 1e-14, "two numbers up to 29, each of six operations"));
    }
}

/*!
One proof serves for the $4g$ at all its places: at 30° the pendulum that swings to 60° has the speed that the
exact motion has there.
*/

const Doubtful four_g{
    "§6, the factor in (1), (2), (3) and (5)",
    {"2g", 2},
    {"4g", 4},
    "2 ∫ 2ga sin Φ dΦ is −4ga cos Φ; the section's last formula and the root in §7 have 4g",
    [](double factor) {
      return factor * cosine_difference(30_deg, 60_deg)
             == within_ulps(2 * by_motion(30_deg, 60_deg), 4, "two sines, three products");
    }};

/*!
Nor is {{eq 6}} a height; the sentence that says so is damaged in other ways too. The formula is the square of
an angular speed. The centre of oscillation $O$ moves $b$ times as fast, and the height due to its speed is
$b(1-\cos\zeta)$, exactly as high as it climbs: the sagitta of {{sec pendulum.10}}.
*/

const Doubtful height{"§6, the height due to the speed",
                      {"(4g/b)(1 − cos ζ)", 4 * 4.9 / 2.5 * (1 - std::cos(60_deg))},
                      {"b (1 − cos ζ)", 2.5 * (1 - std::cos(60_deg))},
                      "a body that falls from there has the speed of O in AB",
                      [](double reading) {
                        const Fifty v = 2.5 * sqrt(by_motion(0, 60_deg) * 2 * Fifty(4.9) / 2.5);  // b = 2.5
                        const Fifty seconds = v / (2 * Fifty(4.9));
                        return reading == within_ulps(4.9 * seconds * seconds, 4, "a cosine, two products");
                      }};

CHECK_THAT("b stands for the body, is the same for the distance kk/a, and never less than 2k, exactly")
{
  const Rational radius(5, 3);
  for(int i = 1; i <= 20; ++i)
  {
    const Rational here(i, 7), there = radius * radius / here, b = equivalent_length(here, radius);
    CHECK(here / (here * here + radius * radius) == 1 / b);
    CHECK(equivalent_length(there, radius) == b);
    CHECK(here + there == b);
    CHECK(b > 2 * radius);
  }
}

CHECK_THAT("neither b nor the difference of the cosines is lost to overflow or cancellation")
{
  CHECK(equivalent_length(1e200, 1.0) == 1e200);
  CHECK(equivalent_length(1e-300, 1.0) == within_ulps(1e300, 1, "one division"));
  CHECK(cosine_difference(5e-10, 1e-9)
        == within_ulps(cos(Fifty(5e-10)) - cos(Fifty(1e-9)), 3, "two sums, two sines, a product"));
  CHECK(std::cos(5e-10) - std::cos(1e-9) == 0);
}

/*!
What is told, by the energy as a fall: the centre of oscillation has come down by $b\cos\Phi - b\cos\zeta$.
*/

CHECK_THAT("the length and the speeds told are those of a fall of the centre of oscillation")
{
  for(const Told& now : told_at("", "zeta=170 phi=169 a=2 k=3 g=16", "zeta=1e-8 phi=1e-9 a=1e-50 k=1e-51",
                                "zeta=90 phi=0 k=0"))
  {
    const Fifty b = a.fifty() + k.fifty() * k.fifty() / a.fifty(), zeta = swing_.zeta.fifty();
    const auto speed_after = [&](const Fifty& fall) { return sqrt(4 * g.fifty() * fall) / b; };
    CHECK(now.value("b", metres) == within_relative(b, 6e-16, "a quotient, a product, a sum"));
    CHECK(now.value("beyond_G", metres)
          == within_relative(b - a.fifty(), 6e-16, "a quotient and a product"));
    const double near = 1e-15 + 4e-16 * swing_.zeta / (swing_.zeta - phi);
    CHECK(now.value("speed", Unit{"rad/s"})
          == within_relative(speed_after(b * (cos(phi.fifty()) - cos(zeta))), near,
                             "ζ − Φ of rounded angles"));
    CHECK(now.value("at_bottom", Unit{"rad/s"})
          == within_relative(speed_after(b * (1 - cos(zeta))), 2e-15, "few roundings"));
    CHECK(now.value("height_due", metres)
          == within_relative(b * (1 - cos(zeta)), 4e-15, "squares of that"));
  }
}

CHECK_THAT("the phase curves have the energy of their amplitudes, and the length is a + 1/a")
{
  for(const Told& now : told_at(""))
  {
    int curve = 0, i = 0;
    for(const auto& point : now.points("phase"))
    {
      const Fifty zeta =
          Fifty(std::array{30, 60, 90, 150, 180}.at(static_cast<std::size_t>(curve))) * exact::pi() / 180;
      const Fifty at = Fifty(point.at("phi")) * exact::pi() / 180, square = 2 * (cos(at) - cos(zeta));
      CHECK(point.at("rate") * point.at("rate") == within(square, 2e-15, "Φ in degrees rounds"));
      i = (i + 1) % 361;
      curve += i == 0 ? 1 : 0;
    }
    CHECK(curve == 5);
    CHECK(now.points("phase").at(90).value("rate")
          == within(-sqrt(2 * (1 - cos(exact::pi() / 6))), 1e-15, "clockwise"));
    CHECK(now.points("phase").at(270).value("rate")
          == within(sqrt(2 * (1 - cos(exact::pi() / 6))), 1e-15, "clockwise"));
    for(const auto& point : now.points("length", 6))
      CHECK(point.value("b")
            == within_relative(point.at("a") + 1 / Fifty(point.at("a")), 4e-16, "a quotient, a sum"));
  }
}

CHECK_THAT("an angle beyond the amplitude is refused, by however little, and the amplitude itself is not")
{
  for(const char* const within_it : {"zeta=30 phi=30", "zeta=150 phi=150"})
    CHECK(!refused_at(within_it));
  for(const char* const beyond :
      {"zeta=30 phi=30.0000000000000000000001", "zeta=150 phi=150.0000000000000000000001"})
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
At which part of its amplitude has a pendulum half of its greatest speed? Compare a very small swing, one
to 90° and one that nearly reaches the top.

answer: At $\frac12\sqrt3$ of it, 0.866, when the swing is small; at 75.52°, or 0.839 of it, for 90°; and
at 120°, two thirds, near the top.
:::
*/

CHECK_THAT("half of the greatest speed is had at √3/2, 0.839 and two thirds of the amplitude")
{
  for(const Told& now : told_at("zeta=0.001 phi=0.00086602540378443865", "zeta=90 phi=75.522487814070076",
                                "zeta=179.99999 phi=120"))
  {
    const Fifty b = a.fifty() + k.fifty() * k.fifty() / a.fifty();
    const Fifty greatest = sqrt(4 * g.fifty() * (1 - cos(swing_.zeta.fifty())) / b);
    CHECK(now.value("speed", Unit{"rad/s"})
          == within_relative(greatest / 2, 1e-10, "ζζ of the smallest, what the widest lacks of 180°"));
  }
}
