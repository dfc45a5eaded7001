#include "edition/section.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/swing.hpp"

SECTION(tautochrone, 12, "The letters, and k from an experiment")

using namespace tautochrone;

/*!
## What Euler does

The mass of the flexible part $AM$ is rejected as very small, and the pendulum is put into letters. In truth
that part *is* very small, unless the swings become quite wide. Let $M$ be the mass of the rest of the
pendulum, $G$ its centre of gravity, and $Mkk$ its moment of inertia with respect to the horizontal axis
through $G$.

This quantity $kk$ can be determined from the free oscillatory motion. One takes the cheek away and sets the
pendulum to very small swings: if one finds that its centre of oscillation is then in $D$, so that $AD$ is the
length of the isochronous simple pendulum, and if $C$ is the centre of gravity of the body,

$$ kk = AC\cdot CD. \tag{1} $$

To describe the present place of the pendulum, where its centre of gravity is in $G$, put

$$ AM = s, \qquad AMG = AC = a; \tag{2} $$

$a$, the length of the whole pendulum, is constant. Then

$$ MG = a - s, \tag{3} $$

which is at the same time the radius of curvature of the curve $CG$ in the point $G$. Finally a vertical $MS$
is drawn through $M$, and the angle by which the pendulum declines is called

$$ SMG = \varphi. \tag{4} $$

::: margin
The letters are those of the figure in {{sec tautochrone.08}}. $s$, and with it $a - s = r$, is a function of
$\varphi$ as soon as the cheek is given.
:::

{{eq 1}} is exact, and in practice a trap. What an experiment gives is the time $T$ of a swing, and with it
$f = AD$, which is greater than $a$ by very little: $f - a = kk/a$. If $T$ errs by the part $\varepsilon$, and
swings that are not infinitely small last too long ({{sec tautochrone.01}}), then $k$ errs by the part

$$ \frac{\delta k}{k} = \frac{aa + kk}{kk}\left(\varepsilon + \frac{\varphi_0^2}{16}\right)
   \text{ nearly}. \tag{A} $$

For $k = \tfrac1{10}a$ that is a hundredfold. So the difference must be measured itself. Let a simple pendulum
of the length $a$ swing beside the body, and let $\delta$ be the part by which the body's swing is longer,
counted as a gain of whole swings in a long time. Then

$$ k = a\sqrt{\delta\,(2 + \delta)}. \tag{B} $$

## The program

From the length $a$ and a true $k$ the program makes what the experiment would give, and calculates $k$
from that again in the two ways.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "the true radius of gyration");
const auto error =
    real("error", 1e-6, none, closed(-1e-2, 1e-2), "ε, by what part the time is taken too long");
const auto phi0 =
    angle("phi0", 1_deg, closed(1e-60_deg, 20_deg), "how wide the swings of the experiment are");
const auto phi =
    angle("phi", 20_deg, closed(0_deg, 89_deg), "SMG, of the pendulum between Huygens's cheeks");  // (4)

double wound()  // (2), s on Huygens's cheek
{
  return euler_s<double>(a, 0, phi);
}

double MG()  // (3), which there is a cos φ
{
  return a * std::cos(phi);
}

double CD_for(double k_)  // (1)
{
  return k_ / a * k_;
}

double k_by_lengths(double f)  // (1), CD by subtraction
{
  return std::sqrt(a) * std::sqrt(std::max(f - a, 0.0));
}

double k_by_gain(double delta)  // (B)
{
  return a * std::sqrt(delta) * std::sqrt(2 + delta);
}

double gain(double k_)  // δ of the body with this k, √(1 + kk/aa) − 1
{
  const double ratio = k_ / a;
  return ratio * ratio / (1 + std::hypot(1, ratio));
}

double amiss(double eps, double width)  // (A)
{
  const double inverse = a / k;
  return (1 + inverse * inverse) * (eps + width * width / 16);
}

double gain_found(double eps, double width)  // the δ of a time that is too long by ε and by the width
{
  const double longer = eps + (1 + eps) * excess(Cheeks::none, 0, width), delta = gain(k);
  return delta + longer * (1 + delta);
}

TELL
{
  require(k / a >= 1e-70, "k", "from 1e-70 a to 1e70 a");
  require(k / a <= 1e70, "k", "from 1e-70 a to 1e70 a");
  require(gain_found(error, phi0) > 0, "error",
          "so small that the time is longer than a simple pendulum's");
  tell("CD", CD_for(k), metres, "from the centre of gravity to that of oscillation");
  tell("delta", gain(k), "δ, by what part its swing is longer than that of a simple pendulum");
  tell("by_gain", k_by_gain(gain(k)), metres, "k from δ, (B)");
  tell("by_lengths", k_by_lengths(a + CD_for(k)), metres, "k from AD as a double and a, (1)");
  tell("found", k_by_gain(gain_found(error, phi0)), metres,
       "k from a time with this error and swings so wide");
  tell("amiss", amiss(error, phi0), percent, "by how much that is too great, where it is little, (A)");
  tell("amiss_width", amiss(0, phi0), percent, "of this because the swings are not infinitely small");
  tell("s", wound(), metres, "AM, (2), between Huygens's cheeks");
  tell("MG", MG(), metres, "the rest, (3)");
}

TELL
{
  curve("errors", {"k", "time", "width", "double"}, [](Curve& out) {
    for(double ratio = 0.001; ratio < 1.01; ratio *= std::pow(10, 1.0 / 12))
    {
      const double greater = 1 + 1 / (ratio * ratio);
      out.put({ratio, greater * 1e-6, greater * 1_deg * 1_deg / 16,
               greater * 0x1p-54});  // as the time is the root of AD
    }
  });
}

/*!
With swings of one degree and a time that is right to a millionth, {{eq 1}} yields for $k = \tfrac1{10}a$ not
{{by_gain|3}} m but {{found|6}} m, too much by {{amiss|2}}; of that {{amiss_width|2}} comes from the width of
the swings, though they are "very small".

::: figure tautochrone-12
alt: The relative error of k against k over a, both logarithmic. Three parallel straight lines fall with the
slope minus two: uppermost that of swings of one degree, then that of a time wrong by a millionth, far below
that of rounding to a double. The two upper ones cross the level of one near k of four and one thousandths of
a.

By what part $k$ comes out wrong from {{eq 1}}, if the swings of the experiment are 1° wide, if the time is
wrong by a millionth (a twelfth of a second in a day), and if only $AD$ is rounded to sixteen digits. Above
the level of one nothing of $k$ is left.
:::

## Checks

The experiment is made again in fifty digits, from its time; the width of the swing enters by the series for
the circle.
*/

