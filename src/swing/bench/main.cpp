/// @file
/// bench-swing: the swing's time and motion, ours and the usual libraries' side by side, speed and error in
/// one row.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cold.hpp"
#include "libraries.hpp"
#include "race/race.hpp"
#include "race/report.hpp"
#include "scenes.hpp"
#include "swing/kernels.hpp"

namespace
{

using Json = nlohmann::ordered_json;

Json errors_of(const bench::Scene& scene, const bench::Method& method)
{
  const bench::Error e = bench::judge(scene, method);
  Json row{{"name", method.name}, {"kind", method.kind}};
  const bool nothing = e.failures == e.judged;
  row["ulps_max"] = nothing ? Json("nan") : Json(race::three_digits(e.worst));
  row["ulps_mean"] = nothing ? Json("nan") : Json(race::three_digits(e.mean));
  row["failures"] = e.failures;
  row["judged"] = e.judged;
  return row;
}

// The peer first: its time is what the others' are divided by.
std::vector<const bench::Method*> peer_first(const bench::Scene& scene)
{
  std::vector<const bench::Method*> methods;
  for(const bench::Method& method : scene.methods)
    methods.push_back(&method);
  std::stable_partition(methods.begin(), methods.end(),
                        [&](const bench::Method* m) { return m->name == scene.peer; });
  return methods;
}

std::vector<race::Timing> race_of(const bench::Scene& scene, race::Options options)
{
  if(scene.cold)
  {
    std::vector<bench::cold::Entrant> entrants;
    for(const bench::Method* method : peer_first(scene))
      entrants.push_back({method->name, method->one});
    return bench::cold::run(entrants, scene.in, options.rounds);
  }
  std::vector<race::Entrant> entrants;
  std::vector<double> out(scene.in.size());
  for(const bench::Method* method : peer_first(scene))
    entrants.push_back({method->name,
                        [&scene, method, &out] {
                          method->run(scene.in, out);
                          race::keep(out.front());
                        },
                        scene.in.size()});
  return race::run(entrants, options);
}

Json report(const bench::Scene& scene, bool errors_only, race::Options options)
{
  Json json{
      {"name", scene.name}, {"quantity", scene.quantity}, {"error_unit", scene.unit}, {"peer", scene.peer}};
  json["methods"] = Json::array();
  for(const bench::Method& method : scene.methods)
    json["methods"].push_back(errors_of(scene, method));
  if(!errors_only)
    for(const race::Timing& timing : race_of(scene, options))
      for(Json& row : json["methods"])
        if(row["name"] == timing.name)
        {
          row["seconds"] = race::three_digits(timing.seconds);
          row["fastest"] = race::three_digits(timing.fastest);
          row["ratio"] = race::three_digits(timing.ratio);
        }
  return json;
}

// Counts characters, not bytes, so that the columns stand.
std::string padded(const std::string& text, std::size_t width)
{
  std::size_t length = 0;
  for(char c : text)
    length += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  return text + std::string(length < width ? width - length : 0, ' ');
}

std::string number(const Json& row, const char* key, double scale = 1)
{
  if(!row[key].is_number())
    return "-";
  return fmt::format("{:.3g}", row[key].get<double>() * scale);
}

void print(const Json& scene, bool errors_only)
{
  fmt::print("\n{}: {}\n", scene["name"].get<std::string>(), scene["quantity"].get<std::string>());
  fmt::print("  {} {:>10} {:>10} {:>9}", padded("errors in " + scene["error_unit"].get<std::string>(), 44),
             "worst", "mean", "failures");
  if(!errors_only)
    fmt::print(" {:>10} {:>10}", "ns", "speed");
  fmt::print("\n");
  for(const Json& row : scene["methods"])
  {
    fmt::print("  {} {:>10} {:>10} {:>9}", padded(row["name"].get<std::string>(), 44),
               number(row, "ulps_max"), number(row, "ulps_mean"), row["failures"].get<std::size_t>());
    if(!errors_only)
      fmt::print(" {:>10} {:>9.3g}x", number(row, "seconds", 1e9), 1 / row["ratio"].get<double>());
    fmt::print("\n");
  }
}

}  // namespace

int main(int argc, char** argv)
{
  CLI::App app{
      "The swing's time and motion: speed against error, ours and the usual libraries' in one run."};
  bool as_json = false;
  bool errors_only = false;
  int rounds = 11;
  std::string wanted;
  app.add_flag("--json", as_json, "print JSON");
  app.add_flag("--errors-only", errors_only, "no timing: the same bytes in every run");
  app.add_option("--rounds", rounds, "rounds of each race")->check(CLI::Range(1, 1000));
  app.add_option("--scene", wanted, "only scenes whose name contains this");
  try
  {
    app.parse(argc, argv);
  }
  catch(const CLI::ParseError& e)
  {
    return app.exit(e) == 0 ? 0 : 2;
  }

  Json json;
  if(!errors_only)
  {
    json["machine"] = race::processor();
    json["compiler"] = SWING_COMPILER;
    json["flags"] = SWING_FLAGS;
    json["rounds"] = rounds;
  }
  json["tiers"] = Json::array();
  for(std::size_t v = 0; v < swing::kernels::count(); ++v)
    json["tiers"].push_back(swing::kernels::variant(v).name);
  json["left_out"] = bench::libraries::left_out();
  if(!as_json)
    for(const std::string& name : bench::libraries::left_out())
      fmt::print("Left out, for it is not installed: {}\n", name);
  json["scenes"] = Json::array();
  for(const bench::Scene& scene : bench::all_scenes())
  {
    if(scene.name.find(wanted) == std::string::npos)
      continue;
    json["scenes"].push_back(report(scene, errors_only, {rounds, 2e-3}));
    if(!as_json)
      print(json["scenes"].back(), errors_only);
  }
  if(as_json)
    std::cout << json.dump(1) << '\n';
  return std::cout.flush() ? 0 : 1;
}
