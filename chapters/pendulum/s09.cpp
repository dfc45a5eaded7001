#include "edition/section.hpp"
#include "pendulum/series.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 9, "The time of a swing, and the length of the seconds pendulum")

using pendulum::ratio_by_mean, pendulum::series;

/*!
## What Euler does

Twice the time of half a swing is that of a whole one, and the smallest of all swings gives the length of
the seconds pendulum. In {{sec pendulum.08}} the time $t$ was that of half a swing, from the lowest point to
the turning point. Twice as much is the time $T$ of a whole one, from side to side:

$$ \begin{aligned} T = \frac{\pi\sqrt b}{\sqrt{2g}}\Bigl(1 + \frac{1^2}{2^2}cc
   &+ \frac{1^2\cdot3^2}{2^2\cdot4^2}c^4 + \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}c^6 \\
   &+ \frac{1^2\cdot3^2\cdot5^2\cdot7^2}{2^2\cdot4^2\cdot6^2\cdot8^2}c^8 + \text{etc.}\Bigr).
   \end{aligned} \tag{1} $$

::: margin
His $g$ is a height, half of today's acceleration: $2g$ is what we call $g$. His $T$ is half of today's
period.
:::

It comes out in seconds, provided that $g$ is the height through which heavy bodies fall in the first
second. If the swings are infinitely small, $\zeta = 0$ and $c = 0$, nothing is left of the bracket, and

$$ T = \frac{\pi\sqrt b}{\sqrt{2g}}, \tag{2} $$

where $b$ is the length of the simple pendulum that swings as fast, that is the distance from the axis $A$
to the centre of oscillation.

What must this length be for a pendulum that beats seconds? $T$ has to be 1, and so

$$ b = \frac{2g}{\pi^2}. \tag{3} $$

In Rhenish feet a body falls $g = 15\tfrac58$ in the first second, $2g = 31\tfrac14$, and he finds
$b = 3{,}16621$ feet. For a longer or a shorter pendulum the times are, as everybody knows, as the square
roots of the lengths; but one has to mind, he adds, that infinitely small swings are meant.

## The program

The time of a swing, by as many terms as wanted; and the length that beats seconds.
*/

double small_swing(double b, double g)  // (2)
{
  return std::numbers::pi * std::sqrt(b) / std::sqrt(2 * g);
}

double whole_swing(double b, double g, double c, int terms)  // (1)
{
  return small_swing(b, g) * series(c * c, terms);
}

double seconds_length(double g, double pi = std::numbers::pi)  // (3)
{
  return 2 * g / (pi * pi);
}

/*!
The lengths are in feet, as his; but any other unit will do if $g$ is in it too (`--g 4.903325 --b 1` is a
metre). A pendulum that swings wide is slower, and to beat seconds it has to be shorter: {{eq 1}} put equal
to 1 gives {{eq 3}} divided by the square of the bracket.
*/

double seconds_length_wide(double g, swing::Amplitude amplitude)
{
  const double bracket = swing::ratio(amplitude);
  return seconds_length(g) / (bracket * bracket);
}

const auto g = real("g", 15.625, feet, positive, "height fallen in the first second");
const auto b = real("b", 3.16621, feet, positive, "length of the equivalent simple pendulum");
const auto swing_ = amplitude(0_deg, from_below(0_deg, 180_deg));
const auto terms = integer("N", 5, 1, 1'000'000, "terms of (1) that are kept; Euler writes five");

TELL
{
  const swing::Amplitude amplitude{swing_.zeta, swing_.eta};
  tell("T", small_swing(b, g) * swing::ratio(amplitude), seconds, "time of one swing");
  tell("kept", whole_swing(b, g, std::sin(swing_.zeta / 2), terms), seconds, "the same by N terms of (1)");
  tell("small", small_swing(b, g), seconds, "time of one infinitely small swing");
  tell("seconds_length", seconds_length(g), feet, "length that beats seconds in infinitely small swings");
  tell("wide_length", seconds_length_wide(g, amplitude), feet, "the same in swings of this amplitude");
  tell("with_31", seconds_length(15.5), feet, "length that beats seconds if 2g is 31");
  tell("needed", 3.16621 / seconds_length(1), feet, "the g for which 3,16621 would be right");
  const double printed_swing = small_swing(3.16621, 15.625);
  tell("gained", 86400 * (1 / printed_swing - 1), seconds, "what a clock of 3,16621 ft gains in a day");
}

/*!
What can have gone wrong with the length? The candidates: the two readings of $g$, the usual stand-ins for
$\pi$, and a reckoning by logarithms of five places, as it should come out and with the last place of the
difference one too small.
*/

TELL
{
  const auto by_logarithms = [](double places) { return std::pow(10, places); };
  auto& rows =
      table("candidates", "Ways to the length of the seconds pendulum; printed is 3,16621",
            {{"way", "way"}, {"b", "b", feet, 6}, {"off", "off the printed", Unit{"10⁻⁵ ft", 1e5L}, 3}});
  const auto row = [&](const char* way, double length) { rows.row({way, length, length - 3.16621}); };
  row("2g = 31", seconds_length(15.5));
  row("2g = 31¼", seconds_length(15.625));
  row("2g = 31¼, π = 22/7", seconds_length(15.625, 22. / 7));
  row("2g = 31¼, π = 3,1416", seconds_length(15.625, 3.1416));
  row("2g = 31¼, π = 3,14", seconds_length(15.625, 3.14));
  row("l. 31,25 − 2 l. π = 0,50055", by_logarithms(0.50055));
  row("the same as 0,50054", by_logarithms(0.50054));
  curve("lengths", {"b", "T0", "T90", "T150", "T175"}, [](Curve& c) {
    for(double length = 0.25; length <= 16; length *= 2)
    {
      std::vector<double> row_ = {length};
      for(const double zeta : {0_deg, 90_deg, 150_deg, 175_deg})
        row_.push_back(small_swing(length, g) * swing::ratio(swing::Amplitude::from_zeta(zeta)));
      c.put(row_);
    }
  });
  curve("beat", {"b"}, [](Curve& c) {
    for(const double zeta : {0_deg, 90_deg, 150_deg, 175_deg})
      c.put({seconds_length_wide(g, swing::Amplitude::from_zeta(zeta))});
  });
}

