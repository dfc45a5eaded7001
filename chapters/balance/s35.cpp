#include "balance/euler.hpp"
#include "edition/section.hpp"

SECTION(balance, 35, "An example, and a slip in its last fraction")

using namespace balance;

/*!
## What Euler does

To see what the formulae of {{sec balance.33}} amount to he takes an example. As μ is mostly much greater
than λ, let $\lambda = 1$ and $\mu = 3$. An oscillation of the beam then takes π seconds, one of the pans, as
far as their motion is regular, a third of that. The number $i$ becomes

$$ i = \frac{9a}{4g}{{entry nine}} \tag{1} $$

and since $g$ is about 16 English feet, $a = 2$ feet would make it {{i_by_arm|5}}
{{entry i_of_two_feet}}. For the sake of easy numbers he takes $i = \tfrac14$, and for the angles $m$, $n$,
$n'$ about ten degrees, that is, in parts of the radius, a sixth {{entry sixth}}. Then

$$ \begin{aligned} \left.\begin{matrix}\eta\\ \vartheta\end{matrix}\right\} = {}&\tfrac16\cos3t\\
   &\pm\left(\tfrac1{720}\cos2t - \tfrac1{1008}\cos4t\right),\\ \omega = {}&\tfrac16\cos t,
   \end{aligned} \tag{2} $$

$$ \begin{aligned} \left.\begin{matrix}d\eta:dt\\ d\vartheta:dt\end{matrix}\right\} = {}&{-\tfrac12}\sin3t\\
   &\mp\bigl(\tfrac1{360}\sin2t\\ &\qquad - \tfrac1{252}\sin4t\bigr),\\
   \frac{d\omega}{dt} = {}&{-\tfrac16}\sin t; \end{aligned} \tag{3} $$

only that he has $\tfrac1{1080}$ for $\tfrac1{1008}$ and $\tfrac1{270}$ {{entry slip}} for $\tfrac1{252}$. The
second is four times the first: so he reckoned with it, and no printer has changed it. The divisor
$2\mu+\lambda$ is 7, and $imn$ is $\tfrac1{144}$.

The example has two properties that he does not mention. A sixth of the radius is {{sixth|4}}°, not ten
degrees. And with $\mu = 3\lambda$ the slower of the two tones that the beam adds to a pan, $\mu - \lambda$,
is twice the beam's own frequency. That is just the tone of the term which his equations have dropped
({{sec balance.28}}): complete to the second order the example is, with $F = \tfrac1{360}$,

$$ \begin{aligned} \left.\begin{matrix}\eta\\ \vartheta\end{matrix}\right\} = {}&\tfrac16\cos3t\\
   &\pm\bigl(-\tfrac1{720}\cos2t + \tfrac1{420}\cos3t\\
   &\qquad - \tfrac1{1008}\cos4t\bigr). \end{aligned} \tag{A} $$

::: margin
Today: a line spectrum. Two lines that a general balance would keep apart coincide in the example.
:::

So the fraction $\tfrac1{720}$ has the wrong sign, and a greater one is missing.

## The program

For any balance let go from rest, the tones that are added to the regular swings $n\cos\mu t$ and
$n'\cos\mu t$: by Euler, and complete to the second order.
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, closed(1e-3, 1e3), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, closed(1e-3, 1e3), "frequency of the pans, μ = √(2g/b)");
const auto i = real("i", 0.25, Unit{"1/s"}, closed(1e-100, 100), "λμμa/4g");
const auto m = angle("m", 1. / 6, closed(-20_deg, 20_deg), "inclination of the beam at the start");
const auto n = angle("n", 1. / 6, closed(-20_deg, 20_deg), "inclination of the pan P at the start");
const auto n1 = angle("n1", 1. / 6, closed(-20_deg, 20_deg), "inclination n′ of the pan Q at the start");
const auto a = real("a", 2, feet, scale, "half the beam, from which i would follow");
const auto g = real("g", 16, feet, scale, "height fallen in the first second");

struct Tone  // what is added to the regular swing of P, and of Q
{
  const char* which;
  Fifty frequency, eta_by_him, eta, theta_by_him, theta;
};

std::vector<Tone> tones()  // (2) and (A)
{
  const Fifty l = lambda.fifty(), u = mu.fifty(), im = i.fifty() * m.fifty();
  const Fifty N = n.fifty(), N1 = n1.fifty(), lower = im / (2 * u - l), upper = im / (2 * u + l);
  const Fifty K = lower - upper, F = 2 * im * m.fifty() * l / (u * u - 4 * l * l);
  return {{"μ − λ", u - l, N * lower, N * lower, -N1 * lower, -N1 * lower},
          {"μ", u, 0, F - N * K, 0, N1 * K - F},
          {"μ + λ", u + l, -N * upper, -N * upper, N1 * upper, N1 * upper},
          {"2λ", 2 * l, 0, -F, 0, F}};
}

TELL
{
  require(lambda.fifty() != 2 * mu.fifty(), "mu", "not half of lambda");
  require(mu.fifty() != 2 * lambda.fifty(), "mu", "not twice lambda");
  tell("beam", double(exact::pi() / lambda.fifty()), seconds, "an oscillation of the beam, π/λ");
  tell("pan", double(exact::pi() / mu.fifty()), seconds, "a regular one of a pan, π/μ");
  tell("i_by_arm", double(i_of<Fifty>(lambda.fifty(), mu.fifty(), a.fifty(), g.fifty())), Unit{"1/s"},
       "what i is with the arm a");
  tell("sixth", 1. / 6 / 1_deg, "degrees in a sixth of the radius");
  auto& rows = table("tones", "What is added to the regular swings, in radians",
                     {{"tone", "tone"},
                      {"frequency", "frequency", Unit{"1/s"}},
                      {"eta_by_him", "η by (2)"},
                      {"eta", "η complete"},
                      {"theta_by_him", "ϑ by (2)"},
                      {"theta", "ϑ complete"}});
  for(const Tone& t : tones())
    rows.row({t.which, double(t.frequency), double(t.eta_by_him), double(t.eta), double(t.theta_by_him),
              double(t.theta)});
}

/*!
{{table tones}}

::: figure balance-35
alt: Upright bars at the frequencies two, three and four. Euler has a short one upwards at two and a shorter
one downwards at four. The complete second order has one downwards at two, a higher one upwards at three, and
the same as Euler's at four.

The tones that are added to P's regular swing in the example, in units of $\tfrac1{720}$: Euler's, and those
of the complete second order, where the two of the frequency 2 are drawn as one.
:::

## Checks
*/

