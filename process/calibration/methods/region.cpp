#include "process/calibration/methods/region.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "process/calibration/methods/space_filling.h"

namespace diefill::process::calibration {
namespace {

/// Uniform in [0, 1), the same on every machine.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : generator_(seed) {}
  double operator()() { return static_cast<double>(generator_() >> 11U) * 0x1p-53; }
  Eigen::Index below(Eigen::Index count) {
    return static_cast<Eigen::Index>((*this)() * static_cast<double>(count));
  }

 private:
  std::mt19937_64 generator_;
};

/// The places walked from.
struct Ensemble {
  Eigen::MatrixXd place;
  Eigen::VectorXd log;
};

bool in_cube(const Eigen::VectorXd& place) {
  return place.minCoeff() >= 0 && place.maxCoeff() <= 1;
}

/// Starts at the most probable of many even places.
Ensemble start(const LogLikelihood& log_likelihood, Eigen::Index dimensions, Eigen::Index walkers,
               const Eigen::VectorXd& best, std::uint64_t seed) {
  const Eigen::MatrixXd even =
      space_filling(static_cast<std::size_t>(64 * walkers), static_cast<std::size_t>(dimensions), seed);
  std::vector<std::pair<double, Eigen::Index>> ranked;
  for (Eigen::Index k = 0; k < even.rows(); ++k)
    ranked.emplace_back(-log_likelihood(even.row(k).transpose()), k);
  std::sort(ranked.begin(), ranked.end());
  Ensemble ensemble{Eigen::MatrixXd(walkers, dimensions), Eigen::VectorXd(walkers)};
  for (Eigen::Index w = 0; w < walkers; ++w) {
    ensemble.place.row(w) = even.row(ranked[static_cast<std::size_t>(w)].second);
    if (w == 0) ensemble.place.row(w) = best.transpose();
    ensemble.log[w] = log_likelihood(ensemble.place.row(w).transpose());
  }
  return ensemble;
}

/// One stretch move of every walker towards or away from another (Goodman and Weare 2010, Eq. 7, a = 2).
void move(Ensemble& ensemble, const LogLikelihood& log_likelihood, Uniform& uniform) {
  const Eigen::Index walkers = ensemble.place.rows(), dimensions = ensemble.place.cols();
  for (Eigen::Index w = 0; w < walkers; ++w) {
    const Eigen::Index other = (w + 1 + uniform.below(walkers - 1)) % walkers;
    const double stretch = 0.5 * std::pow(1 + uniform(), 2), chance = uniform();
    const Eigen::VectorXd from = ensemble.place.row(other).transpose(),
                          to = from + stretch * (ensemble.place.row(w).transpose() - from);
    if (!in_cube(to)) continue;
    const double log = log_likelihood(to);
    const double gain = static_cast<double>(dimensions - 1) * std::log(stretch) + log - ensemble.log[w];
    if (!(std::log(chance) < gain)) continue;
    ensemble.place.row(w) = to.transpose();
    ensemble.log[w] = log;
  }
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

void summarise(Region& region) {
  const Eigen::Index dimensions = region.samples.cols();
  const double outside = 0.5 * (1 - region.share);
  region.lower.resize(dimensions);
  region.upper.resize(dimensions);
  for (Eigen::Index d = 0; d < dimensions; ++d) {
    const std::vector<double> values(region.samples.col(d).begin(), region.samples.col(d).end());
    region.lower[d] = quantile(values, outside);
    region.upper[d] = quantile(values, 1 - outside);
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
  const Eigen::Index walkers = std::max<Eigen::Index>(20, 6 * dimensions);
  Ensemble ensemble = start(log_likelihood, dimensions, walkers, best.at, seed);
  Uniform uniform(seed);
  constexpr int kBurnIn = 200, kThinning = 5;
  for (int k = 0; k < kBurnIn; ++k) move(ensemble, log_likelihood, uniform);
  Region region;
  region.share = share;
  region.best = best.at;
  region.best_log = -best.value;
  const Eigen::Index rounds = (samples + walkers - 1) / walkers;
  region.samples.resize(rounds * walkers, dimensions);
  region.log.resize(rounds * walkers);
  for (Eigen::Index round = 0; round < rounds; ++round) {
    for (int k = 0; k < kThinning; ++k) move(ensemble, log_likelihood, uniform);
    region.samples.middleRows(round * walkers, walkers) = ensemble.place;
    region.log.segment(round * walkers, walkers) = ensemble.log;
  }
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
