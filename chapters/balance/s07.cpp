#include "balance/instrument.hpp"
#include "balance/motion.hpp"
#include "edition/section.hpp"

SECTION(balance, 7, "What moves the pan P")

using namespace balance;

/*!
## What Euler does

Two forces act on the pan P, its weight and the pull of its string, and Newton's law gives two equations.
Gravity urges it downward {{entry urged}} with the force $L$. The string $AP$ pulls it along itself with a
force that is not known beforehand; Euler calls it $P$, like the pan. It is resolved into a vertical part
$P\cos\eta$ upward, and a horizontal part $P\sin\eta$, which drives the pan towards $C$. So the pan is urged
upward with $P\cos\eta - L$, and its motion is determined by

$$ \begin{gathered} \text{I.}\quad \frac{ddx}{2g\,dt^2{{entry two_g}}} = -\frac{P\sin\eta}L,\\
   \text{II.}\quad \frac{ddy}{2g\,dt^2} = \frac{L - P\cos\eta}L.
\end{gathered} \tag{1} $$

::: margin
$m\ddot{\mathbf r} = \mathbf F$. Euler measures masses by their weights, and $g$ is the height fallen in
the first second: $2g$ is the acceleration of gravity.
:::

The pull is not the weight's component along the string. It also has to keep the pan on its circle, and to
lift or let down the end of the beam from which it hangs. Resolved along the string, {{eq 1}} says that

$$ \begin{aligned} \frac PL = \cos\eta &+ \frac{b\,\dot\eta^2}{2g}\\
  &+ \frac{a\,\ddot\omega\cos(\omega-\eta)}{2g}\\
 &- \frac{a\,\dot\omega^2\sin(\omega-\eta)}{2g}. \end{aligned} \tag{A} $$

## The program

The acceleration $\ddot\omega$ of the beam depends on both pans. Here it is taken from the equations without
tensions ({{sec balance.10}}), which come from the energies alone; with it the pull is {{eq A}}, and the
forces are {{eq 1}}. Of a light beam between heavy pans that acceleration is a small difference, and it is
reckoned in fifty digits.

::: code balance/instrument.hpp tensions
:::
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

double across(double P, double inclination)  // (1), I
{
  return -P * std::sin(inclination);
}

double down(double P, double inclination)  // (1), II
{
  return 1 - P * std::cos(inclination);
}

TELL
{
  const double P = double(tensions(widened(given()), widened(now_at())).P);
  tell("P", P, "the pull of the string AP, P/L", 13);
  tell("upward", P * std::cos(eta), "its vertical part, P cos η/L", 13);
  tell("inward", P * std::sin(eta), "its horizontal part, P sin η/L, towards C", 13);
  tell("ddx", across(P, eta), "ddx/(2g dt²) by I", 13);
  tell("ddy", down(P, eta), "ddy/(2g dt²) by II", 13);
}

TELL
{
  curve("forces", {"lambda_t", "upward", "inward"}, [](Curve& out) {
    const Balance<> example = numbers_of(instrument_of_35);
    int degree = 0;
    for(const State<>& now : course(example, released(10_deg, 20_deg, 20_deg), 2 * std::numbers::pi, 360))
    {
      const double P = tensions(example, now).P;
      out.put({double(degree++), P * std::cos(now.at.eta), P * std::sin(now.at.eta)});
    }
  });
}

/*!
In the state given the string pulls with {{P|5}} of the pan's weight; the pan is accelerated by {{ddx|4}} of
gravity outward and by {{ddy|3}} downward.

::: figure balance-07
alt: Two curves over one swing of the beam. The horizontal part of the pull swings about zero between plus
and minus a third of the weight, three times. The vertical part stays near one, and rises and falls twice as
often.

The two parts of the pull in weights of the pan, for the balance of {{sec balance.35}} let go at
$\omega = 10°$, $\eta = \vartheta = 20°$. The horizontal part follows the angle; the vertical one, which
alone can turn a level beam, goes up and down with its square, and with the beam.
:::

## Checks

The coordinate $x$ is differentiated twice in fifty digits, the accelerations of the three angles being those
that follow from the energies. What comes out must be what {{eq 1}} makes of the pull.
*/

std::array<Fifty, 2> twice_differentiated(const State<Fifty>& now, const Angles<Fifty>& acceleration)
{
  const Fifty G = 2 * Fifty(double(g));
  const auto of = place_accelerations<Fifty>(double(a), double(b), now, acceleration);
  return {of.x / G, of.y / G};
}

