#include "balance/causes.hpp"
#include "balance/hung.hpp"
#include "balance/motion.hpp"
#include "balance/scene.hpp"
#include "balance/small_swings.hpp"
#include "edition/section.hpp"
#include "swing/oracle.hpp"

SECTION(balance, 38, "The true cause: the pivot itself can move")

using namespace balance;

/*!
## What Euler does

The cause is found in what the calculation took for granted: that the pivot $C$ stands still. When all is
weighed, Euler says, it is not hard to see why the motion of the beam can set no pan swinging. Its ends $A$
and $B$ move only up and down {{entry only_vertically}}, and what moves so cannot push a pan sideways. Let
$C$ receive some horizontal motion, and both ends have it too; then the pans must be driven to swing. And so
it is in balances: they do not hang from $C$, but by the shears from a point much higher. The rough push that
set the one pan going will have moved the whole balance about that point, and the ends of the beam sideways
as well as up and down. From this, he adds, one sees already why the pans should rest and swing by turns. The
full treatment he means to attempt on another occasion.

This section makes it. The conclusion is right, though two of its grounds are not quite. The ends do move
sideways, by $a(1-\cos\omega)$ against $a\sin\omega$ up and down; the ratio is $\tan\frac12\omega$, small but
not nothing. And no rough push is needed, since the swinging pan itself pulls at $C$.

Let $C$ hang from a fixed point $O$ by weightless shears of the length $h$, inclined by $\varphi$ towards the
side of $A$. With $I = M(kk+cc)+2Laa$, the kinetic energy, $2g$ times, is

$$ \begin{aligned}
&\tfrac12(M+2L)hh\,\dot\varphi^2 + \tfrac12I\dot\omega^2\\
&+ \tfrac12Lbb(\dot\eta^2+\dot\vartheta^2)\\ &+ Mhc\cos(\varphi-\omega)\,\dot\varphi\dot\omega\\
&+ Lhb\,\dot\varphi\bigl(\cos(\varphi-\eta)\,\dot\eta\\
 &\qquad + \cos(\varphi-\vartheta)\,\dot\vartheta\bigr)\\
&- Lab\,\dot\omega\bigl(\sin(\omega-\eta)\,\dot\eta\\
 &\qquad - \sin(\omega-\vartheta)\,\dot\vartheta\bigr),
\end{aligned} \tag{A} $$

and the weights have the potential

$$ \begin{gathered} -(M+2L)h\cos\varphi - Mc\cos\omega\\
   {}- Lb(\cos\eta+\cos\vartheta).
\end{gathered} \tag{B} $$

For small swings one motion is simple: the pans against each other, $\eta=-\vartheta$, with the frequency μ
while $C$ and the beam rest. The others have $\eta=\vartheta$. With $\nu\nu = 2g/h$, the frequency of the
shears if nothing else moved, and

$$ \varepsilon = \frac{2L}{M+2L}, \qquad \kappa^2 = \frac{M^2c^2}{(M+2L)I}, $$

their squares $s=\sigma^2$ are the roots of a cubic,

$$ \begin{gathered} (\nu^2-s)(\lambda^2-s)(\mu^2-s)\\
   {}= s^2\kappa^2(\mu^2-s) + s^2\varepsilon(\lambda^2-s).
\end{gathered} \tag{C} $$

As $c$ is small, so is κ, and the beam hardly takes part: what remains is
$(\nu^2-s)(\mu^2-s)=\varepsilon s^2$, two pendulums, the one of both pans and the one of the shears. The root
σ next to μ differs from it. A pan that swings alone is half the one motion and half the other; the halves get
out of step, and after the time

$$ T = \frac{\pi}{|\sigma-\mu|} \approx \frac{2\pi\,|\mu^2-\nu^2|}{\varepsilon\mu^3} \tag{D} $$

they make up the other pan swinging alone. The coupling is of the first order, so that $T$ does not depend on
how wide the swings are, as long as they are small.

::: margin
Today: normal modes and beats; $\varphi$ is eliminated like a mediator between two oscillators in resonance.
:::

Two things limit the exchange. One lies in the amplitude. A pendulum that swings by $n$ is slower by
$\frac1{16}nn$ ({{sec balance.04}}), so that the pan with the motion and the pan without are out of tune.
Weigh this against the coupling, and the exchange is complete only below a certain swing, and takes the longer
the nearer one is to it:

$$ \begin{gathered} n_c = \sqrt{\frac{32\,|\sigma-\mu|}\mu},\\
   T_n = T\cdot\frac2\pi K(k), \quad k = \frac{n^2}{n_c^2}, \end{gathered} \tag{E} $$

$K$ being the complete elliptic integral. Beyond $n_c$ the motion stays where it is, and Q never has more than
$\sqrt{\frac12-\frac12\sqrt{1-1:k^2}}$ of it.

The other lies in the strings. If Q's is the longer by the part $d$, its frequency is lower by about
$\frac12d\mu$, and two oscillators so far out of tune exchange but a part; of the swing

$$ \frac{1}{\sqrt{1+\delta^2}}, \qquad \delta = \frac{d\mu}{2\,|\sigma-\mu|}, \tag{F} $$

if other motions are left aside. With them it is the sum over the modes of {{api balance::handed_on}}.

## The program

The modes are {{api balance::modes}}, the times {{api balance::transfer}}; the full equations of (A) and (B)
are carried on by {{api balance::Full_motion}}. The instrument given was designed for this section: its four
frequencies are to each other as 5, 13, 20 and 21.
*/

