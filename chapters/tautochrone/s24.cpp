#include <optional>

#include "edition/section.hpp"
#include "tautochrone/analytic.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/member.hpp"

SECTION(tautochrone, 24, "Why it could not be constructed")

using namespace tautochrone;

/*!
## What Euler does

Euler can neither construct the equation of the tautochrone nor separate its variables, and says so. The
equation,

$$ \frac{dz\sqrt{kk+rr}}r = \frac{dx\sqrt f}{\sqrt{2x}{{entry under_the_root}}} =
  \frac{dx\sqrt{kk+aa}}{\sqrt{2ax}}, \tag{1} $$

is exceedingly difficult to construct, and its variables cannot in any way be separated from one another.
For although $r$ can be defined by the other two, $x$ and $z$ (if the ordinate is $QG = y$, then

$$ \begin{aligned} r &= \frac{-dz^3}{dx\,ddy}{{entry first_form}} =
  \frac{-dy\,dz^2}{dx\,ddz}{{entry second_form}} \text{ for } dx \text{ constant,} \\
  \text{or } r &= \frac{dz\,dy}{ddx}{{entry third_form}} \text{ for } dz \text{ constant,}
  \end{aligned} \tag{2} $$

and $dy = \sqrt{dz^2-dx^2}$), yet the equation would become so entangled that nothing at all could be
concluded from it. And if either $x$ or $z$ were thrown out of it, one would fall into much greater
snares. While for the simple pendulum the construction of the tautochrone is of the easiest, for the
compound one it labours under difficulties such that until now he has not been able to overcome them in
any way.

::: margin
No closed form is known to this edition either.
:::

There is one form in which the equation is neat. Let $X = \cos\varphi$, and $S = \sqrt{2x:f}$: the sine of the
angle that Huygens's simple pendulum of the length $f$ makes at the same height. Then

$$ \begin{gathered} X^2 + \Bigl(\frac kf\Bigr)^{\!2}\Bigl(\frac{dX}{dS}\Bigr)^{\!2} = 1 - S^2, \\
  r = -\frac{fS\,dS}{dX}. \end{gathered} \tag{A} $$

It is of the first order and of the second degree, and cannot be separated; but it shows that there is one
solution that is analytic in the lowest place, except where $aa:kk$ is an odd number from three on. For
$k < a$ it is one of many ({{sec tautochrone.25}}); for $k > a$ it is the only one that has $r = a$ in the
lowest place, and no thread can be wound so, because its $r$ grows.

## The program

The three formulae {{eq 2}} are tried on the cycloid, with finite steps in the place of the differentials,
where $r$ is known.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 1.5, metres, scale, "radius of gyration");
const auto S =
    real("S", 0.2, none, closed(1e-6, 0.9), "√(2x/f), at which the analytic tautochrone is looked at");
const auto phi =
    angle("phi", 40_deg, closed(1_deg, 80_deg),
          "angle at which (2) is tried on the cycloid, and the analytic tautochrone looked at");
const auto step = real("step", 1e-4, none, closed(1e-6, 1e-3), "the step, as a part of x or of z");

struct Three
{
  double by_y, by_z, by_x;
};

Three radii(double phi_, double h)  // (2), of the cycloid zz = 2x, a = 1
{
  const double x = std::pow(std::sin(phi_), 2) / 2, z = std::sin(phi_), dx = h * x, dz = h * z;
  const auto z_of = [](double x_) { return std::sqrt(2 * x_); };
  const auto y_of = [](double x_) {
    const double sine = std::sqrt(2 * x_), cosine = std::sqrt(1 - 2 * x_);
    return (std::asin(sine) + sine * cosine) / 2;
  };
  const auto x_of = [](double z_) { return z_ * z_ / 2; };
  const double dz_x = (z_of(x + dx) - z_of(x - dx)) / 2, ddz = z_of(x + dx) - 2 * z + z_of(x - dx);
  const double dy_x = (y_of(x + dx) - y_of(x - dx)) / 2, ddy = y_of(x + dx) - 2 * y_of(x) + y_of(x - dx);
  const double dy_z = (y_of(x_of(z + dz)) - y_of(x_of(z - dz))) / 2,
               ddx = x_of(z + dz) - 2 * x + x_of(z - dz);
  return {-dz_x * dz_x * dz_x / (dx * ddy), -dy_x * dz_x * dz_x / (dx * ddz), dz * dy_z / ddx};
}

template <class Place>
std::optional<Analytic> reached(Place place)  // none where r becomes infinite before
{
  try
  {
    return place();
  }
  catch(const std::domain_error&)
  {
    return std::nullopt;
  }
}

TELL
{
  const Three r = radii(phi, step);
  tell("by_y", r.by_y, "r/a of the cycloid by −dz³/dx ddy");
  tell("by_z", r.by_z, "by −dy dz²/dx ddz");
  tell("by_x", r.by_x, "by dz dy/ddx");
  const Fifty ratio = k.fifty() / a.fifty(), kappa = ratio * ratio;
  require(kappa * 50 >= 1, "k", "kk/aa from 1/50 to 100, for this series");
  require(kappa <= 100, "k", "kk/aa from 1/50 to 100, for this series");
  bool resonant = false;
  for(int m = 1; m <= 24; ++m)
    resonant = resonant || abs(kappa * (2 * m + 1) - 1) < 1e-9;
  require(!resonant, "k",
          "not with aa/kk, to nine digits, an odd number from three on: there is no such curve");
  const auto here = reached([&] { return analytic_at_arc(kappa, S.fifty()); });
  require(here.has_value(), "S", "as far as the curve goes before r is infinite");
  tell("phi_S", double(here->phi), degrees, "the angle of the analytic tautochrone at S");
  tell("r_S", a * double(here->r), metres, "its radius of curvature");
  tell("x_S", a * double(here->x), metres, "its height");
  if(const auto there = reached([&] { return analytic_at_angle(kappa, phi.fifty()); }))
  {
    tell("S_phi", double(there->S),
         "S of the analytic tautochrone at the angle φ, where it reaches so far");
    tell("r_phi", a * double(there->r), metres, "its radius of curvature there");
  }
}

TELL
{
  curve("errors", {"step", "by_y", "by_z", "by_x"}, [](Curve& out) {
    for(double h = 1e-7; h < 1e-1; h *= 1.3)
    {
      const Three r = radii(40_deg, h);
      const double exact = std::cos(40_deg);
      out.put({h, std::abs(r.by_y / exact - 1) + 1e-17, std::abs(r.by_z / exact - 1) + 1e-17,
               std::abs(r.by_x / exact - 1) + 1e-17});
    }
  });
}

/*!
At 40° the cycloid has $r = a\cos 40°$; by the three formulae it is {{by_y|8}}, {{by_z|8}} and
{{by_x|8}}.

::: figure tautochrone-24
alt: The relative error of the three formulae against the step, both logarithmic: three lines fall with
the square of the step to about ten to the minus four and then rise again, ragged, as the steps get
smaller.

The error of the three formulae {{eq 2}} with finite steps, on the cycloid at 40°. Large steps are no
differentials; small ones leave nothing of the second differences but roundings.
:::

The one tautochrone of a body with $k = {{k}}\,a$ is at $S = {{S}}$ inclined by {{phi_S|deg2}}, and has there
the radius {{r_S|6}} m: more than $a$, so that it is not led by a thread that winds itself up.

## Checks
*/

