#include "process/calibration/methods/emulator.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "process/calibration/methods/ensemble.h"
#include "process/calibration/methods/minimise.h"

namespace diefill::process::calibration {
namespace {

constexpr double kShortest = 0.08, kLongest = 8;  // correlation lengths, in widths of the box
constexpr double kMinNoise = 1e-6, kMaxNoise = 100;
constexpr double kUsualLength = 0.8, kSpreadOfLengths = 1.0;  // weak preference, in natural logarithms
constexpr double kConstant = 1e-12;                           // variance of a quantity that does not vary
constexpr Eigen::Index kProcesses = 10;                       // over which predictions are averaged

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

Eigen::MatrixXd correlations(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& lengths, double noise) {
  const Eigen::MatrixXd scaled = inputs * lengths.cwiseInverse().asDiagonal();
  Eigen::MatrixXd matrix(inputs.rows(), inputs.rows());
  for (Eigen::Index a = 0; a < inputs.rows(); ++a)
    for (Eigen::Index b = 0; b <= a; ++b)
      matrix(a, b) = matrix(b, a) = correlation((scaled.row(a) - scaled.row(b)).norm());
  matrix.diagonal().array() += noise;
  return matrix;
}

/// Rows with equal inputs, place by place.
std::vector<std::vector<Eigen::Index>> runs_by_place(const Eigen::MatrixXd& inputs) {
  std::vector<std::vector<Eigen::Index>> places;
  for (Eigen::Index run = 0; run < inputs.rows(); ++run) {
    const auto known = std::find_if(places.begin(), places.end(), [&](const auto& runs) {
      return inputs.row(runs.front()) == inputs.row(run);
    });
    if (known == places.end())
      places.push_back({run});
    else
      known->push_back(run);
  }
  return places;
}

/// Limits of the logarithms of lengths and noise.
struct Limits {
  Eigen::VectorXd lower, upper;

