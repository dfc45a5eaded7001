#include <gsl/gsl_sf_ellint.h>

#include "edition/section.hpp"
#include "pendulum/plate.hpp"
#include "pendulum/series.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 13, "From the top: the complementary angle")

using pendulum::ratio_by_mean;

/*!
## What Euler does

He turns the figure over and counts the angles from the top. About the axis $A$ the circle is drawn with the
radius $AB = Ab = b$; its diameter $Bb$ is vertical, $B$ below and $b$ on top. A radius $Ag$ goes up, only a
little off the vertical, and from $g$ the pendulum begins to descend along the circle. The small angle $bAg$
he calls $\eta$. In the dissertation $\zeta$ was the angle $BAg$, so that now

$$ \zeta = 180° - \eta,\qquad c = \sin\left(90° - \tfrac12\eta\right) = \cos\tfrac12\eta, \tag{1} $$

which is nearly one. When the time $t$ has passed the pendulum has come down from $g$ to $Z$. The angle
$bAZ$ is called $\psi$, and then

$$ \Phi = BAZ = 180° - \psi,\qquad z = \sin\tfrac12\Phi = \cos\tfrac12\psi. \tag{2} $$

::: margin
Today $\sin\tfrac12\eta = \sqrt{1-cc}$ is called the complementary modulus, $k'$.
:::

The equation of the motion is the one that was found in {{sec pendulum.07}},

$$ \frac{dt\sqrt{2g}}{\sqrt b} = \frac{dz}{\sqrt{(1-zz)(cc-zz)}}, \tag{3} $$

and what has to be done is to rewrite it in the new angles. (Here it is printed as it should be; in
{{sec pendulum.07}} the scan has spoiled both factors.)

::: figure pendulum-13
alt: A circle with centre A, lowest point B, highest b. The radius to g leans a little, that to Z much more.

Euler's Fig. 4, to scale. The pendulum starts from rest in $g$ and has come to $Z$. Everything is measured
from the top, $b$.
:::

## The program

The new letters, and the equation in them.
*/

struct Letters
{
  double c, Phi, z;
};

Letters letters(double eta, double psi)  // (1), (2)
{
  return {std::cos(eta / 2), std::numbers::pi - psi, std::cos(psi / 2)};
}

double short_of_one(double eta)  // 1 − c, without a difference
{
  return 2 * std::pow(std::sin(eta / 4), 2);
}

double element(double c, double z)  // (3), without dz
{
  return 1 / std::sqrt((1 - z * z) * (c * c - z * z));
}

/*!
What looks like a mere change of letters is, for a calculator with a fixed number of places, the whole
point. Near the top $c$ cannot be written down: at $\eta = 1''$ it differs from one in the twelfth place,
and in double precision it *is* one as soon as $\eta$ is below $2\cdot10^{-8}$. The angle $\zeta$ is hardly
better; the double nearest to 180° is a definite angle that falls short of it. But $\eta$ can be as small as
it likes and keeps all its digits. So does the time, if it is computed from $\sin\tfrac12\eta$, as by the
mean.

::: code pendulum/series.hpp ratio_by_mean
:::

The routines that take a modulus take $c$. Given the sine instead, Carlson's integral
$R_F(0, \sin^2\tfrac12\eta, 1)$ is the same number.
*/

double ratio_of_modulus(double c)
{
  return gsl_sf_ellint_Kcomp(c, GSL_PREC_DOUBLE) * 2 / std::numbers::pi;
}

double ratio_of_complement(double s)
{
  return gsl_sf_ellint_RF(0, s * s, 1, GSL_PREC_DOUBLE) * 2 / std::numbers::pi;
}

const auto swing_ = amplitude_from_top(12_deg);
const auto psi =
    angle("psi", 60_deg, above_to(0_deg, 180_deg), "bAZ, the angle from the top reached so far");
const auto b = real("b", 1.0, metres, positive, "AB, length of the equivalent simple pendulum");
const auto g =
    real("g", 4.903325, metres, positive, "height fallen in the first second, half of today's g");

