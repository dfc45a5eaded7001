#include "edition/section.hpp"
#include "exact/series.hpp"
#include "pendulum/equation.hpp"
#include "pendulum/series.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 10, "Small arcs: the rule of the sagitta")

using pendulum::series;
using swing::Amplitude;
namespace oracle = swing::oracle;

/*!
## What Euler does

For small arcs two terms of the series make a rule that needs no sines, only two lengths. The formula of
{{sec pendulum.09}} shows that a swing through a larger arc takes somewhat longer {{entry smaller}}, since
$c = \sin\tfrac12\zeta$ {{entry letter}} grows with the arc. To see it more clearly he takes $cc$ so small
that its higher
powers $c^4$, $c^6$ etc. can be neglected. Let $\Theta$ be the time of an infinitely small swing of the same
pendulum, $\Theta = \pi\sqrt b/\sqrt{2g}$; then

$$ \begin{gathered} T = \Theta(1 + \tfrac14 cc),\quad\text{or} \\
   \Theta : T = 1 : 1 + \tfrac14 cc. \end{gathered} \tag{1} $$

This holds for swings that are small enough; for larger arcs more terms of the series have to be taken.

For practical use let the pendulum $AGO$ be at its greatest excursion, $BAO = \zeta$, with $G$ the centre of
gravity and $O$ the centre of oscillation, so that $AO = b = \frac{aa+kk}{a}$. The horizontal $OD$ is drawn
to the vertical $AB$. Then

$$ OD = b\sin\zeta,\qquad AD = b\cos\zeta, \tag{2} $$

and the sagitta is

$$ \begin{aligned} BD &= b(1-\cos\zeta) \\ &= 2b\sin^2\tfrac12\zeta = 2bcc. \end{aligned} \tag{3} $$

::: margin
The *sagitta*, arrow, of an arc is the height between arc and chord. Today: the height $h$ through which $O$
rises.
:::

This interval is easily measured when the amplitude is given. Call it $d$; then $cc = d/2b$, and for swings
that are small enough

$$ \Theta : T = 1 : 1 + \frac{d}{8b} = 8b : 8b + d, \tag{4} $$

that is, as $8AB$ to $8AB + BD$. This rule, he says, is already in common use among experimenters.

::: figure pendulum-10
alt: From A hang AB, vertical, and AO, slanted, equally long, G on it; a level line joins O to D on AB.

Euler's Fig. 3, to scale. The rule needs two lengths: $AB$, which is $AO$, and the sagitta $BD$ by which $O$
has risen.
:::

## The program

The sagitta is formed from the sine of half the angle: for a small swing the difference $1 - \cos\zeta$ would
have no digits left.
*/

struct Figure
{
  double b, OD, AD, BD;
};

Figure figure(double a, double k, Amplitude to)  // (2), (3)
{
  const double b = pendulum::equivalent_length(a, k), s = std::sin(to.zeta / 2);
  return {b, b * std::sin(std::min(to.zeta, to.eta)), b * std::cos(to.zeta), 2 * b * s * s};
}

double rule(double b, double d)  // (1), (4)
{
  return (8 * b + d) / (8 * b);
}

/*!
What the rule misses begins with $\tfrac9{64}c^4$, and each later term is less than $cc$ times the one
before; so

$$ \tfrac9{64}c^4 < \frac T\Theta - \left(1+\tfrac14cc\right) < \frac{\tfrac9{64}c^4}{1-cc}. \tag{A} $$

The correction itself, $T/\Theta - 1$, must not be formed by subtraction, which would lose the digits of a
small one. The library has {{api swing::ratio_excess}} for it.
*/

double in_a_day(double excess)  // of so many swings of a second
{
  return 86400 * excess;
}

double sagitta_for(double seconds_a_day, double b)  // by (4)
{
  return 8 * b * (seconds_a_day / 86400);
}

double amplitude_of(double sagitta_over_b)  // by (3)
{
  return 2 * std::asin(std::sqrt(sagitta_over_b / 2));
}

const auto a = real("a", 0.8, metres, scale, "AG, from the axis to the centre of gravity");
const auto k = real("k", 0.4, metres, closed(0, 1e100), "radius of gyration about G");
const auto swing_ = amplitude(30_deg);

