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

He draws the figure anew and counts the angles from the top. About the axis $A$ a circle is described with
the radius $AB = Ab = b$; its diameter $Bb$ is vertical. A radius $Ag$ is drawn upwards, only a little off
the vertical, and from $g$ the pendulum begins to descend along the circle. The small angle $bAg$ he calls
$\eta$. In the dissertation $\zeta$ was the angle $BAg$, so that now

::: margin
$b$ is both the length and the point at the top. Today $\sin\tfrac12\eta = \sqrt{1-cc}$ is called the
complementary modulus, $k'$.
:::

$$ \zeta = 180° - \eta,\qquad c = \sin\left(90° - \tfrac12\eta\right) = \cos\tfrac12\eta, \tag{1} $$

which is nearly one. When the time $t$ has passed, the pendulum has come down from $g$ to $Z$. The angle
$bAZ$ is called $\psi$, and then

$$ BAZ = \Phi = 180° - \psi,\qquad z = \sin\tfrac12\Phi = \cos\tfrac12\psi. \tag{2} $$

The equation of the motion, found in {{sec pendulum.07}}, was

$$ \frac{dt\sqrt{2g}}{\sqrt b} = \frac{dz}{\sqrt{(1-zz)(cc-zz)}}, \tag{3} $$

and the new angles are now to be put into it.

::: figure pendulum-13
alt: A circle with centre A, lowest point B, highest b. The radius to g leans a little, that to Z much more.

Euler's Fig. 4, to scale, with $\eta$ = {{eta}} and $\psi$ = {{psi}}. The pendulum starts from rest in $g$
and has come to $Z$.
:::

## The program

The new letters, and the equation in the old ones.
*/

struct Letters
{
  double c, Phi, z;
};

Letters letters(double eta, double psi)  // (1), (2)
{
  return {std::cos(eta / 2), std::numbers::pi - psi, std::cos(psi / 2)};
}

template <class Real>
Real element(Real c, Real z)  // (3), without dz
{
  using std::sqrt;
  return 1 / sqrt((1 - z * z) * (c * c - z * z));
}

/*!
For whoever calculates with a fixed number of places the change of letters is the whole point. Near the top
$c$ cannot be written down: in double precision it *is* one as soon as $\eta$ is below $2\cdot10^{-8}$. The
angle $\zeta$ is hardly better, for the double nearest to 180° is a definite angle that falls short of it.
But $\eta$ keeps all its digits however small it is, and so does the time, if it is computed from
$\sin\tfrac12\eta$: by the mean of {{sec pendulum.11}}, for instance. Here GSL is told $c$, and the
edition's own routine η.
*/

double ratio_of_modulus(double c)
{
  return gsl_sf_ellint_Kcomp(c, GSL_PREC_DOUBLE) * 2 / std::numbers::pi;
}

Cell from_modulus(double c)  // as the table shows it
{
  return c < 1 ? Cell(ratio_of_modulus(c)) : Cell("no number");
}

double lost(double got, double eta)
{
  return static_cast<double>(abs(got / ratio_by_mean(Fifty(eta)) - 1));
}

const auto swing_ = amplitude_from_top(12_deg);
const auto psi =
    angle("psi", 60_deg, above_to(0_deg, 180_deg), "bAZ, the angle from the top reached so far");

TELL
{
  require(psi >= swing_.eta, "psi", "at least eta, where the descent begins");
  const auto [c, Phi, z] = letters(swing_.eta, psi);
  tell("c", c, "cos ½η");
  tell("Phi", Phi, degrees, "BAZ, the angle from the lowest point");
  tell("z", z, "cos ½ψ");
  tell("tau", swing::time_from_rest(psi, swing_.eta), "t√(2g)/√b, from g to Z");
  tell("descent", swing::quarter_time_from_top(swing_.eta), "the same from g to B");
  const double short_of_pi = swing::Amplitude::from_zeta(std::numbers::pi).eta;
  tell("short_of_pi", short_of_pi, radians, "what the double nearest to π lacks of 180°");
  tell("nearest_pi", swing::ratio_from_top(short_of_pi), "T/Θ for an amplitude of exactly that double");
}

TELL
{
  auto& rows =
      table("rows", "The time of a swing from nearer and nearer to the top",
            {{"eta", "η", radians}, {"ratio", "T/Θ, from η", none, 12}, {"from_c", "from c", none, 12}});
  for(const double eta : {1., 1e-2, 1e-4, 1e-6, 1e-8, 1e-16, 1e-300})
    rows.row({eta, swing::ratio_from_top(eta), from_modulus(std::cos(eta / 2))});
  curve("lost", {"eta", "from_c", "from_eta", "rounding"}, [](Curve& c) {
    for(double eta = 1; eta > 1e-12; eta /= 1.05)
    {
      const double s = std::sin(eta / 2), K = swing::quarter_time_from_top(eta);
      c.put({eta, lost(ratio_of_modulus(std::cos(eta / 2)), eta) + 1e-18,
             lost(swing::ratio_from_top(eta), eta) + 1e-18, 0x1p-54 / (s * s * K)});
    }
  });
}

