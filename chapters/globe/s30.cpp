#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/asked.hpp"
#include "globe/oracle.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 30, "Rocking by rolling")

using namespace globe;

/*!
## What Euler does

A ball that is tilted by a little and left to roll keeps time with a simple pendulum. With this the part on
rocking begins. Both the velocity ζ at the lowest place and the angle Φ are to be very small, so that
$\cos\Phi = 1 - \frac12\Phi\Phi$. To shorten the formula of {{sec globe.29}} let

$$ \begin{aligned} (a-c)^2 + kk &= bb, \\ aa+cc+kk &= bb + 2ac; \end{aligned} \tag{1} $$

then it takes the form

$$ dt = \frac{d\Phi\sqrt{bb + ac\Phi\Phi}}{\sqrt{\zeta\zeta bb - 2gc\Phi\Phi}}. \tag{2} $$

In the numerator $ac\Phi\Phi$ is dropped, and in the denominator $2gc = nnbb$ is put. What is left,

$$ dt = \frac{d\Phi}{\sqrt{\zeta\zeta - nn\Phi\Phi}}, \tag{3} $$

has the integral, A sin being the arc whose sine follows,

$$ t = \frac1n\,\mathrm{A}\sin\frac{n\Phi}\zeta
   = \frac b{\sqrt{2gc}}\,\mathrm{A}\sin\frac{\Phi\sqrt{2gc}}{\zeta b}, \tag{4} $$

and conversely

$$ \Phi = \frac{\zeta b}{\sqrt{2gc}}\sin\frac{t\sqrt{2gc}}b. \tag{5} $$

So the ball rocks on the plane just as pendulums do. The time of one swing comes by putting the angle
$t\sqrt{2gc}/b$ equal to $\pi$,

$$ t = \frac{\pi b}{\sqrt{2gc}}; \tag{6} $$

and as a simple pendulum of the length $l$ swings in the time $\pi\sqrt{l/2g}${{entry half_g}}, the one that
keeps time with the ball is

$$ l = \frac{bb}c = \frac{(a-c)^2+kk}c \tag{7} $$

long. Without friction there had come $kk/c$ ({{sec globe.15}}).

::: margin
Today: period $2\pi b/\sqrt{2gc}$, $2g$ being the acceleration of gravity. $bb$ is the moment of inertia about
the point of contact over the mass.
:::

What was dropped can be kept. With $h = \sin^2$ of half the amplitude and $r = 4ac/bb$ the whole swing is the
mean of $\sqrt{1 + rh\sin^2\vartheta}/\sqrt{1 - h\sin^2\vartheta}$, and in powers of $h$

$$ \begin{aligned} \frac T{T_0} = 1 &+ \frac{1+r}4\,h \\
   &+ \frac{3(1+r)(3-r)}{64}\,hh + \ldots, \end{aligned} \tag{A} $$

where $T_0$ is {{eq 6}}. A quarter of $h$ is the pendulum's own delay. The rest, $r$ times as much, comes from
the numerator: the moment of inertia grows as the ball rolls up. For our ball $r$ is {{r|4}}; for a ball whose
centre of gravity comes close to the plane it may be as large as one likes.

## The program

The excess $T/T_0 - 1$ is a sum of small things, and is formed as such: with $h = 10^{-20}$ it has all its
digits.
*/

template <class Real>
Real first_order(const Real& r, const Real& h)  // (A)
{
  return (1 + r) / 4 * h;
}

template <class Real>
Real second_order(const Real& r, const Real& h)  // (A)
{
  return first_order(r, h) * (1 + 3 * (3 - r) / 16 * h);
}

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto asked = asked_energy(0.05);
const auto t = real("t", 0.6, seconds, closed(0, 1e100), "time since the lowest place");

double ratio(const Ball<double>& ball)  // r
{
  const double b = std::hypot(ball.gap, ball.k);
  return 4 * (ball.a / b) * (ball.c / b);
}

