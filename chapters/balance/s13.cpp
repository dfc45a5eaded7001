#include "balance/instrument.hpp"
#include "balance/motion.hpp"
#include "edition/section.hpp"

SECTION(balance, 13, "Three equations, and what ought not to be dropped")

using namespace balance;

/*!
## What Euler does

With the tensions of {{sec balance.12}} put in, three equations are left for the three angles. As
$P = L + La\,dd\omega:2g\,dt^2$ and $Q = L - La\,dd\omega:2g\,dt^2$,

$$ \begin{aligned}
\text{I.}&\ \frac{b\,dd\eta}{2g\,dt^2} = -\eta
   - \frac{a{{entry lost_a}}\,\eta\,dd\omega}{2g\,dt^2},\\
\text{III.}&\ {-\frac{b\,dd\vartheta}{2g\,dt^2}} = \vartheta - \frac{a\,\vartheta\,dd\omega}{2g\,dt^2},\\
\text{V.}&\ \frac{M(kk+cc)\,dd\omega + 2La\,a\,dd\omega}{2g\,dt^2}\\
 &\qquad = -Mc\,\omega. \end{aligned} \tag{1} $$

The last has ω alone. What the tensions have above or below the weights of the pans is as if these weights
were fixed to $A$ and $B$; they only make the beam more sluggish. The first two are those of a pendulum whose
weight changes while $A$ or $B$ is accelerated. No equation has η and ϑ together.

Here the reckoning stops being consistent. The products $\eta\,dd\omega$ are of the second order. They
come from the change of a tension, which is of the first, times the lean of a string, which is too. If such
products are kept, all must be; and three more have been dropped, with the squares that {{sec balance.11}}
set aside:

$$ \begin{aligned}
\text{I.}&\ \frac{b\ddot\eta}{2g} = -\eta - \frac{a\eta\ddot\omega}{2g}
  + \frac a{2g}\frac{d^2}{dt^2}\frac{\omega\omega}2,\\
\text{III.}&\ {-\frac{b\ddot\vartheta}{2g}} = \vartheta - \frac{a\vartheta\ddot\omega}{2g}
  + \frac a{2g}\frac{d^2}{dt^2}\frac{\omega\omega}2,\\
\text{V.}&\ \frac{I\ddot\omega}{2g} = -Mc\,\omega + \frac{Lab}{2g}\Bigl[\omega(\ddot\eta-\ddot\vartheta)\\
  &\qquad - \frac{d^2}{dt^2}\frac{\eta\eta-\vartheta\vartheta}2\Bigr].
\end{aligned} \tag{A} $$

Here $I = M(kk+cc)+2Laa$. The first new term is the acceleration with which $A$ moves sideways on its arc.
It does not vanish with η: it drives a pan that hangs at rest. The bracket is what the pans do to the beam
when they do not swing alike. All these terms come from one, the part of the third degree in the energy of
motion; to keep a part of them is to break the balance between what the beam does to the pans and what they
do to it.

::: margin
Today: the whole second order comes from the cubic Lagrangian
$Lab\bigl[(\eta-\vartheta)\frac{d^2}{dt^2}\frac{\omega^2}2 - \tfrac12\ddot\omega(\eta^2-\vartheta^2)\bigr]$.
:::

How large is what is dropped? With $\omega = m\cos\lambda t$ and $\eta = n\cos\mu t$ both terms of I are
trains of waves. The kept one has in η the amplitudes $imn:(2\mu\mp\lambda)$ at the frequencies
$\mu\mp\lambda$; the dropped one has

$$ F = \frac ab\,\frac{\lambda\lambda mm}{\mu\mu-4\lambda\lambda}
   \quad\text{at } 2\lambda. \tag{B} $$

Where $\mu = 3\lambda$, as in Euler's example, $\mu - \lambda$ is $2\lambda$. The two fall on each other
with opposite signs, and if $m = n$ the dropped one is exactly twice the other.

## The program

A state of the balance, with the accelerations that {{eq 1}}, {{eq A}} and the full equations give it.

::: code balance/instrument.hpp orders (1) (A)
:::
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, closed(1e-3, 1e3), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, closed(1e-3, 1e3), "frequency of the pans, μ = √(2g/b)");
const auto beta = real("beta", 0.5, none, closed(1e-3, 1e3), "a/b, arm to string");
const auto rho = real("rho", 0.25, none, closed(0, 0.49), "Laa/I, share of one pan in the whole inertia");
const auto omega = angle("omega", 6_deg, closed(-90_deg, 90_deg), "inclination ω of the beam");
const auto eta = angle("eta", -7_deg, closed(-90_deg, 90_deg), "inclination η of the string AP");
const auto theta = angle("theta", 5_deg, closed(-90_deg, 90_deg), "inclination ϑ of the string BQ");
const auto omega_rate = real("omega_rate", 0.3, Unit{"1/s"}, closed(-1e3, 1e3), "dω/dt");
const auto eta_rate = real("eta_rate", -0.2, Unit{"1/s"}, closed(-1e3, 1e3), "dη/dt");
const auto theta_rate = real("theta_rate", 0.4, Unit{"1/s"}, closed(-1e3, 1e3), "dϑ/dt");
const auto t = real("t", 7, seconds, closed(0, 50), "a later time");

Balance<Fifty> given()
{
  return {lambda.fifty() * lambda.fifty(), mu.fifty() * mu.fifty(), beta.fifty(), rho.fifty()};
}

State<Fifty> now_at(const Fifty& part)  // the state, all angles and rates reduced to a part
{
  return {{part * omega.fifty(), part * eta.fifty(), part * theta.fifty()},
          {part * omega_rate.fifty(), part * eta_rate.fifty(), part * theta_rate.fifty()}};
}

const Unit per_second_2{"1/s²"};

TELL
{
  const State<Fifty> now = now_at(1);
  const Angles<Fifty> full = accelerations(given(), now), his = euler_accelerations(given(), now.at),
                      second = second_order_accelerations(given(), now);
  const auto say = [](const char* name, const Fifty& x, const char* what) {
    tell(name, double(x), per_second_2, what);
  };
  say("omega_full", full.omega, "ddω/dt² by the full equations");
  say("omega_euler", his.omega, "by (1)");
  say("omega_second", second.omega, "by (A)");
  say("eta_full", full.eta, "ddη/dt² by the full equations");
  say("eta_euler", his.eta, "by (1)");
  say("eta_second", second.eta, "by (A)");
  say("theta_full", full.theta, "ddϑ/dt² by the full equations");
  say("theta_euler", his.theta, "by (1)");
  say("theta_second", second.theta, "by (A)");
}

/*!
The terms by themselves, in the same state; and how what is missing shrinks with the swings.
*/

