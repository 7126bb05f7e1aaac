// The part of a calibration's report that holds measured against simulated values.
#pragma once

#include "process/results/studies/calibration.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// Table and pictures of the measurements that were fitted, or of those kept for checking.
Section measured_and_simulated(const results::Calibration& calibration, bool fitted);

/// Measured against simulated values of a map, as a PNG of their own: on the diagonal where they agree.
Figure agreement_picture(const results::CalibratedMeasurement& measurement);

}  // namespace diefill::render::report
