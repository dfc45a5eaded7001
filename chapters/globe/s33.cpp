#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "globe/asked.hpp"
#include "globe/oracle.hpp"
#include "globe/rolling.hpp"
#include "globe/scene.hpp"
#include "globe/scene_judge.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 33, "The two fast cases with friction, and a rule put right")

using namespace globe;

/*!
## What Euler does

Of the two cases that were worked out without friction for a very small $c$, the ball that just fails to
turn over and the ball that turns fast, Euler says that all holds in like manner when friction is added. The
formulae, he says, differ from the former ones chiefly in that for $k$ one has to write

$$ b = \sqrt{{{entry root}}(a-c)^2+kk}, \tag{1} $$

and therefore these motions are slower, too, than on the smooth plane. This, he ends, is about all that can be
determined by calculation of such motions of a ball.

He does not write the formulae out. By the rule {{sec globe.17}} becomes, with $\omega = 90° - \frac12\Phi$,

$$ t\sqrt{2gc} = -b\,l\tan\tfrac12\omega + \frac{2cc}{3b}\cos^3\omega, \tag{2} $$

and {{sec globe.22}}, where now $\zeta\zeta bb = 4gcnn$, becomes

$$ \begin{aligned} 2nt\sqrt{gc} &= \Phi\Bigl(b + \frac{cc}{4b} + \frac b{2nn}\Bigr) \\
   &\quad - \frac{cc}{8b}\sin2\Phi - \frac b{2nn}\sin\Phi. \end{aligned} \tag{3} $$

::: margin
Today: $h = \frac12nn$, the energy over what the top asks for; Case II is $h = 1$.
:::

That rolling is slower is right, and for more than a small $c$. With the same $h$ the times differ only by
what stands under the upper root, and for the ball that rolls this is

$$ \begin{aligned} &aa+cc+kk-2ac\cos\Phi \\
   &= kk + cc\sin^2\Phi + (a - c\cos\Phi)^2: \end{aligned} \tag{A} $$

it is more by the square of the height of $G$ above the plane.

But the rule is not right. On the smooth plane $G$ only goes up and down, and what that adds to $kk$ is of the
order $cc$. The ball that rolls turns about its point of contact, whose distance from $G$ grows from $a-c$ to
$a+c$ and falls again; so there is a term of the order $c$ itself,

$$ \sqrt{bb + 4ac\sin^2\tfrac12\Phi} = b + \frac{2ac}b\sin^2\tfrac12\Phi - \ldots, $$

and it goes not with $2\Phi$, but with Φ. The rule leaves it out, and keeps a lesser one that has no
business there. To the first order in $c$ and $1:nn$ one has in place of {{eq 3}}

$$ \begin{aligned} 2nt\sqrt{gc} &= \Phi\Bigl(b + \frac{ac}b + \frac b{2nn}\Bigr) \\
   &\quad - \Bigl(\frac{ac}b + \frac b{2nn}\Bigr)\sin\Phi, \end{aligned} \tag{B} $$

and if the second order is wanted, too, on the right

$$ \begin{aligned} \Bigl(\frac{3b}{2n^4} &+ \frac{2ac}{bnn} - \frac{2aacc}{b^3}\Bigr) \\
   &\cdot\frac{6\Phi - 8\sin\Phi + \sin2\Phi}{16} \end{aligned} \tag{C} $$

besides. In Case II, where the time is elementary ({{sec globe.28}}), the first order is

$$ \begin{aligned} t\sqrt{2gc} = -&\Bigl(b + \frac{2ac}b\Bigr)\,l\tan\tfrac12\omega \\
   -&\frac{2ac}b\cos\omega. \end{aligned} \tag{D} $$

Here the rule is wrong in the logarithm itself: near the top its time is too short by as much as one
likes.

## The program

The place is given as the sine and cosine of ½Φ, that is as $\cos\omega$ and $\sin\omega$, so that the
top may be as near as one likes.
*/

template <class Real>
Real log_cot(const Place<Real>& at)  // −l tan ½ω
{
  using std::asinh;
  return asinh(at.s / at.c);
}

template <class Real>
Real rule_to_top(const Ball<Real>& ball, const Real& b, const Place<Real>& at)  // (2)
{
  return b * log_cot(at) + 2 * ball.c * (ball.c / b) / 3 * at.s * at.s * at.s;
}

