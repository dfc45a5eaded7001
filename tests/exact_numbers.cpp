/// @file Fifty digits and exact fractions: against published constants, against the C library's correctly
/// rounded reading of decimals, and against each other.
#include "edition/compare.hpp"
#include "exact/inside.hpp"
#include "exact/rational.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <locale>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using namespace exact;
using edition::within_relative;

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double tiny = std::numeric_limits<double>::denorm_min();
constexpr double greatest = std::numeric_limits<double>::max();

// 168 bits are 2.7e-51 of relative spacing.
edition::Expectation to_fifty_digits(const Fifty& y)
{
  return within_relative(y, 1e-49, "a few units of digit 50");
}

Fifty power_of_two(int n)
{
  return ldexp(Fifty(1), n);
}

}  // namespace

TEST_CASE("constants agree with published digits")
{
  CHECK(pi() == to_fifty_digits(Fifty("3.14159265358979323846264338327950288419716939937510582")));
  CHECK(ln2() == to_fifty_digits(Fifty("0.693147180559945309417232121458176568075500134360255254")));
  CHECK(euler_gamma()
        == to_fifty_digits(Fifty("0.577215664901532860606512090082402431042159335939923599")));
  CHECK(exp(Fifty(1)) == to_fifty_digits(Fifty("2.71828182845904523536028747135266249775724709369995958")));
  CHECK(sqrt(Fifty(2))
        == to_fifty_digits(Fifty("1.41421356237309504880168872420969807856967187537694807")));
  CHECK(tgamma(Fifty(0.25))
        == to_fifty_digits(Fifty("3.6256099082219083119306851558676720029951676828801")));
}

TEST_CASE("functions agree with each other where they are inverse")
{
  for(const char* text : {"0.3", "0.007", "1e-9", "0.99", "1.0000001", "2.5", "17", "1e-25"})
  {
    const Fifty x(text);
    CAPTURE(text);
    CHECK(exp(log(x)) == within_relative(x, 1e-48, "log(1e-25) = -58 is the exponent, with its rounding"));
    CHECK(log1p(expm1(x)) == to_fifty_digits(x));
    CHECK(asinh(sinh(x)) == to_fifty_digits(x));
    CHECK(tan(atan(x)) == within_relative(x, 1e-48, "tan magnifies errors at 17 by 17"));
    CHECK(sinh(x) / cosh(x) == to_fifty_digits(tanh(x)));
    CHECK(sqrt(x) * sqrt(x) == to_fifty_digits(x));
    CHECK(cbrt(-x) * cbrt(-x) * cbrt(-x) == to_fifty_digits(-x));
    CHECK(pow(x, Fifty(3)) == to_fifty_digits(x * x * x));
    CHECK(pow(x, -3) == to_fifty_digits(1 / (x * x * x)));
    CHECK(hypot(3 * x, 4 * x) == to_fifty_digits(5 * x));
    CHECK(lgamma(x + 1) - lgamma(x)
          == edition::within(log(x), 1e-47, "Stirling's terms near 40 are subtracted"));
    CHECK(tgamma(x + 1) == within_relative(x * tgamma(x), 1e-46, "Lanczos's sum at 17"));
  }
  for(const char* text : {"0.3", "0.007", "1e-9", "0.99", "1e-25"})
  {
    const Fifty x(text);
    CAPTURE(text);
    CHECK(sin(asin(x)) == to_fifty_digits(x));
    CHECK(asin(x) + acos(x) == to_fifty_digits(pi() / 2));
    CHECK(tanh(atanh(x)) == within_relative(x, 1e-48, "at 0.99, 1 - x² is 0.02"));
    CHECK(acosh(1 + x) == within_relative(2 * asinh(sqrt(x / 2)), 1e-24, "1 + 1e-25 keeps half"));
  }
  CHECK(atan2(Fifty(-1), Fifty(-1)) == to_fifty_digits(-3 * pi() / 4));
}

