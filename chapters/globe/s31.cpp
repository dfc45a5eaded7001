#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "globe/asked.hpp"

SECTION(globe, 31, "What friction does to the rocking")

using namespace globe;

/*!
## What Euler does

Friction slows the rocking, and by no small part, since it makes the ball roll and turn about another point.
The two lengths of {{sec globe.30}} are set side by side. On the smooth plane the pendulum that keeps time
with the ball is $kk/c$ long, on the rough one

$$ l = \frac{(a-c)^2+kk}{c}, \tag{1} $$

and as the times are as the roots of the lengths, the times without and with friction are in the ratio

$$ k : \sqrt{(a-c)^2+kk}. \tag{2} $$

What is added under the root is a square. So unless $a - c = 0$, where the centre of gravity lies in the
surface itself, friction always retards the rocking. And in both cases the swings are the slower the nearer
$G$ is to the centre $C$: if $c = 0$, both lengths are infinite. Such a ball has no lowest place; it lies at
rest in every position.

::: margin
Today: without friction the ball turns about an axis through $G$, when rolling about the point of contact;
{{eq 2}} compares the two *radii of gyration*.
:::

The first statement holds for every $c$, and is without a limit: with the mass gathered near $G$, $k$ is
small, and the ratio becomes as large as one likes. A ball of even density, loaded with next to nothing, has
$kk = \tfrac25aa$; friction slows it in the ratio of 1 to {{even|4}}.

The second statement is about balls, and for them it is right. On a smooth plane $kk/c$ falls
with $c$, whatever $c$ is. But {{eq 1}} has two members, $(aa + kk)/c - 2a$ and $c$, of which the second
grows: it is least where

$$ \begin{aligned} c &= \sqrt{aa+kk}, \\ l &= 2c - 2a = \frac{2kk}{\sqrt{aa+kk}+a}, \end{aligned} \tag{A} $$

and from there on the rocking grows slower again. No ball gets there, since $c$ would have to exceed $a$, and
the centre of gravity would lie outside. A cradle may, if its centre of gravity hangs deeper than the
rockers, and {{sec globe.32}} extends all this to cradles.

## The program

The difference $a - c$ is squared, not $aa$ and $ac$ subtracted. How much the times differ is formed from the
square that is added: it keeps its digits where that is small against $kk$.
*/

template <class Real>
Real rolling_length(const Ball<Real>& ball)  // (1)
{
  return ball.gap / ball.c * ball.gap + ball.k / ball.c * ball.k;
}

double ratio(const Ball<double>& ball)  // (2), the second over the first
{
  return std::hypot(ball.gap, ball.k) / ball.k;
}

double slowed(const Ball<double>& ball)  // the same, less one
{
  const double r = ball.gap / ball.k;
  return std::abs(r) > 1 ? ratio(ball) - 1 : r * (r / (1 + ratio(ball)));
}

double quickest(const Ball<double>& ball)  // (A)
{
  return std::hypot(ball.a, ball.k);
}

double least_length(const Ball<double>& ball)  // (A)
{
  return ball.k / (quickest(ball) + ball.a) * 2 * ball.k;
}

const auto a = real("a", 1, feet, scale, "radius of the ball, or of curvature of the rockers");
const auto c = real("c", 0.1, feet, scale, "CG, from their centre to the centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");

TELL
{
  const Ball<double> ball = rounded_ball(a, c, k);
  const double per_root = std::numbers::pi / (std::sqrt(2.) * std::sqrt(g) * std::sqrt(c));
  tell("l_smooth", k / c * k, feet, "length of the pendulum that keeps time on a smooth plane");
  tell("l_rolling", rolling_length(ball), feet, "the same when rolling, (1)");
  tell("swing_smooth", per_root * k, seconds, "a single small swing on a smooth plane");
  tell("swing_rolling", per_root * std::hypot(ball.gap, k), seconds, "the same when rolling");
  tell("ratio", ratio(ball), "the second time over the first, (2)");
  tell("slowed", slowed(ball), percent, "by how much it is longer");
  tell("c_quickest", quickest(ball), feet, "the c with which the rolling pendulum is shortest, (A)");
  tell("l_least", least_length(ball), feet, "and how long it is then");
  tell("partner", quickest(ball) / c * quickest(ball), feet, "the other c with that rolling pendulum");
  tell("even", std::sqrt(3.5), "the ratio for a ball of even density, next to nothing added");
}

