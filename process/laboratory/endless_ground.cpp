#include "process/laboratory/endless_ground.h"

namespace diefill::process::laboratory {

Tooling endless_ground(const Scene& scene) {
  constexpr double kMargin = 1;  // m, wider than any experiment
  Tooling tooling;
  tooling.standing.include(scene.pour.lower - kMargin * Eigen::Vector3d::Ones());
  tooling.standing.include(scene.pour.upper + kMargin * Eigen::Vector3d::Ones());
  return tooling;
}

}  // namespace diefill::process::laboratory
