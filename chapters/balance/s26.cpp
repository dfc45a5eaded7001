#include "balance/euler.hpp"
#include "edition/section.hpp"

SECTION(balance, 26, "Case 1: pans at rest, the beam let go inclined")

using namespace balance;

/*!
## What Euler does

Of three ways in which a balance may be set going this is the first: both pans hang straight down and are at
rest, and the beam is let go at the inclination $m$. The general motion with a beam so released is that of
{{sec balance.25}}; it has four constants left, the amplitudes $\mathfrak A$ and $\mathfrak B$ of the two pans
and their phases α and β. The start has as many conditions: at $t = 0$ both $\eta$ and $\vartheta$ vanish, and
both $d\eta:dt$ and $d\vartheta:dt$. When $t = 0$ is put into the formulae, and each condition is divided by
$\mathfrak A$ or $\mathfrak B$, the last two also by $\mu$, they say {{entry quarter}}

$$ \begin{aligned}
\text{I.}&\quad 0 = \sin\alpha\\
 &\quad + \frac{\lambda\mu\mu am}{4g(2\mu-\lambda)}\sin\alpha\\
 &\quad - \frac{\lambda\mu\mu am}{4g(2\mu+\lambda)}\sin\alpha,\\
\text{II.}&\quad 0 = \sin\beta\\
 &\quad - \frac{\lambda\mu\mu am}{4g(2\mu-\lambda)}\sin\beta\\
 &\quad + \frac{\lambda\mu\mu am}{4g(2\mu+\lambda)}\sin\beta,\\
\text{III.}&\quad 0 = \cos\alpha\\
 &\quad + \frac{\lambda(\mu-\lambda)\mu am}{4g(2\mu-\lambda)}\cos\alpha\\
 &\quad - \frac{\lambda(\mu+\lambda)\mu am}{4g(2\mu+\lambda)}\cos\alpha,\\
\text{IV.}&\quad 0 = \cos\beta\\
 &\quad - \frac{\lambda(\mu-\lambda)\mu am}{4g(2\mu-\lambda)}\cos\beta\\
 &\quad + \frac{\lambda(\mu+\lambda)\mu am}{4g(2\mu+\lambda)}\cos\beta.
\end{aligned} \tag{1} $$

Each pair of fractions can be drawn together, since

$$ \begin{aligned}
   \frac1{2\mu-\lambda} - \frac1{2\mu+\lambda} &= \frac{2\lambda}{4\mu\mu-\lambda\lambda},\\
   \frac{\mu-\lambda}{2\mu-\lambda} - \frac{\mu+\lambda}{2\mu+\lambda}
     &= \frac{-2\lambda\mu}{4\mu\mu-\lambda\lambda}. \end{aligned} \tag{2} $$

So one and the same fraction {{entry four_squares}} stands in all four, with alternating signs:

$$ \begin{aligned}
\text{I.}&\quad 0 = \sin\alpha\,(1 + K),\\ \text{II.}&\quad 0 = \sin\beta\,(1 - K),\\
\text{III.}&\quad 0 = \cos\alpha\,(1 - K),\\ \text{IV.}&\quad 0 = \cos\beta\,(1 + K),\\
K &= \frac{\lambda\lambda\mu\mu am}{2g(4\mu\mu-\lambda\lambda)}. \end{aligned} \tag{3} $$

::: margin
Today: the pan's place and speed at $t = 0$ are linear in $\mathfrak A\sin\alpha$ and $\mathfrak A\cos\alpha$;
{{eq 3}} is that map, already diagonal.
:::

It seems, he says, that they can be met in several ways; the next section runs through some of them. The
letter $K$ is ours; he writes the fraction out each time.

## The program

What is left of the four conditions for any phases, as {{eq 1}} has them and as {{eq 3}} does.

::: code balance/euler.hpp K (3)
:::
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, scale, "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, scale, "frequency of the pans, μ = √(2g/b)");
const auto a = real("a", 16. / 9, feet, scale, "half the beam");
const auto g = real("g", 16, feet, scale, "height fallen in the first second");
const auto m = angle("m", 1. / 6, closed(-90_deg, 90_deg), "inclination of the beam at the start");
const auto alpha = angle("alpha", 30_deg, closed(-180_deg, 180_deg), "phase of the pan P");
const auto beta = angle("beta", 60_deg, closed(-180_deg, 180_deg), "phase of the pan Q");

/*!
What is typed is computed with as it is typed, in fifty digits: where λ is near $2\mu$, the rounding of λ to a
double alone would change K in every digit.
*/

