#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/asked.hpp"
#include "globe/ball.hpp"
#include "globe/oracle.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 20, "A much greater velocity")

using namespace globe;

/*!
## What Euler does

If the ball is made to turn much faster than Case II asks for, the formula yields once more. The section is
the bridge to the third case. In the second, Euler recalls, the angular velocity at the start was

$$ \zeta = \frac{\sqrt{8gc}}k, {{entry eight}} \tag{1} $$

and so rather small, $c$ being as small as can be against $k$. But if this velocity is taken much greater,
so that the quantity

$$ 4gc \quad\text{all but vanishes against}\quad \zeta\zeta kk, \tag{2} $$

the analysis will succeed too. How, is the matter of the next two sections.

::: margin
Today: the kinetic energy at the bottom is large against the potential energy of half a turn. In the $n$ of
{{sec globe.21}}, $\zeta\zeta kk = 4gc\cdot nn$, the condition is $nn \gg 1$.
:::

What makes it succeed is plain from the formula of {{sec globe.13}}. Under the root that is its denominator
stands $\zeta\zeta kk - 4gc(1-\cos\Phi)$, of which the second part never exceeds $8gc$: it is a small
correction to a constant, whatever Φ may be.

But the velocity cannot be made as great as one likes. A smooth plane can push and cannot pull, and nowhere
in the paper is it asked whether it would have to. At the top $G$ moves in a circle about $C$, which goes
straight on; to keep it there takes a force, and the ball's weight must have that to give. By
{{sec globe.10}} the pressure at the top is

$$ \frac\Pi P = 1 - \frac{cc}{kk}\,(2nn - 4), \tag{A} $$

and it is there, for the energies in question, that it first fails. So the ball stays on its plane through
whole turns if, and only if,

$$ 2 < nn \le 2 + \frac{kk}{2cc}, \tag{B} $$

and "much greater" is limited by the ball's own shape: what is to vanish in {{eq 2}} is

$$ \frac{4gc}{\zeta\zeta kk} = \frac1{nn} \ge \frac{2cc}{kk+4cc}. \tag{C} $$

The two smallnesses that {{sec globe.21}} is about to assume are therefore not independent. The ratio
$4gc : \zeta\zeta kk$ cannot be small unless $cc : kk$ is. A ball with $c = k$ has, between $nn = 2$ and
$nn = 2\frac12$, hardly room to turn over at all.

If it has more than {{eq B}} allows, the ball leaves the plane on its way up, before $G$ gets to the top. With
$u = \cos\Phi$ the pressure vanishes where

$$ kk + cc\,\bigl(1 + u^2 + 2(nn-1)u\bigr) = 0. \tag{D} $$

## The program

The energy may be given as $h = \frac12nn$, as what it lacks of the top, or as ζ. What counts for the lift-off
is what exceeds the limit {{eq B}}; it is formed from the numbers as they are written, in fifty digits, since
just above the limit the two roots of {{eq D}} run together at the top.
*/

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto asked = asked_energy(18);

Fifty limit()  // (B), as an energy: half of 2 + kk:2cc
{
  return 1 + k.fifty() * k.fifty() / (4 * c.fifty() * c.fifty());
}

Fifty exceeds(const Energy<Fifty>& e)  // h less the limit; what no reader can have written is nothing
{
  const Fifty over = e.h - limit();
  return abs(over) < 1e-45 * limit() ? Fifty(0) : over;
}

const char* kind(const Energy<Fifty>& e)
{
  if(e.h == 1)
    return "approaches the top for ever";
  return e.h < 1 ? "rocks" : exceeds(e) <= 0 ? "turns over on the plane" : "leaves the plane";
}

