#include "balance/mathieu.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#define EIGEN_DONT_VECTORIZE  // sums in one order, and to the same bits, on every processor and in the page
#include <Eigen/Eigenvalues>

#include "balance/systems.hpp"

namespace balance
{
namespace
{

/// The two solutions y(0) = 1, y′(0) = 0 and y(0) = 0, y′(0) = 1 at one time.
struct Pair_of_solutions
{
  double x1, v1, x2, v2;
};

void check(const Prescribed_beam& of)
{
  if(!(of.mu > 0 && of.lambda > 0 && std::isfinite(of.mu) && std::isfinite(of.lambda)
       && std::isfinite(of.p)))
    throw std::domain_error("no such pan: μ and λ must be positive, all finite");
}

void check(double a, double q)
{
  if(!(a >= 0 && a <= 400 && std::abs(q) <= 8))
    throw std::domain_error("no such point of the chart: allowed are a from 0 to 400 and |q| up to 8");
}

/// In the time τ = λt, so that nothing depends on the unit.
Pair_of_solutions solutions_at(const Prescribed_beam& of, double tau)
{
  const double ratio = of.mu / of.lambda;
  const systems::Prescribed system{ratio * ratio, 1, of.p};
  const double first = 0.25 / std::max({1.0, ratio, std::sqrt(std::abs(of.p))});
  collocation::Motion<systems::Prescribed> motion(system, {{1, 0}, {0, 1}}, {1e-18, first},
                                                  systems::best().prescribed);
  const auto at = motion.to(tau);
  return {at.x[0], at.v[0], at.x[1], at.v[1]};
}

/// μ² − x² for the frequency x of a solution whose lines lie at x + kλ, by the recurrence between them, near x = μ.
double shift_by_lines(const Prescribed_beam& of, double shift)
{
  const double s = of.p / 2 * of.lambda * of.lambda;
  const auto line = [&](int k) {  // μ² − (μ + shift + kλ)²
    const double away = shift + k * of.lambda;
    return -away * (2 * of.mu + away);
  };
  const auto beyond = [&](int side) {
    double sum = 0;
    for(int k = 40; k >= 1; --k)
      sum = s * s / (line(side * k) - sum);
    return sum;
  };
  return -(beyond(1) + beyond(-1)) / (2 * of.mu + shift);
}

/// The number of the stable interval in which a lies, from below: between aₖ(q) and bₖ₊₁(q) it is k.
int interval_of(double a, double q)
{
  int k = 0;
  while(k < 200 && std::max(cosine_characteristic(k + 1, q).value, sine_characteristic(k + 1, q).value) < a)
    ++k;
  return k;
}

Characteristic from_matrix(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside, int which,
                           int first, bool doubled)
{
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside);
  if(solver.info() != Eigen::Success)
    throw std::runtime_error("the characteristic values cannot be found");
  const double value = solver.eigenvalues()[which];
  Eigen::VectorXd v = solver.eigenvectors().col(which);
  Eigen::VectorXd left = diagonal.cwiseProduct(v) - value * v;
  const Eigen::Index n = v.size();
  left.head(n - 1) += beside.cwiseProduct(v.tail(n - 1));
  left.tail(n - 1) += beside.cwiseProduct(v.head(n - 1));
  std::vector<double> c(v.data(), v.data() + n);
  if(doubled)
    c[0] /= std::numbers::sqrt2;
  return {value, std::move(c), first, left.norm()};
}

Characteristic characteristic(int n, double q, bool cosine)
{
  if(!(n >= (cosine ? 0 : 1) && n <= 200 && std::abs(q) <= 1e6))
    throw std::domain_error("no such characteristic value: orders are at most 200, |q| at most 10⁶");
  // the lines that count: well beyond the order and where k² outgrows q
  const int size = 25 + n / 2 + static_cast<int>(1.2 * std::sqrt(std::abs(q)) + 3 * std::cbrt(std::abs(q)));
  const int first = n % 2 == 1 ? 1 : cosine ? 0 : 2;
  Eigen::VectorXd diagonal(size), beside(size - 1);
  for(int k = 0; k < size; ++k)
    diagonal[k] = (first + 2.0 * k) * (first + 2.0 * k);
  beside.setConstant(q);
  if(first == 1)
    diagonal[0] += cosine ? q : -q;
  if(first == 0)
    beside[0] *= std::numbers::sqrt2;
  const int which = cosine ? n / 2 : (n - 1) / 2;
  Characteristic found = from_matrix(diagonal, beside, which, first, first == 0);
  // its sign is asked where it is large: at z = 0 for q < 0, at a quarter turn for q > 0, of the function or its slope
  const auto weight = [&](int line) {
    const double multiple = first + 2.0 * line;
    if(q <= 0)
      return cosine ? 1 : multiple;
    return (line % 2 == 0 ? 1 : -1) * (first == 1 ? cosine ? -multiple : 1 : first == 2 ? -multiple : 1);
  };
  double there = 0;
  for(int line = 0; line < size; ++line)
    there += found.coefficients[static_cast<std::size_t>(line)] * weight(line);
  if(there * weight((n - first) / 2) < 0)
    for(double& c : found.coefficients)
      c = -c;
  return found;
}

}  // namespace

