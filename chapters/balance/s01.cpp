#include "balance/hung.hpp"
#include "balance/links.hpp"
#include "balance/motion.hpp"
#include "balance/scene.hpp"
#include "edition/section.hpp"

SECTION(balance, 1, "What Bernoulli saw")

using namespace balance;

/*!
## What Euler does

A pan of a balance is pulled aside and let go, and by and by the other pan has its motion: Euler quotes the
report of Bernoulli and resolves to explain it. The balance was a large one and rather sluggish. Four
things can be told apart in what was seen.

1. The pan that was let go swings to and fro; the other one at first does not stir from its place.
2. Then the other too begins to swing, wider and wider, while the first loses its motion by degrees; and at
   last the first is *truly at rest*.
3. At that very moment the second has its widest swing, almost as wide as that with which the first began.
4. Now everything happens in the contrary order, until the first pan has its whole motion again and its
   companion is for a moment at rest. And so for a good while.

::: margin
Today: two equal oscillators, weakly coupled. What each does is a beat of the two modes in which both swing
equally far, with each other or against.
:::

Nothing in the means by which other kinds of oscillations were mastered seems to serve here; so he takes
refuge in the first principles of motion. He wants above all to leave out no circumstance that can contribute
anything. In the end he finds none of the four things, and one circumstance left out: he has taken the point
from which the balance hangs as fixed ({{sec balance.37}}, {{sec balance.38}}).

## The program

The scene can be played at once, with the circumstance put back in. The balance hangs from a point $O$ by
{{term shears}} of the length $h$, at whose lower end is $C$ with the beam; shears, beam and strings turn
freely, and friction and air are left out. P is pulled aside by $n$ and let go, everything else hangs straight
down. The four angles obey the full equations ({{api balance::Full_motion}}). To very small swings belong four
frequencies, of which two are near that of a pan alone. It is μ for pans that swing against each other; let
it be σ where they swing with each other, and

$$ T = \frac{\pi}{|\sigma-\mu|} \tag{A} $$

is the time in which the two get out of step by half a turn. The instrument given is one whose four
frequencies are as 5, 13, 20 and 21, so that for very small swings *everything* passes at $T = 5\pi$ seconds
and is back at $10\pi$.
*/

const auto n = angle("n", 10_deg, closed(0.01_deg, 30_deg), "how far P is pulled aside");
const auto t = real("t", 15, seconds, closed(0, 60), "a time");
const auto L = real("L", 1, none, closed(0.5, 3), "weight of each pan");
const auto M = real("M", designed.beam.M, none, closed(10, 100), "weight of the beam");
const auto h = real("h", designed.h, feet, closed(2.5, 10), "OC, length of the shears");

const auto hung = [] {
  Suspended s = designed;
  s.beam.L = L;
  s.beam.M = M;
  s.h = h;
  return s;
};
const auto pulled = [] { return Full_state{{0, 0, n, 0}, {}}; };

double pan()  // μ
{
  return std::sqrt(2 * designed.beam.g / designed.beam.b);
}

struct Reach  // the farthest from the vertical
{
  double P = 0, Q = 0, beam = 0, shears = 0;

  void look(const Four& at)
  {
    P = std::max(P, std::abs(at.eta));
    Q = std::max(Q, std::abs(at.theta));
    beam = std::max(beam, std::abs(at.omega));
    shears = std::max(shears, std::abs(at.phi));
  }
};

constexpr int looks = 512;

std::vector<double> moments(double middle)  // one period of a pan around it, from the start at the earliest
{
  const double period = 2 * std::numbers::pi / pan();
  std::vector<double> all;
  for(int k = 0; k <= looks; ++k)
    if(const double time = middle + period * (double(k) / looks - 0.5); time >= 0)
      all.push_back(time);
  return all;
}

Reach around(double middle)
{
  Full_motion motion(hung(), pulled());
  Reach reach;
  for(const double time : moments(middle))
    reach.look(motion.to(time).at);
  return reach;
}

Reach throughout(const Suspended& s, double until)
{
  Full_motion motion(s, pulled());
  Reach reach;
  for(int k = 0; k <= 2000; ++k)
    reach.look(motion.to(until * k / 2000).at);
  return reach;
}

/*!
How far a pan swings at some moment is the most that it leans within one of its periods around that moment,
looked for at the ends of {{looks}} equal steps. The motion starts from rest and would run backwards alike.
*/

