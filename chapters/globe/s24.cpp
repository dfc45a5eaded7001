#include "edition/section.hpp"
#include "globe/asked.hpp"
#include "globe/ball.hpp"
#include "globe/readings.hpp"
#include "globe/rolling.hpp"
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
   \frac{Pkk\,dd\Phi}{2g\,dt^2} &= \lambda\Pi(a - c\cos\Phi)\\ &\quad - \Pi c\sin\Phi, \end{aligned} $$

and Π goes out with $P$ and $g$:

$$ \frac{kk\,dd\Phi}{ddx{{entry over_ddx}}} = -a + c\cos\Phi + \frac c\lambda\sin\Phi. \tag{1} $$

By {{sec globe.03}} $ddx = dds - c\,dd\Phi\cos\Phi + c\,d\Phi^2\sin\Phi$, and now $dds = a\,dd\Phi$. So

$$ \begin{aligned} &\frac{kk\,dd\Phi}{a\,dd\Phi{{entry radius}} - c\,dd\Phi\cos\Phi + c\,d\Phi^2\sin\Phi} \\
   &\quad = -a + c\cos\Phi + \frac c\lambda\sin\Phi, \end{aligned} \tag{2} $$

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

$$ \begin{aligned} \lambda &= c\sin\Phi\\ &\quad\cdot\frac{y - v(cc+kk-ac\cos\Phi)}{kk + yy + vcE}, \\
   E &= (aa+cc+kk)\cos\Phi\\ &\quad - ac(1+\cos^2\Phi). \end{aligned} \tag{A} $$

The denominator is the pressure, over the weight, times $aa+cc+kk-2ac\cos\Phi$. On the way up the slow ball
is held back by friction, the fast one pushed on: $\lambda$ changes its sign where

$$ \frac{d\Phi^2}{2g\,dt^2} = \frac{a-c\cos\Phi}{cc+kk-ac\cos\Phi}, \tag{B} $$

and there the ball rolls on ice as well as on sand, for that moment.

## The program

The state is the angle and the angular velocity; how the two hang together is the next section's matter. All
lengths are measured by the largest, so that no product of four of them is beyond the doubles.
*/

template <class Real>
struct Rolling
{
  Real turning, advance;  // ddΦ/dt² and ddx/dt² over 2g
  Real pressure, lambda;  // Π/P and λ
};

template <class Real>
Rolling<Real> rolling_at(const Ball<Real>& ball, const Place<Real>& at, const Real& w, const Real& g)
{
  const auto [a, c, k, gap] = in_own_measure(ball);
  const Real unit = ball.a / a, v = w / g * w / 2 * unit;
  const Real s = 2 * at.s * at.c, u = (at.c - at.s) * (at.c + at.s), ss = at.s * at.s;
  const Real y = gap + 2 * c * ss, D = k * k + gap * gap + 4 * a * c * ss;
  const Real pushed = y - v * (k * k + c * (2 * a * ss - gap));
  const Real borne = k * k + y * y + v * c * (u * D - a * c * s * s);
  return {0 - c * s * (1 + a * v) / D / unit, 0 - c * s * pushed / D, borne / D,
          c * s * pushed / borne};  // (A)
}

template <class Real>
Real free_velocity(const Ball<Real>& ball, const Place<Real>& at, const Real& g)  // (B)
{
  using std::sqrt;
  const auto [a, c, k, gap] = in_own_measure(ball);
  const Real ss = at.s * at.s, vv = (gap + 2 * c * ss) / (k * k + c * (2 * a * ss - gap));
  return vv >= 0 ? Real(sqrt(vv * a / ball.a) * sqrt(2 * g)) : Real(infinity);
}

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto asked = asked_place(60_deg);
const auto w = real("w", 5, Unit{"1/s"}, closed(0, 1e100), "angular velocity dΦ/dt");

TELL
{
  const Ball<Fifty> ball = exact_ball(a, c, k);
  require_rolling(rounded(ball));
  require(w / g * w * std::max<double>({a, c, k}) <= 1e100, "w",
          "so small that w² a, w² c and w² k are at most 1e100 g");
  const Place<Fifty> there = asked.fifty();
  const Rolling<Fifty> now = rolling_at(ball, there, w.fifty(), g.fifty());
  tell("turning", double(2 * g.fifty() * now.turning), Unit{"1/s²"}, "ddΦ/dt²");
  tell("advance", double(2 * g.fifty() * now.advance), Unit{"ft/s²"}, "ddx/dt², of G forwards");
  tell("pressure", double(now.pressure),
       "Π/P; where it is not above 0 the ball does not stay on the plane");
  tell("friction", double(0 - now.advance), "λΠ/P, backwards, as a part of the weight");
  tell("lambda", double(now.lambda), "λ, the friction that rolling takes over the pressure");
  tell("w_free", double(free_velocity(ball, there, g.fifty())), Unit{"1/s"},
       "the dΦ/dt with which it takes none, (B)");
}

