#include "edition/section.hpp"
#include "exact/quadrature.hpp"

SECTION(globe, 3, "Where G is, and whether the ball scrapes")

/*!
## What Euler does

The place of $G$ follows from two variables only, the way $s$ and the angle Φ, and they also decide whether
the ball scrapes over the plane. A horizontal $GQ$ to the radius $CS$ cuts off $GQ = c\sin\Phi$ and
$CQ = c\cos\Phi$, hence

$$ x = s - c\sin\Phi, \qquad y = a - c\cos\Phi. \tag{1} $$

Differentiated once,

$$ dx = ds - c\,d\Phi\cos\Phi, \qquad dy = c\,d\Phi\sin\Phi, \tag{2} $$

and twice,

$$ \begin{aligned} ddx &= dds - c\,dd\Phi\cos\Phi\\ &\quad + c\,d\Phi^2{{entry square_x}}\sin\Phi,\\
   ddy &= c\,dd\Phi\sin\Phi + c\,d\Phi^2{{entry square_y}}\cos\Phi; \end{aligned} \tag{3} $$

these will be needed to find the motion.

::: margin
Today: the velocity and acceleration of a point of a rigid body. In {{eq 3}} $c\,d\Phi^2$ is the centripetal
part, which points from $G$ to $C$.
:::

If friction is to be taken into account, one must first see how the point $S$ of the ball moves along $IO$.
If the ball did not turn, this point would have the velocity $ds/dt$ towards $O$, like every other. The
turning by which Φ grows pushes it back with the velocity $a\,d\Phi/dt$. It moves on, therefore, with

$$ \frac{ds}{dt} - \frac{a\,d\Phi}{dt}, \tag{4} $$

and there are three cases. If $ds = a\,d\Phi$ the ball rolls perfectly. If $ds > a\,d\Phi$ it scrapes the
plane towards $O$, and friction acts in the opposite direction, along $SI$; if $a\,d\Phi > ds$ the rubbing
is towards $I$, and friction acts along $SO$.

$S$ means three things here, and it is well to keep them apart. The *place* of contact moves with the
velocity $ds/dt$, always, for it is below $C$. The *point of the ball* that is there has the velocity
{{eq 4}}, and it alone matters for friction. The point of the plane has none.

That {{eq 4}} is a difference deserves a thought where one calculates: near rolling it is small, and $s$ and
Φ do not know it well. With σ for it, {{eq 2}} may also be written with what is known,

$$ \frac{dx}{dt} = \sigma + (a - c\cos\Phi)\frac{d\Phi}{dt}, \tag{A} $$

and from {{sec globe.08}} on the programs keep σ itself, not $ds/dt$.

## The program

The reader gives the ball, its attitude, and the four rates.
*/

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the centre to the centre of gravity");
const auto Phi = angle("Phi", 60_deg, closed(-1e12_deg, 1e12_deg), "angle ACS, all turns counted");
const auto v = real("v", 3, Unit{"ft/s"}, closed(-1e60, 1e60), "ds/dt, velocity of the centre");
const auto w = real("w", 4, Unit{"1/s"}, closed(-1e60, 1e60), "dΦ/dt, angular velocity");
const auto dv = real("dv", 5, Unit{"ft/s²"}, closed(-1e60, 1e60), "dds/dt²");
const auto dw = real("dw", 6, Unit{"1/s²"}, closed(-1e60, 1e60), "ddΦ/dt²");

struct Rates
{
  Fifty x, y;
};

Rates first()  // (2)
{
  const Fifty turning = c.fifty() * w.fifty();
  return {v.fifty() - turning * cos(Phi.fifty()), turning * sin(Phi.fifty())};
}

Rates second()  // (3)
{
  const Fifty faster = c.fifty() * dw.fifty(), inward = c.fifty() * w.fifty() * w.fifty();
  const Fifty sine = sin(Phi.fifty()), cosine = cos(Phi.fifty());
  return {dv.fifty() - faster * cosine + inward * sine, faster * sine + inward * cosine};
}

Fifty scraping()  // (4)
{
  return v.fifty() - a.fifty() * w.fifty();
}

TELL
{
  const Unit velocity{"ft/s"}, acceleration{"ft/s²"};
  tell("dx", double(first().x), velocity, "dx/dt", 15);
  tell("dy", double(first().y), velocity, "dy/dt", 15);
  tell("ddx", double(second().x), acceleration, "ddx/dt²", 15);
  tell("ddy", double(second().y), acceleration, "ddy/dt²", 15);
  const Fifty sigma = scraping();
  tell("sigma", double(sigma), velocity, "ds/dt − a dΦ/dt, velocity of the ball's point at S", 15);
  const char* const moves = sigma == 0 ? "rolls" : sigma > 0 ? "scrapes towards O" : "scrapes towards I";
  const char* const acts = sigma == 0  ? "only as far as rolling asks for it"
                           : sigma > 0 ? "along SI, backwards"
                                       : "along SO, forwards";
  tell("ball", moves, "what the ball does");
  tell("friction", acts, "how friction acts");
}

