#include "globe/rolling.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "elliptic/carlson.hpp"
#include "globe/clock.hpp"
#include "globe/halves.hpp"
#include "globe/roots.hpp"

namespace globe::rolling
{

template <class Real>
void require(const Ball<Real>& ball)
{
  const Real limit = 1e40 * (1 + 1e-12) * bb(ball);  // whoever rounds before he compares finds 10²⁰ b kept
  if(!(ball.a > 0 && ball.c > 0 && ball.k > 0 && ball.a * ball.a <= limit && ball.c * ball.c <= limit
       && limit < 1e300))
    throw std::domain_error("the rolling ball needs a, c, k > 0 and a, c ≤ 10²⁰ b");
}

namespace
{

using exact::Fifty;
constexpr double infinite = std::numeric_limits<double>::infinity();

// The formula, from sin ½Φ over √h and what the squares of it and of sin ½Φ lack of 1.
template <class Real>
Real time_to(const Ball<Real>& ball, const Real& sine, const Real& of_rest, const Real& of_top,
             const Real& ss)
{
  using std::sqrt;
  // [time]
  const Real b = sqrt(bb(ball));
  const Real q = 4 * ball.a * ball.c * ss / bb(ball);
  const auto [F, J] = elliptic::R_F_and_J(of_rest, of_top, Real(1 + q), Real(1));
  return b * sine * (F + q / 3 * J);
  // [time]
}

// The same formula, all arguments of its integrals times bbh: no quotient and no root is left outside them.
double time_by_products(const Ball<double>& ball, double h, double sine, double left, double tt)
{
  const double inertia = bb(ball), own = 4 * ball.a * ball.c * (sine * sine);
  const auto [F, J] =
      elliptic::R_F_and_J(left * inertia, h * tt * inertia, h * (inertia + own), h * inertia);
  return inertia * sine * (F + h * own / 3 * J);
}

// What stands in the brackets above, where the first of the arguments is 0, 1 − ϖ being y: by Gauss's means a and g,
// and with them p, which goes to the same limit (Borchardt's and Bulirsch's way to integrals of the third kind).
// With Sₙ = 1 + ½εₙ Sₙ₊₁ and ε = (pp − ag)/(pp + ag) the brackets are ½π(1 + ½qS₀) over the mean. S, and Cₙ = 2 − Sₙ
// with it, are found from the last on by sums of what is positive: where q is large S₀ is small, and keeps its digits.
double whole_by_means(double y, double q)
{
  constexpr int most = 32;  // 12 suffice
  double a = std::sqrt(1 + q), g = std::sqrt(y), p = 1, of_p[most], of_mean[most];
  int n = 0;
  for(bool near = false; !near && n < most; ++n)
  {
    const double ag = a * g, pp = p * p, both = pp + ag, part = 1 / both;
    of_p[n] = pp * part;
    of_mean[n] = ag * part;
    near = std::abs(a - g) <= 1e-8 * a && std::abs(pp - ag) <= 1e-8 * both;
    p = both / (2 * p);
    a = (a + g) / 2;
    g = std::sqrt(ag);
  }
  double S = 1, C = 1;
  while(n-- > 0)
  {
    const double half = C / 2;
    C = half + of_mean[n] * S;
    S = half + of_p[n] * S;
  }
  return std::numbers::pi / 2 * (1 + q / 2 * S) / a;
}

// The formula from the lowest place to the end of a quarter.
template <class Real>
Real whole(const Ball<Real>& ball, const Real& sine, const Real& y, const Real& ss)
{
  if constexpr(std::is_same_v<Real, double>)
    return std::sqrt(bb(ball)) * sine * whole_by_means(y, 4 * ball.a * ball.c * ss / bb(ball));
  else
    return time_to(ball, sine, Real(0), y, ss);
}

// With the energy for the top, so near it that cos² ½Φ is about to vanish among the doubles.
template <class Real>
bool is_beyond_carlson(const Energy<Real>& e, const Real& tt)
{
  return e.from_top == 0 && tt < 1e-200;
}

// With w = sin² ½Φ: Q = Q₀ + h Q₁ and L = L₀ + h L₁, each a polynomial in w. The pressure is PQ/DD, the friction
// cP sin Φ L/DD. In w nothing cancels at the bottom, where a ball that hardly rocks stays.
template <class Real>
struct Polynomials
{
  using P = std::vector<Real>;
  P Q0, Q1, L0, L1;