CHECK_THAT("along the motion that follows from the energies, x and y obey I and II with the pull told")
{
  for(const Told& now : told_at(
          "", "a=1 b=0.5 c=0.3 k=0.4 L=3 M=1 g=4.9 omega=-60 eta=100 theta=-130 omega_rate=2 eta_rate=-9",
          "c=0 L=1e-6 k=900 eta_rate=30 omega_rate=-4", "L=1e6 M=1e-3 omega=1e-9 eta=-1e-9 theta=0"))
  {
    const State<Fifty> state = widened(now_at());
    const auto [x, y] = twice_differentiated(state, accelerations(widened(given()), state));
    const Fifty upward = 1 - y, inward = -x, P = upward * cos(state.at.eta) + inward * sin(state.at.eta);
    const double allowed = 1e-15 * (1 + double(abs(x) + abs(y)));
    const char* const why = "few roundings of the largest part";
    CHECK(now.value("P") == within_ulps(P, 1, "one rounding, of fifty digits"));
    CHECK(now.value("upward") == within(upward, allowed, why));
    CHECK(now.value("inward") == within(inward, allowed, why));
    CHECK(now.value("ddx") == within(x, allowed, why));
    CHECK(now.value("ddy") == within(y, allowed, why));
  }
}

CHECK_THAT(
    "with the beam at rest in its balance and held by its mass the pull is that of a simple pendulum")
{
  for(const Told& now : told_at("M=1e6 k=1000 omega=0 omega_rate=0 eta=60 eta_rate=0",
                                "M=1e6 k=1000 omega=0 omega_rate=0 eta=0 eta_rate=3"))
    CHECK(now.value("P")
          == within(cos(eta.fifty()) + b.fifty() * pow(eta_rate.fifty(), 2) / (2 * g.fifty()), 1e-9,
                    "the pans' share of the inertia"));
}

CHECK_THAT("the figure's forces are those on the integrated motion, which GSL finds too")
{
  const Balance<> example = numbers_of(instrument_of_35);
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("forces", 7))
    {
      const double t = point.at("lambda_t") * 1_deg;
      const State<> start = released(10_deg, 20_deg, 20_deg);
      const State<> there = t > 0 ? by_gsl(example, start, t, 1e-13) : start;
      const Fifty P = tensions(widened(instrument_of_35), widened(there)).P;
      CHECK(point.value("upward") == within(P * cos(Fifty(there.at.eta)), 1e-10, "GSL's tolerance"));
      CHECK(point.value("inward") == within(P * sin(Fifty(there.at.eta)), 1e-10, "GSL's tolerance"));
    }
}

/*!
In I our copy has $a\,g\,dt^2$ for $2g\,dt^2$, and that the pan *seems* to be downward where it is urged.
*/

double time_of_fall(double factor)  // through the height g, from rest, when ddx = factor·g dt²
{
  return std::sqrt(2 / factor);
}

const Emendation two_g{"§7, I, the divisor of ddx",
                       {"a g dt², a being 16/9", time_of_fall(16. / 9)},
                       {"2g dt²", time_of_fall(2)},
                       "g is fallen through in one second; II to IV have 2g",
                       [](double time) { return time == within_ulps(1, 1, "a root"); }};

const Emendation urged{"§7, what gravity does to the pans",
                       {"they seem to be, no force", 0},
                       {"they are urged downward with the force L", 1},
                       "a pan that hangs at rest is pulled up by L and must not move",
                       [](double weight) { return weight - 1 == within(0, 0, "II with P = L, η = 0"); }};

/*!
## Go on from here

::: exercise
The beam is level and at rest, both strings hang straight, and P passes its lowest place at 3 radians a
second. By how much does its string pull more than the weight? And were the beam as heavy as a house?
answer: With a beam that cannot yield by $b\dot\eta^2:2g$, here the whole weight once more. The beam given
yields, and spares the string the part $\rho = Laa:(M(kk+cc)+2Laa)$ of it: 0.69 of it remains.
:::
*/

CHECK_THAT("at its lowest place a pan pulls with its weight and the part 1 − ρ of its turning")
{
  for(const Told& now : told_at("omega=0 eta=0 theta=0 omega_rate=0 eta_rate=3 theta_rate=0",
                                "omega=0 eta=0 theta=0 omega_rate=0 eta_rate=3 theta_rate=0 M=1e6"))
  {
    const Fifty turning = b.fifty() * 9 / (2 * g.fifty()), Laa = L.fifty() * a.fifty() * a.fifty(),
                I = M.fifty() * (k.fifty() * k.fifty() + c.fifty() * c.fifty()) + 2 * Laa;
    CHECK(now.value("P") == within_relative(1 + (1 - Laa / I) * turning, 1e-14, "some roundings"));
    CHECK(now.value("P") == (M > 5 ? between(1.9999, 2, "a house") : between(1.685, 1.695, "0.69 more")));
  }
}
