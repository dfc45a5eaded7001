#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 1, "Two corrections")

using swing::Amplitude;

/*!
## What Euler does

A real pendulum needs two corrections, one for its body and one for its arc, and Euler sets out to give both
for every pendulum. The elements of mechanics, he begins, treat chiefly of simple pendulums swinging through
infinitely small arcs, and take pains to determine the length of the one that beats seconds. But the pendulums
of the experimenters are not simple, and their swings, however slight, cannot pass for infinitely small. The
theory must be corrected twice.

The first correction is supplied by the centre of oscillation: for a given pendulum one seeks the simple
pendulum whose infinitely small swings take the same time. The second is for the greater arcs. Geometers have
determined it with all care, but it is not so widely known that anybody could apply it to the case in hand;
and it is usually confined to simple pendulums. So he thinks it useful to treat the matter in general, in such
a way that the corrections for pendulums composed in any manner, and for arcs of any amplitude, can be had
without labour. The resistance of the air and other hindrances he leaves aside, because the oscillations that
arise from them have been studied closely enough already.

The section has no formula, but what it promises can be put into one line with letters that come later: $a$,
the distance of the centre of gravity from the axis, and $k$, the radius of gyration ({{sec pendulum.03}});
$b = a + kk/a$ ({{sec pendulum.06}}); $g$, the height fallen in the first second ({{sec pendulum.05}});
$\Theta$, the time of an infinitely small swing ({{sec pendulum.10}}). Then

$$ T \;=\; \frac{\pi\sqrt a}{\sqrt{2g}} \;\times\; \sqrt{\frac ba} \;\times\; \frac T\Theta . \tag{A} $$

::: margin
Today: $T = \pi\sqrt{\ell/g}\cdot\frac2\pi K(\sin\frac12\zeta)$, with $g$ for Euler's $2g$ and $\ell$ for his
$b$. $T$ is one swing from side to side, half of today's period.
:::

The first factor is the time of the elements, the second corrects it for the body, the third for the arc. The
second does not depend on the arc, nor the third on the body: so the two can be found apart.

## The program

Each correction is computed as its excess over 1. Both may be very small, so neither is found by subtracting 1
from something near it: with $q = k/a$, the first, $\sqrt{1+qq}-1$, is $qq/(1+\sqrt{1+qq})$.
*/

double naive_time(double a, double g)  // (A), first factor
{
  return std::numbers::pi * (std::sqrt(a) / std::sqrt(2 * g));
}

double for_the_body(double a, double k)  // (A), second factor, less 1
{
  const double q = k / a;
  return q * (q / (1 + std::hypot(1, q)));
}

double time_of_swing(Amplitude to, double a, double k, double g)  // (A)
{
  return naive_time(a, g) * (1 + for_the_body(a, k)) * (1 + swing::ratio_excess(to));
}

/*!
The example is a uniform rod of one metre hung by its end, so that $a = \frac12$ and $kk = \frac1{12}$,
swinging 20° to each side.
*/

const auto swing_ = amplitude(20_deg, from_below(0_deg, 180_deg));
const auto a = real("a", 0.5, metres, scale, "distance AG of the centre of gravity from the axis");
const auto k = real("k", std::sqrt(1.0 / 12), metres, closed(0, 1e100), "radius of gyration about G");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second");

TELL
{
  const Amplitude zeta{swing_.zeta, swing_.eta};
  tell("naive", naive_time(a, g), seconds, "one swing of a point at G, its arc infinitely small");
  tell("body", for_the_body(a, k), percent, "the correction for the body, √(b/a) − 1");
  tell("arc", swing::ratio_excess(zeta), percent, "the correction for the arc, T/Θ − 1");
  tell("T", time_of_swing(zeta, a, k, g), seconds, "one swing of this body through this arc");
}

TELL
{
  curve("corrections", {"zeta", "body", "arc"}, [](Curve& c) {
    for(double zeta = 0; zeta <= 120; zeta += 0.5)
      c.put(
          {zeta, 100 * for_the_body(a, k), 100 * swing::ratio_excess(Amplitude::from_zeta(zeta * 1_deg))});
  });
}

/*!
By the elements a swing of the rod would take {{naive|4}} seconds; it takes {{T|4}}. Nearly all of the
difference is due to the body: {{body|4}}, against {{arc|3}} for the arc.

::: figure pendulum-01
alt: Two curves against the amplitude from 0 to 120 degrees. The correction for the body is a level line at
{{body|3}}. The correction for the arc starts at nothing, stays below one percent to 20 degrees, crosses the
level line near 84 degrees and reaches 37 percent at 120 degrees.

The two corrections for a rod hung by its end, in percent. That for the body is the same for all arcs; that
for the arc is the same for all bodies, and slight as long as the arc is moderate.
:::

## Checks

The equation of {{sec pendulum.05}} is integrated for three bodies, from rest at ζ through half of the time
{{eq A}}. The body must then stand at its lowest point. Neither $b$ nor $T/\Theta$ enters the integration.
*/

