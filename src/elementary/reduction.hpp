/// @file
/// An angle less its quarter turns, for any double.
#pragma once

#include "elementary/circular.hpp"

namespace elementary::circular
{

/// x less so many quarter turns, to some 2⁻⁷⁵ of what is left; NaN where x is not finite.
Reduced<double> reduced_any(double x);

}  // namespace elementary::circular
