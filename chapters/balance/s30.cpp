#include "balance/euler.hpp"
#include "balance/motion.hpp"
#include "edition/section.hpp"

#include <complex>

SECTION(balance, 30, "Case 2: three oscillations in one")

using namespace balance;

/*!
## What Euler does

What the pan P does, let go from $n$ with a beam at $m$, is settled by two conditions of {{sec balance.29}}.
The third, $0=\cos\alpha\,(1-K)$, cannot be met unless

$$ \cos\alpha = 0, \quad\text{that is}\quad \alpha = 90°, \tag{1} $$

because the second part is as good as infinitely small against the first. Then the first condition gives

$$ n = \mathfrak A + \frac{\lambda\lambda\mu\mu a\,\mathfrak Am}{2g(4\mu\mu-\lambda\lambda)}, \tag{2} $$

and from it $\mathfrak A$, which is very nearly $n$ {{entry value_n}}. So the motion of the pan is, the sines
of $90°+x$ being cosines,

$$ \begin{aligned} \eta = {}&n\cos\mu t\\
 &+ \frac{\lambda\mu\mu amn}{4g(2\mu-\lambda)}\cos(\mu-\lambda)t\\
   &- \frac{\lambda\mu\mu amn}{4g(2\mu+\lambda)}\cos(\mu+\lambda)t, \end{aligned} \tag{3} $$

$$ \begin{aligned} \frac{d\eta}{dt} = {}&{-\mu n}\sin\mu t\\
   &- \frac{\lambda(\mu-\lambda)\mu\mu amn}{4g(2\mu-\lambda)}\\ &\quad\times\sin(\mu-\lambda)t\\
   &+ \frac{\lambda(\mu+\lambda)\mu\mu amn}{4g(2\mu+\lambda)}\\
 &\quad\times\sin(\mu+\lambda)t. {{entry last_member}}
   \end{aligned} \tag{4} $$

The motion of this pan is then no longer regular, and departs from that of a simple pendulum by the more, the
greater the coefficients of the last two terms. By Bernoulli's principle, Euler says, this disturbed motion
can be represented as a mixture of oscillations of three kinds, of which one swing takes the times

$$ \frac\pi\mu, \qquad \frac\pi{\mu-\lambda}, \qquad \frac\pi{\mu+\lambda}; \tag{5} $$

and the mixture arises from the swinging of the beam.

::: margin
Today: a line spectrum. Beyond the second order there are more lines, at sums $j\mu + k\lambda$.
:::

It is a statement that can be put to the test: take the motion by the full equations apart into its
oscillations, and see which are there. The three are there. A fourth is too, which he could not find, because
its cause has been dropped ({{sec balance.28}}): one at $2\lambda$, of the amplitude

$$ F = \frac ab\,\frac{\lambda\lambda mm}{\mu\mu-4\lambda\lambda}, \tag{A} $$

which does not depend on $n$ and so outweighs all others when the pan swings little. And the pan's own tone
is not $n$. All must add up to $n$ at the start, so that to the second order it is

$$ n\,(1-K)+F, \tag{B} $$

$K$ being what the two side tones leave of each other at $t=0$. Formula (3) with $n$ starts at $n(1+K)$; with
$\mathfrak A = n:(1+K)$, as (2) has it exactly, it would start at $n$, but its side tones be altered without
need.

## The program

The motion by the full equations is weighed with a window over 16 swings of the beam to and fro, and taken
apart by Fourier's integral. To keep the lines apart μ is 5 and not 3, where two of them would coincide; and
the pans are light, so that hardly any of the swing is handed on to Q meanwhile.
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, closed(0.2, 5), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 5, Unit{"1/s"}, closed(1, 40), "frequency of the pans, μ = √(2g/b)");
const auto beta = real("beta", 0.5, none, closed(0.01, 1), "a/b, arm to string");
const auto rho = real("rho", 0.01, none, closed(0, 0.4), "share of one pan in the whole inertia");
const auto m = angle("m", 1. / 6, closed(0.1_deg, 15_deg), "inclination of the beam at the start");
const auto n = angle("n", 1. / 12, closed(0.1_deg, 15_deg), "inclination of the pan P");
const auto t = real("t", 1, seconds, closed(0, 1e6), "time");

Balance<> given()
{
  return {lambda * lambda, mu * mu, beta, rho};
}

Release release()
{
  return {lambda, mu, beta * lambda / 2, {m, n, 0}, rho};
}

ReleaseOf<Fifty> as_written()
{
  const Fifty l = lambda.fifty();
  return {l, mu.fifty(), beta.fifty() * l / 2, {m.fifty(), n.fifty(), 0}, rho.fifty()};
}

double length()  // of the window
{
  return 32 * std::numbers::pi / lambda;
}

double window(double part)  // Blackman's and Harris's, from 0 to 1
{
  const auto c = [part](int k) { return elementary::cos(2 * std::numbers::pi * k * part); };
  return 0.35875 - 0.48829 * c(1) + 0.14128 * c(2) - 0.01168 * c(3);
}

std::vector<double> swings()  // η at equal steps
{
  const int many = static_cast<int>(16 * 16 * (mu / lambda + 4));
  std::vector<double> all;
  for(const State<>& now : course(given(), released(m, n, 0), length(), many))
    all.push_back(now.at.eta);
  return all;
}

double line(const std::vector<double>& eta, double frequency)  // its amplitude
{
  std::complex<double> sum = 0;
  const double parts = static_cast<double>(eta.size() - 1);
  double weights = 0;
  for(std::size_t k{0}; k < eta.size(); ++k)
  {
    const double part = static_cast<double>(k) / parts;
    const auto [s, c] = elementary::sincos(frequency * length() * part);
    sum += window(part) * eta[k] * std::complex<double>(c, s);
    weights += window(part);
  }
  return 2 * std::abs(sum) / weights;
}

TELL
{
  const double square = mu / lambda * (mu / lambda);
  require(std::abs(square - 4) >= 1, "mu", "such that μμ differs from 4λλ by λλ or more");
  require(10 * mu >= 13 * lambda, "mu", "at least 1.3 lambda");  // 13, 3: exact, as 1.3 and 0.3 are not
  require(mu <= 20 * lambda, "mu", "at most 20 lambda");
  require(std::abs(10 * mu - 30 * lambda) >= 3 * lambda, "mu",
          "such that mu - lambda and 2 lambda are 0.3 lambda apart");
  const Release r = release();
  const double K = K_of(r);
  tell("K", K, "K");
  tell("A", n / (1 + K), degrees, "𝔄 by (2)");
  tell("start", euler_start(r).eta, degrees, "where (3) starts");
  tell("own", std::numbers::pi / mu, seconds, "one swing of the first kind, (5)");
  tell("slower", std::numbers::pi / (mu - lambda), seconds, "of the second");
  tell("faster", std::numbers::pi / (mu + lambda), seconds, "of the third");
  tell("eta", double(euler(as_written(), t.fifty()).eta), degrees, "η at the time t, (3)");
  tell("rate", double(euler_rates(as_written(), t.fifty()).eta), Unit{"1/s"}, "dη:dt, (4)");
}

TELL
{
  const Release r = release();
  const double half = r.i * m * n, lower = half / (2 * mu - lambda), upper = half / (2 * mu + lambda);
  const double F = beta * lambda * lambda * m * m / ((mu - 2 * lambda) * (mu + 2 * lambda));
  const auto eta = swings();
  auto& rows = table("lines", "Amplitudes, in minutes",
                     {{"tone", "tone"},
                      {"frequency", "frequency", Unit{"1/s"}},
                      {"euler", "(3)", arcminutes, 5},
                      {"second", "second order", arcminutes, 5},
                      {"full", "full equations", arcminutes, 4}});
  const auto row = [&](const char* tone, double at, double by_him, double second) {
    rows.row({tone, at, std::abs(by_him), std::abs(second), line(eta, at)});
  };
  row("2λ", 2 * lambda, 0, F);
  row("μ − λ", mu - lambda, lower, lower);
  row("μ", mu, n, n - K_of(r) * n + F);
  row("μ + λ", mu + lambda, upper, upper);
}

TELL
{
  curve("spectrum", {"frequency", "amplitude"}, [](Curve& out) {
    const auto eta = swings();
    for(int k = 1; k <= 600; ++k)
    {
      const double at = k * (mu + 3 * lambda) / 600;
      out.put({at, line(eta, at) / n});
    }
  });
  curve("euler", {"frequency", "amplitude"}, [](Curve& out) {
    const Release r = release();
    out.put({mu - lambda, r.i * m / (2 * mu - lambda)});
    out.put({double(mu), 1});
    out.put({mu + lambda, r.i * m / (2 * mu + lambda)});
  });
}

/*!
{{table lines}}

::: figure balance-30
alt: The spectrum of P's motion on a logarithmic scale: four sharp peaks, at twice the beam's frequency, at
the pan's, and on both sides of that; and fainter ones. Three of them carry Euler's points.

The motion of P by the full equations, taken apart: amplitudes in parts of $n$ over the frequency. The points
are Euler's three oscillations. What stands at $2\lambda$ is not among them; the fainter lines are of the
third order.
:::

## Checks
*/

