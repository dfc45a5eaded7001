#include <algorithm>

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

The time in which the pendulum rises to an angle is an integral, and the sines of half the angles make it
algebraic. The speed of {{sec pendulum.06}} gives the element of time,

$$ dt = \frac{d\Phi\sqrt b}{2\sqrt{g(\cos\Phi-\cos\zeta)}}{{entry root}} , \tag{1} $$

which has to be integrated. He puts $\sin\frac12\zeta = c$ and $\sin\frac12\Phi = z$. Then

$$ \cos\zeta = 1-2cc , \qquad \cos\Phi = 1-2zz , \tag{2} $$

$$ \cos\tfrac12\Phi = \sqrt{1-zz}{{entry half_cosine}} , \tag{3} $$

and from the differentials, $\frac12 d\Phi\cos\frac12\Phi = dz$, he concludes that

$$ d\Phi = \frac{2dz}{\sqrt{1-zz}} . \tag{4} $$

With these values the element of time becomes

$$ \begin{aligned} dt &= \frac{dz\sqrt b}{\sqrt{2g(cc-zz)(1-zz)}}{{entry squares}} ,\quad\text{or} \\
   \frac{dt\sqrt{2g}}{\sqrt b} &= \frac{dz}{\sqrt{(cc-zz)(1-zz)}} . \end{aligned} \tag{5} $$

::: margin
Today: up to $z$ the integral is $F(\arcsin\tfrac zc, c)$, Legendre's of the first kind, and up to $c$ it is
$K(c)$.
:::

For the whole ascent, from $\Phi = 0$ to $\Phi = \zeta$, the integral must be extended from $z = 0$ to
$z = c$. That is the time of half an oscillation. The quantity $c$, he notes, can never exceed one, and in
small oscillations it is a very small fraction.

## The program

The element of time is written in both variables, for doubles and for fifty digits alike.
*/

template <class Real>
Real element_in_phi(Real phi, Real zeta)  // (1) over dΦ, in the unit √b/√(2g)
{
  using std::sqrt;
  return 1 / sqrt(2 * cosine_difference(phi, zeta));
}

template <class Real>
Real element_in_z(Real z, Real c)  // (5) over dz
{
  using std::sqrt;
  return 1 / sqrt((c - z) * (c + z) * (1 - z * z));
}

/*!
The integral is no elementary function. Legendre's substitution $z = c\sin\theta$ turns the element into
$d\theta/\sqrt{1-cc\sin^2\theta}$, which stays finite at the turning point. The angle θ is found from its
tangent, with $cc-zz = \sin\frac12(\zeta+\Phi)\sin\frac12(\zeta-\Phi)$ as a product; an arc sine would lose
its digits near 90°.
*/

double legendre_angle(double phi, Amplitude to)
{
  const double root = std::sqrt(std::sin((to.zeta + phi) / 2)) * std::sqrt(std::sin((to.zeta - phi) / 2));
  return std::atan2(std::sin(phi / 2), root);
}

/*!
In θ a few points of Gauss' rule are enough.
*/

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

const auto swing_ = amplitude(90_deg, open(0_deg, 180_deg));
const auto phi = angle("phi", 60_deg, above_to(0_deg, 180_deg), "how far the pendulum has come, BAG = Φ");
const auto b = real("b", 1.0, metres, scale, "length of the isochronous simple pendulum");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second");

/*!
Where ζ is nearly 180° the doubles of Φ and ζ may be one. There the time is had from the other end, by the way
that is left up to ζ, from the angles as they were written.
*/

Fifty to_the_top()
{
  return exact::pi() - phi.fifty();
}

double time_up_to_phi(Amplitude to)
{
  if(to_the_top() > 1e-3)
    return swing::time_from_bottom(phi, to);
  const double left = double(to_the_top() - swing_.eta.fifty());
  return swing::quarter_time(to) - swing::time_from_rest_past(std::max(left, 0.0), to.eta);
}

TELL
{
  const Amplitude to{swing_.zeta, swing_.eta};
  require(phi <= to.zeta, "phi", "at most zeta");
  require(to_the_top() >= swing_.eta.fifty() * (1 - 1e-15), "phi", "at most zeta");
  const double unit = std::sqrt(b) / std::sqrt(2 * g), u = time_up_to_phi(to);
  tell("c", to.modulus(), "c = sin ½ζ");
  tell("z", std::sin(phi / 2), "z = sin ½Φ");
  tell("t", unit * u, seconds, "from AB up to Φ");
  tell("t_zeta", unit * swing::quarter_time(to), seconds, "the whole ascent, half an oscillation");
  tell("share", u / swing::quarter_time(to), percent, "of the ascent's time has gone when Φ is reached");
  tell("last", swing::time_from_rest_past(std::min(1e-12, to.zeta), to.eta),
       "t√(2g)/√b for the last 10⁻¹² of a radian before ζ");
}

