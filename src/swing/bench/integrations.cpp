#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>

#include "swing/motion.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"
#include "ways.hpp"

namespace bench
{
namespace
{

using exact::Fifty;
namespace oracle = swing::oracle;

// The quarter period as an integral, over Φ as it stands and over the angle that makes it smooth.
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
          "the quarter period as an integral",
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
  add("arithmetic-geometric mean", "classic",
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

void add_integrations(std::vector<Scene>& scenes)
{
  for(double zeta : {10.0, 90.0, 170.0, 179.9})
    scenes.push_back(quadrature(
        "ζ = " + std::string(zeta == 179.9 ? "179.9" : std::to_string(static_cast<int>(zeta))) + "°",
        swing::Amplitude::from_zeta(zeta * degree)));
  scenes.push_back(quadrature("η = 10⁻⁶", swing::Amplitude::from_eta(1e-6)));
  scenes.push_back(integration("ζ = 90°", 90 * degree));
  scenes.push_back(integration("ζ = 179°", 179 * degree));
}

}  // namespace bench
