// A Gaussian process in place of simulations: from runs at some places of the parameter box it predicts the
// quantities at any other, how uncertain it is there, and how much runs scatter over seeds (Rasmussen and
// Williams, Gaussian Processes for Machine Learning, 2006).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace diefill::process::calibration {

/// Variance of Student's t over that of a normal distribution. Fewer than three degrees of freedom, with
/// which t has no finite variance, count as three.
double student_variance(double freedom);

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
  /// Covariance of the quantities of one run over seeds, over covariance().
  double scatter_ratio() const { return scatter_ratio_; }
  /// Degrees of freedom of what varies: places, of which repeats are one, less terms of the trend.
  double freedom() const { return static_cast<double>(places_.size()) - static_cast<double>(trend_.cols()); }
  /// Most probable correlation length along each parameter, in widths of the box.
  const Eigen::VectorXd& lengths() const { return most_probable_.lengths; }
  /// Errors of predicting the mean of the runs at each place from the runs at all other places, over their
  /// standard deviations, root mean square; about 1 where the emulator states its uncertainty truly. What
  /// exceeds 1 has been added to covariance(). 0 where nothing varies.
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

  std::vector<std::vector<Eigen::Index>> places_;  ///< runs at each place
  Eigen::MatrixXd inputs_, outputs_, trend_;       ///< trend: a constant, and a slope along each parameter
  Eigen::VectorXd middle_, spread_;                ///< outputs are scaled by them
  Process most_probable_;
  std::vector<Process> probable_;
  Eigen::MatrixXd covariance_;
  Eigen::VectorXd scatter_;
  double left_out_error_ = 0, scatter_ratio_ = 0;
};

}  // namespace diefill::process::calibration