const auto M = real("M", designed.beam.M, none, closed(0.01, 1e4), "weight of the beam");
const auto L = real("L", 1, none, closed(0.01, 100), "weight of each pan");
const auto a = real("a", 2, feet, closed(0.1, 100), "half the beam");
const auto b = real("b", 2, feet, closed(0.1, 100), "length of the strings");
const auto c = real("c", designed.beam.c, feet, closed(1e-4, 10), "depth of the beam's centre of gravity");
const auto k =
    real("k", 1.1547005383792515, feet, closed(0.03, 100), "the beam's radius of gyration about G");
const auto h = real("h", designed.h, feet, closed(0.01, 1000), "length of the shears");
const auto g = real("g", 16, feet, closed(0.1, 100), "height fallen in the first second");
const auto eta = angle("eta", 10_deg, closed(-30_deg, 30_deg), "inclination of the pan P at the start");
const auto theta = angle("theta", 0_deg, closed(-30_deg, 30_deg), "of the pan Q");
const auto omega = angle("omega", 0_deg, closed(-20_deg, 20_deg), "of the beam");
const auto phi = angle("phi", 0_deg, closed(-20_deg, 20_deg), "of the shears");
const auto eta_rate = real("eta_rate", 0, Unit{"1/s"}, closed(-1, 1), "how fast η changes at the start");
const auto theta_rate = real("theta_rate", 0, Unit{"1/s"}, closed(-1, 1), "how fast ϑ does");
const auto omega_rate = real("omega_rate", 0, Unit{"1/s"}, closed(-1, 1), "how fast ω does");
const auto phi_rate = real("phi_rate", 0, Unit{"1/s"}, closed(-1, 1), "how fast φ does");
const auto t = real("t", 15.7, seconds, closed(0, 1000), "time");
const auto longer = real("longer", 1, Unit{"%"}, closed(-50, 100), "by how much Q's string is the longer");

Suspended given()
{
  return {{a, b, c, k * k, L, M, g}, h};
}

Full_state start()
{
  return {{phi, omega, eta, theta}, {phi_rate, omega_rate, eta_rate, theta_rate}};
}

/*!
First the four ways to swing, and what they make of the time.
*/

const Unit per_second{"1/s"};
constexpr const char* angles[]{"phi", "omega", "eta", "theta"};

TELL
{
  const double all = M + 2 * L, inertia = M * (k * k + c * c) + 2 * L * a * a;
  tell("nu", std::sqrt(2 * g / h), per_second, "ν, the shears'", 15);
  tell("lambda", std::sqrt(2 * g * M * c / inertia), per_second, "λ, the beam's", 15);
  tell("mu", std::sqrt(2 * g / b), per_second, "μ, the pans'", 15);
  tell("epsilon", 2 * L / all, "ε, the pans' part of the whole weight", 15);
  tell("kappa2", M * c * (M * c) / (all * inertia), "κ²", 15);
  auto& rows =
      table("modes", "The four ways to swing: how fast, and how far each part, the farthest being 1",
            {{"sigma", "σ", per_second, 16}, {"phi", "φ"}, {"omega", "ω"}, {"eta", "η"}, {"theta", "ϑ"}});
  for(const Mode& mode : modes(given()))
    rows.row({mode.frequency, mode.shape.phi, mode.shape.omega, mode.shape.eta, mode.shape.theta});
  const Transfer over = transfer(given());
  tell("splitting", over.splitting, per_second, "σ − μ", 16);
  tell("time", over.time, seconds, "π:|σ − μ|, (D): P's motion is then Q's, if σ alone is near", 16);
  tell("estimate", over.estimate, seconds, "the same by the approximation in (D)", 15);
}

