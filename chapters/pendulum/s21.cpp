#include "edition/section.hpp"
#include "pendulum/columns.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 21, "The array, by rows and by columns")

using pendulum::entry, pendulum::log_cot_half, pendulum::ratio_by_mean;
using pendulum::sum_by_columns, pendulum::sum_by_rows, pendulum::sum_with_one_logarithm;

/*!
## What Euler does

All the integrals go into the series, and the time of the descent becomes an endless triangle of terms. The
integrals of {{sec pendulum.20}} are put, one after another, into the equation

$$ \frac{dt\sqrt{2g}}{\sqrt b} = d\omega\left(\frac{1}{\sin\omega} +
     \frac12\cdot\frac{\sin^2\alpha}{\sin^3\omega}
   + \frac{1\cdot3}{2\cdot4}\cdot\frac{\sin^4\alpha}{\sin^5\omega} + \text{etc.}\right). \tag{1} $$

Each of its terms becomes a row, and what has the same power of $\sin\alpha$ he sets in one column. For the
whole descent $gZB$, with $S = \sin\alpha$, $C = \cos\alpha$ and $L = l\cot\frac12\alpha$, the time
$t\sqrt{2g}/\sqrt b$ is the sum of all entries of this array, each multiplied by what stands over its column
($m$ is the row, from 0):

$$ \def\arraystretch{1.7} \begin{array}{ccccc}
   S^{2m}L & C & CS^2 & CS^4 & CS^6 \\ \hline
   1 \\
   \frac{1^2}{2^2} & \frac{1^2}{2^2} \\
   \frac{1^2 3^2}{2^2 4^2} & \frac{1\cdot3}{2\cdot4^2} & \frac{1\cdot3^2}{2^2 4^2} \\
   \frac{1^2 3^2 5^2}{2^2 4^2 6^2} & \frac{1\cdot3\cdot5}{2\cdot4\cdot6^2}
     & \frac{1\cdot3\cdot5^2}{2\cdot4^2 6^2} & \frac{1\cdot3^2 5^2}{2^2 4^2 6^2} \\
   \frac{1^2 3^2 5^2 7^2}{2^2 4^2 6^2 8^2} & \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8^2}
     & \frac{1\cdot3\cdot5\cdot7^2}{2\cdot4\cdot6^2 8^2} & \frac{1\cdot3\cdot5^2 7^2}{2\cdot4^2 6^2 8^2}
     & \frac{1\cdot3^2 5^2 7^2}{2^2 4^2 6^2 8^2} \\
   \text{etc.} \end{array} \tag{2} $$

Since α is supposed to be a very small angle, $\cos\alpha$ is nearly 1. So the second column, in which every
term has the factor $\cos\alpha$ and no sine, matters above all; what has $\sin^2\alpha$, $\sin^4\alpha$,
$\sin^6\alpha$ may be left out without sensible error.

::: margin
Today: $K(\cos\alpha) = L\,P(x) + C\sum_j S_j x^j$ with $x = \sin^2\alpha$. The first column,
$P = \frac2\pi K(\sin\alpha)$, is the series of {{sec pendulum.09}} for a *small* swing of amplitude η.
:::

## The program

The entry in row $m$ and the column of $\cos\alpha\sin^{2j}\alpha$ is a coefficient of {{sec pendulum.20}}
times one of the series,

$$ \frac{a_m^2}{2(m-j)\,a_{m-j}}, \qquad a_n = \frac{1\cdot3\cdots(2n-1)}{2\cdot4\cdots2n}. \tag{3} $$

A row is $a_m J_m$, with the scaled integrals of {{sec pendulum.18}}. So the array is added by rows like
this:

::: code pendulum/columns.hpp sum_by_rows
:::

By columns it needs their sums. Euler finds two of them in the sections that follow; {{sec pendulum.28}} has
the rest, with the recurrence that is used here.

::: code pendulum/columns.hpp sum_by_columns
:::

All entries being positive, the order of adding cannot change the sum. It changes everything else.
*/

