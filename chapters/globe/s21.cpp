#include "edition/section.hpp"
#include "exact/ode.hpp"
#include "globe/ball.hpp"
#include "globe/oracle.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 21, "Case III: fast turning")

using namespace globe;

/*!
## What Euler does

If the ball turns very fast, both roots of the formula for the time can be expanded, and what remains are the
squares of two sines. In this third case let

$$ \zeta\zeta kk = nn \cdot 4gc, \tag{1} $$

$n$ being a very great number. The denominator of the formula of {{sec globe.13}} becomes

$$ \begin{aligned} &\sqrt{\zeta\zeta kk - 4gc(1-\cos\Phi)} \\
   &\quad = 2\sqrt{gc\,(nn - (1-\cos\Phi))} \\
   &\quad = 2\sqrt{gc\,(nn - 2\sin^2\tfrac12\Phi)}, \end{aligned} \tag{2} $$

and it is to be noted that $\zeta = \dfrac{2n}k\sqrt{gc}{{entry two}}$. With the expansion of
{{sec globe.16}} in the numerator, for $cc$ is still supposed infinitely small against $kk$,

$$ 2\,dt\sqrt{gc} = \frac{d\Phi}{\sqrt{nn - 2\sin^2\frac12\Phi}}
   \Bigl(k + \frac{cc}{2k}\sin^2\Phi\Bigr). \tag{3} $$

Since $n$ is very great, there will be exactly enough

$$ \frac1{\sqrt{nn - 2\sin^2\frac12\Phi}} = \frac1n + \frac{\sin^2\frac12\Phi}{n^3}{{entry cube}}, \tag{4} $$

and with this value

$$ \begin{aligned} &2n\,dt\sqrt{gc} \\
   &= d\Phi\Bigl(k + \frac{cc}{2k}\sin^2\Phi\Bigr)\Bigl(1 + \frac{\sin^2\frac12\Phi}{nn}\Bigr) \\
   &= d\Phi\Bigl(k + \frac{cc}{2k}\sin^2\Phi + \frac k{nn}\sin^2\tfrac12\Phi\Bigr), \end{aligned} \tag{5} $$

where the member

$$ \frac{cc}{2nnk}\sin^2\tfrac12\Phi\,\sin^2\Phi \tag{6} $$

has been neglected, since it is small twice over. In our copy a letter r stands for the numerators 1 of
{{eq 4}}.

::: margin
Today: $nn = 2h$, where $h$ is the energy over that of the top, as in {{sec globe.13}}.
:::

Is {{eq 6}} all that has been neglected? Write $X = cc\sin^2\Phi : kk$ and $Y = 2\sin^2\frac12\Phi : nn$. Then
the true factor of $k\,d\Phi$ and Euler's are

$$ \begin{aligned} &\frac{\sqrt{1+X}}{\sqrt{1-Y}} = 1 + \tfrac12X + \tfrac12Y \\
   &\quad + \tfrac14XY + \tfrac38YY - \tfrac18XX + \dots \end{aligned} \tag{A} $$

His {{eq 6}} is the $\frac14XY$. But $X$ and $Y$ were each expanded to the first power only, and the squares
that went out there are small twice over as well. Over a whole turn the three come, on the average, to

$$ \frac{cc}{8nnkk}, \qquad \frac9{16n^4}, \qquad -\frac{3c^4}{64k^4}. \tag{B} $$

The second is greater than the first wherever $nn < 9kk : 2cc$. Now by {{sec globe.20}} the ball stays on its
plane only if $nn \le 2 + kk : 2cc$, and that is less than $9kk : 2cc$ for every $c$ below $k\sqrt2$. So for
any ball to which this case could be applied the term that Euler names is less, on the average, than one
that he passes over in silence.

## The program

What {{eq 5}} lacks is told without any cancellation. With $S = \frac12(X+Y)$ the difference of the squares of
the two members is $S\,(\frac12(3Y-X) + YS)$ over $1 - Y$.
*/

/// The factor of k dΦ in 2n dt√gc.
struct Factor
{
  double exact;  ///< √(1 + X) over √(1 − Y), where the roots are
  double euler;  ///< 1 + X:2 + Y:2
  double lacks;  ///< exact less Euler's
};

