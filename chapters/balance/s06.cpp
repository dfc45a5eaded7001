#include "balance/instrument.hpp"
#include "edition/section.hpp"

SECTION(balance, 6, "The coordinates by the angles")

using namespace balance;

/*!
## What Euler does

The four coordinates of the pans are found from the three angles by two right triangles for each. Euler
produces the vertical $Pp$ of the pan P upwards and draws to it, from the end $A$ of the beam, the normal
$Ar$. As $AP = b$ and the angle $APr$ is η,

$$ Ar = b\sin\eta, \qquad Pr = b\cos\eta. \tag{1} $$

In the triangle $AC\alpha$, α being where the vertical through $A$ meets the horizontal, $CA = a$ and
the angle at $C$ {{entry angle_at_C}} is ω, so that

$$ A\alpha = a\sin\omega, \qquad C\alpha = a\cos\omega. \tag{2} $$

The beam lifts $A$ above the horizontal and the string hangs down from it, outward by $Ar$; therefore

$$ \begin{gathered} x = a\cos\omega + b\sin\eta,\\
   y = b\cos\eta - a\sin\omega.
\end{gathered} \tag{3} $$

For the other pan the same normals are drawn from $B$ {{entry from_B}}, which is as far below the horizontal
as $A$ is above it. Its string leans inward where that of P leans outward, for both angles are counted
towards the same side, and so two signs change:

$$ \begin{gathered} x' = a\cos\omega - b\sin\vartheta,\\
   y' = b\cos\vartheta + a\sin\omega.
\end{gathered} \tag{4} $$

::: margin
$x$, $x'$ are counted outward from $C$, each to its own side; $y$, $y'$ downward. The strokes are no
derivatives.
:::

With the angles go their rates. Differentiated once, {{eq 3}} and {{eq 4}} give the speeds of the pans,

$$ \begin{gathered} \dot x = -a\dot\omega\sin\omega + b\dot\eta\cos\eta,\\
   \dot y = -b\dot\eta\sin\eta - a\dot\omega\cos\omega,
\end{gathered} \tag{A} $$

and those of Q with the same two changes of sign. These are the places where beam and string work on each
other: for small angles the beam enters $\dot y$ at the first order, $\dot x$ only at the second.

## The program

Both pans are one function, shared with the sections that follow.

::: code balance/instrument.hpp places (3) (4)
:::
*/

const auto a = real("a", 2, feet, closed(1e-50, 1e50), "CA = CB, half the beam");
const auto b = real("b", 32. / 9, feet, closed(1e-50, 1e50), "AP = BQ, the strings");
const auto omega = angle("omega", 20_deg, closed(-90_deg, 90_deg), "inclination ω of the beam");
const auto eta = angle("eta", 10_deg, closed(-180_deg, 180_deg), "inclination η of the string AP");
const auto theta = angle("theta", 25_deg, closed(-180_deg, 180_deg), "inclination ϑ of the string BQ");
const auto omega_rate = real("omega_rate", 0.1, Unit{"1/s"}, closed(-1e6, 1e6), "dω/dt");
const auto eta_rate = real("eta_rate", -0.3, Unit{"1/s"}, closed(-1e6, 1e6), "dη/dt");
const auto theta_rate = real("theta_rate", 0.2, Unit{"1/s"}, closed(-1e6, 1e6), "dϑ/dt");

Places<> speeds()  // (A)
{
  const double up = a * omega_rate * std::cos(omega), in = a * omega_rate * std::sin(omega);
  return {b * eta_rate * std::cos(eta) - in, -b * eta_rate * std::sin(eta) - up,
          -b * theta_rate * std::cos(theta) - in, up - b * theta_rate * std::sin(theta)};
}

TELL
{
  const auto [x, y, x1, y1] = places<double>(a, b, {omega, eta, theta});
  tell("x", x, feet, "Cp, outward", 15);
  tell("y", y, feet, "pP, downward", 15);
  tell("x1", x1, feet, "x′ = Cq, outward to the other side", 15);
  tell("y1", y1, feet, "y′ = qQ, downward", 15);
  tell("A_alpha", a * std::sin(omega), feet, "Aα, how high A is lifted", 15);
  tell("A_r", b * std::sin(eta), feet, "Ar, how far P hangs outside A", 15);
}

