#include "balance/euler.hpp"
#include "edition/section.hpp"
#include "exact/ode.hpp"

SECTION(balance, 18, "The other pan")

using namespace balance;

/*!
## What Euler does

The other pan needs no reckoning of its own: its equation is the first pan's with one sign changed. It is

$$ \frac{dd\vartheta}{\mu\mu\,dt^2} = -\vartheta
   - \frac{a\,\vartheta\,\mathfrak C\sin(\gamma+\lambda t)}{f{{entry lost_f}}}, \tag{1} $$

and differs from that of {{sec balance.17}} only in having $-a$ where $+a$ stood. So $a$ is to be replaced by
$-a$, and the constants $\mathfrak A$ and α (our copy has $a$ for α) by two others, $\mathfrak B$ and β,
since another pan has its own. The corrected angle is

$$ \begin{aligned} \vartheta = {}&\mathfrak B\sin(\beta+\mu t)\\
 &- \frac{\mu\mu a\mathfrak B\mathfrak C}{2\lambda(2\mu-\lambda)f}\\
 &\quad\times\cos\bigl(\beta-\gamma+(\mu-\lambda)t\bigr)\\
 &- \frac{\mu\mu a\mathfrak B\mathfrak C}{2\lambda(2\mu+\lambda)f}\\
 &\quad\times\cos\bigl(\beta+\gamma+(\mu+\lambda)t\bigr),
\end{aligned} \tag{2} $$

while the beam keeps $\omega = \mathfrak C\sin(\gamma+\lambda t)$.

::: margin
Today: η and ϑ obey one Mathieu equation, half a period of its coefficient apart.
:::

Why the sign? When the beam's end $A$ is accelerated upwards, $B$ is accelerated downwards. The string of P
is stretched and P seems heavier; that of Q is relieved. What quickens one pan slows the other. But half a
period of the beam later they have changed parts: $\sin(\gamma + \lambda t)$ has the other sign then. So to
replace $a$ by $-a$ is the same as to count the time from another moment. The two pans have the same fate,
only not at the same time:

$$ \begin{gathered} \vartheta\text{ with }(\beta,\gamma)\\
   {} = \eta\text{ with }(\alpha = \beta,\;\gamma + \pi). \end{gathered} \tag{A} $$

## The program

One function serves both pans, with a sign for the side; it is shown in {{sec balance.17}}.
*/

const auto lambda =
    real("lambda", 1, Unit{"1/s"}, closed(1e-20, 1e6), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, closed(1e-6, 1e6), "frequency of the pans, μ = √(2g/b)");
const auto a = real("a", 2, feet, scale, "half the beam");
const auto g = real("g", 18, feet, scale, "height fallen in the first second");
const auto B = angle("B", 1. / 6, closed(-90_deg, 90_deg), "amplitude 𝔅 of the pan Q");
const auto C = angle("C", 1. / 6, closed(-90_deg, 90_deg), "amplitude ℭ of the beam");
const auto beta = angle("beta", 90_deg, closed(-360_deg, 360_deg), "phase β of the pan Q");
const auto gamma = angle("gamma", 90_deg, closed(-360_deg, 360_deg), "phase γ of the beam");
const auto t = real("t", 1, seconds, closed(0, 1e6), "time");

State<> motion(double time)  // (2), and P let go with the same constants
{
  const double i = i_of<double>(lambda, mu, a, g);
  return general<double>(lambda, mu, i, {B, B, C, beta, beta, gamma}, time);
}

TELL
{
  const Fifty l = lambda.fifty(), u = mu.fifty(), i = i_of<Fifty>(l, u, a.fifty(), g.fifty());
  require(l != 2 * u, "lambda", "not 2 mu, where the slower tone is infinite");
  const Constants<Fifty> k{B.fifty(), B.fifty(), C.fifty(), beta.fifty(), beta.fifty(), gamma.fifty()};
  const Angles<Fifty> at = general(l, u, i, k, t.fifty()).at;  // as they are written
  tell("theta", double(at.theta), radians, "ϑ at the time t, (2)");
  tell("eta", double(at.eta), radians, "η of a pan P with the same constants");
  tell("omega", double(at.omega), radians, "ω");
}

TELL
{
  curve("strays", {"turn", "P", "Q"}, [](Curve& out) {
    const Fifty l = lambda.fifty(), u = mu.fifty(), i = i_of<Fifty>(l, u, a.fifty(), g.fifty());
    const Constants<Fifty> k{B.fifty(), B.fifty(), C.fifty(), beta.fifty(), beta.fifty(), gamma.fifty()};
    for(int j = 0; j <= 360; ++j)
    {
      const Fifty time = j * exact::pi() / 90 / l, own = B.fifty() * sin(beta.fifty() + u * time);
      const Angles<Fifty> at = general(l, u, i, k, time).at;
      out.put({j / 180., double(3600 * (at.eta - own)), double(3600 * (at.theta - own))});
    }
  });
}

/*!
::: figure balance-18
alt: Two wavy curves, each the mirror image of the other in the level axis.

What the formulae add to the regular swing of P and of Q, if both have the same constants, in sixtieths of
Euler's degree: the same with opposite signs.
:::

## Checks
*/

