#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/asked.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/member.hpp"
#include "tautochrone/series.hpp"

SECTION(tautochrone, 32, "The curve by points")

using namespace tautochrone;

/*!
## What Euler does

The integrals of {{sec tautochrone.31}} can all be had in finite terms, and with them any point of the
tautochrone. The letter $l$ stands for the natural logarithm.

$$ \begin{aligned} \int\!d\varphi\cos\varphi &= \sin\varphi, \\
  \int\!d\varphi\sin\varphi\cos\varphi &= \tfrac12\sin^2\varphi, \\
  \int\!d\varphi\cos^2\varphi &= \tfrac12\varphi + \tfrac12\sin\varphi\cos\varphi, \end{aligned} \tag{1} $$

$$ \int\!\frac{d\varphi}{\cos^3\varphi} = \frac{\sin\varphi}{2\cos^2\varphi} +
  \tfrac12\,l{{entry lost_l}}\tan(45^\circ + \tfrac12\varphi), \tag{2} $$

$$ \int\!\frac{d\varphi\sin\varphi}{\cos^3\varphi} = \frac1{2\cos^2\varphi}, \qquad
   \int\!\frac{d\varphi}{\cos^2\varphi} = \frac{\sin\varphi}{\cos\varphi}, \tag{3} $$

$$ \begin{aligned} \int\!\frac{d\varphi\sin^2\varphi}{\cos^7\varphi{{entry seventh_in_z}}} =
  \frac{\sin\varphi}{6\cos^6\varphi} &- \frac{\sin\varphi}{24\cos^4\varphi} -
  \frac{\sin\varphi}{16\cos^2\varphi} \\
  &- \tfrac1{16}{{entry sixteenth}}\,l\tan(45^\circ + \tfrac12\varphi), \end{aligned} \tag{4} $$

$$ \int\!\frac{d\varphi\sin^3\varphi}{\cos^7\varphi{{entry seventh_in_x}}} =
  \frac1{6\cos^6\varphi} - \frac1{4\cos^4\varphi}, \tag{5} $$

$$ \int\!\frac{d\varphi\sin^2\varphi}{\cos^6\varphi} = \frac{\sin\varphi}{5\cos^5\varphi} -
  \frac{\sin\varphi}{15\cos^3\varphi} - \frac{2\sin\varphi}{15\cos\varphi}. \tag{6} $$

With these values the arc is

$$ \begin{aligned} z = a\sin\varphi &+ \frac{kk}a\sin\varphi - \frac{kk\sin\varphi}{2a\cos^2\varphi} \\
  &- \frac{kk}{2a{{entry half}}}\,l\tan(45^\circ+\tfrac12\varphi) \\
  &- \frac{k^4{{entry fourth}}\sin\varphi}{a^3\cos^6\varphi} + \frac{k^4\sin\varphi}{4a^3\cos^4\varphi}
  \\ &+ \frac{3k^4\sin\varphi}{8a^3\cos^2\varphi} \\
  &+ \frac{3{{entry three}}k^4}{8a^3}\,l\tan(45^\circ+\tfrac12\varphi), \end{aligned} \tag{7} $$

and the two coordinates are

$$ \begin{aligned} x = \tfrac12a\sin^2\varphi &+ \frac{kk}{2a}\sin^2\varphi + \frac{kk}{2a} -
  \frac{kk}{2a\cos^2\varphi} \\
  &- \frac{k^4}{2a^3} - \frac{k^4}{a^3\cos^6\varphi{{entry powers_in_x}}} +
  \frac{3k^4}{2a^3\cos^4\varphi}, \end{aligned} \tag{8} $$

$$ \begin{aligned} y = \tfrac12a\varphi &+ \tfrac12a\sin\varphi\cos\varphi +
  \frac{kk}{2a}\varphi + \frac{kk}{2a}\sin\varphi\cos\varphi \\
  &- \frac{kk\sin\varphi}{a\cos\varphi} - \frac{6k^4\sin\varphi}{5a^3\cos^5\varphi} \\
  &+ \frac{2k^4\sin\varphi}{5a^3\cos^3\varphi{{entry powers_in_y}}} +
  \frac{4k^4\sin\varphi}{5a^3\cos\varphi}. \end{aligned} \tag{9} $$

So for any angle $\varphi$ the coordinates $x$ and $y$ of the tautochrone can be assigned, and the curve $CG$
that was sought can be constructed by points.

::: margin
$l\tan(45^\circ+\tfrac12\varphi)$ is today's inverse Gudermannian function,
$\operatorname{arsinh}\tan\varphi$.
:::

The constants in {{eq 8}} have been so chosen that $x$ vanishes in $C$, where $\varphi$ does; for the others
no constant is needed. The left-over constants of {{eq 3}} and {{eq 5}} are not written: from $\varphi = 0$
they would be $-\tfrac12$ and $\tfrac1{12}$.

## The program

{{eq 8}} takes a number of the order of $\varphi^4$ as the difference of two that are near $kk:2a$, and
then one of the order of $\varphi^4$ from three of the order of $k^4:a^3$. With $t = \tan^2\varphi$ these
constants go out, and {{eq 8}} becomes

$$ x = \tfrac12a\sin^2\varphi - \frac{kk}{2a}\,t\sin^2\varphi - \frac{k^4}{2a^3}\,t^2(3+2t). \tag{A} $$

In the same way nothing is lost from the others:

::: code tautochrone/euler.hpp curve (7) (8) (9)
:::
*/