TELL
{
  const Unit speed{"ft/s"};
  const auto [x, y, x1, y1] = speeds();
  tell("x_rate", x, speed, "dx/dt", 15);
  tell("y_rate", y, speed, "dy/dt", 15);
  tell("x1_rate", x1, speed, "dx′/dt", 15);
  tell("y1_rate", y1, speed, "dy′/dt", 15);
}

TELL
{
  curve("outline", {"x", "y"}, [](Curve& out) {  // Q, B, C, A, P and the feet r and α, up being positive
    const auto [x, y, x1, y1] = places<double>(a, b, {omega, eta, theta});
    const double c = a * std::cos(omega), s = a * std::sin(omega);
    out.put({x1, -y1});
    out.put({c, -s});
    out.put({0, 0});
    out.put({-c, s});
    out.put({-x, -y});
    out.put({-x, s});
    out.put({-c, 0});
  });
}

/*!
In the attitude of the figure P hangs {{x|5}} ft outward and {{y|5}} ft down, Q {{x1|5}} ft and {{y1|5}} ft.

::: figure balance-06
alt: The balance with its left end A lifted. The strings from both ends lean to the left. Thin lines show the
right triangles: A, C and the foot alpha on the horizontal; A, P and the foot r on the vertical through P.

The triangles of P. A side of the first is $A\alpha$, one of the second $Ar$; Q has the same, turned over.
:::

## Checks

The coordinates are those of a chain of two rods, which another reckoning lays end to end by rotations: turn
the arm by ω, hang the string on it.
*/

struct Point
{
  Fifty x, y;  // to the side of A, and up
};

Point turned(const Point& p, const Fifty& by)  // against the sense in which the arm of A rises
{
  const Fifty half = tan(by / 2), below = 1 + half * half;
  const Fifty c = (1 - half * half) / below, s = 2 * half / below;
  return {p.x * c - p.y * s, p.x * s + p.y * c};
}

std::array<Fifty, 4> by_rotation(const Fifty& w, const Fifty& e, const Fifty& th)
{
  const Point A = turned({a.fifty(), 0}, w), B = turned({-a.fifty(), 0}, w);
  const Point P = turned({0, -b.fifty()}, e), Q = turned({0, -b.fifty()}, th);
  return {A.x + P.x, -A.y - P.y, -B.x - Q.x, -B.y - Q.y};
}

CHECK_THAT("(3) and (4) are the places to which rotations bring arm and string, in fifty digits")
{
  for(const Told& now : told_at("", "a=3 b=1e-40 omega=-89 eta=170 theta=-90", "a=1e50 b=1e-50 omega=1e-30",
                                "a=1 b=1 omega=90"))
  {
    const std::array<Fifty, 4> at = by_rotation(omega.fifty(), eta.fifty(), theta.fifty());
    const double size = 4e-16 * (a + b);
    const char* const why = "two products of sines, rounded";
    CHECK(now.value("x", feet) == within(at[0], size, why));
    CHECK(now.value("y", feet) == within(at[1], size, why));
    CHECK(now.value("x1", feet) == within(at[2], size, why));
    CHECK(now.value("y1", feet) == within(at[3], size, why));
    CHECK(now.value("A_alpha", feet) == within_relative(a.fifty() * sin(omega.fifty()), 5e-16, "a sine"));
    CHECK(now.value("A_r", feet)
          == within(b.fifty() * sin(eta.fifty()), 5e-16 * b, "a sine, also near 180°"));
  }
}

