#include "balance/euler.hpp"
#include "balance/mathieu.hpp"
#include "edition/section.hpp"

SECTION(balance, 27, "Case 1: no phases meet the four conditions")

using namespace balance;

/*!
## What Euler does

The four conditions of {{sec balance.26}} cannot all be met, whatever the phases. If α = 0 and β = 0, the
first two are; the others become

$$ \text{III.}\ 0 = 1 - K, \qquad \text{IV.}\ 0 = 1 + K, \tag{1} $$

which is impossible, since their sum is $0 = 2$. The same happens with α = 90° and β = 90°: then the last two
are met, and I and II become $0 = 1 + K$ {{entry angle_m}} and $0 = 1 - K$. In general, too, there arises
such an absurdity, for

$$ \begin{aligned} \text{I}\cdot\sin\beta + \text{II}\cdot\sin\alpha:&\\ 0 = 2&\sin\alpha\sin\beta,\\
\text{III}\cdot\cos\beta + \text{IV}\cdot\cos\alpha:&\\ 0 = 2&\cos\alpha\cos\beta, \end{aligned} \tag{2} $$

and both at once, he says, cannot be {{entry both_products}}.

They can: with α = 0 and β = 90°, or the other way round, both products vanish. The contradiction lies
elsewhere, in I and III by themselves: they would have $\sin\alpha$ and $\cos\alpha$ vanish together, unless

$$ K = -1 \quad\text{or}\quad K = 1. \tag{A} $$

For these two the conditions can be met, at α = 0 and β = 90° if $K = 1$, at α = 90° and β = 0 if $K = -1$,
with any amplitudes. With $p = am/b = \mu\mu am/2g$ that is where

$$ \lambda = \frac{2\mu}{\sqrt{1 \pm p}}. \tag{B} $$

::: margin
Today: the determinant of the map from the constants to the start is $\mu(1+K)(1-K)$ for each pan. Where it
vanishes, some starts have no solution, others many.
:::

Then Euler's formula has a pan set out from complete rest. No true motion does: the pan's own equation
({{sec balance.15}}) has for one start one solution, and from rest that is rest. What fails is the
approximation, and it fails where one would expect it, about $\lambda = 2\mu$, between whose bounds the
swings of a pan grow without end ({{sec balance.22}}).

## The program
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, scale, "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, scale, "frequency of the pans, μ = √(2g/b)");
const auto a = real("a", 16. / 9, feet, scale, "half the beam");
const auto g = real("g", 16, feet, scale, "height fallen in the first second");
const auto m = angle("m", 1. / 6, open(0_deg, 90_deg), "inclination of the beam at the start");

Fifty arm()  // p = am/b
{
  return mu.fifty() * mu.fifty() * a.fifty() * m.fifty() / (2 * g.fifty());
}

Fifty K()
{
  return K_of<Fifty>(lambda.fifty(), mu.fifty(), a.fifty(), g.fifty(), m.fifty());
}

double where(int K_)  // (B)
{
  return lambda_where_K_is_one(mu, a, g, K_ * m);
}

double determinant(const Fifty& K_)  // over μ
{
  return double((1 + K_) * (1 - K_));
}

TELL
{
  require(lambda.fifty() != 2 * mu.fifty(), "lambda", "not 2 mu, where K is infinite");
  require(arm() >= Fifty("1e-300"), "a", "such that μμam/2g, which is am/b, is at least 1e-300");
  require(arm() <= Fifty("0.99"), "a", "such that μμam/2g, which is am/b, is at most 0.99");
  const double p = double(arm());
  tell("p", p, "am/b");
  tell("K", double(K()), "K");
  tell("one_plus", double(1 + K()), "1 + K");
  tell("one_minus", double(1 - K()), "1 − K");
  tell("determinant", determinant(K()), "(1 + K)(1 − K)");
  tell("one", where(1), Unit{"1/s"}, "λ at which K = 1");
  tell("minus_one", where(-1), Unit{"1/s"}, "λ at which K = −1");
  if(p >= 1e-6 && p <= 0.4)
  {
    const Interval growing = unstable(mu, p, 1);
    tell("from", growing.from, Unit{"1/s"}, "a pan's swings grow from this λ", 11);
    tell("to", growing.to, Unit{"1/s"}, "to this", 11);
  }
}

/*!
What such a motion from nothing looks like: at $K = 1$, with α = 0 and $\mathfrak A = 1$, by
{{sec balance.25}}.
*/