  explicit Polynomials(const Ball<Real>& given)
  {
    const Ball<Real> ball = in_own_measure(given);
    const Real a = ball.a, c = ball.c;
    const P D{bb(ball), 4 * a * c}, y{ball.gap, 2 * c}, u{1, -2}, w{0, 1}, w_rest{0, 1, -1};
    // Q = DD − 4ccN w(1 − w) + 4ccu(h − w)D and L = yN − 4c(h − w)D, with N = bb + 4ach
    Q0 = plus(plus(product_of(D, D), w_rest, Real(-4 * c * c * bb(ball))), product_of(product_of(u, w), D),
              Real(-4 * c * c));
    Q1 = plus(product_of(u, D), w_rest, Real(-4 * a * c));
    for(Real& q : Q1)
      q *= 4 * c * c;
    L0 = plus(product_of(y, {bb(ball)}), product_of(w, D), Real(4 * c));
    L1 = plus(product_of(y, {4 * a * c}), D, Real(-4 * c));
  }

  P Q(const Real& h) const { return plus(Q0, Q1, h); }
  P L(const Real& h) const { return plus(L0, L1, h); }

  // p + factor q
  static P plus(P p, const P& q, const Real& factor)
  {
    p.resize(std::max(p.size(), q.size()), Real(0));
    for(std::size_t n = 0; n < q.size(); ++n)
      p[n] += factor * q[n];
    return p;
  }
};

// pq' − p'q
template <class Real>
std::vector<Real> cross(const std::vector<Real>& p, const std::vector<Real>& q)
{
  return Polynomials<Real>::plus(product_of(p, derivative_of(q)), product_of(derivative_of(p), q),
                                 Real(-1));
}

// The place where sin² ½Φ = w.
template <class Real>
Place<Real> place_of(const Real& w)
{
  using std::sqrt;
  return {sqrt(w), sqrt(1 - w)};
}

template <class Real>
Real angle_of(const Place<Real>& place)
{
  using std::atan2;
  return 2 * atan2(place.s, place.c);
}

}  // namespace

template <class Real>
Real time(const Ball<Real>& ball, const Energy<Real>& e, const Place<Real>& place)
{
  using std::max, std::min, std::sqrt;
  require(ball);
  require(e);
  const Real ss = place.s * place.s, tt = place.c * place.c;
  const Real left = left_for_motion(e, place);
  if(place.s == 0)
    return 0;
  if(!(left >= -8 * std::numeric_limits<double>::epsilon() * min(e.h, tt)))
    throw std::domain_error("the ball does not get there");
  if(is_beyond_carlson(e, tt))
    return separatrix_time(ball, place);
  if constexpr(std::is_same_v<Real, double>)
    if(const double both = e.h * bb(ball); both > 1e-40 && both < 1e40 && e.h > 1e-20 && e.h < 1e20)
      return time_by_products(ball, e.h, place.s, max(left, 0.), tt);
  return time_to(ball, Real(place.s / sqrt(e.h)), max(Real(left / e.h), Real(0)), tt, ss);
}

template <class Real>
Real quarter(const Ball<Real>& ball, const Energy<Real>& e)
{
  using std::sqrt;
  require(ball);
  require(e);
  if(e.from_top == 0)
    return infinite;
  if(e.turns_over())
    return whole(ball, Real(1 / sqrt(e.h)), Real(-e.from_top / e.h), Real(1));
  return whole(ball, Real(1), e.from_top, e.h);
}

double excess(const Ball<double>& ball, const Energy<double>& e)
{
  require(ball);
  require(e);
  if(!(e.from_top > 0))
    throw std::domain_error("the excess is of a ball that rocks");
  const double q = 4 * ball.a * ball.c * e.h / bb(ball);
  // With much of the ball's own in it the excess is no small quantity, and the mean would ask for many nodes.
  if(q > 1e3)
    return quarter(ball, e) / (std::numbers::pi / 2 * std::sqrt(bb(ball))) - 1;
  const double of_pendulum = pendulum_excess(e);
  const double of_ball =
      mean_over_quarter(e.from_top, [q](double s2, double, double) { return root_excess(q * s2); });
  return of_pendulum + of_ball + of_pendulum * of_ball;
}

template <class Real>
Real separatrix_time(const Ball<Real>& ball, const Place<Real>& place)
{
  using std::asinh, std::sqrt;
  require(ball);
  if(place.c == 0)
    return infinite;
  // [elementary]
  const Real b = sqrt(bb(ball)), B = sqrt(BB(ball)), r = 2 * sqrt(ball.a * ball.c);
  // artanh (BV/√D) = arsinh (BV/√(D − BBVV)), and D − BBVV = bb(1 − VV)
  return B * asinh(B * place.s / (b * place.c)) - r * asinh(r * place.s / b);
  // [elementary]
}

Turned angle(const Ball<double>& ball, const Energy<double>& e, double tau)
{
  const double whole = quarter(ball, e);
  return Clock(e).at(tau, whole, [&](const Clock::Reading& now) {
    const double ss = now.place.s * now.place.s, tt = now.place.c * now.place.c;
    const double of_rest = e.turns_over() ? (tt - e.from_top) / e.h : now.cn * now.cn;
    const double sine = e.turns_over() ? now.place.s / std::sqrt(e.h) : now.sn;
    const double derivative = std::sqrt(bb(ball) + 4 * ball.a * ball.c * ss);
    if(is_beyond_carlson(e, tt))
      return Clock::Rate{separatrix_time(ball, now.place), derivative};
    return Clock::Rate{sine == 0 ? 0 : time_to(ball, sine, of_rest, tt, ss), derivative};
  });
}

void quarter(const Ball<double>& ball, std::span<const Energy<double>> e, std::span<double> out)
{
  require_equal(e.size(), out.size());
  for(std::size_t i = 0; i < out.size(); ++i)
    out[i] = quarter(ball, e[i]);
}

void time(const Ball<double>& ball, const Energy<double>& e, std::span<const Place<double>> place,
          std::span<double> out)
{
  require_equal(place.size(), out.size());
  for(std::size_t i = 0; i < out.size(); ++i)
    out[i] = time(ball, e, place[i]);
}

template <class Real>
Real velocity_squared(const Ball<Real>& ball, const Energy<Real>& e, const Place<Real>& place)
{
  return 4 * left_for_motion(e, place) / (bb(ball) + 4 * ball.a * ball.c * place.s * place.s);
}

namespace
{

// c, D, and Q and L by products, in the ball's own measure: h − ϖ and N = bb + 4ach are formed without subtraction.
template <class Real>
struct Borne
{
  Real c, D, Q, L, sine;

