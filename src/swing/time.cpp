#include "swing/time.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "swing/kernels.hpp"
#include "swing/rows.hpp"
#include "swing/twofold.hpp"
#include "swing_tables.hpp"

namespace swing
{
namespace
{

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// An argument that is exact, and one with what it was rounded by: then the distance from a row's centre
// grows by so much.
struct Exact
{
  double x;
  SWING_INLINE double moved(double distance, double) const { return distance; }
};
struct Inexact
{
  double x;
  double lost;
  SWING_INLINE double moved(double distance, double scale) const { return distance + lost * scale; }
};

// Two numbers side by side: what stands above and below in a row's quotient is computed together.
using Pair = double __attribute__((vector_size(16)));

SWING_INLINE Pair load_pair(const double* c)
{
  Pair pair;
  __builtin_memcpy(&pair, __builtin_assume_aligned(c, sizeof pair), sizeof pair);
  return pair;
}

// What the row at c says at the distance t from its centre.
template <class Table>
SWING_INLINE rows::Sum<double> value_of_row(const double* c, double t)
{
  const Pair coefficients[] = {load_pair(c + 2), load_pair(c + 4),  load_pair(c + 6),
                               load_pair(c + 8), load_pair(c + 10), load_pair(c + 12)};
  const Pair both = rows::quintic<1, Table::sloping>(coefficients, Pair{t, t});
  return rows::beyond_centre<Table>(c[1], c[14], t, both[0], both[1]);
}

// What the rows say of x, x having one.
template <class Table>
SWING_INLINE rows::Sum<double> looked_up(double x)
{
  const auto place = rows::place_of<Table>(x);
  const double* const c = Table::stored.rows[place.row];
  return value_of_row<Table>(c, place.x - c[0]);
}

// The same of K, x = 1 − k having a row.
SWING_INLINE rows::Sum<double> looked_up(double k, double x)
{
  const auto place = rows::place_of_modulus(k, x);
  const double* const c = rows::K_by_modulus::stored.rows[place.row];
  return value_of_row<rows::K_by_modulus>(c, place.x - c[0]);
}

// And of T/Θ, η having a row.
SWING_INLINE rows::Sum<double> looked_up(const rows::Angles<double>& a)
{
  const auto place = rows::place_of_angles(a, bits::made(rows::to_upper));
  const double* const c = rows::Ratio_by_eta::stored.rows[place.row];
  return value_of_row<rows::Ratio_by_eta>(c, (place.x - c[0]) + place.rest);
}

// And what the logarithm and its series say of x below them.
template <class Table, class Argument>
SWING_INLINE rows::Sum<double> below(Argument a)
{
  const auto& f = bits::as_stored(Table::stored);
  const rows::Scaled<double> s = rows::scaled<Table>(a.x, f.zero);
  const double* const c = f.centres + rows::centre_of(s.mantissa);
  return rows::below(f, rows::Reading<double>{c[1], a.moved(s.mantissa - c[0], s.power), s.mantissa + c[0]},
                     s.halvings, rows::small_of<Table>(a.x));
}

double rounded(const rows::Sum<double>& sum)
{
  return sum.main + sum.rest;
}

// Whether x stands below the rows and is not tiny.
template <class Table>
SWING_INLINE bool plainly_below(double x)
{
  constexpr auto least = __builtin_bit_cast(std::uint64_t, rows::tiny);
  return bits::bits_of(x) - least < __builtin_bit_cast(std::uint64_t, Table::start) - least;
}

// Asks for what is read below the rows: with cold caches it comes while the code is still waited for.
template <class Table>
SWING_INLINE void expect_below()
{
  const auto& f = bits::as_stored(Table::stored);
  for(const double* line = &f.zero; line < f.rows[0]; line += 8)
    __builtin_prefetch(line);
}

// Asks for the row that serves half of all arguments, and for those that stand before it and serve the next most, while
// it is not yet known which is wanted: with cold caches they come together, and are there when another call wants one.
template <class Table>
SWING_INLINE void expect_usual()
{
  const double* const end = bits::as_stored(Table::stored).rows[Table::of_square] + tables::row_length;
  for(const double* line = end - Table::expected * tables::row_length; line < end; line += 8)
    __builtin_prefetch(line);
}

// Infinite at zero, NaN where there is no value.
double out_of_domain(double x)
{
  return x == 0 ? inf : nan;
}

// Of the table's function for an x that is tiny or has no value.
template <class Table, class Argument>
[[gnu::noinline]] double rounded_value_elsewhere(Argument a)
{
  return a.x > 0 && a.x < Table::start ? rounded(below<Table>(a)) : out_of_domain(a.x);
}

// And for any x that has no row.
template <class Table, class Argument>
SWING_INLINE double rounded_value_below(Argument a)
{
  expect_below<Table>();
  if(plainly_below<Table>(a.x)) [[likely]]
    return rounded(below<rows::Not_tiny<Table>>(a));
  return rounded_value_elsewhere<Table>(a);
}

// T/Θ of any angles.
SWING_INLINE double rounded_ratio(const rows::Angles<double>& a)
{
  using Table = rows::Ratio_by_eta;
  if(rows::beyond_start<Table>(a.eta) <= rows::reach<Table>) [[likely]]
    return rounded(looked_up(a));
  return rounded_value_below<Table>(Inexact{a.eta, a.eta_rest});
}

// K of a modulus that is negative or has no value.
[[gnu::noinline]] double K_elsewhere(double k)
{
  return std::signbit(k) ? K(-k) : out_of_domain(1 - k);
}

void same_length(std::span<const double> in, std::span<double> out)
{
  if(in.size() != out.size())
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
  while(spread > 2.5e-3 * mean)
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
  return (1
          + (e2 * (-1.0 / 10 + e2 / 24 - 3 * e3 / 44 - 5 * e2 * e2 / 208 + e2 * e3 / 16)
             + e3 * (1.0 / 14 + 3 * e3 / 104)))
         / std::sqrt(mean);
}

// Sine of half the sum of two angles between 0 and π, given with their supplements.
double sine_of_half_sum(double a, double a_supplement, double b, double b_supplement)
{
  return std::sin(0.5 * (a + b < pi_hi ? a + b : a_supplement + b_supplement));
}

}  // namespace

Amplitude Amplitude::from_zeta(double zeta)
{
  if(!(zeta >= 0 && zeta <= pi_hi))
    throw std::domain_error("swing: the amplitude ζ must lie between 0 and π");
  const double nearly = pi_hi - zeta;
  const double lost = zeta <= pi_hi / 2 ? (pi_hi - nearly) - zeta : 0;
  const double eta = nearly + (lost + pi_lo);
  return {zeta, eta, 0, (nearly - eta) + (lost + pi_lo)};
}

Amplitude Amplitude::from_eta(double eta)
{
  if(!(eta >= 0 && eta <= pi_hi))
    throw std::domain_error("swing: the angle η from the top must lie between 0 and π");
  const Amplitude swapped = from_zeta(eta);
  return {swapped.eta, swapped.zeta, swapped.eta_rest, 0};
}

Amplitude Amplitude::from_height(double h)
{
  if(!(h >= 0 && h <= 2))
    throw std::domain_error("swing: the height of the turning point must lie between 0 and 2b");
  return h <= 1 ? from_zeta(angle_of(h)) : from_eta(angle_of(2 - h));
}

Amplitude Amplitude::from_depth(double depth)
{
  if(!(depth >= 0 && depth <= 2))
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
  if(!(a >= 0 && b >= 0))
    return nan;
  if(a == 0 || b == 0)
    return 0;
  if(std::max(a, b) < 0x1p-900)  // where half an odd number of the smallest doubles is none
    return agm(a * 0x1p900, b * 0x1p900) * 0x1p-900;
  while(std::abs(a - b) > 2e-8 * a)
  {
    const double mean = 0.5 * a + 0.5 * b;
    b = std::sqrt(a) * std::sqrt(b);
    a = mean;
  }
  return 0.5 * a + 0.5 * b;
}

double K(double k)
{
  using Table = rows::K_by_modulus;
  expect_usual<Table>();
  const double x = bits::made(1) - k;
  if(rows::beyond_start<Table>(x) <= rows::reach<Table>) [[likely]]
    return rounded(looked_up(k, x));
  expect_below<Table>();
  if(plainly_below<Table>(x)) [[likely]]
    return rounded(below<rows::Not_tiny<Table>>(Exact{x}));
  return K_elsewhere(k);
}

double K_from_complement(double kc)
{
  using Table = rows::K_by_complement;
  if(rows::beyond_start<Table>(kc) <= rows::reach<Table>) [[likely]]
    return rounded(looked_up<Table>(kc));
  return rounded_value_below<Table>(Exact{kc});
}

double quarter_time_from_top(double eta)
{
  if(!(eta > 0 && eta <= pi_hi))
    return out_of_domain(eta);
  using Table = rows::Ratio_by_eta;
  const rows::Sum<double> ratio =
      eta >= Table::start ? looked_up(rows::from_top(eta)) : below<Table>(Exact{eta});
  const Twofold K = product_of(ratio.main, pi_hi / 2);
  return K.hi + (K.lo + (ratio.main * (pi_lo / 2) + ratio.rest * (pi_hi / 2)));
}

double quarter_time(Amplitude a)
{
  return quarter_time_from_top(a.eta);
}

double ratio_from_top(double eta)
{
  return rounded_ratio(rows::from_top(eta));
}

double ratio_from_bottom(double zeta)
{
  using Table = rows::Ratio_by_eta;
  constexpr double last = pi_hi - Table::start;  // whose η has a row
  expect_usual<Table>();
  const rows::Angles<double> a = rows::from_bottom(zeta, bits::made(pi_hi), bits::made(pi_lo));
  if(bits::bits_of(zeta) <= bits::bits_of(last)) [[likely]]
    return rounded(looked_up(a));
  expect_below<Table>();
  if(bits::bits_of(zeta) <= bits::bits_of(pi_hi)) [[likely]]
    return rounded(below<rows::Not_tiny<Table>>(Inexact{a.eta, a.eta_rest}));
  return zeta == 0 ? ratio_from_bottom(0) : nan;
}

double ratio(Amplitude a)
{
  return rounded_ratio({a.eta, a.eta_rest, a.zeta, a.zeta_rest});
}

// Up to 90° by a polynomial in ζ²; beyond, where the excess is no longer small, a subtraction costs three
// units of the last place.
double ratio_excess(Amplitude a)
{
  if(a.zeta > pi_hi / 2)
    return ratio(a) - 1;
  const double x = a.zeta * a.zeta;
  double sum = 0;
  for(std::size_t j = std::size(tables::excess); j-- > 0;)
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
// The smallest swings all take the same time to the same part of their amplitude, and the first part of any
// swing goes uniformly.
double time_from_bottom(double phi, Amplitude a)
{
  const double up = std::abs(phi);
  if(!(up <= a.zeta))
    return nan;
  if(up == 0)
    return phi;
  if(a.zeta < 0x1p-500)
    return time_from_bottom(phi * 0x1p400, Amplitude::from_zeta(a.zeta * 0x1p400));
  const double k = a.modulus();
  if(up < 0x1p-950)
    return phi / k / 2;
  const double from_top = supplement(up);
  const double across = std::sin(from_top / 2);
  const double before_rest = std::fmax(0, (a.zeta - up) + a.zeta_rest);
  const double left = std::sin(before_rest / 2) / k * (sine_of_half_sum(a.zeta, a.eta, up, from_top) / k);
  return std::copysign(std::sin(up / 2) / k * carlson_rf(left, across * across, 1),
                       phi);  // divided by k: k² may underflow
}

double time_from_rest(double psi, double eta)
{
  return psi <= pi_hi ? time_from_rest_past(psi - eta, eta) : nan;
}

// With ω = ½ψ, α = ½η the time is the integral of dω/√(sin² ω − sin² α) from α. Where sin² α is too small
// to matter beside 1 it is the logarithm of tan ½ω (1 + √(1 − sin² α/sin² ω)) / tan ½α, and nothing
// underflows.
double time_from_rest_past(double past, double eta)
{
  const double psi = eta + past;
  if(!(eta >= 0 && past >= 0 && psi <= pi_hi))
    return nan;
  if(past == 0)
    return 0;
  if(eta == 0)
    return inf;
  if(psi < 0x1p-500)  // there the time depends on the quotient alone
    return time_from_rest_past(past * 0x1p400, eta * 0x1p400);
  const double omega = psi / 2;
  const double twice_below = past < 1e-8 ? past : 2 * std::sin(past / 2);
  const double above = sine_of_half_sum(psi, supplement(psi), eta, supplement(eta));
  if(eta < 1e-8)
  {
    const double sine = std::sin(omega);
    const double tangents = 4 * std::tan(omega / 2) / eta;
    const double first = past < psi / 2   ? std::log1p(past / eta)
                         : tangents < inf ? std::log(tangents)
                                          : std::log(4 * std::tan(omega / 2)) - std::log(eta);
    const double quotient = twice_below / (2 * sine);
    return first + std::log1p(std::sqrt(quotient) * std::sqrt(above / sine));
  }
  const double sa = std::sin(eta / 2);
  const double ca = std::cos(eta / 2);
  const double so = std::sin(omega);
  const double co = psi < 1 ? std::cos(omega) : std::sin(supplement(psi) / 2);
  return std::sqrt(twice_below) * std::sqrt(above / 2)
         * carlson_rf(sa * sa * co * co, sa * sa * ca * ca, ca * ca * so * so);
}

}  // namespace swing