TELL
{
  require(psi >= swing_.eta, "psi", "at least eta, where the descent begins");
  const auto [c, Phi, z] = letters(swing_.eta, psi);
  const double unit = std::sqrt(b / (2 * g));
  tell("c", c, "cos ½η");
  tell("short_of_one", short_of_one(swing_.eta), "1 − c");
  tell("s", std::sin(swing_.eta / 2), "sin ½η, which says the same and keeps its digits");
  tell("Phi", Phi, degrees, "BAZ, the angle from the lowest point");
  tell("z", z, "cos ½ψ");
  tell("t", unit * swing::time_from_rest(psi, swing_.eta), seconds, "time from g to Z");
  tell("descent", unit * swing::quarter_time_from_top(swing_.eta), seconds, "time from g to B");
  const double short_of_pi = swing::Amplitude::from_zeta(std::numbers::pi).eta;
  tell("short_of_pi", short_of_pi, radians, "what the double nearest to π lacks of 180°");
  tell("nearest_pi", swing::ratio_from_top(short_of_pi), "T/Θ for an amplitude of exactly that double");
  tell("condition", std::numbers::pi / swing_.eta / swing::quarter_time_from_top(swing_.eta),
       "by what factor, nearly, a relative error of ζ is magnified in T");
}

/*!
The time from the top, for smaller and smaller η; and what is lost when it is computed from $c$.
*/

double lost(double got, double eta)
{
  return static_cast<double>(abs(got / ratio_by_mean(Fifty(eta)) - 1));
}

TELL
{
  auto& rows = table("rows", "The descent from near the top",
                     {{"eta", "η", radians},
                      {"K", "t√(2g/b)", none, 12},
                      {"ratio", "T/Θ", none, 12},
                      {"lost", "error from c", none, 2},
                      {"kept", "error from η", none, 2}});
  for(const double eta : {1., 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-16, 1e-150, 1e-300})
  {
    const double ratio = swing::ratio_from_top(eta);
    const double from_c = ratio_of_modulus(std::cos(eta / 2));
    rows.row({eta, swing::quarter_time_from_top(eta), ratio, lost(from_c, eta), lost(ratio, eta)});
  }
  curve("lost", {"eta", "from_c", "from_eta", "rounding"}, [](Curve& c) {
    for(double eta = 1; eta > 1e-12; eta /= 1.05)
    {
      const double s = std::sin(eta / 2), K = swing::quarter_time_from_top(eta);
      c.put({eta, lost(ratio_of_modulus(std::cos(eta / 2)), eta) + 1e-18,
             lost(swing::ratio_from_top(eta), eta) + 1e-18, 0x1p-54 / (s * s * K)});
    }
  });
}

/*!
The lines of the plate, and the race between the routines that are told $c$ and those that are told $\eta$.
*/

TELL
{
  using pendulum::arc, pendulum::at, pendulum::line;
  const double g_ = std::numbers::pi - swing_.eta, Z = std::numbers::pi - psi;
  curve("plate", {"x", "y"}, [=](Curve& c) {
    arc(c, 1, 0, 2 * std::numbers::pi);
    line(c, at(1, 0), at(1, std::numbers::pi));
    line(c, at(0, 0), at(1, g_));
    line(c, at(0, 0), at(1, Z));
    arc(c, 0.62, std::numbers::pi, g_);
    arc(c, 0.4, std::numbers::pi, Z);
    arc(c, 0.2, 0, Z);
    arc(c, 1, g_, Z);
  });
}

TELL
{
  const double eta = swing_.eta, zeta = swing_.zeta, c = std::cos(eta / 2), s = std::sin(eta / 2);
  race("from_the_top", "T/Θ", ratio_by_mean(Fifty(eta)),
       {{"GSL, of c", [=] { return ratio_of_modulus(c); }},
        {"standard library, of c", [=] { return std::comp_ellint_1(c) * 2 / std::numbers::pi; }},
        {"GSL's R_F, of s", [=] { return ratio_of_complement(s); }},
        {"mean, of η", [=] { return ratio_by_mean(eta); }},
        {"this edition, of η", [=] {
           return swing::ratio({zeta, eta});
         }}});
}

/*!
Try `--eta 1e-5` or `--eta 1e-300` for the race. An amplitude of exactly the double that is called π is not
180° but {{short_of_pi|e4}} short of it, and the swing takes {{nearest_pi|8}} times as long as a small one:
no infinity, only a lost digit.

::: figure pendulum-13-lost
alt: Relative error of the time against η. From c it grows as the inverse square; from η it stays at 1e-16.

The same number from $c$ and from $\eta$. The grey line is what the rounding of $c$ must cost, whoever
computes; it is not GSL's fault. At $\eta = 2\cdot10^{-8}$ there is nothing left of $c$ but 1, and the
answer is no number. From $\eta$ all digits are there.
:::

## Checks

The equation {{eq 3}} holds along the exact motion (Jacobi's functions in fifty digits), whose speed gives
$dz/dt$.
*/

