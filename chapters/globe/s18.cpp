#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "globe/ball.hpp"
#include "globe/gauss.hpp"
#include "globe/oracle.hpp"
#include "globe/scene.hpp"
#include "globe/scene_judge.hpp"
#include "globe/time.hpp"

SECTION(globe, 18, "The ball that never quite turns over")

using namespace globe;

/*!
## What Euler does

With just the velocity that the top asks for, the ball approaches the top for ever; Euler says why, and
works out when it has turned through a right angle. The plane is smooth. In {{sec globe.16}} the ball was
started with its centre of gravity $G$ straight below its centre $C$, and with one particular angular
velocity $\zeta$, that for which $\zeta\zeta kk = 8gc$; and since the distance $CG = c$ was very small,
{{sec globe.17}} could integrate. With $\Phi$ for the angle through which the ball has turned, and
$\omega = 90° - \tfrac12\Phi$, the time was

$$ t\sqrt{2gc} = \frac{2cc}{3k}\cos^3\omega - k\,l\tan\tfrac12\omega. \tag{1} $$

Now he asks what this says. At the start $\omega$ is $90°$; as $\Phi$ grows it shrinks. It cannot become so
small that the tangent is negative, for then the logarithm would be imaginary; and it cannot even become
zero, that is, $\Phi$ cannot become $180°$, because the time for that is infinite. So the ball never turns
so far that $G$ stands straight above $C$. It only comes ever nearer to it.

As an example he asks how long $G$ takes to rise through a right angle. Then $\Phi = 90°$, $\omega = 45°$,
and the tangent of $\tfrac12\omega = 22°\,30'$ is $\sqrt{(\sqrt2-1)/(\sqrt2+1)} = \sqrt2-1$, so that

$$ t\sqrt{2gc} = \frac{cc}{3k\sqrt2}{{entry one_k}} + k\,l\,(1+\sqrt2){{entry sign}}, \tag{2} $$

which gives the time $t$ in seconds.

::: margin
Today: $2g$ is the acceleration of gravity, $k$ the radius of gyration about $G$, $l$ the natural logarithm.
This motion is the *separatrix* between rocking and turning over.
:::

Our copy has {{eq 2}} otherwise; *Checks* has the readings, and why we read as above. For {{eq 1}} see
{{sec globe.17}}.

## The program

Formula {{eq 1}} and the term that follows it in the expansion are shared. The logarithm is taken as an
inverse hyperbolic sine, which keeps its digits at the start of the motion too.

::: code globe/time.hpp by_euler (1)
:::

What does {{eq 1}} leave out? In {{sec globe.16}} Euler replaced $\sqrt{kk+cc\sin^2\Phi}$ by
$k + cc\sin^2\Phi/2k$. There is no need to. With $v = \sin\tfrac12\Phi$ the integral of {{sec globe.13}} can
be split without any neglect:

$$ \begin{aligned} &t\sqrt{2gc} = k\,l\cot\tfrac12\omega \\
   &+ \int_0^{\cos\omega}\!\!\frac{4ccvv\,dv}{k+\sqrt{kk+4ccvv(1-vv)}}. \end{aligned} \tag{A} $$

The first term is Euler's logarithm, unaltered; the integral stays finite up to the top. So his conclusion
does not hang on a small $c$: the time to the top is infinite for every ball. And where the root is replaced
by its least value $k$, {{eq A}} becomes {{eq 1}}: his time is always a little too long.
*/

template <class Real>
Real rest(const Real& c, const Real& k, const Real& v)  // (A), the integrand
{
  using std::sqrt;
  return 4 * c * v * v * (c / (k + sqrt(k * k + 4 * c * c * v * v * (1 - v) * (1 + v))));
}

/*!
By how much? With $R$ for the root, $2cc\,vv:k$ exceeds the integrand by $2cc\,vv\,(R-k) : k(k+R)$, and
$R - k$ is $4cc\,vv(1-vv) : (k+R)$. So nothing need be subtracted:
*/

Fifty too_long(const Fifty& r, const Fifty& w)  // (1) less (A), over k; r is c/k
{
  const Fifty end = cos(w), rr = r * r;
  const auto part = [&](const Fifty& u) {  // v = u cos ω
    const Fifty vv = pow(end * u, 2), q = 4 * rr * vv * (1 - vv), root = 1 + sqrt(1 + q);
    return Fifty(pow(u, 4) * (1 - vv) / (root * root));
  };
  return 8 * rr * rr * pow(end, 5) * exact::integrate(part, 0, 1, Fifty("1e-22")).value;
}

