#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "globe/asked.hpp"
#include "globe/ball.hpp"
#include "globe/oracle.hpp"
#include "globe/smooth.hpp"
#include "globe/time.hpp"

SECTION(globe, 19, "What goes uniformly")

using namespace globe;

/*!
## What Euler does

Case II is summed up, its time given by the angle itself, and the uniform progress ascribed to the wrong
point. This quite singular case, Euler says, has place under two conditions: that the distance $CG = c$ is
so small that $cc$ as good as vanishes against $kk$; and that the angular velocity impressed at the start,
when $CGA$ was vertical, is

$$ \zeta = \frac{\sqrt{8gc}}k{{entry velocity}} = \frac{2\sqrt{2gc}}k. \tag{1} $$

Then, if after the time $t$ the ball has turned through $ACS = \Phi$, there is by {{sec globe.17}}, because
$\omega = 90° - \frac12\Phi$,

$$ t\sqrt{2gc} = \frac{2cc}{3k}\sin^3\tfrac12\Phi{{entry cube}} - k\,l\tan(45° - \tfrac14\Phi), \tag{2} $$

$$ t\sqrt{2gc} = k\,l\tan(45° + \tfrac14\Phi) + \frac{2cc}{3k}\sin^3\tfrac12\Phi. \tag{3} $$

In this motion Φ grows continually, but reaches 180° only after an infinite time. While the ball is
turning so, it may at the same time go forward with any motion, in which the centre{{entry centre}} goes
uniformly in the horizontal direction, since $dx:dt = f$. The centre of gravity itself will not go in a
straight line for that; it climbs more and more, but never arrives at the height $a + c$. In our copy the
$t$ of {{eq 2}} and {{eq 3}} is lost.

::: margin
Today: {{eq 3}} has the inverse Gudermannian, $\ln\tan(\frac\pi4 + \frac14\Phi) =
\operatorname{artanh}\sin\frac12\Phi$.
:::

But $x$ is where $G$ is, not $C$. It is the centre of gravity that gains equal lengths in equal times,
because no force is horizontal ({{sec globe.10}}); and the centre of the ball has the velocity

$$ \frac{ds}{dt} = f + c\,\frac{d\Phi}{dt}\cos\Phi, \tag{A} $$

more than $f$ while $G$ is below it and less when $G$ is above. In {{sec globe.23}} Euler says so himself.
In Case II the two agree at 90°, and in the end, when the turning has died out: then all of the ball goes
uniformly.

The two logarithms are one, and both are bad near the top. There $45° - \frac14\Phi$ is a small difference,
and $\tan(45°+\frac14\Phi)$ grows so steeply that an ulp of Φ is much. With the $\psi$ that Φ lacks of
180° it is

$$ l\tan(45° + \tfrac14\Phi) = -l\tan\tfrac14\psi. \tag{B} $$

## The program

Euler's two forms, and that with ψ.
*/

template <class Real>
Real first_form(const Real& Phi, const Real& right)  // (2), its logarithm
{
  using std::log, std::tan;
  return -log(tan(right / 2 - Phi / 4));
}

template <class Real>
Real second_form(const Real& Phi, const Real& right)  // (3)
{
  using std::log, std::tan;
  return log(tan(right / 2 + Phi / 4));
}

template <class Real>
Real by_psi(const Real& psi)  // (B)
{
  using std::log, std::tan;
  return -log(tan(psi / 4));
}

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto f = real("f", 1, Unit{"ft/s"}, closed(-1e100, 1e100), "horizontal velocity of G");
const auto where = asked_place(120_deg);

Fifty from_top()  // ψ
{
  const Fifty psi = where.psi == 0 ? Fifty(exact::pi() - where.Phi.fifty()) : where.psi.fifty();
  require(where.psi > 0 || psi >= 1e-33, "Phi", "less than 180° by 1e-33 rad or more: nearer by --psi");
  return psi;
}

double by_euler(const Place<double>& there)  // (3), t√2gc, the logarithm as arsinh tan ½Φ
{
  return k * std::asinh(there.s / there.c) + 2 * c * (c / k) / 3 * there.s * there.s * there.s;
}

