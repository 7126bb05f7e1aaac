// Heaps by the slider (sample_tools/laboratory/repose.toml): the scene with a powder, and where its heaps
// are.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {

inline constexpr const char* kHeapOnSlider = "heap on the slider";
inline constexpr const char* kHeapOnFloor = "heap on the floor";

/// m, that the slider is drawn by: 5 mm, or 10 mm for grains of 0.9 mm and more.
double slider_draw(const LabPowder& powder);

/// m, boxes around the heaps once the slider is drawn by `draw` (m).
struct HeapBoxes {
  Eigen::AlignedBox3d on_floor, on_slider;
};
HeapBoxes heap_boxes(double draw);

/// Its changes for a powder. Where the heap `creeps`, two snapshots "first" and "second" are 2 and 4 s after
/// the draw, and the powder is cleared away in the end.
SceneChanges repose_changes(const LabSetting& setting, const LabPowder& powder, bool creeps = false);
/// The same for `preset` enlarged with the experiment's size, or for the setting's own powder.
SceneChanges repose_changes(const LabSetting& setting, const std::string& preset, bool creeps = false);

/// Slope (deg) of one of the two heaps of a run, named after both; at the end, or at a snapshot of the scene.
LabQuantity heap_angle(const std::string& run, const char* heap, const std::string& snapshot = "");

}  // namespace diefill::process::laboratory
