// Strategies that are a series over shoe speed: how the fill ratio falls, and the critical speed.
#pragma once

#include <vector>

#include "render/report/document.h"
#include "render/report/sections/strategies.h"

namespace diefill::render::report {

/// Critical speed with its interval, and the chart of fill ratio over speed.
Section speed_section(const std::vector<Strategy>& strategies);

}  // namespace diefill::render::report
