// Whether results of a comparison can have what was measured, found before hours are spent on its runs.
#pragma once

#include <vector>

#include "process/measured_data/compare_with_measured.h"
#include "process/scene/variants.h"
#include "process/tooling/progress.h"

namespace diefill::process {

/// Whether each cavity of the scene's die is a ring, the largest first; empty where they are not known before
/// the run. Reads the tools. Throws SceneError or geometry::MeshError for tools that cannot be used.
std::vector<bool> rings_of(const Scene& scene, const ProgressCallback& on_progress = ignore_progress);

/// Throws SceneError, in one line, for a file whose profile or map no variant's results can have: an unknown
/// quantity, or places that only other cavities have, such as azimuths where there is no ring. Reads the
/// tools of one variant where all files go with it.
void refuse_unmeasurable(const std::vector<MeasuredFile>& files, const std::vector<Variant>& variants,
                         const ProgressCallback& on_progress = ignore_progress);

}  // namespace diefill::process