TELL
{
  auto& angles = table("angles", "With this angular velocity at other angles",
                       {{"Phi", "Φ", degrees, 3},
                        {"turning", "ddΦ/dt²", Unit{"1/s²"}},
                        {"pressure", "Π/P"},
                        {"lambda", "λ"},
                        {"w_free", "none at", Unit{"1/s"}}});
  const Ball<Fifty> ball = exact_ball(a, c, k);
  for(int n = 0; n <= 6; ++n)
  {
    const Fifty Phi = n * exact::pi() / 6;
    const Place<Fifty> there = n < 6 ? place(Phi) : Place<Fifty>{1, 0};
    const Rolling<Fifty> now = rolling_at(ball, there, w.fifty(), g.fifty());
    angles.row({double(Phi), double(2 * g.fifty() * now.turning), double(now.pressure), double(now.lambda),
                double(free_velocity(ball, there, g.fifty()))});
  }
}

TELL
{
  curve("by_velocity", {"w", "lower", "upper"}, [](Curve& by_velocity) {
    const Ball<double> ball = rounded_ball(a, c, k);
    const auto own = in_own_measure(ball);
    const double end =
        5 * (own.a + own.c) / (own.c * own.c + own.k * own.k + own.a * own.c) * own.a / a;  // of v
    const double sixth = std::numbers::pi / 3;
    for(int n = 0; n <= 60; ++n)
    {
      const double now = n * std::sqrt(2 * g) * std::sqrt(end) / 60;
      const Rolling<double> up = rolling_at<double>(ball, place(sixth), now, g),
                            over = rolling_at<double>(ball, place(2 * sixth), now, g);
      if(std::min(up.pressure, over.pressure) > 0.02)
        by_velocity.put({now, up.lambda, over.lambda});
    }
  });
}