/*!
Then the motion, for small swings as the sum of the modes, and in full; whose the energy is; and all of it to
look at.
*/

void tell_energies()
{
  auto& rows = table("energies", "Whose the energy is: full equations, at halves of the time t",
                     {{"t", "t", seconds},
                      {"P", "P", percent, 4},
                      {"Q", "Q", percent, 4},
                      {"rest", "all else", percent, 4}});
  Full_motion full(given(), start());
  for(const double time : {0., t / 2, double(t), 1.5 * t, 2. * t})
  {
    const Energies now = energies(given(), full.to(time));
    const double sum = now.P + now.Q + now.rest;
    rows.row({time, now.P / sum, now.Q / sum, now.rest / sum});
  }
}

TELL
{
  const double fastest = modes(given()).back().frequency;
  require(fastest * t <= 3e4, "t", "so that the fastest mode turns through 30000 radians at the most");
  require(parting(given(), start(), 2 * t) <= 1e4, "t",
          "so small that neighbouring motions stay near each other until 2t");
  Full_motion motion(given(), start());
  auto& rows = table("motion", "Where all stands at the time t, in radians",
                     {{"what", "what"},
                      {"phi", "φ", none, 13},
                      {"omega", "ω", none, 13},
                      {"eta", "η", none, 13},
                      {"theta", "ϑ", none, 13}});
  const Four small = linear_motion(given(), start(), t).at, full = motion.to(t).at;
  rows.row({"sum of modes", small.phi, small.omega, small.eta, small.theta});
  rows.row({"full equations", full.phi, full.omega, full.eta, full.theta});
  tell("drift", motion.energy_drift(), "by what part the energy has changed in the computation", 2);
  const Energies e = energies(given(), start());
  if(e.P + e.Q + e.rest > 1e-6 * L * b)
    tell_energies();
  scene_on_shears("passed", given(), start(), 2 * t, fastest);
}

TELL
{
  curve("pans", {"t", "eta", "theta", "of_P", "of_Q"}, [](Curve& out) {
    auto full = pans(designed, {{0, 0, 10_deg, 0}, {}});
    for(int j = 0; j <= 1500; ++j)
    {
      const double at = j * std::numbers::pi / 125, turn = at / 10;
      const auto now = full(at);
      out.put({at, now[0] / 10_deg, now[1] / 10_deg, std::abs(std::cos(turn)), std::abs(std::sin(turn))});
    }
  });
}

/*!
Three causes of an exchange are compared, {{api balance::Cause}}, each in the time that theory has for it.
*/

TELL
{
  using namespace causes;
  auto& rows = table("causes", "The same beam and pans, and three causes",
                     {{"cause", "cause"},
                      {"theory", "in theory", seconds, 5},
                      {"time", "by the full equations", seconds, 3},
                      {"Q", "Q's swing", percent, 3},
                      {"P", "P's then", percent, 3}});
  const auto row = [&rows](const char* name, Cause by) {
    const Farthest now = passing(by);
    rows.row({name, theory(by), now.time, now.Q / of_P, now.P / of_P});
  };
  row("C can move", Cause::pivot);
  row("C fixed, the beam swings by 1/6", Cause::beam);
  row("C fixed, A and B lower by a/10", Cause::ends);
  tell("held", passing(Cause::none).Q / of_P,
       "C fixed, A and B in line, the beam at rest: Q's greatest swing until 1.5 T, over P's", 2);
}

TELL
{
  curve("ways", {"t", "Q"}, [](Curve& out) {
    for(const Cause by : {Cause::pivot, Cause::beam, Cause::ends})
    {
      if(by != Cause::pivot)
        out.block();
      for(const auto& now : causes::way(by))
        out.put({now[0], now[1]});
    }
  });
}

