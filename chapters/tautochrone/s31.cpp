#include <complex>
#include <memory>

#include <gsl/gsl_integration.h>

#include "edition/scene.hpp"
#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/scene.hpp"
#include "tautochrone/scene_judge.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

SECTION(tautochrone, 31, "Arc, height and breadth as integrals")

using namespace tautochrone;

/*!
## What Euler does

::: margin
The amplitude of a place is here the angle of the thread, not the width of a swing. The angle of a curve's
normal as its variable is today its tangential angle.
:::

For bodies whose $kk$ is very small he now has an equation between the radius of curvature $GM = r$ of the
tautochrone $CG$ and its amplitude, the angle $GMS = \varphi$; from it whatever is needed for drawing the
curve follows by three integrations. Let the arc be $CG = z$, the abscissa $CQ = x$ and the ordinate
$QG = y$. Then

$$ dz = r\,d\varphi, \quad dx = r\,d\varphi\sin\varphi, \quad dy = r\,d\varphi\cos\varphi, \tag{1} $$

and with $r$ from {{sec tautochrone.30}}

$$ \begin{aligned} z = a\!\int\! d\varphi\cos\varphi
  &- \frac{kk}a{{entry lost_k}}\!\int\!\frac{d\varphi}{\cos^3\varphi} \\
  &+ \frac{kk}a\!\int\! d\varphi\cos\varphi -
  \frac{6k^4}{a^3}\!\int\!\frac{d\varphi\sin^2\varphi}{\cos^7\varphi}, \end{aligned} \tag{2} $$

$$ \begin{aligned} x = a\!\int\! d\varphi\sin\varphi\cos\varphi
  &- \frac{kk}a\!\int\!\frac{d\varphi\sin\varphi}{\cos^3\varphi} \\
  &+ \frac{kk}a\!\int\! d\varphi\sin\varphi\cos\varphi -
  \frac{6k^4}{a^3}\!\int\!\frac{d\varphi\sin^3\varphi}{\cos^7\varphi{{entry seventh}}},
  \end{aligned} \tag{3} $$

$$ \begin{aligned} y = a\!\int\! d\varphi\cos^2\varphi
  &- \frac{kk}a\!\int\!\frac{d\varphi}{\cos^2\varphi} \\
  &+ \frac{kk}a\!\int\! d\varphi\cos^2\varphi -
  \frac{6k^4}{a^3}\!\int\!\frac{d\varphi\sin^2\varphi}{\cos^6\varphi}. \end{aligned} \tag{4} $$

## The program

With today's means one may leave the integrals as they are and sum them: Gauss's rule with a few places in
which $r$ is evaluated. (Its places are found as eigenvalues. GSL's ready-made table has them to sixteen
digits up to twenty places, and beyond at times to ten.) {{sec tautochrone.32}} has them in finite terms, and
that is what is told.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto phi = angle("phi", 15_deg, closed(0_deg, 80_deg), "angle GMS, the amplitude of the place");
const auto nodes = integer("nodes", 8, 1, 64, "places at which Gauss's rule takes r");

struct Rule  ///< Gauss's, from 0 to 1
{
  std::vector<double> places;   ///< where r is taken
  std::vector<double> weights;  ///< what it counts there

  explicit Rule(int n)
  {
    const auto size = static_cast<std::size_t>(n);
    const std::unique_ptr<gsl_integration_fixed_workspace, decltype(&gsl_integration_fixed_free)> of(
        gsl_integration_fixed_alloc(gsl_integration_fixed_legendre, size, 0, 1, 0, 0),
        gsl_integration_fixed_free);
    const double* const at = gsl_integration_fixed_nodes(of.get());
    const double* const weight = gsl_integration_fixed_weights(of.get());
    places.assign(at, at + size);
    weights.assign(weight, weight + size);
  }
};

double arc_by(const Rule& rule, double ratio, double to)  // (2), a = 1, of dz = r dφ
{
  double sum = 0;
  for(std::size_t i{0}; i < rule.places.size(); ++i)
    sum += rule.weights[i] * euler_r<double>(1, ratio, to * rule.places[i]);
  return sum * to;
}

TELL
{
  asked_end(k / a, phi);
  tell("z", euler_z<double>(a, k, phi), metres, "CG, the arc");
  tell("x", euler_x<double>(a, k, phi), metres, "CQ, the height above the lowest place");
  tell("y", euler_y<double>(a, k, phi), metres, "QG, the distance from the vertical");
  tell("z_by_rule", a * arc_by(Rule(nodes), k / a, phi), metres, "the arc by Gauss's rule");
}

TELL
{
  curve("errors", {"nodes", "e30", "e60", "e75", "e80"}, [](Curve& out) {
    for(int n = 1; n <= 40; ++n)
    {
      const Rule rule(n);
      std::vector<double> row{double(n)};
      for(const double to : {30_deg, 60_deg, 75_deg, 80_deg})
        row.push_back(std::abs(arc_by(rule, 0.1, to) / euler_z<double>(1, 0.1, to) - 1) + 1e-17);
      out.put(row);
    }
  });
}

/*!
What the curve is for, a scene shows. Three equal bodies are let go together at the angle $\varphi_0$ of the
thread, on Huygens's cycloid, on Euler's curve with both corrections, and on the highest exact tautochrone of
{{sec tautochrone.25}}. On the last the root of the height goes as the cosine of the time, whatever
$\varphi_0$ is; on the others the time is summed ({{api tautochrone::Timed_swing}}).
*/

