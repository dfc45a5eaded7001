#include "globe/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "globe/gauss.hpp"
#include "globe/rolling.hpp"
#include "globe/roots.hpp"

namespace globe
{
namespace
{

using exact::Fifty;

template <class Real>
constexpr std::size_t terms = std::tuple_size_v<Series<Real>>;

// A step as a part of the radius of convergence: the last term is below the last bit.
template <class Real>
const double part_of_radius = std::is_same_v<Real, double> ? 0.2 : 0.15;

// The coefficient n of a product; in double by four sums, of which none waits for another.
template <class Real>
Real product(const Series<Real>& p, const Series<Real>& q, std::size_t n)
{
  if constexpr(std::is_same_v<Real, double>)
  {
    double sum[4] = {0, 0, 0, 0};
    std::size_t i = 0;
    for(; i + 4 <= n + 1; i += 4)
      for(std::size_t lane = 0; lane < 4; ++lane)
        sum[lane] += p[i + lane] * q[n - i - lane];
    for(std::size_t lane = 0; i <= n; ++i, ++lane)
      sum[lane] += p[i] * q[n - i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }
  else
  {
    Real sum = 0;
    for(std::size_t i = 0; i <= n; ++i)
      sum += p[i] * q[n - i];
    return sum;
  }
}

template <class Real>
Real number(std::size_t n)
{
  return Real(static_cast<double>(n));
}

// The series of a stretch, and of what may end it: it ends where one of these becomes negative.
template <class Real>
struct Expansion
{
  Series<Real> Phi, w, s, slip;
  Series<Real> ends[2];

  Expansion(const Ball<Real>& ball, const Real& g, const Real& mu, const State<Real>& start, Mode mode)
  {
    using std::cos, std::sin;
    const auto& [a, c, k, gap] = ball;
    const bool rolls = mode == Mode::rolling;
    const Real lambda = mode == Mode::scraping_forwards ? mu : Real(-mu);
    const Real half = sin(start.Phi / 2), versed = 2 * half * half;  // 1 − cos Φ
    // (bb + 2ac (1 − cos Φ)) Φ'' = −(2gc + ac ww) sin Φ where it rolls, else
    // (kk − cq sin Φ) Φ'' = q (2g + c ww cos Φ), q = λ(a − c cos Φ) − c sin Φ: moment, arm, and force, which for one that
    // scrapes is what presses
    Series<Real> cosine, sine, ww, arm, moment, ratio;
    Series<Real>& force = ends[1];
    Phi[0] = start.Phi;
    w[0] = start.w;
    cosine[0] = cos(start.Phi);
    sine[0] = sin(start.Phi);
    for(std::size_t n = 0; n < terms<Real>; ++n)
    {
      ww[n] = product(w, w, n);
      if(rolls)
      {
        force[n] = -a * c * ww[n] - (n == 0 ? Real(2 * g * c) : Real(0));
        moment[n] = n == 0 ? Real(bb(ball) + 2 * a * c * versed) : Real(-2 * a * c * cosine[n]);
        arm[n] = sine[n];
      }
      else
      {
        force[n] = c * product(ww, cosine, n) + (n == 0 ? Real(2 * g) : Real(0));
        arm[n] = lambda * (n == 0 ? Real(gap + c * versed) : Real(-c * cosine[n])) - c * sine[n];
        moment[n] = (n == 0 ? Real(k * k) : Real(0)) - c * product(arm, sine, n);
      }
      ratio[n] = 0;
      ratio[n] = (force[n] - product(moment, ratio, n)) / moment[0];
      if(n + 1 == terms<Real>)
        break;
      const Real next = number<Real>(n + 1);
      w[n + 1] = product(arm, ratio, n) / next;
      Phi[n + 1] = w[n] / next;
      sine[n + 1] = product(cosine, w, n) / next;
      cosine[n + 1] = -product(sine, w, n) / next;
    }
    s[0] = start.s;
    slip.fill(Real(0));
    slip[0] = start.slip;
    for(std::size_t n = 1; n < terms<Real>; ++n)
    {
      // s'' − aΦ'' from F14: x' + λ(y' + 2gt) stays the same, x' = s' − c (sin Φ)', y' = −c (cos Φ)'
      if(!rolls && n + 1 < terms<Real>)
        slip[n] = number<Real>(n + 1) * c * (lambda * cosine[n + 1] + sine[n + 1]) - a * w[n]
                  - (n == 1 ? Real(2 * g * lambda) : Real(0));
      s[n] = (slip[n - 1] + a * w[n - 1]) / number<Real>(n);
    }
    if(!rolls)
    {
      for(std::size_t n = 0; n < terms<Real>; ++n)
        ends[0][n] = mode == Mode::scraping_forwards ? slip[n] : Real(-slip[n]);
      return;
    }
    ends[0].fill(Real(0));
    ends[1].fill(Real(0));
    for(std::size_t n = 0; n + 2 < terms<Real>; ++n)
    {
      const Real twice = number<Real>((n + 1) * (n + 2));
      const Real pressure = -c * twice * cosine[n + 2] / (2 * g) + (n == 0 ? 1 : 0);
      const Real backwards = (c * twice * sine[n + 2] - a * number<Real>(n + 1) * w[n + 1]) / (2 * g);
      ends[0][n] = mu * pressure - backwards;
      ends[1][n] = mu * pressure + backwards;
    }
  }
};

// How far the series may be used, to a few parts in a hundred: by the powers of two of the last two terms of Φ and w.
template <class Real>
double radius(const Expansion<Real>& e)
{
  double most = -std::numeric_limits<double>::infinity();
  for(const Series<Real>* p : {&e.Phi, &e.w})
  {
    double size = 1;
    for(std::size_t n = 0; n < 4; ++n)
      size = std::max(size, std::abs(static_cast<double>((*p)[n])));
    for(const std::size_t n : {terms<Real> - 2, terms<Real> - 1})
      if(const double term = std::abs(static_cast<double>((*p)[n])) / size; term > 0)
        most = std::max(most, (std::ilogb(term) + 0.5) / static_cast<double>(n));
  }
  return std::exp2(-most);
}

// Whether the series is positive all the way to `length` by what its negative terms can take from the first at most.
template <class Real>
bool stays_positive(const Series<Real>& p, const Real& length)
{
  Real least = p[0], power = 1;
  for(const Real& term : p)
  {
    if(term < 0)
      least += term * power;
    power *= length;
  }
  return least > 1e-9 * p[0];  // far beyond what is rounded
}

// Where a series falls from p(a) ≥ 0 to p(b) < 0: the first number found to be beyond it. Newton's method, and halving
// where that would leave what encloses the root or is slow.
template <class Real>
Real falls_below(const Series<Real>& p, Real a, Real b)
{
  Real at = (a + b) / 2, width = b - a;
  for(int n = 0; n < most_halvings && a < at && at < b; ++n)
  {
    Real value = 0, slope = 0;
    for(std::size_t i = terms<Real>; i-- > 0;)
    {
      slope = slope * at + value;
      value = value * at + p[i];
    }
    (value < 0 ? b : a) = at;
    // a little beyond the root, so that both ends close in on it
    const Real next = at - value / slope;
    const Real step = next - at, past = next + step * Real(0.0009765625);
    const bool is_inside = slope < 0 && a < past && past < b;
    at = is_inside && b - a < width ? past : Real((a + b) / 2);
    width = is_inside ? Real((b - a) * 0.75) : Real(b - a);
  }
  return b;
}

// The first time in (0, length] at which the series becomes negative, or −1. A stretch that begins where what
// may end it is zero begins with positive values; those zeros are divided out.
template <class Real>
Real first_negative(Series<Real> p, const Real& length, bool begins_at_zero)
{
  if(begins_at_zero)
  {
    // What is left of a zero by rounding is no number to divide by.
    std::size_t zeros = 1;
    double size = 0;
    Real power = 1;
    for(const Real& term : p)
    {
      size = std::max(size, std::abs(static_cast<double>(term * power)));
      power *= length;
    }
    power = length;
    const double nothing = (std::is_same_v<Real, double> ? 1e-12 : 1e-40) * size;
    while(zeros + 1 < p.size() && std::abs(static_cast<double>(p[zeros] * power)) < nothing)
    {
      ++zeros;
      power *= length;
    }
    std::fill(std::shift_left(p.begin(), p.end(), static_cast<std::ptrdiff_t>(zeros)), p.end(), Real(0));
  }
  if(stays_positive(p, length))
    return -1;
  constexpr std::size_t parts = 8;
  Series<Real> fall{};  // less its slope
  for(std::size_t n = 1; n < terms<Real>; ++n)
    fall[n - 1] = -number<Real>(n) * p[n];
  // Both at all ends of the parts together, each as value_of() has it.
  std::array<Real, parts + 1> at, of_p{}, of_fall{};
  for(std::size_t n = 0; n <= parts; ++n)
    at[n] = length * static_cast<double>(n) / static_cast<double>(parts);
  for(std::size_t term = terms<Real>; term-- > 0;)
    for(std::size_t n = 0; n <= parts; ++n)
    {
      of_p[n] = of_p[n] * at[n] + p[term];
      of_fall[n] = of_fall[n] * at[n] + fall[term];
    }
  for(std::size_t n = 0; n < parts; ++n)
  {
    const Real a = at[n], b = at[n + 1];
    if(of_p[n + 1] < 0)
      return falls_below(p, a, b);
    // It may dip below zero and come back.
    if(of_fall[n] > 0 && of_fall[n + 1] < 0)
      if(const Real low = falls_below(fall, a, b); value_of(p, low) < 0)
        return falls_below(p, a, low);
  }
  return -1;
}

}  // namespace

template <class Real>
Real Path<Real>::energy(const State<Real>& state) const
{
  using std::sin;
  const auto& [a, c, k, gap] = ball_;
  const Real half = sin(state.Phi / 2), height = gap + 2 * c * half * half;
  const Real x = state.slip + height * state.w, y = c * state.w * sin(state.Phi);
  return (x * x + y * y + k * k * state.w * state.w) / 2 + 2 * g_ * height;
}

template <class Real>
void Path<Real>::enter(Mode mode, const State<Real>& state)
{
  events_.push_back({now_, mode, state, energy(state)});
}

// What the ball does next in a state.
template <class Real>
Mode Path<Real>::choose(const State<Real>& state) const
{
  using std::abs, std::cos, std::sin;
  const auto& [a, c, k, gap] = ball_;
  const Real cosine = cos(state.Phi), sine = sin(state.Phi), half = sin(state.Phi / 2),
             ww = state.w * state.w;
  if(2 * g_ + c * ww * cosine < 0)
    return Mode::off;
  if(state.slip != 0)
    return state.slip > 0 ? Mode::scraping_forwards : Mode::scraping_backwards;
  const Real turning = -sine * (2 * g_ * c + a * c * ww) / (bb(ball_) + 4 * a * c * half * half);
  const Real backwards = -((gap + 2 * c * half * half) * turning + c * ww * sine) / (2 * g_);
  const Real pressure = 1 + (c * turning * sine + c * ww * cosine) / (2 * g_);
  if(abs(backwards) <= mu_ * pressure)
    return Mode::rolling;
  return backwards > 0 ? Mode::scraping_forwards : Mode::scraping_backwards;
}

template <class Real>
State<Real> Path<Real>::advance(const State<Real>& state, Mode mode, const Real& end, Mode& next)
{
  const Expansion<Real> e(ball_, g_, mu_, state, mode);
  Real length = std::min(Real(end - now_), Real(part_of_radius<Real> * radius(e)));
  const bool rolls = mode == Mode::rolling;
  int which = -1;
  for(int i = 0; i < 2; ++i)
  {
    const bool at_zero = !rolls && i == 0 && state.slip == 0;
    const Real until = first_negative(e.ends[i], length, at_zero);
    if(until >= 0)
    {
      length = until;
      which = i;
    }
  }
  steps_.push_back({now_, mode, e.Phi, e.w, e.s, e.slip});
  State<Real> then{value_of(e.s, length), value_of(e.slip, length), value_of(e.Phi, length),
                   value_of(e.w, length)};
  now_ += length;
  next = mode;
  if(rolls)
  {
    then.slip = 0;
    if(which >= 0)
      next = which == 0 ? Mode::scraping_forwards : Mode::scraping_backwards;
  }
  else if(which == 0)
  {
    then.slip = 0;
    next = choose(then);
  }
  else if(which == 1)
    next = Mode::off;
  return then;
}

template <class Real>
Path<Real>::Path(const Ball<Real>& ball, const Real& g, const Real& mu, const State<Real>& start,
                 const Real& end, std::size_t most_events)
    : ball_(ball), g_(g), mu_(mu)
{
  using std::isfinite;
  if(!(g > 0) || !isfinite(g) || !(end >= 0) || !isfinite(end))
    throw std::domain_error("a way needs g > 0 and an end at 0 or later");
  rolling::require(ball);
  const bool surely = mu * (ball.a + ball.c) < 2 * ball.k;  // kk + cc sin²Φ is at least 2kc sin Φ
  if(!(mu >= 0 && (surely || mu < rolling::painleve(ball).mu)))
    throw std::domain_error("with so much friction the scraping is not determined at every angle");
  if(!isfinite(start.s) || !isfinite(start.slip) || !isfinite(start.Phi) || !isfinite(start.w))
    throw std::domain_error("a way needs a finite state to start from");
  State<Real> state = start;
  enter(choose(state), state);
  while(now_ < end && events_.back().mode != Mode::off && events_.size() <= most_events)
  {
    Mode next = events_.back().mode;
    state = advance(state, events_.back().mode, end, next);
    if(next != events_.back().mode)
      enter(next, state);
  }
}

template <class Real>
State<Real> Path<Real>::at(const Real& t) const
{
  if(!(t >= 0 && t <= now_))
    throw std::domain_error("the way is told from its start to its end");
  if(steps_.empty())
    return events_.front().state;
  auto after = std::upper_bound(steps_.begin(), steps_.end(), t,
                                [](const Real& time, const Step& step) { return time < step.start; });
  const Step& step = *std::prev(after);
  const Real past = t - step.start;
  return {value_of(step.s, past), value_of(step.slip, past), value_of(step.Phi, past),
          value_of(step.w, past)};
}

// The work of friction in so much time since a step's start.
template <class Real>
Real Path<Real>::taken(const Step& step, const Real& time) const
{
  using std::abs;
  if(step.mode == Mode::rolling)
    return 0;
  static const Gauss rule(16);
  const Real lambda = step.mode == Mode::scraping_forwards ? mu_ : Real(-mu_);
  Real sum = 0;
  for(const Gauss::Node& node : rule.nodes())
  {
    const Real past = time * (1 + Real(node.x)) / 2;
    const Real Phi = value_of(step.Phi, past), w = value_of(step.w, past);
    const Real pressure = accelerations<Real>(ball_, g_, Phi, w, lambda).pressure;
    sum += node.weight * pressure * abs(value_of(step.slip, past));
  }
  return mu_ * g_ * time * sum;  // 2g Π/P, and half the interval
}

template <class Real>
Real Path<Real>::lost(const Real& t) const
{
  if(!(t >= 0 && t <= now_))
    throw std::domain_error("the way is told from its start to its end");
  Real sum = 0;
  for(std::size_t i = 0; i < steps_.size() && steps_[i].start < t; ++i)
    sum +=
        taken(steps_[i], std::min(t, i + 1 < steps_.size() ? steps_[i + 1].start : now_) - steps_[i].start);
  return sum;
}

template <class Real>
Mode Path<Real>::mode(const Real& t) const
{
  Mode mode = events_.front().mode;
  for(const Event<Real>& event : events_)
    if(event.t <= t)
      mode = event.mode;
  return mode;
}

template class Path<double>;
template class Path<Fifty>;

}  // namespace globe
