/// @file
/// The small swings of the balance with shears by the cubic of §38 in fifty digits, to judge modes() and transfer() of
/// hung.hpp: nothing is taken from there.
#pragma once

#include <array>

#include "balance/links.hpp"
#include "exact/fifty.hpp"

namespace balance
{

/// Of a balance with C movable, A and B in line with it and equal strings.
struct Small_swings
{
  exact::Fifty nu2;      ///< ν², the shears', 1/s²
  exact::Fifty lambda2;  ///< λ², the beam's, 1/s²
  exact::Fifty mu2;      ///< μ², the pans', 1/s²
  exact::Fifty epsilon;  ///< 2L/(M + 2L)
  exact::Fifty kappa2;   ///< κ²
  exact::Fifty shears;   ///< h, in the unit of the lengths
  exact::Fifty strings;  ///< b, in the same unit
  exact::Fifty across;   ///< Mhc/I

  /// By the definitions; e must be 0 and both strings b.
  explicit Small_swings(const links::Built<exact::Fifty>& of)
      : nu2(of.G / of.h), mu2(of.G / of.b), shears(of.h), strings(of.b)
  {
    const exact::Fifty all = of.M + 2 * of.L, mc = of.M * of.c;
    const exact::Fifty inertia = of.M * (of.kk + of.c * of.c) + 2 * of.L * of.a * of.a;
    lambda2 = of.G * mc / inertia;
    epsilon = 2 * of.L / all;
    kappa2 = mc * mc / (all * inertia);
    across = mc * of.h / inertia;
  }

  /// One way to swing.
  struct Way
  {
    exact::Fifty square;                ///< σ², 1/s²
    std::array<exact::Fifty, 4> shape;  ///< φ, ω, η, ϑ, the greatest being 1
  };

  /// The pans against each other, while all else rests.
  Way against() const { return {mu2, {0, 0, 1, -1}}; }

  /// The way with η = ϑ whose σ² is the root of the cubic next to `near`, by Newton's rule: near to some parts in a thousand
  /// of the distance to the next.
  Way together(const exact::Fifty& near) const
  {
    const auto left = [this](const exact::Fifty& s) {
      return (nu2 - s) * (lambda2 - s) * (mu2 - s) - s * s * (kappa2 * (mu2 - s) + epsilon * (lambda2 - s));
    };
    exact::Fifty s = near;
    for(int j = 0; j < 12; ++j)
    {
      const exact::Fifty slight = s * exact::Fifty("1e-20");
      s -= left(s) * 2 * slight / (left(s + slight) - left(s - slight));
    }
    const exact::Fifty pan = s * shears / (strings * (mu2 - s));
    Way way{s, {1, s * across / (lambda2 - s), pan, pan}};
    exact::Fifty most = 0;
    for(const exact::Fifty& part : way.shape)
      if(abs(part) > abs(most))
        most = part;
    for(exact::Fifty& part : way.shape)
      part /= most;
    return way;
  }

  /// The sum of the cubic's three roots, by its coefficients.
  exact::Fifty sum_of_roots() const
  {
    return (nu2 + lambda2 + mu2 - kappa2 * mu2 - epsilon * lambda2) / (1 - kappa2 - epsilon);
  }

  /// 2π|μ² − ν²|/(εμ³), the approximate transfer time where κ is left aside, s.
  exact::Fifty rough_time() const { return 2 * exact::pi() * abs(mu2 - nu2) / (epsilon * mu2 * sqrt(mu2)); }

  /// Self-trapping (§38, (E)), of two motions that exchange in the time π/|σ − μ|.
  struct Limits
  {
    exact::Fifty critical;  ///< the critical swing n_c, radians
    exact::Fifty k;         ///< (n/n_c)²
    exact::Fifty reach;     ///< Q's greatest swing, in parts of n
  };

  /// For the swing n and the difference σ − μ.
  Limits limits(const exact::Fifty& apart, const exact::Fifty& n) const
  {
    const exact::Fifty critical = sqrt(32 * abs(apart) / sqrt(mu2)), r = abs(n) / critical;
    return {critical, r * r, reach(r)};
  }

  /// The last of them by n/n_c.
  static exact::Fifty reach(const exact::Fifty& r)
  {
    return r < 1 ? exact::Fifty(1) : exact::Fifty(sqrt((1 - sqrt(1 - 1 / (r * r * r * r))) / 2));
  }
};

}  // namespace balance
