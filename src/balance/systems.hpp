/// @file
/// The equations that are integrated, as collocation/motion.hpp wants them: for one number, or for eight at once.
#pragma once

#include "balance/chart.hpp"
#include "collocation/motion.hpp"

namespace balance::systems
{

/// The balance with C fixed and A, B in line with it, in its four numbers (balance.hpp): ω, η, ϑ.
struct Fixed
{
  static constexpr unsigned freedoms = 3;  ///< ω, η, ϑ
  static constexpr unsigned angles = 3;    ///< all
  double lambda2;                          ///< λ²
  double mu2;                              ///< μ²
  double beta;                             ///< a/b
  double rho;                              ///< Laa/I

  /// See balance::accelerations(); the sines of the differences by the addition theorem.
  template <class Of, class Real>
  ELEMENTARY_INLINE static void accelerations(const Of& of, const Real&, const Real*,
                                              const elementary::SineCosine<Real>* turned, const Real* v,
                                              Real* a)
  {
    const auto [so, co] = turned[0];
    const auto [se, ce] = turned[1];
    const auto [st, ct] = turned[2];
    const Real s1 = so * ce - co * se, c1 = co * ce + so * se;
    const Real s2 = so * ct - co * st, c2 = co * ct + so * st;
    const Real beta(of.beta), mu2(of.mu2);
    const Real centripetal = beta * v[0] * v[0];
    const Real eta = centripetal * c1 - mu2 * se;
    const Real theta = -(mu2 * st) - centripetal * c2;
    const Real pull =
        (s1 * eta - s2 * theta) + (c2 * v[2] * v[2] - c1 * v[1] * v[1]);  // 0 where η = ϑ, ω = 0
    const Real free = Real(of.rho / of.beta) * pull - Real(of.lambda2) * so;
    const Real omega = free / (Real(1.0) - Real(of.rho) * (s1 * s1 + s2 * s2));
    a[0] = omega;
    a[1] = eta + beta * omega * s1;
    a[2] = theta - beta * omega * s2;
  }
};

/// The balance in full: C hangs from a fixed O by shears of the length h, A and B lie lower than C by e: φ, ω, η, ϑ.
/// Or with C fixed, when φ does not move.
struct Hung
{
  static constexpr unsigned freedoms = 4;  ///< φ, ω, η, ϑ
  static constexpr unsigned angles = 4;    ///< all
  double gravity;                          ///< 2g
  double arm;                              ///< a
  double string;                           ///< b
  double beam;                             ///< c
  double lower;                            ///< e
  double shears;                           ///< h
  double inertia;                          ///< kk + cc
  double pan;                              ///< L/M
  double movable;                          ///< 1, or 0 where C is fixed

