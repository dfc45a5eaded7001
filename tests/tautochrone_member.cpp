/// @file
/// The exact tautochrones in double, and the analytic one, against fifty digits by another equation.
#include "edition/compare.hpp"
#include "exact/series.hpp"
#include "tautochrone/analytic.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/member.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

using namespace exact;
using namespace tautochrone;
using edition::within;
using edition::within_relative;
using edition::within_ulps;

namespace
{

// The height that §25 asks of a tautochrone: 2ax (kk + rr) = (aa + kk) rr sin²φ.
Fifty height(const Fifty& k, const Fifty& phi, const Fifty& r)
{
  return (1 + k * k) * r * r * sin(phi) * sin(phi) / (2 * (k * k + r * r));
}

}  // namespace

TEST_CASE("both ends are the closed forms")
{
  for(const double k : {1e-300, 1e-9, 0.02, 0.3, 0.7, 0.99, 1 - 0x1p-53})
  {
    const Position high = end(Member::highest, k), wide = end(Member::widest, k);
    const Point high_exactly = highest_end(k), wide_exactly = widest_end(k);
    CHECK(high.phi == within_ulps(high_exactly.phi, 6, "a quotient, a root and an arc tangent"));
    CHECK(high.r == within_ulps(high_exactly.r, 6, "a product, two sums and a root"));
    CHECK(high.x == within_ulps(high_exactly.x, 6, "two products"));
    CHECK(high.s == within_relative(1 - high_exactly.r, 2e-15, "a product and a quotient"));
    CHECK(wide.phi == within_ulps(wide_exactly.phi, 6, "two quotients and an arc tangent"));
    CHECK(wide.r == k);
    CHECK(wide.x == within_ulps(wide_exactly.x, 8, "four products"));
    CHECK(wide.s == 1 - k);
  }
}

TEST_CASE("the highest curve from stiff to tiny, at its end, half-way and near the lowest point")
{
  for(const double k : {0.001, 0.02, 0.3, 0.7, 0.99})
  {
    const double last = end(Member::highest, k).phi;
    std::vector<Fifty> angles;
    for(const double part : {1e-3, 0.05, 0.5, 0.9999})
      angles.emplace_back(part * last);
    const std::vector<Fifty> radii = highest(k, angles);
    for(std::size_t i = 0; i < angles.size(); ++i)
    {
      const Position got = at(Member::highest, k, static_cast<double>(angles[i]));
      CHECK(got.r == within_relative(radii[i], 1e-14, "the stated error"));
      CHECK(got.x == within_relative(height(k, angles[i], radii[i]), 1e-14, "the stated error"));
      CHECK(got.s == within_relative(1 - radii[i], 2e-14, "the stated error, and 28 digits of the oracle"));
    }
  }
}

TEST_CASE(
    "the highest curve of a body however small, up to where it ends, is Euler's with both corrections")
{
  for(const double k : {1e-9, 1e-6, 1e-4})
    for(const double phi : {1e-9, 0.5, 1.0, 1.55})
    {
      const Fifty c = cos(Fifty(phi)), kk = Fifty(k) * k;
      const Fifty r = c - kk * (1 - pow(c, 4)) / pow(c, 3) - 6 * kk * kk * (1 - c * c) / pow(c, 7);
      if(kk <= Fifty("1e-6") * pow(c, 4))
        CHECK(at(Member::highest, k, phi).r == within_relative(r, 1e-14, "the library's bound"));
    }
  for(const double k : {0.0009, 0.0011})  // on both sides of the seam
    CHECK(at(Member::highest, k, 0.2).r
          == within_relative(highest(Fifty(k), Fifty(0.2)), 1e-14, "its bound"));
}