/*!
Euler holds that the integral of {{sec globe.13}} cannot be had in general. At this one velocity it can:
it is elliptic. In Carlson's symmetric integrals all that is infinite at the top stands in one elementary
term.

::: code globe/time.cpp time
:::

Euler gives no numbers. Ours are a homogeneous ball of weight 4/5 and radius 1 foot with a pellet of weight
1/5 halfway between centre and surface. The angle is given as his ω, the quantity that is small near the
top; `--omega 1e-300rad` is a good question.
*/

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto omega =
    angle("omega", 45_deg, from_below(1e-300_deg, 90_deg), "half of what Φ is short of 180°");

const Fifty c0 = our_ball<Fifty>.c, k0 = our_ball<Fifty>.k, half_right = exact::pi() / 4;

TELL
{
  require(c <= 100 * k, "c", "at most a hundred times k");
  const Fifty c_ = c.fifty(), k_ = k.fifty(), w = omega.fifty();
  const Fifty second = sqrt(2 * g.fifty() * c_);  // what one second is in t√2gc
  const Fifty exact = separatrix_time(c_, k_, w), euler = separatrix_time_by_euler(c_, k_, w);
  const double equal = separatrix_time_by_euler(1., 1., 45_deg) / separatrix_time(1., 1., 45_deg);
  tell("t_euler", double(euler / second), seconds, "time until Φ = 180° − 2ω, by Euler's formula (1)");
  tell("t", double(exact / second), seconds, "the same, exactly");
  const Fifty late = too_long(c_ / k_, w) * k_ / exact;
  if(late > 1e-300)
    tell("late", double(late), percent, "by how much Euler's time is too long");
  tell("late_equal", equal - 1, percent, "by how much (2) is too long with c = k");
  tell("tenfold", double(k_ * log(Fifty(10)) / second), seconds,
       "time, near the top, to come ten times nearer");
  tell("tau", separatrix_time(c0, k0, half_right), "t√(2gc) at 90° for c = 1/10, k = 3/5");
}

TELL
{
  curve("climb", {"time", "x", "y"}, [](Curve& curve) {
    const double third = separatrix_time<double>(c, k, 45_deg) / 3;
    for(int n = 0; n <= 15; ++n)
    {
      const double missing = 2 * separatrix_angle(c, k, n * third);
      curve.put({n * third / std::sqrt(2 * g * c), -std::sin(missing), std::cos(missing)});
    }
  });
}

TELL
{
  const Ball<double> ball{1, c, k};  // drawn with the radius of our ball
  if(can_be_seen(ball, 1))
    scene_of_ball("approach", smooth_motion(ball, g, energy(1.), 0));
}

/*!
The ball takes {{t|6}} s for the right angle, and Euler's formula is late by {{late|2}}, although $c$ is a
sixth of $k$; even where $c = k$ it would be late by no more than {{late_equal|2}}.

::: figure globe-18
alt: The circle that G describes about C, with G at equal intervals of time. From the lowest point it goes
up on the left in long steps; a quarter of the circle is done after three of them; then the steps shrink,
and below the top the points run into one another without reaching it.

Where $G$ stands with respect to $C$ at equal intervals of time, three to the right angle. Near the top it
needs {{tenfold|3}} s to come ten times nearer, and again {{tenfold|3}} s for every next ten times.
:::

::: scene approach
alt: A ball on a level line turns half round, ever more slowly. A grey line, upright and short, is the way of
its centre of gravity, which in the end stands nearly above the centre.

The motion in true time, with a radius of 1 foot: $G$ goes straight up, since nothing pushes it sideways, and
hardly moves any more while there is still a little of the half turn to do.
:::

## Speed against error
*/

TELL
{
  const double c_ = c, k_ = k, w = omega;
  std::vector<Method> ways{{"Euler's formula (1)", [=] { return separatrix_time_by_euler(c_, k_, w); }},
                           {"and the next term", [=] {
                              return separatrix_time_by_euler(c_, k_, w) + separatrix_next_term(c_, k_, w);
                            }}};
  for(const int n : {2, 4, 6, 8})
    ways.push_back({"rest by Gauss, " + std::to_string(n) + " nodes",
                    [=, gauss = Gauss(n)] {
                      return k_ * std::asinh(1 / std::tan(w))
                             + gauss([=](double v) { return rest<double>(c_, k_, v); }, 0, std::cos(w));
                    },
                    "logarithm taken out"});
  ways.push_back({"Carlson's integrals", [=] { return separatrix_time(c_, k_, w); }});
  race("tau", "t√(2gc)", separatrix_time<Fifty>(c.fifty(), k.fifty(), omega.fifty()), ways);
}