double by_5(double zeta, double n, double time)  // (5)
{
  return zeta / n * std::sin(n * time);
}

TELL
{
  const Ball<double> ball = rounded_ball(a, c, k);
  require_rolling(ball);
  const Energy<double> e = rounded(asked.rolling(a, c, k, g));
  require(e.from_top > 0, asked.given(), "what makes h less than 1: the ball is to rock");
  const double b = std::hypot(ball.gap, k), second = std::sqrt(2 * g) * std::sqrt(c), n = second / b;
  const double zeta = velocity_of_energy<double>(c, bb(ball), g, e), swing = std::numbers::pi / n;
  require(t <= 1e6 * swing, "t", "a time of at most a million very small swings");
  tell("energy", e.h, "h, the square of the sine of half the amplitude");
  tell("amplitude", 2 * std::atan2(std::sqrt(e.h), std::sqrt(e.from_top)), degrees, "the amplitude");
  tell("b", b, feet, "b");
  tell("l", b / c * b, feet, "length of the pendulum that keeps time, (7)");
  tell("l_smooth", k / c * k, feet, "the same on a smooth plane");
  tell("swing_small", swing, seconds, "a single swing, by (6)");
  tell("swing", 2 * rolling::quarter(ball, e) / second, seconds, "a single swing of this amplitude");
  tell("excess", rolling::excess(ball, e), "by what part the second is longer");
  tell("by_first", first_order(ratio(ball), e.h), "the same by the first member of (A)");
  tell("by_second", second_order(ratio(ball), e.h), "the same by two members");
  tell("r", ratio(ball), "r, 4ac/bb");
  tell("share", ratio(ball) / (1 + ratio(ball)), percent,
       "of the delay, what the ball adds to the pendulum's own");
  tell("Phi_small", by_5(zeta, n, t), degrees, "the angle at the time t, by (5)");
  tell("Phi", rolling::angle(ball, e, t * second).Phi, degrees, "the same exactly");
}

TELL
{
  auto& swings = table("swings", "By what part larger swings are longer",
                       {{"amplitude", "amplitude", degrees, 3},
                        {"excess", "exactly", percent},
                        {"by_first", "one member", percent},
                        {"by_second", "two members", percent}});
  const Ball<double> ball = rounded_ball(a, c, k);
  for(const double amplitude : {1_deg, 5_deg, 10_deg, 30_deg, 60_deg, 90_deg, 150_deg})
  {
    const Energy<double> e = energy_of_amplitude(amplitude);
    const double r = ratio(ball);
    swings.row({amplitude, rolling::excess(ball, e), first_order(r, e.h), second_order(r, e.h)});
  }
}

TELL
{
  curve("longer", {"amplitude", "rolling", "first", "second"}, [](Curve& longer) {
    const Ball<double> ball = rounded_ball(a, c, k);
    for(int n = 1; n <= 85; ++n)
    {
      const Energy<double> e = energy_of_amplitude(2 * n * std::numbers::pi / 180);
      const double r = ratio(ball);
      longer.put({2. * n, 1 + rolling::excess(ball, e), 1 + first_order(r, e.h), 1 + second_order(r, e.h)});
    }
  });
  curve("smooth", {"amplitude", "smooth"}, [](Curve& smooth) {
    if(c > 100 * k)
      return;  // beyond what is made for the smooth plane
    for(int n = 1; n <= 85; ++n)
    {
      const Energy<double> e = energy_of_amplitude(2 * n * std::numbers::pi / 180);
      smooth.put({2. * n, 1 + smooth::excess(c, k, e)});
    }
  });
}

/*!
Our ball keeps time with a pendulum of {{l|4}} feet, without friction with one of {{l_smooth|3}}. A swing
takes {{swing_small|6}} seconds if it is small, {{swing|6}} with an amplitude of {{amplitude|4}}°.

{{table swings}}

::: figure globe-30
alt: The time of a swing over that of a small one, against the amplitude. The exact curve for rolling rises
steeply; one member of the series stays below it from 60 degrees on, two members follow it further; the curve
for the smooth plane lies lowest.

How much longer larger swings take: rolling (blue), by one and by two members of {{eq A}} (dashed), and on a
smooth plane (grey). Rolling departs sooner from Euler's law, since the ball that rolls up has more and more
to turn.
:::

## Speed against error

The excess by {{eq A}}, by dividing the two times, and as a mean of excesses. Ask for `--h 1e-20`.
*/

