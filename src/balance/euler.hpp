/// @file
/// Euler's approximate solution: with general phases (§§15–20), let go from rest (§§24–35), toppling (§21), and beside
/// it what is complete to the second order.
///
/// Everything is a template, the same for doubles and for fifty digits. Errors of the doubles: a few units of the last
/// place of the greatest term, whatever the phases (below 2⁵³) and however near a resonance; tests/balance_euler.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "balance/motion.hpp"
#include "balance/phase.hpp"

namespace balance
{

/// i = λμμa/4g (§33), in 1/s; a in the unit of g.
template <class Number>
Number i_of(const Number& lambda, const Number& mu, const Number& a, const Number& g)
{
  return lambda * mu * mu * a / (4 * g);
}

// [release]
/// A balance let go from rest, in the letters of §33, and the one number more that the exact equations need.
template <class Number>
struct ReleaseOf
{
  Number lambda;      ///< the beam's frequency, √(2g/f), in 1/s
  Number mu;          ///< a pan's frequency, √(2g/b), in 1/s
  Number i;           ///< λμμa/4g, in 1/s
  Angles<Number> at;  ///< the inclinations m, n, n′ of beam and pans at the start
  Number rho;         ///< Laa/I, which Euler's formulae do not contain
};
// [release]
using Release = ReleaseOf<double>;  ///< the same in doubles

/// Euler's example (§35): λ = 1, μ = 3, i = ¼, and a sixth of the radius for each angle. ρ is not his.
inline constexpr Release example_of_35{1, 3, 0.25, {1. / 6, 1. / 6, 1. / 6}, 0.25};

/// The same in fifty digits, for exactly the doubles given.
inline ReleaseOf<exact::Fifty> widened(const Release& r)
{
  return {r.lambda, r.mu, r.i, {r.at.omega, r.at.eta, r.at.theta}, r.rho};
}

/// The numbers of the balance: since i = λμμa/4g = λa/2b, the arm is to the string as 2i to λ.
template <class Number>
Balance<Number> balance_of(const ReleaseOf<Number>& r)
{
  return {r.lambda * r.lambda, r.mu * r.mu, 2 * r.i / r.lambda, r.rho};
}

// [constants]
/// The six constants of the general solution (§19), and the amplitudes that follow (§17).
template <class Number = double>
struct Constants
{
  Number A;      ///< 𝔄, of η
  Number B;      ///< 𝔅, of ϑ
  Number C;      ///< ℭ, of ω
  Number alpha;  ///< the phase of η at t = 0
  Number beta;   ///< that of ϑ
  Number gamma;  ///< that of ω
};
// [constants]

/// M and N of §17: twice the amplitudes at the frequencies μ − λ and μ + λ. Not the weight.
template <class Number>
struct Sidebands
{
  Number M;  ///< μμa𝔄ℭ/(λ(2μ−λ)f) = 2i𝔄ℭ/(2μ − λ)
  Number N;  ///< μμa𝔄ℭ/(λ(2μ+λ)f) = 2i𝔄ℭ/(2μ + λ)
};

/// M and N by i, which vanishes with λ, where λ and f alone would give 0·∞. Infinite at λ = 2μ.
template <class Number>
Sidebands<Number> sidebands(const Number& lambda, const Number& mu, const Number& i,
                            const Number& amplitude, const Number& beam)
{
  const Number twice = 2 * i * amplitude * beam;
  return {twice / (2 * mu - lambda), twice / (2 * mu + lambda)};
}

// [general]
/// Beam and pans by Euler's approximate solution with general phases, and their rates (§§17, 18, 20).
/// λ ≠ 2μ.
template <class Number>
State<Number> general(const Number& lambda, const Number& mu, const Number& i, const Constants<Number>& k,
                      const Number& t)
{
  const Rate<Number> slow = together(mu, -lambda), fast = together(mu, lambda);
  State<Number> now;
  const auto pan = [&](const Number& amplitude, const Number& from, int side, Number& at, Number& rate) {
    const auto [M, N] = sidebands(lambda, mu, i, amplitude, k.C);
    const auto alone = phase(Rate<Number>{mu}, t, from);
    const auto lower = phase(slow, t, from - k.gamma), upper = phase(fast, t, from + k.gamma);
    at = amplitude * alone.sine + side * (M * lower.cosine + N * upper.cosine) / 2;
    rate = amplitude * mu * alone.cosine
           - side * (M * slow.value * lower.sine + N * fast.value * upper.sine) / 2;
  };
  pan(k.A, k.alpha, 1, now.at.eta, now.rate.eta);
  pan(k.B, k.beta, -1, now.at.theta, now.rate.theta);
  const auto beam = phase(Rate<Number>{lambda}, t, k.gamma);
  now.at.omega = k.C * beam.sine;
  now.rate.omega = k.C * lambda * beam.cosine;
  return now;
}
// [general]

/// What §19 asks for: the constants from the state at t = 0.
struct Found
{
  Constants<> constants;  ///< amplitudes not negative, phases from −π to π
  double
      of_P;  ///< determinant of the two equations for 𝔄 sin α and 𝔄 cos α, 1/s; at 0 there is no solution
  double of_Q;  ///< of those for 𝔅 sin β and 𝔅 cos β
};

/// The constants of the general solution that starts so. @throws std::domain_error unless λ, μ > 0, λ ≠ 2μ, i ≥ 0, all
/// is finite, and neither determinant vanishes
Found constants_of(double lambda, double mu, double i, const State<>& start);

// [K]
/// K = λλμμam/(2g(4μμ − λλ)) = 2iλm/(4μμ − λλ) (§26), to a few roundings. Infinite at λ = 2μ.
template <class Number>
Number K_of(const Number& lambda, const Number& mu, const Number& a, const Number& g, const Number& m)
{
  const Number divisor = (2 * mu - lambda) * (2 * mu + lambda);
  return lambda * lambda * mu * mu * a * m / (2 * g * divisor);
}
// [K]

/// K of §26, and 1 ± K, each to a few ulps however near K is to ±1.
struct Factors
{
  double K;          ///< what divides the amplitudes of §§30, 32
  double one_plus;   ///< 1 + K
  double one_minus;  ///< 1 − K
};

/// For exactly these doubles. @throws std::domain_error unless λ, μ, g > 0, a ≥ 0, λ ≠ 2μ and all is finite
Factors factors(double lambda, double mu, double a, double g, double m);

/// The λ at which K = 1, 2μ/√(1 + am/b), with am/b = μμam/2g; with −m, where K = −1 (infinite for am/b = 1, NaN beyond).
double lambda_where_K_is_one(double mu, double a, double g, double m);

// [euler]
/// Beam and pans at the time t by Euler's formulae (§33), which are not exact. Precondition: λ ≠ 2μ.
template <class Number>
Angles<Number> euler(const ReleaseOf<Number>& r, const Number& t)
{
  const auto& [m, n, n1] = r.at;
  const Number slower = phase(together(r.mu, -r.lambda), t).cosine / (2 * r.mu - r.lambda);
  const Number faster = phase(together(r.mu, r.lambda), t).cosine / (2 * r.mu + r.lambda);
  const Number strays = r.i * m * (slower - faster);
  const Number alone = phase(Rate<Number>{r.mu}, t).cosine;
  return {m * phase(Rate<Number>{r.lambda}, t).cosine, n * (alone + strays), n1 * (alone - strays)};
}
// [euler]

/// The rates of euler() (§33).
template <class Number>
Angles<Number> euler_rates(const ReleaseOf<Number>& r, const Number& t)
{
  const auto& [m, n, n1] = r.at;
  const Rate<Number> slow = together(r.mu, -r.lambda), fast = together(r.mu, r.lambda);
  const Number slower = slow.value * phase(slow, t).sine / (2 * r.mu - r.lambda);
  const Number faster = fast.value * phase(fast, t).sine / (2 * r.mu + r.lambda);
  const Number strays = r.i * m * (slower - faster);
  const Number alone = r.mu * phase(Rate<Number>{r.mu}, t).sine;
  return {-r.lambda * m * phase(Rate<Number>{r.lambda}, t).sine, -n * (alone + strays),
          -n1 * (alone - strays)};
}

/// The same K by the letters of §33.
template <class Number>
Number K_of(const ReleaseOf<Number>& r)
{
  return 2 * r.i * r.lambda * r.at.omega / ((2 * r.mu - r.lambda) * (2 * r.mu + r.lambda));
}

/// Where euler() starts: m, n(1 + K), n′(1 − K), and not m, n, n′.
template <class Number>
Angles<Number> euler_start(const ReleaseOf<Number>& r)
{
  const Number K = K_of(r);
  return {r.at.omega, r.at.eta + r.at.eta * K, r.at.theta - r.at.theta * K};
}

/// Euler's formula with the amplitudes n/(1 + K), n′/(1 − K), so that it starts at n, n′. Finite at λ = 2μ, since all is
/// multiplied by 4μμ − λλ; infinite at K = ±1.
template <class Number>
Angles<Number> euler_corrected(const ReleaseOf<Number>& r, const Number& t)
{
  const auto& [m, n, n1] = r.at;
  const Number less = 2 * r.mu - r.lambda, more = 2 * r.mu + r.lambda;
  const Number alone = less * more * phase(Rate<Number>{r.mu}, t).cosine;
  const Number strays = r.i * m
                        * (more * phase(together(r.mu, -r.lambda), t).cosine
                           - less * phase(together(r.mu, r.lambda), t).cosine);
  const Number K = 2 * r.i * r.lambda * m;
  return {m * phase(Rate<Number>{r.lambda}, t).cosine, n * (alone + strays) / (less * more + K),
          n1 * (alone - strays) / (less * more - K)};
}

// [second]
/// The motion from rest, complete to the second order of the angles; the third is missing.
///
/// Of what it adds to n cos μt, Euler has the forced part of the product term alone: not its free part, not the term
/// of A's and B's arcs, and nothing for the beam. No divisor vanishes, neither at λ = 2μ nor at μ = 2λ.
/// Source: perturbation of the cubic Lagrangian Lab[(½ω²)″(η − ϑ) − ½ω̈(η² − ϑ²)].
template <class Number>
Angles<Number> second_order_of(const Number& lambda, const Number& mu, const Number& beta,
                               const Number& rho, const Angles<Number>& released, const Number& t)
{
  const auto& [m, n, n1] = released;
  const Rate<Number> beam{lambda}, pan{mu},
      less = together(2 * mu, -lambda), more = together(2 * mu, lambda), near = together(mu, -2 * lambda),
      beyond = together(mu, 2 * lambda);
  const Number of_pan = driven_by(less, beam, t) + driven_by(more, beam, t);   // at μ − λ and μ + λ
  const Number of_beam = driven_by(pan, near, t) + driven_by(beyond, pan, t);  // the same
  const Number product = beta * lambda * lambda * m / 2 * of_pan;              // from −βηω̈
  const Number arc = beta * lambda * lambda * m * m * driven_by(beyond, near, t);  // from β(½ω²)″
  const Number turned = mu * mu * m * (n - n1) / 2 * of_beam;                      // from ω(η̈ − ϑ̈)
  const Number pulled = mu * mu * (n * n - n1 * n1) * driven_by(more, less, t);  // from −½(η² − ϑ²)″
  const Number alone = phase(pan, t).cosine;
  return {m * phase(beam, t).cosine + rho / beta * (pulled - turned), n * alone + n * product - arc,
          n1 * alone - n1 * product + arc};
}
// [second]

/// The same in the letters of §33.
template <class Number>
Angles<Number> second_order(const ReleaseOf<Number>& r, const Number& t)
{
  return second_order_of<Number>(r.lambda, r.mu, 2 * r.i / r.lambda, r.rho, r.at, t);
}

/// A beam whose centre of gravity lies above C, κ = √(2gM|c|/I) taking λ's place as λ = κ√−1 (§21): ω = m cosh κt, and
/// Euler's formula for the pans with the amplitudes that make it start at n, n′. Real throughout.
template <class Number>
Angles<Number> toppling(const Number& kappa, const Number& mu, const Number& beta,
                        const Angles<Number>& released, const Number& t)
{
  using std::cosh;
  using std::sinh;
  const auto& [m, n, n1] = released;
  const Number both = 4 * mu * mu + kappa * kappa, x = kappa * t;
  const auto [s, c] = phase(Rate<Number>{mu}, t);
  const Number strays = beta * m * kappa * (kappa * c * cosh(x) + 2 * mu * s * sinh(x)) / both;
  const Number K = beta * m * kappa * kappa / both;  // −K of §26
  return {m * cosh(x), n * (c - strays) / (1 - K), n1 * (c + strays) / (1 + K)};
}

/// An angle in whole minutes, where `unit` radians count as `degrees` degrees: Euler has 10 for ⅙ (§36).
struct Minutes
{
  long all;  ///< rounded to the nearest, a half away from zero

