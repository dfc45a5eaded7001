/// @file
/// What every benchmark asks and reports alike.
#pragma once

#include <fstream>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "race/race.hpp"

namespace race
{

/// In the order in which it is written.
using Json = nlohmann::ordered_json;

/// What is asked of a benchmark.
struct Asked
{
  bool as_json = false;      ///< JSON, not a table
  bool errors_only = false;  ///< no timing
  int rounds = 11;           ///< of each race
  std::string scene;         ///< only scenes whose name contains this

  /// Whether a scene is wanted.
  bool wants(const std::string& name) const { return name.find(scene) != std::string::npos; }
  /// How its race is run.
  Options options() const { return {rounds, 2e-3}; }
};

/// What is wrong with a number of rounds as it is written, or nothing. CLI11 would read 010 as eight.
inline std::string no_rounds(const std::string& written)
{
  const bool digits = written.find_first_not_of("0123456789") == std::string::npos;
  const bool whole = !written.empty() && written.front() != '0' && digits;
  return whole && (written.size() < 4 || written == "1000")
             ? ""
             : fmt::format("{}; allowed: a whole number from 1 to 1000", written);
}

/// Reads the command line. The status to end with, where there is nothing to run; what is wrong is told in one line.
inline std::optional<int> read(Asked& asked, const std::string& about, int argc, char** argv,
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

/// The processor's name as Linux gives it; "unknown" where it gives none.
inline std::string processor()
{
  std::ifstream info("/proc/cpuinfo");
  for(std::string line; std::getline(info, line);)
    if(line.starts_with("model name"))
      return line.substr(line.find(": ") + 2);
  return "unknown";
}

/// How a report begins: what the times depend on.
inline Json begun(const Asked& asked, const char* compiler, const char* flags)
{
  if(asked.errors_only)
    return Json::object();
  return {{"machine", processor()}, {"compiler", compiler}, {"flags", flags}, {"rounds", asked.rounds}};
}

/// Reports which peers are not installed.
inline void leave_out(Json& report, const Asked& asked, const std::vector<std::string>& peers)
{
  report["left_out"] = peers;
  if(!asked.as_json)
    for(const std::string& name : peers)
      fmt::print("Left out, for it is not installed: {}\n", name);
}

/// A scene without its methods, with the method by whose time the others' are divided.
inline Json scene(const std::string& name, const std::string& quantity, const std::string& unit,
                  const std::string& peer)
{
  return {{"name", name},
          {"quantity", quantity},
          {"error_unit", unit},
          {"peer", peer},
          {"methods", Json::array()}};
}

/// A number rounded to three digits: what a table shows, and more than a repeated run keeps.
inline double three_digits(double x)
{
  return std::stod(fmt::format("{:.3g}", x));
}

/// Adds to a method's row what was measured of it.
inline void put_times(Json& row, const Timing& timing)
{
  row["seconds"] = three_digits(timing.seconds);
  row["fastest"] = three_digits(timing.fastest);
  row["ratio"] = three_digits(timing.ratio);
}

/// Adds a scene to the report if it is wanted: `made` is what is reported of it, `print` shows that where no
/// JSON is asked for.
inline void add_scene(Json& report, const Asked& asked, const std::string& name,
                      const std::function<Json()>& made, const std::function<void(const Json&)>& print)
{
  if(!asked.wants(name))
    return;
  Json& scenes = report["scenes"];
  scenes.push_back(made());
  if(!asked.as_json)
    print(scenes.back());
}

/// Ends the report; the program's status.
inline int ended(const Json& report, const Asked& asked)
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
