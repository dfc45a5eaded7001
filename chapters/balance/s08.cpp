#include "balance/instrument.hpp"
#include "balance/motion.hpp"
#include "edition/section.hpp"

SECTION(balance, 8, "What moves the pan Q")

using namespace balance;

/*!
## What Euler does

The other pan has two equations like those of the first. Its string pulls with the force $Q$: upward with
$Q\cos\vartheta$, and with $Q\sin\vartheta$ horizontally, now away from $C$, since ϑ leans the other way. So

$$ \begin{gathered} \text{III.}\quad \frac{ddx'}{2g\,dt^2} = \frac{Q\sin\vartheta}L,\\
   \text{IV.}\quad \frac{ddy'}{2g\,dt^2} = \frac{L - Q\cos\vartheta}L,
\end{gathered} \tag{1} $$

where $g$ is the height through which heavy bodies fall in one second. Everything moves in seconds, then,
and the unit of length is left free.

The plus in III is the only difference from I. It comes from two conventions that act against each other: $x'$
is counted outward, that is to the side of $B$, while ϑ, like η, is counted to the side of $A$.
A string that leans by a positive ϑ pulls its pan outward.

::: margin
Today $g$ is twice that height: 32.17 ft/s², not {{todays_height|4}} ft.
:::

The two pans are images of each other. In a mirror that exchanges the sides, $A$ with $B$, the motion

$$ (\omega,\eta,\vartheta) \quad\text{becomes}\quad (-\omega,-\vartheta,-\eta), \tag{A} $$

and $Q$ is the pull that $P$ has there. So nothing has to be derived twice.

## The program

The program makes use of {{eq A}}: it reckons the pull of $BQ$ as that of $AP$ in the mirror.
*/

const auto a = real("a", 2, feet, closed(1e-3, 1e3), "CA = CB, half the beam");
const auto b = real("b", 32. / 9, feet, closed(1e-3, 1e3), "AP = BQ, the strings");
const auto c = real("c", 0.1, feet, closed(0, 1e3), "CG, depth of the beam's centre of gravity");
const auto k = real("k", 1.0909, feet, closed(1e-3, 1e3), "the beam's radius of gyration about G");
const auto L = real("L", 1, none, closed(1e-6, 1e6), "weight of each pan");
const auto M = real("M", 4, none, closed(1e-6, 1e6), "weight of the beam");
const auto g = real("g", 16, feet, closed(1e-3, 1e3), "height fallen in the first second");
const auto omega = angle("omega", 10_deg, closed(-90_deg, 90_deg), "inclination ω of the beam");
const auto eta = angle("eta", 20_deg, closed(-180_deg, 180_deg), "inclination η of the string AP");
const auto theta = angle("theta", 5_deg, closed(-180_deg, 180_deg), "inclination ϑ of the string BQ");
const auto omega_rate = real("omega_rate", 0.1, Unit{"1/s"}, closed(-1e3, 1e3), "dω/dt");
const auto eta_rate = real("eta_rate", -0.3, Unit{"1/s"}, closed(-1e3, 1e3), "dη/dt");
const auto theta_rate = real("theta_rate", 0.2, Unit{"1/s"}, closed(-1e3, 1e3), "dϑ/dt");

const auto given = [] { return Instrument{a, b, c, k * k, L, M, g}; };
const auto now_at = [] { return State<>{{omega, eta, theta}, {omega_rate, eta_rate, theta_rate}}; };

Angles<> mirrored(const Angles<>& x)  // (A)
{
  return {-x.omega, -x.theta, -x.eta};
}

double pull_of_BQ(const Instrument& balance_, const State<>& now)  // Q/L, in fifty digits as P in § 7
{
  return double(tensions(widened(balance_), widened({mirrored(now.at), mirrored(now.rate)})).P);
}

constexpr double foot = 0.3048;  // metres

TELL
{
  const double Q = pull_of_BQ(given(), now_at());
  tell("Q", Q, "the pull of the string BQ, Q/L", 13);
  tell("outward", Q * std::sin(theta), "III, ddx′/(2g dt²)", 13);
  tell("down", 1 - Q * std::cos(theta), "IV, ddy′/(2g dt²)", 13);
  tell("todays_height", 9.80665 / 2 / foot, feet, "half of today's standard g, in feet", 6);
}

TELL
{
  curve("accelerations", {"lambda_t", "by_III", "by_differences"}, [](Curve& out) {
    const Balance<> example = numbers_of(instrument_of_35);
    const int parts = 720;
    const double step = 2 * std::numbers::pi / parts;
    const std::vector<State<>> all =
        course(example, released(10_deg, 20_deg, 0), 2 * std::numbers::pi, parts);
    const auto x1 = [&](int i) {
      return places<double>(instrument_of_35.a, instrument_of_35.b, all[static_cast<std::size_t>(i)].at).x1;
    };
    for(int i = 4; i + 4 <= parts; i += 4)
    {
      const State<>& now = all[static_cast<std::size_t>(i)];
      const double second = (x1(i + 4) - 2 * x1(i) + x1(i - 4)) / (16 * step * step);
      out.put({0.5 * i, pull_of_BQ(instrument_of_35, now) * std::sin(now.at.theta),
               second / (2 * instrument_of_35.g)});
    }
  });
}

