#include <array>

#include "edition/section.hpp"
#include "exact/series.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 28, "The fourth column, a conjecture, and all the others")

using exact::double_factorial_ratio;
using pendulum::column_sums, pendulum::exact_column_sums, pendulum::ratio_by_mean;
using pendulum::sum_by_columns, pendulum::sum_with_one_logarithm;

/*!
## What Euler does

The series in the fourth column, Euler says, could be summed in the same way, but the calculation would be
much more laborious and tedious than that for the third; and one may well be spared it. For that column has
the factor $\cos\alpha\sin^4\alpha$, and since $\alpha = \frac12\eta$ and the angle η is supposed to be small
enough, the fourth power of the sine makes it so small that it can safely be neglected. For the rest it seems
to him rather probable that the coefficient will again turn out to be of the form

$$ \beta\; l2, \tag{1} $$

where β is a fraction less than ¾. With this he is ready for a problem which would otherwise be most
difficult:

*A pendulum, swinging about its axis A, describes arcs that fall little short of 180 degrees both in ascending
and in descending. To find the time of each swing.* The solution begins in {{sec pendulum.29}}.

## The program

The labour can be saved by asking for all columns at once. Let $x = \sin^2\alpha$, $L = l\cot\frac12\alpha$,
$C = \cos\alpha$; the array says that the time of the descent is

$$ K = L\,P(x) + C\,S(x), \qquad P = \sum a_n^2 x^n, \qquad S = \sum S_j\,x^j, \tag{2} $$

with $S_0 = l2$, $S_1 = \frac34l2$ from {{sec pendulum.22}} and {{sec pendulum.27}}. Now both $K$ and $P$ are
solutions of one equation, $4\frac{d}{dx}\left(x(1-x)\frac{dy}{dx}\right) = y$, which is symmetrical in $x$
and $1-x$. When {{eq 2}} is put into it, the logarithm drops out, and what is left ties each column's sum to
the two before it:

$$ (j+1)^2 S_{j+1} = \left(2j^2 + 2j + \tfrac34\right) S_j - j^2 S_{j-1} - \frac{j\,a_j^2}{4(j+1)}. \tag{3} $$

::: margin
Today: the hypergeometric equation of $K(k)$ with $k^2 = 1 - x$.
:::

This one line is what he thought too laborious.

::: code pendulum/columns.hpp column_sums
:::

In exact fractions it gives every sum in the form

$$ S_j = \beta_j\, l2 - \rho_j. \tag{4} $$

The reader may choose how many columns to see, and the angle at which they are added.
*/

const auto swing_ = amplitude_from_top(5_deg);
const auto columns = integer("columns", 7, 1, 200, "columns that are summed, beside the logarithmic one");

TELL
{
  auto& sums = table("sums", "The sums of the columns, (4).",
                     {{"j", "j"}, {"beta", "β"}, {"rho", "ρ"}, {"S", "β l 2 − ρ", none, 15}});
  const auto S = exact_column_sums(columns);
  for(std::size_t j = 0; j < S.size() && j < 12; ++j)  // the fractions of the later ones fill lines
    sums.row({1.0 * static_cast<double>(j), S[j].beta.str(), S[j].rho.str(),
        static_cast<double>(S[j].value())});
}

TELL
{
  const auto fourth = exact_column_sums(3)[2];
  tell("beta", fourth.beta, "what stands before l 2 in the fourth column");
  tell("rho", fourth.rho, "and what is taken away");
  tell("S2", fourth.value(), "the sum of the fourth column");
  tell("if_it_were", fourth.value() / exact::ln2(), "what β would have to be if nothing were taken away");
  const Fifty alpha = Fifty(swing_.eta) / 2;
  const Fifty K = ratio_by_mean(2 * alpha) * exact::pi() / 2;
  tell("K", static_cast<double>(K), "t√(2g/b)");
  tell("missing", static_cast<double>(K - sum_by_columns<Fifty>(alpha, columns)),
       "what the columns leave out");
}

/*!
How many digits does a column bring? The sums $S_j$ fall, and their quotients rise, so that after $J$ columns
what is missing is caught between

$$ \frac{C\,S_J\,x^J}{1 - x\,S_{J+1}/S_J} \quad\text{and}\quad \frac{S_J\,x^J}{C}. \tag{5} $$

One can go further. The equation that gave {{eq 3}} also lets the whole array collapse into one column, when
the logarithm is not taken of $\cot\frac12\alpha$ but of $\frac4{\sin\alpha}$:

$$ \begin{gathered} K = \sum a_n^2\,x^n\left(l\,\frac4{\sin\alpha} - r_n\right), \\
   r_n = \frac2{1\cdot2} + \frac2{3\cdot4} + \cdots + \frac2{(2n-1)\,2n}. \end{gathered} \tag{6} $$

::: code pendulum/columns.hpp sum_with_one_logarithm
:::
*/

