#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/asked.hpp"
#include "globe/ball.hpp"
#include "globe/oracle.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 16, "Case II: just the velocity for the top")

using namespace globe;

/*!
## What Euler does

There is another case that can be worked out: a centre of gravity very near the centre, and just the
velocity that takes away the second root. If the distance $c$ of the two centres is very small, one may
write

$$ \sqrt{kk + cc\sin^2\Phi} = k + \frac{cc}{2k}\sin^2\Phi, \tag{1} $$

and the formula of {{sec globe.13}} becomes

$$ dt = \frac{d\Phi\,\bigl(k + \frac{cc}{2k}\sin^2\Phi\bigr)}
   {\sqrt{\zeta\zeta kk - 4gc(1-\cos\Phi)}}. \tag{2} $$

To make the denominator tractable too, let ζ be so taken that

$$ \zeta\zeta kk = 8gc, \qquad \zeta = \frac{\sqrt{8gc}}k; \tag{3} $$

this is the angular velocity impressed at the beginning. Then

$$ \begin{aligned} &\sqrt{\zeta\zeta kk - 4gc(1-\cos\Phi)} \\ &\quad = \sqrt{4gc(1+\cos\Phi)} \\
   &\quad = \cos\tfrac12\Phi\,\sqrt{8gc}, \end{aligned} \tag{4} $$

$$ dt\,\sqrt{8gc} = \frac{d\Phi}{\cos\frac12\Phi}\Bigl(k + \frac{cc}{2k}\sin^2\Phi\Bigr), \tag{5} $$

which is freed of every irrationality. In our copy the condition names the distance by the capital letter
of the centre.

::: margin
Today: $h = 1$, the separatrix, the motion that parts rocking from turning over.
:::

What {{eq 3}} means Euler finds only in {{sec globe.18}}: it is the velocity with which the ball would
just come to stand with $G$ upright over $C$, if it had time without end. The two conditions have nothing
to do with each other. The velocity must be right to the last digit: with a ζ that is less by the part
$\varepsilon$ of itself the ball turns back while it lacks of the top

$$ \psi = 2\arcsin\sqrt{2\varepsilon - \varepsilon\varepsilon}. \tag{A} $$

The smallness of $c$, on the other hand, can be spared, since {{eq 4}} alone makes the integral elliptic
({{sec globe.17}}); and where it is used, {{eq 1}} errs in one direction. With $X = cc\sin^2\Phi:kk$ it is
too great by the part

$$ \begin{aligned} &\frac{1+\frac12X}{\sqrt{1+X}} - 1 \\
   &= \frac{XX}{4\sqrt{1+X}\,(1+\frac12X+\sqrt{1+X})}, \end{aligned} \tag{B} $$

which is less than $\frac18XX$. So each step of the time, and the time itself, comes out a little too long.

The plane holds the ball in this motion, whatever $c$ is. By {{sec globe.10}} the pressure comes to

$$ \frac\Pi P = \frac{kk\,\bigl(kk + cc(1+\cos\Phi)^2\bigr)}{(kk + cc\sin^2\Phi)^2}, \tag{C} $$

all of it positive.

## The program

The place may be given by Φ or by what it lacks of the top, where {{eq 5}} becomes infinite.
*/

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto where = asked_place(60_deg);
const auto epsilon = real("epsilon", 1e-6, none, closed(1e-100, 0.5), "the part by which ζ is missed");

/// √(kk + cc sin²Φ) over k, and (1), which is more.
struct Roots
{
  double exact;  ///< √(1 + X)
  double euler;  ///< 1 + X:2
  double more;   ///< (B)
};

Roots roots(double X)
{
  const double root = std::sqrt(1 + X), sum = 1 + X / 2;
  return {root, sum, X / (sum + root) * (X / root) / 4};  // (1), (B)
}

double square(const Place<double>& there)  // X
{
  const double sine = 2 * (c / k) * there.s * there.c;
  return sine * sine;
}

