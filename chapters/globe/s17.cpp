#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "globe/ball.hpp"
#include "globe/oracle.hpp"
#include "globe/time.hpp"

SECTION(globe, 17, "A logarithm and the cube of a cosine")

using namespace globe;

/*!
## What Euler does

The time with just the velocity for the top is a logarithm and, for what the centre of gravity's distance
adds, the cube of a cosine. To handle the formula of {{sec globe.16}} more easily he puts

$$ \begin{gathered} \tfrac12\Phi = 90° - \omega, \qquad \Phi = 180° - 2\omega, \\
   \sin\Phi = \sin2\omega = 2\sin\omega\cos\omega, \end{gathered} \tag{1} $$

and has to integrate

$$ dt\,\sqrt{8gc} = -\frac{2\,d\omega}{\sin\omega}
   \Bigl(k + \frac{2cc}k{{entry first_line}}\sin^2\omega\cos^2\omega\Bigr), \tag{2} $$

$$ dt\,\sqrt{2gc} = -\frac{k\,d\omega}{\sin\omega}
   - \frac{2cc}k\,d\omega\,\sin\omega\cos^2\omega{{entry sine}}. \tag{3} $$

Both members have known integrals:

$$ t\sqrt{2gc} = C - k\,l\tan\tfrac12\omega + \frac{2cc}{3k}\cos^3\omega{{entry cube}}. \tag{4} $$

To find the constant one has to remember that with $t = 0$ also $\Phi = 0$ and $\omega = 90°$; hence
$C = 0$, and the final equation is

$$ t\sqrt{2gc} = \frac{2cc}{3k}{{entry coefficient}}{{entry denominator}}\cos^3\omega
   - k\,l\tan\tfrac12\omega, \tag{5} $$

from which the time is easily assigned for any angle $\omega = 90° - \frac12\Phi$: that after which the
ball has turned through Φ.

::: margin
Today: $-\ln\tan\frac12\omega = \operatorname{arsinh}\cot\omega$, the inverse Gudermannian of Φ:2.
:::

The first member is the pendulum's, of the length $kk:c$, with the velocity for its top; the second is all
that the rise and fall of the centre of gravity adds, and it is done with when the ball is near the top,
where the cosine is 1: near the top the ball with a small $c$ is behind its pendulum by a constant

$$ \frac{2cc}{3k\sqrt{2gc}}. \tag{A} $$

The chain from {{eq 2}} to {{eq 5}} is badly damaged in our copy. The member with the cosine stands there
four times, each time with a fault. Most of it can be mended: the integral of {{eq 3}} must be that of
{{eq 2}}, and every term must be a length. But for the 2 of the coefficient there is nothing to hold on
to. No line after {{eq 2}} has it in our copy, just as if Euler had once written
$\sin^2\Phi = 2\sin^2\omega\cos^2\omega$; yet {{eq 1}} is sound, and the example of {{sec globe.18}} needs
the 2. Whether he or only our copy lost it cannot be told.

## The program

The formula is in the library, since the next two sections need it, too; near the top it takes the
logarithm as an area-sine, which keeps its digits.

::: code globe/time.hpp by_euler (5)
:::

The place is given by ω, the quantity that is small near the top, or by Φ.
*/

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto omega =
    angle("omega", 30_deg, from_below(1e-300_deg, 90_deg), "half of what Φ is short of 180°");
const auto Phi = angle("Phi", 0, closed(0, 180_deg), "the angle turned instead of ω, where not 0");

Fifty place()  // ω
{
  require(Phi == 0 || Phi >= 1e-20, "Phi", "0, or 1e-20 radians and more");
  const Fifty w = Phi == 0 ? omega.fifty() : Fifty((exact::pi() - Phi.fifty()) / 2);
  require(w > 1e-35 || Phi == 0, "Phi", "short of 180° by more than 2e-35 radians");
  return w;
}

