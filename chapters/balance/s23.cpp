#include "balance/exchange.hpp"
#include "balance/motion.hpp"
#include "balance/scene.hpp"
#include "edition/section.hpp"

SECTION(balance, 23, "A beam at rest: do the three motions leave each other alone?")

using namespace balance;

/*!
## What Euler does

Whatever position and motion the two pans may have received, if the beam itself is left at rest and level at
the start, then by Euler's solution it has no part in anything. For then both $\omega$ and $d\omega:dt$ vanish
at $t=0$, and the formula $\omega = \mathfrak C\sin(\gamma+\lambda t)$ requires

$$ \mathfrak C\sin\gamma = 0 \quad\text{and}\quad \lambda\,\mathfrak C\cos\gamma = 0, \tag{1} $$

which cannot be, sine and cosine never vanishing together, unless

$$ \mathfrak C = 0. \tag{2} $$

With that the side tones of {{sec balance.17}} and {{sec balance.18}} are gone, and there remain

$$ \begin{gathered} \eta = \mathfrak A\sin(\alpha+\mu t),\\
   \vartheta = \mathfrak B\sin(\beta+\mu t),\\
   \omega = 0,
\end{gathered} \tag{3} $$

three formulae of which none acts on another {{entry beam_at_rest}}: each of beam and pans would swing by
itself and regularly. Since this is not what was observed, Euler takes it as a manifest sign that the beam
either was not at rest at the start, or had received some inclination; and this the impulse on the one pan
must needs have brought about.

The step from the formulae to the balance is where it goes wrong. His equation for the beam,
$\ddot\omega+\lambda\lambda\omega=0$, has lost everything that is of the second order ({{sec balance.13}}). A
pan that swings pulls its string the harder the lower it passes, and that twice in each of its periods. One
pan alone therefore sets the resting beam going. If P swings as $\eta = n\cos\mu t$ and Q hangs at rest, then

$$ \omega = \frac{Lab}{I}\,\mu\mu nn\,\frac{\cos\lambda t-\cos2\mu t}{4\mu\mu-\lambda\lambda}, \tag{A} $$

so that the beam moves from the first moment on, although nobody pushed it. With heavy pans there is more. The
beam carries P's pull at $2\mu$ over to Q, whose own frequency is half of that: so one shakes a swing by its
rope. In the mean over a period the lone motion is stable only as long as one pan's share in the inertia,
$\rho = Laa:I$, keeps below

$$ \rho_1 = \frac{4\mu\mu-\lambda\lambda}{32\mu\mu}, \tag{B} $$

about an eighth. Beyond it Q grows from the least beginning, as $e^{rt}$ with

$$ \begin{gathered} r = \frac{nn}4\sqrt{\frac\mu2\left(s-\frac\mu8\right)},\\
   s = \frac{4\rho\mu^3}{4\mu\mu-\lambda\lambda}.
\end{gathered} \tag{C} $$

::: margin
Today: parametric resonance at 2 : 1, the pump being the beam's forced motion; (B) and (C) are from the
averaged quartic Lagrangian.
:::

So the conclusion about the first impulse does not hold: an exchange is no proof that the beam was pushed.

## The program

Formulae (A) to (C) are {{api balance::lone_pan}} and {{api balance::second_order}}; beside them the full
equations are integrated. Where a slight change of the start would grow more than ten thousand times until
$t$, as with light beams on long strings, the program refuses.
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, closed(0.1, 5), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, closed(0.5, 20), "frequency of the pans, μ = √(2g/b)");
const auto beta = real("beta", 0.5, none, closed(0.05, 2), "a/b, arm to string");
const auto rho = real("rho", 0.25, none, closed(0.001, 0.45), "share of one pan in the whole inertia");
const auto n = angle("n", 1. / 6, closed(0.01_deg, 20_deg), "inclination of the pan P at the start");
const auto n1 = angle("n1", 0, closed(-20_deg, 20_deg), "inclination of the pan Q");
const auto t = real("t", 1, seconds, closed(0.001, 200), "time");

Balance<> given()
{
  return {lambda * lambda, mu * mu, beta, rho};
}

constexpr double room = 1e4;  // by so much a slight change of the start may grow

double shown()  // two periods of the beam, or as long as all is sure
{
  return sure_until(given(), released(0, n, n1), 4 * std::numbers::pi / lambda, room);
}

TELL
{
  require(2 * mu >= 1.2 * lambda, "mu", "such that 2 mu is 1.2 lambda at the least");
  require(parting(given(), released(0, n, n1), t) <= room, "t",
          "so short that a slight change does not grow ten thousand times");
  const Angles<> full = Motion(given(), released(0, n, n1)).to(t).at;
  const Angles<> second = second_order(given(), {0, n, n1}, t);
  tell("omega", full.omega, degrees, "the beam, by the full equations", 9);
  tell("eta", full.eta, degrees, "the pan P", 9);
  tell("theta", full.theta, degrees, "the pan Q", 9);
  tell("omega_second", second.omega, degrees, "the beam by (A), nn less n′n′ taking the place of nn");
  const Lone_pan alone = lone_pan(given(), n);
  tell("amplitude", alone.beam, degrees, "each of the two oscillations in (A), for Q at rest");
  tell("threshold", alone.threshold, "ρ beyond which a lone swing is unstable, (B)");
  tell("growth", alone.growth, Unit{"1/s"}, "rate r at which Q then grows, (C)");
}

TELL
{
  curve("beam", {"t", "full", "second"}, [](Curve& out) {
    const double until = shown();
    for(int k = 0; const State<>& now : course(given(), released(0, n, n1), until, 400))
    {
      const double at = until * k++ / 400;
      out.put({at, now.at.omega / 1_deg, second_order(given(), {0, n, n1}, at).omega / 1_deg});
    }
  });
}

TELL
{
  scene_on_pivot("stirred", given(), released(0, n, n1), shown());
}

/*!
To see {{eq C}} at work, one pan is let go by 0.15 of the radius and the other by a ten-thousandth of that,
once with light and once with heavy pans.
*/