template <class Number>
Number half_of(int side, const Number& l, const Number& u, const Number& a_, const Number& g_,
               const Number& m_)
{  // a fraction of (1) in I and II: its divisor has 2μ − λ for side −1, 2μ + λ for side 1
  return l * u * u * a_ * m_ / (4 * g_ * (2 * u + side * l));
}

template <class Number>
std::array<Number, 4> conditions(const Number& lower, const Number& upper, const Number& l, const Number& u,
                                 const Number& al, const Number& be)  // (1)
{
  using std::cos;
  using std::sin;
  const Number value = lower - upper, rate = lower * (u - l) / u - upper * (u + l) / u;
  return {sin(al) * (1 + value), sin(be) * (1 - value), cos(al) * (1 + rate), cos(be) * (1 - rate)};
}

Fifty K()
{
  return K_of<Fifty>(lambda.fifty(), mu.fifty(), a.fifty(), g.fifty(), m.fifty());
}

TELL
{
  require(lambda.fifty() != 2 * mu.fifty(), "lambda", "not 2 mu, where K is infinite");
  const Fifty l = lambda.fifty(), u = mu.fifty();
  const Fifty lower = half_of(-1, l, u, a.fifty(), g.fifty(), m.fifty()),
              upper = half_of(1, l, u, a.fifty(), g.fifty(), m.fifty());
  require(abs(lower) < 1e300, "lambda", "such that the tone μ − λ is below 1e300");
  const auto left = conditions(lower, upper, l, u, alpha.fifty(), beta.fifty());
  tell("lower", double(lower), "λμμam/4g(2μ−λ), the tone μ − λ against the pan's own");
  tell("upper", double(upper), "λμμam/4g(2μ+λ), the tone μ + λ");
  tell("K", double(K()), "K");
  tell("one_plus", double(1 + K()), "1 + K");
  tell("one_minus", double(1 - K()), "1 − K");
  tell("I", double(left[0]), "what condition I leaves at the phases given, where it should be 0");
  tell("II", double(left[1]), "condition II");
  tell("III", double(left[2]), "condition III");
  tell("IV", double(left[3]), "condition IV");
}

double K_by_ratio(double r)  // K:(am/b), r = λ/μ
{
  return r * r / ((2 - r) * (2 + r));
}

TELL
{
  auto& rows = table("ratios", "K against am:b, for a beam slower or faster than the pans",
                     {{"r", "λ/μ"}, {"K", "K : (am/b)"}});
  for(const double r : {0.1, 1. / 3, 1., 1.5, 1.9, 1.99})
    rows.row({r, K_by_ratio(r)});
  curve("slower", {"r", "K"}, [](Curve& out) {
    for(int j = 0; j < 200; ++j)
      out.put({j / 100., K_by_ratio(j / 100.)});
  });
  curve("faster", {"r", "K"}, [](Curve& out) {
    for(int j = 201; j <= 400; ++j)
      out.put({j / 100., K_by_ratio(j / 100.)});
  });
}

