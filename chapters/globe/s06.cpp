#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "globe/ball.hpp"
#include "globe/rolling.hpp"

SECTION(globe, 6, "Two equations for G")

using namespace globe;

/*!
## What Euler does

The first of the two rules gives two equations at once, one for the way of $G$ forwards and one for its rise
and fall. All forces are thought of as applied to $G$ itself. It then bears the weight $P$ along $GP$,
against it the pressure Π, and horizontally the friction $\lambda\Pi$, along $PI$ or along $PO$ as explained
in {{sec globe.04}}. To be rid of that ambiguity Euler lets it act backwards, along $PI$; in the other cases
the sign is easily changed. The motion of $G$ is resolved into the same two directions $IP$ and $PG$, and
the principles of mechanics give

$$ \text{I.}\quad \frac{P\,ddx}{2g\,dt^2} = -\lambda\Pi, \tag{1} $$

$$ \text{II.}\quad \frac{P\,ddy}{2g\,dt^2} = \Pi - P, \tag{2} $$

the element of time $dt$ being taken constant. Our copy has a small $r$ where both begin with $P$.

The $2g$ is what makes forces of weights. A body that nothing carries has $\Pi = 0$, so by {{eq 2}} the
acceleration $ddy/dt^2 = -2g$, and falls in the first second through $g$, which is the meaning of the
letter.

::: margin
Today: $m\ddot x = -\lambda N$, $m\ddot y = N - mg_{\text{today}}$, where $g_{\text{today}} = 2g$ and
$m = P/2g$.
:::

Between them Π may go out, and what remains holds at every moment, whatever the ball's turning does to
the pressure:

$$ \frac{ddx}{dt^2} = -\lambda\Bigl(2g + \frac{ddy}{dt^2}\Bigr). \tag{A} $$

The plane's whole force makes with the vertical an angle whose tangent is λ, and along that line $G$ is
thrown out of the path of a falling body.

## The program

The two equations have three unknowns, the pressure among them. How the turning decides is the business of
the next section; the program borrows its result, ddΦ, and with it the second differentials of
{{sec globe.03}}.
*/

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the centre to the centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto Phi = angle("Phi", 60_deg, closed(-1e12_deg, 1e12_deg), "angle ACS");
const auto w = real("w", 4, Unit{"1/s"}, closed(-1e30, 1e30), "dΦ/dt, angular velocity");
const auto lambda =
    real("lambda", 1. / 3, none, closed(-1e20, 1e20), "λ, friction over pressure, backwards");

Ball<Fifty> ball()
{
  return {a.fifty(), c.fifty(), k.fifty()};
}

Fifty pressure(const Fifty& ddy)  // (2), over P
{
  return 1 + ddy / (2 * g.fifty());
}

Fifty forwards(const Fifty& Pi)  // (1), ddx/dt²
{
  return -2 * g.fifty() * lambda.fifty() * Pi;
}

Fifty upwards(const Fifty& turning)  // ddy/dt², as in §3
{
  const Fifty inward = c.fifty() * w.fifty() * w.fifty();
  return c.fifty() * turning * sin(Phi.fifty()) + inward * cos(Phi.fifty());
}

TELL
{
  const Fifty b = sqrt(bb(ball()));
  require(a.fifty() + c.fifty() < 1e16 * b, "k", "more, or c farther from a: a + c below 1e16 b");
  require(abs(lambda.fifty()) < rolling::painleve(ball()).mu, "lambda", "within the limit of §4");
  const Fifty bears = 2 * g.fifty() + c.fifty() * w.fifty() * w.fifty() * cos(Phi.fifty());
  require(bears >= 0, "w", "such that the plane still bears the ball");
  const Unit acceleration{"ft/s²"};
  const auto moved = accelerations(ball(), g.fifty(), Phi.fifty(), w.fifty(), lambda.fifty());
  const Fifty ddy = upwards(moved.Phi), Pi = pressure(ddy), ddx = forwards(Pi);
  const Fifty faster = moved.Phi * cos(Phi.fifty()) - w.fifty() * w.fifty() * sin(Phi.fifty());
  tell("pressure", double(Pi), "Π/P, the pressure as a part of the weight", 15);
  tell("ddx", double(ddx), acceleration, "ddx/dt², of G forwards", 15);
  tell("ddy", double(ddy), acceleration, "ddy/dt², of G upwards", 15);
  tell("dds", double(ddx + c.fifty() * faster), acceleration, "dds/dt², of the centre forwards", 15);
  tell("ddPhi", double(moved.Phi), Unit{"1/s²"}, "ddΦ/dt², borrowed from the next section", 15);
  tell("lean", std::atan(lambda), degrees, "by how much the plane's whole force leans back");
}