Fifty exact_excess(const Ball<Fifty>& ball, const Energy<Fifty>& e)
{
  const Fifty r = 4 * ball.a * ball.c / bb(ball);
  if((1 + r) * e.h < 1e-16)
    return second_order(r, e.h);  // what follows is less by the square of that
  return rolling::quarter(ball, e) / (exact::pi() / 2 * sqrt(bb(ball))) - 1;
}

TELL
{
  const Ball<double> ball = rounded_ball(a, c, k);
  const Energy<double> e = rounded(asked.rolling(a, c, k, g));
  const double r = ratio(ball), small = std::numbers::pi / 2 * std::hypot(ball.gap, k);
  race("excess", "T/T₀ − 1", exact_excess(exact_ball(a, c, k), asked.rolling(a, c, k, g)),
       {{"one member of (A)", [=] { return first_order(r, e.h); }, "series"},
        {"two members of (A)", [=] { return second_order(r, e.h); }, "series"},
        {"T over T₀, less 1", [=] { return rolling::quarter(ball, e) / small - 1; }},
        {"a mean of excesses", [=] { return rolling::excess(ball, e); }}});
}

/*!
A reader who would rather see the ball than integrate will give it to a physics engine. Several were given
this one: radius 1 metre, $c$ half a metre, $kk = 0.4$, let go from rest at 1.2 radians on a plane with
friction 1, looked at sixty times a second for a minute, each engine with its own settings and nothing that
damps. The first line is this edition, watched in the same way; the true period comes from fifty digits.

{{collected engines ball}}

Below 100 % the ball has lost energy. Above, it has gained some, and neither rolling nor scraping on a plane
at rest can give it any. How the engines were asked stands in [Other systems](other-systems.html), with what
they make of a pendulum.

## Checks

The law of small swings is held against the motion itself, sent off with a velocity that hardly tilts it, and
all larger ones against quadrature in fifty digits.
*/

