#include <utility>

#include <gsl/gsl_sf_ellint.h>

#include "edition/section.hpp"
#include "exact/series.hpp"
#include "pendulum/series.hpp"
#include "pendulum/tail.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 12, "How long, when the swing nearly reaches the top?")

using pendulum::ratio_by_mean, pendulum::series, pendulum::tail_bound;

/*!
## What Euler does

Here begins the supplement to the dissertation, with a question about the widest swings of all. At its end,
in {{sec pendulum.11}}, the time of a swing had been shown to grow without bound as $\zeta$ goes to 180°.
That raises a question which he finds curious: how long is it when $\zeta$ is very nearly 180°, so that
$c = \sin\tfrac12\zeta$ falls short of one by next to nothing?

The series is still there,

$$ T = \frac{\pi\sqrt b}{\sqrt{2g}}\left(1 + \frac{1^2}{2^2}c^2 + \frac{1^2\cdot3^2}{2^2\cdot4^2}c^4
   + \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}c^6 + \text{etc.}\right), \tag{1} $$

and its sum is finite. But the terms hardly diminish any more, and one cannot hope to find the sum from
them, not even roughly. Nor does he see any way to transform the series into one that would give it exactly
enough. He will have to begin anew, from the integral and from the other end of the circle.

## The program

How many terms does it take? The program adds them in fifty digits until no more is left out than a given
part of the whole, which it knows from the mean of {{sec pendulum.11}}.
*/

int terms_needed(const Fifty& cc, double part)  // of (1)
{
  const Fifty whole = ratio_by_mean(2 * acos(sqrt(cc)));
  Fifty left = whole, term = 1;
  int n = 0;
  for(; left > part * whole; ++n)
  {
    left -= term;
    term *= cc * pow(Fifty(2 * n + 1) / Fifty(2 * n + 2), 2);
  }
  return n;
}

/*!
Near the top there is a law in it. With $s = \cos\tfrac12\zeta$, which is small, the terms fall off like
$e^{-nss}/\pi n$, so that what $N$ of them leave out is nearly $\frac1\pi E_1(Nss)$, an exponential
integral. The number of terms goes up as $1/ss$.
*/

double terms_by_law(double s, double part)
{
  const double wanted = std::numbers::pi * part * ratio_by_mean(2 * std::asin(s));
  double low = 0, high = 100;  // of Nss
  for(int i = 0; i < 60; ++i)
  {
    const double middle = (low + high) / 2;
    (-std::expint(-middle) > wanted ? low : high) = middle;
  }
  return high / (s * s);
}

/*!
There was a way to transform the series, and a short one. Let $q = \tan^2\tfrac14\zeta$; then

$$ \frac T\Theta = (1+q)\left(1 + \frac{1^2}{2^2}q^2 + \frac{1^2\cdot3^2}{2^2\cdot4^2}q^4
   + \text{etc.}\right), \tag{2} $$

::: margin
Landen's transformation: $K(c) = (1+q)K(q)$.
:::

the same series, with the square of the tangent of the quarter angle in the place of the sine of the half.
At 90° it takes $c = 0{,}707$ to $q = 0{,}172$; and it can be done again and again. Done to the end it is
the arithmetic-geometric mean.
*/

double quarter_tangent(double zeta)  // q
{
  return std::pow(std::tan(zeta / 4), 2);
}

double series_after_landen(double q, int terms)  // (2)
{
  return (1 + q) * series(q * q, terms);
}

int steps_of_the_mean(double eta, double part)
{
  const double mean = 1 / ratio_by_mean(eta);
  double a = 1, m = std::sin(eta / 2);
  int step = 0;
  for(; a - mean > part * mean; ++step)
    m = std::sqrt(std::exchange(a, (a + m) / 2) * m);
  return step;
}

/*!
Free are the amplitude, here best given by what it lacks, the pendulum's length, $g$, and the accuracy
wanted.
*/

const auto swing_ = amplitude_from_top(5_deg);
const auto b = real("b", 1.0, metres, positive, "length of the equivalent simple pendulum");
const auto g =
    real("g", 4.903325, metres, positive, "height fallen in the first second, half of today's g");
const auto part = real("part", 1e-5, none, closed(1e-15, 0.1), "part of the whole that may be left out");

