// The schedule of a filling as a chart over time: one bar per stage.
#pragma once

#include <QImage>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::render::report {

/// Bars from start to end of every stage, one line a stage, with what was done and by which tool. Throws
/// std::invalid_argument where there is no stage.
QImage compose_timeline(const std::vector<results::Stage>& stages);

}  // namespace diefill::render::report
