#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/asked.hpp"
#include "globe/ball.hpp"
#include "globe/scene.hpp"
#include "globe/scene_judge.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 10, "On a smooth plane")

using namespace globe;

/*!
## What Euler does

Without friction the centre of gravity goes forward uniformly, and one equation is left for the turning alone.
With this the first of the two cases begins for which it is known what $\lambda$ is to be: the plane is
smooth, $\lambda = 0$. The first of the three equations ({{sec globe.06}}) then says that $ddx = 0$; hence
$dx/dt$ is constant. If $G$ had the horizontal velocity $f$ at the beginning, it keeps it, and since $x$ and
$\Phi$ vanish together, $CGA$ being upright at first,

$$ \frac{dx}{dt} = f, \quad x = ft, \tag{1} $$

$$ s = ft + c\sin\Phi. \tag{2} $$

The second equation gives the pressure, the third the turning,

$$ \Pi = P + \frac{P\,ddy}{2g\,dt^2}, \tag{3} $$

$$ \frac{Pkk\,dd\Phi}{2g\,dt^2} = -\Pi c\sin\Phi, \tag{4} $$

and with the one put into the other, $P$ goes out:

$$ kk\,dd\Phi + c\,ddy\sin\Phi = -2gc\,dt^2\sin\Phi. \tag{5} $$

Now $y = a - c\cos\Phi$, so that $ddy = c\,dd\Phi\sin\Phi + c\,d\Phi^2\cos\Phi$ by {{sec globe.03}}, and
there comes

$$ \begin{aligned} kk\,dd\Phi &+ cc\,dd\Phi\sin^2\Phi\\ &+ cc\,d\Phi^2\sin\Phi\cos\Phi\\
   &= -2gc\,dt^2\sin\Phi, \end{aligned} \tag{6} $$

which has two variables only, the angle $\Phi$ and the time $t$. The radius $a$ is not in it. In our copy the
first member of {{eq 4}} is past reading; {{eq 5}} restores it.

::: margin
Today: $2g$ is the acceleration of gravity, $\Pi$ the normal force. With $\theta = \Phi$,
$(k^2 + c^2\sin^2\theta)\,\ddot\theta + c^2\dot\theta^2\sin\theta\cos\theta = -2gc\sin\theta$.
:::

Euler does not ask what {{eq 4}} says of the pressure. The ball is turned back by the pressure and by nothing
else. As long as $\Pi$ is positive the turning is slowed while $G$ goes up and quickened while it goes down;
where {{eq 4}} would turn it the other way the plane would have to pull, and the ball leaves it.

## The program

To have the angular velocity at any place the program takes its square from {{sec globe.11}}, the integral of
{{eq 6}}, with ζ for the angular velocity at the lowest place.
*/

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto f = real("f", 3, Unit{"ft/s"}, closed(-1e100, 1e100), "horizontal velocity of G");
const auto zeta = real("zeta", 8, Unit{"1/s"}, scale, "angular velocity at the lowest place");
const auto where = asked_place(60_deg);

Fifty exact_h()
{
  return zeta.fifty() * zeta.fifty() * k.fifty() * k.fifty() / (8 * g.fifty() * c.fifty());
}

Fifty acceleration(const Place<Fifty>& at, const Fifty& pressure)  // (4), ddΦ/dt²
{
  return 0 - 2 * g.fifty() * c.fifty() / (k.fifty() * k.fifty()) * (2 * at.s * at.c) * pressure;
}

Fifty velocity_of_C(const Place<Fifty>& at, const Fifty& w)  // ds/dt, from (2)
{
  return f.fifty() + c.fifty() * w * (at.c * at.c - at.s * at.s);
}

