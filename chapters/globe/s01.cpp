#include "edition/section.hpp"
#include "exact/quadrature.hpp"

SECTION(globe, 1, "What is asked, and of which balls")

/*!
## What Euler does

The subject is a ball whose centre of gravity is not its centre of figure; so wide a question is narrowed to
one that calculation can reach. In its full generality the motion is beyond it. So Euler lets the ball move on
a horizontal plane only, and on it only straight ahead; and since it goes straight ahead, all turning is shut
out except that about the horizontal axis at right angles to the way. How to deal with turning about oblique
axes the analysis of the time does not yet know, he says.

::: margin
Today: *planar motion* of a rigid body. Without these restrictions it is a top on a table, with five
coordinates and a constraint on the velocities.
:::

Whether a ball keeps to such a motion when it is started so is another question, and Euler does not put it.
Let $x$ be measured along the way, $y$ upwards and $z$ along the axis, all from the centre of gravity $G$.
When the ball turns about that axis with the angular velocity $w$, every particle pulls outwards with $ww$
times its mass and distance from the axis. The moments of these pulls, about the line of the way and about
the vertical through $G$, are

$$ -ww\sum m\,yz, \qquad ww\sum m\,xz, \tag{A} $$

and the forces at the point of contact could have such a moment only if one of them acted sideways, which
would push $G$ out of its way. So both sums must vanish: the axis through $G$ must be a *principal axis*. A
ball that is alike on both sides of the vertical plane in which it goes has that property. It is not enough
that $G$ lies in that plane.

## The program

To see it, a homogeneous ball of radius $a$ is loaded with two pellets of equal weight, together the part $q$
of the whole. Their middle lies at the depth $d$ below the centre; one is shifted up and to one side,
the other down and to the other side, by the same amounts. Then $G$ stays in the middle, at

$$ \begin{aligned} c &= qd, \\
   kk &= \tfrac25(1-q)aa + q(1-q)dd\\ &\quad + q\cdot\textit{shift}^2, \end{aligned} \tag{B} $$

$$ \sum m\,yz = q\cdot\textit{shift}\cdot\textit{side}. \tag{C} $$

The sums are taken about $G$ at once, so that nothing is lost where the mass is nearly all in one place.
*/

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto q = real("q", 0.2, none, open(0., 1.), "weight of both pellets, as a part of the whole");
const auto d = real("d", 0.5, feet, scale, "depth of their middle below the centre");
const auto shift = real("shift", 0, feet, closed(0, 1e100), "how far the one is above it, the other below");
const auto side = real("side", 0.25, feet, closed(0, 1e100), "how far they are to the two sides");

struct Inertia
{
  Fifty zz, yy, xx;  // about the axis, the vertical and the line of the way, all through G
  Fifty yz;          // the product
};

Inertia inertia(const Fifty& up)  // (B), (C)
{
  const Fifty q_ = q.fifty(), d_ = d.fifty(), z = side.fifty();
  const Fifty ball = Fifty(2) / 5 * (1 - q_) * a.fifty() * a.fifty();
  const Fifty height = q_ * (1 - q_) * d_ * d_ + q_ * up * up;
  return {ball + height, ball + q_ * z * z, ball + height + q_ * z * z, q_ * up * z};
}

double tilt(const Inertia& sums)  // of the principal axis that is nearest
{
  return sums.yz == 0 ? 0 : 0.5 * std::atan(double(2 * sums.yz / (sums.zz - sums.yy)));
}

/*!
Left to itself, a ball that turns about an axis that is not principal would at once begin to turn about the
line of the way too, with the angular acceleration $-ww\sum m\,yz\,/\sum m\,(yy+zz)$.
*/

TELL
{
  const Fifty a_ = a.fifty(), deep = d.fifty() + shift.fifty(), out = side.fifty();
  require(d.fifty() <= a_, "d", "at most a");
  require(deep <= a_, "shift", "with d no more than a");
  require(deep * deep + out * out <= a_ * a_, "side", "such that the pellets are in the ball");
  const Inertia sums = inertia(shift.fifty());
  tell("c", double(q.fifty() * d.fifty()), feet, "CG");
  tell("k", double(sqrt(sums.zz)), feet, "radius of gyration about the axis through G");
  tell("product", double(sums.yz), Unit{"ft²"}, "Σ m yz about G, the whole mass being one");
  tell("tilt", tilt(sums), degrees, "angle of the nearest principal axis with the axis of turning");
  tell("wobble", double(0 - sums.yz / sums.xx), "angular acceleration about the line of the way, over ww");
  tell("verdict", sums.yz == 0 ? "plane" : "not plane", "what the motion of this ball can be");
}

TELL
{
  auto& balls = table("balls", "The pellets shifted, as far as they stay in the ball",
                      {{"shift", "shift", feet},
                       {"k", "k", feet},
                       {"product", "Σ m yz", Unit{"ft²"}},
                       {"tilt", "tilt", degrees}});
  const double room = std::max(0., a * std::sqrt((1 - side / a) * (1 + side / a)) - d);
  for(int n = 0; n <= 4; ++n)
  {
    const double up = n * room / 4;
    const Inertia sums = inertia(up);
    balls.row({up, double(sqrt(sums.zz)), double(sums.yz), tilt(sums)});
  }
}