Fifty kept(const State<Fifty>& now)  // −aηω̈:b, of (1)
{
  return beta.fifty() * lambda.fifty() * lambda.fifty() * now.at.eta * now.at.omega;
}

Fifty dropped(const State<Fifty>& now)  // a(ωω/2)¨:b, of (A)
{
  const Fifty& w = now.at.omega;
  return beta.fifty() * (now.rate.omega * now.rate.omega - lambda.fifty() * lambda.fifty() * w * w);
}

TELL
{
  tell("kept", double(kept(now_at(1))), per_second_2, "what (1) has of the second order in ddη/dt²");
  tell("dropped", double(dropped(now_at(1))), per_second_2, "what it has not");
  auto& rows =
      table("orders", "What is missing in ddη/dt² if all angles and rates are reduced to a part",
            {{"part", "part"}, {"by_1", "by (1)", per_second_2, 5}, {"by_A", "by (A)", per_second_2, 5}});
  for(const char* part : {"1", "0.1", "0.01", "0.001", "1e-7"})
  {
    const State<Fifty> now = now_at(Fifty(part));
    const Fifty full = accelerations(given(), now).eta;
    rows.row({double(Fifty(part)), double(full - euler_accelerations(given(), now.at).eta),
              double(full - second_order_accelerations(given(), now).eta)});
  }
}

