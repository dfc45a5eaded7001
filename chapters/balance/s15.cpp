#include <vector>

#include "balance/mathieu.hpp"
#include "edition/section.hpp"
#include "exact/ode.hpp"

SECTION(balance, 15, "A pan under a swinging beam")

using namespace balance;

/*!
## What Euler does

The beam being known, the pans have an equation each that does not contain the other. As
$dd\omega:2g\,dt^2 = -\omega:f$ ({{sec balance.14}}), the first and the third equation become

$$ \begin{gathered} \text{I.}\quad \frac{b\,dd\eta}{2g\,dt^2} = -\eta + \frac{a\eta\omega}f,\\
   \text{III.}\quad \frac{b\,dd\vartheta}{2g\,dt^2} = -\vartheta - \frac{a\vartheta\omega}f.
\end{gathered} \tag{1} $$

(Our copy numbers the second of them II.) As ω is all but infinitely small, the last members may at first be
passed over. Then each pan swings like a simple pendulum of the length $b$, and in finite quantities

$$ \begin{gathered} \eta = \mathfrak A\sin\Bigl(\alpha + t\sqrt{\frac{2g}b{{entry root_of_2g}}}\Bigr),\\
   \vartheta = \mathfrak B\sin\Bigl(\beta + t\sqrt{\frac{2g}b}\Bigr).
\end{gathered} \tag{2} $$

Euler adds that these values are only to be regarded as near the truth; the sections that follow improve
on them by one step.

With the beam's motion put in, {{eq 1}} is an equation that is met in many places today. Let
$\omega = m\cos\lambda t$ and $p = am:b$. As $a:f = \lambda\lambda a:2g$ and $b = 2g:\mu\mu$,

$$ \frac{d^2\eta}{dt^2} + \bigl(\mu\mu - p\,\lambda\lambda\cos\lambda t\bigr)\,\eta = 0, \tag{A} $$

a pendulum whose weight changes in the rhythm of the beam. In the time $z = \tfrac12\lambda t$ it is

$$ \begin{gathered} \frac{d^2\eta}{dz^2} + (A - 2q\cos2z)\,\eta = 0,\\
   A = \frac{4\mu\mu}{\lambda\lambda}, \quad q = 2p,
\end{gathered} \tag{B} $$

::: margin
Today: Mathieu's equation, a linear equation with periodic coefficient; the pan is driven parametrically.
:::

and for the other pan the same with $-q$, which is the same pan half a period of the beam later. How hard the
beam pulls does not depend on its frequency: $q$ is twice the arm, in string lengths, times the angle.

What becomes of a pan is decided by a single number. In a period of the beam, $2\pi:\lambda$, place and
speed change by a fixed linear law, whose coefficients form a matrix of determinant 1; half the sum of its
diagonal is the half trace $h$. If $-1 < h < 1$ the swings remain bounded for ever, and
$h = \cos(2\pi\nu:\lambda)$ gives the mean frequency ν. If $h$ lies beyond, one solution grows by a constant
factor in each period. For a small $p$ that happens only near $\lambda = 2\mu$, μ, $\tfrac23\mu$ and so on,
each time in a narrower interval. Away from these, to the second order of $p$,

$$ \nu - \mu = -\frac{p\,p\,\lambda^4}{4\mu(4\mu\mu-\lambda\lambda)}. \tag{C} $$

A slow beam makes the pans a little slower, one that is faster than $2\mu$ makes them quicker. It is this
small difference that in the end puts every formula like {{eq 2}} out of step, Euler's improved one too.

## The program

Two solutions are followed over half a period of the beam; all else is made of them.
*/

const Unit per_second{"1/s"};
const auto lambda = real("lambda", 1, per_second, closed(1e-3, 1e3), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, per_second, closed(1e-3, 1e3), "frequency of the pans, μ = √(2g/b)");
const auto p = real("p", 1. / 12, none, closed(-0.45, 0.45), "am/b; negative for the pan Q");
const auto n =
    angle("n", 1. / 6, closed(-90_deg, 90_deg), "inclination of the pan at the start, ω being m");
