#include "edition/section.hpp"
#include "exact/quadrature.hpp"

SECTION(tautochrone, 6, "The centre of oscillation, and what it is good for")

/*!
## What Euler does

The motion of a rigid pendulum about a fixed axis is already known, for Huygens has reduced it to that of a
simple one. He showed that every compound pendulum swings as if its whole mass were collected in a certain
point, which he calls the centre of oscillation. Its swings are those of a simple pendulum as long as this
point is distant from the axis. To determine the motion of any pendulum is therefore no more than to find its
centre of oscillation, and for that Huygens gave an elegant rule, which has since been proved in various ways.

Euler does not write the rule down here; he will use it in {{sec tautochrone.09}}. With $\varrho$ for the
distance of a particle $m$ from the axis $A$, $M$ for the whole mass, $C$ for the centre of gravity and $D$
for the centre of oscillation, it is

$$ AD = \frac{\sum m\,\varrho\varrho}{M\cdot AC}. \tag{A} $$

But two things are to be observed about its reach. First, the rule holds for rigid and inflexible bodies
only; such, to be sure, are the bodies commonly used as pendulums. Secondly, it extends only to circular
motion, where the pendulum turns freely about a fixed axis and each of its points describes a circle.

Both fail where a thread winds itself on a cheek. That is why the rest of the paper is needed.

::: margin
The numerator is the moment of inertia about $A$. $AD = \ell$ is today's *reduced length*.
:::

What the rule contains is best seen if the squares are taken from an axis through $C$. With $d = AC$ and the
radius of gyration $k$,

$$ AD = d + \frac{kk}{d}, \tag{B} $$

and this has two remarkable properties. It does not change if $d$ and $kk/d$ are interchanged: there are two
distances at which one body swings in the same time, and an axis through $D$ is as good as one through $A$.
And it is never smaller than $2k$, which it is for $d = k$; there the time depends least on the place of the
axis.

## The program

The sum of {{eq A}} is made over particles: a rod is cut into $n$ equal pieces, each taken as a point in its
middle; a ball into $n$ cylinders about the horizontal line through its centre, on each of which four points
stand for all.
*/

