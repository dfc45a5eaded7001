#include "swing/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

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

// As long as it lives, sums are rounded to the nearest double, and on x86 subnormal numbers kept; then what was
// set before returns. Otherwise neither products nor whole half swings would be split exactly. What is
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

void run(kernels::Table::Motion loop, const Prepared& p, const double* t, double* out, std::size_t n)
{
  const To_nearest whatever_was_set;
  loop(p, t, out, n);
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
  p.f_hi = f.hi;
  p.f_head = head_of(f.hi);
  p.f_tail = f.hi - p.f_head;
  p.f_lo = f.lo;
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

// The polynomial with its first coefficient taken out, where the scale of the whole series' first coefficient
// will take its place. The polynomial's lacks `next`: returns what the scale is to be corrected by, relative
// to it.
double set_relative(double (&to)[kernels::series_terms], const Series& c, double next)
{
  for(std::size_t j = 0; j < kernels::series_terms; ++j)
    to[j] = c[j + 1] / c[0];
  return -next / c[0];
}

// Swinging: Φ = 8√q Σ qⁿ/((2n+1)(1 + q²ⁿ⁺¹)) sin (2n+1)z, and its derivative with z counted from rest, where
// the signs alternate; sin (2n+1)z = sin z fₙ with f₋₁ = −1 and, at z = 0, fₙ = 2n+1.
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

// The cofactor of kernels.cpp, for the constants in front.
Twofold cofactor(double q, double x, double y)
{
  const double three = 1 + x * (1 + x);
  const double five = 1 + x * (1 + x * three);
  const double seven = 1 + x * (1 + x * five);
  const double q2 = q * q;
  return sum_of(1, y * (three + y * q2 * (five + y * q2 * q2 * seven)));
}

void same_length(std::span<const double> in, std::span<double> out)
{
  if(in.size() != out.size())
    throw std::invalid_argument("swing: the arrays differ in length");
}

// The dual nome of K/K' with the modulus k, its complement kc and M(1, kc). Returns the quotient of the theta
// functions at the bottom, of which one factor is 1 − q' or 1 + q'.
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
    p.reach = 0.25;
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

}  // namespace

Motion::Motion(Amplitude a, Start start)
{
  const To_nearest whatever_was_set;
  course_ = prepare(prepared_, a, start);
}

Motion Motion::revolving(double excess)
{
  if(!(excess > 0 && excess <= 1e300))
    throw std::domain_error("swing: the excess of energy must be positive and at most 1e300");
  const To_nearest whatever_was_set;
  Motion m;
  m.course_ = prepare(m.prepared_, excess);
  return m;
}

double Motion::angle(double t) const
{
  double result;
  run(kernels::variant(0).motion[course_].angle, prepared_, &t, &result, 1);
  return result;
}

double Motion::velocity(double t) const
{
  double result;
  run(kernels::variant(0).motion[course_].velocity, prepared_, &t, &result, 1);
  return result;
}

double Motion::angle_from_top(double t) const
{
  double result;
  run(kernels::variant(0).motion[course_].from_top, prepared_, &t, &result, 1);
  return result;
}

void Motion::angle(std::span<const double> t, std::span<double> out) const
{
  same_length(t, out);
  run(kernels::best().motion[course_].angle, prepared_, t.data(), out.data(), t.size());
}

void Motion::velocity(std::span<const double> t, std::span<double> out) const
{
  same_length(t, out);
  run(kernels::best().motion[course_].velocity, prepared_, t.data(), out.data(), t.size());
}

void Motion::angle_from_top(std::span<const double> t, std::span<double> out) const
{
  same_length(t, out);
  run(kernels::best().motion[course_].from_top, prepared_, t.data(), out.data(), t.size());
}

double Motion::period() const
{
  if(prepared_.reach < 1)
    return std::numeric_limits<double>::infinity();
  return (course_ == kernels::fast || course_ == kernels::barely ? 1 : 2) / prepared_.f_hi;
}

}  // namespace swing
