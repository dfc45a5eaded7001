#include "balance/instrument.hpp"
#include "balance/motion.hpp"
#include "edition/section.hpp"

SECTION(balance, 9, "What turns the beam")

using namespace balance;

/*!
## What Euler does

The beam only turns, and so a single equation decides its motion: that of the moments which tend to increase
the angle $pCA{{entry angle_at_C}} = \omega$. There are three of them.

First its own weight $M$, which may be thought collected in $G$. It works to lessen ω, with the moment

$$ -Mc\sin\omega. \tag{1} $$

Then the tension of the string $AP$, which draws the end $A$ down and lessens ω too. The angle at which it
works is found at the vertical through $A$: since $CA\alpha = 90° - \omega$ and $PA\alpha = \eta$, the whole
angle is $CAP{{entry angle_at_A}} = 90° - \omega + \eta$. Its sine is $\cos(\omega-\eta)$, and the moment

$$ -Pa\cos(\omega - \eta). \tag{2} $$

Last the string $BQ$. There $CB\beta = 90° + \omega$ and $QB\beta = \vartheta$, therefore
$CBQ = 90° + \omega - \vartheta$. Drawing $B$ down it increases ω, by

$$ +Qa\cos(\vartheta - \omega). \tag{3} $$

The sum, divided by the moment of inertia $M(kk+cc)$, is the acceleration of the angle:

$$ \begin{gathered} \text{V.}\quad \frac{dd\omega}{2g\,dt^2{{entry two_g}}}
   = \frac N{M(kk+cc)}{{entry minus_before_all}},\\
  \begin{aligned} N = {}&{-Mc}\sin\omega{{entry sine_of_omega}} - Pa\cos(\omega-\eta)\\
   &+ Qa\cos(\vartheta-\omega). \end{aligned} \end{gathered} \tag{4} $$

These five equations, he concludes, contain the whole solution of the problem.

::: margin
Torque is $\sum\mathbf F\cdot\partial\mathbf r/\partial\omega$: the pull's part along the way that the end of
the beam would go.
:::

The pans are in it only by their pulls. While they hang at rest the two pulls are equal and balance each
other; what they do to the beam is the small difference of two great moments. Along a swing that difference
follows the beam: as long as $A$ is high it is accelerated downward, and P, which goes with it, pulls with
less than its weight, Q with more; when $A$ is low it is the other way. So the pans do, to the first order,
just what weights fixed to $A$ and $B$ would do ({{sec balance.14}}).

## The program

Again the tensions are taken from the equations without tensions. Put into V they must give back the
acceleration of the beam that they were computed with. Of a light beam between heavy pans that is what the
two great moments leave; so they are reckoned in fifty digits.
*/

const auto a = real("a", 16. / 9, feet, closed(1e-2, 1e2), "CA = CB, half the beam");
const auto b = real("b", 32. / 9, feet, closed(1e-2, 1e2), "AP = BQ, the strings");
const auto c = real("c", 8. / 81, feet, closed(0, 1e2), "CG, depth of the beam's centre of gravity");
const auto k = real("k", 1.2532, feet, closed(1e-2, 1e2), "the beam's radius of gyration about G");
const auto L = real("L", 1, none, closed(1e-3, 1e3), "weight of each pan");
const auto M = real("M", 4, none, closed(1e-3, 1e3), "weight of the beam");
const auto g = real("g", 16, feet, closed(1e-2, 1e2), "height fallen in the first second");
const auto omega = angle("omega", 10_deg, closed(-90_deg, 90_deg), "inclination ω of the beam");
const auto eta = angle("eta", 20_deg, closed(-180_deg, 180_deg), "inclination η of the string AP");
const auto theta = angle("theta", 5_deg, closed(-180_deg, 180_deg), "inclination ϑ of the string BQ");
const auto omega_rate = real("omega_rate", 0.1, Unit{"1/s"}, closed(-1e2, 1e2), "dω/dt");
const auto eta_rate = real("eta_rate", -0.3, Unit{"1/s"}, closed(-1e2, 1e2), "dη/dt");
const auto theta_rate = real("theta_rate", 0.2, Unit{"1/s"}, closed(-1e2, 1e2), "dϑ/dt");

