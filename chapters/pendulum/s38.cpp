#include "edition/section.hpp"
#include "pendulum/columns.hpp"
#include "pendulum/series.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 38, "An invitation, and what came of it")

using namespace pendulum;

/*!
## What Euler does

He closes by saying why he has given the widest swings so much care: of all who studied the motion of
pendulums nobody had touched this case. Yet it deserves the greatest attention, since it cannot be solved
without devices of its own, in the calculation and in the integrations; and the series of the fourth and
later columns, which he had to pass over here, may give geometers an occasion to carry this fine part of
analysis further.

The invitation can be accepted. All his columns have sums, and one line gives them in turn
({{sec pendulum.28}}): with $S_0 = l2$ and $S_1 = \tfrac34\,l2$,

$$ (j+1)^2 S_{j+1} = \left(2j^2 + 2j + \tfrac34\right) S_j - j^2 S_{j-1} - \frac{j\,a_j^2}{4(j+1)}. \tag{1} $$

With them the method of the supplement is complete, from the top down to a right angle and beyond. What
remains is to set it beside what was found after him, in agreement over three hundred powers of ten.

::: margin
$a_j = \frac12\cdot\frac34\cdots\frac{2j-1}{2j}$, as in {{sec pendulum.08}}.
:::

## The program

Four ways to one number. The first is Euler's, carried through: the logarithmic column and as many of the
others as it takes.
*/

double by_all_columns(double eta)  // (1)
{
  int columns = 3;
  for(double x = std::pow(std::sin(eta / 2), 2), left = x * x * x; left > 1e-17; left *= x)
    ++columns;
  return 2 / std::numbers::pi * sum_by_columns(eta / 2, columns);
}

/*!
The second collapses the whole array into one column of logarithms.
*/

double by_one_logarithm(double eta)
{
  int terms = 3;
  for(double x = std::pow(std::sin(eta / 2), 2), left = x * x * x; left > 1e-17; left *= x)
    ++terms;
  return 2 / std::numbers::pi * sum_with_one_logarithm(eta / 2, terms);
}

/*!
The third is the arithmetic-geometric mean. The fourth is Jacobi's: with the nome $q'$ of the complementary
swing, whose series converge at a breathtaking rate,

$$ \frac T\Theta = \frac1\pi\,\ln\frac1{q'}\;\vartheta_3(q')^2, \qquad q' = \varepsilon + 2\varepsilon^5 + 15\varepsilon^9 + \cdots, \quad
   \varepsilon = \frac{1-\sqrt{c}}{2(1+\sqrt{c})}. \tag{2} $$

Near the top ε is below the smallest double, so that its logarithm has to be carried; and since $1-c$ is
$2\sin^2\tfrac14\eta$, it is the square of $\sin\tfrac14\eta/(1+\sqrt c)$, in which nothing cancels.
*/

double by_theta(double eta)  // (2)
{
  const double root = std::sqrt(std::cos(eta / 2));
  const double log_epsilon = 2 * (std::log(std::sin(eta / 4)) - std::log1p(root));
  const double e4 = std::exp(4 * log_epsilon);
  const double log_nome = log_epsilon + std::log1p(e4 * (2 + e4 * (15 + e4 * (150 + e4 * 1707))));
  const double nome = std::exp(log_nome);
  const double theta = 1 + 2 * nome * (1 + std::pow(nome, 3) * (1 + std::pow(nome, 5)));
  return -log_nome / std::numbers::pi * theta * theta;
}

/*!
Any distance from the top will do.
*/

const auto swing_ = amplitude_from_top(1_deg, open(80_deg, 180_deg));

TELL
{
  const double eta = swing_.eta;
  const Fifty exact = ratio_by_mean(swing_.eta.fifty());
  tell("T_over_Theta", exact, "T/Θ to thirty digits");
  race("ratio", "T/Θ", exact,
       {{"all columns", [=] { return by_all_columns(eta); }},
        {"one column of logarithms", [=] { return by_one_logarithm(eta); }},
        {"arithmetic-geometric mean", [=] { return ratio_by_mean(eta); }},
        {"theta function", [=] { return by_theta(eta); }},
        {"this edition", [=] { return swing::ratio_from_top(eta); }}});
}

/*!
How they agree with fifty digits, from a right angle to one part in $10^{300}$ of a radian:
*/

TELL
{
  curve("agreement", {"power", "columns", "logarithm", "mean", "theta", "edition"}, [](Curve& c) {
    for(double power = 0.19; power > -300; power -= power > -20 ? 0.25 : 1.5)
    {
      const double eta = std::pow(10, power);
      const Fifty exact = ratio_by_mean(Fifty(eta));
      const auto error = [&](double x) { return exact::ulps(x, exact); };
      c.put({power, error(by_all_columns(eta)), error(by_one_logarithm(eta)), error(ratio_by_mean(eta)),
             error(by_theta(eta)), error(swing::ratio_from_top(eta))});
    }
  });
}

/*!
::: figure pendulum-38
alt: Errors of the five ways in units of the last place, against eta from 1.5 radians down to ten to the
minus 300, on a logarithmic scale. All lie below four ulp; the columns, the mean and the theta function
wander, the edition's own function stays below one.

The invitation, answered: Euler's columns, the mean, Jacobi's theta function and the edition's own table,
all within a few units of the last place of the fifty-digit value, from a right angle to $10^{-300}$ of a
radian.
:::

## Checks
*/

CHECK_THAT("the four ways agree with fifty digits from a right angle to the last power of ten")
{
  for(const double eta : {1.5, 1.0, 0.1, 1e-3, 1e-6, 1e-9, 1e-16, 1e-150, 1e-300})
  {
    const Fifty exact = ratio_by_mean(Fifty(eta));
    const char* why = "a logarithm, a few products and sums";
    CHECK(by_all_columns(eta) == within_ulps(exact, 6, why));
    CHECK(by_one_logarithm(eta) == within_ulps(exact, 6, why));
    CHECK(ratio_by_mean(eta) == within_ulps(exact, 6, "a dozen means, each rounded"));
    CHECK(by_theta(eta) == within_ulps(exact, 6, why));
    CHECK(swing::ratio_from_top(eta) == within_ulps(exact, 1.5, "the library's bound"));
  }
}

/*!
The line {{eq 1}} is checked against the definition of the columns, the sum of what stands in them, with a
bound for the tail that is not added.
*/

CHECK_THAT("the recurrence gives the sums of the columns as Euler's array defines them")
{
  const auto S = column_sums<double>(8);
  for(int j = 0; j < 8; ++j)
  {
    const int rows = 80;
    Rational sum = 0;
    for(int m = j + 1; m <= rows; ++m)
      sum += entry(m, j);
    const double tail = double(exact::double_factorial_ratio(rows)) * (rows + 1.0) / (rows + 1.0 - j);
    CHECK(S[static_cast<std::size_t>(j)]
          == between(Fifty(sum), Fifty(sum) + Fifty(tail),
                     "an entry is below a_m/2(m−j), and those of the tail sum to less than a₈₀·81/(81−j)"));
  }
}
