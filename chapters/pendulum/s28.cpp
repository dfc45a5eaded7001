#include "edition/section.hpp"
#include "pendulum/columns.hpp"
#include "swing/oracle.hpp"

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

where β is a fraction less than ¾ {{entry limit}}. With all this he is ready for a problem that would
otherwise be most
difficult. A pendulum swings about its axis $A$ through arcs that fall little short of 180° on the way up as
on the way down; how long does each swing take? The solution begins in {{sec pendulum.29}}.

## The program

All columns can be summed at once. Let $x = \sin^2\alpha$, $L = l\cot\frac12\alpha$ and $u = \cos\alpha$; the
array says that the time of the descent, counted in units of $\sqrt b/\sqrt{2g}$, is

$$ K = L\,P(x) + u\,S(x), \qquad P = \sum a_n^2\, x^n, \qquad S = \sum S_j\,x^j, \tag{A} $$

::: margin
Today: the equation of $K(k)$ with $k^2 = 1 - x$, symmetrical in $x$ and $1 - x$. $P$ is
$\frac2\pi K(\sin\alpha)$.
:::

where $a_n = \frac{1\cdot3\cdots(2n-1)}{2\cdot4\cdots2n}$, and $S_0 = l2$ and $S_1 = \frac34l2$ are known from
{{sec pendulum.22}} and {{sec pendulum.27}}. Now $K$ and $P$ both satisfy one equation,
$4\frac{d}{dx}\left(x(1-x)\frac{dy}{dx}\right) = y$. When {{eq A}} is put into it, the logarithm itself has
the factor that makes
$P$ vanish, and drops out. What its derivative leaves, $\frac{dL}{dx} = -\frac1{2xu}$, and $\frac{du}{dx} =
-\frac1{2u}$ turn the
rest, multiplied by $u$, into

