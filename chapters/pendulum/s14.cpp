#include "edition/section.hpp"
#include "pendulum/asked.hpp"
#include "pendulum/equation.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

SECTION(pendulum, 14, "The equation of the descent")

/*!
## What Euler does

The equation of motion is rewritten in the angles from the top. With the letters of {{sec pendulum.13}} its
two squares are

$$ cc = \cos^2\tfrac12\eta = 1 - \sin^2\tfrac12\eta, \tag{1} $$

$$ zz = \cos^2\tfrac12\psi = 1 - \sin^2\tfrac12\psi, \tag{2} $$

and the differential becomes

$$ \frac{dz}{\sqrt{1-zz}} = \tfrac12\,d\psi. \tag{3} $$

He gives it the sign $+$, although $z = \cos\tfrac12\psi$ decreases when $\psi$ grows, and says why: the
body is now taken to descend, whereas before it was taken to ascend. It is the element of time that has to
be positive.

In the difference $cc - zz$ the two ones cancel, and there remains

$$ \frac{dt\sqrt{2g}}{\sqrt b} = \frac{d\psi}{2\sqrt{\sin^2\tfrac12\psi - \sin^2\tfrac12\eta}}, \tag{4} $$

::: margin
Today: $\tfrac12\dot\psi^2 = 2\left(\sin^2\tfrac12\psi - \sin^2\tfrac12\eta\right)$, the energy counted from
the top, if the unit of time is $\sqrt{b/2g}$.
:::

where, he reminds us, the term $\sin^2\tfrac12\eta$ is as small as can be.

## The program

The equation before the ones are cancelled, and after.
*/

template <class Real>
Real element_before(Real psi, Real eta)  // (3) over the root of cc − zz, without dψ
{
  using std::cos, std::sqrt;
  const Real c = cos(eta / 2), z = cos(psi / 2);
  return 1 / (2 * sqrt(c * c - z * z));
}

template <class Real>
Real element(Real psi, Real eta)  // (4), without dψ
{
  using std::sin, std::sqrt;
  const Real now = sin(psi / 2), start = sin(eta / 2);
  return 1 / (2 * sqrt(now * now - start * start));
}

/*!
One difference is left, and just after the start, where $\psi$ is hardly more than $\eta$, it is again one
of nearly equal numbers. But it is a product,

$$ \sin^2\tfrac12\psi - \sin^2\tfrac12\eta = \sin\tfrac12(\psi+\eta)\,\sin\tfrac12(\psi-\eta), \tag{A} $$

and if the way already gone, $\psi - \eta$, is what is given, nothing is lost at all.
*/

template <class Real>
Real element_of_way(Real way, Real eta)  // (4) by (A); way = ψ − η
{
  using std::sin, std::sqrt;
  return 1 / (2 * sqrt(sin(eta + way / 2)) * sqrt(sin(way / 2)));  // a root each: the product may vanish
}

const auto swing_ = amplitude_from_top(0.1_deg);
const auto psi = angle("psi", 0.2_deg, above_to(0_deg, 180_deg), "the angle from the top that is reached");

TELL
{
  pendulum::require_descent(psi, swing_.eta);
  const double eta = swing_.eta,
               way = pendulum::way_from_rest(static_cast<double>(psi.fifty() - swing_.eta.fifty()), eta),
               tau = swing::time_from_rest_past(way, eta);
  tell("element", element_of_way(way, eta), "dt/dψ in the unit √(b/2g)");
  tell("tau", tau, "time since the start, t√(2g/b)");
  tell("cosh", eta * std::cosh(tau), degrees, "where η cosh t√(2g/b) would be by then");
}

TELL
{
  curve("elements", {"psi", "element"}, [](Curve& c) {
    for(const double eta : {5_deg, 1_deg, 0.1_deg})
    {
      for(double way = 1e-3 * eta; eta + way <= 180_deg; way *= 1.06)
        c.put({(eta + way) / 1_deg, element_of_way(way, eta)});
      c.gap();
    }
  });
  curve("limit", {"psi", "element"}, [](Curve& c) {
    for(double reached = 0.05_deg; reached <= 180_deg; reached *= 1.06)
      c.put({reached / 1_deg, 0.5 / std::sin(reached / 2)});
  });
}

