#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/series.hpp"
#include "pendulum/tail.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 8, "The time of a half swing as a series")

using pendulum::ratio_by_mean, pendulum::series, pendulum::tail_bound;

/*!
## What Euler does

The time of half a swing is an integral that has no closed form, and he makes a series of it. The element of
time in {{sec pendulum.07}} has to be integrated from the lowest point, $z = 0$, to the turning point,
$z = c$. The limits should be the same for all swings, and so he puts $z = cy$; then $y$ runs from 0 to 1,
and

$$ \frac{dt\sqrt{2g}}{\sqrt b} = \frac{dy}{\sqrt{(1-yy)(1-ccyy)}}. \tag{1} $$

::: margin
Today: $t\sqrt{2g/b} = K(c)$, the complete elliptic integral of the first kind; $2g$ is today's $g$.
:::

No integral that he knows gives it, so he makes a series of it. Of the two roots he leaves the first as it
stands and develops the second, in which $cc$ is small when the swing is:

$$ \begin{aligned} \frac{1}{\sqrt{1-ccyy}} = 1 + \tfrac12 ccyy &+ \frac{1\cdot3}{2\cdot4}c^4y^4
   + \frac{1\cdot3\cdot5}{2\cdot4\cdot6}c^6y^6 \\
   &+ \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8}c^8y^8 + \text{etc.}, \end{aligned} \tag{2} $$

so that

$$ \begin{aligned} \frac{dt\sqrt{2g}}{\sqrt b} = \frac{dy}{\sqrt{1-yy}}\Bigl(1 + \tfrac12 ccyy
   &+ \frac{1\cdot3}{2\cdot4}c^4y^4 \\
   &+ \frac{1\cdot3\cdot5}{2\cdot4\cdot6}c^6y^6 + \text{etc.}\Bigr). \end{aligned} \tag{3} $$

Each part is now integrated from $y = 0$ to $y = 1$. The first gives a quarter of the circle whose radius is
one,

$$ \int\frac{dy}{\sqrt{1-yy}} = \frac\pi2, \tag{4} $$

and the others hang on one another, two powers of $y$ at a time: between these limits

$$ \int\frac{y^{n+1}dy}{\sqrt{1-yy}} = \frac{n}{n+1}\int\frac{y^{n-1}dy}{\sqrt{1-yy}}, \tag{5} $$

whence, going up from {{eq 4}},

$$ \int\frac{yy\,dy}{\sqrt{1-yy}} = \frac12\cdot\frac\pi2,\qquad
   \int\frac{y^4dy}{\sqrt{1-yy}} = \frac12\cdot\frac34\cdot\frac\pi2, \tag{6} $$

$$ \begin{aligned} \int\frac{y^6dy}{\sqrt{1-yy}} &= \frac12\cdot\frac34\cdot\frac56\cdot\frac\pi2, \\
   \int\frac{y^8dy}{\sqrt{1-yy}} &= \frac12\cdot\frac34\cdot\frac56\cdot\frac78\cdot\frac\pi2.
   \end{aligned} \tag{7} $$

These are the very fractions that stand in {{eq 2}}. Each therefore comes in twice, once from the root and
once from the integral, and the time of half a swing is a series in which all of them are squared:

$$ \begin{aligned} \frac{t\sqrt{2g}}{\sqrt b} = \frac\pi2\Bigl(1 + \frac{1^2}{2^2}cc
   &+ \frac{1^2\cdot3^2}{2^2\cdot4^2}c^4 + \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}c^6 \\
   &+ \frac{1^2\cdot3^2\cdot5^2\cdot7^2}{2^2\cdot4^2\cdot6^2\cdot8^2}c^8 + \text{etc.}\Bigr).
   \end{aligned} \tag{8} $$

::: margin
Today: ${}_2F_1(\tfrac12,\tfrac12;1;cc)$.
:::

He says nothing of convergence. All terms are positive, so that the exchange of sum and integral is
harmless, and $c$ is less than one.

## The program

The integrand, the development of its second root, and the ladder of integrals, which is carried as a
fraction of $\tfrac12\pi$.
*/

