#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "edition/section.hpp"
#include "pendulum/logarithms.hpp"
#include "pendulum/three_members.hpp"
#include "swing/motion.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 33, "First example: four and a half seconds, or not quite three")

using namespace pendulum;

/*!
## What Euler does

He adds up the members and finds that a swing through 350° takes four times and a half as long as a small
one:

$$ T = (3{,}82675 + 0{,}69249 + 0{,}00099)\,\Theta = 4{,}52023\,\Theta. \tag{1} $$

So if the pendulum beats seconds in its smallest swings, it will need about $4\tfrac12$ seconds for a swing
through an arc of 350°. And if it goes through arcs still greater, still nearer to the full circle, the time
will grow greatly, until for all the 360° it is infinite. One more example, whose arc is short of the circle
by two degrees only, shall show how.

What he has added up is right, and the time is not. The three members make half a swing, in the unit
$\sqrt b/\sqrt{2g}$; the factor forgotten in {{sec pendulum.29}} brings the swing down to

$$ T = \frac2\pi\cdot 4{,}52023\,\Theta = 2{,}8777\,\Theta, \tag{2} $$

and the seconds pendulum takes not four seconds and a half but less than three.

## The program

Everything turns on whether the swing of 350° takes 4.5 or 2.9 seconds, so the program asks in every way it
can. First Euler's own numbers.
*/

const auto swing_ = amplitude_from_top(5_deg, closed(90_deg, 179.99_deg));
const auto Theta = real("Theta", 1.0, seconds, positive, "time of one infinitely small swing");

constexpr double euler_adds = 3.82675 + 0.69249 + 0.00099;  // (1)

/*!
Then his own series of {{sec pendulum.09}}, which converges here too if one has the patience for some ten
thousand terms. Their rounding adds up, unless each term carries the small quantity,
$1 - cc = \sin^2\tfrac12\eta$, and the smallest terms are added first.
*/

double by_his_series(double eta, int terms)
{
  const double log_cc = std::log1p(-std::pow(std::sin(eta / 2), 2));
  double sum = 0;
  for(int n = terms - 1; n >= 0; --n)
  {
    const double log_a =
        n == 0 ? 0 : std::lgamma(n + 0.5) - std::lgamma(n + 1.0) - 0.5 * std::log(std::numbers::pi);
    sum += std::exp(2 * log_a + n * log_cc);
  }
  return sum;
}

/*!
Then the motion itself, by a general integrator that knows nothing of elliptic integrals: from rest at η
below the top, $\psi'' = \sin\psi$, until $\psi$ reaches the other η. The unit of time is
$\sqrt b/\sqrt{2g}$, so $\Theta$ is π.
*/

int falling(double, const double y[], double dydt[], void*)
{
  dydt[0] = y[1];
  dydt[1] = std::sin(y[0]);
  return GSL_SUCCESS;
}

double by_the_motion(double eta)  // T/Θ
{
  gsl_odeiv2_system system{falling, nullptr, 2, nullptr};
  gsl_odeiv2_driver* driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 1e-13, 1e-13);
  double time = 0;
  double y[2] = {eta, 0};
  while(y[0] < std::numbers::pi - 0.01)
    gsl_odeiv2_driver_apply(driver, &time, time + 0.005, y);
  gsl_odeiv2_driver_free(driver);
  const double speed = y[1];  // near the lowest point it hardly changes: sin ψ is below 0.01
  const double left = std::numbers::pi - y[0];
  return 2 / std::numbers::pi * (time + left / speed * (1 - left * left / (6 * speed * speed)));
}

/*!
And last the arithmetic-geometric mean. Side by side:
*/

