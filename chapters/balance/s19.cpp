#include "balance/euler.hpp"
#include "edition/section.hpp"

SECTION(balance, 19, "Six constants for six data")

using namespace balance;

/*!
## What Euler does

In the formulae found, the known must be distinguished from what is still unknown. Known are the distances
$a$, $b$ and $c$ and the weights $L$ and $M$, and what has been made of them, $f$, λ and μ. Unknown are six:

$$ \mathfrak A,\quad \mathfrak B,\quad \mathfrak C,\qquad \alpha,\quad \beta,\quad \gamma. \tag{1} $$

(Our copy has another letter for β.) That is as it must be. Three equations of the second order were
integrated twice, and each integration brings an arbitrary constant; and so the nature of the thing demands.
For a state from which the motion begins is not given by three angles alone. One has to say also what motion
was imparted to the beam and to either pan. So in every case six conditions have to be met.

The count is right, but a count does not say that the six can always be found. They can be written down at
once. The beam stands alone and gives $\mathfrak C\sin\gamma = \omega$,
$\lambda\mathfrak C\cos\gamma = d\omega:dt$, both for $t = 0$. With ℭ and γ known, the formula of
{{sec balance.17}} and its rate are linear in $s = \mathfrak A\sin\alpha$ and $r = \mathfrak A\cos\alpha$.
If

$$ H = \frac{\lambda\mu\mu a\,\mathfrak C}{4g\,(4\mu\mu-\lambda\lambda)}, \tag{A} $$

then at $t = 0$

$$ \begin{aligned}
\eta &= (1 + 2\lambda H\sin\gamma)\,s\\ &\quad + 4\mu H\cos\gamma\,r,\\
\frac{d\eta}{dt} &= -(4\mu\mu-2\lambda\lambda)H\cos\gamma\,s\\
   &\quad + \mu\,(1 - 2\lambda H\sin\gamma)\,r,
\end{aligned} \tag{B} $$

and for Q the same with $-H$. Two equations with two unknowns; they have a solution if their determinant,

$$ \begin{aligned} \mu\bigl[1 &- 4\lambda\lambda HH\sin^2\gamma\\
   &+ 8(2\mu\mu-\lambda\lambda)HH\cos^2\gamma\bigr], \end{aligned} \tag{C} $$

is not zero. It contains $H$ by its square only and is the same for both pans. For a slow beam it is nearly μ.
Near $\lambda = 2\mu$, where $H$ has no bound, it passes through zero: there are states from which no motion
of Euler's form begins, and others from which many do ({{sec balance.27}}).

::: margin
Today: the map from constants to initial data is invertible where {{eq C}} does not vanish.
:::

A consequence is easily overlooked. The amplitude 𝔄 of the regular swing is not the angle by which the pan
is pulled aside, nor is α = 90° when it is let go at rest. Both depend on where the beam is at that moment.

## The program

{{api balance::constants_of}} solves {{eq B}}.
*/

const Unit per_second{"1/s"};
const auto lambda = real("lambda", 1, per_second, closed(1e-6, 1e6), "frequency of the beam, λ = √(2g/f)");
const auto mu = real("mu", 3, per_second, closed(1e-6, 1e6), "frequency of the pans, μ = √(2g/b)");
const auto a = real("a", 16. / 9, feet, closed(1e-20, 1e20), "half the beam");
const auto g = real("g", 16, feet, closed(1e-20, 1e20), "height fallen in the first second");
const auto omega = angle("omega", 0.1, closed(-90_deg, 90_deg), "ω at the start");
const auto eta = angle("eta", 0.12, closed(-90_deg, 90_deg), "η at the start");
const auto theta = angle("theta", -0.08, closed(-90_deg, 90_deg), "ϑ at the start");
const auto omega_rate = real("omega_rate", 0.05, per_second, closed(-1e3, 1e3), "dω/dt at the start");
const auto eta_rate = real("eta_rate", -0.2, per_second, closed(-1e3, 1e3), "dη/dt at the start");
const auto theta_rate = real("theta_rate", 0.3, per_second, closed(-1e3, 1e3), "dϑ/dt at the start");

