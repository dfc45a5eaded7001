#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/asked.hpp"
#include "globe/gauss.hpp"
#include "globe/oracle.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 28, "The time of the ball that rolls")

using namespace globe;

/*!
## What Euler does

If the plane has the friction that rolling takes, angle and time hang together by one formula. It is the
integral of {{sec globe.25}},

$$ \begin{aligned} &d\Phi^2(aa+cc+kk) - 2ac\,d\Phi^2\cos\Phi \\
   &\quad = 4g\,dt^2(c\cos\Phi + C), \end{aligned} \tag{1} $$

from which

$$ 2\,dt\sqrt g = \frac{d\Phi\sqrt{aa+cc+kk-2ac\cos\Phi}}{\sqrt{C{{entry C_for_c}}+c\cos\Phi}}. \tag{2} $$

This, he says, is altogether different from what was found without friction ({{sec globe.13}}). So friction,
be it ever so small, changes the very nature of the motion. And neither can this equation be resolved, except
in the cases that the first part dealt with.

::: margin
Today: an elliptic integral of the third kind; on the smooth plane it was hyperelliptic. $C = c(2h-1)$.
:::

In both conclusions there is more to say. How small the friction may be depends on how large the motion is;
that is for {{sec globe.32}}. And {{eq 2}} is much the more tractable of the two formulae. On the smooth plane
the upper root has the square of $\sin\Phi$; here it has $\cos\Phi$ alone, and with
$\sin^2\tfrac12\varphi = \varpi/(1+\sigma)$, where $\varpi = \sin^2\tfrac12\Phi$, there is nothing but linear
factors of σ under the root. In Carlson's integrals

$$ \begin{aligned} R_F &= \tfrac12\!\int_0^\infty\!\frac{d\sigma}{\sqrt{(\sigma+x)(\sigma+y)(\sigma+z)}}, \\
   R_J &= \tfrac32\!\int_0^\infty\!\frac{(\sigma+1)^{-1}\,d\sigma}{\sqrt{(\sigma+x)(\sigma+y)(\sigma+z)}}
   \end{aligned} $$

the time is, for rocking and turning over alike,

$$ \begin{gathered} t\sqrt{2gc} = b\sqrt{\frac\varpi h}\,\Bigl(R_F + \frac{4ac\varpi}{3bb}\,R_J\Bigr), \\
   x = 1-\frac\varpi h, \quad y = 1-\varpi, \\ z = 1+\frac{4ac\varpi}{bb}, \end{gathered} \tag{A} $$

with $bb = (a-c)^2+kk$ and $h$ for the energy over what the top asks for. There is no case to be told apart,
and where $h$ is all but 1 nothing is lost if $1 - h$ is given by itself. At $h = 1$ two of the letters are
equal, and the time is elementary, whatever $c$ is: with $V = \sin\tfrac12\Phi$ and $BB = (a+c)^2+kk$

$$ \begin{aligned} t\sqrt{2gc} = B&\operatorname{artanh}\frac{BV}{\sqrt{bb+4acVV}} \\
   - 2\sqrt{ac}\,&\operatorname{arsinh}\frac{2V\sqrt{ac}}b. \end{aligned} \tag{B} $$

## The program

Formula {{eq A}} is these lines.

::: code globe/rolling.cpp time (A)
:::

For comparison {{eq 2}} is summed as it stands by Gauss's rule, in an angle ϑ that runs evenly:
$\sin\tfrac12\Phi = \sqrt h\sin\vartheta$ where the ball rocks, $\tfrac12\Phi = \vartheta$ where it turns
over.
*/

template <class Real>
Real rate(const Ball<Real>& ball, const Energy<Real>& e, const Real& theta)  // (2), dτ/dϑ
{
  using std::cos, std::sin, std::sqrt;
  const Real ss = sin(theta) * sin(theta), tt = cos(theta) * cos(theta);
  const Real most = e.turns_over() ? Real(1) : e.h;
  const Real left = e.turns_over() ? Real(tt - e.from_top) : Real(e.from_top + e.h * tt);
  return sqrt(bb(ball) + 4 * ball.a * ball.c * most * ss) / sqrt(left);
}