/*!
Whither the full equations bring this state, {{api balance::Motion}} tells, with the {{api balance::energy}}
that they keep, in parts of $I$. Where neighbouring motions part, roundings with them, it refuses.
*/

Balance<> rounded()
{
  return {lambda * lambda, mu * mu, beta, rho};
}

State<> start()
{
  return {{omega, eta, theta}, {omega_rate, eta_rate, theta_rate}};
}

TELL
{
  const double quick = std::max({double(lambda), double(mu), std::abs(double(omega_rate)),
                                 std::abs(double(eta_rate)), std::abs(double(theta_rate))});
  require(quick * t <= 1e4, "t", "such that no angle turns through 10000 radians");
  const double grown = parting(rounded(), start(), t);
  require(grown <= 1e4, "t", "so short that a slight change does not grow ten thousand times");
  const int lost = int(std::ceil(std::log10(grown)));  // digits of what is told
  Motion motion(rounded(), start());
  const auto [at, rate] = motion.to(t);
  const Unit speed{"1/s"};
  tell("omega_t", at.omega, radians, "ω at the time t, by the full equations", 14 - lost);
  tell("eta_t", at.eta, radians, "η then", 14 - lost);
  tell("theta_t", at.theta, radians, "ϑ then", 14 - lost);
  tell("omega_rate_t", rate.omega, speed, "dω/dt then", 13 - lost);
  tell("eta_rate_t", rate.eta, speed, "dη/dt then", 13 - lost);
  tell("theta_rate_t", rate.theta, speed, "dϑ/dt then", 13 - lost);
  tell("energy", energy(rounded(), start()), per_second_2, "the energy at the start, over I", 14);
  tell("energy_t", energy(rounded(), {at, rate}), per_second_2, "the same at the time t", 13);
}

TELL
{
  curve("terms", {"lambda_t", "kept", "dropped"}, [](Curve& out) {  // Euler's example, let go from rest
    const Fifty sixth = Fifty(1) / 6;
    for(int j = 0; j <= 360; ++j)
    {
      const Fifty t = j * exact::pi() / 180;
      const Fifty w = sixth * cos(t), e = sixth * cos(3 * t), v = -sixth * sin(t);
      out.put({static_cast<double>(j), double(w * e) / 2, double(v * v - w * w) / 2});
    }
  });
}

/*!
In the state given, η is accelerated by {{eta_full|5}} 1/s²; by Euler's equation by {{eta_euler|5}}, by the
complete second order {{eta_second|5}}. Of the second order he keeps {{kept|4}} and drops {{dropped|4}}.

{{table orders}}

A tenth of the swings leaves a hundredth of the fault of {{eq 1}}, but a thousandth of that of {{eq A}}.

::: figure balance-13
alt: Two wavy curves over one period of the beam, of the same height. The one that Euler keeps has a wave of
varying strength; the one that he drops goes regularly up and down twice.

The two parts of the second order in $dd\eta:dt^2$ along the motion of the first order, in Euler's example
($\lambda = 1$, $\mu = 3$, $a:b = \tfrac12$, all angles a sixth): the one that he keeps and the one that he
drops. At the start they cancel.
:::

## Checks

The full equations are Newton's: with the five unknowns they are solved as they stand. And the complete second
order must be what a formal expansion of the full equations has, which is read off from their even and odd
parts.
*/

Instrument realised()  // with b = 1, M(kk+cc)+2Laa = 1 and L = ρ:aa
{
  const double g = mu * mu / 2, c = lambda * lambda / (4 * g);  // M = 2, 2gMc = λλ
  const double own = 1 - 2 * rho;
  return {beta, 1, c, own / 2 - c * c, rho / (beta * beta), 2, g};
}