Fifty turning(const Place<Fifty>& there)  // dΦ/dt
{
  const Fifty c_ = c.fifty();
  return sqrt(2 * g.fifty() * c_ * smooth::velocity_squared<Fifty>(c_, k.fifty(), {1, 0}, there));
}

TELL
{
  require(c <= 100 * k, "c", "at most a hundred times k");
  require(k <= 1e40 * c, "c", "at least 1e-40 of k");
  const Fifty psi = from_top();
  require(psi >= Fifty("1e-300"), "psi", "at least 1e-300 rad");
  const double second = std::sqrt(2 * g) * std::sqrt(c);
  const Place<Fifty> there = where.fifty();
  const Place<double> place = rounded(there);
  const Fifty u = there.c * there.c - there.s * there.s, w = turning(there), ahead = c.fifty() * w * u;
  tell("zeta", 2 * second / k, Unit{"1/s"}, "ζ, the velocity of (1)");
  tell("t", smooth::time<double>(c, k, {1, 0}, place) / second, seconds, "the time to Φ, exactly");
  tell("t_euler", by_euler(place) / second, seconds, "by (3)");
  tell("w", double(w), Unit{"1/s"}, "the angular velocity there");
  tell("ahead", double(ahead), Unit{"ft/s"}, "what C is quicker than G, c cos Φ dΦ/dt");
  tell("v", double(f.fifty() + ahead), Unit{"ft/s"}, "the velocity of C, (A)");
  tell("below", double(2 * c.fifty() * there.c * there.c), feet, "what G lacks of the height a + c");
}

TELL
{
  curve("velocities", {"t", "v", "f"}, [](Curve& velocities) {
    const double second = std::sqrt(2 * g) * std::sqrt(c), end = separatrix_time<double>(c, k, 1_deg);
    for(int n = 0; n <= 160; ++n)
    {
      const double omega = separatrix_angle(c, k, n * end / 160);
      const double w =
          std::sqrt(smooth::velocity_squared<double>(c, k, {1, 0}, place_from_top(2 * omega))) * second;
      velocities.put({n * end / 160 / second, f - c * w * std::cos(2 * omega), double(f)});
    }
  });
}

/*!
At 120° our ball still turns with {{w|4}} radians a second, and $C$, which Euler has go with $f$, goes at
{{v|4}} feet a second, differing by {{ahead|4}}. $G$ lacks {{below|3}} feet of the height $a + c$.

::: figure globe-19
alt: Velocity against time. That of the ball's centre starts well above the horizontal line of the centre
of gravity, falls through it, stays somewhat below for a while, and comes up to it from below in the end.

The velocity of $C$ (blue) and that of $G$ (ink) in Case II, until two degrees are lacking of the top. It
is $G$ that goes uniformly.
:::

## Speed against error

The same logarithm in five forms, three by Φ and two by ψ. Ask for `--psi 1e-12rad`.
*/

TELL
{
  const double right = std::numbers::pi / 2, psi = double(from_top()), Phi = double(where.angle());
  const Place<Fifty> there = where.fifty();
  if(Phi == 0)
    return;  // there is no time to compare
  race("logarithm", "the logarithm of (3)", asinh(Fifty(there.s / there.c)),
       {{"−l tan(45° − Φ:4)", [=] { return first_form(Phi, right); }},
        {"l tan(45° + Φ:4)", [=] { return second_form(Phi, right); }},
        {"artanh sin ½Φ", [=] { return std::atanh(std::sin(Phi / 2)); }},
        {"−l tan ¼ψ", [=] { return by_psi(psi); }},
        {"arsinh cot ½ψ", [=] { return std::asinh(1 / std::tan(psi / 2)); }}});
}

/*!
## Checks

The equations of {{sec globe.06}} and {{sec globe.07}} bring the ball to the angle asked for, and tell how
fast its centre then goes.
*/

