#include "edition/section.hpp"
#include "globe/ball.hpp"

SECTION(globe, 5, "Two rules of mechanics")

using namespace globe;

/*!
## What Euler does

The motion of the ball is split in two, and for each half Euler recalls the rule that governs it. The centre
of gravity $G$ goes forward as if the whole mass were gathered in it and all forces were applied to it, each
in its own direction. And for the turning $G$ may be looked at as if it stood still: the moments of the
forces have to be taken about the axis that goes through $G$, and from them the acceleration of the turning
is to be found.

::: margin
Today: Newton's law for the centre of mass, and the law of the angular momentum about the centre of mass,
which has the same form however that moves.
:::

The first rule hardly surprises. The second is less innocent than it looks, for $G$ does *not* stand still,
and for other points of the ball the same rule would be wrong. Let $O$ be any point of the ball, $Pii$ its
moment of inertia about the axis through $O$, and let $G$ lie ξ in front of $O$ and η above it. The
particles, each with its own acceleration, need about $O$ the moment

$$ \frac P{2g}\Bigl(ii\,\frac{dd\Phi}{dt^2} + \eta X - \xi Y\Bigr), \tag{A} $$

counted in the sense of Φ, where $X$ and $Y$ are the accelerations of $O$ forwards and upwards. The rule
leaves out what is behind the first term. That vanishes in three cases only: $O$ is $G$; or $O$ has no
acceleration; or the acceleration of $O$ points along $OG$. The centre of a homogeneous ball belongs to the
first, the support of a pendulum to the second. For our ball the centre $C$, from which the eye would
reckon, belongs to none: it has the acceleration $dds/dt^2$, and misses

$$ -\,c\,\frac{dds}{dt^2}\cos\Phi. \tag{B} $$

## The program

The reader gives a state, and the friction. The library's accelerations, those of {{sec globe.06}} and
{{sec globe.07}}, say how the ball is moved; then the rule is tried about four points of it: $G$, $C$, the
lowest point $S$, and $A$, where the radius through $G$ ends.
*/

const auto a = real("a", 1, feet, scale, "radius of the ball");
const auto c = real("c", 0.1, feet, scale, "CG, from the centre to the centre of gravity");
const auto k = real("k", 0.6, feet, scale, "radius of gyration: the moment of inertia about G is Pkk");
const auto g = real("g", 15.625, feet, scale, "height fallen from rest in the first second");
const auto Phi = angle("Phi", 60_deg, closed(-1e12_deg, 1e12_deg), "angle ACS");
const auto w = real("w", 4, Unit{"1/s"}, closed(-1e30, 1e30), "dΦ/dt, angular velocity");
const auto lambda =
    real("lambda", 1. / 3, none, closed(-1e20, 1e20), "λ, friction over pressure, backwards");

struct Vector
{
  Fifty x, y;  // forwards and upwards
};

Fifty moment(const Vector& arm, const Vector& force)  // in the sense in which Φ grows
{
  return arm.y * force.x - arm.x * force.y;
}

struct Rule
{
  Fifty inertia, forces;  // ii, and the moment of the forces over P
  Fifty by_rule;          // the ddΦ/dt² that the rule would give
  Fifty missing;          // what it leaves out, ηX − ξY
};

Accelerations<Fifty> moved()
{
  return accelerations(Ball<Fifty>{a.fifty(), c.fifty(), k.fifty()}, g.fifty(), Phi.fifty(), w.fifty(),
                       lambda.fifty());
}

Rule rule_about(const Vector& O)  // seen from G
{
  const auto all = moved();
  const Fifty turning = all.Phi, ww = w.fifty() * w.fifty();
  const Fifty under = c.fifty() * sin(Phi.fifty()), height = a.fifty() - c.fifty() * cos(Phi.fifty());
  const Vector to_G{-O.x, -O.y}, to_S{under - O.x, -height - O.y};
  const Fifty inertia = k.fifty() * k.fifty() + O.x * O.x + O.y * O.y;
  const Fifty forces = moment(to_G, {0, -1}) + moment(to_S, {-lambda.fifty() * all.pressure, all.pressure});
  const Vector acceleration{all.x + turning * O.y - ww * O.x, all.y - turning * O.x - ww * O.y};
  return {inertia, forces, 2 * g.fifty() * forces / inertia, moment(to_G, acceleration)};  // (A)
}