TELL
{
  require(c <= 1e6 * k, "c", "between 1e-40 and a million times k");
  require(k <= 1e40 * c, "c", "between 1e-40 and a million times k");
  const auto there = rounded(where.fifty());
  const double X = square(there), second = std::sqrt(8 * g) * std::sqrt(c), r = c / k;
  const double up = 2 * r * there.c * there.c;  // c(1 + cos Φ):k
  tell("zeta", second / k, Unit{"1/s"}, "ζ, the velocity of (3)");
  tell("rate", k * (roots(X).exact / there.c) / second, Unit{"s/rad"}, "dt:dΦ at Φ, exactly");
  tell("rate_euler", k * (roots(X).euler / there.c) / second, Unit{"s/rad"}, "by (5)");
  tell("more", roots(X).more, percent, "by how much (5) is too great");
  tell("most", roots(r * r).more, percent, "by how much it is at 90°");
  tell("pressure", (1 + up * up) / (1 + X) / (1 + X), "Π/P there");
  tell("short_by", 2 * std::asin(std::sqrt(epsilon * (2 - epsilon))), degrees,
       "what the ball lacks of the top where it turns back, if ζ is less by the part ε");
}

TELL
{
  curve("too_great", {"Phi", "this_ball", "half", "equal"}, [](Curve& too_great) {
    for(int Phi = 2; Phi <= 178; Phi += 2)
    {
      const double sine = std::sin(Phi * 1_deg), r = c / k;
      too_great.put({double(Phi), roots(r * r * sine * sine).more, roots(sine * sine / 4).more,
                     roots(sine * sine).more});
    }
  });
}

/*!
For our ball ζ is {{zeta|6}}. At 60° {{eq 5}} is too great by {{more|3}}, and at 90°, where it is worst,
by {{most|3}}. The velocity is the harder condition: let ζ be less by a millionth, and the ball turns back
{{short_by|4}} before the top.

::: figure globe-16
alt: Relative error of Euler's root against the angle, with a logarithmic scale, for three balls: three
arches, highest at 90 degrees, that of c = k near six per cent, that of this ball near a hundredth of a
per cent.

By which part {{eq 1}} is too great, against Φ: for this ball (blue), $c = \frac12k$ and $c = k$. At the
top and at the lowest place it is exact.
:::

## Speed against error

How many terms of the binomial expansion does the root want? They are asked for $\sqrt{1+X}$; ask for `--c
0.7`, where the expansion has no end.
*/

TELL
{
  const double X = square(rounded(where.fifty()));
  std::vector<Method> ways;
  for(int many = 2; many <= 5; ++many)
    ways.push_back({std::to_string(many) + " terms",
                    [=] {
                      double sum = 0;  // from the last term inwards
                      for(int n = many - 1; n > 0; --n)
                        sum = (1 + sum) * X * (1.5 - n) / n;
                      return 1 + sum;
                    },
                    "binomial"});
  ways.push_back({"the root", [=] { return std::sqrt(1 + X); }});
  const Place<Fifty> there = where.fifty();
  race("root", "√(1+X)", sqrt(1 + pow(2 * c.fifty() / k.fifty() * there.s * there.c, 2)), ways);
}

/*!
## Checks

The motion itself, by the equations of {{sec globe.06}} and {{sec globe.07}}, is to have the velocity of
{{eq 5}}.
*/

CHECK_THAT("started with the ζ told, the ball of the equations of motion turns at Φ with the rate told")
{
  for(const Told& now : told_at("", "Phi=150 c=0.4", "psi=0.01 k=0.3 g=1"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), second = sqrt(2 * g_ * c_);
    const Ball<Fifty> ball{c_ + k_, c_, k_};
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1], accelerations<Fifty>(ball, g_, s[0], s[1], 0).Phi};
    };
    const Fifty zeta = sqrt(8 * g_ * c_) / k_;  // (3)
    const Fifty t = oracle::smooth_time(c_, k_, {1, 0}, where.fifty()) / second;
    const exact::State s = exact::solve(motion, 0, {0, zeta}, t).y;
    CHECK(s[0] == within(where.angle(), 1e-24, "some hundred steps of 1e-32, grown near the top"));
    CHECK(now.value("zeta", Unit{"1/s"})
          == within_relative(zeta, 1e-15, "five roundings, some of them halved"));
    CHECK(now.value("rate", Unit{"s/rad"}) == within_relative(1 / s[1], 4e-15, "a dozen roundings"));
    CHECK(now.value("pressure")
          == within_relative(accelerations<Fifty>(ball, g_, s[0], s[1], 0).pressure, 4e-15,
                             "a dozen roundings"));
  }
}