CHECK_THAT("the tones add up to Euler's formula, and to the complete second order, at any moment")
{
  for(const Told& now : told_at("", "lambda=0.2 mu=3 i=1e-3 m=-5 n=12 n1=-7 a=3 g=16.1",
                                "mu=2.000000001 n1=0 m=0.3 a=1e-50", "lambda=7 mu=3.4 i=2 m=4 g=1e70"))
  {
    const ReleaseOf<Fifty> r{
        lambda.fifty(), mu.fifty(), i.fifty(), {m.fifty(), n.fifty(), n1.fifty()}, Fifty("0.25")};
    const auto rows = now.rows("tones");
    const auto all = tones();
    REQUIRE(rows.size() == 4);
    for(const char* moment : {"0", "0.7", "31.4"})
    {
      const Fifty t(moment), alone = cos(r.mu * t);
      Angles<Fifty> his{0, r.at.eta * alone, r.at.theta * alone}, whole = his;
      for(const Tone& tone : all)
      {
        const Fifty wave = cos(tone.frequency * t);
        his.eta += tone.eta_by_him * wave;
        his.theta += tone.theta_by_him * wave;
        whole.eta += tone.eta * wave;
        whole.theta += tone.theta * wave;
      }
      const Angles<Fifty> by_2 = euler<Fifty>(r, t), second = second_order<Fifty>(r, t);
      CHECK(his.eta == within(by_2.eta, 1e-40, "fifty digits"));
      CHECK(his.theta == within(by_2.theta, 1e-40, "fifty digits"));
      CHECK(whole.eta == within(second.eta, 1e-38, "fifty digits, and a divisor of 4e-9"));
      CHECK(whole.theta == within(second.theta, 1e-38, "the same"));
    }
    for(std::size_t j = 0; j < 4; ++j)
    {
      CHECK(rows[j].value("frequency", Unit{"1/s"}) == within_ulps(all[j].frequency, 0.5, "one rounding"));
      CHECK(rows[j].value("eta_by_him") == within_ulps(all[j].eta_by_him, 0.5, "one rounding"));
      CHECK(rows[j].value("eta") == within_ulps(all[j].eta, 0.5, "one rounding"));
      CHECK(rows[j].value("theta_by_him") == within_ulps(all[j].theta_by_him, 0.5, "one rounding"));
      CHECK(rows[j].value("theta") == within_ulps(all[j].theta, 0.5, "one rounding"));
    }
    CHECK(now.value("beam", seconds) == within_ulps(acos(Fifty(-1)) / r.lambda, 0.5, "one rounding"));
    CHECK(now.value("pan", seconds) == within_ulps(acos(Fifty(-1)) / r.mu, 0.5, "one rounding"));
    CHECK(now.value("i_by_arm", Unit{"1/s"})
          == within_ulps(r.lambda * r.mu * r.mu * a.fifty() / 4 / g.fifty(), 0.5, "one rounding"));
    CHECK(now.value("sixth") == within_ulps(30 / exact::pi(), 3, "a division by the rounded degree"));
  }
}