const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");
const auto K = real("K", 0.3, none, closed(0.02, 0.9), "k/a of the three bodies of the scene");
const auto phi0 = angle("phi0", 45_deg, closed(1_deg, 80_deg), "angle at which they are let go");

constexpr int swings = 10, of_a_swing = 60;  // frames

bool euler_rises()
{
  return phi0 < largest_amplitude(Cheeks::euler_k4, K);
}

bool exact_rises()
{
  return phi0 <= end(Member::highest, K).phi;
}

TELL
{
  tell("missing",
       euler_rises()   ? exact_rises() ? "none" : "the exact curve"
       : exact_rises() ? "Euler's curve"
                       : "Euler's curve, the exact curve",
       "which of the curves do not rise to φ₀");
  tell("huygens_late", excess(Cheeks::cycloids, K, phi0), percent, "a swing on the cycloid is longer by");
  if(euler_rises())
    tell("euler_late", excess(Cheeks::euler_k4, K, phi0), percent, "a swing on Euler's curve is longer by");
}

TELL
{
  struct Way
  {
    std::string name, colour;
    std::vector<Hung> at;  // the frames
  };
  const double T = small_swing(K), unit = clock_in_seconds(a, g);
  constexpr int last = swings * of_a_swing;
  std::vector<Way> ways{{"huygens", "green", hung_between(Cheeks::cycloids, K, phi0, of_a_swing, last)}};
  if(euler_rises())
    ways.push_back({"euler", "vermilion", hung_between(Cheeks::euler_k4, K, phi0, of_a_swing, last)});
  if(exact_rises())
    ways.push_back({"exact", "blue", hung_on_highest(K, phi0, of_a_swing, last)});
  std::vector<Body> bodies;
  std::vector<std::string> columns{"t"};
  for(const Way& way : ways)
  {
    columns.insert(columns.end(), {way.name + "_phi", way.name + "_x", way.name + "_y"});
    bodies.push_back(drawn::trail({way.name + "_x", way.name + "_y"}, way.colour));
  }
  for(const Way& way : ways)
    bodies.push_back(drawn::bob({way.name + "_x", way.name + "_y"}, 0.025, way.colour));
  scene("three", bodies, columns, [&](Curve& frames) {
    for(int i = 0; i <= last; ++i)
    {
      std::vector<double> row{unit * T * i / of_a_swing};
      for(const Way& way : ways)
      {
        const Hung& now = way.at.at(static_cast<std::size_t>(i));
        row.insert(row.end(), {now.phi, now.G_x, now.G_y + 1});
      }
      frames.put(row);
    }
  });
}

/*!
::: scene three
alt: Three bobs near each other at the right ends of three curves that differ little: valleys open upwards,
drawn in three colours.

Ten swings in true time: blue on the exact tautochrone, green on Huygens's cycloid, vermilion on Euler's; the
length is $a$, the bodies have $k = K a$. At {{phi0|deg0}}, with $K = {{K}}$, a swing on the cycloid is longer
by {{huygens_late|percent1}}, on Euler's curve by {{euler_late|percent1}}: that is where his series has ceased
to help. From 25° Euler's keeps with the blue one to a hundredth of a swing. A curve that does not rise to
$\varphi_0$ is missing.
:::

With $k = \tfrac1{10}a$, at {{phi|deg0}}, the arc is {{z|12}} m; {{nodes}} places give
{{z_by_rule|12}} m.

::: figure tautochrone-31
alt: The relative error of the arc against the number of places of Gauss's rule, logarithmic. At 30
degrees it falls to the last digit of a double within eight places, at 60 degrees within fifteen, at 75
and 80 degrees more and more slowly.

The error of Gauss's rule for the arc, $k = \tfrac1{10}a$. The nearer the angle to 90°, where
$1:\cos^7\varphi$ is infinite, the more places are wanted.
:::

## Speed against error

Which is better, to sum or to integrate in finite terms?
*/

