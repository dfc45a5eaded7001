#include "balance/euler.hpp"
#include "balance/mathieu.hpp"
#include "edition/section.hpp"
#include "exact/ode.hpp"

SECTION(balance, 17, "The side tones of a pan")

using namespace balance;

/*!
## What Euler does

To the regular swing of the pan P Euler adds a small correction $p$, and finds that it is made of two further
swings, one a little slower and one a little faster than the pan's own. He supposes that truly

$$ \eta = \mathfrak A\sin(\alpha+\mu t) + p \tag{1} $$

and puts this into the equation of {{sec balance.16}}. The main parts cancel. In the product of the pan's
angle and the beam's he leaves $p$ out, for that would be smaller by one more order, and so gets

$$ \begin{aligned} \frac{ddp}{\mu\mu\,dt^2} = -p &+ \frac{a\mathfrak A\mathfrak C{{entry lost_amplitude}}}f
  \sin(\alpha+\mu t)\\ &\qquad\times\sin(\gamma+\lambda t). \end{aligned} \tag{2} $$

The product of the two sines is half the cosine of their difference less half the cosine of their sum. So he
tries

$$ \begin{aligned} p = {}&\tfrac12M\cos\bigl(\alpha-\gamma+(\mu-\lambda)t\bigr)\\
     &+ \tfrac12N\cos\bigl(\alpha+\gamma+(\mu+\lambda)t\bigr), \end{aligned} \tag{3} $$

where $M$ is not the weight of the beam. Each of the two cosines must satisfy the equation by itself:

$$ \begin{aligned} 0 &= \frac{M(\mu-\lambda)^2}{2\mu\mu} - \tfrac12M + \frac{a\mathfrak A\mathfrak C}{2f},\\
   0 &= \frac{N(\mu+\lambda)^2}{2\mu\mu} - \tfrac12N - \frac{a\mathfrak A\mathfrak C}{2f}.
\end{aligned} \tag{4} $$

Since $\mu\mu - (\mu\mp\lambda)^2 = \pm\lambda(2\mu\mp\lambda)$, there follow

$$ \begin{gathered} M = \frac{\mu\mu a\mathfrak A\mathfrak C}{\lambda(2\mu-\lambda)f},\\
   N = \frac{\mu\mu a\mathfrak A\mathfrak C}{\lambda(2\mu+\lambda)f},
\end{gathered} \tag{5} $$

and η is {{eq 1}} with this $p$.

::: margin
Today: first-order perturbation; the lines $\mu\pm\lambda$ are the side bands of an oscillator whose
stiffness is modulated at λ.
:::

In {{eq 5}} three letters hide a simple thing. As $\lambda\lambda f = \mu\mu b = 2g$,

$$ \begin{gathered} M = \frac ab\,\mathfrak A\mathfrak C\,\frac\lambda{2\mu-\lambda},\\
   N = \frac ab\,\mathfrak A\mathfrak C\,\frac\lambda{2\mu+\lambda}.
\end{gathered} \tag{A} $$

Both are as small as the beam is slow. The slower tone is always the stronger, and at $\lambda = 2\mu$ it has
no bound: the beam then pulls twice in every period of the pan, as a child works a playground swing.

## The program

The formulae use $i = \lambda\mu\mu a/4g$, which Euler introduces in {{sec balance.33}}; with it nothing is
lost when λ vanishes and $f$ is infinite.

::: code balance/euler.hpp general (1) (3) (5)
:::
*/

const auto lambda =
    real("lambda", 1, Unit{"1/s"}, closed(1e-100, 1e6), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, closed(1e-6, 1e6), "frequency of the pans, μ = √(2g/b)");
const auto a = real("a", 2, feet, scale, "half the beam");
const auto g = real("g", 18, feet, scale, "height fallen in the first second");
const auto A = angle("A", 1. / 6, closed(-90_deg, 90_deg), "amplitude 𝔄 of the pan P");
const auto C = angle("C", 1. / 6, closed(-90_deg, 90_deg), "amplitude ℭ of the beam");
const auto alpha = angle("alpha", 90_deg, closed(-360_deg, 360_deg), "phase α of the pan P");
const auto gamma = angle("gamma", 90_deg, closed(-360_deg, 360_deg), "phase γ of the beam");
const auto t = real("t", 1, seconds, closed(0, 1e6), "time");

