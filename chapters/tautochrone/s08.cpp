#include "edition/section.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/scene.hpp"
#include "tautochrone/scene_judge.hpp"
#include "tautochrone/thread.hpp"

SECTION(tautochrone, 8, "The figure: the cheek, the thread and the body")

using namespace tautochrone;

/*!
## What Euler does

Here the mathematics begins, with the figure that all that follows refers to, his sixth. Any pendulum hangs
from the point $A$. The curve $AMB$ is its directrix, the cheek: the flexible upper part of the pendulum
lies on it from $A$ to $M$, and from this last point of contact the lower part $MG$ goes straight on while
it moves.

Two things are then said. First, that this tangent $MG$ passes through the body's centre of gravity $G$; for
the mean direction of the centrifugal force, by which the pendulum is stretched besides its gravity, goes
through that point. Secondly, that $G$ describes a curve $GC$ whose evolute is the cheek, so that $MG$ is its
radius of curvature in $G$.

The line $AD$, which touches the cheek in its highest point $A$, is vertical. On its other side is an equal
cheek, which the figure leaves out; the pendulum swings between the two so that $G$ falls and rises by turns
on the curve $GC$ and on its continuation on the other side.

In the letters of {{sec tautochrone.12}} and {{sec tautochrone.33}}, with $AM = s$, $MG = r = a - s$ and
$\varphi$ the angle of $MG$ with the vertical, the place of $M$ being $p$ below and $q$ beside $A$, that of
$G$ is

$$ AQ = p + r\cos\varphi, \qquad QG = q + r\sin\varphi, \tag{A} $$

and, as $dp = ds\cos\varphi$, $dq = ds\sin\varphi$ and $dr = -ds$, its element has the length $r\,d\varphi$
and is at right angles to $MG$.

::: margin
The involute of the cheek. $M$ is the body's instantaneous centre of rotation; it is at rest as a point of
the body, and only the place of contact moves.
:::

The reason that he gives for the first statement is not sufficient. The centrifugal force pulls through $G$,
but a body that swings with its thread is also turned, now faster, now slower, and a thread that is limp
cannot turn it: it pulls along itself, and through $G$ that has no moment. At $M$ the free part must bear,
across itself, so many weights of the body:

$$ R = -\frac{kk}{r}\cdot\frac{2dd\varphi}{dt^2} = P\cdot\frac{GZ}{MG}, \tag{B} $$

with $P$ and $Z$ of {{sec tautochrone.14}}. So Euler's pendulum needs a free part that is stiff, and is
flexible only where it lies on the cheek. For a heavy point, $k = 0$, nothing is to be borne and the thread
may be limp.

## The program

The cheeks are Huygens's; their coordinates and those of $G$ are:
*/

double G_down(double phi)  // (A), a = 1
{
  return euler_p<double>(1, 0, phi) + std::cos(phi) * std::cos(phi);
}

double G_aside(double phi)  // (A), a = 1
{
  return euler_q<double>(1, 0, phi) + std::cos(phi) * std::sin(phi);
}

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.2, metres, scale, "radius of gyration");
const auto phi0 =
    angle("phi0", 60_deg, above_to(0_deg, 89_deg), "how far the pendulum swings to either side");
const auto phi = angle("phi", within_swing(40_deg, phi0), closed(0_deg, 89_deg),
                       "angle of the free part with the vertical");

const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

double borne(double ratio, double phi0_, double phi_)  // (B)
{
  const auto at = on_cycloids<double>(phi0_, phi_);
  return force(at, ratio) * cycloidal_GZ<double>(ratio, phi0_, phi_) / at.r;
}

TELL
{
  const double ratio = k / a;
  require(ratio >= 1e-80, "k", "from 1e-80 a to 1e20 a");
  require(ratio <= 1e20, "k", "from 1e-80 a to 1e20 a");
  require(phi <= phi0, "phi", "at most phi0");
  tell("s", a * euler_s<double>(1, 0, phi), metres, "AM, the part that lies on the cheek");
  tell("r", a * std::cos(phi), metres, "MG, the free part");
  tell("p", a * euler_p<double>(1, 0, phi), metres, "AP, how far M is below A");
  tell("q", a * euler_q<double>(1, 0, phi), metres, "PM, and beside it");
  tell("AQ", a * G_down(phi), metres, "how far G is below A");
  tell("QG", a * G_aside(phi), metres, "and beside it");
  tell("R", borne(ratio, phi0, phi), "what the free part bears across at M, over the weight");
  tell("R_at_the_end", borne(ratio, phi0, phi0), "the same at the end of the swing");
}

