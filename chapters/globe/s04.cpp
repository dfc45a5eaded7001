#include "edition/section.hpp"
#include "globe/ball.hpp"
#include "globe/readings.hpp"
#include "globe/rolling.hpp"

SECTION(globe, 4, "Weight, pressure, friction")

using namespace globe;

/*!
## What Euler does

Three forces drive the ball, and only the first of them is known beforehand. The weight pulls the centre of
gravity $G$ downwards along $GP$ with the force $P$. Since the ball lies on the plane at $S$ it presses it
there, and the plane presses back just as much, along $SC$; this force, still unknown, is called Π. And if
friction is admitted, it is always proportional to this pressure, and therefore $\lambda\Pi$:

$$ \begin{gathered} \lambda\Pi \;\text{ along }
   \begin{cases} SI, \text{ if } ds > a\,d\Phi,\\ SO, \text{ if } ds < a\,d\Phi, \end{cases} \\
   \lambda = \tfrac13{{entry usual}}, \end{gathered} \tag{1} $$

where for λ, which is the fraction commonly taken when there is real rubbing, any other may be put. In the
case $ds = a\,d\Phi$ nothing rubs. Then, and this he asks the reader to mark, either there is no friction at
all, or λ has a certain value, just as much as is needed to prevent the rubbing.

::: margin
Today: Coulomb's law of dry friction, with a coefficient μ that is the same at rest and in motion;
$\lambda = \pm\mu$ while it slips and $-\mu\le\lambda\le\mu$ while it sticks.
:::

The last sentence makes λ an unknown, and one thing is left to say: how one knows in which case a ball is
whose $S$ is at rest. It rolls on if the plane can give what rolling needs. That is a force $F$, positive
backwards, and a pressure Π, both of which follow from the equations of {{sec globe.25}} by Φ and
$w = d\Phi/dt$ alone; so

$$ \begin{aligned} |F| &\le \mu\Pi: \text{ it rolls;}\\
   F &> \mu\Pi: \text{ it will scrape to } O;\\
   F &< -\mu\Pi: \text{ it will scrape to } I. \end{aligned} \tag{A} $$

And two things are passed over. The plane cannot pull: when $2g + cww\cos\Phi$ becomes negative the ball
leaves it, with or without friction. And where it does scrape, more pressure makes more friction, which may
make more pressure still. From the equations of {{sec globe.08}} the pressure comes as a quotient whose
denominator is $kk - c\sin\Phi(\lambda y - c\sin\Phi)$, with $y = a - c\cos\Phi$; the motion is determined
by them only as long as that is positive at every Φ, for both signs of λ,

$$ \begin{gathered} \mu < \frac{kk + cc\sin^2\Phi}{c\,y\,|\sin\Phi|}, \quad\text{for which} \\
   \mu < \frac{2k}{a+c} \quad\text{is enough}; \end{gathered} \tag{B} $$

for the square of $k - c\,|\sin\Phi|$ is not negative, and $y$ is $a + c$ at most.

## The program

It decides what the ball does, in the attitude and at the velocities that the reader gives. Where the ball
scrapes and the denominator is not positive there, it refuses.
*/

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the centre to the centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto mu =
    real("mu", 1. / 3, none, closed(0, 1e20), "μ, friction over pressure where the ball scrapes");
const auto Phi = angle("Phi", 60_deg, closed(-1e12_deg, 1e12_deg), "angle ACS");
const auto v = real("v", 4, Unit{"ft/s"}, closed(-1e60, 1e60), "ds/dt, velocity of the centre");
const auto w = real("w", 4, Unit{"1/s"}, closed(-1e60, 1e60), "dΦ/dt, angular velocity");

Ball<Fifty> ball()
{
  return {a.fifty(), c.fifty(), k.fifty()};
}

struct Needs
{
  Fifty friction, pressure;  // over the weight; friction backwards
};

Needs needs_of_rolling()
{
  const auto moved = rolling_accelerations(ball(), g.fifty(), Phi.fifty(), w.fifty());
  return {-moved.x / (2 * g.fifty()), moved.pressure};
}

