// Compares a result with a measured profile or map.
#pragma once

#include <filesystem>
#include <vector>

#include "process/measure/figures/zone.h"
#include "process/measured_data/measured_table.h"
#include "process/results/fill_result.h"
#include "process/results/studies/measured_comparison.h"

namespace diefill::process {

/// A measured file as read.
struct MeasuredFile {
  std::filesystem::path file;
  MeasuredTable table;
};

/// Throws SceneError as read_measured_field() does, and for two files of the same name.
std::vector<MeasuredFile> read_measured_files(const std::vector<std::string>& files);

/// The profile or map of the result with the name of the measured value's column, at the measured places. Its
/// zones are those of the scene whose limits concern the coordinates of the profile or map alone, and
/// quarters (azimuths) or thirds of the measured range of each coordinate. Throws SceneError where the result
/// has no such profile or map, where units differ, and where no measured place lies within it.
results::MeasuredComparison compare_with_measured(const MeasuredFile& measured,
                                                  const results::FillResult& result);

}  // namespace diefill::process