Vector on_radius(const Fifty& from_C)  // on the line CGA, seen from G
{
  const Fifty beyond = from_C - c.fifty();
  return {-beyond * sin(Phi.fifty()), -beyond * cos(Phi.fifty())};
}

TELL
{
  const Fifty under = c.fifty() * sin(Phi.fifty()), height = a.fifty() - c.fifty() * cos(Phi.fifty());
  require(k.fifty() * k.fifty() > under * (lambda.fifty() * height - under), "lambda",
          "within the limit of §4 at this Φ");
  require(c.fifty() * w.fifty() * w.fifty() * cos(Phi.fifty()) >= -2 * g.fifty(), "w",
          "such that the plane still bears the ball");
  const Unit acceleration{"1/s²"};
  auto& points = table("points", "The rule tried about four points",
                       {{"O", "O"},
                        {"inertia", "ii (ft²)"},
                        {"forces", "moment over P (ft)"},
                        {"rule", "by the rule", acceleration, 9},
                        {"missing", "left out (ft²/s²)"},
                        {"right", "by (A)", acceleration, 9}});
  for(const auto& [name, O] :
      {std::pair{"G", Vector{0, 0}}, std::pair{"C", on_radius(0)}, std::pair{"S", Vector{under, -height}},
       std::pair{"A", on_radius(a.fifty())}})
  {
    const Rule rule = rule_about(O);
    points.row({name, double(rule.inertia), double(rule.forces), double(rule.by_rule), double(rule.missing),
                double(rule.by_rule - rule.missing / rule.inertia)});
  }
  tell("turning", double(moved().Phi), acceleration, "ddΦ/dt², by the moments about G");
  tell("about_C", double(rule_about(on_radius(0)).by_rule), acceleration,
       "what moments about C would give");
  tell("about_S", double(rule_about({under, -height}).by_rule), acceleration, "what those about S would");
}

TELL
{
  curve("radius", {"from_C", "rule", "right", "G"}, [](Curve& radius) {
    for(int n = -60; n <= 60; ++n)
      radius.put(
          {n / 60., double(rule_about(on_radius(n * a.fifty() / 60)).by_rule), double(moved().Phi), c / a});
  });
}

/*!
The ball of the example is quickened by {{turning|6}} a second in every second. Moments about the centre
would make that {{about_C|6}}, moments about $S$ even {{about_S|6}}; with what is left out all four points
agree.

{{table points}}

::: figure globe-05
alt: A curve and a horizontal line. The curve is the angular acceleration that moments about a point of the
diameter through C, G and A would give, against the place of that point. It crosses the line of the true
value at G.

The angular acceleration that the rule gives about the points of the diameter through $G$ (red), and the
true one (blue). They agree at $G$, and at one other point: the acceleration of that is directed to $G$, the
third case.
:::

## Checks

The ball is replaced by two particles with the same $G$ and $k$, those of {{sec globe.02}}. All that is used
is that each particle's acceleration times its mass is the force on it, and that the forces between them
cancel, in their sum and in their moments about a place of the plane that nothing moves. The accelerations
are second differences.
*/

struct Found
{
  Fifty turning, pressure;
};

