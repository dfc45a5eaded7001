#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "tautochrone/curve.hpp"
#include "tautochrone/series.hpp"

SECTION(tautochrone, 27, "A small body on a long thread")

using namespace tautochrone;

/*!
## What Euler does

So that some fruit may yet be had of an equation that he cannot solve, Euler confines himself to pendulums
for which $kk$ is so small that it nearly vanishes against the other quantities with which it is compared.
Such is the case where the body $EF$, which makes up the pendulum, is very heavy and at the same time very
small, and where wide swings are excluded besides. For the longer such a pendulum is taken, the smaller is
$kk$ against $aa$ and $rr$.

Then the integral of the equation may be expressed by a series whose terms go by the powers of $kk$,

$$ \frac ra = r_0 + r_1\frac{kk}{aa} + r_2\frac{k^4}{a^4} + \text{etc.,} \tag{A} $$

and it will be enough to take two or three of them: those that follow may be left out without error
because of the higher powers of $kk$.

::: margin
$r_0, r_1, r_2$ are ours; the next sections have $r_0 = \cos\varphi$, $P = r_1/a$, $Q = r_2/a^3$.
:::

He is right to name $rr$ beside $aa$, and to exclude wide swings. At the angle $\varphi$ the radius is
about $a\cos\varphi$, and the terms turn out to go by $kk/aa\cos^4\varphi$ rather than by $kk/aa$. That
three terms are enough has a limit of another kind, too. However small $kk$ is, the terms fall only up to
one of them and then grow without end. How small the smallest is depends upon the angle by

$$ A(\varphi) = -\tfrac12 - l\sin\varphi + \tfrac12\sin^2\varphi. \tag{B} $$

The smallest stands near the place $Aaa/kk$ in the series, and what cannot be had by any number of terms is of
the size of $e^{-Aaa/kk}$. This law of the late terms has been read off from the terms themselves, and is
checked below by them; it is not proved here.

## The program

The terms come from {{api tautochrone::terms}}, in polynomials of $\tan^2\varphi$ that have no cancellation.
*/

const auto a = real("a", 1, metres, scale, "AC, from the suspension to the centre of gravity");
const auto k = real("k", 0.1, metres, scale, "radius of gyration");
const auto phi = angle("phi", 40_deg, above_to(0_deg, 89_deg), "angle of the free part with the vertical");
const auto last = integer("last", 16, 2, last_power, "the last power of kk that is looked at");

int place_of_smallest(const std::vector<double>& t)
{
  std::size_t best = 1;
  for(std::size_t n = 1; n < t.size(); ++n)
    if(std::abs(t[n]) < std::abs(t[best]))
      best = n;
  return static_cast<int>(best);
}

double fall(double phi_)  // r₂ over r₁, P and Q of the next sections
{
  const double t = std::pow(std::tan(phi_), 2);
  return 6 * std::pow(1 + t, 3) / (2 + t);
}

TELL
{
  require(k / a >= 1e-9, "k", "from 1e-9 a to a");
  require(k / a <= 1, "k", "from 1e-9 a to a");
  const std::vector<double> t = terms(k / a, phi, last);
  const double kappa = k / a * (k / a), A = double(falling(phi.fifty()));
  tell("first", -t[1], "how much the first correction takes away, over a");
  tell("second", -t[2], "how much the second takes away");
  tell("fall", kappa * fall(phi), "the second over the first");
  tell("best", place_of_smallest(t), "which of the corrections is the smallest");
  tell("smallest", std::abs(t[static_cast<std::size_t>(place_of_smallest(t))]), "its size");
  tell("A", A, "(B)");
  tell("out_of_reach", std::exp(-A / kappa), "e to the −Aaa/kk");
  auto& rows =
      table("terms", "The corrections, over a", {{"n", "power of kk", none, 2}, {"term", "term", none, 6}});
  for(std::size_t n = 1; n < t.size(); ++n)
    rows.row({double(n), t[n]});
}

TELL
{
  curve("fall_and_rise", {"n", "size", "phi"}, [](Curve& out) {
    for(const int degrees_ : {10, 20, 30, 40, 50, 60})
    {
      const std::vector<double> t = terms(0.1, degrees_ * 1_deg, last_power);
      for(std::size_t n = 1; n < t.size(); ++n)
        out.put({double(n), std::abs(t[n]), double(degrees_)});
      out.block();
    }
  });
}

/*!
For $k = \tfrac1{10}a$ and at 40° the second correction is {{fall|2}} of the first, and the smallest of them
is that with the power {{best}} of $kk$. Euler's two are well before it.

{{table terms}}

::: figure tautochrone-27
alt: The size of the corrections against their number, on a logarithmic scale, one line for each angle
from 10 to 60 degrees. At 10 and 20 degrees they fall throughout; at 40 degrees they fall ever more slowly
and come to a stand; at 50 and 60 degrees they soon grow.

The sizes of the corrections for $k = \tfrac1{10}a$. The wider the angle, the
sooner they cease to fall.
:::

## Checks

The terms are compared with those of the recursion in fifty digits, and $A$ with an integral that it is.
*/