TELL
{
  const double T = transfer(hung()).time, swing = std::numbers::pi / pan();
  require(T >= 6, "h", "such that the motion passes in 6 to 40 seconds");
  require(T <= 40, "h", "such that the motion passes in 6 to 40 seconds");
  tell("looks", looks, "steps of a period that are looked at");
  tell("swing", swing, seconds, "one swing of a pan from side to side", 15);
  tell("T", T, seconds, "everything should have passed, (A)", 14);
  tell("swings", T / swing, "the same in swings", 13);
  tell("Q_first", around(0).Q / n, percent, "1: Q's swing while P makes its first, in parts of n", 8);
  tell("P_rest", around(T).P / n, percent, "2: P's at the time T", 8);
  tell("Q_full", around(T).Q / n, percent, "3: Q's then", 10);
  tell("P_again", around(2 * T).P / n, percent, "4: P's at the time 2T", 10);
  tell("Q_rest", around(2 * T).Q / n, percent, "4: Q's then", 8);
}

TELL
{
  const double until = 2 * transfer(hung()).time;
  const Reach all = throughout(hung(), until);
  Suspended held = hung();
  held.movable = false;
  tell("beam", all.beam, degrees, "most that the beam leans, from 0 to 2T", 8);
  tell("shears", all.shears, degrees, "most that the shears do", 8);
  tell("held", throughout(held, until).Q / n, percent, "most that Q swings when C is held fast", 4);
  Full_motion motion(hung(), pulled());
  const Four at = motion.to(t).at;
  tell("phi_t", at.phi, degrees, "φ at the time t, the shears", 8);
  tell("omega_t", at.omega, degrees, "ω then", 8);
  tell("eta_t", at.eta, degrees, "η then", 10);
  tell("theta_t", at.theta, degrees, "ϑ then", 10);
}

TELL
{
  auto& rows = table("scene", "How far the pans swing, in parts of the first pull",
                     {{"part", "time, in T", none, 4},
                      {"t", "time", seconds, 6},
                      {"P", "P", percent, 4},
                      {"Q", "Q", percent, 4}});
  const double T = transfer(hung()).time;
  for(int k = 0; k <= 8; ++k)
  {
    const Reach here_ = around(T * k / 4);
    rows.row({k / 4., T * k / 4, here_.P / n, here_.Q / n});
  }
}

TELL
{
  curve("scene_drawn", {"t", "P", "Q", "P_hull", "Q_hull"}, [](Curve& out) {
    const double T = transfer(hung()).time, degree = 1_deg;
    Full_motion motion(hung(), pulled());
    for(int k = 0; k <= 1200; ++k)
    {
      const double time = 2 * T * k / 1200, turn = std::numbers::pi * time / (2 * T);
      const Four at = motion.to(time).at;
      out.put({time, at.eta / degree, at.theta / degree, n / degree * std::cos(turn),
               n / degree * std::sin(turn)});
    }
  });
}

TELL
{
  scene_on_shears("seen", hung(), pulled(), 2 * transfer(hung()).time, modes(hung()).back().frequency);
}

/*!
Bernoulli's four observations, in their order: while P makes its first swing, Q moves by {{Q_first|2}} of the
pull. After {{T|4}} s, or {{swings|3}} swings, P is at rest but for {{P_rest|2}}, and Q swings by
{{Q_full|4}}. After twice the time P has {{P_again|4}} of its swing again. All the while the beam leans by
{{beam|2}} at the most, and the shears by {{shears|2}}: whoever looks at the pans sees the beam at rest. With
$C$ held fast Q would have got {{held|2}}.

{{table scene}}

::: figure balance-01
alt: Two strips one above the other, against two transfer times. Above, P swings ten degrees to both sides,
less and less until it rests in the middle, and back. Below, Q is at rest, swings up to ten degrees in the
middle and comes to rest at the end. Thin lines enclose both.

One pan moves, comes to rest, the other has it, and back. The thin lines are those of two swings that are
added, $n\cos$ and $n\sin$ of half their difference of phase.
:::

::: scene seen
alt: From a high point hang the shears, from them the level beam, and from its ends two threads with a pan
each, the left one drawn aside.

What Bernoulli saw, in true time and in the instrument's proportions. Only the pan P at the left is pulled.
Watch the other: after {{T|3}} s it has the whole motion and P is at rest, after twice that time P has it
again. Then the scene begins anew.
:::

## Checks

The scene is played a second time by other equations and another rule: by those of the balance built of links
({{api balance::links::Built}}), where the position of each body is a sum of links, and masses and forces
come from these sums alone. The classical rule of Runge and Kutta, with steps of half a millisecond, carries
them on.
*/

struct Played
{
  links::Place<double> place{{0, 0, n, 0}, {}};
  double now = 0;

  void to(double time)
  {
    const int steps = std::max(1, int(std::ceil((time - now) / 5e-4)));
    place = links::runge_kutta(links::built(hung()), place, time - now, steps);
    now = time;
  }
  Four angles() const { return {place.q[0], place.q[1], place.q[2], place.q[3]}; }
};

