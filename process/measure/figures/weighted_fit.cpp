#include "process/measure/figures/weighted_fit.h"

#include <Eigen/LU>
#include <limits>

namespace diefill::process {

template <int functions>
Eigen::Matrix<double, functions, 1> weighted_fit(const std::vector<FitPoint<functions>>& points) {
  constexpr double kIndependent = 1e-8;  // smallest over largest pivot, far above rounding
  using Square = Eigen::Matrix<double, functions, functions>;
  using Vector = Eigen::Matrix<double, functions, 1>;
  Square products = Square::Zero();
  Vector right = Vector::Zero();
  for (const auto& point : points) {
    products += point.weight * point.basis * point.basis.transpose();
    right += point.weight * point.value * point.basis;
  }
  Eigen::FullPivLU<Square> decomposition(products);
  decomposition.setThreshold(kIndependent);
  if (points.size() < functions || !decomposition.isInvertible())
    return Vector::Constant(std::numeric_limits<double>::quiet_NaN());
  return decomposition.solve(right);
}

template Eigen::Matrix<double, 5, 1> weighted_fit<5>(const std::vector<FitPoint<5>>&);
template Eigen::Matrix<double, 3, 1> weighted_fit<3>(const std::vector<FitPoint<3>>&);

}  // namespace diefill::process