TELL
{
  const double eta = swing_.eta;
  const auto m = three_members(eta / 2, 40);
  const Fifty exact = ratio_by_mean(swing_.eta.fifty());
  tell("printed", Theta * 4.52023, seconds, "Euler's T for the example of 5°");
  tell("members", m.sum(), "the three members, added");
  tell("T_by_members", Theta * 2 / std::numbers::pi * m.sum(), seconds, "T by the members and (2)");
  tell("T_by_series", Theta * by_his_series(eta, 20'000), seconds, "T by 20000 terms of the series of §9");
  tell("T_by_motion", Theta * by_the_motion(eta), seconds, "T by integrating the equation of motion");
  tell("T", Theta * static_cast<double>(exact), seconds, "T by the arithmetic-geometric mean");
  tell("T_over_Theta", exact, "T/Θ to thirty digits");
  race("ratio", "T/Θ", exact,
       {{"three members", [=] { return 2 / std::numbers::pi * three_members(eta / 2, 4).sum(); }},
        {"20000 terms of §9", [=] { return by_his_series(eta, 20'000); }},
        {"the motion, rk8pd to 1e-13", [=] { return by_the_motion(eta); }},
        {"arithmetic-geometric mean", [=] { return ratio_by_mean(eta); }},
        {"this edition", [=] { return swing::ratio_from_top(eta); }}});
}

/*!
For the picture, the swing is followed in time.
*/

TELL
{
  curve("swing", {"seconds", "angle"}, [](Curve& c) {
    const swing::Motion motion(swing::Amplitude{swing_.zeta, swing_.eta});
    const double whole = swing::ratio_from_top(swing_.eta);
    for(int i = 0; i <= 400; ++i)
    {
      const double seconds_since_rest = whole * i / 400;
      c.put({Theta * seconds_since_rest,
             motion.angle(std::numbers::pi * (seconds_since_rest - whole / 2)) / 1_deg});
    }
  });
}

/*!
A pendulum that beats seconds takes {{T|6}} s through {{zeta|4}}° to either side; Euler prints {{printed|6}}
s. His three members are right to the fifth decimal.

::: figure pendulum-33
alt: The angle of the pendulum against time for one swing from minus 175 to plus 175 degrees. It lingers
near the ends, passes the lowest point in the middle and comes to rest at 2.88 seconds. A mark at 4.52
seconds, well to the right, shows where Euler's time ends.

The swing of 350° of a seconds pendulum, from rest to rest. It is over after 2,88 s; Euler's time ends far
beyond.
:::

## Checks
*/

CHECK_THAT("the members are added rightly, and make half a swing, not a whole one")
{
  CHECK(euler_adds == within(4.52023, 1e-15, "three decimals added in binary"));
  CHECK(double(ratio_by_mean(exact::pi() / 36) * exact::pi() / 2)
        == within(euler_adds, 1e-5, "three numbers of five decimals"));
}

const Erratum the_swing{"§33, T for 350°",
                        {"4,52023 Θ", 4.52023},
                        {"2,87766 Θ", 2.87766},
                        "the forgotten factor 2/π; his own series, the motion and the mean agree",
                        [](double reading) {
                          const double by_series = by_his_series(5_deg, 20'000);
                          const double by_motion = by_the_motion(5_deg);
                          return by_series == within(reading, 0.5e-5, "half a unit of the fifth decimal")
                                 && by_motion == within(reading, 0.5e-5, "half a unit of the fifth decimal")
                                 && ratio_by_mean(exact::pi() / 36)
                                        == within(reading, 0.5e-5, "half a unit of the fifth decimal");
                        }};

const Erratum in_seconds{
    "§33, the seconds pendulum",
    {"about 4½ seconds", 4.5},
    {"about 2 9/10 seconds", 2.9},
    "the same factor",
    [](double reading) { return by_the_motion(5_deg) == within(reading, 0.05, "about, in tenths"); }};

CHECK_THAT("the three ways that do not use Euler's members agree among themselves")
{
  const Fifty exact = ratio_by_mean(exact::pi() / 36);
  CHECK(by_his_series(5_deg, 20'000)
        == within_relative(exact, 2e-13, "the rounding of lgamma, over the 500 terms that count"));
  CHECK(by_the_motion(5_deg)
        == within_relative(exact, 2e-11, "10⁻¹³ a step, grown by 8/η, and the last hundredth of a radian"));
  CHECK(swing::ratio_from_top(5_deg) == within_ulps(exact, 2, "the library's bound, and 5° rounded"));
}

/*!
The sum of the rounded members has a last digit that is one too large, since all three were rounded upwards.
*/

const Erratum last_digit{"§33, the sum of the members",
                         {"4,52023", 4.52023},
                         {"4,52022", 4.52022},
                         "each member is rounded upwards",
                         [](double reading) {
                           return three_members(exact::pi() / 72, 40).sum()
                                  == within(reading, 0.5e-5, "half a unit");
                         }};
