#include "swing/time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swing
{
namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void same_length(std::span<const double> in, std::span<double> out)
{
  if (in.size() != out.size())
    throw std::invalid_argument("swing: the arrays differ in length");
}

double supplement(double angle)
{
  return (pi_hi - angle) + pi_lo;
}

// The angle a whose 1 − cos a is `versine`.
double angle_of(double versine)
{
  return 2 * std::asin(std::sqrt(versine / 2));
}

double versine(double angle)
{
  const double s = std::sin(angle / 2);
  return 2 * s * s;
}

// Carlson's symmetric integral of the first kind, by duplication until the three arguments differ by so little
// that seven terms of the series about their mean suffice. All ≥ 0, at most one zero.
double carlson_rf(double x, double y, double z)
{
  double mean = (x + y + z) / 3;
  double spread = std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z)});
  while (spread > 2.5e-3 * mean)
  {
    const double sx = std::sqrt(x);
    const double sy = std::sqrt(y);
    const double sz = std::sqrt(z);
    const double lambda = sx * sy + sy * sz + sz * sx;
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
    mean = 0.25 * (mean + lambda);
    spread *= 0.25;
  }
  const double dx = 1 - x / mean;
  const double dy = 1 - y / mean;
  const double dz = -dx - dy;
  const double e2 = dx * dy - dz * dz;
  const double e3 = dx * dy * dz;
  return (1 + (e2 * (-1.0 / 10 + e2 / 24 - 3 * e3 / 44 - 5 * e2 * e2 / 208 + e2 * e3 / 16) +
               e3 * (1.0 / 14 + 3 * e3 / 104))) / std::sqrt(mean);
}

// Sine of half the sum of two angles between 0 and π, given with their supplements.
double sine_of_half_sum(double a, double a_supplement, double b, double b_supplement)
{
  return std::sin(0.5 * (a + b < pi_hi ? a + b : a_supplement + b_supplement));
}

} // namespace

Amplitude Amplitude::from_zeta(double zeta)
{
  if (!(zeta >= 0 && zeta <= pi_hi))
    throw std::domain_error("swing: the amplitude ζ must lie between 0 and π");
  return {zeta, supplement(zeta)};
}

Amplitude Amplitude::from_eta(double eta)
{
  if (!(eta >= 0 && eta <= pi_hi))
    throw std::domain_error("swing: the angle η from the top must lie between 0 and π");
  return {supplement(eta), eta};
}

Amplitude Amplitude::from_height(double h)
{
  if (!(h >= 0 && h <= 2))
    throw std::domain_error("swing: the height of the turning point must lie between 0 and 2b");
  return h <= 1 ? from_zeta(angle_of(h)) : from_eta(angle_of(2 - h));
}

Amplitude Amplitude::from_depth(double depth)
{
  if (!(depth >= 0 && depth <= 2))
    throw std::domain_error("swing: the depth of the turning point must lie between 0 and 2b");
  return depth <= 1 ? from_eta(angle_of(depth)) : from_zeta(angle_of(2 - depth));
}

double Amplitude::height() const { return zeta <= eta ? versine(zeta) : 2 - versine(eta); }
double Amplitude::depth() const { return eta <= zeta ? versine(eta) : 2 - versine(zeta); }
double Amplitude::modulus() const { return std::sin(zeta / 2); }
double Amplitude::complement() const { return std::sin(eta / 2); }

double agm(double a, double b)
{
  if (!(a >= 0 && b >= 0))
    return nan;
  if (a == 0 || b == 0)
    return 0;
  while (std::abs(a - b) > 2e-8 * a)
  {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a) * std::sqrt(b);
    a = mean;
  }
  return 0.5 * (a + b);
}

double K_from_complement(double kc)
{
  return kc >= 0 && kc <= 1 ? 0.5 * pi_hi / agm(1, kc) : nan;
}

double K(double k)
{
  return K_from_complement(std::sqrt((1 - k) * (1 + k)));
}

double quarter_time_from_top(double eta)
{
  return eta >= 0 && eta <= pi_hi ? K_from_complement(std::sin(eta / 2)) : nan;
}

double quarter_time(Amplitude a) { return quarter_time_from_top(a.eta); }

