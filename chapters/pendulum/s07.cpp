#include <algorithm>

#include <boost/math/special_functions/ellint_1.hpp>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_ellint.h>

#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/equation.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 7, "The time as an integral")

using pendulum::cosine_difference;
using swing::Amplitude;
namespace oracle = swing::oracle;

/*!
## What Euler does

The time becomes an integral, and the sines of half the angles make it algebraic. The speed at every angle is
known; so is the time that every element of the angle takes. From {{sec pendulum.06}} the element of time is

$$ dt = \frac{d\Phi\sqrt b}{2\sqrt{g(\cos\Phi-\cos\zeta)}} , \tag{1} $$

and its integral is what has to be found out. To this end he puts $\sin\frac12\zeta = c$ and
$\sin\frac12\Phi = z$. Then

$$ \cos\zeta = 1-2cc , \qquad \cos\Phi = 1-2zz , \tag{2} $$

and since

$$ \cos\tfrac12\Phi = \sqrt{1-zz} , \tag{3} $$

the differential of $z$ gives $\frac12 d\Phi\cos\frac12\Phi = dz$, whence

$$ d\Phi = \frac{2dz}{\sqrt{1-zz}} . \tag{4} $$

With these values the cosines are gone, and the element of time has become algebraic:

$$ dt = \frac{dz\sqrt b}{\sqrt{2g(cc-zz)(1-zz)}} \quad\text{or}\quad
   \frac{dt\sqrt{2g}}{\sqrt b} = \frac{dz}{\sqrt{(cc-zz)(1-zz)}} . \tag{5} $$

To express the whole time of the ascent, from $\Phi = 0$ to $\Phi = \zeta$, the integral must be extended from
$z = 0$ to $z = c$; that gives the time of one half oscillation. It should be noted, he says, that the
quantity $c$ can never exceed unity, and that in small oscillations it is even a very small fraction. This is
what makes the series of {{sec pendulum.08}} converge.

::: margin
Today: $\dfrac{t\sqrt{2g}}{\sqrt b} = F\!\left(\arcsin\dfrac zc,\,c\right)$, Legendre's elliptic integral of
the first kind, and $K(c)$ for the half oscillation.
:::

## The program

Both forms of the element, each written so that it serves in doubles and in fifty digits. In {{eq 5}} the two
factors of $cc-zz$ are kept apart.
*/

template <class Real>
Real element_in_phi(Real phi, Real zeta)  // (1), over dΦ, in the unit √b/√(2g)
{
  using std::sqrt;
  return 1 / sqrt(2 * cosine_difference(phi, zeta));
}

template <class Real>
Real element_in_z(Real z, Real c)  // (5), over dz
{
  using std::sqrt;
  return 1 / sqrt((c - z) * (c + z) * (1 - z * z));
}

/*!
What no elementary function can do, the symmetric integral of Carlson does in a few steps: with
$R_F(x,y,w) = \frac12\int_0^\infty ds/\sqrt{(s+x)(s+y)(s+w)}$ the time is
$\frac zc R_F\bigl(\frac{cc-zz}{cc}, 1-zz, 1\bigr)$. What vanishes at the turning point,
$cc - zz = \sin\frac12(\zeta+\Phi)\sin\frac12(\zeta-\Phi)$, comes as a product.
*/

double by_carlson(double phi, Amplitude to)
{
  const double c = to.modulus(), z = std::sin(phi / 2), cosine = std::cos(phi / 2);
  const double rest = std::sin((to.zeta + phi) / 2) / c * (std::sin((to.zeta - phi) / 2) / c);
  return z / c * gsl_sf_ellint_RF(rest, cosine * cosine, 1, GSL_PREC_DOUBLE);
}

/*!
Others follow Legendre and put $z = c\sin\theta$, which takes the infinity away: the element becomes
$d\theta/\sqrt{1-cc\sin^2\theta}$. The angle θ has to be found without an arc sine, which has no digits left
near 90°. Then plain sums of Gauss serve, and the functions of the libraries.
*/

double legendre_angle(double phi, Amplitude to)
{
  const double root = std::sqrt(std::sin((to.zeta + phi) / 2)) * std::sqrt(std::sin((to.zeta - phi) / 2));
  return std::atan2(std::sin(phi / 2), root);
}

double by_gauss(double phi, Amplitude to, int points)
{
  double c = to.modulus();
  const auto element = [](double theta, void* c_) {
    const double s = *static_cast<double*>(c_) * std::sin(theta);
    return 1 / std::sqrt((1 - s) * (1 + s));
  };
  const gsl_function f{element, &c};
  const auto table = gsl_integration_glfixed_table_alloc(static_cast<std::size_t>(points));
  const double t = gsl_integration_glfixed(&f, 0, legendre_angle(phi, to), table);
  gsl_integration_glfixed_table_free(table);
  return t;
}