enum class Does
{
  leaves,
  scrapes_on,
  scrapes_back,
  rolls,
  begins_on,
  begins_back
};

Does does()
{
  if(2 * g.fifty() + c.fifty() * w.fifty() * w.fifty() * cos(Phi.fifty()) < 0)
    return Does::leaves;
  const Fifty sigma = v.fifty() - a.fifty() * w.fifty();
  if(sigma != 0)  // (1)
    return sigma > 0 ? Does::scrapes_on : Does::scrapes_back;
  const Needs needs = needs_of_rolling();
  if(abs(needs.friction) <= mu.fifty() * needs.pressure)  // (A)
    return Does::rolls;
  return needs.friction > 0 ? Does::begins_on : Does::begins_back;
}

double lambda(Does what)
{
  switch(what)
  {
    case Does::leaves:
      return 0;
    case Does::rolls:
    {
      const Needs needs = needs_of_rolling();
      return needs.friction == 0 ? 0 : double(needs.friction / needs.pressure);
    }
    case Does::scrapes_on:
    case Does::begins_on:
      return mu;
    default:
      return -mu;
  }
}

bool determined(Does what)  // the denominator before (B), where it scrapes
{
  if(what == Does::leaves || what == Does::rolls)
    return true;
  const Fifty side = c.fifty() * sin(Phi.fifty()), y = a.fifty() - c.fifty() * cos(Phi.fifty());
  const Fifty friction = lambda(what) > 0 ? mu.fifty() : Fifty(-mu.fifty());
  return k.fifty() * k.fifty() - side * (friction * y - side) > 0;
}

const std::array<const char*, 6> in_words{"leaves the plane",           "scrapes towards O",
                                          "scrapes towards I",          "rolls",
                                          "begins to scrape towards O", "begins to scrape towards I"};

TELL
{
  const Fifty b = sqrt(bb(ball()));
  require(a.fifty() + c.fifty() < 1e20 * b, "k", "more, or c farther from a: a + c below 1e20 b");
  const Does what = does();
  require(determined(what), "mu", "less: so much leaves the scraping undetermined at this angle");
  tell("ball", in_words.at(static_cast<std::size_t>(what)), "what the ball does");
  tell("lambda", lambda(what), "λ, friction over pressure, positive backwards");
  const Needs needs = needs_of_rolling();
  tell("friction", double(needs.friction), "F/P, what rolling would need at this Φ and w");
  tell("pressure", double(needs.pressure), "Π/P, what the plane would bear meanwhile");
  const auto limit = rolling::painleve(ball());
  tell("limit", double(limit.mu), "the μ up to which scraping is determined at every angle");
  tell("Phi_limit", double(limit.Phi), degrees, "the angle that sets this limit");
  tell("enough", double(2 * k.fifty() / (a.fifty() + c.fifty())), "2k/(a+c), below which every μ is safe");
}

TELL
{
  curve("limits", {"c", "k", "limit", "enough"}, [](Curve& limits) {
    for(const double c_ : {0.1, 0.5, 0.9})
    {
      for(int n = 0; n <= 60; ++n)
      {
        const double k_ = std::pow(10, -2 + n / 30.);
        if(k_ * k_ + c_ * c_ > 1)
          break;
        limits.put({c_, k_, double(rolling::painleve(Ball<Fifty>{1, c_, k_}).mu), 2 * k_ / (1 + c_)});
      }
      limits.block();
    }
  });
}

/*!
At these velocities the ball {{ball}}, and takes {{lambda|4}} of the pressure for it. Scraping would be
determined up to $\mu = {{limit|4}}$; the angle that sets this limit is {{Phi_limit|4}}. A third is far
below.

::: figure globe-04
alt: Limits of mu against the radius of gyration, in logarithmic scales: for three eccentricities three
rising curves, each above a straight line that it approaches on the left. A horizontal line marks one third.

The greatest μ with which scraping is determined, for balls of three eccentricities: exact (blue), and
$2k/(a+c)$ (grey), which is always enough. By that a third is safe for every ball whose $k$ is more than
$\tfrac16(a+c)$.
:::

## Checks

What rolling needs is found here without forces. The energy of a rolling ball is given, its velocity at two
neighbouring angles follows, and the differences tell how $G$ must be accelerated.
*/

