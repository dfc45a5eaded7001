/// @file
/// bench-globe: Carlson's integrals, the times of the ball and its way with friction, ours and the usual libraries'
/// side by side in one process, speed and error in one row.
#include <string>
#include <vector>

#include <fmt/format.h>

#include "race/bench/report.hpp"
#include "race/race.hpp"
#include "scenes.hpp"

namespace
{

using race::Json;

Json report(const bench::Scene& scene, bool errors_only, race::Options options)
{
  Json json = race::scene(scene.name, scene.quantity, scene.unit, scene.methods[0].name);
  std::vector<race::Entrant> entrants;
  std::vector<double> out(scene.size);
  for(const bench::Method& method : scene.methods)
  {
    method.run(out);
    const bench::Error e = bench::judge(scene, out);
    Json row{{"name", method.name}, {"kind", method.kind}};
    row["ulps_max"] = e.failures == e.judged ? Json("nan") : Json(race::three_digits(e.worst));
    row["ulps_mean"] = e.failures == e.judged ? Json("nan") : Json(race::three_digits(e.mean));
    row["failures"] = e.failures;
    row["judged"] = e.judged;
    json["methods"].push_back(row);
    entrants.push_back({method.name,
                        [&method, &out] {
                          method.run(out);
                          race::keep(out.front());
                        },
                        scene.size});
  }
  if(errors_only)
    return json;
  const std::vector<race::Timing> timings = race::run(entrants, options);
  for(std::size_t i = 0; i < timings.size(); ++i)
  {
    json["methods"][i]["seconds"] = race::three_digits(timings[i].seconds);
    json["methods"][i]["ratio"] = race::three_digits(timings[i].ratio);
  }
  return json;
}

void print(const Json& scene, bool errors_only)
{
  fmt::print("\n{}: {}\n  errors in {}, speed as a multiple of the first\n",
             scene["name"].get<std::string>(), scene["quantity"].get<std::string>(),
             scene["error_unit"].get<std::string>());
  for(const Json& row : scene["methods"])
  {
    fmt::print("  worst {:>9} mean {:>9} failures {:>4}", row["ulps_max"].dump(), row["ulps_mean"].dump(),
               row["failures"].get<std::size_t>());
    if(!errors_only)
      fmt::print("  {:>9.4g} ns {:>7.3g}x", row["seconds"].get<double>() * 1e9,
                 1 / row["ratio"].get<double>());
    fmt::print("  {}\n", row["name"].get<std::string>());
  }
}

}  // namespace

int main(int argc, char** argv)
{
  race::Asked asked;
  if(const auto status = race::read(
         asked,
         "The globe's integrals and times: speed against error, ours and the usual libraries' in one run.",
         argc, argv, true))
    return *status;
  Json json = race::begun(asked, GLOBE_COMPILER, GLOBE_FLAGS);
  for(const bench::Lazy& lazy : bench::all_scenes())
    race::add_scene(
        json, asked, lazy.name, [&] { return report(lazy.make(), asked.errors_only, asked.options()); },
        [&](const Json& made) { print(made, asked.errors_only); });
  return race::ended(json, asked);
}
