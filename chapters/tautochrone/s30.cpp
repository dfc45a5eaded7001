#include <algorithm>

#include "edition/section.hpp"
#include "edition/series.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"
#include "tautochrone/ways.hpp"

SECTION(tautochrone, 30, "The second correction, and the radius of curvature")

using namespace tautochrone;

/*!
## What Euler does

The coefficient of $k^4$ gives the second correction, and with it the radius of curvature of the tautochrone
is known as nearly as Euler wants it. In {{sec tautochrone.28}} he had ordered his differential equation by
powers of $kk$, the square of the body's radius of gyration, which is small against $aa$, and had put

$$ r = a\cos\varphi + kk\,P + k^4 Q + \text{etc.} $$

for the radius $r = MG$ where the free part of the pendulum makes the angle $\varphi$ with the vertical. In
{{sec tautochrone.29}} the terms with $kk$ gave $P = -(1-\cos^4\varphi)/a\cos^3\varphi$. Now the terms with
$k^4$ must vanish too. Divided by $a\,d\varphi$ they are

$$ \begin{aligned} a^3Q\cos^3\varphi &+ 3aaPP{{entry first_line}}\cos^2\varphi + 3aP\cos\varphi \\
   &- 3aP\cos^3\varphi - \frac{a\,dP\sin\varphi}{d\varphi} + 2\sin^2\varphi = 0. \end{aligned} \tag{1} $$

With $P$, $PP$ and $dP$ put in from {{sec tautochrone.29}} this becomes

$$ \begin{aligned}
    a^3Q\cos^3\varphi &+ \frac{3}{\cos^4\varphi}{{entry three_over}} - 3 - \frac{3}{\cos^2\varphi} +
  3\cos^2\varphi \\
   &+ 3\sin^2\varphi + \frac{3\sin^2\varphi}{\cos^4\varphi} = 0, \end{aligned} \tag{2} $$

or, since $\sin^2\varphi = 1 - \cos^2\varphi$,

$$ a^3Q\cos^3\varphi + \frac{6}{\cos^4\varphi} - \frac{6}{\cos^2\varphi} = 0, \tag{3} $$

so that

$$ Q = \frac{-6 + 6\cos^2\varphi}{a^3\cos^7\varphi} = \frac{-6\sin^2\varphi}{a^3\cos^7\varphi}. \tag{4} $$

Therefore, nearly,

$$ r = a\cos\varphi - \frac{kk\,(1-\cos^4\varphi)}{a\cos^3\varphi}{{entry fourth_power}}
   - \frac{6k^4\sin^2\varphi}{a^3\cos^7\varphi}. \tag{5} $$

::: margin
The first term is Huygens's cycloid. The terms go by powers of $kk/aa\cos^4\varphi$, which is small only
while the swing is not wide.
:::

In the vertical, $\varphi = 0$, this is $r = a = AC$, as the nature of the thing demands.

## The program

$P$, $Q$ and all that comes of them are polynomials in $\cos\varphi$ and $1/\cos\varphi$. The program
reckons with them in exact fractions, for all $\varphi$ at once.

::: code tautochrone/series.hpp powers
:::

Where the scan is damaged its reading can be put in; the functions' own defaults are right.
*/

const Powers sin2 = 1 - cosine(2);

Powers third(const Rational& a, const Powers& P, const Powers& Q, int a_of_PP = 2, int last_cos = 3)  // (1)
{
  return a * a * a * Q * cosine(3) + 3 * pow(a, a_of_PP) * P * P * cosine(2) + 3 * a * P * cosine(1)
         - 3 * a * P * cosine(last_cos) - a * slope_times_sine(P) + 2 * sin2;
}

Powers put_in(const Powers& Q, int first = 3)  // (2), for a = 1
{
  return Q * cosine(3) + first * cosine(-4) - 3 - 3 * cosine(-2) + 3 * cosine(2) + 3 * sin2
         + 3 * sin2 * cosine(-4);
}

Powers Q(const Rational& a)  // (4)
{
  return -6 * sin2 / (a * a * a * cosine(7));
}

