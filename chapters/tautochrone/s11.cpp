#include "edition/section.hpp"
#include "tautochrone/mechanism.hpp"
#include "tautochrone/thread.hpp"

SECTION(tautochrone, 11, "The weight of the thread")

using namespace tautochrone;

/*!
## What Euler does

A second difficulty comes from the thread itself: what of it lies on the cheek does not move. As long as the
part $AM$ is laid on the curve $AMB$, it takes no share in the motion; and since at each moment only that
mass counts which moves with the pendulum, this mass is variable. So is then the place of its centre of
gravity; and so is its moment of inertia about the axis through that centre, which was called $Mkk$ and
which now changes all the time. From this the centre of oscillation would change in yet another way, far
from that of {{sec tautochrone.10}}.

To be rid of this difficulty he supposes the upper, flexible part, whose mass is to be counted now greater
and now less, to be very light; and the lower part $EF$, which is the proper bulk of the pendulum, to be
very heavy. What the light part adds and takes away can then be held for nothing without error, just as the
effect of the air's resistance is neglected.

Is it without error? He has no number. Let the thread be a strip that weighs $\mu$ times as much as the
body for every length $a$; let it be flexible from $A$ as far as the length $\ell$; beyond that begins the
body's own stem, counted with it. When $s$ lies on the cheek, $u = \ell - s$ still swings. At this instant it
turns about $M$ like a rod hung by its end, so that in the equation of {{sec tautochrone.17}}, with the mass
of the body and $a$ as units,

$$ \begin{aligned} kk + rr \quad &\text{becomes} \quad I = kk + rr + \tfrac13\mu u^3, \\
   r\sin\varphi \quad &\text{becomes} \quad w\sin\varphi, \\
   &\text{where} \quad w = r + \tfrac12\mu u^2. \end{aligned}
   \tag{A} $$

::: margin
Today: a system of one degree of freedom with the energy $\tfrac12 I(\varphi)\dot\varphi^2 + gV(\varphi)$. In
Euler's clock $g = \tfrac12$.
:::

Nothing is lost where the strip comes to rest on the cheek, for at $M$ it is at rest already. On Huygens's
cheeks $r = \cos\varphi$ and $s = 1 - \cos\varphi$, and for narrow swings out to $\varphi_0$

$$ \frac{T}{T_0} - 1 = \frac{\varphi_0^2}{8}\left(\frac12 + \frac{3(1+\mu\ell)}{2w_0}
   - \frac{2 + \mu\ell^2}{I_0}\right), \tag{B} $$

$I_0$ and $w_0$ being what stands in {{eq A}} in the lowest place. For a heavy point on a light strip this
is what a body without a strip would lose whose $kk$ were

$$ kk = \mu\left(\tfrac34\ell - \tfrac78\ell^2 + \tfrac13\ell^3\right) \text{ nearly}. \tag{C} $$

## The program

The two polynomials in $h = 1 - \cos\varphi$ are all that has to be said; {{api tautochrone::Mechanism}}
averages from them by how much the swing is too long, without taking a difference of times.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0, metres, closed(0.0, 1e100), "radius of gyration of the body");
const auto mu =
    real("mu", 0.01, none, closed(0.0, 1e6), "weight of a strip of the length a, over the body's");
const auto l = real("l", 1, metres, scale, "length of the flexible strip, down from A");
const auto phi0 = angle("phi0", 5_deg, closed(1e-60_deg, 85_deg), "how far the pendulum swings");
const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");

struct Strip  ///< a body on Huygens's cheeks by a strip, in units of a
{
  Fifty k;   ///< radius of gyration
  Fifty mu;  ///< weight of the length a
  Fifty l;   ///< how long it is
};

Mechanism swinging(const Strip& on)  // (A)
{
  using Polynomial = Mechanism::Polynomial;
  const Polynomial h(Fifty(1), 1), r = Polynomial(1) - h, u = Polynomial(on.l) - h;
  return {Polynomial(on.k * on.k) + r * r + Polynomial(on.mu / 3) * u * u * u,
          r + Polynomial(on.mu / 2) * u * u};
}

Fifty law(const Strip& on, const Fifty& phi)  // (B)
{
  const Fifty I0 = on.k * on.k + 1 + on.mu * pow(on.l, 3) / 3, w0 = 1 + on.mu * on.l * on.l / 2;
  const Fifty gained = Fifty("0.5") + 3 * (1 + on.mu * on.l) / (2 * w0);
  return phi * phi / 8 * (gained - (2 + on.mu * on.l * on.l) / I0);
}

Fifty like(const Strip& on)  // (C)
{
  return on.mu * on.l * (Fifty("0.75") - on.l * (Fifty("0.875") - on.l / 3));
}

TELL
{
  require(k / a <= 1e6, "k", "at most 1e6 a");
  const double needed = 2 * std::pow(std::sin(phi0 / 2), 2);
  require(l / a > needed * (1 + 1e-12), "l",
          "longer than what is wound on the cheek, a(1 − cos phi0), by more than 1e-12 of it");
  require(l / a <= 10, "l", "at most 10 a");
  const Strip with{k.fifty() / a.fifty(), mu.fifty(), l.fifty() / a.fifty()};
  const Strip without{with.k, 0, 1};
  const Mechanism body = swinging(with);
  const double over = body.excess(phi0);
  tell("T", body.swing_time(phi0) * (std::sqrt(a) / (2 * std::sqrt(g))), seconds, "one swing");
  tell("excess", over, "T/T₀ − 1, with the strip");
  tell("late", 86'400 * over, seconds, "what the clock loses in a day");
  tell("late_without", 86'400 * swinging(without).excess(phi0), seconds,
       "the same, the strip having no weight");
  tell("law", double(law(with, phi0.fifty())), "(B), for narrow swings");
  tell("like", double(like(with)), "(C), the kk/aa of a body that would lose as much as a light strip");
  tell("wound", needed * a, metres, "s at the end of the swing, the part that lies on the cheek");
}

TELL
{
  auto& rows = table("strips", "Seconds a day late; the strip weighs a hundredth on the length a",
                     {{"phi0", "amplitude", degrees, 3},
                      {"none", "no weight", seconds, 6},
                      {"short_", "ℓ = a/5", seconds, 8},
                      {"long_", "ℓ = a", seconds, 8},
                      {"body", "ℓ = a, k = a/10", seconds, 8}});
  const Fifty hundredth = Fifty(1) / 100, tenth = Fifty(1) / 10, fifth = Fifty(1) / 5;
  for(const double phi : {5_deg, 10_deg, 20_deg})
    rows.row({phi, 86'400 * swinging({0, 0, 1}).excess(phi),
              86'400 * swinging({0, hundredth, fifth}).excess(phi),
              86'400 * swinging({0, hundredth, 1}).excess(phi),
              86'400 * swinging({tenth, hundredth, 1}).excess(phi)});
}

TELL
{
  curve("lengths", {"l", "light", "middle", "heavy", "k05"}, [](Curve& out) {
    const double body = 86'400 * swinging({Fifty("0.05"), 0, 1}).excess(5_deg);
    for(int i = 1; i <= 40; ++i)
    {
      const Fifty length = Fifty(i) / 40;
      const auto late = [&](const char* weight) {
        return 86'400 * swinging({0, Fifty(weight), length}).excess(5_deg);
      };
      out.put({i / 40.0, late("0.001"), late("0.003"), late("0.01"), body});
    }
  });
}

/*!
A heavy point would lose nothing between the cheeks. On a strip as long as the pendulum, a hundredth of its
weight, it loses at 5° {{late|4}} s in a day; by {{eq C}} that is as much as a body with
$kk = {{like|4}}\,aa$. What Euler neglects is then nearly as large as what he calculates for $k = a/20$. The
remedy is his, a light strip. A short one helps less than it might seem: by {{eq C}} a strip of the length
$\tfrac34a$ is even worse than one of the length $a$.

{{table strips}}

::: figure tautochrone-11
alt: Seconds a day late against the length of the strip. Three curves, for strips of three weights, rise
steeply from zero, are highest near three quarters of a and almost level from there on. A level line, for a
body with k a twentieth of a and a strip without weight, runs a little above the highest curve.

What the weight of the strip alone makes a heavy point late by, at 5° between Huygens's cheeks: for strips
of a thousandth, three thousandths and a hundredth of its weight on the length $a$. Grey: a body with
$k = a/20$ on a strip without weight.
:::

## Checks

That {{eq A}} is right is seen from the strip itself. Its points have the arcs $\sigma$ from $A$; those with
$\sigma > s$ are beyond $M$ by $\sigma - s$, along the tangent. Their velocities come from differences of
their places, their weight's moment from differences of all their heights, the wound part's too.
*/

