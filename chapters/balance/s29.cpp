#include "balance/euler.hpp"
#include "balance/motion.hpp"
#include "edition/section.hpp"

SECTION(balance, 29, "Case 2: one pan pulled aside, the other left at rest")

using namespace balance;

/*!
## What Euler does

Now the case that was observed: the pan P is led aside by the angle $n$ {{entry angle_n}}, the other is left
hanging at rest, and the beam is inclined by $m$; all three are let go together. At $t = 0$ there must be
$\eta = n$, $\vartheta = 0$, and both rates must vanish. With the formulae of {{sec balance.25}} these are
again four conditions, written at once in their simplest form; $K$ is the fraction of {{sec balance.26}}:

$$ \begin{aligned}
\text{I.}\quad n &= \mathfrak A\sin\alpha\,(1+K),\\ \text{II.}\quad 0 &= \mathfrak B\sin\beta\,(1-K),\\
\text{III.}\quad 0 &= \mathfrak A\cos\alpha\,(1-K),\\ \text{IV.}\quad 0 &= \mathfrak B\cos\beta\,(1+K).
{{entry sign_of_IV}} \end{aligned} \tag{1} $$

He writes III and IV without their factors $\mathfrak A$ and $\mathfrak B$, and adds that these are to be
understood; he has learnt from {{sec balance.28}} that everything hangs on them. For now he sees at a glance:
if

$$ \mathfrak B = 0, \tag{2} $$

the second and the fourth condition hold together, whatever β may be. Then ϑ vanishes throughout, in whatever
way the two others are met, and the pan Q never comes to move {{entry other_pan}}. So it can be, he concludes,
that one pan rests for ever while the other swings. For the motion of P there remain I and III; they are the
subject of the next section.

He might have said more: not only can it be, it must. As long as $K$ is neither 1 nor −1, II and IV leave no
other way than (2). His formulae divide into two pairs, one a pan, and no constant is common to both. That P
swings makes no difference to Q; this is case 1 over again for the one pan, and the simple case for the other.

::: margin
Today: (1) is a linear map from $(\mathfrak A\sin\alpha,\mathfrak A\cos\alpha)$ and the same for Q to the
start, with the determinant $(1-K^2)^2$; it has no elements that lead from one pan to the other.
:::

The full equations deny it, and in two steps. At the second order Q has the motion that it also has beside a
pan at rest,

$$ \begin{gathered} \vartheta = F(\cos2\lambda t-\cos\mu t),\\
   F = \frac ab\,\frac{\lambda\lambda mm}{\mu\mu-4\lambda\lambda},
\end{gathered} \tag{A} $$

since $B$ moves on an arc ({{sec balance.28}}). Here $n$ does not come in, and it does not grow. At the third
order there is a part that grows with the time and has its force from P, and it goes on until Q has all
({{sec balance.31}}).

## The program

What (1) leaves at given constants, and the motion of both pans by the full equations. Where a slight change
of the start would grow more than ten thousand times until $t$, the program refuses.
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, closed(0.1, 10), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, closed(0.1, 30), "frequency of the pans, μ = √(2g/b)");
const auto beta = real("beta", 0.5, none, closed(0.01, 2), "a/b, arm to string");
const auto rho = real("rho", 0.25, none, closed(0, 0.45), "share of one pan in the whole inertia");
const auto m = angle("m", 1. / 6, closed(0.01_deg, 20_deg), "inclination of the beam at the start");
const auto n = angle("n", 1. / 6, closed(0.01_deg, 20_deg), "inclination of the pan P");
const auto t = real("t", 10, seconds, closed(0.001, 200), "time");

Balance<> given()
{
  return {lambda * lambda, mu * mu, beta, rho};
}

double K()  // 2iλm/(4μμ − λλ), i = ½λa/b
{
  return beta * lambda * lambda * m / ((2 * mu - lambda) * (2 * mu + lambda));
}

constexpr double room = 1e4;  // by so much a slight change of the start may grow

TELL
{
  require(std::abs(4 * mu * mu - lambda * lambda) >= 0.1 * lambda * lambda, "lambda",
          "such that 4μμ differs from λλ by a tenth of it");
  require(std::abs(1 + K()) > 1e-3, "m", "such that K is not -1");
  require(std::abs(1 - K()) > 1e-3, "m", "such that K is not 1");
  require(parting(given(), released(m, n, 0), t) <= room, "t",
          "so short that a slight change does not grow ten thousand times");
  tell("K", K(), "K");
  tell("of_P", 1 + K(), "1 + K, by which n is divided to give 𝔄 at α = 90°");
  tell("A", n / (1 + K()), degrees, "𝔄, by I and III");
  const Angles<> full = Motion(given(), released(m, n, 0)).to(t).at;
  const Angles<> second = second_order(given(), {m, n, 0}, t);
  tell("omega", full.omega, degrees, "the beam at the time t, by the full equations", 9);
  tell("eta", full.eta, degrees, "the pan P", 9);
  tell("theta", full.theta, degrees, "the pan Q, by Euler at rest", 9);
  tell("theta_second", second.theta, degrees, "Q by (A)", 9);
}

TELL
{
  curve("other", {"t", "full", "second"}, [](Curve& out) {
    const double until = sure_until(given(), released(m, n, 0), 8 * std::numbers::pi / lambda, room);
    for(int k = 0; const State<>& now : course(given(), released(m, n, 0), until, 1200))
    {
      const double at = until * k++ / 1200;
      out.put({at, now.at.theta / 1_deg, second_order(given(), {m, n, 0}, at).theta / 1_deg});
    }
  });
}

/*!
With the numbers of Euler's example Q stands at {{theta|4}} after {{t}} s; {{eq A}} has {{theta_second|4}},
and Euler 0°.

::: figure balance-29
alt: The inclination of Q over four swings of the beam to and fro. At first it keeps to a small even
oscillation, then its swings become ever wider.

The pan that by Euler stays at rest: by the full equations, by {{eq A}} (dashed), and by him. What it has
beyond (A) comes from the pan P and grows with the time.
:::

## Checks
*/