TELL
{
  curve("lines", {"phi", "q", "p", "G_y", "G_x"}, [](Curve& out) {
    for(int i = 0; i <= 80; ++i)
    {
      const double here = i * 1_deg;
      out.put({double(i), euler_q<double>(1, 0, here), euler_p<double>(1, 0, here), G_aside(here),
               G_down(here)});
    }
  });
  auto& letters = table("letters", "The points of the figure, in parts of a",
                        {{"letter", "point"}, {"aside", "to the right of A"}, {"down", "below A"}});
  const double q = euler_q<double>(1, 0, phi), p = euler_p<double>(1, 0, phi), kk = k / a * (k / a);
  const double MH = std::cos(phi) + kk / std::cos(phi);
  letters.row({"A", 0.0, 0.0});
  letters.row({"M", q, p});
  letters.row({"P", 0.0, p});
  letters.row({"G", G_aside(phi), G_down(phi)});
  letters.row({"Q", 0.0, G_down(phi)});
  letters.row({"S", q, G_down(phi)});
  letters.row({"C", 0.0, 1.0});
  letters.row({"D", 0.0, 1 + kk});
  letters.row({"H", q + MH * std::sin(phi), p + MH * std::cos(phi)});
}

TELL
{
  scene_between_cheeks("swing", Cheeks::cycloids, k / a, phi0, clock_in_seconds(a, g));
}

/*!
::: figure tautochrone-08
alt: A cheek hangs from A and bends away to the right, to B. The thread lies on it from A to M and goes on
straight to the centre of gravity G of the body and to H. A curve goes from G down to C below A, and below C
is D. Level and upright construction lines lead to P, Q and S.

Euler's sixth figure, drawn anew from the text and the geometry with Huygens's cheek. The thread $AM$ lies on
the cheek $AMB$; $G$ has come from $C$ along a curve whose evolute is that cheek. $D$ and $H$ are the
centres of oscillation for the axes $A$ and $M$.
:::

::: scene swing
alt: Two half cycloids meet in a cusp at the top. A thread leaves the right one and goes on, stiff, through
two equal weights with the centre of gravity between them.

The pendulum in its true time, one swing to and fro. For the body stand two equal weights, $k$ above $G$ and
$k$ below it; any other body with the same $kk$ moves alike. The free part always touches the cheek, and turns
the body.
:::

In a swing of 60° a body with $k = \tfrac15a$ needs at 40° {{R|percent2}} of its weight across at $M$, and
at the end of the swing {{R_at_the_end|percent2}}.

{{table letters}}

## Checks

The cheek has the arc $s$ and the tangent that it should have, and $G$ moves at right angles to $MG$ by
$r\,d\varphi$: the differences of the places told are taken in fifty digits.
*/

CHECK_THAT("M, G and the arc told are those of a cycloid and a thread of the length a, whatever the angle")
{
  for(const Told& now : told_at("", "a=1e40 k=1e20 phi=1e-9", "a=3 phi0=89 phi=89", "phi=0"))
  {
    const Fifty x = phi.fifty(), A = a.fifty(), s = 2 * pow(sin(x / 2), 2), r = 1 - s;
    const auto M = cycloidal_places(x);
    const char* const why = "the library's bound, and a product";
    CHECK(now.value("s", metres) == within_relative(A * s, 2e-15, why));
    CHECK(now.value("r", metres) == within_relative(A * r, 2e-14, "the angle's rounding near 90°"));
    CHECK(now.value("p", metres) == within_relative(A * M.p, 2e-15, why));
    CHECK(now.value("q", metres) == within_relative(A * M.q, 2e-15, why));
    CHECK(now.value("AQ", metres) == within_relative(A * M.G_down, 2e-15, why));
    CHECK(now.value("QG", metres) == within_relative(A * M.G_aside, 2e-15, why));
  }
}

