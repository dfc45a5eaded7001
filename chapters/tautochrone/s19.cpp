#include <memory>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gsl/gsl_integration.h>

#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/path.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"
#include "tautochrone/thread.hpp"

SECTION(tautochrone, 19, "The time of a swing")

using namespace tautochrone;

/*!
## What Euler does

The time of one swing is written as an integral along the curve that the centre of gravity describes. Let
now this curve $CG$ be regarded as given; for from it the cheek $AMB$ is determined, and from the cheek
the curve. Its vertical abscissa is $CQ = x$, the arc already described $CG = z$, and the radius of
curvature $GM = r$. Then $a - s = r$ and $d\varphi = dz:r$. First, the height due to the speed of the
centre of gravity in $G$ is

$$ v = \frac{rr(c-x)}{kk+rr}, \tag{1} $$

from which it is plain that the pendulum will go on rising until $x = c$. Then the element of time is

$$ dt = \frac{dz\sqrt{kk+rr}}{r\sqrt{c-x}}, \tag{2} $$

and its integral, duly taken, gives the time in which the pendulum rises through any arc $CG = z$ to any
height $CQ = x$. If in it $x = c$ is put, one has the time of the whole rise. The fall that follows takes
as long, because nothing resists; and on the other side the pendulum moves on an equal curve. So the time
of one oscillation is

$$ T = 2\int\frac{dz\sqrt{kk+rr}}{r\sqrt{c-x}}, \tag{3} $$

if after the integration $x = c$ is put.

::: margin
His oscillation goes from one side to the other, half of today's period. Where $v$ is a height and $\sqrt
v$ the speed, $T$ is in a unit of which $\sqrt{2g}$ go to the second, with today's $g$.
:::

This is the point to which the mechanics has led: from here on only {{eq 3}} is needed. It is an improper
integral, for at $x = c$ its element is infinite; and yet the time is finite, as $c - x$ vanishes like
the first power of what is wanting to the angle. With $\varphi = \varphi_0\sin\alpha$ it becomes

$$ T = 2\int_0^{\pi/2}\sqrt{\frac{kk+rr}{c-x}}\;\varphi_0\cos\alpha\,d\alpha, \tag{A} $$

in which the cosine vanishes with the root, and nothing is infinite.

## The program

{{eq A}} as it stands would give the digits away that {{eq 3}} has: near the end both $c - x$ and
$\varphi_0 - \varphi$ are small differences. The latter is
$2\varphi_0\sin^2\tfrac12(\tfrac12\pi-\alpha)$, and $c - x$ a product that has its sine as a factor. The
cheeks are 0 for a fixed axis, 1 for cycloids, 2 and 3 for Euler's.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto cheeks = integer("cheeks", 1, 0, 3, "0 none, 1 cycloids, 2 Euler's with k², 3 with k⁴");
const auto phi0 =
    angle("phi0", 30_deg, closed(1e-7_deg, 89_deg), "how far the pendulum swings to either side");
const auto phi =
    angle("phi", within_swing(15_deg, phi0), closed(0_deg, 89_deg), "the angle to which it is timed");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

struct Swing  ///< what is integrated, a = 1
{
  Cheeks cheeks;  ///< what leads the thread
  double ratio;   ///< k/a
  double most;    ///< φ₀

  /// dt/dφ by (2), where φ₀ − φ is `wanting`.
  double element(double wanting) const
  {
    const double here = most - wanting;
    const auto at = on_cheeks<double>(cheeks, ratio, most, here);
    double rise = at.to_rise;
    if(cheeks == Cheeks::none)
      rise = 2 * std::sin(wanting / 2) * std::sin(most - wanting / 2);
    else if(here < most)
      rise *= std::sin(wanting) / std::sin(most - here);  // here is rounded, wanting is not
    else
      rise = at.r * at.sin * wanting;
    return std::hypot(ratio, at.r) / std::sqrt(rise);
  }

  /// dt/dα by (A).
  double smooth(double alpha) const
  {
    const double from_top = std::numbers::pi / 2 - alpha;
    return element(2 * most * std::pow(std::sin(from_top / 2), 2)) * most * std::sin(from_top);
  }
};

double risen_in(const Swing& swing, double to)  // the time from C to the angle `to`, (2): Gauss's rule in α
{
  using Doubles = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  const double last = std::asin(std::min(1.0, to / swing.most));
  boost::math::quadrature::gauss<double, 60, Doubles> rule;
  return rule.integrate([&](double alpha) { return swing.smooth(alpha); }, 0.0, last);
}

TELL
{
  const double ratio = k / a;
  require_ratio(ratio);
  const auto which = static_cast<Cheeks>(int(cheeks));
  require(phi0 < 0.99 * largest_amplitude(which, ratio), "phi0",
          "less than 99 hundredths of the angle at which the thread is all wound");
  require(phi <= phi0, "phi", "at most phi0");
  const double unit = std::sqrt(a) / (2 * std::sqrt(g)), T = swing_time(which, ratio, phi0);
  tell("T_clock", T, "the time of a swing in Euler's clock, a = 1, (3)");
  tell("T", T * unit, seconds, "the same in seconds");
  tell("risen", phi == 0 ? 0 : risen_in({which, ratio, phi0}, phi) * unit, seconds,
       "the time from C to the angle φ, (2)");
}

/*!
What rules for sums make of {{eq 3}} is told for a swing of 60° between cycloids, $k = \tfrac1{10}a$:
midpoints in φ, as {{eq 2}} stands; midpoints in α, by {{eq A}}; and the same with $c - x$ got by
subtraction.
*/

