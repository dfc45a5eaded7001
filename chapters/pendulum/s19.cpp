#include <map>

#include "edition/section.hpp"
#include "exact/quadrature.hpp"

SECTION(pendulum, 19, "Down the ladder, from the eleventh power to the logarithm")

/*!
## What Euler does

The lemma is put to work on the odd powers of the sine, from the third to the eleventh. With $n = 2$ it ends
at once in the logarithm, as {{sec pendulum.17}} has already found:

$$ \int_\alpha\frac{d\omega}{\sin^3\omega} = \frac{\cos\alpha}{2\sin^2\alpha} -
     \frac{\cos\omega}{2\sin^2\omega}
   + \frac12\,l{{entry logarithm}}\,\frac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}.
   \tag{1} $$

Each further integral stands on the one before. The third term of the series in {{sec pendulum.17}} needs
$n = 4$, the fourth $n = 6$, the fifth $n = 8$, and with $n = 10$ he writes one more:

$$ \begin{aligned}
   \int_\alpha\frac{d\omega}{\sin^5\omega}{{entry powers}} &=
   \frac{\cos\alpha}{4\sin^4\alpha}{{entry denominators}}
     - \frac{\cos\omega}{4\sin^4\omega} + \frac34\int_\alpha\frac{d\omega}{\sin^3\omega}, \\
   \int_\alpha\frac{d\omega}{\sin^7\omega} &= \frac{\cos\alpha}{6\sin^6\alpha}
     - \frac{\cos\omega}{6\sin^6\omega} + \frac56\int_\alpha\frac{d\omega}{\sin^5\omega}, \\
   \int_\alpha\frac{d\omega}{\sin^9\omega} &= \frac{\cos\alpha}{8\sin^8\alpha}
     - \frac{\cos\omega}{8\sin^8\omega} + \frac78\int_\alpha\frac{d\omega}{\sin^7\omega}, \\
   \int_\alpha\frac{d\omega}{\sin^{11}\omega} &= \frac{\cos\alpha}{10\sin^{10}\alpha}
     - \frac{\cos\omega}{10\sin^{10}\omega} + \frac9{10}\int_\alpha\frac{d\omega}{\sin^9\omega}, \qquad
     \text{etc.} \end{aligned} \tag{2} $$

## The program

One rung of the ladder, and the ladder.
*/

template <class Real>
Real rung(int n, Real alpha, Real omega, Real below)  // (2): ∫dω/sinⁿ⁺¹ω from ∫dω/sinⁿ⁻¹ω
{
  using std::cos, std::pow, std::sin;
  return cos(alpha) / (n * pow(sin(alpha), n)) - cos(omega) / (n * pow(sin(omega), n))
         + (n - 1) * below / n;
}

template <class Real>
std::map<int, Real> ladder(Real alpha, Real omega)  // (1), (2): the integrals, by the powers 1, 3, ..., 11
{
  using std::log, std::tan;
  std::map<int, Real> integrals{{1, log(tan(omega / 2) / tan(alpha / 2))}};
  for(int n = 2; n <= 10; n += 2)
    integrals[n + 1] = rung(n, alpha, omega, integrals[n - 1]);
  return integrals;
}

/*!
Euler leaves both ends free. By default they are wide enough apart, and α is not small, so that all pieces can
be seen.
*/

const auto alpha = angle("alpha", 30_deg, open(0_deg, 90_deg), "α = ½η, where the descent begins");
const auto omega = angle("omega", 75_deg, above_to(0_deg, 90_deg), "ω = ½ψ, at which the integral ends");

TELL
{
  require(alpha >= 1e-30, "alpha", "at least 1e-30rad, so that a double can hold the integrals");
  require(omega.fifty() >= alpha.fifty() * (1 + Fifty("1e-30")), "omega",
          "greater than alpha, by at least 1e-30 of it");
  auto integrals = ladder(alpha.fifty(), omega.fifty());  // the ends may nearly cancel
  tell("logarithm", double(integrals[1]), "the integral of dω/sin ω, on which all stand");
  auto& rungs = table("rungs", "The five rungs: each is made of two ends and the rung below",
                      {{"n", "n"},
                       {"start", "cos α/(n sinⁿα)"},
                       {"end", "− cos ω/(n sinⁿω)"},
                       {"below", "(n−1)/n times the one below"},
                       {"integral", "∫dω/sinⁿ⁺¹ω", none, 12}});
  for(int n = 2; n <= 10; n += 2)
    rungs.row({1. * n, rung<double>(n, alpha, 90_deg, 0), rung<double>(n, 90_deg, omega, 0),
               double((n - 1) * integrals[n - 1] / n), double(integrals[n + 1])});
}

