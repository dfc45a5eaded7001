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

only that he has $\tfrac1{1080}$ for the last fraction. The time in seconds stands here as an angle, and one
second is an angle of about 57°. To look at the balance every half second he therefore writes for $t$ in turn
0°, 30°, 60°, 90°, 120° and so on, and enters the three angles of every moment in a table. A sixth he counts
as ten degrees, so that $\tfrac1{720}$ is 5′ and $\tfrac1{1080}$ is 3⅓′. The table shows, he says, that the
pans' motion is irregular by so little that in practice hardly anybody could notice it; and no greater value,
it seems, can ever be given to the number $i$.

::: margin
Euler's degree is here a sixtieth of the radius, {{his_degree|4}}° of ours, and his minute a 3600th. The
degrees and minutes of this page are his.
:::

## The program

Formula {{eq 1}} is shared with the sections before.

::: code balance/euler.hpp euler (1)
:::

What it leaves free the reader may change. The full equations need one number more, the share
$\rho = Laa/(M(kk+cc)+2Laa)$ of one pan in the inertia of the whole, which the example leaves open.
*/

const auto mu =
    real("mu", 3, Unit{"1/s"}, closed(1, 10), "frequency of the pans, μ = √(2g/b); the beam's is 1");
const auto i = real("i", 0.25, Unit{"1/s"}, closed(0.1, 1), "Euler's number i = λμμa/4g");
const auto m = angle("m", 1. / 6, closed(-20_deg, 20_deg), "inclination of the beam at the start");
const auto n = angle("n", 1. / 6, closed(-20_deg, 20_deg), "inclination of the pan P at the start");
const auto n1 = angle("n1", 1. / 6, closed(-20_deg, 20_deg), "inclination n′ of the pan Q at the start");
const auto rho = real("rho", 0.25, none, closed(0, 0.45), "share of one pan in the whole inertia");

const auto given = [] { return Release{1, mu, i, {m, n, n1}, rho}; };
const double period = 2 * std::numbers::pi;  // of the beam

/*!
The full equations are those of {{sec balance.07}} to {{sec balance.09}} without the two tensions;
$\beta = a/b = 2i/\lambda$ is the ratio of arm to string.

::: code balance/balance.hpp accelerations
:::

With them {{api balance::Motion}} integrates the motion. So every row of the table is filled in twice.
*/

std::string written(double angle)  // in degrees and minutes of Euler's
{
  const long minutes = std::lround(std::abs(3600 * angle));
  const std::string sign = angle < 0 && minutes > 0 ? "−" : "";
  return sign + std::to_string(minutes / 60) + "°\u00a0" + std::to_string(minutes % 60) + "′";
}

TELL
{
  auto& rows =
      table("rows", "Every half second, that is, every 30° of λt: by (1), and by the full equations",
            {{"t", "t"},
             {"omega", "ω by (1)"},
             {"eta", "η"},
             {"theta", "ϑ"},
             {"omega_full", "ω in full"},
             {"eta_full", "η"},
             {"theta_full", "ϑ"}});
  for(int row = 0; const State<>& full : course(balance_of(given()), {given().at, {}}, period, 12))
  {
    const Angles<> by_1 = euler(given(), row * 30_deg), at = full.at;
    const std::string label = (row == 1 ? "" : std::to_string(row / 2)) + (row % 2 == 1 ? "½" : "");
    rows.row({label, written(by_1.omega), written(by_1.eta), written(by_1.theta), written(at.omega),
              written(at.eta), written(at.theta)});
    ++row;
  }
}

/*!
How far is the formula from the truth, and why? Two steps lie between them. The first makes the solution
*complete* to the second order, {{api balance::second_order}}: Euler keeps the product $\eta\omega$ but drops
another term of the same order, the sideways pull that comes from the arcs of $A$ and $B$
({{sec balance.13}}). The second makes the pan's period longer by the factor $1 + \tfrac1{16}nn$, as that of
any pendulum of amplitude $n$ is ({{sec pendulum.10}}).
*/

const auto by_1 = [](const Release& r, double t) { return euler(r, t).eta; };
const auto complete = [](const Release& r, double t) { return second_order(balance_of(r), r.at, t).eta; };
const auto longer = [](const Release& r, double t) {
  return second_order(with_longer_period(balance_of(r), r.at.eta), r.at, t).eta;
};

/*!
How much each misses is looked for through a whole period of the beam.

::: code balance/euler.hpp departure
:::
*/

constexpr Unit minutes{"′", 3600};