const auto given = [] { return Instrument{a, b, c, k * k, L, M, g}; };
const auto now_at = [] { return State<>{{omega, eta, theta}, {omega_rate, eta_rate, theta_rate}}; };

struct Moments
{
  Fifty weight, P, Q;  // (1), (2), (3)

  Fifty all() const { return weight + P + Q; }
};

Moments moments(const Instrument& x, const State<>& now)
{
  const auto [at, rate] = widened(now);
  const Tensions<Fifty> pull = tensions(widened(x), {at, rate});
  return {-Fifty(x.M) * x.c * sin(at.omega),                      // (1)
          -x.L * pull.P * x.a * cos(at.omega - at.eta),           // (2)
          Fifty(x.L * pull.Q) * x.a * cos(at.theta - at.omega)};  // (3)
}

double acceleration(const Instrument& x, const Moments& by)  // (4)
{
  return double(2 * Fifty(x.g) * by.all() / (Fifty(x.M) * (Fifty(x.kk) + Fifty(x.c) * x.c)));
}

TELL
{
  const Unit moment{"ft"};
  const Moments by = moments(given(), now_at());
  tell("weight", double(by.weight), moment, "moment of the beam's weight, (1)", 14);
  tell("by_P", double(by.P), moment, "of the string AP, (2)", 14);
  tell("by_Q", double(by.Q), moment, "of the string BQ, (3)", 14);
  tell("omega_dd", acceleration(given(), by), Unit{"1/s²"}, "ddω/dt² by V", 14);
  tell("CAP", 90_deg - omega + eta, degrees, "angle of the string AP with the beam", 13);
  tell("CBQ", 90_deg + omega - theta, degrees, "of the string BQ", 13);
}

TELL
{
  curve("moments", {"lambda_t", "weight", "strings", "all"}, [](Curve& out) {
    const Balance<> example = numbers_of(instrument_of_35);
    int degree = 0;
    for(const State<>& now : course(example, released(10_deg, 10_deg, 10_deg), 2 * std::numbers::pi, 360))
    {
      const Moments by = moments(instrument_of_35, now);
      out.put({double(degree++), double(by.weight), double(by.P + by.Q), double(by.all())});
    }
  });
}

/*!
In the attitude given the strings pull at the beam with {{by_P|4}} and {{by_Q|4}} (a weight at an arm of a
foot is the unit), its own weight with {{weight|3}}; the beam is accelerated by {{omega_dd|4}} radians per
second in the second.

::: figure balance-09
alt: Three curves over one swing of the beam. The moment of the weight begins at about minus 0.07 and swings
once to plus 0.07 and back. The strings' moment has the other sign and about half the size, with small
ripples. The sum lies between them.

The moments on the beam of {{sec balance.35}}, all three let go at 10°. The strings' two moments, of which
each is near $La$, leave a difference that works against the beam's own weight: the pans make the beam
sluggish.
:::

## Checks

The moments are formed anew from the forces. A pan of the weight $L$ that moves with the acceleration $\mathbf
b$ is held by the force $L(\mathbf b/2g - \mathbf e)$, $\mathbf e$ pointing down; the opposite force works on
the end of the beam, which a growing ω leads upward, or downward, at a right angle to its arm.
*/

struct Exactly
{
  Fifty weight, P, Q;
};

Exactly by_forces()
{
  const State<Fifty> now = widened(now_at());
  const Fifty A = double(a), B = double(b), G = 2 * Fifty(double(g)), W = double(L);
  const auto of = place_accelerations<Fifty>(A, B, now, accelerations(widened(given()), now));
  const Fifty so = sin(now.at.omega), co = cos(now.at.omega);
  // force on A: outward and downward; way of A: inward and upward
  const Fifty out = -W * of.x / G, down = W * (1 - of.y / G);
  const Fifty out1 = -W * of.x1 / G, down1 = W * (1 - of.y1 / G);
  return {-Fifty(double(M)) * double(c) * so, -A * (out * so + down * co), -A * (out1 * so - down1 * co)};
}

