#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/asked.hpp"
#include "globe/ball.hpp"
#include "globe/oracle.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 12, "The living force")

using namespace globe;

/*!
## What Euler does

The living force of the ball is what it was given, less what the rise of its centre of gravity has cost.
It has two parts. That of the turning is, with the velocity of {{sec globe.11}},

$$ \frac{Pkk\,d\Phi^2}{dt^2} = \frac{Pkk\,(4gc\cos\Phi + \zeta\zeta kk - 4gc)}{kk + cc\sin^2\Phi}; \tag{1} $$

that of the progress of the centre of gravity is

$$ P\Bigl(\frac{dx^2}{dt^2} + \frac{dy^2}{dt^2}\Bigr), \tag{2} $$

where $dx:dt = f$ by {{sec globe.10}}, and, since $dy = c\,d\Phi\sin\Phi$,

$$ \begin{aligned} &\frac{dy^2}{dt^2} = \frac{d\Phi^2}{dt^2}cc\sin^2\Phi \\
   &= \frac{(4gc\cos\Phi + \zeta\zeta kk - 4gc)cc\sin^2\Phi}{kk + cc\sin^2\Phi}. \end{aligned} \tag{3} $$

Added together they lose their denominator, and the whole living force is

$$ \begin{aligned} &P\Bigl(ff + \frac{d\Phi^2}{dt^2}(kk + cc\sin^2\Phi){{entry bracket}}\Bigr) \\
   &= P(ff + 4gc\cos\Phi + \zeta\zeta kk - 4gc), \end{aligned} \tag{4} $$

$$ P\bigl(ff + \zeta\zeta kk - 4gc(1-\cos\Phi)\bigr). \tag{5} $$

Here $P(ff + \zeta\zeta kk)$ is the living force that was impressed on the ball in the beginning. It grows
less as $G$ climbs; for $c(1-\cos\Phi)$ is the height through which $G$ has risen since the start, when it
was at its lowest. In our copy one $dt$ of {{eq 2}} has lost its exponent, and {{eq 4}} a pair of brackets.

::: margin
Today: twice the kinetic energy, $m v^2 + I\omega^2$, with weights for masses. A 4g-th part of it is a
height: that to which the weight could be lifted.
:::

Euler proves the law here from the formulae; he does not say why it must be so. The pressure of a smooth
plane is upright, and the point of the ball on which it acts moves along the plane: it does no work. What
it does is to carry living force from one part to another. The horizontal part $Pff$ it never touches. The
other two are parts of one motion, and whatever the energy, the upright part is to the turning one as

$$ cc\sin^2\Phi : kk. \tag{A} $$

So in the lowest place and at the top all is turning. At 90° the share of the rise and fall is greatest;
in a ball with $c > k$ it is then the greater one.

## The program

The three parts are told apart, each over $P$, so that none is lost in a greater one.
*/

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto f = real("f", 3, Unit{"ft/s"}, closed(-1e100, 1e100), "horizontal velocity of G");
const auto asked = asked_energy(2);
const auto where = asked_place(60_deg);

/// Living forces over P.
struct Parts
{
  Fifty turning;  ///< (1)
  Fifty upright;  ///< (3)
  Fifty lost;     ///< the last member of (5)
};

Parts parts(const Fifty& c, const Fifty& k, const Fifty& g, const Energy<Fifty>& e,
            const Place<Fifty>& there)
{
  const Fifty ww = 2 * g * c * smooth::velocity_squared<Fifty>(c, k, e, there);
  const Fifty sine = 2 * there.s * there.c;
  return {k * k * ww, ww * pow(c * sine, 2), 8 * g * c * there.s * there.s};  // (1), (3), (5)
}

