/// @file
/// Euler's formulae without cancellation, and how long the swings take, against fifty digits and other
/// integrals.
#include "edition/compare.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/mechanism.hpp"
#include "tautochrone/path.hpp"
#include "tautochrone/scene.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"
#include "tautochrone/thread.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace exact;
using namespace tautochrone;
using edition::within;
using edition::within_relative;
using edition::within_ulps;

namespace
{

constexpr double degree = std::numbers::pi / 180;

const Cheeks all[] = {Cheeks::none, Cheeks::cycloids, Cheeks::euler_kk, Cheeks::euler_k4};

Laurent<Fifty> radius_on(Cheeks cheeks, const Fifty& k)
{
  switch(cheeks)
  {
    case Cheeks::none:
      return 1;
    case Cheeks::cycloids:
      return truncated(0, k);
    case Cheeks::euler_kk:
      return truncated(1, k);
    default:
      return truncated(2, k);
  }
}

// Euler's sums as they stand in §§30 to 34, with l for the logarithm.
struct AsPrinted
{
  Fifty r, z, x, y, s, p, q, ds;
};

AsPrinted as_printed(const Fifty& a, const Fifty& k, const Fifty& phi)
{
  const Fifty s = sin(phi), c = cos(phi), kk = k * k, k4 = kk * kk, a3 = a * a * a;
  const Fifty l = log(tan(pi() / 4 + phi / 2));
  const auto over = [&](int n) { return 1 / pow(c, n); };
  AsPrinted e;
  e.r = a * c - kk * (1 - pow(c, 4)) / (a * pow(c, 3)) - 6 * k4 * s * s / (a3 * pow(c, 7));
  e.z = a * s + kk / a * s - kk * s / (2 * a) * over(2) - kk / (2 * a) * l - k4 * s / a3 * over(6)
        + k4 * s / (4 * a3) * over(4) + 3 * k4 * s / (8 * a3) * over(2) + 3 * k4 / (8 * a3) * l;
  e.x = a / 2 * s * s + kk / (2 * a) * s * s + kk / (2 * a) - kk / (2 * a) * over(2) - k4 / (2 * a3)
        - k4 / a3 * over(6) + 3 * k4 / (2 * a3) * over(4);
  e.y = a * phi / 2 + a / 2 * s * c + kk * phi / (2 * a) + kk / (2 * a) * s * c - kk * s / (a * c)
        - 6 * k4 * s / (5 * a3) * over(5) + 2 * k4 * s / (5 * a3) * over(3) + 4 * k4 * s / (5 * a3 * c);
  e.s = a - a * c - kk * c / a + kk / a * over(3) - 6 * k4 / a3 * over(5) + 6 * k4 / a3 * over(7);
  e.ds = a * s + kk * s / a + 3 * kk * s / a * over(4) - 30 * k4 * s / a3 * over(6)
         + 42 * k4 * s / a3 * over(8);
  e.p = a / 2 * s * s + kk * s * s / (2 * a) - 3 * kk / (2 * a) + 3 * kk / (2 * a) * over(2)
        - 15 * k4 / (2 * a3) * over(4) + 7 * k4 / a3 * over(6) + k4 / (2 * a3);
  e.q =
      a * phi / 2 - a / 2 * s * c + kk * phi / (2 * a) - kk * s * c / (2 * a) - kk * s / (a * c)
      + kk * s / a * over(3)
      + k4 * s / (a3 * c) * (Fifty(4) / 5 + Fifty(2) / 5 * over(2) - Fifty(36) / 5 * over(4) + 6 * over(6));
  return e;
}

}  // namespace

