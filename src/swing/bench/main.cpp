/// @file
/// bench-swing: the swing's time and motion, ours and the usual libraries' side by side, speed and error in
/// one row.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cold.hpp"
#include "libraries.hpp"
#include "race/bench/report.hpp"
#include "race/race.hpp"
#include "scenes.hpp"
#include "swing/kernels.hpp"

namespace
{

using race::Json;

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
  Json json = race::scene(scene.name, scene.quantity, scene.unit, scene.peer);
  for(const bench::Method& method : scene.methods)
    json["methods"].push_back(errors_of(scene, method));
  if(!errors_only)
    for(const race::Timing& timing : race_of(scene, options))
      for(Json& row : json["methods"])
        if(row["name"] == timing.name)
          race::put_times(row, timing);
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
  race::Asked asked;
  if(const auto status = race::read(
         asked,
         "The swing's time and motion: speed against error, ours and the usual libraries' in one run.",
         argc, argv, true))
    return *status;
  Json json = race::begun(asked, SWING_COMPILER, SWING_FLAGS);
  json["tiers"] = Json::array();
  for(std::size_t v = 0; v < swing::kernels::count(); ++v)
    json["tiers"].push_back(swing::kernels::variant(v).name);
  race::leave_out(json, asked, bench::libraries::left_out());
  for(const bench::Scene& scene : bench::all_scenes())
    race::add_scene(
        json, asked, scene.name, [&] { return report(scene, asked.errors_only, asked.options()); },
        [&](const Json& made) { print(made, asked.errors_only); });
  return race::ended(json, asked);
}
