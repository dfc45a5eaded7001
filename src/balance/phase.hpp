/// @file
/// Frequencies that are sums of others, and sines of their product with a time, without what rounding would take.
#pragma once

#include "elementary/circular.hpp"
#include "exact/fifty.hpp"

namespace balance
{

/// A frequency, and what it was rounded by.
template <class Number>
struct Rate
{
  Number value;   ///< the leading part
  Number lost{};  ///< what it lacks
};

/// The frequencies p + q as they are.
/// @{
inline Rate<double> together(double p, double q)
{
  const auto sum = elementary::sum_of(p, q);
  return {sum.value, sum.lost};
}
inline Rate<exact::Fifty> together(const exact::Fifty& p, const exact::Fifty& q)
{
  return {p + q, 0};
}
/// @}

/// sin and cos of rate·t + from, the product not being rounded: to a unit or two in the last place of 1 for every phase
/// below 2⁵³.
/// @{
inline elementary::SineCosine<double> phase(const Rate<double>& rate, double t, double from = 0)
{
  const auto product = elementary::product_of(rate.value, t);
  const auto sum = elementary::sum_of(product.value, from);
  const double rest = sum.lost + (product.lost + rate.lost * t);
  const auto [s, c] = elementary::sincos(sum.value);
  const auto [sine, cosine] = elementary::sincos(rest);  // up to ½ for the greatest phases
  return {s * cosine + c * sine, c * cosine - s * sine};
}
inline elementary::SineCosine<exact::Fifty> phase(const Rate<exact::Fifty>& rate, const exact::Fifty& t,
                                                  const exact::Fifty& from = 0)
{
  const exact::Fifty x = rate.value * t + from;
  return {sin(x), cos(x)};
}
/// @}

/// sin(½ rate·t)/(½ rate·t), and 1 at 0.
template <class Number>
Number sinc_of_half(const Rate<Number>& rate, const Number& t)
{
  const Rate<Number> half{rate.value / 2, rate.lost / 2};
  const Number x = half.value * t;
  return x == 0 ? Number(1) : phase(half, t).sine / x;
}

/// What an oscillator of the frequency q does that is driven by cos pt and at rest at t = 0, by q + p and q − p:
/// (cos pt − cos qt)/(q² − p²), and its limit where q and p agree.
template <class Number>
Number driven_by(const Rate<Number>& sum, const Rate<Number>& difference, const Number& t)
{
  return t * t / 2 * sinc_of_half(sum, t) * sinc_of_half(difference, t);
}

}  // namespace balance