CHECK_THAT("𝔄, the times, (3) and its derivative are as they stand")
{
  for(const Told& now :
      told_at("", "lambda=0.7 mu=9 beta=0.2 m=0.5 n=3 t=40", "lambda=2 mu=3 n=15 m=2 t=7", "t=987654.321"))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty(), s = t.fifty(), h("1e-18"), N = n.fifty();
    const Fifty half = beta.fifty() * l / 2 * m.fifty();
    const Fifty lower = half / (2 * u - l), upper = half / (2 * u + l), k = lower - upper;
    const auto three = [&](const Fifty& x) {
      return Fifty(N * (cos(u * x) + lower * cos((u - l) * x) - upper * cos((u + l) * x)));
    };
    CHECK(now.value("K") == within_relative(k, 1e-14, "a dozen roundings"));
    CHECK(now.value("A", degrees) == within_relative(N / (1 + k), 1e-15, "a quotient"));
    CHECK(now.value("start", degrees) == within_relative(three(0), 1e-15, "a sum"));
    CHECK(now.value("own", seconds) == within_relative(exact::pi() / u, 1e-15, "a quotient"));
    CHECK(now.value("slower", seconds)
          == within_relative(exact::pi() / (u - l), 1e-15 * double(u / (u - l)), "a difference"));
    CHECK(now.value("faster", seconds) == within_relative(exact::pi() / (u + l), 1e-15, "a sum"));
    CHECK(now.value("eta", degrees) == within_relative(three(s), 4e-16, "one rounding, and degrees"));
    CHECK(now.value("rate", Unit{"1/s"})
          == within_relative((three(s + h) - three(s - h)) / (2 * h), 1e-15, "differences"));
  }
}