CHECK_THAT("with both corrections as factors, the time is that of the body's own motion")
{
  for(const double zeta : {1_deg, 20_deg, 90_deg, 150_deg})
    for(const double radius : {0.0, 0.3, 2.0})  // a point, nearly a rod, nearly all inertia
    {
      const auto motion = [&](const Fifty&, const exact::State& y) {
        return exact::State{y[1], -2 * Fifty(4.9) * 0.5 * sin(y[0]) / (0.25 + Fifty(radius) * radius)};
      };
      const Fifty half = Fifty(time_of_swing(Amplitude::from_zeta(zeta), 0.5, radius, 4.9)) / 2;
      CHECK(exact::solve(motion, 0, {Fifty(zeta), Fifty(0)}, half, Fifty("1e-18")).y[0]
            == within(0, 3e-15,
                      "½T is good to 3 ulp; in it the body could turn through 5.4 rad at full speed"));
    }
}

CHECK_THAT("neither correction loses its digits when it is too small to change 1")
{
  const Fifty zeta(1e-8), q(1e-9);
  CHECK(swing::ratio_excess(Amplitude::from_zeta(1e-8))
        == within_ulps(zeta * zeta / 16, 3, "a few operations; the next term is 10⁻¹⁶ of it"));
  CHECK(for_the_body(1, 1e-9) == within_ulps(q * q / 2, 2, "two roundings; the next term is 10⁻¹⁸ of it"));
}

/*!
The numbers told, for the rod and for two others, one of them hardly a body and hardly a swing:
*/

CHECK_THAT("the corrections told are those of the body's b and of the swing's own time, and the times "
           "their products")
{
  for(const Told& now : told_at("", "zeta=150 a=2 k=3", "zeta=1e-6 a=1 k=1e-7 g=16"))
  {
    const Fifty q = k.fifty() / a.fifty(), body = sqrt(1 + q * q) - 1,
                arc = swing::oracle::ratio_excess(swing_.zeta.fifty());
    const Fifty naive = exact::pi() * sqrt(a.fifty() / (2 * g.fifty()));
    CHECK(now.value("naive", seconds) == within_relative(naive, 6e-16, "two roots, a quotient, a product"));
    CHECK(now.value("body", percent) == within_relative(body, 1e-15, "no difference is taken"));
    CHECK(now.value("arc", percent) == within_relative(arc, 1e-15, "the library's bound"));
    CHECK(now.value("T", seconds)
          == within_relative(naive * (1 + body) * (1 + arc), 1e-15, "and two products"));
  }
}

CHECK_THAT("the figure's lines are the two corrections, in percent")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("corrections", 7))
    {
      const Fifty q = k.fifty() / a.fifty(), zeta = Fifty(point.at("zeta")) * exact::pi() / 180;
      CHECK(point.value("body") == within_relative(100 * (sqrt(1 + q * q) - 1), 1e-15, "few roundings"));
      const Fifty arc = 100 * (swing::oracle::ratio_from_bottom(zeta) - 1);
      CHECK(point.value("arc") == within_relative(arc, 2e-15, "ζ in radians rounds"));
    }
}

/*!
## Notes

"Any amplitude" means any *swing*: in this paper the pendulum turns back before the top or, at most, just
reaches it. One that goes round and round obeys the same equation, but Euler does not speak of it.

## Go on from here

::: exercise
At which amplitude is the correction for the arc as great as that for the body of the rod? Does the rod's
length matter, or the place on the earth?

answer: At 84.248°, near enough, for every uniform rod that hangs by its end: the one correction depends
on the amplitude alone, the other on $k/a$ alone, and $g$ is in neither. Try `--zeta 84.248 --a 1 --k
0.57735`.
:::
*/

CHECK_THAT("at 84.248° both corrections of a rod hung by its end are the same, whatever its length and g")
{
  for(const Told& now : told_at("zeta=84.248", "zeta=84.248 a=1 k=0.57735026918962576 g=1"))
  {
    const Fifty of_rod = 2 / sqrt(Fifty(3)) - 1;
    CHECK(now.value("body", percent) == within(of_rod, 1e-15, "k is rounded"));
    CHECK(now.value("arc", percent) == within(of_rod, 1e-6, "a thousandth of a degree is 4·10⁻⁶"));
  }
}
