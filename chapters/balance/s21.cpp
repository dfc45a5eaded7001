#include "balance/euler.hpp"
#include "balance/instrument.hpp"
#include "balance/motion.hpp"
#include "edition/section.hpp"
#include "exact/ode.hpp"

SECTION(balance, 21, "When nothing drives the beam back")

using namespace balance;

/*!
## What Euler does

If the centre of motion $C$ were the centre of gravity itself, the beam could take up no swing at all, for it
would be in equilibrium in every position. This was noted before ({{sec balance.14}}): then

$$ c = 0, \quad f = \infty, \quad \lambda = \sqrt{\frac{2g}f} = 0. \tag{1} $$

Then each pan could swing by itself, undisturbed by the other. The formulae show it plainly, says
Euler, as the members that the beam's motion has added vanish. There remain

$$ \begin{gathered} \eta = \mathfrak A\sin(\alpha+\mu t),\\
   \vartheta = \mathfrak B\sin(\beta+\mu t),
\end{gathered} \tag{2} $$

two simple pendulums. But this holds as long as the beam remains at rest, though it may be inclined. As soon
as it has taken up any motion there is nothing to restrain it; ω will soon be too large to pass for very
small, and not even the formulae found can be used.

If $G$ is above $C$, then $c$ is negative, $f$ becomes negative too (our copy has $z$ for $f$) and λ
imaginary. All swinging is then excluded. From the least inclination the beam falls over.

::: margin
Today: neutral and unstable equilibrium; λ² passes through zero and its root becomes a rate of growth.
:::

An imaginary λ takes nothing from the formulae. With $\kappa = \sqrt{-2g:f}$ and $\lambda = \kappa\sqrt{-1}$
the beam's sines and cosines become hyperbolic. For a beam let go at $m$ and a pan at $n$, both from rest,

$$ \begin{gathered}
\omega = m\cosh\kappa t,\\ K' = \frac ab\,\frac{\kappa\kappa m}{4\mu\mu+\kappa\kappa},\\
\begin{aligned} \eta = {}&\frac n{1-K'}\Bigl[\cos\mu t\\ &\quad - K'\cos\mu t\cosh\kappa t\\
  &\quad - \frac{2\mu K'}\kappa\sin\mu t\sinh\kappa t\Bigr], \end{aligned}
\end{gathered} \tag{A} $$

and ϑ has $n'$ and $-K'$. All of it is real, and right as long as ω is small.

That the added members vanish with λ must be taken with the beam's amplitude ℭ fixed. A beam that turns with
the speed $\lambda\mathfrak C = \Omega$ keeps this speed if λ vanishes. Its ℭ is infinite then, and in the
limit the two tones of {{sec balance.17}} fall together into

$$ p = \frac{\mu a\mathfrak A\Omega}{4g}\cos(\alpha+\mu t). \tag{B} $$

It only alters 𝔄 and α, so that the pan swings as before. The dropped part of the second order adds
something that may be seen: as $A$ goes around, both pans are carried outward and swing about the lean
$a\Omega\Omega:2g$.

And is it true that a beam with $c = 0$ remains at rest while the pans swing? To the first order. To the
second the pulls of two unequally swinging pans do not balance; with the bracket of {{sec balance.13}}, the
beam being let go at $m$ and $\rho = Laa:I$,

$$ \begin{aligned} \omega - m = \rho\,\frac ba\Bigl[&m(\eta-n)\\ &- m(\vartheta-n')\\
   &- \tfrac12(\eta\eta-nn)\\ &+ \tfrac12(\vartheta\vartheta-n'n')\Bigr]. \end{aligned} \tag{C} $$

The beam trembles in the rhythm of the pans. At the third order it does more. When it stands inclined, two
pans that swing against each other swing a little faster, by the factor $1 + \rho\omega\omega$, because the
beam yields to them. Their energy goes with their frequency, if that changes slowly; so the beam needs energy
to incline, and is driven back to the level, although there is no weight to do so. It swings with the
frequency

$$ \Lambda = \frac{\rho\,\mu\,b}{a\sqrt2}\,(n - n'). \tag{D} $$

A balance with its centre of gravity in $C$ is indifferent only while its pans hang still or swing alike.

## The program
*/

