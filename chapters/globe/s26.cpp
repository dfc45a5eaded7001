#include "edition/section.hpp"
#include "globe/asked.hpp"
#include "globe/rolling.hpp"

SECTION(globe, 26, "The friction as a fraction of cos Φ")

using namespace globe;

/*!
## What Euler does

The friction that rolling takes becomes a formula in the angle and the constant $C$, free of every
differential. What has to be worked out is the left side of the equation of {{sec globe.24}},
$kk\,dd\Phi/ddx$; it is done by substitution alone, and it is the longest calculation of the paper. The
equation of {{sec globe.25}} gives

$$ dd\Phi = \frac{-(2gc\,dt^2 + ac\,d\Phi^2){{entry both_negative}}\sin\Phi}{aa+cc+kk-2ac\cos\Phi}, \tag{1} $$

and its integral gives $2g\,dt^2$. With that put in, one factor goes out of the first member:

$$ \begin{aligned} dd\Phi ={}& \frac{-c\,d\Phi^2\sin\Phi}{2C+2c\cos\Phi{{entry twice_C}}} \\
   &- \frac{ac\,d\Phi^2\sin\Phi}{aa+cc+kk-2ac\cos\Phi}. \end{aligned} \tag{2} $$

The denominator of the fraction that is sought, $ddx$, follows,

$$ \begin{aligned} &a\,dd\Phi - c\,dd\Phi\cos\Phi + c\,d\Phi^2\sin\Phi \\
   &\quad = \frac{c\,d\Phi^2\sin\Phi\,(2C+3c\cos\Phi-a)}{2C+2c\cos\Phi}{{entry three_c}} \\
   &\qquad - \frac{ac(a-c\cos\Phi)\,d\Phi^2\sin\Phi}{aa+cc+kk-2ac\cos\Phi{{entry inertia}}}.
   \end{aligned} \tag{3} $$

Now all members have $d\Phi^2$, and it goes out too. The left side of that equation is

$$ \begin{gathered} -\frac{ckk\sin\Phi}{2C+2c\cos\Phi} \\
   {}- \frac{ackk\sin\Phi}{aa+cc+kk-2ac\cos\Phi}{{entry upper}} \\ \text{over} \\
   \frac{c\sin\Phi(2C+3c\cos\Phi-a)}{2C+2c\cos\Phi}{{entry lower}} \\
   {}- \frac{ac(a-c\cos\Phi)\sin\Phi}{aa+cc+kk-2ac\cos\Phi}, \end{gathered} \tag{4} $$

and, both multiplied by the two denominators{{entry cleared}}, all but $\cos\Phi$ cancels. There remains

$$ \begin{gathered} -kk(aa+cc+kk+2aC){{entry above}} \\ \text{over} \\
   kk(3c\cos\Phi+2C-a) \\ {}+ 2Cc(c-a\cos\Phi) \\
   {}- a^3{{entry below}} + 3aac\cos\Phi \\
   {}- acc(1+4\cos^2\Phi) + 3c^3\cos\Phi, \end{gathered} \tag{5} $$

which has to equal $-a + c\cos\Phi + \frac c\lambda\sin\Phi$. {{sec globe.27}} calls it $S$.

::: margin
Today: friction and normal force of a rolling body follow from its acceleration; that their ratio depends on
the place and the energy alone is the conservation of energy.
:::

Hardly a line of this stands in our copy as it must be; *Checks* has what it has. But the calculation leaves
no choice, and the result is right: the fraction is exactly what the accelerations ask for.

It can be written shorter. With $N = aa+cc+kk+2aC$, $D = aa+cc+kk-2ac\cos\Phi$ and
$y = a - c\cos\Phi$ the denominator of {{eq 5}} is $-L$, and

$$ S = \frac{kkN}{L}, \qquad L = yN - 2(C+c\cos\Phi)D. \tag{A} $$

$N$ is never zero, so $S$ is not either; but $L$ may vanish, and there $S$ is infinite, and no friction is
needed. That happens at the angle Φ with the energy

$$ \begin{aligned} h &= \frac{y\,bb + 4c\sin^2\tfrac12\Phi\,D}{4c\,(cc+kk-ac\cos\Phi)}, \\
   bb &= (a-c)^2 + kk, \end{aligned} \tag{B} $$

where $C = c(2h-1)$. And with $S$ put into the equation the poles go: as $S + y = DQ/L$,

$$ \begin{aligned} \lambda &= \frac{c\sin\Phi\,L}Q, \qquad Q = \frac{\Pi}{P}\,DD, \\
   Q &= DD - ccN\sin^2\Phi \\ &\quad + 2c\cos\Phi\,(C+c\cos\Phi)D. \end{aligned} \tag{C} $$

## The program

Euler's fraction as it stands, and the shorter one.
*/