TEST_CASE("small arguments lose nothing")
{
  for(const char* text : {"1e-3", "-1e-12", "1e-30", "-1e-200"})
  {
    const Fifty x(text);
    const Fifty x2 = x * x;
    const Fifty x3 = x2 * x;
    CAPTURE(text);
    // The next terms of the expansions: x¹⁷/17! and the like, below 1e-65, or x⁵/5, where the sum is cut
    // there.
    const auto odd = [&](int sign, bool divided) {
      Fifty sum;
      Fifty power = x;
      for(int n = 1; n < 40; n += 2)
      {
        const Fifty factor = divided ? Fifty(n) : static_cast<Fifty>(factorial(n));
        sum += power / factor;
        power *= sign * x2;
      }
      return sum;
    };
    CHECK(sin(x) == to_fifty_digits(odd(-1, false)));
    CHECK(sinh(x) == to_fifty_digits(odd(1, false)));
    CHECK(atan(x) == to_fifty_digits(odd(-1, true)));
    CHECK(atanh(x) == to_fifty_digits(odd(1, true)));
    CHECK(tanh(x) == to_fifty_digits(odd(1, false) / cosh(x)));
    CHECK(expm1(x) == to_fifty_digits(sinh(x) + 2 * sinh(x / 2) * sinh(x / 2)));
    CHECK(log1p(x) == to_fifty_digits(2 * atanh(x / (2 + x))));
    CHECK(asinh(x)
          == within_relative(x - x3 / 6 + 3 * x3 * x2 / 40 - 15 * x3 * x2 * x2 / 336, 1e-25,
                             "the term x⁹·105/3456 is left out: 3e-26 of x at 1e-3"));
  }
}

TEST_CASE("outside their domains functions answer as the standard library does")
{
  CHECK(isnan(sqrt(Fifty(-1))));
  CHECK(isnan(log(Fifty(-1))));
  CHECK(isnan(log1p(Fifty(-2))));
  CHECK(isnan(asin(Fifty("1.0000000000000000000000000000000000000000001"))));
  CHECK(isnan(acos(Fifty(-2))));
  CHECK(isnan(acosh(Fifty(0.5))));
  CHECK(isnan(atanh(Fifty(2))));
  CHECK(isnan(tgamma(Fifty(-3))));
  CHECK(static_cast<double>(log(Fifty(0))) == -infinite);
  CHECK(static_cast<double>(atanh(Fifty(-1))) == -infinite);
  CHECK(static_cast<double>(lgamma(Fifty(0))) == infinite);
  CHECK(static_cast<double>(1 / Fifty(0)) == infinite);
  CHECK(isnan(Fifty(0) / 0));
  CHECK_FALSE(isfinite(1 / Fifty(0)));
}

TEST_CASE("NaN is unordered and unequal to itself")
{
  const Fifty nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(nan == nan);
  CHECK_FALSE(nan < 1);
  CHECK_FALSE(nan >= 1);
  CHECK(Fifty(1) < Fifty("1.0000000000000000000000000000000000000000000000001"));
  CHECK(Fifty(2) > 1);
}

TEST_CASE("whole numbers come in exactly and rounding functions take them out")
{
  CHECK(Fifty(9223372036854775807LL) + 1 == Fifty("9223372036854775808"));
  CHECK(Fifty(18446744073709551615ULL) == Fifty("18446744073709551615"));
  CHECK(Fifty(-7) == Fifty("-7"));
  CHECK(floor(Fifty("-2.5")) == -3);
  CHECK(ceil(Fifty("-2.5")) == -2);
  CHECK(round(Fifty("2.5")) == 3);
  CHECK(round(Fifty("-2.5")) == -3);
  CHECK(round(Fifty(0.5) - power_of_two(-169)) == 0);
  CHECK(abs(Fifty(-3)) == 3);
}

