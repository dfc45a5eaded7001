/// @file
/// The balance with shears once more, built of links as a child would build it, to judge hung.hpp: nothing is taken from
/// the equations there.
///
/// A body's place is a sum of links l(sin(q + δ), cos(q + δ)), to the side of A and down, q being φ, ω, η or ϑ and δ a
/// number of right angles. From these sums alone come masses and forces: Newton's law, summed over the bodies.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>

#include "balance/hung.hpp"
#include "exact/fifty.hpp"

/// The balance built of links.
namespace balance::links
{

/// Four angles φ, ω, η, ϑ, and their rates.
template <class Number>
struct Place
{
  std::array<Number, 4> q{};  ///< radians
  std::array<Number, 4> v{};  ///< radians a second
};

/// What is told of a state, in this form.
inline Place<double> place(const Full_state& s)
{
  return {{s.at.phi, s.at.omega, s.at.eta, s.at.theta},
          {s.rate.phi, s.rate.omega, s.rate.eta, s.rate.theta}};
}

/// Masses | forces: four equations for four accelerations.
template <class Number>
using Equations = std::array<std::array<Number, 5>, 4>;

/// Gauss' and Jordan's elimination: what is left has the pivots, and nothing else beside the forces. No pivot is looked for.
template <class Number>
Equations<Number> eliminated(Equations<Number> m)
{
  for(std::size_t i{0}; i < 4; ++i)
    for(std::size_t r{0}; r < 4; ++r)
      if(r != i)
      {
        const Number by = m[r][i] / m[i][i];
        for(std::size_t k = i; k < 5; ++k)
          m[r][k] -= by * m[i][k];
      }
  return m;
}

/// The accelerations. The masses are positive definite, so that no pivot need be looked for.
template <class Number>
std::array<Number, 4> solved(const Equations<Number>& given)
{
  const Equations<Number> m = eliminated(given);
  return {m[0][4] / m[0][0], m[1][4] / m[1][1], m[2][4] / m[2][2], m[3][4] / m[3][3]};
}

/// The balance, in any consistent units.
template <class Number>
struct Built
{
  Number h;             ///< the shears
  Number a;             ///< half the beam
  Number b;             ///< P's string
  Number b1;            ///< Q's
  Number c;             ///< how far G lies below C
  Number kk;            ///< radius of gyration about G, squared
  Number L;             ///< weight of a pan
  Number M;             ///< weight of the beam
  Number G;             ///< 2g
  Number e{};           ///< how far A and B lie below C
  bool movable = true;  ///< false: C is fixed

  /// A link.
  struct Link
  {
    std::size_t k;  ///< which of the angles turns it
    Number l;       ///< its length
    int quarter;    ///< δ in right angles
  };

  /// What leads from O to P, to Q and to G.
  std::array<std::array<Link, 4>, 3> bodies() const
  {
    const Link shears{0, h, 0}, none{0, 0, 0};
    return {{{{shears, {1, a, 1}, {1, e, 0}, {2, b, 0}}},
             {{shears, {1, a, -1}, {1, e, 0}, {3, b1, 0}}},
             {{shears, {1, c, 0}, none, none}}}};
  }

  /// Their weights.
  std::array<Number, 3> weights() const { return {L, L, M}; }