double element(double y, double c)  // (1), without dy
{
  return 1 / std::sqrt((1 - y * y) * (1 - c * c * y * y));
}

template <class Real>
Real root(Real ccyy, int terms)  // (2)
{
  Real sum = 0;
  Real term = 1;
  for(int n = 1; n <= terms; ++n, term *= ccyy * Real(2 * n - 3) / Real(2 * n - 2))
    sum += term;
  return sum;
}

double element_by_series(double y, double c, int terms)  // (3), without dy
{
  return root(c * c * y * y, terms) / std::sqrt(1 - y * y);
}

Rational ladder(int power)  // (4) to (7): ∫ y^power dy/√(1−yy), over ½π, for an even power
{
  return power == 0 ? Rational(1) : Rational(power - 1, power) * ladder(power - 2);  // (5)
}

/*!
The series itself is used in many sections.

::: code pendulum/series.hpp series
:::

How good is it after $N$ terms? With $a_n$ for the fraction $\tfrac12\cdot\tfrac34\cdots\tfrac{2n-1}{2n}$,
what is left out, $R_N$, begins with $a_N^2c^{2N}$, and each of its terms is less than $cc$ times the one
before. A geometric series above, and another below, enclose it:

$$ \frac{a_N^2c^{2N}}{1 - cc\left(\frac{2N+1}{2N+2}\right)^2} < R_N < \frac{a_N^2c^{2N}}{1-cc}. \tag{9} $$

That is close for small swings. Near the top it says little, since $1 - cc$ vanishes. But
$a_n^2(n+\tfrac14)$ grows, and towards $\frac1\pi$; put the limit in the place of every one from $N$ on, or
that with $n = N$, and the sums can be done:

$$ \pi a_N^2(N+\tfrac14)\,B < R_N < B,\qquad B = \frac1\pi\sum_{n\ge N}\frac{c^{2n}}{n+\frac14}. \tag{10} $$

::: code pendulum/tail.hpp tail
:::
*/

template <class Real>
Real first_left_out(Real cc, int N)  // a_N² c²ᴺ
{
  Real term = 1;
  for(int n = 1; n <= N; ++n)
    term *= cc * Real(2 * n - 1) * Real(2 * n - 1) / (Real(2 * n) * Real(2 * n));
  return term;
}

struct Bounds
{
  Fifty geometric_lower, lower, upper, geometric_upper;
};

Bounds bounds(const Fifty& c, const Fifty& s, int N)  // (9) and (10)
{
  const Fifty term = first_left_out(c * c, N), next = Fifty(2 * N + 1) / Fifty(2 * N + 2);
  const Fifty upper = tail_bound(c, s, N);
  const Fifty share = exact::pi() * first_left_out(Fifty(1), N) * (N + Fifty(0.25));
  return {term / (1 - c * c * next * next), share * upper, upper, term / (s * s)};
}

/*!
What is really left out: for wide swings the mean less the terms kept, for others the terms themselves.
*/

Fifty left_out(const Fifty& c, const Fifty& s, int N)
{
  if(c * c > 0.5)
    return ratio_by_mean(2 * asin(s)) - series(1 - s * s, N);
  Fifty sum = 0, term = first_left_out(c * c, N);
  for(int n = N; n < N + 180; ++n)
  {
    sum += term;
    term *= c * c * pow(Fifty(2 * n + 1) / Fifty(2 * n + 2), 2);
  }
  return sum;
}

/*!
Free are the amplitude, which is $c$, the length $b$, the height $g$ that a body falls in the first second,
and the number of terms.
*/

const auto swing_ = amplitude(90_deg);
const auto b = real("b", 1.0, metres, positive, "length of the equivalent simple pendulum");
const auto g =
    real("g", 4.903325, metres, positive, "height fallen in the first second, half of today's g");
const auto N = integer("N", 10, 1, 2000, "terms of the series that are kept");

