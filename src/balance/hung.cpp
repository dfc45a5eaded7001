#include "balance/hung.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gsl/gsl_eigen.h>

#include "balance/systems.hpp"

namespace balance
{
namespace
{

using exact::Fifty;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// φ, ω and both pans together.
using Three = std::array<Fifty, 3>;

/// The matrices of the linear motion with η = ϑ: stiffness (diagonal) and masses.
struct Matrices
{
  Three stiffness;
  std::array<std::array<Fifty, 3>, 3> mass;
};

Matrices matrices_of(const Suspended& s)
{
  const auto& [a, b, c, kk, L, M, g] = s.beam;
  const Fifty G = 2 * Fifty(g), h = s.movable ? s.h : 1, e = s.e;
  const Fifty weight = Fifty(M) * c + 2 * Fifty(L) * e, all = Fifty(M) + 2 * Fifty(L);
  const Fifty inertia = Fifty(M) * (Fifty(kk) + Fifty(c) * c) + 2 * Fifty(L) * (Fifty(a) * a + e * e);
  const Fifty pans = 2 * Fifty(L) * b;
  return {{G * all * h, G * weight, G * pans},
          {{{all * h * h, h * weight, pans * h},
            {h * weight, inertia, pans * e},
            {pans * h, pans * e, pans * b}}}};
}

void check(const Suspended& s)
{
  numbers_of(s.beam);
  const bool possible =
      s.beam.L > 0 && std::isfinite(s.e) && (!s.movable || (s.h > 0 && std::isfinite(s.h)));
  if(!possible)
    throw std::domain_error("no such balance: L and h must be positive, e finite");
}

/// The numbers that move: 0, 1, 2 or, with C fixed, 1, 2.
int first_of(const Suspended& s)
{
  return s.movable ? 0 : 1;
}

/// |stiffness − s·mass| as a polynomial of s, by its values' rule of Sarrus.
std::array<Fifty, 4> characteristic(const Matrices& m, int first)
{
  const auto& k = m.stiffness;
  const auto& M = m.mass;
  const auto minor = [&M](int i, int j) {
    const auto x = static_cast<std::size_t>(i), y = static_cast<std::size_t>(j);
    return M[x][x] * M[y][y] - M[x][y] * M[x][y];
  };
  if(first == 1)
    return {k[1] * k[2], -(k[1] * M[2][2] + M[1][1] * k[2]), minor(1, 2), 0};
  const Fifty whole = M[0][0] * minor(1, 2) - M[0][1] * (M[0][1] * M[2][2] - M[1][2] * M[0][2])
                      + M[0][2] * (M[0][1] * M[1][2] - M[1][1] * M[0][2]);
  return {k[0] * k[1] * k[2], -(k[0] * k[1] * M[2][2] + k[0] * M[1][1] * k[2] + M[0][0] * k[1] * k[2]),
          k[0] * minor(1, 2) + k[1] * minor(0, 2) + k[2] * minor(0, 1), -whole};
}

/// Newton's rule from a good beginning; a double root is reached by halves, which 200 steps allow.
Fifty polished(const std::array<Fifty, 4>& c, Fifty s)
{
  for(int i = 0; i < 200; ++i)
  {
    const Fifty value = c[0] + s * (c[1] + s * (c[2] + s * c[3]));
    const Fifty slope = c[1] + s * (2 * c[2] + s * (3 * c[3]));
    if(value == 0 || slope == 0)
      break;
    const Fifty step = value / slope;
    s -= step;
    if(abs(step) <= abs(s) * Fifty("1e-45"))
      break;
  }
  return s;
}

/// Symmetric matrices of n rows, one after the other.
struct Square
{
  explicit Square(std::size_t rows) : n(rows), entries(rows * rows) {}
  double& operator()(std::size_t i, std::size_t j) { return entries[i * n + j]; }
  gsl_matrix_view view() { return gsl_matrix_view_array(entries.data(), n, n); }

