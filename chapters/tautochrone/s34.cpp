#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"
#include "tautochrone/thread.hpp"

SECTION(tautochrone, 34, "The cheek by points")

using namespace tautochrone;

/*!
## What Euler does

The formulae of {{sec tautochrone.33}}, integrated, give both coordinates of the cheek for any angle, so
that it can be drawn by points; with that the paper ends. The abscissa $AP$ is

$$ \begin{aligned} p = \tfrac12a\sin^2\varphi &+ \frac{kk\sin^2\varphi}{2a} - \frac{3kk}{2a} \\
  &+ \frac{3kk}{2a\cos^2\varphi} - \frac{15k^4}{2a^3{{entry cube_of_a}}\cos^4\varphi} \\
  &+ \frac{7k^4}{a^3\cos^6\varphi} + \frac{k^4}{2a^3}. \end{aligned} \tag{1} $$

For the ordinate one needs

$$ \int d\varphi\sin^2\varphi = \tfrac12\varphi - \tfrac12\sin\varphi\cos\varphi, \tag{2} $$

$$ \begin{aligned} \int\frac{d\varphi}{\cos^2\varphi} &= \frac{\sin\varphi}{\cos\varphi}, \\
  \int\frac{d\varphi}{\cos^4\varphi} &= \frac{\sin\varphi}{3\cos^3\varphi} +
  \frac{2\sin\varphi}{3\cos\varphi}, \end{aligned} \tag{3} $$

$$ \int\frac{d\varphi}{\cos^6\varphi} = \frac{\sin\varphi}{5\cos^5\varphi} +
  \frac{4\sin\varphi}{15\cos^3\varphi} + \frac{8\sin\varphi}{15\cos\varphi}, \tag{4} $$

$$ \begin{aligned} \int\frac{d\varphi}{\cos^8\varphi} = \frac{\sin\varphi}{7\cos^7\varphi} &+
  \frac{6\sin\varphi}{35\cos^5\varphi} \\
  &+ \frac{8\sin\varphi}{35\cos^3\varphi} + \frac{16\sin\varphi}{35\cos\varphi}, \end{aligned} \tag{5} $$

and has

$$ \begin{aligned} q = \tfrac12a\varphi &- \tfrac12a\sin\varphi\cos\varphi + \frac{kk\varphi}{2a} \\
  &- \frac{kk\sin\varphi\cos\varphi}{2a} - \frac{kk\sin\varphi}{a\cos\varphi} \\
  &+ \frac{kk\sin\varphi}{a\cos^3\varphi} \\
  &+ \frac{k^4\sin\varphi}{a^3\cos\varphi}\Bigl(\frac45 + \frac2{5\cos^2\varphi} \\
  &\qquad - \frac{36}{5\cos^4\varphi} + \frac6{\cos^6\varphi}\Bigr). \end{aligned} \tag{6} $$

Since both coordinates, $p$ and $q$, can be had from the given angle $\varphi$, which is also the amplitude of
the arc $AM$, the curve that was sought, $AMB$, is constructed without difficulty.

::: margin
The cheek's amplitude is the angle through which its tangent has turned.
:::

How good is a clock with such cheeks? For narrow swings the excess of the time can be had in finite terms:
with $n$ corrections in the radius it is

$$ \frac T{T_0} - 1 = \frac{kk}{aa+kk}\Bigl(\frac{3kk}{aa}\Bigr)^{\!n}\frac{\varphi_0^2}4 \text{
  nearly}, \tag{A} $$

so that each correction is worth the factor $3kk/aa$.

## The program

The workshop gets a table of points, and beside it how far the cheek stands off from Huygens's, which has
$k = 0$.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto phi = angle("phi", 15_deg, closed(0_deg, 85_deg),
                       "angle of the thread with the vertical, where it leaves the cheek");
const auto phi0 =
    angle("phi0", 5_deg, open(0_deg, 80_deg), "how far the clock's pendulum swings to either side");

double law(int n)  // (A)
{
  const double kappa = k / a * (k / a);
  return kappa / (1 + kappa) * std::pow(3 * kappa, n) * phi0 * phi0 / 4;
}

TELL
{
  const double last = asked_end(k / a, phi);
  tell("p", euler_p<double>(a, k, phi), metres, "AP, how far M is below A");
  tell("q", euler_q<double>(a, k, phi), metres, "PM, how far it is from the vertical");
  if(k / a >= 1e-10 && phi0 < last)
  {
    const double over = excess(Cheeks::euler_k4, k / a, phi0);
    tell("excess", over, "T/T₀ − 1 between such cheeks");
    tell("late", 86'400 * over, seconds, "what the clock loses in a day");
    tell("law", law(2), "(A), n = 2");
  }
  auto& rows = table("cheek", "The cheek by points, in metres, as far as there is thread to be wound",
                     {{"phi", "φ", degrees, 3},
                      {"p", "p", metres, 8},
                      {"q", "q", metres, 8},
                      {"p_off", "p off Huygens's", metres, 4},
                      {"q_off", "q off Huygens's", metres, 4}});
  for(int i = 5; i <= 60 && i * 1_deg < last; i += i < 30 ? 5 : 10)
  {
    const double here = i * 1_deg;
    const auto off = [&](auto of) { return off_huygens(of, a.fifty(), k.fifty(), Fifty(here)); };
    rows.row({here, euler_p<double>(a, k, here), euler_q<double>(a, k, here), off(euler_p<Fifty>),
              off(euler_q<Fifty>)});
  }
}

TELL
{
  curve("cheeks", {"p", "q", "ratio"}, [](Curve& out) {
    for(const double ratio : {0.0, 0.1, 0.3})
    {
      const double last = std::min(largest_amplitude(Cheeks::euler_k4, ratio), 89_deg);
      for(int i = 0; i <= 100; ++i)
        out.put(
            {euler_p<double>(1, ratio, last * i / 100), euler_q<double>(1, ratio, last * i / 100), ratio});
      out.block();
    }
  });
  curve("exact", {"p", "q"}, [](Curve& out) {
    std::vector<double> angles;
    for(int i = 1; i <= 60; ++i)
      angles.push_back(end(Member::highest, 0.3).phi * i / 60.001);
    for(const auto& place_ : tautochrone::drawn(Member::highest, 0.3, angles))
      out.put({place_.p, place_.q});
  });
}

/*!
A clock with such cheeks, $k = \tfrac1{10}a$, loses {{late|e3}} s in a day if it swings 5°. The cheek
stands off from Huygens's by more than a workshop can neglect:

{{table cheek}}

::: figure tautochrone-34
alt: Three cheeks hang from one cusp; the larger k is, the more steeply they run down. The dashed exact
cheek for three tenths is steeper still, and short.

The cheek for $k = 0$, for $\tfrac1{10}a$ and for $\tfrac3{10}a$, each up to the depth $0.62a$ at most.
Dashed, the cheek of the highest exact tautochrone for $\tfrac3{10}a$: of so large a body Euler's is no
longer near.
:::
*/

