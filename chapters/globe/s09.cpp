#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/path.hpp"
#include "globe/rolling.hpp"

SECTION(globe, 9, "One equation for every case")

using namespace globe;

/*!
## What Euler does

If λ were eliminated from the two equations of {{sec globe.08}}, there would remain one that fits all cases
alike; it is obtained more conveniently from the three original ones. The first is multiplied by
$y = a - c\cos\Phi$, the second by $c\sin\Phi$, and both products are added to the third. Then λ and Π go
out together:

$$ \frac{y\,ddx + c\,ddy\sin\Phi + kk\,dd\Phi}{2g\,dt^2} = -c\sin\Phi. \tag{1} $$

With the values of $x$ and $y$ put in, this becomes

$$ \begin{aligned} &dds\,(a - c\cos\Phi)\\ &\quad + dd\Phi\,(cc - ac\cos\Phi + kk)\\
   &\quad + ac\,d\Phi^2{{entry square}}\sin\Phi = -2gc\,dt^2\sin\Phi. \end{aligned} \tag{2} $$

But three variables are still in it, and so nothing can be concluded from it for the purpose. A fuller
solution is therefore to be tried in particular cases; and there are two, that of a plane without friction
and that of perfect rolling.

::: margin
Today: the moment of momentum about the point of contact. Pressure and friction act there and have no
moment.
:::

What was thrown out is the plane. Forces that act at $S$ have no moment about $S$, and $-Pc\sin\Phi$ is that
of the weight. So {{eq 1}} may be said in one breath: the masses of the ball times their accelerations have
about $S$ the moment of its weight. It is tempting to read it as “what the moment of momentum about $S$,

$$ H = y\frac{dx}{dt} + c\frac{dy}{dt}\sin\Phi + kk\frac{d\Phi}{dt}, \tag{A} $$

gains in the time $dt$”; but the place $S$ moves with the velocity $ds/dt$, and $G$ rises meanwhile, so that

$$ \frac{dH}{dt} = -2gc\sin\Phi + \frac{ds}{dt}\,\frac{dy}{dt}. \tag{B} $$

About a place of the plane that stays the rest is not needed. There the moment of momentum of a homogeneous
ball, whose $G$ does not rise and has no arm, is the same for ever: it rolls in the end with five sevenths
of the velocity with which it was bowled, whatever the friction may have been on the way.

The equation is worth most where something happens. When scraping turns into rolling, friction changes at
once, and every acceleration with it; their sum in {{eq 1}} does not notice.

## The program

The three members of {{eq 1}}, for the three ways in which the ball may be carried:
*/

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the centre to the centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto Phi = angle("Phi", 60_deg, closed(-1e12_deg, 1e12_deg), "angle ACS");
const auto w = real("w", 4, Unit{"1/s"}, closed(-1e30, 1e30), "dΦ/dt, angular velocity");
const auto mu =
    real("mu", 1. / 3, none, closed(0, 1e20), "μ, friction over pressure where the ball scrapes");

struct Members
{
  Fifty forwards, upwards, turning;  // y ddx, c ddy sin Φ, kk ddΦ, over dt²

  Fifty sum() const { return forwards + upwards + turning; }
};

Members members(const Ball<Fifty>& ball, const Fifty& at, const Accelerations<Fifty>& moved)  // (1)
{
  const Fifty sine = sin(at / 2), y = (ball.a - ball.c) + 2 * ball.c * sine * sine;
  return {y * moved.x + 0, ball.c * sin(at) * moved.y, ball.k * ball.k * moved.Phi};
}

Ball<Fifty> ball()
{
  return {a.fifty(), c.fifty(), k.fifty()};
}

