#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/asked.hpp"
#include "globe/ball.hpp"
#include "globe/oracle.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 11, "The angular velocity")

using namespace globe;

/*!
## What Euler does

Multiplied by $2d\Phi$ the equation of the smooth plane can be integrated, and gives how fast the ball
turns in every position. That equation, of {{sec globe.10}}, was

$$ \begin{aligned} kk\,dd\Phi &+ cc\,dd\Phi\sin^2\Phi\\ &+ cc\,d\Phi^2\sin\Phi\cos\Phi\\
   &= -2gc\,dt^2\sin\Phi. \end{aligned} $$

Its first member times $2d\Phi$ is the differential of $kk\,d\Phi^2$; the second and the third together are
that of $cc\,d\Phi^2\sin^2\Phi$; and the right side is that of $4gc\,dt^2\cos\Phi$. So, with a constant
$\Gamma$,

$$ kk\,d\Phi^2 + cc\,d\Phi^2\sin^2\Phi = 4g\,dt^2(c\cos\Phi + \Gamma), \tag{1} $$

$$ \frac{d\Phi^2}{dt^2} = \frac{4g(c\cos\Phi + \Gamma)}{kk + cc\sin^2\Phi}, \tag{2} $$

which is the square of the angular velocity. The constant follows from the start. If the ball is given the
angular velocity ζ in the sense $SAB$ where $\Phi = 0$, then

$$ \zeta\zeta = \frac{4g(c+\Gamma)}{kk}, \qquad 4g\Gamma = \zeta\zeta kk - 4gc, \tag{3} $$

$$ \frac{d\Phi^2}{dt^2} = \frac{4gc\cos\Phi + \zeta\zeta kk - 4gc}{kk + cc\sin^2\Phi}. \tag{4} $$

::: margin
Today: an integral of energy, with the mass matrix $k^2 + c^2\sin^2\theta$, which grows with the angle
because $G$ has to go up and down as the ball turns.
:::

Neither $f$ nor the radius $a$ is in it: the progress leaves the turning alone. Euler asks no more of
{{eq 4}} here, but all that follows depends on one number in it. Let $h$ be the energy at the lowest place
over what it takes to stand still at the top; then $\Gamma = c(2h-1)$ and

$$ h = \frac{\zeta\zeta kk}{8gc}, \quad
   \frac{d\Phi^2}{dt^2} = \frac{8gc\,(h - \sin^2\frac12\Phi)}{kk + cc\sin^2\Phi}. \tag{A} $$

If $\Gamma < c$, that is $h < 1$, the ball rocks and turns back where $\sin^2\frac12\Phi = h$; if
$\Gamma > c$, it turns over and over; with $\Gamma = c$ it just has the velocity for the top
({{sec globe.16}}).

And is the ball that turns over slowest at the top? In {{eq A}} both numerator and denominator fall from
90° on. With $u = \cos\Phi$, $m = 2h - 1$ and $rr = 1 + kk:cc$ the square is as $(m+u):(rr-uu)$, and that
is least where $uu + 2mu + rr = 0$,

$$ \cos\Phi = -m + \sqrt{mm - rr}, \tag{B} $$

an angle below 180° only if $h$ exceeds $1 + kk:4cc$. Beyond it {{eq 4}} would have the ball quicken while
its centre of gravity still goes up. Only a plane that pulls could do that, for by {{sec globe.10}}
nothing turns the ball but the pressure: where the velocity would be least the pressure is none, and the
ball leaves the plane.

## The program

The velocity is reckoned by {{eq A}}, which loses nothing near the top or for the smallest motions.
*/

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto asked = asked_energy(2);
const auto where = asked_place(60_deg);

Fifty velocity(const Energy<Fifty>& e, const Place<Fifty>& there)  // (A)
{
  const Fifty c_ = c.fifty();
  return sqrt(2 * g.fifty() * c_ * smooth::velocity_squared<Fifty>(c_, k.fifty(), e, there));
}

Fifty farthest(const Energy<Fifty>& e)
{
  return e.turns_over() ? exact::pi() : Fifty(2 * atan2(sqrt(e.h), sqrt(e.from_top)));
}

double slowest(const Energy<Fifty>& e)  // (B), where it is below 180°; else the end of the way
{
  const Fifty more = e.h - smooth::lift_off_energy<Fifty>(c.fifty(), k.fifty());
  return more > 0 ? smooth::lift_off<double>(c, k, double(more)).Phi : double(farthest(e));
}

TELL
{
  require(c <= 1e6 * k, "c", "between 1e-40 and a million times k");
  require(k <= 1e40 * c, "c", "between 1e-40 and a million times k");
  const Fifty c_ = c.fifty(), kk = k.fifty() * k.fifty(), g_ = g.fifty();
  const Energy<Fifty> e = asked.fifty(c_, kk, g_);
  const Place<Fifty> there = where.fifty();
  require(gets_to(e, there), where.psi == 0 ? "Phi" : "psi", "an angle that the ball gets to");
  tell("energy", double(e.h), "h, the energy as a part of what the top asks for");
  tell("Gamma", double(c_ * (e.h - e.from_top)), feet, "Γ, the constant");
  tell("zeta_0", double(velocity_of_energy<Fifty>(c_, kk, g_, e)), Unit{"1/s"},
       "ζ, the angular velocity at the lowest place");
  tell("w", double(velocity(e, there)), Unit{"1/s"}, "the angular velocity at Φ, by (4)");
  tell("farthest", double(farthest(e)), degrees, "how far the ball turns; 180° where it turns over");
  tell("slowest", slowest(e), degrees, "where it turns slowest on its way up");
  tell("h_lift", smooth::lift_off_energy<double>(c, k), "the h beyond which that is below the top");
}