const Unit per_second{"1/s"};
const auto a = real("a", 2, feet, closed(1e-3, 1e3), "CA = CB, half the beam");
const auto b = real("b", 2, feet, closed(1e-3, 1e3), "AP = BQ, the strings");
const auto c = real("c", -0.1, feet, closed(-1e3, 1e3), "CG; negative: G lies above C");
const auto k = real("k", 1.2, feet, closed(1e-3, 1e3), "the beam's radius of gyration about G");
const auto L = real("L", 0.5, none, closed(1e-3, 1e3), "weight of each pan");
const auto M = real("M", 2, none, closed(1e-3, 1e3), "weight of the beam");
const auto g = real("g", 16, feet, closed(1e-3, 1e3), "height fallen in the first second");
const auto m = angle("m", 1_deg, closed(-90_deg, 90_deg), "inclination of the beam at the start");
const auto n = angle("n", 10_deg, closed(-90_deg, 90_deg), "inclination of the string AP at the start");
const auto n1 =
    angle("n1", -4_deg, closed(-90_deg, 90_deg), "n′, inclination of the string BQ at the start");
const auto t = real("t", 3, seconds, closed(0, 100), "time");
const auto Omega = real("Omega", 0.1, per_second, closed(0, 100), "speed of a beam that turns freely");

Instrument with(double depth)
{
  return {a, b, depth, k * k, L, M, g};
}

Angles<> by_formula(double depth, double time)  // (A); (2) for c = 0; §30 for c > 0
{
  const Quantities q = quantities_of(with(depth));
  const Angles<> from{m, n, n1};
  if(depth < 0)
    return toppling<double>(q.kappa, q.mu, q.beta, from, time);
  if(depth > 0)
    return euler_corrected<double>({q.lambda, q.mu, q.i, from, q.rho}, time);
  return {m, n * std::cos(q.mu * time), n1 * std::cos(q.mu * time)};
}

TELL
{
  const Quantities q = quantities_of(with(c));
  const double squared = c < 0 ? -q.kappa * q.kappa : q.lambda * q.lambda;
  const double divisor = 4 * q.mu * q.mu - squared, reach = q.beta * m * squared;
  require(std::abs(divisor - reach) > 1e-6 * q.mu * q.mu, "c", "such that K is not 1");
  require(std::abs(divisor + reach) > 1e-6 * q.mu * q.mu, "c", "such that K is not -1");
  require(c >= 0 || q.kappa * t <= 30, "t", "such that the beam has not long fallen, at most 30/kappa");
  tell("f", q.f, feet, "f; infinite for c = 0, negative for c below it");
  if(c >= 0)
    tell("lambda", q.lambda, per_second, "λ = √(2g/f)");
  else
    tell("kappa", q.kappa, per_second, "κ = √(−2g/f), rate at which the beam falls");
  const Angles<> now = by_formula(c, t);
  tell("omega", now.omega, degrees, "ω at the time t by the formulae");
  tell("eta", now.eta, degrees, "η");
  tell("theta", now.theta, degrees, "ϑ");
  if(c < 0 && m > 0 && m < 30_deg)
    tell("falls", std::acosh(30_deg / m) / q.kappa, seconds, "time in which the beam falls to 30°, by (A)");
}

double trembles()  // (C), for c = 0
{
  const Quantities q = quantities_of(with(0));
  const double x = std::cos(q.mu * t), s = std::sin(q.mu * t),
               less = -2 * std::pow(std::sin(q.mu * t / 2), 2);
  const double squares = -s * s * (n - n1) * (n + n1) / 2;  // ½(ηη − nn) − ½(ϑϑ − n′n′), as xx − 1 = −ss
  return x == 1 ? 0 : q.rho / q.beta * (m * (n - n1) * less - squares);
}

double frequency_of_the_free_beam(double share, double pan, double ratio, double apart)  // (D)
{
  return share * pan * std::abs(apart) / (ratio * std::numbers::sqrt2);
}

TELL
{
  const double mu = std::sqrt(2 * g / b);
  tell("p", mu * a * n * Omega / (4 * g), degrees,
       "amplitude of (B), if c = 0 and the beam turns with Omega");
  tell("lean", a * Omega * Omega / (2 * g), degrees, "how far both pans then lean outward");
  tell("trembles", trembles(), arcminutes, "ω − m at the time t by (C), if c = 0 and Λt is small");
  const Quantities q = quantities_of(with(0));
  tell("Lambda", frequency_of_the_free_beam(q.rho, mu, q.beta, n - n1), per_second, "Λ by (D), if c = 0");
}

