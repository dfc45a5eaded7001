// The elementary functions against fifty digits, where they are hard and where they are not.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "edition/compare.hpp"
#include "elementary/circular.hpp"
#include "elementary/nearest.hpp"

namespace
{

using exact::Fifty, exact::ulps;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double tiniest = 5e-324;
constexpr double greatest = std::numeric_limits<double>::max();

/// Enough bits for any double less whole turns.
using Long = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<1400, boost::multiprecision::digit_base_2>>;

/// x less whole turns, to fifty digits: the oracle's own reduction is made for moderate numbers.
Fifty within_a_turn(double x)
{
  if(std::abs(x) < 1e6)
    return x;
  static const Long turn = 2 * boost::math::constants::pi<Long>();
  const Long n = round(Long(x) / turn);
  return Fifty((Long(x) - n * turn).str(60, std::ios_base::scientific));
}

/// Numbers from 0 to 1 that are the same everywhere.
class Dice
{
public:
  double unit() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }
  double of_any_size(int lo, int hi)
  {
    return std::ldexp(1 + unit(), static_cast<int>(std::floor(lo + (hi - lo) * unit())))
           * (unit() < 0.5 ? -1 : 1);
  }

private:
  std::mt19937_64 engine_{5};
};

/// Angles of every size, near whole quarter turns and eighths, and the hardest of all doubles.
std::vector<double> angles()
{
  std::vector<double> all{0x1p-27,
                          0x1p-30,
                          tiniest,
                          1e-300,
                          greatest,
                          0x1p20,
                          std::nextafter(0x1p20, 1e9),
                          6381956970095103 * 0x1p797,
                          1e22,
                          1e300,
                          1e15,
                          1048575.5};
  Dice dice;
  for(int i = 0; i < 4000; ++i)
    all.push_back(dice.of_any_size(-40, 20));
  for(int i = 0; i < 1500; ++i)
    all.push_back(dice.of_any_size(20, 1023));
  for(int i = 0; i < 4000; ++i)
    all.push_back(2 * dice.unit() - 1);
  for(int n = 1; n < 4000; ++n)
  {
    const double near = n * (boost::math::constants::pi<double>() / 4);
    all.insert(all.end(), {near, std::nextafter(near, 0), -std::nextafter(near, inf)});
  }
  return all;
}

struct Worst
{
  double sin = 0, cos = 0, tan = 0, swift = 0;
};

}  // namespace

TEST_CASE("sine, cosine and tangent of any angle are right to eight tenths and nine tenths of a unit")
{
  Worst worst;
  for(const double x : angles())
  {
    const Fifty r = within_a_turn(x);
    worst.sin = std::max(worst.sin, ulps(elementary::sin(x), sin(r)));
    worst.cos = std::max(worst.cos, ulps(elementary::cos(x), cos(r)));
    worst.tan = std::max(worst.tan, ulps(elementary::tan(x), sin(r) / cos(r)));
    const auto [s, c] = elementary::sincos(x);
    CHECK(s == elementary::sin(x));
    CHECK(c == elementary::cos(x));
    CHECK(elementary::sin(-x) == -s);
    CHECK(elementary::cos(-x) == c);
  }
  MESSAGE("sin ", worst.sin, ", cos ", worst.cos, ", tan ", worst.tan, " ulp");
  CHECK(worst.sin <= 0.8);
  CHECK(worst.cos <= 0.8);
  CHECK(worst.tan <= 0.9);
}

