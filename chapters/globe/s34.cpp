#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "exact/quadrature.hpp"
#include "exact/rational.hpp"
#include "globe/asked.hpp"
#include "globe/clock.hpp"
#include "globe/oracle.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"
#include "swing/oracle.hpp"

SECTION(globe, 34, "A theorem on three oscillations of one body")

using namespace globe;

/*!
## What Euler does

Hung up by the centre of its base, rocking on a smooth plane, or rocking on a rough one, a body oscillates
like simple pendulums whose lengths are its moments of inertia about three points, each divided by the same
product. With this theorem Euler ends the paper.

The body is one of those of {{sec globe.32}}. Its base is circular or spherical; $C$ is the centre of the
base, $R$ the point by which it touches the plane at rest, $G$ its centre of gravity, and $P$ its mass or
weight. It can be made to oscillate in three ways. It may swing freely, as a pendulum, about a horizontal axis
through $C$. Laid with $R$ on a plane polished so well that it feels no friction at all, it may rock by very
little. And it may do so on a plane as rough as one likes. Then the lengths of the simple pendulums that keep
time with it are

$$ \begin{aligned}
   l_{\mathrm I} &= \frac{\text{moment of inertia about } C}{P\cdot CG},\\
   l_{\mathrm{II}} &= \frac{\text{moment of inertia about } G}{P\cdot CG},\\
   l_{\mathrm{III}} &= \frac{\text{moment of inertia about } R}{P\cdot CG}. \end{aligned} \tag{1} $$

The first is known from the motion of pendulums. With $CG{{entry centres}} = c$, $CR = a$ and $Pkk$ for the
moment about $G$ it is the first of

$$ \begin{gathered} l_{\mathrm I} = \frac{cc+kk}c, \qquad l_{\mathrm{II}} = \frac{kk}c, \\
   l_{\mathrm{III}} = \frac{(a-c)^2+kk}c; \end{gathered} \tag{2} $$

the second and the third have been found above ({{sec globe.15}}, {{sec globe.30}}).

::: margin
Today: $C$, $G$ and $R$ are the *instantaneous centres* about which the body turns as it passes through its
place of rest.
:::

The theorem is right, and one picture holds the three cases together. In each of them the centre of gravity
has the depth $c\cos\Phi$ below $C$, so that gravity does the same work. And in each the body turns, at
every moment, about a point of its own: always about $C$ when it hangs; about the point at the height of $G$
that is plumb over the contact when there is no friction, since $G$ can only rise and sink; about the contact
when it rolls. With $M_\Phi$ for the moment of inertia about that point, over the weight,

$$ \begin{gathered} M_\Phi\,\frac{d\Phi^2}{dt^2} = 8gc\,(h - \sin^2\tfrac12\Phi), \\
   \begin{aligned} M_\Phi &= cc+kk &&\text{hung up,}\\ M_\Phi &= kk + cc\sin^2\Phi &&\text{smooth,}\\
   M_\Phi &= bb + 4ac\sin^2\tfrac12\Phi &&\text{rolling,} \end{aligned} \end{gathered} \tag{A} $$

where $bb = (a-c)^2 + kk$, and $h = \sin^2\frac12\Phi$ at the amplitude. For very small amplitudes only $M_0$
counts, and that is the theorem.

For others it fails. A swing of the amplitude that belongs to $h$ is longer than a very small one, and by
different parts in the three motions,

$$ \begin{gathered} \frac T{T_0} = 1 + mh + \ldots, \\
   m = \tfrac14, \quad m = \tfrac14 + \frac{cc}{kk}, \\ m = \tfrac14 + \frac{ac}{bb},
   \end{gathered} \tag{B} $$

so that rocking on a plane is not even as isochronous as a pendulum. With amplitudes near 180° the theorem
comes back in another form: each swing grows with the logarithm of what is wanting, and these growths are as
the roots of the moments about the three centres in the *highest* place,

$$ \sqrt{cc+kk} \;:\; k \;:\; \sqrt{(a+c)^2+kk}. \tag{C} $$

The differences of the lengths are free of $k$,

$$ l_{\mathrm I} - l_{\mathrm{II}} = c, \qquad l_{\mathrm{III}} - l_{\mathrm I} = \frac{a(a-2c)}c. \tag{D} $$

The free swing is therefore always slower than the smooth rocking, and it is faster than rolling as long as
$G$ is nearer to $C$ than to $R$.

## The program

The lengths are formed without any large square.
*/