CHECK_THAT("dz/dt along the exact descent is the root in the equation")
{
  for(const double eta : {1e-3, 0.1, 1.0})
  {
    const auto motion = swing::oracle::Motion::from_eta(eta);
    for(const double t : {0.5, 1.0, 1.5})
    {
      const Fifty Phi = motion.angle(t), slope = cos(Phi / 2) * motion.velocity(t) / 2;
      const double z = static_cast<double>(sin(Phi / 2));
      const double amplified = 4 * static_cast<double>(1 / (pow(Fifty(std::cos(eta / 2)), 2) - z * z)) + 8;
      CHECK(1 / element(std::cos(eta / 2), z)
            == within_ulps(slope, amplified, "1 − zz and cc − zz cancel"));
    }
  }
}

CHECK_THAT("the letters fit: from ζ and from η, from Φ and from ψ, come the same c and z")
{
  for(const double eta : {1_deg, 12_deg, 90_deg})
    for(const double reached : {12_deg, 60_deg, 180_deg})
    {
      const auto [c, Phi, z] = letters(eta, reached);
      CHECK(c == within_ulps(sin((exact::pi() - eta) / 2), 1, "one cosine"));
      CHECK(z == within(sin((exact::pi() - reached) / 2), 1e-16, "one cosine, of a rounded angle at 180°"));
      CHECK(Phi == within(exact::pi() - reached, 3e-16, "π and the difference are rounded"));
    }
}

/*!
Thirty digits of the table, and the straight line that the times follow against the logarithm of η.
*/

CHECK_THAT("the time of the descent from near the top, for η from 1 to 1e-300")
{
  CHECK(ratio_by_mean(Fifty("1")) == printed("1.39691379101285271058187005814"));
  CHECK(ratio_by_mean(Fifty("1e-3")) == printed("5.72142753851878287200410654201"));
  CHECK(ratio_by_mean(Fifty("1e-16")) == printed("24.7777527650575972683079362804"));
  CHECK(ratio_by_mean(Fifty("1e-300")) == printed("441.085172928572554084051195236"));
  for(double eta = 1; eta > 1e-300; eta *= 1e-3)
  {
    CHECK(swing::ratio_from_top(eta)
          == within_ulps(ratio_by_mean(Fifty(eta)), 2, "the library's own bound"));
    const Fifty s = sin(Fifty(eta) / 2), line = log(4 / s);
    const Fifty K = swing::oracle::K_from_complement(s);
    const Fifty least = s * s * (line - 1) / 4 - 1e-45, most = s * s * line / 4 + 1e-45;
    CHECK(K - line == between(least, most, "the next term, ¼ss(ln(4/s) − 1), and rounding"));
  }
}

CHECK_THAT("at 1e-8 the cosine of ½η is 1, yet what it lacks of 1 is not nothing")
{
  CHECK(std::cos(1e-8 / 2) == 1);
  CHECK(short_of_one(1e-8) == within_ulps(1 - cos(Fifty(1e-8) / 2), 2, "a sine, counted twice"));
  CHECK(std::isnan(ratio_of_modulus(1)));
}

CHECK_THAT("an amplitude of the double nearest to π is not 180°")
{
  const auto amplitude_pi = swing::Amplitude::from_zeta(std::numbers::pi);
  CHECK(amplitude_pi.eta == within_ulps(exact::pi() - std::numbers::pi, 1, "π is known to 107 bits"));
  const Fifty nearest("24.6487401924287497499194089851");
  CHECK(swing::ratio(amplitude_pi) == within_ulps(nearest, 2, "the library's own bound"));
  CHECK(ratio_by_mean(exact::pi() - std::numbers::pi) == printed("24.6487401924287497499194089851"));
}

/*!
What the rounding of $c$ costs is half a unit of its last place times the steepness of the time, $1/ss$.
*/

CHECK_THAT("from c no routine does better than the rounding of c, and GSL does no worse than twice that")
{
  for(const double eta : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
  {
    const double s = std::sin(eta / 2), bound = 0x1p-54 / (s * s * swing::quarter_time_from_top(eta));
    const double from_c = lost(ratio_of_modulus(std::cos(eta / 2)), eta);
    CHECK(from_c == between(0, 2 * bound + 1e-15, "the rounding, and GSL's own"));
    CHECK(lost(ratio_of_complement(s), eta) == between(0, 1e-15, "nothing is lost in s"));
  }
}
