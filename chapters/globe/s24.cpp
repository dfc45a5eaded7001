#include "edition/section.hpp"
#include "globe/asked.hpp"
#include "globe/ball.hpp"
#include "globe/readings.hpp"
#include "globe/scene.hpp"
#include "globe/scene_judge.hpp"

SECTION(globe, 24, "Rolling, and the friction that it takes")

using namespace globe;

/*!
## What Euler does

In the second part the ball rolls and does not scrape, and what was given becomes what is asked: how much
friction does that take? Perfect rolling means that always $ds = a\,d\Phi$ ({{sec globe.03}}). Friction is no
longer the fraction of the pressure that rubbing surfaces have; it is whatever keeps the point of contact at
rest, and $\lambda$ is an unknown of the equations like Π. So Euler puts $ds = a\,d\Phi$ into
them, removes Π, and looks at the value that $\lambda$ takes. As long as it does not exceed the limit that was
assumed in {{sec globe.04}} for true rubbing, $\tfrac13${{entry limit}}, the ball can roll.

The easiest way is to divide the third equation of {{sec globe.07}} by the first of {{sec globe.06}}. They are

$$ \begin{aligned} \frac{P\,ddx}{2g\,dt^2} &= -\lambda\Pi, \\
   \frac{Pkk\,dd\Phi}{2g\,dt^2} &= \lambda\Pi(a - c\cos\Phi) - \Pi c\sin\Phi, \end{aligned} $$

and Π goes out with $P$ and $g$:

$$ \frac{kk\,dd\Phi}{ddx{{entry over_ddx}}} = -a + c\cos\Phi + \frac c\lambda\sin\Phi. \tag{1} $$

By {{sec globe.03}} $ddx = dds - c\,dd\Phi\cos\Phi + c\,d\Phi^2\sin\Phi$, and now $dds = a\,dd\Phi$. So

$$ \frac{kk\,dd\Phi}{a\,dd\Phi{{entry radius}} - c\,dd\Phi\cos\Phi + c\,d\Phi^2\sin\Phi}
   = -a + c\cos\Phi + \frac c\lambda\sin\Phi, \tag{2} $$

from which $\lambda$ is had as soon as $dd\Phi$ and $d\Phi$ are known. Our copy has in {{eq 1}} the letter e
for the last $c$.

::: margin
Today: static friction, a constraint force $F = \lambda\Pi$, and Coulomb's condition $|F| \le \mu\Pi$.
$\lambda$ is counted backwards.
:::

Two remarks. The condition has two sides: $\lambda$ may be negative, where friction has to push the ball
forwards, and then it is $-\lambda$ that must not be too great. And {{eq 2}} fails to tell $\lambda$ at the
lowest and highest place, where it has $\tfrac00$.

Both are mended by going one step further. With $y = a - c\cos\Phi$ for the height of $G$ and
$v = d\Phi^2/2g\,dt^2$, the equation of {{sec globe.25}} gives $dd\Phi$, and {{eq 2}} becomes

$$ \lambda = \frac{c\sin\Phi\,\bigl(y - v(cc+kk-ac\cos\Phi)\bigr)}
   {kk + yy + vc\,\bigl((aa+cc+kk)\cos\Phi - ac(1+\cos^2\Phi)\bigr)}. \tag{A} $$

The denominator is the pressure, over the weight, times $aa+cc+kk-2ac\cos\Phi$. On the way up the slow ball
is held back by friction, the fast one pushed on: $\lambda$ changes its sign where

$$ \frac{d\Phi^2}{2g\,dt^2} = \frac{a-c\cos\Phi}{cc+kk-ac\cos\Phi}, \tag{B} $$

and there the ball rolls on ice as well as on sand, for that moment.

## The program

The state is the angle and the angular velocity; how the two hang together is the next section's matter. All
lengths are measured by the largest, so that no product of four of them is beyond the doubles.
*/

struct Rolling
{
  double turning, advance;  // ddΦ/dt² and ddx/dt² over 2g
  double pressure, lambda;  // Π/P and λ
};

