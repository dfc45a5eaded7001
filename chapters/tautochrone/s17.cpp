#include "edition/section.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/cheeks.hpp"
#include "tautochrone/series.hpp"
#include "tautochrone/swing.hpp"

SECTION(tautochrone, 17, "The equation of motion and its integral")

using namespace tautochrone;

/*!
## What Euler does

The moment $Pb$ put into the equation of the rotation gives the equation of the motion, and this can be
integrated once. For the motion of the pendulum the second equation of {{sec tautochrone.14}} was

$$ \frac{2dd\varphi}{dt^2} = {{entry missing_minus}}\frac{-Pb}{Mkk}; \tag{1} $$

with the value of $Pb$ from {{sec tautochrone.16}} it becomes

$$ \frac{2dd\varphi}{dt^2} = \frac{-(a-s)\,dd\varphi{{entry lost_d}}\sin\varphi}
    {(a-s)^2dd\varphi - (a-s)\,ds\,d\varphi + kk\,dd\varphi}, \tag{2} $$

in which $dd\varphi$ drops out, so that it is transformed into

$$ \begin{aligned} 2(a-s)^2dd\varphi - 2(a-s)\,ds\,d\varphi &+ 2kk\,dd\varphi \\
  &= -(a-s)\,dt^2\sin\varphi. \end{aligned} \tag{3} $$

By this equation the motion is determined as gravity changes it, hence the whole swinging. As $dt$ is
constant in it, let it be multiplied by $d\varphi$ and integrated. The left side is a complete
differential, since the change of $(a-s)^2$ is $-2(a-s)\,ds$; so

$$ \begin{aligned} (a-s)^2d\varphi^2 &+ kk\,d\varphi^2 \\
  &= C\,dt^2{{entry lost_C}} - dt^2\!\int(a-s)\,d\varphi\sin\varphi. \end{aligned} \tag{4} $$

Since the cheek $AMB$ is taken as given, the relation between $s$ and $\varphi$ is known, and with it the
integral on the right; let it be so taken that it vanishes with $s$, where also $\varphi = 0$. Then

$$ dt = \frac{d\varphi\sqrt{kk + (a-s)^2}}{\sqrt{C - \int(a-s)\,d\varphi\sin\varphi}}. \tag{5} $$

::: margin
$(r^2+k^2)\ddot\varphi + rr'\dot\varphi^2 = -g\,r\sin\varphi$, $g = \tfrac12$: the equation that
Lagrange's rule gives. {{eq 4}} is the conservation of energy, per unit of mass.
:::

The constant has the meaning that {{sec tautochrone.18}} gives it: at the turning point $d\varphi = 0$,
and $C$ is the height $c$ to which the centre of gravity rises. Neither in {{eq 3}} nor in {{eq 4}} is
there a trace of $P$, $Z$ and $b$: they have served to find the equation, and are not heard of again.

The middle term of {{eq 3}} comes from the shortening of the thread. The body turns about $M$, for which its
moment of inertia is $M(kk + rr)$, and with $r = a - s$ this changes by $-2M(a-s)\,ds$. Times $d\varphi$, and
for the unit of mass, that is the middle term; so {{eq 3}}, multiplied by $d\varphi$, has the whole
differential of $(kk + rr)\,d\varphi^2$ on its left.

## The program

{{eq 3}} and {{eq 4}} as functions; the cheeks are 1 for Huygens's cycloids, 2 and 3 for Euler's with one
correction and with both, and 0 for a fixed axis.

::: code tautochrone/thread.hpp motion (3) (4)
:::
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto cheeks = integer("cheeks", 1, 0, 3, "0 none, 1 cycloids, 2 Euler's with k², 3 with k⁴");
const auto phi0 =
    angle("phi0", 35_deg, closed(1e-7_deg, 89_deg), "how far the pendulum swings to either side");
const auto phi = angle("phi", within_swing(20_deg, phi0), closed(0_deg, 89_deg),
                       "angle of the free part with the vertical");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

Posture<double> place_at(Cheeks which, double ratio, double here)  // without a swing
{
  return on_cheeks<double>(which, ratio, here, here);
}

double doubled_acceleration(const Posture<double>& at, double ratio,
                            double w)  // 2ddφ/dt² by (3), w for dφ²/dt²
{
  return at.r * at.sin * (2 * at.shortening * w - 1) / (ratio * ratio + at.r * at.r);
}

TELL
{
  const double ratio = k / a;
  const auto which = static_cast<Cheeks>(int(cheeks));
  const auto at = asked_posture(which, ratio, phi0, phi);
  tell("C", a * on_cheeks<double>(which, ratio, phi0, 0).to_rise, metres, "the constant of (4)");
  tell("left", a * at.to_rise, metres, "what the integral leaves of it");
  tell("turning", 2 * std::sqrt(g) / std::sqrt(a) * std::sqrt(turning2(at, ratio)), Unit{"1/s"},
       "dφ/dt by (5), in radians a second");
  tell("acceleration", 2 * g / a * twice_acceleration(at, ratio), Unit{"1/s²"},
       "ddφ/dt² by (3), in radians");
}

/*!
At {{phi|deg0}} of a swing to {{phi0|deg0}} the body turns with {{turning|5}} radians a second, and its
turning changes by {{acceleration|5}} a second in each second.

A motion that is followed by steps of {{eq 3}} knows nothing of {{eq 4}}, and that can be used: what the
steps make of the "constant" shows how good they are. Two ways are tried on swings of 60° between
cycloids, $k = \tfrac1{10}a$, with twelve steps a swing: Runge's and Kutta's with four evaluations a step,
and the midpoint rule, which looks the same from both ends of the step.
*/