TELL
{
  const auto [b, OD, AD, BD] = figure(a, k, {swing_.zeta, swing_.eta});
  const double excess = swing::ratio_excess({swing_.zeta, swing_.eta});
  tell("b", b, metres, "AO = AB, the length of the equivalent simple pendulum");
  tell("OD", OD, metres, "how far O is from the vertical");
  tell("AD", AD, metres, "how far D is below the axis");
  tell("d", BD, metres, "the sagitta BD");
  tell("T_over_Theta", 1 + excess, "one swing, the infinitely small swing being 1");
  tell("rule", rule(b, BD), "the same by the rule (4)");
  tell("day", in_a_day(excess), seconds,
       "how much longer 86400 swings of one second take for being so wide");
  const double d = sagitta_for(1, b);
  tell("d_second", d, metres, "sagitta at which it loses one second a day, by the rule");
  tell("zeta_second", amplitude_of(d / b), degrees, "and the amplitude that belongs to it");
}

double missed(double zeta)
{
  return static_cast<double>(oracle::ratio_excess(zeta) - pow(sin(Fifty(zeta) / 2), 2) / 4);
}

TELL
{
  auto& rows =
      table("rows", "The correction, and what the rule misses of it",
            {{"zeta", "ζ", degrees}, {"excess", "T/Θ − 1", none, 8}, {"missed", "missed", none, 6}});
  for(const double zeta : {1_deg, 5_deg, 10_deg, 15_deg, 20_deg, 30_deg, 60_deg, 90_deg})
    rows.row({zeta, swing::ratio_excess(Amplitude::from_zeta(zeta)), missed(zeta)});
  tell("missed_10", in_a_day(missed(10_deg)), seconds, "what the rule misses in 86400 swings of 10°");
  tell("missed_30", in_a_day(missed(30_deg)), seconds, "and in as many of 30°");
}

TELL
{
  curve("corrections", {"zeta", "excess", "missed", "least", "most"}, [](Curve& c) {
    for(double degree = 0.1; degree < 179.9; degree += degree < 100 ? degree / 16 : (180 - degree) / 8)
    {
      const Fifty zeta = exact::pi() * degree / 180, cc = pow(sin(zeta / 2), 2);
      const Fifty excess = oracle::ratio_excess(zeta), least = Fifty(9) / 64 * cc * cc;
      std::vector<double> row = {degree};
      for(const Fifty& height : {excess, excess - cc / 4, least, least / (1 - cc)})
        row.push_back(static_cast<double>(height));
      c.put(row);
    }
  });
  const Figure f = figure(a, k, {swing_.zeta, swing_.eta});
  curve("points", {"x", "y"}, [=](Curve& c) {  // B, A, O, D; G; in the middle of d
    for(const auto& [x, y] : {std::pair{0., -f.b}, {0., 0.}, {f.OD, -f.AD}, {0., -f.AD}})
      c.put({x, y});
    c.put({f.OD * a / f.b, -f.AD * a / f.b});
    c.put({0, (-f.b - f.AD) / 2});
  });
  curve("arc", {"x", "y"}, [=](Curve& c) {
    for(int i = 0; i <= 60; ++i)
      c.put({f.b * std::sin(swing_.zeta * i / 60), -f.b * std::cos(swing_.zeta * i / 60)});
  });
}

/*!
{{table rows}}

Swings of {{zeta_second|3}} to each side lose a second a day against infinitely small ones, and there the
rule is all that is needed. At 10° to each side it is wrong by only {{missed_10|2}} seconds in a day, at 30°
by {{missed_30|3}}.

::: figure pendulum-10-missed
alt: On logarithmic axes the correction rises with slope two, and below it what the rule misses, with four.

The whole correction, and what the rule misses of it, against the amplitude. The one grows as the square of
the arc, the other as its fourth power. The grey lines are the bounds {{eq A}}; they part towards the top.
:::

## Speed against error

The ways to the correction. With `--zeta 1e-6 --bench` the difference of two numbers near 1 is left with
no digit.
*/

