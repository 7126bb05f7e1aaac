#include "process/calibration/methods/ensemble.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

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
Ensemble start(const LogDensity& log_density, Eigen::Index dimensions, Eigen::Index walkers,
               const Eigen::VectorXd& best, std::uint64_t seed) {
  const Eigen::MatrixXd even =
      space_filling(static_cast<std::size_t>(64 * walkers), static_cast<std::size_t>(dimensions), seed);
  std::vector<std::pair<double, Eigen::Index>> ranked;
  for (Eigen::Index k = 0; k < even.rows(); ++k)
    ranked.emplace_back(-log_density(even.row(k).transpose()), k);
  std::sort(ranked.begin(), ranked.end());
  Ensemble ensemble{Eigen::MatrixXd(walkers, dimensions), Eigen::VectorXd(walkers)};
  for (Eigen::Index w = 0; w < walkers; ++w) {
    ensemble.place.row(w) = even.row(ranked[static_cast<std::size_t>(w)].second);
    if (w == 0) ensemble.place.row(w) = best.transpose();
    ensemble.log[w] = log_density(ensemble.place.row(w).transpose());
  }
  return ensemble;
}

/// One stretch move of every walker towards or away from another (Goodman and Weare 2010, Eq. 7, a = 2).
void move(Ensemble& ensemble, const LogDensity& log_density, Uniform& uniform) {
  const Eigen::Index walkers = ensemble.place.rows(), dimensions = ensemble.place.cols();
  for (Eigen::Index w = 0; w < walkers; ++w) {
    const Eigen::Index other = (w + 1 + uniform.below(walkers - 1)) % walkers;
    const double stretch = 0.5 * std::pow(1 + uniform(), 2), chance = uniform();
    const Eigen::VectorXd from = ensemble.place.row(other).transpose(),
                          to = from + stretch * (ensemble.place.row(w).transpose() - from);
    if (!in_cube(to)) continue;
    const double log = log_density(to);
    const double gain = static_cast<double>(dimensions - 1) * std::log(stretch) + log - ensemble.log[w];
    if (!(std::log(chance) < gain)) continue;
    ensemble.place.row(w) = to.transpose();
    ensemble.log[w] = log;
  }
}

}  // namespace

EnsembleSamples sample_ensemble(const LogDensity& log_density, const Eigen::VectorXd& best,
                                std::uint64_t seed, const EnsembleSize& size) {
  Ensemble ensemble = start(log_density, best.size(), size.walkers, best, seed);
  Uniform uniform(seed);
  for (int k = 0; k < size.burn_in; ++k) move(ensemble, log_density, uniform);
  const Eigen::Index rounds = (size.samples + size.walkers - 1) / size.walkers;
  EnsembleSamples sampled{Eigen::MatrixXd(rounds * size.walkers, best.size()),
                          Eigen::VectorXd(rounds * size.walkers)};
  for (Eigen::Index round = 0; round < rounds; ++round) {
    for (int k = 0; k < size.thinning; ++k) move(ensemble, log_density, uniform);
    sampled.place.middleRows(round * size.walkers, size.walkers) = ensemble.place;
    sampled.log.segment(round * size.walkers, size.walkers) = ensemble.log;
  }
  return sampled;
}

}  // namespace diefill::process::calibration
