#include "balance/instrument.hpp"
#include "balance/motion.hpp"
#include "edition/section.hpp"

SECTION(balance, 5, "Where the pans are")

using namespace balance;

/*!
## What Euler does

To bring the places of P and Q into the calculation, perpendiculars are dropped from both to the horizontal
axis through $C$, to the points $p$ and $q$. Then each pan has two coordinates,

$$ \begin{gathered} Cp = x, \quad pP = y;\\
   Cq = x', \quad qQ = y',
\end{gathered} \tag{1} $$

and these, he says, have to be determined by what was introduced before. Nothing else is done here; the next
section does it ({{sec balance.06}}).

::: margin
$x$ and $x'$ are counted from $C$ outward, each to its own side, $y$ and $y'$ downward. The strokes are no
derivatives.
:::

Four coordinates stand there for three angles. So the four cannot be independent: whoever knows where both
pans are knows a little too much. Let $u$ and $v$ be the place of $A$, outward and downward from $C$; $B$ lies
opposite. The strings have the length $b$,

$$ \begin{gathered} (x-u)^2 + (y-v)^2 = bb,\\
   (x'-u)^2 + (y'+v)^2 = bb,
\end{gathered} \tag{A} $$

and $uu + vv = aa$. With the last the squares of $u$ and $v$ go out of {{eq A}}, and what is left is of the
first degree. With $2R = xx+yy+aa-bb$ and $2R' = x'x'+y'y'+aa-bb$

$$ \begin{gathered} u = \frac{R\,y' + R'y}{xy'+x'y},\\
   v = \frac{R\,x' - R'x}{xy'+x'y}.
\end{gathered} \tag{B} $$

So the ends of the beam are found from the pans alone, without a root and without ambiguity, and with
them all three angles. That $uu+vv$ comes out as $aa$ is the condition that the four coordinates have to
satisfy. Only if $C$ lies in one line with both pans do they not decide where the beam is.

## The program

The program goes there and back: from the angles to the coordinates, and by {{eq B}} to the angles again.
*/

const auto a = real("a", 2, feet, closed(0.1, 100), "CA = CB, half the beam");
const auto b = real("b", 32. / 9, feet, closed(0.1, 100), "AP = BQ, the strings");
const auto omega = angle("omega", 20_deg, closed(-80_deg, 80_deg), "inclination ω of the beam");
const auto eta = angle("eta", 10_deg, closed(-80_deg, 80_deg), "inclination η of the string AP");
const auto theta = angle("theta", 25_deg, closed(-80_deg, 80_deg), "inclination ϑ of the string BQ");
const auto slip = real("slip", 0.01, feet, closed(-1, 1), "by how much x is misread");

struct End
{
  double u, v;  // of A, outward and downward from C
};

End end_of_beam(const Places<>& at)  // (B)
{
  const auto& [x, y, x1, y1] = at;
  const double R = (x * x + y * y + (a - b) * (a + b)) / 2,
               R1 = (x1 * x1 + y1 * y1 + (a - b) * (a + b)) / 2;
  const double divisor = x * y1 + x1 * y;
  return {(R * y1 + R1 * y) / divisor, (R * x1 - R1 * x) / divisor};
}

Angles<> angles_of(const Places<>& at)
{
  const End A = end_of_beam(at);
  return {std::atan2(-A.v, A.u), std::atan2(at.x - A.u, at.y - A.v), std::atan2(A.u - at.x1, at.y1 + A.v)};
}

TELL
{
  Places<> at = places<double>(a, b, {omega, eta, theta});
  const double divisor = at.x * at.y1 + at.x1 * at.y;
  require(std::abs(divisor) >= 0.01 * (a + b) * (a + b), "theta",
          "such that C does not lie nearly in line with P and Q");
  const Angles<> found = angles_of(at);
  tell("x", at.x, feet, "Cp", 14);
  tell("y", at.y, feet, "pP", 14);
  tell("x1", at.x1, feet, "x′ = Cq", 14);
  tell("y1", at.y1, feet, "y′ = qQ", 14);
  tell("omega_found", found.omega, degrees, "ω, from the four coordinates by (B)", 9);
  tell("eta_found", found.eta, degrees, "η", 9);
  tell("theta_found", found.theta, degrees, "ϑ", 9);
  at.x += slip;
  require(std::abs(at.x * at.y1 + at.x1 * at.y) >= 0.01 * (a + b) * (a + b), "slip",
          "such that C does not lie nearly in line with P, as misread, and Q");
  const End A = end_of_beam(at);
  tell("beam_found", std::hypot(A.u, A.v), feet, "half the beam by (B), x being misread", 9);
}

TELL
{
  curve("paths", {"lambda_t", "x", "y", "x1", "y1"}, [](Curve& out) {
    const State<> start{{8_deg, 0, 0}, {0, 36_deg, -24_deg}};
    int degree = 0;
    for(const State<>& now : course(numbers_of(instrument_of_35), start, 2 * std::numbers::pi, 720))
    {
      const auto [x, y, x1, y1] = places<double>(instrument_of_35.a, instrument_of_35.b, now.at);
      out.put({0.5 * degree++, x, y, x1, y1});
    }
  });
}

/*!
From $x = {{x|5}}$, $y = {{y|5}}$, $x' = {{x1|5}}$ and $y' = {{y1|5}}$ ft the angles come out again, ω as
{{omega_found|deg1}}. Were $x$ misread by {{slip}} ft, half the beam would come out as
{{beam_found|5}} ft instead of {{a}}, and one would know.

::: figure balance-05
alt: A level beam ACB, from whose ends strings hang down into two curves. Each curve goes three times from
side to side while it goes down and up once, the left one wider than the right one.

The paths of P and Q while the beam of {{sec balance.35}} swings once: the strings lead out and in, three
times, and the ends of the beam down and up. Both pans hang straight down and are pushed at the moment at
which the beam is let go at 8°.
:::

## Checks
*/