TELL
{
  auto& rows = table("ladder", "The integrals (4) to (7) and the coefficients of (8)",
                     {{"power", "power of y"},
                      {"integral", "∫ : ½π"},
                      {"squared", "coefficient"},
                      {"decimal", "the same", none, 8}});
  for(int n = 0; n <= 4; ++n)
  {
    const Rational a = ladder(2 * n);
    rows.row({2LL * n, a.str(), (a * a).str(), static_cast<double>(a * a)});
  }
  const Fifty c = sin(Fifty(swing_.zeta) / 2), s = sin(Fifty(swing_.eta) / 2);
  const auto [outer_low, low, high, outer_high] = bounds(c, s, N);
  const double K = swing::quarter_time({swing_.zeta, swing_.eta});
  tell("t", std::sqrt(b / (2 * g)) * K, seconds, "time of half a swing");
  tell("K", K, "the same as t√(2g)/√b, the integral of (1)");
  tell("kept", std::numbers::pi / 2 * series(std::pow(std::sin(swing_.zeta / 2), 2), N), "N terms of (8)");
  tell("R", static_cast<double>(left_out(c, s, N)), "R, what they leave out of the bracket of (8)");
  tell("low", static_cast<double>(low), "at least, by (10)");
  tell("high", static_cast<double>(high), "at most, by (10)");
  tell("outer_low", static_cast<double>(outer_low), "at least, by (9)");
  tell("outer_high", static_cast<double>(outer_high), "at most, by (9)");
}

/*!
The figure follows $R_N$ for four amplitudes.
*/

TELL
{
  curve("left_out", {"N", "R", "geometric_lower", "lower", "upper", "geometric_upper"}, [](Curve& curve_) {
    for(const double zeta : {30_deg, 90_deg, 150_deg, 175_deg})
    {
      const Fifty c = sin(Fifty(zeta) / 2), s = cos(Fifty(zeta) / 2);
      for(int terms = 1; terms <= 2000; terms += 1 + terms / 12)
      {
        const double R = static_cast<double>(left_out(c, s, terms));
        if(R < 1e-17)
          break;
        std::vector<double> row = {1.0 * terms, R};
        const auto [outer_low, low, high, outer_high] = bounds(c, s, terms);
        for(const Fifty& bound : {outer_low, low, high, outer_high})
          row.push_back(static_cast<double>(bound));
        curve_.put(row);
      }
      curve_.gap();
    }
  });
}

/*!
That $R_N$ is known so well can be put to use. Add $B$ to the terms kept, and what is still missing is less
than $R_N/32N^2$. The race is between the bare series, the series so closed, and the mean.
*/

TELL
{
  const double eta = swing_.eta, c = std::sin(swing_.zeta / 2), s = std::sin(eta / 2);
  std::vector<Method> ways;
  for(const int terms : {5, 12, 24, 44})
    ways.push_back({std::to_string(terms) + " terms", [=] { return series(c * c, terms); }, "bare"});
  for(const int terms : {5, 12, 24, 44})
    ways.push_back({std::to_string(terms) + " terms and B",
                    [=] { return series(c * c, terms) + tail_bound(c, s, terms); }, "closed"});
  ways.push_back({"arithmetic-geometric mean", [=] { return ratio_by_mean(eta); }});
  ways.push_back({"this edition", [=] { return swing::ratio({swing_.zeta, swing_.eta}); }});
  race("half_swing", "t√(2g)/√b : ½π", ratio_by_mean(Fifty(eta)), ways);
}

/*!
Ten terms for the semicircle leave out {{R|8}}, and {{eq 10}} knows it beforehand to lie between {{low|8}}
and {{high|8}}; by {{eq 9}} it is only known to lie between {{outer_low|8}} and {{outer_high|8}}.

::: figure pendulum-08
alt: What is left out against the number of terms, both logarithmic, at 30, 90, 150 and 175 degrees.

What $N$ terms of {{eq 8}} leave out. The shaded bands are the geometric bounds {{eq 9}}: close for a small
swing, useless for a wide one until the terms have begun to fail. The two bounds {{eq 10}} are drawn as
dots; no eye can part them from one another or from the curve.
:::

## Checks

The element {{eq 1}} first, integrated as it stands, with its infinite end; the mean must come out.
*/

