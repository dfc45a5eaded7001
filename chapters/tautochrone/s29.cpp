#include "edition/section.hpp"
#include "edition/series.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/series.hpp"

SECTION(tautochrone, 29, "The first correction")

using namespace tautochrone;

/*!
## What Euler does

The terms with $kk$ give the first correction of the cycloid, and they give it without integration. When
the values of {{sec tautochrone.28}} are put into the differential equation, there arises, ordered by
powers of $kk$ and divided by $d\varphi$,

$$ \begin{aligned}
  &+a^5\cos^4\varphi - a^5\cos^4\varphi \\
  &+ kk\,\bigl(a^4P\cos^3\varphi + a^3\cos^2\varphi \\
  &\qquad - a^3\cos^4\varphi + a^3\sin^2\varphi\bigr) \\
  &+ k^4\Bigl(a^4Q\cos^3\varphi + 3a^3PP\cos^2\varphi \\
  &\qquad + 3aaP\cos\varphi - 3aaP\cos^3\varphi \\
  &\qquad - \frac{aa\,dP\sin\varphi}{d\varphi} + a - a\cos^2\varphi + a\sin^2\varphi\Bigr) = 0.
  \end{aligned}\tag{1} $$

The terms without $k$ cancel. Those with $kk$, brought to nothing, give

$$ aP\cos^3\varphi + \cos^2\varphi - \cos^4\varphi + \sin^2\varphi = 0, \tag{2} $$

and therefore

$$ P = \frac{-1+\cos^4\varphi}{a\cos^3\varphi{{entry of_P}}} = \frac{-1}{a\cos^3\varphi} +
  \frac{\cos\varphi{{entry last_part}}}{a}, \tag{3} $$

from which further

$$ dP = -\frac{3{{entry of_dP}}\,d\varphi\sin\varphi}{a\cos^4\varphi} - \frac{d\varphi\sin\varphi}{a},
  \tag{4} $$

$$ PP = \frac1{aa\cos^6\varphi} - \frac2{aa\cos^2\varphi} + \frac{\cos^2\varphi}{aa}. \tag{5} $$

::: margin
With $t = \tan^2\varphi$, $aP = -t(2+t)\cos\varphi$.
:::

As $P$ is negative, the radius of curvature of the tautochrone falls below the cycloid's: its thread must
be wound up faster. Near the vertical the correction is $-2\varphi^2kk/a$.

## The program

$P$ in the form that has no cancellation, and its companions.
*/

double P_of(double a_, double phi_)  // (3)
{
  const double t = std::pow(std::tan(phi_), 2);
  return -t * (2 + t) * std::cos(phi_) / a_;
}

double dP_of(double a_, double phi_)  // (4), over dφ
{
  return -std::sin(phi_) * (3 / std::pow(std::cos(phi_), 4) + 1) / a_;
}

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto phi = angle("phi", 30_deg, closed(0_deg, 89_deg), "angle of the free part with the vertical");

TELL
{
  require(k / a <= 1, "k", "at most a");
  tell("P", P_of(a, phi), Unit{"1/m"}, "(3)");
  tell("dP", dP_of(a, phi), Unit{"1/m"}, "(4), for a radian");
  tell("correction", k / a * (k / a) * P_of(1, phi), "kkP over a, by which the radius is changed");
  const Fifty r =
      truncated(1, k.fifty() / a.fifty())(cos(phi.fifty()));  // where it is small, a small difference
  tell("r", double(a.fifty() * r), metres, "a cos φ + kkP");
}

TELL
{
  curve("pieces", {"phi", "of_P", "of_a", "of_dr"}, [](Curve& out) {
    for(int i = 0; i <= 70; ++i)
    {
      const double c = std::cos(i * 1_deg), s = std::sin(i * 1_deg);
      out.put({double(i), P_of(1, i * 1_deg) * c * c * c, c * c - c * c * c * c, s * s});
    }
  });
}

