#include "process/calibration/methods/next_points.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "process/calibration/methods/space_filling.h"
#include "process/results/studies/quantiles.h"

namespace diefill::process::calibration {
namespace {

constexpr int kDraws = 64;
constexpr double kTooNear = 0.02;  // in widths of the box, for a wide region
constexpr std::size_t kCandidates = 512;

/// Independent normal numbers, one row for each draw, evenly spread rather than random.
Eigen::MatrixXd normal_draws(Eigen::Index columns) {
  constexpr std::uint64_t kSeed = 7;
  Eigen::MatrixXd draws = space_filling(kDraws, static_cast<std::size_t>(columns), kSeed);
  for (double& draw : draws.reshaped()) draw = results::normal_quantile(std::clamp(draw, 1e-6, 1 - 1e-6));
  return draws;
}

/// Only the few directions that matter: small eigenvalues stand for no uncertainty.
constexpr Eigen::Index kDirections = 8;

double nearest(const Eigen::VectorXd& place, const std::vector<Eigen::VectorXd>& taken) {
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& other : taken) least = std::min(least, (place - other).norm());
  return least;
}

/// Candidates: even places, and samples of the region.
std::vector<Eigen::VectorXd> candidates(const Region& region, std::uint64_t seed) {
  std::vector<Eigen::VectorXd> all = {region.best};
  const auto even = space_filling(kCandidates, static_cast<std::size_t>(region.best.size()), seed);
  for (Eigen::Index k = 0; k < even.rows(); ++k) all.push_back(even.row(k).transpose());
  const Eigen::Index step = std::max<Eigen::Index>(1, region.samples.rows() / 256);
  for (Eigen::Index k = 0; k < region.samples.rows(); k += step)
    all.push_back(region.samples.row(k).transpose());
  return all;
}

/// Distance below which a run says little new, in widths of the box.
double too_near(const Region& region) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(region.covariance);
  return std::min(kTooNear, 0.25 * std::sqrt(std::max(0.0, axes.eigenvalues().minCoeff())));
}

/// The candidate with the largest value that is further than `apart` from all places taken; nothing where
/// none is.
template <class Value>
Eigen::VectorXd best_candidate(const std::vector<Eigen::VectorXd>& all,
                               const std::vector<Eigen::VectorXd>& taken, double apart, const Value& value) {
  Eigen::VectorXd best;
  double most = -std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& place : all) {
    if (nearest(place, taken) < apart) continue;
    const double worth = value(place);
    if (!(worth > most)) continue;
    most = worth;
    best = place;
  }
  return best;
}

/// The least misfit that the emulators' means know of, whether it was simulated or not.
Minimum best_known(const Likelihood& likelihood, const Region& region,
                   const std::vector<Eigen::VectorXd>& taken) {
  const auto misfit = [&](const Eigen::VectorXd& at) { return likelihood.misfit(at); };
  Minimum best{region.best, misfit(region.best)};
  for (const Eigen::VectorXd& place : taken)
    if (const double value = misfit(place); value < best.value) best = {place, value};
  const auto dimensions = region.best.size();
  const Minimum near =
      minimum_near(misfit, best.at, Eigen::VectorXd::Zero(dimensions), Eigen::VectorXd::Ones(dimensions));
  return near.value < best.value ? near : best;
}

/// Evenly spread samples of the region.
std::vector<Eigen::VectorXd> some_of(const Region& region) {
  std::vector<Eigen::VectorXd> places;
  const Eigen::Index step = std::max<Eigen::Index>(1, region.samples.rows() / 400);
  for (Eigen::Index k = 0; k < region.samples.rows(); k += step)
    places.push_back(region.samples.row(k).transpose());
  return places;
}

}  // namespace

double expected_improvement(const Likelihood& likelihood, const Eigen::VectorXd& place, double best) {
  const auto parts = likelihood.differences(place);
  Eigen::VectorXd misfit = Eigen::VectorXd::Zero(kDraws);
  Eigen::Index column = 0;
  static const Eigen::MatrixXd draws = normal_draws(64);
  for (const Differences& part : parts) {
    const Eigen::Index count = part.value.size(), few = std::min(kDirections, count - 1);
    misfit.array() += part.value.head(count - few).squaredNorm();
    for (Eigen::Index k = count - few; k < count; ++k) {
      const double spread = std::sqrt(part.factor * (*part.spread)[k]);
      misfit.array() += (part.value[k] + spread * draws.col(column++ % draws.cols()).array()).square();
    }
  }
  return (best - misfit.array()).max(0).mean();
}

double misfit_scatter(const Likelihood& likelihood, const Eigen::VectorXd& place) {
  const auto parts = likelihood.differences(place);
  double variance = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double ratio = likelihood.measurements()[k].emulator->scatter_ratio();
    const Eigen::ArrayXd of_run = ratio * parts[k].spread->array();
    // Of (x + s e)^2 with e standard normal: 4 x^2 s^2 + 2 s^4.
    variance += (4 * parts[k].value.array().square() * of_run + 2 * of_run.square()).sum();
  }
  return std::sqrt(variance);
}

double mean_emulator_share(const Likelihood& likelihood, const Region& region) {
  const auto inside = some_of(region);
  double sum = 0;
  for (const Eigen::VectorXd& place : inside) sum += likelihood.emulator_share(place);
  return sum / static_cast<double>(inside.size());
}

bool NextPoints::worthwhile() const {
  return !places.empty() && (expected_gain > std::max(scatter, 0.1) || emulator_share > kShareThatMatters);
}

NextPoints next_points(const Likelihood& likelihood, const Region& region,
                       const std::vector<Eigen::VectorXd>& taken, std::size_t count, std::uint64_t seed) {
  NextPoints next;
  const Minimum best = best_known(likelihood, region, taken);
  next.scatter = misfit_scatter(likelihood, best.at);
  const auto all = candidates(region, seed);
  for (const Eigen::VectorXd& place : all)
    next.expected_gain = std::max(next.expected_gain, expected_improvement(likelihood, place, best.value));
  const auto inside = some_of(region);
  next.emulator_share = mean_emulator_share(likelihood, region);
  std::vector<Eigen::VectorXd> occupied = taken;
  const double apart = too_near(region);
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::VectorXd place =
        k % 2 == 0
            ? best_candidate(all, occupied, apart,
                             [&](const auto& at) { return expected_improvement(likelihood, at, best.value); })
            : best_candidate(inside, occupied, apart,
                             [&](const auto& at) { return likelihood.emulator_share(at); });
    if (place.size() == 0) continue;
    next.places.push_back(place);
    occupied.push_back(place);
  }
  return next;
}

}  // namespace diefill::process::calibration
