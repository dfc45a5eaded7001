/// @file
/// How a reader may ask: for an energy by h, by what it lacks of the top, or by the angular velocity ζ at the
/// lowest place; for a place by the angle from the lowest place or by what that lacks of the top.
#pragma once

#include <algorithm>

#include "edition/section.hpp"
#include "globe/energy.hpp"

namespace globe
{

/// The ball of the options --a, --c and --k.
inline Ball<exact::Fifty> exact_ball(const edition::Parameter<double>& a,
                                     const edition::Parameter<double>& c,
                                     const edition::Parameter<double>& k)
{
  return {a.fifty(), c.fifty(), k.fifty()};
}

/// The same in doubles: a − c keeps its digits, too.
inline Ball<double> rounded_ball(const edition::Parameter<double>& a, const edition::Parameter<double>& c,
                                 const edition::Parameter<double>& k)
{
  return rounded(exact_ball(a, c, k));
}

/// The options --h, --from_top and --zeta: the last that is given and not 0 counts, from_top before h.
struct Asked_energy
{
  edition::Parameter<double> h;         ///< The energy over what the top asks for.
  edition::Parameter<double> from_top;  ///< 1 − h, or 0
  edition::Parameter<double> zeta;      ///< The angular velocity at the lowest place, or 0.

  /// The option that counts, by its name.
  const char* given() const { return zeta != 0 ? "zeta" : from_top != 0 ? "from_top" : "h"; }
  /// What was asked for, with kk as in energy_of_velocity(). Refuses from_top and zeta together, and a ζ with an
  /// h beyond 1e-100 … 1e100.
  Energy<exact::Fifty> fifty(const exact::Fifty& c, const exact::Fifty& kk, const exact::Fifty& g) const
  {
    edition::require(zeta == 0 || from_top == 0, "zeta", "0 where from_top is given");
    if(zeta == 0)
      return energy_given(h.fifty(), from_top.fifty());
    Energy<exact::Fifty> e = energy_of_velocity(c, kk, g, zeta.fifty());
    edition::require(e.h >= exact::Fifty("1e-100"), "zeta", "an h between 1e-100 and 1e100");
    edition::require(e.h <= exact::Fifty("1e100"), "zeta", "an h between 1e-100 and 1e100");
    return e;
  }
  /// The same of a ball on a smooth plane, where kk is k k.
  Energy<exact::Fifty> smooth(const edition::Parameter<double>& c, const edition::Parameter<double>& k,
                              const edition::Parameter<double>& g) const
  {
    return fifty(c.fifty(), k.fifty() * k.fifty(), g.fifty());
  }
  /// And of one that rolls, where it is bb.
  Energy<exact::Fifty> rolling(const edition::Parameter<double>& a, const edition::Parameter<double>& c,
                               const edition::Parameter<double>& k,
                               const edition::Parameter<double>& g) const
  {
    return fifty(c.fifty(), bb(exact_ball(a, c, k)), g.fifty());
  }
};

/// Declares them.
inline Asked_energy asked_energy(double default_h)
{
  using namespace edition;
  return {real("h", default_h, none, scale, "energy, as a part of what the top asks for"),
          real("from_top", 0, none, from_below(-1e100, 1), "1 − h instead of h, where not 0"),
          real("zeta", 0, Unit{"1/s"}, closed(0, 1e100),
               "angular velocity at the lowest place instead of h, where not 0")};
}

/// Settings on either side of the limits of ζ for a ball that rolls, for the checks.
/// @{
inline constexpr const char* rolling_within[] = {
    "from_top=0.5", "zeta=1.0000000000000001e-50 a=2 c=1 k=1 g=0.25", "zeta=1e50 a=2 c=1 k=1 g=0.25"};
inline constexpr const char* rolling_beyond[] = {"from_top=0.5 zeta=1e-9",
                                                 "zeta=9.999999999999999e-51 a=2 c=1 k=1 g=0.25",
                                                 "zeta=1.0000000000000002e50 a=2 c=1 k=1 g=0.25"};
/// @}

/// The options --Phi and --psi: the second counts where it is not 0.
struct Asked_place
{
  edition::Parameter<double> Phi;  ///< The angle from the lowest place.
  edition::Parameter<double> psi;  ///< What it lacks of the top, or 0.

  /// What was asked for: the place. 180°, to 33 digits, is the other end: nearer to it fifty digits would leave
  /// too few of what an angle lacks of it, and the other option tells that.
  Place<exact::Fifty> fifty() const
  {
    const auto all = [](const exact::Fifty& x) { return exact::pi() - x < 1e-33; };
    if(psi != 0)
      return all(psi.fifty()) ? place(exact::Fifty(0)) : place_from_top(psi.fifty());
    return all(Phi.fifty()) ? place_from_top(exact::Fifty(0)) : place(Phi.fifty());
  }
  /// And the angle.
  exact::Fifty angle() const { return psi == 0 ? Phi.fifty() : exact::Fifty(exact::pi() - psi.fifty()); }
};

/// Declares them.
inline Asked_place asked_place(double default_Phi)
{
  using namespace edition;
  return {angle("Phi", default_Phi, closed(0, std::numbers::pi), "angle turned from the lowest place"),
          angle("psi", 0, closed(0, std::numbers::pi), "180° − Phi instead of Phi, where not 0")};
}

/// Refuses a ball that the functions of rolling.hpp do not take: a or c beyond 10²⁰ √((a − c)² + kk).
inline void require_rolling(const Ball<double>& ball)
{
  edition::require(std::max(ball.a, ball.c) <= 1e20 * std::hypot(ball.gap, ball.k), "k",
                   "at least 1e-20 c where c is a");
}

}  // namespace globe
