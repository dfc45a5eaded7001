#include "swing/time.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "swing/kernels.hpp"
#include "swing/twofold.hpp"
#include "swing_tables.hpp"

namespace swing
{
namespace
{

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The row of a table that starts at 2^lowest and has 64 rows for each doubling; out of range the number is
// too large.
template <int lowest>
unsigned row_of(double x)
{
  constexpr std::uint64_t first = static_cast<std::uint64_t>(1023 + lowest) << 6;
  return static_cast<unsigned>((std::bit_cast<std::uint64_t>(x) >> 46) - first);
}

// c[1] t + … + c[6] t⁶: what is to be added to the row's value at its centre.
double beyond_centre(const tables::Row& row, double t)
{
  const double t2 = t * t;
  const double low = row.c[1] + t * row.c[2];
  const double middle = row.c[3] + t * row.c[4];
  const double high = row.c[5] + t * row.c[6];
  return t * (low + t2 * (middle + t2 * high));
}

// aₙ² = (1·3·5…(2n−1)/2·4·6…2n)² and rₙ = 2/(1·2) + 2/(3·4) + … + 2/((2n−1)2n), the numbers of §8 and §28.
struct Coefficient
{
  double a2;
  double r;
};

constexpr int terms = 8;

constexpr std::array<Coefficient, terms> coefficients = []
{
  std::array<Coefficient, terms> c{};
  double a = 1;
  double r = 0;
  for (std::size_t n = 0; n < terms; ++n)
  {
    c[n] = {a * a, r};
    const double odd = 2.0 * static_cast<double>(n) + 1;
    a *= odd / (odd + 1);
    r += 2 / (odd * (odd + 1));
  }
  return c;
}();

// K near the top, Σ aₙ² mⁿ (L − rₙ) with L = ln(4/kc) and m = kc² < 1/128. L is given as twos·ln 2 −
// factor·ln x and `more`, which is small, so that its leading part can be summed without loss.
Twofold K_near_top(int twos, double x, double factor, double more, double m)
{
  double lift = 0;
  if (x < 0x1p-1022)
  {
    x *= 0x1p54;
    lift = 54;
  }
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const double e = static_cast<double>(static_cast<int>(bits >> 52) - 1023) - lift;
  const double z = std::bit_cast<double>((bits & 0x000fffffffffffff) | 0x3ff0000000000000);
  const tables::Row& row = tables::minus_log[row_of<tables::minus_log_lowest>(z)];
  const double head = (twos - factor * e) * tables::ln2_hi;
  const double value = factor * row.c[0];
  const double sum = head + value;
  const double rest = ((head - sum) + value) + (twos - factor * e) * tables::ln2_lo +
                      factor * beyond_centre(row, z - row.centre) + more;
  if (m < 0x1p-60)
    return {sum, rest};
  const double L = sum + rest;
  double series = 0;
  for (std::size_t n = terms - 1; n > 0; --n)
    series = m * (series + coefficients[n].a2 * (L - coefficients[n].r));
  return {sum, rest + series};
}

double rounded(Twofold x)
{
  return x.hi + x.lo;
}

// ln(sin h / h) = −h²/6 − h⁴/180 − h⁶/2835 − …, here with η = 2h < 1/64.
Twofold K_near_top_of_eta(double eta)
{
  const double square = eta * eta;
  const double s = eta * (0.5 - square * (1.0 / 48 - square / 3840));
  return K_near_top(3, eta, 1, square * (1.0 / 24 + square / 2880), s * s);
}

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

// Carlson's symmetric integral of the first kind, by duplication until the three arguments differ by so
// little that seven terms of the series about their mean suffice. All ≥ 0, at most one zero.
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
               e3 * (1.0 / 14 + 3 * e3 / 104))) /
         std::sqrt(mean);
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
  const double nearly = pi_hi - zeta;
  const double lost = zeta <= pi_hi / 2 ? (pi_hi - nearly) - zeta : 0;
  const double eta = nearly + (lost + pi_lo);
  return {zeta, eta, 0, (nearly - eta) + (lost + pi_lo)};
}

