#include <gsl/gsl_sf_ellint.h>

#include "edition/section.hpp"
#include "pendulum/series.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 11, "The whole series, the semicircle, and the swing without end")

using pendulum::ratio_by_mean, pendulum::series;

/*!
## What Euler does

For wide arcs all the terms of the series are wanted, and two cases invite a trial: the semicircle and the
whole circle. In {{sec pendulum.10}} he kept one term and found the rule of the sagitta. Let $\Theta$ again be
the time of an infinitely small swing of the same pendulum, $b$ its equivalent length $AO$, and $d$ the sagitta
$BD$, the height through which the centre of oscillation $O$ rises. Since $cc = d/2b$, the time of one swing is

$$ T = \Theta\left(1 + \frac{1^2}{2^2}\cdot\frac{d}{2b} + \frac{1^2\cdot3^2}{2^2\cdot4^2}\cdot\frac{dd}{4bb}
   + \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}\cdot\frac{d^3}{8b^3} + \text{etc.}\right). \tag{1} $$

::: margin
Today: $T = \Theta\cdot\frac{2}{\pi}K(c)$, a series in $c^2 = \sin^2\tfrac12\zeta$. A *swing* is from one
side to the other, half the modern period.
:::

When the pendulum describes a whole semicircle,
$\zeta = 90°$, the sagitta is the length itself, $d = b$, and

$$ T = \Theta\left(1 + \frac{1^2}{2^2}\cdot\frac12 + \frac{1^2\cdot3^2}{2^2\cdot4^2}\cdot\frac14
   + \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}\cdot\frac18 + \text{etc.}\right), \tag{2} $$

which he sums to $1{,}1805\,\Theta$, nearly in the ratio 5 to 6. From there on the times keep growing; and
if the pendulum is to go through the whole circle the time is infinite, as it must be: once it has been
brought to the top it stays there and never falls. The calculation shows the same, for then $d = 2b$ and
every power of $cc$ is 1,

$$ \frac{T}{\Theta} = 1 + \frac{1^2}{2^2} + \frac{1^2\cdot3^2}{2^2\cdot4^2} + \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}
   + \text{etc.}, \tag{3} $$

and the integral from which the series came becomes one that he can do,

$$ \int_0^1 \frac{dz}{1-zz} = \tfrac12\,l\,\frac{1+z}{1-z}\;\Big|_{z=1} = \infty. \tag{4} $$

## The program

The coefficients are the squares of $a_n = \tfrac12\cdot\tfrac34\cdots\tfrac{2n-1}{2n}$, and each term is
the last one times a fraction. The same few lines serve in double precision and in fifty digits;
{{sec pendulum.08}} derives them.

::: code pendulum/series.hpp series
:::

What it should sum to is known in another way, which Gauss found later:
$T/\Theta = 1/M(1, \cos\tfrac12\zeta)$, where $M$ is the arithmetic-geometric mean. Here it is the judge. It
takes $\cos\tfrac12\zeta$ as $\sin\tfrac12\eta$, with $\eta = 180° - \zeta$, because near the top the cosine
of a rounded $\tfrac12\zeta$ has lost what matters.

::: code pendulum/series.hpp ratio_by_mean
:::

And for the swing without end: the sum of $n$ terms of {{eq 3}} grows like a logarithm. These sums are
today called Landau's constants, and the law of their growth is known.
*/

const double landau_constant = static_cast<double>(exact::euler_gamma() + 4 * exact::ln2());

double sum_at_the_top(double terms)  // (3), nearly
{
  return (std::log(terms - 0.25) + landau_constant) / std::numbers::pi;
}

/*!
The reader may change the amplitude, the length, and how many terms are kept.
*/

const auto swing_ = amplitude(90_deg, closed(0_deg, 180_deg));
const auto b = real("b", 1.0, metres, positive, "length of the equivalent simple pendulum, AO");
const auto n = integer("n", 5, 1, 1'000'000, "terms of the series that are kept; Euler writes five");

TELL
{
  const double sine = std::sin(swing_.zeta / 2);
  const double exact = swing::ratio({swing_.zeta, swing_.eta});
  const double kept = series(sine * sine, n);
  tell("d", 2 * b * sine * sine, metres, "the sagitta BD, how high O rises");
  tell("T_over_Theta", ratio_by_mean(swing_.eta.fifty()), "one swing, the infinitely small swing being 1");
  tell("kept", kept, "the first n terms of (1)");
  tell("short_by", exact - kept, "what they leave out");
  tell("semicircle", ratio_by_mean(exact::pi() / 2), "the same for ζ = 90°");
  tell("five_to_six", 1.2 / swing::ratio_from_top(90_deg) - 1, percent, "by how much 5 : 6 is too large");
  tell("to_pass_ten", std::exp(10 * std::numbers::pi - landau_constant),
       "terms of (3) until their sum passes ten");
}

