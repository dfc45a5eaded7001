/// @file
/// What a section has declared and told, as the program's faces (text, JSON, data, checks, races) see it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "edition/scene.hpp"
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
  Range range;     ///< In the program's unit.
  Fifty exact_lo;  ///< The ends of the range as they are written.
  Fifty exact_hi;  ///< See exact_lo.
  std::string meaning;
  bool logarithmic;      ///< Whether a hand that slides it wants a logarithmic scale.
  Fifty exact_default;   ///< In the program's unit.
  double default_shown;  ///< In `unit`.
  Default usual{0};      ///< As it was declared.

  Fifty exact;        ///< In the program's unit: radians for an angle.
  double value;       ///< `exact`, rounded.
  double shown;       ///< In `unit`.
  std::string given;  ///< What the reader wrote; empty if nothing.

  bool read = false;  ///< Whether its number was asked for since this was last made false.
};

/// A value as told, in the program's unit.
struct ToldValue
{
  std::string name;
  std::variant<double, long long, std::string> number;
  Fifty exact;       ///< The number with all its digits; zero for a text.
  std::string text;  ///< The number with more digits than a double has, or as a fraction; empty if neither.
  Unit unit;
  std::string meaning;
  int digits;  ///< Significant digits that are shown.
};

/// Data of a figure: tab-separated lines, empty unless data were asked for.
struct ToldCurve
{
  std::string name;
  std::vector<std::string> columns;
  std::string lines;
  std::vector<std::vector<double>> points;
};

/// A scene: the bodies that are drawn by the curve of its name.
struct ToldScene
{
  std::string name;
  std::vector<Body> bodies;
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
  double spread;   ///< Half the distance of the ratio's quartiles, relative to it; NaN unless timed.
};

/// Several ways to one number.
struct ToldRace
{
  std::string name;
  std::string quantity;
  Fifty exact;
  std::vector<ToldMethod> methods;
};

/// What a telling came to.
struct Said
{
  std::vector<ToldValue> values;
  std::vector<std::shared_ptr<Table>> tables;
  std::vector<ToldCurve> curves;
  std::vector<ToldScene> scenes;
  std::vector<ToldRace> races;
  std::vector<std::pair<std::string, std::string>> illustrations;  ///< What no claim looks at, and why.
  bool has_data = false;                                           ///< Whether all curves were drawn.
};

/// What this run is asked for beyond the telling itself.
struct Wanted
{
  bool figures = false;  ///< The curves.
  bool scenes = false;   ///< The frames of scenes, which are curves too.
  bool timing = false;
};

/// A TELL block, and what it told last: what it would tell again while the parameters that it read are what they were.
struct Block
{
  /// A parameter that was read, and what it was.
  struct Read
  {
    std::size_t index;
    Fifty exact;
    double value;
  };

  void (*body)();
  std::optional<Wanted> with =
      {};  ///< What it was asked for; nothing where it has not told, or with times.
  std::vector<Read> read = {};
  Said told = {};
};

/// A section of this program.
struct Section
{
  std::string chapter;
  int number = 0;
  std::string title;
  std::vector<std::string> faults;  ///< What was declared wrongly, with its place.
  std::vector<ParameterEntry> parameters;
  std::vector<Entry> apparatus;
  std::vector<Block> telling;  ///< The TELL blocks, in the file's order.
  Wanted wanted;
  Said said;  ///< What was told last.

  /// `pendulum.11`
  std::string id() const;
  /// `pendulum-11`
  std::string program() const;
  /// `pendulum/s11.cpp`
  std::string file() const;
};

/// The sections of this program, in the order in which their files were begun. A section's own program has one.
std::vector<std::unique_ptr<Section>>& sections();
/// The section that declarations, parameters and tellings concern now: the one begun last, until choose().
Section& section();
/// Makes `s` that section.
void choose(Section& s);

/// Takes what the reader wrote for parameter `p`: a finite number in range, else BadInput.
void set_parameter(ParameterEntry& p, const std::string& text);
/// Gives parameter `p` its default again.
void reset_parameter(ParameterEntry& p);
/// What parameter `p` may be, in words.
std::string allowed(const ParameterEntry& p);
/// Makes ζ and η agree once both have been read; BadInput if the reader contradicts himself.
void reconcile_amplitude(Section& s);
/// Gives all parameters their defaults but for these, by name; BadInput if one is unknown or refused.
void set_parameters(Section& s, const std::vector<std::pair<std::string, std::string>>& given);

