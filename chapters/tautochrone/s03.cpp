#include "edition/section.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

SECTION(tautochrone, 3, "A body on Huygens's cheeks")

using namespace tautochrone;

/*!
## What Euler does

Where either of the two conditions fails, swings in a cycloid do not take equal times, and in a clock both
fail. Unless the resistance of the medium is nothing, and unless the mass of the pendulum itself is as it
were infinitely small in extent, as the theory assumes, the swings will not be isochronous even though
they are performed in a cycloid. Now in a clock one can neither take away the resistance of the air nor
use pendulums that might pass for simple ones. So for a double cause it is plain enough that this property
of the cycloid, proved only for simple pendulums in empty space, has no longer a place there.

Experience too seems to have shown the defect clearly enough: the makers of clocks have by now almost
entirely given up the cycloid.

::: margin
$Mkk$ is the moment of inertia about the centre of gravity, $M$ the mass. For a ball of the radius $R$,
$kk = \frac25RR$.
:::

Of the two causes Euler will take up the second. Its size, which he does not give, follows from what he
finds later. Let $k$ be the radius of gyration of the body about its centre of gravity, and $a$ the
distance of that centre from the suspension. Between cycloidal cheeks a narrow swing out to the angle
$\varphi_0$ lasts longer than an infinitely small one by

$$ \frac{T}{T_0} - 1 = \frac{kk}{aa+kk}\cdot\frac{\varphi_0^2}{4} \text{ nearly}, \tag{A} $$

while on a fixed axis it is $\frac1{16}\varphi_0^2$. The cheeks leave of the circle's fault the part

$$ \frac{4kk}{aa+kk}. \tag{B} $$

## The program

The exact excess is an integral over the swing, whose integrand vanishes with $k$; nothing is subtracted
from anything ({{api tautochrone::excess}}).
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, closed(0.0, 1e100), "radius of gyration");
const auto phi0 = angle("phi0", 5_deg, open(0_deg, 90_deg), "how far the pendulum swings to either side");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

double kk_part()  // kk/(aa + kk)
{
  const double ratio = k / a, inverse = a / k;
  return ratio < 1 ? ratio * ratio / (1 + ratio * ratio) : 1 / (1 + inverse * inverse);
}

double law(double phi)  // (A)
{
  return kk_part() * phi * phi / 4;
}

TELL
{
  require(k / a <= 1e20, "k", "at most 1e20 a");
  const double over = excess(Cheeks::cycloids, k / a, phi0), circle = excess(Cheeks::none, k / a, phi0);
  tell("T", swing_time(Cheeks::cycloids, k / a, phi0) * (std::sqrt(a) / (2 * std::sqrt(g))), seconds,
       "one swing between the cheeks");
  tell("excess", over, "T/T₀ − 1 between them");
  tell("late", 86'400 * over, seconds, "what the clock loses in a day");
  tell("late_circle", 86'400 * circle, seconds, "the same on a fixed axis");
  tell("law", law(phi0), "(A)");
  tell("left", 4 * kk_part(), percent, "(B), the part of the circle's fault that is left to narrow swings");
}

TELL
{
  auto& rows = table("bodies", "Seconds a day late between cycloidal cheeks",
                     {{"k", "k/a", none, 3},
                      {"at_5", "5°", seconds, 6},
                      {"at_10", "10°", seconds, 6},
                      {"at_30", "30°", seconds, 6}});
  for(const double ratio : {0.0, 0.02, 0.05, 0.1, 0.2, 0.3})
  {
    const auto late = [=](double phi) { return 86'400 * excess(Cheeks::cycloids, ratio, phi); };
    rows.row({ratio, late(5_deg), late(10_deg), late(30_deg)});
  }
}

TELL
{
  curve("losses", {"phi0", "circle", "k30", "k10", "k02"}, [](Curve& out) {
    for(double degrees_ = 1; degrees_ < 89; degrees_ *= 1.05)
    {
      const double phi = degrees_ * 1_deg;
      const auto late = [=](double ratio) { return 86'400 * excess(Cheeks::cycloids, ratio, phi); };
      out.put({degrees_, 86'400 * excess(Cheeks::none, 0, phi), late(0.3), late(0.1), late(0.02)});
    }
  });
}

/*!
A body with $k = \tfrac1{10}a$ that swings 5° loses {{late_circle|4}} s in a day on a fixed axis, and
{{late|3}} s between Huygens's cheeks: {{left|2}} of the fault is left. So the extension of the body is a
cause, and one that can be calculated; but the cheeks are still much better than none. Whether it was this
that made the makers give them up, the numbers do not say.

{{table bodies}}

::: figure tautochrone-03
alt: Seconds a day lost against the amplitude, both logarithmic, four nearly parallel lines: the circle
uppermost, then between cycloidal cheeks bodies with k three tenths of a, at a third of it, and with a tenth
and a fiftieth of a, about one and about three decades lower.

What the clock loses on a fixed axis, and between Huygens's cheeks with bodies of three sizes. A heavy
point would lose nothing.
:::

## Checks

Fifty digits come by another way: there the integral of {{sec tautochrone.19}} itself is taken by
quadrature, and $T_0$ subtracted.
*/