struct Moving  ///< where the body is in Euler's clock, a = 1
{
  double phi, speed;
};

constexpr double studied = 0.1;  // k/a

Moving change(const Moving& at)  // of φ and dφ/dt, by (3)
{
  const auto place = place_at(Cheeks::cycloids, studied, at.phi);
  return {at.speed, doubled_acceleration(place, studied, at.speed * at.speed) / 2};
}

Moving moved(const Moving& at, const Moving& by, double times)
{
  return {at.phi + times * by.phi, at.speed + times * by.speed};
}

Moving runge_kutta(const Moving& at, double h)
{
  const Moving one = change(at), two = change(moved(at, one, h / 2)), three = change(moved(at, two, h / 2)),
               four = change(moved(at, three, h));
  return moved(moved(moved(moved(at, one, h / 6), two, h / 3), three, h / 3), four, h / 6);
}

Moving midpoint(const Moving& at, double h)  // solved by repetition
{
  Moving middle = at;
  for(int i = 0; i < 60; ++i)
    middle = moved(at, change(middle), h / 2);
  return moved(at, change(middle), h);
}

double constant_at(const Moving& at)  // C by (4), between cycloids
{
  const double c = std::cos(at.phi), s = std::sin(at.phi);
  return at.speed * at.speed * (studied * studied + c * c) + s * s / 2;
}

constexpr int steps_a_swing = 12;

template <class Step>
std::vector<double> constants(Step step, int swings)  // C after each step over C, less one
{
  Moving at{60_deg, 0};
  const double first = constant_at(at), h = swing_time(Cheeks::cycloids, studied, 60_deg) / steps_a_swing;
  std::vector<double> all;
  for(int i = 0; i < steps_a_swing * swings; ++i)
  {
    at = step(at, h);
    all.push_back(constant_at(at) / first - 1);
  }
  return all;
}

TELL
{
  curve("constants", {"swings", "runge_kutta", "midpoint"}, [](Curve& out) {
    const auto drifting = constants(runge_kutta, 100), holding = constants(midpoint, 100);
    for(std::size_t i{0}; i < drifting.size(); ++i)
      out.put({(double(i) + 1) / steps_a_swing, drifting[i], holding[i]});
  });
}

/*!
::: figure tautochrone-17
alt: What two ways make of the constant C in a hundred swings. With the steps of Runge and Kutta it sinks
steadily. With the midpoint rule it goes up and down within a strip that does not move.

How far the constant comes to be from what it was, in hundredths of it, with only twelve steps a swing.
Runge's and Kutta's steps lose a little of it at each swing. The midpoint rule errs more within a swing, and
gets back all of it.
:::

## Speed against error

$d\varphi/dt$ at one place, by the integral and by steps of {{eq 3}} from the turning point on. As the
time is not asked for, the steps are made in $\varphi$: with $w = d\varphi^2:dt^2$ it is $dw = d\varphi\cdot
2dd\varphi/dt^2$.
*/

double stepped(Cheeks which, double ratio, double most, double to,
               int steps)  // dφ/dt, Runge's and Kutta's steps
{
  const double h = (to - most) / steps;
  double w = 0;
  for(int i = 0; i < steps; ++i)
  {
    const auto slope = [=](double part, double value) {
      return doubled_acceleration(place_at(which, ratio, most + (i + part) * h), ratio, value);
    };
    const double one = slope(0, w), two = slope(0.5, w + h / 2 * one), three = slope(0.5, w + h / 2 * two),
                 four = slope(1, w + h * three);
    w += h / 6 * (one + 2 * two + 2 * three + four);
  }
  return std::sqrt(w);
}