/*!
Last the limits: {{eq E}} and {{eq F}} for the instrument given, and {{eq E}} beside the full equations for a
beam of a thousand pans' weight.
*/

TELL
{
  const Transfer over = transfer(given());
  const double mu_ = std::sqrt(2 * g / b);
  const Trapping swing = trapping(over.splitting, mu_, std::abs(eta));
  tell("critical", swing.critical, radians, "n_c, beyond which the exchange stops short, (E)");
  tell("slower", swing.ratio > 1e300 || std::isnan(swing.ratio) ? infinity : swing.ratio,
       "T_n : T at the start given");
  tell("trapped", swing.reach, percent, "of P's swing Q then has at most, equal strings, by (E)");
  const double delta = longer / 200 * mu_ / std::abs(over.splitting);
  tell("detuned", 1 / std::hypot(1., delta), percent, "of P's swing Q has at most by (F), small swings");
  tell("handed_on", handed_on(given(), longer / 100), percent, "the same by the four modes", 10);
}

constexpr Suspended weak{{1, 2, 0.02, 1. / 3, 1, 1000, 16}, 5};  // a beam of a thousand pans' weight

TELL
{
  curve("reach", {"r", "Q"}, [](Curve& out) {
    for(int k = 0; k <= 200; ++k)
      out.put({0.4 + k / 125., trapping(1. / 32, 1, 0.4 + k / 125.).reach});
  });
  curve("reached", {"r", "Q"}, [](Curve& out) {
    const Transfer over = transfer(weak);
    const double critical = trapping(over.splitting, 4, 0).critical;
    const double until = 1.6 * over.time;  // at 0.95 n_c, the slowest, Q is farthest after 1.46 T
    for(const double r : {0.5, 0.7, 0.85, 0.95, 1.05, 1.1, 1.2, 1.4, 1.6, 1.9})
    {
      const Farthest now = farthest(pans(weak, {{0, 0, r * critical, 0}, {}}), until, causes::look);
      out.put({r, now.Q / (r * critical)});
    }
  });
}

/*!
{{table modes}}

{{table motion}}

At {{t}} s the pan P, let go at {{eta|2}}, has come to rest, and Q swings in its place; at twice that time
all is undone.

{{table energies}}

A pan's share is reckoned here as if $C$ stood still. What its swing has in common with the motion of $C$ is
put to all else, which can so be less than nothing.

So the scene that Bernoulli had seen ({{sec balance.01}}) plays before our eyes, and the beam all the while
turns by less than an eighth of a degree. By the approximation in {{eq D}} it would take {{estimate|4}} s, by
the cubic it takes {{time|6}} s.

::: figure balance-38
alt: Above, the swings of P: wide, dying away to rest at sixteen seconds, wide again at thirty-one. Below,
those of Q, which are widest where P's vanish.

The exchange by the full equations in the instrument designed for it: P, let go at 10°, above; Q, which was at
rest, below; in parts of the first swing. Dashed, what the two modes at 4 and 4.2 alone would make of them.
:::

::: scene passed
alt: From a high point hang the shears, from them the level beam, and from its ends two threads with a pan
each; only the left one is drawn aside.

The instrument and the start given, in true time, until twice the time $t$: what moves $C$ is the swinging
pan, what moves the other pan is $C$.
:::

### Three causes

Besides the moving pivot, two causes were met that Euler either set aside or did not see: ends of the beam
that do not lie in line with $C$ ({{sec balance.37}}), and, with ends in line and $C$ fixed, the swinging beam
itself, at the third order ({{sec balance.31}}). In one instrument their times can be compared.
P is let go at a twentieth of the radius, and looked at until one and a half times what theory has.

{{table causes}}

With $C$ held and neither of the two others at work, Q has in one and a half times the first of these times no
more than {{held|2}} of P's swing.

::: figure balance-38-causes
alt: Three curves over a logarithmic axis of time, each rising from zero to about one: at sixteen seconds, at
some five hundred, and at nearly a thousand.

How far Q swings, in parts of P's first swing, for three causes. The ways are alike; it is the time that
tells. A balance whose swings die down in some minutes shows the first alone.
:::

### Two limits

For the instrument given (E) has the limit at {{critical|3}} of the radius, where swings are small no
longer: it says no more than that those of some degrees are far below it. With a string of Q longer by
{{longer}} % Q still has {{handed_on|3}} of P's swing. It is a balance for the purpose: its coupling is
strong. With a beam of a thousand pans' weight $n_c$ is some thirteen degrees.

::: figure balance-38-trapping
alt: Q's greatest swing against P's first. It is one up to the critical swing, falls at once to seven tenths
and then on as a curve; the points of the full motion lie near it.

How much of P's swing Q can have, for a beam of a thousand times a pan's weight: by {{eq E}}, and by the full
equations (points). Beyond the critical swing the exchange stops short at a stroke.
:::

## Checks

The equations are formed once more as a child would build the balance, of links: each body's place is a sum of
links, and Newton's law is summed over the bodies ({{api balance::links::Built}}). The classical rule carries
them on. For small swings the masses and forces of these links are constant, and the motion is a power series
of the time, summed in fifty digits. The cubic is solved in fifty digits by Newton's rule.
*/