double midpoints(int n, double end,
                 const std::function<double(double)>& f)  // twice the integral from 0 to the end
{
  double sum = 0;
  for(int i = 0; i < n; ++i)
    sum += f((i + 0.5) * end / n);
  return 2 * sum * end / n;
}

double subtracted(double alpha)  // dt/dα, c − x by subtraction
{
  const double here = 60_deg * std::sin(alpha), c = std::cos(here), top = std::cos(60_deg);
  const double rise = (1 - top * top) / 2 - (1 - c * c) / 2;
  return std::sqrt((0.01 + c * c) / rise) * 60_deg * std::cos(alpha);
}

TELL
{
  curve("errors", {"nodes", "raw", "alpha", "subtracted"}, [](Curve& out) {
    const Swing swing{Cheeks::cycloids, 0.1, 60_deg};
    const double T = swing_time(Cheeks::cycloids, 0.1, 60_deg);
    const auto error = [T](double sum) { return std::abs(sum / T - 1) + 1e-17; };
    for(int n = 2; n <= 1 << 15; n += std::max(1, n / 8))
      out.put({double(n),
               error(midpoints(n, 60_deg, [=](double here) { return swing.element(60_deg - here); })),
               error(midpoints(n, std::numbers::pi / 2, [=](double alpha) { return swing.smooth(alpha); })),
               error(midpoints(n, std::numbers::pi / 2, subtracted))});
  });
}

/*!
A swing of {{phi0|deg0}} takes {{T|10}} s; the first {{phi|deg0}} of the rise take {{risen|8}} s of it.

::: figure tautochrone-19
alt: The relative error of the time against the number of places, both logarithmic. Midpoints in phi come
down along a gentle line, to a thousandth with thirty thousand places. Midpoints in alpha fall to the
last digits of a double with a dozen places. With subtracted heights they fall as fast and then the error
rises again.

The error of the time of a swing of 60°, by the number of places. In φ a hundred times as many places are
worth one digit; in α a dozen are enough. Heights that are subtracted (ochre) make the error *grow* with
the number of places, which come nearer and nearer to the end.
:::

## Speed against error

The integral {{eq A}} by the usual libraries' rules, {{eq 3}} itself by the one that is made for infinite
ends, and the edition's own, which forms $c - x$ as a divided difference.
*/

double by_qag(const Swing& swing)  // GSL's adaptive rule
{
  const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> room(
      gsl_integration_workspace_alloc(100), gsl_integration_workspace_free);
  gsl_function f{[](double alpha, void* of) { return static_cast<const Swing*>(of)->smooth(alpha); },
                 const_cast<Swing*>(&swing)};
  double result = 0, error = 0;
  gsl_integration_qag(&f, 0, std::numbers::pi / 2, 0, 1e-13, 100, GSL_INTEG_GAUSS31, room.get(), &result,
                      &error);
  return 2 * result;
}

