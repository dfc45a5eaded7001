#include "edition/section.hpp"
#include "globe/judge.hpp"
#include "globe/oracle.hpp"
#include "globe/path.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 32, "Cradles, and friction however small")

using namespace globe;

/*!
## What Euler does

What has been found holds not of balls alone but of all bodies that can rock on a level plane, and the amount
of the friction, Euler says, does not enter. Let a body $PRQ$ rock like a cradle, its base being curved where
it touches the plane, at $R$. Let $C$ be the centre of that curvature and $CR = a$; let $G$ be the centre of
gravity of the body at rest, with $CG = c$, so that $GR = a - c$. The weight is $P$, and $Pkk$ the moment of
inertia about the transverse axis through $G$, about which the body is to be thought of as turning while it
nods. Without any friction a single rocking will then take

$$ \frac{\pi k}{\sqrt{2gc}} \text{ seconds,} \tag{1} $$

but when friction is added, and be it the least, at once

$$ \frac{\pi\sqrt{(a-c)^2+kk}}{\sqrt{2gc{{entry under_root}}}}. \tag{2} $$

This, he says, gives what he once wrote on such motions the light that it needs. It is to be noted above all
that the quantity of friction is not part of the reckoning: the effect is the same as long as friction does
not vanish altogether.

::: margin
Today: the height of $G$ as a function of Φ is the *support function* $p$ of the base; $p(0) = a - c$ and
$p''(0) = c$, whatever its shape.
:::

The first statement is right for small rocking. Of any base only the radius of curvature at $R$ counts, since
the height of $G$ is $a - c + \frac12c\,\Phi\Phi$ but for higher powers; and $c$ must be positive, for with
$G$ above $C$ there is no rocking at all.

The second is right at any friction for amplitudes that are small enough, and at any amplitude wrong for
friction that is small enough. Where the body comes to rest for a moment at the angle Φ, rolling takes a
friction

$$ \lambda = \frac{c\,y\sin\Phi}{kk+yy}, \qquad y = a - c\cos\Phi, \tag{A} $$

which for a small angle is $(a-c)\Phi : l$, with $l = ((a-c)^2+kk):c$. A plane that gives μ lets it roll up to
a threshold $\Phi_*$, about $\mu l:(a-c)$, and no further. If the amplitude is kept and μ made to vanish, the
time goes over into that on the smooth plane, not into {{eq 2}}.

What becomes of a greater rocking? The body scrapes about each turning point and so loses of its amplitude.
Let it exceed $\Phi_*$ by a small ε, and count the time from the turning. There Φ is
$\Phi_* + \varepsilon - \frac12\alpha tt$, and what rolling would need beyond μ is $L\varepsilon - \beta tt$,
with $L$ for the derivative of {{eq A}}. So scraping begins at $-t_0$, with $\beta t_0^2 = L\varepsilon$. Its
velocity grows as that excess, it is as $t_0^2(t+t_0) - \frac13(t^3+t_0^3)$, or $(t+t_0)^2(2t_0-t)$, and ends
at $2t_0$: the body scrapes for $3t_0$, and what it loses is as $t_0^4$, that is as $\varepsilon\varepsilon$.
With the constants put in,

$$ \varepsilon' = \varepsilon - K\varepsilon\varepsilon + \ldots, \qquad
   K = \frac{9\,y\,UU}{2kk\,D\,V\sin\Phi_*}, \tag{B} $$

$$ \begin{aligned} U &= y\,(kk+yy)\cos\Phi_*\\ &\quad + c\,(kk-yy)\sin^2\Phi_*, \\
   V &= U + 2ckk\sin^2\Phi_*, \\ D &= aa+cc+kk-2ac\cos\Phi_*, \end{aligned} $$

where $y$ is that of $\Phi_*$. After $n$ swings ε is nearly $1:Kn$. So the body comes nearer and nearer to the
threshold, and never gets there: it scrapes and rolls by turns for ever. With a very small μ one has
$K\Phi_* = 9(a-c)^2:2kk$. The less friction, the smaller the amplitude to which {{eq 2}} belongs; but how many
swings it takes to be within a given part of it does not depend on friction.

## The program

The threshold is the end of the first window of {{sec globe.27}}. The motion is followed through all its
changes as in {{sec globe.08}}, in a measure in which $a$ and $g$ are 1, and for a limited time: with very
little friction it may end before the cradle rolls at all. In the example $2g$ is 1, and the cradle is let go
at 1 radian.
*/