Factor factor(double X, double Y)
{
  const double S = (X + Y) / 2, exact = std::sqrt(1 + X) / std::sqrt(1 - Y), euler = 1 + S;  // (5)
  return {exact, euler, S * ((3 * Y - X) / 2 + Y * S) / (1 - Y) / (exact + euler)};
}

const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto n = real("n", 4, none, closed(1.5, 1e70), "ζk over 2√gc; below √2 the ball rocks");
const auto Phi = angle("Phi", 120_deg, closed(0_deg, 180_deg), "angle turned from the lowest place");

double shape()  // cc:kk
{
  return c / k * (c / k);
}

double X_at(const Fifty& angle)  // its sine is small near the top
{
  const double sine = double(sin(angle));
  return shape() * sine * sine;
}

double Y_at(double angle, double speed)
{
  const double s = std::sin(angle / 2) / speed;
  return 2 * s * s;
}

Fifty beyond()  // by how much h = ½nn is greater than §20 allows
{
  const Fifty r = k.fifty() / c.fifty();
  return n.fifty() * n.fifty() / 2 - 1 - r * r / 4;
}

TELL
{
  require(c <= k, "c", "at most k: it is to be small");
  require(k <= 1e40 * c, "c", "at least 1e-40 of k");
  const double X = X_at(Phi.fifty()), Y = Y_at(Phi, n), nn = n * n;
  const Factor now = factor(X, Y);
  tell("zeta", 2 * n / k * std::sqrt(g) * std::sqrt(c), Unit{"1/s"}, "ζ, by (1)");
  tell("n_most", std::sqrt(2 + 0.5 / shape()),
       "the greatest n with which the ball stays on the plane, §20");
  if(beyond() > 0)
    tell("Phi_off", smooth::lift_off<double>(c, k, double(beyond())).Phi, degrees,
         "where it leaves it; what is told beyond is of a ball held down");
  tell("exact", k * now.exact, feet, "2n√gc dt:dΦ at Φ, with both roots");
  tell("euler", k * now.euler, feet, "the same by (5)");
  tell("lacks", now.lacks, percent, "by how much that is too small, over k");
  tell("named", X * Y / 4, percent, "of this the neglected member (6), over k");
  tell("silent", 3 * Y * Y / 8, percent, "the next term of (4), over k");
  tell("root", -X * X / 8, percent, "the next term of the numerator, over k");
  tell("mean_named", shape() / (8 * nn), percent, "the first of (B), on the average over a turn");
  tell("mean_silent", 9 / (16 * nn * nn), percent, "the second");
  tell("mean_root", -3 * shape() * shape() / 64, percent, "the third");
}

TELL
{
  curve("means", {"n", "silent", "named", "root"}, [](Curve& means) {
    for(int i = 0; i <= 100; ++i)
    {
      const double speed = 1.5 * std::pow(20, i / 100.), nn = speed * speed;
      means.put({speed, 9 / (16 * nn * nn), shape() / (8 * nn), 3 * shape() * shape() / 64});
    }
  });
  curve("limit", {"n"}, [](Curve& limit) { limit.put({std::sqrt(2 + 0.5 / shape())}); });
}

/*!
At {{Phi|3}} with $n = 4$ the formula {{eq 5}} is too small by {{lacks|4}} of $k$. Of this {{named|3}} is the
member that Euler neglects knowingly, and {{silent|3}} the next term of his expansion {{eq 4}}. On the average
over a turn they are {{mean_named|3}} and {{mean_silent|3}}.

::: figure globe-21
alt: Three lines against n, both logarithmic. The steepest falls as the fourth power of n, another as the
square, the third is level. The steep line, of the term that is not mentioned, is the highest of them till
well beyond an upright line, right of which the plane does not hold the ball.

What {{eq 5}} leaves out on the average over a turn, for this ball, as parts of the whole. Left of the
upright line the ball stays on the plane, and there the term that is not mentioned is the greater.
:::

## Speed against error

How far should the two expansions be taken? The ways are asked for the factor {{eq A}}, by all terms up to an
order in $X$ and $Y$ together. Ask for `--n 1.5`, or for `--n 100 --c 0.01`.
*/

