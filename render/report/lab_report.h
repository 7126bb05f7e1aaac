// A powder's data sheet from the laboratory's tests, as a report.
#pragma once

#include <vector>

#include "process/results/studies/experiment_result.h"
#include "process/results/studies/lab_table.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// Quantities with scatter over seeds, what is missing and why, and the charts. start_offscreen() must have
/// been called.
Document powder_sheet(const results::LabTable& table, const std::vector<results::ExperimentChart>& charts);

}  // namespace diefill::render::report
