#include "globe/clock.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "elliptic/carlson.hpp"

namespace globe
{
namespace
{

using exact::Fifty;

// The υ at which a pendulum that just reaches the top is 10⁻³⁰⁰ from it.
constexpr double latest = 690;

swing::Amplitude amplitude(const Energy<double>& e)
{
  return e.h <= 0.5 ? swing::Amplitude::from_height(2 * e.h) : swing::Amplitude::from_depth(2 * e.from_top);
}

swing::Motion motion(const Energy<double>& e)
{
  require(e);
  return e.turns_over() ? swing::Motion::revolving(-e.from_top) : swing::Motion(amplitude(e));
}

}  // namespace

double pendulum_quarter(const Energy<double>& e)
{
  if(e.turns_over())
    return swing::K_from_complement(std::sqrt(-e.from_top / e.h)) / std::sqrt(e.h);
  return swing::K_from_complement(std::sqrt(e.from_top));
}

Fifty pendulum_quarter(const Energy<Fifty>& e)
{
  if(e.turns_over())
    return elliptic::R_F<Fifty>(0, -e.from_top / e.h, 1) / sqrt(e.h);
  return elliptic::R_F<Fifty>(0, e.from_top, 1);
}

double pendulum_excess(const Energy<double>& e)
{
  return swing::ratio_excess(amplitude(e));
}

template <class Real>
Pendulum_place<Real> pendulum_place(const Energy<Real>& e, const Place<Real>& place)
{
  using std::asinh, std::max, std::min, std::sqrt;
  require(e);
  const Real tt = place.c * place.c;
  const Real left = left_for_motion(e, place);
  if(e.turns_over())
    return {place.s, place.c, place.s / sqrt(e.h) * elliptic::R_F(Real(left / e.h), tt, Real(1))};
  if(place.s == 0)
    return {0, 1, 0};
  if(!(left >= -8 * std::numeric_limits<double>::epsilon() * min(e.h, tt)))
    throw std::domain_error("the ball does not get there");
  if(e.from_top == 0)
    return {place.s, place.c, asinh(place.s / place.c), place.c == 0};
  const Real sn = place.s / sqrt(e.h);
  const Real cn2 = max(Real(left / e.h), Real(0));
  return {sn, sqrt(cn2), sn * elliptic::R_F(cn2, tt, Real(1))};
}

template Pendulum_place<double> pendulum_place(const Energy<double>&, const Place<double>&);
template Pendulum_place<Fifty> pendulum_place(const Energy<Fifty>&, const Place<Fifty>&);

Clock::Clock(const Energy<double>& e) : e_(e), motion_(motion(e)), quarter_(pendulum_quarter(e)) {}

Clock::Reading Clock::reading(double upsilon) const
{
  const double Phi = motion_.angle(upsilon), psi = motion_.angle_from_top(upsilon);
  const Place<double> place{std::sin(Phi / 2), std::sin(psi / 2)};
  if(e_.turns_over())
    return {upsilon, place, place.s, place.c};
  const double greatest = std::sqrt(e_.h);
  // cn by the velocity, or near the top by the height, whichever keeps more digits.
  const double by_velocity = std::max(motion_.velocity(upsilon) / (2 * greatest), 0.0);
  const double tt = place.c * place.c;
  const double cn = tt < by_velocity ? std::sqrt((tt - e_.from_top) / e_.h) : by_velocity;
  return {upsilon, place, place.s / greatest, cn};
}

Turned Clock::at(double tau, double quarter, const std::function<Rate(const Reading&)>& rate) const
{
  const bool once = e_.from_top == 0;
  // How many whole turns or swings, and the time since the last lowest place, backwards where that is nearer.
  const double whole = once ? 0 : (e_.turns_over() ? 2 : 4) * quarter;
  const double left = once ? tau : std::remainder(tau, whole);
  const double turns = once ? 0 : std::round((tau - left) / whole);  // the same ones, at half a turn too
  if(!(std::abs(turns) < 1e9) || (once && !(std::abs(tau) < rate(reading(latest)).time)))
    throw std::domain_error("so late the place can no longer be told");
  double ahead = std::abs(left);
  const bool falling = !once && !e_.turns_over() && ahead > quarter;  // a ball that rocks, on its way back
  if(falling)
    ahead = 2 * quarter - ahead;

  double low = 0, high = once ? latest : quarter_;
  double upsilon = once ? std::min(ahead / rate(reading(0)).derivative, latest)
                        : std::min(ahead / quarter, 1.0) * quarter_;
  for(int step = 0; step < 60; ++step)
  {
    const Rate now = rate(reading(upsilon));
    const double missing = ahead - now.time;
    (missing > 0 ? low : high) = upsilon;
    double next = upsilon + missing / now.derivative;
    if(!(next >= low && next <= high))
      next = (low + high) / 2;
    const bool done = std::abs(next - upsilon) <= 1e-16 * upsilon;
    upsilon = next;
    if(done)
      break;
  }
  const double sign = std::signbit(left) ? -1 : 1;
  const double Phi = motion_.angle(upsilon), from_top = motion_.angle_from_top(upsilon);
  const double turned = e_.turns_over() ? 2 * std::numbers::pi * turns : 0;
  return {turned + sign * Phi, from_top};
}

}  // namespace globe
