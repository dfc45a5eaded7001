/// @file
/// What a section says: values, tables, the data of its figures, races of several ways to one number.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "edition/parameter.hpp"
#include "edition/rule.hpp"
#include "exact/rational.hpp"

namespace edition
{

using exact::Rational;

/// Tells a value: a real number in `unit` (the number itself is in the program's unit), an integer, a
/// text, a fraction, or fifty digits. Its `name` is what the prose calls it by. `digits` is how many of a
/// real number are shown: no more than are true.
/// @{
void tell(const char* name, double value, Unit unit, const char* meaning, int digits = 12);
inline void tell(const char* name, double value, const char* meaning, int digits = 12)
{
  tell(name, value, none, meaning, digits);
}
void tell(const char* name, int value, const char* meaning);
void tell(const char* name, long long value, const char* meaning);
void tell(const char* name, const std::string& value, const char* meaning);
void tell(const char* name, const char* value, const char* meaning);
void tell(const char* name, const Fifty& value, const char* meaning, int digits = 30);
void tell(const char* name, const Rational& value, const char* meaning);
/// @}

/// A cell of a table.
using Cell = std::variant<double, long long, std::string>;

/// A column: its name in the data, its heading, its unit, and how many significant digits are shown.
struct Column
{
  std::string name;     ///< In the data.
  std::string heading;  ///< On the page.
  Unit unit = none;     ///< In which both show it.
  int digits = 6;       ///< Significant digits shown; the data have all.
};

/// A table under way; made by table().
class Table
{
public:
  /// An empty one.
  Table(std::string name, std::string caption, std::vector<Column> columns);
  /// Adds a row, one cell a column (in the program's unit); another number of cells, or a line break or a tab
  /// in one, throws std::logic_error.
  /// @{
  void row(std::initializer_list<Cell> cells);
  void row(std::vector<Cell> cells);
  /// @}

  std::string name;                     ///< What the prose and the data call it by.
  std::string caption;                  ///< What stands above it.
  std::vector<Column> columns;          ///< From left to right.
  std::vector<std::vector<Cell>> rows;  ///< In the program's units.
};

/// Tells a table; the reference is good to the end of the TELL block.
Table& table(const char* name, const char* caption, std::vector<Column> columns);

/// The data of a figure under way; made by curve().
class Curve
{
public:
  /// Without any points yet; one name a column.
  explicit Curve(std::vector<std::string> columns);
  /// Adds a point, one number a column, written with 17 digits; another number of them throws
  /// std::logic_error.
  /// @{
  void put(std::initializer_list<double> numbers);
  void put(const std::vector<double>& numbers);
  /// @}
  /// Breaks the line here: what follows is drawn as a line of its own.
  void gap();
  /// Begins a new block (gnuplot's `index`), for several lines in one file; it has its own header, as
  /// gnuplot expects.
  void block();

  /// The lines so far, tab separated, without the first header.
  const std::string& text() const { return text_; }
  /// The points so far.
  const std::vector<std::vector<double>>& points() const { return points_; }

private:
  std::vector<std::string> columns_;
  std::vector<std::vector<double>> points_;
  std::string text_;
};

/// Declares data for a figure; `draw` is called, at once, only when data are asked for.
void curve(const char* name, std::vector<std::string> columns, const Rule<void(Curve&)>& draw);

/// One way to a number. Methods of one `family` (a series with more and more terms, say) are joined by
/// a line in the plot.
struct Method
{
  std::string name;         ///< What it is called in the plot and the table.
  Rule<double()> evaluate;  ///< The number, computed anew at each call.
  std::string family = {};  ///< Empty for a method that stands alone.
};

/// Sets several ways to one number side by side: the error of each in ulps of the 50-digit value
/// `exact` at the parameters as they were written, and with `--bench` its time. `exact` must be finite and
/// not zero.
void race(const char* name, const char* quantity, const Fifty& exact, const std::vector<Method>& methods);

/// Declares that no check looks at something that is told, and why: the name of a value or of a curve,
/// `table.column`, `race/method`. The page shows the reason.
void illustration(const char* name, const char* reason);

/// Registers who the section is; made by SECTION.
struct Identity
{
  /// What the file declares from here on is this section's.
  Identity(const char* chapter, int number, const char* title, Source source = here());
};

/// Registers what the section says; made by TELL.
struct Telling
{
  /// `body` is called when the program tells.
  explicit Telling(void (*body)());
};

}  // namespace edition

// Compiled once, not by every section.
extern template class std::vector<edition::Column>;
extern template class std::vector<edition::Method>;
