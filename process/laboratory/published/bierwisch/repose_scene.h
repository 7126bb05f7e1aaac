// Heaps by the slider (sample_tools/laboratory/repose.toml): the scene with a powder. Implemented in
// angle_of_repose.cpp.
#pragma once

#include <string>

#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {

inline constexpr const char* kHeapOnSlider = "heap on the slider";
inline constexpr const char* kHeapOnFloor = "heap on the floor";

/// Its changes for `preset`, or for the setting's own powder. Where the heap `creeps`, two snapshots "first"
/// and "second" are 2 and 4 s after the draw, and the powder is cleared away in the end.
SceneChanges repose_changes(const LabSetting& setting, const std::string& preset, bool creeps = false);
/// The same for a powder of any size; with half the lengths of the published set-up if wanted.
SceneChanges repose_changes(const LabSetting& setting, const LabPowder& powder, bool half_lengths,
                            bool creeps);

}  // namespace diefill::process::laboratory