/*!
## Checks

The exact time is confirmed by Euler's three equations of motion ({{sec globe.06}}, {{sec globe.07}}), which
know nothing of any integral.
*/

CHECK_THAT("by the equations of motion the ball has turned through a right angle at the exact time")
{
  const auto motion = [](const Fifty&, const exact::State& s) {
    return exact::State{s[1], accelerations<Fifty>(our_ball<Fifty>, our_g<Fifty>, s[0], s[1], 0).Phi};
  };
  const Fifty second = sqrt(2 * our_g<Fifty> * c0);
  const Fifty t = separatrix_time(c0, k0, half_right) / second;
  CHECK(exact::solve(motion, 0, {0, 2 * second / k0}, t).y[0]
        == within(2 * half_right, 1e-29, "some hundred steps of 1e-32 each"));
}

CHECK_THAT("the integral (A) by Gauss's rule is the exact time, at a right angle and close to the top")
{
  const Gauss gauss(20);
  for(const double w : {45_deg, 1e-9})
    CHECK(0.6 * std::asinh(1 / std::tan(w))
              + gauss([](double v) { return rest(0.1, 0.6, v); }, 0, std::cos(w))
          == within_ulps(separatrix_time<Fifty>(0.1, 0.6, w), 4, "a logarithm and twenty rounded terms"));
}

CHECK_THAT("the tangent of 22°30′ is √2 − 1, and with it (1) becomes (2)")
{
  const char* const because = "a few units of the fiftieth digit";
  const Fifty r = sqrt(Fifty(2));
  CHECK(tan(half_right / 2) == within(sqrt((r - 1) / (r + 1)), 1e-49, because));
  CHECK(tan(half_right / 2) == within(r - 1, 1e-49, because));
  CHECK(separatrix_time_by_euler(c0, k0, half_right)
        == within(c0 * c0 / (3 * k0 * r) + k0 * log(1 + r), 1e-49, because));  // (2)
}

/*!
How good is {{eq 1}}? Since $\sqrt{1+x}$ lies between $1+\frac12x-\frac18xx$ and $1+\frac12x$, the truth
lies between {{eq 1}} and {{eq 1}} with the next term.
*/

CHECK_THAT("for every eccentricity and angle the time lies between Euler's and Euler's with the next term")
{
  for(const double r : {0.01, 1.0 / 6, 1.0, 4.0})
    for(const double w : {89_deg, 45_deg, 1_deg, 1e-20, 1e-300})
    {
      const Fifty euler = separatrix_time_by_euler<Fifty>(r, 1, w),
                  next = separatrix_next_term<Fifty>(r, 1, w);
      const Fifty time = separatrix_time<Fifty>(r, 1, w);
      CHECK(time == between(euler + next, euler, "√(1+x) is between 1+x/2−xx/8 and 1+x/2"));
      if(r < 0.1)
        CHECK(time - euler
              == within_relative(next, r * r / 2, "the term after it is 0.41 cc/kk times as large"));
    }
}

CHECK_THAT("near the top each halving of what is missing takes k l 2, without end; doubles keep up with it")
{
  for(const double w : {1e-12, 1e-100, 1e-300})
  {
    const Fifty halving = separatrix_time(c0, k0, Fifty(w) / 2) - separatrix_time(c0, k0, Fifty(w));
    CHECK(halving == within(k0 * exact::ln2(), 1e-22, "what is left out is of the order of ωω"));
    CHECK(separatrix_time(0.1, 0.6, w)
          == within_ulps(separatrix_time<Fifty>(0.1, 0.6, w), 10, "the library's bound"));
  }
}

/*!
Now the readings. A letter s stands in our copy where {{eq 2}} has its 3, and the $k$ is doubled. As it is
mended the example has the coefficient $2cc:3k$ of {{eq 1}}, which our copy lacks in {{sec globe.17}}; with
$cc:3k$ it would have $6k\sqrt2$. The sign of the logarithm in {{eq 2}} may be mended in two ways, and no
calculation can tell which was set. The proof is the motion of our ball.
*/

bool is_the_time(double reading)
{
  const Fifty lowest = reading + separatrix_next_term(c0, k0, half_right);
  return separatrix_time(c0, k0, half_right) == between(lowest, reading, "the next term is the bound");
}

const double first = 0.01 / (3 * 0.6 * std::sqrt(2.)), last = 0.6 * std::log(1 + std::sqrt(2.));

const Emendation one_k{"§18, the example, the first denominator",
                       {"skk√2", first / 0.6 + last},
                       {"3k√2", first + last},
                       "t√2gc is a length, and the motion takes that time",
                       is_the_time};

