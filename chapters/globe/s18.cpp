#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "globe/ball.hpp"
#include "globe/gauss.hpp"
#include "globe/time.hpp"

SECTION(globe, 18, "The ball that never quite turns over")

using globe::separatrix_time;

/*!
## What Euler does

With just the velocity that the top asks for, the ball approaches the top for ever; Euler says why, and works
out when it has turned through a right angle. The plane is smooth. In {{sec globe.16}} the ball was started
with its centre of gravity $G$ straight below its centre $C$, and with one particular angular velocity
$\zeta$, that for which $\zeta\zeta kk = 8gc$; and since the distance $CG = c$ was very small, {{sec globe.17}} could
integrate. With $\Phi$ for the angle through which the ball has turned, and $\omega = 90° - \tfrac12\Phi$, the
time was

$$ t\sqrt{2gc} = \frac{2cc}{3k}\cos^3\omega - k\,l\tan\tfrac12\omega. \tag{1} $$

Now he asks what this says. At the start $\omega$ is $90°$; as $\Phi$ grows it shrinks. It cannot become
negative, for then the tangent would be negative and its logarithm imaginary; and it cannot even become zero,
that is, $\Phi$ cannot become $180°$, because the time for that is infinite. So the ball never turns so far
that $G$ stands straight above $C$. It only comes ever nearer to it.

As an example he asks how long $G$ takes to rise through a right angle. Then $\Phi = 90°$, $\omega = 45°$, and
the tangent of $\tfrac12\omega = 22°\,30'$ is $\sqrt{(\sqrt2-1)/(\sqrt2+1)} = \sqrt2-1$, so that

$$ t\sqrt{2gc} = \frac{cc}{3k\sqrt2} + k\,l\,(1+\sqrt2). \tag{2} $$

::: margin
Today: $2g$ is the acceleration of gravity, $k$ the radius of gyration about $G$, $l$ the natural logarithm.
This motion is the *separatrix* between rocking and turning over.
:::

What the scan shows in place of {{eq 1}} and {{eq 2}} is something else; *Checks* has the readings, and why we
read as above.

### How near to the truth

To get {{eq 1}} Euler replaced $\sqrt{kk+cc\sin^2\Phi}$ by $k + cc\sin^2\Phi/2k$. There is no need to. Put
$v = \sin\tfrac12\Phi = \cos\omega$ in the integral of {{sec globe.13}}, with his $\zeta$, and split off what
becomes infinite:

$$ t\sqrt{2gc} = \int_0^{\cos\omega}\!\frac{\sqrt{kk+4cc\,vv(1-vv)}}{1-vv}\,dv \tag{3} $$

$$ = k\,l\cot\tfrac12\omega
 + \int_0^{\cos\omega}\!\frac{4cc\,vv\;dv}{k+\sqrt{kk+4cc\,vv(1-vv)}}. \tag{4} $$

The first term is Euler's logarithm, unaltered; the integral stays finite up to the top. So his conclusion
does not hang on a small $c$: the time to the top is infinite for every ball. And where the root is replaced
by its least value $k$, {{eq 4}} becomes {{eq 1}}: his time is always a little too long. The next term of the
expansion,

$$ -\frac{2c^4}{k^3}\left(\frac{\cos^5\omega}{5} - \frac{\cos^7\omega}{7}\right), \tag{5} $$

takes away too much, since $\sqrt{1+x}$ lies between $1+\frac12x-\frac18xx$ and $1+\frac12x$. The truth is in
between.

## The program

The logarithm is taken as an inverse hyperbolic sine,
$-l\tan\tfrac12\omega = \operatorname{arsinh}\cot\omega$, which keeps its digits at the start of the motion
too.
*/

template <class Real>
Real logarithm(const Real& k, const Real& omega)  // −k l tan ½ω
{
  using std::asinh, std::tan;
  return k * asinh(1 / tan(omega));
}

template <class Real>
Real by_euler(const Real& c, const Real& k, const Real& omega)  // (1)
{
  using std::cos;
  const Real v = cos(omega);
  return 2 * c * (c / k) / 3 * v * v * v + logarithm(k, omega);
}

