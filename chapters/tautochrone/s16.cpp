#include "edition/section.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

SECTION(tautochrone, 16, "The force that does what gravity does")

using namespace tautochrone;

/*!
## What Euler does

The force $P$ in $Z$ is now chosen so that it does the same as gravity; then the motion that it causes is
the one that gravity causes on a thread. The gravity of the body is its weight $M$, which pulls straight
down in the centre of gravity $G$; let the vertical line $GV$ represent it. Nothing more is needed than
that the moment of $P$ about the place of suspension $M$ be equal to the moment of gravity about it. The
angle between $GV$ and the line $MG$ produced is $\varphi$, and so

$$ \begin{gathered} M\cdot MG\cdot\sin\varphi = P\cdot MZ \quad\text{or} \\
  P = \frac{M(a-s)\sin\varphi}{a-s+b}. \end{gathered} \tag{1} $$

With the value that was found for $b = GZ$ in {{sec tautochrone.15}} the arm is

$$ \begin{aligned} a&-s+b \\
  &= \frac{(a-s)^2dd\varphi - (a-s)\,ds\,d\varphi + kk\,dd\varphi}{(a-s)\,dd\varphi - ds\,d\varphi},
  \end{aligned} \tag{2} $$

and therefore

$$ P = \frac{M\bigl((a-s)^2dd\varphi - (a-s)\,ds\,d\varphi\bigr)\sin\varphi}
            {(a-s)^2dd\varphi - (a-s)\,ds\,d\varphi + kk\,dd\varphi}, \tag{3} $$

$$ Pb = \frac{Mkk(a-s)\,dd\varphi\sin\varphi}
             {(a-s)^2dd\varphi - (a-s)\,ds\,d\varphi + kk\,dd\varphi}. \tag{4} $$

::: margin
Here $M$ is the mass, the weight, and a point. Only with the mass as its own weight may a force be
written $M$.
:::

May moments be taken about a point that moves? About this one they may: as a part of the body $M$ is at
rest, and what holds it there has no arm. That something does hold it, {{eq 1}} says itself. Of the
weight's part across the thread, $M\sin\varphi$, no more than $P$ is seen in the motion of $G$. The rest
is borne at $M$,

$$ R = M\sin\varphi - P = P\cdot\frac{GZ}{MG}, \tag{A} $$

and the weight's part is shared between $Z$ and $M$ as a load on a lever between its two supports. $R$
points outwards, towards the cheek. A cheek can push a thread away but not draw it to itself, so that it
is the stiffness of the straight part, or of the strip where it leaves the cheek, that must supply $R$
({{sec tautochrone.08}}).

## The program

The two accelerations in {{eq 3}} and {{eq 4}} are not known yet; the equation that they obey is found
from {{eq 4}} in {{sec tautochrone.17}}. The program anticipates it: {{api tautochrone::force}} has $P$
for a swing that began at rest at the angle $\varphi_0$, and so has no quotient of two numbers that
vanish together in the lowest place. The cheeks: 0 for a fixed axis, 1 for cycloids, 2 and 3 for Euler's.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.3, metres, scale, "radius of gyration");
const auto cheeks = integer("cheeks", 1, 0, 3, "0 none, 1 cycloids, 2 Euler's with k², 3 with k⁴");
const auto phi0 = asked_swing(60_deg, cheeks, k, a);
const auto phi = angle("phi", within_swing(50_deg, phi0), closed(0_deg, 89_deg),
                       "angle of the free part with the vertical");

double moment(Cheeks which, double ratio)  // Pb, (4), over the weight and a
{
  return force(on_cheeks<double>(which, ratio, phi0, phi), ratio)
         * GZ_on_cheeks<double>(which, ratio, phi0, phi);
}

double pressure(const Posture<double>& at,
                double ratio)  // of the thread on the cheek at M, for each length a
{
  return tension(at, ratio) / (at.shortening * at.sin);
}

TELL
{
  const double ratio = k / a;
  const auto which = static_cast<Cheeks>(int(cheeks));
  const auto at = asked_posture(which, ratio, phi0, phi);
  tell("across", at.sin, "M sin φ, the weight's part across the thread, over the weight");
  tell("P", force(at, ratio), "that of it which moves G, (3), over the weight");
  tell("R", moment(which, ratio) / at.r, "and that which is borne at M, (A), over the weight");
  tell("Pb", a * moment(which, ratio), metres, "the moment of P about G, (4), over the weight");
  tell("tension", tension(at, ratio), "the pull along the thread, over the weight");
  if(phi > 0 && which != Cheeks::none)
    tell("pressure", pressure(at, ratio) / a, Unit{"1/m"},
         "of the thread on the cheek where they part, in weights a metre");
}

TELL
{
  curve("parts", {"phi", "cycloid", "axis", "end"}, [](Curve& out) {
    for(int i = 0; i <= 80; ++i)
    {
      const double here = 80_deg * i / 80, ratio = k / a;
      const auto at_end = on_cycloids<double>(here, here);
      const auto part = [=](const Posture<double>& at) {  // P : M sin φ, also in the lowest place
        const double kk = ratio * ratio, turning = 2 * at.shortening * turning2(at, ratio);
        return 1 - kk * (1 - turning) / (kk + at.r * at.r);
      };
      out.put({double(i), part(on_cycloids<double>(80_deg, here)), part(on_circle<double>(80_deg, here)),
               part(at_end)});
    }
  });
}

/*!
At {{phi|deg0}} of a swing to {{phi0|deg0}} the weight's part across is {{across|4}} of the weight;
{{P|4}} of it moves the centre of gravity, and {{R|4}} is borne at $M$.

::: figure tautochrone-16
alt: The part of the weight across the thread that moves G, against the angle of the thread. For a fixed
axis it is a level line at about nine tenths. In a swing to 80 degrees between cycloids it begins near
one, higher than that line, and falls steeply before 80 degrees, where it meets a lower curve, which has
the same part for swings that end at each angle.

$P : M\sin\varphi$, which is $MG : MZ$, for $k = \tfrac3{10}a$. On a fixed axis it stays the same.
Between cycloids, in a swing to 80° (blue), the motion of the thread keeps it high for most of the way;
at the end of a swing (dashed, for swings of every width) all depends on how short the thread has become.
:::

## Checks

The judge is the motion of two weights under d'Alembert's principle, with the speed that the body has gained
from rest ({{sec tautochrone.14}}): what moves $G$ is the acceleration of $G$.
*/