template <class Real>
Real S_of_Euler(const Ball<Real>& ball, const Real& C, const Real& u)  // (5), u = cos Φ
{
  const Real &a = ball.a, &c = ball.c, &k = ball.k;
  const Real above = -k * k * (a * a + c * c + k * k + 2 * a * C);
  return above
         / (k * k * (3 * c * u + 2 * C - a) + 2 * C * c * (c - a * u) - a * a * a + 3 * a * a * c * u
            - a * c * c * (1 + 4 * u * u) + 3 * c * c * c * u);
}

template <class Real>
Real S_by_products(const Ball<Real>& given, const Energy<Real>& e, const Place<Real>& at)  // (A)
{
  const Ball<Real> ball = in_own_measure(given);
  const auto& [a, c, k, gap] = ball;
  const Real ss = at.s * at.s, D = bb(ball) + 4 * a * c * ss, N = bb(ball) + 4 * a * c * e.h;
  const Real L = (gap + 2 * c * ss) * N - 4 * c * left_for_motion(e, at) * D;
  return k * k * N / L * (given.a / a);
}

template <class Real>
Real free_energy(const Ball<Real>& given, const Place<Real>& at)  // (B)
{
  const Ball<Real> ball = in_own_measure(given);
  const auto& [a, c, k, gap] = ball;
  const Real ss = at.s * at.s, D = bb(ball) + 4 * a * c * ss;
  const Real h = ((gap + 2 * c * ss) * bb(ball) / c + 4 * ss * D) / (4 * (k * k + c * (2 * a * ss - gap)));
  return h > 0 ? h : Real(infinity);
}

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the ball's centre to its centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen in the first second; for ζ alone");
const auto asked = asked_energy(3);
const auto where = asked_place(60_deg);

TELL
{
  require_rolling(rounded_ball(a, c, k));
  const Ball<Fifty> ball = exact_ball(a, c, k);
  const Energy<Fifty> e = asked.rolling(a, c, k, g);
  const Place<Fifty> there = where.fifty();
  require(gets_to(e, there), where.psi == 0 ? "Phi" : "psi", "an angle that the ball gets to");
  tell("energy", double(e.h), "h, the energy as a part of what the top asks for");
  tell("S", double(S_by_products(ball, e, there)), feet, "the fraction S, by (A)");
  tell("lambda", double(rolling::friction(ball, e, there)), "λ, friction over pressure, by (C)");
  tell("pressure", double(rolling::pressure(ball, e, there)), "Π/P, what the plane bears");
  tell("h_free", double(free_energy(ball, there)),
       "the energy with which no friction is needed there, (B)");
}

TELL
{
  auto& energies =
      table("energies", "More and more energy, at this angle",
            {{"h", "energy", none, 4}, {"S", "S", feet}, {"lambda", "λ"}, {"pressure", "Π/P"}});
  const Ball<Fifty> ball = exact_ball(a, c, k);
  const Place<Fifty> there = where.fifty();
  for(const double more : {0.0, 0.5, 2.0, 8.0, 12.0, 24.0})
  {
    const Energy<Fifty> e = energy(Fifty(there.s * there.s + more));
    energies.row({double(e.h), double(S_by_products(ball, e, there)),
                  double(rolling::friction(ball, e, there)), double(rolling::pressure(ball, e, there))});
  }
}