template <class Real>
Real needed_at_rest(const Ball<Real>& ball, const Real& Phi)  // (A)
{
  using std::cos, std::sin;
  const Real y = ball.a - ball.c * cos(Phi);
  return ball.c * y * sin(Phi) / (ball.k * ball.k + y * y);
}

template <class Real>
Real decay(const Ball<Real>& ball, const Real& Phi)  // (B), K
{
  using std::cos, std::sin;
  const Real s = sin(Phi), u = cos(Phi), c = ball.c, k = ball.k, y = ball.a - c * u, kk = k * k, yy = y * y;
  const Real U = y * (kk + yy) * u + c * (kk - yy) * s * s, V = U + 2 * c * kk * s * s;
  return 9 * y * U * U / (2 * kk * (kk + yy + c * c * s * s) * V * s);
}

const auto a = real("a", 1, feet, scale, "CR, radius of curvature of the base");
const auto c = real("c", 0.5, feet, scale, "CG, from its centre to the centre of gravity");
const auto k = real("k", 0.5, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 0.5, feet, scale, "height fallen from rest in the first second");
const auto mu = real("mu", 0.2, none, closed(1e-3, 10), "μ, friction over pressure where it scrapes");
const auto Phi = angle("Phi", 1, closed(0.1_deg, 170_deg), "angle at which it is let go");

Ball<Fifty> own_measure()
{
  return {1, c.fifty() / a.fifty(), k.fifty() / a.fifty()};
}

Ball<double> body()
{
  return rounded(own_measure());
}

double threshold()
{
  const Fifty end = rolling::windows(own_measure(), mu.fifty()).front().to;
  return static_cast<double>(2 * asin(sqrt(std::min(end, Fifty(1)))));
}

double swing_of(double quarter)  // a single swing, g being 1
{
  return 2 * quarter / std::sqrt(2 * body().c);
}

double first_swing(double friction)
{
  const Energy<double> e = energy_of_amplitude<double>(Phi);
  const double longest = 2 * swing_of(rolling::quarter(body(), e));
  const Path<double> path(body(), 1, friction, {0, 0, Phi, 0}, longest);
  double low = longest / 1000, high = low;
  while(path.at(high).w < 0 && high < longest * 0.999)
    low = high, high += longest / 1000;
  for(int i = 0; i < 60; ++i)
  {
    const double middle = (low + high) / 2;
    (path.at(middle).w < 0 ? low : high) = middle;
  }
  return high;
}

constexpr std::size_t swings = 16;

Path<double> followed()  // from where it is let go, till it has begun to roll so many times and once more
{
  const double swing = swing_of(rolling::quarter(body(), energy_of_amplitude<double>(Phi)));
  return {body(), 1, mu, {0, 0, Phi, 0}, 1.5 * (swings + 4) * swing, 2 * swings + 4};
}

std::vector<double> excesses()  // ε as often as it begins to roll, while it exceeds the threshold
{
  const double there = threshold(), c_ = body().c;
  const Path<double> path = followed();
  std::vector<double> all;
  for(const auto& event : path.events())
  {
    if(event.mode != Mode::rolling || all.size() > swings)
      continue;
    const double above = event.energy - 2 * (1 - c_ * std::cos(there));
    if(!(above > 1e-6 * c_))
      break;
    all.push_back(above / (2 * c_ * std::sin(there)));
  }
  return all;
}

