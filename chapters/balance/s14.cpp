#include "balance/instrument.hpp"
#include "edition/section.hpp"
#include "exact/ode.hpp"

SECTION(balance, 14, "The beam is a pendulum of the length f")

using namespace balance;

/*!
## What Euler does

The last of the three equations has no other variable than ω and the time, so that the reckoning begins with
it. Put for brevity

$$ \begin{gathered} f = \frac{M(kk+cc) + 2Laa}{Mc},\\
   \text{so that}\quad \frac{f\,dd\omega}{2g\,dt^2} + \omega = 0. \end{gathered} \tag{1} $$

So the beam swings like a simple pendulum of the length $f$, and

$$ \omega = \mathfrak C\sin\Bigl(\gamma + t\sqrt{\frac{2g}f{{entry root_of_2g}}}\Bigr), \tag{2} $$

where $\mathfrak C$ and γ are the constants of the two integrations. A single swing, from one side to the
other, takes in seconds

$$ \pi\sqrt{\frac f{2g}}{{entry time_of_a_swing}}. \tag{3} $$

Written out, the length is

$$ f = c + \frac{kk}c{{entry lengths}} + \frac{2Laa}{Mc}. \tag{4} $$

If the balance were not sluggish, its centre of gravity $G$ being in the centre of motion $C$ itself, then
$c = 0$ would make $f$ infinite, and the beam could take up no swing at all.

::: margin
Today: a physical pendulum; $I\ddot\omega = -(\text{torque})$ with $I = M(kk+cc)+2Laa$, $f = I/Mc$.
:::

The strings have dropped out. To the first order a pan weighs on the end of the beam as if it were fixed
there, whatever its string, and its inertia counts too: it is lifted and lowered with $A$. But as both ends
lie in a line with $C$, the two weights hold each other in balance. The pans make the beam slower without
adding anything to what drives it back.

As a function of $c$ the length has a least value. By {{eq 4}} it is $c + q:c$ with $q = kk + 2Laa:M$, and
since $(c + q:c)^2 - 4q = (c - q:c)^2$,

$$ \begin{gathered} f \geq 2\sqrt{kk + \frac{2Laa}M},\\
   \text{equal at}\quad c = \sqrt{kk + \frac{2Laa}M}. \end{gathered} \tag{A} $$

No beam can be quick that bears heavy pans on long arms, wherever its centre of gravity is put; a
small $c$ makes it slow without limit.

## The program

Here an instrument is given as its maker would give it, and all that the chapter needs of it is told. For
$c = 0$ nothing may be formed by way of $f$, which is infinite, and for very small $c$ neither, since it has
no place in the doubles: the program finds λ from

$$ \lambda\lambda = \frac{2gMc}{M(kk+cc) + 2Laa}. \tag{B} $$

If $c$ is negative, $\kappa = \lambda\sqrt{-1}$ stands in its place ({{sec balance.21}}).
*/

const auto a = real("a", 2, feet, scale, "CA = CB, half the beam");
const auto b = real("b", 2, feet, scale, "AP = BQ, the strings");
const auto c = real("c", 0.1, feet, closed(-1e100, 1e100), "CG, depth of the beam's centre of gravity");
const auto k = real("k", 1.2, feet, scale, "the beam's radius of gyration about G");
const auto L = real("L", 0.5, none, scale, "weight of each pan");
const auto M = real("M", 2, none, scale, "weight of the beam");
const auto g = real("g", 16, feet, scale, "height fallen in the first second");

Instrument given()
{
  return {a, b, c, k * k, L, M, g};
}

const Unit per_second{"1/s"};

TELL
{
  const Quantities q = quantities_of(given());
  const Least least = least_f(given());
  tell("f", q.f, feet, "the pendulum that keeps time with the beam, (1)", 15);
  if(c >= 0)
  {
    tell("lambda", q.lambda, per_second, "λ = √(2g/f), by (B)", 15);
    tell("beam_time", q.beam_time, seconds, "one swing of the beam, (3)", 15);
    tell("i", q.i, per_second, "λμμa/4g, the i of §33", 15);
  }
  else
    tell("kappa", q.kappa, per_second, "κ = √(−2g/f)", 15);
  tell("mu", q.mu, per_second, "μ = √(2g/b), of the pans", 15);
  tell("pan_time", q.pan_time, seconds, "one swing of a pan, π√(b/2g)", 15);
  tell("rho", q.rho, "Laa/I, share of one pan in the whole inertia", 15);
  tell("least_c", least.c, feet, "the c of the quickest beam, (A)", 15);
  tell("least_f", least.f, feet, "its f", 15);
}