template <class Real>
Real right_to_top(const Ball<Real>& ball, const Real& b, const Place<Real>& at)  // (D)
{
  const Real more = 2 * ball.a * (ball.c / b);
  return (b + more) * log_cot(at) - more * at.s;
}

template <class Real>
struct Angle
{
  Real Phi, sine, sine_of_twice;
};

template <class Real>
Real rule(const Ball<Real>& ball, const Real& b, const Real& n, const Angle<Real>& at)  // (3)
{
  const Real cc = ball.c * (ball.c / b), slow = b / (2 * n * n);
  return at.Phi * (b + cc / 4 + slow) - cc / 8 * at.sine_of_twice - slow * at.sine;
}

template <class Real>
Real right(const Ball<Real>& ball, const Real& b, const Real& n, const Angle<Real>& at)  // (B)
{
  const Real more = ball.a * (ball.c / b) + b / (2 * n * n);
  return at.Phi * (b + more) - more * at.sine;
}

template <class Real>
Real second_order(const Ball<Real>& ball, const Real& b, const Real& n, const Angle<Real>& at)  // (C)
{
  const Real ac = ball.a * (ball.c / b), nn = n * n;
  return (3 * b / (2 * nn * nn) + 2 * ac / nn - 2 * ac * (ac / b))
         * (6 * at.Phi - 8 * at.sine + at.sine_of_twice) / 16;
}

/*!
The exact times are Carlson's integrals. The ball and its $n$, and the place, can be chosen.
*/

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto n = real("n", 4, none, closed(1.5, 1e50), "of the fast turning: ζζbb = 4gcnn");
const auto where = asked_place(90_deg);

template <class Real>
Angle<Real> angle_of(const Real& Phi, const Place<Real>& at)
{
  const Real sine = 2 * at.s * at.c;
  return {Phi, sine, 2 * sine * (at.c - at.s) * (at.c + at.s)};
}

template <class Real>
Angle<Real> whole_turn()
{
  return {2 * Real(exact::pi()), 0, 0};
}

TELL
{
  const Ball<double> ball = rounded_ball(a, c, k);
  require(c <= 1e9 * k, "c", "at most a thousand million k");
  const Place<double> at = rounded(where.fifty());
  const bool by_psi = where.psi != 0;
  require((by_psi ? at.c : at.s) >= 1e-300, by_psi ? "psi" : "Phi", "at least 2e-300 rad");
  require((by_psi ? at.s : at.c) >= 1e-33, by_psi ? "psi" : "Phi",
          "less than 180° by 2e-33 rad or more: nearer by the other of the two angles");
  const Energy<double> e = rounded(energy(Fifty(n.fifty() * n.fifty() / 2)));
  const double b = std::hypot(ball.gap, k), second = std::sqrt(2 * g) * std::sqrt(c);
  const double fast = std::sqrt(2.) * n * second;  // 2n√gc
  const Angle<double> turned = angle_of(static_cast<double>(where.angle()), at);
  const double exact_turn = 2 * rolling::quarter(ball, e) / second;
  const double rule_turn = rule<double>(ball, b, n, whole_turn<double>()) / fast;
  const double right_turn = right<double>(ball, b, n, whole_turn<double>()) / fast;
  const double second_turn = second_order<double>(ball, b, n, whole_turn<double>()) / fast + right_turn;
  tell("b", b, feet, "to be written for k, (1)");
  tell("turn", exact_turn, seconds, "a whole turn, exactly");
  tell("turn_rule", rule_turn, seconds, "by the rule, (3)");
  tell("turn_right", right_turn, seconds, "by (B)");
  tell("turn_second", second_turn, seconds, "by (B) with (C)");
  tell("turn_smooth", 2 * smooth::quarter<double>(c, k, e) / second, seconds,
       "on a smooth plane, with the same n");
  tell("turn_mean", rule<double>(ball, std::sqrt(b * b + 2 * a * c), n, whole_turn<double>()) / fast,
       seconds, "by (3) with the root of aa + cc + kk for b");
  tell("n_most", std::sqrt(2 * rolling::loss_of_pressure(ball).h),
       "the greatest n with which the plane bears the rolling ball all the way");
  tell("n_most_smooth", std::sqrt(2 * smooth::lift_off_energy<double>(c, k)), "the same on a smooth plane");
  tell("fast", rolling::time(ball, e, at) / second, seconds, "to Φ, exactly");
  tell("fast_rule", rule<double>(ball, b, n, turned) / fast, seconds, "by the rule, (3)");
  tell("fast_right", right<double>(ball, b, n, turned) / fast, seconds, "by (B)");
  tell("top", rolling::time(ball, energy(1.), at) / second, seconds, "in Case II to Φ, exactly");
  tell("top_rule", rule_to_top(ball, b, at) / second, seconds, "by the rule, (2)");
  tell("top_right", right_to_top(ball, b, at) / second, seconds, "by (D)");
}