/*!
The figures: the ratio over all amplitudes, and how the sums of more and more terms go towards it or, at the
top, go on for ever.
*/

TELL
{
  curve("ratio", {"zeta", "exact", "five_terms", "near_the_top"}, [](Curve& c) {
    for(double zeta = 0; zeta < 180; zeta += zeta < 178 ? 0.5 : 0.01)
    {
      const double eta = (180 - zeta) * 1_deg;
      const double sine = std::cos(eta / 2);
      c.put({zeta, swing::ratio({zeta * 1_deg, eta}), series(sine * sine, 5),
             2 / std::numbers::pi * std::log(8 / eta)});
    }
  });
  curve("sums", {"terms", "sum"}, [](Curve& c) {
    for(const double zeta : {90_deg, 150_deg, 170_deg, 178_deg, 180_deg})
    {
      for(int terms = 1; terms <= 100'000; terms += 1 + terms / 20)
        c.put({static_cast<double>(terms), series(std::pow(std::sin(zeta / 2), 2), terms)});
      c.block();
    }
  });
}

/*!
The ways to the number, side by side. Which of them is the best depends on the amplitude: try `--zeta 175
--bench`.
*/

TELL
{
  const double zeta = swing_.zeta;
  const double eta = swing_.eta;
  const double c = std::sin(zeta / 2);
  if(eta == 0)
    return;  // nothing finite to compare
  std::vector<Method> ways;
  for(const int terms : {5, 12, 24, 44})
    ways.push_back({"Euler's series, " + std::to_string(terms) + " terms",
                    [=] { return series(c * c, terms); }, "series"});
  ways.push_back({"arithmetic-geometric mean", [=] { return ratio_by_mean(eta); }});
  ways.push_back({"GSL, of the modulus",
                  [=] { return gsl_sf_ellint_Kcomp(c, GSL_PREC_DOUBLE) * 2 / std::numbers::pi; }});
  ways.push_back({"this edition", [=] { return swing::ratio({zeta, eta}); }});
  race("ratio", "T/Θ", ratio_by_mean(swing_.eta.fifty()), ways);
}

/*!
For the semicircle the five terms that Euler writes give {{kept|8}}, and {{short_by|e2}} is still to come.
At 90° the terms fall by half from one to the next, so that a handful is soon enough; at 150° they fall
slowly, and at the top not at all.

::: figure pendulum-11
alt: The ratio T/Θ against the amplitude. It leaves 1 slowly, passes 1.18 at 90 degrees and climbs steeply
to infinity at 180 degrees. The sum of five terms follows it up to about 100 degrees and then stays behind,
ending at 1.6.

The time of one swing, in units of the infinitely small swing, against the amplitude. Five terms of {{eq 1}}
serve to a little beyond the semicircle. Near the top the time grows like $\frac2\pi\ln(8/\eta)$, so slowly
that at 179° it is not yet four times what it was.
:::

::: figure pendulum-11-sums
alt: Sums of the series against the number of terms, on a logarithmic scale. All curves begin on one
straight line; the one for 90 degrees leaves it after a few terms, those for 150, 170 and 178 degrees later,
the one for 180 degrees never.

How the sums of {{eq 1}} grow with the number of terms. Every amplitude begins on the same straight line,
which is the divergent series {{eq 3}}; the wider the swing, the later its terms begin to fail and the sum
turns off to its value. For 180° it never does, but it is in no hurry: to pass 10 it needs
{{to_pass_ten|e4}} terms.
:::

## Checks

Euler's sum for the semicircle first. The number has a closed form in the Gamma function, and three routes
to it agree to fifty digits.
*/

CHECK_THAT("the series for the semicircle sums to Γ(¼)²/(2π√π), and so does the mean")
{
  const Fifty closed_form = pow(tgamma(Fifty(0.25)), 2) / (2 * pow(exact::pi(), Fifty(1.5)));
  CHECK(series(Fifty(0.5), 180) == within(closed_form, 1e-48, "180 halvings leave less than 2⁻¹⁸⁰"));
  CHECK(ratio_by_mean(exact::pi() / 2) == within(closed_form, 1e-48, "a dozen roundings of fifty digits"));
  CHECK(swing::ratio({90_deg, 90_deg})
        == within_ulps(closed_form, 2, "the library's own bound, and π/2 rounded"));
}

/*!
So $T/\Theta$ = {{semicircle|30}}, and what is printed, 1,1805, is too large by one and a half units of its
fourth digit. It cannot come from stopping too early: the sums only grow, and they stay below their limit. A
3 read or set as a 5 would explain it; the scan alone does not tell whose slip it was.
*/

const Doubtful one_digit{"§11, T at 90°",
                         {"1,1805", 1.1805},
                         {"1,1803", 1.1803},
                         "all sums of the series stay below 1.18035, and their limit is 1.18034",
                         [](double reading) {
                           return ratio_by_mean(exact::pi() / 2)
                                  == within(reading, 0.5e-4, "half a unit of the fourth place");
                         }};

CHECK_THAT("no number of terms gives what is printed for the semicircle")
{
  for(int terms = 1; terms < 60; ++terms)
    CHECK(series(0.5, terms) == between(1, 1.18034060, "the sums grow towards 1.180340599"));
}

/*!
The ratio 5 : 6 is a rough one. Of ratios in whole numbers up to a hundred the nearest is 61 : 72.
*/

const Erratum whole_numbers{
    "§11, Θ : T in whole numbers",
    {"5 : 6", 6.0 / 5},
    {"61 : 72", 72.0 / 61},
    "5 : 6 is too large by a sixtieth; he calls it very near",
    [](double reading) {
      return reading == within_relative(ratio_by_mean(exact::pi() / 2), 1e-3, "near, to a thousandth");
    }};

/*!
The integral {{eq 4}} has lost a square in the scan, and its logarithm has gained a 2. The proof is that
each must be the derivative of the other, here at $z = 0{,}4$.
*/

const Emendation integrand{
    "§11, the integral for c = 1",
    {"dz/(1 − 2z)", 1 / (1 - 2 * 0.4)},
    {"dz/(1 − zz)", 1 / (1 - 0.4 * 0.4)},
    "with c = 1 the root of §7 is 1 − zz, and only that is the derivative of the logarithm",
    [](double reading) {
      const double slope =
          (std::atanh(0.4 + 1e-5) - std::atanh(0.4 - 1e-5)) / 2e-5;  // atanh z is ½ l((1+z)/(1−z))
      return reading == within(slope, 1e-9, "the third derivative times 10⁻¹⁰ over six");
    }};

const Emendation logarithm{"§11, the logarithm",
                           {"½ l (1+z)/(1−2z)", std::log(1.4 / 0.2) / 2},
                           {"½ l (1+z)/(1−z)", std::log(1.4 / 0.6) / 2},
                           "it is the integral of dz/(1 − zz) from 0, and infinite only at z = 1",
                           [](double reading) {
                             double sum =
                                 0;  // the integral up to z = 0.4, term by term: z + z³/3 + z⁵/5 + ...
                             for(int k = 61; k > 0; k -= 2)
                               sum += std::pow(0.4, k) / k;
                             return reading == within_ulps(sum, 4, "thirty terms, each rounded");
                           }};

const Emendation number{"§11, the section's number",
                        {"§. II", 2},
                        {"§. 11", 11},
                        "it follows §. 10 and precedes §. 12",
                        [](double reading) { return reading > 10 && reading < 12; }};

/*!
The divergent series. Landau's law gives its sums closely enough to say how many terms it takes to pass ten;
no machine will add so many.
*/

CHECK_THAT(
    "the sums for the full circle grow as the logarithm of the number of terms, with Landau's constant")
{
  for(const int terms : {1, 10, 100, 1000, 10'000})
  {
    const double beyond = std::numbers::pi * (series(1.0, terms) - sum_at_the_top(terms));
    const double width = 11.0 / 192 / std::pow(terms - 0.25, 2);
    CHECK(beyond
          == between(-1e-13, width + 1e-13, "Landau's next term is 11/192 n², and 10⁴ additions round"));
  }
}

CHECK_THAT("at 180° the time is infinite, but the double nearest π is not 180°")
{
  CHECK(std::isinf(swing::ratio({180_deg, 0})));
  const double short_of_pi = 1.22464679914735317723e-16;  // π less the double nearest to it
  CHECK(swing::ratio({180_deg, short_of_pi})
        == within_ulps(ratio_by_mean(Fifty(short_of_pi)), 2, "the library's own bound"));
}
