#include "edition/section.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

SECTION(tautochrone, 23, "The length of the pendulum that keeps time with it")

using namespace tautochrone;

/*!
## What Euler does

The length $f$ is found from the radius of curvature in the lowest place $C$, which must be $AC = a$.
There $r = a$, and the equation of {{sec tautochrone.22}} becomes

$$ \sqrt{2fx} = \frac{z{{entry lost_z}}\sqrt{aa+kk}}a, \qquad zz{{entry lost_square}} =
  \frac{2aafx}{aa+kk}. \tag{1} $$

Since in $C$ the radius of curvature is equal to the subnormal

$$ \frac{z\,dz}{dx}{{entry subnormal}} = \frac{aaf}{aa+kk}, \tag{2} $$

it is necessary that $\frac{aaf}{aa+kk} = a$, and therefore

$$ f = a + \frac{kk}a = AD. \tag{3} $$

::: margin
The radius $kk/a$ in the lowest place has the same $f$. It is that of the pendulum turned over: $a$ and
$kk/a$ change places.
:::

The length of the isochronous simple pendulum will thus be equal to $AD$. That is clear of itself: the
smallest swings of this compound pendulum, with which all of the wider ones are isochronous, are made in
arcs of circles described with the radius $AC$, and go on no otherwise than if all mass of the body were
collected in its centre of oscillation $D$; so that $AD$ shows the length of the isochronous simple
pendulum.

## The program

$f$, and the times of swings between the cheeks that the paper knows: whatever they are, the time of a
swing that gets smaller and smaller comes to that of {{eq 3}}.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto phi0 = angle("phi0", 1_deg, open(0_deg, 60_deg), "how far the pendulum swings to either side");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

struct Hanging
{
  const char* name;
  Cheeks cheeks;
  const char* meaning;
};

constexpr Hanging all_cheeks[]{{"circle", Cheeks::none, "a swing on a fixed axis"},
                               {"cycloid", Cheeks::cycloids, "a swing between Huygens's cheeks"},
                               {"euler_kk", Cheeks::euler_kk, "between Euler's, with one correction"},
                               {"euler_k4", Cheeks::euler_k4, "and with both"}};

double in_seconds(double time)  // from Euler's clock, a = 1
{
  return time * (std::sqrt(a) / (2 * std::sqrt(g)));
}

TELL
{
  require_ratio(k / a);
  tell("CD", k / a * k, metres, "kk/a, how far D is below C");
  tell("f", a + k / a * k, metres, "AD, the length of the isochronous simple pendulum, (3)");
  tell("T_0", in_seconds(small_swing(k / a)), seconds, "an infinitely small swing");
  for(const auto& [name, cheeks, meaning] : all_cheeks)
    if(phi0 < largest_amplitude(cheeks, k / a))
      tell(name, in_seconds(swing_time(cheeks, k / a, phi0)), seconds, meaning);
}

TELL
{
  curve("times", {"phi0", "circle", "cycloid", "kk", "k4"}, [](Curve& out) {
    for(int i = 1; i <= 120; ++i)
    {
      std::vector<double> row{i / 4.0};
      for(const auto& [name, cheeks, meaning] : all_cheeks)
        row.push_back(swing_time(cheeks, 0.3, i * 0.25_deg) / small_swing(0.3));
      out.put(row);
    }
  });
}

/*!
With $k = \tfrac1{10}a$, $f$ is {{f|6}} m, and the smallest swing takes {{T_0|8}} s.

::: figure tautochrone-23
alt: The time of a swing over that of the smallest, against the amplitude up to 30 degrees. Four lines
start together from one, level: the circle rises fastest, the cycloid a third as much, Euler's curves less
still.

The time of a swing, over that of the smallest, $k = \tfrac3{10}a$. Whatever the cheeks, all begin with
the time of a simple pendulum of the length $AD$.
:::

## Checks
*/

