// What a section says, as it says it.

#include "edition/tell.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "edition/registry.hpp"
#include "elementary/names.hpp"
#include "race/race.hpp"

namespace edition
{
namespace
{

[[noreturn]] void fault(const std::string& what)
{
  throw std::logic_error(fmt::format("chapters/{}: {}", section().file(), what));
}

void must_be_a_name(const char* what, const std::string& name)
{
  if(!is_name(name))
    fault(
        fmt::format("the {} \"{}\" must be a letter, then letters, digits and _", what, on_one_line(name)));
}

/// Values, parameters, tables and curves are all called by their names alone.
void must_be_new(const std::string& name)
{
  const Said& said = section().said;
  const auto named = [&name](const auto& x) { return x.name == name; };
  const bool taken =
      std::any_of(section().parameters.begin(), section().parameters.end(), named)
      || std::any_of(said.values.begin(), said.values.end(), named)
      || std::any_of(said.tables.begin(), said.tables.end(), [&](const auto& t) { return named(*t); })
      || std::any_of(said.curves.begin(), said.curves.end(), named);
  if(taken)
    fault(fmt::format("two things are named \"{}\"", name));
}

void must_be_columns(const std::string& of, const std::vector<std::string>& names)
{
  for(auto name = names.begin(); name != names.end(); ++name)
  {
    must_be_a_name("column", *name);
    if(std::find(names.begin(), name, *name) != name)
      fault(fmt::format("two columns of \"{}\" are named \"{}\"", of, *name));
  }
}

void must_be_a_line(const std::string& what, const std::string& text)
{
  if(std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < ' '; }))
    fault(fmt::format("{} has a line break or a tab", what));
}

void told(ToldValue value)
{
  must_be_a_name("value", value.name);
  must_be_new(value.name);
  must_be_a_line(fmt::format("the meaning of \"{}\"", value.name), value.meaning);
  section().said.values.push_back(std::move(value));
}

using Sizes = std::array<std::size_t, 6>;

Sizes sizes(const Said& said)
{
  return {said.values.size(), said.tables.size(), said.curves.size(),
          said.scenes.size(), said.races.size(),  said.illustrations.size()};
}

/// Adds to each list what `more` has beyond the first few.
void add(Said& said, const Said& more, const Sizes& few)
{
  std::size_t i = 0;
  const auto list = [&](auto& to, const auto& from) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(few[i++]), from.end());
  };
  list(said.values, more.values);
  list(said.tables, more.tables);
  list(said.curves, more.curves);
  list(said.scenes, more.scenes);
  list(said.races, more.races);
  list(said.illustrations, more.illustrations);
}

bool would_tell_again(const Block& block, const Section& s)
{
  if(!block.with || s.wanted.timing)
    return false;
  const std::size_t scenes = block.told.scenes.size(), figures = block.told.curves.size() - scenes;
  const bool drawn = (block.with->figures || !s.wanted.figures || figures == 0)
                     && (block.with->scenes || !s.wanted.scenes || scenes == 0);
  return drawn && std::all_of(block.read.begin(), block.read.end(), [&](const Block::Read& was) {
           const ParameterEntry& p = s.parameters[was.index];
           return p.exact == was.exact && std::signbit(p.value) == std::signbit(was.value);
         });
}

void tell(Block& block, Section& s)
{
  block.with.reset();
  block.read.clear();
  for(ParameterEntry& p : s.parameters)
    p.read = false;
  const Sizes before = sizes(s.said);
  block.body();
  for(std::size_t i = 0; i < s.parameters.size(); ++i)
    if(const ParameterEntry& p = s.parameters[i]; p.read)
      block.read.push_back({i, p.exact, p.value});
  block.told = {};
  add(block.told, s.said, before);
  if(!s.wanted.timing)
    block.with = s.wanted;
}

}  // namespace

void tell(const char* name, double value, Unit unit, const char* meaning, int digits)
{
  told({name, value, Fifty(value), "", unit, meaning, digits});
}

void tell(const char* name, int value, const char* meaning)
{
  tell(name, static_cast<long long>(value), meaning);
}

void tell(const char* name, long long value, const char* meaning)
{
  told({name, value, Fifty(value), "", none, meaning, 20});
}

void tell(const char* name, const std::string& value, const char* meaning)
{
  must_be_a_line(fmt::format("the text \"{}\"", name), value);
  told({name, value, Fifty(), "", none, meaning, 0});
}

void tell(const char* name, const char* value, const char* meaning)
{
  tell(name, std::string(value), meaning);
}

void tell(const char* name, const Fifty& value, const char* meaning, int digits)
{
  told({name, static_cast<double>(value), value, value.str(digits), none, meaning, digits});
}