/*!
The reading of $g$ is certain: with 31 feet the length would be {{with_31|5}}. The last digits are another
matter. What {{eq 3}} gives is {{seconds_length|6}} feet. No stand-in for $\pi$ leads to 3,16621, and for
the length to be right $g$ would have to be {{needed|7}}. One way leads there, to the last digit: a
difference of logarithms that is wrong by one in its fifth place. But a 9 taken for a 1 would do as well. A
clock with this pendulum would gain {{gained|2}} seconds a day.

::: figure pendulum-09
alt: Time of a swing against length, both logarithmic: parallel lines for 0, 90, 150 and 175 degrees.

The times are as the square roots of the lengths, and not only for small swings: the lines for all
amplitudes are parallel. The points are seconds pendulums: the wider the swing, the shorter the pendulum has
to be.
:::

## Checks

The series {{eq 1}}, in seconds, against the motion: an independent route to the time is the mean.
*/

CHECK_THAT("the series gives the time of a swing in seconds")
{
  for(const double zeta : {0_deg, 20_deg, 60_deg, 90_deg})
  {
    const Fifty exact = exact::pi() * sqrt(Fifty(3.16621) / 31.25) * ratio_by_mean(exact::pi() - zeta);
    CHECK(whole_swing(3.16621, 15.625, std::sin(zeta / 2), 60)
          == within_ulps(exact, 24, "60 terms lose less than 16, cc from ζ less than 4, the factor 4"));
  }
}

CHECK_THAT("times are as the square roots of the lengths, at every amplitude")
{
  for(const double length : {1.0, 2.0, 4.0})
  {
    const Fifty exact = exact::pi() * sqrt(Fifty(length) / 31.25);
    CHECK(small_swing(length, 15.625) == within_ulps(exact, 3, "two roots, two factors and a rounded π"));
  }
  for(const double c : {0.0, 0.5, 0.9})
  {
    const double once = whole_swing(1, 15.625, c, 100);
    CHECK(whole_swing(4, 15.625, c, 100) == 2 * once);  // a power of two costs no rounding
  }
}

CHECK_THAT("a pendulum of the length told beats seconds, at every amplitude")
{
  CHECK(small_swing(seconds_length(15.625), 15.625) == within_ulps(Fifty(1), 4, "a root and four factors"));
  for(const double zeta : {1_deg, 90_deg, 175_deg})
  {
    const auto wide = swing::Amplitude::from_zeta(zeta);
    const double length = seconds_length_wide(15.625, wide);
    const double T = small_swing(length, 15.625) * swing::ratio(wide);
    CHECK(T == within_ulps(Fifty(1), 8, "the bracket's error enters twice"));
  }
}

/*!
The two numbers for $g$ have lost the last stroke of an eighth and a quarter. The proof is the length
printed two lines below: it must come out within a hundredth of a foot.
*/

bool near_the_printed_length(double length)
{
  return length == within(3.16621, 0.01, "31 instead of 31¼ makes 0,025 ft");
}

const Emendation fall{"§9, g",
                      {"15½", [] { return seconds_length(15.5); }},
                      {"15⅝", [] { return seconds_length(15.625); }},
                      "only then is the seconds pendulum about 3,166 ft",
                      near_the_printed_length};

const Emendation double_fall{"§9, 2g",
                             {"31", [] { return 31 / std::pow(std::numbers::pi, 2); }},
                             {"31¼", [] { return 31.25 / std::pow(std::numbers::pi, 2); }},
                             "the same, and it is twice 15⅝",
                             near_the_printed_length};

const Doubtful length{
    "§9, the length of the seconds pendulum",
    {"3,16621", 3.16621},
    {"3,16629", 3.16629},
    "31,25/ππ = 3,166287; a 9 misread, or a slip in the last place of a five-place logarithm",
    [](double reading) {
      return Fifty(31.25) / pow(exact::pi(), 2) == within(reading, 0.5e-5, "half of the last place");
    }};

CHECK_THAT(
    "one unit in the fifth place of the logarithm is all that separates 3,16629 from what is printed")
{
  CHECK(std::log10(31.25) - 2 * std::log10(std::numbers::pi) == printed("0,50055"));
  CHECK(std::pow(10, 0.50054) == printed("3,16621"));
}

const Emendation first_coefficient{
    "§9, the coefficient of cc",
    {"½", 1.0 / 2},
    {"1²/2²", 1.0 / 4},
    "the law of the others; §10 has ¼",
    [](double reading) {
      const Fifty c = Fifty(1e-6);
      return reading == within((ratio_by_mean(2 * acos(c)) - 1) / (c * c), 1e-12, "the next term, 9/64 cc");
    }};
