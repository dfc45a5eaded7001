#include "edition/section.hpp"
#include "pendulum/columns.hpp"
#include "pendulum/steps.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 21, "The array, by rows and by columns")

using pendulum::entry, pendulum::log_cot_half, pendulum::ratio_by_mean;
using pendulum::sum_by_columns, pendulum::sum_by_rows;

/*!
## What Euler does

With the integrals put into the series, the time of the descent becomes an endless triangle of terms. Those of
{{sec pendulum.20}} go, one after another, into the equation

$$ \frac{dt\sqrt{2g}{{entry acceleration}}}{\sqrt b} = d\omega\left(\frac{1}{\sin\omega} +
     \frac12\cdot\frac{\sin^2\alpha{{entry numerators}}}{\sin^3\omega}
   + \frac{1\cdot3}{2\cdot4}\cdot\frac{\sin^4\alpha}{\sin^5\omega} + \text{etc.}\right). \tag{1} $$

Each term of the equation becomes a row, and what has the same power of $\sin\alpha$ beside the cosine is set
in one column. For the whole descent $gZB$ the time $t\sqrt{2g}/\sqrt b$ is the sum of all entries of the
array, each multiplied by what stands over its column; here $S = \sin\alpha$, $C = \cos\alpha$, $L =
l\cot\frac12\alpha$, and $m$ is the number of the row, from 0:

$$ \def\arraystretch{2.6} \begin{array}{ccccc}
   S^{2m}L{{entry logarithm}} & C & CS^2 & CS^4 & CS^6 \\ \hline
   1 \\
   \dfrac{1^2}{2^2} & \dfrac{1^2}{2^2} \\
   \dfrac{1^2 3^2}{2^2 4^2} & \dfrac{1\cdot3}{2\cdot4^2} & \dfrac{1\cdot3^2}{2^2 4^2} \\
   \dfrac{1^2 3^2 5^2}{2^2 4^2 6^2} & \dfrac{1\cdot3\cdot5}{2\cdot4\cdot6^2}
     & \dfrac{1\cdot3\cdot5^2}{2\cdot4^2 6^2} & \dfrac{1\cdot3^2 5^2}{2^2 4^2 6^2} \\
   \dfrac{1^2 3^2 5^2 7^2}{2^2 4^2 6^2 8^2} & \dfrac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8^2}
     & \dfrac{1\cdot3\cdot5\cdot7^2}{2\cdot4\cdot6^2 8^2} & \dfrac{1\cdot3\cdot5^2 7^2}{2\cdot4^2 6^2 8^2}
     & \dfrac{1\cdot3^2 5^2 7^2}{2^2 4^2 6^2 8^2} \\
   \text{etc.} \end{array} \tag{2} $$

::: margin
Today: $K(\cos\alpha) = L\,P(x) + C\sum_j S_j x^j$ with $x = \sin^2\alpha$. The first column,
$P = \frac2\pi K(\sin\alpha)$, is the series of {{sec pendulum.09}} for a *small* swing of amplitude η.
:::

Since α is supposed to be a very small angle, $\cos\alpha$ is nearly 1. So the second column, whose terms have
$\cos\alpha$ and nothing else, matters most beside the first; what has $\sin^2\alpha$, $\sin^4\alpha$,
$\sin^6\alpha$ may be neglected without sensible error.

## The program

The entry in row $m$ and the column of $\cos\alpha\sin^{2j}\alpha$ is a coefficient of {{sec pendulum.20}}
times one of the series,

$$ \frac{a_m^2}{2(m-j)\,a_{m-j}}, \qquad a_n = \frac{1\cdot3\cdots(2n-1)}{2\cdot4\cdots2n}. \tag{A} $$

A row is $a_m J_m$, with the scaled integrals of {{sec pendulum.18}}:

::: code pendulum/columns.hpp sum_by_rows
:::

To add by columns one needs their sums. Euler finds two of them in the sections that follow; the recurrence
that gives all is derived in {{sec pendulum.28}}.

::: code pendulum/columns.hpp sum_by_columns (2)
:::

All entries being positive, the order of adding cannot change the sum. It changes everything else.
*/

