#include "edition/section.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

SECTION(tautochrone, 18, "The speed at every height")

using namespace tautochrone;

/*!
## What Euler does

The height that belongs to the speed of the centre of gravity is the height that it can still rise,
lessened in the ratio $MG : MH$. As $v = (a-s)^2d\varphi^2:dt^2$, the integral of {{sec tautochrone.17}},
in which the constant is now called $c$, gives

$$ v = \frac{(a-s)^2\bigl(c -
  \int(a-s)\,d\varphi\sin\varphi\bigr){{entry lost_bracket}}}{kk + (a-s)^2}. \tag{1} $$

Let this be applied to the start, with the pendulum in the vertical $ACD$, where $s = 0$ and the integral
vanishes. There $v = b$, and therefore

$$ b = \frac{aac}{kk+aa}, \tag{2} $$

by which one may, instead of the constant $c$, bring the first velocity $\sqrt b$ into the reckoning.
With $D$, the centre of oscillation for the vertical position, $CD = kk:a$ and $AD = (aa+kk):a$, so that

$$ b = \frac{AC\cdot c}{AD}. \tag{3} $$

Let further $CQ = x$ be the abscissa of the curve $CG$ that is described. As $Gg = (a-s)\,d\varphi$ and
the line $GM$ is normal to the curve, it is

$$ \sin GMS = \sin\varphi = \frac{dx}{Gg{{entry lost_g}}} = \frac{dx}{(a-s)\,d\varphi}, \tag{4} $$

hence $dx = (a-s)\,d\varphi\sin\varphi$: the integral is nothing else than $x$, the height of $G$ over
its lowest place. And because $MG = a-s$ and $GH = kk:(a-s)$,

$$ v = \frac{(a-s)^2(c-x)}{kk+(a-s)^2} = \frac{MG\,(c-x)}{MH}. \tag{5} $$

::: margin
Conservation of energy: $v(1 + kk/rr) + x = c$. Since $\sqrt v$ is zero at $x = c$, the constant is the
height of the rise, as {{sec tautochrone.19}} will say.
:::

So $M$ and $H$ do for each place what $A$ and $D$ do for the lowest one. For a fixed axis both are the
same points throughout, and $v$ falls with the height as it does for a heavy point, only more slowly by
the constant ratio $AC : AD$. On cheeks the ratio goes down with the height. It is this, and not the
curve alone, that a tautochrone has to make good.

## The program

Speeds as heights, from the formulae of {{sec tautochrone.17}}. The cheeks: 0 for a fixed axis, 1 for
cycloids, 2 and 3 for Euler's.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.3, metres, scale, "radius of gyration");
const auto cheeks = integer("cheeks", 1, 0, 3, "0 none, 1 cycloids, 2 Euler's with k², 3 with k⁴");
const auto phi0 = asked_swing(70_deg, cheeks, k, a);
const auto phi = angle("phi", within_swing(60_deg, phi0), closed(0_deg, 89_deg),
                       "angle of the free part with the vertical");

double part_of_fall(double ratio, double r)  // MG : MH, (5)
{
  return r / (r + ratio * (ratio / r));
}

TELL
{
  const double ratio = k / a;
  const auto which = static_cast<Cheeks>(int(cheeks));
  const auto at = asked_posture(which, ratio, phi0, phi), below = on_cheeks<double>(which, ratio, phi0, 0);
  tell("c", a * below.to_rise, metres, "the height of the rise");
  tell("to_rise", a * at.to_rise, metres, "c − x, what is left of it");
  tell("v", a * speed_height(at, ratio), metres, "the height due to the speed of G, (5)");
  tell("b", a * speed_height(below, ratio), metres, "the same in the lowest place, (2)");
  tell("MG_to_MH", part_of_fall(ratio, at.r), "MG : MH");
  tell("AC_to_AD", part_of_fall(ratio, 1), "AC : AD");
}

TELL
{
  curve("speeds", {"x", "k0", "k1", "k3", "k6", "axis"}, [](Curve& out) {
    for(int i = 0; i <= 80; ++i)
    {
      const double here = 80_deg * i / 80;
      const auto at = on_cycloids<double>(80_deg, here);
      const double c = on_cycloids<double>(80_deg, 0).to_rise, x = std::sin(here) * std::sin(here) / 2;
      const auto share = [&](double ratio) { return speed_height(at, ratio) / c; };
      out.put({x / c, at.to_rise / c, share(0.1), share(0.3), share(0.6),
               part_of_fall(0.6, 1) * at.to_rise / c});
    }
  });
}

/*!
In a swing to {{phi0|deg0}} the centre of gravity rises {{c|5}} m. At {{phi|deg0}} it has {{to_rise|4}} m
before it; the speed there is due to {{v|4}} m, since $MG : MH$ is {{MG_to_MH|4}}. In the lowest place
the ratio was {{AC_to_AD|4}}.

::: figure tautochrone-18
alt: The height due to the speed against the height of the centre of gravity, both in parts of the whole
rise. For a heavy point it is a straight line from one to zero. For bodies with growing radius of
gyration the curves begin lower and sag below a straight line, the more the larger the body. A straight
line from the same beginning as the lowest curve shows a fixed axis.

$v$ against $x$ in a swing to 80° between cycloids, for $k = 0$, $\tfrac1{10}a$, $\tfrac3{10}a$,
$\tfrac6{10}a$. If the axis were fixed, the line would be straight for every body (grey, $\tfrac6{10}a$).
Between cheeks the speed is lost sooner than the height is gained.
:::

## Checks

The judge follows the equation of motion down from rest, without the integral; heights are summed from
$r\,d\varphi\sin\varphi$.
*/

