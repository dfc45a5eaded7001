/// @file
/// bench-tautochrone: a place of an exact curve, or sixty-four, by the flow on the sphere and by the usual libraries'
/// integrators, speed and error in one row.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "race/bench/report.hpp"
#include "race/bench/sundials.hpp"
#include "race/race.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/ways.hpp"

namespace
{

using exact::Fifty;
using race::Json;
using namespace tautochrone;

/// A way to r, for a tolerance: where it is timed, and for all places that are judged.
struct Way
{
  std::function<double()> run;
  std::function<std::vector<double>()> judged;
};

Way to_one_place(const std::function<double()>& run)
{
  return {run, [run] { return std::vector{run()}; }};
}

struct Method
{
  std::string name;
  std::string kind;
  Way way;
};

struct Scene
{
  std::string name;
  std::string quantity;
  std::vector<Fifty> exact;     ///< r at the places that are judged
  std::vector<Method> methods;  ///< the first is what the others' times are divided by
};

/// An equation as it is followed downwards, by the angle that is left behind.
struct Downwards
{
  double k, last;
};

int slope_downwards(double t, const double r[], double out[], void* of)
{
  const Downwards& from = *static_cast<const Downwards*>(of);
  out[0] = -slope(from.last - t, r[0], from.k);
  return 0;
}

double error_of(const Scene& scene, const Method& method)
{
  const std::vector<double> r = method.way.judged();
  double worst = 0;
  for(std::size_t i = 0; i < r.size(); ++i)
    worst = std::max(worst, std::isfinite(r[i])
                                ? std::abs(static_cast<double>(Fifty(r[i]) / scene.exact.at(i) - 1))
                                : HUGE_VAL);
  return worst;
}

/// The way with the loosest tolerance that is right to 1e-13, or else with that which errs least.
void add(Scene& scene, const std::string& name, const std::function<Way(double tolerance)>& make)
{
  constexpr double wanted = 1e-13;
  std::optional<Method> best;
  for(const double tolerance :
      {1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 3e-13, 1e-13, 3e-14, 1e-14, 3e-15, 1e-15})
  {
    const Method now{name, "peer", make(tolerance)};
    const double error = error_of(scene, now);
    if(std::isfinite(error) && (!best || error < error_of(scene, *best)))
      best = now;
    if(error <= wanted)
      break;
  }
  if(best)
    scene.methods.push_back(*best);
}

Scene one_place(Member member, double k, double part)
{
  const bool highest_ = member == Member::highest;
  const Position last = end(member, k);
  const double phi = part * last.phi;
  const Point tip = widest_end(k);
  Scene scene{
      fmt::format("one place of the {} curve, k = {} a", highest_ ? "highest" : "widest", k),
      fmt::format(
          "r at {:.1f} of the angle where the {} curve of k = {} a ends; the integrators with the loosest "
          "tolerance that is right to 1e-13, or that errs least",
          part, highest_ ? "highest" : "widest", k),
      {highest_ ? highest(k, Fifty(phi)) : through(k, tip.phi, tip.r, {Fifty(phi)})[0]},
      {}};
  const auto by_gsl = [&](const std::string& name, Stepper stepper) {
    add(scene, name, [=](double tolerance) {
      return to_one_place([=] { return follow(k, last.phi, last.r, phi, tolerance, stepper); });
    });
  };
  by_gsl("GSL rk8pd", Stepper::runge_kutta);
  by_gsl("GSL bsimp", Stepper::bulirsch_stoer);
  by_gsl("GSL msadams", Stepper::adams);
  by_gsl("GSL msbdf", Stepper::gear);
  const auto of = std::make_shared<Downwards>(Downwards{k, last.phi});
  const auto by_sundials = [=](double tolerance) {
    auto all = bench::sundials::ways(slope_downwards, of, 1, tolerance);
    const auto stiff = bench::sundials::stiff_ways(slope_downwards, of, tolerance);
    all.insert(all.end(), stiff.begin(), stiff.end());
    return all;
  };
  const auto named = by_sundials(1e-7);
  for(std::size_t i = 0; i < named.size(); ++i)
    add(scene, named[i].name, [=](double tolerance) {
      const bench::sundials::Way way = by_sundials(tolerance)[i];
      return to_one_place([=] {
        double r = last.r;
        return way.from(&r, last.phi - phi) ? r : HUGE_VAL;
      });
    });
  scene.methods.push_back(
      {"flow on the sphere", "ours", to_one_place([=] { return at(member, k, phi).r; })});
  return scene;
}

Scene whole_curve(Member member, double k)
{
  constexpr std::size_t places = 64, of = 8;
  const bool highest_ = member == Member::highest;
  const Position last = end(member, k);
  const Point tip = widest_end(k);
  std::vector<double> angles;
  std::vector<Fifty> judged;
  for(std::size_t i = 1; i <= places; ++i)
  {
    angles.push_back(last.phi * (static_cast<double>(i) / (places + 1)));
    if(i % of == 0)
      judged.emplace_back(angles.back());
  }
  const std::vector<double> down(angles.rbegin(), angles.rend());
  Scene scene{
      fmt::format("the whole {} curve, k = {} a", highest_ ? "highest" : "widest", k),
      fmt::format("r at 64 angles from 0 to where the {} curve of k = {} a ends, and the error at every "
                  "eighth; the integrators, which stop at each angle, with the loosest tolerance that is "
                  "right to 1e-13, or that errs least",
                  highest_ ? "highest" : "widest", k),
      highest_ ? highest(k, judged) : through(k, tip.phi, tip.r, judged),
      {}};
  const auto by_gsl = [&](const std::string& name, Stepper stepper) {
    add(scene, name, [=](double tolerance) {
      const auto all = [=] { return follow(k, last.phi, last.r, down, tolerance, stepper); };
      const auto some = [=] {
        const auto r = all();
        std::vector<double> result;
        for(std::size_t i = of; i <= places; i += of)
          result.push_back(r[places - i]);
        return result;
      };
      return Way{[=] { return all()[places - 1]; }, some};
    });
  };
  by_gsl("GSL rk8pd", Stepper::runge_kutta);
  by_gsl("GSL bsimp", Stepper::bulirsch_stoer);
  by_gsl("GSL msadams", Stepper::adams);
  by_gsl("GSL msbdf", Stepper::gear);
  const auto some = [=] {
    const auto all = along(member, k, angles);
    std::vector<double> result;
    for(std::size_t i = of; i <= places; i += of)
      result.push_back(all[i - 1].r);
    return result;
  };
  scene.methods.push_back(
      {"flow on the sphere", "ours", {[=] { return along(member, k, angles)[0].r; }, some}});
  return scene;
}

Json report(const Scene& scene, race::Options options)
{
  Json json = race::scene(scene.name, scene.quantity, "1", scene.methods[0].name);
  std::vector<race::Entrant> entrants;
  for(const Method& method : scene.methods)
    entrants.push_back({method.name, [&method] { race::keep(method.way.run()); }, 1});
  const auto timings = race::run(entrants, options);
  for(std::size_t i = 0; i < timings.size(); ++i)
  {
    const Method& method = scene.methods[i];
    Json row{{"name", method.name},
             {"kind", method.kind},
             {"error", race::three_digits(error_of(scene, method))}};
    race::put_times(row, timings[i]);
    json["methods"].push_back(row);
  }
  return json;
}

void print(const Json& scene)
{
  fmt::print("\n{}: {}\n  {:<24} {:>10} {:>12} {:>8}\n", scene["name"].get<std::string>(),
             scene["quantity"].get<std::string>(), "", "error", "microseconds", "speed");
  for(const Json& row : scene["methods"])
    fmt::print("  {:<24} {:>10.2g} {:>12.4g} {:>7.3g}x\n", row["name"].get<std::string>(),
               row["error"].get<double>(), row["seconds"].get<double>() * 1e6,
               1 / row["ratio"].get<double>());
}

}  // namespace

int main(int argc, char** argv)
{
  race::Asked asked;
  if(const auto status = race::read(
         asked, "The exact tautochrones: speed against error, ours and the usual libraries' in one run.",
         argc, argv, false))
    return *status;
  Json json = race::begun(asked, TAUTOCHRONE_COMPILER, TAUTOCHRONE_FLAGS);
  race::leave_out(json, asked, bench::sundials::left_out());
  for(const Member member : {Member::highest, Member::widest})
    for(const double k : {0.02, 0.1, 0.3, 0.7, 0.99})
    {
      const auto add_scene = [&](const Scene& scene) {
        race::add_scene(
            json, asked, scene.name, [&] { return report(scene, asked.options()); }, print);
      };
      add_scene(one_place(member, k, 0.8));
      add_scene(whole_curve(member, k));
    }
  return race::ended(json, asked);
}
