#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/plate.hpp"
#include "pendulum/series.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 2, "The figure, and the time that is sought")

using pendulum::ratio_by_mean, pendulum::Point, pendulum::at, pendulum::line, pendulum::arc;

/*!
## What Euler does

First the scene: an axis, a vertical, a line through the centre of gravity, and the time from the one line to
the other, of which two make an oscillation. The point $A$ of the figure is a horizontal axis, about which
some pendulum $AG$ swings. The plane of the figure is vertical and the axis stands at right angles to it, so
that every swing takes place in this plane. The vertical line $AB$ is the pendulum's natural position, the one
in which it can stay at rest; and it does so when the centre of gravity of the whole pendulum lies in $AB$.

The angle $BAG = \zeta$ is the greatest excursion, the one to which the pendulum departs from the vertical by
turns on both sides. What is to be found is the time in which it comes from the oblique position $AG$ to the
vertical $AB$: call it $t$. Taken twice it gives the time of one oscillation,

$$ T = 2t . \tag{1} $$

::: margin
An *oscillation* is here one swing, from one side to the other. Today's period, there and back, is $2T = 4t$.
:::

And it is plain by itself that the line $AG$, from which the excursion is counted, has to be drawn from the
axis through the centre of gravity of the whole pendulum, whatever the shape of the body may be.

## The program

To see {{eq 1}} as a fact the time has to be added up from one side to the other, element by element. How long
each element takes is known from {{sec pendulum.07}} on; in the unit $\sqrt b/\sqrt{2g}$ it is
$d\Phi/\sqrt{2(\cos\Phi-\cos\zeta)}$, where $\Phi$ is the present angle with the vertical. The turning points,
where the pendulum stands, make that infinite. So the swing is cut up evenly not in $\Phi$ but in an angle
$\varphi$ with $\Phi = \zeta\cos\varphi$, which runs from 0 on one side through 90° at the lowest point to
180° on the other side. The element becomes

$$ \frac{d\varphi}{\sqrt{S(\zeta\cos^2\tfrac12\varphi)\;S(\zeta\sin^2\tfrac12\varphi)}},
   \qquad S(x) = \frac{\sin x}x . \tag{2} $$

Nothing is infinite in it any more, and nothing cancels however small the swing. It is the same at $\varphi$
and at $180°-\varphi$, where the two factors have changed places: that is {{eq 1}}.
*/

/// The element of time (2) over dφ, from the cosine and sine of half of φ.
template <class Real>
Real element(Real zeta, Real c, Real s)  // (2)
{
  using std::sin, std::sqrt;
  const auto S = [](Real x) { return x > 0 ? sin(x) / x : Real(1); };
  return 1 / sqrt(S(zeta * c * c) * S(zeta * s * s));
}

/*!
The sum takes each of $n$ equal parts of φ by its middle. Because {{eq 2}} repeats itself over and over beyond
the ends, the errors of this simplest of all rules cancel, and its digits double whenever $n$ does.
*/

double time_between(double from, double to, double zeta, int n)  // φ from `from` to `to`
{
  const double part = (to - from) / n;
  double sum = 0;
  for(int i = 0; i < n; ++i)
  {
    const double half = (from + (i + 0.5) * part) / 2;
    sum += element(zeta, std::cos(half), std::sin(half));
  }
  return sum * part;
}

/*!
The reader may change how far the pendulum swings, its length, and the number of parts.
*/

