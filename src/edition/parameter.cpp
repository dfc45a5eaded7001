// Parameters: what the reader may change, and how what he wrote is read.

#include "edition/parameter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "edition/registry.hpp"

namespace edition
{
namespace
{

using Type = ParameterEntry::Type;

constexpr std::array reserved{"json", "check", "bench", "data", "help", "version"};

/// The number that a person would have written for a double: 0.1 is a tenth.
Fifty as_written(double x)
{
  return std::isinf(x) ? Fifty(x) : Fifty(fmt::format("{}", x));
}

/// What in `unit` is in the program's unit.
Fifty from_unit(const Fifty& x, const Unit& unit)
{
  return unit.of_angle ? x * exact::pi() / unit.factor : x / Fifty(unit.factor);
}

Fifty to_unit(const Fifty& x, const Unit& unit)
{
  return unit.of_angle ? x * unit.factor / exact::pi() : x * Fifty(unit.factor);
}

/// The number in `unit` that a person would have written for a double of the program's unit.
Fifty tidy(double x, const Unit& unit)
{
  if(std::isinf(x))
    return Fifty(x);
  const double nearest = static_cast<double>(to_unit(unit.of_angle ? Fifty(x) : as_written(x), unit));
  const Fifty short_one(fmt::format("{:.15g}", nearest));
  return static_cast<double>(from_unit(short_one, unit)) == x ? short_one : as_written(nearest);
}

void set_exact(ParameterEntry& p, const Fifty& in_its_unit)
{
  p.exact = from_unit(in_its_unit, p.unit);
  p.value = static_cast<double>(p.exact);
  p.shown = static_cast<double>(in_its_unit);
}

/// Gives what keeps to other parameters' values, and was not given itself, its default at these values.
void keep_to_others(ParameterEntry& p)
{
  if(!p.given.empty() || !p.usual.most)
    return;
  const Fifty most = p.usual.most();
  if(!(most < p.exact_default))
    return;
  p.exact = most;
  p.value = static_cast<double>(most);
  p.shown = static_cast<double>(to_unit(most, p.unit));
}

std::size_t declare(Type type, const char* name, const Default& default_value, Unit unit, Range range,
                    const char* meaning, Source source)
{
  Section& s = section();
  const auto fault = [&](const std::string& what) {
    s.faults.push_back(fmt::format("{}:{}: the parameter \"{}\" {}", source.file, source.line, name, what));
  };
  ParameterEntry p{};
  p.name = name;
  p.type = type;
  p.unit = unit;
  p.range = range;
  p.meaning = meaning;
  p.exact_lo = from_unit(tidy(range.lo, unit), unit);
  p.exact_hi = from_unit(tidy(range.hi, unit), unit);
  p.logarithmic = type != Type::integer && range.lo >= 0 && range.hi >= 1e6 * std::max(range.lo, 1e-6);
  p.usual = default_value;
  const Fifty written = tidy(default_value.usual, unit);
  p.exact_default = from_unit(written, unit);
  p.default_shown = static_cast<double>(written);
  set_exact(p, written);
  if(!is_name(name))
    fault("must be a letter, then letters, digits and _");
  if(std::any_of(reserved.begin(), reserved.end(), [=](const char* r) { return !std::strcmp(r, name); }))
    fault("has the name of an option that every program has");
  for(const ParameterEntry& other : s.parameters)
    if(other.name == name)
      fault("is declared twice");
  if(!(range.lo <= range.hi))
    fault("has a range that ends before it begins");
  else if(!std::isfinite(default_value.usual) || p.exact < p.exact_lo || p.exact > p.exact_hi
          || (range.lo_open && p.exact == p.exact_lo) || (range.hi_open && p.exact == p.exact_hi))
    fault("has a default out of its range");
  else if(p.usual.most && p.usual.most() < p.exact_default)
    fault("has a default above what it is at most");
  s.parameters.push_back(std::move(p));
  return s.parameters.size() - 1;
}

[[noreturn]] void refuse(const ParameterEntry& p, const std::string& given, const char* fault)
{
  throw BadInput(
      fmt::format("--{}: \"{}\" {}; allowed: {}", p.name, on_one_line(given), fault, allowed(p)));
}

/// Whether `text` is a decimal number: sign, digits with at most one point, exponent.
bool is_decimal(std::string_view text)
{
  const auto digits = [&text] {
    std::size_t n = 0;
    while(n < text.size() && text[n] >= '0' && text[n] <= '9')
      ++n;
    text.remove_prefix(n);
    return n;
  };
  const auto sign = [&text] {
    if(!text.empty() && (text.front() == '+' || text.front() == '-'))
      text.remove_prefix(1);
  };
  sign();
  std::size_t mantissa = digits();
  if(!text.empty() && text.front() == '.')
  {
    text.remove_prefix(1);
    mantissa += digits();
  }
  if(mantissa == 0)
    return false;
  if(text.empty())
    return true;
  if(text.front() != 'e' && text.front() != 'E')
    return false;
  text.remove_prefix(1);
  sign();
  return digits() > 0 && text.empty();
}

/// Whether the exponent is beyond all doubles, so far that the number need not be formed: 1 above, -1 below.
int far_out(const std::string& decimal)
{
  const auto e = decimal.find_first_of("eE");
  const std::string mantissa = decimal.substr(0, e);
  if(mantissa.find_first_of("123456789") == std::string::npos || e == std::string::npos)
    return 0;
  std::string exponent = decimal.substr(e + 1);
  const bool negative = exponent.front() == '-';
  exponent.erase(0, std::min(exponent.find_first_of("123456789"), exponent.size()));
  return exponent.size() <= 4 ? 0 : negative ? -1 : 1;
}

/// Whether a decimal number that is not far out is whole, whatever digits it has: behind the point, where the exponent
/// has moved it, are only noughts.
bool is_whole(const std::string& decimal)
{
  const auto e = std::min(decimal.find_first_of("eE"), decimal.size());
  const std::string mantissa = decimal.substr(0, e);
  const auto last = mantissa.find_last_of("123456789");
  if(last == std::string::npos)
    return true;
  const auto point = static_cast<long>(std::min(mantissa.find('.'), mantissa.size()));
  const long exponent = e < decimal.size() ? std::stol(decimal.substr(e + 1)) : 0;
  const auto place = static_cast<long>(last);
  return (place < point ? place + 1 : place) <= point + exponent;
}

/// Why a text is no number, as helpfully as can be told.
const char* why_no_number(const std::string& text)
{
  if(text.find("inf") != std::string::npos || text.find("nan") != std::string::npos)
    return "is not a finite number";
  if(text.find("\u2212") != std::string::npos || text.find("\u2013") != std::string::npos)
    return "is not a number (its minus is a typographic one; write -)";
  std::string point = text;
  const auto comma = point.find(',');
  if(comma != std::string::npos && is_decimal(point.replace(comma, 1, ".")))
    return "is not a number (write a point for the comma)";
  return "is not a number";
}

ParameterEntry* find(Section& s, const std::string& name)
{
  for(ParameterEntry& p : s.parameters)
    if(p.name == name)
      return &p;
  return nullptr;
}

}  // namespace

bool Unit::operator==(const Unit& other) const
{
  return !std::strcmp(symbol, other.symbol) && factor == other.factor && of_angle == other.of_angle;
}

double in_unit(double x, const Unit& unit)
{
  return unit.of_angle ? static_cast<double>(to_unit(Fifty(x), unit)) : x * unit.factor;
}

namespace
{

const ParameterEntry& read(std::size_t index)
{
  ParameterEntry& p = section().parameters[index];
  p.read = true;
  return p;
}

}  // namespace

template <>
Parameter<double>::operator double() const
{
  return read(index_).value;
}

template <>
Fifty Parameter<double>::fifty() const
{
  return read(index_).exact;
}

template <>
Parameter<int>::operator int() const
{
  return static_cast<int>(read(index_).value);
}

Default at_most(double usual, const char* in_words, Rule<Fifty()> most)
{
  return {usual, in_words, std::move(most)};
}

Parameter<double> real(const char* name, const Default& default_value, Unit unit, Range range,
                       const char* meaning, Source source)
{
  return Parameter<double>(declare(Type::real, name, default_value, unit, range, meaning, source));
}

Parameter<int> integer(const char* name, int default_value, int lo, int hi, const char* meaning,
                       Source source)
{
  return Parameter<int>(declare(Type::integer, name, static_cast<double>(default_value), none,
                                closed(lo, hi), meaning, source));
}

Parameter<double> angle(const char* name, const Default& default_value, Range range, const char* meaning,
                        Source source)
{
  return Parameter<double>(declare(Type::angle, name, default_value, degrees, range, meaning, source));
}

namespace
{

/// Makes the second of two angles 180° less the first, in value and default.
void mirror(ParameterEntry& from, ParameterEntry& to)
{
  const Fifty rest = exact::pi() - from.exact_default;
  to.exact_default = to.exact = rest;
  to.value = static_cast<double>(rest);
  to.default_shown = to.shown = static_cast<double>(to_unit(rest, degrees));
}

AmplitudeParameter both(double zeta, double eta, Range range, Source source)
{
  const double half_turn = std::numbers::pi;
  const Range from_top{half_turn - range.hi, half_turn - range.lo, range.hi_open, range.lo_open};
  const Parameter<double> z =
      angle("zeta", zeta, range, "amplitude, from the lowest point to the turning point", source);
  const Parameter<double> e =
      angle("eta", eta, from_top, "the same from the top: eta = 180° − zeta", source);
  auto& p = section().parameters;
  p.back().logarithmic = true;
  p.back().exact_lo = exact::pi() - p[p.size() - 2].exact_hi;
  p.back().exact_hi = exact::pi() - p[p.size() - 2].exact_lo;
  return {z, e};
}

}  // namespace

AmplitudeParameter amplitude(double default_zeta, Range range, Source source)
{
  const AmplitudeParameter pair = both(default_zeta, std::numbers::pi - default_zeta, range, source);
  auto& p = section().parameters;
  mirror(p[p.size() - 2], p.back());
  return pair;
}

AmplitudeParameter amplitude_from_top(double default_eta, Range range, Source source)
{
  const AmplitudeParameter pair = both(std::numbers::pi - default_eta, default_eta, range, source);
  auto& p = section().parameters;
  mirror(p.back(), p[p.size() - 2]);
  return pair;
}

void reconcile_amplitude(Section& s)
{
  ParameterEntry* const zeta = find(s, "zeta");
  ParameterEntry* const eta = find(s, "eta");
  if(!zeta || !eta)
    return;
  const auto follow = [](const ParameterEntry& given, ParameterEntry& other) {
    other.exact = exact::pi() - given.exact;
    other.value = static_cast<double>(other.exact);
    other.shown = static_cast<double>(to_unit(other.exact, degrees));
  };
  if(!zeta->given.empty() && !eta->given.empty())
  {
    if(abs(zeta->exact + eta->exact - exact::pi()) > Fifty(1e-13))
      throw BadInput(
          fmt::format("--eta: \"{}\" contradicts --zeta \"{}\"; allowed: one of them, or eta = 180° - zeta",
                      on_one_line(eta->given), on_one_line(zeta->given)));
  }
  else if(!zeta->given.empty())
    follow(*zeta, *eta);
  else if(!eta->given.empty())
    follow(*eta, *zeta);
}

std::string allowed(const ParameterEntry& p)
{
  const auto end = [&](double x) {
    return with_unit(show(static_cast<double>(tidy(x, p.unit)), 12), p.unit);
  };
  const Range& r = p.range;
  if(p.type == Type::integer)
    return fmt::format("a whole number from {:.0f} to {:.0f}", r.lo, r.hi);
  if(std::isinf(r.lo) && std::isinf(r.hi))
    return "any finite number";
  if(std::isinf(r.hi))
    return fmt::format("{} {} {}", p.name, r.lo_open ? ">" : "≥", end(r.lo));
  return fmt::format("{} {} {} {} {}", end(r.lo), r.lo_open ? "<" : "≤", p.name, r.hi_open ? "<" : "≤",
                     end(r.hi));
}

void reset_parameter(ParameterEntry& p)
{
  p.exact = p.exact_default;
  p.value = static_cast<double>(p.exact);
  p.shown = p.default_shown;
  p.given.clear();
}

void set_parameter(ParameterEntry& p, const std::string& text)
{
  std::string digits = text;
  bool in_radians = false;
  const auto drop = [&digits](std::string_view suffix) {
    const bool there = digits.size() > suffix.size() && digits.ends_with(suffix);
    if(there)
      digits.resize(digits.size() - suffix.size());
    return there;
  };
  if(p.type == Type::angle && !(in_radians = drop("rad")))
    drop("°") || drop("deg");
  if(!is_decimal(digits))
    refuse(p, text, why_no_number(digits));
  if(digits.size() > 1000)
    refuse(p, text, "has more than a thousand characters");
  if(const int out = far_out(digits))
    refuse(p, text, out > 0 ? "is not a finite number for a double" : "is too small for a double");
  const Fifty number(digits.front() == '+' ? digits.substr(1) : digits);
  if(p.type == Type::integer && !is_whole(digits))
    refuse(p, text, "is not a whole number");
  const Fifty in_its_unit = in_radians ? to_unit(number, p.unit) : number;
  ParameterEntry read = p;
  set_exact(read, in_its_unit);
  if(in_radians)
    read.value = static_cast<double>(read.exact = number);
  if(!std::isfinite(read.value))
    refuse(p, text, "is not a finite number for a double");
  if(number != Fifty(0) && read.value == 0)
    refuse(p, text, "is too small for a double");
  const auto& r = p.range;
  const Fifty& x = read.exact;
  // A double given in full may miss a written end by its rounding: what rounds to the end is the end.
  const bool low = r.lo_open ? x <= p.exact_lo : x < p.exact_lo && read.value < r.lo;
  const bool high = r.hi_open ? x >= p.exact_hi : x > p.exact_hi && read.value > r.hi;
  if(low || high)
    refuse(p, text, "is out of range");
  if(number == Fifty(0))  // -0 is 0
    set_exact(read, Fifty(0));
  read.given = text;
  p = std::move(read);
}

void set_parameters(Section& s, const std::vector<std::pair<std::string, std::string>>& given)
{
  choose(s);  // whose parameters a default asks that is at most something
  for(ParameterEntry& p : s.parameters)
    reset_parameter(p);
  for(const auto& [name, text] : given)
  {
    ParameterEntry* const p = find(s, name);
    if(!p)
      throw BadInput(
          fmt::format("--{}: is no parameter here; allowed: what --help lists", on_one_line(name)));
    set_parameter(*p, text);
  }
  reconcile_amplitude(s);
  for(ParameterEntry& p : s.parameters)
    keep_to_others(p);
}

void require(bool possible, const char* parameter, const char* allowed_in_words, Source source)
{
  const ParameterEntry* const p = find(section(), parameter);
  if(!p)
    throw std::logic_error(fmt::format("require() names \"{}\", which is no parameter", parameter));
  meet_limit(source, possible, static_cast<std::size_t>(p - section().parameters.data()));
  if(possible)
    return;
  throw BadInput(fmt::format("--{}: {} is not possible here; allowed: {}", p->name,
                             p->given.empty() ? with_unit(show(p->shown, 12), p->unit)
                                              : '"' + on_one_line(p->given) + '"',
                             allowed_in_words));
}

}  // namespace edition
