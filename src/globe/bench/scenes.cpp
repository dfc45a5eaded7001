#include "scenes.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_sf_ellint.h>

#include "elliptic/carlson.hpp"
#include "globe/path.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"
#include "globe/time.hpp"
#include "race/bench/parts.hpp"

namespace bench
{
namespace
{

using exact::Fifty;
using namespace globe;

const Ball<double> ball = our_ball<double>;
const double k = ball.k, c = ball.c;

std::vector<double> powers_of_ten(std::uint64_t seed, std::size_t n, double low, double high)
{
  std::vector<double> x = uniform(seed, n, low, high);
  for(double& y : x)
    y = std::pow(10, y);
  return x;
}

// A method from a function of the number of the argument; what it throws becomes NaN.
template <class Function>
Method each(std::string name, std::string kind, Function f)
{
  return {std::move(name), std::move(kind), [f](std::span<double> out) {
            for(std::size_t i = 0; i < out.size(); ++i)
            {
              try
              {
                out[i] = f(i);
              }
              catch(const std::exception&)
              {
                out[i] = not_a_number;
              }
            }
          }};
}

template <class Function>
std::vector<Fifty> exactly(std::size_t n, Function f)
{
  std::vector<Fifty> values;
  for(std::size_t i = 0; i < n; ++i)
    values.push_back(f(i));
  return values;
}

// The arguments of a scene live as long as its methods.
struct Arguments
{
  std::vector<double> x, y, z, p;
};

std::shared_ptr<Arguments> carlson_arguments()
{
  return std::make_shared<Arguments>(Arguments{powers_of_ten(1, many, -6, 6), powers_of_ten(2, many, -6, 6),
                                               powers_of_ten(3, many, -6, 6),
                                               powers_of_ten(4, many, -6, 6)});
}

const char* const carlson_spread = ", arguments spread evenly in their logarithm from 1e-6 to 1e6";

Scene first_kind()
{
  const auto a = carlson_arguments();
  Scene s{"R_F", std::string("R_F(x, y, z)") + carlson_spread, "ulp", many, {}, {}};
  s.exact = exactly(2000, [=](std::size_t i) { return elliptic::R_F<Fifty>(a->x[i], a->y[i], a->z[i]); });
  s.methods = {
      each("Boost ellint_rf in double", "peer",
           [=](std::size_t i) { return boost::math::ellint_rf(a->x[i], a->y[i], a->z[i], DoubleOnly()); }),
      each("Boost ellint_rf", "peer",
           [=](std::size_t i) { return boost::math::ellint_rf(a->x[i], a->y[i], a->z[i], Promoting()); }),
      each("GSL ellint_RF", "peer",
           [=](std::size_t i) { return gsl_sf_ellint_RF(a->x[i], a->y[i], a->z[i], GSL_PREC_DOUBLE); }),
      each("this edition", "ours",
           [=](std::size_t i) { return elliptic::R_F(a->x[i], a->y[i], a->z[i]); })};
  return s;
}

Scene second_kind()
{
  const auto a = carlson_arguments();
  Scene s{"R_D", std::string("R_D(x, y, z)") + carlson_spread, "ulp", many, {}, {}};
  s.exact = exactly(2000, [=](std::size_t i) { return elliptic::R_D<Fifty>(a->x[i], a->y[i], a->z[i]); });
  s.methods = {
      each("Boost ellint_rd in double", "peer",
           [=](std::size_t i) { return boost::math::ellint_rd(a->x[i], a->y[i], a->z[i], DoubleOnly()); }),
      each("Boost ellint_rd", "peer",
           [=](std::size_t i) { return boost::math::ellint_rd(a->x[i], a->y[i], a->z[i], Promoting()); }),
      each("GSL ellint_RD", "peer",
           [=](std::size_t i) { return gsl_sf_ellint_RD(a->x[i], a->y[i], a->z[i], GSL_PREC_DOUBLE); }),
      each("this edition", "ours",
           [=](std::size_t i) { return elliptic::R_D(a->x[i], a->y[i], a->z[i]); })};
  return s;
}

Scene third_kind()
{
  const auto a = carlson_arguments();
  Scene s{"R_J", std::string("R_J(x, y, z, p)") + carlson_spread, "ulp", many, {}, {}};
  s.exact = exactly(
      2000, [=](std::size_t i) { return elliptic::R_J<Fifty>(a->x[i], a->y[i], a->z[i], a->p[i]); });
  s.methods = {each("Boost ellint_rj in double", "peer",
                    [=](std::size_t i) {
                      return boost::math::ellint_rj(a->x[i], a->y[i], a->z[i], a->p[i], DoubleOnly());
                    }),
               each("Boost ellint_rj", "peer",
                    [=](std::size_t i) {
                      return boost::math::ellint_rj(a->x[i], a->y[i], a->z[i], a->p[i], Promoting());
                    }),
               each("GSL ellint_RJ", "peer",
                    [=](std::size_t i) {
                      return gsl_sf_ellint_RJ(a->x[i], a->y[i], a->z[i], a->p[i], GSL_PREC_DOUBLE);
                    }),
               each("this edition", "ours",
                    [=](std::size_t i) { return elliptic::R_J(a->x[i], a->y[i], a->z[i], a->p[i]); })};
  return s;
}

// The closed form of Case II through somebody's R_J and R_D.
template <class RJ, class RD>
double separatrix_by(RJ rj, RD rd, double r, double omega)
{
  const double v = std::cos(omega), s = std::sin(omega);
  const double q = 1 + 4 * r * r * v * v, B = 2 * r * (std::hypot(r, 1.0) + r);
  const double X = (1 + B * s * s) / (1 + B), Z = 1 + B * v * v;
  return k
         * (std::asinh(v / (s * std::sqrt(q)))
            + 4 * r * r * v * v * v / 3 * (rj(1.0, X, Z, q) + rd(X, Z, 1.0)));
}

Scene to_the_top(double ratio)
{
  const auto w = std::make_shared<std::vector<double>>(powers_of_ten(5, many, -8, std::log10(1.5)));
  const double r = ratio;
  Scene s{fmt::format("time to the top, c = {:.3g} k", r),
          "τ of Case II to the angle 2ω from the top, ω from 1e-8 to 1.5",
          "ulp",
          many,
          {},
          {}};
  s.exact = exactly(500, [=](std::size_t i) { return separatrix_time<Fifty>(r * k, k, (*w)[i]); });
  s.methods = {
      each("the closed form by Boost in double", "peer",
           [=](std::size_t i) {
             return separatrix_by(
                 [](double x, double y, double z, double p) {
                   return boost::math::ellint_rj(x, y, z, p, DoubleOnly());
                 },
                 [](double x, double y, double z) { return boost::math::ellint_rd(x, y, z, DoubleOnly()); },
                 r, (*w)[i]);
           }),
      each("the closed form by GSL", "peer",
           [=](std::size_t i) {
             return separatrix_by(
                 [](double x, double y, double z, double p) {
                   return gsl_sf_ellint_RJ(x, y, z, p, GSL_PREC_DOUBLE);
                 },
                 [](double x, double y, double z) { return gsl_sf_ellint_RD(x, y, z, GSL_PREC_DOUBLE); }, r,
                 (*w)[i]);
           }),
      each("the closed form by ours", "ours",
           [=](std::size_t i) { return separatrix_time_by_carlson(r * k, k, (*w)[i]); }),
      {"this edition, an array", "ours",
       [=](std::span<double> out) { separatrix_time(r * k, k, *w, out); }},
      each("this edition", "ours", [=](std::size_t i) { return separatrix_time(r * k, k, (*w)[i]); })};
  return s;
}

// Energies as what is missing to the top.
std::shared_ptr<std::vector<Energy<double>>> energies(bool near_top)
{
  auto e = std::make_shared<std::vector<Energy<double>>>();
  for(const double below : near_top ? powers_of_ten(6, many, -15, -3) : uniform(6, many, 0.01, 1))
    e->push_back(energy_from_top(below));
  return e;
}

Energy<Fifty> exact_energy(const Energy<double>& e)
{
  return {1 - Fifty(e.from_top), e.from_top};
}

Scene rolling_quarter(bool near_top)
{
  const auto e = energies(near_top);
  Scene s{near_top ? "rolling near the top" : "rolling",
          near_top ? "τ of a quarter period, 1 − h from 1e-15 to 1e-3"
                   : "τ of a quarter period, h uniform in (0, 0.99)",
          "ulp",
          many,
          {},
          {}};
  // with the ball's numbers as doubles, which is what all are given
  const Ball<Fifty> as_given{ball.a, ball.c, ball.k};
  s.exact = exactly(2000, [=](std::size_t i) { return rolling::quarter(as_given, exact_energy((*e)[i])); });
  const double b2 = bb(ball), b = std::sqrt(b2), ac4 = 4 * ball.a * ball.c;
  s.methods = {
      each("the formula by Boost in double", "peer",
           [=](std::size_t i) {
             const auto& [h, below] = (*e)[i];
             const double q = ac4 * h / b2;
             return b
                    * (boost::math::ellint_rf(0.0, below, 1 + q, DoubleOnly())
                       + q / 3 * boost::math::ellint_rj(0.0, below, 1 + q, 1.0, DoubleOnly()));
           }),
      each("the formula by GSL", "peer",
           [=](std::size_t i) {
             const auto& [h, below] = (*e)[i];
             const double q = ac4 * h / b2;
             return b
                    * (gsl_sf_ellint_RF(0.0, below, 1 + q, GSL_PREC_DOUBLE)
                       + q / 3 * gsl_sf_ellint_RJ(0.0, below, 1 + q, 1.0, GSL_PREC_DOUBLE));
           }),
      each("Legendre's Π by Boost in double", "peer",
           [=](std::size_t i) {
             const double h = (*e)[i].h, D = b2 + ac4 * h;
             return b2 / std::sqrt(D)
                    * boost::math::ellint_3(std::sqrt(h * BB(ball) / D), ac4 * h / D, DoubleOnly());
           }),
      each("this edition", "ours", [=](std::size_t i) { return rolling::quarter(ball, (*e)[i]); })};
  return s;
}

Scene rolling_time()
{
  const auto e = energies(false);
  const auto at = std::make_shared<std::vector<Place<double>>>();
  const std::vector<double> part = uniform(7, many, 0.01, 0.99);
  for(std::size_t i = 0; i < many; ++i)
    at->push_back(place(2 * std::asin(std::sqrt((*e)[i].h)) * part[i]));
  Scene s{"rolling to a place",
          "τ to an angle, h uniform in (0, 0.99), the angle a part of the amplitude",
          "ulp",
          many,
          {},
          {}};
  const Ball<Fifty> as_given{ball.a, ball.c, ball.k};
  s.exact = exactly(1000, [=](std::size_t i) {
    const Fifty sine = (*at)[i].s;
    return rolling::time(as_given, exact_energy((*e)[i]), {sine, sqrt(1 - sine * sine)});
  });
  const double b2 = bb(ball), b = std::sqrt(b2), ac4 = 4 * ball.a * ball.c;
  s.methods = {
      each("the formula by Boost in double", "peer",
           [=](std::size_t i) {
             const double ss = (*at)[i].s * (*at)[i].s, tt = (*at)[i].c * (*at)[i].c;
             const auto& [h, below] = (*e)[i];
             const double x = (h - ss) / h, q = ac4 * ss / b2;
             return b * (*at)[i].s / std::sqrt(h)
                    * (boost::math::ellint_rf(x, tt, 1 + q, DoubleOnly())
                       + q / 3 * boost::math::ellint_rj(x, tt, 1 + q, 1.0, DoubleOnly()));
           }),
      each("this edition", "ours", [=](std::size_t i) { return rolling::time(ball, (*e)[i], (*at)[i]); })};
  return s;
}

// The integrand of §13, with sin ½Φ = √h sin θ.
double smooth_integrand(const Energy<double>& e, double theta)
{
  const double s = std::sin(theta), t = std::cos(theta);
  const double ss = e.h * s * s, tt = e.from_top + e.h * t * t;
  return std::sqrt((k * k + 4 * c * c * ss * tt) / tt);
}

Scene smooth_quarter(bool near_top)
{
  constexpr std::size_t few = 2000;
  const auto e = energies(near_top);
  Scene s{near_top ? "smooth plane near the top" : "smooth plane",
          near_top ? "τ of a quarter period, 1 − h from 1e-15 to 1e-3"
                   : "τ of a quarter period, h uniform in (0, 0.99)",
          "ulp",
          few,
          {},
          {}};
  s.exact = exactly(60, [=](std::size_t i) { return smooth::quarter<Fifty>(c, k, exact_energy((*e)[i])); });
  const auto rule = std::make_shared<boost::math::quadrature::tanh_sinh<double>>();
  const std::shared_ptr<gsl_integration_workspace> space{gsl_integration_workspace_alloc(1000),
                                                         &gsl_integration_workspace_free};
  gsl_set_error_handler_off();
  s.methods = {
      each("Boost tanh_sinh", "peer",
           [=](std::size_t i) {
             return rule->integrate([&](double theta) { return smooth_integrand((*e)[i], theta); }, 0.0,
                                    std::numbers::pi / 2);
           }),
      each("GSL qags", "peer",
           [=](std::size_t i) {
             gsl_function f{[](double theta, void* energy) {
                              return smooth_integrand(*static_cast<const Energy<double>*>(energy), theta);
                            },
                            const_cast<Energy<double>*>(&(*e)[i])};
             double value = 0, error = 0;
             gsl_integration_qags(&f, 0, std::numbers::pi / 2, 0, 2e-14, 1000, space.get(), &value, &error);
             return value;
           }),
      each("this edition", "ours", [=](std::size_t i) { return smooth::quarter(c, k, (*e)[i]); })};
  return s;
}

// The way of a cradle let go at 1 rad with μ = 1/5, by GSL: events by halving the step.
double event_by_gsl(double tolerance, int which)
{
  struct Now
  {
    double lambda;  // 2: rolling
  } now{0.2};
  static const Ball<double> b = cradle<double>;
  static const double g = cradle_g<double>;
  const auto right = [](double, const double y[], double dy[], void* p) {
    const double lambda = static_cast<Now*>(p)->lambda, cosine = std::cos(y[0]), sine = std::sin(y[0]);
    dy[0] = y[1];
    if(lambda == 2)
    {
      dy[1] = -sine * (2 * g * b.c + b.a * b.c * y[1] * y[1]) / (bb(b) + 2 * b.a * b.c * (1 - cosine));
      dy[2] = 0;
      return static_cast<int>(GSL_SUCCESS);
    }
    const double q = lambda * (b.a - b.c * cosine) - b.c * sine, M = b.k * b.k - b.c * q * sine;
    const double bearing = (2 * g + b.c * y[1] * y[1] * cosine) / M;
    dy[1] = q * bearing;
    dy[2] = -lambda * b.k * b.k * bearing + b.c * dy[1] * cosine - b.c * y[1] * y[1] * sine - b.a * dy[1];
    return static_cast<int>(GSL_SUCCESS);
  };
  gsl_odeiv2_system system{right, nullptr, 3, &now};
  const std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)> step{
      gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 3), &gsl_odeiv2_step_free};
  const std::unique_ptr<gsl_odeiv2_control, decltype(&gsl_odeiv2_control_free)> control{
      gsl_odeiv2_control_y_new(tolerance, 0), &gsl_odeiv2_control_free};
  const std::unique_ptr<gsl_odeiv2_evolve, decltype(&gsl_odeiv2_evolve_free)> evolve{
      gsl_odeiv2_evolve_alloc(3), &gsl_odeiv2_evolve_free};
  // What is left before the stretch ends.
  const auto left = [&](const double y[]) {
    const double cosine = std::cos(y[0]), sine = std::sin(y[0]), ww = y[1] * y[1];
    if(now.lambda != 2)
      return now.lambda > 0 ? y[2] : -y[2];
    const double turning = -sine * (2 * g * b.c + b.a * b.c * ww) / (bb(b) + 2 * b.a * b.c * (1 - cosine));
    const double friction = (b.c * turning * cosine - b.c * ww * sine - b.a * turning) / (2 * g);
    const double bearing = 1 + (b.c * turning * sine + b.c * ww * cosine) / (2 * g);
    return 0.2 * bearing - std::abs(friction);
  };
  double t = 0, y[3] = {1, 0, 0}, h = 1e-3;
  for(int events = 0;;)
  {
    double before = t, y0[3] = {y[0], y[1], y[2]}, tried = h;
    gsl_odeiv2_evolve_apply(evolve.get(), control.get(), step.get(), &system, &t, 100, &h, y);
    tried = t - before;
    if(left(y) >= 0 || tried < 1e-9)
      continue;
    double low = 0, high = tried, there[3], error[3];
    for(int i = 0; i < 50; ++i)
    {
      const double middle = (low + high) / 2;
      std::copy(y0, y0 + 3, there);
      gsl_odeiv2_step_reset(step.get());
      gsl_odeiv2_step_apply(step.get(), before, middle, there, error, nullptr, nullptr, &system);
      (left(there) < 0 ? high : low) = middle;
    }
    t = before + high;
    std::copy(there, there + 3, y);
    if(++events == which)
      return t;
    if(now.lambda != 2)
      now.lambda = 2, y[2] = 0;
    else
      now.lambda = y[0] > 0 ? 0.2 : -0.2;
    gsl_odeiv2_evolve_reset(evolve.get());
    h = 1e-3;
  }
}

