#include "edition/section.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/series.hpp"

SECTION(tautochrone, 26, "A neat property of the curve")

using namespace tautochrone;

/*!
## What Euler does

Although the equation cannot be constructed, its finite form has a remarkable meaning by which the
tautochrone is determined. Let the radii of curvature $CA$ and $GM$ be drawn, the one in the lowest place
$C$, the other in any place $G$, and for the points of suspension $A$ and $M$ let $D$ and $H$ be the
centres of oscillation. Let further the horizontal $GQ$ and the vertical $MS$ be drawn. Because

$$ \begin{gathered} AC = a, \quad AD = a + \frac{kk}a{{entry of_AD}}, \quad CQ = x, \\ MG = r, \quad MH
  = r + \frac{kk}r, \quad GS = r\sin\varphi, \end{gathered} \tag{1} $$

the equation $2ax = (aa+kk)\,rr\sin^2\varphi : (kk+rr)$ of {{sec tautochrone.25}} says

$$ 2\,CQ = \frac{AD\cdot GS^2}{MG\cdot MH}. \tag{2} $$

If from $S$ the straight line $ST$ is drawn at right angles to $GM$, then $GT = GS^2 : MG$, and

$$ \begin{gathered} 2\,CQ = \frac{AD\cdot GT}{MH}, \\[6pt] AD : MH = 2\,CQ : GT, \\
  AD : 2\,CQ = MH : GT. \end{gathered} \tag{3} $$

In this neat property the nature of the tautochrone is laid open.

::: margin
For a point, $k = 0$, it says $2x = r\sin^2\varphi\cdot a : r$: the cycloid's $2x = a\sin^2\varphi$.
:::

On a curve that is no tautochrone {{eq 3}} fails by some part, the *defect*

$$ D = \frac{2\,CQ\cdot MH}{AD\cdot GT} - 1, \tag{A} $$

and it is this part that makes its wide swings too slow: the excess of the time of a swing is the mean of
$\sqrt{1+D} - 1$ over it, taken so that its height goes as the squared sine of evenly spaced angles.

## The program

The lengths of {{eq 1}} on the highest exact tautochrone, and the defect of the curves that the paper
knows ({{api tautochrone::defect}}).
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto phi = angle("phi",
                       at_most(30_deg, "where the curve ends",
                               [] { return k < a ? end(Member::highest, k / a).phi : 30_deg; }),
                       above_to(0_deg, 89_deg), "angle of MG with the vertical");

struct Lengths  ///< Those of (1) and GT, of any numbers.
{
  double AD, CQ, MG, MH, GS, GT;
};

Lengths lengths(double a_, double k_, double r, double x, double phi_)  // (1)
{
  const double sine = std::sin(phi_);
  return {a_ + k_ / a_ * k_, x, r, r + k_ / r * k_, r * sine, r * sine * sine};
}

TELL
{
  const double small = k / a;
  require(small >= 1e-9, "k", "at least 1e-9 a and less than a");
  require(small < 1, "k", "at least 1e-9 a and less than a");
  require(phi <= end(Member::highest, small).phi, "phi",
          "up to the end of the curve, tan φ = (a − k)/√(ak)");
  const Position here = at(Member::highest, small, phi);
  const Lengths is = lengths(a, k, a * here.r, a * here.x, phi);
  tell("CQ", is.CQ, metres, "the height of G");
  tell("AD", is.AD, metres, "of the centre of oscillation below A");
  tell("MH", is.MH, metres, "of that for M from M");
  tell("GS", is.GS, metres, "from G to the vertical through M");
  tell("GT", is.GT, metres, "from G to the foot of the perpendicular from S");
  tell("twice_CQ_by_AD", 2 * is.CQ / is.AD, "2CQ : AD");
  tell("GT_by_MH", is.GT / is.MH, "GT : MH, which must be the same");
  const auto missed = [=](const char* name, Cheeks cheeks, const char* meaning) {
    if(phi < largest_amplitude(cheeks, small))
      tell(name, defect(cheeks, small, phi), meaning);
  };
  missed("of_circle", Cheeks::none, "the defect (A) of a circle");
  missed("of_cycloid", Cheeks::cycloids, "that of the cycloid");
  missed("of_kk", Cheeks::euler_kk, "that of Euler's curve with the first correction");
  missed("of_k4", Cheeks::euler_k4, "and with both");
}

TELL
{
  curve("defects", {"phi", "circle", "cycloid", "kk", "k4"}, [](Curve& out) {
    for(int i = 1; i <= 60; ++i)
    {
      std::vector<double> row{double(i)};
      for(const Cheeks cheeks : {Cheeks::none, Cheeks::cycloids, Cheeks::euler_kk, Cheeks::euler_k4})
        row.push_back(defect(cheeks, 0.1, i * 1_deg));
      out.put(row);
    }
  });
}

/*!
The cycloid misses the proportion by {{of_cycloid|e3}}, Euler's curves by {{of_kk|e3}} and {{of_k4|e3}}.
Whoever has a drawing of the cheek can try it with a ruler.

::: figure tautochrone-26
alt: The defect against the angle on a logarithmic scale, for k a tenth of a: the circle highest, then the
cycloid, then Euler's curves. The last two cross near 58 degrees.

By how much {{eq 3}} fails, $k = \tfrac1{10}a$. On an exact tautochrone it does not.
:::

## Checks
*/

