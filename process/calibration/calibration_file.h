// The file that `diefill calibrate` reads: starting powder, parameters with ranges, measurements, and how
// much to compute.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/calibration/measurement.h"
#include "process/calibration/parameter_range.h"

namespace diefill::process::calibration {

struct CalibrationPlan {
  std::filesystem::path file;
  std::string text;  ///< as read
  std::string title;
  std::filesystem::path powder;  ///< that it starts from
  std::vector<ParameterRange> parameters;
  std::vector<Measurement> measurements;
  std::uint64_t seed = 1;
  int seeds = 2;             ///< runs of each set of parameters
  int start_points = 0;      ///< of the space-filling start
  int most_points = 0;       ///< at which the search ends in any case
  int points_at_once = 2;    ///< of a round of the search
  std::string finer_grains;  ///< grain_diameter of a last check with finer grains; empty: none
  int resolution = 4;        ///< of a screening
};

/// Throws SceneError where fewer values are to be fitted than there are parameters.
void check_enough_data(const CalibrationPlan& plan);

/// What the last check sets in its scenes.
std::string finer_grains_of(const CalibrationPlan& plan);

/// Reads the file and every scene it names, at both ends of every range. Throws SceneError.
CalibrationPlan read_calibration(const std::filesystem::path& file);

/// The scene of a run at a place of the unit cube, read and checked in full; `set` is TOML that it changes
/// last. Throws SceneError.
Scene scene_at(const CalibrationPlan& plan, const MeasurementRun& run, const std::vector<double>& place,
               const std::string& set = "");

}  // namespace diefill::process::calibration
