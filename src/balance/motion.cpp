#include "balance/motion.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "balance/systems.hpp"
#include "exact/ode.hpp"

namespace balance
{
namespace
{

using exact::Fifty;

/// The state as integrators want it, six numbers in a row: angles, then rates.
template <class Number>
std::array<Number, 6> row(const State<Number>& s)
{
  return {s.at.omega, s.at.eta, s.at.theta, s.rate.omega, s.rate.eta, s.rate.theta};
}

template <class Row>
auto state(const Row& y) -> State<std::remove_cvref_t<decltype(y[0])>>
{
  return {{y[0], y[1], y[2]}, {y[3], y[4], y[5]}};
}

int right_side(double, const double y[], double dydt[], void* balance)
{
  const State<> now{{y[0], y[1], y[2]}, {y[3], y[4], y[5]}};
  const auto a = row(State<>{now.rate, accelerations(*static_cast<const Balance<>*>(balance), now)});
  std::copy(a.begin(), a.end(), dydt);
  return GSL_SUCCESS;
}

bool all_finite(const State<>& s)
{
  const auto y = row(s);
  return std::all_of(y.begin(), y.end(), [](double x) { return std::isfinite(x); });
}

/// The same balance, unless it or the start is impossible.
const Balance<>& checked(const Balance<>& b, const State<>& start)
{
  const bool possible = b.mu2 > 0 && b.beta > 0 && b.rho >= 0 && b.rho < 0.5 && std::isfinite(b.lambda2)
                        && std::isfinite(b.mu2) && std::isfinite(b.beta) && all_finite(start);
  if(!possible)
    throw std::domain_error("no such motion: allowed are μ² > 0, β > 0, 0 ≤ ρ < ½ and finite numbers");
  return b;
}

collocation::Moment<3> moment(const State<>& s)
{
  return {{s.at.omega, s.at.eta, s.at.theta}, {s.rate.omega, s.rate.eta, s.rate.theta}};
}

/// The greatest of the frequencies and the rates, 1/s.
double fastest(const Balance<>& b, const State<>& start)
{
  const double still = std::sqrt(std::max(b.mu2, std::abs(b.lambda2)));
  return std::max(
      {still, std::abs(start.rate.omega), std::abs(start.rate.eta), std::abs(start.rate.theta)});
}

/// State and its rate of change, which have the same six numbers.
State<> step(const State<>& from, const State<>& slope, double h)
{
  auto y = row(from);
  const auto k = row(slope);
  for(std::size_t i = 0; i < y.size(); ++i)
    y[i] += h * k[i];
  return state(y);
}

}  // namespace

struct Motion::Inner
{
  Balance<> b;
  double start_energy;
  State<> now;
  collocation::Motion<systems::Fixed> motion;

  Inner(const Balance<>& balance, const State<>& start, double tolerance)
      : b(checked(balance, start)), start_energy(energy(balance, start)), now(start),
        motion({b.lambda2, b.mu2, b.beta, b.rho}, moment(start), {tolerance, 0.125 / fastest(b, start)},
               systems::best().fixed)
  {
  }
};

Motion::Motion(const Balance<>& b, const State<>& start, double tolerance)
    : inner_(std::make_unique<Inner>(b, start, tolerance))
{
}
Motion::~Motion() = default;
Motion::Motion(Motion&&) noexcept = default;
Motion& Motion::operator=(Motion&&) noexcept = default;

const State<>& Motion::to(double t)
{
  const auto at = inner_->motion.to(t);
  return inner_->now = {{at.x[0], at.x[1], at.x[2]}, {at.v[0], at.v[1], at.v[2]}};
}

double Motion::energy_drift() const
{
  const double change = std::abs(energy(inner_->b, inner_->now) - inner_->start_energy);
  return inner_->start_energy == 0 ? change : change / std::abs(inner_->start_energy);
}

const collocation::Effort& Motion::effort() const
{
  return inner_->motion.effort();
}

State<> by_gsl(const Balance<>& b, const State<>& start, double t, double tolerance)
{
  Balance<> of = checked(b, start);
  if(!(tolerance >= 1e-15 && tolerance <= 0.1 && std::isfinite(t) && t >= 0))
    throw std::domain_error("allowed are tolerances from 1e-15 to 0.1 and times from 0");
  gsl_odeiv2_system system{right_side, nullptr, 6, &of};
  const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver{
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 0.01 / std::sqrt(b.mu2), tolerance,
                                    tolerance),
      gsl_odeiv2_driver_free};
  if(!driver)
    throw std::bad_alloc();
  auto y = row(start);
  double from = 0;
  const int status = gsl_odeiv2_driver_apply(driver.get(), &from, t, y.data());
  if(status != GSL_SUCCESS)
    throw std::runtime_error(std::string("the motion cannot be carried on: ") + gsl_strerror(status));
  return state(y);
}