/*!
At 30° the radius is changed by {{correction|e3}} of $a$.

::: figure tautochrone-29
alt: Three curves against the angle. The squared sine rises to 0.88 at 70 degrees, the difference of the
powers of the cosine rises to a quarter at 45 degrees and falls, and P times the cubed cosine is their sum
turned downwards.

The three pieces of {{eq 2}} for $a = 1$. What the kinetic energy of turning adds, above, $P\cos^3\varphi$
must take away, below.
:::

## Checks
*/

const Rational third(7, 3);

CHECK_THAT("(1) is what the equation becomes when the series is put in, whatever P and Q are")
{
  const Powers P_ = cosine(-2) + 5, Q_ = cosine(1) - 2, sin2 = 1 - cosine(2);
  const Expansion r({third * cosine(1), P_, Q_});
  const Expansion dr_sin({slope_times_sine(r[0]), slope_times_sine(P_), slope_times_sine(Q_)});
  const Expansion line = equation<Expansion>(Powers(third), Expansion::x(), r, dr_sin, cosine(1));
  const Rational aa = third * third, a3 = aa * third, a4 = aa * aa;
  CHECK(line[0] == Powers(0));
  CHECK(line[1] == a4 * P_ * cosine(3) + a3 * cosine(2) - a3 * cosine(4) + a3 * sin2);
  CHECK(line[2]
        == a4 * Q_ * cosine(3) + 3 * a3 * P_ * P_ * cosine(2) + 3 * aa * P_ * cosine(1)
               - 3 * aa * P_ * cosine(3) - aa * slope_times_sine(P_) + third - third * cosine(2)
               + third * sin2);
}

CHECK_THAT("(2) vanishes for P by (3); (4) and (5) are its derivative and its square")
{
  const Powers P_ = P(third), sin2 = 1 - cosine(2);
  CHECK(third * P_ * cosine(3) + cosine(2) - cosine(4) + sin2 == Powers(0));
  CHECK(P_ == corrections<Rational>(1)[1] / third);
  CHECK(slope_times_sine(P_) == -1 * sin2 * (3 * cosine(-4) + 1) / third);
  CHECK(P_ * P_ == (cosine(-6) - 2 * cosine(-2) + cosine(2)) / (third * third));
  CHECK(P(1)(Rational(3, 5)) == Rational(-544, 135));
}

CHECK_THAT("what is told of P, its slope and the radius is the series', for any a, k and φ")
{
  for(const Told& now :
      told_at("", "a=2 k=0.6 phi=75", "a=1e-80 k=1e-85 phi=1e-90", "phi=89 a=3e70 k=3e69", "phi=71.6125"))
  {
    const Fifty c = cos(phi.fifty()), s = sin(phi.fifty()), kk = pow(k.fifty() / a.fifty(), 2);
    const Fifty tt = pow(s / c, 2), P_ = -(tt * (1 + c * c) / c);  // (1 − c⁴)/c³ = (s² + s²c²)/c³
    const char* const why = "a tangent, squared, and the angle's rounding";
    CHECK(now.value("P", Unit{"1/m"}) == within_relative(P_ / a.fifty(), 5e-14, why));
    CHECK(now.value("dP", Unit{"1/m"})
          == within_relative(-s * (3 / pow(c, 4) + 1) / a.fifty(), 5e-14, why));
    CHECK(now.value("correction") == within_relative(kk * P_, 5e-14, why));
    CHECK(now.value("r", metres)
          == within_relative(a.fifty() * (c + kk * P_), 1e-15, "a, k and the angle as they were written"));
  }
  for(const Told& now : told_at("", "phi=20", "phi=70"))  // by differences
  {
    const Fifty h("1e-14"), P_plus = P(1)(cos(phi.fifty() + h)), P_minus = P(1)(cos(phi.fifty() - h));
    CHECK(now.value("dP", Unit{"1/m"})
          == within_relative((P_plus - P_minus) / (2 * h), 5e-15, "a fourth power"));
  }
}

