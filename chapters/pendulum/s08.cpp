#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "pendulum/series.hpp"
#include "pendulum/tail.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 8, "The time of a half swing as a series")

using pendulum::ratio_by_mean, pendulum::series, pendulum::tail_bound;

/*!
## What Euler does

The time of half a swing becomes a series in powers of $cc = \sin^2\tfrac12\zeta$, with squares for its
coefficients. The element of time of {{sec pendulum.07}} is to be integrated from $z = 0$ to $z = c$. To have
the limits 0 and 1 he puts $z = cy$, and

$$ \frac{dt\sqrt{2g}}{\sqrt b} = \frac{dy}{\sqrt{(1-yy)(1-ccyy)}}. \tag{1} $$

::: margin
Today: $t\sqrt{2g/b} = K(c)$, the complete elliptic integral of the first kind; $2g$ is today's $g$.
:::

The first root stays as it is, and the second is expanded as a power with exponent $-\tfrac12$,

$$ \begin{aligned} \frac{1}{\sqrt{1-ccyy}} = 1 &+ \tfrac12 ccyy + \frac{1\cdot3}{2\cdot4}c^4y^4 \\
   &+ \frac{1\cdot3\cdot5}{2\cdot4\cdot6}c^6y^6 \\
   &+ \frac{1\cdot3\cdot5\cdot7}{2\cdot4\cdot6\cdot8}c^8y^8{{entry binomial_powers}} + \text{etc.},
   \end{aligned} \tag{2} $$

so that

$$ \begin{aligned} \frac{dt\sqrt{2g}}{\sqrt b} = \frac{dy}{\sqrt{1-yy}}\Bigl(1
   &+ \tfrac12 ccyy + \frac{1\cdot3}{2\cdot4}c^4y^4 \\
   &+ \frac{1\cdot3\cdot5}{2\cdot4\cdot6}c^6y^6 + \text{etc.}\Bigr). \end{aligned} \tag{3} $$

Each part is integrated from $y = 0$ to $y = 1$. The first gives

$$ \int{{entry integral_sign}}\frac{dy}{\sqrt{1-yy}} = \frac\pi2, \tag{4} $$

where π is the circumference of the circle of diameter 1. The others follow two powers of $y$ at a time, since
between these limits

$$ \int\frac{y^{n+1}dy}{\sqrt{1-yy}} =
\frac{n}{n+1}{{entry ladder_factor}}\int\frac{y^{n-1}dy}{\sqrt{1-yy}}, \tag{5} $$

and so

$$ \begin{aligned} \int\frac{yy{{entry powers}}\,dy}{\sqrt{1-yy}} &= \frac12\cdot\frac\pi2, \\
   \int\frac{y^4dy}{\sqrt{1-yy}} &= \frac12\cdot\frac34\cdot\frac\pi2, \\
   \int\frac{y^6dy}{\sqrt{1-yy}} &= \frac12\cdot\frac34\cdot\frac56\cdot\frac\pi2, \\
   \int\frac{y^8dy}{\sqrt{1-yy}} &= \frac12\cdot\frac34\cdot\frac56\cdot\frac78\cdot\frac\pi2,\quad\text{etc.}
   \end{aligned} \tag{6} $$

These are the fractions of {{eq 2}} once more. Each therefore enters twice, and the time is the series of
their squares,

$$ \begin{aligned} \frac{t\sqrt{2g}}{\sqrt b} = \frac\pi2\Bigl(1
   &+ \frac{1^2}{2^2}{{entry first_coefficient}}cc + \frac{1^2\cdot3^2}{2^2\cdot4^2}c^4 \\
   &+ \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}c^6 \\
   &+ \frac{1^2\cdot3^2\cdot5^2\cdot7^2}{2^2\cdot4^2\cdot6^2\cdot8^2}c^8 + \text{etc.}\Bigr).
   \end{aligned} \tag{7} $$

::: margin
Today: the bracket is ${}_2F_1(\tfrac12,\tfrac12;1;cc)$.
:::

He says nothing of convergence. Since $c < 1$ and all terms are positive, sum and integral may be exchanged.

## The program

The element, the expansion of its second root, and the integrals as fractions of $\tfrac12\pi$.
*/

Fifty element(const Fifty& y, const Fifty& c)  // (1) over dy
{
  return 1 / sqrt((1 - y * y) * (1 - c * c * y * y));
}