TEST_CASE("Euler's curve and cheek, from the smallest angles to near the right angle")
{
  for(const double a : {1.0, 0.7, 1e-50})
    for(const double share : {0.0, 1e-9, 0.02, 0.1, 0.3, 2.0})
      for(const double phi : {1e-12, 1e-6, 1e-3, 0.1, 0.49, 0.51, 0.53, 1.0, 1.4, 1.57})
      {
        const double k = share * a;
        const AsPrinted exactly = as_printed(a, k, phi);
        const Fifty t = tan(Fifty(phi)) * tan(Fifty(phi)), q = Fifty(k) * k / (Fifty(a) * a);
        // How large the terms that are subtracted are beside the first one.
        const double scale = static_cast<double>(a * (1 + q * t * (2 + t) + 6 * q * q * t * pow(1 + t, 3)));
        const char* because = "1e-14 of the terms' sizes";
        CHECK(euler_r(a, k, phi) == within(exactly.r, 1e-14 * scale, because));
        CHECK(euler_z(a, k, phi) == within(exactly.z, 1e-14 * scale * std::sin(phi), because));
        CHECK(euler_x(a, k, phi)
              == within(exactly.x, 1e-14 * scale * std::pow(std::sin(phi), 2) + 1e-46 * a, because));
        CHECK(euler_y(a, k, phi) == within(exactly.y, 1e-14 * scale * std::sin(phi), because));
        const double lost = 1e-46 * scale;  // the oracle's own digits, at the smallest angles
        const auto near_ = [&](const Fifty& y) {
          return within(y, 1e-14 * static_cast<double>(abs(y)) + lost, "1e-14 of itself");
        };
        CHECK(euler_s(a, k, phi) == near_(exactly.s));
        CHECK(euler_ds(a, k, phi) == near_(exactly.ds));
        CHECK(euler_p(a, k, phi) == near_(exactly.p));
        CHECK(euler_q(a, k, phi) == near_(exactly.q));
      }
}

TEST_CASE("the same in fifty digits, odd or even in the angle, and a − x − r cos φ = p, y − r sin φ = q")
{
  const Fifty a(2), k("0.3");
  for(const char* angle : {"0.05", "0.5", "-0.5", "1.1"})
  {
    const Fifty phi(angle);
    const AsPrinted exactly = as_printed(a, k, phi);
    CHECK(euler_z(a, k, phi) == within(exactly.z, 1e-45, "sixty roundings"));
    CHECK(euler_y(a, k, phi) == within(exactly.y, 1e-45, "sixty roundings"));
    CHECK(euler_q(a, k, phi) == within(exactly.q, 1e-44, "sixty roundings"));
    CHECK(a - euler_x(a, k, phi) - euler_r(a, k, phi) * cos(phi)
          == within(euler_p(a, k, phi), 1e-45, "sixty roundings"));
    CHECK(euler_y(a, k, phi) - euler_r(a, k, phi) * sin(phi)
          == within(euler_q(a, k, phi), 1e-44, "sixty roundings"));
  }
}

TEST_CASE("the terms of the series are good to 1e-14 of themselves, to k³²")
{
  const auto exactly = corrections<Fifty>(last_power);
  for(const double k : {1e-3, 0.1, 0.3, 0.9})
    for(const double phi : {1e-9, 1e-3, 0.1, 0.7, 1.3})
    {
      const auto got = terms(k, phi, last_power);
      Fifty sum, largest;
      for(std::size_t n = 0; n < got.size(); ++n)
      {
        const Fifty term = pow(Fifty(k) * k, static_cast<int>(n)) * exactly[n](cos(Fifty(phi)));
        const double digits = phi < 1e-4 ? 1e-9 : 1e-14;  // the oracle subtracts numbers of the size 10²²
        CHECK(got[n] == within_relative(term, digits, "stated, and what the oracle loses"));
        if(n <= 12)
        {
          sum += term;
          largest = std::max(largest, abs(term));
        }
      }
      CHECK(radius_by_series(12, k, phi)
            == within(sum, 1e-13 * static_cast<double>(largest), "1e-13 of the largest term"));
    }
  // For k/a = 0.001 the series has 33 digits at 80°.
  const Fifty small("0.001");
  CHECK(truncated(22, small)(cos(80 * pi() / 180))
        == within(Fifty("0.17345613164023033030405436185333"), 1e-30, "thirty digits of the reference"));
  CHECK_THROWS_AS(terms(0.1, 0.5, 17), std::domain_error);
  CHECK_THROWS_AS(terms(0.1, 1.58, 2), std::domain_error);
  CHECK_THROWS_AS(terms(-0.1, 0.5, 2), std::domain_error);
}