CHECK_THAT("μ goes from 1.3 λ to 20 λ, but not where μμ is within λλ of 4λλ or μ − λ within 0.3 λ of 2λ")
{
  for(const char* const no :
      {"mu=1.2999999999999998", "lambda=3 mu=3.899999999999", "mu=20.000000000000004",
       "lambda=0.5 mu=10.000000000000002", "mu=1.73205081", "lambda=2 mu=3.464101616", "mu=2.23606797",
       "mu=2.700000000001", "mu=3.299999999999", "lambda=2 mu=6.599999999999"})
    CHECK(refused_at(no));
  for(const char* const yes :
      {"mu=1.3", "lambda=3 mu=3.9", "mu=20", "lambda=0.5 mu=10", "mu=1.7320508", "lambda=2 mu=3.464101615",
       "mu=2.23606798", "mu=2.7", "mu=3.3", "lambda=2 mu=6.6"})
    CHECK(!refused_at(yes));
}

std::vector<double> swings_by_gsl()  // at the same steps
{
  const std::size_t many = swings().size();
  const double step = length() / static_cast<double>(many - 1);
  State<> now = released(m, n, 0);
  std::vector<double> all{n};
  while(all.size() < many)
  {
    now = by_gsl(given(), now, step, 1e-12);
    all.push_back(now.at.eta);
  }
  return all;
}