Scene way()
{
  Scene s{
      "way with friction",
      "the time of the seventh change from scraping to rolling or back, cradle, μ = 1/5, let go at 1 rad",
      "ulp",
      1,
      {},
      {}};
  const Path<Fifty> exact(cradle<Fifty>, cradle_g<Fifty>, Fifty(0.2), {0, 0, 1, 0}, 11, 7);
  s.exact = {exact.events()[7].t};
  for(const double tolerance : {1e-10, 1e-12, 1e-15})
    s.methods.push_back(each(fmt::format("GSL rk8pd, {:.0e}, events by halving", tolerance), "peer",
                             [=](std::size_t) { return event_by_gsl(tolerance, 7); }));
  s.methods.push_back(each("this edition", "ours", [](std::size_t) {
    const Path<double> path(cradle<double>, cradle_g<double>, 0.2, {0, 0, 1, 0}, 11, 7);
    return path.events()[7].t;
  }));
  return s;
}

}  // namespace

std::vector<Lazy> all_scenes()
{
  std::vector<Lazy> scenes{{"R_F", first_kind}, {"R_D", second_kind}, {"R_J", third_kind}};
  for(const double r : {1.0 / 6, 0.5, 1.0, 1.2, 1.5})
    scenes.push_back({"time to the top", [r] { return to_the_top(r); }});
  scenes.push_back({"rolling", [] { return rolling_quarter(false); }});
  scenes.push_back({"rolling near the top", [] { return rolling_quarter(true); }});
  scenes.push_back({"rolling to a place", rolling_time});
  scenes.push_back({"smooth plane", [] { return smooth_quarter(false); }});
  scenes.push_back({"smooth plane near the top", [] { return smooth_quarter(true); }});
  scenes.push_back({"way with friction", way});
  return scenes;
}

Error judge(const Scene& scene, std::span<const double> out)
{
  Error e;
  e.judged = scene.exact.size();
  for(std::size_t i = 0; i < e.judged; ++i)
  {
    if(!std::isfinite(out[i]))
    {
      ++e.failures;
      continue;
    }
    const double ulps = exact::ulps(out[i], scene.exact[i]);
    e.worst = std::max(e.worst, ulps);
    e.mean += ulps;
  }
  e.mean /= static_cast<double>(e.judged - e.failures);
  return e;
}

}  // namespace bench