template <class Real>
struct Three
{
  Real hung, smooth, rough;
};

template <class Real>
Three<Real> lengths(const Ball<Real>& body)  // (2)
{
  const Real about_G = body.k / body.c * body.k;
  return {about_G + body.c, about_G, about_G + body.gap / body.c * body.gap};
}

/*!
The swings of any amplitude are {{eq A}} integrated: the pendulum's by the arithmetic and geometric mean, on
the smooth plane by the mean of equal steps ({{sec globe.13}}), rolling by Carlson's integrals
({{sec globe.28}}). What they exceed the small ones by is reckoned by itself, or nothing would be left of it
for small amplitudes.
*/

Three<double> quarters(const Ball<double>& body, const Energy<double>& e)  // (A), in τ
{
  return {std::hypot(body.c, body.k) * pendulum_quarter(e), smooth::quarter(body.c, body.k, e),
          rolling::quarter(body, e)};
}

Three<double> excesses(const Ball<double>& body, const Energy<double>& e)  // (B), all of it
{
  return {pendulum_excess(e), smooth::excess(body.c, body.k, e), rolling::excess(body, e)};
}

const auto a = real("a", 1, feet, scale, "CR, radius of the base");
const auto c = real("c", 0.1, feet, scale, "CG, from its centre to the centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto Phi = angle("Phi", 60_deg, open(0_deg, 180_deg), "amplitude, to either side");
const auto psi =
    angle("psi", 0_deg, from_below(0_deg, 180_deg), "what it lacks of 180° instead, where not 0");
const auto h = real("h", 0, none, from_below(0, 1), "sin² of half the amplitude instead, where not 0");

Energy<Fifty> energy_asked()
{
  if(h != 0)
    return energy(h.fifty());
  return psi != 0 ? energy_of_amplitude_from_top(psi.fifty()) : energy_of_amplitude(Phi.fifty());
}

TELL
{
  const Ball<double> body = rounded_ball(a, c, k);
  require(c <= 100 * k, "c", "at most a hundred times k");
  require(k <= 1e40 * c, "c", "at least 1e-40 of k");
  const Energy<double> e = rounded(energy_asked());
  require(e.h >= 1e-300, h != 0 ? "h" : "Phi", "at least 1e-300 in sin²½Φ");
  require(e.from_top >= 1e-200, "psi", "at least 2e-100 rad");
  const double second = std::sqrt(2 * g) * std::sqrt(c);  // what one second is in τ
  const auto l = lengths(body);
  const auto quarter = quarters(body, e), more = excesses(body, e);
  const double small = std::numbers::pi / second;
  tell("l_1", l.hung, feet, "length of the pendulum that keeps time with the body hung up, (2)");
  tell("l_2", l.smooth, feet, "rocking on a smooth plane");
  tell("l_3", l.rough, feet, "rolling to and fro");
  tell("small_1", small * std::hypot(c, k), seconds, "a very small single swing, hung up");
  tell("small_2", small * k, seconds, "on a smooth plane");
  tell("small_3", small * std::hypot(body.gap, k), seconds, "rolling");
  tell("swing_1", 2 * quarter.hung / second, seconds, "a swing of the amplitude asked for, hung up");
  tell("swing_2", 2 * quarter.smooth / second, seconds, "on a smooth plane");
  tell("swing_3", 2 * quarter.rough / second, seconds, "rolling");
  tell("excess_1", more.hung, percent, "by how much it is longer than the small one, hung up");
  tell("excess_2", more.smooth, percent, "on a smooth plane");
  tell("excess_3", more.rough, percent, "rolling");
}

/*!
What the theorem leaves of itself at larger amplitudes:
*/

TELL
{
  const Ball<double> body = rounded_ball(a, c, k);
  auto& swings = table("swings", "Swings over very small ones",
                       {{"Phi", "amplitude", degrees, 3},
                        {"hung", "hung up", none, 8},
                        {"smooth", "smooth plane", none, 8},
                        {"rough", "rolling", none, 8}});
  for(const double amplitude : {1_deg, 10_deg, 30_deg, 60_deg, 90_deg, 120_deg, 150_deg, 179_deg})
  {
    const auto more = excesses(body, energy_of_amplitude(amplitude));
    swings.row({amplitude, 1 + more.hung, 1 + more.smooth, 1 + more.rough});
  }
}

TELL
{
  curve("ratios", {"Phi_deg", "hung", "smooth", "rough"}, [](Curve& ratios) {
    for(int n = 1; n <= 170; ++n)
    {
      const auto more = excesses(rounded_ball(a, c, k), energy_of_amplitude(n * 1_deg));
      ratios.put({static_cast<double>(n), 1 + more.hung, 1 + more.smooth, 1 + more.rough});
    }
  });
}

/*!
For our ball the three pendulums are {{l_1|5}}, {{l_2|5}} and {{l_3|5}} feet long. Let go at 60°, it takes
{{swing_1|6}} seconds when hung up, {{swing_2|6}} on ice, {{swing_3|6}} when it rolls. These are longer than
the small swings by {{excess_1|4}}, {{excess_2|4}} and {{excess_3|4}}: the three motions no longer keep time
with the three pendulums.

{{table swings}}

::: figure globe-34
alt: Three curves against the amplitude, all starting from one and rising ever more steeply. The lowest is
that of the body hung up, the highest that of the body that rolls.

Swings over very small ones, against the amplitude: hung up by $C$ (grey), on a smooth plane (green), rolling
(blue). Were the theorem true of all amplitudes the three would be one curve.
:::

## Checks

That a moment about $C$, $G$ or $R$ stands over $P\cdot CG$ is tried on our ball itself, a homogeneous ball of
weight 4/5 with a pellet of 1/5 halfway down.
*/

CHECK_THAT("the moments of ball and pellet about C, G and R, over P·CG, are the three lengths")
{
  const Rational ball(4, 5), pellet(1, 5), own(2, 5), at(1, 2), CG = pellet * at, CR(1);
  const auto moment = [&](const Rational& depth) {  // about a point so far below C
    const Rational to_pellet = at - depth;
    return ball * (own + depth * depth) + pellet * to_pellet * to_pellet;
  };
  const Three<Fifty> l = lengths(our_ball<Fifty>);
  CHECK(Fifty(moment(Rational(0)) / CG) == within_relative(l.hung, 1e-48, "fifty digits"));
  CHECK(Fifty(moment(CG) / CG) == within_relative(l.smooth, 1e-48, "fifty digits"));
  CHECK(Fifty(moment(CR) / CG) == within_relative(l.rough, 1e-48, "fifty digits"));
  for(const Told& now : told_at("a=1 c=0.1 k=0.6"))
    CHECK(now.value("l_1", feet)
          == within_relative(Fifty(moment(Rational(0)) / CG), 1e-15, "three roundings"));
}

enum class Way
{
  hung,
  smooth,
  rough
};
const std::array<Way, 3> ways{Way::hung, Way::smooth, Way::rough};

// ddΦ/dt²: of a pendulum, and by the equations of §§3, 6, 7 and 9.
Fifty acceleration(Way way, const Ball<Fifty>& body, const Fifty& g_, const Fifty& at, const Fifty& w)
{
  if(way == Way::smooth)
    return accelerations<Fifty>(body, g_, at, w, 0).Phi;
  if(way == Way::rough)
    return rolling_accelerations<Fifty>(body, g_, at, w).Phi;
  return -2 * g_ * body.c * sin(at) / (body.c * body.c + body.k * body.k);
}

// The quarter in τ, by quadrature in fifty digits, and by the arithmetic and geometric mean.
Fifty quarter_of(Way way, const Ball<Fifty>& body, const Energy<Fifty>& e)
{
  if(way == Way::smooth)
    return oracle::smooth_quarter(body.c, body.k, e);
  if(way == Way::rough)
    return oracle::rolling_quarter(body, e);
  return sqrt(body.c * body.c + body.k * body.k) * swing::oracle::K_from_complement(sqrt(e.from_top));
}

Fifty moment_at_rest(Way way, const Ball<Fifty>& body)
{
  if(way == Way::smooth)
    return body.k * body.k;
  return way == Way::rough ? bb(body) : Fifty(body.c * body.c + body.k * body.k);
}

const char* name_of(Way way, const std::array<const char*, 3>& names)
{
  return names.at(static_cast<std::size_t>(way));
}

CHECK_THAT("the lengths and the small swings are those of the theorem, and (D) holds")
{
  for(const Told& now : told_at("", "a=1 c=3 k=0.2 g=0.5", "a=1e-40 c=2e-45 k=3e-40 g=1e-60"))
  {
    const Ball<Fifty> body = exact_ball(a, c, k);
    const Fifty c_ = body.c;
    for(const Way way : ways)
    {
      const Fifty M = moment_at_rest(way, body), T = exact::pi() * sqrt(M / (2 * g.fifty() * c_));
      CHECK(now.value(name_of(way, {"l_1", "l_2", "l_3"}), feet)
            == within_relative(M / c_, 1e-15, "six roundings"));
      CHECK(now.value(name_of(way, {"small_1", "small_2", "small_3"}), seconds)
            == within_relative(T, 2e-15, "seven roundings"));
    }
    const Three<Fifty> l = lengths(body);
    CHECK(l.hung - l.smooth == within_relative(c_, 1e-35, "fifty digits less ten"));
    CHECK(l.rough - l.hung
          == within_relative(body.a * (body.a - 2 * c_) / c_, 1e-35, "fifty digits less ten"));
  }
}

CHECK_THAT(
    "a c beyond 1e-40 or a hundred times k is refused, and an amplitude too near to nothing or to the top")
{
  for(const char* const within_them :
      {"c=100 k=1", "c=200 k=2", "c=1 k=1e40", "c=2 k=2e40", "h=1e-300", "Phi=2e-150rad", "psi=2e-100rad"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"c=100.00000000000001 k=1", "c=200.00000000000003 k=2", "c=0.9999999999999999 k=1e40",
       "c=1.9999999999999998 k=2e40", "h=9.99999999999999e-301", "Phi=1.9999999999999e-150rad",
       "psi=1.9999999999999e-100rad"})
    CHECK(refused_at(beyond));
}

CHECK_THAT(
    "let go at the amplitude the body is at its lowest place after half the swing told, in each motion")
{
  for(const Told& now : told_at("", "psi=5 c=0.3", "c=0.5 k=0.5 Phi=90 g=1e50", "h=1e-20 a=1 c=2 k=0.3",
                                "c=0.9999 k=0.01 Phi=5"))
  {
    const Ball<Fifty> body = exact_ball(a, c, k);
    const Energy<Fifty> e = energy_asked();
    const Fifty second = sqrt(2 * g.fifty() * body.c), amplitude = 2 * atan2(sqrt(e.h), sqrt(e.from_top));
    for(const Way way : ways)
    {
      const Fifty time = quarter_of(way, body, e) / second;
      const auto motion = [&](const Fifty&, const exact::State& s) {
        const Fifty w = s[1] * amplitude / time;
        return exact::State{s[1], acceleration(way, body, g.fifty(), s[0] * amplitude, w) * time * time
                                      / amplitude};
      };
      CHECK(exact::solve(motion, 0, {1, 0}, 1, Fifty("1e-24")).y[0]
            == within(0, 1e-20, "steps of 1e-24, as parts of the amplitude"));
      CHECK(now.value(name_of(way, {"swing_1", "swing_2", "swing_3"}), seconds)
            == within_relative(2 * time, 3e-15, "eight ulps, a root and two quotients"));
    }
  }
}

// M over M of the lowest place, less one, by (A), where sin ½Φ is √h sin θ: over h.
Fifty growth(Way way, const Ball<Fifty>& body, const Fifty& h_, const Fifty& ss)
{
  if(way == Way::hung)
    return 0;
  if(way == Way::smooth)
    return 4 * pow(body.c / body.k, 2) * ss * (1 - h_ * ss);
  return 4 * body.a * body.c * ss / bb(body);
}

CHECK_THAT(
    "the excesses are those of (A), by quadrature without cancellation, down to the smallest amplitude")
{
  for(const Told& now : told_at("", "h=1e-20", "h=1e-290 a=1 c=2 k=0.3", "c=1e-12 Phi=1e-8 a=1e-5",
                                "Phi=1e-20rad c=50 k=0.5"))
  {
    const Ball<Fifty> body = exact_ball(a, c, k);
    const Energy<Fifty> e = energy_asked();
    for(const Way way : ways)
    {
      const auto integrand = [&](const Fifty& theta) {
        const Fifty ss = pow(sin(theta), 2), y = (growth(way, body, e.h, ss) + ss) / (1 - e.h * ss);
        return Fifty(y / (1 + sqrt(1 + e.h * y)));
      };
      const Fifty over_h = exact::integrate(integrand, 0, exact::pi() / 2).value * 2 / exact::pi();
      CHECK(now.value(name_of(way, {"excess_1", "excess_2", "excess_3"}), percent)
            == within_relative(e.h * over_h, 4e-15, "ten ulps, and four roundings of the ball"));
    }
  }
  for(const Told& now :
      told_at("psi=1e-12", "psi=1e-80rad c=0.5", "h=0.999999 k=0.05", "c=50 k=0.5 Phi=170"))
  {
    const Ball<Fifty> body = exact_ball(a, c, k);
    const Energy<Fifty> e = energy_asked();
    for(const Way way : ways)
    {
      const Fifty small = exact::pi() / 2 * sqrt(moment_at_rest(way, body));
      CHECK(now.value(name_of(way, {"excess_1", "excess_2", "excess_3"}), percent)
            == within_relative(quarter_of(way, body, e) / small - 1, 4e-15, "ten ulps"));
    }
  }
}

CHECK_THAT(
    "for small amplitudes the excesses are as the coefficients (B), the one of the pendulum the least")
{
  for(const Told& now : told_at("h=1e-18", "h=1e-200 c=3", "a=5 c=0.01 k=4 h=1e-30"))
  {
    const Fifty a_ = a.fifty(), c_ = c.fifty(), k_ = k.fifty(), quarter = Fifty(1) / 4, h_ = h.fifty();
    CHECK(now.value("excess_1", percent) == within_relative(h_ * quarter, 4e-15, "ten ulps"));
    CHECK(now.value("excess_2", percent)
          == within_relative(h_ * (quarter + c_ * c_ / (k_ * k_)), 4e-15, "ten ulps"));
    CHECK(now.value("excess_3", percent)
          == within_relative(h_ * (quarter + a_ * c_ / ((a_ - c_) * (a_ - c_) + k_ * k_)), 4e-15,
                             "ten ulps"));
  }
  for(const Told& now : told_at("", "Phi=179 c=0.01", "c=3 k=0.1 Phi=20"))
    for(const auto& row : now.rows("swings"))
    {
      CHECK(row.at("hung") < row.at("smooth"));
      CHECK(row.at("hung") < row.at("rough"));
    }
}

CHECK_THAT("near the top the swings grow as the roots (C), whatever they have come to before")
{
  for(const Ball<Fifty>& body : {our_ball<Fifty>, cradle<Fifty>, Ball<Fifty>{1, 2, Fifty(1) / 10}})
    for(const Way way : ways)
    {
      const Fifty top = way == Way::smooth  ? body.k * body.k
                        : way == Way::rough ? BB(body)
                                            : Fifty(body.c * body.c + body.k * body.k);
      const Fifty grown = quarter_of(way, body, energy_from_top(Fifty("1e-34")))
                          - quarter_of(way, body, energy_from_top(Fifty("1e-30")));
      CHECK(grown == within_relative(sqrt(top) * 2 * log(Fifty(10)), 1e-25, "of the order 1e-30 times 30"));
    }
}

CHECK_THAT("the table and the curves are swings of fifty digits over very small ones")
{
  const std::array<const char*, 3> columns{"hung", "smooth", "rough"};
  const auto compare = [&](const ToldRow& row, double amplitude) {
    const Ball<Fifty> body = exact_ball(a, c, k);
    for(const Way way : ways)
    {
      const Fifty small = exact::pi() / 2 * sqrt(moment_at_rest(way, body));
      CHECK(row.value(name_of(way, columns))
            == within_relative(quarter_of(way, body, energy_of_amplitude(Fifty(amplitude))) / small, 1e-13,
                               "ten ulps, and what an ulp of 179° makes of it"));
    }
  };
  for(const Told& now : told_at("", "c=3 k=0.1", "a=1e30 c=2e29 k=5e29"))
    for(const auto& row : now.rows("swings"))
    {
      CHECK(row.value("Phi", degrees) == between(1e-2, 3.13, "from 1° to 179°"));
      compare(row, row.at("Phi", degrees));
    }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("ratios", 6))
    {
      CHECK(point.value("Phi_deg") == between(1, 170, "what is drawn"));
      compare(point, point.at("Phi_deg") * 1_deg);
    }
}