TEST_CASE("a decimal becomes the nearest double, as strtod reads it")
{
  std::vector<std::string> texts = {"0.1",
                                    "-3.16621",
                                    "1e22",
                                    "1e23",
                                    "9007199254740993",
                                    "9007199254740995",
                                    "9007199254740993.00000000000000000000000000001",
                                    "1.7976931348623157e308",
                                    "1.7976931348623159e308",
                                    "2.2250738585072011e-308",
                                    "2.2250738585072014e-308",
                                    "4.9e-324",
                                    "2.4703282292062327e-324",
                                    "2.4703282292062329e-324",
                                    "7.4109846876186981e-324",
                                    "7.4109846876186983e-324",
                                    "1e-400",
                                    "0",
                                    "1e400"};
  std::mt19937_64 random(20);
  for(int i = 0; i < 2000; ++i)
  {
    const int exponent = static_cast<int>(random() % 330) - (i % 2 == 0 ? 324 : 20);
    const std::string whole = std::to_string(random());
    texts.push_back(whole + "." + std::to_string(random()) + "e" + std::to_string(exponent));
  }
  for(const std::string& text : texts)
  {
    CAPTURE(text);
    CHECK(static_cast<double>(Fifty(text)) == std::strtod(text.c_str(), nullptr));
  }
}

TEST_CASE("a double goes through fifty digits unchanged")
{
  for(double x : {0.0, 1.0, -0.1, tiny, 3 * tiny, 2.2250738585072014e-308, greatest, infinite})
  {
    CHECK(static_cast<double>(Fifty(x)) == x);
    CHECK(static_cast<double>(Fifty(-x)) == -x);
  }
}

TEST_CASE("text shows what is asked for")
{
  CHECK(Fifty("0.000123456").str(3) == "0.000123");
  CHECK(Fifty("0.0000123456").str(3) == "1.23e-05");
  CHECK(Fifty(1).str() == "1");
  CHECK(Fifty("1234567").str(7) == "1234567");
  CHECK(Fifty("1234567").str(3) == "1.23e+06");
  CHECK(Fifty("-2.5").str(10) == "-2.5");
  CHECK(Fifty(0).str() == "0");
  CHECK((Fifty(1) / 3).str() == "0.33333333333333333333333333333333333333333333333333");
  CHECK(Fifty("9.99999").str(3) == "10");
  CHECK((1 / Fifty(0)).str() == "inf");
  CHECK((-1 / Fifty(0)).str(5) == "-inf");
  CHECK((Fifty(0) / 0).str() == "nan");
  CHECK_THROWS_AS(Fifty(1).str(0), std::out_of_range);
  CHECK_THROWS_AS(Fifty(1).str(51), std::out_of_range);
}

// Thousands apart, as many languages write them; no locale need be installed for it.
struct Apart : std::numpunct<char>
{
  char do_thousands_sep() const override { return '.'; }
  char do_decimal_point() const override { return ','; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_CASE("text is the same in every locale")
{
  const auto texts = [] {
    return std::vector<std::string>{
        Fifty("1234567").str(),           Fifty("1234567.25").str(12),
        Fifty("-1.5e123456").str(),       (Fifty(1) / 3).str(),
        Rational(1234567, 7654321).str(), Rational("123456789123456789123456789").str(),
        Rational(1234567).numerator(),    bernoulli(30).str()};
  };
  const std::vector<std::string> plain = texts();
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Apart));
  const std::vector<std::string> national = texts();
  const Fifty read("1234567.25");
  std::locale::global(before);
  CHECK(plain == national);
  CHECK(plain.front() == "1234567");
  CHECK(read == 1234567.25);
}

