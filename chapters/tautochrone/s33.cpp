#include "edition/scene.hpp"
#include "edition/section.hpp"
#include "edition/series.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/scene.hpp"
#include "tautochrone/scene_judge.hpp"
#include "tautochrone/series.hpp"

SECTION(tautochrone, 33, "The cheek: its arc, and how it is bent")

using namespace tautochrone;

/*!
## What Euler does

For a pendulum one needs not the curve that it describes but the cheek that makes it do so, which is that
curve's evolute. To find this directrix $AMB$, let any arc of it be $AM = s$, the abscissa $AP = p$, and
the ordinate $PM = q$. Then

$$ s = a - r, \qquad dp = ds\cos\varphi, \qquad dq = ds\sin\varphi, \tag{1} $$

because the thread, of the length $a$, lies on the cheek with its part $s$ and touches it with the rest.
::: margin
$ds/d\varphi$ is the cheek's own radius of curvature. It is zero in $A$: the two cheeks meet there in a
cusp.
:::

From what was found before,

$$ \begin{aligned} s = a &- a\cos\varphi - \frac{kk\cos\varphi}a + \frac{kk}{a\cos^3\varphi} \\
  &- \frac{6k^4}{a^3{{entry cube_of_a}}\cos^5\varphi} + \frac{6k^4}{a^3\cos^7\varphi},
  \end{aligned} \tag{2} $$

$$ \begin{aligned} ds = a\,d\varphi\sin\varphi &+ \frac{kk\,d\varphi\sin\varphi}a +
  \frac{3kk\,d\varphi\sin\varphi}{a\cos^4\varphi}
  \\ &- \frac{30k^4d\varphi\sin\varphi}{a^3\cos^6\varphi} +
  \frac{42k^4d\varphi\sin\varphi}{a^3\cos^8\varphi}, \end{aligned} \tag{3} $$

$$ \begin{aligned} dp = a\,d\varphi\sin\varphi\cos\varphi
 &+ \frac{kk\,d\varphi\sin\varphi\cos\varphi}a \\
 &+ \frac{3kk\,d\varphi\sin\varphi}{a\cos^3\varphi} - \frac{30k^4d\varphi\sin\varphi}{a^3\cos^5\varphi}
 \\ &+ \frac{42k^4d\varphi\sin\varphi}{a^3\cos^7\varphi}, \end{aligned} \tag{4} $$

$$ \begin{aligned} dq = a\,d\varphi\sin^2\varphi &+ \frac{kk\,d\varphi\sin^2\varphi}a -
  \frac{3kk\,d\varphi}{a\cos^2\varphi} \\ &+
  \frac{3kk\,d\varphi}{a\cos^4\varphi} + \frac{30k^4d\varphi}{a^3\cos^4\varphi} \\ &-
  \frac{72k^4d\varphi}{a^3\cos^6\varphi} +
 \frac{42k^4d\varphi}{a^3\cos^8\varphi}. \end{aligned} \tag{5} $$

## The program

As they stand, {{eq 2}} and {{eq 5}} lose their digits at small angles, where terms of the size of $a$
must leave a number of the size of $a\varphi^2$. With $t = \tan^2\varphi$ all that is left of them is
positive:

::: code tautochrone/euler.hpp cheek (2) (3)
:::
*/

double dp_over_dphi(double a, double k, double phi)  // (4)
{
  return euler_ds<double>(a, k, phi) * std::cos(phi);
}

double dq_over_dphi(double a, double k, double phi)  // (5)
{
  return euler_ds<double>(a, k, phi) * std::sin(phi);
}

double first_end(double ratio)  // of Euler's cheek and the exact one, in radians
{
  return std::min(largest_amplitude(Cheeks::euler_k4, ratio), end(Member::highest, ratio).phi);
}

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto phi = angle("phi", 15_deg, closed(0_deg, 85_deg),
                       "angle of the thread with the vertical, where it leaves the cheek");

