#include "balance/hung.hpp"
#include "edition/section.hpp"

SECTION(balance, 2, "A sluggish balance")

using namespace balance;

/*!
## What Euler does

From the word {{term sluggish}} in the report Euler reads off where the centre of gravity of the beam must
lie: below the point about which it turns. If it lay in that point the beam would rest in every position, and
above it the beam would fall over. A beam that seeks its level, and seeks it slowly, has it a little below.

Besides it is easily understood, he says, that one pan cannot have acted on the other unless the beam was
tilted. Therefore both have to be looked at together: at any time, $t$ {{entry time_letter}} seconds after
the beginning, the position of the beam and that of the pans.

Sluggishness and sensitivity are one and the same. An overweight δ in one pan tilts a beam that is at rest by
the angle ω at which its moment is that of the beam's own weight,

$$ \begin{gathered} \delta\,a\cos\omega = Mc\sin\omega,\\
   \tan\omega = \frac{\delta\,a}{Mc},
\end{gathered} \tag{A} $$

and a small swing of the beam lasts $\pi\sqrt{f:2g}$ from side to side, where $f = I:Mc$ and $I =
M(kk+cc)+2Laa$ ({{sec balance.14}}). Of the two the depth $c$ drops out where one divides by the square of
the other:

$$ \frac{\tan\omega}{(\text{time})^2} = \frac{2g\,\delta\,a}{\pi^2\,I}. \tag{B} $$

A balance that shows a weight ten times as small swings $\sqrt{10}$ times as slowly, whatever else is done
to it, as long as $c$ is small and its arms and masses remain.

::: margin
Today: stable equilibrium; $c$ is the metacentric height of the beam.
:::

The second remark is what keeps him from the solution. It is true if the point $C$ stands fast. If $C$ can
give way sideways, one pan acts on the other over a beam that stays level: with its centre of gravity in $C$
itself the beam of {{sec balance.01}} takes no part in small swings at all, and the exchange goes on.

## The program
*/

const auto a = real("a", 2, feet, closed(1e-3, 1e3), "CA = CB, half the beam");
const auto b = real("b", 2, feet, closed(1e-3, 1e3), "AP = BQ, the strings");
const auto c = real("c", 0.1, feet, closed(1e-300, 1e3), "CG, depth of the beam's centre of gravity");
const auto k = real("k", 1.1547, feet, closed(1e-3, 1e3), "the beam's radius of gyration about G");
const auto L = real("L", 0.5, none, closed(1e-6, 1e6), "weight of each pan");
const auto M = real("M", 2, none, closed(1e-6, 1e6), "weight of the beam");
const auto g = real("g", 16, feet, closed(1e-3, 1e3), "height fallen in the first second");
const auto overweight = real("overweight", 0.005, none, closed(1e-6, 1e3), "overweight δ in the pan Q");
const auto omega =
    angle("omega", 15_deg, closed(-60_deg, 60_deg), "inclination ω of the beam, for the plate");
const auto eta = angle("eta", 22_deg, closed(-60_deg, 60_deg), "inclination η of the string AP");
const auto theta = angle("theta", 32_deg, closed(-60_deg, 60_deg), "inclination ϑ of the string BQ");
const auto CG = real("CG", 0.25, none, closed(0.05, 1), "how long CG is drawn, in parts of CA");

const auto given = [] { return Instrument{a, b, c, k * k, L, M, g}; };

double beam_time(double depth)  // π√(f : 2g)
{
  Instrument lowered = given();
  lowered.c = depth;
  return quantities_of(lowered).beam_time;
}

double tilt_at(double depth)  // (A)
{
  return std::atan2(overweight * a, M * depth);
}

TELL
{
  const double I = M * (k * k + c * c) + 2 * L * a * a;
  tell("tilt", tilt_at(c), degrees, "ω under the overweight, (A)", 15);
  tell("beam_time", beam_time(c), seconds, "one small swing of the beam", 14);
  tell("gain", 2 * g * overweight * a / (std::numbers::pi * std::numbers::pi * I), Unit{"1/s²"},
       "tan ω over the square of the time, (B)", 14);
}

const auto level = [] {
  Suspended s = designed;
  s.beam.c = 0;
  return s;
};

TELL
{
  tell("T_level", transfer(level()).time, seconds, "§1's balance with G in C: the motion passes in", 14);
  tell("beam_there", std::abs(modes(level())[3].shape.omega), degrees,
       "lean of its beam there, for 1 rad of the pans");
}

/*!
The plate of the paper is drawn from its letters ({{sec balance.03}} to {{sec balance.06}}), $A$ to the left
as in the text, ω lifting $A$, both strings leaning by positive angles.
*/