/*!
The pan Q is pulled by {{Q|5}} of its weight, outward by {{outward|4}} of gravity. Euler's 16 English feet
({{sec balance.35}}) for the height fallen are {{todays_height|5}} feet today.

::: figure balance-08
alt: The outward acceleration of Q over one swing of the beam. The curve is flat near zero at first, since
the pan starts at rest, and then swings with a changing strength. Small points from the positions lie on the
line from the pull.

The pan Q, let go hanging straight down while the beam begins at 10°, P at 20°. Its outward acceleration in
parts of gravity by III: the line; by taking its place every two degrees and forming second differences: the
points. A pan that {{sec balance.28}} leaves at rest for ever is already moving.
:::

## Checks
*/

CHECK_THAT("x′ and y′ along the motion that follows from the energies obey III and IV with the pull told")
{
  for(const Told& now : told_at(
          "", "a=1 b=0.5 c=0.3 k=0.4 L=3 M=1 g=4.9 omega=-60 eta=100 theta=-130 omega_rate=2 eta_rate=-9",
          "c=0 L=1e-6 k=900 theta_rate=30 omega_rate=-4", "L=1e6 M=1e-3 omega=1e-9 eta=-1e-9 theta=0"))
  {
    const State<Fifty> state = widened(now_at());
    const auto of =
        place_accelerations<Fifty>(double(a), double(b), state, accelerations(widened(given()), state));
    const Fifty G = 2 * Fifty(double(g)), x1 = of.x1 / G, y1 = of.y1 / G;
    const Fifty st = sin(state.at.theta), ct = cos(state.at.theta);
    const double allowed = 1e-15 * (1 + double(abs(x1) + abs(y1)));
    const char* const why = "few roundings of the largest part";
    CHECK(now.value("Q") == within_ulps((1 - y1) * ct + x1 * st, 1, "one rounding, of fifty digits"));
    CHECK(now.value("outward") == within(x1, allowed, why));
    CHECK(now.value("down") == within(y1, allowed, why));
    CHECK(now.value("todays_height", feet)
          == within_relative(Fifty("9.80665") / 2 / Fifty("0.3048"), 1e-15, "two quotients"));
  }
}

CHECK_THAT(
    "the pull in the mirror is the one of BQ itself, and today's height of fall rounds to Euler's 16")
{
  for(const State<>& now :
      {State<>{{0.1, -0.12, 0.08}, {0.3, -0.2, 0.4}}, State<>{{-0.9, 0.7, 1.3}, {1.1, -2, 0.6}}})
    CHECK(pull_of_BQ(instrument_of_35, now)
          == within_ulps(five_equations(instrument_of_35, now).tension.Q, 1, "two reckonings rounded"));
  for(const Told& now : told_at(""))
    CHECK(now.value("todays_height", feet) == printed("16"));
}

CHECK_THAT("in the figure the second differences of the place are the pull's acceleration, to their order, "
           "and both are right at moments to which GSL carries the motion")
{
  const Balance<> example = numbers_of(instrument_of_35);
  const State<> start = released(10_deg, 20_deg, 0);
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("accelerations", 7))
    {
      const double t = point.at("lambda_t") * 1_deg, step = 2_deg;
      const State<> there = by_gsl(example, start, t, 1e-13);
      const Fifty Q = tensions(widened(instrument_of_35), widened(there)).Q;
      CHECK(point.value("by_III") == within(Q * sin(Fifty(there.at.theta)), 1e-11, "GSL's tolerance"));
      const auto x1 = [&](double time) {
        const Angles<> at = time > 1e-9 ? by_gsl(example, start, time, 1e-13).at : start.at;
        return places<double>(instrument_of_35.a, instrument_of_35.b, at).x1;
      };
      const double second = (x1(t + step) - 2 * x1(t) + x1(t - step)) / (step * step);
      CHECK(point.value("by_differences")
            == within(second / (2 * instrument_of_35.g), 1e-9, "roundings over a square"));
      CHECK(
          point.value("by_differences")
          == within(Q * sin(Fifty(there.at.theta)), 2e-4, "a twelfth of the step's square, fourth rates"));
    }
}

/*!
## Go on from here

::: exercise
Hang the balance at rest with both strings vertical and the beam at 30°, and read the pulls. Which pan is
heavier in the hand?

answer: With `--omega 30 --eta 0 --theta 0` and no rates Q pulls with more than its weight: B is low and
begins to rise, and the pan must be accelerated upward with it.
:::
*/

CHECK_THAT("under a beam let go at 30° the lower pan pulls with more than its weight")
{
  for(const Told& now : told_at("omega=30 eta=0 theta=0 omega_rate=0 eta_rate=0 theta_rate=0"))
    CHECK(now.value("Q") == between(1.001, 1.5, "the beam turns back"));
}