Fifty from_nothing(const Fifty& p, const Fifty& t)  // μ = 1
{
  const Fifty l = 2 / sqrt(1 + p), i = l * p / 2;  // im is ½λp for m = 1
  return general<Fifty>(l, 1, i, {1, 0, 1, 0, 0, exact::pi() / 2}, t).at.eta;
}

TELL
{
  curve("nothing", {"t", "eta"}, [](Curve& out) {
    for(int j = 0; j <= 400; ++j)
      out.put({j / 8., double(from_nothing(Fifty(1) / 12, Fifty(j) / 8))});
  });
}

/*!
In the example $K$ is {{K|4}}, far from 1; it would be 1 if the beam had the frequency {{one|6}} 1/s, and −1
at {{minus_one|6}} 1/s. Both lie between {{from|6}} and {{to|6}} 1/s, the bounds within which the pan's true
equation has growing solutions.

::: figure balance-27
alt: A curve that starts level at zero and then swings. The swings grow for about six of them, to twice the
amplitude 𝔄 that was set, and begin to shrink.

A pan that begins to move out of complete rest: Euler's approximate solution where $K = 1$, at
$am:b = \tfrac1{12}$, over μt. The true equation has no such motion.
:::

## Checks
*/

CHECK_THAT(
    "(2) are I and II, III and IV so combined; at α = 0, β = 90° both are met, and all four only at K = ±1")
{
  for(const Rational& k : {Rational(1, 420), Rational(1), Rational(-1)})
  {
    // sines and cosines of 0° and 90°, and of an angle with the sine 3/5
    for(const auto& [sa, ca, sb, cb] :
        {std::array<Rational, 4>{0, 1, 1, 0},
         {1, 0, 0, 1},
         {0, 1, 0, 1},
         {Rational(3, 5), Rational(4, 5), Rational(5, 13), Rational(12, 13)}})
    {
      const Rational I = sa * (1 + k), II = sb * (1 - k), III = ca * (1 - k), IV = cb * (1 + k);
      CHECK(I * sb + II * sa == 2 * sa * sb);
      CHECK(III * cb + IV * ca == 2 * ca * cb);
      const bool all = I == 0 && II == 0 && III == 0 && IV == 0;
      CHECK(all == ((k == 1 && sa == 0 && cb == 0) || (k == -1 && ca == 0 && sb == 0)));
    }
  }
}

CHECK_THAT(
    "K is 1 and −1 at the two frequencies told, and both lie where swings grow, as the multipliers have it")
{
  for(const Told& now : told_at("", "lambda=5.999999999 m=3", "mu=0.2 lambda=0.7 a=30 g=5", "a=0.0001"))
  {
    const Fifty p = arm(), r = lambda.fifty() / mu.fifty(), K_ = p * (4 / (4 - r * r) - 1);
    CHECK(now.value("p") == within_ulps(p, 0.5, "one rounding"));
    CHECK(now.value("K") == within_ulps(K_, 0.5, "one rounding"));
    CHECK(now.value("one_plus") == within_ulps(1 + K_, 0.5, "one rounding"));
    CHECK(now.value("one_minus") == within_ulps(1 - K_, 0.5, "one rounding"));
    CHECK(now.value("determinant") == within_relative(1 - K_ * K_, 2e-16, "one rounding"));
    const Fifty one = 2 * mu.fifty() / sqrt(1 + p), minus = 2 * mu.fifty() / sqrt(1 - p);
    CHECK(now.value("one", Unit{"1/s"}) == within_relative(one, 1e-15, "a root"));
    CHECK(now.value("minus_one", Unit{"1/s"}) == within_relative(minus, 1e-15, "a root"));
    // to the second order of p the bounds are 2μ(1 ∓ ½·p): a = 1 ± q − q²/8, q = 2p, and λ = 2μ/√a
    const Fifty q = 2 * p, up = 1 + q - q * q / 8 - q * q * q / 64,
                down = 1 - q - q * q / 8 + q * q * q / 64;
    const double next = 4 * double(q * q * q * q) + 1e-12;
    CHECK(now.value("from", Unit{"1/s"})
          == within_relative(2 * mu.fifty() / sqrt(up), next, "q⁴, and the library"));
    CHECK(now.value("to", Unit{"1/s"}) == within_relative(2 * mu.fifty() / sqrt(down), next, "the same"));
    for(const int K_is : {1, -1})
      CHECK(floquet({1, where(K_is) / mu, double(p)}).growth > 0);
  }
  for(const Told& now : told_at("a=20 m=9", "a=1e-50"))  // strong and weak pulls
  {
    const Fifty p = arm();
    CHECK(now.value("one", Unit{"1/s"}) == within_relative(2 * mu.fifty() / sqrt(1 + p), 1e-15, "a root"));
    CHECK(now.value("minus_one", Unit{"1/s"})
          == within_relative(2 * mu.fifty() / sqrt(1 - p), 1e-13, "one less am:b"));
  }
}

