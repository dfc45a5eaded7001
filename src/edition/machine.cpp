// How a section reads to machines: JSON, and tab-separated data for the figures.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "edition/registry.hpp"

namespace edition
{
namespace
{

using nlohmann::ordered_json;

/// JSON has no infinities: a number that is not finite becomes a word.
ordered_json number(double x)
{
  if(std::isnan(x))
    return "nan";
  if(std::isinf(x))
    return x > 0 ? "inf" : "-inf";
  return x;
}

ordered_json any_number(const Cell& cell)
{
  if(const auto* x = std::get_if<double>(&cell))
    return number(*x);
  if(const auto* i = std::get_if<long long>(&cell))
    return *i;
  return std::get<std::string>(cell);
}

const char* type_name(ParameterEntry::Type type)
{
  return type == ParameterEntry::Type::angle  ? "angle"
         : type == ParameterEntry::Type::real ? "real"
                                              : "integer";
}

ordered_json entries(const Section& s, Kind kind)
{
  auto list = ordered_json::array();
  for(const Entry& e : s.apparatus)
    if(e.kind == kind)
      list.push_back({{"kind", name_of(e.kind)},
                      {"where", e.where},
                      {"copy", e.copy.text},
                      {"right", e.right.text},
                      {"because", e.because},
                      {"shown", e.shown == Shown::at_its_place}});
  return list;
}

/// Whether the number is one that no double can be near to.
bool beyond_doubles(const ToldValue& v)
{
  const auto* x = std::get_if<double>(&v.number);
  return x && isfinite(v.exact) && (std::isinf(*x) || (*x == 0 && v.exact != Fifty(0)));
}

/// Puts the reason why no claim looks at `key`, where one is declared.
void excuse(ordered_json& j, const Said& said, const std::string& key)
{
  for(const auto& [name, reason] : said.illustrations)
    if(key == name || key.starts_with(name + '.') || key.starts_with(name + '/'))
      j["illustration"] = reason;
}

ordered_json columns_of(const Said& said, const Table& t)
{
  auto list = ordered_json::array();
  for(const Column& c : t.columns)
  {
    list.push_back(
        {{"name", c.name}, {"heading", c.heading}, {"unit", c.unit.symbol}, {"digits", c.digits}});
    excuse(list.back(), said, t.name + '.' + c.name);
  }
  return list;
}

ordered_json any_coordinate(const Moving& coordinate)
{
  if(const auto* x = std::get_if<double>(&coordinate))
    return *x;
  return std::get<std::string>(coordinate);
}

ordered_json bodies_of(const ToldScene& s)
{
  auto list = ordered_json::array();
  for(const Body& b : s.bodies)
  {
    ordered_json body{{"kind", b.kind}, {"at", ordered_json::array()}, {"colour", b.colour}};
    for(const Spot& spot : b.at)
      body["at"].push_back({any_coordinate(spot.x), any_coordinate(spot.y)});
    if(b.radius > 0)
      body["radius"] = b.radius;
    if(b.kind == "wheel")
      body["turn"] = any_coordinate(b.turn);
    list.push_back(std::move(body));
  }
  return list;
}

ordered_json methods_of(const Said& said, const ToldRace& r)
{
  auto list = ordered_json::array();
  for(const ToldMethod& m : r.methods)
  {
    ordered_json method{{"name", m.name},
                        {"value", number(m.value)},
                        {"ulps", number(m.ulps)},
                        {"relative", number(m.relative)}};
    if(!m.family.empty())
      method["family"] = m.family;
    if(!std::isnan(m.seconds))
    {
      method["seconds"] = m.seconds;
      method["ratio"] = m.ratio;
      method["spread"] = m.spread;
    }
    excuse(method, said, r.name + '/' + m.name);
    list.push_back(std::move(method));
  }
  return list;
}

/// Writes `text` to `path` by way of a file beside it that is this process's own, so that nobody ever sees half
/// of it, and several may write the same at once.
void write_whole(const std::filesystem::path& path, const std::string& text)
{
  const std::filesystem::path part = fmt::format("{}.{}.part", path.string(), getpid());
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  std::error_code failed;
  if(out)
    std::filesystem::rename(part, path, failed);
  if(!out || failed)
  {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw std::runtime_error(fmt::format("cannot write {}", path.string()));
  }
}

std::string tsv(const Table& t)
{
  std::string out;
  for(const auto& row : t.rows)
    for(std::size_t i = 0; i < row.size(); ++i)
    {
      const Cell cell = in_unit(row[i], t.columns[i]);
      const auto* x = std::get_if<double>(&cell);
      const auto* n = std::get_if<long long>(&cell);
      out += x ? show(*x, 17) : n ? fmt::format("{}", *n) : std::get<std::string>(cell);
      out += i + 1 == row.size() ? '\n' : '\t';
    }
  return out;
}

}  // namespace

std::string as_json(const Section& s)
{
  ordered_json j{{"chapter", s.chapter}, {"section", s.number}, {"id", s.id()}, {"title", s.title}};
  for(const char* list : {"parameters", "values", "tables", "curves", "races"})
    j[list] = ordered_json::array();
  for(const ParameterEntry& p : s.parameters)
  {
    j["parameters"].push_back({{"name", p.name},
                               {"kind", type_name(p.type)},
                               {"unit", p.unit.symbol},
                               {"default", number(p.default_shown)},
                               {"value", number(p.shown)},
                               {"range", allowed(p)},
                               {"lo", number(in_unit(p.range.lo, p.unit))},
                               {"hi", number(in_unit(p.range.hi, p.unit))},
                               {"lo_open", p.range.lo_open},
                               {"hi_open", p.range.hi_open},
                               {"log", p.logarithmic},
                               {"meaning", p.meaning}});
    if(p.usual.most)
      j["parameters"].back()["default_at_most"] = p.usual.most_in_words;
  }
  for(const ToldValue& v : s.said.values)
  {
    const auto* x = std::get_if<double>(&v.number);
    ordered_json value{{"name", v.name},
                       {"value", beyond_doubles(v) ? ordered_json(v.text)
                                 : x               ? number(in_unit(*x, v.unit))
                                                   : any_number(v.number)},
                       {"unit", v.unit.symbol},
                       {"meaning", v.meaning}};
    if(x)
      value["digits"] = v.digits;
    if(!v.text.empty())
      value["text"] = v.text;
    excuse(value, s.said, v.name);
    j["values"].push_back(std::move(value));
  }
  for(const auto& t : s.said.tables)
  {
    auto rows = ordered_json::array();
    for(const auto& row : t->rows)
    {
      rows.push_back(ordered_json::array());
      for(std::size_t i = 0; i < row.size(); ++i)
        rows.back().push_back(any_number(in_unit(row[i], t->columns[i])));
    }
    j["tables"].push_back(
        {{"name", t->name}, {"caption", t->caption}, {"columns", columns_of(s.said, *t)}, {"rows", rows}});
  }
  for(const ToldCurve& c : s.said.curves)
  {
    j["curves"].push_back({{"name", c.name}, {"columns", c.columns}});
    excuse(j["curves"].back(), s.said, c.name);
  }
  j["scenes"] = ordered_json::array();
  for(const ToldScene& scene : s.said.scenes)
    j["scenes"].push_back({{"name", scene.name}, {"bodies", bodies_of(scene)}});
  for(const ToldRace& r : s.said.races)
    j["races"].push_back({{"name", r.name},
                          {"quantity", r.quantity},
                          {"exact", r.exact.str(30)},
                          {"methods", methods_of(s.said, r)}});
  j["errata"] = entries(s, Kind::erratum);
  j["emendations"] = entries(s, Kind::emendation);
  j["doubtful"] = entries(s, Kind::doubtful);
  j["undecided"] = entries(s, Kind::undecided);
  return j.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

std::vector<std::pair<std::string, std::string>> data_files(const Section& s)
{
  std::vector<std::pair<std::string, std::string>> files;
  const auto file = [&](const std::string& name, const std::vector<std::string>& columns,
                        const std::string& lines) {
    files.emplace_back(fmt::format("{}.{}.tsv", s.program(), name),
                       fmt::format("{}\n{}", fmt::join(columns, "\t"), lines));
  };
  for(const auto& t : s.said.tables)
  {
    std::vector<std::string> names;
    for(const Column& c : t->columns)
      names.push_back(c.name);
    file(t->name, names, tsv(*t));
  }
  for(const ToldCurve& c : s.said.curves)
  {
    const bool frames = std::any_of(s.said.scenes.begin(), s.said.scenes.end(),
                                    [&](const ToldScene& scene) { return scene.name == c.name; });
    if(frames ? s.wanted.scenes : s.wanted.figures)
      file(c.name, c.columns, c.lines);
  }
  return files;
}

std::string write_data(const Section& s, const std::string& folder)
{
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if(failed)
    throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder, failed.message()));
  std::string written;
  for(const auto& [name, content] : data_files(s))
  {
    const auto path = std::filesystem::path(folder) / name;
    write_whole(path, content);
    written += path.string() + '\n';
  }
  return written;
}

}  // namespace edition