Fifty exact_time(const Fifty& ratio)
{
  const auto r = cheeks == 0 ? exact::Laurent<Fifty>(1) : truncated(cheeks - 1, ratio);
  return exact::pi() * sqrt(2 * (1 + ratio * ratio)) * (1 + excess(r, ratio, phi0.fifty()));
}

TELL
{
  if(phi0 < 1e-3)
    return;  // the quadrature of fifty digits subtracts heights
  const double ratio = k / a;
  const auto which = static_cast<Cheeks>(int(cheeks));
  const Swing swing{which, ratio, phi0};
  const Path path(cheeks == 0 ? exact::Laurent<double>(1.0, 0) : truncated_in_double(cheeks - 1, ratio),
                  ratio);
  const auto smooth = [=](double alpha) { return swing.smooth(alpha); };
  const double quarter = std::numbers::pi / 2;
  std::vector<Method> ways{{"this edition", [=] { return path.swing_time(swing.most); }}};
  for(const int n : {8, 16, 32})
    ways.push_back({"midpoints in α, " + std::to_string(n), [=] { return midpoints(n, quarter, smooth); },
                    "midpoints"});
  ways.push_back({"midpoints in φ, 1000", [=] {
                    return midpoints(1000, swing.most,
                                     [=](double here) { return swing.element(swing.most - here); });
                  }});
  ways.push_back({"Boost gauss<20>", [=] {
                    return 2 * boost::math::quadrature::gauss<double, 20>::integrate(smooth, 0.0, quarter);
                  }});
  ways.push_back({"Boost gauss_kronrod<31>", [=] {
                    return 2
                           * boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                               smooth, 0.0, quarter, 10, 1e-13);
                  }});
  ways.push_back({"Boost tanh_sinh, in φ", [=] {
                    boost::math::quadrature::tanh_sinh<double> rule;
                    return 2
                           * rule.integrate(
                               [=](double here, double to_end) {
                                 return swing.element(to_end > 0 ? to_end : swing.most - here);
                               },
                               0.0, swing.most);
                  }});
  ways.push_back({"GSL qag", [=] { return by_qag(swing); }});
  race("time", "T in Euler's clock, a = 1", exact_time(k.fifty() / a.fifty()), ways);
}

/*!
## Checks

The judge of the whole time is a quadrature in fifty digits, with $r$ as a polynomial in the cosine and
its inverse, and heights summed from it.
*/

CHECK_THAT(
    "the time told is that of (3) in fifty digits, and all ways of the race come to it within their means")
{
  for(const Told& now :
      told_at("", "cheeks=0 phi0=60 a=2", "cheeks=2 k=0.2 phi0=45 phi=40", "cheeks=3 k=0.02 phi0=1 phi=1",
              "cheeks=3 k=2e39 a=1e40 phi0=40 phi=1", "k=0.05 phi0=80 phi=0 g=16"))
  {
    const Fifty T = exact_time(k.fifty() / a.fifty());
    CHECK(now.value("T_clock") == within_relative(T, 1e-15, "the library's three ulps, and the angle's"));
    CHECK(now.value("T", seconds)
          == within_relative(T * sqrt(a.fifty() / (4 * g.fifty())), 2e-15, "three roundings more"));
    CHECK(now.exact("time") == within_relative(T, 1e-24, "the quadrature"));
    const double wide = phi0 > 70_deg || (cheeks > 1 && phi0 > 35_deg) ? 1 : 0;  // near a place where r = 0
    const char* const rule = "twenty places and more, whose elements err by some ulps";
    CHECK(now.method("time", "this edition")
          == within_relative(T, 2e-15, "two ulps, and those of r's powers"));
    CHECK(now.method("time", "midpoints in α, 32") == within_relative(T, 5e-15 + 1e-9 * wide, rule));
    CHECK(now.method("time", "midpoints in α, 16") == within_relative(T, 5e-15 + 1e-5 * wide, rule));
    CHECK(now.method("time", "midpoints in α, 8") == within_relative(T, 1e-8 + 1e-3 * wide, "few places"));
    CHECK(now.method("time", "Boost gauss<20>") == within_relative(T, 1e-13 + 1e-6 * wide, rule));
    CHECK(now.method("time", "Boost gauss_kronrod<31>") == within_relative(T, 1e-13, "what was asked for"));
    CHECK(now.method("time", "GSL qag") == within_relative(T, 1e-13, "what was asked for"));
    CHECK(now.method("time", "Boost tanh_sinh, in φ")
          == within_relative(T, 1e-8, "the root of its last change"));
    CHECK(now.method("time", "midpoints in φ, 1000")
          == between(T * Fifty("0.9"), T, "the infinite end is missed"));
  }
}