Fifty depths_summed(const Fifty& l_, const Fifty& x)  // of all points of a strip below A
{
  const Fifty s = 2 * pow(sin(x / 2), 2), u = l_ - s;
  return s * s / 2 - s * s * s / 6 + u * (s - s * s / 2) + u * u / 2 * cos(x);  // p = σ − ½σσ on the cheek
}

CHECK_THAT("inertia and moment are those of the strip's points, by differences of their places")
{
  const Fifty d("1e-15"), l_("0.8");
  for(const char* const at : {"0.2", "0.7", "1.1"})
  {
    const Fifty x(at), s = 2 * pow(sin(x / 2), 2), u = l_ - s;
    const auto speed2 = [&](const Fifty& sigma) -> Fifty {  // of the point σ, for dφ/dt = 1
      const auto place = [&](const Fifty& y) {
        const auto M = cycloidal_places(y);
        const Fifty on = sigma - 2 * pow(sin(y / 2), 2);
        return std::pair<Fifty, Fifty>(M.q + on * sin(y), M.p + on * cos(y));
      };
      const auto up = place(x + d), low = place(x - d);
      return (pow(up.first - low.first, 2) + pow(up.second - low.second, 2)) / (4 * d * d);
    };
    const Fifty simpson = u / 6 * (speed2(s) + 4 * speed2(s + u / 2) + speed2(l_));
    CHECK(simpson == within(u * u * u / 3, 1e-28, "Simpson's rule is exact, the step's square is not"));
    const Fifty moment = (depths_summed(l_, x - d) - depths_summed(l_, x + d)) / (2 * d);
    CHECK(moment == within(u * u / 2 * sin(x), 1e-28, "the square of the step"));
  }
}

