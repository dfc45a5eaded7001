#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 16, "The first term of the whole descent")

/*!
## What Euler does

The formula of {{sec pendulum.15}} also gives the time of the whole descent, from the first position $Ag$ to
the lowest, $AB$. One has only to put $\psi = 180°$. A quarter of that is 45°, whose tangent is 1, and so

$$ t = \frac{\sqrt b}{\sqrt{2g}}\,l\,\frac1{\operatorname{tg}\frac14\eta}
   = \frac{\sqrt b}{\sqrt{2g}}\,l\cot\tfrac14\eta{{entry quarters}}. \tag{1} $$

::: margin
Today: $t\sqrt{2g/b} = K(\cos\tfrac12\eta)$, of which $\ln\cot\tfrac14\eta =
\operatorname{artanh}\cos\tfrac12\eta$ is a part.
:::

This is only the first part of the whole value. Still, he says, it already determines the time of the whole
descent accurately enough; and to that end it will be worth the trouble to find out what correction the
following terms of the series can bring. With that he turns to them.

## The program

For η near 180°, a small swing, the tangent of $\tfrac14\eta$ is near 1 and its logarithm has few digits
left; there the inverse hyperbolic tangent of $\cos\tfrac12\eta = \sin\tfrac12\zeta$ serves.
*/

double first_term(const swing::Amplitude& a)  // (1), in units √(b/2g)
{
  return a.eta < 1 ? -std::log(std::tan(a.eta / 4)) : std::atanh(std::sin(a.zeta / 2));
}

/*!
Is it accurate enough? The next terms together bring $l\,2$ for a descent from near the top, as {{sec
pendulum.22}} will find. Of the whole, which is nearly $l(8:\eta)$ there, this is the part

$$ \frac{l\,2}{l\,8 - l\,\eta}, \tag{A} $$

and a logarithm grows slowly: whoever wants the part to be small has to go very near the top indeed.
*/

double start_for(double part)  // the η from which, by (A), this part is missing
{
  return 8 * std::exp2(-1 / part);
}

const auto swing_ = amplitude_from_top(5_deg);
const auto b = real("b", 1.0, metres, scale, "length of the equivalent simple pendulum");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

TELL
{
  const swing::Amplitude a{swing_.zeta, swing_.eta};
  const double unit = std::sqrt(b) / std::sqrt(2 * g), K = swing::quarter_time(a), first = first_term(a);
  tell("t", unit * K, seconds, "time of the whole descent");
  tell("t_first", unit * first, seconds, "the same by the first term, (1)");
  tell("K", K, "t√(2g)/√b");
  tell("first", first, "l cot ¼η");
  tell("missing", K - first, "what the first term leaves out");
  tell("part", (K - first) / K, percent, "the same as part of the whole");
  tell("percent_start", start_for(0.01), radians, "η from which it misses one per cent");
}

double missing_part(double eta)
{
  return 1 - first_term(swing::Amplitude::from_eta(eta)) / swing::quarter_time_from_top(eta);
}

TELL
{
  curve("parts", {"eta", "part"}, [](Curve& c) {
    for(double log_eta = 0; log_eta > -32; log_eta -= 0.1)
      c.put({std::pow(10, log_eta), missing_part(std::pow(10, log_eta))});
  });
  curve("examples", {"eta", "part"}, [](Curve& c) {
    for(const double eta : {5_deg, 1_deg, start_for(0.01)})
      c.put({eta, missing_part(eta)});
  });
}

/*!
At $\eta = 5°$, the first of the two examples that he will reckon, the first term gives {{first|8}} and the
truth is {{K|8}}; {{part|percent1}} is missing, and "accurately enough" is too much said. He takes it back
himself when the second term, in {{sec pendulum.17}}, brings a quarter. What is missing is nearly the same
for all starts near the top, and the whole grows so slowly that only one per cent of it is missing from
{{percent_start|e2}} of a radian: on a circle of a metre's radius far less than the width of an atomic
nucleus.

::: figure pendulum-16
alt: The missing part against η. It falls from 38 per cent at one radian to 1 per cent at 6e-30 radians.

What part of the descent the first term misses. The dots are Euler's own two examples, 5° and 1°, and the
start from which one per cent is missing.
:::

## Checks

The formula against the integral that it is, and at both ends of the scale.
*/

Fifty integral_of_first_term(double eta)
{
  return exact::integrate([](const Fifty& psi) { return 1 / (2 * sin(psi / 2)); }, eta, exact::pi()).value;
}

CHECK_THAT(
    "the first term is the integral of dψ/2 sin ½ψ from η to 180°, from 1e-307 up to the smallest swings")
{
  for(const double eta : {1_deg, 5_deg, 57_deg, 58_deg, 120_deg})
    CHECK(first_term(swing::Amplitude::from_eta(eta))
          == within_ulps(integral_of_first_term(eta), 2, "a tangent and a logarithm"));
  CHECK(first_term(swing::Amplitude::from_eta(1e-307))
        == within_ulps(log(Fifty(4) / 1e-307), 2, "ηη is nothing here"));
  CHECK(first_term(swing::Amplitude::from_zeta(1e-150)) == within_ulps(0.5e-150, 1, "ζζ is nothing here"));
}

