#include "balance/instrument.hpp"
#include "balance/motion.hpp"
#include "edition/section.hpp"

SECTION(balance, 10, "Five equations for five unknowns")

using namespace balance;

/*!
## What Euler does

What is to be determined by the five equations? First of all the two tensions $P$ and $Q$, which must be got
rid of; then three equations are left, and from them the three angles η, ϑ and ω are to be found. Once these
are known for any time $t$, the true position of the beam and of both pans can be told, and the whole lofty
question is solved. If obstacles remain, he says, it is not mechanics that has to answer for them but
analysis alone.

He does not carry the elimination out, as he will not need it: from the next section on the angles are
very small. It can be done in three lines. Let I, multiplied by the cosine of η, and II, by its sine, be
subtracted so that $P$ goes out; and III and IV likewise:

$$ \begin{aligned}
\frac{b\,dd\eta}{2g\,dt^2} &= -\sin\eta + \frac a{2g}\bigl(\ddot\omega\sin(\omega-\eta)\\
   &\quad + \dot\omega^2\cos(\omega-\eta)\bigr),\\
\frac{b\,dd\vartheta}{2g\,dt^2} &= -\sin\vartheta\\
   &\quad - \frac a{2g}\bigl(\ddot\omega\sin(\omega-\vartheta)\\
   &\quad + \dot\omega^2\cos(\omega-\vartheta)\bigr).
\end{aligned} \tag{A} $$

Then the tensions, as they follow from the same four by the other combination ({{sec balance.07}}), are put
into V. In them stands $\ddot\omega$ again, and it is brought to the left:

$$ \begin{aligned}
&\bigl[M(kk+cc)\\
 &\quad + Laa(p^2+q^2)\bigr]\frac{dd\omega}{2g\,dt^2}\\
 &= -Mc\sin\omega\\
 &\ - Lap\Bigl(\cos\eta\\
 &\quad + \frac{b\dot\eta^2 - a\dot\omega^2\sin(\omega-\eta)}{2g}\Bigr)\\
 &\ + Laq\Bigl(\cos\vartheta\\
 &\quad + \frac{b\dot\vartheta^2\! + a\dot\omega^2\sin(\omega-\vartheta)}{2g}\Bigr),\\
&p = \cos(\omega-\eta),\\ &q = \cos(\omega-\vartheta).
\end{aligned} \tag{B} $$

The bracket is never less than the beam's own moment of inertia; so the accelerations can always be found, and
the equations determine the motion from its beginning for all time. Only the part of each pan's weight that
moves along its string burdens the beam: $p^2$ and $q^2$ of it.

::: margin
Today: a differential-algebraic system, its constraints used up by the choice of coordinates. (A) and (B) are
Lagrange's equations.
:::

The mechanics has one limit, though. A string cannot push. If a tension comes out negative the string has
become slack, and the pan flies freely; the five equations then hold no longer.

## The program

The obstacles that he leaves to analysis are overcome by arithmetic. The five equations are solved as they
stand for the five unknowns, by {{api balance::five_equations}}; and from their accelerations the motion is
carried on, however wide, by {{api balance::Motion}}. The start given is one far beyond the smallest
oscillations. From such starts neighbouring motions part rapidly, and the roundings of any reckoning with
them; where a slight change would grow more than ten thousand times until $t$ the program refuses.
*/

