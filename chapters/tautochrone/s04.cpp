#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

SECTION(tautochrone, 4, "The resistance of the air")

using namespace tautochrone;

/*!
## What Euler does

Of the two causes that spoil Huygens's theorem, the resistance of the medium is the lesser by far, although
geometers have laboured on it far more than on the other. Air is so thin that its resistance is very small and
may be neglected without notable error. The extension of the body, he announces, will be seen to bring a much
greater inequality into the motion.

What is known of the resistance he reports in three steps. If it were proportional to the velocity, the
cycloid would serve as well as in empty space: Newton proved it for the simple pendulum. But the resistance
of the air does not follow the velocity, it follows its square. There the use of the cycloid ends, and another
curve has to be put in its place; he was, he says, the first to find it, and gave it in the *Commentarii* of
the Petersburg academy. (The number of the volume is missing in our copy.) And that curve too, like the
cycloid, demands a simple pendulum; for a compound one it is of no use.

He writes no formula and no number. With $z$ for the arc from the lowest point, $\omega$ for $\sqrt{g/a}$ with
today's $g$, and a bob that starts at rest from the arc $A$, the first case is
$\ddot z + 2\gamma\omega\dot z + \omega^2z = 0$, and every swing takes

$$ T = \frac{\pi}{\omega\sqrt{1 - \gamma^2}}, \tag{A} $$

longer than without resistance, but equally for all. In the second case the resistance is $\beta\dot z^2$, and
on the cycloid

$$ \frac{T}{T_0} - 1 = \frac{(\beta A)^2}{6} + \dots \tag{B} $$

It is of the *second* order. To the first, the descent takes longer by the part $\frac{2}{3\pi}\beta A$ and
the ascent that follows is shorter by as much: the two halves of a swing compensate one another. The curve
that makes all descents equal has the slope and the height

$$ \frac{dx}{dz} = \frac{e^{\beta z} - 1}{\beta a}, \qquad x = \frac{e^{\beta z} - 1 - \beta z}{\beta\beta a},
   \tag{C} $$

for with $w = (1 - e^{-\beta z})/\beta$ the equation of the descent on it becomes $\ddot w = -\omega^2 w$.

::: margin
Drag: $\tfrac12 c\rho\,\pi R^2 v^2$. For a ball $n$ times as heavy as the air $\beta = \frac{3c}{8nR}$. That
$c$ does not change with the velocity is an assumption.
:::

Is Euler's comparison right? Let the bob be a ball of the radius $R$. The smaller it is, the less its
extension counts ($kk = \tfrac25RR$, {{eq tautochrone.03 A}}), but the more the air. For narrow swings of any
width both are equally bad if

$$ R = a\sqrt[4]{\tfrac{15}{64}}\,\sqrt{\frac cn}. \tag{D} $$

## The program

Let $y$ be the distance that, without resistance, would have the same energy: $yy = 2\int z\,e^{2\beta z}dz$.
In it the swing is a plain one, and its time is the average of $e^{\beta z}dz/dy$ over
$y = y_0\sin\alpha$. With $\beta z = yM(y)$ and $q = e^{2\beta z}$ the coefficients of $M$ and $q$ follow one
from another out of $Mq' = 2$ and $q' = 2q\,(yM)'$; $\beta$ is made 1.
*/

struct Powers  ///< of y, for β = 1
{
  std::vector<Fifty> arc;  ///< in z: of y, yy, ...
  std::vector<Fifty> e;    ///< in e^z: of 1, y, yy, ...
};

Powers powers(std::size_t order)
{
  std::vector<Fifty> M{1}, q{1, 2}, p{1, 1};
  for(std::size_t n{1}; n < order; ++n)
  {
    Fifty known = 2 * M[0] * q[n], next = M[0] * p[n];
    for(std::size_t i{1}; i < n; ++i)
      known += 2 * Fifty(i + 1) * M[i] * q[n - i] + M[i] * Fifty(n - i + 1) * q[n - i + 1];
    M.push_back(-known / Fifty(2 * (n + 2)));
    for(std::size_t i{1}; i <= n; ++i)
      next += Fifty(i + 1) * M[i] * p[n - i];
    p.push_back(next / Fifty(n + 1));
    q.push_back(0);
    for(std::size_t i{0}; i <= n; ++i)
      q[n + 1] += 2 * Fifty(i + 1) * M[i] * q[n - i] / Fifty(n + 1);
  }
  return {M, p};
}

