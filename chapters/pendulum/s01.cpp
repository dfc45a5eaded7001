#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "pendulum/equation.hpp"
#include "pendulum/series.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 1, "Two corrections")

using pendulum::equivalent_length, pendulum::ratio_by_mean;
using swing::Amplitude;

/*!
## What Euler does

Every real pendulum wants two corrections, one for its body and one for its arc, and he will give both for all
of them. The elements of mechanics, he begins, teach the pendulum in a doubly simple case: the body is a point
on a thread, and it swings through arcs that are infinitely small. What they are at pains to determine is the
length of such a pendulum that beats seconds. But the pendulums with which experiments are made are not
simple, and their swings, be they as small as they may, cannot pass for infinitely small. So the theory wants
two corrections.

The first is for the body, and the centre of oscillation supplies it: for any pendulum whatever one finds the
length of the simple pendulum whose infinitely small swings take the same time. The second is for the arc. It
has been settled by the geometers with all diligence, but it has not become so generally known that anybody
could apply it to the case in hand; moreover it is usually given for simple pendulums only. It will therefore
be useful to treat the matter once in full generality, so that the corrections for a body composed in any way,
and for any amplitude of the arcs, can be had from it without labour. The resistance of the air and other
hindrances are left aside: the oscillations that come of them have, he says, been examined closely enough.

That is the whole section; it has no formula. But its programme can be put into one line, with the letters of
later sections: $a$ is the distance of the centre of gravity from the axis and $k$ the radius of gyration
({{sec pendulum.03}}), $b = a + kk/a$ ({{sec pendulum.06}}), $g$ the height fallen in the first second
({{sec pendulum.05}}), and $\Theta$ the time of a swing through an infinitely small arc ({{sec pendulum.10}}).
Then

$$ T \;=\; \frac{\pi\sqrt a}{\sqrt{2g}} \;\times\; \sqrt{\frac ba} \;\times\; \frac T\Theta . \tag{1} $$

::: margin
Today: $T = \pi\sqrt{\ell/g}\cdot\frac2\pi K(\sin\frac12\zeta)$, with Euler's $2g$ for $g$ and $b$ for $\ell$.
$T$ is one swing from side to side, half of today's period.
:::

The first factor is the time of the elements, the second the correction for the body, the third the correction
for the arc. That they are *factors*, that the third knows nothing of the body and the second nothing of the
arc, is what makes Euler's plan possible.

## The program

Each correction is told as what it adds to 1. Both may be very small, and neither is found by subtracting 1
from something near it: $\sqrt{1+qq}-1$, with $q = k/a$, is $qq/(1+\sqrt{1+qq})$.
*/

double naive_time(double a, double g)  // (1), first factor
{
  return std::numbers::pi * std::sqrt(a) / std::sqrt(2 * g);
}

double for_the_body(double a, double k)  // (1), second factor, less 1
{
  const double q = k / a;
  return q * (q / (1 + std::hypot(1, q)));
}

double for_the_arc(swing::Amplitude amplitude)  // (1), third factor, less 1
{
  return swing::ratio_excess(amplitude);
}

/*!
The wider the arc, the greater the third factor; so for every body there is one amplitude at which both
corrections are equal.
*/

double equal_at(double a, double k)
{
  double narrow = 0, wide = std::numbers::pi;
  for(double middle = wide / 2; middle != narrow && middle != wide; middle = (narrow + wide) / 2)
    (for_the_arc(Amplitude::from_zeta(middle)) < for_the_body(a, k) ? narrow : wide) = middle;
  return narrow;
}

/*!
The example is as plain as can be: a uniform rod of one metre hung by its end, so that $a = \frac12$ and
$kk = \frac1{12}$, swinging 20° to each side.
*/

const auto swing_ = amplitude(20_deg, from_below(0_deg, 180_deg));
const auto a = real("a", 0.5, metres, positive, "distance AG of the centre of gravity from the axis");
const auto k = real("k", 0.28867513459481287, metres, nonnegative, "radius of gyration about G");
const auto g = real("g", 4.903325, metres, positive, "height fallen in the first second");

TELL
{
  const double body = for_the_body(a, k);
  const double arc = for_the_arc({swing_.zeta, swing_.eta});
  const double T = naive_time(a, g) * (1 + body) * (1 + arc);
  tell("naive", naive_time(a, g), seconds, "one swing of a point at G, through an infinitely small arc");
  tell("body", body, percent, "the correction for the body, √(b/a) − 1");
  tell("b", equivalent_length<double>(a, k), metres, "length of the simple pendulum that swings alike");
  tell("Theta", naive_time(a, g) * (1 + body), seconds, "one swing of this body, its arc infinitely small");
  tell("arc", arc, percent, "the correction for the arc, T/Θ − 1");
  tell("T", T, seconds, "one swing of this body through this arc, T");
  tell("naive_in_a_day", 86400 / naive_time(a, g), "swings in a day by the elements");
  tell("in_a_day", 86400 / T, "and with both corrections");
  tell("equal_at", equal_at(a, k), degrees, "the amplitude at which both corrections are equal");
}

