#include "edition/section.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"
#include "tautochrone/cheeks.hpp"

SECTION(tautochrone, 1, "What the cycloid did not do for clocks")

using namespace tautochrone;

/*!
## What Euler does

The theory is right, and yet the clocks that were made after it do not go evenly. Huygens was the first to
set out how pendulums move, and mechanics owes to it some of its largest and most useful inventions. But
his way to make the motion of a clock uniform, by cycloids, has by now been found not quite to serve its
purpose in practice.

Euler looks for the cause. It is no fault of the theory, which rests on the firmest foundations; geometry,
from which it comes, is as certain as ever. It lies in this: the pendulums that regulate clocks differ
much from those of the theorem. No wonder, then, that practice does not answer to theory, and that some
inequality is left in the clocks, although in the theory the swings take perfectly equal times.

::: margin
$T/T_0 = \frac2\pi K(\sin\tfrac12\varphi_0)$. A *swing* is half the modern period.
:::

He gives no numbers. How large is the inequality that the cycloid was to take away? A pendulum on a fixed
axis swings in a circle, and $T$, the time of a swing out to the angle $\varphi_0$ on either side, is
longer than $T_0$, that of an infinitely small one, by

$$ \frac{T}{T_0} - 1 = \frac{\varphi_0^2}{16} + \frac{11\,\varphi_0^4}{3072} + \dots, \tag{A} $$

as follows from {{eq pendulum.11 1}}. A clock that is set by small swings and makes wide ones loses this
part of a day.

## The program

To subtract 1 from the ratio of the times loses as many digits as the excess has zeros. The program never
forms the ratio: {{api tautochrone::excess}} averages what each place of the swing contributes, and all
that it averages is positive.
*/

