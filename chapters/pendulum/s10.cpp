#include "edition/section.hpp"
#include "exact/series.hpp"
#include "pendulum/equation.hpp"
#include "pendulum/series.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 10, "Small arcs: the rule of the sagitta")

using pendulum::ratio_by_mean, pendulum::series;

/*!
## What Euler does

The series of {{sec pendulum.09}} shows at once that a swing through a larger arc takes longer, since
$c = \sin\tfrac12\zeta$ grows with the arc. To see by how much, he lets $cc$ be so small that $c^4$, $c^6$ and
all higher powers can be left out. Let $\Theta$ be the time of an infinitely small swing of the same pendulum;
then

$$ T = \Theta(1 + \tfrac14 cc),\qquad\text{or}\qquad \Theta : T = 1 : 1 + \tfrac14 cc. \tag{1} $$

That is good for small swings. For larger ones more terms have to be taken.

Next he makes the formula fit for use, where one measures lengths and not sines. Let the pendulum $AGO$ be at
its greatest excursion, with $G$ the centre of gravity and $O$ the centre of oscillation, so that
$AO = b = \frac{aa+kk}{a}$. From $O$ a horizontal line is drawn to $D$ on the vertical $AB$. Then

$$ OD = b\sin\zeta,\qquad AD = b\cos\zeta, \tag{2} $$

and what is left of $AB$, the sagitta of the arc, is

$$ BD = b(1-\cos\zeta) = 2b\sin^2\tfrac12\zeta = 2bcc. \tag{3} $$

::: margin
A sagitta, an arrow, is the height of an arc over, or here below, its chord. Today: the height $h$ from which
$O$ falls.
:::

This height is easily measured, for any amplitude. Call it $d$; then $cc = d/2b$, and for small swings

$$ \Theta : T = 1 : 1 + \frac{d}{8b},\qquad\text{or}\qquad \Theta : T = 8b : 8b + d. \tag{4} $$

In the letters of the figure it is $8AB : 8AB + BD$, and this, he says, is the rule that experimenters
everywhere use.

::: figure pendulum-10
alt: From A hang AB, vertical, and AO, slanted, equally long, G on it; a level line joins O to D on AB.

Euler's Fig. 3, to scale. The rule needs two lengths: $AB$, which is $AO$, and the sagitta $BD$ by which $O$
has risen.
:::

## The program

Everything in {{eq 2}} and {{eq 3}} is one line. The sagitta is formed from the sine of half the angle: the
difference $1 - \cos\zeta$ has no digits left when the swing is small.
*/

struct Figure
{
  double b, OD, AD, BD;
};

Figure figure(double a, double k, double zeta)  // (2), (3)
{
  const double b = pendulum::equivalent_length(a, k);
  return {b, b * std::sin(zeta), b * std::cos(zeta), 2 * b * std::pow(std::sin(zeta / 2), 2)};
}

double rule(double b, double d)  // (1), (4)
{
  return (8 * b + d) / (8 * b);
}

/*!
What the rule leaves out begins with $\tfrac9{64}c^4$, and the terms after it fall at least as fast as the
powers of $cc$. So much is sure:

$$ \tfrac9{64}c^4 < \frac T\Theta - \left(1+\tfrac14cc\right) < \frac{\tfrac9{64}c^4}{1-cc}. \tag{5} $$

The correction itself, $T/\Theta - 1$, must not be had by subtraction. The mean of {{sec pendulum.11}} gives
it without: what the two numbers of each step differ by is known from the step before, and $1 - M$ is the sum
of these halves.
*/

template <class Real>
Real excess_by_mean(Real zeta, Real eta)  // T/Θ − 1
{
  using std::sin, std::sqrt;
  Real a = 1, g = sin(eta / 2), half_gap = sin(zeta / 4) * sin(zeta / 4);  // ½(a − g)
  Real sum = 0;
  while(sum + half_gap != sum)
  {
    sum += half_gap;
    const Real mean = (a + g) / 2;
    g = sqrt(a * g);
    a = mean;
    half_gap *= half_gap / (2 * (a + g));
  }
  return sum / (1 - sum);
}