Fifty k_of_time(const Fifty& T)  // (1), Euler's clock: T = π√(2f)
{
  const Fifty f = T * T / (2 * pow(exact::pi(), 2));
  return sqrt(a.fifty() * (f - a.fifty()));
}

CHECK_THAT(
    "k comes back from its experiment, and with an error in time and width as wrong as the program says")
{
  for(const Told& now : told_at("", "k=1e-3 error=1e-4 phi0=5", "k=0.3 a=2 error=-1e-3 phi0=20",
                                "a=1e40 k=5e40 error=0 phi0=1e-8"))
  {
    const Fifty k_ = k.fifty(), a_ = a.fifty(), T = exact::pi() * sqrt(2 * (a_ + k_ * k_ / a_));
    const Fifty T_found = T * (1 + error.fifty()) * (1 + circle_excess(phi0.fifty()));
    const char* const why = "at most ten roundings";
    CHECK(now.value("CD", metres) == within_relative(k_ * k_ / a_, 1e-15, why));
    CHECK(now.value("delta") == within_relative(T / (exact::pi() * sqrt(2 * a_)) - 1, 2e-15, why));
    CHECK(k_of_time(T) == within_relative(k_, 1e-40, "(1)"));
    CHECK(now.value("by_gain", metres) == within_relative(k_, 2e-15, why));
    CHECK(now.value("found", metres) == within_relative(k_of_time(T_found), 1e-13, "the library's bound"));
  }
}

