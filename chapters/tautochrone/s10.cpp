#include "edition/section.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/thread.hpp"

SECTION(tautochrone, 10, "The centre of oscillation wanders")

using namespace tautochrone;

/*!
## What Euler does

In any other position the pendulum turns at the first instant no longer about $A$ but about $M$, where it
leaves the cheek, and its centre of oscillation is another. Call it $H$. Its distance from the centre of
gravity $G$ is not that of $D$ from $C$ in the position of rest, because the pendulum has become shorter, $MG$
instead of $AC$: its axis has moved on to $M$. The rule is the same ({{sec tautochrone.09}}); and as it gave
$CD = \frac{kk}{AC}$, it now gives

$$ GH = \frac{kk}{MG}, \qquad GH : CD = AC : MG. \tag{1} $$

So $GH$ is greater than $CD$. A compound pendulum moves at every instant as if it were all collected in its
centre of oscillation. But because this centre $H$ changes, no simple pendulum can be shown whose motion
would agree with that of the compound one, unless the cheek $AMB$ is taken away altogether.

::: margin
$H$ is where a blow makes no shock at $M$. As $MG \to 0$, $GH$ grows without bound.
:::

"As if collected in $H$" is true of a pendulum of fixed length. Here the thread shortens while it turns, and
the point that stands in for $H$ in the equation of motion is another. It will be called $Z$
({{sec tautochrone.15}}): in $Z$ the force $P$ must act, across the line $MG$, that changes the motion of
$G$ and the rotation just as the constraint wants it. If the body swings out to $\varphi_0$ between
Huygens's cheeks, and $c = \cos\varphi$, $c_0 = \cos\varphi_0$, all lengths being measured by $a$, then

$$ GZ = \frac{kk\,c\,(kk + c_0^2)}{cc\,(kk+cc) + kk\,(cc - c_0^2)}, \tag{A} $$

$$ \frac{GZ}{GH} = 1 - \frac{(kk + cc)(cc - c_0^2)}{cc\,(kk+cc) + kk\,(cc - c_0^2)}. \tag{B} $$

$Z$ therefore lies between $G$ and $H$. At the end of the swing, $c = c_0$, where the thread is for an instant
at rest, it falls on $H$; everywhere else it is nearer to $G$.

## The program

A centre of oscillation is found from {{eq 1}}, the point $Z$ from {{eq A}}; both, and the forces, from the
angle and the amplitude alone.

::: code tautochrone/thread.hpp motion (1)
:::
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.3, metres, scale, "radius of gyration");
const auto phi0 =
    angle("phi0", 60_deg, above_to(0_deg, 89_deg), "how far the pendulum swings to either side");
const auto phi = angle("phi", within_swing(30_deg, phi0), closed(0_deg, 89_deg),
                       "angle of the free part with the vertical");

double short_of_H(double ratio, const Posture<double>& at)  // 1 − GZ/GH, (B)
{
  const double kk = ratio * ratio, cc = at.cos * at.cos;
  const double rise = 2 * at.to_rise;  // cc − c₀c₀
  return (kk + cc) * rise / (cc * (kk + cc) + kk * rise);
}

TELL
{
  const double ratio = k / a;
  require(ratio >= 1e-80, "k", "from 1e-80 a to 1e20 a");
  require(ratio <= 1e20, "k", "from 1e-80 a to 1e20 a");
  const auto at = posture_as_written(Cheeks::cycloids, ratio, phi0, phi);
  tell("CD", a * (ratio * ratio), metres, "of the centre of oscillation at rest");
  tell("GH", a * GH(at, ratio), metres, "of that for the axis M, (1)");
  tell("GZ", a * cycloidal_GZ<double>(ratio, phi0, phi), metres, "of the place where P must act, (A)");
  tell("short_of_H", short_of_H(ratio, at), percent, "by how much GZ is smaller than GH, (B)");
  tell("P", force(at, ratio), "the force P over the weight");
  tell("tension", tension(at, ratio), "the pull along the thread over the weight");
}

TELL
{
  curve("loci", {"phi", "G_y", "G_x", "Z_y", "Z_x", "H_y", "H_x", "q", "p"}, [](Curve& out) {
    for(int i = 0; i <= 60; ++i)
    {
      const double here = i * 1_deg, s = std::sin(here), c = std::cos(here);
      const double q = euler_q<double>(1, 0, here), p = euler_p<double>(1, 0, here);
      const double Z = c + cycloidal_GZ<double>(0.3, 60_deg, here), H = c + 0.09 / c;
      out.put({double(i), q + c * s, p + c * c, q + Z * s, p + Z * c, q + H * s, p + H * c, q, p});
    }
  });
}

/*!
With $k = \tfrac3{10}a$ and a swing of 60°, $GH$ has at 30° grown from {{CD|4}} m to {{GH|5}} m. But $GZ$ is
{{GZ|5}} m, less by {{short_of_H|3}}: to take $H$ for $Z$ would be no small error.

::: figure tautochrone-10
alt: A cheek hangs from A to the right. From it five straight threads go down to the curve of G. Below that
curve runs the curve of Z, and below it that of H; these two begin apart at the bottom and meet at the right
end of the swing, at 60 degrees.

Where $G$, $Z$ and $H$ are in a swing out to 60° between cycloidal cheeks, $k = \tfrac3{10}a$, to one side.
$H$ leaves $G$ as the free part gets shorter. $Z$, where the equation of motion has its force, meets it only
at the end of the swing.
:::

## Checks

The centre of oscillation is taken from its definition: a body with the radius of gyration $k$ may be
replaced by two equal weights, $k$ above and $k$ below $G$, and Huygens's sum of $m\rho\rho$ is made for the
axis $M$.
*/