/*!
How far each is off, and how that goes with $c$:
*/

double part_off(double found, double exact)
{
  return (found - exact) / exact;
}

TELL
{
  auto& errors = table("errors", "Errors as parts of the time, a half of c at a time",
                       {{"c", "c (feet)", none, 4},
                        {"rule", "turn, rule", percent, 3},
                        {"right", "turn, (B)", percent, 3},
                        {"second", "turn, (B) + (C)", percent, 3},
                        {"top_rule", "Case II, rule", percent, 3},
                        {"top_right", "Case II, (D)", percent, 3}});
  const Place<double> at = rounded(where.fifty());
  const Energy<double> e = rounded(energy(Fifty(n.fifty() * n.fifty() / 2)));
  for(const double part : {1., 0.5, 0.25, 0.125})
  {
    const Ball<double> ball = rounded(Ball<Fifty>{a.fifty(), part * c.fifty(), k.fifty()});
    const double b = std::hypot(ball.gap, ball.k);
    const double turn = 2 * rolling::quarter(ball, e) * std::sqrt(2.) * n;
    const double top = rolling::time(ball, energy(1.), at);
    const double by_B = right<double>(ball, b, n, whole_turn<double>());
    errors.row({ball.c, part_off(rule<double>(ball, b, n, whole_turn<double>()), turn),
                part_off(by_B, turn),
                part_off(by_B + second_order<double>(ball, b, n, whole_turn<double>()), turn),
                part_off(rule_to_top(ball, b, at), top), part_off(right_to_top(ball, b, at), top)});
  }
}

TELL
{
  curve("orders", {"c", "rule", "right"}, [](Curve& orders) {
    const Place<double> at = rounded(where.fifty());
    for(int i = 0; i <= 60; ++i)
    {
      const Ball<double> ball{1, std::pow(10, -3 + i / 24.), k / a};
      const double b = std::hypot(ball.gap, ball.k), top = rolling::separatrix_time(ball, at);
      orders.put({ball.c, std::abs(part_off(rule_to_top(ball, b, at), top)),
                  std::abs(part_off(right_to_top(ball, b, at), top))});
    }
  });
}

TELL
{
  const Ball<double> ball = rounded_ball(a, c, k);
  const Energy<double> e = rounded(energy(Fifty(n.fifty() * n.fifty() / 2)));
  if(can_be_seen(ball, e.h))
    scene_of_ball("fast_turning", rolling_motion(ball, g, e));
}

/*!
With $n = 4$ our ball takes {{turn|6}} seconds for a turn; the rule gives {{turn_rule|6}}, {{eq B}} gives
{{turn_right|6}}. With just the velocity for the top it takes {{top|6}} seconds for the first right angle, by
the rule {{top_rule|6}}, by {{eq D}} {{top_right|6}}. The plane bears it, without having to pull, up to
$n = {{n_most|4}}$ ({{sec globe.27}}), and on a smooth plane up to {{n_most_smooth|4}}; with more the program
tells the times of a ball that is held down.

{{table errors}}

In Case II, when $c$ is halved, the rule's error is halved; were the rule as good as the formula of the smooth
plane, it would be sixteen times less ({{sec globe.17}}). In the columns of the turn there is an error, too,
that does not fall with $c$; it is owed to $n$.

::: figure globe-33
alt: Two straight lines in a logarithmic plot of error against c. The upper one, the rule's, has the slope
one; the lower one, steeper, has the slope two.

Case II: error as a part of the time to the place asked for, against $c$: of the rule (red) and of {{eq D}}
(blue). The rule errs in the first order of $c$, {{eq D}} in the second.
:::

::: scene fast_turning
alt: A ball on a level line with its centre of gravity just below the centre; a grey wave is the way of that
point.

The fast case in true time: two turns with {{n}} for $n$, from the lowest place, as far as the plane bears the
ball. A smaller $n$ makes the turning more uneven.
:::

## Speed against error

The time to Φ of the fast ball, by the rule, by what should stand in its place, and exactly.
*/

