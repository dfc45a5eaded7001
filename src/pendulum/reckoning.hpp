/// @file
/// A reckoning on paper, line by line: what our copy has, what a calculator with a table finds, and what
/// is true.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "edition/section.hpp"
#include "pendulum/logarithms.hpp"
#include "pendulum/three_members.hpp"

namespace pendulum
{

/// One line of a reckoning.
struct Line
{
  const char* what;      ///< what it is the number of
  std::string printed;   ///< as our copy has it
  std::string reckoned;  ///< as honest work with a seven-place table gives it
  exact::Fifty truth;    ///< as it should be
};

/// Tells the lines as the table `name`; his numbers and their verdicts are left out unless the
/// parameters are `his` own.
inline void tell_lines(const char* name, const char* caption, const std::vector<Line>& lines, bool his)
{
  auto& rows = edition::table(name, caption,
                              {{"what", "what"},
                               {"printed", "our copy has"},
                               {"reckoned", "reckoned"},
                               {"true", "true", edition::none, 10},
                               {"verdict", "what it has is"}});
  for(const Line& l : lines)
    rows.row({l.what, his ? l.printed : "", l.reckoned, static_cast<double>(l.truth),
              his ? verdict(l.printed, l.reckoned, l.truth) : ""});
}

// [last_members]
/// Euler's reckoning of the second and the third member of his time (§§32, 36), cos α l 2 and ¾ sin²α
/// times that, beside his eight lines, of which the first is what he starts from.
/// Domain: 0 < α < π/2, radians.
inline std::vector<Line> last_members(const exact::Fifty& alpha, const std::array<const char*, 8>& printed)
{
  const exact::Fifty ln_two("0.6931472"), cosine = cos(alpha), quarters = 0.75, square = pow(sin(alpha), 2);
  const auto truth = three_members(alpha, 1);
  const SevenPlaces twice = 2 * SevenPlaces::of(sin(alpha));
  const SevenPlaces second = SevenPlaces::as_written(printed[0]) + SevenPlaces::of(cosine);
  const SevenPlaces third = second + SevenPlaces::of(quarters) + twice;
  return {{"l 0,6931472", printed[0], SevenPlaces::of(ln_two).text(), augmented_logarithm(ln_two)},
          {"l cos α", printed[1], SevenPlaces::of(cosine).text(), augmented_logarithm(cosine)},
          {"l member II", printed[2], second.text(), augmented_logarithm(truth.second)},
          {"member II", printed[3], rounded(second.number(), 5), truth.second},
          {"l ¾", printed[4], SevenPlaces::of(quarters).text(), augmented_logarithm(quarters)},
          {"l sin²α", printed[5], twice.text(), augmented_logarithm(square)},
          {"l member III", printed[6], third.text(), augmented_logarithm(truth.third)},
          {"member III", printed[7], rounded(third.number(), 5), truth.third}};
}
// [last_members]

}  // namespace pendulum