constexpr int tried[]{4, 16, 64, 256};

TELL
{
  if(phi >= phi0)
    return;  // at rest
  const double ratio = k / a;
  const auto which = static_cast<Cheeks>(int(cheeks));
  const Fifty exact_ratio = k.fifty() / a.fifty();
  const Fifty exactly =
      turning2(on_cheeks<Fifty>(which, exact_ratio, phi0.fifty(), phi.fifty()), exact_ratio);
  std::vector<Method> ways{{"the integral (4)", [=] {
                              return std::sqrt(turning2(on_cheeks<double>(which, ratio, phi0, phi), ratio));
                            }}};
  for(const int n : tried)
    ways.push_back({std::to_string(n) + " steps of (3)",
                    [=] { return stepped(which, ratio, phi0, phi, n); }, "steps"});
  race("turning", "dφ/dt in Euler's clock, a = 1", sqrt(exactly), ways);
}

/*!
## Checks

The judge of $dd\varphi$ is d'Alembert's principle on two weights ({{sec tautochrone.14}}), which has no
moment of inertia in it; that of $d\varphi$ follows the motion from rest, and does not know that it has
an integral.
*/

exact::Laurent<Fifty> radius_on(int which, const Fifty& ratio)
{
  return which == 0 ? exact::Laurent<Fifty>(1) : truncated(which - 1, ratio);
}

CHECK_THAT(
    "speed, acceleration and constant told are those of the motion from rest, on all four kinds of cheeks")
{
  for(const Told& now :
      told_at("", "cheeks=3 k=0.3 phi0=45 phi=40", "cheeks=2 a=1e50 k=2e49 phi0=1e-3 phi=1e-4",
              "cheeks=0 phi0=89 phi=30 k=2", "k=1e-6 a=3 phi0=80 phi=79", "phi0=89 phi=88 k=0.02 g=16"))
  {
    const Fifty A = a.fifty(), ratio = k.fifty() / A, x = phi.fifty();
    const auto r = radius_on(cheeks, ratio), height = integral(r);
    const Fifty w = turning2_by_motion(r, ratio, phi0.fifty(), x), top = height(cos(phi0.fifty()));
    const Accelerations of = accelerations(r, ratio, w, x);
    const char* const why = "the library's bound, and the angle's rounding near the end";
    CHECK(now.value("turning", Unit{"1/s"}) == within_relative(sqrt(4 * g.fifty() * w / A), 5e-14, why));
    CHECK(now.value("acceleration", Unit{"1/s²"})
          == within_relative(2 * g.fifty() * of.turning / A, 5e-14, why));
    CHECK(now.value("C", metres)
          == within_relative(A * (height(Fifty(1)) - top), 5e-14, "r dφ sin φ, summed"));
    CHECK(now.value("left", metres) == within_relative(A * (height(cos(x)) - top), 5e-14, "the same"));
    CHECK(now.exact("turning") == within_relative(sqrt(w), 1e-24, "the motion's 25 digits"));
    CHECK(now.method("turning", "the integral (4)") == within_relative(sqrt(w), 5e-14, why));
  }
}

CHECK_THAT("steps of (3) come to the same, 64 and 256 of them to the fourth power of their length")
{
  for(const Told& now : told_at("", "cheeks=3 k=0.2 phi0=40 phi=10", "cheeks=0 k=0.5 phi0=80 phi=20"))
  {
    const Fifty ratio = k.fifty() / a.fifty();
    const Fifty speed =
        sqrt(turning2_by_motion(radius_on(cheeks, ratio), ratio, phi0.fifty(), phi.fifty()));
    for(const int n : tried)
    {
      const double step = (phi0 - phi) / n;
      CHECK(now.method("turning", std::to_string(n) + " steps of (3)")
            == within_relative(speed, std::pow(step, 4) + 2e-15 * n,
                               "the fourth power of a step, and roundings"));
    }
  }
}