TELL
{
  curve("round", {"Phi_deg", "S", "lambda", "h"}, [](Curve& round) {
    const Ball<double> ball = rounded_ball(a, c, k);
    const double free = std::min(free_energy(ball, place(120_deg)), 1e9);
    bool first = true;
    for(const double h : {0.92 * free, free, 1.08 * free})
    {
      if(!first)
        round.block();
      first = false;
      for(double Phi = 0.5; Phi < 180; Phi += 1)
      {
        const Place<double> at = place(Phi * std::numbers::pi / 180);
        if(at.s * at.s <= h)
          round.put({Phi, S_by_products(ball, energy(h), at) / ball.a,
                     rolling::friction(ball, energy(h), at), h});
      }
    }
  });
}

/*!
At 60°, with three times the energy for the top, $S$ is {{S|5}} feet and $\lambda$ is {{lambda|4}}; with
$h = {{h_free|4}}$ the ball would roll through that angle without friction.

{{table energies}}

::: figure globe-26
alt: Two panels over the angle. Above the fraction S for three energies: a curve above zero, one below, and
one that goes to infinity at 120° and comes back from the other side. Below the friction ratio for the same:
an arc above zero, one below, and one that crosses zero at 120°.

Euler's fraction (above, over $a$) and the friction (below): with the energy for which none is needed at 120°
(green), a little less (blue) and a little more (purple). Where $S$ is infinite $\lambda$ changes its sign.
:::

## Speed against error

$\lambda$ may be reckoned through Euler's fraction, from the accelerations, or by {{eq C}}. Near a pole of
$S$ all three lose the digits that $\lambda$ itself loses there. But near the top, and where the centre of
gravity comes close to the plane, it is only {{eq C}}, written in $\sin\tfrac12\Phi$, $\cos\tfrac12\Phi$ and
$a - c$, that keeps them: try `--psi 1e-9rad`, or `--c 0.999999 --k 1e-6 --Phi 1e-6rad`.
*/

double lambda_by_accelerations(const Ball<double>& ball, double ww, double Phi)
{
  const auto rolls = rolling_accelerations<double>(ball, 0.5, Phi, std::sqrt(ww));
  return -rolls.x / rolls.pressure;
}

TELL
{
  const Ball<double> ball = in_own_measure(rounded_ball(a, c, k));
  const Energy<Fifty> exact_e = asked.rolling(a, c, k, g);
  const Place<Fifty> exact_at = where.fifty();
  const Energy<double> e = rounded(exact_e);
  const Place<double> at = rounded(exact_at);
  const double Phi = 2 * std::atan2(at.s, at.c), s = std::sin(Phi), u = std::cos(Phi);
  const double C = ball.c * (2 * e.h - 1), ww = rolling::velocity_squared(ball, e, at) * ball.c;
  const Fifty lambda = rolling::friction(exact_ball(a, c, k), exact_e, exact_at);
  if(lambda == 0)
    return;  // at 0 and 180° there is nothing to reckon
  race("lambda", "λ", lambda,
       {{"Euler's fraction (5)",
         [=] { return ball.c * s / (S_of_Euler(ball, C, u) + ball.a - ball.c * u); }},
        {"the accelerations", [=] { return lambda_by_accelerations(ball, ww, Phi); }},
        {"without S, (C)", [=] { return rolling::friction(ball, e, at); }}});
}

/*!
## Checks

All is held against the acceleration of the rolling ball and the force that it asks for, in fifty digits.
*/

struct Exactly
{
  Fifty ddPhi, ddx, S, lambda, pressure;  // with 2g = 1
  Fifty ww;                               // dΦ²/dt²
};

