#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/path.hpp"

SECTION(tautochrone, 21, "The simple pendulum first")

using namespace tautochrone;

/*!
## What Euler does

To find the curve more easily Euler begins with the simple pendulum, all of whose mass is in the one point
$G$. As the body has no parts outside of it, $kk = 0$, and the time of one swing, from
{{sec tautochrone.19}}, is

$$ 2\int\frac{dz}{\sqrt{c-x}}, \tag{1} $$

from $x = 0$ to $x = c$. Its value does not depend upon $c$ if

$$ dz = \frac{dx\sqrt f}{\sqrt x}, \qquad z = 2\sqrt{fx}, \tag{2} $$

which is the equation of a cycloid. The radius of curvature in the lowest place $C$, being equal to the
subnormal there, is

$$ \frac{z\,dz}{dx} = 2f, \tag{3} $$

and since it must be equal to $AC = a$, $f = \tfrac12a$: half of the simple pendulum that keeps time with
the smallest swings. This most elegant property of the cycloid Huygens brought to light, and geometers
have since confirmed it by various proofs.

::: margin
$T = 2\sqrt f\int_0^c \frac{dx}{\sqrt{x(c-x)}} = 2\pi\sqrt f$: in Euler's clock, where a velocity is the
root of a height.
:::

Why the root of $x$? Let the arc be as another power, $z = 2a\,(x/2a)^p$. With $x = cu$

$$ T = 2p\,\sqrt{2a}\,\Bigl(\frac c{2a}\Bigr)^{p-\frac12}\cdot B(p, \tfrac12) , \tag{A} $$

$B$ being Euler's integral $\int u^{p-1}du : \sqrt{1-u}$; and of all powers only $p = \tfrac12$ is free of
$c$.

## The program

The times of the swings of {{eq A}} for the reader's height and power, and the cycloid's.
*/

const auto a = real("a", 1, metres, scale, "AC, the length of the thread");
const auto c = real("c", 0.1, metres, scale, "height to which the bob rises");
const auto p = real("p", 0.5, none, closed(0.25, 2), "z goes as this power of x; ½ is the cycloid");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

double beta(double power)  // B(p, ½)
{
  return double(tgamma(Fifty(power)) / tgamma(Fifty(power) + 0.5) * sqrt(exact::pi()));
}

double time_of(double power, double B, double height)  // (A) over √a, for heights in units of a
{
  return 2 * power * std::numbers::sqrt2 * std::pow(height / 2, power - 0.5) * B;
}

TELL
{
  require(c / a <= 0.5, "c", "from 1e-100 a to half of a, the height of the cycloid");
  require(c / a >= 1e-100, "c", "from 1e-100 a to half of a, the height of the cycloid");
  tell("f", a / 2, metres, "half of a");
  tell("z", std::sqrt(2 * a) * std::sqrt(c), metres, "the arc, by (2)");
  tell("T", small_swing(0) * (std::sqrt(a) / (2 * std::sqrt(g))), seconds,
       "one swing on the cycloid, 2π√f of Euler's clock");
  tell("T_p", time_of(p, beta(p), c / a) * (std::sqrt(a) / (2 * std::sqrt(g))), seconds,
       "one swing with the power p, (A)");
  if(c / a < 0.499)
    tell("summed",
         Path(exact::Laurent<double>(1.0, 1), 0).swing_time(std::asin(std::sqrt(2 * (c / a))))
             * (std::sqrt(a) / (2 * std::sqrt(g))),
         seconds, "(1), summed along the cycloid");
}

TELL
{
  curve("powers", {"c", "p40", "p50", "p60", "p100"}, [](Curve& out) {
    const double B40 = beta(0.4), B50 = beta(0.5), B60 = beta(0.6), B100 = beta(1);
    for(double height = 1e-4; height < 0.5; height *= 1.1)
      out.put({height, time_of(0.4, B40, height), time_of(0.5, B50, height), time_of(0.6, B60, height),
               time_of(1, B100, height)});
  });
}

/*!
A thread of {{a}} m swings in {{T|8}} s, whatever the height.

::: figure tautochrone-21
alt: The time of a swing against the height of its rise, the latter logarithmic. The line for the power
one half is level; those for greater powers rise, that for a smaller one falls.

The time of a swing, over $\sqrt a$ of Euler's clock, where the arc goes as the power $p$ of the height.
Only for $p = \tfrac12$ are all swings equal; $p = 1$ is a free fall and its reversal.
:::

## Checks
*/

Fifty integral_1(const Fifty& power, const Fifty& height)  // (1) by quadrature, a = 1, after x = c u⁴
{
  return exact::integrate_from_ends(
             [&](const Fifty& u, const Fifty& to_end) {
               const Fifty v = u > Fifty(0.5) ? to_end : 1 - u;  // 1 − u⁴ = (1 − u)(1 + u)(1 + uu)
               const Fifty dz = 8 * power * pow(height / 2, power) * pow(u, 4 * power - 1);
               return 2 * dz / sqrt(height * v * (1 + u) * (1 + u * u));
             },
             0, 1)
      .value;
}