/*!
The three cases beside each other, with the full equations.
*/

const auto tame = [] {  // the full equations can be followed, and the beam has not fallen too far
  const Quantities q = quantities_of(with(-std::abs(c)));
  if(q.mu * t > 300 || q.beta > 3 || std::abs(m) * std::cosh(q.kappa * t) > 1)
    return false;
  for(const double depth : {std::abs(c), 0., -std::abs(c)})
    if(parting(numbers_of(with(depth)), released(m, n, n1), t) > 1e4)
      return false;  // neighbouring motions part
  return true;
};

TELL
{
  if(tame())
  {
    auto& rows =
        table("fates", "The balance at the time t, for G as far below C as given, in C and above it",
              {{"c", "c", feet},
               {"omega", "ω, formulae", degrees, 5},
               {"omega_full", "ω, full", degrees, 5},
               {"eta", "η, formulae", degrees, 5},
               {"eta_full", "η, full", degrees, 5}});
    for(const double depth : {std::abs(c), 0., -std::abs(c)})
    {
      const Angles<> his = by_formula(depth, t);
      const Angles<> full = Motion(numbers_of(with(depth)), released(m, n, n1)).to(t).at;
      rows.row({depth, his.omega, full.omega, his.eta, full.eta});
    }
  }
  curve("beam", {"t", "below", "in", "above", "formula"}, [](Curve& out) {  // §14's, pans hanging straight
    const auto motion = [](double depth) {
      return course(numbers_of({2, 2, depth, 1.44, 0.5, 2, 16}), released(1_deg, 0, 0), 6, 240);
    };
    const std::vector<State<>> below = motion(0.1), in = motion(0), above = motion(-0.1);
    const double kappa = quantities_of({2, 2, -0.1, 1.44, 0.5, 2, 16}).kappa;
    for(std::size_t j{0}; j < above.size(); ++j)
    {
      const double time = 6 * static_cast<double>(j) / 240;
      out.put({time, below[j].at.omega / 1_deg, in[j].at.omega / 1_deg, above[j].at.omega / 1_deg,
               std::cosh(kappa * time)});
    }
  });
}

/*!
And the beam with $G$ in $C$, for a minute, beside $m\cos\Lambda t$.
*/

const double free_n = 10_deg, free_n1 = -4_deg;  // the pans of the second figure

Balance<> free_beam()
{
  return numbers_of({2, 2, 0, 1.44, 0.5, 2, 16});
}

TELL
{
  curve("free", {"t", "full", "slow"}, [](Curve& out) {
    const Balance<> it = free_beam();
    const double slow = frequency_of_the_free_beam(it.rho, std::sqrt(it.mu2), it.beta, free_n - free_n1);
    Motion motion(it, released(1_deg, free_n, free_n1));
    for(int j = 0; j <= 1200; ++j)
    {
      const double time = j / 20.;
      out.put({time, motion.to(time).at.omega / 1_deg, std::cos(slow * time)});
    }
  });
}

/*!
With $G$ a tenth of a foot above $C$ the beam falls at the rate κ = {{kappa|5}} 1/s, from {{m}} to 30° in
{{falls|4}} s; from a tenth of $m$ it would take only $\ln10:\kappa$ longer. With $G$ in $C$ the pans let it
swing with Λ = {{Lambda|4}} 1/s.

{{table fates}}

::: figure balance-21
alt: Inclination of the beam against time, for three places of the centre of gravity. Below the pivot it
swings by one degree, in the pivot it stays, above it the beam leaves slowly, then ever faster. The formula
agrees up to some sixty degrees and then runs ahead.

The beam, let go at 1° with the pans hanging straight, with $G$ a tenth of a foot below $C$, in $C$, and a
tenth above: by the full equations, and by {{eq A}} (dashed).
:::

::: figure balance-21-free
alt: Inclination of the beam against time over a minute. A slow wave of about half a minute's period with a
fine trembling upon it; the formula runs through the middle.

A beam that nothing drives back, $G$ lying in $C$, let go at 1° while the pans swing, from 10° and −4°: the
full equations, and $m\cos\Lambda t$. In a quarter of a minute it has gone over to the other side.
:::

## Checks

A pan's equation is that of {{sec balance.17}}, in which the beam is accelerated by $-\lambda\lambda\omega$,
with whatever sign $\lambda\lambda$ has. Solved to some twenty-five digits it must arrive where the formulae
are.
*/

