#include "balance/euler.hpp"
#include "balance/mathieu.hpp"
#include "edition/section.hpp"
#include "exact/ode.hpp"

SECTION(balance, 16, "The beam's motion put into the equations of the pans")

using namespace balance;

/*!
## What Euler does

To determine the motion of the pans more accurately, the known motion of the beam is put into their equations.
Two letters make it shorter. Let

$$ \begin{gathered} \sqrt{\frac{2g}f}{{entry root_of_lambda}} = \lambda, \quad\text{so that}\\
   \omega = \mathfrak C\sin(\gamma+\lambda t); \end{gathered} \tag{1} $$

then

$$ \begin{aligned}
\frac{b\,dd\eta}{2g\,dt^2}
  &= -\eta + \frac{a\,\mathfrak C\,\eta{{entry lost_factor}}\sin(\gamma+\lambda t)}f,\\
\frac{b\,dd\vartheta}{2g\,dt^2} &= -\vartheta - \frac{a\,\mathfrak C\,\vartheta\sin(\gamma+\lambda t)}f.
\end{aligned} \tag{2} $$

Let also $\sqrt{2g:b} = \mu$ (in our copy the 2 has strayed to the root); then the first members are

$$ \frac{dd\eta}{\mu\mu\,dt^2} \quad\text{and}\quad \frac{dd\vartheta}{\mu\mu\,dt^2}. \tag{3} $$

From here on an instrument is two numbers, λ and μ, and the lengths return only in $a:f$. As
$\lambda:\mu = \sqrt b:\sqrt f$, all depends on how the strings compare with the pendulum that keeps time with
the beam.

::: margin
Today: $2g$ is written $g$; λ and μ are angular frequencies.
:::

The factor η in {{eq 2}} is more than a letter. The beam does not change the place to which the pan returns
but the weight with which it does: P weighs $1 - a\omega:f$ of what it is, and Q the same with a plus. A force
that is in proportion to η cannot stir a pan that hangs at rest. If η were missing, as in our copy, the beam
would shake both pans directly, with the strength $a\mathfrak C:f$, and a pan at rest would not remain so.

To solve {{eq 2}} Euler will put the first approximation into the small member, once ({{sec balance.17}}). One
can do it again. The second time the product contains, among its waves, one of the frequency μ itself, and a
pendulum driven at its own frequency answers with a swing that grows as the time. To
$\mathfrak A\cos\mu t$, which is {{sec balance.15}}'s with α = 90°, there comes

$$ \mathfrak A\,\delta t\sin\mu t, \quad
   \delta = \frac{\mu^3(a\mathfrak C:f)^2}{4(4\mu\mu-\lambda\lambda)}. \tag{A} $$

It is no growth: $\cos\mu t + \delta t\sin\mu t$ is the beginning of $\cos(\mu-\delta)t$. The iteration
reports in its own way that the pan is a little slower than μ, in proportion to the square of the beam's pull.

## The program

What {{eq 2}} says at one moment, from lengths. All is reckoned in fifty digits and told as a double.
*/

const auto a = real("a", 16. / 9, feet, closed(1e-20, 1e20), "half the beam");
const auto b = real("b", 32. / 9, feet, closed(1e-20, 1e20), "the strings");
const auto f = real("f", 32, feet, closed(1e-20, 1e20), "the pendulum that keeps time with the beam");
const auto g = real("g", 16, feet, closed(1e-20, 1e20), "height fallen in the first second");
const auto C = angle("C", 1. / 6, closed(-90_deg, 90_deg), "amplitude ℭ of the beam");
const auto gamma = angle("gamma", 90_deg, closed(-360_deg, 360_deg), "phase γ of the beam");
const auto t = real("t", 1, seconds, closed(0, 1e6), "time");
const auto eta = angle("eta", 10_deg, closed(-90_deg, 90_deg), "inclination η of the string AP");
const auto theta = angle("theta", 10_deg, closed(-90_deg, 90_deg), "inclination ϑ of the string BQ");

