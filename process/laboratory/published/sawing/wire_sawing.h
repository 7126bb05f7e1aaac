// Wire sawing of silicon with a slurry of grains in a DPD fluid (Bierwisch 2009, appendix A).
#pragma once

#include "process/laboratory/published/scene_experiment.h"

namespace diefill::process::laboratory {

/// Viscosity of fluid and slurry, drag in the gap, stress on groove and grains.
LabPlan plan_wire_sawing(const LabSetting& setting);

}  // namespace diefill::process::laboratory
