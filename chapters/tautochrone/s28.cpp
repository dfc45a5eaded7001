#include "edition/section.hpp"
#include "edition/series.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/series.hpp"

SECTION(tautochrone, 28, "The equation by powers of kk")

using namespace tautochrone;

/*!
## What Euler does

The differential equation of {{sec tautochrone.25}} is ordered by the powers of $kk$, and a series for $r$
is put into it. Freed of its fractions the equation reads

$$ \begin{aligned}
  &+ar^4{{entry first_power}}\,d\varphi + 2akkrr\,d\varphi + ak^4{{entry last_power_}}\,d\varphi \\
  &-aar^3{{entry cube}}\,d\varphi\cos\varphi - aakkr\,d\varphi\cos\varphi \\
  &- k^4r\,d\varphi\cos\varphi - kkr^3\,d\varphi\cos\varphi \\
  &- aakk\,dr\sin\varphi - k^4dr\sin\varphi = 0. \end{aligned} \tag{1} $$

::: margin
A singular perturbation: $dr$ has the small factor $kk$, so that each order is found without integrating,
and no room is left for a constant.
:::

If $kk$ vanished, nothing would be left but $ar^4 = aar^3\cos\varphi$, that is $r = a\cos\varphi$. To find
a truer value he puts

$$ r = a\cos\varphi + kkP + k^4Q + \text{etc.,} \tag{2} $$

with $P$ and $Q$ functions of $\varphi$ that are still to be found. Then

$$ dr = -a\,d\varphi\sin\varphi + kk\,dP + k^4dQ + \text{etc.,} \tag{3} $$

and, kept through $k^4$, the powers are

$$ \begin{aligned}
r^2 &= a^2\cos^2\varphi + 2akkP\cos\varphi \\
  &\quad + 2ak^4Q\cos\varphi + k^4PP, \\
r^3 &= a^3\cos^3\varphi + 3aakkP\cos^2\varphi \\
  &\quad + 3aak^4Q\cos^2\varphi + 3ak^4PP{{entry of_the_cube}}\cos\varphi, \\
r^4 &= a^4\cos^4\varphi + 4a^3kkP\cos^3\varphi \\
  &\quad + 4a^3k^4Q\cos^3\varphi + 6aak^4PP{{entry of_the_fourth}}\cos^2\varphi.
\end{aligned} \tag{4} $$

## The program

The left side of {{eq 1}}, divided by $d\varphi$:

::: code tautochrone/series.hpp equation (1)
:::

The series can be carried on as far as one likes. With {{eq 2}} put into {{eq 1}}, the power $k^{2n}$ has
the $n$-th coefficient multiplied by $a^4\cos^3\varphi$, and all else is known:
{{api tautochrone::corrections}}. How well $r$ then satisfies the equation is seen from its left side,
here divided by $a^5$.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto phi = angle("phi", 30_deg, closed(0_deg, 80_deg), "angle of the free part with the vertical");
const auto n = integer("n", 3, 0, 12, "corrections that are kept in (2)");

Fifty left_side(int kept, const Fifty& ratio, const Fifty& angle_)  // (1) over a⁵dφ, of the series
{
  const auto r = truncated(kept, ratio);
  const Fifty c = cos(angle_);
  return equation<Fifty>(1, ratio * ratio, r(c), slope_times_sine(r)(c), c);
}

TELL
{
  require(k / a >= 1e-9, "k", "from 1e-9 a to a");
  require(k / a <= 1, "k", "from 1e-9 a to a");
  const auto r = corrections<Rational>(n)[static_cast<std::size_t>(int(n))];
  tell("coefficient", double(Fifty(r[r.lowest()])),
       "of the lowest power of cos φ in the last correction, for a = 1", 17);
  tell("power", r.lowest(), "that power");
  tell("last", std::pow(k / a, 2 * n) * double(r(cos(phi.fifty()))), "the last correction, over a");
  tell("left", double(left_side(n, k.fifty() / a.fifty(), phi.fifty())),
       "what (1) leaves with these, over a⁵");
  tell("cycloid", double(left_side(0, k.fifty() / a.fifty(), phi.fifty())), "the same with a cos φ alone");
}

TELL
{
  curve("left_sides", {"ratio", "n0", "n1", "n2", "n3"}, [](Curve& out) {
    for(double ratio = 0.01; ratio < 0.5; ratio *= 1.1)
    {
      std::vector<double> row{ratio};
      for(int kept = 0; kept <= 3; ++kept)
        row.push_back(std::abs(double(left_side(kept, ratio, exact::pi() / 6))));
      out.put(row);
    }
  });
}

/*!
The cycloid leaves {{cycloid|3}} of {{eq 1}}; with {{n}} corrections {{left|e2}} is left.

::: figure tautochrone-28
alt: What the left side of the equation comes to, against k over a, both logarithmic: four straight lines
of the slopes 2, 4, 6 and 8 for none, one, two and three corrections.

What {{eq 1}} leaves at 30° against $k/a$. Each correction makes the line steeper by two;
Euler's has both $P$ and $Q$, "three" one more.
:::

## Checks

{{eq 1}} is the equation of {{sec tautochrone.25}} times $(kk+rr)^2$, whatever $r$ and $dr$ are.
*/

