#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include <functional>

SECTION(tautochrone, 9, "The centre of oscillation at rest")

/*!
## What Euler does

The body is first considered in its natural place, at rest, and its centre of oscillation there is determined
from one quantity, $kk$. Its centre of gravity is then in the point $C$ of the vertical through $A$, and there
the pendulum will stay for ever if it has no motion yet. Let $D$ be the centre of oscillation of the whole
pendulum in this place. Its distance from $A$ comes out if every particle of the body is multiplied by the
square of its distance from the axis $A$, and the sum of all these products is divided by the mass of the
body times the distance of the centre of gravity from the axis:

$$ AD = \frac{\sum m\,\varrho\varrho}{M\cdot AC}. \tag{1} $$

Or else one thinks of a horizontal axis that goes through the centre of gravity $C$ of the body, parallel to
the axis $A$, which is to be perpendicular to the vertical plane $CAG$, and multiplies the particles by the
squares of *their* distances from that axis. Let the sum of these products be

$$ Mkk, \tag{2} $$

$M$ denoting the mass or weight of the whole pendulum; he calls this expression the *moment of inertia* of the
body with respect to the axis through $C$. Then the rectangle

$$ CD\cdot AC = kk{{entry rectangle}}, \qquad CD = \frac{kk}{AC}, \tag{3} $$

and so the centre of oscillation is determined from the known quantity $kk$.

::: margin
(1) and (3) agree because $\sum m\varrho\varrho = M(AC^2 + kk)$, the theorem of parallel axes. $k$ is the
radius of gyration.
:::

All that the paper needs to know of a body is in $k$. For a homogeneous body of the size $R$ it is
$kk = cRR$, with $c = \frac25$ for a ball, $\frac12$ for a disc that swings in its plane, $\frac14$ for one
that swings across it, 1 for a ring, $\frac13$ for a level rod of the half length $R$. In a clock the stem
has its weight too. If a ball of the radius $R$ hangs at the distance $l$ from $A$ by a straight thin stem
that weighs $\mu$ times as much as the ball, then

$$ \begin{aligned} AC &= l\,\frac{1 + \frac12\mu}{1 + \mu}, \\
  kk &= \frac{1}{1+\mu}\left(\frac25RR + \frac{\mu\,ll}{12} + \frac{\mu\,ll}{4(1+\mu)}\right). \end{aligned}
  \tag{A} $$

A light stem therefore adds nearly $\frac13\mu\,ll$ to $kk$, and that is soon more than the ball has of
itself.

## The program

The two ways to $D$ stand side by side, for the ball with its stem. Of the first nothing is known but
{{eq 1}}, of the second {{eq 3}} and {{eq A}}.
*/

const auto l = real("l", 1, metres, scale, "from the suspension to the middle of the ball");
const auto R =
    real("R", 0.05, metres, scale, "radius of the ball, and the size of the bodies in the table");
const auto mu = real("mu", 0.01, none, closed(0.0, 1e6), "weight of the stem over that of the ball");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

double AC()  // (A)
{
  return l * ((1 + mu / 2) / (1 + mu));
}

double of_ball()  // √(⅖RR)
{
  return std::sqrt(0.4) * R;
}

double of_stem()  // the root of what the stem brings into the bracket of (A)
{
  return std::sqrt(mu / 12 + mu / (4 * (1 + mu))) * l;
}

double k()  // (2), by (A)
{
  return std::hypot(of_ball(), of_stem()) / std::sqrt(1 + mu);
}

double AD()  // (1): the squares of all distances from A, a ball's being its own and its centre's
{
  const double own = R / l * std::sqrt(0.4);
  return l * ((1 + own * own + mu / 3) / (1 + mu / 2));
}

double CD()  // (3)
{
  return k() / AC() * k();
}

TELL
{
  require(R / l <= 1e50, "R", "from 1e-50 l to 1e50 l");
  require(R / l >= 1e-50, "R", "from 1e-50 l to 1e50 l");
  tell("AC", AC(), metres, "from the suspension to the centre of gravity");
  tell("k", k(), metres, "radius of gyration, (2)");
  tell("k_over_AC", k() / AC(), "what makes the pendulum compound");
  const double part = of_stem() / std::hypot(of_ball(), of_stem());
  tell("from_the_stem", part * part, percent, "of kk, what the stem brings");
  tell("CD", CD(), metres, "from there to the centre of oscillation, (3)");
  tell("AD", AD(), metres, "length of the isochronous simple pendulum, (1)");
  tell("T", std::numbers::pi * (std::sqrt(AD()) / std::sqrt(2.0)) / std::sqrt(g), seconds,
       "a narrow swing");
}