CHECK_THAT("GH is that of two equal weights at the distance k from G, about the axis M, and CD about A")
{
  for(const Told& now : told_at("", "k=2 a=0.5 phi0=89 phi=89", "a=1e50 k=1e-20 phi=1e-9", "k=1e20 phi=60"))
  {
    const Fifty k_ = k.fifty();
    const auto beyond = [&](const Fifty& r) -> Fifty {  // of the centre of oscillation for the distance r
      const Fifty sum = (r - k_) * (r - k_) + (r + k_) * (r + k_);
      return (sum - 2 * r * r) / (2 * r);
    };
    const char* const why = "three roundings, and the angle's near 90°";
    CHECK(now.value("CD", metres) == within_relative(k_ * k_ / a.fifty(), 1e-15, "three roundings"));
    CHECK(now.value("GH", metres) == within_relative(k_ * k_ / (a.fifty() * cos(phi.fifty())), 2e-14, why));
    if(k_ / a.fifty() > 1e-5 && k_ / a.fifty() < 1e5)
    {
      CHECK(now.value("CD", metres) == within_relative(beyond(a.fifty()), 1e-15, why));
      CHECK(now.value("GH", metres) == within_relative(beyond(a.fifty() * cos(phi.fifty())), 2e-14, why));
    }
  }
}

/*!
$GZ$, $P$ and the tension come from the motion itself. The energy gives $d\varphi/dt$, its differences in
fifty digits $dd\varphi$; from these follow the acceleration of $G$, as a point with two coordinates, and
that of the rotation. $GZ$ is the arm with which $P$ must act.
*/

struct Accelerations  ///< of a body on cycloids, a = 1, from differences of its energy and its places
{
  Fifty turning;  ///< 2ddφ/dt²
  Fifty along;    ///< 2ddG/dt² along the thread, towards M
  Fifty across;   ///< and at right angles to it, upwards
};

Accelerations accelerations(const Fifty& k_, const Fifty& phi0_, const Fifty& phi_)
{
  const Fifty h = phi_ * Fifty("1e-12");
  const auto turning2_ = [&](const Fifty& x) -> Fifty {
    return (pow(cos(x), 2) - pow(cos(phi0_), 2)) / (2 * (k_ * k_ + pow(cos(x), 2)));
  };
  const auto y = [](const Fifty& x) -> Fifty { return (x + sin(x) * cos(x)) / 2; };
  const auto height = [](const Fifty& x) -> Fifty { return pow(sin(x), 2) / 2; };
  const Fifty w = turning2_(phi_), twice_dd = (turning2_(phi_ + h) - turning2_(phi_ - h)) / (2 * h);
  const auto twice = [&](const auto& f) -> Fifty {  // the second time derivative of f(φ), doubled
    const Fifty up = f(phi_ + h), low = f(phi_ - h);
    return 2 * w * (up - 2 * f(phi_) + low) / (h * h) + twice_dd * (up - low) / (2 * h);
  };
  const Fifty to_right = twice(y), upwards = twice(height), s = sin(phi_), c = cos(phi_);
  return {twice_dd, upwards * c - to_right * s, upwards * s + to_right * c};
}

