#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

SECTION(tautochrone, 30, "The second correction, and the radius of curvature")

using tautochrone::corrections, tautochrone::excess, tautochrone::Expansion, tautochrone::falling;
using tautochrone::highest, tautochrone::Powers, tautochrone::truncated;

/*!
## What Euler does

The coefficient of $k^4$ gives the second correction, and with it the radius of curvature of the tautochrone
is found as nearly as Euler wants it. In {{sec tautochrone.28}} he had ordered his equation by the powers of
$kk$, the square of the body's radius of gyration, which is small against $aa$, and had put

$$ r = a\cos\varphi + kk\,P + k^4 Q + \text{etc.} $$

for the radius $r = MG$ at the place where the free part of the pendulum makes the angle $\varphi$ with the
vertical. In {{sec tautochrone.29}} the terms with $kk$ gave $P = -(1-\cos^4\varphi)/a\cos^3\varphi$. Now the
terms with $k^4$ must vanish too. Divided by $a\,d\varphi$ they are

$$ \begin{aligned} a^3Q\cos^3\varphi &+ 3aaPP\cos^2\varphi + 3aP\cos\varphi - 3aP\cos^3\varphi \\
   &- \frac{a\,dP\sin\varphi}{d\varphi} + 2\sin^2\varphi = 0. \end{aligned} \tag{1} $$

Here $Q$ occurs without its differential, as $P$ did before it. What is to be solved is not a differential
equation any more: it is enough to put in what is known. With $P$, $PP$ and $dP$ it becomes

$$ \begin{aligned}
   a^3Q\cos^3\varphi &+ \frac{3}{\cos^4\varphi} - 3 - \frac{3}{\cos^2\varphi} + 3\cos^2\varphi \\
   &+ 3\sin^2\varphi + \frac{3\sin^2\varphi}{\cos^4\varphi} = 0, \end{aligned} \tag{2} $$

or, since $\sin^2\varphi = 1 - \cos^2\varphi$,

$$ a^3Q\cos^3\varphi + \frac{6}{\cos^4\varphi} - \frac{6}{\cos^2\varphi} = 0, \tag{3} $$

so that

$$ Q = -\frac{6\sin^2\varphi}{a^3\cos^7\varphi}. \tag{4} $$

Therefore, nearly,

$$ r = a\cos\varphi - \frac{kk\,(1-\cos^4\varphi)}{a\cos^3\varphi}
   - \frac{6k^4\sin^2\varphi}{a^3\cos^7\varphi}. \tag{5} $$

In the vertical, $\varphi = 0$, this is $r = a = AC$, as the nature of the thing demands.

::: margin
The first term is Huygens's cycloid. The corrections are in truth powers of $kk/aa\cos^4\varphi$: small only
while the swing is not wide.
:::

## The program

$P$, $Q$ and all that comes of them are sums of powers of $\cos\varphi$, also negative ones, with fractions
for coefficients. The program reckons with such sums exactly, so that its verdict on Euler's algebra is not a
matter of digits.
*/

Powers c(int n) { return {1, n}; }  // the power n of cos φ

const Powers sin2 = 1 - c(2);

Powers first(const Rational& a) { return (c(4) - 1) / (a * c(3)); }  // P of § 29

Powers second(const Rational& a) { return -6 * sin2 / (a * a * a * c(7)); }  // (4)

Powers third_line(const Rational& a, const Powers& P, const Powers& Q)  // (1)
{
  const Powers dP_sin = -sin2 * derivative(P);  // d cos φ is −sin φ dφ
  return a * a * a * Q * c(3) + 3 * a * a * P * P * c(2) + 3 * a * P * c(1) - 3 * a * P * c(3)
         - a * dP_sin + 2 * sin2;
}

/*!
As a second route the program forgets Euler's lines. It takes the equation of {{sec tautochrone.28}} with
$a = 1$ and lets the machine find one coefficient after the other, as many as one likes: in the order $n$ the
unknown $r_n$ stands alone, with the factor $\cos^3\varphi$, and all else is known. Written with $u = kk + rr$
it is $uu - (1+kk)\,ru\cos\varphi - kk(1+kk)\,\frac{dr}{d\varphi}\sin\varphi = 0$.

::: code tautochrone/series.cpp corrections
:::

The formula itself, in lengths:
*/

