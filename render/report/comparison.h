// Sections of a report that compare several runs.
#pragma once

#include <vector>

#include "render/fields/pictures.h"
#include "render/report/document.h"
#include "render/report/sections/strategies.h"

namespace diefill::render::report {

/// Ranking, maps on one scale, curves, scatter over seeds, critical shoe speed where the strategies are a
/// series over speed, and differences from the first strategy.
/// `range`: of the solid fraction on maps; from the strategies' own where it is kRangeFromData.
std::vector<Section> comparison_sections(const std::vector<Strategy>& strategies,
                                         const ColourRange& range = kRangeFromData);

}  // namespace diefill::render::report