TELL
{
  const double zeta = swing_.zeta, eta = swing_.eta, cc = std::pow(std::sin(zeta / 2), 2);
  const Fifty exact = zeta < eta ? oracle::ratio_excess(swing_.zeta.fifty())
                                 : oracle::ratio_from_top(swing_.eta.fifty()) - 1;
  std::vector<Method> ways = {{"the rule", [=] { return cc / 4; }}};
  ways.push_back({"the ratio less 1", [=] { return swing::ratio({zeta, eta}) - 1; }});
  ways.push_back({"the series less 1, 12 terms", [=] { return series(cc, 12) - 1; }});
  ways.push_back({"this edition", [=] { return swing::ratio_excess({zeta, eta}); }});
  race("correction", "T/Θ − 1", exact, ways);
}

/*!
## Checks

The figure's lengths, and the rule against the mean.
*/

CHECK_THAT("the sagitta is what AD lacks of AB, and OD and AD are the sides of a right angle")
{
  for(const double zeta : {1e-9, 1_deg, 30_deg, 90_deg, 170_deg})
  {
    const auto [b, OD, AD, BD] = figure(0.8, 0.4, Amplitude::from_zeta(zeta));
    CHECK(std::hypot(OD, AD) == within_ulps(Fifty(b), 1, "sine, cosine, and two factors"));
    CHECK(AD == within(b * cos(Fifty(zeta)), 2e-16, "a cosine and a factor"));
    CHECK(BD == within_ulps(b * (1 - cos(Fifty(zeta))), 4, "a sine counts twice, and two factors"));
  }
}

CHECK_THAT("the rule falls short, and by an amount between the bounds (A), at every degree")
{
  for(int degree = 1; degree < 180; ++degree)
  {
    const Fifty zeta = exact::pi() * degree / 180, cc = pow(sin(zeta / 2), 2);
    const double in_double = rule(1, figure(0.8, 0.4, Amplitude::from_zeta(static_cast<double>(zeta))).BD);
    CHECK(in_double == within_ulps(1 + cc / 4, 2, "the sum's rounding and the quotient's"));
    const Fifty missed = oracle::ratio_from_top(exact::pi() - zeta) - 1 - cc / 4;
    const Fifty least = Fifty(9) / 64 * cc * cc;
    CHECK(missed == between(least, least / (1 - cc), "coefficients below 9/64 but positive"));  // (A)
  }
}

/*!
The correction down to swings that nobody could see, and at the other end the ratio up to a sagitta that lacks
only $10^{-20}b$ of the diameter. There $2b - d$ must be given: in double precision $d/2b$ is 1.
*/

CHECK_THAT("T/Θ − 1 keeps its digits from a swing of 1e-150 to one that nearly reaches the top")
{
  for(const double zeta : {1e-150, 1e-100, 1e-8})
    CHECK(swing::ratio_excess(Amplitude::from_zeta(zeta))
          == within_ulps(Fifty(zeta) * zeta / 16 * (1 + Fifty(11) * zeta * zeta / 192), 2,
                         "the first terms of (B)"));
  for(const double zeta : {1_deg, 60_deg, 150_deg, 179_deg})
    CHECK(
        swing::ratio_excess(Amplitude::from_zeta(zeta))
        == within_ulps(oracle::ratio_from_top(exact::pi() - zeta) - 1, 4, "beyond 90° a mild difference"));
  CHECK(swing::ratio(Amplitude::from_depth(1e-20))
        == within_ulps(1 / oracle::agm(1, sqrt(Fifty(1e-20) / 2)), 2, "cos ½ζ is the root of (2b − d)/2b"));
}

/*!
Two words of our copy cannot stand. What grows with the arc is $c$; $t$ is the time. And the times become not
smaller but greater, as the formula shows that follows two lines below; who slipped there cannot be told.
*/

const Emendation letter{
    "§10, the quantity that grows",
    {"t = sin ½ζ", [] { return swing::quarter_time(Amplitude::from_zeta(60_deg)); }},
    {"c = sin ½ζ", [] { return Amplitude::from_zeta(60_deg).modulus(); }},
    "§7 calls it c; the proof is for ζ = 60°, and t is taken in units √(b/2g)",
    [](double reading) { return reading == within_ulps(Fifty(0.5), 1, "the sine of 30°"); }};