TELL
{
  require(c <= 100 * k, "c", "at most a hundred times k");
  const Fifty w = place(), c_ = c.fifty(), k_ = k.fifty(), second = sqrt(2 * g.fifty() * c_), v = cos(w);
  const Fifty exact = separatrix_time(c_, k_, w), euler = separatrix_time_by_euler(c_, k_, w);
  tell("w", double(w), degrees, "ω");
  tell("Phi_w", double(exact::pi() - 2 * w), degrees, "Φ");
  tell("t", double(exact / second), seconds, "the time to Φ, exactly");
  tell("t_euler", double(euler / second), seconds, "by Euler's formula (5)");
  tell("late", double(euler / exact - 1), percent, "by how much (5) is too long");
  tell("t_half", double((euler - c_ * c_ / (3 * k_) * v * v * v) / second), seconds,
       "by (5) with cc:3k for 2cc:3k");
  tell("behind", double(2 * c_ * c_ / (3 * k_) / second), seconds,
       "what the ball near the top lags behind its pendulum");
}

TELL
{
  curve("readings", {"c", "two", "one", "next"}, [](Curve& curve) {
    const Fifty w = place();
    for(double r = 0.01; r < 2; r *= 1.05)
    {
      const Fifty late = separatrix_time_by_euler<Fifty>(r, 1, w) - separatrix_time<Fifty>(r, 1, w);
      const Fifty next = late + separatrix_next_term<Fifty>(r, 1, w), v = cos(w);
      curve.put({r, double(late), double(abs(r * r / 3 * v * v * v - late)), -double(next)});
    }
  });
}

/*!
At ω = {{w}}, that is $\Phi$ = {{Phi_w}}, {{eq 5}} gives {{t_euler|8}} s where the ball takes {{t|8}} s.
With the coefficient of our copy it would give {{t_half|8}} s. Near the top the ball is {{behind|4}} s
behind its pendulum.

::: figure globe-17
alt: The error of the formula against c over k, both logarithmic: three nearly straight lines, of slope 2
for the coefficient cc/3k, slope 4 for 2cc/3k and slope 6 with the next term.

The error of {{eq 5}} at this ω against the eccentricity, in units of $k$. A formula that keeps $cc$ must
be wrong by $c^4$ only. With $2cc:3k$ it is (blue); with $cc:3k$ it is wrong by a part of $cc$ itself (red).
:::

## Checks

First the chain. Each line is integrated as it stands, from ω to 90°, and must give {{eq 5}}; and {{eq 5}}
is held against the motion.
*/

const Fifty c0 = our_ball<Fifty>.c, k0 = our_ball<Fifty>.k;

Fifty euler(const Fifty& c, const Fifty& k, const Fifty& w)  // (5), as it stands there
{
  return 2 * c * c / (3 * k) * pow(cos(w), 3) - k * log(tan(w / 2));
}

CHECK_THAT("(2) and (3) are Euler's formula of §16 in ω, and their integral from ω to 90° is (5)")
{
  const Fifty right = exact::pi() / 2;
  for(const double w : {80_deg, 30_deg, 1_deg})
  {
    const auto second = [](const Fifty& x) {  // (2), over √8gc:√2gc = 2
      return Fifty((k0 + 2 * c0 * c0 / k0 * pow(sin(x) * cos(x), 2)) / sin(x));
    };
    const auto third = [](const Fifty& x) {  // (3)
      return Fifty(k0 / sin(x) + 2 * c0 * c0 / k0 * sin(x) * pow(cos(x), 2));
    };
    const Fifty at = w, turned = 2 * (right - at);
    const Fifty in_Phi = (k0 + c0 * c0 / (2 * k0) * pow(sin(turned), 2)) / cos(turned / 2);  // §16 (5)
    CHECK(second(at) == within_relative(in_Phi, 1e-46, "(1) is put in; dΦ = −2dω"));
    CHECK(third(at) == within_relative(in_Phi, 1e-46, "and the sine divided out"));
    CHECK(exact::integrate(third, at, right).value == within_relative(euler(c0, k0, at), 1e-38, "(5)"));
  }
  CHECK(euler(c0, k0, right) == within(0, 1e-48, "C = 0"));
}

