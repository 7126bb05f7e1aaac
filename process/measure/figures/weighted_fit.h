// A sum of a few functions fitted to values at scattered places.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace diefill::process {

/// One value, its weight, and what each function of the sum is at its place.
template <int functions>
struct FitPoint {
  Eigen::Matrix<double, functions, 1> basis;
  double value = 0, weight = 0;
};

/// Coefficients c that make sum_k w_k (y_k - c . b_k)^2 smallest (normal equations; the bases in use are
/// nearly orthogonal). All NaN where the points do not determine them.
template <int functions>
Eigen::Matrix<double, functions, 1> weighted_fit(const std::vector<FitPoint<functions>>& points);

}  // namespace diefill::process