Rolling rolling_at(const Ball<double>& ball, const Place<double>& at, double w, double g)
{
  const auto [a, c, k] = in_own_measure(ball);
  const double unit = ball.a / a, v = w / g * w / 2 * unit;
  const double s = 2 * at.s * at.c, u = (at.c - at.s) * (at.c + at.s);
  const double y = a - c + 2 * c * at.s * at.s, D = k * k + (a - c) * (a - c) + 4 * a * c * at.s * at.s;
  const double pushed = y - v * (c * c + k * k - a * c * u);
  const double borne = k * k + y * y + v * c * (u * D - a * c * s * s);
  return {0 - c * s * (1 + a * v) / D / unit, 0 - c * s * pushed / D, borne / D,
          c * s * pushed / borne};  // (A)
}

double free_velocity(const Ball<double>& ball, const Place<double>& at, double g)  // (B)
{
  const auto [a, c, k] = in_own_measure(ball);
  const double y = a - c + 2 * c * at.s * at.s;
  const double vv = y / (c * (c - a) + k * k + 2 * a * c * at.s * at.s);
  return vv >= 0 ? std::sqrt(vv * a / ball.a) * std::sqrt(2 * g) : infinity;
}

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto asked = asked_place(60_deg);
const auto w = real("w", 5, Unit{"1/s"}, closed(0, 1e100), "angular velocity dΦ/dt");

TELL
{
  const Ball<double> ball{a, c, k};
  require_rolling(ball);
  require(w / g * w * std::max({ball.a, ball.c, ball.k}) <= 1e100, "w",
          "a w² a and w² c of at most 1e100 g");
  const auto there = rounded(asked.fifty());
  const Rolling now = rolling_at(ball, there, w, g);
  tell("turning", 2 * g * now.turning, Unit{"1/s²"}, "ddΦ/dt²");
  tell("advance", 2 * g * now.advance, Unit{"ft/s²"}, "ddx/dt², of G forwards");
  tell("pressure", now.pressure, "Π/P; where it is not above 0 the ball does not stay on the plane");
  tell("friction", 0 - now.advance, "λΠ/P, backwards, as a part of the weight");
  tell("lambda", now.lambda, "λ, the friction that rolling takes over the pressure");
  tell("w_free", free_velocity(ball, there, g), Unit{"1/s"}, "the dΦ/dt with which it takes none, (B)");
}

TELL
{
  auto& angles = table("angles", "With this angular velocity at other angles",
                       {{"Phi", "Φ", degrees},
                        {"turning", "ddΦ/dt²", Unit{"1/s²"}},
                        {"pressure", "Π/P"},
                        {"lambda", "λ"},
                        {"w_free", "none at", Unit{"1/s"}}});
  const Ball<double> ball{a, c, k};
  for(int n = 0; n <= 6; ++n)
  {
    const double Phi = n * std::numbers::pi / 6;
    const Place<double> there = n < 6 ? place(Phi) : Place<double>{1, 0};
    const Rolling now = rolling_at(ball, there, w, g);
    angles.row({Phi, 2 * g * now.turning, now.pressure, now.lambda, free_velocity(ball, there, g)});
  }
}

TELL
{
  curve("by_velocity", {"w", "lower", "upper"}, [](Curve& by_velocity) {
    const Ball<double> ball{a, c, k};
    const auto [a_, c_, k_] = in_own_measure(ball);
    const double end = 5 * (a_ + c_) / (c_ * c_ + k_ * k_ + a_ * c_) * a_ / a;  // of v
    const double sixth = std::numbers::pi / 3;
    for(int n = 0; n <= 60; ++n)
    {
      const double now = n * std::sqrt(2 * g) * std::sqrt(end) / 60;
      const Rolling up = rolling_at(ball, place(sixth), now, g),
                    over = rolling_at(ball, place(2 * sixth), now, g);
      if(std::min(up.pressure, over.pressure) > 0.02)
        by_velocity.put({now, up.lambda, over.lambda});
    }
  });
}

TELL
{
  const Fifty s = asked.fifty().s, u = asked.fifty().c;  // of ½Φ
  const Fifty moved = w.fifty() * w.fifty() / (8 * g.fifty() * c.fifty())
                      * (bb<Fifty>({a.fifty(), c.fifty(), k.fifty()}) + 4 * a.fifty() * c.fifty() * s * s);
  const Ball<double> ball{a, c, k};
  const auto at = rounded(asked.fifty());
  Energy<double> e = rounded(Energy<Fifty>{s * s + moved, u * u - moved});
  if(!can_be_seen(ball, e.h))
    return;
  e.h = std::max(e.h, at.s * at.s);  // at rest, where both are rounded
  const double from =
      w == 0 ? rolling::quarter<double>(in_radii(ball), e) : rolling::time<double>(in_radii(ball), e, at);
  if(std::isfinite(from))
    scene_of_ball("rolling", rolling_motion(ball, g, e, from));
}

