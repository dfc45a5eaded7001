#include "edition/compare.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace edition
{
namespace
{

thread_local Claim last_claim;

double spacing_at(double y)
{
  const double magnitude = std::abs(y);
  return std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
}

Expectation around(const Fifty& y, const Fifty& radius, std::string tolerance, const char* because)
{
  return {y, y - radius, y + radius, std::move(tolerance), because};
}

}  // namespace

Expectation::Expectation(const Fifty& expected, const Fifty& lowest, const Fifty& highest,
                         std::string tolerance, std::string because)
    : expected_(expected), lowest_(lowest), highest_(highest), tolerance_(std::move(tolerance)),
      because_(std::move(because))
{
}

bool Expectation::holds(const Fifty& got, int digits) const
{
  last_claim = {got.str(digits), expected_.str(digits), tolerance_, because_};
  return lowest_ <= got && got <= highest_;
}

std::string Expectation::text() const
{
  return fmt::format("{} ({}: {})", expected_.str(20), tolerance_, because_);
}

Expectation within_ulps(const Fifty& y, double n, const char* because)
{
  return around(y, Fifty(n) * Fifty(spacing_at(static_cast<double>(y))), fmt::format("± {:g} ulp", n),
                because);
}

Expectation within(const Fifty& y, double eps, const char* because)
{
  return around(y, eps, fmt::format("± {:g}", eps), because);
}

Expectation within_relative(const Fifty& y, double eps, const char* because)
{
  return around(y, abs(y) * Fifty(eps), fmt::format("± {:g} of itself", eps), because);
}

Expectation between(const Fifty& lo, const Fifty& hi, const char* because)
{
  return {(lo + hi) / Fifty(2), lo, hi, fmt::format("from {} to {}", lo.str(8), hi.str(8)), because};
}

Expectation printed(const char* number)
{
  std::string digits = number;
  if(const auto comma = digits.find(','); comma != std::string::npos)
    digits[comma] = '.';
  if(digits.empty() || digits.find_first_not_of("-0123456789.") != std::string::npos)
    throw std::invalid_argument(fmt::format("printed(\"{}\"): not a decimal number", number));
  const auto point = digits.find('.');
  const int places = point == std::string::npos ? 0 : static_cast<int>(digits.size() - point - 1);
  const Fifty half_unit = Fifty(0.5) * pow(Fifty(10), Fifty(-places));
  return around(Fifty(digits.c_str()), half_unit, "to the digits printed", "half a unit of the last place");
}

doctest::String toString(const Expectation& e)
{
  return e.text().c_str();
}

Claim take_last_claim()
{
  return std::exchange(last_claim, Claim{});
}

}  // namespace edition