constexpr int rules[]{2, 4, 8, 16};

TELL
{
  if(phi == 0)
    return;  // no arc
  std::vector<Method> ways{{"finite terms", [] { return euler_z<double>(1, k / a, phi); }}};
  for(const int n : rules)
    ways.push_back({"Gauss, " + std::to_string(n) + " places",
                    [rule = Rule(n)] { return arc_by(rule, k / a, phi); }, "Gauss"});
  race("z", "z/a", euler_z<Fifty>(1, k.fifty() / a.fifty(), phi.fifty()), ways);
}

/*!
## Checks

The judge sums in fifty digits, by a rule of another kind and with a radius of curvature that comes from
the recursion of {{sec tautochrone.28}}.
*/

Fifty summed(const Fifty& ratio, const Fifty& to, const std::function<Fifty(const Fifty&)>& factor)
{
  const auto r = truncated(2, ratio);
  if(to == 0)
    return 0;
  return exact::integrate([&](const Fifty& x) { return r(cos(x)) * factor(x); }, 0, to).value;
}

const auto one = [](const Fifty&) { return Fifty(1); };
const auto sine = [](const Fifty& x) { return sin(x); };
const auto cosine_ = [](const Fifty& x) { return cos(x); };

double sizes(double ratio)  // of the largest terms at the angle, over a
{
  const double kappa = ratio * ratio, e = 1 / std::cos(phi);
  return phi * (1 + kappa * std::pow(e, 3) + 6 * kappa * kappa * std::pow(e, 7));
}

CHECK_THAT("arc, height and breadth told are the sums of r dφ, of r dφ sin φ and of r dφ cos φ")
{
  for(const Told& now :
      told_at("", "a=2 k=0.6 phi=15 nodes=4", "k=0.02 phi=75 nodes=40", "a=1e50 k=2e49 phi=1e-3 nodes=2"))
  {
    const Fifty ratio = k.fifty() / a.fifty();
    const double allowed = a * sizes(k / a) * 1e-14;
    const char* const why = "the library's bound, of the sum of the terms' sizes";
    CHECK(now.value("z", metres) == within(a.fifty() * summed(ratio, phi.fifty(), one), allowed, why));
    CHECK(now.value("x", metres)
          == within(a.fifty() * summed(ratio, phi.fifty(), sine), allowed * std::sin(phi), why));
    CHECK(now.value("y", metres) == within(a.fifty() * summed(ratio, phi.fifty(), cosine_), allowed, why));
    CHECK(now.exact("z")
          == within(summed(ratio, phi.fifty(), one), 1e-38 * sizes(k / a), "two ways of fifty digits"));
    CHECK(now.method("z", "finite terms")
          == within(summed(ratio, phi.fifty(), one), sizes(k / a) * 1e-14, why));
  }
}

CHECK_THAT("Huygens's body and Euler's move as their equations of motion say, on their curves")
{
  for(const Told& now : told_at("", "K=0.1 phi0=60 a=2", "K=0.7 phi0=15 g=1", "K=0.3 phi0=60"))
  {
    const Fifty unit = sqrt(a.fifty() / g.fifty()) / 2, start = phi0.fifty(), ratio = K.fifty();
    const double slack = 1e-13 * phi0;
    const char* const why = "ten swings, and the clock's bound at each";
    const auto frames = now.points("three", 9);
    for(const std::string name : {"huygens", "euler"})
    {
      if(name == "euler" && !(truncated(2, ratio)(cos(start)) > 0))
        continue;
      const Cheeks cheeks = name == "euler" ? Cheeks::euler_k4 : Cheeks::cycloids;
      const auto places = places_between(frames, cheeks, ratio, start, unit);
      for(std::size_t i = 0; i < frames.size(); ++i)
      {
        const On_curve& at = places[i];
        CHECK(frames[i].value((name + "_phi").c_str()) == within(at.phi, slack, why));
        CHECK(frames[i].value((name + "_x").c_str()) == within(at.y, slack, why));
        CHECK(frames[i].value((name + "_y").c_str()) == within(at.x, slack, why));
      }
    }
  }
}