Found by_particles()
{
  const Fifty a_ = a.fifty(), c_ = c.fifty(), k_ = k.fifty(), g_ = g.fifty(), w_ = w.fifty();
  const Fifty unit = g_ / (a_ + c_ + k_), h = Fifty(1e-12) / (abs(w_) + sqrt(unit));
  // What is lacking in the upward force and in the moment about the place where S is now, for a trial.
  const auto lacking = [&](const Fifty& turning, const Fifty& pressure) {
    const Fifty forwards = -2 * g_ * lambda.fifty() * pressure;
    const auto particle = [&](int side, const Fifty& t) {
      const Fifty at = Phi.fifty() + w_ * t + turning * t * t / 2;
      const Vector G{forwards * t * t / 2 - c_ * sin(Phi.fifty()), a_ - c_ * cos(at)};
      return Vector{G.x + side * k_ * cos(at), G.y - side * k_ * sin(at)};
    };
    Vector sum{0, 2 * g_ * (1 - pressure)};
    Fifty moments = 2 * g_ * moment({-c_ * sin(Phi.fifty()), 0}, {0, 1});
    for(const int side : {-1, 1})
    {
      const Vector before = particle(side, -h), now = particle(side, 0), after = particle(side, h);
      const Vector accelerated{(after.x - 2 * now.x + before.x) / (h * h),
                               (after.y - 2 * now.y + before.y) / (h * h)};
      sum.y += accelerated.y / 2;
      moments += moment(now, accelerated) / 2;
    }
    return Vector{sum.y, moments};
  };
  // The trial is linear in both unknowns: two equations, solved by Cramer's rule.
  const Vector none_ = lacking(0, 0), one = lacking(unit, 0), other = lacking(0, 1);
  const Fifty p = (one.x - none_.x) / unit, q = other.x - none_.x, r = (one.y - none_.y) / unit,
              s = other.y - none_.y, D = p * s - q * r;
  return {(q * none_.y - s * none_.x) / D, (r * none_.x - p * none_.y) / D};
}

CHECK_THAT("about every point the rule with what it leaves out gives the acceleration of two particles")
{
  for(const Told& now : told_at("", "lambda=-0.3 Phi=-130 w=2", "c=0.5 k=0.5 Phi=132 lambda=0.78 w=0",
                                "a=3e8 c=1e8 k=2e8 w=1e-4 lambda=0.1", "lambda=0 Phi=180 w=17.6"))
  {
    const Unit acceleration{"1/s²"};
    const Found found = by_particles();
    const double size = 2 * g / (a + c + k) + w * w,
                 slack = 1e-15 * double(abs(found.turning)) + 1e-18 * size;
    const char* const because = "the square of the step of the differences, and one rounding";
    CHECK(now.value("turning", acceleration) == within(found.turning, slack, because));
    const Fifty F = -lambda.fifty() * found.pressure, u = cos(Phi.fifty()), v = sin(Phi.fifty());
    const Fifty height = a.fifty() - c.fifty() * u;
    int n = 0;
    for(const auto& row : now.rows("points"))
    {
      CHECK(row.value("O") == std::string(1, "GCSA"[n]));
      CHECK(row.value("right", acceleration) == within(found.turning, slack, because));
      // The arms from O, read off the figure: those of the weight, the pressure and the friction.
      const Fifty beyond = n == 3 ? Fifty(a.fifty() - c.fifty()) : Fifty(-c.fifty());
      const Fifty weight = n == 0 ? Fifty(0) : n == 2 ? Fifty(-c.fifty() * v) : Fifty(beyond * v);
      const Fifty pressure = n == 0 ? Fifty(-c.fifty() * v) : n == 3 ? Fifty(-a.fifty() * v) : Fifty(0);
      const Fifty friction = n == 0   ? height
                             : n == 1 ? a.fifty()
                             : n == 2 ? Fifty(0)
                                      : Fifty(a.fifty() * (1 - u));
      const Fifty forces = weight + pressure * found.pressure - friction * F;
      const double about = double(abs(weight) + abs(pressure * found.pressure) + abs(friction * F));
      CHECK(row.value("forces") == within(forces, 1e-15 * double(abs(forces)) + 1e-18 * about, because));
      // What is told by the rule, and what it leaves out, are what these moments make them.
      const Fifty i = n == 0   ? k.fifty()
                      : n == 2 ? Fifty(hypot(hypot(k.fifty(), c.fifty() * v), height))
                               : Fifty(hypot(k.fifty(), beyond));
      CHECK(row.value("inertia") == within_ulps(i * i, 1, "rounded once"));
      const Fifty rule = 2 * g.fifty() * forces / (i * i),
                  left = 2 * g.fifty() * forces - i * i * found.turning;
      const double more = 1e-15 * double(abs(rule)) + 1e-18 * 2 * g * about / double(i * i);
      CHECK(row.value("rule", acceleration) == within(rule, more, because));
      CHECK(row.value("missing")
            == within(left, 1e-15 * double(abs(left)) + double(i * i) * (more + slack), "a difference"));
      if(n == 1)
        CHECK(now.value("about_C", acceleration) == within(rule, more, because));
      if(n == 2)
        CHECK(now.value("about_S", acceleration) == within(rule, more, because));
      ++n;
    }
    // (B)
    const Fifty dds = 2 * g.fifty() * F + c.fifty() * (found.turning * u - w.fifty() * w.fifty() * v);
    CHECK(rule_about(on_radius(0)).missing
          == within(-c.fifty() * u * dds, 1e-18 * c * (a + c + k) * size, "the step of the differences"));
  }
}

