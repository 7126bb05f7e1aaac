// The section of a report on what was recorded while the scene ran.
#pragma once

#include "process/results/fill_result.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// Charts over time: the solid fraction of all zones in one, and one of every probe. Without blocks where
/// nothing was recorded.
Section over_time_section(const results::FillResult& result);

}  // namespace diefill::render::report
