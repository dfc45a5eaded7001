#include "edition/section.hpp"
#include "exact/quadrature.hpp"
#include "exact/series.hpp"
#include "globe/asked.hpp"
#include "globe/ball.hpp"
#include "globe/oracle.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 15, "The time of one rocking")

using namespace globe;

/*!
## What Euler does

A ball that is hardly moved rocks about its lowest place, and every single swing takes the same time. The
integral of {{sec globe.14}} was so taken that Φ vanishes with $t$. The sine of an angle cannot grow beyond
$\pm1${{entry bound}}, so the angle goes at most to

$$ \Phi = \pm\frac{\zeta k}{\sqrt{2gc}}. \tag{1} $$

Since ζ is taken as infinitely small, the ball makes the smallest excursions to and fro about the position
of the beginning: a motion that he had formerly called vacillatory, and determined. And as Φ was nothing at
first, it comes back to nothing whenever

$$ \sin\frac{t\sqrt{2gc}}{k} = 0. \tag{2} $$

If the arc is put equal to $180° = \pi$, there comes

$$ t = \frac{\pi k}{\sqrt{2gc}}, \tag{3} $$

the time of every single oscillation or rocking. The progress, with which we let the centre of gravity move,
disturbs this rocking in nothing.

::: margin
Today: half of a period, $T_0 = \pi k/\sqrt{2gc}$, that of a pendulum of the length $kk:c$. Rolling, it is
another one ({{sec globe.31}}).
:::

What if the swing is not so small? With $h = \sin^2\frac12\Phi$ at the farthest place, and an angle ϑ that
runs from 0 to 90° on the way there, the formula of {{sec globe.13}} becomes

$$ \begin{gathered} \frac T{T_0} = \frac2\pi\int \sqrt{\frac{1 + 4q\,X(1-X)}{1-X}}\;d\vartheta, \\
   X = h\sin^2\vartheta, \qquad q = \frac{cc}{kk}, \end{gathered} \tag{A} $$

and expanded by the powers of $X$, each of whose means is known,

$$ \begin{aligned} \frac T{T_0} &= 1 + \Bigl(\frac14 + q\Bigr)h \\
   &+ \Bigl(\frac9{64} - \frac{3q}8 - \frac{3qq}4\Bigr)hh \\
   &+ \Bigl(\frac{25}{256} - \frac{5q}{64} + \frac{15qq}{16} + \frac{5q^3}4\Bigr)h^3 \\
   &+ \cdots \end{aligned} \tag{B} $$

With $q = 0$ it is the pendulum's own series. The rocking keeps its time worse than the pendulum, as long as
the first term rules: the farther the ball swings, the more its weight has to be moved up and down as well,
and that is inertia beyond $kk$. The root in {{eq A}} has a zero at the negative
$X = \frac12(1 - \sqrt{1 + kk:cc})$, and {{eq B}} converges only while $h$ is less than the size of that, if
it is less than 1. For a large $c:k$ that is $kk:4cc$, an amplitude of $k:c$. Beyond it the time is another
altogether: a ball with hardly any moment of inertia, $k = 0$, simply falls when it is let go, and the half of
a single swing takes the time of a fall through the height $2ch$,

$$ t = \sqrt{\frac{2ch}g}, \tag{C} $$

whereas {{eq 3}} makes it nothing. It is not the same to let first $k$ vanish and then the amplitude, or
the other way about.

## The program

What the swing exceeds {{eq 3}} by is told by itself: for small swings it is much less than an ulp of the
time.
*/

template <class Real>
std::array<Real, 3> terms(const Real& q, const Real& h)  // (B)
{
  return {(Real(1) / 4 + q) * h, (Real(9) / 64 - 3 * q / 8 - 3 * q * q / 4) * h * h,
          (Real(25) / 256 - 5 * q / 64 + 15 * q * q / 16 + 5 * q * q * q / 4) * h * h * h};
}

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto asked = asked_energy(0.07);

