#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "swing/oracle.hpp"

SECTION(pendulum, 32, "First example: the members with the logarithm of two")

using namespace pendulum;

/*!
## What Euler does

For the second member of the time Euler multiplies the hyperbolic logarithm of two by $\cos\alpha$, and for
the third he multiplies that product by $\tfrac34\sin^2\alpha$ {{entry factor}}. The logarithm is 0,69314718,
and $\alpha = 2°30'$; so the second member of {{eq pendulum.29 2}} comes, by common logarithms, from

$$ \begin{aligned} l\,0{,}6931472 &= 9{,}8408253{{entry ln_two}} \\ l\cos\alpha &= 9{,}9995865 \\
   \text{sum} = l\,\text{membr. II} &= 9{,}8404118, \end{aligned} \tag{1} $$

and is 0,69249. From it he has the third,

$$ \begin{aligned} l\,\text{membr. II} &= 9{,}8404118 \\ l\,\tfrac34{{entry its_logarithm}}
   &= 9{,}8750613 \\ l\sin^2\alpha &= 7{,}2793592 \\
   l\,\text{membr. III} &= 6{,}9948323, \end{aligned} \tag{2} $$

which is 0,00099. Since this is not even one thousandth, the members that follow can safely be left out.

## The program

Each line is done again in whole ten-millionths, as in {{sec pendulum.30}}, from the logarithm of two that
Euler starts with.

::: code pendulum/reckoning.hpp last_members
:::
*/

std::vector<Line> reckoning(const Fifty& alpha)  // (1), (2)
{
  return last_members(alpha, {"9,8408253", "9,9995865", "9,8404118", "0,69249", "9,8750613", "7,2793592",
                              "6,9948323", "0,00099"});
}

/*!
Whether the rest may be left out can be said exactly: it is what $K(\cos\alpha)$ has beyond the three members.
*/

Fifty left_out(const Fifty& alpha)
{
  return ratio_by_mean(2 * alpha) * exact::pi() / 2 - three_members(alpha, 200).sum();
}

const auto swing_ = amplitude_from_top(5_deg, closed(90_deg, 179.9_deg));

TELL
{
  const Fifty alpha = swing_.eta.fifty() / 2;
  tell_lines("lines", "the reckoning, line by line", reckoning(alpha), swing_.eta == 5_deg);
  tell("left_out", double(left_out(alpha)), "all the members after the third");
}

TELL
{
  curve("sizes", {"eta", "first", "second", "third", "rest"}, [](Curve& c) {
    for(double eta = 0.5; eta < 60.01; eta *= 1.05)
    {
      const Fifty alpha = Fifty(eta) * exact::pi() / 360;
      const auto m = three_members(alpha, 200);
      c.put({eta, double(m.first), double(m.second), double(m.third), double(left_out(alpha))});
    }
  });
}

/*!
{{table lines}}

The first line is too small by two units of its last place. The slip is no misreading, for he
adds with it: from 9.8408255 the sum would be 9.8404120. The same number serves him again in {{sec
pendulum.36}}. In neither example does it touch the fifth decimal, and nor does all that he leaves out here,
{{left_out|e2}}.

::: figure pendulum-32
alt: The sizes of the three members and of what is left out, against eta from half a degree to 60 degrees,
both scales logarithmic. The first two are of order one; the third rises as the square of eta, the rest as its
fourth power.

How large the members are. The third grows as the square of η, what is left out as the fourth power: at 5° it
reaches the sixth decimal.
:::

## Checks
*/

CHECK_THAT("from Euler's logarithm of two the table gives every other line as our copy has it")
{
  const std::vector<Line> lines = reckoning(exact::pi() / 72);
  for(std::size_t i = 1; i < lines.size(); ++i)
    CHECK(lines[i].reckoned == lines[i].printed);
}

