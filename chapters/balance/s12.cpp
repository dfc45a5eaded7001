#include "balance/instrument.hpp"
#include "balance/motion.hpp"
#include "edition/section.hpp"

SECTION(balance, 12, "The five equations for small angles, and the tensions")

using namespace balance;

/*!
## What Euler does

For small angles the five equations become so simple that the two tensions can be read off. With the
coordinates of {{sec balance.11}}, the sines being the angles and the cosines unity, they take these forms:

$$ \begin{aligned}
\text{I.}&\quad \frac{b\,dd\eta}{2g\,dt^2} = -\frac{P\eta}L,\\
\text{II.}&\quad {-\frac{a\,dd\omega}{2g\,dt^2}} = 1{{entry unity}} - \frac PL,\\
\text{III.}&\quad {-\frac{b\,dd\vartheta}{2g\,dt^2}} = +\frac{Q\vartheta}L,\\
\text{IV.}&\quad {+\frac{a\,dd\omega}{2g\,dt^2}} = 1 - \frac QL,\\
\text{V.}&\quad \frac{dd\omega}{2g\,dt^2} = \frac{-Mc\,\omega - Pa + Qa}{M(kk+cc)}{{entry minus_again}}.
\end{aligned} \tag{1} $$

The second and the fourth give both tensions at once:

$$ \begin{gathered} P = L + \frac{La\,dd\omega}{2g\,dt^2},\\
   Q = L - \frac{La\,dd\omega}{2g\,dt^2}.
\end{gathered} \tag{2} $$

So the strings pull with the pans' weights, a little more or less as the end of the beam goes up faster or
slower. With the beam's equation, $dd\omega:2g\,dt^2 = -\omega:f$ ({{sec balance.14}}), the excess is $\mp
a\omega:f$ in weights of a pan.

::: margin
Today: expand in powers of a smallness ε and keep equal powers. II and IV to first order, V to
second do not go together.
:::

Right to the first order of the angles, {{eq 2}} will be used at the second: in I and III the tension is
multiplied by η or ϑ, and there the first order suffices; but in V the tensions themselves stand, and there
that order is the last which is right. To the {{term second order}}

$$ \begin{gathered} \frac PL = 1 + \frac{a\ddot\omega + b\dot\eta^2}{2g} - \tfrac12\eta^2,\\
   \frac QL = 1 - \frac{a\ddot\omega - b\dot\vartheta^2}{2g} - \tfrac12\vartheta^2,
\end{gathered} \tag{A} $$

with $\ddot\omega$ to that order. Every pendulum pulls with less than its weight where it turns, and
with more where it passes the vertical. Such parts are of the second order, that of the beam is of the first;
yet in Euler's example, at ten degrees, they are more than what the beam does.

## The program

The balance of {{sec balance.35}} is given. The motion is that of the full equations.
*/

const auto a = real("a", 16. / 9, feet, closed(0.1, 10), "CA = CB, half the beam");
const auto b = real("b", 32. / 9, feet, closed(0.1, 10), "AP = BQ, the strings");
const auto c = real("c", 8. / 81, feet, closed(0.01, 10), "CG, depth of the beam's centre of gravity");
const auto k = real("k", 1.2532, feet, closed(0.1, 10), "the beam's radius of gyration about G");
const auto L = real("L", 1, none, closed(0.01, 10), "weight of each pan");
const auto M = real("M", 4, none, closed(0.1, 10), "weight of the beam");
const auto g = real("g", 16, feet, closed(0.1, 100), "height fallen in the first second");
const auto omega = angle("omega", 1. / 6, closed(-30_deg, 30_deg), "inclination ω of the beam");
const auto eta = angle("eta", 1. / 6, closed(-30_deg, 30_deg), "inclination η of the string AP");
const auto theta = angle("theta", 1. / 6, closed(-30_deg, 30_deg), "inclination ϑ of the string BQ");
const auto omega_rate = real("omega_rate", 0, Unit{"1/s"}, closed(-5, 5), "dω/dt");
const auto eta_rate = real("eta_rate", 0, Unit{"1/s"}, closed(-5, 5), "dη/dt");
const auto theta_rate = real("theta_rate", 0, Unit{"1/s"}, closed(-5, 5), "dϑ/dt");