double x_as_it_stands(double a, double k, double phi)  // (8)
{
  const double s = std::sin(phi), cc = std::pow(std::cos(phi), 2), kk = k * k, k4 = kk * kk, a3 = a * a * a;
  return a * s * s / 2 + kk * s * s / (2 * a) + kk / (2 * a) - kk / (2 * a * cc) - k4 / (2 * a3)
         - k4 / (a3 * cc * cc * cc) + 3 * k4 / (2 * a3 * cc * cc);
}

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.3, metres, scale, "radius of gyration");
const auto phi = angle("phi", 15_deg, closed(0_deg, 80_deg), "angle GMS, the amplitude of the place");

TELL
{
  const double ratio = k / a;
  require(ratio >= 1e-10, "k", "from 1e-10 a to a");
  const double last = asked_end(ratio, phi);
  tell("r", double(euler_r<Fifty>(a.fifty(), k.fifty(), phi.fifty())), metres,
       "GM, the radius of curvature");
  tell("z", euler_z<double>(a, k, phi), metres, "CG, the arc, (7)");
  tell("x", euler_x<double>(a, k, phi), metres, "CQ, the height above the lowest place, (8)");
  tell("y", euler_y<double>(a, k, phi), metres, "QG, the distance from the vertical, (9)");
  tell("end", last, degrees, "where r has come down to zero: the curve has ended");
  if(ratio >= 0.02 && ratio < 0.99 && phi <= end(Member::highest, ratio).phi)
    tell("x_exact", a * at(Member::highest, ratio, phi).x, metres,
         "the height of the highest exact curve at this angle");
  auto& rows = table("points", "The curve by points, in metres, as far as it goes",
                     {{"phi", "φ", degrees, 3},
                      {"r", "r", metres, 8},
                      {"x", "x", metres, 8},
                      {"y", "y", metres, 8},
                      {"x_off", "x less the cycloid's", metres, 4},
                      {"y_off", "y less the cycloid's", metres, 4}});
  for(int i = 5; i <= 75 && i * 1_deg < last; i += 5)
  {
    const double here = i * 1_deg;
    const auto off = [&](auto of) { return off_huygens(of, a.fifty(), k.fifty(), Fifty(here)); };
    rows.row({here, euler_r<double>(a, k, here), euler_x<double>(a, k, here), euler_y<double>(a, k, here),
              off(euler_x<Fifty>), off(euler_y<Fifty>)});
  }
}

