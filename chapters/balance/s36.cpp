#include "balance/euler.hpp"
#include "edition/section.hpp"

SECTION(balance, 36, "A table of the motion, every half second")

using namespace balance;

/*!
## What Euler does

To see how far the pans stray from regular swings Euler tabulates an example through a whole period of the
beam. In {{sec balance.33}} he had found how beam and pans move when all three are let go from rest, the beam
at the angle $m$, the pans at $n$ and $n'$:

$$ \begin{aligned}
\omega &= m\cos\lambda t,\\
\eta &= n\cos\mu t + \frac{imn}{2\mu-\lambda}\cos(\mu-\lambda)t
  - \frac{imn}{2\mu+\lambda}\cos(\mu+\lambda)t,\\
\vartheta &= n'\cos\mu t - \frac{imn'}{2\mu-\lambda}\cos(\mu-\lambda)t
  + \frac{imn'}{2\mu+\lambda}\cos(\mu+\lambda)t,
\end{aligned} \tag{1} $$

and {{sec balance.35}} chose an example: $\lambda = 1$ and $\mu = 3$, so that the pans swing three times
while the beam swings once; $i = \tfrac14$; and for all three angles about ten degrees, a sixth of the
radius. Then

$$ \omega = \tfrac16\cos t,\qquad \left.\begin{matrix}\eta\\ \vartheta\end{matrix}\right\}
 = \tfrac16\cos 3t \pm \left(\tfrac1{720}\cos 2t - \tfrac1{1008}\cos 4t\right), \tag{2} $$

only that he has $\tfrac1{1080}$ for the last fraction. The time in seconds stands under the cosines as an
angle, and one second is an angle of about 57°. To look at the balance every half second he therefore lets
$t$ run through 0°, 30°, 60° and so on, to the end of the beam's period. The sixth of the radius he counts as
ten degrees, so that $\tfrac1{720}$ is 5′ and the other fraction 3⅓′: together they move a pan by a few
minutes in ten degrees. He concludes that in practice hardly anybody would notice so small an irregularity,
and that it can hardly ever be greater, since no greater number $i$ seems possible.

::: margin
Euler's degree is here a sixtieth of the radius, {{his_degree|4}}° of ours, and his minute a 3600th. The
degrees and minutes of this page are his.
:::

## The program

Formula {{eq 1}} is shared with the sections before.

::: code balance/euler.hpp euler
:::

What it leaves free the reader may change. The full equations need one number more, the share
$\rho = Laa/(M(kk+cc)+2Laa)$ of one pan in the inertia of the whole, which has dropped out of {{eq 1}}.
*/

const auto lambda = real("lambda", 1, Unit{"1/s"}, closed(0.01, 100), "the beam's frequency λ = √(2g/f)");
const auto mu = real("mu", 3, Unit{"1/s"}, closed(0.01, 1000), "the pans' frequency μ = √(2g/b)");
const auto i = real("i", 0.25, Unit{"1/s"}, closed(0.001, 100), "Euler's number i = λμμa/4g");
const auto m = angle("m", 1. / 6, closed(-20_deg, 20_deg), "inclination of the beam at the start");
const auto n = angle("n", 1. / 6, above_to(0_deg, 20_deg), "inclination of the pan P at the start");
const auto n1 = angle("n1", 1. / 6, closed(-20_deg, 20_deg), "inclination n′ of the pan Q at the start");
const auto rho = real("rho", 0.25, none, closed(0, 0.45), "share of one pan in the whole inertia");

Release given()
{
  require(mu >= lambda / 10 && mu <= 10 * lambda, "mu", "from lambda/10 to 10 lambda");
  require(lambda != 2 * mu, "lambda", "anything but 2 mu, which makes a divisor of (1) zero");
  require(i >= lambda / 10 && i <= lambda, "i",
          "from lambda/10 to lambda (strings of five arms to half an arm)");
  return {lambda, mu, i, {m, n, n1}, rho};
}

