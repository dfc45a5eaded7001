#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/ball.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 23, "A planet, and a comet")

using namespace globe;

/*!
## What Euler does

The centre of gravity goes round the centre of the ball much as a planet goes round the sun. The centre $C$,
Euler says, keeps its distance from the plane and goes straight on, but it does not go evenly, because it is
the centre of gravity $G$ whose horizontal velocity is the same for ever ({{sec globe.10}}). Meanwhile $G$
goes round $C$ almost as the planets do in their orbits, and in this motion the lowest place of $G$
corresponds to the perihelion, the highest to the aphelion. Of the formula for the time ({{eq globe.22 3}})
the first member, which contains the angle Φ, represents the mean motion; the two others contain the
inequalities and involve, as it were, an eccentricity. The case before this one, where the time of a
revolution was infinite, may then be thought similar to the motion of a comet in a parabola.

He gives no formulae. These are what he speaks of. The velocity of $C$ is

$$ \frac{ds}{dt} = f + c\,\frac{d\Phi}{dt}\cos\Phi, \tag{A} $$

greater than the velocity $f$ of $G$ while $G$ is below it and less while it is above. The angular velocities
at perihelion and aphelion are, in the $n$ of {{sec globe.21}}, as

$$ n : \sqrt{nn - 2}. \tag{B} $$

::: margin
Today: perihelion is where a planet is nearest to the sun, aphelion where it is farthest; an inequality is a
periodic deviation from the mean motion.
:::

How far does the likeness go? A planet of the eccentricity ε has, by Kepler's laws, angular velocities at
perihelion and aphelion that are as $(1+\varepsilon)^2 : (1-\varepsilon)^2$; so there is a planet for every
ball. Its mean anomaly follows from the true one, which here is Φ, by

$$ M = \Phi - 2\varepsilon\sin\Phi + \tfrac34\varepsilon\varepsilon\sin2\Phi - \dots, \tag{C} $$

and the ball's by $M = \Phi - e_1\sin\Phi - e_2\sin2\Phi$. The first inequalities agree with $e_1 =
2\varepsilon$. The second do not: they have different signs. The planet is drawn out along the line from
perihelion to aphelion; the ball's $e_2$ comes from $cc\sin^2\Phi$, the rise and fall of $G$, which delays it
on both sides and at neither end. And the comet gets on otherwise than the ball of Case II. When what Φ lacks
of 180° has become half as much the comet has been under way, in the end, eight times as long, the ball of
{{sec globe.18}} but always by the same time longer.

That $G$ is fastest at the lowest place, slowest at the highest, and steadily the one or the other between
them is exact, not only for small inequalities, but it hangs on the plane. By {{sec globe.10}}

$$ \frac{dd\Phi}{dt^2} = -\frac{2gc\sin\Phi}{kk}\,\frac\Pi P : \tag{D} $$

the turning is slowed all the way up just if the pressure is positive all the way. For $nn > 2 + kk:2cc$
({{sec globe.20}}) it is not. The slowest place of the formula is then no longer the top but the place where
$\Pi$ vanishes, and from there on the ball flies.

In flight $G$ falls freely and the turning is even. Let ψ be what Φ lacks of 180° at the lift-off and $x$ the
angle turned since. Since there $cw^2\cos\psi = 2g$, time and $g$ go out, and the ball's height above the
plane is, $w$ being whatever it may,

$$ \begin{aligned} c\,\bigl(&(x - \sin x)\sin\psi \\
   &- (\tfrac12xx - 1 + \cos x)\cos\psi\bigr). \end{aligned} \tag{E} $$

It rises as $x^3$, without a jerk, and is down again where

$$ \tan\psi = \frac{\frac12xx - 1 + \cos x}{x - \sin x}. \tag{F} $$

For a small ψ this is $x = 4\psi$: a ball that lifts off just before the top comes down three times as far
behind it.

## The program

What is small of the third and fourth order in {{eq E}} is summed as a series while $x$ is below 3.
*/

double rest_of_sine(double x)  // x − sin x
{
  if(x >= 3)
    return x - std::sin(x);
  double sum = 1;
  for(int m = 31; m >= 5; m -= 2)
    sum = 1 - sum * x * x / (m * (m - 1));
  return sum * x * x * x / 6;
}

double rest_of_cosine(double x)  // ½xx − 1 + cos x
{
  if(x >= 3)
    return x * x / 2 - 1 + std::cos(x);
  double sum = 1;
  for(int m = 32; m >= 6; m -= 2)
    sum = 1 - sum * x * x / (m * (m - 1));
  return sum * x * x * x * x / 24;
}

