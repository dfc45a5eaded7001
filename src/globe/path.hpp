/// @file
/// The way of the ball with Coulomb's friction: it scrapes, rolls and leaves the plane, each as long as it must.
///
/// While it scrapes forwards λ is μ, backwards −μ; it rolls where that asks for no more than |λ| ≤ μ; and where
/// the pressure would vanish it is off the plane, where a Path ends, for of impacts the paper says nothing.
///
/// Each stretch is integrated by Taylor series whose length and steps are chosen so that what they lack is less
/// than the rounding; what ends a stretch is then a root of a polynomial. `Real` is double or exact::Fifty.
#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include "exact/fifty.hpp"
#include "globe/ball.hpp"

namespace globe
{

/// The coefficients of a Taylor series in the time. With so many a step may be a fifth of the radius of convergence in
/// double, a seventh in fifty digits.
template <class Real>
using Series = std::array<Real, std::is_same_v<Real, double> ? 26 : 66>;

/// What the ball does.
enum class Mode
{
  scraping_forwards,   ///< ds > a dΦ: friction acts backwards
  scraping_backwards,  ///< ds < a dΦ: friction acts forwards
  rolling,             ///< ds = a dΦ
  off                  ///< not on the plane
};

/// Where the ball is, and how it moves.
template <class Real>
struct State
{
  Real s;     ///< IS, the place of contact
  Real slip;  ///< ds/dt − a dΦ/dt, the velocity of scraping, given by itself since it may be small
  Real Phi;   ///< the angle, all turns counted
  Real w;     ///< dΦ/dt
};

/// Something that changes what the ball does.
template <class Real>
struct Event
{
  Real t;             ///< when
  Mode mode;          ///< what it does from then on
  State<Real> state;  ///< where
  Real energy;        ///< (xx' + yy' + kk ww)/2 + 2g y, over the mass
};

/// The motion from a state at t = 0 to a given time, or till it ends.
template <class Real>
class Path
{
public:
  /// Follows the motion till t = end, or the ball is off the plane, or so many events have happened.
  /// Domain: a, c, k, g > 0, end ≥ 0, and 0 ≤ μ < painleve(ball).mu, below which the scraping is determined at
  /// every angle; else std::domain_error. Error in double: events to 10⁻¹³ of the time after the first ones;
  /// whatever the motion itself makes of a rounding is added.
  Path(const Ball<Real>& ball, const Real& g, const Real& mu, const State<Real>& start, const Real& end,
       std::size_t most_events = 1000);

  /// What the ball does at t = 0, and all changes, in order.
  const std::vector<Event<Real>>& events() const { return events_; }

  /// The state at a time from 0 to ended(), else std::domain_error.
  State<Real> at(const Real& t) const;

  /// What it does at a time: the mode since the last event.
  Mode mode(const Real& t) const;

  /// The last time that is told.
  const Real& ended() const { return now_; }

  /// The energy over the mass.
  Real energy(const State<Real>& state) const;

  /// What friction has taken of it till a time from 0 to ended(), else std::domain_error: the work of friction, a sum of
  /// what is not negative, and so with its digits where hardly anything is lost. Error: 10⁻¹³ of it,
  /// in fifty digits, too, since the nodes are doubles.
  /// Source: the integral of λΠ over the way scraped, by Gauss's rule with sixteen nodes to a step.
  Real lost(const Real& t) const;

private:
  // A step: from when, what the ball does, and the series of Φ, w, s and the slip in what has passed since.
  struct Step
  {
    Real start;
    Mode mode;
    Series<Real> Phi, w, s, slip;
  };

  void enter(Mode mode, const State<Real>& state);
  Mode choose(const State<Real>& state) const;
  State<Real> advance(const State<Real>& state, Mode mode, const Real& end, Mode& next);
  Real taken(const Step& step, const Real& time) const;

  Ball<Real> ball_;
  Real g_, mu_, now_ = 0;
  std::vector<Event<Real>> events_;
  std::vector<Step> steps_;
};

extern template class Path<double>;
extern template class Path<exact::Fifty>;

}  // namespace globe
