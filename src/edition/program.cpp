// A section's program: its command line, and what it answers.

#include <cstdio>
#include <map>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include "edition/registry.hpp"

namespace
{

using namespace edition;

/// What the reader asks of the program.
struct Request
{
  bool json = false;
  bool check = false;
  bool bench = false;
  std::string data;
  std::map<std::string, std::vector<std::string>> given;  ///< Parameter name to what was written for it.
  std::vector<std::string> for_doctest;
  std::string answer;  ///< Set when --help or --version is all there is to say.
};

std::string option_help(const ParameterEntry& p)
{
  const std::string most = p.usual.most_in_words;
  return fmt::format("{} (default {}{}; {})", p.meaning, with_unit(show(p.default_shown, 12), p.unit),
                     most.empty() ? "" : ", or " + most + " where that is less", allowed(p));
}

/// What may follow an option on the command line.
std::string allowed_for(const Section& s, const std::string& option)
{
  for(const ParameterEntry& p : s.parameters)
    if("--" + p.name == option)
      return allowed(p);
  return "a folder";
}

/// What CLI11 would take in silence: a value for an option that has none, and an empty value, for which it takes
/// the next argument.
void refuse_odd_equations(const Section& s, const std::vector<std::string>& arguments)
{
  for(const std::string& argument : arguments)
  {
    const auto equals = argument.find('=');
    if(!argument.starts_with("--") || equals == std::string::npos)
      continue;
    const std::string option = argument.substr(0, equals);
    const std::string value = argument.substr(equals + 1);
    for(const char* flag : {"--json", "--check", "--bench", "--help", "--version"})
      if(option == flag)
        throw BadInput(fmt::format("{}: \"{}\" is a value for what has none; allowed: {} alone", option,
                                   on_one_line(value), option));
    if(value.empty())
      throw BadInput(
          fmt::format("{}: \"\" is no value; allowed: {}", on_one_line(option), allowed_for(s, option)));
  }
}

Request parse(Section& s, std::vector<std::string> arguments)
{
  Request r;
  if(const auto dashes = std::find(arguments.begin(), arguments.end(), "--"); dashes != arguments.end())
  {
    r.for_doctest.assign(dashes + 1, arguments.end());
    arguments.erase(dashes, arguments.end());
  }
  refuse_odd_equations(s, arguments);
  CLI::App app{fmt::format("{} §{}. {}", s.chapter, s.number, s.title), s.program()};
  app.set_help_flag("--help", "say this and end");
  app.set_version_flag("--version",
                       fmt::format("{} (Euler on Oscillation {})", s.program(), EDITION_VERSION),
                       "say which edition this is and end");
  for(const ParameterEntry& p : s.parameters)
    app.add_option("--" + p.name, r.given[p.name], option_help(p))
        ->type_name(p.type == ParameterEntry::Type::integer ? "WHOLE NUMBER" : "NUMBER")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
  app.add_flag("--json", r.json, "tell it, or the checks, or the races, to machines");
  app.add_flag("--check", r.check,
               "run the checks; what follows -- goes to doctest; exit status 1 when one fails");
  app.add_flag("--bench", r.bench, "time the several ways to one number against each other");
  auto* const data = app.add_option("--data", r.data, "write the figures' data into this folder")
                         ->type_name("DIR")
                         ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.allow_extras();
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes a vector from its end
  try
  {
    app.parse(arguments);
  }
  catch(const CLI::CallForHelp&)
  {
    r.answer = app.help();
  }
  catch(const CLI::CallForVersion& version)
  {
    r.answer = std::string(version.what()) + '\n';
  }
  catch(const CLI::ArgumentMismatch& e)  // "--zeta: ...": its value is missing
  {
    const std::string option = std::string(e.what()).substr(0, std::string(e.what()).find(':'));
    throw BadInput(
        fmt::format("{}: \"\" is no value; allowed: {}", on_one_line(option), allowed_for(s, option)));
  }
  catch(const CLI::ParseError& e)
  {
    throw BadInput(fmt::format("{}; allowed: what --help lists", on_one_line(e.what())));
  }
  if(const auto unknown = app.remaining(); !unknown.empty())
    throw BadInput(fmt::format("{}: \"{}\" is not known here; allowed: what --help lists",
                               unknown.front().starts_with('-') ? "option" : "argument",
                               on_one_line(unknown.front())));
  if(!r.for_doctest.empty() && !r.check)
    throw BadInput(fmt::format("-- \"{}\": arguments for doctest without --check; allowed: after --check",
                               on_one_line(r.for_doctest.front())));
  if(data->count() > 1)
    throw BadInput(fmt::format("--data: given {} times; allowed: once", data->count()));
  if(data->count() > 0 && r.data.empty())
    throw BadInput("--data: \"\" is no value; allowed: a folder");
  if(r.check + r.bench + !r.data.empty() > 1)
    throw BadInput("--check, --bench, --data: more than one given; allowed: one of them");
  return r;
}

void take_parameters(Section& s, const Request& r)
{
  std::vector<std::pair<std::string, std::string>> once;
  for(const auto& [name, given] : r.given)
  {
    if(given.size() > 1)
      throw BadInput(fmt::format("--{}: given {} times (\"{}\"); allowed: once", name, given.size(),
                                 on_one_line(fmt::format("{}", fmt::join(given, "\", \"")))));
    if(!given.empty())
      once.emplace_back(name, given.front());
  }
  set_parameters(s, once);
}

/// All of `text`, or an exception: standard output may be a full disk.
void say(const std::string& text)
{
  if(std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw std::runtime_error("cannot write to standard output");
}

int answer(Section& s, const std::vector<std::string>& arguments)
{
  const Request r = parse(s, arguments);
  if(!r.answer.empty())
  {
    say(r.answer);
    return 0;
  }
  take_parameters(s, r);
  if(r.check)
  {
    const CheckResult result = run_checks(s, r.for_doctest, r.json);
    say(result.report);
    return result.passed ? 0 : 1;
  }
  const bool data = !r.data.empty();
  tell_anew(s, {data, data, r.bench});
  const std::string written = data ? write_data(s, r.data) : "";
  say(r.json ? as_json(s) : data ? written : r.bench ? races_as_text(s) : as_text(s));
  return 0;
}

/// One line on standard error. Where that is closed or full the exit status alone must say it.
int complain(const std::string& program, const std::string& what, int status)
{
  std::string line = program + ": " + what;
  std::replace(line.begin(), line.end(), '\n', ' ');
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
  return status;
}

/// The section that a program is; of several that were built into one, that by whose name it is called.
Section& called(std::string_view name)
{
  name = name.substr(name.rfind('/') + 1);
  for(const auto& s : sections())
    if(s->program() == name)
      choose(*s);
  return section();
}

}  // namespace

int edition::run(int argc, char** argv)
{
  gsl_set_error_handler_off();  // GSL's own handler ends the program; its functions' status and NaN say enough
  Section& s = called(argc > 0 ? argv[0] : "");
  if(!s.faults.empty())
    return complain(s.program(), s.faults.front(), 1);
  try
  {
    return answer(s, {argv + 1, argv + argc});
  }
  catch(const BadInput& e)
  {
    return complain(s.program(), e.what(), 2);
  }
  catch(const std::exception& e)
  {
    return complain(s.program(), e.what(), 1);
  }
}