/*!
What it leaves out tends to $l\,2$ from above. The bounds are those of the time itself: with $s =
\sin\tfrac12\eta$ it is more than $l\frac4s$ and less than $(1+\tfrac14ss)\,l\frac4s$.
*/

CHECK_THAT("what the first term leaves out lies between ln 2 and what the bounds of the time allow")
{
  for(const double start : {1e-300, 1e-8, 1_deg, 5_deg, 30_deg, 90_deg})
  {
    const Fifty eta = start, s = sin(eta / 2), first = -log(tan(eta / 4));
    const Fifty least = exact::ln2() - 2 * log(cos(eta / 4));  // l(4/s) less the first term
    CHECK(swing::oracle::K_from_complement(s) - first
          == between(least - 1e-46, least + s * s * log(4 / s) / 4 + 1e-46, "and fifty digits' rounding"));
  }
  const auto a = swing::Amplitude::from_eta(1e-300);
  CHECK(swing::quarter_time(a) - first_term(a)
        == within(exact::ln2(), 2.3e-13, "two numbers near 690, an ulp each"));
}

CHECK_THAT("fifteen per cent is missing at 5°, eleven at 1°, and one from a start of 8 : 2¹⁰⁰")
{
  CHECK(100 * missing_part(5_deg) == printed("15.4"));
  CHECK(100 * missing_part(1_deg) == printed("11.3"));
  CHECK(missing_part(start_for(0.01)) == within(Fifty(0.01), 3e-16, "(A) is exact to ηη; two ulps of 1"));
}

/*!
Our copy has ½ for ¼ in both expressions.
*/

const Emendation quarters{
    "§16, tangent and cotangent",
    {"tg ½η, cot ½η", [] { return -std::log(std::tan(5_deg / 2)); }},
    {"tg ¼η, cot ¼η", [] { return -std::log(std::tan(5_deg / 4)); }},
    "at 5° it must be the integral of the first term; §31 there has the cotangent of 1° 15'",
    [](double reading) {
      return reading == within_ulps(integral_of_first_term(5_deg), 2, "two roundings");
    }};

/*!
What is told, at Euler's five degrees, at a right angle, near the top and far from it:
*/

CHECK_THAT("the times told are K and its first term in seconds, and what is missing is their difference")
{
  for(const Told& now : told_at("", "eta=90 b=2", "eta=1e-200rad g=1e-90", "zeta=1e-9 b=1e100"))
  {
    const Fifty eta = swing_.eta.fifty(), s = sin(eta / 2), K = swing::oracle::K_from_complement(s);
    const Fifty first = -log(tan(eta / 4)), unit = sqrt(b.fifty() / (2 * g.fifty()));
    const char* const why = "a root each, a product, and the library's ulp";
    CHECK(now.value("t", seconds) == within_relative(unit * K, 6e-16, why));
    CHECK(now.value("t_first", seconds) == within_relative(unit * first, 9e-16, why));
    CHECK(now.value("K") == within_ulps(K, 1, "the library's bound"));
    CHECK(now.value("first") == within_ulps(first, 3, "a tangent and a logarithm"));
    const double of_K = 4e-16 * static_cast<double>(K);
    CHECK(now.value("missing")
          == within(K - first, of_K, "two numbers, rounded before they are subtracted"));
    CHECK(now.value("part", percent) == within((K - first) / K, 5e-16, "the same"));
    CHECK(now.value("percent_start", radians) == within_relative(pow(Fifty(2), -97), 1e-15, "8 : 2¹⁰⁰"));
  }
}

CHECK_THAT("the figure's part is what the time's own bounds leave, at all its points")
{
  for(const Told& now : told_at(""))
    for(const char* const drawn : {"parts", "examples"})
      for(const auto& point : now.points(drawn, 12))
      {
        const Fifty eta(point.at("eta")), s = sin(eta / 2), K = swing::oracle::K_from_complement(s);
        CHECK(point.value("part")
              == within(1 + log(tan(eta / 4)) / K, 5e-16, "one less a rounded quotient"));
      }
}

/*!
## Go on from here

::: exercise
From which start would a tenth be missing? And half of the whole?

answer: By {{eq A}} from $8 : 2^{10}$ of a radian, 0.448°, where the program tells 10.0003 per cent. For
half it would be 2 radians, or 115°, which is not near the top any more; there {{eq A}} fails, and the
program tells 65 per cent.
:::
*/

CHECK_THAT(
    "a tenth is missing from 1/128 of a radian; at 2 radians, where (A) has a half, it is 65 per cent")
{
  CHECK(start_for(0.1) == within_ulps(Fifty(1) / 128, 2, "a power of two"));
  CHECK(start_for(0.5) == within_ulps(Fifty(2), 2, "a power of two"));
  for(const Told& now : told_at("eta=0.0078125rad"))
    CHECK(now.value("part", percent) == within(0.100003, 0.5e-6, "six digits"));
  for(const Told& now : told_at("eta=2rad"))
    CHECK(now.value("part", percent) == within(0.65, 0.005, "two digits"));
}