const Doubtful smaller{"§10, the times of swings through larger arcs",
                       {"smaller (minora)", -1},
                       {"greater (maiora)", 1},
                       "every term of the series grows with the arc; the proof compares 1°, 90° and 179°",
                       [](double sign) {
                         if(std::abs(sign) != 1)
                           return false;  // no direction
                         const double T = swing::ratio_from_bottom(90_deg);
                         return sign * (T - swing::ratio_from_bottom(1_deg)) > 0
                                && sign * (swing::ratio_from_bottom(179_deg) - T) > 0;
                       }};

/*!
What is told, at 30°, near the top, and for a swing that nobody could see:
*/

CHECK_THAT(
    "the lengths told are the triangle's, the times the oracle's, and the day 86400 times the excess")
{
  for(const Told& now : told_at("", "eta=1e-9rad a=2 k=3", "zeta=1e-100rad k=0", "zeta=90 a=1e-50 k=1e-49"))
  {
    const Fifty b = a.fifty() + k.fifty() * k.fifty() / a.fifty(), zeta = swing_.zeta.fifty(),
                eta = swing_.eta.fifty();
    const Fifty excess = zeta < eta ? oracle::ratio_excess(zeta) : oracle::ratio_from_top(eta) - 1;
    const Fifty d = zeta < Fifty(1e-20) ? b * zeta * zeta / 2 : b * (1 - cos(zeta));
    const char* const few = "few roundings";
    CHECK(now.value("b", metres) == within_relative(b, 6e-16, few));
    CHECK(now.value("OD", metres) == within_relative(b * (zeta < eta ? sin(zeta) : sin(eta)), 1e-15, few));
    CHECK(now.value("AD", metres) == within(b * cos(zeta), 1e-15 * static_cast<double>(b), few));
    CHECK(now.value("d", metres) == within_relative(d, 2e-15, few));
    CHECK(now.value("T_over_Theta") == within_relative(1 + excess, 6e-16, few));
    CHECK(now.value("rule") == within_relative(1 + d / (8 * b), 6e-16, few));
    CHECK(now.value("day", seconds) == within_relative(86400 * excess, 1e-15, few));
    CHECK(now.value("d_second", metres) == within_relative(b / 10800, 1e-15, few));
    CHECK(now.value("zeta_second", degrees) == within_relative(acos(1 - Fifty(1) / 10800), 1e-15, few));
    const auto beyond = [](int degree) {
      const Fifty x = degree * exact::pi() / 180;
      return 86400 * (oracle::ratio_from_bottom(x) - 1 - (1 - cos(x)) / 8);
    };
    CHECK(now.value("missed_10", seconds)
          == within_relative(beyond(10), 1e-13, "the double of 10° to the fourth"));
    CHECK(now.value("missed_30", seconds)
          == within_relative(beyond(30), 1e-13, "the double of 30° to the fourth"));
    CHECK(now.exact("correction") == within_relative(excess, 1e-40, "the same oracle"));
    CHECK(now.method("correction", "the rule") == within_relative(d / (8 * b), 1e-15, few));
    CHECK(now.method("correction", "this edition")
          == within_relative(excess, 1e-15, "the library's bound"));
    CHECK(now.method("correction", "the ratio less 1")
          == within(excess, 3e-16 * static_cast<double>(1 + excess), "near 1"));
    Fifty twelve = 0;
    for(int i = 1; i < 12; ++i)
      twelve += static_cast<Fifty>(pow(exact::double_factorial_ratio(i), 2)) * pow(d / (2 * b), i);
    CHECK(now.method("correction", "the series less 1, 12 terms") == within(twelve, 3e-15, "near 1 to 4"));
  }
}

