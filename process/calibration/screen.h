// Which parameters matter: a two-level design over the ends of their ranges, effects with standard errors,
// and the regression that they make (Kottlan 2018, sections 2.5.1 and 2.5.2).
#pragma once

#include "process/calibration/calibrate.h"
#include "process/calibration/fit.h"
#include "process/calibration/methods/fractional_design.h"

namespace diefill::process::calibration {

/// Runs the design of the plan's resolution and gives the effects on every measured value that is to be
/// fitted. Throws as calibrate() does.
results::Calibration screen(const CalibrationPlan& plan, const CalibrateOptions& options);

/// Effects from the runs of a design, its points in the design's order. Values of runs without a result leave
/// their quantity out.
results::Screening screening_of(const CalibrationPlan& plan, const FractionalDesign& design,
                                const SimulatedPoints& simulated);

}  // namespace diefill::process::calibration