Fifty f_of(const Fifty& depth)  // §14
{
  return depth + k.fifty() * k.fifty() / depth
         + 2 * L.fifty() * a.fifty() * a.fifty() / (M.fifty() * depth);
}

CHECK_THAT("ω, η, ϑ are the solution of Euler's equations for c below, in and above C")
{
  for(const Told& now :
      told_at("", "a=1 b=2 c=-0.05 k=1 L=1.29875 M=1 g=9 m=0.01rad n=0.16666666666666666rad n1=-0.1rad t=5",
              "c=0 t=2", "c=-1e-300 t=4", "c=1e-14 m=-9", "c=0.4 m=-20 n=60 t=7",
              "c=-3 m=0.001 t=5 n=-30 b=0.5"))
  {
    const Fifty depth = Fifty(double(c)), G = 2 * g.fifty(), u = sqrt(G / b.fifty()),
                ratio = a.fifty() / b.fifty();
    const Fifty l2 = depth == 0 ? Fifty(0) : G / f_of(depth);  // λλ, or −κκ
    const Fifty K = ratio * m.fifty() * l2 / (4 * u * u - l2);
    const auto beam = [&](const Fifty& time) {
      const Fifty rate = sqrt(abs(l2)) * time;
      return Fifty(m.fifty() * (l2 < 0 ? cosh(rate) : cos(rate)));
    };
    const exact::RightSide right = [&](const Fifty& time, const exact::State& y) {
      const Fifty pull = ratio * l2 * beam(time) * cos(u * time);
      return exact::State{y[1], n.fifty() / (1 + K) * pull - u * u * y[0], y[3],
                          -n1.fifty() / (1 - K) * pull - u * u * y[2]};
    };
    const exact::State end =
        exact::solve(right, 0, {n.fifty(), 0, n1.fifty(), 0}, t.fifty(), Fifty("1e-26")).y;
    const double phases = 1e-15 * (2 + double(u) * t + double(sqrt(abs(l2))) * t);
    const double swing = phases * (1 + double(ratio * abs(beam(t.fifty())))) * (std::abs(n) + std::abs(n1));
    const char* const why = "phases from rounded frequencies";
    CHECK(now.value("omega", degrees) == within_relative(beam(t.fifty()), 2 * phases, why));
    CHECK(now.value("eta", degrees) == within(end[0], swing, why));
    CHECK(now.value("theta", degrees) == within(end[2], swing, why));
    if(c == 0)
    {
      CHECK(now.value("f", feet) == infinite("G lies in C"));
      CHECK(now.value("lambda", per_second) == within(0, 0, "nothing drives it back"));
      continue;
    }
    CHECK(now.value("f", feet) == within_relative(f_of(depth), 1e-15, "few roundings"));
    if(c > 0)
      CHECK(now.value("lambda", per_second) == within_relative(sqrt(l2), 1e-15, "few roundings"));
    else
    {
      CHECK(now.value("kappa", per_second) == within_relative(sqrt(-l2), 1e-15, "few roundings"));
      const Fifty times = exact::pi() / 6 / m.fifty();
      CHECK(now.value("falls", seconds)
            == within_relative(log(times + sqrt(times * times - 1)) / sqrt(-l2), 1e-15, "few roundings"));
    }
  }
}

CHECK_THAT("(A) is Euler's formula of § 30 with an imaginary λ: between the two there is no gap at c = 0")
{
  for(const char* const small : {"1e-8", "1e-12"})
  {
    const Fifty e(small), u = 3, ratio = Fifty(1) / 2;  // λ = e, or κ = e
    const Angles<Fifty> from{Fifty("0.1"), Fifty("0.2"), Fifty("-0.3")};
    const Angles<Fifty> over = toppling<Fifty>(e, u, ratio, from, 7),
                        under = euler_corrected<Fifty>({e, u, ratio * e / 2, from, 0}, 7);
    const double square = double(e * e);
    CHECK(over.omega == within(under.omega, 10 * square, "49 squares of it"));
    CHECK(over.eta == within(under.eta, square, "a part of its square"));
    CHECK(over.theta == within(under.theta, square, "a part of its square"));
    CHECK(abs(over.omega - from.omega) > square);
  }
}