CHECK_THAT("ϑ is (2) as it stands, with f, and η is ϑ with −a for a")
{
  for(const Told& now :
      told_at("", "lambda=0.3 mu=5 a=0.7 g=16 B=-4 C=7 beta=20 gamma=-130 t=123.25", "lambda=1e-20 t=1e4",
              "lambda=5.999999999 t=11", "lambda=9 mu=2 a=3e40 g=1e40 gamma=10 t=0.3"))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty(), T = t.fifty(), f = 2 * g.fifty() / (l * l);
    const auto formula = [&](const Fifty& arm) {
      const Fifty half = u * u * arm * B.fifty() * C.fifty() / (2 * l * f);
      return B.fifty() * sin(beta.fifty() + u * T)
             - half / (2 * u - l) * cos(beta.fifty() - gamma.fifty() + (u - l) * T)
             - half / (2 * u + l) * cos(beta.fifty() + gamma.fifty() + (u + l) * T);
    };
    const char* const once = "one rounding";
    CHECK(now.value("theta", radians) == within_ulps(formula(a.fifty()), 1, once));
    CHECK(now.value("eta", radians) == within_ulps(formula(-a.fifty()), 1, once));
    CHECK(now.value("omega", radians) == within_ulps(C.fifty() * sin(gamma.fifty() + l * T), 1, once));
  }
}

CHECK_THAT("λ = 2μ is refused, and not what is next to it, even where a double does not tell them apart")
{
  for(const char* const infinite : {"lambda=6", "lambda=1 mu=0.5"})
    CHECK(refused_at(infinite));
  for(const char* const beside : {"lambda=5.99999999999999999", "lambda=6.00000000000000001"})
    CHECK(!refused_at(beside));
}

CHECK_THAT("(A): Q is P half a period of the beam away")
{
  const Constants<Fifty> one{0, Fifty(1) / 6, Fifty(1) / 7, 0, Fifty("0.3"), Fifty("1.1")},
      other{Fifty(1) / 6, 0, Fifty(1) / 7, Fifty("0.3"), 0, Fifty("1.1") + exact::pi()};
  for(const int time : {0, 1, 17})
    CHECK(general<Fifty>(1, 3, Fifty(1) / 4, one, time).at.theta
          == within(general<Fifty>(1, 3, Fifty(1) / 4, other, time).at.eta, 1e-45, "fifty digits"));
}

CHECK_THAT("(2) misses the solution of (1) by the square of the beam's angle: a tenth of that, a hundredth "
           "of this")
{
  const auto missed = [](const Fifty& beam) {
    const Constants<Fifty> k{0, 1, beam, 0, Fifty("0.4"), Fifty("1.3")};
    const State<Fifty> from = general<Fifty>(1, 3, Fifty(1) / 4, k, 0);
    const exact::RightSide right = [&](const Fifty& time, const exact::State& y) {  // (1): aμμ/f = ½
      return exact::State{y[1], -9 * y[0] - y[0] * beam * sin(Fifty("1.3") + time) / 2};
    };
    const Fifty theta = exact::solve(right, 0, {from.at.theta, from.rate.theta}, 2, Fifty("1e-24")).y[0];
    return abs(theta - general<Fifty>(1, 3, Fifty(1) / 4, k, 2).at.theta);
  };
  CHECK(missed(Fifty(1) / 100) / missed(Fifty(1) / 1000) == within(100, 1, "and a part of the next order"));
}

CHECK_THAT("the figure has the two side tones of (2), with opposite signs")
{
  for(const Told& now : told_at("", "lambda=5.99999999999999999"))  // every phase is 90°
    for(const auto& point : now.points("strays", 7))
    {
      const Fifty l = lambda.fifty(), u = mu.fifty(), time = Fifty(point.at("turn")) * exact::pi() * 2 / l;
      const Fifty size = 3600 * i_of(l, u, a.fifty(), g.fifty()) * B.fifty() * C.fifty();
      const Fifty lower = size / (2 * u - l), upper = size / (2 * u + l);
      const Fifty tones = lower * cos((u - l) * time) - upper * cos((u + l) * time);
      CHECK(point.value("P") == within(tones, 1e-14 * double(lower), "the moment is rounded"));
      CHECK(point.value("Q") == within(-tones, 1e-14 * double(lower), "the same"));
    }
}

/*!
In {{eq 1}} our copy has no $f$. Then the last term would be as many feet as $a$ has: two for one in
eighteen. And it exchanges $\mathfrak A$ and $a$, which has just been spoken of, where the constants of P are
meant.
*/

const Emendation lost_f{
    "§18, the last term of the equation",
    {"aϑℭ sin(γ + λt)", 2. / 1},
    {"aϑℭ sin(γ + λt) : f", 2. / 36},
    "it is the equation of §16, whose term aω/f is a number",
    [](double a_over_f) {  // a = 2, f = 2g/λλ = 36: A's acceleration, λλaω, in units of 2gω
      return a_over_f * 2 * 18 == within_ulps(1. * 1 * 2, 2, "a product");
    }};

/*!
## Go on from here

::: exercise
Where is the balance when, by these formulae, P and Q hang at the same angle although they have the same
constants?
answer: Where the two tones together vanish; in the example at
$7\cos2\lambda t = 5\cos4\lambda t$, that is at $\cos2\lambda t = \frac1{20}(7-\sqrt{249})$, for the first
time a little after λt = 58°. A check finds it.
:::
*/

CHECK_THAT("in the example the pans first meet a little after λt = 58°, where both tones together vanish")
{
  const double meeting = std::acos((7 - std::sqrt(249.)) / 20) / 2;
  const State<> now = motion(meeting);
  CHECK(now.at.theta == within(now.at.eta, 1e-15, "two roundings of angles below a sixth"));
  CHECK(meeting == between(58_deg, 58.1_deg, "in degrees"));
  for(int k = 0; k <= 57; ++k)
    CHECK(motion(k * 1_deg).at.theta < motion(k * 1_deg).at.eta);
}