  std::size_t n;
  std::vector<double> entries;
};

/// Whether all pivots of a symmetric matrix are above 0.
bool positive_definite(Square a)
{
  for(std::size_t k = 0; k < a.n; ++k)
  {
    if(!(a(k, k) > 0 && std::isfinite(a(k, k))))
      return false;
    for(std::size_t i = k + 1; i < a.n; ++i)
      for(std::size_t j = k + 1; j < a.n; ++j)
        a(i, j) -= a(i, k) * a(k, j) / a(k, k);
  }
  return true;
}

/// The squares of the frequencies, and the shapes in the columns, the mass of each being 1.
struct Small_modes
{
  std::vector<double> squares;
  Square shapes;
};

/// The modes of these stiffnesses, one a coordinate, by GSL, which ends the program for masses that are none unless told not
/// to: so they are asked first. It gets them scaled so that all masses on the diagonal are 1.
Small_modes solved(const std::vector<double>& stiffness, Square mass)
{
  const std::size_t n = mass.n;
  std::vector<double> scale(n);
  for(std::size_t i = 0; i < n; ++i)
    scale[i] = std::sqrt(mass(i, i));
  Square pull(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    pull(i, i) = stiffness[i] / scale[i] / scale[i];
    for(std::size_t j = 0; j < n; ++j)
      mass(i, j) = mass(i, j) / scale[i] / scale[j];
  }
  if(!positive_definite(mass))
    throw std::domain_error("no such balance: its matrix of masses is not positive definite");
  Small_modes found{std::vector<double>(n), Square(n)};
  Square spent = mass;  // GSL writes over what it is given
  gsl_vector_view squares = gsl_vector_view_array(found.squares.data(), n);
  gsl_matrix_view pulls = pull.view(), masses = spent.view(), shapes = found.shapes.view();
  const std::unique_ptr<gsl_eigen_gensymmv_workspace, decltype(&gsl_eigen_gensymmv_free)> room(
      gsl_eigen_gensymmv_alloc(n), &gsl_eigen_gensymmv_free);
  if(gsl_eigen_gensymmv(&pulls.matrix, &masses.matrix, &squares.vector, &shapes.matrix, room.get()) != 0)
    throw std::domain_error("no such balance: its modes are not to be had");
  for(std::size_t k = 0; k < n; ++k)
  {
    double of_all = 0;
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t j = 0; j < n; ++j)
        of_all += found.shapes(i, k) * mass(i, j) * found.shapes(j, k);
    for(std::size_t i = 0; i < n; ++i)
      found.shapes(i, k) /= std::sqrt(of_all) * scale[i];
  }
  return found;
}

/// The squares of the frequencies with η = ϑ, in fifty digits, the least first.
std::vector<Fifty> squares(const Suspended& s)
{
  check(s);
  const Matrices m = matrices_of(s);
  const int first = first_of(s);
  const auto left_out = static_cast<std::size_t>(first), n = 3 - left_out;
  Square mass(n);
  std::vector<double> stiffness(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    stiffness[i] = static_cast<double>(m.stiffness[i + left_out]);
    for(std::size_t j = 0; j < n; ++j)
      mass(i, j) = static_cast<double>(m.mass[i + left_out][j + left_out]);
  }
  const auto polynomial = characteristic(m, first);
  std::vector<Fifty> found;
  for(const double square : solved(stiffness, mass).squares)
    found.push_back(polished(polynomial, square));
  std::sort(found.begin(), found.end());
  return found;
}

/// s − μ² for the mode with η = ϑ nearest to μ² where that is too small to be a difference: what is left of the pans'
/// equation when φ and ω are eliminated, solved by repetition.
Fifty beyond_pans(const Suspended& s, const Fifty& mu2)
{
  const Matrices m = matrices_of(s);
  Fifty beyond = 0;
  for(int i = 0; i < 8; ++i)
  {
    const Fifty square = mu2 + beyond;
    const Fifty x = square * m.mass[0][2], y = square * m.mass[1][2];
    const Fifty beam = m.stiffness[1] - square * m.mass[1][1];
    if(s.movable)
    {
      const Fifty shears = m.stiffness[0] - square * m.mass[0][0], both = -square * m.mass[0][1];
      beyond = -(x * x * beam - 2 * x * y * both + y * y * shears) / (shears * beam - both * both)
               / m.mass[2][2];
    }
    else
      beyond = -y * y / beam / m.mass[2][2];
  }
  return beyond;
}

/// What stiffness and masses leave of a mode: its shape is at right angles to two rows.
Three shape_of(const Suspended& s, const Matrices& m, const Fifty& square)
{
  const int first = first_of(s);
  std::array<std::array<Fifty, 3>, 3> row;
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 3; ++j)
      row[i][j] = (i == j ? m.stiffness[i] : Fifty(0)) - square * m.mass[i][j];
  if(first == 1)
  {
    const auto size = [](const Fifty& x, const Fifty& y) { return abs(x) + abs(y); };
    const bool upper =
        size(row[1][1], row[1][2]) / m.mass[1][1] >= size(row[2][1], row[2][2]) / m.mass[2][2];
    return upper ? Three{0, -row[1][2], row[1][1]} : Three{0, -row[2][2], row[2][1]};
  }
  Three best;
  Fifty largest = -1;
  for(std::size_t i = 0; i < 3; ++i)
  {
    const auto &x = row[(i + 1) % 3], &y = row[(i + 2) % 3];
    const Three across{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
    const Fifty size = (abs(across[0]) + abs(across[1]) + abs(across[2])) * m.mass[i][i];
    if(size > largest)
    {
      largest = size;
      best = across;
    }
  }
  return best;
}

/// The same, its greatest part being 1.
Three normal_shape(const Suspended& s, const Matrices& m, const Fifty& square)
{
  Three shape = shape_of(s, m, square);
  std::size_t greatest = 0;
  for(std::size_t i = 1; i < 3; ++i)
    if(abs(shape[i]) > abs(shape[greatest]))
      greatest = i;
  const Fifty size = shape[greatest];
  for(Fifty& x : shape)
    x /= size;
  return shape;
}

Mode mode_of(const Fifty& square, const Four& shape)
{
  return {static_cast<double>(square), square < 0 ? nan : static_cast<double>(Fifty(sqrt(square))), shape};
}

/// Where a mode is at the time t, and how fast.
struct Swung
{
  Fifty x;
  Fifty v;
};

/// From where it is at first, and how fast; it swings, or topples, or drifts.
Swung swung(const Fifty& square, const Fifty& at, const Fifty& rate, double t)
{
  if(square == 0)
    return {at + rate * t, rate};
  const Fifty k = sqrt(abs(square)), turn = k * t;
  if(square > 0)
    return {at * cos(turn) + rate / k * sin(turn), rate * cos(turn) - at * k * sin(turn)};
  return {at * cosh(turn) + rate / k * sinh(turn), rate * cosh(turn) + at * k * sinh(turn)};
}

systems::Hung system_of(const Suspended& s)
{
  check(s);
  modes(s);  // refuses what has no masses
  const Instrument& x = s.beam;
  return {
      2 * x.g, x.a, x.b, x.c, s.e, s.movable ? s.h : 1, x.kk + x.c * x.c, x.L / x.M, s.movable ? 1.0 : 0.0};
}

collocation::Moment<4> moment_of(const Suspended& s, const Full_state& now)
{
  if(!s.movable && (now.at.phi != 0 || now.rate.phi != 0))
    throw std::domain_error("where C is fixed φ must be 0 and at rest");
  return {{now.at.phi, now.at.omega, now.at.eta, now.at.theta},
          {now.rate.phi, now.rate.omega, now.rate.eta, now.rate.theta}};
}

double fastest(const Suspended& s, const Full_state& start)
{
  double most = 0;
  for(const Mode& m : modes(s))
    most = std::max(most, std::sqrt(std::abs(m.square)));
  const Four& v = start.rate;
  return std::max({most, std::abs(v.phi), std::abs(v.omega), std::abs(v.eta), std::abs(v.theta)});
}

}  // namespace