Needs by_energy()
{
  const Fifty a_ = a.fifty(), c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), w_ = w.fifty(), h = 1e-12;
  const auto x = [&](const Fifty& turn) { return a_ * turn - c_ * sin(Phi.fifty() + turn); };
  const auto y = [&](const Fifty& turn) { return a_ - c_ * cos(Phi.fifty() + turn); };
  const auto inertia = [&](const Fifty& turn) {  // about the point of contact
    return k_ * k_ + pow(hypot(c_ * sin(Phi.fifty() + turn), y(turn)), 2);
  };
  const Fifty energy = inertia(0) * w_ * w_ / 2 + 2 * g_ * y(0);
  const auto ww = [&](const Fifty& turn) { return 2 * (energy - 2 * g_ * y(turn)) / inertia(turn); };
  const Fifty turning = (ww(h) - ww(-h)) / (4 * h);
  const auto twice = [&](const std::function<Fifty(const Fifty&)>& of) {
    return (of(h) - 2 * of(0) + of(-h)) / (h * h) * w_ * w_ + (of(h) - of(-h)) / (2 * h) * turning;
  };
  return {-twice(x) / (2 * g_), 1 + twice(y) / (2 * g_)};
}

CHECK_THAT("the force and the pressure told are what the energy of a rolling ball asks for")
{
  for(const Told& now : told_at("", "w=0 v=0 Phi=-30 c=0.5 k=0.5", "c=0.9 Phi=170 w=12 v=12",
                                "a=1e50 c=3e49 k=5e49 g=1e50 Phi=1e6 w=-1"))
  {
    const Needs needs = by_energy();
    const double ww = w * w * ((a + c) / g) + 1;  // how much turning there is
    CHECK(now.value("friction") == within(needs.friction, 1e-15 * ww, "differences, and one rounding"));
    CHECK(now.value("pressure") == within(needs.pressure, 1e-15 * ww, "differences, and one rounding"));
  }
}

/*!
Whether it is right that the ball begins to scrape can be seen by letting it: with $\lambda = \pm\mu$ the
velocity of scraping must grow to that side. And where it rolls, it must not grow to the side to which
friction lets it.
*/

Fifty scraping_grows(const Fifty& with)  // dσ/dt when λ is so much
{
  const auto moved = accelerations(ball(), g.fifty(), Phi.fifty(), w.fifty(), with);
  const Fifty turning = moved.Phi, ww = w.fifty() * w.fifty();
  const Fifty dds = moved.x + c.fifty() * (turning * cos(Phi.fifty()) - ww * sin(Phi.fifty()));
  return dds - a.fifty() * turning;
}

CHECK_THAT("what the ball is told to do is what its point at S does next")
{
  for(const Told& now :
      told_at("", "v=3.9999999999999996", "v=4.0000000000000009 mu=0", "Phi=80 w=0 v=0 mu=0.05",
              "Phi=-80 w=0 v=0 mu=0.05", "Phi=80 w=0 v=0 mu=0.0729", "Phi=80 w=0 v=0 mu=0.0731",
              "Phi=180 w=18 v=18", "Phi=180 w=17 v=17", "Phi=0 w=0 v=0 mu=0",
              "c=0.5 k=0.5 Phi=1rad w=0 v=0 mu=0.2"))
  {
    const bool pulls = 1 + c.fifty() * pow(w.fifty(), 2) * cos(Phi.fifty()) / (2 * g.fifty()) < 0;
    const Fifty sigma = v.fifty() - a.fifty() * w.fifty();
    const Fifty on = scraping_grows(mu.fifty()), back = scraping_grows(-mu.fifty());
    std::string expected = "rolls";
    if(pulls)
      expected = "leaves the plane";
    else if(sigma > 0)
      expected = "scrapes towards O";
    else if(sigma < 0)
      expected = "scrapes towards I";
    else if(on > 0)
      expected = "begins to scrape towards O";
    else if(back < 0)
      expected = "begins to scrape towards I";
    CHECK(now.value("ball") == expected);
    // The λ told: none, ±μ, or the one with which the scraping does not grow.
    if(expected == "leaves the plane")
      CHECK(now.value("lambda") == within(0, 0, "no plane, no friction"));
    else if(expected == "rolls")
    {
      const Needs needs = by_energy();
      CHECK(now.value("lambda") == within(needs.friction / needs.pressure, 1e-15, "the energy's"));
      CHECK(scraping_grows(needs.friction / needs.pressure)
            == within(0, 1e-20 * double(g), "the step of the differences"));
    }
    else
    {
      const Fifty side = expected.ends_with("O") ? Fifty(1) : Fifty(-1);
      CHECK(now.value("lambda") == within_ulps(side * mu.fifty(), 0.51, "the fraction that was given"));
    }
  }
}