TELL
{
  curve("elements", {"part", "in_phi", "in_theta"}, [](Curve& c) {
    for(double part = 0; part < 1; part += part < 0.9 ? 0.01 : 0.001)
    {
      const double s = std::sin(45_deg) * std::sin(part * 90_deg);
      c.put({part, 90_deg * element_in_phi(part * 90_deg, 90_deg), 90_deg / std::sqrt(1 - s * s)});
    }
  });
}

/*!
A pendulum that swings to {{zeta|deg0}} has used {{share|3}} of its time when it reaches {{phi|deg0}}; the
rest it needs to come to a stop.

::: figure pendulum-07
alt: Two curves of time per part of the way. In terms of Φ it rises slowly and then without bound at the
turning point. In terms of θ it rises gently from 1.57 to 2.22.

The time that each part of the way to a right angle takes, the way being measured by $\Phi/\zeta$ or by
$\theta/90°$, where $\sin\theta = z/c$. Both curves enclose the same area, the time of the ascent. In Φ the
element grows without bound where the pendulum stops; in θ it stays finite.
:::

## Speed against error
*/

TELL
{
  const Amplitude to{swing_.zeta, swing_.eta};
  const double at = phi;
  std::vector<Method> ways;
  for(const int points : {4, 8, 16})
    ways.push_back({"Gauss in θ, " + std::to_string(points) + " points",
                    [=] { return by_gauss(at, to, points); }, "Gauss"});
  if(to.modulus() < 1)
    ways.push_back({"Legendre's F, GSL", [=] {
                      return gsl_sf_ellint_F(legendre_angle(at, to), to.modulus(), GSL_PREC_DOUBLE);
                    }});
  ways.push_back({"this edition", [=] { return time_up_to_phi(to); }});
  if(to.zeta < 1e-20)
    return;  // 180° less that is 180° even in fifty digits
  const Fifty eta = to.zeta < to.eta ? exact::pi() - swing_.zeta.fifty() : swing_.eta.fifty();
  const Fifty K = oracle::K_from_complement(sin(eta / 2));
  race("ascent", "t√(2g)/√b", to_the_top() <= eta ? K : oracle::time_from_bottom(phi.fifty(), eta), ways);
}

/*!
## Checks

The judge is the motion itself, computed by theta functions: the element of time must be the reciprocal of
its speed, and the integrals must be its times.
*/

CHECK_THAT("the elements in Φ and in z are the reciprocal of the speed, and their integrals the time")
{
  const Fifty right = exact::pi() / 2, c = sin(right / 2), K = oracle::K_from_complement(c);
  const auto motion = oracle::Motion::from_zeta(right);
  const auto in_phi = [&](const Fifty& x) { return element_in_phi(x, right); };
  const auto in_z = [&](const Fifty& z) { return element_in_z(z, c); };
  for(const double part : {0.05, 0.5, 0.95})
  {
    const Fifty x = motion.angle(part * K), z = sin(x / 2);
    CHECK(cos(x) == within(1 - 2 * z * z, 1e-49, "a few roundings of fifty digits"));        // (2)
    CHECK(cos(x / 2) == within(sqrt(1 - z * z), 1e-49, "a few roundings of fifty digits"));  // (3)
    const Fifty slowness = 1 / motion.velocity(part * K);
    CHECK(in_phi(x) == within_relative(slowness, 1e-47, "at 0.95 a digit is lost"));
    CHECK(in_z(z) * cos(x / 2) / 2 == within_relative(slowness, 1e-47, "the same"));  // (4)
    CHECK(exact::integrate(in_phi, 0, x).value == within(part * K, 1e-40, "the rule's own tolerance"));
  }
  const auto to_the_end = [&](const Fifty& z, const Fifty& gap) {
    return gap > 0 ? 1 / sqrt(gap * (c + z) * (1 - z * z)) : in_z(z);
  };
  CHECK(exact::integrate_from_ends(to_the_end, 0, c).value == within(K, 1e-40, "the rule's own tolerance"));
}