double length_at(double depth)  // (4)
{
  return depth + k * k / depth + 2 * L * a * a / (M * depth);
}

TELL
{
  curve("length", {"c", "f", "without_pans"}, [](Curve& out) {
    const double middle = least_f(given()).c;
    for(int j = 0; j <= 120; ++j)
    {
      const double depth = middle * std::pow(10, -2 + j / 30.);
      out.put({depth, length_at(depth), depth + k * k / depth});
    }
  });
}

/*!
With $c$ = {{c}} ft the beam keeps time with a pendulum of {{f|6}} ft and makes a swing in {{beam_time|5}} s;
a pan makes one in {{pan_time|5}} s. The quickest that this beam could be, with its centre of gravity
{{least_c|4}} ft deep, is as a pendulum of {{least_f|4}} ft.

::: figure balance-14
alt: The length of the equivalent pendulum against the depth of the centre of gravity, both logarithmic: a
straight line that falls, a round minimum, a straight line that rises. A second, lower curve is for the beam
without pans.

The length of the pendulum that keeps time with the beam, against the depth $c$ of its centre of gravity, and
the same for the beam without pans. Left of the least value the beam is sluggish because little drives it
back, right of it because the beam itself hangs long.
:::

## Speed against error

Three ways to λ. They differ only where $c$ is small beyond measure, as with `--c 1e-320`.
*/

TELL
{
  if(c > 0)
  {
    const Fifty inertia =
        M.fifty() * (k.fifty() * k.fifty() + c.fifty() * c.fifty()) + 2 * L.fifty() * a.fifty() * a.fifty();
    race("of_lambda", "λ", sqrt(2 * g.fifty() * M.fifty() * c.fifty() / inertia),
         {{"√(2g/f)", [] { return std::sqrt(2 * g / length_at(c)); }},
          {"√(2gMc/I)", [] { return std::sqrt(2 * g * M * c / (M * (k * k + c * c) + 2 * L * a * a)); }},
          {"with c scaled", [] { return quantities_of(given()).lambda; }}});
  }
}

/*!
## Checks

The beam of the check is made of four points: two of weight ½M at the distance $k$ on either side of $G$,
which have the same $M$, $c$ and $k$, and one of weight $L$ at each end. What its weight does and its inertia
are sums over the points.
*/

struct Sums
{
  Fifty inertia;  // Σ weight·distance² from C
  Fifty moment;   // Σ weight·depth below C
};

Sums of_points(const Fifty& depth)
{
  const Fifty half = M.fifty() / 2, square = depth * depth + k.fifty() * k.fifty(), A = a.fifty();
  return {half * square + half * square + L.fifty() * A * A + L.fifty() * A * A,
          half * depth + half * depth};
}

CHECK_THAT("f is where the points' pendulum has its centre of oscillation, and all that follows from it")
{
  const char* const why = "a dozen roundings";
  for(const Told& now :
      told_at("", "a=0.3 b=7 c=0.02 k=5 L=3 M=0.1 g=4.9", "c=1e-300 b=1e-60", "c=1e80 L=1e-9",
              "L=1 b=2 k=1.1547005383792515 c=1e-8", "a=1e40 b=1e30 k=1e41 c=1e35 M=1e50"))
  {
    const auto [inertia, moment] = of_points(c.fifty());
    const Fifty f = inertia / moment, G = 2 * g.fifty();
    CHECK(now.value("f", feet) == within_relative(f, 1e-15, why));
    CHECK(now.value("lambda", per_second) == within_relative(sqrt(G / f), 1e-15, why));
    CHECK(now.value("beam_time", seconds) == within_relative(exact::pi() * sqrt(f / G), 1e-15, why));
    const Fifty mu_ = sqrt(G / b.fifty());
    CHECK(now.value("i", per_second)
          == within_relative(sqrt(G / f) * mu_ * mu_ * a.fifty() / (2 * G), 2e-15, why));
    CHECK(now.value("mu", per_second) == within_relative(mu_, 1e-15, why));
    CHECK(now.value("pan_time", seconds) == within_relative(exact::pi() / mu_, 1e-15, why));
    CHECK(now.value("rho") == within_relative(L.fifty() * a.fifty() * a.fifty() / inertia, 2e-15, why));
    CHECK(now.exact("of_lambda") == within_relative(sqrt(G / f), 1e-45, "fifty digits"));
    CHECK(now.method("of_lambda", "√(2g/f)") == within_relative(sqrt(G / f), 2e-15, why));
    CHECK(now.method("of_lambda", "√(2gMc/I)") == within_relative(sqrt(G / f), 2e-15, why));
    CHECK(now.method("of_lambda", "with c scaled") == within_relative(sqrt(G / f), 1e-15, why));
  }
}