const auto a = real("a", 16. / 9, feet, closed(0.1, 10), "CA = CB, half the beam");
const auto b = real("b", 32. / 9, feet, closed(0.1, 10), "AP = BQ, the strings");
const auto c = real("c", 8. / 81, feet, closed(0, 10), "CG, depth of the beam's centre of gravity");
const auto k = real("k", 1.2532, feet, closed(0.1, 10), "the beam's radius of gyration about G");
const auto L = real("L", 1, none, closed(0.01, 10), "weight of each pan");
const auto M = real("M", 4, none, closed(0.1, 10), "weight of the beam");
const auto g = real("g", 16, feet, closed(0.1, 100), "height fallen in the first second");
const auto omega = angle("omega", 34_deg, closed(-90_deg, 90_deg), "inclination ω of the beam");
const auto eta = angle("eta", 52_deg, closed(-90_deg, 90_deg), "inclination η of the string AP");
const auto theta = angle("theta", -29_deg, closed(-90_deg, 90_deg), "inclination ϑ of the string BQ");
const auto omega_rate = real("omega_rate", 0, Unit{"1/s"}, closed(-5, 5), "dω/dt");
const auto eta_rate = real("eta_rate", 0, Unit{"1/s"}, closed(-5, 5), "dη/dt");
const auto theta_rate = real("theta_rate", 0, Unit{"1/s"}, closed(-5, 5), "dϑ/dt");
const auto t = real("t", 10, seconds, closed(0, 50), "a later time");

const auto given = [] { return Instrument{a, b, c, k * k, L, M, g}; };
const auto start = [] { return State<>{{omega, eta, theta}, {omega_rate, eta_rate, theta_rate}}; };

double beam_by_three(const Instrument& x, const State<>& now)  // (B)
{
  const auto& [at, rate] = now;
  const double G = 2 * x.g, s1 = std::sin(at.omega - at.eta), p = std::cos(at.omega - at.eta),
               s2 = std::sin(at.omega - at.theta), q = std::cos(at.omega - at.theta);
  const double square = x.a * rate.omega * rate.omega;
  const double P = std::cos(at.eta) + (x.b * rate.eta * rate.eta - square * s1) / G;
  const double Q = std::cos(at.theta) + (x.b * rate.theta * rate.theta + square * s2) / G;
  const double bracket = x.M * (x.kk + x.c * x.c) + x.L * x.a * x.a * (p * p + q * q);
  return G * (-x.M * x.c * std::sin(at.omega) + x.L * x.a * (q * Q - p * P)) / bracket;
}

TELL
{
  const Five five = five_equations(given(), start());
  const Unit rate{"1/s²"};
  tell("omega_dd", five.acceleration.omega, rate, "ddω/dt² at the start, by the five equations", 15);
  tell("eta_dd", five.acceleration.eta, rate, "ddη/dt²", 15);
  tell("theta_dd", five.acceleration.theta, rate, "ddϑ/dt²", 15);
  tell("P", five.tension.P, "P/L", 15);
  tell("Q", five.tension.Q, "Q/L", 15);
}

struct Later
{
  State<> state;
  double slackest;      // the least tension of both strings at 1000 instants and at the start
  double energy_drift;  // to the rounding
  double grown;         // how many times a slight change of the start has grown, at the worst
};

double apart(const Angles<>& x, const Angles<>& y)
{
  return std::max({std::abs(x.omega - y.omega), std::abs(x.eta - y.eta), std::abs(x.theta - y.theta)});
}

Later later()
{
  const Balance<> balance_ = numbers_of(given());
  const double slight = 1e-9;
  State<> beside = start();
  beside.at.eta += slight;
  beside.at.theta += slight;
  Motion motion(balance_, start()), other(balance_, beside);
  Later found{start(), infinity, 0, 1};
  for(int i = 0; i <= 1000; ++i)
  {
    found.state = motion.to(t * i / 1000);
    const Tensions<> pull = tensions(balance_, found.state);
    found.slackest = std::min({found.slackest, pull.P, pull.Q});
    found.grown = std::max(found.grown, apart(found.state.at, other.to(t * i / 1000).at) / slight);
  }
  found.energy_drift = motion.energy_drift();
  return found;
}

TELL
{
  const Later found = later();
  require(found.grown <= 1e4, "t", "so short that a slight change does not grow ten thousand times");
  const auto& [at, rate] = found.state;
  const Unit speed{"1/s"};
  tell("omega_t", at.omega, degrees, "ω at the time t", 11);
  tell("eta_t", at.eta, degrees, "η then", 11);
  tell("theta_t", at.theta, degrees, "ϑ then", 11);
  tell("omega_rate_t", rate.omega, speed, "dω/dt then", 10);
  tell("eta_rate_t", rate.eta, speed, "dη/dt then", 10);
  tell("theta_rate_t", rate.theta, speed, "dϑ/dt then", 10);
  tell("slackest", found.slackest,
       "the least pull of a string, in weights of a pan, at 1001 instants until t", 9);
}

