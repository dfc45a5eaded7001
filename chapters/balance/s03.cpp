#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "exact/rational.hpp"

SECTION(balance, 3, "The beam: length, weight, moment of inertia")

/*!
## What Euler does

The beam with all that is fixed to it enters the calculation by four numbers. Let $C$ be the point about which
it can turn in a vertical plane; through it are drawn a horizontal line $pq$ {{entry horizontal}} and a
vertical one $Cc$. At the time considered the beam is tilted, and the straight line $ACB$ that stands for it
makes with the horizontal, to both sides, the angle $ACp = BCq = \omega$. From the ends $A$ and $B$ the pans
hang. Then there are

- the length of the arms, $CA = CB = a$;
- the mass or the weight of the beam $M$, with handle, tongue and all other parts that are firmly connected
  with it;
- its centre of gravity $G$, below $C$ by $CG = c$, which with the beam leans from the vertical by the same
  angle, $GCc = \omega$;
- its moment of inertia about $G$, $Mkk$: each particle is multiplied by the square of its distance from $G$
  and all is added up. About $C$ it is therefore

$$ M(kk + cc). \tag{1} $$

::: margin
The parallel axis theorem, and $k$ the radius of gyration. $M$ is a weight: the beam's mass is $M:2g$ where
the unit of force is that of weight.
:::

That is all that the mechanics of a rigid body has to know about the beam; how it is made does not matter. But
it matters that $A$, $C$ and $B$ lie in one line, which is assumed in passing here. A beam whose ends lie a
little lower behaves otherwise ({{sec balance.37}}).

## The program

Let the beam be made. A thin straight rod $ACB$, balanced in $C$, has no reason to become level; something
must hang below. A tongue, a thin rod of the length $l$ that points from $C$ downward and has the part $p$
of the whole weight, is enough:

$$ \begin{gathered} c = \tfrac12pl,\\
   kk + cc = (1-p)\tfrac13aa + p\,\tfrac13ll.
\end{gathered} \tag{A} $$

The radius of gyration about $G$ is got without a difference of squares, which would cost digits where the
tongue is heavy.
*/

const auto a = real("a", 2, feet, scale, "CA = CB, half the beam");
const auto l = real("l", 1, feet, scale, "length of the tongue");
const auto p = real("p", 0.2, none, closed(0, 1), "part of the tongue in the weight");
const auto M = real("M", 2, none, scale, "weight of the beam");
const auto N = integer("N", 8, 1, 100000, "particles in each arm, and in the tongue");

double depth()  // (A)
{
  return p * l / 2;
}

double gyration_about_G()  // kk
{
  const double rod = (1 - p) * a * a / 3;
  return rod + p * l * l * (1. / 12 + (1 - p) / 4);
}

/*!
Euler's own rule, taken at its word, is a sum over particles. The program cuts each arm and the tongue into
$N$ equal pieces and puts the weight of each into its middle: to the distances $\pm x$ from $C$ along the
beam, to the depth $z$ along the tongue.
*/

struct Moments
{
  double G = 0, C = 0;  // Mkk and M(kk + cc)
};

Moments by_particles(int pieces)
{
  Moments sum;
  const double of_arms = M * (1 - p) / pieces, of_tongue = M * p / pieces;
  for(int i = 0; i < pieces; ++i)
  {
    const double part = (i + 0.5) / pieces, x = a * part, z = l * part;
    sum.G += of_arms * (x * x + depth() * depth()) + of_tongue * (z - depth()) * (z - depth());
    sum.C += of_arms * x * x + of_tongue * z * z;
  }
  return sum;
}

TELL
{
  const double kk = gyration_about_G(), c = depth();
  const Moments sum = by_particles(N);
  tell("c", c, feet, "CG, depth of the centre of gravity", 15);
  tell("k", std::sqrt(kk), feet, "radius of gyration about G", 15);
  tell("kk", kk, Unit{"ft²"}, "its square", 15);
  tell("about_G", M * kk, Unit{"ft²"}, "moment of inertia about G, Mkk", 15);
  tell("about_C", M * (kk + c * c), Unit{"ft²"}, "about C, (1)", 15);
  tell("sum_G", sum.G, Unit{"ft²"}, "about G by N particles in each of the three", 12);
  tell("sum_C", sum.C, Unit{"ft²"}, "about C by the same", 12);
  tell("missing", 1 / (4. * N * N), percent, "what the sum about C is too small by", 12);
}

TELL
{
  curve("particles", {"N", "about_C"}, [](Curve& out) {
    for(int pieces = 1; pieces <= 1024; pieces *= 2)
    {
      const Moments sum = by_particles(pieces);
      const double all = M * (gyration_about_G() + depth() * depth());
      out.put({double(pieces), 1 - sum.C / all});
    }
  });
}

/*!
This tongue lowers the centre of gravity by {{c}} ft, little enough for a sluggish balance
({{sec balance.02}}), and the beam's radius of gyration is {{k|6}} ft. From {{N}} particles for each arm and
for the tongue the moment of inertia about $C$ comes out too small by {{missing|percent2}}; it is one part in
$4NN$, whatever the rods.

::: figure balance-03
alt: A straight line on logarithmic axes against the number of particles: it falls by a hundred for ten times
the particles, from a quarter at one particle.

What part is missing of the moment of inertia when each arm and the tongue are replaced by $N$ equal
particles. A beam may be taken for a row of weights: it matters little how fine.
:::

## Checks

The sums are carried out once more with exact fractions, and the integrals with fifty digits.
*/