CHECK_THAT("the moments told are those of the forces on the ends of the beam, and V gives its acceleration")
{
  for(const Told& now : told_at(
          "", "a=1 b=0.5 c=0.3 k=0.4 L=3 M=1 g=4.9 omega=-60 eta=100 theta=-130 omega_rate=2 eta_rate=-9",
          "c=0 L=1e-3 k=90 eta_rate=30 omega_rate=-4",
          "a=100 b=0.01 c=0 k=0.01 L=1000 M=0.001 g=100 omega_rate=100 eta_rate=-100 theta_rate=100",
          "L=1e3 M=1e-2 omega=1e-9 eta=-1e-9 theta=0"))
  {
    const Exactly by = by_forces();
    const Unit moment{"ft"};
    const char* const why = "one rounding, of fifty digits";
    CHECK(now.value("weight", moment) == within_ulps(by.weight, 1, why));
    CHECK(now.value("by_P", moment) == within_ulps(by.P, 1, why));
    CHECK(now.value("by_Q", moment) == within_ulps(by.Q, 1, why));
    const Fifty beam = accelerations(widened(given()), widened(now_at())).omega;
    CHECK(now.value("omega_dd", Unit{"1/s²"}) == within_ulps(beam, 1, why));
  }
}

/*!
The angles between beam and strings are taken from the places of the points.
*/

CHECK_THAT("CAP and CBQ are the angles between the lines from A to C and P, and from B to C and Q")
{
  for(const Told& now : told_at("", "omega=-60 eta=40 theta=-30", "omega=90 eta=180 theta=-90 a=1 b=9"))
  {
    const Fifty A = a.fifty(), B = b.fifty(), so = sin(omega.fifty()), co = cos(omega.fifty());
    const auto [x, y, x1, y1] = places<Fifty>(A, B, {omega.fifty(), eta.fifty(), theta.fifty()});
    const Fifty px = x - A * co, py = y + A * so, qx = x1 - A * co, qy = y1 - A * so;  // from A, from B
    const auto angle = [](const Fifty& sine,
                          const Fifty& cosine) {  // from the string to the beam, turning on
      const Fifty found = atan2(sine, cosine);
      return found < -exact::pi() / 4 ? Fifty(found + 2 * exact::pi()) : found;
    };
    const Fifty P = angle(px * so + py * co, -px * co + py * so),
                Q = angle(-qx * so + qy * co, -qx * co - qy * so);
    CHECK(now.value("CAP", degrees) == within(P, 1e-15, "two sums"));
    CHECK(now.value("CBQ", degrees) == within(Q, 1e-15, "the same"));
  }
}

CHECK_THAT("the moments in the figure are those of the motion that GSL finds, and act against each other")
{
  const Balance<> example = numbers_of(instrument_of_35);
  const State<> start = released(10_deg, 10_deg, 10_deg);
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("moments", 8))
    {
      const double time = point.at("lambda_t") * 1_deg;
      const State<> there = time > 0 ? by_gsl(example, start, time, 1e-13) : start;
      const Instrument& x = instrument_of_35;
      const double weight = -x.M * x.c * std::sin(there.at.omega);
      const double all = x.M * (x.kk + x.c * x.c) * accelerations(example, there).omega / (2 * x.g);
      CHECK(point.value("weight") == within(weight, 1e-11, "GSL's tolerance"));
      CHECK(point.value("all") == within(all, 1e-10, "the same"));
      CHECK(point.value("strings") == within(all - weight, 1e-10, "the same"));
      if(std::abs(weight) > 0.02)
        CHECK(point.value("strings")
              == within(-0.5 * weight, 0.4 * std::abs(weight), "2Laa : I, and ripples"));
    }
}

/*!
Our copy has the last equation wrong in several places and two angles by wrong names. The sine of η for that
of ω stands in it twice, in the sum of the moments and in V, and it may have stood in the print; but the text
just before has ω. The divisor has $g$ for $2g$, which the others have. And the minus of the first term has
come to stand before the whole fraction, as it does again in {{sec balance.12}}. For β at the end of the
vertical through $B$ our copy has δ.
*/