exact::Laurent<Fifty> radius_on(int which, const Fifty& ratio)
{
  return which == 0 ? exact::Laurent<Fifty>(1) : truncated(which - 1, ratio);
}

CHECK_THAT("the heights told, of the rise and of the speeds, are those of the motion from rest on all "
           "kinds of cheeks")
{
  for(const Told& now :
      told_at("", "cheeks=3 k=0.3 phi0=45 phi=40", "cheeks=2 a=1e50 k=2e49 phi0=1e-3 phi=1e-4",
              "cheeks=0 phi0=89 phi=30 k=2", "k=1e-6 a=3 phi0=80 phi=79", "phi0=89 phi=88 k=0.02"))
  {
    const Fifty A = a.fifty(), ratio = k.fifty() / A, kk = ratio * ratio, x = phi.fifty(),
                most = phi0.fifty();
    const auto radius = radius_on(cheeks, ratio), height = integral(radius);
    const Fifty r = radius(cos(x)), w = turning2_by_motion(radius, ratio, most, x),
                w0 = turning2_by_motion(radius, ratio, most, 0);
    const char* const why = "the library's bound, and the angle's rounding near the end";
    CHECK(now.value("c", metres)
          == within_relative(A * (height(Fifty(1)) - height(cos(most))), 5e-14, why));
    CHECK(now.value("to_rise", metres)
          == within_relative(A * (height(cos(x)) - height(cos(most))), 5e-14, why));
    CHECK(now.value("v", metres) == within_relative(A * r * r * w, 5e-14, why));
    CHECK(now.value("b", metres) == within_relative(A * w0, 5e-14, why));
    CHECK(now.value("MG_to_MH")
          == within_relative(r * r * w / (height(cos(x)) - height(cos(most))), 5e-14, why));
    CHECK(now.value("AC_to_AD")
          == within_relative(w0 / (height(Fifty(1)) - height(cos(most))), 5e-14, why));
    CHECK(now.value("AC_to_AD") == within_relative(1 / (1 + kk), 1e-15, "a few roundings"));
  }
  for(const Told& now : told_at("phi0=30 phi=29.9999999999", "cheeks=3 phi0=45 phi=44.999999999999",
                                "cheeks=0 phi=69.9999999"))
  {
    const Fifty ratio = k.fifty(), x = phi.fifty();
    const auto radius = radius_on(cheeks, ratio), height = integral(radius);
    const Fifty rise = height(cos(x)) - height(cos(phi0.fifty())), rr = pow(radius(cos(x)), 2);
    CHECK(now.value("to_rise", metres) == within_relative(rise, 1e-14, "the angles as written"));
    CHECK(now.value("v", metres) == within_relative(rr * rise / (rr + ratio * ratio), 1e-14, "the same"));
  }
}

