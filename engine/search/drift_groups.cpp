#include "engine/search/drift_groups.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "engine/search/passing_speed.h"

namespace diefill::engine {

namespace {

using Velocities = std::vector<Eigen::Vector3d>;

constexpr int kRounds = 4;
constexpr double kLeastShare = 0.05, kLargestScatter = 0.2;

Eigen::Vector3d mean_of(const Velocities& velocities) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& velocity : velocities) sum += velocity;
  return sum / static_cast<double>(velocities.size());
}

/// Direction along which velocities differ most.
Eigen::Vector3d main_direction(const Velocities& velocities, const Eigen::Vector3d& mean) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& velocity : velocities) scatter += (velocity - mean) * (velocity - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>().computeDirect(scatter).eigenvectors().col(2);
}

/// Sets the mean velocity of each group; returns the share of the smaller one. Sums are in the order of the
/// grains, whatever the number of threads.
double set_drifts(const Velocities& velocities, DriftGroups& groups) {
  std::array<Eigen::Vector3d, 2> sum = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::array<std::size_t, 2> count = {0, 0};
  for (std::size_t k = 0; k < velocities.size(); ++k) {
    sum[groups.group[k]] += velocities[k];
    ++count[groups.group[k]];
  }
  for (std::size_t g = 0; g < 2; ++g)
    if (count[g] > 0) groups.drift[g] = sum[g] / static_cast<double>(count[g]);
  return static_cast<double>(std::min(count[0], count[1])) / static_cast<double>(velocities.size());
}

/// Each grain to the group whose velocity is nearer to its own.
void regroup(const Velocities& velocities, DriftGroups& groups) {
  for (std::size_t k = 0; k < velocities.size(); ++k) {
    const double first = (velocities[k] - groups.drift[0]).squaredNorm();
    const double second = (velocities[k] - groups.drift[1]).squaredNorm();
    groups.group[k] = second < first ? 1 : 0;
  }
}

/// m/s, mean distance of a velocity from that of its group.
double scatter_of(const Velocities& velocities, const DriftGroups& groups) {
  double sum = 0;
  for (std::size_t k = 0; k < velocities.size(); ++k)
    sum += (velocities[k] - groups.drift[groups.group[k]]).norm();
  return sum / static_cast<double>(velocities.size());
}

}  // namespace

std::optional<DriftGroups> drift_groups(const Velocities& velocities) {
  if (velocities.empty()) return std::nullopt;
  const Eigen::Vector3d mean = mean_of(velocities);
  const Eigen::Vector3d direction = main_direction(velocities, mean);
  DriftGroups groups{{mean, mean}, std::vector<std::uint8_t>(velocities.size())};
  for (std::size_t k = 0; k < velocities.size(); ++k)
    groups.group[k] = direction.dot(velocities[k] - mean) > 0 ? 1 : 0;
  for (int round = 0; round < kRounds; ++round) {
    if (set_drifts(velocities, groups) < kLeastShare) return std::nullopt;
    regroup(velocities, groups);
  }
  if (set_drifts(velocities, groups) < kLeastShare) return std::nullopt;
  if (scatter_of(velocities, groups) > kLargestScatter * passing_speed(groups.drift)) return std::nullopt;
  return groups;
}

}  // namespace diefill::engine