TELL
{
  curve("curves", {"y", "x", "kind"}, [](Curve& out) {
    const double ratio = 0.3, last[]{55_deg, 89_deg, end_of_truncated(2, ratio)};
    for(int i = 0; i <= 60; ++i)
      out.put({std::sin(last[0] * i / 60), 2 * std::pow(std::sin(last[0] * i / 120), 2), 0});
    for(const int kind : {1, 2})
    {
      out.block();
      for(int i = 0; i <= 60; ++i)
      {
        const double small = kind == 1 ? 0 : ratio, here = last[kind] * i / 60;
        out.put({euler_y<double>(1, small, here), euler_x<double>(1, small, here), double(kind)});
      }
    }
    out.block();
    std::vector<double> angles;
    for(int i = 1; i <= 60; ++i)
      angles.push_back(end(Member::highest, ratio).phi * i / 60.001);
    for(const Drawn& place_ : tautochrone::drawn(Member::highest, ratio, angles))
      out.put({place_.y, place_.at.x, 3});
  });
}

/*!
For a body with $k = \tfrac3{10}a$ the place at {{phi|deg0}} is {{x|8}} m above the lowest and {{y|8}} m
beside it; on the exact curve it would be {{x_exact|8}} m above. The curve can be drawn up to
{{end|deg1}}:

{{table points}}

::: figure tautochrone-32
alt: The upper parts of four curves that began together in the lowest place. The circle rises most
gently, the cycloid next. Euler's curve leaves the cycloid upwards and ends first; the exact one rises
most steeply and ends higher.

The upper parts of the circle about $A$, the cycloid, Euler's curve and the highest exact tautochrone,
for $k = \tfrac3{10}a$. Euler's goes less than half of the way from the cycloid to the exact one where it
ends, its radius of curvature having come down to zero.
:::

## Checks

The judge of the curve is the sum of $r\,d\varphi$, $r\,d\varphi\sin\varphi$ and $r\,d\varphi\cos\varphi$
in fifty digits, $r$ coming from the recursion of {{sec tautochrone.28}}.
*/

Fifty summed(const Fifty& ratio, const Fifty& to, int sines, int cosines)
{
  const auto r = truncated(2, ratio);
  if(to == 0)
    return 0;
  return exact::integrate(
             [&](const Fifty& x) { return r(cos(x)) * pow(sin(x), sines) * pow(cos(x), cosines); }, 0, to)
      .value;
}

Fifty sizes(const Fifty& ratio, const Fifty& to)  // of the terms of r at that angle
{
  const Fifty kk = ratio * ratio, c = cos(to);
  return 1 + kk / pow(c, 3) + 6 * kk * kk / pow(c, 7);
}

CHECK_THAT("radius, arc and both coordinates told are sums of r dφ, for any a, k and φ; the end is where "
           "the polynomial is zero")
{
  for(const Told& now : told_at("", "a=2 k=0.6 phi=15", "k=0.02 phi=75", "a=1e50 k=2e49 phi=1e-5",
                                "k=1e-9 phi=60", "k=1 phi=10"))
  {
    const Fifty A = a.fifty(), ratio = k.fifty() / A, to = phi.fifty();
    const double allowed = double(A * to * sizes(ratio, to)) * 1.5e-14;
    const char* const why = "the library's bound, of the sum of the terms' sizes";
    const auto r = truncated(2, ratio);
    CHECK(now.value("r", metres) == within_ulps(A * r(cos(to)), 1, "a rounding"));
    CHECK(now.value("z", metres) == within(A * summed(ratio, to, 0, 0), allowed, why));
    CHECK(now.value("x", metres) == within(A * summed(ratio, to, 1, 0), allowed * double(sin(to)), why));
    CHECK(now.value("y", metres) == within(A * summed(ratio, to, 0, 1), allowed, why));
    Fifty lo = 0, hi = exact::pi() / 2;
    for(int i = 0; i < 100; ++i)
      (r(cos((lo + hi) / 2)) > 0 ? lo : hi) = (lo + hi) / 2;
    CHECK(now.value("end", degrees) == within_ulps(lo, 5, "the library's four, and k/a"));
    for(const auto& row : now.rows("points"))
    {
      const Fifty here = row.at("phi", degrees), s = sin(here), c = cos(here);
      const double of_terms = double(A * sizes(ratio, here)) * 1.5e-14;
      const Fifty x = A * summed(ratio, here, 1, 0), y = A * summed(ratio, here, 0, 1);
      CHECK(row.value("r", metres) == within(A * r(c), of_terms, why));
      CHECK(row.value("x", metres) == within(x, of_terms, why));
      CHECK(row.value("y", metres) == within(y, of_terms, why));
      const Fifty x_off = x - A * s * s / 2, y_off = y - A * (here + s * c) / 2;
      const double digits = double(A) * 1e-27;
      CHECK(row.value("x_off", metres)
            == within(x_off, 1e-14 * std::abs(double(x_off)) + digits, "a quadrature's digits"));
      CHECK(row.value("y_off", metres)
            == within(y_off, 1e-14 * std::abs(double(y_off)) + digits, "a quadrature's digits"));
    }
  }
}