TELL
{
  curve("paths", {"ratio", "Phi", "A_x", "A_y", "G_x", "G_y"}, [](Curve& paths) {
    const double r = c / a;  // lengths in radii
    for(const double ratio : {1.6, 1.0, 0.4})
    {
      for(int n = -60; n <= 180; ++n)
      {
        const double turned = n * 3_deg, way = ratio * turned;
        paths.put({ratio, turned, way - std::sin(turned), 1 - std::cos(turned), way - r * std::sin(turned),
                   1 - r * std::cos(turned)});
      }
      paths.block();
    }
  });
}

/*!
In the state of the example the ball turns faster than it advances: its point at $S$ moves with {{sigma|4}}
feet a second, so it {{ball}}, and friction acts {{friction}}. $G$ lags behind the centre, {{dx|4}} feet a
second against 3, and is on its way up.

::: figure globe-03
alt: Three curves, one above the other, on three horizontal lines. The uppermost touches its line in smooth,
wide waves; the middle one comes down to its line in sharp points; the lowest makes small loops on its line.

Three ways of moving told by their traces: the path of the point $A$ of the surface (blue) through two
turns, and that of $G$ (grey). Where $A$ comes to the plane it scrapes on towards $O$, or stops dead in
a cusp, or goes back, $ds$ being 1.6, 1 and 0.4 times $a\,d\Phi$.
:::

## Checks

Against the differentials stand differences, as small as fifty digits allow, of a motion that has the rates
of the example: $G$ before, at and after the moment.
*/

struct Sample
{
  Fifty before, now, after, step;

  Fifty rate() const { return (after - before) / (2 * step); }
  Fifty curvature() const { return (after - 2 * now + before) / (step * step); }
};

Fifty unit_of_time()  // in which nothing turns by more than a little
{
  const Fifty fast = abs(w.fifty()) + sqrt(abs(dw.fifty()));
  return fast == 0 ? Fifty(1) : 1 / fast;
}

Sample sample(const std::function<Fifty(const Fifty& way, const Fifty& turn)>& quantity)
{
  const Fifty h = unit_of_time() * 1e-12;
  const auto at = [&](const Fifty& t) {
    return quantity(v.fifty() * t + dv.fifty() * t * t / 2, w.fifty() * t + dw.fifty() * t * t / 2);
  };
  return {at(-h), at(0), at(h), h};
}

Sample forward(const Fifty& distance,
               const Fifty& angle)  // of what is so far from C, at that angle from CS
{
  return sample([&](const Fifty& way, const Fifty& turn) { return way - distance * sin(angle + turn); });
}

Sample upward(const Fifty& distance, const Fifty& angle)
{
  return sample([&](const Fifty&, const Fifty& turn) { return 0 - distance * cos(angle + turn); });
}

CHECK_THAT("the differentials told are what differences come to, at every attitude, speed and size")
{
  const Unit velocity{"ft/s"}, acceleration{"ft/s²"};
  for(const Told& now :
      told_at("", "Phi=-200 v=-7 dw=-30", "v=1e40 w=1e-40 Phi=179.99999 a=1e50 c=1e50 dv=0 dw=1e-60",
              "w=0 dw=0 v=0 dv=-2", "Phi=1e12 c=1e-100 w=-1e60"))
  {
    const Sample x = forward(c.fifty(), Phi.fifty()), y = upward(c.fifty(), Phi.fifty());
    const Fifty T = unit_of_time();
    const Fifty size = abs(v.fifty()) + abs(dv.fifty()) * T + c.fifty() / T;
    const char* const because = "the square of the step, 1e-24, and one rounding";
    const auto near = [&](const Fifty& expected, const Fifty& of) {
      return within(expected, 2e-16 * double(abs(expected)) + 1e-22 * double(of), because);
    };
    CHECK(now.value("dx", velocity) == near(x.rate(), size));
    CHECK(now.value("dy", velocity) == near(y.rate(), c.fifty() / T));
    CHECK(now.value("ddx", acceleration) == near(x.curvature(), size / T));
    CHECK(now.value("ddy", acceleration) == near(y.curvature(), c.fifty() / T / T));
    // The point of the ball that is at S.
    const Fifty at_S = forward(a.fifty(), 0).rate();
    CHECK(now.value("sigma", velocity) == near(at_S, abs(v.fifty()) + a.fifty() / T));
  }
}