TELL
{
  curve("law", {"j", "S", "law"}, [](Curve& c) {
    const auto S = column_sums<double>(301);
    for(std::size_t j = 1; j <= 300; j += 1 + j / 10)
      c.put({static_cast<double>(j), S[j], std::sqrt(std::numbers::pi / static_cast<double>(j)) / 2});
  });
  curve("missing", {"columns", "a2", "a10", "a30", "a45"}, [](Curve& c) {
    for(int J = 0; J <= 30; ++J)
    {
      std::vector<double> row{1.0 * J};
      for(const double alpha : {2.5_deg, 10_deg, 30_deg, 45_deg})
      {
        const Fifty K = ratio_by_mean(Fifty(2 * alpha)) * exact::pi() / 2;
        row.push_back(static_cast<double>((K - sum_by_columns(Fifty(alpha), J)) / K));
      }
      c.put(row);
    }
  });
}

TELL
{
  const double alpha = swing_.eta / 2;
  std::vector<Method> ways;
  for(const int J : {0, 1, 2, 3, 4, 6})
    ways.push_back({"columns: " + std::to_string(J), [=] { return sum_by_columns(alpha, J); }, "columns"});
  for(const int n : {1, 2, 3, 4, 6})
    ways.push_back({"(6), terms: " + std::to_string(n), [=] { return sum_with_one_logarithm(alpha, n); },
                   "one"});
  ways.push_back({"arithmetic-geometric mean",
                  [=] { return ratio_by_mean(2 * alpha) * std::numbers::pi / 2; }});
  race("K", "t√(2g/b)", ratio_by_mean(Fifty(2 * alpha)) * exact::pi() / 2, ways);
}

/*!
{{table sums}}

The fourth column's sum is $\frac{41}{64}\,l2 - \frac1{128}$, or {{S2|12}}. So β is a fraction less than ¾;
but something is taken away, and it will not go into β, since $l2$ is not a fraction itself.

::: figure pendulum-28
alt: The sums of the columns against their number, both logarithmic. The points approach a straight line of
slope minus one half.

The sums $S_j$. They fall slowly, like $\frac12\sqrt{\pi/j}$; it is the powers of $\sin^2\alpha$ that make the
columns small.
:::

::: figure pendulum-28-columns
alt: Relative error of the time against the number of columns, for alpha of 2.5, 10, 30 and 45 degrees. Each
is nearly a straight line on the logarithmic scale, the steeper the smaller the angle; Euler's two columns are
marked.

What is missing of the time when so many columns are added beside the logarithmic one. Euler stopped at two.
With all of them his method reaches as far as one likes, and at 45°, where {{sec pendulum.11}} has the
semicircle, it still gains three digits in ten columns.
:::

## Checks

First the conjecture. The fourth column's series is added, its remainder caught between $a_{N+2}$ and
$a_{N+1}$ (for its terms are greater than $a_{n+1} - a_{n+2}$ and less than $a_n - a_{n+1}$), and what comes
out is {{eq 4}}.
*/

CHECK_THAT("the fourth column's terms lie between the differences of the a_n, exactly")
{
  for(int n = 1; n <= 60; ++n)
  {
    const Rational term = pendulum::entry(n + 2, 2);
    CHECK(term > double_factorial_ratio(n + 1) - double_factorial_ratio(n + 2));
    CHECK(term < double_factorial_ratio(n) - double_factorial_ratio(n + 1));
  }
}

CHECK_THAT("the series of the fourth column comes as near to 41/64 l 2 − 1/128 as its bounds let it")
{
  const auto fourth = exact_column_sums(3)[2];
  CHECK(fourth.beta == Rational(41, 64));
  CHECK(fourth.rho == Rational(1, 128));
  double a = 1;  // a_n
  double sum = 0;
  for(double n = 1; n <= 1e5; ++n)
  {
    a *= (2 * n - 1) / (2 * n);
    sum += a * std::pow((2 * n + 1) * (2 * n + 3) / ((2 * n + 2) * (2 * n + 4)), 2) / (2 * n);
  }
  const double N = 1e5;
  const double next = a * (2 * N + 1) / (2 * N + 2);
  CHECK(fourth.value() - Fifty(sum)
        == between(next * (2 * N + 3) / (2 * N + 4) - 1e-12, next + 1e-12, "the bounds, and 10⁵ roundings"));
}

