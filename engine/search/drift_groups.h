// Powder of which a part moves and a part does not: falling onto what has settled, or carried by the shoe
// over a filled cavity. Motion measured against one mean velocity would count all of it as fast; measured
// against the velocity of its own part, next to none is.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace diefill::engine {

/// Two groups of grains, each with its mean velocity.
struct DriftGroups {
  std::array<Eigen::Vector3d, 2> drift;  ///< m/s
  std::vector<std::uint8_t> group;       ///< of each grain, 0 or 1
};

/// The two groups that these `velocities` (m/s) form; none where they form one: where the smaller group has
/// less than a twentieth of the grains, or velocities scatter in a group by more than a fifth of what lies
/// between the groups, as they do in a steady flow.
std::optional<DriftGroups> drift_groups(const std::vector<Eigen::Vector3d>& velocities);

}  // namespace diefill::engine