/*!
In Euler's example K is {{K|4}}: the pan's two side tones, of {{lower|4}} and {{upper|4}} of its own, nearly
cancel at the start. At the phases {{alpha}} and {{beta}} the four conditions leave {{I|4}}, {{II|4}},
{{III|4}}, {{IV|4}}.

{{table ratios}}

::: figure balance-26
alt: K in units of a m over b against the ratio of the two frequencies. From zero it rises slowly, steeply
near two, where it has a pole; beyond it comes from below and tends to minus one.

$K$ in units of $am:b$, which is a small number. It is smaller yet where the beam is the slower, as Euler
supposes; the point is his example. Only near $\lambda = 2\mu$ can $K$ be of any size.
:::

## Speed against error

The first form of the fraction, {{eq 1}}, subtracts what is nearly equal when the beam is slow; the other does
not. Both forms of $4\mu\mu - \lambda\lambda$ are good enough here; near $\lambda = 2\mu$ only the product is.
*/

TELL
{
  if(m == 0 || lambda == 2 * mu)  // no relative error; nothing that doubles could tell
    return;
  race("of_K", "K", K(),
       {{"two fractions, (1)",
         [] { return half_of<double>(-1, lambda, mu, a, g, m) - half_of<double>(1, lambda, mu, a, g, m); }},
        {"4μμ − λλ, (3)",
         [] { return lambda * lambda * mu * mu * a * m / (2 * g * (4 * mu * mu - lambda * lambda)); }},
        {"(2μ − λ)(2μ + λ)", [] { return K_of<double>(lambda, mu, a, g, m); }},
        {"carried in two doubles", [] { return factors(lambda, mu, a, g, m).K; }}});
}

/*!
## Checks
*/

CHECK_THAT("(2) holds in fractions, so that (1) and (3) are the same conditions")
{
  for(const Rational& l : {Rational(1), Rational(7, 5), Rational(9)})
    for(const Rational& u : {Rational(3), Rational(22, 7)})
    {
      const Rational less = 2 * u - l, more = 2 * u + l;
      CHECK(1 / less - 1 / more == 2 * l / (4 * u * u - l * l));
      CHECK((u - l) / less - (u + l) / more == -2 * l * u / (4 * u * u - l * l));
    }
}

Fifty fifty_K()  // by the difference of the two fractions
{
  const Fifty l = lambda.fifty(), u = mu.fifty();
  return l * u * u * a.fifty() * m.fifty() / (4 * g.fifty()) * (1 / (2 * u - l) - 1 / (2 * u + l));
}

CHECK_THAT(
    "what is told is what the general solution of § 20 starts with, also beside the pole and for a beam "
    "a thousand million times slower than the pans")
{
  const char* const because = "one rounding";
  for(const Told& now : told_at("", "lambda=1e-9 m=-20 alpha=170", "lambda=5.9999999994 mu=3 beta=-5",
                                "mu=0.3 lambda=7 a=1e20 g=1e19", "lambda=6.0000000006 m=0.01"))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty(), i = i_of<Fifty>(l, u, a.fifty(), g.fifty());
    // an amplitude of 1 for each pan, the beam farthest out
    const Constants<Fifty> k{1, 1, m.fifty(), alpha.fifty(), beta.fifty(), exact::pi() / 2};
    const State<Fifty> start = general<Fifty>(l, u, i, k, 0);
    const Fifty K_ = fifty_K();
    CHECK(now.value("K") == within_ulps(K_, 0.5, because));
    CHECK(now.value("one_plus") == within_ulps(1 + K_, 0.5, because));
    CHECK(now.value("one_minus") == within_ulps(1 - K_, 0.5, because));
    const auto [M, N] = sidebands<Fifty>(l, u, i, 1, m.fifty());
    CHECK(now.value("lower") == within_ulps(M / 2, 0.5, because));
    CHECK(now.value("upper") == within_ulps(N / 2, 0.5, because));
    CHECK(now.value("I") == within_relative(start.at.eta, 2e-16, because));
    CHECK(now.value("II") == within_relative(start.at.theta, 2e-16, because));
    CHECK(now.value("III") == within_relative(start.rate.eta / u, 2e-16, because));
    CHECK(now.value("IV") == within_relative(start.rate.theta / u, 2e-16, because));
    CHECK(now.exact("of_K") == within_relative(K_, 1e-38, "a difference of fractions in fifty digits"));
  }
}