/*!
In our copy the interval that is called $c$ in the proof runs from $G$ to $G$.
*/

const Emendation centres{
    "§34, the interval called c",
    {"GG", 0},
    {"CG", 0.1},
    "our ball, with kk = 36/100, keeps time with a pendulum of 37/10 feet when it hangs by C",
    [](double reading) {
      const double moment = reading * reading + 0.36;
      return moment == within_relative(Fifty(37) / 10 * Fifty(reading), 1e-14, "some roundings");
    }};

/*!
## Notes

In {{eq A}} the centre of the turning moves, and the moment about it changes with Φ. Only because {{eq A}} is
the equation of energy does this make no difference; an equation of moments about such a point would want a
further term ({{sec globe.05}}).

## Go on from here

::: exercise
A cradle is hung up by the centre of its rockers, then rocked on ice, then on wood. From the three times its
$c$, $k$ and $a$ are to be found, $G$ being above the floor.
answer: By the times the lengths {{eq 2}} are known. Then $c = l_{\mathrm I} - l_{\mathrm{II}}$, $kk =
c\,l_{\mathrm{II}}$ and $a = c + \sqrt{c(l_{\mathrm{III}} - l_{\mathrm{II}})}$.
:::

::: exercise
If $G$ is halfway between $C$ and $R$, the body hung up and the body that rolls keep the same time. At which
amplitudes?
answer: At very small ones only. For $a = 2c$ the coefficients {{eq B}} are $\frac14$ and
$\frac14 + 2cc:(cc+kk)$: rolling is slower at every other amplitude.
:::
*/