Fifty frequency(const Fifty& length)  // (1), and μ
{
  return sqrt(2 * g.fifty() / length);
}

Fifty beam(const Fifty& time)  // (1)
{
  return C.fifty() * sin(gamma.fifty() + frequency(f.fifty()) * time);
}

Fifty pan(const Fifty& at, int side, const Fifty& time)  // (2), side 1 for P, −1 for Q
{
  return -at + side * a.fifty() * at * beam(time) / f.fifty();
}

Fifty slower_by()  // δ of (A)
{
  const Fifty l = frequency(f.fifty()), u = frequency(b.fifty()), depth = a.fifty() * C.fifty() / f.fifty();
  return u * u * u * depth * depth / (4 * (2 * u - l) * (2 * u + l));
}

TELL
{
  const Unit per_second{"1/s"};
  require(f.fifty() * 4 != b.fifty(), "f", "not a quarter of b, where λ is 2μ");
  const Fifty T = t.fifty();
  tell("lambda", double(frequency(f.fifty())), per_second, "λ, of the beam");
  tell("mu", double(frequency(b.fifty())), per_second, "μ, of the pans");
  tell("omega", double(beam(T)), degrees, "ω at the time t");
  tell("depth", double(a.fifty() * C.fifty() / f.fifty()), percent,
       "aℭ/f, how much a pan's weight changes");
  tell("weight_P", double(1 - a.fifty() * beam(T) / f.fifty()),
       "weight of P as its string feels it, over L");
  tell("weight_Q", double(1 + a.fifty() * beam(T) / f.fifty()), "that of Q");
  tell("of_P", double(pan(eta.fifty(), 1, T)), "ddη/μμdt², (2)");
  tell("of_Q", double(pan(theta.fifty(), -1, T)), "ddϑ/μμdt²");
  tell("delta", double(slower_by()), per_second,
       "δ of (A), by how much the pans are slower if the beam swings little");
}

/*!
What each step gains, in Euler's example: the greatest error within the last fifth of a time, of a pan let go
at the angle 1 under a beam of a sixth. Judge is the equation itself.
*/

constexpr int moments = 150;  // out of step with beam and pan

std::array<double, 3> errors(double until)
{
  const double delta = 1. / 60480;  // δ at λ = 1, μ = 3, aℭ:b = 1/12
  const Release once{1, 3, 0.25, {1. / 6, 1, 0}, 0}, in_step{1, 3 - delta, 0.25, {1. / 6, 1, 0}, 0};
  std::array<double, 3> most{};
  for(int j = 0; j < moments; ++j)
  {
    const double time = late_moment(j, moments, until), right = pan_under({3, 1, 1. / 12}, {1, 0}, time).y;
    most[0] = std::max(most[0], std::abs(std::cos(3 * time) - right));
    most[1] = std::max(most[1], std::abs(euler_corrected(once, time).eta - right));
    most[2] = std::max(most[2], std::abs(euler_corrected(in_step, time).eta - right));
  }
  return most;
}

TELL
{
  curve("steps", {"t", "none", "once", "in_step"}, [](Curve& out) {
    for(int j = 0; j <= 60; ++j)
    {
      const double until = std::pow(10, 0.5 + j / 20.);
      const std::array<double, 3> most = errors(until);
      out.put({until, most[0], most[1], most[2]});
    }
  });
}

/*!
In the example the beam changes the weight of a pan by {{depth|percent2}} at most, and at the time {{t}} s P
feels {{weight_P|6}}, Q {{weight_Q|6}} of it. The pans are slower by {{delta|e3}} 1/s.

::: figure balance-16
alt: Errors against the time, both logarithmic. With the product left out the error lies near a hundredth and
in the end grows. With the product put in once it starts far smaller, grows steadily and comes up
to the first after a thousand seconds. With the frequency put right it stays small throughout.

What the approximations miss of the solution of {{eq 2}}, in parts of the excursion: with the small member
left out, {{sec balance.15}}; with the first approximation put into it once, {{sec balance.17}}; the same
with $\mu - \delta$ for μ. Euler's step gains much for some time; then its clock is wrong.
:::

## Checks
*/

