// What `diefill fit-discharge` prints and writes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "process/continuum/discharge_fit.h"

namespace diefill::app {

/// Numbers with their deviations, how well they fit, and what to beware of.
void print_fit(const process::continuum::DischargeFit& fit, const process::continuum::DischargeData& data);
/// SI units; `file` is that of the measurements.
nlohmann::ordered_json fit_as_json(const process::continuum::DischargeFit& fit,
                                   const process::continuum::DischargeData& data, const std::string& file);
/// A line for each point: measured, fitted, deviation of the fit.
std::string fit_as_csv(const process::continuum::DischargeFit& fit,
                       const process::continuum::DischargeData& data);

/// Why the fitted law may be none of the powder, a line each: an estimate that goes by it then gives no
/// answer.
std::vector<std::string> doubts(const process::continuum::DischargeFit& fit);
/// What to beware of, a line each; doubts() first.
std::vector<std::string> remarks(const process::continuum::DischargeFit& fit);

}  // namespace diefill::app
