// The report of a calibration or a screening: the powder with its uncertainty, measured against simulated,
// residual maps, effects, correlations and what was kept for checking.
#pragma once

#include "process/results/studies/calibration.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// start_offscreen() must have been called.
Document calibration_document(const results::Calibration& calibration);

/// Effects of a screening on one quantity, with their 95 % margins, as a PNG of their own.
Figure effects_picture(const results::Screening& screening, std::size_t quantity);

}  // namespace diefill::render::report
