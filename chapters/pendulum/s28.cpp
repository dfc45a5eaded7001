#include "edition/section.hpp"
#include "pendulum/columns.hpp"

SECTION(pendulum, 28, "The fourth column, a conjecture, and all the others")

using exact::double_factorial_ratio;
using pendulum::column_sums, pendulum::exact_column_sums, pendulum::ratio_by_mean;
using pendulum::sum_by_columns, pendulum::sum_with_one_logarithm;

/*!
## What Euler does

Euler leaves the fourth column out and guesses its sum. It could be found like the third, he says, but by a
calculation much more laborious and tedious still, and it is not needed: the column has the factor
$\cos\alpha\sin^4\alpha$, and with $\alpha = \frac12\eta$ and η as small as is supposed the fourth power can
safely be neglected. Besides, it seems to him quite probable that the coefficient will again be of the form

$$ \beta\; l2, \tag{1} $$

where β is a fraction less than ¾. With all this he is ready for a problem that would otherwise be most
difficult. A pendulum swings about its axis $A$ through arcs that fall little short of 180° on the way up as
on the way down; how long does each swing take? The solution begins in {{sec pendulum.29}}.

## The program

All columns can be summed at once. Let $x = \sin^2\alpha$, $L = l\cot\frac12\alpha$ and $u = \cos\alpha$; the
array says that the time of the descent, in the unit $\sqrt b/\sqrt{2g}$, is

$$ K = L\,P(x) + u\,S(x), \qquad P = \sum a_n^2\, x^n, \qquad S = \sum S_j\,x^j, \tag{2} $$

where $a_n = \frac{1\cdot3\cdots(2n-1)}{2\cdot4\cdots2n}$, and $S_0 = l2$ and $S_1 = \frac34l2$ are known from
{{sec pendulum.22}} and {{sec pendulum.27}}. Now $K$ and $P$ both satisfy one equation,
$4\frac{d}{dx}\left(x(1-x)\frac{dy}{dx}\right) = y$. When {{eq 2}} is put into it, the logarithm drops out,
and what is left ties each column's sum to the two before it:

$$ (j+1)^2 S_{j+1} = \left(2j^2 + 2j + \tfrac34\right) S_j - j^2 S_{j-1} - \frac{j\,a_j^2}{4(j+1)}. \tag{3} $$

::: margin
Today: the equation of $K(k)$ with $k^2 = 1 - x$, symmetrical in $x$ and $1 - x$. $P$ is
$\frac2\pi K(\sin\alpha)$.
:::

::: code pendulum/columns.hpp column_sums (3)
:::

In exact fractions, {{eq 3}} gives every sum in the form

$$ S_j = \beta_j\, l2 - \rho_j. \tag{4} $$
*/

Fifty K(const Fifty& alpha)  // (2), by the mean of Gauss
{
  return ratio_by_mean(2 * alpha) * exact::pi() / 2;
}

const auto swing_ = amplitude_from_top(5_deg);
const auto columns = integer("columns", 7, 1, 200, "columns that are summed, beside the logarithmic one");

TELL
{
  auto& sums = table("sums", "The sums of the columns, (4).",
                     {{"j", "j"}, {"beta", "β"}, {"rho", "ρ"}, {"S", "β l 2 − ρ", none, 15}});
  const auto S = exact_column_sums(columns);
  for(std::size_t j = 0; j < S.size() && j < 12; ++j)  // the fractions of the later ones fill lines
    sums.row({static_cast<double>(j), S[j].beta.str(), S[j].rho.str(), static_cast<double>(S[j].value())});
  const auto fourth = exact_column_sums(3)[2];
  tell("beta", fourth.beta, "what stands before l 2 in the fourth column");
  tell("rho", fourth.rho, "and what is taken away");
  tell("S2", fourth.value(), "the sum of the fourth column");
  const Fifty alpha = swing_.eta.fifty() / 2;
  tell("K", static_cast<double>(K(alpha)), "t√(2g/b)");
  tell("missing", static_cast<double>(K(alpha) - sum_by_columns(alpha, columns)),
       "what the columns leave out");
}

/*!
The sums $S_j$ fall and their quotients rise, so that after $J$ columns what is missing is caught between

$$ \frac{u\,S_J\,x^J}{1 - x\,S_{J+1}/S_J} \quad\text{and}\quad \frac{S_J\,x^J}{u}. \tag{5} $$

The same equation even lets the whole array collapse into one column, when the logarithm is not taken of
$\cot\frac12\alpha$ but of $\frac4{\sin\alpha}$:

$$ \begin{gathered} K = \sum a_n^2\,x^n\left(l\,\frac4{\sin\alpha} - r_n\right), \\
   r_n = \frac2{1\cdot2} + \frac2{3\cdot4} + \cdots + \frac2{(2n-1)\,2n}. \end{gathered} \tag{6} $$

::: code pendulum/columns.hpp sum_with_one_logarithm (6)
:::
*/

TELL
{
  curve("missing", {"columns", "a2", "a10", "a30", "a45"}, [](Curve& c) {
    for(int J = 0; J <= 30; ++J)
    {
      std::vector<double> row{1.0 * J};
      for(const double alpha : {2.5_deg, 10_deg, 30_deg, 45_deg})
        row.push_back(static_cast<double>(1 - sum_by_columns(Fifty(alpha), J) / K(alpha)));
      c.put(row);
    }
  });
}