CHECK_THAT(
    "it refuses an angle beyond the swing, a swing that winds up the thread to its end, and an extreme k")
{
  for(const char* const within_them : {"phi0=60 phi=60", "phi0=30 phi=30"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"phi0=60 phi=60.00000000000000001", "phi0=30 phi=30.00000000000000001"})
    CHECK(refused_at(beyond));
  for(const char* const within_them : ratio_within)
    CHECK(!refused_at(within_them));
  for(const char* const beyond : ratio_beyond)
    CHECK(refused_at(beyond));
  // with one correction r is zero where cos⁴φ = κ : (1 + κ), with both at 60° for 1152κκ + 15κ = 1
  for(const std::string body : {"cheeks=2 k=0.258198889747161126", "cheeks=2 a=2 k=0.516397779494322251",
                                "cheeks=3 k=0.153828149399070924", "cheeks=3 a=2 k=0.307656298798141847"})
  {
    CHECK(!refused_at(body + " phi=1 phi0=59.9999999999"));
    CHECK(refused_at(body + " phi=1 phi0=60.0000000001"));
  }
}

CHECK_THAT(
    "sin φ is dx : Gg, by the places of G on Huygens's cheeks, and the sum of Gg sin φ is the height")
{
  const Fifty h("1e-15");
  const auto place = [](const Fifty& at) {  // beside A, and below it
    const Fifty s = sin(at), c = cos(at);
    return std::pair{(at - s * c) / 2 + c * s, s * s / 2 + c * c};
  };
  for(const char* at_ : {"0.1", "0.7", "1.5"})
  {
    const Fifty x(at_);
    const auto after = place(x + h), before = place(x - h);
    const Fifty dx = before.second - after.second, Gg = hypot(after.first - before.first, dx);
    CHECK(dx / Gg == within_relative(sin(x), 1e-28, "the square of the step"));
    CHECK(1 - place(x).second == within(pow(sin(x), 2) / 2, 1e-48, "the height above C"));
  }
}

CHECK_THAT(
    "the figure's curves are those of the motion; the line for k = 0 and the fixed axis's are straight")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("speeds", 6))
    {
      const Fifty most = 80 * exact::pi() / 180, c = pow(sin(most), 2) / 2, x = Fifty(point.at("x")) * c;
      const Fifty rr = 1 - 2 * x;
      CHECK(point.value("x") == between(0, 1, "from the lowest place to the end"));
      CHECK(point.value("k0") == within(1 - Fifty(point.at("x")), 1e-15, "a straight line"));
      CHECK(point.value("axis")
            == within((1 - Fifty(point.at("x"))) / Fifty("1.36"), 1e-15, "a straight line"));
      for(const auto& [name, ratio] : {std::pair{"k1", "0.1"}, {"k3", "0.3"}, {"k6", "0.6"}})
      {
        const Fifty angle_ = asin(sqrt(2 * x)),
                    w = x < c * Fifty("0.999") ? turning2_by_motion(Fifty(ratio), most, angle_) : Fifty(0);
        CHECK(point.value(name) == within(rr * w / c, 1e-14, "the angle's rounding"));
      }
    }
}

/*!
Our copy has no bracket about the difference in {{eq 1}}, and in {{eq 4}} it has $CG$, the whole arc, for
$Gg$. The first is tried between cycloids, $a = 1$, $k = \tfrac1{10}$, at 10° of a swing of 20°; the
second on the same curve, with an element from 9.99° to 10.01°.
*/

double v_with(bool bracket)
{
  const double rr = std::pow(std::cos(10_deg), 2), c = std::pow(std::sin(20_deg), 2) / 2,
               x = std::pow(std::sin(10_deg), 2) / 2;
  return bracket ? rr * (c - x) / (0.01 + rr) : rr * c - x / (0.01 + rr);
}