Exactly by_motion(const Ball<Fifty>& ball, const Energy<Fifty>& e, const Place<Fifty>& at)
{
  const Fifty s = 2 * at.s * at.c, u = at.c * at.c - at.s * at.s,
              D = bb(ball) + 4 * ball.a * ball.c * at.s * at.s;
  const Fifty left = e.h < 0.5 ? Fifty(e.h - at.s * at.s) : Fifty(at.c * at.c - e.from_top);
  const Fifty ww = 4 * ball.c * left / D, ddPhi = -s * ball.c * (1 + ball.a * ww) / D;
  const Fifty x = ball.a * ddPhi - ball.c * ddPhi * u + ball.c * ww * s;
  const Fifty pressure = 1 + ball.c * (ddPhi * s + ww * u);
  return {ddPhi, x, ball.k * ball.k * ddPhi / x, -x / pressure, pressure, ww};
}

CHECK_THAT("Euler's fraction (5) is kk ddΦ/ddx, and so is (A); with either λ and Π are those of the motion")
{
  for(const Ball<Fifty>& ball : {our_ball<Fifty>, cradle<Fifty>, Ball<Fifty>{3, 5, 2}})
    for(const Fifty& h : {Fifty("0.7"), Fifty(1), Fifty("5.3"), Fifty(90)})
      for(const Fifty& Phi : {Fifty("0.4"), Fifty("1.2"), Fifty("1.9")})
      {
        const auto m = by_motion(ball, energy(h), place(Phi));
        const Fifty S = S_of_Euler(ball, ball.c * (2 * h - 1), cos(Phi)), y = ball.a - ball.c * cos(Phi);
        CHECK(S == within_relative(m.S, 1e-44, "fifty digits"));  // (5)
        CHECK(S_by_products(ball, energy(h), place(Phi))
              == within_relative(m.S, 1e-44, "fifty digits"));  // (A)
        CHECK(-ball.a + ball.c * cos(Phi) + ball.c / m.lambda * sin(Phi)
              == within_relative(S, 1e-43, "the equation of §24"));
        CHECK(rolling::friction(ball, energy(h), place(Phi))  // (C)
              == within_relative(ball.c * sin(Phi) / (S + y), 1e-43, "fifty digits"));
      }
}

