#include "edition/section.hpp"
#include "globe/rolling.hpp"
#include "globe/scene.hpp"
#include "globe/scene_judge.hpp"

SECTION(globe, 2, "The figure and its letters")

/*!
## What Euler does

All the letters of the paper are laid down at one figure, the section of the ball by the upright plane in
which it goes. $IO$ is the straight line on the horizontal plane along which the ball advances. In the
beginning it touched that line at $I$; after the time $t$ it touches it at $S$, and has covered the way
$IS = s$. Its centre is then at $C$, above $S$, its centre of gravity at $G$, and

$$ CS = CA = a, \qquad CG = c, \tag{1} $$

$A$ being the end of the radius that goes through $G$, the place of the surface to which $G$ is nearest. If
the ball turns, it always turns about the horizontal axis through $G$ at right angles to this section; with
respect to that axis its moment of inertia is $Pkk$, where $P$ is its weight or mass. A perpendicular $GP$
is dropped from $G$ to the line $IO$, and the two coordinates

$$ IP = x, \qquad PG = y \tag{2} $$

say where $G$ is. The third letter that moves is the angle

$$ AGP = ACS = \Phi, \tag{3} $$

the same at $G$ as at $C$ because $GP$ and $CS$ are both upright. It grows in the sense $SAB$, that is, as
the ball turns when it rolls towards $O$. Then

$$ \frac{dx}{dt}, \qquad \frac{dy}{dt}, \qquad \frac{d\Phi}{dt} \tag{4} $$

are the horizontal velocity of $G$, its velocity upwards, and the angular velocity of the ball. Euler
reminds the reader of his habit: times are counted in seconds, a velocity is the way described in one
second, and for the sake of this the letter $g$ comes in, the height through which a body falls in the first
second.

::: margin
Today: $2g$ is the acceleration of gravity, $k$ the radius of gyration. $P$ stands for a weight and for a
point, $C$ for a point and, from {{sec globe.25}}, for a constant; $S$ for a point and, from
{{sec globe.27}}, for a fraction.
:::

Two things are worth adding. One is which side $G$ is on: for $0 < \Phi < 180°$ it is behind $C$, on the
side of $I$, for the ball has carried it past the lowest place and up at the back. The other is that $a$,
$c$ and $k$ are not quite free. About $C$ the moment of inertia is $P(kk+cc)$, and since no part of a ball
is farther from its axis than $a$,

$$ kk + cc \le aa. \tag{A} $$

Nothing more is asked for: two equal particles at the depth $c$, one $k$ before and the other $k$ behind the
upright diameter, have the $c$ and the $k$ that were wanted, and they are in the ball as soon as {{eq A}}
holds. The cradles of {{sec globe.32}}, which only stand on a piece of a sphere, need not keep to it.

## The program

The reader places the ball, whose $G$ lies halfway to the surface here, so that the figure can be read.
Since Φ counts all turns, its sine is taken in fifty digits, and the height, which may nearly vanish when
$G$ is at the surface, is put together from $a - c$ and what is above it.
*/