Fifty root(const Fifty& ccyy, int terms)  // (2)
{
  Fifty sum = 0, term = 1;
  for(int n = 1; n <= terms; ++n, term *= ccyy * (2 * n - 3) / (2 * n - 2))
    sum += term;
  return sum;
}

Rational ladder(int power)  // (4), (6), for an even power of y
{
  return power == 0 ? Rational(1) : Rational(power - 1, power) * ladder(power - 2);  // (5)
}

/*!
The series {{eq 7}} is used in many sections.

::: code pendulum/series.hpp series (7)
:::

How good is it after $N$ terms? Let $a_n = \tfrac12\cdot\tfrac34\cdots\tfrac{2n-1}{2n}$, and let $R_N$ be what
is left out of the bracket, from $a_N^2c^{2N}$ on. Its terms fall faster than the powers of $cc$, and so

$$ R_N < \frac{a_N^2c^{2N}}{1-cc}. \tag{A} $$

For small swings that is close. Near the top it says little, because $1 - cc$ vanishes. But
$a_n^2(n+\tfrac14)$ grows with $n$, towards $\frac1\pi$. With this limit in its place, or its value at
$n = N$, the sum can be done, and so $R_N$ is enclosed:

$$ \pi a_N^2(N+\tfrac14)\,B < R_N < B,\qquad B = \frac1\pi\sum_{n\ge N}\frac{c^{2n}}{n+\frac14}. \tag{B} $$

::: code pendulum/tail.hpp tail (B)
:::
*/

struct LeftOut
{
  Fifty R, lower, upper, geometric;
};

LeftOut left_out(const Fifty& c, const Fifty& s, int N)  // (A), (B)
{
  Fifty a = 1;
  for(int n = 1; n <= N; ++n)
    a *= Fifty(2 * n - 1) / Fifty(2 * n);
  const Fifty R = 1 / swing::oracle::agm(1, s) - series(c * c, N);  // (7), from the mean of §11
  const Fifty B = tail_bound(c, s, N);
  return {R, exact::pi() * a * a * (N + Fifty(0.25)) * B, B, a * a * pow(c, 2 * N) / (s * s)};
}

const auto swing_ = amplitude(90_deg);
const auto b = real("b", 1.0, metres, scale, "length of the equivalent simple pendulum");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second");
const auto N = integer("N", 10, 1, 2000, "terms of the series that are kept");

double by_terms(double zeta, int terms)  // (7)
{
  return std::numbers::pi / 2 * series(std::pow(std::sin(zeta / 2), 2), terms);
}

TELL
{
  require(swing_.eta >= 1e-150, "eta", "at least 1e-150rad, since (A) divides by its square");
  auto& rows = table("ladder", "The integrals (4) and (6), and the coefficients of (7)",
                     {{"power", "power of y"}, {"integral", "∫ : ½π"}, {"squared", "coefficient"}});
  for(int n = 0; n <= 4; ++n)
    rows.row({2LL * n, ladder(2 * n).str(), pow(ladder(2 * n), 2).str()});
  const bool wide = swing_.zeta > swing_.eta;  // the smaller of the two angles carries the digits
  const Fifty half = (wide ? swing_.eta : swing_.zeta).fifty() / 2;
  const Fifty c = wide ? cos(half) : sin(half), s = wide ? sin(half) : cos(half);
  const auto [R, lower, upper, geometric] = left_out(c, s, N);
  const double unit = std::sqrt(b) / std::sqrt(2 * g);
  tell("t", unit * swing::quarter_time({swing_.zeta, swing_.eta}), seconds, "time of half a swing");
  tell("kept", unit * by_terms(swing_.zeta, N), seconds, "the same by N terms of (7)");
  if(R > 1e-40)  // fifty digits tell no less
    tell("R", static_cast<double>(R), "R, what they leave out of the bracket of (7)");
  tell("lower", static_cast<double>(lower), "at least, by (B)");
  tell("upper", static_cast<double>(upper), "at most, by (B)");
  tell("geometric", static_cast<double>(geometric), "at most, by (A)");
}

TELL
{
  curve("lacking", {"terms", "R", "lower", "upper", "geometric"}, [](Curve& curve_) {
    for(const double zeta : {30_deg, 90_deg, 150_deg, 175_deg})
    {
      const Fifty c = sin(Fifty(zeta) / 2), s = cos(Fifty(zeta) / 2);
      for(int terms = 1; terms <= 2000; terms += 1 + terms / 12)
      {
        std::vector<double> row = {1.0 * terms};
        const auto [R, lower, upper, geometric] = left_out(c, s, terms);
        for(const Fifty& height : {R, lower, upper, geometric})
          row.push_back(static_cast<double>(height));
        if(R > 1e-17)
          curve_.put(row);
      }
      curve_.gap();
    }
  });
}