TEST_CASE("where the truncated curves end")
{
  const double expected[3][4] = {{81.8707159516, 79.3119962159, 77.8106282388, 76.7590242636},
                                 {71.6124949224, 65.9125933865, 62.5740541079, 60.238289956},
                                 {57.5849608126, 47.8289415857, 42.2122848305, 38.3356224528}};
  const double bodies[] = {0.02, 0.1, 0.3};
  for(std::size_t i = 0; i < 3; ++i)
    for(int order = 1; order <= 4; ++order)
      CHECK(end_of_truncated(order, bodies[i]) / degree
            == within(Fifty(expected[i][order - 1]), 1e-10, "the digits of the reference"));
  for(const double k : {1e-10, 1e-5, 0.1, 1.0})
    for(const int order : {1, 2, 5, 12})
    {
      const double phi = end_of_truncated(order, k);
      const Laurent<Fifty> r = truncated(order, k);
      const Fifty below = r(cos(Fifty(phi) * (1 - Fifty("1e-15")))),
                  above = r(cos(Fifty(phi) * (1 + Fifty("1e-15"))));
      CHECK((below > 0 && above < 0));  // the zero lies within 1e-15 of it
    }
  for(const double k : {1e-10, 1e-5, 0.1, 1.0, 1e5, 1e10})
  {
    const Fifty kk = Fifty(k) * k;
    CHECK(end_of_truncated(1, k)
          == within_ulps(acos(pow(kk / (1 + kk), Fifty(1) / 4)), 4, "cos⁴φ = kk/(1 + kk), in closed form"));
    const double phi = end_of_truncated(2, k);
    CHECK(euler_r<Fifty>(1, k, Fifty(phi) * (1 - Fifty("1e-15"))) > 0);
    CHECK(euler_r<Fifty>(1, k, Fifty(phi) * (1 + Fifty("1e-15"))) < 0);
  }
  CHECK(end_of_truncated(0, 0.3) == std::acos(0.0));
  CHECK(end_of_truncated(2, 0) == std::acos(0.0));
  CHECK_THROWS_AS(end_of_truncated(2, -1), std::domain_error);
  CHECK_THROWS_AS(end_of_truncated(17, 0.1), std::domain_error);
}

TEST_CASE("T/T₀ − 1 keeps thirteen digits of itself however small it is")
{
  for(const double k : {1e-3, 0.005, 0.02, 0.1, 0.3, 0.7})
    for(const Cheeks cheeks : all)
      for(const double degrees : {0.01, 1.0, 5.0, 30.0, 45.0, 60.0, 80.0})
      {
        const double phi0 = degrees * degree;
        const Fifty exactly = excess(radius_on(cheeks, k), k, phi0);
        if(isnan(exactly))  // the curve has ended
          continue;
        CHECK(excess(cheeks, k, phi0) == within_relative(exactly, 1e-13, "the stated error"));
        CHECK(swing_time(cheeks, k, phi0)
              == within_ulps(pi() * sqrt(2 * (1 + Fifty(k) * k)) * (1 + exactly), 3, "the stated error"));
      }
}

TEST_CASE("the smallest excess follows its law down to the smallest amplitudes")
{
  for(const double k : {0.02, 0.3})
    for(const double phi0 : {1e-8, 1e-20, 1e-100, 1e-140})
    {
      const Fifty q = Fifty(k) * k, square = Fifty(phi0) * phi0;
      CHECK(excess(Cheeks::none, k, phi0) == within_relative(square / 16, 1e-14, "φ₀²/16, the next φ₀⁴"));
      const Fifty law = q / (4 * (1 + q)) * square;
      CHECK(excess(Cheeks::cycloids, k, phi0) == within_relative(law, 1e-14, "the law of §34"));
      CHECK(excess(Cheeks::euler_kk, k, phi0) == within_relative(3 * q * law, 1e-14, "the law of §34"));
      CHECK(excess(Cheeks::euler_k4, k, phi0) == within_relative(9 * q * q * law, 1e-14, "the law of §34"));
    }
}