constexpr double first = 0.15, seed = 1e-4 * first;

std::vector<Envelope> grown(double share, double swing, double beginning, double until)
{
  return envelopes({1, 25, 0.5, share}, released(0, swing, beginning), until, 4 * std::numbers::pi, 200);
}

double slope(const std::vector<Envelope>&
                 all)  // of the logarithm of Q's amplitude, late enough for the growing part alone
{
  const std::size_t i = all.size() / 2, j = 4 * all.size() / 5;
  return std::log(all[j].Q / all[i].Q) / (all[j].t - all[i].t);
}

TELL
{
  const Lone_pan heavy = lone_pan({1, 25, 0.5, 0.35}, first);
  tell("heavy_theory", heavy.growth, Unit{"1/s"}, "r for μ = 5, λ = 1, n = 0.15, ρ = 0.35, by (C)");
  tell("heavy_seen", slope(grown(0.35, first, seed, 600)), Unit{"1/s"}, "the same by the full equations",
       3);
  curve("other_pan", {"t", "heavy", "light", "theory"}, [](Curve& out) {
    const auto light = grown(0.05, first, seed, 900), heavy_pans = grown(0.35, first, seed, 900);
    for(std::size_t k{0}; k < light.size(); ++k)
      out.put({light[k].t, heavy_pans[k].Q / first, light[k].Q / first,
               1e-4 * std::exp(lone_pan({1, 25, 0.5, 0.35}, first).growth * light[k].t)});
  });
}

/*!
After {{t}} s the beam that was left at rest stands at {{omega|4}}; (A) has {{omega_second|4}}.

::: figure balance-23
alt: The beam's inclination over two of its periods, a fast oscillation on a slow one, up to some four tenths
of a degree. Euler's line is zero.

The beam's motion when one pan is let go alone: by the full equations, by {{eq A}} (dashed), and by Euler.
:::

::: scene stirred
alt: A level beam on its pivot, a thread with a pan at each end, the left one drawn aside.

The same in true time and proportions. Euler's beam would stay level; watch its ends while P swings.
With short arms and heavy pans ($a = \tfrac1{10}b$, $\rho = \tfrac25$) each of the two oscillations in
{{eq A}} has more than a degree and a half.
:::

### The other pan

With pans that have 0.35 of the inertia each, Q grows by {{heavy_seen|3}} of itself in a second; (C) has
{{heavy_theory|3}}.

::: figure balance-23-growth
alt: Q's amplitude on a logarithmic scale against the time. With heavy pans it climbs along a straight line
until it is as great as P's; with light ones it stays as small as it was.

Q's swing in parts of P's, the beam being at rest when the pans are let go: with heavy pans, with light ones;
the dashed line has the slope of {{eq C}}.
:::

## Checks
*/