TELL
{
  const Unit squares{"ft²/s²"};
  const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty();
  const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g_);
  const Place<Fifty> there = where.fifty();
  require(gets_to(e, there), where.psi == 0 ? "Phi" : "psi", "an angle that the ball gets to");
  require(e.h * c_ <= 1e100, asked.given(), "an energy h of at most 1e100 over c");
  require(e.h * g_ <= 1e100, asked.given(), "an energy h of at most 1e100 over g");
  const Parts now = parts(c_, k_, g_, e, there);
  const Fifty forwards = f.fifty() * f.fifty();
  tell("turning", double(now.turning), squares, "of the turning, kk(dΦ/dt)², (1)");
  tell("forwards", double(forwards), squares, "of the progress forwards, ff");
  tell("upright", double(now.upright), squares, "of the progress upwards, (dy/dt)², (3)");
  tell("whole", double(forwards + now.turning + now.upright), squares, "the whole");
  tell("impressed", double(forwards + 8 * g_ * c_ * e.h), squares, "what was impressed, ff + ζζkk");
  tell("lost", double(now.lost), squares, "what the rise of G has cost, 4gc(1 − cos Φ)");
  const Fifty side = c_ * 2 * there.s * there.c;
  tell("share", double(side * side / (side * side + k_ * k_)), percent,  // (A), at rest, too
       "the upright part's share of what is not ff");
}

TELL
{
  curve("parts", {"Phi", "turning", "upright", "alike"}, [](Curve& curve) {  // alike: turning, if k were c
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty();
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g_);
    const Fifty end = e.turns_over() ? exact::pi() : Fifty(2 * atan2(sqrt(e.h), sqrt(e.from_top)));
    for(int n = -90; n <= 90; ++n)
    {
      const Fifty at = abs(n) * end / 90;
      const Place<Fifty> there =
          n % 90 == 0 && n != 0 ? Place<Fifty>{sin(end / 2), cos(end / 2)} : place(at);
      const Parts now = parts(c_, k_, g_, e, there);
      const Fifty sine = 2 * there.s * there.c;
      curve.put({(n < 0 ? -1 : 1) * double(at * 180 / exact::pi()), double(now.turning),
                 double(now.upright), double((now.turning + now.upright) / (1 + sine * sine))});
    }
  });
}

/*!
With twice the energy for the top our ball has, at 60°, {{turning|6}} square feet per square second in its
turning and {{upright|6}} in the rise of $G$; with the $ff = {{forwards}}$ of its progress the whole is
{{whole|6}}, and the {{lost|6}} that are lacking of {{impressed|6}} are what the rise has cost.

::: figure globe-12
alt: Living force against the angle of one turn, as two layers. The lower, thick one is that of the
turning; the upper one, thin for this ball, that of the rise and fall, which vanishes at the lowest place
and at the ends. Their sum is a smooth wave below the level of what was impressed.

The two parts of the living force that the turning shares with the rise and fall of $G$, over one turn or
swing. Their sum (ink) is a plain cosine; only the parts know of $k$. A ball with its $k$ as small as $c$ and
the same energy would have its turning below the dashed line, and the rise and fall of $G$ between both.
:::

## Checks

The parts are those of the motion that the three equations of {{sec globe.06}} and {{sec globe.07}} bring
about.
*/