$$ \begin{aligned} 4(1-x)^2\left(S' + x\,S''\right) &- 8x(1-x)\,S' - (3-4x)\,S \\
   &= 4(1-x)\,P' - P, \end{aligned} $$

and the power $x^j$ of this, with $4(j+1)^2a_{j+1}^2 = (2j+1)^2a_j^2$, ties each column's sum to the
two before it:

$$ (j+1)^2 S_{j+1} = \left(2j^2 + 2j + \tfrac34\right) S_j - j^2 S_{j-1} - \frac{j\,a_j^2}{4(j+1)}. \tag{B} $$

::: code pendulum/columns.hpp column_sums (B)
:::

In exact fractions, {{eq B}} gives every sum in the form

$$ S_j = \beta_j\, l2 - \rho_j. \tag{C} $$
*/

Fifty K(const Fifty& alpha)  // (A), by the mean of Gauss
{
  return ratio_by_mean(2 * alpha) * exact::pi() / 2;
}

const auto swing_ = amplitude_from_top(5_deg, from_below(90_deg, 180_deg));
const auto columns = integer("columns", 7, 1, 200, "columns that are summed, beside the logarithmic one");

double beyond(int J)  // what J columns leave out of K; nothing, where fifty digits cannot tell
{
  const Fifty alpha = swing_.eta.fifty() / 2, whole = K(alpha), left = whole - sum_by_columns(alpha, J);
  return abs(left) < Fifty("1e-46") * whole ? 0 : static_cast<double>(left);
}

TELL
{
  auto& sums = table("sums", "The sums of the columns, (C)",
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
  tell("missing", beyond(columns), "what the columns leave out, as far as fifty digits tell", 6);
}

/*!
The terms of $S_j$ are $\frac{a_{i+j}^2}{2i\,a_i}$, with $i$ from 1. When $j$ grows by one, each is
multiplied by
$\left(\frac{2i+2j+1}{2i+2j+2}\right)^2$, which is less than 1 and rises with $j$. So the sums fall, and
since sequences
whose quotients rise keep that property when they are added, the quotients of the sums rise. After $J$
columns what is missing is
therefore caught between

$$ \frac{u\,S_J\,x^J}{1 - x\,S_{J+1}/S_J} \quad\text{and}\quad \frac{S_J\,x^J}{u}. \tag{D} $$

The same equation even lets the whole array collapse into one column, when the logarithm is not taken of
$\cot\frac12\alpha$ but of $\frac4{\sin\alpha}$, whose derivative is $-\frac1{2x}$. With $K =
P\,l\frac4{\sin\alpha} - \sum
a_n^2r_nx^n$ the power $x^n$ of the equation says $r_{n+1} - r_n = \frac{2}{(2n+1)(2n+2)}$, and $r_0 = 0$
because $S_0 = l2$:

$$ \begin{gathered} K = \sum a_n^2\,x^n\left(l\,\frac4{\sin\alpha} - r_n\right), \\
   r_n = \frac2{1\cdot2} + \frac2{3\cdot4} + \cdots + \frac2{(2n-1)\,2n}. \end{gathered} \tag{E} $$

::: code pendulum/columns.hpp sum_with_one_logarithm (E)
:::
*/

TELL
{
  curve("lacking", {"columns", "a2", "a10", "a30", "a45"}, [](Curve& c) {
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
$\frac34\,l2$, which he may have guessed; but the fraction that is taken away will not go into β, since $l2$
is irrational.

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
        {"(E), terms: " + std::to_string(n), [=] { return sum_with_one_logarithm(alpha, n); }, "one"});
  ways.push_back(
      {"arithmetic-geometric mean", [=] { return ratio_by_mean(2 * alpha) * std::numbers::pi / 2; }});
  race("descent", "t√(2g/b)", K(swing_.eta.fifty() / 2), ways);
}

/*!
## Checks

First the conjecture. The sum needs no equation and no new device: the fourth column's terms are so many times
those of the second, which sum to $l2$, and differences that cancel from term to term,

$$ \begin{gathered} \frac{a_{n+2}^2}{2n\,a_n} = \frac{41}{64}\cdot\frac{a_n}{2n} + d_n - d_{n+1}, \\
   d_n = \frac{23n^3 + 11n^2 - 22n - 16}{64\,n\,(n+1)^2}\,a_n. \end{gathered} \tag{F} $$

The differences add up to $d_1 = -\frac1{128}$, since $d_n$ vanishes in the end, with $a_n$.
*/

Rational d(int n)  // (F)
{
  const Rational numerator = ((Rational(23) * n + 11) * n - 22) * n - 16;
  return numerator / (Rational(64) * n * (n + 1) * (n + 1)) * double_factorial_ratio(n);
}

CHECK_THAT("a term of the fourth column is as (F) has it, exactly, and its differences leave −1/128")
{
  for(int n = 1; n <= 40; ++n)
    CHECK(pendulum::entry(n + 2, 2)
          == Rational(41, 64) * double_factorial_ratio(n) / (2 * n) + d(n) - d(n + 1));
  CHECK(d(1) == Rational(-1, 128));
  CHECK(exact_column_sums(3)[2].beta == Rational(41, 64));
  CHECK(exact_column_sums(3)[2].rho == -d(1));
}

/*!
Forty values of $n$ prove {{eq F}} for all, since both sides, times $n(n+1)^2(n+2)^2/a_n$, are polynomials of
the fifth degree at most. Now were $S_2 = \beta\,l2$ with a fraction β, then
$l2 = \frac1{128}\big/\left(\frac{41}{64} - \beta\right)$ would be a fraction too, which it is not. So the
conjecture is
refuted; a slip it was not, for he only found it probable. Our copy has ¼ for the limit of β, as it has for
the sum in {{sec
pendulum.27}}, where ¾ is certain. What a man held to be probable cannot be restored from what is true.
*/

CHECK_THAT("the differences (F), term by term, sum to −1/128 but for the last of them")
{
  Rational sum = 0;
  for(int n = 1; n <= 60; ++n)
    sum += pendulum::entry(n + 2, 2) - Rational(41, 64) * double_factorial_ratio(n) / (2 * n);
  CHECK(sum == Rational(-1, 128) - d(61));
}

const Undecided limit{
    "§28, β less than",
    {"¼", 0.25},
    {"¾", 0.75},
    "either may have been guessed: a column's sum is positive and less than that of the second, l 2",
    [](double bound) { return bound > 0 && bound < 1; }};

/*!
Then the others. Added to the logarithmic column they must make the time, and what is left out must lie
between the bounds.
*/

CHECK_THAT("all columns with the logarithmic one are the time, and so is the one column (E)")
{
  for(const double alpha : {1e-300, 1_deg, 30_deg, 60_deg})
  {
    CHECK(sum_by_columns(Fifty(alpha), 380) == within_relative(K(alpha), 1e-47, "¾ to the 380th is 10⁻⁴⁷"));
    CHECK(sum_with_one_logarithm(Fifty(alpha), 380) == within_relative(K(alpha), 1e-47, "the same"));
  }
}

CHECK_THAT("what J columns leave out lies between the bounds (D)")
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
            == between(part * u / (1 - x * S[J + 1] / S[J]), part / u, "(D)"));
    }
}

/*!
What is told, and what the figure shows, once more from other sources: the sums from the entries of the
array, by Euler's
logarithm and the bound of {{eq D}}.
*/

