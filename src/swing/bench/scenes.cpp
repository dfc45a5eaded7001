#include "scenes.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include <boost/math/policies/policy.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include "swing/motion.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

namespace bench
{
namespace
{

using exact::Fifty;
namespace oracle = swing::oracle;
namespace policies = boost::math::policies;

// Boost's own default, which computes in long double, and the one that stays in double.
// Where they fail they give an infinity or a NaN; what an exception costs is not counted against them.
using Overflow = policies::overflow_error<policies::ignore_error>;
using Domain = policies::domain_error<policies::ignore_error>;
using Promoting = policies::policy<policies::promote_double<true>, Overflow, Domain>;
using DoubleOnly = policies::policy<policies::promote_double<false>, Overflow, Domain>;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double degree = std::numbers::pi / 180;
constexpr std::size_t judged = 2000;
constexpr std::size_t many = 100000;

// A method from a function of one number; what it throws becomes NaN.
template <class Function>
Method each(std::string name, std::string kind, Function f)
{
  return {std::move(name), std::move(kind), [f](std::span<const double> in, std::span<double> out) {
            for(std::size_t i = 0; i < in.size(); ++i)
            {
              try
              {
                out[i] = f(in[i]);
              }
              catch(const std::exception&)
              {
                out[i] = not_a_number;
              }
            }
          }};
}

double gsl_value(int status, double value)
{
  return status == GSL_SUCCESS ? value : not_a_number;
}

double gsl_K(double k)
{
  gsl_sf_result r;
  const int status = gsl_sf_ellint_Kcomp_e(k, GSL_PREC_DOUBLE, &r);
  return gsl_value(status, r.val);
}

double gsl_rf(double x, double y, double z)
{
  gsl_sf_result r;
  const int status = gsl_sf_ellint_RF_e(x, y, z, GSL_PREC_DOUBLE, &r);
  return gsl_value(status, r.val);
}

std::vector<double> uniform(std::uint64_t seed, std::size_t n, double a, double b)
{
  std::mt19937_64 engine(seed);
  std::vector<double> x(n);
  for(double& y : x)
    y = a + (b - a) * std::ldexp(static_cast<double>(engine() >> 11), -53);
  return x;
}

// Uniform in the logarithm to base 2, by exact scaling alone so that the numbers are the same everywhere.
std::vector<double> logarithmic(std::uint64_t seed, std::size_t n, int octaves)
{
  std::mt19937_64 engine(seed);
  std::vector<double> x(n);
  for(double& y : x)
  {
    const double mantissa = 0.5 + std::ldexp(static_cast<double>(engine() >> 11), -54);
    y = std::ldexp(mantissa, -static_cast<int>(engine() % static_cast<std::uint64_t>(octaves)));
  }
  return x;
}

template <class Function>
std::vector<Fifty> exactly(const std::vector<double>& in, Function f)
{
  std::vector<Fifty> values;
  for(std::size_t i = 0; i < in.size() && i < judged; ++i)
    values.push_back(f(in[i]));
  return values;
}

// Σ aₙ² k²ⁿ, Euler's first series, cut off after so many terms.
double euler_series(double k2, int terms)
{
  double sum = 0;
  double a = 1;
  double power = 1;
  for(int n = 0; n < terms; ++n)
  {
    sum += a * a * power;
    a *= (2.0 * n + 1) / (2.0 * n + 2);
    power *= k2;
  }
  return sum;
}

// The supplement's three members (§29) with α = ½η: ln cot ½α times four terms of the series, and two with ln
// 2.
double euler_supplement(double eta)
{
  const double s = std::sin(eta / 2);
  const double c = std::cos(eta / 2);
  const double x = s * s;
  const double series = 1 + x * (1.0 / 4 + x * (9.0 / 64 + x * (25.0 / 256)));
  return -std::log(std::tan(eta / 4)) * series + c * std::numbers::ln2 * (1 + 3 * x / 4);
}

void add_series(Scene& scene, const std::function<double(double)>& k2_of, double scale)
{
  for(int terms : {3, 6, 12, 24})
    scene.methods.push_back(each("Euler's series, " + std::to_string(terms) + " terms", "Euler",
                                 [=](double x) { return scale * euler_series(k2_of(x), terms); }));
}

Method array(const std::string& name, std::size_t variant,
             swing::kernels::Table::Loop swing::kernels::Table::*loop)
{
  const swing::kernels::Table& table = swing::kernels::variant(variant);
  return {name + ", " + table.name, "ours",
          [&table, loop](std::span<const double> in, std::span<double> out) {
            (table.*loop)(in.data(), out.data(), in.size());
          }};
}

void add_K_peers(Scene& scene, const std::function<double(double)>& k_of, const std::string& of,
                 double scale)
{
  scene.methods.push_back(each("Boost ellint_1" + of, "peer", [=](double x) {
    return scale * boost::math::ellint_1(k_of(x), Promoting());
  }));
  scene.methods.push_back(each("Boost ellint_1 in double" + of, "peer", [=](double x) {
    return scale * boost::math::ellint_1(k_of(x), DoubleOnly());
  }));
  scene.methods.push_back(
      each("GSL ellint_Kcomp" + of, "peer", [=](double x) { return scale * gsl_K(k_of(x)); }));
  scene.methods.push_back(each("std::comp_ellint_1" + of, "peer",
                               [=](double x) { return scale * std::comp_ellint_1(k_of(x)); }));
}

Scene K_by_modulus()
{
  Scene s{"K by modulus",
          "K(k), k uniform in (0, 1)",
          "ulp",
          "Boost ellint_1",
          uniform(1, 4096, 0, 1),
          {},
          0,
          {}};
  s.exact = exactly(s.in, [](double k) { return oracle::K(k); });
  add_K_peers(
      s, [](double k) { return k; }, "", 1);
  s.methods.push_back(each("this edition", "ours", [](double k) { return swing::K(k); }));
  s.methods.push_back(each("arithmetic–geometric mean", "classic", [](double k) {
    return std::numbers::pi / 2 / swing::agm(1, std::sqrt((1 - k) * (1 + k)));
  }));
  s.methods.push_back(each("Boost ellint_rf", "peer", [](double k) {
    return boost::math::ellint_rf(0.0, (1 - k) * (1 + k), 1.0, Promoting());
  }));
  s.methods.push_back(
      each("GSL ellint_RF", "peer", [](double k) { return gsl_rf(0, (1 - k) * (1 + k), 1); }));
  add_series(
      s, [](double k) { return k * k; }, std::numbers::pi / 2);
  return s;
}

Scene K_near_one()
{
  Scene s = K_by_modulus();
  s.name = "K by modulus near 1";
  s.quantity = "K(k), 1 − k logarithmically uniform down to 2⁻⁵³";
  s.in = logarithmic(2, 4096, 53);
  for(double& k : s.in)
    k = 1 - k;
  s.exact = exactly(s.in, [](double k) { return oracle::K(k); });
  return s;
}

Scene K_by_complement()
{
  Scene s{"K by complement",
          "K from kc = sin ½η, kc logarithmically uniform in (2⁻⁴⁰, 1)",
          "ulp",
          "Boost ellint_1 of √(1 − kc²)",
          logarithmic(3, 4096, 40),
          {},
          0,
          {}};
  s.exact = exactly(s.in, [](double kc) { return oracle::K_from_complement(kc); });
  add_K_peers(
      s, [](double kc) { return std::sqrt((1 - kc) * (1 + kc)); }, " of √(1 − kc²)", 1);
  s.methods.push_back(each("this edition", "ours", [](double kc) { return swing::K_from_complement(kc); }));
  s.methods.push_back(each("arithmetic–geometric mean", "classic",
                           [](double kc) { return std::numbers::pi / 2 / swing::agm(1, kc); }));
  s.methods.push_back(each("Boost ellint_rf", "peer", [](double kc) {
    return boost::math::ellint_rf(0.0, kc * kc, 1.0, Promoting());
  }));
  s.methods.push_back(each("GSL ellint_RF", "peer", [](double kc) { return gsl_rf(0, kc * kc, 1); }));
  s.methods.push_back(
      each("Euler's supplement", "Euler", [](double kc) { return euler_supplement(2 * std::asin(kc)); }));
  return s;
}

Scene K_by_tiny_complement()
{
  Scene s = K_by_complement();
  s.name = "K by tiny complement";
  s.peer = "Boost ellint_rf";
  s.quantity = "K from kc, kc logarithmically uniform down to 2⁻⁹⁹⁶ = 1.5·10⁻³⁰⁰";
  s.in = logarithmic(4, 4096, 996);
  s.exact = exactly(s.in, [](double kc) { return oracle::K_from_complement(kc); });
  return s;
}

Scene period()
{
  Scene s{"period from ζ",
          "T/Θ, ζ uniform in (0, π)",
          "ulp",
          "Boost ellint_1 of sin ½ζ",
          uniform(5, 4096, 0, swing::pi_hi),
          {},
          0,
          {}};
  s.exact = exactly(s.in, [](double zeta) { return oracle::ratio_from_top(exact::pi() - Fifty(zeta)); });
  constexpr double scale = 2 / std::numbers::pi;
  add_K_peers(
      s, [](double zeta) { return std::sin(zeta / 2); }, " of sin ½ζ", scale);
  s.methods.push_back(
      each("this edition", "ours", [](double zeta) { return swing::ratio_from_bottom(zeta); }));
  s.methods.push_back(each("arithmetic–geometric mean", "classic",
                           [](double zeta) { return 1 / swing::agm(1, std::cos(zeta / 2)); }));
  s.methods.push_back(each("Euler's sagitta rule", "Euler", [](double zeta) {
    const double c = std::sin(zeta / 2);
    return 1 + c * c / 4;
  }));
  add_series(
      s,
      [](double zeta) {
        const double c = std::sin(zeta / 2);
        return c * c;
      },
      1);
  s.methods.push_back(each("Euler's supplement", "Euler", [](double zeta) {
    return 2 / std::numbers::pi * euler_supplement((swing::pi_hi - zeta) + swing::pi_lo);
  }));
  return s;
}

Scene K_arrays()
{
  Scene s{"K over arrays",
          "K(k) for 10⁵ moduli k = sin ½ζ, ζ uniform",
          "ulp",
          "Boost ellint_1",
          uniform(6, many, 0, swing::pi_hi),
          {},
          0,
          {}};
  for(double& x : s.in)
    x = std::sin(x / 2);
  s.exact = exactly(s.in, [](double k) { return oracle::K(k); });
  add_K_peers(
      s, [](double k) { return k; }, "", 1);
  s.methods.push_back(each("this edition, one by one", "ours", [](double k) { return swing::K(k); }));
  for(std::size_t v = 0; v < swing::kernels::count(); ++v)
    s.methods.push_back(array("this edition", v, &swing::kernels::Table::K));
  return s;
}

Scene period_arrays()
{
  Scene s{"period over arrays",
          "T/Θ for 10⁵ amplitudes, ζ uniform",
          "ulp",
          "Boost ellint_1 of sin ½ζ",
          uniform(7, many, 0, swing::pi_hi),
          {},
          0,
          {}};
  s.exact = exactly(s.in, [](double zeta) { return oracle::ratio_from_top(exact::pi() - Fifty(zeta)); });
  add_K_peers(
      s, [](double zeta) { return std::sin(zeta / 2); }, " of sin ½ζ", 2 / std::numbers::pi);
  s.methods.push_back(
      each("this edition, one by one", "ours", [](double zeta) { return swing::ratio_from_bottom(zeta); }));
  for(std::size_t v = 0; v < swing::kernels::count(); ++v)
    s.methods.push_back(array("this edition", v, &swing::kernels::Table::ratio));
  return s;
}

// 2 arctan(k sn/dn), the best that can be made of sn, cn and dn.
double angle_from(double k, double sn, double dn)
{
  return 2 * std::atan2(k * sn, dn);
}

template <class Policy>
double boost_angle(double k, double t)
{
  double cn;
  double dn;
  const double sn = boost::math::jacobi_elliptic(k, t, &cn, &dn, Policy());
  return angle_from(k, sn, dn);
}

double gsl_angle(double k, double t)
{
  double sn;
  double cn;
  double dn;
  const int status = gsl_sf_elljac_e(t, k * k, &sn, &cn, &dn);
  return gsl_value(status, angle_from(k, sn, dn));
}

Scene angle_scene(const std::string& name, swing::Amplitude a, const oracle::Motion& exact, double periods)
{
  const swing::Motion m(a);
  Scene s{"Φ(t), " + name,
          "Φ at 10⁵ random times",
          "2⁻⁵² ζ",
          "GSL elljac_e",
          uniform(8, many, 0, 100 * m.period()),
          {},
          a.zeta,
          {}};
  if(periods > 0)
  {
    s.quantity = "Φ at 10⁵ random times in one period, after 10⁶ periods";
    s.in = uniform(9, many, periods * m.period(), (periods + 1) * m.period());
  }
  s.exact.reserve(300);
  for(std::size_t i = 0; i < 300; ++i)
    s.exact.push_back(exact.angle(s.in[i]));
  const double k = a.modulus();
  s.methods.push_back(each("GSL elljac_e", "peer", [k](double t) { return gsl_angle(k, t); }));
  s.methods.push_back(
      each("Boost jacobi_elliptic", "peer", [k](double t) { return boost_angle<Promoting>(k, t); }));
  s.methods.push_back(each("Boost jacobi_elliptic in double", "peer",
                           [k](double t) { return boost_angle<DoubleOnly>(k, t); }));
  s.methods.push_back(each("this edition, one by one", "ours", [m](double t) { return m.angle(t); }));
  for(std::size_t v = 0; v < swing::kernels::count(); ++v)
  {
    const swing::kernels::Table& table = swing::kernels::variant(v);
    s.methods.push_back({std::string("this edition, ") + table.name, "ours",
                         [m, &table](std::span<const double> in, std::span<double> out) {
                           table.read(*m.rows(swing::kernels::angle), in.data(), out.data(), in.size());
                         }});
  }
  return s;
}

void add_angles(std::vector<Scene>& scenes)
{
  const auto from_zeta = [&](const std::string& name, double zeta, double periods = 0) {
    scenes.push_back(
        angle_scene(name, swing::Amplitude::from_zeta(zeta), oracle::Motion::from_zeta(zeta), periods));
  };
  const auto from_eta = [&](const std::string& name, double eta, double periods = 0) {
    scenes.push_back(
        angle_scene(name, swing::Amplitude::from_eta(eta), oracle::Motion::from_eta(eta), periods));
  };
  from_zeta("ζ = 10⁻⁴", 1e-4);
  from_zeta("ζ = 10°", 10 * degree);
  from_zeta("ζ = 90°", 90 * degree);
  from_zeta("ζ = 150°", 150 * degree);
  from_zeta("ζ = 179°", 179 * degree);
  from_eta("η = 10⁻⁴", 1e-4);
  from_eta("η = 10⁻⁹", 1e-9);
  from_zeta("ζ = 90°, after 10⁶ periods", 90 * degree, 1e6);
  from_eta("η = 10⁻⁴, after 10⁶ periods", 1e-4, 1e6);
}

// The quarter swing as an integral, over Φ as it stands and over the angle that makes it smooth.
struct Integrand
{
  double zeta;
  double k;
  double kc;