Energy<double> energy_asked()
{
  require(c <= 100 * k, "c", "between 1e-40 and a hundred times k");
  require(k <= 1e40 * c, "c", "between 1e-40 and a hundred times k");
  const Energy<Fifty> e = asked.fifty(c.fifty(), k.fifty() * k.fifty(), g.fifty());
  require(e.from_top > 0, asked.given(), "an energy h below 1: the ball is to rock");
  return rounded(e);
}

TELL
{
  const Energy<double> e = energy_asked();
  const double second = std::sqrt(2 * g) * std::sqrt(c), small = std::numbers::pi * k / second;
  const auto [first, next, third] = terms<double>(c / k * (c / k), e.h);
  tell("small", small, seconds, "a single very small swing, (3)");
  tell("length", k * (k / c), feet, "the pendulum that swings in that time, kk:c");
  tell("Phi_euler", 2 * std::sqrt(e.h), degrees, "how far it swings, by (1)");
  tell("Phi", 2 * std::atan2(std::sqrt(e.h), std::sqrt(e.from_top)), degrees, "the same, exactly");
  tell("swing", 2 * smooth::quarter<double>(c, k, e) / second, seconds, "a single swing, exactly");
  tell("excess", smooth::excess(c, k, e), "T:T₀ − 1, by how much it is longer than (3)");
  tell("one", first, "the same by (B) as far as h");
  tell("two", first + next, "as far as hh");
  tell("three", first + next + third, "as far as h³");
  tell("fall", 2 * std::sqrt(2 * c) * std::sqrt(e.h / g), seconds,
       "a single swing without inertia, by (C)");
}

TELL
{
  auto& rows = table("rows", "The excess of a single swing",
                     {{"Phi", "Φ", degrees, 4},
                      {"excess", "this ball", percent, 8},
                      {"three", "by (B)", percent, 8},
                      {"pendulum", "pendulum", percent, 8}});
  for(const double Phi : {1., 5., 10., 30., 60., 90., 150.})
  {
    const Energy<double> e = energy_of_amplitude(Phi * 1_deg);
    const auto [first, next, third] = terms<double>(c / k * (c / k), e.h);
    rows.row({Phi * 1_deg, smooth::excess(c, k, e), first + next + third, smooth::excess(0, 1, e)});
  }
  curve("longer", {"Phi", "ratio", "equal", "pendulum"}, [](Curve& longer) {
    for(int Phi = 0; Phi <= 176; Phi += 2)
    {
      const Energy<double> e = energy_of_amplitude(Phi * 1_deg);
      longer.put({double(Phi), 1 + smooth::excess(c, k, e), 1 + smooth::excess(1, 1, e),
                  1 + smooth::excess(0, 1, e)});
    }
  });
}

/*!
A very small swing of our ball takes {{small|8}} s, like one of a pendulum {{length}} feet long. With an
amplitude of {{Phi|4}} it takes {{swing|8}} s, longer by {{excess|4}} of the time, of which the first term
of {{eq B}} makes {{one|4}} and three terms {{three|4}}.

{{table rows}}

::: figure globe-15
alt: Time of a single swing over that of a very small one against the amplitude from 0 to 176 degrees:
three curves that start at 1 and rise, the pendulum's lowest, this ball's a little above it, and that of a
ball with c = k far above at moderate amplitudes.

The single swing in units of {{eq 3}} against its amplitude: the pendulum (grey), this ball (blue), and
one with $c = k$. The more eccentric ball keeps its time worse.
:::

## Speed against error

All ways are asked for the excess. Ask for `--h 1e-20`, or for `--c 1`, where $4qh$ is greater.
*/

Fifty by_mean(const Fifty& q, const Energy<Fifty>& e)  // (A) less 1, with no difference of great numbers
{
  if(e.from_top < 1e-12)  // where the integrand has a peak, but the excess is great
    return oracle::smooth_quarter(sqrt(q), 1, e) * 2 / exact::pi() - 1;
  const auto f = [&](const Fifty& angle) {  // from the farthest place
    const Fifty X = e.h * pow(cos(angle), 2), rest = e.from_top + e.h * pow(sin(angle), 2);
    return X * (1 / rest + 4 * q) / (1 + sqrt((1 + 4 * q * X * rest) / rest));
  };
  return exact::integrate(f, 0, exact::pi() / 2).value * 2 / exact::pi();
}

