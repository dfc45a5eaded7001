/// @file
/// bench-balance: the motion of the balance, by our collocation with each instruction set and by the usual libraries,
/// speed and error in one row.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <boost/numeric/odeint.hpp>
#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "balance/systems.hpp"
#include "race/bench/report.hpp"
#include "race/bench/sundials.hpp"
#include "race/race.hpp"

namespace
{

using collocation::Moment;
using race::Json;
using namespace balance::systems;

constexpr double year = 2 * std::numbers::pi;  // a period of the beam

/// The equations as an integrator of six numbers wants them, with the C library's sines and the addition theorem, as
/// quick as they can be written for one processor.
using State = std::array<double, 6>;

void slope(const Fixed& of, const double* y, double* d)
{
  const double so = std::sin(y[0]), co = std::cos(y[0]), se = std::sin(y[1]), ce = std::cos(y[1]),
               st = std::sin(y[2]), ct = std::cos(y[2]);
  const double s1 = so * ce - co * se, c1 = co * ce + so * se, s2 = so * ct - co * st,
               c2 = co * ct + so * st;
  const double centripetal = of.beta * y[3] * y[3];
  const double eta = centripetal * c1 - of.mu2 * se, theta = -(of.mu2 * st) - centripetal * c2;
  const double pull = (s1 * eta - s2 * theta) + (c2 * y[5] * y[5] - c1 * y[4] * y[4]);
  const double omega = (of.rho / of.beta * pull - of.lambda2 * so) / (1 - of.rho * (s1 * s1 + s2 * s2));
  d[0] = y[3];
  d[1] = y[4];
  d[2] = y[5];
  d[3] = omega;
  d[4] = eta + of.beta * omega * s1;
  d[5] = theta - of.beta * omega * s2;
}

int slope_for_gsl(double, const double y[], double d[], void* of)
{
  slope(*static_cast<const Fixed*>(of), y, d);
  return GSL_SUCCESS;
}

int pan_for_gsl(double t, const double y[], double d[], void* of)
{
  const Prescribed& p = *static_cast<const Prescribed*>(of);
  const double stiffness = p.strength * std::cos(p.lambda * t) - p.mu2;
  d[0] = y[2];
  d[1] = y[3];
  d[2] = stiffness * y[0];
  d[3] = stiffness * y[1];
  return GSL_SUCCESS;
}

template <std::size_t n>
bool by_gsl(int (*equations)(double, const double*, double*, void*), void* of, std::array<double, n>& y,
            double t, double tolerance)
{
  gsl_odeiv2_system system{equations, nullptr, n, of};
  gsl_odeiv2_driver* driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 0.01, tolerance, tolerance);
  double from = 0;
  const int status = gsl_odeiv2_driver_apply(driver, &from, t, y.data());
  gsl_odeiv2_driver_free(driver);
  return status == GSL_SUCCESS;
}

State row(const Moment<3>& m)
{
  return {m.x[0], m.x[1], m.x[2], m.v[0], m.v[1], m.v[2]};
}

/// The largest of the six differences, the pans' rates over μ.
double error_of(const State& y, const State& exact)
{
  double most = 0;
  for(std::size_t k = 0; k < 6; ++k)
    most = std::max(most, std::abs(y[k] - exact[k]) / (k > 3 ? 3 : 1));
  return std::isfinite(y[0]) ? most : HUGE_VAL;
}

double energy_of(const Fixed& b, const State& y)
{
  const auto height = [](double x) { return 2 * std::sin(x / 2) * std::sin(x / 2); };
  const double pans = (y[4] * y[4] + y[5] * y[5]) / 2 + b.mu2 * (height(y[1]) + height(y[2]));
  const double coupled = b.beta * y[3] * (y[5] * std::sin(y[0] - y[2]) - y[4] * std::sin(y[0] - y[1]));
  return y[3] * y[3] / 2 + b.lambda2 * height(y[0]) + b.rho / (b.beta * b.beta) * (pans + coupled);
}