const auto given = [] { return Instrument{a, b, c, k * k, L, M, g}; };
const auto start = [] { return State<>{{omega, eta, theta}, {omega_rate, eta_rate, theta_rate}}; };

Tensions<> first_order(const Balance<>& x, const Angles<>& at)  // (2)
{
  const double pull = x.beta / x.mu2 * (-x.lambda2 * at.omega);  // a ddω/(2g dt²)
  return {1 + pull, 1 - pull};
}

template <class Number>
Tensions<Number> second_order_tensions(const Balance<Number>& x, const State<Number>& now)  // (A)
{
  const auto& [at, rate] = now;
  const Number pull = x.beta * second_order_accelerations(x, now).omega / x.mu2;
  return {1 + pull + rate.eta * rate.eta / x.mu2 - at.eta * at.eta / 2,
          1 - pull + rate.theta * rate.theta / x.mu2 - at.theta * at.theta / 2};
}

TELL
{
  const Balance<> x = numbers_of(given());
  const Tensions<> first = first_order(x, start().at), second = second_order_tensions(x, start()),
                   exact = tensions(x, start());
  tell("P_first", first.P, "P/L by (2)", 14);
  tell("Q_first", first.Q, "Q/L by (2)", 14);
  tell("P_second", second.P, "P/L by (A)", 13);
  tell("Q_second", second.Q, "Q/L by (A)", 13);
  tell("P", exact.P, "P/L exactly", 13);
  tell("Q", exact.Q, "Q/L exactly", 13);
  tell("P_moved", first.P - 1, percent, "by how much the beam alters P, by (2)", 12);
  tell("P_missing", exact.P - first.P, percent, "what (2) leaves out of P", 10);
}

TELL
{
  curve("pulls", {"lambda_t", "first", "second", "exact"}, [](Curve& out) {
    const Balance<> x = numbers_of(given());
    const double period = 2 * std::numbers::pi / std::sqrt(x.lambda2);
    int degree = 0;
    for(const State<>& now : course(x, start(), period, 360))
      out.put({double(degree++), first_order(x, now.at).P, second_order_tensions(x, now).P,
               tensions(x, now).P});
  });
}

/*!
When Euler's example begins, all three angles being a sixth of the radius, {{eq 2}} has $P =$ {{P_first|6}}
and $Q =$ {{Q_first|6}}, a part in 108 less and more than the weight. The strings really pull with {{P|6}} and
{{Q|6}}. What is left out of $P$, {{P_missing|percent2}}, outweighs what is taken in, {{P_moved|percent2}}.

::: figure balance-12
alt: Three curves of P over one swing of the beam. By the first order a slow wave of one per cent. The exact
pull goes up and down six times, by several per cent; points of the second order lie on it.

The pull of the string $AP$ in weights of the pan, in Euler's example. {{eq 2}} has only the slow wave that
comes from the beam; the pan's own swing makes the greater one, with twice its frequency.
:::

## Checks
*/

struct Exactly
{
  Tensions<Fifty> first, second, exact;
};

Exactly in_fifty()
{
  const Fifty A = double(a), B = double(b), G = 2 * Fifty(double(g)), W = double(L), m = double(M),
              C = double(c);
  const Fifty kk = given().kk, I = m * (kk + C * C) + 2 * W * A * A;
  const State<Fifty> now = widened(start());
  const auto& [at, rate] = now;
  const Fifty beam =
      -m * C * at.omega / I;  // ddω/(2g dt²) of the first order, and what V adds in the second:
  const Fifty of_P = B * rate.eta * rate.eta / G - at.eta * at.eta / 2;
  const Fifty of_Q = B * rate.theta * rate.theta / G - at.theta * at.theta / 2;
  // the pulls' second order, and the arms' shortening by cos(ω − η) and cos(ω − ϑ) against the weights
  const auto shorter = [](const Fifty& x) { return Fifty(x * x / 2); };
  const Fifty more = W * A * (of_Q - of_P + shorter(at.omega - at.eta) - shorter(at.omega - at.theta)) / I;
  return {{1 + A * beam, 1 - A * beam},
          {1 + A * (beam + more) + of_P, 1 - A * (beam + more) + of_Q},
          tensions(widened(given()), now)};
}

