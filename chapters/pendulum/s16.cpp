#include "edition/section.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 16, "The first term of the whole descent")

/*!
## What Euler does

The formula of {{sec pendulum.15}} also gives the time of the whole descent, from the first position $Ag$ to
the lowest, $AB$. One has only to put $\psi = 180°$. A quarter of that is 45°, whose tangent is 1, and so

$$ t = \frac{\sqrt b}{\sqrt{2g}}\,l\,\frac1{\operatorname{tg}\frac14\eta}
   = \frac{\sqrt b}{\sqrt{2g}}\,l\cot\tfrac14\eta. \tag{1} $$

::: margin
Today: $K(\cos\tfrac12\eta)$, and $\ln\cot\tfrac14\eta = \operatorname{artanh}\cos\tfrac12\eta$.
:::

This is only the first part of the whole value. Still, he says, it already fixes the time of the whole descent
accurately enough; but it will be worth the trouble to find out what correction the following terms of the
series bring. With that he turns to them.

## The program

The formula is one line, or two. For η near 180°, a small swing, the tangent of $\tfrac14\eta$ is near 1 and
its logarithm has few digits left; there the inverse hyperbolic tangent of
$\cos\tfrac12\eta = \sin\tfrac12\zeta$ serves.
*/

double first_term(const swing::Amplitude& a)  // (1), in units √(b/2g)
{
  return a.eta < 1 ? -std::log(std::tan(a.eta / 4)) : std::atanh(std::sin(a.zeta / 2));
}

/*!
Is it accurate enough? The correction that the next terms bring is not small, as {{sec pendulum.17}} will
find; together they bring $l\,2$ for a descent from the very top. Of the whole, which is nearly $l(8:\eta)$
there, this is the part

$$ \frac{l\,2}{l\,8 - l\,\eta}, \tag{2} $$

and a logarithm grows slowly: whoever wants the part to be small has to go very near the top indeed.
*/

double start_for(double part)  // the η from which, by (2), no more than this part is missing
{
  return 8 * std::exp2(-1 / part);
}

/*!
Free are η, the length and $g$.
*/

const auto swing_ = amplitude_from_top(5_deg);
const auto b = real("b", 1.0, metres, positive, "length of the equivalent simple pendulum");
const auto g =
    real("g", 4.903325, metres, positive, "height fallen in the first second, half of today's g");

TELL
{
  const swing::Amplitude a{swing_.zeta, swing_.eta};
  const double unit = std::sqrt(b / (2 * g)), K = swing::quarter_time(a), first = first_term(a);
  tell("t", unit * K, seconds, "time of the whole descent");
  tell("t_first", unit * first, seconds, "the same by the first term, (1)");
  tell("K", K, "t√(2g)/√b");
  tell("first", first, "l cot ¼η");
  tell("missing", K - first, "what the first term leaves out");
  tell("part", (K - first) / K, percent, "the same as part of the whole");
  tell("percent_start", start_for(0.01), radians, "η from which it misses no more than one per cent");
}

/*!
From the height of the axis, where there is nothing small about η, to a start that no experiment will ever
make.
*/

TELL
{
  auto& rows = table("rows", "The whole descent and its first term",
                     {{"eta", "η", degrees, 4},
                      {"K", "t√(2g/b)", none, 12},
                      {"first", "l cot ¼η", none, 12},
                      {"missing", "missing", none, 8},
                      {"part", "part", percent, 4}});
  for(const double eta : {90_deg, 30_deg, 10_deg, 5_deg, 1_deg, 0.1_deg, 1e-3_deg, 1e-6_deg, 1e-30})
  {
    const auto a = swing::Amplitude::from_eta(eta);
    const double K = swing::quarter_time(a), first = first_term(a);
    rows.row({eta, K, first, K - first, (K - first) / K});
  }
  curve("part", {"eta", "part", "law"}, [](Curve& c) {
    for(double log_eta = 0; log_eta > -32; log_eta -= 0.1)
    {
      const double eta = std::pow(10, log_eta);
      const auto a = swing::Amplitude::from_eta(eta);
      const double K = swing::quarter_time(a);
      c.put({eta, 1 - first_term(a) / K, std::log(2) / (std::log(8) - std::log(eta))});
    }
  });
  curve("examples", {"eta", "part"}, [](Curve& c) {
    for(const double eta : {5_deg, 1_deg, start_for(0.01)})
      c.put({eta, 1 - first_term(swing::Amplitude::from_eta(eta)) / swing::quarter_time_from_top(eta)});
  });
}

