#include "balance/instrument.hpp"
#include "balance/motion.hpp"
#include "edition/section.hpp"

SECTION(balance, 24, "The beam let go inclined")

using namespace balance;

/*!
## What Euler does

For the rest of the paper the beam is let go from an inclination: at the start $\omega=m$, and it is at rest.
So at $t=0$

$$ m = \mathfrak C\sin\gamma, \quad \frac{d\omega}{dt} = \lambda\,\mathfrak C\cos\gamma = 0, \tag{1} $$

whence $\gamma = 90° = \frac\pi2$ and $\mathfrak C = m$, that is

$$ \omega = m\cos\lambda t. \tag{2} $$

What the pans do makes no difference to the beam: it performs regular swings, those of a simple pendulum of
the length

$$ f = c + \frac{kk}c + \frac{2Laa}{Mc}, {{entry length}} \tag{3} $$

and from $\lambda=\sqrt{2g:f}$ it follows that $f = 2g:\lambda\lambda$, by which the next section replaces
$f$.

::: margin
Today: nonlinear frequency shift, from the averaged Lagrangian. The quartic part of the weight gives
$\frac1{16}$, the cubic coupling in the second order the rest.
:::

It is exact in the first order of $m$. How regular is the beam beyond it? A pendulum with wider swings is
slower, by $\frac1{16}mm$. Here there is another thing of the same order. The pans hang from ends that move on
arcs, and follow them with their own swings of the second order ({{sec balance.28}}); these pull back at the
beam. In the mean the beam's frequency is

$$ \lambda\left[1 - mm\left(
   \frac1{16} + \frac{2\rho\lambda\lambda}{\mu\mu-4\lambda\lambda}\right)\right], \tag{A} $$

if the pans hung at rest at the start, ρ being $Laa:I$. With short strings, μ being great, the second part
vanishes: the pans go along with $A$ and $B$ as if they were fixed there, and the beam is the pendulum (3) to
the letter. With very long ones it is $-\frac12\rho$. The pans then stay behind when their strings' ends move
sideways, and of their inertia the beam has to carry the less the more it is inclined. If ρ is above an eighth
such a beam is even *quicker* in wide swings than in small ones.

## The program

Beside (2) and (A) stands the motion by the full equations; its mean frequency is taken from the moment at
which ω vanishes for the hundredth time.
*/

const auto a = real("a", 16. / 9, feet, closed(0.1, 100), "half the beam");
const auto b = real("b", 32. / 9, feet, closed(0.1, 1000), "length of the strings");
const auto c = real("c", 8. / 81, feet, closed(1e-3, 10), "depth of the beam's centre of gravity");
const auto k =
    real("k", 1.2531928435011872, feet, closed(0.03, 100), "the beam's radius of gyration about G");
const auto L = real("L", 1, none, closed(0, 100), "weight of each pan");
const auto M = real("M", 4, none, closed(0.01, 1e4), "weight of the beam");
const auto g = real("g", 16, feet, closed(0.1, 100), "height fallen in the first second");
const auto m = angle("m", 1. / 6, closed(0.1_deg, 20_deg), "inclination of the beam at the start");
const auto t = real("t", 1, seconds, closed(0, 50), "time");

double kk()
{
  return k * k;
}

Instrument given()
{
  return {a, b, c, kk(), L, M, g};
}

double pendulum()  // (3)
{
  return c + kk() / c + 2 * L * a * a / (M * c);
}

template <class Number>
Number shift_of(const Balance<Number>& of, const Number& beam)  // (A), less 1
{
  return -beam * beam * (Number(1) / 16 + 2 * of.rho * of.lambda2 / (of.mu2 - 4 * of.lambda2));
}

bool tame(const Balance<>& of, double beam, double until)  // neighbouring motions stay near each other
{
  return parting(of, released(beam, 0, 0), until) <= 1e4;
}

double hundred(const Balance<>& of)  // swings, and a little more: wide ones are slower
{
  return 110 * std::numbers::pi / std::sqrt(of.lambda2);
}