CHECK_THAT("the parts told are those of the ball that the equations of motion move, from start to Φ")
{
  const Unit squares{"ft²/s²"};
  for(const Told& now :
      told_at("", "h=0.7 Phi=100 c=0.5 f=-1e8", "zeta=15 Phi=150 f=1e-9", "h=3 c=2 Phi=90"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), second = sqrt(2 * g_ * c_), f_ = f.fifty();
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g_);
    const Ball<Fifty> ball{c_ + k_, c_, k_};
    const Fifty zeta = 2 * second * sqrt(e.h) / k_;
    // The unknowns: x, y and Φ with their velocities.
    const auto motion = [&](const Fifty&, const exact::State& s) {
      const auto moved = accelerations<Fifty>(ball, g_, s[4], s[5], 0);
      return exact::State{s[1], moved.x, s[3], moved.y, s[5], moved.Phi};
    };
    const Fifty t = oracle::smooth_time(c_, k_, e, where.fifty()) / second;
    const exact::State s = exact::solve(motion, 0, {0, f_, 0, 0, 0, zeta}, t).y;
    const Fifty whole = s[1] * s[1] + s[3] * s[3] + pow(k_ * s[5], 2);
    CHECK(now.value("turning", squares) == within_ulps(pow(k_ * s[5], 2), 1, "rounded once"));
    CHECK(now.value("forwards", squares) == within_ulps(s[1] * s[1], 1, "rounded once"));
    CHECK(now.value("upright", squares) == within_ulps(s[3] * s[3], 1, "rounded once"));
    CHECK(now.value("whole", squares) == within_ulps(whole, 1, "rounded once"));
    CHECK(now.value("impressed", squares) == within_ulps(f_ * f_ + pow(zeta * k_, 2), 1, "rounded once"));
    CHECK(now.value("lost", squares) == within_ulps(4 * g_ * s[2], 1, "4g times the rise, rounded once"));
    CHECK(whole + 4 * g_ * s[2]
          == within_relative(f_ * f_ + pow(zeta * k_, 2), 1e-26, "(5), by some hundred steps of 1e-32"));
    CHECK(now.value("share", percent)
          == within_relative(s[3] * s[3] / (s[3] * s[3] + pow(k_ * s[5], 2)), 2e-16, "rounded once"));
    CHECK(s[3] * s[3] / pow(k_ * s[5], 2)
          == within_relative(pow(c_ * sin(s[4]) / k_, 2), 1e-26, "(A), whatever the energy"));
  }
}

CHECK_THAT("the parts and their sum are (1), (3) and (5) at every scale")
{
  const Unit squares{"ft²/s²"};
  for(const Told& now : told_at("", "from_top=1e-15 psi=1e-3 f=0", "h=1e-30 Phi=1e-20 c=3 f=1e-20",
                                "h=1e60 c=1e-60 Phi=90 g=1e-90"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), at = where.angle(), f_ = f.fifty();
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g_);
    const Fifty fall = 8 * g_ * c_ * pow(sin(at / 2), 2), left = 8 * g_ * c_ * e.h - fall;
    const Fifty s = c_ * sin(at), D = k_ * k_ + s * s;
    CHECK(now.value("turning", squares) == within_ulps(k_ * k_ * left / D, 1, "rounded once"));
    CHECK(now.value("upright", squares) == within_ulps(s * s * left / D, 1, "rounded once"));
    CHECK(now.value("forwards", squares) == within_ulps(f_ * f_, 1, "rounded once"));
    CHECK(now.value("whole", squares) == within_ulps(f_ * f_ + left, 1, "rounded once"));
    CHECK(now.value("impressed", squares) == within_ulps(f_ * f_ + 8 * g_ * c_ * e.h, 1, "rounded once"));
    CHECK(now.value("lost", squares) == within_ulps(fall, 1, "rounded once"));
    CHECK(now.value("share", percent) == within_ulps(s * s / D, 1, "rounded once"));
  }
}

CHECK_THAT(
    "it refuses an energy and an angle just beyond its limits, however they are given, and none on them")
{
  // h is ζζ with c = 1/2, g = 1/4 and k = 1, or with g = 1/8, c = k = 1; hc is it with g = 1/8 and k = 1.
  for(const char* const beyond :
      {"from_top=0.5 zeta=1e-300", "c=0.5 g=0.25 k=1 Phi=0 zeta=9.9999999999999999e-51",
       "c=0.5 g=0.25 k=1 zeta=1.0000000000000001e50", "h=0.25 Phi=60.00000000000001",
       "h=0.75 Phi=120.00000000000001", "h=0.25 psi=119.99999999999999", "c=1e50 h=1.0000000000000001e50",
       "c=1e50 from_top=-1.0000000000000001e50", "c=1e50 g=0.125 k=1 zeta=1.0000000000000001e50",
       "g=1e50 h=1.0000000000000001e50", "g=1e60 h=1.0000000000000001e40"})
    CHECK(refused_at(beyond));
  for(const char* const within_them :
      {"from_top=0.5", "c=0.5 g=0.25 k=1 Phi=0 zeta=1.0000000000000001e-50", "c=0.5 g=0.25 k=1 zeta=1e50",
       "h=0.25 Phi=60", "h=0.75 Phi=120", "h=0.25 psi=120", "c=1e50 h=1e50", "c=1e50 from_top=-1e50",
       "c=1e50 g=0.125 k=1 zeta=1e50", "g=1e50 h=1e50", "g=1e60 h=1e40"})
    CHECK(!refused_at(within_them));
}