TELL
{
  using pendulum::arc, pendulum::at, pendulum::line;
  const double g = std::numbers::pi - swing_.eta, Z = std::numbers::pi - psi;
  curve("plate", {"x", "y"}, [=](Curve& c) {
    arc(c, 1, 0, 2 * std::numbers::pi);
    line(c, at(1, 0), at(1, std::numbers::pi));
    line(c, at(0, 0), at(1, g));
    line(c, at(0, 0), at(1, Z));
    arc(c, 0.62, std::numbers::pi, g);
    arc(c, 0.4, std::numbers::pi, Z);
    arc(c, 0.2, 0, Z);
    arc(c, 1, g, Z);
  });
}

/*!
{{table rows}}

An amplitude of exactly the double that is called π is not 180° but {{short_of_pi|e4}} rad short of it, and
the swing takes no infinite time but {{nearest_pi|8}} Θ.

::: figure pendulum-13-lost
alt: Relative error of the time against η. From c it grows as the inverse square; from η it stays at 1e-16.

The same time from $c$ and from $\eta$. The grey line is what the rounding of $c$ may cost, whoever
computes. Below $\eta = 2\cdot10^{-8}$ there is nothing left of $c$ but 1, and the answer is no number. From
$\eta$ nothing is lost.
:::

## Checks

The letters fit the old ones, and {{eq 3}} holds along the exact motion.
*/

CHECK_THAT("from ζ and from η, from Φ and from ψ, come the same c and z")
{
  for(const double eta : {1_deg, 12_deg, 90_deg})
    for(const double reached : {12_deg, 60_deg, 180_deg})
    {
      const auto [c, Phi, z] = letters(eta, reached);
      CHECK(c == within_ulps(sin((exact::pi() - eta) / 2), 1, "one cosine"));
      CHECK(z == within_ulps(sin((exact::pi() - reached) / 2), 1, "one cosine"));
      CHECK(Phi == within(exact::pi() - reached, 3e-16, "π and the difference are rounded"));
    }
}

CHECK_THAT("dz/dt along the exact motion is the root in the equation")
{
  for(const double eta : {1e-3, 0.1, 1.0})
    for(const double t : {0.5, 1.0, 1.5})
    {
      const auto motion = swing::oracle::Motion::from_eta(eta);
      const Fifty Phi = motion.angle(t), slope = cos(Phi / 2) * motion.velocity(t) / 2;
      CHECK(1 / element(cos(Fifty(eta) / 2), sin(Phi / 2))
            == within_relative(slope, 1e-46, "fifty digits, less what cc − zz cancels"));
    }
}

CHECK_THAT("the time of a swing keeps its digits down to 1e-300 from the top")
{
  CHECK(ratio_by_mean(Fifty("1")) == printed("1.39691379101285271058187005814"));
  CHECK(ratio_by_mean(Fifty("1e-16")) == printed("24.7777527650575972683079362804"));
  CHECK(ratio_by_mean(Fifty("1e-300")) == printed("441.085172928572554084051195236"));
  for(double eta = 1; eta > 1e-300; eta *= 1e-10)
    CHECK(swing::ratio_from_top(eta)
          == within_ulps(ratio_by_mean(Fifty(eta)), 0.7, "the library's own bound"));
}

CHECK_THAT("an amplitude of the double nearest to π is not 180°")
{
  const auto nearest = swing::Amplitude::from_zeta(std::numbers::pi);
  CHECK(nearest.eta == within_ulps(exact::pi() - std::numbers::pi, 0.5, "correctly rounded"));
  CHECK(ratio_by_mean(exact::pi() - std::numbers::pi) == printed("24.6487401924287497499194089851"));
}

/*!
The steepness of the time against $c$ is $1/ss$, nearly; by so much the rounding of $c$, half a unit of its
last place, is magnified.
*/

