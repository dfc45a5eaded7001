// The limits that a section sets by require(), as a check run meets them.

#include <algorithm>

#include <fmt/format.h>

#include "edition/registry.hpp"

namespace edition
{
namespace
{

/// Whether two numbers of a parameter are as near as the two sides of a limit must be.
bool near(const ParameterEntry& p, const Fifty& x, const Fifty& y)
{
  const Fifty apart = abs(x - y), larger = std::max(abs(x), abs(y));
  return p.type == ParameterEntry::Type::integer ? apart <= 1 : apart <= larger / 100 || larger <= 1e-9;
}

/// Whether the two settings differ in this parameter alone, and by little. What was not given in either keeps to
/// the others.
bool beside(const std::vector<Limit::At>& kept, const Limit::Refusal& refused)
{
  const auto& parameters = section().parameters;
  for(std::size_t i = 0; i < parameters.size(); ++i)
  {
    const Limit::At &one = kept[i], &other = refused.at[i];
    const bool apart = one.exact != other.exact && (one.given || other.given);
    if(i == refused.named ? !near(parameters[i], one.exact, other.exact) : apart)
      return false;
  }
  return true;
}

}  // namespace

void meet_limit(const Source& place, bool kept, std::size_t named)
{
  Ledger& l = ledger();
  if(!l.running)
    return;
  std::string file(place.file);
  for(const char* folder : {"chapters/", "src/"})
    if(const auto at = file.rfind(folder); at != std::string::npos)
      file = file.substr(at);
  Limit& limit = l.limits[{file, static_cast<unsigned>(place.line)}];
  if(kept ? limit.kept.contains(l.setting) : limit.refused.contains(l.setting))
    return;
  std::vector<Limit::At> at;
  for(const ParameterEntry& p : section().parameters)
    at.push_back({p.exact, !p.given.empty()});
  if(kept)
    limit.kept[l.setting] = std::move(at);
  else
    limit.refused[l.setting] = {named, std::move(at)};
}

bool both_sides(const Limit& limit)
{
  return std::any_of(limit.refused.begin(), limit.refused.end(), [&](const auto& no) {
    return std::any_of(limit.kept.begin(), limit.kept.end(),
                       [&](const auto& yes) { return beside(yes.second, no.second); });
  });
}

std::string one_sided(const Place& place, const Limit& limit)
{
  const std::string where = fmt::format("the limit of {}, line {},", place.first, place.second);
  if(limit.refused.empty())
    return where + " is not seen to refuse anything";
  const Limit::Refusal& first = limit.refused.begin()->second;
  return fmt::format("{} refuses {}, and no setting is seen that keeps it and differs by at most a "
                     "hundredth of --{} alone",
                     where, limit.refused.begin()->first, section().parameters[first.named].name);
}

}  // namespace edition
