// How a section reads in a terminal.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "edition/registry.hpp"

namespace edition
{
namespace
{

constexpr std::size_t line_width = 88;

/// The characters of a UTF-8 text, so that columns with Greek letters line up.
std::size_t width(const std::string& text)
{
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string pad_right(const std::string& text, std::size_t to)
{
  return text + std::string(to - std::min(to, width(text)), ' ');
}

std::string pad_left(const std::string& text, std::size_t to)
{
  return std::string(to - std::min(to, width(text)), ' ') + text;
}

std::string capitalised(std::string word)
{
  if(!word.empty() && word[0] >= 'a' && word[0] <= 'z')
    word[0] = static_cast<char>(word[0] - 'a' + 'A');
  return word;
}

/// `text` in lines of at most line_width, the first after `used` characters, the others indented by
/// `indent`.
std::string wrapped(const std::string& text, std::size_t used, std::size_t indent)
{
  std::string out;
  std::size_t column = used;
  for(std::size_t at = 0; at < text.size();)
  {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if(column + 1 + width(word) > line_width && column > indent)
    {
      out += '\n' + std::string(indent, ' ');
      column = indent;
    }
    else if(at > 0)
    {
      out += ' ';
      ++column;
    }
    out += word;
    column += width(word);
    at = end + 1;
  }
  return out + '\n';
}

/// A name, what it is, and what it means, in three columns.
struct Line
{
  std::string name;
  std::string number;
  std::string meaning;
};

std::string lines(const std::vector<Line>& all)
{
  std::size_t names = 0;
  std::size_t numbers = 0;
  for(const Line& l : all)
  {
    names = std::max(names, width(l.name));
    if(width(l.number) <= 24)
      numbers = std::max(numbers, width(l.number));
  }
  std::string out;
  for(const Line& l : all)
  {
    const std::string head = "  " + pad_right(l.name, names) + "  " + pad_right(l.number, numbers) + "  ";
    out += head + wrapped(l.meaning, width(head), names + numbers + 6);
  }
  return out;
}

std::string shown(const ToldValue& v)
{
  if(!v.text.empty())
    return v.text;
  if(const auto* x = std::get_if<double>(&v.number))
    return with_unit(show(in_unit(*x, v.unit), v.digits), v.unit);
  if(const auto* i = std::get_if<long long>(&v.number))
    return fmt::format("{}", *i);
  return std::get<std::string>(v.number);
}

std::string shown(const Cell& cell, int digits)
{
  if(const auto* x = std::get_if<double>(&cell))
    return show(*x, digits);
  if(const auto* i = std::get_if<long long>(&cell))
    return fmt::format("{}", *i);
  return std::get<std::string>(cell);
}

/// Rows of cells under headings: numbers to the right, words to the left.
std::string grid(const std::vector<std::string>& headings,
                 const std::vector<std::vector<std::string>>& cells, const std::vector<bool>& words)
{
  std::vector<std::size_t> widths;
  for(std::size_t i = 0; i < headings.size(); ++i)
  {
    widths.push_back(width(headings[i]));
    for(const auto& row : cells)
      widths[i] = std::max(widths[i], width(row[i]));
  }
  const auto line = [&](const std::vector<std::string>& row) {
    std::string out = " ";
    for(std::size_t i = 0; i < row.size(); ++i)
      out += ' ' + (words[i] ? pad_right(row[i], widths[i]) : pad_left(row[i], widths[i])) + ' ';
    return out.substr(0, out.find_last_not_of(' ') + 1) + '\n';
  };
  std::string out = line(headings);
  for(const auto& row : cells)
    out += line(row);
  return out;
}

std::string as_grid(const Table& t)
{
  std::vector<std::string> headings;
  std::vector<bool> words;
  for(std::size_t i = 0; i < t.columns.size(); ++i)
  {
    const std::string symbol = t.columns[i].unit.symbol;
    headings.push_back(t.columns[i].heading + (symbol.empty() ? "" : " [" + symbol + "]"));
    words.push_back(!t.rows.empty() && std::holds_alternative<std::string>(t.rows.front()[i]));
  }
  std::vector<std::vector<std::string>> cells;
  for(const auto& row : t.rows)
  {
    cells.emplace_back();
    for(std::size_t i = 0; i < row.size(); ++i)
      cells.back().push_back(shown(in_unit(row[i], t.columns[i]), t.columns[i].digits));
  }
  return wrapped(t.caption, 0, 0) + grid(headings, cells, words);
}

std::string with_prefix(double time)
{
  if(std::isnan(time))
    return "";
  constexpr std::array scales{std::pair{1e-9, "ns"}, std::pair{1e-6, "µs"}, std::pair{1e-3, "ms"}};
  for(const auto& [scale, symbol] : scales)
    if(time < 995 * scale)
      return fmt::format("{:.2g} {}", time / scale, symbol);
  return fmt::format("{:.2g} s", time);
}

std::string as_grid(const ToldRace& r)
{
  std::vector<std::vector<std::string>> cells;
  bool timed = false;
  for(const ToldMethod& m : r.methods)
  {
    timed = timed || !std::isnan(m.seconds);
    cells.push_back({m.name, fmt::format("{:.17g}", m.value), fmt::format("{:.2g}", m.ulps),
                     fmt::format("{:.1e}", m.relative)});
    if(timed)
    {
      cells.back().push_back(with_prefix(m.seconds));
      cells.back().push_back(fmt::format("{:.2g} ± {:.0f} %", m.ratio, 100 * m.spread));
    }
  }
  std::vector<std::string> headings{"way", "value", "error [ulp]", "relative error"};
  std::vector<bool> words{true, false, false, false};
  if(timed)
  {
    headings.insert(headings.end(), {"time", "ratio"});
    words.insert(words.end(), {false, false});
  }
  return wrapped(fmt::format("{}, to 30 digits {}", r.quantity, r.exact.str(30)), 0, 0)
         + grid(headings, cells, words);
}

}  // namespace

std::string as_text(const Section& s)
{
  std::string out = fmt::format("{} §{}. {}\n", capitalised(s.chapter), s.number, s.title);
  std::vector<Line> parameters;
  for(const ParameterEntry& p : s.parameters)
    parameters.push_back({p.name, "= " + with_unit(show(p.shown, 12), p.unit), p.meaning});
  if(!parameters.empty())
    out += '\n' + lines(parameters);
  std::vector<Line> values;
  for(const ToldValue& v : s.said.values)
    values.push_back({v.name, shown(v), v.meaning});
  if(!values.empty())
    out += '\n' + lines(values);
  for(const auto& t : s.said.tables)
    out += '\n' + as_grid(*t);
  return out;
}

std::string races_as_text(const Section& s)
{
  std::string out;
  for(const ToldRace& r : s.said.races)
    out += (out.empty() ? "" : "\n") + as_grid(r);
  return out.empty() ? "nothing here has more than one way to its number\n" : out;
}

}  // namespace edition