const std::array<double, 5> upper{1, 1. / 2, -1. / 8, 1. / 16, -5. / 128};  // of √(1+X)
const std::array<double, 5> lower{1, 1. / 2, 3. / 8, 5. / 16, 35. / 128};   // of 1/√(1−Y)

double by_order(double X, double Y, std::size_t order)
{
  double sum = 0, x = 1;
  for(std::size_t i{0}; i <= order; ++i, x *= X)
  {
    double inner = 0;
    for(std::size_t j = order - i + 1; j-- > 0;)
      inner = inner * Y + lower[j];
    sum += upper[i] * x * inner;
  }
  return sum;
}

TELL
{
  const double X = X_at(Phi.fifty()), Y = Y_at(Phi, n);
  std::vector<Method> ways;
  for(std::size_t order{1}; order <= 4; ++order)
    ways.push_back(
        {"order " + std::to_string(order), [=] { return by_order(X, Y, order); }, "expanded, (A)"});
  ways.push_back({"the roots", [=] { return std::sqrt((1 + X) / (1 - Y)); }});
  const Fifty r = c.fifty() / k.fifty() * sin(Phi.fifty()), s = sin(Phi.fifty() / 2) / n.fifty();
  race("factor", "√(1+X):√(1−Y)", sqrt((1 + r * r) / (1 - 2 * s * s)), ways);
}

/*!
## Checks

The factor is held against the ball of the equations of motion ({{sec globe.06}}, {{sec globe.07}}): let it
start with the ζ told, and look how fast it turns at Φ.
*/

CHECK_THAT(
    "the ball of the equations of motion, started with the ζ told, turns at Φ with the exact rate told")
{
  for(const Told& now : told_at("", "n=1.5 c=0.5 Phi=180", "n=20 c=0.02 g=1 Phi=75"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), n_ = n.fifty();
    const Ball<Fifty> ball{c_ + k_, c_, k_};
    const auto motion = [&](const Fifty&, const exact::State& s) {
      return exact::State{s[1], accelerations<Fifty>(ball, g_, s[0], s[1], 0).Phi};
    };
    const Fifty at = Phi.fifty(), zeta = 2 * n_ * sqrt(g_ * c_) / k_;
    const Place<Fifty> there{sin(at / 2), cos(at / 2)};
    const Fifty t = oracle::smooth_time(c_, k_, energy(Fifty(n_ * n_ / 2)), there) / sqrt(2 * g_ * c_);
    const exact::State s = exact::solve(motion, 0, {0, zeta}, t).y;
    CHECK(s[0] == within(at, 1e-28, "some hundred steps of 1e-32"));
    CHECK(now.value("zeta", Unit{"1/s"}) == within_relative(zeta, 1e-15, "six roundings"));
    CHECK(now.value("exact", feet)
          == within_relative(2 * n_ * sqrt(g_ * c_) / s[1], 2e-15, "a dozen roundings"));
  }
}