CHECK_THAT("λ = 2μ is refused, and not what no double tells from it, nor K = 0; so is a tone of 1e300, and "
           "not a little less")
{
  for(const char* const no :
      {"lambda=6", "lambda=1 mu=0.5", "lambda=1.000000000000001e51 mu=1e51 a=1e100 g=1e-99 m=0.4rad"})
    CHECK(refused_at(no));
  for(const char* const yes : {"lambda=5.99999999999999999", "lambda=6.00000000000000001", "lambda=6 mu=4",
                               "m=0", "lambda=9.99999999999999e50 mu=1e51 a=1e100 g=1e-99 m=0.4rad"})
    CHECK(!refused_at(yes));
}

CHECK_THAT("two fractions lose as many digits as the beam is slow; the product loses none")
{
  for(const Told& now : told_at("", "lambda=1e-9 m=-20", "mu=0.3 lambda=7 a=1e20 g=1e19"))
  {
    const Fifty K_ = fifty_K();
    const double slow = std::max(1., mu / lambda) * std::max(1., lambda / mu);
    CHECK(now.method("of_K", "two fractions, (1)")
          == within_relative(K_, 1e-15 * slow, "each rounds, and they nearly cancel"));
    CHECK(now.method("of_K", "4μμ − λλ, (3)") == within_relative(K_, 2e-15, "a dozen roundings"));
    CHECK(now.method("of_K", "(2μ − λ)(2μ + λ)") == within_relative(K_, 2e-15, "a dozen roundings"));
    CHECK(now.method("of_K", "carried in two doubles")
          == within_relative(K_, 1e-15, "the parameters' own"));
  }
}

CHECK_THAT("K : (am/b) is r²/(4 − r²), in the table and in the figure")
{
  for(const Told& now : told_at(""))
  {
    for(const auto& row : now.rows("ratios"))
    {
      const Fifty r = row.at("r");
      CHECK(row.value("K") == within_ulps(1 / (2 - r) + 1 / (2 + r) - 1, 64, "2 − r is exact"));
    }
    for(const char* side : {"slower", "faster"})
      for(const auto& point : now.points(side, 7))
      {
        const Fifty r = point.at("r");
        CHECK(point.value("K")
              == within_ulps(4 / (4 - r * r) - 1, 64, "2 − r loses five bits at the most"));
      }
  }
  CHECK(K_by_ratio(1. / 3) == within_ulps(Fifty(1) / 35, 3, "a third is rounded"));
}

/*!
Under all eight fractions of the first form our copy has $g$ for $4g$; and in the second form, here and in
{{sec balance.27}}, a + where the 4 of $4\mu\mu$ should stand. Both are settled by what the pan of
{{sec balance.25}} starts with.
*/

bool starts_with(double reading)  // K of the example
{
  const State<> start = general<double>(1, 3, 0.25, {1, 1, 1. / 6, 90_deg, 90_deg, 90_deg}, 0);
  return reading == within_relative(start.at.eta - 1, 1e-12, "a difference from 1 of 1/420");
}

double K_with(double times_g, double times_mu2)
{
  return 9 * 16. / 9 / 6 / (2 * 16 * times_g * (times_mu2 * 9 - 1));
}

const Emendation quarter{"§26, the divisors of I to IV",
                         {"g(2μ ∓ λ)", [] { return K_with(0.25, 4); }},
                         {"4g(2μ ∓ λ)", [] { return K_with(1, 4); }},
                         "§25 has 4g, and both pans start with it",
                         starts_with};

const Emendation four_squares{"§26 and §27, the divisor of the simplified fraction",
                              {"2g(+μμ − λλ)", [] { return K_with(1, 1); }},
                              {"2g(4μμ − λλ)", [] { return K_with(1, 4); }},
                              "it is the product of 2μ − λ and 2μ + λ",
                              starts_with};