template <class Function>
double halve(const Function& below, double low, double high)
{
  for(int i = 0; i < 60; ++i)
    (below((low + high) / 2) ? low : high) = (low + high) / 2;
  return high;
}

/*!
Where {{eq E}} is greatest needs a thought, since a ball that turns fast bobs up and down in its flight as $G$
goes round. Over $\cos\psi$, with $x = \tan\psi + u$, it is $-\frac12uu$ and a part that returns with every
turn. So the greatest is where $u$ lies between −180° and 180°.
*/

double highest_place(double tangent)  // the x at which (E) is greatest
{
  const auto rises = [=](double x) {
    const double s = std::sin(x / 2);
    return rest_of_sine(x) < 2 * tangent * s * s;
  };
  if(tangent < 1)
    return halve(rises, tangent, 3.5 * tangent);
  const double from = std::max(tangent - std::numbers::pi, 0.5),
               step = (tangent + std::numbers::pi - from) / 64;
  double best = from, most = -1;
  for(int i = 1; i <= 64; ++i)
  {
    const double x = from + i * step, height = tangent * rest_of_sine(x) - rest_of_cosine(x);
    if(height > most)
    {
      most = height;
      best = x;
    }
  }
  const auto height = [=](double x) { return tangent * rest_of_sine(x) - rest_of_cosine(x); };
  double highest = halve(rises, best - step, best + step);
  for(const double turn : {-2 * std::numbers::pi, 2 * std::numbers::pi})  // near ±180° two may be as high
    if(const double about = highest + turn; about > step && about < 2 * tangent)
      if(const double other = halve(rises, about - step, about + step); height(other) > height(highest))
        highest = other;
  return highest;
}

/// From the lift-off to where the ball is down again.
struct Flight
{
  double psi;     ///< what Φ lacks of 180° at the lift-off
  double w;       ///< dΦ/dτ, τ being t√2gc
  double turned;  ///< x when it is down
  double rise;    ///< the greatest height over c
};

Flight flight(double c, double k, double excess)  // h being 1 + kk:4cc and that much
{
  const auto off = smooth::lift_off(c, k, excess);
  const double cosine = 1 / (c * off.w) / (c * off.w), sine = std::sin(off.from_top);
  const double tangent = sine / cosine;
  const double turned = halve([=](double x) { return rest_of_cosine(x) < tangent * rest_of_sine(x); },
                              tangent, 4.1 * tangent);  // (F)
  const double highest = highest_place(tangent);
  return {off.from_top, off.w, turned, sine * rest_of_sine(highest) - cosine * rest_of_cosine(highest)};
}

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto f = real("f", 3, Unit{"ft/s"}, closed(-1e100, 1e100), "horizontal velocity of G");
const auto n = real("n", 4, none, closed(1.5, 1e6), "ζk over 2√gc; below √2 the ball rocks");

Fifty over()  // what h = ½nn exceeds the limit by
{
  const Fifty r = k.fifty() / c.fifty(), limit = 1 + r * r / 4;
  const Fifty excess = n.fifty() * n.fifty() / 2 - limit;
  return abs(excess) < 1e-45 * limit ? Fifty(0) : excess;
}

TELL
{
  require(c <= 100 * k, "c", "at most a hundred times k");
  require(k <= 1e40 * c, "c", "at least 1e-40 of k");
  const double second = std::sqrt(2 * g) * std::sqrt(c), zeta = std::numbers::sqrt2 * n / k * second;
  tell("w_low", zeta, Unit{"1/s"}, "dΦ/dt in the perihelion, G lowest: ζ");
  tell("C_low", f + c * zeta, Unit{"ft/s"}, "ds/dt there");
  if(over() <= 0)
  {
    const double more = 2 / double(n.fifty() * n.fifty() - 2), top = zeta / std::sqrt(1 + more);
    const auto e = smooth::inequalities<double>(c, k, n);
    tell("w_high", top, Unit{"1/s"}, "dΦ/dt in the aphelion, G highest, by (B)");
    tell("C_high", f - c * top, Unit{"ft/s"}, "ds/dt there");
    tell("eccentricity", std::tanh(std::log1p(more) / 8), "ε of the planet with the same two velocities");
    tell("by_first", e.e1 / 2, "ε of the planet with the same first inequality");
    tell("second_planet", -0.75 * (e.e1 / 2) * (e.e1 / 2), degrees, "what that planet has for e₂, (C)");
    tell("second", e.e2, degrees, "e₂, the ball's own");
  }
  else
  {
    const Flight now = flight(c, k, double(over()));
    tell("psi_off", now.psi, degrees, "what Φ lacks of 180° where the ball lifts off");
    tell("w_off", now.w * second, Unit{"1/s"}, "dΦ/dt there, the least");
    tell("turned", now.turned, degrees, "x, the angle turned in flight, (F)");
    tell("lasts", now.turned / now.w / second, seconds, "how long it flies");
    tell("rise", c * now.rise, feet, "how high it rises, (E)");
  }
}