template <class Real>
Real next_term(const Real& c, const Real& k, const Real& omega)  // (5)
{
  using std::cos;
  const Real v = cos(omega), r = c / k;
  return -2 * c * r * r * r * v * v * v * v * v * (1 / Real(5) - v * v / 7);
}

/*!
Euler says in {{sec globe.13}} that the integral cannot be had in general. At this one velocity it can. It is
elliptic, and in Carlson's symmetric integrals all that is infinite at the top again stands in one elementary
term:

$$ t\sqrt{2gc} = k\operatorname{arsinh}\frac{\cot\omega}{\sqrt q} + \frac{4cc}{3k}\,R\cos^3\omega, \tag{6} $$

where $q = 1 + (4cc/kk)\cos^2\omega$ and $R = R_J(1,X,Z,q) + R_D(X,Z,1)$ stays bounded. With $v = \cos\omega$:

::: code globe/time.cpp time
:::

The integrands of {{eq 3}} and {{eq 4}} are for the comparison of quadratures.
*/

double root(double c, double k, double v) { return std::hypot(k, 2 * c * v * std::sqrt((1 - v) * (1 + v))); }
double whole(double c, double k, double v) { return root(c, k, v) / ((1 - v) * (1 + v)); }  // (3)
double rest(double c, double k, double v) { return 4 * c * v * v * (c / (k + root(c, k, v))); }  // (4)

/*!
Euler gives no numbers. Ours are a homogeneous ball of weight 4/5 and radius 1 foot with a pellet of weight
1/5 set in halfway between centre and surface, for which $c = \tfrac1{10}$ and $kk = \tfrac9{25}$. The angle
is given as his ω, which is exactly the quantity that is small near the top: `--omega 1e-300rad` is a good
question.
*/

const auto c = real("c", 0.1, feet, positive, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, positive, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, positive, "height fallen from rest in the first second");
const auto omega = angle("omega", 45_deg, open(0_deg, 90_deg), "half of what Φ is short of 180°");

const Fifty c0 = Fifty(1) / 10, k0 = Fifty(3) / 5, g0 = Fifty(125) / 8;  // our ball in fractions
const Fifty half_right = exact::pi() / 4;                                // ω = 45°

TELL
{
  require(c <= 1e6 * k, "c", "at most a million times k");
  const double second = std::sqrt(2 * g * c);  // what one second is in t√2gc
  const double exact = separatrix_time<double>(c, k, omega);
  const double euler = by_euler<double>(c, k, omega);
  const double l = logarithm<double>(k, omega);
  tell("zeta", 2 * second / k, Unit{"rad/s"}, "angular velocity at the start, √(8gc)/k");
  tell("Phi", std::numbers::pi - 2 * omega, degrees, "the angle turned through, 180° - 2ω");
  tell("t_euler", euler / second, seconds, "time to get there, by Euler's formula (1)");
  tell("t", exact / second, seconds, "the same, exactly");
  tell("late", euler / exact - 1, percent, "by how much Euler's time is too long");
  tell("t_halved", (euler + l) / 2 / second, seconds, "the time if cc/3k stood in (1) for 2cc/3k");
  tell("t_minus", (euler - 2 * l) / second, seconds, "the time with the scan's sign of the logarithm");
  tell("tenfold", k * std::log(10.0) / second, seconds, "time, near the top, to come ten times nearer");
  tell("tau", separatrix_time(c0, k0, half_right), "t√(2gc) at 90° for c = 1/10, k = 3/5");
  tell("tau_euler", by_euler(c0, k0, half_right), "the same by (2)");
  const Fifty equal = by_euler<Fifty>(1, 1, half_right) / separatrix_time<Fifty>(1, 1, half_right) - 1;
  tell("late_equal", static_cast<double>(equal), percent, "by how much (2) is too long with c = k");
}

/*!
For the figures: where $G$ is after equal times, and how the error at a right angle depends on the
eccentricity.
*/

