#include <complex>

#include "balance/euler.hpp"
#include "edition/section.hpp"

SECTION(balance, 20, "The angular velocities, and the end of the solution")

using namespace balance;

/*!
## What Euler does

To meet the six conditions the angular velocities are needed at any time $t$ as well as the angles. They are
found by differentiating what {{sec balance.17}} and {{sec balance.18}} have:

$$ \begin{aligned}
\frac{d\eta}{dt} = {}&\mu\mathfrak A\cos(\alpha+\mu t)\\
 &- \frac{\mu\mu(\mu-\lambda)a\mathfrak A\mathfrak C}{2\lambda(2\mu-\lambda)f}\\
 &\quad\times\sin\bigl(\alpha-\gamma+(\mu-\lambda)t\bigr)\\
 &- \frac{\mu\mu(\mu+\lambda)a\mathfrak A\mathfrak C}{2\lambda(2\mu+\lambda)f}\\
 &\quad\times\sin\bigl(\alpha+\gamma+(\mu+\lambda)t\bigr), \end{aligned} \tag{1} $$

$$ \begin{aligned}
\frac{d\vartheta}{dt} = {}&\mu\mathfrak B\cos(\beta+\mu t)\\
 &+ \frac{\mu\mu(\mu-\lambda)a\mathfrak B\mathfrak C}{2\lambda(2\mu-\lambda)f}\\
 &\quad\times\sin\bigl(\beta-\gamma+(\mu-\lambda)t\bigr)\\
 &+ \frac{\mu\mu(\mu+\lambda)a\mathfrak B\mathfrak C}{2\lambda(2\mu+\lambda)f}\\
 &\quad\times\sin\bigl(\beta+\gamma+(\mu+\lambda)t\bigr), \end{aligned} \tag{2} $$

$$ \frac{d\omega}{dt} = \lambda\mathfrak C\cos(\gamma+\lambda t). \tag{3} $$

With that, he says, the whole solution of this most difficult problem has been happily brought to its end.

The differentiation is right in every term. It makes the two side tones more unequal than they were: each is
multiplied by its own frequency, the slower by $\mu - \lambda$, the faster by $\mu + \lambda$. In the angle
the slower was the stronger; in the velocity, by the factors

$$ \frac{\mu-\lambda}{2\mu-\lambda} \;<\; \tfrac12 \;<\; \frac{\mu+\lambda}{2\mu+\lambda}, \tag{A} $$

the faster is, and it remains so, whatever the signs, as long as $\lambda < \mu\sqrt2$. That is why $K$ comes
into the angles of {{sec balance.26}} with one sign and into the velocities with the other.

::: margin
Today: the velocities belong to the state; an equation of the second order is one of the first for both.
:::

Whether it is the end may be doubted. The formulae solve {{sec balance.16}} but for what is of the third
order of the angles; yet those equations lack terms of the second ({{sec balance.13}}). So the angles are
right to the first order only, and what the side tones add is of the order of what is missing.

## The program

One function gives angles and velocities; it is shown in {{sec balance.17}}. Here all six constants are free.
*/

const Unit per_second{"1/s"};
const auto lambda =
    real("lambda", 1, per_second, closed(1e-100, 1e6), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, per_second, closed(1e-6, 1e6), "frequency of the pans, μ = √(2g/b)");
const auto a = real("a", 16. / 9, feet, scale, "half the beam");
const auto g = real("g", 16, feet, scale, "height fallen in the first second");
const auto A = angle("A", 1. / 6, closed(-90_deg, 90_deg), "amplitude 𝔄 of the pan P");
const auto B = angle("B", 0.1, closed(-90_deg, 90_deg), "amplitude 𝔅 of the pan Q");
const auto C = angle("C", 1. / 6, closed(-90_deg, 90_deg), "amplitude ℭ of the beam");
const auto alpha = angle("alpha", 40_deg, closed(-360_deg, 360_deg), "phase α of the pan P");
const auto beta = angle("beta", 110_deg, closed(-360_deg, 360_deg), "phase β of the pan Q");
const auto gamma = angle("gamma", 75_deg, closed(-360_deg, 360_deg), "phase γ of the beam");
const auto t = real("t", 2, seconds, closed(0, 1e6), "time");
const auto rho = real("rho", 0.25, none, closed(0, 0.45), "Laa/I, which Euler's formulae do not contain");

double i()
{
  return i_of<double>(lambda, mu, a, g);
}

State<> motion(double part, double time)  // all amplitudes reduced to a part
{
  return general<double>(lambda, mu, i(), {part * A, part * B, part * C, alpha, beta, gamma}, time);
}

