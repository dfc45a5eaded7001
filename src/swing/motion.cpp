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

Twofold half(Twofold x) { return {0.5 * x.hi, 0.5 * x.lo}; }

void set_frequency(Prepared& p, Twofold f)
{
  p.f_hi = f.hi;
  p.f_head = head_of(f.hi);
  p.f_tail = f.hi - p.f_head;
  p.f_lo = f.lo;
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

// θ₁ = 2q^¼ sin z · N(sin² z) and θ₃ = D(sin² z).
void set_theta_polynomials(Prepared& p, double q)
{
  const double q2 = q * q;
  const double q4 = q2 * q2;
  const double q6 = q4 * q2;
  const double q9 = q4 * q4 * q;
  p.n[0] = 1 - 3 * q2 + 5 * q6;
  p.n[1] = 4 * q2 - 20 * q6;
  p.n[2] = 16 * q6;
  p.d[0] = 1 + 2 * (q + q4 + q9);
  p.d[1] = -4 * (q + 4 * q4 + 9 * q9);
  p.d[2] = 16 * (q4 + 6 * q9);
  p.d[3] = -64 * q9;
}

// The cofactor of kernels.cpp, for the constants in front.
double cofactor(double q, double x, double y)
{
  const double three = 1 + x * (1 + x);
  const double five = 1 + x * (1 + x * three);
  const double seven = 1 + x * (1 + x * five);
  const double q2 = q * q;
  return 1 + y * (three + y * q2 * (five + y * q2 * q2 * seven));
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
    p.log_q = 0x1p500;
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
    const double scale = (k / kc).hi * ((p.d[0] + p.d[1] + p.d[2] + p.d[3]) / (p.n[0] + p.n[1] + p.n[2]));
    for (double& n : p.n)
      n *= scale;
    p.velocity_scale = 2 * kc.hi;
  }
  else
  {
    course_ = from_rest ? kernels::high_from_rest : kernels::high;
    const Nome nome = nome_of(kc.hi, k.hi);
    p.root_q = kc.hi * nome.root_over_modulus;
    p.q = p.root_q * p.root_q;
    p.log_q = pi_hi * (agm_of_one_and(k) / mean).hi;
    const double at_bottom = cofactor(p.q, -1, p.q * p.q) / ((1 - p.q) * cofactor(p.q, p.q, -p.q));
    p.angle_scale = 2 * k.hi * nome.root_over_modulus * at_bottom;
    p.velocity_scale = 4 * k.hi * at_bottom;
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
    p.log_q = pi_hi * (agm_of_one_and(kappa) / mean).hi;
    const double at_bottom = cofactor(p.q, -1, p.q * p.q) / ((1 + p.q) * cofactor(p.q, -p.q, p.q));
    p.angle_scale = 0.5 / at_bottom;
    p.velocity_scale = 4 * inverse.hi * at_bottom;
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