State<> start()
{
  return {{omega, eta, theta}, {omega_rate, eta_rate, theta_rate}};
}

double determinant()  // (C), over μ
{
  const double C = std::hypot(omega, omega_rate / lambda), less = 2 * mu - lambda, more = 2 * mu + lambda;
  if(C == 0)
    return 1;
  const double H = i_of<double>(lambda, mu, a, g) * C / (less * more);
  const double sine = 2 * lambda * H * (omega / C), cosine = 4 * mu * H * (omega_rate / lambda / C);
  return (1 - sine) * (1 + sine) + cosine * cosine * (1 - lambda * lambda / (2 * mu * mu));
}

TELL
{
  require(lambda != 2 * mu, "lambda", "not 2 mu, where H is infinite");
  require(std::abs(determinant()) > 1e-3, "omega", "such that the determinant (C) is more than μ/1000");
  require(std::abs(determinant()) < 1e100, "a", "such that the determinant (C) is below 1e100 μ");
  const Constants<> k = constants_of(lambda, mu, i_of<double>(lambda, mu, a, g), start()).constants;
  tell("A", k.A, radians, "𝔄, amplitude of the pan P");
  tell("B", k.B, radians, "𝔅, of the pan Q");
  tell("C", k.C, radians, "ℭ, of the beam");
  tell("alpha", k.alpha, degrees, "phase α of P at the start");
  tell("beta", k.beta, degrees, "phase β of Q");
  tell("gamma", k.gamma, degrees, "phase γ of the beam");
  tell("determinant", determinant(), "the determinant (C) over μ");
}

/*!
The same pan, pulled aside by $n$ and let go at rest, at different moments of the beam's swing.
*/

Constants<> let_go(double ratio, double phase)  // n = 1, μ = 1, a:b = ½, ℭ = ⅙
{
  const State<> at{{std::sin(phase) / 6, 1, 0}, {ratio * std::cos(phase) / 6, 0, 0}};
  return constants_of(ratio, 1, ratio / 4, at).constants;
}

TELL
{
  curve("moments", {"gamma", "third", "equal", "faster"}, [](Curve& out) {
    for(int j = 0; j <= 360; j += 2)
    {
      const double phase = j * 1_deg;
      const auto more = [phase](double ratio) { return 100 * (let_go(ratio, phase).A - 1); };
      out.put({static_cast<double>(j), more(1. / 3), more(1), more(1.5)});
    }
  });
}

/*!
From the state given, the pan P has the amplitude {{A|6}} and the phase {{alpha|deg2}}, the pan Q {{B|6}} and
{{beta|deg2}}, the beam {{C|6}} and {{gamma|deg2}}. The determinant is {{determinant|8}} μ: the problem is
well posed.

::: figure balance-19
alt: By how many per cent the amplitude of the pan exceeds its release, against the phase of the beam. For a
beam with a third of the pan's frequency the curve is nearly level; for equal frequencies it is a wave of a
few per cent, for a beam one and a half times as fast one of more than ten.

By how much the amplitude 𝔄 exceeds the angle at which a pan is let go from rest, against the phase γ at which
the beam then is; for beams of a third, once, one and a half times the frequency of the pans
($\mathfrak C = \tfrac16$, $a:b = \tfrac12$).
:::

## Checks

For the check {{eq B}} is not used. The general formula itself, in fifty digits, is put to $t = 0$, once with
α = 0 and once with α = 90°; that gives the four coefficients.
*/

struct Solved
{
  Fifty amplitude, phase, determinant, size;
};