double zero(const Balance<>& of, double beam, int count)  // when ω vanishes for the time number `count`
{
  Motion motion(of, released(beam, 0, 0));
  const double step = std::numbers::pi / (20 * std::sqrt(of.lambda2));
  double at = 0, last = beam, now = beam;
  for(int found = 0; found < count; found += (now > 0) != (last > 0) ? 1 : 0)
  {
    last = now;
    at += step;
    now = motion.to(at).at.omega;
  }
  at -= step * now / (now - last);
  for(int k = 0; k < 4; ++k)  // Newton's rule
  {
    const State<> near = Motion(of, released(beam, 0, 0)).to(at);
    at -= near.at.omega / near.rate.omega;
  }
  return at;
}

double frequency(const Balance<>& of, double beam)  // in the mean, over λ, less 1
{
  return (100 - 0.5) * std::numbers::pi / (zero(of, beam, 100) * std::sqrt(of.lambda2)) - 1;
}

TELL
{
  const Balance<> of = numbers_of(given());
  require(std::abs(of.mu2 / of.lambda2 - 4) >= 1, "b", "such that μμ differs from 4λλ by λλ or more");
  require(of.mu2 <= 400 * of.lambda2, "b", "such that mu is 20 lambda at the most");
  require(tame(of, m, std::max(double(t), hundred(of))), "m",
          "so small that neighbouring motions of balance and pans stay near each other for a hundred "
          "swings, and until t");
  const double lambda = std::sqrt(of.lambda2);
  tell("f", pendulum(), feet, "f, (3)", 15);
  tell("lambda", std::sqrt(2 * g / pendulum()), Unit{"1/s"}, "λ", 15);
  tell("half_swing", std::numbers::pi / lambda, seconds, "one swing by (2)", 15);
  tell("omega", m * std::cos(lambda * t), degrees, "ω at the time t, (2)");
  tell("full", t == 0 ? m : Motion(of, released(m, 0, 0)).to(t).at.omega, degrees,
       "the same by the full equations");
  tell("rho", of.rho, "ρ");
  tell("shift", shift_of(of, double(m)), percent, "by what part the beam is quicker than λ, (A)");
  tell("pendulum", -m * m / 16, percent, "by what part a pendulum of the length f would be");
  tell("seen", frequency(of, m), percent, "by what part it is so by the full equations", 5);
}

TELL
{
  curve("slower", {"m", "pendulum", "theory", "full"}, [](Curve& out) {
    const Balance<> of = numbers_of(given());
    for(int k = 1; k <= 15; ++k)
    {
      const double beam = k * 1_deg;
      if(!tame(of, beam, hundred(of)))
        break;
      out.put({double(k), -100 * beam * beam / 16, 100 * shift_of(of, beam), 100 * frequency(of, beam)});
    }
  });
}

/*!
The mean frequency of the beam of Euler's example, let go at {{m|3}}, differs from λ by {{seen|3}}: a pendulum
of the length $f$ has {{pendulum|3}}, and (A) {{shift|3}}.

::: figure balance-24
alt: By what part the beam's frequency falls as it swings wider. The points of the full motion lie on the
lower one of two parabolas.

By how much the mean frequency differs from λ: a pendulum of the length $f$ (Euler's word taken exactly),
{{eq A}}, and the full equations (points).
:::

## Checks
*/

Fifty kk_exactly()
{
  return k.fifty() * k.fifty();
}

