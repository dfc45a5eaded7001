// What was told, as the checks see it.

#include "edition/told.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "edition/registry.hpp"

namespace edition
{
namespace
{

[[noreturn]] void unknown(const std::string& what)
{
  throw std::logic_error(fmt::format("{} is not told", what));
}

void must_be(const Unit& claimed, const Unit& told, const std::string& key)
{
  if(!(claimed == told))
    throw std::logic_error(
        fmt::format("{} is told in \"{}\", and claimed in \"{}\"", key, told.symbol, claimed.symbol));
}

void look_at(const std::string& key, bool infinite = false)
{
  Looked& looked = ledger().coverage[key];
  looked.cases.insert(ledger().current_case);
  ++looked.settings[ledger().setting];
  looked.infinite = looked.infinite || infinite;
}

ToldNumber from_cell(const std::string& key, const Cell& cell)
{
  if(const auto* x = std::get_if<double>(&cell))
    return {key, Fifty(*x), show(*x, 17), 17};
  if(const auto* i = std::get_if<long long>(&cell))
    return {key, Fifty(*i), fmt::format("{}", *i), 20};
  return {key, Fifty(), std::get<std::string>(cell), 0};
}

template <class Things>
const auto& named(const Things& things, const char* name, const char* kind)
{
  const auto found =
      std::find_if(things.begin(), things.end(), [=](const auto& x) { return x.name == name; });
  if(found == things.end())
    unknown(fmt::format("the {} \"{}\"", kind, name));
  return *found;
}

/// The pairs of a setting such as "zeta=150 b=2".
std::vector<std::pair<std::string, std::string>> pairs_of(const std::string& setting)
{
  std::vector<std::pair<std::string, std::string>> pairs;
  std::istringstream words(setting);
  for(std::string word; words >> word;)
  {
    const auto equals = word.find('=');
    if(equals == std::string::npos)
      throw std::logic_error(fmt::format("the setting \"{}\" has no = in \"{}\"", setting, word));
    pairs.emplace_back(word.substr(0, equals), word.substr(equals + 1));
  }
  return pairs;
}

}  // namespace

ToldNumber::ToldNumber(std::string key, const Fifty& exact, std::string text, int digits)
    : key_(std::move(key)), exact_(exact), text_(std::move(text)), digits_(digits)
{
}

ToldNumber::ToldNumber(const ToldNumber&) = default;
ToldNumber::ToldNumber(ToldNumber&&) noexcept = default;
ToldNumber::~ToldNumber() = default;

bool ToldNumber::is(const Expectation& e) const
{
  look_at(key_, e.is_infinite());
  if(digits_ == 0)
    throw std::logic_error(fmt::format("{} is a text, not a number", key_));
  return e.holds(exact_, std::max(digits_, 17));
}

bool ToldNumber::is(const Rational& q) const
{
  look_at(key_);
  remember({text_, q.str(), "exactly", "", -1});
  return text_ == q.str();
}

bool ToldNumber::is_text(std::string_view words) const
{
  look_at(key_);
  remember({text_, std::string(words), "exactly", "", -1});
  return text_ == words;
}

doctest::String toString(const ToldNumber& told)
{
  return told.text().c_str();
}

ToldRow::ToldRow(std::string name, const std::vector<Column>& columns, const std::vector<Cell>& cells)
    : name_(std::move(name)), columns_(columns), cells_(cells)
{
}

ToldRow::ToldRow(const ToldRow&) = default;
ToldRow::ToldRow(ToldRow&&) noexcept = default;
ToldRow& ToldRow::operator=(const ToldRow&) = default;
ToldRow& ToldRow::operator=(ToldRow&&) noexcept = default;
ToldRow::~ToldRow() = default;

std::size_t ToldRow::index_of(const char* column) const
{
  return static_cast<std::size_t>(&named(columns_, column, ("column of " + name_).c_str())
                                  - columns_.data());
}

const Cell& ToldRow::cell(const char* column, Unit unit) const
{
  const std::size_t i = index_of(column);
  must_be(unit, columns_[i].unit, name_ + '.' + column);
  return cells_[i];
}

ToldNumber ToldRow::value(const char* column, Unit unit) const
{
  return from_cell(name_ + '.' + column, cell(column, unit));
}

double ToldRow::at(const char* column, Unit unit) const
{
  const Cell& it = cell(column, unit);
  look_at(name_ + '.' + column);
  if(const auto* x = std::get_if<double>(&it))
    return *x;
  if(const auto* i = std::get_if<long long>(&it))
    return static_cast<double>(*i);
  throw std::logic_error(fmt::format("{}.{} has words", name_, column));
}

const std::string& ToldRow::words(const char* column) const
{
  const std::size_t i = index_of(column);
  look_at(name_ + '.' + column);
  if(const auto* text = std::get_if<std::string>(&cells_[i]))
    return *text;
  throw std::logic_error(fmt::format("{}.{} has numbers", name_, column));
}

Told::Told(std::string setting, Said& said) : setting_(std::move(setting)), said_(&said) {}

ToldNumber Told::value(const char* name, Unit unit) const
{
  const ToldValue& v = named(said_->values, name, "value");
  must_be(unit, v.unit, name);
  if(const auto* x = std::get_if<double>(&v.number))
    return v.text.empty() ? ToldNumber{name, v.exact, show(*x, 17), 17}
                          : ToldNumber{name, v.exact, v.text, 30};
  if(const auto* i = std::get_if<long long>(&v.number))
    return {name, v.exact, fmt::format("{}", *i), 20};
  return {name, Fifty(), std::get<std::string>(v.number), 0};
}

std::vector<ToldRow> Told::rows(const char* table) const
{
  const auto found = std::find_if(said_->tables.begin(), said_->tables.end(),
                                  [=](const auto& t) { return t->name == table; });
  if(found == said_->tables.end())
    unknown(fmt::format("the table \"{}\"", table));
  std::vector<ToldRow> rows;
  for(const auto& cells : (*found)->rows)
    rows.emplace_back(table, (*found)->columns, cells);
  return rows;
}

std::vector<ToldRow> Told::points(const char* curve, std::size_t n) const
{
  if(!said_->has_data)
  {
    Section& s = section();
    Said kept = std::exchange(s.said, Said{});
    tell_anew(s, {true, true, false});
    *said_ = std::exchange(s.said, std::move(kept));
  }
  const ToldCurve& c = named(said_->curves, curve, "curve");
  std::vector<Column> columns;
  for(const std::string& name : c.columns)
    columns.push_back({name, name, none, 17});
  std::vector<ToldRow> points;
  const std::size_t last = c.points.empty() ? 0 : c.points.size() - 1;
  const std::size_t count = n == 0 || n > c.points.size() ? c.points.size() : n;
  for(std::size_t k = 0; k < count; ++k)
  {
    const std::size_t at = count < 2 ? 0 : k * last / (count - 1);
    points.emplace_back(curve, columns, std::vector<Cell>(c.points[at].begin(), c.points[at].end()));
  }
  return points;
}

ToldNumber Told::method(const char* race, const std::string& name) const
{
  const ToldMethod& m = named(named(said_->races, race, "race").methods, name.c_str(), "way");
  return {fmt::format("{}/{}", race, name), Fifty(m.value), show(m.value, 17), 17};
}

ToldNumber Told::exact(const char* race) const
{
  const ToldRace& r = named(said_->races, race, "race");
  return {fmt::format("{}/exact", race), r.exact, r.exact.str(30), 30};
}

std::vector<std::string> Told::methods(const char* race) const
{
  std::vector<std::string> names;
  for(const ToldMethod& m : named(said_->races, race, "race").methods)
    names.push_back(m.name);
  return names;
}

Settings::Settings(std::span<const std::string_view> settings) : settings_(settings.begin(), settings.end())
{
}

Settings::Iterator Settings::end()
{
  return {this, settings_.size()};
}

Settings::~Settings()
{
  section().parameters = ledger().own;
  ledger().setting.clear();
}

const Told& Settings::tell_at(std::size_t i)
{
  Section& s = section();
  const std::string& setting = settings_[i];
  if(setting.empty())
    s.parameters = ledger().own;
  else
    set_parameters(s, pairs_of(setting));
  ledger().setting = setting;
  if(!ledger().said.contains(setting))
  {
    tell_anew(s, {});
    ledger().said[setting] = std::move(s.said);
    s.said = Said{};
  }
  told_.emplace(setting, ledger().said[setting]);
  return *told_;
}

Refusal Refusal::operator!() const
{
  Refusal other = *this;
  other.claimed_ = !claimed_;
  return other;
}

Refusal::operator bool() const
{
  remember({words(), claimed_ ? "refused" : "told", "exactly", "", -1});
  return refused_ == claimed_;
}

std::string Refusal::words() const
{
  return setting_ + (refused_ ? ": refused" : ": told");
}

doctest::String toString(const Refusal& refusal)
{
  return refusal.words().c_str();
}

Refusal refused_at(const std::string& setting)
{
  try
  {
    for(const Told& now : told_at(setting))
      static_cast<void>(now);
  }
  catch(const BadInput&)
  {
    return {setting, true};
  }
  return {setting, false};
}

Ledger& ledger()
{
  static Ledger only;
  return only;
}

namespace
{

/// What is told under a name, as text, for finding out whether it changes from setting to setting.
std::map<std::string, std::string> everything(const Said& said)
{
  std::map<std::string, std::string> all;
  for(const ToldValue& v : said.values)
    all[v.name] = !v.text.empty()                                 ? v.text
                  : std::holds_alternative<std::string>(v.number) ? std::get<std::string>(v.number)
                                                                  : v.exact.str(20);
  for(const auto& t : said.tables)
    for(std::size_t i = 0; i < t->columns.size(); ++i)
    {
      std::string& cells = all[t->name + '.' + t->columns[i].name];
      bool numbers = false;
      for(const auto& row : t->rows)
      {
        cells += from_cell("", row[i]).text() + '\n';
        numbers = numbers || !std::holds_alternative<std::string>(row[i]);
      }
      if(!numbers)
        all.erase(t->name + '.' + t->columns[i].name);  // words are the table's labels
    }
  for(const ToldRace& r : said.races)
  {
    all[r.name + "/exact"] = r.exact.str(20);
    for(const ToldMethod& m : r.methods)
      all[r.name + '/' + m.name] = show(m.value, 17);
  }
  return all;
}

}  // namespace

std::vector<std::string> uncovered(Section& s)
{
  Ledger& l = ledger();
  if(!l.said.contains("") || !l.said[""].has_data)
  {
    s.parameters = l.own;
    tell_anew(s, {true, true, false});
    l.said[""] = std::move(s.said);
    s.said = Said{};
  }
  const Said& own = l.said[""];
  const auto excused = [&](const std::string& key) {
    return std::any_of(own.illustrations.begin(), own.illustrations.end(), [&](const auto& i) {
      return key == i.first || key.starts_with(i.first + '.') || key.starts_with(i.first + '/');
    });
  };
  std::vector<std::string> missing;
  if(!s.parameters.empty() && l.said.size() < 3)
    missing.push_back("the section is told at fewer than two settings besides the defaults");
  std::vector<std::map<std::string, std::string>> elsewhere;
  for(const auto& [setting, said] : l.said)
    if(!setting.empty())
      elsewhere.push_back(everything(said));
  for(const auto& [key, text] : everything(own))
  {
    if(excused(key))
      continue;
    const Looked& looked = l.coverage[key];
    const std::string& told = text;
    const bool changes = std::any_of(elsewhere.begin(), elsewhere.end(), [&, &name = key](const auto& all) {
      return all.contains(name) && all.at(name) != told;
    });
    const std::size_t here = looked.settings.contains("") ? 1 : 0;
    const std::size_t others = looked.settings.size() - here;
    if(here == 0)
      missing.push_back(fmt::format("no claim looks at {}", key));
    else if(changes && others < 2)
      missing.push_back(
          fmt::format("{} is looked at at {} settings besides the defaults, and changes with them", key,
                      others == 0 ? "no" : "one of the"));
  }
  for(const ToldCurve& c : own.curves)
    for(const std::string& column : c.columns)
    {
      const std::string key = c.name + '.' + column;
      const Looked& looked = l.coverage[key];
      const int claims = looked.settings.contains("") ? looked.settings.at("") : 0;
      if(!excused(key) && claims < std::min<int>(3, static_cast<int>(c.points.size())))
        missing.push_back(fmt::format("{} is looked at at fewer than three of its points", key));
    }
  for(const auto& [place, limit] : l.limits)
    if(!both_sides(limit))
      missing.push_back(one_sided(place, limit));
  return missing;
}

}  // namespace edition
