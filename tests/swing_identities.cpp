/// @file
/// The swing's time by other routes, and the laws that K obeys.
#include <cmath>

#include <doctest/doctest.h>

#include "exact/quadrature.hpp"
#include "swing/motion.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"
#include "swing_worst.hpp"

using exact::Fifty;
namespace oracle = swing::oracle;

namespace
{

// The complete integral of the second kind by the same mean: K (1 − Σ 2ⁿ⁻¹ cₙ²), c₀ = k.
Fifty E_from_complement(const Fifty& kc)
{
  Fifty a = 1;
  Fifty b = kc;
  Fifty c2 = (Fifty(1) - kc) * (Fifty(1) + kc);
  Fifty sum = c2 / Fifty(2);
  Fifty power = 1;
  while(c2 > Fifty(1e-48))
  {
    const Fifty mean = (a + b) / Fifty(2);
    const Fifty c = (a - b) / Fifty(2);
    b = sqrt(a * b);
    a = mean;
    c2 = c * c;
    sum += power * c2;
    power *= Fifty(2);
  }
  return oracle::K_from_complement(kc) * (Fifty(1) - sum);
}

}  // namespace

TEST_CASE("four routes to K agree: table, array, mean, and the periodic trapezium rule")
{
  for(double zeta : {0.1, 1.0, 1.5707963267948966, 2.0, 2.5, 3.0})
  {
    CAPTURE(zeta);
    const swing::Amplitude a = swing::Amplitude::from_zeta(zeta);
    const double kc = a.complement();
    const Fifty exact = oracle::K_from_complement(kc);
    CHECK(exact::ulps(swing::K_from_complement(kc), exact) <= 0.75);
    double array[1] = {kc};
    swing::K_from_complement(array, array);
    CHECK(exact::ulps(array[0], exact) <= 1.25);
    CHECK(exact::ulps(swing::pi_hi / 2 / swing::agm(1, kc), exact) <= 5);
    // The mean value of 1/√(cos² + kc² sin²); the error falls as tan²ᴺ(¼ζ) and at 3 rad needs 500 points.
    constexpr int points = 500;
    Fifty sum = 0;
    for(int i = 0; i < points; ++i)
    {
      const Fifty angle = exact::pi() * Fifty(2 * i + 1) / Fifty(2 * points);
      const Fifty c = cos(angle);
      const Fifty s = Fifty(kc) * sin(angle);
      sum += Fifty(1) / sqrt(c * c + s * s);
    }
    CHECK(exact::ulps(swing::K_from_complement(kc), exact::pi() / Fifty(2 * points) * sum) <= 0.75);
  }
}

TEST_CASE("Legendre's relation E K' + E' K − K K' = ½π, to k = 1 − 10⁻¹²")
{
  for(double k : {1e-6, 0.1, 0.5, 0.7, 0.9, 1 - 1e-3, 1 - 1e-6, 1 - 1e-9, 1 - 1e-12})
  {
    CAPTURE(k);
    const Fifty kc = sqrt((Fifty(1) - Fifty(k)) * (Fifty(1) + Fifty(k)));
    const Fifty E = E_from_complement(kc);
    const Fifty E_other = E_from_complement(Fifty(k));
    const auto relation = [&](const Fifty& K, const Fifty& K_other) {
      return E * K_other + E_other * K - K * K_other - exact::pi() / Fifty(2);
    };
    CHECK(static_cast<double>(abs(relation(oracle::K_from_complement(kc), oracle::K(kc)))) < 1e-46);
    // With the two K as doubles each errs by half an ulp and the relation by (E' − K')dK + (E − K)dK'.
    const double K = swing::K(k);
    const double K_other = swing::K_from_complement(k);
    const double allowed = 0x1p-52 * K * K_other + std::abs(K - 1) * 0x1p-52;
    CHECK(static_cast<double>(abs(relation(K, K_other))) < allowed);
  }
}

TEST_CASE("Landen's step up and down: K(k) = (1 + k₁) K(k₁), k₁ = (1 − kc)/(1 + kc)")
{
  Dice dice(7);
  Worst worst;
  for(int i = 0; i < 1000; ++i)
  {
    const double kc = dice.log_between(1e-12, 1);
    // kc₁ = 2√kc/(1 + kc): the relation for the double nearest to it, whose error costs K half an ulp more.
    const swing::Twofold one_and = swing::sum_of(1, kc);
    const swing::Twofold root = swing::sqrt({kc, 0});
    const double kc1 = (swing::Twofold{2 * root.hi, 2 * root.lo} / one_and).hi;
    const swing::Twofold factor = swing::Twofold{2, 0} / one_and;
    worst.see(
        kc, ulps(swing::K_from_complement(kc), factor * swing::Twofold{swing::K_from_complement(kc1), 0}));
  }
  CAPTURE(worst.at);
  CHECK(worst.error <= 2);
}

TEST_CASE("T(150°) = √3 T(30°), by tables from end to end")
{
  const double d = swing::pi_hi / 180;
  CHECK(exact::ulps(swing::ratio_from_bottom(150 * d),
                    sqrt(Fifty(3)) * Fifty(swing::ratio_from_bottom(30 * d)))
        <= 2);
}

TEST_CASE("at 90°, where the nome is exchanged for its dual, nothing jumps")
{
  const double right = swing::pi_hi / 2;
  const swing::Motion below(swing::Amplitude::from_zeta(right));
  const swing::Motion above(swing::Amplitude::from_zeta(std::nextafter(right, 2.0)));
  REQUIRE(below.course() == swing::kernels::low);
  REQUIRE(above.course() == swing::kernels::high);
  Worst angle;
  Worst velocity;
  for(int i = -2000; i <= 2000; ++i)
  {
    const double t = below.period() * i / 2000;
    angle.see(t, std::abs(below.angle(t) - above.angle(t)));
    velocity.see(t, std::abs(below.velocity(t) - above.velocity(t)));
  }
  CAPTURE(angle.at);
  CAPTURE(velocity.at);
  // The two amplitudes differ by one ulp of ½π, the periods by 2·10⁻¹⁶; either form errs by up to three
  // ulps.
  CHECK(angle.error <= 7 * 0x1p-52);
  CHECK(velocity.error <= 7 * 0x1p-52);
  // K from both sides of k = kc.
  const double k = std::sqrt(0.5);
  CHECK(std::abs(swing::K(k) - swing::K_from_complement(k)) <= 2 * 0x1p-52);
}