struct Method
{
  std::string name;
  std::string kind;
  std::function<double()> run;     ///< its error
  std::optional<double> energy{};  ///< what it added to the energy, relatively
  std::size_t times = 1;           ///< that it comes to the result in a run
};

struct Scene
{
  std::string name;
  std::string quantity;
  std::string unit;             ///< of the errors
  std::vector<Method> methods;  ///< the peer that the others' times are divided by first
};

constexpr const char* radians = "radian";

constexpr Fixed example{1, 9, 0.5, 0.25};

/// A motion of the example's balance to the time t.
Scene motion(const std::string& name, const std::string& quantity, const Moment<3>& start, double t,
             const std::vector<double>& for_gsl, const std::vector<double>& for_odeint,
             const std::vector<double>& for_sundials, const std::vector<double>& for_us)
{
  Scene scene{name, quantity, radians, {}};
  const auto exact =
      row(collocation::Motion<Fixed>(example, start, {1e-22, 0.05}, balance::systems::best().fixed).to(t));
  const auto add = [&](const std::string& way, double tolerance, const std::string& kind,
                       const std::function<State()>& run) {
    const State y = run();
    const State first = row(start);
    const double energy = energy_of(example, y) / energy_of(example, first) - 1;
    scene.methods.push_back({fmt::format("{}, {:.0e}", way, tolerance), kind,
                             [run, exact] { return error_of(run(), exact); }, energy});
  };
  for(const double tolerance : for_gsl)
    add("GSL rk8pd", tolerance, "peer", [=] {
      State y = row(start);
      Fixed of = example;
      by_gsl(slope_for_gsl, &of, y, t, tolerance);
      return y;
    });
  namespace odeint = boost::numeric::odeint;
  const auto equations = [](const State& y, State& d, double) { slope(example, y.data(), d.data()); };
  for(const double tolerance : for_odeint)
  {
    add("odeint fehlberg78", tolerance, "peer", [=] {
      State y = row(start);
      odeint::integrate_adaptive(
          odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(tolerance, tolerance), equations,
          y, 0.0, t, 0.01);
      return y;
    });
    add("odeint bulirsch_stoer", tolerance, "peer", [=] {
      State y = row(start);
      odeint::bulirsch_stoer<State> stepper(tolerance, tolerance);
      odeint::integrate_adaptive(stepper, equations, y, 0.0, t, 0.01);
      return y;
    });
  }
  const auto of = std::make_shared<Fixed>(example);
  for(const double tolerance : for_sundials)
    for(const bench::sundials::Way& way : bench::sundials::ways(slope_for_gsl, of, 6, tolerance))
      add(way.name, tolerance, "peer", [=] {
        State y = row(start);
        if(!way.from(y.data(), t))
          y[0] = HUGE_VAL;
        return y;
      });
  for(std::size_t i = 0; i < count(); ++i)
    for(const double tolerance : for_us)
      add(fmt::format("Gauss 8, {}", kernels(i).name), tolerance, "ours", [=] {
        return row(collocation::Motion<Fixed>(example, start, {tolerance, 0.05}, kernels(i).fixed).to(t));
      });
  return scene;
}