TELL
{
  const Ball<double> ball = rounded_ball(a, c, k);
  const Place<double> at = rounded(where.fifty());
  const Energy<Fifty> e0 = energy(Fifty(n.fifty() * n.fifty() / 2));
  const Energy<double> e = rounded(e0);
  const Angle<double> turned = angle_of(static_cast<double>(where.angle()), at);
  const double b = std::hypot(ball.gap, k), n_ = n, fast = std::sqrt(2.) * n_;
  race("time", "t√(2gc)", oracle::rolling_time(exact_ball(a, c, k), e0, where.fifty()),
       {{"rule, (3)", [=] { return rule(ball, b, n_, turned) / fast; }},
        {"first order, (B)", [=] { return right(ball, b, n_, turned) / fast; }, "series"},
        {"second order, (B) + (C)",
         [=] { return (right(ball, b, n_, turned) + second_order(ball, b, n_, turned)) / fast; }, "series"},
        {"Carlson's integrals", [=] { return rolling::time(ball, e, at); }}});
}

/*!
## Checks

The exact times are held against quadrature in fifty digits and against the equations of motion. The rule is
held against the smooth plane's integral of {{sec globe.16}} and {{sec globe.21}} with $b$ written for $k$,
the formulae {{eq B}} to {{eq D}} against their own integrals, with the powers of $c$ cut off under the
integral.
*/

struct Asked
{
  Ball<Fifty> ball;
  Fifty b, nn, second;
  Energy<Fifty> e;
  Place<Fifty> at;
};

Asked asked_now()
{
  const Ball<Fifty> ball = exact_ball(a, c, k);
  const Fifty nn = n.fifty() * n.fifty();
  return {ball, sqrt(bb(ball)), nn, sqrt(2 * g.fifty() * ball.c), energy(Fifty(nn / 2)), where.fifty()};
}

// ∫ of a polynomial in ss = sin² ½Φ from the lowest place: p0 + p1 ss + p2 ss² + p3 sin² Φ,
// over cos ½Φ where it just gets to the top, in tan ¼Φ.
Fifty integral(const std::array<Fifty, 4>& p, const Place<Fifty>& at, bool to_top)
{
  const auto integrand = [&](const Fifty& x) {
    const Fifty whole = 1 + x * x, s = 2 * x / whole, u = (1 - x) * (1 + x) / whole, ss = s * s;
    const Fifty f = p[0] + p[1] * ss + p[2] * ss * ss + p[3] * 4 * ss * u * u;
    return Fifty(f * 4 / whole / (to_top ? 2 * u : Fifty(1)));
  };
  return exact::integrate(integrand, 0, at.s / (1 + at.c)).value;
}

const Place<Fifty> half_turn{1, 0};

CHECK_THAT("the exact times are those of the rolling ball's integral, in fifty digits")
{
  for(const Told& now :
      told_at("", "n=1.5 c=0.5 k=0.5 psi=1e-9 g=3", "a=1e40 c=1e38 k=6e39 n=1e10 Phi=1",
              "c=1 k=0.01 Phi=179", "c=1e-30 psi=1e-200rad", "c=0.999999999 k=1e-9 Phi=1e-9rad"))
  {
    const Asked it = asked_now();
    const Fifty e_turn = 2 * oracle::rolling_quarter(it.ball, it.e) / it.second;
    CHECK(now.value("b", feet) == within_relative(it.b, 1e-15, "three roundings"));
    CHECK(now.value("turn", seconds) == within_relative(e_turn, 4e-15, "eight ulps and a root"));
    CHECK(now.value("fast", seconds)
          == within_relative(oracle::rolling_time(it.ball, it.e, it.at) / it.second, 4e-15,
                             "eight ulps, a root"));
    CHECK(now.value("top", seconds)
          == within_relative(oracle::rolling_time(it.ball, energy(Fifty(1)), it.at) / it.second, 6e-15,
                             "eight ulps of the greater of two terms, and a root"));
    const Fifty smooth = 2 * oracle::smooth_quarter(it.ball.c, it.ball.k, it.e) / it.second;
    CHECK(now.value("turn_smooth", seconds) == within_relative(smooth, 4e-15, "eight ulps and a root"));
    CHECK(e_turn > smooth);
  }
}