TELL
{
  curve("plate", {"x", "y"}, [](Curve& out) {
    const auto [x, y, x1, y1] = places<double>(a, b, {omega, eta, theta});
    const double across = a * std::cos(omega), up = a * std::sin(omega);
    const double deep = CG * a;
    out.put({-across, up});                                       // A
    out.put({across, -up});                                       // B
    out.put({0, 0});                                              // C
    out.put({-deep * std::sin(omega), -deep * std::cos(omega)});  // G
    out.put({-x, -y});                                            // P
    out.put({x1, -y1});                                           // Q
    out.put({-x, 0});                                             // p
    out.put({x1, 0});                                             // q
    out.put({-across, 0});                                        // α
    out.put({across, 0});                                         // ε
    out.put({across, -up - b});                                   // β
    out.put({-x, up});                                            // r
    out.put({x1, -up});                                           // s
  });
  curve("slow", {"c", "tilt", "time"}, [](Curve& out) {
    for(int j = -40; j <= 0; ++j)
    {
      const double depth = a * std::pow(10, j / 10.);
      out.put({depth, tilt_at(depth) / 1_deg, beam_time(depth)});
    }
  });
}

/*!
A hundredth of a pan's weight tilts this balance by {{tilt|3}}, and its beam takes {{beam_time|3}} s from side
to side.

::: figure balance-02
alt: A beam, its left end A lifted, turning about C. Below C the centre of gravity G. From A and B hang
strings with weights P and Q, both leaning to the left. Thin lines: the horizontal through C with the feet
p, alpha, epsilon and q, the vertical through C, the verticals and normals of both pans.

The figure of the paper (Tab. III, Fig. 2), drawn anew from its letters. $CG$ is drawn too long. ε is the foot
on the horizontal above $B$, β a point of the vertical below it, $r$ and $s$ the feet of the normals.
:::

::: figure balance-02-slow
alt: Two lines against the depth of the centre of gravity, both axes logarithmic. From right to left the tilt
rises, at first ten times for a depth ten times smaller, and bends towards 90 degrees; the time of swing rises
half as steeply.

Tilt under an overweight and time of swing, for one balance whose centre of gravity is brought nearer and
nearer to $C$. One cannot have the one without the other.
:::

## Checks
*/

Fifty moment(const Fifty& at)  // on the beam at rest, pans hanging straight down, Q heavier by δ
{
  const Fifty A = a.fifty(), P = L.fifty(), Q = P + overweight.fifty();
  return M.fifty() * c.fifty() * sin(at) + P * A * cos(at) - Q * A * cos(at);
}

CHECK_THAT("at the inclination told the moments of beam and pans are in balance, on which side B is lower")
{
  for(const Told& now :
      told_at("", "overweight=1e-6 a=0.01 c=30 M=700", "c=1e-300 overweight=2", "c=1e-9 b=7 M=1e-6"))
  {
    Fifty low = 0, high = exact::pi() / 2;  // B sinks until the moment of the beam's weight is great enough
    for(int step = 0; step < 170; ++step)
    {
      const Fifty middle = (low + high) / 2;
      (moment(middle) > 0 ? high : low) = middle;
    }
    CHECK(now.value("tilt", degrees) == within_ulps(low, 3, "two products and an arc"));
  }
}

CHECK_THAT("the time is that of a pendulum of the length I : Mc, and (B) the quotient of the two")
{
  for(const Told& now :
      told_at("", "overweight=1e-6 a=0.01 c=30 M=700", "c=1e-250 L=2", "c=1e-9 b=7 M=1e-6"))
  {
    const Fifty Laa = L.fifty() * a.fifty() * a.fifty(), cc = c.fifty() * c.fifty();
    const Fifty I = M.fifty() * (k.fifty() * k.fifty() + cc) + 2 * Laa;
    const Fifty f = I / (M.fifty() * c.fifty()), time = exact::pi() * sqrt(f / (2 * g.fifty()));
    CHECK(now.value("beam_time", seconds) == within_relative(time, 3e-15, "a dozen roundings"));
    const Fifty slope = overweight.fifty() * a.fifty() / (M.fifty() * c.fifty());
    CHECK(now.value("gain", Unit{"1/s²"}) == within_relative(slope / (time * time), 3e-15, "the same"));
  }
}

CHECK_THAT("with G in C the beam stays level, and the pans pass their motion on all the same")
{
  for(const Told& now : told_at("", "c=0.5"))
  {
    const auto& [A, B, C, KK, pan, beam, G] = level().beam;
    const Fifty nu2 = 2 * Fifty(G) / level().h, mu2 = 2 * Fifty(G) / B;
    const Fifty rest = 1 - 2 * Fifty(pan) / (Fifty(beam) + 2 * Fifty(pan));
    // (νν − s)(μμ − s) = ess, e being the pans' part in the whole weight
    const Fifty s = (nu2 + mu2 + sqrt((nu2 + mu2) * (nu2 + mu2) - 4 * rest * nu2 * mu2)) / (2 * rest);
    const Fifty T = exact::pi() / (sqrt(s) - sqrt(mu2));
    CHECK(now.value("T_level", seconds) == within_relative(T, 1e-14, "a difference of frequencies"));
    CHECK(now.value("beam_there", degrees) == within(0, 0, "nothing turns it"));
  }
}