/// Eight motions; the error is the largest of any.
Scene ensemble()
{
  constexpr double t = 100 * year;
  constexpr collocation::Care care{1e-10, 0.05};
  Scene scene{"eight motions", "eight motions near Euler's example, 100 periods of the beam", radians, {}};
  std::array<Moment<3>, 8> starts;
  std::array<State, 8> exact;
  for(unsigned i = 0; i < 8; ++i)
  {
    starts[i] = {{1. / 6 + 0.001 * i, 1. / 6 - 0.002 * i, 1. / 6}, {}};
    exact[i] = row(collocation::Motion<Fixed>(example, starts[i], {1e-22, 0.05}, best().fixed).to(t));
  }
  for(std::size_t v = 0; v < count(); ++v)
  {
    const auto alone = [=] {
      double most = 0;
      for(unsigned i = 0; i < 8; ++i)
        most = std::max(
            most,
            error_of(row(collocation::Motion<Fixed>(example, starts[i], care, kernels(v).fixed).to(t)),
                     exact[i]));
      return most;
    };
    const auto together = [=] {
      const auto states =
          collocation::Ensemble<Fixed>(example, starts, care, kernels(v).fixed_together).to(t);
      double most = 0;
      for(unsigned i = 0; i < 8; ++i)
        most = std::max(most, error_of(row(states[i]), exact[i]));
      return most;
    };
    scene.methods.push_back({fmt::format("one after the other, {}", kernels(v).name), "ours", alone});
    scene.methods.push_back({fmt::format("side by side, {}", kernels(v).name), "ours", together});
  }
  return scene;
}

/// Points of the chart about the one of the scene.
struct Row
{
  static constexpr std::size_t points = 64;
  double a[points], q[points], exact[points];
  balance::Halves at[points]{};

  Row()
  {
    for(std::size_t i = 0; i < points; ++i)
    {
      a[i] = 30 + 0.1875 * static_cast<double>(i);  // 36 among them
      q[i] = 1. / 6;
      const Prescribed pan{a[i] / 4, 1, q[i] / 2};
      const auto end =
          collocation::Motion<Prescribed>(pan, {{1, 0}, {0, 1}}, {1e-18, 0.05}, best().prescribed)
              .to(year / 2);
      exact[i] = end.x[0] * end.v[1] + end.x[1] * end.v[0];
    }
  }

  double error() const
  {
    double most = 0;
    for(std::size_t i = 0; i < points; ++i)
      most = std::max(most, std::abs(at[i].half_trace() - exact[i]));
    return most;
  }
};

Scene chart()
{
  Scene scene{"stability chart",
              "half trace of a pan's equation, a point of the stability chart (a = 36, q = 1/6)",
              "1",
              {}};
  constexpr double exact = 0.9999999946033331161;
  const Prescribed pan{9, 1, 1. / 12};
  const auto by_solutions = [=](const std::array<double, 4>& y) {
    return std::abs(y[0] * y[3] + y[1] * y[2] - exact);
  };
  scene.methods.push_back({"GSL rk8pd, 1e-8", "peer", [=] {
                             std::array<double, 4> y{1, 0, 0, 1};
                             Prescribed of = pan;
                             by_gsl(pan_for_gsl, &of, y, year, 1e-8);
                             return std::abs((y[0] + y[3]) / 2 - exact);
                           }});
  scene.methods.push_back({"GSL rk8pd over half the period, 1e-8", "peer", [=] {
                             std::array<double, 4> y{1, 0, 0, 1};
                             Prescribed of = pan;
                             by_gsl(pan_for_gsl, &of, y, year / 2, 1e-8);
                             return by_solutions(y);
                           }});
  const auto of = std::make_shared<Prescribed>(pan);
  for(const bench::sundials::Way& way : bench::sundials::ways(pan_for_gsl, of, 4, 1e-8))
    scene.methods.push_back({way.name + " over half the period, 1e-8", "peer", [=] {
                               std::array<double, 4> y{1, 0, 0, 1};
                               return way.from(y.data(), year / 2) ? by_solutions(y) : HUGE_VAL;
                             }});
  constexpr double third = year / 6 * (1 + 0x1p-20);  // so that no fourth step is left over
  const auto of_points = std::make_shared<Row>();
  for(std::size_t v = 0; v < count(); ++v)
  {
    scene.methods.push_back(
        {fmt::format("Gauss 8 over half the period, {}, 1e-3", kernels(v).name), "ours", [=] {
           collocation::Motion<Prescribed> motion(pan, {{1, 0}, {0, 1}}, {1e-3, third},
                                                  kernels(v).prescribed);
           const auto at = motion.to(year / 2);
           return by_solutions({at.x[0], at.x[1], at.v[0], at.v[1]});
         }});
    scene.methods.push_back({fmt::format("series, {}", kernels(v).name), "ours", [=] {
                               double a = 36, q = 1. / 6;
                               race::forget(a);
                               race::forget(q);
                               balance::Halves at{};
                               kernels(v).halves_of_one(a, q, at);
                               return std::abs(at.half_trace() - exact);
                             }});
    scene.methods.push_back({fmt::format("series, a row of {} points, {}", Row::points, kernels(v).name),
                             "ours",
                             [=] {
                               kernels(v).halves_of_many(of_points->a, of_points->q, of_points->at,
                                                         Row::points);
                               return of_points->error();
                             },
                             {},
                             Row::points});
  }
  return scene;
}

