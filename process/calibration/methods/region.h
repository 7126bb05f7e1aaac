// The parameters that agree with the measurements: not a point but a region, sampled from the likelihood with
// all places of the parameter box equally probable in advance.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "process/calibration/methods/ensemble.h"
#include "process/calibration/methods/likelihood.h"
#include "process/calibration/methods/minimise.h"

namespace diefill::process::calibration {

/// Logarithm of a likelihood at a place of the unit cube.
using LogLikelihood = LogDensity;

struct Region {
  Eigen::MatrixXd samples;  ///< in the unit cube, one per row, in random order: every k-th stand for all
  Eigen::VectorXd log;      ///< log-likelihood of each
  Eigen::VectorXd best;     ///< where the likelihood is largest
  double best_log = 0;
  double threshold = 0;  ///< log-likelihood at the edge of the region that holds `share` of the samples
  Eigen::VectorXd lower, upper;  ///< interval of each parameter alone that holds `share`, and `best`
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
  double share = 0.9;

  /// Whether a place of this log-likelihood belongs to the region: the most probable ones that hold `share`.
  bool contains(double log_likelihood) const { return log_likelihood >= threshold; }
  /// Correlation of two parameters over the samples; 0 where one does not vary.
  double correlation(Eigen::Index first, Eigen::Index second) const;
};

/// Samples by the affine-invariant ensemble of Goodman and Weare (2010), which long narrow valleys do not
/// slow down. Same samples for the same seed on every machine.
Region sample_region(const LogLikelihood& log_likelihood, Eigen::Index dimensions, std::uint64_t seed,
                     double share = 0.9, int samples = 4000);

/// A parameter held at a value, all others as they fit best.
struct ProfilePoint {
  double place = 0;        ///< of the parameter, in the unit cube
  double value = 0;        ///< least value of the objective there
  Eigen::VectorXd others;  ///< the whole place
};

/// The objective along each parameter, least over all others, at `count` even places.
std::vector<std::vector<ProfilePoint>> profiles(const Objective& objective, Eigen::Index dimensions,
                                                int count);

/// Samples spread over the edge of the region: the furthest to both sides along the longest axis of the
/// samples, then along the next, at most `count`.
std::vector<Eigen::VectorXd> edge_of(const Region& region, std::size_t count);

}  // namespace diefill::process::calibration