TELL
{
  curve("complete", {"x", "p1", "p3", "p5", "p7", "p9", "p11"}, [](Curve& c) {
    auto whole = ladder(2.5_deg, 90_deg);
    for(double x = 1; x < 4; x += x < 1.1 ? 0.005 : 0.02)
    {
      std::vector<double> row{x};
      for(const auto& [power, part] : ladder(2.5_deg, x * 2.5_deg))
        row.push_back(part / whole[power]);
      c.put(row);
    }
  });
}

/*!
{{table rungs}}

::: figure pendulum-19
alt: Part of each integral that is complete, against omega over alpha from 1 to 4. The curves for the powers 3
to 11 rise the sooner the higher the power; the curve for the first power hardly rises at all.

How much of each integral up to 90° has been gathered when the pendulum has come to ω, for
$\alpha = 2\tfrac12°$. The higher the power, the nearer to the start its integral is decided; only the first,
the logarithm, is spread over the whole descent.
:::

## Checks
*/

Fifty quadrature(int power, const Fifty& from, const Fifty& to)
{
  return exact::integrate([&](const Fifty& y) { return 1 / pow(sin(from + y), power); }, 0, to - from)
      .value;
}

CHECK_THAT("every rung is the integral that it is said to be")
{
  struct
  {
    double from, to;
  } const ends[] = {{30_deg, 75_deg}, {2.5_deg, 90_deg}, {60_deg, 61_deg}};
  for(const auto [from, to] : ends)
    for(const auto& [power, integral] : ladder(Fifty(from), Fifty(to)))
      CHECK(integral == within_relative(quadrature(power, from, to), 1e-45, "the last digits of fifty"));
}

CHECK_THAT("the higher the power, the more of the integral is complete at ω = 2α")
{
  auto whole = ladder(2.5_deg, 90_deg);
  double before = 0;
  for(const auto& [power, part] : ladder(2.5_deg, 5_deg))
    CHECK(part / whole[power] > std::exchange(before, part / whole[power]));
}

/*!
In our copy none of the five lines is whole: under $d\omega$ all powers are one too low, under the cosines
every power is a square, and the logarithm has become an integral of tangents. The damage is the same in all
lines of {{eq 2}}; it is tried here in the first of them, from 30° to 75°, and in {{eq 1}}.
*/

double integral(int power)
{
  return static_cast<double>(quadrature(power, 30_deg, 75_deg));
}

bool is_integral(double reading, int power)
{
  return reading == within_relative(quadrature(power, 30_deg, 75_deg), 1e-14, "a few roundings");
}

const Emendation powers{"§19, the powers under dω, here for n = 4",
                        {"∫ dω/sin⁴ω = … + ¾ ∫ dω/sin²ω", [] { return integral(4) - 0.75 * integral(2); }},
                        {"∫ dω/sin⁵ω = … + ¾ ∫ dω/sin³ω", [] { return integral(5) - 0.75 * integral(3); }},
                        "left and right must differ by the two ends alone",
                        [](double ends) {
                          return ends
                                 == within_relative(rung(4, 30_deg, 75_deg, 0.), 1e-14, "a few roundings");
                        }};

const Emendation denominators{
    "§19, under the cosines, here for n = 4",
    {"cos α/(4 sin²α) − cos ω/(4 sin²ω)",
     [] { return rung(2, 30_deg, 75_deg, 0.) / 2 + 0.75 * integral(3); }},
    {"cos α/(4 sin⁴α) − cos ω/(4 sin⁴ω)", [] { return rung(4, 30_deg, 75_deg, integral(3)); }},
    "§18 has the nth powers; our copy has squares in every line",
    [](double right) { return is_integral(right, 5); }};

const Emendation logarithm{
    "§19, n = 2",
    {"½ ∫ tg ½ω/tg ½α",
     [] {
       const double tangents = -2 * std::log(std::cos(75_deg / 2) / std::cos(30_deg / 2));  // ∫ tg ½ω dω
       return rung(2, 30_deg, 75_deg, tangents / std::tan(15_deg));
     }},
    {"½ l (tg ½ω/tg ½α)", [] { return rung(2, 30_deg, 75_deg, ladder(30_deg, 75_deg)[1]); }},
    "§17 has found it; an integral over ω would be another number",
    [](double right) { return is_integral(right, 3); }};