/*!
The crudest way is to let an adaptive rule loose on {{eq 1}} as it stands.
*/

double adaptively(double phi, Amplitude to)
{
  double zeta = to.zeta, t = 0, error = 0;
  const gsl_function f{[](double x, void* z) { return element_in_phi(x, *static_cast<double*>(z)); }, &zeta};
  gsl_integration_workspace* space = gsl_integration_workspace_alloc(200);
  gsl_integration_qags(&f, 0, phi, 0, 1e-10, 200, space, &t, &error);
  gsl_integration_workspace_free(space);
  return t;
}

const auto swing_ = amplitude(90_deg, open(0_deg, 180_deg));
const auto phi = angle("phi", 60_deg, above_to(0_deg, 180_deg), "how far the pendulum has come, BAG = Φ");
const auto b = real("b", 1.0, metres, positive, "length of the isochronous simple pendulum");
const auto g = real("g", 4.903325, metres, positive, "height fallen in the first second");

TELL
{
  const Amplitude zeta{swing_.zeta, swing_.eta};
  const Fifty to_the_top = exact::pi() - phi.fifty();  // where ζ is nearly 180°, only this can tell
  require(phi <= zeta.zeta && to_the_top >= swing_.eta.fifty() * (1 - 1e-15), "phi", "at most zeta");
  const double unit = std::sqrt(b) / std::sqrt(2 * g), u = swing::time_from_bottom(phi, zeta);
  tell("c", zeta.modulus(), "c = sin ½ζ");
  tell("z", std::sin(phi / 2), "z = sin ½Φ");
  tell("t", unit * u, seconds, "from AB up to Φ");
  tell("t_zeta", unit * swing::quarter_time(zeta), seconds, "the whole ascent, half an oscillation");
  tell("share", u / swing::quarter_time(zeta), percent, "of the ascent's time has gone when Φ is reached");
  tell("u", u, "t√(2g)/√b, the integral (5) up to z");
  
}

TELL
{
  const Amplitude zeta{swing_.zeta, swing_.eta};
  const double at = phi, c = zeta.modulus();
  using namespace boost::math::policies;  // not in long doubles, and NaN rather than an exception
  using Doubles = policy<promote_double<false>, domain_error<ignore_error>, overflow_error<ignore_error>>;
  std::vector<Method> ways;
  for(const int points : {4, 8, 16})
    ways.push_back({"Gauss in θ, " + std::to_string(points) + " points",
                    [=] { return by_gauss(at, zeta, points); }, "Gauss"});
  const auto way = [&](const char* name, auto time) { ways.push_back({name, time}); };
  way("adaptive on (1), GSL", [=] { return adaptively(at, zeta); });
  way("Carlson's R_F, GSL", [=] { return by_carlson(at, zeta); });
  way("Legendre's F, GSL", [=] { return gsl_sf_ellint_F(legendre_angle(at, zeta), c, GSL_PREC_DOUBLE); });
  way("Legendre's F, Boost", [=] { return boost::math::ellint_1(c, legendre_angle(at, zeta), Doubles()); });
  way("Legendre's F, std", [=] { return std::ellint_1(c, legendre_angle(at, zeta)); });
  way("this edition", [=] { return swing::time_from_bottom(at, zeta); });
  if(zeta.zeta < 1e-20)
    return;  // 180° less that is 180° even in fifty digits
  const Fifty eta = zeta.zeta < zeta.eta ? exact::pi() - swing_.zeta.fifty() : swing_.eta.fifty();
  const bool at_rest = at == zeta.zeta;
  const Fifty last = oracle::time_from_rest_past(std::min(1e-12, zeta.zeta), eta);
  tell("last", static_cast<double>(last), "what the last 10⁻¹² of a radian before ζ take, in the same unit");
  const Fifty K = oracle::K_from_complement(sin(eta / 2));
  race("t", "t√(2g)/√b", at_rest ? K : oracle::time_from_bottom(phi.fifty(), eta), ways);
}

TELL
{
  curve("elements", {"part", "in_phi", "in_theta"}, [](Curve& c) {
    for(double part = 0; part < 1; part += part < 0.9 ? 0.01 : 0.001)
    {
      const double theta = part * 90_deg, s = std::sin(45_deg) * std::sin(theta);
      c.put({part, 90_deg * element_in_phi(part * 90_deg, 90_deg), 90_deg / std::sqrt(1 - s * s)});
    }
  });
}