double radius(double a, double k, double phi)  // (5)
{
  const double cosine = std::cos(phi);
  const double sine = std::sin(phi);
  return a * cosine - k * k * (1 - std::pow(cosine, 4)) / (a * std::pow(cosine, 3))
         - 6 * std::pow(k, 4) * sine * sine / (std::pow(a, 3) * std::pow(cosine, 7));
}

/*!
With what shall it be compared? With a curve that satisfies Euler's equation exactly. There is more than one:
the equation of {{sec tautochrone.25}} is of the first order, but it is singular at $\varphi = 0$, and
whenever $k < a$ infinitely many of its solutions pass there through $r = a$. Each is a tautochrone, and each
ends where its cheek would have to turn back, at $dr = 0$. The edition measures Euler's formula by the one
that lets the pendulum rise highest, which ends at $\tan\varphi = (a-k)/\sqrt{ak}$ at the height $(a-k)^2/2a$.
It is found from there backwards, because backwards all errors die: {{api tautochrone::highest}}.
*/

const auto a = real("a", 1.0, metres, closed(1e-6, 1e6), "length AC, suspension to centre of gravity");
const auto k = real("k", 0.1, metres, positive, "radius of gyration about the centre of gravity");
const auto phi = angle("phi", 30_deg, open(0_deg, 90_deg), "angle of the free part with the vertical");

Fifty k_over_a() { return Fifty(k) / Fifty(a); }

TELL
{
  require(k >= 1e-9 * a && k < a, "k", "at least 10⁻⁹ a, and less than a for a curve with cheeks");
  const auto end = tautochrone::highest_end(k_over_a());
  require(Fifty(phi) <= end.phi, "phi", "up to the end of the curve, tan φ = (a − k)/√(ak)");
  const Fifty cosine = cos(Fifty(phi));
  const Fifty exact = highest(k_over_a(), Fifty(phi));
  const auto r_n = corrections<Fifty>(3);
  const auto in_metres = [](const Fifty& x) { return static_cast<double>(Fifty(a) * x); };
  const auto term = [&](int n) { return in_metres(pow(k_over_a(), 2 * n) * r_n[std::size_t(n)](cosine)); };
  const auto error = [&](int order) { return in_metres(truncated(order, k_over_a())(cosine) - exact); };
  tell("kkP", term(1), metres, "the first correction, k²P");
  tell("k4Q", term(2), metres, "the second correction, k⁴Q");
  tell("r", radius(a, k, phi), metres, "the radius of curvature by (5)");
  tell("exact", in_metres(exact), metres, "that of the highest exact tautochrone");
  tell("error_0", error(0), metres, "by how much the cycloid's radius, a cos φ, is too large");
  tell("error_1", error(1), metres, "the same with the first correction");
  tell("error_2", error(2), metres, "the same by (5)");
  tell("next", -term(3), metres, "what of this the next term of the series explains");
  tell("end", static_cast<double>(end.phi), degrees, "where the exact curve ends");
  const Fifty best = falling(Fifty(phi)) / pow(k_over_a(), 2);
  tell("best", static_cast<double>(best), "about how many terms of the series fall before they grow");
}

/*!
What does it matter to a clock? The integral of {{sec tautochrone.19}}, taken along the curve that belongs to
{{eq 5}}, says how much longer a wide swing takes than a small one; on an exact tautochrone it takes no longer
at all.
*/

double lost(int order, double amplitude)  // seconds in a day, against infinitely small swings
{
  const auto kept = truncated(order, k_over_a());
  if(kept(cos(Fifty(amplitude))) < 1e-4)
    return std::nan("");  // there, or just beyond, the truncated curve has turned back
  return 86400 * static_cast<double>(excess(kept, k_over_a(), Fifty(amplitude)));
}