/*!
Formula {{eq 5}} serves the next sections too. With $t = \tan^2\varphi$ it is a product, and nothing cancels
at small angles:

::: code tautochrone/euler.hpp curve (5)
:::

A second route forgets these lines and starts from the equation of {{sec tautochrone.28}}. For $a = 1$ and
$u = kk + rr$ it is $uu - (1+kk)\,ru\cos\varphi - kk(1+kk)\,\frac{dr}{d\varphi}\sin\varphi = 0$; with
$k^{2n}$ the unknown coefficient $r_n$ is multiplied by $\cos^3\varphi$, and all else is known.

::: code tautochrone/series.cpp corrections
:::

The judge is a curve that satisfies Euler's equation exactly. {{sec tautochrone.25}} gives its slope:

::: code tautochrone/curve.hpp slope
:::

For $k < a$ infinitely many of its solutions pass through $r = a$ at $\varphi = 0$, where it is singular;
each is a tautochrone up to the place where $dr = 0$ and its cheek would have to turn back. The one that
lets the pendulum rise highest ends at $\tan\varphi = (a-k)/\sqrt{ak}$; {{api tautochrone::highest}}
follows it from there backwards, because backwards all errors die.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto phi = angle("phi",
                       at_most(30_deg, "where the curve ends",
                               [] { return k < a ? end(Member::highest, k / a).phi : 30_deg; }),
                       closed(0_deg, 90_deg), "angle of the free part with the vertical");
const auto phi0 = angle("phi0", 30_deg, open(0_deg, 90_deg), "how far the clock's pendulum swings");
const auto order = integer("order", 2, 0, 12, "corrections that are kept; Euler has two");

Fifty ratio()  // k/a
{
  return k.fifty() / a.fifty();
}

double rounded_ratio()  // not below 1e-9, where the quotient of doubles may be that of k = 1e-9 a
{
  return std::max(k / a, 1e-9);
}

Fifty place()  // φ, which as a double may be beyond the end of the curve by some of its ulps
{
  return std::min(phi.fifty(), highest_end(ratio()).phi);
}

/*!
By how much the series errs is not found in doubles, where it may be less than a rounding of $r$. Where the
terms fall fast it is the sum of those that are left out; elsewhere a difference in fifty digits, of which the
exact curve has twenty-eight.
*/

struct Error
{
  double over_a;  ///< what the series has too much
  int digits;     ///< how many of it are true
};

Error error_of(int kept, const Fifty& exact)
{
  const std::vector<double> t = terms(rounded_ratio(), phi, 12);
  double left_out = 0;
  for(std::size_t n = t.size() - 1; n > std::size_t(kept); --n)
    left_out -= t[n];
  if(std::abs(t.back()) <= 1e-13 * std::abs(left_out))
    return {left_out, 12};
  const double error = double(truncated(kept, ratio())(cos(place())) - exact);
  const double digits = std::floor(std::log10(std::max(std::abs(error), 1e-30)) + 27);
  return {error, std::clamp(int(digits), 0, 12)};
}

TELL
{
  require(ratio() >= Fifty("1e-9"), "k", "at least 1e-9 a and less than a");
  require(rounded_ratio() < 1, "k", "at least 1e-9 a and less than a");
  const Position last = end(Member::highest, rounded_ratio());
  require(phi <= last.phi, "phi", "up to the end of the curve, tan φ = (a − k)/√(ak)");
  tell("r", double(euler_r<Fifty>(a.fifty(), k.fifty(), phi.fifty())), metres,
       "the radius of curvature by (5)");
  tell("series", a * radius_by_series(order, rounded_ratio(), phi), metres,
       "the same with the corrections that are kept");
  tell("exact", a * at(Member::highest, rounded_ratio(), phi).r, metres,
       "that of the highest exact tautochrone");
  const Fifty exact = highest(ratio(), place());
  const auto error = [&](const char* name, int kept, const char* meaning) {
    const Error of = error_of(kept, exact);
    if(of.digits > 0)
      tell(name, of.over_a, meaning, of.digits);
  };
  error("error_0", 0, "by how much the cycloid's radius is too large, over a");
  error("error_1", 1, "the same with the first correction");
  error("error_2", 2, "the same by (5)");
  tell("end", double(highest_end(ratio()).phi), degrees, "where the exact curve ends");
}

/*!
What does that matter to a clock? The integral of {{sec tautochrone.19}} says how much longer a wide swing
takes than a small one on each of the three curves; on an exact tautochrone it takes no longer.
*/

