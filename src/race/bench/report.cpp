#include "race/bench/report.hpp"

#include <fstream>
#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace race
{
namespace
{

/// What is wrong with a number of rounds as it is written, or nothing. CLI11 would read 010 as eight.
std::string no_rounds(const std::string& written)
{
  const bool digits = written.find_first_not_of("0123456789") == std::string::npos;
  const bool whole = !written.empty() && written.front() != '0' && digits;
  return whole && (written.size() < 4 || written == "1000")
             ? ""
             : fmt::format("{}; allowed: a whole number from 1 to 1000", written);
}

/// The processor's name as Linux gives it; "unknown" where it gives none.
std::string processor()
{
  std::ifstream info("/proc/cpuinfo");
  for(std::string line; std::getline(info, line);)
    if(line.starts_with("model name"))
      return line.substr(line.find(": ") + 2);
  return "unknown";
}

}  // namespace

std::optional<int> read(Asked& asked, const std::string& about, int argc, char** argv,
                        bool times_can_be_left_out)
{
  CLI::App app{about};
  app.add_flag("--json", asked.as_json, "print JSON");
  if(times_can_be_left_out)
    app.add_flag("--errors-only", asked.errors_only, "no timing: the same bytes in every run");
  app.add_option("--rounds", asked.rounds, "rounds of each race")->check(no_rounds);
  app.add_option("--scene", asked.scene, "only scenes whose name contains this");
  try
  {
    app.parse(argc, argv);
  }
  catch(const CLI::ParseError& e)
  {
    if(e.get_exit_code() == 0)
      return app.exit(e);
    std::cerr << e.what()
              << (dynamic_cast<const CLI::ValidationError*>(&e) ? "\n" : "; allowed: what --help lists\n");
    return 2;
  }
  return std::nullopt;
}

Json begun(const Asked& asked, const char* compiler, const char* flags)
{
  if(asked.errors_only)
    return Json::object();
  return {{"machine", processor()}, {"compiler", compiler}, {"flags", flags}, {"rounds", asked.rounds}};
}

void leave_out(Json& report, const Asked& asked, const std::vector<std::string>& peers)
{
  report["left_out"] = peers;
  if(!asked.as_json)
    for(const std::string& name : peers)
      fmt::print("Left out, for it is not installed: {}\n", name);
}

Json scene(const std::string& name, const std::string& quantity, const std::string& unit,
           const std::string& peer)
{
  return {{"name", name},
          {"quantity", quantity},
          {"error_unit", unit},
          {"peer", peer},
          {"methods", Json::array()}};
}

double three_digits(double x)
{
  return std::stod(fmt::format("{:.3g}", x));
}

void put_times(Json& row, const Timing& timing)
{
  row["seconds"] = three_digits(timing.seconds);
  row["fastest"] = three_digits(timing.fastest);
  row["ratio"] = three_digits(timing.ratio);
}

void add_scene(Json& report, const Asked& asked, const std::string& name, const std::function<Json()>& made,
               const std::function<void(const Json&)>& print)
{
  if(!asked.wants(name))
    return;
  Json& scenes = report["scenes"];
  scenes.push_back(made());
  if(!asked.as_json)
    print(scenes.back());
}

int ended(const Json& report, const Asked& asked)
{
  if(!report.contains("scenes"))
  {
    std::cerr << "--scene: " << asked.scene << "; allowed: a part of a scene's name\n";
    return 2;
  }
  if(asked.as_json)
    std::cout << report.dump(1) << '\n';
  return std::cout.flush() ? 0 : 1;
}

}  // namespace race