CHECK_THAT("the motion told, and how far each member swings, are those of links")
{
  for(const Told& now : told_at("", "n=30 L=3 M=40 h=6 t=7", "n=0.01 M=20 t=40 h=5"))
  {
    const double T = transfer(hung()).time, room = 1e-9;
    std::vector<std::pair<double, std::size_t>> when;
    for(std::size_t row = 0; row <= 8; ++row)
      for(const double time : moments(T * double(row) / 4))
        when.emplace_back(time, row);
    for(int k = 0; k <= 2000; ++k)
      when.emplace_back(2 * T * k / 2000, 9);
    when.emplace_back(t, 10);
    std::sort(when.begin(), when.end());
    std::array<Reach, 11> seen{};
    Played again;
    Four at_t;
    for(const auto& moment : when)
    {
      again.to(moment.first);
      seen[moment.second].look(again.angles());
      if(moment.second == 10)
        at_t = again.angles();
    }
    const char* const why = "the fourth power of the rule's step, over a minute, in parts of n";
    CHECK(now.value("phi_t", degrees) == within(at_t.phi, room * n, why));
    CHECK(now.value("omega_t", degrees) == within(at_t.omega, room * n, why));
    CHECK(now.value("eta_t", degrees) == within(at_t.eta, room * n, why));
    CHECK(now.value("theta_t", degrees) == within(at_t.theta, room * n, why));
    CHECK(now.value("beam", degrees) == within(seen[9].beam, room * n, why));
    CHECK(now.value("shears", degrees) == within(seen[9].shears, room * n, why));
    CHECK(now.value("Q_first", percent) == within(seen[0].Q / n, room, why));
    CHECK(now.value("P_rest", percent) == within(seen[4].P / n, room, why));
    CHECK(now.value("Q_full", percent) == within(seen[4].Q / n, room, why));
    CHECK(now.value("P_again", percent) == within(seen[8].P / n, room, why));
    CHECK(now.value("Q_rest", percent) == within(seen[8].Q / n, room, why));
    const auto rows = now.rows("scene");
    REQUIRE(rows.size() == 9);
    for(std::size_t k = 0; k <= 8; ++k)
    {
      CHECK(rows[k].value("part") == within(double(k) / 4, 0, "quarters"));
      CHECK(rows[k].value("t", seconds) == within_relative(double(k) * T / 4, 1e-15, "a product"));
      CHECK(rows[k].value("P", percent) == within(seen[k].P / n, room, why));
      CHECK(rows[k].value("Q", percent) == within(seen[k].Q / n, room, why));
    }
    CHECK(now.value("looks") == 512);
  }
}

CHECK_THAT("the scene shows the links where that rule brings them")
{
  for(const Told& now : told_at("", "n=30 L=3 M=40 h=6 t=7", "n=0.01 M=20 t=40 h=5"))
  {
    Played again;
    double last = 0;
    for(const auto& frame : now.points("seen", 9))
    {
      again.to(frame.at("t"));
      const Four at = again.angles();
      const auto& beam = designed.beam;
      CHECK(frame.value("t") == between(last, 2.000001 * transfer(hung()).time, "in their order"));
      last = frame.at("t");
      for(const auto& column :
          by_name(joints<double>(h, beam.a, beam.b, at.phi, at.omega, at.eta, at.theta)))
        CHECK(frame.value(column.first)
              == within(column.second, 1e-8 * n + 4e-15, "the room of the angles, times the lengths"));
    }
  }
}

/*!
The time $T$ is looked for where the linear equations say it: σ is a zero of the determinant of the three
angles φ, ω and $\eta = \vartheta$, found in fifty digits.
*/

Fifty determinant(const Fifty& s)  // of stiffness less s times mass; φ, ω and both pans
{
  const auto& [a, b, c, kk, L0, M0, g] = hung().beam;
  const Fifty G = 2 * Fifty(g), P = 2 * Fifty(L0) * b, W = Fifty(M0) + 2 * Fifty(L0), H = double(h);
  const Fifty I = Fifty(M0) * (Fifty(kk) + Fifty(c) * c) + 2 * Fifty(L0) * a * a, Mc = Fifty(M0) * c;
  const Fifty x = (G - s * H) * W * H, y = G * Mc - s * I, z = (G - s * b) * P;
  const Fifty xy = s * H * Mc, xz = s * H * P;  // the beam and the pans do not touch each other
  return x * y * z - xy * xy * z - xz * xz * y;
}

