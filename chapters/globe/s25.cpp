#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/asked.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 25, "The motion of the ball that rolls")

using namespace globe;

/*!
## What Euler does

The motion itself does not wait for the friction: one equation has neither it nor the pressure, and it can be
integrated. That equation, from {{sec globe.09}}, holds in every case; with $dds = a\,dd\Phi$ it becomes one
of $\Phi$ alone,

$$ \begin{aligned} &a\,dd\Phi(a - c\cos\Phi) \\ &\quad + dd\Phi(cc - ac\cos\Phi + kk) \\
   &\quad + ac\,d\Phi^2\sin\Phi = -2cg\,dt^2\sin\Phi, \end{aligned} \tag{1} $$

or, collected,

$$ \begin{aligned} &(aa+cc+kk)\,dd\Phi - 2ac\,dd\Phi\cos\Phi \\
   &\quad + ac\,d\Phi^2\sin\Phi = -2cg\,dt^2\sin\Phi. \end{aligned} \tag{2} $$

Multiplied by $2d\Phi$ it integrates of itself: the first two members with the third are the differential of
$d\Phi^2(aa+cc+kk-2ac\cos\Phi)$, and the right side that of $4cg\,dt^2\cos\Phi$. So

$$ \begin{aligned} (aa+cc+kk&-2ac\cos\Phi)\,d\Phi^2 \\
   &= 4g\,dt^2(C + c\cos\Phi), \end{aligned} \tag{3} $$

with a constant $C$, here a length, which is to be settled by what the friction allows; {{sec globe.27}}
will ask how great it may be.

::: margin
Today: conservation of energy. $aa+cc+kk-2ac\cos\Phi$ is, over the mass, the moment of inertia about the
point of contact, which is at rest.
:::

What has been found is the living force, though Euler does not say so. With $ds = a\,d\Phi$ the left side is

$$ dx^2 + dy^2 + kk\,d\Phi^2, \tag{A} $$

what it was in {{sec globe.12}} on a smooth plane: friction that holds without scraping takes nothing away.
As there, the constant is better replaced by $h$, the living force at the lowest place over what it takes to
stand still at the top:

$$ \begin{gathered} C = c(2h-1), \\
   4g(C + c\cos\Phi) = 8gc(h - \sin^2\tfrac12\Phi). \end{gathered} \tag{B} $$

With $C < c$ the ball rocks up to $\cos\Phi = -C/c$, with $C > c$ it rolls on for ever, and $C = c$ is the
case between.

In one thing rolling is simpler than sliding. The acceleration from {{eq 2}} and {{eq 3}} is

$$ \frac{dd\Phi}{dt^2} = -\frac{2gc\,(aa+cc+kk+2aC)\sin\Phi}{(aa+cc+kk-2ac\cos\Phi)^2}, \tag{C} $$

and $aa+cc+kk+2aC$ is positive, being $(a-c)^2 + kk + 4ach$. So a ball that rolls loses velocity all the
way from the lowest place to the top, with whatever energy. On a smooth plane that is so only up to
$h = 1 + kk/4cc$; with more it would quicken again before the top, and it is just there that it leaves the
plane ({{sec globe.23}}).

## The program

The energy may be given as $h$, as what it lacks of 1, or as the angular velocity ζ at the lowest place.
*/

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto asked = asked_energy(3);
const auto where = asked_place(60_deg);

template <class Real>
Real unit(const Ball<Real>& ball)  // one second in the measure of τ
{
  using std::sqrt;
  return sqrt(2 * static_cast<Real>(g.fifty())) * sqrt(ball.c);
}

template <class Real>
Real rolling_velocity(const Ball<Real>& ball, const Energy<Real>& e, const Place<Real>& at)  // (3)
{
  using std::sqrt;
  return sqrt(rolling::velocity_squared(ball, e, at)) * unit(ball);
}

Fifty rolling_acceleration(const Ball<Fifty>& ball, const Energy<Fifty>& e, const Place<Fifty>& at)  // (C)
{
  const Fifty ac = 4 * ball.a * ball.c, D = bb(ball) + ac * at.s * at.s;
  return 0 - 4 * g.fifty() * (ball.c / D) * ((bb(ball) + ac * e.h) / D) * at.s * at.c;
}