TELL
{
  const auto late = [](const char* name, Cheeks cheeks, const char* meaning) {
    if(phi0 < largest_amplitude(cheeks, rounded_ratio()))
      tell(name, 86400 * excess(cheeks, rounded_ratio(), phi0), seconds, meaning);
  };
  late("lost_0", Cheeks::cycloids, "what such swings lose in a day on Huygens's cheeks");
  late("lost_1", Cheeks::euler_kk, "the same on cheeks with the first correction");
  late("lost_2", Cheeks::euler_k4, "the same on those that belong to (5)");
}

TELL
{
  curve("radius", {"phi", "exact", "n0", "n1", "n2", "n4", "n8"}, [](Curve& out) {
    const double last = end(Member::highest, rounded_ratio()).phi;
    for(int i = 0; i <= 140; ++i)
    {
      const double here = last * i / 140;
      std::vector<double> row{here / 1_deg, at(Member::highest, rounded_ratio(), here).r};
      for(const int n : {0, 1, 2, 4, 8})
        row.push_back(radius_by_series(n, rounded_ratio(), here));
      out.put(row);
    }
  });
}

/*!
Where the exact curve has {{exact|8}}, {{eq 5}} gives {{r|8}}. The cycloid's radius is too large by
{{error_0|e3}}; with $P$ the error is {{error_1|e3}}, with $P$ and $Q$ {{error_2|e3}}. To a clock the
corrections are worth still more: with swings of 30° it loses {{lost_0|3}} seconds in a day on Huygens's
cheeks, {{lost_1|2}} with $P$, and {{lost_2|2}} with both.

::: figure tautochrone-30
alt: The radius of curvature against the angle for a body with k = a/10. The cycloid falls as a cosine.
Euler's curve with two corrections lies below it and runs to zero at 66 degrees. The exact curve keeps close
to Euler's to about 45 degrees, falls steeply between 45 and 60, and ends at 71 degrees at 0.30.

The radius of curvature, in units of $a$. To about 45° Euler's formula and the exact curve are one line.
Beyond, his runs to $r = 0$, where the whole thread would be wound up; the exact curve keeps away from
zero, and ends at {{end|deg1}}.
:::

::: figure tautochrone-30-errors
alt: The error of the series against the angle, on a logarithmic scale, for the cycloid and for 1, 2, 4
and 8 corrections. At small angles every correction lowers the error by a decade or more. The lines come
together near 50 degrees and part again in the opposite order.

The error of $r/a$ when the series is kept through $k^{2n}$; the dips are where an approximation crosses the
exact curve. The more corrections, the better at small angles, and the worse at the end of the curve.
:::

## Speed against error

Three ways to one radius: the formula, the series with more or fewer corrections, and the exact equation
followed backwards from the end of the curve, by GSL's steps and by the flow on the sphere.
*/

constexpr std::pair<int, const char*> kept[]{{1, "k²"}, {2, "k⁴"}, {4, "k⁸"}, {8, "k¹⁶"}, {12, "k²⁴"}};
constexpr std::pair<double, const char*> steps[]{
    {1e-4, "10⁻⁴"}, {1e-7, "10⁻⁷"}, {1e-10, "10⁻¹⁰"}, {1e-13, "10⁻¹³"}};

TELL
{
  const double small = rounded_ratio();
  std::vector<Method> ways{{"formula (5)", [=] { return euler_r<double>(1, small, phi); }}};
  for(const auto& [n, last] : kept)
    ways.push_back({std::string("series to ") + last,
                    [=, last_one = n] { return radius_by_series(last_one, small, phi); }, "series"});
  if(small >= 0.01 && phi > 0)  // for a smaller body the equation is too stiff
  {
    const Position last = end(Member::highest, small);
    for(const auto& [eps, name] : steps)
      ways.push_back({std::string("followed back, ") + name,
                      [=, tolerance = eps] {
                        return follow(small, last.phi, last.r, phi, tolerance, Stepper::runge_kutta);
                      },
                      "GSL"});
  }
  ways.push_back({"flow on the sphere", [=] { return at(Member::highest, small, phi).r; }});
  race("r", "r/a", highest(ratio(), place()), ways);
}

/*!
## Checks

Euler's algebra is checked exactly, beginning with {{eq 1}} itself.
*/

