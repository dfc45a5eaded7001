#include "edition/section.hpp"
#include "globe/asked.hpp"
#include "globe/oracle.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"

SECTION(globe, 29, "Rolling from a given velocity")

using namespace globe;

/*!
## What Euler does

So that the two cases can be compared, the constant of the rolling ball is settled by its velocity at the
lowest place, as it was on the smooth plane. There, at $t = 0$, let $\Phi = 0$ and $d\Phi/dt = \zeta$. Since
the ball rolls, its progress is given with that,

$$ \frac{ds}{dt} = \frac{a\,d\Phi}{dt}{{entry rolling_start}} = a\zeta, \tag{1} $$

while on the smooth plane it could be any. The equation of {{sec globe.25}} gives for $\Phi = 0$

$$ \begin{aligned} &\zeta\zeta(aa+cc+kk-2ac) \\ &\quad = \zeta\zeta\bigl((a-c)^2+kk\bigr)
   = 4g(c+C), \end{aligned} \tag{2} $$

whence

$$ 4gC = \zeta\zeta\bigl((a-c)^2+kk\bigr) - 4gc, \tag{3} $$

and in general

$$ \begin{aligned} &\frac{d\Phi^2}{dt^2}(aa+cc+kk-2ac\cos\Phi) \\
   &\quad = \zeta\zeta\bigl((a-c)^2+kk\bigr)\\ &\qquad - 4gc(1-\cos\Phi). \end{aligned} \tag{4} $$

From this

$$ dt = \frac{d\Phi\sqrt{aa+cc+kk-2ac\cos\Phi}}{\sqrt{\zeta\zeta((a-c)^2+kk)-4gc(1-\cos\Phi)}}, \tag{5} $$

where $a - c$ is the distance of the centre of gravity from the surface of the ball. Our copy has the Greek
letter γ for the lower root.

::: margin
Today: {{eq 2}} is the energy at the lowest place; $bb = (a-c)^2+kk$ is the radius of gyration about the point
of contact, squared.
:::

Set beside {{sec globe.11}}, {{eq 5}} differs in two places. Below, $kk$ has become $bb = (a-c)^2 + kk$: the
ball that rolls has more to set in motion, and with the same ζ more energy. With

$$ h = \frac{\zeta\zeta\,bb}{8gc} \tag{A} $$

it rocks for $h < 1$ up to $\sin^2\tfrac12\Phi = h$, as the other does with its own $h$. Above,
$kk + cc\sin^2\Phi$ has become $bb + 4ac\sin^2\tfrac12\Phi$, which grows all the way up; there it was the same
at the top as at the lowest place. The whole time, of a single swing or of a turn, is twice what
{{sec globe.28}} gives with $\sin^2\tfrac12\Phi = h$ or 1. Near $h = 1$ it grows as the logarithm of what is
missing:

$$ \begin{aligned} t\sqrt{2gc} \approx B\,&l\,\frac{4B}{b\sqrt{|1-h|}} \\
   &- 2\sqrt{ac}\operatorname{arsinh}\frac{2\sqrt{ac}}b, \end{aligned} \tag{B} $$

with $BB = (a+c)^2+kk$, for the quarter of an oscillation or half a turn. So the delay near the top has $B$
for its measure where on the smooth plane it was $k$: for a tenth of $|1-h|$ a swing, or a turn, takes
$B\,l\,10$ more of $t\sqrt{2gc}$.

## The program

Whole times go by Carlson's formula. In Legendre's form, with its complete integral of the third kind, they
are these; the integral is found by the steps of Bulirsch, which end when two means meet.
*/

double complete(double kc, double p)  // ∫ dϑ/((cos²ϑ + p sin²ϑ)√(cos²ϑ + kc² sin²ϑ)) from 0 to 90°
{
  double e = kc, m = 1, first = 1, root = std::sqrt(p), second = 1 / root;
  for(;;)
  {
    const double before = first, step = e / root;
    first += second / root;
    second = 2 * (second + before * step);
    root += step;
    const double mean = m;
    m += kc;
    if(std::abs(mean - kc) <= 1e-9 * mean)
      break;
    kc = 2 * std::sqrt(e);
    e = kc * m;
  }
  return std::numbers::pi / 2 * (second + first * m) / (m * (m + root));
}