CHECK_THAT("from c GSL loses what the rounding of c may cost, and in the end all")
{
  for(const double eta : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
  {
    const double s = std::sin(eta / 2), cost = 0x1p-54 / (s * s * swing::quarter_time_from_top(eta));
    CHECK(lost(ratio_of_modulus(std::cos(eta / 2)), eta)
          == between(cost / 100, 1.5 * cost + 4e-16, "c is rounded, and half as much cc; a few ulps more"));
  }
  CHECK(std::cos(2e-8 / 2) == 1);
  CHECK(std::isnan(ratio_of_modulus(1)));
}

/*!
What is told at Euler's figure, near the top and far from it; the exact motion says how long the descent
takes.
*/

CHECK_THAT("the letters and times told are those of the exact descent")
{
  for(const Told& now : told_at("", "eta=1e-200rad psi=1e-100rad", "eta=100 psi=150"))
  {
    const Fifty eta = swing_.eta.fifty(), psi_ = psi.fifty(),
                K = swing::oracle::K_from_complement(sin(eta / 2));
    CHECK(now.value("c") == within_ulps(cos(eta / 2), 1, "one cosine"));
    CHECK(now.value("Phi", degrees)
          == within(exact::pi() - psi_, 5e-16, "π and the difference are rounded"));
    CHECK(now.value("z") == within_ulps(cos(psi_ / 2), 1, "one cosine"));
    CHECK(now.value("descent") == within_ulps(K, 1, "the library's bound"));
    const auto motion = swing::oracle::Motion::from_eta(eta);
    const Fifty tau = swing::oracle::time_from_rest_past(psi_ - eta, eta);
    CHECK(now.value("tau") == within_relative(tau, 2e-15, "the library's bound, six ulps"));
    CHECK(motion.angle_from_top(tau - K)
          == within_relative(psi_, 1e-40, "fifty digits, less the tenth of the time"));
    const Fifty short_of = exact::pi() - Fifty(std::numbers::pi);
    CHECK(now.value("short_of_pi", radians) == within_ulps(short_of, 0.5, "correctly rounded"));
    CHECK(now.value("nearest_pi")
          == within_ulps(swing::oracle::ratio_from_top(short_of), 1, "the library's bound"));
  }
}

CHECK_THAT("the table has the times from η, and what the modulus that is a double has for a time")
{
  for(const Told& now : told_at(""))
    for(const auto& row : now.rows("rows"))
    {
      const double eta = row.at("eta", radians), c = std::cos(eta / 2);
      CHECK(row.value("ratio")
            == within_ulps(swing::oracle::ratio_from_top(Fifty(eta)), 1, "the library's bound"));
      if(c < 1)
        CHECK(row.value("from_c")
              == within_relative(2 / exact::pi() * swing::oracle::K(Fifty(c)),
                                 3e-10 / eta / eta * 1e-7 + 1e-15, "GSL forms 1 − cc of it"));
      else
        CHECK(row.words("from_c") == "no number");
    }
}

CHECK_THAT("the figures have the losses, and the circle with its lines")
{
  for(const Told& now : told_at(""))
  {
    for(const auto& point : now.points("lost", 6))
    {
      const Fifty eta(point.at("eta")), s = sin(eta / 2), K = swing::oracle::K_from_complement(s);
      const Fifty rounding = ldexp(Fifty(1), -54) / (s * s * K);
      CHECK(point.value("rounding") == within_relative(rounding, 1e-15, "squares and quotients"));
      CHECK(point.value("from_eta") == between(0, 2e-16, "the library's bound"));
      if(point.at("eta") > 1e-7)
        CHECK(point.value("from_c")
              == between(0, 1.5 * static_cast<double>(rounding) + 6e-16, "as the check above"));
    }
    const auto plate = now.points("plate");
    for(std::size_t i = 0; i < 40; i += 7)
    {
      const Fifty x(plate.at(i).at("x"));
      CHECK(plate.at(i).value("y")
            == within(-sqrt(1 - x * x) * (plate.at(i).at("y") > 0 ? -1 : 1), 1e-7, "the circle"));
    }
    const Fifty ends[] = {sin(swing_.eta.fifty()), cos(swing_.eta.fifty())};
    bool has_g = false;
    for(const auto& point : plate)
      has_g = has_g
              || (abs(Fifty(std::abs(point.at("x"))) - ends[0]) < 1e-15
                  && abs(point.at("y") - ends[1]) < 1e-15);
    CHECK(has_g);
  }
}

CHECK_THAT("a place nearer to the top than the start is refused, and the start itself is not")
{
  for(const char* const from_it : {"eta=60 psi=60", "eta=1e-200rad psi=1e-200rad"})
    CHECK(!refused_at(from_it));
  for(const char* const before_it :
      {"eta=60 psi=59.99999999999997", "eta=1e-200rad psi=9.99999999999999e-201rad"})
    CHECK(refused_at(before_it));
}

/*!
## Go on from here

::: exercise
How near to the top must a pendulum be let go for one swing to last a hundred of its smallest ones? Near
the top $T/\Theta$ is $\frac2\pi\,l\frac8\eta$.

answer: $\eta = 8e^{-50\pi}$, or $4.83\cdot10^{-68}$ of a radian: no experiment comes near it. The program
tells $50\pi$ for the descent with `--eta 4.8336e-68rad`.
:::
*/

CHECK_THAT("from 8e^(−50π) of a radian one swing lasts a hundred of the smallest")
{
  CHECK(8 * exp(-50 * exact::pi()) == within_relative(4.83361766e-68, 1e-8, "nine digits"));
  for(const Told& now : told_at("eta=4.83361766265925e-68rad"))
    CHECK(now.value("descent") == within_relative(50 * exact::pi(), 1e-15, "fifteen digits of η"));
}