template <class Real>
Real smooth_velocity(const Ball<Real>& ball, const Energy<Real>& e, const Place<Real>& at)
{
  using std::sqrt;
  return sqrt(smooth::velocity_squared(ball.c, ball.k, e, at)) * unit(ball);
}

TELL
{
  require(c <= 100 * k, "c", "at most a hundred times k");
  const Ball<Fifty> ball = exact_ball(a, c, k);
  const Energy<Fifty> e = asked.rolling(a, c, k, g);
  const Place<Fifty> there = where.fifty();
  require(gets_to(e, there), where.psi == 0 ? "Phi" : "psi", "an angle that the ball gets to");
  tell("energy", double(e.h), "h, the energy as a part of what the top asks for");
  tell("C", double(ball.c * (e.h - e.from_top)), feet, "Euler's constant C, by (B)");
  tell("w_low", double(velocity_of_energy<Fifty>(ball.c, bb(ball), g.fifty(), e)), Unit{"1/s"},
       "dΦ/dt at the lowest place");
  tell("w", double(rolling_velocity(ball, e, there)), Unit{"1/s"}, "dΦ/dt at Φ");
  tell("turning", double(rolling_acceleration(ball, e, there)), Unit{"1/s²"}, "ddΦ/dt² at Φ");
  tell("w_end", e.turns_over() ? double(rolling_velocity(ball, e, {1, 0})) : 0., Unit{"1/s"},
       "dΦ/dt at the end of the way up");
  tell("end", e.turns_over() ? std::numbers::pi : double(2 * atan2(sqrt(e.h), sqrt(e.from_top))), degrees,
       "and where that is");
  tell("top_share", double(pow(ball.a + ball.c, 2) / BB(ball)), percent,
       "of the living force at the top, that of the progress");
  tell("w_smooth", double(smooth_velocity(ball, e, there)), Unit{"1/s"},
       "dΦ/dt at Φ on a smooth plane, with this h");
}

TELL
{
  auto& way = table("way", "The way up, in six parts",
                    {{"Phi", "Φ", degrees},
                     {"rolling", "rolling, dΦ/dt", Unit{"1/s"}},
                     {"forward", "of the living force, forward", percent},
                     {"smooth", "smooth, dΦ/dt", Unit{"1/s"}}});
  const Ball<double> ball = rounded_ball(a, c, k);
  const Energy<double> e = rounded(asked.rolling(a, c, k, g));
  for(int n = 0; n <= 6; ++n)
  {
    const double part = std::sqrt(std::min(e.h, 1.)) * std::sin(n * std::numbers::pi / 12);
    const Place<double> at =
        n < 6 ? Place<double>{part, std::sqrt((1 - part) * (1 + part))}
              : Place<double>{std::sqrt(std::min(e.h, 1.)), std::sqrt(std::max(e.from_top, 0.))};
    // dx² over (A): dx is a − c cos Φ times dΦ, the height of G
    const double y = ball.gap + 2 * c * at.s * at.s,
                 share = y / std::sqrt(bb(ball) + 4 * a * c * at.s * at.s);
    const bool rests = n == 6 && !e.turns_over();
    way.row({2 * std::atan2(at.s, at.c), rests ? 0. : rolling_velocity(ball, e, at), share * share,
             rests ? 0. : smooth_velocity(ball, e, at)});
  }
}

TELL
{
  curve("portrait", {"Phi_deg", "rolling", "smooth", "h"}, [](Curve& portrait) {
    const Ball<double> ball = rounded_ball(a, c, k);
    for(const double h : {0.5, 1.0, 2.0})
    {
      if(h > 0.5)
        portrait.block();
      const double end = 2 * std::asin(std::sqrt(std::min(h, 1.)));
      for(int n = -60; n <= 60; ++n)
      {
        const Place<double> at = place(std::abs(end * std::sin(n * std::numbers::pi / 120)));
        const bool rests = std::abs(n) == 60 && h <= 1;
        portrait.put({end * std::sin(n * std::numbers::pi / 120) * 180 / std::numbers::pi,
                      rests ? 0 : rolling_velocity(ball, energy(h), at),
                      rests ? 0 : smooth_velocity(ball, energy(h), at), h});
      }
    }
  });
}