TELL
{
  auto& flights = table("flights", "Flights of this ball, by what h exceeds the limit",
                        {{"excess", "excess", none, 1},
                         {"psi", "lifts off before the top by", degrees, 6},
                         {"past", "comes down behind it by", degrees, 6},
                         {"rise", "rises, in parts of c", none, 4}});
  for(const double excess : {1e-12, 0.01, 1., 8., 100.})
  {
    const Flight now = flight(c, k, excess);
    flights.row({excess, now.psi, now.turned - now.psi, now.rise});
  }
}

TELL
{
  curve("turning", {"own_Phi", "own", "limit_Phi", "limit", "over_Phi", "over"}, [](Curve& turning) {
    const double most = smooth::lift_off_energy<double>(c, k), pi = std::numbers::pi;
    const std::array<double, 3> h{n * n / 2, most, 1.8 * most};
    for(int i = 0; i <= 90; ++i)
    {
      std::vector<double> row;
      for(const double energy_of : h)
      {
        const bool lifts = energy_of > most * (1 + 1e-12);
        const double end = lifts ? smooth::lift_off<double>(c, k, energy_of - most).Phi : pi;
        const Place<double> there = i == 90 && !lifts ? Place<double>{1, 0} : place(i * end / 90);
        const double square = smooth::velocity_squared<double>(c, k, energy(energy_of), there);
        row.insert(row.end(), {i * end / 90 / 1_deg, k * std::sqrt(square)});
      }
      turning.put(row);
    }
  });
  curve("edge", {"Phi", "w"}, [](Curve& edge) {
    for(int Phi = 92; Phi <= 180; Phi += 2)
      edge.put({double(Phi), k / c / std::sqrt(-std::cos(Phi * 1_deg))});
  });
}

/*!
With $n = 4$ our ball turns at {{w_low|5}} radians a second in its perihelion and at {{w_high|5}} in its
aphelion, and its centre goes at {{C_low|4}} and {{C_high|4}} feet a second, while $G$ keeps to three. A
planet with these velocities would have the eccentricity {{eccentricity|3}}, one with the same first
inequality {{by_first|3}}. The second inequality is {{second|3}}, where the planet has {{second_planet|3}}.

{{table flights}}

::: figure globe-23
alt: Angular velocity against the angle of half a turn, for three velocities. The two lower curves fall all
the way to the top, the second just touching the corner of a shaded region in the upper right; the third runs
into that region before the top and ends there, level.

How the turning slackens from perihelion to aphelion, in parts of $\sqrt{2gc}:k$: for this ball's $n$ (blue),
the greatest that {{sec globe.20}} allows (green), and more. In the shaded region the plane would have to
pull. A curve that meets its edge is level there, by {{eq D}}: the ball is off before it has an aphelion.
:::

## Checks

The two velocities, of $G$ about $C$ and of $C$ itself, are those of Newton's equations.
*/

CHECK_THAT(
    "by the equations of motion the ball has the velocities told, below and above, and G goes evenly")
{
  for(const Told& now : told_at("", "n=1.5 c=0.6 f=0", "n=8 c=0.05 g=1 f=-7"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), n_ = n.fifty(), f_ = f.fifty();
    const Ball<Fifty> ball{c_ + k_, c_, k_};
    const auto motion = [&](const Fifty&, const exact::State& s) {
      const auto moved = accelerations<Fifty>(ball, g_, s[2], s[3], 0);
      return exact::State{s[1], moved.x, s[3], moved.Phi};
    };
    const Fifty zeta = 2 * n_ * sqrt(g_ * c_) / k_;
    const Fifty half = smooth::quarter(c_, k_, energy(Fifty(n_ * n_ / 2))) / sqrt(2 * g_ * c_);
    const exact::State top = exact::solve(motion, 0, {0, f_, 0, zeta}, half).y;
    CHECK(top[2] == within(exact::pi(), 1e-27, "some hundred steps of 1e-32"));
    CHECK(top[1] == within(f_, 1e-40, "nothing pushes G forward or back"));
    CHECK(top[3] == within_relative(zeta * sqrt(n_ * n_ - 2) / n_, 1e-26, "(B)"));
    CHECK(now.value("w_low", Unit{"1/s"}) == within_relative(zeta, 1e-15, "some roundings"));
    CHECK(now.value("w_high", Unit{"1/s"}) == within_relative(top[3], 2e-15, "some roundings"));
    const double size = 2e-15 * double(abs(f_) + c_ * zeta);
    CHECK(now.value("C_low", Unit{"ft/s"}) == within(f_ + c_ * zeta, size, "a sum, (A)"));
    CHECK(now.value("C_high", Unit{"ft/s"}) == within(f_ - c_ * top[3], size, "a difference, (A)"));
  }
}