CHECK_THAT("the tensions told are Euler's, those of the second order, and those of the full equations")
{
  for(const Told& now :
      told_at("", "omega=-20 eta=30 theta=3 omega_rate=1 eta_rate=-2 theta_rate=5 L=9 M=0.3",
              "a=0.1 b=9 c=3 omega=1e-9 eta=0 theta=-1e-3 eta_rate=1e-4", "g=0.1 k=9 b=0.2"))
  {
    const Exactly is = in_fifty();
    const double size = 1 + double(abs(is.exact.P) + abs(is.exact.Q));
    const double room = 2e-14 * size * (1 + L / M);
    const char* const why =
        "some thirty roundings; a light beam between heavy pans is what is left of both";
    CHECK(now.value("P_first") == within(is.first.P, 2e-15, "a dozen roundings"));
    CHECK(now.value("Q_first") == within(is.first.Q, 2e-15, "the same"));
    CHECK(now.value("P_second") == within(is.second.P, room, why));
    CHECK(now.value("Q_second") == within(is.second.Q, room, why));
    CHECK(now.value("P") == within(is.exact.P, room, why));
    CHECK(now.value("Q") == within(is.exact.Q, room, why));
    CHECK(now.value("P_moved", percent) == within(is.first.P - 1, 2e-15, "a difference"));
    CHECK(now.value("P_missing", percent) == within(is.exact.P - is.first.P, room, why));
  }
  for(const Told& now : told_at(""))
  {
    CHECK(now.value("P_first") == within(1 - Fifty(1) / 108, 1e-6, "k is given with five digits"));
    const Exactly is = in_fifty();
    const bool more = abs(is.exact.P - is.first.P) > abs(is.first.P - 1);  // left out than taken in
    CHECK(more);
  }
}

CHECK_THAT(
    "(1): on the true motion each of the five is off by the second order, and (2) too; (A) by the third")
{
  const Balance<Fifty> x = widened(given());
  const Fifty A = double(a), B = double(b), G = 2 * Fifty(double(g)), W = double(L), m = double(M);
  const Fifty inertia = m * (Fifty(given().kk) + Fifty(double(c)) * double(c));
  const auto off =
      [&](const Fifty& s) {  // of I to V, (2), (A), at the angles 0.1, 0.17, −0.12 and rates, times s
        const State<Fifty> now{{0.1 * s, 0.17 * s, -0.12 * s}, {0.3 * s, -0.2 * s, 0.4 * s}};
        const Angles<Fifty> to = accelerations(x, now);
        const auto [P, Q] = tensions(x, now);
        const Tensions<Fifty> later = second_order_tensions(x, now);
        const Fifty excess = -x.beta * x.lambda2 * now.at.omega / x.mu2;
        return std::array<Fifty, 7>{B * to.eta / G + P * now.at.eta,
                                    -A * to.omega / G - 1 + P,
                                    -B * to.theta / G - Q * now.at.theta,
                                    A * to.omega / G - 1 + Q,
                                    inertia * to.omega / G + m * double(c) * now.at.omega + W * A * (P - Q),
                                    P - 1 - excess,
                                    P - later.P};
      };
  const auto at_one = off(Fifty("1e-9")), at_half = off(Fifty("5e-10"));
  for(const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{4},
                             std::size_t{5}, std::size_t{6}})
    CHECK(at_one[i] / at_half[i] == within(i < 6 ? 4 : 8, 1e-7, "the next order"));
}

