// The page of all published figures: met, not met, or not measured yet and why. Made from kept tables alone.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "process/laboratory/published/published_figure.h"
#include "process/results/studies/lab_table.h"

namespace diefill::process::laboratory {

/// What has been tried on figures that are not met, by id. Throws SceneError as read_published_figures; empty
/// where the file is missing.
std::map<std::string, std::string> read_remarks(const std::filesystem::path& file);

/// The page in Markdown, one row for each figure. `tables` from coarse to fine: the last one that has a value
/// of a figure counts.
std::string fidelity_page(const std::vector<PublishedFigure>& figures,
                          const std::vector<results::LabTable>& tables,
                          const std::map<std::string, std::string>& remarks);

}  // namespace diefill::process::laboratory
