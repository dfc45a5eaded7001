/// @file
/// What the C library's names of the elementary functions mean in a program that is linked with names.cpp: the functions
/// of nearest.hpp, except while something is timed.
#pragma once

namespace elementary
{

/// While one lives, the names mean the C library's own functions again, so that what is timed takes the time that it would
/// take in a reader's program. Elsewhere than in a program with names.cpp it changes nothing, nor in the page, which times
/// nothing. Not for several threads.
class Plain_names
{
public:
  Plain_names();   ///< From now on.
  ~Plain_names();  ///< As before.
  Plain_names(const Plain_names&) = delete;
  Plain_names& operator=(const Plain_names&) = delete;

  /// Whether one lives.
  static bool asked();

private:
  bool before_;
};

}  // namespace elementary
