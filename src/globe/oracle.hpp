/// @file
/// Times of the ball in fifty digits by quadrature alone: what the elliptic and spectral ways are judged by.
#pragma once

#include <functional>

#include "exact/fifty.hpp"
#include "globe/energy.hpp"

/// Judges that share nothing with what they judge.
namespace globe::oracle
{

/// On a smooth plane the time τ = t√(2gc) from the lowest place to another. c, k, h > 0, the place one that
/// the ball gets to; infinite at the top for h = 1. Good to 35 digits and more.
///
/// Source: the integral of §13 in y, where sin ½Φ is tanh y, or √h tanh y of a ball that rocks. The integrand
/// is flat until the ball is near its end and then falls as an exponential; tanh-sinh between its bends.
exact::Fifty smooth_time(const exact::Fifty& c, const exact::Fifty& k, const Energy<exact::Fifty>& e,
                         const Place<exact::Fifty>& place);

/// The time to rest, or over half a turn.
exact::Fifty smooth_quarter(const exact::Fifty& c, const exact::Fifty& k, const Energy<exact::Fifty>& e);

/// The inverse, within the first quarter: the place at the time τ, 0 ≤ τ. Good to 25 digits.
///
/// Source: the double's answer, put right by one step of Newton's method with smooth_time().
Place<exact::Fifty> smooth_place(const exact::Fifty& c, const exact::Fifty& k,
                                 const Energy<exact::Fifty>& e, const exact::Fifty& tau);

/// The same of the ball that rolls, a, c, k > 0, by the integral of §28.
/// @{
exact::Fifty rolling_time(const Ball<exact::Fifty>& ball, const Energy<exact::Fifty>& e,
                          const Place<exact::Fifty>& place);
exact::Fifty rolling_quarter(const Ball<exact::Fifty>& ball, const Energy<exact::Fifty>& e);
Place<exact::Fifty> rolling_place(const Ball<exact::Fifty>& ball, const Energy<exact::Fifty>& e,
                                  const exact::Fifty& tau);
/// @}

/// What Gauss's rule with n ≥ 1 nodes gives for the integral of f from a to b, in fifty digits.
exact::Fifty gauss(int n, const std::function<exact::Fifty(const exact::Fifty&)>& f, const exact::Fifty& a,
                   const exact::Fifty& b);

}  // namespace globe::oracle
