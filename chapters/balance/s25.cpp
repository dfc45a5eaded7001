#include "balance/euler.hpp"
#include "edition/section.hpp"

SECTION(balance, 25, "The pans under a beam let go at m")

using namespace balance;

/*!
## What Euler does

With the beam's constants known, the formulae for the pans take the shape in which they are used from here on.
In the solution of {{sec balance.17}} and {{sec balance.18}} Euler puts $\mathfrak C = m$, $\gamma=\frac\pi2$
and $f = 2g:\lambda\lambda$ {{entry two_g}}, whereby

$$ \frac{\mu\mu a\,\mathfrak A\mathfrak C}{2\lambda(2\mu\mp\lambda)f}
   = \frac{\lambda\mu\mu a\,\mathfrak Am}{4g(2\mu\mp\lambda)}. \tag{1} $$

So

$$ \begin{aligned}
\eta = {}&\mathfrak A\sin(\alpha+\mu t)\\
 &+ \frac{\lambda\mu\mu a\,\mathfrak Am}{4g(2\mu-\lambda)}\\
 &\quad\times\cos\bigl(\alpha-\tfrac\pi2+(\mu-\lambda)t\bigr)\\
 &+ \frac{\lambda\mu\mu a\,\mathfrak Am}{4g(2\mu+\lambda)}\\
 &\quad\times\cos\bigl(\alpha+\tfrac\pi2+(\mu+\lambda)t\bigr),
\end{aligned} \tag{2} $$

and ϑ has $\mathfrak B$, β and the opposite signs. As $\cos(x-90°) = \sin x$ and $\cos(x+90°)=-\sin x$, this
becomes somewhat neater:

$$ \begin{aligned}
\eta = {}&\mathfrak A\sin(\alpha+\mu t)\\
 &+ \frac{\lambda\mu\mu a\,\mathfrak Am}{4g(2\mu-\lambda)}\\
 &\quad\times\sin\bigl(\alpha+(\mu-\lambda)t\bigr)\\
 &- \frac{\lambda\mu\mu a\,\mathfrak Am}{4g(2\mu+\lambda)}\\
 &\quad\times\sin\bigl(\alpha+(\mu+\lambda)t\bigr),\\
\vartheta = {}&\mathfrak B\sin(\beta+\mu t)\\
 &- \frac{\lambda\mu\mu a\,\mathfrak Bm}{4g(2\mu-\lambda)}\\
 &\quad\times\sin\bigl(\beta+(\mu-\lambda)t\bigr)\\
 &+ \frac{\lambda\mu\mu a\,\mathfrak Bm}{4g(2\mu+\lambda)}\\
 &\quad\times\sin\bigl(\beta+(\mu+\lambda)t\bigr).
\end{aligned} \tag{3} $$

From them he takes the angular velocities:

$$ \begin{aligned}
\frac{d\eta}{dt} = {}&\mu\mathfrak A\cos(\alpha+\mu t)\\
 &+ \frac{\lambda(\mu-\lambda)\mu\mu a\,\mathfrak Am}{4g(2\mu-\lambda)}\\
 &\quad\times\cos\bigl(\alpha+(\mu-\lambda)t\bigr)\\
 &- \frac{\lambda(\mu+\lambda)\mu\mu a\,\mathfrak Am}{4g(2\mu+\lambda)}\\
 &\quad\times\cos\bigl(\alpha+(\mu+\lambda)t\bigr),
\end{aligned} \tag{4} $$

and $d\vartheta:dt$ likewise with $\mathfrak B$, β and the opposite signs of the last two terms.

What do two side tones do to a swing? Together they are a swing of the pan's own frequency that waxes and
wanes, and one a quarter of a period away from it:

$$ \begin{aligned} \eta &= \mathfrak A(1+K\cos\lambda t)\sin(\alpha+\mu t)\\
   &\quad - \mathfrak A\,H\sin\lambda t\cos(\alpha+\mu t),\\
   K &= \frac{\lambda\lambda\mu\mu am}{2g(4\mu\mu-\lambda\lambda)}, \quad H = \frac{2\mu}\lambda K.
   \end{aligned} \tag{A} $$

::: margin
Today: $K$ is amplitude modulation, $H$ phase modulation. That the width goes as the inverse root of the
frequency is the adiabatic invariance of $E/\omega$.
:::

The first of them alters the swing's width, by the $K$ of {{sec balance.26}}; the second its phase, by
$H\sin\lambda t$ to the first order of $H$. As the beam is slow, $H$ is much the greater of the two. So what
the pan feels of the beam is hardly that it swings wider and narrower, but that its clock runs fast while the
end of the beam is accelerated upwards, and slow while it is accelerated downwards; over a swing of the beam
both cancel. It is what a
pendulum does whose weight changes slowly: its frequency goes as the root of the weight, its width as the
inverse fourth root, which at the beam's greatest inclination gives the ratios $H\lambda:\mu$ and $K$, in the
proportion of 2 to 1.

## The program

The shape (2) is the general solution with $\gamma=\frac\pi2$, {{api balance::general}}; the shape (3) stands
here. It is reckoned in fifty digits from the numbers as they are typed: where λ is near $2\mu$, the rounding
of λ alone would change the slower tone.
*/