CHECK_THAT("where c is 10⁻³²⁰ f has no place in the doubles, but λ has; at c = 0 it is nothing")
{
  for(const Told& now : told_at("c=1e-320", "c=4e-324 g=1e-9 M=5"))
  {
    const auto [inertia, moment] = of_points(Fifty(double(c)));
    const Fifty right = sqrt(2 * g.fifty() * moment / inertia);
    CHECK(now.value("f", feet) == infinite("above 1e308"));
    CHECK(now.value("lambda", per_second)
          == within_relative(right, 1e-15, "of the c that a double can be"));
    CHECK(now.value("beam_time", seconds) == within_relative(exact::pi() / right, 1e-15, "the same"));
    CHECK(now.value("i", per_second)
          == within_relative(right * a.fifty() / (2 * b.fifty()), 2e-15, "the same"));
    CHECK(now.method("of_lambda", "√(2g/f)") == within(0, 0, "the length overflows"));
    CHECK(now.method("of_lambda", "with c scaled") == within_relative(right, 1e-15, "the same"));
  }
  // nor need 2gMc or the inertia have one
  for(const Told& now :
      told_at("c=1e-149 g=1e-60 M=1e-100 a=1e-80 k=1e-90 L=1e-100", "a=1e100 L=1e100 M=1e-100"))
  {
    const auto [inertia, moment] = of_points(c.fifty());
    const Fifty right = sqrt(2 * g.fifty() * moment / inertia);
    CHECK(now.value("lambda", per_second) == within_relative(right, 1e-15, "roots taken one by one"));
    CHECK(now.value("beam_time", seconds) == within_relative(exact::pi() / right, 1e-15, "the same"));
  }
  for(const Told& now : told_at("c=0"))
  {
    CHECK(now.value("f", feet) == infinite("G lies in C"));
    CHECK(now.value("beam_time", seconds) == infinite("no swing at all"));
    CHECK(now.value("lambda", per_second) == within(0, 0, "nothing drives it back"));
    CHECK(now.value("i", per_second) == within(0, 0, "with λ"));
  }
}

CHECK_THAT("above C the centre of gravity gives a negative f, and κ is the rate of √(−2g/f)")
{
  for(const Told& now : told_at("c=-0.1", "c=-1e-310 L=3", "c=-7 a=1 k=0.1 g=5"))
  {
    const auto [inertia, moment] = of_points(Fifty(double(c)));
    CHECK(now.value("kappa", per_second)
          == within_relative(sqrt(-2 * g.fifty() * moment / inertia), 1e-15, "a dozen roundings"));
    if(c < -1e-300)
      CHECK(now.value("f", feet) == within_relative(inertia / moment, 1e-15, "a dozen roundings"));
  }
}

CHECK_THAT("(A): at the c told f is the length told, and greater on either side of it")
{
  for(const Told& now : told_at("", "a=0.3 k=5 L=3 M=0.1 c=-3", "L=1e-60 k=1e-9", "c=1e60 M=1e-30",
                                "a=1e100 L=1e100 M=1e-100"))
  {
    const auto length = [](const Fifty& depth) {
      const auto [inertia, moment] = of_points(depth);
      return Fifty(inertia / moment);
    };
    const Fifty A = a.fifty(), own = k.fifty() * k.fifty() + 2 * L.fifty() * A * A / M.fifty();
    // the place by bisection: where f(x(1 − h)) and f(x(1 + h)) change order
    Fifty low = sqrt(own) / 8, high = 8 * sqrt(own);
    for(int j = 0; j < 60; ++j)
    {
      const Fifty x = (low + high) / 2, h("1e-20");
      (length(x * (1 + h)) < length(x * (1 - h)) ? low : high) = x;
    }
    CHECK(now.value("least_c", feet) == within_relative(low, 1e-15, "sixty halvings, few roundings"));
    CHECK(now.value("least_f", feet) == within_relative(length(low), 1e-15, "level there"));
    CHECK(length(low * 2) > length(low));
    CHECK(length(low / 2) > length(low));
  }
}