TELL
{
  curve("angles", {"t", "omega", "eta", "theta"}, [](Curve& out) {
    int i = 0;
    for(const State<>& now : course(numbers_of(given()), start(), t, 600))
      out.put({t * i++ / 600, now.at.omega / 1_deg, now.at.eta / 1_deg, now.at.theta / 1_deg});
  });
}

/*!
Let go in that attitude the strings pull with {{P|4}} and {{Q|4}} of a pan's weight, and after {{t}} s the
beam stands at {{omega_t|deg2}}, the strings at {{eta_t|deg2}} and {{theta_t|deg2}}. The strings remain taut:
the least pull is {{slackest|3}}.

::: figure balance-10
alt: Three curves against ten seconds. The pans swing widely and not alike, by some 25 to 55 degrees;
the beam is thrown beyond the upright, comes back, swings less for a while, and is
thrown almost upright again.

The three angles by the five equations, from a start far beyond the smallest oscillations. The question is
solved, as he says, if only somebody integrates.
:::

## Speed against error

Elimination by hand saves most of the work of elimination by the machine, which besides is done in fifty
digits: of a light beam between heavy pans the acceleration is a small difference of two great moments.
*/

TELL
{
  const State<> now = start();
  const Instrument x = given();
  const Fifty beam = accelerations(widened(x), widened(now)).omega;
  if(beam == 0)
    return;  // nothing turns the beam
  race("beam", "ddω/dt²", beam,
       {{"five equations", [x, now] { return five_equations(x, now).acceleration.omega; }},
        {"three, (B)", [x, now] { return beam_by_three(x, now); }},
        {"by the energies", [x, now] { return accelerations(numbers_of(x), now).omega; }}});
}

/*!
## Checks

The five equations are judged by themselves: the unknowns are put back into I to V, in fifty digits, with
the second differentials of the coordinates.
*/

struct Left
{
  Fifty of_pans, of_beam;  // what does not cancel in I to IV, and in V, in parts of the greatest term
};

Left left_over(const Instrument& x, const State<>& at_start, const Five& five)
{
  const State<Fifty> now = widened(at_start);
  const auto& [o, e, th] = five.acceleration;
  const Fifty G = 2 * Fifty(x.g), P = five.tension.P, Q = five.tension.Q;
  const Places<Fifty> dd = place_accelerations<Fifty>(x.a, x.b, now, {o, e, th});
  const Fifty I = dd.x / G + P * sin(now.at.eta), II = dd.y / G - 1 + P * cos(now.at.eta);
  const Fifty III = dd.x1 / G - Q * sin(now.at.theta), IV = dd.y1 / G - 1 + Q * cos(now.at.theta);
  const Fifty own = Fifty(x.M) * x.c * sin(now.at.omega), La = Fifty(x.L) * x.a;
  const Fifty inertia = Fifty(x.M) * (Fifty(x.kk) + Fifty(x.c) * x.c);
  const Fifty V = inertia * o / G + own
                  + La * (P * cos(now.at.omega - now.at.eta) - Q * cos(now.at.theta - now.at.omega));
  const Fifty size = 1 + abs(P) + abs(Q), most = abs(own) + La * size + inertia * abs(Fifty(o)) / G;
  return {(abs(I) + abs(II) + abs(III) + abs(IV)) / size, abs(V) / most};
}

