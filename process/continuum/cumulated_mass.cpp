#include "process/continuum/cumulated_mass.h"

#include <algorithm>

namespace diefill::process::continuum {

namespace {

/// Calls `visit` with the indices of each increment's two points; the first increment begins at index -1.
template <class Visit>
void for_each_increment(const Outflow& outflow, const Visit& visit) {
  Eigen::Index before = -1;
  for (const Eigen::Index point : outflow) {
    visit(before, point);
    before = point;
  }
}

double increment(const Eigen::VectorXd& masses, Eigen::Index before, Eigen::Index point) {
  return masses[point] - (before < 0 ? 0 : masses[before]);
}

}  // namespace

double variance_per_mass(const std::vector<Outflow>& outflows, const Eigen::VectorXd& measured,
                         const Eigen::VectorXd& fitted, Eigen::Index fitted_numbers) {
  double squares = 0, mass = 0;
  for (const Outflow& outflow : outflows)
    for_each_increment(outflow, [&](Eigen::Index before, Eigen::Index point) {
      const double expected = increment(fitted, before, point),
                   off = increment(measured, before, point) - expected;
      squares += off * off;
      mass += std::max(0.0, expected);
    });
  const auto count = static_cast<double>(measured.size());
  return mass > 0 ? squares / mass * count / (count - static_cast<double>(fitted_numbers)) : 0;
}

Eigen::MatrixXd covariance_of_sums(const Eigen::MatrixXd& sums, const std::vector<Outflow>& outflows,
                                   const Eigen::VectorXd& fitted, double per_mass) {
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(sums.rows(), sums.rows());
  for (const Outflow& outflow : outflows) {
    // An increment counts in its own mass and in all later ones.
    Eigen::VectorXd later = Eigen::VectorXd::Zero(sums.rows());
    for (const Eigen::Index point : outflow) later += sums.col(point);
    for_each_increment(outflow, [&](Eigen::Index before, Eigen::Index point) {
      const double mass = std::max(0.0, increment(fitted, before, point));
      covariance += per_mass * mass * later * later.transpose();
      later -= sums.col(point);
    });
  }
  return covariance;
}

}  // namespace diefill::process::continuum