CHECK_THAT("the speeds are how fast the places change: a quotient of differences in fifty digits")
{
  for(const Told& now : told_at("", "omega_rate=7 eta_rate=-300 theta_rate=2 omega=-60 eta=179 theta=5",
                                "omega_rate=0 eta_rate=1e-6 theta_rate=-1e6 theta=90"))
  {
    const Fifty h("1e-18");
    const auto at = [&](const Fifty& t) {
      return by_rotation(omega.fifty() + omega_rate.fifty() * t, eta.fifty() + eta_rate.fifty() * t,
                         theta.fifty() + theta_rate.fifty() * t);
    };
    const auto before = at(-h), after = at(h);
    const auto rate = [&](std::size_t i) { return (after[i] - before[i]) / (2 * h); };
    const Unit speed{"ft/s"};
    const double allowed =
        6e-16 * (a * std::abs(omega_rate) + b * (std::abs(eta_rate) + std::abs(theta_rate)));
    const char* const why = "two products, and the square of the step";
    CHECK(now.value("x_rate", speed) == within(rate(0), allowed, why));
    CHECK(now.value("y_rate", speed) == within(rate(1), allowed, why));
    CHECK(now.value("x1_rate", speed) == within(rate(2), allowed, why));
    CHECK(now.value("y1_rate", speed) == within(rate(3), allowed, why));
  }
}

CHECK_THAT("strings keep their length and the beam its own, whatever the angles, and so they are drawn")
{
  for(const Told& now : told_at("", "omega=-45 eta=120 theta=-77 a=1 b=0.3", "omega=80 eta=-3 theta=3"))
  {
    const auto all = now.points("outline");
    REQUIRE(all.size() == 7);
    const auto length = [&all](std::size_t i, std::size_t j) {
      return hypot(Fifty(all[i].at("x")) - all[j].at("x"), Fifty(all[i].at("y")) - all[j].at("y"));
    };
    const double size = 4e-16 * (a + b);
    CHECK(double(length(0, 1)) == within(b.fifty(), size, "BQ"));
    CHECK(double(length(1, 2)) == within(a.fifty(), size, "CB"));
    CHECK(double(length(2, 3)) == within(a.fifty(), size, "CA"));
    CHECK(double(length(3, 4)) == within(b.fifty(), size, "AP"));
    const std::array<Fifty, 4> at = by_rotation(omega.fifty(), eta.fifty(), theta.fifty());
    const Point A = turned({a.fifty(), 0}, omega.fifty());
    const std::array<Point, 7> right{
        {{at[2], -at[3]}, {A.x, -A.y}, {0, 0}, {-A.x, A.y}, {-at[0], -at[1]}, {-at[0], A.y}, {-A.x, 0}}};
    for(std::size_t i = 0; i < 7; ++i)
    {
      CHECK(all[i].value("x") == within(right[i].x, size, "drawn to scale"));
      CHECK(all[i].value("y") == within(right[i].y, size, "drawn to scale"));
    }
  }
}

/*!
Two words are wrong in our copy, whether by the scan or already before it. In {{eq 2}} it gives ω to the
angle at $A$; and the normals of Q it draws from $C$.
*/

double height_with(double angle_at_C_)  // Aα, a being 1 and ω 20°
{
  return std::sin(angle_at_C_);
}

const Emendation angle_at_C{
    "§6, the angle that is ω in the triangle ACα",
    {"CAα", height_with(70_deg)},
    {"ACα", height_with(20_deg)},
    "Aα is a sin ω, as the same line says, and § 9 has CAα = 90° − ω",
    [](double height) { return height == within_ulps(sin(Fifty(20) * exact::pi() / 180), 2, "a sine"); }};

double depth_with(
    double start)  // y′ + b, a and b being 1, ω 20°, ϑ 25°; the vertical begins so far below C
{
  return std::cos(25_deg) + start;
}

const Emendation from_B{"§6, whence the normals of the other pan are drawn",
                        {"from C", depth_with(0)},
                        {"from B", depth_with(std::sin(20_deg))},
                        "from C itself no Bε = a sin ω could be drawn, and Q would be too high",
                        [](double depth) {
                          const Point B = turned({-1, 0}, Fifty(20) * exact::pi() / 180);
                          const Point Q = turned({0, -1}, Fifty(25) * exact::pi() / 180);
                          return depth == within_ulps(-B.y - Q.y, 2, "a sum of two");
                        }};

/*!
## Notes

Two sums show what is hidden in the signs: $x + x' = 2a\cos\omega + b(\sin\eta - \sin\vartheta)$ and
$y + y' = b(\cos\eta + \cos\vartheta)$. The beam's inclination drops out of the second altogether, and
remains in the first only by its square. Whatever the beam does to both pans in common is of the second
order.
*/
