/// @file
/// Gauss' collocation with eight stages for motions of few degrees of freedom.
///
/// For every smooth system x″ = F(t, x, x′) of n numbers. In each step the accelerations are a polynomial of the seventh
/// degree that satisfies the equations at eight moments, the zeros of Legendre's polynomial; what is found so is right to
/// the sixteenth order, keeps every quadratic invariant, and can be gone back. The eight moments are worked on at once,
/// or, in an ensemble, as many motions as a register holds. The equations of a step are solved by repetition, from the
/// polynomial of the step before; what is added up is added with what the sums are rounded by. Sines and cosines of
/// angles are found once or twice a step, and turned on from there while the repetitions come nearer to each other.
///
/// The step is as long as the polynomial's last two coefficients allow, and kept as long as it may: a motion that returns
/// is followed by equal steps, and so without drift. A motion that cannot be followed is refused, not guessed at.
///
/// All is + − × ÷ and √ without contraction, in the same order for every width of registers and for a motion alone or
/// among others: the bits are the same. The course of the steps does not depend on the moments asked for.
#pragma once

#include <cmath>
#include <cstdint>

#include "collocation/coefficients.hpp"
#include "collocation/effort.hpp"
#include "collocation/eight.hpp"

namespace collocation
{

/// A motion of n numbers under way, `lanes` of them side by side: plain numbers, the same for every width of registers.
template <unsigned n, unsigned lanes>
struct alignas(64) Record
{
  double x[n][lanes] = {};          ///< where they are
  double x_lost[n][lanes] = {};     ///< what those were rounded by
  double v[n][lanes] = {};          ///< how fast they move
  double v_lost[n][lanes] = {};     ///< what those were rounded by
  double t[lanes] = {};             ///< when
  double t_lost[lanes] = {};        ///< what that was rounded by
  double step[lanes] = {};          ///< the next step
  double last_step[lanes] = {};     ///< the last one; 0 before the first
  double trouble[lanes] = {};       ///< the largest error estimated lately, fading
  double refused[lanes] = {};       ///< 1 where the motion could not be followed
  double forces[n][8][lanes] = {};  ///< the accelerations at the stages of the last step
};

inline namespace COLLOCATION_REGISTERS
{

/// One motion: its eight stages are worked on at once.
struct Alone
{
  static constexpr unsigned kept = 1;    ///< motions in a Record
  static constexpr unsigned pieces = 1;  ///< that the stages are worked on in
  using Number = double;                 ///< one for each motion
  using Piece = Eight;                   ///< the stages that are worked on at once
  using Stages = Eight;                  ///< one for each motion and stage
  using Answer = bool;                   ///< to a question about each motion

  /// From and to memory, and from a table of eight.
  /// @{
  ELEMENTARY_INLINE static double load(const double* x) { return *x; }
  ELEMENTARY_INLINE static void save(double* to, double x) { *to = x; }
  ELEMENTARY_INLINE static Eight load_stages(const double (*x)[1], unsigned) { return Eight(&x[0][0]); }
  ELEMENTARY_INLINE static void save_stages(double (*to)[1], unsigned, const Eight& x)
  {
    x.store(&to[0][0]);
  }
  ELEMENTARY_INLINE static Eight table(const double* x) { return Eight(x); }
  /// @}
};

/// As many motions as a register holds, of the eight in a Record: the stages one after the other.
struct Together
{
  static constexpr unsigned kept = 8;    ///< motions in a Record
  static constexpr unsigned pieces = 8;  ///< that the stages are worked on in
  using Number = Register;               ///< one for each motion
  using Piece = Register;                ///< a stage
  using Answer = Answers<width>;         ///< to a question about each motion
  /// One for each motion and stage.
  struct Stages
  {
    Register at[8];  ///< by stage

    Stages() = default;
    /// The same at each stage.
    ELEMENTARY_INLINE Stages(const Register& x)
    {
      for(Register& one : at)
        one = x;
    }
  };

  /// From and to memory, and from a table of eight.
  /// @{
  ELEMENTARY_INLINE static Register load(const double* x) { return Register(x); }
  ELEMENTARY_INLINE static void save(double* to, const Register& x) { x.store(to); }
  ELEMENTARY_INLINE static Stages load_stages(const double (*x)[8], unsigned from)
  {
    Stages s;
    for(unsigned j = 0; j < 8; ++j)
      s.at[j] = Register(&x[j][from]);
    return s;
  }
  ELEMENTARY_INLINE static void save_stages(double (*to)[8], unsigned from, const Stages& x)
  {
    for(unsigned j = 0; j < 8; ++j)
      x.at[j].store(&to[j][from]);
  }
  ELEMENTARY_INLINE static Stages table(const double* x)
  {
    Stages s;
    for(unsigned j = 0; j < 8; ++j)
      s.at[j] = Register(x[j]);
    return s;
  }
  /// @}
};

/// Stage by stage.
/// @{
template <class Function, class... Arguments>
ELEMENTARY_INLINE Together::Stages by_stage(Function f, const Arguments&... x)
{
  Together::Stages result;
  for(unsigned j = 0; j < 8; ++j)
    result.at[j] = f(x.at[j]...);
  return result;
}
ELEMENTARY_INLINE Together::Stages operator+(const Together::Stages& x, const Together::Stages& y)
{
  return by_stage([](const Register& a, const Register& b) { return a + b; }, x, y);
}
ELEMENTARY_INLINE Together::Stages operator-(const Together::Stages& x, const Together::Stages& y)
{
  return by_stage([](const Register& a, const Register& b) { return a - b; }, x, y);
}
ELEMENTARY_INLINE Together::Stages operator*(const Together::Stages& x, const Together::Stages& y)
{
  return by_stage([](const Register& a, const Register& b) { return a * b; }, x, y);
}
ELEMENTARY_INLINE Together::Stages magnitude(const Together::Stages& x)
{
  return by_stage([](const Register& a) { return magnitude(a); }, x);
}
ELEMENTARY_INLINE Together::Stages select(const Together::Answer& which, const Together::Stages& x,
                                          const Together::Stages& y)
{
  return by_stage([&which](const Register& a, const Register& b) { return select(which, a, b); }, x, y);
}
ELEMENTARY_INLINE Register sum(const Together::Stages& x)
{
  const Register* y = x.at;
  return ((y[0] + y[4]) + (y[2] + y[6])) + ((y[1] + y[5]) + (y[3] + y[7]));
}
/// @}

/// Piece j of Stages.
/// @{
ELEMENTARY_INLINE Eight& piece(Eight& x, unsigned)
{
  return x;
}
ELEMENTARY_INLINE const Eight& piece(const Eight& x, unsigned)
{
  return x;
}
ELEMENTARY_INLINE Register& piece(Together::Stages& x, unsigned j)
{
  return x.at[j];
}
ELEMENTARY_INLINE const Register& piece(const Together::Stages& x, unsigned j)
{
  return x.at[j];
}
/// @}

/// How many of a System's numbers, the first ones, are angles whose sines and cosines its accelerations are given.
template <class System>
constexpr unsigned angles_of = [] {
  if constexpr(requires { System::angles; })
    return System::angles;
  else
    return 0U;
}();

/// Sine and cosine of x + by, where those of x are given and |by| ≤ 2⁻⁸: by series, which break off below 2⁻⁵⁷.
template <class Piece>
ELEMENTARY_INLINE elementary::SineCosine<Piece> turned_on(const elementary::SineCosine<Piece>& of_x,
                                                          const Piece& by)
{
  const Piece z = by * by;
  const Piece sine = by + (by * z) * (Piece(-1. / 6) + z * Piece(1. / 120));
  const Piece less = z * (Piece(-0.5) + z * Piece(1. / 24));  // cos − 1
  return {of_x.sine + (of_x.cosine * sine + of_x.sine * less),
          of_x.cosine + (of_x.cosine * less - of_x.sine * sine)};
}

/// What the accelerations of a System want of the time at all stages: the time itself, or what the System's driven()
/// makes of it, which is found once a step.
/// @{
template <class System, class Piece>
ELEMENTARY_INLINE Piece driven(const System& of, const Piece& t)
{
  if constexpr(requires { System::driven(of, t); })
    return System::driven(of, t);
  else
    return t;
}
template <class System>
ELEMENTARY_INLINE Together::Stages driven(const System& of, const Together::Stages& t)
{
  return by_stage([&of](const Register& at) { return driven(of, at); }, t);
}
/// @}

/// The integral of the polynomial through F from the step's beginning to each stage, and that of this integral.
template <class Stages>
struct Integrals
{
  Stages once;   ///< Σ of coefficients::once times F
  Stages twice;  ///< Σ of coefficients::twice times F
};

/// The integrals of one motion's stages F, and of all numbers' of several motions side by side.
/// @{
ELEMENTARY_INLINE Integrals<Eight> integrals(const Eight& F)
{
  using coefficients::once, coefficients::twice;
  alignas(64) double f[8];
  F.store(f);
  Eight even1 = Eight(once[0]) * Eight(f[0]), odd1 = Eight(once[1]) * Eight(f[1]);
  Eight even2 = Eight(twice[0]) * Eight(f[0]), odd2 = Eight(twice[1]) * Eight(f[1]);
  for(unsigned j = 2; j < 8; j += 2)
  {
    const Eight even(f[j]), odd(f[j + 1]);
    even1 = even1 + Eight(once[j]) * even;
    odd1 = odd1 + Eight(once[j + 1]) * odd;
    even2 = even2 + Eight(twice[j]) * even;
    odd2 = odd2 + Eight(twice[j + 1]) * odd;
  }
  return {even1 + odd1, even2 + odd2};
}
template <unsigned n>
ELEMENTARY_INLINE void integrals(const Together::Stages (&F)[n], Integrals<Together::Stages> (&of_F)[n])
{
  using coefficients::once, coefficients::twice;
#pragma GCC unroll 1
  for(unsigned i = 0; i < 8; ++i)
  {
    Integrals<Register> even[n], odd[n];
    for(unsigned k = 0; k < n; ++k)
    {
      even[k] = {Register(once[0][i]) * F[k].at[0], Register(twice[0][i]) * F[k].at[0]};
      odd[k] = {Register(once[1][i]) * F[k].at[1], Register(twice[1][i]) * F[k].at[1]};
    }
#pragma GCC unroll 3
    for(unsigned j = 2; j < 8; j += 2)
    {
      const Register once_even(once[j][i]), twice_even(twice[j][i]), once_odd(once[j + 1][i]),
          twice_odd(twice[j + 1][i]);
      for(unsigned k = 0; k < n; ++k)
      {
        even[k].once = even[k].once + once_even * F[k].at[j];
        even[k].twice = even[k].twice + twice_even * F[k].at[j];
        odd[k].once = odd[k].once + once_odd * F[k].at[j + 1];
        odd[k].twice = odd[k].twice + twice_odd * F[k].at[j + 1];
      }
    }
    for(unsigned k = 0; k < n; ++k)
    {
      of_F[k].once.at[i] = even[k].once + odd[k].once;
      of_F[k].twice.at[i] = even[k].twice + odd[k].twice;
    }
  }
}
/// @}

/// |x| of one number or of several.
/// @{
ELEMENTARY_INLINE double magnitude_of(double x)
{
  return elementary::magnitude(x);
}
ELEMENTARY_INLINE Register magnitude_of(const Register& x)
{
  return magnitude(x);
}
/// @}

/// The upper 24 bits of x, so that its square is exact: what it would be rounded by is the same in every step, and adds up.
/// @{
ELEMENTARY_INLINE double trimmed(double x)
{
  return elementary::from_bits<double>(elementary::bits_of(x) & ~std::uint64_t{0x1fffffff});
}
ELEMENTARY_INLINE Register trimmed(const Register& x)
{
  return each<Register>(
      [](Wide a) {
        return elementary::from_bits<Wide>(elementary::bits_of(a) & ~std::uint64_t{0x1fffffff});
      },
      x);
}
/// @}

/// The numbers of each stage.
/// @{
ELEMENTARY_INLINE void split(const Eight& x, double (&numbers)[8])
{
  x.store(numbers);
}
ELEMENTARY_INLINE void split(const Together::Stages& x, Register (&numbers)[8])
{
  for(unsigned j = 0; j < 8; ++j)
    numbers[j] = x.at[j];
}
/// @}

/// A motion of a System, alone or among others, as it is carried on from step to step.
template <class Layout, class System>
class Course
{
public:
  static constexpr unsigned n = System::freedoms;  ///< numbers that move
  using Number = typename Layout::Number;          ///< one for each motion
  using Piece = typename Layout::Piece;            ///< some of
  using Stages = typename Layout::Stages;          ///< one for each motion and stage
  using Answer = typename Layout::Answer;          ///< to a question about each motion
  using Kept = Record<n, Layout::kept>;            ///< the motion in memory

  /// The motion as it is kept; of several, those from number `from` on.
  ELEMENTARY_INLINE Course(const System& of, const Kept& kept, unsigned from = 0) : of_(of), from_(from)
  {
    for(unsigned k = 0; k < n; ++k)
    {
      x_[k] = Layout::load(kept.x[k] + from_);
      x_lost_[k] = Layout::load(kept.x_lost[k] + from_);
      v_[k] = Layout::load(kept.v[k] + from_);
      v_lost_[k] = Layout::load(kept.v_lost[k] + from_);
      F_[k] = Layout::load_stages(kept.forces[k], from_);
    }
    t_ = Layout::load(kept.t + from_);
    t_lost_ = Layout::load(kept.t_lost + from_);
    step_ = Layout::load(kept.step + from_);
    last_step_ = Layout::load(kept.last_step + from_);
    trouble_ = Layout::load(kept.trouble + from_);
    refused_ = Layout::load(kept.refused + from_);
  }

  /// Keeps it.
  ELEMENTARY_INLINE void keep(Kept& kept) const
  {
    for(unsigned k = 0; k < n; ++k)
    {
      Layout::save(kept.x[k] + from_, x_[k]);
      Layout::save(kept.x_lost[k] + from_, x_lost_[k]);
      Layout::save(kept.v[k] + from_, v_[k]);
      Layout::save(kept.v_lost[k] + from_, v_lost_[k]);
      Layout::save_stages(kept.forces[k], from_, F_[k]);
    }
    Layout::save(kept.t + from_, t_);
    Layout::save(kept.t_lost + from_, t_lost_);
    Layout::save(kept.step + from_, step_);
    Layout::save(kept.last_step + from_, last_step_);
    Layout::save(kept.trouble + from_, trouble_);
    Layout::save(kept.refused + from_, refused_);
  }

  /// Carries it on by whole steps as long as none leads beyond `until`, or, `exactly`, to that moment by a last step as
  /// long as is left.
  ELEMENTARY_INLINE void advance(const Number& until, bool exactly, Effort& effort)
  {
    for(;;)
    {
      const Number left = (until - t_) - t_lost_;
      const Answer whole = step_ <= left;
      Answer going = whole & (refused_ <= Number(0.0));
      if(exactly)
        going = (Number(0.0) < left) & (refused_ <= Number(0.0));
      if(!any(going))
        return;
      attempt(going, select(whole, step_, left), effort);
    }
  }

private:
  static constexpr unsigned angles = angles_of<System>;

  // The angles at the stages in an earlier sweep, and their sines and cosines.
  struct Turned
  {
    Stages from[angles + 1], sine[angles + 1], cosine[angles + 1];  // one more, for there may be none
  };

  const System& of_;
  unsigned from_;
  Number x_[n], x_lost_[n], v_[n], v_lost_[n];
  Number t_, t_lost_, step_, last_step_, trouble_, refused_;
  Stages F_[n];  // of the last step

  // The polynomial of the last step goes on through a step h; before the first step the accelerations are those at the
  // start.
  ELEMENTARY_INLINE void guess(const Number& h, Stages (&G)[n]) const
  {
    namespace number = coefficients;
    const Answer begun = Number(0.0) < last_step_;
    const Number ratio = h / select(begun, last_step_, Number(1.0));
    const Stages at = Stages(Number(1.0)) + Stages(ratio) * Layout::table(number::c);
    Stages before[8];  // Π (at − cₘ) for m < j
    before[0] = Stages(Number(1.0));
    for(unsigned j = 1; j < 8; ++j)
      before[j] = before[j - 1] * (at - Stages(Number(number::c[j - 1])));
    Number f[n][8];
    for(unsigned k = 0; k < n; ++k)
    {
      split(F_[k], f[k]);
      G[k] = Stages(Number(0.0));
    }
    Stages behind = Stages(Number(1.0));
    for(unsigned j = 8; j-- > 0;)
    {
      const Stages weight = before[j] * behind * Stages(Number(number::w[j]));
      for(unsigned k = 0; k < n; ++k)
        G[k] = G[k] + weight * Stages(f[k][j]);
      behind = behind * (at - Stages(Number(number::c[j])));
    }
    if(any(!begun))
    {
      Stages x[n], v[n], first[n];
      for(unsigned k = 0; k < n; ++k)
      {
        x[k] = Stages(x_[k]);
        v[k] = Stages(v_[k]);
      }
      Turned turned;
      forces(driven(of_, Stages(t_)), x, v, begun, true, turned, first);
      for(unsigned k = 0; k < n; ++k)
        G[k] = select(begun, G[k], first[k]);
    }
  }

  // One sweep: from the accelerations the velocities and places at the stages, and from these the accelerations.
  ELEMENTARY_INLINE void sweep(const Number& h, const Stages& drive, const Stages& of_step,
                               const Stages (&F)[n], const Answer& busy, bool anew, Turned& turned,
                               Stages (&G)[n]) const
  {
    Stages x[n], v[n];
    const Stages h_of_all(h);
    Integrals<Stages> of_F[n];
    if constexpr(Layout::pieces > 1)
      integrals(F, of_F);
    for(unsigned k = 0; k < n; ++k)
    {
      if constexpr(Layout::pieces == 1)
        of_F[k] = integrals(F[k]);
      v[k] = Stages(v_[k]) + h_of_all * of_F[k].once;
      const Stages drift = of_step * Stages(v_[k]);
      x[k] = Stages(x_[k]) + (drift + (h_of_all * h_of_all) * of_F[k].twice);
    }
    forces(drive, x, v, busy, anew, turned, G);
  }

  // The accelerations at all stages. Sines and cosines are found `anew`, or turned on from those of an earlier sweep of
  // this step, unless all stages of a motion together have come farther than 2⁻⁸ from there.
  ELEMENTARY_INLINE void forces(const Stages& drive, const Stages (&x)[n], const Stages (&v)[n],
                                const Answer& busy, bool anew, Turned& turned, Stages (&a)[n]) const
  {
    Answer stale = busy;
    bool renewed = anew;
    if constexpr(angles > 0)
      if(!anew)
      {
        Stages off = magnitude(x[0] - turned.from[0]);
        for(unsigned k = 1; k < angles; ++k)
          off = off + magnitude(x[k] - turned.from[k]);
        stale = !(sum(off) <= Number(0x1p-8));
        renewed = any(stale & busy);
      }
#pragma GCC unroll 1
    for(unsigned j = 0; j < Layout::pieces; ++j)
    {
      Piece at[n], rate[n], acceleration[n];
      for(unsigned k = 0; k < n; ++k)
      {
        at[k] = piece(x[k], j);
        rate[k] = piece(v[k], j);
      }
      if constexpr(angles > 0)
      {
        elementary::SineCosine<Piece> now[angles];
        for(unsigned k = 0; k < angles; ++k)
        {
          Piece &from = piece(turned.from[k], j), &sine = piece(turned.sine[k], j),
                &cosine = piece(turned.cosine[k], j);
          if(renewed)
          {
            now[k] = sincos(at[k]);
            from = anew ? at[k] : select(stale, at[k], from);
            sine = anew ? now[k].sine : select(stale, now[k].sine, sine);
            cosine = anew ? now[k].cosine : select(stale, now[k].cosine, cosine);
          }
          if(!anew)
            now[k] = turned_on<Piece>({sine, cosine}, at[k] - from);
        }
        System::accelerations(of_, piece(drive, j), at, now, rate, acceleration);
      }
      else
        System::accelerations(of_, piece(drive, j), at, rate, acceleration);
      for(unsigned k = 0; k < n; ++k)
        piece(a[k], j) = acceleration[k];
    }
  }

  ELEMENTARY_INLINE static Number size_of(const Stages (&F)[n])
  {
    Stages all = magnitude(F[0]);
    for(unsigned k = 1; k < n; ++k)
      all = all + magnitude(F[k]);
    return sum(all);
  }

  ELEMENTARY_INLINE static Number coefficient(const Stages (&F)[n], const double* weights)
  {
    Number size = magnitude_of(sum(F[0] * Layout::table(weights)));
    for(unsigned k = 1; k < n; ++k)
      size = size + magnitude_of(sum(F[k] * Layout::table(weights)));
    return size;
  }

  // Solves the equations of a step by repetition. Converged is what changes no more, but for rounding, or, where the
  // tolerance is coarse, for 2⁻¹⁸ of it.
  ELEMENTARY_INLINE Answer solved(const Answer& going, const Number& h, Stages (&F)[n],
                                  Effort& effort) const
  {
    constexpr double noise = 0x1p-44, rounding = 0x1p-54;
    const double rest = select(effort.tolerance <= 0x1p-36, rounding, 0x1p-18 * effort.tolerance);
    constexpr int most = 60;
    const Stages of_step = Stages(h) * Layout::table(coefficients::c);
    const Stages drive = driven(of_, Stages(t_) + (of_step + Stages(t_lost_)));
    Answer busy = going, good = going;
    Number before(0.0);
    Turned turned;
    for(int count = 1; any(busy); ++count)
    {
      ++effort.sweeps;
      Stages G[n], change[n];
      sweep(h, drive, of_step, F, busy, count == 1, turned, G);
      for(unsigned k = 0; k < n; ++k)
        change[k] = G[k] - F[k];
      const Number changed = size_of(change), size = size_of(G);
      for(unsigned k = 0; k < n; ++k)
        F[k] = select(busy, G[k], F[k]);
      const Answer smaller = changed <= Number(0.5) * before;
      const Answer settled = changed * changed <= Number(rest) * (size * before);
      const Answer quiet = (!smaller) & (changed <= Number(noise) * size);
      const Answer done = count == 1 ? changed <= Number(0.0) : (settled & smaller) | quiet;
      const Answer failing =
          (count > 3 ? !(changed <= Number(0.7) * before) : !(changed <= Number(HUGE_VAL))) & !done;
      good = good & !(busy & failing);
      busy = busy & !done & !failing;
      if(count == most)
      {
        good = good & !busy;
        busy = busy & !busy;
      }
      before = changed;
    }
    return good;
  }

  ELEMENTARY_INLINE void attempt(const Answer& going, const Number& h, Effort& effort)
  {
    namespace number = coefficients;
    Stages F[n];
    guess(h, F);
    const Answer converged = solved(going, h, F, effort);

    // the error of the step, by the last coefficients
    const Number zero(0.0), size = Number(0.125) * size_of(F);
    const Number seventh = coefficient(F, number::seventh),
                 sixth = Number(0.25) * coefficient(F, number::sixth);
    const Number last = select(seventh <= sixth, sixth, seventh);
    Number speed = h * size;
    for(unsigned k = 0; k < n; ++k)
      speed = speed + magnitude_of(v_[k]);
    const Number scale = size * speed;
    const Number error =
        select(zero < scale, h * (last * last) / select(zero < scale, scale, Number(1.0)), zero);
    const Number tolerance(effort.tolerance);
    const Answer accepted = converged & (error <= tolerance);
    const Answer rejected = going & !accepted;

    // The common case, a step that was good and that is followed by one as long, waits for none of this.
    if(any(accepted))
    {
      const Answer first = last_step_ <= zero;
      const Number fading = Number(0.9) * trouble_;
      const Number trouble = select(first, error, select(fading <= error, error, fading));
      const Answer easy = Number(0x1p5) * trouble <= tolerance,
                   idle = Number(0x1p18) * trouble <= tolerance;
      const Answer longer = accepted & easy & !(h < step_);
      if(any(longer))
        step_ = select(longer, trimmed(h * select(idle, Number(2.0), Number(1.1875))), step_);
      trouble_ = select(accepted, trouble, trouble_);
      commit(accepted, h, F);
      ++effort.steps;
    }
    if(any(rejected))
    {
      const Number floor(0x1p-200);
      const Number room = tolerance / select(floor <= error, error, floor);
      const Number factor = Number(0.9) * root(root(root(root(room))));
      const Number held =
          select(factor <= Number(0.25), Number(0.25), select(factor <= Number(0.8), factor, Number(0.8)));
      step_ = select(rejected, trimmed(h * select(converged, held, Number(0.5))), step_);
      trouble_ = select(rejected, tolerance, trouble_);
      const Answer hopeless =
          rejected & ((step_ <= Number(0x1p-40) * magnitude_of(t_)) | (step_ <= Number(0x1p-900)));
      refused_ = select(hopeless, Number(1.0), refused_);
      ++effort.rejected;
    }
  }

  // Where F leads to in a step of h.
  ELEMENTARY_INLINE void commit(const Answer& accepted, const Number& h, const Stages (&F)[n])
  {
    namespace number = coefficients;
    for(unsigned k = 0; k < n; ++k)
    {
      const Number gained =
          h * (sum(F[k] * Layout::table(number::b)) + sum(F[k] * Layout::table(number::b_lost)));
      const Number bent =
          (h * h) * (sum(F[k] * Layout::table(number::d)) + sum(F[k] * Layout::table(number::d_lost)));
      const auto drift = elementary::product_of(h, v_[k]);
      const auto x = elementary::sum_of(x_[k], drift.value);
      const Number x_rest = (x.lost + drift.lost) + (bent + (h * v_lost_[k] + x_lost_[k]));
      const auto x_new = elementary::ordered_sum(x.value, x_rest);
      const auto v = elementary::sum_of(v_[k], gained);
      const auto v_new = elementary::ordered_sum(v.value, Number(v.lost + v_lost_[k]));
      x_[k] = select(accepted, x_new.value, x_[k]);
      x_lost_[k] = select(accepted, x_new.lost, x_lost_[k]);
      v_[k] = select(accepted, v_new.value, v_[k]);
      v_lost_[k] = select(accepted, v_new.lost, v_lost_[k]);
      F_[k] = select(accepted, F[k], F_[k]);
    }
    const auto t = elementary::sum_of(t_, h);
    const auto t_new = elementary::ordered_sum(t.value, Number(t.lost + t_lost_));
    t_ = select(accepted, t_new.value, t_);
    t_lost_ = select(accepted, t_new.lost, t_lost_);
    last_step_ = select(accepted, h, last_step_);
  }
};
}  // namespace COLLOCATION_REGISTERS
}  // namespace collocation