const auto lambda =
    real("lambda", 1, Unit{"1/s"}, closed(1e-100, 1e6), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, closed(1e-6, 1e6), "frequency of the pans, μ = √(2g/b)");
const auto a = real("a", 16. / 9, feet, scale, "half the beam");
const auto g = real("g", 16, feet, scale, "height fallen in the first second");
const auto m = angle("m", 1. / 6, closed(-90_deg, 90_deg), "inclination of the beam at the start");
const auto A = angle("A", 1. / 6, closed(-90_deg, 90_deg), "amplitude 𝔄 of the pan P");
const auto B = angle("B", 1. / 6, closed(-90_deg, 90_deg), "amplitude 𝔅 of the pan Q");
const auto alpha = angle("alpha", 40_deg, closed(-360_deg, 360_deg), "phase α of the pan P");
const auto beta = angle("beta", 70_deg, closed(-360_deg, 360_deg), "phase β of the pan Q");
const auto t = real("t", 1, seconds, closed(0, 1e6), "time");

Fifty tone(int side)  // λμμam/(4g(2μ + side λ)), against the pan's own swing
{
  const Fifty l = lambda.fifty(), u = mu.fifty();
  return i_of<Fifty>(l, u, a.fifty(), g.fifty()) * m.fifty() / (2 * u + side * l);
}

struct Swing
{
  Fifty angle, rate;
};

Swing pan(const Fifty& amplitude, const Fifty& from, int side, const Fifty& at)  // side 1 for P, −1 for Q
{
  const Fifty u = mu.fifty(), slow = u - lambda.fifty(), fast = u + lambda.fifty();
  const Fifty own = from + u * at, lower = from + slow * at, upper = from + fast * at;
  return {
      amplitude * (sin(own) + side * (tone(-1) * sin(lower) - tone(1) * sin(upper))),  // (3)
      amplitude
          * (u * cos(own) + side * (tone(-1) * slow * cos(lower) - tone(1) * fast * cos(upper)))};  // (4)
}

