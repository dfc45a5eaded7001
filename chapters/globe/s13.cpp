#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "globe/asked.hpp"
#include "globe/ball.hpp"
#include "globe/gauss.hpp"
#include "globe/oracle.hpp"
#include "globe/smooth.hpp"
#include "swing/motion.hpp"
#include "swing/oracle.hpp"

SECTION(globe, 13, "The integral that resists")

using namespace globe;

/*!
## What Euler does

The time is an integral that in general, Euler says, cannot be found but by approximation; only a ball whose
two centres coincide gives it away. From the velocity to the motion is one more integration. In
{{sec globe.11}} he had, with ζ for the angular velocity at the lowest place,

$$ \begin{aligned} \frac{d\Phi^2}{dt^2}&(kk + cc\sin^2\Phi) \\
   &= \zeta\zeta kk - 4gc(1-\cos\Phi), \end{aligned} \tag{1} $$

and drawing the root he gets

$$ dt = \frac{d\Phi\sqrt{kk + cc\sin^2\Phi}}{\sqrt{\zeta\zeta kk - 4gc(1-\cos\Phi)}}. \tag{2} $$

This formula, he says, is such that it admits of no integration in general, and can be dealt with by
approximations alone. It would be quite easy if $c = 0$, where the centre of gravity falls into the
centre of the ball; for then

$$ dt = \frac{d\Phi}{\zeta}, \qquad \Phi = \zeta t, \tag{3} $$

and such a ball moves uniformly, in its progress as in its turning. The next sections pick three cases in
which {{eq 2}} yields: rocking by very little ({{sec globe.14}}), just the velocity for the top
({{sec globe.16}}), and very fast turning ({{sec globe.21}}).

::: margin
Today: under the roots there is a polynomial of the fifth degree in $\cos\Phi$: the integral is
hyperelliptic, of genus 2.
:::

He is right that {{eq 2}} is not to be had in general, even by the elliptic integrals that came later. But
three things can be said. First, let a pendulum have the same share $h$ of the energy that its top asks
for; it stops at the same angle as the ball. With $\tau = t\sqrt{2gc}$ for the ball's time and υ for the
pendulum's own,

$$ \begin{gathered} d\upsilon = \frac{\tfrac12\,d\Phi}{\sqrt{h - \sin^2\frac12\Phi}}, \\
   h = \frac{\zeta\zeta kk}{8gc}, \\
   d\tau = \sqrt{kk + cc\sin^2\Phi}\;d\upsilon. \end{gathered} \tag{A} $$

Here υ is elliptic, and the root is a smooth periodic function of υ. Such a function is integrated over
its period by the plainest of all rules, the mean of equally spaced values, and the error falls faster
than any power of their number. Secondly, there are velocities at which {{eq 2}} is elliptic after all.
One is Euler's Case II, $h = 1$ ({{sec globe.17}}). For the other, write the radicand above as
$cc\,(r - \cos\Phi)(r + \cos\Phi)$ with $r = \sqrt{1 + kk:cc}$, and the one below as
$4gc\,(2h - 1 + \cos\Phi)$. If $2h - 1 = r$, the second factor goes out:

$$ \begin{aligned} h_0 &= \tfrac12\Bigl(1 + \sqrt{1 + \tfrac{kk}{cc}}\Bigr), \\
   d\tau &= \frac c{\sqrt2}\sqrt{r - \cos\Phi}\;d\Phi. \end{aligned} \tag{B} $$

Thirdly, the time back and forth is not all: a reader wants the angle at a given time, too. The program
inverts the integral.

## The program

The rule for {{eq A}} is the mean of the root at equal steps of υ, times the pendulum's own quarter. A ball
that turns over has half a turn in place of a quarter of the period.
*/

swing::Motion pendulum(const Energy<double>& e)
{
  if(e.turns_over())
    return swing::Motion::revolving(-e.from_top);
  return swing::Motion(e.h < 0.5 ? swing::Amplitude::from_height(2 * e.h)
                                 : swing::Amplitude::from_depth(2 * e.from_top));
}