  /// The equations of Euler and Lagrange, divided by M, with η̈ and ϑ̈ eliminated: two equations remain for hφ̈ and ω̈,
  /// whose coefficients are sums of squares.
  template <class Of, class Real>
  ELEMENTARY_INLINE static void accelerations(const Of& of, const Real&, const Real*,
                                              const elementary::SineCosine<Real>* turned, const Real* v,
                                              Real* acc)
  {
    const auto [sf, cf] = turned[0];
    const auto [so, co] = turned[1];
    const auto [se, ce] = turned[2];
    const auto [st, ct] = turned[3];
    const Real G(of.gravity), a(of.arm), b(of.string), e(of.lower), h(of.shears), ell(of.pan);
    const Real weight = Real(of.beam) + Real(2.0) * ell * e;  // (Mc + 2Le)/M
    // of the differences φ−ω, φ−η, φ−ϑ, ω−η, ω−ϑ
    const Real s_fo = sf * co - cf * so, c_fo = cf * co + sf * so;
    const Real s_fe = sf * ce - cf * se, c_fe = cf * ce + sf * se;
    const Real s_ft = sf * ct - cf * st, c_ft = cf * ct + sf * st;
    const Real s_oe = so * ce - co * se, c_oe = co * ce + so * se;
    const Real s_ot = so * ct - co * st, c_ot = co * ct + so * st;
    // how A and B move across and along their strings when the beam turns
    const Real across_A = e * c_oe - a * s_oe, along_A = -(e * s_oe) - a * c_oe;
    const Real across_B = e * c_ot + a * s_ot, along_B = a * c_ot - e * s_ot;
    const Real f2 = v[0] * v[0], o2 = v[1] * v[1], e2 = b * v[2] * v[2], t2 = b * v[3] * v[3];
    // −bη̈ and −bϑ̈, were φ and ω to move uniformly
    const Real pull_A = (G * se + along_A * o2) - h * s_fe * f2;
    const Real pull_B = (G * st + along_B * o2) - h * s_ft * f2;
    const Real of_shears = Real(1.0) + ell * (s_fe * s_fe + s_ft * s_ft);
    const Real of_both = weight * c_fo - ell * (c_fe * across_A + c_ft * across_B);
    const Real of_beam = Real(of.inertia) + ell * (along_A * along_A + along_B * along_B);
    const Real on_shears = ell * (((c_fe * pull_A - s_fe * e2) + c_ft * pull_B) - s_ft * t2)
                           - (weight * s_fo * o2 + (Real(1.0) + Real(2.0) * ell) * G * sf);
    const Real on_beam = ell * ((along_A * e2 + along_B * t2) + (across_A * pull_A + across_B * pull_B))
                         + weight * (h * s_fo * f2 - G * so);
    const Real cross = Real(of.movable) * of_both;
    const Real determinant = of_shears * of_beam - cross * cross;
    const Real across = Real(of.movable) * (on_shears * of_beam - on_beam * of_both) / determinant;  // hφ̈
    const Real omega = (on_beam * of_shears - on_shears * cross) / determinant;
    acc[0] = across / h;
    acc[1] = omega;
    acc[2] = -((pull_A + c_fe * across) + across_A * omega) / b;
    acc[3] = -((pull_B + c_ft * across) + across_B * omega) / b;
  }
};

/// A pan under a beam that swings with ω = m cos λt, whatever the pan does (§15), and the same with the opposite start:
/// two solutions of y″ = −(μ² − (am/b)λ² cos λt) y at once.
struct Prescribed
{
  static constexpr unsigned freedoms = 2;  ///< the two solutions
  double mu2;                              ///< μ²
  double lambda;                           ///< λ
  double strength;                         ///< (am/b)λ²

  /// What the time alone makes of the weight: the stiffness.
  template <class Of, class Real>
  ELEMENTARY_INLINE static Real driven(const Of& of, const Real& t)
  {
    return Real(of.strength) * sincos(Real(of.lambda) * t).cosine - Real(of.mu2);
  }

  /// The equation, which is linear.
  template <class Of, class Real>
  ELEMENTARY_INLINE static void accelerations(const Of&, const Real& stiffness, const Real* x, const Real*,
                                              Real* a)
  {
    a[0] = stiffness * x[0];
    a[1] = stiffness * x[1];
  }
};

/// The functions that carry these motions on and make the chart, for one instruction set.
struct Kernels
{
  const char* name;                               ///< "sse2", "avx2", "avx512", or "portable"
  collocation::Engine<Fixed, 1> fixed;            ///< one balance with C fixed
  collocation::Engine<Fixed, 8> fixed_together;   ///< eight of them with different starts
  collocation::Engine<Hung, 1> hung;              ///< one in full
  collocation::Engine<Prescribed, 1> prescribed;  ///< one pan
  /// A point of the stability chart, and `count` of them.
  /// @{
  void (*halves_of_one)(double a, double q, Halves& result);
  void (*halves_of_many)(const double* a, const double* q, Halves* result, std::size_t count);
  /// @}
};

/// How many this processor can run, from the plainest to the widest; at least one.
std::size_t count();

/// Number i < count().
const Kernels& kernels(std::size_t i);

/// The widest.
const Kernels& best();

}  // namespace balance::systems
