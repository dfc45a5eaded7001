#include "edition/section.hpp"
#include "pendulum/columns.hpp"
#include "pendulum/series.hpp"
#include "pendulum/three_members.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 37, "Where each method stops being the best one")

using namespace pendulum;

/*!
## What Euler does

The closer the swing comes to the whole circle, the longer it lasts and the less it costs to compute: a
small $\alpha$ makes the members of {{eq pendulum.29 2}} fall off at once. With a greater $\alpha$ the
labour grows, and when the terms with the higher powers of $\sin\alpha$ can no longer be neglected the
method fails altogether, since the sums of the fourth and later columns would need reckoning too intricate,
and no device of analysis is known that would help.

But then, he says, the dissertation's own series does the business much better. For then
$\zeta = 180° - \eta$ is such that $c = \sin\tfrac12\zeta = \cos\tfrac12\eta$ is notably less than 1, and

$$ \frac{T}{\Theta} = 1 + \frac{1^2}{2^2}cc + \frac{1^2\cdot3^2}{2^2\cdot4^2}c^4 + \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}c^6
   + \text{etc.} \tag{1} $$

converges well enough for its sum to be had by adding up several terms.

::: margin
In one phrase: an expansion about $k = 1$ for the wide swings, one about $k = 0$ for the others, and the
hope that they overlap.
:::

Is that so? The claim has two ends, and both can be measured: up to which η do the three members serve, and
how many terms of {{eq 1}} does it take from there on?

## The program

To five decimals of $K$, as in his examples, the three members serve while what they leave out is less than
half a unit of the fifth. One bisection finds the angle; another, with the fourth column added, how much
that column would have given him.
*/

double left_out(double eta, int columns)  // of K, by the logarithmic column and so many of the others
{
  return swing::quarter_time_from_top(eta) - sum_by_columns(eta / 2, columns);
}

double reach(int columns)  // the η at which half a unit of the fifth decimal is left out
{
  double low = 1_deg, high = 80_deg;
  while(high - low > 1e-12)
    (left_out((low + high) / 2, columns) < 0.5e-5 ? low : high) = (low + high) / 2;
  return low;
}

/*!
The other end: terms of {{eq 1}} until no more than half a unit of the fifth decimal of $K$ is missing; and
the same count for what is known today, a series after one step of the arithmetic-geometric mean, and the
steps of that mean alone.
*/

template <class Sum>
int terms_until(double exact, double tolerance, Sum sum)  // the least n with sum(n) within the tolerance
{
  int n = 1;
  for(int step = 1; std::abs(exact - sum(n)) > tolerance; n += step)
    step = n < 200 ? 1 : n / 100;
  return n;
}

int terms_of_his_series(double eta, double tolerance)  // (1)
{
  const double cc = std::pow(std::cos(eta / 2), 2);
  double sum = 0, term = 1;
  const double enough = swing::ratio_from_top(eta) - tolerance;
  for(int n = 0;; ++n)
  {
    sum += term;
    if(sum > enough)
      return n + 1;
    term *= std::pow((2 * n + 1.0) / (2 * n + 2), 2) * cc;
  }
}

double after_one_step(double eta, int terms)
{
  const double quarter = (std::numbers::pi - eta) / 4;  // ¼ζ
  return series(std::pow(std::tan(quarter), 4), terms) / std::pow(std::cos(quarter), 2);
}

TELL
{
  const double eta = reach(2);
  tell("three_reach", eta, degrees, "η up to which the three members give K to five decimals");
  tell("four_reach", reach(3), degrees, "the same with the fourth column");
  const double unit = 0.5e-5 * 2 / std::numbers::pi;
  tell("terms_there", terms_of_his_series(eta, unit), "terms of (1) for the same accuracy at that η");
  tell("terms_150", terms_of_his_series(30_deg, unit), "terms of (1) at ζ = 150°");
  tell("terms_120", terms_of_his_series(60_deg, unit), "terms of (1) at ζ = 120°");
  tell("one_step_there",
       terms_until(swing::ratio_from_top(eta), unit, [=](int n) { return after_one_step(eta, n); }),
       "terms at the first of these angles after one step of the mean");
  tell("columns_there",
       terms_until(swing::quarter_time_from_top(30_deg), 0.5e-5,
                   [](int n) { return sum_by_columns(15_deg, n); }),
       "columns beside the logarithmic one at ζ = 150°");
}

/*!
For the picture the count is made at every angle.
*/

TELL
{
  curve("labour", {"eta", "his_series", "one_step", "columns", "mean"}, [](Curve& c) {
    const double unit = 0.5e-5 * 2 / std::numbers::pi;
    for(double eta = 1; eta < 150; eta *= 1.03)
    {
      const double e = eta * 1_deg;
      const double exact = swing::ratio_from_top(e);
      double a = 1, g = std::sin(e / 2);
      int steps = 0;
      for(; std::abs(1 / a - exact) > unit; ++steps)
        std::tie(a, g) = std::pair{(a + g) / 2, std::sqrt(a * g)};
      c.put({eta, double(terms_of_his_series(e, unit)),
             double(terms_until(exact, unit, [=](int n) { return after_one_step(e, n); })),
             double(terms_until(exact * std::numbers::pi / 2, 0.5e-5,
                                [=](int n) { return sum_by_columns(e / 2, n); })),
             double(steps)});
    }
  });
}