TELL
{
  curve("climb", {"time", "x", "y"}, [](Curve& curve) {
    const double third = separatrix_time<double>(c, k, 45_deg) / 3;
    for(int n = 0; n <= 15; ++n)
    {
      const double missing = 2 * globe::separatrix_angle(c, k, n * third);
      curve.put({n * third / std::sqrt(2 * g * c), -std::sin(missing), std::cos(missing)});
    }
  });
  curve("readings", {"c", "two", "one", "next"}, [](Curve& curve) {
    for(double r = 0.01; r < 2; r *= 1.05)
    {
      const Fifty late = by_euler<Fifty>(r, 1, half_right) - separatrix_time<Fifty>(r, 1, half_right);
      const Fifty halved = late - Fifty(r) * r / (6 * sqrt(Fifty(2)));
      const Fifty next = late + next_term<Fifty>(r, 1, half_right);
      curve.put({r, static_cast<double>(late), static_cast<double>(-halved), static_cast<double>(-next)});
    }
  });
}

/*!
And the ways to the time, side by side.
*/

TELL
{
  const double c_now = c, k_now = k, w = omega, v_end = std::cos(w);
  const auto by_rest = [=](const globe::Gauss& rule) {
    return logarithm(k_now, w) + rule([=](double v) { return rest(c_now, k_now, v); }, 0, v_end);
  };
  const auto by_whole = [=](const globe::Gauss& rule) {
    return rule([=](double v) { return whole(c_now, k_now, v); }, 0, v_end);
  };
  std::vector<Method> ways{
      {"Euler's formula (1)", [=] { return by_euler(c_now, k_now, w); }},
      {"and the next term (5)", [=] { return by_euler(c_now, k_now, w) + next_term(c_now, k_now, w); }}};
  for(const int n : {2, 4, 6, 8, 12})
    ways.push_back({"rest by Gauss, " + std::to_string(n) + " nodes",
                    [=, rule = globe::Gauss(n)] { return by_rest(rule); }, "logarithm taken out"});
  for(const int n : {4, 8, 12, 16, 20})
    ways.push_back({"whole by Gauss, " + std::to_string(n) + " nodes",
                    [=, rule = globe::Gauss(n)] { return by_whole(rule); }, "the whole integral"});
  ways.push_back({"Carlson's integrals (6)", [=] { return separatrix_time(c_now, k_now, w); }});
  race("tau", "t√(2gc)", separatrix_time<Fifty>(c_now, k_now, w), ways);
}

/*!
The ball takes {{t|6}} s for the right angle, and Euler's formula is late by {{late|2}}, although $c$ is a
sixth of $k$; even where $c = k$ it would be late by no more than {{late_equal|2}}. Of the quadratures the
one that has the logarithm taken out needs a handful of nodes at any ω; the other fails as the top comes near
(try `--omega 0.01 --bench`).

::: figure globe-18
alt: The circle that G describes about C, with G at equal intervals of time. From the lowest point it goes up
on the left in long steps; a quarter of the circle is done after three of them; then the steps shrink, and
below the top the points run into one another without reaching it.

Where $G$ stands with respect to $C$ at equal intervals of time, three to the right angle. Near the top it
needs {{tenfold|3}} s to come ten times nearer, and again {{tenfold|3}} s for every next ten times.
:::

::: figure globe-18-readings
alt: The error of the formula for a right angle against c over k, both logarithmic: three nearly straight
lines, of slope 2 for the coefficient cc/3k, slope 4 for 2cc/3k and slope 6 with the next term.

The error of {{eq 1}} at $\Phi = 90°$ against the eccentricity, in units of $k$. A formula that keeps $cc$
must be wrong by $c^4$ only. With $2cc/3k$ it is; with $cc/3k$ it is wrong by a part of $cc$ itself.
:::

## Checks
*/

CHECK_THAT("the tangent of 22°30′ is √2 − 1, and with it (1) becomes (2)")
{
  const char* const because = "a few units of the fiftieth digit";
  const Fifty r = sqrt(Fifty(2));
  CHECK(tan(half_right / 2) == within(r - 1, 1e-49, because));
  CHECK(sqrt((r - 1) / (r + 1)) == within(r - 1, 1e-49, because));
  CHECK(by_euler(c0, k0, half_right) == within(c0 * c0 / (3 * k0 * r) + k0 * log(1 + r), 1e-49, because));
}