CHECK_THAT(
    "(3) and (4) hold for the motion, and the left side of (4) has half of (3)'s as its differential")
{
  const Fifty ratio("0.3"), kk = ratio * ratio, most("0.7"), h("1e-8");
  for(const int which : {1, 2, 3})
    for(const char* at_ : {"0.01", "0.4", "0.69"})
    {
      const Fifty x(at_), s = sin(x), c = cos(x);
      const auto radius = radius_on(which, ratio);
      const auto w = [&](const Fifty& y) { return turning2_by_motion(radius, ratio, most, y); };
      const auto store = [&](const Fifty& y) { return w(y) * (kk + pow(radius(cos(y)), 2)); };
      const Fifty r = radius(c), ds = s * derivative(radius)(c) * w(x),
                  dd = (w(x + h) - w(x - h)) / (4 * h);
      CHECK(2 * r * r * dd - 2 * r * ds + 2 * kk * dd
            == within_relative(-r * s, 1e-13, "the square of the step"));
      CHECK((store(x + h) - store(x - h)) / (2 * h) == within_relative(-r * s, 1e-13, "the same"));
      const auto height = integral(radius);
      CHECK(store(x) == within_relative(height(c) - height(cos(most)), 1e-24, "the motion's 25 digits"));
    }
}

/*!
The figure's two ways are made again in fifty digits, with the acceleration of the two weights in place
of {{eq 3}}.
*/

struct State50
{
  Fifty phi, speed;
};

State50 pushed(const State50& at, const State50& by, const Fifty& times)
{
  return {at.phi + times * by.phi, at.speed + times * by.speed};
}

State50 rate(const State50& at)
{
  const exact::Laurent<Fifty> cycloid(Fifty(1), 1);
  return {at.speed, accelerations(cycloid, Fifty("0.1"), at.speed * at.speed, at.phi).turning / 2};
}

CHECK_THAT("in the figure the constants are those of the two ways in fifty digits; one sinks, one does not")
{
  for(const Told& now : told_at(""))
  {
    const auto all = now.points("constants");
    const Fifty h = Fifty(swing_time(Cheeks::cycloids, 0.1, 60_deg)) / 12, most = exact::pi() / 3;
    State50 one{most, 0}, other{most, 0};
    const auto constant = [](const State50& at) -> Fifty {
      return at.speed * at.speed * (Fifty("0.01") + pow(cos(at.phi), 2)) + pow(sin(at.phi), 2) / 2;
    };
    const Fifty first = constant(one);
    for(std::size_t i{0}; i < 30; ++i)
    {
      const State50 k1 = rate(one), k2 = rate(pushed(one, k1, h / 2)), k3 = rate(pushed(one, k2, h / 2)),
                    k4 = rate(pushed(one, k3, h));
      const State50 sum{k1.phi + 2 * k2.phi + 2 * k3.phi + k4.phi,
                        k1.speed + 2 * k2.speed + 2 * k3.speed + k4.speed};
      one = pushed(one, sum, h / 6);
      State50 middle = other;
      for(int n = 0; n < 60; ++n)
        middle = pushed(other, rate(middle), h / 2);
      other = pushed(other, rate(middle), h);
      CHECK(all[i].value("swings") == within_ulps(Fifty(int(i) + 1) / 12, 1, "a quotient"));
      CHECK(all[i].value("runge_kutta")
            == within(constant(one) / first - 1, 1e-13, "some hundred roundings"));
      CHECK(all[i].value("midpoint") == within(constant(other) / first - 1, 1e-13, "the same"));
    }
    const double lost = all[11].at("runge_kutta");  // in the first swing
    CHECK(all.back().value("runge_kutta")
          == between(110 * lost, 70 * lost, "in a hundred about as much each"));
    CHECK(all.back().value("swings") == within(100, 1e-12, "a hundred swings"));
    for(std::size_t from{0}; from < all.size(); from += 120)  // the strip, anew in every ten swings
    {
      double lowest = 1, highest_ = -1;
      for(std::size_t i{from}; i < from + 120; ++i)
      {
        lowest = std::min(lowest, all[i].at("midpoint"));
        highest_ = std::max(highest_, all[i].at("midpoint"));
      }
      CHECK(lowest == between(0, 5e-4, "it does not drift"));
      CHECK(highest_ == within(0.00805, 5e-5, "nor does its other side"));
    }
  }
}

/*!
Our copy has no minus in {{eq 1}}. In {{sec tautochrone.14}} and in all that follows the minus is there,
so that it may have been lost by the printer as well as by our copy. In {{eq 2}} it has $d^2d\varphi$ for
$2dd\varphi$, and $d\varphi$ for three of the four $dd\varphi$ on the right; in {{eq 4}} it has
$(dt^2-dt^2)\int$ for $C\,dt^2 - dt^2\!\int$. The readings are tried between cycloids, $a = 1$, $k =
\tfrac1{10}$, at 10° of a swing of 20°.
*/