CHECK_THAT("a c of more than a thousand million k is refused, and an angle nearer to 0 or 180° than its "
           "digits tell")
{
  for(const char* const within_them :
      {"c=1e9 k=1", "c=2e9 k=2", "Phi=2e-300rad", "psi=2e-300rad",
       "Phi=179.9999999999999999999999999999998854", "psi=179.9999999999999999999999999999998854"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"c=1000000000.0000002 k=1", "c=2000000000.0000005 k=2", "Phi=1.999999999999999e-300rad",
       "psi=1.999999999999999e-300rad", "Phi=179.9999999999999999999999999999998855",
       "psi=179.9999999999999999999999999999998855"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("the equations of motion bring the rolling ball round in the time told")
{
  for(const Told& now : told_at("", "n=1.6 c=0.5 k=0.5", "n=20 c=0.9 k=0.3"))
  {
    const Asked it = asked_now();
    const Fifty turn = 2 * oracle::rolling_quarter(it.ball, it.e) / it.second;
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1] * turn,
                          rolling_accelerations<Fifty>(it.ball, g.fifty(), s[0], s[1]).Phi * turn};
    };
    const Fifty zeta = sqrt(2 * it.nn) * it.second / it.b;
    CHECK(exact::solve(motion, 0, {0, zeta}, 1, Fifty("1e-24")).y[0]
          == within(2 * exact::pi(), 1e-19, "steps of 1e-24"));
    CHECK(now.value("turn", seconds) == within_relative(turn, 4e-15, "eight ulps and a root"));
  }
}

CHECK_THAT(
    "up to the greatest n told the plane bears the ball all the way round, and with more it does not")
{
  for(const Told& now : told_at("", "c=0.5 k=0.5", "a=1e40 c=9e39 k=1e39", "c=1e-20"))
  {
    const Asked it = asked_now();
    const auto least = [&](const Fifty& n_, bool rolls) {  // what it bears, over all angles
      Fifty smallest = infinity;
      for(int i = 0; i <= 720; ++i)
      {
        const Fifty at = i * exact::pi() / 720;
        const Energy<Fifty> e = energy(Fifty(n_ * n_ / 2));
        const Place<Fifty> there = i == 720 ? half_turn : place(at);
        const Fifty ww = 2 * it.ball.c
                         * (rolls ? rolling::velocity_squared(it.ball, e, there)
                                  : smooth::velocity_squared(it.ball.c, it.ball.k, e, there));
        smallest =
            std::min(smallest, rolls ? rolling_accelerations<Fifty>(it.ball, 1, at, sqrt(ww)).pressure
                                     : accelerations<Fifty>(it.ball, 1, at, sqrt(ww), 0).pressure);
      }
      return smallest;
    };
    const Fifty loss = rolling::loss_of_pressure(it.ball).h, off = 1 + pow(it.ball.k / it.ball.c, 2) / 4;
    CHECK(now.value("n_most") == within_relative(sqrt(2 * loss), 1e-15, "an ulp, and a root"));
    CHECK(now.value("n_most_smooth") == within_relative(sqrt(2 * off), 1e-15, "some roundings"));
    for(const bool rolls : {false, true})
    {
      const Fifty most = sqrt(2 * (rolls ? loss : off));
      CHECK(least(most * Fifty("0.9999"), rolls) > 0);
      CHECK(least(most * Fifty("1.0001"), rolls) < 0);
    }
  }
}

CHECK_THAT("the scene is the rolling ball as the equation of §9 has it, as long as the plane bears it")
{
  for(const Told& now : told_at("", "n=1.6 c=0.5 k=0.5 a=2", "n=9 c=0.9 k=0.3 g=3"))
  {
    const Asked it = asked_now();
    const Fifty w = sqrt(4 * g.fifty() * it.ball.c * it.nn) / it.b;
    const auto frames = now.points("fast_turning", 7);
    for(const auto& frame : judged(frames, Plane::rough, it.ball, g.fifty(), 0, w))
    {
      CHECK(frame.told.value("t") == between(frame.earliest, frame.latest, "in their order"));
      CHECK(frame.pressure == between(-1e-9, infinity, "the plane bears it, to the last frame"));
      for(const Judged_ball::Number& one : frame.numbers())
        CHECK(one.told == within(one.right, frame.slack, Judged_ball::because));
    }
    const Fifty last = frames.back().at("Phi");
    if(last < 6)  // before one turn: the plane bears nothing there
    {
      const Fifty &a_ = it.ball.a, &c_ = it.ball.c, &k_ = it.ball.k;
      const Fifty over = 4 * g.fifty() * c_ * (it.nn - (1 - cos(last)));
      const Fifty ww = over / (a_ * a_ + c_ * c_ + k_ * k_ - 2 * a_ * c_ * cos(last));
      CHECK(rolling_accelerations<Fifty>(it.ball, g.fifty(), last, sqrt(ww)).pressure
            == within(0, 1e-9, "the angle, many times w"));
    }
  }
}

