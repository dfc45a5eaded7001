#pragma once
/** @file
 * How a claim shows series and polynomials: by their first terms.
 */
#include "edition/compare.hpp"
#include "exact/series.hpp"

#include <string>

namespace edition
{

/// The first three terms that are not zero, of those from x to the power `lowest` to that of `highest`, and
/// how many follow: "1 + 1/2 x^2 + -1/8 x^4 + 5 more".
template <class Coefficients>
std::string first_terms(const Coefficients& c, int lowest, int highest)
{
  std::string shown;
  int terms = 0;
  for(int n = lowest; n <= highest; ++n)
  {
    if(c[n] == decltype(c[n])(0) || ++terms > 3)
      continue;
    const std::string factor = doctest::toString(c[n]).c_str();
    const bool simple = factor.find(' ') == std::string::npos;
    if(terms > 1)
      shown += " + ";
    shown += simple ? "" : "(";
    shown += factor;
    shown += simple ? "" : ")";
    if(n != 0)
      shown += " x";
    if(n != 0 && n != 1)
      shown.append("^").append(std::to_string(n));
  }
  if(terms > 3)
    shown.append(" + ").append(std::to_string(terms - 3)).append(" more");
  return terms == 0 ? "0" : shown;
}

}  // namespace edition

/// @cond
template <class Coefficient>
struct doctest::StringMaker<exact::Series<Coefficient>>
{
  static doctest::String convert(const exact::Series<Coefficient>& s)
  {
    return edition::first_terms(s, 0, s.degree()).c_str();
  }
};
template <class Coefficient>
struct doctest::StringMaker<exact::Laurent<Coefficient>>
{
  static doctest::String convert(const exact::Laurent<Coefficient>& s)
  {
    return edition::first_terms(s, s.lowest(), s.highest()).c_str();
  }
};
/// @endcond
