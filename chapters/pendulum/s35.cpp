#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "pendulum/series.hpp"

SECTION(pendulum, 35, "Second example: three logarithms and an antilogarithm")

using namespace pendulum;

/*!
## What Euler does

The first member again, and this time he shows the reckoning. As in {{sec pendulum.31}}, the series is
multiplied by the hyperbolic logarithm of $\cot\tfrac12\alpha = \cot 15'$, whose common logarithm is
2,3601799. The first member is

$$ 1{,}00001904 \cdot 2{,}3601799 \cdot 2{,}30258509, \tag{1} $$

and this time he shows the reckoning:

$$ \begin{aligned} l\,1{,}00001904 &= 0{,}0000082 \\ l\,2{,}30258509 &= 0{,}3622157 \\ l\,2{,}3601799 &= 0{,}3729452 \\
   l\,\text{membr. I} &= 0{,}7351691, \qquad \text{membr. I} = 5{,}43461. \end{aligned} \tag{2} $$

It is the one place where one can watch him round, and he does it by feeling.

## The program

Each line is looked up twice, once rounded as it should be and once with the further places cut off.
*/

struct LookedUp
{
  const char* what;
  const char* printed;
  Fifty number;
};

std::vector<LookedUp> look_ups()  // (2)
{
  return {{"l 1,00001904", "0,0000082", Fifty("1.00001904")},
          {"l 2,30258509", "0,3622157", Fifty("2.30258509")},
          {"l 2,3601799", "0,3729452", Fifty("2.3601799")}};
}

/*!
And the addition is done with what is printed, whether it is right or not.
*/

SevenPlaces sum_of_the_printed()
{
  SevenPlaces sum = SevenPlaces::as_written("0,0000000");
  for(const LookedUp& l : look_ups())
    sum = sum + SevenPlaces::as_written(l.printed);
  return sum;
}

const auto swing_ = amplitude_from_top(1_deg, closed(90_deg, 179.9_deg));

TELL
{
  auto& rows = table("look_ups", "the three look-ups, rounded and cut off",
                     {{"what", "what"},
                      {"printed", "printed"},
                      {"rounded", "rounded"},
                      {"cut", "cut off"},
                      {"true", "true", none, 10}});
  for(const LookedUp& l : look_ups())
    rows.row({l.what, l.printed, SevenPlaces::of(l.number).text(), SevenPlaces::cut_off(l.number).text(),
              double(augmented_logarithm(l.number))});
  const Fifty alpha = swing_.eta.fifty() / 2;
  const Fifty first = -log(tan(alpha / 2)) * ratio_by_mean(exact::pi() - 2 * alpha);
  tell_lines("lines", "what comes of them",
             {{"log cot ½α", "2,3601799", rounded(-log(tan(alpha / 2)) / log(Fifty(10)), 7),
               -log(tan(alpha / 2)) / log(Fifty(10))},
              {"l member I", "0,7351691", sum_of_the_printed().text(), augmented_logarithm(first)},
              {"member I", "5,43461", rounded(sum_of_the_printed().number(), 5), first}},
             swing_.eta == 1_deg);
  tell("hyperbolic", -log(tan(alpha / 2)), "l cot ½α, the hyperbolic logarithm");
  tell("first", double(first), "the first member, exactly");
  tell("antilogarithm", double(sum_of_the_printed().number()),
       "the number whose logarithm is the printed sum");
  curve("off", {"line", "off"}, [](Curve& c) {
    double line = 0;
    for(const LookedUp& l : look_ups())
      c.put({++line, 1e7
                         * (double(Fifty(std::string(l.printed).replace(1, 1, ".")))
                            - double(augmented_logarithm(l.number)))});
  });
}

/*!
The first logarithm is cut off where it should have been rounded up; the third is rounded up where it should
have stayed. The two slips cancel, and the sum is right. Its antilogarithm is {{antilogarithm|8}}, which is
cut off once more: rounded it would be 5,43462.

::: figure pendulum-35
alt: How far each of the three printed logarithms lies from the true one, in units of the seventh place: the
first two thirds of a unit below, outside the half unit of honest rounding, the second inside it, the third
almost a whole unit above.

How far the three printed logarithms are from the true ones. An honest rounding stays within the shaded half
unit; the first and the third leave it, to opposite sides, and together they are off by little.
:::

## Checks
*/

CHECK_THAT("of the three printed logarithms the first is cut off, the second rounded, the third neither")
{
  const auto l = look_ups();
  CHECK(SevenPlaces::cut_off(l[0].number).text() == l[0].printed);
  CHECK(SevenPlaces::of(l[0].number).text() != l[0].printed);
  CHECK(SevenPlaces::of(l[1].number).text() == l[1].printed);
  CHECK(SevenPlaces::of(l[2].number).text() != l[2].printed);
  CHECK(SevenPlaces::cut_off(l[2].number).text() != l[2].printed);
}

CHECK_THAT("their sum is added rightly, and is the right logarithm all the same")
{
  const Fifty alpha = exact::pi() / 360;
  const Fifty first = -log(tan(alpha / 2)) * ratio_by_mean(exact::pi() - 2 * alpha);
  CHECK(sum_of_the_printed().text() == "0,7351691");
  CHECK(augmented_logarithm(first) == printed("0,7351691"));
  CHECK(-log(tan(alpha / 2)) / log(Fifty(10)) == printed("2,3601799"));
  CHECK(truncated(first, 5) == "5,43461");
}

const Erratum first_logarithm{"§35, l 1,00001904",
                              {"0,0000082", 0.0000082},
                              {"0,0000083", 0.0000083},
                              "cut off, not rounded",
                              [](double reading) {
                                return augmented_logarithm(Fifty("1.00001904"))
                                       == within(reading, 0.5e-7, "half a unit of the last place");
                              }};

const Erratum third_logarithm{"§35, l 2,3601799",
                              {"0,3729452", 0.3729452},
                              {"0,3729451", 0.3729451},
                              "the table's entry; it makes good the slip before",
                              [](double reading) {
                                return augmented_logarithm(Fifty("2.3601799"))
                                       == within(reading, 0.5e-7, "half a unit of the last place");
                              }};

const Erratum member{"§35, member I",
                     {"5,43461", 5.43461},
                     {"5,43462", 5.43462},
                     "cut off, not rounded",
                     [](double reading) {
                       const Fifty alpha = exact::pi() / 360;
                       return -log(tan(alpha / 2)) * ratio_by_mean(exact::pi() - 2 * alpha)
                              == within(reading, 0.5e-5, "half a unit of the last place");
                     }};
