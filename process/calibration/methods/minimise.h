// The least value of a function within a box, without derivatives: NLopt.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace diefill::process::calibration {

using Objective = std::function<double(const Eigen::VectorXd&)>;

struct Minimum {
  Eigen::VectorXd at;
  double value = 0;
};

/// Searches the whole box by DIRECT-L (Gablonsky and Kelley 2001), then goes down from the best place found
/// by subplex (Rowan 1990). Deterministic. Values that are not finite count as very large. Throws
/// std::runtime_error where NLopt fails.
Minimum minimum_in_box(const Objective& objective, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                       int evaluations = 400);

/// Goes down from `start` alone.
Minimum minimum_near(const Objective& objective, const Eigen::VectorXd& start, const Eigen::VectorXd& lower,
                     const Eigen::VectorXd& upper, int evaluations = 200);

}  // namespace diefill::process::calibration