double by_pendulum(double c, double k, const Energy<double>& e, int n)  // (A), n steps
{
  const swing::Motion motion = pendulum(e);
  const double quarter = motion.period() / (e.turns_over() ? 2 : 4);
  double sum = 0;
  for(int i = 0; i <= n; ++i)
    sum += std::hypot(k, c * std::sin(motion.angle(i * quarter / n))) * (i % n == 0 ? 0.5 : 1);
  return sum * quarter / n;
}

/*!
The other ways take {{eq 2}} as it stands, in an angle ϑ that goes from 0 to 90° in the same quarter: with
$\sin\frac12\Phi = \sqrt h\sin\vartheta$ where the ball rocks, $\frac12\Phi = \vartheta$ where it turns
over.
*/

template <class Real>
Real rate(const Real& c, const Real& k, const Energy<Real>& e, const Real& theta)  // (2), dτ/dϑ
{
  using std::cos, std::sin, std::sqrt;
  const Real ss = sin(theta) * sin(theta), tt = cos(theta) * cos(theta);
  const Real most = e.turns_over() ? Real(1) : e.h;
  const Real left = e.turns_over() ? Real(tt - e.from_top) : Real(e.from_top + e.h * tt);
  return sqrt(Real(k * k + 4 * c * c * most * ss * (e.turns_over() ? tt : left))) / sqrt(left);
}

double by_angle(double c, double k, const Energy<double>& e, int n)  // the same rule, even in ϑ
{
  const double right = std::numbers::pi / 2;
  double sum = (rate(c, k, e, 0.) + rate(c, k, e, right)) / 2;
  for(int i = 1; i < n; ++i)
    sum += rate(c, k, e, i * right / n);
  return sum * right / n;
}

/*!
The energy may be given as $h$, as what it lacks of the top, or as ζ; the place as Φ or as what that
lacks of 180°. Near the top it is the small number that tells. To a place that it never reaches the ball
takes an infinite time.
*/

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto asked = asked_energy(0.5);
const auto where = asked_place(60_deg);
const auto t = real("t", 0.3, seconds, closed(0, 1e100), "time since the lowest place");

Fifty beyond()  // by how much h is greater than §20 allows
{
  const Fifty r = k.fifty() / c.fifty();
  return -asked.smooth(c, k, g).from_top - r * r / 4;
}

TELL
{
  require(c <= 100 * k, "c", "between 1e-40 and a hundred times k");
  require(k <= 1e40 * c, "c", "between 1e-40 and a hundred times k");
  const Energy<Fifty> e0 = asked.smooth(c, k, g);
  const Place<Fifty> place0 = where.fifty();
  const auto e = rounded(e0);
  const double second = std::sqrt(2 * g) * std::sqrt(c);  // what one second is in τ
  const double quarter = smooth::quarter<double>(c, k, e);
  require(e.from_top != 0 || t <= 600 * k / second, "t", "at most 600 k:√(2gc) where h is 1");
  require(e.from_top == 0 || t <= 1e3 * quarter / second, "t", "the time of 500 swings or whole turns");
  const Turned turned = smooth::angle(c, k, e, t * second);
  const auto second_energy = smooth::second_energy<double>(c, k);
  tell("energy", e.h, "h, the energy as a part of what the top asks for");
  tell("below_top", e.from_top, "1 − h");
  tell("swing", 2 * quarter / second, seconds, "a single swing; where the ball turns over, a whole turn");
  tell("t_Phi",
       gets_to(e0, place0) ? smooth::time<double>(c, k, e, rounded(place0)) / second
                           : std::numeric_limits<double>::infinity(),
       seconds, "from the lowest place to Φ");
  tell("Phi_t", turned.Phi, degrees, "the angle at the time t");
  tell("psi_t", turned.from_top, degrees, "what it lacks there of the top, or of the nearest one");
  tell("h_0", second_energy.h, "the second energy at which (2) is elliptic, (B)");
  tell("turn_0", 2 * second_energy.half_turn / second, seconds, "a whole turn with it");
  const double root = k / (c * (1 + std::hypot(1., k / c)));
  tell("top_0", root * root, "what the plane bears at the top with it, as a part of the weight");
  tell("h_most", smooth::lift_off_energy<double>(c, k),
       "the greatest h with which the ball stays on its plane");
  if(beyond() > 0)
  {
    const auto off = smooth::lift_off<double>(c, k, double(beyond()));
    tell("Phi_off", off.Phi, degrees, "where it leaves it; what is told beyond is of a ball held down");
    tell("t_off", off.tau / second, seconds, "when");
  }
}