CHECK_THAT("what is told, and what the race comes to, is what the motion asks for")
{
  for(const Told& now :
      told_at("", "c=0.5 k=0.5 h=0.9 Phi=130", "c=3 h=0.2 Phi=10", "a=1e-80 c=1e-79 k=1e-81 h=40",
              "from_top=1e-20 psi=1e-9rad", "h=1e30 c=1e-15", "zeta=7 g=2", "h=9.67"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Energy<Fifty> e = asked.rolling(a, c, k, g);
    const Place<Fifty> at = where.fifty();
    const auto m = by_motion(ball, e, at);
    const Fifty u = at.c * at.c - at.s * at.s, y = ball.a - ball.c * u,
                N = bb(ball) + 4 * ball.a * ball.c * e.h;
    const Fifty D = bb(ball) + 4 * ball.a * ball.c * at.s * at.s, L = abs(ball.k * ball.k * N / m.S);
    const Fifty Q = m.pressure * D * D;
    const Fifty common = e.h < 0.5 ? e.h : Fifty(abs(e.from_top) + at.c * at.c);
    const Fifty kept = abs(y) * N + 4 * ball.c * common * D;
    const double of_L = 2e-15 * double(kept / L),
                 of_Q = 2e-15
                        * double((D * D + ball.c * ball.c * N + 4 * ball.c * ball.c * common * D) / abs(Q));
    const char* const because = "some roundings of the summands";
    CHECK(now.value("energy") == within_relative(e.h, 2e-16, "rounded once"));
    CHECK(now.value("S", feet) == within_ulps(m.S, 1, "rounded once"));
    CHECK(now.value("lambda") == within_ulps(m.lambda, 1, "rounded once"));
    CHECK(now.value("pressure") == within_ulps(m.pressure, 1, "rounded once"));
    CHECK(now.exact("lambda") == within_relative(m.lambda, 1e-40, "the motion, in fifty digits"));
    CHECK(now.method("lambda", "without S, (C)") == within_relative(m.lambda, of_L + of_Q, because));
    // These two form what they need by subtraction; the angle is rounded too.
    const double rough = 8 * (of_L + of_Q) + 1e-14 / std::min(double(at.s), double(at.c));
    CHECK(now.method("lambda", "the accelerations") == within_relative(m.lambda, rough, because));
    CHECK(now.method("lambda", "Euler's fraction (5)")
          == within_relative(m.lambda, rough * double(1 + abs(m.S / (m.S + y))), because));
  }
}

CHECK_THAT("at rest, with G close to the plane, and where little pressure is left, what is told has all "
           "its digits")
{
  for(const Told& now : told_at("h=0.5 Phi=90", "c=0.999999999 k=1e-9 h=0.4 Phi=1e-5", "h=40.2 psi=1e-7"))
  {
    const auto m = by_motion(exact_ball(a, c, k), asked.rolling(a, c, k, g), where.fifty());
    CHECK(now.value("S", feet) == within_ulps(m.S, 1, "rounded once"));
    CHECK(now.value("lambda") == within_ulps(m.lambda, 1, "rounded once"));
    CHECK(now.value("pressure") == within_ulps(m.pressure, 1, "rounded once"));
  }
}

CHECK_THAT("a place beyond the one where the ball turns back is refused, and a ball with c = a and k below "
           "1e-20 a")
{
  for(const char* const within_them :
      {"h=0.25 Phi=60", "from_top=1e-300 psi=2e-150rad", "c=1 k=1e-20", "a=2 c=2 k=2e-20"})
    CHECK(!refused_at(within_them));
  for(const char* const beyond :
      {"h=0.25 Phi=60.00000000000000000001", "from_top=1e-300 psi=1.99999999999999999999e-150rad",
       "c=1 k=9.9999999999999e-21", "a=2 c=2 k=1.9999999999999e-20"})
    CHECK(refused_at(beyond));
}

CHECK_THAT("a ζ is refused together with 1 − h, and where its h is less than 1e-100 or more than 1e100")
{
  for(const char* const within_them : rolling_within)
    CHECK(!refused_at(within_them + std::string(" Phi=0")));
  for(const char* const beyond : rolling_beyond)
    CHECK(refused_at(beyond + std::string(" Phi=0")));
}

CHECK_THAT("near the top, and with G close to the plane, (C) keeps its digits, and the other ways lose "
           "half of them")
{
  for(const Told& now : told_at("psi=1e-9rad", "c=0.999999 k=1e-6 Phi=1e-6rad"))
  {
    const Fifty exact = by_motion(exact_ball(a, c, k), asked.rolling(a, c, k, g), where.fifty()).lambda;
    CHECK(now.method("lambda", "without S, (C)") == within_relative(exact, 1e-14, "some roundings"));
    const Ball<double> ball = rounded_ball(a, c, k);
    const Place<double> at = rounded(where.fifty());
    const double Phi = 2 * std::atan2(at.s, at.c), u = std::cos(Phi);
    const double through = c * std::sin(Phi) / (S_of_Euler(ball, c * (2 * asked.h - 1), u) + a - c * u);
    CHECK(std::abs(through / double(exact) - 1) > 1e-11);
  }
}

CHECK_THAT("with the energy of (B) no friction is needed, and S changes from above every number to below")
{
  for(const Told& now :
      told_at("", "c=0.5 k=0.5 Phi=100", "a=1e50 c=1e-50 k=1e40 Phi=170", "c=1.5 k=0.1 Phi=5 h=2"))
  {
    const Ball<Fifty> ball = exact_ball(a, c, k);
    const Place<Fifty> at = where.fifty();
    const Fifty u = at.c * at.c - at.s * at.s, y = ball.a - ball.c * u;
    if(y * (ball.c * ball.c + ball.k * ball.k - ball.a * ball.c * u) < 0)
    {
      CHECK(now.value("h_free") == infinite("none is enough"));
      continue;
    }
    // dds of a ball without friction is a ddΦ: y = v (cc + kk − ac cos Φ), and v of §25
    const Fifty v = y / (ball.c * ball.c + ball.k * ball.k - ball.a * ball.c * u);
    const Fifty h = at.s * at.s + v * (bb(ball) + 4 * ball.a * ball.c * at.s * at.s) / (4 * ball.c);
    CHECK(now.value("h_free") == within_ulps(h, 1, "rounded once"));
    const auto less = by_motion(ball, energy(Fifty(h * (1 - Fifty("1e-9")))), at),
               more = by_motion(ball, energy(Fifty(h * (1 + Fifty("1e-9")))), at);
    CHECK((less.lambda > 0 && more.lambda < 0 && less.S > 0 && more.S < 0));
  }
}

CHECK_THAT("the table and the curves are what the motion asks for")
{
  for(const Told& now : told_at("", "c=0.5 k=0.5 h=0.9 Phi=130", "a=1e-80 c=1e-81 k=1e-80 h=40",
                                "c=0.999999999 k=1e-9 Phi=1e-9rad"))
  {
    const std::array<double, 6> more{0, 0.5, 2, 8, 12, 24};
    const auto rows = now.rows("energies");
    CHECK(rows.size() == more.size());
    for(std::size_t i = 0; i < more.size(); ++i)
    {
      const Place<Fifty> at = where.fifty();
      const Energy<Fifty> e = energy(Fifty(at.s * at.s + more.at(i)));
      const auto m = by_motion(exact_ball(a, c, k), e, at);
      const char* const because = "fifty digits, rounded once";
      CHECK(rows[i].value("h") == within_ulps(e.h, 1, because));
      CHECK(rows[i].value("S", feet) == within_ulps(m.S, 1, because));
      CHECK(rows[i].value("lambda") == within_ulps(m.lambda, 1, because));
      CHECK(rows[i].value("pressure") == within_ulps(m.pressure, 1, because));
    }
  }
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("round", 11))
    {
      const Ball<Fifty> ball = exact_ball(a, c, k);
      const Fifty Phi = Fifty(point.at("Phi_deg")) * exact::pi() / 180;
      const auto m = by_motion(ball, energy(Fifty(point.at("h"))), place(Phi));
      CHECK(point.value("Phi_deg") == between(0, 180, "half a turn"));
      CHECK(point.value("h") == between(9, 11, "three energies"));
      CHECK(point.value("S") == within_relative(m.S / ball.a, 1e-12, "of the sum a hundredth is left"));
      CHECK(point.value("lambda") == within(m.lambda, 1e-14, "some roundings"));
    }
}