double i()
{
  return i_of<double>(lambda, mu, a, g);
}

/*!
What is told is computed from the numbers as they are written, in fifty digits: where λ is near $2\mu$, the
rounding of λ to a double alone would change $M$ in every digit.
*/

TELL
{
  const Fifty l = lambda.fifty(), u = mu.fifty(), i_ = i_of<Fifty>(l, u, a.fifty(), g.fifty());
  require(l != 2 * u, "lambda", "not 2 mu, where M is infinite");
  const auto [M, N] = sidebands<Fifty>(l, u, i_, A.fifty(), C.fifty());
  const Constants<Fifty> k{A.fifty(), 0, C.fifty(), alpha.fifty(), 0, gamma.fifty()};
  tell("M", double(M), radians, "twice the amplitude of the slower tone, (5)");
  tell("N", double(N), radians, "twice that of the faster one");
  tell("slower", double(u - l), Unit{"1/s"}, "frequency of the slower tone; negative: its phase runs back");
  tell("faster", double(u + l), Unit{"1/s"}, "frequency of the faster tone");
  tell("eta", double(general(l, u, i_, k, t.fifty()).at.eta), radians, "η at the time t");
}

/*!
How long does the formula hold? Beside it stands the pan that swings by the equation itself, under the same
beam: {{api balance::pan_under}} solves it to rounding, whatever the time. Both are let go at the same angle
and at rest, for which the formula needs the amplitude $n/(1+K)$ with $K = \tfrac12(M-N):\mathfrak A$
({{sec balance.30}}).
*/

constexpr int moments = 200;  // out of step with beam and pan

double most_missed(double until)  // in the last fifth before that time, for a release of the size 1
{
  const double p = 2 * i() / lambda * C;
  const Release from{lambda, mu, i(), {C, 1, 0}, 0};
  double most = 0;
  for(int k = 0; k < moments; ++k)
  {
    const double time = late_moment(k, moments, until);
    const double his = euler_corrected(from, time).eta;
    most = std::max(most, std::abs(his - pan_under({mu, lambda, p}, {1, 0}, time).y));
  }
  return most;
}

const auto easy = [] {  // an equation that one second does for, and nowhere near a pole
  return lambda >= 0.1 * mu && lambda <= 1.5 * mu && 2 * i() / lambda * std::abs(C) <= 0.2;
};

TELL
{
  if(easy())
  {
    auto& rows =
        table("missed", "What the formula misses of the equation's own solution, as part of the excursion",
              {{"swings", "swings of the pan"}, {"most", "at most", percent, 3}});
    for(const double swings : {10., 100., 1000.})
      rows.row({swings, most_missed(swings * std::numbers::pi / mu)});
  }
}

TELL
{
  curve("tones", {"ratio", "M", "N"}, [](Curve& out) {
    for(int k = 0; k <= 400; ++k)
      if(const double r = 0.01 * k; k != 200)
        out.put({r, r / (2 - r), r / (2 + r)});
  });
}

/*!
{{table missed}}

The table compares the formula with the equation followed step by step. For ten swings it is right to two
parts in ten thousand. Then ten times the time brings ten times the fault: the formula's clock goes by μ, and
the pan's by a mean frequency that differs from it ({{sec balance.15}}).

::: figure balance-17
alt: M and N over the product of the amplitudes and a over b, against the ratio of the frequencies. Both
start at zero; N rises slowly to two thirds at 4, M rises steeply to infinity at 2 and comes back from below.

The strength of the two tones, $M$ and $N$ in units of $\mathfrak A\mathfrak Ca/b$. Euler's example has
$\lambda = \tfrac13\mu$; he takes λ to be much smaller still.
:::

## Checks
*/

