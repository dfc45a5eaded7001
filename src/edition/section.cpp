// Who the sections of a program are.

#include <array>

#include <fmt/format.h>

#include "edition/registry.hpp"

namespace edition
{
namespace
{

Section*& current()
{
  static Section* chosen = nullptr;
  return chosen;
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

std::string Section::file() const
{
  return fmt::format("{}/s{:02}.cpp", chapter, number);
}

std::vector<std::unique_ptr<Section>>& sections()
{
  static std::vector<std::unique_ptr<Section>> all;
  return all;
}

Section& section()
{
  if(!current())
    throw std::logic_error("a section's file must open with SECTION(chapter, number, \"title\")");
  return *current();
}

void choose(Section& s)
{
  current() = &s;
}

Identity::Identity(const char* chapter, int number, const char* title, Source source)
{
  auto s = std::make_unique<Section>();
  s->chapter = chapter;
  s->number = number;
  s->title = title;
  if(!std::string(source.file).ends_with(s->file()))
    s->faults.push_back(fmt::format("{}:{}: SECTION names chapters/{}, which this file is not", source.file,
                                    source.line, s->file()));
  choose(*s);
  sections().push_back(std::move(s));
}

Telling::Telling(void (*body)())
{
  section().telling.push_back({body});
}

Rule<double()> Reading::constant(double value)
{
  return [value] { return value; };
}

template <Kind kind_of_entry>
EntryOf<kind_of_entry>::EntryOf(const char* where, Reading copy, Reading right, const char* because,
                                Rule<bool(double)> holds, Shown shown)
{
  section().apparatus.push_back(
      {kind_of_entry, where, std::move(copy), std::move(right), because, std::move(holds), shown});
}
template struct EntryOf<Kind::erratum>;
template struct EntryOf<Kind::emendation>;
template struct EntryOf<Kind::doubtful>;
template struct EntryOf<Kind::undecided>;

const char* name_of(Kind kind)
{
  constexpr std::array names{"erratum", "emendation", "doubtful", "undecided"};
  return names[static_cast<std::size_t>(kind)];
}

bool is_name(const std::string& name)
{
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto more = [=](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && letter(name.front()) && std::all_of(name.begin(), name.end(), more);
}

std::string on_one_line(const std::string& words)
{
  constexpr std::size_t longest = 60;
  std::string out;
  for(std::size_t i = 0; i < words.size();)
  {
    const auto byte = [&](std::size_t at) {
      return at < words.size() ? static_cast<unsigned char>(words[at]) : 0U;
    };
    const unsigned c = byte(i);
    const std::size_t length = c < 0x80                ? 1
                               : c >= 0xC2 && c < 0xE0 ? 2
                               : c >= 0xE0 && c < 0xF0 ? 3
                               : c >= 0xF0 && c < 0xF5 ? 4
                                                       : 0;
    bool whole = length > 0 && c >= ' ' && c != 0x7F && !(c == 0xC2 && byte(i + 1) < 0xA0);
    for(std::size_t k = 1; k < length; ++k)
      whole = whole && (byte(i + k) & 0xC0U) == 0x80U;
    out += whole ? words.substr(i, length) : fmt::format("\\x{:02x}", c);
    i += whole ? length : 1;
    if(out.size() > longest && i < words.size())
      return fmt::format("{}… ({} bytes)", out, words.size());
  }
  return out;
}

}  // namespace edition