/*!
In the full equations nothing is neglected. They are those of {{sec balance.07}} to {{sec balance.09}} after
the two tensions are eliminated; $\beta = a/b = 2i/\lambda$ is the ratio of arm to string.

::: code balance/balance.hpp accelerations
:::

First the table as Euler must have had it, with his $\tfrac1{1080}$. At its thirteen moments the cosines of
$2t$, $3t$ and $4t$ are 0, ±½ or ±1, so that the minutes of the pans are fractions.
*/

template <class Number>
Number pan(int side, int row, Number other)  // (2), in minutes: η for side 1, ϑ for side −1
{
  constexpr int cos_90[]{1, 0, -1, 0};                // of 0°, 90°, 180°, ...
  constexpr int twice_cos_60[]{2, 1, -1, -2, -1, 1};  // of 0°, 60°, 120°, ...
  const Number strays = 5 * Number(twice_cos_60[row % 6]) - other * twice_cos_60[2 * row % 6];
  return 600 * cos_90[row % 4] + side * strays / 2;
}

std::string written(double minutes)
{
  const long whole = std::lround(std::abs(minutes));
  const std::string sign = minutes < 0 && whole > 0 ? "−" : "";
  return sign + std::to_string(whole / 60) + "° " + std::to_string(whole % 60) + "′";
}

TELL
{
  auto& rows = table("printed", "Euler's table; the scan has lost all signs and what stands in ⟨ ⟩",
                     {{"t", "t (s)"}, {"omega", "ω"}, {"eta", "η"}, {"theta", "ϑ"}});
  for(int k = 0; k < 13; ++k)
  {
    const std::string theta = written(pan(-1, k, 600 * 6 / 1080.));
    std::string eta = written(pan(1, k, 600 * 6 / 1080.));
    eta.insert(eta.find(' ') + 1, "⟨");
    const std::string time = (k == 1 ? "" : std::to_string(k / 2)) + (k % 2 == 1 ? "½" : "");
    rows.row({time, written(600 * std::cos(k * 30_deg)), eta + "⟩", "⟨" + theta + "⟩"});
  }
}

/*!
Then the same thirteen moments by {{eq 1}} and by the full equations, which {{api balance::Motion}}
integrates.
*/

TELL
{
  auto& rows = table("rows", "The motion by (1), and by the full equations",
                     {{"angle", "λt", degrees}, {"omega", "ω by (1)"}, {"eta", "η"}, {"theta", "ϑ"},
                      {"omega_full", "ω in full"}, {"eta_full", "η"}, {"theta_full", "ϑ"}});
  const auto in_minutes = [](double angle) { return written(3600 * angle); };
  for(const auto& [t, full, by_1, second_order, lengthened] : one_period(given(), 12))
    rows.row({lambda * t, in_minutes(by_1.omega), in_minutes(by_1.eta), in_minutes(by_1.theta),
              in_minutes(full.omega), in_minutes(full.eta), in_minutes(full.theta)});
}

/*!
How far is the formula from the truth, and why? Two steps lie between them. The first makes the solution
*complete* to the second order, {{api balance::second_order}}: Euler keeps the product $\eta\omega$ but drops
another term of the same order, the sideways pull that comes from the arcs of $A$ and $B$
({{sec balance.13}}). The second makes the pan's period longer by the factor $1 + \tfrac1{16}nn$, as that of
any pendulum of amplitude $n$ is ({{sec pendulum.10}}).
*/

constexpr Unit minutes{"′", 3600};

