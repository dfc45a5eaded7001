#include <optional>

#include "edition/section.hpp"
#include "edition/series.hpp"
#include "tautochrone/analytic.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/ways.hpp"

SECTION(tautochrone, 25, "An equation of the first order, and its many curves")

using namespace tautochrone;

/*!
## What Euler does

With the angle $\varphi$ in place of $x$ and $z$ the equation of the tautochrone gets two variables and first
differentials, but even so they cannot be separated. For since $d\varphi = dz/r$, one has

$$ \begin{gathered} dz = r\,d\varphi, \quad dx = r\,d\varphi\sin\varphi, \\
  x = \int r\,d\varphi\sin\varphi. \end{gathered} \tag{1} $$

Put into the equation of {{sec tautochrone.24}}, this gives

$$ \begin{aligned} \sqrt{kk+rr} &= \frac{r\sin\varphi\sqrt{kk+aa}}{\sqrt{2ax}}, \\
  2ax &= \frac{(aa+kk)\,rr\sin^2\varphi}{kk+rr}, \end{aligned} \tag{2} $$

and by differentiation

$$ \begin{aligned} a\,dx ={}& \frac{(aa+kk)\,rr\,d\varphi\sin\varphi\cos\varphi}{kk+rr} \\
  &+ \frac{(aa+kk)\,kk\,r\,dr\sin^2\varphi}{(kk+rr)^2{{entry square}}}. \end{aligned} \tag{3} $$

With the value of $dx$ from {{eq 1}} and divided by $r\sin\varphi$ it becomes

$$ \begin{aligned} a\,d\varphi ={}& \frac{(aa+kk)\,r\,d\varphi\cos\varphi}{kk+rr} \\
  &+ \frac{(aa+kk)\,kk\,dr\sin\varphi}{(kk+rr)^2}. \end{aligned} \tag{4} $$

::: margin
Two lines that our copy has between {{eq 2}} and {{eq 3}} repeat {{eq 3}} in a garbled form and are left
out here.
:::

That $r = a$ for $\varphi = 0$ seems to choose one solution. It does not. For $\varphi = 0$ {{eq 4}}
leaves $dr$ undetermined, and demands only $r = a$ or $r = kk/a$. If $k < a$, infinitely many solutions
leave the place $r = a$ together, and differ by multiples of $\varphi$ to the power $(aa-kk)/kk$. Each is a
tautochrone for the same body, with the same time, as far as its cheek goes: to where $dr = 0$. Two have
their ends in finite terms. The one that lets the pendulum rise highest ends at

$$ \tan\varphi = \frac{a-k}{\sqrt{ak}}, \qquad x = \frac{(a-k)^2}{2a}, \tag{A} $$

the one that lets it swing widest at

$$ \varphi = 90° - 2\arctan\frac ka, \qquad r = k. \tag{B} $$

Through every place with $a(kk+rr) \le (aa+kk)\,r\cos\varphi$ passes one of them.

## The program

The slope by {{eq 4}}, and the curves, which are followed from their ends towards the vertical, where all
errors die ({{api tautochrone::at}}). For $k < a/5000$ the steps are too many, and only the highest is told,
which need not be followed from its end:

::: code tautochrone/curve.hpp slope (4)
:::
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.3, metres, scale, "radius of gyration");
const auto phi =
    angle("phi",
          at_most(40_deg, "where the highest curve ends",
                  [] {  // rounded, at k near a, that may be beyond the widest one's end
                    return k < a ? std::min(end(Member::highest, k / a).phi, end(Member::widest, k / a).phi)
                                 : 40_deg;
                  }),
          above_to(0_deg, 90_deg), "angle at which the curves are looked at");
const auto phi1 = angle("phi1", 50_deg, above_to(0_deg, 90_deg), "angle of a place of the reader's");
const auto r1 = real("r1", 0.4, metres, scale, "radius of curvature at that place");

bool passes(double small, double angle_, double r)  // whether a curve that can be wound passes there, a = 1
{
  return (1 + small * small) * r * std::cos(angle_) >= small * small + r * r;
}

int digits_of_s(double small)  // as many as are left of 1 − k/a when k/a is rounded, but one or two
{
  return std::clamp(14 + int(std::floor(std::log10(1 - small))), 1, 12);
}

TELL
{
  const double small = k / a;
  require(small >= 1e-9, "k", "at least 1e-9 a and less than a");
  require(small < 1, "k", "at least 1e-9 a and less than a: else r would grow with φ");
  const Position top = end(Member::highest, small), tip = end(Member::widest, small);
  require(phi <= tip.phi, "phi", "at most 90° − 2 arctan(k/a), where the widest curve ends");
  if(phi <= top.phi)
  {
    const Position here = at(Member::highest, small, phi);
    tell("r_highest", a * here.r, metres, "r of the curve that rises highest");
    tell("x_highest", a * here.x, metres, "its height");
    tell("s_highest", a * here.s, metres, "the arc of its cheek", digits_of_s(small));
  }
  const bool few_steps = small >= 2e-4;
  if(few_steps)
  {
    const Position wide = at(Member::widest, small, phi);
    tell("r_widest", a * wide.r, metres, "r of the curve that reaches widest");
    tell("x_widest", a * wide.x, metres, "its height");
  }
  if(few_steps && passes(small, phi1, r1 / a) && phi <= phi1)
    tell("r_through", a * at_through(small, phi1, r1 / a, phi).r, metres,
         "r of the curve through the reader's place");
  const Fifty ratio = k.fifty() / a.fifty();
  tell("end_highest", double(highest_end(ratio).phi), degrees, "where the highest curve ends, (A)");
  tell("height", double(a.fifty() * pow(1 - ratio, 2) / 2), metres, "how high that is");
  tell("end_widest", double(widest_end(ratio).phi), degrees, "where the widest curve ends, (B)");
}

/*!
One of the curves is singled out in another way: it has a series in powers of $h = 1 - \cos\varphi$,

$$ \frac ra = \sum b_m h^m, \qquad \cos\varphi = \sum x_m S^{2m}, \tag{C} $$

$S$ being $\sin\varphi : \sqrt{1 + kk/rr}$, and the coefficients are fractions where $kk/aa$ is one. There
is no such curve where $aa/kk$ is an odd number from three on; instead of the power of $h$ there is then a
term $h^m\,l\,h$.
*/