TEST_CASE("near 90°, where the curve of a small body ends, r has the digits of the cosine")
{
  for(const auto& [k, phi] : {std::pair{1e-9, 1.57075},
                              {1e-9, 1.57071},
                              {1e-9, 1.5705},
                              {1e-6, 1.56},
                              {1e-4, 1.5},
                              {1e-3, 1.4},
                              {2e-3, 1.45},
                              {0.02, 1.3}})
  {
    const Position got = at(Member::highest, k, phi);
    const Fifty r = highest(Fifty(k), Fifty(phi));
    CHECK(got.r == within_relative(r, 2e-15, "some roundings"));
    CHECK(got.x == within_relative(height(k, phi, r), 2e-15, "the same"));
    CHECK(got.s == within_relative(1 - r, 2e-15, "the same"));
  }
}

TEST_CASE("the widest curve, which leaves Euler's half-way up")
{
  for(const double k : {0.1, 0.3, 0.9})
  {
    const Point last = widest_end(k);
    std::vector<Fifty> angles;
    for(const double part : {0.05, 0.3, 0.5, 0.7, 0.9999})
      angles.emplace_back(part * static_cast<double>(last.phi));
    const std::vector<Fifty> radii = through(k, last.phi, last.r, angles);
    for(std::size_t i = 0; i < angles.size(); ++i)
    {
      const Position got = at(Member::widest, k, static_cast<double>(angles[i]));
      CHECK(got.r == within_relative(radii[i], 1e-13, "the stated error"));
      CHECK(got.x == within_relative(height(k, angles[i], radii[i]), 1e-13, "the stated error"));
    }
  }
}

TEST_CASE("the reference values of the two curves, found by two other integrators")
{
  struct Row
  {
    double k;
    Member member;
    int degrees;
    const char *r, *x;
  };
  // Taylor series in φ, and in the arc of the virtual curve, with thirty-five digits.
  for(const Row& row :
      {Row{0.3, Member::highest, 40, "0.52774307459556211843269900054898", "0.1701860897508417356032354"},
       Row{0.3, Member::widest, 40, "0.33020211853085364633855302639799", "0.12335738636556119968101494"},
       Row{0.1, Member::highest, 70, "0.30185075543461239030237470995565", "0.40182483558391930446061233"},
       Row{0.1, Member::widest, 40, "0.22060483202626613840320548830965", "0.17308773457059733148040965"},
       Row{0.02, Member::highest, 60, "0.4969010710513600449408009444", ""}})
  {
    // The angle and k as they are meant, not as their doubles: conditioned by dr/dφ and dr/dk.
    const Position got = at(row.member, row.k, row.degrees * std::numbers::pi / 180);
    CHECK(got.r == within_relative(Fifty(row.r), 2e-15, "some roundings, and those of k and the angle"));
    if(*row.x != 0)
      CHECK(got.x == within_relative(Fifty(row.x), 2e-15, "some roundings, and those of k and the angle"));
  }
}

TEST_CASE("at angles as small as doubles can be, r is one and s falls with the square of the angle")
{
  for(const double k : {0.02, 0.1, 0.3, 0.5})
    for(const double phi : {1e-300, 1e-100, 1e-20})
    {
      const Position got = at(Member::highest, k, phi);
      CHECK(got.r == 1);
      const Fifty first = (1 + Fifty(k) * k) / (1 - 3 * Fifty(k) * k) / 2 * phi * phi;
      // Beyond κ = 1/3 the square is not the lowest power; before, the next is φ^((1 - kk)/kk) or φ⁴.
      CHECK(got.s == within_relative(first, phi < 1e-160 ? 1 : 1e-12, "the square underflows at 1e-300"));
    }
  CHECK(at(Member::highest, 0.3, 0).r == 1);
  CHECK(at(Member::highest, 0.3, 5e-324).r == 1);
}