CHECK_THAT("(1) is what the general solution starts with, in fractions of the sines")
{
  const Fifty l("0.9"), u("2.3"), a_("1.7"), g_("16"), m_("0.2");
  const Fifty i = i_of<Fifty>(l, u, a_, g_), k = K_of<Fifty>(l, u, a_, g_, m_), half = exact::pi() / 2;
  for(const Fifty& x : {Fifty("0.3"), Fifty("1.4"), Fifty("-2")})
  {
    const State<Fifty> at = general<Fifty>(l, u, i, {Fifty("0.11"), Fifty("0.07"), m_, x, x + 1, half}, 0);
    CHECK(at.at.eta == within(Fifty("0.11") * sin(x) * (1 + k), 1e-45, "I"));
    CHECK(at.at.theta == within(Fifty("0.07") * sin(x + 1) * (1 - k), 1e-45, "II"));
    CHECK(at.rate.eta / u == within(Fifty("0.11") * cos(x) * (1 - k), 1e-45, "III"));
    CHECK(at.rate.theta / u == within(Fifty("0.07") * cos(x + 1) * (1 + k), 1e-45, "IV"));
  }
}

CHECK_THAT(
    "𝔄 makes the general solution start at n and rest; the motion told is GSL's, and Q's second order (A)")
{
  for(const Told& now : told_at("", "lambda=0.7 mu=4 beta=1.2 rho=0.1 m=15 n=2 t=3", "mu=2 m=2 n=9 t=20",
                                "n=0.01 m=0.5 t=150 rho=0.4"))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty(), i = beta.fifty() * l / 2, s = t.fifty();
    const Fifty k = i * m.fifty() * (1 / (2 * u - l) - 1 / (2 * u + l));
    CHECK(now.value("K") == within_relative(k, 3e-15, "a dozen roundings"));
    CHECK(now.value("of_P") == within_relative(1 + k, 3e-15, "the same"));
    const Fifty A = n.fifty() / (1 + k), right = exact::pi() / 2;
    CHECK(now.value("A", degrees) == within_relative(A, 3e-15, "the same"));
    const State<Fifty> start = general<Fifty>(l, u, i, {A, 0, m.fifty(), right, 0, right}, 0);
    CHECK(start.at.eta == within(n.fifty(), 1e-45, "I"));
    CHECK(start.rate.eta == within(0, 1e-45, "III"));
    const Angles<> full = by_gsl(given(), released(m, n, 0), t, 1e-13).at;
    CHECK(now.value("omega", degrees) == within(full.omega, 2e-11, "GSL's tolerance, step by step"));
    CHECK(now.value("eta", degrees) == within(full.eta, 2e-11, "the same"));
    CHECK(now.value("theta", degrees) == within(full.theta, 2e-11, "the same"));
    const Fifty am = beta.fifty() * m.fifty() * m.fifty() * l * l;
    const Fifty F = u == 2 * l ? Fifty(am * s * sin(u * s) / (2 * u)) :  // the limit
                        Fifty(am / (u * u - 4 * l * l) * (cos(2 * l * s) - cos(u * s)));
    const double off = (1e-15 + 1e-15 * mu * t) * double(am) * (1 + t / mu);
    CHECK(now.value("theta_second", degrees) == within(F, off, "phases rounded"));
  }
}

CHECK_THAT(
    "where neighbouring motions part too far the program refuses, but not where the swings are small")
{
  CHECK(refused_at("beta=0.1 rho=0.45 m=20 n=20 t=6.685"));
  CHECK(!refused_at("beta=0.1 rho=0.45 m=20 n=20 t=6.672"));
  CHECK(refused_at("beta=0.01 rho=0.45 m=20 n=20 t=200"));
  CHECK(!refused_at("beta=0.01 rho=0.45 m=1 n=0.02 t=200"));
}