/*!
What is told, by quadrature of each power:
*/

CHECK_THAT("the rungs told are the ends, the rung below and the integral")
{
  for(const Told& now :
      told_at("", "alpha=1e-9rad omega=90", "alpha=60 omega=60.5", "alpha=60 omega=60.0000000001"))
  {
    const Fifty a = alpha.fifty(), o = omega.fifty();
    const auto at = [&](int power) {
      const auto f = [&](const Fifty& y) { return pow(sin(a) / sin(a + y), power); };
      return exact::integrate(f, 0, o - a).value / pow(sin(a), power);
    };
    const Fifty log_of = log(tan(o / 2)) - log(tan(a / 2));
    CHECK(now.value("logarithm") == within_relative(log_of, 2e-16, "a rounding"));
    for(const auto& row : now.rows("rungs"))
    {
      const int n = static_cast<int>(row.at("n"));
      CHECK(row.value("start")
            == within_relative(cos(a) / (n * pow(sin(a), n)), 4e-15, "a rounded angle, n times"));
      const Fifty end = -cos(o) / (n * pow(sin(o), n));
      CHECK(row.value("end")
            == within(end, 4e-15 * std::abs(static_cast<double>(end)) + 1e-16, "the same; cos 90°"));
      CHECK(row.value("below") == within_relative(at(n - 1) * (n - 1) / n, 2e-16, "a rounding"));
      CHECK(row.value("integral") == within_relative(at(n + 1), 2e-16, "a rounding"));
    }
  }
}

CHECK_THAT("the figure has the part of each integral that is complete")
{
  const Fifty start = exact::pi() / 72;
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("complete", 4))
      for(const int power : {1, 3, 5, 7, 9, 11})
      {
        const Fifty here = quadrature(power, start, point.at("x") * start),
                    whole = quadrature(power, start, exact::pi() / 2);
        const std::string column = "p" + std::to_string(power);
        CHECK(point.value(column.c_str()) == within(here / whole, 1e-13, "rungs, and a rounded place"));
      }
}

CHECK_THAT("an α below 10⁻³⁰ is refused, and an ω that exceeds it by less than 10⁻³⁰ of it, and at these "
           "limits none")
{
  CHECK(refused_at("alpha=9.999999999999998e-31rad"));
  CHECK(!refused_at("alpha=1e-30rad"));
  for(const char* const too_near : {"alpha=60 omega=60.0000000000000000000000000000599",
                                    "alpha=1e-9rad omega=1.00000000000000000000000000000099e-9rad"})
    CHECK(refused_at(too_near));
  for(const char* const far_enough : {"alpha=60 omega=60.0000000000000000000000000000601",
                                      "alpha=1e-9rad omega=1.00000000000000000000000000000101e-9rad"})
    CHECK(!refused_at(far_enough));
}

/*!
## Go on from here

::: exercise
From $\alpha = 2\frac12°$ to $\omega = 2\alpha$, which part of its whole is each of the five integrals?
Think of powers of ω in the place of those of the sine.

answer: With powers it would be $1 - 2^{-n}$: three quarters, fifteen sixteenths, and so on to
$\frac{1023}{1024}$. From the tables for `--alpha 2.5 --omega 5` and `--omega 90` come 0.746, 0.937,
0.984, 0.996 and 0.999.
:::
*/

CHECK_THAT("at twice α all but 2⁻ⁿ of each integral is complete, nearly")
{
  for(const Told& now : told_at("alpha=2.5 omega=5"))
    for(const auto& row : now.rows("rungs"))
    {
      const int n = static_cast<int>(row.at("n"));
      const Fifty start = alpha.fifty(), rest = pow(Fifty(0.5), n);
      const Fifty whole = quadrature(n + 1, start, exact::pi() / 2);
      CHECK(row.value("integral") == within_relative(whole * (1 - rest), 0.006, "sines for angles"));
      const double told[] = {0.746, 0.937, 0.984, 0.996, 0.999};
      CHECK(row.value("integral")
            == within(told[n / 2 - 1] * whole, static_cast<double>(whole) * 0.5e-3, "three decimals"));
    }
}