/// Has the section tell: what it said before is forgotten. A block runs again only where a parameter that it read
/// last time is another now, or more curves are wanted.
void tell_anew(Section& s, Wanted wanted);

/// Tells a curve, which is drawn where that is `wanted`.
void add_curve(const char* name, std::vector<std::string> columns, const Rule<void(Curve&)>& draw,
               bool wanted);

/// A number of the program's unit in `unit`.
double in_unit(double x, const Unit& unit);
/// A cell in its column's unit.
Cell in_unit(const Cell& cell, const Column& column);
/// A number with up to `digits` significant digits, as text and tables show it.
std::string show(double x, int digits);
/// A number with its unit behind it.
std::string with_unit(std::string number, const Unit& unit);
/// Someone's words as they can stand on one line: controls and broken bytes escaped, the middle of long ones
/// left out.
std::string on_one_line(const std::string& words);
/// The entry's kind, as text and JSON call it.
const char* name_of(Kind kind);
/// Whether a name may stand for a parameter, a value, a table or a column: a letter, then letters, digits and _.
bool is_name(const std::string& name);

/// The section's text, as a person reads it.
std::string as_text(const Section& s);
/// The section as JSON (`book/schema/section.json`).
std::string as_json(const Section& s);
/// The races alone, as a person reads them.
std::string races_as_text(const Section& s);
/// Tables and the curves that were wanted, as tab-separated files: name and content.
std::vector<std::pair<std::string, std::string>> data_files(const Section& s);
/// Writes data_files() into `folder`, each complete or not at all; returns their paths one a line. Throws
/// std::runtime_error when it cannot.
std::string write_data(const Section& s, const std::string& folder);

/// What the claims of a check run have looked at.
struct Looked
{
  std::set<std::size_t> cases;          ///< The checks, from 1.
  std::map<std::string, int> settings;  ///< How many claims at each setting.
  bool infinite = false;                ///< Whether it was claimed to be infinite.
};
/// By name: `T_over_Theta`, `rows.ratio` (also of a curve), `period/AGM`, `period/exact`.
using Coverage = std::map<std::string, Looked>;

/// A limit that require() sets, as a check run has met it: the parameters of the settings on its two sides.
struct Limit
{
  /// One parameter at a setting.
  struct At
  {
    Fifty exact;
    bool given;
  };
  /// A setting that was refused, and the parameter, by its index, that the refusal names.
  struct Refusal
  {
    std::size_t named;
    std::vector<At> at;
  };

  std::map<std::string, std::vector<At>> kept;  ///< By setting.
  std::map<std::string, Refusal> refused;       ///< By setting.
};
/// Where a require() stands: file and line.
using Place = std::pair<std::string, unsigned>;

/// Keeps that the setting of the check run under way was on this side of the limit, where there is such a run.
void meet_limit(const Source& place, bool kept, std::size_t named);
/// Whether a limit was met on both sides: at two settings, one kept, one refused, that differ in the parameter which
/// the refusal names and in no other, by a hundredth of it at the most (a whole number by one, and what is
/// below 1e-9 by as much).
bool both_sides(const Limit& limit);
/// What is missing of a limit that was not met on both sides, in words.
std::string one_sided(const Place& place, const Limit& limit);

/// One check run's memory of what was told at which setting, and looked at.
struct Ledger
{
  bool running = false;              ///< Whether checks are being run.
  std::vector<ParameterEntry> own;   ///< The reader's parameters.
  std::map<Place, Limit> limits;     ///< What require() was asked.
  std::map<std::string, Said> said;  ///< By setting.
  Coverage coverage;
  std::string setting;           ///< Where the claims now being made are made.
  std::size_t current_case = 0;  ///< The check that now runs, from 1.
};
/// The ledger of the check run under way.
Ledger& ledger();
/// What is told at the defaults and no claim looks at enough, in words.
std::vector<std::string> uncovered(Section& s);

/// Runs the checks, with arguments for doctest, and says what came of them as text or JSON.
struct CheckResult
{
  bool passed;
  std::string report;
};
CheckResult run_checks(Section& s, const std::vector<std::string>& doctest_arguments, bool json);

/// What main() does: answers the command line, and returns the exit status.
int run(int argc, char** argv);

}  // namespace edition
