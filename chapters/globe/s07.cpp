#include "edition/section.hpp"
#include "globe/ball.hpp"
#include "globe/rolling.hpp"

SECTION(globe, 7, "The moments, and the third equation")

using namespace globe;

/*!
## What Euler does

The second rule gives the third equation, and with it as many equations as there are unknowns. Moments are
taken about $G$. The weight has none, for it passes through that point. The pressure Π, which acts along
$SC$, has the moment

$$ \Pi\cdot GQ = \Pi c\sin\Phi, \tag{1} $$

and the turning is slowed by it. Thirdly the friction $\lambda\Pi$ along $PI$ has the moment

$$ \lambda\Pi\cdot PG = \lambda\Pi(a - c\cos\Phi), \tag{2} $$

and by this the turning is quickened. To determine it the principles of motion therefore supply

$$ \begin{aligned} \text{III.}\quad \frac{Pkk\,dd\Phi}{2g{{entry two_g}}\,dt^2}
   = \lambda\Pi&(a - c\cos\Phi)\\ &- \Pi c\sin\Phi. \end{aligned} \tag{3} $$

So three equations are found, out of which the whole motion of the ball must be determined. As many are
indeed needed, for three things are unknown at each time: the way $s$ and the angle Φ, and besides them the
pressure itself, Π. In our copy the $P$ of {{eq 3}} and its 2 are both the $\partial$ of a differential.

::: margin
Today: $mk^2\ddot\theta = \mu N y - N c\sin\theta$.
:::

The two arms $c\sin\Phi$ and $\lambda(a - c\cos\Phi)$ are equal when the plane's whole force, leaning
backwards by the angle with the tangent λ, is directed to $G$; then the turning is neither quickened nor
slowed. Seen from $S$, the points at the distance $c$ from $C$ lie within an angle whose tangent is

$$ \frac{c}{\sqrt{aa - cc}} \tag{A} $$

to either side of the vertical. With more friction than this a ball that scrapes forwards is quickened at
every Φ.

Held at rest at the angle Φ and let go, the ball begins to turn with

$$ \begin{aligned} &\text{smooth:}\\
   &\frac{dd\Phi}{dt^2} = -\frac{2gc\sin\Phi}{kk + cc\sin^2\Phi},\\
   &\text{rolling:}\\
   &\frac{dd\Phi}{dt^2} = -\frac{2gc\sin\Phi}{aa+cc+kk - 2ac\cos\Phi};
   \end{aligned} \tag{B} $$

rolling is the slower, $G$ being farther from $S$ than from the vertical through it, and needs
$\lambda = c\sin\Phi\,y/(kk + yy)$.

## The program

The reader gives the state, the second of the chapter's balls standing as an example, held at 30°.
*/

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.5, feet, scale, "CG, from the centre to the centre of gravity");
const auto k = real("k", 0.5, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto Phi = angle("Phi", 30_deg, closed(-1e12_deg, 1e12_deg), "angle ACS");
const auto w = real("w", 0, Unit{"1/s"}, closed(-1e30, 1e30), "dΦ/dt, angular velocity");
const auto lambda =
    real("lambda", 1. / 3, none, closed(-1e20, 1e20), "λ, friction over pressure, backwards");

Fifty arm_of_pressure(const Fifty& at)  // (1)
{
  return c.fifty() * sin(at);
}

Fifty arm_of_friction(const Fifty& at)  // (2)
{
  const Fifty sine = sin(at / 2);
  return lambda.fifty() * ((a.fifty() - c.fifty()) + 2 * c.fifty() * sine * sine);
}

Fifty turning(const Fifty& Pi)  // (3), Π being over P
{
  const Fifty kk = k.fifty() * k.fifty();
  return 2 * g.fifty() * Pi * (arm_of_friction(Phi.fifty()) - arm_of_pressure(Phi.fifty())) / kk;
}

/*!
The pressure comes with all three equations, from the library.
*/

TELL
{
  const Ball<Fifty> ball{a.fifty(), c.fifty(), k.fifty()};
  require(c.fifty() < a.fifty(), "c", "less than a: G is in the ball");
  require(a.fifty() < 1e20 * sqrt(bb(ball)), "k", "more, or c farther from a: a below 1e20 b");
  require(abs(lambda.fifty()) < rolling::painleve(ball).mu, "lambda", "within the limit of §4");
  const Fifty at = Phi.fifty(), w_ = w.fifty(), g_ = g.fifty();
  require(2 * g_ + c.fifty() * w_ * w_ * cos(at) >= 0, "w", "such that the plane still bears the ball");
  const Fifty Pi = accelerations(ball, g_, at, w_, lambda.fifty()).pressure;
  tell("pressure", double(Pi), "Π/P");
  tell("slows", double(Pi * arm_of_pressure(at)), feet, "moment of the pressure over P, slowing");
  tell("quickens", double(Pi * arm_of_friction(at)), feet, "moment of the friction over P, quickening");
  tell("turning", double(turning(Pi)), Unit{"1/s²"}, "ddΦ/dt²");
  tell("balance", double(arm_of_pressure(at) / (a.fifty() - c.fifty() * cos(at))),
       "the λ with which the plane's force is directed to G");
  tell("always", double(c.fifty() / sqrt((a.fifty() - c.fifty()) * (a.fifty() + c.fifty()))),
       "(A), the λ beyond which friction wins at every Φ");
  auto& let_go = table("let_go", "The ball held at Φ and let go",
                       {{"plane", "on a plane"},
                        {"lambda", "λ"},
                        {"pressure", "Π/P"},
                        {"turning", "ddΦ/dt²", Unit{"1/s²"}, 9}});
  const auto smooth = accelerations<Fifty>(ball, g_, at, 0, 0);
  const auto rolls = rolling_accelerations<Fifty>(ball, g_, at, 0);
  const auto scrapes = accelerations<Fifty>(ball, g_, at, 0, lambda.fifty());
  let_go.row({"that is smooth", 0., double(smooth.pressure), double(smooth.Phi)});
  let_go.row({"on which it rolls", double(-rolls.x / (2 * g_) / rolls.pressure), double(rolls.pressure),
              double(rolls.Phi)});
  let_go.row(
      {"over which it is drawn forwards", double(lambda), double(scrapes.pressure), double(scrapes.Phi)});
}

TELL
{
  curve("arms", {"Phi_deg", "pressure", "friction"}, [](Curve& arms) {  // in radii
    for(int n = 0; n <= 180; ++n)
      arms.put({2. * n, double(arm_of_pressure(n * exact::pi() / 90) / a.fifty()),
                double(arm_of_friction(n * exact::pi() / 90) / a.fifty())});
  });
}

/*!
At 30° the plane's force would have to lean by {{balance|4}} to be directed to $G$. It leans by a third
only, so the pressure wins, and the turning goes back. The ball whose friction would always win needs a λ of
{{always|4}}.

{{table let_go}}

::: figure globe-07
alt: Two curves against the angle through one turn. The arm of the pressure is a sine; that of the friction
a raised wave, lowest at 0 and highest at 180 degrees. Where the sine is above the other the region is
shaded.

The arms of the pressure (red) and of the friction that a ball meets when it scrapes forwards (blue). Where
the red one is higher the ball is turned back, elsewhere forwards.
:::

## Checks

No moment is taken here. In a small displacement of the ball that keeps it on the plane, by $\delta s$ and
δΦ, the pressure does no work. What the weight and the friction do, the masses times their accelerations
must account for. The displacements of $G$ are differences.
*/

struct State
{
  Fifty a, c, k, g, Phi, w, lambda;
};

State given()
{
  return {a.fifty(), c.fifty(), k.fifty(), g.fifty(), Phi.fifty(), w.fifty(), lambda.fifty()};
}

// What the work lacks if the ball is turned with this acceleration, over the weight and 1/2g.
Fifty lacking(const State& now, const Fifty& turning, const Fifty& ds, const Fifty& dPhi)
{
  const Fifty h = 1e-12;
  const auto x = [&](const Fifty& t) { return t * ds - now.c * sin(now.Phi + t * dPhi); };
  const auto y = [&](const Fifty& t) { return 0 - now.c * cos(now.Phi + t * dPhi); };
  const Fifty dx = (x(h) - x(-h)) / (2 * h), dy = (y(h) - y(-h)) / (2 * h);
  const Fifty ddy = now.c * (turning * sin(now.Phi) + now.w * now.w * cos(now.Phi));
  const Fifty friction = now.lambda * (2 * now.g + ddy), ddx = -friction;  // I and II
  return ddx * dx + ddy * dy + now.k * now.k * turning * dPhi + 2 * now.g * dy
         + friction * (ds - now.a * dPhi);
}

// The acceleration with which it lacks nothing; the work is linear in it.
Fifty by_work(const State& now, const Fifty& ds)
{
  const Fifty unit = now.g / (now.a + now.k), at_rest = lacking(now, 0, ds, 1);
  return -at_rest * unit / (lacking(now, unit, ds, 1) - at_rest);
}

CHECK_THAT("with the turning told every small displacement does the work that is asked for")
{
  for(const Told& now :
      told_at("", "w=-3 Phi=-130 lambda=-0.6", "c=0.1 k=0.6 w=4", "Phi=1e-20rad lambda=0",
              "a=3e50 c=1e50 k=2e50 g=1e-50 w=1e-52 Phi=1000", "Phi=132.66033 lambda=0.782483626"))
  {
    const State here = given();
    const Fifty turning_ = by_work(here, 0);
    // The same, however the ball is shifted meanwhile.
    CHECK(by_work(here, -7 * here.a)
          == within_relative(turning_, 1e-12, "the step; less, where M nearly vanishes"));
    const Fifty ddy = here.c * (turning_ * sin(here.Phi) + here.w * here.w * cos(here.Phi));
    const Fifty Pi = 1 + ddy / (2 * here.g), y = here.a - here.c * cos(here.Phi);
    const auto near = [&](const Fifty& expected) {
      return within_relative(expected, 3e-16, "the step of the differences, and one rounding");
    };
    CHECK(now.value("turning", Unit{"1/s²"}) == near(turning_));
    CHECK(now.value("pressure") == near(Pi));
    // Arms: how far G is from the lines SC and IO.
    CHECK(now.value("slows", feet) == near(Pi * here.c * sin(here.Phi)));
    CHECK(now.value("quickens", feet) == near(Pi * here.lambda * y));
  }
}

CHECK_THAT("it refuses a G at the surface, too little inertia near it, too much friction, a ball that "
           "leaves the plane")
{
  for(const char* const beyond :
      {"c=1", "a=3 c=3 k=3", "a=5e20 c=499999999999999999997 k=4 lambda=0", "lambda=0.7824837",
       "c=0.1 k=0.6 lambda=-3.68081", "Phi=180 g=1 w=2.0000000000000001",
       "Phi=120 c=0.25 g=1 w=-4.0000000000000001"})
    CHECK(refused_at(beyond));
  for(const char* const within_them :
      {"c=0.99999999999999999", "a=3 c=2.9999999999999999 k=3",
       "a=5e20 c=499999999999999999997 k=4.0000000000000001 lambda=0", "lambda=0.7824836",
       "c=0.1 k=0.6 lambda=-3.6808", "Phi=180 g=1 w=2", "Phi=120 c=0.25 g=1 w=-3.9999999999999999"})
    CHECK(!refused_at(within_them));
}

CHECK_THAT("with the λ told for balance the turning is not quickened, and beyond (A) it is at every angle")
{
  for(const Told& now : told_at("", "c=0.1 k=0.6 Phi=-20", "c=0.999999 k=0.1 Phi=5 lambda=0.01"))
  {
    State here = given();
    const Fifty y = here.a - here.c * cos(here.Phi);
    const Fifty lean = tan(atan2(here.c * sin(here.Phi), y));  // from S to G, from the vertical
    CHECK(now.value("balance") == within_relative(lean, 3e-16, "rounded once"));
    here.lambda = lean;
    CHECK(by_work(here, 0) == within(0, 1e-20 * double(here.g / here.k), "the step"));
    // The greatest of these angles, by the tangent from S to the circle of G.
    const Fifty most = tan(asin(here.c / here.a));
    CHECK(now.value("always") == within_relative(most, 3e-16, "rounded once"));
    const Fifty where = acos(here.c / here.a);
    CHECK(here.c * sin(where) / (here.a - here.c * cos(where))
          == within_relative(most, 1e-42, "touched there"));
    for(int n = 0; n < 360; ++n)
    {
      const Fifty at = n * exact::pi() / 180;
      CHECK(most * (1 + Fifty(1e-12)) * (here.a - here.c * cos(at)) - here.c * sin(at)
            == between(0, 3 * here.a * (1 + most), "friction wins"));
    }
  }
}

CHECK_THAT("let go, the three balls turn and press as the work asks for, and the one that rolls does roll")
{
  for(const Told& now :
      told_at("", "c=0.1 k=0.6 Phi=-100", "a=3e50 c=1e50 k=2e50 g=1e-50 Phi=1000 lambda=0.1"))
  {
    State here = given();
    here.w = 0;
    const auto rows = now.rows("let_go");
    CHECK(rows.size() == 3);
    // Rolling at rest, the work of a displacement that rolls: friction has no part in it.
    const Fifty rolls = [&] {
      State free = here;
      free.lambda = 0;
      const Fifty h = 1e-12;
      const auto x = [&](const Fifty& t) { return here.a * t - here.c * sin(here.Phi + t); };
      const auto y = [&](const Fifty& t) { return 0 - here.c * cos(here.Phi + t); };
      const Fifty dx = (x(h) - x(-h)) / (2 * h), dy = (y(h) - y(-h)) / (2 * h);
      return -2 * here.g * dy / (dx * dx + dy * dy + here.k * here.k);
    }();
    const Fifty y = here.a - here.c * cos(here.Phi);
    const Fifty needs = here.c * sin(here.Phi) * y / (here.k * here.k + y * y);
    const std::array<Fifty, 3> lambdas{0, needs, here.lambda};
    for(std::size_t i = 0; i < 3; ++i)
    {
      here.lambda = lambdas.at(i);
      const Fifty begins = i == 1 ? rolls : by_work(here, 0);
      const char* const because = "the step of the differences, and one rounding";
      CHECK(rows[i].value("turning", Unit{"1/s²"}) == within_relative(begins, 3e-16, because));
      CHECK(rows[i].value("pressure")
            == within_relative(1 + here.c * begins * sin(here.Phi) / (2 * here.g), 3e-16, because));
      CHECK(rows[i].value("lambda") == within_relative(lambdas.at(i), 3e-16, "rounded once"));
      CHECK(by_work(here, 0) == within_relative(begins, 1e-20, "the λ that rolling needs, too"));
    }
    CHECK(rows[0].words("plane") == "that is smooth");
    for(std::size_t i = 0; i < 3; ++i)
      CHECK(rows[i].value("plane")
            == std::array{"that is smooth", "on which it rolls", "over which it is drawn forwards"}.at(i));
  }
}

CHECK_THAT("the arms drawn are how far G is from the vertical through S, and λ times how high it is")
{
  for(const Told& now : told_at("", "c=0.1 lambda=-0.2", "a=1e80 c=3e79 k=2e79 lambda=0.1"))
    for(const auto& point : now.points("arms", 9))
    {
      const State here = given();
      const Fifty at = point.at("Phi_deg") * exact::pi() / 180;
      const Fifty u = 1 - 2 * pow(sin(at / 2), 2), v = 2 * sin(at / 2) * cos(at / 2);
      CHECK(point.value("pressure") == within(here.c / here.a * v, 1e-15, "rounded once"));
      CHECK(point.value("friction")
            == within(here.lambda * (1 - here.c / here.a * u), 1e-15, "rounded once"));
      CHECK(point.value("Phi_deg") == between(0, 360, "one turn"));
    }
}

/*!
That it must be $2g$ in {{eq 3}}, as in the other two, is seen where they are used together.
*/

const State example{1, Fifty(1) / 10, Fifty(3) / 5, Fifty(125) / 8, exact::pi() / 3, 4, Fifty(1) / 3};

double with_III(int n)  // ddΦ/dt² from I, II and III with ng in III
{
  const double sine = std::sin(60_deg), y = 0.95, arm = y / 3 - 0.1 * sine, g_ = 15.625;
  return arm * (1 + 1.6 * 0.5 / (2 * g_)) / (0.36 / (n * g_) - arm * 0.1 * sine / (2 * g_));
}

const Emendation two_g{"§7, III, under the line",
                       {"g dt²", [] { return with_III(1); }},
                       {"2g dt²", [] { return with_III(2); }},
                       "with half of it the work of a small displacement is not accounted for",
                       [](double reading) {
                         return lacking(example, reading, 1, 1)
                                == within(0, 1e-13, "the rounding of a turning of twenty");
                       }};

/*!
## Notes

That friction has to act at the contact and the weight at $G$ is all that makes the ball turn. A ball thrown
forwards without turning is turned by friction so that $G$ rises behind; {{sec globe.08}} follows it.

## Go on from here

::: exercise
The ball lies with $G$ a little beside the vertical, Φ being very small. By how much is it slower to start
when it rolls than on a smooth plane?
answer: In the ratio of $kk$ to $(a-c)^2 + kk$, by {{eq B}}; for the ball of the example one to two. That is
the ratio of the lengths of the two pendulums in {{sec globe.34}}.
:::
*/

CHECK_THAT("near the lowest place rolling starts half as fast as smooth, for the ball of the example")
{
  for(const Told& now : told_at("Phi=1e-20rad w=0"))
  {
    const auto rows = now.rows("let_go");
    const Fifty smooth = -2 * Fifty(125) / 8 * Fifty(1) / 2 * Fifty(1e-20) / (Fifty(1) / 4);
    CHECK(rows[0].value("turning", Unit{"1/s²"}) == within_relative(smooth, 3e-16, "rounded once"));
    CHECK(rows[1].value("turning", Unit{"1/s²"}) == within_relative(smooth / 2, 3e-16, "rounded once"));
  }
}
