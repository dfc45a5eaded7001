#include "edition/section.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

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

$$ \begin{aligned} a^3Q\cos^3\varphi &+ 3aaPP\cos^2\varphi + 3aP\cos\varphi - 3aP\cos^3\varphi \\
   &- \frac{a\,dP\sin\varphi}{d\varphi} + 2\sin^2\varphi = 0. \end{aligned} \tag{1} $$

With $P$, $PP$ and $dP$ put in from {{sec tautochrone.29}} this becomes

$$ \begin{aligned}
   a^3Q\cos^3\varphi &+ \frac{3}{\cos^4\varphi} - 3 - \frac{3}{\cos^2\varphi} + 3\cos^2\varphi \\
   &+ 3\sin^2\varphi + \frac{3\sin^2\varphi}{\cos^4\varphi} = 0, \end{aligned} \tag{2} $$

or, since $\sin^2\varphi = 1 - \cos^2\varphi$,

$$ a^3Q\cos^3\varphi + \frac{6}{\cos^4\varphi} - \frac{6}{\cos^2\varphi} = 0, \tag{3} $$

so that

$$ Q = \frac{-6 + 6\cos^2\varphi}{a^3\cos^7\varphi} = \frac{-6\sin^2\varphi}{a^3\cos^7\varphi}. \tag{4} $$

Therefore, nearly,

$$ r = a\cos\varphi - \frac{kk\,(1-\cos^4\varphi)}{a\cos^3\varphi}
   - \frac{6k^4\sin^2\varphi}{a^3\cos^7\varphi}. \tag{5} $$

In the vertical, $\varphi = 0$, this is $r = a = AC$, as the nature of the thing demands.

::: margin
The first term is Huygens's cycloid. The terms go by powers of $kk/aa\cos^4\varphi$, which is small only while
the swing is not wide.
:::

## The program

$P$, $Q$ and all that comes of them are polynomials in $\cos\varphi$ and $1/\cos\varphi$. The program reckons
with them in exact fractions, for all $\varphi$ at once.

::: code tautochrone/series.hpp powers
:::

Where the scan is damaged its reading can be put in; the defaults are right.
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
Formula {{eq 5}} serves the next sections too.

::: code tautochrone/series.hpp radius (5)
:::

A second route forgets these lines and starts from the equation of {{sec tautochrone.28}}. For $a = 1$ and
$u = kk + rr$ it is $uu - (1+kk)\,ru\cos\varphi - kk(1+kk)\,\frac{dr}{d\varphi}\sin\varphi = 0$; with
$k^{2n}$ the unknown coefficient $r_n$ is multiplied by $\cos^3\varphi$, and all else is known.

::: code tautochrone/series.cpp corrections
:::

The judge is a curve that satisfies Euler's equation exactly. {{sec tautochrone.25}} gives its slope:

::: code tautochrone/curve.hpp slope
:::

For $k < a$ infinitely many of its solutions pass through $r = a$ at $\varphi = 0$, where it is singular; each
is a tautochrone up to the place where $dr = 0$ and its cheek would have to turn back. The one that lets the
pendulum rise highest ends at $\tan\varphi = (a-k)/\sqrt{ak}$; {{api tautochrone::highest}} follows it from
there backwards, because backwards all errors die.
*/

const auto k = real("k", 0.1, none, from_below(1e-9, 1), "radius of gyration, the length AC being a = 1");
const auto phi = angle("phi", 30_deg, open(0_deg, 90_deg), "angle of the free part with the vertical");

