#include "swing/motion.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "swing/phase.hpp"
#include "swing/twofold.hpp"
#include "swing_tables.hpp"

#if defined(__x86_64__)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace swing
{
namespace
{

using kernels::Prepared;

#if defined(__x86_64__)
using Settings = unsigned;
Settings settings()
{
  return _mm_getcsr();
}
Settings to_nearest(Settings s)
{
  constexpr unsigned denormals_are_zero = 0x40;
  return s & ~(_MM_ROUND_MASK | _MM_FLUSH_ZERO_MASK | denormals_are_zero);
}
void set(Settings s)
{
  _mm_setcsr(s);
}
#else
using Settings = int;
Settings settings()
{
  return std::fegetround();
}
Settings to_nearest(Settings)
{
  return FE_TONEAREST;
}
void set(Settings s)
{
  std::fesetround(s);
}
#endif

// As long as it lives, sums are rounded to the nearest double, and on x86 subnormal numbers kept; then what
// was set before returns. Otherwise neither products nor whole half swings would be split exactly. What is
// computed under it stands in functions of its own, so that no compiler moves it out.
class To_nearest
{
public:
  To_nearest() : before_(settings())
  {
    if(to_nearest(before_) != before_)
      set(to_nearest(before_));
  }
  ~To_nearest()
  {
    if(to_nearest(before_) != before_)
      set(before_);
  }
  To_nearest(const To_nearest&) = delete;
  To_nearest& operator=(const To_nearest&) = delete;

private:
  Settings before_;
};

// Whether the setting is such already. It is faster to look what two sums are rounded to than to ask the
// processor; flushed numbers do not count where none is as small as that.
bool usual_setting()
{
  double tiny = 0x1p-60;
#if defined(__x86_64__)
  asm volatile("" : "+x"(tiny));
#else
  asm volatile("" : "+m"(tiny));
#endif
  return !(1 + tiny > 1 - tiny);
}

kernels::Course started(kernels::Course course, Start start)
{
  return static_cast<kernels::Course>(course + (start == Start::rest));
}

Twofold half(Twofold x)
{
  return {0.5 * x.hi, 0.5 * x.lo};
}

void set_frequency(Prepared& p, Twofold f)
{
  const double head = head_of(f.hi);
  p.frequency = {f.hi, head, f.hi - head, f.lo, p.frequency.reach};
}

void set_log_q(Prepared& p, Twofold log_q)
{
  p.log_q_hi = log_q.hi;
  p.log_q_head = head_of(log_q.hi);
  p.log_q_tail = log_q.hi - p.log_q_head;
  p.log_q_lo = log_q.lo;
}

void set_scales(Prepared& p, Twofold angle, Twofold velocity)
{
  p.angle_scale = angle.hi;
  p.velocity_scale = velocity.hi;
  if(angle.hi > 0)
  {
    p.angle_scale_lost = angle.lo / angle.hi;
    p.velocity_scale_lost = velocity.lo / velocity.hi;
  }
}

// The nome of a modulus k ≤ 1/√2 with complement kc: q = ε + 2ε⁵ + 15ε⁹ + …, 2ε = (1 − √kc)/(1 + √kc); and
// √q/k. Neither subtracts anything.
struct Nome
{
  double q;
  double root_over_modulus;
};

Nome nome_of(double k, double kc)
{
  const double divisor = 2 * (1 + kc) * (1 + std::sqrt(kc)) * (1 + std::sqrt(kc));
  const double epsilon = k * k / divisor;
  const double e4 = epsilon * epsilon * epsilon * epsilon;
  const double series = 1 + e4 * (2 + e4 * (15 + e4 * (150 + e4 * 1707)));
  return {epsilon * series, std::sqrt(series / divisor)};
}

// Polynomials in x = (sin z / π)², with one coefficient more than is prepared: a factor is taken out.
using Series = std::array<double, kernels::series_terms + 1>;

// Fourier's series as such a polynomial: Σ a(n) fₙ for n ≤ last, where fₙ₊₁ = 2 cos 2z fₙ − fₙ₋₁ and
// cos 2z = 1 − 2π²x. To cut off the polynomial instead would cost many digits.
template <class Coefficient>
Series sum_of_multiples(Series before_first, Series first, unsigned last, Coefficient a)
{
  Series before = before_first;
  Series f = first;
  Series sum{};
  for(unsigned n = 0; n <= last; ++n)
  {
    const double factor = a(n);
    Series next{};
    for(std::size_t j = 0; j < f.size(); ++j)
    {
      sum[j] += factor * f[j];
      next[j] = 2 * f[j] - before[j] - (j > 0 ? 4 * pi_hi * pi_hi * f[j - 1] : 0);
    }
    before = f;
    f = next;
  }
  return sum;
}

double power(double q, unsigned n)
{
  double result = 1;
  for(; n > 0; --n)
    result *= q;
  return result;
}

// The polynomial with its first coefficient taken out, where the scale of the whole series' first
// coefficient will take its place. The polynomial's lacks `next`: returns what the scale is to be corrected
// by, relative to it.
double set_relative(double (&to)[kernels::series_terms], const Series& c, double next)
{
  for(std::size_t j = 0; j < kernels::series_terms; ++j)
    to[j] = c[j + 1] / c[0];
  return -next / c[0];
}

// Swinging: Φ = 8√q Σ qⁿ/((2n+1)(1 + q²ⁿ⁺¹)) sin (2n+1)z, and its derivative with z counted from rest,
// where the signs alternate; sin (2n+1)z = sin z fₙ with f₋₁ = −1 and, at z = 0, fₙ = 2n+1.
void set_swinging(Prepared& p, double q, unsigned terms)
{
  const auto velocity = [q](unsigned n) {
    return (n % 2 == 0 ? 1 : -1) * power(q, n) / (1 + power(q, 2 * n + 1));
  };
  const auto angle = [&](unsigned n) { return std::abs(velocity(n)) / (2 * n + 1); };
  const unsigned next = terms + 1;
  p.angle_scale_lost +=
      set_relative(p.angle_series, sum_of_multiples({-1}, {1}, terms, angle), (2 * next + 1) * angle(next));
  p.velocity_scale_lost += set_relative(p.velocity_series, sum_of_multiples({-1}, {1}, terms, velocity),
                                        (2 * next + 1) * velocity(next));
}

// Revolving: Φ = 2z + 4 Σ qⁿ/n(1 + q²ⁿ) sin 2nz, where sin 2nz = 2 sin z cos z fₙ₋₁ with f₋₁ = 0; and its
// derivative, a series of cos 2nz = fₙ with f₋₁ = cos 2z.
void set_revolving(Prepared& p, double q)
{
  const auto a = [q](unsigned n) { return power(q, n) / (1 + power(q, 2 * n)); };
  const Series angle = sum_of_multiples({}, {8 * pi_hi * pi_hi}, kernels::series_terms - 1,
                                        [&](unsigned n) { return a(n + 1) / (n + 1); });
  std::copy_n(angle.begin(), kernels::series_terms, p.angle_series);
  const auto velocity = [&](unsigned n) { return n == 0 ? 0.25 : a(n); };
  constexpr Series cosine{1, -2 * pi_hi * pi_hi};
  p.velocity_scale_lost +=
      set_relative(p.velocity_series, sum_of_multiples(cosine, {1}, kernels::series_terms, velocity),
                   a(kernels::series_terms + 1));
}

// The cofactor of kernels/forms.hpp, for the constants in front.
Twofold cofactor(double q, double x, double y)
{
  const double three = 1 + x * (1 + x);
  const double five = 1 + x * (1 + x * three);
  const double seven = 1 + x * (1 + x * five);
  const double q2 = q * q;
  return sum_of(1, y * (three + y * q2 * (five + y * q2 * q2 * seven)));
}

// The dual nome of K/K' with the modulus k, its complement kc and M(1, kc). Returns the quotient of the
// theta functions at the bottom, of which one factor is 1 − q' or 1 + q'.
Twofold set_dual(Prepared& p, const Nome& dual, Twofold k, double kc, Twofold mean, double sign)
{
  p.root_q = kc * dual.root_over_modulus;
  p.q = p.root_q * p.root_q;
  set_log_q(p, Twofold{pi_hi, pi_lo} * agm_of_one_and(k) / mean);
  return cofactor(p.q, -1, p.q * p.q) / (sum_of(1, sign * p.q) * cofactor(p.q, -sign * p.q, sign * p.q));
}

// Swinging.
[[gnu::noinline]] kernels::Course prepare(Prepared& p, Amplitude a, Start start)
{
  if(a.eta == 0)
  {
    if(start == Start::rest)
      throw std::domain_error("swing: at rest at the top the pendulum stays there");
    set_frequency(p, {0x1p-500, 0});
    p.frequency.reach = 0.25;
    set_log_q(p, {0x1p500, 0});
    p.angle_scale = 0.5;
    p.velocity_scale = 4;
    return kernels::near_top;
  }
  const Twofold k = sin(half({a.zeta, a.zeta_rest}));
  const Twofold kc = sin(half({a.eta, a.eta_rest}));
  const Twofold mean = agm_of_one_and(kc);
  set_frequency(p, mean * Twofold{tables::one_over_pi_hi, tables::one_over_pi_lo});
  if(a.zeta <= a.eta)
  {
    const Twofold scale = k * Twofold{2 * pi_hi, 2 * pi_lo} / mean;
    set_scales(p, scale, scale * kc);
    const double q = nome_of(k.hi, kc.hi).q;
    const bool small = q < kernels::small_nome;
    set_swinging(p, q, small ? kernels::few_terms : kernels::series_terms);
    return started(small ? kernels::small : kernels::low, start);
  }
  const Nome dual = nome_of(kc.hi, k.hi);
  const Twofold scale = k * set_dual(p, dual, k, kc.hi, mean, -1);
  set_scales(p, scale * Twofold{2 * dual.root_over_modulus, 0}, {4 * scale.hi, 4 * scale.lo});
  return started(p.q < kernels::tiny_nome ? kernels::near_top : kernels::high, start);
}

// Going round: with κ² = 1/(1 + excess), Φ = 2 am(t/κ, κ); a turn takes the time 2κK(κ) = π/M(1/κ, κ'/κ).
[[gnu::noinline]] kernels::Course prepare(Prepared& p, double excess)
{
  const Twofold inverse = sqrt(sum_of(1, excess));
  const Twofold kappa = Twofold{1, 0} / inverse;
  const Twofold kappa_c = sqrt(Twofold{excess, 0}) / inverse;
  const Twofold mean = agm_of_one_and(kappa_c);
  set_frequency(p, mean * inverse * Twofold{tables::one_over_pi_hi, tables::one_over_pi_lo});
  if(excess >= 1)
  {
    p.velocity_scale = 2 * inverse.hi;
    p.velocity_scale_lost = inverse.lo / inverse.hi;
    set_revolving(p, nome_of(kappa.hi, kappa_c.hi).q);
    return kernels::fast;
  }
  const Twofold at_bottom = set_dual(p, nome_of(kappa_c.hi, kappa.hi), kappa, kappa_c.hi, mean, 1);
  const Twofold scale = inverse * at_bottom;
  set_scales(p, Twofold{0.5, 0} / at_bottom, {4 * scale.hi, 4 * scale.lo});
  return kernels::barely;
}

// How many rows a quarter period has, if it takes the time `quarter` in the unit in which the poles of the
// motion lie ½π or more from the real times: so many that a row's polynomial is exact to 2⁻⁵⁵ of the angle.
// None where they would no longer fit into the nearest caches.
std::size_t rows_in_quarter(double quarter)
{
  constexpr double longest_step = 0.05;
  std::size_t n = 32;
  while(static_cast<double>(n) * longest_step < quarter)
  {
    n *= 2;
    if(n > 512)
      return 0;
  }
  return n;
}

bool starts_at_rest(kernels::Course course)
{
  return course < kernels::fast && course % 2 == 1;
}
bool goes_round(kernels::Course course)
{
  return course >= kernels::fast;
}

// Rows and the memory they lie in.
struct Made
{
  kernels::Rows rows;
  std::vector<kernels::Row> memory;
};

// The way to go from the first phase to the last, known better than where each phase lies.
struct Way
{
  Twofold from;
  Twofold length;
};

// The angles at the phases once more, as sums of the steps from each to the next: these are so small that
// their roundings hardly count, and what they are wrong by in common goes out, for they must make up the
// whole way.
void settle(std::vector<kernels::Row>& rows, std::size_t last, const Way& way)
{
  const auto beyond = [](const kernels::Row& row, double distance) {
    kernels::Row without = row;
    without.c[0] = 0;
    return phase::polynomial(without.c, distance);
  };
  std::vector<Twofold> gone{{}};
  for(std::size_t i = 0; i < last; ++i)
    gone.push_back(gone[i] + Twofold{beyond(rows[i], 0.5) - beyond(rows[i + 1], -0.5), 0});
  const Twofold scale = way.length / gone[last];
  for(std::size_t i = 0; i <= last; ++i)
    rows[i].c[0] = (way.from + gone[i] * scale).hi;
}

// At each phase the question is answered from the beginning, with a half swing for the unit of time; the
// rest is the equation of motion. Angles are odd about the lowest point and change their sign from half
// swing to half swing.
[[gnu::noinline]] std::unique_ptr<const Made> made(const Prepared& p, kernels::Course course,
                                                   kernels::Question asked, std::size_t in_quarter,
                                                   const Way& way)
{
  const kernels::Table& best = kernels::best();
  const std::size_t size = (in_quarter / kernels::rows_at_once + 1) * kernels::rows_at_once;
  const double steps = 2 * static_cast<double>(in_quarter);
  Prepared by_phase = p;
  by_phase.frequency = {1, 1, 0, 0, 1};
  std::vector<double> phase(size);
  for(std::size_t i = 0; i < size; ++i)
    phase[i] = static_cast<double>(std::min(i, in_quarter)) / steps;
  const bool from_top = asked == kernels::from_top;
  std::vector<double> angle(size);
  std::vector<double> speed(size);
  best.direct[course][from_top ? kernels::from_top : kernels::angle](by_phase, phase.data(), angle.data(),
                                                                     size);
  best.direct[course][kernels::velocity](by_phase, phase.data(), speed.data(), size);
  if(from_top)
    for(double& v : speed)
      v = -v;

  auto result = std::make_unique<Made>();
  result->memory.resize(size);
  kernels::Rows& r = result->rows;
  r.frequency = p.frequency;
  r.steps = steps;
  r.row = result->memory.data();
  r.one = goes_round(course) && asked == kernels::angle ? best.read_one_turning : best.read_one;
  const kernels::Centres centres{angle.data(), speed.data(), size, from_top ? 1.0 : -1.0,
                                 1 / (p.frequency.hi * steps)};
  (asked == kernels::velocity ? best.rows_of_velocity : best.rows_of_angle)(centres, result->memory.data());
  if(asked == kernels::angle)
    settle(result->memory, in_quarter, way);
  if(asked != kernels::from_top)
  {
    const bool odd = (asked == kernels::angle) != starts_at_rest(course);
    r.by_parity = goes_round(course) ? 0 : bits::sign_bit;
    r.by_side = odd ? bits::sign_bit : 0;
  }
  if(goes_round(course) && asked == kernels::angle)
  {
    r.turn_hi = 2 * pi_hi;
    r.turn_lo = 2 * pi_lo;
  }
  return result;
}

}  // namespace

// What copies of a motion share: its rows, of which those for a question are made when it is first asked.
class Motion::Tables
{
public:
  Tables(std::size_t in_quarter, const Way& way) : in_quarter_(in_quarter), way_(way) {}
  ~Tables()
  {
    for(const std::atomic<const Made*>& made : made_)
      delete made.load();
  }
  Tables(const Tables&) = delete;
  Tables& operator=(const Tables&) = delete;

  // None where they have not been made yet.
  const kernels::Rows* ready(kernels::Question asked) const
  {
    const Made* const made = made_[asked].load(std::memory_order_acquire);
    return made != nullptr ? &made->rows : nullptr;
  }

  // None where there shall be none. To be called in round to nearest.
  const kernels::Rows* rows(const Prepared& p, kernels::Course course, kernels::Question asked)
  {
    if(in_quarter_ == 0)
      return nullptr;
    if(const kernels::Rows* const rows = ready(asked))
      return rows;
    std::unique_ptr<const Made> mine = made(p, course, asked, in_quarter_, way_);
    const Made* others = nullptr;
    if(made_[asked].compare_exchange_strong(others, mine.get()))
      return &mine.release()->rows;
    return &others->rows;
  }

private:
  std::size_t in_quarter_;
  Way way_;
  std::array<std::atomic<const Made*>, 3> made_{};
};

Motion::Motion(Amplitude a, Start start)
{
  const To_nearest whatever_was_set;
  course_ = prepare(prepared_, a, start);
  // With smaller amplitudes numbers may become subnormal where the rows are read, which may be flushed.
  const std::size_t rows = a.zeta > 0x1p-400 ? rows_in_quarter(0.5 / prepared_.frequency.hi) : 0;
  const Twofold zeta{a.zeta, a.zeta_rest};
  tables_ = std::make_shared<Tables>(rows, start == Start::rest ? Way{zeta, -zeta} : Way{{}, zeta});
}

Motion Motion::revolving(double excess)
{
  if(!(excess > 0 && excess <= 1e300))
    throw std::domain_error("swing: the excess of energy must be positive and at most 1e300");
  const To_nearest whatever_was_set;
  Motion m;
  m.course_ = prepare(m.prepared_, excess);
  m.tables_ = std::make_shared<Tables>(
      rows_in_quarter(0.5 * std::sqrt(1 + excess) / m.prepared_.frequency.hi), Way{{}, {pi_hi, pi_lo}});
  return m;
}

const kernels::Rows* Motion::rows(kernels::Question asked) const
{
  const To_nearest whatever_was_set;
  return tables_->rows(prepared_, course_, asked);
}

[[gnu::noinline]] double Motion::ask_with_care(kernels::Question asked, double t) const
{
  const To_nearest whatever_was_set;
  double result;
  if(const kernels::Rows* const rows = tables_->rows(prepared_, course_, asked))
    kernels::best().read(*rows, &t, &result, 1);
  else
    kernels::variant(0).direct[course_][asked](prepared_, &t, &result, 1);
  return result;
}

double Motion::ask(kernels::Question asked, double t) const
{
  const kernels::Rows* const rows = tables_->ready(asked);
  if(rows != nullptr && std::abs(t) >= 0x1p-400 && usual_setting()) [[likely]]
    return rows->one(*rows, t);
  return ask_with_care(asked, t);
}

void Motion::ask(kernels::Question asked, std::span<const double> t, std::span<double> out) const
{
  if(t.size() != out.size())
    throw std::invalid_argument("swing: the arrays differ in length");
  const To_nearest whatever_was_set;
  const kernels::Table& best = kernels::best();
  if(const kernels::Rows* const rows = tables_->rows(prepared_, course_, asked))
    best.read(*rows, t.data(), out.data(), t.size());
  else
    best.direct[course_][asked](prepared_, t.data(), out.data(), t.size());
}

double Motion::angle(double t) const
{
  return ask(kernels::angle, t);
}

double Motion::velocity(double t) const
{
  return ask(kernels::velocity, t);
}

double Motion::angle_from_top(double t) const
{
  return ask(kernels::from_top, t);
}

void Motion::angle(std::span<const double> t, std::span<double> out) const
{
  ask(kernels::angle, t, out);
}

void Motion::velocity(std::span<const double> t, std::span<double> out) const
{
  ask(kernels::velocity, t, out);
}

void Motion::angle_from_top(std::span<const double> t, std::span<double> out) const
{
  ask(kernels::from_top, t, out);
}

double Motion::period() const
{
  if(prepared_.frequency.reach < 1)
    return std::numeric_limits<double>::infinity();
  return (goes_round(course_) ? 1 : 2) / prepared_.frequency.hi;
}

}  // namespace swing
