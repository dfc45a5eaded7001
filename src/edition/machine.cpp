// How a section reads to machines: JSON, and tab-separated data for the figures.

#include <cmath>
#include <filesystem>
#include <fstream>

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
                      {"printed", e.printed.text},
                      {"right", e.right.text},
                      {"because", e.because}});
  return list;
}

ordered_json columns_of(const Table& t)
{
  auto list = ordered_json::array();
  for(const Column& c : t.columns)
    list.push_back(
        {{"name", c.name}, {"heading", c.heading}, {"unit", c.unit.symbol}, {"digits", c.digits}});
  return list;
}

ordered_json methods_of(const ToldRace& r)
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
    }
    list.push_back(std::move(method));
  }
  return list;
}

/// Writes `text` to `path` by way of a file beside it, so that nobody ever sees half of it.
void write_whole(const std::filesystem::path& path, const std::string& text)
{
  const std::filesystem::path part = path.string() + ".part";
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
      const auto* x = std::get_if<double>(&row[i]);
      const auto* n = std::get_if<long long>(&row[i]);
      out += x ? show(*x, 17) : n ? fmt::format("{}", *n) : std::get<std::string>(row[i]);
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
    j["parameters"].push_back({{"name", p.name},
                               {"kind", type_name(p.type)},
                               {"unit", p.unit.symbol},
                               {"default", number(p.default_shown)},
                               {"value", number(p.shown)},
                               {"range", allowed(p)},
                               {"meaning", p.meaning}});
  for(const ToldValue& v : s.values)
  {
    ordered_json value{
        {"name", v.name}, {"value", any_number(v.number)}, {"unit", v.unit.symbol}, {"meaning", v.meaning}};
    if(!v.digits.empty())
      value["text"] = v.digits;
    j["values"].push_back(std::move(value));
  }
  for(const auto& t : s.tables)
  {
    auto rows = ordered_json::array();
    for(const auto& row : t->rows)
    {
      rows.push_back(ordered_json::array());
      for(const Cell& cell : row)
        rows.back().push_back(any_number(cell));
    }
    j["tables"].push_back(
        {{"name", t->name}, {"caption", t->caption}, {"columns", columns_of(*t)}, {"rows", rows}});
  }
  for(const ToldCurve& c : s.curves)
    j["curves"].push_back({{"name", c.name}, {"columns", c.columns}});
  for(const ToldRace& r : s.races)
    j["races"].push_back(
        {{"name", r.name}, {"quantity", r.quantity}, {"exact", r.exact}, {"methods", methods_of(r)}});
  j["errata"] = entries(s, Kind::erratum);
  j["emendations"] = entries(s, Kind::emendation);
  j["doubtful"] = entries(s, Kind::doubtful);
  j["undecided"] = entries(s, Kind::undecided);
  return j.dump(2) + '\n';
}

std::string write_data(const Section& s, const std::string& folder)
{
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if(failed)
    throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder, failed.message()));
  std::string written;
  const auto write = [&](const std::string& name, const std::vector<std::string>& columns,
                         const std::string& lines) {
    const auto path = std::filesystem::path(folder) / fmt::format("{}.{}.tsv", s.program(), name);
    write_whole(path, fmt::format("{}\n{}", fmt::join(columns, "\t"), lines));
    written += path.string() + '\n';
  };
  for(const auto& t : s.tables)
  {
    std::vector<std::string> names;
    for(const Column& c : t->columns)
      names.push_back(c.name);
    write(t->name, names, tsv(*t));
  }
  for(const ToldCurve& c : s.curves)
    write(c.name, c.columns, c.lines);
  return written;
}

}  // namespace edition