CHECK_THAT("the rule told is the smooth plane's integral cut off as Euler cuts it, with b for k")
{
  for(const Told& now :
      told_at("", "n=1.5 c=0.5 k=0.5 psi=1e-9 g=3", "a=1e40 c=1e38 k=6e39 n=1e10 Phi=1", "c=1e-30 Phi=170"))
  {
    const Asked it = asked_now();
    const Fifty b = it.b, cc = it.ball.c * it.ball.c, fast = sqrt(2 * it.nn) * it.second;
    const std::array<Fifty, 4> p{b, b / it.nn, 0, cc / (2 * b)};
    const char* const because = "a score of roundings";
    CHECK(now.value("turn_rule", seconds)
          == within_relative(2 * integral(p, half_turn, false) / fast, 3e-15, because));
    CHECK(now.value("fast_rule", seconds)
          == within_relative(integral(p, it.at, false) / fast, 3e-15, because));
    CHECK(now.value("top_rule", seconds)
          == within_relative(integral({b, 0, 0, cc / (2 * b)}, it.at, true) / it.second, 3e-15, because));
    const Fifty A = sqrt(b * b + 2 * it.ball.a * it.ball.c);
    CHECK(now.value("turn_mean", seconds)
          == within_relative(2 * integral({A, A / it.nn, 0, cc / (2 * A)}, half_turn, false) / fast, 3e-15,
                             because));
  }
}

CHECK_THAT("(B), (C) and (D) are the rolling ball's integral cut off at the first and the second order")
{
  for(const Told& now :
      told_at("", "n=1.5 c=0.5 k=0.5 psi=1e-9 g=3", "a=1e40 c=1e38 k=6e39 n=1e10 Phi=1", "c=1e-30 Phi=170"))
  {
    const Asked it = asked_now();
    const Fifty b = it.b, ac = it.ball.a * it.ball.c, fast = sqrt(2 * it.nn) * it.second;
    const Fifty first = 2 * ac / b + b / it.nn;
    const Fifty second = 3 * b / (2 * it.nn * it.nn) + 2 * ac / (b * it.nn) - 2 * ac * ac / (b * b * b);
    const char* const because = "a score of roundings, some of them of differences";
    CHECK(now.value("turn_right", seconds)
          == within_relative(2 * integral({b, first, 0, 0}, half_turn, false) / fast, 4e-15, because));
    CHECK(now.value("turn_second", seconds)
          == within_relative(2 * integral({b, first, second, 0}, half_turn, false) / fast, 6e-15, because));
    CHECK(now.value("fast_right", seconds)
          == within_relative(integral({b, first, 0, 0}, it.at, false) / fast, 4e-15, because));
    CHECK(now.value("top_right", seconds)
          == within_relative(integral({b, 2 * ac / b, 0, 0}, it.at, true) / it.second, 4e-15, because));
  }
}

