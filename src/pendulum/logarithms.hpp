/// @file
/// Reckoning as it was done with a table of logarithms of seven places, so that every line that Euler
/// prints in his two examples (§§30–36) can be done again exactly as he did it.
#pragma once

#include <string>

#include "exact/fifty.hpp"

namespace pendulum
{

// [SevenPlaces]
/// A common logarithm as a table of seven places has it, in whole ten-millionths. What is below zero is
/// written with ten added, or as many tens as it takes.
class SevenPlaces
{
public:
  /// Looks a number up: its logarithm, rounded to seven places. Domain: x > 0, else std::domain_error.
  static SevenPlaces of(const exact::Fifty& x);

  /// The same with the further places cut off, not rounded.
  static SevenPlaces cut_off(const exact::Fifty& x);
  /// Takes a logarithm as it stands on the paper: "9,8408253". One with ten added counts as negative
  /// from 5 upwards.
  static SevenPlaces as_written(const std::string& text);

  /// Sums and whole multiples, exactly, as on paper.
  /// @{
  friend SevenPlaces operator+(SevenPlaces a, SevenPlaces b) { return SevenPlaces(a.units_ + b.units_); }
  friend SevenPlaces operator*(int n, SevenPlaces a) { return SevenPlaces(n * a.units_); }
  /// @}

  /// The number whose logarithm this is.
  exact::Fifty number() const;
  /// As Euler writes it: "9,9995865".
  std::string text() const;

private:
  explicit SevenPlaces(long long units) : units_(units) {}
  long long units_;
};
// [SevenPlaces]

/// The common logarithm, with tens added until it is not negative, unrounded: what a line of the reckoning
/// should be. Domain: x > 0.
exact::Fifty augmented_logarithm(const exact::Fifty& x);

/// A number with so many decimals, rounded, with Euler's comma: rounded(3.826746, 5) is "3,82675".
/// Domain: x ≥ 0, 0 ≤ places ≤ 12.
std::string rounded(const exact::Fifty& x, int places);
/// The same, with the further decimals cut off.
std::string truncated(const exact::Fifty& x, int places);

/// What is to be said of a printed decimal number (with comma), given what honest reckoning writes
/// there and the true number: "right" when the true number rounds to it; "as reckoned" when it does
/// not, but the reckoning gives just that; "last place" when it is off by at most two units of its last
/// place; else "wrong".
std::string verdict(const std::string& printed, const std::string& reckoned, const exact::Fifty& truth);

}  // namespace pendulum
