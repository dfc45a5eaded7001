#include "globe/smooth.hpp"

#include <limits>
#include <stdexcept>

#include "elliptic/carlson.hpp"
#include "globe/clock.hpp"
#include "globe/graded.hpp"
#include "globe/halves.hpp"

namespace globe::smooth
{
namespace
{

using exact::Fifty;

template <class Real>
constexpr bool is_double = std::is_same_v<Real, double>;

template <class Real>
void require_ball(const Real& c, const Real& k)
{
  if(!(c >= 0 && k > 0 && c <= 1e9 * k))
    throw std::domain_error("the ball needs k > 0 and 0 ≤ c ≤ 10⁹ k");
}

// What the time exceeds kυ by, as far as the pendulum's sn and cn go; its modulus is √h, or 1/√h.
template <class Real>
Real rest(const Real& c, const Real& k, const Energy<Real>& e, const Real& sn, const Real& cn)
{
  using std::abs, std::max, std::min, std::sqrt;
  if(c == 0)
    return 0;
  const Real own = k / (2 * c);  // as near come the zeros of the root to either end
  const Real distance = sqrt(Real(abs(e.from_top)) / max(e.h, Real(1)));
  // A kink narrower than this does not show.
  const Real narrowest = is_double<Real> ? 1e-10 : 1e-30;
  const Real at_top = e.from_top == 0 ? own : min(own, max(distance, narrowest));
  const auto factor = [&](const Real& w, const Real& y) {
    return Real(4 * c * c * w / (k + sqrt(k * k + 4 * c * c * w * y)));
  };
  if(e.turns_over())
    return integrate_over_angle(
        [&](const Real& s, const Real& t) {
          const Real y = t * t;
          return Real(factor(Real(s * s), y) * y / sqrt(y - e.from_top));
        },
        sn, cn, own, at_top);
  return integrate_over_angle(
      [&](const Real& s, const Real& t) {
        const Real y = e.from_top + e.h * t * t;
        return Real(factor(Real(e.h * s * s), y) * sqrt(y));
      },
      sn, cn, own, at_top);
}

// The mean over the quarter of what is made of cc sin²Φ/kk; NaN where the mesh would have to be too fine.
template <class Function>
double mean_of(const Function& made, double c, double k, const Energy<double>& e)
{
  const double q = 4 * (c / k) * (c / k);
  if(e.turns_over())
    return mean_over_quarter(-e.from_top / e.h,
                             [&](double s2, double c2, double) { return made(q * s2 * c2); });
  const double p = q * e.h;
  return mean_over_quarter(e.from_top, [&](double s2, double, double d2) { return made(p * s2 * d2); });
}

}  // namespace

template <class Real>
Real quarter(const Real& c, const Real& k, const Energy<Real>& e)
{
  using std::sqrt;
  require_ball(c, k);
  require(e);
  if(e.from_top == 0)
    return std::numeric_limits<double>::infinity();
  if constexpr(is_double<Real>)
    if(c <= 3 * k && std::abs(e.from_top) > 1e-15)
    {
      const double mean = mean_of([](double x) { return std::sqrt(1 + x); }, c, k, e);
      if(mean >= 1)
        return k * pendulum_quarter(e) * mean;
    }
  return k * pendulum_quarter(e) + rest(c, k, e, Real(1), Real(0));
}

double excess(double c, double k, const Energy<double>& e)
{
  require_ball(c, k);
  require(e);
  if(!(e.from_top > 0 && c <= 100 * k))
    throw std::domain_error("the excess is of a ball that rocks, with c ≤ 100 k");
  const double of_pendulum = pendulum_excess(e), mean = mean_of(root_excess, c, k, e);
  const double of_ball = mean >= 0 ? mean : rest(c, k, e, 1., 0.) / (k * pendulum_quarter(e));
  return of_pendulum + of_ball + of_pendulum * of_ball;
}

template <class Real>
Real time(const Real& c, const Real& k, const Energy<Real>& e, const Place<Real>& place)
{
  require_ball(c, k);
  const Pendulum_place<Real> at = pendulum_place(e, place);
  if(at.never)
    return std::numeric_limits<double>::infinity();
  return k * at.upsilon + rest(c, k, e, at.sn, at.cn);
}

Turned angle(double c, double k, const Energy<double>& e, double tau)
{
  require_ball(c, k);
  const double whole = quarter(c, k, e);
  return Clock(e).at(tau, whole, [&](const Clock::Reading& now) {
    const double sine = 2 * now.place.s * now.place.c;
    return Clock::Rate{k * now.upsilon + rest(c, k, e, now.sn, now.cn), std::hypot(k, c * sine)};
  });
}

void quarter(double c, double k, std::span<const Energy<double>> e, std::span<double> out)
{
  require_equal(e.size(), out.size());
  for(std::size_t i = 0; i < out.size(); ++i)
    out[i] = quarter(c, k, e[i]);
}

void time(double c, double k, const Energy<double>& e, std::span<const Place<double>> place,
          std::span<double> out)
{
  require_equal(place.size(), out.size());
  for(std::size_t i = 0; i < out.size(); ++i)
    out[i] = time(c, k, e, place[i]);
}

void angle(double c, double k, const Energy<double>& e, std::span<const double> tau, std::span<Turned> out)
{
  require_equal(tau.size(), out.size());
  for(std::size_t i = 0; i < out.size(); ++i)
    out[i] = angle(c, k, e, tau[i]);
}

template <class Real>
Second_energy<Real> second_energy(const Real& c, const Real& k)
{
  using std::sqrt;
  if(!(c > 0 && k > 0))
    throw std::domain_error("the second energy needs c > 0 and k > 0");
  const Real r = k / c;
  const Real u = sqrt(1 + r * r);
  const Real kc = r / (u + 1), kc2 = kc * kc;
  const Real E = kc2 / 3 * (elliptic::R_D(Real(0), kc2, Real(1)) + elliptic::R_D(Real(0), Real(1), kc2));
  return {(1 + u) / 2, c * sqrt(2 * (u + 1)) * E};
}

template <class Real>
Real pressure(const Real& c, const Real& k, const Energy<Real>& e, const Place<Real>& place)
{
  const Real ss = place.s * place.s, tt = place.c * place.c;
  const Real moment = k * k + 4 * c * c * ss * tt;
  return k * k * (k * k + 4 * c * c * (tt * tt - e.from_top * (tt - ss))) / (moment * moment);
}

template <class Real>
Real velocity_squared(const Real& c, const Real& k, const Energy<Real>& e, const Place<Real>& place)
{
  const Real ss = place.s * place.s, tt = place.c * place.c;
  return 4 * left_for_motion(e, place) / (k * k + 4 * c * c * ss * tt);
}

template <class Real>
Real lift_off_energy(const Real& c, const Real& k)
{
  return 1 + k / c * (k / c) / 4;
}

template <class Real>
Lift_off<Real> lift_off(const Real& c, const Real& k, const Real& excess)
{
  using std::atan2, std::sqrt;
  using std::isfinite;
  if(!(c > 0 && k > 0 && excess > 0) || !isfinite(excess))
    throw std::domain_error("the ball leaves the plane with more energy than 1 + kk/4cc only");
  const Real quarter_kappa = k / c * (k / c) / 4;
  const Real q = 2 * (quarter_kappa + excess);
  const Real cosine = sqrt(2 * excess) / sqrt(sqrt(q * q + 4 * excess) + q);
  const Place<Real> there{sqrt((1 - cosine) * (1 + cosine)), cosine};
  const Energy<Real> e{1 + quarter_kappa + excess, -(quarter_kappa + excess)};
  return {2 * atan2(there.s, there.c), 2 * atan2(there.c, there.s), time(c, k, e, there),
          sqrt(velocity_squared(c, k, e, there))};
}

template <class Real>
Real anomaly(const Inequalities<Real>& e, const Real& M)
{
  using std::abs, std::cos, std::sin;
  if(!(e.e1 >= 0 && e.e2 >= 0 && e.e1 + 2 * e.e2 < 0.5))
    throw std::domain_error("the inequalities are too large to be small");
  Real Phi = M;
  for(int step = 0; step < 30; ++step)
  {
    const Real change = (M - (Phi - e.e1 * sin(Phi) - e.e2 * sin(2 * Phi)))
                        / (1 - e.e1 * cos(Phi) - 2 * e.e2 * cos(2 * Phi));
    const Real next = Phi + change;
    if(next == Phi)
      break;
    Phi = next;
  }
  return Phi;
}

#define GLOBE_SMOOTH(Real)                                                                                 \
  template Real quarter(const Real&, const Real&, const Energy<Real>&);                                    \
  template Real time(const Real&, const Real&, const Energy<Real>&, const Place<Real>&);                   \
  template Second_energy<Real> second_energy(const Real&, const Real&);                                    \
  template Real pressure(const Real&, const Real&, const Energy<Real>&, const Place<Real>&);               \
  template Real velocity_squared(const Real&, const Real&, const Energy<Real>&, const Place<Real>&);       \
  template Real lift_off_energy(const Real&, const Real&);                                                 \
  template Lift_off<Real> lift_off(const Real&, const Real&, const Real&);                                 \
  template Real anomaly(const Inequalities<Real>&, const Real&);
GLOBE_SMOOTH(double)
GLOBE_SMOOTH(Fifty)
#undef GLOBE_SMOOTH

}  // namespace globe::smooth