TELL
{
  tell("lost_0", lost(0, 30_deg), seconds, "what swings of 30° lose in a day on Huygens's cheeks");
  tell("lost_2", lost(2, 30_deg), seconds, "what they lose on those that belong to (5)");
  auto& losses = table("losses", "Seconds that a clock loses in a day, by the width of its swings",
                       {{"phi", "φ", degrees, 2}, {"cycloid", "cycloid", none, 3},
                        {"kk", "with P", none, 3}, {"k4", "with P and Q", none, 3}});
  const auto cell = [](double loss) { return std::isnan(loss) ? Cell("r < 0") : Cell(loss); };
  for(const double amplitude : {5_deg, 10_deg, 20_deg, 30_deg, 45_deg, 60_deg})
    losses.row({amplitude, cell(lost(0, amplitude)), cell(lost(1, amplitude)), cell(lost(2, amplitude))});
}

/*!
For the figures: the radius over the whole swing,
*/

TELL
{
  curve("radius", {"phi", "cycloid", "kk", "k4"}, [](Curve& out) {
    const auto to_kk = truncated(1, k_over_a());
    for(double degree = 0; degree < 90; degree += degree < 60 ? 1 : 0.1)
    {
      const Fifty cosine = cos(Fifty(degree * 1_deg));
      out.put({degree, static_cast<double>(cosine), static_cast<double>(to_kk(cosine)),
               radius(a, k, degree * 1_deg) / a});
    }
  });
  curve("exact", {"phi", "exact"}, [](Curve& out) {
    const Fifty end = tautochrone::highest_end(k_over_a()).phi;
    std::vector<Fifty> angles;
    for(int i = 0; i <= 140; ++i)
      angles.push_back(end * i / 140);
    const auto radii = highest(k_over_a(), angles);
    for(std::size_t i = 0; i < angles.size(); ++i)
      out.put({static_cast<double>(angles[i] * 180 / exact::pi()), static_cast<double>(radii[i])});
  });
}

/*!
and the error that is left when more and more orders of the series are kept.
*/

TELL
{
  curve("orders", {"n", "at10", "at20", "at30", "at40", "at50"}, [](Curve& out) {
    const auto r_n = corrections<Fifty>(24);
    const Fifty end = tautochrone::highest_end(k_over_a()).phi;
    std::vector<Fifty> angles;
    for(int degree = 10; degree <= 50; degree += 10)
      angles.push_back(std::min(degree * exact::pi() / 180, end));  // not farther than the curve goes
    std::vector<Fifty> left = highest(k_over_a(), angles);
    for(int n = 0; n <= 24; ++n)
    {
      std::vector<double> row = {static_cast<double>(n)};
      for(std::size_t i = 0; i < angles.size(); ++i)
      {
        left[i] -= pow(k_over_a(), 2 * n) * r_n[std::size_t(n)](cos(angles[i]));
        row.push_back(static_cast<double>(abs(left[i])));
      }
      out.put(row);
    }
  });
}

/*!
There are two ways to $r$. Euler's series costs next to nothing and can be carried on; or one follows the
differential equation back from the end of the curve, here with a Runge-Kutta rule of GSL that chooses its
steps.
*/

double followed_back(double k, double phi, double tolerance)
{
  const auto right_side = [](double at, const double r[], double slope[], void* k_of_body) {
    slope[0] = tautochrone::slope(at, r[0], *static_cast<double*>(k_of_body));
    return int{GSL_SUCCESS};
  };
  gsl_odeiv2_system system{right_side, nullptr, 1, &k};
  auto* driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, -1e-3, tolerance, 0);
  double at = std::max(phi, std::atan((1 - k) / std::sqrt(k)));
  double r = std::sqrt(k * (1 - k + k * k));
  const int status = gsl_odeiv2_driver_apply(driver, &at, phi, &r);
  gsl_odeiv2_driver_free(driver);
  return status == GSL_SUCCESS ? r : std::nan("");
}