TELL
{
  const Angles<> half_way = course(balance_of(given()), {given().at, {}}, period, 2)[1].at;
  const Angles<> by_formula = euler(given(), period / 2);
  tell("his_degree", 1. / 60, degrees, "Euler's degree in ours: a sixth of the radius counts as ten");
  tell("added", i * m * n * (1 / (2 * mu - 1) + 1 / (2 * mu + 1)), minutes,
       "the fractions of (2) together");
  tell("missed", departure(given(), by_1), minutes,
       "the most that (1) misses of η in a period of the beam");
  tell("left", departure(given(), longer), minutes, "what is left of that after both steps");
  tell("apart", half_way.theta - half_way.eta, minutes, "ϑ less η at λt = 180°");
  tell("apart_by_1", by_formula.theta - by_formula.eta, minutes, "the same by (1)");
  tell("eta_at_six", written(by_1(given(), 6)), "η by (1) at 6 seconds");
  tell("phase_missed", mu * (period - 6), degrees, "what μt then lacks of the last row");
}

TELL
{
  curve("strays", {"angle", "eta", "theta", "by_1_eta", "by_1_theta"}, [r = given()](Curve& c) {
    for(double degree = 0; const State<>& full : course(balance_of(r), {r.at, {}}, period, 360))
    {
      const Angles<> regular = small_motion(balance_of(r), {r.at, {}}, degree * 1_deg);
      const Angles<> by_1 = euler(r, degree * 1_deg);
      c.put({degree++, 3600 * (full.at.eta - regular.eta), 3600 * (full.at.theta - regular.theta),
             3600 * (by_1.eta - regular.eta), 3600 * (by_1.theta - regular.theta)});
    }
  });
}

/*!
{{table rows}}

The beam keeps to Euler's formula within a few minutes. The pans do not: half-way, at 180°, they stand
{{apart|f0}}′ apart, where {{eq 1}} has {{apart_by_1|f0}}′. In one period of the beam P departs from {{eq 1}}
by up to {{missed|f1}}′, while what the formula adds to a regular swing is {{added|f1}}′ at most: he leaves
out nearly three times what he keeps. After both steps only {{left|f1}}′ remain.

::: figure balance-36
alt: Minutes by which the two pans stray from regular swings, over one period of the beam. By Euler's formula,
with points at the thirteen moments of his table, they stay within 9 minutes and mirror each other. By the
full equations they swing three times as far, at first against each other, in the end together.

How far the pans stray from regular swings, $n\cos\mu t$; the points are the moments of Euler's table. In
truth the pans stray more than twice as far. At first they do so against each other, by the term that he
drops; in the end together, because both lag.
:::

The times, too, are only roughly right. In half a second the angle is a little less than 30°, and it adds up:
at 6 seconds $\mu t$ still lacks {{phase_missed|3}}°, and by his own formula P is then at {{eta_at_six}}, not
at the 10° of his last row.

## Speed against error
*/

TELL
{
  const Release r = given();
  const Balance<> b = balance_of(r);
  const State<> start{r.at, {}};
  const double t = period / 2;
  std::vector<Method> ways{{"the pan alone, n cos μt", [=] { return small_motion(b, start, t).eta; }},
                           {"Euler's formula (1)", [=] { return by_1(r, t); }},
                           {"complete second order", [=] { return complete(r, t); }}};
  for(const int steps : {20, 80, 320, 1280})
    ways.push_back({"Runge-Kutta, " + std::to_string(steps) + " steps",
                    [=] { return runge_kutta(b, start, t, steps).at.eta; }, "Runge-Kutta, equal steps"});
  for(const int digits : {4, 8, 12})
    ways.push_back({"GSL rk8pd, 1e-" + std::to_string(digits),
                    [=] { return by_gsl(b, start, t, std::pow(10, -digits)).at.eta; }, "GSL rk8pd"});
  for(const int digits : {4, 8, 12})
    ways.push_back({"Gauss, 1e-" + std::to_string(digits),
                    [=] { return Motion(b, start, std::pow(10, -digits)).to(t).at.eta; },
                    "Gauss, 8 stages"});
  race("eta", "η at λt = 180°", oracle(b, start, t).at.eta, ways);
}

/*!
## Checks

Of the table the scan has kept, in each of thirteen rows, the degrees and minutes of $\omega$ and one number
more; all signs, the minutes of η and the whole of $\vartheta$ are lost.
*/

constexpr int scan[13][3]{{10, 0, 10}, {8, 40, 0}, {5, 0, 10}, {0, 0, 0}, {5, 0, 9},
                          {8, 40, 0},  {10, 0, 9}, {8, 40, 0}, {5, 0, 9}, {0, 0, 0},
                          {5, 0, 10},  {8, 40, 0}, {10, 0, 10}};

constexpr double by_1008 = 600. * 6 / 1008, by_1080 = 600. * 6 / 1080;  // the last fraction, in minutes

double pan(int side, double t, double last)  // (2) in minutes, η for side 1, ϑ for side −1
{
  return 600 * std::cos(3 * t) + side * (5 * std::cos(2 * t) - last * std::cos(4 * t));
}

