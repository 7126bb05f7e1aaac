#include "process/run/powder_domain.h"

namespace diefill::process {

namespace {

constexpr double kFarAway = 1e3;  // m
constexpr double kLongFall =
    0.5;  // m below the tools, where spilled grains are computed no longer in any case

}  // namespace

geometry::Box powder_domain(const Scene& scene, const Tooling& tooling, const Schedule& schedule) {
  geometry::Box domain = schedule.swept();
  const double margin = 2 * largest_grain(scene);
  domain.lower = domain.lower.cwiseMax(tooling.standing.lower - Eigen::Vector3d::Constant(margin));
  domain.upper = domain.upper.cwiseMin(tooling.standing.upper + Eigen::Vector3d::Constant(margin));
  domain.lower[2] = tooling.standing.lower[2] - margin;
  domain.upper[2] = kFarAway;
  if (!scene.economy.drop_spilled) {
    domain.lower.head<2>().setConstant(-kFarAway);
    domain.upper.head<2>().setConstant(kFarAway);
    domain.lower[2] -= kLongFall;
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (scene.numerics.period[static_cast<std::size_t>(axis)]) {
      domain.lower[axis] = -kFarAway;
      domain.upper[axis] = kFarAway;
    }
  return domain;
}

}  // namespace diefill::process
