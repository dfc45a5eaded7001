#include <algorithm>

#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "pendulum/body.hpp"
#include "pendulum/equation.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 4, "The moment of gravity, and equal times up and down")

using pendulum::three_weights, pendulum::turned;
using swing::Amplitude;

/*!
## What Euler does

The moment of gravity depends on the angle alone, and so the pendulum takes as long to move away from the
vertical as to come back. In any position that it has while it swings, let the line $AG = a$ make with the
vertical $AB$ the angle $BAG = \Phi$. This is a variable: from nothing in the vertical position it can grow,
by turns on both sides, up to $\Phi = \zeta$, the amplitude of the greatest excursion.

The pendulum is supposed to be driven by gravity alone. Then it bears the force $M$, applied at its centre of
gravity $G$ in the vertical direction $GH$. The moment of this force about the axis of gyration $A$ is

$$ Ma\sin\Phi , \tag{1} $$

and it acts to diminish the angle $BAG = \Phi$.

::: margin
Today: the torque $-mga\sin\theta$. Euler measures forces by weights; the factor $2g$ that turns a weight into
an acceleration comes in {{sec pendulum.05}}.
:::

Hence, when the pendulum approaches the vertical $AB$, this force accelerates it; when it recedes from there,
the force retards it by just as much. From this he infers that approach and recession are completed in equal
times: with $t_\uparrow$ for the time from the angle Φ up to the turning point and $t_\downarrow$ for the time
from there back to Φ,

$$ t_\uparrow = t_\downarrow \qquad\text{for every } \Phi . \tag{A} $$

That is why he need find only one of these times and may double it, as he does in {{sec pendulum.02}}.

## The program

The moment is one product. Near the top Φ cannot be given well enough: no double comes nearer to 180° than
some $10^{-16}$. There the function is given what is missing to 180°, which has the same sine.
*/

double moment(double M, double a, double phi)  // (1)
{
  return M * a * std::sin(phi);
}

double by_small_swings(double M, double a, double phi)
{
  return M * a * phi;
}

/*!
The two times come from different formulae of the library, in the unit $\sqrt b/\sqrt{2g}$. One takes a
quarter of the motion, less the way from the lowest point to Φ by the integral of {{sec pendulum.07}}. The
other begins at rest, with the integral of {{sec pendulum.14}}.
*/

double from_phi_to_rest(double phi, Amplitude to)  // (A), left side
{
  return swing::quarter_time(to) - swing::time_from_bottom(phi, to);
}

double from_rest_to_phi(double way, Amplitude to)  // (A), right side; way = ζ − Φ
{
  return swing::time_from_rest_past(pendulum::way_from_rest(way, to.eta), to.eta);
}

const auto swing_ = amplitude(100_deg, from_below(10_deg, 180_deg));

const auto phi = angle("phi", 60_deg, closed(0_deg, 180_deg), "the present angle BAG = Φ");
const auto M = real("M", 1.0, kilograms, scale, "mass, and at the same time the weight");
const auto a = real("a", 1.0, metres, scale, "distance AG of the centre of gravity from the axis");

TELL
{
  const Amplitude zeta{swing_.zeta, swing_.eta};
  require(phi.fifty() <= swing_.zeta.fifty(), "phi", "at most zeta");
  require(phi <= 179.9_deg, "phi", "at most 179.9°, where a double still tells how near the top is");
  const double way = static_cast<double>(swing_.zeta.fifty() - phi.fifty());
  tell("moment", moment(M, a, phi), Unit{"kg m"}, "moment of gravity at Φ, weight times arm");
  tell("small_swings", by_small_swings(M, a, phi), Unit{"kg m"},
       "what the law of small swings has for it, MaΦ");
  tell("at_rest", moment(M, a, std::min(zeta.zeta, zeta.eta)), Unit{"kg m"},
       "the moment at the turning point");
  tell("up", from_phi_to_rest(phi, zeta), "from Φ up to rest at ζ, in units of √b/√(2g)");
  tell("down", from_rest_to_phi(way, zeta), "from there down to Φ");
}

TELL
{
  curve("moments", {"phi", "moment", "small"}, [](Curve& c) {
    for(int degrees = -180; degrees <= 180; degrees += 2)
      c.put({1.0 * degrees, moment(1, 1, degrees * 1_deg), degrees * 1_deg});
  });
}

/*!
At {{phi|deg0}} the moment is {{moment|4}}; by the law of small swings it would be {{small_swings|4}}.

::: figure pendulum-04
alt: The moment of gravity over Ma against the angle from −180 to 180 degrees: a sine. Through the origin its
tangent, the law of small swings, which leaves it beyond 30 degrees.

The moment of gravity, as a fraction of its greatest value $Ma$, and the law of small swings. Beyond 90° the
moment falls again, and near the top almost nothing brings the pendulum back: that is why the widest swings
last so long.
:::

## Checks

The three weights of {{sec pendulum.03}} are turned until $AG$ makes the angle Φ. Each of them pulls with its
own arm, its distance from the vertical through $A$.
*/

CHECK_THAT("the weights of all elements pull like one force M at G, towards the vertical from both sides")
{
  const auto body = pendulum::body_of(three_weights());
  for(int degrees = -180; degrees <= 180; degrees += 5)
  {
    const auto elements = turned(three_weights(), degrees * 1_deg);
    const double pull = elements.row(0).dot(elements.row(1));
    CHECK(pull
          == within(moment(body.M, body.a(), degrees * 1_deg), 4e-15, "three products up to 2, turned"));
  }
}