links::Built<Fifty> built_exactly()
{
  return {h.fifty(), a.fifty(), b.fifty(),    b.fifty(), c.fifty(), k.fifty() * k.fifty(),
          L.fifty(), M.fifty(), 2 * g.fifty()};
}

const char* const settings[] = {
    "", "M=20 c=0.1 h=5 eta=9 t=10 longer=10",
    "h=2 c=0.01 phi=-3 omega=4 theta=7 eta_rate=0.3 omega_rate=-0.1 t=7.5 longer=-3",
    "M=3 L=2 a=1.5 b=3 c=0.4 k=0.95 h=0.7 g=9 eta=-25 phi_rate=0.5 t=12 longer=0"};

CHECK_THAT("the frequencies are μ and the three roots of (C), the shapes what the equations leave of them")
{
  for(const Told& now : told_at(settings[0], settings[1], settings[2], settings[3]))
  {
    const Small_swings x(built_exactly());
    CHECK(now.value("nu", per_second) == within_ulps(sqrt(x.nu2), 2, "a quotient and a root"));
    CHECK(now.value("lambda", per_second) == within_ulps(sqrt(x.lambda2), 4, "some products and a root"));
    CHECK(now.value("mu", per_second) == within_ulps(sqrt(x.mu2), 2, "a quotient and a root"));
    CHECK(now.value("epsilon") == within_ulps(x.epsilon, 2, "a sum and a quotient"));
    CHECK(now.value("kappa2") == within_ulps(x.kappa2, 12, "products"));
    Fifty sum = 0, nearest = 1e300;
    for(const auto& row : now.rows("modes"))
    {
      const Fifty told = row.at("sigma", per_second);
      const bool against = row.at("theta") == -row.at("eta");
      const Small_swings::Way way = against ? x.against() : x.together(told * told);
      CHECK(row.value("sigma", per_second)
            == within_ulps(sqrt(way.square), 4, "the options' rounding, and one"));
      for(std::size_t part{0}; part < 4; ++part)
        CHECK(row.value(angles[part]) == within(way.shape[part], 1e-14, "the options' rounding"));
      const Fifty apart = sqrt(way.square) - sqrt(x.mu2);
      if(!against && abs(apart) < abs(nearest))
        nearest = apart;
      sum += against ? Fifty(0) : way.square;
    }
    CHECK(sum == within_relative(x.sum_of_roots(), 1e-13, "all three roots are there"));
    const char* const because = "the options' rounding, which a difference of frequencies makes greater";
    CHECK(now.value("splitting", per_second) == within_relative(nearest, 1e-13, because));
    CHECK(now.value("time", seconds) == within_relative(exact::pi() / abs(nearest), 1e-13, because));
    CHECK(now.value("estimate", seconds) == within_relative(x.rough_time(), 1e-14, "some products"));
  }
}