CHECK_THAT("the sums told are β l 2 − ρ with the fractions of the recurrence, and the first are Euler's")
{
  for(const Told& now : told_at("", "eta=1e-100rad columns=3", "eta=90 columns=12"))
  {
    const auto rows = now.rows("sums");
    for(std::size_t j = 0; j < rows.size(); ++j)
    {
      CHECK(rows[j].value("j") == within(Fifty(static_cast<int>(j)), 0, "a count"));
      const Rational beta(rows[j].words("beta").c_str()), rho(rows[j].words("rho").c_str());
      const Fifty S = Fifty(beta) * exact::ln2() - Fifty(rho);
      CHECK(rows[j].value("S") == within_relative(S, 2e-16, "rounded to a double"));
      Fifty some = 0;
      for(int n = 1; n <= 40; ++n)
        some += static_cast<Fifty>(pendulum::entry(n + static_cast<int>(j), static_cast<int>(j)));
      CHECK(S - some
            == between(0, Fifty(double_factorial_ratio(40)), "the entries are less than those of l 2"));
    }
    CHECK(now.value("beta") == Rational(41, 64));
    CHECK(now.value("rho") == Rational(1, 128));
    CHECK(now.value("S2")
          == within(Fifty(41) / 64 * log(Fifty(2)) - Fifty(1) / 128, 1e-28, "as told, 30 digits"));
    const Fifty alpha = swing_.eta.fifty() / 2, truth = swing::oracle::K_from_complement(sin(alpha));
    CHECK(now.value("K") == within_relative(truth, 2e-16, "rounded to a double"));
    const Fifty x = pow(sin(alpha), 2),
                most = log(Fifty(2)) * pow(x, static_cast<int>(columns)) / cos(alpha);
    CHECK(now.value("missing") == between(0, most, "no column's sum is above l 2"));
  }
}

CHECK_THAT("the ways of the race leave out what their bounds allow, and the figure's lines too")
{
  for(const Told& now : told_at("", "eta=1e-100rad columns=3", "eta=90 columns=12"))
  {
    const Fifty alpha = swing_.eta.fifty() / 2, truth = swing::oracle::K_from_complement(sin(alpha));
    const double x = std::pow(std::sin(swing_.eta / 2), 2), size = static_cast<double>(truth);
    CHECK(now.exact("descent") == within_relative(truth, 1e-45, "two ways of fifty digits"));
    for(const int J : {0, 2, 4, 6})
      CHECK(now.method("descent", "columns: " + std::to_string(J))
            == between(truth - std::log(2.) * std::pow(x, J) / std::sqrt(1 - x) - 1e-15 * size,
                       truth + 1e-15 * size, "(D)"));
    for(const int n : {1, 2, 4, 6})
      CHECK(now.method("descent", "(E), terms: " + std::to_string(n))
            == between(truth - std::pow(x, n) * size - 1e-15 * size, truth + 1e-15 * size,
                       "the terms fall like x"));
    CHECK(now.method("descent", "arithmetic-geometric mean")
          == within_ulps(truth, 5, "η rounds, and its own bound"));
  }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("lacking", 4))
      for(const auto& [column, degree] :
          {std::pair{"a2", 2.5}, std::pair{"a10", 10.}, std::pair{"a30", 30.}, std::pair{"a45", 45.}})
      {
        const Fifty alpha = degree * exact::pi() / 180, x = pow(sin(alpha), 2),
                    truth = swing::oracle::K_from_complement(sin(alpha));
        const int J = static_cast<int>(point.at("columns"));
        const auto S = exact_column_sums(J + 1);
        const Fifty least = S.back().value() * pow(x, J) * cos(alpha) / truth,
                    most = S.back().value() * pow(x, J) / cos(alpha) / truth;
        CHECK(point.value(column) == between(least - Fifty(1e-15), most + Fifty(1e-15), "(D); α rounds"));
      }
  for(const Told& now : told_at(""))
  {
    const auto points = now.points("lacking");
    CHECK(points.at(10).at("columns") == 10);
    CHECK(points[10].at("a45") < 1e-3 * points[0].at("a45"));  // ten columns gain more than three digits
  }
}

/*!
## Go on from here

::: exercise
How many columns does the semicircle take, 90° from the top, if less than $10^{-10}$ is to be left out?

answer: It takes 31. There $x = \frac12$, and every column beyond the first few halves what is missing:
30 leave $1.9\cdot10^{-10}$, 31 leave $0.96\cdot10^{-10}$.
:::
*/

CHECK_THAT("for the semicircle 31 columns leave out less than 10⁻¹⁰, and 30 do not")
{
  for(const Told& now : told_at("eta=90 columns=30"))
    CHECK(now.value("missing") == within(1.9e-10, 0.05e-10, "two digits"));
  for(const Told& now : told_at("eta=90 columns=31"))
    CHECK(now.value("missing") == within(0.96e-10, 0.005e-10, "two digits"));
}
