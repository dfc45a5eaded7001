/// @file
/// The pendulum with fifty digits: what the fast functions, and the sections, are judged by.
///
/// Everything here is slow and plain. Each quantity can be had by two routes that share no formula;
/// tests/swing_oracle.cpp compares them, and both with published constants. Arguments are taken as they
/// are: a double stands for itself, exactly. Units as in time.hpp. Errors are a few units of the
/// forty-fifth digit unless said otherwise.
#pragma once

#include "exact/fifty.hpp"

namespace swing::oracle
{

using exact::Fifty;

/// The arithmetic-geometric mean of a, b ≥ 0.
Fifty agm(Fifty a, Fifty b);

/// K from kc, 0 ≤ kc ≤ 1: π/2M(1, kc).
Fifty K_from_complement(const Fifty& kc);
/// K from k, 0 ≤ k ≤ 1.
Fifty K(const Fifty& k);
/// K from kc by Euler's series in k² = 1 − kc² where kc² > ½, else by the one in kc² and ln(4/kc): the
/// second route.
Fifty K_by_series(const Fifty& kc);

/// T/Θ from ζ, 0 ≤ ζ ≤ π.
Fifty ratio_from_bottom(const Fifty& zeta);
/// T/Θ from η, 0 ≤ η ≤ π.
Fifty ratio_from_top(const Fifty& eta);
/// T/Θ − 1 from ζ, without cancellation: (1 − M)/M, where 1 − M is a sum of squares over means.
Fifty ratio_excess(const Fifty& zeta);

/// The time from the lowest point up to Φ, 0 ≤ Φ ≤ ζ, for the amplitude ζ = π − η, η ≥ 0; infinite at the
/// top.
Fifty time_from_bottom(const Fifty& phi, const Fifty& eta);
/// The time from rest at η from the top down to ψ = η + past from the top.
Fifty time_from_rest_past(const Fifty& past, const Fifty& eta);

/// The motion by theta functions of the nome or its dual, whichever is the smaller; never more than e^−π.
/// Of a time of 10ⁿ half periods n digits are lost; beyond 10³⁰ of them the answer is NaN.
class Motion
{
public:
  /// Swinging with 0 < ζ < π, at t = 0 upwards through the lowest point.
  static Motion from_zeta(const Fifty& zeta);
  /// The same with η = π − ζ given, 0 < η < π.
  static Motion from_eta(const Fifty& eta);
  /// Going round, as swing::Motion::revolving; excess > 0.
  static Motion revolving(const Fifty& excess);

  Fifty angle(const Fifty& t) const;           ///< Φ
  Fifty velocity(const Fifty& t) const;        ///< Φ'
  Fifty angle_from_top(const Fifty& t) const;  ///< the angle from the upper vertical, 0 … π
  /// Φ by Gauss' and Landen's transformation of the amplitude, the second route. Loses half as many digits
  /// as kc has zeros.
  Fifty angle_by_landen(const Fifty& t) const;
  /// A quarter of the period of swinging, half the time of a turn of revolving.
  const Fifty& quarter() const { return quarter_; }

private:
  struct Place;
  Motion(const Fifty& k, const Fifty& kc, const Fifty& rate, bool turns);
  Place place(const Fifty& t) const;
  struct Quotient;
  Quotient tangent_of_half(const Fifty& u) const;

  Fifty k_;
  Fifty kc_;
  Fifty rate_;  // du/dt
  bool turns_;  // going round
  bool dual_;   // theta functions of the dual nome
  Fifty K_;
  Fifty other_K_;
  Fifty q_;
  Fifty quarter_;
};

}  // namespace swing::oracle