CHECK_THAT("the velocities told are those of the motion, and only that of G has not changed")
{
  const Unit speed{"ft/s"};
  for(const Told& now : told_at("", "Phi=30 c=0.5 f=-2", "psi=0.02 k=0.4 g=1 f=0.1"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), second = sqrt(2 * g_ * c_), f_ = f.fifty();
    const Ball<Fifty> ball{c_ + k_, c_, k_};
    const auto motion = [&](const Fifty&, const exact::State& s) {  // x, x', y, y', Φ, Φ'
      const auto moved = accelerations<Fifty>(ball, g_, s[4], s[5], 0);
      return exact::State{s[1], moved.x, s[3], moved.y, s[5], moved.Phi};
    };
    const Fifty t = oracle::smooth_time(c_, k_, {1, 0}, where.fifty()) / second;
    const exact::State s = exact::solve(motion, 0, {0, f_, ball.a - c_, 0, 0, 2 * second / k_}, t).y;
    CHECK(s[4] == within(where.angle(), 1e-24, "some hundred steps of 1e-32, grown near the top"));
    CHECK(s[1] == within(f_, 1e-40, "G has not changed its velocity"));
    CHECK(now.value("w", Unit{"1/s"}) == within_ulps(s[5], 1, "rounded once"));
    CHECK(now.value("ahead", speed) == within_ulps(c_ * s[5] * cos(s[4]), 1, "rounded once"));
    CHECK(now.value("v", speed) == within_ulps(f_ + c_ * s[5] * cos(s[4]), 1, "s = x + c sin Φ"));
    CHECK(now.value("below", feet) == within_relative(ball.a + c_ - s[2], 1e-15, "a + c − y"));
    CHECK(now.value("t", seconds) == within_relative(t, 4e-15, "the library's ten ulps, and an ulp of ω"));
  }
}

Fifty euler(const Fifty& Phi)  // (2), as it stands there
{
  const Fifty c_ = c.fifty(), k_ = k.fifty(), right = exact::pi() / 2;
  return 2 * c_ * c_ / (3 * k_) * pow(sin(Phi / 2), 3) - k_ * log(tan(right / 2 - Phi / 4));
}

CHECK_THAT("the numbers told are (1), (3), (A), at every scale and however near the top")
{
  const Unit speed{"ft/s"};
  for(const Told& now : told_at("", "psi=1e-12rad f=0", "psi=1e-40rad c=2", "Phi=1 c=1e-12 f=1e20",
                                "Phi=1e-10 c=90 k=1 g=1e-90"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), second = sqrt(2 * g_ * c_);
    const Fifty psi = where.psi == 0 ? Fifty(exact::pi() - where.angle()) : where.psi.fifty();
    const Fifty s = sin(psi), D = k_ * k_ + c_ * c_ * s * s, w = 2 * second * sin(psi / 2) / sqrt(D);
    CHECK(now.value("zeta", Unit{"1/s"}) == within_relative(2 * second / k_, 1e-15, "four roundings"));
    CHECK(now.value("w", Unit{"1/s"}) == within_relative(w, 2e-16, "rounded once"));
    CHECK(now.value("ahead", speed)
          == within(-c_ * w * cos(psi), 2e-16 * double(c_ * w * abs(cos(psi))) + 1e-45 * double(c_ * w),
                    "rounded once; the cosine of 90° is not nothing to fifty digits"));
    CHECK(now.value("v", speed) == within_relative(f.fifty() - c_ * w * cos(psi), 2e-16, "rounded once"));
    CHECK(now.value("below", feet)
          == within_relative(2 * c_ * pow(sin(psi / 2), 2), 2e-16, "rounded once"));
    CHECK(now.value("t", seconds)
          == within_relative(oracle::smooth_time(c_, k_, {1, 0}, {cos(psi / 2), sin(psi / 2)}) / second,
                             4e-15, "the library's eight ulps and a root"));
    const Fifty five = 2 * c_ * c_ / (3 * k_) * pow(cos(psi / 2), 3) - k_ * log(tan(psi / 4));
    CHECK(now.value("t_euler", seconds) == within_relative(five / second, 2e-15, "some roundings"));
    if(psi > 1e-5)
      CHECK(five == within_relative(euler(exact::pi() - psi), 1e-40, "(2) with Φ"));
  }
}