double by_Legendre(const Ball<double>& ball, const Energy<double>& e)
{
  const double ac = 4 * ball.a * ball.c, b2 = bb(ball), B2 = BB(ball);
  if(e.turns_over())
    return b2 / std::sqrt(B2 * e.h) * complete(std::sqrt(b2 / B2 * (-e.from_top / e.h)), b2 / B2);
  const double D = b2 + ac * e.h;
  return b2 / std::sqrt(D) * complete(std::sqrt(b2 / D * e.from_top), b2 / D);
}

double near_top(const Ball<double>& ball, double from_top)  // (B)
{
  const double b = std::hypot(ball.gap, ball.k), B = std::hypot(ball.a + ball.c, ball.k);
  const double root = 2 * std::sqrt(ball.a) * std::sqrt(ball.c);
  return B * (std::log(4 * (B / b)) - std::log(std::abs(from_top)) / 2) - root * std::asinh(root / b);
}

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto asked = asked_energy(0.5);

double second()  // what one second is in τ
{
  return std::sqrt(2 * g) * std::sqrt(c);
}

TELL
{
  const Ball<double> ball = rounded_ball(a, c, k);
  require_rolling(ball);
  const Energy<Fifty> exact_e = asked.rolling(a, c, k, g);
  const Energy<double> e = rounded(exact_e);
  const double zeta = velocity_of_energy<double>(c, bb(ball), g, e);
  tell("energy", e.h, "h, the energy as a part of what the top asks for, (A)");
  tell("below_top", e.from_top, "1 − h");
  tell("velocity", zeta, Unit{"1/s"}, "ζ, dΦ/dt at the lowest place");
  tell("progress", a * zeta, Unit{"ft/s"}, "ds/dt there, (1)");
  tell("C", double(c.fifty() * (exact_e.h - exact_e.from_top)), feet, "the constant C, by (3)");
  tell("b", std::hypot(ball.gap, k), feet, "b, which takes the place of k");
  tell("whole", 2 * rolling::quarter(ball, e) / second(), seconds,
       "a single swing; where the ball turns over, a whole turn");
  tell("near", e.from_top == 0 ? infinity : 2 * near_top(ball, e.from_top) / second(), seconds,
       "the same by (B), good near the top");
  tell("zeta_rolling", velocity_of_energy<double>(c, bb(ball), g, energy(1.)), Unit{"1/s"},
       "the ζ for the top, rolling");
  tell("zeta_smooth", velocity_of_energy<double>(c, k * k, g, energy(1.)), Unit{"1/s"},
       "and on a smooth plane");
  tell("tenth", std::hypot(a + c, k) * std::log(10.) / second(), seconds,
       "how much later for a tenth of |1 − h|");
}

TELL
{
  auto& tops = table("tops", "Ever nearer to the energy for the top",
                     {{"from_top", "1 − h", none, 1},
                      {"whole", "swing or turn", seconds, 10},
                      {"near", "by (B)", seconds, 10}});
  const Ball<double> ball = rounded_ball(a, c, k);
  for(const double below : {0.5, 1e-2, 1e-6, 1e-15, 1e-100, -1e-15, -1e-2, -1.})
    tops.row({below, 2 * rolling::quarter(ball, energy_from_top(below)) / second(),
              2 * near_top(ball, below) / second()});
}

TELL
{
  curve("times", {"h", "rolling"}, [](Curve& times) {
    const Ball<double> ball = rounded_ball(a, c, k);
    for(int n = -80; n <= 80; ++n)
    {
      const Energy<double> e =
          energy_from_top((n < 0 ? 0.99 : -2) * std::pow(1e-5, 1 - std::max(1, std::abs(n)) / 80.));
      times.put({e.h, 2 * rolling::quarter(ball, e) / second()});
    }
  });
  curve("smooth", {"h", "smooth"}, [](Curve& smooth) {
    if(c > 1e9 * k)
      return;  // beyond what is made for the smooth plane
    for(int n = -80; n <= 80; ++n)
    {
      const Energy<double> e =
          energy_from_top((n < 0 ? 0.99 : -2) * std::pow(1e-5, 1 - std::max(1, std::abs(n)) / 80.));
      smooth.put({e.h, 2 * smooth::quarter<double>(c, k, e) / second()});
    }
  });
}