TELL
{
  const Ball<Fifty> b = ball();
  require(b.a + b.c < 1e20 * sqrt(bb(b)), "k", "more, or c farther from a: a + c below 1e20 b");
  require(mu.fifty() < rolling::painleve(b).mu, "mu", "below the limit of §4");
  const Fifty at = Phi.fifty(), w_ = w.fifty(), g_ = g.fifty();
  require(2 * g_ + b.c * w_ * w_ * cos(at) >= 0, "w", "such that the plane still bears the ball");
  const Unit square{"ft²/s²"};
  auto& cases = table("cases", "The members of (1), whatever carries the ball",
                      {{"plane", "the ball"},
                       {"forwards", "y ddx", square},
                       {"upwards", "c ddy sin Φ", square},
                       {"turning", "kk ddΦ", square},
                       {"sum", "their sum", square, 12}});
  const auto add = [&](const char* plane, const Accelerations<Fifty>& moved) {
    const Members all = members(b, at, moved);
    cases.row({plane, double(all.forwards), double(all.upwards), double(all.turning), double(all.sum())});
  };
  add("slides without friction", accelerations<Fifty>(b, g_, at, w_, 0));
  add("scrapes forwards", accelerations<Fifty>(b, g_, at, w_, mu.fifty()));
  add("scrapes back", accelerations<Fifty>(b, g_, at, w_, -mu.fifty()));
  add("rolls", rolling_accelerations(b, g_, at, w_));
  tell("weight", double(-2 * g_ * b.c * sin(at)), square,
       "−2gc sin Φ, the moment of the weight over the mass");
}

/*!
And along a motion: the ball bowled in {{sec globe.08}}, which scrapes and then rolls.
*/

Path<double> bowled()
{
  return {our_ball<double>, our_g<double>, 1. / 3, {0, 10, 0, 0}, 0.6};
}

TELL
{
  tell("rolls_from", bowled().events().at(1).t, seconds, "when the bowled ball begins to roll");
  curve("bowled", {"t", "forwards", "upwards", "turning", "sum"}, [](Curve& curve_) {
    const Path<double> path = bowled();
    const auto put = [&](double t, const State<double>& at, bool rolls) {
      const Ball<Fifty> b = our_ball<Fifty>;
      const Fifty g_ = our_g<Fifty>, Phi_ = at.Phi, w_ = at.w;
      const Members all = members(b, Phi_,
                                  rolls ? rolling_accelerations(b, g_, Phi_, w_)
                                        : accelerations<Fifty>(b, g_, Phi_, w_, Fifty(1) / 3));
      curve_.put({t, double(all.forwards), double(all.upwards), double(all.turning), double(all.sum())});
    };
    const double change = path.events().at(1).t;
    for(int n = 0; n <= 60; ++n)
      put(change * n / 60, path.at(change * n / 60), false);
    curve_.gap();
    for(int n = 0; n <= 60; ++n)
    {
      const double t = n == 60 ? path.ended() : change + (path.ended() - change) * n / 60;
      put(t, path.at(t), true);
    }
  });
}

/*!
Whatever carries the ball, the sum is the moment of the weight, {{weight|6}}.

{{table cases}}

::: figure globe-09
alt: Four curves against the time. Those of the three members jump, two of them far, at the moment when the
ball begins to roll; the curve of their sum runs smoothly through that moment.

The members of {{eq 1}} for the bowled ball. When it begins to roll, at {{rolls_from|4}} seconds, all three
jump; their sum (blue) goes on.
:::

## Checks

The accelerations come from the equations of Lagrange here, with the coordinates $s$ and Φ; a ball that
rolls has $s = a\Phi$ and one equation only, that of its energy.
*/

struct Rates
{
  Fifty dds, ddPhi;
};

Rates by_lagrange(const Fifty& l)  // (cc + kk) ddΦ − c u dds = −2gcv + aF, dds − c u ddΦ + c v ww = −F
{
  const Ball<Fifty> b = ball();
  const Fifty v = sin(Phi.fifty()), u = cos(Phi.fifty()), ww = pow(w.fifty(), 2), g2 = 2 * g.fifty();
  // F = l(2g + c v ddΦ + c u ww): three equations for dds, ddΦ and F, by Cramer's rule.
  const Fifty D = b.k * b.k + b.c * b.c * v * v - l * b.c * v * (b.a - b.c * u);
  const Fifty top = (b.a - b.c * u) * l * (g2 + b.c * u * ww) - g2 * b.c * v - b.c * b.c * u * v * ww;
  const Fifty turning = top / D, F = l * (g2 + b.c * v * turning + b.c * u * ww);
  return {b.c * u * turning - b.c * v * ww - F, turning};
}