CHECK_THAT("the designed instrument has the frequencies 1, 13/5, 4, 21/5, and passes all at 5π in the sum "
           "of its modes")
{
  constexpr int fifths[]{5, 13, 20, 21};
  for(std::size_t which{0}; which < 4; ++which)
    CHECK(modes(designed)[which].frequency
          == within_relative(Fifty(fifths[which]) / 5, 1e-15, "M, c and h are rounded"));
  for(const int times : {1, 2, 1000001})
  {
    const Four at = linear_motion(designed, {{0, 0, 1, 0}, {}}, times * 5 * std::numbers::pi).at;
    CHECK(at.eta == within(times % 2 == 0 ? 1 : 0, 3e-7, "phases of 66 million, M, c and h rounded"));
    CHECK(at.theta == within(times % 2 == 0 ? 0 : -1, 3e-7, "the same"));
  }
}

CHECK_THAT(
    "the sum of modes is the series in fifty digits, the full motion and the scene are those of links")
{
  for(const Told& now : told_at(settings[0], settings[1], settings[2], settings[3]))
  {
    const int parts = 1 + static_cast<int>(modes(given()).back().frequency * t / 4);
    const links::Place<Fifty> from{
        {phi.fifty(), omega.fifty(), eta.fifty(), theta.fifty()},
        {phi_rate.fifty(), omega_rate.fifty(), eta_rate.fifty(), theta_rate.fifty()}};
    const auto small = links::small_motion(built_exactly(), from, t.fifty(), parts);
    const auto full = links::followed(given(), start(), t);
    const auto rows = now.rows("motion");
    for(std::size_t part{0}; part < 4; ++part)
    {
      CHECK(rows[0].value(angles[part])
            == within(small.q[part], 1e-13, "phases up to 100, angles below 1"));
      CHECK(rows[1].value(angles[part]) == within(full.q[part], 1e-9, "the classical rule, twice"));
    }
    CHECK(rows[0].words("what") == std::string("sum of modes"));
    CHECK(rows[1].words("what") == std::string("full equations"));
    CHECK(now.value("drift") == between(0, 1e-12, "rounding, step by step"));
    double last = 0;
    for(const auto& frame : now.points("passed", 5))
    {
      CHECK(frame.value("t") == between(last, 2.000001 * t, "in their order"));
      last = frame.at("t");
      const auto q = links::followed(given(), start(), last).q;
      for(const auto& column : by_name(joints<double>(h, a, b, q[0], q[1], q[2], q[3])))
        CHECK(frame.value(column.first) == within(column.second, 1e-8 * (h + a + b), "the same rule"));
    }
  }
}

CHECK_THAT(
    "it follows the fastest mode through 30000 radians, and neighbouring motions until they part before 2t")
{
  for(const char* const beyond :
      {"g=72 b=0.1 t=767.68", "M=0.4 L=0.125 a=10 b=25 c=0.2 k=1 h=50 eta=30 theta=-30 t=9.74"})
    CHECK(refused_at(beyond));
  for(const char* const within_them :
      {"g=72 b=0.1 t=767.6785", "M=0.4 L=0.125 a=10 b=25 c=0.2 k=1 h=50 eta=30 theta=-30 t=9.72"})
    CHECK(!refused_at(within_them));
}

CHECK_THAT("the energy's shares are those of the motion of links")
{
  for(const Told& now : told_at(settings[0], settings[1], settings[3]))
  {
    const auto rows = now.rows("energies");
    for(std::size_t j{0}; j < 5; ++j)
    {
      const double time = t * double(j) / 2;
      const Energies of = links::built(given()).shares(links::followed(given(), start(), time));
      CHECK(rows[j].value("t", seconds) == within_relative(time, 1e-15, "a product"));
      CHECK(rows[j].value("P", percent) == within(of.P, 1e-8, "the classical rule"));
      CHECK(rows[j].value("Q", percent) == within(of.Q, 1e-8, "the same"));
      CHECK(rows[j].value("rest", percent) == within(of.rest, 1e-8, "the same"));
    }
  }
}

/*!
Of the three causes the first and the last are looked at in the motion of links, the second in that which GSL
finds.
*/

