#include "edition/section.hpp"
#include "pendulum/three_members.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 29, "The solution, and the factor that was forgotten")

using pendulum::Members, pendulum::ratio_by_mean, pendulum::three_members;

/*!
## What Euler does

The problem is set at the end of {{sec pendulum.28}}: a pendulum swings through arcs that fall little short
of 180° to either side; how long does one swing take? Everything is ready. Let $\Theta$ be the time of a
swing of the same pendulum through infinitely small arcs, let the descent begin at the point $g$, whose
distance from the upper vertical is the angle $bAg = \eta$, and put $\alpha = \tfrac12\eta$. First the value
of the series

$$ P = 1 + \frac{1^2}{2^2}\sin^2\alpha + \frac{1^2\cdot3^2}{2^2\cdot4^2}\sin^4\alpha
   + \frac{1^2\cdot3^2\cdot5^2}{2^2\cdot4^2\cdot6^2}\sin^6\alpha + \text{etc.} \tag{1} $$

is wanted; $\alpha$ being small, three or four of its terms will mostly do. Then the array of
{{sec pendulum.21}}, summed by its first three columns, gives what he announces as the time of one whole
swing,

$$ T = \Theta\left( l\cot\tfrac12\alpha \cdot P + \cos\alpha\; l2 + \tfrac34\cos\alpha\,\sin^2\alpha\; l2 \right),
   \qquad \Theta = \frac{\pi\sqrt b}{\sqrt{2g}}, \tag{2} $$

and half of it as the time of an ascent or a descent.

::: margin
Today: the bracket is $K(\cos\alpha)$, and (1) is $\frac2\pi K(\sin\alpha)$. The large swing carries within
it the small swing of the complementary amplitude.
:::

Here he has slipped. What the array sums to, from {{sec pendulum.16}} on, is $t\sqrt{2g}/\sqrt b$, where $t$
is the time of *half* a swing. With $T = 2t$ and with his own $\Theta$ that makes

$$ T = \frac{2}{\pi}\,\Theta\left( l\cot\tfrac12\alpha \cdot P + \cos\alpha\; l2 + \tfrac34\cos\alpha\,\sin^2\alpha\; l2 \right). \tag{3} $$

The factor $2/\pi$ is missing in {{eq 2}} and, since both examples use it as it stands, in every result that
follows.

## The program

The three members are kept apart, because the examples want them one by one. The first is taken as minus the
logarithm of a tangent, which neither overflows nor cancels, however small the angle.

::: code pendulum/three_members.hpp three_members
:::
*/

double as_printed(const Members<double>& m)  // (2), in units Θ
{
  return m.sum();
}

double as_it_should_be(const Members<double>& m)  // (3), in units Θ
{
  return 2 / std::numbers::pi * m.sum();
}

/*!
Euler leaves η free, and the pendulum through $\Theta$.
*/

const auto swing_ = amplitude_from_top(5_deg);
const auto Theta = real("Theta", 1.0, seconds, positive, "time of one infinitely small swing");
const auto terms = integer("terms", 4, 1, 1000, "terms of the series P that are kept");

TELL
{
  const auto m = three_members(swing_.eta / 2, terms);
  const double exact = swing::ratio({swing_.zeta, swing_.eta});
  tell("P", m.factor, "the sum of the series (1)");
  tell("first", m.first, "first member, l cot ½α · P");
  tell("second", m.second, "second member, cos α l 2");
  tell("third", m.third, "third member, ¾ cos α sin²α l 2");
  tell("bracket", m.sum(), "their sum");
  tell("T_printed", Theta * as_printed(m), seconds, "the swing by (2), as it is printed");
  tell("T_mended", Theta * as_it_should_be(m), seconds, "the swing by (3)");
  tell("T", Theta * exact, seconds, "the swing, exactly");
  tell("too_long", as_printed(m) / exact, "how many times too long (2) is");
}

/*!
How far the two laws lie from the truth when the angle is not so small, and how the error shrinks with every
further column:
*/

TELL
{
  curve("laws", {"eta", "printed", "mended", "exact"}, [](Curve& c) {
    for(double eta = 0.05; eta <= 90; eta += eta < 2 ? 0.05 : 0.5)
    {
      const auto m = three_members(eta * 0.5_deg, 200);
      c.put({eta, as_printed(m), as_it_should_be(m), swing::ratio_from_top(eta * 1_deg)});
    }
  });
  const double alpha = swing_.eta / 2;
  const auto members = [=](int kept) {
    const auto m = three_members(alpha, 40);
    return 2 / std::numbers::pi * (m.first + (kept > 1 ? m.second : 0) + (kept > 2 ? m.third : 0));
  };
  race("ratio", "T/Θ", ratio_by_mean(Fifty(2 * alpha)),
       {{"first member", [=] { return members(1); }, "members"},
        {"two members", [=] { return members(2); }, "members"},
        {"three members", [=] { return members(3); }, "members"},
        {"series in cc, 1000 terms", [=] { return pendulum::series(std::pow(std::cos(alpha), 2), 1000); }},
        {"arithmetic-geometric mean", [=] { return ratio_by_mean(2 * alpha); }},
        {"this edition", [=] { return swing::ratio_from_top(2 * alpha); }}});
}

/*!
For a descent from {{eta|3}}° below the top the three members are {{first|7}}, {{second|6}} and {{third|3}}.
Printed as {{T_printed|6}} s for a seconds pendulum, the swing takes {{T_mended|6}} s.

::: figure pendulum-29
alt: T over Theta against eta from 0 to 90 degrees. The exact curve and the mended formula lie on each other
up to about 40 degrees; the printed formula runs far above both, everywhere higher by more than a half.

The printed law {{eq 2}}, the mended one {{eq 3}} and the truth. The printed law is not off by a small
correction but by $\pi/2$ throughout; the mended one leaves the truth only when the columns that Euler
dropped begin to matter.
:::

## Checks

First that the members are what he says: they miss the exact sum by the fourth and later columns of the
array, which {{sec pendulum.28}} bounds from both sides.
*/

