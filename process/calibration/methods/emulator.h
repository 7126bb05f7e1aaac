// A Gaussian process in place of simulations: from runs at some places of the parameter box it predicts the
// quantities at any other, how uncertain it is there, and how much runs scatter over seeds (Rasmussen and
// Williams, Gaussian Processes for Machine Learning, 2006).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace diefill::process::calibration {

/// One emulator serves all quantities of one measurement, such as the points of a curve. They share the
/// correlation lengths and the ratio of scatter to variation; their covariance is C times a factor.
class Emulator {
 public:
  /// `inputs`: one run a row, in the unit cube. `outputs`: the quantities of the runs, a row each. Repeats
  /// (equal inputs, another seed) separate scatter from variation. Lengths and scatter are not known from few
  /// runs: predictions are the mean over several that the runs make probable. Throws std::invalid_argument
  /// for fewer than three runs, or values that are not finite.
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
  Eigen::VectorXd scatter() const { return scatter_; }
  /// Most probable correlation length along each parameter, in widths of the box.
  const Eigen::VectorXd& lengths() const { return most_probable_.lengths; }
  /// Errors of predicting each run from all others over their standard deviations, root mean square; about 1
  /// where the emulator states its uncertainty truly. What exceeds 1 has been added to covariance().
  double left_out_error() const { return left_out_error_; }

 private:
  /// The process with certain lengths and noise, for outputs in units of their spread.
  struct Process {
    Eigen::VectorXd lengths;
    double noise = 0;  ///< variance of scatter over that of the variation
    Eigen::MatrixXd inverse, trend_normal, trend_weight, coefficients, weights;
    Eigen::VectorXd variances;  ///< of each quantity where nothing is known, apart from scatter
    double log_likelihood =
        0;  ///< restricted, mean over the quantities, with the preference for usual lengths
  };
  Process process_with(const Eigen::VectorXd& log_parameters, bool for_predictions) const;
  void choose_processes();
  void check_by_leaving_out();

  Eigen::MatrixXd inputs_, outputs_, trend_;  ///< trend: a constant, and a slope along each parameter
  Eigen::VectorXd middle_, spread_;           ///< outputs are scaled by them
  Process most_probable_;
  std::vector<Process> probable_;
  Eigen::MatrixXd covariance_;
  Eigen::VectorXd scatter_;
  double left_out_error_ = 0;
};

}  // namespace diefill::process::calibration