/*!
What our copy has is tried line by line on our ball at 60° with $h = 3$: each line with its own damage, all
else right. Where it has the letter e, $c$ is taken for it, as in {{sec globe.24}}.
*/

struct Our_state
{
  double a = 1, c = 0.1, kk = 0.36, C = 0.5, u = 0.5, s = std::sqrt(0.75);
  double D = a * a + c * c + kk - 2 * a * c * u, N = a * a + c * c + kk + 2 * a * C;
  double ww = 2 * (C + c * u) / D, V = 2 * C + 2 * c * u;  // 2g = 1
  double upper = -c * kk * s / V - a * c * kk * s / D;     // of (4)
  double lower = c * s * (2 * C + 3 * c * u - a) / V - a * c * (a - c * u) * s / D;
  double below = kk * (3 * c * u + 2 * C - a) + 2 * C * c * (c - a * u) - a * a * a + 3 * a * a * c * u
                 - a * c * c * (1 + 4 * u * u) + 3 * c * c * c * u;
};

const Our_state o;

Exactly ours()
{
  return by_motion(our_ball<Fifty>, energy(Fifty(3)), place(Fifty(exact::pi() / 3)));
}

bool is_ddPhi(double reading)
{
  return reading == within_relative(ours().ddPhi, 1e-14, "the equation of motion");
}

bool is_ddx(double reading)
{
  return reading == within_relative(ours().ddx, 1e-13, "the equation of motion");
}

bool is_S(double reading)
{
  return reading == within_relative(ours().S, 1e-12, "kk ddΦ/ddx of the motion");
}

