#include <vector>

#include "edition/section.hpp"
#include "pendulum/body.hpp"
#include "pendulum/equation.hpp"

SECTION(pendulum, 3, "What is left of a body: M, a and k")

using pendulum::Elements, pendulum::body_of, pendulum::moment_of_inertia, pendulum::three_weights;

/*!
## What Euler does

Three numbers are all that the motion knows of a body: its mass, how far its centre of gravity is from the
axis, and its radius of gyration. However the pendulum may be put together, let $G$ be the centre of gravity
of the whole, $AG = a$ its distance from the axis, and $M$ the mass, the letter at the same time meaning the
weight. Then gravity acts on it just as if a single force $M$ were applied at $G$ in the vertical direction
$GH$.

The principles of motion ask for one thing more, the moment of inertia of the whole pendulum about an axis
through $G$ parallel to the axis of gyration. It is found by multiplying each element of the body by the
square of its distance from that axis and gathering all these products into one sum. Let it be

$$ \sum rr\,dM = Mkk , \tag{1} $$

as one may, since a length $k$ can always be assigned such that $Mkk$ equals the sum, whatever it is. And once
the moment about $G$ is known, mechanics teaches that the moment about the axis of gyration $A$ is

$$ M(aa + kk) . \tag{2} $$

::: margin
Today: $I_A = m(a^2 + k^2)$, the theorem of the parallel axis (Steiner's, Huygens's); $k$ is the *radius of
gyration* about the centre of mass.
:::

So three numbers are all that the motion will ever know of the body, and $M$ is going to cancel.

## The program

A body is a list of elements, a mass and a place each. The centre of gravity and $k$ are sums over them, and
so is the moment of inertia about any point.

::: code pendulum/body.hpp body
:::

::: code pendulum/body.hpp sum_of_squares
:::

Against these sums stands what Euler puts in their place.
*/

double about_the_axis(double M, double a, double k)  // (2)
{
  return M * (a * a + k * k);
}

/*!
Real bodies have no elements, they have to be cut. A rod is cut into $n$ pieces, each as if it were all in its
middle. A disc, or a ball seen along the axis, is cut into $n$ rings; how much of it lies within each radius
is a known function.
*/

Elements rod(double length, double a, double M, int n)  // along AG, its middle at G
{
  Elements pieces(3, n);
  for(int i = 0; i < n; ++i)
    pieces.col(i) << M / n, 0, -a + length * ((i + 0.5) / n - 0.5);
  return pieces;
}

Elements rings(double (*mass_within)(double), int n)  // of radius and mass 1, six weights to a ring
{
  Elements pieces(3, 6 * n);
  for(int i = 0; i < 6 * n; ++i)
  {
    const double ring = i / 6, r = (ring + 0.5) / n, turn = i % 6 * 60_deg;
    const double mass = mass_within((ring + 1) / n) - mass_within(ring / n);
    pieces.col(i) << mass / 6, r * std::cos(turn), r * std::sin(turn);
  }
  return pieces;
}

double disc(double r) { return r * r; }
double ball(double r) { return 1 - std::pow(1 - r * r, 1.5); }

/*!
The reader may change the rod, where it is hung, and into how many pieces it is cut.
*/