const auto v = real("v", 0, per_second, closed(-100, 100), "its rate at the start");
const auto t = real("t", 100, seconds, closed(0, 1e4), "time");

Prescribed_beam given()
{
  return {mu, lambda, p};
}

double pushed_by()  // (C)
{
  const double l2 = lambda * lambda;
  return -p * p * l2 * l2 / (4 * mu * (2 * mu - lambda) * (2 * mu + lambda));
}

const auto possible = [] {
  require(mu <= 20 * lambda, "mu", "at most 20 lambda");
  require(lambda * t <= 2e5 * std::numbers::pi, "t", "at most 100000 periods of the beam");
};

TELL
{
  possible();
  const Floquet f = floquet(given());
  require(f.growth * t <= 600, "t", "such that the swings do not grow beyond all numbers");
  tell("A", f.a, "A = 4μμ/λλ", 11);
  tell("q", f.q, "q = 2am/b", 15);
  tell("half_trace", f.half_trace, "h, half the trace of the change in a period", 11);
  tell("frequency", f.frequency, per_second, "mean frequency ν", 13);
  tell("shift", f.shift, per_second, "ν − μ", 11);
  if(lambda != 2 * mu)
    tell("shift_by_C", pushed_by(), per_second, "the same by (C)");
  tell("growth", f.growth, per_second, "rate at which swings grow", 11);
  const Pan now = pan_under(given(), {n, v}, t);
  tell("eta", now.y, radians, "η at the time t, of (A)", 9);
  tell("eta_rate", now.rate, per_second, "its rate", 9);
  tell("eta_by_2", n * std::cos(mu * t) + v / mu * std::sin(mu * t), radians, "η by (2)", 11);
}

TELL
{
  auto& rows = table("intervals", "Between these frequencies of the beam the swings of the pan grow",
                     {{"order", "order"},
                      {"near", "near", per_second},
                      {"from", "from", per_second, 11},
                      {"to", "to", per_second, 11},
                      {"growth", "rate in the middle", per_second, 4}});
  for(int order = 1; order <= 3; ++order)
  {
    const Interval growing = unstable(mu, p, order);
    const double middle = (growing.from + growing.to) / 2;
    rows.row({order, 2 * mu / order, growing.from, growing.to, floquet({mu, middle, p}).growth});
  }
}

/*!
The chart of {{eq A}}. Its bounds are found here from the exponents themselves: from the middle of an interval
outwards, where does the growth cease? Half a period of the beam tells it, by power series; all strengths $p$
are looked at side by side ({{api balance::halves}}).
*/

std::vector<double> bounds(const std::vector<double>& strengths, int order,
                           double side)  // in μ, by halving
{
  const std::size_t n = strengths.size();
  std::vector<double> middle(n), half(n), in(n, 0), out(n, 1.25), A(n), q(n);
  std::vector<Halves> at(n);
  for(std::size_t k{0}; k < n; ++k)
  {
    const Interval growing = unstable(1, strengths[k], order);
    middle[k] = (growing.from + growing.to) / 2;
    half[k] = (growing.to - growing.from) / 2;
    q[k] = 2 * strengths[k];
  }
  const auto where = [&](std::size_t k) { return middle[k] + side * (in[k] + out[k]) / 2 * half[k]; };
  for(int j = 0; j < 20; ++j)
  {
    for(std::size_t k{0}; k < n; ++k)
      A[k] = 4 / (where(k) * where(k));
    halves(A, q, at);
    for(std::size_t k{0}; k < n; ++k)
      (at[k].growing() ? in : out)[k] = (in[k] + out[k]) / 2;
  }
  std::vector<double> found(n);
  for(std::size_t k{0}; k < n; ++k)
    found[k] = where(k);
  return found;
}