TELL
{
  auto& errors = table("errors", "Errors of equal steps, for c = 1/10 and k = 3/5",
                       {{"from_top", "1 − h", none, 1},
                        {"upsilon_16", "16 of υ", none, 2},
                        {"upsilon_80", "80 of υ", none, 2},
                        {"theta_16", "16 of ϑ", none, 2},
                        {"theta_80", "80 of ϑ", none, 2}});
  for(const double below : {0.5, 1e-3, 1e-6, 1e-15, -1e-15, -1.})
  {
    const Energy<double> e = energy_from_top(below);
    const double quarter = smooth::quarter(0.1, 0.6, e);
    errors.row({below, by_pendulum(0.1, 0.6, e, 16) / quarter - 1,
                by_pendulum(0.1, 0.6, e, 80) / quarter - 1, by_angle(0.1, 0.6, e, 16) / quarter - 1,
                by_angle(0.1, 0.6, e, 80) / quarter - 1});
  }
}

TELL
{
  const std::array<double, 3> ratios{c / k, 1, 3};  // c:k, this ball's and two more
  curve("second", {"h", "quarter", "h_1", "quarter_1", "h_3", "quarter_3"}, [&](Curve& second) {
    std::vector<double> row;
    for(const double ratio : ratios)
    {
      const auto known = smooth::second_energy<double>(ratio, 1);
      row.insert(row.end(), {known.h, known.half_turn});
    }
    second.put(row);
  });
  curve("times", {"h", "quarter", "h_1", "quarter_1", "h_3", "quarter_3"}, [&](Curve& times) {
    for(int i = -100; i <= 100; ++i)
    {
      std::vector<double> row;
      for(const double ratio :
          ratios)  // 1 − h from 0.98 to 1e-6, and back to where the ball leaves the plane
      {
        const double end = i < 0 ? 0.98 : 1 - std::min(smooth::lift_off_energy<double>(ratio, 1), 10.);
        const double nearer = 1 - std::max(1, std::abs(i)) / 100.;
        const Energy<double> e = energy_from_top(end * std::pow(1e-6, nearer * nearer));
        row.insert(row.end(), {e.h, smooth::quarter<double>(ratio, 1, e)});
      }
      times.put(row);
    }
  });
}

/*!
Our ball, with half the energy that the top asks for, takes {{swing|8}} s for a single swing, and has turned
through {{Phi_t|6}} after {{t|3}} s. The energy {{eq B}} is {{h_0|6}} here, and a whole turn takes
{{turn_0|6}} s. By {{sec globe.20}} the ball leaves its plane before the top if $h$ is more than
{{h_most|4}}; the program tells where, and what it says of later times is of a ball that is held down.

{{table errors}}

Far from the top both rules are good. Near it the ball stays for long where ϑ hardly changes, and steps of ϑ
pass over that; steps of υ, the pendulum's own time, follow it.

::: figure globe-13
alt: The time of a quarter against the energy, for three balls. Each curve rises without end towards h =
1 from either side, the more eccentric ball's above the other; on its right branch a point marks the
second energy, and the branch ends soon after.

The time from the lowest place to rest, or over half a turn, in units of $k:\sqrt{2gc}$, for this ball
(blue) and for $c = k$ and $c = 3k$, up to the energy with which the ball leaves the plane. At $h = 1$
each is infinite. There and at the point marked, $h_0$, it is elliptic.
:::

## Speed against error

All ways are asked for the quarter period, or the half turn, and each rule is one with so many values. Ask
for `--from_top 1e-15`, or for `--c 6`.
*/

