#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "pendulum/three_members.hpp"
#include "swing/oracle.hpp"

SECTION(pendulum, 35, "Second example: three logarithms and an antilogarithm")

using namespace pendulum;

/*!
## What Euler does

In the second example, too, Euler works out the first member by logarithms, and this time he shows the
reckoning. The series of {{sec pendulum.34}} has to be multiplied by the hyperbolic logarithm of
$\cot\tfrac12\alpha = \cot 15'$. The common logarithm of that cotangent is 2,3601799, and 2,30258509 turns it
into a hyperbolic one, so that the whole first member is

$$ 1{,}00001904 \cdot 2{,}3601799 \cdot 2{,}30258509. \tag{1} $$

By logarithms,

$$ \begin{aligned} l\,1{,}00001904 &= 0{,}0000082 \\ l\,2{,}30258509 &= 0{,}3622157 \\ l\,2{,}3601799
   &= 0{,}3729452{{entry third_logarithm}} \\
   l\,\text{membr. I} &= 0{,}7351691 \\ \text{membr. I} &= 5{,}43461. \end{aligned} \tag{2} $$

Here one can watch him round.

## The program

Each number is looked up twice, once rounded as it should be and once with the further places cut off.
*/

struct LookedUp
{
  const char* number;
  std::string printed;
};

const LookedUp look_ups[] = {  // (2)
    {"1.00001904", "0,0000082"},
    {"2.30258509", "0,3622157"},
    {"2.3601799", "0,3729452"}};

/*!
What is added is what stands there, right or not.
*/

SevenPlaces sum_of_the_printed()
{
  SevenPlaces sum = SevenPlaces::as_written("0,0000000");
  for(const LookedUp& l : look_ups)
    sum = sum + SevenPlaces::as_written(l.printed);
  return sum;
}

TELL
{
  auto& rows = table("look_ups", "the three look-ups, rounded and cut off",
                     {{"number", "number"},
                      {"printed", "he has"},
                      {"rounded", "rounded"},
                      {"cut", "cut off"},
                      {"true", "true", none, 10}});
  for(const auto& [number, printed] : look_ups)
    rows.row({number, printed, SevenPlaces::of(Fifty(number)).text(),
              SevenPlaces::cut_off(Fifty(number)).text(), double(augmented_logarithm(Fifty(number)))});
}

/*!
The member itself can be had for any angle.
*/

const auto swing_ = amplitude_from_top(1_deg, closed(90_deg, 179.9_deg));

Fifty common_logarithm_of_cotangent(const Fifty& alpha)
{
  return -log(tan(alpha / 2)) / log(Fifty(10));
}

TELL
{
  const Fifty alpha = swing_.eta.fifty() / 2;
  tell("common", double(common_logarithm_of_cotangent(alpha)), "the common logarithm of cot ½α");
  tell("first", double(three_members(alpha, 200).first), "the first member");
  tell("antilogarithm", double(sum_of_the_printed().number()),
       "the number whose logarithm is the sum of his three");
}

TELL
{
  curve("off", {"line", "off"}, [](Curve& c) {
    double line = 0;
    const auto put = [&](SevenPlaces printed, const Fifty& truth) {
      c.put({++line, double((log(printed.number()) / log(Fifty(10)) - truth) * 1e7)});
      return truth;
    };
    Fifty sum = 0;
    for(const auto& [number, printed] : look_ups)
      sum += put(SevenPlaces::as_written(printed), augmented_logarithm(Fifty(number)));
    put(sum_of_the_printed(), sum);
  });
}

/*!
{{table look_ups}}

The first logarithm is cut off where it should have been rounded up. The third is neither rounded nor cut off,
but a unit too large. The one makes good the other, and the sum is right. The number that belongs to it is
{{antilogarithm|8}}; Euler cuts it off at 5,43461, where 5,43462 is nearer, and nearer to the true member too,
{{first|8}}.

::: figure pendulum-35
alt: How far each of his three logarithms and their sum lie from the true ones, in units of the
seventh place: the first two thirds of a unit below, the second close to the truth, the third almost a whole
unit above, the sum a third of a unit above.

How far his logarithms lie from the true ones. Rounding alone stays within the shaded half unit. The
first and the third leave it to opposite sides; the sum is inside again.
:::

## Checks
*/

