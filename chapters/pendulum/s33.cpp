#include "edition/section.hpp"
#include "pendulum/scene.hpp"
#include "pendulum/scene_judge.hpp"
#include "pendulum/steps.hpp"
#include "pendulum/three_members.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 33, "First example: four and a half seconds, or not quite three")

using namespace pendulum;

/*!
## What Euler does

Euler adds up the members and finds that a swing through 350° takes four and a half times as long as a very
small one. The three, 3,82675 from {{sec pendulum.31}} with 0,69249 and 0,00099 from {{sec pendulum.32}}, make

$$ T = 4{,}52023{{entry the_swing}}\,\Theta. \tag{1} $$

So if the pendulum beats seconds in its smallest swings, it needs about $4\tfrac12$ seconds for each swing
through an arc of 350°. With arcs still greater, still nearer to the full circle, the times grow enormously,
until for all the 360° the time is infinite. He will therefore work out one more example, with an arc that
falls short of the circle by two degrees only.

He has added rightly, and yet the time is wrong. The members make half a swing, counted in units of $\sqrt
b/\sqrt{2g}$, and Θ is π of these units; with the factor that was forgotten in {{sec pendulum.29}},

$$ T = \frac2\pi\cdot 4{,}52023\,\Theta = {{his_mended|6}}\,\Theta, \tag{A} $$

and the seconds pendulum takes less than three seconds. (The last digit is a unit too large, as is that of the
sum.)

## The program

Two ways do not know the three members. The first is Euler's own series of {{sec pendulum.09}}, which
gives $T/\Theta$ for any arc, here too, with 20000 terms. The second is the motion
itself. Let the pendulum go, at rest, η below the top, and follow $\psi'' = \sin\psi$ step by step for half
the time that somebody claims for the swing: it must then hang straight down.
*/

double after(double time, double eta)  // the angle past the lowest point, in radians; time in units √b/√2g
{
  const Place start{eta, 0};
  return runge_kutta(start, time, 4000, [](double psi) { return std::sin(psi); }).phi - std::numbers::pi;
}

double after_half_of(double T_over_Theta, double eta)
{
  return after(std::numbers::pi * T_over_Theta / 2, eta);
}

/*!
The angle and the pendulum may be the reader's.
*/

const auto swing_ = amplitude_from_top(5_deg, closed(90_deg, 179.99_deg));
const auto Theta = real("Theta", 1.0, seconds, scale, "time of one infinitely small swing");

TELL
{
  const double eta = swing_.eta;
  const double sum = three_members(eta / 2, 40).sum();  // (1)
  const Fifty exact = ratio_by_mean(swing_.eta.fifty());
  tell("sum", sum, "the three members, added");
  tell("mended", 2 / std::numbers::pi * sum, "T/Θ by the members");                 // (A)
  tell("his_mended", 2 / std::numbers::pi * 4.52023, "T/Θ for 5° by Euler's sum");  // (A)
  tell("T", Theta * double(exact), seconds, "T by the arithmetic-geometric mean");
  tell("T_over_Theta", exact, "T/Θ to thirty digits");
  tell("half_way", after_half_of(sum, eta), degrees, "where the pendulum is at half of Euler's time", 9);
}

TELL
{
  const double rule = three_members(swing_.eta / 2, 40).sum();
  curve("swing", {"seconds", "angle"}, [=](Curve& c) {
    for(int i = 0; i <= 300; ++i)
      c.put({Theta * rule * i / 300, after(std::numbers::pi * rule * i / 300, swing_.eta) / 1_deg});
  });
  curve("ends", {"exact", "euler", "turn"}, [=](Curve& c) {
    c.put({Theta * swing::ratio({swing_.zeta, swing_.eta}), Theta * rule, swing_.zeta / 1_deg});
  });
}

TELL
{
  pendulum::scene_of_swing("moving", {swing_.zeta, swing_.eta}, Theta / std::numbers::pi);
}