TEST_CASE("the arcs are right to seven tenths of a unit")
{
  double of_atan = 0, of_asin = 0, of_acos = 0, of_atan2 = 0;
  Dice dice;
  std::vector<double> all{tiniest, 1e-300, 0x1p-27, 0.41421356237309503, 2.414213562373095, 1,
                          1e16,    0x1p60, greatest};
  for(int i = 0; i < 6000; ++i)
    all.push_back(dice.of_any_size(-30, 3));
  for(const double x : all)
  {
    of_atan = std::max(of_atan, ulps(elementary::atan(x), atan(Fifty(x))));
    const double y = dice.of_any_size(-12, 12) * x;
    of_atan2 = std::max(of_atan2, ulps(elementary::atan2(y, x), atan2(Fifty(y), Fifty(x))));
    CHECK(elementary::atan(-x) == -elementary::atan(x));
  }
  for(int i = 0; i < 6000; ++i)
    for(const double x :
        {2 * dice.unit() - 1, 1 - std::ldexp(1 + dice.unit(), -2 - i % 50), dice.of_any_size(-70, 0)})
    {
      of_asin = std::max(of_asin, ulps(elementary::asin(x), asin(Fifty(x))));
      of_acos = std::max(of_acos, ulps(elementary::acos(x), acos(Fifty(x))));
    }
  for(const double size : {1e-320, 1e-308, 1e-160, 1e160, 1e308})
    for(const double along : {size, -size})
      for(const double ratio : {0.3, 0.9, 1.0, 1.5})
      {
        const double across = ratio * size;
        of_atan2 =
            std::max(of_atan2, ulps(elementary::atan2(across, along), atan2(Fifty(across), Fifty(along))));
      }
  MESSAGE("atan ", of_atan, ", atan2 ", of_atan2, ", asin ", of_asin, ", acos ", of_acos, " ulp");
  CHECK(of_atan <= 0.7);
  CHECK(of_atan2 <= 0.7);
  CHECK(of_asin <= 0.7);
  CHECK(of_acos <= 0.7);
}

TEST_CASE("at the ends they are what they must be")
{
  CHECK(std::signbit(elementary::sin(-0.0)));
  CHECK(std::signbit(elementary::tan(-0.0)));
  CHECK(elementary::cos(0) == 1);
  for(const double bad : {not_a_number, inf, -inf})
  {
    CHECK(std::isnan(elementary::sin(bad)));
    CHECK(std::isnan(elementary::cos(bad)));
    CHECK(std::isnan(elementary::tan(bad)));
    CHECK(std::isnan(elementary::asin(bad)));
    CHECK(std::isnan(elementary::acos(bad)));
  }
  const Fifty half = exact::pi() / 2;
  CHECK(elementary::atan(inf) == static_cast<double>(half));
  CHECK(elementary::atan(-inf) == -static_cast<double>(half));
  CHECK(std::isnan(elementary::atan(not_a_number)));
  CHECK(std::isnan(elementary::asin(std::nextafter(1, 2))));
  CHECK(elementary::asin(1) == static_cast<double>(half));
  CHECK(elementary::acos(-1) == static_cast<double>(2 * half));
  CHECK(elementary::acos(1) == 0);
  CHECK(elementary::atan2(1e-300, 1e300) == 0);
  CHECK(elementary::atan2(1e-300, -1e300) == static_cast<double>(2 * half));
  CHECK(elementary::atan2(1e300, -1e-300) == static_cast<double>(half));
  CHECK(elementary::atan2(3e-320, 2) == 3e-320 / 2);
  for(const double y : {0.0, -0.0, 1.0, -1.0, inf, -inf})
    for(const double x : {0.0, -0.0, 2.0, -2.0, inf, -inf})
    {
      const double got = elementary::atan2(y, x), other = std::atan2(y, x);
      CHECK(std::abs(got - other) <= 4.5e-16);  // the C library's may err by one unit, 4.4e-16 near π
      CHECK(std::signbit(got) == std::signbit(other));
    }
}