Fifty by_quadrature(const Fifty& ratio, const Fifty& phi)
{
  return excess(truncated(0, ratio), ratio, phi);
}

CHECK_THAT("the excess told is the quadrature's, for any body and amplitude")
{
  for(const Told& now : told_at("", "k=0.3 phi0=60 a=1.5", "a=1e-80 k=3e-82 phi0=85", "k=1e19 phi0=80"))
  {
    const Fifty over = by_quadrature(k.fifty() / a.fifty(), phi0.fifty());
    CHECK(now.value("excess") == within_relative(over, 1e-12, "the library's bound, and the angle's"));
    CHECK(now.value("late", seconds) == within_relative(86'400 * over, 1e-12, "a product"));
    const Fifty T = exact::pi() * sqrt((a.fifty() + k.fifty() / a.fifty() * k.fifty()) / (2 * g.fifty()));
    CHECK(now.value("T", seconds)
          == within_relative(T * (1 + over), 2e-15, "three ulps and three roundings"));
  }
}

CHECK_THAT("narrow swings obey the law (A), however narrow they are, and (B) is the part of the circle's")
{
  for(const Told& now : told_at("", "phi0=1e-7 k=0.3", "phi0=1e-40 k=5 a=2", "phi0=1e-9 k=1e-60"))
  {
    const Fifty kappa = pow(k.fifty() / a.fifty(), 2), pp = pow(phi0.fifty(), 2),
                part = kappa / (1 + kappa);
    CHECK(now.value("law") == within_relative(part * pp / 4, 2e-15, "seven roundings"));
    CHECK(now.value("excess")
          == within_relative(part * pp / 4, 1e-13 + 2 * double(pp),
                             "the next term, and the library's bound"));
    CHECK(now.value("late_circle", seconds)
          == within_relative(5400 * pp, 1e-13 + double(pp), "the first term, 86400/16, and the next"));
    CHECK(now.value("left", percent) == within_relative(4 * part, 2e-15, "four roundings"));
  }
}

CHECK_THAT("a circle's loss at 5° is the series' of the odd and even numbers")
{
  for(const Told& now : told_at("", "phi0=60 k=0", "phi0=1"))
  {
    const Fifty cc = pow(sin(phi0.fifty() / 2), 2);
    Fifty sum = 0, term = 1;
    for(int n = 1; n < 200; ++n)
    {
      term *= cc * (2 * n - 1) * (2 * n - 1) / (4 * n * n);
      sum += term;
    }
    CHECK(now.value("late_circle", seconds) == within_relative(86'400 * sum, 1e-13, "the library's bound"));
  }
}

CHECK_THAT("the table and the figure's curves are the quadrature's; a heavy point loses nothing")
{
  for(const Told& now : told_at(""))
  {
    for(const auto& row : now.rows("bodies"))
      for(const auto& [name, degrees_] : {std::pair{"at_5", 5}, {"at_10", 10}, {"at_30", 30}})
      {
        const Fifty ratio = Fifty(row.at("k")), phi = degrees_ * exact::pi() / 180;
        if(ratio == 0)
          CHECK(row.value(name, seconds) == 0);
        else
          CHECK(row.value(name, seconds)
                == within_relative(86'400 * by_quadrature(ratio, phi), 1e-12, "the library's bound"));
      }
    for(const auto& point : now.points("losses", 4))
    {
      const Fifty phi = Fifty(point.at("phi0")) * exact::pi() / 180;
      for(const auto& [name, ratio] : {std::pair{"k30", 0.3}, {"k10", 0.1}, {"k02", 0.02}})
        CHECK(point.value(name)
              == within_relative(86'400 * by_quadrature(ratio, phi), 1e-12, "the library's bound"));
      CHECK(point.value("circle")
            == within_relative(86'400 * excess(exact::Laurent<Fifty>(1), 0, phi), 1e-12,
                               "the library's bound"));
    }
  }
}

CHECK_THAT("a body with k beyond 10²⁰ a is refused, and one with just that k is not")
{
  for(const char* const within_them : {"k=1e20", "a=2 k=2e20"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"k=1.0000000000000002e20", "a=2 k=2.0000000000000004e20"})
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
How small must a ball on a thread of the length $a$ be, to lose no more than a tenth of a second in a day
between Huygens's cheeks, with swings of 5°?

answer: {{eq A}} with $kk = \tfrac25RR$ gives $R = 0.039\,a$, a ball of 4 cm on a pendulum of a second:
`--k 0.02466` tells a tenth of a second. The loss goes as $RR$; a ball of half the size loses a quarter.
:::
*/

CHECK_THAT("k = 0.02466 a, a ball with the radius 0.039 a, loses a tenth of a second at 5°")
{
  for(const Told& now : told_at("k=0.02466"))
  {
    CHECK(now.value("late", seconds) == within(0.1, 5e-4, "the exercise"));
    CHECK(k / std::sqrt(0.4) == within(0.039, 5e-4, "two digits"));
  }
}