CHECK_THAT("the friction that makes the pressure infinite is refused, and a ball that leaves the plane; "
           "less is not")
{
  // At 90° kk + cc is λac, with c = k = a:2 for λ = 1; with k = a for 2.5.
  for(const char* const beyond :
      {"c=0.5 k=0.5 Phi=90 lambda=1", "c=0.5 k=0.5 Phi=-90 lambda=-1", "c=0.5 k=1 Phi=90 lambda=2.5",
       "Phi=180 c=0.5 g=1 w=2.0000000000000001", "Phi=120 c=0.25 g=1 w=-4.0000000000000001"})
    CHECK(refused_at(beyond));
  for(const char* const within_them :
      {"c=0.5 k=0.5 Phi=90 lambda=0.99999999999999999", "c=0.5 k=0.5 Phi=-90 lambda=-0.99999999999999999",
       "c=0.5 k=1 Phi=90 lambda=2.4999999999999999", "Phi=180 c=0.5 g=1 w=2",
       "Phi=120 c=0.25 g=1 w=-3.9999999999999999"})
    CHECK(!refused_at(within_them));
}

CHECK_THAT("along the diameter the rule agrees with the particles at G, and is off elsewhere by (A)")
{
  for(const Told& now : told_at("", "Phi=-30 w=0 lambda=0", "c=0.5 k=0.5 Phi=100"))
  {
    const Found found = by_particles();
    const Fifty F = -lambda.fifty() * found.pressure, v = sin(Phi.fifty()), u = cos(Phi.fifty());
    for(const auto& point : now.points("radius", 7))
    {
      const Fifty from_C = point.at("from_C") * a.fifty(), beyond = from_C - c.fifty();
      // Weight, pressure and friction, with their arms from the point of the diameter.
      const Fifty forces = beyond * v - from_C * v * found.pressure - (a.fifty() - from_C * u) * F;
      const Fifty rule = 2 * g.fifty() * forces / (k.fifty() * k.fifty() + beyond * beyond);
      CHECK(point.value("rule") == within(rule, 1e-13, "the place in doubles, and the differences"));
      CHECK(point.value("right") == within(found.turning, 1e-14, "the differences, and one rounding"));
      CHECK(point.value("from_C") == between(-1, 1, "in the ball"));
      CHECK(point.value("G") == within_relative(c.fifty() / a.fifty(), 4e-16, "two roundings"));
    }
    // The other point: so far beyond G its own acceleration about G points it at G.
    const Fifty X = 2 * g.fifty() * F, Y = 2 * g.fifty() * (found.pressure - 1);
    const Rule other = rule_about(on_radius(c.fifty() + (u * X - v * Y) / found.turning));
    CHECK(other.by_rule == within_relative(found.turning, 1e-21, "the square of the step"));
    const Rule at_G = rule_about(on_radius(c.fifty()));
    CHECK(at_G.by_rule == within(found.turning, 1e-22, "the square of the step, 1e-24"));
    CHECK(at_G.missing == within(0, 1e-40, "nothing"));
  }
}

