/// @file
/// What the text that the edition is made from has wrong, or seems to: each place with its proof.
#pragma once

#include <string>
#include <type_traits>

#include "edition/rule.hpp"

namespace edition
{

/// What stands in a text at some place, and the number that comes of it when it is taken at its word.
struct Reading
{
  /// The words, and the number, or what computes it when it is wanted.
  /// @{
  template <class Yield>
  requires std::is_arithmetic_v<Yield> Reading(const char* words, Yield value)
      : text(words), yields(constant(static_cast<double>(value)))
  {
  }
  template <class Yield>
  requires std::is_invocable_r_v<double, Yield> Reading(const char* words, Yield compute)
      : text(words), yields(compute)
  {
  }
  /// @}

  std::string text;       ///< The words.
  Rule<double()> yields;  ///< The number.

private:
  static Rule<double()> constant(double value);
};

/// Whose slip it is.
enum class Kind
{
  erratum,     ///< Euler's own, or his printer's.
  emendation,  ///< Our copy's: the right reading is certain.
  doubtful,    ///< Wrong, but whether Euler, the printer or our copy is to blame cannot be told.
  undecided    ///< Which of two readings is meant cannot be told.
};

/// Whether the account of the section refers to an entry at its place.
enum class Shown
{
  at_its_place,  ///< The prose has `{{entry NAME}}` where the reading stands.
  not_there      ///< The place itself is not shown on the page.
};
/// For an entry whose place the page does not show.
inline constexpr Shown not_shown = Shown::not_there;

/// An entry of the apparatus: a place, what our copy has there, what is right, and the proof, a function
/// of the number that a reading yields. The proof must fail with what the copy has and with readings that
/// are neither (the right number changed by a sixteenth of itself, doubled, with the other sign), and hold
/// with what is right; for an undecided reading it must hold with both, and fail with one of the others. The programs' checks try all of them.
struct Entry
{
  Kind kind;                 ///< Whose slip it is.
  std::string where;         ///< The place, section first.
  Reading copy;              ///< What stands there; of two possible readings, the one.
  Reading right;             ///< What should; of two possible readings, the other.
  std::string because;       ///< The proof in words.
  Rule<bool(double)> holds;  ///< The proof.
  Shown shown;               ///< Whether the account refers to it.
};

/// An Entry of one kind, declared as an object of the section's file, in whose apparatus it is then.
template <Kind kind_of_entry>
struct EntryOf
{
  /// See Entry.
  EntryOf(const char* where, Reading copy, Reading right, const char* because, Rule<bool(double)> holds,
          Shown shown = Shown::at_its_place);
};
extern template struct EntryOf<Kind::erratum>;
extern template struct EntryOf<Kind::emendation>;
extern template struct EntryOf<Kind::doubtful>;
extern template struct EntryOf<Kind::undecided>;
/// The four kinds, as a section declares them.
/// @{
using Erratum = EntryOf<Kind::erratum>;
using Emendation = EntryOf<Kind::emendation>;
using Doubtful = EntryOf<Kind::doubtful>;
using Undecided = EntryOf<Kind::undecided>;
/// @}

}  // namespace edition