TELL
{
  require(c <= 100 * k, "c", "at most a hundred times k");
  require(exact_h() >= 1e-100, "zeta", "an h between 1e-100 and 1e100");
  require(exact_h() <= 1e100, "zeta", "an h between 1e-100 and 1e100");
  const Energy<Fifty> e = energy(exact_h());
  const Place<Fifty> there = where.fifty();
  require(gets_to(e, there), where.psi == 0 ? "Phi" : "psi", "an angle that the ball gets to");
  const Fifty c_ = c.fifty(), k_ = k.fifty(), pressure = smooth::pressure(c_, k_, e, there);
  const Fifty w = sqrt(2 * g.fifty() * c_ * smooth::velocity_squared(c_, k_, e, there));
  tell("h", double(e.h), "the motion at the lowest place, as a part of what the top asks for");
  tell("w", double(w), Unit{"1/s"}, "angular velocity dΦ/dt at Φ");
  tell("pressure", double(pressure), "Π/P there, the pressure as a part of the weight");
  tell("acceleration", double(acceleration(there, pressure)), Unit{"1/s²"}, "ddΦ/dt² there");
  tell("v", double(velocity_of_C(there, w)), Unit{"ft/s"},
       "ds/dt there, the velocity of C and of the point of contact");
  tell("zeta_lift", velocity_of_energy<double>(c, k * k, g, energy(smooth::lift_off_energy<double>(c, k))),
       Unit{"1/s"}, "the ζ beyond which the ball leaves the plane");
}

TELL
{
  curve("path", {"t", "x", "y", "s", "C"}, [](Curve& path) {
    const auto e = energy_of_velocity<double>(c, k * k, g, zeta);
    const double all = std::min(4 * smooth::quarter<double>(c, k, e), 20 * k);
    const double second = std::sqrt(2 * g) * std::sqrt(c);
    for(int n = 0; n <= 32; ++n)
    {
      const double turned = smooth::angle(c, k, e, n * all / 32).Phi, t = n * all / 32 / second;
      path.put({t, f * t, a - c * std::cos(turned), f * t + c * std::sin(turned), a});
    }
  });
}

TELL
{
  const auto e = energy_of_velocity<double>(c, k * k, g, zeta);
  if(can_be_seen({a, c, k}, e.h))
    scene_of_ball("turning", smooth_motion({a, c, k}, g, e, f / a));
}

/*!
At 60° the ball still turns with {{w|4}} of the 8 radians a second that it had. The plane bears
{{pressure|4}} of the weight there, and its centre, which at the lowest place runs ahead of $G$, goes at
{{v|4}} feet a second. It would leave the plane, on its way over the top, if ζ were more than {{zeta_lift|4}}.

::: figure globe-10
alt: Two rows of dots against the way. One is the path of G, a wave whose dots are equally far apart
horizontally; the other the straight path of C, at the mean height of the wave, whose dots crowd and spread.
A short line joins each dot of one to that of the other.

$G$ (blue) and $C$ (ink) at equal intervals of time, through two turns. $G$ gains the same length in each;
$C$ hurries while $G$ is low and lags while it is high. The heights are drawn larger than the lengths.
:::

::: scene turning
alt: A ball on a level line, its centre of gravity marked below the centre; a grey wave is the way of that
point.

The ball in true time and in its proportions, through two turns, or one period where it rocks. Watch $G$: it
gains evenly, whatever the ball does about it. Where ζ is beyond {{zeta_lift|4}} the scene ends when the ball
leaves the plane.
:::

## Checks

The told values are held against the three equations of {{sec globe.06}} and {{sec globe.07}}, solved
together, with the angular velocity that the loss of living force leaves.
*/

Fifty w_squared(const Fifty& angle)  // what ζζkk − 4gc(1 − cos Φ) leaves
{
  const Fifty s = c.fifty() * sin(angle), k_ = k.fifty();
  return (zeta.fifty() * zeta.fifty() * k_ * k_ - 4 * g.fifty() * c.fifty() * (1 - cos(angle)))
         / (k_ * k_ + s * s);
}

