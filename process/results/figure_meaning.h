// Units and descriptions of the figures of a run, by name.
#pragma once

#include <string>
#include <utility>

namespace diefill::results {

/// Unit and description of a figure. Figures that are not known take the unit from the end of their name,
/// such as
/// `_kg` or `_seconds`; without one they are plain numbers ("1").
/// Those of smaller cavities, such as `cavity_2_fill_ratio`, mean what the name behind the number says.
std::pair<const char*, const char*> figure_meaning(const std::string& full_name);

/// True for figures that count things and are whole numbers in report.json.
bool counts(const std::string& name);

}  // namespace diefill::results
