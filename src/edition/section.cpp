#include "edition/section.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>

#include <fmt/format.h>

#include "edition/registry.hpp"
#include "race/race.hpp"

namespace edition
{
namespace
{

std::size_t declare(ParameterEntry entry)
{
  entry.value = static_cast<double>(static_cast<long double>(entry.default_shown) / entry.unit.factor);
  entry.shown = entry.default_shown;
  section().parameters.push_back(std::move(entry));
  return section().parameters.size() - 1;
}

double in_unit(double x, const Unit& unit)
{
  return static_cast<double>(static_cast<long double>(x) * unit.factor);
}

/// The degrees nearest to an angle's radians that a person would have written.
double tidy_degrees(double rad)
{
  const long double deg = static_cast<long double>(rad) * degrees.factor;
  const double tidy = std::strtod(fmt::format("{:.15g}", static_cast<double>(deg)).c_str(), nullptr);
  const bool same = static_cast<double>(static_cast<long double>(tidy) / degrees.factor) == rad;
  return same ? tidy : static_cast<double>(deg);
}

[[noreturn]] void refuse(const ParameterEntry& p, const std::string& given, const char* fault)
{
  throw BadInput(fmt::format("--{}: \"{}\" {}; allowed: {}", p.name, given, fault, allowed(p)));
}

/// Two tables or curves of one name would write one file.
void refuse_second(const std::string& name)
{
  for(const auto& t : section().tables)
    if(t->name == name)
      throw std::logic_error("two tables or curves are named " + name);
  for(const ToldCurve& c : section().curves)
    if(c.name == name)
      throw std::logic_error("two tables or curves are named " + name);
}

void told(ToldValue value)
{
  for(const ToldValue& other : section().values)
    if(other.name == value.name)
      throw std::logic_error("two values are named " + value.name);
  section().values.push_back(std::move(value));
}

}  // namespace

std::string Section::id() const
{
  return fmt::format("{}.{:02}", chapter, number);
}

std::string Section::program() const
{
  return fmt::format("{}-{:02}", chapter, number);
}

Section& section()
{
  static Section only;
  return only;
}

Identity::Identity(const char* chapter, int number, const char* title)
{
  section().chapter = chapter;
  section().number = number;
  section().title = title;
}

Telling::Telling(void (*body)())
{
  section().telling.push_back(body);
}

template <>
Parameter<double>::operator double() const
{
  return section().parameters[index_].value;
}

template <>
Fifty Parameter<double>::fifty() const
{
  const ParameterEntry& p = section().parameters[index_];
  const bool in_degrees = p.type == ParameterEntry::Type::angle && p.shown_is_exact;
  return in_degrees ? Fifty(p.shown) * exact::pi() / 180 : Fifty(p.value);
}

template <>
Parameter<int>::operator int() const
{
  return static_cast<int>(section().parameters[index_].value);
}

Parameter<double> real(const char* name, double default_value, Unit unit, Range range, const char* meaning)
{
  return Parameter<double>(declare({name,
                                    ParameterEntry::Type::real,
                                    unit,
                                    range,
                                    in_unit(default_value, unit),
                                    meaning,
                                    0,
                                    0,
                                    true,
                                    {}}));
}

Parameter<int> integer(const char* name, int default_value, int lo, int hi, const char* meaning)
{
  return Parameter<int>(declare({name,
                                 ParameterEntry::Type::integer,
                                 none,
                                 closed(lo, hi),
                                 static_cast<double>(default_value),
                                 meaning,
                                 0,
                                 0,
                                 true,
                                 {}}));
}

Parameter<double> angle(const char* name, double default_value, Range range, const char* meaning)
{
  return Parameter<double>(declare({name,
                                    ParameterEntry::Type::angle,
                                    degrees,
                                    range,
                                    tidy_degrees(default_value),
                                    meaning,
                                    0,
                                    0,
                                    true,
                                    {}}));
}

AmplitudeParameter amplitude(double default_zeta, Range range)
{
  const double half_turn = std::numbers::pi;
  const Range from_top{half_turn - range.hi, half_turn - range.lo, range.hi_open, range.lo_open};
  section().has_amplitude = true;
  const auto zeta =
      angle("zeta", default_zeta, range, "amplitude, from the lowest point to the turning point");
  const auto eta =
      angle("eta", half_turn - default_zeta, from_top, "the same from the top: eta = 180° - zeta");
  auto& p = section().parameters;
  p.back().default_shown = 180 - p[p.size() - 2].default_shown;
  p.back().shown = p.back().default_shown;
  p.back().value = static_cast<double>(static_cast<long double>(p.back().shown) / degrees.factor);
  return {zeta, eta};
}

AmplitudeParameter amplitude_from_top(double default_eta, Range range)
{
  const AmplitudeParameter both = amplitude(std::numbers::pi - default_eta, range);
  auto& p = section().parameters;
  ParameterEntry& zeta = p[p.size() - 2];
  ParameterEntry& eta = p.back();
  eta.default_shown = eta.shown = tidy_degrees(default_eta);
  eta.value = default_eta;
  zeta.default_shown = zeta.shown = 180 - eta.shown;
  zeta.value = static_cast<double>(static_cast<long double>(zeta.shown) / degrees.factor);
  return both;
}

void reconcile_amplitude(Section& s)
{
  if(!s.has_amplitude)
    return;
  const auto named = [&s](const char* name) -> ParameterEntry& {
    return *std::find_if(s.parameters.begin(), s.parameters.end(),
                         [=](const auto& p) { return p.name == name; });
  };
  ParameterEntry& zeta = named("zeta");
  ParameterEntry& eta = named("eta");
  const auto follow = [](const ParameterEntry& given, ParameterEntry& other) {
    other.shown = 180 - given.shown;
    other.shown_is_exact = given.shown_is_exact && 180 - other.shown == given.shown;
    const long double half_turn = std::numbers::pi_v<long double>;
    other.value = static_cast<double>(half_turn - static_cast<long double>(given.shown) / degrees.factor);
  };
  if(!zeta.given.empty() && !eta.given.empty())
  {
    if(std::abs(zeta.shown + eta.shown - 180) > 1e-13 * 180)
      throw BadInput(
          fmt::format("--eta: \"{}\" contradicts --zeta \"{}\"; allowed: one of them, or eta = 180° - zeta",
                      eta.given, zeta.given));
  }
  else if(!zeta.given.empty())
    follow(zeta, eta);
  else if(!eta.given.empty())
    follow(eta, zeta);
}

std::string allowed(const ParameterEntry& p)
{
  const auto end = [&](double x) {
    return with_unit(show(p.type == ParameterEntry::Type::angle ? tidy_degrees(x) : in_unit(x, p.unit), 12),
                     p.unit);
  };
  const Range& r = p.range;
  if(p.type == ParameterEntry::Type::integer)
    return fmt::format("a whole number from {:.0f} to {:.0f}", r.lo, r.hi);
  if(std::isinf(r.lo) && std::isinf(r.hi))
    return "any finite number";
  if(std::isinf(r.hi))
    return fmt::format("{} {} {}", p.name, r.lo_open ? ">" : "≥", end(r.lo));
  return fmt::format("{} {} {} {} {}", end(r.lo), r.lo_open ? "<" : "≤", p.name, r.hi_open ? "<" : "≤",
                     end(r.hi));
}

void set_parameter(ParameterEntry& p, const std::string& text)
{
  using Type = ParameterEntry::Type;
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
  if(text.empty() || digits.find_first_not_of("0123456789+-.eE") != std::string::npos)
  {
    const bool unending = text.find("inf") != std::string::npos || text.find("nan") != std::string::npos;
    refuse(p, text, unending ? "is not a finite number" : "is not a number");
  }
  char* end = nullptr;
  errno = 0;
  const long double number = std::strtold(digits.c_str(), &end);
  const bool vanished = errno == ERANGE && number == 0;
  if(end != digits.c_str() + digits.size() || digits.empty())
    refuse(p, text, "is not a number");
  if(!std::isfinite(static_cast<double>(number)))
    refuse(p, text, "is not a finite number");
  if(p.type == Type::integer && number != std::floor(number))
    refuse(p, text, "is not a whole number");
  p.shown = static_cast<double>(in_radians ? number * degrees.factor : number);
  p.value = static_cast<double>(in_radians ? number : number / p.unit.factor);
  if(vanished || (number != 0 && p.value == 0))
    refuse(p, text, "is too small for a double");
  if(!p.range.contains(p.value))
    refuse(p, text, "is out of range");
  p.shown_is_exact = !in_radians;
  p.given = text;
}

void require(bool possible, const char* parameter, const char* allowed_in_words)
{
  if(possible)
    return;
  for(const ParameterEntry& p : section().parameters)
    if(p.name == parameter)
      throw BadInput(fmt::format(
          "--{}: {} is not possible here; allowed: {}", p.name,
          p.given.empty() ? with_unit(show(p.shown, 12), p.unit) : '"' + p.given + '"', allowed_in_words));
  throw std::logic_error(fmt::format("require() names \"{}\", which is no parameter", parameter));
}

void tell(const char* name, double value, Unit unit, const char* meaning)
{
  told({name, in_unit(value, unit), "", unit, meaning});
}

void tell(const char* name, int value, const char* meaning)
{
  tell(name, static_cast<long long>(value), meaning);
}

void tell(const char* name, long long value, const char* meaning)
{
  told({name, value, "", none, meaning});
}

void tell(const char* name, const std::string& value, const char* meaning)
{
  told({name, value, "", none, meaning});
}

void tell(const char* name, const Fifty& value, const char* meaning)
{
  told({name, static_cast<double>(value), value.str(30), none, meaning});
}

void tell(const char* name, const Rational& value, const char* meaning)
{
  told({name, static_cast<double>(value), value.str(), none, meaning});
}

Table::Table(std::string its_name, std::string its_caption, std::vector<Column> its_columns)
    : name(std::move(its_name)), caption(std::move(its_caption)), columns(std::move(its_columns))
{
}

void Table::row(std::vector<Cell> cells)
{
  if(cells.size() != columns.size())
    throw std::logic_error(
        fmt::format("table {}: {} cells for {} columns", name, cells.size(), columns.size()));
  for(std::size_t i = 0; i < cells.size(); ++i)
    if(auto* x = std::get_if<double>(&cells[i]))
      *x = in_unit(*x, columns[i].unit);
  rows.push_back(std::move(cells));
}

Table& table(const char* name, const char* caption, std::vector<Column> columns)
{
  refuse_second(name);
  section().tables.push_back(std::make_unique<Table>(name, caption, std::move(columns)));
  return *section().tables.back();
}

void Curve::put(const std::vector<double>& numbers)
{
  if(numbers.size() != columns_.size())
    throw std::logic_error(
        fmt::format("a curve of {} columns got a point of {}", columns_.size(), numbers.size()));
  for(std::size_t i = 0; i < numbers.size(); ++i)
    text_ += (i == 0 ? "" : "\t") + show(numbers[i], 17);
  text_ += '\n';
}

void Curve::block()
{
  text_ += fmt::format("\n\n{}\n", fmt::join(columns_, "\t"));
}

void curve(const char* name, std::vector<std::string> columns, const std::function<void(Curve&)>& draw)
{
  refuse_second(name);
  Curve under_way(columns);
  if(section().wanted.data)
    draw(under_way);
  section().curves.push_back({name, std::move(columns), under_way.text()});
}

void race(const char* name, const char* quantity, const Fifty& exact, const std::vector<Method>& methods)
{
  ToldRace told_race{name, quantity, exact.str(30), {}};
  std::vector<::race::Entrant> entrants;
  constexpr std::size_t evaluations = 64;  // enough that the clock is not what is measured
  for(const Method& m : methods)
  {
    const double value = m.evaluate();
    const double relative = static_cast<double>(abs((Fifty(value) - exact) / exact));
    told_race.methods.push_back({m.name, m.family, value, exact::ulps(value, exact), relative, NAN, NAN});
    entrants.push_back({m.name,
                        [&m] {
                          for(std::size_t i = 0; i < evaluations; ++i)
                            ::race::keep(m.evaluate());
                        },
                        evaluations});
  }
  if(section().wanted.timing)
  {
    const auto timings = ::race::run(entrants);
    for(std::size_t i = 0; i < timings.size(); ++i)
    {
      told_race.methods[i].seconds = timings[i].seconds;
      told_race.methods[i].ratio = timings[i].ratio;
    }
  }
  section().races.push_back(std::move(told_race));
}

void enter(Entry entry)
{
  section().apparatus.push_back(std::move(entry));
}

const char* name_of(Kind kind)
{
  constexpr std::array names{"erratum", "emendation", "doubtful", "undecided"};
  return names[static_cast<std::size_t>(kind)];
}

std::string with_unit(std::string number, const Unit& unit)
{
  const std::string symbol = unit.symbol;
  if(!symbol.empty())
    number += symbol == "°" || symbol == "′" || symbol == "″" ? symbol : " " + symbol;
  return number;
}

std::string show(double x, int digits)
{
  return std::isnan(x) ? "nan" : fmt::format("{:.{}g}", x, digits);  // a NaN's sign says nothing
}

}  // namespace edition