CHECK_THAT("what the ball is told to do is what its point at S does, down to the last digit of the rates")
{
  for(const Told& now : told_at("", "v=4", "v=4.000000000000001", "a=0.1 w=3 v=0.3",
                                "a=0.1 w=3 v=0.29999999999999998", "w=-5 v=-5.1"))
  {
    const Fifty at_S = v.fifty() + a.fifty() * -w.fifty();
    const bool rolls = abs(at_S) < 1e-40;  // no two inputs of so few digits differ by less
    CHECK(now.value("ball") == (rolls ? "rolls" : at_S > 0 ? "scrapes towards O" : "scrapes towards I"));
    CHECK(now.value("friction")
          == (rolls      ? "only as far as rolling asks for it"
              : at_S > 0 ? "along SI, backwards"
                         : "along SO, forwards"));
    CHECK(now.value("sigma", Unit{"ft/s"})
          == within_ulps(at_S, 0.51, "rounded once, even where it is small"));
    // (A): from σ and the height of G.
    const Fifty y = a.fifty() - c.fifty() * cos(Phi.fifty());
    CHECK(now.value("dx", Unit{"ft/s"}) == within_ulps(at_S + y * w.fifty(), 0.51, "rounded once"));
  }
}

CHECK_THAT(
    "the paths drawn are the velocities added up, and A goes forwards, rests or goes back on the plane")
{
  for(const Told& now : told_at("", "c=0.9", "a=3e50 c=2e50"))
    for(const auto& point : now.points("paths", 16))
    {
      const Fifty ratio = point.at("ratio"), turned = point.at("Phi");
      const auto added = [&](const Fifty& r, bool up) {
        return exact::integrate(
                   [&](const Fifty& p) { return up ? Fifty(r * sin(p)) : Fifty(ratio - r * cos(p)); }, 0,
                   turned)
            .value;
      };
      const Fifty r = c.fifty() / a.fifty();
      const char* const because = "a product and a sine";
      CHECK(point.value("A_x") == within(added(1, false), 8e-15, because));
      CHECK(point.value("A_y") == within(added(1, true), 2e-15, because));
      CHECK(point.value("G_x") == within(added(r, false), 8e-15, because));
      CHECK(point.value("G_y") == within(1 - r + added(r, true), 2e-15, because));
      CHECK(point.value("ratio") == between(0.4, 1.6, "one of the three"));
      CHECK(point.value("Phi") == between(-3.15, 9.43, "from half a turn before to one and a half after"));
    }
}

/*!
In our copy the exponent of $d\Phi$ is a star in both lines of {{eq 3}}. Differences of another motion
decide.
*/

Fifty differences(bool up)  // of s = t/7 + tt, Φ = 1 + 3t + 2tt at t = 0, the ball's c being 1/10
{
  const Fifty h = 1e-12;
  const auto at = [&](const Fifty& t) {
    const Fifty angle = 1 + 3 * t + 2 * t * t;
    return up ? Fifty(-cos(angle) / 10) : Fifty(t / 7 + t * t - sin(angle) / 10);
  };
  return (at(h) - 2 * at(0) + at(-h)) / (h * h);
}

double ddx(int power)
{
  return 2 - 0.4 * std::cos(1.) + 0.1 * std::pow(3., power) * std::sin(1.);
}

double ddy(int power)
{
  return 0.4 * std::sin(1.) + 0.1 * std::pow(3., power) * std::cos(1.);
}

const Emendation square_x{
    "§3, ddx, the last term",
    {"dΦ*", ddx(1)},
    {"dΦ²", ddx(2)},
    "the second differences of x come to that",
    [](double reading) { return reading == within(differences(false), 1e-15, "some roundings"); }};

const Emendation square_y{
    "§3, ddy, the last term",
    {"dΦ*", ddy(1)},
    {"dΦ²", ddy(2)},
    "the second differences of y come to that",
    [](double reading) { return reading == within(differences(true), 1e-15, "some roundings"); }};

/*!
## Go on from here

::: exercise
When the ball rolls its point at $S$ is at rest. Is it so only for a moment, and with what acceleration does
it leave?
answer: Upwards with $a\,d\Phi^2/dt^2$, and not at all forwards or backwards, however the rolling is
quickened or slowed; that is why a path with cusps meets the plane at a right angle.
:::
*/

CHECK_THAT("the point at S of a ball that rolls leaves it straight upwards, with the acceleration aww")
{
  for(const Told& now : told_at("v=4 dv=6", "v=-15 a=3 w=-5 dw=7 dv=21"))
  {
    CHECK(now.value("ball") == "rolls");
    CHECK(forward(a.fifty(), 0).curvature() == within(0, 1e-20, "the square of the step"));
    CHECK(upward(a.fifty(), 0).curvature()
          == within_relative(a.fifty() * w.fifty() * w.fifty(), 1e-20, "the square of the step"));
  }
}