CHECK_THAT("(2) and (3) are the equation of § 25, for any numbers")
{
  const Rational a_(7, 3), kk(4, 25), r(5, 4), s(3, 5),
      x = (a_ * a_ + kk) * r * r * s * s / (kk + r * r) / (2 * a_);
  const Rational AD = a_ + kk / a_, MH = r + kk / r, GS = r * s, GT = GS * s;
  CHECK(2 * x == AD * GS * GS / (r * MH));
  CHECK(2 * x == AD * GT / MH);
  CHECK(GT == GS * GS / r);
}

CHECK_THAT("the lengths told are those of the exact curve, whose height is the integral of r sin φ, and "
           "both ratios are one")
{
  for(const Told& now : told_at("", "a=2e40 k=6e39 phi=50", "a=3 k=0.06 phi=80", "k=0.8 phi=1e-7"))
  {
    const Fifty small = k.fifty() / a.fifty(), r = highest(small, phi.fifty()), s = sin(phi.fifty()),
                kk = small * small;
    const Fifty GT = r * s * s, MH = r + kk / r, x = (1 + kk) * GT / MH / 2;
    const char* const why = "the library's bound, and k/a";
    CHECK(now.value("CQ", metres) == within_relative(a.fifty() * x, 5e-14, why));
    CHECK(now.value("AD", metres) == within_relative(a.fifty() * (1 + kk), 1e-15, "two roundings"));
    CHECK(now.value("MH", metres) == within_relative(a.fifty() * MH, 5e-14, why));
    CHECK(now.value("GS", metres) == within_relative(a.fifty() * r * s, 5e-14, why));
    CHECK(now.value("GT", metres) == within_relative(a.fifty() * GT, 5e-14, why));
    CHECK(now.value("twice_CQ_by_AD") == within_relative(GT / MH, 5e-14, why));
    CHECK(now.value("GT_by_MH") == within_relative(GT / MH, 5e-14, why));
  }
  for(const double to : {0.2, 0.6, 0.9})
  {
    const Drawn place_ = drawn(Member::highest, 0.3, {to})[0];
    const Lengths is = lengths(1, 0.3, place_.at.r, place_.by_arc, to);
    CHECK(2 * is.CQ * is.MH == within_relative(is.AD * is.GT, 1e-12, "the height as an integral"));
  }
}

