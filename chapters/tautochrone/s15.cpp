#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

SECTION(tautochrone, 15, "The place Z where the force must act")

using namespace tautochrone;

/*!
## What Euler does

The suspension ties the turning of the body to the advance of its centre of gravity, and that fixes the
point $Z$ in which a force must act to change both as the tie demands. If the body were free and as ready
for one motion as for any other, the two changes found in {{sec tautochrone.14}} would each go its own
way. But on the thread the turning always keeps a given proportion to the advance, and the two equations
show at once where $P$ has to be applied. Divided one by the other they give

$$ dd\varphi : d\bigl((a-s)\,d\varphi\bigr){{entry lost_bracket}} = b : kk, \tag{1} $$

$$ b = \frac{kk\,dd\varphi}{d{{entry a_for_d}}\bigl((a-s)\,d\varphi\bigr)}
     = \frac{kk\,dd\varphi}{(a-s)\,dd\varphi - ds\,d\varphi}. \tag{2} $$

From this it is plain that $Z$ is not the centre of oscillation $H$ which belongs to the suspension in
$M$. For that one it is

$$ GH = \frac{kk}{a-s}, \tag{3} $$

to which $b = GZ$ would be equal if $ds$ were zero, that is, if the point of suspension $M$ did not
change. It is because this point changes, he ends, that the interval $GZ$ is greater{{entry greater}}
than $GH$.

::: margin
$b = k^2\ddot\varphi/(r\ddot\varphi + \dot r\dot\varphi)$: the two accelerations of a body that rolls
along its cheek.
:::

It is smaller. In {{eq 2}} the product $ds\,d\varphi$ is positive whenever the thread winds itself up,
and also when it comes off again, since both factors change sign; but $dd\varphi$ is negative, because
the body is retarded in its rise and hastened in its fall. What is taken away from a negative number
makes it larger in size, and the quotient smaller. With {{eq 2}} and the first equation of
{{sec tautochrone.14}},

$$ GZ = GH\Bigl(1 - \frac{2M\,ds\,d\varphi}{P\,dt^2}\Bigr), \tag{A} $$

and all in the fraction is positive. Only at the turning point, where the thread stands still for an
instant, is $Z$ in $H$. Euler makes no use of the remark, and the equation of motion that he derives from
{{eq 2}} is right.

## The program

$GZ$ and $GH$ from the formulae of the motion, for a fixed axis and for three kinds of cheeks: 0 stands
for the axis, 1 for Huygens's cycloids, 2 and 3 for Euler's cheeks with one and with two corrections.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto cheeks = integer("cheeks", 1, 0, 3, "0 none, 1 cycloids, 2 Euler's with k², 3 with k⁴");
const auto phi0 =
    angle("phi0", 20_deg, closed(1e-7_deg, 89_deg), "how far the pendulum swings to either side");
const auto phi = angle("phi", within_swing(10_deg, phi0), closed(0_deg, 89_deg),
                       "angle of the free part with the vertical");

double nearer(const Posture<double>& at, double ratio)  // 1 − GZ/GH, by (A): 2ds dφ/P dt²
{
  const double kk = ratio * ratio, rr = at.r * at.r, turning = 2 * at.shortening * turning2(at, ratio);
  return turning * (kk + rr) / (rr + kk * turning);
}

/*!
How much would it matter to take $H$ for $Z$? The term with $ds$ would be missing from the equation of
motion, and the body would fall as if it had always hung by a thread of its present length. Between
cycloids the speed can then be had in finite terms: with $u = (c^2 - c_0^2):(kk + c_0^2)$, $c =
\cos\varphi$, all in parts of $a$,

$$ \frac{d\varphi^2}{dt^2} = \tfrac12\ln(1+u) \quad\text{instead of}\quad \tfrac12\,\frac u{1+u}. \tag{B} $$

The logarithm is the greater of the two, so the swing would be reckoned too short. By how much is a
quotient of two integrals over the same places, $\varphi = \varphi_0\sin\alpha$, the difference in {{eq
B}} being formed without subtraction.
*/

double log_less_quotient(double u)  // ln(1 + u) − u/(1 + u)
{
  if(u > 0.2)
    return std::log1p(u) - u / (1 + u);
  double sum = 0, power = -u;
  for(int n = 2; n < 30; ++n)
    sum += (n - 1.0) / n * (power *= -u);
  return sum;
}