// The right sides were found with 120 digits by another library, mpmath.
TEST_CASE("a sine knows its angle, far out and beside a multiple of pi")
{
  CHECK(sin(pi()) == to_fifty_digits(Fifty("4.33483368264870798111070286259770700622454578626434e-51")));
  CHECK(cos(pi() / 2)
        == to_fifty_digits(Fifty("2.16741684132435399055535143129885350311227289313217e-51")));
  CHECK(tan(pi() / 2)
        == to_fifty_digits(Fifty("461378716328960171718715682558375796501559778974180.38483405")));
  CHECK(sin(-pi()) == -sin(pi()));
  CHECK(sin(Fifty(1e22))
        == to_fifty_digits(Fifty("-0.852200849767188801772705893753029368261762150410043656")));
  CHECK(cos(Fifty("1e44"))
        == to_fifty_digits(Fifty("-0.893712793236090405131302880152865490827862902050102043")));
  CHECK(tan(Fifty("1e44"))
        == to_fifty_digits(Fifty("0.501995216447248522167111362584337990447921179431713426")));
  for(const Fifty& far : {Fifty("1e45"), Fifty("-1e55"), 1 / Fifty(0), Fifty(0) / 0})
  {
    CHECK(isnan(sin(far)));
    CHECK(isnan(cos(far)));
    CHECK(isnan(tan(far)));
  }
  for(int quarters = -5; quarters <= 5; ++quarters)
  {
    const Fifty x = quarters * pi() / 2 + Fifty(0.3);
    CHECK(sin(x) == to_fifty_digits(2 * sin(x / 2) * cos(x / 2)));
    CHECK(cos(x) == to_fifty_digits((cos(x / 2) - sin(x / 2)) * (cos(x / 2) + sin(x / 2))));
  }
}

TEST_CASE("a sine is the same whichever angles were asked before")
{
  const std::vector<Fifty> angles{Fifty("0.3"),   Fifty("-0.3"), Fifty("0.15"),
                                  Fifty("1e-30"), Fifty("7e9"),  pi()};
  std::vector<Fifty> sines, cosines;
  for(const Fifty& x : angles)
    sines.push_back(sin(x));
  for(const Fifty& x : angles)
    cosines.push_back(cos(x));
  for(std::size_t i = 0; i < angles.size(); ++i)
    for(std::size_t j = 0; j < angles.size(); ++j)
    {
      CHECK(sin(angles[i]) == sines[i]);
      CHECK(cos(angles[j]) == cosines[j]);
      CHECK(cos(angles[i]) == cosines[i]);
      CHECK(sin(angles[j]) == sines[j]);
    }
}

TEST_CASE("sine and cosine are those of three times the digits, between the places of the table and far "
          "from them")
{
  using Wide = boost::multiprecision::number<
      boost::multiprecision::cpp_bin_float<600, boost::multiprecision::digit_base_2>,
      boost::multiprecision::et_off>;
  std::vector<Fifty> angles{355,           52174, Fifty("1048575.9"), Fifty("1048576.1"), Fifty("1e-30"),
                            Fifty("-1e-9")};
  for(int n = -260; n <= 260; ++n)
  {
    angles.push_back(Fifty(n) / 64 + Fifty("1e-20"));  // where the nearest place changes
    angles.push_back(n * pi() / 2
                     + Fifty(n) * n * Fifty("1e-21"));  // beside quarters, on both sides of 2^-60
    angles.push_back(Fifty(n) * 1013 + Fifty(1) / 3);
  }
  for(const Fifty& x : angles)
  {
    const Wide wide(exact::real(x));
    CHECK(sin(x) == to_fifty_digits(exact::fifty(Wide(sin(wide)).convert_to<exact::Real>())));
    CHECK(cos(x) == to_fifty_digits(exact::fifty(Wide(cos(wide)).convert_to<exact::Real>())));
  }
}

TEST_CASE(
    "an arc tangent is that of three times the digits, in every octant and where the nearest place changes")
{
  using Wide = boost::multiprecision::number<
      boost::multiprecision::cpp_bin_float<600, boost::multiprecision::digit_base_2>,
      boost::multiprecision::et_off>;
  const auto narrow = [](const Wide& x) { return exact::fifty(x.convert_to<exact::Real>()); };
  std::vector<Fifty> tangents{Fifty("1e-300"), Fifty("1e-25"), Fifty("1e300"), 1, 1 + Fifty("1e-40")};
  for(int n = 1; n <= 120; ++n)
    tangents.push_back(narrow(tan(Wide(n) / 128)) + n % 2 * Fifty("1e-20"));
  for(const Fifty& x : tangents)
  {
    const Wide wide(exact::real(x));
    CHECK(atan(x) == to_fifty_digits(narrow(atan(wide))));
    CHECK(atan(-x) == -atan(x));
    CHECK(atan2(x, -1) == to_fifty_digits(narrow(atan2(wide, Wide(-1)))));
    CHECK(atan2(-1, -x) == to_fifty_digits(narrow(atan2(Wide(-1), Wide(-wide)))));
    const Wide sine = wide / sqrt(1 + wide * wide);
    CHECK(asin(narrow(sine)) == to_fifty_digits(narrow(asin(Wide(exact::real(narrow(sine)))))));
    CHECK(acos(-narrow(sine)) == to_fifty_digits(narrow(acos(Wide(exact::real(-narrow(sine)))))));
  }
  // On the axes and at infinity, where no quotient is taken.
  CHECK(atan(Fifty(0)) == 0);
  CHECK(atan2(Fifty(0), -1) == pi());
  CHECK(atan2(Fifty(-3), 0) == -pi() / 2);
  CHECK(atan(1 / Fifty(0)) == pi() / 2);
  CHECK(asin(Fifty(-1)) == -pi() / 2);
  CHECK(acos(Fifty(-1)) == pi());
  CHECK(isnan(atan(Fifty(0) / 0)));
}