CHECK_THAT("the terms told are the series', and the smallest of them is the one told")
{
  for(const Told& now :
      told_at("", "k=0.3 phi=20 last=16", "a=2e60 k=2e58 phi=80", "k=0.02 phi=1e-6 last=3"))
  {
    const Fifty ratio = k.fifty() / a.fifty(), c = cos(phi.fifty());
    std::vector<Fifty> t{truncated(0, ratio)(c)};
    for(int n = 1; n <= last; ++n)
      t.push_back((truncated(n, ratio) - truncated(n - 1, ratio))(c));
    const auto told = now.rows("terms");
    std::size_t best = 1;
    for(std::size_t n = 1; n < t.size(); ++n)
    {
      CHECK(told[n - 1].value("n") == int(n));
      CHECK(told[n - 1].value("term")
            == within_relative(t[n], 3e-14, "the library's bound, and the angle's"));
      if(abs(t[n]) < abs(t[best]))
        best = n;
    }
    CHECK(now.value("first") == within_relative(-t[1], 2e-14, "the library's bound"));
    CHECK(now.value("second") == within_relative(-t[2], 2e-14, "the library's bound"));
    CHECK(now.value("fall") == within_relative(t[2] / t[1], 3e-14, "both bounds"));
    CHECK(now.value("best") == int(best));
    CHECK(now.value("smallest") == within_relative(abs(t[best]), 3e-14, "the library's bound"));
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

CHECK_THAT("A is the integral of cos³φ/sin φ from the angle to 90°, and e to the −Aaa/kk is told of it")
{
  for(const Told& now : told_at("", "k=0.3 phi=20", "a=2 k=0.5 phi=80"))
  {
    const Fifty A = exact::integrate([](const Fifty& x) { return pow(cos(x), 3) / sin(x); }, phi.fifty(),
                                     exact::pi() / 2)
                        .value;
    const Fifty share = A / pow(k.fifty() / a.fifty(), 2);
    CHECK(now.value("A") == within_ulps(A, 1, "a rounding"));
    CHECK(now.value("out_of_reach")
          == within_relative(exp(-share), 1e-15 * (2 + double(share)), "the exponent rounds"));
  }
}

CHECK_THAT("the late terms grow like Γ(n + 5/4)/Aⁿ: each is (n + 1/4)/A times the one before, the more "
           "nearly the later")
{
  for(const double angle_ : {30_deg, 45_deg, 60_deg})
  {
    const Fifty A = falling(angle_), c = cos(Fifty(angle_));
    const auto r = corrections<Fifty>(14);
    Fifty before = 1;
    for(const int n : {6, 10, 14})
    {
      const auto i = static_cast<std::size_t>(n);
      const Fifty off = abs(r[i](c) / r[i - 1](c) * A / (n + Fifty(0.25)) - 1);
      CHECK(off < before);
      before = off;
    }
    CHECK(before == between(0, 1.0 / 14, "less than the order 1/n"));
  }
}

CHECK_THAT("in the figure the terms at 10° still fall with the power sixteen, and those at 60° grow from "
           "the third on")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("fall_and_rise"))
    {
      const int n = int(point.at("n"));
      const Fifty c = cos(Fifty(point.at("phi")) * exact::pi() / 180), tenth = Fifty("0.1");
      if(n < 5)
        CHECK(point.value("size")
              == within_relative(abs((truncated(n, tenth) - truncated(n - 1, tenth))(c)), 3e-14,
                                 "the library's bound"));
    }
  CHECK(place_of_smallest(terms(0.1, 10_deg, 16)) == 16);
  CHECK(place_of_smallest(terms(0.1, 60_deg, 16)) == 2);
}

/*!
## Go on from here

::: exercise
At which angle is the second correction as large as the first, for $k = \tfrac1{10}a$? What does that say of
Euler's formula there?

answer: With $t = \tan^2\varphi$ their quotient is $\kappa\,\dfrac{6(1+t)^3}{2+t}$. At 40° it is {{fall|2}};
it comes to 1 just beyond 61.9°: `--phi 61.9` tells 0.998. Where the last term kept is as large as the one
before, nothing is known of those that are left out.
:::
*/

CHECK_THAT("for k = a/10 the two corrections are equal between 61.9° and 62°")
{
  for(const Told& now : told_at("phi=61.9"))
    CHECK(now.value("fall") == between(0.99, 1, "the exercise"));
  for(const Told& now : told_at("phi=62"))
    CHECK(now.value("fall") == between(1, 1.02, "the exercise"));
}