const Doubtful sign{"§18, the example, the last term",
                    {"− k l(1+√2)", first - last},
                    {"+ k l(1+√2), or − k l(√2−1)", first + last},
                    "with the minus the ball would be there before it starts",
                    is_the_time};

/*!
What is told is held against {{eq A}} in fifty digits, and the figures against the equations of motion and
against that integral.
*/

Fifty by_rest(const Fifty& c, const Fifty& k, const Fifty& w)  // (A)
{
  return k * asinh(1 / tan(w))
         + exact::integrate([&](const Fifty& v) { return rest(c, k, v); }, 0, cos(w)).value;
}

Fifty euler(const Fifty& c, const Fifty& k, const Fifty& w)  // (1), as it stands there
{
  return 2 * c * c / (3 * k) * pow(cos(w), 3) - k * log(tan(w / 2));
}

CHECK_THAT("the times and the race told are (1), its next term, (A), and Gauss's rule, in fifty digits")
{
  for(const Told& now : told_at("", "c=0.6 omega=30", "c=40 k=1 omega=1e-300 g=1e-90", "c=1e-50 omega=80",
                                "c=50 k=1 omega=89.9999999"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), w = omega.fifty(), second = sqrt(2 * g.fifty() * c_);
    const Fifty t = by_rest(c_, k_, w), late = euler(c_, k_, w) / t - 1;
    // An ulp of ω is this part of what it lacks of a right angle.
    const double slack = 3e-15 + 4e-16 / std::cos(omega);
    const char* const because = "the library's ten ulps, a root, a quotient, and an ulp of ω";
    CHECK(now.value("t", seconds) == within_ulps(t / second, 1, "rounded once"));
    CHECK(now.value("t_euler", seconds) == within_ulps((1 + late) * t / second, 1, "rounded once"));
    const Fifty first = 2 * pow(c_ / k_, 4) * pow(cos(w), 5) * (Fifty(1) / 5 - pow(cos(w), 2) / 7) * k_ / t;
    CHECK(now.value("late", percent)
          == (c_ < k_ / 10'000
                  ? within_relative(first, 1e-15, "the next term; the one after it is smaller by cc:kk")
                  : within(late, 1e-15 * double(late) + 1e-38, "forty digits of either time")));
    CHECK(now.value("late_equal", percent)
          == within(euler(1, 1, half_right) / by_rest(1, 1, half_right) - 1, 2e-15, "six roundings of 1"));
    CHECK(now.value("tenfold", seconds) == within_ulps(k_ * log(Fifty(10)) / second, 1, "rounded once"));
    CHECK(now.value("tau") == within(by_rest(c0, k0, half_right), 1e-38, "both to forty digits"));
    CHECK(now.exact("tau") == within_relative(t, 1e-38, "another way of fifty digits"));
    CHECK(now.method("tau", "Euler's formula (1)") == within_relative((1 + late) * t, slack, because));
    const Fifty r = c_ / k_, v = cos(w);
    const Fifty next = -2 * k_ * pow(r, 4) * pow(v, 5) * (Fifty(1) / 5 - v * v / 7);
    CHECK(now.method("tau", "and the next term")
          == within((1 + late) * t + next, slack * double((1 + late) * t - next), "a sum of two"));
    CHECK(now.method("tau", "Carlson's integrals") == within_relative(t, slack, because));
    const auto integrand = [&](const Fifty& x) { return rest(c_, k_, x); };
    for(const int n : {2, 4, 6, 8})
      CHECK(now.method("tau", "rest by Gauss, " + std::to_string(n) + " nodes")
            == within_relative(k_ * asinh(1 / tan(w)) + oracle::gauss(n, integrand, 0, v), slack, because));
  }
}

CHECK_THAT("a ball whose c is more than a hundred times k is refused, and one whose c is just that is not")
{
  for(const char* const within_them : {"c=100 k=1", "c=200 k=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"c=100.00000000000001 k=1", "c=200.00000000000003 k=2"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("the points of the climb are where the equations of motion bring the ball in those times")
{
  for(const Told& now : told_at(""))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), second = sqrt(2 * g_ * c_);
    const Ball<Fifty> ball{c_ + k_, c_, k_};  // its radius does not come in
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1], accelerations<Fifty>(ball, g_, s[0], s[1], 0).Phi};
    };
    const Fifty third = by_rest(c_, k_, half_right) / second / 3;
    for(const auto& point : now.points("climb", 6))
    {
      const double n = std::round(point.at("time") / double(third));
      CHECK(point.value("time") == within_relative(n * third, 2e-15, "the library's four ulps and a root"));
      const Fifty Phi = exact::solve(motion, 0, {0, 2 * second / k_}, n * third).y[0];
      CHECK(point.value("x") == within(-sin(Phi), 2e-14, "the library's twenty ulps of the time"));
      CHECK(point.value("y") == within(-cos(Phi), 2e-14, "the same"));
    }
  }
}

