// Samples of a distribution of which only the logarithm of its density is known, up to a constant: the
// affine-invariant ensemble of Goodman and Weare (2010), which long narrow valleys do not slow down.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

namespace diefill::process::calibration {

/// Logarithm of a density at a place of the unit cube.
using LogDensity = std::function<double(const Eigen::VectorXd&)>;

struct EnsembleSize {
  Eigen::Index walkers = 20;  ///< more than twice the dimensions
  int burn_in = 200;          ///< moves of every walker before the first sample
  int thinning = 5;           ///< moves between samples
  Eigen::Index samples = 4000;
};

struct EnsembleSamples {
  Eigen::MatrixXd place;  ///< in the unit cube, one per row
  Eigen::VectorXd log;    ///< logarithm of the density of each
};

/// Starts at `best` and at the most probable of many even places. Same samples for the same seed on every
/// machine.
EnsembleSamples sample_ensemble(const LogDensity& log_density, const Eigen::VectorXd& best,
                                std::uint64_t seed, const EnsembleSize& size);

}  // namespace diefill::process::calibration
