#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/plate.hpp"
#include "pendulum/scene.hpp"
#include "pendulum/scene_judge.hpp"
#include "pendulum/series.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 2, "The figure, and the time that is sought")

using pendulum::ratio_by_mean, pendulum::Point, pendulum::at, pendulum::line, pendulum::arc;

/*!
## What Euler does

The time sought is that from the greatest excursion down to the vertical; twice this is the time of one
oscillation. In the figure the point $A$ is a horizontal axis about which a pendulum $AG$ of any kind swings.
The plane of the figure is vertical and perpendicular to the axis, so that the pendulum swings in this plane.
The vertical line $AB$ shows its natural position, in which it can stay at rest; that is so when the centre of
gravity of the whole pendulum lies in $AB$.

The angle $BAG = \zeta$ is the greatest excursion, which the pendulum makes from $AB$ to both sides by turns.
What has to be determined is the time in which it comes from the oblique position $AG$ to the vertical $AB$.
In the letters of {{sec pendulum.09}}, where this time is $t$ and that of one oscillation $T$,

$$ T = 2t . \tag{1} $$

::: margin
An *oscillation* is one swing, from one side to the other. Today's period, there and back, is $2T = 4t$.
:::

Clearly the line $AG$, from which the excursion is counted, must be drawn from the axis through the centre of
gravity of the whole pendulum.

## The program

To test {{eq 1}} the times of all the elements of the motion are added, from one side to the other. In the
unit $\sqrt b/\sqrt{2g}$ the element of time is $d\Phi/\sqrt{2(\cos\Phi-\cos\zeta)}$, where $\Phi$ is the
present angle with the vertical ({{sec pendulum.07}}). It is infinite at the turning points. So the swing is
divided evenly not in $\Phi$ but in an angle $\varphi$ with $\Phi = \zeta\cos\varphi$, which grows from 0 on
one side through 90° at the lowest point to 180° on the other. The element of time becomes

$$ \frac{d\varphi}{\sqrt{S(\zeta\cos^2\tfrac12\varphi)\;S(\zeta\sin^2\tfrac12\varphi)}},
   \qquad S(x) = \frac{\sin x}x . \tag{A} $$

It is finite everywhere, nothing cancels in it however small the swing, and it is the same at $\varphi$ and at
$180°-\varphi$, where the two factors change places: that is {{eq 1}}. The sum takes each of $n$ equal parts
of $\varphi$ at its middle. For a periodic function, as this one is, so simple a rule is an excellent one: the
number of correct digits grows in proportion to $n$.
*/

double time_between(double from, double to, double zeta, int n)  // φ from `from` to `to`
{
  const auto S = [](double x) { return x > 0 ? std::sin(x) / x : 1; };
  const double part = (to - from) / n;
  double sum = 0;
  for(int i = 0; i < n; ++i)
  {
    const double half = (from + (i + 0.5) * part) / 2, c = std::cos(half), s = std::sin(half);
    sum += part / std::sqrt(S(zeta * c * c) * S(zeta * s * s));  // (A)
  }
  return sum;
}