/*!
{{table sums}}

The fourth column sums to $\frac{41}{64}\,l2 - \frac1{128}$ = {{S2|12}}. That is less than
$\frac34\,l2$, as he thought; but the fraction that is taken away will not go into β, since $l2$ is
irrational.

::: figure pendulum-28
alt: Relative error of the time against the number of columns, for alpha of 2.5, 10, 30 and 45 degrees. Each
is nearly a straight line on the logarithmic scale, the steeper the smaller the angle; Euler's two columns are
marked.

What is missing of the time when so many columns are added beside the logarithmic one. Euler stopped at two.
With all of them his method reaches as far as one likes: even at 45°, the semicircle of {{sec pendulum.11}},
ten columns gain more than three digits.
:::

## Speed against error
*/

TELL
{
  const double alpha = swing_.eta / 2;
  std::vector<Method> ways;
  for(const int J : {0, 2, 4, 6})
    ways.push_back({"columns: " + std::to_string(J), [=] { return sum_by_columns(alpha, J); }, "columns"});
  for(const int n : {1, 2, 4, 6})
    ways.push_back(
        {"(6), terms: " + std::to_string(n), [=] { return sum_with_one_logarithm(alpha, n); }, "one"});
  ways.push_back(
      {"arithmetic-geometric mean", [=] { return ratio_by_mean(2 * alpha) * std::numbers::pi / 2; }});
  race("K", "t√(2g/b)", K(alpha), ways);
}

/*!
## Checks

First the conjecture. The sum needs no equation and no new device: the fourth column's terms are so many times
those of the second, which sum to $l2$, and differences that cancel from term to term,

$$ \begin{gathered} \frac{a_{n+2}^2}{2n\,a_n} = \frac{41}{64}\cdot\frac{a_n}{2n} + d_n - d_{n+1}, \\
   d_n = \frac{23n^3 + 11n^2 - 22n - 16}{64\,n\,(n+1)^2}\,a_n. \end{gathered} \tag{7} $$

The differences add up to $d_1 = -\frac1{128}$, since $d_n$ vanishes in the end, with $a_n$.
*/

Rational d(int n)  // (7)
{
  const Rational numerator = ((Rational(23) * n + 11) * n - 22) * n - 16;
  return numerator / (Rational(64) * n * (n + 1) * (n + 1)) * double_factorial_ratio(n);
}

CHECK_THAT("a term of the fourth column is as (7) has it, exactly, and its differences leave −1/128")
{
  for(int n = 1; n <= 40; ++n)
    CHECK(pendulum::entry(n + 2, 2)
          == Rational(41, 64) * double_factorial_ratio(n) / (2 * n) + d(n) - d(n + 1));
  CHECK(d(1) == Rational(-1, 128));
  CHECK(exact_column_sums(3)[2].beta == Rational(41, 64));
  CHECK(exact_column_sums(3)[2].rho == -d(1));
}

/*!
Forty values of $n$ prove {{eq 7}} for all, since both sides, times $n(n+1)^2(n+2)^2/a_n$, are polynomials of
the fifth degree at most. Now were $S_2 = \beta\,l2$ with a fraction β, then
$l2 = \frac1{128}\big/\left(\frac{41}{64} - \beta\right)$ would be a fraction too. The scan, besides, has
taken the limit for β down to ¼, like the sum in {{sec pendulum.27}}.
*/

const Erratum form{
    "§28, the conjecture on the fourth column",
    {"β l 2, nothing taken away", 0.0},
    {"β l 2 − 1/128, with β = 41/64", 1.0 / 128},
    "the differences (7) sum to a fraction, which β l 2 cannot take up, l 2 being irrational",
    [](double taken_away) {
      Rational sum = 0;  // of the differences, term by term, to within d₆₁
      for(int n = 1; n <= 60; ++n)
        sum += pendulum::entry(n + 2, 2) - Rational(41, 64) * double_factorial_ratio(n) / (2 * n);
      return Rational::exactly(-taken_away) - sum == d(61);
    }};

const Emendation limit{
    "§28, β less than",
    {"¼", 0.25},
    {"¾", 0.75},
    "§27 has found ¾ for the third column, and the fourth sums to 0,63 l 2",
    [](double bound) { return exact_column_sums(3)[2].value() < Fifty(bound) * exact::ln2(); }};

/*!
Then the others. Added to the logarithmic column they must make the time, and what is left out must lie
between the bounds.
*/

CHECK_THAT("all columns with the logarithmic one are the time, and so is the one column (6)")
{
  for(const double alpha : {1e-300, 1_deg, 30_deg, 60_deg})
  {
    CHECK(sum_by_columns(Fifty(alpha), 380) == within_relative(K(alpha), 1e-47, "¾ to the 380th is 10⁻⁴⁷"));
    CHECK(sum_with_one_logarithm(Fifty(alpha), 380) == within_relative(K(alpha), 1e-47, "the same"));
  }
}

CHECK_THAT("what J columns leave out lies between the bounds (5)")
{
  const auto S = column_sums<Fifty>(11);
  for(const double alpha : {1_deg, 10_deg, 30_deg, 60_deg, 75_deg})
    for(std::size_t J = 0; J < 9; ++J)
    {
      CHECK(S[J + 1] * S[J + 1] < S[J] * S[J + 2]);  // the quotients rise
      const Fifty u = cos(Fifty(alpha));
      const Fifty x = 1 - u * u;
      const Fifty part = S[J] * pow(x, static_cast<int>(J));
      CHECK(K(alpha) - sum_by_columns(Fifty(alpha), static_cast<int>(J))
            == between(part * u / (1 - x * S[J + 1] / S[J]), part / u, "(5)"));
    }
}