TELL
{
  asked_end(k / a, phi);
  tell("s", euler_s<double>(a, k, phi), metres, "AM, the arc on which the thread lies");
  tell("ds", euler_ds<double>(a, k, phi), metres, "ds/dφ, the cheek's radius of curvature");
  tell("dp", dp_over_dphi(a, k, phi), metres, "dp/dφ");
  tell("dq", dq_over_dphi(a, k, phi), metres, "dq/dφ");
  tell("cycloid", euler_s<double>(a, 0, phi), metres, "the arc on Huygens's cheek");
}

const std::vector<std::pair<double, double>>& exact_bends()  // at angles up to the end, for k = a/10
{
  static const auto all = [] {  // no parameter is in them: all tellings of the section have the same
    const Fifty small("0.1"), last = double(highest_end(small).phi);
    std::vector<Fifty> angles;
    for(int i = 1; i <= 70; ++i)
      angles.push_back(last * Fifty(i) / 70);
    const std::vector<Fifty> radii = highest(small, angles);  // on one way down
    std::vector<std::pair<double, double>> bends;
    for(std::size_t i{0}; i < angles.size(); ++i)
      bends.emplace_back(double(angles[i]), -double(slope(angles[i], radii[i], small)));
    return bends;
  }();
  return all;
}

TELL
{
  curve("bends", {"phi", "cycloid", "kk", "k4"}, [](Curve& out) {
    for(int i = 0; i <= 65; ++i)
    {
      const double here = i * 1_deg, c = std::cos(here);
      out.put({double(i), std::sin(here), std::sin(here) * (1 + 0.01 * (1 + 3 / (c * c * c * c))),
               euler_ds<double>(1, 0.1, here)});
    }
  });
  curve("exact", {"phi", "ds"}, [](Curve& out) {
    for(const auto& [angle_, bend] : exact_bends())
      out.put({angle_ / 1_deg, bend});
  });
}

/*!
At {{phi|deg0}} the thread lies on the cheek with {{s|8}} m; on Huygens's it would with {{cycloid|8}} m.

::: figure tautochrone-33
alt: The cheek's radius of curvature against the angle. The cycloid's is the sine. Euler's with one and
with two corrections leave it upwards, the second steeply from 45 degrees. The exact one rises to a peak
above 50 degrees and falls to zero at 71 degrees.

How the cheek is bent, $k = \tfrac1{10}a$: its radius of curvature. Euler's cheek gets flatter as far as it
goes. That which belongs to the highest exact tautochrone is flattest between 50° and 60°, and ends at 71° in
a second cusp, where $ds = 0$.
:::

What the cheeks are for, a scene shows, with a body large enough that they differ to the eye. Three equal
bodies hang from one point, $k = K a$, and are let go together where the thread is inclined by $\varphi_0$:
one between Huygens's cheeks, one between Euler's, one between those of the highest exact tautochrone.
*/

const auto g = real("g", 4.903325, metres, scale, "height fallen in the first second, half of today's g");
const auto K = real("K", 0.3, none, closed(0.02, 0.9), "k/a of the three bodies of the scene");
const auto phi0 = angle(
    "phi0",
    at_most(40_deg, "nine tenths of where the first of the cheeks ends", [] { return 0.9 * first_end(K); }),
    closed(1_deg, 80_deg), "angle at which they are let go");

constexpr int of_a_swing = 60, last = 6 * of_a_swing;  // frames

struct Way  ///< one of the three
{
  const char* name;
  const char* colour;
  std::vector<Hung> (*frames)();
};

constexpr Way ways[]{
    {"huygens", "green", [] { return hung_between(Cheeks::cycloids, K, phi0, of_a_swing, last); }},
    {"euler", "vermilion", [] { return hung_between(Cheeks::euler_k4, K, phi0, of_a_swing, last); }},
    {"exact", "blue", [] { return hung_on_highest(K, phi0, of_a_swing, last); }}};

