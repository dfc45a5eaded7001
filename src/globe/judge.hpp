/// @file
/// A motion with friction in fifty digits, by Newton's equations alone: what a Path is judged by.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "exact/ode.hpp"
#include "globe/path.hpp"

namespace globe::oracle
{

/// What the ball does from one change to the next.
struct Stretch
{
  exact::Fifty from;          ///< when it begins
  Mode mode;                  ///< what the ball does
  State<exact::Fifty> start;  ///< the state in which it begins
};

/// The stretch in which the time t ≥ 0 lies; `motion` as Judge::stretches() gives it.
const Stretch& stretch_at(const std::vector<Stretch>& motion, const exact::Fifty& t);

/// Newton's equations with friction. Of a motion it is told the start alone. It goes on by steps, half of the time in
/// which the ball turns by a radian or would swing, and looks at the end of each whether the ball may do what it is
/// taken to do, and in between by the cubic that has the values and the slopes of what must be positive: so a change
/// that is made and undone within a step is seen, too. Where it may not, there is a change, which it finds by halving
/// the step and at last by Newton's method.
///
/// Source: accelerations() and rolling_accelerations() of G, integrated by exact::solve(). Good to 17 digits.
class Judge
{
public:
  /// Domain: as Path.
  Judge(const Ball<exact::Fifty>& ball, const exact::Fifty& g, const exact::Fifty& mu)
      : ball_(ball), g_(g), mu_(mu)
  {
  }

  /// The motion from a state at t = 0 to a given time, or till the ball is off the plane or so many changes have
  /// happened. Throws std::runtime_error where two changes lie nearer to each other than it can tell apart.
  std::vector<Stretch> stretches(const State<exact::Fifty>& start, const exact::Fifty& end,
                                 std::size_t most_changes = 1000) const;

  /// The state so long after another, or before it; the ball does the same all the while.
  State<exact::Fifty> after(const State<exact::Fifty>& from, Mode mode, const exact::Fifty& time) const;

  /// The state at the time t ≥ 0 of a motion.
  State<exact::Fifty> at(const std::vector<Stretch>& motion, const exact::Fifty& t) const;

  /// What must be positive as long as the ball does this: of one that scrapes, how fast it does; of one that
  /// rolls, μΠ less the friction backwards and forwards (over P); and last what holds it down, 1 + cww cos Φ/2g.
  std::array<exact::Fifty, 3> margins(const State<exact::Fifty>& at, Mode mode) const;

  /// The energy over the mass, as Path::energy().
  exact::Fifty energy(const State<exact::Fifty>& at) const;

private:
  exact::State forwards(const exact::State& G, Mode mode) const;
  State<exact::Fifty> in_a_moment(const State<exact::Fifty>& from, Mode mode,
                                  const exact::Fifty& time) const;
  Mode without_slip(const State<exact::Fifty>& at) const;
  bool may(const State<exact::Fifty>& from, const State<exact::Fifty>& to, Mode mode,
           const exact::Fifty& time) const;
  exact::Fifty longest_step(const State<exact::Fifty>& at) const;
  std::optional<Stretch> next(const State<exact::Fifty>& now, Mode mode, const exact::Fifty& soon) const;
  exact::State of_G(const State<exact::Fifty>& at) const;
  State<exact::Fifty> of_contact(const exact::State& G, Mode mode) const;

  Ball<exact::Fifty> ball_;
  exact::Fifty g_, mu_;
};

}  // namespace globe::oracle
