#include "balance/instrument.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <Eigen/LU>

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
  using elementary::cos;
  using elementary::sin;
  const auto [so, co] = elementary::sincos(at.omega);
  const auto [se, ce] = elementary::sincos(at.eta);
  const auto [st, ct] = elementary::sincos(at.theta);
  const double G = 2 * x.g, a = x.a, b = x.b;
  const double o2 = rate.omega * rate.omega, e2 = rate.eta * rate.eta, t2 = rate.theta * rate.theta;
  // columns: ω̈, η̈, ϑ̈, P/L, Q/L; rows I to V, the second differentials of §6's coordinates put in
  Eigen::Matrix<double, 5, 5> A;
  Eigen::Matrix<double, 5, 1> right;
  A << -a * so, b * ce, 0, G * se, 0,   //
      -a * co, -b * se, 0, G * ce, 0,   //
      -a * so, 0, -b * ct, 0, -G * st,  //
      a * co, 0, -b * st, 0, G * ct,    //
      x.M * (x.kk + x.c * x.c), 0, 0, G * x.L * a * cos(at.omega - at.eta),
      -G * x.L * a * cos(at.theta - at.omega);
  right << a * co * o2 + b * se * e2, G - a * so * o2 + b * ce * e2, a * co * o2 - b * st * t2,
      G + a * so * o2 + b * ct * t2, -G * x.M * x.c * so;
  const Eigen::Matrix<double, 5, 1> u = A.partialPivLu().solve(right);
  return {{u[0], u[1], u[2]}, {u[3], u[4]}};
}

}  // namespace balance