const auto swing_ = amplitude_from_top(5_deg);
const auto rows = integer("rows", 5, 0, 100'000, "rows that are added; Euler writes five");
const auto columns = integer("columns", 2, 0, 500, "columns that are added beside the logarithmic one");

TELL
{
  const double alpha = swing_.eta / 2;
  const double exact = swing::quarter_time({swing_.zeta, swing_.eta});
  const double by_rows = sum_by_rows<double>(alpha, rows);
  const double by_columns = sum_by_columns<double>(alpha, columns);
  tell("exact", exact, "t√(2g/b), the whole array");
  tell("by_rows", by_rows, "the first rows");
  tell("rows_short", exact - by_rows, "what they leave out");
  tell("by_columns", by_columns, "the logarithmic column and the first of the others");
  tell("columns_short", exact - by_columns, "what they leave out");
}

TELL
{
  auto& array = table("array", "The array in lowest terms: what stands before L, and before the powers of S.",
                      {{"m", "row"}, {"L", "S²ᵐ L"}, {"C0", "C"}, {"C2", "C S²"}, {"C4", "C S⁴"},
                       {"C6", "C S⁶"}});
  for(int m = 0; m <= 4; ++m)
  {
    std::vector<Cell> cells{1.0 * m, pow(exact::double_factorial_ratio(m), 2).str()};
    for(int j = 0; j < 4; ++j)
      cells.push_back(j < m ? entry(m, j).str() : "");
    array.row(cells);
  }
}

/*!
For the figure, what is missing after so many rows and after so many columns.
*/

TELL
{
  curve("rows", {"count", "small", "large"}, [](Curve& c) {
    for(int k = 1; k <= 1000; k += 1 + k / 8)
    {
      const auto missing = [k](double alpha) {
        return swing::quarter_time_from_top(2 * alpha) - sum_by_rows(alpha, k);
      };
      c.put({1.0 * k, missing(2.5_deg), missing(30_deg)});
    }
  });
  curve("columns", {"count", "small", "large"}, [](Curve& c) {
    for(int k = 0; k <= 20; ++k)
    {
      const auto missing = [k](const Fifty& alpha) {
        return static_cast<double>(ratio_by_mean(2 * alpha) * exact::pi() / 2 - sum_by_columns(alpha, k));
      };
      c.put({k + 1.0, missing(Fifty(2.5_deg)), missing(Fifty(30_deg))});
    }
  });
}

/*!
And the race, in which the single column of {{sec pendulum.28}} and the mean take part.
*/

TELL
{
  const double alpha = swing_.eta / 2;
  std::vector<Method> ways;
  for(const int k : {5, 100, 1000})
    ways.push_back({"rows: " + std::to_string(k), [=] { return sum_by_rows(alpha, k); }, "rows"});
  for(const int k : {1, 2, 4, 7})
    ways.push_back({"columns: " + std::to_string(k), [=] { return sum_by_columns(alpha, k); }, "columns"});
  for(const int k : {2, 4, 7})
    ways.push_back({"one column, terms: " + std::to_string(k),
                    [=] { return sum_with_one_logarithm(alpha, k); }, "one"});
  ways.push_back({"arithmetic-geometric mean",
                  [=] { return ratio_by_mean(2 * alpha) * std::numbers::pi / 2; }});
  ways.push_back({"this edition", [=] { return swing::quarter_time_from_top(2 * alpha); }});
  race("time", "t√(2g/b)", ratio_by_mean(Fifty(2 * alpha)) * exact::pi() / 2, ways);
}

/*!
{{table array}}

Of {{exact|9}}, five rows leave out {{rows_short|e2}}. The logarithmic column and two more leave out
{{columns_short|e2}}.

::: figure pendulum-21
alt: What is missing against the number of rows or columns, both scales logarithmic. By rows, for both
angles, it falls slowly along a line of slope minus one half. By columns it plunges, for 2.5 degrees by a
factor of 600 with every column, for 30 degrees by a factor of 4.

What is still missing of the time, against how many rows or columns have been added, the logarithmic column
counting as the first. By rows it falls like $1/\sqrt{\pi m}$, and a smaller α helps nothing; by columns
every further one gains a factor $\sin^2\alpha$.
:::

## Checks

First the entries that are printed, in exact fractions; the ten that have no logarithm are all right.
*/

CHECK_THAT("the law (3) gives what Euler prints, column by column")
{
  const auto ratio = [](long long above, long long below) { return Rational(above, below); };
  CHECK(entry(1, 0) == ratio(1, 2 * 2));
  CHECK(entry(2, 0) == ratio(1 * 3, 2 * 4 * 4));
  CHECK(entry(3, 0) == ratio(1 * 3 * 5, 2 * 4 * 6 * 6));
  CHECK(entry(4, 0) == ratio(1 * 3 * 5 * 7, 2 * 4 * 6 * 8 * 8));
  CHECK(entry(2, 1) == ratio(1 * 9, 4 * 16));
  CHECK(entry(3, 1) == ratio(1 * 3 * 25, 2 * 16 * 36));
  CHECK(entry(4, 1) == ratio(1 * 3 * 5 * 49, 2 * 4 * 36 * 64));
  CHECK(entry(3, 2) == ratio(1 * 9 * 25, 4 * 16 * 36));
  CHECK(entry(4, 2) == ratio(1 * 3 * 25 * 49, 2 * 16 * 36 * 64));
  CHECK(entry(4, 3) == ratio(1 * 9 * 25 * 49, 4 * 16 * 36 * 64));
}

CHECK_THAT("entry by entry, the array's first rows are what the scaled integrals make of them")
{
  const Fifty alpha(0.3);
  const Fifty x = pow(sin(alpha), 2);
  Fifty sum = 0;
  for(int m = 0; m < 12; ++m)
  {
    sum += static_cast<Fifty>(pow(exact::double_factorial_ratio(m), 2)) * pow(x, m) * log_cot_half(alpha);
    for(int j = 0; j < m; ++j)
      sum += static_cast<Fifty>(entry(m, j)) * pow(x, j) * cos(alpha);
  }
  CHECK(sum == within_relative(sum_by_rows(alpha, 12), 1e-46, "a hundred roundings of fifty digits"));
}

/*!
Added by columns it comes to the whole time, and enough columns give all the digits there are. Added by rows
it does so too, in the end: after $m$ rows about $1/\sqrt{\pi m}$ is missing, divided by $\cos\alpha$.
*/

CHECK_THAT("by columns, and in one column, the array sums to K(cos α)")
{
  for(const double alpha : {1e-300, 1e-3, 2.5_deg, 30_deg, 45_deg, 1.0})
  {
    const Fifty exact = ratio_by_mean(Fifty(2 * alpha)) * exact::pi() / 2;
    CHECK(sum_by_columns(Fifty(alpha), 330)
          == within_relative(exact, 1e-44, "at 1 rad sin²α to the 330th is 10⁻⁴⁹"));
    CHECK(sum_with_one_logarithm(Fifty(alpha), 330) == within_relative(exact, 1e-44, "the same"));
    CHECK(sum_by_columns(alpha, 120)
          == within_ulps(exact, 4, "a logarithm, the mean, and a short polynomial"));
  }
}

CHECK_THAT("by rows what is missing falls like 1/√(πm), however small α is")
{
  for(const double alpha : {1e-300, 1e-8, 2.5_deg, 30_deg})
    for(const int m : {100, 500, 10'000})
    {
      const double missing = swing::quarter_time_from_top(2 * alpha) - sum_by_rows(alpha, m);
      CHECK(missing * std::cos(alpha) * std::sqrt(std::numbers::pi * m)
            == between(0.99, 1.01, "the next term is less than 1/m, and doubles near 690 end at 1.1e-13"));
    }
}

CHECK_THAT("five hundred rows add up in double as they do in fifty digits")
{
  for(const double alpha : {1e-3, 1e-2, 0.1, 0.3, 1.0})
    CHECK(sum_by_rows(alpha, 500) == within_ulps(sum_by_rows(Fifty(alpha), 500), 16,
          "falling terms, all positive"));
}

CHECK_THAT("near 90° all sits in the columns, and the time still comes out")
{
  const double alpha = 80_deg;
  const Fifty exact = ratio_by_mean(2 * Fifty(alpha)) * exact::pi() / 2;
  CHECK(sum_by_columns(Fifty(alpha), 1500) == within_relative(exact, 1e-19, "sin²α to the 1500th is 10⁻²⁰"));
}

/*!
Readings. In the differential the scan has put $\sin\omega$ for $\sin\alpha$ above; under the root on the
left the letter z for the digit 2; and in the array the integral sign for the letter $l$. (On the left a
bare $d$ and a 1 stand for $dt$ and $t$; and a third power of 1 in the fifth row may stay, since it changes
nothing.)
*/

double three_terms(double above)  // of (1), with α = 2½°, ω = 5°, and `above` for the sine above
{
  const double vv = std::pow(above / std::sin(5_deg), 2);
  return (1 + vv / 2 + 3 * vv * vv / 8) / std::sin(5_deg);
}

const Emendation numerators{
    "§21, (1)", {"sin²ω and sin⁴ω above", [] { return three_terms(std::sin(5_deg)); }},
    {"sin²α and sin⁴α above", [] { return three_terms(std::sin(2.5_deg)); }},
    "three terms stay below the root that they come from, by less than the fourth and its followers",
    [](double sum) {
      const double root = 1 / std::sqrt(std::sin(7.5_deg) * std::sin(2.5_deg));
      const double vv = std::pow(std::sin(2.5_deg) / std::sin(5_deg), 2);
      return sum < root && root < sum + 0.3125 * vv * vv * vv / (1 - vv) / std::sin(5_deg);
    }};

const Emendation acceleration{
    "§21, left sides", {"√(zg), z being cos ½ψ, 1 at the lowest point", 1.0}, {"√(2g)", 2.0},
    "g is the height fallen in the first second, half of the acceleration",
    [](double acceleration_over_g) { return acceleration_over_g / 2 == 1.0; }};

const Emendation logarithm{
    "§21, the first column", {"∫ cot ½α", 2 * std::log(std::sin(1.25_deg))},
    {"l cot ½α", log_cot_half(2.5_deg)},
    "the first column is the integral of dω/sin ω and its multiples",
    [](double l) {
      const double columns_without = sum_by_columns(2.5_deg, 6)
          - log_cot_half(2.5_deg) * ratio_by_mean(175_deg);
      return columns_without + l * ratio_by_mean(175_deg)
          == within(swing::quarter_time_from_top(5_deg), 1e-14,
              "six columns leave 10⁻¹⁷, and a few roundings");
    }};