const auto swing_ = amplitude(40_deg, from_below(0_deg, 180_deg));
const auto b = real("b", 1.0, metres, scale, "length of the simple pendulum that swings alike");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second");
const auto n = integer("n", 2, 1, 100'000, "parts into which each half of the swing is cut");

double error_of(double time, double exact)
{
  return (time - exact) / exact;
}

TELL
{
  const double unit = std::sqrt(b) / std::sqrt(2 * g);
  const double down = time_between(0_deg, 90_deg, swing_.zeta, n);
  const double exact = swing::quarter_time({swing_.zeta, swing_.eta});
  tell("t", unit * down, seconds, "from AG down to AB");
  tell("T", unit * time_between(0_deg, 180_deg, swing_.zeta, 2 * n), seconds, "one oscillation");
  tell("error", error_of(down, exact), "the relative error of t, from so few parts", 3);
}

TELL
{
  curve("fig_1", {"x", "y"}, [](Curve& c) {
    const Point A{0, 0}, G = at(1, swing_.zeta);
    line(c, A, at(1, 0));             // AB
    line(c, A, G);                    // AG
    line(c, A, at(1, -swing_.zeta));  // the other side
    line(c, G, {G.x, G.y - 0.22});    // GH
    arc(c, 1, -swing_.zeta, swing_.zeta);
    arc(c, 0.28, 0, swing_.zeta);
  });
}

TELL
{
  pendulum::scene_of_swing("swing", {swing_.zeta, swing_.eta}, std::sqrt(b) / std::sqrt(2 * g));
}

/*!
With each half of the swing cut into {{n}} parts the relative error of $t$ is {{error|e1}}.

::: figure pendulum-02
alt: A point A at the top. From it a vertical line down to B, an oblique line down to the right to G, and a
dashed line as far to the left. An arc leads from the dashed line's end through B to G. The angle between AB
and AG is marked ζ. From G a short arrow leads straight down to H.

The first figure of Euler's plate, drawn after the text. $A$ is the axis seen end on, $AB$ the position of
rest, $G$ the centre of gravity at the greatest excursion ζ, and $GH$ the vertical in which gravity acts
({{sec pendulum.03}}). The time from $G$ to $B$ is $t$; that from $G$ to the end of the dashed line is $T$.
:::

::: scene swing
alt: A pendulum hangs from its axis, drawn aside by the amplitude; a grey arc marks the way of its bob.

The same pendulum moving, in its true time: from $G$ through $B$ to the other side, and back.
:::

## Speed against error

The same sum over equal parts of $\Phi$ itself shows why it is not done that way.
*/

double in_equal_angles(double zeta, int parts)
{
  double sum = 0;
  for(int i = 0; i < parts; ++i)
    sum += zeta / parts / std::sqrt(2 * (std::cos(zeta * (i + 0.5) / parts) - std::cos(zeta)));
  return sum;
}

TELL
{
  const double zeta = swing_.zeta, eta = swing_.eta;
  if(!(zeta > 1e-7))
    return;  // the difference of the cosines is nothing but its rounding
  std::vector<Method> ways;
  for(const int parts : {4, 16, 64, 256})
    ways.push_back(
        {std::to_string(parts) + " equal parts of Φ", [=] { return in_equal_angles(zeta, parts); }, "Φ"});
  for(const int parts : {2, 4, 8})
    ways.push_back({std::to_string(parts) + " equal parts of φ",
                    [=] { return time_between(0_deg, 90_deg, zeta, parts); }, "φ"});
  ways.push_back({"this edition", [=] { return swing::quarter_time({zeta, eta}); }});
  race("descent", "t√(2g)/√b", exact::pi() / 2 * ratio_by_mean(swing_.eta.fifty()), ways);
}

/*!
## Checks

The judge integrates over the whole swing in $\Phi$, from $-\zeta$ to $\zeta$, in fifty digits and with both
infinite ends.
*/

CHECK_THAT("the time from side to side is twice the time from AG to AB")
{
  for(const double zeta : {1e-8, 20_deg, 40_deg, 90_deg, 150_deg})
  {
    const auto element = [&](const Fifty&, const Fifty& to_end) {
      const Fifty e = abs(to_end);  // ζ − Φ on the one side, ζ + Φ on the other
      return 1 / sqrt(4 * sin(e / 2) * sin(Fifty(zeta) - e / 2));
    };
    const Fifty T = exact::integrate_from_ends(element, -Fifty(zeta), Fifty(zeta)).value;
    CHECK(2 * time_between(0_deg, 90_deg, zeta, 16)  // (1)
          == within_ulps(T, 4, "sixteen equal weights: the roundings of the elements average out"));
    CHECK(time_between(90_deg, 180_deg, zeta, 16) == within_ulps(T / 2, 4, "the same in reverse"));
    const Fifty by_mean = exact::pi() * ratio_by_mean(exact::pi() - Fifty(zeta));
    CHECK(T == within(by_mean, 1e-38, "the quadrature's forty digits"));
  }
}

CHECK_THAT("the scene shows the motion itself, in its true time")
{
  for(const Told& now : told_at("", "zeta=150 b=2", "zeta=1e-6"))
  {
    const Fifty unit = sqrt(Fifty(b)) / sqrt(2 * Fifty(g));
    const pendulum::Scene_judge judge(swing_.zeta.fifty(), swing_.eta.fifty(), unit);
    for(const auto& frame : now.points("swing", 9))
    {
      const Fifty phi = judge.angle(frame.at("t"));
      CHECK(frame.value("t") == between(0, judge.last(), "one period"));
      CHECK(frame.value("phi") == within(phi, judge.slack(), judge.because));
      CHECK(frame.value("x") == within(sin(phi), judge.slack(), judge.because));
      CHECK(frame.value("y") == within(-cos(phi), judge.slack(), judge.because));
    }
  }
}

CHECK_THAT("twice as many parts of φ give twice as many digits; in Φ the error only falls like 1/√n")
{
  const auto error = [](double time) {
    return std::abs(time / swing::quarter_time({150_deg, 30_deg}) - 1);
  };
  const auto digits = [&](int n) { return -std::log10(error(time_between(0_deg, 90_deg, 150_deg, n))); };
  CHECK(digits(4) / digits(2) == within(2, 0.05, "the error falls in geometric progression"));
  CHECK(digits(8) / digits(4) == within(2, 0.05, "the same, down to 10⁻¹³"));
  CHECK(error(in_equal_angles(150_deg, 400)) / error(in_equal_angles(150_deg, 100))
        == within(0.5, 0.001, "the next order is smaller by 1/n"));
}

/*!
What is told: the sum of two parts once more in fifty digits, and the time itself.
*/

Fifty of_parts(const Fifty& zeta, int parts)  // (A) at the middles of equal parts of φ, to 90°
{
  const auto S = [](const Fifty& x) { return x == Fifty(0) ? Fifty(1) : sin(x) / x; };
  Fifty sum = 0;
  for(int i = 0; i < parts; ++i)
  {
    const Fifty phi = (Fifty(i) + Fifty(0.5)) * exact::pi() / (2 * parts);
    sum += 1 / sqrt(S(zeta * (1 + cos(phi)) / 2) * S(zeta * (1 - cos(phi)) / 2));
  }
  return sum * exact::pi() / (2 * parts);
}

CHECK_THAT(
    "the times told are the sum over equal parts, twice that for both halves, and the error is its error")
{
  for(const Told& now : told_at("", "zeta=150 n=5 b=2", "zeta=1e-100 n=1 g=1e90", "zeta=90 n=20"))
  {
    const Fifty zeta = swing_.zeta.fifty(), unit = sqrt(b.fifty() / (2 * g.fifty())),
                sum = of_parts(zeta, n);
    const Fifty truth = exact::pi() / 2 * swing::oracle::ratio_from_bottom(zeta);
    CHECK(now.value("t", seconds) == within_relative(unit * sum, 1.5e-15, "a few roundings a part"));
    CHECK(now.value("T", seconds) == within_relative(2 * unit * sum, 1.5e-15, "a few roundings a part"));
    CHECK(now.value("error") == within(sum / truth - 1, 1e-15, "a difference of rounded numbers"));
  }
}

CHECK_THAT("every way of the race is the sum that it says it is")
{
  for(const Told& now : told_at("", "zeta=150", "zeta=1"))
  {
    const Fifty zeta = swing_.zeta.fifty(),
                truth = exact::pi() / 2 * swing::oracle::ratio_from_bottom(zeta);
    CHECK(now.exact("descent") == within_relative(truth, 1e-40, "two ways of fifty digits"));
    for(const int parts : {4, 16, 64, 256})
    {
      Fifty sum = 0;
      for(int i = 0; i < parts; ++i)
      {
        const Fifty Phi = zeta * (Fifty(i) + Fifty(0.5)) / parts;
        sum += zeta / parts / (2 * sqrt(sin((zeta + Phi) / 2) * sin((zeta - Phi) / 2)));
      }
      const double lost = 1e-15 + 2e-14 / swing_.zeta / swing_.zeta;
      CHECK(now.method("descent", std::to_string(parts) + " equal parts of Φ")
            == within_relative(sum, lost, "the difference of the cosines near the end"));
    }
    for(const int parts : {2, 4, 8})
      CHECK(now.method("descent", std::to_string(parts) + " equal parts of φ")
            == within_relative(of_parts(zeta, parts), 1e-15, "few roundings a part"));
    CHECK(now.method("descent", "this edition")
          == within_ulps(truth, 1, "ζ rounds, and the library's bound"));
  }
}

CHECK_THAT("the plate has B below A, G at the distance 1 and at the angle ζ, and arcs about A")
{
  for(const Told& now : told_at("", "zeta=150"))
  {
    const auto points = now.points("fig_1");
    const auto is_at = [&](std::size_t i, const Fifty& x, const Fifty& y) {
      CHECK(points.at(i).value("x") == within(x, 3e-16, "a rounded sine"));
      CHECK(points.at(i).value("y") == within(y, 3e-16, "a rounded cosine"));
    };
    const Fifty s = sin(swing_.zeta.fifty()), c = cos(swing_.zeta.fifty());
    is_at(0, 0, 0);
    is_at(1, 0, -1);
    is_at(3, s, -c);
    is_at(5, -s, -c);
    is_at(7, s, -c - Fifty("0.22"));
    is_at(8, -s, -c);
    is_at(108, s, -c);
    is_at(points.size() - 1, Fifty("0.28") * s, -Fifty("0.28") * c);
  }
}

/*!
## Go on from here

::: exercise
Cut each half of a swing to 170° into five parts and see the error. What should it be with ten?

answer: Twice as many digits: five parts leave $3\cdot10^{-5}$, and the square of that is $10^{-9}$,
nearly. It is $-1.35\cdot10^{-9}$.
:::
*/

CHECK_THAT("near the top, too, twice as many parts give twice as many digits")
{
  for(const Told& now : told_at("zeta=170 n=5"))
    CHECK(now.value("error") == within(-2.84e-5, 0.005e-5, "as the answer has it"));
  for(const Told& now : told_at("zeta=170 n=10"))
    CHECK(now.value("error") == within(-1.35e-9, 0.005e-9, "as the answer has it"));
}