  Borne(const Ball<Real>& given, const Energy<Real>& e, const Place<Real>& place)
  {
    const Ball<Real> ball = in_own_measure(given);
    const Real a = ball.a;
    c = ball.c;
    const Real ss = place.s * place.s, tt = place.c * place.c, u = tt - ss;
    const Real left = left_for_motion(e, place);
    const Real N = bb(ball) + 4 * a * c * e.h;
    sine = 2 * place.s * place.c;
    D = bb(ball) + 4 * a * c * ss;
    Q = D * D - c * c * N * sine * sine + 4 * c * c * u * left * D;
    L = (ball.gap + 2 * c * ss) * N - 4 * c * left * D;
  }
};

}  // namespace

template <class Real>
Real pressure(const Ball<Real>& ball, const Energy<Real>& e, const Place<Real>& place)
{
  const Borne<Real> borne(ball, e, place);
  return borne.Q / (borne.D * borne.D);
}

template <class Real>
Real friction(const Ball<Real>& ball, const Energy<Real>& e, const Place<Real>& place)
{
  const Borne<Real> borne(ball, e, place);
  return borne.c * borne.sine * (borne.L / borne.Q);
}

template <class Real>
Greatest<Real> greatest_friction(const Ball<Real>& ball, const Energy<Real>& e)
{
  using std::abs, std::sqrt;
  require(ball);
  require(e);
  const Polynomials<Real> all(ball);
  const auto Q = all.Q(e.h), L = all.L(e.h);
  const Place<Real> rest = e.turns_over() ? Place<Real>{1, 0} : Place<Real>{sqrt(e.h), sqrt(e.from_top)};
  const Real last = e.turns_over() ? Real(1) : e.h;
  const auto off = roots_between(Q, Real(0), last);
  if(!off.empty())
    return {angle_of(place_of(off.front())), infinite};
  Greatest<Real> greatest{angle_of(rest), e.turns_over() ? Real(0) : friction(ball, e, rest)};
  const std::vector<Real> u{1, -2}, twice_w_rest{0, 2, -2};
  const auto extremal = Polynomials<Real>::plus(product_of(u, product_of(L, Q)),
                                                product_of(twice_w_rest, cross(Q, L)), Real(1));
  for(const Real& root : roots_between(extremal, Real(0), last))
  {
    const Place<Real> there = place_of(root);
    const Real lambda = friction(ball, e, there);
    if(abs(lambda) > abs(greatest.lambda))
      greatest = {angle_of(there), lambda};
  }
  return greatest;
}

namespace
{

// What friction forbids at one place: the energies h from one to another.
template <class Real>
struct Forbidden
{
  Real from, to;  // none where from > to
};

// How rolling with the friction sigma μ is limited, place by place: μQ − sigma c sin Φ L is α + βh. Places are given by
// tan ½Φ.
template <class Real>
class Limit
{
public:
  Limit(const Ball<Real>& ball, const Real& mu, int sigma)
      : all_(ball), ball_(in_own_measure(ball)), mu_(mu), sigma_(sigma)
  {
  }