const auto num = integer("num", 1, 1, 100, "kk/aa as a fraction: its numerator");
const auto den = integer("den", 100, 1, 100, "its denominator");
const auto m = integer("m", 3, 1, 12, "the coefficient that is wanted");

TELL
{
  const Rational kappa(num, den);
  const int place_ = resonance(kappa);
  const auto i = static_cast<std::size_t>(int(m));
  if(place_ > 0)
    tell("logarithmic", logarithmic_coefficient(kappa), "the coefficient of h to the power m₀ times l h");
  tell("m0", place_, "the power where the series fails, 0 for none");
  if(place_ == 0 || m < place_)
    tell("b", radius_series(kappa, m)[i], "b of that number");
  if(place_ == 0 || m <= place_)
    tell("x_m", cosine_series(kappa, m)[i], "x of that number");
}

TELL
{
  curve("plane", {"phi", "r", "kind"}, [](Curve& out) {
    const auto draw = [&](double last, double kind, auto r) {
      for(int i = 1; i <= 100; ++i)
      {
        const double here = std::min(last, last * i / 100);
        out.put({here / 1_deg, r(here), kind});
      }
      out.block();
    };
    const double small = 0.3, tip = end(Member::widest, small).phi, top = end(Member::highest, small).phi;
    draw(top, 0, [=](double x) { return at(Member::highest, small, x).r; });
    draw(tip, 0, [=](double x) { return at(Member::widest, small, x).r; });
    for(const auto& [x1, y1] :
        {std::pair{20_deg, 0.45}, {30_deg, 0.3}, {40_deg, 0.42}, {35_deg, 0.75}, {25_deg, 0.88}})
      draw(x1, 1, [=, x = x1, y = y1](double at_) { return at_through(small, x, y, at_).r; });
    draw(46_deg, 2, [](double x) { return euler_r<double>(1, 0.3, x); });
    for(const double sign : {1.0, -1.0})  // where dr = 0
      draw(tip, 3, [=](double x) {
        const double half = 1.09 * std::cos(x) / 2;
        return half + sign * std::sqrt(std::max(0.0, half * half - 0.09));
      });
  });
}