CHECK_THAT("the values told satisfy the equations of motion, all three, whatever the scale")
{
  for(const Told& now :
      told_at("", "zeta=5 Phi=60 f=-2", "c=50 k=1 zeta=1e20 Phi=150 g=1e-50 f=1e15", "c=1e-60 Phi=0",
              "zeta=5.892556509887896 Phi=179.999999", "zeta=18.63 psi=1e-9"))
  {
    const Fifty at = where.angle(), w = sqrt(w_squared(at)), g_ = g.fifty(), c_ = c.fifty(), k_ = k.fifty();
    const auto moved = accelerations<Fifty>(Ball<Fifty>{a.fifty(), c_, k_}, g_, at, w, 0);
    CHECK(moved.x == within(0, 1e-40, "(1): nothing pushes G forward or back"));
    CHECK(moved.Phi * (k_ * k_ + pow(c_ * sin(at), 2)) + pow(c_ * w, 2) * sin(at) * cos(at)  // (6)
          == within(-2 * g_ * c_ * sin(at), 1e-44 * double(1 + pow(c_ * w, 2)), "fifty digits"));
    CHECK(k_ * k_ * moved.Phi + c_ * moved.y * sin(at)  // (5)
          == within(-2 * g_ * c_ * sin(at), 1e-44 * double(1 + pow(c_ * w, 2)), "fifty digits"));
    CHECK(moved.pressure == within_relative(1 + moved.y / (2 * g_), 1e-42, "(3)"));
    CHECK(now.value("h") == within_ulps(exact_h(), 1, "rounded once"));
    CHECK(now.value("w", Unit{"1/s"}) == within_ulps(w, 1, "the integral of (6), rounded once"));
    CHECK(now.value("pressure") == within_ulps(moved.pressure, 1, "rounded once"));
    CHECK(now.value("acceleration", Unit{"1/s²"}) == within_ulps(moved.Phi, 1, "rounded once"));
    CHECK(now.value("v", Unit{"ft/s"}) == within_ulps(f.fifty() + c_ * w * cos(at), 1, "rounded once"));
    // At the top: 1 = c w²/2g, with what is left of the living force there.
    CHECK(now.value("zeta_lift", Unit{"1/s"})
          == within_relative(sqrt(8 * g_ * c_ / (k_ * k_) + 2 * g_ / c_), 1e-14, "some roundings"));
  }
}

CHECK_THAT(
    "it refuses a c or an h beyond its limits and an angle that the ball does not get to, none before them")
{
  // With c = 1/8 and g = k = 1 h is ζζ, with c = 1/2 a quarter of that; and a ball with h = 1/4 gets to 60°.
  for(const char* const beyond :
      {"c=50.00000000000001 k=0.5 Phi=0", "c=100.00000000000002 k=1 Phi=0",
       "c=0.125 g=1 k=1 Phi=0 zeta=9.9999999999999999e-51", "c=0.125 g=1 k=1 zeta=1.0000000000000001e50",
       "c=0.125 g=1 k=1 zeta=0.5 Phi=60.00000000000001", "c=0.125 g=1 k=1 zeta=0.5 psi=119.99999999999999",
       "c=0.5 g=1 k=1 zeta=1 Phi=60.00000000000001"})
    CHECK(refused_at(beyond));
  for(const char* const within_them :
      {"c=50 k=0.5 Phi=0", "c=100 k=1 Phi=0", "c=0.125 g=1 k=1 Phi=0 zeta=1.0000000000000001e-50",
       "c=0.125 g=1 k=1 zeta=1e50", "c=0.125 g=1 k=1 zeta=0.5 Phi=60", "c=0.125 g=1 k=1 zeta=0.5 psi=120",
       "c=0.5 g=1 k=1 zeta=1 Phi=60"})
    CHECK(!refused_at(within_them));
}