Body cheek(const std::vector<Hung>& frames,
           const char* colour)  // the two, as far as the thread lies on them
{
  int first = 0;  // of the frames, on the other side
  while(frames.at(std::size_t(first)).phi > 0)
    ++first;
  std::vector<Spot> joints;
  for(int i = -first; i <= first; ++i)
  {
    const Hung& now = frames[std::size_t(first - std::abs(i))];
    const double x = i == 0 ? 0 : i < 0 ? -now.M_x : now.M_x, y = i == 0 ? 0 : now.M_y;
    joints.push_back({x, y});
  }
  return drawn::rod(joints, colour);
}

TELL
{
  require(phi0 < 0.99 * first_end(K), "phi0",
          "less than 99 hundredths of the angle at which the first of the cheeks ends");
  tell("wound_huygens", euler_s<double>(1, 0, phi0), "AM : a on Huygens's cheek, where they are let go");
  tell("wound_euler", euler_s<double>(1, K, phi0), "the same on Euler's");
  tell("wound_exact", at(Member::highest, K, phi0).s, "the same on the exact one");
  const double T = small_swing(K), unit = clock_in_seconds(a, g);
  std::vector<std::vector<Hung>> frames_of;
  std::vector<Body> bodies;
  std::vector<std::string> columns{"t"};
  for(const Way& way : ways)
  {
    frames_of.push_back(way.frames());
    bodies.push_back(cheek(frames_of.back(), way.colour));
  }
  for(const Way& way : ways)
  {
    const std::string name = way.name;
    const Spot M{name + "_M_x", name + "_M_y"}, G{name + "_G_x", name + "_G_y"};
    bodies.push_back(drawn::rod({M, G}, way.colour));
    bodies.push_back(drawn::bob(G, 0.03, way.colour));
    columns.insert(columns.end(),
                   {name + "_phi", name + "_M_x", name + "_M_y", name + "_G_x", name + "_G_y"});
  }
  scene("wound", bodies, columns, [&](Curve& out) {
    for(std::size_t i = 0; i <= std::size_t{last}; ++i)
    {
      std::vector<double> row{unit * T * double(i) / of_a_swing};
      for(const auto& frames : frames_of)
        row.insert(row.end(), {frames[i].phi, frames[i].M_x, frames[i].M_y, frames[i].G_x, frames[i].G_y});
      out.put(row);
    }
  });
}

/*!
::: scene wound
alt: From one point hang three pairs of short cheeks that differ little, like nested beaks. Three threads lie
on the right ones and go down, straight, to three bobs close to each other.

Six swings in true time: blue between the exact cheeks, green between Huygens's, vermilion between Euler's.
Each cheek is drawn as far as its thread comes to lie on it. Let go at {{phi0|deg0}}, with $K = {{K}}$, on
Huygens's cheek lie {{wound_huygens|3}} of the thread, on Euler's {{wound_euler|3}}, on the exact one
{{wound_exact|3}}. That the free part becomes shorter makes up for the time that the turning of the body
costs in a wide swing. At 10° Euler's cheek takes up less than the exact one, at 40° more.
:::

## Checks
*/

CHECK_THAT("(2) is a − r; (3), (4) and (5) are its differentials, term by term in fractions")
{
  const Powers sin2 = 1 - cosine(2);
  for(const Rational& kk : {Rational(1, 100), Rational(4, 25)})
  {
    const auto r_n = corrections<Rational>(2);
    const Powers s = 1 - cosine(1) - kk * cosine(1) + kk * cosine(-3) - 6 * kk * kk * cosine(-5)
                     + 6 * kk * kk * cosine(-7);
    CHECK(s == 1 - r_n[0] - kk * r_n[1] - kk * kk * r_n[2]);
    const Powers bent = 1 + kk + 3 * kk * cosine(-4) - 30 * kk * kk * cosine(-6)
                        + 42 * kk * kk * cosine(-8);  // ds/sin φ dφ
    CHECK(slope_times_sine(s) == sin2 * bent);
    CHECK(cosine(1) * bent
          == cosine(1) + kk * cosine(1) + 3 * kk * cosine(-3) - 30 * kk * kk * cosine(-5)
                 + 42 * kk * kk * cosine(-7));
    CHECK(sin2 * bent
          == sin2 + kk * sin2 - 3 * kk * cosine(-2) + 3 * kk * cosine(-4) + 30 * kk * kk * cosine(-4)
                 - 72 * kk * kk * cosine(-6) + 42 * kk * kk * cosine(-8));
  }
}