TELL
{
  require(lambda.fifty() != 2 * mu.fifty(), "lambda", "not 2 mu, where the slower tone is infinite");
  require(abs(tone(-1)) < 1e100, "a", "such that the side tones are below 1e100");  // this is the greater
  const Swing P = pan(A.fifty(), alpha.fifty(), 1, t.fifty()),
              Q = pan(B.fifty(), beta.fifty(), -1, t.fifty());
  tell("lower", double(tone(-1)), "λμμam/4g(2μ−λ), the tone at μ − λ in parts of the pan's own", 15);
  tell("upper", double(tone(1)), "λμμam/4g(2μ+λ), the one at μ + λ", 15);
  tell("eta", double(P.angle), radians, "η at the time t, (3)", 15);
  tell("theta", double(Q.angle), radians, "ϑ", 15);
  tell("eta_rate", double(P.rate), Unit{"1/s"}, "dη:dt, (4)", 15);
  tell("theta_rate", double(Q.rate), Unit{"1/s"}, "dϑ:dt", 15);
  const Fifty K = K_of<Fifty>(lambda.fifty(), mu.fifty(), a.fifty(), g.fifty(), m.fifty());
  tell("wider", double(K), "K, by what part the swing is wider when the beam is at m, (A)", 15);
  tell("ahead", double(tone(-1) + tone(1)), "H, by how much the swing is behind or ahead at the most, (A)",
       15);
}

TELL
{
  curve("modulation", {"turn", "width", "phase"}, [](Curve& out) {
    const double K = double(tone(-1) - tone(1)), H = double(tone(-1) + tone(1));
    for(int k = 0; k <= 360; ++k)
    {
      const auto [s, c] = elementary::sincos(k * 2_deg);
      out.put({2. * k, 100 * K * c, 100 * H * s});
    }
  });
}

/*!
In Euler's example the swing is wider by {{wider|4}} of itself when the beam stands at $m$; its phase is
behind or ahead by {{ahead|4}} of the radius at the most.

::: figure balance-25
alt: Two waves over two swings of the beam to and fro. The one of the phase is six times as high as that of
the width and a quarter of a turn behind it.

What the two side tones do to P's swing: they make it wider and narrower, and put it behind and ahead, in
hundredths of the swing and of the radius. The phase has the greater share.
:::

## Checks
*/

CHECK_THAT("(3) is (2), and both are the general solution of § 17 with its f; (4) is its derivative")
{
  for(const Told& now : told_at("", "lambda=0.02 mu=7 a=3 g=9 m=-20 A=5 B=-8 alpha=-100 beta=300 t=77",
                                "lambda=5.9999 t=40", "lambda=5.99999999999999 t=123456.789",
                                "lambda=1e-100 mu=2 t=1e4", "lambda=9 mu=2 a=3e40 g=1e40 t=0.3"))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty(), s = t.fifty(), f = 2 * g.fifty() / (l * l), h("1e-18");
    const auto whole = [&](const Fifty& size, const Fifty& from, int side, const Fifty& at) {  // (2), by f
      const Fifty half = u * u * a.fifty() * m.fifty() / (2 * l * f), right = exact::pi() / 2;
      return Fifty(size
                   * (sin(from + u * at) + side * half / (2 * u - l) * cos(from - right + (u - l) * at)
                      + side * half / (2 * u + l) * cos(from + right + (u + l) * at)));
    };
    const auto slope = [&](const Fifty& size, const Fifty& from, int side) {
      return Fifty((whole(size, from, side, s + h) - whole(size, from, side, s - h)) / (2 * h));
    };
    const Fifty lower = l * u * u * a.fifty() * m.fifty() / (4 * g.fifty() * (2 * u - l)),
                upper = l * u * u * a.fifty() * m.fifty() / (4 * g.fifty() * (2 * u + l));
    const char* const once = "one rounding";
    CHECK(now.value("lower") == within_ulps(lower, 1, once));
    CHECK(now.value("upper") == within_ulps(upper, 1, once));
    CHECK(now.value("eta", radians) == within_ulps(whole(A.fifty(), alpha.fifty(), 1, s), 1, once));
    CHECK(now.value("theta", radians) == within_ulps(whole(B.fifty(), beta.fifty(), -1, s), 1, once));
    const char* const slopes = "one rounding, differences";
    CHECK(now.value("eta_rate", Unit{"1/s"})
          == within_relative(slope(A.fifty(), alpha.fifty(), 1), 1e-15, slopes));
    CHECK(now.value("theta_rate", Unit{"1/s"})
          == within_relative(slope(B.fifty(), beta.fifty(), -1), 1e-15, slopes));
    const Fifty K = l * l * u * u * a.fifty() * m.fifty() / (2 * g.fifty() * (4 * u * u - l * l));
    CHECK(now.value("wider") == within_ulps(K, 1, once));
    CHECK(now.value("ahead") == within_ulps(2 * u / l * K, 1, "one rounding, H = 2μK/λ"));
  }
}