/*!
Free are the two lengths that make the pendulum, $a$ and $k$, and the amplitude.
*/

const auto a = real("a", 0.8, metres, positive, "AG, from the axis to the centre of gravity");
const auto k = real("k", 0.4, metres, nonnegative, "radius of gyration about G");
const auto swing_ = amplitude(30_deg);

TELL
{
  const auto [b, OD, AD, BD] = figure(a, k, swing_.zeta);
  const double excess = swing::ratio_excess({swing_.zeta, swing_.eta});
  tell("b", b, metres, "AO = AB, the length of the equivalent simple pendulum");
  tell("OD", OD, metres, "how far O is from the vertical");
  tell("AD", AD, metres, "how far D is below the axis");
  tell("d", BD, metres, "the sagitta BD");
  tell("T_over_Theta", 1 + excess, "one swing, the infinitely small swing being 1");
  tell("rule", rule(b, BD), "the same by the rule (4)");
  const double cc = BD / b / 2, least = 9. / 64 * cc * cc;
  tell("least", least, "by how much the rule falls short, at least");
  tell("most", least / (1 - cc), "and at most, by (5)");
  tell("day", 86400 * excess, seconds, "how much longer 86400 swings of one second take for being so wide");
  const double d = 8 * b / 86400;
  tell("d_second", d, metres, "sagitta at which it loses one second a day, by the rule");
  tell("zeta_second", 2 * std::asin(std::sqrt(d / b / 2)), degrees, "and the amplitude that belongs to it");
}

/*!
The rule for a few amplitudes: the correction to a small swing, the part of it that the rule misses, and what
the two make in 86400 swings of one second, a clock's day.
*/

TELL
{
  auto& rows = table("rows", "The correction T/Θ − 1, and what the rule misses of it",
                     {{"zeta", "ζ", degrees},
                      {"excess", "T/Θ − 1", none, 8},
                      {"missed", "missed", none, 6},
                      {"day", "in 86400 s", seconds, 6},
                      {"day_missed", "missed in 86400 s", seconds, 3}});
  for(const double zeta : {1_deg, 5_deg, 10_deg, 15_deg, 20_deg, 30_deg, 60_deg, 90_deg})
  {
    const Fifty exact = excess_by_mean(Fifty(zeta), exact::pi() - zeta);
    const double excess = static_cast<double>(exact);
    const double missed = static_cast<double>(exact - pow(sin(Fifty(zeta) / 2), 2) / 4);
    rows.row({zeta, excess, missed, 86400 * excess, 86400 * missed});
    if(zeta == 10_deg)
      tell("missed_10", 86400 * missed, seconds, "what the rule misses in 86400 swings of 10°");
    if(zeta == 30_deg)
      tell("missed_30", 86400 * missed, seconds, "and in as many of 30°");
  }
  curve("missed", {"zeta", "excess", "missed", "least", "most"}, [](Curve& c) {
    for(double degree = 0.1; degree < 179.9; degree = std::min(degree * 1.06, 180 - (180 - degree) / 1.3))
    {
      const Fifty zeta = exact::pi() * degree / 180, cc = pow(sin(zeta / 2), 2);
      const Fifty excess = excess_by_mean(zeta, exact::pi() - zeta), least = Fifty(9) / 64 * cc * cc;
      std::vector<double> row = {degree};
      for(const Fifty& height : {excess, excess - cc / 4, least, least / (1 - cc)})
        row.push_back(static_cast<double>(height));
      c.put(row);
    }
  });
}

/*!
And the figure's own lines and points.
*/