CHECK_THAT("M, N and η are (5), (1) and (3) as Euler writes them, with his f, in fifty digits")
{
  for(const Told& now : told_at("", "lambda=0.02 mu=5 a=0.7 g=16 A=3 C=-7 alpha=20 gamma=-130 t=1234.5",
                                "lambda=1.9999999 mu=1 A=1e-9 t=7", "lambda=1e-100 t=1e5",
                                "lambda=9 mu=2 a=3e40 g=1e40 gamma=10 t=0.3"))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty(), f = 2 * g.fifty() / (l * l);
    const Fifty strength = u * u * a.fifty() * A.fifty() * C.fifty() / (l * f);
    const Fifty M = strength / (2 * u - l), N = strength / (2 * u + l), T = t.fifty();
    const char* const once = "one rounding";
    CHECK(now.value("M", radians) == within_ulps(M, 1, once));
    CHECK(now.value("N", radians) == within_ulps(N, 1, once));
    CHECK(now.value("slower", Unit{"1/s"}) == within_ulps(u - l, 1, once));
    CHECK(now.value("faster", Unit{"1/s"}) == within_ulps(u + l, 1, once));
    const Fifty eta = A.fifty() * sin(alpha.fifty() + u * T)
                      + M / 2 * cos(alpha.fifty() - gamma.fifty() + (u - l) * T)
                      + N / 2 * cos(alpha.fifty() + gamma.fifty() + (u + l) * T);
    CHECK(now.value("eta", radians) == within_ulps(eta, 1, once));
  }
}

CHECK_THAT("λ = 2μ is refused, and not what is next to it, even where a double does not tell them apart")
{
  for(const char* const infinite : {"lambda=6", "lambda=1 mu=0.5"})
    CHECK(refused_at(infinite));
  for(const char* const beside : {"lambda=5.99999999999999999", "lambda=6.00000000000000001"})
    CHECK(!refused_at(beside));
}

CHECK_THAT("p solves (2): integrated to thirty digits from its own start it arrives at its own end")
{
  for(const Told& now : told_at("", "lambda=2.5 mu=1.1 a=1 g=16 alpha=20 gamma=-130 t=4"))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty(), depth = a.fifty() * l * l / (2 * g.fifty());
    const Fifty fac = A.fifty() * C.fifty() * depth;
    const State<Fifty> at_0 = general<Fifty>(l, u, i_of(l, u, a.fifty(), g.fifty()),
                                             {A.fifty(), 0, C.fifty(), alpha.fifty(), 0, gamma.fifty()}, 0);
    const exact::RightSide right = [&](const Fifty& time, const exact::State& y) {
      const Fifty product = sin(alpha.fifty() + u * time) * sin(gamma.fifty() + l * time);
      return exact::State{y[1], u * u * (fac * product - y[0])};
    };
    const exact::State from{at_0.at.eta - A.fifty() * sin(alpha.fifty()),
                            at_0.rate.eta - A.fifty() * u * cos(alpha.fifty())};
    const Fifty p = exact::solve(right, 0, from, t.fifty(), Fifty("1e-24")).y[0];
    CHECK(now.value("eta", radians)
          == within(p + A.fifty() * sin(alpha.fifty() + u * t.fifty()), 1e-15, "few roundings"));
  }
}

