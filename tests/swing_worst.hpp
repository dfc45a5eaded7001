/// @file
/// What the tests of the swing share: the worst error seen, and a reference fast enough for a million
/// arguments.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "exact/fifty.hpp"
#include "swing/time.hpp"
#include "swing/twofold.hpp"

/// The largest error seen, and where.
struct Worst
{
  double error = 0;
  double at = std::numeric_limits<double>::quiet_NaN();

  void see(double x, double e)
  {
    if(!(e <= error))
    {
      error = e;
      at = x;
    }
  }
};

/// Numbers from 0 to 1 that are the same everywhere.
class Dice
{
public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double unit() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }
  double between(double a, double b) { return a + (b - a) * unit(); }
  double log_between(double a, double b) { return a * std::exp(std::log(b / a) * unit()); }

private:
  std::mt19937_64 engine_;
};

/// The error of a double in units of its last place against 107 bits; infinite unless both are finite.
inline double ulps(double got, swing::Twofold exact)
{
  const double place = std::nextafter(std::abs(exact.hi), HUGE_VAL) - std::abs(exact.hi);
  const double e = std::abs((got - exact.hi) - exact.lo) / place;
  return std::isfinite(e) ? e : std::numeric_limits<double>::infinity();
}

/// π/2M(1, kc) of 107 bits.
inline swing::Twofold K_of(swing::Twofold kc)
{
  const swing::Twofold half_pi{swing::pi_hi / 2, swing::pi_lo / 2};
  return half_pi / swing::agm_of_one_and(kc);
}

/// √(1 − k²) of 107 bits.
inline swing::Twofold complement_of(double k)
{
  return swing::sqrt(swing::sum_of(1, -k) * swing::sum_of(1, k));
}

/// K by η of 107 bits.
inline swing::Twofold K_of_eta(swing::Twofold eta)
{
  return K_of(swing::sin({eta.hi / 2, eta.lo / 2}));
}

/// T/Θ from K.
inline swing::Twofold ratio_of(swing::Twofold K)
{
  return K / swing::Twofold{swing::pi_hi / 2, swing::pi_lo / 2};
}