TEST_CASE("wide swings on a circle and on cycloids, to where the integrand changes abruptly")
{
  for(const double eta : {1.0, 1e-2, 1e-4, 1e-8, 1e-12})
  {
    const double phi0 = std::numbers::pi - eta;
    Fifty a = 1, b = cos(Fifty(phi0) / 2);  // Gauss
    while(abs(a - b) > Fifty("1e-45"))
    {
      const Fifty mean = (a + b) / 2;
      b = sqrt(a * b);
      a = mean;
    }
    const double conditioning = 1e-16 / eta;  // how far the sine of ½φ₀ is rounded near the top
    CHECK(excess(Cheeks::none, 0.3, phi0) == within_relative(1 / a - 1, 1e-13 + conditioning, "as stated"));
  }
  // On cycloids T is an elliptic integral: 2√2 ∫ √((κ + 1 − ss)/(1 − ss)) dα, s = sin φ₀ sin α.
  for(const double k : {1e-12, 1e-6, 1e-3, 0.1})
    for(const double phi0 : {1.0, 1.5, 1.57, 1.5707963, 1.570796326794896})
    {
      const Fifty kk = Fifty(k) * k, c0 = cos(Fifty(phi0));
      const Fifty integral =
          integrate_from_ends(
              [&](const Fifty& alpha, const Fifty& to_end) {
                const Fifty sine = alpha < 1 ? sin(alpha) : cos(to_end),
                            cosine = alpha < 1 ? cos(alpha) : sin(to_end);
                const Fifty cc = c0 * c0 * sine * sine + cosine * cosine;
                return kk * (1 - cc) / (cc * (1 + kk)) / (1 + sqrt((kk + cc) / (cc * (1 + kk))));
              },
              0, pi() / 2, Fifty("1e-25"))
              .value;
      CHECK(excess(Cheeks::cycloids, k, phi0)
            == within_relative(2 * integral / pi(), 1e-13, "the stated error"));
    }
}

TEST_CASE("near the end of a truncated curve, where r goes to zero, the time is still right")
{
  for(const double k : {0.02, 0.1, 0.3})
    for(const Cheeks cheeks : {Cheeks::euler_kk, Cheeks::euler_k4})
    {
      const double phi0 = largest_amplitude(cheeks, k) * (1 - 1e-3);
      CHECK(excess(cheeks, k, phi0)
            == within_relative(excess(radius_on(cheeks, k), k, phi0), 1e-13, "the stated error"));
      CHECK_THROWS_AS(excess(cheeks, k, largest_amplitude(cheeks, k) * (1 + 1e-9)), std::domain_error);
    }
}

TEST_CASE("the reference times, and what is refused")
{
  CHECK(swing_time(Cheeks::cycloids, 0.1, 30 * degree)
        == within_ulps(Fifty("4.46845955697901495197415370652"), 3, "k and the angle are rounded"));
  CHECK(swing_time(Cheeks::euler_kk, 0.1, 30 * degree)
        == within_ulps(Fifty("4.4651919831379511120708240144"), 3, "k and the angle are rounded"));
  CHECK(swing_time(Cheeks::euler_k4, 0.1, 30 * degree)
        == within_ulps(Fifty("4.46505163457804366671258770483"), 3, "k and the angle are rounded"));
  CHECK(swing_time(Cheeks::cycloids, 0.1, 85 * degree)
        == within_ulps(Fifty("4.66824149048720613564727377285"), 3, "k and the angle are rounded"));
  CHECK(86400 * excess(Cheeks::euler_k4, 0.02, 5 * degree)
        == within_relative(Fifty("9.795224502e-8"), 1e-9, "ten digits of the reference"));
  for(const double bad : {0.0, -0.1, 1.5707963267948968, 4.0, std::nan("")})
    CHECK_THROWS_AS(excess(Cheeks::cycloids, 0.1, bad), std::domain_error);
  CHECK_THROWS_AS(excess(Cheeks::none, 0.1, 3.15), std::domain_error);
  for(const double bad : {-1e-9, 1e21, std::nan("")})
    CHECK_THROWS_AS(excess(Cheeks::cycloids, bad, 0.1), std::domain_error);
}

TEST_CASE("the defect of §26 is what CQ, MH and GT make of it")
{
  for(const double k : {0.02, 0.1, 0.3})
    for(const Cheeks cheeks : all)
      for(const double phi : {1e-5, 0.1, 0.5})
      {
        const Laurent<Fifty> r_ = radius_on(cheeks, k);
        const Fifty c = cos(Fifty(phi)), r = r_(c), q = Fifty(k) * k, sine = sin(Fifty(phi));
        const Fifty x = integral(r_)(Fifty(1)) - integral(r_)(c);
        const Fifty ratio = 2 * x * (q + r * r) / ((1 + q) * r * r * sine * sine) - 1;
        CHECK(defect(cheeks, k, phi) == within_relative(ratio, 1e-14, "the stated error"));
      }
}