const auto phi0 = angle("phi0", 5_deg, open(0_deg, 180_deg), "how far the pendulum swings to either side");
const auto counted = real("counted", 86'400, seconds, scale, "time that the clock has counted");

double two_terms(double phi)  // (A)
{
  const double pp = phi * phi;
  return pp / 16 + 11 * pp * pp / 3072;
}

TELL
{
  const double over = excess(Cheeks::none, 0, phi0);
  tell("excess", over, "T/T₀ − 1 in a circle");
  tell("late", counted * over, seconds, "what the clock is late when it has counted so long");
  tell("narrow", 86'400 * excess(Cheeks::none, 0, 2.5_deg), seconds,
       "in a day, by swings of 2½° to either side");
  tell("wide", 86'400 * excess(Cheeks::none, 0, 30_deg), seconds, "in a day, by swings of 30°");
  tell("spread", 86'400 * (excess(Cheeks::none, 0, 5.5_deg) - excess(Cheeks::none, 0, 4.5_deg)), seconds,
       "in a day, when swings of 5½° replace swings of 4½°");
  tell("two_terms", two_terms(phi0), "two terms of (A)");
}

TELL
{
  curve("losses", {"phi0", "late", "law"}, [](Curve& out) {
    for(double degrees_ = 0.1; degrees_ < 120; degrees_ *= 1.1)
    {
      const double angle_ = degrees_ * 1_deg;
      out.put({degrees_, 86'400 * excess(Cheeks::none, 0, angle_), 86'400 * angle_ * angle_ / 16});
    }
  });
}

/*!
With swings of 5° such a clock is late by {{late|4}} s a day, with swings of 30° by {{wide|4}} s. A clock
might be set by the swings that it makes; but where these do not stay the same, a single degree, 5½°
instead of 4½°, is worth {{spread|3}} s a day. A circle is tolerable only where the swings are narrow;
that is what the cheeks were to make needless.

::: figure tautochrone-01
alt: Seconds a day lost on a circle against the amplitude, both logarithmic: a straight line with the
slope two from 0.02 seconds at a tenth of a degree through 41 seconds at 5 degrees, a little above the
line of the law at the right end.

What a pendulum that swings in a circle loses in a day against its own smallest swings. The thin line is the
first term of {{eq A}}.
:::

## Speed against error

The same number by the ratio of the times, from which 1 is taken, and by two terms of {{eq A}}. Try
`--phi0 0.001 --bench`.
*/

Fifty exactly(const Fifty& phi)  // the three first terms where a difference has no digits left
{
  const Fifty pp = phi * phi;
  if(phi < 1e-9)
    return pp / 16 + 11 * pp * pp / 3072 + 173 * pp * pp * pp / 737'280;
  return swing::oracle::ratio_from_top(exact::pi() - phi) - 1;
}

TELL
{
  const double phi = phi0;
  race("excess", "T/T₀ − 1", exactly(phi0.fifty()),
       {{"averaged", [=] { return excess(Cheeks::none, 0, phi); }},
        {"ratio of the times less 1", [=] { return swing::ratio_from_bottom(phi) - 1; }},
        {"two terms of (A)", [=] { return two_terms(phi); }}});
}

/*!
## Checks
*/

CHECK_THAT("the excess told is the exact swing's, at any amplitude")
{
  for(const Told& now :
      told_at("", "phi0=1e-6 counted=3600", "phi0=60", "phi0=1e-60 counted=1e90", "phi0=179.9"))
  {
    const Fifty exact = exactly(phi0.fifty());
    CHECK(now.value("excess")
          == within_relative(exact, 1e-12, "the library's bound, and the angle's near the top"));
    CHECK(now.value("late", seconds) == within_relative(counted.fifty() * exact, 1e-12, "a product more"));
    CHECK(now.exact("excess") == within_relative(exact, 1e-30, "the same oracle"));
    CHECK(now.method("excess", "averaged") == within_relative(exact, 1e-12, "the same"));
    CHECK(now.method("excess", "ratio of the times less 1")
          == within(exact, 3e-16 + 3e-13 * double(exact),
                    "two ulps of the ratio, and the angle's near the top"));
  }
}

CHECK_THAT(
    "the same excess by the series of all odd and even numbers, that for tiny swings by its three terms")
{
  for(const double phi : {1e-5, 0.1, 1.0, 2.0})
  {
    const Fifty cc = pow(sin(Fifty(phi) / 2), 2);
    Fifty sum = 0, term = 1;
    for(int n = 1; n < 1000; ++n)
    {
      term *= cc * (2 * n - 1) * (2 * n - 1) / (4 * n * n);
      sum += term;
    }
    CHECK(excess(Cheeks::none, 0, phi) == within_relative(sum, 1e-13, "the library's bound"));
  }
  CHECK(exactly(Fifty("9.99e-10"))
        == within_relative(exactly(Fifty("1.001e-9")) * pow(Fifty("9.99") / Fifty("10.01"), 2), 1e-19,
                           "it goes with the square on both sides of the seam"));
}

CHECK_THAT("two terms fall short by the third and those after it, whatever the amplitude")
{
  for(const Told& now : told_at("", "phi0=1e-6", "phi0=60", "phi0=120"))
  {
    const Fifty phi = phi0.fifty(), exact = exactly(phi), third = 173 * pow(phi, 6) / 737'280;
    for(const auto& two : {now.value("two_terms"), now.method("excess", "two terms of (A)")})
      CHECK(two
            == between(exact - 2.5 * third - 1e-15 * exact, exact - third + 1e-15 * exact,
                       "all terms are positive"));
  }
}

CHECK_THAT("what is told of other swings is theirs, and does not depend on this one")
{
  for(const Told& now : told_at("", "phi0=1e-6", "phi0=60 counted=1"))
  {
    const auto late = [](const Fifty& degrees_) { return 86'400 * exactly(degrees_ * exact::pi() / 180); };
    CHECK(now.value("narrow", seconds) == within_relative(late(2.5), 1e-13, "the library's bound"));
    CHECK(now.value("wide", seconds) == within_relative(late(30), 1e-13, "the library's bound"));
    CHECK(now.value("spread", seconds)
          == within_relative(late(5.5) - late(4.5), 1e-12, "a difference of two"));
  }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("losses", 7))
    {
      const Fifty phi = Fifty(point.at("phi0")) * exact::pi() / 180;
      CHECK(point.value("late") == within_relative(86'400 * exactly(phi), 1e-13, "the library's bound"));
      CHECK(point.value("law") == within_relative(86'400 * phi * phi / 16, 1e-15, "four roundings"));
    }
}

/*!
## Go on from here

::: exercise
A clock is to be late by no more than a second a day on its circle. How wide may it swing?

answer: By {{eq A}} to $\varphi_0 = 4/\sqrt{86400}$ of a radian, nearly 0.78°: `--phi0 0.779` tells a
little less than one second.
:::
*/

CHECK_THAT("swings of 0.779° lose a little less than a second in a day")
{
  CHECK(86'400 * excess(Cheeks::none, 0, 0.779_deg) == between(0.99, 1, "the exercise"));
}