TELL
{
  const double ratio = swing::ratio({swing_.zeta, swing_.eta});
  const double s = std::sin(swing_.eta / 2), q = quarter_tangent(swing_.zeta);
  tell("c", std::cos(swing_.eta / 2), "the quantity in whose powers (1) proceeds");
  tell("q", q, "and that of (2)");
  tell("T", std::numbers::pi * std::sqrt(b / (2 * g)) * ratio, seconds, "time of one swing");
  tell("T_over_Theta", ratio, "the same, the infinitely small swing being 1");
  tell("by_law", terms_by_law(s, part), "terms of (1) that are needed, by the law for the top");
  const double closed = series(1 - s * s, 10) + tail_bound(std::cos(swing_.eta / 2), s, 10);
  tell("ten_closed", closed, "ten terms of (1) and the bound of what is left out, §8");
  tell("steps", steps_of_the_mean(swing_.eta, part), "steps of the mean that are needed");
  if(swing_.eta >= 0.5_deg)  // below, counting takes too long
  {
    tell("needed", terms_needed(1 - Fifty(s) * s, part), "terms of (1) that are needed, counted");
    tell("needed_landen", terms_needed(Fifty(q) * q, part), "the same of (2)");
  }
}

/*!
The same counts for more amplitudes and tolerances. Whoever wants fifteen digits at 175° by {{eq 1}} has
something to do.
*/

TELL
{
  auto& rows = table("rows", "Terms needed of (1) and of (2), for a given part of the whole",
                     {{"zeta", "ζ", degrees},
                      {"s3", "(1): 10⁻³"},
                      {"s5", "10⁻⁵"},
                      {"s7", "10⁻⁷"},
                      {"s10", "10⁻¹⁰"},
                      {"s15", "10⁻¹⁵"},
                      {"l5", "(2): 10⁻⁵"},
                      {"l10", "10⁻¹⁰"},
                      {"l15", "10⁻¹⁵"}});
  for(const int degree : {10, 30, 60, 90, 120, 150, 160, 170, 172, 175})
  {
    const Fifty zeta = exact::pi() * degree / 180;
    const auto direct = [&](double allowed) { return 1.0 * terms_needed(pow(sin(zeta / 2), 2), allowed); };
    const auto landen = [&](double allowed) { return 1.0 * terms_needed(pow(tan(zeta / 4), 4), allowed); };
    rows.row({degree * 1_deg, direct(1e-3), direct(1e-5), direct(1e-7), direct(1e-10), direct(1e-15),
              landen(1e-5), landen(1e-10), landen(1e-15)});
  }
  curve("needed", {"zeta", "series", "landen", "mean"}, [](Curve& c) {
    for(int degree = 2; degree <= 179; ++degree)
    {
      const Fifty zeta = exact::pi() * degree / 180;
      const double direct = terms_needed(pow(sin(zeta / 2), 2), 1e-5);
      const double landen = terms_needed(pow(tan(zeta / 4), 4), 1e-5);
      c.put({1.0 * degree, direct, landen, 1.0 * steps_of_the_mean((180 - degree) * 1_deg, 1e-5)});
    }
  });
}

/*!
The race at 175°. Besides the two series there is the bare one with its tail closed as in
{{sec pendulum.08}}, and the routines that take the modulus $c$. These can do no better than $c$ itself,
which has been rounded: near the top that is what they suffer from.
*/

TELL
{
  const double zeta = swing_.zeta, eta = swing_.eta, c = std::sin(zeta / 2), s = std::sin(eta / 2);
  std::vector<Method> ways;
  for(const int terms : {100, 1000, 4000, 16000})
    ways.push_back({std::to_string(terms) + " terms", [=] { return series(c * c, terms); }, "series (1)"});
  for(const int terms : {10, 100, 1000})
    ways.push_back({std::to_string(terms) + " terms and B",
                    [=] { return series(c * c, terms) + tail_bound(c, s, terms); }, "series (1) closed"});
  for(const int terms : {5, 46, 107, 170})
    ways.push_back({"Landen, " + std::to_string(terms) + " terms",
                    [=] { return series_after_landen(quarter_tangent(zeta), terms); }, "series (2)"});
  ways.push_back({"mean", [=] { return ratio_by_mean(eta); }});
  const double quarter = std::numbers::pi / 2;
  ways.push_back({"GSL, of c", [=] { return gsl_sf_ellint_Kcomp(c, GSL_PREC_DOUBLE) / quarter; }});
  ways.push_back({"standard library, of c", [=] { return std::comp_ellint_1(c) / quarter; }});
  ways.push_back({"this edition", [=] { return swing::ratio({zeta, eta}); }});
  race("near_the_top", "T/Θ", ratio_by_mean(Fifty(eta)), ways);
}

