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
  if(!isfinite(y))
    return {y, y, y.str(30), "exactly", because};
  return {y - radius, y + radius, y.str(30), std::move(tolerance), because};
}

}  // namespace

Expectation::Expectation(const Fifty& lowest, const Fifty& highest, std::string expected,
                         std::string tolerance, std::string because)
    : lowest_(lowest), highest_(highest), expected_(std::move(expected)), tolerance_(std::move(tolerance)),
      because_(std::move(because))
{
}

Expectation::Expectation(const Expectation&) = default;
Expectation::Expectation(Expectation&&) noexcept = default;
Expectation::~Expectation() = default;

bool Expectation::holds(const Fifty& got, int digits) const
{
  const Fifty width = highest_ - lowest_;
  const bool measurable = isfinite(width) && width > 0 && isfinite(got);
  const double used = measurable ? static_cast<double>(abs(2 * got - highest_ - lowest_) / width) : -1.0;
  remember({got.str(digits), expected_, tolerance_, because_, used});
  return lowest_ <= got && got <= highest_;
}

std::string Expectation::text() const
{
  return fmt::format("{} ({}: {})", expected_, tolerance_, because_);
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
  return {lo, hi, fmt::format("{} … {}", lo.str(17), hi.str(17)), "a range", because};
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
  const Fifty y(digits.c_str());
  return {y - half_unit, y + half_unit, number, "to the digits printed", "half a unit of the last place"};
}

Expectation infinite(const char* because)
{
  const Fifty beyond(std::numeric_limits<double>::infinity());
  Expectation e{beyond, beyond, "inf", "exactly", because};
  e.infinite_ = true;
  return e;
}

doctest::String toString(const Expectation& e)
{
  return e.text().c_str();
}

void remember(Claim claim)
{
  last_claim = std::move(claim);
}

Claim take_last_claim()
{
  return std::exchange(last_claim, Claim{});
}

}  // namespace edition