CHECK_THAT("scraping is refused where with its λ the plane would have to pull, and nowhere else")
{
  const char* const twice[] = {"c=0.5 k=0.1 mu=0.95 Phi=80 w=0 v=1",
                               "c=0.5 k=0.1 mu=0.95 Phi=-80 w=0 v=-1"};
  for(const char* const setting : twice)
    CHECK(refused_at(setting));
  // At 90° the denominator is kk + cc − μac, with c = k = a:2 nothing for μ = 1.
  for(const char* const side : {"Phi=90 v=1", "Phi=-90 v=-1"})
  {
    CHECK(refused_at(std::string("c=0.5 k=0.5 w=0 mu=1 ") + side));
    CHECK(!refused_at(std::string("c=0.5 k=0.5 w=0 mu=0.99999999999999999 ") + side));
  }
  for(const char* const setting :
      {"c=0.5 k=0.1 mu=0.95 Phi=-80 w=0 v=1", "c=0.5 k=0.1 mu=0.55 Phi=80 w=0 v=1"})
    for(const Told& now : told_at(setting))
    {
      CHECK(now.value("ball") == "scrapes towards O");
      CHECK(accelerations(ball(), g.fifty(), Phi.fifty(), w.fifty(), mu.fifty()).pressure > 0);
    }
  const Fifty at = 80 * exact::pi() / 180;
  CHECK(accelerations(Ball<Fifty>{1, Fifty(1) / 2, Fifty(1) / 10}, Fifty(1), at, Fifty(0), Fifty("0.95"))
            .pressure
        < 0);
}

CHECK_THAT("with G at the surface it refuses a k of a:5e19, and not one just above it")
{
  CHECK(refused_at("a=5e19 c=5e19 k=1 mu=0"));
  CHECK(!refused_at("a=5e19 c=5e19 k=1.0000000000000001 mu=0"));
}

CHECK_THAT("at the limit told the denominator vanishes, at that angle and at no other, and (B) is enough")
{
  for(const Told& now :
      told_at("", "c=0.5 k=0.5", "c=1 k=1e-6", "a=3e-60 c=5e-60 k=1e-60", "a=9e90", "c=1e-50"))
  {
    const Ball<Fifty> b = ball();
    const auto bound = [&](const Fifty& at) {
      const Fifty side = b.c * sin(at), y = b.a - b.c * cos(at);
      return (b.k * b.k + side * side) / abs(side * y);
    };
    // The least value, between the neighbours of the best of many angles.
    const int n = 2000;
    int best = 1;
    for(int i = 1; i < n; ++i)
      if(bound(exact::pi() * i / n) < bound(exact::pi() * best / n))
        best = i;
    Fifty from = exact::pi() * (best - 1) / n, to = exact::pi() * (best + 1) / n;
    const Fifty part = (sqrt(Fifty(5)) - 1) / 2;
    for(int i = 0; i < 130; ++i)
    {
      const Fifty first = to - part * (to - from), second = from + part * (to - from);
      (bound(first) < bound(second) ? to : from) = bound(first) < bound(second) ? second : first;
    }
    CHECK(now.value("limit") == within_ulps(bound(from), 1, "rounded once"));
    CHECK(now.value("Phi_limit", degrees)
          == within_relative(from, 1e-15, "half of fifty digits, at a minimum; rounded once"));
    CHECK(now.value("enough") == within_ulps(2 * b.k / (b.a + b.c), 1, "rounded once"));
    CHECK(bound(from) == between(2 * b.k / (b.a + b.c), infinity, "(B)"));
  }
}

