#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "pendulum/series.hpp"
#include "swing/oracle.hpp"

SECTION(pendulum, 31, "First example: the member with the logarithm")

using namespace pendulum;

/*!
## What Euler does

The first member is the series of {{sec pendulum.30}} times the hyperbolic logarithm of
$\cot\tfrac12\alpha$ {{entry one_logarithm}}. Euler looks up the common logarithm of the cotangent of
$1°\,15'$, which is 1,6611437, and turns it into a hyperbolic one by the factor 2,30258509. So the first
member of {{eq pendulum.29 2}} is a product of three factors,

::: margin
2,30258509… is $\ln 10$, so that the last two factors are $\ln\cot 1°15'$.
:::

$$ 1{,}0004801{{entry the_factor}} \cdot 2{,}3025851 \cdot 1{,}6611437 = 3{,}82675, \tag{1} $$

worked out by logarithms that he does not write down.

## The program

With a table of seven places the product is three look-ups, an addition and one antilogarithm.
*/

Fifty product(const Fifty& factor, const Fifty& modulus, const Fifty& common)  // (1)
{
  return (SevenPlaces::of(factor) + SevenPlaces::of(modulus) + SevenPlaces::of(common)).number();
}

/*!
The result is right. That is strange, since one of its factors is not. So the program also asks the
question backwards, which factors have a product that rounds to 3,82675; and it tries what becomes of the
factor as it stands, if the calculator cuts off further places where he should have rounded.
*/

double factor_for(double product)
{
  return product / (2.3025851 * 1.6611437);
}

Fifty product_with_cuts()
{
  const auto cut = [](const char* number) { return SevenPlaces::cut_off(Fifty(number)); };
  return (cut("1.0004801") + cut("2.3025851") + cut("1.6611437")).number();
}

const auto swing_ = amplitude_from_top(5_deg, closed(90_deg, 179.9_deg));

TELL
{
  const Fifty alpha = swing_.eta.fifty() / 2;
  const Fifty true_factor = ratio_by_mean(exact::pi() - 2 * alpha);
  const Fifty ten = log(Fifty(10));
  const Fifty common = -log(tan(alpha / 2)) / ten;
  const bool his = swing_.eta == 5_deg;
  const Fifty by_table = product(his ? Fifty("1.0004801") : true_factor, Fifty("2.3025851"), common);
  tell_lines("lines", "the reckoning, line by line",
             {{"log cot ½α", "1,6611437", rounded(common, 7), common},
              {"hyperbolic per common", "2,30258509", rounded(ten, 8), ten},
              {"the same, shorter", "2,3025851", rounded(ten, 7), ten},
              {"member I", "3,82675", rounded(by_table, 5), true_factor * common * ten}},
             his);
  tell("product_printed", double(by_table), "the product (1) by the table");
  tell("good_from", factor_for(3.826745), "the least factor whose product rounds to 3,82675");
  tell("good_to", factor_for(3.826755), "the greatest");
  tell("product_cut", double(product_with_cuts()), "the product (1) if every logarithm is cut off");
}

TELL
{
  curve("factors", {"factor", "product"}, [](Curve& c) {
    const double true_factor = double(ratio_by_mean(exact::pi() * 35 / 36));
    for(const double factor : {1.000472, true_factor, 1.0004801, 1.000483})
      c.put({factor, factor * 2.3025851 * 1.6611437});
  });
}

/*!
{{table lines}}

From the factor of our copy the table gives {{product_printed|8}}, which rounds to {{product_printed|6}}. To
round to what he has, the factor would have to lie between {{good_from|8}} and {{good_to|8}}, and the
true one does. Only if every logarithm were cut off at its seventh place, and the product ({{product_cut|8}})
at its fifth, would his factor lead to his product. Euler does cut now and then, as in
{{sec pendulum.35}}. So either the factor is a slip of pen or press, made twice, for a number near
{{good_from|7}}, or he worked with the wrong factor and the cutting saved him. The paper does not tell.

::: figure pendulum-31
alt: The product against the factor, a rising line. A band shows the products that round to 3.82675. The
true factor lies in the band, that of our copy, 1.0004801, above it.

Which factors lead to his product: those whose point lies in the band. The true factor does, that of
our copy does not.
:::

## Checks
*/