CHECK_THAT(
    "the planet told has the ball's two velocities by Kepler's law of areas, or its first inequality")
{
  for(const Told& now : told_at("", "n=1.5 c=0.6", "n=1e6 c=1e-9", "n=1.5 c=1e-20 g=1e90"))
  {
    const Fifty n_ = n.fifty(), r = c.fifty() / k.fifty(), mean = 1 + r * r / 4 + 1 / (2 * n_ * n_);
    // (1 + ε):(1 − ε) is the root of the quotient of the velocities.
    const Fifty root = sqrt(sqrt(n_ * n_ / (n_ * n_ - 2))), first = 1 / (4 * n_ * n_) / mean;
    CHECK(now.value("eccentricity") == within_relative((root - 1) / (root + 1), 2e-15, "five roundings"));
    CHECK(now.value("by_first") == within_relative(first, 1e-15, "six roundings"));
    CHECK(now.value("second_planet", degrees)
          == within_relative(-3 * first * first / 4, 2e-15, "six roundings, doubled"));
    CHECK(now.value("second", degrees) == within_relative(r * r / 8 / mean, 1e-15, "six roundings"));
  }
}

CHECK_THAT("(C) is Kepler's equation to the second order of ε")
{
  for(const double v : {0.5, 1.5, 3.})
  {
    const Fifty epsilon("1e-8"), E = 2 * atan(sqrt((1 - epsilon) / (1 + epsilon)) * tan(Fifty(v) / 2));
    CHECK(E - epsilon * sin(E) - v + 2 * epsilon * sin(Fifty(v))
          == within(3 * epsilon * epsilon / 4 * sin(2 * Fifty(v)), 1e-24, "the third order"));
  }
}

CHECK_THAT(
    "to halve what it lacks of 180° the comet takes eight times its time, the ball of Case II k l 2 more")
{
  const auto comet = [](const Fifty& lacks) {
    const Fifty x = 1 / tan(lacks / 2);
    return Fifty(x + x * x * x / 3);  // Barker's equation of the parabola
  };
  const Fifty small("1e-9"), c0 = our_ball<Fifty>.c, k0 = our_ball<Fifty>.k;
  CHECK(comet(small / 2) / comet(small) == within(8, 1e-16, "terms of the second order"));
  const auto ball = [&](const Fifty& lacks) {
    return smooth::time<Fifty>(c0, k0, {1, 0}, place_from_top(lacks));
  };
  CHECK(ball(small / 2) - ball(small) == within(k0 * exact::ln2(), 1e-17, "terms of the second order"));
}

CHECK_THAT("the turning slackens all the way up while the plane bears, else just to the lift-off")
{
  for(const Fifty& n_ : {Fifty(2), Fifty(4), Fifty("4.47"), Fifty("4.48"), Fifty(6), Fifty(100)})
  {
    const Ball<Fifty> ball = our_ball<Fifty>;
    const Fifty more = n_ * n_ / 2 - 10;
    const Fifty end = more > 0 ? smooth::lift_off(ball.c, ball.k, more).Phi : exact::pi();
    for(int i = 1; i < 60; ++i)
    {
      const Fifty at = i * end / 60, s = ball.c * sin(at);
      const Fifty w2 = 4 * ball.c * (n_ * n_ - 1 + cos(at)) / (ball.k * ball.k + s * s);  // g = 1
      CHECK(accelerations<Fifty>(ball, 1, at, sqrt(w2), 0).Phi < 0);
    }
  }
}

/*!
The flight is followed in time: $G$ as a stone that is thrown up, the turning even, and the ball's height from
where $C$ then is.
*/