CHECK_THAT("the times told are those of the motion, and of (5), however near the top")
{
  for(const Told& now : told_at("", "Phi=120 c=0.6", "omega=1e-300 g=1e-90", "c=1e-50 omega=80",
                                "Phi=179.9999999999 c=20 k=3", "Phi=1e-6 c=2"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), second = sqrt(2 * g.fifty() * c_), v = cos(place());
    const Fifty w = Phi == 0 ? omega.fifty() : Fifty(exact::pi() / 2 - Phi.fifty() / 2);
    const Fifty t = oracle::smooth_time(c_, k_, {1, 0}, {v, sin(w)}) / second,
                by_five = euler(c_, k_, w) / second;
    CHECK(now.value("w", degrees) == within_ulps(w, 1, "rounded once"));
    CHECK(now.value("Phi_w", degrees) == within_ulps(exact::pi() - 2 * w, 1, "rounded once"));
    const double slack = 2e-16 + 1e-40 / double(v);
    const char* const because = "rounded once, and 40 digits of v before";
    CHECK(now.value("t", seconds) == within_relative(t, slack, because));
    CHECK(now.value("t_euler", seconds) == within_relative(by_five, slack, because));
    CHECK(now.value("late", percent)
          == within(by_five / t - 1, 1e-15 * double(by_five / t - 1) + 1e-33, "35 digits of either"));
    const Fifty half = by_five - c_ * c_ / (3 * k_) * v * v * v / second;
    CHECK(now.value("t_half", seconds) == within_relative(half, slack, because));
    CHECK(now.value("behind", seconds)
          == within_relative(2 * c_ * c_ / (3 * k_) / second, 2e-16, "rounded once"));
  }
}

