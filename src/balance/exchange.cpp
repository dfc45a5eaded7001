#include "balance/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "balance/motion.hpp"
#include "swing/time.hpp"

namespace balance
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

Averaged averaged(const Balance<>& b, double m)
{
  const double lambda = std::sqrt(b.lambda2), mu = std::sqrt(b.mu2);
  const double outer = (mu - 2 * lambda) * (mu + 2 * lambda), inner = (2 * mu - lambda) * (2 * mu + lambda);
  if(!(b.lambda2 > 0 && b.mu2 > 0 && outer != 0 && inner != 0 && std::isfinite(m)))
    throw std::domain_error("no average: λ² and μ² must be positive, λ neither 2μ nor ½μ");
  const double splitting = b.rho * b.mu2 * mu * m * m / (2 * outer);
  const double shift = -b.beta * b.beta * b.lambda2 * b.lambda2 * m * m / (4 * mu * inner);
  return {splitting, shift, splitting == 0 ? infinity : std::numbers::pi / std::abs(splitting)};
}

Lone_pan lone_pan(const Balance<>& b, double n)
{
  if(!(b.lambda2 >= 0 && 4 * b.mu2 > b.lambda2 && std::isfinite(n)))
    throw std::domain_error("no such pan: λ² must not be negative, and below 4μ²");
  const double mu = std::sqrt(b.mu2), lambda = std::sqrt(b.lambda2);
  const double inner = (2 * mu - lambda) * (2 * mu + lambda);
  const double g = 4 * b.rho * b.mu2 * mu / inner;
  const double square = mu / 4 * (2 * g - mu / 4);  // g² − (μ/4 − g)²
  return {b.rho / b.beta * b.mu2 * n * n / inner, inner / (32 * b.mu2),
          square > 0 ? n * n / 4 * std::sqrt(square) : 0};
}

double trapping_ratio(double r)
{
  if(!(r >= 0 && r <= 1))
    return std::numeric_limits<double>::quiet_NaN();
  const double complement = std::sqrt((1 - r) * (1 + r) * (1 + r * r));
  return 2 / std::numbers::pi * swing::K_from_complement(complement);
}

Trapping trapping(double splitting, double mu, double n)
{
  if(!(mu > 0 && splitting != 0 && n >= 0 && std::isfinite(mu + splitting + n)))
    throw std::domain_error("no exchange: μ must be positive, the splitting not zero, n not negative");
  const double critical = std::sqrt(32 * std::abs(splitting) / mu);
  const double r = n / critical, k = r * r;
  // ½ − ½√(1 − 1/k²) without the difference
  const double part = r <= 1 ? 1 : 1 / (2 * k * (k + std::sqrt((r - 1) * (r + 1) * (r * r + 1))));
  return {critical, trapping_ratio(r), r == 1 ? std::sqrt(0.5) : std::sqrt(part)};
}

std::vector<Envelope> envelopes(const Balance<>& b, const State<>& start, double until, double window,
                                int parts)
{
  if(!(window > 0 && window < until && parts >= 1))
    throw std::domain_error("no envelope: the window must be positive and shorter than the time");
  const double mu = std::sqrt(b.mu2);
  // 16 moments in a period of the fastest line that is not small, at 2μ + λ from the demodulation
  const double fastest = 2 * mu + std::sqrt(std::abs(b.lambda2));
  const int samples = static_cast<int>(std::ceil(until * fastest * 16 / (2 * std::numbers::pi)));
  const auto states = course(b, start, until, samples);
  const double h = until / samples;
  std::vector<Envelope> found;
  for(int k = 0; k <= parts; ++k)
  {
    const double middle = window / 2 + (until - window) * k / parts;
    const int first = std::max(0, static_cast<int>(std::ceil((middle - window / 2) / h)));
    const int last = std::min(samples, static_cast<int>(std::floor((middle + window / 2) / h)));
    double weights = 0, p_cos = 0, p_sin = 0, q_cos = 0, q_sin = 0;
    for(int j = first; j <= last; ++j)
    {
      const double t = j * h;
      const State<>& now = states[static_cast<std::size_t>(j)];
      const double weight = 1 + elementary::cos(2 * std::numbers::pi * (t - middle) / window);
      const auto [s, c] = elementary::sincos(mu * t);
      const double p = now.rate.eta / mu, q = now.rate.theta / mu;
      weights += weight;
      p_cos += weight * (now.at.eta * c - p * s);
      p_sin += weight * (now.at.eta * s + p * c);
      q_cos += weight * (now.at.theta * c - q * s);
      q_sin += weight * (now.at.theta * s + q * c);
    }
    found.push_back({middle, std::hypot(p_cos, p_sin) / weights, std::hypot(q_cos, q_sin) / weights});
  }
  return found;
}

Envelope by_gsl_in_the_mean(const Balance<>& b, const State<>& start, double middle, double window,
                            int parts)
{
  const double mu = std::sqrt(b.mu2);
  State<> now = start;
  std::complex<double> P = 0, Q = 0;
  double at = 0;
  for(int k = 0; k < parts; ++k)
  {
    const double next = middle + window * (double(k) / parts - 0.5);
    now = by_gsl(b, now, next - at, 1e-12);
    at = next;
    const std::complex<double> back = std::polar(1., mu * next);
    P += back * std::complex<double>(now.at.eta, now.rate.eta / mu);
    Q += back * std::complex<double>(now.at.theta, now.rate.theta / mu);
  }
  return {middle, std::abs(P) / parts, std::abs(Q) / parts};
}

Handover handover(const std::vector<Envelope>& course)
{
  for(std::size_t k = 1; k + 1 < course.size(); ++k)
  {
    const Envelope &before = course[k - 1], &here = course[k], &after = course[k + 1];
    if(here.Q > before.Q && here.Q >= after.Q
       && here.Q > course.front().Q + (course.front().P - course.front().Q) / 4)
    {
      const double bend = before.Q - 2 * here.Q + after.Q;
      const double part = bend == 0 ? 0 : (before.Q - after.Q) / (2 * bend);
      return {here.t + part * (here.t - before.t), here.Q / course.front().P, here.P / course.front().P};
    }
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan, nan};
}

}  // namespace balance