const Emendation lost_bracket{
    "§18, v",
    {"(a−s)²c − ∫(a−s)dφ sin φ over kk + (a−s)²", [] { return v_with(false); }},
    {"(a−s)²(c − ∫(a−s)dφ sin φ) over kk + (a−s)²", [] { return v_with(true); }},
    "it follows from the integral of §17; the last formula of the section has the bracket",
    [](double v) {
      const Fifty ten = exact::pi() / 18;
      return v
             == within_relative(pow(cos(ten), 2) * turning2_by_motion(Fifty("0.1"), 2 * ten, ten), 1e-14,
                                "a few roundings");
    }};

double sine_by(bool element)  // dx over the element, or over the whole arc
{
  const double dx = (std::pow(std::sin(10.01_deg), 2) - std::pow(std::sin(9.99_deg), 2)) / 2;
  return dx / (element ? std::sin(10.01_deg) - std::sin(9.99_deg) : std::sin(10_deg));
}

const Emendation lost_g{
    "§18, sin φ",
    {"dx : CG", [] { return sine_by(false); }},
    {"dx : Gg", [] { return sine_by(true); }},
    "Gg is the element (a−s)dφ of the arc, as the same line has it",
    [](double sine) {
      return sine == within_relative(sin(exact::pi() / 18), 1e-7, "the square of the element's angle");
    }};

/*!
## Notes

In one more place our copy has an *f* where a sign of an integral stood; the sentence itself corrects it.

On a tautochrone the height due to the speed is known without the radius of curvature: by the equation of
{{sec tautochrone.25}} $rr:(kk+rr)$ is $2x:f\sin^2\varphi$, $f = a + kk:a$, hence

$$ v = \frac{2x\,(c-x)}{f\sin^2\varphi}. \tag{A} $$
*/

CHECK_THAT("on the highest tautochrone, whose radius comes from its slope, v is 2x(c − x) over f sin²φ")
{
  for(const char* ratio : {"0.1", "0.3", "0.7"})
  {
    const Fifty K(ratio), last = highest_end(K).phi, x = last / 2, r = highest(K, x);
    // The height, as the sum of r dφ sin φ, by Simpson's rule on 40 strips.
    std::vector<Fifty> angles;
    for(int i = 1; i <= 40; ++i)
      angles.push_back(x * i / 40);
    const auto radii = highest(K, angles);
    Fifty sum = 0;
    for(int i = 1; i <= 40; ++i)
      sum += (i == 40      ? 1
              : i % 2 == 1 ? 4
                           : 2)
             * radii[static_cast<std::size_t>(i - 1)] * sin(angles[static_cast<std::size_t>(i - 1)]);
    const Fifty height = sum * x / 120;
    CHECK(r * r / (K * K + r * r)
          == within_relative(2 * height / ((1 + K * K) * pow(sin(x), 2)), 1e-5, "Simpson's rule"));
  }
}

/*!
## Go on from here

::: exercise
A body passes the lowest place with the speed that is due to the height $b$. Does it depend on the cheeks how
high it rises?

answer: No: {{eq 3}} knows nothing of them, the height is $c = b\cdot AD : AC$ on an axis, between cycloids
and between Euler's cheeks (`--cheeks 0` to `--cheeks 3`). The *angle* to which it swings does depend on them,
and the time.
:::
*/

CHECK_THAT(
    "on an axis and between all cheeks the height of the rise is that of the first speed times AD : AC")
{
  for(const Told& now : told_at("cheeks=0", "cheeks=1", "cheeks=2", "cheeks=3", "cheeks=2 k=0.2 phi0=30"))
  {
    const Fifty kk = pow(k.fifty() / a.fifty(), 2);
    const auto radius = radius_on(cheeks, k.fifty() / a.fifty()), height = integral(radius);
    const Fifty c = a.fifty() * (height(Fifty(1)) - height(cos(phi0.fifty())));
    CHECK(now.value("c", metres) == within_relative(c, 5e-14, "the library's bound"));
    CHECK(now.value("b", metres) == within_relative(c / (1 + kk), 5e-14, "the same"));
  }
}
