/// @file
/// The face that a section shows to a page: many sections in one program, each asked by name, with what the
/// reader wrote for its parameters; the answers are JSON.
#pragma once

#include <string>

namespace live
{

/// What the section of program `name` (`pendulum-11`) tells with `given`, a JSON object of parameter names
/// and what was written for them: `{"told": as --json, "text": as without, "data": {file name: its
/// content}}`, the curves only where those of `figures` are wanted. Refused input gives `{"refused": the
/// sentence that the program would say}`; a section that this program has not, or a fault in it, `{"failed": why}`.
std::string tell(const std::string& name, const std::string& given, bool figures);

/// The data with the frames of the section's scenes, without those of its figures: `{"data": ...}`, or as
/// tell() where that cannot be said.
std::string frames(const std::string& name, const std::string& given);

/// What came of the section's checks with `given`: `{"checked": as --check --json}`, or as tell() where
/// that cannot be said.
std::string check(const std::string& name, const std::string& given);

}  // namespace live