Solved solved_for(int side)  // 1 for P, −1 for Q
{
  const Fifty l = lambda.fifty(), u = mu.fifty(), i = i_of<Fifty>(l, u, a.fifty(), g.fifty());
  const Fifty w = omega.fifty(), ww = omega_rate.fifty() / l;
  const Fifty C = sqrt(w * w + ww * ww), gamma = C == 0 ? Fifty(0) : atan2(w, ww);
  const auto at_0 = [&](const Fifty& phase) {
    const State<Fifty> now = general<Fifty>(l, u, i, {1, 1, C, phase, phase, gamma}, 0);
    return side > 0 ? std::array<Fifty, 2>{now.at.eta, now.rate.eta}
                    : std::array<Fifty, 2>{now.at.theta, now.rate.theta};
  };
  const std::array<Fifty, 2> by_sine = at_0(exact::pi() / 2), by_cosine = at_0(0);
  const Fifty value = side > 0 ? eta.fifty() : theta.fifty(),
              rate = side > 0 ? eta_rate.fifty() : theta_rate.fifty();
  const Fifty det = by_sine[0] * by_cosine[1] - by_cosine[0] * by_sine[1];
  const Fifty s = (value * by_cosine[1] - by_cosine[0] * rate) / det;
  const Fifty r = (by_sine[0] * rate - value * by_sine[1]) / det;
  // how far roundings of the coefficients may move s and r
  const Fifty size = (abs(value * by_cosine[1]) + abs(by_cosine[0] * rate) + abs(by_sine[0] * rate)
                      + abs(value * by_sine[1]))
                     / abs(det);
  return {sqrt(s * s + r * r), s == 0 && r == 0 ? Fifty(0) : atan2(s, r), det / u, size};
}

CHECK_THAT("the constants told are those with which the general formula starts as it should")
{
  for(const Told& now :
      told_at("", "lambda=0.02 mu=5 a=0.7 omega=-80 eta=70 theta=-3 omega_rate=0 eta_rate=9 theta_rate=-20",
              "lambda=1.9 mu=1 a=0.1 omega=20 omega_rate=-0.3",
              "lambda=7 mu=3 omega=0 omega_rate=-0.2 eta=1e-9", "omega=0 omega_rate=0 eta=30 eta_rate=0",
              "lambda=1e-6 a=1e-3 mu=2 eta=-9", "lambda=1e3 mu=1 eta=-30"))
  {
    const Fifty l = lambda.fifty(), u = mu.fifty();
    const double near = double(1 + u / abs(2 * u - l));
    const Solved P = solved_for(1), Q = solved_for(-1);
    const double allowed = 4e-15 * near * (1 + double(1 / abs(P.determinant)));
    const char* const why = "a dozen roundings, over the determinant";
    CHECK(now.value("A", radians) == within(P.amplitude, allowed * double(P.size), why));
    CHECK(now.value("B", radians) == within(Q.amplitude, allowed * double(Q.size), why));
    CHECK(now.value("alpha", degrees) == within(P.phase, allowed * double(P.size / P.amplitude), why));
    CHECK(now.value("beta", degrees) == within(Q.phase, allowed * double(Q.size / Q.amplitude), why));
    const Fifty w = omega.fifty(), ww = omega_rate.fifty() / l;
    CHECK(now.value("C", radians) == within_relative(sqrt(w * w + ww * ww), 1e-15, "few roundings"));
    const Fifty gamma = w == 0 && ww == 0 ? Fifty(0) : atan2(w, ww);
    CHECK(now.value("gamma", degrees) == within(gamma, 1e-15, "few roundings"));
    CHECK(now.value("determinant")
          == within(P.determinant, allowed * (1 + double(abs(P.determinant))), "products of it"));
    CHECK(Q.determinant == within_relative(P.determinant, 1e-40, "it has H by its square only"));
  }
}

CHECK_THAT("a beam of twice the pans' frequency is refused, and the next doubles are not")
{
  for(const char* const infinite : {"lambda=6", "lambda=1 mu=0.5"})
    CHECK(refused_at(infinite));
  for(const char* const beside : {"lambda=5.9999999999999991", "lambda=6.0000000000000009"})
    CHECK(!refused_at(beside));
}