CHECK_THAT("the motion is GSL's, the second order (A), and both differ by the next orders only")
{
  for(const Told& now : told_at("", "lambda=0.3 mu=4 beta=1.3 rho=0.4 n=12 n1=-5 t=9", "n=0.02 t=150",
                                "lambda=5 mu=3.1 rho=0.01 n1=20 t=3"))
  {
    const Angles<> full = by_gsl(given(), released(0, n, n1), t, 1e-13).at;
    CHECK(now.value("omega", degrees) == within(full.omega, 1e-11, "GSL's tolerance, step by step"));
    CHECK(now.value("eta", degrees) == within(full.eta, 1e-11, "the same"));
    CHECK(now.value("theta", degrees) == within(full.theta, 1e-11, "the same"));
    const Fifty l = lambda.fifty(), u = mu.fifty(), s = t.fifty(), N = n.fifty(), N1 = n1.fifty();
    const Fifty size = rho.fifty() / beta.fifty() * u * u / (4 * u * u - l * l);
    const double phases = 1e-15 * (1 + 2 * mu * t);
    CHECK(now.value("omega_second", degrees)
          == within(size * (N * N - N1 * N1) * (cos(l * s) - cos(2 * u * s)),
                    double(size) * (n * n + n1 * n1) * phases, "phases rounded"));
    CHECK(now.value("amplitude", degrees) == within_relative(size * N * N, 4e-15, "a dozen roundings"));
    CHECK(now.value("threshold") == within_relative((4 - l * l / (u * u)) / 32, 4e-15, "the same"));
    const Fifty g = 4 * rho.fifty() * u * u * u / (4 * u * u - l * l),
                square = g * g - (u / 4 - g) * (u / 4 - g);
    CHECK(now.value("growth", Unit{"1/s"})
          == within_relative(square > 0 ? Fifty(N * N / 4 * sqrt(square)) : Fifty(0), 1e-13,
                             "near the threshold a difference"));
    CHECK((square > 0) == (rho.fifty() > (4 - l * l / (u * u)) / 32));
  }
}

CHECK_THAT("the scene shows that motion, in its true time")
{
  for(const Told& now : told_at("", "lambda=0.3 mu=4 beta=1.3 rho=0.4 n=12 n1=-5",
                                "lambda=2 beta=1 rho=0.4", "lambda=0.1 mu=20"))
  {
    double last = 0;
    for(const auto& frame : now.points("stirred", 6))
    {
      const double at = frame.at("t");
      CHECK(frame.value("t") == between(last, 12.6 / lambda, "in their order, two periods of the beam"));
      last = at;
      const Angles<> full = at > 0 ? by_gsl(given(), released(0, n, n1), at, 1e-13).at : Angles<>{0, n, n1};
      for(const auto& column : by_name(joints<double>(0, beta, 1, 0, full.omega, full.eta, full.theta)))
        CHECK(frame.value(column.first) == within(column.second, 3e-11, "GSL's tolerance, step by step"));
    }
  }
  for(const Told& now : told_at("beta=0.1 rho=0.4"))
    CHECK(now.value("amplitude", degrees) == between(1.5_deg, 2_deg, "as the caption says"));
}

CHECK_THAT(
    "where neighbouring motions part too far the program refuses, but not where the swings are small")
{
  CHECK(refused_at("beta=0.1 rho=0.4 n=20 n1=-20 t=5.17"));
  CHECK(!refused_at("beta=0.1 rho=0.4 n=20 n1=-20 t=5.16"));
  CHECK(refused_at("lambda=5 mu=20 beta=0.05 rho=0.45 n=20 n1=-19.9 t=100"));
  CHECK(!refused_at("lambda=5 mu=20 beta=0.05 rho=0.45 n=0.02 n1=-0.01 t=100"));
}

CHECK_THAT("it refuses pans that swing less than six tenths as fast as the beam")
{
  for(const char* const slower : {"lambda=5 mu=2.9999999999999996", "mu=0.59999999999999987"})
    CHECK(refused_at(slower));
  for(const char* const as_fast : {"lambda=5 mu=3", "mu=0.6"})
    CHECK(!refused_at(as_fast));
}

CHECK_THAT("ten times smaller swings miss (A) by a thousandth: the third order is next")
{
  const auto missed = [](double swing) {
    const Balance<> b{1, 9, 0.5, 0.25};
    return Motion(b, released(0, swing, 0)).to(2).at.omega - second_order(b, {0, swing, 0}, 2).omega;
  };
  CHECK(missed(0.02) / missed(0.002) == within_relative(1000, 0.05, "and the fourth order"));
}