double by_steps(
    double until)  // most_missed() by the classical rule with 400 steps a radian of the pan's phase
{
  const double p = 2 * i() / lambda * C, K = i() * C * (1 / (2 * mu - lambda) - 1 / (2 * mu + lambda));
  const auto pull = [&](double time, double y) {
    return -(mu * mu - p * lambda * lambda * std::cos(lambda * time)) * y;
  };
  double y = 1, v = 0, now = 0, most = 0;
  for(int k = 0; k < moments; ++k)
  {
    const double from = now, to = late_moment(k, moments, until);
    const int steps = static_cast<int>(std::ceil((to - from) * mu * 400));
    const double h = (to - from) / steps;
    for(int step = 0; step < steps; ++step, now = from + step * h)
    {
      const double k1 = pull(now, y), k2 = pull(now + h / 2, y + h / 2 * v);
      const double k3 = pull(now + h / 2, y + h / 2 * (v + h / 2 * k1)),
                   k4 = pull(now + h, y + h * (v + h / 2 * k2));
      y += h * (v + h / 6 * (k1 + k2 + k3));
      v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    now = to;
    const double strays = i() * C
                          * (std::cos((mu - lambda) * to) / (2 * mu - lambda)
                             - std::cos((mu + lambda) * to) / (2 * mu + lambda));
    most = std::max(most, std::abs((std::cos(mu * to) + strays) / (1 + K) - y));
  }
  return most;
}

CHECK_THAT("what the formula misses in the table is what the classical rule of four stages finds")
{
  for(const Told& now : told_at("", "lambda=1.3 mu=2 C=4", "lambda=0.7 mu=1 a=1 C=10"))
    for(const auto& row : now.rows("missed"))
    {
      const double swings = row.at("swings");
      CHECK(row.value("most", percent)
            == within(by_steps(swings * std::numbers::pi / mu), 1e-9 * swings, "the rule's fourth order"));
      CHECK(row.value("swings") == between(10, 1000, "the rows' own numbers"));
    }
}

CHECK_THAT("what is missing grows with the time, by as much as the mean frequency differs from μ")
{
  for(const Told& now : told_at("", "lambda=1.3 mu=2 C=4"))
  {
    const double shift = std::abs(floquet({mu, lambda, 2 * i() / lambda * C}).shift);
    const auto rows = now.rows("missed");
    const double late = shift * 1000 * std::numbers::pi / mu;
    CHECK(rows[2].at("most", percent)
          == within_relative(late, 0.05, "the side tones' own errors beside it"));
    CHECK(rows[2].at("most", percent) / rows[1].at("most", percent)
          == between(9, 11, "ten times the time"));
  }
  for(const Told& now : told_at(""))
    CHECK(now.rows("missed")[0].at("most", percent) == between(1e-5, 2.5e-4, "two parts in ten thousand"));
}

CHECK_THAT("the figure's two curves solve (4), also beyond the pole")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("tones", 9))
    {
      const Fifty r = point.at("ratio"), own = r * r / 2;  // a𝔄ℭ/2f over 𝔄ℭa/b
      const Fifty slow = (1 - r) * (1 - r) - 1, fast = (1 + r) * (1 + r) - 1;
      if(r > 0)
        CHECK(point.value("M") == within_relative(-2 * own / slow, 1e-14, "a difference near the pole"));
      if(r > 0)
        CHECK(point.value("N") == within_relative(2 * own / fast, 1e-15, "few roundings"));
    }
}

/*!
Our copy has lost 𝔄 in {{eq 2}} and in {{eq 4}}, not in {{eq 5}}. In the example the slower tone would be six
times as strong.
*/

const Emendation lost_amplitude{
    "§17, the last term of the equation for p, and of both equations for M and N",
    {"aℭ/f", 1. / 60},
    {"a𝔄ℭ/f", 1. / 360},
    "the product of the two sines comes with 𝔄, and so does the result",
    [](double M) {  // (4) at λ = 1, μ = 3, a/f = 1/18, 𝔄 = ℭ = 1/6
      return M * 4 / 18 + 1. / 36 / 18 / 2 == within_ulps(M / 2, 4, "three roundings");
    }};

/*!
## Notes

What Euler leaves out by taking $p$ away from the product is of the third order and rightly left out. What was
already missing in the equation is not: {{sec balance.13}}.

## Go on from here

::: exercise
At which λ is the slower tone three times as strong as the faster one?
answer: At $\lambda = \mu$, by
{{eq A}}: run with `--lambda 3`, and compare $M$ and $N$. The slower tone is then no swing at all, but a
constant lean of the string.
:::
*/

CHECK_THAT("at λ = μ the slower tone stands still and is three times the faster")
{
  for(const Told& now : told_at("lambda=3"))
  {
    CHECK(now.value("slower", Unit{"1/s"}) == within(0, 0, "equal numbers"));
    CHECK(now.value("N", radians) == within_relative(Fifty(1) / 216, 1e-15, "a third of it"));
    CHECK(now.value("M", radians) == within_relative(Fifty(1) / 72, 1e-15, "half of 1/36, a/b being ½"));
  }
}