CHECK_THAT("the table and the figures have the correction, what the rule misses, and the triangle")
{
  const auto beyond = [](const Fifty& zeta) {
    return oracle::ratio_from_bottom(zeta) - 1 - (1 - cos(zeta)) / 8;
  };
  for(const Told& now : told_at("", "zeta=100 a=2 k=3"))
  {
    for(const auto& row : now.rows("rows"))
    {
      const Fifty zeta = row.at("zeta", degrees);
      CHECK(row.value("excess")
            == within_relative(oracle::ratio_from_bottom(zeta) - 1, 1e-15, "the library's bound"));
      CHECK(row.value("missed") == within_relative(beyond(zeta), 1e-15, "fifty digits, rounded"));
    }
    for(const auto& point : now.points("corrections", 6))
    {
      const Fifty zeta = Fifty(point.at("zeta")) * exact::pi() / 180, cc = (1 - cos(zeta)) / 2,
                  least = 9 * cc * cc / 64;
      CHECK(point.value("excess")
            == within_relative(oracle::ratio_from_bottom(zeta) - 1, 1e-15, "rounded"));
      CHECK(point.value("missed") == within_relative(beyond(zeta), 1e-15, "rounded"));
      CHECK(point.value("least") == within_relative(least, 1e-15, "rounded"));
      CHECK(point.value("most") == within_relative(least / (1 - cc), 1e-15, "rounded"));
    }
    const Fifty b = a.fifty() + k.fifty() * k.fifty() / a.fifty(), s = sin(swing_.zeta.fifty()),
                c = cos(swing_.zeta.fifty());
    const std::array<std::pair<Fifty, Fifty>, 6> places{{{0, -b},
                                                         {0, 0},
                                                         {b * s, -b * c},
                                                         {0, -b * c},
                                                         {a.fifty() * s, -a.fifty() * c},
                                                         {0, -b * (1 + c) / 2}}};
    const auto points = now.points("points");
    for(std::size_t i = 0; i < places.size(); ++i)
    {
      CHECK(points.at(i).value("x") == within(places[i].first, 1e-14, "few roundings of lengths to 7"));
      CHECK(points.at(i).value("y") == within(places[i].second, 1e-14, "few roundings of lengths to 7"));
    }
    const auto arc = now.points("arc");
    for(std::size_t i = 0; i <= 60; i += 15)
    {
      const Fifty at = swing_.zeta.fifty() * static_cast<int>(i) / 60;
      CHECK(arc.at(i).value("x") == within(b * sin(at), 1e-14, "few roundings of lengths to 7"));
      CHECK(arc.at(i).value("y") == within(-b * cos(at), 1e-14, "few roundings of lengths to 7"));
    }
  }
}

/*!
## Notes

In powers of the angle itself the correction is

$$ \frac T\Theta = 1 + \frac{\zeta^2}{16} + \frac{11\,\zeta^4}{3072} + \frac{173\,\zeta^6}{737280}
   + \frac{22931\,\zeta^8}{1321205760} + \cdots \tag{B} $$

Euler's series in $\sin\tfrac12\zeta$ gives it, in exact fractions.
*/

CHECK_THAT("the series in the sine turns into the series in the angle")
{
  const auto sine = exact::sin(exact::Series<Rational>({Rational(0), Rational(1, 2)}, 9));
  const auto sum = series<exact::Series<Rational>>(sine * sine, 5);
  CHECK(sum[2] == Rational(1, 16));
  CHECK(sum[4] == Rational(11, 3072));
  CHECK(sum[6] == Rational(173, 737280));
  CHECK(sum[8] == Rational(22931, 1321205760));
}

/*!
## Go on from here

::: exercise
The pendulum of a clock swings 2° to each side. In a cold night the oil stiffens and it swings 1.9°. By
how much does the clock's day change?

answer: It gains 0.64 seconds a day: 6.58 are lost at 2° and 5.94 at 1.9°. As the loss goes with the
square of the arc, five per cent less of the arc take away nearly ten of the loss.
:::
*/

CHECK_THAT("from 2° to 1.9° the loss falls from 6.58 to 5.94 seconds a day")
{
  for(const Told& now : told_at("zeta=2", "zeta=1.9"))
    CHECK(now.value("day", seconds)
          == within(swing_.zeta > 1.95_deg ? 6.58 : 5.94, 0.005, "to two decimals"));
}