CHECK_THAT(
    "for very small c the rule's error is of the first order, that of (B) and (D) of the second, with "
    "(C) of the third")
{
  const Fifty n_("1e25"), k_ = Fifty(3) / 5;  // 1 : nn is nothing here
  const Place<Fifty> at = place(Fifty(exact::pi() / 2));
  const Angle<Fifty> turn = whole_turn<Fifty>();
  std::array<Fifty, 5> before{};
  for(const char* const c_ : {"1e-6", "0.5e-6"})
  {
    const Ball<Fifty> ball{1, Fifty(c_), k_};
    const Fifty b = sqrt(bb(ball)), fast = sqrt(Fifty(2)) * n_;
    const Fifty exact_turn = 2 * rolling::quarter(ball, energy(Fifty(n_ * n_ / 2))) * fast;
    const Fifty top = rolling::separatrix_time(ball, at), by_B = right(ball, b, n_, turn);
    const std::array<Fifty, 5> errors{rule(ball, b, n_, turn) / exact_turn - 1, by_B / exact_turn - 1,
                                      (by_B + second_order(ball, b, n_, turn)) / exact_turn - 1,
                                      rule_to_top(ball, b, at) / top - 1,
                                      right_to_top(ball, b, at) / top - 1};
    CHECK(errors[0] == within_relative(-ball.a * ball.c / bb(ball), 1e-5, "to the first order"));
    const std::array<int, 5> halving{2, 4, 8, 2, 4};
    if(before[0] != 0)
      for(std::size_t i = 0; i < 5; ++i)
        CHECK(before[i] / errors[i] == within_relative(Fifty(halving[i]), 1e-5, "the next order"));
    before = errors;
  }
}

CHECK_THAT("the table's errors are those of the formulae in fifty digits")
{
  for(const Told& now : told_at("", "n=10 c=0.01 Phi=170", "a=1e-40 c=3e-41 k=1e-40 n=1.5 psi=1e-6"))
    for(const auto& row : now.rows("errors"))
    {
      const Asked it = asked_now();
      const Ball<Fifty> ball{it.ball.a, row.at("c"), it.ball.k};
      const Fifty b = sqrt(bb(ball)), ac = ball.a * ball.c, cc = ball.c * ball.c;
      const Fifty fast = sqrt(2 * it.nn), first = 2 * ac / b + b / it.nn;
      const Fifty second = 3 * b / (2 * it.nn * it.nn) + 2 * ac / (b * it.nn) - 2 * ac * ac / (b * b * b);
      const Fifty turn = oracle::rolling_quarter(ball, it.e) * fast;
      const Fifty top = oracle::rolling_time(ball, energy(Fifty(1)), it.at);
      const char* const because = "ulps of 1, of two times that nearly agree";
      const auto off = [&](const std::array<Fifty, 4>& p) {
        return Fifty(integral(p, half_turn, false) / turn - 1);
      };
      const auto top_off = [&](const std::array<Fifty, 4>& p) {
        return Fifty(integral(p, it.at, true) / top - 1);
      };
      CHECK(row.value("c") == between(c.fifty() / 9, c.fifty() * (1 + 1e-15), "c and parts of it"));
      CHECK(row.value("rule", percent) == within(off({b, b / it.nn, 0, cc / (2 * b)}), 1e-14, because));
      CHECK(row.value("right", percent) == within(off({b, first, 0, 0}), 1e-14, because));
      CHECK(row.value("second", percent) == within(off({b, first, second, 0}), 1e-14, because));
      CHECK(row.value("top_rule", percent) == within(top_off({b, 0, 0, cc / (2 * b)}), 1e-14, because));
      CHECK(row.value("top_right", percent) == within(top_off({b, 2 * ac / b, 0, 0}), 1e-14, because));
    }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("orders", 5))
    {
      const Ball<Fifty> ball{1, point.at("c"), k.fifty() / a.fifty()};
      const Fifty b = sqrt(bb(ball)), top = oracle::rolling_time(ball, energy(Fifty(1)), where.fifty());
      const Fifty by_rule = integral({b, 0, 0, ball.c * ball.c / (2 * b)}, where.fifty(), true);
      const Fifty by_D = integral({b, 2 * ball.c / b, 0, 0}, where.fifty(), true);
      CHECK(point.value("c") == between(1e-4, 1, "small"));
      CHECK(point.value("rule") == within(abs(by_rule / top - 1), 1e-14, "ulps of 1"));
      CHECK(point.value("right") == within(abs(by_D / top - 1), 1e-14, "ulps of 1"));
    }
}

