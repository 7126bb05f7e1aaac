// What experiments measure that has no published value: kept from earlier runs in one CSV file beside the
// page of fidelity, and written as a page of its own. A later run of an experiment replaces its own rows
// only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/results/studies/lab_table.h"

namespace diefill::process::laboratory {

/// Names of the file and of the page.
inline constexpr const char *kOtherFigures = "other_figures.csv", *kOtherFiguresPage = "OTHER_FIGURES.md";

struct OtherFigure {
  std::string experiment;
  std::string size;     ///< "coarse", "medium" or "published"
  results::LabRow row;  ///< with a value
};

/// All of `file`; none where it is missing. Throws SceneError, naming the line, for a file that is wrong.
std::vector<OtherFigure> read_other_figures(const std::filesystem::path& file);

/// Takes values of `measured` over in place of those of the same or a coarser size. Figures that an
/// experiment of that size no longer measures are dropped.
void take_over(std::vector<OtherFigure>& kept, const std::vector<results::LabTable>& measured);

/// The file's text: experiment, size, id, quantity, unit, values of the seeds, d in mm, core seconds.
std::string csv_of(const std::vector<OtherFigure>& kept);

/// The page in Markdown, a table for each experiment, in the order of the registry.
std::string other_figures_page(const std::vector<OtherFigure>& kept);

}  // namespace diefill::process::laboratory