Rates rolling_by_energy()  // ½(kk + xx' + yy') ww + 2gy is constant; its derivative, by Φ, is a difference
{
  const Ball<Fifty> b = ball();
  const Fifty h = 1e-12, w_ = w.fifty();
  const auto inertia = [&](const Fifty& turn) {
    const Fifty at = Phi.fifty() + turn;
    return b.k * b.k + pow(b.a - b.c * cos(at), 2) + pow(b.c * sin(at), 2);
  };
  const auto height = [&](const Fifty& turn) { return 0 - b.c * cos(Phi.fifty() + turn); };
  const Fifty turning =
      -((inertia(h) - inertia(-h)) / 2 * w_ * w_ + 2 * g.fifty() * (height(h) - height(-h)))
      / (2 * h * inertia(0));
  return {b.a * turning, turning};
}

CHECK_THAT("in all four cases the members told are Lagrange's, and their sum is the moment of the weight")
{
  for(const Told& now : told_at("", "Phi=-130 w=2 mu=0.1", "c=0.5 k=0.5 Phi=132.66 mu=0.78248 w=0",
                                "a=3e50 c=1e50 k=2e50 g=1e-50 w=1e-52 mu=0.1", "c=1 k=0.1 Phi=1e-10 mu=0"))
  {
    const Ball<Fifty> b = ball();
    const Fifty v = sin(Phi.fifty()), u = cos(Phi.fifty()), ww = pow(w.fifty(), 2);
    const Fifty y = b.a - b.c * u, weight = -2 * g.fifty() * b.c * v;
    const Unit square{"ft²/s²"};
    CHECK(now.value("weight", square) == within_relative(weight, 3e-16, "rounded once"));
    const std::array<Rates, 4> cases{by_lagrange(0), by_lagrange(mu.fifty()), by_lagrange(-mu.fifty()),
                                     rolling_by_energy()};
    const std::array<const char*, 4> names{"slides without friction", "scrapes forwards", "scrapes back",
                                           "rolls"};
    std::size_t n = 0;
    for(const auto& row : now.rows("cases"))
    {
      const auto& [dds, ddPhi] = cases.at(n);
      const Fifty ddx = dds - b.c * ddPhi * u + b.c * ww * v, ddy = b.c * ddPhi * v + b.c * ww * u;
      const Fifty all[]{y * ddx, b.c * v * ddy, b.k * b.k * ddPhi};
      const double size = double(abs(all[0]) + abs(all[1]) + abs(all[2]));
      const auto once = [&](const Fifty& expected) {
        return within(expected, 1.2e-16 * double(abs(expected)) + 1e-21 * size, "rounded once");
      };
      CHECK(row.value("plane") == names.at(n));
      CHECK(row.value("forwards", square) == once(all[0]));
      CHECK(row.value("upwards", square) == once(all[1]));
      CHECK(row.value("turning", square) == once(all[2]));
      CHECK(row.value("sum", square) == once(weight));
      // (2)
      const Fifty left = dds * y + ddPhi * (b.c * b.c - b.a * b.c * u + b.k * b.k) + b.a * b.c * ww * v;
      CHECK(left
            == within(weight, 1e-21 * size + 1e-40 * double(abs(weight)), "the step of the differences"));
      ++n;
    }
    CHECK(n == 4);
  }
}

CHECK_THAT("it refuses too little inertia with G at the surface, too much friction, and a ball that leaves "
           "the plane")
{
  for(const char* const beyond :
      {"a=5e19 c=5e19 k=1 mu=0", "mu=3.68081", "c=0.5 k=0.5 mu=0.7824837",
       "Phi=180 c=0.5 g=1 w=2.0000000000000001", "Phi=120 c=0.25 g=1 w=-4.0000000000000001"})
    CHECK(refused_at(beyond));
  for(const char* const within_them :
      {"a=5e19 c=5e19 k=1.0000000000000001 mu=0", "mu=3.6808", "c=0.5 k=0.5 mu=0.7824836",
       "Phi=180 c=0.5 g=1 w=2", "Phi=120 c=0.25 g=1 w=-3.9999999999999999"})
    CHECK(!refused_at(within_them));
}