  /// "−8° 40′", with a narrow space that does not break.
  std::string text() const;
};

/// The angle in minutes; the rounding is that of the number itself, however near to a half it is.
/// @throws std::domain_error unless unit and degrees are positive and all is finite and below 10¹⁵ minutes
Minutes in_minutes(const exact::Fifty& angle, const exact::Fifty& unit, double degrees);

/// A row of a table like that of §36: ω, η, ϑ at the time t by (1) of that section, in minutes.
struct Row
{
  Minutes omega;  ///< the beam
  Minutes eta;    ///< the pan P
  Minutes theta;  ///< the pan Q
};

/// For exactly the numbers given. λt is given, as Euler does, as an angle. @throws std::domain_error as in_minutes() does
Row row_of(const ReleaseOf<exact::Fifty>& r, const exact::Fifty& lambda_t, const exact::Fifty& unit,
           double degrees);

// [departure]
/// The most, in radians, that η by the full equations departs from η by a formula in one period of the
/// beam, to some four digits (720 moments are looked at). Throws as Motion does.
template <class Formula>
double departure(const Release& r, Formula eta)
{
  const double period = 2 * std::numbers::pi / r.lambda;
  const auto full = course(balance_of(r), {r.at, {}}, period, 720);
  double most = 0;
  for(std::size_t k = 0; k < full.size(); ++k)
    most = std::max(most, std::abs(full[k].at.eta - eta(r, period * static_cast<double>(k) / 720)));
  return most;
}
// [departure]

}  // namespace balance