template <class Real>
Real theta_of(const Energy<Real>& e, const Place<Real>& at)
{
  using std::atan2, std::sqrt;
  return e.turns_over() ? Real(atan2(at.s, at.c)) : Real(atan2(at.s, sqrt(left_for_motion(e, at))));
}

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto asked = asked_energy(0.5);
const auto where = asked_place(60_deg);
const auto t = real("t", 0.3, seconds, closed(0, 1e100), "time since the lowest place");

double second()  // what one second is in τ
{
  return std::sqrt(2 * g) * std::sqrt(c);
}

double time_to_place(const Ball<double>& ball, const Energy<double>& e, const Place<double>& at)
{
  return at.s * at.s <= e.h ? rolling::time(ball, e, at) / second() : infinity;
}

double smooth_to_place(const Energy<double>& e, const Place<double>& at)
{
  return at.s * at.s <= e.h ? smooth::time<double>(c, k, e, at) / second() : infinity;
}

TELL
{
  const Ball<double> ball = rounded_ball(a, c, k);
  require(c <= 1e9 * k, "c", "at most a thousand million k");
  const Ball<Fifty> exactly = exact_ball(a, c, k);
  const Energy<Fifty> exact_e = asked.rolling(a, c, k, g);
  const Place<Fifty> exact_at = where.fifty();
  const Fifty one = sqrt(2 * g.fifty() * exactly.c);
  const bool gets = gets_to(exact_e, exact_at);
  const Energy<double> e = rounded(exact_e);
  const Place<double> at = rounded(exact_at);
  if(e.from_top == 0)
    require(t <= 600 * std::hypot(a + c, k) / second(), "t", "at most 600 times √((a + c)² + kk) : √2gc");
  else
    require(t <= 1e6 * rolling::quarter(ball, e) / second(), "t",
            "at most a million times what the way to the end or the top takes");
  const Turned turned = rolling::angle(ball, e, t * second());
  tell("energy", e.h, "h, the energy as a part of what the top asks for");
  tell("below_top", e.from_top, "1 − h");
  tell("t_Phi", gets ? double(rolling::time(exactly, exact_e, exact_at) / one) : infinity, seconds,
       "from the lowest place to Φ, by (A)");
  tell("t_smooth", gets ? smooth_to_place(e, at) : infinity, seconds,
       "the same on a smooth plane, with this h");
  tell("t_1", exact_at.c == 0 ? infinity : double(rolling::separatrix_time(exactly, exact_at) / one),
       seconds, "with just the energy for the top, by (B)");
  tell("Phi_t", turned.Phi, degrees, "the angle at the time t");
  tell("psi_t", turned.from_top, degrees, "what it lacks there of the top, or of the nearest one");
}

TELL
{
  auto& energies =
      table("energies", "From the lowest place to Φ, rolling and on a smooth plane",
            {{"h", "energy", none, 1}, {"rolling", "rolling", seconds}, {"smooth", "smooth", seconds}});
  const Ball<double> ball = rounded_ball(a, c, k);
  const Place<double> at = rounded(where.fifty());
  for(const double h : {0.5, 1.0, 2.0, 8.0})
    energies.row({h, time_to_place(ball, energy(h), at), smooth_to_place(energy(h), at)});
}

TELL
{
  curve("motion", {"t", "rolling", "smooth"}, [](Curve& motion) {
    const Ball<double> ball = rounded_ball(a, c, k);
    const Energy<double> e = rounded(asked.rolling(a, c, k, g));
    const double end =
        e.from_top == 0 ? 8 * std::hypot(a + c, k) : (e.turns_over() ? 2 : 4) * rolling::quarter(ball, e);
    for(int n = 0; n <= 120; ++n)
      motion.put({n * end / 120 / second(),
                  rolling::angle(ball, e, n * end / 120).Phi * 180 / std::numbers::pi,
                  smooth::angle(c, k, e, n * end / 120).Phi * 180 / std::numbers::pi});
  });
}