TELL
{
  auto& lengths = table("lengths", "Both pendulums, from hardly any load to a deep cradle",
                        {{"c", "c (feet)", none, 4},
                         {"smooth", "smooth", feet},
                         {"rolling", "rolling", feet},
                         {"ratio", "times, ratio"}});
  for(const double part : {0.001, 0.1, 0.5, 1.0, 2.0, 10.0})
  {
    const Ball<double> ball{a, part * a, k};
    lengths.row({ball.c, k / ball.c * k, rolling_length(ball), ratio(ball)});
  }
}

TELL
{
  curve("both", {"c", "smooth", "rolling"}, [](Curve& both) {
    for(int n = -40; n <= 40; ++n)
    {
      const Ball<double> ball{1, std::pow(10, n / 40.), k / a};
      both.put({ball.c, ball.k / ball.c * ball.k, rolling_length(ball)});
    }
  });
  curve("marks", {"c", "l"}, [](Curve& marks) {
    const Ball<double> ball{1, 1, k / a};
    marks.put({1, rolling_length(ball)});
    marks.put({quickest(ball), least_length(ball)});
  });
}

/*!
A single swing of our ball takes {{swing_rolling|5}} seconds when it rolls, without friction
{{swing_smooth|5}}: friction makes it longer by {{slowed|3}}.

{{table lengths}}

::: figure globe-31
alt: Two curves of length against c, both axes logarithmic. The one for the smooth plane is a straight line
that falls. The one for rolling lies above it, touches it at c = a, turns a little further on and rises.

The pendulums that keep time, for our $k/a$: without friction (grey) and when rolling (blue). They touch at
$c = a$. To the right of that there are cradles only; the rolling pendulum is shortest at the second point,
$c = {{c_quickest|4}}\,a$.
:::

## Checks

The times are held against the motion itself: the ball is sent off from its lowest place with hardly any
velocity, by the equations of {{sec globe.03}}, {{sec globe.06}} and {{sec globe.07}}, and has to be back
there.
*/

Fifty left_over(const Ball<Fifty>& ball, const Fifty& g_, const Fifty& swing, bool rolls)
{
  const Fifty w = Fifty("1e-15") / swing;
  const auto motion = [&](const Fifty&, const exact::State& s) {
    const Fifty Phi = s[0] * w, turning = s[1] * w;
    const auto moved = rolls ? rolling_accelerations<Fifty>(ball, g_, Phi, turning)
                             : accelerations<Fifty>(ball, g_, Phi, turning, 0);
    return exact::State{s[1] * swing, moved.Phi / w * swing};
  };
  return exact::solve(motion, 0, {0, 1}, 1).y[0] / swing;
}

CHECK_THAT("after the times told the ball is back at its lowest place, on either plane")
{
  for(const Told& now : told_at("", "a=1 c=3 k=0.2 g=0.5", "a=1e-40 c=2e-45 k=3e-40 g=1e-60"))
  {
    const Ball<Fifty> ball{a.fifty(), c.fifty(), k.fifty()};
    const Fifty smooth = exact::pi() * ball.k / sqrt(2 * g.fifty() * ball.c),
                rolling = exact::pi() * sqrt(bb(ball)) / sqrt(2 * g.fifty() * ball.c);
    CHECK(left_over(ball, g.fifty(), smooth, false)
          == within(0, 1e-26, "the square of the amplitude is left out"));
    CHECK(left_over(ball, g.fifty(), rolling, true)
          == within(0, 1e-22, "the square of the amplitude is left out"));
    CHECK(now.value("swing_smooth", seconds) == within_relative(smooth, 2e-15, "six roundings"));
    CHECK(now.value("swing_rolling", seconds) == within_relative(rolling, 2e-15, "seven roundings"));
    CHECK(now.value("ratio") == within_relative(rolling / smooth, 1e-15, "three roundings"));
    CHECK(now.value("slowed", percent) == within_relative(rolling / smooth - 1, 2e-15, "six roundings"));
    CHECK(now.value("l_smooth", feet)
          == within_relative(2 * g.fifty() * pow(smooth / exact::pi(), 2), 1e-15, "three roundings"));
    CHECK(now.value("l_rolling", feet)
          == within_relative(2 * g.fifty() * pow(rolling / exact::pi(), 2), 1e-15, "six roundings"));
  }
}

CHECK_THAT("a part in a million million of friction's work is told as well as a part of a half")
{
  for(const Told& now :
      told_at("c=1.0000001 k=0.5", "c=0.999999999 k=1e-9", "c=1 k=1e-100", "c=0.999 k=1e10"))
  {
    const Fifty r = (a.fifty() - c.fifty()) / k.fifty();
    CHECK(now.value("slowed", percent) == within_relative(sqrt(1 + r * r) - 1, 2e-15, "some roundings"));
  }
}