CHECK_THAT("both members are right as they stand, and to five decimals the three are enough")
{
  const Fifty alpha = exact::pi() / 72;
  const auto m = three_members(alpha, 40);
  CHECK(exact::ln2() == printed("0,69314718"));
  CHECK(m.second == printed("0,69249"));
  CHECK(m.third == printed("0,00099"));
  CHECK(m.third < Fifty("0.001"));
  CHECK(left_out(alpha) == between(0, 0.5e-5, "half a unit of the fifth decimal"));
}

const Erratum ln_two{"§§32 and 36, l 0,6931472",
                     {"9,8408253", 9.8408253},
                     {"9,8408255", 9.8408255},
                     "both times the lines below are added up with the 3",
                     [](double reading) {
                       return augmented_logarithm(Fifty("0.6931472"))
                              == within(reading, 0.5e-7, "half a unit of the last place");
                     }};

/*!
Our copy garbles the factor of the third member twice. The logarithm beside it settles both.
*/

bool has_his_logarithm(double factor)
{
  return std::log10(factor) + 10 == within(9.8750613, 0.5e-7, "half a unit of the last place");
}

const Emendation factor{"§32, the factor of the third member",
                        {"2/7 sin²α", 2.0 / 7},
                        {"¾ sin²α", 0.75},
                        "its logarithm, 9,8750613, stands below",
                        has_his_logarithm};

const Emendation its_logarithm{"§32, the line of that factor",
                               {"l ½", 0.5},
                               {"l ¾", 0.75},
                               "9,8750613 stands beside it; l ½ is 9,6989700",
                               has_his_logarithm};

/*!
The true column and the figure come from the three members in fifty digits; here they are formed
once more, term by term, and the rest from the series for $K$ that has all members.
*/

CHECK_THAT(
    "what is told is the true logarithm or member, and what is left out is of the fourth power of sin α")
{
  for(const Told& now : told_at("", "eta=1", "eta=60"))
  {
    const Fifty alpha = swing_.eta.fifty() / 2, ten = log(Fifty(10)), ln_two("0.6931472");
    const auto common = [&](const Fifty& x) { return log(x) / ten + 10; };
    const Fifty second = sin(exact::pi() / 2 - alpha) * exact::ln2();
    const Fifty third = second * (1 - pow(cos(alpha), 2)) * 3 / 4;
    const std::array<Fifty, 8> truth{common(ln_two),       common(cos(alpha)),
                                     common(second),       second,
                                     common(Fifty(3) / 4), 2 * (common(sin(alpha)) - 10) + 10,
                                     common(third),        third};
    const auto rows = now.rows("lines");
    REQUIRE(rows.size() == truth.size());
    for(std::size_t i = 0; i < truth.size(); ++i)
      CHECK(rows[i].value("true") == within_relative(truth[i], 2e-16, "rounded to a double"));
    const Fifty u = cos(alpha), K = swing::oracle::K_from_complement(sin(alpha));
    const Fifty factor = swing::oracle::ratio_from_bottom(2 * alpha);
    const Fifty rest = K - factor * log((1 + u) / sin(alpha)) - second - third;
    CHECK(now.value("left_out") == within(rest, 1e-16, "rounded to a double, and two hundred terms"));
  }
}

CHECK_THAT("the figure has the three members and the rest")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("sizes", 7))
    {
      const Fifty alpha = Fifty(point.at("eta")) * exact::pi() / 360, s = sin(alpha), u = cos(alpha);
      const Fifty first = swing::oracle::ratio_from_bottom(2 * alpha) * log((1 + u) / s);
      const Fifty second = u * exact::ln2(), third = second * s * s * 3 / 4;
      CHECK(point.value("first") == within_relative(first, 2e-16, "rounded to a double"));
      CHECK(point.value("second") == within_relative(second, 2e-16, "rounded to a double"));
      CHECK(point.value("third") == within_relative(third, 2e-16, "rounded to a double"));
      const Fifty K = swing::oracle::K_from_complement(s);
      CHECK(point.value("rest")
            == within_relative(K - first - second - third, 1e-15, "fifty digits of three members"));
    }
}