/*!
At 175° it takes {{needed}} terms of Euler's series to have the time to the hundred thousandth part; after
one transformation {{needed_landen}}; by the mean, {{steps}} steps. So the answer to his question, for 5°
from the top, was within reach: {{T_over_Theta|8}} times the small swing. Even ten terms of {{eq 1}} itself
would do, if one adds what their successors very nearly sum to, an arc and a logarithm; this gives
{{ten_closed|8}}, and it is as good right up to the top.

::: figure pendulum-12
alt: Terms needed against amplitude. The series needs a handful up to 60 degrees, 90 000 at 179 degrees.

What it takes to have $T$ to the hundred thousandth part. The series {{eq 1}} does well up to a hundred
degrees and then becomes hopeless. One step of Landen's takes the square root of the labour, roughly; the
mean hardly notices how near the top is.
:::

## Checks

The transformation {{eq 2}} holds exactly; it is proven here from the exact coefficients, by comparing the
powers of $q$. With $q = \tan^2\tfrac14\zeta$, $cc = 4q/(1+q)^2$.
*/

CHECK_THAT("the series in c, with 4q/(1+q)² for cc, is (1+q) times the series in q")
{
  const int order = 24;
  using exact::Series;
  const auto q = Series<Rational>::x(order), one = Series<Rational>(1).truncated(order);
  const auto cc = Series<Rational>(4) * q / ((one + q) * (one + q));
  auto left = Series<Rational>({Rational(0)}, order), right = left, power = one;
  for(int n = 0; n <= order; ++n, power *= cc)
  {
    const Series<Rational> coefficient = pow(exact::double_factorial_ratio(n), 2);
    left += coefficient * power;
    if(2 * n <= order)
      right += (one + q) * coefficient * pow(q, 2 * n);
  }
  CHECK(left == right);
}

CHECK_THAT("the series after one step gives the time")
{
  for(const double zeta : {10_deg, 90_deg, 150_deg, 175_deg})
    CHECK(series_after_landen(quarter_tangent(zeta), 400)
          == within_ulps(ratio_by_mean(exact::pi() - zeta), 200, "400 terms, and a q that is nearly 1"));
}

/*!
The counts: one term fewer is not enough, and the law of the exponential integral foretells them.
*/

CHECK_THAT("the counted terms are enough, and one fewer is not")
{
  for(const double zeta : {60_deg, 90_deg, 150_deg, 175_deg})
    for(const double allowed : {1e-3, 1e-10, 1e-15})
    {
      const Fifty cc = pow(sin(Fifty(zeta) / 2), 2), whole = ratio_by_mean(exact::pi() - zeta);
      const int n = terms_needed(cc, allowed);
      CHECK(series(cc, n) == within_relative(whole, allowed, "this is the tolerance asked for"));
      CHECK(series(cc, n - 1)
            == between(0, whole * (1 - Fifty(allowed)), "or else the count is too large"));
    }
}

CHECK_THAT("near the top the number of terms is by a law, seven over ss for five figures")
{
  for(const int degree : {170, 175, 178})
  {
    const Fifty cc = pow(sin(exact::pi() * degree / 360), 2);
    const double law = terms_by_law(std::cos(degree * 0.5_deg), 1e-5);
    const double counted = terms_needed(cc, 1e-5);
    CHECK(counted == within_relative(law, 0.01, "corrections of the order ss = 0,0076 at 170°"));
  }
}

CHECK_THAT("the mean needs thirteen steps at most, even a part in 10³⁰⁰ from the top")
{
  CHECK(steps_of_the_mean(5_deg, 1e-15) == 6);
  CHECK(steps_of_the_mean(1e-50, 1e-15) == 10);
  CHECK(steps_of_the_mean(1e-100, 1e-15) == 11);
  CHECK(steps_of_the_mean(1e-300, 1e-15) == 13);
}

/*!
What stood in the way was not the series but the state of the art, as the count of terms shows. And the scan
has lost all the squares in {{eq 1}}.
*/

const Erratum no_way{
    "§12, no way to transform the series",
    {"none: 3791 terms at 175°", 3791},
    {"Landen's: 46 terms", 46},
    "the proof counts the terms that five figures take at 175°",
    [](double reading) { return reading == terms_needed(pow(tan(exact::pi() * 175 / 720), 4), 1e-5); }};

const Emendation squares{"§12, the series",
                         {"1 + ½c² + 1/(2·4) c⁴ + 1·3·5/(2·4·6) c⁶", 1 + 1. / 8 + 1. / 128 + 15. / 48 / 64},
                         {"1 + 1²/2² c² + 1²3²/2²4² c⁴ + 1²3²5²/2²4²6² c⁶", [] { return series(0.25, 4); }},
                         "the series of §9; at ζ = 60° four terms must come that near to T/Θ",
                         [](double reading) {
                           const double next = 1225. / 16384 / 256;
                           const double short_by = swing::ratio_from_top(120_deg) - reading;
                           return short_by == between(next, 2 * next, "the terms fall by more than cc = ¼");
                         }};