CHECK_THAT("Q grows as (C) says, the better the smaller P's swing; below the threshold it does not")
{
  for(const Told& now : told_at(""))
  {
    const Fifty s = 4 * Fifty("0.35") * 125 / 99;
    const Fifty theory = Fifty("0.0225") / 4 * sqrt(Fifty(5) / 2 * (s - Fifty(5) / 8));
    CHECK(now.value("heavy_theory", Unit{"1/s"}) == within_relative(theory, 1e-14, "roundings"));
    CHECK(now.value("heavy_seen", Unit{"1/s"}) == within_relative(theory, 0.08, "the next order, nn"));
  }
  const double half = lone_pan({1, 25, 0.5, 0.35}, first / 2).growth;
  CHECK(slope(grown(0.35, first / 2, seed / 2, 2400)) == within_relative(half, 0.04, "nn is a quarter"));
  const auto light = grown(0.05, first, seed, 900);
  for(const Envelope& now : light)
    CHECK(now.Q < 4 * seed);
}

CHECK_THAT("the figures have GSL's motion and (A); Q's growth, and none")
{
  for(const Told& now : told_at("", "lambda=0.5 mu=2 n=5", "rho=0.4 n1=8"))
    for(const auto& point : now.points("beam", 4))
    {
      const double s = point.at("t");
      const Angles<> full = s == 0 ? Angles<>{} : by_gsl(given(), released(0, n, n1), s, 1e-13).at;
      CHECK(point.value("full") == within(full.omega / 1_deg, 1e-9, "GSL's tolerance"));
      const Fifty l = lambda.fifty(), u = mu.fifty(), N = n.fifty(), N1 = n1.fifty();
      const Fifty size = rho.fifty() / beta.fifty() * u * u / (4 * u * u - l * l) * (N * N - N1 * N1);
      CHECK(point.value("second")
            == within(size * (cos(l * s) - cos(2 * u * s)) * 180 / exact::pi(), 1e-13, "phases rounded"));
    }
  for(const Told& now : told_at(""))
  {
    const auto points = now.points("other_pan");
    const Fifty rate =
        Fifty("0.0225") / 4 * sqrt(Fifty(5) / 2 * (4 * Fifty("0.35") * 125 / 99 - Fifty(5) / 8));
    for(const std::size_t k : {std::size_t{20}, std::size_t{60}, std::size_t{100}})
    {
      const auto& point = points[k];
      const Fifty theory = exp(rate * point.at("t")) / 10000;
      CHECK(point.value("theory") == within_relative(theory, 1e-13, "an exponential"));
      CHECK(point.value("heavy")
            == between(3 * theory, 9 * theory,
                       "what of Q grows is a few times its seed, for P stirs it too"));
      CHECK(point.value("light") == between(0, 0.0004, "it does not grow"));
    }
    CHECK(points.back().at("light") < 0.0004);
    CHECK(points[160].at("heavy") > 0.1);
  }
}

/*!
How far the beam gets in Euler's example, if P alone is let go by a sixth and ρ is ¼, is read from the motion
by GSL.
*/

const Erratum beam_at_rest{
    "§23, the greatest inclination of the beam, in minutes, while it swings once to and fro",
    {"none", 0},
    {"23.1′", 23.1},
    "the full equations, λ = 1, μ = 3, a/b = ½, ρ = ¼, n = ⅙",
    [](double reading) {
      State<> now = released(0, 1. / 6, 0);
      double most = 0;
      for(int k = 0; k < 630; ++k)
      {
        now = by_gsl({1, 9, 0.5, 0.25}, now, 0.01, 1e-12);
        most = std::max(most, std::abs(now.at.omega));
      }
      return reading == within(most / 1_deg * 60, 0.05, "the digit given");
    }};

/*!
## Go on from here

::: exercise
How heavy may the pans of Euler's example be at the most, if one that swings alone is not to wake the other?
Does it help to let it swing half as wide?
answer: By {{eq B}} one pan's share in the inertia may be 35 parts in 288, whatever the swing. Half the swing
only makes the waking four times as slow.
:::
*/

CHECK_THAT(
    "the threshold in the example is 35/288 at any swing, and half the swing wakes four times as slowly")
{
  double wide = 0;
  for(const Told& now : told_at("n=10", "n=5"))
  {
    CHECK(now.value("threshold") == within_relative(Fifty(35) / 288, 1e-14, "(B)"));
    const Lone_pan alone = lone_pan(given(), n);
    if(n > 6_deg)
      wide = alone.growth;
    else
      CHECK(4 * alone.growth == within_relative(wide, 1e-14, "a square"));
  }
}
