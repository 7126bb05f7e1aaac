// Published figures that families of experiments without scenes have: as tables, and those kept in the tree.
#pragma once

#include <filesystem>
#include <vector>

#include "process/laboratory/published/published_figure.h"
#include "process/results/studies/experiment_result.h"
#include "process/results/studies/lab_table.h"

namespace diefill::process::laboratory {

/// The figures of one experiment, called "<experiment>_figures", with range and verdict. Throws
/// std::out_of_range for an id that is not published.
results::LabTable table_of_figures(const results::ExperimentResult& result,
                                   const std::vector<PublishedFigure>& published);

/// The tables in <laboratory>/<family>/<experiment>_figures.json, by name. Throws results::ResultError for
/// one that cannot be read.
std::vector<results::LabTable> family_tables(const std::filesystem::path& laboratory);

}  // namespace diefill::process::laboratory