CHECK_THAT("nine reference times, for three bodies on three curves out to 30°, and one for 85°, to all "
           "their digits")
{
  const char* const times[3][3]{{"4.44390885834605262632089054004", "4.44377166533180494191456496054",
                                 "4.44377142651126102788531286892"},
                                {"4.46845955697901495197415370652", "4.4651919831379511120708240144",
                                 "4.46505163457804366671258770483"},
                                {"4.66798324678503649497915329349", "4.65083588912069673078167180773",
                                 "4.64624919034289855260462239256"}};
  const double bodies[3]{0.02, 0.1, 0.3};
  for(std::size_t i{0}; i < 3; ++i)
    for(std::size_t j{0}; j < 3; ++j)
      CHECK(swing_time(static_cast<Cheeks>(1 + int(j)), bodies[i], 30_deg)
            == within_relative(Fifty(times[i][j]), 1e-15, "three ulps, and the angle's"));
  CHECK(
      swing_time(Cheeks::cycloids, 0.1, 85_deg)
      == within_relative(Fifty("4.66824149048720613564727377285"), 2e-15, "the same; it is near the end"));
}

/*!
The time to any height is looked at by following the motion: from the lowest place, with the speed that
it has there, for the time that is told. The accelerations are those of two weights ({{sec
tautochrone.14}}).
*/

CHECK_THAT("after the time told the body, which passed C with its greatest speed, is at the angle φ; and "
           "φ₀ takes half of T")
{
  for(const Told& now : told_at("", "cheeks=3 k=0.3 phi0=40 phi=39", "cheeks=0 k=2 a=5 phi0=80 phi=50 g=7",
                                "phi0=80 phi=1e-6"))
  {
    const Fifty A = a.fifty(), ratio = k.fifty() / A, unit = sqrt(A / (4 * g.fifty()));
    const auto r = cheeks == 0 ? exact::Laurent<Fifty>(1) : truncated(cheeks - 1, ratio);
    const auto motion = [&](const Fifty&, const exact::State& y) -> exact::State {
      return {y[1], accelerations(r, ratio, y[1] * y[1], y[0]).turning / 2};
    };
    const Fifty speed = sqrt(turning2_by_motion(r, ratio, phi0.fifty(), 0));
    const Fifty about = risen_in({static_cast<Cheeks>(int(cheeks)), k / a, phi0}, phi);
    const auto there = exact::solve(motion, 0, {0, speed}, about, Fifty("1e-24"));
    const Fifty time = about + (phi.fifty() - there.y[0]) / there.y[1];
    CHECK(now.value("risen", seconds) == within_relative(unit * time, 1e-13, "sixty places"));
  }
  for(const Told& now : told_at("phi=30", "phi0=60 phi=60 k=0.3", "cheeks=3 phi0=40 phi=40"))
    CHECK(now.value("risen", seconds)
          == within_relative(exact_time(k.fifty()) / (4 * sqrt(g.fifty())), 1e-13, "sixty places"));
  for(const Told& now : told_at("phi0=1e-6 phi=1e-6"))
  {
    const Fifty half = exact::pi() / 2 * sqrt((1 + pow(k.fifty(), 2)) / (2 * g.fifty()));
    CHECK(now.value("risen", seconds) == within_relative(half, 1e-13, "a narrow swing"));
  }
  for(const Told& now : told_at("phi=0"))
    CHECK(now.value("risen", seconds) == within(0, 0, "no time"));
}

