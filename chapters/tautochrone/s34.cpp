#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/series.hpp"

SECTION(tautochrone, 34, "The cheek by points")

using namespace tautochrone;

/*!
## What Euler does

The formulae of {{sec tautochrone.33}}, integrated, give both coordinates of the cheek for any angle, so
that it can be drawn by points; with that the paper ends. The abscissa $AP$ is

$$ p = \tfrac12a\sin^2\varphi + \frac{kk\sin^2\varphi}{2a} - \frac{3kk}{2a} + \frac{3kk}{2a\cos^2\varphi} -
\frac{15k^4}{2a^3{{entry cube_of_a}}\cos^4\varphi} + \frac{7k^4}{a^3\cos^6\varphi} + \frac{k^4}{2a^3}.
  \tag{1} $$

For the ordinate one needs

$$ \int d\varphi\sin^2\varphi = \tfrac12\varphi - \tfrac12\sin\varphi\cos\varphi, \tag{2} $$

$$ \int\frac{d\varphi}{\cos^2\varphi} = \frac{\sin\varphi}{\cos\varphi}, \qquad
    \int\frac{d\varphi}{\cos^4\varphi} = \frac{\sin\varphi}{3\cos^3\varphi} +
  \frac{2\sin\varphi}{3\cos\varphi}, \tag{3} $$

$$ \int\frac{d\varphi}{\cos^6\varphi} = \frac{\sin\varphi}{5\cos^5\varphi} +
  \frac{4\sin\varphi}{15\cos^3\varphi} + \frac{8\sin\varphi}{15\cos\varphi}, \tag{4} $$

$$ \int\frac{d\varphi}{\cos^8\varphi} = \frac{\sin\varphi}{7\cos^7\varphi} +
  \frac{6\sin\varphi}{35\cos^5\varphi} +
   \frac{8\sin\varphi}{35\cos^3\varphi} + \frac{16\sin\varphi}{35\cos\varphi}, \tag{5} $$

and has

$$ \begin{aligned} q &= \tfrac12a\varphi - \tfrac12a\sin\varphi\cos\varphi + \frac{kk\varphi}{2a} -
  \frac{kk\sin\varphi\cos\varphi}{2a}
  - \frac{kk\sin\varphi}{a\cos\varphi} + \frac{kk\sin\varphi}{a\cos^3\varphi} \\
   &+ \frac{k^4\sin\varphi}{a^3\cos\varphi}\Bigl(\frac45 + \frac2{5\cos^2\varphi} -
  \frac{36}{5\cos^4\varphi} + \frac6{\cos^6\varphi}\Bigr).
  \end{aligned} \tag{6} $$

Since both coordinates, $p$ and $q$, can be had from the given angle φ, which is also the amplitude of the
arc $AM$, the curve that was sought, $AMB$, is constructed without difficulty.

::: margin
The cheek's amplitude is the angle through which its tangent has turned.
:::

How good is a clock with such cheeks? For narrow swings the excess of the time can be had in finite terms:
with $n$ corrections in the radius it is

$$ \frac T{T_0} - 1 = \frac{kk}{aa+kk}\Bigl(\frac{3kk}{aa}\Bigr)^{\!n}\frac{\varphi_0^2}4 \text{
  nearly}, \tag{A} $$

so that each correction is worth the factor $3kk/aa$.

## The program

The workshop gets a table of points, and beside it how far the cheek stands off from Huygens's, which has
$k = 0$.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto phi = angle("phi", 30_deg, closed(0_deg, 85_deg),
                       "angle of the thread with the vertical, where it leaves the cheek");
const auto phi0 =
    angle("phi0", 5_deg, open(0_deg, 80_deg), "how far the clock's pendulum swings to either side");

double law(int n)  // (A)
{
  const double kappa = k / a * (k / a);
  return kappa / (1 + kappa) * std::pow(3 * kappa, n) * phi0 * phi0 / 4;
}

TELL
{
  require(k / a <= 1, "k", "at most a");
  tell("p", euler_p<double>(a, k, phi), metres, "AP, how far M is below A");
  tell("q", euler_q<double>(a, k, phi), metres, "PM, how far it is from the vertical");
  if(k / a >= 1e-10 && phi0 < largest_amplitude(Cheeks::euler_k4, k / a))
  {
    const double over = excess(Cheeks::euler_k4, k / a, phi0);
    tell("excess", over, "T/T₀ − 1 between such cheeks");
    tell("late", 86'400 * over, seconds, "what the clock loses in a day");
    tell("law", law(2), "(A), n = 2");
  }
  auto& rows = table("cheek", "The cheek by points, in metres",
                     {{"phi", "φ", degrees, 3},
                      {"p", "p", metres, 8},
                      {"q", "q", metres, 8},
                      {"p_off", "p off Huygens's", metres, 4},
                      {"q_off", "q off Huygens's", metres, 4}});
  for(int i = 5; i <= 60; i += i < 30 ? 5 : 10)
  {
    const double here = i * 1_deg, p = euler_p<double>(a, k, here), q = euler_q<double>(a, k, here);
    rows.row({here, p, q, p - euler_p<double>(a, 0, here), q - euler_q<double>(a, 0, here)});
  }
}

TELL
{
  curve("cheeks", {"p", "q", "ratio"}, [](Curve& out) {
    for(const double ratio : {0.0, 0.1, 0.3})
    {
      const double last = std::min(largest_amplitude(Cheeks::euler_k4, ratio), 89_deg);
      for(int i = 0; i <= 100; ++i)
        out.put(
            {euler_p<double>(1, ratio, last * i / 100), euler_q<double>(1, ratio, last * i / 100), ratio});
      out.block();
    }
  });
  curve("exact", {"p", "q"}, [](Curve& out) {
    std::vector<double> angles;
    for(int i = 1; i <= 60; ++i)
      angles.push_back(end(Member::highest, 0.3).phi * i / 60.001);
    for(const auto& place_ : drawn(Member::highest, 0.3, angles))
      out.put({place_.p, place_.q});
  });
}

/*!
A clock with such cheeks, $k = \tfrac1{10}a$, loses {{late|e3}} s in a day if it swings 5°. The cheek
stands off from Huygens's by more than a workshop can neglect:

{{table cheek}}

::: figure tautochrone-34
alt: Three cheeks hang from one cusp; the larger k is, the more steeply they run down. The dashed exact
cheek for three tenths is steeper still, and short.

The cheek for $k = 0$, for $\tfrac1{10}a$ and for $\tfrac3{10}a$, each up to the depth $0{,}62a$ at most.
Dashed, the cheek of the highest exact tautochrone for $\tfrac3{10}a$: of so large a body Euler's is no
longer near.
:::

## Checks
*/