/*!
A pendulum that swings to {{zeta|deg0}} reaches {{phi|deg0}} after {{share|3}} of its ascent; the rest goes in
turning round.

::: figure pendulum-07
alt: Two curves of time per part of the way. In terms of Φ it rises slowly and then without bound at the
turning point. In terms of θ it rises gently from 1.57 to 2.22.

What each element of the way to a right angle takes, the way being measured by $\Phi/\zeta$ or by
$\theta/90°$, where $\sin\theta = z/c$. Both curves enclose the same area, the time of the ascent. In Φ the
last elements take longer than any number, for there the pendulum stands; in θ nothing remarkable happens.
:::

## Checks

The angle of {{eq 1}} and the quantity $z$ of {{eq 5}} give the same time, element by element and in the
whole, and the library, Carlson's integral and the sums agree with them.
*/

CHECK_THAT("the elements in Φ and in z are the same time, and so are their integrals")
{
  const Fifty zeta = exact::pi() / 2, c = sin(zeta / 2);
  for(const Fifty& x : {exact::pi() / 180, exact::pi() / 4, exact::pi() / 3, exact::pi() * 89 / 180})
  {
    const Fifty z = sin(x / 2);
    CHECK(cos(x) == within(1 - 2 * z * z, 1e-48, "to the last digit"));  // (2)
    CHECK(cos(x / 2) == within(sqrt(1 - z * z), 1e-48, "to the last digit"));  // (3)
    CHECK(element_in_z(z, c) * cos(x / 2) / 2
          == within_relative(element_in_phi(x, zeta), 1e-45, "a dozen roundings near the end"));  // (4)
  }
  const auto in_z = [&](const Fifty& z) { return element_in_z(z, c); };
  const auto in_phi = [&](const Fifty& x) { return element_in_phi(x, zeta); };
  const Fifty u("0.826017876249245185456239407804");
  CHECK(exact::integrate(in_z, 0, Fifty(1) / 2).value == within(u, 1e-29, "as many digits as given"));
  CHECK(exact::integrate(in_phi, 0, exact::pi() / 3).value == within(u, 1e-29, "as many digits as given"));
}

CHECK_THAT("the whole ascent to a right angle takes 1.854074677301371918...")
{
  const Fifty c = sin(exact::pi() / 4), K("1.85407467730137191843385034720");
  const auto from_end = [&](const Fifty& z, const Fifty& to_end) {
    return to_end > 0 ? 1 / sqrt(to_end * (c + z) * (1 - z * z)) : element_in_z(z, c);
  };
  CHECK(exact::integrate_from_ends(from_end, 0, c).value == within(K, 1e-29, "as many digits as are given"));
  CHECK(swing::quarter_time({90_deg, 90_deg}) == within_ulps(K, 2, "the library's bound, and π/2 rounded"));
  CHECK(by_gauss(90_deg, Amplitude::from_zeta(90_deg), 16) == within_ulps(K, 8, "sixteen terms"));
}

CHECK_THAT("all ways lead to the same time, below and above the right angle")
{
  for(const double zeta : {1_deg, 90_deg, 150_deg})
    for(const double part : {0.1, 0.66, 0.999})
    {
      const Amplitude to = Amplitude::from_zeta(zeta);
      const double at = part * zeta;
      const Fifty t = oracle::time_from_bottom(at, exact::pi() - Fifty(zeta));
      CHECK(by_carlson(at, to) == within_relative(t, 2e-15, "a dozen roundings, and R_F's own"));
      CHECK(by_gauss(at, to, 32) == within_relative(t, 2e-14, "32 terms, rather few at 150°"));
      CHECK(adaptively(at, to) == within_relative(t, 1e-10, "the tolerance that is asked for"));
      CHECK(swing::time_from_bottom(at, to) == within_relative(t, 1e-15, "four ulps"));
    }
  const double half_way = swing::time_from_bottom(0.5e-9, Amplitude::from_zeta(1e-9));
  CHECK(half_way == within_ulps(exact::pi() / 6, 4, "arcsin ½, and no more, for so small a swing"));
}

/*!
The last $10^{-12}$ of a radian before the turning point take {{last|e2}} of the unit, for the pendulum hardly
moves there. As the difference of two times that number is lost for the greater part; with {{eq 2}} taken at
its word, $cc$ less $zz$, nearly so. Begun at the turning point, by {{sec pendulum.14}}, the integral has all
its digits.
*/