const Emendation both_negative{"§26, the first equation",
                               {"(−2gc dt² + ac dΦ²)", (-o.c + o.a * o.c * o.ww) * o.s / o.D},
                               {"−(2gc dt² + ac dΦ²)", -(o.c + o.a * o.c * o.ww) * o.s / o.D},
                               "the next line has both members negative, and so has the motion",
                               is_ddPhi};

const Emendation twice_C{
    "§26, the second equation, the first denominator",
    {"aC + c cos Φ", -o.c* o.ww* o.s / (o.a * o.C + o.c * o.u) - o.a* o.c* o.ww* o.s / o.D},
    {"2C + 2c cos Φ", -o.c* o.ww* o.s / o.V - o.a* o.c* o.ww* o.s / o.D},
    "the integral gives 2g dt² so, and the motion has that acceleration",
    is_ddPhi};

const Emendation three_c{"§26, the third equation, the first fraction",
                         {"(aC + c cos Φ − a)/(aC + c cos Φ)",
                          o.ww*(o.c* o.s*(o.a* o.C + o.c * o.u - o.a) / (o.a * o.C + o.c * o.u)
                                - o.a * o.c * (o.a - o.c * o.u) * o.s / o.D)},
                         {"(2C + 3c cos Φ − a)/(2C + 2c cos Φ)", o.ww* o.lower},
                         "(2) put in, and the motion has that acceleration",
                         is_ddx};

const Emendation inertia{
    "§26, the third equation, the second denominator",
    {"aC + cc − kk − 2ac cos Φ",
     o.ww*(o.c* o.s*(2 * o.C + 3 * o.c * o.u - o.a) / o.V
           - o.a * o.c * (o.a - o.c * o.u) * o.s / (o.a * o.C + o.c * o.c - o.kk - 2 * o.a * o.c * o.u))},
    {"aa + cc + kk − 2ac cos Φ", o.ww* o.lower},
    "it is that of (2), and the motion has that acceleration",
    is_ddx};

const Emendation upper{
    "§26, the fourth formula, above",
    {"ckk sin Φ/a(c + c cos Φ) − ackk sin Φ/(aa + cc + kk − 2acc cos Φ)",
     (o.c * o.kk * o.s / (o.a * o.c * (1 + o.u))
      - o.a * o.c * o.kk * o.s / (o.N - 2 * o.a * o.C - 2 * o.a * o.c * o.c * o.u))
         / o.lower},
    {"−ckk sin Φ/(2C + 2c cos Φ) − ackk sin Φ/(aa + cc + kk − 2ac cos Φ)", o.upper / o.lower},
    "it is kk times (2), and the motion has that ratio",
    is_S};

const Emendation lower{"§26, the fourth formula, below",
                       {"(ae + 3c cos Φ − a)/(2c + 2c cos Φ); ae(a − c cos Φ)",
                        o.upper
                            / (o.c * o.s * (o.a * o.c + 3 * o.c * o.u - o.a) / (2 * o.c * (1 + o.u))
                               - o.a * o.c * (o.a - o.c * o.u) * o.s / o.D)},
                       {"(2C + 3c cos Φ − a)/(2C + 2c cos Φ); ac(a − c cos Φ)", o.upper / o.lower},
                       "it is (3), and the motion has that ratio",
                       is_S};

const Emendation cleared{
    "§26, the fourth formula, cleared of fractions",
    {"[ckk(aa + cc + kk − 2acc cos Φ) − (c + c cos Φ) ackk] / [c(2c + 3cc cos Φ − a)(…) − (2c + 2cc cos Φ) "
     "ac(…)]",
     (o.c * o.kk * (o.N - 2 * o.a * o.C - 2 * o.a * o.c * o.c * o.u) - o.c * (1 + o.u) * o.a * o.c * o.kk)
         / (o.c * (2 * o.c + 3 * o.c * o.c * o.u - o.a) * (o.N - 2 * o.a * o.C - 2 * o.a * o.c * o.c * o.u)
            - (2 * o.c + 2 * o.c * o.c * o.u) * o.a * o.c * (o.a - o.c * o.u))},
    {"[−ckk(aa + cc + kk − 2ac cos Φ) − (2C + 2c cos Φ) ackk] / [c(2C + 3c cos Φ − a)(…) − (2C + 2c cos Φ) "
     "ac(…)]",
     (-o.c * o.kk * o.D - o.V * o.a * o.c * o.kk)
         / (o.c * (2 * o.C + 3 * o.c * o.u - o.a) * o.D - o.V * o.a * o.c * (o.a - o.c * o.u))},
    "(4) with both parts multiplied by the denominators, and the motion has that ratio",
    is_S};