CHECK_THAT("the exact height told is that of equal times, 2ax = (aa + kk) rr sin²φ : (kk + rr), r coming "
           "from the slope")
{
  for(const Told& now : told_at("", "a=2e30 k=1e30 phi=20", "k=0.05 phi=70"))
  {
    const Fifty ratio = k.fifty() / a.fifty(), kk = ratio * ratio, r = highest(ratio, phi.fifty());
    CHECK(now.value("x_exact", metres)
          == within_relative(a.fifty() * (1 + kk) / 2 * pow(r * sin(phi.fifty()), 2) / (kk + r * r), 3e-14,
                             "the library's bound"));
  }
}

/*!
Euler's formulae themselves, every term as it is given above, are compared with quadratures, and {{eq A}}
with {{eq 8}}.
*/

Fifty l_tan(const Fifty& phi_)
{
  return log(tan(exact::pi() / 4 + phi_ / 2));
}

Fifty over(const Fifty& to, int sines, int cosines)  // ∫ dφ sinᵐφ : cosⁿφ
{
  return exact::integrate([=](const Fifty& x) { return pow(sin(x), sines) * pow(cos(x), -cosines); }, 0, to)
      .value;
}

CHECK_THAT("the integrals (1) to (6) are right, (3) and (5) up to the constants that are not written")
{
  for(const char* to_ : {"0.2", "1.1"})
  {
    const Fifty to(to_), s = sin(to), c = cos(to), c2 = c * c, c4 = c2 * c2, c6 = c4 * c2, l = l_tan(to);
    const char* const why = "a quadrature";
    CHECK(s == within_relative(over(to, 0, -1), 1e-38, why));
    CHECK(s * s / 2 == within_relative(over(to, 1, -1), 1e-38, why));
    CHECK((to + s * c) / 2 == within_relative(over(to, 0, -2), 1e-38, why));
    CHECK(s / (2 * c2) + l / 2 == within_relative(over(to, 0, 3), 1e-37, why));
    CHECK(1 / (2 * c2) - Fifty(1) / 2 == within_relative(over(to, 1, 3), 1e-37, why));
    CHECK(s / c == within_relative(over(to, 0, 2), 1e-37, why));
    CHECK(s / (6 * c6) - s / (24 * c4) - s / (16 * c2) - l / 16
          == within_relative(over(to, 2, 7), 1e-36, why));
    CHECK(1 / (6 * c6) - 1 / (4 * c4) + Fifty(1) / 12 == within_relative(over(to, 3, 7), 1e-36, why));
    CHECK(s / (5 * c4 * c) - s / (15 * c2 * c) - 2 * s / (15 * c)
          == within_relative(over(to, 2, 6), 1e-36, why));
  }
}

/*!
{{eq 7}}, {{eq 8}} and {{eq 9}} are written with what our copy has in each place, or with what is right.
The readings are tried at $a = 2$, $k = \tfrac6{10}$, $\varphi = \tfrac12$, one at a time.
*/

struct Terms  ///< what stands in the places in question
{
  Fifty half = 2;           ///< z: kk l under it, times a
  Fifty fourth = 1;         ///< z: what the first three terms with k⁴ are multiplied by
  int sign = -1;            ///< z: of the first of them
  Fifty three = 3;          ///< z: eighths in the last term
  int in_x[3]{6, 4, 3};     ///< x: powers of the cosine in its last terms, of a in the first of these
  int in_y[4]{5, 3, 1, 3};  ///< y: the same in its last three, of a in all of them
};

