// Figures as a report labels and shows them: words, units and digits of results/figure_table.h in print.
#pragma once

#include <string>

#include "process/results/figure_table.h"
#include "process/results/fill_result.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// "Fill density of model powder": at the head of a row.
std::string row_title(const std::string& figure);

/// "Azimuthal variation: range over mean of the filled fraction of 12 sectors".
std::string explained(const std::string& figure);

/// "Fill ratio", "Full die": the short label, where the unit stands elsewhere.
std::string short_title(const std::string& figure);

/// "Fill height [mm]"; plain numbers have no brackets.
std::string column_title(const std::string& figure);

/// The same at an axis, where plain numbers have "[–]".
std::string axis_title(const std::string& figure);

/// The unit that a figure is shown in: "kg/m³", "°"; empty for plain numbers.
std::string unit_in_print(const std::string& figure);
std::string unit_in_print(const results::Figure& figure);

/// A value in the unit that the figure is shown in.
double in_shown_unit(const std::string& figure, double value);

/// "12.3 g" of a value in the figure's stored unit; "–" for NaN.
std::string shown(const std::string& figure, double value);

/// Adds a row with the run's value; none where the run has no such figure. An empty title is row_title().
void add_figure(Table& table, const results::FillResult& result, const std::string& figure,
                const std::string& title = {});

}  // namespace diefill::render::report
