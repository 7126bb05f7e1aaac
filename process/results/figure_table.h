// The figures of a run: name, meaning, unit, label and format. Everything that writes, lists, compares or
// draws figures reads them here.
#pragma once

#include <span>
#include <string>
#include <utility>

#include "process/results/fill_result.h"

namespace diefill::results {

/// Unit and digits in which a value is shown.
struct ShownAs {
  const char* unit;   ///< such as "g" or "kg/m^3"; "1" for plain numbers
  double factor;      ///< from the stored value to `unit`
  int digits;         ///< significant ones, where no scatter says otherwise
  double period = 0;  ///< in `unit`, after which an angle repeats; 0: not periodic
};

/// One figure. `*` in `name` and `label` stands for the name of an item of the scene, such as a heap.
struct Figure {
  const char* name;     ///< in report.json and results.h5; scripts read it, so it does not change
  const char* unit;     ///< of the stored value
  const char* meaning;  ///< how it is computed, in a line
  const char* label;    ///< in rows of tables and in sentences: "filled mass of model powder"
  ShownAs shown;
  bool compared = false;              ///< `diefill compare` judges variants by it
  const char* short_label = nullptr;  ///< over columns and at axes, where the label is too long
  const char* other_name = nullptr;   ///< its name in report.json for any cavity but the largest
};

/// All figures; those that are compared are in the order of comparison.json. A new one is a line in
/// figure_table.cpp.
std::span<const Figure> figure_table();

/// The entry of a figure; null for figures that are unknown. Those of smaller cavities, such as
/// `cavity_2_fill_ratio`, have the entry of the name after the number.
const Figure* find_figure(const std::string& name);

/// The same for names in the program's own source. Throws std::out_of_range for unknown ones.
const Figure& figure_called(const std::string& name);

/// A unit, and what numbers in the shown unit are divided by to be in it.
struct StoredAs {
  std::string unit;
  double divisor;
};

/// From numbers of the figure `name` in `shown_unit` to those that report.json has under this name. Those of
/// other names, or in a unit in which the figure is not shown, stay as they are.
StoredAs stored_as(const std::string& name, const std::string& shown_unit);

/// The text with its first letter as a capital.
std::string capitalised(std::string text);

/// Label with a capital, for rows of tables.
std::string title_of(const Figure& figure);

/// Label for columns and axes: the short one where there is one.
std::string short_label(const Figure& figure);

/// Label of a figure that belongs to the item `thing` of the scene, such as "slope of heap".
std::string label_of(const Figure& figure, const std::string& thing);

/// The figure of that name in its stored unit; NaN where the result has none. Mean and standard deviation of
/// the solid fraction are those of the summary.
double figure_of(const FillResult& result, const std::string& name);

/// Unit and meaning of a figure. Unknown ones, as of files of other versions, take the unit from the end of
/// their name, such as `_kg` or `_seconds`; without one they are plain numbers ("1").
std::pair<const char*, const char*> figure_meaning(const std::string& name);

/// True for counts, which are whole numbers in report.json.
bool counts(const std::string& name);

}  // namespace diefill::results