const auto swing_ = amplitude(40_deg, from_below(0_deg, 180_deg));
const auto b = real("b", 1.0, metres, positive, "length of the simple pendulum that swings alike");
const auto g = real("g", 4.903325, metres, positive, "height fallen in the first second");
const auto n = integer("n", 2, 1, 100'000, "parts into which each half of the swing is cut");

TELL
{
  const double unit = std::sqrt(b) / std::sqrt(2 * g);
  const double down = time_between(0_deg, 90_deg, swing_.zeta, n);
  const double up = time_between(90_deg, 180_deg, swing_.zeta, n);
  tell("t", unit * down, seconds, "from AG down to AB");
  tell("up", unit * up, seconds, "from AB up to the other side");
  tell("T", unit * (down + up), seconds, "one oscillation");  // (1)
  tell("dimensionless", down, "t√(2g)/√b");
  const double exact = swing::quarter_time({swing_.zeta, swing_.eta});
  tell("error", down / exact - 1, "the relative error of that, from so few parts");
}

/*!
The same sum over equal parts of $\Phi$ itself shows why it is not done that way.
*/

double in_equal_angles(double zeta, int parts)
{
  double sum = 0;
  for(int i = 0; i < parts; ++i)
  {
    const double phi = zeta * (i + 0.5) / parts;
    sum += zeta / parts / std::sqrt(2 * (std::cos(phi) - std::cos(zeta)));
  }
  return sum;
}

TELL
{
  const double zeta = swing_.zeta, eta = swing_.eta;
  if(!(zeta > 1e-7))
    return;  // the difference of the cosines is nothing but its rounding
  std::vector<Method> ways;
  const auto way = [&](int parts, const char* of, auto sum) {
    ways.push_back({std::to_string(parts) + " equal parts of " + of, sum, of});
  };
  for(const int parts : {4, 16, 64, 256})
    way(parts, "Φ", [=] { return in_equal_angles(zeta, parts); });
  for(const int parts : {1, 2, 4, 8})
    way(parts, "φ", [=] { return time_between(0_deg, 90_deg, zeta, parts); });
  ways.push_back({"this edition", [=] { return swing::quarter_time({zeta, eta}); }});
  race("t", "t√(2g)/√b", exact::pi() / 2 * ratio_by_mean(swing_.eta.fifty()), ways);
}

TELL
{
  curve("fig_1", {"x", "y"}, [](Curve& c) {
    const Point A{0, 0}, G = at(1, swing_.zeta);
    line(c, A, at(1, 0));                // AB
    line(c, A, G);                       // AG
    line(c, A, at(1, -swing_.zeta));     // the other side
    line(c, G, {G.x, G.y - 0.22});       // GH
    arc(c, 1, -swing_.zeta, swing_.zeta);
    arc(c, 0.28, 0, swing_.zeta);
  });
}

/*!
Two parts of each half give $t$ with a relative error of {{error|e1}}; from eight on nothing is left to see
but rounding.

::: figure pendulum-02
alt: A point A at the top. From it a vertical line down to B, an oblique line down to the right to G, and a
dashed line as far to the left. An arc leads from the dashed line's end through B to G. The angle between AB
and AG is marked ζ. From G a short arrow leads straight down to H.

The first figure of Euler's plate, drawn after the text. $A$ is the axis seen end on, $AB$ the position of
rest, $G$ the centre of gravity at the greatest excursion ζ, and $GH$ the vertical in which gravity acts, of
which {{sec pendulum.03}} will speak. The time from $G$ to $B$ is $t$; that from $G$ to the end of the dashed
line is $T$.
:::

## Checks

The judge adds up the whole swing in $\Phi$, from $-\zeta$ to $\zeta$, in fifty digits and with both of its
infinite ends.
*/

Fifty from_side_to_side(double zeta)
{
  const auto element_in_phi = [&](const Fifty&, const Fifty& to_end) {
    const Fifty e = abs(to_end);  // ζ − Φ on the one side, ζ + Φ on the other
    return 1 / sqrt(4 * sin(e / 2) * sin(Fifty(zeta) - e / 2));
  };
  return exact::integrate_from_ends(element_in_phi, -Fifty(zeta), Fifty(zeta)).value;
}

CHECK_THAT("the time from side to side is twice the time from AG to AB")
{
  for(const double zeta : {1e-8, 20_deg, 40_deg, 90_deg, 150_deg})
  {
    const Fifty T = from_side_to_side(zeta);
    const double t = time_between(0_deg, 90_deg, zeta, 16);
    CHECK(2 * t == within_ulps(T, 16, "sixteen elements of four roundings each, and their sum"));
    CHECK(time_between(90_deg, 180_deg, zeta, 16) == within_ulps(t, 16, "the same elements in reverse"));
    const Fifty by_mean = exact::pi() * ratio_by_mean(exact::pi() - Fifty(zeta));
    CHECK(T == within(by_mean, 1e-38, "the quadrature's forty digits"));
  }
}

CHECK_THAT("at 20° and at a hundred-millionth of a radian the time is known to thirty digits")
{
  const Fifty at_20("1.58284280433835074868491653517"), at_nothing("1.57079632679489662904879873411");
  CHECK(time_between(0_deg, 90_deg, 20_deg, 8) == within_ulps(at_20, 8, "eight elements and their sum"));
  CHECK(time_between(0_deg, 90_deg, 1e-8, 8) == within_ulps(at_nothing, 8, "eight elements and their sum"));
  CHECK(from_side_to_side(1e-8) / 2 == within(at_nothing, 1e-29, "the digits given"));
  CHECK(std::cos(5e-9) - std::cos(1e-8) == 0);  // which is what the difference of the cosines would have said
}

CHECK_THAT("twice as many parts of φ give twice as many digits")
{
  const double exact_time = swing::quarter_time({150_deg, 30_deg});
  const auto error = [&](double time) { return std::abs(time / exact_time - 1); };
  const auto digits = [&](int parts) {
    return -std::log10(error(time_between(0_deg, 90_deg, 150_deg, parts)));
  };
  CHECK(digits(4) / digits(2) == between(1.8, 2.2, "the error is a power with n in the exponent"));
  CHECK(digits(8) / digits(4) == between(1.8, 2.2, "and so on, up to rounding"));
  CHECK(error(in_equal_angles(150_deg, 400))
        == within_relative(error(in_equal_angles(150_deg, 100)) / 2, 0.01, "in Φ it only falls like 1/√n"));
}