/*!
For $k = \tfrac3{10}a$ the highest curve has at 40° the radius {{r_highest|8}} m, the widest
{{r_widest|8}} m, and both had $r = a$ in the vertical. They end at {{end_highest|deg2}} and
{{end_widest|deg2}}.

::: figure tautochrone-25
alt: The plane of angle and radius for k three tenths of a. Seven tautochrones start together at angle zero
and radius one and spread downwards like a fan. A dotted line bounds them above on the right and has its tip
at 57 degrees; the curves that reach it end there level. Euler's curve starts with them, crosses the
others and runs down to the dotted line.

Tautochrones of one body, $k = \tfrac3{10}a$: all leave the place $r = a$ of the vertical together, and
all have the same time. Dotted, where $dr = 0$: beyond it no cheek can go. In blue the highest and the
widest, to their ends; in green five others, as far as the places by which they were chosen; in vermilion, for
comparison, Euler's curve of {{sec tautochrone.30}}.
:::

## Speed against error

Many ways lead to the number $r$ at an angle; the outer place from which they start is that of the highest
curve. Followed forwards, from 5°, every error grows as the curves spread. A polynomial that satisfies the
equation in $n$ places is good if it is told the outer value; without, the more places the better it can
imitate the differences of the curves, and it takes one for another. For $k = \tfrac1{10}a$ and as far as 40°
twenty places do without the outer value; with more of them the result gets worse, not better.
*/

double fault(std::optional<double> outer,
             int n)  // of n places to 40°, k = a/10: of a, 1 where all is wrong
{
  const std::vector<double> angles{10_deg, 20_deg, 30_deg};
  const std::vector<double> found = collocation(0.1, 40_deg, outer, n, angles);
  double worst = 0;
  for(std::size_t i{0}; i < angles.size(); ++i)
  {
    const double error = std::abs(found[i] - at(Member::highest, 0.1, angles[i]).r);
    worst = error < 1 ? std::max(worst, error) : 1;
  }
  return worst;
}

TELL
{
  curve("places", {"n", "told", "untold"}, [](Curve& out) {
    const double outer = at(Member::highest, 0.1, 40_deg).r;
    for(int n = 8; n <= 100; n += 4)
      out.put({double(n), fault(outer, n) + 1e-17, fault(std::nullopt, n)});
  });
}

/*!
::: figure tautochrone-25-places
alt: The error against the number of places, on a logarithmic scale. Told the outer value, it falls to the
last digit of a double by 24 places and stays there. Without, it falls as fast to a few parts of a million
million, is least at 20 places, and then rises raggedly by many powers of ten, at times to one.

The error of $r/a$, the greatest of those at 10°, 20° and 30°, when a polynomial satisfies the equation in $n$
places up to 40°, $k = \tfrac1{10}a$. Where it is told the outer value (blue), more places are better; where
it is not, the equation does not say which of the curves is meant, and soon any rounding decides.
:::

Backwards any integrator will do. The edition's takes neither $\varphi$ nor $r$, but $H = 1 - \cos\varphi$ and
two numbers $Y$ and $Z$, as $r$ to $k$, whose squares make up $\sin^2\varphi$: so the equation becomes a flow
on a sphere,

$$ \begin{aligned} \dot H &= Z^2, \qquad \dot Y = \varepsilon Z, \\
  \dot Z &= (1-H)Z - \varepsilon Y, \qquad \varepsilon = \frac k{1+kk} \end{aligned} \tag{D} $$

for $a = 1$, of products alone. By $Y$ instead of the time only one equation is left: a power series of 24
terms, or 32, costs little more than two sums of squares a term, and carries far; and as errors die, it need
not be so good in the beginning. Of many places those that lie in one step are found together. The second race
is for the whole curve, $r$ at 64 angles.
*/