CHECK_THAT("it refuses a body with k greater than a, and none with k = a")
{
  for(const char* const within_them : {"k=1", "k=2 a=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"k=1.0000000000000003", "k=2.0001 a=2"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("for a small body the exact curve differs from the cycloid by kkP")
{
  for(const char* small : {"1e-2", "1e-3", "1e-4"})
  {
    const Fifty ratio(small), x = exact::pi() / 6, P_ = P(1)(cos(x));
    CHECK((highest(ratio, x) - cos(x)) / (ratio * ratio)
          == within_relative(P_, 7 * double(ratio * ratio), "Q is 6.1 P at 30°"));
  }
}

CHECK_THAT("the pieces in the figure add up to nothing, and are those of (2)")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("pieces", 8))
    {
      const Fifty c = cos(Fifty(point.at("phi")) * exact::pi() / 180);
      CHECK(point.value("of_a") == within(c * c - pow(c, 4), 3e-16, "a difference"));
      CHECK(point.value("of_dr") == within(1 - c * c, 3e-16, "a square"));
      CHECK(point.value("of_P") == within(pow(c, 4) - 1, 1e-15, "their sum, with the other sign"));
    }
}

/*!
Our copy has damaged exponents in {{eq 3}} and {{eq 4}}. The readings are tried at φ = 30° and $a = 1$:
against the recursion, which knows nothing of them, and against differences of it.
*/

double at_30(double of_one, double of_cosine)  // −1/cos^..φ + cos^..φ
{
  const double c = std::cos(30_deg);
  return -1 / std::pow(c, of_one) + std::pow(c, of_cosine);
}

const auto is_P = [](double reading) {
  return reading
         == within_ulps(corrections<Fifty>(1)[1](cos(exact::pi() / 6)), 8, "a difference of powers");
};

const Emendation of_P{"§29, P, its first form",
                      {"(−1 + cos⁴φ)/a cos⁵φ",
                       [] { return (-1 + std::pow(std::cos(30_deg), 4)) / std::pow(std::cos(30_deg), 5); }},
                      {"(−1 + cos⁴φ)/a cos³φ",
                       [] { return (-1 + std::pow(std::cos(30_deg), 4)) / std::pow(std::cos(30_deg), 3); }},
                      "the line before has P cos³φ, for so r³ and r⁴ make it",
                      is_P};

const Emendation last_part{"§29, P, its second form",
                           {"−1/a cos⁵φ + cos⁴φ/a", at_30(5, 4)},
                           {"−1/a cos³φ + cos φ/a", at_30(3, 1)},
                           "it is the first form divided out, and PP has cos²φ/aa",
                           is_P};

const Emendation of_dP{
    "§29, dP",
    {"−2 dφ sin φ/a cos⁵φ", -2 * 0.5 / std::pow(std::cos(30_deg), 5) - 0.5},
    {"−3 dφ sin φ/a cos⁴φ", -3 * 0.5 / std::pow(std::cos(30_deg), 4) - 0.5},
    "it is the differential of P",
    [](double reading) {
      const Fifty h("1e-14"), x = exact::pi() / 6;
      const auto r1 = corrections<Fifty>(1)[1];
      return reading == within_ulps((r1(cos(x + h)) - r1(cos(x - h))) / (2 * h), 8, "a fourth power");
    }};

/*!
## Go on from here

::: exercise
With $P$ alone, where does the radius of curvature come down to zero, so that the thread is all wound? Take
$k = \tfrac1{10}a$.

answer: By the margin $r = a\cos\varphi\,(1 - \kappa t(2 + t))$ with $\kappa = kk : aa$, so that
$t = \sqrt{1 + 1 : \kappa} - 1$, and $\varphi = 71.6125°$: `--phi 71.6125` leaves of a thread of one metre
less than a hundredth of a millimetre. The second correction brings it down to 65.913°
({{sec tautochrone.32}}).
:::
*/

CHECK_THAT(
    "with P alone the thread is all wound at 71.6125° for k = a/10, with both corrections at 65.913°")
{
  for(const Told& now : told_at("phi=71.6125"))
  {
    CHECK(now.value("r", metres) == within(0, 1e-5, "a hundredth of a millimetre"));
    CHECK(atan(sqrt(sqrt(1 + 1 / pow(k.fifty(), 2)) - 1))
          == within_relative(phi.fifty(), 1e-5, "five digits"));
  }
  CHECK(truncated(2, Fifty("0.1"))(cos(Fifty("65.913") * exact::pi() / 180))
        == within(0, 1e-4, "five digits"));
}