TELL
{
  const Fifty s = asked.fifty().s, u = asked.fifty().c;  // of ½Φ
  const Fifty moved = w.fifty() * w.fifty() / (8 * g.fifty() * c.fifty())
                      * (bb(exact_ball(a, c, k)) + 4 * a.fifty() * c.fifty() * s * s);
  const Ball<double> ball = rounded_ball(a, c, k);
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
  for(const Told& now :
      told_at("", "a=1 c=0.5 k=0.5 g=0.5 Phi=120 w=1.5", "c=3 k=0.01 w=0.2 Phi=20 g=1e-3",
              "a=1e60 c=1e58 k=1e61 w=1e-9 psi=1e-30rad g=1e50", "c=0.999999999 k=1e-9 Phi=1e-9rad",
              "c=0.999999999 k=1e-9 Phi=10 w=3", "c=1.000000000001 k=1e-12 Phi=1e-5 w=0.01"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Fifty g_ = g.fifty(), w_ = w.fifty(), Phi = asked.angle(), s = sin(Phi), u = cos(Phi);
    const auto rolls = rolling_accelerations<Fifty>(ball, g_, Phi, w_);
    const Fifty lambda = -rolls.x / (2 * g_ * rolls.pressure);
    const auto moved = accelerations<Fifty>(ball, g_, Phi, w_, lambda);
    const Fifty ddx = ball.a * moved.Phi - ball.c * moved.Phi * u + ball.c * w_ * w_ * s;
    const Fifty size = abs(moved.x) + ball.c * w_ * w_ * s;
    CHECK(
        moved.x
        == within(ddx, 1e-30 * double(size), "§3 with dds = a ddΦ; fifty digits less those of aa over kk"));
    CHECK(
        ball.k * ball.k * moved.Phi / ddx  // (1), (2)
        == within_relative(-ball.a + ball.c * u + ball.c / lambda * s, 1e-15, "the small angle's digits"));
    const char* const because = "fifty digits, rounded once";
    CHECK(now.value("turning", Unit{"1/s²"}) == within_ulps(moved.Phi, 1, because));
    CHECK(now.value("advance", Unit{"ft/s²"}) == within_ulps(moved.x, 1, because));
    CHECK(now.value("friction") == within_ulps(-moved.x / (2 * g_), 1, because));
    CHECK(now.value("pressure") == within_ulps(moved.pressure, 1, because));
    CHECK(now.value("lambda") == within_ulps(lambda, 1, because));
  }
}

CHECK_THAT("with the velocity of (B) the ball on a smooth plane rolls of itself, for that moment")
{
  for(const Told& now : told_at("", "c=0.5 k=0.5 Phi=130", "a=1e-60 c=1e-62 k=1e-60 g=1e40 Phi=0",
                                "c=1.5 k=0.1 Phi=10", "c=0.999999999 k=1e-9 Phi=0.01"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Fifty g_ = g.fifty(), Phi = asked.angle(), u = cos(Phi), s = sin(Phi);
    const Fifty v = (ball.a - ball.c * u) / (ball.c * ball.c + ball.k * ball.k - ball.a * ball.c * u);
    if(v < 0)
    {
      CHECK(now.value("w_free", Unit{"1/s"}) == infinite("no velocity is great enough"));
      continue;
    }
    const Fifty free = sqrt(2 * g_ * v);
    CHECK(now.value("w_free", Unit{"1/s"}) == within_ulps(free, 1, "fifty digits, rounded once"));
    const auto slides = accelerations<Fifty>(ball, g_, Phi, free, 0);
    const Fifty dds = slides.x + ball.c * slides.Phi * u - ball.c * free * free * s;
    CHECK(dds == within(ball.a * slides.Phi, 1e-40 * double(ball.c * free * free), "fifty digits"));
  }
}

Fifty free_square(const Fifty& Phi)  // (B), the square of dΦ/dt
{
  const Fifty a_ = a.fifty(), c_ = c.fifty(), k_ = k.fifty(), u = cos(Phi);
  return 2 * g.fifty() * (a_ - c_ * u) / (c_ * c_ + k_ * k_ - a_ * c_ * u);
}

Fifty lambda_at(const Fifty& Phi, const Fifty& w_)  // by the accelerations of rolling
{
  const auto rolls = rolling_accelerations<Fifty>(exact_ball(a, c, k), g.fifty(), Phi, w_);
  return -rolls.x / (2 * g.fifty() * rolls.pressure);
}

CHECK_THAT("a ball with c = a is refused whose k is less than 1e-20 of them, and a w with a product beyond "
           "1e100 g")
{
  for(const char* const within_them : {"c=1 k=1e-20", "a=2 c=2 k=2e-20", "a=1e100 g=1 w=1",
                                       "c=1e100 g=1 w=1", "k=1e100 g=1 w=1", "a=1e100 g=4 w=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"c=1 k=9.9999999999999e-21", "a=2 c=2 k=1.9999999999999e-20",
                                  "a=1e100 g=1 w=1.0000000000000002", "c=1e100 g=1 w=1.0000000000000002",
                                  "k=1e100 g=1 w=1.0000000000000002", "a=1e100 g=4 w=2.0000000000000005"})
    CHECK(refused_at(beyond));
}

CHECK_THAT(
    "the scene is the ball that rolls as the equation of §9 has it, from the place and velocity asked for")
{
  for(const Told& now :
      told_at("", "c=0.5 k=0.5 Phi=120 w=0.8 g=2", "Phi=90 w=0 c=0.9 k=0.1", "w=20 c=0.5"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const auto frames = now.points("rolling", 7);
    for(const auto& frame : judged(frames, Plane::rough, ball, g.fifty(), asked.angle(), w.fifty()))
    {
      CHECK(frame.told.value("t") == between(frame.earliest, frame.latest, "in their order"));
      CHECK(frame.pressure == between(-1e-9, infinity, "the plane bears it, to the last frame"));
      for(const Judged_ball::Number& one : frame.numbers())
        CHECK(one.told == within(one.right, frame.slack, Judged_ball::because));
    }
  }
}

CHECK_THAT("the table and the figure are the friction that the accelerations of rolling ask for")
{
  for(const Told& now : told_at("c=1.5 k=0.1"))
    CHECK(now.rows("angles").front().value("w_free", Unit{"1/s"})
          == infinite("G is below the plane, and nothing frees it there"));
  for(const Told& now : told_at("", "c=0.5 k=0.5 g=0.5 w=0.7", "a=1e-60 c=1e-62 k=1e-60 g=1e40 w=1e48",
                                "c=0.999999999 k=1e-9"))
  {
    int sixth = 0;  // of half a turn
    for(const auto& row : now.rows("angles"))
    {
      const Fifty Phi = sixth++ * exact::pi() / 6;
      const auto rolls = rolling_accelerations<Fifty>(exact_ball(a, c, k), g.fifty(), Phi, w.fifty());
      const char* const because = "fifty digits, rounded once";
      CHECK(row.value("Phi", degrees) == within_ulps(Phi, 1, "steps of 30°"));
      if(row.at("Phi", degrees) < 0.01 || row.at("Phi", degrees) > 3.14)
      {
        CHECK(row.value("turning", Unit{"1/s²"}) == within(0, 0, "no arm"));
        CHECK(row.value("lambda") == within(0, 0, "no friction"));
      }
      else
      {
        CHECK(row.value("turning", Unit{"1/s²"}) == within_ulps(rolls.Phi, 1, because));
        CHECK(row.value("lambda") == within_ulps(lambda_at(Phi, w.fifty()), 1, because));
      }
      CHECK(row.value("pressure") == within_ulps(rolls.pressure, 1, because));
      if(const Fifty vv = free_square(Phi); vv >= 0)
        CHECK(row.value("w_free", Unit{"1/s"}) == within_ulps(sqrt(vv), 1, because));
      else
        CHECK(row.value("w_free", Unit{"1/s"}) == infinite("no velocity is great enough"));
    }
    CHECK(sixth == 7);
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