CHECK_THAT("the two factors, what one lacks of the other, and the terms are those of fifty digits")
{
  const char* const because = "a dozen roundings";
  for(const Told& now : told_at("", "n=1.5 c=0.6 Phi=179.9999", "n=1e8 c=1e-12 Phi=90",
                                "n=1e70 c=1e-30 Phi=1e-3", "n=7 Phi=0"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), n_ = n.fifty(), at = Phi.fifty(), r = c_ / k_;
    const Fifty X = pow(r * sin(at), 2), Y = 2 * pow(sin(at / 2) / n_, 2);
    const Fifty euler = k_ + c_ * c_ / (2 * k_) * pow(sin(at), 2) + k_ * Y / 2;  // (5)
    CHECK(now.value("zeta", Unit{"1/s"})
          == within_relative(sqrt(n_ * n_ * 4 * g.fifty() * c_) / k_, 1e-15, because));
    CHECK(now.value("n_most") == within_relative(sqrt(2 + k_ * k_ / (2 * c_ * c_)), 1e-15, because));
    CHECK(now.value("exact", feet) == within_relative(k_ * sqrt((1 + X) / (1 - Y)), 2e-15, because));
    CHECK(now.value("euler", feet) == within_relative(euler, 2e-15, because));
    // By the difference where fifty digits can bear it, else by the terms of the second order.
    const Fifty lacks = X + Y > 1e-15 ? Fifty(sqrt((1 + X) / (1 - Y)) - euler / k_)
                                      : Fifty(X * Y / 4 + 3 * Y * Y / 8 - X * X / 8);
    const double size = double((X + Y) * (X + 3 * Y));
    CHECK(now.value("lacks", percent)
          == within(lacks, 4e-15 * size * double(1 / (1 - Y)), "of the greatest of its summands"));
    CHECK(now.value("named", percent)
          == within_relative(c_ * c_ / (2 * n_ * n_ * k_ * k_) * pow(sin(at / 2) * sin(at), 2), 4e-15,
                             "a dozen roundings"));  // (6)
    CHECK(now.value("silent", percent) == within_relative(3 * Y * Y / 8, 4e-15, because));
    CHECK(now.value("root", percent) == within_relative(-X * X / 8, 4e-15, because));
    CHECK(now.value("mean_named", percent) == within_relative(r * r / (8 * n_ * n_), 2e-15, because));
    CHECK(now.value("mean_silent", percent) == within_relative(9 / (16 * pow(n_, 4)), 2e-15, because));
    CHECK(now.value("mean_root", percent) == within_relative(-3 * pow(r, 4) / 64, 2e-15, because));
  }
}

CHECK_THAT("(B) are the means of the three terms, and with (5) they are the true turn but for smaller ones")
{
  // Sines and cosines of at most four times the angle: the mean of sixteen values is exact.
  const auto mean = [](const auto& f) {
    Fifty sum = 0;
    for(int i = 0; i < 16; ++i)
      sum += f(i * exact::pi() / 8);
    return Fifty(sum / 16);
  };
  const Fifty nn = 16, q = Fifty(1) / 36;
  const auto X = [&](const Fifty& at) { return Fifty(q * pow(sin(at), 2)); };
  const auto Y = [&](const Fifty& at) { return Fifty(2 * pow(sin(at / 2), 2) / nn); };
  const char* const because = "sixteen sums of fifty digits";
  CHECK(mean([&](const Fifty& at) { return Fifty(X(at) * Y(at) / 4); })
        == within(q / (8 * nn), 1e-48, because));
  CHECK(mean([&](const Fifty& at) { return Fifty(3 * Y(at) * Y(at) / 8); })
        == within(9 / (16 * nn * nn), 1e-48, because));
  CHECK(mean([&](const Fifty& at) { return Fifty(-X(at) * X(at) / 8); })
        == within(-3 * q * q / 64, 1e-48, because));
  for(const Fifty& small : {Fifty("1e-4"), Fifty("1e-6")})  // Y of its order, X of the same
  {
    const Fifty half = oracle::smooth_quarter(sqrt(small), 1, energy(Fifty(1 / (2 * small))));
    const Fifty mean_factor = half * sqrt(2 / small) / exact::pi();  // n = 1:√small, c = √small, k = 1
    const Fifty missing = mean_factor - (1 + small / 4 + small / 2);
    CHECK(missing
          == within_relative(small * small * (Fifty(1) / 8 + Fifty(9) / 16 - Fifty(3) / 64),
                             2 * double(small), "the third order"));
  }
}