CHECK_THAT("f is the length by which the five equations turn a beam at a very small angle, and (2) follows")
{
  for(const Told& now :
      told_at("", "a=3 b=28 c=0.02 k=1.4 L=0.4 M=7 m=20 t=31", "a=0.5 b=40 c=3 k=0.45 L=30 M=0.7 m=3 t=4"))
  {
    const Fifty f = c.fifty() + kk_exactly() / c.fifty()
                    + 2 * L.fifty() * a.fifty() * a.fifty() / (M.fifty() * c.fifty());
    const Five five = five_equations(given(), {{1e-5, 0, 0}, {}});
    CHECK(now.value("f", feet) == within_relative(f, 2e-15, "a dozen roundings"));
    CHECK(-2 * g * 1e-5 / five.acceleration.omega
          == within_relative(f, 1e-9, "elimination, and the angle's square"));
    const Fifty lambda = sqrt(2 * g.fifty() / f);
    CHECK(now.value("lambda", Unit{"1/s"}) == within_relative(lambda, 2e-15, "some roundings"));
    CHECK(now.value("half_swing", seconds) == within_relative(exact::pi() / lambda, 3e-15, "the same"));
    CHECK(now.value("omega", degrees)
          == within(m.fifty() * cos(lambda * t.fifty()), m * (1e-15 + 3e-15 * double(lambda) * t),
                    "the phase"));
    CHECK(now.value("full", degrees)
          == within(by_gsl(numbers_of(given()), released(m, 0, 0), t, 1e-13).at.omega, 1e-10,
                    "GSL's tolerance"));
    const Fifty I =
        M.fifty() * (kk_exactly() + c.fifty() * c.fifty()) + 2 * L.fifty() * a.fifty() * a.fifty();
    const Fifty rho = L.fifty() * a.fifty() * a.fifty() / I, mu2 = 2 * g.fifty() / b.fifty(),
                mm = m.fifty() * m.fifty();
    CHECK(now.value("rho") == within_relative(rho, 2e-15, "some roundings"));
    const Fifty of_pans = 2 * rho * lambda * lambda / (mu2 - 4 * lambda * lambda);
    CHECK(now.value("shift", percent)
          == within_relative(-mm * (Fifty(1) / 16 + of_pans), 1e-13, "a difference"));
    CHECK(now.value("pendulum", percent) == within_relative(-mm / 16, 1e-15, "a square"));
  }
}

CHECK_THAT("strings on which μμ lies between 3 λλ and 5 λλ are refused, and those on which μ is above 20 λ")
{
  const std::string three = "a=1 k=1 c=1 m=1 M=2 L=1 g=1.5 b=", five = "a=1 k=1 c=1 m=1 M=2 L=3 g=2.5 b=",
                    quick = "a=1 k=1 c=1 m=1 M=1 L=24 ";  // λ is 1 in all, but for g=100 where it is 2
  for(const std::string& no : {three + "0.99999999999999989", five + "1.0000000000000002",
                               quick + "g=25 b=0.12499999999999999", quick + "g=100 b=0.12499999999999999"})
    CHECK(refused_at(no));
  for(const std::string& yes : {three + "1", five + "1", quick + "g=25 b=0.125", quick + "g=100 b=0.125"})
    CHECK(!refused_at(yes));
}

CHECK_THAT(
    "a beam is refused whose neighbours part from it within a hundred swings, or before t if that is later")
{
  const std::string light = "M=100 L=0.5 a=20 b=3 c=0.7 k=0.5 m=";
  const std::string quick = "M=1000 L=2.2 a=2.1 b=0.18 c=1.9 k=0.14 g=100 m=20 t=";  // a hundred: 33.9 s
  for(const std::string& apart : {light + "14.431", quick + "43.4"})
    CHECK(refused_at(apart));
  for(const std::string& near : {light + "14.429", quick + "43"})
    CHECK(!refused_at(near));
}

/*!
The mean frequency is taken a second time from the motion by GSL, which is at zero at the moment that the
program found, as often before as it should be.
*/

double zeros_by_gsl(const Balance<>& of, double beam,
                    double until)  // their number, and what is left of the next
{
  State<> now = released(beam, 0, 0);
  const int parts = 4000;
  int many = 0;
  for(int k = 0; k < parts; ++k)
  {
    const State<> next = by_gsl(of, now, until / parts, 1e-13);
    many += (next.at.omega > 0) != (now.at.omega > 0) ? 1 : 0;
    now = next;
  }
  const bool just = std::abs(now.at.omega / now.rate.omega) < 1e-8 * until;  // at the zero, or all but
  return just ? many + ((now.at.omega > 0) == (now.rate.omega < 0) ? 1 : 0) : 0;
}

