// What a calibration has found, in numbers and words: measured against simulated, intervals, profiles, maps,
// correlations, and which further measurement would help.
#pragma once

#include <optional>
#include <string>

#include "process/calibration/fit.h"
#include "process/results/studies/calibration.h"

namespace diefill::process::calibration {

/// Everything but command, version and why the search ended.
results::Calibration calibration_results(const CalibrationPlan& plan, const SimulatedPoints& simulated,
                                         const std::optional<Fit>& fit);

/// The parts of it: parameters with profiles, correlations and samples; measurements; maps.
void add_parameters(results::Calibration& account, const CalibrationPlan& plan,
                    const std::optional<Fit>& fit);
void add_measurements(results::Calibration& account, const CalibrationPlan& plan,
                      const SimulatedPoints& simulated, const std::optional<Fit>& fit);
void add_maps(results::Calibration& account, const CalibrationPlan& plan, const Fit& fit);

/// Comment at the top of powder.toml, and its table [calibration].
std::string powder_comment(const results::Calibration& account);
std::string powder_calibration_table(const results::Calibration& account);

}  // namespace diefill::process::calibration