TELL
{
  const Ball<double> ball = body();
  require(c < a, "c", "less than a");
  require(100 * c >= a, "c", "at least a/100");
  require(10 * k >= a, "k", "at least a/10");
  require(k <= 10 * a, "k", "at most 10 a");
  require(mu < rolling::painleve(ball).mu, "mu", "below the limit of §4");
  const double there = threshold();
  require(std::abs(needed_at_rest(ball, there) - mu) < 1e-9 * mu, "mu",
          "so little that it scrapes first where it turns");
  const double T = std::sqrt(a) / std::sqrt(g);
  const Energy<double> e = energy_of_amplitude<double>(Phi);
  const double small = std::numbers::pi / std::sqrt(2 * ball.c) * T;
  tell("small_smooth", small * ball.k, seconds, "a very small swing without friction, (1)");
  tell("small_rolling", small * std::hypot(ball.gap, ball.k), seconds, "the same rolling, (2)");
  tell("smooth", swing_of(smooth::quarter(ball.c, ball.k, e)) * T, seconds,
       "from the angle at which it is let go, without friction");
  tell("rolling", swing_of(rolling::quarter(ball, e)) * T, seconds, "the same if it could roll");
  tell("lambda", needed_at_rest<double>(ball, Phi), "the friction that this takes when it is let go, (A)");
  tell("threshold", there, degrees, "the amplitude up to which it rolls, with the friction there is");
  tell("rough", mu * (std::hypot(ball.gap, ball.k) / ball.c) * std::hypot(ball.gap, ball.k) / ball.gap,
       degrees, "the same for very little friction, μl/(a − c)");
  tell("K", decay(ball, there), "the constant of (B)", 10);
}

TELL
{
  auto& first = table("first", "The first swing, with less and less friction",
                      {{"mu", "μ", none, 1}, {"swing", "swing", seconds, 9}});
  const double T = std::sqrt(a) / std::sqrt(g);
  for(const double friction : {0.1, 0.01, 0.001, 0.0001})
    first.row({friction, first_swing(friction) * T});
  auto& later = table("later", "By how much it exceeds the threshold, swing after swing",
                      {{"n", "n"}, {"excess", "ε", degrees, 7}, {"gain", "change of 1/ε", none, 7}});
  const std::vector<double> all = excesses();
  for(std::size_t n = 1; n < all.size(); n *= 2)
    later.row({static_cast<int>(n), all[n - 1], 1 / all[n] - 1 / all[n - 1]});
}

TELL
{
  curve("decay", {"n", "excess", "law"}, [](Curve& points) {
    const std::vector<double> all = excesses();
    const double K = decay(body(), threshold());
    for(std::size_t n = 0; n < all.size(); ++n)
      points.put(
          {static_cast<double>(n + 1), all[n] / 1_deg, 1 / (K * static_cast<double>(n + 1)) / 1_deg});
  });
}

// A point of the body, so far from C and at such an angle from CR: at rest, and rolled.
std::vector<double> twice(double r, double from_CR, double turned)
{
  return {r * std::sin(from_CR), 1 - r * std::cos(from_CR), turned + r * std::sin(from_CR - turned),
          1 - r * std::cos(from_CR - turned)};
}

TELL
{
  const double half = 70_deg, turned = std::min<double>(Phi, 40_deg);
  curve("base", {"x", "y", "x_rolled", "y_rolled"}, [=](Curve& base) {
    for(int n = -20; n <= 20; ++n)
      base.put(twice(1, half * n / 20, turned));
    base.put(twice(1, -half, turned));
  });
  curve("letters", {"x", "y", "x_rolled", "y_rolled"}, [=](Curve& letters) {  // C, G, R, P, Q
    letters.put(twice(0, 0, turned));
    letters.put(twice(body().c, 0, turned));
    for(const double at : {0., -half, half})
      letters.put(twice(1, at, turned));
  });
}

/*!
::: figure globe-32-cradle
alt: A cradle whose base is an arc with the lowest point R and the ends P and Q, drawn on a line IO at rest
and, in grey, rolled to one side. G lies between R and the centre C of the arc.

Euler's figure, drawn anew: the cradle $PRQ$ on the plane $IO$ at rest, and rolled to $S$ by the angle at
which it is let go, but no more than 40° (grey). $C$ stays at its height, and so $G$ rises.
:::

The cradle let go at 1 radian would need a friction of {{lambda|4}}. Without any its swing takes {{smooth|6}}
seconds, and if it rolled it would take {{rolling|6}}. With less and less friction the first of these is
approached:

{{table first}}

With $\mu = \frac15$ it would roll from {{threshold|5}} downwards. It scrapes and rolls by turns, and ever
nearer to that. From one swing to the next 1/ε (ε in radians) grows by what tends to $K = {{K|6}}$. Here $n$
counts how often the cradle has begun to roll:

{{table later}}

::: figure globe-32
alt: A logarithmic plot of the excess over the threshold against the number of swings. The points fall and
approach a straight line of slope minus one.

By how much the amplitude exceeds the threshold, swing after swing: as the motion is followed (blue), and
$1:Kn$ (grey). It never comes to nothing.
:::

## Checks

The motion is followed once more in fifty digits, by Newton's equations for $G$ and Φ in {{sec globe.06}} and
{{sec globe.07}}. As in {{sec globe.08}} the judge is told the start alone, and finds by itself when the
cradle must change what it does.
*/