/*!
Along the bowled ball's way the velocities come from Newton's equations in fifty digits, and {{eq B}} from
the differences of $H$ at neighbouring times.
*/

using Motion = exact::State;  // s, σ, Φ, w

Motion rates(const Motion& at, bool rolls)
{
  const Ball<Fifty> b = our_ball<Fifty>;
  const Fifty g_ = our_g<Fifty>, v = sin(at[2]), u = cos(at[2]);
  const auto moved = rolls ? rolling_accelerations(b, g_, at[2], at[3])
                           : accelerations<Fifty>(b, g_, at[2], at[3], Fifty(1) / 3);
  const Fifty dds = moved.x + b.c * (moved.Phi * u - at[3] * at[3] * v);
  return {at[1] + b.a * at[3], rolls ? Fifty(0) : Fifty(dds - b.a * moved.Phi), at[3], moved.Phi};
}

Motion after(const Motion& from, bool rolls, const Fifty& time)
{
  if(time == 0)
    return from;
  const auto motion = [&](const Fifty&, const Motion& at) { return rates(at, rolls); };
  return exact::solve(motion, 0, from, time, Fifty("1e-24")).y;
}

struct Rolls
{
  Fifty from;
  Motion at;
};

Rolls begins_to_roll(double about)  // by Newton's method
{
  Motion at = after({0, 10, 0, 0}, false, about);
  Fifty t = about;
  for(int i = 0; i < 2; ++i)
  {
    const Fifty correction = -at[1] / rates(at, false)[1];
    at = after(at, false, correction);
    t += correction;
  }
  at[1] = 0;
  return {t, at};
}

Fifty H(const Motion& at)  // (A)
{
  const Ball<Fifty> b = our_ball<Fifty>;
  const Fifty y = b.a - b.c * cos(at[2]), v = b.c * sin(at[2]);
  return y * (at[1] + y * at[3]) + v * v * at[3] + b.k * b.k * at[3];
}

CHECK_THAT(
    "along the bowled ball's way the sum told is the moment of the weight, also where friction changes")
{
  for(const Told& now : told_at(""))
  {
    const Ball<Fifty> b = our_ball<Fifty>;
    const Fifty g_ = our_g<Fifty>;
    const auto points = now.points("bowled");
    const Rolls change = begins_to_roll(points.at(60).at("t"));
    CHECK(now.value("rolls_from", seconds)
          == within_relative(change.from, 1e-13, "rounding of some steps"));
    for(const std::size_t n : {std::size_t{0}, std::size_t{30}, std::size_t{60}, std::size_t{61},
                               std::size_t{90}, std::size_t{121}})
    {
      const bool rolls = n > 60;
      const Fifty t = points.at(n).at("t");
      const Motion at = rolls ? after(change.at, true, t - change.from) : after({0, 10, 0, 0}, false, t);
      // The accelerations as differences of velocities.
      const Fifty h = 1e-8;
      const Motion before = after(at, rolls, -h), later = after(at, rolls, h);
      const auto ddx = [&](const Motion& m) { return m[1] + (b.a - b.c * cos(m[2])) * m[3]; };
      const auto ddy = [&](const Motion& m) { return b.c * sin(m[2]) * m[3]; };
      const Fifty y = b.a - b.c * cos(at[2]), v = b.c * sin(at[2]);
      const char* const because = "rounding of some steps, and the square of the step of the differences";
      CHECK(points.at(n).value("forwards")
            == within(y * (ddx(later) - ddx(before)) / (2 * h), 1e-12, because));
      CHECK(points.at(n).value("upwards")
            == within(v * (ddy(later) - ddy(before)) / (2 * h), 1e-12, because));
      CHECK(points.at(n).value("turning")
            == within(b.k * b.k * (later[3] - before[3]) / (2 * h), 1e-12, because));
      CHECK(points.at(n).value("sum") == within(-2 * g_ * v, 1e-12, "of the motion's rounding"));
      CHECK(points.at(n).value("t") == between(0, 0.6, "till the end"));
      const Fifty ds = at[1] + b.a * at[3];
      CHECK(
          (H(later) - H(before)) / (2 * h)
          == within(-2 * g_ * v + ds * v * at[3], 1e-12, "(B), the square of the step of the differences"));
    }
    for(const char* const member : {"forwards", "upwards", "turning"})
      CHECK(std::abs(points.at(61).at(member) - points.at(60).at(member)) == between(0.05, 20, "it jumps"));
    CHECK(points.at(61).at("sum") == within(points.at(60).at("sum"), 1e-13, "it goes on"));
  }
}