CHECK_THAT("(A): the two frequencies belong to the linear equations, and T is the time told")
{
  for(const Told& now : told_at("", "n=30 L=3 M=40 h=6 t=7", "n=0.01 M=20 t=40 h=5"))
  {
    const Fifty mu = sqrt(2 * Fifty(designed.beam.g) / designed.beam.b);
    Fifty low = mu * (1 + Fifty("1e-9")), high = mu + exact::pi() / 6;
    REQUIRE(determinant(low * low) * determinant(high * high) < 0);
    for(int k = 0; k < 160; ++k)
    {
      const Fifty middle = (low + high) / 2;
      (determinant(middle * middle) * determinant(low * low) > 0 ? low : high) = middle;
    }
    const Fifty T = exact::pi() / (low - mu);
    CHECK(now.value("T", seconds) == within_relative(T, 1e-15, "one quotient"));
    CHECK(now.value("swing", seconds) == within_relative(exact::pi() / mu, 5e-16, "a root"));
    CHECK(now.value("swings") == within_relative(T * mu / exact::pi(), 2e-15, "two quotients"));
  }
}

CHECK_THAT(
    "shears with which the motion would pass in less than 6 seconds, or in more than 40, are refused")
{
  for(const auto& [within_them, beyond, T] : {std::tuple{"L=3 h=5.0705", "L=3 h=5.0704", 6},
                                              {"L=2.5 h=3.8273", "L=2.5 h=3.8272", 6},
                                              {"L=0.5 h=7.828", "L=0.5 h=7.829", 40},
                                              {"M=100 h=3.9734", "M=100 h=3.9735", 40}})
  {
    CHECK(refused_at(beyond));
    for(const Told& now : told_at(within_them))
      CHECK(now.value("T", seconds) == within_relative(T, 1e-4, "nearly the limit"));
  }
}

CHECK_THAT("with C held fast Q swings as little as GSL finds by the equations of the fixed pivot")
{
  for(const Told& now : told_at("", "n=30 L=3 M=40 h=6 t=7", "n=20 M=20 t=40 h=5"))
  {
    const double until = 2 * transfer(hung()).time;
    State<> fixed = released(0, n, 0);
    double most = 0;
    for(int k = 0; k < 2000; ++k)
    {
      fixed = by_gsl(numbers_of(hung().beam), fixed, until / 2000, 1e-14);
      most = std::max(most, std::abs(fixed.at.theta));
    }
    CHECK(now.value("held", percent) == within(most / n, 1e-11, "GSL's tolerance, 2000 times"));
  }
}

CHECK_THAT("for very small swings the given balance is at rest again, P for Q, a million handovers later")
{
  const double half = 5 * std::numbers::pi;
  const auto all = modes(designed);
  REQUIRE(all.size() == 4);
  for(const std::size_t k : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}})
    CHECK(all[k].frequency
          == within_relative(Fifty(std::array{5, 13, 20, 21}[k]) / 5, 1e-15, "h, M and c are rounded"));
  CHECK(transfer(designed).time == within_relative(5 * exact::pi(), 2e-15, "h, M and c are rounded"));
  for(const double handovers : {1., 2., 1e6, 1e6 + 1})
  {
    const Full_state there = linear_motion(designed, {{0, 0, 1, 0}, {}}, handovers * half);
    const bool back = std::fmod(handovers, 2) == 0;
    const double room = 1e-13 * handovers;
    CHECK(there.at.eta == within(back ? 1 : 0, room, "the instrument's numbers are rounded"));
    CHECK(there.at.theta == within(back ? 0 : -1, room, "the same"));
  }
}

CHECK_THAT("the figure shows that motion, and its hulls are two frequencies added")
{
  for(const Told& now : told_at(""))
  {
    Played again;
    for(const auto& point : now.points("scene_drawn", 9))
    {
      const Fifty time(point.at("t")), T = transfer(hung()).time, degree = exact::pi() / 180;
      again.to(point.at("t"));
      CHECK(point.value("P") == within(again.place.q[2] / 1_deg, 1e-8, "the rule's error, in degrees"));
      CHECK(point.value("Q") == within(again.place.q[3] / 1_deg, 1e-8, "the same"));
      const Fifty mean = exact::pi() * time / (2 * T);
      CHECK(point.value("P_hull") == within(n.fifty() / degree * cos(mean), 1e-13, "a cosine"));
      CHECK(point.value("Q_hull") == within(n.fifty() / degree * sin(mean), 1e-13, "a sine"));
    }
  }
}

/*!
## Notes

Observation 2, "truly at rest", is the strongest: it holds for a model only if nothing is lost on the way and
both pans are exactly equal ({{sec balance.04}}). What Euler suspected of a rough first impulse
({{sec balance.38}}) is not needed: here the beam and the shears begin at rest, and it is the swinging pan
itself that moves $C$.
*/
