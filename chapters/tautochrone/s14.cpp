#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"
#include "tautochrone/thread.hpp"

SECTION(tautochrone, 14, "What a force across the line does")

using namespace tautochrone;

/*!
## What Euler does

Before he asks what gravity does to the pendulum, Euler asks what any force does to each of the two
motions. Let it act in some point $Z$ of the straight line $MG$ produced, and let it be $ZX = P$, at
right angles to this line. No other direction need be considered: an oblique force is resolved, and the
part that pulls along $MZ$ goes through $G$ and cannot turn the body; only the part across counts. Let
$GZ = b$.

The motion of the centre of gravity is changed just as if $P$ were applied in $G$ itself. The force retards
it; and with the mass $M$ of the body it is, when $dt$ is taken constant,

$$ \frac{2d\bigl((a-s)\,d\varphi\bigr){{entry lost_bracket}}}{dt^2} = \frac{-P}M, \tag{1} $$

because $(a-s)\,d\varphi$ is the element of the path of $G$ ({{sec tautochrone.13}}). The turning about $G$
is retarded by the moment of the force, $Pb$, and resisted by the moment of inertia $Mkk$, so that

$$ \frac{2dd\varphi}{dt^2} = \frac{-Pb}{Mkk}. \tag{2} $$

The letter $b$, which was a height in {{sec tautochrone.13}}, is a distance here and in the next two
sections.

::: margin
$\dot v_G = F/m$ and $\ddot\varphi = Fb/I$. The factor 2 belongs to a clock in which velocities are roots of
heights: a body's own weight gives the acceleration ½.
:::

The two equations say more than each alone. A point of the line that lies above $G$ is carried back with $G$
and forward by the turning, and one is not moved at all: its distance from $G$ is

$$ \frac{kk}b. \tag{A} $$

Were this point held, the blow would not be felt there. With $b = kk/MG$ it is $M$, and $Z$ is then the
centre of oscillation $H$ of {{sec tautochrone.10}}. This is where the theory of the fixed axis sits in
the two equations; but $M$ is not a fixed axis, and so $Z$ will be another point.

## The program

A free body at rest is struck. What {{eq 1}} and {{eq 2}} say of it, in metres and seconds:
*/

const auto P = real("P", 0.2, none, closed(0, 1000), "the force, in weights of the body");
const auto b = real("b", 0.05, metres, scale, "GZ, how far beyond the centre of gravity it acts");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

double retardation(double force)  // of G, (1)
{
  return 2 * g * force;
}

double turning_retardation(double force)  // (2)
{
  return 2 * g * force / k * (b / k);
}

double moved(double above, double arm)  // of a place above G, k = 1: its displacement over that of G
{
  return 1 - above * arm;
}

TELL
{
  require(b / k >= 1e-20, "b", "from 1e-20 k to 1e20 k");
  require(b / k <= 1e20, "b", "from 1e-20 k to 1e20 k");
  tell("retardation", retardation(P), Unit{"m/s²"}, "of the centre of gravity, (1)");
  tell("turning", turning_retardation(P), Unit{"1/s²"}, "of the rotation, in radians, (2)");
  tell("still", k / b * k, metres, "how far above G a point is that does not move, (A)");
  tell("top", double(1 - b.fifty() / k.fifty()),
       "what a point at the distance k above G moves, G itself moving by 1");
}

TELL
{
  curve("lines", {"place", "b0", "b_half", "b_one", "b_two"}, [](Curve& out) {
    for(int i = -20; i <= 20; ++i)
    {
      const double above = i / 10.0;
      out.put({above, moved(above, 0), moved(above, 0.5), moved(above, 1), moved(above, 2)});
    }
  });
}

