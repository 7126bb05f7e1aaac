// Conditions that wait for more powder than the scene has.
#pragma once

#include "process/tooling/tooling.h"

namespace diefill::process {

/// Throws SceneError for a condition on `filled_mass` that has to be met for the run to go on, where all
/// powder that is poured and let in weighs less. Does nothing where the powder comes from a file or another
/// run, or a step lets in powder without limit.
void refuse_unreachable_mass(const Scene& scene, const Tooling& tooling);

}  // namespace diefill::process
