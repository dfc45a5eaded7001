#include <vector>

#include "edition/section.hpp"
#include "exact/quadrature.hpp"

SECTION(pendulum, 19, "Down the ladder, from the eleventh power to the logarithm")

/*!
## What Euler does

The lemma of {{sec pendulum.18}} is put to work. The terms of the series need the integrals of $d\omega$ over
the odd powers of the sine, so $n$ is even. For $n = 2$ the lemma ends at once in the logarithm, as
{{sec pendulum.17}} already found,

$$ \int_\alpha\frac{d\omega}{\sin^3\omega} = \frac{\cos\alpha}{2\sin^2\alpha} -
     \frac{\cos\omega}{2\sin^2\omega}
   + \frac12\,l\,\frac{\operatorname{tg}\frac12\omega}{\operatorname{tg}\frac12\alpha}, \tag{1} $$

and each further one stands on the one before. For the third term of the series $n = 4$,

$$ \int_\alpha\frac{d\omega}{\sin^5\omega} = \frac{\cos\alpha}{4\sin^4\alpha} -
     \frac{\cos\omega}{4\sin^4\omega}
   + \frac34\int_\alpha\frac{d\omega}{\sin^3\omega}, \tag{2} $$

for the fourth $n = 6$, for the fifth $n = 8$,

$$ \int_\alpha\frac{d\omega}{\sin^7\omega} = \frac{\cos\alpha}{6\sin^6\alpha} -
     \frac{\cos\omega}{6\sin^6\omega}
   + \frac56\int_\alpha\frac{d\omega}{\sin^5\omega}, \tag{3} $$

$$ \int_\alpha\frac{d\omega}{\sin^9\omega} = \frac{\cos\alpha}{8\sin^8\alpha} -
     \frac{\cos\omega}{8\sin^8\omega}
   + \frac78\int_\alpha\frac{d\omega}{\sin^7\omega}, \tag{4} $$

and so on; with $n = 10$ he writes one more,

$$ \int_\alpha\frac{d\omega}{\sin^{11}\omega} = \frac{\cos\alpha}{10\sin^{10}\alpha} -
     \frac{\cos\omega}{10\sin^{10}\omega}
   + \frac9{10}\int_\alpha\frac{d\omega}{\sin^9\omega}, \qquad \text{etc.} \tag{5} $$

## The program

One rung of the ladder, and the ladder.
*/

template <class Real>
Real rung(int n, Real alpha, Real omega, Real lower)  // (1) to (5): of dω/sinⁿ⁺¹ω, from that of dω/sinⁿ⁻¹ω
{
  using std::cos, std::pow, std::sin;
  return cos(alpha) / (n * pow(sin(alpha), n)) - cos(omega) / (n * pow(sin(omega), n)) + (n - 1) * lower / n;
}

template <class Real>
std::vector<Real> ladder(Real alpha, Real omega)  // of dω/sin ω, dω/sin³ω, ..., dω/sin¹¹ω
{
  using std::log, std::tan;
  std::vector<Real> integrals{log(tan(omega / 2) / tan(alpha / 2))};
  for(const int n : {2, 4, 6, 8, 10})
    integrals.push_back(rung(n, alpha, omega, integrals.back()));
  return integrals;
}

/*!
Euler leaves both ends free. The program has the halves as its parameters, to keep his letters, and takes them
not small, so that everything can be seen.
*/

const auto alpha = angle("alpha", 30_deg, open(0_deg, 90_deg), "α = ½η, where the descent begins");
const auto omega = angle("omega", 75_deg, above_to(0_deg, 90_deg), "ω = ½ψ, down to which is integrated");

TELL
{
  require(omega > alpha, "omega", "greater than alpha");
  const auto integrals = ladder<double>(alpha, omega);
  require(std::isfinite(integrals.back()), "alpha",
      "an angle whose sine has a tenth power that a double can hold");
  tell("logarithm", integrals[0], "of dω/sin ω, the logarithm on which all stand");
  auto& rungs = table("rungs", "The five rungs, each made of two ends and of the rung below it.",
                      {{"n", "n"}, {"start", "cos α/(n sinⁿα)"}, {"end", "− cos ω/(n sinⁿω)"},
                       {"below", "(n−1)/n times the one below"}, {"integral", "∫dω/sinⁿ⁺¹ω", none, 12}});
  for(int n = 2; n <= 10; n += 2)
  {
    const auto i = static_cast<std::size_t>(n / 2);
    rungs.row({1.0 * n, rung<double>(n, alpha, 90_deg, 0), rung<double>(n, 90_deg, omega, 0),
               (n - 1) * integrals[i - 1] / n, integrals[i]});
  }
}

/*!
For the figure: how much of each integral is complete when ω has reached a given multiple of α.
*/

TELL
{
  curve("complete", {"x", "p1", "p3", "p5", "p7", "p9", "p11"}, [](Curve& c) {
    const auto whole = ladder(2.5_deg, 90_deg);
    for(double x = 1; x < 4; x += x < 1.1 ? 0.005 : 0.02)
    {
      const auto part = ladder(2.5_deg, x * 2.5_deg);
      c.put({x, part[0] / whole[0], part[1] / whole[1], part[2] / whole[2], part[3] / whole[3],
             part[4] / whole[4], part[5] / whole[5]});
    }
  });
}

