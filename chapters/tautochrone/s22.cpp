#include <algorithm>

#include <boost/math/quadrature/gauss.hpp>
#include <gsl/gsl_sf_ellint.h>

#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/member.hpp"

SECTION(tautochrone, 22, "The equation of the tautochrone")

using namespace tautochrone;

/*!
## What Euler does

The formula that was found for any compound pendulum is fitted to equal times when it takes the form that
it has for the simple one. Necessarily

$$ \begin{aligned} &2\int\frac{dz\sqrt{kk+rr}}{r\sqrt{c-x}} \quad\text{must become} \\
  &2\int\frac{dx\sqrt{\frac12f}}{\sqrt{(c-x)x}}; \end{aligned} \tag{1} $$

for then, when $x = c$ is put after the integration, the letter $c$ goes out of the reckoning, and each
swing takes as long as the smallest swings of a simple pendulum whose length is $f$. When the two are
compared, there arises

$$ \begin{gathered} \frac{dz\sqrt{kk+rr}}r = \frac{dx\sqrt f}{\sqrt{2x}} \quad\text{or} \\
  \sqrt{2fx}{{entry lost_root}} = \int\frac{dz\sqrt{kk+rr}}r. \end{gathered} \tag{2} $$

This equation expresses the nature of the tautochrone $CG$ for any compound pendulum. That it departs not
a little from the cycloid is clear enough of itself.

::: margin
Today: $\sigma^2 = 2fx$ with $d\sigma^2 = dz^2 + kk\,d\varphi^2$. A bead on a curve of the arc σ and the
same heights has the same times: that curve must be a cycloid.
:::

That {{eq 2}} suffices is shown by {{eq 1}}; that it is necessary Euler says, and does not prove. Abel's
theorem does, which recovers $\sigma$ from the times $T(c)$ of all swings up to the height $x$:

$$ \sigma(x) = \frac1{2\pi}\int_0^x \frac{T(c)\,dc}{\sqrt{x-c}}. \tag{A} $$

If $T$ is the same for all of them, $2\pi\sqrt{f/2}$, then $\sigma = \sqrt{2fx}$ and nothing else. It is
here supposed that both sides are equal, as Euler's cheeks are: from the times nothing but the sum of the
two sides can be known.

And why will Huygens's $r = a\cos\varphi$ not do? With it $\sqrt{2fx}$ is $\sqrt{aa+kk}\,\sin\varphi$, and the
integral is $\int d\varphi\sqrt{kk+aa\cos^2\varphi}$, the arc of an ellipse. The two agree only for $k = 0$
and for small angles; then

$$ \frac{\sigma}{\sqrt{2fx}} = 1 + \frac{kk}{aa+kk}\cdot\frac{\varphi^2}6 \text{ nearly.} \tag{B} $$

## The program

The integral in {{eq 2}}, which is called σ here. On the exact curve it is
$\sin\varphi\cdot fr:\sqrt{kk+rr}$; on Huygens's cheeks an elliptic integral.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.3, metres, scale, "radius of gyration");
const auto phi = angle("phi", 40_deg, above_to(0_deg, 85_deg), "angle of the thread with the vertical");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

double sigma_of_cycloid(double ratio, double phi_)  // ∫dφ√(kk + cos²φ), a = 1
{
  const double root = std::hypot(1, ratio);
  return root * gsl_sf_ellint_E(phi_, 1 / root, GSL_PREC_DOUBLE);
}

double by_Abel(double ratio, double to)  // (A) on the cycloid, from the times of its swings: c = x(1 − uu)
{
  const auto time = [=](double u) {
    return swing_time(Cheeks::cycloids, ratio, std::asin(std::sin(to) * std::sqrt((1 - u) * (1 + u))));
  };
  const double sum = boost::math::quadrature::gauss<double, 30>::integrate(time, 0.0, 1.0);
  return sum * std::sin(to) / (std::numbers::pi * std::numbers::sqrt2);  // √x = sin φ/√2
}

TELL
{
  const double small = k / a, f = 1 + small * small;
  require(small >= 1e-9, "k", "at least 1e-9 a and less than a");
  require(small < 1, "k", "at least 1e-9 a and less than a");
  tell("T", small_swing(small) * (std::sqrt(a) / (2 * std::sqrt(g))), seconds,
       "every swing on the tautochrone");
  if(phi <= end(Member::highest, small).phi)
  {
    const Position here = at(Member::highest, small, phi);
    tell("sigma", a * f * here.r * std::sin(phi) / std::hypot(small, here.r), metres,
         "σ on the highest exact tautochrone");
    tell("root", a * std::sqrt(2 * f * here.x), metres, "√(2fx) there, which must be the same");
  }
  const double sigma_ = sigma_of_cycloid(small, phi);
  tell("sigma_cycloid", a * sigma_, metres, "σ on Huygens's cheeks");
  tell("root_cycloid", a * std::sqrt(f) * std::sin(phi), metres, "√(2fx) there");
  tell("Abel", a * by_Abel(small, phi), metres, "σ there from the times of its swings, (A)");
}

TELL
{
  curve("straight", {"root_x", "circle", "cycloid"}, [](Curve& out) {
    const double f = 1.09;
    for(int i = 1; i <= 100; ++i)
    {
      const double root_x = 0.007 * i,
                   half = std::asin(root_x / std::numbers::sqrt2);  // x = 2 sin²½φ and ½ sin²φ
      out.put(
          {root_x, std::sqrt(f) * 2 * half / (std::sqrt(2 * f) * root_x),
           sigma_of_cycloid(0.3, std::asin(root_x * std::numbers::sqrt2)) / (std::sqrt(2 * f) * root_x)});
    }
  });
}

/*!
On the tautochrone σ and $\sqrt{2fx}$ are both {{sigma|10}} m. On Huygens's cheeks they are
{{sigma_cycloid|8}} and {{root_cycloid|8}} m.

::: figure tautochrone-22
alt: The quotient of sigma by the square root of 2fx against the square root of the height. The
tautochrone is a level line at one. The circle's curve rises steadily; the cycloid's stays below it, and
near its end climbs steeply past it.

The quotient of the two sides of {{eq 2}}, $k = \tfrac3{10}a$, against $\sqrt{x/a}$. It must be 1
everywhere: where it grows, wider swings are slower.
:::

## Checks
*/