CHECK_THAT("the scene is the ball as the equations of motion have it, and it ends before the top")
{
  for(const Told& now : told_at("", "c=0.6", "c=0.05 k=1.2 g=2"))
  {
    const Ball<Fifty> ball{1, c.fifty(), k.fifty()};
    const Fifty zeta = sqrt(8 * g.fifty() * ball.c) / ball.k;
    for(const auto& frame : judged(now.points("approach", 7), Plane::smooth, ball, g.fifty(), 0, zeta))
    {
      CHECK(frame.told.value("t") == between(frame.earliest, frame.latest, "in their order"));
      CHECK(frame.told.value("Phi") == between(0, exact::pi(), "on the way up"));
      for(const Judged_ball::Number& one : frame.numbers())
        CHECK(one.told == within(one.right, frame.slack, Judged_ball::because));
    }
  }
}

/*!
## Notes

The radius of the ball does not come in: without friction the plane acts through $C$, however far below
$C$ it lies. Any uniform progress may be added, since by {{sec globe.10}} nothing changes the horizontal
velocity of $G$.

## Go on from here

::: exercise
How near is our ball to the top two seconds after it has passed its lowest place, and how near after twenty?
answer: Near the top $\cot\frac12\omega$ is $4:\psi$, with ψ for the $2\omega$ that is lacking, and the
integral of {{eq A}} has all but reached its value up to the top, 0.01106. So
$\psi = 4e^{-(t\sqrt{2gc} - 0.01106):k}$: after two seconds 0.644°, after twenty 6·10⁻²⁴ of a degree.
:::

::: exercise
The time to the top is infinite for every ball, by {{eq A}}. Is it so if all mass is in $G$, so that $k = 0$?
answer: No. The logarithm goes out, and the integral becomes $2c(1 - \cos\frac12\Phi)$, at the top $2c$. That
is the time $\sqrt{2c:g}$ of a fall through $2c$: $G$ is thrown straight up and comes to rest at the top. What
takes for ever is the dying turning about $G$.
:::
*/

CHECK_THAT("after two seconds 0.644° are lacking, and after twenty 6e-24 of a degree")
{
  const auto lacking = [](const char* time) {  // degrees
    const Fifty up = Fifty(time) * sqrt(2 * Fifty("15.625") / 10) - Fifty("0.01106");
    return Fifty(4 * exp(-up / (Fifty(3) / 5)) * 180 / exact::pi());
  };
  CHECK(lacking("2") == printed("0.644"));
  CHECK(lacking("20") == within(Fifty("6e-24"), 5e-25, "one figure"));
  for(const char* const time : {"2", "20"})
    for(const Told& now : told_at("omega=" + Fifty(lacking(time) / 2).str(15)))
      CHECK(now.value("t", seconds) == within_relative(Fifty(time), 1e-5, "the integral to four figures"));
}

CHECK_THAT("as k vanishes the time to Φ tends to that of a body thrown up, to the height 2c of the top")
{
  const auto tau = [](const Fifty& w) {  // (A) with v = (k:2c) sinh x
    const Fifty c_ = Fifty(1) / 10, k_ = Fifty("1e-10");
    const auto part = [&](const Fifty& x) {
      const Fifty s = sinh(x), v = k_ / (2 * c_) * s;
      return Fifty(k_ * s * s / (1 + sqrt(1 + s * s * (1 - v * v))) * k_ / (2 * c_) * cosh(x));
    };
    const auto end = exact::integrate(part, 0, asinh(2 * c_ * cos(w) / k_));
    return Fifty(end.value - k_ * log(tan(w / 2)));
  };
  for(const Fifty& w : {Fifty(exact::pi() / 4), Fifty(exact::pi() / 12), Fifty(exact::pi() / 180)})
  {
    // Thrown up to 2c it has yet to rise the part (1 − part of its time)² of that, which is 2c sin²ω.
    const Fifty part = 1 - sin(w);
    CHECK(tau(w) == within(part / 5, 1e-10, "less than k"));
    CHECK(2 * pow(1 - part, 2) == within(1 - cos(2 * w), 1e-45, "what is lacking of the height, over c"));
  }
}