Fifty needed(const Ball<Fifty>& ball, const Fifty& Phi_, const Fifty& w = 0)  // λ of rolling, g being 1
{
  const auto moved = rolling_accelerations<Fifty>(ball, 1, Phi_, w);
  return -moved.x / (2 * moved.pressure);
}

Fifty amplitude_that_needs(const Ball<Fifty>& ball, const Fifty& friction)  // the least
{
  Fifty low = 0, high = 0;
  while(needed(ball, high) < friction)
    low = high, high += Fifty(1) / 100;
  for(int i = 0; i < 150; ++i)
  {
    const Fifty middle = (low + high) / 2;
    (needed(ball, middle) < friction ? low : high) = middle;
  }
  return low;
}

CHECK_THAT("the first swing with less and less friction is that of Newton's equations")
{
  for(const Told& now :
      told_at("", "Phi=60 c=0.3 k=0.7 mu=0.05", "a=2e40 c=1.6e40 k=1.2e40 Phi=120 g=1e50 mu=0.3"))
    for(const auto& row : now.rows("first"))
    {
      const double friction = row.at("mu");
      const Fifty T = sqrt(a.fifty() / g.fifty()), swing = row.at("swing", seconds) / T;
      const oracle::Judge judge(own_measure(), 1, friction);
      const std::vector<oracle::Stretch> all = judge.stretches({0, 0, Phi.fifty(), 0}, swing);
      for(const int part : {1, 5, 9})
        CHECK(judge.at(all, part * swing / 10).w < 0);
      const State<Fifty> turns = judge.at(all, swing);
      const Fifty h("1e-20"), slows = judge.after(turns, all.back().mode, h).w - turns.w;
      CHECK(
          row.value("swing", seconds)
          == within_relative((swing - turns.w * h / slows) * T, 1e-12, "where Newton's method has w = 0"));
      CHECK(row.value("mu") == between(1e-4, 0.1, "down to a ten-thousandth"));
    }
}

CHECK_THAT(
    "as friction vanishes the first swing tends to that of the smooth plane, in the first order of μ")
{
  for(const Told& now : told_at(""))
  {
    const auto rows = now.rows("first");
    const Fifty without =
        2 * oracle::smooth_quarter(own_measure().c, own_measure().k, energy_of_amplitude(Phi.fifty()))
        / sqrt(2 * own_measure().c) * sqrt(a.fifty() / g.fifty());
    const Fifty thousandth = rows[2].at("swing", seconds) - without,
                less = rows[3].at("swing", seconds) - without;
    CHECK(thousandth / less == within_relative(Fifty(10), 0.01, "the square of μ is left out"));
    CHECK(now.value("smooth", seconds) == within_relative(without, 4e-15, "eight ulps and a root"));
  }
}

