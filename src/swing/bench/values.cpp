#include <cmath>
#include <numbers>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_ellint.h>

#include "libraries.hpp"
#include "published.hpp"
#include "swing/kernels.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"
#include "ways.hpp"

namespace bench
{
namespace
{

using exact::Fifty;
namespace oracle = swing::oracle;

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

// The supplement's three members (§29) with α = ½η: ln cot ½α times four terms of the series, and two with
// ln 2.
double euler_supplement(double eta)
{
  const double s = std::sin(eta / 2);
  const double c = std::cos(eta / 2);
  const double x = s * s;
  const double series = 1 + x * (1.0 / 4 + x * (9.0 / 64 + x * (25.0 / 256)));
  return -std::log(std::tan(eta / 4)) * series + c * std::numbers::ln2 * (1 + 3 * x / 4);
}

template <class Function>
void add_series(Scene& scene, Function k2_of, double scale)
{
  for(int terms : {3, 6, 12, 24})
    scene.methods.push_back(each("Euler's series, " + std::to_string(terms) + " terms", "Euler",
                                 [=](double x) { return scale * euler_series(k2_of(x), terms); }));
}

// What the peers are given, from what a scene gives: k, kc and m₁ = kc².
struct By_modulus
{
  static constexpr const char* of = "";
  static double k(double x) { return x; }
  static double kc(double x) { return std::sqrt(m1(x)); }
  static double m1(double x) { return (1 - x) * (1 + x); }
};
struct By_complement
{
  static constexpr const char* of = " of √(1 − kc²)";
  static double k(double x) { return std::sqrt((1 - x) * (1 + x)); }
  static double kc(double x) { return x; }
  static double m1(double x) { return x * x; }
};
struct By_amplitude
{
  static constexpr const char* of = " of sin ½ζ";
  static double k(double x) { return std::sin(x / 2); }
  static double kc(double x) { return std::cos(x / 2); }
  static double m1(double x)
  {
    const double c = std::cos(x / 2);
    return c * c;
  }
};

// The published methods, which take m₁.
template <class Given>
void add_published(Scene& s, double scale)
{
  s.methods.push_back(each("method of Cephes", "peer",
                           [=](double x) { return scale * published::K_in_one_piece(Given::m1(x)); }));
  s.methods.push_back(each("method of Fukushima (2009)", "peer",
                           [=](double x) { return scale * published::K_by_polynomials(Given::m1(x)); }));
  s.methods.push_back(each("method of Fukushima (2015)", "peer",
                           [=](double x) { return scale * published::K_by_quotients(Given::m1(x)); }));
}

template <class Given>
void add_boost(Scene& s, double scale)
{
  const std::string of = Given::of;
  s.methods.push_back(each("Boost ellint_1" + of, "peer", [=](double x) {
    return scale * boost::math::ellint_1(Given::k(x), Promoting());
  }));
  s.methods.push_back(each("Boost ellint_1 in double" + of, "peer", [=](double x) {
    return scale * boost::math::ellint_1(Given::k(x), DoubleOnly());
  }));
}

template <class Given>
void add_peers(Scene& s, double scale)
{
  add_published<Given>(s, scale);
  for(const libraries::K_way& way : libraries::K_ways())
    s.methods.push_back(
        each(way.name, "peer", [=, K = way.K](double x) { return scale * K(Given::k(x), Given::kc(x)); }));
  add_boost<Given>(s, scale);
  const std::string of = Given::of;
  s.methods.push_back(
      each("GSL ellint_Kcomp" + of, "peer", [=](double x) { return scale * gsl_K(Given::k(x)); }));
  s.methods.push_back(each("std::comp_ellint_1" + of, "peer",
                           [=](double x) { return scale * std::comp_ellint_1(Given::k(x)); }));
}

Scene new_scene(const std::string& name, const std::string& quantity, std::vector<double> in)
{
  return {name, quantity, "ulp", "method of Cephes", std::move(in), {}, 0, {}};
}

Scene K_by_modulus(const std::string& name, const std::string& quantity, std::vector<double> in)
{
  Scene s = new_scene(name, quantity, std::move(in));
  s.exact = exactly(s.in, [](double k) { return oracle::K(k); });
  s.methods.push_back(each("this edition", "ours", [](double k) { return swing::K(k); }));
  add_peers<By_modulus>(s, 1);
  s.methods.push_back(each("arithmetic-geometric mean", "classic", [](double k) {
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

Scene K_by_complement(const std::string& name, const std::string& quantity, std::vector<double> in)
{
  Scene s = new_scene(name, quantity, std::move(in));
  s.exact = exactly(s.in, [](double kc) { return oracle::K_from_complement(kc); });
  s.methods.push_back(each("this edition", "ours", [](double kc) { return swing::K_from_complement(kc); }));
  add_peers<By_complement>(s, 1);
  s.methods.push_back(each("arithmetic-geometric mean", "classic",
                           [](double kc) { return std::numbers::pi / 2 / swing::agm(1, kc); }));
  s.methods.push_back(each("Boost ellint_rf", "peer", [](double kc) {
    return boost::math::ellint_rf(0.0, kc * kc, 1.0, Promoting());
  }));
  s.methods.push_back(each("GSL ellint_RF", "peer", [](double kc) { return gsl_rf(0, kc * kc, 1); }));
  s.methods.push_back(
      each("Euler's supplement", "Euler", [](double kc) { return euler_supplement(2 * std::asin(kc)); }));
  return s;
}

Scene period()
{
  Scene s = new_scene("period from ζ", "T/Θ for ζ uniform in (0, π)", uniform(5, many, 0, swing::pi_hi));
  s.exact = exactly(s.in, [](double zeta) { return oracle::ratio_from_top(exact::pi() - Fifty(zeta)); });
  s.methods.push_back(
      each("this edition", "ours", [](double zeta) { return swing::ratio_from_bottom(zeta); }));
  add_peers<By_amplitude>(s, 2 / std::numbers::pi);
  s.methods.push_back(each("arithmetic-geometric mean", "classic",
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

// The same question with a cold cache, put to the quickest.
Scene with_cold_cache(Scene s)
{
  std::erase_if(s.methods, [](const Method& m) {
    return m.name != "this edition" && !m.name.starts_with("method of")
           && !m.name.starts_with("Boost ellint_1");
  });
  s.name += " with a cold cache";
  s.quantity += ", each call after 4 MB of other memory";
  s.cold = true;
  return s;
}

Method over_arrays(std::size_t variant, swing::kernels::Table::Loop swing::kernels::Table::*loop)
{
  const swing::kernels::Table& table = swing::kernels::variant(variant);
  return {std::string("this edition, ") + table.name, "ours",
          [&table, loop](std::span<const double> in, std::span<double> out) {
            (table.*loop)(in.data(), out.data(), in.size());
          }};
}

Scene K_arrays()
{
  Scene s = new_scene("K over arrays", "K(k) for 10⁵ moduli k = sin ½ζ, ζ uniform",
                      uniform(6, many, 0, swing::pi_hi));
  for(double& x : s.in)
    x = std::sin(x / 2);
  s.exact = exactly(s.in, [](double k) { return oracle::K(k); });
  add_published<By_modulus>(s, 1);
  add_boost<By_modulus>(s, 1);
  s.methods.push_back(each("this edition, one by one", "ours", [](double k) { return swing::K(k); }));
  for(std::size_t v = 0; v < swing::kernels::count(); ++v)
    s.methods.push_back(over_arrays(v, &swing::kernels::Table::K));
  return s;
}

Scene period_arrays()
{
  Scene s = new_scene("period over arrays", "T/Θ for 10⁵ amplitudes, ζ uniform",
                      uniform(7, many, 0, swing::pi_hi));
  s.exact = exactly(s.in, [](double zeta) { return oracle::ratio_from_top(exact::pi() - Fifty(zeta)); });
  add_published<By_amplitude>(s, 2 / std::numbers::pi);
  add_boost<By_amplitude>(s, 2 / std::numbers::pi);
  s.methods.push_back(
      each("this edition, one by one", "ours", [](double zeta) { return swing::ratio_from_bottom(zeta); }));
  for(std::size_t v = 0; v < swing::kernels::count(); ++v)
    s.methods.push_back(over_arrays(v, &swing::kernels::Table::ratio));
  return s;
}

}  // namespace

void add_values(std::vector<Scene>& scenes)
{
  std::vector<double> near_one = logarithmic(2, many, 53);
  for(double& k : near_one)
    k = 1 - k;
  const Scene uniformly = K_by_modulus("K by modulus", "K(k), k uniform in (0, 1)", uniform(1, many, 0, 1));
  const Scene near = K_by_modulus("K by modulus near 1", "K(k), 1 − k logarithmically uniform down to 2⁻⁵³",
                                  std::move(near_one));
  const Scene complement =
      K_by_complement("K by complement", "K from kc = sin ½η, kc logarithmically uniform in (2⁻⁴⁰, 1)",
                      logarithmic(3, many, 40));
  const Scene from_zeta = period();
  scenes.insert(scenes.end(), {uniformly, with_cold_cache(uniformly), near, with_cold_cache(near),
                               complement, with_cold_cache(complement)});
  scenes.push_back(K_by_complement("K by tiny complement",
                                   "K from kc, kc logarithmically uniform down to 2⁻⁹⁹⁶ = 1.5·10⁻³⁰⁰",
                                   logarithmic(4, many, 996)));
  scenes.insert(scenes.end(), {from_zeta, with_cold_cache(from_zeta), K_arrays(), period_arrays()});
}

}  // namespace bench