CHECK_THAT("the last moments of the ascent are known only from the turning point")
{
  const Fifty last("0.00000141421356237309504880168874778");
  const Amplitude right = Amplitude::from_zeta(90_deg);
  const double K = swing::quarter_time(right), phi_ = 90_deg - 1e-12;
  CHECK(swing::time_from_rest_past(1e-12, 90_deg) == within_ulps(last, 4, "little more than a root"));

  const double c = right.modulus(), z = std::sin(phi_ / 2);
  const double bluntly = K - z / c * gsl_sf_ellint_RF(1 - z * z / (c * c), 1 - z * z, 1, GSL_PREC_DOUBLE);
  const double off = std::abs(bluntly / static_cast<double>(last) - 1);
  CHECK(off == between(1e-6, 1e-3, "cc − zz is 10⁻¹², rounded to 10⁻¹⁶"));
  CHECK(K - by_carlson(phi_, right) == within_relative(last, 1e-4, "90° − 10⁻¹² is itself rounded by 10⁻¹⁶"));
}

/*!
In the text that we have every $zz$ but the one in $\cos\Phi$ has become $2zz$, and the root of {{eq 1}} stops
short of the bracket. {{sec pendulum.13}} quotes {{eq 5}} rightly. Each formula is put to the test at
$\Phi = 40°$, for a swing to 90°.
*/

const double z_40 = std::sin(20_deg);

const Emendation root{
    "§7, dt", {"dΦ √b / 2√g (cos Φ − cos ζ)", 1 / (2 * std::sqrt(0.5) * cosine_difference(40_deg, 90_deg))},
    {"dΦ √b / 2√(g (cos Φ − cos ζ))", 1 / (2 * std::sqrt(0.5 * cosine_difference(40_deg, 90_deg)))},
    "it is the reciprocal of the speed of the exact motion",
    [](double reading) {  // b = 1, 2g = 1
      const auto motion = oracle::Motion::from_zeta(exact::pi() / 2);
      const Fifty t = oracle::time_from_bottom(40_deg, exact::pi() / 2);
      return reading == within_ulps(1 / motion.velocity(t), 6, "two sines, a root, three products");
    }};

const Emendation half_cosine{
    "§7, cos ½Φ", {"√(1 − 2zz)", std::sqrt(1 - 2 * z_40 * z_40)}, {"√(1 − zz)", std::sqrt(1 - z_40 * z_40)},
    "z is the sine of ½Φ; √(1 − 2zz) is the root of cos Φ",
    [](double reading) {
      return reading == within_ulps(cos(Fifty(20_deg)), 3, "a sine, a product, a root");
    }};

const Emendation differential{
    "§7, dΦ", {"2dz/√(1 − 2zz)", 2 / std::sqrt(1 - 2 * z_40 * z_40)},
    {"2dz/√(1 − zz)", 2 / std::sqrt(1 - z_40 * z_40)},
    "Φ is twice the arc whose sine is z",
    [](double reading) {
      const Fifty h("1e-12"), slope = (asin(z_40 + h) - asin(z_40 - h)) / h;
      return reading == within_ulps(slope, 4, "a product, a root, a quotient");
    }};

/// The integral of 1/√((cc − n zz)(1 − n zz)) up to 40°, with cc = ½: n is 2 as printed, and 1.
double integral(int n)
{
  const auto element = [=](const Fifty& z) { return 1 / sqrt((Fifty(1) / 2 - n * z * z) * (1 - n * z * z)); };
  return static_cast<double>(exact::integrate(element, 0, sin(exact::pi() / 9)).value);
}

const Emendation time_element{
    "§7, the integral", {"dz/√((cc − 2zz)(1 − 2zz))", [] { return integral(2); }},
    {"dz/√((cc − zz)(1 − zz))", [] { return integral(1); }},
    "the exact motion comes to 40° sooner by a twelfth than is printed, and it comes to 90°, where the "
    "printed root is imaginary",
    [](double reading) {
      const Fifty t = oracle::time_from_bottom(exact::pi() * 2 / 9, exact::pi() / 2);
      return reading == within_ulps(t, 1, "fifty digits, rounded");
    }};

CHECK_THAT("the printed root would end where z is c over the root of two")
{
  CHECK(0.5 - 2 * 0.5 * 0.5 == 0);  // cc − 2zz at Φ = 60°, for a swing to 90°
  CHECK(integral(2) == within(Fifty("0.55800314432573795904"), 1.2e-16, "the double nearest to it"));
  CHECK(integral(1) == within(Fifty("0.51564164027618766279"), 1.2e-16, "the double nearest to it"));
}