/*!
Our ball, with half the energy for the top, has rolled through 60° in {{t_Phi|6}} seconds; on a smooth plane
it would be there in {{t_smooth|6}}.

{{table energies}}

::: figure globe-28
alt: Angle against time through one whole oscillation. Both curves swing between the same angles; the one for
the smooth plane has gone nearly twice to and fro when the rolling one has done so once.

One oscillation of the ball that rolls (blue), and the same ball with the same $h$ on a smooth plane (grey).
Both turn back at the same angle.
:::

## Speed against error

How far does plain summing of {{eq 2}} get? Ask for `--from_top 1e-9 --psi 0.01`.
*/

const std::vector<int> counts{4, 8, 16, 32};

TELL
{
  const Ball<double> ball = rounded_ball(a, c, k);
  const Energy<Fifty> exact_e = asked.rolling(a, c, k, g);
  const Place<Fifty> exact_at = where.fifty();
  if(exact_at.s == 0 || !gets_to(exact_e, exact_at) || (exact_e.from_top == 0 && exact_at.c == 0))
    return;  // no time, or none that ends
  const Energy<double> e = rounded(exact_e);
  const Place<double> at = rounded(exact_at);
  const double end = theta_of(e, at);
  std::vector<Method> ways;
  for(const int n : counts)
    ways.push_back({"Gauss, " + std::to_string(n) + " nodes",
                    [=, gauss = Gauss(n)] {
                      return gauss([=](double theta) { return rate(ball, e, theta); }, 0, end);
                    },
                    "Gauss"});
  ways.push_back({"Carlson's integrals, (A)", [=] { return rolling::time(ball, e, at); }});
  race("time", "t√(2gc)", rolling::time(exact_ball(a, c, k), exact_e, exact_at), ways);
}

/*!
## Checks

The times are held against {{eq 2}} by quadrature in fifty digits, and against the equations of motion.
*/