const auto swing_ = amplitude_from_top(5_deg, from_below(30_deg, 180_deg));
const auto rows = integer("rows", 5, 0, 100'000, "rows that are added; Euler writes five");
const auto columns = integer("columns", 2, 0, 500, "columns that are added beside the logarithmic one");

Fifty whole(const Fifty& alpha)  // K(cos α), by the mean
{
  return ratio_by_mean(2 * alpha) * exact::pi() / 2;
}

TELL
{
  const Fifty alpha = swing_.eta.fifty() / 2, exact = whole(alpha);
  const Fifty beyond = exact - sum_by_columns(alpha, columns);  // nothing, where fifty digits cannot tell
  tell("exact", swing::quarter_time({swing_.zeta, swing_.eta}), "t√(2g/b), the whole array");
  tell("rows_short", double(exact - sum_by_rows(alpha, rows)), "what the first rows leave out");
  tell("columns_short", beyond < Fifty("1e-46") * exact ? 0 : double(beyond),
       "what the logarithmic column and the first others leave out");
}

TELL
{
  curve("missing", {"count", "rows_small", "rows_large", "columns_small", "columns_large"}, [](Curve& c) {
    for(int k = 1; k <= 1000; k += 1 + k / 8)
    {
      std::vector<double> row{1. * k};
      for(const double alpha : {2.5_deg, 30_deg})
        row.push_back(static_cast<double>(whole(alpha) - sum_by_rows(alpha, k)));
      for(const double alpha : {2.5_deg, 30_deg})
        row.push_back(static_cast<double>(whole(alpha) - sum_by_columns(Fifty(alpha), k - 1)));
      c.put(row);
    }
  });
}

/*!
Of {{exact|9}}, five rows leave out {{rows_short|e2}}; the logarithmic column and two more leave out
{{columns_short|e2}}.

::: figure pendulum-21
alt: What is missing against the number of rows or columns, both scales logarithmic. By rows, for both
angles, it falls slowly along a line of slope minus one half. By columns it plunges, for 2.5 degrees by a
factor of some 500 to 700 with every column, for 30 degrees by a factor of 4 to 5.

What is still missing of the time, against how many rows or columns have been added, the logarithmic column
counting as the first. By rows it falls like $1/\sqrt{\pi m}$, and a smaller α does not help; by columns
every further one gains a factor $\sin^2\alpha$.
:::

## Speed against error
*/

TELL
{
  const double alpha = swing_.eta / 2;
  std::vector<Method> ways;
  for(const int k : {5, 100, 1000})
    ways.push_back({"rows: " + std::to_string(k), [=] { return sum_by_rows(alpha, k); }, "rows"});
  for(const int k : {1, 2, 4, 7})
    ways.push_back({"columns: " + std::to_string(k), [=] { return sum_by_columns(alpha, k); }, "columns"});
  ways.push_back(
      {"arithmetic-geometric mean", [=] { return ratio_by_mean(2 * alpha) * std::numbers::pi / 2; }});
  race("time", "t√(2g/b)", whole(swing_.eta.fifty() / 2), ways);
}

/*!
## Checks

First the entries that stand in our copy, in exact fractions; all ten that have no logarithm are right.
*/

CHECK_THAT("the law (A) gives what our copy has, column by column")
{
  CHECK(entry(1, 0) == Rational(1, 2 * 2));
  CHECK(entry(2, 0) == Rational(1 * 3, 2 * 4 * 4));
  CHECK(entry(3, 0) == Rational(1 * 3 * 5, 2 * 4 * 6 * 6));
  CHECK(entry(4, 0) == Rational(1 * 3 * 5 * 7, 2 * 4 * 6 * 8 * 8));
  CHECK(entry(2, 1) == Rational(1 * 9, 4 * 16));
  CHECK(entry(3, 1) == Rational(1 * 3 * 25, 2 * 16 * 36));
  CHECK(entry(4, 1) == Rational(1 * 3 * 5 * 49, 2 * 4 * 36 * 64));
  CHECK(entry(3, 2) == Rational(1 * 9 * 25, 4 * 16 * 36));
  CHECK(entry(4, 2) == Rational(1 * 3 * 25 * 49, 2 * 16 * 36 * 64));
  CHECK(entry(4, 3) == Rational(1 * 9 * 25 * 49, 4 * 16 * 36 * 64));
}

CHECK_THAT("entry by entry, the first rows are what the scaled integrals make of them")
{
  const Fifty alpha(0.3), x = pow(sin(alpha), 2);
  Fifty sum = 0;
  for(int m = 0; m < 12; ++m)
  {
    sum += static_cast<Fifty>(pow(exact::double_factorial_ratio(m), 2)) * pow(x, m) * log_cot_half(alpha);
    for(int j = 0; j < m; ++j)
      sum += static_cast<Fifty>(entry(m, j)) * pow(x, j) * cos(alpha);
  }
  CHECK(sum == within_relative(sum_by_rows(alpha, 12), 1e-48, "a hundred roundings of fifty digits"));
}

CHECK_THAT("by columns the array sums to K(cos α), with all digits that there are")
{
  for(const double alpha : {1e-300, 1e-3, 2.5_deg, 30_deg, 45_deg, 1.0})
  {
    CHECK(sum_by_columns(Fifty(alpha), 330)
          == within_relative(whole(alpha), 1e-47, "fifty digits; sin²α to the 330th is below 10⁻⁴⁹"));
    CHECK(sum_by_columns(alpha, 120) == within_ulps(whole(alpha), 4, "the bound of the function"));
  }
  CHECK(sum_by_columns(Fifty(80_deg), 1500)  // near 90° all sits in the columns
        == within_relative(whole(80_deg), 1e-20, "sin²α to the 1500th is 10⁻²⁰"));
}

CHECK_THAT("by rows what is missing falls like 1/√(πm), over cos α, however small α is")
{
  for(const double alpha : {1e-300, 1e-8, 2.5_deg, 30_deg})
    for(const int m : {100, 500, 10'000})
    {
      const double missing = swing::quarter_time_from_top(2 * alpha) - sum_by_rows(alpha, m);
      CHECK(missing * std::cos(alpha) * std::sqrt(std::numbers::pi * m)
            == within(1, 0.3 / m, "(5/24 + tan²α/6)/m comes next"));
    }
}

/*!
Readings. In {{eq 1}} our copy has put $\sin\omega$ for $\sin\alpha$ above; under the roots on the left the
letter z for the digit 2; and in the array the integral sign for the letter $l$. (On the left a bare $d$ and a
1 stand for $dt$ and $t$; and a third power of 1 in the fifth row may stay, since it changes nothing.)
*/

double three_terms(double above)  // of (1), with α = 2½°, ω = 5°, and `above` for the sine above
{
  const double vv = std::pow(above / std::sin(5_deg), 2);
  return (1 + vv / 2 + 3 * vv * vv / 8) / std::sin(5_deg);
}

const Emendation numerators{
    "§21, (1)",
    {"sin²ω/sin³ω, sin⁴ω/sin⁵ω", three_terms(std::sin(5_deg))},
    {"sin²α/sin³ω, sin⁴α/sin⁵ω", three_terms(std::sin(2.5_deg))},
    "three terms stay below the root that they come from, by less than the fourth and its followers",
    [](double sum) {
      const double root = 1 / std::sqrt(std::sin(7.5_deg) * std::sin(2.5_deg));
      const double vv = std::pow(std::sin(2.5_deg) / std::sin(5_deg), 2);
      return sum < root && root < sum + 0.3125 * vv * vv * vv / (1 - vv) / std::sin(5_deg);
    }};

const Emendation acceleration{
    "§21, left sides",
    {"√(zg)", 1.0},
    {"√(2g)", 2.0},
    "the body must hang straight down after the time that the array gives; z, cos ½ψ, would be 1 there",
    [](double times_g) {
      if(!(times_g > 0))
        return false;
      const double time = swing::quarter_time_from_top(5_deg) / std::sqrt(times_g);
      const auto falling = [](double psi) { return 2 * std::sin(psi); };  // b = g = 1
      const pendulum::Place start{5_deg, 0};
      return pendulum::runge_kutta(start, time, 4000, falling).phi
             == within(exact::pi(), 1e-9, "the steps' error, grown 8/η-fold");
    }};

const Emendation logarithm{
    "§21, the first column",
    {"∫ cot ½α", 2 * std::log(std::sin(1.25_deg))},
    {"l cot ½α", log_cot_half(2.5_deg)},
    "the time less the first entry is the other columns, and they sum to hardly more than l 2",
    [](double first) {
      return swing::quarter_time_from_top(5_deg) - first
             == within(exact::ln2(), 0.005, "terms of the order sin²α");
    }};

/*!
What is told, at 5°, at 90° and near the top, by the oracle's time and the entries themselves:
*/

Fifty by_entries(const Fifty& alpha, int rows_kept)  // (2), row by row from the fractions
{
  const Fifty x = pow(sin(alpha), 2), log_cot = log((1 + cos(alpha)) / sin(alpha));
  Fifty sum = 0;
  for(int m = 0; m < rows_kept; ++m)
  {
    sum += static_cast<Fifty>(pow(exact::double_factorial_ratio(m), 2)) * pow(x, m) * log_cot;
    for(int j = 0; j < m; ++j)
      sum += static_cast<Fifty>(entry(m, j)) * pow(x, j) * cos(alpha);
  }
  return sum;
}

CHECK_THAT("the time told is the oracle's, and what rows and columns leave out is what they lack of it")
{
  for(const Told& now :
      told_at("", "eta=90 rows=12 columns=4", "eta=1e-200rad rows=3 columns=1", "eta=1 rows=0 columns=11"))
  {
    const Fifty alpha = swing_.eta.fifty() / 2, K = swing::oracle::K_from_complement(sin(alpha));
    const double size = static_cast<double>(K);
    CHECK(now.value("exact") == within_ulps(K, 1, "the library's bound"));
    CHECK(now.value("rows_short")
          == within_relative(K - by_entries(alpha, rows), 2e-16, "fifty digits, rounded to a double"));
    const Fifty factor = swing::oracle::ratio_from_bottom(2 * alpha), x = pow(sin(alpha), 2);
    Fifty by = factor * log((1 + cos(alpha)) / sin(alpha));
    const auto sums = pendulum::exact_column_sums(columns);
    for(int j = 0; j < columns; ++j)
      by += cos(alpha) * pow(x, j) * sums.at(static_cast<std::size_t>(j)).value();
    const Fifty noise = Fifty("1e-46") * K, beyond = K - by;
    CHECK(now.value("columns_short")
          == within(beyond < noise ? Fifty(0) : beyond, 2e-16 * static_cast<double>(beyond + noise),
                    "fifty digits, rounded; nothing, where they cannot tell"));
    CHECK(now.exact("time") == within_relative(K, 1e-45, "two ways of fifty digits"));
    for(const int k : {5, 100, 1000})
      CHECK(now.method("time", "rows: " + std::to_string(k))
            == within_relative(sum_by_rows(alpha, k), 4e-15, "rows of rounded integrals"));
    CHECK(now.method("time", "rows: 5") == within_relative(by_entries(alpha, 5), 1e-15, "the entries"));
    for(const int k : {1, 2, 4, 7})
    {
      const double most =
          std::log(2.) * std::pow(std::sin(swing_.eta / 2), 2 * k) / std::cos(swing_.eta / 2);
      CHECK(now.method("time", "columns: " + std::to_string(k))
            == between(K - most - 1e-15 * size, K + 1e-15 * size, "no column's sum is above l 2"));
    }
    CHECK(now.method("time", "arithmetic-geometric mean")
          == within_ulps(K, 5, "η rounds, and its own bound"));
  }
}

CHECK_THAT("the figure has what rows and columns leave out at 2½° and 30°")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("missing", 5))
    {
      const int k = static_cast<int>(point.at("count"));
      for(const auto& [alpha, of_rows, of_columns] : {std::tuple{2.5_deg, "rows_small", "columns_small"},
                                                      std::tuple{30_deg, "rows_large", "columns_large"}})
      {
        const Fifty a = alpha, K = swing::oracle::K_from_complement(sin(a));
        if(k < 40)
          CHECK(point.value(of_rows)
                == within_relative(K - by_entries(a, k), 1e-6, "a digit or two, and double"));
        CHECK(point.value(of_rows)
              == within_relative(1 / (cos(a) * sqrt(exact::pi() * k)), 0.3 / k + 0.1 / k,
                                 "the law of the rows"));
        const double most = std::log(2.) * std::pow(std::sin(alpha), 2 * (k - 1)) / std::cos(alpha);
        CHECK(point.value(of_columns)
              == between(-1e-46, most + 1e-46, "no column's sum is above l 2; fifty digits"));
      }
    }
}

/*!
## Go on from here

::: exercise
How many rows would have to be added at 5° to leave out only a hundredth? And what does a single column
beside the logarithmic one leave out?

answer: The law $1/\sqrt{\pi m}$ says $m = 10^4/\pi$, some 3183; with $\cos\alpha$ below, a few more:
3189. One column leaves 0.00099.
:::
*/

CHECK_THAT("3189 rows leave out a hundredth at 5°, and one column a thousandth")
{
  for(const Told& now : told_at("rows=3189 columns=1"))
  {
    CHECK(now.value("rows_short") == within(0.01, 3e-6, "3189 is a whole number"));
    CHECK(now.value("columns_short") == within(0.00099, 0.5e-5, "two digits"));
  }
}