/*!
What is told is compared with {{eq 2}} to {{eq 5}} as they stand, in fifty digits.
*/

CHECK_THAT("arc and bend told are those of (2) to (5), for any a, k and φ, also where (2) loses all but a "
           "few digits")
{
  for(const Told& now :
      told_at("", "a=2 k=0.7 phi=40", "a=3e60 k=3e58 phi=1e-8", "a=1e-40 k=1e-60 phi=60", "phi=1e-14"))
  {
    const Fifty A = a.fifty(), kk = pow(k.fifty() / A, 2), k4 = kk * kk, c = cos(phi.fifty()),
                s = sin(phi.fifty());
    const Fifty arc = 1 - c - kk * c + kk / pow(c, 3) - 6 * k4 / pow(c, 5) + 6 * k4 / pow(c, 7);
    const Fifty bend = s * (1 + kk + 3 * kk / pow(c, 4) - 30 * k4 / pow(c, 6) + 42 * k4 / pow(c, 8));
    const char* const why = "the library's bound, and the angle's rounding";
    CHECK(now.value("s", metres) == within_relative(A * arc, 2e-14, why));
    CHECK(now.value("ds", metres) == within_relative(A * bend, 2e-14, why));
    CHECK(now.value("dp", metres) == within_relative(A * bend * c, 2e-14, why));
    CHECK(now.value("dq", metres) == within_relative(A * bend * s, 2e-14, why));
    CHECK(now.value("cycloid", metres)
          == within_relative(A * 2 * pow(sin(phi.fifty() / 2), 2), 1e-15, "a square"));
  }
}

CHECK_THAT("in the figure the exact cheek's bend is the slope of the exact radius, by differences, and "
           "ends in zero")
{
  const Fifty ratio("0.1"), h("1e-7");
  for(const Told& now : told_at(""))
  {
    const auto all = now.points("exact");
    for(const std::size_t i : {std::size_t(10), std::size_t(40), std::size_t(60)})
    {
      const Fifty here = Fifty(all[i].at("phi")) * exact::pi() / 180;
      const Fifty slope_ = (highest(ratio, here + h) - highest(ratio, here - h)) / (2 * h);
      CHECK(all[i].value("ds") == within_relative(-slope_, 1e-10, "the square of the step"));
    }
    std::size_t flattest{0};
    for(std::size_t i{0}; i < all.size(); ++i)
      flattest = all[i].at("ds") > all[flattest].at("ds") ? i : flattest;
    CHECK(all[flattest].at("phi") == between(50, 60, "where the exact cheek is flattest"));
    CHECK(all.back().value("ds") == within(0, 1e-13, "the end, whose angle is rounded"));
    CHECK(all.back().value("phi")
          == within(atan(Fifty("0.9") / sqrt(ratio)) * 180 / exact::pi(), 1e-13, "the same"));
    double before = -1;
    for(const auto& point : now.points("bends"))
    {
      CHECK(point.at("k4") > before);  // ever flatter
      before = point.at("k4");
      const Fifty x = Fifty(point.at("phi")) * exact::pi() / 180, c = cos(x), e4 = pow(c, -4),
                  kk = ratio * ratio;
      CHECK(point.value("cycloid") == within(sin(x), 2e-16, "a sine"));
      CHECK(point.value("kk") == within_relative(sin(x) * (1 + kk + 3 * kk * e4), 4e-15, "a fourth power"));
      CHECK(point.value("k4")
            == within_relative(
                sin(x) * (1 + kk + 3 * kk * e4 - 30 * kk * kk * e4 / (c * c) + 42 * kk * kk * e4 * e4),
                2e-14, "the library's bound"));
    }
  }
}