/*!
At $\eta = 5°$ the first term gives {{first|8}} and the truth is {{K|8}}; {{part|percent1}} is missing. What
is missing is much the same for all starts near the top; the whole grows, but so slowly that one per cent is
reached only at {{percent_start|e2}} of a radian; on a circle of one metre no atomic nucleus is so small.

::: figure pendulum-16
alt: The missing part against η. It falls from 38 per cent at one radian to 1 per cent at 6e-30 radians.

What part of the descent the first term misses. The dots are Euler's own two examples, 5° and 1°, and the
start from which one per cent would be missing. The dashed line, {{eq 2}}, can be told from the curve only
beyond 5°.
:::

## Checks

The formula as the limit of that of {{sec pendulum.15}} and against its own integral; and at both ends of the
scale.
*/

CHECK_THAT("the first term is the logarithm of the cotangent, from 1e-307 up to the smallest swings")
{
  for(const double eta : {1e-307, 1e-150, 1e-8, 5_deg, 57_deg, 58_deg, 120_deg})
  {
    const double first = first_term(swing::Amplitude::from_eta(eta));
    CHECK(first == within_ulps(-log(tan(Fifty(eta) / 4)), 3, "a tangent and a logarithm"));
  }
  for(const double zeta : {1e-150_rad, 1e-8_rad, 1_deg})
  {
    const double first = first_term(swing::Amplitude::from_zeta(zeta));
    CHECK(first == within_ulps(atanh(sin(Fifty(zeta) / 2)), 3, "a sine and its inverse"));
  }
}

/*!
What it leaves out tends to $l\,2$, from above, and so nearly that at $10^{-300}$ nothing else can be seen.
The bounds are those of the time itself: with $s = \sin\tfrac12\eta$ it is more than $l\frac4s$ and less than
$(1+\tfrac14ss)\,l\frac4s$.
*/

CHECK_THAT("what the first term leaves out lies between ln 2 and what the bounds of the time allow")
{
  for(const double start : {1e-300, 1e-8, 1_deg, 5_deg, 30_deg, 90_deg})
  {
    const Fifty eta = start, s = sin(eta / 2), line = log(4 / s), first = -log(tan(eta / 4));
    const Fifty missing = swing::oracle::K_from_complement(s) - first, least = line - first;
    CHECK(missing
          == between(least - 1e-45, least + s * s * line / 4 + 1e-45, "and fifty digits' rounding"));
    CHECK(least == within(exact::ln2() - 2 * log(cos(eta / 4)), 1e-45, "4/s over cot ¼η is 2/cos² ¼η"));
  }
  const auto a = swing::Amplitude::from_eta(1e-300);
  const double missing = swing::quarter_time(a) - first_term(a);
  CHECK(missing == within(exact::ln2(), 2.3e-13, "two numbers near 690, an ulp each"));
}

CHECK_THAT("one per cent is missing from a start of 8 : 2¹⁰⁰, and fifteen at 5°")
{
  const double eta = start_for(0.01);
  CHECK(eta == within_relative(Fifty("6.31089e-30"), 1e-6, "as many digits as are written"));
  const double K = swing::quarter_time_from_top(eta), first = first_term(swing::Amplitude::from_eta(eta));
  CHECK((K - first) / K == within(Fifty(0.01), 1e-14, "the law is exact to ηη, and the difference rounds"));
  const auto a = swing::Amplitude::from_eta(5_deg);
  CHECK(swing::quarter_time(a) == printed("4.52022327494766"));
  CHECK(first_term(a) == printed("3.82492474119814"));
  CHECK(first_term(swing::Amplitude::from_eta(1_deg)) == printed("5.43451497993626"));
}

/*!
So the words "accurately enough" are too much; the sections that follow take them back. And the scan has lost
a half in both expressions.
*/

const Erratum enough{
    "§16, the first term",
    {"accurate enough", [] { return first_term(swing::Amplitude::from_eta(5_deg)); }},
    {"not before l 2 is added", [] { return first_term(swing::Amplitude::from_eta(5_deg)) + std::log(2); }},
    "at his own 5° it falls short by more than a seventh of the time",
    [](double reading) {
      const double K = swing::quarter_time_from_top(5_deg);
      return reading == within_relative(K, 0.01, "enough should mean one per cent");
    }};

double limit_of_the_way(double eta)  // the formula of §15, at ψ = 180°
{
  return std::log(std::tan(45_deg) / std::tan(eta / 4));
}

bool is_the_limit(double reading)
{
  return reading == within_ulps(Fifty(limit_of_the_way(5_deg)), 4, "the same logarithm");
}

const Emendation tangent{"§16, the tangent",
                         {"tg ½η", [] { return std::log(1 / std::tan(5_deg / 2)); }},
                         {"tg ¼η", [] { return std::log(1 / std::tan(5_deg / 4)); }},
                         "§15 has the quarters; at 5° it must be its value for ψ = 180°",
                         is_the_limit};

const Emendation cotangent{"§16, the cotangent",
                           {"cot ½η", [] { return -std::log(std::tan(5_deg / 2)); }},
                           {"cot ¼η", [] { return -std::log(std::tan(5_deg / 4)); }},
                           "the same; and for η = 5° §31 takes the cotangent of 1° 15'",
                           is_the_limit};