CHECK_THAT("(1) is the coefficient of k⁴ in the equation of § 28, divided by a, whatever P and Q are")
{
  const Rational a_(7, 3);
  for(const auto& [p, q] : {std::pair{P(a_), Q(a_)}, {cosine(-2) + 5, cosine(1) - 2}})
  {
    const Expansion r({a_ * cosine(1), p, q});
    const Expansion dr_sin({slope_times_sine(r[0]), slope_times_sine(p), slope_times_sine(q)});
    CHECK(equation<Expansion>(Powers(a_), Expansion::x(), r, dr_sin, cosine(1))[2] == a_ * third(a_, p, q));
  }
}

CHECK_THAT("(1), (2) and (3) are the same for any Q, and vanish for Euler's")
{
  CHECK(third(Rational(7, 3), P(Rational(7, 3)), Q(Rational(7, 3))) == Powers(0));
  for(const Powers& q : {Powers(0), cosine(-3), Q(1)})
  {
    CHECK(third(1, P(1), q) == put_in(q));
    CHECK(put_in(q) == q * cosine(3) + 6 * cosine(-4) - 6 * cosine(-2));  // (3)
  }
}

CHECK_THAT("the second route finds the same P and Q, and all its coefficients vanish in the vertical")
{
  const auto r_n = corrections<Rational>(8);
  CHECK(r_n[1] == P(1));
  CHECK(r_n[2] == Q(1));
  for(std::size_t n = 1; n <= 8; ++n)
    CHECK(r_n[n](Rational(1)) == 0);
}

/*!
So $r = a$ in the vertical with any number of corrections, and confirms none. What does is the exact curve:
for a small $k$ the error of {{eq 5}} must be $k^6r_3$.
*/

CHECK_THAT("the error of (5) is the next term of the series, the more nearly the smaller k is")
{
  const Fifty angle_ = exact::pi() / 6;
  const Fifty r_3 = corrections<Fifty>(3)[3](cos(angle_));
  for(const char* small : {"1e-2", "1e-3"})
  {
    const Fifty kk = pow(Fifty(small), 2);
    const Fifty left_out = highest(Fifty(small), angle_) - radius<Fifty>(1, Fifty(small), angle_);
    CHECK(left_out / pow(kk, 3)
          == within_relative(r_3, 20 * double(kk), "the term after it is 17 kk times as large"));
  }
}

CHECK_THAT(
    "of a small body, or at a small angle, the error told is the first term left out, and what comes after")
{
  for(const Told& now : told_at("k=0.001", "k=1e-6 phi=60", "k=0.003 phi=1e-4"))
  {
    const Fifty c = cos(phi.fifty()), kappa = ratio() * ratio();
    const auto r = corrections<Fifty>(12);
    for(const auto& [name, n] : {std::pair{"error_0", 0}, {"error_1", 1}, {"error_2", 2}})
    {
      Fifty left_out = 0;
      for(int i = n + 1; i <= 12; ++i)
        left_out -= pow(kappa, i) * r[std::size_t(i)](c);
      CHECK(now.value(name) == within_relative(left_out, 1e-12, "the library's bound"));
    }
  }
}

/*!
What is told is compared with fifty digits: with the series summed after its recursion, with the exact curve
followed back after another equation, with the times by quadrature.
*/

CHECK_THAT("the radii told are the series' and the exact curve's, at any a, k and φ")
{
  for(const Told& now :
      told_at("", "a=2 k=0.6 phi=40 order=5", "k=0.02 phi=60 order=12", "a=3e50 k=2.9e50 phi=1e-9 order=1"))
  {
    const Fifty r = highest(ratio(), phi.fifty()), c = cos(phi.fifty());
    const auto sizes = [&](int n) {
      Fifty sum = 0;
      for(int i = 1; i <= n; ++i)
        sum += abs(truncated(i, ratio())(c) - truncated(i - 1, ratio())(c));
      return double(sum + 1) * 1e-14;
    };
    const char* const bound = "the library's bound, of the largest term";
    CHECK(now.value("r", metres) == within_ulps(a.fifty() * truncated(2, ratio())(c), 1, "a rounding"));
    CHECK(now.value("series", metres)
          == within(a.fifty() * truncated(order, ratio())(c), a * sizes(order), bound));
    CHECK(now.value("exact", metres) == within_relative(a.fifty() * r, 2e-14, "the library's bound"));
    for(const auto& [name, n] : {std::pair{"error_0", 0}, {"error_1", 1}, {"error_2", 2}})
      if(error_of(n, r).digits > 0)
        CHECK(now.value(name)
              == within(truncated(n, ratio())(c) - r, 1e-27 + 1e-12 * std::abs(error_of(n, r).over_a),
                        "the exact curve's digits, and the terms'"));
    const Fifty tangent = (1 - ratio()) / sqrt(ratio());
    CHECK(now.value("end", degrees) == within_ulps(atan(tangent), 1, "a rounding"));
  }
}