CHECK_THAT("it refuses 4μμ nearer to λλ than a tenth of that, and K within a thousandth of 1 or −1, and no "
           "more")
{
  const std::string one = "mu=0.6 beta=2 t=1 m=",
                    less = "mu=0.4 beta=2 t=1 m=";  // K is m : 0.22, −m : 0.18
  for(const std::string& no : std::vector<std::string>{
          "lambda=5.72077554", "lambda=6.32455532", one + "0.2197801rad", one + "0.22rad",
          one + "0.2202199rad", less + "0.1798201rad", less + "0.18rad", less + "0.1801799rad"})
    CHECK(refused_at(no));
  for(const std::string& yes :
      std::vector<std::string>{"lambda=5.72077553", "lambda=6.32455533", one + "0.2197799rad",
                               one + "0.2202201rad", less + "0.1798199rad", less + "0.1801801rad"})
    CHECK(!refused_at(yes));
}

CHECK_THAT("what Q has beyond (A) goes with P's swing, at a given beam, and grows")
{
  const auto beyond = [](double swing, double time) {
    const Balance<> b{1, 9, 0.5, 0.25};
    double most = 0;
    for(int k = 0; k < 40; ++k)
    {
      const double at = time + k / 20.;
      const double with_P = by_gsl(b, released(0.1, swing, 0), at, 1e-13).at.theta;
      most = std::max(most, std::abs(with_P - by_gsl(b, released(0.1, 0, 0), at, 1e-13).at.theta));
    }
    return most;
  };
  CHECK(beyond(0.02, 20) / beyond(0.01, 20) == within_relative(2, 0.05, "nn and beyond"));
  CHECK(beyond(0.02, 40) > 1.5 * beyond(0.02, 20));
}

CHECK_THAT("in the figure Q is GSL's, and (A)")
{
  for(const Told& now : told_at("", "lambda=2 mu=7 n=3", "rho=0.05 beta=1"))
    for(const auto& point : now.points("other", 4))
    {
      const double s = point.at("t");
      const Angles<> full = s == 0 ? Angles<>{} : by_gsl(given(), released(m, n, 0), s, 1e-13).at;
      CHECK(point.value("full") == within(full.theta / 1_deg, 1e-8, "GSL's tolerance"));
      const Fifty l = lambda.fifty(), u = mu.fifty();
      const Fifty F = beta.fifty() * m.fifty() * m.fifty() * l * l / (u * u - 4 * l * l);
      CHECK(point.value("second")
            == within(F * (cos(2 * l * s) - cos(u * s)) * 180 / exact::pi(), 1e-12, "phases rounded"));
    }
}

/*!
In the heading and in the line after it our copy has $m$ for the angle of P, which is the beam's; I has $n$.
IV it has with the sign of III. That may be its own slip or the printer's or Euler's; it does no harm, for
$\mathfrak B = 0$ meets either. (Where ϑ is said to vanish, it has $\mathfrak A$, by which no angle is
called.)
*/

const Emendation angle_n{
    "§29, the angle of P in the heading and in the next line, the beam being at 10° and P at 4°",
    {"m", 10.},
    {"n", 4.},
    "what I has on its left is where P starts",
    [](double reading) {
      const double k = K_of<double>(1, 3, 16. / 9, 16, 10_deg), A = 4_deg / (1 + k);
      const State<> start = general<double>(1, 3, 0.25, {A, 0, 10_deg, 90_deg, 0, 90_deg}, 0);
      return reading * 1_deg == within_relative(start.at.eta, 1e-14, "roundings");
    }};

const Doubtful sign_of_IV{
    "§29, IV, what stands beside cos β, in the example",
    {"− K", -1. / 420},
    {"+ K", 1. / 420},
    "§26 has it, and Q's rate at the start",
    [](double reading) {
      const State<> start = general<double>(1, 3, 0.25, {0, 1, 1. / 6, 0, 0, 90_deg}, 0);
      return reading == within_relative(start.rate.theta / 3 - 1, 1e-12, "a difference from 1");
    }};

const Erratum other_pan{
    "§29, the inclination of Q after 200 seconds, in degrees, with the numbers of the example",
    {"at rest", 0},
    {"−9.44°", -9.44},
    "the full equations with ρ = ¼; P then all but rests",
    [](double reading) {
      const Angles<> at = by_gsl({1, 9, 0.5, 0.25}, released(1. / 6, 1. / 6, 0), 200, 1e-13).at;
      return reading == within(at.theta / 1_deg, 0.005, "the digits given")
             && std::abs(at.eta) < 0.01 * std::abs(at.theta);
    }};