/*!
That the split is a split of the energy and of the moment of momentum, too, is seen with many particles.
*/

CHECK_THAT(
    "forty moving particles have the momentum, the moment and the energy of G and of the motion about G")
{
  // Any cloud will do; these places and velocities are the fractional parts of multiples of roots.
  const auto part = [](int n, int root) {
    const Fifty x = n * sqrt(Fifty(root));
    return x - floor(x) - Fifty(1) / 2;
  };
  const Fifty far = 1e8;  // the cloud may be anywhere
  struct Particle
  {
    Fifty m;
    Vector place, velocity;
  };
  std::vector<Particle> cloud;
  Fifty mass = 0;
  Vector G{0, 0}, V{0, 0};
  for(int n = 1; n <= 40; ++n)
  {
    const Particle one{1 + part(n, 2), {far + part(n, 3), part(n, 5) - far}, {part(n, 7), part(n, 11)}};
    cloud.push_back(one);
    mass += one.m;
    G = {G.x + one.m * one.place.x, G.y + one.m * one.place.y};
    V = {V.x + one.m * one.velocity.x, V.y + one.m * one.velocity.y};
  }
  G = {G.x / mass, G.y / mass};
  V = {V.x / mass, V.y / mass};
  Fifty all = 0, about_G = 0, energy = 0, energy_about_G = 0;
  for(const Particle& one : cloud)
  {
    const Vector r{one.place.x - G.x, one.place.y - G.y}, v{one.velocity.x - V.x, one.velocity.y - V.y};
    all += one.m * moment(one.place, one.velocity);
    about_G += one.m * moment(r, v);
    energy += one.m * (pow(one.velocity.x, 2) + pow(one.velocity.y, 2));
    energy_about_G += one.m * (v.x * v.x + v.y * v.y);
  }
  CHECK(all == within(mass * moment(G, V) + about_G, 1e-36, "of the size of 1e9"));
  CHECK(energy == within(mass * (V.x * V.x + V.y * V.y) + energy_about_G, 1e-38, "a few units"));
  CHECK(energy_about_G == between(1, 100, "there is motion about G"));
}

/*!
## Go on from here

::: exercise
A homogeneous hoop rolls down an inclined plane. Is the rule right about the point of the hoop that touches
the plane, though it is neither $G$ nor without acceleration?
answer: Yes: the acceleration of that point is directed to the centre, which is $G$ ({{sec globe.03}}), the
third case. For a ball whose $G$ is elsewhere it is no longer so; our table shows by how much.
:::
*/

CHECK_THAT("of a rolling ball with G at the centre the point at S misses nothing, of ours it does")
{
  const auto missing = [](const Fifty& c_) {
    const Ball<Fifty> b{1, c_, Fifty(3) / 5};
    const Fifty at = exact::pi() / 3, w_ = 4;
    const auto all = rolling_accelerations(b, Fifty(125) / 8, at, w_);
    const Vector G_from_S{-c_ * sin(at), 1 - c_ * cos(at)};
    const Vector of_S{all.x - all.Phi * G_from_S.y + w_ * w_ * G_from_S.x,
                      all.y + all.Phi * G_from_S.x + w_ * w_ * G_from_S.y};
    CHECK(of_S.x == within(0, 1e-45, "straight up, as in §3"));
    CHECK(of_S.y == within(16, 1e-45, "aww"));
    return moment(G_from_S, of_S);
  };
  CHECK(missing(0) == within(0, 1e-45, "fifty digits"));
  CHECK(missing(Fifty(1) / 10) == within(Fifty(16) / 10 * sin(exact::pi() / 3), 1e-44, "acww sin Φ"));
}
