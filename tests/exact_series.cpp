/// @file
/// Formal series and Laurent polynomials: against known expansions and against identities.
#include "edition/compare.hpp"
#include "exact/series.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace exact;
using S = Series<Rational>;
using L = Laurent<Rational>;

namespace
{

const S x = S::x(12);
S random_series(int seed, int constant)
{
  std::vector<Rational> c = {constant};
  for(int n = 1; n <= 12; ++n)
  {
    c.push_back(Rational((n * seed) % 7 - 3, (n + seed) % 5 + 1));
  }
  return S(std::move(c), 12);
}

}  // namespace

TEST_CASE("known expansions")
{
  CHECK(exp(x)[10] == 1 / factorial(10));
  CHECK(log(1 + x)[7] == Rational(1, 7));
  CHECK(sqrt(1 + x)[4] == Rational(-5, 128));
  CHECK(sin(x)[9] == 1 / factorial(9));
  CHECK(cos(x)[10] == -1 / factorial(10));
  CHECK((sin(x) / cos(x))[11] == Rational(1382, 155925));
  CHECK((1 / sqrt(1 - x))[6] == double_factorial_ratio(6));
  CHECK(reverse(sin(x))[9] == double_factorial_ratio(4) / 9);
  CHECK((x / (exp(x) - 1))[10] == bernoulli(10) / factorial(10));
}

TEST_CASE("the functions obey their identities for arbitrary series")
{
  for(int seed : {1, 2, 3})
  {
    const S a = random_series(seed, 0);
    const S b = random_series(seed + 4, 1);
    CHECK(exp(log(b)) == b);
    CHECK(sqrt(b) * sqrt(b) == b);
    CHECK(pow(pow(b, Rational(2, 3)), 3) == b * b);
    CHECK(sin(a) * sin(a) + cos(a) * cos(a) == S({1}, 12));
    CHECK(derivative(integral(a)) == a);
    CHECK(derivative(a * b) == derivative(a) * b + a * derivative(b));
    CHECK(a / b * b == a);
    CHECK(pow(b, -2) * b * b == S({1}, 12));
    CHECK(derivative(compose(b, a)) == (compose(derivative(b), a) * derivative(a)).truncated(11));
    const S c = x + x * a;
    CHECK(compose(c, reverse(c)) == x);
    CHECK(compose(reverse(c), c) == x);
  }
}

TEST_CASE("the order is that to which the terms determine the result")
{
  CHECK((S::x(5) * S::x(7)).order() == 5);
  CHECK((S::x(5) + S::x(7)).order() == 5);
  CHECK(derivative(S::x(5)).order() == 4);
  CHECK(integral(S::x(5)).order() == 6);
  CHECK((S::x(5) / S::x(5)).order() == 4);  // x cancels, and an order with it
  CHECK((S(1) + S::x()).order() == S::unlimited);
  CHECK((S::x() * S::x())[2] == 1);
  CHECK(S::x(3) * 2 == S({0, 2}, 3));
  CHECK_FALSE(S::x(3) == S::x(4));
  CHECK(S::x(3).truncated(9).order() == 3);
  CHECK_THROWS_AS(S::x(3)[4], std::out_of_range);
  CHECK_THROWS_AS(S::x(3)[-1], std::out_of_range);
}

TEST_CASE("values are the sums of the known terms")
{
  CHECK(exp(x)(Rational(1)) == Rational("260412269/95800320"));  // 1 + 1 + 1/2! + ... + 1/12!
  CHECK(exp(x)(Fifty("0.001"))
        == edition::within_relative(exp(Fifty("0.001")), 2e-49, "0.001^13/13! is 1.6e-49"));
  CHECK(S::x(3)(0.5) == 0.5);
}

TEST_CASE("what has no series is refused")
{
  CHECK_THROWS_AS(exp(1 + x), std::domain_error);
  CHECK_THROWS_AS(log(x), std::domain_error);
  CHECK_THROWS_AS(sqrt(4 + x), std::domain_error);
  CHECK_THROWS_AS(exp(S::x()), std::domain_error);
  CHECK_THROWS_AS(1 / x, std::domain_error);
  CHECK_THROWS_AS(x / S(0), std::domain_error);
  CHECK_THROWS_AS(S(1) / (1 + S::x()), std::domain_error);
  CHECK_THROWS_AS(reverse(x * x), std::domain_error);
  CHECK_THROWS_AS(compose(exp(x), 1 + x), std::domain_error);
  CHECK_THROWS_AS(derivative(S({1}, 0)), std::domain_error);
  CHECK_THROWS_AS(S({1}, -1), std::invalid_argument);
}

TEST_CASE("a series of series is one in two variables")
{
  using Two = Series<S>;
  const Two y = Two::x(4);
  const Two a(S::x(4));  // the inner variable
  // 1/(1 - x - y): the coefficient of x^i y^j is the binomial coefficient.
  const Two inverse = Two(1) / (Two(1) - a - y);
  for(int i = 0; i <= 4; ++i)
  {
    for(int j = 0; j <= 4; ++j)
    {
      CHECK(inverse[j][i] == binomial(i + j, i));
    }
  }
}

TEST_CASE("series of fifty digits sum as those of fractions do")
{
  const auto real = sin(Series<Fifty>::x(15));
  CHECK(real[13] == edition::within_relative(Fifty(1 / factorial(13)), 1e-49, "a few roundings"));
}

TEST_CASE("Laurent polynomials keep to their powers")
{
  const L c(1, 1);
  const L inverse(1, -1);
  CHECK(c * inverse == L(1));
  CHECK((c + inverse) * (c - inverse) == L(1, 2) - L(1, -2));
  CHECK(derivative(L(3, -2) + L(5, 0) + L(1, 4)) == L(-6, -3) + L(4, 3));
  CHECK(integral(L(-6, -3) + L(4, 3)) == L(3, -2) + L(1, 4));
  CHECK_THROWS_AS(integral(inverse), std::domain_error);
  CHECK((L(1, 3) - L(1, 3)) == L());
  CHECK((L(1, 3) + 0).lowest() == 3);
  CHECK((L(1, 3) + L(2, -4)).highest() == 3);
  CHECK((L(1, 3) + L(2, -4))[-4] == 2);
  CHECK((L(1, 3) + L(2, -4))[-5] == 0);
  CHECK((L(6, 2) + L(4, 1)) / L(2, 3) == L(3, -1) + L(2, -2));
  CHECK((L(1, 3) + L(2, -4))(Rational(1, 2)) == Rational(1, 8) + 32);
  CHECK((L(1, -1))(4.0) == 0.25);
  CHECK_THROWS_AS(L(1) / (L(1) + c), std::domain_error);
  CHECK_THROWS_AS(L(1) / L(0), std::domain_error);
}