CHECK_THAT("the rates told are those of (5) and of the root, their difference (B), at every scale")
{
  for(const Told& now : told_at("", "psi=1e-30 c=3", "Phi=1e-20 c=1e-12 epsilon=1e-30",
                                "c=1e-30 epsilon=0.5", "c=100 k=1 g=1e-90 Phi=120"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty();
    const Place<Fifty> there = where.fifty();
    const Fifty root = sqrt(k_ * k_ + pow(2 * c_ * there.s * there.c, 2)),
                bottom = there.c * sqrt(8 * g_ * c_);
    const Fifty X = pow(2 * c_ / k_ * there.s * there.c, 2);
    const char* const because = "a dozen roundings";
    CHECK(now.value("zeta", Unit{"1/s"}) == within_relative(sqrt(8 * g_ * c_) / k_, 1e-15, because));
    CHECK(now.value("rate", Unit{"s/rad"}) == within_relative(root / bottom, 4e-15, because));
    CHECK(now.value("rate_euler", Unit{"s/rad"})
          == within_relative((k_ + 2 * pow(c_ * there.s * there.c, 2) / k_) / bottom, 4e-15,
                             because));  // (5)
    // (B): by the difference where fifty digits can bear it, else by its first term.
    const auto more = [](const Fifty& x) {
      return x > 1e-16 ? Fifty((1 + x / 2) / sqrt(1 + x) - 1) : Fifty(x * x / 8 * (1 - x));
    };
    CHECK(now.value("more", percent) == within_relative(more(X), 8e-15, because));
    CHECK(now.value("most", percent) == within_relative(more(pow(c_ / k_, 2)), 8e-15, because));
    CHECK(more(X) <= X * X / 8);
    const Fifty u = 2 * there.c * there.c - 1, D = k_ * k_ * (1 + X);
    CHECK(now.value("pressure")
          == within_relative(k_ * k_ * (k_ * k_ + pow(c_ * (1 + u), 2)) / (D * D), 8e-15, because));
    // What is left of h = 1 is 1 − (1 − ε)², the square of cos ½Φ where the ball turns back.
    const Fifty lack = 1 - pow(1 - epsilon.fifty(), 2);
    CHECK(now.value("short_by", degrees)
          == within_relative(2 * atan2(sqrt(lack), sqrt(1 - lack)), lack > 1e-20 ? 2e-15 : 1e-15, because));
  }
  for(const Told& now : told_at("Phi=180"))
  {
    CHECK(now.value("rate", Unit{"s/rad"}) == infinite("the ball does not get past the top"));
    CHECK(now.value("rate_euler", Unit{"s/rad"}) == infinite("nor by (5)"));
  }
}

CHECK_THAT("a c of a million times k is told of, and one of a part in 1e40; a hair beyond them is refused")
{
  for(const char* const within_them : {"c=1e6 k=1", "c=5e5 k=0.5", "c=1 k=1e40", "c=2 k=2e40"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"c=1000000.0000000002 k=1", "c=500000.0000000001 k=0.5",
                                  "c=0.9999999999999998 k=1e40", "c=1.9999999999999996 k=2e40"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("(4) holds for the ζ of (3) at every angle, and for no other velocity")
{
  for(const double Phi : {0., 1., 2., 3., 3.1415})
  {
    const Fifty half = cos(Fifty(Phi) / 2), fall = 4 * (1 - cos(Fifty(Phi)));  // g = c = 1
    CHECK(sqrt(8 - fall)
          == within(half * sqrt(Fifty(8)), 1e-42, "fifty digits, half of them lost near the top"));
    if(Phi > 0)
      CHECK(sqrt(8.1 - fall) > half * sqrt(Fifty(8.1)));
  }
}

CHECK_THAT("in the race each way gives what the expansion gives in fractions")
{
  const std::array<Fifty, 5> binomial{1, Fifty(1) / 2, -Fifty(1) / 8, Fifty(1) / 16, -Fifty(5) / 128};
  for(const Told& now : told_at("", "Phi=90 c=0.3", "Phi=90 c=0.7"))
  {
    const Fifty X = pow(c.fifty() / k.fifty() * sin(where.angle()), 2);
    CHECK(now.exact("root") == within_relative(exp(log(1 + X) / 2), 1e-45, "another way of fifty digits"));
    CHECK(now.method("root", "the root") == within_relative(exp(log(1 + X) / 2), 4e-16, "X is rounded"));
    Fifty sum = 1 + X / 2, power = X;
    for(std::size_t many = 2; many <= 5; ++many)
    {
      CHECK(now.method("root", std::to_string(many) + " terms")
            == within(sum, 2e-15 * double(1 + power), "some roundings of the greatest summand"));
      power *= X;
      if(many < 5)
        sum += binomial[many] * power;
    }
  }
}

CHECK_THAT("the errors drawn are the quotient of the two roots, less one, and worst at 90°")
{
  for(const Told& now : told_at("", "c=0.5"))
  {
    double greatest = 0, worst = 0;
    for(const auto& point : now.points("too_great"))
      if(point.at("this_ball") > greatest)
        greatest = point.at("this_ball"), worst = point.at("Phi");
    CHECK(worst == within(90, 0, "one of the angles drawn"));
    for(const auto& point : now.points("too_great", 7))
    {
      const Fifty ss = pow(sin(point.at("Phi") * exact::pi() / 180), 2), r = c.fifty() / k.fifty();
      const auto more = [](const Fifty& x) { return Fifty((1 + x / 2) / sqrt(1 + x) - 1); };
      CHECK(point.value("Phi") == between(2, 178, "up to the top"));
      // An ulp of π moves the sine of 178° by 28 ulps, and (B) by four times that.
      CHECK(point.value("this_ball") == within_relative(more(r * r * ss), 3e-14, "an ulp of the angle"));
      CHECK(point.value("half") == within_relative(more(ss / 4), 3e-14, "an ulp of the angle"));
      CHECK(point.value("equal") == within_relative(more(ss), 3e-14, "an ulp of the angle"));
    }
  }
}

/*!
## Go on from here

::: exercise
How much does the plane bear in this motion at the lowest place, and how much at the top? Is it ever less than
the weight?
answer: By {{eq C}} it bears $1 + 4cc:kk$ at the lowest place and just the weight at the top; between
them, say at 120°, it is less than the weight for every $c$, but never nothing.
:::
*/

CHECK_THAT("at the lowest place the plane bears 1 + 4cc:kk, at the top 1, at 120° less than the weight")
{
  for(const double r : {0.01, 1. / 6, 1., 50.})
  {
    const auto bears = [&](const Fifty& Phi) {
      const Fifty w =
          2 * cos(Phi / 2) * sqrt(2 * Fifty(r)) / sqrt(1 + pow(r * sin(Phi), 2));  // k = 1, g = 1
      return accelerations<Fifty>(Ball<Fifty>{r + 1, r, 1}, 1, Phi, w, 0).pressure;
    };
    CHECK(bears(0) == within_relative(1 + 4 * Fifty(r) * r, 1e-45, "fifty digits"));
    CHECK(bears(exact::pi()) == within(1, 1e-45, "fifty digits"));
    CHECK(bears(2 * exact::pi() / 3) < 1);
    CHECK(bears(2 * exact::pi() / 3) > 0);
  }
}