/*!
### Three bobs

Three equal bodies, all with the radius of gyration $k = {{body}}\,a$, are let go together at
{{wide|deg0}}: one between Huygens's cheeks, one between Euler's, one between those of the highest exact
tautochrone. The exact one swings like a clock that never varies, $\sqrt x$ as a cosine of the time. The
other two are followed from rest by steps of the equation of motion ({{eq tautochrone.17 3}}); whole
swings, there and back, are left out of the time first.
*/

const auto body = real("body", 0.3, none, closed(0.02, 0.9), "k/a of the three bodies");
const auto wide = angle("wide",
                        at_most(30_deg, "nine tenths of where the first of the curves ends",
                                [] {
                                  return 0.9
                                         * std::min(largest_amplitude(Cheeks::euler_k4, body),
                                                    end(Member::highest, body).phi);
                                }),
                        closed(1_deg, 80_deg), "the angle at which they are let go");
const auto swings = real("swings", 78, none, closed(0, 1e5), "time since then, in swings of the exact one");

double angle_after(Cheeks cheeks,
                   double time)  // since it was let go, a = 1, Euler's clock; the right side is positive
{
  const double T = swing_time(cheeks, body, wide), h = std::fmod(time, 2 * T) / 2000;
  const auto change = [cheeks](double at, double speed) {
    const auto place_ = on_cheeks<double>(cheeks, body, at, at);
    return place_.r * place_.sin * (place_.shortening * speed * speed - 0.5)
           / (body * body + place_.r * place_.r);
  };
  double at = wide, speed = 0;
  for(int i = 0; i < 2000; ++i)  // Runge's and Kutta's steps
  {
    const double one = change(at, speed), two = change(at + h / 2 * speed, speed + h / 2 * one),
                 three = change(at + h / 2 * (speed + h / 2 * one), speed + h / 2 * two),
                 four = change(at + h * (speed + h / 2 * two), speed + h * three);
    at += h * (speed + h / 6 * (one + two + three));
    speed += h / 6 * (one + 2 * two + 2 * three + four);
  }
  return at;
}