struct Sums
{
  Fifty z, x, y;
  Sums(const Fifty& A, const Fifty& K, const Fifty& to, const Terms& has)
  {
    const Fifty s = sin(to), c = cos(to), kk = K * K, k4 = kk * kk, a3 = A * A * A, l = l_tan(to);
    const auto below = [&](int n) { return pow(c, n); };
    z = A * s + kk / A * s - kk * s / (2 * A * below(2)) - kk / (has.half * A) * l
        + has.sign * has.fourth * k4 * s / (a3 * below(6)) + has.fourth * k4 * s / (4 * a3 * below(4))
        + has.fourth * 3 * k4 * s / (8 * a3 * below(2)) + has.three * k4 / (8 * a3) * l;
    x = A * s * s / 2 + kk * s * s / (2 * A) + kk / (2 * A) - kk / (2 * A * below(2)) - k4 / (2 * a3)
        - k4 / (pow(A, has.in_x[2]) * below(has.in_x[0])) + 3 * k4 / (2 * a3 * below(has.in_x[1]));
    const Fifty an = pow(A, has.in_y[3]);
    y = A * to / 2 + A * s * c / 2 + kk * to / (2 * A) + kk * s * c / (2 * A) - kk * s / (A * c)
        - 6 * k4 * s / (5 * an * below(has.in_y[0])) + 2 * k4 * s / (5 * an * below(has.in_y[1]))
        + 4 * k4 * s / (5 * an * below(has.in_y[2]));
  }
};

CHECK_THAT("(7), (8) and (9), as they stand here, are the sums of r dφ; (8) is (A), and in double loses "
           "what (A) keeps")
{
  for(const char* to_ : {"0.3", "1.2"})
  {
    const Fifty A = 2, K("0.6"), to(to_), ratio = K / A, t = pow(tan(to), 2), s = sin(to);
    const Sums has(A, K, to, {});
    const char* const why = "a quadrature";
    CHECK(has.z == within_relative(A * summed(ratio, to, 0, 0), 1e-36, why));
    CHECK(has.x == within_relative(A * summed(ratio, to, 1, 0), 1e-36, why));
    CHECK(has.y == within_relative(A * summed(ratio, to, 0, 1), 1e-36, why));
    CHECK(has.x
          == within_relative(A / 2 * s * s - K * K / (2 * A) * t * s * s
                                 - pow(K, 4) / (2 * pow(A, 3)) * t * t * (3 + 2 * t),
                             1e-45, "the same fraction"));
  }
  const Fifty small("1e-6");
  const Fifty x = Sums(1, Fifty("0.3"), small, {}).x;
  CHECK(std::abs(double(x_as_it_stands(1, 0.3, 1e-6) / x - 1))
        == between(1e-7, 1, "seven digits are lost, at least"));
  CHECK(euler_x<double>(1, 0.3, 1e-6) == within_relative(x, 1e-15, "and none by (A)"));
}

