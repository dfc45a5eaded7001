#include <cmath>
#include <functional>

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_elljac.h>

#include "published.hpp"
#include "swing/motion.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"
#include "ways.hpp"

namespace bench
{
namespace
{

using exact::Fifty;
using published::Doubling;
using swing::kernels::Question;
namespace kernels = swing::kernels;
namespace oracle = swing::oracle;

// sn, cn and dn, by each of the peers.
using Functions = Doubling::Functions;

template <class Policy>
struct By_boost
{
  double k;
  Functions operator()(double t) const
  {
    Functions f{};
    f.sn = boost::math::jacobi_elliptic(k, t, &f.cn, &f.dn, Policy());
    return f;
  }
};

struct By_gsl
{
  double k;
  Functions operator()(double t) const
  {
    Functions f{};
    const int status = gsl_sf_elljac_e(t, k * k, &f.sn, &f.cn, &f.dn);
    f.dn = gsl_value(status, f.dn);
    f.cn = gsl_value(status, f.cn);
    return f;
  }
};

struct As_published
{
  double k;
  double kc;
  Functions operator()(double t) const { return Doubling::as_published(k, kc)(t); }
};

// What is asked of the motion, from the three functions: Φ = 2 arctan(k sn/dn), the best that can be made
// of them, Φ' = 2k cn, and what Φ lacks of π.
template <Question asked>
double answer(double k, const Functions& f)
{
  if constexpr(asked == kernels::angle)
    return 2 * std::atan2(k * f.sn, f.dn);
  else if constexpr(asked == kernels::velocity)
    return 2 * k * f.cn;
  else
    return 2 * std::atan2(f.dn, std::fabs(k * f.sn));
}

template <Question asked, class Way>
Method by(const std::string& name, double k, Way way)
{
  return each(name, "peer", [=](double t) { return answer<asked>(k, way(t)); });
}

template <Question asked>
void add_peers(Scene& s, const swing::Amplitude& a)
{
  const double k = a.modulus();
  const double kc = a.complement();
  s.methods.push_back(by<asked>("method of Fukushima (2012)", k, As_published{k, kc}));
  s.methods.push_back(
      by<asked>("method of Fukushima (2012), prepared", k, Doubling(k, kc, swing::quarter_time(a))));
  s.methods.push_back(by<asked>("GSL elljac_e", k, By_gsl{k}));
  s.methods.push_back(by<asked>("Boost jacobi_elliptic", k, By_boost<Promoting>{k}));
  s.methods.push_back(by<asked>("Boost jacobi_elliptic in double", k, By_boost<DoubleOnly>{k}));
}

// An amplitude, as both take it.
struct Swing
{
  std::string name;
  swing::Amplitude a;
  oracle::Motion exact;
};

Swing from_zeta(const std::string& name, double zeta)
{
  return {name, swing::Amplitude::from_zeta(zeta), oracle::Motion::from_zeta(zeta)};
}
Swing from_eta(const std::string& name, double eta)
{
  return {name, swing::Amplitude::from_eta(eta), oracle::Motion::from_eta(eta)};
}

Fifty exact_answer(const oracle::Motion& m, Question asked, double t)
{
  return asked == kernels::angle      ? m.angle(t)
         : asked == kernels::velocity ? m.velocity(t)
                                      : m.angle_from_top(t);
}

template <Question asked>
double one_answer(const swing::Motion& m, double t)
{
  if constexpr(asked == kernels::angle)
    return m.angle(t);
  else if constexpr(asked == kernels::velocity)
    return m.velocity(t);
  else
    return m.angle_from_top(t);
}

constexpr std::size_t judged_motions = 300;

template <Question asked>
Scene motion_scene(const std::string& group, const std::string& quantity, const Swing& w,
                   double periods = 0)
{
  const swing::Motion m(w.a);
  Scene s{group + ", " + w.name,
          quantity + " at 10⁵ random times",
          "",
          "method of Fukushima (2012)",
          {},
          {},
          0,
          {}};
  s.in = uniform(8, many, 0, 100 * m.period());
  if(periods > 0)
  {
    s.quantity += " in one period, after 10⁶ periods";
    s.in = uniform(9, many, periods * m.period(), (periods + 1) * m.period());
  }
  s.unit = asked == kernels::angle ? "2⁻⁵² ζ" : asked == kernels::velocity ? "2⁻⁵² of the greatest" : "ulp";
  s.place = asked == kernels::angle ? w.a.zeta : asked == kernels::velocity ? 2 * w.a.modulus() : 0;
  for(std::size_t i = 0; i < judged_motions; ++i)
    s.exact.push_back(exact_answer(w.exact, asked, s.in[i]));
  add_peers<asked>(s, w.a);
  s.methods.push_back(
      each("this edition, one by one", "ours", [m](double t) { return one_answer<asked>(m, t); }));
  for(std::size_t v = 0; v < kernels::count(); ++v)
  {
    const kernels::Table& table = kernels::variant(v);
    s.methods.push_back({std::string("this edition, ") + table.name, "ours",
                         [m, &table](std::span<const double> in, std::span<double> out) {
                           table.read(*m.rows(asked), in.data(), out.data(), in.size());
                         }});
  }
  return s;
}

// One time only: the edition makes a motion and its rows, the others compute what they need of the
// amplitude.
Scene once(const Swing& w)
{
  const double k = w.a.modulus();
  const double kc = w.a.complement();
  const double quarter = swing::quarter_time(w.a);
  Scene s{"Φ once, " + w.name,
          "Φ at one time, the amplitude not prepared",
          "2⁻⁵² ζ",
          "method of Fukushima (2012)",
          uniform(10, 100, 0, 4 * quarter),
          {},
          w.a.zeta,
          {}};
  for(double t : s.in)
    s.exact.push_back(w.exact.angle(t));
  s.methods.push_back(by<kernels::angle>("method of Fukushima (2012)", k, As_published{k, kc}));
  s.methods.push_back(by<kernels::angle>("GSL elljac_e", k, By_gsl{k}));
  s.methods.push_back(by<kernels::angle>("Boost jacobi_elliptic in double", k, By_boost<DoubleOnly>{k}));
  s.methods.push_back(
      each("this edition, with rows", "ours", [a = w.a](double t) { return swing::Motion(a).angle(t); }));
  s.methods.push_back(each("this edition, computed directly", "ours", [a = w.a](double t) {
    const swing::Motion m(a);
    double angle = 0;
    kernels::variant(0).direct[m.course()][kernels::angle](m.prepared(), &t, &angle, 1);
    return angle;
  }));
  return s;
}

}  // namespace

void add_motions(std::vector<Scene>& scenes)
{
  const Swing tiny = from_zeta("ζ = 10⁻⁴", 1e-4);
  const Swing ten = from_zeta("ζ = 10°", 10 * degree);
  const Swing right = from_zeta("ζ = 90°", 90 * degree);
  const Swing high = from_zeta("ζ = 150°", 150 * degree);
  const Swing higher = from_zeta("ζ = 179°", 179 * degree);
  const Swing near = from_eta("η = 10⁻⁴", 1e-4);
  const Swing nearer = from_eta("η = 10⁻⁹", 1e-9);
  for(const Swing& w : {tiny, ten, right, high, higher, near, nearer})
    scenes.push_back(motion_scene<kernels::angle>("Φ(t)", "Φ", w));
  for(Swing w : {right, near})
  {
    w.name += ", after 10⁶ periods";
    scenes.push_back(motion_scene<kernels::angle>("Φ(t)", "Φ", w, 1e6));
  }
  for(const Swing& w : {ten, high, near})
    scenes.push_back(motion_scene<kernels::velocity>("velocity", "Φ'", w));
  for(const Swing& w : {ten, high, near})
    scenes.push_back(motion_scene<kernels::from_top>("from the top", "the angle from the top", w));
  for(const Swing& w : {ten, right, high, near, nearer})
    scenes.push_back(once(w));
}

}  // namespace bench
