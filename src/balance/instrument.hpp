/// @file
/// Balances as a maker gives them: lengths, times, the named instruments of the chapter; Newton's five equations.
#pragma once

#include <array>

#include "balance/balance.hpp"

namespace balance
{

/// E35 realised: with it λ = 1, μ = 3, i = ¼, ρ = ¼ exactly (§35). English feet.
inline constexpr Instrument instrument_of_35{16. / 9, 32. / 9, 8. / 81, 10304. / 6561, 1, 4, 16};
/// Arms and strings of two feet, pans half a weight each.
inline constexpr Instrument light_pans{2, 2, 0.1, 4. / 3, 0.5, 2, 16};
/// The same with pans of a weight each: that of §37, to be lowered at A and B.
inline constexpr Instrument heavy_pans{2, 2, 0.1, 4. / 3, 1, 2, 16};

/// Lengths, times and numbers of a balance (§§14–16, 22, 33).
struct Quantities
{
  double
      f;  ///< M(kk+cc+2Laa/M)/(Mc), the pendulum that keeps time with the beam; ±∞ where too great, ∞ for c = 0
  double lambda;     ///< √(2g/f), 1/s; NaN for c < 0
  double kappa;      ///< √(−2g/f), the rate at which a beam topples that has c < 0, 1/s; NaN for c > 0
  double mu;         ///< √(2g/b), 1/s
  double beam_time;  ///< π/λ, one oscillation of the beam in seconds, half of today's period; NaN for c < 0
  double pan_time;  ///< π/μ, one of a pan
  double i;         ///< λμμa/4g = aλ/2b, 1/s (§33); NaN for c < 0
  double beta;      ///< a/b
  double rho;       ///< Laa/I
};

/// Each to 1e-15 relatively, f and λ also where c is so small that f overflows or λ² underflows.
/// @throws std::domain_error as numbers_of() does
Quantities quantities_of(const Instrument& instrument);

/// The four numbers in fifty digits, for exactly the doubles given. @throws std::domain_error as numbers_of() does
Balance<exact::Fifty> widened(const Instrument& instrument);

/// A state in fifty digits, for exactly the doubles given.
inline State<exact::Fifty> widened(const State<>& now)
{
  const auto& [at, rate] = now;
  return {{at.omega, at.eta, at.theta}, {rate.omega, rate.eta, rate.theta}};
}

/// The c for which f is least, and that f, 2c: c = √(kk + 2Laa/M) (§14).
struct Least
{
  double c;  ///< how far G must lie below C
  double f;  ///< 2c
};

/// Whatever the instrument's own c is. @throws std::domain_error as numbers_of() does
Least least_f(const Instrument& instrument);

/// The coefficient λμμa/(4g(2μ−λ)) of §§25–30, i/(2μ − λ), which vanishes with c. NaN for c < 0.
double slower_coefficient(const Quantities& q);

/// The inclination at which the beam rests under an overweight in one pan (§2): tan ω = overweight·a/Mc; from 0 to ½π.
/// @throws std::domain_error unless c ≥ 0 and the overweight is positive and finite, and as numbers_of() does
double tilt(const Instrument& instrument, double overweight);

/// The places of the pans (§6): x, y of P and x′, y′ of Q, each outward and downward from C, in the unit of a and b.
template <class Number = double>
struct Places
{
  Number x;   ///< Cp
  Number y;   ///< pP
  Number x1;  ///< Cq
  Number y1;  ///< qQ
};

// [places]
/// The four coordinates by the angles (§6).
template <class Number>
Places<Number> places(const Number& a, const Number& b, const Angles<Number>& at)
{
  using elementary::cos;
  using elementary::sin;
  return {a * cos(at.omega) + b * sin(at.eta), b * cos(at.eta) - a * sin(at.omega),
          a * cos(at.omega) - b * sin(at.theta), b * cos(at.theta) + a * sin(at.omega)};
}
// [places]

/// The second derivatives of the four coordinates, in the unit of a and b per s², where the angles have the
/// accelerations `to`, whatever these come from.
template <class Number>
Places<Number> place_accelerations(const Number& a, const Number& b, const State<Number>& now,
                                   const Angles<Number>& to)
{
  using elementary::cos;
  using elementary::sin;
  const auto& [at, rate] = now;
  const auto across = [](const Number& angle, const Number& speed,
                         const Number& acceleration) {  // of the sine
    return Number(acceleration * cos(angle) - speed * speed * sin(angle));
  };
  const auto along = [](const Number& angle, const Number& speed,
                        const Number& acceleration) {  // of the cosine
    return Number(-acceleration * sin(angle) - speed * speed * cos(angle));
  };
  const Number up = a * across(at.omega, rate.omega, to.omega),
               out = a * along(at.omega, rate.omega, to.omega);
  return {out + b * across(at.eta, rate.eta, to.eta), b * along(at.eta, rate.eta, to.eta) - up,
          out - b * across(at.theta, rate.theta, to.theta), b * along(at.theta, rate.theta, to.theta) + up};
}

/// The pulls of the strings AP and BQ, in weights of a pan.
template <class Number = double>
struct Tensions
{
  Number P;  ///< P/L
  Number Q;  ///< Q/L
};

// [tensions]
/// The tensions from the state, exactly: what is left of the pan's weight along the string, the pan's
/// turning, and what the string's upper end adds. Source: I–IV of §§7–8 resolved along the strings.
template <class Number>
Tensions<Number> tensions(const Balance<Number>& b, const State<Number>& now)
{
  using elementary::cos;
  using elementary::sin;
  const auto& [at, rate] = now;
  const Number omega = accelerations(b, now).omega, square = rate.omega * rate.omega;
  const Number s1 = sin(at.omega - at.eta), c1 = cos(at.omega - at.eta);
  const Number s2 = sin(at.omega - at.theta), c2 = cos(at.omega - at.theta);
  return {cos(at.eta) + (rate.eta * rate.eta + b.beta * (omega * c1 - square * s1)) / b.mu2,
          cos(at.theta) + (rate.theta * rate.theta - b.beta * (omega * c2 - square * s2)) / b.mu2};
}
// [tensions]

/// The tensions to the first order of the angles (§12): 1 ± (a/2g)ω̈ with ω̈ = −λ²ω.
template <class Number>
Tensions<Number> first_order_tensions(const Balance<Number>& b, const Angles<Number>& at)
{
  const Number pull = -b.beta * b.lambda2 * at.omega / b.mu2;
  return {1 + pull, 1 - pull};
}

/// What the five equations say of a state (§§7–9).
struct Five
{
  Angles<> acceleration;  ///< ω̈, η̈, ϑ̈
  Tensions<> tension;     ///< P/L, Q/L
};

/// Euler's five equations I–V with their five unknowns, solved together as they stand (by Gauss' elimination with
/// pivots), without the Lagrangian. In fifty digits: of light beams the acceleration is a small difference of great
/// moments. Each unknown is right to an ulp for exactly the doubles given.
/// @throws std::domain_error as numbers_of() does, for L = 0, and where the state is not finite
Five five_equations(const Instrument& instrument, const State<>& now);

// [orders]
/// The accelerations by the equations of §13 and §15, which keep ηω but not all of its order:
/// η̈ = −μ²η − βηω̈.
template <class Number>
Angles<Number> euler_accelerations(const Balance<Number>& b, const Angles<Number>& at)
{
  const Number omega = -b.lambda2 * at.omega;
  return {omega, -b.mu2 * at.eta - b.beta * at.eta * omega, -b.mu2 * at.theta + b.beta * at.theta * omega};
}

/// The accelerations complete to the second order: (½ω²)″ is ω̇² + ωω̈, and what is of the second order
/// is formed with the accelerations of the first.
template <class Number>
Angles<Number> second_order_accelerations(const Balance<Number>& b, const State<Number>& now)
{
  const auto& [at, rate] = now;
  const Angles<Number> first{-b.lambda2 * at.omega, -b.mu2 * at.eta, -b.mu2 * at.theta};
  const auto half_square = [](const Number& x, const Number& v, const Number& a) { return v * v + x * a; };
  const Number arc = b.beta * half_square(at.omega, rate.omega, first.omega);
  const Number pulled =
      half_square(at.eta, rate.eta, first.eta) - half_square(at.theta, rate.theta, first.theta);
  return {first.omega + b.rho / b.beta * (at.omega * (first.eta - first.theta) - pulled),
          first.eta - b.beta * at.eta * first.omega + arc,
          first.theta + b.beta * at.theta * first.omega - arc};
}
// [orders]

}  // namespace balance