  /// Newton's law for the bodies, link by link.
  Equations<Number> equations(const Place<Number>& at) const
  {
    using std::cos;
    using std::sin;
    Equations<Number> all{};
    const auto weight = weights();
    const auto made_of = bodies();
    std::array<Number, 4> s, c;  // the angles' sines and cosines; of differences, by the addition theorem
    for(std::size_t k{0}; k < 4; ++k)
    {
      s[k] = sin(at.q[k]);
      c[k] = cos(at.q[k]);
    }
    for(std::size_t body{0}; body < 3; ++body)
      for(const Link& i : made_of[body])
      {
        const Number across = i.quarter == 0 ? s[i.k] : Number(i.quarter) * c[i.k];
        all[i.k][4] -= weight[body] * i.l * G * across;
        for(const Link& j : made_of[body])
        {
          const Number sine = s[j.k] * c[i.k] - c[j.k] * s[i.k], cosine = c[j.k] * c[i.k] + s[j.k] * s[i.k];
          const Number both = weight[body] * i.l * j.l;
          const int quarter = j.quarter - i.quarter;  // of the difference, from −2 to 2
          const bool even = quarter % 2 == 0;
          const Number turn = even ? 1 - std::abs(quarter) : quarter;
          all[i.k][j.k] += both * (even ? Number(turn * cosine) : Number(-turn * sine));
          all[i.k][4] +=
              both * (even ? Number(turn * sine) : Number(turn * cosine)) * at.v[j.k] * at.v[j.k];
        }
      }
    all[1][1] += M * kk;
    if(!movable)
    {
      for(std::size_t k{0}; k < 4; ++k)
        all[0][k] = all[k][0] = 0;
      all[0][0] = 1;
      all[0][4] = 0;
    }
    return all;
  }

  /// The accelerations of the four angles.
  std::array<Number, 4> accelerations(const Place<Number>& at) const { return solved(equations(at)); }

  /// By how much the force on each angle grows with it, at rest and all hanging straight down.
  std::array<Number, 4> stiffness() const
  {
    std::array<Number, 4> all{};
    const auto weight = weights();
    const auto made_of = bodies();
    for(std::size_t body{0}; body < 3; ++body)
      for(const Link& i : made_of[body])
        if(i.quarter == 0)
          all[i.k] += weight[body] * i.l * G;
    return all;
  }

  /// Living force and what the weights were lifted, in weight times length.
  Number energy(const Place<Number>& at) const
  {
    using std::sin;
    const auto m = equations(at);
    const auto stiff = stiffness();
    Number sum = 0;
    for(std::size_t i{0}; i < 4; ++i)
    {
      const Number half = sin(at.q[i] / 2);
      sum += 2 * stiff[i] * half * half / G;
      for(std::size_t k{0}; k < 4; ++k)
        sum += at.v[i] * m[i][k] * at.v[k] / (2 * G);
    }
    return sum;
  }

  /// Whose the energy is, in parts of all: a pan's own is reckoned as if its string hung from a fixed point.
  Energies shares(const Place<Number>& at) const
  {
    using std::cos;
    const Number all = energy(at);
    const auto own = [&](const Number& string, std::size_t pan) {
      return L * string * (string * at.v[pan] * at.v[pan] / (2 * G) + 1 - cos(at.q[pan])) / all;
    };
    const Number P = own(b, 2), Q = own(b1, 3);
    return {P, Q, 1 - P - Q};
  }
};

/// A balance of hung.hpp, built so.
inline Built<double> built(const Suspended& s)
{
  const Instrument& x = s.beam;
  return {s.h, x.a, x.b, x.b, x.c, x.kk, x.L, x.M, 2 * x.g, s.e, s.movable};
}

/// Where it is after the time `until`, by the classical rule in equal steps, whose error falls as steps⁻⁴.
Place<double> runge_kutta(const Built<double>& of, Place<double> now, double until, int steps);

/// The same by two sets of steps, 40 and 80 to a turn of the fastest mode, and what they tell of the limit: in motions of
/// some hundred turns the error is below 1e-9.
Place<double> followed(const Suspended& s, const Full_state& from, double until);

/// Small motions at the time t: the masses are those at rest, the forces as the angles; the power series of the time is
/// summed in fifty digits, in `parts` equal steps, each of four turns of the fastest mode's angle at most.
Place<exact::Fifty> small_motion(const Built<exact::Fifty>& of, Place<exact::Fifty> now,
                                 const exact::Fifty& t, int parts);

/// The most that ϑ can have of η in small motions, η being let go alone (handed_on() of hung.hpp), in some twenty digits:
/// the residues of ϑ's answer at the four frequencies, signs left aside. Precondition: none topples, no two agree
exact::Fifty handed_on(const Built<exact::Fifty>& of);

}  // namespace balance::links