const auto a = real("a", 1, feet, scale, "CS, the radius of the ball");
const auto c = real("c", 0.5, feet, scale, "CG, from the centre to the centre of gravity");
const auto k = real("k", 0.5, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto s = real("s", 2, feet, closed(-1e100, 1e100), "IS, the way that the point of contact has made");
const auto Phi = angle("Phi", 60_deg, closed(-1e12_deg, 1e12_deg), "angle ACS, all turns counted");

struct Point
{
  Fifty x, y;  // from I towards O, and upwards
};

Point from_C(const Fifty& distance)  // on the radius CGA
{
  const Fifty sine = sin(Phi.fifty() / 2);
  return {s.fifty() - distance * sin(Phi.fifty()), (a.fifty() - distance) + 2 * distance * sine * sine};
}

Fifty turns()  // the whole turns next to Φ
{
  return round(Phi.fifty() / (2 * exact::pi()));
}

double greatest_k()  // (A)
{
  return double(sqrt((a.fifty() - c.fifty()) * (a.fifty() + c.fifty())));
}

TELL
{
  require(c.fifty() <= a.fifty(), "c", "at most a: G is in the ball");
  const Point G = from_C(c.fifty()), A = from_C(a.fifty());
  tell("x", double(G.x), feet, "IP, how far G has gone", 15);
  tell("y", double(G.y), feet, "PG, how high it is", 15);
  tell("behind", double(c.fifty() * sin(Phi.fifty())), feet, "GQ, by how much G is behind C", 15);
  tell("below", double(c.fifty() * cos(Phi.fifty())), feet, "CQ, by how much it is below C", 15);
  tell("x_A", double(A.x), feet, "how far A is from I", 15);
  tell("y_A", double(A.y), feet, "how high A is above the plane", 15);
  tell("turns", double(turns()), "whole turns, counted to the nearest");
  tell("rest", double(Phi.fifty() - 2 * exact::pi() * turns()), degrees, "what Φ has beyond these", 15);
  tell("greatest_k", greatest_k(), feet, "the greatest k of a ball with this c");
  const bool ball = k.fifty() * k.fifty() + c.fifty() * c.fifty() <= a.fifty() * a.fifty();
  tell("verdict", ball ? "a ball" : "a cradle", "what can have this c and this k");
}

TELL
{
  // The lengths of the figures are those of the ball, the radius being one.
  curve("points", {"x", "y"}, [](Curve& points) {  // I, S, C, A, G, P, Q
    const double way = s / a, r = c / a;
    const double sine = double(sin(Phi.fifty())), cosine = double(cos(Phi.fifty()));
    points.put({0, 0});
    points.put({way, 0});
    points.put({way, 1});
    points.put({way - sine, 1 - cosine});
    points.put({way - r * sine, 1 - r * cosine});
    points.put({way - r * sine, 0});
    points.put({way, 1 - r * cosine});
  });
  curve("circle", {"x", "y"}, [](Curve& circle) {
    for(int n = 0; n <= 120; ++n)
      circle.put({s / a - std::sin(n * 3_deg), 1 - std::cos(n * 3_deg)});
  });
  curve("arc", {"x", "y"}, [](Curve& arc) {  // from CS to CA, a quarter of the radius wide
    const double rest = double(Phi.fifty() - 2 * exact::pi() * turns());
    for(int n = 0; n <= 40; ++n)
      arc.put({s / a - std::sin(n * rest / 40) / 4, 1 - std::cos(n * rest / 40) / 4});
  });
}

/*!
Let go at rest with the angle that is left of Φ after whole turns, on a plane that lets it roll only, the ball
rocks:
*/

const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");

TELL
{
  const Fifty rest = Phi.fifty() - 2 * exact::pi() * turns(), aside = abs(rest);
  const globe::Ball<double> ball{a, c, k};
  const auto e = globe::rounded(globe::Energy<Fifty>{pow(sin(aside / 2), 2), pow(cos(aside / 2), 2)});
  if(!globe::can_be_seen(ball, e.h) || e.from_top == 0)
    return;  // nothing moves, or too little to be seen
  auto motion =
      globe::rolling_motion(ball, g, e, globe::rolling::quarter<double>(globe::in_radii(ball), e));
  if(rest < 0)
  {
    motion.angle = [forwards = motion.angle](double tau) { return -forwards(tau); };
    motion.advanced = [forwards = motion.advanced](double to, double t) { return -forwards(-to, t); };
  }
  globe::scene_of_ball("rocking", motion);
}

/*!
With the ball turned by 60° its centre of gravity is {{behind|4}} foot behind the centre and {{y|4}} above
the plane, and $x$ is {{x|8}} feet. With that $c$ no ball has a $k$ above {{greatest_k|4}} foot.

::: figure globe-02
alt: A circle on a horizontal line. From its centre C two radii go, one down to the point of contact S, the
other to A, down and to the left. On the second lies G; a perpendicular leads from G down to P on the line,
a horizontal to Q on the first radius. The angle between the radii is marked Φ, and the starting point I
lies to the left.

The first figure of the plate, drawn from its description. The ball goes from $I$ towards $O$ and turns in
the sense $SAB$, so that $G$ has been carried behind $C$ and up at the back.
:::

::: scene rocking
alt: A ball on a level line; the radius CA goes down to the left, with G on it. A grey line is the way of G.

The same ball let go at this place, in true time: the radius is $CA$, the dot $G$, the grey line its way. As
the ball rolls back, $S$ runs along the plane by as much as the radius turns.
:::

## Checks

Turning is done here without any sine: the radius is turned by a very small angle, whose series has few
terms, and that turn is doubled again and again.
*/

Point turned(const Fifty& length)  // what hung straight down, after a turn by Φ in the sense SAB
{
  constexpr int doublings = 60;
  const Fifty e = ldexp(Phi.fifty(), -doublings);  // below 2⁻²⁵
  Fifty term = 1, versed = 0, sine = 0;            // one less the cosine, which keeps its digits
  for(int n = 1; n <= 14; ++n)
  {
    term = term * e / n;
    (n % 2 == 1 ? sine : versed) += (n % 4 == 1 || n % 4 == 2 ? 1 : -1) * term;
  }
  for(int n = 0; n < doublings; ++n)
  {
    const Fifty doubled = 2 * sine * (1 - versed);
    versed = 2 * sine * sine;
    sine = doubled;
  }
  return {-length * sine, length * versed};  // from the place where it hung, backwards and upwards
}

// What a small turn and its doublings lose of fifty digits.
double loss()
{
  return 2e-45 * (1 + std::abs(Phi));
}

CHECK_THAT("the places told are those to which small turns bring the radius, through however many turns")
{
  for(const Told& now : told_at("", "Phi=-150 s=-3", "Phi=1e12 a=1e60 c=1e60 s=1e30", "c=1 Phi=1e-20rad",
                                "c=1e-60 Phi=99999999999.5 a=3 s=0"))
  {
    const Point g = turned(c.fifty()), A = turned(a.fifty());
    const double lost = loss();
    CHECK(now.value("x", feet)
          == within(s.fifty() + g.x, 2e-16 * double(abs(s.fifty() + g.x)) + lost * c, "rounded once"));
    const Fifty up = a.fifty() - c.fifty() + g.y;
    CHECK(now.value("y", feet) == within(up, 2e-16 * double(up) + lost * a, "rounded once"));
    CHECK(now.value("behind", feet) == within(-g.x, 2e-16 * double(abs(g.x)) + lost * c, "rounded once"));
    CHECK(now.value("below", feet)
          == within(c.fifty() - g.y, 2e-16 * double(abs(c.fifty() - g.y)) + lost * c, "rounded once"));
    CHECK(now.value("x_A", feet)
          == within(s.fifty() + A.x, 2e-16 * double(abs(s.fifty() + A.x)) + lost * a, "rounded once"));
    CHECK(now.value("y_A", feet) == within(A.y, 2e-16 * double(A.y) + lost * a, "rounded once"));
    // What is left of Φ turns the radius to the same place, and is at most half a turn.
    const Fifty whole = round(Phi.fifty() / (2 * exact::pi()));
    CHECK(now.value("turns") == within(whole, 0, "a whole number below 3e9"));
    const Fifty left = atan2(-A.x, a.fifty() - A.y);
    CHECK(now.value("rest", degrees)
          == within(left, 4e-16 * double(abs(left)) + lost, "the angle of A, rounded once"));
  }
}

CHECK_THAT("G may lie at the surface, and is refused a hair beyond it")
{
  for(const char* const at_it : {"c=1", "a=3 c=3"})
    CHECK(!refused_at(at_it));
  for(const char* const beyond : {"c=1.00000000000000001", "a=3 c=3.00000000000000001"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("the angle at G is the angle at C, each found from the places of three points")
{
  for(const Told& now : told_at("", "Phi=-150", "Phi=135 c=0.9", "Phi=-0.001 a=7"))
  {
    const Point G = from_C(c.fifty()), A = from_C(a.fifty());
    // From the radius downwards to the one and to the other, in the sense SAB.
    const Fifty at_G = atan2(G.x - A.x, G.y - A.y), at_C = atan2(s.fifty() - A.x, a.fifty() - A.y);
    CHECK(at_G == within(at_C, 1e-44, "fifty digits"));
    CHECK(now.value("rest", degrees) == within(at_G, 1e-15, "(3), rounded"));
    const Fifty CG = hypot(G.x - s.fifty(), G.y - a.fifty());
    CHECK(CG == within_relative(c.fifty(), 1e-45, "(1)"));
    CHECK((G.x < s.fifty()) == (at_C > 0));
  }
}

CHECK_THAT("two particles have any c and k that are wanted, and lie in the ball exactly when (A) holds")
{
  for(const Told& now : told_at("", "c=0.1 k=0.9949874371066199", "c=0.1 k=0.99498743710662",
                                "c=1 k=1e-100", "a=1e60 c=6e59 k=8e59"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), a_ = a.fifty();
    Fifty depth = 0, moment = 0;
    bool inside = true;
    for(const int side : {-1, 1})  // of the upright diameter
    {
      const Point from{side * k_, -c_};
      depth -= from.y / 2;
      moment += (from.x * from.x + pow(from.y + c_, 2)) / 2;
      inside = inside && from.x * from.x + from.y * from.y <= a_ * a_;
    }
    CHECK(depth == within_relative(c_, 1e-49, "the mean of the two"));
    CHECK(sqrt(moment) == within_relative(k_, 1e-48, "half the sum of two equal squares"));
    CHECK(now.value("verdict") == (inside ? "a ball" : "a cradle"));
    const Fifty most = a_ == c_ ? Fifty(0) : Fifty(a_ * sqrt(1 - pow(c_ / a_, 2)));
    CHECK(now.value("greatest_k", feet) == within_relative(most, 2e-16, "rounded once"));
  }
}

CHECK_THAT(
    "the scene is the ball rolling as the equations of motion have it, let go at rest at the angle told")
{
  for(const Told& now : told_at("", "Phi=-150 c=0.3 a=2 g=3", "Phi=537 c=0.9 k=0.2"))
    for(const auto& frame :
        globe::judged(now.points("rocking", 7), globe::Plane::rough, {a.fifty(), c.fifty(), k.fifty()},
                      g.fifty(), Phi.fifty() - 2 * exact::pi() * turns(), 0))
    {
      CHECK(frame.told.value("t") == between(frame.earliest, frame.latest, "in their order"));
      CHECK(frame.pressure == between(-1e-9, infinity, "the plane bears it, to the last frame"));
      for(const globe::Judged_ball::Number& one : frame.numbers())
        CHECK(one.told == within(one.right, frame.slack, globe::Judged_ball::because));
    }
}

CHECK_THAT("the figure is the ball's: its circle, its two radii, its right angles at P and at Q")
{
  for(const Told& now : told_at("", "Phi=-100 c=0.7", "s=-5 a=2 c=0.3 Phi=700"))
  {
    const Fifty way = s.fifty() / a.fifty(), r = c.fifty() / a.fifty();
    const Point A = turned(1), G = turned(r);
    const std::array<Point, 7> places{Point{0, 0},
                                      Point{way, 0},
                                      Point{way, 1},
                                      Point{way + A.x, A.y},
                                      Point{way + G.x, 1 - r + G.y},
                                      Point{way + G.x, 0},
                                      Point{way, 1 - r + G.y}};
    std::size_t n = 0;
    for(const auto& point : now.points("points"))
    {
      CHECK(point.value("x") == within(places.at(n).x, 4e-15, "a sum of two"));
      CHECK(point.value("y") == within(places.at(n++).y, 1e-15, "a sum of two"));
    }
    for(const auto& point : now.points("circle", 9))
    {
      const Fifty x = Fifty(point.at("x")) - way, y = Fifty(point.at("y")) - 1;
      CHECK(hypot(x, y) == within(1, 4e-15, "the radius"));
      CHECK(point.value("x") == between(way - 1 - 1e-15, way + 1 + 1e-15, "as wide as the ball"));
      CHECK(point.value("y") == between(-1e-15, 2 + 1e-15, "as high"));
    }
    const Fifty whole = atan2(-A.x, 1 - A.y);
    int part = 0;
    for(const auto& point : now.points("arc", 5))
    {
      const Fifty at = whole * (part++) / 4;
      CHECK(point.value("x") == within(way - sin(at) / 4, 4e-15, "a quarter of the radius"));
      CHECK(point.value("y") == within(1 - cos(at) / 4, 1e-15, "a quarter of the radius"));
    }
  }
}

/*!
## Notes

That Φ vanishes together with $s$ is not said here, and need not be: a ball may be put down in any attitude.
It is assumed in {{sec globe.10}}, where the ball starts with $G$ at its lowest.

## Go on from here

::: exercise
A hollow ball carries a lump as heavy as itself at one place of its inner wall; both wall and lump are thin.
What are $c$ and $kk$, and how far is it from the bound {{eq A}}?
answer: $c = \frac12a$. About $C$ the wall has $\frac23aa$ and the lump $aa$, each with half the weight, so
that $kk + cc = \frac56aa$ and $kk = \frac7{12}aa$.
:::
*/

CHECK_THAT("a hollow ball and a lump of its weight on its wall have c = a/2 and kk = 7aa/12")
{
  const Rational half(1, 2), about_C = half * Rational(2, 3) + half * Rational(1);
  CHECK(about_C == Rational(5, 6));
  CHECK(about_C - half * half == Rational(7, 12));
}