CHECK_THAT("the swings told are those of the integrals, the friction that of the motion at rest")
{
  for(const Told& now :
      told_at("", "Phi=60 c=0.3 k=0.7 mu=0.05", "a=2e40 c=1.6e40 k=1.2e40 Phi=120 g=1e50 mu=0.3"))
  {
    const Ball<Fifty> ball = own_measure();
    const Fifty T = sqrt(a.fifty() / g.fifty()), one = T / sqrt(2 * ball.c);
    const Energy<Fifty> e = energy_of_amplitude(Phi.fifty()), least = energy(Fifty("1e-40"));
    CHECK(now.value("smooth", seconds)
          == within_relative(2 * oracle::smooth_quarter(ball.c, ball.k, e) * one, 4e-15,
                             "eight ulps and a root"));
    CHECK(now.value("rolling", seconds)
          == within_relative(2 * oracle::rolling_quarter(ball, e) * one, 4e-15, "eight ulps and a root"));
    CHECK(now.value("small_smooth", seconds)
          == within_relative(2 * oracle::smooth_quarter(ball.c, ball.k, least) * one, 2e-15,
                             "eight roundings"));
    CHECK(now.value("small_rolling", seconds)
          == within_relative(2 * oracle::rolling_quarter(ball, least) * one, 2e-15, "eight roundings"));
    CHECK(now.value("lambda") == within_relative(needed(ball, Phi.fifty()), 2e-15, "eight roundings"));
    const Fifty there = amplitude_that_needs(ball, mu.fifty());
    CHECK(now.value("threshold", degrees) == within_ulps(there, 1, "the window's 19 digits, rounded"));
    const Fifty l = bb(ball) / ball.c;
    CHECK(now.value("rough", degrees)
          == within_relative(mu.fifty() * l / (1 - ball.c), 2e-15, "eight roundings"));
    CHECK(needed(ball, Fifty("1e-10"))
          == within_relative((1 - ball.c) * Fifty("1e-10") / l, 1e-17, "the square of the angle"));
    // K by its definition, from differences of the accelerations
    const Fifty d("1e-12");
    const Fifty L1 = (needed(ball, there + d) - needed(ball, there - d)) / (2 * d);
    const Fifty L2 = (needed(ball, there, sqrt(d)) - mu.fifty()) / d;
    const auto at_rest = rolling_accelerations<Fifty>(ball, 1, there, 0);
    const Fifty alpha = -at_rest.Phi, beta = alpha * L1 / 2 - alpha * alpha * L2;
    const auto scraping = [&](const Fifty& friction) {  // dσ/dt
      const auto moved = accelerations<Fifty>(ball, 1, there, 0, friction);
      return Fifty(moved.x + (ball.c * cos(there) - ball.a) * moved.Phi);
    };
    const Fifty kappa = -(scraping(mu.fifty() + d) - scraping(mu.fifty() - d)) / (2 * d);
    CHECK(now.value("K")
          == within_relative(Fifty(9) / 4 * mu.fifty() * at_rest.pressure * kappa * L1 * L1
                                 / (beta * ball.c * sin(there)),
                             1e-9, "differences of 1e-12"));
  }
}

CHECK_THAT("the excesses told are those of Newton's equations, scraping after scraping")
{
  for(const Told& now : told_at("", "mu=0.1 Phi=40", "a=2 c=0.6 k=1.4 mu=0.1 Phi=80 g=20"))
  {
    const Ball<Fifty> ball = own_measure();
    const oracle::Judge judge(ball, 1, mu.fifty());
    const Fifty there = amplitude_that_needs(ball, mu.fifty());
    std::vector<Fifty> excess;
    for(const oracle::Stretch& one : judge.stretches({0, 0, Phi.fifty(), 0}, 1000, 2 * swings + 4))
      if(one.mode == Mode::rolling)
        excess.push_back((judge.energy(one.start) - 2 * (1 - ball.c * cos(there)))
                         / (2 * ball.c * sin(there)));
    const auto rows = now.rows("later");
    CHECK(rows.size() == 5);
    for(std::size_t i = 0, n = 1; i < rows.size(); ++i, n *= 2)
    {
      const char* const because = "a difference of energies";
      const Fifty gain = 1 / excess[n] - 1 / excess[n - 1];
      CHECK(rows[i].value("n") == static_cast<int>(n));
      CHECK(rows[i].value("excess", degrees) == within_relative(excess[n - 1], 1e-9, because));
      CHECK(rows[i].value("gain") == within_relative(gain, 1e-7, because));
    }
    CHECK(rows.back().value("gain") == within_relative(decay(ball, there), 0.02, "(B), of the order of ε"));
  }
  for(const Told& now : told_at("mu=0.01"))
    CHECK(now.rows("later").empty());
}