double ratio_from_top(double eta) { return quarter_time_from_top(eta) * (2 / pi_hi); }

double ratio(Amplitude a) { return ratio_from_top(a.eta); }

// The mean falls short of 1 by the sum of all the half differences c₁ + c₂ + …, where c₁ = sin² ¼ζ and each
// c is the square of the one before over four times its mean: nothing is subtracted from anything near it.
double ratio_excess(Amplitude a)
{
  double lower = a.complement();
  if (lower == 0)
    return std::numeric_limits<double>::infinity();
  const double quarter = std::sin(a.zeta / 4);
  double c = quarter * quarter;
  double short_of_one = c;
  double upper = 1;
  double mean = 1 - c;
  while (c > 1e-17 * short_of_one)
  {
    lower = std::sqrt(upper) * std::sqrt(lower);
    upper = mean;
    mean = 0.5 * (upper + lower);
    c = c * c / (4 * mean);
    short_of_one += c;
  }
  return short_of_one / (1 - short_of_one);
}

void K(std::span<const double> k, std::span<double> out)
{
  same_length(k, out);
  for (std::size_t i = 0; i < k.size(); ++i)
    out[i] = K(k[i]);
}

void K_from_complement(std::span<const double> kc, std::span<double> out)
{
  same_length(kc, out);
  for (std::size_t i = 0; i < kc.size(); ++i)
    out[i] = K_from_complement(kc[i]);
}

void ratio(std::span<const double> zeta, std::span<double> out)
{
  same_length(zeta, out);
  for (std::size_t i = 0; i < zeta.size(); ++i)
    out[i] = zeta[i] >= 0 ? ratio_from_top(supplement(zeta[i])) : nan;
}

void ratio_from_top(std::span<const double> eta, std::span<double> out)
{
  same_length(eta, out);
  for (std::size_t i = 0; i < eta.size(); ++i)
    out[i] = ratio_from_top(eta[i]);
}

// With z = sin ½Φ the time is the integral of dz/√((1 − z²)(k² − z²)); k² − z² is a product of two sines.
double time_from_bottom(double phi, Amplitude a)
{
  const double up = std::abs(phi);
  if (!(up <= a.zeta))
    return nan;
  const double from_top = supplement(up);
  const double z = std::sin(up / 2);
  if (z == 0)
    return phi;
  const double k = a.modulus();
  const double across = std::sin(from_top / 2);
  const double left = std::sin((a.zeta - up) / 2) * sine_of_half_sum(a.zeta, a.eta, up, from_top);
  return std::copysign(z * carlson_rf(left, k * k * across * across, k * k), phi);
}

double time_from_rest(double psi, double eta)
{
  return psi <= pi_hi ? time_from_rest_past(psi - eta, eta) : nan;
}

// With ω = ½ψ, α = ½η the time is the integral of dω/√(sin² ω − sin² α) from α. Where sin² α is too small to matter
// beside 1 it is the logarithm of tan ½ω (1 + √(1 − sin² α/sin² ω)) / tan ½α, and nothing underflows.
double time_from_rest_past(double past, double eta)
{
  const double psi = eta + past;
  if (!(eta >= 0 && past >= 0 && psi <= pi_hi))
    return nan;
  if (past == 0)
    return 0;
  if (eta == 0)
    return std::numeric_limits<double>::infinity();
  const double omega = psi / 2;
  const double alpha = eta / 2;
  const double below = std::sin(past / 2);
  const double above = sine_of_half_sum(psi, supplement(psi), eta, supplement(eta));
  if (eta < 1e-8)
  {
    const double sine = std::sin(omega);
    const double v = past < psi / 2 ? past / eta : std::tan(omega / 2) / std::tan(alpha / 2) - 1;
    return std::log1p(v) + std::log1p(std::sqrt(below / sine) * std::sqrt(above / sine));
  }
  const double sa = std::sin(alpha);
  const double ca = std::cos(alpha);
  const double so = std::sin(omega);
  const double co = psi < 1 ? std::cos(omega) : std::sin(supplement(psi) / 2);
  return std::sqrt(below * above) * carlson_rf(sa * sa * co * co, sa * sa * ca * ca, ca * ca * so * so);
}

} // namespace swing
