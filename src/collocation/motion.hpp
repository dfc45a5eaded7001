/// @file
/// A motion of few degrees of freedom, or eight of them side by side, integrated to rounding by Gauss' collocation.
///
/// A system says how many numbers move and what their accelerations are, for eight of each at once. The first `angles` of
/// them may be angles: then it is given their sines and cosines too, which cost less so than if it found them itself.
///
/// @code{.cpp}
/// struct Pendulum
/// {
///   static constexpr unsigned freedoms = 1, angles = 1;  // the latter may be left out, and `turned` with it
///   double q2;                                           // x″ = −q² sin x
///
///   template <class Of, class Real>
///   ELEMENTARY_INLINE static void accelerations(const Of& of, const Real& t, const Real* x,
///                                               const elementary::SineCosine<Real>* turned, const Real* v, Real* a)
///   {
///     a[0] = Real(-of.q2) * turned[0].sine;
///   }
/// };
/// collocation::Motion<Pendulum> motion({1}, {.x = {1.5}, .v = {0}}, {.first_step = 0.1});
/// const double angle = motion.to(10).x[0];
/// @endcode
///
/// A system whose accelerations know the time only through one number may say what that is, in a function driven(of, t):
/// then accelerations() is given that number for t, and it is found once a step.
///
/// Errors, measured in tests/collocation.cpp: of the tolerance 1e-14 a step the motions that return to where they were
/// (a pendulum, Euler's balance of §36) are right to 5e-14 of their amplitude after a hundred periods and to 1e-10 after
/// ten thousand, when the energy still has 3e-12; of a wild motion the error divided by its condition is less than fifty
/// units of 2⁻⁵².
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "collocation/gauss.hpp"

namespace collocation
{

/// Where a motion of n numbers is, and how fast.
template <unsigned n>
struct Moment
{
  std::array<double, n> x{};  ///< where
  std::array<double, n> v{};  ///< how fast
};

/// How a motion is to be followed.
struct Care
{
  double tolerance =
      1e-14;  ///< error of a step relative to the velocities, by an estimate that is mostly far too
              ///< high; 1e-24 to 0.01. From 2⁻³⁶ on the step's equations are solved to 2⁻¹⁸ of it
  double first_step =
      0.125;  ///< what is tried first; found too long, it is shortened, found too short, lengthened
};

/// The first step, as short as all others are kept.
inline double first_step(const Care& care)
{
  return trimmed(std::max(care.first_step, 0x1p-900));
}

/// The functions that carry a motion on, compiled for one instruction set.
template <class System, unsigned lanes>
struct Engine
{
  using Kept = Record<System::freedoms, lanes>;  ///< the motion in memory
  /// Carries it on: by whole steps up to, or exactly to the moment given for each.
  void (*advance)(const System& of, Kept& kept, const double* until, bool exactly, Effort& effort);
};

inline namespace COLLOCATION_REGISTERS
{

/// Carries a motion on; see Course.
template <class System>
void advance_alone(const System& of, Record<System::freedoms, 1>& kept, const double* until, bool exactly,
                   Effort& effort)
{
  Course<Alone, System> course(of, kept);
  course.advance(*until, exactly, effort);
  course.keep(kept);
}

/// Copies the motion number `of` to the place number `to`.
template <unsigned n, unsigned some, unsigned others>
ELEMENTARY_INLINE void copy(const Record<n, some>& from, unsigned of, Record<n, others>& record,
                            unsigned to)
{
  for(unsigned k = 0; k < n; ++k)
  {
    record.x[k][to] = from.x[k][of];
    record.x_lost[k][to] = from.x_lost[k][of];
    record.v[k][to] = from.v[k][of];
    record.v_lost[k][to] = from.v_lost[k][of];
    for(unsigned j = 0; j < 8; ++j)
      record.forces[k][j][to] = from.forces[k][j][of];
  }
  record.t[to] = from.t[of];
  record.t_lost[to] = from.t_lost[of];
  record.step[to] = from.step[of];
  record.last_step[to] = from.last_step[of];
  record.trouble[to] = from.trouble[of];
  record.refused[to] = from.refused[of];
}

/// Carries eight on, as many at a time as a register holds, or, where it holds but two, one after the other, which is the
/// quicker there; see Course.
template <class System>
void advance_together(const System& of, Record<System::freedoms, 8>& kept, const double* until,
                      bool exactly, Effort& effort)
{
  for(unsigned from = 0; from < 8; from += width == 2 ? 1 : width)
    if constexpr(width == 2)
    {
      Record<System::freedoms, 1> one;
      copy(kept, from, one, 0);
      advance_alone(of, one, until + from, exactly, effort);
      copy(one, 0, kept, from);
    }
    else
    {
      Course<Together, System> course(of, kept, from);
      course.advance(Register(until + from), exactly, effort);
      course.keep(kept);
    }
}

/// The functions compiled with this file's flags.
/// @{
template <class System>
constexpr Engine<System, 1> engine_here{advance_alone<System>};
template <class System>
constexpr Engine<System, 8> engine_of_eight_here{advance_together<System>};
/// @}

}  // namespace COLLOCATION_REGISTERS

/// A motion under way, carried on from time to time. It starts at t = 0.
template <class System>
class Motion
{
public:
  static constexpr unsigned n = System::freedoms;  ///< numbers that move

