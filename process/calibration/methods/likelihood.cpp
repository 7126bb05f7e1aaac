#include "process/calibration/methods/likelihood.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace diefill::process::calibration {
namespace {

constexpr double kNoSpread = 1e-14;  // of the largest eigenvalue: what rounding makes of 0

}  // namespace

Likelihood::Likelihood(std::vector<MeasuredData> data) : data_(std::move(data)) {
  if (data_.empty()) throw std::invalid_argument("a likelihood needs a measurement");
  for (const MeasuredData& measured : data_) {
    const Eigen::Index count = measured.emulator->covariance().rows();
    if (measured.values.size() != count || measured.deviations.size() != count ||
        !(measured.deviations.minCoeff() > 0))
      throw std::invalid_argument("every quantity has a measured value and a deviation above zero");
    const Eigen::MatrixXd whitened = measured.deviations.cwiseInverse().asDiagonal() *
                                     measured.emulator->covariance() *
                                     measured.deviations.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (whitened + whitened.transpose()));
    const Eigen::VectorXd& rising = solver.eigenvalues();
    const Eigen::Index kept = (rising.array() > kNoSpread * std::abs(rising[count - 1])).count();
    eigenvectors_.push_back(solver.eigenvectors().rightCols(kept));
    spread_.push_back(Eigen::VectorXd::Zero(kept + 1));
    spread_.back().tail(kept) = rising.tail(kept);
  }
}

std::vector<Differences> Likelihood::differences(const Eigen::VectorXd& place) const {
  std::vector<Differences> all;
  for (std::size_t k = 0; k < data_.size(); ++k) {
    const auto predicted = data_[k].emulator->at(place);
    const Eigen::VectorXd over = (predicted.mean - data_[k].values).cwiseQuotient(data_[k].deviations);
    Eigen::VectorXd rotated(spread_[k].size());
    rotated.tail(rotated.size() - 1) = eigenvectors_[k].transpose() * over;
    rotated[0] =
        std::sqrt(std::max(0.0, over.squaredNorm() - rotated.tail(rotated.size() - 1).squaredNorm()));
    all.push_back({std::move(rotated), predicted.factor, &spread_[k]});
  }
  return all;
}

double Likelihood::log_at(const Eigen::VectorXd& place) const {
  double sum = 0;
  for (const Differences& part : differences(place)) {
    const Eigen::ArrayXd variance = 1 + part.factor * part.spread->array();
    sum += (part.value.array().square() / variance + variance.log()).sum();
  }
  return -0.5 * sum;
}

double Likelihood::chi_square(const Eigen::VectorXd& place) const {
  double sum = 0;
  for (const Differences& part : differences(place))
    sum += (part.value.array().square() / (1 + part.factor * part.spread->array())).sum();
  return sum;
}

double Likelihood::misfit(const Eigen::VectorXd& place) const {
  double sum = 0;
  for (const Differences& part : differences(place)) sum += part.value.squaredNorm();
  return sum;
}

double Likelihood::emulator_share(const Eigen::VectorXd& place) const {
  double sum = 0;
  for (const Differences& part : differences(place)) sum += part.factor * part.spread->sum();
  return sum / static_cast<double>(data());
}

std::size_t Likelihood::data() const {
  Eigen::Index count = 0;
  for (const MeasuredData& measured : data_) count += measured.values.size();
  return static_cast<std::size_t>(count);
}

}  // namespace diefill::process::calibration