/*!
The judge of the times takes the two times themselves and subtracts, in fifty digits, with those heights.
*/

Fifty time_of(const Strip& on, const Fifty& phi)  // of a swing out to phi, by the midpoint rule
{
  const auto risen = [&](const Fifty& x) -> Fifty {
    return pow(sin(x), 2) / 2 + on.mu * (on.l * on.l / 2 - depths_summed(on.l, x));
  };
  const Fifty top = risen(phi);
  Fifty sum = 0;
  const int nodes = 320;
  for(int i = 0; i < nodes; ++i)
  {
    const Fifty alpha = (2 * i + 1) * exact::pi() / (4 * nodes), x = phi * sin(alpha), c = cos(x);
    const Fifty inertia = on.k * on.k + c * c + on.mu * pow(on.l - 1 + c, 3) / 3;
    sum += sqrt(inertia / (top - risen(x))) * cos(alpha);
  }
  return phi * exact::pi() / nodes * sum;
}

Fifty narrow(const Strip& on)  // T₀, of an infinitely small swing
{
  const Fifty I0 = on.k * on.k + 1 + on.mu * pow(on.l, 3) / 3, w0 = 1 + on.mu * on.l * on.l / 2;
  return exact::pi() * sqrt(2 * I0 / w0);
}

Fifty by_times(const Strip& on, const Fifty& phi)
{
  return time_of(on, phi) / narrow(on) - 1;
}