CHECK_THAT("the five unknowns satisfy the five equations, and are those that the energies give")
{
  for(const Told& now : told_at(
          "", "a=1 b=0.5 c=0.3 k=0.4 L=3 M=1 g=5 omega=-60 eta=90 theta=-80 omega_rate=2 eta_rate=-5 t=1",
          "L=10 M=0.1 k=1 omega=10 eta=10 theta=-9 t=2",
          "L=10 M=0.1 k=0.1 c=0.01 a=10 b=0.1 omega=1e-7 eta=2e-7 theta=-3e-7 t=0.1",
          "c=0 L=0.01 k=9 eta_rate=5 omega_rate=-4 theta=0 t=3"))
  {
    const Five five = five_equations(given(), start());
    const Left left = left_over(given(), start(), five);
    CHECK(double(left.of_pans) == within(0, 1e-15, "the unknowns are rounded"));
    CHECK(double(left.of_beam) == within(0, 1e-15, "the same"));
    const State<Fifty> state = widened(start());
    const Angles<Fifty> to = accelerations(widened(given()), state);
    const Tensions<Fifty> pull = tensions(widened(given()), state);
    const double size = 1 + double(abs(to.omega) + abs(to.eta) + abs(to.theta));
    // of a light beam between heavy pans the moments nearly cancel
    const double heavy = 1 + L * a * a / (M * (k * k + c * c));
    const double room = 2e-14 * size * heavy;
    const Unit rate{"1/s²"};
    const char* const once = "one rounding, of fifty digits";
    CHECK(now.value("omega_dd", rate) == within_ulps(to.omega, 1, once));
    CHECK(now.value("eta_dd", rate) == within_ulps(to.eta, 1, once));
    CHECK(now.value("theta_dd", rate) == within_ulps(to.theta, 1, once));
    CHECK(now.value("P") == within_ulps(pull.P, 1, once));
    CHECK(now.value("Q") == within_ulps(pull.Q, 1, once));
    const char* const why = "some forty roundings";
    CHECK(now.exact("beam") == within_relative(to.omega, 1e-45, "the same again"));
    for(const char* const way : {"five equations", "three, (B)", "by the energies"})
      CHECK(now.method("beam", way) == within(to.omega, room, why));
  }
}

/*!
In the last setting the strings lie nearly in line with the beam: there the bracket of {{eq B}} is little more
than the beam's own inertia.
*/

CHECK_THAT("(A) and (B) are the five equations without their tensions")
{
  for(const Told& now : told_at(
          "", "a=1 b=0.5 c=0.3 k=0.4 L=3 M=1 g=5 omega=-60 eta=90 theta=-80 omega_rate=2 eta_rate=-5 t=1",
          "L=10 M=0.1 k=1 omega=80 eta=-10 theta=-9.9 omega_rate=3 t=0"))
  {
    const State<> s = start();
    const Fifty o = accelerations(widened(given()), widened(s)).omega, w = s.at.omega, G = 2 * g.fifty();
    const Fifty square = Fifty(s.rate.omega) * s.rate.omega, A = double(a), B = double(b);
    const Fifty u = w - s.at.eta, v = w - s.at.theta;
    const Fifty by_eta = (G * -sin(Fifty(s.at.eta)) + A * (o * sin(u) + square * cos(u))) / B;
    const Fifty by_theta = (G * -sin(Fifty(s.at.theta)) - A * (o * sin(v) + square * cos(v))) / B;
    const double size = 1 + double(abs(by_eta) + abs(by_theta) + abs(o));
    const double room = 2e-14 * size * (1 + L * a * a / (M * (k * k + c * c)));
    CHECK(now.value("eta_dd", Unit{"1/s²"}) == within(by_eta, room, "(A)"));
    CHECK(now.value("theta_dd", Unit{"1/s²"}) == within(by_theta, room, "(A)"));
    CHECK(beam_by_three(given(), s) == within(o, room, "(B)"));
  }
}

