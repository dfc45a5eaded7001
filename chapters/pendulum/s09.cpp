#include "edition/section.hpp"
#include "pendulum/series.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 9, "The time of a swing, and the length of the seconds pendulum")

using pendulum::ratio_by_mean, pendulum::series;
using swing::Amplitude;

/*!
## What Euler does

The time of a whole swing is twice that of half a swing, and for infinitely small swings it gives the length
of the seconds pendulum. By {{sec pendulum.08}} the time $T = 2t$ of one swing, from side to side, is

$$ \begin{aligned} T = \frac{\pi\sqrt b}{\sqrt{2g}}\Bigl(1
   &+ \frac{1^2}{2^2}{{entry first_coefficient}}cc + \frac{1^2\cdot3^2}{2^2\cdot4^2}c^4 \\
   &+ \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}c^6 \\
   &+ \frac{1^2\cdot3^2\cdot5^2\cdot7^2}{2^2\cdot4^2\cdot6^2\cdot8^2}c^8 + \text{etc.}\Bigr).
   \end{aligned} \tag{1} $$

::: margin
His $g$ is a height, half of today's acceleration: $2g$ is what we call $g$. His $T$ is half of today's
period.
:::

It comes out in seconds, if $g$ is the height through which heavy bodies fall freely in one second. When the
swings are infinitely small, $\zeta = 0$ and $c = 0$, the time is

$$ T = \frac{\pi\sqrt b}{\sqrt{2g}}, \tag{2} $$

where $b$ is the length of the isochronous simple pendulum, or the distance of the centre of oscillation from
the axis $A$. For a pendulum that swings once a second this must be 1, and its length is

$$ b = \frac{2g}{\pi^2}. \tag{3} $$

In Rhenish feet $g = 15\tfrac58$ and $2g = 31\tfrac14$ {{entry fall}}, and he finds $b = 3{,}16621$
{{entry length}}. With a longer or a
shorter pendulum the times are, as is commonly known, as the square roots of the lengths $b$; but it must be
kept in mind, he adds, that infinitely small swings are meant.

## The program

Lengths are in feet, as his; any other unit will do if $g$ is in it too (`--g 4.903325 --b 1` is a metre).
*/

