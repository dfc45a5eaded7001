/// @file The pendulum's array away from the places where its sections look: D, V, W everywhere, entries, the sums of
/// all columns, bad indices.
#include "edition/compare.hpp"
#include "exact/series.hpp"
#include "pendulum/columns.hpp"

#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

using namespace edition;
using namespace pendulum;

TEST_CASE("D, V and W keep within their bounds all over the interval, and near both of its ends")
{
  std::mt19937_64 random(1777);
  std::uniform_real_distribution<double> uniform(0, 1);
  for(int n = 0; n < 3000; ++n)
  {
    const double v = n % 3 == 0 ? std::pow(10, -18 * uniform(random)) : uniform(random);
    if(v == 0)
      continue;
    CAPTURE(v);
    CHECK(D(v) == within_ulps(D(Fifty(v)), 4, "documented"));
    CHECK(V(v) == within_ulps(V(Fifty(v)), 6, "documented"));
    CHECK(W(v) == within_ulps(W(Fifty(v)), 6, "documented"));
    const double root = std::pow(10, -12 * uniform(random));  // near v = 1, where the root is given
    const double near = std::sqrt((1 - root) * (1 + root));
    const Fifty exactly = sqrt((1 - Fifty(root)) * (1 + Fifty(root)));
    if(root < 0.5)
      CHECK(V(near, root) == within_ulps(V(exactly, Fifty(root)), 6, "documented"));
  }
}

TEST_CASE("at the ends they are what they are said to be, and what is too small vanishes")
{
  CHECK(D(0.0) == 0);
  CHECK(V(0.0) == 0.25);
  CHECK(W(0.0) == 0);
  CHECK(D(1e-200) == 0);
  CHECK(V(1e-200) == 0.25);
  CHECK(std::isinf(V(1.0)));
}

TEST_CASE("an entry outside the array is refused")
{
  CHECK_THROWS_AS(entry(0, 0), std::domain_error);
  CHECK_THROWS_AS(entry(3, 3), std::domain_error);
  CHECK_THROWS_AS(entry(3, -1), std::domain_error);
}

TEST_CASE("an entry's row, times the powers, is the scaled integral, for rows up to 30")
{
  const Fifty alpha(0.7);
  const Fifty x = pow(sin(alpha), 2);
  for(int m = 0; m <= 30; ++m)
  {
    const Fifty a = static_cast<Fifty>(exact::double_factorial_ratio(m));
    Fifty row = a * a * pow(x, m) * log_cot_half(alpha);
    for(int j = 0; j < m; ++j)
      row += static_cast<Fifty>(entry(m, j)) * pow(x, j) * cos(alpha);
    CHECK(row
          == within_relative(a * scaled_integral(m, alpha), 1e-46, "a hundred roundings of fifty digits"));
  }
}

TEST_CASE("the logarithm of the cotangent keeps its digits from the smallest angle to nearly 90 degrees")
{
  for(const double alpha : {1e-300, 1e-8, 0.1, 0.999, 1.001, 1.5, 1.5707})
    CHECK(log_cot_half(alpha)
          == within_ulps(log_cot_half(Fifty(alpha)), 3, "documented; 90° less α is exact"));
}

TEST_CASE("no columns, no rows, no terms: nothing but what is left")
{
  CHECK(column_sums<double>(0).empty());
  CHECK(exact_column_sums(0).empty());
  CHECK(sum_by_rows(0.5, 0) == 0);
  CHECK(sum_with_one_logarithm(0.5, 0) == 0);
  const Fifty first = log_cot_half(Fifty(0.5)) * series(pow(sin(Fifty(0.5)), 2), 120);
  CHECK(sum_by_columns(0.5, 0) == within_ulps(first, 3, "sin²α is 0.23, and 120 terms leave nothing"));
}

// K with one logarithm less L·P, divided by cos α and with all that is no multiple of ln 2 set apart, leaves
// (1−x)^−½ Σ a_n² xⁿ (ln 2 − r_n − ln ½(1+√(1−x))).
TEST_CASE("the recurrence of the column sums gives the coefficients of their generating function, exactly")
{
  using Formal = exact::Series<exact::Rational>;
  const int order = 39;
  std::vector<exact::Rational> squares;
  std::vector<exact::Rational> with_r;
  exact::Rational r = 0;
  for(int n = 0; n <= order; ++n)
  {
    squares.push_back(pow(exact::double_factorial_ratio(n), 2));
    with_r.push_back(squares.back() * r);
    r += exact::Rational(2, (2 * n + 1) * (2 * n + 2));
  }
  const Formal root = sqrt(1 - Formal::x(order));
  const Formal P(squares, order);
  const Formal beta = P / root;
  const Formal rho = (Formal(with_r, order) + P * log((1 + root) / 2)) / root;
  const auto S = exact_column_sums(order + 1);
  const auto rounded = column_sums<Fifty>(order + 1);
  for(int j = 0; j <= order; ++j)
  {
    const auto i = static_cast<std::size_t>(j);
    CHECK(S[i].beta == beta[j]);
    CHECK(S[i].rho == rho[j]);
    CHECK(rounded[i] == within_relative(S[i].value(), 1e-47, "forty steps, and what β ln 2 − ρ cancels"));
  }
}

TEST_CASE("in double the recurrence errs in proportion to j, and the sums follow their law")
{
  const auto S = column_sums<double>(1001);
  const auto truth = column_sums<Fifty>(1001);
  for(const std::size_t j : {2u, 10u, 100u, 1000u})
  {
    CHECK(S[j] == within_relative(truth[j], 1e-15 * static_cast<double>(j), "documented"));
    CHECK(S[j] < S[j - 1]);
  }
  const double law = std::sqrt(std::numbers::pi / 1000) / 2 - 1 / (1000 * std::numbers::pi);
  CHECK(S[1000] == within_relative(law, 2e-3, "½√(π/j) − 1/(πj), and what is a jth of the first"));
}
