// How full the die is: the first section of every report.
#pragma once

#include "process/results/fill_result.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// Verdict, masses of the real powder, fill ratio, height and cycle time, a table of all cavities where there
/// are several, and then how the solid fraction is spread. Rows without a value are left out; what too few
/// grains stand behind is named with the reason.
Section filling_section(const results::FillResult& result);

}  // namespace diefill::render::report