TELL
{
  const Fifty l = lambda.fifty(), u = mu.fifty(), i_ = i_of<Fifty>(l, u, a.fifty(), g.fifty());
  require(l != 2 * u, "lambda", "not 2 mu, where M is infinite");
  const auto [M, N] = sidebands<Fifty>(l, u, i_, A.fifty(), C.fifty());
  const Constants<Fifty> k{A.fifty(), B.fifty(), C.fifty(), alpha.fifty(), beta.fifty(), gamma.fifty()};
  const State<Fifty> now = general(l, u, i_, k, t.fifty());  // as they are written
  tell("M", double(M), radians, "M of the pan P (§17)");
  tell("N", double(N), radians, "N of the pan P");
  tell("eta", double(now.at.eta), radians, "η at the time t");
  tell("theta", double(now.at.theta), radians, "ϑ");
  tell("omega", double(now.at.omega), radians, "ω");
  tell("eta_rate", double(now.rate.eta), per_second, "dη/dt, (1)");
  tell("theta_rate", double(now.rate.theta), per_second, "dϑ/dt, (2)");
  tell("omega_rate", double(now.rate.omega), per_second, "dω/dt, (3)");
}

/*!
What the formulae are worth is seen beside the full equations, begun in the same state. If the amplitudes are
reduced, what is missing falls with their square.
*/

Balance<> full_numbers()
{
  return {lambda * lambda, mu * mu, 2 * i() / lambda, rho};
}

const auto moderate = [] {  // such that the full equations need not be followed for ever
  const double arm = 2 * i() / lambda;
  const bool angles = std::abs(A) < 0.5 && std::abs(B) < 0.5 && std::abs(C) < 0.5;
  return angles && arm > 0.01 && arm < 2 && lambda > 0.05 * mu && lambda < 1.9 * mu && mu * t < 300;
};

TELL
{
  if(moderate())
  {
    auto& rows = table("missing", "By how much the full equations depart from the formulae at the time t",
                       {{"part", "amplitudes"},
                        {"eta", "in η", arcminutes, 4},
                        {"theta", "in ϑ", arcminutes, 4},
                        {"omega", "in ω", arcminutes, 4}});
    for(const double part : {1., 0.1, 0.01})
    {
      const Angles<> full = Motion(full_numbers(), motion(part, 0)).to(t).at, his = motion(part, t).at;
      rows.row({part, full.eta - his.eta, full.theta - his.theta, full.omega - his.omega});
    }
  }
}

/*!
{{table missing}}

## Speed against error

A derivative can be had without differentiating. The quotient of differences asks for a small step and then
subtracts what is nearly equal. If the formula for η can take a complex time, one evaluation with the time
$t + h\sqrt{-1}$ gives the velocity as the imaginary part over $h$, and nothing is subtracted.
*/

template <class Number>
Number pan(const Number& time)  // §17
{
  using std::cos;
  using std::sin;
  const auto [M, N] = sidebands<double>(lambda, mu, i(), A, C);
  return double(A) * sin(double(alpha) + double(mu) * time)
         + M / 2 * cos(double(alpha - gamma) + (mu - lambda) * time)
         + N / 2 * cos(double(alpha + gamma) + (mu + lambda) * time);
}

double forward(double h)
{
  return (pan<double>(t + h) - pan<double>(t)) / h;
}

double central(double h)
{
  return (pan<double>(t + h) - pan<double>(t - h)) / (2 * h);
}

double complex_step(double h)
{
  return pan<std::complex<double>>({t, h}).imag() / h;
}

Fifty rate()  // of the numbers that the program has
{
  const Constants<Fifty> k{A.fifty(), B.fifty(), C.fifty(), alpha.fifty(), beta.fifty(), gamma.fifty()};
  const Fifty l = lambda.fifty(), u = mu.fifty();
  return general<Fifty>(l, u, i_of<Fifty>(l, u, a.fifty(), g.fifty()), k, t.fifty()).rate.eta;
}

TELL
{
  if(moderate() && abs(rate()) > 1e-6 * mu * std::abs(A))
    race("velocity", "dη/dt", rate(),
         {{"one-sided difference, h = 10⁻⁸/μ", [] { return forward(1e-8 / mu); }},
          {"central difference, h = 10⁻⁵/μ", [] { return central(1e-5 / mu); }},
          {"complex step, h = 10⁻³⁰/μ", [] { return complex_step(1e-30 / mu); }},
          {"(1)", [] { return motion(1, t).rate.eta; }}});
  curve("steps", {"h", "one_sided", "central", "complex"}, [](Curve& out) {
    const double right = double(rate()), size = std::max(mu * std::abs(A), 1e-300);
    const auto off = [&](double got) { return std::max(std::abs(got - right) / size, 1e-17); };
    for(int j = 0; j <= 90; ++j)
    {
      const double h = std::pow(10, -15 + j / 6.);
      out.put({h, off(forward(h / mu)), off(central(h / mu)), off(complex_step(h / mu))});
    }
  });
}