/*!
{{table rungs}}

::: figure pendulum-19
alt: Part of each integral that is complete, against omega over alpha from 1 to 4. The curves for the powers 3
to 11 rise the sooner the higher the power; the curve for the first power hardly rises at all.

How much of each integral has been gathered when the pendulum has come to ω, for $\alpha = 2\tfrac12°$. The
higher the power, the nearer to the start all that matters has happened; only the first integral, the
logarithm, is spread over the whole descent.
:::

## Checks

The six integrals against quadrature, with both ends in play and for the whole descent from a small angle.
*/

Fifty quadrature(int power, const Fifty& from, const Fifty& to)
{
  return exact::integrate([&](const Fifty& y) { return 1 / pow(sin(from + y), power); }, 0, to - from).value;
}

CHECK_THAT("every rung is the integral that it is said to be")
{
  struct { double from, to; } const ends[] = {{30_deg, 75_deg}, {2.5_deg, 90_deg}, {60_deg, 61_deg}};
  for(const auto [from, to] : ends)
  {
    const auto integrals = ladder(Fifty(from), Fifty(to));
    for(std::size_t i = 0; i < 6; ++i)
      CHECK(integrals[i] == within_relative(quadrature(2 * static_cast<int>(i) + 1, from, to), 1e-38,
            "the quadrature"));
  }
}

CHECK_THAT("in double the ladder keeps its digits where the ends are far apart")
{
  const auto integrals = ladder(30_deg, 75_deg);
  const auto truth = ladder(Fifty(30_deg), Fifty(75_deg));
  for(std::size_t i = 0; i < 6; ++i)
    CHECK(integrals[i] == within_ulps(truth[i], 16,
          "a power of a rounded sine, eleven half ulps, and the sum"));
}

CHECK_THAT("the higher the power, the sooner the integral is nearly complete")
{
  const auto whole = ladder(2.5_deg, 90_deg);
  const auto twice = ladder(2.5_deg, 5_deg);
  for(std::size_t i = 1; i < 6; ++i)
    CHECK(twice[i] / whole[i] > twice[i - 1] / whole[i - 1]);
  CHECK(twice[5] / whole[5] > 0.99);
}

/*!
In the scan not one of the five lines is whole. On the left the powers are one too low; so are those under the
integrals on the right; under the cosines every power has become a square; and the logarithm has become an
integral of tangents, though "as we have found before" stands next to it. The damage is the same in all lines;
it is tried here in the second, {{eq 2}}, and in the first.
*/

const auto to_75 = [](int power) { return static_cast<double>(quadrature(power, 30_deg, 75_deg)); };
const auto five = [](double reading) {
  return reading == within_relative(quadrature(5, 30_deg, 75_deg), 1e-14, "a few roundings");
};

const Emendation left_powers{
    "§19, left sides", {"sin²ω, sin⁴ω, sin⁶ω, sin⁸ω, sin¹⁰ω; for n = 4: sin⁴ω", [] { return to_75(4); }},
    {"sin³ω, sin⁵ω, sin⁷ω, sin⁹ω, sin¹¹ω; for n = 4: sin⁵ω", [] { return to_75(5); }},
    "they must equal the right sides",
    [](double left) { return left == within_relative(ladder(30_deg, 75_deg)[2], 1e-14, "a few roundings"); }};

const Emendation right_powers{
    "§19, the integrals on the right", {"sin²ω, sin⁴ω, sin⁶ω, sin⁸ω; for n = 4: sin²ω", [] {
      return rung(4, 30_deg, 75_deg, to_75(2));
    }},
    {"sin³ω, sin⁵ω, sin⁷ω, sin⁹ω; for n = 4: sin³ω", [] { return rung(4, 30_deg, 75_deg, to_75(3)); }},
    "the lemma goes down by two powers", five};

const Emendation denominators{
    "§19, under the cosines", {"sin²α, sin²ω in every line; for n = 4", [] {
      const auto end = [](double angle) { return std::cos(angle) / (4 * std::pow(std::sin(angle), 2)); };
      return end(30_deg) - end(75_deg) + 0.75 * to_75(3);
    }},
    {"sinⁿα, sinⁿω; for n = 4 the fourth powers", [] { return rung(4, 30_deg, 75_deg, to_75(3)); }},
    "§18 has them", five};

const Emendation logarithm{
    "§19, n = 2", {"½ ∫ tg ½ω/tg ½α, an integral over ω", [] {
      const double tangents = -2 * std::log(std::cos(75_deg / 2) / std::cos(30_deg / 2));  // ∫ tg ½ω dω
      return rung(2, 30_deg, 75_deg, tangents / std::tan(15_deg));
    }},
    {"½ l (tg ½ω/tg ½α)", [] { return rung(2, 30_deg, 75_deg, ladder(30_deg, 75_deg)[0]); }},
    "§17 has found it",
    [](double reading) {
      return reading == within_relative(quadrature(3, 30_deg, 75_deg), 1e-14, "a few roundings");
    }};