Amplitude Amplitude::from_eta(double eta)
{
  if (!(eta >= 0 && eta <= pi_hi))
    throw std::domain_error("swing: the angle η from the top must lie between 0 and π");
  const Amplitude swapped = from_zeta(eta);
  return {swapped.eta, swapped.zeta, swapped.eta_rest, 0};
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

double Amplitude::height() const
{
  return zeta <= eta ? versine(zeta) : 2 - versine(eta);
}
double Amplitude::depth() const
{
  return eta <= zeta ? versine(eta) : 2 - versine(zeta);
}
double Amplitude::modulus() const
{
  return std::sin(zeta / 2);
}
double Amplitude::complement() const
{
  return std::sin(eta / 2);
}

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

double K(double k)
{
  const double up = std::abs(k);
  const double y = 1 - up;
  const unsigned i = row_of<tables::K_by_modulus_lowest>(y);
  if (i < tables::K_by_modulus_rows)
  {
    const tables::Row& row = tables::K_by_modulus[i];
    return row.c[0] + beyond_centre(row, up - row.centre);
  }
  if (y > 0)
  {
    const double m = y * (1 + up);
    return rounded(K_near_top(2, m, 0.5, 0, m));
  }
  return y == 0 ? inf : nan;
}

double K_from_complement(double kc)
{
  const unsigned i = row_of<tables::K_by_complement_lowest>(kc);
  if (i < tables::K_by_complement_rows && kc <= 1)
  {
    const tables::Row& row = tables::K_by_complement[i];
    return row.c[0] + beyond_centre(row, kc - row.centre);
  }
  if (kc > 0 && kc < 1)
    return rounded(K_near_top(2, kc, 1, 0, kc * kc));
  return kc == 0 ? inf : nan;
}

double quarter_time_from_top(double eta)
{
  const unsigned i = row_of<tables::K_by_eta_lowest>(eta);
  if (i < tables::K_by_eta_rows && eta <= pi_hi)
  {
    const tables::Row& row = tables::K_by_eta[i];
    return row.c[0] + beyond_centre(row, eta - row.centre);
  }
  if (eta > 0 && eta < 1)
    return rounded(K_near_top_of_eta(eta));
  return eta == 0 ? inf : nan;
}

double quarter_time(Amplitude a)
{
  return quarter_time_from_top(a.eta);
}

namespace
{

// T/Θ where η is given as a sum whose second part is small beside the last place of the first, or nothing.
double ratio_of(double eta, double rest)
{
  const unsigned i = row_of<tables::ratio_by_eta_lowest>(eta);
  if (i < tables::ratio_by_eta_rows && eta <= pi_hi)
  {
    const tables::Row& row = tables::ratio_by_eta[i];
    return row.c[0] + beyond_centre(row, (eta - row.centre) + rest);
  }
  if (eta > 0 && eta < 1)
  {
    const Twofold K = K_near_top_of_eta(eta);
    const Twofold ratio = product_of(K.hi, tables::two_over_pi_hi);
    return ratio.hi + (ratio.lo + (K.hi * tables::two_over_pi_lo + K.lo * tables::two_over_pi_hi));
  }
  return eta == 0 ? inf : nan;
}

} // namespace

double ratio_from_top(double eta)
{
  return ratio_of(eta, 0);
}

double ratio_from_bottom(double zeta)
{
  if (!(zeta >= 0 && zeta <= pi_hi))
    return nan;
  const double nearly = pi_hi - zeta;
  const double eta = nearly + pi_lo;
  return ratio_of(eta, (nearly - eta) + pi_lo);
}

double ratio(Amplitude a)
{
  return ratio_of(a.eta, a.eta_rest);
}

// Up to 90° by a polynomial in ζ²; beyond, where the excess is no longer small, a subtraction costs three
// units of the last place.
double ratio_excess(Amplitude a)
{
  if (a.zeta > pi_hi / 2)
    return ratio(a) - 1;
  const double x = a.zeta * a.zeta;
  double sum = 0;
  for (std::size_t j = std::size(tables::excess); j-- > 0;)
    sum = tables::excess[j] + x * sum;
  return x * sum;
}

void K(std::span<const double> k, std::span<double> out)
{
  same_length(k, out);
  kernels::best().K(k.data(), out.data(), k.size());
}

void K_from_complement(std::span<const double> kc, std::span<double> out)
{
  same_length(kc, out);
  kernels::best().K_from_complement(kc.data(), out.data(), kc.size());
}

void ratio_from_bottom(std::span<const double> zeta, std::span<double> out)
{
  same_length(zeta, out);
  kernels::best().ratio(zeta.data(), out.data(), zeta.size());
}

void ratio_from_top(std::span<const double> eta, std::span<double> out)
{
  same_length(eta, out);
  kernels::best().ratio_from_top(eta.data(), out.data(), eta.size());
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
  const double left = std::sin((a.zeta - up) / 2) / k * (sine_of_half_sum(a.zeta, a.eta, up, from_top) / k);
  return std::copysign(z / k * carlson_rf(left, across * across, 1), phi);  // divided by k: k² may underflow
}

double time_from_rest(double psi, double eta)
{
  return psi <= pi_hi ? time_from_rest_past(psi - eta, eta) : nan;
}

// With ω = ½ψ, α = ½η the time is the integral of dω/√(sin² ω − sin² α) from α. Where sin² α is too small to
// matter beside 1 it is the logarithm of tan ½ω (1 + √(1 − sin² α/sin² ω)) / tan ½α, and nothing underflows.
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
  const double below = std::sin(past / 2);
  const double above = sine_of_half_sum(psi, supplement(psi), eta, supplement(eta));
  if (eta < 1e-8)
  {
    const double sine = std::sin(omega);
    const double tangents = 4 * std::tan(omega / 2) / eta;
    const double first = past < psi / 2   ? std::log1p(past / eta)
                         : tangents < inf ? std::log(tangents)
                                          : std::log(4 * std::tan(omega / 2)) - std::log(eta);
    const double quotient = past < 1e-8 ? past / (2 * sine) : below / sine;
    return first + std::log1p(std::sqrt(quotient) * std::sqrt(above / sine));
  }
  const double sa = std::sin(eta / 2);
  const double ca = std::cos(eta / 2);
  const double so = std::sin(omega);
  const double co = psi < 1 ? std::cos(omega) : std::sin(supplement(psi) / 2);
  return std::sqrt(below * above) * carlson_rf(sa * sa * co * co, sa * sa * ca * ca, ca * ca * so * so);
}

} // namespace swing
