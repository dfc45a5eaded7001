#include "edition/section.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/swing.hpp"
#include "tautochrone/thread.hpp"

SECTION(tautochrone, 13, "Two motions in one")

using namespace tautochrone;

/*!
## What Euler does

The speed of the centre of gravity is expressed by the turning of the thread, and the body's motion is
taken apart into a translation and a rotation. Let the pendulum have begun its motion in the vertical $AC$,
where the velocity of the centre of gravity was due to the height $b$ and hence is $\sqrt b$; after the time
$t$ it has come into the position $AMG$, and the velocity of $G$ is now $\sqrt v$. In the next element of
time, $dt$, the centre of gravity goes on to $g$, and the thread comes to touch the cheek in $m$, with
$Mm = ds$. The straight part turns by the angle $GMg = d\varphi$, and since the arc $Gg$ has its centre in
$M$, it is $(a-s)\,d\varphi$. Therefore

$$ \sqrt v = \frac{(a-s)\,d\varphi}{dt}, \qquad v = \frac{(a-s)^2\,d\varphi^2}{dt^2}. \tag{1} $$

While $G$ goes forward, the body also turns, since its inclination to the vertical grows by $d\varphi$. Its
motion is therefore twofold: all its parts advance in the direction $Gg$ with the velocity $\sqrt v$, and at
the same time they go round an axis through $G$ with the angular velocity

$$ \frac{d\varphi}{dt}. \tag{2} $$

Both together are the whole motion of the pendulum; for every motion of a body can be regarded as made up of
one with its centre of gravity and one about an axis through it.

::: margin
Velocities are square roots of heights: $v$ is today's $\dot z^2/2g$.
:::

The point $m$ is new, the thread there is not: as a part of the body, the place of contact $M$ is at rest,
and only *which* point it is changes. This is why $ds$ is not found in {{eq 1}}. It will come back when
{{eq 1}} is differentiated ({{sec tautochrone.14}}).

What the fall from the height $c - x$ has given is shared between the two motions. A body that turns with
the angular velocity {{eq 2}} has a store of motion as if its mass went round at the distance $k$; so that

$$ \begin{gathered} c - x = v + kk\,\frac{d\varphi^2}{dt^2} = v\Bigl(1 + \frac{kk}{rr}\Bigr), \\
  r = a - s. \end{gathered} \tag{A} $$

Euler arrives at this by the laws of motion in {{sec tautochrone.18}}. It says where the trouble with
Huygens's cheeks lies: the wider the swing, the shorter is $r$, and the greater the share that goes to turning
the body and is lost to the speed.

## The program

The body hangs between Huygens's cheeks, where $r = a\cos\varphi$. The two velocities, in lengths of
$a$ and in Euler's clock:

::: code tautochrone/thread.hpp motion (1) (2)
:::
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto phi0 = angle("phi0", 20_deg, closed(1e-90_deg, 89.9_deg), "how far the pendulum swings");
const auto phi = angle("phi", within_swing(10_deg, phi0), closed(0_deg, 89.9_deg),
                       "angle SMG of the thread with the vertical");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

double velocity(double height)  // √v in metres a second
{
  return 2 * std::sqrt(g) * std::sqrt(height);
}

double share(double ratio, double r)  // of the store of motion that is in the rotation, by (A)
{
  const double whole = std::hypot(ratio, r);
  return ratio / whole * (ratio / whole);
}

TELL
{
  require(k / a >= 1e-9, "k", "from 1e-9 a to 1e9 a");
  require(k / a <= 1e9, "k", "from 1e-9 a to 1e9 a");
  const double ratio = k / a;
  const auto here = posture_as_written(Cheeks::cycloids, ratio, phi0, phi),
             below = on_cycloids<double>(phi0, 0);
  const double v = a * speed_height(here, ratio);
  tell("v", v, metres, "height due to the velocity of G");
  tell("b", a * speed_height(below, ratio), metres, "the same in the lowest place");
  tell("velocity", velocity(v), Unit{"m/s"}, "of G along its curve, (1)");
  tell("turning", 2 * std::sqrt(g) / std::sqrt(a) * std::sqrt(turning2(here, ratio)), Unit{"1/s"},
       "dφ/dt, in radians a second, (2)");
  tell("share", share(ratio, here.r), percent, "of what the fall gave, the part that turns the body, (A)");
}

TELL
{
  curve("shares", {"phi", "k1", "k2", "k3", "axis"}, [](Curve& out) {
    for(int i = 0; i <= 80; ++i)
    {
      const double c = std::cos(i * 1_deg);
      out.put({double(i), share(0.1, c), share(0.2, c), share(0.3, c), share(0.3, 1)});
    }
  });
}

/*!
At {{phi}} of a swing to {{phi0}} the centre of gravity moves with {{velocity|6}} metres a second, and
{{share|percent3}} of the store of motion is in the rotation.

::: figure tautochrone-13
alt: The share of the rotation against the angle of the thread. Three curves, for k a tenth, two tenths and
three tenths of a, begin low and rise, steeply beyond 60 degrees. A level line shows that about a fixed axis
the share stays what it is at the bottom.

How much of the store of motion is in the rotation, on Huygens's cheeks. With a fixed axis (grey, $k =
\tfrac3{10}a$) the share stays the same, and the body moves as a point would. On the cheeks it grows as the
thread gets shorter.
:::

## Checks

The judge follows the equation of motion in fifty digits, from rest at the turning point. It does not use
that the store of motion is conserved.
*/