TEST_CASE("between κ = 1/3 and 1 the deviation is a power of the angle smaller than two")
{
  for(const double k : {0.7, 0.9})
  {
    const double nu = (1 - k) * (1 + k) / (k * k);
    // Where the angle's square is nothing the flow is linear: Y = A + kB, Z = kA + B, B/A as A^nu.
    struct Parts
    {
      double A, ratio;
    };
    const auto parts = [&](double phi) {
      const double kk = k * k, s = at(Member::highest, k, phi).s, b = s / ((1 - k) * (1 + k) - s);
      return Parts{phi / std::hypot(1 + kk * b, k * (1 + b)), b};
    };
    const Parts far = parts(1e-30), near_ = parts(1e-40);
    CHECK(std::log(far.ratio / near_.ratio) / std::log(far.A / near_.A)
          == within(Fifty(nu), 1e-13, "some hundred roundings in each, over ln 10¹⁰"));
  }
}

TEST_CASE("a body that resonates, and its neighbours, have the same highest curve within their distance")
{
  for(const int odd : {3, 7})
  {
    const double k = 1 / std::sqrt(odd), phi = 0.5 * end(Member::highest, k).phi;
    const double there = at(Member::highest, k, phi).r;
    for(const double off : {-1e-9, 1e-9})
      CHECK(at(Member::highest, k * (1 + off), phi).r
            == within_relative(there, 2e-8, "dr/dk is no greater than at other k: here below 10/a"));
    CHECK(there == within_relative(highest(k, phi), 1e-14, "the stated error"));
  }
}

TEST_CASE("through any point of the region passes one; outside it none that can be wound")
{
  for(const double r : {0.2, 0.5})
  {
    const Position got = at_through(0.3, 0.7, r, 0.35);
    CHECK(got.r == within_relative(through(0.3, 0.7, r, {Fifty(0.35)})[0], 1e-14, "as for the highest"));
    CHECK(at_through(0.3, 0.7, r, 0.7).r == within_ulps(r, 4, "k Y/Z gives it back"));
  }
  CHECK_THROWS_AS(at_through(0.3, 0.7, 0.8, 0.35), std::domain_error);
  CHECK_THROWS_AS(at_through(0.3, 0.7, 0.05, 0.35), std::domain_error);
  CHECK_THROWS_AS(at_through(0.3, 0.7, 0.5, 0.8), std::domain_error);
}

TEST_CASE("many places on one way down are those that are found one by one")
{
  for(const Member member : {Member::highest, Member::widest})
    for(const double k : {0.005, 0.02, 0.1, 0.3, 0.6, 0.99})
    {
      const double last = end(member, k).phi;
      const std::vector<double> angles{0,          5e-324,      1e-200,       1e-12,
                                       1e-5,       0.01 * last, 0.1 * last,   0.11 * last,
                                       0.5 * last, 0.9 * last,  0.999 * last, last};
      const std::vector<Position> places = along(member, k, angles);
      for(std::size_t i = 0; i < angles.size(); ++i)
      {
        const Position alone = at(member, k, angles[i]);
        CHECK(places[i].phi == angles[i]);
        CHECK(places[i].r == within_relative(alone.r, 1e-13, "the header's, of both"));
        CHECK(places[i].x == within_relative(alone.x, 2e-13, "the same, and the square of Y"));
        CHECK(places[i].s == within(alone.s, 1e-13 * alone.s + 1e-300, "the same, and what underflows"));
      }
    }
  CHECK(along(Member::highest, 0.3, {}).empty());
  CHECK(
      along(Member::highest, 1e-6, {0.1, 1.2, 1.56}).back().r
      == within_relative(highest(Fifty(1e-6), Fifty(1.56)), 1e-13, "near 90° an ulp of the angle counts"));
  CHECK_THROWS_AS(along(Member::highest, 0.3, {0.2, 0.1}), std::domain_error);
  CHECK_THROWS_AS(along(Member::highest, 0.3, {0.1, 1.5}), std::domain_error);
  CHECK_THROWS_AS(along(Member::highest, 1.3, {0.1}), std::domain_error);
}