CHECK_THAT(
    "the three formulae (2) give r to the square of the step, until the second differences are roundings")
{
  for(const Told& now : told_at("", "phi=10 step=1e-3", "phi=75 step=1e-5"))
  {
    const Fifty r = cos(phi.fifty()), steep = 1 / pow(r, 2);
    const double eps =
        double(20 * steep * steep * step.fifty() * step.fifty()) + 4e-15 * double(steep) / (step * step);
    const char* const why = "the third and fourth differentials, and an ulp over a square of the step";
    CHECK(now.value("by_y") == within_relative(r, eps, why));
    CHECK(now.value("by_z") == within_relative(r, eps, why));
    CHECK(now.value("by_x") == within_relative(r, eps, why));
  }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("errors", 8))
    {
      const double h = point.at("step"), eps = 40 * h * h + 1e-14 / (h * h);
      for(const char* name : {"by_y", "by_z", "by_x"})
        CHECK(point.value(name) == between(0, eps, "the square of the step, and roundings"));
    }
}

CHECK_THAT("the curve told satisfies (A): its slope by differences in S, and its radius with it")
{
  for(const Told& now : told_at("", "k=1 S=0.3", "k=0.33 a=1.5 S=0.1", "k=3 S=0.05 a=1"))
  {
    const Fifty ratio = k.fifty() / a.fifty(), kappa = ratio * ratio, f = 1 + kappa, h("1e-9");
    const auto X = [&](const Fifty& s) { return cos(analytic_at_arc(kappa, s).phi); };
    const Fifty s = S.fifty(),
                slope_ = (8 * (X(s + h) - X(s - h)) - (X(s + 2 * h) - X(s - 2 * h))) / (12 * h);
    const Fifty x = sqrt(1 - s * s - pow(ratio / f * slope_, 2));  // by (A)
    CHECK(now.value("phi_S", degrees)
          == within_relative(acos(x), 1e-14, "differences of 10⁻⁹ in 25 digits"));
    CHECK(now.value("r_S", metres) == within_relative(-a.fifty() * f * s / slope_, 1e-13, "the same"));
    CHECK(now.value("x_S", metres) == within_relative(a.fifty() * f * s * s / 2, 1e-15, "a product"));
  }
}