CHECK_THAT("K = 1 and K = −1 are refused, and what is as near in the divisor as a millionth of μμ, and no "
           "more")
{
  for(const char* const one : {"b=20 c=0.821557135", "b=20 c=0.8215574", "b=20 c=0.821557737",
                               "b=20 c=0.825845242", "b=20 c=0.8258455", "b=20 c=0.825845849",
                               "a=20 L=0.01 m=-90 c=-0.83441048", "a=20 L=0.01 m=-90 c=-0.83441101"})
    CHECK(refused_at(one));
  for(const char* const beside :
      {"b=20 c=0.821557125", "b=20 c=0.821557746", "b=20 c=0.825845231", "b=20 c=0.825845859",
       "a=20 L=0.01 m=-90 c=-0.83441046", "a=20 L=0.01 m=-90 c=-0.83441103"})
    CHECK(!refused_at(beside));
}

CHECK_THAT("a beam falling at the rate 1 is followed for 30 seconds, at 2 for 15, one that does not fall "
           "for a hundred")
{
  const std::string falling = "a=1 c=-1 k=1 L=1 M=1 g=";
  for(const char* const until : {"2 t=30.000000000000004", "8 t=15.000000000000002"})
    CHECK(refused_at(falling + until));
  for(const char* const until : {"2 t=30", "8 t=15", "2 t=100 c=0", "2 t=100 c=1"})
    CHECK(!refused_at(falling + until));
}

CHECK_THAT("(B) is what the two tones of § 17 tend to when λ vanishes and λℭ does not; the lean is where "
           "no force is left")
{
  for(const Told& now : told_at("", "Omega=3 a=0.2 b=7 n=-60 g=4", "Omega=0.01 a=900 g=1e3"))
  {
    const Fifty G = 2 * g.fifty(), u = sqrt(G / b.fifty()), e("1e-30");
    const Fifty i = i_of<Fifty>(e, u, a.fifty(), g.fifty());
    const auto [M_, N_] = sidebands<Fifty>(e, u, i, n.fifty(), Fifty(Omega.fifty() / e));
    CHECK(now.value("p", degrees) == within_relative((M_ + N_) / 2, 1e-15, "few roundings"));
    const Fifty lean = a.fifty() * Omega.fifty() * Omega.fifty() / G;
    CHECK(now.value("lean", degrees) == within_relative(lean, 1e-15, "few roundings"));
    // by the full equations for c = 0, at a speed that makes squares negligible
    const Fifty slow("1e-15"), small = lean * slow * slow;
    const Balance<Fifty> free{0, u * u, a.fifty() / b.fifty(), Fifty(1) / 4};
    const Angles<Fifty> force =
        accelerations<Fifty>(free, {{0, small, -small}, {slow * Omega.fifty(), 0, 0}});
    CHECK(force.eta == within(0, double(u * u * small) * 1e-20, "the cube"));
    CHECK(force.theta == within(0, double(u * u * small) * 1e-20, "the cube"));
  }
}