CHECK_THAT("(1) is the equation of § 25 freed of its fractions, for any numbers")
{
  const Rational a_(7, 3), kk(4, 25), r(5, 4), dr_sin(-2, 7), c(3, 5), u = kk + r * r;
  const Rational fractions = a_ - (a_ * a_ + kk) * r * c / u - (a_ * a_ + kk) * kk * dr_sin / (u * u);
  CHECK(equation<Rational>(a_, kk, r, dr_sin, c) == u * u * fractions);
}

CHECK_THAT("the powers (4) are those of (2) as far as k⁴, whatever P and Q are")
{
  const Powers P_ = cosine(-2) + 5, Q_ = cosine(1) - 2;
  const Rational a_(7, 3);
  const Expansion r({a_ * cosine(1), P_, Q_});
  const Expansion r2 = r * r, r3 = r2 * r, r4 = r2 * r2;
  CHECK(r2[1] == 2 * a_ * P_ * cosine(1));
  CHECK(r2[2] == 2 * a_ * Q_ * cosine(1) + P_ * P_);
  CHECK(r3[1] == 3 * a_ * a_ * P_ * cosine(2));
  CHECK(r3[2] == 3 * a_ * a_ * Q_ * cosine(2) + 3 * a_ * P_ * P_ * cosine(1));
  CHECK(r4[1] == 4 * a_ * a_ * a_ * P_ * cosine(3));
  CHECK(r4[2] == 4 * a_ * a_ * a_ * Q_ * cosine(3) + 6 * a_ * a_ * P_ * P_ * cosine(2));
}

Rational leading(
    int last)  // R = ξ − Σ dₙ ξ^(1−4n) from R⁴ − R³ξ + dR/dξ = 0: the largest terms at wide angles
{
  std::vector<Rational> d{1};  // of R/ξ in powers of ξ⁻⁴
  for(int i = 1; i <= last; ++i)
  {
    exact::Series<Rational> R(d, i), cube = R * R * R;
    const Rational known = (cube * (R - 1))[i] + Rational(5 - 4 * i) * d[static_cast<std::size_t>(i - 1)];
    d.push_back(-known);
  }
  return d.back();
}

CHECK_THAT(
    "the leading coefficients told are those of the equation at wide angles, and the terms are the series'")
{
  for(const Told& now : told_at("", "n=1 k=0.3", "n=8 phi=60 a=3e40 k=1e39", "n=12 phi=1e-8"))
  {
    CHECK(now.value("coefficient") == within_ulps(Fifty(leading(n)), 1, "a rounding"));
    CHECK(now.value("power") == 1 - 4 * n);
    const Fifty ratio = k.fifty() / a.fifty(), c = cos(phi.fifty());
    CHECK(now.value("last")
          == within_relative((truncated(n, ratio) - truncated(n - 1, ratio))(c), 1e-13, "a power"));
  }
  CHECK(leading(8) == -825'896'250);
}

