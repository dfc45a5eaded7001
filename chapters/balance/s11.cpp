#include "balance/instrument.hpp"
#include "edition/section.hpp"

SECTION(balance, 11, "The smallest swings only")

using namespace balance;

/*!
## What Euler does

The angles are now taken to be infinitely small, because with finite ones all labour would be in vain. As in
most questions about oscillations, Euler says, one must be content with this: the sine of an angle is put
equal to the angle and the cosine equal to 1, and the inquiry is thereby restricted to the smallest swings.
The coordinates of {{sec balance.06}} become

$$ \begin{aligned} x &= a + b\eta, & x' &= a - b\vartheta,\\
                   y &= b - a\omega, & y' &= b + a\omega. \end{aligned} \tag{1} $$

Nothing in them is of a higher degree than the first. What has been left out is exactly

$$ \begin{aligned}
\text{of } x:&\ -2a\sin^2\tfrac12\omega - b(\eta-\sin\eta),\\
\text{of } y:&\ -2b\sin^2\tfrac12\eta + a(\omega-\sin\omega),
\end{aligned} \tag{A} $$

and of $x'$ and $y'$ the same with $-\vartheta$ for η and $-\omega$ for ω. The sines have lost parts of the
third order, the cosines of the second.

::: margin
Today: linearisation. The second order is the first at which anything is coupled here.
:::

Beside $a$ and $b$ these parts are slight. But $a$ and $b$ do not move, and it is motion that is asked for.
The end $A$ goes up by $a\sin\omega$ and at the same time inward by $2a\sin^2\tfrac12\omega$, which compare
as

$$ \frac{\text{inward}}{\text{upward}} = \tan\tfrac12\omega. \tag{B} $$

The part left out is as small as half the angle, not as its square. And for one question there is nothing to
compare it with. A pan that hangs straight down has by {{eq 1}} the place $x = a$ and keeps it, whatever the
beam may do; in truth $A$ goes in and out twice in every period of the beam and takes the string with it. Who
asks whether a beam can set a resting pan in motion has by {{eq 1}} already answered.

That would be no fault if all that is of the second order were left out from here on. But two sections later
the product of η and the beam's acceleration is of that order, and is kept ({{sec balance.13}}).

## The program
*/

const auto a = real("a", 16. / 9, feet, closed(1e-50, 1e50), "CA = CB, half the beam");
const auto b = real("b", 32. / 9, feet, closed(1e-50, 1e50), "AP = BQ, the strings");
const auto omega = angle("omega", 1. / 6, closed(-90_deg, 90_deg), "inclination ω of the beam");
const auto eta = angle("eta", 1. / 6, closed(-90_deg, 90_deg), "inclination η of the string AP");
const auto theta = angle("theta", 1. / 6, closed(-90_deg, 90_deg), "inclination ϑ of the string BQ");

Places<> smallest()  // (1)
{
  return {a + b * eta, b - a * omega, a - b * theta, b + a * omega};
}

/*!
Of what is left out neither part is formed as the difference that it is: for small angles that would be
nothing but rounding.
*/

double over_cosine(double length, double x)  // length·(1 − cos x)
{
  const double s = std::sin(x / 2);
  return 2 * (length * s) * s;
}

double over_sine(double x)  // x − sin x
{
  if(std::abs(x) > 1)
    return x - std::sin(x);
  double sum = 0, term = x * x * x / 6;
  for(int k = 4; k <= 22; k += 2)
  {
    sum += term;
    term *= -x * x / (k * (k + 1));
  }
  return sum;
}

Places<> left_out()  // (A)
{
  const double in = over_cosine(a, omega), up = a * over_sine(omega);
  return {-in - b * over_sine(eta), up - over_cosine(b, eta), b * over_sine(theta) - in,
          -up - over_cosine(b, theta)};
}

TELL
{
  const Places<> at = smallest(), out = left_out();
  tell("x", at.x, feet, "Cp by (1)");
  tell("y", at.y, feet, "pP");
  tell("x1", at.x1, feet, "x′ = Cq");
  tell("y1", at.y1, feet, "y′ = qQ");
  tell("of_x", out.x, feet, "what (1) leaves out of x: the true place less (1)");
  tell("of_y", out.y, feet, "of y");
  tell("of_x1", out.x1, feet, "of x′");
  tell("of_y1", out.y1, feet, "of y′");
  tell("inward", over_cosine(a, omega), feet, "how far A has moved inward");
  tell("sideways", std::tan(omega / 2), percent, "the same against its way up, (B)");
}