CHECK_THAT("all ways lead to the same time, below and above the right angle")
{
  for(const double zeta : {1_deg, 90_deg, 150_deg})
    for(const double part : {0.1, 0.66, 0.999})
    {
      const Amplitude to = Amplitude::from_zeta(zeta);
      const Fifty t = oracle::time_from_bottom(part * zeta, exact::pi() - Fifty(zeta));
      CHECK(by_gauss(part * zeta, to, 32)
            == within_relative(t, 1e-15, "32 terms, their roundings averaged"));
      CHECK(swing::time_from_bottom(part * zeta, to) == within_relative(t, 1e-15, "the library's bound"));
    }
  CHECK(by_gauss(0.5e-9, Amplitude::from_zeta(1e-9), 4)
        == within_ulps(exact::pi() / 6, 2, "arcsin ½, and no more, for so small a swing"));
}

/*!
The last $10^{-12}$ of a radian before the turning point take {{last|e2}} of the unit $\sqrt{b/2g}$.
As the difference of two times this number keeps few of its digits, and fewer still when $cc-zz$ is formed
by subtraction. Counted from the turning point, as in {{sec pendulum.14}}, it has them all.
*/

CHECK_THAT("the last moments of the ascent are known only from the turning point")
{
  const Amplitude right = Amplitude::from_zeta(90_deg);
  const Fifty last = oracle::time_from_rest_past(1e-12, exact::pi() / 2);
  CHECK(swing::time_from_rest_past(1e-12, 90_deg) == within_ulps(last, 2, "little more than a root"));
  const double K = swing::quarter_time(right), c = right.modulus(), phi_ = 90_deg - 1e-12;
  CHECK(K - by_gauss(phi_, right, 32)
        == within_relative(last, 1e-4, "90° − 10⁻¹² is itself rounded by 10⁻¹⁶"));
  const double z = std::sin(phi_ / 2), theta = std::atan2(z, std::sqrt(c * c - z * z));
  CHECK(std::abs((K - gsl_sf_ellint_F(theta, c, GSL_PREC_DOUBLE)) / static_cast<double>(last) - 1)
        == between(5e-5, 5e-4, "cc − zz is 10⁻¹² and rounded by 10⁻¹⁶"));
}

/*!
In our copy every $zz$ but the one in $\cos\Phi$ has become $2zz$, and two roots stop short of what belongs
under them. {{sec pendulum.13}} has {{eq 5}} rightly. The proofs put the motion at $\Phi = 40°$, in a swing
to 90°, with $b = 1$ and $2g = 1$.
*/

const double z_40 = std::sin(20_deg), difference = cosine_difference(40_deg, 90_deg);

bool is_slowness(double element_over_dphi)
{
  const Fifty t = oracle::time_from_bottom(40_deg, exact::pi() / 2);
  const Fifty velocity = oracle::Motion::from_zeta(exact::pi() / 2).velocity(t);
  return element_over_dphi == within_ulps(1 / velocity, 4, "two sines, a root, three products");
}

const Emendation root{"§7, the root in dt, and again in the first dt in terms of z",
                      {"dΦ √b / 2√g (cos Φ − cos ζ)", 1 / (2 * std::sqrt(0.5) * difference)},
                      {"dΦ √b / 2√(g (cos Φ − cos ζ))", 1 / (2 * std::sqrt(0.5 * difference))},
                      "it is the reciprocal of the speed with which the motion passes through 40°",
                      is_slowness};

const Emendation half_cosine{
    "§7, cos ½Φ, and again in dΦ",
    {"√(1 − 2zz)", std::sqrt(1 - 2 * z_40 * z_40)},
    {"√(1 − zz)", std::sqrt(1 - z_40 * z_40)},
    "z is the sine of ½Φ; √(1 − 2zz) is the root of cos Φ",
    [](double reading) { return reading == within_ulps(cos(Fifty(20_deg)), 2, "a sine and a root"); }};

double element_at_40(double n)  // over dΦ; n is 2 in our copy
{
  return std::cos(20_deg) / 2 / std::sqrt((0.5 - n * z_40 * z_40) * (1 - n * z_40 * z_40));
}

const Emendation squares{
    "§7, dt in terms of z, twice",
    {"dz/√((cc − 2zz)(1 − 2zz))", element_at_40(2)},
    {"dz/√((cc − zz)(1 − zz))", element_at_40(1)},
    "times dz/dΦ = ½ cos ½Φ it must be the same; and the root with the 2 is imaginary from 60° to 90°",
    is_slowness};

/*!
What is told, and the race's ways, by the motion in fifty digits:
*/

