/// @file
/// The best approximation by a sum of given functions, found with fifty digits.
#pragma once

#include <functional>
#include <vector>

#include "exact/fifty.hpp"

namespace generate
{

using exact::Fifty;

/// What is to be approximated at one point: the target and each function of the basis, all weighted alike.
struct Sample
{
  std::vector<Fifty> basis;  ///< the functions of the basis there
  Fifty target;              ///< what they are to make together
};

/// A linear combination of the basis and the largest weighted error that it makes on the samples.
struct Fit
{
  std::vector<Fifty> coefficients;  ///< of the functions, in their order
  Fifty error;                      ///< the largest on the samples
};

/// Remez' exchange on the given samples, which must be ordered by their abscissa and lie densely: the
/// combination whose largest error is the smallest possible. Throws std::runtime_error when the error does
/// not level out.
Fit minimax(const std::vector<Sample>& samples);

/// The polynomial c₀ + c₁x + … of degree n − 1 through n points. The abscissae must differ.
std::vector<Fifty> through(const std::vector<Fifty>& x, const std::vector<Fifty>& y);

/// A quotient of polynomials.
struct Quotient
{
  std::vector<Fifty> above;  ///< the coefficients of the numerator
  std::vector<Fifty> below;  ///< those of the denominator, the first being 1
};

/// The quotient of polynomials of degree n that agrees with f at 2n + 1 of Tchebychef's points of the
/// interval from a to b: very nearly the best there. Both are polynomials in x − centre.
Quotient rational(const std::function<Fifty(const Fifty&)>& f, int n, const Fifty& a, const Fifty& b,
                  const Fifty& centre);

/// The value of the polynomial c₀ + c₁x + …
Fifty value(const std::vector<Fifty>& c, const Fifty& x);

/// The n zeros of Tchebychef's polynomial of degree n on the interval from a to b.
std::vector<Fifty> tchebychef_points(int n, const Fifty& a, const Fifty& b);

}  // namespace generate
