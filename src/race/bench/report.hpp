/// @file
/// What every benchmark asks and reports alike.
#pragma once

#include <fstream>
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

/// Reads the command line. The status to end with, where there is nothing to run.
inline std::optional<int> read(Asked& asked, const std::string& about, int argc, char** argv,
                               bool times_can_be_left_out)
{
  CLI::App app{about};
  app.add_flag("--json", asked.as_json, "print JSON");
  if(times_can_be_left_out)
    app.add_flag("--errors-only", asked.errors_only, "no timing: the same bytes in every run");
  app.add_option("--rounds", asked.rounds, "rounds of each race")->check(CLI::Range(1, 1000));
  app.add_option("--scene", asked.scene, "only scenes whose name contains this");
  try
  {
    app.parse(argc, argv);
  }
  catch(const CLI::ParseError& e)
  {
    return app.exit(e) == 0 ? 0 : 2;
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

/// Ends the report; the program's status.
inline int ended(const Json& report, const Asked& asked)
{
  if(asked.as_json)
    std::cout << report.dump(1) << '\n';
  return std::cout.flush() ? 0 : 1;
}

}  // namespace race
