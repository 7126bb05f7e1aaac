// Whether the dies of a calibration have the cavities that its measurements name, and of a kind that has the
// profiles and maps that were measured.
#pragma once

#include "process/calibration/calibration_file.h"
#include "process/tooling/progress.h"

namespace diefill::process::calibration {

/// Throws SceneError, in one line with the names that there are, where a measurement asks for a figure of a
/// further cavity, such as "cavity_3_fill_ratio", that the tools of its scene do not have, or for a figure,
/// profile or map that only rings have, or only other cavities, such as a fill level over azimuth. Reads the
/// tools of such scenes only, as the starting powder's scene has them. Scenes with a die whose cavity is not
/// known before a run pass. Throws geometry::MeshError for tools that cannot be used.
void check_cavities(const CalibrationPlan& plan, const ProgressCallback& on_progress = ignore_progress);

}  // namespace diefill::process::calibration