CHECK_THAT("a determinant within μ/1000 of zero is refused, on either side of it, and one from 1e100 μ on")
{
  // 1 − ss, s being ω : 0.88 at λ = 5, and 1e50 at a = 6e19 and λ = μ = 1e6
  const std::string near_zero = "lambda=5 omega_rate=0 omega=", great = "lambda=1e6 mu=1e6 g=1e-20 a=";
  for(const char* const angle : {"0.879559891rad", "0.88rad", "0.880439889rad"})
    CHECK(refused_at(near_zero + angle));
  for(const char* const angle : {"0.879559889rad", "0.880439891rad"})
    CHECK(!refused_at(near_zero + angle));
  CHECK(refused_at(great + "6.0000000001e19"));
  CHECK(!refused_at(great + "5.9999999999e19"));
}

CHECK_THAT(
    "where K is 1 no motion of the form begins: the determinant vanishes there, and the program refuses")
{
  for(const double m : {1. / 6, -1. / 6})
  {
    const double root = lambda_where_K_is_one(3, 16. / 9, 16, m);
    const std::string at = "omega=0.16666666666666666rad omega_rate=0 lambda=" + std::to_string(root);
    CHECK(refused_at(at.c_str()));
  }
}

CHECK_THAT("in the figure the pan's amplitude is that with which the formula of § 17 starts at n, at rest")
{
  for(const Told& now : told_at(""))
    for(const auto& point : now.points("moments", 7))
    {
      const Fifty phase = Fifty(point.at("gamma")) * exact::pi() / 180;
      const auto hold = [&](const char* column, const Fifty& ratio) {
        const Fifty H = ratio / 4 / 6 / (4 - ratio * ratio);
        // release from rest at 1: Cramer's rule with (B)
        const Fifty s1 = 1 + 2 * ratio * H * sin(phase), r1 = 4 * H * cos(phase),
                    s2 = -(4 - 2 * ratio * ratio) * H * cos(phase), r2 = 1 - 2 * ratio * H * sin(phase);
        const Fifty det = s1 * r2 - r1 * s2;
        CHECK(point.value(column)
              == within(100 * (sqrt(r2 * r2 + s2 * s2) / det - 1), 2e-13,
                        "a difference from 1, in per cent"));
      };
      hold("third", Fifty(1) / 3);
      hold("equal", 1);
      hold("faster", Fifty(3) / 2);
    }
  double slow = 0, fast = 0;
  for(int j = 0; j < 360; ++j)
  {
    slow = std::max(slow, std::abs(let_go(1. / 3, j * 1_deg).A - 1));
    fast = std::max(fast, std::abs(let_go(1.5, j * 1_deg).A - 1));
  }
  CHECK(slow == between(0.002, 0.003, "nearly level"));
  CHECK(fast == between(0.1, 0.13, "more than a tenth"));
}

/*!
## Go on from here

::: exercise
A pan is pulled aside by 10° and let go at rest while the beam passes through the level, rising at $A$. Is its
phase α then 90°, and does the other pan, treated alike, have the same?

answer: Neither. With `--omega 0 --omega_rate 0.16666666666666666 --eta 10 --eta_rate 0 --theta 10`
`--theta_rate 0` α is 89.23° and β is as much above 90°. In their regular swings, then, P has still to reach
its highest point and Q has passed it; the side tones make up for it.
:::
*/

CHECK_THAT("let go together at rest under a level beam the pans have phases on either side of 90°")
{
  for(const Told& now :
      told_at("omega=0 omega_rate=0.16666666666666666 eta=10 theta=10 eta_rate=0 theta_rate=0"))
  {
    const double lean = std::atan(34. / 3 / 840);  // (4μμ − 2λλ)H:μ, H = im:35 = 1/840
    CHECK(now.value("alpha", degrees) == within(90_deg - lean, 1e-15, "few roundings"));
    CHECK(now.value("beta", degrees) == within(90_deg + lean, 1e-15, "few roundings"));
    CHECK((90_deg - lean) / 1_deg == printed("89.23"));
  }
}