TELL
{
  const Energy<double> e = energy_asked();
  const double c_ = c, k_ = k;
  std::vector<Method> ways;
  for(std::size_t many = 1; many <= 3; ++many)
    ways.push_back({std::to_string(many) + (many == 1 ? " term" : " terms"),
                    [=] {
                      const auto summands = terms(c_ / k_ * (c_ / k_), e.h);
                      double sum = 0;
                      for(std::size_t i = many; i-- > 0;)
                        sum += summands[i];
                      return sum;
                    },
                    "series (B)"});
  ways.push_back(
      {"the time less one", [=] { return smooth::quarter(c_, k_, e) / (std::numbers::pi * k_ / 2) - 1; }});
  ways.push_back({"this edition", [=] { return smooth::excess(c_, k_, e); }});
  race("excess", "T:T₀ − 1", by_mean(pow(c.fifty() / k.fifty(), 2), {e.h, e.from_top}), ways);
}

/*!
## Checks

The times told are held against quadrature of {{eq A}} and of {{sec globe.13}}, two ways of fifty digits.
*/

CHECK_THAT(
    "the times, the amplitudes and the excess told are those of the integral, however small the swing")
{
  for(const Told& now : told_at("", "h=1e-20", "from_top=1e-12 c=0.4", "zeta=1e-8 c=1e-12",
                                "h=0.5 c=50 k=1 g=1e-70", "h=0.99 c=50 k=0.5", "from_top=1e-100 c=0.5"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), second = sqrt(2 * g_ * c_);
    const Energy<Fifty> e = asked.fifty(c_, k_ * k_, g_);
    const Fifty q = pow(c_ / k_, 2), h = e.h, small = exact::pi() * k_ / second, excess = by_mean(q, e);
    CHECK(now.value("small", seconds) == within_relative(small, 2e-15, "six roundings"));
    CHECK(now.value("length", feet) == within_relative(k_ * k_ / c_, 4e-16, "three roundings"));
    CHECK(now.value("Phi_euler", degrees)
          == within_relative(velocity_of_energy<Fifty>(c_, k_ * k_, g_, e) * k_ / second, 4e-16,
                             "(1), a root of a rounded number"));
    const Fifty end = h < 0.5 ? Fifty(2 * asin(sqrt(h))) : Fifty(2 * acos(sqrt(e.from_top)));
    CHECK(now.value("Phi", degrees) == within_relative(end, 8e-16, "two roots and an arc"));
    CHECK(
        now.value("swing", seconds)
        == within_relative(2 * oracle::smooth_quarter(c_, k_, e) / second, 4e-15, "eight ulps and a root"));
    CHECK(now.value("excess")
          == within_relative(excess, 3e-15, "the library's eight ulps, and three inputs"));
    CHECK(small * (1 + excess)
          == within_relative(2 * oracle::smooth_quarter(c_, k_, e) / second, 1e-33,
                             "two ways of forty digits"));
    // The rounding of the greatest summand, of some ten operations.
    const Fifty one = h / 4 + q * h, two = h * h * (9 - 24 * q - 48 * q * q) / 64;
    const Fifty three = pow(h, 3) * (25 - 20 * q + 240 * q * q + 320 * q * q * q) / 256;
    const double least =
        2e-15 * double(h * (1 + q) + h * h * (1 + q * q) + h * h * h * (1 + q * q * q * 2));
    CHECK(now.value("one") == within_relative(one, 1e-15, "five roundings"));
    CHECK(now.value("two") == within(one + two, least, "ten roundings of its summands"));
    CHECK(now.value("three") == within(one + two + three, least, "ten roundings of its summands"));
    CHECK(now.value("fall", seconds)
          == within_relative(2 * sqrt(2 * c_ * h / g_), 1e-15, "five roundings"));
    for(const auto& row : now.rows("rows"))
    {
      const Energy<Fifty> there = energy_of_amplitude<Fifty>(row.at("Phi", degrees));
      CHECK(row.value("Phi", degrees) == between(0, 3, "below the top"));
      CHECK(row.value("excess", percent) == within_relative(by_mean(q, there), 4e-15, "ten ulps"));
      CHECK(row.value("pendulum", percent) == within_relative(by_mean(0, there), 4e-15, "ten ulps"));
      const std::array<Fifty, 3> of = terms<Fifty>(q, there.h);
      CHECK(row.value("three", percent)
            == within(of[0] + of[1] + of[2],
                      4e-15 * double(of[0] + abs(of[1]) + abs(of[2]) + q * q * there.h * there.h),
                      "ten roundings of its summands"));
    }
  }
}