CHECK_THAT("the rolling pendulum is shortest at the c of (A), and as long as is told")
{
  for(const Told& now : told_at("", "k=30", "a=1e-70 k=1e-80"))
  {
    const Fifty a_ = a.fifty(), k_ = k.fifty(), best = sqrt(a_ * a_ + k_ * k_);
    const Fifty least = rolling_length(Ball<Fifty>{a_, best, k_}), step = Fifty("1e-6") * best;
    CHECK(now.value("c_quickest", feet) == within_relative(best, 1e-15, "(A)"));
    CHECK(now.value("l_least", feet) == within_relative(2 * best - 2 * a_, 2e-15, "five roundings"));
    CHECK(least == within_relative(2 * best - 2 * a_, 1e-8, "(A); of the digits of a few are left"));
    for(const int sign : {-1, 1})
      CHECK(rolling_length(Ball<Fifty>{a_, best + sign * step, k_}) > least);
  }
}

CHECK_THAT("a ball of even density has 2/5 of aa for kk, and is slowed in that ratio")
{
  // the moment of inertia of a ball about a diameter, from discs of the height z: ½π(1 − zz)² over the volume
  const Fifty kk =
      exact::integrate([](const Fifty& z) { return Fifty(pow(1 - z * z, 2) / 2); }, -1, 1).value * 3 / 4;
  CHECK(kk == within(Fifty(2) / 5, 1e-38, "the rule's bound"));
  for(const Told& now : told_at(""))
    CHECK(now.value("even") == within_relative(sqrt(1 + 1 / kk), 1e-15, "(2) with c = 0"));
}

CHECK_THAT("the table and the curves are (1) and (2), and only at c = a the pendulums are equally long")
{
  for(const Told& now : told_at("", "k=30", "a=1e-70 k=1e-69"))
    for(const auto& row : now.rows("lengths"))
    {
      const Ball<Fifty> ball{a.fifty(), row.at("c"), k.fifty()};
      const Fifty smooth = ball.k * ball.k / ball.c, rolling = smooth + pow(ball.a - ball.c, 2) / ball.c;
      const char* const because = "some roundings, and that of c in a − c";
      CHECK(row.value("c") == between(ball.a / 1001, 10.01 * ball.a, "from a thousandth of a to ten a"));
      CHECK(row.value("smooth", feet) == within_relative(smooth, 1e-15, because));
      CHECK(row.value("rolling", feet) == within_relative(rolling, 2e-15, because));
      CHECK(row.value("ratio") == within_relative(sqrt(rolling / smooth), 2e-15, because));
      CHECK((row.at("smooth", feet) == row.at("rolling", feet)) == (row.at("c") == double(a)));
    }
  for(const Told& now : told_at(""))
  {
    for(const auto& point : now.points("both", 9))
    {
      const Fifty c_ = point.at("c"), smooth = k.fifty() * k.fifty() / c_;
      CHECK(point.value("c") == between(0.1, 10, "what is drawn"));
      CHECK(point.value("smooth") == within_relative(smooth, 1e-15, "three roundings"));
      CHECK(point.value("rolling")
            == within_relative(smooth + (1 - c_) * (1 - c_) / c_, 2e-15, "six roundings"));
    }
    for(const auto& point : now.points("marks"))
    {
      CHECK(point.value("c") == between(1, 1.2, "c = a, and the shortest"));
      CHECK(point.value("l")
            == within_relative((pow(1 - Fifty(point.at("c")), 2) + k.fifty() * k.fifty()) / point.at("c"),
                               1e-14, "(1)"));
    }
  }
}

/*!
## Go on from here

::: exercise
A cradle rocks as fast with one $c$ as with another. How are the two related?

answer: $cc' = aa + kk$: {{eq 1}} is $(aa+kk)/c + c - 2a$, and the two members change places. With our ball's
$c$ the other is {{partner|4}} feet.
:::
*/

CHECK_THAT("c and (aa + kk)/c give pendulums of one length")
{
  for(const Told& now : told_at("", "c=3 k=2", "a=1e-30 c=1e40"))
  {
    const Ball<Fifty> ball{a.fifty(), c.fifty(), k.fifty()};
    const Fifty other = (ball.a * ball.a + ball.k * ball.k) / ball.c;
    CHECK(rolling_length(Ball<Fifty>{ball.a, other, ball.k})
          == within_relative(rolling_length(ball), 1e-40, "fifty digits"));
    CHECK(now.value("partner", feet) == within_relative(other, 1e-15, "four roundings"));
  }
}