TEST_CASE(
    "the pair for equations of motion errs by 1.3·2⁻⁵³ at most, has the same bits in vectors, and ends "
    "at its reach")
{
  using Two = double __attribute__((vector_size(16)));
  Dice dice;
  double worst = 0;
  for(int i = 0; i < 4000; ++i)
  {
    const double x = i < 2000 ? 8 * dice.unit() - 4 : 2048 * dice.unit() - 1024;
    const auto [s, c] = elementary::circular::swift_sincos(x);
    worst = std::max({worst, std::abs(static_cast<double>(sin(Fifty(x)) - s)),
                      std::abs(static_cast<double>(cos(Fifty(x)) - c))});
    for(const double other : {-x, 0.5, 3.0, 2e6, not_a_number})
    {
      const auto [sines, cosines] = elementary::circular::swift_sincos(Two{x, other});
      const auto [sine, cosine] = elementary::circular::swift_sincos(other);
      CHECK(sines[0] == s);
      CHECK(cosines[0] == c);
      CHECK((sines[1] == sine || (std::isnan(sines[1]) && std::isnan(sine) && !(other <= 0x1p20))));
      CHECK((cosines[1] == cosine || (std::isnan(cosines[1]) && std::isnan(cosine) && !(other <= 0x1p20))));
    }
  }
  MESSAGE("worst ", worst * 0x1p53, " · 2⁻⁵³");
  CHECK(worst <= 1.3 * 0x1p-53);
}

TEST_CASE(
    "the functions rounded to nearest err by half a unit in the last place, and exact results are exact")
{
  namespace nearest = elementary::nearest;
  struct Tried
  {
    const char* name;
    double (*function)(double);
    Fifty (*exactly)(const Fifty&);
    double lo, hi;
  };
#define NEAREST(name, exactly, lo, hi)                                                                     \
  Tried                                                                                                    \
  {                                                                                                        \
#name, &nearest::name, [](const Fifty& x) -> Fifty { return exactly; }, lo, hi                         \
  }
  const Tried all[] = {NEAREST(sin, sin(x), -9, 9),
                       NEAREST(cos, cos(x), -9, 9),
                       NEAREST(tan, tan(x), -9, 9),
                       NEAREST(asin, asin(x), -1, 1),
                       NEAREST(acos, acos(x), -1, 1),
                       NEAREST(atan, atan(x), -4, 4),
                       NEAREST(exp, exp(x), -700, 700),
                       NEAREST(exp, exp(x), -1, 1),
                       NEAREST(exp2, exp(x * log(Fifty(2))), -1000, 1000),
                       NEAREST(expm1, expm1(x), -3, 3),
                       NEAREST(expm1, expm1(x), -40, 700),
                       NEAREST(log, log(x), 0.5, 2),
                       NEAREST(log, log(x), 0, 1e9),
                       NEAREST(log2, log(x) / log(Fifty(2)), 0, 9),
                       NEAREST(log10, log(x) / log(Fifty(10)), 0, 99),
                       NEAREST(log1p, log1p(x), -1, 3),
                       NEAREST(cbrt, cbrt(x), -9, 9),
                       NEAREST(sinh, sinh(x), -3, 3),
                       NEAREST(sinh, sinh(x), -700, 700),
                       NEAREST(cosh, cosh(x), -3, 3),
                       NEAREST(cosh, cosh(x), -700, 700),
                       NEAREST(tanh, tanh(x), -3, 3),
                       NEAREST(tanh, tanh(x), -30, 30),
                       NEAREST(asinh, asinh(x), -3, 3),
                       NEAREST(asinh, asinh(x), -1e9, 1e9),
                       NEAREST(acosh, acosh(x), 1, 3),
                       NEAREST(acosh, acosh(x), 1, 1e9),
                       NEAREST(atanh, atanh(x), -1, 1)};
#undef NEAREST
  Dice dice;
  double worst = 0;
  for(const Tried& f : all)
  {
    CAPTURE(f.name);
    double here = 0;
    for(int i = 0; i < 1000; ++i)
    {
      double x = f.lo + (f.hi - f.lo) * dice.unit();
      if(i % 4 == 0 && f.lo < 0)
        x = std::ldexp(x, -i / 20);
      here = std::max(here, ulps(f.function(x), f.exactly(x)));
    }
    CHECK(here <= 0.5 + 0x1p-20);
    worst = std::max(worst, here);
  }
  for(int i = 0; i < 2000; ++i)
  {
    const double x = std::abs(dice.of_any_size(-9, 9)),
                 y = i % 2 == 0 ? dice.of_any_size(-3, 6) : i % 90 - 45;
    CAPTURE(x);
    CAPTURE(y);
    worst = std::max(worst, ulps(nearest::pow(x, y), pow(Fifty(x), Fifty(y))));
    worst = std::max(worst, ulps(nearest::atan2(x, y), atan2(Fifty(x), Fifty(y))));
    worst = std::max(worst, ulps(nearest::hypot(x, y), sqrt(Fifty(x) * x + Fifty(y) * y)));
    CHECK(worst <= 0.5 + 0x1p-20);
  }
  MESSAGE("worst ", worst, " ulp");
  CHECK(nearest::pow(134217729, 2)
        == 18014398777917440);  // 18014398777917441, between two doubles, to the even one
  CHECK(nearest::pow(3, 33) == 5559060566555523);
  CHECK(nearest::pow(-2, -1074) == tiniest);
  CHECK(nearest::pow(0.25, -1.5) == 8);
  CHECK(nearest::exp2(-1074) == tiniest);
  CHECK(nearest::exp2(10) == 1024);
  CHECK(nearest::log2(tiniest) == -1074);
  CHECK(nearest::log10(1e22) == 22);
  CHECK(nearest::cbrt(-27) == -3);
  CHECK(nearest::hypot(3 * tiniest, 4 * tiniest) == 5 * tiniest);
  CHECK(nearest::hypot(3e307, 4e307) == 5e307);
  CHECK(ulps(nearest::exp(-740), exp(Fifty(-740))) <= 0.5);  // eight digits are left
}

