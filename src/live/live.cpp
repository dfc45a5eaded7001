#include "live/live.hpp"

#include <gsl/gsl_errno.h>
#include <nlohmann/json.hpp>

#include "edition/registry.hpp"

namespace live
{
namespace
{

using edition::Section;
using nlohmann::ordered_json;

std::string word(const char* key, const std::string& value)
{
  return ordered_json{{key, value}}.dump();
}

/// Finds the section, gives it its parameters, and has `answer` answer.
template <class Answer>
std::string asked(const std::string& name, const std::string& given, Answer answer)
{
  gsl_set_error_handler_off();  // as the programs do
  try
  {
    for(const auto& s : edition::sections())
      if(s->program() == name)
      {
        const auto written = ordered_json::parse(given).get<std::map<std::string, std::string>>();
        edition::set_parameters(*s, {written.begin(), written.end()});
        return answer(*s);
      }
    return word("failed", name + ": no section of this program");
  }
  catch(const edition::BadInput& e)
  {
    return word("refused", e.what());
  }
  catch(const std::exception& e)
  {
    return word("failed", e.what());
  }
}

/// The section's data files, as a JSON object.
std::string data_of(const Section& s)
{
  auto data = ordered_json::object();
  for(const auto& [file, content] : edition::data_files(s))
    data[file] = content;
  return data.dump();
}

}  // namespace

std::string tell(const std::string& name, const std::string& given, bool figures)
{
  return asked(name, given, [figures](Section& s) {
    edition::tell_anew(s, {figures, false, false});
    return "{\"told\": " + edition::as_json(s) + ", \"text\": " + ordered_json(edition::as_text(s)).dump()
           + ", \"data\": " + data_of(s) + '}';
  });
}

std::string frames(const std::string& name, const std::string& given)
{
  return asked(name, given, [](Section& s) {
    edition::tell_anew(s, {false, true, false});
    return "{\"data\": " + data_of(s) + '}';
  });
}

std::string check(const std::string& name, const std::string& given)
{
  return asked(name, given,
               [](Section& s) { return "{\"checked\": " + edition::run_checks(s, {}, true).report + '}'; });
}

}  // namespace live