CHECK_THAT("in the race each way gives what its formula gives")
{
  for(const Told& now : told_at("", "n=1.5 c=0.5 k=0.5 Phi=170", "n=100 c=0.001 Phi=1e-20"))
  {
    const Asked it = asked_now();
    const Fifty b = it.b, ac = it.ball.a * it.ball.c, cc = it.ball.c * it.ball.c, fast = sqrt(2 * it.nn);
    const Fifty first = 2 * ac / b + b / it.nn;
    const Fifty second = 3 * b / (2 * it.nn * it.nn) + 2 * ac / (b * it.nn) - 2 * ac * ac / (b * b * b);
    const char* const because = "a score of roundings, some of them of differences";
    CHECK(now.exact("time") == within_relative(rolling::time(it.ball, it.e, it.at), 1e-33, "two ways"));
    CHECK(now.method("time", "Carlson's integrals")
          == within_relative(rolling::time(it.ball, it.e, it.at), 4e-15, "eight ulps"));
    CHECK(
        now.method("time", "rule, (3)")
        == within_relative(integral({b, b / it.nn, 0, cc / (2 * b)}, it.at, false) / fast, 3e-15, because));
    CHECK(now.method("time", "first order, (B)")
          == within_relative(integral({b, first, 0, 0}, it.at, false) / fast, 4e-15, because));
    CHECK(now.method("time", "second order, (B) + (C)")
          == within_relative(integral({b, first, second, 0}, it.at, false) / fast, 6e-15, because));
  }
}

CHECK_THAT(
    "under the root rolling has more by the square of the height of G, at every angle and for every c")
{
  for(const Ball<Fifty>& ball : {our_ball<Fifty>, cradle<Fifty>, Ball<Fifty>{1, 3, Fifty(1) / 9}})
    for(const Place<Fifty>& at : {place(Fifty(1) / 3), place(Fifty(2)), place(Fifty(3))})
    {
      const Energy<Fifty> e = energy(Fifty(7));
      const Fifty y = ball.a - ball.c * (at.c - at.s) * (at.c + at.s);
      const Fifty left = 4 * left_for_motion(e, at);
      CHECK(left / rolling::velocity_squared(ball, e, at)  // (A)
            == within_relative(left / smooth::velocity_squared(ball.c, ball.k, e, at) + y * y, 1e-46,
                               "fifty digits"));
    }
}

CHECK_THAT("near the top the rule's time is short without bound")
{
  const Ball<Fifty> ball = our_ball<Fifty>;
  const Fifty b = sqrt(bb(ball));
  Fifty last = 0;
  for(const char* const psi : {"1e-10", "1e-20", "1e-40"})
  {
    const Place<Fifty> at = place_from_top(Fifty(psi));
    const Fifty lacks = rolling::separatrix_time(ball, at) - rule_to_top(ball, b, at);
    CHECK(lacks == between(last + 1, infinity, "more by a logarithm"));
    last = lacks;
  }
}

/*!
The root in {{eq 1}} has become a letter $v$ in our copy. The time of small rocking decides, as it did in
{{sec globe.30}}.
*/

const Emendation root{"§33, b",
                      {"(a − c)² + kk, without the root", 1.17},
                      {"√((a − c)² + kk)", std::sqrt(1.17)},
                      "a very small swing of our rolling ball takes πb/√(2gc), by quadrature",
                      [](double reading) {
                        const Fifty T = oracle::rolling_quarter(our_ball<Fifty>, energy(Fifty("1e-40")));
                        return reading == within_relative(T * 2 / exact::pi(), 1e-15, "a root, rounded");
                      }};

/*!
## Go on from here

::: exercise
Which length has to be written for $b$ in {{eq 3}}, if a single length is to make the time of a whole turn
right to the first order?
answer: $\sqrt{aa+cc+kk} = \sqrt{bb+2ac}$, for the mean of what stands under the root is $bb + 2ac$, and
$b + ac:b$ is its root to the first order. Our ball's turn comes out as {{turn_mean|6}} seconds. The
inequality within the turn, which goes with $\sin\Phi$, no length can supply.
:::
*/

CHECK_THAT("with the root of aa + cc + kk the time of a turn is right to the first order")
{
  const Fifty n_("1e25");
  Fifty before = 0;
  for(const char* const c_ : {"1e-6", "0.5e-6"})
  {
    const Ball<Fifty> ball{1, Fifty(c_), Fifty(3) / 5};
    const Fifty mean = sqrt(1 + ball.c * ball.c + ball.k * ball.k);
    const Fifty turn = 2 * rolling::quarter(ball, energy(Fifty(n_ * n_ / 2))) * sqrt(Fifty(2)) * n_;
    const Fifty error = rule(ball, mean, n_, whole_turn<Fifty>()) / turn - 1;
    if(before != 0)
      CHECK(before / error == within_relative(Fifty(4), 1e-5, "the next order"));
    before = error;
  }
}