TELL
{
  curve("tongues", {"p", "from1", "to1", "from2", "to2", "from3", "to3"}, [](Curve& out) {
    std::vector<double> strengths(21);
    for(std::size_t j{0}; j < strengths.size(); ++j)
      strengths[j] = 0.02 * static_cast<double>(j);
    std::vector<std::vector<double>> ends;
    for(const int order : {1, 2, 3})
      for(const double side : {-1., 1.})
        ends.push_back(bounds(strengths, order, side));
    for(std::size_t j{0}; j < strengths.size(); ++j)
      out.put({strengths[j], ends[0][j], ends[1][j], ends[2][j], ends[3][j], ends[4][j], ends[5][j]});
  });
}

/*!
In the example the mean frequency differs from μ by {{shift|e4}} 1/s, by {{eq C}} {{shift_by_C|e4}}. After
{{t}} s the pan stands at {{eta|5}} of the radius; the simple pendulum {{eq 2}} would be at {{eta_by_2|5}}.

{{table intervals}}

::: figure balance-15
alt: Chart of the ratio of the frequencies against the strength p. Three tongues start at the ratios 2, 1 and
two thirds; the first is broad, the second narrow, the third as thin as a line. Euler's example is a point far
below them.

Where the swings of a pan grow without bound: in the tongues, for a beam that the pans do not disturb. They
begin at $\lambda = 2\mu$, μ and $\tfrac23\mu$. A slow beam keeps below them; the point is Euler's example.
:::

## Checks

The judge is {{eq A}} itself, solved to some twenty digits over one period of the beam. What the program knows
about Mathieu's equation plays no part.
*/

struct Change  // of place and speed in a time, for two starts
{
  Fifty yy, yv, vy, vv;
};

Change change(const Fifty& l, const Fifty& u, const Fifty& s, const Fifty& time)
{
  const exact::RightSide right = [&](const Fifty& at, const exact::State& y) {  // (A)
    const Fifty weight = u * u - s * l * l * cos(l * at);
    return exact::State{y[1], -weight * y[0], y[3], -weight * y[2]};
  };
  const exact::State end = exact::solve(right, 0, {1, 0, 0, 1}, time, Fifty("1e-24")).y;
  return {end[0], end[2], end[1], end[3]};
}

Change then(const Change& second, const Change& first)
{
  return {second.yy * first.yy + second.yv * first.vy, second.yy * first.yv + second.yv * first.vv,
          second.vy * first.yy + second.vv * first.vy, second.vy * first.yv + second.vv * first.vv};
}

const char* const settings[] = {"", "lambda=1.97 t=40 v=-1", "lambda=6.2 mu=3 p=-0.2 t=31 n=1",
                                "lambda=0.11 mu=1.9 p=0.3 t=2000 n=-80", "lambda=700 mu=300 p=-0.05 t=7"};