CHECK_THAT(
    "told where the curve ends, as by default if k is great, the exact radius is √(k(aa − ak + kk) : a)")
{
  for(const Told& now :
      told_at("k=0.571", "k=0.984", "a=2 k=1.38", "k=0.9999999999", "k=0.9999999999999999"))
  {
    const Fifty q = ratio(), r = sqrt(q * (1 - q + q * q)), end_ = atan((1 - q) / sqrt(q));
    CHECK(now.value("exact", metres) == within_relative(a.fifty() * r, 2e-14, "the library's bound"));
    CHECK(now.exact("r") == within_relative(r, 1e-14, "the default is rounded, and may be before the end"));
    CHECK(now.value("error_0") == within(cos(end_) - r, 1e-14, "the same"));
    CHECK(now.value("end", degrees) == within_ulps(end_, 1, "a rounding"));
  }
}

CHECK_THAT(
    "it refuses an angle beyond the end of the curve, a body with k = a and one with less than 1e-9 a")
{
  for(const char* const within_them :
      {"k=1e-9", "k=0.9999999999999999", "k=9e-9 a=9", "k=2e-9 a=2", "k=1.9999 a=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"k=9.99999999999999999e-10", "k=1", "k=0.99999999999999999", "k=1.9999e-9 a=2", "k=2 a=2"})
    CHECK(refused_at(beyond));
  for(const std::string body : {"k=0.381966011250105152", "a=2 k=0.763932022500210304"})  // (a − k)² = ak
  {
    CHECK(!refused_at(body + " phi=44.9999999999"));
    CHECK(refused_at(body + " phi=45.0000000001"));
  }
}

CHECK_THAT(
    "what is lost in a day is what a quadrature of fifty digits finds, and nothing is told of no curve")
{
  for(const Told& now : told_at("", "k=0.3 phi0=45", "a=2 k=0.04 phi0=60"))
    for(const auto& [name, n] : {std::pair{"lost_0", 0}, {"lost_1", 1}, {"lost_2", 2}})
      CHECK(now.value(name, seconds)
            == within_relative(86400 * excess(truncated(n, ratio()), ratio(), phi0.fifty()), 1e-12,
                               "the library's bound, and that of k/a near the end of the curve"));
  for(const Told& now : told_at("k=0.3 phi=10 phi0=60"))
    CHECK_THROWS(now.value("lost_2", seconds));
}

CHECK_THAT("the figure's curves and the race's ways are the exact curve and the series")
{
  for(const Told& now : told_at("", "k=0.3 phi=20", "a=2 k=0.1 phi=70"))
  {
    const auto close = [](const Fifty& c, int n) {  // of the largest term
      return 2e-14 * (1 + double(abs(truncated(n, ratio())(c) - c)));
    };
    const Fifty c = cos(phi.fifty()), r = highest(ratio(), phi.fifty());
    CHECK(now.exact("r") == within_relative(at(Member::highest, k / a, phi).r, 1e-13, "two routes"));
    CHECK(now.method("r", "flow on the sphere") == within_relative(r, 2e-14, "the library's bound"));
    CHECK(now.method("r", "formula (5)") == within(truncated(2, ratio())(c), close(c, 2), "its bound"));
    for(const auto& [n, last] : kept)
      CHECK(now.method("r", std::string("series to ") + last)
            == within(truncated(n, ratio())(c), close(c, n), "the library's bound"));
    for(const auto& [eps, name] : steps)
      CHECK(now.method("r", std::string("followed back, ") + name)
            == within(r, 2 * eps + 1e-13, "backwards the errors of the steps die, all but the last few"));
    for(const auto& point : now.points("radius", 6))
    {
      const Fifty angle_ = Fifty(point.at("phi")) * exact::pi() / 180, cosine_ = cos(angle_);
      if(angle_ > 0 && angle_ < highest_end(ratio()).phi)
        CHECK(point.value("exact")
              == within_relative(highest(ratio(), angle_), 1e-13, "its bound, and φ's"));
      for(const auto& [name, n] : {std::pair{"n0", 0}, {"n1", 1}, {"n2", 2}, {"n4", 4}, {"n8", 8}})
        CHECK(point.value(name)
              == within(truncated(n, ratio())(cosine_), 40 * close(cosine_, n), "its bound, and φ's"));
    }
  }
}

/*!
In the scan {{eq 1}} and {{eq 5}} have suffered, and {{eq 2}} has a wrong figure, which may be the scan's or
the printer's. The readings are tried at $\cos\varphi = \tfrac35$, in fractions.
*/

double at_three_fifths(const Powers& line)
{
  return double(line(Rational(3, 5)));
}

const auto vanishes = [](double line) { return line == 0; };

const Emendation first_line{
    "§30, first line, terms with PP and P",
    {"3a³PP cos²φ, 3aP cos⁵φ", [] { return at_three_fifths(third(2, P(2), Q(2), 3, 5)); }},
    {"3aaPP cos²φ, 3aP cos³φ", [] { return at_three_fifths(third(2, P(2), Q(2))); }},
    "all terms are pure numbers, and the last comes from kk r³ cos φ of §28; only so does the line vanish",
    vanishes};

const Doubtful three_over{
    "§30, second line, the first fraction",
    {"6/cos⁴φ", [] { return at_three_fifths(put_in(Q(1), 6)); }},
    {"3/cos⁴φ", [] { return at_three_fifths(put_in(Q(1))); }},
    "3aaPP cos²φ begins with 3/cos⁴φ; the 6 arises only in the next line, which is right",
    vanishes};

const Emendation fourth_power{
    "§30, the radius of curvature",
    {"kk(1 − cos²φ)/a cos³φ", [] { return at_three_fifths((cosine(2) - 1) / cosine(3)); }},
    {"kk(1 − cos⁴φ)/a cos³φ", [] { return at_three_fifths((cosine(4) - 1) / cosine(3)); }},
    "it is kkP, and P of §29 has the fourth power",
    [](double P) { return P == at_three_fifths(corrections<Rational>(1)[1]); }};

/*!
## Notes

Euler says nothing of how near *nearly* is. Today the series would be called asymptotic: it diverges, but
for a small body on a long thread and no wide swings, his own condition, its terms fall for long before
they grow.

$P$ and $Q$ come without integration: since $dr$ is multiplied by $kk$, it enters each order with a
coefficient already known. So no constant of integration appears, and it stays hidden that the tautochrone
is not unique. Near the vertical the others differ from Euler's by a multiple of $\varphi$ to the power
$aa/kk - 1$, smaller than every power of $kk$.

## Go on from here

::: exercise
For $k = \tfrac1{10}a$, at 30°, keep more and more corrections (`--order`). By what factor does each lessen
the error? Can this go on?

answer: Without any the radius is wrong by 7.2e-3 of $a$, with six by 7.2e-8. But the first correction brings
a factor of 16, the sixth only one of 4, and it goes on falling: by {{eq tautochrone.27 B}} the terms cease to
fall near the thirty-second, where they are of the size of $e^{-32}$. At 45° they do so near the tenth.
:::
*/

CHECK_THAT("for k = a/10 at 30° six corrections lessen the error from 7.2e-3 to 7.2e-8, each by a smaller "
           "factor; the "
           "terms fall to the thirty-second, at 45° to the tenth")
{
  const double exactly = at(Member::highest, 0.1, 30_deg).r;
  const auto error = [=](int n) { return std::abs(radius_by_series(n, 0.1, 30_deg) - exactly); };
  CHECK(error(0) == within(7.2e-3, 5e-5, "two digits"));
  CHECK(error(6) == within(7.2e-8, 5e-10, "two digits"));
  CHECK(error(0) / error(1) == within(16, 0.5, "two digits"));
  CHECK(error(5) / error(6) == within(4, 0.1, "nearly"));
  for(int n = 1; n < 6; ++n)
    CHECK(error(n) / error(n + 1) < error(n - 1) / error(n));
  CHECK(100 * falling(exact::pi() / 6) == within(32, 0.5, "A aa/kk"));
  CHECK(100 * falling(exact::pi() / 4) == within(10, 0.5, "A aa/kk"));
}