CHECK_THAT("on the tautochrone the integral of (2), summed along it, is the root of 2fx, and both are told")
{
  for(const Told& now : told_at("", "a=2e30 k=1e30 phi=25", "k=0.7 phi=1", "phi=10 k=0.2"))
  {
    const Fifty small = k.fifty() / a.fifty(), kk = small * small, r = highest(small, phi.fifty()),
                s = sin(phi.fifty());
    const Fifty root = sqrt(pow((1 + kk) * r * s, 2) / (kk + r * r));
    CHECK(now.value("sigma", metres)
          == within_relative(a.fifty() * root, 5e-14, "the library's bound, and k/a"));
    CHECK(now.value("root", metres) == within_relative(a.fifty() * root, 5e-14, "the same"));
    CHECK(now.value("T", seconds)
          == within_relative(exact::pi() * sqrt(a.fifty() * (1 + kk) / (2 * g.fifty())), 2e-15,
                             "two ulps and three roundings"));
  }
  for(const Told& now : told_at(""))
  {
    std::vector<Fifty> angles;
    for(int i = 1; i <= 64; ++i)  // the midpoints of 64 strips; then Richardson's rule with 32
      angles.push_back(phi.fifty() * (2 * i - 1) / 128);
    for(int i = 1; i <= 32; ++i)
      angles.push_back(phi.fifty() * (2 * i - 1) / 64);
    std::sort(angles.begin(), angles.end());
    const std::vector<Fifty> r = highest(Fifty("0.3"), angles);
    Fifty fine = 0, coarse = 0;
    for(std::size_t i = 0; i < angles.size(); ++i)
      (i % 3 == 1 ? coarse : fine) += sqrt(r[i] * r[i] + Fifty("0.09"));
    fine *= phi.fifty() / 64;
    coarse *= phi.fifty() / 32;
    CHECK(now.value("sigma", metres)
          == within(fine + (fine - coarse) / 3, 1e-6, "the fourth power of a strip"));
  }
}