constexpr State<> somewhere{{0.1, -0.12, 0.08}, {0.3, -0.2, 0.4}};

double by_five(double sine_of, double factor, bool minus_before_all)  // ddω/dt² by V in that state
{
  const Instrument& x = instrument_of_35;
  const Moments by = moments(x, somewhere);
  const double weight = x.M * x.c * std::sin(sine_of), strings = double(by.P + by.Q);
  return factor * x.g * (minus_before_all ? -(weight + strings) : strings - weight)
         / (x.M * (x.kk + x.c * x.c));
}

bool is_true_acceleration(double reading)
{
  const Fifty beam = accelerations(widened(instrument_of_35), widened(somewhere)).omega;
  return reading == within(beam, 1e-13, "forty roundings");
}

const Emendation sine_of_omega{"§9, the moments added up, and again V",
                               {"− Mc sin η", [] { return by_five(-0.12, 2, false); }},
                               {"− Mc sin ω", [] { return by_five(0.1, 2, false); }},
                               "the text before has ω; only so does V agree with the energies",
                               is_true_acceleration};

const Emendation two_g{"§9, V, the divisor of ddω",
                       {"g dt²", [] { return by_five(0.1, 1, false); }},
                       {"2g dt²", [] { return by_five(0.1, 2, false); }},
                       "the others have 2g; only so does V agree with the energies",
                       is_true_acceleration};

const Emendation minus_before_all{"§9, V, the minus",
                                  {"before the whole fraction", [] { return by_five(0.1, 2, true); }},
                                  {"before Mc sin ω alone", [] { return by_five(0.1, 2, false); }},
                                  "only so does V agree with the energies, and with the sum before it",
                                  is_true_acceleration};

const Emendation angle_at_C{"§9, the angle that is to increase",
                            {"PCA",
                             [] {
                               const auto [x, y, x1, y1] = places<double>(2, 3, {0.2, 0.3, 0.4});
                               return std::atan2(y, x) + 0.2;
                             }},
                            {"pCA", 0.2},
                            "for a beam lifted by a fifth of the radius it is that fifth (§3)",
                            [](double angle) { return angle == within(0.2, 1e-15, "an angle"); }};

const Emendation angle_at_A{
    "§9, the angle that is 90° − ω + η",
    {"CAα, once more", [] { return 90_deg - 0.2; }},
    {"CAP", [] { return 90_deg - 0.2 + 0.3; }},
    "its sine is said to be the cosine of ω − η, and it is not less than a right angle here",
    [](double angle) {
      return std::sin(angle) == within(cos(Fifty(0.2) - Fifty(0.3)), 1e-15, "a sine")
             && angle == between(90_deg, 180_deg, "η is greater than ω");
    }};

/*!
## Go on from here

::: exercise
Beam and both strings are inclined by the same angle, however great, and let go. How does the beam begin to
move?
answer: As the simple pendulum of the length $f = (M(kk+cc)+2Laa):Mc$ would from that angle, exactly. The
strings stand at right angles to the beam, so that the pans go along with $A$ and $B$ as if they were fixed to
them.
:::
*/

CHECK_THAT(
    "let go with strings at right angles to it, the beam begins as the pendulum f does, at any angle")
{
  for(const Told& now : told_at("omega=10 eta=10 theta=10 omega_rate=0 eta_rate=0 theta_rate=0",
                                "omega=60 eta=60 theta=60 omega_rate=0 eta_rate=0 theta_rate=0 L=9 b=0.5"))
  {
    const Fifty I =
        M.fifty() * (k.fifty() * k.fifty() + c.fifty() * c.fifty()) + 2 * L.fifty() * a.fifty() * a.fifty();
    CHECK(now.value("omega_dd", Unit{"1/s²"})
          == within_relative(-2 * g.fifty() * M.fifty() * c.fifty() / I * sin(omega.fifty()), 1e-13,
                             "the options' rounding"));
  }
}