TELL
{
  curve("turn", {"Phi_deg", "back", "smooth", "on"}, [](Curve& turn) {
    const auto pressure = [](int n, int sign) {
      const Fifty friction = sign * lambda.fifty();
      return double(accelerations<Fifty>(ball(), g.fifty(), 2_deg * n, w.fifty(), friction).pressure);
    };
    for(int n = 0; n <= 180; ++n)
      turn.put({2. * n, pressure(n, -1), pressure(n, 0), pressure(n, 1)});
  });
}

/*!
In the example the plane bears {{pressure|6}} of the weight, a little more than the whole: the ball turns
faster and faster ({{ddPhi|4}} a second in every second), which lifts $G$. Friction changes the velocity of
$G$ forwards by {{ddx|5}} feet a second in every second, and the force of the plane leans {{lean|4}}°
backwards.

::: figure globe-06
alt: Three curves of the pressure over the weight against the angle through one turn. That without friction
lies symmetrically about 180 degrees; with friction backwards it is raised in the first half and lowered in
the second, with friction forwards the other way round.

The pressure that a ball bears at each angle when it turns with the same angular velocity: on a smooth plane
(grey), scraping forwards (blue, λ) and scraping backwards (red, −λ). Friction quickens or slows the
turning, and that lifts $G$ or lets it fall.
:::

## Speed against error

Three equations, I, II and the third of the next section, and the second differential of $y$: four linear
equations for $ddx$, $ddy$, $dd\Phi$ and Π. They may be solved beforehand, by letters; or each time, by
elimination; or by turns, the pressure being guessed, the turning found from it, the rise of $G$ from that,
and a better pressure from {{eq 2}}.
*/

struct Numbers  // what the equations need, in doubles
{
  double arm, side, fall;  // λ(a − c cos Φ) − c sin Φ, c sin Φ, and cww cos Φ/2g
};

Numbers numbers()
{
  const double sine = std::sin(Phi), cosine = std::cos(Phi);
  return {lambda * (a - c * cosine) - c * sine, c * sine, c * w * w * cosine / (2 * g)};
}

double solved_by_letters(const Numbers& n, double k_)
{
  return k_ * k_ * (1 + n.fall) / (k_ * k_ - n.side * n.arm);
}

// Rows: I, II, III and ddy; columns: ddx/2g, ddy/2g, ddΦ/2g, Π, and what is known.
double by_elimination(const Numbers& n, double k_, double lambda_)
{
  std::array<std::array<double, 5>, 4> rows{
      {{1, 0, 0, lambda_, 0}, {0, 1, 0, -1, -1}, {0, 0, k_ * k_, -n.arm, 0}, {0, 1, -n.side, 0, n.fall}}};
  for(std::size_t i = 0; i < 4; ++i)
  {
    std::size_t pivot = i;
    for(std::size_t j = i + 1; j < 4; ++j)
      if(std::abs(rows[j][i]) > std::abs(rows[pivot][i]))
        pivot = j;
    std::swap(rows[i], rows[pivot]);
    for(std::size_t j = i + 1; j < 4; ++j)
    {
      const double times = rows[j][i] / rows[i][i];
      for(std::size_t column = i; column < 5; ++column)
        rows[j][column] -= times * rows[i][column];
    }
  }
  return rows[3][4] / rows[3][3];
}

double by_turns(const Numbers& n, double k_, int turns)
{
  double Pi = 1;
  for(int i = 0; i < turns; ++i)
    Pi = 1 + n.fall + n.side * n.arm * Pi / (k_ * k_);
  return Pi;
}

TELL
{
  const Numbers n = numbers();
  const double k_ = k, lambda_ = lambda;
  std::vector<Method> ways{{"solved by letters", [=] { return solved_by_letters(n, k_); }},
                           {"elimination", [=] { return by_elimination(n, k_, lambda_); }}};
  for(const int turns : {2, 4, 8, 16})
    ways.push_back(
        {"by turns, " + std::to_string(turns), [=] { return by_turns(n, k_, turns); }, "by turns"});
  const Fifty exact = accelerations(ball(), g.fifty(), Phi.fifty(), w.fifty(), lambda.fifty()).pressure;
  const double part = n.side * n.arm / k / k;  // its sixteenth power is to be finite
  if(exact != 0 && std::abs(n.fall) < 1e100 && double(k) > 1e-70 && k < 1e70 && std::abs(n.arm) < 1e70
     && std::abs(n.side) < 1e70 && std::abs(part) < 1e12)
    race("Pi", "Π/P", exact, ways);
}