/*!
A pendulum that beats seconds takes {{T|6}} s through 350°. At half of Euler's time, where it should hang
straight down, it is {{half_way|deg0}} up on the other side.

::: figure pendulum-33
alt: The angle of the pendulum against time, from rest at minus 175 degrees. It lingers at first, falls
through the lowest point, rises and comes to rest at plus 175 degrees after {{T|3}} seconds, where the
swing is over. When Euler's time of 4,52 seconds ends it has come down again and is past the lowest point.

A seconds pendulum, let go 5° from the top. Its swing is over after {{T|f2}} s; when Euler's time ends, it has
come down again and passed the lowest point.
:::

::: scene moving
alt: A pendulum hangs from its axis, drawn aside by the amplitude; a grey arc marks the way of its bob.

The same pendulum in its true time, to be held against Euler’s four and a half seconds from side to side.
:::

## Speed against error

The members, the series and the mean, each as it would be taken today for the number alone.
*/

TELL
{
  const double eta = swing_.eta;
  race("ratio", "T/Θ", ratio_by_mean(swing_.eta.fifty()),
       {{"three members", [=] { return 2 / std::numbers::pi * three_members(eta / 2, 4).sum(); }},
        {"series of §9, 20000 terms", [=] { return series(std::pow(std::cos(eta / 2), 2), 20'000); }},
        {"arithmetic-geometric mean", [=] { return ratio_by_mean(eta); }},
        {"this edition", [=] { return swing::ratio_from_top(eta); }}});
}

/*!
## Checks
*/

CHECK_THAT(
    "it hangs straight down after the time (1), if this is taken for half a swing in units of √b/√2g")
{
  CHECK(after(3.82675 + 0.69249 + 0.00099, 5_deg)
        == within(0, 3.5e-5, "three half units of the fifth decimal and what is left out, at the speed 2"));
}

CHECK_THAT("the scene shows the motion itself, in its true time")
{
  for(const Told& now : told_at("", "zeta=120 Theta=2", "eta=0.01"))
  {
    const Fifty unit = Fifty(Theta) / exact::pi();
    const pendulum::Scene_judge judge(swing_.zeta.fifty(), swing_.eta.fifty(), unit);
    for(const auto& frame : now.points("moving", 9))
    {
      const Fifty phi = judge.angle(frame.at("t"));
      CHECK(frame.value("t") == between(0, judge.last(), "one period"));
      CHECK(frame.value("phi") == within(phi, judge.slack(), judge.because));
      CHECK(frame.value("x") == within(sin(phi), judge.slack(), judge.because));
      CHECK(frame.value("y") == within(-cos(phi), judge.slack(), judge.because));
    }
  }
}

const Erratum the_swing{"§33, T for 350°, and that of the seconds pendulum",
                        {"4,52023 Θ, 4½ seconds", 4.52023},
                        {"2,87766 Θ, 2,9 seconds", 2.87766},
                        "the forgotten factor 2/π: the motion says so, and his own series of §9",
                        [](double reading) {
                          return after_half_of(reading, 5_deg)
                                     == within(0, 1.6e-5, "half a unit of the fifth decimal, times π")
                                 && series(std::pow(std::cos(2.5_deg), 2), 20'000)
                                        == within(reading, 0.5e-5, "half a unit of the fifth decimal");
                        }};

/*!
The sum 4,52023 is not quite {{sum|7}}, because all three members were rounded upwards.
*/

CHECK_THAT("the members' true sum rounds to 4,52022; rounded singly, upwards all, they make 4,52023")
{
  const auto m = three_members(exact::pi() / 72, 40);
  CHECK(m.sum() == printed("4,52022"));
  CHECK(m.first == between(3.826745, 3.82675, "rounded up to 3,82675"));
  CHECK(m.second == between(0.692485, 0.69249, "rounded up to 0,69249"));
  CHECK(m.third == between(0.000985, 0.00099, "rounded up to 0,00099"));
}

CHECK_THAT("the series and the motion agree with the arithmetic-geometric mean")
{
  const Fifty exact = ratio_by_mean(exact::pi() / 36);
  CHECK(
      series(std::pow(std::cos(2.5_deg), 2), 20'000)
      == within_relative(exact, 5e-14, "cc is rounded twice, and 91 times as much of that is in the sum"));
  CHECK(after_half_of(double(exact), 5_deg)
        == within(0, 1e-12, "4000 roundings, the first of them grown 8/η-fold"));
}

/*!
What is told at 5°, at a right angle from the top, and nearer to it, by the oracle's time and its exact
motion:
*/

CHECK_THAT("the times told are the exact swing's, the members short of it by their own bound")
{
  for(const Told& now : told_at("", "eta=90 Theta=2", "eta=0.01 Theta=1e-50"))
  {
    const Fifty eta = swing_.eta.fifty(), T = swing::oracle::ratio_from_top(eta),
                quarter = T * exact::pi() / 2;
    const double s = std::sin(swing_.eta / 2), bound = 0.437 * std::pow(s, 4) / std::cos(swing_.eta / 2);
    const char* const why = "the members' own bound, and a few roundings";
    CHECK(now.value("sum") == between(quarter - bound - 4e-15, quarter + 4e-15, why));
    CHECK(now.value("his_mended")
          == within_relative(Fifty("9.04046") / exact::pi(), 3e-16, "twice the sum, over π"));
    CHECK(now.value("mended") == between(T - 2 / exact::pi() * bound - 3e-15, T + 3e-15, why));
    CHECK(now.value("T", seconds) == within_relative(Theta.fifty() * T, 3e-16, "a product"));
    CHECK(now.value("T_over_Theta") == within_relative(T, 1e-45, "two ways of fifty digits"));
    CHECK(now.exact("ratio") == within_relative(T, 1e-45, "two ways of fifty digits"));
    CHECK(now.method("ratio", "three members")
          == within(T, bound + std::pow(s, 8) + 3e-15, "four terms of the factor"));
    CHECK(now.method("ratio", "arithmetic-geometric mean") == within_ulps(T, 4, "its own bound"));
    CHECK(now.method("ratio", "this edition")
          == within_ulps(T, 1, "η rounds by less, and the library's bound"));
  }
}

CHECK_THAT(
    "20000 terms serve at 5° to 91 times the rounding of cc, and not a hundredth of a degree from the top")
{
  for(const Told& now : told_at("", "eta=90 Theta=2"))
  {
    const Fifty T = swing::oracle::ratio_from_top(swing_.eta.fifty());
    CHECK(now.method("ratio", "series of §9, 20000 terms")
          == within_relative(T, 5e-14, "as the check above says"));
  }
  for(const Told& now : told_at("eta=0.01"))
  {
    const Fifty T = swing::oracle::ratio_from_top(swing_.eta.fifty());
    CHECK(now.method("ratio", "series of §9, 20000 terms")
          == between(T * Fifty("0.5"), T * Fifty("0.8"), "from a fifth to a half of the time is missing"));
  }
}

CHECK_THAT(
    "at half of Euler's time, and all along the figure's curve, the pendulum is where the exact motion is")
{
  for(const Told& now : told_at("", "eta=90 Theta=2", "eta=20"))
  {
    const auto motion = swing::oracle::Motion::from_eta(swing_.eta.fifty());
    const Fifty members = three_members(swing_.eta.fifty() / 2, 40).sum(), unit = exact::pi() / 2;
    CHECK(now.value("half_way", degrees)
          == within(motion.angle(unit * members - motion.quarter()), 2e-10,
                    "4000 steps, their error grown 8/η-fold"));
    for(const auto& point : now.points("swing", 6))
    {
      const Fifty t = Fifty(point.at("seconds")) / Theta.fifty() * exact::pi() - motion.quarter();
      CHECK(point.value("angle")
            == within(motion.angle(t) * 180 / exact::pi(), 2e-8, "the same, in degrees"));
    }
    for(const auto& point : now.points("ends"))
    {
      const Fifty T = swing::oracle::ratio_from_top(swing_.eta.fifty());
      CHECK(point.value("exact")
            == within_relative(Theta.fifty() * T, 4e-16, "the library's bound, a product"));
      CHECK(point.value("euler") == within_relative(Theta.fifty() * members, 1e-15, "a few roundings"));
      CHECK(point.value("turn")
            == within_relative(swing_.zeta.fifty() * 180 / exact::pi(), 4e-16, "a quotient"));
    }
  }
}

/*!
## Go on from here

::: exercise
From which angle would the seconds pendulum really take four and a half seconds?

answer: From 0.3903°, less than the twelfth part of Euler's five degrees: $\frac2\pi\,l\frac8\eta =
4\frac12$.
:::
*/

CHECK_THAT("four and a half seconds belong to 0.3903°")
{
  for(const Told& now : told_at("eta=0.3902782"))
    CHECK(now.value("T", seconds) == within(4.5, 1e-5, "η to seven digits, and ηη"));
}