CHECK_THAT("the third body is on the exact curve, and the root of its height is a cosine of the time")
{
  for(const Told& now : told_at("", "K=0.1 phi0=60 a=2", "K=0.7 phi0=15 g=1"))
  {
    const Fifty T = exact::pi() * sqrt((1 + pow(K.fifty(), 2)) * a.fifty() / (2 * g.fifty()));
    const auto frames = now.points("three", 14);
    const auto exactly = on_highest(frames, K.fifty(), phi0.fifty(), T);
    for(std::size_t i{0}; i < frames.size(); ++i)
    {
      const auto& frame = frames[i];
      const On_curve& right = exactly[i];
      const char* const why = "the curve's error below 1e-13, and that the time is rounded";
      CHECK(frame.value("t") == between(0, 10.0001 * T, "ten swings"));
      CHECK(frame.value("exact_phi") == within(right.phi, 1e-12, why));
      CHECK(frame.value("exact_y") == within(right.x, 1e-12, why));
      CHECK(frame.value("exact_x") == within(right.y, 1e-12, why));
    }
  }
}

CHECK_THAT("which curves rise to φ₀, and by how much the swings on them are too long, in fifty digits")
{
  for(const Told& now :
      told_at("", "K=0.1 phi0=60", "K=0.7 phi0=15", "K=0.3 phi0=60", "K=0.02 phi0=80", "K=0.2 phi0=59"))
  {
    const Fifty start = phi0.fifty(), ratio = K.fifty();
    const bool euler = truncated(2, ratio)(cos(start)) > 0, exact_ = start < highest_end(ratio).phi;
    const std::string missing_ = euler && exact_ ? "none"
                                 : euler         ? "the exact curve"
                                 : exact_        ? "Euler's curve"
                                                 : "Euler's curve, the exact curve";
    CHECK(now.value("missing") == missing_);
    const char* const why = "the library's bound, and that K and φ₀ are rounded";
    CHECK(now.value("huygens_late", percent)
          == within_relative(excess(truncated(0, 0), ratio, start), 1e-13, why));
    if(euler)
      CHECK(now.value("euler_late", percent)
            == within_relative(excess(truncated(2, ratio), ratio, start), 1e-12, why));
  }
  for(const Told& now : told_at("phi0=25"))
    CHECK(now.value("euler_late", percent)
          == between(0, 0.001, "no more than a hundredth of a swing in ten"));
}

double missed(int n, double ratio, double to)  // what Gauss's rule with n places may miss, for a = 1
{
  double least = infinity;
  for(double rho = 1.02; rho < 100; rho *= 1.02)  // ellipses that do not reach to 90°
  {
    if(to / 2 * (1 + (rho + 1 / rho) / 2) >= 1.57)
      break;
    double largest = 0;
    for(int i = 0; i <= 60; ++i)
    {
      const double angle = i * std::numbers::pi / 60, kk = ratio * ratio;
      const std::complex<double> out = std::polar(rho, angle), in = std::polar(1 / rho, -angle);
      const std::complex<double> c = std::cos(to / 2 * (1.0 + (out + in) / 2.0));
      const std::complex<double> secant = std::conj(c) / std::norm(c), cubed = secant * secant * secant;
      const auto r = c + kk * (c - cubed) - 6 * kk * kk * (1.0 - c * c) * cubed * cubed * secant;
      largest = std::max(largest, std::abs(r));
    }
    least = std::min(least, to / 2 * 64 / 15 * largest * std::pow(rho, -2 * n) / (1 - 1 / (rho * rho)));
  }
  return least + 1e-14 * (1 + ratio * ratio * std::pow(1 / std::cos(to), 7));
}

CHECK_THAT(
    "Gauss's rule misses no more than the ellipses about the interval allow, which may not reach to 90°")
{
  const char* const why = "the largest |r| on the best ellipse, and the roundings";
  for(const Told& now :
      told_at("", "a=2 k=0.6 phi=15 nodes=4", "k=0.02 phi=75 nodes=40", "nodes=38 phi=40"))
  {
    const Fifty z = summed(k.fifty() / a.fifty(), phi.fifty(), one);
    CHECK(now.value("z_by_rule", metres) == within(a.fifty() * z, a * missed(nodes, k / a, phi), why));
    for(const int n : rules)
      CHECK(now.method("z", "Gauss, " + std::to_string(n) + " places")
            == within(z, missed(n, k / a, phi), why));
  }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("errors", 40))
      for(const auto& [name, to] :
          {std::pair{"e30", 30_deg}, {"e60", 60_deg}, {"e75", 75_deg}, {"e80", 80_deg}})
        CHECK(point.value(name)
              == between(
                  1e-17,
                  1e-17 + missed(int(point.at("nodes")), 0.1, to) / std::abs(euler_z<double>(1, 0.1, to)),
                  why));
}