TELL
{
  std::vector<Method> ways = {{"formula (5)", [] { return radius(a, k, phi); }}};
  const std::pair<int, const char*> orders[] = {{1, "k²"}, {2, "k⁴"}, {4, "k⁸"}, {8, "k¹⁶"}, {12, "k²⁴"}};
  for(const auto& [order, last] : orders)
  {
    exact::Laurent<double> kept;
    const auto exactly = truncated(order, k_over_a());
    for(int n = exactly.lowest(); n <= exactly.highest(); ++n)
      kept += exact::Laurent<double>(static_cast<double>(exactly[n]), n);
    ways.push_back({std::string("series to ") + last, [=] { return a * kept(std::cos(phi)); }, "series"});
  }
  const std::pair<double, const char*> tolerances[] = {
      {1e-4, "10⁻⁴"}, {1e-7, "10⁻⁷"}, {1e-10, "10⁻¹⁰"}, {1e-13, "10⁻¹³"}};
  if(k / a >= 0.01)  // for a smaller body the equation is too stiff
    for(const auto& [tolerance, name] : tolerances)
      ways.push_back({std::string("followed back, ") + name,
                      [t = tolerance] { return a * followed_back(k / a, phi, t); }, "GSL"});
  race("r", "r", Fifty(a) * highest(k_over_a(), Fifty(phi)), ways);
}

/*!
At the default inputs {{eq 5}} gives $r$ = {{r|8}}, where the exact curve has {{exact|8}}. The cycloid's
radius is too large by {{error_0|e3}}; with $P$ the error is {{error_1|e3}}, with $P$ and $Q$ it is
{{error_2|e3}}, and of that the next term of the series explains {{next|e3}}. In a clock the corrections are
worth still more:

{{table losses}}

With swings of 30° a clock loses {{lost_0|3}} seconds in a day on Huygens's cheeks, {{lost_2|2}} on Euler's.
With the few degrees that most clocks allow themselves there is hardly anything to mend, and what there is,
$P$ mends. But at 60° the second correction achieves nearly nothing that the first has not.

::: figure tautochrone-30
alt: The radius of curvature against the angle for a body with k = a/10. The cycloid falls as a cosine to zero
at 90 degrees. Euler's curve with two corrections lies below it and runs to zero at 66 degrees. The exact
curve keeps close to Euler's to about 45 degrees, falls steeply between 45 and 60, and ends at 71 degrees at
0.30.

The radius of curvature, in units of $a$. To about 45° Euler's formula and the exact curve are one line.
Beyond, the exact curves part from each other as they part from his. His runs to $r = 0$, where all of the
thread would be wound up; they all end before, the highest at {{end|deg1}}, where the cheek would have to turn
back.
:::

::: figure tautochrone-30-orders
alt: The error of the series against the number of orders kept, for five angles, on a logarithmic scale. For
10 degrees it falls on and on. For 30 degrees it falls more and more slowly. For 40 degrees it ceases to fall
at about order 10, and for 50 degrees it soon rises beyond all bounds.

How much is wrong with $r/a$ when the series is kept through $k^{2n}$; Euler stops at $n = 2$. Each curve
falls to a floor, which is the higher, the wider the angle: there the exact tautochrones of the same $a$ and
$k$ differ among themselves, and a series in powers of $kk$ cannot tell them apart. In the end the terms grow,
at 50° soon, at 10° far outside the picture.
:::

## Checks

First Euler's algebra, exactly and for every $\varphi$ at once.
*/

CHECK_THAT("with P and Q the third line vanishes, whatever a is")
{
  for(const Rational& length : {Rational(1), Rational(2), Rational(7, 3)})
    CHECK(third_line(length, first(length), second(length)) == Powers(0));
}

Powers put_in(const Rational& figure, const Powers& Q)  // (2), for a = 1, with a figure for its first 3
{
  return Q * c(3) + figure / c(4) - 3 - 3 / c(2) + 3 * c(2) + 3 * sin2 + 3 * sin2 / c(4);
}

Powers gathered(const Powers& Q) { return Q * c(3) + 6 / c(4) - 6 / c(2); }  // (3)

