/// @file
/// How long a swing takes: the pendulum's time for any amplitude, up to the top.
///
/// The angle Φ is measured from the lowest point, ζ is its greatest value, η = π − ζ what is missing to the
/// top, both in radians. T is the time of one swing from one side to the other (half of today's period), Θ
/// the same for very small arcs, and the unit of time is √(b/2g), b being the length of the equivalent
/// simple pendulum and 2g the acceleration of gravity; in it Θ = π and the equation of motion is Φ'' = −sin
/// Φ.
///
///     K(k)                       quarter of a whole period, k = sin ½ζ           K(1) = +∞
///     K_from_complement(kc)      the same, kc = cos ½ζ = sin ½η                  K_from_complement(0) = +∞
///     quarter_time(a)            the same from the amplitude
///     quarter_time_from_top(η)   the same from η: K(cos ½η)
///     ratio(a)                   T/Θ; also ratio_from_bottom(ζ) and ratio_from_top(η)
///     ratio_excess(a)            T/Θ − 1, without cancellation
///     time_from_bottom(Φ, a)     from Φ = 0 up to Φ
///     time_from_rest(ψ, η)       from rest at η from the top down to ψ from the top
///     time_from_rest_past(δ, η)  the same down to ψ = η + δ, δ however small
///     agm(a, b)                  the arithmetic-geometric mean
///
/// Near the top the modulus k is no fit parameter (below η = 2·10⁻⁸ the double nearest to cos ½η is 1), nor
/// is ζ; there one gives η or kc. The functions of arrays never throw for what is in the arrays.
#pragma once

#include <span>

namespace swing
{

/// π as the sum of two doubles: the first is the double nearest to π,
inline constexpr double pi_hi = 0x1.921fb54442d18p+1;
/// the second what it lacks.
inline constexpr double pi_lo = 0x1.1a62633145c07p-53;

/// How far the pendulum swings: the amplitude and its supplement, each as exact as a double can be.
struct Amplitude
{
  double zeta;           ///< greatest angle from the lowest point, 0 … π, radians
  double eta;            ///< π − ζ, formed from a π of 107 bits
  double zeta_rest = 0;  ///< what zeta lacks of ζ, where η was given
  double eta_rest = 0;   ///< what eta lacks of η, where ζ was given

  /// From ζ. Throws std::domain_error unless 0 ≤ ζ ≤ π (the double nearest to π lies below π: its η is
  /// 1.22·10⁻¹⁶).
  static Amplitude from_zeta(double zeta);
  /// From η. Throws std::domain_error unless 0 ≤ η ≤ π.
  static Amplitude from_eta(double eta);
  /// From the height h = 1 − cos ζ of the turning point over the lowest point, in lengths b (Euler's d/b).
  /// Throws std::domain_error unless 0 ≤ h ≤ 2. Neither ζ nor η loses digits: no arc cosine is taken.
  static Amplitude from_height(double h);
  /// From the depth 1 − cos η of the turning point under the top, in lengths b. Throws as from_height().
  static Amplitude from_depth(double depth);

  /// 1 − cos ζ, as 2 sin² ½ζ.
  double height() const;
  /// 1 − cos η, as 2 sin² ½η.
  double depth() const;
  /// k = sin ½ζ.
  double modulus() const;
  /// kc = cos ½ζ = sin ½η.
  double complement() const;
};

// The errors that follow are the worst found against 107 bits and fifty digits, in units of the last place
// (ulp): hundreds of thousands of arguments in every range, the edges of all tables and intervals included.
// tests/swing_time.cpp holds them.
//
// They are those of round to nearest. In the other modes of fesetround what is read from tables (K and T/Θ
// in all their forms) errs by 1.15 ulp and everything else by twice as much as stated. Where the processor
// is told to flush subnormal numbers, a subnormal kc or η is zero; nothing else is lost.
// tests/swing_environment.cpp holds this.

/// The complete elliptic integral of the first kind K(k) of the modulus k, |k| ≤ 1. K(±1) = +∞; NaN outside
/// and for NaN. Worst error 0.6 ulp, for every k up to 1 − 2⁻⁵³.
double K(double k);

/// K as a function of the complementary modulus kc = √(1 − k²), 0 ≤ kc ≤ 1, down to the smallest double.
/// K_from_complement(0) = +∞; NaN outside and for NaN. Worst error 0.54 ulp.
double K_from_complement(double kc);

/// The time from the lowest point to rest, in units √(b/2g); +∞ for η = 0. Worst error 0.8 ulp.
double quarter_time(Amplitude a);

/// The same from η = π − ζ, 0 ≤ η ≤ π, down to the smallest double. NaN outside and for NaN. Worst error
/// 0.6 ulp.
double quarter_time_from_top(double eta);

/// T/Θ, the time of a swing over that of a very small one; +∞ for η = 0. Worst error 0.55 ulp.
double ratio(Amplitude a);

/// The same from η = π − ζ, 0 ≤ η ≤ π. NaN outside and for NaN. Worst error 0.56 ulp.
double ratio_from_top(double eta);

/// The same from ζ, 0 ≤ ζ ≤ π, for those who ask once and keep no Amplitude. NaN outside and for NaN. Worst
/// error 0.55 ulp, also at the double nearest to π and before it.
double ratio_from_bottom(double zeta);

/// T/Θ − 1, to full relative precision also for the smallest swings; +∞ for η = 0. Worst error 10⁻¹⁵ of the
/// value.
double ratio_excess(Amplitude a);

/// The time from the lowest point up to the angle Φ, in units √(b/2g). Odd in Φ. NaN unless |Φ| ≤ ζ.
/// Worst error 5 ulp for Φ and ζ as given.
double time_from_bottom(double phi, Amplitude a);

/// The time from rest at the angle η from the top down to the angle ψ from the top, 0 < η ≤ ψ ≤ π, in units
/// √(b/2g). NaN unless ψ and η are so; +∞ for η = 0 < ψ. Worst error 6 ulp for ψ and η as given.
double time_from_rest(double psi, double eta);

/// The same where ψ = η + past and `past` ≥ 0 is the given quantity: near rest ψ itself would not carry its
/// digits. Worst error 6 ulp.
double time_from_rest_past(double past, double eta);

/// K of an array of moduli, with the widest registers that the processor has; on all of them the same bits
/// as for one number, for the ends and NaN too. Throws std::invalid_argument when the spans differ in
/// length, never for a value. The spans may be the same, or not overlap.
void K(std::span<const double> k, std::span<double> out);

/// K_from_complement of an array, the same.
void K_from_complement(std::span<const double> kc, std::span<double> out);

/// T/Θ of an array of amplitudes ζ, the same.
void ratio_from_bottom(std::span<const double> zeta, std::span<double> out);

/// T/Θ of an array of η = π − ζ, the same.
void ratio_from_top(std::span<const double> eta, std::span<double> out);

/// The arithmetic-geometric mean of a and b, both ≥ 0: K = π/2M(1, kc). Stops when both means agree to half
/// the digits, after which one more arithmetic mean has them all. Zero when either is zero; NaN for a
/// negative one. K by this mean errs by up to 5 ulp.
double agm(double a, double b);

}  // namespace swing