const Fifty c0 = our_ball<Fifty>.c, k0 = our_ball<Fifty>.k;
const std::vector<int> counts{8, 16, 32, 64};

TELL
{
  const auto e = rounded(asked.smooth(c, k, g));
  if(e.from_top == 0)
    return;  // nothing finite to compare
  const double c_ = c, k_ = k, right = std::numbers::pi / 2;
  std::vector<Method> ways;
  for(const int n : counts)
    ways.push_back(
        {"steps of υ, " + std::to_string(n), [=] { return by_pendulum(c_, k_, e, n); }, "even in υ"});
  for(const int n : counts)
    ways.push_back(
        {"steps of ϑ, " + std::to_string(n), [=] { return by_angle(c_, k_, e, n); }, "even in ϑ"});
  for(const int n : counts)
    ways.push_back({"Gauss in ϑ, " + std::to_string(n),
                    [=, gauss = Gauss(n)] {
                      return gauss([=](double theta) { return rate(c_, k_, e, theta); }, 0, right);
                    },
                    "Gauss"});
  ways.push_back({"this edition", [=] { return smooth::quarter(c_, k_, e); }});
  race("quarter", "τ", oracle::smooth_quarter(c.fifty(), k.fifty(), asked.smooth(c, k, g)), ways);
}

/*!
## Checks

The times are held against quadrature of {{eq 2}} in fifty digits, and against the equations of motion.
*/

CHECK_THAT("the times and angles told are those of the integral in fifty digits, near the top too")
{
  for(const Told& now : told_at("", "from_top=1e-15 psi=1e-3 t=0.9", "zeta=12 Phi=170 c=0.3 t=0.2",
                                "from_top=-1e-30 Phi=180 k=3 t=1", "h=1e-40 Phi=1e-30 g=1e50 t=1e-30"))
  {
    const Energy<Fifty> e = asked.smooth(c, k, g);
    const Fifty c_ = c.fifty(), k_ = k.fifty(), second = sqrt(2 * g.fifty() * c_);
    CHECK(now.value("energy") == within_ulps(e.h, 1, "rounded once"));
    CHECK(now.value("below_top") == within_ulps(e.from_top, 1, "rounded once"));
    CHECK(
        now.value("swing", seconds)
        == within_relative(2 * oracle::smooth_quarter(c_, k_, e) / second, 4e-15, "eight ulps and a root"));
    if(where.fifty().s * where.fifty().s <= e.h)
      CHECK(now.value("t_Phi", seconds)
            == within_relative(oracle::smooth_time(c_, k_, e, where.fifty()) / second, 1e-14,
                               "eight ulps, and what the place rounds"));
    const auto turned = oracle::smooth_place(c_, k_, e, t.fifty() * second);
    CHECK(now.value("Phi_t", degrees)
          == within_relative(2 * atan2(turned.s, turned.c), 1e-14, "ten ulps of τ, and a root"));
    CHECK(now.value("psi_t", degrees)
          == within_relative(2 * atan2(turned.c, turned.s), 4e-14, "ten ulps of τ are more of ψ"));
  }
  for(const Told& now : told_at("h=1"))
    CHECK(now.value("swing", seconds) == infinite("with just the velocity for the top"));
  for(const Told& now : told_at("Phi=90.001", "h=1e-30", "h=1 Phi=180"))
    CHECK(now.value("t_Phi", seconds) == infinite("the ball stops before"));
}

