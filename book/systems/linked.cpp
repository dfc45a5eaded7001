/// @file
/// other-systems: the question that the page *Other systems* puts to every system, its answer to fifty digits,
/// and what the libraries say that the edition itself is linked with; and the true periods of what the physics
/// engines are given, with what the edition shows in their place. Prints JSON.
#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/version.hpp>
#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>
#include <gsl/gsl_version.h>
#include <nlohmann/json.hpp>

#include "exact/quadrature.hpp"
#include "globe/rolling.hpp"
#include "swing/motion.hpp"
#include "swing/oracle.hpp"

namespace
{

using Json = nlohmann::ordered_json;
using exact::Fifty;
using std::numbers::pi;

/// One of the three swings: the angle that is left to the top, and half of a quarter period.
struct Swing
{
  double eta;
  double u;
  double k = std::cos(eta / 2);
  double kc = std::sin(eta / 2);
};

std::vector<Swing> swings()
{
  std::vector<Swing> all;
  for(const double eta : {pi / 180, 1e-4, 1e-9})
    all.push_back({eta, static_cast<double>(swing::oracle::Motion::from_eta(eta).quarter() / Fifty(2))});
  return all;
}

/// What a library says, as text: a number with all its digits, or its complaint, without the place in its source.
std::string said(const std::function<double()>& call)
{
  try
  {
    return fmt::format("{:.17g}", call());
  }
  catch(const std::exception& error)
  {
    const std::string what = error.what();
    const auto place = what.rfind("): ");
    return "error: " + (place == std::string::npos ? what : what.substr(place + 3));
  }
}

/// GSL's way: a status beside the result.
double gsl(const std::function<int(gsl_sf_result*)>& call)
{
  gsl_sf_result result{};
  if(const int status = call(&result))
    throw std::runtime_error(gsl_strerror(status));
  return result.val;
}

Json way(const char* of, const char* call, const std::function<double(const Swing&)>& f)
{
  Json got = Json::array();
  for(const Swing& s : swings())
    got.push_back(said([&] { return f(s); }));
  return {{"of", of}, {"call", call}, {"got", got}};
}

Json of_gsl()
{
  const auto K = [](double k) {
    return gsl([k](gsl_sf_result* r) { return gsl_sf_ellint_Kcomp_e(k, GSL_PREC_DOUBLE, r); });
  };
  const auto jacobi = [](const Swing& s) {
    struct
    {
      double sn, cn, dn;
    } is{};
    if(const int status = gsl_sf_elljac_e(s.u, s.k * s.k, &is.sn, &is.cn, &is.dn))
      throw std::runtime_error(gsl_strerror(status));
    return is;
  };
  return {
      {"system", "GSL"},
      {"version", gsl_version},
      {"K",
       {{"call", "gsl_sf_ellint_Kcomp(k, mode)"},
        {"quarter", said([&] { return K(0.25); })},
        {"one", said([&] { return K(1); })},
        {"beyond", said([&] { return K(1.5); })}}},
      {"Pi", {{"call", "gsl_sf_ellint_Pcomp(k, n, mode)"}, {"quarter", said([] {
                                                              return gsl([](gsl_sf_result* r) {
                                                                return gsl_sf_ellint_Pcomp_e(
                                                                    0.25, 0.25, GSL_PREC_DOUBLE, r);
                                                              });
                                                            })}}},
      {"ways",
       {way("T", "2/π · gsl_sf_ellint_Kcomp(cos(η/2))", [&](const Swing& s) { return 2 / pi * K(s.k); }),
        way("T", "2/π · gsl_sf_ellint_RF(0, sin²(η/2), 1)",
            [](const Swing& s) {
              return 2 / pi * gsl([&](gsl_sf_result* r) {
                       return gsl_sf_ellint_RF_e(0, s.kc * s.kc, 1, GSL_PREC_DOUBLE, r);
                     });
            }),
        way("Phi", "2 asin(k·sn), gsl_sf_elljac_e(u, k², …)",
            [&](const Swing& s) { return 2 * std::asin(s.k * jacobi(s).sn); }),
        way("Phi", "2 atan2(k·sn, dn), gsl_sf_elljac_e(u, k², …)", [&](const Swing& s) {
          const auto is = jacobi(s);
          return 2 * std::atan2(s.k * is.sn, is.dn);
        })}}};
}

Json of_boost()
{
  namespace math = boost::math;
  return {
      {"system", "Boost.Math"},
      {"version", fmt::format("{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000)},
      {"K",
       {{"call", "ellint_1(k)"},
        {"quarter", said([] { return math::ellint_1(0.25); })},
        {"one", said([] { return math::ellint_1(1.0); })},
        {"beyond", said([] { return math::ellint_1(1.5); })}}},
      {"Pi", {{"call", "ellint_3(k, n)"}, {"quarter", said([] { return math::ellint_3(0.25, 0.25); })}}},
      {"ways",
       {way("T", "2/π · ellint_1(cos(η/2))", [](const Swing& s) { return 2 / pi * math::ellint_1(s.k); }),
        way("T", "2/π · ellint_rf(0, sin²(η/2), 1)",
            [](const Swing& s) { return 2 / pi * math::ellint_rf(0.0, s.kc * s.kc, 1.0); }),
        way("Phi", "2 asin(k·sn), jacobi_sn(k, u)",
            [](const Swing& s) { return 2 * std::asin(s.k * math::jacobi_sn(s.k, s.u)); }),
        way("Phi", "2 atan2(k·sn, dn), jacobi_elliptic(k, u, &cn, &dn)", [](const Swing& s) {
          double cn = 0;
          double dn = 0;
          const double sn = math::jacobi_elliptic(s.k, s.u, &cn, &dn);
          return 2 * std::atan2(s.k * sn, dn);
        })}}};
}

Json of_standard_library()
{
  return {{"system", "C++ standard library"},
          {"version", fmt::format("libstdc++ of GCC {}", _GLIBCXX_RELEASE)},
          {"K",
           {{"call", "std::comp_ellint_1(k)"},
            {"quarter", said([] { return std::comp_ellint_1(0.25); })},
            {"one", said([] { return std::comp_ellint_1(1.0); })},
            {"beyond", said([] { return std::comp_ellint_1(1.5); })}}},
          {"Pi", {{"call", "std::comp_ellint_3(k, n)"}, {"quarter", said([] {
                                                           return std::comp_ellint_3(0.25, 0.25);
                                                         })}}},
          {"ways", {way("T", "2/π · std::comp_ellint_1(cos(η/2))", [](const Swing& s) {
             return 2 / pi * std::comp_ellint_1(s.k);
           })}}};
}

/// The whole oscillation, in seconds, of a body of mass 1 with the moment of inertia I about its centre of
/// gravity, which is c below the middle of a ball of radius R that rolls on a plane (R = 0: c below a fixed axis),
/// from rest at theta0; g = 9.81. With sin ½θ = sin ½θ0 sin s the time is smooth in s.
Fifty oscillation(const Fifty& R, const Fifty& c, const Fifty& I, const Fifty& theta0)
{
  const Fifty gc = Fifty("9.81") * c;
  const auto time = [&](const Fifty& s) {
    const Fifty x = sin(theta0 / 2) * sin(s);  // sin ½θ
    return sqrt((I + (R - c) * (R - c) + 4 * R * c * x * x) / (gc * (1 - x * x)));
  };
  return 4 * exact::integrate(time, Fifty(0), exact::pi() / 2).value;
}

/// What a minute shows of a motion that starts from rest at theta0, looked at sixty times a second as the physics
/// engines are in findings/engines: the mean time of a whole oscillation between two passages of the lowest place, in
/// seconds, and the largest angle of the last five seconds, in degrees.
Json watched(const std::function<double(double)>& angle)
{
  const auto at = [&](int step) { return angle(step / 60.0); };
  double first = 0, last = 0, largest = 0;
  int times = 0;
  for(int i = 0; i < 3600; ++i)
  {
    const double before = at(i), now = at(i + 1);
    if(before > 0 && now <= 0)
    {
      last = (i + before / (before - now)) / 60;
      if(times++ == 0)
        first = last;
    }
    if(i >= 3300)
      largest = std::max(largest, std::abs(now));
  }
  return {{"period", (last - first) / (times - 1)}, {"amplitude", largest * 180 / pi}};
}

/// The pendulum (a point, at the length 1) and the loaded ball by the edition's own functions.
Json of_edition()
{
  const swing::Motion pendulum(swing::Amplitude::from_zeta(pi / 2), swing::Start::rest);
  const globe::Ball<double> ball{1, 0.5, std::sqrt(0.4)};
  const auto e = globe::energy_of_amplitude(1.2);
  const double quarter = globe::rolling::quarter(ball, e);
  return {{"bob", "0"},
          {"pendulum", watched([&](double t) { return pendulum.angle(t * std::sqrt(9.81)); })},
          {"ball", watched([&](double t) {
             return globe::rolling::angle(ball, e, quarter + t * std::sqrt(9.81 * 0.5)).Phi;
           })}};
}

Json of_engines()
{
  Json pendulum;
  for(const char* bob : {"0", "0.004", "0.005"})
    pendulum[bob] = oscillation(Fifty(0), Fifty(1), Fifty(bob), exact::pi() / 2).str(20);
  return {{"pendulum", pendulum},
          {"ball", oscillation(Fifty(1), Fifty("0.5"), Fifty("0.4"), Fifty("1.2")).str(20)},
          {"edition", of_edition()}};
}

}  // namespace

int main()
{
  gsl_set_error_handler_off();
  Json question = {
      {"eta", Json::array()}, {"u", Json::array()}, {"T", Json::array()}, {"Phi", Json::array()}};
  for(const Swing& s : swings())
  {
    question["eta"].push_back(fmt::format("{:.17g}", s.eta));
    question["u"].push_back(fmt::format("{:.17g}", s.u));
    question["T"].push_back(swing::oracle::ratio_from_top(s.eta).str(40));
    question["Phi"].push_back(swing::oracle::Motion::from_eta(s.eta).angle(s.u).str(40));
  }
  std::cout << Json{{"question", question},
                    {"systems", {of_gsl(), of_boost(), of_standard_library()}},
                    {"engines", of_engines()}}
                   .dump(2)
            << '\n';
}