CHECK_THAT("of his three logarithms the first is cut off, the second rounded, the third neither")
{
  const auto rounded = [](int i) { return SevenPlaces::of(Fifty(look_ups[i].number)).text(); };
  const auto cut_off = [](int i) { return SevenPlaces::cut_off(Fifty(look_ups[i].number)).text(); };
  CHECK(look_ups[0].printed == cut_off(0));
  CHECK(look_ups[0].printed != rounded(0));
  CHECK(look_ups[1].printed == rounded(1));
  CHECK(look_ups[2].printed != rounded(2));
  CHECK(look_ups[2].printed != cut_off(2));
}

CHECK_THAT("they are added rightly, the sum is the member's true logarithm, and the member is cut off")
{
  const Fifty alpha = exact::pi() / 360;
  const Fifty first = three_members(alpha, 20).first;
  CHECK(common_logarithm_of_cotangent(alpha) == printed("2,3601799"));
  CHECK(Fifty("1.00001904") * Fifty("2.3601799") * Fifty("2.30258509")  // (1)
        == within(first, 1.3e-7, "half a unit of the seventh decimal in the second factor"));
  CHECK(sum_of_the_printed().text() == "0,7351691");
  CHECK(augmented_logarithm(first) == printed("0,7351691"));
  CHECK(truncated(first, 5) == "5,43461");
  CHECK(truncated(sum_of_the_printed().number(), 5) == "5,43461");
}

const Erratum third_logarithm{"§35, l 2,3601799",
                              {"0,3729452", 0.3729452},
                              {"0,3729451", 0.3729451},
                              "neither rounding nor cutting off leads to what he has",
                              [](double reading) {
                                return augmented_logarithm(Fifty("2.3601799"))
                                       == within(reading, 0.5e-7, "half a unit of the last place");
                              }};

/*!
What is told, at 1° and elsewhere, from the cotangent's sine and cosine and the oracle's time:
*/

CHECK_THAT("the logarithm and the member told are the true ones, and the last column the true logarithms")
{
  const Fifty ten = log(Fifty(10)),
              printed_sum = Fifty("0.0000082") + Fifty("0.3622157") + Fifty("0.3729452");
  for(const Told& now : told_at("", "eta=5", "eta=90"))
  {
    const Fifty eta = swing_.eta.fifty(), cotangent = (1 + cos(eta / 2)) / sin(eta / 2);
    CHECK(now.value("common") == within_relative(log(cotangent) / ten, 2e-16, "rounded to a double"));
    const Fifty first = log(cotangent) * swing::oracle::ratio_from_bottom(eta);
    CHECK(now.value("first") == within_relative(first, 2e-16, "rounded to a double"));
    CHECK(now.value("antilogarithm")
          == within_relative(exp(printed_sum * ten), 2e-16, "rounded to a double"));
    for(const auto& row : now.rows("look_ups"))
      CHECK(row.value("true") == within_relative(log(Fifty(row.words("number"))) / ten, 2e-16, "rounded"));
  }
}

CHECK_THAT("the figure shows two thirds below, almost nothing, nearly one above, and a third")
{
  for(const Told& now : told_at(""))
  {
    const auto points = now.points("off");
    REQUIRE(points.size() == 4);
    const Fifty ten = log(Fifty(10));
    Fifty sum = 0;
    for(std::size_t i = 0; i < 3; ++i)
    {
      std::string decimal = look_ups[i].printed;
      decimal[decimal.find(',')] = '.';
      const Fifty off = (Fifty(decimal) - log(Fifty(look_ups[i].number)) / ten) * 10'000'000;
      CHECK(points[i].value("line") == within(Fifty(static_cast<int>(i) + 1), 0, "a count"));
      CHECK(points[i].value("off") == within_relative(off, 1e-12, "fifty digits, one of his less a true"));
      sum += off;
    }
    CHECK(points[3].value("off") == within_relative(sum, 1e-12, "errors add"));
  }
}