CHECK_THAT(
    "it refuses a body with k = a, for which there is no such curve, and one with k less than 1e-9 a")
{
  for(const char* const within_them : {"k=1e-9", "k=0.9999999999999999", "k=2e-9 a=2", "k=1.9999 a=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"k=9.99999999999999e-10", "k=1", "k=1.9999e-9 a=2", "k=2 a=2"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("on Huygens's cheeks the integral is the one told, and Abel's theorem has it back from the "
           "times of the swings")
{
  for(const Told& now : told_at("", "a=2e30 k=1e30 phi=25", "k=0.02 phi=80", "k=0.9 phi=1e-5"))
  {
    const Fifty small = k.fifty() / a.fifty(), kk = small * small;
    const Fifty sum =
        exact::integrate([&](const Fifty& x) { return sqrt(kk + pow(cos(x), 2)); }, 0, phi.fifty()).value;
    CHECK(now.value("sigma_cycloid", metres)
          == within_relative(a.fifty() * sum, 3e-15, "GSL's integral, and k/a"));
    CHECK(now.value("root_cycloid", metres)
          == within_relative(a.fifty() * sqrt(1 + kk) * sin(phi.fifty()), 1e-15, "a root and a sine"));
    CHECK(now.value("Abel", metres)
          == within_relative(a.fifty() * sum, 1e-13, "thirty places, and the roundings of the times"));
  }
}

CHECK_THAT("on Huygens's cheeks the quotient begins as (B), whatever the body")
{
  for(const Fifty& small : {Fifty("0.01"), Fifty("0.3"), Fifty("0.95")})
  {
    const Fifty kk = small * small, to("1e-4");
    const auto element = [&](const Fifty& x) -> Fifty { return sqrt(kk + pow(cos(x), 2)); };
    const Fifty quotient = exact::integrate(element, 0, to).value / (sqrt(1 + kk) * sin(to));
    CHECK(quotient - 1 == within_relative(kk / (1 + kk) * to * to / 6, 1e-7, "the next terms"));
  }
}

CHECK_THAT("in the figure both quotients begin with one and grow, the circle's as φ to 2 sin ½φ")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("straight", 6))
    {
      const Fifty root_x = point.at("root_x"), circle = 2 * asin(root_x / sqrt(Fifty(2))),
                  phi_ = asin(root_x * sqrt(Fifty(2)));
      CHECK(point.value("circle") == within_relative(circle / (2 * sin(circle / 2)), 2e-15, "an arc"));
      const Fifty sum =
          exact::integrate([](const Fifty& x) { return sqrt(Fifty("0.09") + pow(cos(x), 2)); }, 0, phi_)
              .value;
      CHECK(point.value("cycloid")
            == within_relative(sum / (sqrt(Fifty("1.09")) * sin(phi_)), 2e-14, "an arc near 90°"));
    }
}

/*!
In {{eq 2}} our copy has read the root sign as that of an integral: $\int 2fx$. It is tried on the exact
curve at 40°, with $a = 1$, $k = \tfrac3{10}$.
*/

double height_40()
{
  return at(Member::highest, 0.3, 40_deg).x;
}

const Emendation lost_root{"§22, the left side of the equation",
                           {"∫2fx, here fxx", [] { return 1.09 * height_40() * height_40(); }},
                           {"√(2fx)", [] { return std::sqrt(2 * 1.09 * height_40()); }},
                           "it is the integral of dx√f/√(2x), and a length",
                           [](double side) {
                             const Fifty r = highest(Fifty("0.3"), Fifty(40) * exact::pi() / 180);
                             return side
                                    == within_relative(Fifty("1.09") * r
                                                           * sin(Fifty(40) * exact::pi() / 180)
                                                           / sqrt(r * r + Fifty("0.09")),
                                                       5e-14, "the library's bound");
                           }};

/*!
## Go on from here

::: exercise
A pendulum's swings take $T = T_0(1 + \varepsilon c)$ as long as $c$ is small. What curve does {{eq A}} give?
Try it on the circle.

answer: $\int_0^x c\,dc : \sqrt{x-c}$ is $\tfrac43x\sqrt x$, and so
$\sigma = \sqrt{2fx}\,(1 + \tfrac23\varepsilon x)$. In a circle $T$ grows by $\tfrac1{16}\varphi_0^2$ and $c$
is $\tfrac12a\varphi_0^2$, so that $\varepsilon = 1 : 8a$ and $\sigma = \sqrt{2fx}\,(1 + x : 12a)$: so the
circle's line in the figure begins.
:::
*/

CHECK_THAT("the circle's quotient in the figure begins as 1 + x/12")
{
  for(const Told& now : told_at(""))
  {
    const auto all = now.points("straight");
    for(const std::size_t i : {std::size_t(0), std::size_t(4), std::size_t(9)})
    {
      const double x = std::pow(all[i].at("root_x"), 2);
      CHECK(all[i].value("circle") == within(1 + x / 12, x * x / 8, "the next term, 3xx/160"));
    }
  }
}