CHECK_THAT("(C) is the second order of the full equations for c = 0, and the beam trembles by their square")
{
  for(const Told& now : told_at("", "m=20 n=-8 n1=0.5 t=11", "n=5 n1=5 m=4", "n=0 n1=3 b=9 t=77 c=0"))
  {
    const Fifty u = sqrt(2 * g.fifty() / b.fifty()), ratio = a.fifty() / b.fifty(),
                Laa = L.fifty() * a.fifty() * a.fifty();
    const Fifty share = Laa / (M.fifty() * k.fifty() * k.fifty() + 2 * Laa);
    const auto moved = [&](const Fifty& part) {
      const Fifty s("1e-10");
      const State<Fifty> now_at{{part * m.fifty() * s, part * n.fifty() * s * cos(u * t.fifty()),
                                 part * n1.fifty() * s * cos(u * t.fifty())},
                                {0, -part * n.fifty() * s * u * sin(u * t.fifty()),
                                 -part * n1.fifty() * s * u * sin(u * t.fifty())}};
      return Fifty(accelerations<Fifty>({0, u * u, ratio, share}, now_at).omega / (s * s));
    };
    // the second rate of (C) by differences, against the full equations' second order
    const auto tremble = [&](const Fifty& time) {
      const Fifty x = cos(u * time), e = n.fifty() * x, th = n1.fifty() * x;
      const Fifty squares = e * e - n.fifty() * n.fifty() - th * th + n1.fifty() * n1.fifty();
      return Fifty(share / ratio * (m.fifty() * (e - n.fifty() - th + n1.fifty()) - squares / 2));
    };
    const Fifty T = t.fifty(), h("1e-12");
    const Fifty second = (tremble(T + h) - 2 * tremble(T) + tremble(T - h)) / (h * h);
    CHECK((moved(1) + moved(-1)) / 2 == within(second, 1e-8, "even part, and differences"));
    const double size = double(abs(m.fifty() * (n.fifty() - n1.fifty()))) + n * n + n1 * n1;
    CHECK(now.value("trembles", arcminutes)
          == within(tremble(T), size * 1e-15 * (3 + double(u) * t), "phases from rounded frequencies"));
  }
}

CHECK_THAT("the table's full motions are those of GSL")
{
  for(const Told& now : told_at("", "c=0.02 m=-3 n=1 n1=7 t=6", "m=0.1 a=1 b=3 L=2 t=4"))
    for(const auto& row : now.rows("fates"))
    {
      const double depth = row.at("c", feet);
      CHECK(row.value("c", feet) == between(-std::abs(c), std::abs(c), "the three"));
      const Angles<> full = by_gsl(numbers_of(with(depth)), released(m, n, n1), t, 1e-13).at;
      CHECK(row.value("omega_full", degrees)
            == within(full.omega, 3e-11, "GSL's tolerance, and the fall's growth"));
      CHECK(row.value("eta_full", degrees) == within(full.eta, 3e-11, "the same"));
      const Quantities q = quantities_of(with(std::abs(depth)));
      const double phase = (depth == 0 ? 0 : q.lambda) * t;
      CHECK(row.value("omega", degrees)
            == within_relative(depth < 0 ? cosh(Fifty(phase)) * m.fifty() : cos(Fifty(phase)) * m.fifty(),
                               1e-14 * (1 + std::abs(std::tan(phase))), "the phase is rounded"));
      const Angles<> small = small_motion(numbers_of(with(depth)), released(m, n, n1), t);
      CHECK(row.value("eta", degrees)
            == within(small.eta, 2 * q.beta * std::abs(m * n) * q.lambda / q.mu * std::cosh(q.lambda * t),
                      "what the beam adds, twice"));
    }
}

CHECK_THAT("in the figure the beam moves as GSL has it, and the formula overtakes it beyond sixty degrees")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("beam", 7))
    {
      const double time = point.at("t");
      const auto hold = [&](const char* column, double depth) {
        const Balance<> it = numbers_of({2, 2, depth, 1.44, 0.5, 2, 16});
        const double omega = time == 0 ? 1_deg : by_gsl(it, released(1_deg, 0, 0), time, 1e-13).at.omega;
        CHECK(point.value(column) == within(omega / 1_deg, 1e-8, "GSL's tolerance, and the fall's growth"));
      };
      hold("below", 0.1);
      hold("in", 0);
      hold("above", -0.1);
      const Fifty kappa = sqrt(Fifty(32) / Fifty("34.5"));
      CHECK(point.value("formula") == within_relative(cosh(kappa * Fifty(time)), 1e-14, "a phase rounded"));
    }
  const auto falls = [](double time) {
    return by_gsl(numbers_of({2, 2, -0.1, 1.44, 0.5, 2, 16}), released(1_deg, 0, 0), time, 1e-12).at.omega
           / 1_deg;
  };
  const double kappa = std::sqrt(32 / 34.5);
  CHECK(std::cosh(kappa * 5) / falls(5) == between(0.98, 1.02, "agrees near sixty degrees"));
  CHECK(falls(5) == between(55, 65, "near sixty"));
  CHECK(std::cosh(kappa * 6) / falls(6) == between(1.1, 3, "runs ahead"));
}

