#include "edition/section.hpp"
#include "pendulum/columns.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 38, "An invitation, and what came of it")

using namespace pendulum;

/*!
## What Euler does

Euler closes by saying why he has treated the widest swings, whose arc is all but the whole circle, with such
care: of all who studied the motion of pendulums, none had touched this case. Yet it deserves the greatest
attention, because it cannot be solved without devices of its own, both in the calculation and in the
integrations. And the summation of the fourth and later columns, which he had to pass over here, may give
geometers an occasion to carry this fine part of analysis further.

The invitation can be accepted. All the columns have sums, and {{eq pendulum.28 B}} gives them, each from the
two before it. With them the method of the supplement is complete, and the gap of {{sec pendulum.37}} is
closed.

## The program

With $x = \sin^2\alpha$, what $J$ columns beside the logarithmic one leave out is less than $S_J
x^J/\cos\alpha$ ({{eq pendulum.28 D}}), and none of the sums $S_J$ is greater than the first, $l2$. So the
program knows beforehand how many bring what is left out below $10^{-16}$ of the time.
*/

int columns_needed(double eta)
{
  const double x = std::pow(std::sin(eta / 2), 2);
  const double enough = 1e-16 * swing::quarter_time_from_top(eta);
  int J = 0;
  for(double left = std::numbers::ln2 / std::cos(eta / 2); left > enough; left *= x)
    ++J;
  return J;
}

double by_columns(double eta)  // T/Θ
{
  return 2 / std::numbers::pi * sum_by_columns(eta / 2, columns_needed(eta));
}

/*!
His own series of {{sec pendulum.09}} leaves out, after $n$ terms, less than the next term over $1 - cc$.
*/

int terms_needed(double zeta)
{
  const double cc = std::pow(std::sin(zeta / 2), 2);
  const double enough = 1e-16 * (1 - cc) * swing::ratio_from_bottom(zeta);
  int n = 0;
  for(double next = 1; next > enough; ++n)
    next *= std::pow((2 * n + 1.0) / (2 * n + 2), 2) * cc;
  return n;
}

/*!
Together they are a rule for every swing: up to a right angle the one, beyond it the other.
*/

double by_both(swing::Amplitude a)  // T/Θ
{
  return a.zeta > a.eta ? by_columns(a.eta) : series(std::pow(a.modulus(), 2), terms_needed(a.zeta));
}

const auto swing_ = amplitude_from_top(1_deg, open(80_deg, 180_deg));

TELL
{
  tell("T_over_Theta", ratio_by_mean(swing_.eta.fifty()), "T/Θ to thirty digits");
  tell("columns", columns_needed(swing_.eta), "columns that leave out less than 1e-16 of the time");
  tell("columns_1", columns_needed(1_deg), "columns that leave out less than 1e-16 of the time, at η = 1°");
  tell("columns_90", columns_needed(90_deg), "the same at 90°");
  tell("terms_1", terms_needed(179_deg), "terms of the series of §9 that do so, at η = 1°");
  tell("terms_90", terms_needed(90_deg), "the same at 90°");
}

TELL
{
  curve("needed", {"zeta", "columns", "terms"}, [](Curve& c) {
    for(double zeta = 1; zeta < 179.5; ++zeta)
      c.put({zeta, zeta < 50 ? std::nan("") : columns_needed((180 - zeta) * 1_deg),
             zeta > 130 ? std::nan("") : terms_needed(zeta * 1_deg)});
  });
}

/*!
For a swing that falls short of the top by 1° it takes {{terms_1}} terms of the series to bring what is left
out below $10^{-16}$ of the time. They are counted, not to be added in doubles: so many roundings would leave
more than that. Of the columns, beside the logarithmic one, it takes {{columns_1}}; but the logarithmic one
needs the sum of Euler's series for the small swing of 1°, which is had here from the mean of Gauss. Series
and array meet near a right angle, where it takes {{terms_90}} terms or {{columns_90}} columns. The wider the
swing from there, the fewer columns it takes; the narrower, the fewer terms.

::: figure pendulum-38
alt: How many terms the series and how many columns the array need for sixteen digits, against the amplitude.
The terms rise from a few to about fifty at 90 degrees and steeply on; the columns fall from there to a few
near 180 degrees.

The invitation, answered: how many terms of the dissertation's series, or columns of the supplement's array,
leave out less than $10^{-16}$ of the time.
:::

## Speed against error

The columns take their sums from the recurrence each time; a table of them would be quicker.
*/

TELL
{
  const double eta = swing_.eta;
  race("ratio", "T/Θ", ratio_by_mean(swing_.eta.fifty()),
       {{"all columns", [=] { return by_columns(eta); }},
        {"one column of logarithms",
         [=] { return 2 / std::numbers::pi * sum_with_one_logarithm(eta / 2, columns_needed(eta)); }},
        {"arithmetic-geometric mean", [=] { return ratio_by_mean(eta); }},
        {"this edition", [=] { return swing::ratio_from_top(eta); }}});
}

/*!
## Checks
*/

CHECK_THAT("by terms or by columns, every swing comes out to a few units of the last place")
{
  for(const double small : {1.57, 1.0, 0.1, 1e-3, 1e-8, 1e-16, 1e-150, 1e-300})
  {
    CHECK(by_both(swing::Amplitude::from_eta(small))
          == within_ulps(ratio_by_mean(Fifty(small)), 4,
                         "a logarithm, a mean and a polynomial, each rounded"));
    CHECK(by_both(swing::Amplitude::from_zeta(small))
          == within_ulps(ratio_by_mean(exact::pi() - Fifty(small)), 6, "up to 47 additions, each rounded"));
  }
}