TELL
{
  const Release r = given();
  const Departure most = greatest_departure(r);
  const Moment half_way = one_period(r, 2)[1];
  tell("his_degree", 1. / 60, degrees, "Euler's degree in ours: a sixth of the radius counts as ten");
  tell("first_fraction", i * m * n / (2 * mu - lambda), minutes, "coefficient of cos (μ−λ)t");
  tell("other_fraction", i * m * n / (2 * mu + lambda), minutes, "coefficient of cos (μ+λ)t");
  tell("strays", most.strays, minutes, "the most that (1) lets η stray from n cos μt");
  tell("from_euler", most.from_euler, minutes, "the most that η departs from (1) in one period of the beam");
  tell("from_second_order", most.from_second_order, minutes, "the same with the second order complete");
  tell("from_lengthened", most.from_lengthened, minutes, "the same with the pan's period longer too");
  tell("apart", half_way.exact.theta - half_way.exact.eta, minutes, "ϑ less η at λt = 180°");
  tell("apart_by_1", half_way.euler.theta - half_way.euler.eta, minutes, "the same by (1)");
  tell("eta_at_six", written(3600 * euler(r, 6 / lambda).eta), "η by (1) at λt = 6, his last time");
  tell("phase_missed", (2 * std::numbers::pi - 6) * mu / lambda, degrees, "what μt still lacks there");
}

/*!
The data of the figures, and the several ways to one number, $\eta$ when the beam has swung once to the other
side.
*/

TELL
{
  curve("motion", {"angle", "omega", "eta", "theta", "euler_omega", "euler_eta", "euler_theta", "strays",
                   "from_euler", "from_lengthened"}, [r = given()](Curve& c) {
    for(const Moment& now : one_period(r, 360))
    {
      const Departure d = departure(r, now);
      c.put({r.lambda * now.t / 1_deg, 60 * now.exact.omega, 60 * now.exact.eta, 60 * now.exact.theta,
             60 * now.euler.omega, 60 * now.euler.eta, 60 * now.euler.theta, 3600 * d.strays,
             3600 * d.from_euler, 3600 * d.from_lengthened});
    }
  });
}

TELL
{
  const Release r = given();
  const Balance<> b = balance_of(r);
  const State<> start{r.at, {}};
  const double t = std::numbers::pi / lambda;
  std::vector<Method> ways{{"the pan alone, n cos μt", [=] { return small_motion(b, start, t).eta; }},
                           {"Euler's formula (1)", [=] { return euler(r, t).eta; }},
                           {"complete second order", [=] { return second_order(b, r.at, t).eta; }}};
  for(int steps = 20; steps <= 1280; steps *= 4)
    ways.push_back({"Runge-Kutta, " + std::to_string(steps) + " steps",
                    [=] { return runge_kutta(b, start, t, steps).at.eta; }, "Runge-Kutta, equal steps"});
  for(int digits = 4; digits <= 14; digits += 2)
    ways.push_back({"GSL rk8pd, 1e-" + std::to_string(digits),
                    [=] { return Motion(b, start, std::pow(10, -digits)).to(t).at.eta; }, "GSL rk8pd"});
  race("eta", "η at λt = 180°", oracle(b, start, t).at.eta, ways);
}

/*!
The beam keeps to Euler's table within a few minutes. The pans do not: half-way, at 180°, they stand
{{apart|f0}}′ apart, where {{eq 1}} has {{apart_by_1|f0}}′.

::: figure balance-36
alt: Inclination of beam and both pans over one period of the beam. The beam goes down and up once, the pans
swing three times. Euler's points lie on the beam's curve; at the pans' turning points they lie between the
two pans' curves, which have come apart.

Beam and pans by the full equations, with the points of Euler's table. At their turnings P goes too far and Q
not far enough, while Euler's points are all but the same for both.
:::

In one period of the beam P departs from {{eq 1}} by up to {{from_euler|f1}}′, while what the formula adds to
a regular swing never exceeds {{strays|f1}}′: what he leaves out is nearly three times what he keeps. With
the second order complete {{from_second_order|f1}}′ are still missing, with the longer period as well only
{{from_lengthened|f1}}′. The missing term is greatest half-way. There the pan alone, without any of Euler's
terms, is nearer the truth, as the race shows: his $\cos 2t$ has the wrong sign. The lag grows all the time.

::: figure balance-36-departure
alt: Minutes of η over one period of the beam. What Euler's formula adds to a regular swing stays between
minus 9 and plus 5 minutes. The truth less his formula swings more and more widely, up to three times as far.
What is left after both steps stays small.

What Euler left out against what he kept, for the pan P. The thin line is what is left when the second order
is complete and the period lengthened.
:::

## Checks

First the readings. The scan has, in each of thirteen rows, the degrees and minutes of $\omega$ and one
number more. All 39 follow from the formula, whichever last fraction one takes.
*/