CHECK_THAT("it refuses a c, an energy and a time just beyond its limits, and none on them")
{
  // With c = 1/8 and g = k = 1 h is ζζ; with c = 1 and g = 1/2 a second is one in τ.
  for(const char* const beyond :
      {"c=50.00000000000001 k=0.5", "c=100.00000000000002 k=1", "c=0.9999999999999998 k=1e40",
       "c=1.9999999999999996 k=2e40", "from_top=0.5 zeta=1e-300",
       "c=0.125 g=1 k=1 zeta=9.9999999999999999e-51", "c=0.125 g=1 k=1 t=0 zeta=1.0000000000000001e50",
       "h=1 c=1 g=0.5 k=1 t=600.0000000000002", "h=1 c=4 g=2 k=2 t=300.0000000000001"})
    CHECK(refused_at(beyond));
  for(const char* const within_them :
      {"c=50 k=0.5", "c=100 k=1", "c=1 k=1e40", "c=2 k=2e40", "from_top=0.5",
       "c=0.125 g=1 k=1 zeta=1.0000000000000001e-50", "c=0.125 g=1 k=1 t=0 zeta=1e50",
       "h=1 c=1 g=0.5 k=1 t=600", "h=1 c=4 g=2 k=2 t=300"})
    CHECK(!refused_at(within_them));
}

CHECK_THAT("where the time is not infinite it may be that of 500 swings or turns, and not of more")
{
  for(const char* const motion : {"", "c=0.5 k=0.5 h=3 g=2 ", "from_top=1e-9 ", "h=1e-40 "})
  {
    Fifty most;
    for(const Told& now : told_at(motion))
    {
      const Fifty swing = 2 * oracle::smooth_quarter(c.fifty(), k.fifty(), asked.smooth(c, k, g))
                          / sqrt(2 * g.fifty() * c.fifty());
      CHECK(now.value("swing", seconds) == within_relative(swing, 4e-15, "eight ulps and a root"));
      most = 500 * swing;
    }
    CHECK(!refused_at(motion + ("t=" + Fifty(most * (1 - Fifty(1e-12))).str(20))));
    CHECK(refused_at(motion + ("t=" + Fifty(most * (1 + Fifty(1e-12))).str(20))));
  }
}

CHECK_THAT("the time told brings the ball by the equations of motion to the angle asked for, and Φ is ζt "
           "where c vanishes")
{
  for(const Told& now : told_at("", "h=3 Phi=150", "zeta=20 Phi=90 c=0.5 k=0.5"))
  {
    const Energy<Fifty> e = asked.smooth(c, k, g);
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), second = sqrt(2 * g_ * c_);
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1], accelerations<Fifty>(Ball<Fifty>{1, c_, k_}, g_, s[0], s[1], 0).Phi};
    };
    const Fifty time = oracle::smooth_time(c_, k_, e, where.fifty()) / second;
    CHECK(now.value("t_Phi", seconds) == within_relative(time, 1e-14, "eight ulps and a root"));
    CHECK(exact::solve(motion, 0, {0, 2 * second * sqrt(e.h) / k_}, time).y[0]
          == within(where.angle(), 1e-28, "some hundred steps of 1e-32"));
  }
  const Fifty tiny("1e-30"), zeta = 3, h = zeta * zeta / (8 * tiny);  // g = k = 1
  const Fifty tau = oracle::smooth_time(tiny, 1, energy(h), place(Fifty(1)));
  CHECK(zeta * tau / sqrt(2 * tiny) == within(1, 1e-29, "(3), but for the share 1:h of the energy"));
}

CHECK_THAT("the second energy and its turn are those of the integral, whatever the ball")
{
  for(const Told& now : told_at("", "c=0.01", "c=50 k=1 g=1e-80", "c=1e-5 k=1"))
  {
    const Fifty r = k.fifty() / c.fifty(), h0 = (1 + sqrt(1 + r * r)) / 2;
    CHECK(now.value("h_0") == within_ulps(h0, 4, "two roots"));
    CHECK(now.value("turn_0", seconds)
          == within_relative(2 * oracle::smooth_quarter(c.fifty(), k.fifty(), energy(h0))
                                 / sqrt(2 * g.fifty() * c.fifty()),
                             4e-15, "eight ulps and a root"));
    // The top is the place at which the ball would leave the plane first.
    const Fifty w2 = 8 * g.fifty() * c.fifty() * (h0 - 1) / pow(k.fifty(), 2), root = sqrt(1 + r * r);
    const Ball<Fifty> ball{c.fifty() + k.fifty(), c.fifty(), k.fifty()};
    const Fifty bears = accelerations<Fifty>(ball, g.fifty(), exact::pi(), sqrt(w2), 0).pressure;
    CHECK(now.value("top_0") == within_relative(bears, 1e-15, "five roundings, some of them doubled"));
    CHECK(bears == within((root - 1) / (root + 1), 1e-38, "a difference from 1"));
    CHECK(bears > 0);
  }
}

