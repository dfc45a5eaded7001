/// @file
/// The oracle of the pendulum: each quantity by two routes, and against published constants.
#include <doctest/doctest.h>

#include "exact/fifty.hpp"
#include "exact/quadrature.hpp"
#include "swing/oracle.hpp"
#include "swing_worst.hpp"

using exact::Fifty;
namespace oracle = swing::oracle;

namespace
{

double relative(const Fifty& got, const Fifty& exact)
{
  return static_cast<double>(abs(got / exact - Fifty(1)));
}
Fifty degrees(double d)
{
  return Fifty(d) * exact::pi() / Fifty(180);
}

}  // namespace

TEST_CASE("K by the mean and by Euler's two series agree to 45 digits, from kc = 1 to 1e-300")
{
  for(double kc : {1.0, 0.999, 0.9, 0.75, 0.7072, 0.7071, 0.5, 0.25, 1e-2, 1e-5, 1e-20, 1e-154, 1e-300})
  {
    CAPTURE(kc);
    CHECK(relative(oracle::K_from_complement(kc), oracle::K_by_series(kc)) < 1e-45);
  }
}

TEST_CASE("K is the integral that defines it")
{
  const Fifty k("0.8");
  const exact::Integral integral = exact::integrate(
      [&](const Fifty& x) {
        const Fifty s = k * sin(x);
        return Fifty(1) / sqrt(Fifty(1) - s * s);
      },
      Fifty(0), exact::pi() / Fifty(2));
  CHECK(relative(integral.value, oracle::K(k)) < 1e-39);
}

TEST_CASE("T/Θ at 90° is Γ(¼)²/(2π^{3/2}), at 30° a product with Γ(⅓)³, and T(150°) = √3 T(30°)")
{
  const Fifty pi = exact::pi();
  const Fifty quarter = tgamma(Fifty(0.25));
  CHECK(relative(oracle::ratio_from_bottom(pi / Fifty(2)), quarter * quarter / (Fifty(2) * pi * sqrt(pi)))
        < 1e-45);
  const Fifty third = Fifty(1) / Fifty(3);
  const Fifty at30 =
      pow(Fifty(3), Fifty(0.25)) * pow(tgamma(third), 3) / (pow(Fifty(2), Fifty(7) / Fifty(3)) * pi);
  CHECK(relative(oracle::ratio_from_bottom(degrees(30)) * pi / Fifty(2), at30) < 1e-45);
  CHECK(relative(oracle::ratio_from_bottom(degrees(150)),
                 sqrt(Fifty(3)) * oracle::ratio_from_bottom(degrees(30)))
        < 1e-45);
}

TEST_CASE("the mean of 1 and √2 is Gauss's")
{
  CHECK(oracle::agm(Fifty(1), sqrt(Fifty(2))).str(30) == "1.19814023473559220743992249228");
}

TEST_CASE("T/Θ − 1 agrees with the difference, and with its series where that would cancel")
{
  CHECK(relative(oracle::ratio_excess(Fifty(2)), oracle::ratio_from_bottom(Fifty(2)) - Fifty(1)) < 1e-44);
  const Fifty z = Fifty(1e-8);
  const Fifty x = z * z;
  const Fifty series =
      x / Fifty(16) + Fifty(11) * x * x / Fifty(3072) + Fifty(173) * x * x * x / Fifty(737280);
  CHECK(relative(oracle::ratio_excess(z), series) < 1e-45);
}

TEST_CASE("T/Θ from ζ and from η agree")
{
  for(double eta : {3.0, 1.5, 0.1, 1e-6})
    CHECK(relative(oracle::ratio_from_top(eta), oracle::ratio_from_bottom(exact::pi() - Fifty(eta)))
          < 1e-40);
}