constexpr int places = 64;

std::vector<double> evenly(double to)  // 64 angles up to this one
{
  std::vector<double> angles;
  for(int i = 1; i <= places; ++i)
    angles.push_back(to * i / places);
  return angles;
}

double mean_by_flow(double small, double to)
{
  double sum = 0;
  for(const Position& now : along(Member::highest, small, evenly(to)))
    sum += now.r;
  return sum / places;
}

Fifty mean_exactly(const Fifty& small, double to)
{
  std::vector<Fifty> angles;
  for(const double angle_ : evenly(to))
    angles.emplace_back(angle_);
  Fifty sum = 0;
  for(const Fifty& r : highest(small, angles))
    sum += r;
  return sum / places;
}

struct Integrator  ///< one of GSL's
{
  const char* name;
  Stepper stepper;
  double each;  ///< what a step may err by
};

constexpr Integrator integrators[]{{"Runge and Kutta, 10⁻¹⁵", Stepper::runge_kutta, 1e-15},
                                   {"Adams, 10⁻¹³", Stepper::adams, 1e-13},
                                   {"Gear, 10⁻¹³", Stepper::gear, 1e-13},
                                   {"Bulirsch and Stoer, 10⁻¹⁵", Stepper::bulirsch_stoer, 1e-15}};

double mean_by(const Integrator& by, double small, double to)
{
  const Position last = end(Member::highest, small);
  std::vector<double> angles = evenly(to);
  std::reverse(angles.begin(), angles.end());
  double sum = 0;
  for(const double r : follow(small, last.phi, last.r, angles, by.each, by.stepper))
    sum += r;
  return sum / places;
}

TELL
{
  const double small = k / a;
  const Position last = end(Member::highest, small);
  if(small < 0.1 || phi <= 5_deg || phi >= last.phi)
    return;  // there the usual ways are too stiff, or there is nothing to race for
  const double to = phi, r5 = at(Member::highest, small, 5_deg).r,
               outer = at(Member::highest, small, last.phi).r;
  std::vector<Method> ways{{"flow on the sphere", [=] { return at(Member::highest, small, to).r; }}};
  ways.push_back(
      {"backwards, 10⁻⁷", [=] { return follow(small, last.phi, last.r, to, 1e-7, Stepper::runge_kutta); }});
  for(const Integrator& by : integrators)
    ways.push_back({std::string("backwards, ") + by.name,
                    [=] { return follow(small, last.phi, last.r, to, by.each, by.stepper); }});
  ways.push_back(
      {"forwards, 10⁻¹³", [=] { return follow(small, 5_deg, r5, to, 1e-13, Stepper::runge_kutta); }});
  for(const int n : {16, 32, 64})
    ways.push_back({std::to_string(n) + " places, outer value",
                    [=] { return collocation(small, last.phi, outer, n, {to})[0]; }, "collocation"});
  for(const int n : {16, 64})
    ways.push_back({std::to_string(n) + " places, without",
                    [=] { return collocation(small, last.phi, std::nullopt, n, {to})[0]; },
                    "collocation without"});
  illustration("r/16 places, without", "it has no value to be near to: no solution is singled out");
  illustration("r/64 places, without", "the same");
  race("r", "r/a", highest(k.fifty() / a.fifty(), phi.fifty()), ways);
  std::vector<Method> whole{{"flow, on one way", [=] { return mean_by_flow(small, to); }}};
  for(const Integrator& by : integrators)
    whole.push_back({by.name, [=] { return mean_by(by, small, to); }});
  race("mean", "r/a at 64 angles, their mean", mean_exactly(k.fifty() / a.fifty(), to), whole);
}