CHECK_THAT("the integral of the element from 0 to 1 is ½π over the arithmetic-geometric mean")
{
  for(const double zeta : {10_deg, 90_deg, 170_deg})
  {
    const Fifty c = sin(Fifty(zeta) / 2);
    const auto integral = exact::integrate_from_ends(
        [&](const Fifty& y, const Fifty& gap) {
          return 1 / sqrt((gap > 0 ? gap : 1 - y) * (1 + y) * (1 - c * c * y * y));
        },
        Fifty(0), Fifty(1));
    const Fifty K = exact::pi() / 2 * ratio_by_mean(exact::pi() - zeta);
    CHECK(integral.value == within(K, 1e-36, "the rule's estimate, 1e-40, with room"));
    const double at_half = static_cast<double>(1 / sqrt(Fifty(0.75) * (1 - c * c / 4)));
    CHECK(element(0.5, std::sin(zeta / 2))
          == within_ulps(at_half, 4, "seven roundings, halved by the root"));
    const double summed = element_by_series(0.5, std::sin(zeta / 2), 40);
    CHECK(summed == within_ulps(at_half, 8, "forty terms, the n-th below 4⁻ⁿ"));
  }
}

/*!
Its factors: the coefficients of {{eq 2}} are binomial, exactly, and the ladder agrees with the integrals.
*/

CHECK_THAT(
    "the root's coefficients are those of the binomial series, and the same as the ladder's fractions")
{
  for(int n = 0; n <= 40; ++n)
  {
    const Rational sign = n % 2 == 0 ? 1 : -1;
    const Rational coefficient = root(Rational(1), n + 1) - root(Rational(1), n);
    CHECK(coefficient == sign * exact::binomial(Rational(-1, 2), n));
    CHECK(coefficient == ladder(2 * n));
  }
}

Fifty integral_of_power(int power)
{
  return exact::integrate_from_ends(
             [&](const Fifty& y, const Fifty& gap) {
               return pow(y, power) / sqrt((gap > 0 ? gap : 1 - y) * (1 + y));
             },
             Fifty(0), Fifty(1))
      .value;
}

CHECK_THAT("the ladder gives the integrals of the even powers")
{
  for(int power = 0; power <= 14; power += 2)
    CHECK(
        integral_of_power(power)
        == within(Fifty(ladder(power)) * exact::pi() / 2, 1e-36, "the rule's estimate, 1e-40, with room"));
}

CHECK_THAT("the series is the time, from the smallest swing to nine tenths of the way up")
{
  for(const double zeta : {1e-8_rad, 1_deg, 30_deg, 90_deg, 150_deg, 162_deg})
    CHECK(series(Fifty(pow(sin(Fifty(zeta) / 2), 2)), 4000)
          == within(ratio_by_mean(exact::pi() - zeta), 1e-40, "c⁸⁰⁰⁰ at 162° and 4000 roundings of 1e-50"));
}

/*!
The bracket {{eq 10}} rests on one line: the quotient of $a_n^2(n+\tfrac14)$ and the one before it has a
numerator that exceeds its denominator by exactly one, $(2n+1)^2(4n+5) - (2n+2)^2(4n+1) = 1$.
*/

CHECK_THAT("the bracket holds for every amplitude, because (2n+1)²(4n+5) exceeds (2n+2)²(4n+1) by one")
{
  for(long long n = 0; n < 1000; ++n)
    CHECK((2 * n + 1) * (2 * n + 1) * (4 * n + 5) - (2 * n + 2) * (2 * n + 2) * (4 * n + 1) == 1);
  for(const double zeta : {1e-6_rad, 10_deg, 90_deg, 150_deg, 179_deg})
    for(const int terms : {1, 2, 5, 20})
    {
      const Fifty c = sin(Fifty(zeta) / 2), s = cos(Fifty(zeta) / 2), R = left_out(c, s, terms);
      const auto [outer_low, low, high, outer_high] = bounds(c, s, terms);
      CHECK(R == between(low, high, "a_n²(n+¼) lies between its value at N and 1/π"));
      CHECK(R == between(outer_low, outer_high, "a_n² falls, and ever more slowly"));
      CHECK(high / low - 1 == between(0, 1.0 / (32 * terms * terms), "the next term of the law of a_n"));
    }
}