CHECK_THAT("it refuses a c and a Φ just beyond its limits, at the top and at the lowest place, none on "
           "them")
{
  for(const char* const within_them :
      {"c=50 k=0.5", "c=100 k=1", "Phi=1e-20rad", "Phi=0", "Phi=179.9999999999999999999999999999999988"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"c=50.00000000000001 k=0.5", "c=100.00000000000002 k=1", "Phi=9.99999999999999e-21rad",
       "Phi=1e-300rad", "Phi=179.9999999999999999999999999999999989", "Phi=180"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("near the top the ball lags behind its pendulum by (A), if c is small")
{
  for(const char* r : {"1e-3", "1e-5"})
  {
    const Fifty c_(r), w("1e-60");
    const Fifty lag = separatrix_time<Fifty>(c_, 1, w) - asinh(1 / tan(w));
    CHECK(lag == within_relative(2 * c_ * c_ / 3, double(c_ * c_), "what is left is c⁴ against cc"));
  }
}

/*!
Now the readings. Each is judged by the motion of our ball at 90°: since $\sqrt{1+X}$ lies between
$1+\frac12X-\frac18XX$ and $1+\frac12X$, the true time lies between {{eq 5}} and {{eq 5}} with the next
term.
*/

const double first = 0.01 / (3 * 0.6 * std::sqrt(2.)), last = 0.6 * std::log(1 + std::sqrt(2.));

bool is_the_time(double reading)
{
  const Fifty half_right = exact::pi() / 4;
  const Fifty lowest = reading + separatrix_next_term(c0, k0, half_right);
  return separatrix_time(c0, k0, half_right) == between(lowest, reading, "the next term is the bound");
}

const Doubtful first_line{"§17, the first formula to be integrated",
                          {"cc/2k", first / 4 + last},
                          {"2cc/k", first + last},
                          "the 2k of §16 and the 4 of sin²Φ = 4 sin²ω cos²ω make that",
                          is_the_time};

const Emendation sine{"§17, the second one",
                      {"sin²ω cos²ω", 0.02 / 0.6 * std::numbers::pi / 32 + last},
                      {"sin ω cos²ω", first + last},
                      "the sine of the denominator is divided out, and only so has it the integral (4)",
                      is_the_time};

const Emendation cube{"§17, the integral",
                      {"cos²ω", first* std::sqrt(2.) + last},
                      {"cos³ω", first + last},
                      "the integral of sin ω cos²ω, and the motion takes that time",
                      is_the_time};

const Doubtful coefficient{
    "§17, the first term, used in §§18 and 19",
    {"cc/3k", first / 2 + last},
    {"2cc/3k", first + last},
    "sin²Φ is 4 sin²ω cos²ω; without the 2 the ball would be at 90° before the motion brings it there",
    is_the_time};

const Emendation denominator{"§17, the final equation, the denominator",
                             {"skk", first / 0.6 + last},
                             {"3k", first + last},
                             "t√2gc is a length, and the motion takes that time",
                             is_the_time};

CHECK_THAT("the true time of the readings is that of the equations of motion, and the bound a bound")
{
  const auto motion = [](const Fifty&, const exact::State& s) {
    return exact::State{s[1], accelerations<Fifty>(our_ball<Fifty>, our_g<Fifty>, s[0], s[1], 0).Phi};
  };
  const Fifty second = sqrt(2 * our_g<Fifty> * c0), right = exact::pi() / 2;
  const Fifty t = separatrix_time(c0, k0, right / 2) / second;
  CHECK(exact::solve(motion, 0, {0, 2 * second / k0}, t).y[0]
        == within(right, 1e-29, "a hundred steps of 1e-32"));
  // In v = cos ω: ∫ 8c⁴ v⁴(1 − vv):k³ ... is the next term, from (1 + X:2) − √(1+X) < XX:8.
  const auto next = [](const Fifty& v) {
    return Fifty(-2 * pow(c0, 4) / pow(k0, 3) * pow(v, 4) * (1 - v * v));
  };
  CHECK(separatrix_next_term(c0, k0, right / 2)
        == within_relative(exact::integrate(next, 0, sqrt(Fifty(2)) / 2).value, 1e-38, "forty digits"));
}

CHECK_THAT("the readings drawn are the formulae less the integral")
{
  for(const Told& now : told_at("", "omega=80", "Phi=178"))
    for(const auto& point : now.points("readings", 5))
    {
      const Fifty r = point.at("c"), w = place(), v = cos(w);
      const Fifty late = euler(r, 1, w) - oracle::smooth_time(r, 1, {1, 0}, {v, sin(w)});
      const Fifty next = 2 * pow(r, 4) * pow(v, 5) * (Fifty(1) / 5 - v * v / 7);
      const char* const because = "rounded once, 35 digits of the time before";
      CHECK(point.value("two") == within(late, 1e-15 * double(late) + 1e-33, because));
      CHECK(point.value("next") == within(next - late, 1e-15 * double(next - late) + 1e-33, because));
      CHECK(point.value("one")
            == within_relative(abs(r * r * v * v * v / 3 - late), 1e-13, "r*r is rounded"));
      CHECK(point.value("c") == between(0.01, 2, "the range that is drawn"));
    }
}

/*!
## Go on from here

::: exercise
Halve $c$. By how much does the error of {{eq 5}} in $t\sqrt{2gc}$ shrink, with either coefficient?
answer: With $2cc:3k$ what is left is of the order of $c^4$, and the error is 16 times less; with $cc:3k$ it
is of the order of $cc$, and only 4 times less.
:::
*/

CHECK_THAT("halving c divides the error by 16 with the one coefficient, by 4 with the other")
{
  const Fifty w = exact::pi() / 6, v3 = pow(cos(w), 3);
  const auto error = [&](const Fifty& c, int two) {
    return Fifty(two * c * c / (3 * k0) * v3 - k0 * log(tan(w / 2)) - separatrix_time(c, k0, w));
  };
  CHECK(error(c0, 2) / error(c0 / 2, 2) == within(16, 0.2, "the next term, by a fortieth of itself"));
  CHECK(error(c0, 1) / error(c0 / 2, 1) == within(4, 0.05, "the c⁴ against the cc"));
}