/*!
What is told, near the top and at both ends of the range; and that the numbers of columns and terms do what
is said of them, and one fewer does not, by the bounds that the program uses, in fifty digits.
*/

CHECK_THAT("the times told, and every way of the race, are the oracle's time")
{
  for(const Told& now : told_at("", "zeta=80.5", "eta=1e-300rad"))
  {
    const Fifty T = swing::oracle::ratio_from_top(swing_.eta.fifty());
    CHECK(now.value("T_over_Theta") == within_relative(T, 1e-45, "two ways of fifty digits"));
    CHECK(now.exact("ratio") == within_relative(T, 1e-45, "two ways of fifty digits"));
    CHECK(now.method("ratio", "all columns") == within_ulps(T, 5, "a logarithm, a mean and a polynomial"));
    CHECK(now.method("ratio", "one column of logarithms") == within_ulps(T, 6, "a logarithm at each term"));
    CHECK(now.method("ratio", "arithmetic-geometric mean")
          == within_ulps(T, 5, "η rounds, and its own bound"));
    CHECK(now.method("ratio", "this edition")
          == within_ulps(T, 1, "η rounds by less, and the library's bound"));
  }
}

bool enough_columns(int J, const Fifty& eta)
{
  const Fifty x = pow(sin(eta / 2), 2);
  return exact::ln2() * pow(x, J) / cos(eta / 2)
         <= Fifty("1e-16") * swing::oracle::K_from_complement(sqrt(x));
}

bool enough_terms(int n, const Fifty& zeta)
{
  const Fifty cc = pow(sin(zeta / 2), 2), half = 0.5;
  const Fifty next = 2 * (lgamma(n + half) - lgamma(half) - lgamma(Fifty(n + 1))) + n * log(cc);
  return exp(next) <= Fifty("1e-16") * (1 - cc) * swing::oracle::ratio_from_bottom(zeta);
}

CHECK_THAT(
    "the columns and terms told are enough, and one fewer is not; what they leave out is below the bound")
{
  const Fifty degree = exact::pi() / 180;
  for(const Told& now : told_at("", "zeta=80.5", "eta=1e-300rad"))
  {
    const int fewest = columns_needed(swing_.eta);
    CHECK(enough_columns(fewest, swing_.eta.fifty()));
    CHECK_FALSE(enough_columns(fewest - 1, swing_.eta.fifty()));
    CHECK(now.value("columns") == fewest);
    CHECK(now.value("columns_1") == 4);
    CHECK(now.value("columns_90") == 53);
    CHECK(now.value("terms_1") == 405810);
    CHECK(now.value("terms_90") == 47);
  }
  for(const auto& [J, eta] : {std::pair{4, degree}, std::pair{53, 90 * degree}})
  {
    CHECK(enough_columns(J, eta));
    CHECK_FALSE(enough_columns(J - 1, eta));
  }
  for(const auto& [n, zeta] : {std::pair{405810, 179 * degree}, std::pair{47, 90 * degree}})
  {
    CHECK(enough_terms(n, zeta));
    CHECK_FALSE(enough_terms(n - 1, zeta));
  }
  const Fifty K = swing::oracle::K_from_complement(sin(45 * degree));
  CHECK(K - sum_by_columns(45 * degree, 53)
        == between(0, 1e-16 * static_cast<double>(K), "the bound itself"));
}

CHECK_THAT("the figure counts columns from 50° on and terms to 130°; wider swings take fewer columns, "
           "narrower ones terms")
{
  for(const Told& now : told_at(""))
  {
    double columns_before = infinity, terms_before = 0;
    for(const auto& point : now.points("needed"))
    {
      if(const double columns = point.at("columns"); !std::isnan(columns))
        CHECK(std::exchange(columns_before, columns) >= columns);  // the wider, the fewer
      if(const double terms = point.at("terms"); !std::isnan(terms))
        CHECK(std::exchange(terms_before, terms) <= terms);  // the narrower, the fewer
    }
    for(const auto& point : now.points("needed", 9))
    {
      const Fifty zeta = Fifty(point.at("zeta")) * exact::pi() / 180;
      if(const double columns = point.at("columns"); !std::isnan(columns))
      {
        CHECK(enough_columns(static_cast<int>(columns), exact::pi() - zeta));
        CHECK_FALSE(enough_columns(static_cast<int>(columns) - 1, exact::pi() - zeta));
      }
      if(const double terms = point.at("terms"); !std::isnan(terms))
      {
        CHECK(enough_terms(static_cast<int>(terms), zeta));
        CHECK_FALSE(enough_terms(static_cast<int>(terms) - 1, zeta));
      }
    }
  }
}

/*!
## Go on from here

::: exercise
Every further column leaves $\sin^2\alpha$ of what the one before has left. Foretell from this how many
columns are needed at a tenth of a degree from the top, and at a hundredth.

answer: The angles are a tenth and a hundredth of 1°, so that a column brings two or four digits more than the
four that it brings there, nearly. For sixteen digits it takes 3 columns, and 2; `--eta 0.1` and `--eta 0.01`
tell so.
:::
*/

CHECK_THAT(
    "a tenth of a degree from the top takes 3 columns, a hundredth 2, and each brings 4, 6 or 8 digits")
{
  for(const Told& now : told_at("eta=0.1", "eta=0.01"))
    CHECK(now.value("columns") == (swing_.eta > 0.05_deg ? 3 : 2));
  const auto digits = [](double eta) { return -2 * std::log10(std::sin(eta / 2)); };
  CHECK(digits(1_deg) == within(4.12, 0.005, "of sin²α"));
  CHECK(digits(0.1_deg) == within(6.12, 0.005, "of sin²α"));
  CHECK(digits(0.01_deg) == within(8.12, 0.005, "of sin²α"));
}
