/// @file
/// doctest, with assertions that are one call each. Its usual ones are written out at every place, each with a handler of
/// exceptions, and of a section's program they were a quarter; an exception that a check meets ends that check all the
/// same, and is told.
#pragma once

#define DOCTEST_CONFIG_SUPER_FAST_ASSERTS
#include <doctest/doctest.h>
