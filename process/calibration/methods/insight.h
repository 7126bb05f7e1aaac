// What a calibration's region says: which parameters the measurements fix, which only together, and which
// further measurement would help most.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "process/calibration/methods/region.h"

namespace diefill::process::calibration {

/// One sentence for every parameter that the data leave open, for every end of a range that cuts the region
/// off, and for every pair that the data fix only along a line. `measured_by`: names of the measurements that
/// were fitted.
std::vector<std::string> insights(const Region& region, const std::vector<std::string>& parameters,
                                  const std::vector<std::string>& measured_by);

/// A measurement that could be made (again): what it would give over the samples of the region, one per row,
/// and its standard deviations.
struct PossibleMeasurement {
  std::string name;
  Eigen::MatrixXd values;
  Eigen::VectorXd deviations;
};

/// What it would do to the region, as a linear and normal estimate.
struct Informativeness {
  std::string name;
  double volume = 1;           ///< of the region afterwards over now, 0 to 1
  Eigen::VectorXd deviations;  ///< standard deviation of each parameter afterwards over now
};

/// Those that shrink the region most first. Throws std::invalid_argument where a measurement has not a row
/// for each sample.
std::vector<Informativeness> informativeness_of(const Eigen::MatrixXd& samples,
                                                const std::vector<PossibleMeasurement>& possible);

}  // namespace diefill::process::calibration
