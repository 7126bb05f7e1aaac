// The forces of single contacts, for figures that are computed now and then.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>

namespace diefill::engine {

class Simulation;

inline constexpr std::size_t kNoGrain = static_cast<std::size_t>(-1);

/// The force of one contact on a grain, from another or from a wall.
struct ContactForce {
  std::size_t grain;          ///< place in Grains
  std::size_t other;          ///< the same; kNoGrain: a wall
  Eigen::Vector3d force;      ///< N, on grain
  Eigen::Vector3d arm;        ///< m, from the grain's centre to the contact
  Eigen::Vector3d other_arm;  ///< m, the same from the other's
};

/// Visits the forces of all contacts of the last step, in a fixed order, with places and velocities as they
/// are now; none before the first.
void visit_contact_forces(const Simulation& simulation,
                          const std::function<void(const ContactForce&)>& visit);

}  // namespace diefill::engine