constexpr int scan[13][3]{{10, 0, 10}, {8, 40, 0}, {5, 0, 10}, {0, 0, 0}, {5, 0, 9}, {8, 40, 0}, {10, 0, 9},
                          {8, 40, 0}, {5, 0, 9}, {0, 0, 0}, {5, 0, 10}, {8, 40, 0}, {10, 0, 10}};

/// True when the third number of each row is the degrees of a pan, the other fraction being so many minutes.
bool fits(int side, double other)
{
  bool all = true;
  for(int k = 0; k < 13; ++k)
    all = all && std::lround(std::abs(pan(side, k, other))) / 60 == scan[k][2];
  return all;
}

CHECK_THAT("a second is about 57°, and the numbers of the table that the scan has kept follow from (1)")
{
  CHECK(1 / 1_deg == printed("57"));
  for(int k = 0; k < 13; ++k)
  {
    const double omega = std::abs(3600 * euler(example_of_35, k * 30_deg).omega);
    CHECK(std::lround(omega) == 60 * scan[k][0] + scan[k][1]);
  }
  CHECK(fits(1, 600 * 6 / 1080.));
  CHECK(fits(1, 600 * 6 / 1008.));
}

CHECK_THAT("formula (1) gives the minutes that exact fractions give")
{
  for(int k = 0; k < 13; ++k)
  {
    const Angles<> at = euler(example_of_35, k * 30_deg);
    const Rational other(600 * 6, 1008);
    CHECK(3600 * at.eta == within(Fifty(pan(1, k, other)), 1e-11, "phases up to 26, rounded, times 600"));
    CHECK(3600 * at.theta == within(Fifty(pan(-1, k, other)), 1e-11, "phases up to 26, rounded, times 600"));
  }
}

const Emendation column{
    "§36, table, heading of the third numbers", {"ϑ", -1}, {"η", 1},
    "ϑ would begin with 9° and have 10° in the middle",
    [](double side) { return fits(static_cast<int>(side), 600 * 6 / 1080.); }};

const Emendation labels{
    "§36, table, the times", {"0, ½, 1½, 2, … 6½", 6.5}, {"0, ½, 1, 1½, … 6", 6},
    "thirteen rows are twelve half seconds", [](double last) { return 2 * last == 12; }};

const Emendation ten_degrees{
    "§36, the fraction for ten degrees", {"1/2", 1. / 2}, {"1/6", 1. / 6},
    "only then 1/720 is 5′, as he says next",
    [](double reading) { return 600 / reading / 720 == within_ulps(5, 2, "two divisions"); }};

const Doubtful other_minutes{
    "§36, the minutes of 1/1080", {"3½′", 3.5}, {"3⅓′", 10. / 3},
    "600′·6/1080; but the scan has ½ for another fraction too, in the same sentence",
    [](double reading) { return reading == within_ulps(600 * 6 / 1080., 1, "one division"); }};

const Erratum other_fraction{
    "§36, the last fraction", {"1/1080", 1. / 1080}, {"1/1008", 1. / 1008},
    "imn/(2μ+λ); Euler's own slip, since his derivative in §35 has four times 1/1080, 1/270",
    [](double reading) { return reading == within_ulps(1 / (4. * 6 * 6 * 7), 1, "one division"); }};

/*!
With $\tfrac1{1080}$ five rows come out otherwise than with $\tfrac1{1008}$, by a minute. Which of them was
printed cannot be told from a scan without minutes; the table above supposes that he went on with his own
fraction, as in §35.
*/

