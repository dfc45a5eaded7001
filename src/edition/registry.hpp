/// @file
/// What a section has declared and told, as the program's faces (text, JSON, data, checks, races) see it.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "edition/section.hpp"

namespace edition
{

/// Input that the program refuses: one line for standard error, exit status 2.
struct BadInput : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A parameter as declared, and its value in this run.
struct ParameterEntry
{
  enum class Type
  {
    real,
    integer,
    angle
  };

  std::string name;
  Type type;
  Unit unit;
  Range range;           ///< In the program's unit.
  double default_shown;  ///< In `unit`.
  std::string meaning;
  double value;         ///< In the program's unit: radians for an angle.
  double shown;         ///< In `unit`.
  bool shown_is_exact;  ///< True where `shown` is the number and `value` its rounding.
  std::string given;    ///< What the reader wrote; empty if nothing.
};

/// A value as told. `number` is in `unit`.
struct ToldValue
{
  std::string name;
  std::variant<double, long long, std::string> number;
  std::string digits;  ///< More digits than a double has, where the value has them.
  Unit unit;
  std::string meaning;
};

/// Data of a figure: tab-separated lines, empty unless data were asked for.
struct ToldCurve
{
  std::string name;
  std::vector<std::string> columns;
  std::string lines;
};

/// One way to a number, with its error and, where the race was run, its time.
struct ToldMethod
{
  std::string name;
  std::string family;
  double value;
  double ulps;
  double relative;
  double seconds;  ///< Median time of an evaluation; NaN unless timed.
  double ratio;    ///< Median over rounds of its time against the first method's; NaN unless timed.
};

/// Several ways to one number.
struct ToldRace
{
  std::string name;
  std::string quantity;
  std::string exact;
  std::vector<ToldMethod> methods;
};

/// What this run is asked for beyond the telling itself.
struct Wanted
{
  bool data = false;
  bool timing = false;
};

/// The section of this program.
struct Section
{
  std::string chapter;
  int number = 0;
  std::string title;
  std::vector<ParameterEntry> parameters;
  std::vector<Entry> apparatus;
  bool has_amplitude = false;
  std::vector<void (*)()> telling;  ///< The TELL blocks, in the file's order.
  Wanted wanted;

  std::vector<ToldValue> values;
  std::vector<std::unique_ptr<Table>> tables;
  std::vector<ToldCurve> curves;
  std::vector<ToldRace> races;

  /// `pendulum.11`
  std::string id() const;
  /// `pendulum-11`
  std::string program() const;
};

/// The one section of this program, filled while its file's objects are constructed and while it tells.
Section& section();

/// Takes what the reader wrote for parameter `p`: a finite number in range, else BadInput.
void set_parameter(ParameterEntry& p, const std::string& text);
/// What parameter `p` may be, in words.
std::string allowed(const ParameterEntry& p);
/// Makes ζ and η agree once both have been read; BadInput if the reader contradicts himself.
void reconcile_amplitude(Section& s);

/// A number with up to `digits` significant digits, as text and tables show it.
std::string show(double x, int digits);
/// A number with its unit behind it.
std::string with_unit(std::string number, const Unit& unit);
/// The entry's kind, as text and JSON call it.
const char* name_of(Kind kind);

/// The section's text, as a person reads it.
std::string as_text(const Section& s);
/// The section as JSON (`book/schema/section.json`).
std::string as_json(const Section& s);
/// The races alone, as a person reads them.
std::string races_as_text(const Section& s);
/// Writes tables and curves as TSV files into `folder`, each complete or not at all; returns their
/// paths one a line. Throws std::runtime_error when it cannot.
std::string write_data(const Section& s, const std::string& folder);

/// Runs the checks, with arguments for doctest, and says what came of them as text or JSON.
struct CheckResult
{
  bool passed;
  std::string report;
};
CheckResult run_checks(const Section& s, const std::vector<std::string>& doctest_arguments, bool json);

}  // namespace edition