/*!
## Checks

The equations are held against Lagrange's, for the coordinates $s$ and Φ, of which neither is a coordinate
of $G$. With $F$ for the friction over $P/2g$ they are

$$ \begin{aligned} &\frac{dds - c\,dd\Phi\cos\Phi + c\,d\Phi^2\sin\Phi}{dt^2}\\ &\quad = -F,\\
   &\frac{(cc+kk)\,dd\Phi - c\,dds\cos\Phi}{dt^2}\\ &\quad = -2gc\sin\Phi + aF, \end{aligned} \tag{B} $$

and $F$ is λ times what {{eq 2}} has for Π.
*/

struct Lagrange
{
  Fifty dds, ddPhi, F;
};

Lagrange by_lagrange(const Fifty& at, const Fifty& l)
{
  const Fifty a_ = a.fifty(), c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), ww = pow(w.fifty(), 2),
              v = sin(at), u = cos(at);
  // F = p + q ddΦ; put into both, dds goes out: (cc + kk) ddΦ − c u (−F + c u ddΦ − c v ww) = −2gcv + aF.
  const Fifty p = l * (2 * g_ + c_ * ww * u), q = l * c_ * v;
  const Fifty left = c_ * c_ * v * v + k_ * k_ - (a_ - c_ * u) * q;
  const Fifty right = (a_ - c_ * u) * p - 2 * g_ * c_ * v - c_ * c_ * u * v * ww;
  const Fifty turning = right / left, F = p + q * turning;
  return {-F + c_ * u * turning - c_ * v * ww, turning, F};
}

CHECK_THAT("the accelerations and the pressure told satisfy Lagrange's equations, whatever the state")
{
  const Unit acceleration{"ft/s²"};
  for(const Told& now :
      told_at("", "lambda=-0.3 Phi=-130 w=2", "c=0.5 k=0.5 Phi=132.66033 lambda=0.782483626 w=0",
              "a=3e50 c=1e50 k=2e50 g=1e-50 w=1e-52 lambda=0.1", "lambda=0 Phi=180 w=17.677669529663687"))
  {
    const Lagrange found = by_lagrange(Phi.fifty(), lambda.fifty());
    const Fifty ww = pow(w.fifty(), 2), v = sin(Phi.fifty()), u = cos(Phi.fifty());
    const Fifty y = c.fifty() * (found.ddPhi * v + ww * u);
    const Fifty x = found.dds - c.fifty() * (found.ddPhi * u - ww * v);
    const auto once = [](const Fifty& expected, double of) {
      return within(expected, 1.2e-16 * double(abs(expected)) + 1e-30 * of, "rounded once");
    };
    CHECK(now.value("ddPhi", Unit{"1/s²"}) == once(found.ddPhi, g / k));
    CHECK(now.value("ddx", acceleration) == once(x, g));
    CHECK(now.value("ddy", acceleration) == once(y, g));
    CHECK(now.value("dds", acceleration) == once(found.dds, g));
    CHECK(now.value("pressure") == once(1 + y / (2 * g.fifty()), 1));
    // (A), and the angle that it means
    CHECK(x
          == within(-lambda.fifty() * (2 * g.fifty() + y), 1e-30 * double(2 * g + abs(y)), "fifty digits"));
    CHECK(now.value("lean", degrees)
          == within(atan2(-x, 2 * g.fifty() + y), 2e-16, "an arc, of that force"));
  }
}

CHECK_THAT("a ball that nothing carries falls through g in the first second")
{
  const Fifty ddy = -2 * g.fifty();
  CHECK(pressure(ddy) == within(0, 1e-49, "(2)"));
  CHECK(forwards(0) == within(0, 0, "(1)"));
  CHECK(exact::integrate([&](const Fifty& t) { return ddy * t; }, 0, 1).value
        == within_relative(-g.fifty(), 1e-40, "the velocity, added up for a second"));
}