void tell(const char* name, const Rational& value, const char* meaning)
{
  told({name, static_cast<double>(value), static_cast<Fifty>(value), value.str(), none, meaning, 17});
}

Table::Table(std::string its_name, std::string its_caption, std::vector<Column> its_columns)
    : name(std::move(its_name)), caption(std::move(its_caption)), columns(std::move(its_columns))
{
}

void Table::row(std::initializer_list<Cell> cells)
{
  row(std::vector<Cell>(cells));
}

void Table::row(std::vector<Cell> cells)
{
  if(cells.size() != columns.size())
    fault(fmt::format("table {}: {} cells for {} columns", name, cells.size(), columns.size()));
  for(const Cell& cell : cells)
    if(const auto* words = std::get_if<std::string>(&cell))
      must_be_a_line(fmt::format("table {}: a cell", name), *words);
  rows.push_back(std::move(cells));
}

Table& table(const char* name, const char* caption, std::vector<Column> columns)
{
  must_be_a_name("table", name);
  must_be_new(name);
  std::vector<std::string> names;
  for(const Column& c : columns)
    names.push_back(c.name);
  must_be_columns(name, names);
  section().said.tables.push_back(std::make_shared<Table>(name, caption, std::move(columns)));
  return *section().said.tables.back();
}

Cell in_unit(const Cell& cell, const Column& column)
{
  if(const auto* x = std::get_if<double>(&cell))
    return in_unit(*x, column.unit);
  return cell;
}

Curve::Curve(std::vector<std::string> columns) : columns_(std::move(columns)) {}

void Curve::put(std::initializer_list<double> numbers)
{
  put(std::vector<double>(numbers));
}

void Curve::put(const std::vector<double>& numbers)
{
  if(numbers.size() != columns_.size())
    fault(fmt::format("a curve of {} columns got a point of {}", columns_.size(), numbers.size()));
  for(std::size_t i = 0; i < numbers.size(); ++i)
    text_ += (i == 0 ? "" : "\t") + show(numbers[i], 17);
  text_ += '\n';
  points_.push_back(numbers);
}

void Curve::gap()
{
  text_ += '\n';
}

void Curve::block()
{
  text_ += fmt::format("\n\n{}\n", fmt::join(columns_, "\t"));
}

void curve(const char* name, std::vector<std::string> columns, const Rule<void(Curve&)>& draw)
{
  add_curve(name, std::move(columns), draw, section().wanted.figures);
}

void add_curve(const char* name, std::vector<std::string> columns, const Rule<void(Curve&)>& draw,
               bool wanted)
{
  must_be_a_name("curve", name);
  must_be_new(name);
  must_be_columns(name, columns);
  Curve under_way(columns);
  if(wanted)
    draw(under_way);
  section().said.curves.push_back({name, std::move(columns), under_way.text(), under_way.points()});
}

void race(const char* name, const char* quantity, const Fifty& exact, const std::vector<Method>& methods)
{
  must_be_a_name("race", name);
  if(methods.empty() || !isfinite(exact) || exact == Fifty(0))
    fault(fmt::format(
        "the race \"{}\" needs ways, and a number to be judged by that is neither 0 nor infinite", name));
  ToldRace told_race{name, quantity, exact, {}};
  std::vector<::race::Entrant> entrants;
  constexpr std::size_t evaluations = 64;  // enough that the clock is not what is measured
  for(const Method& m : methods)
  {
    const double value = m.evaluate();
    const double relative = static_cast<double>(abs((Fifty(value) - exact) / exact));
    told_race.methods.push_back(
        {m.name, m.family, value, exact::ulps(value, exact), relative, NAN, NAN, NAN});
    entrants.push_back(::race::of_function(m.name, m.evaluate, evaluations));
  }
  if(section().wanted.timing)
  {
    const elementary::Plain_names plain;
    const auto timings = ::race::run(entrants);
    for(std::size_t i = 0; i < timings.size(); ++i)
    {
      told_race.methods[i].seconds = timings[i].seconds;
      told_race.methods[i].ratio = timings[i].ratio;
      told_race.methods[i].spread = timings[i].spread;
    }
  }
  section().said.races.push_back(std::move(told_race));
}

void illustration(const char* name, const char* reason)
{
  section().said.illustrations.emplace_back(name, reason);
}

void tell_anew(Section& s, Wanted wanted)
{
  choose(s);
  s.said = Said{};
  s.said.has_data = wanted.figures && wanted.scenes;
  s.wanted = wanted;
  for(Block& block : s.telling)
    if(would_tell_again(block, s))
      add(s.said, block.told, {});
    else
      tell(block, s);
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

template class std::vector<edition::Column>;
template class std::vector<edition::Method>;