TELL
{
  require(c <= 1e6 * k, "c", "at most a million times k");
  require(k <= 1e40 * c, "c", "at least 1e-40 of k");
  const Energy<Fifty> e = asked.fifty(c.fifty(), k.fifty() * k.fifty(), g.fifty());
  const Fifty over = exceeds(e);
  const double second = std::sqrt(2 * g) * std::sqrt(c), most = double(limit());
  tell("kind", kind(e), "what the ball does");
  tell("n", std::sqrt(2 * double(e.h)), "n, its square being ζζkk:4gc");
  tell("n_most", std::sqrt(2 * most), "the greatest n with which it stays on the plane, (B)");
  tell("zeta_II", 2 * second / k, Unit{"1/s"}, "ζ of Case II, (1)");
  tell("zeta_most", 2 * std::sqrt(most) * second / k, Unit{"1/s"}, "the greatest ζ, with which n is that");
  tell("share", 0.5 / double(e.h), percent, "4gc, which is to vanish, as a part of ζζkk");
  tell("share_least", 0.5 / most, percent, "the least that it can be made on the plane, (C)");
  if(e.turns_over())
    tell("pressure", double(-4 * over * c.fifty() * c.fifty() / (k.fifty() * k.fifty())),
         "Π/P at the top, (A); where it is negative the ball is no longer on the plane");
  if(over > 0)
  {
    const auto off = smooth::lift_off<double>(c, k, double(over));
    tell("Phi_off", off.Phi, degrees, "Φ where the ball leaves the plane, (D)");
    tell("psi_off", off.from_top, degrees, "what that lacks of the top");
    tell("t_off", off.tau / second, seconds, "the time till then since the lowest place");
    tell("w_off", off.w * second, Unit{"1/s"}, "dΦ/dt there");
  }
}

TELL
{
  curve("limit", {"ratio", "n"}, [](Curve& curve) {
    for(int i = -100; i <= 50; ++i)
    {
      const double ratio = std::pow(10, i / 50.);
      curve.put({ratio, std::sqrt(2 * smooth::lift_off_energy(ratio, 1.))});
    }
  });
  curve("here", {"ratio", "n"}, [](Curve& here) {
    const Energy<Fifty> e = asked.fifty(c.fifty(), k.fifty() * k.fifty(), g.fifty());
    here.put({c / k, std::sqrt(2 * double(e.h))});
  });
}

/*!
Our ball, for which ζ of Case II is {{zeta_II|5}}, stays on its plane up to $\zeta = $ {{zeta_most|5}}, or
$n = $ {{n_most|5}}, and no further. The part that is to vanish can be made {{share_least|3}} there and not
less. With $n = $ {{n|3}} the pressure at the top would have to be {{pressure|3}} of the weight, which is a
pull, and long before that, at {{Phi_off|6}}, the ball is off.

::: figure globe-20
alt: The plane of c over k and n, both logarithmic. Below a level line at the root of two the ball rocks; a
falling line, which approaches that level to the right, is the limit above which it leaves the plane. Between
them is a wedge, wide on the left and closing to the right, where it turns over on the plane. A point marks
this ball.

What a ball does, by its shape and by $n$. Turning fast and staying down, as Case III asks, is possible in
the wedge alone; to the right it closes.
:::

## Checks

The pressure is that of the three equations of {{sec globe.06}} and {{sec globe.07}}. Where it vanishes is
found by halving, from it alone.
*/

Fifty bears(const Energy<Fifty>& e, const Fifty& psi)  // Π/P of the equations of motion, by what Φ lacks
{
  const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty();
  const Fifty w2 = 8 * g_ * c_ * (pow(sin(psi / 2), 2) - e.from_top) / (k_ * k_ + pow(c_ * sin(psi), 2));
  return accelerations<Fifty>(Ball<Fifty>{c_ + k_, c_, k_}, g_, exact::pi() - psi, sqrt(w2), 0).pressure;
}