TELL
{
  curve("portrait", {"Phi", "h_a", "h_b", "top", "h_c", "h_lift", "h_d", "none"}, [](Curve& portrait) {
    const double lift = smooth::lift_off_energy<double>(c, k), unit = std::sqrt(8 * g) * std::sqrt(c) / k;
    for(int n = 0; n <= 360; ++n)
    {
      const double Phi = (n - 180) * 1_deg;
      const auto there = n % 360 == 0 ? place_from_top(0.) : place(std::abs(Phi));
      std::vector<double> row{n - 180.};
      for(const double h : {0.2, 0.6, 1., (1 + lift) / 2, lift, 1.5 * lift})
      {
        const double left = smooth::velocity_squared<double>(1, k / c, energy(h), there);
        row.push_back(std::sqrt(std::max(left, 0.)) * (k / c) / 2);
      }
      row.push_back(std::abs(n - 180) > 90 ? std::sqrt(2 * g) / std::sqrt(-c * std::cos(Phi)) / unit : 0);
      portrait.put(row);
    }
  });
}

/*!
With twice the energy for the top the ball starts with {{zeta_0|6}} radians a second, and has {{w|6}} at
60°. Its slowest place is the top, as long as $h$ is not more than {{h_lift|6}}.

::: figure globe-11
alt: Angular velocity against the angle, upper half. Closed arches about the lowest place for the balls
that rock; an arch from top to top for the one with just the velocity for it; waves above. A grey line
that comes down towards the top on either side cuts the highest wave in its lowest points.

The angular velocity {{eq 4}} against the angle, in units of the ζ of Case II, for six energies. The arches
rock, the waves turn over, and {{eq 4}} with $\Gamma = c$ (red) parts them. On the grey line there is no
pressure: the waves that cut it have their lowest points there, and above it {{eq 4}} is void.
:::

## Checks

The velocities are held against the equations of motion of {{sec globe.06}}, which know of no integral,
and near the top against {{eq 4}} in fifty digits.
*/

CHECK_THAT("the velocity told is what the equations of motion bring about, at the angle asked for")
{
  for(const Told& now : told_at("", "h=0.7 Phi=100 c=0.5", "zeta=15 Phi=150", "from_top=-0.01 psi=1 k=2"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), second = sqrt(2 * g_ * c_);
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g_);
    const Ball<Fifty> ball{c_ + k_, c_, k_};
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1], accelerations<Fifty>(ball, g_, s[0], s[1], 0).Phi};
    };
    const Fifty start = 2 * second * sqrt(e.h) / k_;  // 4g(c + Γ) = ζζkk
    const Fifty t = oracle::smooth_time(c_, k_, e, where.fifty()) / second;
    const exact::State there = exact::solve(motion, 0, {0, start}, t).y;
    CHECK(there[0] == within(where.angle(), 1e-27, "some hundred steps of 1e-32, and the way to the top"));
    CHECK(now.value("w", Unit{"1/s"}) == within_ulps(there[1], 1, "rounded once"));
    CHECK(now.value("zeta_0", Unit{"1/s"}) == within_ulps(start, 1, "rounded once"));
  }
}

CHECK_THAT("the numbers told are (3) and (4), and the turning points their zeros, at every scale")
{
  for(const Told& now : told_at("", "from_top=1e-15 psi=1e-3", "zeta=40 Phi=120", "h=1e-30 Phi=1e-20 c=3",
                                "h=1.3 c=5 k=4 g=1e-90 Phi=180"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), at = where.angle();
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g_);
    const Fifty Gamma = 2 * c_ * e.h - c_, r2 = 1 + pow(k_ / c_, 2), m = Gamma / c_;
    const Fifty half = sin(at / 2), turns = 4 * g_ * (c_ + Gamma - 2 * c_ * half * half);  // (4)
    CHECK(now.value("energy") == within_ulps(e.h, 1, "rounded once"));
    CHECK(now.value("Gamma", feet) == within_ulps(Gamma, 1, "rounded once"));
    CHECK(now.value("zeta_0", Unit{"1/s"})
          == within_relative(sqrt(4 * g_ * (c_ + Gamma)) / k_, 2e-16, "rounded once"));
    CHECK(now.value("w", Unit{"1/s"})
          == within_relative(sqrt(turns) / sqrt(k_ * k_ + pow(c_ * sin(at), 2)), 2e-16, "rounded once"));
    const Fifty end = e.h < 1 ? acos(-m) : exact::pi();
    CHECK(now.value("farthest", degrees)
          == within(end, 2e-16 * double(end) + 1e-25, "rounded once; acos keeps half of fifty digits"));
    CHECK(now.value("h_lift") == within_ulps((3 + r2) / 4, 3, "a square and a sum"));
    const Fifty least = -m + sqrt(std::max(Fifty(m * m - r2), Fifty(0)));  // (B)
    CHECK(now.value("slowest", degrees)
          == within_relative(e.h > (3 + r2) / 4 ? Fifty(acos(least)) : end, 2e-15,
                             "the library's eight ulps"));
  }
}