CHECK_THAT("from the three lengths the cradle's measures are found again")
{
  for(const Ball<Fifty>& body : {our_ball<Fifty>, cradle<Fifty>, Ball<Fifty>{3, 2, Fifty(1) / 7}})
  {
    const Three<Fifty> l = lengths(body);
    const Fifty c_ = l.hung - l.smooth;
    CHECK(c_ == within_relative(body.c, 1e-45, "fifty digits"));
    CHECK(sqrt(c_ * l.smooth) == within_relative(body.k, 1e-45, "fifty digits"));
    CHECK(c_ + sqrt(c_ * (l.rough - l.smooth)) == within_relative(body.a, 1e-45, "fifty digits"));
  }
}

CHECK_THAT(
    "with G halfway between C and R hanging and rolling agree in small swings, and in no greater ones")
{
  for(const Told& now : told_at("c=0.5 k=0.5", "a=4 c=2 k=0.1 Phi=5", "c=0.5 k=3 Phi=170"))
  {
    CHECK(now.value("small_3", seconds)
          == within_relative(
              exact::pi()
                  * sqrt(lengths(Ball<Fifty>{a.fifty(), c.fifty(), k.fifty()}).hung / (2 * g.fifty())),
              2e-15, "seven roundings"));
    for(const auto& row : now.rows("swings"))
      CHECK(row.at("rough") > row.at("hung"));
  }
}
