// How well parameters agree with the measurements, given both the measurements' standard deviations and what
// the emulators do not know.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "process/calibration/methods/emulator.h"

namespace diefill::process::calibration {

/// A measurement and the emulator of its quantities.
struct MeasuredData {
  Eigen::VectorXd values, deviations;  ///< in the emulator's units; deviations above zero
  std::shared_ptr<const Emulator> emulator;
};

/// Differences of one measurement, rotated so that they are independent of each other: each has variance
/// 1 + factor * spread. An emulator of some runs varies in as many directions at most: all others, of which a
/// map has thousands, are one entry with the root of their sum of squares and no spread.
struct Differences {
  Eigen::VectorXd value;  ///< simulated less measured over the measured deviation, rotated
  double factor = 0;      ///< of the emulator at this place
  const Eigen::VectorXd* spread = nullptr;
};

/// Normal errors: those of the measurements independent of each other, those of an emulator with its
/// covariance.
class Likelihood {
 public:
  /// Throws std::invalid_argument for no measurements, sizes that differ and deviations that are not above 0.
  explicit Likelihood(std::vector<MeasuredData> data);

  /// Natural logarithm at a place of the unit cube, without the constant.
  double log_at(const Eigen::VectorXd& place) const;
  /// Sum of squares of all differences over their variances, about data() where the model fits.
  double chi_square(const Eigen::VectorXd& place) const;
  /// The same over the measurements' variances alone: what a search makes small.
  double misfit(const Eigen::VectorXd& place) const;
  /// Mean over the data of the emulators' variance over the measurements'.
  double emulator_share(const Eigen::VectorXd& place) const;
  std::vector<Differences> differences(const Eigen::VectorXd& place) const;
  /// Number of measured values.
  std::size_t data() const;
  const std::vector<MeasuredData>& measurements() const { return data_; }

 private:
  std::vector<MeasuredData> data_;
  /// Of the emulator's covariance over the deviations: eigenvectors with an eigenvalue, and these after a 0.
  std::vector<Eigen::MatrixXd> eigenvectors_;
  std::vector<Eigen::VectorXd> spread_;
};

}  // namespace diefill::process::calibration