std::vector<Mode> modes(const Suspended& s)
{
  const Matrices m = matrices_of(s);
  std::vector<Mode> all;
  for(const Fifty& square : squares(s))
  {
    const Three shape = normal_shape(s, m, square);
    const double pans = static_cast<double>(shape[2]);
    all.push_back(
        mode_of(square, {static_cast<double>(shape[0]), static_cast<double>(shape[1]), pans, pans}));
  }
  all.push_back(mode_of(2 * Fifty(s.beam.g) / s.beam.b, {0, 0, 1, -1}));
  std::stable_sort(all.begin(), all.end(),
                   [](const Mode& x, const Mode& y) { return x.square < y.square; });
  return all;
}

Transfer transfer(const Suspended& s)
{
  const std::vector<Fifty> found = squares(s);
  const auto& [a, b, c, kk, L, M, g] = s.beam;
  const Fifty mu2 = 2 * Fifty(g) / b, mu = sqrt(mu2);
  const auto away = [&](const Fifty& square) -> Fifty { return (square - mu2) / (sqrt(square) + mu); };
  const Fifty* own = nullptr;  // whose frequency is nearest to μ
  for(const Fifty& square : found)
    if(square > 0 && (own == nullptr || abs(away(square)) < abs(away(*own))))
      own = &square;
  if(own == nullptr)
    throw std::domain_error("no such balance: it topples in every way");
  Fifty nearest = *own - mu2;
  if(abs(nearest) < mu2 * Fifty("1e-20"))
    nearest = beyond_pans(s, mu2);
  nearest /= sqrt(mu2 + nearest) + mu;
  Fifty estimate;
  const Fifty mu3 = mu2 * mu;
  if(s.movable)
    estimate =
        2 * exact::pi() * abs(mu2 - 2 * Fifty(g) / s.h) * (Fifty(M) + 2 * Fifty(L)) / (2 * Fifty(L) * mu3);
  else
  {
    const Fifty e = s.e;
    const Fifty inertia = Fifty(M) * (Fifty(kk) + Fifty(c) * c) + 2 * Fifty(L) * (Fifty(a) * a + e * e);
    const Fifty lambda2 = 2 * Fifty(g) * (Fifty(M) * c + 2 * Fifty(L) * e) / inertia;
    estimate = exact::pi() * abs(mu2 - lambda2) * inertia / (Fifty(L) * e * e * mu3);
  }
  return {static_cast<double>(nearest), static_cast<double>(exact::pi() / abs(nearest)),
          static_cast<double>(estimate)};
}