TELL
{
  const Figure f = figure(a, k, swing_.zeta);
  curve("points", {"x", "y"}, [=](Curve& c) {
    const double share = a / f.b, half = swing_.zeta / 2;
    c.put({0, 0});                                                       // A
    c.put({0, -f.b});                                                    // B
    c.put({0, -f.AD});                                                   // D
    c.put({0, (-f.b - f.AD) / 2});                                       // in the middle of d
    c.put({f.OD, -f.AD});                                                // O
    c.put({f.OD * share, -f.AD * share});                                // G
    c.put({f.OD / 2, -f.AD / 2});                                        // in the middle of b
    c.put({0.22 * f.b * std::sin(half), -0.22 * f.b * std::cos(half)});  // within ζ
  });
  curve("lines", {"x", "y"}, [=](Curve& c) {
    for(const auto& [x, y] : {std::pair{0., -f.b}, {0., 0.}, {f.OD, -f.AD}, {0., -f.AD}})
      c.put({x, y});
  });
  curve("arc", {"x", "y", "mark_x", "mark_y"}, [=](Curve& c) {
    for(int i = 0; i <= 60; ++i)
    {
      const double phi = swing_.zeta * i / 60, x = f.b * std::sin(phi), y = -f.b * std::cos(phi);
      c.put({x, y, 0.2 * x, 0.2 * y});
    }
  });
}

/*!
The ways to the correction. Try `--zeta 1e-6 --bench`: the difference of two numbers near 1 is then worth
nothing.
*/

TELL
{
  const double zeta = swing_.zeta, eta = swing_.eta, cc = std::pow(std::sin(zeta / 2), 2);
  race("excess", "T/Θ − 1", excess_by_mean(Fifty(zeta), Fifty(eta)),
       {{"the rule", [=] { return cc / 4; }},
        {"the ratio less 1",
         [=] {
           return swing::ratio({zeta, eta}) - 1;
         }},
        {"the series less 1, 12 terms", [=] { return series(cc, 12) - 1; }},
        {"the mean's differences", [=] { return excess_by_mean(zeta, eta); }},
        {"this edition", [=] {
           return swing::ratio_excess({zeta, eta});
         }}});
}

/*!
A clock whose pendulum swings {{zeta_second|3}}° to each side loses a second a day, and there the rule is
perfect. Even at 10° to each side it is wrong by no more than {{missed_10|2}} seconds in 86400 swings, but at
30° by {{missed_30|3}}.

::: figure pendulum-10-missed
alt: On logarithmic axes the correction rises with slope two, and below it what the rule misses, with four.

The whole correction, and what the rule misses of it, against the amplitude. The one grows as the square of
the arc, the other as its fourth power. The grey lines are the bounds {{eq 5}}; they part only where nobody
would use the rule.
:::

## Checks

The figure's lengths, and the rule against the mean: the bounds {{eq 5}} hold at every degree.
*/

CHECK_THAT("the sagitta is what AD lacks of AB, and OD and AD are the sides of a right angle")
{
  for(const double zeta : {1e-9_rad, 1_deg, 30_deg, 90_deg, 170_deg})
  {
    const auto [b, OD, AD, BD] = figure(0.8, 0.4, zeta);
    CHECK(b == within_ulps(Fifty(1), 2, "a product, a quotient and a sum"));
    CHECK(std::hypot(OD, AD) == within_ulps(Fifty(b), 4, "sine, cosine, and two factors"));
    CHECK(BD == within(b - Fifty(AD), 4e-16, "AD carries no more digits"));
    CHECK(BD == within_ulps(b * (1 - cos(Fifty(zeta))), 6, "a sine counts twice, and three factors"));
  }
}

CHECK_THAT("the rule falls short, and by an amount between the bounds, at every degree")
{
  for(int degree = 1; degree < 180; ++degree)
  {
    const Fifty zeta = exact::pi() * degree / 180, cc = pow(sin(zeta / 2), 2);
    const double in_double = rule(1, figure(0.8, 0.4, static_cast<double>(zeta)).BD);
    CHECK(in_double == within_ulps(1 + cc / 4, 2, "the sum's rounding and the quotient's"));
    const Fifty missed = ratio_by_mean(exact::pi() - zeta) - 1 - cc / 4;
    const Fifty least = Fifty(9) / 64 * cc * cc;
    CHECK(missed == between(least, least / (1 - cc), "coefficients below 9/64 but positive"));
  }
}

/*!
The correction without cancellation, down to swings that nobody could see. There it is
$\tfrac1{16}\zeta\zeta$, with the next term far below the last digit.
*/