/*!
At 60°, turning with 5 radians a second, our ball asks for a friction of {{lambda|4}} of the pressure. Were it
{{w_free|4}} radians a second, it would ask for none.

{{table angles}}

::: figure globe-24
alt: The friction ratio against the angular velocity, at 60° and at 120°. Both curves begin above zero, fall,
cross zero, one after the other, and go on falling.

What rolling takes at 60° and 120°, against the angular velocity that the ball has there. It begins with
what holds a ball that is let go, sinks to nothing, and changes sides. At 120° little is then left of the
pressure, and λ runs away.
:::

::: scene rolling
alt: A ball on a level line; a radius goes down to the left, with the centre of gravity on it. A grey line is
the way of that point.

The ball rolls on from this place, with this velocity, in true time: two turns, or a swing to and fro, and no
farther than to where the plane bears nothing. It is quick while $G$ is low and slow while it is high; with
$c = {{c}}$ that is hard to see, with 0.5 it is not.
:::

## Checks

The friction that is told is put into the equations of motion of {{sec globe.06}} and {{sec globe.07}} for a
ball that scrapes with just that ratio, which know nothing of rolling: the point of contact must keep pace.
*/

CHECK_THAT("with the λ told the equations of motion make ds and a dΦ change alike; (1), (2) and (A) agree")
{
  for(const Told& now : told_at("", "a=1 c=0.5 k=0.5 g=0.5 Phi=120 w=1.5", "c=3 k=0.01 w=0.2 Phi=20 g=1e-3",
                                "a=1e60 c=1e58 k=1e61 w=1e-9 psi=1e-30rad g=1e50"))
  {
    const Ball<Fifty> ball{a.fifty(), c.fifty(), k.fifty()};
    const Fifty g_ = g.fifty(), w_ = w.fifty(), Phi = asked.angle(), s = sin(Phi), u = cos(Phi);
    const auto rolls = rolling_accelerations<Fifty>(ball, g_, Phi, w_);
    const Fifty lambda = -rolls.x / (2 * g_ * rolls.pressure);
    const auto moved = accelerations<Fifty>(ball, g_, Phi, w_, lambda);
    const Fifty ddx = ball.a * moved.Phi - ball.c * moved.Phi * u + ball.c * w_ * w_ * s;
    const Fifty size = abs(moved.x) + ball.c * w_ * w_ * s;
    CHECK(moved.x == within(ddx, 1e-40 * double(size), "§3 with dds = a ddΦ"));
    CHECK(
        ball.k * ball.k * moved.Phi / ddx  // (1), (2)
        == within_relative(-ball.a + ball.c * u + ball.c / lambda * s, 1e-15, "the small angle's digits"));
    const Fifty y = ball.a - ball.c * u, v = w_ * w_ / (2 * g_),
                D = y * y + pow(ball.c * s, 2) + ball.k * ball.k;
    const Fifty most = y + v * (ball.c * ball.c + ball.k * ball.k + ball.a * ball.c);
    // What rounding makes of the numerator of (A), as a part of the whole.
    const double slack = 2e-15 * double(most * ball.c * s / D);
    CHECK(now.value("turning", Unit{"1/s²"}) == within_relative(moved.Phi, 4e-15, "a dozen roundings"));
    CHECK(now.value("advance", Unit{"ft/s²"})
          == within(moved.x, 2 * double(g_) * slack, "some roundings of the summands"));
    CHECK(now.value("friction") == within(-moved.x / (2 * g_), slack, "the same"));
    CHECK(now.value("pressure")
          == within(moved.pressure, 4e-15 * double(1 + v * ball.c), "some roundings of the summands"));
    CHECK(now.value("lambda")
          == within(lambda,
                    double(slack / moved.pressure)
                        + 4e-15 * double(abs(lambda) * (1 + v * ball.c) / moved.pressure),
                    "the quotient of the two"));
  }
}