/*!
::: figure balance-20
alt: Errors of three ways to a derivative against the step, both logarithmic. Either kind of differences makes
a V: their errors fall with the step at first and rise again when it is too small. The complex step falls
like the central difference and then stays at the bottom.

The error of dη/dt against the step $h$, in units of 1/μ. Differences err on both sides of a best step; the
complex step has none too small.
:::

## Checks
*/

Fifty typed(int side, const Fifty& T)  // §§17, 18 as they stand, with f
{
  const Fifty l = lambda.fifty(), u = mu.fifty(), f = 2 * g.fifty() / (l * l);
  const Fifty own = side > 0 ? A.fifty() : B.fifty(), from = side > 0 ? alpha.fifty() : beta.fifty();
  const Fifty half = side * u * u * a.fifty() * own * C.fifty() / (2 * l * f);
  return own * sin(from + u * T) + half / (2 * u - l) * cos(from - gamma.fifty() + (u - l) * T)
         + half / (2 * u + l) * cos(from + gamma.fifty() + (u + l) * T);
}

CHECK_THAT("the angles are those of §§ 17 and 18, and the velocities their changes, by differences in "
           "fifty digits")
{
  for(const Told& now :
      told_at("", "lambda=0.02 mu=5 a=0.7 A=3 B=-80 C=-7 alpha=-200 beta=9 gamma=311 t=1234.5",
              "lambda=1.9999999 mu=1 A=1e-9 B=30 t=7", "lambda=1e-100 t=1e5",
              "lambda=9 mu=2 a=3e40 g=1e40 gamma=10 t=0.3", "A=0 B=1e-300rad t=1e6"))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty(), T = t.fifty(), h = Fifty("1e-17") / u;
    const Fifty i2 = l * u * u * a.fifty() * A.fifty() * C.fifty() / (2 * g.fifty());
    const char* const once = "one rounding";
    CHECK(now.value("M", radians) == within_ulps(i2 / (2 * u - l), 1, once));
    CHECK(now.value("N", radians) == within_ulps(i2 / (2 * u + l), 1, once));
    CHECK(now.value("eta", radians) == within_ulps(typed(1, T), 1, once));
    CHECK(now.value("theta", radians) == within_ulps(typed(-1, T), 1, once));
    const auto rate_of = [&](int side) {
      return Fifty((typed(side, T + h) - typed(side, T - h)) / (2 * h));
    };
    CHECK(now.value("eta_rate", per_second)
          == within_relative(rate_of(1), 1e-15, "one rounding, differences"));
    CHECK(now.value("theta_rate", per_second) == within_relative(rate_of(-1), 1e-15, "the same"));
    CHECK(now.value("omega", radians) == within_ulps(C.fifty() * sin(gamma.fifty() + l * T), 1, once));
    const Fifty back = gamma.fifty() + l * T;
    CHECK(now.value("omega_rate", per_second)
          == within_relative(C.fifty() * (sin(back + Fifty("1e-20")) - sin(back - Fifty("1e-20")))
                                 / Fifty("2e-20") * l,
                             1e-15, "one rounding, differences"));
  }
}

CHECK_THAT("the program refuses λ = 2μ, and not what is next to it")
{
  CHECK(refused_at("lambda=6"));
  CHECK(refused_at("lambda=1 mu=0.5"));
  CHECK(!refused_at("lambda=5.9999999999999991"));
  CHECK(!refused_at("lambda=6.0000000000000009"));
}

CHECK_THAT("the table ends where angles, arm, time or the ratio of the frequencies are no more moderate")
{
  for(const Told& now :
      told_at("A=28.6 B=-28.6 C=28.6", "a=7.1", "a=0.036", "lambda=0.151", "lambda=5.69", "t=99"))
    CHECK(now.rows("missing").size() == 3);
  for(const Told& now :
      told_at("A=28.7", "B=-28.7", "C=28.7", "a=7.2", "a=0.035", "lambda=0.149", "lambda=5.71", "t=101"))
    CHECK_THROWS(now.rows("missing"));
}

