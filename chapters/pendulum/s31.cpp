#include "edition/section.hpp"
#include "pendulum/reckoning.hpp"
#include "pendulum/series.hpp"

SECTION(pendulum, 31, "First example: the member with the logarithm")

using namespace pendulum;

/*!
## What Euler does

The series of {{sec pendulum.30}} is to be multiplied by the hyperbolic logarithm of $\cot\tfrac12\alpha$.
So he looks up the common logarithm of the cotangent of $1°\,15'$, which is 1,6611437, and turns it into a
hyperbolic one by the factor 2,30258509. The first member of {{eq pendulum.29 2}} is then a product of three
factors,

$$ 1{,}0004801 \cdot 2{,}3025851 \cdot 1{,}6611437 = 3{,}82675, \tag{1} $$

worked out by logarithms that he does not write down.

::: margin
2,30258509… is $\ln 10$, so that the last two factors are $\ln\cot 1°15'$.
:::

## The program

With a seven-place table the product is three look-ups, an addition and one antilogarithm.
*/

SevenPlaces logarithm_of_product(const Fifty& factor, const Fifty& modulus, const Fifty& common)  // (1)
{
  return SevenPlaces::of(factor) + SevenPlaces::of(modulus) + SevenPlaces::of(common);
}

const auto swing_ = amplitude_from_top(5_deg, closed(90_deg, 179.9_deg));

Fifty common_logarithm_of_cotangent(const Fifty& alpha)
{
  return -log(tan(alpha / 2)) / log(Fifty(10));
}

/*!
The printed result is right. That is strange, since one of its factors is not ({{sec pendulum.30}}). So the
program asks the question backwards: which factors have a product that rounds to 3,82675?
*/

struct Factors
{
  double lowest, highest;
};

Factors that_round_to(double product, double half_a_unit)
{
  const double others = 2.3025851 * 1.6611437;
  return {(product - half_a_unit) / others, (product + half_a_unit) / others};
}

/*!
And it tries what becomes of the printed factor if the calculator cuts off further places where he should
have rounded them.
*/

Fifty product_with_cuts()
{
  return (SevenPlaces::cut_off(Fifty("1.0004801")) + SevenPlaces::cut_off(Fifty("2.3025851"))
          + SevenPlaces::cut_off(Fifty("1.6611437")))
      .number();
}

TELL
{
  const Fifty alpha = swing_.eta.fifty() / 2;
  const Fifty factor = ratio_by_mean(exact::pi() - 2 * alpha);
  const Fifty common = common_logarithm_of_cotangent(alpha);
  const bool his = swing_.eta == 5_deg;
  const SevenPlaces product =
      logarithm_of_product(his ? Fifty("1.0004801") : factor, Fifty("2.3025851"), common);
  tell_lines("lines", "the reckoning, line by line",
             {{"log cot ½α", "1,6611437", rounded(common, 7), common},
              {"hyperbolic per common", "2,30258509", rounded(log(Fifty(10)), 8), log(Fifty(10))},
              {"the same, shorter", "2,3025851", rounded(log(Fifty(10)), 7), log(Fifty(10))},
              {"member I", "3,82675", rounded(product.number(), 5), factor * common * log(Fifty(10))}},
             his);
  tell("hyperbolic", -log(tan(alpha / 2)), "l cot ½α, the hyperbolic logarithm");
  tell("first", double(factor * common * log(Fifty(10))), "the first member, exactly");
  tell("product_printed", double(product.number()),
       "the product (1) by the table, from the factor as printed");
  const Factors good = that_round_to(3.82675, 0.5e-5);
  tell("good_from", good.lowest, "the least factor whose product rounds to 3,82675");
  tell("good_to", good.highest, "the greatest");
  tell("product_cut", double(product_with_cuts()),
       "the product from the factor as printed, if every logarithm is cut off");
  curve("factors", {"factor", "product"}, [](Curve& c) {
    for(double f = 1.000470; f <= 1.0004851; f += 1e-6)
      c.put({f, f * 2.3025851 * 1.6611437});
  });
}

/*!
From the printed factor the table gives {{product_printed|8}}, which rounds to 3,82676. To round to what is
printed, the factor would have to lie between {{good_from|9}} and {{good_to|9}}, and the true one does. Only
if every logarithm were cut off at its seventh place, and the product ({{product_cut|8}}) at its fifth,
would the printed factor lead to the printed product. Euler does cut now and then, as in
{{sec pendulum.35}}. So either the factor is a misprint, made twice, for a number near 1,000476, or he
worked with the wrong factor and cutting saved him. The paper does not tell.

::: figure pendulum-31
alt: The product against the factor, a rising line. A band shows the products that round to 3.82675. The
true factor 1.0004762 lies in the band, the printed factor 1.0004801 above it.

Which factors lead to the printed product: those whose point lies in the band. The true factor does, the
printed one does not.
:::

## Checks
*/

CHECK_THAT("the looked-up logarithm and the two printed values of ln 10 are right to their last digits")
{
  CHECK(common_logarithm_of_cotangent(exact::pi() / 72) == printed("1,6611437"));
  CHECK(log(Fifty(10)) == printed("2,30258509"));
  CHECK(log(Fifty(10)) == printed("2,3025851"));
}

CHECK_THAT("member I is right as printed, though one of its printed factors is not")
{
  const Fifty alpha = exact::pi() / 72;
  const Fifty truth = ratio_by_mean(exact::pi() - 2 * alpha) * -log(tan(alpha / 2));
  CHECK(truth == printed("3,82675"));
  CHECK(
      rounded(logarithm_of_product(Fifty("1.0004801"), Fifty("2.3025851"), Fifty("1.6611437")).number(), 5)
      == "3,82676");
  CHECK(truncated(product_with_cuts(), 5) == "3,82675");
}

/*!
The factor stands here a second time, still wrong; and a letter $l$ too many stands before the cotangent:
what is multiplied by 2,30258509 is the common logarithm of the cotangent, not the logarithm of a logarithm.
*/

const Doubtful the_factor{"§31, (1), the first factor",
                          {"1,0004801", 1.0004801},
                          {"1,0004762", 1.0004762},
                          "as in §30, from where it is taken",
                          [](double reading) {
                            return ratio_by_mean(35 * exact::pi() / 36)
                                   == within(reading, 0.5e-7, "half a unit of its last place");
                          }};

const Emendation one_logarithm{
    "§31, the logarithm of the cotangent",
    {"hyperbolic logarithm of l cot ½α", std::log(-std::log(std::tan(1.25_deg)))},
    {"hyperbolic logarithm of cot ½α", -std::log(std::tan(1.25_deg))},
    "it is what the product of the last two factors comes to",
    [](double l) {
      return l == within(2.3025851 * 1.6611437, 2e-7, "each factor is rounded to seven decimals");
    }};