CHECK_THAT("with the velocity of (B) the ball on a smooth plane rolls of itself, for that moment")
{
  for(const Told& now :
      told_at("", "c=0.5 k=0.5 Phi=130", "a=1e-60 c=1e-62 k=1e-60 g=1e40 Phi=0", "c=1.5 k=0.1 Phi=10"))
  {
    const Ball<Fifty> ball{a.fifty(), c.fifty(), k.fifty()};
    const Fifty g_ = g.fifty(), Phi = asked.angle(), u = cos(Phi), s = sin(Phi);
    const Fifty v = (ball.a - ball.c * u) / (ball.c * ball.c + ball.k * ball.k - ball.a * ball.c * u);
    if(v < 0)
    {
      CHECK(now.value("w_free", Unit{"1/s"}) == infinite("no velocity is great enough"));
      continue;
    }
    const Fifty free = sqrt(2 * g_ * v);
    CHECK(now.value("w_free", Unit{"1/s"}) == within_relative(free, 4e-15, "ten roundings"));
    const auto slides = accelerations<Fifty>(ball, g_, Phi, free, 0);
    const Fifty dds = slides.x + ball.c * slides.Phi * u - ball.c * free * free * s;
    CHECK(dds == within(ball.a * slides.Phi, 1e-40 * double(ball.c * free * free), "fifty digits"));
  }
}

Fifty free_at(double Phi)  // (B)
{
  const Fifty a_ = a.fifty(), c_ = c.fifty(), k_ = k.fifty(), u = cos(Fifty(Phi));
  return sqrt(2 * g.fifty() * (a_ - c_ * u) / (c_ * c_ + k_ * k_ - a_ * c_ * u));
}

CHECK_THAT(
    "the scene is the ball that rolls as the equation of §9 has it, from the place and velocity asked for")
{
  for(const Told& now :
      told_at("", "c=0.5 k=0.5 Phi=120 w=0.8 g=2", "Phi=90 w=0 c=0.9 k=0.1", "w=20 c=0.5"))
  {
    const Ball<Fifty> ball{a.fifty(), c.fifty(), k.fifty()};
    const auto frames = now.points("rolling", 7);
    for(const auto& frame : judged(frames, Plane::rough, ball, g.fifty(), asked.angle(), w.fifty()))
    {
      CHECK(frame.told.value("t") == between(frame.earliest, frame.latest, "in their order"));
      CHECK(frame.pressure == between(-1e-9, infinity, "the plane bears it, to the last frame"));
      CHECK(frame.told.value("Phi") == within(frame.Phi, frame.slack, Judged_ball::because));
      CHECK(frame.told.value("C_x") == within(frame.C_x, frame.slack, Judged_ball::because));
      CHECK(frame.told.value("G_x") == within(frame.G_x, frame.slack, Judged_ball::because));
      CHECK(frame.told.value("G_y") == within(frame.G_y, frame.slack, Judged_ball::because));
    }
  }
}

CHECK_THAT("the table and the figure are the friction that the accelerations of rolling ask for")
{
  const auto lambda_at = [](double Phi, double w_) {
    const auto rolls =
        rolling_accelerations<Fifty>({a.fifty(), c.fifty(), k.fifty()}, g.fifty(), Fifty(Phi), Fifty(w_));
    return Fifty(-rolls.x / (2 * g.fifty() * rolls.pressure));
  };
  for(const Told& now : told_at("c=1.5 k=0.1"))
    CHECK(now.rows("angles").front().value("w_free", Unit{"1/s"})
          == infinite("G is below the plane, and nothing frees it there"));
  for(const Told& now : told_at("", "c=0.5 k=0.5 g=0.5 w=0.7", "a=1e-60 c=1e-62 k=1e-60 g=1e40 w=1e48"))
    for(const auto& row : now.rows("angles"))
    {
      const Ball<Fifty> ball{a.fifty(), c.fifty(), k.fifty()};
      const double Phi = row.at("Phi", degrees);
      const auto rolls = rolling_accelerations<Fifty>(ball, g.fifty(), Fifty(Phi), w.fifty());
      const double most = double(2 * g.fifty() / ball.a + w.fifty() * w.fifty());
      CHECK(row.value("Phi", degrees)
            == within(exact::pi() * std::round(6 * Phi / 3.14159) / 6, 1e-15, "steps of 30°"));
      CHECK(row.value("turning", Unit{"1/s²"})
            == within(rolls.Phi, 1e-14 * most, "some roundings, and that of Φ"));
      CHECK(row.value("pressure") == within(rolls.pressure, 1e-14, "some roundings, and that of Φ"));
      CHECK(row.value("lambda") == within(lambda_at(Phi, w), 1e-14, "some roundings, and that of Φ"));
      CHECK(row.value("w_free", Unit{"1/s"}) == within_relative(free_at(Phi), 1e-14, "(B)"));
    }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("by_velocity", 7))
    {
      const double now_w = point.at("w");
      CHECK(point.value("w") == between(0, 100, "from rest"));
      CHECK(point.value("lower") == within(lambda_at(60_deg, now_w), 1e-13, "some roundings"));
      CHECK(point.value("upper")
            == within(lambda_at(120_deg, now_w), 1e-11, "over a fiftieth of the weight"));
    }
}