CHECK_THAT("the times told are the integral (1), for any power and height; for p = ½ they are 2π√f")
{
  for(const Told& now : told_at("", "p=0.6 c=0.4 a=2", "p=1 c=1e-60 g=1", "p=0.3 a=1e60 c=3e59"))
  {
    const Fifty clock = sqrt(a.fifty()) / sqrt(4 * g.fifty());
    const Fifty lg = abs(log(c.fifty() / a.fifty() / 2)) * std::abs(p - 0.5);
    CHECK(now.value("T_p", seconds)
          == within_relative(clock * integral_1(p.fifty(), c.fifty() / a.fifty()),
                             1.2e-15 + 2e-16 * double(lg), "ten roundings, and the height's in the power"));
    CHECK(now.value("T", seconds)
          == within_relative(clock * 2 * exact::pi() * sqrt(Fifty(1) / 2), 1e-15, "two ulps, a quotient"));
    if(c / a < 0.499)
      CHECK(now.value("summed", seconds)
            == within_relative(clock * 2 * exact::pi() * sqrt(Fifty(1) / 2), 1e-15, "the same"));
    CHECK(now.value("f", metres) == within_ulps(a.fifty() / 2, 1, "a rounding, of a"));
    CHECK(now.value("z", metres)
          == within_relative(2 * sqrt(a.fifty() / 2 * c.fifty()), 1e-15, "two roots"));
  }
}

CHECK_THAT("(2) is the cycloid with r = a cos φ: its lowest radius is the subnormal, 2f = a")
{
  for(const char* at_ : {"1e-9", "0.3", "1.2"})
  {
    const Fifty phi(at_), h("1e-17"), x = pow(sin(phi), 2) / 2, z = 2 * sqrt(x / 2);
    CHECK(z == within_relative(sin(phi), 1e-48, "∫cos φ dφ"));
    const auto z_of = [](const Fifty& y) { return 2 * sqrt(y / 2); };
    const Fifty small = x * h, slope_ = (z_of(x + small) - z_of(x - small)) / (2 * small);
    CHECK(z * slope_ == within_relative(1, 1e-30, "z dz/dx is 2f everywhere, here 1"));
    CHECK(1 / slope_ == within_relative(sin(phi), 1e-30, "dx/dz is sin φ, so that r = dz/dφ = cos φ"));
  }
}

CHECK_THAT("it refuses a height above that of the cycloid, half of a, and one of less than 1e-100 a")
{
  for(const char* const within_them : {"c=0.5", "a=2 c=1", "a=2 c=2e-100", "a=8 c=8e-100"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"c=0.5000000000000001", "a=2 c=1.000000000000001",
                                  "a=2 c=1.99999999999999e-100", "a=8 c=7.9999e-100"})
    CHECK(refused_at(beyond));
}

CHECK_THAT(
    "of the powers only ½ leaves the time free of c: doubling c multiplies it by 2 to the power p − ½")
{
  for(const double power : {0.3, 0.5, 0.6, 1.0})
    CHECK(time_of(power, 1, 0.2) / time_of(power, 1, 0.1)
          == within_relative(pow(Fifty(2), Fifty(power) - 0.5), 1e-15, "two powers"));
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("powers", 4))
      for(const auto& [name, power] : {std::pair{"p40", 0.4}, {"p50", 0.5}, {"p60", 0.6}, {"p100", 1.0}})
        CHECK(point.value(name)
              == within_relative(integral_1(power, point.at("c")), 8e-16, "six roundings"));
}

/*!
## Go on from here

::: exercise
What motion is it for $p = 1$? Find its time without {{eq A}}.

answer: The arc is then the height: both branches of the curve are plumb, and the bob falls freely from the
height $c$ and is thrown up again as high. A fall from $c$ takes $\sqrt{c : g}$ seconds, as $g$ is the height
fallen in the first; the swing takes twice that. `--p 1` tells 0.28562 s, `--p 1 --c 0.4` the double.
:::
*/

CHECK_THAT("for p = 1 the swing is a free fall and its reversal, which takes 2√(c : g)")
{
  for(const Told& now : told_at("p=1", "p=1 c=0.4", "p=1 c=1e-50 a=3 g=2"))
    CHECK(now.value("T_p", seconds)
          == within_relative(2 * sqrt(c.fifty() / g.fifty()), 3e-14, "two Gammas, a power"));
  for(const Told& now : told_at("p=1"))
    CHECK(now.value("T_p", seconds) == within(0.28562, 0.000005, "five digits"));
}