TELL
{
  curve("corrections", {"zeta", "body", "arc"}, [](Curve& c) {
    for(double zeta = 0; zeta <= 120; zeta += 0.5)
      c.put({zeta, 100 * for_the_body(a, k), 100 * for_the_arc(Amplitude::from_zeta(zeta * 1_deg))});
  });
}

/*!
By the elements the rod would make {{naive_in_a_day|f0}} swings in a day; it makes {{in_a_day|f0}}. Nearly all
of the difference is the body's: {{body|4}}, against {{arc|3}} for the arc of 20°. Only from {{equal_at|deg1}}
on is the arc the greater culprit.

::: figure pendulum-01
alt: Two curves against the amplitude from 0 to 120 degrees. The correction for the body is a level line at
15.5 percent. The correction for the arc starts at nothing, stays below one percent to 20 degrees, crosses the
level line near 84 degrees and reaches 37 percent at 120 degrees.

The two corrections for a rod hung by its end, in percent of the uncorrected time. The one for the body is the
same for all arcs. The one for the arc is the same for all bodies; it is slight for long, which is why the
elements could do without it, and then it is not.
:::

## Checks

Whether the corrections are factors is for the motion itself to say. The equation of {{sec pendulum.05}} is
integrated in many digits for three bodies, from rest at ζ for half of the time {{eq 1}}: each must stand at
its lowest point then. Nothing of {{eq 1}} enters that integration, neither $b$ nor $T/\Theta$.
*/

/// Where the body is half a swing after it was let go at zeta.
Fifty after_half_a_swing(double zeta, double a, double k, double g)
{
  const double arc = for_the_arc(Amplitude::from_zeta(zeta));
  const double T = naive_time(a, g) * (1 + for_the_body(a, k)) * (1 + arc);
  const Fifty torque = 2 * Fifty(g) * Fifty(a);
  const Fifty inertia = Fifty(a) * Fifty(a) + Fifty(k) * Fifty(k);
  const auto motion = [&](const Fifty&, const exact::State& y) {
    return exact::State{y[1], -torque * sin(y[0]) / inertia};
  };
  return exact::solve(motion, 0, {Fifty(zeta), Fifty(0)}, Fifty(T) / 2, Fifty("1e-18")).y[0];
}

CHECK_THAT("with both corrections as factors, the time is that of the body's own motion")
{
  for(const double zeta : {1_deg, 20_deg, 90_deg, 150_deg})
    for(const double radius : {0.0, 0.28867513459481287, 2.0})  // a point, the rod, nearly all inertia
      CHECK(after_half_a_swing(zeta, 0.5, radius, 4.903325)
            == within(0, 6e-15, "½T is good to 5 ulp, in which the body, at its fastest, moves 5.4 radians"));
}

CHECK_THAT("the rod's numbers agree with fifty digits")
{
  const Fifty half = Fifty(1) / 2, third = Fifty(2) / 3, fall = 2 * Fifty("4.903325");
  const Fifty theta = exact::pi() * sqrt(third / fall);
  const double radius = std::sqrt(1.0 / 12);
  const double naive = naive_time(0.5, 4.903325);
  const double body = for_the_body(0.5, radius);
  CHECK(naive == within_ulps(exact::pi() * sqrt(half / fall), 3, "π, two roots, a product, a quotient"));
  CHECK(body == within_ulps(sqrt(Fifty(4) / 3) - 1, 4, "k rounded, and five operations"));
  CHECK(equivalent_length(0.5, radius) == within_ulps(third, 2, "k rounded, and three operations"));
  CHECK(naive * (1 + body) * (1 + for_the_arc(Amplitude::from_zeta(20_deg)))
        == within_ulps(theta * ratio_by_mean(exact::pi() * 8 / 9), 6, "three factors, two ulps each"));
}

/*!
Swings of a hundred-millionth of a radian, and a bob that is a speck: the corrections are what they should be,
though 1 and either of them add up to 1.
*/

CHECK_THAT("neither correction loses its digits when it is too small to be added to 1")
{
  const Fifty zeta(1e-8), q(1e-9);
  const double arc = for_the_arc(Amplitude::from_zeta(1e-8));
  CHECK(arc == within_ulps(zeta * zeta / 16, 4, "a few operations; the next term is 10⁻¹⁶ of it"));
  CHECK(for_the_body(1, 1e-9) == within_ulps(q * q / 2, 3, "four operations; the next term is 10⁻¹⁸ of it"));
  CHECK(1 + arc == 1);
}

CHECK_THAT("at the amplitude where the corrections are equal, they are")
{
  for(const double radius : {0.1, 0.2887, 1.0, 3.0})
  {
    const double zeta = equal_at(0.5, radius);
    CHECK(for_the_arc(Amplitude::from_zeta(zeta))
          == within_relative(for_the_body(0.5, radius), 1e-14, "an ulp of ζ, and T/Θ is not yet steep"));
  }
}

/*!
## Notes

"Any amplitude" means here any *swing*: all through the paper the pendulum turns back before the top. One that
has enough speed to go round and round obeys the same equation, and the program's library knows it too, but
Euler does not speak of it.
*/
