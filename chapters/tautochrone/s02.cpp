#include "edition/section.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/path.hpp"
#include "tautochrone/scene.hpp"
#include "tautochrone/scene_judge.hpp"
#include "tautochrone/swing.hpp"

SECTION(tautochrone, 2, "What Huygens proved, and of what pendulum")

using namespace tautochrone;

/*!
## What Euler does

Huygens proved that all swings in a cycloid take the same time, but of a pendulum that no clock has. If a
pendulum is so hung that it moves in a common cycloid with a horizontal base, its swings are completed in
equal times, whether they are wide or narrow. The theorem is quite true; but one has to mark well under
what conditions, lest more be credited to it than its proof can bear. There are two.

First, the motion must go on in a medium that does not resist: in a space empty of all matter.

Secondly, the pendulum must be simple. All its mass has to be collected as it were in a single point. That
is achieved accurately enough when a very small and very heavy ball hangs from a thread so thin and so
light that its weight vanishes against the weight of the ball.

::: margin
Today $\pi\sqrt{a/g}$, the $g$ of today being twice Euler's.
:::

He writes no formula here. In the letters that he will use from {{sec tautochrone.12}} on, with $a$ for the
length of the thread, the bob at the angle $\varphi$ with the vertical is led along a curve whose radius of
curvature, arc and height are

$$ \begin{gathered} r = a\cos\varphi, \quad z = a\sin\varphi, \\
  x = \tfrac12 a\sin^2\varphi, \end{gathered} \tag{A} $$

so that $zz = 2ax$; and the time of a swing from side to side, $g$ being the height fallen from rest in the
first second, is

$$ T = \frac{\pi\sqrt{2a}}{\sqrt{4g}} \tag{B} $$

seconds, whatever $\varphi_0$ is. The cheeks between which the thread must hang are the cycloid's evolute, a
cycloid again.

## The program

The program does not use {{eq B}}. It sums the time along the curve, as {{sec tautochrone.19}} will teach,
by {{api tautochrone::Path}}: for a bob without extension every element of the arc is divided by the
square root of the height fallen.
*/

const auto a = real("a", 0.994, metres, scale, "length of the thread, down to the bob");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");
const auto phi0 =
    angle("phi0", 60_deg, closed(1e-90_deg, 89.9_deg), "how far the thread swings to either side");

Path cycloid()
{
  return {exact::Laurent<double>(1.0, 1), 0};  // (A)
}

double in_seconds(double time)  // from Euler's clock, a = 1
{
  return time * (std::sqrt(a) / (2 * std::sqrt(g)));
}

TELL
{
  tell("T", in_seconds(cycloid().swing_time(phi0)), seconds, "one swing, summed along the cycloid");
  tell("T_small", in_seconds(small_swing(0)), seconds, "an infinitely small swing, (B)");
  tell("T_circle", in_seconds(swing_time(Cheeks::none, 0, phi0)), seconds,
       "one swing of the bob on a fixed axis");
  tell("x", euler_x<double>(a, 0, phi0), metres, "how high the bob rises");
  tell("z", euler_z<double>(a, 0, phi0), metres, "the arc that it describes on either side");
}

TELL
{
  auto& rows = table("swings", "Swings of the same bob, in seconds",
                     {{"phi0", "amplitude", degrees, 3},
                      {"cycloid", "cycloid", seconds, 14},
                      {"circle", "circle", seconds, 8}});
  for(const double phi : {0.01_deg, 1_deg, 10_deg, 30_deg, 60_deg, 85_deg, 89.9_deg})
    rows.row({phi, in_seconds(cycloid().swing_time(phi)), in_seconds(swing_time(Cheeks::none, 0, phi))});
}

TELL
{
  curve("cheek", {"q", "p", "y", "x"}, [](Curve& out) {
    for(int i = -90; i <= 90; ++i)
    {
      const double phi = i * 0.999 * 1_deg;
      out.put({euler_q<double>(1, 0, phi), euler_p<double>(1, 0, phi), euler_y<double>(1, 0, phi),
               euler_x<double>(1, 0, phi)});
    }
  });
}

TELL
{
  scene_between_cheeks("swing", Cheeks::cycloids, 0, phi0, in_seconds(1));
}

/*!
All swings of the table take {{T|12}} s, narrow and wide alike; in a circle they do not.

{{table swings}}

::: figure tautochrone-02
alt: Two half cycloids hang from a common cusp at the top, like an open pair of curtains. Between them a
thread in five positions, lying on the cheek above and straight below; the five bobs lie on a larger
cycloid, open upwards.

The cheeks, the thread in five positions, and the cycloid of the bob. Where the thread leaves the cheek it
touches it; there is the centre about which the bob turns.
:::

::: scene swing
alt: Two half cycloids meet in a cusp at the top. A thread leaves the right one, straight, down to a bob on a
larger cycloid, open upwards.

The same in its true time, one swing to and fro: only the free part of the thread is drawn in blue, what lies
on the cheek is hidden by it. However far the bob is let go, it is back after $2T$.
:::

## Checks
*/