CHECK_THAT(
    "each cause hands all over, in the time that theory has for it, within the accuracy of each theory")
{
  for(const Told& now : told_at(""))
  {
    const auto rows = now.rows("causes");
    for(const Cause by : {Cause::pivot, Cause::beam, Cause::ends})
    {
      const auto& row = rows[static_cast<std::size_t>(by)];
      const bool mean = by == Cause::beam;
      const Farthest other = causes::judged(by);
      CHECK(row.value("theory", seconds)
            == within_relative(causes::theory_exactly(by), by == Cause::ends ? 1e-10 : 1e-13,
                               "what was designed, and differences of frequencies"));
      CHECK(row.value("time", seconds) == within_relative(other.time, 1e-3, "the same swing, or the next"));
      CHECK(row.value("time", seconds)
            == within_relative(row.at("theory", seconds), mean ? 0.03 : 0.02,
                               "a flat top, other swings on it"));
      CHECK(row.value("Q", percent) == within(other.Q / causes::of_P, mean ? 0.01 : 1e-3, "another rule"));
      CHECK(row.value("P", percent) == within(other.P / causes::of_P, mean ? 0.01 : 1e-3, "the same"));
      CHECK(row.at("Q", percent) == between(0.98, 1.02, "all, but for other motions"));
    }
    const double time = rows[1].at("time", seconds), most = causes::mean_by_gsl(time).Q;
    for(const double part : {0.8, 1.2})
      CHECK(causes::mean_by_gsl(part * time).Q < most);
    CHECK(rows[0].words("cause") == std::string("C can move"));
    CHECK(now.value("held")
          == within_relative(causes::judged(Cause::none).Q / causes::of_P, 1e-3, "the same"));
  }
}

CHECK_THAT("the figures are these motions: the exchange, the three ways to it")
{
  for(const Told& now : told_at(""))
  {
    for(const auto& point : now.points("pans", 5))
    {
      const Fifty time = point.at("t");
      const auto q = links::followed(designed, {{0, 0, 10_deg, 0}, {}}, double(time)).q;
      CHECK(point.value("eta") == within(q[2] / 10_deg, 1e-8, "the classical rule"));
      CHECK(point.value("theta") == within(q[3] / 10_deg, 1e-8, "the same"));
      CHECK(point.value("of_P")
            == within(sqrt((1 + cos(time / 5)) / 2), 1e-7, "half the sum of two motions"));
      CHECK(point.value("of_Q") == within(sqrt((1 - cos(time / 5)) / 2), 1e-7, "half the difference"));
    }
    links::Place<double> at{{0, 0, 10_deg, 0}, {}};
    double turned = 0;  // the beam, until all is undone
    for(int j = 0; j < 3142; ++j)
    {
      at = links::runge_kutta(links::built(designed), at, 0.01, 1);
      turned = std::max(turned, std::abs(at.q[1]));
    }
    CHECK(turned == between(0.11_deg, 0.125_deg, "an eighth of a degree"));
    const auto points = now.points("ways");
    REQUIRE(points.size() == 3 * 131);
    for(const Cause by : {Cause::pivot, Cause::beam, Cause::ends})
      for(const std::size_t j : {std::size_t{20}, std::size_t{90}, std::size_t{115}, std::size_t{130}})
      {
        const auto& point = points[131 * static_cast<std::size_t>(by) + j];
        const double turn = std::numbers::pi * point.at("t") / (2 * causes::theory(by));
        CHECK(point.value("Q")
              == within(std::abs(std::sin(turn)), 0.15, "side tones, and the time's own error"));
      }
  }
}

CHECK_THAT("beyond the critical swing the exchange stops short, below it takes longer; unequal strings "
           "exchange a part")
{
  for(const Told& now :
      told_at(settings[0], settings[1], "M=1000 a=1 c=0.02 k=0.55 h=5 eta=13 longer=0.1",
              "M=1000 a=1 c=0.02 k=0.55 h=5 eta=25 longer=-2", "M=5000 h=7 eta=0 longer=0"))
  {
    const Small_swings x(built_exactly());
    const Fifty mu = sqrt(x.mu2), apart = sqrt(x.together(modes(given()).back().square).square) - mu;
    const Small_swings::Limits of = x.limits(apart, eta.fifty());
    CHECK(now.value("critical", radians)
          == within_relative(of.critical, 1e-12, "σ − μ, the options' rounding"));
    if(of.k < 1)
      CHECK(now.value("slower")
            == within_relative(2 * swing::oracle::K(of.k) / exact::pi(), 1e-11, "k near 1 magnifies"));
    else
      CHECK(now.value("slower") == infinite("the exchange never ends"));
    CHECK(now.value("trapped", percent) == within_relative(of.reach, 1e-11, "k near 1 magnifies"));
    const Fifty delta = longer.fifty() / 200 * mu / apart;
    CHECK(now.value("detuned", percent) == within_relative(1 / sqrt(1 + delta * delta), 1e-11, "σ − μ"));
  }
}