CHECK_THAT("about a place that stays, a homogeneous ball keeps its moment of momentum, and rolls with five "
           "sevenths")
{
  const Rational inertia(2, 5), velocity(10);
  // Before: a·v; in the end (aa + kk)w with v = aw.
  CHECK(velocity / (1 + inertia) == Rational(50, 7));
  const Path<double> path({1, 1e-15, std::sqrt(0.4)}, 15.625, 0.2, {0, 10, 0, 0}, 10, 1);
  CHECK(path.events().at(1).state.w == within(Fifty(50) / 7, 1e-13, "c is 1e-15, and rounding"));
}

/*!
In our copy the square of $d\Phi$ is missing in {{eq 2}}. The dimensions ask for it, and so does any state.
*/

double last_member(int power)  // what ac dΦ^power sin Φ comes to, for our ball at 60° with w = 4
{
  return 0.1 * std::pow(4., power) * std::sin(60_deg);
}

const Emendation square{"§9, the last member on the left",
                        {"dΦ", last_member(1)},
                        {"dΦ²", last_member(2)},
                        "what the other members of (2) lack for the state of our ball, scraping",
                        [](double reading) {
                          const Ball<Fifty> b = our_ball<Fifty>;
                          const Fifty at = exact::pi() / 3, v = sin(at), u = cos(at);
                          const auto moved = accelerations<Fifty>(b, our_g<Fifty>, at, 4, Fifty(1) / 3);
                          const Fifty dds = moved.x + b.c * (moved.Phi * u - 16 * v);
                          const Fifty lack = -2 * our_g<Fifty> * b.c * v - dds * (b.a - b.c * u)
                                             - moved.Phi * (b.c * b.c - b.a * b.c * u + b.k * b.k);
                          return reading == within(lack, 1e-15, "a few roundings");
                        }};

/*!
## Go on from here

::: exercise
Put $s = a\Phi$ into {{eq 2}}. What equation for Φ alone is that?
answer: $dd\Phi\,(aa + cc + kk - 2ac\cos\Phi) + ac\,d\Phi^2\sin\Phi = -2gc\,dt^2\sin\Phi$, that of rolling
({{sec globe.25}}). Put $dds = c\,dd\Phi\cos\Phi - c\,d\Phi^2\sin\Phi$, and it is that of the smooth plane
({{sec globe.10}}).
:::
*/

CHECK_THAT(
    "with s = aΦ equation (2) is that of rolling, and with G going uniformly that of the smooth plane")
{
  for(const Told& now : told_at("", "Phi=-130 w=2"))
  {
    CHECK(now.rows("cases").size() == 4);
    const Ball<Fifty> b = ball();
    const Fifty v = sin(Phi.fifty()), u = cos(Phi.fifty()), ww = pow(w.fifty(), 2), g2 = 2 * g.fifty();
    const Fifty rolls = rolling_by_energy().ddPhi, smooth = by_lagrange(0).ddPhi;
    CHECK(rolls * (b.a * b.a + b.c * b.c + b.k * b.k - 2 * b.a * b.c * u) + b.a * b.c * ww * v
          == within(-g2 * b.c * v, 1e-20, "the square of the step"));
    CHECK(smooth * (b.k * b.k + b.c * b.c * v * v) + b.c * b.c * ww * v * u
          == within(-g2 * b.c * v, 1e-44, "fifty digits"));
    CHECK(by_lagrange(0).dds == within(b.c * smooth * u - b.c * ww * v, 1e-44, "G goes uniformly"));
  }
}