/*!
Of $dp/dy$, $p = e^{\beta z}$, the descent has the negative $y$ and the ascent the positive; of the whole
swing only even powers are left. The averages of the powers of a sine are $\frac12$,
$\frac{1\cdot3}{2\cdot4}$, ... and $\frac2\pi$, $\frac2\pi\cdot\frac23$, ...
*/

struct Swing  ///< with a resistance as the square; all for one swing from the right to the left
{
  double whole = 0;    ///< T/T₀ − 1
  double descent = 0;  ///< the same of the descent, against ½T₀
  double ascent = 0;   ///< and of the ascent
  double lost = 0;     ///< the part of the arc that is missing on the other side
};

Swing resisted(double b)  // (B) and all the terms that follow; b = βA ≤ 1
{
  static const Powers of = powers(170);
  double yy = 0, term = 2;  // yy/bb, by the series of its exponential
  for(int n = 0; n < 40; ++n, term *= -2 * b / n)
    yy += term / (n + 2);
  const double y0 = b * std::sqrt(yy);
  Swing swing;
  double even = 1, odd = 2 / std::numbers::pi, power = y0;
  for(std::size_t n{1}; n < 168; ++n, power *= y0)
  {
    double& mean = n % 2 == 0 ? even : odd;
    mean *= n == 1 ? 1 : double(n - 1) / double(n);
    const double gained = mean * power * double(Fifty(n + 1) * of.e[n + 1]);
    swing.whole += n % 2 == 0 ? gained : 0;
    swing.descent += n % 2 == 0 ? gained : -gained;
    swing.ascent += gained;
    swing.lost -= n % 2 == 0 ? 0 : 2 * power * double(of.arc[n]) * std::sqrt(yy);
  }
  return swing;
}

/*!
What the section asks for, and the small formulae:
*/

const auto a = real("a", 0.994, metres, scale, "length of the pendulum, down to the centre of the ball");
const auto R = real("R", 0.05, metres, scale, "radius of the ball");
const auto n = real("n", 9000, none, scale, "how many times heavier than the medium the ball is");
const auto c = real("c", 0.44, none, scale, "coefficient of drag, 0.44 for a ball that is not too slow");
const auto phi0 = angle("phi0", 5_deg, closed(1e-9_deg, 89_deg), "angle from which the swing begins");
const auto gamma_ = real("gamma", 0.001, none, closed(0.0, 0.999), "γ, of a resistance as the velocity");

double per_length()  // β
{
  return 0.375 * (c / n) / R;
}

double as_velocity()  // (A), T/T₀ − 1
{
  const double root = std::sqrt((1 - gamma_) * (1 + gamma_));
  return gamma_ * gamma_ / (root * (1 + root));
}

double higher(double b)  // (C): 2(eᵇ − 1 − b)/bb − 1
{
  double sum = 0, term = 2 * b / 6;
  for(int i = 4; i < 40; term *= b / i, ++i)
    sum += term;
  return sum;
}

double equally_bad()  // (D)
{
  return a * std::sqrt(std::sqrt(15.0 / 64)) * (std::sqrt(c) / std::sqrt(n));
}

double extended(double ratio, double phi)  // the excess of a ball, R = ratio a
{
  return excess(Cheeks::cycloids, ratio * std::sqrt(0.4), phi);
}