Floquet floquet(const Prescribed_beam& of)
{
  check(of);
  const auto [x1, v1, x2, v2] = solutions_at(of, std::numbers::pi);
  const Halves h{-v1 * x2, x1 * v2};
  Floquet f{2 * of.p, 4 * (of.mu / of.lambda) * (of.mu / of.lambda), h.half_trace(), of.mu, 0, 0};
  const int k = interval_of(f.a, f.q);
  if(h.growing())
  {
    const double sinh2 = -std::min(h.sine2, h.cosine2);
    const int order = h.cosine2 < 0 ? 2 * ((k + 1) / 2) + (k % 2 == 0 ? 1 : 0) : 2 * ((k + 1) / 2);
    f.growth = std::asinh(std::sqrt(sinh2)) / std::numbers::pi * of.lambda;
    f.frequency = order * of.lambda / 2;
    f.shift = f.frequency - of.mu;
    return f;
  }
  const double half =
      elementary::atan2(std::sqrt(h.sine2), std::sqrt(h.cosine2)) / std::numbers::pi;  // in λ
  f.frequency = (k % 2 == 0 ? k / 2.0 + half : (k + 1) / 2.0 - half) * of.lambda;
  f.shift = f.frequency - of.mu;
  double shift = 0;
  for(int i = 0; i < 60; ++i)
    shift = shift_by_lines(of, shift);
  // where the recurrence settles, it settles on the same frequency, and to full relative precision
  if(std::abs(shift_by_lines(of, shift) - shift) <= 1e-13 * std::abs(shift)
     && std::abs(shift - f.shift) <= 1e-7 * of.lambda)
  {
    f.shift = shift;
    f.frequency = of.mu + shift;
  }
  return f;
}

Halves halves(double a, double q)
{
  check(a, q);
  Halves at{};
  systems::best().halves_of_one(a, q, at);
  return at;
}

void halves(std::span<const double> a, std::span<const double> q, std::span<Halves> at)
{
  if(a.size() != q.size() || a.size() != at.size())
    throw std::invalid_argument("a chart wants as many numbers a as q, and room for as many points");
  for(std::size_t i = 0; i < a.size(); ++i)
    check(a[i], q[i]);
  systems::best().halves_of_many(a.data(), q.data(), at.data(), a.size());
}

Pan pan_under(const Prescribed_beam& of, const Pan& start, double t)
{
  check(of);
  const double period = 2 * std::numbers::pi / of.lambda;
  if(!(t >= 0 && t < 1e6 * period && std::isfinite(start.y) && std::isfinite(start.rate)))
    throw std::domain_error("no such time: allowed are 0 to 10⁶ periods of the beam");
  const auto product = elementary::product_of(of.lambda, t);
  const double turns = std::floor(product.value / (2 * std::numbers::pi));
  constexpr double turn = 2 * std::numbers::pi, turn_lost = 0x1.1a62633145c07p-52;
  const auto whole = elementary::product_of(turns, turn);
  const double left =
      std::max(0.0, (product.value - whole.value) + (product.lost - whole.lost - turns * turn_lost));
  const auto [x1, v1, x2, v2] = solutions_at(of, std::numbers::pi);
  using Change = Eigen::Matrix2d;
  Change power = Change::Identity(), base;
  base << 1 + 2 * v1 * x2, 2 * x2 * v2, 2 * x1 * v1, 1 + 2 * v1 * x2;
  for(long n = static_cast<long>(turns); n > 0; n /= 2)
  {
    if(n % 2 == 1)
      power = base * power;
    base = base * base;
  }
  const auto rest = solutions_at(of, left);
  Change last;
  last << rest.x1, rest.x2, rest.v1, rest.v2;
  const Eigen::Vector2d end = last * (power * Eigen::Vector2d(start.y, start.rate / of.lambda));
  return {end[0], end[1] * of.lambda};
}

Characteristic cosine_characteristic(int n, double q)
{
  return characteristic(n, q, true);
}

Characteristic sine_characteristic(int n, double q)
{
  return characteristic(n, q, false);
}

Interval unstable(double mu, double p, int order)
{
  if(!(mu > 0 && std::isfinite(mu) && order >= 1 && std::abs(p) < 0.5))
    throw std::domain_error("no such interval: allowed are orders from 1, μ > 0 and |am/b| below ½");
  const double a = cosine_characteristic(order, 2 * p).value, b = sine_characteristic(order, 2 * p).value;
  return {2 * mu / std::sqrt(std::max(a, b)), 2 * mu / std::sqrt(std::min(a, b))};
}

}  // namespace balance