CHECK_THAT("the times and angles told are those of the integral (2), from rest to the fastest turning")
{
  for(const Told& now : told_at("", "from_top=1e-15 psi=1e-3 t=2", "zeta=9 Phi=170 c=0.3 t=0.2",
                                "from_top=-1e-30 psi=1e-20 k=3 t=1", "h=1e-40 Phi=1e-21rad g=1e50 t=1e-30",
                                "a=1 c=1 k=1e-5 Phi=90 h=0.9", "c=0.999999999 k=1e-9 Phi=1e-9rad t=1e-10",
                                "a=1e50 c=1e49 k=1e50 g=1e40 h=30"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Energy<Fifty> e = asked.rolling(a, c, k, g);
    const Place<Fifty> at = where.fifty();
    const Fifty one = sqrt(2 * g.fifty() * ball.c);
    CHECK(now.value("energy") == within_ulps(e.h, 1, "rounded once"));
    CHECK(now.value("below_top") == within_ulps(e.from_top, 1, "rounded once"));
    CHECK(now.value("t_Phi", seconds)
          == within_ulps(oracle::rolling_time(ball, e, at) / one, 1, "rounded once"));
    CHECK(now.value("t_smooth", seconds)
          == within_relative(oracle::smooth_time(ball.c, ball.k, e, at) / one, 1e-14,
                             "eight ulps, and what the place rounds"));
    const Energy<Fifty> top{1, 0};
    CHECK(now.value("t_1", seconds)
          == within_ulps(oracle::rolling_time(ball, top, at) / one, 1, "rounded once"));
    const Place<Fifty> turned = oracle::rolling_place(ball, e, t.fifty() * one);
    CHECK(now.value("Phi_t", degrees)
          == within_relative(2 * atan2(turned.s, turned.c), 1e-14, "ten ulps of τ, and a root"));
    CHECK(now.value("psi_t", degrees)
          == within_relative(2 * atan2(turned.c, turned.s), 1e-13, "ten ulps of τ are more of ψ"));
  }
  for(const Told& now : told_at("Phi=90.001", "h=1 Phi=180", "from_top=1e-300 psi=1e-160"))
  {
    CHECK(now.value("t_Phi", seconds) == infinite("the ball does not get there"));
    CHECK(now.value("t_smooth", seconds) == infinite("the ball does not get there"));
  }
  for(const Told& now : told_at("Phi=180"))
    CHECK(now.value("t_1", seconds) == infinite("the top"));
}

CHECK_THAT("it refuses balls and times beyond its limits, and follows what lies within them")
{
  for(const char* const within_them :
      {"c=1e9 k=1", "c=2e9 k=2", "h=1 a=3 c=1 k=3 g=0.5 t=3000", "t=1185508.99", "h=2 t=872347.459"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"c=1000000000.0000002 k=1", "c=2000000000.0000005 k=2", "h=1 a=3 c=1 k=3 g=0.5 t=3000.0000000001",
       "t=1185508.993", "h=2 t=872347.461"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("a ζ is refused together with 1 − h, and where its h is less than 1e-100 or more than 1e100")
{
  for(const char* const within_them : rolling_within)
    CHECK(!refused_at(within_them + std::string(" t=0")));
  for(const char* const beyond : rolling_beyond)
    CHECK(refused_at(beyond + std::string(" t=0")));
}

CHECK_THAT("the equations of motion bring the ball to the angle asked for in the time told")
{
  for(const Told& now : told_at("", "h=3 Phi=150", "zeta=15 Phi=90 c=0.5 k=0.5", "h=1 Phi=120"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Energy<Fifty> e = asked.rolling(a, c, k, g);
    const Fifty g_ = g.fifty(), one = sqrt(2 * g_ * ball.c);
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1], rolling_accelerations<Fifty>(ball, g_, s[0], s[1]).Phi};
    };
    const Fifty time = rolling::time(ball, e, where.fifty()) / one;
    CHECK(now.value("t_Phi", seconds) == within_relative(time, 1e-14, "eight ulps and a root"));
    CHECK(exact::solve(motion, 0, {0, 2 * one * sqrt(e.h) / sqrt(bb(ball))}, time).y[0]
          == within(where.angle(), 1e-28, "some hundred steps of 1e-32"));
  }
}

CHECK_THAT("with h = 1 the elementary time (B) is the formula (A), for every ball")
{
  for(const Ball<Fifty>& ball :
      {our_ball<Fifty>, cradle<Fifty>, Ball<Fifty>{1, 1, Fifty("1e-6")}, Ball<Fifty>{1, 9, 2}})
    for(const char* V : {"1e-30", "0.5", "0.99999"})
    {
      const Fifty v(V), D = bb(ball) + 4 * ball.a * ball.c * v * v, r = 2 * sqrt(ball.a * ball.c);
      const Place<Fifty> at{v, sqrt(1 - v * v)};
      CHECK(sqrt(BB(ball)) * atanh(sqrt(BB(ball)) * v / sqrt(D)) - r * asinh(r * v / sqrt(bb(ball)))
            == within_relative(rolling::time(ball, energy(Fifty(1)), at), 1e-24,
                               "artanh of nearly 1, and a difference"));
    }
}

CHECK_THAT("the table, the race and the figure are the integral, the rule in fifty digits and the motion")
{
  for(const Told& now : told_at("", "c=0.5 k=0.5 g=0.5 Phi=20", "from_top=1e-9 psi=0.01 k=2"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Energy<Fifty> e = asked.rolling(a, c, k, g);
    const Place<Fifty> at = where.fifty();
    const Fifty one = sqrt(2 * g.fifty() * ball.c);
    for(const auto& row : now.rows("energies"))
    {
      const Energy<Fifty> of_row = energy(Fifty(row.at("h")));
      CHECK(row.value("h") == between(0.5, 8, "the four energies"));
      if(at.s * at.s > of_row.h)
      {
        CHECK(row.value("rolling", seconds) == infinite("the ball does not get there"));
        CHECK(row.value("smooth", seconds) == infinite("the ball does not get there"));
        continue;
      }
      CHECK(
          row.value("rolling", seconds)
          == within_relative(oracle::rolling_time(ball, of_row, at) / one, 1e-14, "eight ulps and a root"));
      CHECK(row.value("smooth", seconds)
            == within_relative(oracle::smooth_time(ball.c, ball.k, of_row, at) / one, 1e-14,
                               "eight ulps and a root"));
    }
    const Fifty time = oracle::rolling_time(ball, e, at);
    CHECK(now.exact("time") == within_relative(time, 1e-33, "the quadrature's bound"));
    CHECK(now.method("time", "Carlson's integrals, (A)") == within_relative(time, 3e-15, "eight ulps"));
    for(const int n : counts)
      CHECK(now.method("time", "Gauss, " + std::to_string(n) + " nodes")
            == within_relative(
                oracle::gauss(
                    n, [&](const Fifty& theta) { return rate(ball, e, theta); }, 0, theta_of(e, at)),
                1e-13, "rounded nodes and angle"));
    if(e.from_top > 0.1)
      CHECK(now.method("time", "Gauss, 32 nodes")
            == within_relative(time, 1e-13, "the rule has converged: rounded nodes and angle"));
  }
  for(const Told& now : told_at(""))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Fifty g_ = g.fifty(), one = sqrt(2 * g_ * ball.c), w = 2 * one * sqrt(asked.h.fifty());
    for(const auto& point : now.points("motion", 5))
    {
      const Fifty time = point.at("t");
      const auto angle = [&](bool rolls) {
        const auto motion = [&](const Fifty&, const exact::State& s) {
          return exact::State{s[1], rolls ? rolling_accelerations<Fifty>(ball, g_, s[0], s[1]).Phi
                                          : accelerations<Fifty>(ball, g_, s[0], s[1], 0).Phi};
        };
        const Fifty start = w / (rolls ? Fifty(sqrt(bb(ball))) : ball.k);
        return time == 0 ? Fifty(0)
                         : Fifty(exact::solve(motion, 0, {0, start}, time).y[0] / exact::pi() * 180);
      };
      CHECK(point.value("t") == between(0, 6, "one oscillation"));
      CHECK(point.value("rolling") == within(angle(true), 1e-11, "some ulps of the time"));
      CHECK(point.value("smooth") == within(angle(false), 1e-11, "some ulps of the time"));
    }
  }
}

/*!
In {{eq 2}} our copy has $c$ where $C$ must stand; it is tried on our ball, a tenth of a second after it has
passed its lowest place with $h = 3$.
*/

exact::State our_motion(const Fifty&, const exact::State& s)
{
  return {s[1], rolling_accelerations<Fifty>(our_ball<Fifty>, our_g<Fifty>, s[0], s[1]).Phi};
}

const exact::State& a_tenth_later()
{
  static const Fifty zeta = sqrt(24 * our_g<Fifty> * our_ball<Fifty>.c / bb(our_ball<Fifty>));
  static const exact::State there = exact::solve(our_motion, 0, {0, zeta}, Fifty(1) / 10).y;
  return there;
}

double two_dt(double C)  // (2) over dΦ, our ball
{
  const double u = double(cos(a_tenth_later()[0]));
  return std::sqrt(1.37 - 0.2 * u) / std::sqrt(C + 0.1 * u);
}

const Emendation C_for_c{"§28, the lower root",
                         {"c + c cos Φ", [] { return two_dt(0.1); }},
                         {"C + c cos Φ", [] { return two_dt(0.5); }},
                         "the line before has C, and the motion of our ball that velocity",
                         [](double reading) {
                           return reading
                                  == within_relative(2 * sqrt(our_g<Fifty>) / a_tenth_later()[1], 1e-13,
                                                     "2√g dt/dΦ of the motion");
                         }};

/*!
## Go on from here

::: exercise
A hoop without weight carries a heavy point on its rim, $c = a$ and $k = 0$. How long does it take, rolling,
from the lowest place to rest?
answer: In {{eq 2}} the upper root is then $2a\sin\frac12\Phi$, and with $\cos\frac12\Phi$ for the variable
all is elementary, whatever the energy: $t\sqrt{2gc} = 2a\operatorname{artanh}\sqrt h$. Very small swings take
no time at all. `--c 1 --k 1e-9` comes near it.
:::
*/

CHECK_THAT("with c = a the quarter of a period tends to 2a artanh √h as k vanishes, for every energy")
{
  for(const Fifty& h : {Fifty(1e-6), Fifty(1) / 2, Fifty(1) - 1e-6})
    CHECK(rolling::quarter(Ball<Fifty>{3, 3, 1e-15}, energy(h))
          == within_relative(6 * atanh(sqrt(h)), 1e-20, "what is left is of the order kk l k"));
}