CHECK_THAT(
    "for very small ε one scraping lasts 3t₀ and takes Kεε; for very little friction KΦ is 9(a − c)² : 2kk")
{
  const Ball<Fifty> ball = cradle<Fifty>;
  const Fifty there = Fifty(4) / 10, friction = needed(ball, there), in_energy = 2 * ball.c * sin(there);
  const oracle::Judge judge(ball, 1, friction);
  const Fifty alpha = -rolling_accelerations<Fifty>(ball, 1, there, 0).Phi;
  for(const char* const small : {"1e-3", "1e-5"})  // it rolls through the lowest place
  {
    const Fifty excess(small), lowest = 2 * (1 - ball.c), at_threshold = 2 * (1 - ball.c * cos(there)),
                               w = sqrt(2 * (at_threshold - lowest + excess * in_energy) / bb(ball));
    const std::vector<oracle::Stretch> all = judge.stretches({0, 0, 0, w}, 20, 2);
    const Fifty next = (judge.energy(all[2].start) - at_threshold) / in_energy, t0 = all[1].start.w / alpha;
    CHECK((all[2].from - all[1].from) / t0
          == within_relative(3, 4 * double(sqrt(excess)), "of its root's order"));
    CHECK(1 / next - 1 / excess
          == within_relative(decay(ball, there), 10 * double(excess), "(B), of the order of ε"));
  }
  const Fifty least("1e-8");
  CHECK(decay(cradle<Fifty>, least) * least == within_relative(Fifty(9) / 2, 1e-12, "the square of Φ"));
  CHECK(decay(our_ball<Fifty>, least) * least
        == within_relative(Fifty(9) / 2 * Fifty(81) / 36, 1e-12, "the square of Φ"));
}