double mean(Motion& motion, double from)  // of ω over a period of the pans
{
  double sum = 0;
  for(int j = 0; j < 64; ++j)
    sum += motion.to(from + j * std::numbers::pi / 2 / 64).at.omega;
  return sum / 64;
}

CHECK_THAT("(D): after half of that period the beam with c = 0 stands on the other side, after the whole "
           "it is back")
{
  const Balance<> it = free_beam();
  const double middle = std::numbers::pi / 4;  // half a period of the pans
  for(const double part : {1., 0.25})
    for(const double other : {-4_deg, 4_deg})
    {
      const double n_ = part * 10_deg, n1_ = part * other, m_ = part * part * 1_deg;
      const double slow = frequency_of_the_free_beam(it.rho, 4, it.beta, n_ - n1_);
      Motion motion(it, released(m_, n_, n1_));
      const double first = mean(motion, 0);
      const double opposite = mean(motion, std::numbers::pi / slow - middle);
      const double back = mean(motion, 2 * std::numbers::pi / slow - middle);
      CHECK(opposite / m_ == within(-1, 0.08 * part + 0.002, "a part of the order of the pans' angles"));
      CHECK(back / first == within(1, 0.02 * part, "a part of the order of the pans' angles"));
    }
  // the factor 1 + ρωω: c = 0, the beam at 1/100 and free to yield, the pans a trifle apart
  const Fifty w = Fifty(1) / 100, apart("1e-20"), share = Fifty(1) / 4;
  const Angles<Fifty> drawn = accelerations<Fifty>({0, 1, Fifty(1) / 2, share}, {{w, apart, -apart}, {}});
  CHECK(sqrt((drawn.theta - drawn.eta) / (2 * apart))
        == within(1 + share * w * w, 1e-8, "the fourth power"));
  Motion alike(it, released(1_deg, 10_deg, 10_deg));
  CHECK(alike.to(60).at.omega == within(1_deg, 1e-10, "pans that swing alike do not move it"));
}

CHECK_THAT("Λ told is (D), and in the figure the slow wave is its cosine, the full motion GSL's")
{
  for(const Told& now : told_at("", "a=0.3 b=7 c=0 k=5 L=3 M=0.1 g=4.9 n=-20 n1=60 t=0.1", "n1=10 t=1"))
  {
    const Fifty Laa = L.fifty() * a.fifty() * a.fifty();
    const Fifty share = Laa / (M.fifty() * k.fifty() * k.fifty() + 2 * Laa);
    const Fifty square = share * share * g.fifty() * b.fifty() / (a.fifty() * a.fifty());  // ½ρρμμbb:aa
    CHECK(now.value("Lambda", per_second)
          == within(sqrt(square) * abs(n.fifty() - n1.fifty()), 1e-15 * double(sqrt(square)),
                    "few roundings"));
  }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("free", 9))
    {
      const double time = point.at("t");
      if(time == 0)
        continue;
      const double omega = by_gsl(free_beam(), released(1_deg, free_n, free_n1), time, 1e-13).at.omega;
      CHECK(point.value("full")
            == within(omega / 1_deg, 1e-8, "GSL's tolerance, and nothing drives it back"));
      const Fifty slow = Fifty(1) / Fifty("3.44") * 4 * 14 * exact::pi() / 180 / sqrt(Fifty(2));
      CHECK(point.value("slow") == within(cos(slow * Fifty(time)), 1e-13, "a phase of 12"));
    }
}

CHECK_THAT("a tenth of the inclination takes ln 10 : κ longer to fall, to its square")
{
  const double kappa = std::sqrt(32 / 34.5);
  for(const Told& now : told_at("m=0.1"))
    CHECK(now.value("falls", seconds)
          == within(std::acosh(30.) / kappa + std::log(10.) / kappa, 1e-3, "the square of 1/30"));
}

/*!
## Notes

Equilibrium in every position needs more than $c = 0$: the points $A$, $C$, $B$ must lie in a line and the
pans must weigh the same. If $A$ and $B$ lie a little below $C$ the weights of the pans drive the beam back
({{sec balance.37}}), and with unequal pans the heavier sinks to the lowest place ({{sec balance.02}}).
*/