CHECK_THAT("in the figure each curve has the coordinates of its kind, sums of r dφ sin φ and r dφ cos φ")
{
  for(const Told& now : told_at(""))
  {
    const auto all = now.points("curves");
    for(std::size_t i{5}; i < all.size(); i += 19)
    {
      const int kind = int(all[i].at("kind"));
      const double part = double(i % 61) / 60;
      CHECK(all[i].value("kind") == within(kind, 0, "a number"));
      const Fifty ratio("0.3"), one(1);
      if(kind < 3)
      {
        const Fifty last = kind == 0   ? 55 * exact::pi() / 180
                           : kind == 1 ? 89 * exact::pi() / 180
                                       : Fifty(end_of_truncated(2, 0.3));
        const Fifty to = last * part, used = kind == 2 ? ratio : Fifty(0);
        CHECK(all[i].value("x")
              == within(kind == 0 ? one - cos(to) : summed(used, to, 1, 0), 1e-13, "the terms' sizes"));
        CHECK(all[i].value("y")
              == within(kind == 0 ? sin(to) : summed(used, to, 0, 1), 1e-13, "the terms' sizes"));
        continue;
      }
      const double to = end(Member::highest, 0.3).phi * (double(i - 183) + 1) / 60.001;
      std::vector<Fifty> angles;
      for(int j = 1; j <= 64; ++j)
        angles.push_back(Fifty(to) * j / 64);
      const auto radii = highest(Fifty(0.3), angles);
      Fifty x = 0, y = 1;  // Simpson's rule from φ = 0, where r sin φ is 0 and r cos φ is 1
      for(std::size_t j{0}; j < 64; ++j)
      {
        const int weight = j == 63 ? 1 : j % 2 == 0 ? 4 : 2;
        x += weight * radii[j] * sin(angles[j]);
        y += weight * radii[j] * cos(angles[j]);
      }
      CHECK(all[i].value("x") == within(x * to / 192, 1e-7, "the fourth power of a strip"));
      CHECK(all[i].value("y") == within(y * to / 192, 1e-7, "the fourth power of a strip"));
    }
    const auto height = [&](std::size_t from, double y) {  // of the curve whose points begin there
      std::size_t i = from;
      while(all[i + 1].at("y") < y)
        ++i;
      const double part = (y - all[i].at("y")) / (all[i + 1].at("y") - all[i].at("y"));
      return all[i].at("x") + part * (all[i + 1].at("x") - all[i].at("x"));
    };
    const double y = all[182].at("y"), cycloid = height(61, y);
    CHECK((all[182].at("x") - cycloid) / (height(183, y) - cycloid)
          == between(0.4, 0.45, "less than half of the way"));
  }
}

/*!
Our copy is much damaged here. The sign $l$ is nowhere; powers of the cosine and of $a$ are mixed up;
where a line begins with a minus it is lost.
*/

double z_with(const Terms& has)
{
  return double(Sums(2, Fifty("0.6"), Fifty("0.5"), has).z);
}
double x_with(const Terms& has)
{
  return double(Sums(2, Fifty("0.6"), Fifty("0.5"), has).x);
}
double y_with(const Terms& has)
{
  return double(Sums(2, Fifty("0.6"), Fifty("0.5"), has).y);
}

std::function<bool(double)> is_sum(int sines, int cosines)
{
  return [=](double reading) {
    return reading
           == within_ulps(2 * summed(Fifty("0.3"), Fifty("0.5"), sines, cosines), 1,
                          "rounded once; a quadrature");
  };
}

std::function<bool(double)> is_integral(int sines, int cosines)
{
  return [=](double reading) {
    return reading == within_ulps(over(Fifty("0.5"), sines, cosines), 1, "rounded once; a quadrature");
  };
}

double third_power(bool logarithm)  // (2) at ½
{
  const Fifty x("0.5"), c = cos(x);
  return double(sin(x) / (2 * c * c) + (logarithm ? l_tan(x) : tan(exact::pi() / 4 - x / 2)) / 2);
}

double seventh_power(int part)  // (4) at ½, the last term a `part`th
{
  const Fifty x("0.5"), s = sin(x), cc = pow(cos(x), 2);
  return double(s / (6 * cc * cc * cc) - s / (24 * cc * cc) - s / (16 * cc) - l_tan(x) / part);
}

const Emendation lost_l{"§32, the integral of 1/cos³φ",
                        {"½ tang (45° − ½φ)", [] { return third_power(false); }},
                        {"½ l tang (45° + ½φ)", [] { return third_power(true); }},
                        "the logarithm is the integral's; here and in the other places l has been lost",
                        is_integral(0, 3)};

const Emendation seventh_in_z{
    "§32, the integral with sin²φ, its denominator",
    {"cos²φ", [] { return double(over(Fifty("0.5"), 2, 2)); }},
    {"cos⁷φ", [] { return double(over(Fifty("0.5"), 2, 7)); }},
    "§31 asks for it, and the value given is its integral",
    [](double reading) { return reading == within_ulps(seventh_power(16), 2, "both rounded"); }};

const Emendation sixteenth{"§32, the same integral, its last term",
                           {"1/18", [] { return seventh_power(18); }},
                           {"1/16", [] { return seventh_power(16); }},
                           "quadrature; and the 3/8 of z is six sixteenths",
                           is_integral(2, 7)};