TELL
{
  curve("two", {"x", "d", "side", "shift", "G", "tilt"}, [](Curve& two) {
    const double room = std::max(0., std::sqrt((1 - side / a) * (1 + side / a)) - d / a);
    for(int n = 0; n < 2; ++n)
      two.put({2.5 * n, d / a, side / a, n * room, q * d / a, tilt(inertia(n * room * a))});
  });
}

/*!
With the pellets level the ball is the one of the whole chapter: $c$ is {{c}} and $k$ {{k}} foot, and the
motion {{verdict}}.

{{table balls}}

::: figure globe-01
alt: Two circles, balls seen along their way. In the left one two dots lie level below the centre, one to
each side, and the axis through the centre of gravity is horizontal. In the right one a dot is high on the
one side and the other low on the other; the centre of gravity is at the same place, but a second axis
through it slopes.

Two balls seen in the direction in which they go, with the same weights and the same $G$. In the second the
principal axis (blue) is not the axis of turning (grey), and it cannot keep to Euler's motion.
:::

## Checks

A homogeneous ball has the moments of six equal masses at $\pm a\sqrt{3/5}$ on three axes. With the two
pellets that makes eight particles, and of these everything can be summed, particle by particle.
*/

using Vector = std::array<Fifty, 3>;  // along the way, upwards, along the axis

struct Particle
{
  Fifty m;
  Vector r;
};

std::vector<Particle> particles(const Fifty& up)
{
  const Fifty r = a.fifty() * sqrt(Fifty(3) / 5), m = (1 - q.fifty()) / 6, p = q.fifty() / 2;
  const Fifty z = side.fifty(), y = -d.fifty();
  std::vector<Particle> all{{p, {0, y + up, z}}, {p, {0, y - up, -z}}};
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(const int sign : {-1, 1})
    {
      Vector place{0, 0, 0};
      place[axis] = sign * r;
      all.push_back({m, place});
    }
  Vector G{0, 0, 0};
  for(const Particle& one : all)
    for(std::size_t i = 0; i < 3; ++i)
      G[i] += one.m * one.r[i];
  CHECK(G[1] == within(-q.fifty() * d.fifty(), 1e-45 * double(d), "G lies in the middle at the depth c"));
  CHECK(G[2] == within(0, 1e-45 * double(a), "G lies in the plane of the way"));
  for(Particle& one : all)
    one.r[1] -= G[1];
  return all;
}

Vector cross(const Vector& p, const Vector& r)
{
  return {p[1] * r[2] - p[2] * r[1], p[2] * r[0] - p[0] * r[2], p[0] * r[1] - p[1] * r[0]};
}

Fifty moment_of(const std::vector<Particle>& all,
                const Fifty& about_way)  // Σ m r × r'', along the way, w = 1
{
  Fifty sum = 0;
  for(const Particle& one : all)
  {
    const Vector axis{0, 0, 1}, centripetal = cross(axis, cross(axis, one.r)),
                                tilting = cross({about_way, 0, 0}, one.r);
    Vector whole{};
    for(std::size_t i = 0; i < 3; ++i)
      whole[i] = centripetal[i] + tilting[i];
    sum += one.m * cross(one.r, whole)[0];
  }
  return sum;
}

CHECK_THAT("the moments told are those of the eight particles, and the axis told is principal")
{
  for(const Told& now : told_at("", "shift=0.3", "a=1e60 d=3e59 shift=5e59 side=1e59 q=0.999999999999",
                                "d=0.01 q=0.5 shift=0.1 side=0.9", "side=0"))
  {
    const auto all = particles(shift.fifty());
    Fifty kk = 0, yy = 0, product = 0;
    for(const Particle& one : all)
    {
      kk += one.m * (one.r[0] * one.r[0] + one.r[1] * one.r[1]);
      yy += one.m * (one.r[0] * one.r[0] + one.r[2] * one.r[2]);
      product += one.m * one.r[1] * one.r[2];
    }
    const char* const once = "rounded once";
    CHECK(now.value("c", feet) == within_ulps(q.fifty() * d.fifty(), 1, once));
    CHECK(now.value("k", feet) == within_ulps(sqrt(kk), 1, once));
    CHECK(now.value("product", Unit{"ft²"})
          == within(product, 1e-15 * double(abs(product)) + 1e-45 * double(kk), once));
    CHECK(kk + pow(q.fifty() * d.fifty(), 2)
          == between(0, a.fifty() * a.fifty(), "no mass is outside the ball"));
    const bool plane = abs(product) < 1e-45 * kk;
    CHECK(now.value("verdict") == (plane ? "plane" : "not plane"));
    // The principal axis: its angle has the tangent of twice 2Σmyz over the difference of the moments.
    const Fifty twice = plane ? Fifty(0) : atan(2 * product / (kk - yy));
    CHECK(now.value("tilt", degrees) == within(twice / 2, 4e-16, "an arc and a half"));
    const Fifty sine = sin(twice / 2), cosine = cos(twice / 2);
    CHECK((kk - yy) * sine * cosine
          == within(product * (cosine * cosine - sine * sine), 1e-44 * double(kk + yy), "no product left"));
    // With the wobble told no moment is asked for along the way; without it ww times the product is.
    const Fifty asked = moment_of(all, 0), slope = moment_of(all, 1) - asked;
    CHECK(-asked == within(-product, 1e-44 * double(kk + yy), "(A)"));
    CHECK(now.value("wobble")
          == within(-asked / slope, 1e-15 * double(abs(asked / slope)) + 1e-44, "rounded once"));
  }
}