CHECK_THAT("at a given angle it satisfies (A) as well: the slope of S by differences in the angle")
{
  for(const Told& now : told_at("", "k=1 phi=10", "k=0.3 phi=20", "k=3 phi=2 a=1.5"))
  {
    const Fifty ratio = k.fifty() / a.fifty(), kappa = ratio * ratio, f = 1 + kappa, h("1e-9"),
                x = phi.fifty();
    const auto arc = [&](const Fifty& angle_) { return analytic_at_angle(kappa, angle_).S; };
    const Fifty slope_ = (8 * (arc(x + h) - arc(x - h)) - (arc(x + 2 * h) - arc(x - 2 * h))) / (12 * h);
    const Fifty s = sin(x) * sqrt(1 - pow(ratio / (f * slope_), 2));  // by (A), dX/dS = −sin φ : dS/dφ
    CHECK(now.value("S_phi") == within_relative(s, 1e-13, "differences of 10⁻⁹ in 25 digits"));
    CHECK(now.value("r_phi", metres)
          == within_relative(a.fifty() * f * s * slope_ / sin(x), 1e-13, "the same"));
  }
}

CHECK_THAT("a body with k greater than a has a radius that grows")
{
  for(const Told& now : told_at("", "S=0.1 k=1.1"))
    CHECK(now.value("r_S", metres) == between(1.001, 2, "greater than a = 1"));
}

CHECK_THAT("near the lowest place it is the series of § 25, whose first coefficients are −(1+κ)/2 and "
           "−(1+κ)³/8(1−3κ)")
{
  for(const Told& now : told_at("S=0.001", "S=0.0001 k=0.9", "S=0.001 k=0.21"))
  {
    const Fifty kappa = pow(k.fifty() / a.fifty(), 2), ss = S.fifty() * S.fifty(), f = 1 + kappa;
    const Fifty X = 1 - f / 2 * ss - pow(f, 3) / (8 * (1 - 3 * kappa)) * ss * ss;
    CHECK(now.value("phi_S", degrees)
          == within_relative(acos(X), 100 * double(pow(f, 4) * ss * ss), "the third coefficient"));
  }
}

CHECK_THAT(
    "it refuses a resonance, the first, the last of these bodies, or to a part in 10⁹, but not beside it")
{
  // κ = 1/3 at k = 0.57735026918962576, κ = 1/49 at k = 1/7
  for(const std::string setting : {"S=1e-6 k=0.5773502690", "S=1e-6 k=0.57735026918962576",
                                   "S=1e-6 k=0.5773502694", "S=1e-6 a=7 k=1", "S=1e-6 a=2 k=1.1547005388"})
    CHECK(refused_at(setting));
  for(const std::string setting :
      {"S=1e-6 k=0.5773502688", "S=1e-6 k=0.5773502695", "S=1e-6 a=7 k=1.0000001", "S=1e-6 a=7 k=0.9999999",
       "S=1e-6 a=2 k=1.1547005390"})
    CHECK(!refused_at(setting));
}

CHECK_THAT("it refuses an S beyond that where r is infinite and S = sin φ, for great bodies and small")
{
  for(const auto& [body, within_it, beyond] : {std::array{"k=10 S=", "0.3017689", "0.3017690"},
                                               {"a=3 k=3 S=", "0.8151601", "0.8151602"},
                                               {"k=0.15 S=", "0.8067226", "0.8067227"}})
  {
    CHECK(refused_at(std::string(body) + beyond));
    for(const Told& now : told_at(std::string(body) + within_it))
    {
      const Fifty there = asin(S.fifty());
      CHECK(
          now.value("phi_S", degrees)
          == within(k > a ? exact::pi() - there : there, 1e-6, "half of kk : rr, r being thousands of k"));
      CHECK(now.value("r_S", metres) == between(1000 * k, infinity, "nearly infinite"));
    }
  }
}

