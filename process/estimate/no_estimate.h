// Scenes of which formulas say nothing, or for which no formula is needed.
#pragma once

#include <string>

#include "process/estimate/estimate.h"

namespace diefill::process::estimate {

/// Degrees by which gravity may be off -z: the weight towards the openings is then 0.4 % less, which the
/// stated error holds many times over.
inline constexpr double kLargestTilt = 5;

/// Sets the answer, and why, of a scene that cannot be estimated as gravity does not act along -z or changes
/// while tools move, and of one whose shoe is closed; false: the formulas hold. `scene` has prepared steps.
bool is_not_estimated(const Scene& scene, const Tooling& tooling, Estimate& estimate);

}  // namespace diefill::process::estimate
