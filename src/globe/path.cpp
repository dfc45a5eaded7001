#include "globe/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "globe/rolling.hpp"
#include "globe/roots.hpp"

namespace globe
{
namespace
{

using exact::Fifty;

template <class Real>
using Series = std::vector<Real>;

// How many terms, and a step as a part of the radius of convergence: the last term is below the last bit.
template <class Real>
constexpr int terms = std::is_same_v<Real, double> ? 24 : 64;
template <class Real>
const double part_of_radius = std::is_same_v<Real, double> ? 0.2 : 0.15;

// The coefficient n of a product.
template <class Real>
Real product(const Series<Real>& p, const Series<Real>& q, int n)
{
  Real sum = 0;
  for(std::size_t i = 0, last = static_cast<std::size_t>(n); i <= last; ++i)
    sum += p[i] * q[last - i];
  return sum;
}

// The series of a stretch: Φ, w, cos Φ, sin Φ, the pressure, and what may end it.
template <class Real>
struct Expansion
{
  Series<Real> Phi, w, cosine, sine, slip, s;
  Series<Real> ends[2];  // the stretch ends where one of them becomes negative

  Expansion(const Ball<Real>& ball, const Real& g, const Real& mu, const State<Real>& start, Mode mode)
  {
    using std::cos, std::sin;
    const auto& [a, c, k] = ball;
    const int n_terms = terms<Real>;
    const auto size = static_cast<std::size_t>(n_terms) + 1;
    for(Series<Real>* p : {&Phi, &w, &cosine, &sine, &slip, &s})
      p->assign(size + 1, Real(0));
    Series<Real> ww(size), arm(size), moment(size), force(size), ratio(size);
    Phi[0] = start.Phi;
    w[0] = start.w;
    cosine[0] = cos(start.Phi);
    sine[0] = sin(start.Phi);
    s[0] = start.s;
    slip[0] = start.slip;
    const bool rolls = mode == Mode::rolling;
    const Real lambda = mode == Mode::scraping_forwards ? mu : Real(-mu);
    for(int m = 0; m < n_terms; ++m)
    {
      const auto n = static_cast<std::size_t>(m);
      const Real next = Real(static_cast<double>(m + 1));
      ww[n] = product(w, w, m);
      if(rolls)  // (A − 2ac cos Φ) Φ'' = −(2gc + ac ww) sin Φ
      {
        force[n] = -a * c * ww[n];
        moment[n] = -2 * a * c * cosine[n];
        if(m == 0)
        {
          force[0] -= 2 * g * c;
          moment[0] += bb(ball) + 2 * a * c;
        }
        arm[n] = sine[n];
      }
      else  // (kk − cq sin Φ) Φ'' = q (2g + c ww cos Φ), q = λ(a − c cos Φ) − c sin Φ
      {
        force[n] = c * product(ww, cosine, m);
        arm[n] = -lambda * c * cosine[n] - c * sine[n];
        if(m == 0)
        {
          force[0] += 2 * g;
          arm[0] += lambda * a;
        }
        moment[n] = -c * product(arm, sine, m);
        if(m == 0)
          moment[0] += k * k;
      }
      Real left = force[n];
      for(std::size_t i = 1; i <= n; ++i)
        left -= moment[i] * ratio[n - i];
      ratio[n] = left / moment[0];
      w[n + 1] = product(arm, ratio, m) / next;
      Phi[n + 1] = w[n] / next;
      sine[n + 1] = product(cosine, w, m) / next;
      cosine[n + 1] = -product(sine, w, m) / next;
    }
    for(std::size_t n = 1; n + 1 <= static_cast<std::size_t>(n_terms); ++n)
    {
      // s'' − aΦ'' from F14: x' + λ(y' + 2gt) stays the same, x' = s' − c (sin Φ)', y' = −c (cos Φ)'
      const Real next = Real(static_cast<double>(n + 1));
      if(!rolls)
        slip[n] = next * c * (lambda * cosine[n + 1] + sine[n + 1]) - a * w[n]
                  - (n == 1 ? Real(2 * g * lambda) : Real(0));
      s[n] = (slip[n - 1] + a * w[n - 1]) / Real(static_cast<double>(n));
    }
    for(Series<Real>& end : ends)
      end.assign(size - 2, Real(0));
    for(std::size_t n = 0; n < size - 2; ++n)
    {
      const Real twice = Real(static_cast<double>((n + 1) * (n + 2)));
      if(rolls)
      {
        const Real pressure = -c * twice * cosine[n + 2] / (2 * g) + (n == 0 ? 1 : 0);
        const Real backwards =
            (c * twice * sine[n + 2] - a * Real(static_cast<double>(n + 1)) * w[n + 1]) / (2 * g);
        ends[0][n] = mu * pressure - backwards;
        ends[1][n] = mu * pressure + backwards;
      }
      else
      {
        ends[0][n] = mode == Mode::scraping_forwards ? slip[n] : Real(-slip[n]);
        ends[1][n] = force[n];
      }
    }
  }
};

// How far the series may be used: by the last two terms of Φ and w.
template <class Real>
double radius(const Expansion<Real>& e)
{
  double shortest = std::numeric_limits<double>::infinity();
  for(const Series<Real>* p : {&e.Phi, &e.w})
  {
    double size = 1;
    for(std::size_t n = 0; n < 4; ++n)
      size = std::max(size, std::abs(static_cast<double>((*p)[n])));
    for(const int n : {terms<Real> - 2, terms<Real> - 1})
    {
      const double term = std::abs(static_cast<double>((*p)[static_cast<std::size_t>(n)])) / size;
      if(term > 0)
        shortest = std::min(shortest, std::pow(term, -1.0 / n));
    }
  }
  return shortest;
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
    while(zeros + 1 < p.size()
          && std::abs(static_cast<double>(p[zeros] * power))
                 < (std::is_same_v<Real, double> ? 1e-12 : 1e-40) * size)
    {
      ++zeros;
      power *= length;
    }
    p.erase(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(zeros));
  }
  if(stays_positive(p, length))
    return -1;
  constexpr std::size_t parts = 32;
  const Series<Real> slope = derivative_of(p);
  // Both at all ends of the parts together, each as value_of() has it.
  std::array<Real, parts + 1> at, of_p{}, of_slope{};
  for(std::size_t n = 0; n <= parts; ++n)
    at[n] = length * static_cast<double>(n) / static_cast<double>(parts);
  const auto all_values = [&at](const Series<Real>& terms_of, std::array<Real, parts + 1>& values) {
    for(std::size_t term = terms_of.size(); term-- > 0;)
      for(std::size_t n = 0; n <= parts; ++n)
        values[n] = values[n] * at[n] + terms_of[term];
  };
  all_values(p, of_p);
  all_values(slope, of_slope);
  const auto falls_below = [&](Real a, Real b) {  // p(a) ≥ 0 > p(b)
    Real middle = (a + b) / 2;
    for(int n = 0; n < most_halvings && a < middle && middle < b; ++n, middle = (a + b) / 2)
      (value_of(p, middle) < 0 ? b : a) = middle;
    return b;
  };
  for(std::size_t n = 0; n < parts; ++n)
  {
    const Real a = at[n], b = at[n + 1];
    if(of_p[n + 1] < 0)
      return falls_below(a, b);
    // It may dip below zero and come back.
    if(of_slope[n] < 0 && of_slope[n + 1] > 0)
    {
      Real low = a, high = b;
      Real middle = (low + high) / 2;
      for(int m = 0; m < most_halvings && low < middle && middle < high; ++m, middle = (low + high) / 2)
        (value_of(slope, middle) < 0 ? low : high) = middle;
      if(value_of(p, low) < 0)
        return falls_below(a, low);
    }
  }
  return -1;
}

}  // namespace

template <class Real>
Real Path<Real>::energy(const State<Real>& state) const
{
  using std::cos, std::sin;
  const auto& [a, c, k] = ball_;
  const Real x = state.slip + (a - c * cos(state.Phi)) * state.w, y = c * state.w * sin(state.Phi);
  return (x * x + y * y + k * k * state.w * state.w) / 2 + 2 * g_ * (a - c * cos(state.Phi));
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
  const auto& [a, c, k] = ball_;
  const Real cosine = cos(state.Phi), sine = sin(state.Phi), ww = state.w * state.w;
  if(2 * g_ + c * ww * cosine < 0)
    return Mode::off;
  if(state.slip != 0)
    return state.slip > 0 ? Mode::scraping_forwards : Mode::scraping_backwards;
  const Real turning = -sine * (2 * g_ * c + a * c * ww) / (bb(ball_) + 2 * a * c * (1 - cosine));
  const Real backwards = (c * turning * cosine - c * ww * sine - a * turning) / (2 * g_);
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
  steps_.push_back({now_, e.Phi, e.w, e.s, e.slip});
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
  if(!(mu >= 0 && mu < rolling::painleve(ball).mu))
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