TEST_CASE("the functions rounded to nearest have C's values at the ends")
{
  namespace nearest = elementary::nearest;
  const auto same = [](double a, double b) {
    return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
  };
  for(const double x : {0.0, -0.0, 1.0, -1.0, inf, -inf, not_a_number, 800.0, -800.0, 1.5, -1.5})
  {
    CAPTURE(x);
    // what is not at an end is looked at above
    for(const auto& [ours, theirs] : std::initializer_list<std::pair<double, double>>{
            {nearest::exp(x), std::exp(x)},     {nearest::exp2(x * 2), std::exp2(x * 2)},
            {nearest::log(x), std::log(x)},     {nearest::log2(x), std::log2(x)},
            {nearest::log10(x), std::log10(x)}, {nearest::log1p(x), std::log1p(x)},
            {nearest::expm1(x), std::expm1(x)}, {nearest::sinh(x), std::sinh(x)},
            {nearest::cosh(x), std::cosh(x)},   {nearest::tanh(x), std::tanh(x)},
            {nearest::asinh(x), std::asinh(x)}, {nearest::acosh(x), std::acosh(x)},
            {nearest::atanh(x), std::atanh(x)}, {nearest::cbrt(x), std::cbrt(x)},
            {nearest::sin(x), std::sin(x)},     {nearest::cos(x), std::cos(x)},
            {nearest::tan(x), std::tan(x)},     {nearest::asin(x), std::asin(x)},
            {nearest::acos(x), std::acos(x)},   {nearest::atan(x), std::atan(x)}})
      CHECK((same(ours, theirs) || std::abs(ours - theirs) <= 4.5e-16 * std::abs(theirs)));
    for(const double y :
        {0.0, -0.0, 1.0, -1.0, 2.0, 3.0, -3.0, 0.5, -0.5, inf, -inf, not_a_number, 1e300, -1e300})
    {
      CAPTURE(y);
      const double power = nearest::pow(x, y), angle = nearest::atan2(x, y);
      CHECK((same(power, std::pow(x, y)) || std::abs(power - std::pow(x, y)) <= 4.5e-16 * std::abs(power)));
      CHECK((same(angle, std::atan2(x, y))
             || std::abs(angle - std::atan2(x, y)) <= 4.5e-16 * std::abs(angle)));
      CHECK((same(nearest::hypot(x, y), std::hypot(x, y))
             || std::abs(nearest::hypot(x, y) - std::hypot(x, y)) <= 4.5e-16 * std::hypot(x, y)
             || std::isnan(nearest::hypot(x, y))));
    }
  }
}