/*!
Without its brackets {{eq 4}} is no identity: the second member would be an area, added to squares of
velocities. Its number is judged by the motion. Our ball, with $g = 1$, starts with $\zeta = 3$; what is
left of its living force a fifth of a second later must be what was impressed less the rise of $G$.
*/

struct Example
{
  Fifty w2, s2;  // (dΦ/dt)² and (c sin Φ)² then
};

const Example& example()
{
  static const Example then = [] {
    const Ball<Fifty> ball = our_ball<Fifty>;
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1], accelerations<Fifty>(ball, 1, s[0], s[1], 0).Phi};
    };
    const exact::State there = exact::solve(motion, 0, {0, 3}, Fifty("0.2"), Fifty("1e-18")).y;
    return Example{there[1] * there[1], pow(ball.c * sin(there[0]), 2)};
  }();
  return then;
}

const Emendation bracket{
    "§12, the whole living force",
    {"(dΦ²/dt²) kk + cc sin²Φ", double(example().w2* Fifty("0.36") + example().s2)},
    {"(dΦ²/dt²)(kk + cc sin²Φ)", double(example().w2*(Fifty("0.36") + example().s2))},
    "it is to be the sum of (1) and (3), and the motion has that much left",
    [](double reading) {
      const Ball<Fifty> ball = our_ball<Fifty>;
      const auto motion = [&](const Fifty&, const exact::State& s) {
        return exact::State{s[1], accelerations<Fifty>(ball, 1, s[0], s[1], 0).Phi};
      };
      const Fifty Phi = exact::solve(motion, 0, {0, 3}, Fifty("0.2")).y[0];
      return reading == within(9 * ball.k * ball.k - 4 * ball.c * (1 - cos(Phi)), 1e-14, "(5)");
    }};

CHECK_THAT("the layers drawn are (1) and (3), and their sum a plain cosine")
{
  for(const Told& now : told_at("", "h=0.4 c=1"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty();
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g_);
    for(const auto& point : now.points("parts", 9))
    {
      const Fifty at = point.at("Phi") * exact::pi() / 180, s = c_ * sin(at), D = k_ * k_ + s * s;
      const Fifty left = 4 * g_ * c_ * (2 * e.h - 1 + cos(at));
      // An ulp of the angle, of up to 180 degrees, moves the sum by 4gc sin Φ times that.
      const double slack = 1e-14 * double(g_ * c_ * (1 + e.h));
      CHECK(point.value("Phi") == between(-180, 180, "one turn"));
      CHECK(point.value("turning") == within(k_ * k_ * left / D, 8 * slack, "an ulp of the angle"));
      CHECK(point.value("upright") == within(s * s * left / D, 8 * slack, "an ulp of the angle"));
      const Fifty alike = left / (c_ * c_ + s * s) * c_ * c_;  // (1) with kk = cc
      CHECK(point.value("alike") == within(alike, 8 * slack, "an ulp of the angle"));
    }
  }
}

/*!
## Go on from here

::: exercise
At what angle has the upright part the greatest share, and how much is it? When is it greater than that of
the turning?
answer: By {{eq A}} the share is $cc\sin^2\Phi:(kk+cc\sin^2\Phi)$, greatest at 90°, if the ball gets there:
$cc:(kk+cc)$. It is more than a half if $c > k$. With `--c 0.6 --Phi 90` the program finds it to be just a
half.
:::
*/

CHECK_THAT("with c = k the upright part is just half at 90°")
{
  for(const Told& now : told_at("c=0.6 Phi=90", "c=0.6 h=0.5 Phi=90"))  // where h is ½ it stands there
    CHECK(now.value("share", percent) == within_ulps(Fifty(1) / 2, 1, "rounded once"));
}
