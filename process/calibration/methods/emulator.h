// A Gaussian process in place of simulations: from runs at some places of the parameter box it tells the
// quantities at any other, how uncertain it is there, and how much runs scatter over seeds (Rasmussen and
// Williams, Gaussian Processes for Machine Learning, 2006).
#pragma once

#include <Eigen/Core>

namespace diefill::process::calibration {

/// One emulator serves all quantities of one measurement, such as the points of a curve. They share the
/// correlation lengths and the ratio of scatter to variation; their covariance is C times a factor.
class Emulator {
 public:
  /// `inputs`: one run a row, in the unit cube. `outputs`: the quantities of the runs, a row each. Repeats
  /// (equal inputs, another seed) tell scatter from variation. Lengths and scatter maximise the restricted
  /// likelihood. Throws std::invalid_argument for fewer than three runs, or values that are not finite.
  Emulator(Eigen::MatrixXd inputs, Eigen::MatrixXd outputs);

  struct Prediction {
    Eigen::VectorXd mean;
    double factor = 0;  ///< covariance of the error of `mean` is factor * covariance()
  };
  /// At a place of the unit cube.
  Prediction at(const Eigen::VectorXd& place) const;
  /// Covariance of quantities where nothing is known, apart from scatter.
  const Eigen::MatrixXd& covariance() const { return covariance_; }
  /// Standard deviation of one run over seeds, quantity by quantity.
  Eigen::VectorXd scatter() const;
  /// Correlation length along each parameter, in widths of the box.
  const Eigen::VectorXd& lengths() const { return lengths_; }
  /// Errors of predicting each run from all others over their standard deviations, root mean square; about 1
  /// where the emulator states its uncertainty truly. What exceeds 1 has been added to covariance().
  double left_out_error() const { return left_out_error_; }

 private:
  void choose_lengths();
  void factorise(const Eigen::VectorXd& lengths, double noise);
  double log_likelihood(const Eigen::VectorXd& log_parameters);
  void check_by_leaving_out();

  Eigen::MatrixXd inputs_, outputs_, trend_;  ///< trend: a constant, and a slope along each parameter
  Eigen::VectorXd middle_, spread_;           ///< outputs are scaled by them
  Eigen::VectorXd lengths_;
  double noise_ = 0;  ///< variance of scatter over that of the variation
  double left_out_error_ = 0;
  Eigen::MatrixXd inverse_, trend_normal_, trend_weight_, coefficients_, weights_, covariance_;
  double log_determinant_ = 0;
};

}  // namespace diefill::process::calibration