double exact_angle_after(double count)  // the same after so many swings of the exact one
{
  const double phase = std::cos(std::numbers::pi * std::fmod(count, 2));
  const double x = tautochrone::at(Member::highest, body, wide).x * phase * phase;
  double lo = 0, hi = wide;
  for(int i = 0; i < 60; ++i)
    (tautochrone::at(Member::highest, body, (lo + hi) / 2).x < x ? lo : hi) = (lo + hi) / 2;
  return std::copysign(hi, phase);
}

struct Hung  ///< where a bob is, and its thread leaves the cheek, a = 1
{
  double y, down, q, p;
};

Hung hung(int which, double at)  // 0 Huygens's, 1 Euler's, 2 exact
{
  const double size = std::abs(at), side = at < 0 ? -1 : 1, used = which == 0 ? 0 : double(body);
  if(which < 2)
    return {side * euler_y<double>(1, used, size), 1 - euler_x<double>(1, used, size),
            side * euler_q<double>(1, used, size), euler_p<double>(1, used, size)};
  if(size < 1e-9)
    return {at, 1, 0, 0};
  const Drawn place_ = tautochrone::drawn(
      Member::highest, body, {std::min(size, end(Member::highest, body).phi * (1 - 1e-12))})[0];
  return {side * place_.y, 1 - place_.at.x, side * place_.q, place_.p};
}

TELL
{
  require(wide < 0.95 * largest_amplitude(Cheeks::euler_k4, body), "wide",
          "less than 95 hundredths of the angle at which Euler's curve ends");
  require(wide < end(Member::highest, body).phi, "wide",
          "less than the angle at which the exact curve ends");
  const double time = swings * small_swing(body);
  auto& rows = table("bobs", "The three bobs after so many swings of the exact one, in parts of a",
                     {{"bob", "between the cheeks of"},
                      {"angle", "angle", degrees, 6},
                      {"y", "to the right"},
                      {"down", "below A"},
                      {"q", "M to the right"},
                      {"p", "M below A"}});
  const double angles[]{angle_after(Cheeks::cycloids, time), angle_after(Cheeks::euler_k4, time),
                        exact_angle_after(swings)};
  const char* const names[]{"Huygens", "Euler", "the exact curve"};
  for(int i = 0; i < 3; ++i)
  {
    const Hung at = hung(i, angles[i]);
    rows.row({names[i], angles[i], at.y, at.down, at.q, at.p});
  }
}

TELL
{
  curve("arcs", {"kind", "y", "down", "q", "p"}, [](Curve& out) {
    for(int which = 0; which < 3; ++which)
    {
      for(int i = -40; i <= 40; ++i)
      {
        const Hung at = hung(which, wide * i / 40);
        out.put({double(which), at.y, at.down, at.q, at.p});
      }
      out.block();
    }
  });
}

/*!
{{table bobs}}

::: figure tautochrone-34-bobs
alt: Between two short cheeks, which hang from A, three threads go down to three bobs. The exact one is
at the right end of its arc, Euler's a little way from the right end of his, and Huygens's near the
lowest place.

The three bobs after {{swings}} swings of the exact one (blue), which is just turning back. Euler's
(vermilion) is late by an eighth of a swing, Huygens's (green) by almost half a one: it is near the
lowest place. Of the three arcs, which are hardly to be told apart, the exact one is drawn.
:::

## Checks
*/