CHECK_THAT("the beam goes as quickly as (A) says, to the next order of m, and the moments are GSL's")
{
  for(const Told& now : told_at("", "b=40 c=0.2 L=3", "b=1 m=12"))
  {
    const Balance<> of = numbers_of(given());
    const double theory = shift_of(of, double(m));
    CHECK(now.value("seen", percent)
          == within(theory, 12 * std::pow(double(m), 4) + 0.03 * m * m,
                    "the next order, and half a swing of a hundred"));
    const double at = zero(of, m, 100);
    CHECK(zeros_by_gsl(of, m, at) == 100);
    CHECK(now.value("seen", percent)
          == within(99.5 * std::numbers::pi / (at * std::sqrt(of.lambda2)) - 1, 1e-12, "the same moment"));
    for(const auto& point : now.points("slower", 4))
    {
      const double beam = point.at("m") * 1_deg;
      CHECK(point.value("pendulum") == within_relative(-100 * Fifty(beam) * beam / 16, 1e-14, "a square"));
      CHECK(point.value("theory")
            == within_relative(100 * shift_of<Fifty>({of.lambda2, of.mu2, of.beta, of.rho}, beam), 1e-12,
                               "a difference"));
      CHECK(point.value("full")
            == within(100 * shift_of(of, beam), 1200 * std::pow(beam, 4) + 3 * beam * beam,
                      "the next order, and half a swing"));
    }
  }
}

CHECK_THAT("with long strings and heavy pans wide swings are the quicker ones")
{
  const Balance<> long_strings{1, 0.04, 0.02, 0.4};
  CHECK(shift_of(long_strings, 0.1) > 0);
  CHECK(frequency(long_strings, 0.1) > 0);
  CHECK(shift_of(Balance<>{1, 1e-9, 1, 0.4}, 1.)
        == within(-1. / 16 + 0.2, 1e-8, "−½ρ for the second part"));
  CHECK(shift_of(Balance<>{1, 1e9, 1, 0.4}, 1.) == within(-1. / 16, 1e-8, "the pendulum alone"));
}

/*!
In {{eq 3}} our copy has denominators λ and $a$, and the square at $L$ instead of $a$; the lengths themselves
are those of {{sec balance.14}}.
*/

const Emendation length{
    "§24, the length f, in Euler's example in feet",
    {"c/λ + k/a + 2L²a/(Mc)",
     [] { return 8. / 81 + std::sqrt(10304.) / 81 / (16. / 9) + 2 * 16. / 9 / (4 * 8. / 81); }},
    {"c + kk/c + 2Laa/(Mc)", [] { return 32.; }},
    "the five equations turn the beam so",
    [](double reading) {
      const Five five = five_equations(instrument_of_35, {{1e-5, 0, 0}, {}});
      return -32 * 1e-5 / five.acceleration.omega == within_relative(reading, 1e-9, "elimination");
    }};

/*!
## Go on from here

::: exercise
Can strings be found on which the beam takes the same time for wide swings and small ones?
answer: By {{eq A}} where $\mu\mu = (4-32\rho)\,\lambda\lambda$, that is, with strings of the length
$b = f:(4-32\rho)$. So the pans must be light, ρ less than an eighth; with heavier ones no string will do.
:::
*/

CHECK_THAT("on strings of the length f : (4 − 32ρ) the beam's mean frequency is λ, to the next order of m")
{
  for(const double share : {0.04, 0.05, 0.08})
  {
    const Balance<> of{1, 4 - 32 * share, 0.5, share};
    CHECK(shift_of(of, 0.1) == within(0, 1e-17, "a difference of equal parts"));
    const Balance<> heavier{1, 4 - 32 * share, 0.5, 2 * share};
    const double m_ = 0.02, room = 0.004 * m_ * m_ + 10 * std::pow(m_, 4);
    CHECK(frequency(of, m_) == within(0, room, "half a swing of a hundred, and the next order"));
    CHECK(frequency(heavier, m_) == within_relative(shift_of(heavier, m_), 0.2, "the same"));
  }
  for(const double share : {0.125, 0.3})
    for(const double mu2 : {1e-6, 0.5, 2., 3., 5., 50., 1e6})
      CHECK(shift_of(Balance<>{1, mu2, 0.5, share}, 0.1) != 0);
}