CHECK_THAT("the looked-up logarithm, both values of ln 10 and member I are right as they stand")
{
  const Fifty logarithm = -log(tan(exact::pi() / 144));
  CHECK(logarithm / log(Fifty(10)) == printed("1,6611437"));
  CHECK(log(Fifty(10)) == printed("2,30258509"));
  CHECK(log(Fifty(10)) == printed("2,3025851"));
  CHECK(ratio_by_mean(exact::pi() * 35 / 36) * logarithm == printed("3,82675"));
}

CHECK_THAT("from his factors the table gives 3,82676, and only cutting off gives what he has")
{
  CHECK(rounded(product(Fifty("1.0004801"), Fifty("2.3025851"), Fifty("1.6611437")), 5) == "3,82676");
  CHECK(rounded(product(Fifty("1.0004762"), Fifty("2.3025851"), Fifty("1.6611437")), 5) == "3,82675");
  CHECK(rounded(product_with_cuts(), 5) == "3,82676");
  CHECK(truncated(product_with_cuts(), 5) == "3,82675");
}

/*!
The factor is wrong here by another proof than in {{sec pendulum.30}}: it does not fit its product. And there
is a letter $l$ too many before the cotangent, which {{sec pendulum.35}} has not.
*/

const Doubtful the_factor{
    "§31, (1), the first factor",
    {"1,0004801", 1.0004801},
    {"1,0004762", 1.0004762},
    "the product asks for it, and it is the series of §30",
    [](double factor) { return factor * 2.3025851 * 1.6611437 == printed("3,82675"); }};

const Doubtful one_logarithm{
    "§31, what is multiplied by the series",
    {"the hyperbolic logarithm of l cot ½α", std::log(-std::log(std::tan(1.25_deg)))},
    {"the hyperbolic logarithm of cot ½α", -std::log(std::tan(1.25_deg))},
    "it is what the last two factors come to",
    [](double l) {
      return l == within(2.3025851 * 1.6611437, 2e-7, "half a unit of the seventh decimal of each");
    }};

/*!
What is told follows from the product's decimals and two exact factors, and the table's last column from the
time itself:
*/

CHECK_THAT("the factors told give 3.826745 and 3.826755, and the true column is that of the exact time")
{
  const Fifty logarithms = Fifty("2.3025851") * Fifty("1.6611437");
  for(const Told& now : told_at("", "eta=1", "eta=90"))
  {
    CHECK(now.value("good_from") == within_relative(Fifty("3.826745") / logarithms, 4e-16, "a quotient"));
    CHECK(now.value("good_to") == within_relative(Fifty("3.826755") / logarithms, 4e-16, "a quotient"));
    CHECK(now.value("product_cut")
          == between(Fifty("3.82675"), Fifty("3.82676"), "cut off at the fifth place"));
    const Fifty half = swing_.eta.fifty() / 4, ten = log(Fifty(10)),
                log_cot = log(cos(half)) - log(sin(half));
    const auto rows = now.rows("lines");
    CHECK(rows[0].value("true") == within_relative(log_cot / ten, 2e-16, "rounded to a double"));
    CHECK(rows[1].value("true") == within_relative(ten, 2e-16, "rounded to a double"));
    CHECK(rows[2].value("true") == within_relative(ten, 2e-16, "rounded to a double"));
    const Fifty factor = swing::oracle::ratio_from_bottom(swing_.eta.fifty());
    CHECK(rows[3].value("true") == within_relative(factor * log_cot, 2e-16, "rounded to a double"));
    const Fifty used = now.setting().empty() ? Fifty("1.0004801") : factor;
    const double by_table = 2e-7 * static_cast<double>(factor * log_cot);
    CHECK(now.value("product_printed")
          == within(used * log_cot, by_table, "three logarithms of seven places, each ± ½ in the last"));
  }
}

CHECK_THAT("each point of the figure is a factor and its product, and only the true factor is in the band")
{
  for(const Told& now : told_at(""))
  {
    int inside = 0;
    for(const auto& point : now.points("factors"))
    {
      const Fifty product = Fifty(point.at("factor")) * Fifty("2.3025851") * Fifty("1.6611437");
      CHECK(point.value("product") == within_relative(product, 4e-16, "two products"));
      inside += product > Fifty("3.826745") && product < Fifty("3.826755") ? 1 : 0;
    }
    CHECK(inside == 1);
    const Fifty factor = swing::oracle::ratio_from_bottom(exact::pi() / 36);
    CHECK(now.points("factors")[1].value("factor") == within_ulps(factor, 1, "rounded to a double"));
  }
}