CHECK_THAT("(2) is the motion of (1): integrated to thirty digits it arrives where the sine is")
{
  const Fifty f = Fifty(69) / 2, root = sqrt(32 / f), C = Fifty(1) / 6, phase("0.4");
  const exact::RightSide right = [&](const Fifty&, const exact::State& y) {  // (1), 2g = 32
    return exact::State{y[1], -y[0] * 32 / f};
  };
  for(const char* time : {"0.5", "3.262", "20"})
    CHECK(exact::solve(right, 0, {C * sin(phase), C * root * cos(phase)}, Fifty(time), Fifty("1e-28")).y[0]
          == within(C * sin(phase + Fifty(time) * root), 1e-24, "the integration"));
}

CHECK_THAT("the figure has (4), with the pans and without")
{
  for(const Told& now : told_at("", "a=7 k=0.3 L=2 M=1"))
    for(const auto& point : now.points("length", 7))
    {
      const auto [inertia, moment] = of_points(Fifty(point.at("c")));
      const Fifty pans = 2 * L.fifty() * a.fifty() * a.fifty();
      CHECK(point.value("f") == within_relative(inertia / moment, 1e-15, "few roundings"));
      CHECK(point.value("without_pans") == within_relative((inertia - pans) / moment, 1e-15, "the same"));
    }
}

/*!
Three readings of our copy cannot stand. In {{eq 2}} it has $g$ for $2g$; {{sec balance.21}} and
{{sec balance.24}} have $2g$. In {{eq 3}} it has $f:g$ without a root or a π, though the example of
{{sec balance.35}} with λ = 1 gives π seconds; and in {{eq 4}} $c:g$ for $c$, which would be no length.
*/

const Emendation root_of_2g{"§14, the root in ω",
                            {"√(g/f)", [] { return std::sqrt(16 / 34.5); }},
                            {"√(2g/f)", [] { return std::sqrt(32 / 34.5); }},
                            "the equation for ω just above it demands it",
                            [](double root) {  // fω̈/2g + ω of sin(root·t), over sin
                              return root > 0
                                     && 34.5 / 32 * root * root == within_ulps(1, 4, "few roundings");
                            }};

const Emendation time_of_a_swing{
    "§14, the time of a swing",
    {"f/g", 34.5 / 16},
    {"π√(f/2g)", [] { return std::numbers::pi * std::sqrt(34.5 / 32); }},
    "after that time, and no earlier, the sine of (2) is what it was with the other sign",
    [](double time) {
      const double root = std::sqrt(32 / 34.5);
      const bool reversed = std::cos(root * time) == within(-1, 1e-15, "a phase rounded");
      return reversed && time == between(0, 1.5 * std::numbers::pi / root, "the first time");
    }};

const Emendation lengths{"§14, f written out",
                         {"c/g + kk/c + 2Laa/Mc", 0.1 / 16 + 14.4 + 20},
                         {"c + kk/c + 2Laa/Mc", 0.1 + 14.4 + 20},
                         "it is (1) divided out, and a sum of lengths",
                         [](double f) {  // M = 2, L = ½, a = 2, c = 0.1, k = 1.2
                           return f * 2 * 0.1 == within_ulps(2 * (1.44 + 0.01) + 4, 8, "few roundings");
                         }};

/*!
## Go on from here

::: exercise
Move the centre of gravity until beam and pans keep the same time. Where does it lie, and is it possible with
every length of the strings?

answer: $f = b$ gives $cc - bc + kk + 2Laa:M = 0$; by {{eq A}} the strings must not be shorter than
{{least_f|4}} ft in the example. With `--b 4` it is possible at two depths of $G$, $2\pm\sqrt{0.56}$ ft.
:::
*/

CHECK_THAT(
    "with strings of four feet beam and pans keep the same time at two depths of G, and not between them")
{
  for(const double depth : {2 - std::sqrt(0.56), 2 + std::sqrt(0.56)})
    CHECK(length_at(depth) == within_ulps(4, 8, "few roundings"));
  CHECK(length_at(2) < 4);
  for(const Told& now : told_at("b=4"))
    CHECK(now.value("least_f", feet) == between(3, 4, "so that 4 is possible"));
}