TEST_CASE("the fast integral: two ulps to 1.4 rad, the same bits from every set of instructions")
{
  struct Curve
  {
    Laurent<double> r;
    double k;
  };
  const Laurent<double> c(1.0, 1);
  const Curve curves[] = {{Laurent<double>(1), 0.2},
                          {c, 0.2},
                          {c, 0.0},
                          {Laurent<double>(0.1) + 0.7 * c + 0.05 * c * c + 0.15 * c * c * c, 0.2},
                          {Laurent<double>(2.0) - 1.5 * c + 0.5 * c * c * c * c, 0.4},
                          {c + Laurent<double>(0.01, 1) - Laurent<double>(0.01, -3), 0.1}};
  for(const Curve& curve : curves)
  {
    const Path path(curve.r, curve.k);
    Laurent<Fifty> r;
    for(int i = curve.r.lowest(); i <= curve.r.highest(); ++i)
      r += Laurent<Fifty>(Fifty(curve.r[i]), i);
    const Fifty small = pi() * sqrt(2 * (1 + Fifty(curve.k) * curve.k));
    for(const double phi0 : {1e-3, 0.1, 0.3, 1.0, 1.2, 1.4})
    {
      if(r(cos(Fifty(phi0))) < 0.01)
        continue;
      CHECK(path.swing_time(phi0)
            == within_ulps(small * (1 + excess(r, curve.k, phi0)), curve.r.lowest() < 0 ? 4 : 2,
                           "the stated error; powers of 1/c bring their own"));
    }
    const Fifty lowest =
        pi() * sqrt(2 * (r(Fifty(1)) * r(Fifty(1)) + Fifty(curve.k) * curve.k) / r(Fifty(1)));
    CHECK(path.swing_time(1e-8) == within_ulps(lowest, 2, "no difference of cosines is taken"));
    CHECK(path.swing_time(1e-150) == within_ulps(lowest, 2, "nor does it matter how small"));
    for(std::size_t i = 0; i < kernels::variants().count; ++i)
      for(const double phi0 : {1e-8, 0.7, 1.0})
        CHECK(path.swing_time(phi0, kernels::variants().sum[i]) == path.swing_time(phi0));
  }
  CHECK_THROWS_AS(Path(Laurent<double>(1.0, -1), 0.1), std::domain_error);
  CHECK_THROWS_AS(Path(Laurent<double>(1.0, 24), 0.1), std::domain_error);
  CHECK_THROWS_AS(Path(c, -1), std::domain_error);
  CHECK_THROWS_AS(Path(c, 0.1).swing_time(0), std::domain_error);
  CHECK_THROWS_AS(Path(c, 0.1).swing_time(3.0), std::domain_error);  // the curve has come down again
  CHECK_THROWS_AS(Path(c, 0.1).swing_time(std::nan("")), std::domain_error);
}

