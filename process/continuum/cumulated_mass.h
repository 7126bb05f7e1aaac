// Errors of cumulated masses: what has run out until a time carries the scatter of all mass before it.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace diefill::process::continuum {

/// Indices of the points of one outflow, by rising time.
using Outflow = std::vector<Eigen::Index>;

/// kg: variance of cumulated mass over that mass, a random walk whose steps scatter independently (for grains
/// that fall independently of each other the mass of one). From the differences between the measured and the
/// fitted increments, the first from no mass on: sum (dy - df)^2 / sum df, N / (N - `fitted_numbers`) times.
double variance_per_mass(const std::vector<Outflow>& outflows, const Eigen::VectorXd& measured,
                         const Eigen::VectorXd& fitted, Eigen::Index fitted_numbers);

/// Covariance of `sums` times the masses, a row of weights for each sum, where `fitted` masses of an outflow
/// vary as such a walk of variance `per_mass`, and those of different outflows independently.
Eigen::MatrixXd covariance_of_sums(const Eigen::MatrixXd& sums, const std::vector<Outflow>& outflows,
                                   const Eigen::VectorXd& fitted, double per_mass);

}  // namespace diefill::process::continuum