/*!
## Checks
*/

CHECK_THAT("(3) is the differential of (2), for any r: by differences in fifty digits")
{
  const Fifty a_ = 2, kk("0.36"), x("0.7"), h("1e-16");
  const auto r = [](const Fifty& y) { return 2 * cos(y) + y * y / 10; };
  const auto twice_ax = [&](const Fifty& y) {
    return (a_ * a_ + kk) * pow(r(y) * sin(y), 2) / (kk + r(y) * r(y));
  };
  const Fifty dr = (r(x + h) - r(x - h)) / (2 * h), u = kk + r(x) * r(x);
  CHECK(
      (twice_ax(x + h) - twice_ax(x - h)) / (4 * h)
      == within_relative(
          (a_ * a_ + kk) * (r(x) * r(x) * sin(x) * cos(x) / u + kk * r(x) * dr * pow(sin(x), 2) / (u * u)),
          1e-28, "the square of the step"));
}

CHECK_THAT(
    "the curves told are those of fifty digits, followed back from other places, and their heights are (2)")
{
  for(const Told& now : told_at("", "a=2e50 k=2e49 phi=30 r1=1e50", "k=0.8 phi=2 phi1=3 r1=0.85",
                                "k=0.02 phi=20 phi1=30 r1=0.5", "phi=55"))
  {
    const Fifty small = k.fifty() / a.fifty(), kk = small * small, s = sin(phi.fifty());
    const auto height = [&](const Fifty& r) {
      return a.fifty() * (1 + kk) * r * r * s * s / (kk + r * r) / 2;
    };
    if(phi < end(Member::highest, k / a).phi)
    {
      const Fifty r = highest(small, phi.fifty());
      CHECK(now.value("r_highest", metres)
            == within_relative(a.fifty() * r, 5e-14, "the library's bound, and k/a"));
      CHECK(now.value("x_highest", metres) == within_relative(height(r), 5e-14, "the same"));
      CHECK(now.value("s_highest", metres) == within_relative(a.fifty() * (1 - r), 2e-13, "the same"));
    }
    const double tip = end(Member::widest, k / a).phi, between_ = phi + (tip - phi) / 2;
    const Fifty wide = through(small, between_, at(Member::widest, k / a, between_).r, {phi.fifty()})[0];
    CHECK(now.value("r_widest", metres) == within_relative(a.fifty() * wide, 5e-13, "the same"));
    CHECK(now.value("x_widest", metres) == within_relative(height(wide), 5e-13, "the same"));
    if(phi <= phi1)
      CHECK(now.value("r_through", metres)
            == within_relative(a.fifty()
                                   * through(small, phi1.fifty(), r1.fifty() / a.fifty(), {phi.fifty()})[0],
                               5e-13, "the same"));
    CHECK(now.value("end_highest", degrees)
          == within_relative(atan((1 - small) / sqrt(small)), 2e-15, "six ulps, and k/a"));
    CHECK(now.value("height", metres)
          == within_relative(a.fifty() * pow(1 - small, 2) / 2, 3e-15, "the same"));
    CHECK(now.value("end_widest", degrees)
          == within_relative(exact::pi() / 2 - 2 * atan(small), 3e-15, "the same"));
  }
  for(const Told& now : told_at("k=0.9999999 phi=1e-6"))  // all of the curves is as small as 1 − k/a
  {
    CHECK(now.value("end_highest", degrees)
          == within_relative((1 - k.fifty()) / sqrt(k.fifty()), 1e-13,
                             "the angle's own tangent, and k as written"));
    CHECK(now.value("height", metres) == within_relative(pow(1 - k.fifty(), 2) / 2, 1e-15, "the same"));
    CHECK(now.value("s_highest", metres)
          == within_relative(1 - highest(k.fifty(), phi.fifty()), 1e-6, "seven digits of 1 − k/a are k's"));
  }
  for(const Told& now : told_at("k=1e-5 phi=40"))  // the others would take 10¹⁰ steps
    CHECK(now.value("r_highest", metres)
          == within_relative(highest(k.fifty(), phi.fifty()), 5e-14, "the library's bound"));
}