CHECK_THAT(
    "λ = 2μ is refused, and not what no double tells from it; so is am/b above 0.99 or below 1e-300, "
    "and nothing between")
{
  for(const char* const no :
      {"lambda=6", "lambda=1 mu=0.5", "mu=1 g=1 m=0.99rad a=2.00000000000000001",
       "mu=2 g=2 m=0.99rad a=1.00000000000000001", "mu=1e-100 g=1 m=1rad a=1.9999999999999999e-100"})
    CHECK(refused_at(no));
  for(const char* const yes :
      {"lambda=5.99999999999999999", "lambda=6.00000000000000001", "mu=1 g=1 m=0.99rad a=2",
       "mu=2 g=2 m=0.99rad a=1", "mu=1e-100 g=1 m=1rad a=2.0000000000000001e-100"})
    CHECK(!refused_at(yes));
}

CHECK_THAT(
    "where K = 1 Euler's formula leaves rest with place and speed zero, against the equation of § 15")
{
  const Fifty p = Fifty(1) / 12, l = 2 / sqrt(1 + p), h("1e-12");
  CHECK(from_nothing(p, 0) == within(0, 1e-45, "fifty digits"));
  CHECK((from_nothing(p, h) - from_nothing(p, -h)) / (2 * h) == within(0, 1e-20, "the square of the step"));
  // the equation leaves the products of side tone and beam: −λλp cos λt times the side tones
  const auto left = [&](const Fifty& t) {
    const Fifty y = from_nothing(p, t);
    const Fifty bend = (from_nothing(p, t + h) + from_nothing(p, t - h) - 2 * y) / (h * h);
    return bend + (1 - p * l * l * cos(l * t)) * y;
  };
  CHECK(abs(left(2)) > Fifty("0.01"));
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("nothing", 7))
    {
      const Fifty t = point.at("t"), x = p * l / 2;
      CHECK(point.value("eta")
            == within(sin(t) + x / (2 - l) * sin((1 - l) * t) - x / (2 + l) * sin((1 + l) * t), 1e-15,
                      "one rounding, and the letters of § 25"));
    }
}

double both_vanish()  // of four pairs of 0° and 90°
{
  int many = 0;
  for(const int sine_a : {0, 1})
    for(const int sine_b : {0, 1})
      many += sine_a * sine_b == 0 && (1 - sine_a) * (1 - sine_b) == 0 ? 1 : 0;
  return many;
}

const Erratum both_products{"§27, where both products vanish, α and β being 0° or 90°",
                            {"nowhere", 0},
                            {"at α = 0, β = 90° and at α = 90°, β = 0", 2},
                            "sin 0° and cos 90° are zero; the contradiction is between I and III",
                            [](double reading) { return reading == both_vanish(); }};

/*!
For the angle $am$ our copy has $\alpha\alpha$; which, α being 90°, is a number, but not Euler's.
*/

const Emendation angle_m{
    "§27, the fraction with α = 90°",
    {"λλμμαα", [] { return 9 * std::pow(90_deg, 2) / (2 * 16 * 35); }},
    {"λλμμam", [] { return 9 * 16. / 9 / 6 / (2 * 16 * 35); }},
    "it is the K of §26",
    [](double reading) { return reading == within_relative(Fifty(1) / 420, 1e-14, "few roundings"); }};

/*!
## Go on from here

::: exercise
Where between $2\mu$ and the bounds of the growing swings do the two frequencies lie at which $K$ is 1 and
−1, if the beam pulls but little?
answer: Half-way: the bounds are at $2\mu(1\mp p)$, the two frequencies, by {{eq B}}, at
$2\mu(1\mp\tfrac12p)$. So Euler's formula fails well inside the interval.
:::
*/

CHECK_THAT("for a small p the two frequencies lie half-way between 2μ and the bounds")
{
  for(const Told& now : told_at("m=0.1", "m=0.01"))
  {
    const Unit unit{"1/s"};
    const double two = 2 * mu, p = double(arm());
    CHECK((two - where(1)) / (two - unstable(mu, p, 1).from) == within(0.5, p, "the next order of p"));
    CHECK((where(-1) - two) / (unstable(mu, p, 1).to - two) == within(0.5, p, "the same"));
    CHECK(now.value("from", unit) == within_relative(two * (1 - p), 2 * p * p, "the same"));
  }
}
