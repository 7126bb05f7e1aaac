// Figures that comparisons of filling strategies give (`diefill compare`), too long for the laboratory: read
// from sample_tools/laboratory/comparisons.csv, with the command that gives each again.
#pragma once

#include <filesystem>
#include <vector>

#include "process/laboratory/published/published_figure.h"
#include "process/results/studies/lab_table.h"

namespace diefill::process::laboratory {

/// The figures in `file` (columns id, value in the unit of the published figure, d in mm, command) as a table
/// of size "compared"; empty where the file is missing. Throws SceneError, naming the line, for a file that
/// is wrong, or an id that no published figure has.
results::LabTable compared_figures(const std::filesystem::path& file,
                                   const std::vector<PublishedFigure>& figures);

}  // namespace diefill::process::laboratory