/*!
A fifth of its weight, half of $k$ away from the centre, retards the latter by {{retardation|4}} m/s²
wherever it acts; and it turns the body so that the point {{still|3}} m above $G$ stays where it is.

::: figure tautochrone-14
alt: An upright line, the body's, and four straight lines that it goes over into when the same force strikes
at four distances below the centre of gravity. All four pass through the same point beside the centre of
gravity. The farther down the force acts, the more they lean, and the nearer to the centre they cross the
line where the body was.

The line $MZ$ of a free body before (grey) and just after a force has acted across it at the points
marked. $G$ goes as far wherever the force acts; the turning grows with $b$. Where a line crosses the old
one, at the distance $kk : b$, the body has stayed.
:::

## Checks

The body is replaced by two weights $\tfrac12M$ at the distance $k$ above and below $G$. By the law of the
lever the force is shared between them, and each share is all that its weight obeys; nothing is said of
translation, rotation and moments of inertia.
*/

struct Shares  ///< the accelerations of the two weights, doubled, as Euler's clock has them
{
  Fifty upper, lower;
  Shares(const Fifty& force, const Fifty& arm, const Fifty& gyration)
      : upper(force * (gyration - arm) / gyration), lower(force * (gyration + arm) / gyration)
  {
  }
};

CHECK_THAT(
    "both retardations told, and the point at rest, are those of two weights on a rod without weight")
{
  for(const Told& now : told_at("", "P=1000 b=3 k=0.01", "b=1e40 k=1e38 g=16", "b=1e-12 k=1e-3 P=1e-9",
                                "b=1e-9 k=1e9", "b=0.1000000001"))
  {
    const Shares of(P.fifty(), b.fifty(), k.fifty());
    const Fifty mean = (of.upper + of.lower) / 2, turn = (of.lower - of.upper) / (2 * k.fifty());
    const char* const why = "four roundings";
    CHECK(now.value("retardation", Unit{"m/s²"}) == within_relative(2 * g.fifty() * mean, 1e-15, why));
    CHECK(now.value("turning", Unit{"1/s²"}) == within_relative(2 * g.fifty() * turn, 1e-15, why));
    CHECK(now.value("still", metres) == within_relative(mean / turn, 1e-15, why));
    CHECK(now.value("top") == within_relative(of.upper / mean, 1e-15, "b and k as they were written"));
  }
}

CHECK_THAT("where the force is nothing, nothing is retarded")
{
  for(const Told& now : told_at("P=0"))
  {
    CHECK(now.value("retardation", Unit{"m/s²"}) == within(0, 0, "exact"));
    CHECK(now.value("turning", Unit{"1/s²"}) == within(0, 0, "exact"));
  }
}

CHECK_THAT("the lines of the figure go through the places to which the two weights are moved")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("lines", 5))
      for(const auto& [name, arm] : {std::pair{"b0", 0.0}, {"b_half", 0.5}, {"b_one", 1.0}, {"b_two", 2.0}})
      {
        const Shares of(1, arm, 1);
        const Fifty up =
            (1 + Fifty(point.at("place"))) / 2;  // its part of the way from the lower to the upper
        CHECK(point.value(name) == within(of.lower + up * (of.upper - of.lower), 1e-15, "three roundings"));
        CHECK(point.value("place") == between(-2, 2, "the line is as long"));
      }
}

CHECK_THAT(
    "the work that the force does from the start is what both motions have gained: the factor 2 is right")
{
  // In the time t, (1) and (2) give the displacement ¼Pt² and the turning ¼Pbt²/kk from rest.
  const Fifty force("0.2"), arm("0.07"), gyration("0.1"), t("0.3");
  const Shares of(force, arm, gyration);
  const auto height = [&](const Fifty& twice) -> Fifty {
    return pow(twice / 2 * t, 2);
  };  // due to the speed
  const Fifty way = force * t * t / 4, turn = force * arm * t * t / (4 * gyration * gyration);
  CHECK(force * (way + arm * turn)
        == within_relative((height(of.upper) + height(of.lower)) / 2, 1e-47, "two sums of the same"));
}

/*!
In a swing the two equations hold with the force of {{sec tautochrone.16}}, which gravity and the thread are
together equal to. The accelerations are those of two weights again, led along the curve by d'Alembert's
principle; the speed is the one that the body has gained on its way from rest.
*/