CHECK_THAT("in the second figure a tenth of the depth gives ten times the slope and the root of it in time")
{
  for(const Told& now : told_at("", "a=0.5 M=9", "L=3 overweight=0.1"))
  {
    const auto all = now.points("slow");
    REQUIRE(all.size() == 41);
    for(const auto& point : all)
    {
      const Fifty C(point.at("c")), A = a.fifty(), W = M.fifty();
      const Fifty slope = overweight.fifty() * A / (W * C);
      CHECK(point.value("tilt") == within_relative(atan(slope) * 180 / exact::pi(), 2e-15, "an arc"));
      const Fifty I = W * (k.fifty() * k.fifty() + C * C) + 2 * L.fifty() * A * A;
      CHECK(point.value("time")
            == within_relative(exact::pi() * sqrt(I / (2 * g.fifty() * W * C)), 3e-15, "a root"));
    }
    CHECK(all[0].value("c") == within_relative(Fifty(double(a)) * 1e-4, 1e-15, "ten powers to the decade"));
    CHECK(all[40].value("c") == within_relative(Fifty(double(a)), 1e-15, "the same"));
    CHECK(all[0].at("time") / all[10].at("time") == within(std::sqrt(10), 1e-3, "cc beside kk"));
  }
}

/*!
The plate is measured: lengths, angles, feet.
*/

CHECK_THAT("the plate has the paper's lengths, angles and right angles")
{
  for(const Told& now : told_at("", "a=1 b=3 omega=-40 eta=-10 theta=50 CG=0.5", "omega=0 eta=0 theta=5"))
  {
    const auto all = now.points("plate");
    REQUIRE(all.size() == 13);
    const auto x = [&all](std::size_t i) { return Fifty(all[i].at("x")); };
    const auto y = [&all](std::size_t i) { return Fifty(all[i].at("y")); };
    enum : std::size_t
    {
      A,
      B,
      C,
      G,
      P,
      Q,
      p,
      q,
      alpha,
      epsilon,
      beta,
      r,
      s
    };
    // the point at the distance d from another, turned by `by` from straight below it towards the side of A
    const auto hangs = [&](std::size_t i, std::size_t from, double d, const Fifty& by) {
      CHECK(all[i].value("x") == within(x(from) - d * sin(by), 5e-16 * (a + b), "drawn to scale"));
      CHECK(all[i].value("y") == within(y(from) - d * cos(by), 5e-16 * (a + b), "the same"));
    };
    const Fifty quarter = exact::pi() / 2;
    CHECK(all[C].value("x") == within(0, 0, "C is the origin"));
    CHECK(all[C].value("y") == within(0, 0, "the same"));
    hangs(A, C, a, quarter + omega.fifty());
    hangs(B, C, a, omega.fifty() - quarter);
    hangs(G, C, CG * a, omega.fifty());
    hangs(P, A, b, eta.fifty());
    hangs(Q, B, b, theta.fifty());
    hangs(beta, B, b, 0);
    const auto meet = [&](std::size_t i, std::size_t upright, std::size_t flat) {
      CHECK(all[i].value("x") == within(x(upright), 0, "on the vertical"));
      CHECK(all[i].value("y") == within(y(flat), 0, "on the horizontal"));
    };
    meet(p, P, C);
    meet(q, Q, C);
    meet(alpha, A, C);
    meet(epsilon, B, C);
    meet(r, P, A);
    meet(s, Q, B);
  }
}

/*!
Our copy calls the time $k$. That letter is taken by the radius of gyration in the next section, and from
{{sec balance.07}} on the time is $t$.
*/

double fallen(double time)  // in heights g, under II of § 7 with the string cut: ddy = 2g dt²
{
  return time * time;
}

const Emendation time_letter{
    "§2, the time since the beginning, after one second",
    {"k, which is 1.1547 for the beam given", [] { return 1.1547; }},
    {"t", 1},
    "what falls freely comes through the height g in this time (§8)",
    [](double time) { return time >= 0 && fallen(time) == within_ulps(1, 1, "a square"); }};

/*!
## Go on from here

::: exercise
Make the balance of the figure show a tenth of the overweight as it now shows the whole. How long is its swing
then?

answer: With `--c 0.01 --overweight 0.0005` the tilt is the same, and the time has grown by the root of ten,
but for the little that $cc$ adds to $kk$.
:::
*/

CHECK_THAT("a tenth of the depth and of the overweight: the same tilt, the root of ten times the time")
{
  const double before = tilt_at(c);
  for(const Told& now : told_at("c=0.01 overweight=0.0005"))
  {
    CHECK(now.value("tilt", degrees) == within_relative(Fifty(before), 1e-15, "the same quotient"));
    CHECK(now.value("beam_time", seconds)
          == within_relative(sqrt(Fifty(10)) * beam_time(0.1), 0.002, "cc"));
  }
}