std::vector<State<>> course(const Balance<>& b, const State<>& start, double until, int parts)
{
  Motion motion(b, start);
  std::vector<State<>> states;
  for(int k = 0; k <= parts; ++k)
    states.push_back(motion.to(until * k / parts));
  return states;
}

double parting(const Balance<>& b, const State<>& start, double t)
{
  const double slight = 1e-9;
  State<> beside = start;
  beside.at.omega += slight;
  beside.at.eta += slight;
  beside.at.theta += slight;
  Motion one(b, start), other(b, beside);
  double most = 1;
  for(int k = 1; k <= 100; ++k)
  {
    const Angles<>& x = one.to(t * k / 100).at;
    const Angles<>& y = other.to(t * k / 100).at;
    most = std::max({most, std::abs(x.omega - y.omega) / slight, std::abs(x.eta - y.eta) / slight,
                     std::abs(x.theta - y.theta) / slight});
  }
  return most;
}

double sure_until(const Balance<>& b, const State<>& start, double until, double most)
{
  while(parting(b, start, until) > most)
    until /= 2;
  return until;
}

State<> runge_kutta(const Balance<>& b, const State<>& start, double t, int steps)
{
  if(steps < 1)
    throw std::invalid_argument("a motion needs at least one step");
  const double h = t / steps;
  const auto slope = [&b](const State<>& s) { return State<>{s.rate, accelerations(b, s)}; };
  State<> now = start;
  for(int i = 0; i < steps; ++i)
  {
    const State<> k1 = slope(now);
    const State<> k2 = slope(step(now, k1, h / 2));
    const State<> k3 = slope(step(now, k2, h / 2));
    const State<> k4 = slope(step(now, k3, h));
    now = step(step(step(step(now, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
  }
  return now;
}

// The sines and cosines of the three angles are carried on with them, s′ = cω and c′ = −sω: of all that the equations ask
// for they take the most time in fifty digits.
State<Fifty> oracle(const Balance<>& b, const State<>& start, double t)
{
  constexpr std::size_t angles = systems::Fixed::angles, sines = 2 * angles, cosines = 3 * angles;
  const Balance<Fifty> widened{b.lambda2, b.mu2, b.beta, b.rho};
  const auto slope = [&widened](const Fifty& now, const exact::State& y) {
    const Fifty *const x = y.data(), *const v = x + angles;
    exact::State rates(y.size());
    std::array<elementary::SineCosine<Fifty>, angles> turned;
    for(std::size_t i = 0; i < angles; ++i)
    {
      turned[i] = {y[sines + i], y[cosines + i]};
      rates[i] = v[i];
      rates[sines + i] = turned[i].cosine * v[i];
      rates[cosines + i] = -turned[i].sine * v[i];
    }
    systems::Fixed::accelerations(widened, now, x, turned.data(), v, rates.data() + angles);
    return rates;
  };
  const auto y = row(start);
  exact::State from(y.begin(), y.end());
  for(std::size_t i = 0; i < angles; ++i)
    from.push_back(sin(from[i]));
  for(std::size_t i = 0; i < angles; ++i)
    from.push_back(cos(from[i]));
  for(const char* tolerance : {"1e-20", "1e-27", "1e-34"})  // a wild motion magnifies what each step leaves
  {
    const exact::Solution at_end = exact::solve(slope, 0.0, from, t, Fifty(tolerance));
    if(at_end.error < Fifty("1e-18"))
      return state(at_end.y);
  }
  throw std::runtime_error("the motion is too wild to be followed to 18 digits");
}

}  // namespace balance