Json report(const Scene& scene, race::Options options)
{
  Json json = race::scene(scene.name, scene.quantity, scene.unit, scene.methods[0].name);
  std::vector<race::Entrant> entrants;
  for(const Method& method : scene.methods)
    entrants.push_back({method.name, [&method] { race::keep(method.run()); }, method.times});
  const auto timings = race::run(entrants, options);
  for(std::size_t i = 0; i < timings.size(); ++i)
  {
    const Method& method = scene.methods[i];
    Json row{{"name", method.name}, {"kind", method.kind}, {"error", race::three_digits(method.run())}};
    if(method.energy)
      row["energy"] = race::three_digits(*method.energy);
    race::put_times(row, timings[i]);
    json["methods"].push_back(row);
  }
  return json;
}

void print(const Json& scene)
{
  fmt::print("\n{}: {}\n  {:<44} {:>10} {:>10} {:>12} {:>8}\n", scene["name"].get<std::string>(),
             scene["quantity"].get<std::string>(), "", "error", "energy", "microseconds", "speed");
  for(const Json& row : scene["methods"])
    fmt::print("  {:<44} {:>10.2g} {:>10} {:>12.4g} {:>7.3g}x\n", row["name"].get<std::string>(),
               row["error"].get<double>(),
               row.contains("energy") ? fmt::format("{:.2g}", row["energy"].get<double>()) : "",
               row["seconds"].get<double>() * 1e6, 1 / row["ratio"].get<double>());
}

}  // namespace

int main(int argc, char** argv)
{
  race::Asked asked;
  if(const auto status = race::read(
         asked, "The motion of the balance: speed against error, ours and the usual libraries' in one run.",
         argc, argv, false))
    return *status;
  const Moment<3> start{{1. / 6, 1. / 6, 1. / 6}, {}}, violent{{0.6, 0.9, -0.5}, {}};
  const std::vector<std::function<Scene()>> scenes{
      [&] {
        return motion("Euler's example", "Euler's example, 100 periods of the beam", start, 100 * year,
                      {1e-12, 1e-13}, {1e-12, 1e-14}, {1e-11, 1e-12}, {1e-8, 3e-9, 1e-10, 1e-14});
      },
      [&] {
        return motion("violent motion", "the motion from (0.6, 0.9, −0.5), 3 periods of the beam", violent,
                      3 * year, {1e-12, 1e-14}, {1e-14}, {1e-12}, {1e-10, 2e-11, 1e-11, 1e-14});
      },
      ensemble, chart,
      [&] {
        return motion("ten thousand periods", "Euler's example, 10⁴ periods of the beam", start, 1e4 * year,
                      {1e-12}, {}, {}, {1e-9, 1e-10, 1e-14});
      }};
  Json json = race::begun(asked, BALANCE_COMPILER, BALANCE_FLAGS);
  race::leave_out(json, asked, bench::sundials::left_out());
  for(const auto& make : scenes)
  {
    const Scene scene = make();
    race::add_scene(
        json, asked, scene.name, [&] { return report(scene, asked.options()); }, print);
  }
  return race::ended(json, asked);
}