/*!
With half the energy for the top our ball rolls through its lowest place with {{velocity|4}} radians, and
{{progress|4}} feet, a second, and a single swing takes {{whole|7}} seconds. Near the top every tenth of what
is missing costs {{tenth|4}} seconds more.

{{table tops}}

::: figure globe-29
alt: The time of a single swing, or of a turn, against the energy. Two curves that rise to a pole at h = 1
from either side, that of rolling above that of the smooth plane.

A single swing ($h < 1$) or a whole turn ($h > 1$) against the energy: rolling (blue) and on a smooth plane
(grey). At $h = 1$ either takes for ever.
:::

## Speed against error

One number, the time of a quarter or of half a turn, by several ways. Ask for `--from_top 1e-15`: whoever
forms $1 - h$ by subtraction has lost most of it before any formula begins.
*/

const std::vector<int> counts{8, 16, 32, 64};

template <class Real>
Real by_steps(const Ball<Real>& ball, const Energy<Real>& e, int n,
              const Real& right)  // the trapezoidal rule in ϑ
{
  using std::cos, std::sin, std::sqrt;
  Real sum = 0;
  for(int i = 0; i <= n; ++i)
  {
    const Real s = sin(right * i / n), u = cos(right * i / n);
    const Real most = e.turns_over() ? Real(1) : e.h,
               left = e.turns_over() ? Real(u * u - e.from_top) : Real(e.from_top + e.h * u * u);
    sum += sqrt(bb(ball) + 4 * ball.a * ball.c * most * s * s) / sqrt(left) * (i % n == 0 ? 0.5 : 1);
  }
  return sum * right / n;
}

TELL
{
  const Ball<double> ball = rounded_ball(a, c, k);
  const Energy<double> e = rounded(asked.rolling(a, c, k, g));
  if(e.from_top == 0)
    return;  // nothing finite to compare
  std::vector<Method> ways;
  for(const int n : counts)
    ways.push_back({"steps of ϑ, " + std::to_string(n),
                    [=] { return by_steps(ball, e, n, std::numbers::pi / 2); }, "even in ϑ"});
  ways.push_back({"near the top, (B)", [=] { return near_top(ball, e.from_top); }});
  ways.push_back({"Legendre and Bulirsch", [=] { return by_Legendre(ball, e); }});
  if(e.h != 1)
    ways.push_back({"Carlson, 1 − h subtracted", [=] { return rolling::quarter(ball, energy(e.h)); }});
  ways.push_back({"Carlson, 1 − h given", [=] { return rolling::quarter(ball, e); }});
  race("quarter", "t√(2gc)", rolling::quarter(exact_ball(a, c, k), asked.rolling(a, c, k, g)), ways);
}

/*!
## Checks

The times are held against quadrature of {{eq 5}} in fifty digits, the constants against {{eq 2}} and
{{eq 4}}.
*/