CHECK_THAT("on both curves the height by (2) is the integral of r sin φ: so the virtual arc is √(2fx), and "
           "all swings are equal")
{
  for(const Member which : {Member::highest, Member::widest})
    for(const double small : {0.05, 0.3, 0.8})
    {
      const double last = end(which, small).phi * 0.999;
      for(const Drawn& place_ : drawn(which, small, {last * 0.2, last * 0.7, last}))
        CHECK(place_.by_arc == within_relative(place_.at.x, 1e-12, "the library's bound"));
    }
}

CHECK_THAT("the highest curve ends where dr = 0, at (A), and the widest at the tip, where both branches of "
           "dr = 0 meet")
{
  for(const double small : {0.02, 0.3, 0.99})
  {
    const Fifty s = small, kk = s * s;
    const auto top = highest_end(s), tip = widest_end(s);
    for(const auto& [phi_, r] : {std::pair{top.phi, top.r}, {tip.phi, tip.r}})
      CHECK((1 + kk) * r * cos(phi_) == within_relative(kk + r * r, 1e-45, "closed forms"));
    CHECK((1 + kk) * pow(top.r * sin(top.phi), 2) / (kk + top.r * top.r)
          == within_relative(pow(1 - s, 2), 1e-45, "2x by (2)"));
    CHECK(pow((1 + kk) * cos(tip.phi) / 2, 2) == within_relative(kk, 1e-45, "the discriminant of dr = 0"));
  }
}

