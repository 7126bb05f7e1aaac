#include "process/calibration/methods/emulator.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "process/calibration/methods/minimise.h"

namespace diefill::process::calibration {
namespace {

constexpr double kShortest = 0.08, kLongest = 8;  // correlation lengths, in widths of the box
constexpr double kLeastNoise = 1e-8, kMostNoise = 100;
constexpr double kUsualLength = 0.8, kSpreadOfLengths = 1.0;  // weak preference, in natural logarithms

/// Matern's correlation of order 5/2 at a scaled distance.
double correlation(double distance) {
  const double root = std::sqrt(5.0) * distance;
  return (1 + root + root * root / 3) * std::exp(-root);
}

Eigen::MatrixXd trend_at(const Eigen::MatrixXd& places, Eigen::Index terms) {
  Eigen::MatrixXd trend(places.rows(), terms);
  trend.col(0).setOnes();
  if (terms > 1) trend.rightCols(terms - 1) = places;
  return trend;
}

}  // namespace

Emulator::Emulator(Eigen::MatrixXd inputs, Eigen::MatrixXd outputs)
    : inputs_(std::move(inputs)), outputs_(std::move(outputs)) {
  const Eigen::Index runs = inputs_.rows();
  if (runs < 3 || outputs_.rows() != runs || outputs_.cols() == 0)
    throw std::invalid_argument("an emulator needs three runs or more");
  if (!inputs_.allFinite() || !outputs_.allFinite())
    throw std::invalid_argument("an emulator needs finite values");
  // A slope for every parameter needs runs to spare.
  trend_ = trend_at(inputs_, runs >= 2 * (inputs_.cols() + 1) ? inputs_.cols() + 1 : 1);
  middle_ = outputs_.colwise().mean();
  spread_ = (outputs_.rowwise() - middle_.transpose()).colwise().norm() / std::sqrt(double(runs - 1));
  for (double& spread : spread_)
    if (!(spread > 0)) spread = 1;
  outputs_ = (outputs_.rowwise() - middle_.transpose()) * spread_.cwiseInverse().asDiagonal();
  choose_lengths();
  check_by_leaving_out();
}

void Emulator::factorise(const Eigen::VectorXd& lengths, double noise) {
  lengths_ = lengths;
  noise_ = noise;
  const Eigen::Index runs = inputs_.rows(), terms = trend_.cols();
  const Eigen::MatrixXd scaled = inputs_ * lengths.cwiseInverse().asDiagonal();
  Eigen::MatrixXd matrix(runs, runs);
  for (Eigen::Index a = 0; a < runs; ++a)
    for (Eigen::Index b = 0; b <= a; ++b)
      matrix(a, b) = matrix(b, a) = correlation((scaled.row(a) - scaled.row(b)).norm());
  matrix.diagonal().array() += noise;
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  inverse_ = factor.solve(Eigen::MatrixXd::Identity(runs, runs));
  trend_weight_ = factor.solve(trend_);
  const Eigen::LLT<Eigen::MatrixXd> of_trend(trend_.transpose() * trend_weight_);
  trend_normal_ = of_trend.solve(Eigen::MatrixXd::Identity(terms, terms));
  coefficients_ = trend_normal_ * (trend_weight_.transpose() * outputs_);
  const Eigen::MatrixXd rest = outputs_ - trend_ * coefficients_;
  weights_ = factor.solve(rest);
  covariance_ = rest.transpose() * weights_ / static_cast<double>(runs - terms);
  log_determinant_ = 2 * factor.matrixLLT().diagonal().array().log().sum() +
                     2 * of_trend.matrixLLT().diagonal().array().log().sum();
}

/// Restricted log-likelihood, mean over the quantities, at logarithms of the lengths and of the noise.
double Emulator::log_likelihood(const Eigen::VectorXd& log_parameters) {
  const Eigen::Index dimensions = inputs_.cols();
  factorise(log_parameters.head(dimensions).array().exp(), std::exp(log_parameters[dimensions]));
  constexpr double kConstant = 1e-12;  // variance of a quantity that does not vary
  const double freedom = static_cast<double>(inputs_.rows() - trend_.cols());
  const double variances = (covariance_.diagonal().array() + kConstant).log().mean();
  const double preference =
      ((log_parameters.head(dimensions).array() - std::log(kUsualLength)) / kSpreadOfLengths).square().sum();
  return -0.5 * (freedom * variances + log_determinant_ + preference);
}

void Emulator::choose_lengths() {
  const Eigen::Index dimensions = inputs_.cols();
  Eigen::VectorXd lower = Eigen::VectorXd::Constant(dimensions + 1, std::log(kShortest)),
                  upper = Eigen::VectorXd::Constant(dimensions + 1, std::log(kLongest));
  lower[dimensions] = std::log(kLeastNoise);
  upper[dimensions] = std::log(kMostNoise);
  const int evaluations = 100 + 60 * static_cast<int>(dimensions);
  const Minimum best = minimum_in_box([this](const Eigen::VectorXd& at) { return -log_likelihood(at); },
                                      lower, upper, evaluations);
  log_likelihood(best.at);
}

/// Dubrule, Mathematical Geology 15 (1983): predictions of each run from the others without refitting.
void Emulator::check_by_leaving_out() {
  const Eigen::MatrixXd rest = inverse_ - trend_weight_ * trend_normal_ * trend_weight_.transpose();
  const Eigen::MatrixXd weighted = rest * outputs_;
  double squares = 0, count = 0;
  for (Eigen::Index k = 0; k < outputs_.rows(); ++k)
    for (Eigen::Index q = 0; q < outputs_.cols(); ++q) {
      const double variance = covariance_(q, q) * rest(k, k);
      if (!(variance > 1e-12)) continue;
      squares += weighted(k, q) * weighted(k, q) / variance;
      count += 1;
    }
  left_out_error_ = count > 0 ? std::sqrt(squares / count) : 0;
  const double widened = std::max(1.0, left_out_error_ * left_out_error_);
  covariance_ = widened * (spread_.asDiagonal() * covariance_ * spread_.asDiagonal());
}

Emulator::Prediction Emulator::at(const Eigen::VectorXd& place) const {
  Eigen::VectorXd near(inputs_.rows());
  for (Eigen::Index k = 0; k < inputs_.rows(); ++k)
    near[k] = correlation((inputs_.row(k).transpose() - place).cwiseQuotient(lengths_).norm());
  const Eigen::VectorXd trend = trend_at(place.transpose(), trend_.cols()).transpose();
  const Eigen::VectorXd missing = trend - trend_weight_.transpose() * near;
  Prediction prediction;
  prediction.mean =
      middle_ + spread_.cwiseProduct((coefficients_.transpose() * trend) + (weights_.transpose() * near));
  prediction.factor = std::max(0.0, 1 - near.dot(inverse_ * near) + missing.dot(trend_normal_ * missing));
  return prediction;
}

Eigen::VectorXd Emulator::scatter() const {
  return (noise_ * covariance_.diagonal()).cwiseMax(0).cwiseSqrt();
}

}  // namespace diefill::process::calibration
