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

constexpr int kEvaluations = 100;       // of a profile's value at a place
constexpr Eigen::Index kFewOthers = 3;  // that a search of their box finds without help

/// An objective with one parameter held; NLopt takes no interval without width: only the others are searched.
struct Held {
  const Objective& objective;
  Eigen::Index parameter;
  double place;

  Eigen::VectorXd whole(const Eigen::VectorXd& others) const {
    Eigen::VectorXd all(others.size() + 1);
    all << others.head(parameter), place, others.tail(others.size() - parameter);
    return all;
  }
  double operator()(const Eigen::VectorXd& others) const { return objective(whole(others)); }
  ProfilePoint at(const Minimum& least) const { return {place, least.value, whole(least.at)}; }
};

ProfilePoint least_in_box(const Held& held, Eigen::Index dimensions) {
  const Eigen::Index others = dimensions - 1;
  if (others == 0) return held.at({Eigen::VectorXd(0), held(Eigen::VectorXd(0))});
  return held.at(
      minimum_in_box(held, Eigen::VectorXd::Zero(others), Eigen::VectorXd::Ones(others), kEvaluations));
}

/// In a narrow valley of many parameters the line through a place's neighbours leads to a lower value: there
/// and back again.
void go_down_from_neighbours(const Objective& objective, Eigen::Index parameter,
                             std::vector<ProfilePoint>& along) {
  const auto others = [&](const ProfilePoint& point) {
    const Eigen::Index count = point.others.size() - 1;
    Eigen::VectorXd place(count);
    place << point.others.head(parameter), point.others.tail(count - parameter);
    return place;
  };
  const auto try_from = [&](const ProfilePoint& further, const ProfilePoint& neighbour, ProfilePoint& point) {
    const Eigen::VectorXd start = 2 * others(neighbour) - others(further);
    const Held held{objective, parameter, point.place};
    const Minimum least = minimum_near(held, start, Eigen::VectorXd::Zero(start.size()),
                                       Eigen::VectorXd::Ones(start.size()), kEvaluations);
    if (least.value < point.value) point = held.at(least);
  };
  for (std::size_t k = 2; k < along.size(); ++k) try_from(along[k - 2], along[k - 1], along[k]);
  for (std::size_t k = along.size(); k-- > 2;) try_from(along[k], along[k - 1], along[k - 2]);
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
  std::vector<std::vector<ProfilePoint>> all;
  for (Eigen::Index d = 0; d < dimensions; ++d) {
    std::vector<ProfilePoint> along;
    for (int k = 0; k < count; ++k)
      along.push_back(least_in_box({objective, d, static_cast<double>(k) / (count - 1)}, dimensions));
    if (dimensions > kFewOthers + 1) go_down_from_neighbours(objective, d, along);
    all.push_back(std::move(along));
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