const Undecided minutes_of_eta{
    "§36, table, minutes of η at 0°, 90°, 180°, 270°, 360°", {"2′, 8′, 58′, 8′, 2′", 600 * 6 / 1080.},
    {"1′, 9′, 59′, 9′, 1′", 600 * 6 / 1008.}, "1/1080 or 1/1008; the same for ϑ",
    [](double other) { return fits(1, other); }};

/*!
The times are only roughly right. In half a second the angle is a little less than 30°, and it adds up: at 6
seconds $\mu t$ still lacks {{phase_missed|3}}°, and by his own formula P is then at {{eta_at_six}}, not at
the 10° of his last row. Nor is $\tfrac14$ the greatest possible $i$. His own balance has more, before he
rounds its $i$ down for convenience.
*/

const Erratum last_time{
    "§36, table, the time of the last row", {"6", 6}, {"6,28", 2 * std::numbers::pi},
    "2π seconds, when the beam is back at 10° 0′",
    [](double t) { return std::lround(3600 * euler(example_of_35, t).omega) == 600; }};

const Erratum greatest_i{
    "§36, the greatest i", {"1/4", 1. / 4}, {"9/32, if not more", 9. / 32},
    "λμμa/4g in §35, with λ = 1, μ = 3, arms a of 2 feet and g of 16",
    [](double bound) { return bound >= 3. * 3 * 2 / (4 * 16); }};

/*!
Then the motion. The energy is not in the equations that are integrated, and yet it stays what it was. And
when all angles are made ten times smaller, the error of an approximation falls a hundredfold where it is
complete to the first order, a thousandfold where to the second. Euler's falls a hundredfold: he has terms of
the second order, but not all.
*/

CHECK_THAT("over one period of the beam the full motion keeps its energy and agrees with eighteen digits")
{
  const Balance<> b = balance_of(example_of_35);
  const State<> start{example_of_35.at, {}};
  Motion motion(b, start);
  const char* reason = "a hundred steps, each to 1e-13";
  CHECK(motion.to(6.28).at.eta == within(oracle(b, start, 6.28).at.eta, 1e-11, reason));
  CHECK(motion.energy_drift() == within(0, 1e-11, reason));
}

CHECK_THAT("Euler's formula errs by the square of the angles, the complete one by the cube")
{
  const Departure large = greatest_departure({1, 3, 0.25, {1. / 60, 1. / 60, 1. / 60}, 0.25});
  const Departure small = greatest_departure({1, 3, 0.25, {1. / 600, 1. / 600, 1. / 600}, 0.25});
  CHECK(large.from_euler / small.from_euler == between(99, 101, "10², and a part of the next order"));
  CHECK(large.from_second_order / small.from_second_order == between(980, 1020, "10³, and as before"));
}

CHECK_THAT("what the formula leaves out is over twice what it keeps, whatever the pans weigh")
{
  for(const double share : {0.0, 0.1, 0.25, 0.45})
  {
    const Departure d = greatest_departure({1, 3, 0.25, {1. / 6, 1. / 6, 1. / 6}, share});
    CHECK(d.from_euler / d.strays == between(2.6, 3.1, "24.6′ over 8.6′, and a tenth either way"));
  }
}

/*!
## Notes

That hardly anybody would notice remains true of one period: {{from_euler|f0}}′ in ten degrees are little.
But the two causes differ in kind. The missing term of the second order comes and goes with the beam, as
those that Euler kept. The longer period is of the third order, beyond what his equations for very small
angles can show, and it accumulates: with every swing each pan lags a little more behind the table.

The share $\rho$ matters little here, because the pulls of two pans that start alike cancel on the beam to
the second order. They do not when the pans start as mirror images; try `--n1 -9.5`.

Of the number that can hardly be greater the scan has lost the letter. It must be $i$, which
{{sec balance.34}} makes the measure of the irregularity.
*/
