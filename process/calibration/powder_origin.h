// What powder.toml says about how its powder was found: a comment at its top and the table [calibration].
#pragma once

#include <string>

#include "process/calibration/fit.h"
#include "process/results/studies/calibration.h"

namespace diefill::process::calibration {

/// Lines that begin with #; one more where the measurements have different grains or walls.
std::string powder_comment(const results::Calibration& account, const CalibrationPlan& plan, const Fit& fit);

/// Verdict, samples, parameters, and each measurement with what was measured and whether the powder meets it.
std::string powder_calibration_table(const results::Calibration& account, const CalibrationPlan& plan);

}  // namespace diefill::process::calibration
