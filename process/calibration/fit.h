// Emulators and likelihood of a calibration from the runs that are there.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "process/calibration/calibration_file.h"
#include "process/calibration/methods/likelihood.h"
#include "process/calibration/methods/region.h"
#include "process/calibration/point_runs.h"

namespace diefill::process::calibration {

/// The points of a calibration with what their runs gave.
struct SimulatedPoints {
  std::vector<Point> points;
  std::vector<PointOutcome> outcomes;
};

struct Fit {
  std::vector<std::size_t> measurement;  ///< which measurement each of the likelihood's is
  /// Which of its values are fitted: those that most runs have, so that a place without one, such as a sector
  /// without grains, does not take away all others.
  std::vector<std::vector<std::size_t>> places;
  std::shared_ptr<const Likelihood> likelihood;
  Region region;
};

/// Nothing where a fitted measurement has values at fewer than dimensions + 2 points.
std::optional<Fit> fit_points(const CalibrationPlan& plan, const SimulatedPoints& simulated);

/// That in a sentence, with the measurement; empty where there is a fit.
std::string why_no_fit(const CalibrationPlan& plan, const SimulatedPoints& simulated);

}  // namespace diefill::process::calibration