CHECK_THAT("the path drawn is that of Newton's equations, G going uniformly")
{
  for(const Told& now : told_at(""))
  {
    const Ball<Fifty> ball{a.fifty(), c.fifty(), k.fifty()};
    const auto motion = [&](const Fifty&, const exact::State& s) {
      const auto moved = accelerations<Fifty>(ball, g.fifty(), s[2], s[3], 0);
      return exact::State{s[1], moved.x, s[3], moved.Phi};
    };
    for(const auto& point : now.points("path", 4))
    {
      const Fifty t = point.at("t");
      const exact::State there = t == 0 ? exact::State{0, f.fifty(), 0, zeta.fifty()}
                                        : exact::solve(motion, 0, {0, f.fifty(), 0, zeta.fifty()}, t).y;
      CHECK(point.value("t") == between(0, 4, "the time of two turns"));
      CHECK(point.value("x") == within(there[0], 1e-14, "(1)"));
      CHECK(point.value("C") == within(ball.a, 0, "the height of C, as given"));
      CHECK(point.value("y") == within(ball.a - ball.c * cos(there[2]), 1e-14, "the height of G"));
      CHECK(point.value("s") == within(there[0] + ball.c * sin(there[2]), 1e-14, "(2)"));
    }
  }
}

CHECK_THAT("the scene is the ball as the equations of motion have it, up to where the plane bears nothing")
{
  for(const Told& now : told_at("", "zeta=5 f=-2 a=2 c=0.9 Phi=10", "c=0.9 k=0.3 zeta=20 f=1 g=3"))
  {
    const auto frames = now.points("turning", 7);
    const Ball<Fifty> ball{a.fifty(), c.fifty(), k.fifty()};
    for(const auto& frame : judged(frames, Plane::smooth, ball, g.fifty(), 0, zeta.fifty(), f.fifty()))
    {
      CHECK(frame.told.value("t") == between(frame.earliest, frame.latest, "in their order"));
      CHECK(frame.pressure == between(-1e-9, infinity, "the plane bears it, to the last frame"));
      for(const Judged_ball::Number& one : frame.numbers())
        CHECK(one.told == within(one.right, frame.slack, Judged_ball::because));
    }
    if(exact_h() > smooth::lift_off_energy<Fifty>(ball.c, ball.k))
    {
      const Fifty u = cos(Fifty(frames.back().at("Phi"))), kk = ball.k * ball.k, cc = ball.c * ball.c;
      const Fifty ww = 8 * g.fifty() * ball.c * (exact_h() - (1 - u) / 2) / (kk + cc * (1 - u * u));
      CHECK(accelerations<Fifty>(ball, g.fifty(), frames.back().at("Phi"), sqrt(ww), 0).pressure
            == within(0, 1e-12, "the angle is rounded"));
    }
  }
}

CHECK_THAT("just below the ζ told the plane bears something at the top, just above it would have to pull")
{
  for(const double more : {-1e-9, 1e-9})
  {
    const Fifty h = smooth::lift_off_energy(our_ball<Fifty>.c, our_ball<Fifty>.k) + more;
    const Fifty w2 = 8 * our_g<Fifty> * our_ball<Fifty>.c * (h - 1) / pow(our_ball<Fifty>.k, 2);
    const auto top = accelerations<Fifty>(our_ball<Fifty>, our_g<Fifty>, exact::pi(), sqrt(w2), 0);
    CHECK((top.pressure > 0) == (more < 0));
  }
}

/*!
## Notes

That the radius does not come in is peculiar to the smooth plane: the pressure goes through $C$, however far
below it acts.

## Go on from here

::: exercise
How fast must the ball turn at its lowest place for the plane to bear there just twice the weight, and what
does it bear then at the top?
answer: At the lowest place {{eq 3}} is $1 + c\zeta\zeta:2g$ times the weight, so $\zeta\zeta = 2g:c$. At the
top $w^2$ is less by $8gc:kk$, and the plane bears $1 - cw^2:2g = 4cc:kk$ of the weight. For our ball $\zeta$
is 17.68, and a ninth is left.
:::
*/

CHECK_THAT("with ζζ = 2g:c the plane bears twice the weight below and 4cc:kk of it at the top")
{
  for(const Told& now : told_at("zeta=17.677669529663688 Phi=0"))
    CHECK(now.value("pressure") == within(2, 1e-15, "the rounding of ζ"));
  for(const Told& now : told_at("zeta=17.677669529663688 Phi=180"))
    CHECK(now.value("pressure") == within(Fifty(1) / 9, 1e-15, "the rounding of ζ"));
}