const auto d = real("d", 0.5, metres, scale, "AC, from the axis to the centre of gravity");
const auto L = real("L", 1, metres, scale, "length of a thin rod");
const auto R = real("R", 0.05, metres, scale, "radius of a ball");
const auto n = integer("n", 10, 1, 100'000, "into how many parts they are cut");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

struct Sum  ///< what (A) needs of a body
{
  double weight = 0;   ///< Σm
  double squares = 0;  ///< Σmρρ, over dd

  /// Adds two particles of half the weight m, at d + x and d − x from the axis, or both at the height d and x
  /// aside; x in parts of d.
  void add(double m, double x)
  {
    weight += m;
    squares += m + m * x * x;
  }
};

double length(const Sum& of)  // (A)
{
  return of.squares / of.weight * d;
}

double rod_summed(int parts)
{
  Sum rod;
  for(int i = 0; i < parts; ++i)
    rod.add(1, (2 * i + 1 - parts) / (2.0 * parts) * (L / d));
  return length(rod);
}

double ball_summed(int parts)
{
  Sum ball;
  for(int i = 0; i < parts; ++i)
  {
    const double u = (i + 0.5) / parts;  // distance from the line through the centre, over R
    ball.add(u * std::sqrt((1 - u) * (1 + u)), u * (R / d));
  }
  return length(ball);
}

double by_gyration(double distance, double k)  // (B)
{
  return distance + k * (k / distance);
}

double rod_k()
{
  return L / std::sqrt(12.0);
}

TELL
{
  require(L / d <= 1e100, "L", "from 1e-100 d to 1e100 d");
  require(L / d >= 1e-100, "L", "from 1e-100 d to 1e100 d");
  require(R / d <= 1e100, "R", "from 1e-100 d to 1e100 d");
  require(R / d >= 1e-100, "R", "from 1e-100 d to 1e100 d");
  const double rod = by_gyration(d, rod_k());
  tell("rod", rod, metres, "AD of the rod, (B)");
  tell("rod_summed", rod_summed(n), metres, "AD of its n particles, (A)");
  tell("ball", by_gyration(d, R * std::sqrt(0.4)), metres, "AD of the ball, (B)");
  tell("ball_summed", ball_summed(n), metres, "AD of its n cylinders, (A)");
  tell("T", std::numbers::pi * (std::sqrt(rod) / std::sqrt(2.0)) / std::sqrt(g), seconds,
       "a narrow swing of the rod");
  tell("other", rod_k() * (rod_k() / d), metres, "the other distance for which the rod's AD is the same");
  tell("shortest", 2 * rod_k(), metres, "the shortest AD that the rod can have, and");
  tell("at", rod_k(), metres, "the distance of the axis that gives it");
}

TELL
{
  auto& rows = table("cut", "What is missing of kk when the bodies are cut into n parts",
                     {{"n", "n"}, {"rod", "rod", percent, 6}, {"ball", "ball", percent, 6}});
  for(const int parts : {1, 3, 10, 30, 100, 300})
  {
    Sum ball;  // kk over RR
    for(int i = 0; i < parts; ++i)
    {
      const double u = (i + 0.5) / parts, m = u * std::sqrt((1 - u) * (1 + u));
      ball.weight += m;
      ball.squares += m * u * u;
    }
    rows.row({parts, 1.0 / parts / parts, 1 - 2.5 * ball.squares / ball.weight});
  }
}

TELL
{
  curve("lengths", {"d", "AD", "other"}, [](Curve& out) {
    for(int i = 0; i <= 78; ++i)
    {
      const double distance = 0.2 * std::pow(1.05, i);
      out.put({distance, by_gyration(distance, 1), 1 / distance});
    }
  });
}

/*!
A rod of one metre hung by its end swings like a simple pendulum of {{rod|4}} m, two thirds of it. Cut into
{{n}} particles it would be {{rod_summed|5}} m. How fast the sums come near depends on how the body is cut:

{{table cut}}

The rod's fault goes with $1/nn$; that of the ball, whose outermost cylinders shrink like a square root, only
with $1/n\sqrt n$.

::: figure tautochrone-06
alt: The length of the isochronous simple pendulum against the distance of the axis from the centre of
gravity, both in parts of k. It falls along a hyperbola, is least, two, at the distance one, and rises along a
straight line. A level line cuts it twice, at one half and at two.

How long the simple pendulum is that keeps time with a body hung at the distance $d$. Grey: its two parts,
$d$ and $kk/d$. The level line meets it at two distances whose product is $kk$.
:::

## Checks

Of both bodies the sum {{eq A}} is an integral, taken in fifty digits from the axis $A$ itself; of the rod's
particles it is a sum of whole numbers.
*/

Fifty rod_exactly()  // ∫ρρ dρ over L d
{
  const Fifty l = L.fifty(), at = d.fifty();
  return exact::integrate([](const Fifty& x) -> Fifty { return x * x; }, at - l / 2, at + l / 2).value
         / (l * at);
}

Fifty ball_exactly()  // slices at the depth z, of the weight RR − zz; each has ρρ = (d + z)² + ¼(RR − zz)
{
  const Fifty r = R.fifty() / d.fifty();
  const auto slices = [&](const Fifty& z) -> Fifty {
    const Fifty area = r * r - z * z;
    return area * ((1 + z) * (1 + z) + area / 4);
  };
  return d.fifty() * exact::integrate(slices, -r, r).value / (4 * r * r * r / 3);
}

CHECK_THAT("AD, for rod and ball, is the integral about the axis, and T that of a simple pendulum so long")
{
  for(const Told& now : told_at("", "d=3 L=0.2 R=2.5 g=3", "d=1e-3 L=40 R=0.7 n=7", "d=1e80 L=1e81 R=1e79"))
  {
    const char* const why = "six roundings";
    CHECK(now.value("rod", metres) == within_relative(rod_exactly(), 1e-15, why));
    CHECK(now.value("ball", metres) == within_relative(ball_exactly(), 1e-15, why));
    CHECK(now.value("T", seconds)
          == within_relative(exact::pi() * sqrt(rod_exactly() / (2 * g.fifty())), 2e-15, why));
  }
}

CHECK_THAT("the sums are those of the particles, each at its place, counted from the axis")
{
  for(const Told& now : told_at("", "d=3 L=0.2 R=2.5 n=1", "d=0.01 L=4 R=0.7 n=33"))
  {
    const Fifty at = d.fifty();
    const int parts = n;
    Fifty rod = 0, ball = 0, weight = 0;
    for(int i = 0; i < parts; ++i)
    {
      const Fifty place = at - L.fifty() / 2 + (2 * i + 1) * L.fifty() / (2 * parts);
      rod += place * place / parts;
      const Fifty u = Fifty(2 * i + 1) / (2 * parts), x = u * R.fifty(), m = u * sqrt(1 - u * u);
      weight += m;  // a quarter each below, above, and at either side
      ball += m * (pow(at + x, 2) + pow(at - x, 2) + 2 * (at * at + x * x)) / 4;
    }
    CHECK(now.value("rod_summed", metres) == within_relative(rod / at, 1e-14, "a sum of n"));
    CHECK(now.value("ball_summed", metres) == within_relative(ball / (weight * at), 1e-14, "a sum of n"));
  }
}

CHECK_THAT("the table: a rod lacks 1/nn of its kk, a ball what the integral has more than the sum")
{
  for(const Told& now : told_at(""))
    for(const auto& row : now.rows("cut"))
    {
      const int parts = static_cast<int>(row.at("n"));
      Rational squares = 0;
      Fifty part = 0, weight = 0;
      for(int i = 0; i < parts; ++i)
      {
        const Rational x(2 * i + 1 - parts, 2 * parts);
        squares += x * x / Rational(parts);
        const Fifty u = Fifty(2 * i + 1) / (2 * parts);
        weight += u * sqrt(1 - u * u);
        part += u * sqrt(1 - u * u) * u * u;
      }
      CHECK(row.value("rod", percent)
            == within_relative(Fifty(Rational(1) - Rational(12) * squares), 1e-15, "two quotients"));
      CHECK(row.value("ball", percent)
            == within(1 - part / weight * Fifty("2.5"), 1e-15 * parts, "one less a sum of n"));
    }
}

Fifty by_k(const Fifty& distance, const Fifty& kk)  // (B)
{
  return distance + kk / distance;
}

CHECK_THAT("three times as many parts make the rod's fault nine times smaller, the ball's nearly 3√3 times")
{
  for(const Told& now : told_at(""))
  {
    const auto rows = now.rows("cut");
    CHECK(rows[4].at("rod", percent) / rows[5].at("rod", percent) == within(9, 1e-12, "3²"));
    CHECK(rows[4].at("ball", percent) / rows[5].at("ball", percent)
          == within(3 * sqrt(Fifty(3)), 0.15, "the next order is 1/nn"));
  }
}

CHECK_THAT("the other distance gives the same length; shorter than 2k no axis makes it")
{
  for(const Told& now : told_at("", "d=3 L=0.2", "d=1e-5 L=3"))
  {
    const Fifty kk = L.fifty() * L.fifty() / 12, here = d.fifty(), there = kk / here;
    CHECK(now.value("other", metres) == within_relative(there, 1e-15, "three roundings"));
    CHECK(there + kk / there == within_relative(rod_exactly(), 1e-45, "kk/d and d have changed places"));
    CHECK(now.value("shortest", metres) == within_relative(2 * sqrt(kk), 1e-15, "a root and a quotient"));
    CHECK(now.value("at", metres) == within_relative(sqrt(kk), 1e-15, "a root and a quotient"));
    CHECK(rod_exactly() >= 2 * sqrt(kk));
    const Fifty off("1e-10");  // the change at the least is of the second order
    CHECK(by_k(sqrt(kk) * (1 + off), kk) / (2 * sqrt(kk)) - 1
          == within_relative(off * off / 2, 1e-9, "flat"));
  }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("lengths", 5))
    {
      const Fifty at = point.at("d");
      CHECK(point.value("AD") == within_relative((1 + at * at) / at, 1e-15, "three roundings"));
      CHECK(point.value("other") == within_relative(1 / at, 1e-15, "a quotient"));
    }
}