CHECK_THAT("a ball is refused whose c is more than k, or less than 1e-40 of it")
{
  for(const char* const within_them : {"c=1 k=1", "c=2 k=2", "c=1 k=1e40", "c=2 k=2e40"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"c=1.0000000000000002 k=1", "c=2.0000000000000005 k=2",
                                  "c=0.9999999999999999 k=1e40", "c=1.9999999999999998 k=2e40"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("with more than the greatest n told the ball is without pressure at the angle told")
{
  for(const Told& now : told_at("n=6", "n=4.5", "n=1e8 c=1e-3 g=7", "n=1.5 c=1 k=1 Phi=1"))
  {
    const Fifty c_ = c.fifty(), k_ = k.fifty(), e = n.fifty() * n.fifty() / 2;
    const Ball<Fifty> ball{c_ + k_, c_, k_};
    Fifty low = exact::pi() / 2, high = exact::pi();
    for(int i = 0; i < 150; ++i)
    {
      const Fifty at = (low + high) / 2;
      const Fifty w = sqrt(2 * c_ * smooth::velocity_squared<Fifty>(c_, k_, energy(e), place(at)));
      (accelerations<Fifty>(ball, 1, at, w, 0).pressure > 0 ? low : high) = at;
    }
    CHECK((n.fifty() > sqrt(2 + pow(k_ / c_, 2) / 2)) == (high < 3.14159));
    if(high < 3.14159)
      CHECK(now.value("Phi_off", degrees) == within_relative(low, 4e-15, "eight ulps, and the excess"));
  }
}

CHECK_THAT("as long as the plane holds a ball with c < k√2 the silent mean is greater than the named one")
{
  for(const double ratio : {1e-6, 0.1, 1. / 6, 1., 1.4})
  {
    const Fifty q = Fifty(ratio) * ratio, nn = 2 + 1 / (2 * q);  // the greatest of §20, where it is hardest
    CHECK(9 / (16 * nn * nn) > q / (8 * nn));
  }
  const Fifty q = 2.1, nn = 2 + 1 / (2 * q);
  CHECK(9 / (16 * nn * nn) < q / (8 * nn));
}

/*!
Two readings. The velocity in our copy has lost the 2 of {{eq 1}}; with it a half turn would not be done in
the time that {{eq 1}} gives to its energy. And {{eq 4}} has the square where the cube must stand, as the next
line confirms; that the root times its inverse be 1 decides it.
*/

const Emendation two{
    "§21, the velocity at the start",
    {"(n:k)√gc", 1.0},
    {"(2n:k)√gc", 2.0},
    "it follows from the first line; with n = 3 the ball is by it at the top when it should be",
    [](double reading) {
      const Ball<Fifty> ball = our_ball<Fifty>;  // n = 3 and g = 1
      const auto motion = [&](const Fifty&, const exact::State& s) {
        return exact::State{s[1], accelerations<Fifty>(ball, 1, s[0], s[1], 0).Phi};
      };
      const Fifty half = oracle::smooth_quarter(ball.c, ball.k, energy(Fifty(4.5)));
      const Fifty zeta = reading * 3 / ball.k * sqrt(ball.c);
      return exact::solve(motion, 0, {0, zeta}, half / sqrt(2 * ball.c)).y[0]
             == within(exact::pi(), 1e-20, "some hundred steps of 1e-32");
    }};

const Emendation cube{
    "§21, the expansion of the denominator",
    {"1:n + sin²½Φ:n²", 0.1 + 0.5 / 100},
    {"1:n + sin²½Φ:n³", 0.1 + 0.5 / 1000},
    "at n = 10 and Φ = 90° its product with the root itself is 1 but for terms in 1:n⁴",
    [](double reading) { return reading * std::sqrt(99.) == within(1, 1e-4, "3Y²:8 is 0.4e-4"); }};

CHECK_THAT("in the race each order gives the sum of the terms up to it, in fractions")
{
  const std::array<Fifty, 5> above{1, Fifty(1) / 2, -Fifty(1) / 8, Fifty(1) / 16, -Fifty(5) / 128};
  for(const Told& now : told_at("", "n=1.5 c=0.6 Phi=90", "n=100 c=0.01"))
  {
    const Fifty at = Phi.fifty(), X = pow(c.fifty() / k.fifty() * sin(at), 2);
    const Fifty Y = 2 * pow(sin(at / 2) / n.fifty(), 2);
    CHECK(now.exact("factor")
          == within_relative(exp((log(1 + X) - log(1 - Y)) / 2), 1e-45, "another way of fifty digits"));
    CHECK(now.method("factor", "the roots")
          == within_relative(exp((log(1 + X) - log(1 - Y)) / 2), 3e-15, "what X and Y round"));
    for(std::size_t order{1}; order <= 4; ++order)
    {
      Fifty sum = 0;
      for(std::size_t i{0}; i <= order; ++i)
        for(std::size_t j{0}; i + j <= order; ++j)
          sum += above[i] * pow(X, int(i)) * abs(above[j]) * pow(Y, int(j))
                 * (j < 2 ? 1 : int(2 * j - 1));  // of 1/√(1−Y) each is 2j − 1 times that of the root
      CHECK(now.method("factor", "order " + std::to_string(order))
            == within_relative(sum, 4e-15, "some roundings of positive sums"));
    }
  }
}

CHECK_THAT("the lines drawn are the means (B), and the limit is that of the pressure at the top")
{
  for(const Told& now : told_at("", "c=0.3"))
  {
    const Fifty q = pow(c.fifty() / k.fifty(), 2);
    for(const auto& point : now.points("means", 5))
    {
      const Fifty speed = point.at("n");
      CHECK(point.value("n") == between(1.5, 30.001, "twentyfold"));
      CHECK(point.value("silent") == within_relative(Fifty(9) / 16 * pow(speed, -4), 2e-15, "roundings"));
      CHECK(point.value("named") == within_relative(q / 8 * pow(speed, -2), 2e-15, "roundings"));
      CHECK(point.value("root") == within_relative(q * q * 3 / 64, 2e-15, "roundings"));
    }
    for(const auto& point : now.points("limit", 1))
    {
      const Fifty speed = point.at("n"), w2 = 4 * c.fifty() * (speed * speed - 2) / pow(k.fifty(), 2);
      const Ball<Fifty> ball{c.fifty() + k.fifty(), c.fifty(), k.fifty()};
      CHECK(accelerations<Fifty>(ball, 1, exact::pi(), sqrt(w2), 0).pressure
            == within(0, 1e-14, "some ulps of n"));
      CHECK(point.value("n") == within_relative(sqrt(2 + 1 / (2 * q)), 1e-15, "roundings"));
    }
  }
}

/*!
## Notes

When $n$ grows without end, with the same ball, {{eq 5}} does not become exact: $Y$ vanishes and $X$ remains.
On paper the ball would then turn with $d\Phi:dt$ inverse to $\sqrt{kk + cc\sin^2\Phi}$. No plane holds it
there.

## Go on from here

::: exercise
With which $n$ do the three means {{eq B}} cancel, so that {{eq 5}} makes a whole turn right but for smaller
terms? Can the ball be on its plane then?
answer: With $x = kk:nncc$ they cancel where $36xx + 8x = 3$; there $nn = \frac23(\sqrt{31}+2)\,kk:cc$, some
5.05 times $kk:cc$. By {{sec globe.20}} the plane holds the ball up to $nn = 2 + kk:2cc$ only, which is less
for every $c$ below $k$. So on its plane the ball takes longer for a turn than {{eq 5}} has it, as far as
these terms tell: the silent one outweighs the root's.
:::
*/

CHECK_THAT("the three means cancel with an n that no plane allows, and with less they come to a delay")
{
  const Fifty times = 2 * (sqrt(Fifty(31)) + 2) / 3;  // nn over kk:cc
  CHECK(times == printed("5.05"));
  const auto sum = [](const Fifty& nn, const Fifty& q) {
    return Fifty(9 / (16 * nn * nn) + q / (8 * nn) - 3 * q * q / 64);
  };
  for(const Told& now : told_at("c=0.1 k=1 n=22.4614698", "c=0.02 k=1 n=112.307349"))
  {
    const Fifty q = pow(c.fifty() / k.fifty(), 2);
    CHECK(n.fifty() == within_relative(sqrt(times / q), 1e-8, "the n given has nine figures"));
    CHECK(now.value("mean_silent", percent)
          == within_relative(3 * q * q / 64 - q * q / (8 * times), 1e-7, "the fourth power of that n"));
  }
  for(const char* const ratio : {"0.001", "0.1", "0.5", "1"})
  {
    const Fifty q = pow(Fifty(ratio), 2), most = 2 + 1 / (2 * q);
    CHECK(most < times / q);
    for(const Fifty& part :
        {Fifty(1), Fifty(Fifty(1) / 2), Fifty(Fifty(1) / 100)})  // of what nn exceeds 2 by
      CHECK(sum(2 + part * (most - 2), q) > 0);
  }
}