/*!
The closed form {{eq 6}} is confirmed in two ways that know nothing of it: by the integral of {{sec globe.13}}
in Φ, and by Euler's three equations of motion ({{sec globe.06}}, {{sec globe.07}}), which know nothing of the
integral either.
*/

CHECK_THAT("the integral of §13 as it stands gives the closed form, at a right angle and close to the top")
{
  for(const Fifty& w : {half_right, Fifty("1e-12")})
  {
    const auto dt = [&](const Fifty& Phi, const Fifty& to_end) {
      const Fifty missing = to_end > 0 ? 2 * w + to_end : exact::pi() - Phi;
      return sqrt(k0 * k0 + c0 * c0 * pow(sin(Phi), 2)) / (2 * sin(missing / 2));
    };
    const Fifty integral = exact::integrate_from_ends(dt, 0, exact::pi() - 2 * w).value;
    CHECK(separatrix_time(c0, k0, w) == within(integral, 1e-36, "the end, π − 2·10⁻¹², keeps 38 digits"));
  }
}

CHECK_THAT("Gauss's rule gives the same time in double from either form of the integral, (3) or (4)")
{
  const globe::Gauss twenty(20);
  const double v_end = std::cos(45_deg);
  const double by_rest = twenty([](double v) { return rest(0.1, 0.6, v); }, 0, v_end);
  const double by_whole = twenty([](double v) { return whole(0.1, 0.6, v); }, 0, v_end);
  const Fifty exact = separatrix_time<Fifty>(0.1, 0.6, 45_deg);
  CHECK(logarithm(0.6, 45_deg) + by_rest == within_ulps(exact, 8, "twenty rounded terms"));
  CHECK(by_whole == within_ulps(exact, 8, "twenty rounded terms"));
}

CHECK_THAT("by the equations of motion, too, the ball has turned through a right angle at that time")
{
  const globe::Ball<Fifty> ball{1, c0, k0};
  const auto motion = [&](const Fifty&, const exact::State& s) {
    return exact::State{s[1], globe::accelerations<Fifty>(ball, g0, s[0], s[1], 0).Phi};
  };
  const Fifty t = separatrix_time(c0, k0, half_right) / sqrt(2 * g0 * c0);
  const auto there = exact::solve(motion, 0, {0, sqrt(8 * g0 * c0) / k0}, t);
  CHECK(there.y[0] == within(exact::pi() / 2, 1e-29, "the integration promises 32 digits a step"));
}

CHECK_THAT("for every eccentricity and angle the time lies between Euler's and Euler's with the next term")
{
  for(const double r : {0.01, 1.0 / 6, 1.0, 4.0})
    for(const double w : {89_deg, 45_deg, 1_deg, 1e-20, 1e-300})
    {
      const Fifty euler = by_euler<Fifty>(r, 1, w), next = next_term<Fifty>(r, 1, w);
      const Fifty time = separatrix_time<Fifty>(r, 1, w);
      CHECK(time == between(euler + next, euler, "√(1+x) is between 1+x/2−xx/8 and 1+x/2"));
      if(r < 0.1)
        CHECK(time - euler == within_relative(next, 5 * r * r, "the term after it is smaller by cc/kk"));
    }
}

CHECK_THAT("near the top each halving of what is missing takes k l 2, without end; doubles keep up with it")
{
  for(const double w : {1e-12, 1e-100, 1e-300})
  {
    const Fifty halving = separatrix_time(c0, k0, Fifty(w) / 2) - separatrix_time(c0, k0, Fifty(w));
    CHECK(halving == within(k0 * exact::ln2(), 1e-22, "what is left out is of the order of ωω"));
    const Fifty euler = by_euler<Fifty>(0.1, 0.6, w), exact = separatrix_time<Fifty>(0.1, 0.6, w);
    CHECK(by_euler(0.1, 0.6, w) == within_ulps(euler, 3, "a logarithm, a product, a sum"));
    CHECK(separatrix_time(0.1, 0.6, w) == within_ulps(exact, 10, "the library's bound"));
  }
}

