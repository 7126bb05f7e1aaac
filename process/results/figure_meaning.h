// Units and descriptions of the figures of a run, by name.
#pragma once

#include <string>
#include <utility>

namespace diefill::results {

/// Unit and description of a figure. Figures that are not known take the unit from the end of their name,
/// such as
/// `_kg` or `_seconds`; without one they are plain numbers ("1").
std::pair<const char*, const char*> figure_meaning(const std::string& name);

/// True for figures that count things and are whole numbers in report.json.
bool counts(const std::string& name);

}  // namespace diefill::results