CHECK_THAT("the later state is that of twenty digits, and the slackest string that of GSL's motion")
{
  for(const Told& now : told_at("t=4", "L=10 M=0.1 k=1 omega=10 eta=10 theta=-9 t=2",
                                "g=5 b=2 eta=70 omega_rate=1 eta_rate=-2 t=3"))
  {
    const Balance<> x = numbers_of(given());
    const State<Fifty> there = oracle(x, start(), t);
    const char* const why = "the integrator's bound, and the growth of roundings in wild motions";
    const Unit speed{"1/s"};
    CHECK(now.value("omega_t", degrees) == within(there.at.omega, 2e-12, why));
    CHECK(now.value("eta_t", degrees) == within(there.at.eta, 2e-12, why));
    CHECK(now.value("theta_t", degrees) == within(there.at.theta, 2e-12, why));
    CHECK(now.value("omega_rate_t", speed) == within(there.rate.omega, 1e-11, why));
    CHECK(now.value("eta_rate_t", speed) == within(there.rate.eta, 1e-11, why));
    CHECK(now.value("theta_rate_t", speed) == within(there.rate.theta, 1e-11, why));
    State<> going = start();
    double slackest = infinity;
    for(int i = 0; i <= 1000; ++i)
    {
      const Five five = five_equations(given(), going);
      slackest = std::min({slackest, five.tension.P, five.tension.Q});
      going = by_gsl(x, going, t / 1000, 1e-14);
    }
    CHECK(now.value("slackest") == within(slackest, 1e-9, "GSL's tolerance, 1000 times"));
  }
}

CHECK_THAT("at the defaults the motion until t is GSL's, its energy stands, and the strings stay taut")
{
  for(const Told& now : told_at(""))
  {
    const Balance<> x = numbers_of(given());
    const State<> there = by_gsl(x, start(), t, 1e-14);
    CHECK(now.value("omega_t", degrees) == within(there.at.omega, 1e-9, "GSL's tolerance, grown"));
    CHECK(now.value("eta_t", degrees) == within(there.at.eta, 1e-9, "the same"));
    CHECK(now.value("theta_t", degrees) == within(there.at.theta, 1e-9, "the same"));
    const Unit speed{"1/s"};
    CHECK(now.value("omega_rate_t", speed) == within(there.rate.omega, 1e-9, "the same"));
    CHECK(now.value("eta_rate_t", speed) == within(there.rate.eta, 1e-9, "the same"));
    CHECK(now.value("theta_rate_t", speed) == within(there.rate.theta, 1e-9, "the same"));
    CHECK(later().energy_drift == within(0, 1e-13, "rounding"));
    CHECK(now.value("slackest") == between(0.01, 1, "no string is slack"));
    for(const auto& point : now.points("angles", 7))
    {
      const double time = point.at("t");
      const State<> then = time > 0 ? by_gsl(x, start(), time, 1e-14) : start();
      CHECK(point.value("omega") == within(then.at.omega / 1_deg, 1e-7, "GSL's tolerance, in degrees"));
      CHECK(point.value("eta") == within(then.at.eta / 1_deg, 1e-7, "the same"));
      CHECK(point.value("theta") == within(then.at.theta / 1_deg, 1e-7, "the same"));
    }
  }
}

CHECK_THAT(
    "where neighbouring motions part too far the program refuses, but not where the swings are small")
{
  for(const char* const within_it : {"t=12.75", "g=32 t=9.016", "omega=1 eta=2 theta=-1 t=50"})
    CHECK(!refused_at(within_it));
  for(const char* const beyond : {"t=12.775", "g=32 t=9.033", "t=50"})  // twice the g, the time by √2 less
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
Begin with both strings pulled up to 90°, the beam level. Does a string become slack, and is the motion told
then true?

answer: With `--omega 0 --eta 90 --theta -90` the strings begin without any pull. A little above, the pans
would fall freely; from exactly there the strings tighten at once, and the least pull is that of the start.
:::
*/

CHECK_THAT("with both strings pulled up to 90° the least pull is none, at the start")
{
  for(const Told& now : told_at("omega=0 eta=90 theta=-90 t=1"))
  {
    CHECK(now.value("P") == within(0, 1e-15, "cos 90° rounded"));
    CHECK(now.value("slackest") == within(0, 1e-15, "the same"));
  }
}