CHECK_THAT("the shifted balls of the table and the figure are summed particle by particle, too")
{
  for(const Told& now : told_at("", "side=0.5 d=0.3", "q=0.001 a=1e-50 d=1e-51 side=2e-51"))
  {
    const auto check = [](const Fifty& up) {
      Fifty kk = 0, yy = 0, product = 0;
      for(const Particle& one : particles(up))
      {
        kk += one.m * (one.r[0] * one.r[0] + one.r[1] * one.r[1]);
        yy += one.m * (one.r[0] * one.r[0] + one.r[2] * one.r[2]);
        product += one.m * one.r[1] * one.r[2];
      }
      return std::array<Fifty, 3>{sqrt(kk), product,
                                  up == 0 ? Fifty(0) : atan(2 * product / (kk - yy)) / 2};
    };
    const Fifty room = sqrt(a.fifty() * a.fifty() - side.fifty() * side.fifty()) - d.fifty();
    int n = 0;
    for(const auto& row : now.rows("balls"))
    {
      const auto expected = check(row.at("shift", feet));
      CHECK(row.value("shift", feet) == within_relative(n++ * room / 4, 4e-15, "a root less d"));
      CHECK(row.value("k", feet) == within_ulps(expected[0], 1, "rounded once"));
      CHECK(row.value("product", Unit{"ft²"})
            == within(expected[1], 1e-15 * double(abs(expected[1])) + 1e-300, "rounded once"));
      CHECK(row.value("tilt", degrees) == within(expected[2], 4e-16, "an arc and a half"));
    }
    n = 0;
    for(const auto& point : now.points("two"))
    {
      const Fifty up = n * room;
      CHECK(point.value("x") == within(2.5 * n++, 0, "two balls side by side"));
      CHECK(point.value("shift") == within(up / a.fifty(), 1e-15, "a root less d"));
      CHECK(point.value("d") == within_relative(d.fifty() / a.fifty(), 4e-16, "two roundings"));
      CHECK(point.value("side") == within_relative(side.fifty() / a.fifty(), 4e-16, "two roundings"));
      CHECK(point.value("G")
            == within_relative(q.fifty() * d.fifty() / a.fifty(), 1e-15, "three roundings"));
      CHECK(point.value("tilt") == within(check(up)[2], 4e-15, "what the shift is off, and an arc"));
    }
  }
}

CHECK_THAT(
    "pellets at the surface of the ball are allowed, and none a hair beyond it: below, shifted, aside")
{
  for(const char* const at_it : {"d=1 side=0", "d=0.75 shift=0.25 side=0", "a=5 d=2 shift=1 side=4"})
    CHECK(!refused_at(at_it));
  for(const char* const beyond : {"d=1.000000000000001 side=0", "d=0.75 shift=0.250000000000001 side=0",
                                  "a=5 d=2 shift=1 side=4.000000000000001"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("a homogeneous ball has two fifths of the square of its radius")
{
  // In spherical shells: each has two thirds of the square of its own radius.
  const Fifty mass = exact::integrate([](const Fifty& r) { return r * r; }, 0, 1).value;
  const Fifty sum = exact::integrate([](const Fifty& r) { return 2 * pow(r, 4) / 3; }, 0, 1).value;
  CHECK(sum / mass == within(Fifty(2) / 5, 1e-45, "fifty digits"));
}

/*!
## Notes

Principal is what the motion needs; whether it is also stable against a small push to the side is another
matter, which depends on the three moments and on the speed, and which a section in one plane cannot show.

## Go on from here

::: exercise
Load the ball with one pellet only, of the weight 1/5, at the depth 1/2 and 1/4 to the side. Where is $G$,
and is the motion plane?
answer: $G$ is at the side too, by 1/20. About it
$\sum m\,yz = -\tfrac15\cdot\tfrac45\cdot\tfrac12\cdot\tfrac14 = -\tfrac1{50}$: not plane.
:::
*/

CHECK_THAT("one pellet to the side has the product −1/50")
{
  const Rational m(1, 5), rest(4, 5), y(-1, 2), z(1, 4);
  const Rational Gy = m * y, Gz = m * z;
  CHECK(Gz == Rational(1, 20));
  CHECK(m * (y - Gy) * (z - Gz) + rest * Gy * Gz == Rational(-1, 50));
}