CHECK_THAT(
    "with more than the greatest h told the ball is without pressure where and when it is told to leave")
{
  for(const Told& now :
      told_at("", "h=10.001", "from_top=-30 c=0.3 Phi=100", "h=1e9 k=1e-3 g=1e40 t=1e-24"))
  {
    const Energy<Fifty> e = asked.smooth(c, k, g);
    const Fifty c_ = c.fifty(), k_ = k.fifty(), second = sqrt(2 * c_);  // g = 1
    const Ball<Fifty> ball{c_ + k_, c_, k_};
    const auto bears = [&](const Fifty& h, const Place<Fifty>& there) {
      const Fifty w = second * sqrt(smooth::velocity_squared<Fifty>(c_, k_, energy(h), there));
      return accelerations<Fifty>(ball, 1, 2 * atan2(there.s, there.c), w, 0).pressure;
    };
    const Fifty most = 1 + pow(k_ / c_, 2) / 4;
    CHECK(now.value("h_most") == within_relative(most, 1e-15, "four roundings"));
    CHECK(bears(most, {1, 0}) == within(0, 1e-45, "fifty digits"));
    if(e.h <= most)
      continue;
    Fifty low = exact::pi() / 2, high = exact::pi();
    for(int i = 0; i < 150; ++i)
    {
      const Fifty middle = (low + high) / 2;
      (bears(e.h, place(middle)) > 0 ? low : high) = middle;
    }
    const Fifty t_off = oracle::smooth_time(c_, k_, e, place(low)) / second / sqrt(g.fifty());
    CHECK(now.value("Phi_off", degrees) == within_relative(low, 4e-15, "eight ulps, and the excess"));
    CHECK(now.value("t_off", seconds)
          == within_relative(t_off, 1e-14, "eight ulps, a root, and the excess"));
  }
}

template <class Function>
Fifty mean(int n, const Function& f)
{
  Fifty sum = (f(Fifty(0)) + f(Fifty(1))) / 2;
  for(int i = 1; i < n; ++i)
    sum += f(Fifty(i) / n);
  return sum / n;
}

Fifty steps_of_upsilon(const Fifty& c, const Fifty& k, const Energy<Fifty>& e, int n)
{
  using Oracle = swing::oracle::Motion;
  const Oracle motion = e.turns_over() ? Oracle::revolving(-e.from_top)
                                       : Oracle::from_eta(2 * atan2(sqrt(e.from_top), sqrt(e.h)));
  const Fifty quarter = motion.quarter();
  return quarter * mean(n, [&](const Fifty& x) { return hypot(k, c * sin(motion.angle(x * quarter))); });
}

Fifty steps_of_theta(const Fifty& c, const Fifty& k, const Energy<Fifty>& e, int n)
{
  const Fifty right = exact::pi() / 2;
  return right * mean(n, [&](const Fifty& x) { return rate<Fifty>(c, k, e, x * right); });
}

CHECK_THAT("the errors in the table are those of the rules, of υ near the top too")
{
  for(const Told& now : told_at(""))
    for(const auto& row : now.rows("errors"))
    {
      const Energy<Fifty> e = energy_from_top(Fifty(row.at("from_top")));
      const Fifty quarter = oracle::smooth_quarter(c0, k0, e);
      for(const int n : {16, 80})
      {
        const std::string many = std::to_string(n);
        CHECK(row.value(("upsilon_" + many).c_str())
              == within(steps_of_upsilon(c0, k0, e, n) / quarter - 1, 4e-15, "sixteen ulps of 1"));
        const Fifty late = steps_of_theta(c0, k0, e, n) / quarter;
        CHECK(row.value(("theta_" + many).c_str())
              == within(late - 1, 2e-14 * double(late), "n rounded values"));
      }
      CHECK(row.value("from_top") == between(-1, 0.5, "the energies that are told of"));
      CHECK(steps_of_upsilon(c0, k0, e, 80) == within_relative(quarter, 1e-14, "eighty steps suffice"));
      if(abs(e.from_top) < 1e-5)
        CHECK(abs(steps_of_theta(c0, k0, e, 80) / quarter - 1) > 0.01);
    }
}