/*!
With $h = {{energy}}$, for Euler $C = {{C}}$ foot, our ball rolls through its lowest place with {{w_low|4}}
radians a second and over the top with {{w_end|4}}. At 60° it has {{w|4}}; on a smooth plane, with so much
more energy than the top asks for too, it would turn with {{w_smooth|4}}.

{{table way}}

::: figure globe-25
alt: Angular velocity against angle for three energies, rolling and on a smooth plane. Each family has an
oval, two arcs that meet at 180°, and a wave above and below; that of the smooth plane lies outside.

The velocity at every angle, with half the energy for the top, just that energy, and twice as much: rolling
(blue) and on a smooth plane (grey). The middle ones part rocking from turning over.
:::

## Checks

The integral is held against the equations of motion, and its left side against the living force of
{{sec globe.12}}.
*/

Fifty square_by_3(const Ball<Fifty>& ball, const Fifty& C, const Fifty& Phi)  // (3), dΦ²/dt²
{
  const Fifty &a_ = ball.a, &c_ = ball.c, &k_ = ball.k;
  return 4 * g.fifty() * (C + c_ * cos(Phi)) / (a_ * a_ + c_ * c_ + k_ * k_ - 2 * a_ * c_ * cos(Phi));
}

CHECK_THAT("the equations of motion, followed from the lowest place, keep to (3); (A) is its left side")
{
  for(const Told& now : told_at("", "c=0.5 k=0.5 g=0.5 h=0.9 Phi=30", "c=3 h=0.2 Phi=10"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Fifty h = asked.h.fifty(), C = ball.c * (2 * h - 1);
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1], rolling_accelerations<Fifty>(ball, g.fifty(), s[0], s[1]).Phi};
    };
    const Fifty low = sqrt(8 * g.fifty() * ball.c * h / bb(ball));
    CHECK(now.value("w_low", Unit{"1/s"}) == within_relative(low, 2e-15, "eight roundings"));
    for(const Fifty& t : {Fifty("0.1"), Fifty("0.3")})
    {
      const auto there = exact::solve(motion, 0, {0, low}, t).y;
      const Fifty& Phi = there[0];
      const Fifty ww = there[1] * there[1];
      CHECK(ww == within_relative(square_by_3(ball, C, Phi), 1e-27, "the solver's bound"));
      const Fifty dx = (ball.a - ball.c * cos(Phi)) * there[1], dy = ball.c * sin(Phi) * there[1];
      CHECK(dx * dx + dy * dy + ball.k * ball.k * ww  // (A)
            == within_relative(4 * g.fifty() * (C + ball.c * cos(Phi)), 1e-27, "the solver's bound"));
    }
  }
}