TEST_CASE(
    "64 places of a whole curve are those found one by one, right, and the same bits by every variant")
{
  for(const Member member : {Member::highest, Member::widest})
    for(const double k : {0.02, 0.1, 0.25, 0.3, 0.57, 0.8, 0.99})
    {
      const double last = end(member, k).phi, bound = member == Member::highest ? 1e-14 : 1e-13;
      std::vector<double> angles;
      for(int i = 1; i <= 64; ++i)
        angles.push_back(0.9999 * last * i / 64);
      const auto places = along(member, k, angles);
      for(std::size_t i = 0; i < places.size(); ++i)
      {
        const Position alone = at(member, k, angles[i]);
        CHECK(places[i].phi == angles[i]);
        CHECK(places[i].r == within_relative(alone.r, 2 * bound, "the header's, of both"));
        CHECK(places[i].x == within_relative(alone.x, 2 * bound, "the same"));
        CHECK(places[i].s == within_relative(alone.s, 2 * bound, "the same"));
      }
      if(k > 0.25)  // below, fifty digits take their time
      {
        const std::size_t some[]{2, 11, 35, 62};
        std::vector<Fifty> exactly;
        for(const std::size_t i : some)
          exactly.emplace_back(angles[i]);
        const Point tip = widest_end(k);
        const auto radii =
            member == Member::highest ? highest(k, exactly) : through(k, tip.phi, tip.r, exactly);
        for(std::size_t j = 0; j < exactly.size(); ++j)
        {
          const Position& now = places[some[j]];
          CHECK(now.r == within_relative(radii[j], bound, "the header's"));
          CHECK(now.x == within_relative(height(k, exactly[j], radii[j]), bound, "the header's"));
          CHECK(now.s == within_relative(1 - radii[j], bound, "the header's"));
        }
      }
      for(std::size_t variant = 0; variant < kernels::variants().count; ++variant)
      {
        const auto same = along(member, k, angles, kernels::variants().find[variant]);
        for(std::size_t i = 0; i < places.size(); ++i)
        {
          CHECK(same[i].r == places[i].r);
          CHECK(same[i].x == places[i].x);
          CHECK(same[i].s == places[i].s);
        }
      }
    }
}

TEST_CASE("arc, breadth and cheek of the highest curve; the height again as an integral")
{
  const double forty = 40 * std::numbers::pi / 180;
  const auto row = drawn(Member::highest, 0.3, {0, 0.1, forty, end(Member::highest, 0.3).phi});
  CHECK(row[0].z == 0);
  CHECK(row[2].z
        == within_relative(Fifty("0.57036915000727598004500406"), 1e-14, "some hundred roundings"));
  CHECK(row[2].y
        == within_relative(Fifty("0.53322311174704761834487428"), 1e-14, "some hundred roundings"));
  CHECK(row[2].p == within(Fifty("0.42553926056070359700303794"), 1e-15, "three differences"));
  CHECK(row[2].q == within(Fifty("0.1939964022991412273222671"), 1e-14, "y less r sin φ"));
  for(const double k : {0.02, 0.1, 0.7, 0.9})
    for(const Member member : {Member::highest, Member::widest})
    {
      const double last = end(member, k).phi;
      for(const Drawn& d : drawn(member, k, {0.01 * last, 0.5 * last, last}))
        CHECK(d.by_arc
              == within_relative(Fifty(d.at.x), k < 0.1 ? 1e-12 : 1e-13,
                                 "x = ½fSS is what makes the times equal"));
    }
}

