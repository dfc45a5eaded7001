/// @file
/// The teller: with this a section declares, once, who it is, what the reader may change, what it says,
/// what Euler or our copy of him has wrong, and what is checked. The command line, the text, the JSON, the
/// figures' data, the tests and the page all follow from that. How a section is written stands in
/// `book/authoring.md`.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "edition/apparatus.hpp"
#include "edition/compare.hpp"
#include "edition/doctest.hpp"
#include "edition/parameter.hpp"
#include "edition/tell.hpp"
#include "edition/told.hpp"

/// Names the section that this file is.
#define SECTION(chapter, number, title)                                                                    \
  static const edition::Identity edition_identity{#chapter, number, title};

/// Opens a block in which the section says something. A section may have several, one idea each; they
/// are told in their order.
#define TELL EDITION_TELL(__COUNTER__)
/// @cond
#define EDITION_TELL(count) EDITION_TELL_COUNTED(count)
#define EDITION_TELL_COUNTED(count) EDITION_TELL_NAMED(edition_tell_##count, edition_telling_##count)
#define EDITION_TELL_NAMED(body, registration)                                                             \
  [[gnu::cold]] static void body();                                                                        \
  static const edition::Telling registration{&(body)};                                                     \
  static void body()
/// @endcond

/// Opens a check: a doctest case whose name is a statement.
#define CHECK_THAT(statement) [[gnu::cold]] TEST_CASE(statement)

using namespace edition;  // a section's file speaks the edition's language