CHECK_THAT(
    "where the ball turns back it has no velocity, and beyond it is not told of, however near the top")
{
  for(const Told& now : told_at("h=0.5 Phi=90", "h=0.25 Phi=60"))
  {
    CHECK(now.value("w", Unit{"1/s"}) == within(0, 0, "at rest"));
    CHECK(now.value("w_smooth", Unit{"1/s"}) == within(0, 0, "at rest"));
  }
  for(const char* const within_them : {"h=0.25 Phi=60", "from_top=1e-300 psi=2e-150rad"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"h=0.25 Phi=60.00000000000000000001", "from_top=1e-300 psi=1.99999999999999999999e-150rad"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("a ball whose c is more than a hundred times k is refused, and one whose c is just that is not")
{
  for(const char* const within_them : {"c=100 k=1", "c=200 k=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"c=100.00000000000001 k=1", "c=200.00000000000003 k=2"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("a ζ is refused together with 1 − h, and where its h is less than 1e-100 or more than 1e100")
{
  for(const char* const within_them : rolling_within)
    CHECK(!refused_at(within_them + std::string(" Phi=0")));
  for(const char* const beyond : rolling_beyond)
    CHECK(refused_at(beyond + std::string(" Phi=0")));
}

CHECK_THAT("the velocities told are (3) and the acceleration is that of the equations of motion")
{
  for(const Told& now : told_at("", "c=0.5 k=0.5 g=0.5 h=0.9 Phi=30", "c=3 h=0.2 Phi=10",
                                "from_top=1e-30 psi=1e-14rad g=1e40", "from_top=-1e-30 psi=1e-14rad c=1e-8",
                                "a=1e60 c=1e58 k=1e60 h=1e-40 Phi=1e-21rad", "zeta=12"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Energy<Fifty> e = asked.rolling(a, c, k, g);
    const Place<Fifty> at = where.fifty();
    const Fifty Phi = where.angle(), C = ball.c * (e.h - e.from_top), g_ = g.fifty();
    // h − sin² ½Φ loses what the two have in common; of the place an ulp is left
    const Fifty left = e.h < 0.5 ? Fifty(e.h - at.s * at.s) : Fifty(at.c * at.c - e.from_top),
                common = e.h < 0.5 ? e.h : abs(e.from_top) + at.c * at.c;
    const double slack = 4e-15 + 1e-15 * double(common / left);
    const Fifty w = sqrt(8 * g_ * ball.c * left / (bb(ball) + 4 * ball.a * ball.c * at.s * at.s));
    CHECK(w * w
          == within(square_by_3(ball, C, Phi), 1e-47 * double(8 * g_ * ball.c * (1 + e.h) / bb(ball)),
                    "(B)"));
    CHECK(now.value("energy") == within_relative(e.h, 2e-16, "rounded once"));
    CHECK(now.value("C", feet) == within(C, 4e-16 * double(ball.c * (1 + e.h)), "three roundings"));
    CHECK(now.value("w", Unit{"1/s"})
          == within_relative(w, slack, "some roundings, and what is in common"));
    CHECK(
        now.value("turning", Unit{"1/s²"})
        == within_relative(rolling_accelerations<Fifty>(ball, g_, Phi, w).Phi, 1e-14, "a dozen roundings"));
    CHECK(now.value("w_low", Unit{"1/s"})
          == within_relative(sqrt(8 * g_ * ball.c * e.h / bb(ball)), 2e-15, "eight roundings"));
    CHECK(now.value("w_end", Unit{"1/s"})
          == within_relative(e.turns_over() ? Fifty(sqrt(8 * g_ * ball.c * -e.from_top / BB(ball)))
                                            : Fifty(0),
                             3e-15, "(3) at the top, or rest"));
    CHECK(now.value("top_share", percent)
          == within_relative(pow(ball.a + ball.c, 2) / BB(ball), 1e-15, "(A)"));
    CHECK(now.value("end", degrees)
          == within_relative(e.turns_over() ? exact::pi() : Fifty(2 * asin(sqrt(e.h))), 1e-15, "(B)"));
    const Fifty s = ball.c * sin(Phi);
    CHECK(now.value("w_smooth", Unit{"1/s"})
          == within_relative(sqrt(8 * g_ * ball.c * left / (ball.k * ball.k + s * s)), slack, "§11"));
  }
}

CHECK_THAT(
    "a ball that rolls is slowed all the way up whatever its energy, by (C) as by Newton's equations; on "
    "a smooth plane only up to h = 1 + kk/4cc")
{
  for(const Ball<Fifty>& ball : {our_ball<Fifty>, cradle<Fifty>, Ball<Fifty>{1, 3, Fifty(1) / 10}})
  {
    const Fifty limit = 1 + ball.k * ball.k / (4 * ball.c * ball.c);
    for(const Fifty& h : {Fifty((1 + limit) / 2), Fifty(2 * limit), Fifty(1000)})
      for(int n = 1; n < 60; ++n)
      {
        const Fifty Phi = n * exact::pi() / 60, C = ball.c * (2 * h - 1), g_ = g.fifty();
        const Fifty w = sqrt(square_by_3(ball, C, Phi)),
                    D = bb(ball) + 2 * ball.a * ball.c * (1 - cos(Phi));
        const Fifty turning = rolling_accelerations<Fifty>(ball, g_, Phi, w).Phi;
        CHECK(
            turning  // (C)
            == within_relative(-2 * g_ * ball.c * (bb(ball) + 4 * ball.a * ball.c * h) * sin(Phi) / (D * D),
                               1e-40, "fifty digits"));
        CHECK(turning < 0);
      }
    for(const int sign : {-1, 1})
    {
      const Fifty Phi = exact::pi() - Fifty("1e-6"), h = limit + sign * (limit - 1) / 1000,
                  s = ball.c * sin(Phi);
      const Fifty ww = 4 * g.fifty() * ball.c * (2 * h - 1 + cos(Phi)) / (ball.k * ball.k + s * s);
      CHECK((accelerations<Fifty>(ball, g.fifty(), Phi, sqrt(ww), 0).Phi > 0) == (sign > 0));
    }
  }
}

CHECK_THAT("the way and the portrait are (3), and §11 on a smooth plane")
{
  const auto square_smooth = [](const Fifty& h, const Fifty& Phi) {
    const Fifty s = c.fifty() * sin(Phi);
    return Fifty(4 * g.fifty() * c.fifty() * (2 * h - 1 + cos(Phi)) / (k.fifty() * k.fifty() + s * s));
  };
  for(const Told& now : told_at("", "c=0.5 k=0.5 g=0.5 h=0.9 Phi=30", "a=1e60 c=1e58 k=1e60 h=1e-10 Phi=0"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Energy<Fifty> e = asked.rolling(a, c, k, g);
    const Fifty C = ball.c * (2 * e.h - 1), most = e.h < 1 ? Fifty(2 * asin(sqrt(e.h))) : exact::pi();
    int n = 0;
    for(const auto& row : now.rows("way"))
    {
      const Fifty Phi = 2 * asin(sin(most / 2) * sin(n * exact::pi() / 12));
      const Fifty y = ball.a - ball.c * cos(Phi), x = ball.c * sin(Phi);
      const double unit = std::sqrt(double(8 * g.fifty() * ball.c * e.h / bb(ball)));
      const double here = n == 6 ? 1e-10 : 1e-14;  // at rest the square is nothing in fifty digits
      CHECK(row.value("Phi", degrees)
            == within_relative(Phi, n == 6 ? 1e-15 : 3e-15, "an arc of a rounded sine"));
      CHECK(row.value("rolling", Unit{"1/s"})
            == within(sqrt(abs(square_by_3(ball, C, Phi))), here * unit, "some roundings"));
      CHECK(row.value("smooth", Unit{"1/s"})
            == within(sqrt(abs(square_smooth(e.h, Phi))), 10 * here * unit, "some roundings"));
      CHECK(row.value("forward", percent)
            == within_relative(y * y / (y * y + x * x + ball.k * ball.k), 1e-14, "dx² over (A)"));
      ++n;
    }
  }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("portrait", 13))
    {
      const Ball<Fifty> ball = exact_ball(a, c, k);
      const Fifty h = point.at("h"), Phi = Fifty(point.at("Phi_deg")) / 180 * exact::pi();
      CHECK(point.value("h") == between(0.5, 2, "the three energies"));
      CHECK(point.value("Phi_deg") == between(-180, 180, "all round"));
      CHECK(point.value("rolling")
            == within(sqrt(abs(square_by_3(ball, ball.c * (2 * h - 1), Phi))), 1e-6, "a root near rest"));
      CHECK(point.value("smooth") == within(sqrt(abs(square_smooth(h, Phi))), 1e-6, "a root near rest"));
    }
}

/*!
## Go on from here

::: exercise
Of the living force, {{eq A}}, one part is the progress of $G$ forwards. Where has a rolling ball the greatest
share of it there?

answer: The share is $yy/(yy + cc\sin^2\Phi + kk)$, and with $c < a$ it is greatest at the top, where $y$ is
greatest and $\sin\Phi = 0$; in the table it comes to {{top_share|3}}. It does not depend on the energy.
:::
*/