CHECK_THAT("it refuses an angle beyond the end of the swing and a k beyond its limits, by however little, "
           "and neither at the limit")
{
  for(const char* const within_them :
      {"phi0=30 phi=30", "phi0=60 phi=60", "k=1e-80", "a=2 k=2e-80", "k=1e20", "a=2 k=2e20"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"phi0=30 phi=30.00000000000002", "phi0=60 phi=60.00000000000003", "k=9.999999999999997e-81",
       "a=2 k=1.9999999999999994e-80", "k=1.0000000000000002e20", "a=2 k=2.0000000000000004e20"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("the thread touches the cheek, and G moves across it by r dφ, by differences")
{
  const Fifty h("1e-15");
  for(const char* const at : {"0.1", "0.7", "1.5"})
  {
    const Fifty x(at), s = sin(x), c = cos(x);
    const auto up = cycloidal_places<Fifty>(x + h), low = cycloidal_places<Fifty>(x - h);
    const Fifty dq = (up.q - low.q) / (2 * h), dp = (up.p - low.p) / (2 * h);
    CHECK(dq * c - dp * s == within(0, 1e-28, "the square of the step"));
    CHECK(dq * s + dp * c == within(s, 1e-28, "ds is sin φ dφ"));
    const Fifty dy = (up.G_aside - low.G_aside) / (2 * h), dx = (up.G_down - low.G_down) / (2 * h);
    CHECK(dy * s + dx * c == within(0, 1e-28, "no motion along MG"));
    CHECK(dy * c - dx * s == within(c, 1e-28, "r dφ across it"));
  }
}

/*!
What is borne across is taken from the rotation, which nothing else can change: from differences of
$d\varphi/dt$, that the energy gives.
*/

Fifty needed(const Fifty& k_, const Fifty& phi0_, const Fifty& x)  // (B), a = 1
{
  const Fifty h = x * Fifty("1e-12");
  const auto turning2_ = [&](const Fifty& y) -> Fifty {
    return (pow(cos(y), 2) - pow(cos(phi0_), 2)) / (2 * (k_ * k_ + pow(cos(y), 2)));
  };
  return -k_ * k_ / cos(x) * (turning2_(x + h) - turning2_(x - h)) / (2 * h);
}

CHECK_THAT("what the free part bears across is what the rotation needs")
{
  for(const Told& now :
      told_at("", "k=0.9 phi0=89 phi=1", "a=1e30 k=1e26 phi0=80 phi=79", "k=1e3 phi=1e-3"))
  {
    const Fifty k_ = k.fifty() / a.fifty();
    const char* const why = "the library's bounds, and the angle's near 90°";
    CHECK(now.value("R") == within_relative(needed(k_, phi0.fifty(), phi.fifty()), 3e-14, why));
    CHECK(now.value("R_at_the_end") == within_relative(needed(k_, phi0.fifty(), phi0.fifty()), 3e-14, why));
  }
}

CHECK_THAT("the scene shows the body where its equation of motion takes it, and the thread where it leaves "
           "the cheek")
{
  for(const Told& now : told_at("", "phi0=89 k=0.02 a=2", "phi0=20 k=3 g=1 phi=5"))
    for(const Judged_frame& frame : judged(now.points("swing", 9), Cheeks::cycloids, k.fifty() / a.fifty(),
                                           phi0.fifty(), sqrt(a.fifty() / g.fifty()) / 2))
    {
      CHECK(frame.told.value("t") == within_relative(frame.t, 1e-14, "the clock's bound"));
      for(const auto& [column, right] : frame.right)
        CHECK(frame.told.value(column.c_str()) == within(right, frame.slack, Judged_frame::because));
    }
}

CHECK_THAT("the points of the figure lie where their definitions put them, and so do its lines")
{
  for(const Told& now : told_at("", "phi=10 k=0.5", "phi0=89 phi=85 a=2"))
  {
    const Fifty x = phi.fifty(), kk = pow(k.fifty() / a.fifty(), 2), c = cos(x), s = sin(x);
    const auto M = cycloidal_places(x);
    for(const auto& row : now.rows("letters"))
    {
      const std::string letter = row.words("letter");
      const Fifty along = letter == "M" ? Fifty(0) : letter == "H" ? c + kk / c : c;
      const bool on_axis =
          letter == "A" || letter == "P" || letter == "Q" || letter == "C" || letter == "D";
      const Fifty aside = on_axis ? Fifty(0) : letter == "S" ? M.q : M.q + along * s;
      const Fifty down = letter == "A"   ? Fifty(0)
                         : letter == "P" ? M.p
                         : letter == "C" ? Fifty(1)
                         : letter == "D" ? 1 + kk
                                         : M.p + along * c;
      CHECK(row.value("aside") == within(aside, 1e-14, "a few roundings"));
      CHECK(row.value("down") == within(down, 1e-14, "a few roundings"));
      CHECK(std::string("AMPGQSCDH").find(letter) < 9);
    }
  }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("lines", 6))
    {
      const Fifty x = Fifty(point.at("phi")) * exact::pi() / 180;
      const auto M = cycloidal_places(x);
      CHECK(point.value("q") == within(M.q, 2e-15, "a few roundings"));
      CHECK(point.value("p") == within(M.p, 2e-15, "a few roundings"));
      CHECK(point.value("G_y") == within(M.G_aside, 2e-15, "a few roundings"));
      CHECK(point.value("G_x") == within(M.G_down, 2e-15, "a few roundings"));
    }
}

/*!
## Go on from here

::: exercise
What must be borne across at $M$ when the body is at rest at the end of its swing? For which swing is it half
of the weight's part across the thread?

answer: At rest the body begins to turn about $M$ as about a fixed axis, so that by {{eq B}}
$R = \dfrac{kk\sin\varphi_0}{kk + rr}$, over the weight. It is half of $\sin\varphi_0$ where $r = k$; between
cycloids where $\cos\varphi_0 = k : a$, for $k = \tfrac15a$ at 78.463°.
:::
*/

CHECK_THAT("at the end of a swing R is kk sin φ₀ : (kk + rr), half of sin φ₀ where r = k")
{
  for(const Told& now : told_at("", "phi0=78.463040967 phi=0", "k=3 a=2 phi0=30 phi=0"))
  {
    const Fifty kk = pow(k.fifty() / a.fifty(), 2), s = sin(phi0.fifty()), c = cos(phi0.fifty());
    CHECK(now.value("R_at_the_end")
          == within_relative(kk * s / (kk + c * c), 1e-13, "the library's bound"));
  }
  for(const Told& now : told_at("phi0=78.463040967 phi=0"))
    CHECK(now.value("R_at_the_end")
          == within_relative(sin(phi0.fifty()) / 2, 1e-9, "eleven digits of the angle"));
}
