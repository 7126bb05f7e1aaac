#include "process/calibration/methods/region.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace diefill::process::calibration {
namespace {

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

/// Random order (Fisher and Yates): samples come walker by walker, so that every k-th of them would be the
/// chain of a single one.
void shuffle_rows(EnsembleSamples& samples, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (Eigen::Index last = samples.place.rows() - 1; last > 0; --last) {
    const double uniform = static_cast<double>(random() >> 11U) * 0x1p-53;
    const auto other = static_cast<Eigen::Index>(uniform * static_cast<double>(last + 1));
    samples.place.row(last).swap(samples.place.row(other));
    std::swap(samples.log[last], samples.log[other]);
  }
}

/// Intervals hold the best place too, which a region that the box cuts off may have at its end.
void summarise(Region& region) {
  const Eigen::Index dimensions = region.samples.cols();
  const double outside = 0.5 * (1 - region.share);
  region.lower.resize(dimensions);
  region.upper.resize(dimensions);
  for (Eigen::Index d = 0; d < dimensions; ++d) {
    const std::vector<double> values(region.samples.col(d).begin(), region.samples.col(d).end());
    region.lower[d] = std::min(quantile(values, outside), region.best[d]);
    region.upper[d] = std::max(quantile(values, 1 - outside), region.best[d]);
  }
  region.threshold = quantile({region.log.begin(), region.log.end()}, 1 - region.share);
  region.mean = region.samples.colwise().mean();
  const Eigen::MatrixXd off = region.samples.rowwise() - region.mean.transpose();
  region.covariance = off.transpose() * off / static_cast<double>(region.samples.rows() - 1);
}

}  // namespace

double Region::correlation(Eigen::Index first, Eigen::Index second) const {
  const double scale = std::sqrt(covariance(first, first) * covariance(second, second));
  return scale > 0 ? covariance(first, second) / scale : 0;
}

Region sample_region(const LogLikelihood& log_likelihood, Eigen::Index dimensions, std::uint64_t seed,
                     double share, int samples) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(dimensions), one = Eigen::VectorXd::Ones(dimensions);
  const Minimum best = minimum_in_box([&](const Eigen::VectorXd& at) { return -log_likelihood(at); }, zero,
                                      one, 400 * static_cast<int>(dimensions));
  EnsembleSize size;
  size.walkers = std::max<Eigen::Index>(20, 6 * dimensions);
  size.samples = samples;
  EnsembleSamples sampled = sample_ensemble(log_likelihood, best.at, seed, size);
  shuffle_rows(sampled, seed);
  Region region;
  region.share = share;
  region.best = best.at;
  region.best_log = -best.value;
  region.samples = std::move(sampled.place);
  region.log = std::move(sampled.log);
  summarise(region);
  return region;
}

std::vector<std::vector<ProfilePoint>> profiles(const Objective& objective, Eigen::Index dimensions,
                                                int count) {
  std::vector<std::vector<ProfilePoint>> all(static_cast<std::size_t>(dimensions));
  for (Eigen::Index d = 0; d < dimensions; ++d)
    for (int k = 0; k < count; ++k) {
      Eigen::VectorXd lower = Eigen::VectorXd::Zero(dimensions), upper = Eigen::VectorXd::Ones(dimensions);
      lower[d] = upper[d] = static_cast<double>(k) / (count - 1);
      Minimum best{lower, objective(lower)};
      if (dimensions > 1) {
        // NLopt takes no interval without width: only the others are searched.
        const auto whole = [&](const Eigen::VectorXd& others) {
          Eigen::VectorXd place(dimensions);
          place << others.head(d), lower[d], others.tail(dimensions - 1 - d);
          return place;
        };
        const Minimum least =
            minimum_in_box([&](const Eigen::VectorXd& at) { return objective(whole(at)); },
                           Eigen::VectorXd::Zero(dimensions - 1), Eigen::VectorXd::Ones(dimensions - 1), 100);
        best = {whole(least.at), least.value};
      }
      all[static_cast<std::size_t>(d)].push_back({lower[d], best.value, best.at});
    }
  return all;
}

std::vector<Eigen::VectorXd> edge_of(const Region& region, std::size_t count) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(region.covariance);
  std::vector<Eigen::VectorXd> edge;
  for (Eigen::Index axis = region.covariance.rows(); axis-- > 0;) {
    const Eigen::VectorXd along =
        (region.samples.rowwise() - region.mean.transpose()) * axes.eigenvectors().col(axis);
    for (const double side : {-1.0, 1.0}) {
      if (edge.size() == count) return edge;
      Eigen::Index furthest = 0;
      double most = -std::numeric_limits<double>::infinity();
      for (Eigen::Index k = 0; k < along.size(); ++k)
        if (region.contains(region.log[k]) && side * along[k] > most) {
          most = side * along[k];
          furthest = k;
        }
      edge.push_back(region.samples.row(furthest).transpose());
    }
  }
  return edge;
}

}  // namespace diefill::process::calibration