CHECK_THAT("half trace, mean frequency, growth, place and speed are those of the equation in twenty digits")
{
  for(const Told& now : told_at(settings[0], settings[1], settings[2], settings[3], settings[4]))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty(), s = p.fifty(), turn = 2 * exact::pi();
    const Change period = change(l, u, s, turn / l);
    const Fifty h = (period.yy + period.vv) / 2;
    CHECK(now.value("A") == within_ulps(4 * u * u / (l * l), 4, "few roundings"));
    CHECK(now.value("q") == within_ulps(2 * s, 1, "a double of it"));
    CHECK(now.value("half_trace") == within(h, 1e-12 * (1 + double(abs(h))), "the phase of μ periods"));
    // the mean frequency: the multiple of ½λ nearest to μ, and what the half trace leaves
    const Fifty halves = round(2 * u / l);
    if(abs(h) < 1)
    {
      const bool even = 2 * floor(halves / 2) == halves;
      const Fifty lean = (even ? acos(h) : acos(-h)) * l / turn;
      const Fifty up = halves * l / 2 + lean, down = halves * l / 2 - lean;
      const Fifty nu = abs(up - u) < abs(down - u) ? up : down;
      CHECK(now.value("frequency", per_second) == within_relative(nu, 1e-13, "the lesser of its errors"));
      CHECK(now.value("shift", per_second) == within_relative(nu - u, 1e-10, "to full precision"));
      CHECK(now.value("growth", per_second) == within(0, 0, "bounded"));
    }
    else
    {
      CHECK(now.value("frequency", per_second) == within_ulps(halves * l / 2, 2, "kept to it"));
      CHECK(now.value("shift", per_second)
            == within(halves * l / 2 - u, 1e-15 * double(u), "a difference"));
      CHECK(now.value("growth", per_second)
            == within_relative(acosh(abs(h)) * l / turn, 1e-11, "half a period, to rounding"));
    }
    CHECK(now.value("shift_by_C", per_second)
          == within_relative(-s * s * l * l * l * l / (4 * u * (4 * u * u - l * l)), 1e-13, "λ near 2μ"));
    const Fifty whole = floor(l * t.fifty() / turn);
    Change all{1, 0, 0, 1}, base = period;
    for(long left = static_cast<long>(double(whole)); left > 0; left /= 2)
    {
      if(left % 2 == 1)
        all = then(base, all);
      base = then(base, base);
    }
    all = then(change(l, u, s, t.fifty() - whole * turn / l), all);
    const Fifty y = all.yy * n.fifty() + all.yv * v.fifty(), rate = all.vy * n.fifty() + all.vv * v.fifty();
    const double size = double(sqrt(y * y + rate * rate / (u * u)));
    CHECK(now.value("eta", radians) == within(y, 2e-11 * size, "of the swings' size"));
    CHECK(now.value("eta_rate", per_second) == within(rate, 2e-11 * size * mu, "the same"));
    CHECK(now.value("eta_by_2", radians)
          == within(n.fifty() * cos(u * t.fifty()) + v.fifty() / u * sin(u * t.fifty()),
                    (std::abs(n) + std::abs(v / mu)) * (1e-15 + 2e-16 * mu * t), "the phase is rounded"));
  }
}

Fifty beyond(const Fifty& l, int order)  // by how much the half trace has passed ±1
{
  const Change period = change(l, mu.fifty(), p.fifty(), 2 * exact::pi() / l);
  return (order % 2 == 0 ? 1 : -1) * (period.yy + period.vv) / 2 - 1;
}

CHECK_THAT("the intervals' ends are where the half trace, in twenty digits, passes ±1, and within it grows")
{
  for(const Told& now : told_at("", "mu=1 p=0.05 t=1", "mu=0.02 lambda=0.01 p=-0.3"))
    for(const auto& row : now.rows("intervals"))
    {
      const int order = static_cast<int>(row.at("order"));
      CHECK(row.value("order") == between(1, 3, "the rows' own"));
      CHECK(row.value("near", per_second) == within_relative(2 * mu.fifty() / order, 1e-15, "a quotient"));
      const Fifty from = row.at("from", per_second), to = row.at("to", per_second);
      const auto passes = [&](const Fifty& guess) {  // by secants, from points about it
        Fifty x0 = guess - (to - from) / 100, x1 = guess + (to - from) / 100;
        Fifty f0 = beyond(x0, order);
        for(int j = 0; j < 5; ++j)
        {
          const Fifty f1 = beyond(x1, order);
          const Fifty next = x1 - f1 * (x1 - x0) / (f1 - f0);
          x0 = x1, f0 = f1, x1 = next;
        }
        return x1;
      };
      CHECK(row.value("from", per_second) == within_relative(passes(from), 1e-13, "a matrix in doubles"));
      CHECK(row.value("to", per_second) == within_relative(passes(to), 1e-13, "a matrix in doubles"));
      const Fifty middle = (from + to) / 2, period = 2 * exact::pi() / middle;
      CHECK(row.value("growth", per_second)
            == within_relative(acosh(1 + beyond(middle, order)) / period, 1e-9, "the middle is rounded"));
    }
}