double small_swing(double b, double g)  // (2)
{
  return std::numbers::pi * (std::sqrt(b) / std::sqrt(2 * g));
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
A pendulum that swings wide is slower, and must be shorter to beat seconds: {{eq 1}} put equal to 1 gives
{{eq 3}} divided by the square of the bracket.
*/

double wide_length(double g, Amplitude amplitude)
{
  return seconds_length(g) / std::pow(swing::ratio(amplitude), 2);
}

double fall_for(double length)  // the g by (3)
{
  return length / seconds_length(1);
}

double gained_in_a_day(double length, double fall)
{
  return 86400 * (1 / small_swing(length, fall) - 1);
}

const auto g = real("g", 15.625, feet, scale, "height fallen in the first second");
const auto b = real("b", 3.16621, feet, scale, "length of the equivalent simple pendulum");
const auto swing_ = amplitude(0_deg, from_below(0_deg, 180_deg));
const auto terms = integer("N", 5, 1, 1'000'000, "terms of (1) that are kept; Euler writes five");

TELL
{
  const Amplitude wide{swing_.zeta, swing_.eta};
  tell("T", small_swing(b, g) * swing::ratio(wide), seconds, "time of one swing");
  tell("kept", whole_swing(b, g, std::sin(swing_.zeta / 2), terms), seconds, "the same by N terms of (1)");
  tell("small", small_swing(b, g), seconds, "time of one infinitely small swing");
  tell("seconds_length", seconds_length(g), feet, "length that beats seconds in infinitely small swings");
  tell("wide_length", wide_length(g, wide), feet, "the same in swings of this amplitude");
  tell("needed", fall_for(3.16621), feet, "the g for which 3,16621 would be right");
  tell("gained", gained_in_a_day(3.16621, 15.625), seconds, "what a clock with 3,16621 ft gains in a day",
       6);
}

/*!
The length in our copy is not quite what {{eq 3}} gives. The table tries the two readings of $g$, two usual
values of π, and a reckoning by logarithms of five places, first as it should be and then with its last place
one too small.
*/

TELL
{
  auto& rows =
      table("candidates", "Ways to the length of the seconds pendulum; our copy has 3,16621",
            {{"way", "way"}, {"b", "b", feet, 6}, {"off", "off 3,16621", Unit{"10⁻⁵ ft", 1e5}, 3}});
  const auto row = [&](const char* way, double length) { rows.row({way, length, length - 3.16621}); };
  row("2g = 31", seconds_length(15.5));
  row("2g = 31¼", seconds_length(15.625));
  row("2g = 31¼, π = 22/7", seconds_length(15.625, 22. / 7));
  row("2g = 31¼, π = 3.1416", seconds_length(15.625, 3.1416));
  row("log 31.25 − 2 log π = 0.50055", std::pow(10, 0.50055));
  row("the same as 0.50054", std::pow(10, 0.50054));
}

TELL
{
  curve("lengths", {"b", "T0", "T90", "T150", "T175"}, [](Curve& c) {
    for(double length = 0.25; length <= 16; length *= 2)
    {
      std::vector<double> row = {length};
      for(const double zeta : {0_deg, 90_deg, 150_deg, 175_deg})
        row.push_back(small_swing(length, g) * swing::ratio(Amplitude::from_zeta(zeta)));
      c.put(row);
    }
  });
  curve("beat", {"b"}, [](Curve& c) {
    for(const double zeta : {0_deg, 90_deg, 150_deg, 175_deg})
      c.put({wide_length(g, Amplitude::from_zeta(zeta))});
  });
}

/*!
{{table candidates}}

The reading of $g$ is certain: 31 feet make a length that is wrong in its second decimal. The last digit of
3,16621 is another matter. {{eq 3}} gives {{seconds_length|6}} feet; neither 22/7 nor 3.1416 for π leads to
3.16621, and $g$ would have to be {{needed|7}}. A slip of one in the fifth place of a logarithm leads there
to the last digit; but a 9 read or set as a 1 would do as well. A clock with this pendulum would gain
{{gained|2}} seconds a day.

::: figure pendulum-09
alt: Time of a swing against length, both logarithmic: parallel lines for 0, 90, 150 and 175 degrees.

The time of a swing grows as the square root of the length, at every amplitude: the lines are parallel. The
points are pendulums that beat seconds; the wider the swing, the shorter the pendulum.
:::

## Checks

The series {{eq 1}} in seconds, against the mean of {{sec pendulum.11}}.
*/

CHECK_THAT("the series gives the time of a swing in seconds")
{
  for(const double zeta : {0_deg, 20_deg, 60_deg, 90_deg})
  {
    const Fifty exact = exact::pi() * sqrt(Fifty(3.16621) / 31.25) * ratio_by_mean(exact::pi() - zeta);
    CHECK(whole_swing(3.16621, 15.625, std::sin(zeta / 2), 60)
          == within_ulps(exact, 8, "60 terms, most of them too small to be rounded; four factors"));
  }
}

CHECK_THAT(
    "times are as the square roots of the lengths, and the lengths told beat seconds at any amplitude")
{
  for(const double zeta : {0_deg, 1_deg, 90_deg, 175_deg})
  {
    const double c = std::sin(zeta / 2), once = whole_swing(1, 15.625, c, 100);
    CHECK(whole_swing(4, 15.625, c, 100) == 2 * once);  // a power of two costs no rounding
    const auto wide = Amplitude::from_zeta(zeta);
    CHECK(small_swing(wide_length(15.625, wide), 15.625) * swing::ratio(wide)
          == within_ulps(Fifty(1), 4, "two roots, four factors, and the bracket twice"));
  }
}

/*!
In our copy $g$ has lost an eighth and $2g$ a quarter. The two agree with each
other, 31 being twice 15½, but not with the length beside them.
*/

const Emendation fall{
    "§9, g and 2g",
    {"g = 15½, 2g = 31", seconds_length(15.5)},
    {"g = 15⅝, 2g = 31¼", seconds_length(15.625)},
    "only then is the seconds pendulum about 3.166 ft",
    [](double b_) { return b_ == within(3.16621, 1e-4, "the length is wrong in its last place"); }};

const Doubtful length{
    "§9, the length of the seconds pendulum",
    {"3,16621", 3.16621},
    {"3,16629", 3.16629},
    "31.25/ππ = 3.166287; a 9 misread, or a slip in the last place of a five-place logarithm",
    [](double b_) {
      return Fifty(31.25) / pow(exact::pi(), 2) == within(b_, 0.5e-5, "half of the last place");
    }};

CHECK_THAT("one in the fifth place of the logarithm is all that separates 3,16629 from 3,16621")
{
  CHECK(std::log10(31.25) - 2 * std::log10(std::numbers::pi) == printed("0,50055"));
  CHECK(std::pow(10, 0.50054) == printed("3,16621"));
}

const Emendation first_coefficient{
    "§9, the coefficient of cc",
    {"½", 1.0 / 2},
    {"1²/2²", 1.0 / 4},
    "it is what T/Θ − 1 is to cc in a very small swing, and §10 has ¼",
    [](double reading) {
      const Fifty c = Fifty(1e-6);
      return reading == within((ratio_by_mean(2 * acos(c)) - 1) / (c * c), 1e-12, "the next term, 9/64 cc");
    }};

/*!
What is told, at Euler's feet, in metres for a wide swing, and for a hair from the top:
*/

CHECK_THAT("times and lengths told are those of the formula and of the oracle's time")
{
  for(const Told& now :
      told_at("", "g=4.903325 b=1 zeta=150 N=40", "eta=1e-9 g=1e-90 b=1e90 N=2", "zeta=1e-6 N=1"))
  {
    const Fifty T = swing::oracle::ratio_from_top(swing_.eta.fifty()),
                cc = pow(sin(swing_.zeta.fifty() / 2), 2);
    const Fifty small = exact::pi() * sqrt(b.fifty() / (2 * g.fifty())),
                length = 2 * g.fifty() / pow(exact::pi(), 2);
    Fifty bracket = 0;
    for(int i = 0; i < terms; ++i)
      bracket += static_cast<Fifty>(pow(exact::double_factorial_ratio(i), 2)) * pow(cc, i);
    CHECK(now.value("small", seconds) == within_relative(small, 6e-16, "two roots, two factors"));
    CHECK(now.value("T", seconds) == within_relative(small * T, 8e-16, "and the library's ulp"));
    CHECK(now.value("kept", seconds) == within_relative(small * bracket, 3e-15, "and the terms"));
    CHECK(now.value("seconds_length", feet)
          == within_relative(length, 5e-16, "two factors and a quotient"));
    CHECK(now.value("wide_length", feet)
          == within_relative(length / (T * T), 2e-15, "the ratio counts twice"));
    CHECK(now.value("needed", feet)
          == within_relative(Fifty("3.16621") * pow(exact::pi(), 2) / 2, 6e-16, "as above"));
    const Fifty beat = exact::pi() * sqrt(Fifty("3.16621") / Fifty("31.25"));
    CHECK(now.value("gained", seconds) == within(86400 / beat - 86400, 4e-11, "a day's seconds, rounded"));
  }
}

CHECK_THAT("the table's lengths are those of their ways, and stand so far off")
{
  for(const Told& now : told_at(""))
  {
    const auto rows = now.rows("candidates");
    const Fifty ten(10), pp = pow(exact::pi(), 2);
    const std::array<Fifty, 6> lengths{31 / pp,
                                       Fifty("31.25") / pp,
                                       Fifty("31.25") * 49 / 484,
                                       Fifty("31.25") / pow(Fifty("3.1416"), 2),
                                       pow(ten, Fifty("0.50055")),
                                       pow(ten, Fifty("0.50054"))};
    for(std::size_t i = 0; i < lengths.size(); ++i)
    {
      CHECK(rows.at(i).value("b", feet) == within_relative(lengths[i], 6e-16, "few roundings"));
      CHECK(rows.at(i).value("off", Unit{"10⁻⁵ ft", 1e5})
            == within(lengths[i] - Fifty("3.16621"), 2e-15, "a difference"));
    }
  }
}

CHECK_THAT("the figure's lines are the times at four amplitudes, its points the lengths that beat seconds")
{
  for(const Told& now : told_at(""))
  {
    const std::array<int, 4> degrees_{0, 90, 150, 175};
    const auto ratio = [](int degree) {
      return swing::oracle::ratio_from_bottom(degree * exact::pi() / 180);
    };
    for(const auto& point : now.points("lengths"))
    {
      const Fifty small = exact::pi() * sqrt(Fifty(point.at("b")) / (2 * g.fifty()));
      for(const auto& [column, degree] :
          {std::pair{"T0", 0}, std::pair{"T90", 90}, std::pair{"T150", 150}, std::pair{"T175", 175}})
        CHECK(point.value(column)
              == within_relative(small * ratio(degree), 3e-15, "ζ rounds, near the top more"));
    }
    const auto beat = now.points("beat");
    for(std::size_t i = 0; i < 4; ++i)
      CHECK(beat.at(i).value("b")
            == within_relative(2 * g.fifty() / pow(exact::pi() * ratio(degrees_[i]), 2), 6e-15,
                               "the ratio twice"));
  }
}

/*!
## Go on from here

::: exercise
How long, in Rhenish feet, is a pendulum that beats seconds while it swings through a whole semicircle?

answer: 2.2727 feet, which `--zeta 90` tells: the length in very small swings divided by the square of
1.18034.
:::
*/

CHECK_THAT("swinging through the semicircle, 2.2727 feet beat seconds")
{
  for(const Told& now : told_at("zeta=90"))
  {
    CHECK(now.value("wide_length", feet) == within(2.2727, 0.5e-4, "to four decimals"));
    CHECK(now.value("seconds_length", feet)
          == within_relative(2.27266584694 * 1.18034059902 * 1.18034059902, 1e-11, "twelve digits each"));
  }
}