TELL
{
  auto& rows = table("shares", "What is left out, beside what is kept",
                     {{"angle", "angle", degrees},
                      {"sine", "of the sine", percent, 4},
                      {"cosine", "of the cosine", percent, 4},
                      {"sideways", "of A's motion", percent, 4}});
  for(const double x : {0.01_deg, 0.1_deg, 1_deg, 10_deg, 30_deg})
    rows.row({x, over_sine(x) / x, over_cosine(1, x), std::tan(x / 2)});
  curve("small", {"degrees", "sine", "cosine", "sideways"}, [](Curve& out) {
    for(int j = 0; j <= 80; ++j)
    {
      const double x = 1_deg * std::pow(10, -2 + j / 20.);
      if(x < 90_deg)
        out.put({x / 1_deg, over_sine(x) / x, over_cosine(1, x), std::tan(x / 2)});
    }
  });
}

/*!
At Euler's sixth of the radius the end of the beam has moved {{inward|4}} ft inward, {{sideways|percent2}} of
its way up. To $x$, which is {{x|4}} ft by {{eq 1}}, {{of_x|3}} ft must be added.

{{table shares}}

::: figure balance-11
alt: Three straight lines on logarithmic scales. What is left out of sine and cosine falls by two decades when
the angle falls by one; the sideways motion of A beside its vertical motion falls by one decade only.

What the small angles leave out, in parts of what they keep. Sine and cosine improve with the square of the
angle; the motion of $A$, of which only the vertical part is kept, with the angle itself.
:::

## Speed against error

The distance $1 - \cos\omega$ is the seed of all that Euler's formulae lack, and one must not reckon it as it
is written. Below ω = 10⁻⁸ the cosine is 1 to sixteen figures, and the difference nothing.
*/

TELL
{
  const Fifty s = sin(omega.fifty() / 2);
  if(s != 0)
    race("versine", "1 − cos ω", 2 * s * s,
         {{"1 − cos ω", [] { return 1 - std::cos(omega); }},
          {"sin²ω : (1 + cos ω)",
           [] {
             const double sine = std::sin(omega);
             return sine * sine / (1 + std::cos(omega));
           }},
          {"2 sin²½ω", [] { return over_cosine(1, omega); }}});
}

/*!
## Checks
*/

Places<Fifty> true_places()  // by the tangents of half the angles
{
  const auto both = [](const Fifty& x) {
    const Fifty h = tan(x / 2), below = 1 + h * h;
    return std::array<Fifty, 2>{2 * h / below, (1 - h * h) / below};
  };
  const Fifty A = a.fifty(), B = b.fifty();
  const auto w = both(omega.fifty()), e = both(eta.fifty()), th = both(theta.fifty());
  return {A * w[1] + B * e[0], B * e[1] - A * w[0], A * w[1] - B * th[0], B * th[1] + A * w[0]};
}

CHECK_THAT("(1) and (A) together are the true places, and (A) keeps its digits for the smallest angles")
{
  for(const Told& now :
      told_at("", "omega=-89 eta=80 theta=-61 a=0.3 b=7", "omega=1e-9rad eta=-1e-9rad a=3",
              "eta=1e-7rad theta=-1e-9rad omega=90", "omega=0 eta=58 b=1e40"))
  {
    const Fifty A = a.fifty(), B = b.fifty(), w = omega.fifty(), e = eta.fifty(), th = theta.fifty();
    const double size = 5e-16 * (a + b);
    const char* const sum = "a product and a sum";
    CHECK(now.value("x", feet) == within(A + B * e, size, sum));
    CHECK(now.value("y", feet) == within(B - A * w, size, sum));
    CHECK(now.value("x1", feet) == within(A - B * th, size, sum));
    CHECK(now.value("y1", feet) == within(B + A * w, size, sum));
    const Places<Fifty> at = true_places();
    const auto parts = [](double of_cosine, double x, double of_sine, double y) {
      return 1e-15 * (of_cosine * x * x + of_sine * std::abs(y * y * y));
    };
    const char* const few = "two parts, each to a few roundings";
    CHECK(now.value("of_x", feet) == within(at.x - (A + B * e), parts(a, omega, b, eta), few));
    CHECK(now.value("of_y", feet) == within(at.y - (B - A * w), parts(b, eta, a, omega), few));
    CHECK(now.value("of_x1", feet) == within(at.x1 - (A - B * th), parts(a, omega, b, theta), few));
    CHECK(now.value("of_y1", feet) == within(at.y1 - (B + A * w), parts(b, theta, a, omega), few));
    CHECK(now.value("inward", feet) == within_relative(A * (1 - cos(w)), 1e-15, "a square"));
    const Fifty ratio = w == 0 ? Fifty(0) : (1 - cos(w)) / sin(w);
    CHECK(now.value("sideways", percent) == within_relative(ratio, 5e-16, "a tangent"));
  }
}