double reckoned_short(double ratio, double phi0_)  // 1 − T/T by (B), H being taken for Z, between cycloids
{
  constexpr int places = 400;
  const double below = ratio * ratio + std::pow(std::cos(phi0_), 2);
  double time = 0, missing = 0;
  for(int i = 0; i < places; ++i)
  {
    const double alpha = (i + 0.5) * std::numbers::pi / (2 * places),
                 from_top = std::numbers::pi / 2 - alpha;
    const double here = phi0_ * std::sin(alpha), way = 2 * phi0_ * std::pow(std::sin(from_top / 2), 2);
    const double u = std::sin(way) * std::sin(phi0_ + here) / below;
    const double right = std::sqrt(u / (1 + u)), wrong = std::sqrt(std::log1p(u));
    time += std::cos(alpha) / right;
    missing += std::cos(alpha) * log_less_quotient(u) / (right * wrong * (right + wrong));
  }
  return missing / time;
}

TELL
{
  const double ratio = k / a;
  const auto which = static_cast<Cheeks>(int(cheeks));
  const auto at = asked_posture(which, ratio, phi0, phi);
  tell("GH", a * GH(at, ratio), metres, "of the centre of oscillation for the axis M, (3)");
  tell("GZ", a * GZ_on_cheeks<double>(which, ratio, phi0, phi), metres,
       "of the place where the force must act, (2)");
  tell("nearer", nearer(at, ratio), percent, "by how much GZ is smaller than GH, (A)");
  if(which == Cheeks::cycloids)
  {
    tell("short", reckoned_short(ratio, phi0), percent,
         "by how much too short a swing would be, if Z were H, (B)");
    tell("fast", 86'400 * reckoned_short(ratio, phi0), seconds, "what that would come to in a day");
  }
}

TELL
{
  curve("ratios", {"phi", "ratio", "amplitude"}, [](Curve& out) {
    for(const int most : {20, 40, 60, 80})
    {
      for(int i = 0; i <= 80; ++i)
      {
        const double top = most * 1_deg, here = top * std::sin(i * 90_deg / 80);
        out.put({here / 1_deg, 1 - nearer(on_cycloids<double>(top, here), k / a), double(most)});
      }
      out.block();
    }
  });
}

/*!
In a swing to {{phi0|deg0}} between Huygens's cheeks $GZ$ is {{GZ|5}} m at {{phi|deg0}}, and $GH$ is
{{GH|5}} m. To neglect the {{nearer|2}} would make a clock that swings so far {{fast|4}} seconds fast in
a day, more than the body's extent makes it lose. For narrow swings the fault is

$$ \frac{aa}{aa+kk}\cdot\frac{\varphi_0^2}8, \tag{C} $$

and a heavy point is not spared: also with $k = 0$ the term with $ds$ is what makes its swings between
cycloids equal.

::: figure tautochrone-15
alt: The ratio of GZ to GH against the angle of the thread, for swings to 20, 40, 60 and 80 degrees. Each
curve begins below one, the lower the wider the swing, and rises to one where the swing ends. Above one,
in a shaded strip, is where Euler's remark would have them.

How far $Z$ is from $G$, compared with $H$, between cycloids, $k = \tfrac1{10}a$. In each swing it comes
to $H$ at the turning point and is nearer to $G$ at every other place. Euler's words would have it in the
shaded strip.
:::

## Checks

The judge of $GZ$ is the motion of two weights $\tfrac12M$, at the distance $k$ from $G$, by d'Alembert's
principle, the speed being that which the body has gained from rest. The retardations of the rotation and
of $G$ are then what they are, and {{eq 1}} gives the arm.
*/

Fifty arm(int corrections, const Fifty& ratio, const Fifty& most, const Fifty& x)  // b, a = 1
{
  const auto r = corrections < 0 ? exact::Laurent<Fifty>(1) : truncated(corrections, ratio);
  const Accelerations of = accelerations(r, ratio, turning2_by_motion(r, ratio, most, x), x);
  return ratio * ratio * of.turning / of.across;
}

CHECK_THAT(
    "GZ and GH told are those of the motion on every kind of cheeks, and Z is in H for a fixed axis only")
{
  for(const Told& now :
      told_at("", "cheeks=3 k=0.3 phi0=45 phi=40", "cheeks=2 a=1e50 k=2e49 phi0=1e-3 phi=1e-4",
              "cheeks=0 phi0=89 phi=30 k=2", "k=1e-6 a=3 phi0=80 phi=79", "k=1e6 phi0=50 phi=1",
              "k=0.01 phi0=89 phi=60", "k=1e-9 phi0=89"))  // in these Z is near to G
  {
    const Fifty ratio = k.fifty() / a.fifty(), x = phi.fifty();
    const Fifty r = cheeks == 0 ? Fifty(1) : truncated(cheeks - 1, ratio)(cos(x)), H = ratio * ratio / r;
    const Fifty b = arm(cheeks - 1, ratio, phi0.fifty(), x);
    const char* const why = "the library's bound, and the angle's rounding near the end";
    CHECK(now.value("GH", metres) == within_relative(a.fifty() * H, 5e-14, why));
    CHECK(now.value("GZ", metres)
          == within(a.fifty() * b, double(a.fifty() * (cheeks == 1 ? b : H)) * 5e-14, why));
    CHECK(now.value("nearer", percent) == within(1 - b / H, 5e-14, why));
  }
  for(const Told& now : told_at("phi0=1e-6 phi=5e-7", "phi0=1e-6 phi=5e-7 k=0.01"))
  {
    const Fifty kk = pow(k.fifty(), 2), rise = pow(phi0.fifty(), 2) - pow(phi.fifty(), 2);
    CHECK(now.value("nearer", percent)
          == within_relative(rise, 1e-11, "the square of the angle comes next"));
    CHECK(now.value("GH", metres) == within_relative(kk, 1e-11, "the same"));
  }
}

CHECK_THAT("GZ is smaller than GH in 300 places of swings between Huygens's and Euler's cheeks, by (A)")
{
  int smaller = 0;
  for(const double ratio : {0.02, 0.1, 0.3, 0.6})
    for(const Cheeks which : {Cheeks::cycloids, Cheeks::euler_kk, Cheeks::euler_k4})
      for(const double part : {0.1, 0.3, 0.5, 0.8, 0.95})
        for(const double place : {0.0, 0.25, 0.5, 0.75, 0.99})
        {
          const double most = part * largest_amplitude(which, ratio);
          const auto at = on_cheeks<Fifty>(which, ratio, most, place * most);
          const Fifty w = turning2(at, Fifty(ratio)), ds_dphi = at.shortening * at.sin * w;
          CHECK(GZ(at, Fifty(ratio))
                == within(GH(at, Fifty(ratio))
                              * (place == 0 ? 1 - nearer(on_cheeks<double>(which, ratio, most, 0), ratio)
                                            : 1 - 2 * ds_dphi / force(at, Fifty(ratio))),
                          place == 0 ? 1e-13 : 1e-45, "two forms of the same, at φ = 0 in double"));
          if(GZ(at, Fifty(ratio)) < GH(at, Fifty(ratio)))
            ++smaller;
        }
  CHECK(smaller == 300);
}

/*!
The false equation, with $H$ for $Z$, is followed as a motion in fifty digits: at half of the time that
{{eq B}} gives for a swing the body must hang upright.
*/

CHECK_THAT(
    "with H for Z the swing would be as much shorter as told, by following that motion for half the time")
{
  for(const Told& now :
      told_at("", "k=0.6 a=2 phi0=75 phi=0", "k=1e-3 phi0=5 phi=1", "k=0.01 phi0=87 phi=0"))
  {
    const Fifty ratio = k.fifty() / a.fifty(), kk = ratio * ratio;
    const auto false_motion = [&](const Fifty&, const exact::State& y) -> exact::State {
      const Fifty c = cos(y[0]);
      return {y[1], -c * sin(y[0]) / (2 * (kk + c * c))};
    };
    const auto over = excess(exact::Laurent<Fifty>(Fifty(1), 1), ratio, phi0.fifty());
    const Fifty T = exact::pi() * sqrt(2 * (1 + kk)) * (1 + over);
    // How far from upright it is after half the time, over the speed: by so much the half is to be changed.
    const Fifty guess = 1 - reckoned_short(double(ratio), phi0);
    const auto there = exact::solve(false_motion, 0, {phi0.fifty(), 0}, T * guess / 2, Fifty("1e-24"));
    const Fifty short_ = 1 - (guess - 2 * there.y[0] / there.y[1] / T);
    CHECK(now.value("short", percent)
          == within_relative(short_, 1e-12, "a few hundred roundings, mostly less"));
    CHECK(now.value("fast", seconds) == within_relative(86'400 * short_, 1e-12, "a product"));
  }
}

CHECK_THAT(
    "narrow swings would be too short by (C), for any body; and a heavy point's by an eighth of φ₀φ₀")
{
  for(const Told& now : told_at("phi0=1e-5 phi=0", "phi0=1e-5 phi=0 k=2", "phi0=1e-5 phi=0 k=1e-9"))
  {
    const Fifty kk = pow(k.fifty(), 2), pp = pow(phi0.fifty(), 2);
    CHECK(
        now.value("short", percent)
        == within_relative(pp / (8 * (1 + kk)), 1e-12, "φ₀φ₀ is 3e-14 here, and a few hundred roundings"));
  }
  CHECK(reckoned_short(0.1, 20_deg)
        == between(5 * excess(Cheeks::cycloids, 0.1, 20_deg), 1, "far more than it loses"));
}

CHECK_THAT("in the figure all ratios are those of the motion and at most one, which they are at the end")
{
  for(const Told& now : told_at("", "k=0.4"))
  {
    int ends = 0;
    for(const auto& point : now.points("ratios"))
    {
      CHECK(point.value("ratio") == between(0, 1, "the remark is refuted"));
      if(point.at("phi") > point.at("amplitude") - 1e-9)
        CHECK(point.value("ratio") == within(1, 1e-13, "at the turning point Z is in H"));
      ends += point.at("phi") > point.at("amplitude") - 1e-9 ? 1 : 0;
    }
    CHECK(ends == 4);
    for(const auto& point : now.points("ratios", 7))
    {
      const Fifty at_ = point.at("phi"), x = (at_ > 0 ? at_ : Fifty("1e-12")) * exact::pi() / 180,
                  most = int(point.at("amplitude")) * exact::pi() / 180;
      const Fifty K = k.fifty();
      const Fifty ratio = x >= most ? Fifty(1) : arm(0, K, most, x) * cos(x) / (K * K);
      CHECK(point.value("ratio") == within(ratio, 2e-14, "the angle's rounding"));
      CHECK(point.value("phi") == between(0, 80, "within the widest swing"));
      CHECK(int(point.at("amplitude")) % 20 == 0);
      CHECK(point.value("amplitude") == between(20, 80, "one of the four"));
    }
  }
}

/*!
All three readings are tried between cycloids, $a = 1$ and $k = \tfrac1{10}$, at 10° of a swing of 20°.
Our copy has lost the bracket in {{eq 1}}, as in {{sec tautochrone.14}}; and in {{eq 2}} it has an $a$
for the $d$ before it.
*/

double turned()  // ddφ over dt²
{
  return twice_acceleration(on_cycloids<double>(20_deg, 10_deg), 0.1) / 2;
}

double wound()  // ds dφ over dt²
{
  const auto at = on_cycloids<double>(20_deg, 10_deg);
  return at.shortening * at.sin * turning2(at, 0.1);
}

double b_by(double below)  // kk ddφ over it
{
  return 0.01 * turned() / below;
}

bool is_arm(double b)
{
  return b
         == within_relative(arm(0, Fifty("0.1"), exact::pi() / 9, exact::pi() / 18), 2e-14,
                            "the library's bound");
}

const Emendation lost_bracket{
    "§15, the proportion",
    {"ddφ : d(a−s)dφ", [] { return b_by(-wound()); }},
    {"ddφ : d((a−s)dφ)", [] { return b_by(std::cos(10_deg) * turned() - wound()); }},
    "the expanded form beside it, and the accelerations of the body",
    is_arm};

const Emendation a_for_d{
    "§15, b, the denominator",
    {"a(a−s)dφ",
     [] { return b_by(std::cos(10_deg) * std::sqrt(turning2(on_cycloids<double>(20_deg, 10_deg), 0.1))); }},
    {"d((a−s)dφ)", [] { return b_by(std::cos(10_deg) * turned() - wound()); }},
    "the expanded form beside it, and the accelerations of the body",
    is_arm};

/*!
Whoever thinks of $dd\varphi$ as positive in {{eq 2}} will find $GZ$ greater than $GH$; this is what our
copy's word comes to as a number.
*/

const Erratum greater{
    "§15, GZ and GH",
    {"GZ is greater than GH: by the size of ddφ, GZ : GH = 1.11",
     [] { return std::cos(10_deg) * -turned() / (std::cos(10_deg) * -turned() - wound()); }},
    {"GZ is smaller than GH: with its sign, GZ : GH = 0.91",
     [] { return std::cos(10_deg) * turned() / (std::cos(10_deg) * turned() - wound()); }},
    "the accelerations of the body demand it, here and wherever the thread is wound",
    [](double reading) { return is_arm(reading * 0.01 / std::cos(10_deg)); }};

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
## Go on from here

::: exercise
A clock swings 5° between Huygens's cheeks. Somebody reckons its swings with $H$ in the place of $Z$, first
for a body with $k = \tfrac1{10}a$, then for a heavy point. By how much a day will he be wrong?

answer: {{eq C}} gives nearly $0.00095$ of a day for the point: `--phi0 5` tells 81.5 seconds for the body,
and with `--k 1e-9` it is 82.3 for the point. That is twice what a *circle* costs at 5°
({{sec tautochrone.03}}): the term with $ds$ is no small correction.
:::
*/

CHECK_THAT(
    "at 5° to take H for Z costs 81.5 seconds a day, for a heavy point 82.3, twice what a circle does")
{
  const Fifty five = exact::pi() / 36;
  for(const auto& [setting, seconds_] : {std::pair{"phi0=5", 81.5}, {"phi0=5 k=1e-9", 82.3}})
    for(const Told& now : told_at(setting))
    {
      CHECK(now.value("fast", seconds) == within(seconds_, 0.05, "three digits"));
      const Fifty law = five * five / 8 / (1 + pow(k.fifty(), 2));
      CHECK(now.value("short", percent) == within_relative(law, 2e-3, "(C), for narrow swings"));
    }
  CHECK(Fifty("82.3") / (86'400 * circle_excess(five)) == within(2, 0.01, "twice"));
}