CHECK_THAT("the points told are Euler's (1) and (6), as they stand, in fifty digits")
{
  for(const Told& now : told_at("", "a=2 k=0.7 phi=40", "a=3e60 k=3e58 phi=1e-8", "a=1e-40 k=1e-60 phi=60",
                                "phi=1e-12 k=1e-7"))
  {
    const auto both = [&](const Fifty& x) {
      const Fifty kk = pow(k.fifty() / a.fifty(), 2), k4 = kk * kk, c = cos(x), s = sin(x), cc = c * c,
                  c4 = cc * cc, c6 = c4 * cc;
      const Fifty p =
          (1 + kk) * s * s / 2 - 3 * kk / 2 + 3 * kk / (2 * cc) - 15 * k4 / (2 * c4) + 7 * k4 / c6 + k4 / 2;
      const Fifty q = (1 + kk) * (x - s * c) / 2 - kk * s / c + kk * s / (c * cc)
                      + k4 * s / c * (Fifty(4) / 5 + 2 / (5 * cc) - 36 / (5 * c4) + 6 / c6);
      return std::pair{a.fifty() * p, a.fifty() * q};
    };
    const auto [p, q] = both(phi.fifty());
    const char* const why = "the library's bound, and the angle's rounding";
    CHECK(now.value("p", metres) == within_relative(p, 2e-14, why));
    CHECK(now.value("q", metres) == within_relative(q, 2e-14, why));
    for(const auto& row : now.rows("cheek"))
    {
      const Fifty x = row.at("phi", degrees), c = cos(x), s = sin(x);
      const auto [p_, q_] = both(x);
      CHECK(truncated(2, k.fifty() / a.fifty())(c) > 0);
      CHECK(row.value("p", metres) == within_relative(p_, 2e-14, why));
      CHECK(row.value("q", metres) == within_relative(q_, 2e-14, why));
      const Fifty p_off = p_ - a.fifty() * s * s / 2, q_off = q_ - a.fifty() * (x - s * c) / 2;
      CHECK(row.value("p_off", metres)
            == within(p_off, 1e-14 * double(p_off) + 1e-44 * double(p_),
                      "a difference of two, in fifty digits"));
      CHECK(row.value("q_off", metres)
            == within(q_off, 1e-14 * double(q_off) + 1e-44 * double(q_),
                      "a difference of two, in fifty digits"));
    }
  }
}

CHECK_THAT("(1) and (6) are the integrals of ds cos φ and ds sin φ, ds being that of § 33")
{
  const Fifty A = 2, K("0.6"), to("0.8");
  for(const bool across : {false, true})
  {
    const Fifty sum =
        exact::integrate([&](const Fifty& x) { return euler_ds(A, K, x) * (across ? sin(x) : cos(x)); }, 0,
                         to)
            .value;
    CHECK((across ? euler_q(A, K, to) : euler_p(A, K, to)) == within_relative(sum, 1e-38, "a quadrature"));
  }
}

CHECK_THAT("the integrals (2) to (5) are right: quadrature")
{
  const Fifty to("0.9"), s = sin(to), c = cos(to);
  const auto over = [&](int power) {
    return exact::integrate([=](const Fifty& x) { return pow(cos(x), -power); }, 0, to).value;
  };
  const char* const why = "quadrature";
  CHECK(
      (to - s * c) / 2
      == within(exact::integrate([](const Fifty& x) { return pow(sin(x), 2); }, 0, to).value, 1e-38, why));
  CHECK(s / c == within(over(2), 1e-38, why));
  CHECK(s / (3 * pow(c, 3)) + 2 * s / (3 * c) == within(over(4), 1e-38, why));
  CHECK(s / (5 * pow(c, 5)) + 4 * s / (15 * pow(c, 3)) + 8 * s / (15 * c) == within(over(6), 1e-37, why));
  CHECK(s / (7 * pow(c, 7)) + 6 * s / (35 * pow(c, 5)) + 8 * s / (35 * pow(c, 3)) + 16 * s / (35 * c)
        == within(over(8), 1e-36, why));
}

CHECK_THAT(
    "a thread of the length a, wound on this cheek, leads the centre of gravity along the curve of § 32")
{
  for(const char* ratio : {"0.02", "0.1", "0.3"})
    for(const char* at_ : {"1e-6", "0.4", "0.8"})
    {
      const Fifty K(ratio), x(at_), r = euler_r<Fifty>(1, K, x);
      CHECK(1 - euler_p<Fifty>(1, K, x) - r * cos(x)
            == within(euler_x<Fifty>(1, K, x), 1e-45, "a difference"));
      CHECK(euler_q<Fifty>(1, K, x) + r * sin(x) == within(euler_y<Fifty>(1, K, x), 1e-45, "a sum"));
    }
}