const Emendation above{"§26, the last fraction, above",
                       {"kk(aa + cc + kk − 2ac)", o.kk*(o.N - 2 * o.a * o.C - 2 * o.a * o.c) / o.below},
                       {"−kk(aa + cc + kk + 2aC)", -o.kk* o.N / o.below},
                       "§27 comes to (aa + kk)² with this alone, and the motion has that ratio",
                       is_S};

const Emendation below{
    "§26, the last fraction, below",
    {"kk(3cc cos Φ + 2c − a) + 2cc(c − a cos Φ) − a³ + 3acc cos Φ − …",
     -o.kk* o.N
         / (o.kk * (3 * o.c * o.c * o.u + 2 * o.c - o.a) + 2 * o.c * o.c * (o.c - o.a * o.u)
            - o.a * o.a * o.a + 3 * o.a * o.c * o.c * o.u - o.a * o.c * o.c * (1 + 4 * o.u * o.u)
            + 3 * o.c * o.c * o.c * o.u)},
    {"kk(3c cos Φ + 2C − a) + 2Cc(c − a cos Φ) − a³ + 3aac cos Φ − …", -o.kk* o.N / o.below},
    "every member must be a solid of three dimensions, and the motion has that ratio",
    is_S};

CHECK_THAT("each letter of the last denominator is needed: changed alone as in our copy it makes S wrong")
{
  const double right = o.kk * o.N / double(-ours().S);
  CHECK(o.below == within_relative(right, 1e-13, "(5) by the motion"));
  for(const double change : {o.kk * 3 * o.u * (o.c * o.c - o.c), o.kk * 2 * (o.c - o.C),
                             2 * o.c * (o.c - o.a * o.u) * (o.c - o.C), 3 * o.a * o.c * o.u * (o.c - o.a)})
    CHECK(std::abs(change / o.below) > 0.01);
}

/*!
## Go on from here

::: exercise
At which angles is there no energy with which a ball rolls through without friction, however fast it turns?
answer: Where the divisor of {{eq B}} is not positive, $\cos\Phi \ge (cc+kk):ac$. Our ball, with $cc + kk$
greater than $ac$, has no such angle. With $c = \frac12a$ and $k = \frac14a$ there are, up to
$\cos\Phi = \frac58$ or 51°: friction holds it back there on the way up, with any energy.
`--c 0.5 --k 0.25 --Phi 51` and `--Phi 52` show it.
:::
*/

CHECK_THAT("where ac cos Φ exceeds cc + kk friction is backwards on the way up, however fast the ball is")
{
  CHECK(acos(Fifty(5) / 8) * 180 / exact::pi() == between(51, 52, "51°19′"));
  for(const Told& now :
      told_at("c=0.5 k=0.25 Phi=51", "c=0.5 k=0.25 Phi=51 h=1e9", "c=0.5 k=0.25 Phi=1 h=1e30"))
  {
    CHECK(now.value("h_free") == infinite("none is enough"));
    CHECK(now.value("pressure") == between(0, infinity, "it bears the ball"));
    CHECK(now.value("lambda") == between(1e-3, 100, "backwards"));
  }
  for(const Told& now : told_at("c=0.5 k=0.25 Phi=52"))
    CHECK(now.value("h_free") == between(1, 1e3, "something over a small divisor"));
  for(const Told& now : told_at("c=0.5 k=0.25 Phi=52 h=1e9"))
    CHECK(now.value("lambda") == between(-100, -1e-3, "forwards"));
}
