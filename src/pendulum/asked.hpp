/// @file
/// How a reader may ask for a place of a descent, and what of it is refused.
#pragma once

#include "edition/section.hpp"

namespace pendulum
{

/// Refuses, by its name, a ψ that does not exceed η, where the descent begins, by 10⁻³⁰ of η: of less, the fifty
/// digits of both would leave too few.
inline void require_descent(const edition::Parameter<double>& psi, const edition::Parameter<double>& eta)
{
  edition::require(psi.fifty() >= eta.fifty() * (1 + exact::Fifty("1e-30")), "psi",
                   "greater than eta, where the descent begins, by at least 1e-30 of it");
}

/// Settings on either side of that limit, for the checks.
/// @{
inline constexpr const char* descended[] = {"eta=60 psi=60.000000000000000000000000000061",
                                            "eta=1rad psi=1.000000000000000000000000000001rad",
                                            "eta=1e-200rad psi=1.0000000000000000000000000000101e-200rad"};
inline constexpr const char* hardly_descended[] = {
    "eta=60 psi=60.000000000000000000000000000059",
    "eta=1e-200rad psi=1.00000000000000000000000000000099e-200rad"};
/// @}

}  // namespace pendulum