bool fits(int side, double last)  // the third numbers of the rows are its degrees
{
  bool all = true;
  for(int row = 0; row < 13; ++row)
    all = all && std::lround(std::abs(pan(side, row * 30_deg, last))) / 60 == scan[row][2];
  return all;
}

CHECK_THAT("a second is about 57°; (1) with the numbers of § 35 is (2), and gives all 39 numbers")
{
  const char* const because = "phases up to 26, rounded, times 600";
  CHECK(1 / 1_deg == printed("57"));
  for(int row = 0; row < 13; ++row)
  {
    const auto& [omega, eta, theta] = euler(example_of_35, row * 30_deg);
    CHECK(std::lround(std::abs(3600 * omega)) == 60 * scan[row][0] + scan[row][1]);
    CHECK(3600 * eta == within(pan(1, row * 30_deg, by_1008), 1e-12, because));
    CHECK(3600 * theta == within(pan(-1, row * 30_deg, by_1008), 1e-12, because));
  }
  CHECK(fits(1, by_1008));
  CHECK(fits(1, by_1080));
}

/*!
The last fraction is wrong, and was so already in {{sec balance.35}}. It makes a difference of a minute in
five rows; which minutes were printed there cannot be told.
*/

const Erratum last_fraction{
    "§36, the last fraction",
    {"1/1080", 1. / 1080},
    {"1/1008", 1. / 1008},
    "imn/(2μ+λ); Euler's own slip, since his derivative in §35 has four times 1/1080, 1/270",
    [](double reading) {  // −cos 4t, driven by −imn cos 4t, must satisfy x″ + 9x = imn·cos 4t
      return (16 - 9) * reading == within_ulps(1. / 4 / 36, 2, "two roundings");
    }};

const Undecided minutes_of_eta{"§36, table, minutes of η at 0°, 90°, 180°, 270°, 360°",
                               {"2′, 8′, 58′, 8′, 2′", by_1080},
                               {"1′, 9′, 59′, 9′, 1′", by_1008},
                               "1/1080 or 1/1008; the same for ϑ",
                               [](double last) { return fits(1, last); }};

const Doubtful last_minutes{
    "§36, the minutes of 1/1080",
    {"3½′", 3.5},
    {"3⅓′", 10. / 3},
    "600′·6/1080; but the scan has ½ for another fraction too, in the same sentence",
    [](double reading) { return reading * 1080 == within_ulps(3600, 1, "one product"); }};

const Emendation ten_degrees{
    "§36, the fraction for ten degrees",
    {"1/2", 1. / 2},
    {"1/6", 1. / 6},
    "only then 1/720 is 5′, as he says next",
    [](double reading) { return 600 / reading / 720 == within_ulps(5, 2, "two divisions"); }};

const Emendation column{"§36, table, heading of the third numbers",
                        {"ϑ", -1},
                        {"η", 1},
                        "ϑ would begin with 9° and have 10° in the middle",
                        [](double side) { return fits(static_cast<int>(side), by_1080); }};

const Doubtful labels{"§36, table, the times",
                      {"0, ½, 1½, 2, … 6½", 6.5},
                      {"0, ½, 1, 1½, … 6", 6},
                      "thirteen rows are twelve half seconds",
                      [](double last) { return 1 + 2 * last == std::size(scan); }};

/*!
Then the motion. The energy does not occur in the equations that are integrated, and yet it keeps its value.
When all angles are made ten times smaller, the error of an approximation falls a hundredfold where it is
complete to the first order, a thousandfold where to the second. Euler's falls a hundredfold: he has terms of
the second order, but not all.
*/

CHECK_THAT("over one period of the beam the full motion keeps its energy")
{
  Motion motion(balance_of(example_of_35), {example_of_35.at, {}});
  motion.to(period);
  CHECK(motion.energy_drift() == within(0, 1e-12, "some fifty steps, each to rounding"));
}

CHECK_THAT("Euler's formula errs by the square of the angles, the complete one by the cube")
{
  const Release large{1, 3, 0.25, {1. / 60, 1. / 60, 1. / 60}, 0.25};
  const Release small{1, 3, 0.25, {1. / 600, 1. / 600, 1. / 600}, 0.25};
  CHECK(departure(large, by_1) / departure(small, by_1)
        == between(99, 101, "10², and a part of the next order"));
  CHECK(departure(large, complete) / departure(small, complete)
        == between(980, 1020, "10³, and as before"));
}

/*!
## Notes

That hardly anybody would notice remains true of one period: {{missed|f0}}′ in ten degrees are little. But the
two causes differ in kind. The missing term of the second order comes and goes with the beam, as those that
Euler kept. The longer period is of the third order, beyond what his equations for very small angles can show,
and it accumulates: with every swing each pan lags a little more behind the table.

The number that can hardly be greater has lost its letter in the scan. It must be $i$, which
{{sec balance.34}} makes the measure of the irregularity. But his own balance there has a greater one, before
he rounds it down.
*/