CHECK_THAT("the state told is that to which twenty digits come, and the energy is kept")
{
  for(const Told& now : told_at("", "lambda=0.9 mu=2 omega=-10 eta=12 theta=-9 rho=0.4 t=9",
                                "mu=11 beta=1 eta_rate=1 theta_rate=-2 t=3"))
  {
    const State<Fifty> then = oracle(rounded(), start(), t);
    const double room = 1e-13 * parting(rounded(), start(), t);
    const char* const why = "rounding, as neighbouring motions part";
    const Unit speed{"1/s"};
    CHECK(now.value("omega_t", radians) == within(then.at.omega, room, why));
    CHECK(now.value("eta_t", radians) == within(then.at.eta, room, why));
    CHECK(now.value("theta_t", radians) == within(then.at.theta, room, why));
    const double quick = room * (lambda + mu);
    CHECK(now.value("omega_rate_t", speed) == within(then.rate.omega, quick, why));
    CHECK(now.value("eta_rate_t", speed) == within(then.rate.eta, quick, why));
    CHECK(now.value("theta_rate_t", speed) == within(then.rate.theta, quick, why));
    const Balance<Fifty> of{rounded().lambda2, rounded().mu2, rounded().beta, rounded().rho};
    const Fifty all = energy(of, widened(start()));
    CHECK(now.value("energy", per_second_2) == within_relative(all, 1e-14, "some sums"));
    CHECK(now.value("energy_t", per_second_2) == within_relative(all, 1e-12, "kept, step by step"));
  }
}

CHECK_THAT("it refuses a time in which an angle might turn through 10000 radians, be it quick by the beam, "
           "the pans or a rate given")
{
  const std::string still = "omega=0 eta=0 theta=0 rho=0 beta=1e-3 ";
  for(const char* const quick :
      {"lambda=1000 omega_rate=0 eta_rate=0 theta_rate=0", "mu=1000 omega_rate=0 eta_rate=0 theta_rate=0",
       "omega_rate=-1000 eta_rate=0 theta_rate=0", "omega_rate=0 eta_rate=-1000 theta_rate=0",
       "omega_rate=0 eta_rate=0 theta_rate=-1000"})
  {
    CHECK(!refused_at(still + quick + " t=10"));
    CHECK(refused_at(still + quick + " t=10.00000000000001"));
  }
  CHECK(!refused_at(still + "lambda=250 omega_rate=0 eta_rate=0 theta_rate=0 t=40"));
  CHECK(refused_at(still + "lambda=250 omega_rate=0 eta_rate=0 theta_rate=0 t=40.00000000000001"));
}

CHECK_THAT("it refuses a time in which a slight change grows ten thousand times; after one nearly so long "
           "the state told is still that of twenty digits, but for 2e-11")
{
  for(const auto& [within_it, beyond] :
      {std::pair{"omega=80 eta=60 t=25.29", "omega=80 eta=60 t=25.33"},
       {"omega=80 eta=60 rho=0.4 t=12.35", "omega=80 eta=60 rho=0.4 t=12.37"}})
  {
    CHECK(refused_at(beyond));
    for(const Told& now : told_at(within_it))
    {
      const State<Fifty> then = oracle(rounded(), start(), t);
      const char* const why = "roundings, ten thousand times as great";
      const Unit speed{"1/s"};
      CHECK(now.value("omega_t", radians) == within(then.at.omega, 2e-11, why));
      CHECK(now.value("eta_t", radians) == within(then.at.eta, 2e-11, why));
      CHECK(now.value("theta_t", radians) == within(then.at.theta, 2e-11, why));
      CHECK(now.value("omega_rate_t", speed) == within(then.rate.omega, 2e-11, why));
      CHECK(now.value("eta_rate_t", speed) == within(then.rate.eta, 2e-11, why));
      CHECK(now.value("theta_rate_t", speed) == within(then.rate.theta, 2e-11, why));
    }
  }
}