CHECK_THAT("the times told are those of the integral (5), and C and h are those of (2) and (3)")
{
  for(const Told& now :
      told_at("", "from_top=1e-15", "from_top=-1e-15 c=0.5 k=0.5", "zeta=12 a=2", "h=1e-40 c=3",
              "a=1 c=1 k=1e-8", "c=0.999999999 k=1e-9", "h=0.50000000000000001", "from_top=-1e-200 k=20",
              "a=1e50 c=1e49 k=1e50 g=1e-40 h=1e20"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Energy<Fifty> e = asked.rolling(a, c, k, g);
    const Fifty g_ = g.fifty(), one = sqrt(2 * g_ * ball.c), zeta = sqrt(8 * g_ * ball.c * e.h / bb(ball));
    CHECK(now.value("energy") == within_ulps(e.h, 1, "rounded once"));
    CHECK(now.value("below_top") == within_ulps(e.from_top, 1, "rounded once"));
    CHECK(now.value("velocity", Unit{"1/s"}) == within_relative(zeta, 2e-15, "eight roundings"));
    CHECK(now.value("progress", Unit{"ft/s"}) == within_relative(ball.a * zeta, 2e-15, "eight roundings"));
    CHECK(now.value("b", feet) == within_relative(sqrt(bb(ball)), 1e-15, "two roundings"));
    CHECK(now.value("C", feet)
          == within((zeta * zeta * bb(ball) - 4 * g_ * ball.c) / (4 * g_),
                    1.2e-16 * double(abs(ball.c * (e.h - e.from_top))) + 1e-45 * double(ball.c),
                    "(3), rounded once; of a difference in fifty digits"));
    CHECK(now.value("whole", seconds)
          == within_relative(2 * oracle::rolling_quarter(ball, e) / one, 4e-15, "eight ulps and a root"));
    CHECK(now.value("tenth", seconds)
          == within_relative(sqrt(BB(ball)) * log(Fifty(10)) / one, 2e-15, "six roundings"));
    const Fifty b = sqrt(bb(ball)), B = sqrt(BB(ball)), r = 2 * sqrt(ball.a * ball.c),
                off = abs(e.from_top);
    const Fifty first = B * log(4 * B / b / sqrt(off)), last = r * asinh(r / b);
    CHECK(now.value("near", seconds)
          == within(2 * (first - last) / one, 4e-15 * double((abs(first) + last + B * abs(log(off))) / one),
                    "a difference of logarithms"));
  }
  for(const Told& now : told_at("h=1"))
  {
    CHECK(now.value("whole", seconds) == infinite("with just the energy for the top"));
    CHECK(now.value("near", seconds) == infinite("the logarithm of nothing"));
  }
}

CHECK_THAT("a ball with c = a is refused whose k is less than 1e-20 of them, and one with just that is not")
{
  for(const char* const within_them : {"c=1 k=1e-20", "a=2 c=2 k=2e-20"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond : {"c=1 k=9.9999999999999e-21", "a=2 c=2 k=1.9999999999999e-20"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("a ζ is refused together with 1 − h, and where its h is less than 1e-100 or more than 1e100")
{
  for(const char* const within_them : rolling_within)
    CHECK(!refused_at(within_them));
  for(const char* const beyond : rolling_beyond)
    CHECK(refused_at(beyond));
}

CHECK_THAT("(B) errs by less than |1 − h| l |1 − h| on either side of the top")
{
  for(const Ball<Fifty>& ball : {our_ball<Fifty>, cradle<Fifty>})
    for(const char* off : {"1e-3", "-1e-3", "1e-8", "-1e-8", "1e-15", "-1e-15"})
    {
      const Fifty d(off), b = sqrt(bb(ball)), B = sqrt(BB(ball)), r = 2 * sqrt(ball.a * ball.c);
      const Fifty time = B * log(4 * B / b / sqrt(abs(d))) - r * asinh(r / b);
      CHECK(time
            == within(oracle::rolling_quarter(ball, {1 - d, d}), double(-abs(d) * log(abs(d))),
                      "what is left out"));
    }
}

CHECK_THAT("the table, the figure and the race are the integral, (B), and the rule in fifty digits")
{
  const auto by_B = [](const Ball<Fifty>& ball, const Fifty& off) {
    const Fifty b = sqrt(bb(ball)), B = sqrt(BB(ball)), r = 2 * sqrt(ball.a * ball.c);
    return Fifty(B * log(4 * B / b / sqrt(abs(off))) - r * asinh(r / b));
  };
  for(const Told& now : told_at("", "from_top=1e-15", "from_top=-1e-3 c=0.5 k=0.5 g=0.5"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Energy<Fifty> e = asked.rolling(a, c, k, g);
    const Fifty one = sqrt(2 * g.fifty() * ball.c);
    for(const auto& row : now.rows("tops"))
    {
      const Fifty below = row.at("from_top");
      CHECK(row.value("from_top") == between(-1, 0.5, "the energies of the table"));
      CHECK(row.value("whole", seconds)
            == within_relative(2 * oracle::rolling_quarter(ball, {1 - below, below}) / one, 4e-15,
                               "eight ulps"));
      CHECK(row.value("near", seconds)
            == within_relative(2 * by_B(ball, below) / one, 1e-14, "a difference"));
    }
    const Fifty time = oracle::rolling_quarter(ball, e);
    CHECK(now.exact("quarter") == within_relative(time, 1e-33, "the quadrature's bound"));
    CHECK(now.method("quarter", "Carlson, 1 − h given") == within_relative(time, 2e-15, "eight ulps"));
    CHECK(now.method("quarter", "Legendre and Bulirsch") == within_relative(time, 4e-15, "some means"));
    CHECK(now.method("quarter", "near the top, (B)")
          == within_relative(by_B(ball, e.from_top), 1e-14, "a difference"));
    const Fifty h = static_cast<double>(e.h);
    CHECK(now.method("quarter", "Carlson, 1 − h subtracted")
          == within_relative(oracle::rolling_quarter(ball, {h, 1 - h}), 2e-15,
                             "right for the h that is left"));
    for(const int n : counts)
      CHECK(now.method("quarter", "steps of ϑ, " + std::to_string(n))
            == within_relative(by_steps<Fifty>(ball, e, n, exact::pi() / 2),
                               1e-13 + 1e-31 / double(abs(e.from_top)),
                               "the rule in fifty digits; the last step feels the rounding of its angle"));
  }
  for(const Told& now : told_at(""))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Fifty one = sqrt(2 * g.fifty() * ball.c);
    for(const auto& point : now.points("times", 6))
    {
      CHECK(point.value("h") == between(0, 3, "what is drawn"));
      CHECK(point.value("rolling")
            == within_relative(2 * oracle::rolling_quarter(ball, energy(Fifty(point.at("h")))) / one, 1e-11,
                               "what an ulp of h is of 1 − h"));
    }
    for(const auto& point : now.points("smooth", 6))
    {
      CHECK(point.value("h") == between(0, 3, "what is drawn"));
      CHECK(
          point.value("smooth")
          == within_relative(2 * oracle::smooth_quarter(ball.c, ball.k, energy(Fifty(point.at("h")))) / one,
                             1e-11, "what an ulp of h is of 1 − h"));
    }
  }
}

/*!
In {{eq 1}} our copy has lost a $d$: with $a\Phi/dt$ there would be no progress at all where Φ is nothing. The
point of contact is at rest if the centre goes with {{progress|5}} feet a second, our ball's $a\zeta$ with
$h = \tfrac12$.
*/

double our_zeta()
{
  return std::sqrt(8 * 15.625 * 0.1 * 0.5 / 1.17);
}

const Emendation rolling_start{"§29, ds/dt at the start",
                               {"aΦ/dt", 0.},
                               {"a dΦ/dt", [] { return our_zeta(); }},
                               "the point of contact is at rest",
                               [](double progress) {
                                 return progress - our_zeta()
                                        == within(0, 1e-15, "the progress less a times the turning");
                               }};

/*!
## Go on from here

::: exercise
Two equal balls are sent off with the same ζ, one on ice, one rolling. Which of them turns over more easily?

answer: The one that rolls: by {{eq A}} it has $bb:kk$ times the other's $h$. Our ball turns over from
{{zeta_rolling|4}} radians a second on, on ice from {{zeta_smooth|4}}.
:::
*/

CHECK_THAT("the ball that rolls turns over from a smaller ζ on")
{
  for(const Told& now : told_at("", "c=0.5 k=0.5", "a=1e20 c=3e20 k=1e19"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Fifty gc = 8 * g.fifty() * ball.c;
    CHECK(now.value("zeta_rolling", Unit{"1/s"})
          == within_relative(sqrt(gc / bb(ball)), 2e-15, "(A) with h = 1"));
    CHECK(now.value("zeta_smooth", Unit{"1/s"}) == within_relative(sqrt(gc) / ball.k, 2e-15, "§16"));
    CHECK(sqrt(gc / bb(ball)) < sqrt(gc) / ball.k);
  }
}