CHECK_THAT("the smallest swings, out to 10⁻⁸ of a radian, have the time of (3) on all cheeks, and wider "
           "ones that of the quadrature")
{
  for(const Told& now :
      told_at("", "phi0=1e-8rad k=0.7 a=2", "phi0=30 k=0.2", "phi0=1e-100rad a=1e50 k=1e48"))
  {
    const Fifty small = k.fifty() / a.fifty(), f = a.fifty() * (1 + small * small),
                T = exact::pi() * sqrt(f / (2 * g.fifty()));
    CHECK(now.value("CD", metres) == within_relative(a.fifty() * small * small, 1e-15, "two roundings"));
    CHECK(now.value("f", metres) == within_relative(f, 1e-15, "three roundings"));
    CHECK(now.value("T_0", seconds) == within_relative(T, 2e-15, "two ulps and three roundings"));
    for(const auto& [name, cheeks, meaning] : all_cheeks)
    {
      const int order = cheeks == Cheeks::cycloids ? 0 : cheeks == Cheeks::euler_kk ? 1 : 2;
      const auto r = cheeks == Cheeks::none ? exact::Laurent<Fifty>(1) : truncated(order, small);
      const Fifty over = phi0 < 1e-4 ? Fifty(0) : excess(r, small, phi0.fifty());
      CHECK(now.value(name, seconds)
            == within_relative(T * (1 + over), 2e-15, "three ulps and three roundings"));
    }
  }
}

CHECK_THAT("it refuses a k less than 1e-9 a, and one greater than 1e9 a")
{
  for(const char* const within_them : ratio_within)
    CHECK(!refused_at(within_them));
  for(const char* const beyond : ratio_beyond)
    CHECK(refused_at(beyond));
}

CHECK_THAT("(3) is where the subnormal (2) is a, in fractions, and kk/a in the place of a has the same f")
{
  const Rational a_(7, 3), kk(4, 25), f = a_ + kk / a_;
  CHECK(a_ * a_ * f / (a_ * a_ + kk) == a_);
  CHECK(kk / a_ + kk / (kk / a_) == f);
}

CHECK_THAT("the figure's curves are the quadrature's")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("times", 4))
    {
      const Fifty x = Fifty(point.at("phi0")) * exact::pi() / 180, small("0.3");
      CHECK(point.value("circle")
            == within_relative(1 + excess(exact::Laurent<Fifty>(1), small, x), 1e-15, "four ulps"));
      for(const auto& [name, order] : {std::pair{"cycloid", 0}, {"kk", 1}, {"k4", 2}})
        CHECK(point.value(name)
              == within_relative(1 + excess(truncated(order, small), small, x), 1e-15, "four ulps"));
    }
}

/*!
The scan has read three letters $z$ of {{eq 1}} and {{eq 2}} as the figure 2. They are tried at $a = 2$,
$k = \tfrac35$ and a very small height $x$; near $C$ the curve is a circle of the radius $a$.
*/

const double x = 1e-10, f_ = 2 + 0.36 / 2, arc = 2 * std::sqrt(x);  // zz = 2ax nearly

const Emendation lost_z{
    "§23, √(2fx) near C",
    {"2√(aa + kk)/a", 2 * std::sqrt(4.36) / 2},
    {"z√(aa + kk)/a", arc* std::sqrt(4.36) / 2},
    "it is the integral of dz√(kk + rr)/r with r = a",
    [](double reading) { return reading == within_relative(sqrt(Fifty(2) * f_ * x), 1e-14, "roots"); }};

const Emendation lost_square{
    "§23, zz",
    {"2z = 2aafx/(aa + kk)", 4 * f_* x / 4.36},
    {"zz = 2aafx/(aa + kk)", std::sqrt(8 * f_ * x / 4.36)},
    "it is the line before, squared; and the arc of a circle is so",
    [](double z) { return z == within_relative(2 * acos(1 - Fifty(x) / 2), 1e-10, "x/12 of it"); }};

const Emendation subnormal{"§23, the subnormal",
                           {"2dz/dx", 2 / std::sqrt(x)},
                           {"z dz/dx", arc / std::sqrt(x)},
                           "§21 has it so, and the radius of curvature in C must come to a",
                           [](double reading) { return reading == within_relative(2, 1e-14, "a = 2"); }};

/*!
## Go on from here

::: exercise
A maker gives the pendulum of a clock, a body with $k = \tfrac1{10}a$, the length $a$ of the simple pendulum
that keeps the time wanted. How wrong does the clock go?

answer: It swings as a simple pendulum of the length $a + kk/a$, a hundredth more: too slowly by
$\sqrt{1 + kk/aa} - 1$, 431 seconds in a day. That is why $a$ must not be measured but timed
({{sec tautochrone.12}}); against it all that the cheeks do is little.
:::
*/

CHECK_THAT("a body with k = a/10 on the length a is late by 431 seconds in a day")
{
  const Fifty part = Fifty(431) / 86'400;
  for(const Told& now : told_at(""))
    CHECK(now.value("T_0", seconds)
          == within_relative(exact::pi() * sqrt(a.fifty() / (2 * g.fifty())) * (1 + part), 0.5 / 86'400,
                             "half a second in a day"));
}