TEST_CASE("GZ, GH, the forces: the worked point, the limits, and differences of the motion")
{
  const double phi0 = 20 * degree, phi = 10 * degree;
  const auto there = on_cycloids(phi0, phi);
  CHECK(GZ(there, 0.1) == within_relative(Fifty("0.009246049915336488887162384"), 1e-14, "stated"));
  CHECK(cycloidal_GZ(0.1, phi0, phi)
        == within_relative(Fifty("0.009246049915336488887162384"), 1e-14, "stated"));
  CHECK(GH(there, 0.1) == within_relative(Fifty("0.01015426611885744985234218"), 1e-14, "stated"));
  CHECK(std::sqrt(turning2(there, 0.1))
        == within_relative(Fifty("0.2104874169187383700968054"), 1e-14, "stated"));
  CHECK(speed_height(there, 0.1)
        == within_relative(Fifty("0.04296899488992135933445379"), 1e-14, "stated"));
  // P b = 0.00159... M in Euler's example, and P = M r sin φ/(r + b)
  CHECK(force(there, 0.1) * GZ(there, 0.1)
        == within_relative(Fifty("0.001590625833293136252161118"), 1e-14, "stated"));
  for(const double k : {1e-100, 1e-8, 0.02, 0.3, 1.0})
    for(const double widest : {1e-100, 1e-3, 0.5, 1.5})
      for(const double part : {0.0, 1e-9, 0.5, 1 - 1e-12, 1.0})
      {
        const double at_ = widest * part;
        const auto got = on_cycloids(widest, at_);
        const auto exactly = on_cycloids(Fifty(widest), Fifty(at_));
        const Fifty b = GZ(exactly, Fifty(k));
        CHECK(cycloidal_GZ(k, widest, at_) == within_relative(b, 1e-14, "every term is positive"));
        CHECK(force(got, k)
              == within_relative(exactly.r * exactly.sin / (exactly.r + b), 1e-14, "moments about M, §16"));
        CHECK(tension(got, k) == within_relative(tension(exactly, Fifty(k)), 1e-14, "stated"));
        CHECK(cycloidal_GZ(k, widest, at_)
              <= GH(got, k) * (1 + 1e-15));  // not greater, as the paper has it
      }
  // Energy: the height due to the rotation and v together are what has fallen.
  const Fifty k("0.3"), angle("0.4"), most("0.6");
  const auto p = on_cycloids(most, angle);
  CHECK(speed_height(p, k) + k * k * turning2(p, k) == within_relative(p.to_rise, 1e-48, "§18"));
  CHECK(turning2(p, k) == within_relative(turning2_by_motion(k, most, angle), 1e-25, "stated"));
  const Fifty h("1e-15");
  const auto turning_at = [&](const Fifty& x) { return turning2(on_cycloids(most, x), k); };
  CHECK(twice_acceleration(p, k)
        == within((turning_at(angle + h) - turning_at(angle - h)) / (2 * h), 1e-28, "d(φ'²)/dφ = 2φ''"));
  const auto on = on_circle(most, angle);
  CHECK(twice_acceleration(on, k)
        == within(-sin(angle) / (1 + k * k), 1e-48, "a rigid body about a fixed axis"));
  CHECK(GZ(on, k) == within(GH(on, k), 1e-48, "with a fixed axis Z is the centre of oscillation"));
  CHECK(across(on, k)
        == within(k * k * sin(angle) / (1 + k * k), 1e-48, "the reaction across a rigid rod"));
}

TEST_CASE("a place on any cheeks: r, its shortening and c − x are those of the series; two weights move so")
{
  for(const double k : {0.02, 0.1, 0.3})
    for(const Cheeks cheeks : all)
      for(const double phi0 : {1e-8, 0.2, 0.8})
        for(const double part : {0.0, 1e-9, 0.5, 1 - 1e-12, 1.0})
        {
          const double phi = phi0 * part;
          const Laurent<Fifty> r = radius_on(cheeks, k), falling = integral(r), dr = derivative(r);
          const Fifty c = cos(Fifty(phi));
          const auto got = on_cheeks(cheeks, k, phi0, phi);
          CHECK(got.r == within(r(c), 1e-14 * (1 + k * k * 40), "stated"));
          CHECK(got.shortening == within_relative(dr(c), 1e-14, "stated, and dr/dφ is −sin φ dr/dc"));
          const Fifty rise = falling(c) - falling(cos(Fifty(phi0)));
          CHECK(got.to_rise == within_relative(rise, 3e-14, "the sum of the terms is at most thrice it"));
        }
  const Fifty k("0.3"), most("0.6"), angle("0.4");
  for(const Cheeks cheeks : {Cheeks::none, Cheeks::cycloids, Cheeks::euler_kk, Cheeks::euler_k4})
  {
    const Laurent<Fifty> r = radius_on(cheeks, k);
    const auto at_ = on_cheeks(cheeks, k, most, angle);
    const Fifty w = turning2_by_motion(r, k, most, angle);
    const Accelerations of = accelerations(r, k, w, angle);
    CHECK(w == within_relative(turning2(at_, k), 1e-25, "stated"));
    CHECK(of.turning == within_relative(twice_acceleration(at_, k), 1e-24, "stated"));
    CHECK(-of.across == within_relative(force(at_, k), 1e-24, "stated"));
    CHECK(cos(angle) + of.along == within_relative(tension(at_, k), 1e-24, "stated"));
    CHECK(-of.turning * k * k / force(at_, k) == within_relative(GZ(at_, k), 1e-24, "stated"));
  }
}