struct Shape  ///< of a homogeneous body
{
  const char* name;  ///< what it is
  Rational c;        ///< kk over RR
};

const Shape shapes[] = {{"ball", {2, 5}},
                        {"disc in its plane", {1, 2}},
                        {"disc across it", {1, 4}},
                        {"ring in its plane", 1},
                        {"level rod", {1, 3}}};

TELL
{
  auto& rows = table("bodies", "Bodies of the size R that hang with their centre at l, by light threads",
                     {{"body", "body"}, {"c", "kk/RR"}, {"CD", "CD", metres, 6}, {"AD", "AD", metres, 8}});
  for(const Shape& of : shapes)
  {
    const double beyond = R / l * (double(Fifty(of.c)) * R);
    rows.row({of.name, double(Fifty(of.c)), beyond, l + beyond});
  }
  auto& drawn = table("drawn", "The same with R = 3/10 l, as the figure has them",
                      {{"body", "body"}, {"aside", "aside"}, {"D", "AD/l", none, 8}});
  double aside = 0;
  for(const Shape& of : shapes)
    drawn.row({of.name, aside++, 1 + 0.09 * double(Fifty(of.c))});
}

/*!
The stem of a hundredth of the ball's weight brings {{from_the_stem|percent1}} of $kk$, and so $k$ becomes
{{k_over_AC|3}} of $AC$. The centre of oscillation is {{CD|3}} m below that of gravity.

{{table bodies}}

::: figure tautochrone-09
alt: Five bodies hang side by side with their centres C at the same depth: a ball, a disc seen from the front,
a disc seen from its edge, a ring, and a level rod. In each the centre of oscillation D is marked below C; it
is lowest in the ring and highest in the disc that swings across its plane.

Bodies of one size, $R = \tfrac3{10}AC$, that hang with the centre of gravity $C$ at the same depth, and their
centres of oscillation $D$. The farther the mass is from $C$, the farther is $D$. Between the ticks at the
left is a tenth of $AC$.
:::

## Checks

Each body is taken to pieces: its particles' distances from an axis are summed by quadrature in fifty digits.
*/

Fifty integral(const std::function<Fifty(const Fifty&)>& f, const Fifty& from, const Fifty& to)
{
  return exact::integrate(f, from, to).value;
}

struct Sums  ///< over a body's particles
{
  Fifty weight;   ///< Σm
  Fifty depths;   ///< Σm·depth below A
  Fifty squares;  ///< Σmρρ about A
};

Sums in_pieces()  // the ball of the weight 1 by level slices, the stem by its points
{
  const Fifty r = R.fifty() / l.fifty(), m = mu.fifty();
  const auto area = [&](const Fifty& z) -> Fifty { return (r * r - z * z) / (4 * r * r * r / 3); };
  const auto of_slices = [&](const Fifty& z) -> Fifty {
    return area(z) * ((1 + z) * (1 + z) + (r * r - z * z) / 4);
  };
  const auto of_points = [&](const Fifty& x) -> Fifty { return m * x * x; };
  return {1 + m, 1 + m / 2, integral(of_slices, -r, r) + integral(of_points, 0, 1)};
}

CHECK_THAT("D is where the sum over all particles puts it, by both of Euler's ways")
{
  for(const Told& now :
      told_at("", "l=3 R=0.7 mu=2", "l=1e40 R=1e38 mu=1e-6", "l=0.1 R=2 mu=0 g=3", "R=0.02 mu=1e5"))
  {
    const Sums all = in_pieces();
    const Fifty length = l.fifty(), depth = all.depths / all.weight, D = all.squares / all.depths;
    const Fifty kk = all.squares / all.weight - depth * depth;
    const char* const why = "at most ten roundings";
    CHECK(now.value("AC", metres) == within_relative(length * depth, 1e-15, why));
    CHECK(now.value("AD", metres) == within_relative(length * D, 2e-15, why));
    CHECK(now.value("CD", metres) == within_relative(length * (D - depth), 4e-15, why));
    CHECK(now.value("k", metres) == within_relative(length * sqrt(kk), 2e-15, why));
    CHECK(now.value("k_over_AC") == within_relative(sqrt(kk) / depth, 2e-15, why));
    CHECK(now.value("T", seconds)
          == within_relative(exact::pi() * sqrt(length * D / (2 * g.fifty())), 3e-15, why));
    const Fifty of_it = Fifty("0.4") * pow(R.fifty() / l.fifty(), 2) / all.weight;
    if(mu == 0)
      CHECK(now.value("from_the_stem", percent) == 0);
    else
      CHECK(now.value("from_the_stem", percent) == within_relative(1 - of_it / kk, 3e-15, why));
  }
}

