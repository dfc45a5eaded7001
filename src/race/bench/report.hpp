/// @file
/// What every benchmark asks and reports alike.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

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

/// Reads the command line. The status to end with, where there is nothing to run; what is wrong is told in one line.
std::optional<int> read(Asked& asked, const std::string& about, int argc, char** argv,
                        bool times_can_be_left_out);

/// How a report begins: what the times depend on.
Json begun(const Asked& asked, const char* compiler, const char* flags);

/// Reports which peers are not installed.
void leave_out(Json& report, const Asked& asked, const std::vector<std::string>& peers);

/// A scene without its methods, with the method by whose time the others' are divided.
Json scene(const std::string& name, const std::string& quantity, const std::string& unit,
           const std::string& peer);

/// A number rounded to three digits: what a table shows, and more than a repeated run keeps.
double three_digits(double x);

/// Adds to a method's row what was measured of it.
void put_times(Json& row, const Timing& timing);

/// Adds a scene to the report if it is wanted: `made` is what is reported of it, `print` shows that where no
/// JSON is asked for.
void add_scene(Json& report, const Asked& asked, const std::string& name, const std::function<Json()>& made,
               const std::function<void(const Json&)>& print);

/// Ends the report; the program's status.
int ended(const Json& report, const Asked& asked);

}  // namespace race