CHECK_THAT(
    "in the scene Huygens's body and Euler's move as their equation of motion says, on threads of the "
    "length a")
{
  for(const Told& now : told_at("", "K=0.1 phi0=60 a=2", "K=0.6 g=1", "K=0.9"))
  {
    const Fifty unit = sqrt(a.fifty() / g.fifty()) / 2, ratio = K.fifty(), start = phi0.fifty();
    const auto frames = now.points("wound", 7);
    CHECK(now.value("wound_huygens") == within_relative(1 - cos(start), 2e-15, "a square"));
    CHECK(now.value("wound_euler")
          == within_relative(1 - truncated(2, ratio)(cos(start)), 2e-14, "the bound"));
    for(const std::string name : {"huygens", "euler"})
    {
      const Cheeks cheeks = name == "euler" ? Cheeks::euler_k4 : Cheeks::cycloids;
      const auto places = places_between(frames, cheeks, ratio, start, unit);
      for(std::size_t i{0}; i < frames.size(); ++i)
      {
        const On_curve& at = places[i];
        const double slack = 1e-13 * (1 + double(ratio));
        const char* const why = "six swings, and the clock's bound at each";
        const auto is = [&](const char* column, const Fifty& right) {
          CHECK(frames[i].value((name + column).c_str()) == within(right, slack, why));
        };
        is("_phi", at.phi);
        is("_M_x", at.y - at.r * sin(at.phi));
        is("_M_y", at.x - 1 + at.r * cos(at.phi));
        is("_G_x", at.y);
        is("_G_y", at.x - 1);
      }
    }
  }
}

CHECK_THAT("the third body is on the exact curve where the cosine of the time has it, and its cheek is the "
           "evolute")
{
  for(const Told& now : told_at("", "K=0.1 phi0=60 a=2", "K=0.6 g=1", "K=0.9"))
  {
    const Fifty T = exact::pi() * sqrt((1 + pow(K.fifty(), 2)) * a.fifty() / (2 * g.fifty()));
    CHECK(now.value("wound_exact")
          == within_relative(1 - highest(K.fifty(), phi0.fifty()), 1e-13, "the library's bound"));
    const auto frames = now.points("wound", 23);
    const auto places = on_highest(frames, K.fifty(), phi0.fifty(), T);
    for(std::size_t i{0}; i < frames.size(); ++i)
    {
      const auto& frame = frames[i];
      const On_curve& right = places[i];
      const char* const why = "the curve's error below 1e-13, and that the time is rounded";
      CHECK(frame.value("t") == between(0, 6.0001 * T, "six swings"));
      CHECK(frame.value("exact_phi") == within(right.phi, 1e-12, why));
      CHECK(frame.value("exact_G_x") == within(right.y, 1e-12, why));
      CHECK(frame.value("exact_G_y") == within(right.x - 1, 1e-12, why));
      CHECK(frame.value("exact_M_x") == within(right.y - right.r * sin(right.phi), 1e-12, why));
      CHECK(frame.value("exact_M_y") == within(right.x - 1 + right.r * cos(right.phi), 1e-12, why));
    }
  }
}