CHECK_THAT("(1), (2) and (3) are the same, whatever Q is")
{
  for(const Powers& Q : {Powers(0), Powers(5, -3), second(1)})
  {
    CHECK(third_line(1, first(1), Q) == put_in(3, Q));
    CHECK(put_in(3, Q) == gathered(Q));
  }
}

CHECK_THAT("the machine finds the same P and Q from the equation alone")
{
  const auto r_n = corrections<Rational>(2);
  CHECK(r_n[1] == first(1));
  CHECK(r_n[2] == second(1));
}

CHECK_THAT("with (5) nothing is left of the equation of § 28 up to k⁴, and something of k⁶")
{
  const Rational length = 2;
  std::vector<Powers> r = {length * c(1), first(length), second(length)};
  std::vector<Powers> dr_sin;
  for(const Powers& part : r)
    dr_sin.push_back(-sin2 * derivative(part));
  const auto left = tautochrone::equation<Expansion>(Powers(length), Expansion::x(), Expansion(r),
                                                     Expansion(dr_sin), c(1));
  for(int order = 0; order <= 2; ++order)
    CHECK(left[order] == Powers(0));
  CHECK_FALSE(left[3] == Powers(0));
}

/*!
In the scan the first line and the last have suffered, and the second has a wrong figure, which may be the
scan's or the printer's. With these readings a line no longer vanishes when the right $P$ and $Q$ are put in;
here at $\cos\varphi = \tfrac35$, in fractions.
*/

double at_three_fifths(const Powers& line) { return static_cast<double>(line(Rational(3, 5))); }

const auto vanishes = [](double line) { return line == 0; };

double first_line(const Rational& a, const Powers& misread)
{
  return at_three_fifths(third_line(a, first(a), second(a)) + misread);
}

const Emendation square_of_a{
    "§30, first line, the term with PP",
    {"3a³PP cos²φ", [] { return first_line(2, (3 * 8 - 3 * 4) * first(2) * first(2) * c(2)); }},
    {"3aaPP cos²φ", [] { return first_line(2, 0); }},
    "all terms must be pure numbers, as sin²φ is: with a = 2 the line does not vanish otherwise", vanishes};

const Emendation cube_of_cosine{
    "§30, first line, the second term with P",
    {"3aP cos⁵φ", [] { return first_line(1, 3 * first(1) * (c(3) - c(5))); }},
    {"3aP cos³φ", [] { return first_line(1, 0); }},
    "it comes from kk r³ cos φ of §28, and only so does the line vanish", vanishes};

const Doubtful three_over{
    "§30, second line, the first fraction", {"6/cos⁴φ", [] { return at_three_fifths(put_in(6, second(1))); }},
    {"3/cos⁴φ", [] { return at_three_fifths(put_in(3, second(1))); }},
    "3PP cos²φ begins with 3/cos⁴φ; the 6 arises only in the next line, which is right", vanishes};

/*!
The same for the formula itself. With the misread power $r$ is larger by $kk\sin^2\varphi/a\cos\varphi$, and
misses the exact curve by more than the last term that Euler adds.
*/

const Emendation fourth_power{
    "§30, the radius of curvature",
    {"kk(1 − cos²φ)/a cos³φ", [] { return radius(1, 0.1, 30_deg) + 0.01 * 0.25 / std::cos(30_deg); }},
    {"kk(1 − cos⁴φ)/a cos³φ", [] { return radius(1, 0.1, 30_deg); }},
    "P of §29 has the fourth power, and the exact curve agrees with that alone",
    [](double r) {
      return r == within(highest(Fifty("0.1"), Fifty(30_deg)), 1e-4, "twice the next term, 4.1e-5");
    }};

/*!
Then what the formula leaves out. Close to Euler's own supposition, $kk$ small, the error must be $k^6r_3$,
with the coefficient that the machine finds next; and the smaller $k$ is, the more exactly so.
*/