CHECK_THAT("the time and the excess told are the integral's, whatever the strip, the body and the swing")
{
  for(const Told& now : told_at("", "mu=0.3 l=0.6 k=0.2 phi0=40", "a=1e30 l=1e30 k=3e29 phi0=1 mu=1e6",
                                "a=2 l=2 k=1e-3 phi0=80 mu=1e-3", "l=8 mu=5 phi0=60"))
  {
    const Strip on{k.fifty() / a.fifty(), mu.fifty(), l.fifty() / a.fifty()};
    const Fifty over = by_times(on, phi0.fifty());
    const char* const why = "the library's bound, and the angle's rounding";
    CHECK(now.value("excess") == within_relative(over, 3e-13, why));
    CHECK(now.value("late", seconds) == within_relative(86'400 * over, 3e-13, why));
    CHECK(now.value("T", seconds)
          == within_relative(sqrt(a.fifty() / (4 * g.fifty())) * time_of(on, phi0.fifty()), 1e-14, why));
    const Fifty s = a.fifty() * (1 - cos(phi0.fifty()));
    CHECK(now.value("wound", metres) == within_relative(s, 2e-15, "a sine's square and two products"));
    if(on.k == 0)
      CHECK(now.value("late_without", seconds) == 0);
    else
      CHECK(now.value("late_without", seconds)
            == within_relative(86'400 * by_times({on.k, 0, 1}, phi0.fifty()), 3e-13, why));
  }
}

CHECK_THAT("narrow swings obey the law (B), which for a light strip is that of a body with the kk of (C)")
{
  for(const Told& now : told_at("", "phi0=1e-6 mu=0.3 l=0.6 k=0.2", "phi0=1e-50 k=3 l=2 mu=20 a=1.5",
                                "phi0=1e-30 mu=1e-12 l=0.5"))
  {
    const Strip on{k.fifty() / a.fifty(), mu.fifty(), l.fifty() / a.fifty()};
    const Fifty pp = pow(phi0.fifty(), 2), small("1e-3");
    const Fifty by_limit = by_times(on, small) / (small * small);  // of swings of a thousandth
    CHECK(now.value("law")
          == within_relative(pp * by_limit, 1e-5, "the next term of a thousandth's swing"));
    CHECK(now.value("excess")
          == within_relative(pp * by_limit, 1e-5 + 4 * double(pp), "the next terms of both"));
    const Fifty u = on.l;
    CHECK(now.value("like")
          == within_relative(on.mu * (9 * u / 12 - 7 * u * u / 8 + pow(u, 3) / 3), 1e-15, "a sum"));
    if(on.k == 0)
      CHECK(like(on) / 4 * pp
            == within_relative(law(on, phi0.fifty()), 3 * double(on.mu), "the first order"));
  }
}

CHECK_THAT("the table is the times', and a strip a fifth of a long does more than half of the harm")
{
  for(const Told& now : told_at(""))
    for(const auto& row : now.rows("strips"))
    {
      const Fifty phi = Fifty(row.at("phi0", degrees)), hundredth("0.01"), tenth("0.1"), fifth("0.2");
      const char* const why = "the library's bound, and the angle's rounding";
      CHECK(row.value("none", seconds) == 0);
      const Fifty short_one = 86'400 * by_times({0, hundredth, fifth}, phi),
                  long_one = 86'400 * by_times({0, hundredth, 1}, phi);
      CHECK(row.value("short_", seconds) == within_relative(short_one, 1e-13, why));
      CHECK(row.value("long_", seconds) == within_relative(long_one, 1e-13, why));
      CHECK(row.value("body", seconds)
            == within_relative(86'400 * by_times({tenth, hundredth, 1}, phi), 1e-13, why));
      CHECK(short_one > long_one / 2);
    }
}

CHECK_THAT(
    "the figure's curves are the times'; a hundredth on the whole length does nearly what k = a/20 does")
{
  const Fifty five = exact::pi() / 36;
  for(const Told& now : told_at(""))
  {
    for(const auto& point : now.points("lengths", 4))
    {
      const Fifty length = Fifty(point.at("l"));
      for(const auto& [name, weight] :
          {std::pair{"light", "0.001"}, {"middle", "0.003"}, {"heavy", "0.01"}})
        CHECK(point.value(name)
              == within_relative(86'400 * by_times({0, Fifty(weight), length}, five), 1e-13, "the bound"));
      CHECK(point.value("k05")
            == within_relative(86'400 * by_times({Fifty("0.05"), 0, 1}, five), 1e-13, "the bound"));
    }
    const auto last = now.points("lengths").back();
    CHECK(last.at("heavy") / last.at("k05") == between(0.8, 0.85, "nearly"));
  }
}

CHECK_THAT("by (C) three quarters of a are the worst length, and at a there is a least")
{
  const auto gains = [](const Rational& u) -> Rational {  // the derivative of (C) by the length
    return Rational(3, 4) - Rational(7, 4) * u + u * u;
  };
  CHECK(gains(Rational(3, 4)) == Rational(0));
  CHECK(gains(1) == Rational(0));
  CHECK(gains(Rational(7, 10)) > Rational(0));
  CHECK(gains(Rational(9, 10)) < Rational(0));
  CHECK(like({0, 1, Fifty("0.75")}) == within_relative(Fifty(27) / 128, 1e-48, "27/128"));
  CHECK(like({0, 1, 1}) == within_relative(Fifty(5) / 24, 1e-48, "5/24, which is less"));
}

CHECK_THAT("a strip not longer than what is wound is refused, one longer than ten times a, and a k beyond "
           "10⁶ a; within these limits none is")
{
  for(const char* const within_them : {"k=1e6", "a=2 k=2e6", "phi0=60 l=0.50000000000051",
                                       "phi0=85 a=2 l=1.8256885145069", "l=10", "a=2 l=20"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"k=1000000.0000000002", "a=2 k=2000000.0000000004", "phi0=60 l=0.50000000000049",
       "phi0=85 a=2 l=1.8256885145061", "l=10.000000000000002", "a=2 l=20.000000000000004"})
    CHECK(refused_at(beyond));
}

/*!
## Go on from here

::: exercise
How heavy may a strip of the length $a$ be, if on a heavy point that swings 5° it is to spoil no more than a
second in ten days?

answer: By {{eq B}} and {{eq C}} about $\mu = 0.0029$: `--mu 0.0029` loses a little less than a tenth of a
second a day, 0.003 a little more.
:::
*/

CHECK_THAT("a strip of 0.0029 of the bob spoils less than a tenth of a second a day, one of 0.003 more")
{
  CHECK(86'400 * by_times({0, Fifty("0.0029"), 1}, exact::pi() / 36)
        == between(0.095, 0.1, "the exercise"));
  CHECK(86'400 * by_times({0, Fifty("0.003"), 1}, exact::pi() / 36) == between(0.1, 0.105, "the exercise"));
}