/*!
The three members serve up to {{three_reach|f2}}°, with the fourth column they would have served to
{{four_reach|f1}}°. But where they give up, the series that Euler recommends in their place needs
{{terms_there}} terms; at 150° it is still {{terms_150}}, at 120° it is {{terms_120}}. Between about seven
and sixty degrees from the top neither of his methods is fit for work by hand. What would have closed the
gap is within his reach: all the columns ({{sec pendulum.28}}) need only {{columns_there}} at 150°.

::: figure pendulum-37
alt: Number of terms for five decimals against eta, both logarithmic. Euler's series falls from a hundred
thousand terms at one degree to ten at 120 degrees. The columns rise from two at one degree to fifty at 100
degrees and cross it near 90 degrees. The series after one step and the mean stay low throughout. A band
marks the angles between 6.7 and 60 degrees.

The labour for five decimals. The three members end where the columns need more than two; from there to
about 60° Euler's series asks for dozens to thousands of terms. One step of the arithmetic-geometric mean
changes that; the mean itself never needs more than five steps.
:::

## Checks
*/

CHECK_THAT(
    "at the angle found, what the three members leave out lies inside the bracket of the fourth column")
{
  const double eta = reach(2);
  const double x = std::pow(std::sin(eta / 2), 2);
  const double S2 = column_sums<double>(3)[2];
  CHECK(0.5e-5 / (x * x)
        == between(S2 * std::cos(eta / 2), S2 / std::cos(eta / 2) * 1.003,
                   "S₂ cos α/(1 − 0,881 x) to S₂/cos α"));
  CHECK(left_out(eta * 0.999, 2) < 0.5e-5);
  CHECK(left_out(eta * 1.001, 2) > 0.5e-5);
}

CHECK_THAT("the count of terms of his series is the least one, by fifty digits")
{
  const double eta = reach(2);
  const double unit = 0.5e-5 * 2 / std::numbers::pi;
  const int terms = terms_of_his_series(eta, unit);
  const Fifty cc = pow(cos(Fifty(eta) / 2), 2);
  const Fifty exact = ratio_by_mean(Fifty(eta));
  CHECK(exact - series(cc, terms) < Fifty(unit));
  CHECK(exact - series(cc, terms - 1) > Fifty(unit));
}

const Erratum several_terms{"§37, how many terms of the series",
                            {"several", 50},
                            {"some thousands, where the three members give up", 2720},
                            "at the angle where three members no longer give five decimals",
                            [](double terms) {
                              const Fifty eta = reach(2);
                              return series(pow(cos(eta / 2), 2), static_cast<int>(terms))
                                     == within(ratio_by_mean(eta), 0.5e-5,
                                               "half a unit of the fifth decimal");
                            }};

/*!
The two expansions do meet, and the swing of 150° can be had by both. It must come to $\sqrt3$ times the
swing of 30°, which is one of the few relations between swings that need no tables.
*/

CHECK_THAT("both expansions give the swing of 150°, and it is √3 times that of 30°")
{
  const Fifty small = series(pow(sin(exact::pi() / 12), 2), 90);
  const Fifty by_his_series = series(pow(sin(exact::pi() * 5 / 12), 2), 1600);
  const Fifty by_columns = 2 / exact::pi() * sum_by_columns(exact::pi() / 12, 95);
  CHECK(by_his_series == within_relative(sqrt(Fifty(3)) * small, 1e-45, "cc¹⁶⁰⁰ is below 10⁻⁴⁸"));
  CHECK(by_columns == within_relative(sqrt(Fifty(3)) * small, 1e-45, "sin²ʲα for j = 95 is below 10⁻¹¹⁰"));
}

/*!
The page has lost its head: the number of the section must be supplied. And one reading stays open. The copy
lets the method fail when the terms with $\sin^6\alpha$ count; since it is the *fourth* column that is
missing one would rather expect $\sin^4\alpha$. But what is said is true of either power: wherever the one
or the other counts, the three members are not enough.
*/

const Emendation heading{"§37, the heading",
                         {"none, the text runs on from §36", 36},
                         {"§. 37", 37},
                         "§36 has ended, and §38 follows",
                         [](double number) { return number > 36 && number < 38; }};

const Undecided power{"§37, the terms that cannot be neglected",
                      {"sin⁶α", 6},
                      {"sin⁴α", 4},
                      "where either counts in the fifth decimal, the method fails",
                      [](double exponent) {
                        const auto S = column_sums<double>(4);
                        const int column = static_cast<int>(exponent) / 2;
                        const double s = std::pow(1e-5 / S[static_cast<std::size_t>(column)],
                                                  1 / exponent);  // sin α at which that column is a unit
                        return left_out(2 * std::asin(s), 2) > 0.5e-5;
                      }};
