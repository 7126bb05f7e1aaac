// When powder is at rest (Bierwisch 2009 gives no criterion; OP-27 recommends this one).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "process/machine/condition.h"

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process {

/// Watches a simulation for rest: kinetic energy per grain below 1e-4 m g d for 10 ms, or a centre of mass
/// that stays within 1e-3 d for 0.1 s. A plain value, so that a checkpoint can keep it.
struct RestWatch {
  double quiet_since = -1;  ///< s, when the kinetic energy fell below the limit; negative: it has not
  double still_since =
      -1;  ///< s, when the centre of mass was last where `place` says; negative: not yet checked
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< m

  /// Checks at the simulation's present time; true once the powder is at rest. `grain_diameter` d in m. With
  /// `limits` of one's own the kinetic energy alone decides.
  bool at_rest(const engine::Simulation& simulation, double grain_diameter,
               const std::optional<RestLimits>& limits = std::nullopt);
};

}  // namespace diefill::process
