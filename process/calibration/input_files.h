// The files that a calibration reads besides the tools of its scenes.
#pragma once

#include <filesystem>
#include <vector>

#include "process/calibration/calibration_file.h"

namespace diefill::process::calibration {

/// The calibration file, its starting powder, its CSVs of measurements, its scenes, and the powder files that
/// these name. Throws SceneError for a scene that cannot be read.
std::vector<std::filesystem::path> input_files(const CalibrationPlan& plan);

}  // namespace diefill::process::calibration
