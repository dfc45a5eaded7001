/// @file
/// What more than one section judges a reading by.
#pragma once

#include "edition/section.hpp"

namespace globe
{

/// Whether a ratio of friction to pressure can be the one of §§4 and 24: by §27 a ball rolls without danger when
/// S + a exceeds 3c, and needs c/(S + a) for it, so that the plane must have as much; our copy's half is the
/// greatest that is in question.
inline bool lets_roll_what_is_safe(double ratio)
{
  const double c = 0.1, S_and_a = 3.001 * c;
  return ratio == edition::between(c / S_and_a, 0.5, "not less than is needed, nor above a half");
}

}  // namespace globe