CHECK_THAT("what the clock loses is what the equation leaves: the law (A) for swings however narrow, and "
           "for any number of corrections")
{
  for(const Told& now : told_at("", "phi0=1e-6 k=0.3", "phi0=1e-60 k=0.01 a=2", "phi0=0.1 k=0.05"))
  {
    const Fifty kappa = pow(k.fifty() / a.fifty(), 2), pp = pow(phi0.fifty(), 2);
    const Fifty law_ = 9 * pow(kappa, 3) / (1 + kappa) * pp / 4;
    CHECK(now.value("law") == within_relative(law_, 4e-15, "a dozen roundings"));
    const double wider = 1e-12 + 12 * double(pp);
    CHECK(now.value("excess") == within_relative(law_, wider, "the next term, some ten times φ₀φ₀"));
    CHECK(now.value("late", seconds) == within_relative(86'400 * law_, wider, "the same"));
  }
  for(const auto& [cheeks, n] :
      {std::pair{Cheeks::cycloids, 0}, {Cheeks::euler_kk, 1}, {Cheeks::euler_k4, 2}})
  {
    const Fifty kappa = pow(Fifty(0.2), 2);
    CHECK(excess(cheeks, 0.2, 1e-8)
          == within_relative(kappa / (1 + kappa) * pow(3 * kappa, n) * Fifty(1e-16) / 4, 1e-12,
                             "the library's bound"));
  }
}

CHECK_THAT("in the figure Euler's cheeks are (1) and (6), and the exact one has the length that its thread "
           "leaves free")
{
  for(const Told& now : told_at(""))
  {
    for(const auto& point : now.points("cheeks", 7))
    {
      const Fifty K = point.at("ratio");
      Fifty lo = 0, hi = Fifty(89) * exact::pi() / 180;  // the angle at which the depth is this one
      for(int i = 0; i < 120; ++i)
        (euler_p<Fifty>(1, K, (lo + hi) / 2) < Fifty(point.at("p")) ? lo : hi) = (lo + hi) / 2;
      CHECK(point.value("q") == within(euler_q<Fifty>(1, K, lo), 2e-13, "p and q are rounded"));
      CHECK(point.value("p") == between(0, euler_p<Fifty>(1, K, hi) + 1e-13, "the same"));
    }
    Fifty length = 0, p = 0, q = 0;
    for(const auto& point : now.points("exact"))
    {
      length += hypot(Fifty(point.at("p")) - p, Fifty(point.at("q")) - q);
      const Fifty p_ = Fifty(point.at("p")), q_ = Fifty(point.at("q"));
      CHECK(point.value("p") == between(p, 0.5, "it grows"));
      CHECK(point.value("q") == between(q, 0.5, "it grows"));
      p = p_;
      q = q_;
    }
    CHECK(length == within(1 - end(Member::highest, 0.3).r, 1e-3, "chords for arcs"));
  }
}

/*!
The bobs are followed in fifty digits, as two weights each ({{sec tautochrone.14}}), and the exact one by
its height.
*/

CHECK_THAT("the three bobs are where the motion of two weights, and the cosine of the exact one, have them")
{
  for(const Told& now :
      told_at("", "swings=10.3 body=0.1 wide=50", "swings=77.5 body=0.5 wide=20", "swings=0"))
  {
    const auto rows = now.rows("bobs");
    const Fifty ratio = body.fifty(), kk = ratio * ratio, T_0 = exact::pi() * sqrt(2 * (1 + kk));
    for(std::size_t i{0}; i < 3; ++i)
    {
      Fifty to = 0;
      if(i < 2)
      {
        const auto r = truncated(i == 0 ? 0 : 2, ratio);
        const Fifty twice = 2 * T_0 * (1 + excess(r, ratio, wide.fifty())), time = swings.fifty() * T_0;
        const auto motion = [&](const Fifty&, const exact::State& y) -> exact::State {
          return {y[1], accelerations(r, ratio, y[1] * y[1], y[0]).turning / 2};
        };
        const Fifty rest = time - floor(time / twice) * twice;
        to =
            rest > 0 ? exact::solve(motion, 0, {wide.fifty(), 0}, rest, Fifty("1e-16")).y[0] : wide.fifty();
      }
      else
      {
        const auto height = [&](const Fifty& x) -> Fifty {
          const Fifty r = highest(ratio, x);
          return (1 + kk) / 2 * pow(r * sin(x), 2) / (kk + r * r);
        };
        const Fifty phase = cos(exact::pi() * swings.fifty()), c = height(wide.fifty());
        to = exact_angle_after(swings);
        const Fifty size = abs(to);
        if(size > Fifty("1e-6") && size < wide.fifty() * Fifty("0.999999"))
          to -= (height(size) - c * phase * phase) / (highest(ratio, size) * sin(to));
        else
          to = size > Fifty("1e-6") ? wide.fifty() * (phase < 0 ? -1 : 1) : Fifty(0);
      }
      CHECK(rows[i].words("bob") == std::string(i == 0 ? "Huygens" : i == 1 ? "Euler" : "the exact curve"));
      CHECK(rows[i].value("angle", degrees) == within(to, 2e-9, "2000 steps, and the roots of heights"));
      const Fifty size = abs(to), side = to < 0 ? -1 : 1, used = i == 0 ? Fifty(0) : ratio;
      if(i < 2)
      {
        CHECK(rows[i].value("y") == within(side * euler_y<Fifty>(1, used, size), 4e-9, "the angle's"));
        CHECK(rows[i].value("down") == within(1 - euler_x<Fifty>(1, used, size), 4e-9, "the angle's"));
        CHECK(rows[i].value("q") == within(side * euler_q<Fifty>(1, used, size), 4e-9, "the angle's"));
        CHECK(rows[i].value("p") == within(euler_p<Fifty>(1, used, size), 4e-9, "the angle's"));
        continue;
      }
      const Fifty r = size > 0 ? highest(ratio, size) : Fifty(1);
      const Fifty x = (1 + kk) / 2 * pow(r * sin(size), 2) / (kk + r * r);
      CHECK(rows[i].value("down") == within(1 - x, 4e-9, "the angle's"));
      CHECK(rows[i].value("p") == within(1 - x - r * cos(size), 4e-9, "M is MG above G"));
      Fifty y = 0;  // Simpson's rule
      std::vector<Fifty> angles;
      for(int j = 1; j <= 64; ++j)
        angles.push_back(size * j / 64);
      if(size > 0)
      {
        const auto radii = highest(ratio, angles);
        y = 1;
        for(std::size_t j{0}; j < 64; ++j)
          y += (j == 63 ? 1 : j % 2 == 0 ? 4 : 2) * radii[j] * cos(angles[j]);
      }
      CHECK(rows[i].value("y") == within(side * y * size / 192, 1e-6, "the fourth power of a strip"));
      CHECK(rows[i].value("q") == within(side * (y * size / 192 - r * sin(size)), 1e-6, "the same"));
    }
  }
}

CHECK_THAT("it refuses a place beyond the end of Euler's curve, a k greater than a, and bobs let go beyond "
           "the exact curve's end or, but for a twentieth, that of Euler's")
{
  // Euler's r is zero at 60° for 1152κκ + 15κ = 1; the exact curve ends at 30° for 3(1 − k)² = k
  for(const std::string cheek : {"k=0.153828149399070924", "a=2 k=0.307656298798141847"})
  {
    CHECK(!refused_at(cheek + " phi=59.9999999999"));
    CHECK(refused_at(cheek + " phi=60.0000000001"));
  }
  CHECK(!refused_at("body=0.153828149399070924 wide=56.9999999999"));
  CHECK(refused_at("body=0.153828149399070924 wide=57.0000000001"));
  CHECK(!refused_at("body=0.565741454089335118 wide=29.9999999999"));
  CHECK(refused_at("body=0.565741454089335118 wide=30.0000000001"));
  for(const char* const within_them : {"k=1", "a=2 k=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"k=1.0000000000000003", "a=2 k=2.0001"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("Euler's bob is late by an eighth of a swing after 78, Huygens's by almost half of one")
{
  CHECK(78 * excess(Cheeks::euler_k4, 0.3, 30_deg) == within(0.125, 0.01, "an eighth"));
  CHECK(78 * excess(Cheeks::cycloids, 0.3, 30_deg) == between(0.45, 0.5, "almost half"));
}

CHECK_THAT("each arc of that figure is led by its cheek: G is at the end of what the thread leaves free")
{
  for(const Told& now : told_at("", "body=0.1 wide=60"))
    for(const auto& point : now.points("arcs", 13))
    {
      const Fifty y = point.at("y"), down = point.at("down"), q = point.at("q"), p = point.at("p");
      const int which = int(point.at("kind"));
      const Fifty size = abs(atan2(y - q, down - p)), side = y < 0 ? -1 : 1;
      const Fifty free = which < 2 ? euler_r<Fifty>(1, which == 0 ? Fifty(0) : body.fifty(), size)
                         : size > Fifty("1e-9") ? highest(body.fifty(), size)
                                                : Fifty(1);
      CHECK(point.value("kind") == between(0, 2, "three"));
      CHECK(size == between(0, wide.fifty() + Fifty("1e-12"), "within the swing"));
      CHECK(point.value("y") == within(q + side * free * sin(size), 1e-12, "the angle's rounding"));
      CHECK(point.value("down") == within(p + free * cos(size), 1e-12, "the angle's rounding"));
      CHECK(point.value("q") == within(y - side * free * sin(size), 1e-12, "the angle's rounding"));
      CHECK(point.value("p") == within(down - free * cos(size), 1e-12, "the angle's rounding"));
    }
}

CHECK_THAT("the three arcs are hardly to be told apart: at one distance sideways their heights differ by "
           "less than "
           "three thousandths of a")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("arcs", 7))
    {
      const double y = std::abs(point.at("y"));
      double lo = 0, hi = wide;  // on Huygens's arc
      for(int i = 0; i < 60; ++i)
        (euler_y<double>(1, 0, (lo + hi) / 2) < y ? lo : hi) = (lo + hi) / 2;
      CHECK(1 - point.at("down") - euler_x<double>(1, 0, hi) == between(-1e-12, 0.003, "hardly"));
    }
}

/*!
Our copy has $aa$ for $a^3$ under every $k^4$ of {{eq 1}} and {{eq 6}}: then they are no lengths.
*/

double depth_with(int power_of_a)  // (1) at a = 2, k = 0,3, φ = ½
{
  const double cc = std::pow(std::cos(0.5), 2), ss = 1 - cc, kk = 0.09, below = std::pow(2, power_of_a);
  return ss + kk * ss / 4 - 3 * kk / 4 + 3 * kk / (4 * cc)
         + kk * kk / below * (-15 / (2 * cc * cc) + 7 / (cc * cc * cc) + 0.5);
}

const Emendation cube_of_a{
    "§34, the terms with k⁴",
    {"k⁴ over aa", depth_with(2)},
    {"k⁴ over a³", depth_with(3)},
    "it is the integral of ds cos φ",
    [](double depth) {
      const Fifty sum =
          exact::integrate([](const Fifty& x) { return euler_ds<Fifty>(2, Fifty("0.3"), x) * cos(x); }, 0,
                           Fifty("0.5"))
              .value;
      return depth == within_ulps(sum, 8, "a few roundings");
    }};

/*!
## Go on from here

::: exercise
How large may the body be, if a clock with Euler's cheeks that swings 5° is to lose no more than a tenth of a
second in a day?

answer: {{eq A}} with $n = 2$ is nearly $\tfrac94\kappa^3\varphi_0^2$, so that $k$ goes as the sixth root of
what is allowed: it gives $k = 0.203\,a$. `--k 0.2019` tells 0.0998 s, so that the terms that {{eq A}} leaves
out cost less than a hundredth of $k$. Between Huygens's cheeks such a body would lose 6.5 s.
:::

::: exercise
Each correction of the radius is worth the factor $3\kappa$, by {{eq A}}. For which bodies does it do harm,
even to the narrowest swings?

answer: For those with $\kappa > \tfrac13$, $k > 0.577\,a$. There the exact radius no longer begins as the
series says: its first term in $\varphi^2$, $\dfrac{1+\kappa}{1-3\kappa}$, has changed its sign.
:::
*/

CHECK_THAT("with k = 0.2019 a a clock loses a tenth of a second in a day at 5°, by the law with 0.203 a; "
           "with Huygens's "
           "cheeks 6.5 s")
{
  for(const Told& now : told_at("k=0.2019"))
    CHECK(now.value("late", seconds) == between(0.0995, 0.1, "the exercise"));
  for(const Told& now : told_at("k=0.20317"))
    CHECK(now.value("law") == within_relative(0.1 / 86'400, 2e-3, "three digits of k, to the sixth power"));
  CHECK(86'400 * excess(Cheeks::cycloids, 0.2019, 5_deg) == within(6.5, 0.05, "two digits"));
}

CHECK_THAT("for narrow swings the second correction helps where k < 0.577 a, and harms where k > 0.578 a")
{
  for(const double ratio : {0.4, 0.577})
    CHECK(excess(Cheeks::euler_k4, ratio, 1e-6) < excess(Cheeks::euler_kk, ratio, 1e-6));
  for(const double ratio : {0.578, 0.9})
    CHECK(excess(Cheeks::euler_k4, ratio, 1e-6) > excess(Cheeks::euler_kk, ratio, 1e-6));
}
