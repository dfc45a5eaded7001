#include "pendulum/logarithms.hpp"

#include <algorithm>
#include <stdexcept>

namespace pendulum
{
namespace
{

using exact::Fifty;

constexpr long long unit = 10'000'000;

Fifty power_of_ten(int n)
{
  return pow(Fifty(10), n);
}

/// A whole number of units of the last of `places` decimals, written out.
std::string written(long long units, int places)
{
  const std::string digits = std::to_string(units);
  const std::size_t wanted = static_cast<std::size_t>(places) + 1;
  const std::string padded = std::string(wanted - std::min(wanted, digits.size()), '0') + digits;
  const std::size_t comma = padded.size() - static_cast<std::size_t>(places);
  return places == 0 ? padded : padded.substr(0, comma) + ',' + padded.substr(comma);
}

long long whole(const Fifty& x)
{
  return static_cast<long long>(static_cast<double>(x));
}

Fifty in_units(const Fifty& x)
{
  if(!(x > 0))
    throw std::domain_error("only a positive number has a logarithm");
  return log(x) / log(Fifty(10)) * unit;
}

}  // namespace

SevenPlaces SevenPlaces::of(const Fifty& x)
{
  return SevenPlaces(whole(floor(in_units(x) + Fifty(0.5))));
}

SevenPlaces SevenPlaces::cut_off(const Fifty& x)
{
  return SevenPlaces(whole(floor(in_units(x))));
}

SevenPlaces SevenPlaces::as_written(const std::string& text)
{
  std::string digits = text;
  digits.erase(std::remove(digits.begin(), digits.end(), ','), digits.end());
  const long long units = std::stoll(digits);
  return SevenPlaces(units < 5 * unit ? units : units - 10 * unit);
}

Fifty SevenPlaces::number() const
{
  return pow(Fifty(10), Fifty(units_) / unit);
}

std::string SevenPlaces::text() const
{
  long long units = units_;
  while(units < 0)
    units += 10 * unit;
  return written(units, 7);
}

Fifty augmented_logarithm(const Fifty& x)
{
  Fifty logarithm = log(x) / log(Fifty(10));
  while(logarithm < 0)
    logarithm += 10;
  return logarithm;
}

std::string rounded(const Fifty& x, int places)
{
  return truncated(x + Fifty(0.5) / power_of_ten(places), places);
}

std::string truncated(const Fifty& x, int places)
{
  return written(whole(floor(x * power_of_ten(places))), places);
}

std::string verdict(const std::string& printed, const std::string& reckoned, const Fifty& truth)
{
  std::string digits = printed;
  std::replace(digits.begin(), digits.end(), ',', '.');
  const auto point = std::min(digits.find('.'), digits.size() - 1);
  const int places = static_cast<int>(digits.size() - point - 1);
  if(rounded(truth, places) == printed)
    return "right";
  if(printed == reckoned)
    return "as reckoned";
  const Fifty off = abs(Fifty(digits) - truth) * power_of_ten(places);
  return off <= 2 ? "last place" : "wrong";
}

}  // namespace pendulum