CHECK_THAT("at 179° the geometric bounds are a factor 14 apart after a thousand terms")
{
  const Fifty s = sin(exact::pi() / 360), c = cos(exact::pi() / 360);
  const auto [outer_low, low, high, outer_high] = bounds(c, s, 1000);
  CHECK(left_out(c, s, 1000) == within(Fifty("0.659781707745116542512683316685"), 1e-29, "thirty digits"));
  CHECK(outer_high / outer_low == within(14.11, 0.005, "1/(1 − cc) has overtaken 1000 terms"));
  CHECK(high / low - 1 == between(0, 3.2e-8, "one part in 32 N²"));
}

/*!
In double precision it matters little in which order twenty thousand terms are added, as long as $cc$ is
exactly what it is taken for.
*/

CHECK_THAT("twenty thousand terms at 175° lose fewer than two hundred units of the last place")
{
  const double cc = std::pow(std::sin(175_deg / 2), 2);
  const Fifty exact = ratio_by_mean(2 * asin(sqrt((1 - Fifty(cc)))));
  CHECK(series(cc, 20000) == within_ulps(exact, 200, "20000 random roundings: their root is 141"));
}

/*!
Now the scan. In this section it has halved most exponents, and each can be put right from its neighbours.
*/

double misread(double c, double y)
{
  const double cy = c * y;
  return 1 + cy * cy / 2 + 3. / 8 * cy * cy + 15. / 48 * std::pow(cy, 3) + 105. / 384 * std::pow(cy, 4);
}

const Emendation binomial_powers{
    "§8, the series of the root, twice",
    {"c²y², c³y³, c⁴y⁴", [] { return misread(0.5, 0.8); }},
    {"c⁴y⁴, c⁶y⁶, c⁸y⁸", [] { return root(0.16, 5); }},
    "the series must give the root from which it comes",
    [](double reading) {
      return reading == within(1 / std::sqrt(1 - 0.16), 3.1e-5, "left out: less than 63/256·0,16⁵/0,84");
    }};

const Emendation integral_sign{
    "§8, the first integral",
    {"dy/√(1−y²) = ½π", [] { return 1 / std::sqrt(1 - 0.5 * 0.5); }},
    {"∫ dy/√(1−y²) = ½π", [] { return std::asin(1.0); }},
    "without the sign it is a function of y, here taken at y = ½; the integral from 0 to 1 is a right "
    "angle",
    [](double reading) { return reading == within_ulps(exact::pi() / 2, 1, "one arc sine"); }};

const Emendation ladder_factor{
    "§8, the factor of the reduction",
    {"π/(n+1)", std::numbers::pi / 2},
    {"n/(n+1)", 1.0 / 2},
    "for n = 1 it must lead from ∫dy/√(1−yy) to ∫yy dy/√(1−yy)",
    [](double reading) {
      return reading == within(integral_of_power(2) / integral_of_power(0), 1e-15, "one rounding");
    }};

double four_integrals(int first)  // of the powers first, first+2, first+4, first+6
{
  Fifty sum = 0;
  for(int power = first; power < first + 8; power += 2)
    sum += integral_of_power(power);
  return static_cast<double>(sum);
}

const Emendation powers{
    "§8, the four integrals",
    {"y dy, y³dy, y⁵dy, y⁷dy", [] { return four_integrals(1); }},
    {"yy dy, y⁴dy, y⁶dy, y⁸dy", [] { return four_integrals(2); }},
    "the values printed beside them, ½·½π and so on, belong to the even powers; the proof adds all four",
    [](double reading) {
      const double values = std::numbers::pi / 2 * (1. / 2 + 3. / 8 + 15. / 48 + 105. / 384);
      return reading == within_ulps(values, 4, "a sum of four");
    }};

const Emendation first_coefficient{
    "§8, the coefficient of cc",
    {"½", 1.0 / 2},
    {"1²/2²", 1.0 / 4},
    "it is what T/Θ − 1 is to cc in a very small swing, and §§10, 11 and 37 have it",
    [](double reading) {
      const Fifty c = Fifty(1e-6);
      return reading == within((ratio_by_mean(2 * acos(c)) - 1) / (c * c), 1e-12, "the next term, 9/64 cc");
    }};