TELL
{
  const double b = per_length() * a * std::sin(phi0);
  require(b <= 1, "n", "such that βA is from 1e-90 to 1");
  require(b >= 1e-90, "n", "such that βA is from 1e-90 to 1");
  require(R / a >= 1e-90, "R", "from 1e-90 a to 1e9 a");
  require(R / a <= 1e9, "R", "from 1e-90 a to 1e9 a");
  const Swing swing = resisted(b);
  const double body = extended(R / a, phi0);
  tell("b", b, "βA, the measure of the resistance");
  tell("late_air", 86'400 * swing.whole, seconds, "by the resistance of the air, in a day");
  tell("late_body", 86'400 * body, seconds, "by the extension of the ball, in a day");
  tell("greater", body / swing.whole, "how many times this is greater");
  tell("equal", equally_bad(), metres, "radius of a ball for which both were the same, (D)");
  tell("descent", 86'400 * swing.descent, seconds, "a day made of descents would be late by");
  tell("ascent", 86'400 * swing.ascent, seconds, "a day made of ascents, by");
  tell("lost", swing.lost, percent, "of the arc, in one swing");
  tell("higher", higher(b), percent, "how much higher Euler's curve is than the cycloid at the arc A, (C)");
  tell("velocity", as_velocity(), "T/T₀ − 1 if the resistance is as the velocity, (A)");
}

TELL
{
  curve("balls", {"R", "air", "body"}, [](Curve& out) {
    for(double radius = 0.001; radius < 0.21; radius *= 1.2)
    {
      const double b = 0.375 * 0.44 / 9000 / radius * std::sin(5_deg);
      out.put({radius, 86'400 * resisted(b).whole, 86'400 * extended(radius, 5_deg)});
    }
  });
}

/*!
For a ball of the radius 5 cm, 9000 times as heavy as air (nearly lead), on a pendulum of a second, the
extension costs {{late_body|3}} s in a day at 5° and the air {{late_air|e2}} s: Euler's "much greater" is
{{greater|2}} times. With one reserve. Descents alone would be late by {{descent|3}} s in a day, more than by
the extension; the air does so little because the ascents are early by nearly as much. And all the while it
takes {{lost|2}} of the arc at every swing, which the clock has to give back.

::: figure tautochrone-04
alt: Seconds a day late against the radius of the ball, both logarithmic. A falling straight line for the
air and a rising one for the extension cross at about five thousandths of a. At a twentieth of a they are four
powers of ten apart.

What the two causes cost a ball that hangs between Huygens's cheeks and swings 5°. Bobs of clocks lie far to
the right of the crossing.
:::

## Checks

The judge follows the equation of motion in fifty digits, $\ddot\eta = -\eta - b\,\dot\eta^2$ from rest in
$\eta = -1$, to the place of the told time, and corrects that by the velocity found there.
*/

exact::State moved(const Fifty& b, const Fifty& t)  // η and dη/dt
{
  const auto motion = [&](const Fifty&, const exact::State& at) -> exact::State {
    return {at[1], -at[0] - b * at[1] * at[1]};
  };
  return exact::solve(motion, 0, {-1, 0}, t, Fifty("1e-34")).y;
}

Fifty until_rest(const Fifty& b, const Fifty& guess)  // T ω
{
  Fifty t = guess;
  for(int i = 0; i < 5; ++i)
  {
    const exact::State at = moved(b, t);
    t += at[1] / (at[0] + b * at[1] * at[1]);
  }
  return t;
}

Fifty until_bottom(const Fifty& b, const Fifty& guess)
{
  Fifty t = guess;
  for(int i = 0; i < 5; ++i)
  {
    const exact::State at = moved(b, t);
    t -= at[0] / at[1];
  }
  return t;
}

Fifty b_exactly()
{
  return Fifty("0.375") * c.fifty() / (n.fifty() * R.fifty()) * a.fifty() * sin(phi0.fifty());
}

CHECK_THAT("what the air costs, in a swing, in a descent, in an ascent, and of the arc, is the motion's")
{
  for(const Told& now : told_at("", "n=1 R=0.2 phi0=30", "n=20 a=3 R=0.1 phi0=60", "n=1 R=0.4 c=1 phi0=80"))
  {
    const Fifty b = b_exactly(), half = exact::pi() / 2;
    const Fifty T = until_rest(b, 2 * half * (1 + b * b / 6)), down = until_bottom(b, half * (1 + b / 5));
    const char* const why = "a dozen roundings";
    CHECK(now.value("b") == within_relative(b, 2e-15, why));
    CHECK(now.value("late_air", seconds) == within_relative(86'400 * (T / (2 * half) - 1), 2e-14, why));
    CHECK(now.value("descent", seconds) == within_relative(86'400 * (down / half - 1), 2e-14, why));
    CHECK(now.value("ascent", seconds) == within_relative(86'400 * ((T - down) / half - 1), 2e-14, why));
    CHECK(now.value("lost", percent) == within_relative(1 - moved(b, T)[0], 2e-14, why));
  }
}

CHECK_THAT("a small resistance counts by its square, the halves of a swing by the first power")
{
  for(const Told& now : told_at("n=1e30", "n=1e80 phi0=1e-3", "R=1e30 a=1e30 n=1e5"))
  {
    const Fifty b = b_exactly();
    const double next = 2e-14 + 2 * double(b);
    CHECK(now.value("late_air", seconds) == within_relative(86'400 * b * b / 6, next, "(B)"));
    CHECK(now.value("descent", seconds) == within_relative(57'600 * b / exact::pi(), next, "2b/3π"));
    CHECK(now.value("ascent", seconds) == within_relative(-57'600 * b / exact::pi(), next, "−2b/3π"));
    CHECK(now.value("lost", percent) == within_relative(4 * b / 3, next, "the first order"));
  }
}

/*!
The other cause is judged by the integral of {{sec tautochrone.19}} in fifty digits, Euler's curve by the
motion on it.
*/

Fifty body_by_times(const Fifty& ratio, const Fifty& phi)  // the excess of a ball, R = ratio a
{
  const Fifty k = ratio * sqrt(Fifty("0.4"));
  return excess(truncated(0, k), k, phi);
}

CHECK_THAT(
    "what the extension costs is the integral's, and so many times greater; it exceeds the descents'")
{
  for(const Told& now : told_at("", "R=0.3 phi0=40 a=2", "R=0.001 phi0=1 n=100"))
  {
    const Fifty over = body_by_times(R.fifty() / a.fifty(), phi0.fifty()), b = b_exactly();
    const Fifty air = until_rest(b, exact::pi() * (1 + b * b / 6)) / exact::pi() - 1;
    CHECK(now.value("late_body", seconds) == within_relative(86'400 * over, 1e-13, "the library's bound"));
    CHECK(now.value("greater") == within_relative(over / air, 1.5e-13, "the library's bound"));
  }
  for(const Told& now : told_at(""))
  {
    CHECK(now.value("greater") == between(10'000, 20'000, "four powers of ten"));
    CHECK(now.value("descent", seconds) == between(0.5, 0.6, "more than by the extension"));
  }
}

CHECK_THAT("a ball as small as (D) is equally bad by both causes, if it swings narrowly")
{
  for(const Told& now : told_at("", "a=20 n=8000 c=1", "n=1e9 a=1e-3"))
  {
    const Fifty radius = a.fifty();
    const Fifty aa = radius * radius, slow = Fifty("0.375") * c.fifty() / n.fifty();
    Fifty low = 0, high = radius;
    for(int i = 0; i < 170; ++i)
    {
      const Fifty middle = (low + high) / 2, both = middle * middle;
      (both / aa / 10 > slow * slow / both * aa / 6 ? high : low) = middle;
    }
    CHECK(now.value("equal", metres) == within_relative(low, 2e-15, "three roots"));
  }
  for(const Told& now : told_at("R=0.00483581067 phi0=0.1"))
    CHECK(now.value("greater") == within(1, 1e-4, "kk against aa + kk, and the angle"));
}

CHECK_THAT(
    "on Euler's curve descents from any arc take a quarter of a plain swing, and it is so much higher")
{
  for(const char* const from : {"0.1", "0.7", "2"})
  {
    const auto motion = [](const Fifty&, const exact::State& at) -> exact::State {
      return {at[1], -expm1(at[0]) + at[1] * at[1]};  // β = 1, towards smaller z
    };
    const exact::State end = exact::solve(motion, 0, {Fifty(from), 0}, exact::pi() / 2).y;
    CHECK(end[0] == within(0, 1e-27, "it is in the lowest place"));
  }
  for(const Told& now : told_at("", "n=1 R=0.2 phi0=30", "n=1e40"))
  {
    const Fifty b = b_exactly();
    const Fifty more = b < Fifty("1e-12") ? b / 3 + b * b / 12 : 2 * (expm1(b) - b) / (b * b) - 1;
    CHECK(now.value("higher", percent) == within_relative(more, 3e-15, "a dozen roundings"));
  }
}

CHECK_THAT("a resistance as the velocity makes all swings longer by the same part")
{
  for(const Told& now : told_at("", "gamma=0.9 phi0=60", "gamma=0.3", "gamma=1e-80"))
  {
    const Fifty y = gamma_.fifty(), T = exact::pi() / sqrt((1 - y) * (1 + y));
    CHECK(
        now.value("velocity")
        == within_relative(y < Fifty("1e-20") ? y * y / 2 : T / exact::pi() - 1, 2e-15, "five roundings"));
    const auto motion = [&](const Fifty&, const exact::State& at) -> exact::State {
      return {at[1], -at[0] - 2 * y * at[1]};
    };
    const exact::State end = exact::solve(motion, 0, {-1, 0}, T).y;
    CHECK(end[1] == within(0, 1e-28, "at rest"));
  }
}

CHECK_THAT("the figure's curves are the motion's and the integral's; they cross at five thousandths")
{
  for(const Told& now : told_at(""))
  {
    for(const auto& point : now.points("balls", 5))
    {
      const Fifty radius = point.at("R"), five = exact::pi() / 36;
      const Fifty b = Fifty("0.375") * Fifty("0.44") / (9000 * radius) * sin(five);
      const Fifty air = until_rest(b, exact::pi() * (1 + b * b / 6)) / exact::pi() - 1;
      CHECK(point.value("air") == within_relative(86'400 * air, 3e-14, "a dozen roundings"));
      CHECK(point.value("body")
            == within_relative(86'400 * body_by_times(radius, five), 1e-13, "the library's bound"));
    }
    for(const auto& point : now.points("balls"))
      CHECK((point.at("air") > point.at("body")) == (point.at("R") < 0.00487));
  }
}

CHECK_THAT("on Euler's curve the whole swing one way takes π/ω, back it does not")
{
  const auto one_way = [](const Fifty&, const exact::State& at) -> exact::State {
    return {at[1], -expm1(at[0]) + at[1] * at[1]};
  };
  const auto back = [](const Fifty&, const exact::State& at) -> exact::State {
    return {at[1], -expm1(at[0]) - at[1] * at[1]};
  };
  const exact::State there = exact::solve(one_way, 0, {Fifty("0.7"), 0}, exact::pi()).y;
  CHECK(there[1] == within(0, 1e-27, "at rest again"));
  const exact::State again = exact::solve(back, 0, there, exact::pi()).y;
  CHECK(abs(again[1]) > Fifty("0.01"));
}

CHECK_THAT("a resistance with βA beyond 1 or below 10⁻⁹⁰ is refused, and a ball beyond 10⁹ a or below "
           "10⁻⁹⁰ a; within these limits neither is")
{
  for(const char* const within_them :
      {"a=1 R=1 c=1 phi0=30 n=0.18750000000001", "a=4 R=0.5 c=2 phi0=30 n=3.0000000000001",
       "a=1 R=1 c=1 phi0=30 n=1.8749999999999e89", "a=1 R=1e-90 n=1e90", "a=2 R=2e-90 n=1e90", "a=1 R=1e9",
       "a=2 R=2e9"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"a=1 R=1 c=1 phi0=30 n=0.18749999999999", "a=4 R=0.5 c=2 phi0=30 n=2.9999999999999",
       "a=1 R=1 c=1 phi0=30 n=1.8750000000001e89", "a=1 R=9.999999999999997e-91 n=1e90",
       "a=2 R=1.9999999999999994e-90 n=1e90", "a=1 R=1000000000.0000002", "a=2 R=2000000000.0000004"})
    CHECK(refused_at(beyond));
}

/*!
## Notes

The compensation ends where ascents and descents go on different curves, or where the clock's wheels push in
one half of the swing more than in the other. That the two halves of a swing on the curve {{eq C}}, continued
with the same formula beyond the lowest point, together take $\pi/\omega$ is true as well; but only one way:
back on the same curve they do not.

## Go on from here

::: exercise
In water lead is but 11 times as heavy as what it swings in. Which of the two causes is greater then, for the
ball of 5 cm at 5°?

answer: The water: `--n 11.3` makes it late by about 9 s a day, the extension stays at {{late_body|3}} s.
:::
*/

CHECK_THAT("in water the ball is late by about nine seconds a day")
{
  CHECK(86'400 * resisted(0.375 * 0.44 / 11.3 / 0.05 * 0.994 * std::sin(5_deg)).whole
        == between(8.5, 9.5, "the exercise"));
}
