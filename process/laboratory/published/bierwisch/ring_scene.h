// The narrow ring (sample_tools/narrow_ring) passed by the shoe: the scene for a grain size, speed and number
// of passages. Implemented in ring_maps.cpp.
#pragma once

#include <string>

#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {

inline constexpr const char* kRingScene = "../narrow_ring/fill.toml";

/// Keys of grain size, ring and walls. Coarse: d = 1.88 mm; the other sizes: 0.94 mm. `tools`: where the
/// scene's own folder has the ring's tools.
std::string ring_keys(const LabSetting& setting, const std::string& tools = "");
/// A run of kRingScene, `speed` as a scene has it, in quotes.
LabRun ring_passages(const LabSetting& setting, const char* name, const char* speed, int count);

}  // namespace diefill::process::laboratory
