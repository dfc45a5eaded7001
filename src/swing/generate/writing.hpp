/// @file
/// Arrays of numbers written as C++.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "exact/fifty.hpp"

namespace generate
{

/// As hexadecimal, so that nothing is rounded.
std::string hex(double x);

/// Each as the nearest double.
std::vector<double> rounded(const std::vector<exact::Fifty>& c);

/// log₂ of an error, for the comments.
std::string bits(const exact::Fifty& error);

/// An array with its comment.
void write_array(std::FILE* out, const std::string& name, const std::string& comment,
                 const std::vector<double>& c);

}  // namespace generate