CHECK_THAT("the lengths and times told are those of the motion, small or not")
{
  for(const Told& now :
      told_at("", "h=1e-20 t=2", "from_top=1e-6 c=0.5 k=0.5 t=1", "a=1e50 c=3e50 k=1e48 h=0.3 t=1e20",
              "a=1 c=1 k=1e-4 h=0.2 t=0.1", "c=0.999999999 k=1e-9 t=1e-8", "zeta=0.1"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Energy<Fifty> e = asked.rolling(a, c, k, g);
    const Fifty one = sqrt(2 * g.fifty() * ball.c), b = sqrt(bb(ball)), small = exact::pi() * b / one;
    const Fifty r = 4 * ball.a * ball.c / bb(ball);
    CHECK(now.value("energy") == within_ulps(e.h, 1, "rounded once"));
    CHECK(now.value("amplitude", degrees)
          == within_relative(2 * atan2(sqrt(e.h), sqrt(e.from_top)), 1e-15, "three roundings"));
    CHECK(now.value("b", feet) == within_relative(b, 1e-15, "two roundings"));
    CHECK(now.value("l", feet)
          == within_relative(2 * g.fifty() * pow(small / exact::pi(), 2), 2e-15, "(7)"));
    CHECK(now.value("l_smooth", feet)
          == within_relative(ball.k * ball.k / ball.c, 1e-15, "three roundings"));
    CHECK(now.value("swing_small", seconds) == within_relative(small, 2e-15, "six roundings"));
    CHECK(now.value("swing", seconds)
          == within_relative(2 * oracle::rolling_quarter(ball, e) / one, 4e-15, "eight ulps and a root"));
    CHECK(now.value("excess") == within_relative(exact_excess(ball, e), 3e-15, "ten ulps"));
    CHECK(now.value("r") == within_relative(r, 2e-15, "five roundings"));
    CHECK(now.value("by_first") == within_relative((1 + r) / 4 * e.h, 3e-15, "seven roundings"));
    CHECK(now.value("by_second")
          == within((1 + r) / 4 * e.h + 3 * (1 + r) * (3 - r) / 64 * e.h * e.h,
                    3e-15 * double((1 + r) * e.h * (1 + (3 + r) * e.h)), "roundings of the members"));
    const Fifty n = one / b, zeta = 2 * n * sqrt(e.h), time = t.fifty();
    CHECK(now.value("Phi_small", degrees)
          == within(zeta / n * sin(n * time), 4e-15 * double(zeta / n * (1 + n * time)),
                    "(5); an ulp of its angle"));
    // Of the exact motion by its own time, from the lowest place and within the first quarter.
    if(time * one < oracle::rolling_quarter(ball, e))
    {
      const Place<Fifty> there = oracle::rolling_place(ball, e, time * one);
      CHECK(now.value("Phi", degrees)
            == within_relative(2 * atan2(there.s, there.c), 1e-14, "ten ulps of the time"));
    }
  }
}

CHECK_THAT(
    "the motion of a ball that is hardly tilted is (5), and the exact one, by the equations of motion")
{
  for(const Told& now : told_at("", "c=0.5 k=0.5 h=0.01 t=3", "a=2 c=3 k=0.3 h=0.6 t=1"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Fifty g_ = g.fifty(), n = sqrt(2 * g_ * ball.c / bb(ball)), tiny("1e-18"), time = t.fifty();
    const auto scaled = [&](const Fifty&, const exact::State& s) {  // Φ in units of tiny
      return exact::State{s[1],
                          rolling_accelerations<Fifty>(ball, g_, s[0] * tiny, s[1] * tiny).Phi / tiny};
    };
    CHECK(exact::solve(scaled, 0, {0, 1}, time).y[0]
          == within(sin(n * time) / n, 1e-28, "the square of the amplitude is left out"));
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1], rolling_accelerations<Fifty>(ball, g_, s[0], s[1]).Phi};
    };
    const Fifty zeta = 2 * n * sqrt(asked.rolling(a, c, k, g).h);
    CHECK(now.value("Phi", degrees)
          == within(exact::solve(motion, 0, {0, zeta}, time).y[0], 1e-14 * double(zeta * (time + 1 / n)),
                    "ten ulps of the time"));
  }
}