/*!
For the equal times the equation of motion, $\Phi'' = -\sin\Phi$ in this unit of time, is integrated in many
digits: from rest at ζ for the one time, then back from there, with the speed reversed, for the other.
*/

CHECK_THAT("in the one time the pendulum comes down to Φ; thrown back, it is at rest again after the other")
{
  const auto motion = [](const Fifty&, const exact::State& y) { return exact::State{y[1], -sin(y[0])}; };
  for(const double zeta : {1_deg, 30_deg, 100_deg, 170_deg})
    for(const double part : {0.25, 0.6, 0.99})
    {
      const Amplitude to = Amplitude::from_zeta(zeta);
      const Fifty start(zeta), small("1e-20"), down(from_rest_to_phi(zeta - part * zeta, to));
      const auto there = exact::solve(motion, 0, {start, 0}, down, small).y;
      CHECK(there[0] == within(part * zeta, 1e-15, "a time of at most 4, to an ulp"));
      const Fifty up(from_phi_to_rest(part * zeta, to));
      const auto back = exact::solve(motion, 0, {there[0], -there[1]}, up, small).y;
      CHECK(back[0] == within(start, 1e-15, "at rest the angle hardly depends on the time"));
      CHECK(back[1] == within(0, 1e-15, "two times of at most 4, to an ulp"));
    }
}

CHECK_THAT("near the top the angle from the top gives the moment; Φ as a double does not")
{
  const Amplitude hair = Amplitude::from_eta(1e-20);
  CHECK(moment(2, 3, hair.eta) == within_ulps(6e-20, 2, "a sine and a product"));
  CHECK(moment(2, 3, hair.zeta)
        == within_relative(6 * 1.2246467991473532e-16, 1e-15, "what a double lacks to π"));
}

/*!
What is told, at the default, near the top, and for a swing that is hardly one:
*/

CHECK_THAT("the moments told are weight times arm, and the two times told are the exact motion's")
{
  for(const Told& now : told_at("", "eta=1e-9 phi=170 M=3 a=0.1", "zeta=10 phi=4", "zeta=150 phi=0 a=1e-50",
                                "zeta=60 phi=0", "zeta=60 phi=59.9999999999", "eta=1e-20 phi=179.9"))
  {
    const Fifty Ma = M.fifty() * a.fifty(), Phi = phi.fifty(), eta = swing_.eta.fifty(),
                zeta = swing_.zeta.fifty();
    CHECK(now.value("moment", Unit{"kg m"})
          == within(Ma * sin(Phi), 5e-16 * M * a, "a sine and two products"));
    CHECK(now.value("small_swings", Unit{"kg m"}) == within_relative(Ma * Phi, 5e-16, "two products"));
    CHECK(now.value("at_rest", Unit{"kg m"})
          == within_relative(Ma * sin(eta), 6e-16, "a sine and two products"));
    const Fifty K = exact::pi() / 2 * swing::oracle::ratio_from_top(eta),
                up = K - swing::oracle::time_from_bottom(Phi, eta);
    const double way_rounds = 4e-16 * swing_.zeta / std::max(1e-300, swing_.zeta - phi);
    const double rounding =
        static_cast<double>(K) * 1e-15 * (1 + std::sqrt(way_rounds)) + static_cast<double>(up) * way_rounds;
    CHECK(now.value("up") == within(up, 2 * rounding, "a difference of rounded times"));
    CHECK(now.value("down")
          == within_relative(up, 2e-15, "the library's six ulps, and the way's rounding"));
    CHECK(zeta > Phi);
  }
}

CHECK_THAT("the figure is a sine and its tangent")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("moments", 9))
    {
      const Fifty Phi = Fifty(point.at("phi")) * exact::pi() / 180;
      CHECK(point.value("moment") == within(sin(Phi), 3e-16, "near 180° the double of Φ tells"));
      CHECK(point.value("small") == within(Phi, 5e-16, "degrees to radians"));
    }
}

CHECK_THAT(
    "an angle beyond the amplitude or 179.9° is refused, by however little, and these angles are not")
{
  for(const char* const within_it : {"zeta=60 phi=60", "zeta=150 phi=150", "eta=1e-20 phi=179.9"})
    CHECK(!refused_at(within_it));
  for(const char* const beyond :
      {"zeta=60 phi=60.0000000000000000000001", "zeta=150 phi=150.0000000000000000000001",
       "eta=1e-20 phi=179.90000000000006"})
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
Let go at 60° or at 120°, a pendulum is driven by the same moment at first. Which of the two is sooner
down?

answer: That from 60°: `--zeta 60 --phi 0` tells 1.6858, and `--zeta 120 --phi 0` 2.1565. From 120° the
way is twice as long, but it takes only 28 per cent more time, since the moment grows at first.
:::
*/

CHECK_THAT("from 60° and from 120° the moment is the same at first, and the times are 1.6858 and 2.1565")
{
  for(const Told& now : told_at("zeta=60 phi=0", "zeta=120 phi=0"))
  {
    const Fifty K = exact::pi() / 2 * swing::oracle::ratio_from_bottom(swing_.zeta.fifty());
    CHECK(now.value("at_rest", Unit{"kg m"}) == within_ulps(sqrt(Fifty(3)) / 2, 2, "a sine"));
    CHECK(now.value("down") == within_ulps(K, 6, "the library's bound"));
    CHECK(now.value("up") == within(swing_.zeta < 90_deg ? 1.6858 : 2.1565, 0.5e-4, "to four decimals"));
  }
}