Fifty by_halving(const Energy<Fifty>& e)  // ψ where it vanishes
{
  Fifty low = 0, high = exact::pi() / 2;
  for(int i = 0; i < 220; ++i)
    (bears(e, (low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return high;
}

CHECK_THAT("the ball leaves the plane at the place told, where its pressure vanishes, and at that time")
{
  const char* const because = "the library's eight ulps, and some roundings";
  for(const Told& now : told_at("", "h=10.0000000000005", "zeta=40 c=0.6 g=1", "from_top=-1e9 c=3",
                                "h=1.01000000000000000003 c=3e10 k=6e9 g=1e-80"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), second = sqrt(2 * g.fifty() * c_);
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g.fifty());
    const Fifty psi = by_halving(e), left = pow(sin(psi / 2), 2) - e.from_top, s = c_ * sin(psi);
    CHECK(now.value("psi_off", degrees) == within_relative(psi, 4e-15, because));
    CHECK(now.value("Phi_off", degrees) == within_relative(exact::pi() - psi, 4e-15, because));
    CHECK(now.value("t_off", seconds)
          == within_relative(oracle::smooth_time(c_, k_, e, place_from_top(psi)) / second, 4e-15, because));
    CHECK(now.value("w_off", Unit{"1/s"})
          == within_relative(2 * second * sqrt(left / (k_ * k_ + s * s)), 4e-15, because));
  }
}

CHECK_THAT("by the equations of motion the ball has got there at that time, and the plane bears nothing")
{
  for(const Told& now : told_at("", "h=2 c=0.5"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), second = sqrt(2 * g_ * c_);
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g_);
    const Ball<Fifty> ball{c_ + k_, c_, k_};
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1], accelerations<Fifty>(ball, g_, s[0], s[1], 0).Phi};
    };
    const Fifty psi = by_halving(e), u = -cos(psi), nn = 2 * e.h;
    const Fifty t = oracle::smooth_time(c_, k_, e, place_from_top(psi)) / second;
    const exact::State s = exact::solve(motion, 0, {0, 2 * second * sqrt(e.h) / k_}, t).y;
    CHECK(s[0] == within(exact::pi() - psi, 1e-28, "some hundred steps of 1e-32"));
    CHECK(accelerations<Fifty>(ball, g_, s[0], s[1], 0).pressure == within(0, 1e-26, "the same"));
    CHECK(k_ * k_ + c_ * c_ * (1 + u * u + 2 * (nn - 1) * u) == within(0, 1e-44, "(D)"));
    CHECK(now.value("t_off", seconds) == within_relative(t, 4e-15, "eight ulps and a root"));
  }
}

CHECK_THAT("what the ball does, and the numbers of (1), (2), (A), (B) and (C), are told for every energy")
{
  const char* const because = "half a dozen roundings";
  for(const Told& now : told_at("", "h=0.5", "h=10 g=1e50", "from_top=-1e-30 c=3",
                                "zeta=1e-3 k=1e30 c=1e-8", "h=1e90 c=1e6 k=1"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty();
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g_);
    const Fifty zz = 8 * g_ * c_ / (k_ * k_) * e.h, nn_most = 2 + k_ * k_ / (2 * c_ * c_);
    CHECK(now.value("n") == within_relative(sqrt(zz * k_ * k_ / (4 * g_ * c_)), 1e-15, because));
    CHECK(now.value("n_most") == within_relative(sqrt(nn_most), 1e-15, because));
    CHECK(now.value("zeta_II", Unit{"1/s"}) == within_relative(sqrt(8 * g_ * c_) / k_, 1e-15, because));
    CHECK(now.value("zeta_most", Unit{"1/s"})
          == within_relative(sqrt(4 * g_ * c_ * nn_most) / k_, 1e-15, because));
    CHECK(now.value("share", percent) == within_relative(4 * g_ * c_ / (zz * k_ * k_), 1e-15, because));
    CHECK(now.value("share_least", percent)
          == within_relative(2 * c_ * c_ / (k_ * k_ + 4 * c_ * c_), 1e-15, because));
    const bool over = e.h > 1, off = 2 * e.h > nn_most;
    CHECK(now.value("kind") == (off ? "leaves the plane" : over ? "turns over on the plane" : "rocks"));
    if(over)
      CHECK(now.value("pressure")
            == within(bears(e, 0), 1e-15 * double(abs(bears(e, 0))) + 1e-45, "rounded once"));
  }
  for(const Told& now : told_at("h=1"))
    CHECK(now.value("kind") == "approaches the top for ever");
}