CHECK_THAT("a body is refused out of proportion, or with friction beyond §4 or more than it needs at rest")
{
  for(const char* const within_them :
      {"c=0.9999999999999999", "a=2 c=1.9999999999999998", "c=0.01 mu=0.003", "a=2 c=0.02 mu=0.003",
       "k=0.1 mu=0.01", "a=2 k=0.2 mu=0.01", "k=10 mu=0.003", "a=2 k=20 mu=0.0015", "k=0.1 mu=0.13422",
       "c=0.9 k=0.1 mu=0.10557", "mu=0.41717", "c=0.2 k=1 mu=0.09999"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"c=1", "a=2 c=2", "c=0.00999999999999999 mu=0.003", "a=2 c=0.01999999999999999 mu=0.003",
       "k=0.09999999999999999 mu=0.01", "a=2 k=0.1999999999999999 mu=0.01", "k=10.000000000000002 mu=0.003",
       "a=2 k=20.000000000000004 mu=0.0015", "k=0.1 mu=0.13423", "c=0.9 k=0.1 mu=0.10558", "mu=0.41718",
       "c=0.2 k=1 mu=0.1"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("the curve is the excesses and the law")
{
  for(const Told& now : told_at(""))
  {
    const auto rows = now.rows("later");
    for(const auto& point : now.points("decay"))
    {
      CHECK(point.value("n") == between(1, 17, "swings"));
      CHECK(
          point.value("law")
          == within_relative(180 / (exact::pi() * decay(own_measure(), Fifty(threshold())) * point.at("n")),
                             1e-12, "the threshold's rounding"));
      for(const auto& row : rows)
        if(row.at("n") == point.at("n"))
          CHECK(point.value("excess")
                == within_relative(row.at("excess", degrees) * 180 / exact::pi(), 1e-14,
                                   "the same in degrees"));
    }
  }
}

CHECK_THAT(
    "the cradle drawn keeps its form, G is CG below C, and when rolled it rests where it has rolled to")
{
  for(const Told& now : told_at("", "Phi=10", "a=3 c=1.2 k=2 mu=0.1"))
  {
    const Fifty turned = std::min<Fifty>(Phi.fifty(), 40 * exact::pi() / 180), c_ = own_measure().c;
    const auto letters = now.points("letters");
    const char* const because = "sines and some roundings";
    CHECK(letters.size() == 5);
    const auto distance = [](const ToldRow& p, const ToldRow& q, const char* x, const char* y) {
      return std::hypot(p.at(x) - q.at(x), p.at(y) - q.at(y));
    };
    for(const auto& point : now.points("base", 9))
    {
      CHECK(point.value("x") == between(-0.95, 0.95, "up to 70° from R"));
      CHECK(point.value("y") == within(1 - sqrt(1 - pow(Fifty(point.at("x")), 2)), 1e-14, because));
      CHECK(point.value("y_rolled") == between(0, 2, "above the plane"));
      for(const ToldRow& letter : letters)
        CHECK(distance(point, letter, "x_rolled", "y_rolled")
              == within(distance(point, letter, "x", "y"), 1e-14, because));
      CHECK(point.value("x_rolled") == between(turned - 1, turned + 1, "about the new place"));
    }
    const std::array<Fifty, 3> from_C{0, c_, 1};  // C, G, R
    for(std::size_t i = 0; i < 3; ++i)
    {
      CHECK(letters[i].value("x") == within(0, 1e-16, because));
      CHECK(letters[i].value("y") == within(1 - from_C[i], 1e-15, because));
      CHECK(letters[i].value("x_rolled") == within(turned - from_C[i] * sin(turned), 1e-15, because));
      CHECK(letters[i].value("y_rolled") == within(1 - from_C[i] * cos(turned), 1e-15, because));
    }
  }
}

/*!
That only the radius of curvature at $R$ counts is tried with a base that is no circle but half an ellipse.
*/

CHECK_THAT("on an elliptic base, too, small rocking takes the times (1) and (2) of its radius of curvature")
{
  const Fifty wide = 2, high = 3, a_ = wide * wide / high, c_ = Fifty(1) / 5, k_ = Fifty(1) / 2,
              amplitude("1e-10");
  const Fifty depth = high - (a_ - c_);  // of G below the ellipse's centre
  const auto p = [&](const Fifty& x) {
    return Fifty(sqrt(pow(wide * sin(x), 2) + pow(high * cos(x), 2)) - depth * cos(x));
  };
  const auto slope = [&](const Fifty& x) {
    return Fifty((wide * wide - high * high) * sin(x) * cos(x) / (p(x) + depth * cos(x)) + depth * sin(x));
  };
  for(const bool rolls : {false, true})
  {
    Fifty sum = 0;
    for(int i = 0; i < 12; ++i)  // where Φ is the amplitude times sin θ, and 2g = 1
    {
      const Fifty theta = (2 * i + 1) * exact::pi() / 48, x = amplitude * sin(theta);
      const Fifty M = k_ * k_ + pow(slope(x), 2) + (rolls ? Fifty(p(x) * p(x)) : Fifty(0));
      sum += amplitude * cos(theta) * sqrt(M / (2 * (p(amplitude) - p(x)))) * exact::pi() / 24;
    }
    const Fifty moment = k_ * k_ + (rolls ? Fifty(pow(a_ - c_, 2)) : Fifty(0));
    CHECK(2 * sum
          == within_relative(exact::pi() * sqrt(moment / c_), 1e-18, "the square of the amplitude"));
  }
}

/*!
In our copy there stands $v = gc$ under the fraction {{eq 2}}, where in {{eq 1}} it has $\sqrt{2gc}$.
*/

const Emendation under_root{
    "§32, under the time with friction",
    {"gc, without root and 2", 0.25},
    {"√(2gc)", std::sqrt(0.5)},
    "a very small swing of the cradle with 2g = 1, by quadrature, is π√((a − c)² + kk) over it",
    [](double reading) {
      const Fifty T =
          2 * oracle::rolling_quarter(cradle<Fifty>, energy(Fifty("1e-40"))) / sqrt(Fifty(1) / 2);
      return reading
             == within_relative(exact::pi() * sqrt(bb(cradle<Fifty>)) / T, 1e-15, "a root, rounded");
    }};

/*!
## Go on from here

::: exercise
How many swings does a cradle with $a - c = k$ need on ice until its amplitude exceeds the threshold by no
more than a hundredth part of it, according to {{eq B}}?

answer: $\varepsilon:\Phi_* = 2kk:9(a-c)^2n$, with $n$ the number of swings; that is a hundredth for
$n = 200:9$, some twenty-two swings, whatever the friction is.
:::
*/

CHECK_THAT("by (B) with very little friction, and a − c = k, the excess is a hundredth for n = 200:9")
{
  const Fifty least("1e-8"), n = Fifty(200) / 9;
  CHECK(1 / (decay(cradle<Fifty>, least) * n) / least
        == within_relative(Fifty(1) / 100, 1e-12, "the square of Φ"));
}
