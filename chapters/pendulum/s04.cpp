#include <algorithm>

#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "pendulum/body.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 4, "The moment of gravity, and equal times up and down")

using pendulum::body_of, pendulum::three_weights;
using swing::Amplitude;

/*!
## What Euler does

Gravity always pulls back towards the vertical, with a moment that goes as the sine of the angle, and so the
way up and the way down take equal times. Take the pendulum in any position that it has while it swings. The
line $AG = a$ makes with the vertical $AB$ an angle $BAG = \Phi$, a variable one: nothing in the vertical
position, it grows by turns on both sides up to $\Phi = \zeta$, if ζ denotes the amplitude of the greatest
excursion.

Gravity alone is supposed to drive the pendulum, and so it bears, applied at its centre of gravity $G$ and in
the vertical direction $GH$, the force $M$. The moment of this force about the axis of gyration $A$ is

$$ Ma\sin\Phi , \tag{1} $$

and its action tends to diminish the angle $BAG = \Phi$.

::: margin
Today: the torque $-mga\sin\theta$. Euler measures forces by weights; the factor that makes a weight an
acceleration, $2g$, comes in {{sec pendulum.05}}.
:::

From this he draws one conclusion at once. While the pendulum approaches the vertical $AB$ the force quickens
its motion; while it recedes from there the same force, at the same angle, slows it by just as much. Hence
approach and recession are completed in equal times. If $\overrightarrow{\Phi\zeta}$ is the time from the
angle Φ up to the turning point, and $\overrightarrow{\zeta\Phi}$ that from there down again,

$$ \overrightarrow{\Phi\zeta} = \overrightarrow{\zeta\Phi} \qquad\text{for every } \Phi . \tag{2} $$

That is why he may look for one of the two times only and, in {{sec pendulum.02}}, take it twice.

## The program

The moment is one product. Near the top, though, the sine is that of an angle whose rounding is larger than
itself: no double comes nearer to 180° than some $10^{-16}$. The sine of an angle and of what it lacks to 180°
are the same, so the smaller of the two is taken.
*/

double moment(double M, double a, double phi)  // (1)
{
  return M * a * std::sin(phi);
}

double moment_at_rest(double M, double a, Amplitude amplitude)  // (1) at Φ = ζ
{
  return M * a * std::sin(std::min(amplitude.zeta, amplitude.eta));
}

/*!
The two times of {{eq 2}} come from different formulae of the library, in the unit $\sqrt b/\sqrt{2g}$. The
one adds up from the lowest point, by the integral of {{sec pendulum.07}}, and leaves the rest to a quarter of
the motion. The other begins at rest, with the integral of {{sec pendulum.14}}.
*/

double from_phi_to_rest(double phi, Amplitude amplitude)  // (2), left side
{
  return swing::quarter_time(amplitude) - swing::time_from_bottom(phi, amplitude);
}

double from_rest_to_phi(double phi, Amplitude amplitude)  // (2), right side
{
  return swing::time_from_rest_past(amplitude.zeta - phi, amplitude.eta);
}

const auto swing_ = amplitude(100_deg, open(0_deg, 180_deg));
const auto phi = angle("phi", 60_deg, closed(0_deg, 180_deg), "the present angle BAG = Φ");
const auto M = real("M", 1.0, Unit{"kg"}, positive, "mass, and at the same time the weight");
const auto a = real("a", 1.0, metres, positive, "distance AG of the centre of gravity from the axis");

TELL
{
  const Amplitude zeta{swing_.zeta, swing_.eta};
  require(phi <= zeta.zeta, "phi", "at most zeta");
  tell("moment", moment(M, a, phi), Unit{"kg m"}, "moment of gravity at Φ, weight times arm");
  tell("at_rest", moment_at_rest(M, a, zeta), Unit{"kg m"}, "the same at the turning point");
  tell("small_swings", M * a * phi, Unit{"kg m"}, "what the law of small swings has for it, MaΦ");
  tell("up", from_phi_to_rest(phi, zeta), "from Φ up to rest at ζ, in the unit √b/√(2g)");
  tell("down", from_rest_to_phi(phi, zeta), "from there down to Φ");
}