CHECK_THAT(
    "of the sine a sixth of the square is left out, of the cosine a half, of A's motion half the angle")
{
  for(const Told& now : told_at(""))
  {
    const auto hold = [](const ToldRow& row, const Fifty& x, const Unit& unit) {
      CHECK(row.value("sine", unit) == within_relative(1 - sin(x) / x, 2e-14, "the angle is rounded"));
      CHECK(row.value("cosine", unit) == within_relative(1 - cos(x), 2e-14, "the same"));
      CHECK(row.value("sideways", unit) == within_relative((1 - cos(x)) / sin(x), 2e-14, "the same"));
      const Fifty beyond = x * x;
      CHECK(row.value("sine", unit) == within_relative(x * x / 6, double(beyond) / 19.9, "next term"));
      CHECK(row.value("cosine", unit) == within_relative(x * x / 2, double(beyond) / 11.9, "next term"));
      CHECK(row.value("sideways", unit) == within_relative(x / 2, double(beyond) / 7.9, "next terms"));
    };
    for(const auto& row : now.rows("shares"))
    {
      CHECK(row.value("angle", degrees) == between(1e-2_deg, 30_deg, "the rows' own angles"));
      hold(row, row.at("angle", degrees), percent);
    }
    const auto points = now.points("small");
    for(std::size_t j{0}; j + 10 < points.size(); j += 13)  // up to 28°
      hold(points[j], Fifty(points[j].at("degrees")) * exact::pi() / 180, none);
  }
}

CHECK_THAT(
    "1 − cos ω as it is written keeps no digit of the smallest angles; as a square it keeps them all")
{
  for(const Told& now : told_at("", "omega=1e-9rad", "omega=-77", "omega=1e-4"))
  {
    const Fifty versine = 1 - cos(omega.fifty());
    CHECK(now.exact("versine") == within_relative(versine, 1e-30, "a difference in fifty digits"));
    CHECK(now.method("versine", "1 − cos ω")
          == within(versine, 3e-16, "half a unit of the last place of 1, and the angle's own"));
    CHECK(now.method("versine", "sin²ω : (1 + cos ω)") == within_ulps(versine, 5, "few roundings"));
    CHECK(now.method("versine", "2 sin²½ω") == within_ulps(versine, 4, "few roundings"));
  }
  for(const Told& now : told_at("omega=1e-9rad"))
    CHECK(now.method("versine", "1 − cos ω") == within(0, 0, "the cosine is 1 in double precision"));
}

CHECK_THAT("a tenth of the angles leaves out a hundredth, and of x beyond the arc a thousandth")
{
  const auto missing = [](const Fifty& part) {
    const Angles<Fifty> at{part / 6, part / 7, part / 8};
    const Places<Fifty> now = places<Fifty>(2, 3, at);
    return std::array<Fifty, 3>{now.x - (2 + 3 * at.eta), now.y - (3 - 2 * at.omega),
                                now.x - (2 + 3 * at.eta) + at.omega * at.omega};
  };
  const auto small = missing(Fifty("1e-3")), smaller = missing(Fifty("1e-4"));
  CHECK(small[0] / smaller[0] == within(100, 0.2, "a part of the next order"));
  CHECK(small[1] / smaller[1] == within(100, 0.2, "a part of the next order"));
  CHECK(small[2] / smaller[2] == within(1000, 2, "without aωω/2 only the sine of η is left"));
}

/*!
## Go on from here

::: exercise
Up to what angle does $A$ move sideways by no more than a hundredth of its way up? And by no more than a
hundredth of $a$?

answer: By {{eq B}} up to $2\arctan 0.01$, a little more than 1°; and up to $\arccos 0.99$, which is more
than 8°. What is small beside the beam need not be small beside its motion.
:::
*/

CHECK_THAT("a hundredth of the way up is reached soon after 1°, a hundredth of the beam only beyond 8°")
{
  const Fifty degree = exact::pi() / 180;
  CHECK(2 * atan(Fifty(1) / 100) / degree == between(1.1, 1.2, "degrees"));
  CHECK(acos(Fifty(99) / 100) / degree == between(8, 8.2, "degrees"));
}