double handed_on(const Suspended& s, double longer)
{
  check(s);
  if(!(longer > -1 && std::isfinite(longer) && (s.movable || s.e != 0)))
    throw std::domain_error(
        "nothing to hand on: the strings must be positive, and something couple the pans");
  const auto& [a, b, c, kk, L, M, g] = s.beam;
  const double other = b * (1 + longer), h = s.h, weight = M * c + 2 * L * s.e;
  const double masses[4][4] = {
      {(M + 2 * L) * h * h, weight * h, L * b * h, L * other * h},
      {weight * h, M * (kk + c * c) + 2 * L * (a * a + s.e * s.e), L * b * s.e, L * other * s.e},
      {L * b * h, L * b * s.e, L * b * b, 0},
      {L * other * h, L * other * s.e, 0, L * other * other}};
  const double pulls[4] = {(M + 2 * L) * h, weight, L * b, L * other};
  const std::size_t left_out = s.movable ? 0 : 1, n = 4 - left_out;
  Square mass(n);
  std::vector<double> stiffness(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    stiffness[i] = 2 * g * pulls[i + left_out];
    for(std::size_t j = 0; j < n; ++j)
      mass(i, j) = masses[i + left_out][j + left_out];
  }
  Small_modes modes = solved(stiffness, mass);
  double sum = 0;
  for(std::size_t k = 0; k < n; ++k)
  {
    if(!(modes.squares[k] > 0))
      throw std::domain_error("no such balance: a mode topples");
    double of_P = 0;
    for(std::size_t i = 0; i < n; ++i)
      of_P += mass(n - 2, i) * modes.shapes(i, k);
    sum += std::abs(modes.shapes(n - 1, k) * of_P);
  }
  return sum;
}

Full_state linear_motion(const Suspended& s, const Full_state& start, double t)
{
  const Matrices m = matrices_of(s);
  const auto inner = [&m](const Three& x, const Three& y) {  // with the masses
    Fifty sum = 0;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        sum += x[i] * m.mass[i][j] * y[j];
    return sum;
  };
  const auto half = [](double x, double y) { return (Fifty(x) + y) / 2; };
  const Three at{start.at.phi, start.at.omega, half(start.at.eta, start.at.theta)};
  const Three rate{start.rate.phi, start.rate.omega, half(start.rate.eta, start.rate.theta)};
  Three x{0, 0, 0}, v{0, 0, 0};
  for(const Fifty& square : squares(s))
  {
    const Three shape = normal_shape(s, m, square);
    const Fifty mass = inner(shape, shape);
    const Swung by = swung(square, inner(shape, at) / mass, inner(shape, rate) / mass, t);
    for(std::size_t i = 0; i < 3; ++i)
    {
      x[i] += shape[i] * by.x;
      v[i] += shape[i] * by.v;
    }
  }
  const Swung apart = swung(2 * Fifty(s.beam.g) / s.beam.b, half(start.at.eta, -start.at.theta),
                            half(start.rate.eta, -start.rate.theta), t);
  const auto four = [](const Three& all, const Fifty& pans) {
    return Four{static_cast<double>(all[0]), static_cast<double>(all[1]),
                static_cast<double>(all[2] + pans), static_cast<double>(all[2] - pans)};
  };
  return {four(x, apart.x), four(v, apart.v)};
}