CHECK_THAT("it refuses a c beyond 1e-40 or a hundred times k, and a place too near the top for its digits")
{
  for(const char* const within_them : {"c=100 k=1", "c=200 k=2", "c=1 k=1e40", "c=2 k=2e40",
                                       "psi=1e-300rad", "Phi=179.9999999999999999999999999999999427"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"c=100.00000000000001 k=1", "c=200.00000000000003 k=2", "c=0.9999999999999999 k=1e40",
       "c=1.9999999999999998 k=2e40", "psi=9.999999999999999e-301rad",
       "Phi=179.9999999999999999999999999999999428", "Phi=180"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("(2) and (3) are the same, and (B); in the race each way is as good as its angle")
{
  for(const Told& now : told_at("", "psi=1e-6rad", "Phi=10"))
  {
    const Fifty right = exact::pi() / 2, Phi = where.angle(), psi = 2 * right - Phi;
    const Fifty value = 2 * atanh(tan(Phi / 4));
    CHECK(first_form<Fifty>(Phi, right)
          == within_relative(value, 1e-38, "fifty digits, some lost near the top"));
    CHECK(second_form<Fifty>(Phi, right) == within_relative(value, 1e-38, "the same"));
    CHECK(by_psi<Fifty>(psi) == within_relative(value, 1e-38, "the same"));
    CHECK(now.exact("logarithm") == within_relative(value, 1e-38, "the same"));
    // An ulp of Φ, and of 45° + Φ:4, over what it lacks; near 45° the logarithm of nearly 1 loses the same.
    const double rough = 1e-15 / double(psi) + 1e-15;
    CHECK(now.method("logarithm", "−l tan(45° − Φ:4)") == within(value, rough, "an ulp of Φ near the top"));
    CHECK(now.method("logarithm", "l tan(45° + Φ:4)") == within(value, rough, "an ulp of Φ near the top"));
    const double square = 1e-15 / double(psi * psi) + 1e-15;
    CHECK(now.method("logarithm", "artanh sin ½Φ") == within(value, square, "an ulp of 1, over ψψ:8"));
    CHECK(now.method("logarithm", "−l tan ¼ψ") == within(value, 1e-15 * double(1 + value), "a few ulps"));
    CHECK(now.method("logarithm", "arsinh cot ½ψ")
          == within(value, 1e-15 * double(1 + value), "a few ulps"));
  }
}

CHECK_THAT("at ψ = 1e-12 the forms by Φ have lost more than half of their digits, those by ψ none")
{
  const double right = std::numbers::pi / 2, Phi = std::numbers::pi - 1e-12;
  const Fifty value = asinh(1 / tan(Fifty(1e-12) / 2));
  CHECK(abs(first_form(Phi, right) - value) > 1e-6);
  CHECK(abs(second_form(Phi, right) - value) > 1e-6);
  CHECK(by_psi(1e-12) == within_ulps(value, 2, "a tangent and a logarithm"));
}

CHECK_THAT("the velocities drawn are those of the motion at those times")
{
  for(const Told& now : told_at("", "c=0.4 f=-1"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), second = sqrt(2 * g_ * c_);
    const Ball<Fifty> ball{c_ + k_, c_, k_};
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1], accelerations<Fifty>(ball, g_, s[0], s[1], 0).Phi};
    };
    for(const auto& point : now.points("velocities", 5))
    {
      const Fifty t = point.at("t");
      const exact::State s =
          t == 0 ? exact::State{0, 2 * second / k_} : exact::solve(motion, 0, {0, 2 * second / k_}, t).y;
      CHECK(point.value("v")
            == within(f.fifty() + c_ * s[1] * cos(s[0]), 4e-14 * double(1 + c_ * s[1]),
                      "twenty ulps of the time"));
      CHECK(point.value("f") == within_relative(f.fifty(), 1e-16, "it is f"));
      CHECK(point.value("t") == between(0, 10, "until two degrees before the top"));
    }
  }
}

/*!
Now the readings. Which point goes uniformly is judged by the path of our ball: its centre's velocity at
60°, with $f = 1$, is found by differences of the way $s$ that the equations of motion give.
*/