CHECK_THAT("with unequal strings Q has of P's swing what the answer of the four equations has for residues")
{
  for(const Told& now : told_at("", "longer=10", "M=20 c=0.1 h=5 longer=3", "h=2 c=0.01 longer=-20",
                                "M=1000 a=1 c=0.02 longer=0.01"))
  {
    links::Built<Fifty> of = built_exactly();
    of.b1 *= 1 + longer.fifty() / 100;
    CHECK(now.value("handed_on", percent) == within_relative(links::handed_on(of), 1e-10, "GSL's solver"));
  }
}

CHECK_THAT("the trapping figure: the line is (E), the points lie by it to the next order of the swing")
{
  for(const Told& now : told_at(""))
  {
    for(const auto& point : now.points("reach", 9))
      CHECK(point.value("Q")
            == within_relative(Small_swings::reach(point.at("r")), 1e-12, "k near 1 magnifies"));
    CHECK(trapping(transfer(weak).splitting, 4, 0).critical
          == between(13_deg, 13.5_deg, "some thirteen degrees"));
    for(const auto& point : now.points("reached"))
    {
      const double r = point.at("r");
      CHECK(point.value("Q")
            == within(trapping(1. / 32, 1, r).reach, 0.04, "the next order, and other motions"));
    }
  }
}

/*!
How far an end of the beam moves sideways is seen from its place.
*/

const Erratum only_vertically{
    "§38, how far A is from its place sideways, in parts of its way up, the beam at 10°",
    {"not at all", 0},
    {"by tan 5°", [] { return std::tan(5_deg); }},
    "A moves on a circle about C",
    [](double reading) {
      const Fifty x = exact::pi() / 18;
      return reading == within_relative((1 - cos(x)) / sin(x), 1e-14, "few roundings");
    }};

/*!
## Notes

With ever shorter shears, or an ever heavier beam, $T$ grows without end: so Euler's fixed pivot is contained
in this as a limit. But there is no fixed pivot, only one that moves little, and two equal pans wait for it.

What the model leaves out is what ends it all, the air and the friction at $C$. Whether one sees an exchange
depends on whether $T$ is shorter than the time in which the swings die away.

## Go on from here

::: exercise
Let the shears be as long as the strings ($h = b$). What becomes of the three modes with $\eta=\vartheta$,
if the beam's own part, κ, is left aside?
answer: One is the beam alone, the others have $\sigma^2 = \mu^2:(1\pm\sqrt\varepsilon)$, one on either side
of μ and nearly as far from it. So three motions exchange, those of P, of Q and of the shears. A check
confirms it for a small $c$.
:::

::: exercise
A hand that slowly pulls P aside by $\eta$ pulls the shears too, until it lets go. By how much, and does it
spoil the exchange?
answer: By $\varphi = L\eta:(M+2L)$, to the same side, since the pull $L\eta$ of the string is that which
holds the whole weight, $M+2L$, at the inclination φ. Hardly: in an instrument of round numbers Q still has
more than 0.99 of P's swing. A check confirms it.
:::
*/

CHECK_THAT("shears as long as the strings: σ² = μ²/(1 ± √ε), when c is small")
{
  Suspended s = designed;
  s.h = s.beam.b;
  s.beam.c = 1e-4;
  const auto all = modes(s);
  const double root = std::sqrt(2 / (s.beam.M + 2));
  CHECK(all[1].square == within_relative(16 / (1 + root), 1e-8, "κ², of the order of cc"));
  CHECK(all[3].square == within_relative(16 / (1 - root), 1e-8, "the same"));
}

CHECK_THAT("with shears displaced as a hand would, Q has more than 0.99 of P's swing")
{
  const double part = 1. / 22;  // L : (M + 2L) of the instrument in round numbers
  const double n = causes::of_P, time = 1.5 * transfer(plain).time;
  CHECK(farthest(pans(plain, {{part * n, 0, n, 0}, {}}), time, causes::look).Q / n
        == between(0.99, 1.01, "all but a trace"));
}