TEST_CASE("equal times, over twelve decades of amplitude, by the integral of §19 with heights by the arc")
{
  // T/T₀ is the average of √((1 + D)) over x = x₀ sin²β, where the height is by the arc and 1 + D = 2CQ
  // MH/(AD GT).
  const double k = 0.3, last = end(Member::highest, k).phi;
  for(const double phi0 : {last, 0.1 * last, 1e-3 * last, 1e-6 * last, 1e-9 * last, 1e-12 * last})
  {
    std::vector<double> angles;
    for(int i = 1; i <= 24; ++i)
      angles.push_back(phi0 * std::sin(i * std::numbers::pi / 48));
    for(const Drawn& d : drawn(Member::highest, k, angles))
    {
      const double r = d.at.r, sine = std::sin(d.at.phi);
      const double defect = 2 * d.by_arc * (k * k + r * r) / ((1 + k * k) * r * r * sine * sine);
      CHECK(std::sqrt(defect) == within(Fifty(1), 1e-14, "then every average of it is T₀ as nearly"));
    }
  }
}

TEST_CASE("where there is no curve, none is told")
{
  for(const double k : {0.0, -0.3, 1.0, 1.5, 1e300, std::nan("")})
    CHECK_THROWS_AS(at(Member::highest, k, 0.1), std::domain_error);
  CHECK_THROWS_AS(at(Member::highest, 0.3, 0.95), std::domain_error);
  CHECK_NOTHROW(at(Member::widest, 0.3, 0.95));
  CHECK_THROWS_AS(at(Member::widest, 0.3, 1.0), std::domain_error);
  CHECK_THROWS_AS(at(Member::widest, 0.3, std::nan("")), std::domain_error);
  CHECK_THROWS_AS(drawn(Member::highest, 0.3, {0.5, 0.4}), std::domain_error);
  CHECK_THROWS_AS(drawn(Member::highest, 0.001, {0.5}), std::domain_error);
}

TEST_CASE("x_m and b_m in fractions are the polynomials in κ that they should be")
{
  for(const char* text : {"1/7919", "9/100", "2/5", "2", "10"})
  {
    const Rational q(text), one(1);
    const auto x = cosine_series(q, 4), b = radius_series(q, 4);
    CHECK(x[1] == -(1 + q) / 2);
    CHECK(x[2] == -(1 + q) * (1 + q) * (1 + q) / (8 * (1 - 3 * q)));
    const Rational third = (1 - 3 * q) * (1 - 3 * q), fifth = 1 - 5 * q, p2 = (1 + q) * (1 + q);
    CHECK(x[3] == -(1 - q) * p2 * p2 * (1 + q) / (16 * third * fifth));
    CHECK(x[4]
          == -p2 * p2 * p2 * (1 + q) * (5 + 3 * q * q) / (128 * third * (1 - 3 * q) * fifth * (1 - 7 * q)));
    CHECK(b[1] == -(1 + q) / (1 - 3 * q));
    CHECK(b[2] == -6 * q * p2 / (third * fifth));
    CHECK(b[3] == -2 * q * p2 * (1 + q) * (5 + 27 * q) / (third * (1 - 3 * q) * fifth * (1 - 7 * q)));
    CHECK(b[4]
          == 15 * q * p2 * p2 * (216 * q * q * q + 63 * q * q - 14 * q - 1)
                 / (third * third * fifth * fifth * (1 - 7 * q) * (1 - 9 * q)));
    // r = -f S/(dX/dS), term by term: b(h(S)) (dX/dS) + (1 + κ) S = 0
    const int n = 12;
    const auto xs = cosine_series(q, n + 1), bs = radius_series(q, n);
    std::vector<Rational> h = {0}, slope;
    for(int m = 1; m <= n; ++m)
      h.push_back(-xs[static_cast<std::size_t>(m)]);
    for(int m = 0; m <= n; ++m)
      slope.push_back(2 * (m + 1) * xs[static_cast<std::size_t>(m) + 1]);
    const Series<Rational> r = compose(Series<Rational>(bs, n), Series<Rational>(h, n));
    CHECK(r * Series<Rational>(slope, n) == Series<Rational>({-(1 + q)}, n));
  }
}