CHECK_THAT(
    "it refuses an angle beyond the widest curve's end, a body with k = a and one with less than 1e-9 a")
{
  for(const char* const within_them : {"k=1e-9", "k=0.9999999999999999", "k=2e-9 a=2", "k=1.9999 a=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"k=9.99999999999999e-10", "k=1", "k=1.9999e-9 a=2", "k=2 a=2"})
    CHECK(refused_at(beyond));
  CHECK(!refused_at("k=0.99999999999999"));
  for(const std::string body : {"k=0.267949192431122706", "a=2 k=0.535898384862245413"})  // a tan 15°
  {
    CHECK(!refused_at(body + " phi=59.9999999999"));
    CHECK(refused_at(body + " phi=60.0000000001"));
  }
}

CHECK_THAT("the coefficients told satisfy the equation of the curve, term by term in fractions")
{
  for(const Told& now : told_at("", "num=2 den=7 m=5", "num=3 den=1 m=7", "num=1 den=2 m=12"))
  {
    const Rational kappa(num, den), eps2 = kappa / ((1 + kappa) * (1 + kappa));
    const std::vector<Rational> x = cosine_series(kappa, m + 1), b = radius_series(kappa, m);
    exact::Series<Rational> X(x, m + 1), slope_ = derivative(X);  // in T = SS; dX/dS = 2S dX/dT
    const exact::Series<Rational> T = exact::Series<Rational>::x(m + 1);
    CHECK(X * X + 4 * eps2 * T * slope_ * slope_ == (1 - T).truncated(m));  // XX + ε²(dX/dS)² = 1 − SS
    const exact::Series<Rational> r =
        exact::Series<Rational>(1 + kappa) / (Rational(-2) * slope_);  // r = −f S/(dX/dS)
    CHECK(compose(exact::Series<Rational>(b, m), (1 - X).truncated(m)) == r);
    CHECK(now.value("x_m") == x[static_cast<std::size_t>(int(m))]);
    CHECK(now.value("b") == b[static_cast<std::size_t>(int(m))]);
    CHECK(now.value("m0") == 0);
  }
}

CHECK_THAT("for aa = 3kk and aa = 5kk there is no such series, but a logarithm with the coefficient 2, and "
           "with 27")
{
  for(const Told& now : told_at("num=1 den=3", "num=1 den=5", "num=2 den=10 m=1"))
  {
    const bool three = Rational(num, den) == Rational(1, 3);
    CHECK(now.value("logarithmic") == Rational(three ? 2 : 27));
    CHECK(now.value("m0") == (three ? 1 : 2));
    if(m == 1)
      CHECK(now.value("b") == Rational(-3));  // −(1 + κ)/(1 − 3κ)
  }
}

CHECK_THAT("(4) is the flow (D) on the sphere H(2 − H) = YY + ZZ, by differences along the exact curve")
{
  const Fifty small("0.3"), eps = small / (1 + small * small), x("0.7"), h("1e-7");
  struct On
  {
    Fifty H, Y, Z;
  };
  const auto on = [&](const Fifty& angle_) -> On {
    const Fifty r = highest(small, angle_), part = sin(angle_) / sqrt(small * small + r * r);
    return {1 - cos(angle_), r * part, small * part};
  };
  const On now = on(x), up = on(x + h), low = on(x - h);
  CHECK(now.H * (2 - now.H)
        == within_relative(now.Y * now.Y + now.Z * now.Z, 1e-45, "a sine and a cosine"));
  const Fifty rate = (up.H - low.H) / (now.Z * now.Z);  // of the flow's time
  const char* const why = "the square of the step";
  CHECK((up.Y - low.Y) / rate == within_relative(eps * now.Z, 1e-12, why));
  CHECK((up.Z - low.Z) / rate == within_relative((1 - now.H) * now.Z - eps * now.Y, 1e-12, why));
}

CHECK_THAT("backwards and by the outer value the ways of the race come to the curve; forwards they lose "
           "what the spreading takes")
{
  for(const Told& now : told_at("", "k=0.25 phi=30", "a=2 k=0.6 phi=48"))
  {
    const Fifty small = k.fifty() / a.fifty(), r = highest(small, phi.fifty()),
                mean = mean_exactly(small, phi);
    CHECK(now.exact("r") == within_relative(at(Member::highest, k / a, phi).r, 1e-13, "two routes"));
    CHECK(now.method("r", "flow on the sphere") == within_relative(r, 5e-14, "the library's bound"));
    CHECK(now.method("r", "backwards, 10⁻⁷") == within(r, 2e-7, "the last steps' errors"));
    for(const Integrator& by : integrators)
    {
      const bool higher = by.stepper == Stepper::runge_kutta || by.stepper == Stepper::bulirsch_stoer;
      const double eps = higher ? 3e-13 : 1e-11;
      CHECK(now.method("r", std::string("backwards, ") + by.name)
            == within(r, eps, "the last steps' errors, many of them where the order is low"));
      CHECK(now.method("mean", by.name) == within(mean, eps, "the same"));
    }
    CHECK(now.method("mean", "flow, on one way") == within_relative(mean, 5e-14, "the library's bound"));
    double alone = 0;
    for(const double angle_ : evenly(phi))
      alone += at(Member::highest, k / a, angle_).r;
    CHECK(now.exact("mean") == within_relative(alone / places, 1e-13, "two routes"));
    const double spread = std::exp(double((falling(5_deg) - falling(phi.fifty())) / (small * small)));
    CHECK(now.method("r", "forwards, 10⁻¹³") == within(r, 1e-12 * spread, "what curves part by, at most"));
    for(const auto& [n, eps] : {std::pair{16, 1e-3}, {32, 1e-5}, {64, 1e-9}})
      CHECK(now.method("r", std::to_string(n) + " places, outer value")
            == within(r, eps, "each doubling nearly squares the error"));
  }
}

CHECK_THAT("told the outer value the polynomial is good to the last digits with many places, untold it is "
           "spoilt by them")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("places"))
    {
      const double n = point.at("n"), falls = std::pow(10, -n / 2 - 2);
      CHECK(point.value("told")
            == between(0, std::max(falls, 1e-12), "half a digit a place, then roundings"));
      const double least = n < 40 ? 0 : 1e-10, most = n > 16 ? 1 : falls;
      CHECK(point.value("untold")
            == between(least, most, "as good with few places; with many any rounding decides"));
    }
}