CHECK_THAT("the less k, the nearer the limit is to 2k/(a+c)")
{
  Fifty last = 2;
  for(const char* const k_ : {"1e-1", "1e-2", "1e-4", "1e-8"})
  {
    const Fifty ratio =
        rolling::painleve(Ball<Fifty>{1, Fifty(1) / 10, Fifty(k_)}).mu / (2 * Fifty(k_) / Fifty("1.1"));
    CHECK(ratio == between(1, last, "it falls"));
    last = ratio;
  }
  CHECK(last == within(1, 1e-9, "the sine need only be k/c, near the top"));
}

CHECK_THAT(
    "the limits drawn are the least of (B), and more than a third where k is more than a sixth of a + c")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("limits", 13))
    {
      const Fifty c_ = point.at("c"), k_ = point.at("k");
      Fifty least = 1e9;
      for(int i = 1; i < 4000; ++i)
      {
        const Fifty at = exact::pi() * i / 4000;
        least =
            std::min(least, Fifty((k_ * k_ + pow(c_ * sin(at), 2)) / (c_ * sin(at) * (1 - c_ * cos(at)))));
      }
      CHECK(point.value("limit") == within_relative(least, 1e-3, "the steps of the search"));
      CHECK(point.value("limit") == between(0, least, "the least of all"));
      CHECK(point.value("enough") == within_relative(2 * k_ / (1 + c_), 1e-15, "three roundings"));
      CHECK(point.value("c") == between(0.1, 0.9, "one of three"));
      CHECK(point.value("k") == between(0.01, 1, "balls"));
      if(6 * k_ > 1 + c_)
        CHECK(point.value("limit") == between(Fifty(1) / 3, infinity, "a third is safe"));
    }
}

/*!
Our copy has ½ for the fraction here, and again in {{sec globe.24}}. In {{sec globe.27}}, however, rolling
is out of danger when $S + a$ is more than $3c$, and it needs $c/(S+a)$: there he reckons with a third. We
follow that; but nothing says that it must be the same number in both places, and with a half rolling would
be out of danger then, too.
*/

const Undecided usual{"§4, the common fraction",
                      {"1/2", 0.5},
                      {"1/3", 1. / 3},
                      "rolling that needs no more than c/(3c), as in §27, is possible with it",
                      lets_roll_what_is_safe};

/*!
## Notes

That the equations may have no solution, or two, when friction is great was seen by Painlevé on a rod that
slides over a table; the ball with its mass in one place is of the same kind.

## Go on from here

::: exercise
A ball stands, held, at Φ = 80° and is let go. How much friction does it take that it begins to roll?
answer: $\lambda = c\sin\Phi\,y/(kk+yy)$, for our ball 0.0730; below that it begins to scrape towards $O$,
for its back, where $G$ is, falls and $S$ is thrown forwards.
:::
*/

CHECK_THAT("let go at 80° our ball rolls only with μ above c sin Φ y/(kk + yy)")
{
  const Fifty at = 80 * exact::pi() / 180, c_ = Fifty(1) / 10, y = 1 - c_ * cos(at);
  const Fifty least = c_ * sin(at) * y / (Fifty(9) / 25 + y * y);
  CHECK(least == printed("0.0730"));
  for(const Told& now : told_at("Phi=80 w=0 v=0 mu=0.0729"))
    CHECK(now.value("ball") == "begins to scrape towards O");
  for(const Told& now : told_at("Phi=80 w=0 v=0 mu=0.0731"))
    CHECK(now.value("ball") == "rolls");
}