CHECK_THAT("it refuses a c, an energy and an angle just beyond its limits, and none on them")
{
  // With c = 1/8 and g = k = 1 h is ζζ; with h = 1/4 the ball gets to 60°, with 3/4 to 120°.
  for(const char* const beyond :
      {"c=1000000.0000000002 k=1", "c=500000.0000000001 k=0.5", "c=0.9999999999999998 k=1e40",
       "c=1.9999999999999996 k=2e40", "from_top=0.5 zeta=1e-300",
       "c=0.125 g=1 k=1 Phi=0 zeta=9.9999999999999999e-51", "c=0.125 g=1 k=1 zeta=1.0000000000000001e50",
       "h=0.25 Phi=60.00000000000001", "h=0.75 Phi=120.00000000000001", "h=0.25 psi=119.99999999999999"})
    CHECK(refused_at(beyond));
  for(const char* const within_them :
      {"c=1e6 k=1", "c=5e5 k=0.5", "c=1 k=1e40", "c=2 k=2e40", "from_top=0.5",
       "c=0.125 g=1 k=1 Phi=0 zeta=1.0000000000000001e-50", "c=0.125 g=1 k=1 zeta=1e50", "h=0.25 Phi=60",
       "h=0.75 Phi=120", "h=0.25 psi=120"})
    CHECK(!refused_at(within_them));
}

CHECK_THAT("where (4) has its least velocity there is no pressure, and the acceleration changes its sign")
{
  for(const Told& now : told_at("zeta=40", "h=12", "h=1.3 c=5 k=4"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty();
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g_);
    const Fifty m = 2 * e.h - 1, Phi = acos(-m + sqrt(m * m - 1 - pow(k_ / c_, 2)));
    const auto with = [&](const Fifty& at) {
      return accelerations<Fifty>(Ball<Fifty>{c_ + k_, c_, k_}, g_, at, velocity(e, place(at)), 0);
    };
    CHECK(now.value("slowest", degrees) == within_relative(Phi, 2e-15, "the library's eight ulps"));
    CHECK(with(Phi).pressure == within(0, 1e-40, "fifty digits"));
    CHECK(with(Phi - 1e-6).Phi < 0);
    CHECK(with(Phi + 1e-6).Phi > 0);
  }
}

CHECK_THAT("the portrait is (4), in units of the ζ of Case II, and its grey line the one without pressure")
{
  for(const Told& now : told_at("", "c=0.5"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), lift = 1 + pow(k_ / c_, 2) / 4;
    const std::array<const char*, 6> names{"h_a", "h_b", "top", "h_c", "h_lift", "h_d"};
    const std::array<Fifty, 6> h{Fifty(0.2), Fifty(0.6), 1, (1 + lift) / 2, lift, lift * 3 / 2};
    for(const auto& point : now.points("portrait", 9))
    {
      CHECK(point.value("Phi") == between(-180, 180, "one turn"));
      const Fifty u = cos(point.at("Phi") * exact::pi() / 180);
      for(std::size_t i = 0; i < names.size(); ++i)
      {
        const Fifty square = (2 * h[i] - 1 + u) / (2 * (1 + pow(c_ / k_, 2) * (1 - u * u)));
        CHECK(
            point.value(names[i])
            == within(sqrt(std::max(square, Fifty(0))), 4e-15 * double(h[i]), "the library's eight ulps"));
      }
      // Π = 0: c w² cos Φ = −2g, over the square 8gc:kk of the unit
      const Fifty none = u < -1e-9 ? Fifty(k_ / (2 * c_ * sqrt(-u))) : Fifty(0);
      CHECK(point.value("none")
            == within(none, 1e-14 * double(none), "some roundings, an ulp of the angle"));
    }
  }
}

/*!
## Go on from here

::: exercise
On its way from the lowest place to 90° a ball with $h = 1$ loses half of its energy to the rise of $G$.
What part of its angular velocity does it lose, if $c = k$?
answer: By {{eq A}} the square of the velocity falls from $8gc:kk$ to $4gc:(kk+cc)$, a quarter of that; it
loses half of its velocity. The other half of the energy that is left is in the rising of $G$
({{sec globe.12}}). `--h 1 --c 0.6 --Phi 90` says so.
:::
*/

CHECK_THAT("with c = k and h = 1 half of the velocity is left at 90°")
{
  for(const Told& now : told_at("h=1 c=0.6 Phi=90"))
    CHECK(now.value("w", Unit{"1/s"})
          == within_relative(sqrt(2 * g.fifty() / c.fifty()), 2e-16, "half of √(8g:c), rounded once"));
}
