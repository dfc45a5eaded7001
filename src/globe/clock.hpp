/// @file
/// The pendulum that goes with the ball: with the same h it stands at the ball's own angle, only the clock runs
/// unevenly. Its time υ is the argument of the elliptic functions, sin ½Φ = √h sn υ, or sn √h υ of 1/√h.
#pragma once

#include <functional>
#include <stdexcept>

#include "globe/energy.hpp"
#include "swing/motion.hpp"

namespace globe
{

/// Throws std::invalid_argument unless two arrays are of one length.
inline void require_equal(std::size_t one, std::size_t other)
{
  if(one != other)
    throw std::invalid_argument("the arrays differ in length");
}

/// υ from the lowest place to rest, or to the top.
double pendulum_quarter(const Energy<double>& e);
/// The same in fifty digits.
exact::Fifty pendulum_quarter(const Energy<exact::Fifty>& e);

/// That over ½π, less one. h < 1.
double pendulum_excess(const Energy<double>& e);

/// A place as the pendulum's argument.
template <class Real>
struct Pendulum_place
{
  Real sn;             ///< sin ½Φ over its greatest value
  Real cn;             ///< the cosine of the same angle
  Real upsilon;        ///< υ
  bool never = false;  ///< the top, just reached: υ is infinite
};

/// Throws std::domain_error where the ball does not get.
template <class Real>
Pendulum_place<Real> pendulum_place(const Energy<Real>& e, const Place<Real>& place);

/// The pendulum's motion, asked where it is when another clock shows a time.
class Clock
{
public:
  /// For any energy.
  explicit Clock(const Energy<double>& e);

  /// Where the pendulum is.
  struct Reading
  {
    double upsilon;       ///< υ, within the first quarter
    Place<double> place;  ///< the angle
    double sn;            ///< as in Pendulum_place
    double cn;            ///< as in Pendulum_place
  };
  /// The other clock's time there, and its derivative by υ, which is above 0.
  struct Rate
  {
    double time;        ///< from the lowest place
    double derivative;  ///< by υ
  };

  /// Where the pendulum is when the other clock shows `tau`, which takes `quarter` for a quarter. By Newton's
  /// method in υ, kept between bounds. Throws std::domain_error unless |tau| is below 10⁹ quarters; where
  /// those are infinite, unless the ball is more than 10⁻³⁰⁰ from the top.
  Turned at(double tau, double quarter, const std::function<Rate(const Reading&)>& rate) const;

private:
  Reading reading(double upsilon) const;

  Energy<double> e_;
  swing::Motion motion_;
  double quarter_;
};

}  // namespace globe
