/// @file
/// A reckoning on paper, line by line: what is printed, what a calculator with a table finds, and what
/// is true.
#pragma once

#include <string>
#include <vector>

#include "edition/section.hpp"
#include "pendulum/logarithms.hpp"

namespace pendulum
{

/// One line of a reckoning.
struct Line
{
  const char* what;      ///< what it is the number of
  const char* printed;   ///< as Euler prints it
  std::string reckoned;  ///< as honest work with a seven-place table gives it
  exact::Fifty truth;    ///< as it should be
};

/// Tells the lines as the table `name`; the printed numbers and their verdicts are left out unless the
/// parameters are `his` own.
inline void tell_lines(const char* name, const char* caption, const std::vector<Line>& lines, bool his)
{
  auto& rows = edition::table(name, caption,
                              {{"what", "what"},
                               {"printed", "printed"},
                               {"reckoned", "reckoned"},
                               {"true", "true", edition::none, 10},
                               {"verdict", "what is printed is"}});
  for(const Line& l : lines)
    rows.row({l.what, his ? l.printed : "", l.reckoned, static_cast<double>(l.truth),
              his ? verdict(l.printed, l.reckoned, l.truth) : ""});
}

}  // namespace pendulum