Fifty over_rods(const std::function<Fifty(const Fifty& x, const Fifty& z)>& of)  // M times a mean
{
  const Fifty A = a.fifty(), l_ = l.fifty(), P = p.fifty();
  const auto rod = exact::integrate([&](const Fifty& x) { return of(x, 0); }, -A, A).value / (2 * A);
  const auto tongue = exact::integrate([&](const Fifty& z) { return of(0, z); }, 0, l_).value / l_;
  return M.fifty() * ((1 - P) * rod + P * tongue);
}

CHECK_THAT("centre of gravity and moments are the integrals over both rods, and (1) is the one about C")
{
  for(const Told& now : told_at("", "p=1 l=3 N=1", "a=1e-90 l=1e-95 p=0.7 M=1e80", "p=1e-9 a=7 N=3"))
  {
    const Fifty c = over_rods([](const Fifty&, const Fifty& z) { return z; }) / M.fifty();
    const Fifty about_G =
        over_rods([&c](const Fifty& x, const Fifty& z) { return x * x + (z - c) * (z - c); });
    const Fifty about_C = over_rods([](const Fifty& x, const Fifty& z) { return x * x + z * z; });
    const Unit square{"ft²"};
    const char* const why = "a dozen roundings, of positive terms alone";
    CHECK(now.value("c", feet) == within_relative(c, 4e-16, "two products"));
    CHECK(now.value("kk", square) == within_relative(about_G / M.fifty(), 2e-15, why));
    CHECK(now.value("k", feet) == within_relative(sqrt(about_G / M.fifty()), 2e-15, why));
    CHECK(now.value("about_G", square) == within_relative(about_G, 2e-15, why));
    CHECK(now.value("about_C", square) == within_relative(about_C, 2e-15, why));
  }
}

Rational exact_sum(int pieces,
                   const Rational& from)  // mean of ((i + ½)/pieces − from)², for 0 the integral
{
  if(pieces == 0)
    return Rational(1, 3) - from + from * from;
  Rational sum;
  for(int i = 0; i < pieces; ++i)
  {
    const Rational x = Rational(2 * i + 1, 2 * pieces) - from;
    sum += x * x;
  }
  return sum / pieces;
}

struct Exactly
{
  Fifty G, C;
};

Exactly in_fractions(int pieces)
{
  const Rational P = Rational::exactly(p), A = Rational::exactly(a), l_ = Rational::exactly(l);
  const Rational c = P / 2, end = exact_sum(pieces, 0);  // c in parts of l
  const Rational arms = (1 - P) * A * A * end;
  const Rational about_G = arms + l_ * l_ * ((1 - P) * c * c + P * exact_sum(pieces, c));
  return {M.fifty() * Fifty(about_G), M.fifty() * Fifty(arms + l_ * l_ * P * end)};
}

CHECK_THAT("the sums over particles are what they are in fractions, and about C they lack one part in 4NN")
{
  for(const Told& now : told_at("", "p=1 l=3 N=1", "a=7 l=4 p=0.7 M=3 N=97", "p=0.5 l=9 a=0.01 N=20"))
  {
    const Unit square{"ft²"};
    const Exactly sum = in_fractions(N);
    CHECK(now.value("sum_G", square) == within_relative(sum.G, 1e-14, "N sums of rounded squares"));
    CHECK(now.value("sum_C", square) == within_relative(sum.C, 1e-14, "the same"));
    const Fifty about_C = over_rods([](const Fifty& x, const Fifty& z) { return x * x + z * z; });
    CHECK(now.value("missing", percent)
          == within_relative(1 - sum.C / about_C, 1e-9, "of the doubles given, and a difference"));
  }
}

CHECK_THAT("the figure's parts are those of the fractions")
{
  for(const Told& now : told_at("", "p=0.9 l=3", "a=7 l=4 p=0.7 M=3"))
    for(const auto& point : now.points("particles", 4))
    {
      const int pieces = static_cast<int>(point.at("N"));
      const Exactly sum = in_fractions(pieces), all = in_fractions(0);
      CHECK(point.value("about_C") == within(1 - sum.C / all.C, 2e-14, "one less a sum of N terms"));
      CHECK(point.value("N") == within(pieces, 0, "a whole number"));
    }
}

/*!
Our copy has the horizontal go through $p$ and $g$. In {{sec balance.05}} $p$ and $q$ are the feet of the
pans' perpendiculars on it, and the only point called $G$ lies below.
*/

double slope_with(double x,
                  double y)  // angle from the vertical Cc of a line from p, 2.4 ft from C, to x, y below
{
  return std::atan2(2.4 + x, y);
}

const Emendation horizontal{
    "§3, the horizontal through C",
    {"p g, were it G", [] { return slope_with(-0.1 * std::sin(15_deg), 0.1 * std::cos(15_deg)); }},
    {"p q", [] { return slope_with(1.5, 0); }},
    "a horizontal makes a right angle with the vertical Cc",
    [](double angle) { return angle == within_ulps(exact::pi() / 2, 1, "an arc"); }};
