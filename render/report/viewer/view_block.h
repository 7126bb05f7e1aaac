// The interactive view of one run or several as content of a report.
#pragma once

#include <vector>

#include "render/fields/pictures.h"
#include "render/report/document.h"
#include "render/report/viewer/packed_run.h"

namespace diefill::render::report {

/// Most that the data of one view take in a page, and most runs side by side.
inline constexpr std::size_t kMaxViewBytes = 18'000'000, kMaxViewedRuns = 4;

/// The view of the runs, and their still pictures for readers without it. `range`: of the solid fraction.
/// Where the data would exceed `most_bytes`, every other instant is left out until they do not. Of more than
/// kMaxViewedRuns runs the first are shown, and a remark says so.
View3D view_of(const std::vector<ViewedRun>& runs, const ColourRange& range,
               std::size_t most_bytes = kMaxViewBytes);

}  // namespace diefill::render::report