CHECK_THAT("(2) is what a string pulls whose upper end is accelerated as the beam's end is")
{
  for(const Told& now :
      told_at("", "a=3 b=0.2 f=7e3 g=4.9 C=-80 gamma=-130 t=12345.5 eta=-40 theta=77",
              "a=1e-20 f=1e20 t=1e6", "b=1e15 g=1e-9 f=1e-15 eta=1e-9 t=9", "f=1e-3 C=0 t=0"))
  {
    const Fifty G = 2 * g.fifty(), l = sqrt(G) / sqrt(f.fifty()), T = t.fifty(), h = Fifty("1e-14") / l;
    const auto omega = [&](const Fifty& time) {
      return C.fifty() * (sin(gamma.fifty()) * cos(l * time) + cos(gamma.fifty()) * sin(l * time));
    };
    // the end A rises by aω; its acceleration by differences, over 2g
    const Fifty raised = a.fifty() * (omega(T + h) - 2 * omega(T) + omega(T - h)) / (h * h) / G;
    const char* const why = "one rounding, and differences of 1e-14";
    const double close = double(abs(a.fifty() / f.fifty())) * 1e-15;
    const Unit per_second{"1/s"};
    CHECK(now.value("lambda", per_second) == within_ulps(l, 0.5001, why));
    CHECK(now.value("mu", per_second) == within_ulps(sqrt(G / b.fifty()), 0.5001, why));
    CHECK(now.value("omega", degrees) == within(omega(T), 1e-16 * (1e-3 + std::abs(C)), why));
    CHECK(now.value("depth", percent) == within_ulps(a.fifty() / f.fifty() * C.fifty(), 0.5001, why));
    CHECK(now.value("weight_P") == within(1 + raised, 2e-16 + close, why));
    CHECK(now.value("weight_Q") == within(1 - raised, 2e-16 + close, why));
    CHECK(now.value("of_P") == within(-(1 + raised) * eta.fifty(), std::abs(eta) * (2e-16 + close), why));
    CHECK(now.value("of_Q")
          == within(-(1 - raised) * theta.fifty(), std::abs(theta) * (2e-16 + close), why));
  }
}

CHECK_THAT("it refuses the pendulum whose λ is 2μ, a quarter of the strings, and none beside it")
{
  for(const char* const beside :
      {"f=0.99999999999999999999 b=4", "f=1.00000000000000000001 b=4", "f=32.000001 b=128"})
    CHECK(!refused_at(beside));
  for(const char* const there : {"f=1 b=4", "f=32 b=128"})
    CHECK(refused_at(there));
}

CHECK_THAT("δ is by how much the mean frequency lies below μ, to the square of the beam's angle")
{
  for(const Told& now : told_at("C=0.01", "C=0.01 f=500", "C=-0.01 f=0.2 b=5 a=0.1"))
  {
    const double l = double(frequency(f.fifty())), u = double(frequency(b.fifty()));
    CHECK(now.value("delta", Unit{"1/s"})
          == within_relative(-floquet({u, l, a * C / b}).shift, 1e-5, "the fourth power is left out"));
  }
  for(const Told& now : told_at(""))
    CHECK(now.value("delta", Unit{"1/s"}) == within_relative(Fifty(1) / 60480, 1e-15, "1/144 : (12·35)"));
}