CHECK_THAT("GZ, P and the tension told are what the accelerations of the body demand")
{
  for(const Told& now : told_at("", "k=2 a=0.5 phi0=89 phi=45", "k=1e-6 a=3 phi0=80 phi=79",
                                "a=1e50 k=3e49 phi=1e-3", "k=0.1 phi0=89 phi=89"))
  {
    const Fifty k_ = k.fifty() / a.fifty();
    const Accelerations of = accelerations(k_, phi0.fifty(), phi.fifty());
    const Fifty pull = cos(phi.fifty()) + of.along, P_ = -of.across, arm = -of.turning * k_ * k_ / P_;
    CHECK(now.value("GZ", metres)
          == within_relative(a.fifty() * arm, 2e-14, "the library's, and the angle's"));
    CHECK(now.value("P") == within_relative(P_, 2e-14, "the same"));
    CHECK(now.value("tension") == within_relative(pull, 2e-14, "the same"));
    CHECK(now.value("short_of_H", percent)
          == within(1 - arm * cos(phi.fifty()) / (k_ * k_), 2e-14, "two sines, and the angle's rounding"));
  }
  for(const Told& now : told_at("phi0=60 phi=59.99999999999", "phi0=89 phi=88.9999999999 k=1e-5"))
  {
    const Fifty kk = pow(k.fifty() / a.fifty(), 2), cc = pow(cos(phi.fifty()), 2),
                rise = cc - pow(cos(phi0.fifty()), 2);
    CHECK(now.value("short_of_H", percent)
          == within_relative((kk + cc) * rise / (cc * (kk + cc) + kk * rise), 1e-14,
                             "the angles as written"));
  }
}

CHECK_THAT("the three loci are those of G, Z and H; Z and H meet at the end of the swing")
{
  for(const Told& now : told_at(""))
  {
    const auto all = now.points("loci");
    for(const std::size_t i : {std::size_t(5), std::size_t(30), std::size_t(45), std::size_t(60)})
    {
      const Fifty x = int(i) * exact::pi() / 180, s = sin(x), c = cos(x);
      const auto M = cycloidal_places(x);
      const Accelerations of = accelerations(Fifty("0.3"), exact::pi() / 3, x);
      const Fifty Z = c + of.turning / of.across * Fifty("0.09"), H = c + Fifty("0.09") / c;
      const char* const why = "a few roundings";
      CHECK(all[i].value("phi") == within(int(i), 0, "a count"));
      CHECK(all[i].value("q") == within(M.q, 2e-15, why));
      CHECK(all[i].value("p") == within(M.p, 2e-15, why));
      CHECK(all[i].value("G_y") == within(M.G_aside, 2e-15, why));
      CHECK(all[i].value("G_x") == within(M.G_down, 2e-15, why));
      CHECK(all[i].value("Z_y") == within(M.q + Z * s, 2e-15, why));
      CHECK(all[i].value("Z_x") == within(M.p + Z * c, 2e-15, why));
      CHECK(all[i].value("H_y") == within(M.q + H * s, 2e-15, why));
      CHECK(all[i].value("H_x") == within(M.p + H * c, 2e-15, why));
    }
    CHECK(all.back().value("Z_y")
          == within(all.back().at("H_y"), 2e-15, "one place, reckoned in two ways"));
  }
}

CHECK_THAT("it refuses an angle beyond the end of the swing and a k beyond its limits, by however little, "
           "and neither at the limit")
{
  for(const char* const within_them :
      {"phi0=30 phi=30", "phi0=50 phi=50", "k=1e-80", "a=2 k=2e-80", "k=1e20", "a=2 k=2e20"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"phi0=30 phi=30.0000000000000000000001", "phi0=50 phi=50.0000000000000000000001",
       "k=9.999999999999997e-81", "a=2 k=1.9999999999999994e-80", "k=1.0000000000000002e20",
       "a=2 k=2.0000000000000004e20"})
    CHECK(refused_at(beyond));
}

/*!
## Notes

That no simple pendulum agrees with the compound one is meant of a pendulum whose length is fixed. A *curve*
with a heavy point on it that keeps the same time does exist: its arc σ is that of {{sec tautochrone.22}},
$d\sigma^2 = dz^2 + kk\,d\varphi^2$, and its heights are those of $G$. Equal times ask that this curve be a
cycloid.
*/

/*!
## Go on from here

::: exercise
How near to $G$ does $Z$ come in a swing of a very small body, measured by $GH$?

answer: For $k = 0$ the fraction in {{eq B}} is $\dfrac{cc - c_0^2}{cc}$, so that $GZ : GH = c_0^2 : cc$. In a
swing to 60° it is a quarter in the lowest place: `--k 1e-6 --phi 0` tells that $GZ$ is smaller by 75 %.
However small the body is, to take $H$ for $Z$ is wrong by a finite part.
:::
*/

CHECK_THAT("for a very small body GZ : GH is the quotient of the squared cosines")
{
  for(const Told& now : told_at("k=1e-6 phi=0", "k=1e-7 phi=45", "k=1e-6 phi0=80 phi=0"))
    CHECK(now.value("short_of_H", percent)
          == within_relative(1 - pow(cos(phi0.fifty()) / cos(phi.fifty()), 2), 1e-9,
                             "kk against the cosines"));
}