/*!
Now the readings. {{eq 1}} is held against the accelerations of our ball at 60°; the radius that is left out
in {{eq 2}} shows when the ball is measured in half feet, since in feet it is 1. The limit is ½ in our copy,
as it is in {{sec globe.04}}, where any other fraction may take its place; {{sec globe.27}} reckons with a
third. Which of the two is meant here is as undecided as there, since what rolls with a third rolls with a
half, too; we put a third in both places.
*/

struct Our_state
{
  Fifty left, over_dds, without_a, right;  // of (1) and (2), in half feet
};

Our_state our_state()
{
  const Ball<Fifty> ball{2, Fifty(2) / 10, Fifty(6) / 5};
  const Fifty g_ = 2 * our_g<Fifty>, w_ = 5, Phi = exact::pi() / 3, s = sin(Phi), u = cos(Phi);
  const auto rolls = rolling_accelerations<Fifty>(ball, g_, Phi, w_);
  const Fifty above = ball.k * ball.k * rolls.Phi, lambda = -rolls.x / (2 * g_ * rolls.pressure);
  return {above / rolls.x, above / (ball.a * rolls.Phi), above / (rolls.x - (ball.a - 1) * rolls.Phi),
          -ball.a + ball.c * u + ball.c / lambda * s};
}

bool is_the_right_side(double reading)
{
  return reading == within_relative(our_state().right, 1e-14, "the right side of (1), our ball at 60°");
}

const Emendation over_ddx{"§24, the first equation, the denominator",
                          {"dds", [] { return double(our_state().over_dds); }},
                          {"ddx", [] { return double(our_state().left); }},
                          "the first equation of motion has ddx, and the accelerations of our ball agree",
                          is_the_right_side};

const Emendation radius{"§24, the second equation, the denominator",
                        {"ddΦ − c ddΦ cos Φ", [] { return double(our_state().without_a); }},
                        {"a ddΦ − c ddΦ cos Φ", [] { return double(our_state().left); }},
                        "dds is a ddΦ, and every member must be a length",
                        is_the_right_side};

const Undecided limit{"§24, as in §4, the greatest λ",
                      {"1/2", 0.5},
                      {"1/3", 1 / 3.},
                      "rolling with S + a above 3c, as in §27, where λ = c/(S + a), needs no more than it",
                      lets_roll_what_is_safe};

/*!
## Go on from here

::: exercise
A ball is held with $CG$ horizontal and let go. How rough must the plane be for it to roll away at once, and
which $c$ asks for most?

answer: By {{eq A}}, with $v = 0$ and $\Phi = 90°$, $\lambda = ac/(aa+kk)$: it grows with $c$.
`--Phi 90 --w 0` tells it for our ball, and a check does so for others.
:::
*/

CHECK_THAT("let go with CG horizontal a ball asks for ac/(aa + kk)")
{
  for(const Told& now : told_at("Phi=90 w=0", "Phi=90 w=0 c=0.9 k=0.1", "Phi=90 w=0 a=1e30 c=1e10 k=1e32"))
    CHECK(now.value("lambda")
          == within_relative(a.fifty() * c.fifty() / (pow(a.fifty(), 2) + pow(k.fifty(), 2)), 2e-15,
                             "some roundings, and that of 90°"));
}
