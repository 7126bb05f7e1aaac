#include "process/continuum/separable_fit.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <stdexcept>

namespace diefill::process::continuum {

namespace {

constexpr int kScan = 240;                  // shapes looked at
constexpr double kWorstDetermined = 1e-10;  // smallest over largest singular value of the scaled Jacobian

/// The points with their weights.
class Problem {
 public:
  Problem(const SeparableModel& model, const Eigen::VectorXd& y, const Eigen::VectorXd& sigma)
      : model_(model), y_(y), sigma_(sigma) {}

  Eigen::VectorXd coefficients(double shape) const {
    const Eigen::MatrixXd weighted = sigma_.cwiseInverse().asDiagonal() * model_.basis(shape);
    return weighted.colPivHouseholderQr().solve(Eigen::VectorXd(y_.cwiseQuotient(sigma_)));
  }
  double chi_square(double shape) const {
    const Eigen::VectorXd off = y_ - model_.basis(shape) * coefficients(shape);
    return off.cwiseQuotient(sigma_).squaredNorm();
  }
  double best_shape() const {
    if (!model_.fits_shape()) return model_.least_shape;
    const double low = std::log(model_.least_shape), step = (std::log(model_.largest_shape) - low) / kScan;
    int best = 0;
    double least = INFINITY;
    for (int k = 0; k <= kScan; ++k)
      if (const double chi = chi_square(std::exp(low + k * step)); chi < least) {
        least = chi;
        best = k;
      }
    const double from = low + std::max(0, best - 1) * step, to = low + std::min(kScan, best + 1) * step;
    constexpr int kBits = 40;
    const auto found = boost::math::tools::brent_find_minima(
        [&](double logarithm) { return chi_square(std::exp(logarithm)); }, from, to, kBits);
    return std::exp(found.first);
  }
  Eigen::VectorXd values(const Eigen::VectorXd& fitted) const {
    const bool shaped = model_.fits_shape();
    const double shape = shaped ? fitted[fitted.size() - 1] : model_.least_shape;
    return model_.basis(shape) * fitted.head(fitted.size() - (shaped ? 1 : 0));
  }

 private:
  const SeparableModel& model_;
  const Eigen::VectorXd &y_, &sigma_;
};

/// Derivatives of `function` by central differences.
template <class Function>
Eigen::MatrixXd jacobian(const Function& function, const Eigen::VectorXd& at) {
  Eigen::MatrixXd slopes(function(at).size(), at.size());
  for (Eigen::Index k = 0; k < at.size(); ++k) {
    const double step = 1e-5 * std::max(1e-6, std::abs(at[k]));
    Eigen::VectorXd above = at, below = at;
    above[k] += step;
    below[k] -= step;
    slopes.col(k) = (function(above) - function(below)) / (2 * step);
  }
  return slopes;
}

constexpr const char* kUndetermined =
    "the points do not determine all parameters of this law; measure more points over a wider range";

/// (J^T J)^-1 of the weighted Jacobian; throws where the points do not determine the numbers.
Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& weighted) {
  const Eigen::VectorXd scale = weighted.colwise().norm().transpose();
  if (!(scale.minCoeff() > 0)) throw std::invalid_argument(kUndetermined);
  const Eigen::MatrixXd scaled = weighted * scale.cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> parts(scaled, Eigen::ComputeThinV);
  const Eigen::VectorXd& singular = parts.singularValues();
  if (singular.minCoeff() < kWorstDetermined * singular.maxCoeff())
    throw std::invalid_argument(kUndetermined);
  const Eigen::MatrixXd inverse =
      parts.matrixV() * singular.cwiseAbs2().cwiseInverse().asDiagonal() * parts.matrixV().transpose();
  return scale.cwiseInverse().asDiagonal() * inverse * scale.cwiseInverse().asDiagonal();
}

/// Covariance of the fitted numbers, with found.values and chi^2 known (separable_fit.h).
Eigen::MatrixXd covariance_of_fitted(const SeparableFit& found, const Eigen::MatrixXd& slopes,
                                     const Eigen::VectorXd& sigma, bool sigma_is_relative,
                                     const CovarianceOfSums& shared) {
  const Eigen::MatrixXd weighted = sigma.cwiseInverse().asDiagonal() * slopes;
  const Eigen::MatrixXd own = covariance_of(weighted);
  if (!shared)
    return own *
           (sigma_is_relative ? found.chi_square_per_freedom : std::max(1.0, found.chi_square_per_freedom));
  const Eigen::MatrixXd sums = own * weighted.transpose() * sigma.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd of_shared = shared(sums, found.values);
  return sigma_is_relative ? of_shared : Eigen::MatrixXd(own + of_shared);
}

}  // namespace

SeparableFit fit(const SeparableModel& model, const Eigen::VectorXd& y, const Eigen::VectorXd& sigma,
                 bool sigma_is_relative, const CovarianceOfSums& shared) {
  const auto wanted = static_cast<Eigen::Index>(model.names.size());
  if (y.size() < wanted + 1)
    throw std::invalid_argument("found " + std::to_string(y.size()) +
                                (y.size() == 1 ? " point; " : " points; ") + std::to_string(wanted) +
                                " parameters and their errors need at least " + std::to_string(wanted + 1));
  const Problem problem(model, y, sigma);
  const double shape = problem.best_shape();
  SeparableFit found;
  found.fitted = problem.coefficients(shape);
  if (model.fits_shape()) {
    found.fitted.conservativeResize(found.fitted.size() + 1);
    found.fitted[found.fitted.size() - 1] = shape;
    constexpr double kAtBound = 1.01;
    found.shape_at_bound = shape < kAtBound * model.least_shape || shape * kAtBound > model.largest_shape;
  }
  found.values = problem.values(found.fitted);
  found.chi_square_per_freedom =
      (y - found.values).cwiseQuotient(sigma).squaredNorm() / static_cast<double>(y.size() - wanted);
  const Eigen::MatrixXd slopes =
      jacobian([&](const Eigen::VectorXd& at) { return problem.values(at); }, found.fitted);
  const Eigen::MatrixXd covariance = covariance_of_fitted(found, slopes, sigma, sigma_is_relative, shared);
  found.fitted_covariance = covariance;
  found.value_errors = (slopes * covariance * slopes.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
  const auto meaning = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
    return model.meaning ? model.meaning(at) : at;
  };
  found.numbers = meaning(found.fitted);
  const Eigen::MatrixXd to_numbers = jacobian(meaning, found.fitted);
  found.covariance = to_numbers * covariance * to_numbers.transpose();
  return found;
}

}  // namespace diefill::process::continuum