TEST_CASE("what is not a decimal is refused")
{
  for(const char* text :
      {"", " ", "1,5", "0x10", "1.5 m", "e5", ".e5", "1.2.3", "--1", "1e", "+", "1e5e5", "1-2"})
  {
    CAPTURE(text);
    CHECK_THROWS_AS(Fifty{text}, std::invalid_argument);
  }
}

TEST_CASE("the error in ulps is measured in the binade of the exact value")
{
  CHECK(ulps(1.0, Fifty(1)) == 0);
  CHECK(ulps(std::nextafter(1.0, 2.0), Fifty(1)) == 1);
  CHECK(ulps(std::nextafter(1.0, 0.0), Fifty(1)) == 0.5);  // the doubles below 1 lie twice as dense
  CHECK(ulps(1.0, 1 - power_of_two(-54)) == 0.5);
  CHECK(ulps(0.1, Fifty("0.1")) < 0.5);
  CHECK(ulps(0.0, Fifty(0)) == 0);
  CHECK(ulps(tiny, Fifty(0)) == 1);
  CHECK(ulps(0.0, Fifty(tiny) / 4) == 0.25);
  CHECK(ulps(3 * tiny, Fifty(tiny)) == 2);
  CHECK(ulps(greatest, Fifty(greatest) + power_of_two(971)) == 1);
  CHECK(ulps(infinite, power_of_two(1024)) == 0);
  CHECK(ulps(infinite, Fifty(greatest)) == infinite);
  CHECK(ulps(infinite, Fifty(-infinite)) == infinite);
  CHECK(ulps(1.0, Fifty(infinite)) == infinite);
  CHECK(ulps(std::nan(""), Fifty(1)) == infinite);
  CHECK(ulps(1.0, Fifty(0) / 0) == infinite);
}

TEST_CASE("a formula runs in double and in fifty digits alike")
{
  const auto formula = [](auto x) {
    using std::exp, std::pow, std::sqrt;
    return sqrt(1 + x * x) + 2 * exp(-x) - pow(x, 3) / 3.0;
  };
  CHECK(ulps(formula(0.75), formula(Fifty(0.75))) <= 2);  // four roundings, each half an ulp
}

TEST_CASE("fractions are kept in lowest terms with a positive denominator")
{
  CHECK(Rational(6, -4).str() == "-3/2");
  CHECK(Rational(6, -4).numerator() == "-3");
  CHECK(Rational(6, -4).denominator() == "2");
  CHECK(Rational("10/5").str() == "2");
  CHECK(Rational("-007").str() == "-7");
  CHECK(Rational(0, -5) == 0);
  CHECK(Rational(1, 3) + Rational(1, 6) == Rational(1, 2));
  CHECK(Rational(1, 3) < Rational(1, 2));
  CHECK(-Rational(1, 3) < 0);
  CHECK(abs(Rational(-1, 3)) == Rational(1, 3));
  CHECK(pow(Rational(-2, 3), 3) == Rational(-8, 27));
  CHECK(pow(Rational(-2, 3), -3) == Rational(-27, 8));
  CHECK(pow(Rational(0), 0) == 1);
  CHECK(Rational(18446744073709551615ULL) + 1 == pow(Rational(2), 64));
  CHECK(Rational::exactly(0.1) == Rational("3602879701896397/36028797018963968"));
}