CHECK_THAT("in the race each rule gives what it gives in fifty digits")
{
  for(const Told& now : told_at("", "from_top=1e-9", "zeta=9 c=0.4"))
  {
    const Energy<Fifty> e = asked.smooth(c, k, g);
    const Fifty c_ = c.fifty(), k_ = k.fifty(), right = exact::pi() / 2;
    CHECK(now.exact("quarter")
          == within_relative(smooth::quarter(c_, k_, e), 1e-35, "two ways of forty digits"));
    CHECK(now.method("quarter", "this edition")
          == within_relative(smooth::quarter(c_, k_, e), 4e-15, "eight ulps, and three rounded numbers"));
    for(const int n : counts)
    {
      const std::string many = std::to_string(n);
      CHECK(now.method("quarter", "steps of υ, " + many)
            == within_relative(steps_of_upsilon(c_, k_, e, n), 4e-15,
                               "n roots of rounded angles, and the quarter"));
      CHECK(now.method("quarter", "steps of ϑ, " + many)
            == within_relative(steps_of_theta(c_, k_, e, n), 2e-14, "n rounded values"));
      CHECK(now.method("quarter", "Gauss in ϑ, " + many)
            == within_relative(oracle::gauss(
                                   n, [&](const Fifty& x) { return rate<Fifty>(c_, k_, e, x); }, 0, right),
                               2e-14 + 2e-16 / std::sqrt(std::abs(double(e.from_top))),
                               "n rounded values, each by what an ulp of ϑ makes of it near the top"));
    }
  }
}

CHECK_THAT("the figure's times are those of the integral")
{
  const std::array<const char*, 3> h_of{"h", "h_1", "h_3"}, quarter_of{"quarter", "quarter_1", "quarter_3"};
  for(const Told& now : told_at(""))
  {
    const std::array<Fifty, 3> ratios{c.fifty() / k.fifty(), 1, 3};
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Fifty r = sqrt(1 + pow(1 / ratios[i], 2));
      const auto root = [&](const Fifty& x) { return sqrt(r - cos(x)); };  // (B)
      for(const auto& point : now.points("second", 1))
      {
        CHECK(point.value(h_of[i]) == within_ulps((1 + r) / 2, 4, "two roots"));
        CHECK(point.value(quarter_of[i])
              == within_relative(ratios[i] / sqrt(Fifty(2)) * exact::integrate(root, 0, exact::pi()).value,
                                 4e-15, "eight ulps"));
      }
      for(const auto& point : now.points("times", 7))
      {
        const Energy<Fifty> e = energy(Fifty(point.at(h_of[i])));
        CHECK(point.value(h_of[i])
              == between(0.02, double(1 + 1 / (4 * pow(ratios[i], 2))), "up to the limit of §20"));
        CHECK(point.value(quarter_of[i])
              == within_relative(oracle::smooth_quarter(ratios[i], 1, e), 2e-10,
                                 "h has lost digits of 1 − h, an ulp of 1 against 1e-6"));
      }
    }
  }
}

/*!
## Notes

That there are no other such energies than these two is not shown here.

## Go on from here

::: exercise
With the energy {{eq B}} the ball turns over. Does it stay on the plane? Find what the plane bears at the
top.
answer: By {{sec globe.10}} it bears $1 - 4cc(h-1):kk$ of the weight there, and with {{eq B}} that is
$(r-1):(r+1) = kk:cc(r+1)^2$, never negative. For our ball it is {{top_0|4}}.
:::
*/
