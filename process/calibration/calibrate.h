// Finds the powder that agrees with measurements: a space-filling start, then simulations where they help
// most, until they help no more.
#pragma once

#include <functional>
#include <string>

#include "process/calibration/calibration_file.h"
#include "process/calibration/point_runs.h"
#include "process/results/studies/calibration.h"

namespace diefill::process::calibration {

/// What to do about runs that are not finished.
enum class OpenRuns {
  run,       ///< here and now
  write,     ///< their scenes and job scripts, to be run elsewhere
  leave_out  ///< go by those that are finished; no scene is written and no run renamed
};

struct CalibrateOptions {
  PointOptions points;  ///< directory, jobs and budget (jobs.cpu_seconds)
  OpenRuns open_runs = OpenRuns::run;
  std::string command;  ///< for the account
  /// Receives intermediate results, one line at a time.
  std::function<void(const std::string&)> on_note;
};

/// Runs the calibration, or resumes it where runs are there, and returns its results. Writes
/// `directory`/powder.toml where a powder was found. Throws Interrupted, SceneError, std::runtime_error.
results::Calibration calibrate(const CalibrationPlan& plan, const CalibrateOptions& options);

}  // namespace diefill::process::calibration