CHECK_THAT("in the figure the errors are those against the equation solved to eighteen digits")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("steps", 31))
    {
      const double until = point.at("t");
      if(until > 25)
        continue;
      std::vector<Fifty> times;
      for(int k = 0; k < moments; ++k)
        times.emplace_back(late_moment(k, moments, until));
      const exact::RightSide right = [](const Fifty& time, const exact::State& y) {
        return exact::State{y[1], (cos(time) / 12 - 9) * y[0]};
      };
      Fifty none, once, in_step;
      std::size_t j{0};
      for(const exact::Solution& now_at : exact::solve(right, 0, {1, 0}, times, Fifty("1e-22")))
      {
        const Fifty T = times[j++], y = now_at.y[0];
        const auto waves = [&T](const Fifty& u) {  // §17, let go at the angle 1 from rest, im = 1/24
          const Fifty lower = 1 / (24 * (2 * u - 1)), upper = 1 / (24 * (2 * u + 1));
          return Fifty((cos(u * T) + lower * cos((u - 1) * T) - upper * cos((u + 1) * T))
                       / (1 + lower - upper));
        };
        none = std::max(none, abs(cos(3 * T) - y));
        once = std::max(once, abs(waves(3) - y));
        in_step = std::max(in_step, abs(waves(3 - Fifty(1) / 60480) - y));
      }
      const char* const why = "a motion to rounding";
      CHECK(point.value("none") == within(none, 1e-13, why));
      CHECK(point.value("once") == within(once, 1e-13, why));
      CHECK(point.value("in_step") == within(in_step, 1e-13, why));
    }
}

CHECK_THAT(
    "putting the frequency right keeps the error of Euler's step where it was, a thousand seconds on")
{
  const std::array<double, 3> early = errors(10), late = errors(3000);
  CHECK(early[1] == between(1e-5, 1e-3, "of the second order of the beam's angle"));
  CHECK(late[1] == between(30 * early[1], 1, "out of step"));
  CHECK(late[2] == between(0, 3 * early[1], "in step"));
  CHECK(early[0] == between(5 * early[1], 1, "Euler's step gains"));
}

/*!
Our copy has $g:f$ for $2g:f$ in {{eq 1}}, and has lost η and ϑ from the last members of {{eq 2}}. With the
equation of {{sec balance.17}} they come back.
*/

const Emendation root_of_lambda{"§16, the root that is called λ",
                                {"√(g/f)", [] { return std::sqrt(16. / 32); }},
                                {"√(2g/f)", [] { return std::sqrt(32. / 32); }},
                                "fω̈/2g + ω is nothing for ω = sin λt, and §§ 21 and 24 have it",
                                [](double root) {
                                  const double left = 32. / 32 * root * root - 1;
                                  return root > 0 && left == within(0, 4e-16, "few roundings");
                                }};

const Emendation lost_factor{
    "§16, the last members of both equations",
    {"aℭ sin(γ + λt) : f", 16. / 9 / 6 / 32},
    {"aℭη sin(γ + λt) : f", 16. / 9 / 6 / 32 / 10},
    "it is what the pull of the string lacks of L, times the sine of its inclination",
    [](double member) {  // η = 0.1, ω = ℭ = ⅙ and at rest: A sinks with aω·2g:f
      const double lacks = 16. / 9 / 6 / 32, lean = 0.1;
      return member == within_ulps(lacks * lean, 3, "a product");
    }};

/*!
## Go on from here

::: exercise
Which pan feels heavier while $A$ is above the horizontal, the higher or the lower one, and why?

answer: Q, whose end $B$ is then below and is accelerated upward, as {{weight_Q|6}} shows, ω being positive;
$A$ is above and accelerated downward. The beam is always accelerated back to the level.
:::
*/

CHECK_THAT("while A is above the horizontal P is felt as lighter, Q as heavier")
{
  for(const Told& now : told_at("", "t=0.5 C=3", "t=4 gamma=200 C=20"))
  {
    const bool above = beam(t.fifty()) > 0;
    CHECK(above);
    CHECK(now.value("weight_P") == between(0, 1 - 1e-9, "lighter"));
    CHECK(now.value("weight_Q") == between(1 + 1e-9, 2, "heavier"));
  }
}