CHECK_THAT("it refuses kk less than a fiftieth of aa, and kk greater than a hundred times aa")
{
  for(const char* const within_them :
      {"k=0.141421356237309506", "k=10", "a=2 k=0.282842712474619011", "a=2 k=20"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"k=0.141421356237309504", "k=10.0000000000000001", "a=2 k=0.282842712474619009", "a=2 k=20.0001"})
    CHECK(refused_at(beyond));
}

/*!
{{eq 1}} and {{eq 2}} are much damaged in our copy. The readings are tried on the cycloid $zz = 2ax$ with
$a = 2$ at $x = \tfrac15$, where $r = a\cos\varphi$, with the exact differentials of $y$ and $z$ for
$dx = 1$.
*/

struct Place24
{
  double x = 0.2, a = 2, sine = std::sqrt(2 * x / a), cosine = std::sqrt(1 - sine * sine);
  double dz = 1 / sine, dy = cosine / sine, ddz = -1 / (a * sine * sine * sine),
         ddx = 1 / a;  // for dz = 1 in ddx
};

const auto is_r = [](double reading) {
  return reading == within_ulps(2 * sqrt(1 - Fifty(0.2)), 8, "a few roundings");
};

const Emendation first_form{"§24, r for dx constant, the first form",
                            {"−dz²/2 dx dy",
                             [] {
                               const Place24 at_;
                               return -at_.dz * at_.dz / (2 * at_.dy);
                             }},
                            {"−dz³/dx ddy",
                             [] {
                               const Place24 at_;
                               return -at_.dz * at_.dz * at_.dy / at_.ddz;
                             }},
                            "as dx is constant, dy ddy = dz ddz; it is the radius of curvature",
                            is_r};

const Emendation second_form{"§24, r for dx constant, the second form",
                             {"−dy dz²/2x dx z",
                              [] {
                                const Place24 at_;
                                return -at_.dy * at_.dz * at_.dz / (2 * at_.x * std::sqrt(0.8));
                              }},
                             {"−dy dz²/dx ddz",
                              [] {
                                const Place24 at_;
                                return -at_.dy * at_.dz * at_.dz / at_.ddz;
                              }},
                             "dz ddz = dy ddy, as dx is constant; only so is it the radius of curvature",
                             is_r};

const Emendation third_form{"§24, r for dz constant",
                            {"dz dy/dax",
                             [] {
                               const Place24 at_;
                               return at_.cosine / (at_.a * at_.sine);
                             }},
                            {"dz dy/ddx",
                             [] {
                               const Place24 at_;
                               return at_.cosine / at_.ddx;
                             }},
                            "the second differential of x is wanted",
                            is_r};

const Emendation under_the_root{
    "§24, the equation, the first root",
    {"√(2ax) under √f", std::sqrt(2 + 0.09 / 2) / std::sqrt(2 * 2 * 0.1)},
    {"√(2x) under √f", std::sqrt(2 + 0.09 / 2) / std::sqrt(2 * 0.1)},
    "§22 has it so, and the third member, here for a = 2, k = 0.3, x = 0.1",
    [](double side) {
      return side == within_ulps(sqrt(Fifty(0.09) + 4) / sqrt(Fifty(2) * 2 * Fifty(0.1)), 8, "roots");
    }};

/*!
## Go on from here

::: exercise
Put $X = 1 - \alpha S^2$ into {{eq A}}, for small $S$ and $a = 1$. Which curves are there?

answer: $4\varepsilon^2\alpha^2 - 2\alpha + 1 = 0$, where $\varepsilon = k : f$, has two roots,
$\alpha = \tfrac12(1 + kk)$ and $\alpha = \tfrac12(1 + kk) : kk$. As $r = f : 2\alpha$ in the lowest place,
the first curve has there $r = a$, as it should; the other $r = kk : a$, which is the pendulum turned over
({{sec tautochrone.23}}).
:::
*/

CHECK_THAT("(A) begins with two curves, whose radii in the lowest place are a and kk : a; the one told is "
           "the first")
{
  for(const Rational& kk : {Rational(9, 4), Rational(1, 9), Rational(3, 7)})
    for(const Rational& alpha : {(1 + kk) / 2, (1 + kk) / (2 * kk)})
    {
      const Rational f = 1 + kk;
      CHECK(4 * (kk / (f * f)) * alpha * alpha - 2 * alpha + 1 == Rational(0));
      CHECK((f / (2 * alpha) == Rational(1) || f / (2 * alpha) == kk));
    }
  for(const Told& now : told_at("S=1e-6", "S=1e-6 k=0.5 a=1"))
    CHECK(now.value("r_S", metres) == within_relative(1, 1e-9, "the square of S"));
}