CHECK_THAT("the two velocities and their heights are those of the motion that begins at rest in φ₀")
{
  for(const Told& now :
      told_at("", "a=2 k=0.6 phi0=60 phi=0", "phi0=1e-8 phi=4e-9 k=0.02", "a=1e40 k=3e40 phi0=85 phi=80"))
  {
    const Fifty A = a.fifty(), ratio = k.fifty() / A,
                w = turning2_by_motion(ratio, phi0.fifty(), phi.fifty()), r = cos(phi.fifty());
    const char* const why = "the library's bound, and the angles' rounding";
    CHECK(now.value("v", metres) == within_relative(A * r * r * w, 1e-14, why));
    CHECK(now.value("b", metres)
          == within_relative(A * turning2_by_motion(ratio, phi0.fifty(), 0), 1e-14, why));
    CHECK(now.value("velocity", Unit{"m/s"})
          == within_relative(sqrt(4 * g.fifty() * A * w) * r, 1e-14, why));
    CHECK(now.value("turning", Unit{"1/s"}) == within_relative(sqrt(4 * g.fifty() * w / A), 1e-14, why));
    const Fifty fallen = (cos(2 * phi.fifty()) - cos(2 * phi0.fifty())) / 4;
    CHECK(now.value("share", percent)
          == within_relative(1 - r * r * w / fallen, 1e-14, "what the translation leaves of the fall"));
  }
  for(const Told& now : told_at("phi=19.9999999999", "k=0.01 phi0=89 phi=88.999999999999"))
  {
    const Fifty rr = pow(cos(phi.fifty()), 2), rise = (rr - pow(cos(phi0.fifty()), 2)) / 2;
    CHECK(now.value("v", metres)
          == within_relative(rr * rise / (rr + pow(k.fifty(), 2)), 1e-14, "the angles as written"));
  }
}

CHECK_THAT("the element Gg is (a−s)dφ: the place of G, by differences, though M moves by ds")
{
  const Fifty h("1e-15"), x = phi.fifty();
  const auto after = cycloidal_places<Fifty>(x + h), before = cycloidal_places<Fifty>(x - h);
  const Fifty dx = (after.G_down - before.G_down) / (2 * h),
              dy = (after.G_aside - before.G_aside) / (2 * h);
  CHECK(sqrt(dx * dx + dy * dy) == within_relative(cos(x), 1e-28, "the square of the step"));
  CHECK(dx * sin(x) + dy * -cos(x) == within_relative(-cos(x), 1e-28, "it goes at right angles to MG"));
}

CHECK_THAT(
    "with the store of motion summed over the body's parts, the translation and the rotation are all")
{
  // Four equal parts at the corners of a rectangle of the radius of gyration k, moving about M at rest.
  const Fifty r("0.9"), w("1.7"), half("0.06"), other("0.08");
  Fifty sum = 0;
  for(const int i : {-1, 1})
    for(const int j : {-1, 1})
    {
      const Fifty along = r + i * half, across_ = j * other;
      sum += w * w * (along * along + across_ * across_) / 4;
    }
  CHECK(sum == within_relative(w * w * (r * r + Fifty("0.01")), 1e-48, "k is a tenth here"));
}

CHECK_THAT("in the figure the share is kk/(kk+rr), and what is left of it is rr to kk + rr")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("shares", 6))
    {
      const Fifty cc = (1 + cos(Fifty(point.at("phi")) * exact::pi() / 90)) / 2;
      for(const auto& [name, kk] : {std::pair{"k1", "0.01"}, {"k2", "0.04"}, {"k3", "0.09"}})
        CHECK(point.value(name) == within_relative(1 - cc / (cc + Fifty(kk)), 4e-15, "a cosine's square"));
      CHECK(point.value("axis") == within_relative(Fifty("0.09") / Fifty("1.09"), 1e-15, "a division"));
    }
}

CHECK_THAT("it refuses an angle beyond the end of the swing and a k beyond its limits, by however little, "
           "and neither at the limit")
{
  for(const char* const within_them :
      {"phi0=30 phi=30", "phi0=50 phi=50", "k=1e-9", "a=2 k=2e-9", "k=1e9", "a=2 k=2e9"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"phi0=30 phi=30.0000000000000000000001", "phi0=50 phi=50.0000000000000000000001",
       "k=9.999999999999997e-10", "a=2 k=1.9999999999999994e-9", "k=1000000000.0000002",
       "a=2 k=2000000000.0000004"})
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
How wide must a body with $k = \tfrac1{10}a$ swing between cycloids until, at the turning point, the
rotation would take half of whatever is gained next?

answer: Half is reached where $r = k$, at $\arccos\tfrac1{10}$, which is 84.26°: the check below finds it.
:::
*/

CHECK_THAT("the share is a half where r = k, at 84.26° on cycloids with k = a/10")
{
  const double angle_ = std::acos(0.1);
  CHECK(share(0.1, std::cos(angle_)) == within(0.5, 1e-15, "two roundings"));
  CHECK(angle_ / 1_deg == within(84.26, 0.005, "two decimals"));
}