TEST_CASE("what the free part bears across loses near Z = G what the header says, and P·GZ/r does not")
{
  for(const double k : {1e-12, 1e-3, 0.1, 10.0})
    for(const double most : {30.0, 80.0, 89.0})
      for(double at = 1; at <= most; at += 9.3)
      {
        const double phi0 = most * degree, phi = at * degree;
        const auto exactly = on_cycloids<Fifty>(phi0, phi);
        const Fifty R = across<Fifty>(exactly, k), kk = Fifty(k) * k, c0 = cos(Fifty(phi0));
        const auto p = on_cycloids(phi0, phi);
        const auto lost = static_cast<double>((kk + exactly.r * exactly.r) / (kk + c0 * c0));
        CHECK(across(p, k) == within_relative(R, 1e-14 + 1e-15 * lost, "as documented"));
        CHECK(force(p, k) * cycloidal_GZ(k, phi0, phi) / p.r
              == within_relative(R, 3e-14, "the angle's rounding near 90°"));
      }
}

TEST_CASE("M runs along the cheek with the thread, G across it")
{
  const Fifty h("1e-15");
  for(const char* const at : {"0.1", "0.8", "1.5"})
  {
    const Fifty x(at), s = sin(x), c = cos(x);
    const auto up = cycloidal_places<Fifty>(x + h), low = cycloidal_places<Fifty>(x - h);
    CHECK((up.q - low.q) / (2 * h) == within(s * s, 1e-28, "ds = sin φ dφ"));
    CHECK((up.p - low.p) / (2 * h) == within(s * c, 1e-28, "ds = sin φ dφ"));
    CHECK((up.G_aside - low.G_aside) / (2 * h) == within(c * c, 1e-28, "r = cos φ"));
    CHECK((up.G_down - low.G_down) / (2 * h) == within(-c * s, 1e-28, "r = cos φ"));
  }
}

TEST_CASE("a body on any curve that is a polynomial in 1 − cos φ: the same excess as by its times")
{
  using Polynomial = Mechanism::Polynomial;
  const Polynomial h(Fifty(1), 1);
  for(const double k : {0.0, 1e-9, 0.1, 0.7, 30.0})
    for(const double phi : {1e-120, 1e-8, 0.1, 1.0, 1.47})
    {
      const Polynomial c = Polynomial(1) - h, kk(Fifty(k) * k);
      if(phi > 1e-100 || k > 1e-5)
        CHECK(Mechanism(kk + c * c, c).excess(phi)
              == within_relative(excess(Cheeks::cycloids, k, phi), phi > 1.4 ? 1e-13 : 5e-15, "stated"));
      CHECK(Mechanism(kk + Polynomial(1), 1).excess(phi)
            == within_relative(excess(Cheeks::none, k, phi), 5e-15, "about a fixed axis"));
    }
  CHECK(
      Mechanism(1, 1).excess(3.1)
      == within_relative(excess(Cheeks::none, 0, 3.1), 1e-12, "near the top the angle's rounding counts"));
  // another curve, against the quadrature of §19 in fifty digits
  const Polynomial r = Polynomial(1) - Polynomial(Fifty("0.7")) * h + Polynomial(Fifty("0.2")) * h * h;
  const Laurent<Fifty> u = Laurent<Fifty>(1) - Laurent<Fifty>(1, 1);  // h in powers of cos φ
  const Laurent<Fifty> radius =
      Laurent<Fifty>(1) - Laurent<Fifty>(Fifty("0.7")) * u + Laurent<Fifty>(Fifty("0.2")) * u * u;
  const Mechanism body(Polynomial(Fifty("0.25")) + r * r, r);
  for(const double phi : {0.2, 1.0, 1.5})
    CHECK(body.excess(phi)
          == within_relative(excess(radius, Fifty("0.5"), Fifty(phi)), 1e-13, "another integral"));
  CHECK(body.small_swing() == within_relative(pi() * sqrt(Fifty("2.5")), 4e-16, "2π√(½·1,25)"));
  CHECK(body.swing_time(1.0)
        == within_relative(pi() * sqrt(Fifty("2.5")) * (1 + Fifty(body.excess(1.0))), 7e-16, "a product"));
  CHECK_THROWS_AS(body.excess(0), std::domain_error);
  CHECK_THROWS_AS(body.excess(std::numbers::pi), std::domain_error);
  CHECK_THROWS_AS(body.excess(std::nan("")), std::domain_error);
  CHECK_THROWS_AS(Mechanism(1, Polynomial(1) - h).excess(1.6), std::domain_error);
  CHECK_THROWS_AS(Mechanism(h, 1), std::domain_error);
  CHECK_THROWS_AS(Mechanism(1, Polynomial(Fifty(1), -1) + Polynomial(1)), std::domain_error);
}