CHECK_THAT("the table has (3), (A) and (B), and what GSL's motion is made of; the second order is near, by "
           "its next order")
{
  for(const Told& now : told_at("", "mu=7 n=1 m=5", "lambda=2 mu=14 beta=1 rho=0.02 m=3 n=3"))
  {
    const auto eta = swings_by_gsl();
    const Fifty l = lambda.fifty(), u = mu.fifty(), N = n.fifty(), M_ = m.fifty();
    const Fifty half = beta.fifty() * l / 2 * M_, lower = half / (2 * u - l), upper = half / (2 * u + l);
    const Fifty F = beta.fifty() * l * l * M_ * M_ / (u * u - 4 * l * l);
    const Fifty frequency[]{2 * l, u - l, u, u + l}, by_him[]{0, N * lower, N, N * upper},
        second[]{F, N * lower, N * (1 - lower + upper) + F, N * upper};
    const auto rows = now.rows("lines");
    REQUIRE(rows.size() == 4);
    for(std::size_t k{0}; k < 4; ++k)
    {
      const auto& row = rows[k];
      CHECK(row.value("frequency", Unit{"1/s"}) == within_relative(frequency[k], 1e-15, "a sum"));
      CHECK(row.value("euler", arcminutes) == within_relative(by_him[k], 4e-15, "a dozen roundings"));
      CHECK(row.value("second", arcminutes) == within_relative(second[k], 4e-15, "the same"));
      CHECK(row.value("full", arcminutes)
            == within(line(eta, double(frequency[k])), 1e-9, "GSL's tolerance"));
      CHECK(row.value("full", arcminutes)
            == within(second[k], 0.06 * double(second[k]) + 1e-4 * n,
                      "the third order, and what the window lets through"));
    }
    CHECK(rows[0].words("tone") == std::string("2λ"));
  }
}

CHECK_THAT("the figure has GSL's spectrum, and Euler's lines")
{
  for(const Told& now : told_at("", "mu=7 n=1 m=5", "lambda=2 mu=14 beta=1 m=3 n=3"))
  {
    const auto eta = swings_by_gsl();
    for(const auto& point : now.points("spectrum", 7))
      CHECK(point.value("amplitude")
            == within(line(eta, point.at("frequency")) / n, 1e-8, "GSL's tolerance"));
    const Fifty half = beta.fifty() * lambda.fifty() / 2 * m.fifty();
    const auto points = now.points("euler");
    REQUIRE(points.size() == 3);
    const Fifty l = lambda.fifty(), u = mu.fifty();
    CHECK(points[0].value("frequency") == within_relative(u - l, 2e-15, "a difference"));
    CHECK(points[1].value("frequency") == within_relative(u, 2e-16, "as given"));
    CHECK(points[2].value("frequency") == within_relative(u + l, 1e-15, "a sum"));
    CHECK(points[0].value("amplitude")
          == within_relative(half / (2 * mu.fifty() - lambda.fifty()), 4e-15, "roundings"));
    CHECK(points[1].value("amplitude") == within(1, 0, "n itself"));
    CHECK(points[2].value("amplitude")
          == within_relative(half / (2 * mu.fifty() + lambda.fifty()), 4e-15, "roundings"));
  }
}

CHECK_THAT("a single oscillation has its own amplitude in the window, and nothing five lines away from it")
{
  std::vector<double> pure;
  for(int k = 0; k <= 2000; ++k)
    pure.push_back(0.3 * std::cos(5.013 * length() * k / 2000));
  CHECK(line(pure, 5.013) == within(0.3, 1e-4, "the mirrored line"));
  CHECK(line(pure, 5.013 + 5 * 2 * std::numbers::pi / length()) == between(0, 1e-4, "Harris's side lobes"));
}

/*!
For $n$ in the value of $\mathfrak A$ our copy has $n:2$; and in {{eq 4}} it has lost a 4 in both
denominators, and a λ in the last numerator.
*/

const Emendation value_n{"§30, 𝔄, very nearly, for n = 10°",
                         {"n/2", 5.},
                         {"n", 10.},
                         "(2), in the example, and the formula's own start",
                         [](double reading) {
                           const double k = K_of<double>(1, 3, 16. / 9, 16, 1. / 6);
                           return reading * (1 + k) == within(10, 0.05, "K is 1/420");
                         }};

const Emendation last_member{
    "§30, the coefficient of the last member of dη:dt, for λ = ½, μ = 3, am = 2/9, n = 1",
    {"(μ+λ)μμamn : g(2μ+λ)", [] { return 3.5 * 9 * 2 / 9. / (16 * 6.5); }},
    {"λ(μ+λ)μμamn : 4g(2μ+λ)", [] { return 0.5 * 3.5 * 9 * 2 / 9. / (64 * 6.5); }},
    "it is the derivative of (3)",
    [](double reading) {
      const Release r{0.5, 3, i_of<double>(0.5, 3, 16. / 9, 16), {1. / 8, 1, 0}, 0};
      const double half = r.i / 8, rest = -3 * std::sin(3.) - 2.5 * half / 5.5 * std::sin(2.5);
      return rest + reading * std::sin(3.5) == within(euler_rates(r, 1.).eta, 1e-14, "roundings");
    }};
