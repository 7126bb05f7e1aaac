// The narrow ring (sample_tools/narrow_ring) passed by the shoe: the scene for a grain size, speed and number
// of passages. Implemented in ring_maps.cpp.
#pragma once

#include <string>

#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {

/// `speed` as a scene has it, in quotes. Coarse: d = 1.88 mm; the other sizes: 0.94 mm.
LabRun ring_passages(const LabSetting& setting, const char* name, const char* speed, int count);

}  // namespace diefill::process::laboratory