  /// `of`, from `start` at t = 0.
  /// @throws std::domain_error unless the start is finite, 1e-24 ≤ tolerance ≤ 0.01, and the first step positive and finite
  Motion(const System& of, const Moment<n>& start, const Care& care = {},
         Engine<System, 1> engine = engine_here<System>)
      : of_(of), engine_(engine)
  {
    bool possible = care.tolerance >= 1e-24 && care.tolerance <= 0.01 && care.first_step > 0
                    && std::isfinite(care.first_step);
    for(unsigned k = 0; k < n; ++k)
    {
      possible = possible && std::isfinite(start.x[k]) && std::isfinite(start.v[k]);
      kept_.x[k][0] = start.x[k];
      kept_.v[k][0] = start.v[k];
    }
    if(!possible)
      throw std::domain_error("no such motion: numbers must be finite, the tolerance from 1e-24 to 0.01");
    kept_.step[0] = first_step(care);
    effort_.tolerance = care.tolerance;
  }

  /// Where it is at the time t, which must not lie before the last one asked for. What is found does not depend on which
  /// moments were asked for before, to the last bit.
  /// @throws std::invalid_argument if t is not finite or lies before
  /// @throws std::runtime_error if the steps become too short: the motion is not smooth enough
  Moment<n> to(double t)
  {
    if(!std::isfinite(t) || t < asked_)
      throw std::invalid_argument("a motion can only be carried on to a later time");
    asked_ = t;
    engine_.advance(of_, kept_, &t, false, effort_);
    auto there = kept_;
    engine_.advance(of_, there, &t, true, effort_);
    if(there.refused[0] != 0)
      throw std::runtime_error("the motion cannot be carried on: its steps become too short");
    Moment<n> now;
    for(unsigned k = 0; k < n; ++k)
    {
      now.x[k] = there.x[k][0];
      now.v[k] = there.v[k][0];
    }
    return now;
  }

  /// What it has cost so far.
  const Effort& effort() const { return effort_; }

private:
  System of_;
  Engine<System, 1> engine_;
  Record<n, 1> kept_;
  Effort effort_;
  double asked_ = 0;
};

/// Eight motions of one system side by side, from different starts, all from t = 0. Each has the bits that it has alone.
template <class System>
class Ensemble
{
public:
  static constexpr unsigned n = System::freedoms;  ///< numbers that move

  /// `of`, from each of `starts`. @throws std::domain_error as Motion does
  Ensemble(const System& of, const std::array<Moment<n>, 8>& starts, const Care& care = {},
           Engine<System, 8> engine = engine_of_eight_here<System>)
      : of_(of), engine_(engine)
  {
    for(unsigned i = 0; i < 8; ++i)
    {
      const Motion<System> alone(of, starts[i], care);  // refuses what is no motion
      for(unsigned k = 0; k < n; ++k)
      {
        kept_.x[k][i] = starts[i].x[k];
        kept_.v[k][i] = starts[i].v[k];
      }
      kept_.step[i] = first_step(care);
    }
    effort_.tolerance = care.tolerance;
  }

  /// Where each is at the time t, which must not lie before the last one asked for; a motion that cannot be carried on is
  /// NaN from there.
  /// @throws std::invalid_argument if t is not finite or lies before
  std::array<Moment<n>, 8> to(double t)
  {
    if(!std::isfinite(t) || t < asked_)
      throw std::invalid_argument("a motion can only be carried on to a later time");
    asked_ = t;
    double until[8];
    for(double& each : until)
      each = t;
    engine_.advance(of_, kept_, until, false, effort_);
    auto there = kept_;
    engine_.advance(of_, there, until, true, effort_);
    std::array<Moment<n>, 8> now;
    for(unsigned i = 0; i < 8; ++i)
      for(unsigned k = 0; k < n; ++k)
      {
        const double lost = there.refused[i] != 0 ? std::nan("") : 0;
        now[i].x[k] = there.x[k][i] + lost;
        now[i].v[k] = there.v[k][i] + lost;
      }
    return now;
  }

  /// What it has cost so far; a step or a sweep is one of all that are followed side by side.
  const Effort& effort() const { return effort_; }

private:
  System of_;
  Engine<System, 8> engine_;
  Record<n, 8> kept_;
  Effort effort_;
  double asked_ = 0;
};

}  // namespace collocation