CHECK_THAT(
    "it refuses an angle beyond the swing, one that winds up nearly all of the thread, and an extreme k")
{
  // with one correction r is zero where cos⁴φ = κ : (1 + κ), with both at 60° for 1152κκ + 15κ = 1
  for(const std::string body : {"cheeks=2 k=0.258198889747161126", "cheeks=2 a=2 k=0.516397779494322251",
                                "cheeks=3 k=0.153828149399070924", "cheeks=3 a=2 k=0.307656298798141847"})
  {
    CHECK(!refused_at(body + " phi=1 phi0=59.3999999999"));
    CHECK(refused_at(body + " phi=1 phi0=59.4000000001"));
  }
  for(const char* const within_them : {"phi0=30 phi=30", "phi0=60 phi=60"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"phi0=30 phi=30.00000000000001", "phi0=60 phi=60.00000000000003"})
    CHECK(refused_at(beyond));
  for(const char* const within_them : ratio_within)
    CHECK(!refused_at(within_them));
  for(const char* const beyond : ratio_beyond)
    CHECK(refused_at(beyond));
}

CHECK_THAT("in the figure the midpoints in φ err by ζ(½, ½) = −0.6049 times the root of a strip, the "
           "others as in fifty digits")
{
  const Fifty most = exact::pi() / 3, c0 = Fifty(1) / 2, kk("0.01");
  const Fifty T = exact::pi() * sqrt(2 * (1 + kk))
                  * (1 + excess(exact::Laurent<Fifty>(Fifty(1), 1), Fifty("0.1"), most));
  const Fifty last = sqrt((kk + c0 * c0) / (c0 * sin(most)));  // of 1 : √(φ₀ − φ) in dt/dφ
  for(const Told& now : told_at(""))
  {
    double worst = 0;
    for(const auto& point : now.points("errors"))
    {
      const int n = int(point.at("nodes"));
      const Fifty lost = Fifty("0.604898643421630370") * 2 * last * sqrt(most / n) / T;
      CHECK(point.value("nodes") == between(2, 1 << 15, "as many as that"));
      CHECK(point.value("raw") == within_relative(lost, 1.0 / n, "the next term"));
      if(n < 40)
      {
        Fifty sum = 0;
        for(int i = 0; i < n; ++i)
        {
          const Fifty alpha = (2 * i + 1) * exact::pi() / (4 * n), x = most * sin(alpha),
                      cc = pow(cos(x), 2);
          sum += sqrt((kk + cc) * 2 / (cc - c0 * c0)) * most * cos(alpha);
        }
        const Fifty error = abs(sum * exact::pi() / n / T - 1);
        CHECK(point.value("alpha") == within(error, 5e-15, "roundings"));
        CHECK(point.value("subtracted") == within(error, 1e-12, "heights that lose digits"));
      }
      else
      {
        CHECK(point.value("alpha") == between(0, 5e-15 + 1e-16 * std::sqrt(n), "a sum of n rounded terms"));
        CHECK(point.value("subtracted") == between(0, 1e-16 * n * n, "the last strip's height is as n⁻²"));
        worst = std::max(worst, point.at("subtracted"));
      }
    }
    CHECK(worst == between(1e-13, 1, "it has grown"));
    const auto all = now.points("errors");
    CHECK(all[10].at("nodes") == 12);
    CHECK(all[10].value("alpha") == between(0, 5e-15, "a dozen places are enough"));
    CHECK(all.back().value("nodes") == between(29'000, 1 << 15, "thirty thousand places"));
    CHECK(all.back().value("raw") == between(0.9e-3, 1.3e-3, "a thousandth"));
  }
}

/*!
## Notes

{{eq A}} needs no more than a dozen places because its element is a smooth and even function of α, with
the period π: for such the rule of midpoints converges as fast as a geometric progression. How fast, the
nearest place says where $kk + rr$ or $(c-x):\cos^2\alpha$ is zero, which lies among the complex numbers.

## Go on from here

::: exercise
How large is the part of the swing's time that the body spends in the last hundredth of its angle? Is it
one hundredth?

answer: For narrow swings the time grows as α, and $1 - \tfrac2\pi\arcsin 0.99$ is nine hundredths; the
program tells it with `--phi 29.7`, and the check below compares it.
:::
*/

CHECK_THAT("the last hundredth of a narrow swing takes nine hundredths of its time")
{
  const Swing swing{Cheeks::cycloids, 0.1, 1e-4};
  const double part = 1 - risen_in(swing, 0.99e-4) / risen_in(swing, 1e-4);
  CHECK(part == within(1 - 2 / exact::pi() * asin(Fifty("0.99")), 1e-8, "the square of the angle"));
  CHECK(part == within(0.09, 0.005, "hundredths"));
}