CHECK_THAT("the four coordinates are those of § 6, and the angles that they come from are found again")
{
  for(const Told& now :
      told_at("", "a=1 b=3 omega=-70 eta=30 theta=-40 slip=-0.2", "a=0.1 b=0.12 omega=1e-9 eta=80 theta=80",
              "a=50 b=70 omega=60 eta=-20 theta=-75 slip=0.5"))
  {
    const Angles<Fifty> at{omega.fifty(), eta.fifty(), theta.fifty()};
    const Places<Fifty> is = places<Fifty>(a.fifty(), b.fifty(), at);
    const double size = a + b, room = 3e-16 * size;
    CHECK(now.value("x", feet) == within(is.x, room, "two products of sines"));
    CHECK(now.value("y", feet) == within(is.y, room, "the same"));
    CHECK(now.value("x1", feet) == within(is.x1, room, "the same"));
    CHECK(now.value("y1", feet) == within(is.y1, room, "the same"));
    const double divisor = std::abs(double(is.x * is.y1 + is.x1 * is.y)),
                 off = 4e-15 * size * size * size / divisor;
    const char* const why = "the coordinates' roundings, as (B) enlarges them";
    CHECK(now.value("omega_found", degrees) == within(at.omega, off / a, why));
    CHECK(now.value("eta_found", degrees) == within(at.eta, off / b, why));
    CHECK(now.value("theta_found", degrees) == within(at.theta, off / b, why));
  }
}

/*!
The end of the beam is found a second time as the point where two lines cross, from the distances of the lines
from $C$ and the angle between them.
*/

CHECK_THAT("the beam found, also with x misread, reaches to where the two lines of (B) cross")
{
  for(const Told& now : told_at("", "a=1 b=3 omega=-70 eta=30 theta=-40 slip=-0.2",
                                "a=50 b=70 omega=60 eta=-20 theta=-75 slip=0.5", "slip=0 omega=-5"))
  {
    auto [x, y, x1, y1] = places<Fifty>(a.fifty(), b.fifty(), {omega.fifty(), eta.fifty(), theta.fifty()});
    x += slip.fifty();
    const Fifty bb = b.fifty() * b.fifty(), aa = a.fifty() * a.fifty();
    const Fifty R = (x * x + y * y + aa - bb) / 2, R1 = (x1 * x1 + y1 * y1 + aa - bb) / 2;
    // the lines x u + y v = R and x′u − y′v = R′ have these distances from C, and their normals this angle
    const Fifty d = R / hypot(x, y), d1 = R1 / hypot(x1, y1), angle = atan2(y, x) - atan2(-y1, x1);
    const Fifty reach = sqrt(d * d + d1 * d1 - 2 * d * d1 * cos(angle)) / abs(sin(angle));
    const double size = a + b, divisor = std::abs(double(x * y1 + x1 * y));
    CHECK(now.value("beam_found", feet)
          == within(reach, 4e-15 * size * size * size / divisor, "as (B) enlarges the roundings"));
    if(slip == 0)
      CHECK(reach == within_relative(a.fifty(), 1e-45, "nothing was misread"));
  }
}

CHECK_THAT("where C lies nearly in line with both pans the program refuses")
{
  // at ω = 0, η = −30°, b = 2a there is x = 0, and the bound is |1 − 2 sin ϑ| = 0.03√3, at 28.2955118970° and
  // 31.7342911694°
  for(const std::string place :
      {"a=1 b=2 omega=0 eta=-30 slip=0 theta=", "a=3 b=6 omega=0 eta=-30 slip=0 theta="})
  {
    for(const char* const within_them : {"28.295511896", "31.734291170"})
      CHECK(!refused_at(place + within_them));
    for(const char* const beyond : {"28.295511898", "31.734291168"})
      CHECK(refused_at(place + beyond));
  }
  // with a level beam and strings that hang straight down the bound is |2a + the slip| = 0.01(a + b)²:b
  for(const char* const within_them : {"slip=-0.195999999999 a=0.1 b=0.1 omega=0 eta=0 theta=0",
                                       "slip=-0.204000000001 a=0.1 b=0.1 omega=0 eta=0 theta=0",
                                       "slip=-0.390999999999 a=0.2 b=0.1 omega=0 eta=0 theta=0"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"slip=-0.196000000001 a=0.1 b=0.1 omega=0 eta=0 theta=0",
                                  "slip=-0.203999999999 a=0.1 b=0.1 omega=0 eta=0 theta=0",
                                  "slip=-0.391000000001 a=0.2 b=0.1 omega=0 eta=0 theta=0"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("the paths drawn are those of the motion that GSL finds")
{
  const State<> start{{8_deg, 0, 0}, {0, 36_deg, -24_deg}};
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("paths", 9))
    {
      const double time = point.at("lambda_t") * 1_deg;
      const State<> there = time > 0 ? by_gsl(numbers_of(instrument_of_35), start, time, 1e-13) : start;
      const Places<> is = places<double>(instrument_of_35.a, instrument_of_35.b, there.at);
      CHECK(point.value("x") == within(is.x, 1e-11, "GSL's tolerance"));
      CHECK(point.value("y") == within(is.y, 1e-11, "the same"));
      CHECK(point.value("x1") == within(is.x1, 1e-11, "the same"));
      CHECK(point.value("y1") == within(is.y1, 1e-11, "the same"));
    }
}