  double raw(double phi) const
  {
    return 1 / (2 * std::sqrt(std::sin((zeta - phi) / 2) * std::sin((zeta + phi) / 2)));
  }
  double smooth(double x) const
  {
    const double c = std::cos(x);
    const double s = std::sin(x);
    return 1 / std::sqrt(kc * kc * s * s + c * c);
  }
};

double trapezium(const Integrand& f, int panels)
{
  double sum = 0.5 * (f.smooth(0) + f.smooth(std::numbers::pi / 2));
  for(int i = 1; i < panels; ++i)
    sum += f.smooth(std::numbers::pi / 2 * i / panels);
  return std::numbers::pi / 2 / panels * sum;
}

// ∫₀^∞ ds/√(1 + kc² sinh² s): the integrand is flat up to ln(2/kc) and then falls as e⁻ˢ.
double trapezium_of_sinh(const Integrand& f)
{
  constexpr double step = 0.27;
  double sum = 0.5;
  for(int i = 1;; ++i)
  {
    const double t = f.kc * std::sinh(step * i);
    const double term = 1 / std::sqrt(1 + t * t);
    sum += term;
    if(term < 1e-17)
      return step * sum;
  }
}

extern "C" double raw_for_gsl(double phi, void* f)
{
  return static_cast<const Integrand*>(f)->raw(phi);
}
extern "C" double smooth_for_gsl(double x, void* f)
{
  return static_cast<const Integrand*>(f)->smooth(x);
}

class Workspace
{
public:
  Workspace() : w_(gsl_integration_workspace_alloc(1000)) {}
  ~Workspace() { gsl_integration_workspace_free(w_); }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  gsl_integration_workspace* get() const { return w_; }

private:
  gsl_integration_workspace* w_;
};

Scene quadrature(const std::string& name, swing::Amplitude a)
{
  Scene s{"quadrature, " + name,
          "the quarter swing as an integral",
          "ulp",
          "Boost tanh_sinh, product form",
          {a.zeta},
          {},
          0,
          {}};
  s.exact = {oracle::K_from_complement(sin(Fifty(a.eta) / Fifty(2)))};
  const Integrand f{a.zeta, a.modulus(), a.complement()};
  const double quarter_turn = std::numbers::pi / 2;
  const auto add = [&](const std::string& method, const std::string& kind, auto run) {
    s.methods.push_back(each(method, kind, [run](double) { return run(); }));
  };
  add("Boost tanh_sinh, product form", "peer", [f] {
    static boost::math::quadrature::tanh_sinh<double, Promoting> rule;
    return rule.integrate(
        [&](double, double to_end) {
          // to_end is Φ − 0 in the lower half (negative) and ζ − Φ in the upper.
          const double left = to_end > 0 ? to_end : f.zeta + to_end;
          return 1 / (2 * std::sqrt(std::sin(left / 2) * std::sin(f.zeta - left / 2)));
        },
        0.0, f.zeta, 1e-13);
  });
  add("Boost tanh_sinh, as it stands", "peer", [f] {
    static boost::math::quadrature::tanh_sinh<double, Promoting> rule;
    return rule.integrate([&](double phi) { return 1 / std::sqrt(2 * (std::cos(phi) - std::cos(f.zeta))); },
                          0.0, f.zeta, 1e-13);
  });
  add("Boost gauss_kronrod<31>, smooth", "peer", [f, quarter_turn] {
    return boost::math::quadrature::gauss_kronrod<double, 31, Promoting>::integrate(
        [&](double x) { return f.smooth(x); }, 0.0, quarter_turn, 15, 1e-13);
  });
  add("GSL qags, as it stands", "peer", [f] {
    static const Workspace w;
    Integrand g = f;
    gsl_function function{raw_for_gsl, &g};
    double value = 0;
    double error = 0;
    const int status = gsl_integration_qags(&function, 0, f.zeta, 0, 1e-12, 1000, w.get(), &value, &error);
    return gsl_value(status, value);
  });
  add("GSL qag61, smooth", "peer", [f, quarter_turn] {
    static const Workspace w;
    Integrand g = f;
    gsl_function function{smooth_for_gsl, &g};
    double value = 0;
    double error = 0;
    const int status = gsl_integration_qag(&function, 0, quarter_turn, 0, 1e-13, 1000, GSL_INTEG_GAUSS61,
                                           w.get(), &value, &error);
    return gsl_value(status, value);
  });
  for(int panels : {8, 16, 64})
    add("trapezium rule, " + std::to_string(panels) + " panels", "classic",
        [f, panels] { return trapezium(f, panels); });
  add("trapezium rule after sinh", "classic", [f] { return trapezium_of_sinh(f); });
  add("arithmetic–geometric mean", "classic",
      [f, quarter_turn] { return quarter_turn / swing::agm(1, f.kc); });
  add("this edition", "ours", [f] { return swing::K_from_complement(f.kc); });
  return s;
}

extern "C" int pendulum(double, const double y[], double dydt[], void*)
{
  dydt[0] = y[1];
  dydt[1] = -std::sin(y[0]);
  return GSL_SUCCESS;
}

// From the bottom to the time t in as many steps as the tolerance asks for.
double integrate(const gsl_odeiv2_step_type* type, double tolerance, double speed, double t_end)
{
  gsl_odeiv2_system system{pendulum, nullptr, 2, nullptr};
  gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&system, type, 1e-2, tolerance, tolerance);
  double t = 0;
  double y[2] = {0, speed};
  const int status = gsl_odeiv2_driver_apply(driver, &t, t_end, y);
  gsl_odeiv2_driver_free(driver);
  return gsl_value(status, y[0]);
}

Scene integration(const std::string& name, double zeta)
{
  const swing::Motion m(swing::Amplitude::from_zeta(zeta));
  Scene s{"integration, " + name,
          "Φ after 10.3 periods by integrating the equation of motion",
          "2⁻⁵² ζ",
          "GSL rk8pd, 1e-10",
          {10.3 * m.period()},
          {},
          zeta,
          {}};
  s.exact = {oracle::Motion::from_zeta(zeta).angle(s.in[0])};
  const double speed = m.velocity(0);
  const auto add = [&](const std::string& type_name, const gsl_odeiv2_step_type* type,
                       const char* tolerance) {
    const double bound = std::stod(tolerance);
    s.methods.push_back(each(type_name + ", " + tolerance, "peer",
                             [=](double end) { return integrate(type, bound, speed, end); }));
  };
  for(const char* tolerance : {"1e-6", "1e-8", "1e-10", "1e-12"})
    add("GSL rkf45", gsl_odeiv2_step_rkf45, tolerance);
  for(const char* tolerance : {"1e-6", "1e-8", "1e-10", "1e-12"})
    add("GSL rk8pd", gsl_odeiv2_step_rk8pd, tolerance);
  s.methods.push_back(each("this edition", "ours", [m](double t) { return m.angle(t); }));
  return s;
}

}  // namespace