/*!
{{table ladder}}

Ten terms for the semicircle leave out {{R|8}}. By {{eq B}} this must lie between {{lower|8}} and {{upper|8}};
by {{eq A}} it need only be less than {{geometric|8}}. Nearer the top the difference is greater: try
`--zeta 179 --N 1000`.

::: figure pendulum-08
alt: What is left out against the number of terms, both logarithmic, at 30, 90, 150 and 175 degrees. The
wider the swing, the later the curve turns down.

What $N$ terms of {{eq 7}} leave out. The geometric bound {{eq A}}, grey, is close for a small swing and
useless for a wide one. The dots are both bounds {{eq B}}; they lie on the curve.
:::

## Speed against error

The bound can be put to use: add $B$ to the terms that are kept, and the error is less than $R_N/32N^2$. The
race is between the bare series, the series so closed, and the mean.
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
  race("half_swing", "t√(2g)/√b : ½π", ratio_by_mean(swing_.eta.fifty()), ways);
}

/*!
## Checks

First the integrals as they stand, infinite at the end.
*/

CHECK_THAT("the integral of the element from 0 to 1 is ½π over the mean, and the second root is its series")
{
  for(const double zeta : {10_deg, 90_deg, 170_deg})
  {
    const Fifty c = sin(Fifty(zeta) / 2), s = cos(Fifty(zeta) / 2), y = 0.5;
    CHECK(exact::integrate([&](const Fifty& x) { return element(x, c); }, 0, 1, Fifty("1e-20")).value
          == within(exact::pi() / 2 / swing::oracle::agm(1, s), 1e-23,
                    "half the digits are lost at the end"));
    CHECK(root(c * c * y * y, 90) / sqrt(1 - y * y)
          == within(element(y, c), 1e-49, "ninety terms, the n-th below 4⁻ⁿ"));  // (3)
  }
}

Fifty integral_of(int power)  // of y
{
  const auto part = [=](const Fifty& y) { return pow(y, power) / sqrt(1 - y * y); };
  return exact::integrate(part, 0, 1, Fifty("1e-20")).value;
}

CHECK_THAT("the ladder gives the integrals of the even powers, and they are the binomial fractions of (2)")
{
  for(int n = 0; n <= 20; ++n)
  {
    CHECK(ladder(2 * n) == (n % 2 == 0 ? 1 : -1) * exact::binomial(Rational(-1, 2), n));
    CHECK(integral_of(2 * n)
          == within(Fifty(ladder(2 * n)) * exact::pi() / 2, 1e-23, "half the digits are lost at the end"));
  }
}

