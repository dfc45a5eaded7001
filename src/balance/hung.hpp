/// @file
/// The balance whose pivot C hangs from a higher point O by shears (§38), and the one whose ends A, B lie lower than C
/// (§37): modes, transfer times, the exact motion.
///
/// φ is the inclination of the shears, counted like the other angles from the vertical towards the side of A.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "balance/instrument.hpp"

namespace balance
{

/// Such a balance.
struct Suspended
{
  Instrument beam;      ///< beam and pans
  double h;             ///< OC, the length of the shears; what it is does not matter where C is fixed
  double e = 0;         ///< how far A and B lie below the level of C; negative if above
  bool movable = true;  ///< false: C is fixed
};

/// Designed so that its frequencies are 1, 13/5, 4 and 21/5 (§38): P's motion passes to Q exactly at t = 5π.
inline constexpr Suspended designed{
    {2, 2, 0.0491419399153504980158277981914353, 4. / 3, 1, 33.8387865167112365868474531686185, 16},
    4.55549335388984006168325650473419};
/// In round numbers (§38).
inline constexpr Suspended plain{Instrument{2, 2, 0.1, 4. / 3, 1, 20, 16}, 5};

/// Four angles, or their rates.
struct Four
{
  double phi = 0;    ///< the shears
  double omega = 0;  ///< the beam
  double eta = 0;    ///< the pan P
  double theta = 0;  ///< the pan Q
};

/// Where it is, and how fast.
struct Full_state
{
  Four at;    ///< radians
  Four rate;  ///< radians a second
};

/// One way to swing in which all swing alike.
struct Mode
{
  double square;     ///< σ², 1/s²; negative where it topples
  double frequency;  ///< σ, 1/s; NaN where it topples
  Four shape;  ///< the angles, the greatest being ±1; 0 throughout where C is fixed and φ does not move
};

/// The linear modes, the slowest first: four, or three where C is fixed. Frequencies, squares and shapes are right to the
/// last bit but one for exactly the doubles given: GSL's solver finds them, fifty digits make them exact.
/// @throws std::domain_error as numbers_of() does, unless h > 0 (C movable), L > 0 and e is finite, and, in words, where
/// the mass matrix is not positive definite
std::vector<Mode> modes(const Suspended& s);

/// What becomes of a motion of P alone.
struct Transfer
{
  double splitting;  ///< σ − μ, 1/s, σ being the mode with η = ϑ nearest to μ: to full relative precision
  double time;  ///< π/|σ − μ|: P's motion is then Q's; ∞ where nothing couples them
  double
      estimate;  ///< 2π|μ² − ν²|/(εμ³), ν² = 2g/h, ε = 2L/(M+2L); C fixed: from σ − μ ≈ (Le²/I)μ³/(μ²−λ²)
};

/// For small swings. @throws std::domain_error as modes() does
Transfer transfer(const Suspended& s);

/// The most that Q can have of the swing of P, which is let go alone, where Q's string is longer than P's by the part
/// `longer` of it: what the linear modes so excited have of ϑ, signs left aside; 1 where the strings are equal and something
/// couples them. A motion comes as near to it as one likes if the frequencies have no common measure. Error below 1e-10
/// for moderate instruments (GSL's solver alone; tests/balance_linear.cpp).
/// @throws std::domain_error as modes() does, unless longer > −1, and where a mode topples or nothing couples the pans
double handed_on(const Suspended& s, double longer);

/// The linear motion at the time t: the sum of the modes with the parts that the start gives them, in fifty digits, and so
/// right to the last bit for exactly the doubles given.
/// @throws std::domain_error as modes() does
Full_state linear_motion(const Suspended& s, const Full_state& start, double t);

/// The exact motion, under way.
class Full_motion
{
public:
  /// `s` from `start` at t = 0; φ must be 0 and at rest where C is fixed.
  /// @throws std::domain_error as modes() does, or where the start is not finite, or the tolerance not from 1e-24 to 0.01
  Full_motion(const Suspended& s, const Full_state& start, double tolerance = 1e-14);
  ~Full_motion();
  /// It may be moved, not copied.
  /// @{
  Full_motion(Full_motion&&) noexcept;
  Full_motion& operator=(Full_motion&&) noexcept;
  /// @}

  /// The state at the time t, which must not lie before the last one asked for. Error below 1e-12 in the scenes of §38
  /// until t = 60. @throws as Motion::to() does
  const Full_state& to(double t);

  /// |E/E₀ − 1|, or |E − E₀| where E₀ is zero, at the last time asked for.
  double energy_drift() const;

private:
  struct Inner;
  std::unique_ptr<Inner> inner_;
};

/// How many times a slight change of the angles at the start has grown until the time t, as parting() of motion.hpp tells
/// it of the balance with C fixed. @throws as Full_motion does. Precondition: t ≥ 0
double parting(const Suspended& s, const Full_state& start, double t);

/// The energy in the instrument's weight times length, zero where all hangs straight down, and its shares.
struct Energies
{
  double P;     ///< of the pan P by itself, ½Lb²η̇²/2g + Lb(1 − cos η)
  double Q;     ///< of Q
  double rest;  ///< all else, the couplings included
};
/// Of a state.
Energies energies(const Suspended& s, const Full_state& now);

}  // namespace balance