Posture<double> worked()
{
  return on_cycloids<double>(20_deg, 10_deg);
}

double by_moment(int sign)  // (1)
{
  return sign * force(worked(), 0.1) * cycloidal_GZ<double>(0.1, 20_deg, 10_deg) / 0.01;
}

double right_side(bool second)  // (2); the copy's has first differentials for the second ones
{
  const auto at = worked();
  const double w = turning2(at, 0.1), dd = twice_acceleration(at, 0.1) / 2, ds = at.shortening * at.sin * w;
  const double has = second ? dd : std::sqrt(w);
  return -at.r * has * at.sin / (at.r * at.r * has - at.r * ds + 0.01 * dd);
}

bool is_doubled(double turning)
{
  const Fifty ten = exact::pi() / 18, K("0.1");
  return turning
         == within_relative(
             accelerations(truncated(0, K), K, turning2_by_motion(K, 2 * ten, ten), ten).turning, 2e-14,
             "the library's bound, and a few roundings");
}

const Doubtful missing_minus{"§17, the equation of the rotation",
                             {"2ddφ/dt² = Pb/Mkk", [] { return by_moment(1); }},
                             {"2ddφ/dt² = −Pb/Mkk", [] { return by_moment(-1); }},
                             "§14 has the minus, and so have the lines that follow; the motion is retarded",
                             is_doubled};

const Emendation lost_d{"§17, the equation with the value of Pb",
                        {"dφ for ddφ", [] { return right_side(false); }},
                        {"ddφ", [] { return right_side(true); }},
                        "§16 has ddφ, and the motion wants it",
                        is_doubled};

const Emendation lost_C{"§17, the integral",
                        {"(dt² − dt²)∫", 0},
                        {"C dt² − dt²∫", [] { return worked().to_rise; }},
                        "the next line has C, and the body moves",
                        [](double right) {
                          const Fifty ten = exact::pi() / 18, K("0.1");
                          const Fifty store =
                              turning2_by_motion(K, 2 * ten, ten) * (K * K + pow(cos(ten), 2));
                          return right == within_relative(store, 4e-15, "two sines");
                        }};

CHECK_THAT("a k beyond its limits is refused, a swing beyond the end of Euler's cheeks, and an angle "
           "beyond the swing, and just within they are not")
{
  for(const char* const within_them : ratio_within)
    CHECK(!refused_at(within_them));
  for(const char* const beyond : ratio_beyond)
    CHECK(refused_at(beyond));
  for(const char* const within_them : posture_within)
    CHECK(!refused_at(within_them));
  for(const char* const beyond : posture_beyond)
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
For a heavy point between cycloids, $k = 0$ and $a = 1$, integrate {{eq 5}}. How fast does the thread turn in
the lowest place?

answer: With $u = \sin\varphi$ it is $dt = \sqrt2\,du : \sqrt{u_0^2 - u^2}$, so that
$\sin\varphi = \sin\varphi_0\cos\dfrac t{\sqrt2}$ from rest: what swings like a cosine is not the angle but
its sine. In the lowest place $d\varphi : dt$ is $\sin\varphi_0 : \sqrt2$ of Euler's clock; `--k 1e-9 --phi 0`
tells 1.796 radians a second.
:::
*/

CHECK_THAT("a very small body turns in the lowest place by sin φ₀ : √2 of Euler's clock, and its sine is a "
           "cosine of "
           "the time")
{
  for(const Told& now : told_at("k=1e-9 phi=0", "k=1e-8 phi=0 phi0=80 a=2"))
    CHECK(now.value("turning", Unit{"1/s"})
          == within_relative(sin(phi0.fifty()) * sqrt(2 * g.fifty() / a.fifty()), 1e-14,
                             "kk is 10⁻¹⁶ aa or less"));
  for(const Told& now : told_at("k=1e-9 phi=0"))
    CHECK(now.value("turning", Unit{"1/s"}) == within(1.796, 0.0005, "four digits"));
  const Fifty start("1.2");
  const std::vector<Fifty> times{Fifty("0.5"), Fifty("1.9"), Fifty("4.3")};
  const auto places = places_by_motion(truncated(0, 0), 0, start, times);
  for(std::size_t i{0}; i < times.size(); ++i)
    CHECK(sin(places[i].phi)
          == within(sin(start) * cos(times[i] / sqrt(Fifty(2))), 1e-15, "the motion's bound"));
}
