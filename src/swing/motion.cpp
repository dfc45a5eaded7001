#include "swing/motion.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "swing/twofold.hpp"
#include "swing_tables.hpp"

namespace swing
{
namespace
{

using kernels::Prepared;

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

void set_log_q(Prepared& p, double log_q)
{
  p.log_q = log_q;
  p.log_q_head = head_of(log_q);
  p.log_q_tail = log_q - p.log_q_head;
}

void set_scales(Prepared& p, Twofold angle, Twofold velocity)
{
  p.angle_scale = angle.hi;
  p.velocity_scale = velocity.hi;
  if (angle.hi > 0)
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

// θ₁/sin z and θ₃ as polynomials in x = (sin z / π)², without their constant factors.
void set_theta_polynomials(Prepared& p, double q)
{
  const double q2 = q * q;
  const double q4 = q2 * q2;
  const double q6 = q4 * q2;
  const double q9 = q4 * q4 * q;
  const double n0 = 1 - 3 * q2 + 5 * q6;
  const double d0 = 1 + 2 * (q + q4 + q9);
  const double x1 = pi_hi * pi_hi;
  const double x2 = x1 * x1;
  p.n[0] = (4 * q2 - 20 * q6) / n0 * x1;
  p.n[1] = 16 * q6 / n0 * x2;
  p.d[0] = -4 * (q + 4 * q4 + 9 * q9) / d0 * x1;
  p.d[1] = 16 * (q4 + 6 * q9) / d0 * x2;
  p.d[2] = -64 * q9 / d0 * x1 * x2;
  p.p[0] = p.n[0] - p.d[0];
  p.p[1] = p.n[1] - p.d[1];
  p.p[2] = -p.d[2];
}

// The quotient of the two where sin z = 1.
double theta_quotient_at_rest(const Prepared& p)
{
  const double x = 1 / (pi_hi * pi_hi);
  return 1 + x * (p.p[0] + x * (p.p[1] + x * p.p[2])) / (1 + x * (p.d[0] + x * (p.d[1] + x * p.d[2])));
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
  if (in.size() != out.size())
    throw std::invalid_argument("swing: the arrays differ in length");
}

} // namespace

Motion::Motion(Amplitude a, Start start)
{
  const bool from_rest = start == Start::rest;
  Prepared& p = prepared_;
  if (a.eta == 0)
  {
    if (from_rest)
      throw std::domain_error("swing: at rest at the top the pendulum stays there");
    course_ = kernels::high;
    set_frequency(p, {0x1p-500, 0});
    p.reach = 0.25;
    set_log_q(p, 0x1p500);
    p.angle_scale = 0.5;
    p.velocity_scale = 4;
    return;
  }
  const Twofold k = sin(half({a.zeta, a.zeta_rest}));
  const Twofold kc = sin(half({a.eta, a.eta_rest}));
  const Twofold mean = agm_of_one_and(kc);
  set_frequency(p, mean * Twofold{tables::one_over_pi_hi, tables::one_over_pi_lo});
  if (a.zeta <= a.eta)
  {
    course_ = from_rest ? kernels::low_from_rest : kernels::low;
    set_theta_polynomials(p, nome_of(k.hi, kc.hi).q);
    const Twofold scale = k * Twofold{pi_hi, pi_lo} / Twofold{theta_quotient_at_rest(p), 0};
    set_scales(p, scale / kc, scale + scale);
  }
  else
  {
    course_ = from_rest ? kernels::high_from_rest : kernels::high;
    const Nome nome = nome_of(kc.hi, k.hi);
    p.root_q = kc.hi * nome.root_over_modulus;
    p.q = p.root_q * p.root_q;
    set_log_q(p, pi_hi * (agm_of_one_and(k) / mean).hi);
    const Twofold at_bottom = cofactor(p.q, -1, p.q * p.q) / (sum_of(1, -p.q) * cofactor(p.q, p.q, -p.q));
    const Twofold scale = k * at_bottom;
    set_scales(p, scale * Twofold{2 * nome.root_over_modulus, 0}, {4 * scale.hi, 4 * scale.lo});
  }
}

// With κ² = 1/(1 + excess), Φ = 2 am(t/κ, κ); a turn takes the time 2κK(κ) = π/M(1/κ, κ'/κ).
Motion Motion::revolving(double excess)
{
  if (!(excess > 0 && excess <= 1e300))
    throw std::domain_error("swing: the excess of energy must be positive and at most 1e300");
  Motion m;
  Prepared& p = m.prepared_;
  const Twofold inverse = sqrt(sum_of(1, excess));
  const Twofold kappa = Twofold{1, 0} / inverse;
  const Twofold kappa_c = sqrt(Twofold{excess, 0}) / inverse;
  const Twofold mean = agm_of_one_and(kappa_c);
  set_frequency(p, mean * inverse * Twofold{tables::one_over_pi_hi, tables::one_over_pi_lo});
  if (excess >= 1)
  {
    m.course_ = kernels::fast;
    set_theta_polynomials(p, nome_of(kappa.hi, kappa_c.hi).q);
    p.angle_scale = 1 / std::sqrt(kappa_c.hi);
    p.velocity_scale = 2 * inverse.hi * std::sqrt(kappa_c.hi);
  }
  else
  {
    m.course_ = kernels::barely;
    const Nome nome = nome_of(kappa_c.hi, kappa.hi);
    p.root_q = kappa_c.hi * nome.root_over_modulus;
    p.q = p.root_q * p.root_q;
    set_log_q(p, pi_hi * (agm_of_one_and(kappa) / mean).hi);
    const Twofold at_bottom = cofactor(p.q, -1, p.q * p.q) / (sum_of(1, p.q) * cofactor(p.q, -p.q, p.q));
    const Twofold scale = inverse * at_bottom;
    set_scales(p, Twofold{0.5, 0} / at_bottom, {4 * scale.hi, 4 * scale.lo});
  }
  return m;
}

double Motion::angle(double t) const
{
  double result;
  kernels::variant(0).motion[course_].angle(prepared_, &t, &result, 1);
  return result;
}

double Motion::velocity(double t) const
{
  double result;
  kernels::variant(0).motion[course_].velocity(prepared_, &t, &result, 1);
  return result;
}

double Motion::angle_from_top(double t) const
{
  double result;
  kernels::variant(0).motion[course_].from_top(prepared_, &t, &result, 1);
  return result;
}

void Motion::angle(std::span<const double> t, std::span<double> out) const
{
  same_length(t, out);
  kernels::best().motion[course_].angle(prepared_, t.data(), out.data(), t.size());
}

void Motion::velocity(std::span<const double> t, std::span<double> out) const
{
  same_length(t, out);
  kernels::best().motion[course_].velocity(prepared_, t.data(), out.data(), t.size());
}

void Motion::angle_from_top(std::span<const double> t, std::span<double> out) const
{
  same_length(t, out);
  kernels::best().motion[course_].from_top(prepared_, t.data(), out.data(), t.size());
}

double Motion::period() const
{
  if (prepared_.reach < 1)
    return std::numeric_limits<double>::infinity();
  return (course_ == kernels::fast || course_ == kernels::barely ? 1 : 2) / prepared_.f_hi;
}

} // namespace swing