CHECK_THAT("a ball is refused whose c is more than a million times k, or less than 1e-40 of it")
{
  for(const char* const within_them : {"c=1e6 k=1", "c=2e6 k=2", "c=1 k=1e40", "c=2 k=2e40"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"c=1000000.0000000002 k=1", "c=2000000.0000000005 k=2",
                                  "c=0.9999999999999999 k=1e40", "c=1.9999999999999998 k=2e40"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("a ζ is refused together with 1 − h, and where its h is less than 1e-100 or more than 1e100")
{
  for(const char* const within_them :
      {"from_top=0.5", "zeta=1.0000000000000001e-50 c=1 k=1 g=0.125", "zeta=1e50 c=1 k=1 g=0.125"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"from_top=0.5 zeta=1e-9", "zeta=9.999999999999999e-51 c=1 k=1 g=0.125",
                                  "zeta=1.0000000000000002e50 c=1 k=1 g=0.125"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("with no more than (B) allows, the plane bears something everywhere but at the top")
{
  for(const char* const setting : {"h=10", "c=0.6 h=1.25", "c=0.01 h=901", "c=6 h=1.0025"})
    for(const Told& now : told_at(setting))
    {
      const Energy<Fifty> e = asked.fifty(c.fifty(), k.fifty() * k.fifty(), g.fifty());
      for(int i = 1; i <= 180; ++i)
        CHECK(bears(e, i * exact::pi() / 180) > 0);
      CHECK(bears(e, 0) == within(0, 1e-40, "each is just the limit"));
      CHECK(now.value("kind") == "turns over on the plane");
    }
}

/*!
In our copy {{eq 1}} has a 2 where there must be an 8. The ball itself decides. Let it fall from rest a
thousandth of a degree below the top: it comes to the lowest place with just less than the ζ of Case II, and
with the other reading it would not have been able to climb there.
*/

Fifty fallen()  // dΦ/dt at the lowest place, with g = 1, by the equations of motion
{
  const Ball<Fifty> ball = our_ball<Fifty>;
  const Fifty psi = exact::pi() / 180000;
  const auto motion = [&](const Fifty&, const exact::State& s) {
    return exact::State{s[1], accelerations<Fifty>(ball, 1, s[0], s[1], 0).Phi};
  };
  const Energy<Fifty> e = energy_of_amplitude_from_top<Fifty>(psi);
  const Fifty t = oracle::smooth_quarter(ball.c, ball.k, e) / sqrt(2 * ball.c);
  return -exact::solve(motion, 0, {exact::pi() - psi, 0}, t).y[1];
}

const Emendation eight{"§20, the velocity of Case II",
                       {"√(2gc) : k", std::sqrt(0.2) / 0.6},
                       {"√(8gc) : k", std::sqrt(0.8) / 0.6},
                       "§16 has it, and the ball that falls from near the top comes down with it",
                       [](double reading) {
                         static const Fifty down = fallen();
                         return reading == within_relative(down, 1e-10, "the part it began below, squared");
                       }};

CHECK_THAT("the limit drawn is the n at which the pressure at the top vanishes")
{
  for(const Told& now : told_at("", "c=0.3 h=4"))
  {
    for(const auto& point : now.points("limit", 7))
    {
      const Fifty r = point.at("ratio"), n = point.at("n");
      // At the top of the ball k = 1, g = 1: w² = 4c(nn − 2).
      const auto top =
          accelerations<Fifty>(Ball<Fifty>{r + 1, r, 1}, 1, exact::pi(), sqrt(4 * r * (n * n - 2)), 0);
      CHECK(top.pressure == within(0, 2e-15 * double(1 + 4 * r * r), "an ulp of n"));
      CHECK(point.value("n") == within_relative(sqrt(2 + 1 / (2 * r * r)), 1e-15, "five roundings"));
      CHECK(point.value("ratio") == between(0.01, 10, "three powers of ten"));
    }
    for(const auto& point : now.points("here", 1))
    {
      const Energy<Fifty> e = asked.fifty(c.fifty(), k.fifty() * k.fifty(), g.fifty());
      CHECK(point.value("ratio") == within_relative(c.fifty() / k.fifty(), 4e-16, "one quotient"));
      CHECK(point.value("n") == within_relative(sqrt(2 * e.h), 4e-16, "one root"));
    }
  }
}

/*!
## Notes

That the ball leaves the plane does not end its motion, only the formulae of this part. It flies, turning
evenly, and comes down again; {{sec globe.23}} follows it so far.

## Go on from here

::: exercise
How near to its centre must the centre of gravity of a ball be, in parts of $k$, for $n = 10$ to be possible
on the plane?
answer: By {{eq B}} $kk:2cc$ must be at least 98, so that $c \le k:14$. With `--c 0.1 --k 1.4 --h 50` the
program finds that $n$ is just the greatest.
:::
*/

CHECK_THAT("with c = k:14 the greatest n is 10")
{
  for(const Told& now : told_at("c=0.1 k=1.4 h=50"))
  {
    CHECK(now.value("n_most") == within_relative(10, 1e-15, "half a dozen roundings"));
    CHECK(now.value("n") == within_ulps(10, 1, "a root"));
    CHECK(now.value("kind") == "turns over on the plane");
  }
}