/*!
That the body moves as if all of it were in $D$, at any width of swing, is seen from the energy: what its
particles have lost in height gives them their velocities.
*/

struct Particle  ///< of a rigid body in its place of rest
{
  Fifty mass;   ///< its mass
  Fifty down;   ///< below the axis
  Fifty aside;  ///< to the right
};

CHECK_THAT("four particles that fall about an axis have at any angle the rotation of a point in D")
{
  const Particle body[] = {{1, 1, 0},
                           {2, Fifty("0.4"), Fifty("0.3")},
                           {3, Fifty("1.7"), Fifty("-0.2")},
                           {1, Fifty("0.9"), 0}};  // Σm·aside = 0: C is below A
  for(const char* const from : {"0.2", "1.5", "3"})
  {
    const Fifty high(from), now = high / 3;
    Fifty fallen = 0, squares = 0, moment = 0;
    for(const Particle& p : body)
    {
      const auto height = [&](const Fifty& x) -> Fifty { return -p.down * cos(x) + p.aside * sin(x); };
      fallen += p.mass * (height(high) - height(now));
      squares += p.mass * (p.down * p.down + p.aside * p.aside);
      moment += p.mass * p.down;
    }
    const Fifty AD = squares / moment;
    CHECK(
        fallen / squares
        == within_relative((cos(now) - cos(high)) / AD, 1e-47, "the height that a point in D has fallen"));
  }
}