CHECK_THAT("the four integrals of each line, summed one by one, make (2), (3) and (4)")
{
  const Fifty ratio("0.3"), kk = ratio * ratio, to("0.7");
  const auto integral_of = [&](int sines, int cosines) {
    return exact::integrate([=](const Fifty& x) { return pow(sin(x), sines) * pow(cos(x), cosines); }, 0,
                            to)
        .value;
  };
  const auto line = [&](int sines, int shift) {
    return integral_of(sines, 1 + shift) - kk * integral_of(sines, shift - 3)
           + kk * integral_of(sines, 1 + shift) - 6 * kk * kk * integral_of(sines + 2, shift - 7);
  };
  CHECK(line(0, 0) == within(summed(ratio, to, one), 1e-38, "quadratures"));
  CHECK(line(1, 0) == within(summed(ratio, to, sine), 1e-38, "quadratures"));
  CHECK(line(0, 1) == within(summed(ratio, to, cosine_), 1e-38, "quadratures"));
}

/*!
In our copy $kk$ has lost a $k$ in {{eq 2}}, twice, and {{eq 3}} has a 6 where it must have a 7. The
readings are tried at $a = 1$, $k = \tfrac3{10}$, φ = 30°.
*/

double with(double of_kk, int exponent, bool height)
{
  const Fifty kk = Fifty(9) / 100, to = exact::pi() / 6;
  return double(exact::integrate(
                    [&](const Fifty& x) {
                      const Fifty c = cos(x), s = sin(x);
                      return (c - of_kk * pow(c, -3) + of_kk * c - 6 * kk * kk * s * s * pow(c, -exponent))
                             * (height ? s : 1);
                    },
                    0, to)
                    .value);
}

const Emendation lost_k{
    "§31, z, the factor of two integrals",
    {"k/a", [] { return with(0.3, 7, false); }},
    {"kk/a", [] { return with(0.09, 7, false); }},
    "r of §30 has kk/a, and so have the lines for x and y",
    [](double arc) {
      return arc == within_ulps(euler_z<double>(1, 0.3, 30_deg), 8, "Euler's finite terms of §32");
    }};

const Emendation seventh{
    "§31, x, the last integral",
    {"dφ sin³φ/cos⁶φ", [] { return with(0.09, 6, true); }},
    {"dφ sin³φ/cos⁷φ", [] { return with(0.09, 7, true); }},
    "it is r of §30 times sin φ, which changes no power of the cosine",
    [](double height) {
      return height == within_ulps(euler_x<double>(1, 0.3, 30_deg), 8, "Euler's finite terms of §32");
    }};

/*!
## Go on from here

::: exercise
By how much is the arc longer than the ordinate, near the lowest place? Does the size of the body matter?

answer: $z - y = \int r\,d\varphi\,(1-\cos\varphi)$ begins with $\tfrac16a\varphi^3$, whatever $k$ is: the
corrections of $r$ are of the order of $\varphi^2$ and change only what is of the order of $\varphi^5$. At 1°
both `--phi 1 --k 0.01` and `--phi 1 --k 0.3` have the difference 8.86e-7 m.
:::

::: exercise
Euler's formulae give numbers at any angle, also where his curve has ended. What does `--k 1 --phi 30` say,
and what would {{eq 2}} give there?

answer: The program refuses: for $k = a$ the radius is zero at 17.5°. Beyond, {{eq 2}} adds up a negative
radius; at 30° its arc would be negative, $-0.115\,a$.
:::
*/

CHECK_THAT("near the lowest place z − y is a φ³/6 for small bodies and for large")
{
  for(const Told& now : told_at("phi=1 k=0.01", "phi=1 k=0.3"))
  {
    const Fifty z = summed(k.fifty(), phi.fifty(), one), sixth = pow(phi.fifty(), 3) / 6;
    CHECK(now.value("z", metres) == within(z, 1e-15, "the library's bound"));
    CHECK(now.value("y", metres) == within(z - sixth, 1e-3 * double(sixth), "the next power of the angle"));
  }
}

CHECK_THAT("what lies beyond the end of the curve is refused, and a k greater than a; (2) would give a "
           "negative arc there")
{
  CHECK(refused_at("k=1 phi=30"));
  // r is zero at 60° for 1152κκ + 15κ = 1
  for(const std::string body : {"k=0.153828149399070924", "a=2 k=0.307656298798141847"})
  {
    CHECK(!refused_at(body + " phi=59.9999999999"));
    CHECK(refused_at(body + " phi=60.0000000001"));
  }
  for(const char* const within_them : {"k=1", "a=2 k=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"k=1.0000000000000003", "a=2 k=2.0001"})
    CHECK(refused_at(beyond));
  CHECK(euler_z<double>(1, 1, 30_deg) == within(-0.115, 5e-4, "three digits"));
}