TELL
{
  const Fifty end = highest_end(Fifty(k)).phi;
  require(Fifty(phi) <= end, "phi", "up to the end of the curve, tan φ = (a − k)/√(ak)");
  const Fifty exact = highest(Fifty(k), Fifty(phi));
  const auto error = [&](int n) { return double(truncated(n, Fifty(k))(cos(Fifty(phi))) - exact); };
  tell("r", radius<double>(1, k, phi), "the radius of curvature by (5), in units of a");
  tell("exact", double(exact), "that of the highest exact tautochrone");
  tell("error_0", error(0), "by how much the cycloid's radius, a cos φ, is too large");
  tell("error_1", error(1), "the same with the first correction");
  tell("error_2", error(2), "the same by (5)");
  tell("end", double(end), degrees, "where the exact curve ends");
}

/*!
What does that matter to a clock? The integral of {{sec tautochrone.19}} says how much longer a wide swing
takes than a small one on each of the three curves; on an exact tautochrone it takes no longer.
*/

TELL
{
  const auto late = [](int n) {
    return late_in_a_day(excess(truncated(n, Fifty(k)), Fifty(k), exact::pi() / 6));
  };
  tell("lost_0", late(0), seconds, "what swings of 30° lose in a day on Huygens's cheeks");
  tell("lost_1", late(1), seconds, "the same on cheeks with the first correction");
  tell("lost_2", late(2), seconds, "the same on those that belong to (5)");
}

TELL
{
  curve("radius", {"phi", "exact", "n0", "n1", "n2", "n4", "n8"}, [](Curve& out) {
    std::vector<Fifty> angles;
    for(int i = 0; i <= 140; ++i)
      angles.push_back(highest_end(Fifty(k)).phi * i / 140);
    const std::vector<Fifty> exact = highest(Fifty(k), angles);
    for(std::size_t i = 0; i < angles.size(); ++i)
    {
      std::vector<double> row{double(angles[i]) / 1_deg, double(exact[i])};
      for(const int n : {0, 1, 2, 4, 8})
        row.push_back(double(truncated(n, Fifty(k))(cos(angles[i]))));
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
Beyond, his runs to $r = 0$, where the whole thread would be wound up; the exact curve keeps away from zero,
and ends at {{end|deg1}}.
:::

::: figure tautochrone-30-errors
alt: The error of the series against the angle, on a logarithmic scale, for the cycloid and for 1, 2, 4 and 8
corrections. At small angles every correction lowers the error by a decade or more. The lines come together
near 50 degrees and part again in the opposite order.

The error of $r/a$ when the series is kept through $k^{2n}$; the dips are where an approximation crosses the
exact curve. The more corrections, the better at small angles, and the worse at the end of the curve.
:::

## Speed against error
*/

TELL
{
  std::vector<Method> ways{{"formula (5)", [] { return radius<double>(1, k, phi); }}};
  for(const auto& [n, last] : {std::pair{1, "k²"}, {2, "k⁴"}, {4, "k⁸"}, {8, "k¹⁶"}, {12, "k²⁴"}})
    ways.push_back({std::string("series to ") + last,
                    [r = truncated_in_double(n, Fifty(k))] { return r(std::cos(phi)); }, "series"});
  for(const auto& [eps, name] :
      {std::pair{1e-4, "10⁻⁴"}, {1e-7, "10⁻⁷"}, {1e-10, "10⁻¹⁰"}, {1e-13, "10⁻¹³"}})
    if(k >= 0.01)  // for a smaller body the equation is too stiff
      ways.push_back({std::string("followed back, ") + name,
                      [tolerance = eps] { return followed_back(k, phi, tolerance); }, "GSL"});
  race("r", "r", highest(Fifty(k), Fifty(phi)), ways);
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

Euler says nothing of how near *nearly* is. Today the series would be called asymptotic: it diverges, but for
a small body on a long thread and no wide swings, his own condition, its terms fall for long before they
grow.

$P$ and $Q$ come without integration: since $dr$ is multiplied by $kk$, it enters each order with a
coefficient already known. So no constant of integration appears, and it stays hidden that the tautochrone is
not unique. Near the vertical the others differ from Euler's by a multiple of $\varphi$ to the power
$aa/kk - 1$, smaller than every power of $kk$.
*/