CHECK_THAT("the error of (5) is the next term of the series, the more nearly the smaller k is")
{
  const Fifty angle_ = exact::pi() / 6;
  const Fifty r_3 = corrections<Fifty>(3)[3](cos(angle_));
  for(const char* k_ : {"1e-2", "1e-3", "1e-4"})
  {
    const Fifty kk = pow(Fifty(k_), 2);
    const Fifty left_out = highest(Fifty(k_), angle_) - truncated(2, Fifty(k_))(cos(angle_));
    CHECK(left_out / pow(kk, 3)
          == within_relative(r_3, 20 * static_cast<double>(kk), "the term after it is 17 kk times as large"));
  }
}

/*!
That $r = a$ in the vertical is less of a confirmation than it seems: each coefficient vanishes there of
itself. More can be said. Near the vertical the coefficients are $4\cdot3^{n-1}$ times $-(1-\cos\varphi)$, and
therefore every order that is kept takes the small swings nearer to equality by the factor $3kk/aa$ and no
more.
*/

CHECK_THAT("every coefficient vanishes in the vertical, and there begins with −4·3ⁿ⁻¹(1 − cos φ)")
{
  const auto r_n = corrections<Rational>(8);
  for(int n = 1; n <= 8; ++n)
  {
    CHECK(r_n[std::size_t(n)](Rational(1)) == 0);
    CHECK(derivative(r_n[std::size_t(n)])(Rational(1)) == 4 * pow(Rational(3), n - 1));
  }
}

CHECK_THAT("after n corrections a small swing is longer by ¼ φ₀² 3ⁿ κⁿ⁺¹/(1 + κ), where κ = kk/aa")
{
  const Fifty amplitude("1e-3");
  const Fifty kappa("0.01");
  for(int n = 0; n <= 3; ++n)
  {
    const Fifty law = pow(Fifty(3), n) * pow(kappa, n + 1) / (4 * (1 + kappa));
    CHECK(excess(truncated(n, Fifty("0.1")), Fifty("0.1"), amplitude) / pow(amplitude, 2)
          == within_relative(law, 2e-5, "the next power of the amplitude, 10⁻⁶, has a coefficient below 20"));
  }
}

CHECK_THAT("exact curves a twentieth of a apart at 50° agree to sixteen digits at 25°, but not to all")
{
  const Fifty k_("0.1");
  const auto right_side = [&](const Fifty& at, const exact::State& r) {
    return exact::State{tautochrone::slope(at, r[0], k_)};
  };
  const Fifty start = highest(k_, Fifty(50_deg)) + 0.05;
  const Fifty other = solve(right_side, Fifty(50_deg), {start}, Fifty(25_deg)).y[0];
  const Fifty apart = abs(other - highest(k_, Fifty(25_deg)));
  CHECK(apart == between(Fifty("1e-20"), Fifty("1e-16"), "exp(−(A(25°) − A(50°))/0.01) is 10⁻¹⁷"));
}

CHECK_THAT("the terms begin to grow after about A aa/kk of them, A = −½ − ln sin φ + ½ sin²φ")
{
  const auto r_n = corrections<Fifty>(24);
  for(const double degree : {30, 45, 60})
  {
    const Fifty angle_ = degree * exact::pi() / 180;
    const Fifty growth = r_n[24](cos(angle_)) / r_n[23](cos(angle_));
    CHECK(growth * falling(angle_) == within_relative(Fifty(24.25), 0.02, "the law is for large n"));
  }
}

/*!
## Notes

- Euler says nothing of how near *nearly* is. The coefficients grow like factorials, so that the series
  diverges whatever $k$ and $\varphi$ are. Its terms fall for about $A\,aa/kk$ orders, {{best|f0}} at the
  default inputs, and whoever stops there has done as well as can be done. His own condition, a small and
  heavy body on a long thread and no wide swings, is just what makes that number large.
- The equation loses its differential when it is solved by orders, since $dr$ is multiplied by $kk$ and so
  always enters with a coefficient already known. No constant of integration can appear. This hides that for
  given $a$ and $k$ the tautochrone is not unique: near the vertical the others differ from Euler's by a
  multiple of $\varphi$ to the power $aa/kk - 1$, smaller than every power of $kk$.
- Today the expansion would be called an asymptotic one, of a singularly perturbed equation.
*/