CHECK_THAT("the times told are the motion's, and the share their quotient")
{
  for(const Told& now : told_at("", "zeta=150 phi=149 b=2", "zeta=20 phi=1 g=1e50", "eta=1e-6 phi=179",
                                "eta=1e-20rad phi=179.9999999999999999"))
  {
    const Fifty zeta = swing_.zeta.fifty(), eta = swing_.eta.fifty(), Phi = phi.fifty();
    const Fifty unit = sqrt(b.fifty() / (2 * g.fifty())),
                K = exact::pi() / 2 * swing::oracle::ratio_from_top(eta);
    const Fifty u = oracle::time_from_bottom(Phi, eta);
    CHECK(now.value("c") == within_ulps(sin(zeta / 2), 1, "one sine"));
    CHECK(now.value("z") == within_ulps(sin(Phi / 2), 1, "one sine"));
    const double near = 2e-15 + (to_the_top() > 1e-3 ? 4e-16 / (swing_.zeta - phi) : 0);
    CHECK(now.value("t", seconds) == within_relative(unit * u, near, "ζ − Φ of rounded angles"));
    CHECK(now.value("t_zeta", seconds)
          == within_relative(unit * K, 1e-15, "the library's bound, and the unit"));
    CHECK(now.value("share", percent) == within_relative(u / K, near, "the quotient of both"));
    const Fifty last = oracle::time_from_rest_past(Fifty("1e-12"), eta);
    CHECK(now.value("last") == within_relative(last, 4e-15, "little more than a root"));
    CHECK(now.exact("ascent") == within_relative(u, 1e-40, "the same oracle"));
    CHECK(now.method("ascent", "this edition") == within_relative(u, near, "ζ − Φ of rounded angles"));
  }
}

CHECK_THAT(
    "Gauss' rule gains digits with its points, and Legendre's integral has them all, far from the top")
{
  for(const Told& now : told_at("", "zeta=60 phi=50", "zeta=20 phi=1"))
  {
    const Fifty u = oracle::time_from_bottom(phi.fifty(), swing_.eta.fifty());
    CHECK(now.method("ascent", "Gauss in θ, 4 points") == within_relative(u, 2e-6, "four points"));
    CHECK(now.method("ascent", "Gauss in θ, 8 points") == within_relative(u, 2e-12, "eight points"));
    CHECK(now.method("ascent", "Gauss in θ, 16 points") == within_relative(u, 2e-15, "sixteen points"));
    CHECK(now.method("ascent", "Legendre's F, GSL") == within_relative(u, 3e-15, "Carlson's duplication"));
  }
}

CHECK_THAT("the figure has the element of time in both variables")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("elements", 6))
    {
      const Fifty part(point.at("part")), quarter = exact::pi() / 2;
      const auto motion = oracle::Motion::from_zeta(quarter);
      if(part < Fifty(0.9))
      {
        const Fifty t = oracle::time_from_bottom(part * quarter, quarter);
        CHECK(point.value("in_phi")
              == within_relative(quarter / motion.velocity(t), 1e-14, "ζ − Φ rounds"));
      }
      const Fifty s = pow(sin(part * quarter), 2) / 2;
      CHECK(point.value("in_theta") == within_relative(quarter / sqrt(1 - s), 1e-15, "few roundings"));
    }
}

CHECK_THAT("an angle beyond the amplitude is refused, also where both are too near to the top for a double "
           "to tell")
{
  for(const char* const within_it :
      {"zeta=20 phi=20", "zeta=150 phi=150", "eta=1e-9 phi=179.999999999",
       "eta=1e-18 phi=179.999999999999999999", "eta=1e-18 phi=179.9999999999999999990000000000000009"})
    CHECK(!refused_at(within_it));
  for(const char* const beyond :
      {"zeta=20 phi=20.00000000000001", "zeta=150 phi=150.00000000000006",
       "eta=1e-9 phi=179.999999999000000000001", "eta=1e-18 phi=179.999999999999999999000000000001",
       "eta=1e-18 phi=179.9999999999999999990000000000000011"})
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
How far has the pendulum come after half of its ascent's time? Compare a swing to 90° with a very small
one.

answer: To 65.53° of 90, and to $\frac12\sqrt2$ of a small amplitude; the wider the swing, the farther. At
half of the time $\tan\frac12\Phi = c/\sqrt{c'(1+c')}$, where $c' = \cos\frac12\zeta$.
:::
*/

CHECK_THAT("after half of the time a swing to 90° has come to 65.53°, a small one to √½ of its amplitude")
{
  for(const Told& now : told_at("phi=65.530199479297808"))
  {
    CHECK(now.value("share", percent) == within(0.5, 1e-14, "a rounded angle, and the library's bound"));
    const Fifty c = sqrt(Fifty(0.5));
    CHECK(tan(phi.fifty() / 2) == within(c / sqrt(c * (1 + c)), 1e-16, "the angle's seventeen digits"));
  }
  for(const Told& now : told_at("zeta=0.001 phi=0.00070710678118654752"))
    CHECK(now.value("share", percent) == within(0.5, 1e-10, "ζζ"));
}