TEST_CASE("fractions refuse what is none")
{
  CHECK_THROWS_AS(Rational(1, 0), std::domain_error);
  CHECK_THROWS_AS(Rational("1/0"), std::domain_error);
  CHECK_THROWS_AS(Rational(1) / 0, std::domain_error);
  CHECK_THROWS_AS(pow(Rational(0), -1), std::domain_error);
  CHECK_THROWS_AS(Rational::exactly(std::nan("")), std::domain_error);
  for(const char* text : {"", "1.5", "1/", "/2", "0x10", "1/2/3", "--1", "1 /2"})
  {
    CAPTURE(text);
    CHECK_THROWS_AS(Rational{text}, std::invalid_argument);
  }
}

TEST_CASE("a fraction becomes the nearest double and the nearest fifty digits")
{
  CHECK(static_cast<double>(Rational(1, 3)) == 1.0 / 3.0);
  CHECK(static_cast<double>(Rational(-2, 3)) == -2.0 / 3.0);
  CHECK(static_cast<double>(Rational("9007199254740993")) == 9007199254740992.0);  // a tie, to even
  CHECK(static_cast<double>(Rational("9007199254740993000001/1000000")) == 9007199254740994.0);  // above it
  CHECK(static_cast<double>(pow(Rational(2), -1074)) == tiny);
  CHECK(static_cast<double>(pow(Rational(2), -1075)) == 0);
  CHECK(static_cast<double>(pow(Rational(2), 1024)) == infinite);
  CHECK(static_cast<double>(factorial(170))
        == within_relative(tgamma(Fifty(171)), 1.2e-16, "one rounding"));
  CHECK(static_cast<Fifty>(Rational(22, 7)) == Fifty(22) / 7);
  CHECK(static_cast<Fifty>(Rational(-1, 10)) == Fifty("-0.1"));
  std::mt19937_64 random(7);
  for(int i = 0; i < 300; ++i)
  {
    const auto n = static_cast<long long>(random() >> 12);  // 52 bits: a double holds it
    const auto d = static_cast<long long>(random() >> 12) + 1;
    CHECK(static_cast<double>(Rational(n, d)) == static_cast<double>(n) / static_cast<double>(d));
  }
  for(int n = 0; n < 300; ++n)  // with fewer, as many and more digits than are had
  {
    CAPTURE(n);
    CHECK(static_cast<double>(pow(Rational(2), n) * Rational(3, 7)) == std::ldexp(3.0 / 7.0, n));
    CHECK(static_cast<Fifty>(pow(Rational(2), n) * Rational(3, 7)) == ldexp(Fifty(3) / 7, n));
  }
}

TEST_CASE("exact numbers agree with published ones")
{
  CHECK(factorial(25) == Rational("15511210043330985984000000"));
  CHECK(double_factorial(9) == 945);
  CHECK(double_factorial(10) == 3840);
  CHECK(double_factorial(-1) == 1);
  CHECK(double_factorial_ratio(0) == 1);
  CHECK(double_factorial_ratio(4) == Rational(35, 128));
  CHECK(binomial(10, 3) == 120);
  CHECK(binomial(3, 5) == 0);
  CHECK(binomial(Rational(-1, 2), 4) == Rational(35, 128));
  CHECK(bernoulli(1) == Rational(-1, 2));
  CHECK(bernoulli(3) == 0);
  CHECK(bernoulli(12) == Rational(-691, 2730));
  CHECK(bernoulli(30) == Rational("8615841276005/14322"));
  CHECK_THROWS_AS(factorial(-1), std::domain_error);
  CHECK_THROWS_AS(double_factorial(-2), std::domain_error);
  CHECK_THROWS_AS(double_factorial_ratio(-1), std::domain_error);
  CHECK_THROWS_AS(binomial(3, -1), std::domain_error);
  CHECK_THROWS_AS(bernoulli(-1), std::domain_error);
}