/*!
The recurrence {{eq 3}} again, by a way that does not use the equation: {{eq 6}} less $L\,P$, divided by $C$,
with all that is not a multiple of $l2$ set apart, as formal series in exact fractions. It leaves
$S = (1-x)^{-\frac12}\sum a_n^2x^n\left(l2 - r_n - l\,\tfrac12(1+\sqrt{1-x})\right)$.
*/

CHECK_THAT("the recurrence gives the coefficients of that series, forty columns of them")
{
  using Formal = exact::Series<Rational>;
  const int order = 39;
  std::vector<Rational> squares;
  std::vector<Rational> with_r;
  Rational r = 0;
  for(int n = 0; n <= order; ++n)
  {
    squares.push_back(pow(double_factorial_ratio(n), 2));
    with_r.push_back(squares.back() * r);
    r += Rational(2, (2 * n + 1) * (2 * n + 2));
  }
  const Formal root = sqrt(1 - Formal::x(order));
  const Formal P(squares, order);
  const Formal beta = P / root;
  const Formal rho = (Formal(with_r, order) + P * log((1 + root) / 2)) / root;
  const auto S = exact_column_sums(order + 1);
  for(int j = 0; j <= order; ++j)
  {
    CHECK(S[static_cast<std::size_t>(j)].beta == beta[j]);
    CHECK(S[static_cast<std::size_t>(j)].rho == rho[j]);
  }
}

CHECK_THAT("added to the logarithmic column they are the time, and so is the one column (6)")
{
  for(const double alpha : {1e-300, 1_deg, 30_deg, 60_deg})
  {
    const Fifty K = ratio_by_mean(Fifty(2 * alpha)) * exact::pi() / 2;
    CHECK(sum_by_columns(Fifty(alpha), 380) == within_relative(K, 1e-44, "¾ to the 380th is 10⁻⁴⁷"));
    CHECK(sum_with_one_logarithm(Fifty(alpha), 380) == within_relative(K, 1e-44, "the same"));
  }
}

CHECK_THAT("what J columns leave out lies between the bounds (5)")
{
  const auto S = column_sums<Fifty>(11);
  for(const double alpha : {1_deg, 10_deg, 30_deg, 60_deg, 75_deg})
    for(std::size_t J = 0; J < 9; ++J)
    {
      CHECK(S[J + 1] * S[J + 1] < S[J] * S[J + 2]);  // the quotients rise
      const Fifty C = cos(Fifty(alpha));
      const Fifty x = 1 - C * C;
      const Fifty part = S[J] * pow(x, static_cast<int>(J));
      const Fifty K = ratio_by_mean(Fifty(2 * alpha)) * exact::pi() / 2;
      CHECK(K - sum_by_columns(Fifty(alpha), static_cast<int>(J))
            == between(part * C / (1 - x * S[J + 1] / S[J]), part / C, "(5)"));
    }
}

CHECK_THAT("in double the recurrence loses little, and all sums fall as they should")
{
  const auto S = column_sums<double>(1001);
  const auto truth = column_sums<Fifty>(1001);
  for(const std::size_t j : {2u, 10u, 100u, 1000u})
  {
    CHECK(S[j] == within_relative(truth[j], 1e-15 * static_cast<double>(j),
          "an error grows in proportion to j"));
    CHECK(S[j] < S[j - 1]);
  }
  const double law = std::sqrt(std::numbers::pi / 1000) / 2 - 1 / (1000 * std::numbers::pi);
  CHECK(S[1000] == within_relative(law, 2e-3, "½√(π/j) − 1/(πj), and what is a jth of the first"));
}

/*!
The conjecture itself is an erratum of Euler's, though he says no more than that it seems probable: were
$S_2 = \beta\,l2$ with a fraction β, then $l2 = \rho_2/(\beta_2 - \beta)$ would be a fraction, which it is
not. And the scan has taken the limit for β, like the sum in {{sec pendulum.27}}, down to ¼.
*/

const Erratum form{
    "§28, the sum of the fourth column", {"β l 2, nothing taken away", 0.0},
    {"β l 2 − 1/128, with β = 41/64", 1.0 / 128},
    "the series, summed exactly, has a part without l 2, and l 2 is irrational",
    [](double rho) { return Rational::exactly(rho) == exact_column_sums(3)[2].rho; }};

const Emendation limit{
    "§28, β less than", {"¼", 0.25}, {"¾", 0.75},
    "§27 has found ¾ for the third column, and the fourth has 0,63",
    [](double bound) { return exact_column_sums(3)[2].value() < Fifty(bound) * exact::ln2(); }};
