// Weighted least squares of sums of functions that share one number which they do not depend on linearly.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace diefill::process::continuum {

/// y_i = sum_j c_j phi_j(i; s).
struct SeparableModel {
  std::vector<std::string> names;  ///< of c_j, then of s where it is fitted
  /// phi_j of every point, a row each, at the shape s.
  std::function<Eigen::MatrixXd(double shape)> basis;
  /// Bounds of s, both above 0, searched in ratio; equal: s is given, not fitted.
  double least_shape = 1, largest_shape = 1;
  /// What the c_j stand for, in terms of fitted numbers (c, s); empty: themselves.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& fitted)> meaning;

  bool fits_shape() const { return largest_shape > least_shape; }
};

struct SeparableFit {
  Eigen::VectorXd fitted;             ///< c, then s where it is fitted
  Eigen::VectorXd numbers;            ///< what they mean, as `names`
  Eigen::MatrixXd fitted_covariance;  ///< of `fitted`
  Eigen::MatrixXd covariance;         ///< of `numbers`
  Eigen::VectorXd values;             ///< of the model at the points
  Eigen::VectorXd value_errors;       ///< of the model there: one standard deviation, from the covariance
  double chi_square_per_freedom = 0;
  bool shape_at_bound = false;  ///< the points do not determine s
};

/// Covariance of sums over y, a row of weights for each sum, where the errors of y are not independent;
/// `values` are those of the model at the points.
using CovarianceOfSums =
    std::function<Eigen::MatrixXd(const Eigen::MatrixXd& sums, const Eigen::VectorXd& values)>;

/// Fits `y` with standard deviations `sigma`. Where `sigma_is_relative`, only their ratios are known and the
/// scatter about the fit gives their size; else the covariance is widened where points scatter by more than
/// they claim (chi^2 per degree of freedom above 1). For each s the c_j follow from a linear system; s is
/// found by a scan and Brent's method. Where errors are `shared`, sigma weighs the points, and the covariance
/// is (J^T W J)^-1 J^T W S W J (J^T W J)^-1 with S those errors, and 1 / W besides unless
/// `sigma_is_relative`. Throws std::invalid_argument where there are fewer points than numbers plus one, or
/// they do not determine the numbers.
SeparableFit fit(const SeparableModel& model, const Eigen::VectorXd& y, const Eigen::VectorXd& sigma,
                 bool sigma_is_relative, const CovarianceOfSums& shared = {});

}  // namespace diefill::process::continuum
