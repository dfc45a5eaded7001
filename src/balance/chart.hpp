/// @file
/// Half a period of the beam at many points of the stability chart, by power series: the loops that are compiled for each
/// instruction set.
///
/// Mathieu's equation y″ + (a − 2q cos 2z) y = 0 has polynomial coefficients in x = sin² z, and its two solutions there
/// are power series whose coefficients follow each from the two before. They are summed at z = ¼π, x = ½, for q and for
/// −q; the other half of the way to z = ½π is the first half for −q, gone backwards. All is + − × in one order, for a
/// point alone and for points side by side.
#pragma once

#include <cstddef>

#include "balance/mathieu.hpp"
#include "collocation/eight.hpp"

namespace balance
{

/// The stability chart, by series.
namespace chart
{

constexpr int terms = 48;  ///< that are summed; those left out are below 2⁻⁵⁵ where halves() may be asked

/// What the next term is made with, from term n and the one before: (of_n − ½(a ∓ 2q) of_all) times the former less
/// ±q of_all times the latter; for the even and the odd solution.
struct Term
{
  double of_n[2];    ///< 2ν²/d with ν = n for the even, n + ½ for the odd
  double of_all[2];  ///< 1/d with d = (2n+1)(2n+2), or (2n+2)(2n+3)
  double weight[2];  ///< ν of the next, for the slope
};

/// A term for each step of the series.
struct Table
{
  Term of[terms];  ///< from the first
};

/// The terms.
constexpr Table table = [] {
  Table all{};
  for(int n = 0; n < terms; ++n)
    for(int odd = 0; odd < 2; ++odd)
    {
      const double twice_nu = 2.0 * n + odd, d = (twice_nu + 1) * (twice_nu + 2);
      all.of[n].of_n[odd] = twice_nu * twice_nu / (2 * d);
      all.of[n].of_all[odd] = 1 / d;
      all.of[n].weight[odd] = twice_nu / 2 + 1;
    }
  return all;
}();

inline namespace COLLOCATION_REGISTERS
{

/// A series under way.
template <class Real>
struct Series
{
  Real term;    ///< the last term
  Real before;  ///< the one before it
  Real sum;     ///< of the terms
  Real slope;   ///< of the terms, each by its ν

  /// The first term is 1, and ν is there 0 or ½.
  ELEMENTARY_INLINE explicit Series(const Real& nu) : term(Real{} + 1), before{}, sum(term), slope(nu) {}

  /// Adds the next.
  ELEMENTARY_INLINE void add(Real of_term, Real of_before, Real weight)
  {
    const Real next = of_term * term - of_before * before;
    before = term;
    term = next;
    sum = sum + next;
    slope = slope + weight * next;
  }
};

/// From the four series at z = ¼π what is wanted at ½π.
template <class Real>
ELEMENTARY_INLINE void put_together(Real even, Real even_slope, Real odd, Real odd_slope, Real even_back,
                                    Real even_back_slope, Real odd_back, Real odd_back_slope, Real& sine2,
                                    Real& cosine2)
{
  const Real y1 = odd_back_slope * even + odd_back * even_slope;
  const Real y1_slope = even_back_slope * even + even_back * even_slope;
  const Real y2 = odd_back_slope * odd + odd_back * odd_slope;
  const Real y2_slope = even_back_slope * odd + even_back * odd_slope;
  sine2 = -2 * (y1_slope * y2);
  cosine2 = 2 * (y1 * y2_slope);
}

/// One point: q and −q side by side.
inline void halves_of_one(double a, double q, Halves& result)
{
  using Two = double __attribute__((vector_size(16)));
  const Two q_of{q, -q};
  const Two less = 0.5 * a - q_of;
  Series<Two> even(Two{}), odd(Two{} + 0.5);
  for(const Term& of : table.of)
  {
    even.add(of.of_n[0] - less * of.of_all[0], q_of * of.of_all[0], Two{} + of.weight[0]);
    odd.add(of.of_n[1] - less * of.of_all[1], q_of * of.of_all[1], Two{} + of.weight[1]);
  }
  put_together(even.sum[0], even.slope[0], odd.sum[0], odd.slope[0], even.sum[1], even.slope[1], odd.sum[1],
               odd.slope[1], result.sine2, result.cosine2);
}

/// `count` points: as many side by side as a register holds, the four series one after the other.
inline void halves_of_many(const double* a, const double* q, Halves* result, std::size_t count)
{
  using collocation::width, collocation::Wide;
  for(std::size_t from = 0; from < count; from += width)
  {
    const std::size_t here = count - from < width ? count - from : width;
    Wide a_of{}, q_of{};
    for(std::size_t i = 0; i < here; ++i)
    {
      a_of[i] = a[from + i];
      q_of[i] = q[from + i];
    }
    const Wide less = 0.5 * a_of - q_of, less_back = 0.5 * a_of + q_of;
    Series<Wide> even(Wide{}), even_back(Wide{}), odd(Wide{} + 0.5), odd_back(Wide{} + 0.5);
    for(const Term& of : table.of)
    {
      const Wide q_even = q_of * of.of_all[0], q_odd = q_of * of.of_all[1];
      even.add(of.of_n[0] - less * of.of_all[0], q_even, Wide{} + of.weight[0]);
      even_back.add(of.of_n[0] - less_back * of.of_all[0], -q_even, Wide{} + of.weight[0]);
      odd.add(of.of_n[1] - less * of.of_all[1], q_odd, Wide{} + of.weight[1]);
      odd_back.add(of.of_n[1] - less_back * of.of_all[1], -q_odd, Wide{} + of.weight[1]);
    }
    Wide sine2, cosine2;
    put_together(even.sum, even.slope, odd.sum, odd.slope, even_back.sum, even_back.slope, odd_back.sum,
                 odd_back.slope, sine2, cosine2);
    for(std::size_t i = 0; i < here; ++i)
      result[from + i] = {sine2[i], cosine2[i]};
  }
}

}  // namespace COLLOCATION_REGISTERS
}  // namespace chart
}  // namespace balance