CHECK_THAT(
    "a rod and a ball are refused that are beyond 10¹⁰⁰ d or below 10⁻¹⁰⁰ d, and at just that they are not")
{
  for(const char* const within_them : {"d=0.5 L=5e99", "d=0.25 L=2.5e99", "d=2 L=2e-100", "d=4 L=4e-100",
                                       "d=0.5 R=5e99", "d=0.25 R=2.5e99", "d=2 R=2e-100", "d=4 R=4e-100"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"d=0.5 L=5.000000000000002e99", "d=0.25 L=2.500000000000001e99", "d=2 L=1.999999999999999e-100",
       "d=4 L=3.999999999999998e-100", "d=0.5 R=5.000000000000002e99", "d=0.25 R=2.500000000000001e99",
       "d=2 R=1.999999999999999e-100", "d=4 R=3.999999999999998e-100"})
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
At what distance from its middle must a rod be hung to swing as fast as it can, and how much shorter is its
simple pendulum then than when it hangs by its end?

answer: At $L/\sqrt{12} = {{at|3}}\,L$; there it is ${{shortest|3}}\,L$ against ${{rod|3}}\,L$: `--d 0.2887`
tells it.
:::
*/

CHECK_THAT("a rod swings fastest about an axis 0.289 L from its middle, with 0.577 L for 0.667 L")
{
  const Fifty k = 1 / sqrt(Fifty(12));
  CHECK(k == within(Fifty("0.289"), 5e-4, "three decimals"));
  CHECK(by_k(k, k * k) == within(Fifty("0.577"), 5e-4, "three decimals"));
  CHECK(by_k(Fifty("0.5"), k * k) == within(Fifty("0.667"), 5e-4, "three decimals"));
}