CHECK_THAT("the figure's pulls are those of the motion that GSL finds")
{
  for(const Told& now : told_at("", "omega=20 eta=5 theta=-10 eta_rate=1", "L=3 eta=0 theta=0"))
  {
    const Balance<> x = numbers_of(given());
    for(const auto& point : now.points("pulls", 5))
    {
      const double time = point.at("lambda_t") * 1_deg / std::sqrt(x.lambda2);
      const State<> there = time > 0 ? by_gsl(x, start(), time, 1e-13) : start();
      CHECK(point.value("first") == within(first_order_tensions(x, there.at).P, 1e-10, "GSL's tolerance"));
      CHECK(point.value("second") == within(second_order_tensions(x, there).P, 1e-10, "the same"));
      CHECK(point.value("exact") == within(five_equations(given(), there).tension.P, 1e-10, "the same"));
    }
  }
}

/*!
Over a long time a string lifts its pan no more than the pan falls: whatever the tension does in between, its
vertical part has the pan's weight for its mean. II, integrated, says by how much it may differ.
*/

CHECK_THAT(
    "the vertical part of P, added up over the time, is the weight but for the pan's speed at the end")
{
  for(const Told& now : told_at("", "omega=20 eta=5 theta=-10 eta_rate=1"))
  {
    const Balance<> x = numbers_of(given());
    const int parts = 20000;
    const double until = 40;
    const auto all = course(x, start(), until, parts);
    double sum = 0;
    for(std::size_t i = 0; i < all.size(); ++i)  // Simpson's rule
      sum += (i == 0 || i + 1 == all.size() ? 1
              : i % 2 == 1                  ? 4
                                            : 2)
             * tensions(x, all[i]).P * std::cos(all[i].at.eta);
    const double lifted = sum * until / parts / 3;
    const auto falls = [](const State<>& s) {  // dy/dt
      return -b * s.rate.eta * std::sin(s.at.eta) - a * s.rate.omega * std::cos(s.at.omega);
    };
    CHECK(lifted
          == within(until - (falls(all.back()) - falls(all.front())) / (2 * g), 1e-9, "Simpson's rule"));
    CHECK(lifted / until == within(1, 0.002, "the speed's share vanishes with the time"));
    CHECK(now.value("P") == between(0.5, 1.5, "in between it differs"));
  }
}

/*!
In II and IV our copy has a letter, probably the ϑ of the line above, for unity; and in V the minus before the
whole fraction, as in {{sec balance.09}}. There, with {{eq 2}}, the length $f$ would come out wrong.
*/

const Emendation unity{"§12, II and IV, what P/L is subtracted from",
                       {"ϑ, in a balance that is at rest 0", 0},
                       {"1", 1},
                       "(2) follows from it; of a balance at rest a string pulls with the pan's weight",
                       [](double pull) { return pull == within_ulps(1, 1, "P/L at rest"); }};

double length(int sign)  // f from V and (2): [M(kk + cc) ± 2Laa] : Mc
{
  const Instrument& x = light_pans;
  return (x.M * (x.kk + x.c * x.c) + sign * 2 * x.L * x.a * x.a) / (x.M * x.c);
}

const Emendation minus_again{
    "§12, V, the minus; with (2) the length f for M = 2, L = ½, a = 2, kk = 4/3, c = 0.1",
    {"before the whole fraction", [] { return length(-1); }},
    {"before Mcω alone", [] { return length(1); }},
    "the full equations, at an inclination of 1e-12, accelerate the beam as such a pendulum",
    [](double f) {
      const State<Fifty> tilted{{Fifty("1e-12"), 0, 0}, {}};
      const Fifty beam = accelerations(widened(light_pans), tilted).omega;
      return f
             == within_relative(-2 * Fifty(light_pans.g) * tilted.at.omega / beam, 1e-14,
                                "a dozen roundings");
    }};