std::vector<Scene> all_scenes()
{
  // GSL's own handler would end the program where a modulus rounds to 1; each call's status is looked at
  // instead.
  gsl_set_error_handler_off();
  std::vector<Scene> scenes{K_by_modulus(), K_near_one(), K_by_complement(), K_by_tiny_complement(),
                            period(),       K_arrays(),   period_arrays()};
  add_angles(scenes);
  for(double zeta : {10.0, 90.0, 170.0, 179.9})
    scenes.push_back(quadrature(
        "ζ = " + std::string(zeta == 179.9 ? "179.9" : std::to_string(static_cast<int>(zeta))) + "°",
        swing::Amplitude::from_zeta(zeta * degree)));
  scenes.push_back(quadrature("η = 10⁻⁶", swing::Amplitude::from_eta(1e-6)));
  scenes.push_back(integration("ζ = 90°", 90 * degree));
  scenes.push_back(integration("ζ = 179°", 179 * degree));
  return scenes;
}

Error judge(const Scene& scene, const Method& method)
{
  const std::size_t n = scene.exact.size();
  std::vector<double> out(n);
  method.run(std::span(scene.in).first(n), out);
  Error error;
  error.judged = n;
  double sum = 0;
  for(std::size_t i = 0; i < n; ++i)
  {
    if(!std::isfinite(out[i]))
    {
      ++error.failures;
      continue;
    }
    const double e =
        scene.place > 0 ? static_cast<double>(abs(Fifty(out[i]) - scene.exact[i])) / (scene.place * 0x1p-52)
                        : exact::ulps(out[i], scene.exact[i]);
    error.worst = std::fmax(error.worst, e);
    sum += e;
  }
  if(n > error.failures)
    error.mean = sum / static_cast<double>(n - error.failures);
  return error;
}

}  // namespace bench