CHECK_THAT("pans half or twice as quick as the beam are refused, and not those that no double tells from "
           "them")
{
  for(const char* const tuned : {"mu=0.5", "mu=2", "lambda=3 mu=1.5", "lambda=3 mu=6"})
    CHECK(refused_at(tuned));
  for(const char* const beside : {"mu=0.49999999999999999999", "mu=0.50000000000000000001",
                                  "mu=1.99999999999999999999", "mu=2.00000000000000000001"})
    CHECK(!refused_at(beside));
}

CHECK_THAT("in the example the tones are the fractions of (2), (3) and (A), in whole numbers")
{
  const Rational im(1, 24), n_(1, 6), lower = im * n_ / 5, upper = im * n_ / 7;
  CHECK(lower == Rational(1, 720));
  CHECK(upper == Rational(1, 1008));
  CHECK(2 * lower == Rational(1, 360));
  CHECK(4 * upper == Rational(1, 252));
  const Rational F = 2 * im * n_ / (9 - 4);
  CHECK(F == Rational(1, 360));
  CHECK(lower - F == Rational(-1, 720));
  CHECK(F - lower + upper == Rational(1, 420));
  CHECK(Rational(9 * 2, 4 * 16) == Rational(9, 32));
}

CHECK_THAT("(3) is what the rates of § 33 are in the example")
{
  for(const double t : {0.3, 1., 2.5})
  {
    const Angles<> rate = euler_rates(example_of_35, t);
    const double strays = std::sin(2 * t) / 360 - std::sin(4 * t) / 252;
    CHECK(rate.eta == within(-std::sin(3 * t) / 2 - strays, 2e-16, "few roundings"));
    CHECK(rate.theta == within(-std::sin(3 * t) / 2 + strays, 2e-16, "few roundings"));
    CHECK(rate.omega == within(-std::sin(t) / 6, 1e-16, "few roundings"));
  }
}

const Erratum slip{
    "§35, the last fraction of the pans' velocities; with it 1/1080 in η and ϑ",
    {"1/270", 1. / 270},
    {"1/252", 1. / 252},
    "(μ+λ)imn/(2μ+λ)",
    [](double reading) {  // a quarter of it, driven by imn cos 4t, satisfies x″ + 9x = imn cos 4t
      return (16 - 9) * reading / 4 == within_ulps(Fifty(1) / 144, 2, "two roundings");
    }};

const Emendation nine{"§35, the number i", {"2a/4g", 2}, {"9a/4g", 9}, "λμμ is 9", [](double reading) {
                        return reading / 4 == i_of<double>(1, 3, 1, 1);
                      }};

const Emendation i_of_two_feet{"§35, i for a = 2 feet",
                               {"1/12", 1. / 12},
                               {"9/32", 9. / 32},
                               "9·2/(4·16); it is near the ¼ that he takes instead",
                               [](double reading) { return reading == i_of<double>(1, 3, 2, 16); }};

const Emendation sixth{
    "§35, the angles m, n, n′, and the first fractions of (2) and of dω:dt",
    {"1/2", 1. / 2},
    {"1/6", 1. / 6},
    "ten degrees; and imn/5 is then 1/720",
    [](double reading) {
      return reading > 0 && reading * reading / 4 / 5 == within_ulps(Fifty(1) / 720, 3, "three roundings");
    }};

/*!
## Go on from here

::: exercise
Let Q hang at rest at first, $n' = 0$. Which tones has it by Euler, and which in truth, to the second order?
answer: By him none. In truth two of the same strength $F = \tfrac1{360}$, against each other, at μ and at 2λ;
so that it begins at rest and soon does not remain so.
:::
*/

CHECK_THAT("a pan at rest has by Euler no tones, complete two of 1/360")
{
  for(const Told& now : told_at("n1=0"))
  {
    const Fifty F = Fifty(1) / 360, right[]{0, -F, 0, F};
    const auto rows = now.rows("tones");
    for(std::size_t k{0}; k < 4; ++k)
    {
      CHECK(rows[k].value("theta_by_him") == within(0, 0, "nothing"));
      CHECK(rows[k].value("theta") == within(right[k], 1e-17, "one rounding"));
    }
  }
}