CHECK_THAT("a ball that does not rock is refused, one with c = a and k below 1e-20 a, and more than a "
           "million swings")
{
  for(const char* const within_them :
      {"h=0.9999999999999999", "from_top=1e-300", "zeta=0.9999999999999999 a=2 c=1 k=1 g=0.25",
       "c=1 k=1e-20 t=0", "a=2 c=2 k=2e-20 t=0", "c=1 k=1 g=0.5 t=3141592.65358979",
       "c=1 k=2 g=0.5 t=6283185.30717958"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"h=1", "from_top=-1e-300", "zeta=1 a=2 c=1 k=1 g=0.25",
                                  "c=1 k=9.9999999999999e-21 t=0", "a=2 c=2 k=1.9999999999999e-20 t=0",
                                  "c=1 k=1 g=0.5 t=3141592.6535898", "c=1 k=2 g=0.5 t=6283185.3071796"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("a ζ is refused together with 1 − h, where its h is less than 1e-100, and however far the ball "
           "turns over")
{
  for(const char* const within_them : {"from_top=0.5", "zeta=1.0000000000000001e-50 a=2 c=1 k=1 g=0.25"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"from_top=0.5 zeta=1e-9", "zeta=9.999999999999999e-51 a=2 c=1 k=1 g=0.25",
       "zeta=1.0000000000000002e50 a=2 c=1 k=1 g=0.25", "zeta=1e50 a=2 c=1 k=1 g=0.25"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("(A) is right to the square: what is left over falls with the cube of h")
{
  for(const Ball<Fifty>& ball : {our_ball<Fifty>, cradle<Fifty>, Ball<Fifty>{1, 1, Fifty(1) / 3}})
    for(const char* text : {"1e-4", "1e-8"})
    {
      const Fifty h(text), r = 4 * ball.a * ball.c / bb(ball);
      const Fifty exact = oracle::rolling_quarter(ball, energy(h)) / (exact::pi() / 2 * sqrt(bb(ball))) - 1;
      CHECK(first_order(r, h) == within(exact, double(pow((1 + r) * h, 2)), "the square"));
      CHECK(second_order(r, h) == within(exact, double(pow((1 + r) * h, 3)), "the cube"));
    }
}

CHECK_THAT("the table, the race and the figure are the excess in fifty digits")
{
  const auto of = [](double amplitude) { return energy_of_amplitude(Fifty(amplitude)); };
  for(const Told& now : told_at("", "c=0.5 k=0.5 h=1e-20", "a=1 c=1 k=1e-4 h=0.9"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Fifty r = 4 * ball.a * ball.c / bb(ball);
    for(const auto& row : now.rows("swings"))
    {
      const Energy<Fifty> e = of(row.at("amplitude", degrees));
      CHECK(row.value("amplitude", degrees) == between(0, 3, "radians"));
      CHECK(row.value("excess", percent) == within_relative(exact_excess(ball, e), 3e-15, "ten ulps"));
      CHECK(row.value("by_first", percent)
            == within_relative(first_order(r, e.h), 3e-15, "some roundings"));
      CHECK(row.value("by_second", percent)
            == within(second_order(r, e.h), 4e-15 * double((1 + r) * (1 + (3 + r) * e.h)),
                      "of a difference"));
    }
    const Energy<Fifty> e = asked.rolling(a, c, k, g);
    const Fifty exact = exact_excess(ball, e);
    const Fifty judged = oracle::rolling_quarter(ball, e) / (exact::pi() / 2 * sqrt(bb(ball))) - 1;
    CHECK(now.exact("excess")
          == within(judged, 1e-32 * double(1 + judged), "two ways, of which this one subtracts"));
    CHECK(now.method("excess", "one member of (A)")
          == within_relative(first_order(r, e.h), 3e-15, "some roundings"));
    CHECK(now.method("excess", "two members of (A)")
          == within(second_order(r, e.h), 4e-15 * double((1 + r) * e.h * (1 + (3 + r) * e.h)),
                    "of a difference"));
    CHECK(now.method("excess", "T over T₀, less 1")
          == within(exact, 4e-15 * double(1 + exact), "of the times' digits so many are left"));
    CHECK(now.method("excess", "a mean of excesses") == within_relative(exact, 3e-15, "ten ulps"));
  }
  for(const Told& now : told_at(""))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Fifty r = 4 * ball.a * ball.c / bb(ball);
    for(const auto& point : now.points("longer", 6))
    {
      const Energy<Fifty> e = of(point.at("amplitude") * std::numbers::pi / 180);
      CHECK(point.value("amplitude") == between(2, 170, "degrees"));
      CHECK(point.value("rolling") == within_relative(1 + exact_excess(ball, e), 3e-15, "ten ulps"));
      CHECK(point.value("first") == within_relative(1 + first_order(r, e.h), 3e-15, "some roundings"));
      CHECK(point.value("second") == within_relative(1 + second_order(r, e.h), 3e-15, "some roundings"));
    }
    for(const auto& point : now.points("smooth", 6))
    {
      const Energy<Fifty> e = of(point.at("amplitude") * std::numbers::pi / 180);
      CHECK(point.value("amplitude") == between(2, 170, "degrees"));
      CHECK(point.value("smooth")
            == within_relative(oracle::smooth_quarter(ball.c, ball.k, e) / (exact::pi() / 2 * ball.k),
                               3e-15, "ten ulps"));
    }
  }
}

/*!
The ball that the engines were given, at their $g$ of 9.81 m/s²:
*/

CHECK_THAT("the engines' ball swings as the edition says, by the equations of motion and in fifty digits")
{
  const Ball<Fifty> ball{1, Fifty(1) / 2, sqrt(Fifty(2) / 5)};
  const Fifty tilt = Fifty(6) / 5, half_g = Fifty("9.81") / 2;
  const auto motion = [&](const Fifty&, const exact::State& s) {
    return exact::State{s[1], rolling_accelerations<Fifty>(ball, half_g, s[0], s[1]).Phi};
  };
  const double second = std::sqrt(9.81 * 0.5);
  const double period = 4 * rolling::quarter({1, 0.5, std::sqrt(0.4)}, energy_of_amplitude(1.2)) / second;
  CHECK(period
        == within_relative(4 * oracle::rolling_quarter(ball, energy_of_amplitude(tilt))
                               / sqrt(2 * half_g * ball.c),
                           2e-15, "eight ulps and a root"));
  CHECK(exact::solve(motion, 0, {tilt, 0}, Fifty(period)).y[0]
        == within(tilt, 1e-13, "at rest where it was let go, a period later"));
  CHECK(exact::solve(motion, 0, {tilt, 0}, Fifty(period) / 2).y[0]
        == within(-tilt, 1e-13, "and on the other side after half of it"));
}

/*!
The law of the pendulum has lost a 2 in our copy. Its swing with the length of our ball is held against the
motion of the pendulum itself, tilted by hardly anything.
*/

bool is_a_swing(double time)
{
  const Fifty l = Fifty(117) / 10, tiny("1e-12");
  const auto pendulum = [&](const Fifty&, const exact::State& s) {
    return exact::State{s[1], -2 * our_g<Fifty> / l * sin(s[0] * tiny) / tiny};
  };
  const exact::State halfway = exact::solve(pendulum, 0, {0, 1}, Fifty(time) / 2).y;
  return halfway[1] == within(0, 1e-14, "halfway it rests") && halfway[0] > 0
         && exact::solve(pendulum, 0, {0, 1}, Fifty(time)).y[0] == within(0, 1e-14, "then it is back");
}

const Emendation half_g{
    "§30, the time of the simple pendulum",
    {"π√(l/g)", [] { return std::numbers::pi * std::sqrt(11.7 / 15.625); }},
    {"π√(l/2g)", [] { return std::numbers::pi * std::sqrt(11.7 / 31.25); }},
    "the conclusion l = bb/c needs it, and a body that falls g in the first second has the "
    "acceleration 2g",
    is_a_swing};

/*!
## Go on from here

::: exercise
A ball rocks on a rough plane with an amplitude of 30°. What part of the delay of its swings is the pendulum's
own, and what part comes from $a$ and $c$?

answer: By {{eq A}} they are as 1 to $r = 4ac/bb$. For our ball the second is {{share|3}} of the whole,
whatever the amplitude, as long as one member is enough.
:::
*/

CHECK_THAT("of the delay the ball's own part is r/(1 + r)")
{
  for(const Told& now : told_at("", "c=0.5 k=0.5", "a=1e30 c=1e-5 k=1e12"))
  {
    const Fifty r = 4 * a.fifty() * c.fifty() / bb(exact_ball(a, c, k));
    CHECK(now.value("share", percent) == within_relative(r / (1 + r), 3e-15, "seven roundings"));
  }
  // of the motion itself: the excess less that of a pendulum of the same amplitude
  const Fifty h("1e-12"), r = 4 * our_ball<Fifty>.a * our_ball<Fifty>.c / bb(our_ball<Fifty>);
  const Fifty whole = exact_excess(our_ball<Fifty>, energy(h)), own = whole - h / 4;
  CHECK(own / whole == within(r / (1 + r), 1e-11, "h is left out"));
}