Place<Fifty> sixty()
{
  return globe::place(Fifty(exact::pi() / 3));
}

Fifty second()
{
  return sqrt(2 * our_g<Fifty> * our_ball<Fifty>.c);
}

Fifty time_to_sixty()
{
  return oracle::smooth_time(our_ball<Fifty>.c, our_ball<Fifty>.k, {1, 0}, sixty()) / second();
}

Fifty w_at_sixty()
{
  return second()
         * sqrt(smooth::velocity_squared<Fifty>(our_ball<Fifty>.c, our_ball<Fifty>.k, {1, 0}, sixty()));
}

Fifty way(const Fifty& t)  // s = x + c sin Φ, with f = 1
{
  const Fifty zeta = sqrt(8 * our_g<Fifty> * our_ball<Fifty>.c) / our_ball<Fifty>.k;
  const auto motion = [](const Fifty&, const exact::State& s) {
    const auto moved = accelerations<Fifty>(our_ball<Fifty>, our_g<Fifty>, s[2], s[3], 0);
    return exact::State{s[1], moved.x, s[3], moved.Phi};
  };
  const exact::State s = exact::solve(motion, 0, {0, 1, 0, zeta}, t).y;
  return s[0] + our_ball<Fifty>.c * sin(s[2]);
}

const Erratum centre{
    "§19, what goes uniformly",
    {"the centre C of the ball", 1},
    {"its centre of gravity, C going with f + c cos Φ dΦ/dt", double(1 + 0.05 * w_at_sixty())},
    "that is the velocity with which the way s grows, and x, which grows as ft, is that of G",
    [](double reading) {
      const Fifty t = time_to_sixty(), step("1e-9");
      return reading
             == within((way(t + step) - way(t - step)) / (2 * step), 1e-12,
                       "the square of the step, and a third derivative below 1e3");
    }};

const Emendation velocity{"§19, the second condition",
                          {"ν2gc : k", std::sqrt(2.)},
                          {"√(8gc) : k", std::sqrt(8.)},
                          "it is twice √2gc : k, and with that h is 1",
                          [](double root) {  // ζk:√gc; (3) of §16
                            const Fifty zeta = root, h = zeta * abs(zeta) / 8;
                            return h == within(1, 1e-15, "two roundings of the root");
                          }};

const double third = 0.01 / 0.6 * 2 / 3, sine = std::sin(60_deg), logarithm = 0.6 * std::atanh(sine);

const Emendation cube{"§19, the time, both lines",
                      {"cc/2k sin² ½Φ", third * 0.75 * sine* sine + logarithm},
                      {"2cc/3k sin³ ½Φ", third* sine* sine* sine + logarithm},
                      "§17, in the only way that the motion bears; at 120°",
                      [](double reading) {
                        const Fifty c_ = our_ball<Fifty>.c, k_ = our_ball<Fifty>.k, w = exact::pi() / 6;
                        const Fifty lowest = reading + separatrix_next_term(c_, k_, w);
                        return oracle::smooth_time(c_, k_, {1, 0}, {cos(w), sin(w)})
                               == between(lowest, reading, "the next term is the bound");
                      }};

/*!
## Go on from here

::: exercise
The centre begins to lose against $G$ at 90°. Does it lose on the whole?
answer: The way of $C$ is $s = ft + c\sin\Phi$. At 90° it is $c$ ahead of the uniform progress, and in the
end, where Φ is 180°, level with it: what was gained is lost again, no more and no less.
:::
*/

CHECK_THAT("what C gained on the first half of its climb it loses on the second")
{
  const Fifty t = 16 * time_to_sixty();
  const Fifty half = separatrix_time(our_ball<Fifty>.c, our_ball<Fifty>.k, Fifty(exact::pi() / 4))
                     / sqrt(2 * our_g<Fifty> * our_ball<Fifty>.c);
  CHECK(way(half) - half == within(our_ball<Fifty>.c, 1e-28, "c ahead at 90°"));
  CHECK(way(t) - t == between(0, 1e-4, "hardly ahead near the top"));
}