TEST_CASE("Φ by theta functions and by Landen's transformation agree, for any energy")
{
  const auto agree = [](const oracle::Motion& m, double tolerance) {
    for(double part : {0.1, 0.37, 0.5, 0.93, 1.0, 1.6, 2.3, 3.7, 40.2})
    {
      const Fifty t = m.quarter() * Fifty(part);
      const Fifty by_theta = m.angle(t);
      CAPTURE(part);
      CHECK(static_cast<double>(abs(by_theta - m.angle_by_landen(t))) < tolerance);
    }
  };
  for(double zeta : {1e-5, 0.2, 1.5707, 1.5709, 2.5, 3.14})
    agree(oracle::Motion::from_zeta(zeta), 1e-44);
  for(double eta : {1e-4, 1e-9, 1e-15})
    agree(oracle::Motion::from_eta(eta), 1e-34);
  for(double excess : {1e-9, 0.3, 0.999, 1.001, 50.0})
    agree(oracle::Motion::revolving(excess), 1e-40);
}

TEST_CASE("½Φ'² + 1 − cos Φ is the energy that was given")
{
  const auto lost = [](const oracle::Motion& m, const Fifty& energy, double part) {
    const Fifty t = m.quarter() * Fifty(part);
    const Fifty v = m.velocity(t);
    const Fifty s = sin(m.angle(t) / Fifty(2));
    return static_cast<double>(abs((v * v / Fifty(2) + Fifty(2) * s * s) / energy - Fifty(1)));
  };
  for(double part : {0.0, 0.3, 0.77, 1.0, 2.9})
  {
    for(double zeta : {1e-5, 1.0, 2.0, 3.1})
    {
      const Fifty k = sin(Fifty(zeta) / Fifty(2));
      CHECK(lost(oracle::Motion::from_zeta(zeta), Fifty(2) * k * k, part) < 1e-40);
    }
    for(double excess : {1e-6, 0.7, 3.0})
      CHECK(lost(oracle::Motion::revolving(excess), Fifty(2) * (Fifty(1) + Fifty(excess)), part) < 1e-40);
  }
}

TEST_CASE("the times to an angle and the angles at a time are inverse to each other")
{
  for(double eta : {3.0, 1.6, 0.5, 1e-3, 1e-9})
  {
    CAPTURE(eta);
    const auto m = oracle::Motion::from_eta(eta);
    const Fifty zeta = exact::pi() - Fifty(eta);
    for(double part : {0.1, 0.5, 0.9, 0.999})
    {
      const Fifty phi = zeta * Fifty(part);
      const Fifty t = oracle::time_from_bottom(phi, eta);
      CHECK(relative(m.angle(t), phi) < 1e-38);
      const Fifty rest = oracle::time_from_rest_past(zeta - phi, eta);
      CHECK(relative(rest + t, m.quarter()) < 1e-38);
    }
    CHECK(relative(oracle::time_from_bottom(zeta, eta), m.quarter()) < 1e-24);
  }
}

TEST_CASE("to just the top the time is ln tan(¼π + ¼Φ), and there infinite")
{
  for(double phi : {1e-9, 1.0, 3.0, 3.1415926})
    CHECK(relative(oracle::time_from_bottom(phi, 0), log(tan((exact::pi() + Fifty(phi)) / Fifty(4))))
          < 1e-38);
  CHECK(!isfinite(oracle::time_from_bottom(exact::pi(), 0)));
  CHECK(!isfinite(oracle::ratio_from_top(0)));
}

TEST_CASE("a time too far to tell gives NaN at once")
{
  for(const oracle::Motion& m :
      {oracle::Motion::from_zeta(1), oracle::Motion::from_eta(1e-9), oracle::Motion::revolving(Fifty(0.1))})
    for(double t : {3.3e149, -1e150, 1e300})
    {
      CHECK(isnan(m.angle(t)));
      CHECK(isnan(m.velocity(t)));
      CHECK(isnan(m.angle_from_top(t)));
    }
}

TEST_CASE("107 bits are right to 2⁻⁹⁸ wherever the tests use them")
{
  const auto off = [](swing::Twofold got, const Fifty& exact) {
    return static_cast<double>(abs((Fifty(got.hi) + Fifty(got.lo)) / exact - Fifty(1)));
  };
  Dice dice(11);
  for(int i = 0; i < 300; ++i)
  {
    const double k = 1 - dice.log_between(0x1p-53, 1);
    CHECK(off(K_of(complement_of(k)), oracle::K(k)) < 0x1p-98);
    const double eta = dice.log_between(1e-250, 3.14);
    CHECK(off(ratio_of(K_of_eta({eta, 0})), oracle::ratio_from_top(eta)) < 0x1p-98);
  }
}