  explicit Limits(Eigen::Index dimensions)
      : lower(Eigen::VectorXd::Constant(dimensions + 1, std::log(kShortest))),
        upper(Eigen::VectorXd::Constant(dimensions + 1, std::log(kLongest))) {
    lower[dimensions] = std::log(kMinNoise);
    upper[dimensions] = std::log(kMaxNoise);
  }
  Eigen::VectorXd at(const Eigen::VectorXd& place) const { return lower + place.cwiseProduct(upper - lower); }
  Eigen::VectorXd place(const Eigen::VectorXd& at) const { return (at - lower).cwiseQuotient(upper - lower); }
};

}  // namespace

double student_variance(double freedom) {
  constexpr double kFewest = 3;
  const double counted = std::max(freedom, kFewest);
  return counted / (counted - 2);
}

Emulator::Emulator(Eigen::MatrixXd inputs, Eigen::MatrixXd outputs)
    : inputs_(std::move(inputs)), outputs_(std::move(outputs)) {
  const Eigen::Index runs = inputs_.rows();
  if (runs < 3 || outputs_.rows() != runs || outputs_.cols() == 0)
    throw std::invalid_argument("an emulator needs three runs or more");
  if (!inputs_.allFinite() || !outputs_.allFinite())
    throw std::invalid_argument("an emulator needs finite values");
  places_ = runs_by_place(inputs_);
  // A slope for every parameter needs places to spare: repeats say nothing about slopes.
  const Eigen::Index slopes = inputs_.cols() + 1;
  trend_ = trend_at(inputs_, static_cast<Eigen::Index>(places_.size()) >= 2 * slopes ? slopes : 1);
  middle_ = outputs_.colwise().mean();
  spread_ =
      (outputs_.rowwise() - middle_.transpose()).colwise().norm() / std::sqrt(static_cast<double>(runs - 1));
  for (double& spread : spread_)
    if (!(spread > 0)) spread = 1;
  outputs_ = (outputs_.rowwise() - middle_.transpose()) * spread_.cwiseInverse().asDiagonal();
  choose_processes();
  check_by_leaving_out();
}

Emulator::Process Emulator::process_with(const Eigen::VectorXd& log_parameters, bool for_predictions) const {
  const Eigen::Index runs = inputs_.rows(), terms = trend_.cols(), dimensions = inputs_.cols();
  Process process;
  process.lengths = log_parameters.head(dimensions).array().exp();
  process.noise = std::exp(log_parameters[dimensions]);
  const Eigen::LLT<Eigen::MatrixXd> factor(correlations(inputs_, process.lengths, process.noise));
  process.trend_weight = factor.solve(trend_);
  const Eigen::LLT<Eigen::MatrixXd> of_trend(trend_.transpose() * process.trend_weight);
  process.coefficients = of_trend.solve(process.trend_weight.transpose() * outputs_);
  const Eigen::MatrixXd rest = outputs_ - trend_ * process.coefficients;
  process.weights = factor.solve(rest);
  const double freedom = static_cast<double>(runs - terms);
  process.variances = rest.cwiseProduct(process.weights).colwise().sum().transpose() / freedom;
  const double log_determinant = 2 * factor.matrixLLT().diagonal().array().log().sum() +
                                 2 * of_trend.matrixLLT().diagonal().array().log().sum();
  const double variances = (process.variances.array() + kConstant).log().mean();
  const double preference =
      ((log_parameters.head(dimensions).array() - std::log(kUsualLength)) / kSpreadOfLengths).square().sum();
  process.log_likelihood = -0.5 * (freedom * variances + log_determinant + preference);
  if (!for_predictions) return process;
  process.inverse = factor.solve(Eigen::MatrixXd::Identity(runs, runs));
  process.trend_normal = of_trend.solve(Eigen::MatrixXd::Identity(terms, terms));
  return process;
}

void Emulator::choose_processes() {
  constexpr std::uint64_t kSeed = 5;
  const Limits limits(inputs_.cols());
  const auto log_likelihood = [&](const Eigen::VectorXd& at) {
    const double value = process_with(at, false).log_likelihood;
    return std::isfinite(value) ? value : -1e100;
  };
  const int evaluations = 100 + 60 * static_cast<int>(inputs_.cols());
  const Minimum best = minimum_in_box([&](const Eigen::VectorXd& at) { return -log_likelihood(at); },
                                      limits.lower, limits.upper, evaluations);
  most_probable_ = process_with(best.at, true);
  scatter_ = (most_probable_.noise * most_probable_.variances).cwiseMax(0).cwiseSqrt();
  scatter_ = scatter_.cwiseProduct(spread_);
  EnsembleSize size;
  size.walkers = std::max<Eigen::Index>(kProcesses, 4 * (inputs_.cols() + 1));
  size.burn_in = 40;
  size.samples = size.walkers;
  const auto sampled =
      sample_ensemble([&](const Eigen::VectorXd& place) { return log_likelihood(limits.at(place)); },
                      limits.place(best.at).cwiseMax(0).cwiseMin(1), kSeed, size);
  for (Eigen::Index k = 0; k < kProcesses; ++k)
    probable_.push_back(process_with(limits.at(sampled.place.row(k).transpose()), true));
}

/// Dubrule, Mathematical Geology 15 (1983): predictions from the other places without refitting. With the
/// projected inverse covariance P, leaving the runs B out gives the errors P_BB^-1 (P y)_B of covariance
/// variance * P_BB^-1.
void Emulator::check_by_leaving_out() {
  const Process& process = most_probable_;
  const Eigen::MatrixXd projected =
      process.inverse - process.trend_weight * process.trend_normal * process.trend_weight.transpose();
  const Eigen::MatrixXd weighted = projected * outputs_;
  double squares = 0, count = 0;
  for (const std::vector<Eigen::Index>& runs : places_) {
    const Eigen::LDLT<Eigen::MatrixXd> block(projected(runs, runs));
    const double share = 1 / static_cast<double>(runs.size());
    const Eigen::VectorXd of_mean =
        block.solve(Eigen::VectorXd::Constant(static_cast<Eigen::Index>(runs.size()), share));
    const double variance = share * of_mean.sum();  // of the error of the mean, over that of the quantity
    for (Eigen::Index q = 0; q < outputs_.cols(); ++q) {
      // What does not vary says nothing, nor does a place without which the trend is not determined.
      if (!(process.variances[q] / variance > kConstant)) continue;
      const double error = of_mean.dot(weighted(runs, q));
      squares += error * error / (process.variances[q] * variance);
      count += 1;
    }
  }
  left_out_error_ = count > 0 ? std::sqrt(squares / count) : 0;
  const double widened = std::max(1.0, left_out_error_ * left_out_error_);
  const double freedom = static_cast<double>(outputs_.rows() - trend_.cols());
  const Eigen::MatrixXd of_outputs =
      (outputs_ - trend_ * process.coefficients).transpose() * process.weights / freedom;
  covariance_ = widened * (spread_.asDiagonal() * of_outputs * spread_.asDiagonal());
  scatter_ratio_ = process.noise / widened;
}

Emulator::Prediction Emulator::at(const Eigen::VectorXd& place) const {
  const Eigen::Index quantities = outputs_.cols();
  const double count = static_cast<double>(probable_.size());
  const Eigen::VectorXd trend = trend_at(place.transpose(), trend_.cols()).transpose();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(quantities), squares = sum, variance = sum;
  Eigen::VectorXd near(inputs_.rows());
  for (const Process& process : probable_) {
    for (Eigen::Index k = 0; k < inputs_.rows(); ++k)
      near[k] = correlation((inputs_.row(k).transpose() - place).cwiseQuotient(process.lengths).norm());
    const Eigen::VectorXd missing = trend - process.trend_weight.transpose() * near;
    const Eigen::VectorXd mean =
        process.coefficients.transpose() * trend + process.weights.transpose() * near;
    const double factor =
        std::max(0.0, 1 - near.dot(process.inverse * near) + missing.dot(process.trend_normal * missing));
    sum += mean / count;
    squares += mean.cwiseAbs2() / count;
    variance += factor / count * process.variances;
  }
  variance += (squares - sum.cwiseAbs2()).cwiseMax(0);
  // The variation itself is known from as many places only: Student's t is wider than a normal distribution.
  variance *= student_variance(freedom());
  double factor = 0, vary = 0;
  for (Eigen::Index q = 0; q < quantities; ++q) {
    if (!(most_probable_.variances[q] > kConstant)) continue;
    factor += variance[q] / most_probable_.variances[q];
    vary += 1;
  }
  return {middle_ + spread_.cwiseProduct(sum), vary > 0 ? factor / vary : 0};
}

}  // namespace diefill::process::calibration