exact::Laurent<Fifty> radius_on(int which, const Fifty& ratio)
{
  return which == 0 ? exact::Laurent<Fifty>(1) : truncated(which - 1, ratio);
}

Accelerations judged(int which, const Fifty& ratio, const Fifty& most, const Fifty& x)
{
  const auto r = radius_on(which, ratio);
  return accelerations(r, ratio, turning2_by_motion(r, ratio, most, x), x);
}

CHECK_THAT("P, its moment and what is borne at M are those that the accelerations of the body demand")
{
  for(const Told& now :
      told_at("", "cheeks=3 k=0.3 phi0=45 phi=40", "cheeks=2 a=1e50 k=2e49 phi0=1e-3 phi=1e-4",
              "cheeks=0 phi0=89 phi=30 k=2", "k=1e-6 a=3 phi0=80 phi=79", "phi0=89 phi=88.9 k=0.02",
              "k=0.01 phi0=89 phi=60", "k=1e-9 phi0=89 phi=30"))  // in these Z is near to G
  {
    const Fifty ratio = k.fifty() / a.fifty(), kk = ratio * ratio, x = phi.fifty(), s = sin(x);
    const auto radius = radius_on(cheeks, ratio);
    const Fifty r = radius(cos(x)), bent = s * derivative(radius)(cos(x));  // ds/dφ
    const Accelerations of = judged(cheeks, ratio, phi0.fifty(), x);
    const char* const why = "the library's bound, and the angle's rounding near the end";
    CHECK(now.value("across") == within_relative(s, 1e-15, "a sine"));
    CHECK(now.value("P") == within_relative(-of.across, 5e-14, why));
    CHECK(now.value("R") == within(s + of.across, 5e-14 * double(s), "what is left of the weight across"));
    const Fifty moment_ = -kk * of.turning, of_itself = cheeks == 1 ? moment_ : Fifty(r * s);
    CHECK(now.value("R")
          == within(moment_ / r, 5e-14 * double(of_itself / r), "the moment that turns the body"));
    CHECK(now.value("Pb", metres)
          == within(a.fifty() * moment_, 5e-14 * double(a.fifty() * of_itself), why));
    CHECK(now.value("tension") == within_relative(cos(x) + of.along, 5e-14, why));
    if(cheeks != 0)
      CHECK(now.value("pressure", Unit{"1/m"})
            == within_relative((cos(x) + of.along) / (a.fifty() * bent), 5e-14, why));
  }
}

/*!
Euler's four formulae hold as they stand, with the accelerations of the two weights put in for
$dd\varphi$ and the speed for $ds\,d\varphi$.
*/

CHECK_THAT("(1) to (4), with dd φ and ds dφ as the motion has them, give one and the same force and moment")
{
  const Fifty ratio("0.2"), kk = ratio * ratio, most("0.9");
  for(const int which : {1, 2, 3})
    for(const char* at_ : {"1e-9", "0.4", "0.899"})
    {
      const Fifty x(at_), s = sin(x), c = cos(x);
      const auto radius = radius_on(which, ratio);
      const Fifty r = radius(c), w = turning2_by_motion(radius, ratio, most, x);
      const Accelerations of = accelerations(radius, ratio, w, x);
      const Fifty dd = of.turning / 2, ds = s * derivative(radius)(c) * w;  // over dt²
      const Fifty b = kk * dd / (r * dd - ds), below = r * r * dd - r * ds + kk * dd;
      const char* const why = "the motion's 25 digits";
      CHECK(r + b == within_relative(below / (r * dd - ds), 1e-20, "(2)"));
      CHECK(r * s / (r + b) == within_relative(-of.across, 1e-18, why));
      CHECK((r * r * dd - r * ds) * s / below == within_relative(-of.across, 1e-18, why));
      CHECK(kk * r * dd * s / below == within_relative(-kk * of.turning, 1e-18, why));
      CHECK(s + of.across == between(0, s, "R is positive: it points outwards"));
    }
}