CHECK_THAT("the accelerations told as true are those of Newton's five equations")
{
  for(const Told& now :
      told_at("", "lambda=0.9 mu=2 omega=-60 eta=80 theta=-75 rho=0.4 omega_rate=1 eta_rate=3 t=0",
              "beta=3 mu=5 omega=1e-7rad eta=2e-7rad theta=0 omega_rate=0 eta_rate=1e-6 "
              "theta_rate=-1e-7"))
  {
    const State<Fifty> wide = now_at(1);
    const State<> state{{double(wide.at.omega), double(wide.at.eta), double(wide.at.theta)},
                        {double(wide.rate.omega), double(wide.rate.eta), double(wide.rate.theta)}};
    const Angles<> right = five_equations(realised(), state).acceleration;
    const double size = std::abs(right.omega) + std::abs(right.eta) + std::abs(right.theta);
    const double allowed = 4e-14 * size + 1e-15 * mu * mu;
    const char* const why = "the instrument's numbers are rounded";
    CHECK(now.value("omega_full", per_second_2) == within(right.omega, allowed, why));
    CHECK(now.value("eta_full", per_second_2) == within(right.eta, allowed, why));
    CHECK(now.value("theta_full", per_second_2) == within(right.theta, allowed, why));
  }
}

Angles<Fifty> order_of_full(int order,
                            const State<Fifty>& now)  // the part of that order in the full equations
{
  const Fifty s("1e-12");
  const auto scaled = [&now](const Fifty& part) {
    const auto& [at, rate] = now;
    return State<Fifty>{{part * at.omega, part * at.eta, part * at.theta},
                        {part * rate.omega, part * rate.eta, part * rate.theta}};
  };
  const Angles<Fifty> plus = accelerations(given(), scaled(s)), minus = accelerations(given(), scaled(-s));
  if(order == 1)
    return {(plus.omega - minus.omega) / (2 * s), (plus.eta - minus.eta) / (2 * s),
            (plus.theta - minus.theta) / (2 * s)};
  const Fifty ss = 2 * s * s;
  return {(plus.omega + minus.omega) / ss, (plus.eta + minus.eta) / ss, (plus.theta + minus.theta) / ss};
}

CHECK_THAT("(A) is the full equations' first and second order, (1) their first and a part of the second")
{
  for(const Told& now :
      told_at("", "lambda=7 mu=0.3 beta=20 rho=0.4 omega=-60 eta=80 theta=-75 eta_rate=30 t=0",
              "rho=0 omega=1e-9 omega_rate=1e-9 eta=1e-12 theta=90 t=0",
              "omega=9 eta=9 theta=9 omega_rate=0 eta_rate=0 theta_rate=0"))
  {
    const State<Fifty> state = now_at(1);
    const Angles<Fifty> one = order_of_full(1, state), two = order_of_full(2, state);
    const char* const why = "one rounding, and the square of 1e-12";
    const auto hold = [&](const char* name, const Fifty& first, const Fifty& second) {
      CHECK(now.value(name, per_second_2)
            == within(first + second,
                      3e-16 * double(abs(first + second)) + 1e-21 * double(abs(second) + abs(first)), why));
    };
    hold("omega_second", one.omega, two.omega);
    hold("eta_second", one.eta, two.eta);
    hold("theta_second", one.theta, two.theta);
    State<Fifty> still = state;  // the pans at rest: what then drives them is the arc
    still.at.eta = still.at.theta = still.rate.eta = still.rate.theta = 0;
    const Fifty arc = order_of_full(2, still).eta;
    hold("omega_euler", one.omega, 0);
    hold("eta_euler", one.eta, two.eta - arc);
    hold("theta_euler", one.theta, two.theta + arc);
    hold("dropped", 0, arc);
    hold("kept", 0, two.eta - arc);
  }
}