CHECK_THAT("the pressures drawn are Lagrange's at each angle, without friction and with either sign")
{
  for(const Told& now : told_at("", "w=0 lambda=0.5", "c=0.5 k=0.5 lambda=0.7 w=1"))
    for(const auto& point : now.points("turn", 8))
    {
      const Fifty at = point.at("Phi_deg") * exact::pi() / 180;
      CHECK(point.value("Phi_deg") == between(0, 360, "one turn"));
      const std::array<const char*, 3> names{"back", "smooth", "on"};
      for(const int sign : {-1, 0, 1})
      {
        const Lagrange found = by_lagrange(at, sign * lambda.fifty());
        const Fifty y = c.fifty() * (found.ddPhi * sin(at) + pow(w.fifty(), 2) * cos(at));
        CHECK(point.value(names.at(static_cast<std::size_t>(1 + sign)))
              == within_relative(1 + y / (2 * g.fifty()), 1e-13,
                                 "the angle in doubles, where the pressure may change fast"));
      }
    }
}

CHECK_THAT("it refuses too little inertia with G at the surface, too much friction, and a ball that leaves "
           "the plane")
{
  for(const char* const beyond :
      {"a=5e15 c=5e15 k=1 lambda=0", "lambda=3.68081", "lambda=-3.68081", "c=0.5 k=0.5 lambda=0.7824837",
       "Phi=180 c=0.5 g=1 w=2.0000000000000001", "Phi=120 c=0.25 g=1 w=-4.0000000000000001"})
    CHECK(refused_at(beyond));
  for(const char* const within_them :
      {"a=5e15 c=5e15 k=1.0000000000000001 lambda=0", "lambda=3.6808", "lambda=-3.6808",
       "c=0.5 k=0.5 lambda=0.7824836", "Phi=180 c=0.5 g=1 w=2", "Phi=120 c=0.25 g=1 w=-3.9999999999999999"})
    CHECK(!refused_at(within_them));
}

CHECK_THAT("letters and elimination come to the pressure of (B), and turns to what each turn leaves")
{
  for(const Told& now : told_at("", "lambda=-0.3 Phi=-130 w=2", "c=0.5 k=0.5 Phi=132 lambda=0.7 w=0.5"))
  {
    const Lagrange found = by_lagrange(Phi.fifty(), lambda.fifty());
    const Fifty v = sin(Phi.fifty()), u = cos(Phi.fifty()), ww = pow(w.fifty(), 2);
    const Fifty Pi = 1 + c.fifty() * (found.ddPhi * v + ww * u) / (2 * g.fifty());
    CHECK(now.exact("Pi") == within_relative(Pi, 1e-44, "fifty digits"));
    CHECK(now.method("Pi", "solved by letters")
          == within_relative(Pi, 1e-14, "a dozen roundings, and Φ's"));
    CHECK(now.method("Pi", "elimination") == within_relative(Pi, 1e-14, "a dozen roundings, and Φ's"));
    // Each turn leaves of the error the part by which ddΦ lifts G.
    const Fifty part = 1 - (1 + c.fifty() * ww * u / (2 * g.fifty())) / Pi;
    for(const int turns : {2, 4, 8, 16})
      CHECK(now.method("Pi", "by turns, " + std::to_string(turns))
            == within(Pi + (1 - Pi) * pow(part, turns), 1e-14 * double(abs(Pi) + 1), "a geometric series"));
  }
}

/*!
## Go on from here

::: exercise
A ball scrapes with a constant λ. Show from {{eq 1}} and {{eq 2}} alone that
$dx/dt + \lambda(dy/dt + 2g\,t)$ stays the same, however the ball turns, and find by how much the velocity
of a homogeneous ball falls in a second.
answer: It is {{eq A}} times $dt$, summed. Where $G$ stays at the same height $dx/dt$ falls by $2g\lambda$
in a second, with a third by 10.4 feet a second.
:::
*/

CHECK_THAT("in a second of scraping a homogeneous ball loses two thirds of g")
{
  const auto moved =
      accelerations<Fifty>(Ball<Fifty>{1, 0, Fifty(2) / 5}, our_g<Fifty>, 1, 7, Fifty(1) / 3);
  CHECK(moved.y == within(0, 1e-48, "the same height"));
  CHECK(-moved.x == within(2 * our_g<Fifty> / 3, 1e-47, "(1)"));
  CHECK(-moved.x == printed("10.4"));
}
