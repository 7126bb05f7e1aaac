// Grains, walls and stiffness of the scenes that a powder was fitted with: its parameters belong to these.
#pragma once

#include <string>
#include <vector>

#include "process/calibration/fit.h"

namespace diefill::process::calibration {

struct FittedGrains {
  std::string text;                       ///< such as "grain model D, d = 1 mm, wall spheres of 0.2 mm, ..."
  std::vector<std::string> measurements;  ///< names of those whose scenes have them
};

/// Those of all fitted measurements at the best parameters, each once. The first are those of powder.toml.
std::vector<FittedGrains> fitted_grains(const CalibrationPlan& plan, const Fit& fit);

/// All of them; of several, with their measurements.
std::string text_of(const std::vector<FittedGrains>& grains);

/// That the measurements differ in these, and which of them powder.toml states; empty where they do not.
std::string differing_grains(const std::vector<FittedGrains>& grains);

}  // namespace diefill::process::calibration
