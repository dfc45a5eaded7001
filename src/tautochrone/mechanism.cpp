#include "tautochrone/mechanism.hpp"

#include "tautochrone/average.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace tautochrone
{
namespace
{

// The coefficients of hⁿ, n ≥ first, in double.
std::vector<double> from(const Mechanism::Polynomial& p, int first)
{
  std::vector<double> all;
  for(int n = first; n <= p.highest(); ++n)
    all.push_back(static_cast<double>(p[n]));
  return all;
}

double value(const std::vector<double>& coefficients, double h)
{
  double sum = 0;
  for(auto c = coefficients.rbegin(); c != coefficients.rend(); ++c)
    sum = sum * h + *c;
  return sum;
}

}  // namespace

Mechanism::Mechanism(const Polynomial& inertia, const Polynomial& moment)
{
  const exact::Fifty I0 = inertia[0], w0 = moment[0];
  if(inertia.lowest() < 0 || moment.lowest() < 0 || !(I0 > 0) || !(w0 > 0))
    throw std::domain_error("a pendulum has a positive inertia and a positive moment in its lowest place");
  const Polynomial i = inertia * Polynomial(1 / I0), m = moment * Polynomial(1 / w0), V = integral(m);
  const Polynomial rest =
      Polynomial(2) * V * i * Polynomial(1, -1) - (Polynomial(2) - Polynomial(exact::Fifty(1), 1)) * m * m;
  inertia_ = from(i, 0);
  moment_ = from(m, 0);
  height_ = from(V, 1);
  rest_ = from(rest, 1);  // in the lowest place nothing is left
  small_ = 2 * std::numbers::pi * static_cast<double>(sqrt(I0 / (2 * w0)));
}

double Mechanism::excess(double phi0) const
{
  if(!(phi0 > 0 && phi0 < std::numbers::pi))
    throw std::domain_error("this amplitude is not between 0 and π");
  const double half = std::sin(phi0 / 2), h0 = 2 * half * half, c0 = std::cos(phi0);
  // (V₀ − V)/(h₀ − h) as a polynomial in h, by one synthetic division
  std::vector<double> steepness(height_.size());
  double carried = 0;
  for(std::size_t n = height_.size(); n-- > 0;)
    steepness[n] = carried = carried * h0 + height_[n];
  const double average = average_over_quarter(
      [&](double sin2, double cos2) {
        const double h = h0 * sin2, c = c0 + h0 * cos2;  // after sin ½φ = sin ½φ₀ sin α
        const double I = value(inertia_, h), w = value(moment_, h);
        if(!(I > 0) || !(w > 0))
          return std::numeric_limits<double>::quiet_NaN();
        const double D = h * value(rest_, h) / ((1 + c) * w * w), root = std::sqrt(1 + D);
        return 2 * std::sqrt(I) * D / (root * (1 + root) * std::sqrt((1 + c) * value(steepness, h)));
      },
      value(inertia_, h0) < 0.01 || 1 + c0 < 0.06);
  if(std::isnan(average))
    throw std::domain_error("the pendulum does not rise to this angle");
  return average / std::numbers::sqrt2;
}

double Mechanism::small_swing() const
{
  return small_;
}

double Mechanism::swing_time(double phi0) const
{
  return small_ + small_ * excess(phi0);
}

}  // namespace tautochrone