CHECK_THAT(
    "it refuses an angle beyond the end of the curve, a body with k = a and one with less than 1e-9 a")
{
  for(const char* const within_them : {"k=1e-9", "k=0.9999999999999999", "k=2e-9 a=2", "k=1.9999 a=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"k=9.99999999999999e-10", "k=1", "k=1.9999e-9 a=2", "k=2 a=2"})
    CHECK(refused_at(beyond));
  for(const std::string body : {"k=0.381966011250105152", "a=2 k=0.763932022500210304"})  // (a − k)² = ak
  {
    CHECK(!refused_at(body + " phi=44.9999999999"));
    CHECK(refused_at(body + " phi=45.0000000001"));
  }
}

CHECK_THAT("the defects told are those of the curves of §§ 30 and 32, in fifty digits")
{
  const auto by_lengths = [](const Fifty& small, const Fifty& r, const Fifty& x) {
    const Fifty kk = small * small;
    return 2 * x * (r + kk / r) / ((1 + kk) * r * pow(sin(phi.fifty()), 2)) - 1;
  };
  for(const Told& now : told_at("", "a=2e40 k=6e39 phi=40", "a=3 k=0.06 phi=70", "k=0.2 phi=1e-5"))
  {
    const Fifty small = k.fifty() / a.fifty(), x = phi.fifty(), one = 1;
    const char* const why = "the library's bound, and k/a and φ where r falls fast";
    CHECK(now.value("of_circle")
          == within_relative(by_lengths(small, 1, 2 * pow(sin(x / 2), 2)), 1e-13, why));
    CHECK(now.value("of_cycloid")
          == within_relative(by_lengths(small, cos(x), pow(sin(x), 2) / 2), 1e-13, why));
    CHECK(
        now.value("of_k4")
        == within_relative(by_lengths(small, euler_r(one, small, x), euler_x(one, small, x)), 2e-12, why));
    const Fifty kk = small * small, s = sin(x), t = pow(s / cos(x), 2);
    CHECK(now.value("of_kk")
          == within_relative(by_lengths(small, truncated(1, small)(cos(x)), s * s / 2 * (1 - kk * t)),
                             1e-12, why));
  }
}

CHECK_THAT("the mean of √(1+D) − 1 over the swing is the excess of its time: 200 evenly spaced angles")
{
  for(const Cheeks cheeks : {Cheeks::cycloids, Cheeks::none})
  {
    const double phi0 = 0.6,
                 x0 = cheeks == Cheeks::none ? 1 - std::cos(phi0) : std::pow(std::sin(phi0), 2) / 2;
    double sum = 0;
    for(int i = 0; i < 200; ++i)
    {
      const double x = x0 * std::pow(std::sin((i + 0.5) * std::numbers::pi / 400), 2);
      const double here = cheeks == Cheeks::none ? std::acos(1 - x) : std::asin(std::sqrt(2 * x));
      sum += std::sqrt(1 + defect(cheeks, 0.3, here)) - 1;
    }
    CHECK(sum / 200
          == within_relative(excess(cheeks, 0.3, phi0), 1e-11, "a difference from 1, and the arcs"));
  }
}

CHECK_THAT("the figure's curves are these defects")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("defects", 6))
    {
      const Fifty x = Fifty(point.at("phi")) * exact::pi() / 180, small("0.1"), kk = small * small, one = 1,
                  s = sin(x), t = pow(s / cos(x), 2);
      const auto by_lengths = [&](const Fifty& r, const Fifty& height) {
        return 2 * height * (r + kk / r) / ((1 + kk) * r * s * s) - 1;
      };
      const char* const why = "the library's bound";
      CHECK(point.value("circle") == within_relative(by_lengths(1, 2 * pow(sin(x / 2), 2)), 1e-13, why));
      CHECK(point.value("cycloid") == within_relative(by_lengths(cos(x), s * s / 2), 1e-13, why));
      CHECK(point.value("kk")
            == within_relative(by_lengths(truncated(1, small)(cos(x)), s * s / 2 * (1 - kk * t)), 1e-12,
                               why));
      CHECK(point.value("k4")
            == within_relative(by_lengths(euler_r(one, small, x), euler_x(one, small, x)), 1e-12, why));
    }
}

/*!
For $AD$ our copy has $r$ where it must have $a$; tried on the exact curve for $a = 1$, $k = \tfrac3{10}$
at 30°.
*/

double depth(bool of_r)
{
  return 1 + 0.09 / (of_r ? double(highest(Fifty("0.3"), exact::pi() / 6)) : 1.0);
}

const Emendation of_AD{
    "§26, AD",
    {"a + kk/r", [] { return depth(true); }},
    {"a + kk/a", [] { return depth(false); }},
    "D belongs to the suspension A and the distance AC = a; and the proportion holds only so",
    [](double AD) {
      const Drawn place_ = drawn(Member::highest, 0.3, {30_deg})[0];
      const Lengths is = lengths(1, 0.3, place_.at.r, place_.by_arc, 30_deg);
      return AD == within_relative(2 * is.CQ * is.MH / is.GT, 1e-12, "the height as an integral");
    }};

/*!
## Go on from here

::: exercise
What is the defect {{eq A}} of Huygens's cycloid, and what does it make of narrow swings?

answer: With $r = a\cos\varphi$ and $x = \tfrac12a\sin^2\varphi$ it is $D = \dfrac{kk}{aa+kk}\tan^2\varphi$.
For narrow swings half of its mean, where $\varphi^2$ is on the average $\tfrac12\varphi_0^2$, is the excess:
the law of {{eq tautochrone.03 A}}.
:::
*/

CHECK_THAT("the cycloid's defect is κ tan²φ : (1 + κ)")
{
  for(const Told& now : told_at("", "k=0.5 phi=20", "k=1e-8 phi=1e-5"))
  {
    const Fifty kappa = pow(k.fifty() / a.fifty(), 2), t = pow(tan(phi.fifty()), 2);
    CHECK(now.value("of_cycloid")
          == within_relative(kappa * t / (1 + kappa), 1e-13, "the library's bound"));
  }
}