CHECK_THAT("all swings take the time π√(2a)/√(4g), from the narrowest to nearly the whole cycloid")
{
  for(const Told& now : told_at("", "phi0=1e-80", "phi0=89.9 a=3e50", "a=1e-90 g=1e90 phi0=85"))
  {
    const Fifty T = exact::pi() * sqrt(2 * a.fifty()) / sqrt(4 * g.fifty());
    CHECK(now.value("T", seconds) == within_relative(T, 1e-15, "two ulps of the sum, three roundings"));
    CHECK(now.value("T_small", seconds) == within_relative(T, 1e-15, "the same"));
    for(const auto& row : now.rows("swings"))
      CHECK(row.value("cycloid", seconds) == within_relative(T, 1e-15, "the same"));
  }
}

CHECK_THAT("the scene shows the bob where its equation of motion takes it, on a thread of the length a")
{
  for(const Told& now : told_at("", "phi0=89.9 a=2", "phi0=20 g=1"))
    for(const Judged_frame& frame :
        judged(now.points("swing", 9), Cheeks::cycloids, 0, phi0.fifty(), sqrt(a.fifty() / g.fifty()) / 2))
    {
      CHECK(frame.told.value("t") == within_relative(frame.t, 1e-14, "the clock's bound"));
      for(const auto& [column, right] : frame.right)
        CHECK(frame.told.value(column.c_str()) == within(right, frame.slack, Judged_frame::because));
    }
}

/*!
That is the theorem; the next checks do not presuppose it. The bob's equation of motion is followed, from
rest, for half the time told: it must be in the lowest place then.
*/

Fifty arc_after_half(const Fifty& T, const Fifty& z0)  // z" = −½ dx/dz = −z/2, by its power series, a = 1
{
  Fifty sum = 0, term = z0;
  for(int n = 1; n < 60; ++n)
  {
    sum += term;
    term *= -T * T / 8 / ((2 * n - 1) * (2 * n));
  }
  return sum;
}

CHECK_THAT("the equation of motion brings the bob to the lowest place after half the time, from any height")
{
  for(const double phi : {1e-9, 0.5, 1.5})
  {
    const Fifty z0 = sin(Fifty(phi));
    CHECK(arc_after_half(cycloid().swing_time(phi), z0)
          == within(0, 1e-15 * double(z0), "two ulps of the time, at the greatest speed"));
  }
}

CHECK_THAT("height, arc and the times on the circle are told rightly")
{
  for(const Told& now : told_at("", "phi0=1e-80", "phi0=89.9 a=3e50", "a=2 g=1 phi0=45"))
  {
    const Fifty s = sin(phi0.fifty()), T = exact::pi() * sqrt(a.fifty() / (2 * g.fifty()));
    CHECK(now.value("x", metres) == within_relative(a.fifty() * s * s / 2, 1e-15, "a square"));
    CHECK(now.value("z", metres) == within_relative(a.fifty() * s, 1e-15, "a product"));
    CHECK(now.value("T_circle", seconds)
          == within_relative(T * (1 + circle_excess(phi0.fifty())), 2e-15, "three ulps and a product"));
    for(const auto& row : now.rows("swings"))
      CHECK(row.value("circle", seconds)
            == within_relative(T * (1 + circle_excess(row.at("phi0", degrees))), 2e-15, "the same"));
  }
}

CHECK_THAT("the thread of the figure has everywhere the length a, and touches the cheek that it leaves")
{
  for(const Told& now : told_at(""))
  {
    const auto all = now.points("cheek");
    for(const std::size_t i : {std::size_t(1), std::size_t(50), std::size_t(120), std::size_t(179)})
    {
      const Fifty phi = (int(i) - 90) * Fifty(0.999) * exact::pi() / 180;
      const Fifty q = (phi - sin(phi) * cos(phi)) / 2, p = pow(sin(phi), 2) / 2;
      CHECK(all[i].value("q") == within(q, 1e-15, "the cheek is a cycloid"));
      CHECK(all[i].value("p") == within(p, 1e-15, "the cheek is a cycloid"));
      CHECK(all[i].value("y") == within(q + cos(phi) * sin(phi), 1e-15, "a free part of the length cos φ"));
      CHECK(all[i].value("x")
            == within(1 - p - cos(phi) * cos(phi), 1e-15, "the same, from the lowest place"));
    }
  }
}

/*!
## Go on from here

::: exercise
By how much longer must the thread of {{a}} m be, if the clock is to lose a second in a day? Compare it with
what a circle costs ({{sec tautochrone.01}}).

answer: The time goes as $\sqrt a$, so by two parts in 86400, 0.023 mm: `--a 0.994023`. On a circle swings of
0.78° cost as much; so a maker whose rod grows by more than that with the weather has a greater trouble than
the circle.
:::
*/

CHECK_THAT("a thread longer by 0.023 mm loses a second in a day, whatever the swing")
{
  const Fifty T = exact::pi() * sqrt(Fifty("0.994") / (2 * Fifty("4.903325")));
  for(const Told& now : told_at("a=0.994023", "a=0.994023 phi0=10"))
    CHECK(now.value("T", seconds)
          == within_relative(T * (1 + Fifty(1) / 86'400), 2e-8, "two digits of 0.023"));
}