/// G at the lift-off, and how it goes on.
struct Thrown
{
  Fifty w;    ///< dΦ/dt, which stays
  Fifty v;    ///< the velocity of G upwards
  Fifty Phi;  ///< the angle
  Fifty g_;   ///< the height fallen in the first second
  Fifty c_;   ///< CG
  /// The ball's height above the plane, a time later.
  Fifty height(const Fifty& t) const { return v * t - g_ * t * t + c_ * (cos(Phi + w * t) - cos(Phi)); }
  /// Its differential.
  Fifty speed(const Fifty& t) const { return v - 2 * g_ * t - c_ * w * sin(Phi + w * t); }
};

template <class Function>
Fifty root_near(const Function& falls, const Fifty& about)  // where it changes from plus to minus
{
  Fifty low = about * Fifty("0.99"), high = about * Fifty("1.01");
  for(int i = 0; i < 160; ++i)
    (falls((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  return low;
}

Thrown thrown(const Fifty& excess)
{
  const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty();
  const auto off = smooth::lift_off(c_, k_, excess);
  const Fifty w = off.w * sqrt(2 * g_ * c_);
  return {w, c_ * w * sin(off.Phi), off.Phi, g_, c_};
}

Fifty highest(const Thrown& stone, const Fifty& lands)  // of 40000 heights, and then by the velocity
{
  const double w = double(stone.w), v = double(stone.v), Phi = double(stone.Phi), end = double(lands);
  double best = 0, most = 0;
  for(int i = 1; i < 40000; ++i)
  {
    const double t = i * end / 40000;
    const double height =
        v * t - double(stone.g_) * t * t + double(stone.c_) * (std::cos(Phi + w * t) - std::cos(Phi));
    if(height > most)
    {
      most = height;
      best = t;
    }
  }
  if(double(exact::pi()) - Phi < 0.1)
    best = 0.75 * end;  // where the difference is lost in double the place is known: 3ψ of 4ψ
  Fifty low = best * Fifty("0.99"), high = best * Fifty("1.01");
  if(w * end > 100)  // many bobs: nearer about
  {
    low = best - end / 20000;
    high = best + end / 20000;
  }
  for(int i = 0; i < 160; ++i)
    (stone.speed((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  return stone.height(low);
}

CHECK_THAT("the flight told begins where the pressure vanishes, and is that of a stone that turns evenly")
{
  for(const Told& now : told_at("n=6", "n=1.6 c=0.6 g=1", "n=4.4722", "n=30 c=2", "n=23.3 c=0.2"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), nn = n.fifty() * n.fifty();
    const Thrown stone = thrown(nn / 2 - 1 - k_ * k_ / (4 * c_ * c_));
    const Fifty s = c_ * sin(stone.Phi);
    CHECK(stone.w * stone.w
          == within_relative(4 * stone.g_ * c_ * (nn - 1 + cos(stone.Phi)) / (k_ * k_ + s * s), 1e-35,
                             "the living force that is left"));
    CHECK(accelerations<Fifty>(Ball<Fifty>{c_ + k_, c_, k_}, stone.g_, stone.Phi, stone.w, 0).pressure
          == within(0, 1e-30, "fifty digits"));
    const Fifty psi = exact::pi() - stone.Phi;
    CHECK(now.value("psi_off", degrees) == within_relative(psi, 4e-15, "the library's eight ulps"));
    CHECK(now.value("w_off", Unit{"1/s"}) == within_relative(stone.w, 4e-15, "the same"));
    Fifty low = tan(psi), high = 5 * low;  // x by (F), halved
    for(int i = 0; i < 160; ++i)
    {
      const Fifty x = (low + high) / 2;
      (x * x / 2 - 1 + cos(x) < tan(psi) * (x - sin(x)) ? low : high) = x;
    }
    const Fifty lands = root_near([&](const Fifty& t) { return stone.height(t); }, low / stone.w);
    CHECK(now.value("lasts", seconds) == within_relative(lands, 2e-14, "a dozen ulps of tan ψ"));
    CHECK(now.value("turned", degrees) == within_relative(lands * stone.w, 2e-14, "the same"));
    CHECK(now.value("rise", feet)
          == within_relative(highest(stone, lands), 1e-13, "sums with differences"));
    for(int i = 1; i < 100; ++i)
      CHECK(stone.height(i * lands / 100) > 0);
  }
}

CHECK_THAT("the flights of the table are such, and near the limit the ball is down 3ψ behind the top")
{
  for(const Told& now : told_at("", "c=0.6", "c=0.01 g=1e-20"))
    for(const auto& row : now.rows("flights"))
    {
      const Thrown stone = thrown(row.at("excess"));
      const Fifty psi = exact::pi() - stone.Phi, turned = row.at("past", degrees) + psi;
      CHECK(row.value("excess") == between(1e-12, 100, "what is told of"));
      CHECK(row.value("psi", degrees) == within_relative(psi, 4e-15, "the library's eight ulps"));
      const Fifty lands = root_near([&](const Fifty& t) { return stone.height(t); }, turned / stone.w);
      CHECK(row.value("past", degrees)
            == within_relative(lands * stone.w - psi, 4e-14, "a difference of what has a dozen ulps"));
      CHECK(row.value("rise") == within_relative(highest(stone, lands) / stone.c_, 1e-13, "sums"));
      if(psi < 1e-3)
        CHECK(lands * stone.w == within_relative(4 * psi, 1e-6, "the next term is of the second order"));
    }
}

CHECK_THAT("a ball is refused whose c is more than a hundred times k, or less than 1e-40 of it")
{
  for(const char* const within_them : {"c=100 k=1", "c=200 k=2", "c=1 k=1e40", "c=2 k=2e40"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"c=100.00000000000001 k=1", "c=200.00000000000003 k=2",
                                  "c=0.9999999999999999 k=1e40", "c=1.9999999999999998 k=2e40"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("the curves are what the living force leaves, and the edge is where the pressure vanishes")
{
  for(const Told& now : told_at("", "n=9 c=0.2"))
  {
    const Fifty q = pow(c.fifty() / k.fifty(), 2), most = 2 + 1 / (2 * q), degree = exact::pi() / 180;
    const Fifty own = n.fifty() * n.fifty();
    for(const auto& point : now.points("turning", 4))
    {
      const auto left = [&](const Fifty& nn, const Fifty& at) {
        return Fifty(sqrt(2 * (nn - 1 + cos(at)) / (1 + q * pow(sin(at), 2))));
      };
      const char* const because = "an ulp of the angle";
      CHECK(point.value("own") == within_relative(left(own, point.at("own_Phi") * degree), 1e-14, because));
      CHECK(point.value("limit")
            == within_relative(left(most, point.at("limit_Phi") * degree), 1e-14, because));
      CHECK(point.value("over")
            == within_relative(left(most * 1.8, point.at("over_Phi") * degree), 1e-14, because));
      CHECK(point.value("own_Phi") == between(0, 180.0001, "half a turn at most"));
      CHECK(point.value("limit_Phi") == between(0, 180.0001, "half a turn"));
      CHECK(point.value("over_Phi") == between(0, 179, "till the lift-off"));
    }
    for(const auto& point : now.points("edge", 4))
    {
      const Fifty at = point.at("Phi") * degree, w = point.at("w") * sqrt(2 * c.fifty()) / k.fifty();
      const Ball<Fifty> ball{c.fifty() + k.fifty(), c.fifty(), k.fifty()};
      CHECK(accelerations<Fifty>(ball, 1, at, w, 0).pressure == within(0, 1e-13, "ulps of near 90°"));
      CHECK(point.value("w") == within_relative(1 / sqrt(-q * cos(at)), 2e-14, "ulps of near 90°"));
      CHECK(point.value("Phi") == between(92, 180, "the upper half"));
    }
  }
}

/*!
## Go on from here

::: exercise
How far from the top can a ball at most lift off, and how high does it rise in its flight, if it turns faster
and faster?
answer: By {{eq globe.20 D}} $\cos\Phi$ tends to $-(kk+cc):2nncc$, so that the ball lifts off near 90° and
never before. $G$ is then thrown up with the velocity $cw$, and $w$ is given by $cw^2\cos\psi = 2g$: it rises
$c^3nn:(kk+cc)$, without bound. With `--n 1e6` the program tells nearly that.
:::
*/

CHECK_THAT("with n = 10⁶ the ball lifts off at 90° and rises c³nn:(kk+cc), but for small parts")
{
  for(const Told& now : told_at("n=1e6"))
  {
    const Fifty c_ = c.fifty(), all = pow(k.fifty(), 2) + c_ * c_;
    CHECK(now.value("psi_off", degrees) == within(90_deg, 1e-10, "the part of 1:nn"));
    CHECK(now.value("rise", feet) == within_relative(pow(c_, 3) * 1e12 / all, 1e-9, "the part of 1:nn"));
  }
}