CHECK_THAT("what is lost is nearly (A), where it is small")
{
  for(const Told& now :
      told_at("", "error=1e-9 phi0=0.01", "k=3 a=2 error=-1e-4 phi0=2", "k=1e-6 error=1e-20 phi0=1e-9"))
  {
    const Fifty k_ = k.fifty(), a_ = a.fifty(), T = exact::pi() * sqrt(2 * (a_ + k_ * k_ / a_));
    const Fifty width = circle_excess(phi0.fifty()), eps = error.fifty();
    const Fifty both = k_of_time(T * (1 + eps) * (1 + width)) / k_ - 1,
                one = k_of_time(T * (1 + width)) / k_ - 1;
    const double next = 2e-13 + 3 * std::abs(double(both)) + 3 * std::abs(double(one))
                        + double(phi0.fifty() * phi0.fifty());
    CHECK(now.value("amiss", percent) == within_relative(both, next, "the second order"));
    CHECK(now.value("amiss_width", percent) == within_relative(one, next, "the second order"));
  }
}

CHECK_THAT("with AD as a double k errs by no more than that rounding explains")
{
  for(const Told& now : told_at("", "k=1e-6", "k=1e-12", "a=3 k=20"))
  {
    const double f = a + CD_for(k),
                 lost = a * (f * 3.4e-16);  // half an ulp of AD, CD's, and the difference's
    CHECK(now.value("by_lengths", metres)
          == within(k.fifty(), std::min(lost / k, std::sqrt(lost)) + 1e-15 * k, "as stated"));
  }
  for(const Told& now : told_at("k=1e-12"))
    CHECK(now.value("by_lengths", metres) == 0);
}

CHECK_THAT("s and MG make up the whole pendulum, which is the involute's: s is a cycloid's arc")
{
  for(const Told& now : told_at("", "phi=89 a=1e50 k=1e49", "phi=1e-6 a=0.5", "phi=45"))
  {
    const Fifty wound = a.fifty() * 2 * pow(sin(phi.fifty() / 2), 2);
    CHECK(now.value("s", metres) == within_relative(wound, 2e-15, "the library's bound"));
    CHECK(now.value("MG", metres)
          == within_relative(a.fifty() - wound, 2e-14, "the angle's rounding near 90°"));
  }
}

CHECK_THAT(
    "the figure's lines are (A), and half an ulp of AD; a millionth of a day is a twelfth of a second")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("errors", 5))
    {
      const Fifty kk = pow(Fifty(point.at("k")), 2), degree = exact::pi() / 180;
      CHECK(point.value("time") == within_relative((1 + kk) / kk / 1'000'000, 2e-15, "five roundings"));
      CHECK(point.value("width")
            == within_relative((1 + kk) / kk * degree * degree / 16, 3e-15, "eight roundings"));
      CHECK(point.value("double") == within_relative((1 + kk) / kk * ldexp(Fifty(1), -54), 2e-15, "five"));
    }
  CHECK(Fifty("0.0864") == within(Fifty(1) / 12, 5e-3, "86400 s by a million"));
}

CHECK_THAT("a k beyond its limits is refused, and an error that makes the time as short as a simple "
           "pendulum's, and just within they are not")
{
  for(const char* const within_them :
      {"k=1e-70", "a=2 k=2e-70", "k=1e70", "a=2 k=2e70", "k=0.1 phi0=1 error=-0.00498175386",
       "a=2 k=0.1 phi0=20 error=-0.00884882504"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"k=9.999999999999997e-71", "a=2 k=1.9999999999999994e-70", "k=1.0000000000000004e70",
       "a=2 k=2.0000000000000008e70", "k=0.1 phi0=1 error=-0.00498175387",
       "a=2 k=0.1 phi0=20 error=-0.00884882505"})
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
How narrow must the swings be, that their width spoils the $k$ of $\tfrac1{10}a$ by no more than a thousandth?

answer: By {{eq A}} $\varphi_0^2/16 = 0.001/101$, so that $\varphi_0$ is 0.72°: `--phi0 0.72 --error 0` says
that it is then wrong by nearly a thousandth.
:::
*/

CHECK_THAT("swings of 0.72° spoil k by nearly a thousandth")
{
  for(const Told& now : told_at("phi0=0.72 error=0"))
    CHECK(now.value("amiss", percent) == between(0.00099, 0.001, "the exercise"));
}
