#include "balance/instrument.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace balance
{

Quantities quantities_of(const Instrument& x)
{
  const Balance<> b = numbers_of(x);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const double inertia = x.M * (x.kk + x.c * x.c) + 2 * x.L * x.a * x.a;
  // λ² may be too small for a double where λ is not
  const bool tiny = std::abs(x.c) < 0x1p-500;
  // the roots are taken one by one: 2gMc and the inertia may each be too great or too small where λ is not
  const double scaled =
      std::sqrt(2 * x.g * (std::abs(x.c) * (tiny ? 0x1p500 : 1))) * (std::sqrt(x.M) / std::sqrt(inertia));
  const double rate = scaled * (tiny ? 0x1p-250 : 1);
  const bool stands = x.c >= 0;
  const double mu = std::sqrt(b.mu2);
  Quantities q{};
  q.f = x.c == 0 ? std::numeric_limits<double>::infinity() : inertia / x.M / x.c;
  q.lambda = stands ? rate : nan;
  q.kappa = x.c <= 0 ? rate : nan;
  q.mu = mu;
  q.beam_time = stands ? std::numbers::pi / rate : nan;
  q.pan_time = std::numbers::pi / mu;
  q.i = stands ? b.beta / 2 * rate : nan;
  q.beta = b.beta;
  q.rho = b.rho;
  return q;
}

Balance<exact::Fifty> widened(const Instrument& x)
{
  numbers_of(x);
  const exact::Fifty G = 2 * exact::Fifty(x.g), M = x.M, Laa = exact::Fifty(x.L) * x.a * x.a;
  const exact::Fifty inertia = M * (exact::Fifty(x.kk) + exact::Fifty(x.c) * x.c) + 2 * Laa;
  return {G * M * x.c / inertia, G / x.b, exact::Fifty(x.a) / x.b, Laa / inertia};
}

Least least_f(const Instrument& x)
{
  numbers_of(x);
  const double c = std::hypot(std::sqrt(x.kk), x.a * std::sqrt(2 * x.L / x.M));
  return {c, 2 * c};
}

double slower_coefficient(const Quantities& q)
{
  return q.i / (2 * q.mu - q.lambda);
}

double tilt(const Instrument& x, double overweight)
{
  numbers_of(x);
  if(!(x.c >= 0 && overweight > 0 && std::isfinite(overweight)))
    throw std::domain_error("no tilt: c must not be negative, the overweight positive");
  return elementary::atan2(overweight * x.a, x.M * x.c);
}

Five five_equations(const Instrument& x, const State<>& now)
{
  numbers_of(x);
  const auto& [at, rate] = now;
  const bool finite = std::isfinite(at.omega + at.eta + at.theta + rate.omega + rate.eta + rate.theta);
  if(!(x.L > 0 && finite))
    throw std::domain_error("no such state: the pans must weigh something, the angles and rates be finite");
  using exact::Fifty;
  const auto [wide, speed] = widened(now);
  const Fifty so = sin(wide.omega), co = cos(wide.omega), se = sin(wide.eta), ce = cos(wide.eta),
              st = sin(wide.theta), ct = cos(wide.theta), o2 = speed.omega * speed.omega,
              e2 = speed.eta * speed.eta, t2 = speed.theta * speed.theta;
  const Fifty G = 2 * Fifty(x.g), a = x.a, b = x.b, La = G * x.L * a,
              inertia = Fifty(x.M) * (Fifty(x.kk) + Fifty(x.c) * x.c), none = 0;
  // columns: ω̈, η̈, ϑ̈, P/L, Q/L, right side; rows I to V, the second differentials of §6's coordinates put in
  std::array<std::array<Fifty, 6>, 5> m{{
      {-a * so, b * ce, none, G * se, none, a * co * o2 + b * se * e2},
      {-a * co, -b * se, none, G * ce, none, G - a * so * o2 + b * ce * e2},
      {-a * so, none, -b * ct, none, -G * st, a * co * o2 - b * st * t2},
      {a * co, none, -b * st, none, G * ct, G + a * so * o2 + b * ct * t2},
      {inertia, none, none, La * cos(wide.omega - wide.eta), -La * cos(wide.theta - wide.omega),
       -G * x.M * x.c * so},
  }};
  for(std::size_t i = 0; i < 5; ++i)
  {
    std::size_t pivot = i;
    for(std::size_t r = i; r < 5; ++r)
      if(abs(m[r][i]) > abs(m[pivot][i]))
        pivot = r;
    std::swap(m[i], m[pivot]);
    for(std::size_t r = 0; r < 5; ++r)
      if(r != i)
      {
        const Fifty by = m[r][i] / m[i][i];
        for(std::size_t k = i; k < 6; ++k)
          m[r][k] -= by * m[i][k];
      }
  }
  const auto u = [&m](std::size_t i) { return static_cast<double>(m[i][5] / m[i][i]); };
  return {{u(0), u(1), u(2)}, {u(3), u(4)}};
}

}  // namespace balance