CHECK_THAT("the pressure on the cheek grows beyond bounds near the cusp, as the inverse of the angle")
{
  for(const Told& now :
      told_at("phi=1e-9rad", "phi=1e-60rad cheeks=3 k=0.1", "phi=1e-9rad a=1e-20 k=1e-21"))
  {
    const Fifty ratio = k.fifty() / a.fifty(), kk = ratio * ratio;
    const Fifty bend = cheeks == 1 ? Fifty(1) : 1 + 4 * kk + 12 * kk * kk;  // ds/φ dφ at A
    const Fifty lowest = turning2_by_motion(radius_on(cheeks, ratio), ratio, phi0.fifty(), 0);
    CHECK(now.value("pressure", Unit{"1/m"})
          == within_relative((1 + 2 * lowest) / (a.fifty() * bend * phi.fifty()), 1e-13,
                             "φ is nothing here"));
  }
}

CHECK_THAT("for a fixed axis what is borne is kk sin φ/(aa + kk), however the body swings")
{
  for(const Told& now : told_at("cheeks=0", "cheeks=0 k=2 a=5 phi=3", "cheeks=0 k=1e-4 phi0=5 phi=5"))
  {
    const Fifty kk = pow(k.fifty() / a.fifty(), 2);
    CHECK(now.value("R") == within_relative(kk * sin(phi.fifty()) / (1 + kk), 4e-15, "a few roundings"));
  }
}

CHECK_THAT(
    "in the figure the parts are the motion's, at each end of a swing cc/(kk + cc), and level for the axis")
{
  for(const Told& now : told_at("", "k=0.1", "k=2"))
  {
    const Fifty K = k.fifty() / a.fifty(), kk = K * K, most = 80 * exact::pi() / 180;
    for(const auto& point : now.points("parts", 6))
    {
      const Fifty at_ = point.at("phi"), x = (at_ > 0 ? at_ : Fifty("1e-9")) * exact::pi() / 180,
                  cc = pow(cos(x), 2);
      const char* const why = "the angle's rounding";
      CHECK(point.value("phi") == between(0, 80, "the swing"));
      CHECK(point.value("end") == within(cc / (kk + cc), 1e-14, why));
      CHECK(point.value("axis") == within(1 / (1 + kk), 1e-15, "a few roundings"));
      const Fifty part = x < most ? -judged(1, K, most, x).across / sin(x) : cc / (kk + cc);
      CHECK(point.value("cycloid") == within(part, 2e-14, why));
    }
  }
}

CHECK_THAT("a k beyond its limits is refused, a swing beyond the end of Euler's cheeks, and an angle "
           "beyond the swing, and just within they are not")
{
  for(const char* const within_them : ratio_within)
    CHECK(!refused_at(within_them));
  for(const char* const beyond : ratio_beyond)
    CHECK(refused_at(beyond));
  for(const char* const within_them : posture_within)
    CHECK(!refused_at(within_them));
  for(const char* const beyond : posture_beyond)
    CHECK(refused_at(beyond));
}

/*!
## Notes

The pressure on the cheek has no part in the motion, since nothing moves in its direction. It grows
beyond every bound where the thread lies at the cusp in $A$: there the cheek is bent most sharply,
$ds/d\varphi = 0$.

## Go on from here

::: exercise
Between cycloids, is there a place of the swing, besides the lowest, at which nothing is borne at $M$?

answer: No. There $dd\varphi$ would have to be zero. With $c = \cos\varphi$ and $\kappa
= kk:aa$ the turning is retarded in proportion to $\sin\varphi\,c\,(\kappa + c_0^2):(\kappa + c^2)^2$, in
which every factor is positive; the check below compares it.
:::
*/

CHECK_THAT(
    "between cycloids ddφ is proportional to −sin φ c(κ + c₀²)/(κ + c²)² and has one sign in the rise")
{
  for(const char* ratio : {"0.001", "0.3", "2"})
    for(const char* at_ : {"0.01", "0.7", "1.3"})
    {
      const Fifty K(ratio), x(at_), most("1.4"), cc = pow(cos(x), 2), below = K * K + cc;
      CHECK(judged(1, K, most, x).turning
            == within_relative(-sin(x) * cos(x) * (K * K + pow(cos(most), 2)) / (below * below), 1e-22,
                               "the motion's 25 digits"));
    }
}
