/// @file
/// The inner loops over arrays, compiled once for each instruction set and chosen when the program runs.
///
/// All variants are made from one source (kernels.cpp and the folder kernels/) out of + − × ÷ and shifts of
/// bits alone, without contraction, so that each gives the same bits; only how many numbers are worked on
/// at once differs. What a product is rounded by is exact, and had by a fused instruction where there is one.
#pragma once

#include <cstddef>
#include <cstdint>

/// The loops over arrays.
namespace swing::kernels
{

/// The most terms that the series of a motion have after the first. They fall as the powers of the nome,
/// which is at most e^−π: the next would be less than 2⁻⁵⁸ of the first.
inline constexpr unsigned series_terms = 12;
/// As many suffice with a nome below `small_nome`.
inline constexpr unsigned few_terms = 4;
/// The nome of ζ = 10.1°.
inline constexpr double small_nome = 0x1p-11;
/// The dual nome of η = 3.6°. Below it one term is enough of each theta function.
inline constexpr double tiny_nome = 0x1p-14;

/// How often a half swing (or half a turn) goes into a unit of time.
struct Frequency
{
  double hi = 0;          ///< the leading double
  double head = 0;        ///< its upper 26 bits
  double tail = 0;        ///< hi − head
  double lo = 0;          ///< what hi lacks, to 107 bits in all
  double reach = 0x1p50;  ///< as many half swings can be told apart
};

/// The motion prepared for asking: what Motion computes once. See motion.cpp for how, kernels/forms.hpp for
/// what it is.
struct Prepared
{
  Frequency frequency;  ///< of the half swings

  double angle_series[series_terms] = {};     ///< of Φ in powers of x = (sin z / π)²
  double velocity_series[series_terms] = {};  ///< of Φ' in the same
  double log_q_hi =
      0;  ///< −ln q' of the dual nome: the argument of the hyperbolic functions per half swing
  double log_q_head = 0;  ///< its upper 26 bits
  double log_q_tail = 0;  ///< log_q_hi − log_q_head
  double log_q_lo = 0;    ///< what log_q_hi lacks
  double root_q = 0;      ///< √q'
  double q = 0;           ///< q'

  double angle_scale = 0;          ///< factor of the series of Φ or of tan ½Φ
  double velocity_scale = 0;       ///< factor of Φ'
  double angle_scale_lost = 0;     ///< what the first was rounded by, relative to it
  double velocity_scale_lost = 0;  ///< what the second was rounded by, relative to it
};

/// The courses a motion can take, each with its own formula. One started at rest follows upon the same
/// started at the bottom.
enum Course : int
{
  small,               ///< swinging, ζ up to 10.1°, the clock started at the bottom
  small_from_rest,     ///< the same started at rest
  low,                 ///< swinging, ζ from there to 90°
  low_from_rest,       ///< the same started at rest
  high,                ///< swinging, ζ > 90°
  high_from_rest,      ///< the same started at rest
  near_top,            ///< swinging, η < 3.6°
  near_top_from_rest,  ///< the same started at rest
  fast,                ///< revolving, with at least twice the energy that just reaches the top
  barely               ///< revolving with less
};

/// What can be asked of a motion.
enum Question : unsigned
{
  angle,     ///< Φ
  velocity,  ///< Φ'
  from_top   ///< the angle from the top, π − |Φ| in the first swing
};

/// A polynomial of degree 7 in the distance from its phase, counted in steps from one phase to the next. It
/// fills one line of the cache.
struct alignas(64) Row
{
  double c[8];  ///< the value at the phase, and the coefficients that follow
};

/// A motion's answers to one question: rows at equally spaced phases from the clock's start to a quarter
/// period.
struct Rows
{
  /// Reads the rows for one time, not less than 2⁻⁴⁰⁰.
  using One = double (*)(const Rows& rows, double t);

  Frequency frequency;          ///< of the half swings
  double steps = 0;             ///< from row to row in a half swing; a power of two
  std::uint64_t by_parity = 0;  ///< the bit of the sign where an odd half swing changes what is asked
  std::uint64_t by_side = 0;    ///< the bit of the sign where it is odd about the nearest whole half swing
  double turn_hi = 0;           ///< what each half swing adds: of an angle, going round, 2π,
  double turn_lo = 0;           ///< in two parts
  const Row* row = nullptr;     ///< the rows, ½ steps + 1 of them
  One one = nullptr;            ///< how this processor reads them best for one time
};

/// What the rows are made of: what is known at each of their phases.
struct Centres
{
  const double* angle = nullptr;  ///< Φ, or the angle from the top
  const double* speed = nullptr;  ///< its derivative by the time
  std::size_t size = 0;           ///< how many phases there are, a multiple of `rows_at_once`
  double pull = 0;  ///< the second derivative over the sine of the angle: −1, from the top 1
  double step = 0;  ///< the time from phase to phase
};
/// So many rows are made together.
inline constexpr std::size_t rows_at_once = 8;

/// One of the instruction sets, with all loops compiled for it. `in` and `out` have n elements; they may be
/// the same array.
struct Table
{
  const char* name;  ///< "sse2", "avx2", "avx512" (or "portable" where there is but one)

  /// A loop over numbers.
  using Loop = void (*)(const double* in, double* out, std::size_t n);
  Loop K;                  ///< of k
  Loop K_from_complement;  ///< of kc
  Loop ratio;              ///< of ζ
  Loop ratio_from_top;     ///< of η

  /// A loop over times that computes each answer from the beginning.
  using Direct = void (*)(const Prepared& p, const double* t, double* out, std::size_t n);
  Direct direct[10][3];  ///< by Course and Question

  /// A loop over times that reads the rows.
  using Read = void (*)(const Rows& rows, const double* t, double* out, std::size_t n);
  Read read;  ///< of any motion and question

  Rows::One read_one;          ///< the same for one time of a motion to and fro
  Rows::One read_one_turning;  ///< and of one that goes round

  /// Makes rows.
  using Make = void (*)(const Centres& centres, Row* rows);
  Make rows_of_angle;     ///< of the angle at the centres
  Make rows_of_velocity;  ///< of its derivative
};

/// How many variants this processor can run, from the plainest to the widest; at least one.
std::size_t count();

/// The variant number i < count().
const Table& variant(std::size_t i);

/// The widest.
const Table& best();

}  // namespace swing::kernels
