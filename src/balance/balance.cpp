#include "balance/euler.hpp"

#include <stdexcept>

namespace balance
{
namespace
{

/// x(t) of x″ = −q2·x from x and v.
double free_swing(double q2, double x, double v, double t)
{
  const double q = std::sqrt(std::abs(q2));
  if(q2 < 0)
    return x * std::cosh(q * t) + v * (std::sinh(q * t) / q);
  return x * phase(Rate<double>{q}, t).cosine + v * t * sinc_of_half(Rate<double>{2 * q}, t);
}

}  // namespace

Balance<> numbers_of(const Instrument& x)
{
  const double inertia = x.M * (x.kk + x.c * x.c) + 2 * x.L * x.a * x.a;
  const Balance<> b{2 * x.g * x.M * x.c / inertia, 2 * x.g / x.b, x.a / x.b, x.L * x.a * x.a / inertia};
  const bool possible = x.a > 0 && x.b > 0 && x.M > 0 && x.g > 0;
  const bool solid = x.kk >= 0 && x.L >= 0 && x.kk + x.c * x.c > 0;
  const bool in_range = std::isfinite(b.lambda2 + b.mu2 + b.beta + b.rho) && b.mu2 > 0 && b.beta > 0;
  if(!possible || !solid || !in_range)
    throw std::domain_error("no such balance: a, b, M, g, kk + cc must be positive, kk and L not negative");
  return b;
}

Angles<> small_motion(const Balance<>& b, const State<>& start, double t)
{
  return {free_swing(b.lambda2, start.at.omega, start.rate.omega, t),
          free_swing(b.mu2, start.at.eta, start.rate.eta, t),
          free_swing(b.mu2, start.at.theta, start.rate.theta, t)};
}

double driven(double q, double p, double t)
{
  return driven_by(together(q, p), together(q, -p), t);
}

Angles<> second_order(const Balance<>& b, const Angles<>& released, double t)
{
  return second_order_of(std::sqrt(b.lambda2), std::sqrt(b.mu2), b.beta, b.rho, released, t);
}

}  // namespace balance