using Power = exact::Series<exact::Rational>;

template <class Number>
exact::Series<Number> expanded(const Number& q, int order)  // the root in (A), by the powers of X
{
  using Series = exact::Series<Number>;
  const Series X = Series::x(order), one = Series(1).truncated(order);
  const Series square = (one + Series(Number(4 * q)) * X * (one - X)) / (one - X);
  Series root = one;  // Newton's method, each turn doubling the terms that are right
  for(int right = 1; right <= order; right *= 2)
    root = (root + square / root) * Series(Number(1) / Number(2));
  return root;
}

CHECK_THAT(
    "it refuses a ball that turns over, and ratios of c to k that are beyond its limits, none before them")
{
  // With c = 1/8 and g = k = 1 h is ζζ.
  for(const char* const within_them :
      {"c=50 k=0.5", "c=100 k=1", "c=1 k=1e40", "c=2 k=2e40", "from_top=0.5",
       "c=0.125 g=1 k=1 zeta=1.0000000000000001e-50", "h=0.99999999999999999", "from_top=1e-100",
       "c=0.125 g=1 k=1 zeta=0.99999999999999999"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"c=50.00000000000001 k=0.5", "c=100.00000000000002 k=1", "c=0.9999999999999998 k=1e40",
       "c=1.9999999999999996 k=2e40", "from_top=0.5 zeta=1e-300",
       "c=0.125 g=1 k=1 zeta=9.9999999999999999e-51", "h=1", "from_top=-1e-100", "c=0.125 g=1 k=1 zeta=1",
       "c=0.125 g=1 k=1 zeta=1e50", "c=0.125 g=1 k=1 zeta=1.0000000000000001e50"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("the coefficients of (B) are those of the mean of the expanded root, exactly")
{
  // In X the root's square is (1 + 4q X(1 − X)):(1 − X); the mean of sin²ⁿϑ is 1·3·5…(2n−1) : 2·4·6…2n.
  const std::array<exact::Rational, 3> means{exact::Rational(1, 2), exact::Rational(3, 8),
                                             exact::Rational(5, 16)};
  for(const int times : {0, 1, 2, 3, 4})  // the coefficients are polynomials of degree 3 in q
  {
    const exact::Rational q(times, 7);
    const Power root = expanded(q, 3);
    const auto expected = terms<exact::Rational>(q, exact::Rational(1));
    for(int n = 1; n <= 3; ++n)
      CHECK(root[n] * means[static_cast<std::size_t>(n - 1)] == expected[static_cast<std::size_t>(n - 1)]);
  }
}

CHECK_THAT("the series (B) ends to converge where h is as great as the negative zero of the root")
{
  for(const int q : {1, 4})
  {
    const int n = 80;
    const auto root = expanded(Fifty(q), n);
    const Fifty zero = (sqrt(1 + Fifty(1) / q) - 1) / 2;
    // The mean multiplies the n-th by (2n − 1):2n.
    CHECK(root[n] / root[n - 1] * (2 * n - 1) / (2 * n) * zero
          == within(-1, 0.03, "besides, the terms fall as 1:nn, which is here a fortieth"));
  }
}

CHECK_THAT("without inertia half of a single swing is a free fall, (C), and (3) has no part in it")
{
  for(const char* h : {"1e-3", "0.5", "0.9"})
  {
    const Fifty e(h), k_("1e-12");  // c = g = 1, τ = t√2
    CHECK(oracle::smooth_quarter(1, k_, energy(e)) / sqrt(Fifty(2))
          == within_relative(sqrt(2 * e), 1e-8, "what is left is of the order of kk:cch, and a logarithm"));
  }
}

/*!
Our copy lets the sine grow to $\pm\pi$. If that were so the ball would swing three times as far as it does.
*/

const Emendation bound{"§15, the bound of the sine",
                       {"±π", std::numbers::pi},
                       {"±1", 1},
                       "the ball turns back where its living force is spent",
                       [](double reading) {
                         // (1) with that bound, against sin² ½Φ = h, for h = 1e-12.
                         const Fifty root("1e-6"), Phi = 2 * asin(root);
                         return reading * 2 * root == within_relative(Phi, 1e-12, "what (1) neglects, h:6");
                       }};

CHECK_THAT("the curves drawn are the means (A)")
{
  for(const Told& now : told_at("", "c=0.3"))
    for(const auto& point : now.points("longer", 7))
    {
      const Energy<Fifty> e = energy_of_amplitude<Fifty>(point.at("Phi") * exact::pi() / 180);
      CHECK(point.value("Phi") == between(0, 176, "not the top"));
      CHECK(point.value("ratio")
            == within_relative(1 + by_mean(pow(c.fifty() / k.fifty(), 2), e), 3e-15, "8 ulps"));
      CHECK(point.value("equal") == within_relative(1 + by_mean(1, e), 3e-15, "8 ulps"));
      CHECK(point.value("pendulum") == within_relative(1 + by_mean(0, e), 3e-15, "8 ulps"));
    }
}

CHECK_THAT("in the race each way gives what it gives in fifty digits")
{
  for(const Told& now : told_at("", "h=1e-20", "h=0.6 c=0.5"))
  {
    const Fifty q = pow(c.fifty() / k.fifty(), 2), h = asked.h.fifty();
    const Energy<Fifty> e = energy(h);
    const Fifty quarter = oracle::smooth_quarter(c.fifty(), k.fifty(), e) * 2 / (exact::pi() * k.fifty());
    const std::array<Fifty, 3> of = terms<Fifty>(q, h);
    const double slack = 3e-15 * double(of[0] + abs(of[1]) + abs(of[2]) + q * q * h * h);
    CHECK(now.exact("excess") == within(quarter - 1, 3e-15 * double(of[0]), "h is rounded there"));
    CHECK(now.method("excess", "1 term") == within_relative(of[0], 1e-15, "five roundings"));
    CHECK(now.method("excess", "2 terms") == within(of[0] + of[1], slack, "ten roundings of its summands"));
    CHECK(now.method("excess", "3 terms")
          == within(of[0] + of[1] + of[2], slack, "ten roundings of its summands"));
    CHECK(now.method("excess", "the time less one")
          == within(quarter - 1, 3e-15 * double(quarter), "eight ulps of the time"));
    CHECK(now.method("excess", "this edition") == within_relative(by_mean(q, e), 3e-15, "eight ulps"));
  }
}

/*!
## Go on from here

::: exercise
Is there a ball whose second term in {{eq B}} vanishes, so that one term is good to the third order?
answer: $\frac9{64} - \frac38q - \frac34qq$ vanishes for $q = \frac14$, that is $c = \frac12k$. With `--c
0.3` one term and two are the same.
:::
*/

CHECK_THAT("for c = k:2 the second term vanishes")
{
  CHECK(terms<exact::Rational>(exact::Rational(1, 4), exact::Rational(1))[1] == exact::Rational(0));
  for(const Told& now : told_at("c=0.3"))
  {
    CHECK(now.value("one") == within_relative(asked.h.fifty() / 2, 1e-15, "¼ + q is a half"));
    CHECK(now.value("two") == within_relative(asked.h.fifty() / 2, 1e-15, "and nothing is added"));
  }
}