TELL
{
  curve("moment", {"phi", "moment", "small"}, [](Curve& c) {
    for(int degrees = -180; degrees <= 180; degrees += 2)
      c.put({1.0 * degrees, moment(1, 1, degrees * 1_deg), degrees * 1_deg});
  });
}

/*!
At {{phi|deg0}} the law of small swings has {{small_swings|4}} for {{moment|4}}. What the picture shows is why
wide swings last: beyond a right angle the farther the pendulum is out, the less it is pulled back.

::: figure pendulum-04
alt: The moment of gravity over Ma against the angle from −180 to 180 degrees: a sine. Through the origin its
tangent, the law of small swings, which leaves it beyond 30 degrees.

The moment of gravity, as a fraction of its greatest value $Ma$, and the law that the elements put in its
place. Where the moment is greatest, at 90°, the pendulum is far from its turning point if it swings wide;
near the top there is next to no moment to bring it back, and at the very top none.
:::

## Checks

That the weights of all the elements do what one force $M$ at $G$ would do is tried with the three weights of
{{sec pendulum.03}}. Each pulls with its own arm; the body is turned so that $AG$ makes the angle Φ, all the
way round.
*/

/// What all the elements together pull about the axis when AG is turned to phi.
double pull_of_all(const pendulum::Elements& elements, double phi)
{
  const Eigen::Vector2d G = body_of(elements).G;
  const double turn = phi - std::atan2(G.x(), -G.y());
  const auto how_far_right = std::cos(turn) * elements.row(1) - std::sin(turn) * elements.row(2);
  return elements.row(0).dot(how_far_right);
}

CHECK_THAT("the weights of all elements pull like one force M at G, towards the vertical from both sides")
{
  const auto body = body_of(three_weights());
  for(int degrees = -180; degrees <= 180; degrees += 5)
    CHECK(pull_of_all(three_weights(), degrees * 1_deg)
          == within(moment(body.M, body.a(), degrees * 1_deg), 4e-15, "six products of at most 1.2"));
}

/*!
Equal times, three times over. The two formulae must agree. And the equation of motion, integrated in many
digits from the lowest point upwards and from rest downwards, each for the time that it is said to take, must
bring the pendulum to the same place Φ, with the same speed in opposite directions.
*/

CHECK_THAT("the way up takes as long as the way down, and passes with the same speed")
{
  const auto motion = [](const Fifty&, const exact::State& y) { return exact::State{y[1], -sin(y[0])}; };
  for(const double zeta : {1_deg, 30_deg, 100_deg, 170_deg})
    for(const double part : {0.25, 0.6, 0.99})
    {
      const Amplitude amplitude = Amplitude::from_zeta(zeta);
      const double there = part * zeta, K = swing::quarter_time(amplitude);
      const double up = from_phi_to_rest(there, amplitude), down = from_rest_to_phi(there, amplitude);
      CHECK(up == within(down, 4e-16 * K + 2.3e-16 / zeta, "K rounded, and η = 180° − ζ as a part of ζ"));

      const Fifty speed_at_bottom = 2 * sin(Fifty(zeta) / 2);  // §6
      const Fifty rise = Fifty(K) - Fifty(down), small("1e-20");
      const auto rising = exact::solve(motion, 0, {Fifty(0), speed_at_bottom}, rise, small).y;
      const auto falling = exact::solve(motion, 0, {Fifty(zeta), Fifty(0)}, Fifty(down), small).y;
      CHECK(rising[0] == within(falling[0], 2e-15, "K and the time, each rounded, at a speed of at most 2"));
      CHECK(rising[1] == within(-falling[1], 1e-15, "the same, with at most 1 for the change of speed"));
      CHECK(falling[0] == within(Fifty(there), 1e-15, "the time is good to an ulp or two"));
    }
}

CHECK_THAT("the moment keeps its digits within a hair of the top")
{
  const Amplitude hair = Amplitude::from_eta(1e-20);
  CHECK(moment_at_rest(1, 1, hair) == within_ulps(sin(Fifty(1e-20)), 1, "one sine"));
  CHECK(moment(1, 1, hair.zeta) == within_ulps(1.2246467991473532e-16, 1, "what π lacks as a double"));
  CHECK(moment_at_rest(1, 1, Amplitude::from_eta(1e-300)) == 1e-300);
  CHECK(moment_at_rest(2, 3, Amplitude::from_zeta(90_deg)) == 6);
}
