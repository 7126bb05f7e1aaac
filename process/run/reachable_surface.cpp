#include "process/run/reachable_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "process/run/tooling.h"

namespace diefill::process {

namespace {

/// Poses of all tools in turn: at the start, then in even distances through every step.
std::vector<std::vector<ToolPose>> sampled_poses(const Scene& scene, const Tooling& tooling,
                                                 double distance) {
  std::vector<std::vector<ToolPose>> samples(1, std::vector<ToolPose>(tooling.tools.size()));
  for (const auto& step : scene.steps) {
    if (step->tool().empty() || !step->duration()) continue;
    const std::size_t k = tooling.index_of(step->tool());
    const std::vector<ToolPose> before = samples.back();
    // Fine in time, then only those kept that have moved on by `distance`: a passage to and fro is sampled
    // once a way.
    constexpr int kInstants = 2000;
    Eigen::Vector3d last = before[k].translation;
    for (int n = 1; n <= kInstants; ++n) {
      const ToolPose pose = compose(step->motion(*step->duration() * n / kInstants), before[k]);
      if (n < kInstants && (pose.translation - last).norm() < distance) continue;
      last = pose.translation;
      samples.push_back(before);
      samples.back()[k] = pose;
    }
  }
  return samples;
}

}  // namespace

ReachableSurface::ReachableSurface(const Scene& scene, const Tooling& tooling, double grain_diameter) {
  const Eigen::Vector3d extent = tooling.all.size();
  geometry::ReachRequest request;
  // Voxels a quarter of a grain wide: fine enough for walls, coarse enough for a scene of a few hundred
  // millimetres.
  constexpr double kMostVoxels = 2e7;
  request.voxel = std::max(0.25 * grain_diameter, std::cbrt(extent.prod() / kMostVoxels));
  request.voxel = std::clamp(request.voxel, 1e-5, 5e-4);
  request.climb = 2 * grain_diameter;
  request.powder = {scene.pour.lower, scene.pour.upper};
  request.domain.lower = tooling.standing.lower;
  request.domain.upper = tooling.standing.upper;
  request.domain.upper[2] = std::max(tooling.all.upper[2], scene.pour.upper[2]) + request.climb;
  // Flooded voxels are free space up to the walls: only their size makes the answer fuzzy.
  // Wide enough to join the frayed borders of what was flooded: a strip of wall too many costs little, a gap
  // grains.
  margin_ = 2 * request.voxel + 0.5 * grain_diameter;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto& period = scene.numerics.period[axis];
    period_half_[axis] = period ? 0.5 * *period : std::numeric_limits<double>::infinity();
    if (!period) continue;
    const auto a = static_cast<Eigen::Index>(axis);
    request.domain.lower[a] = std::max(request.domain.lower[a], -period_half_[axis]);
    request.domain.upper[a] = std::min(request.domain.upper[a], period_half_[axis]);
  }
  const auto samples = sampled_poses(scene, tooling, 0.25 * extent.head<2>().maxCoeff() / 8);
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) {
    geometry::MovingSolid solid;
    solid.mesh = &tooling.tools[k].mesh;
    for (const auto& sample : samples) {
      solid.rotations.push_back(sample[k].rotation);
      solid.translations.push_back(sample[k].translation);
    }
    request.solids.push_back(solid);
  }
  reach_ = std::make_unique<geometry::Reach>(request);
}

bool ReachableSurface::operator()(std::size_t tool, const Eigen::Vector3d& point,
                                  const Eigen::Vector3d& normal) const {
  // Along a period every place is like every other: ask well inside the flooded box.
  Eigen::Vector3d asked = point;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double inside = 0.9 * period_half_[axis];
    asked[axis] = std::clamp(point[axis], -inside, inside);
  }
  return reach_->reachable(tool, asked, normal, margin_);
}

}  // namespace diefill::process
