#include "edition/section.hpp"
#include "pendulum/body.hpp"

SECTION(pendulum, 3, "What is left of a body: M, a and k")

using pendulum::Elements, pendulum::body_of, pendulum::moment_of_inertia, pendulum::three_weights;

/*!
## What Euler does

Only three numbers of a body enter its motion: its mass, the distance of its centre of gravity from the axis,
and its radius of gyration. However the pendulum may be put together, let $G$ be the centre of gravity of the
whole, $AG = a$ its distance from the axis, and $M$ the mass, by the same letter also the weight. Gravity then
acts on the pendulum as if a single force $M$ were applied at $G$ in the vertical direction $GH$.

::: margin
Today: $I_A = m(a^2 + k^2)$, the parallel-axis (Huygens–Steiner) theorem; $k$ is the *radius of gyration*
about the centre of mass.
:::

The principles of motion also require the moment of inertia of the whole pendulum about an axis through $G$
parallel to the axis of gyration $A$. It is found by multiplying each element of the pendulum by the square of
its distance $r$ from that axis and gathering all these products into one sum, which he sets equal to $Mkk$,

$$ \sum rr\,dM = Mkk ; \tag{1} $$

for there is always a length $k$ that makes $Mkk$ equal to the sum. And once the moment about $G$ is known,
mechanics teaches that the one about the axis of gyration $A$ is

$$ M(aa + kk) . \tag{2} $$

## The program

A body is a list of elements, each a mass and a place. The centre of gravity and $k$ are sums over them.

::: code pendulum/body.hpp body
:::

::: code pendulum/body.cpp body_of (1)
:::

And so is the moment of inertia about any point, beside which stands Euler's expression for it.

::: code pendulum/body.cpp sum_of_squares
:::
*/

double about_the_axis(double M, double a, double k)  // (2)
{
  return M * (a * a + k * k);
}

/*!
A rod has no elements; it is cut into $n$ pieces, the mass of each taken to be at its middle.
*/

Elements rod(double length, double a, double M, int n)  // along AG, its middle at G
{
  Elements pieces(3, n);
  for(int i = 0; i < n; ++i)
    pieces.col(i) << M / n, 0, -a + length * ((i + 0.5) / n - 0.5);
  return pieces;
}

double radius_of_rod(double length)
{
  return length / std::sqrt(12);
}