/*!
::: figure pendulum-14
alt: The element of time against ψ. Three curves fall from infinity, at 5, 1 and 0.1 degrees, to a common
one.

The time that each further radian takes, against the angle from the top. At every start the element is
infinite, but only for a moment; soon all three curves lie on one, $\tfrac12 : \sin\tfrac12\psi$, as if η
were nothing. On that {{sec pendulum.15}} builds.
:::

## Speed against error
*/

TELL
{
  const double eta = swing_.eta;
  const Fifty gone = psi.fifty() - swing_.eta.fifty();
  const double way = static_cast<double>(gone);
  race("difference", "dt/dψ", element_of_way(gone, swing_.eta.fifty()),
       {{"1/(2√(cc − zz))", [=] { return element_before<double>(psi, eta); }},
        {"the equation (4)", [=] { return element<double>(psi, eta); }},
        {"the product (A)", [=] { return element_of_way(way, eta); }}});
}

/*!
## Checks

The exact descent has at every moment the speed that {{eq 4}} gives it.
*/

CHECK_THAT("the element, in its three forms, is one over the speed of the exact descent")
{
  for(const double start : {1e-3, 5_deg, 90_deg})
    for(const double part : {0.1, 0.5, 0.9, 1.0})
    {
      const auto motion = swing::oracle::Motion::from_eta(start);
      const Fifty t = motion.quarter() * (part - 1);  // before the lowest point
      const Fifty psi_ = motion.angle_from_top(t), eta = start, slowness = 1 / motion.velocity(t);
      const char* const why = "fifty digits, less what the squares cancel";
      CHECK(element_before(psi_, eta) == within_relative(slowness, 1e-43, why));
      CHECK(element(psi_, eta) == within_relative(slowness, 1e-47, why));
      CHECK(element_of_way(psi_ - eta, eta) == within_relative(slowness, 1e-47, why));
    }
}

/*!
The sign in {{eq 3}}: $z$ decreases while $\psi$ grows.
*/

CHECK_THAT("dz is −½dψ times √(1 − zz), so that the sign + means the descent")
{
  for(const double psi_ : {1_deg, 60_deg, 179_deg})
  {
    const Fifty h("1e-20"), z = cos(Fifty(psi_) / 2);
    const Fifty slope = (cos((psi_ + h) / 2) - cos((psi_ - h) / 2)) / (2 * h);
    CHECK(slope / sqrt(1 - z * z) == within(Fifty(-0.5), 5e-29, "some 1e-50 over h, and hh = 1e-40"));
  }
}

/*!
Near the top the pendulum moves about an unstable equilibrium, and goes as the hyperbolic cosine of the
time.
*/

CHECK_THAT("near the top ψ is η cosh t, while ψ is small")
{
  const auto motion = swing::oracle::Motion::from_eta(1e-9);
  for(const double t : {0.1, 1.0, 10.0})
  {
    const Fifty linear = Fifty(1e-9) * cosh(Fifty(t)),
                ratio = motion.angle_from_top(t - motion.quarter()) / linear;
    CHECK(ratio
          == between(1 - linear * linear / 24, 1,
                     "ψ³/48 is missing in the end, before that half as much again"));
  }
}

CHECK_THAT("one part in a hundred millions from the top the ones cancel to nothing, the product does not")
{
  CHECK(std::isinf(element_before(2e-8, 1e-8)));

  for(const double way : {1e-300, 1e-20, 1e-8, 1.0})
    CHECK(element_of_way(way, 1e-8)
          == within_ulps(element_of_way(Fifty(way), Fifty(1e-8)), 2, "two sines, a product, a root"));
}

/*!
What is told is judged by the exact descent: its speed at the moment when it has come to ψ, and the time to
there.
*/

