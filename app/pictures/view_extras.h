// What the interactive view of a report shows besides the results as they are stored: the averaged density on
// a grid over the cavities, and solid fractions at kept instants.
#pragma once

#include "process/tooling/progress.h"
#include "render/report/viewer/viewed_run.h"

namespace diefill::app {

/// Measures both. The grid has at most some 70 points along its longest side; points in tools and outside the
/// powder have no value. Instants are those of spread_instants(); `on_progress` is called for each.
render::report::ViewExtras view_extras(const results::FillResult& result,
                                       const process::ProgressCallback& on_progress);

}  // namespace diefill::app
