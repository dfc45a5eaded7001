/// @file
/// The elementary functions rounded to the nearest double, with the same bits on every machine.
///
/// What circular.hpp has is swifter. These err by half a unit in the last place and a part of it that cannot be seen: they
/// are summed to about 2⁻⁷³, so that one argument in some hundred thousand may give the other neighbour, the same one
/// everywhere; exact results are exact. Sine and cosine take twice the C library's time, the others ten to thirty times.
/// Measured against fifty digits in tests/elementary.cpp. Domains, zeros, infinities and NaN are C's. In a program that is
/// linked with names.cpp they are what the C library's names mean.
#pragma once

/// The nearest double, everywhere the same.
namespace elementary::nearest
{

double sin(double x);  ///< x in radians, of any size; NaN for ±∞
double cos(double x);  ///< x in radians, of any size; NaN for ±∞
double tan(double x);  ///< x in radians, of any size; NaN for ±∞

double asin(double x);             ///< from −½π to ½π; NaN outside [−1, 1]
double acos(double x);             ///< from 0 to π; NaN outside [−1, 1]
double atan(double x);             ///< from −½π to ½π
double atan2(double y, double x);  ///< the angle of the point (x, y), from −π to π

double exp(double x);    ///< eˣ
double exp2(double x);   ///< 2ˣ
double expm1(double x);  ///< eˣ − 1
double log(double x);    ///< NaN below 0, −∞ at 0
double log2(double x);   ///< as log
double log10(double x);  ///< as log
double log1p(double x);  ///< log (1 + x); NaN below −1, −∞ there

double pow(double x, double y);    ///< xʸ
double cbrt(double x);             ///< ∛x
double hypot(double x, double y);  ///< √(x² + y²), without overflow between

double sinh(double x);   ///< ½(eˣ − e⁻ˣ)
double cosh(double x);   ///< ½(eˣ + e⁻ˣ)
double tanh(double x);   ///< sinh x/cosh x
double asinh(double x);  ///< log (x + √(x² + 1))
double acosh(double x);  ///< log (x + √(x² − 1)); NaN below 1
double atanh(double x);  ///< ½ log ((1 + x)/(1 − x)); NaN outside [−1, 1], ±∞ at its ends

}  // namespace elementary::nearest