const Emendation seventh_in_x{
    "§32, the integral with sin³φ, its denominator",
    {"cos²φ", [] { return double(over(Fifty("0.5"), 3, 2)); }},
    {"cos⁷φ", [] { return double(over(Fifty("0.5"), 3, 7)); }},
    "§31 asks for it, and the value given is its integral",
    [](double reading) {
      const Fifty cc = pow(cos(Fifty("0.5")), 2);
      return reading
             == within_ulps(1 / (6 * cc * cc * cc) - 1 / (4 * cc * cc) + Fifty(1) / 12, 1, "rounded once");
    }};

const Emendation half{"§32, z, the first logarithm",
                      {"kk/a", [] { return z_with({.half = 1}); }},
                      {"kk/2a", [] { return z_with({}); }},
                      "it is the integral of r dφ",
                      is_sum(0, 0)};

const Emendation fourth{
    "§32, z, three terms with k⁴",
    {"kk⁴, the first without a sign", [] { return z_with({.fourth = Fifty("0.6"), .sign = 1}); }},
    {"k⁴, the first with a minus", [] { return z_with({}); }},
    "it is the integral of r dφ; all terms must be lengths",
    is_sum(0, 0)};

const Emendation three{"§32, z, the last logarithm",
                       {"2kk⁴/8a³", [] { return z_with({.three = Fifty("1.2")}); }},
                       {"3k⁴/8a³", [] { return z_with({}); }},
                       "it is the integral of r dφ",
                       is_sum(0, 0)};

const Emendation powers_in_x{"§32, x, the last two terms",
                             {"aa cos⁵φ, a³ cos⁶φ",
                              [] {
                                return x_with({.in_x = {5, 6, 2}});
                              }},
                             {"a³ cos⁶φ, a³ cos⁴φ", [] { return x_with({}); }},
                             "it is the integral of r dφ sin φ",
                             is_sum(1, 0)};

const Emendation powers_in_y{"§32, y, the last three terms",
                             {"aa, and cos⁵φ in all of them",
                              [] {
                                return y_with({.in_y = {5, 5, 5, 2}});
                              }},
                             {"a³, and cos⁵φ, cos³φ, cos φ", [] { return y_with({}); }},
                             "it is the integral of r dφ cos φ",
                             is_sum(0, 1)};

/*!
## Go on from here

::: exercise
For which body does Euler's curve end just at 60°?

answer: With $\cos\varphi = \tfrac12$ the radius of {{sec tautochrone.30}} is
$\tfrac12 - \tfrac{15}2\kappa - 576\kappa^2$ in parts of $a$, $\kappa = kk:aa$. It is zero for
$\kappa = 0.02366$, $k = 0.1538\,a$: `--k 0.15382815` ends at 60°.
:::
*/

CHECK_THAT(
    "Euler's curve for k = 0.15382815 a ends at 60°, that for k = a before 17.5°; beyond, it is refused")
{
  const double kappa = (std::sqrt(7.5 * 7.5 + 4 * 576 * 0.5) - 7.5) / (2 * 576);
  for(const Told& now : told_at("k=0.15382815"))
  {
    CHECK(double(k) == within_relative(std::sqrt(kappa), 1e-6, "six digits of k and more"));
    CHECK(now.value("end", degrees) == within_relative(60_deg, 1e-6, "as many of the end"));
  }
  for(const char* const within_them : {"k=1 phi=17.49", "k=0.153828149399070924 phi=59.9999999999",
                                       "a=2 k=0.307656298798141847 phi=59.9999999999"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"k=1 phi=17.5", "k=0.153828149399070924 phi=60.0000000001",
                                  "a=2 k=0.307656298798141847 phi=60.0000000001"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("a k less than 1e-10 a is refused, and one greater than a")
{
  for(const char* const within_them : {"k=1e-10", "k=1", "a=2 k=2e-10", "a=2 k=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"k=9.99999999999999e-11", "k=1.0000000000000003", "a=2 k=1.9999e-10", "a=2 k=2.0001"})
    CHECK(refused_at(beyond));
}