CHECK_THAT(
    "λ = 2μ is refused, and not what no double tells from it; so is a tone of 1e100, and not what is "
    "a little less")
{
  const std::string great = "g=0.1125 m=0.5rad a=";  // the slower tone is then 2a, in feet
  for(const std::string& no :
      std::vector<std::string>{"lambda=6", "lambda=1 mu=0.5", great + "5.000000000000001e99"})
    CHECK(refused_at(no));
  for(const std::string& yes :
      std::vector<std::string>{"lambda=5.99999999999999999", "lambda=6.00000000000000001", "lambda=6 mu=4",
                               great + "4.999999999999999e99"})
    CHECK(!refused_at(yes));
}

CHECK_THAT("(A) is (3), in fifty digits")
{
  const Fifty l("0.7"), u(3), half("0.013"), from("0.4");
  const Fifty lower = half / (2 * u - l), upper = half / (2 * u + l), K = lower - upper, H = 2 * u / l * K;
  for(const int s : {0, 1, 5})
  {
    const Fifty three =
        sin(from + u * s) + lower * sin(from + (u - l) * s) - upper * sin(from + (u + l) * s);
    CHECK((1 + K * cos(l * s)) * sin(from + u * s) - H * sin(l * s) * cos(from + u * s)
          == within(three, 1e-45, "fifty digits"));
  }
}

CHECK_THAT(
    "for slow beams the width goes as the inverse fourth root of the weight that the pan seems to have")
{
  // the weight at the beam's greatest inclination is 1 − (am/b)λλ/μμ of itself
  const Fifty l("1e-6"), u(3), am = Fifty(1) / 12;
  const Fifty weight = 1 - am * l * l / (u * u), K = am * l * l / (4 * u * u - l * l);
  CHECK(1 / sqrt(sqrt(weight)) - 1 == within_relative(K, 1e-10, "the square of λ/μ"));
  CHECK(sqrt(weight) - 1 == within_relative(-2 * K, 1e-10, "the same"));
}

CHECK_THAT("the figure has K cos λt and H sin λt")
{
  for(const Told& now : told_at("", "lambda=0.3 mu=2", "lambda=1e-50"))
    for(const auto& point : now.points("modulation", 8))
    {
      const Fifty x = Fifty(point.at("turn")) * exact::pi() / 180, l = lambda.fifty(), u = mu.fifty();
      const Fifty K = l * l * u * u * a.fifty() * m.fifty() / (2 * g.fifty() * (4 * u * u - l * l)),
                  H = 2 * u / l * K;
      CHECK(point.value("width")
            == within(100 * K * cos(x), 1e-14 * double(100 * H), "two tones, nearly equal"));
      CHECK(point.value("phase") == within(100 * H * sin(x), 1e-14 * double(100 * H), "a dozen roundings"));
    }
}

/*!
Our copy substitutes $f = a:\lambda$. Then the beam's length would depend on its arm alone; {{sec balance.24}}
has $2g:\lambda\lambda$, with which all coefficients here agree. (A bracket that it lacks in the second of the
two formulae for cosines is put in silently.)
*/

const Emendation two_g{"§25, the value of f, in Euler's example in feet",
                       {"a/λ", 16. / 9},
                       {"2g/λλ", 32.},
                       "with it the coefficients of § 17 are those of § 25",
                       [](double f) {  // μμa/(2λ(2μ−λ)f) against λμμa/(4g(2μ−λ))
                         return 9 * 16. / 9 / (2 * 5 * f)
                                == within_relative(9 * 16. / 9 / (64 * Fifty(5)), 1e-14, "roundings");
                       }};