Fifty mean(const std::function<Fifty(const Fifty&)>& density, const std::function<Fifty(const Fifty&)>& of)
{
  const auto both = [&](const Fifty& x) -> Fifty { return density(x) * of(x); };
  return integral(both, 0, 1) / integral(density, 0, 1);
}

Fifty by_integral(const std::string& body)  // kk for R = 1
{
  const auto one = [](const Fifty&) -> Fifty { return 1; };
  const auto x1 = [](const Fifty& x) -> Fifty { return x; };
  const auto xx = [](const Fifty& x) -> Fifty { return x * x; };
  const auto turned = [](const Fifty& x) -> Fifty { return pow(cos(2 * exact::pi() * x), 2); };
  if(body == "ball")  // slices at the height x, of the weight 1 − xx, each xx and a disc's quarter
    return mean([](const Fifty& x) -> Fifty { return 1 - x * x; },
                [](const Fifty& x) -> Fifty { return x * x + (1 - x * x) / 4; });
  if(body == "disc in its plane")
    return mean(x1, xx);
  if(body == "disc across it")  // of each ring only the heights count
    return mean(x1, xx) * mean(one, turned);
  return body == "ring in its plane" ? mean(one, one) : mean(one, xx);
}

CHECK_THAT("the table's bodies have the moments of their integrals, and D by them")
{
  for(const Told& now : told_at("", "l=3 R=0.7", "l=1e-10 R=1e-12"))
    for(const auto& row : now.rows("bodies"))
    {
      const Fifty c = by_integral(row.words("body")), beyond = c * R.fifty() * R.fifty() / l.fifty();
      CHECK(row.value("c") == within_relative(c, 1e-15, "a rounding"));
      CHECK(row.value("CD", metres) == within_relative(beyond, 1e-15, "four roundings"));
      CHECK(row.value("AD", metres) == within_relative(l.fifty() + beyond, 1e-15, "two more"));
    }
  for(const Told& now : told_at(""))
  {
    int at = 0;
    for(const auto& row : now.rows("drawn"))
    {
      CHECK(row.value("aside") == at++);
      CHECK(row.value("D")
            == within_relative(1 + Fifty("0.09") * by_integral(row.words("body")), 1e-15, "roundings"));
    }
    CHECK(at == 5);
  }
}

/*!
In our copy a comma stands for the sign of the product, as if $CD$ and $AC$ were each equal to $kk$. The
formula next to it divides. What is right is decided by particles: two equal ones, $k$ above and $k$ below
$C$.
*/

double CD_of_two(double distance, double k_)  // by (1)
{
  const double above = distance - k_, below = distance + k_;
  return (above * above + below * below) / 2 / distance - distance;
}

const Emendation rectangle{
    "§9, the rectangle",
    {"CD, AC = kk", 0.09},
    {"CD·AC = kk", 0.045},
    "for AC = 2 and k = 0.3 the sum over two particles gives CD so, and the next formula says it",
    [](double reading) {
      return reading == within(CD_of_two(2, 0.3), 1e-15, "two squares and a difference");
    }};

CHECK_THAT("a ball beyond 10⁵⁰ l or below 10⁻⁵⁰ l is refused, and one of just that size is not")
{
  for(const char* const within_them : {"R=1e50", "l=2 R=2e50", "R=1e-50", "l=2 R=2e-50"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"R=1.0000000000000004e50", "l=2 R=2.0000000000000008e50",
                                  "R=9.999999999999997e-51", "l=2 R=1.9999999999999994e-50"})
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
Where is $D$ for a ball with a radius of a tenth of a metre, hung by a light thread with its centre at one
metre? With what stem is $k$ greatest?

answer: At 1.004 m exactly (`--R 0.1 --mu 0`). For a very small ball $k$ is greatest when the stem weighs
twice as much as the ball; then $k = \frac13l$, half of $AC$ (`--mu 2 --R 1e-9`).
:::
*/

CHECK_THAT("the exercise: AD is 1.004 exactly; with a stem of twice the ball's weight k is greatest, l/3")
{
  CHECK(Rational(1) + Rational(2, 5) * Rational(1, 100) == Rational(1004, 1000));
  const auto kk = [](const Rational& m) -> Rational {  // (A) for R = 0, l = 1
    const Rational all = m + Rational(1);
    return m / (Rational(12) * all) + m / (Rational(4) * all * all);
  };
  CHECK(kk(2) == Rational(1, 9));
  CHECK(kk(Rational(19, 10)) < Rational(1, 9));
  CHECK(kk(Rational(21, 10)) < Rational(1, 9));
  for(const Told& now : told_at("mu=2 R=1e-9"))
    CHECK(now.value("k_over_AC") == within(Fifty("0.5"), 1e-15, "half of AC"));
}