CHECK_THAT("what (1) misses falls with the square of the swings and is the dropped term, what (A) misses "
           "with the cube")
{
  for(const Told& now :
      told_at("", "mu=0.7 beta=2 omega=30 eta=-10 theta=20 t=0", "omega_rate=-2 eta_rate=1 t=0"))
  {
    const Fifty arc = dropped(now_at(1));
    const State<Fifty> tiny = now_at(Fifty("1e-9"));
    const Fifty cube =
        (accelerations(given(), tiny).eta - second_order_accelerations(given(), tiny).eta) * Fifty("1e27");
    for(const auto& row : now.rows("orders"))
    {
      const Fifty s = row.at("part");
      CHECK(row.value("part") == between(1e-7, 1, "the rows' own"));
      const State<Fifty> here = now_at(s);
      const Fifty full = accelerations(given(), here).eta;
      const Fifty own = lambda.fifty() * lambda.fifty(), Mu = mu.fifty() * mu.fifty();
      const Fifty his = here.at.eta * (beta.fifty() * own * here.at.omega - Mu);
      CHECK(row.value("by_1", per_second_2) == within_relative(full - his, 1e-9, "the part is rounded"));
      CHECK(row.value("by_A", per_second_2)
            == within_relative(full - his - s * s * arc, 1e-8, "the part is rounded"));
      if(s <= 1e-3)
      {
        CHECK(row.value("by_1", per_second_2) == within_relative(s * s * arc, 100 * double(s), "the cube"));
        CHECK(row.value("by_A", per_second_2)
              == within_relative(s * s * s * cube, 100 * double(s), "the fourth"));
      }
    }
  }
}

CHECK_THAT(
    "in the figure the terms are those of (1) and (A) along the example's first order, and cancel at the "
    "start")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("terms", 9))
    {
      const double x = point.at("lambda_t") * 1_deg;
      const double lower = std::cos(2 * x), upper = std::cos(4 * x);
      CHECK(point.value("kept") == within((lower + upper) / 144, 1e-15, "waves of angles rounded"));
      CHECK(point.value("dropped") == within(-lower / 72, 1e-15, "the double angle"));
    }
}

CHECK_THAT("at μ = 3λ and m = n the dropped wave in η is twice the kept one, exactly")
{
  for(const Rational& share : {Rational(1, 2), Rational(9, 16), Rational(7)})  // a:b; i = λa/2b
  {
    const Rational l = 1, u = 3, m(1, 6), i = l * share / 2;
    const Rational lower = i * m * m / (2 * u - l), F = share * l * l * m * m / (u * u - 4 * l * l);
    // each solves its own equation η̈ + μμη = wave
    CHECK(lower * (u * u - (u - l) * (u - l)) == share * l * l * m * m / 2);
    CHECK(-F * (u * u - 4 * l * l) == -share * l * l * m * m);
    CHECK(F == 2 * lower);
  }
}

/*!
In {{eq 1}} our copy has $c$ for $a$ in I, while III, which is of the same kind, has $a$. With $c$ the pan P
would hardly feel the beam, and Q would.
*/

double term_with(double arm)  // b·ddη:2g + η by I, at η = 0.1 and ddω:2g = 0.05
{
  return -arm * 0.1 * 0.05;
}

const Emendation lost_a{"§13, the last term of I",
                        {"cη ddω", term_with(8. / 81)},
                        {"aη ddω", term_with(16. / 9)},
                        "P exceeds L by La ddω:2g, and §15 has a",
                        [](double term) {
                          const double excess = 16. / 9 * 0.05;  // of P:L, by II
                          return term == within_ulps(-excess * 0.1, 4, "two products");
                        }};

/*!
## Notes

Nothing in {{eq 1}} is wrong as a first approximation: the products are then superfluous, but do no harm. They
become a fault when conclusions of the second order are drawn from them. That happens in
{{sec balance.28}} (the pans stay at rest for ever), {{sec balance.31}} (the beam gives no motion to the pans)
and in every wave $\cos2t$ of the example in {{sec balance.35}}.
*/