CHECK_THAT(
    "the series is the time, and in double twenty thousand terms of it lose no more than their rounding")
{
  for(const double zeta : {1e-8, 1_deg, 30_deg, 90_deg, 150_deg, 162_deg})
    CHECK(left_out(sin(Fifty(zeta) / 2), cos(Fifty(zeta) / 2), 4000).R
          == within(0, 1e-45, "c⁸⁰⁰⁰ is 10⁻⁴³ at 162°, and 4000 roundings"));
  const double cc = std::pow(std::sin(175_deg / 2), 2);
  CHECK(series(cc, 20'000)
        == within_ulps(1 / swing::oracle::agm(1, sqrt(1 - Fifty(cc))), 200,
                       "√20000 is 141, for cc as given"));
}

/*!
The bounds {{eq B}} rest on one line: the quotient of $a_n^2(n+\tfrac14)$ and the one before it has a
numerator greater by one than its denominator, $(2n+1)^2(4n+5) - (2n+2)^2(4n+1) = 1$.
*/

CHECK_THAT("the bounds hold for every amplitude, because (2n+1)²(4n+5) exceeds (2n+2)²(4n+1) by one")
{
  for(long long n = 0; n < 4; ++n)  // four values prove a cubic
    CHECK((2 * n + 1) * (2 * n + 1) * (4 * n + 5) - (2 * n + 2) * (2 * n + 2) * (4 * n + 1) == 1);
  for(const double zeta : {10_deg, 90_deg, 150_deg, 179_deg})
    for(const int terms : {1, 2, 5, zeta < 2 ? 12 : 1000})
    {
      const Fifty c = sin(Fifty(zeta) / 2), s = cos(Fifty(zeta) / 2);
      const auto [R, lower, upper, geometric] = left_out(c, s, terms);
      CHECK(R == between(lower, upper, "a_n²(n+¼) lies between its value at N and 1/π"));
      CHECK(R == between(lower, geometric, "a_n² falls"));
      CHECK(upper - tail_bound(c, s, terms + 1)
            == within(pow(c, 2 * terms) / (exact::pi() * (terms + Fifty(0.25))), 1e-48,
                      "some 1000 roundings"));
      CHECK(upper / lower - 1 == between(0, 1.0 / (32 * terms * terms), "the next term of the law of a_n"));
    }
}

/*!
Our copy has halved or dropped most exponents. Each can be put right from its neighbours.
*/

const Emendation binomial_powers{
    "§8, the series of the root, twice",
    {"c²y², c³y³, c⁴y⁴", 1 + 0.16 / 2 + 3 * 0.16 / 8 + 15 * 0.064 / 48 + 105 * 0.0256 / 384},
    {"c⁴y⁴, c⁶y⁶, c⁸y⁸", static_cast<double>(root(0.16, 5))},
    "at cy = 0.4 the series must give the root from which it comes",
    [](double sum) { return sum == within(1 / std::sqrt(0.84), 3.1e-5, "less than 63/256·0.16⁵/0.84"); }};

const Emendation integral_sign{
    "§8, the first integral",
    {"dy/√(1−y²) = ½π", 1 / std::sqrt(0.75)},
    {"∫ dy/√(1−y²) = ½π", std::asin(1.0)},
    "without the sign it is a function of y, here taken at y = ½",
    [](double reading) { return reading == within_ulps(exact::pi() / 2, 1, "one arc sine"); }};

const Emendation ladder_factor{
    "§8, the factor of the reduction",
    {"π/(n+1)", std::numbers::pi / 2},
    {"n/(n+1)", 1.0 / 2},
    "for n = 1 it must lead from ∫dy/√(1−yy) to ∫yy dy/√(1−yy)",
    [](double factor) { return factor * integral_of(0) == within(integral_of(2), 1e-23, "as above"); }};

const Emendation powers{"§8, the four integrals",
                        {"y dy, y³dy, y⁵dy, y⁷dy", [] { return static_cast<double>(integral_of(7)); }},
                        {"yy dy, y⁴dy, y⁶dy, y⁸dy", [] { return static_cast<double>(integral_of(8)); }},
                        "the values beside them belong to the even powers; the proof takes the last",
                        [](double reading) {
                          return reading == within_ulps(exact::pi() * 35 / 256, 1, "½·¾·⅚·⅞·½π, rounded");
                        }};

const Emendation first_coefficient{
    "§8, the coefficient of cc",
    {"½", 1.0 / 2},
    {"1²/2²", 1.0 / 4},
    "it is what T/Θ − 1 is to cc in a very small swing, and §§10, 11 and 37 have it",
    [](double reading) {
      const Fifty c = Fifty(1e-6), T = 1 / swing::oracle::agm(1, sqrt(1 - c * c));
      return reading == within((T - 1) / (c * c), 1e-12, "the next term, 9/64 cc");
    }};

/*!
What is told, at the semicircle, near the top and for a small swing:
*/

Fifty first_terms(const Fifty& cc, int terms)  // the bracket of (7), from the fractions of (6)
{
  Fifty sum = 0;
  Fifty fraction = 1;
  for(int n = 0; n < terms; ++n)
  {
    sum += fraction * fraction * pow(cc, n);
    fraction *= Fifty(2 * n + 1) / (2 * n + 2);
  }
  return sum;
}

CHECK_THAT("the table has the fractions of (6) and their squares")
{
  for(const Told& now : told_at(""))
  {
    const auto rows = now.rows("ladder");
    const std::string fractions[] = {"1", "1/2", "3/8", "5/16", "35/128"};
    for(std::size_t i = 0; i < rows.size(); ++i)
    {
      CHECK(rows[i].value("power") == 2 * static_cast<int>(i));
      CHECK(rows[i].words("integral") == fractions[i]);
      CHECK(Rational(rows[i].words("squared").c_str()) == pow(Rational(fractions[i].c_str()), 2));
    }
  }
}

CHECK_THAT("the times told are the oracle's and the terms', and what is left out lies in its bounds")
{
  for(const Told& now : told_at("", "zeta=179 N=1000", "zeta=30 N=3 b=2", "zeta=150 N=40 g=1e80"))
  {
    const Fifty eta = swing_.eta.fifty(), cc = pow(cos(eta / 2), 2), T = swing::oracle::ratio_from_top(eta);
    const Fifty unit = sqrt(b.fifty() / (2 * g.fifty())) * exact::pi() / 2, sum = first_terms(cc, N),
                R = T - sum;
    CHECK(now.value("t", seconds) == within_relative(unit * T, 1e-15, "the library's bound, and the unit"));
    CHECK(now.value("kept", seconds)
          == within_relative(unit * sum, 4e-14, "cc rounds, and a half ulp a term"));
    CHECK(now.value("R") == within(R, 3e-16 * static_cast<double>(R) + 1e-46, "rounded to a double"));
    Fifty a = 1;
    for(int n = 1; n <= N; ++n)
      a *= Fifty(2 * n - 1) / (2 * n);
    const Fifty geometric = a * a * pow(cc, static_cast<int>(N)) / (1 - cc);
    CHECK(now.value("geometric") == within_relative(geometric, 4e-16, "rounded to a double"));
    const Fifty close = R * (1 + Fifty(1) / (32 * int(N) * int(N)));
    CHECK(now.value("upper") == between(R * (1 - 3e-16), close * (1 + 3e-16), "the law of a_n"));
    CHECK(now.value("lower") == between(2 * R - close * (1 + 3e-16), R * (1 + 3e-16), "the law of a_n"));
  }
}

CHECK_THAT("it refuses swings that end less than 10⁻¹⁵⁰ from the top, and no others")
{
  CHECK(refused_at("eta=9.999999999999997e-151rad"));
  CHECK(!refused_at("eta=1e-150rad"));
}

CHECK_THAT("every way of the race is the sum that it says it is")
{
  for(const Told& now : told_at("", "zeta=150", "zeta=30"))
  {
    const Fifty eta = swing_.eta.fifty(), cc = pow(cos(eta / 2), 2), T = swing::oracle::ratio_from_top(eta);
    CHECK(now.exact("half_swing") == within_relative(T, 1e-45, "two ways of fifty digits"));
    for(const int terms : {5, 12, 24, 44})
    {
      const Fifty sum = first_terms(cc, terms), R = T - sum;
      CHECK(now.method("half_swing", std::to_string(terms) + " terms")
            == within_relative(sum, 4e-15, "roundings"));
      CHECK(now.method("half_swing", std::to_string(terms) + " terms and B")
            == between(T - Fifty(1e-14), T + R / (32 * terms * terms) + Fifty(1e-14),
                       "B is above R by so little"));
    }
    CHECK(now.method("half_swing", "arithmetic-geometric mean") == within_ulps(T, 4, "its own bound"));
    CHECK(now.method("half_swing", "this edition") == within_ulps(T, 1, "the library's bound"));
  }
}

CHECK_THAT("the figure has what is left out, between its bounds")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("lacking", 9))
    {
      const double R = point.at("R"), n = point.at("terms");
      CHECK(point.value("upper") == between(R, R * (1 + 1 / (32 * n * n) + 1e-15), "the law of a_n"));
      CHECK(point.value("lower") == between(R * (1 - 1 / (32 * n * n) - 1e-15), R, "the law of a_n"));
      CHECK(point.value("geometric") == between(R, infinity, "a_n² falls"));
    }
  for(const Told& now : told_at(""))
  {
    const auto first = now.points("lacking").front();
    CHECK(
        first.value("R")
        == within_relative(swing::oracle::ratio_from_bottom(exact::pi() / 6) - 1, 4e-16, "30°, one term"));
    CHECK(first.value("terms") == within(1, 0, "a count"));
  }
}

/*!
## Go on from here

::: exercise
How many terms must be kept for the semicircle if what is left out of the bracket is to be less than
$10^{-10}$? Find it from {{eq A}} first.

answer: It takes 28. The geometric bound {{eq A}} halves with each term, and finds as many. What is left
out is $1.68\cdot10^{-10}$ with 27 terms and $0.81\cdot10^{-10}$ with 28, as the program tells.
:::
*/

CHECK_THAT("for the semicircle 28 terms leave out less than 10⁻¹⁰, and 27 do not")
{
  for(const Told& now : told_at("N=27"))
    CHECK(now.value("R") == within(1.68e-10, 0.005e-10, "as the answer has it"));
  for(const Told& now : told_at("N=28"))
  {
    CHECK(now.value("R") == within(0.81e-10, 0.005e-10, "as the answer has it"));
    CHECK(now.value("geometric") == between(0.81e-10, 1e-10, "(A)"));
  }
}
