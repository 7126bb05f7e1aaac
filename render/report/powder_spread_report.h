// The report of runs with powders drawn from a calibration's region.
#pragma once

#include "process/results/studies/powder_spread.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// start_offscreen() must have been called.
Document powder_spread_document(const results::PowderSpread& spread);

}  // namespace diefill::render::report