CHECK_THAT(
    "the three members fall short of K(cos α) by what the fourth and later columns hold, and no more")
{
  const double S2 = 0.436234912546214963845414327809;  // the fourth column's sum, pendulum.28
  for(const double eta : {1_deg, 5_deg, 10_deg, 20_deg, 60_deg})
  {
    const Fifty alpha = Fifty(eta) / 2;
    const Fifty x = pow(sin(alpha), 2);
    const Fifty missing = ratio_by_mean(2 * alpha) * exact::pi() / 2 - three_members(alpha, 200).sum();
    CHECK(missing / (x * x)
          == between(S2 * cos(alpha) / (1 - 0.881 * x), S2 / cos(alpha), "the columns' sums fall"));
  }
}

CHECK_THAT("nothing is lost however near the top the descent begins")
{
  for(const double eta : {1e-3, 1e-8, 1e-16, 1e-150, 1e-300})
  {
    const Fifty exact = ratio_by_mean(Fifty(eta)) * exact::pi() / 2;
    const double left_out = 0.04 * std::pow(eta, 4);  // more than the fourth column
    CHECK(three_members(eta / 2, 4).sum()
          == within(exact, 4 * 1.2e-16 * static_cast<double>(exact) + left_out,
                    "three roundings of the logarithm, and the columns left out"));
  }
}

/*!
Then the factor. Euler contradicts himself in three places, and each of them settles it: the time of the
descent by {{sec pendulum.16}} and {{sec pendulum.21}}, doubled; the series of {{sec pendulum.09}}, which
converges here too, if slowly; and the motion itself.
*/

double descent_by_steps(double eta,
                        int steps)  // from rest at η to the lowest point, ψ'' = sin ψ, by Störmer's rule
{
  const double h = 2 * swing::quarter_time_from_top(eta) / steps;
  double psi = eta;
  double half_step = h / 2 * std::sin(psi);  // the velocity, half a step on
  double before = psi;
  int n = 0;
  for(; psi < std::numbers::pi; ++n)
  {
    before = psi;
    psi += h * half_step;
    half_step += h * std::sin(psi);
  }
  return h * (n - (psi - std::numbers::pi) / (psi - before));
}

const Erratum forgotten_factor{
    "§29, the law for T",
    {"T = Θ[…]", 1.0},
    {"T = (2/π) Θ[…]", 2 / std::numbers::pi},
    "his bracket is t√(2g)/√b, and T = 2t, Θ = π√b/√(2g)",
    [](double factor) {
      const double claimed = factor * three_members(2.5_deg, 6).sum();
      const double by_his_series = pendulum::series(std::pow(std::cos(2.5_deg), 2), 20'000);
      const double by_the_motion = 2 / std::numbers::pi * descent_by_steps(5_deg, 20'000);
      return claimed
                 == within(by_his_series, 2e-6, "the fourth column, 1.0e-6; the terms after 20000, 1e-19")
             && claimed == within(by_the_motion, 2e-6, "the fourth column; the steps err by 1e-7")
             && claimed == within(ratio_by_mean(Fifty(5_deg)), 2e-6, "the fourth column");
    }};

/*!
The rest is the scan's. In {{eq 1}} it prints ½ for the square of ½; in {{eq 2}} it takes the letter $l$ for
a stroke of division, a 1 for a 3, and has lost the sine of the third member.
*/

bool is_coefficient(double reading, int n)  // of sin²ⁿα in (1), as an exact fraction
{
  return Rational::exactly(reading) == pow(exact::double_factorial_ratio(n), 2);
}

const Emendation first_coefficient{"§29, the series, second term",
                                   {"½ sin²α", 0.5},
                                   {"(1²/2²) sin²α", 0.25},
                                   "§§10, 11 and 37 have the squares",
                                   [](double a) { return is_coefficient(a, 1); }};

const Emendation third_coefficient{"§29, (2), third term of the series",
                                   {"3·9/(4·16)", 27.0 / 64},
                                   {"1·9/(4·16)", 9.0 / 64},
                                   "the series just before has 1²·3²",
                                   [](double a) { return is_coefficient(a, 2); }};

const Emendation logarithm{"§29, (2), first member",
                           {"Θ / cot ½α", std::tan(1.25_deg)},
                           {"Θ l cot ½α", -std::log(std::tan(1.25_deg))},
                           "it is the member with the logarithm of the cotangent, worked out in §31",
                           [](double l) {
                             const auto m = three_members(2.5_deg, 6);
                             return l * m.factor + m.second + m.third
                                    == within(swing::quarter_time_from_top(5_deg), 2e-6,
                                              "the fourth column");
                           }};

const Emendation third_member{
    "§29, (2), third member",
    {"¾ cos²α l 2", 0.75 * std::pow(std::cos(2.5_deg), 2) * std::numbers::ln2},
    {"¾ cos α sin²α l 2", 0.75 * std::cos(2.5_deg) * std::pow(std::sin(2.5_deg), 2) * std::numbers::ln2},
    "it is the third column of §27, and §32 works it out with the sine",
    [](double third) {
      const auto m = three_members(2.5_deg, 6);
      return m.first + m.second + third
             == within(swing::quarter_time_from_top(5_deg), 2e-6, "the fourth column");
    }};