CHECK_THAT(
    "what is left of (1) is told rightly: the slope taken by differences, the equation with its fractions")
{
  for(const Told& now : told_at("", "n=0 k=0.3", "n=2 phi=60 a=3e40 k=1e39"))
  {
    const Fifty ratio = k.fifty() / a.fifty(), kk = ratio * ratio, h("1e-12");
    const auto fractions = [&](int kept) -> Fifty {
      const auto r_at = [&](const Fifty& x) { return truncated(kept, ratio)(cos(x)); };
      const Fifty r = r_at(phi.fifty()), slope_ = (r_at(phi.fifty() + h) - r_at(phi.fifty() - h)) / (2 * h),
                  u = kk + r * r;
      return u * u - (1 + kk) * (r * cos(phi.fifty()) * u + kk * slope_ * sin(phi.fifty()));
    };
    CHECK(now.value("left")
          == within_relative(fractions(n), 1e-14, "differences of 1e-12, squared, and a rounding"));
    CHECK(now.value("cycloid") == within_relative(fractions(0), 1e-14, "the same"));
  }
}

CHECK_THAT("it refuses a k less than 1e-9 a, and one greater than a")
{
  for(const char* const within_them : {"k=1e-9", "k=1", "k=2e-9 a=2", "k=2 a=2"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"k=9.99999999999999e-10", "k=1.0000000000000003", "k=1.9999e-9 a=2", "k=2.0001 a=2"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("the lines of the figure have the slopes 2, 4, 6 and 8, and end in the next coefficient")
{
  const Fifty c = cos(exact::pi() / 6);
  const auto r = corrections<Fifty>(4);
  for(const Told& now : told_at(""))
  {
    const auto first = now.points("left_sides", 3)[0];
    for(const auto& [name, kept] : {std::pair{"n0", 0}, {"n1", 1}, {"n2", 2}, {"n3", 3}})
    {
      const Fifty next = abs(r[static_cast<std::size_t>(kept) + 1](c) * pow(c, 3))
                         * pow(Fifty(first.at("ratio")), 2 * kept + 2);
      CHECK(first.value(name)
            == within_relative(next, 0.01, "kk is a ten-thousandth, times the growth of the terms"));
    }
    for(const auto& point : now.points("left_sides", 3))
      for(const auto& [name, kept] : {std::pair{"n0", 0}, {"n1", 1}, {"n2", 2}, {"n3", 3}})
        CHECK(point.value(name)
              == within_relative(abs(left_side(kept, point.at("ratio"), exact::pi() / 6)), 1e-15,
                                 "a rounding"));
  }
}

/*!
In our copy most of the exponents of {{eq 1}} and {{eq 4}} are damaged. All terms of one equation have the
same dimension, five; and on the exact curve each term must be what the other eight demand, here for
$a = 2$, $k = \tfrac35$ at 30°.
*/

struct Curve30  ///< the exact curve's place at 30°
{
  Fifty a = 2, k = Fifty("0.6"), r, dr_sin, c = cos(exact::pi() / 6);
  Curve30()
  {
    const Fifty at_ = exact::pi() / 6, r0 = highest(k / a, at_);
    r = a * r0;
    dr_sin = a * slope(at_, r0, k / a) * sin(at_);
  }
};

double term(const char* which, int power)  // of (1), with the power as it is read
{
  const Curve30 on;
  const std::string w = which;
  return double(w == "first"   ? on.a * pow(on.r, power)
                : w == "third" ? on.a * pow(on.k, power)
                               : -on.a * on.a * pow(on.r, power) * on.c);
}

auto balances(const char* which, int power)  // whether a term is what the other eight demand
{
  return [=](double reading) {
    const Curve30 on;
    const Fifty others =
        equation<Fifty>(on.a, on.k * on.k, on.r, on.dr_sin, on.c) - Fifty(term(which, power));
    return reading == within_relative(-others, 1e-15, "a rounding of the term");
  };
}

const Emendation first_power{
    "§28, (1), the first term",
    {"ar²", [] { return term("first", 2); }},
    {"ar⁴", [] { return term("first", 4); }},
    "all terms have the dimension five, and only so do they add up to nothing on the exact curve",
    balances("first", 4)};

const Emendation cube{"§28, (1), the term −aar³ cos φ",
                      {"−aar² cos φ", [] { return term("fourth", 2); }},
                      {"−aar³ cos φ", [] { return term("fourth", 3); }},
                      "the same",
                      balances("fourth", 3)};

const Emendation last_power_{"§28, (1), the third term",
                             {"ak²", [] { return term("third", 2); }},
                             {"ak⁴", [] { return term("third", 4); }},
                             "the same",
                             balances("third", 4)};

double power_through_k4(int exponent, int binomial_, int of_a,
                        int of_k)  // at a = 2, k = ½, cos φ = 1, P = 3, Q = 0
{
  const double a_ = 2, kk = 0.25, P_ = 3, a_power = std::pow(a_, exponent);
  return a_power + exponent * std::pow(a_, exponent - 1) * kk * P_
         + binomial_ * std::pow(a_, of_a) * std::pow(0.5, of_k) * P_ * P_;
}

const Emendation of_the_cube{"§28, r³, the term with PP",
                             {"3aakkPP", [] { return power_through_k4(3, 3, 2, 2); }},
                             {"3ak⁴PP", [] { return power_through_k4(3, 3, 1, 4); }},
                             "it is the cube of a cos φ + kkP through k⁴",
                             [](double cube_) { return cube_ == 8 + 3 * 4 * 0.75 + 3 * 2 * 0.75 * 0.75; }};

const Emendation of_the_fourth{
    "§28, r⁴, the term with PP",
    {"6a³kkPP", [] { return power_through_k4(4, 6, 3, 2); }},
    {"6aak⁴PP", [] { return power_through_k4(4, 6, 2, 4); }},
    "it is the fourth power of a cos φ + kkP through k⁴",
    [](double fourth) { return fourth == 16 + 4 * 8 * 0.75 + 6 * 4 * 0.75 * 0.75; }};

/*!
## Go on from here

::: exercise
How many corrections are best at 60°, if by the best is meant what leaves the least of {{eq 1}}? Take
$k = \tfrac1{10}a$.

answer: One. `--phi 60 --n 1` leaves 0.0067, a cosine alone 0.0095, two corrections 0.0121, and from then on
each makes it worse; twelve leave $1.4\cdot10^{19}$. At 30° six are better than three: how far the series
helps hangs on the angle ({{sec tautochrone.30}}).
:::
*/

CHECK_THAT("at 60° one correction leaves least of (1), and more and more leave the more; at 30° six leave "
           "less than "
           "three")
{
  double before = 0;
  for(int kept = 1; kept <= 12; ++kept)
  {
    const double left = std::abs(double(left_side(kept, Fifty("0.1"), exact::pi() / 3)));
    CHECK(left > before);
    before = left;
  }
  CHECK(before == within_relative(1.4e19, 0.02, "two digits"));
  for(const auto& [setting, left] :
      {std::pair{"phi=60 n=0", 0.0095}, {"phi=60 n=1", 0.0067}, {"phi=60 n=2", 0.0121}})
    for(const Told& now : told_at(setting))
      CHECK(now.value("left") == within(left, 0.00005, "two digits"));
  CHECK(abs(left_side(6, Fifty("0.1"), exact::pi() / 6))
        < abs(left_side(3, Fifty("0.1"), exact::pi() / 6)));
}