CHECK_THAT("in the figure every curve satisfies (4) between its points, Euler's is § 30's, and the dotted "
           "line has dr = 0")
{
  for(const Told& now : told_at(""))
  {
    const auto all = now.points("plane");
    for(std::size_t i = 10; i < all.size(); i += 40)
    {
      const double kind = all[i].at("kind");
      const Fifty x = Fifty(all[i].at("phi")) * exact::pi() / 180, small("0.3"), kk = small * small;
      const Fifty r = all[i].at("r");
      CHECK(all[i].value("kind") == between(0, 3, "four kinds"));
      CHECK(all[i].value("phi") == between(0, 57, "up to the tip"));
      if(kind == 2)
        CHECK(all[i].value("r") == within(truncated(2, small)(cos(x)), 1e-13, "the library's bound"));
      else if(kind == 3)
        CHECK((1 + kk) * r * cos(x) == within(kk + r * r, 1e-14, "a root"));
      else if(i % 100 > 2)
      {
        const Fifty before = Fifty(all[i - 2].at("phi")) * exact::pi() / 180;
        CHECK(all[i - 2].value("r")
              == within(through(small, x, r, {before})[0], 2e-13, "both are rounded"));
      }
    }
  }
}

/*!
In {{eq 3}} our copy has $(kk+ar)^2$ below. At $a = 2$, $k = \tfrac35$ and the place of the exact curve at
30° the reading is tried in {{eq 4}}.
*/

double last_term(bool square_)  // of (3)
{
  const Fifty small("0.3"), x = exact::pi() / 6, r = 2 * highest(small, x), dr = 2 * slope(x, r / 2, small),
                            kk("0.36");
  return double((4 + kk) * kk * r * dr * pow(sin(x), 2) / pow(kk + (square_ ? r : Fifty(2)) * r, 2));
}

const Emendation square{
    "§25, a dx, the last denominator",
    {"(kk + ar)²", [] { return last_term(false); }},
    {"(kk + rr)²", [] { return last_term(true); }},
    "a quotient's differential has the square of its denominator, and only that leaves a dx = a r dφ sin φ",
    [](double term) {
      const Fifty small("0.3"), x = exact::pi() / 6, r = 2 * highest(small, x), kk("0.36");
      const Fifty rest = 2 * r * sin(x) - (4 + kk) * r * r * sin(x) * cos(x) / (kk + r * r);
      return term == within_relative(rest, 1e-14, "a difference");
    }};

/*!
## Go on from here

::: exercise
How far can a body with $k = \tfrac12a$ swing in equal times, and how high?

answer: `--k 0.5 --phi 30`: at most to 36.87°, by {{eq B}}, but then not so high as by {{eq A}}, where it
rises $\tfrac18a$ and swings 35.26°. For $k = a$ nothing is left.
:::

::: exercise
For $\kappa = kk : aa = \tfrac13$ there is no series in powers of $h$. Put $r = a(1 + \beta h\,l\,h + \dots)$
into {{eq 4}} and find $\beta$.

answer: The terms with $h\,l\,h$ cancel whatever $\beta$ is, and those with $h$ demand $\beta = 2$:
`--num 1 --den 3` tells the logarithmic coefficient.
:::
*/

CHECK_THAT(
    "for k = a/2 the ends are at 35.26°, one eighth of a high, and 36.87°; for κ = 1/3 the logarithm has 2")
{
  for(const Told& now : told_at("k=0.5 phi=30"))
  {
    CHECK(now.value("end_highest", degrees) == within(35.26_deg, 0.005_deg, "four digits"));
    CHECK(now.value("height", metres) == within_ulps(Fifty(0.125), 8, "the library's bound"));
    CHECK(now.value("end_widest", degrees) == within(36.87_deg, 0.005_deg, "four digits"));
  }
  for(const Told& now : told_at("num=1 den=3"))
    CHECK(now.value("logarithmic") == Rational(2));
}