const auto L = real("L", 1.0, metres, scale, "length of the rod");
const auto a = real("a", 0.5, metres, scale, "distance AG of its middle from the axis");
const auto M = real("M", 1.0, kilograms, scale, "its mass");
const auto n = integer("n", 10, 1, 10'000, "pieces into which it is cut");

TELL
{
  const Elements pieces = rod(L, a, M, n);
  const double k = radius_of_rod(L);
  tell("k", k, metres, "the rod's radius of gyration, L/√12");
  tell("k_of_pieces", body_of(pieces).k, metres, "that of its n pieces");  // (1)
  tell("about_A", about_the_axis(M, a, k), Unit{"kg m²"}, "the rod's moment of inertia about A, M(aa+kk)");
  tell("about_A_of_pieces", moment_of_inertia(pieces, {0, 0}), Unit{"kg m²"},
       "that of its pieces, added up");
}

/*!
The body drawn below is three weights on a frame without weight. Its centre of gravity lies in none of them.
*/

TELL
{
  curve("body", {"x", "y", "size"}, [](Curve& c) {
    const Elements weights = three_weights();
    const auto body = body_of(weights);
    for(const auto& weight : weights.colwise())
      c.put({weight(1), weight(2), std::sqrt(weight(0))});
    c.put({body.G.x(), body.G.y(), body.k});
  });
}

/*!
The pieces have $k$ = {{k_of_pieces|5}} instead of {{k|5}}: each has lost its own moment of inertia about its
middle.

::: figure pendulum-03
alt: Three dots of different size around a point G, all joined to it by thin lines. A circle of radius k about
G runs among them. Above is the axis A, joined to G by a heavy line marked a.

Three weights, their areas as their masses, joined in one body hung at $A$. If their whole mass were spread
evenly over the circle of radius $k$ about $G$, the body would move exactly as it does: it would have the same
$M$, $a$ and $k$.
:::

## Checks

For the three weights all is known in fractions. Their $kk$ can be had without $G$, from the distances $r$
between them: $MMkk$ is the sum of $mm'rr$ over all pairs (Lagrange), here $\frac{36}5$, and $M = \frac72$.
*/

CHECK_THAT("the three weights have the M, a and k that fractions give, and so the moment about A")
{
  const auto body = body_of(three_weights());
  CHECK(body.M == 3.5);
  CHECK(body.a() == within_ulps(sqrt(Fifty(377) / 490), 2, "two sums of three and a root"));
  CHECK(body.k == within_ulps(sqrt(Fifty(36) / 5) / 3.5, 2, "a sum of six squares and a root"));
  CHECK(moment_of_inertia(three_weights(), {0, 0})
        == within_ulps(4.75, 2, "six squares of rounded tenths"));
  CHECK(about_the_axis(body.M, body.a(), body.k) == within_ulps(4.75, 4, "a and k squared"));
}

CHECK_THAT("for the axis anywhere, M(aa + kk) is the sum of the squares about it")
{
  const auto body = body_of(three_weights());
  for(const double x : {-3.0, 0.1, 0.7})
    for(const double y : {-40.0, -0.9, 2.0})
      CHECK(
          about_the_axis(body.M, (Eigen::Vector2d(x, y) - body.G).norm(), body.k)
          == within_relative(moment_of_inertia(three_weights(), {x, y}), 1e-15, "four or five roundings"));
}

/*!
A piece of the rod is $L/n$ long, and what it has lost is a twelfth of the square of that.
*/

CHECK_THAT("a rod of n pieces has kk = LL(1 − 1/nn)/12, and its middle is its centre of gravity")
{
  for(const int pieces : {1, 2, 10, 1000})
  {
    const auto body = body_of(rod(2, 0.5, 3, pieces));
    CHECK(body.k * body.k == within((1 - 1.0 / pieces / pieces) / 3, 1e-15, "rounded sums up to 1"));
    CHECK(body.a() == within(0.5, 1e-15, "the same"));
  }
}

CHECK_THAT("no square overflows in a body as large as numbers get")
{
  Elements large = three_weights();
  large.bottomRows<2>() *= 0x1p1000;
  CHECK(body_of(large).k == std::ldexp(body_of(three_weights()).k, 1000));
  CHECK(body_of(large).a() == std::ldexp(body_of(three_weights()).a(), 1000));
}

/*!
What is told: the rod and its pieces, by the sums in closed form; and the figure's weights, by their
fractions.
*/

CHECK_THAT(
    "the rod's numbers are L/√12 and M(aa + kk), those of its pieces lack a twelfth of a piece's square")
{
  for(const Told& now : told_at("", "L=3 a=0.01 n=1 M=7", "L=1e-50 a=1e-48 n=1000 M=1e60"))
  {
    const Fifty kk = L.fifty() * L.fifty() / 12, lost = kk / (Fifty(int(n)) * int(n)),
                aa = a.fifty() * a.fifty();
    const double rounding = 1e-14 * static_cast<double>(L + a);
    CHECK(now.value("k", metres) == within_relative(sqrt(kk), 4e-16, "a root and a quotient"));
    CHECK(now.value("k_of_pieces", metres)
          == within(sqrt(kk - lost), rounding, "places that round, as L and a"));
    CHECK(now.value("about_A", Unit{"kg m²"})
          == within_relative(M.fifty() * (aa + kk), 1e-15, "few roundings"));
    CHECK(now.value("about_A_of_pieces", Unit{"kg m²"})
          == within_relative(M.fifty() * (aa + kk - lost), 2e-13, "n rounded squares"));
  }
}

CHECK_THAT("the figure has three weights with their centre of gravity and radius of gyration")
{
  for(const Told& now : told_at(""))
  {
    const auto points = now.points("body");
    REQUIRE(points.size() == 4);
    double mass = 0, x = 0, y = 0;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const double m = points[i].at("size") * points[i].at("size");
      mass += m;
      x += m * points[i].at("x");
      y += m * points[i].at("y");
    }
    CHECK(mass == within(3.5, 1e-15, "the weights are 1, 2 and ½"));
    CHECK(points[3].value("x") == within(Fifty(x) / mass, 1e-15, "the centre of gravity"));
    CHECK(points[3].value("y") == within(Fifty(y) / mass, 1e-15, "the centre of gravity"));
    CHECK(points[3].value("size")
          == within(sqrt(Fifty(36) / 5) / 3.5, 1e-15, "Lagrange's sum over all pairs"));
  }
}

/*!
## Go on from here

::: exercise
How far from its middle must the rod be hung for the moment about the axis to be twice that about the
middle? {{sec pendulum.06}} will tell what is remarkable about this place.

answer: Where $aa = kk$, at $L/\sqrt{12}$ or {{k|6}} metres. Hung there it swings the fastest.
:::
*/

CHECK_THAT("hung at the distance k, a rod has twice the moment that it has about its middle")
{
  for(const Told& now : told_at("a=0.28867513459481287", "L=2 a=0.57735026918962574 M=3"))
    CHECK(now.value("about_A", Unit{"kg m²"})
          == within_relative(2 * M.fifty() * L.fifty() * L.fifty() / 12, 1e-15, "few roundings"));
}