TEST_CASE("at the resonances there is a logarithm instead")
{
  CHECK(logarithmic_coefficient(Rational(1, 3)) == 2);
  CHECK(logarithmic_coefficient(Rational(1, 5)) == 27);
  CHECK(resonance(Rational(1, 99)) == 49);
  CHECK(resonance(Rational(1, 4)) == 0);
  CHECK(resonance(Rational(2, 3)) == 0);
  CHECK_THROWS_AS(radius_series(Rational(1, 5), 2), std::domain_error);
  CHECK_NOTHROW(radius_series(Rational(1, 5), 1));
  CHECK_THROWS_AS(cosine_series(Rational(1, 5), 3), std::domain_error);
  CHECK_THROWS_AS(logarithmic_coefficient(Rational(1, 4)), std::domain_error);
  // r = 1 + 2 h ln h + C h + ... on the highest curve, by differences of (r - 1)/h over a factor of e in h
  const double k = 1 / std::sqrt(3.0);
  const auto over_h = [&](double phi) {
    const double half = std::sin(phi / 2);
    return -at(Member::highest, k, phi).s / (2 * half * half);
  };
  CHECK(over_h(1e-8) - over_h(1e-8 / std::exp(1.0))
        == within(Fifty(4), 1e-10, "2 ln h, h as φφ; the next terms are of the order h ln²h"));
}

TEST_CASE("the analytic curve by its series, beyond it, and from either coordinate")
{
  // From power series with a residual below 1e-32.
  CHECK(analytic_at_arc(1, Fifty("0.2")).phi
        == within(Fifty("0.2809224326867400528387513132"), 1e-24, "stated"));
  CHECK(analytic_at_arc(1, Fifty("0.2")).r
        == within(Fifty("1.041678695307436886079037313"), 1e-24, "stated"));
  CHECK(analytic_at_arc(4, Fifty("0.2")).r
        == within(Fifty("1.04708762761795141065777329"), 1e-24, "stated"));
  CHECK(analytic_at_arc(Fifty("0.5"), Fifty("0.2")).r
        == within(Fifty("1.104608177351299373014477331"), 1e-24, "stated"));
  // For k = 0.3 forwards in fifty digits against backwards from the end.
  const Fifty degree = pi() / 180;
  CHECK(analytic_at_angle(Fifty("0.09"), 20 * degree).r
        == within(Fifty("0.86278185291636023827873669934"), 1e-24, "stated"));
  CHECK(analytic_at_angle(Fifty("0.09"), 40 * degree).r
        == within(Fifty("0.506014363284527808799193290531"), 1e-24, "stated"));
  for(const char* kappa : {"0.03", "0.09", "0.4", "1", "10"})
    for(const char* S : {"1e-100", "1e-3", "0.2", "0.26"})  // with κ = 0.4 it ends at S = 0.271
    {
      const Analytic by_arc = analytic_at_arc(Fifty(kappa), Fifty(S));
      const Analytic by_angle = analytic_at_angle(Fifty(kappa), by_arc.phi);
      CHECK(by_angle.S == within_relative(Fifty(S), 1e-25, "the stated digits"));
      CHECK(by_angle.r == within_relative(by_arc.r, 1e-25, "the stated digits"));
      CHECK(by_arc.x == within_relative(height(sqrt(Fifty(kappa)), by_arc.phi, by_arc.r), 1e-25, "§25"));
    }
  CHECK(analytic_at_arc(2, Fifty("0.2")).r > 1);  // k > a: the radius grows
  CHECK_THROWS_AS(analytic_at_arc(Fifty("0.4"), Fifty("0.28")), std::domain_error);
  CHECK_THROWS_AS(analytic_at_arc(4, Fifty("0.98")), std::domain_error);
  CHECK_THROWS_AS(analytic_at_arc(Fifty(1) / 3, Fifty("0.1")), std::domain_error);
  CHECK_THROWS_AS(analytic_at_arc(Fifty("0.001"), Fifty("0.1")), std::domain_error);
  CHECK_THROWS_AS(analytic_at_angle(1, -1), std::domain_error);
}