const auto L = real("L", 1.0, metres, positive, "length of a rod");
const auto a = real("a", 0.5, metres, positive, "distance AG of its middle from the axis");
const auto M = real("M", 1.0, Unit{"kg"}, positive, "its mass");
const auto n = integer("n", 10, 1, 10'000, "pieces into which the rod is cut, or rings");

TELL
{
  const Elements pieces = rod(L, a, M, n);
  const double k = L / std::sqrt(12);
  tell("k", k, metres, "the rod's radius of gyration, L/√12");
  tell("k_of_pieces", body_of(pieces).k, metres, "that of its n pieces");  // (1)
  tell("about_A", about_the_axis(M, a, k), Unit{"kg m²"}, "the rod's moment of inertia about A, M(aa+kk)");
  tell("about_A_of_pieces", moment_of_inertia(pieces, {0, 0}), Unit{"kg m²"}, "that of its pieces, added up");
  auto& rows = table("bodies", "Radius of gyration: of n rings, and as the limit is known",
                     {{"body", "body of radius 1"}, {"rings", "k of n rings"}, {"known", "k", none, 10}});
  rows.row({"disc", body_of(rings(disc, n)).k, std::sqrt(0.5)});
  rows.row({"ball", body_of(rings(ball, n)).k, std::sqrt(0.4)});
}

/*!
A body can be far from any rod, and its centre of gravity need not be in it. The one drawn here is three
weights on a frame that weighs nothing.
*/

TELL
{
  const auto body = body_of(three_weights());
  tell("a_of_three", body.a(), "three weights: a, in units of their places");
  tell("k_of_three", body.k, "three weights: k");
  curve("body", {"x", "y", "size"}, [&](Curve& c) {
    const Elements weights = three_weights();
    for(int i = 0; i < 3; ++i)
      c.put({weights(1, i), weights(2, i), std::sqrt(weights(0, i))});
    c.put({body.G.x(), body.G.y(), body.k});
  });
}

/*!
{{n}} pieces of the rod have $k$ = {{k_of_pieces|8}} instead of {{k|8}}: cutting makes it a little too small,
because in each piece the ends count for more than the middle.

::: figure pendulum-03
alt: Three dots of different size around a point G, all joined to it by thin lines. A circle of radius k about
G runs among them. Above is the axis A, joined to G by a heavy line marked a.

Three weights, their areas as their masses, on one body hung at $A$. All of it spread evenly on the circle of
radius $k$ about $G$ would move exactly as the three weights do: the same $M$, the same $a$, the same $k$.
:::

## Checks

The theorem {{eq 2}} holds without any rounding, and in exact fractions it can be tried without any: for the
three weights, and for bodies strewn about at random.
*/

struct Exact
{
  Rational m, x, y;
};

/// The sum of squares about A, less M·aa, less the sum of squares about G.
Rational parallel_axis_is_wrong_by(const std::vector<Exact>& body)
{
  Rational sum, X, Y, at_A, at_G;
  for(const auto& [m, x, y] : body)
    sum += m, X += m * x, Y += m * y, at_A += m * (x * x + y * y);
  X /= sum, Y /= sum;
  for(const auto& [m, x, y] : body)
    at_G += m * ((x - X) * (x - X) + (y - Y) * (y - Y));
  return at_A - sum * (X * X + Y * Y) - at_G;
}

CHECK_THAT("the moment about A is exactly M(aa + kk)")
{
  const auto tenths = [](int t) { return Rational(t, 10); };
  CHECK(parallel_axis_is_wrong_by({{1, tenths(3), tenths(-11)},
                                   {2, tenths(-2), tenths(-4)},
                                   {tenths(5), tenths(9), tenths(-23)}}) == 0);
  unsigned state = 1777;
  const auto next = [&] { return static_cast<int>((state = state * 1664525 + 1013904223) >> 20) - 2000; };
  for(int bodies = 0; bodies < 20; ++bodies)
  {
    std::vector<Exact> body;
    for(int i = 0; i < 7; ++i)
      body.push_back({Rational(std::abs(next()) + 1, 7), Rational(next(), 13), Rational(next(), 11)});
    CHECK(parallel_axis_is_wrong_by(body) == 0);
  }
}

CHECK_THAT("the three weights have the a and k, and the length b, that thirty digits give")
{
  const auto body = body_of(three_weights());
  CHECK(body.M == 3.5);
  CHECK(body.a() == within_ulps(Fifty("0.877147510457642931755625435942"), 4, "two sums of three, a root"));
  CHECK(body.k == within_ulps(Fifty("0.766651877999927895911716686422"), 6, "six squares, a sum, a root"));
  const double b = pendulum::equivalent_length(body.a(), body.k);
  CHECK(b == within_ulps(Fifty("1.54722306221308368598803956207"), 8, "a and k as above"));
  CHECK(about_the_axis(body.M, body.a(), body.k)
        == within_ulps(Fifty(moment_of_inertia(three_weights(), {0, 0})), 16, "twice the errors of a and k"));
}

/*!
A rod of $n$ pieces has $kk = \frac1{12}LL\,(1 - 1/nn)$ and a disc of $n$ rings $\frac12(1 - 1/2nn)$ of the
square of its radius; for the ball the limit is $\frac25$, and what is amiss falls nearly as fast. And the
circle of radius $k$ does stand for the body.
*/

CHECK_THAT("what cutting takes from k is known")
{
  for(const int pieces : {1, 2, 10, 1000})
  {
    const double nn = 1.0 * pieces * pieces;
    CHECK(std::pow(body_of(rod(1, 0.5, 1, pieces)).k, 2)
          == within((1 - 1 / nn) / 12, 2e-16 * pieces, "a rounding of at most 1 for each piece"));
    CHECK(body_of(rod(1, 0.5, 1, pieces)).a() == within(0.5, 2e-16 * pieces, "the same"));
    CHECK(std::pow(body_of(rings(disc, pieces)).k, 2)
          == within((1 - 0.5 / nn) / 2, 1e-15 * pieces, "six roundings of at most 1 for each ring"));
  }
  const auto missing = [](int pieces) { return 0.4 - std::pow(body_of(rings(ball, pieces)).k, 2); };
  CHECK(missing(1000) / missing(2000) == between(3.8, 4, "a quarter, but for the rim's 1/nn√n"));
  CHECK(missing(2000) == within(0, 1e-6, "of the order of 1/nn"));
}

CHECK_THAT("a ring of radius k about G has the body's moment about any axis")
{
  const auto body = body_of(three_weights());
  Elements ring = rings(disc, 1);  // radius ½, mass 1
  ring.row(0) *= body.M;
  ring.bottomRows<2>() *= 2 * body.k;
  ring.bottomRows<2>().colwise() += body.G;
  for(const auto& [x, y] : {std::pair{0.0, 0.0}, {-3.0, 1.0}, {0.7, -0.9}})
  {
    const double of_body = moment_of_inertia(three_weights(), {x, y});
    CHECK(moment_of_inertia(ring, {x, y}) == within_ulps(of_body, 32, "six terms here, three there"));
  }
}

CHECK_THAT("a body as large as numbers get still has its k")
{
  Elements large = three_weights();
  large.bottomRows<2>() *= 0x1p1000;
  CHECK(body_of(large).k == std::ldexp(body_of(three_weights()).k, 1000));
  CHECK(body_of(large).a() == std::ldexp(body_of(three_weights()).a(), 1000));
}