CHECK_THAT(
    "it refuses a place beyond the end of Euler's curve, a k greater than a, and bodies let go where, but "
    "for a hundredth, one of the cheeks has ended: Euler's for small K, the exact one for great K")
{
  // Euler's r is zero at 60° for 1152κκ + 15κ = 1; the exact cheek ends at 30° for 3(1 − K)² = K
  for(const std::string body : {"k=0.153828149399070924", "a=2 k=0.307656298798141847"})
  {
    CHECK(!refused_at(body + " phi=59.9999999999"));
    CHECK(refused_at(body + " phi=60.0000000001"));
  }
  CHECK(!refused_at("K=0.153828149399070924 phi0=59.3999999999"));
  CHECK(refused_at("K=0.153828149399070924 phi0=59.4000000001"));
  CHECK(!refused_at("K=0.565741454089335118 phi0=29.6999999999"));
  CHECK(refused_at("K=0.565741454089335118 phi0=29.7000000001"));
  for(const char* const within_them : {"k=1", "a=2 k=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"k=1.0000000000000003", "a=2 k=2.0001"})
    CHECK(refused_at(beyond));
}

CHECK_THAT(
    "Euler's cheek takes up more of the thread than Huygens's, at 10° less than the exact one, at 40° more")
{
  for(const Told& now : told_at("", "phi0=10"))
  {
    const double more = phi0 > 0.5 ? 1 : -1;
    const Fifty c = cos(phi0.fifty()), euler = 1 - truncated(2, K.fifty())(c),
                exact_ = 1 - highest(K.fifty(), phi0.fifty());
    CHECK(now.value("wound_euler") == between(1 - c, 1, "his corrections are positive"));
    CHECK((euler - exact_) * more > Fifty("1e-6"));
  }
}

/*!
Our copy has $aa$ for $a^3$ under every $k^4$. Then the terms are no lengths; and a cheek so cut would not
have the arc $a - r$.
*/

double arc_with(int power_of_a)  // (2) at a = 2, k = ½, cos φ = ½
{
  const double c = 0.5, kk = 0.25, below = std::pow(2, power_of_a);
  return 2 - 2 * c - kk * c / 2 + kk / (2 * c * c * c)
         + 6 * kk * kk / below * (std::pow(c, -7) - std::pow(c, -5));
}

const Emendation cube_of_a{"§33, the terms with k⁴",
                           {"k⁴ over aa", arc_with(2)},
                           {"k⁴ over a³", arc_with(3)},
                           "s is a − r, with r of §30",
                           [](double arc) {
                             const Fifty r = 2 * truncated(2, Fifty(1) / 4)(Fifty(1) / 2);
                             return arc == within_ulps(2 - r, 4, "a few roundings");
                           }};

/*!
## Go on from here

::: exercise
How is the cheek bent near the cusp? Compare Euler's with the exact one, whose radius of curvature
{{eq tautochrone.25 4}} makes begin as $\dfrac{1+\kappa}{1-3\kappa}\,a\varphi$, $\kappa = kk:aa$.

answer: {{eq 3}} begins with $(1 + 4\kappa + 12\kappa^2)\,a\varphi$: the exact factor developed as far as
$\kappa^2$. For $k = \tfrac3{10}a$, at `--k 0.3 --phi 1e-4`, Euler's is 1.457, where the exact one is 1.493.
:::

::: exercise
How much of the thread lies on the cheek when Euler's curve ends?

answer: All of it, $s = a$, since $r = a - s$ has come down to zero; the exact cheek ends sooner, at a second
cusp, with some thread still free.
:::
*/

CHECK_THAT("near the cusp Euler's cheek bends as 1 + 4κ + 12κ², the exact one as (1 + κ) : (1 − 3κ)")
{
  for(const Told& now : told_at("k=0.3 phi=1e-4", "k=0.1 phi=1e-5"))
  {
    const Fifty kappa = pow(k.fifty(), 2), x = phi.fifty();
    CHECK(now.value("ds", metres)
          == within_relative(x * (1 + 4 * kappa + 12 * kappa * kappa), 1e-9, "the square of the angle"));
    CHECK(
        -slope<Fifty>(Fifty("1e-4"), highest(k.fifty(), Fifty("1e-4")), k.fifty())
        == within_relative(Fifty("1e-4") * (1 + kappa) / (1 - 3 * kappa), 1e-6, "the square of the angle"));
  }
}

CHECK_THAT(
    "at the end of Euler's curve all of the thread lies on the cheek; at the exact one's end some is free")
{
  for(const char* const at : {"k=0.3 phi=47.828941585", "k=0.1 phi=65.912593386"})
    for(const Told& now : told_at(at))
    {
      CHECK(now.value("s", metres) == within(1, 1e-7, "ten digits of the angle, where s grows fast"));
      CHECK(highest_end(k.fifty()).r == between(double(k), 1, "of the length 1"));
    }
}