TEST_CASE("where a swing is at a time: as its equation of motion says, wide and near the end of its curve")
{
  struct Scene
  {
    Cheeks cheeks;
    int order;  // of the curve's series; -1: a circle
    double k, phi0;
  };
  const double last = largest_amplitude(Cheeks::euler_k4, 0.3);
  for(const Scene& now :
      {Scene{Cheeks::none, -1, 0, 1.5}, Scene{Cheeks::cycloids, 0, 0, 1.5},
       Scene{Cheeks::cycloids, 0, 5, 0.7}, Scene{Cheeks::euler_kk, 1, 0.3, 0.5},
       Scene{Cheeks::euler_k4, 2, 0.02, 1.2}, Scene{Cheeks::euler_k4, 2, 0.3, 0.99 * last}})
  {
    const Fifty k = now.k, phi0 = now.phi0;
    const Laurent<Fifty> r = now.order < 0 ? Laurent<Fifty>(Fifty(1)) : truncated(now.order, k);
    const Timed_swing swing(now.cheeks, now.k, now.phi0);
    CHECK(
        swing.time()
        == within_relative(pi() * sqrt(2 * (1 + k * k)) * (1 + excess(r, k, phi0)), 5e-15, "the header's"));
    const double fastest =
        std::sqrt(turning2(on_cheeks<double>(now.cheeks, now.k, now.phi0, 0), now.k)) * swing.time();
    std::vector<Fifty> times;
    for(const double part : {1e-9, 0.13, 0.499, 0.5, 0.87, 1.0, 1.7, 2.0, 3.3})
      times.emplace_back(part * swing.time());
    const std::vector<On_curve> places = places_by_motion(r, k, phi0, times);
    for(std::size_t i = 0; i < times.size(); ++i)
      CHECK(swing.angle(static_cast<double>(times[i]))
            == within(places[i].phi, 1e-14 * fastest * (1 + static_cast<double>(times[i]) / swing.time()),
                      "the header's"));
    const On_curve& late = places.back();
    CHECK(late.r == r(cos(late.phi)));
    CHECK(late.x
          == within(
              integrate([&](const Fifty& at) -> Fifty { return r(cos(at)) * sin(at); }, 0, late.phi).value,
              1e-16, "the header's"));
    CHECK(late.y
          == within(
              integrate([&](const Fifty& at) -> Fifty { return r(cos(at)) * cos(at); }, 0, late.phi).value,
              1e-16, "the header's"));
  }
}

TEST_CASE("where the smallest swings are at a time is a cosine; and what is no swing is refused")
{
  for(const double phi0 : {1e-9, 1e-150, 1e-300})
    for(const double k : {0.0, 0.3, 1e20})
    {
      const Timed_swing swing(Cheeks::cycloids, k, phi0);
      CHECK(swing.time() == within_relative(small_swing(k), 5e-15, "the header's"));
      CHECK(swing.angle(0) == within_relative(phi0, 1e-15, "a sine and its arc"));
      for(const double part : {0.1, 1.0 / 3, 0.9, 1.5, 7.75})
        CHECK(swing.angle(part * swing.time())
              == within(phi0 * cos(pi() * Fifty(part)), 4e-14 * phi0 * (1 + part),
                        "the header's, π φ₀ the fastest"));
    }
  CHECK(Timed_swing(Cheeks::cycloids, 0.3, 5e-324).angle(1)
        == within(0, 5e-324, "there is nothing smaller"));
  const double half_pi = std::numbers::pi / 2, nan = std::nan("");
  for(const double phi0 : {0.0, -0.1, half_pi, nan})
    CHECK_THROWS_AS(Timed_swing(Cheeks::cycloids, 0.1, phi0), std::domain_error);
  for(const double k : {-0.1, 2e20, nan})
    CHECK_THROWS_AS(Timed_swing(Cheeks::cycloids, k, 0.1), std::domain_error);
  CHECK_THROWS_AS(Timed_swing(Cheeks::euler_k4, 0.3, largest_amplitude(Cheeks::euler_k4, 0.3)),
                  std::domain_error);
  CHECK_THROWS_AS(hung_between(Cheeks::none, 0.3, 0.1, 4, 4), std::domain_error);
  CHECK_THROWS_AS(hung_on_highest(0.3, 0.1, 5, 5), std::domain_error);
  CHECK_THROWS_AS(hung_on_highest(0.3, 1.2, 6, 6), std::domain_error);
}