CHECK_THAT(
    "in a swing between cheeks, Huygens's or Euler's, both equations hold with one force P in one point Z")
{
  const Fifty ratio("0.2"), most("0.7");
  for(const int corrections : {0, 1, 2})
    for(const char* at_ : {"1e-6", "0.3", "0.65"})
    {
      const Fifty x(at_);
      const auto r = truncated(corrections, ratio);
      const auto here = on_cheeks(static_cast<Cheeks>(1 + corrections), ratio, most, x);
      const Accelerations of = accelerations(r, ratio, turning2_by_motion(r, ratio, most, x), x);
      const Fifty force_ = force(here, ratio), arm = GZ(here, ratio);
      CHECK(of.across == within_relative(-force_, 1e-20, "(1), and the motion's 25 digits"));
      CHECK(of.turning == within_relative(-force_ * arm / (ratio * ratio), 1e-18, "(2), the same"));
    }
}

/*!
Our copy has no bracket about $(a-s)\,d\varphi$ in {{eq 1}}. Taken at its word it would be
$-ds\,d\varphi$ that is divided by $dt^2$. The readings are tried between cycloids, with $a = 1$, $k =
\tfrac1{10}$, at 10° of a swing of 20°.
*/

double force_by(bool bracket)
{
  const auto at = on_cycloids<double>(20_deg, 10_deg);
  const double ds_dphi = at.shortening * at.sin * turning2(at, 0.1);  // over dt²
  return -(bracket ? at.r * twice_acceleration(at, 0.1) - 2 * ds_dphi : -2 * ds_dphi);
}

const Emendation lost_bracket{
    "§14, the retardation of the centre of gravity",
    {"2d(a−s)dφ", [] { return force_by(false); }},
    {"2d((a−s)dφ)", [] { return force_by(true); }},
    "it is the change of the element (a−s)dφ of the path of G",
    [](double force_) {
      const Fifty K("0.1"), ten = exact::pi() / 18;
      const auto r = truncated(0, K);
      const Fifty w = turning2_by_motion(K, 2 * ten, ten);
      return force_ == within_relative(-accelerations(r, K, w, ten).across, 1e-14, "the library's bound");
    }};

CHECK_THAT("an arm beyond 10²⁰ k or below 10⁻²⁰ k is refused, and one of just that is not")
{
  for(const char* const within_them : {"k=1 b=1e-20", "k=2 b=2e-20", "k=1 b=1e20", "k=2 b=2e20"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"k=1 b=9.999999999999997e-21", "k=2 b=1.9999999999999994e-20",
                                  "k=1 b=1.0000000000000002e20", "k=2 b=2.0000000000000004e20"})
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
A uniform rod of one metre lies free. Where must it be struck, that its one end does not move? Compare with
the centre of oscillation of the rod when it hangs by this end.

answer: Its $kk$ is a twelfth of the square of its length, and the end is half a length from $G$; by {{eq A}}
$b = kk : \tfrac12$, a sixth of its length beyond $G$, two thirds of the length from the end:
`--k 0.288675 --b 0.1666667`. It is the centre of oscillation: an axis through a place that the blow leaves at
rest has nothing to bear of it.
:::
*/

CHECK_THAT("a uniform rod of one metre that is struck a sixth beyond its middle rests at its other end")
{
  const Fifty kk =
      exact::integrate([](const Fifty& x) -> Fifty { return x * x; }, Fifty(-1) / 2, Fifty(1) / 2).value;
  for(const Told& now : told_at("k=0.28867513459481288225 b=0.16666666666666666667"))
  {
    CHECK(pow(k.fifty(), 2) == within_relative(kk, 1e-19, "twenty digits"));
    CHECK(now.value("still", metres) == within_relative(0.5, 1e-15, "the end"));
    CHECK(b.fifty() + Fifty("0.5") == within_relative(Fifty(2) / 3, 1e-19, "two thirds from the end"));
  }
}