CHECK_THAT("the bounds in the figure, from the exponents, are Mathieu's characteristic values")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("tongues", 5))
    {
      const double s = point.at("p");
      const auto hold = [&point, s](const char* from, const char* to, int order) {
        const Interval growing = unstable(1, s, order);
        const double close = 2e-6 * (growing.to - growing.from) + 1e-14;
        CHECK(point.value(from) == within(growing.from, close, "twenty halvings"));
        CHECK(point.value(to) == within(growing.to, close, "twenty halvings"));
      };
      hold("from1", "to1", 1);
      hold("from2", "to2", 2);
      hold("from3", "to3", 3);
    }
}

CHECK_THAT("it refuses pans more than twenty times as fast as the beam, more than 100000 of its periods, "
           "and swings that grow more than e to the 600 times")
{
  for(const char* const within_them :
      {"mu=20", "lambda=0.25 mu=5", "lambda=100 t=6283.18530717958", "lambda=80 t=7853.98163397448"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"mu=20.000000000000004", "lambda=0.25 mu=5.000000000000001",
                                  "lambda=100 t=6283.18530717959", "lambda=80 t=7853.98163397449"})
    CHECK(refused_at(beyond));
  for(const auto& [within_it, beyond] :
      {std::pair{"lambda=6 t=2407.777", "lambda=6 t=2407.778"},
       {"lambda=12 mu=6 p=0.2 t=509.1419", "lambda=12 mu=6 p=0.2 t=509.142"}})
  {
    CHECK(refused_at(beyond));
    for(const Told& now : told_at(within_it))
      CHECK(now.value("growth", per_second) == within_relative(600 / t.fifty(), 1e-6, "nearly the limit"));
  }
}

CHECK_THAT("(C) is the beginning of the difference ν − μ, for slow beams and fast ones")
{
  for(const char* const at : {"p=1e-4", "p=1e-4 lambda=0.3", "p=-1e-4 lambda=11"})
    for(const Told& now : told_at(at))
      CHECK(now.value("shift", per_second) == within_relative(pushed_by(), 1e-6, "the next order"));
  for(const Told& now : told_at("lambda=7"))
    CHECK(now.value("shift", per_second) == between(1e-6, 1, "a beam faster than 2μ quickens the pans"));
}

/*!
In {{eq 2}} our copy has $g$ for $2g$, twice. It is the same slip as in {{sec balance.14}}.
*/

const Emendation root_of_2g{"§15, both roots",
                            {"√(g/b)", [] { return std::sqrt(16. * 9 / 32); }},
                            {"√(2g/b)", [] { return std::sqrt(32. * 9 / 32); }},
                            "(1) without its last members demands it, and § 22 has it",
                            [](double root) {  // bη̈:2g + η of sin(root·t), over the sine; b = 32/9
                              const double left = 32. / 9 / 32 * root * root - 1;
                              return root > 0 && left == within(0, 4e-16, "few roundings");
                            }};

/*!
## Notes

The equation itself leaves two things out. It has the beam swing as a pendulum for ever, whatever the pans
do to it; and it lacks the sideways motion of $A$, which is of the same order as the term that it keeps
({{sec balance.13}}). So the chart is that of Euler's problem; the true balance has a resonance besides, at
$\mu = 2\lambda$ ({{sec balance.28}}).

## Go on from here

::: exercise
Let the beam pull twice in every period of the pan, `--lambda 6 --t 10`. How many periods of the beam does it
take for the swings of the example to double?

answer: Fewer than three: they grow by nearly $\mu p$ a second, so that the doubling takes 2.8 s, and a period
of the beam lasts a little more than one. A child on a swing does the same, with a $p$ of its own.
:::
*/

CHECK_THAT("at λ = 2μ swings double in less than three periods of the beam, growing by nearly μp")
{
  for(const Told& now : told_at("lambda=6 t=10"))
  {
    CHECK(now.value("growth", per_second) == within_relative(mu * p, 0.01, "the next order of p"));
    const double period = 2 * std::numbers::pi / lambda;
    CHECK(now.value("growth", per_second) == between(std::log(2.) / (3 * period), 1, "less than three"));
    CHECK(now.value("growth", per_second) == between(std::log(2.) / 2.85, std::log(2.) / 2.75, "2.8 s"));
  }
}
