#include "balance/balance.hpp"

#include <stdexcept>

namespace balance
{
namespace
{

double sinc(double x)
{
  return x == 0 ? 1 : std::sin(x) / x;
}

/// x(t) of x″ = −q2·x from x and v.
double free_swing(double q2, double x, double v, double t)
{
  const double q = std::sqrt(std::abs(q2));
  if(q2 < 0)
    return x * std::cosh(q * t) + v * (std::sinh(q * t) / q);
  return x * std::cos(q * t) + v * t * sinc(q * t);
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
  return t * t / 2 * sinc((q + p) * t / 2) * sinc((q - p) * t / 2);
}

Angles<> second_order(const Balance<>& b, const Angles<>& released, double t)
{
  const auto& [m, n, n1] = released;
  const double lambda = std::sqrt(b.lambda2);
  const double mu = std::sqrt(b.mu2);
  const auto sidebands = [&](double q) { return driven(q, mu - lambda, t) + driven(q, mu + lambda, t); };
  const double product = b.beta * b.lambda2 * m / 2 * sidebands(mu);          // from −βηω̈
  const double arc = b.beta * b.lambda2 * m * m * driven(mu, 2 * lambda, t);  // from β(½ω²)″
  const double turned = b.mu2 * m * (n - n1) / 2 * sidebands(lambda);         // from ω(η̈ − ϑ̈)
  const double pulled = b.mu2 * (n * n - n1 * n1) * driven(lambda, 2 * mu, t);  // from −½(η² − ϑ²)″
  return {m * std::cos(lambda * t) + b.rho / b.beta * (pulled - turned),
          n * std::cos(mu * t) + n * product - arc, n1 * std::cos(mu * t) - n1 * product + arc};
}

}  // namespace balance
