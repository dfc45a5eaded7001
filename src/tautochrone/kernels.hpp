#pragma once
/** @file
 * The loops that are compiled once for each set of instructions, and that give the same bits with each.
 */
#include <array>
#include <cstddef>
#include <cstdint>

namespace tautochrone::kernels
{

/// How many places go through a loop at once.
inline constexpr int lanes = 8;

/// A curve and an amplitude prepared for the loops: polynomials in c = cos φ and in e = 1/c.
struct Swing
{
  int powers;                  ///< how many coefficients the polynomials in c have
  int inverse_powers;          ///< how many those in e
  const double* r;             ///< of c⁰, c, ... in r
  const double* rise;          ///< of c⁰, c, ... in (x₀ − x)/(c − c₀)
  const double* r_inverse;     ///< of e, ee, ... in r
  const double* rise_inverse;  ///< of e, ee, ... in (x₀ − x)/(c − c₀)
  double c0;                   ///< cos φ₀
  double uu2;                  ///< 2 sin²½φ₀ = 1 − c₀
  double kk;                   ///< (k/a)²
};

/// Sums √((kk + rr)/((1 + c)(x₀ − x)/(c − c₀))) over three times eight places with c = c₀ + uu2 cos²α,
/// where the cos²α are given: one sum for each eight. The additions have the same order in every variant,
/// so that the bits are the same.
using Sum = void (*)(const Swing& swing, const double* cos2, double* sums);

/// The last power in the series of a step.
inline constexpr std::size_t last_power = 32;

/// A step of an exact tautochrone as the loops want it, see member.cpp: Y = unit Y₀ (1 + t), z = k (1 + t) + u, and
/// w and u by powers of t, which is from −length to 0.
struct Step
{
  double terms[last_power + 1][2];  ///< of w and of u
  double k;                         ///< k/a
  double kk;                        ///< (k/a)²
  double eps;                       ///< k/(1 + kk)
  double unit;                      ///< a factor of Y
  double Y;                         ///< Y₀: with `unit` Y at t = 0
  double cosine;                    ///< cos φ there
  double lifted;                    ///< (1 − cos φ)/YY there
  double length;                    ///< how far down it goes
  double small;                     ///< an error of t whose cube is nothing
  double guess[7];  ///< of t by the powers of q − q₀ from the first on; q is 2 sin ½φ/Y₀, and q₀ at t = 0
};

/// Some places of a tautochrone.
struct Places
{
  double r[lanes];            ///< MG
  double x[lanes];            ///< CQ
  double s[lanes];            ///< AM
  std::int64_t found[lanes];  ///< not 0 where the step has the angle; elsewhere the numbers mean nothing
};

/// Looks for the places with these angles, as many as there are lanes, in a step.
using Find = void (*)(const Step& step, const double* angles, Places& places);

/// The variants that this machine can run, the fastest last.
struct Variants
{
  std::size_t count = 0;              ///< how many
  std::array<Sum, 3> sum{};           ///< the loops over a swing
  std::array<Find, 3> find{};         ///< those over the places of a curve
  std::array<const char*, 3> name{};  ///< "sse2", "avx2", "avx512", or "portable"
};
/// Those variants; asked of the machine once.
const Variants& variants();

}  // namespace tautochrone::kernels