  Forbidden<Real> at(const Real& tangent) const
  {
    const Real whole = 1 + tangent * tangent, rest = tangent * tangent / whole;
    const Real c_sine = sigma_ * 2 * ball_.c * tangent / whole, y = ball_.gap + 2 * ball_.c * rest;
    // The h at which just so much friction is needed; with more energy it needs more where β is below 0.
    const Real alpha = mu_ * value_of(all_.Q0, rest) - c_sine * value_of(all_.L0, rest);
    const Real beta = mu_ * value_of(all_.Q1, rest) - c_sine * value_of(all_.L1, rest);
    const Real h = -alpha / beta;
    if(beta < 0)
      return {std::max(h, rest), Real(infinite)};
    // At rest λ is c sin Φ y/(kk + yy).
    if(mu_ * (ball_.k * ball_.k + y * y) < c_sine * y)
      return {rest, h};
    return {Real(infinite), Real(-infinite)};
  }

private:
  Polynomials<Real> all_;
  Ball<Real> ball_;
  Real mu_;
  int sigma_;
};

// The least of f between two places that enclose it, also where f has a kink or is infinite beyond: the place to twenty
// digits, and the value, where f is smooth, to twice as many.
template <class Function>
Fifty least(const Function& f, Fifty a, Fifty b)
{
  const Fifty part = (3 - sqrt(Fifty(5))) / 2;
  Fifty x = a + part * (b - a), y = b - part * (b - a), fx = f(x), fy = f(y);
  while(b - a > 1e-20 * b)
  {
    if(fx <= fy)
    {
      b = y, y = x, fy = fx;
      x = a + part * (b - a), fx = f(x);
    }
    else
    {
      a = x, x = y, fx = fy;
      y = b - part * (b - a), fy = f(y);
    }
  }
  return std::min(fx, fy);
}

// What is forbidden at a run of neighbouring places hangs together. They are looked for in double, close to each other
// where the ball's own moment changes and evenly in log tan ½Φ beyond; the ends are put right in fifty digits.
void add_forbidden(const Ball<Fifty>& ball, const Fifty& mu, int sigma,
                   std::vector<Forbidden<Fifty>>& forbidden)
{
  constexpr int steps = 4000;
  const Limit<Fifty> limit(ball, mu, sigma);
  const Limit<double> near(rounded(in_own_measure(ball)), static_cast<double>(mu), sigma);
  const double bend = std::min(1., std::sqrt(static_cast<double>(bb(ball) / BB(ball))));
  const double unit = std::asinh(1e9 / bend) / steps;
  const auto place_of_step = [&](int n) {
    return n <= 0 ? 0 : bend * std::sinh(unit * std::min(n, steps));
  };
  std::vector<Forbidden<double>> looked;
  for(int n = 0; n <= steps; ++n)
    looked.push_back(near.at(place_of_step(n)));
  const auto around = [&](const auto& f, int n) {
    return least(f, Fifty(place_of_step(n - 1)), Fifty(place_of_step(n + 1)));
  };
  const auto index = [](int n) { return static_cast<std::size_t>(n); };
  const auto none_at = [&](int n) { return n > steps || looked[index(n)].from > looked[index(n)].to; };
  for(int n = 0; n <= steps; ++n)
  {
    if(none_at(n))
      continue;
    int lowest = n, highest = n;
    for(; !none_at(n); ++n)
    {
      lowest = looked[index(n)].from < looked[index(lowest)].from ? n : lowest;
      highest = looked[index(n)].to > looked[index(highest)].to ? n : highest;
    }
    const bool ends = std::isfinite(looked[index(highest)].to);
    forbidden.push_back(
        {around([&](const Fifty& at) { return limit.at(at).from; }, lowest),
         ends ? Fifty(-around([&](const Fifty& at) { return Fifty(-limit.at(at).to); }, highest))
              : Fifty(infinite)});
  }
}

}  // namespace

template <>
std::vector<Window<Fifty>> windows(const Ball<Fifty>& ball, const Fifty& mu)
{
  require(ball);
  if(!(mu > 0) || !isfinite(mu))
    throw std::domain_error("μ must be positive and finite");
  std::vector<Forbidden<Fifty>> forbidden;
  for(const int sigma : {1, -1})
    add_forbidden(ball, mu, sigma, forbidden);
  forbidden.push_back({loss_of_pressure(ball).h, Fifty(infinite)});
  std::sort(forbidden.begin(), forbidden.end(),
            [](const auto& f, const auto& g) { return f.from < g.from; });
  std::vector<Window<Fifty>> rolls;
  Fifty h = 0;
  for(const auto& f : forbidden)
  {
    if(f.from > h)
      rolls.push_back({h, f.from});
    h = std::max(h, f.to);
  }
  return rolls;
}

template <>
std::vector<Window<double>> windows(const Ball<double>& ball, const double& mu)
{
  std::vector<Window<double>> all;
  for(const Window<Fifty>& window : windows(exactly(ball), Fifty(mu)))
    all.push_back({static_cast<double>(window.from), static_cast<double>(window.to)});
  return all;
}

template <class Real>
Loss<Real> loss_of_pressure(const Ball<Real>& given)
{
  require(given);
  // −Q₀/Q₁ loses digits where G is close to the plane, or far below it: the double's answer is that of fifty digits.
  if constexpr(std::is_same_v<Real, double>)
  {
    const auto exact = loss_of_pressure(exactly(given));
    return {static_cast<double>(exact.h), static_cast<double>(exact.Phi),
            static_cast<double>(exact.from_top)};
  }
  const Ball<Real> ball = in_own_measure(given);
  const Polynomials<Real> all(ball);
  const auto h_at = [&](const Real& w) { return Real(-value_of(all.Q0, w) / value_of(all.Q1, w)); };
  const Real a = ball.a, c = ball.c;
  Loss<Real> first{1 + BB(ball) / (4 * c * c), angle_of(Place<Real>{1, 0}), Real(0)};
  if(ball.k * ball.k >= (a + c) * (3 * c - a))
    return first;
  // Q₁ is below 0 from the top down to its root; beyond, more energy only presses more.
  for(const Real& w : roots_between(cross(all.Q0, all.Q1), Real(0), Real(1)))
    if(value_of(all.Q1, w) < 0 && h_at(w) < first.h)
    {
      const Place<Real> there = place_of(w);
      first = {h_at(w), angle_of(there), angle_of(Place<Real>{there.c, there.s})};
    }
  return first;
}

template <class Real>
Painleve<Real> painleve(const Ball<Real>& given)
{
  using std::abs, std::sqrt;
  require(given);
  const Ball<Real> ball = in_own_measure(given);
  const auto& [a, c, k, gap] = ball;
  // The greatest of sin Φ y/(kk + cc sin²Φ), y = a − c cos Φ: where ½ sin Φ times the derivative by w of both,
  // and u = cos Φ, that of sin Φ, balance. With w = sin² ½Φ in the lower half and cos² ½Φ in the upper.
  const std::vector<Real> moment{k * k, 4 * c * c, -4 * c * c}, twice_w_rest{0, 2, -2};
  // At 90° the halves meet: a root that rounding has put beyond the end of either is there.
  const Real half = sqrt(Real(0.5));
  Painleve<Real> limit{(k * k + c * c) / (c * a), angle_of(Place<Real>{half, half})};
  for(const int side : {1, -1})
  {
    const std::vector<Real> y{side > 0 ? gap : Real(a + c), Real(side * 2 * c)},
        u{Real(side), Real(-2 * side)};
    const auto extremal = Polynomials<Real>::plus(product_of(u, product_of(y, moment)),
                                                  product_of(twice_w_rest, cross(moment, y)), Real(side));
    for(const Real& w : roots_between(extremal, Real(0), Real(0.5)))
    {
      const Place<Real> there = place_of(w);
      const Real mu = value_of(moment, w) / (2 * c * there.s * there.c * abs(value_of(y, w)));
      if(mu < limit.mu)
        limit = {mu, angle_of(side > 0 ? there : Place<Real>{there.c, there.s})};
    }
  }
  return limit;
}

#define GLOBE_ROLLING(Real)                                                                                \
  template void require(const Ball<Real>&);                                                                \
  template Real time(const Ball<Real>&, const Energy<Real>&, const Place<Real>&);                          \
  template Real quarter(const Ball<Real>&, const Energy<Real>&);                                           \
  template Real separatrix_time(const Ball<Real>&, const Place<Real>&);                                    \
  template Real velocity_squared(const Ball<Real>&, const Energy<Real>&, const Place<Real>&);              \
  template Real pressure(const Ball<Real>&, const Energy<Real>&, const Place<Real>&);                      \
  template Real friction(const Ball<Real>&, const Energy<Real>&, const Place<Real>&);                      \
  template Greatest<Real> greatest_friction(const Ball<Real>&, const Energy<Real>&);                       \
  template Loss<Real> loss_of_pressure(const Ball<Real>&);                                                 \
  template Painleve<Real> painleve(const Ball<Real>&);
GLOBE_ROLLING(double)
GLOBE_ROLLING(Fifty)
#undef GLOBE_ROLLING

}  // namespace globe::rolling