Energies energies(const Suspended& s, const Full_state& now)
{
  const Instrument& x = s.beam;
  const auto& [at, v] = now;
  const double G = 2 * x.g, h = s.movable ? s.h : 1;
  const auto height = [](double angle) {  // 1 − cos
    const double half = elementary::sin(angle / 2);
    return 2 * half * half;
  };
  using elementary::cos;
  using elementary::sin;
  const double weight = x.M * x.c + 2 * x.L * s.e;
  const double inertia = x.M * (x.kk + x.c * x.c) + 2 * x.L * (x.a * x.a + s.e * s.e);
  const auto pan = [&](double angle, double rate) {
    return x.L * x.b * (x.b * rate * rate / (2 * G) + height(angle));
  };
  const double across_A = s.e * cos(at.omega - at.eta) - x.a * sin(at.omega - at.eta);
  const double across_B = s.e * cos(at.omega - at.theta) + x.a * sin(at.omega - at.theta);
  const double coupled =
      weight * h * cos(at.phi - at.omega) * v.phi * v.omega
      + x.L * x.b * h * v.phi * (cos(at.phi - at.eta) * v.eta + cos(at.phi - at.theta) * v.theta)
      + x.L * x.b * v.omega * (across_A * v.eta + across_B * v.theta);
  const double own = ((x.M + 2 * x.L) * h * h * v.phi * v.phi + inertia * v.omega * v.omega) / 2;
  const double raised = (x.M + 2 * x.L) * h * height(at.phi) + weight * height(at.omega);
  return {pan(at.eta, v.eta), pan(at.theta, v.theta), (own + coupled) / G + raised};
}

struct Full_motion::Inner
{
  Suspended s;
  Full_state now;
  double start_energy;
  collocation::Motion<systems::Hung> motion;

  double energy() const
  {
    const auto [P, Q, rest] = energies(s, now);
    return P + Q + rest;
  }

  Inner(const Suspended& of, const Full_state& start, double tolerance)
      : s(of), now(start), start_energy(energy()),
        motion(system_of(of), moment_of(of, start), {tolerance, 0.125 / fastest(of, start)},
               systems::best().hung)
  {
  }
};

Full_motion::Full_motion(const Suspended& s, const Full_state& start, double tolerance)
    : inner_(std::make_unique<Inner>(s, start, tolerance))
{
}
Full_motion::~Full_motion() = default;
Full_motion::Full_motion(Full_motion&&) noexcept = default;
Full_motion& Full_motion::operator=(Full_motion&&) noexcept = default;

const Full_state& Full_motion::to(double t)
{
  const auto [x, v] = inner_->motion.to(t);
  return inner_->now = {{x[0], x[1], x[2], x[3]}, {v[0], v[1], v[2], v[3]}};
}

double parting(const Suspended& s, const Full_state& start, double t)
{
  const double slight = 1e-9;
  Full_state beside = start;
  for(double* angle : {&beside.at.omega, &beside.at.eta, &beside.at.theta})
    *angle += slight;
  if(s.movable)
    beside.at.phi += slight;
  Full_motion one(s, start), other(s, beside);
  double most = 1;
  for(int k = 1; k <= 100; ++k)
  {
    const Four x = one.to(t * k / 100).at, y = other.to(t * k / 100).at;
    most = std::max({most, std::abs(x.phi - y.phi) / slight, std::abs(x.omega - y.omega) / slight,
                     std::abs(x.eta - y.eta) / slight, std::abs(x.theta - y.theta) / slight});
  }
  return most;
}

double Full_motion::energy_drift() const
{
  const double change = std::abs(inner_->energy() - inner_->start_energy);
  return inner_->start_energy == 0 ? change : change / std::abs(inner_->start_energy);
}

}  // namespace balance