CHECK_THAT(
    "the element and the time told are those of the exact descent, the cosine that of its first moments")
{
  for(const Told& now : told_at("", "eta=30 psi=100", "eta=1e-200rad psi=2e-200rad", "zeta=60 psi=180"))
  {
    const Fifty eta = swing_.eta.fifty(), way = psi.fifty() - eta;
    const Fifty tau = swing::oracle::time_from_rest_past(way, eta);
    const auto motion = swing::oracle::Motion::from_eta(eta);
    const Fifty slowness = 1 / motion.velocity(tau - motion.quarter());
    CHECK(now.value("element") == within_ulps(slowness, 3, "two sines and their roots, and products"));
    CHECK(now.value("tau") == within_ulps(tau, 6, "the library's bound"));
    CHECK(now.value("cosh", degrees)
          == within_relative(eta * cosh(tau), 4e-15, "the time's ulps, times itself"));
    CHECK(now.exact("difference") == within_relative(slowness, 1e-44, "fifty digits, less the motion's"));
    CHECK(now.method("difference", "the product (A)") == within_ulps(slowness, 3, "as above"));
  }
  for(const Told& now : told_at("", "eta=30 psi=100", "eta=0.01 psi=0.02"))
  {
    const Fifty eta = swing_.eta.fifty(), s = sin(eta / 2), p = sin(psi.fifty() / 2);
    const Fifty slowness = 1 / (2 * sqrt(p * p - s * s));
    const double lost = static_cast<double>(3e-16 / (p * p - s * s)),
                 kept = static_cast<double>(p * p) * lost;
    CHECK(now.method("difference", "1/(2√(cc − zz))")
          == within_relative(slowness, lost, "squares near one"));
    CHECK(now.method("difference", "the equation (4)")
          == within_relative(slowness, kept + 3e-16, "small squares"));
  }
  for(const Told& now : told_at("eta=60 psi=60.0000000000000000000001"))
  {
    const Fifty s = sin(swing_.eta.fifty() / 2), p = sin(psi.fifty() / 2);
    CHECK(now.method("difference", "the product (A)")
          == within_ulps(1 / (2 * sqrt(p * p - s * s)), 3, "as above, however short the way"));
    for(const char* const by_difference : {"1/(2√(cc − zz))", "the equation (4)"})
      CHECK(now.method("difference", by_difference) == infinite("η and ψ are one double"));
  }
}

CHECK_THAT("the curves are the element at three starts, and half over the sine")
{
  for(const Told& now : told_at(""))
  {
    int starts = 0;
    double before = 180;
    for(const auto& point : now.points("elements"))
    {
      const double at = point.at("psi");
      starts += at < before ? 1 : 0;
      before = at;
      const Fifty eta = Fifty(starts == 1 ? "5" : starts == 2 ? "1" : "0.1") * exact::pi() / 180;
      const Fifty s = sin(eta / 2), p = sin(Fifty(at) * exact::pi() / 360);
      CHECK(point.value("element")
            == within_relative(1 / (2 * sqrt(p * p - s * s)), 1e-12, "ψ − η of a rounded ψ"));
    }
    CHECK(starts == 3);
    for(const auto& point : now.points("limit", 9))
      CHECK(
          point.value("element")
          == within_relative(1 / (2 * sin(Fifty(point.at("psi")) * exact::pi() / 360)), 1e-14, "ψ rounds"));
  }
}

CHECK_THAT(
    "a way of less than 10⁻³⁰ of η is refused, since fifty digits of both angles would leave too few of it")
{
  for(const char* const too_near : pendulum::hardly_descended)
    CHECK(refused_at(too_near));
  for(const char* const far_enough : pendulum::descended)
    CHECK(!refused_at(far_enough));
}

/*!
## Go on from here

::: exercise
Let go a tenth of a degree from the top, the pendulum falls at first like the hyperbolic cosine. How far
is it down when this is wrong by one per cent?

answer: About 40° from the top: at 39° the cosine is 0.98 per cent ahead, at 40° 1.03. Nearly four fifths of
the time are over by then, since near the top the pendulum lingers.
:::
*/

CHECK_THAT("from a tenth of a degree the hyperbolic cosine is one per cent ahead between 39° and 40°")
{
  for(const Told& now : told_at("psi=39"))
    CHECK(now.value("cosh", degrees) == within_relative(1.0098 * Fifty(psi), 5e-5, "0.98 per cent"));
  for(const Told& now : told_at("psi=40"))
  {
    CHECK(now.value("cosh", degrees) == within_relative(1.0103 * Fifty(psi), 5e-5, "1.03 per cent"));
    const Fifty whole = swing::oracle::K_from_complement(sin(swing_.eta.fifty() / 2));
    CHECK(now.value("tau") == between(whole * Fifty("0.78"), whole * Fifty("0.8"), "nearly four fifths"));
  }
}