CHECK_THAT("the formulae miss the full equations, here by GSL, by the square of the amplitudes")
{
  for(const Told& now :
      told_at("", "lambda=0.7 mu=2 a=3 A=5 B=-10 C=12 rho=0.4 t=9", "mu=1.3 gamma=200 t=20"))
    for(const auto& row : now.rows("missing"))
    {
      const double part = row.at("part");
      CHECK(row.value("part") == between(0.01, 1, "the rows' own"));
      const auto missed = [](double s) {
        const Angles<> full = by_gsl(full_numbers(), motion(s, 0), t, 1e-14).at;
        return Angles<Fifty>{
            Fifty(full.omega) - C.fifty() * s * sin(gamma.fifty() + lambda.fifty() * t.fifty()),
            Fifty(full.eta) - motion(s, t).at.eta, Fifty(full.theta) - motion(s, t).at.theta};
      };
      const Angles<Fifty> right = missed(part), smaller = missed(part / 10);
      const char* const why = "GSL's tolerance, step by step";
      CHECK(row.value("eta", arcminutes) == within(right.eta, 3e-12, why));
      CHECK(row.value("theta", arcminutes) == within(right.theta, 3e-12, why));
      CHECK(row.value("omega", arcminutes) == within(right.omega, 3e-12, why));
      if(part < 1)
        CHECK(right.eta
              == within(100 * smaller.eta, 0.05 * part * part * part, "a third order, of angles below ¼"));
    }
}

CHECK_THAT("differences lose half of the digits or a third; the complex step and (1) lose none")
{
  for(const Told& now : told_at("", "lambda=0.7 mu=2 a=3 A=5 C=12 t=9", "mu=1.3 gamma=200 t=20 A=-3"))
  {
    const Fifty T = t.fifty(), h = Fifty("1e-17") / mu.fifty(),
                right = (typed(1, T + h) - typed(1, T - h)) / (2 * h);
    const double size = std::abs(A) * mu, phase = 1e-15 * (2 + mu * t);
    CHECK(now.exact("velocity") == within(right, size * 1e-30, "differences in fifty digits"));
    CHECK(now.method("velocity", "one-sided difference, h = 10⁻⁸/μ")
          == within(right, size * (2e-8 + 1e8 * phase), "½h of the next derivative, roundings over h"));
    CHECK(now.method("velocity", "central difference, h = 10⁻⁵/μ")
          == within(right, size * (1e-10 + 1e5 * phase), "a sixth of h², roundings over h"));
    CHECK(now.method("velocity", "complex step, h = 10⁻³⁰/μ")
          == within(right, size * phase, "the phases'"));
    CHECK(now.method("velocity", "(1)") == within(right, size * phase, "the phases'"));
  }
}

CHECK_THAT("in the figure the errors are of the order that the step has, and of that of roundings below")
{
  for(const Told& now : told_at(""))
  {
    const Fifty T = t.fifty(), u = mu.fifty(), tiny = Fifty("1e-14") / u;
    const Fifty second = (typed(1, T + tiny) - 2 * typed(1, T) + typed(1, T - tiny)) / (tiny * tiny);
    const Fifty size = abs(A.fifty()) * u;
    for(const auto& point : now.points("steps", 31))
    {
      const double h = point.at("h");
      const double half = double(abs(second) / u / size / 2) * h, rounding = 2e-16;
      CHECK(point.value("complex") == between(1e-17, h * h + 1e-15, "a sixth of the third derivative"));
      CHECK(point.value("central") == between(1e-17, h * h + 7 * rounding / h, "the same, and roundings"));
      CHECK(point.value("one_sided") == between(1e-17, 1.2 * half + h * h + 7 * rounding / h, "½h of η̈"));
      if(h > 1e-6 && h < 1e-2)
        CHECK(point.value("one_sided") == within_relative(half, 0.1, "½h of η̈ alone"));
      if(h < 1e-8)
        CHECK(point.value("complex") == between(1e-17, 2e-15, "at the bottom"));
    }
  }
}

CHECK_THAT(
    "(A): in the velocity the faster tone is the stronger for every beam slower than μ√2, and not beyond")
{
  const auto slower = [](const Rational& r) {  // its strength, without the sign
    return r < Rational(1) ? (1 - r) / (2 - r) : (r - 1) / (2 - r);
  };
  for(const Rational& r : {Rational(1, 1000), Rational(1, 3), Rational(1), Rational(141, 100)})  // λ:μ
  {
    CHECK(slower(r) < (1 + r) / (2 + r));
    CHECK((1 - r) / (2 - r) < Rational(1, 2));
    CHECK((1 + r) / (2 + r) > Rational(1, 2));
    CHECK(1 / (2 - r) > 1 / (2 + r));
  }
  for(const Rational& r : {Rational(142, 100), Rational(19, 10)})
    CHECK(slower(r) > (1 + r) / (2 + r));
}