CHECK_THAT("the points told are Euler's (1) and (6), as they stand, in fifty digits")
{
  for(const Told& now :
      told_at("", "a=2 k=0.7 phi=80", "a=3e60 k=3e58 phi=1e-8", "a=1e-40 k=1e-60 phi=60", "phi=1e-12"))
  {
    const auto both = [&](const Fifty& x) {
      const Fifty kk = pow(k.fifty() / a.fifty(), 2), k4 = kk * kk, c = cos(x), s = sin(x), cc = c * c,
                  c4 = cc * cc, c6 = c4 * cc;
      const Fifty p =
          (1 + kk) * s * s / 2 - 3 * kk / 2 + 3 * kk / (2 * cc) - 15 * k4 / (2 * c4) + 7 * k4 / c6 + k4 / 2;
      const Fifty q = (1 + kk) * (x - s * c) / 2 - kk * s / c + kk * s / (c * cc)
                      + k4 * s / c * (Fifty(4) / 5 + 2 / (5 * cc) - 36 / (5 * c4) + 6 / c6);
      return std::pair{a.fifty() * p, a.fifty() * q};
    };
    const auto [p, q] = both(phi.fifty());
    const char* const why = "the library's bound, and the angle's rounding";
    CHECK(now.value("p", metres) == within_relative(p, 2e-14, why));
    CHECK(now.value("q", metres) == within_relative(q, 2e-14, why));
    for(const auto& row : now.rows("cheek"))
    {
      const Fifty x = row.at("phi", degrees), c = cos(x), s = sin(x);
      const auto [p_, q_] = both(x);
      CHECK(row.value("p", metres) == within_relative(p_, 2e-14, why));
      CHECK(row.value("q", metres) == within_relative(q_, 2e-14, why));
      CHECK(row.value("p_off", metres)
            == within(p_ - a.fifty() * s * s / 2, 3e-14 * double(p_), "a difference of two"));
      CHECK(row.value("q_off", metres)
            == within(q_ - a.fifty() * (x - s * c) / 2, 3e-14 * double(q_), "a difference of two"));
    }
  }
}

CHECK_THAT("(1) and (6) are the integrals of ds cos φ and ds sin φ, ds being that of § 33")
{
  const Fifty A = 2, K("0.6"), to("0.8");
  for(const bool across : {false, true})
  {
    const Fifty sum =
        exact::integrate([&](const Fifty& x) { return euler_ds(A, K, x) * (across ? sin(x) : cos(x)); }, 0,
                         to)
            .value;
    CHECK((across ? euler_q(A, K, to) : euler_p(A, K, to)) == within_relative(sum, 1e-38, "a quadrature"));
  }
}

CHECK_THAT("the integrals (2) to (5) are right: quadrature")
{
  const Fifty to("0.9"), s = sin(to), c = cos(to);
  const auto over = [&](int power) {
    return exact::integrate([=](const Fifty& x) { return pow(cos(x), -power); }, 0, to).value;
  };
  const char* const why = "quadrature";
  CHECK(
      (to - s * c) / 2
      == within(exact::integrate([](const Fifty& x) { return pow(sin(x), 2); }, 0, to).value, 1e-38, why));
  CHECK(s / c == within(over(2), 1e-38, why));
  CHECK(s / (3 * pow(c, 3)) + 2 * s / (3 * c) == within(over(4), 1e-38, why));
  CHECK(s / (5 * pow(c, 5)) + 4 * s / (15 * pow(c, 3)) + 8 * s / (15 * c) == within(over(6), 1e-37, why));
  CHECK(s / (7 * pow(c, 7)) + 6 * s / (35 * pow(c, 5)) + 8 * s / (35 * pow(c, 3)) + 16 * s / (35 * c)
        == within(over(8), 1e-36, why));
}