CHECK_THAT("T/Θ − 1 keeps all its digits, from a swing of 1e-150 to one that nearly reaches the top")
{
  for(const double zeta : {1e-150_rad, 1e-100_rad, 1e-8_rad})
  {
    const Fifty exact = Fifty(zeta) * zeta / 16 * (1 + Fifty(11) * zeta * zeta / 192);
    CHECK(excess_by_mean(zeta, 180_deg - zeta) == within_ulps(exact, 4, "a sine counts twice"));
    const auto narrow = swing::Amplitude::from_zeta(zeta);
    CHECK(swing::ratio_excess(narrow) == within_ulps(exact, 4, "a polynomial in ζζ"));
  }
  for(const double zeta : {1_deg, 60_deg, 150_deg, 179_deg})
  {
    const auto wide = swing::Amplitude::from_zeta(zeta);
    const Fifty exact = ratio_by_mean(exact::pi() - zeta) - 1;
    const Fifty excess = excess_by_mean(Fifty(zeta), exact::pi() - zeta);
    CHECK(excess == within(exact, 1e-47, "fifty digits less the cancelled ones"));
    CHECK(swing::ratio_excess(wide) == within_ulps(exact, 6, "beyond 90° a mild difference"));
  }
}

/*!
At the other end it is the height still missing to the top that has to be given, $2b - d$: at $10^{-20}b$ the
ratio $d/2b$ is 1 in double precision.
*/

CHECK_THAT("the sagitta may come within 1e-20 of the whole diameter")
{
  const Fifty eta = 2 * asin(sqrt(Fifty("1e-20") / 2));
  CHECK(ratio_by_mean(eta) == printed("15.7618899783518127844569373031"));
  const double nearly = swing::ratio(swing::Amplitude::from_depth(1e-20));
  CHECK(nearly == within_ulps(ratio_by_mean(eta), 2, "the library's own bound"));
}

/*!
Two words of the text cannot stand. One is certain: what grows with the arc is $c$; $t$ is the time.
*/

const Emendation letter{
    "§10, the quantity that grows",
    {"t = sin ½ζ", [] { return swing::quarter_time(swing::Amplitude::from_zeta(60_deg)); }},
    {"c = sin ½ζ", [] { return swing::Amplitude::from_zeta(60_deg).modulus(); }},
    "§7 calls it c; the proof is for ζ = 60°, and t is taken in units √(b/2g)",
    [](double reading) { return reading == within_ulps(Fifty(0.5), 2, "the sine of 30°"); }};

/*!
The other makes the swings through larger arcs quicker, against the formula that follows two lines below. Who
slipped cannot be told.
*/

const Doubtful smaller{"§10, the times of swings through larger arcs",
                       {"smaller (minora)", -1},
                       {"greater (maiora)", 1},
                       "T/Θ grows with every degree from 0° to 179°",
                       [](double sign) {
                         const auto excess = [](int degree) {
                           return swing::ratio_excess(swing::Amplitude::from_zeta(degree * 1_deg));
                         };
                         bool holds = true;
                         for(int degree = 1; degree < 180; ++degree)
                           holds = holds && sign * (excess(degree) - excess(degree - 1)) > 0;
                         return holds;
                       }};

/*!
## Notes

In powers of the angle itself the correction is

$$ \frac T\Theta = 1 + \frac{\zeta^2}{16} + \frac{11\,\zeta^4}{3072} + \frac{173\,\zeta^6}{737280}
   + \frac{22931\,\zeta^8}{1321205760} + \cdots \tag{6} $$

Euler's series in $\sin\tfrac12\zeta$ gives it, in exact fractions.
*/

CHECK_THAT("the series in the sine turns into the series in the angle")
{
  using exact::Series;
  const auto half = Series<Rational>({Rational(0), Rational(1, 2)}, 9);
  const auto sine = exact::sin(half);
  Series<Rational> sum = Series<Rational>({Rational(0)}, 9);
  for(int n = 0; n <= 4; ++n)
    sum += pow(sine, 2 * n) * Series<Rational>(pow(exact::double_factorial_ratio(n), 2));
  CHECK(sum[2] == Rational(1, 16));
  CHECK(sum[4] == Rational(11, 3072));
  CHECK(sum[6] == Rational(173, 737280));
  CHECK(sum[8] == Rational(22931, 1321205760));
}