/*!
"Never" belongs to a $\zeta$ that is met exactly. Let $\zeta\zeta kk$ be $8gc(1\pm\delta)$. Then the ball
passes over the top, or turns back, and the time for that is, but for what vanishes with δ, the logarithm
$k\,l(4/\sqrt\delta)$ and the value that the integral of {{eq 4}} has at the top.
*/

CHECK_THAT("an aim off by δ takes k l(4/√δ) and one constant, whether the ball goes over or turns back")
{
  const Fifty delta("1e-20"), near_top("1e-30");
  const Fifty constant = separatrix_time(c0, k0, near_top) - logarithm(k0, near_top);
  for(const Fifty& highest : {Fifty(1), sqrt(1 - delta)})  // the greatest v: over the top, turning back
  {
    const auto dt = [&](const Fifty& v, const Fifty& to_end) {
      const Fifty gap = (to_end > 0 ? to_end : highest - v) * (highest + v);
      return sqrt((k0 * k0 + 4 * c0 * c0 * v * v * (1 - v * v)) / (gap * (gap + delta)));
    };
    CHECK(exact::integrate_from_ends(dt, 0, highest).value
          == within(k0 * log(4 / sqrt(delta)) + constant, 1e-17, "some δ l δ is left out, near 5·10⁻¹⁹"));
  }
}

/*!
Now the readings. Of {{eq 2}} the scan shows the first term with $kk$, and with a letter s for its digit,
which in this scan is a 2 in {{sec globe.22}} and a 3 in {{sec globe.17}}. One $k$ is certainly too many: the
sum must be a length.
*/

double inches_to_feet(int powers_of_k)
{
  const auto term = [=](double foot) { return std::pow(0.1 * foot, 2) / std::pow(0.6 * foot, powers_of_k); };
  return term(12) / term(1);
}

const Emendation one_k{
    "§18, the example, the first denominator", {"skk√2", inches_to_feet(2)}, {"3k√2", inches_to_feet(1)},
    "t√2gc is a length, and has twelve times as many inches as feet",
    [](double reading) { return reading == within_ulps(12, 8, "seven rounded operations"); }};

/*!
The digit is decided by the motion, through the bounds of {{eq 5}}; and so is the coefficient of {{eq 1}},
which stands without its 2 in the lines that lead to it. In Euler's hand that would have been a slip, and the
right angle would have taken {{t_halved|6}} s. But if s is one and the same digit at the end of
{{sec globe.17}} and here, this display follows from that one only with a 2 in the numerator. It may just be
lost.
*/

bool is_the_time(double reading)
{
  const Fifty lowest = reading + next_term(c0, k0, half_right);
  return separatrix_time(c0, k0, half_right) == between(lowest, reading, "the bounds of (1) and (5)");
}

double example(double factor, double l) { return factor * 0.01 / (0.6 * std::sqrt(2)) + 0.6 * l; }

const double l = std::log(1 + std::sqrt(2));

const Doubtful coefficient{
    "§17, the first term, used in §18", {"cc/3k", example(1.0 / 6, l)}, {"2cc/3k", example(1.0 / 3, l)},
    "sin²Φ is 4 sin²ω cos²ω; without the 2 the ball would be at 90° before the motion brings it there",
    is_the_time};

/*!
And the logarithm. With the minus of the scan the time would be {{t_minus|6}} s. A plus mends it; so does the
minus with the tangent itself, $\sqrt2-1$, as it comes out of {{eq 1}}. The two are the same number, and no
calculation can tell which was set.
*/

const Doubtful sign{
    "§18, the example, the last term",
    {"− k l(1+√2)", example(1.0 / 3, -l)}, {"+ k l(1+√2)", example(1.0 / 3, l)},
    "with the minus the ball would be there before it starts", is_the_time};

const Undecided either_way{
    "§18, the example, how the last term is to be mended", {"+ k l(1+√2)", example(1.0 / 3, l)},
    {"− k l(√2−1)", example(1.0 / 3, -std::log(std::sqrt(2) - 1))},
    "l(√2−1) is −l(√2+1), and both are the time of the motion", is_the_time};

/*!
## Notes

The radius of the ball does not come in: without friction nothing at the surface can turn it. Any uniform
progress may be added, since by {{sec globe.10}} nothing changes the horizontal velocity of $G$.
*/