CHECK_THAT(
    "a thread of the length a, wound on this cheek, leads the centre of gravity along the curve of § 32")
{
  for(const char* ratio : {"0.02", "0.1", "0.3"})
    for(const char* at_ : {"1e-6", "0.4", "0.8"})
    {
      const Fifty K(ratio), x(at_), r = euler_r<Fifty>(1, K, x);
      CHECK(1 - euler_p<Fifty>(1, K, x) - r * cos(x)
            == within(euler_x<Fifty>(1, K, x), 1e-45, "a difference"));
      CHECK(euler_q<Fifty>(1, K, x) + r * sin(x) == within(euler_y<Fifty>(1, K, x), 1e-45, "a sum"));
    }
}

CHECK_THAT("what the clock loses is what the equation leaves: the law (A) for swings however narrow, and "
           "for any number of corrections")
{
  for(const Told& now : told_at("", "phi0=1e-6 k=0.3", "phi0=1e-60 k=0.01 a=2", "phi0=0.1 k=0.05"))
  {
    const Fifty kappa = pow(k.fifty() / a.fifty(), 2), pp = pow(phi0.fifty(), 2);
    const Fifty law_ = 9 * pow(kappa, 3) / (1 + kappa) * pp / 4;
    CHECK(now.value("law") == within_relative(law_, 4e-15, "a dozen roundings"));
    const double wider = 1e-12 + 12 * double(pp);
    CHECK(now.value("excess") == within_relative(law_, wider, "the next term, some ten times φ₀φ₀"));
    CHECK(now.value("late", seconds) == within_relative(86'400 * law_, wider, "the same"));
  }
  for(const auto& [cheeks, n] :
      {std::pair{Cheeks::cycloids, 0}, {Cheeks::euler_kk, 1}, {Cheeks::euler_k4, 2}})
  {
    const Fifty kappa = pow(Fifty(0.2), 2);
    CHECK(excess(cheeks, 0.2, 1e-8)
          == within_relative(kappa / (1 + kappa) * pow(3 * kappa, n) * Fifty(1e-16) / 4, 1e-12,
                             "the library's bound"));
  }
}

CHECK_THAT("in the figure Euler's cheeks are (1) and (6), and the exact one has the length that its thread "
           "leaves free")
{
  for(const Told& now : told_at(""))
  {
    for(const auto& point : now.points("cheeks", 7))
    {
      const Fifty K = point.at("ratio");
      Fifty lo = 0, hi = Fifty(89) * exact::pi() / 180;  // the angle at which the depth is this one
      for(int i = 0; i < 120; ++i)
        (euler_p<Fifty>(1, K, (lo + hi) / 2) < Fifty(point.at("p")) ? lo : hi) = (lo + hi) / 2;
      CHECK(point.value("q") == within(euler_q<Fifty>(1, K, lo), 2e-13, "p and q are rounded"));
      CHECK(point.value("p") == between(0, euler_p<Fifty>(1, K, hi) + 1e-13, "the same"));
    }
    Fifty length = 0, p = 0, q = 0;
    for(const auto& point : now.points("exact"))
    {
      length += hypot(Fifty(point.at("p")) - p, Fifty(point.at("q")) - q);
      const Fifty p_ = Fifty(point.at("p")), q_ = Fifty(point.at("q"));
      CHECK(point.value("p") == between(p, 0.5, "it grows"));
      CHECK(point.value("q") == between(q, 0.5, "it grows"));
      p = p_;
      q = q_;
    }
    CHECK(length == within(1 - end(Member::highest, 0.3).r, 1e-3, "chords for arcs"));
  }
}

/*!
Our copy has $aa$ for $a^3$ under every $k^4$ of {{eq 1}} and {{eq 6}}: then they are no lengths.
*/

double depth_with(int power_of_a)  // (1) at a = 2, k = 0,3, φ = ½
{
  const double cc = std::pow(std::cos(0.5), 2), ss = 1 - cc, kk = 0.09, below = std::pow(2, power_of_a);
  return ss + kk * ss / 4 - 3 * kk / 4 + 3 * kk / (4 * cc)
         + kk * kk / below * (-15 / (2 * cc * cc) + 7 / (cc * cc * cc) + 0.5);
}

const Emendation cube_of_a{
    "§34, the terms with k⁴",
    {"k⁴ over aa", depth_with(2)},
    {"k⁴ over a³", depth_with(3)},
    "it is the integral of ds cos φ",
    [](double depth) {
      const Fifty sum =
          exact::integrate([](const Fifty& x) { return euler_ds<Fifty>(2, Fifty("0.3"), x) * cos(x); }, 0,
                           Fifty("0.5"))
              .value;
      return depth == within_ulps(sum, 8, "a few roundings");
    }};
